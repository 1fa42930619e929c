//! Recovery: a text with errors is read again with their fixes made.
//!
//! So one run finds the other errors of such a statement too, and does not report errors that only follow from another
//! one. All spans are places in the author's text.

use super::ast::SpecFile;
use super::visit::VisitMut;
use crate::diagnostic::{Diagnostic, Fix, Severity};
use crate::source::Span;
use std::ops::Range;

/// How often one text is read at most. After the last reading another error may remain hidden.
const MAX_READINGS: usize = 6;

/// Longest replacement whose characters are compared with those it replaces.
const LONGEST_COMPARED: usize = 200;

/// The tree of a text, and its errors.
pub(super) type Reading = (Option<SpecFile>, Vec<Diagnostic>);

/// Reads a text, and reads it again with its fixes made until a reading offers no other fix. The tree is that of the
/// last reading. An error with a fix comes from the reading in which its fix was made, any other error from the last
/// reading.
pub(super) fn read(text: &str, most_errors: usize, read_once: impl Fn(&str) -> Reading) -> Reading {
    let mut draft = Draft::new(text);
    let (mut tree, mut found) = read_once(text);
    let mut reported: Vec<Diagnostic> = Vec::new();
    for _ in 1..MAX_READINGS {
        let fixed = apart(&draft.text, &found);
        if tree.is_none() || fixed.is_empty() || found.len() > most_errors {
            break;
        }
        let fixes: Vec<&Fix> = fixed.iter().filter_map(|d| d.fix.as_ref()).collect();
        let next = draft.with(&fixes);
        let (next_tree, next_found) = read_once(&next.text);
        if next_tree.is_none() {
            break;
        }
        reported.extend(fixed.iter().map(|d| draft.diagnostic(d)));
        (draft, tree, found) = (next, next_tree, next_found);
    }
    let rest: Vec<Diagnostic> = found.iter().map(|d| draft.diagnostic(d)).collect();
    // An error may remain after its fix.
    let is_new =
        |d: &Diagnostic| !reported.iter().any(|r| (r.code, r.span, &r.message) == (d.code, d.span, &d.message));
    let rest: Vec<Diagnostic> = rest.into_iter().filter(is_new).collect();
    reported.extend(rest);
    if let Some(tree) = &mut tree {
        draft.file(tree);
    }
    (tree, reported)
}

/// The errors whose fixes can be made together, in the order of the text.
fn apart<'d>(text: &str, found: &'d [Diagnostic]) -> Vec<&'d Diagnostic> {
    let place = |d: &Diagnostic| d.fix.as_ref().map(|fix| (fix.span.start, fix.span.end));
    // A text that ends in an open block may be cut off: what the block is missing is unknown.
    let is_cut_off = |fix: &Fix| text[fix.span.end as usize..].chars().all(|c| c.is_whitespace() || c == '}');
    let is_sure = |d: &Diagnostic, fix: &Fix| d.code != "mavc::syntax::unclosed_block" || !is_cut_off(fix);
    let errors = found.iter().filter(|d| d.severity == Severity::Error);
    let mut fixed: Vec<&Diagnostic> = errors.filter(|d| d.fix.as_ref().is_some_and(|fix| is_sure(d, fix))).collect();
    // A brace that is left over may close the block that another fix opens.
    let is_stray = |d: &Diagnostic| d.code == "mavc::syntax::stray_brace";
    if fixed.iter().any(|d| d.code == "mavc::syntax::missing_brace") {
        fixed.retain(|d| !is_stray(d));
    }
    fixed.sort_by_key(|d| place(d));
    let mut last: Option<(u32, u32)> = None;
    fixed.retain(|d| {
        let fix = place(d);
        let fits = last.zip(fix).is_none_or(|(last, fix)| fix.0 >= last.1 && fix != last);
        last = if fits { fix } else { last };
        fits
    });
    fixed
}

/// A text with some fixes made.
struct Draft {
    text: String,
    /// For each byte, and for the end, its offset in the author's text.
    origin: Vec<u32>,
    /// For each byte, and for the end, whether a fix has inserted it.
    put: Vec<bool>,
}

impl Draft {
    fn new(text: &str) -> Self {
        Draft { text: text.to_string(), origin: (0..=text.len() as u32).collect(), put: vec![false; text.len() + 1] }
    }

    /// With more fixes made, which are in order and apart.
    fn with(&self, fixes: &[&Fix]) -> Self {
        let mut next = Draft { text: String::new(), origin: Vec::new(), put: Vec::new() };
        let mut from = 0;
        for fix in fixes {
            let start = fix.span.start as usize;
            next.keep(self, from..start);
            from = fix.span.end as usize;
            next.replace(self, start..from, &fix.text);
        }
        next.keep(self, from..self.text.len());
        next.origin.extend(self.origin.last());
        next.put.push(false);
        next
    }

    /// Replaces a range by `new`. Characters that both have in common keep their places.
    fn replace(&mut self, before: &Draft, range: Range<usize>, new: &str) {
        self.text.push_str(new);
        let kept = in_common(&before.text[range.clone()], new);
        let mut at = range.start;
        for old in kept {
            match old {
                Some(old) => {
                    at = range.start + old;
                    self.origin.push(before.origin[at]);
                    self.put.push(before.put[at]);
                    at += 1;
                }
                None => {
                    self.origin.push(before.origin[at]);
                    self.put.push(true);
                }
            }
        }
    }

    fn keep(&mut self, before: &Draft, range: Range<usize>) {
        self.text.push_str(&before.text[range.clone()]);
        self.origin.extend_from_slice(&before.origin[range.clone()]);
        self.put.extend_from_slice(&before.put[range]);
    }

    /// The span of the author's text that corresponds to `span` of this one.
    fn place(&self, span: Span) -> Span {
        let at = |offset: usize| self.origin[offset.min(self.text.len())];
        let start = at(span.start as usize);
        // Text after it that a fix has removed is not part of it.
        let end = match (span.end as usize).checked_sub(1).filter(|&last| span.end > span.start && !self.put[last]) {
            Some(last) => at(last) + 1,
            None => at(span.end as usize),
        };
        Span { start, end: end.max(start), ..span }
    }

    fn diagnostic(&self, diagnostic: &Diagnostic) -> Diagnostic {
        let mut placed = diagnostic.clone();
        placed.span = self.place(placed.span);
        placed.labels.iter_mut().for_each(|label| label.span = self.place(label.span));
        placed.fix = placed.fix.filter(|fix| !self.cuts(fix.span.start) && !self.cuts(fix.span.end));
        placed.fix.iter_mut().for_each(|fix| fix.span = self.place(fix.span));
        placed
    }

    /// Whether an offset lies inside text that a fix has inserted: the author's text has no such place.
    fn cuts(&self, offset: u32) -> bool {
        let at = offset as usize;
        at > 0 && self.put[at - 1] && self.put[at]
    }
}

/// Gives every span its place in the author's text.
impl VisitMut<'_> for Draft {
    fn span(&mut self, span: &mut Span) {
        *span = self.place(*span);
    }
}

/// For each byte of `new` the byte of `old` that it repeats, in order: the longest common subsequence of their
/// characters.
fn in_common(old: &str, new: &str) -> Vec<Option<usize>> {
    let characters = |text: &str| text.char_indices().collect::<Vec<_>>();
    let (a, b) = (characters(old), characters(new));
    let mut kept = vec![None; new.len()];
    if a.len() * b.len() > LONGEST_COMPARED * LONGEST_COMPARED {
        return kept;
    }
    // lengths[i][j]: of what a[i..] and b[j..] have in common.
    let mut lengths = vec![vec![0_usize; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            lengths[i][j] = match a[i].1 == b[j].1 {
                true => lengths[i + 1][j + 1] + 1,
                false => lengths[i + 1][j].max(lengths[i][j + 1]),
            };
        }
    }
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        if a[i].1 == b[j].1 {
            (0..a[i].1.len_utf8()).for_each(|k| kept[b[j].0 + k] = Some(a[i].0 + k));
            (i, j) = (i + 1, j + 1);
        } else if lengths[i + 1][j] >= lengths[i][j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    kept
}
