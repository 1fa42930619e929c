//! The text of the spec, with every diagnostic below its line.

use super::prose::prose;
use crate::diagnostic::{Diagnostic, Severity};
use crate::read::OVERRIDE;
use crate::source::{FileId, Source, SourceMap, Span};
use maud::{Markup, html};
use std::ops::Range;

/// Most diagnostics that are shown.
const MOST_DIAGNOSTICS: usize = 200;

/// Most characters of a line that are shown.
const LONGEST_LINE: usize = 400;

/// Most bytes of text that are shown, over all files, in lines that are not near a diagnostic.
const MOST_TEXT: usize = 250_000;
/// Most bytes of text that are shown, over all files, in lines near one.
const MOST_NEAR: usize = 400_000;

/// Lines before and after a diagnostic that count as near it.
const NEAR: usize = 3;

/// A message at a place of the spec.
struct Remark<'a> {
    span: Span,
    severity: Severity,
    message: Message<'a>,
}

enum Message<'a> {
    /// The diagnostic as a whole, at its own place.
    Diagnostic(&'a Diagnostic),
    /// One of its further labels.
    Label(&'a str, &'a Diagnostic),
}

/// Every file with its remarks.
pub fn section(sources: &SourceMap, diagnostics: &[Diagnostic]) -> Markup {
    let shown = &diagnostics[..diagnostics.len().min(MOST_DIAGNOSTICS)];
    let remarks: Vec<Remark> = shown.iter().flat_map(remarks).collect();
    let mut left = Budget { any: MOST_TEXT, near: MOST_NEAR };
    let (set, files): (Vec<_>, Vec<_>) = sources.iter().partition(|(_, source)| source.name == OVERRIDE);
    let files: Vec<Markup> = files.into_iter().map(|(id, source)| file(id, source, &remarks, &mut left)).collect();
    html! {
        h2 { (headline(diagnostics)) }
        @for file in files { (file) }
        @if !set.is_empty() { (overrides(&set, &remarks)) }
    }
}

fn remarks(diagnostic: &Diagnostic) -> impl Iterator<Item = Remark<'_>> {
    let severity = diagnostic.severity;
    let own = Remark { span: diagnostic.span, severity, message: Message::Diagnostic(diagnostic) };
    let others = diagnostic.labels.iter();
    std::iter::once(own).chain(others.map(move |l| Remark {
        span: l.span,
        severity,
        message: Message::Label(&l.message, diagnostic),
    }))
}

fn headline(diagnostics: &[Diagnostic]) -> String {
    let count = |severity| diagnostics.iter().filter(|d| d.severity == severity).count();
    let counted = |n: usize, one: &str, more: &str| match n {
        0 => None,
        1 => Some(format!("1 {one}")),
        n => Some(format!("{n} {more}")),
    };
    let parts: Vec<String> = [
        counted(count(Severity::Error), "error", "errors"),
        counted(count(Severity::Warning), "warning", "warnings"),
        counted(count(Severity::Advice), "remark", "remarks"),
    ]
    .into_iter()
    .flatten()
    .collect();
    match parts.is_empty() {
        true => "The spec has no errors, warnings or remarks".into(),
        false => format!("The spec has {}", parts.join(", ")),
    }
}

/// Bytes that may still be shown.
struct Budget {
    any: usize,
    near: usize,
}

impl Budget {
    /// Whether a line of this length is shown.
    fn takes(&mut self, length: usize, is_near: bool) -> bool {
        let purse = if is_near { &mut self.near } else { &mut self.any };
        let fits = *purse >= length;
        *purse = if fits { *purse - length } else { 0 };
        fits
    }
}

fn file(id: FileId, source: &Source, remarks: &[Remark], left: &mut Budget) -> Markup {
    let here: Vec<&Remark> = remarks.iter().filter(|r| r.span.file == id).collect();
    let first = |r: &Remark| source.place(r.span.start as usize).line;
    let near: Vec<Range<usize>> = here.iter().map(|r| first(r)).map(|l| l.saturating_sub(NEAR)..l + NEAR + 1).collect();
    let count = source.place(source.text.len()).line;
    // The last line is often nothing but the end of the one before.
    let count = if source.line(count).is_empty() && count > 1 { count - 1 } else { count };
    let mut rows: Vec<Markup> = Vec::new();
    let mut hidden = 0;
    for line in 1..=count {
        let range = source.line(line);
        let is_near = near.iter().any(|n| n.contains(&line));
        let length = range.len().min(4 * LONGEST_LINE) + 60;
        if !left.takes(length, is_near) {
            hidden += 1;
            continue;
        }
        if hidden > 0 {
            rows.push(gap(hidden));
            hidden = 0;
        }
        rows.push(html! {
            div.line { span.no aria-hidden="true" { (line) } code { (text(source, range, &here)) } }
        });
        rows.extend(here.iter().filter(|r| first(r) == line).map(|r| remark(r, source)));
    }
    if hidden > 0 {
        rows.push(gap(hidden));
    }
    html! {
        h3.file { (source.name) }
        div.source tabindex="0" role="region" aria-label={ "Text of " (source.name) } {
            @for row in rows { (row) }
        }
    }
}

/// Fields set on the command line: these have no file and no line numbers.
fn overrides(set: &[(FileId, &Source)], remarks: &[Remark]) -> Markup {
    html! {
        h3.file { "Set on the command line" }
        div.source tabindex="0" role="region" aria-label="Fields set on the command line" {
            @for (id, source) in set {
                @let here: Vec<&Remark> = remarks.iter().filter(|r| r.span.file == *id).collect();
                div.line {
                    span.no aria-hidden="true" { }
                    code { (OVERRIDE) " " (text(source, source.line(1), &here)) }
                }
                @for r in &here { (remark(r, source)) }
            }
        }
    }
}

fn gap(hidden: usize) -> Markup {
    html! { div.gap { @if hidden == 1 { "1 line omitted" } @else { (hidden) " lines omitted" } } }
}

/// A line's text with the places of remarks highlighted and its comment dimmed.
fn text(source: &Source, line: Range<usize>, here: &[&Remark]) -> Markup {
    let whole = &source.text[line.clone()];
    let kept = whole.char_indices().nth(LONGEST_LINE).map_or(whole.len(), |(i, _)| i);
    let comment = comment(&whole[..kept]);
    let spans = here.iter().map(|r| (first_line_only(r.span, source), r.severity));
    let marks: Vec<(Range<usize>, Severity)> = spans
        .filter(|(s, _)| s.start < line.start + kept && s.end > line.start)
        .map(|(s, severity)| (s.start.saturating_sub(line.start)..(s.end - line.start).min(kept), severity))
        .collect();
    let mut edges: Vec<usize> = marks.iter().flat_map(|(m, _)| [m.start, m.end]).chain([0, comment, kept]).collect();
    edges.retain(|&e| whole.is_char_boundary(e));
    edges.sort_unstable();
    edges.dedup();
    html! {
        @for pair in edges.windows(2) {
            @let piece = &whole[pair[0]..pair[1]];
            @match marks.iter().find(|(m, _)| m.contains(&pair[0])) {
                Some((_, severity)) => mark class=(severity.name()) { (piece) },
                None => @if pair[0] >= comment { span.comment { (piece) } } @else { (piece) },
            }
        }
        @if kept < whole.len() { span.comment { " …" } }
    }
}

/// The first line of a span; only this is highlighted if the span (usually a block) has several lines.
fn first_line_only(span: Span, source: &Source) -> Range<usize> {
    let (start, end) = (span.start as usize, span.end as usize);
    let line = source.line(source.place(start).line);
    start..end.min(line.end).max(start)
}

/// Offset at which a line's comment begins; the line's length if it has none.
fn comment(line: &str) -> usize {
    let mut quoted = false;
    for (i, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '/' if !quoted && line[i..].starts_with("//") => return i,
            _ => {}
        }
    }
    line.len()
}

fn remark(remark: &Remark, source: &Source) -> Markup {
    let place = source.place(remark.span.start as usize);
    let severity = remark.severity.name();
    html! {
        div.remark.(severity) {
            @match &remark.message {
                Message::Diagnostic(d) => {
                    p {
                        strong { span.severity { (severity) } " " (prose(&d.message)) }
                        @if !d.label.is_empty() { ": " (prose(&d.label)) }
                    }
                    @if let Some(help) = &d.help { p.help { "help: " (prose(help)) } }
                    p.code {
                        (d.code)
                        @if source.name != OVERRIDE { ", line " (place.line) ", column " (place.column) }
                    }
                }
                Message::Label(label, d) => p { (prose(label)) " " span.code { "(" (d.code) ")" } },
            }
        }
    }
}
