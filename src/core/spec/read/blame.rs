//! Errors that appear where a `let` is used but belong to its declaration: reported once, with both places.

use super::context::{Context, State};
use super::elaborate::expr_of;
use super::expression::trailing_unit;
use super::overrides::OVERRIDE;
use crate::diagnostic::{Diagnostic, Fix, Label};
use crate::syntax::ast::{Expr, ExprKind};
use crate::unit::Quantity;

/// How many further uses of a wrong `let` get a label.
const MOST_USES: usize = 4;

impl<'a> Context<'a> {
    /// The chain of `let`s that `expr` names, and the value of the last.
    fn chain(&self, expr: &Expr) -> (Vec<&'a str>, Option<&'a Expr>) {
        let mut names = Vec::new();
        let mut value: Option<&'a Expr> = None;
        let mut name = sole_name(expr);
        while let Some((&key, entry)) = name.filter(|n| !self.is_parameter(n)).and_then(|n| self.lets.get_key_value(n))
        {
            value = expr_of(entry.field);
            name = value.and_then(sole_name);
            names.push(key);
        }
        (names, value)
    }

    /// The name and value of the `let` that `expr` resolves to.
    pub(super) fn let_behind(&self, expr: &Expr) -> Option<(&'a str, &'a Expr)> {
        let (names, value) = self.chain(expr);
        names.last().copied().zip(value)
    }

    /// Reports `error` at `expr`. Where `expr` names a `let`, the declaration gets a label with the `fact` that differs
    /// from what is `due`, and later uses with the same error become labels of the first.
    pub(super) fn report_of_let(&mut self, expr: &Expr, due: &str, fact: &str, error: Diagnostic) {
        let Some((name, value)) = self.let_behind(expr) else {
            return self.report(error);
        };
        let key = (name, due.to_string());
        if let Some(&index) = self.accused.get(&key) {
            let first = &mut self.diagnostics[index];
            let is_new = first.span != expr.span && first.labels.iter().all(|label| label.span != expr.span);
            // The declaration has a label too.
            if is_new && first.labels.len() <= MOST_USES {
                first.labels.push(Label { span: expr.span, message: "and here".into() });
            }
            return;
        }
        if !self.is_full() {
            self.accused.insert(key, self.diagnostics.len());
        }
        self.report(error.also(value.span, format!("`{name}` is {fact}")));
    }

    /// Reports two values that must have the same dimension and have not: at the `let` behind one of them, if there is
    /// one, once for all its uses.
    pub(super) fn report_of_sides(&mut self, [a, b]: [(&Expr, Quantity); 2], error: Diagnostic) {
        let (side, other) = if self.let_behind(a.0).is_some() { (a, b) } else { (b, a) };
        let (due, fact) = (other.1.dimension.to_string(), side.1.dimension.describe());
        self.report_of_let(side.0, &due, &fact, error);
    }

    /// Where `expr` lacks a unit because a `let` does, reports that at the `let`, once for all its uses. `units` are
    /// the candidates: the help lists all of them, and a single one becomes a fix.
    pub(super) fn blame(&mut self, expr: &Expr, units: &[&str], error: Diagnostic) -> Diagnostic {
        let (chain, found) = self.chain(expr);
        let (Some(value), Some(&last)) = (found.filter(|e| trailing_unit(e).is_none()), chain.last()) else {
            return error;
        };
        let Some(corrected) = units.iter().map(|unit| self.with_unit(value, unit)).collect::<Option<Vec<_>>>() else {
            return error;
        };
        for name in &chain {
            if let Some(entry) = self.lets.get_mut(name) {
                entry.state = State::Done(None);
            }
        }
        let is_set = self.sources.get(value.span.file).name == OVERRIDE;
        let choices: Vec<String> = corrected
            .iter()
            .map(|text| match is_set {
                true => format!("`--set {last}={}`", text.replace(' ', "")),
                false => format!("`let {last} = {text}`"),
            })
            .collect();
        let error = error.also(value.span, format!("`{last}` has no unit here"));
        let mut error = error.help(format!("write {}", choices.join(" or ")));
        error.fix = <[String; 1]>::try_from(corrected).ok().map(|[text]| Fix { span: value.span, text });
        error
    }

    /// Whether the missing unit of the `let` behind `expr` has been reported.
    pub(super) fn is_blamed(&self, expr: &Expr) -> bool {
        let name = sole_name(expr).filter(|name| !self.is_parameter(name));
        name.and_then(|n| self.lets.get(n)).is_some_and(|l| matches!(l.state, State::Done(None)))
    }
}

/// The name that an expression consists of, apart from signs and parentheses.
pub(super) fn sole_name(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Negate(inner) | ExprKind::Paren { inner, unit: None } => sole_name(inner),
        _ => None,
    }
}
