//! Resolves one element of `against`: a fault mode, a family, or a range within a family.

use crate::diagnostic::{Diagnostic, nearest};
use crate::read::context::{Context, without_digits};
use crate::read::fault::Modes;
use crate::read::plan::CHOICE;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind};
use std::collections::BTreeMap;
use std::ops::Range;

/// The most modes that a help lists.
const MOST_LISTED: usize = 12;

/// Indices of the modes that an element stands for, ascending: one run for each `every`.
pub(super) type Runs = Vec<Range<usize>>;

/// Reads the elements of one `against`.
pub(super) struct Choice<'a> {
    modes: &'a Modes,
    by_name: BTreeMap<&'a str, usize>,
    /// In the order declared.
    names: Vec<&'a str>,
    /// The value of the field: the single element, or the list of all.
    whole: &'a Expr,
    elements: &'a [Expr],
}

impl<'a> Choice<'a> {
    pub fn new(modes: &'a Modes, whole: &'a Expr, elements: &'a [Expr]) -> Self {
        let names: Vec<&str> = modes.modes.iter().map(|mode| mode.name.as_str()).collect();
        let by_name = names.iter().enumerate().map(|(k, name)| (*name, k)).collect();
        Choice { modes, by_name, names, whole, elements }
    }

    /// The modes of an element; `None` where it has an error.
    pub fn read(&self, cx: &mut Context, element: &Expr) -> Option<Runs> {
        match &element.kind {
            ExprKind::Name(name) => self.named(cx, name, element.span),
            ExprKind::Range { low, high } => self.range(cx, element, low, high),
            ExprKind::Text(text) if text == "all" || self.find(text).is_some() => {
                let error = not_named(element.span).here("text in quotes").help(format!("write `{text}`"));
                cx.report(error.fix(element.span, text.as_str()));
                None
            }
            _ => {
                let error = not_named(element.span).here("not a name");
                cx.report(error.help("write the names of modes, as in `[M1, M2]`"));
                None
            }
        }
    }

    /// The modes that a name stands for. A name of both a mode and a family, which is reported elsewhere, stands for
    /// both.
    pub fn find(&self, name: &str) -> Option<Runs> {
        let mode = self.mode(name).map(|mode| mode..mode + 1);
        let family = self.modes.families.find(name).into_iter().flat_map(|family| family.runs.iter().cloned());
        let runs: Runs = mode.into_iter().chain(family).collect();
        (!runs.is_empty()).then_some(runs)
    }

    fn mode(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    fn named(&self, cx: &mut Context, name: &str, span: Span) -> Option<Runs> {
        let found = self.find(name);
        if found.is_none() {
            self.unknown(cx, name, span);
        }
        found
    }

    /// Reports a name of neither a mode nor a family.
    fn unknown(&self, cx: &mut Context, name: &str, span: Span) {
        match name {
            "all" => {
                let error = Diagnostic::error(CHOICE, span, "`all` is not a fault mode");
                let error = error.here("not allowed in a list").help("write `all` without `[ ]`");
                cx.report(if self.elements.len() == 1 { error.fix(self.whole.span, "all") } else { error });
            }
            "healthy" | "none" => {
                let message = format!("`{name}` is not a fault mode");
                let error = Diagnostic::error(CHOICE, span, message).here("not a fault");
                cx.report(match span == self.whole.span {
                    true => {
                        let help = "write `[]` to plan for the healthy vehicle alone, which is always included";
                        error.help(help).fix(span, "[]")
                    }
                    false => error.help("remove it: the healthy vehicle is always included"),
                });
            }
            _ if cx.modes_unnamed => {}
            _ => self.misspelt(cx, name, span),
        }
    }

    fn misspelt(&self, cx: &mut Context, name: &str, span: Span) {
        let names = &self.names;
        let is_listed = |mode: &str| self.elements.iter().any(|e| matches!(&e.kind, ExprKind::Name(n) if n == mode));
        // A mode that is already listed is not suggested, nor is one that differs only in its number, which is rarely
        // misspelt.
        let open = |mode: &str| !is_listed(mode) && without_digits(mode) != without_digits(name);
        // The search for similar names takes time, and nobody reads hundreds of errors.
        let families = if cx.is_full() { Vec::new() } else { self.modes.families.names() };
        let near_family = nearest(name, families.into_iter().filter(|family| open(family)));
        let has_mode = || nearest(name, names.iter().copied().filter(|m| open(m))).is_some();
        match near_family {
            Some(family) if !has_mode() => cx.unknown("fault mode", name, span, &[family]),
            _ => cx.unknown_among("fault mode", name, span, names, open),
        }
    }

    /// `W1 .. W4`: the modes of one `every` from the first to the last that is named, in the order declared.
    fn range(&self, cx: &mut Context, element: &Expr, low: &Expr, high: &Expr) -> Option<Runs> {
        let (first, last) = (self.end(cx, low, true), self.end(cx, high, false));
        let (first, last) = (first?, last?);
        let written = |expr: &Expr| cx.sources.snippet(expr.span).to_string();
        let (from, to) = (written(low), written(high));
        if !self.modes.families.have_run(first, last) {
            let message = format!("`{from}` and `{to}` are not modes of the same `every`");
            let error = Diagnostic::error(CHOICE, element.span, message).here("not a range");
            let between = self.names.get(first..=last).filter(|names| names.len() <= MOST_LISTED);
            let list = between.map_or(format!("{from}, ..., {to}"), |names| names.join(", "));
            cx.report(error.help(format!("list the modes, as in `[{list}]`")));
            return None;
        }
        if first > last {
            let error = Diagnostic::error(CHOICE, element.span, format!("`{to}` is declared before `{from}`"));
            let range = format!("{to} .. {from}");
            cx.report(error.here("runs backwards").help(format!("write `{range}`")).fix(element.span, range));
            return None;
        }
        Some(std::iter::once(first..last + 1).collect())
    }

    /// The mode at one end of a range: the start where `first`.
    fn end(&self, cx: &mut Context, expr: &Expr, first: bool) -> Option<usize> {
        let ExprKind::Name(name) = &expr.kind else {
            let message = "a range of fault modes must go from one mode name to another";
            cx.report(Diagnostic::error(CHOICE, expr.span, message).here("not a name").help("write `M1 .. M4`"));
            return None;
        };
        let (mode, family) = (self.mode(name), self.modes.families.find(name));
        if let (None, Some(family)) = (mode, family) {
            let end = if first { family.first() } else { family.last() };
            let message = format!("`{name}` names {} fault modes, but a range ends at a single one", family.count());
            let instead = &self.modes.modes[end].name;
            let error = Diagnostic::error(CHOICE, expr.span, message).here("not a single fault mode");
            cx.report(error.help(format!("write `{instead}`")).fix(expr.span, instead.as_str()));
            return None;
        }
        if mode.is_none() {
            self.unknown(cx, name, expr.span);
        }
        mode
    }
}

fn not_named(span: Span) -> Diagnostic {
    Diagnostic::error(CHOICE, span, "`against` takes fault modes by name")
}
