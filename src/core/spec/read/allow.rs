//! `allow = [tip_speed]`: warnings that the author has accepted and that are not shown again.

use std::sync::LazyLock;

use super::context::{Context, no_filter};
use super::edits;
use super::elaborate::expr_of;
use crate::diagnostic::{Diagnostic, Severity, codes, nearest};
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, Field};

const UNKNOWN: &str = "mavc::allow::unknown";
const NOT_A_WARNING: &str = "mavc::allow::not_a_warning";
const IDLE: &str = "mavc::allow::idle";

/// The warnings that `allow` can suppress: those about what is written. The results of an analysis (`mavc::analysis`)
/// and errors cannot be suppressed.
const WARNINGS: [&str; 41] = [
    "mavc::sense::thrust_to_weight",
    "mavc::sense::inertia",
    "mavc::sense::parts",
    "mavc::sense::products",
    "mavc::sense::arm",
    "mavc::sense::propeller",
    "mavc::sense::coincident",
    "mavc::sense::torque_ratio",
    "mavc::sense::tip_speed",
    "mavc::sense::rotor_table",
    "mavc::sense::time_constant",
    "mavc::sense::yaw_drag",
    "mavc::sense::hover_power",
    "mavc::sense::hover_time",
    "mavc::sense::gravity",
    "mavc::sense::gains",
    "mavc::sense::wind",
    "mavc::sense::gusts",
    "mavc::sense::drag",
    "mavc::sense::noise",
    "mavc::sense::loss",
    "mavc::sense::estimator",
    "mavc::sense::effect",
    "mavc::sense::speed",
    "mavc::sense::limit",
    "mavc::sense::tolerance",
    "mavc::sense::distance",
    "mavc::sense::duration",
    "mavc::name::unused",
    "mavc::fault::unused",
    "mavc::plan::none_selected",
    "mavc::plan::coarse_grid",
    "mavc::plan::few_samples",
    "mavc::plan::listed_twice",
    "mavc::mission::close_waypoints",
    "mavc::volume::unknown_size",
    "mavc::air::no_drag",
    "mavc::simulate::no_drag",
    "mavc::simulate::other_air",
    "mavc::campaign::no_modes",
    "mavc::campaign::listed_twice",
];

/// The last parts of the codes, where no other of [`WARNINGS`] ends in the same part: what one writes.
static SHORT: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let words = WARNINGS.map(last_word);
    words.into_iter().filter(|word| words.iter().filter(|other| *other == word).count() == 1).collect()
});

/// The words that `allow` accepts.
pub(super) fn words() -> &'static [&'static str] {
    &SHORT
}

fn last_word(code: &str) -> &str {
    code.rsplit("::").next().unwrap_or(code)
}

/// One element of an `allow`.
struct Entry {
    code: &'static str,
    span: Span,
    in_list: bool,
    is_used: bool,
}

/// The warnings that the spec allows.
#[derive(Default)]
pub(super) struct Allowed(Vec<Entry>);

impl Allowed {
    /// Whether `diagnostic` is suppressed; marks the entry that suppresses it as used.
    pub fn silences(&mut self, diagnostic: &Diagnostic) -> bool {
        let is_meant = |entry: &&mut Entry| entry.code == diagnostic.code;
        match self.0.iter_mut().find(is_meant).filter(|_| diagnostic.severity == Severity::Warning) {
            Some(entry) => {
                entry.is_used = true;
                true
            }
            None => false,
        }
    }
}

impl<'a> Context<'a> {
    /// Reads the `allow` fields of all files; a file may have only one.
    pub fn allow(&mut self, fields: &[&'a Field]) {
        for (k, field) in fields.iter().enumerate() {
            if let Some(first) = fields[..k].iter().find(|first| first.span.file == field.span.file) {
                let message = "a file may have only one `allow`";
                let error = Diagnostic::error("mavc::name::duplicate", field.name.span, message);
                let error = error.here("second `allow`").also(first.name.span, "first `allow`");
                self.report(error.help("merge the two lists"));
            }
            match expr_of(field) {
                Some(Expr { kind: ExprKind::List { elements, unit: None }, .. }) => {
                    elements.iter().for_each(|element| self.allow_one(element, true));
                }
                Some(expr) => self.allow_one(expr, false),
                None => self.report(no_filter(field.span)),
            }
        }
    }

    fn allow_one(&mut self, element: &Expr, in_list: bool) {
        let (ExprKind::Name(written) | ExprKind::Text(written)) = &element.kind else {
            let error = Diagnostic::error(UNKNOWN, element.span, "`allow` takes warning codes");
            let error = error.here("not a warning code");
            return self.report(error.help("write the last part of the code, as in `allow = [tip_speed]`"));
        };
        match meant(written) {
            Some(code) => self.allowed.0.push(Entry { code, span: element.span, in_list, is_used: false }),
            None => self.report(no_warning(written, element.span)),
        }
    }

    /// Warns of every `allow` that suppressed nothing.
    pub fn warn_idle(&mut self) {
        for Entry { code, span, in_list, is_used } in std::mem::take(&mut self.allowed).0 {
            if is_used {
                continue;
            }
            let message = format!("unused `allow`: the spec has no warning `{code}`");
            let warning = Diagnostic::warning(IDLE, span, message).here("suppresses nothing");
            let warning = warning.help("remove it, so that it cannot hide a later mistake");
            self.report(match in_list {
                true => warning.fix(edits::element(self.sources.get(span.file), span), ""),
                false => warning,
            });
        }
    }
}

/// The code that `written` stands for: a full code, or the last part of one.
pub(super) fn meant(written: &str) -> Option<&'static str> {
    let is_meant = |code: &&&str| **code == written || code.strip_prefix("mavc::") == Some(written);
    let is_short = |code: &&&str| SHORT.contains(&written) && last_word(code) == written;
    WARNINGS.iter().find(is_meant).or_else(|| WARNINGS.iter().find(is_short)).copied()
}

/// The error for `written`, which is not a warning that can be allowed.
fn no_warning(written: &str, span: Span) -> Diagnostic {
    let alike = |code: &&&str| last_word(code) == last_word(written);
    if SHORT.iter().all(|word| *word != last_word(written)) {
        if let (Some(one), Some(other)) = (WARNINGS.iter().find(alike), WARNINGS.iter().rfind(alike)) {
            let error = Diagnostic::error(UNKNOWN, span, format!("`{written}` is ambiguous in `allow`"));
            let error = error.here("several warnings end in this");
            return error.help(format!("write the full code: `\"{one}\"` or `\"{other}\"`"));
        }
        let is_code = |page: &&codes::CodePage| page.code == written || page.last_word() == last_word(written);
        if let Some(page) = codes::all().iter().find(is_code) {
            let message = format!("`{}` cannot be allowed", page.code);
            let error = Diagnostic::error(NOT_A_WARNING, span, message).here("an error or the result of an analysis");
            return error.help(format!("remove it; `mavc explain {}` shows how to fix the spec", page.code));
        }
    }
    let error = Diagnostic::error(UNKNOWN, span, format!("unknown warning `{written}`")).here("not a warning code");
    match nearest(last_word(written), SHORT.iter().copied()) {
        Some(near) => error.help(format!("did you mean `{near}`?")).fix(span, near),
        None => error.help("write the last part of the warning's code; `mavc explain sense` lists the sense checks"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_warning_has_a_page_and_a_form_to_write() {
        for code in WARNINGS {
            assert!(codes::lookup(code).is_some(), "{code} has no page");
            assert_eq!(meant(code), Some(code));
        }
        for page in codes::all().iter().filter(|page| page.code.starts_with("mavc::sense::")) {
            assert!(WARNINGS.contains(&page.code), "{} cannot be allowed", page.code);
        }
        for word in words() {
            assert_eq!(meant(word).map(last_word), Some(*word));
        }
        assert_eq!(meant("unused"), None, "two warnings end with it");
        assert_eq!(meant("too_heavy"), None);
    }
}
