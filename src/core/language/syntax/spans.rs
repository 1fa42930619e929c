//! Visits every span of a tree.

use super::ast::*;
use crate::source::{Span, Spanned};

/// Replaces every span of a file's tree by `place(span)`.
pub(super) fn each_span(file: &mut SpecFile, place: &dyn Fn(Span) -> Span) {
    let walk = Walk { place };
    for item in &mut file.items {
        match item {
            Item::Use(path) => walk.spanned(path),
            Item::Let(field) | Item::Field(field) => walk.field(field),
            Item::Block(block) => walk.block(block),
            Item::Broken(span) => walk.span(span),
        }
    }
}

struct Walk<'a> {
    place: &'a dyn Fn(Span) -> Span,
}

impl Walk<'_> {
    fn span(&self, span: &mut Span) {
        *span = (self.place)(*span);
    }

    fn spanned<T>(&self, spanned: &mut Spanned<T>) {
        self.span(&mut spanned.span);
    }

    fn field(&self, field: &mut Field) {
        self.span(&mut field.span);
        self.spanned(&mut field.name);
        match &mut field.value {
            FieldValue::Expr(expr) => self.expr(expr),
            FieldValue::Where { field, relation, value } => {
                self.spanned(field);
                self.spanned(relation);
                self.expr(value);
            }
        }
    }

    fn block(&self, block: &mut Block) {
        self.span(&mut block.span);
        self.spanned(&mut block.keyword);
        block.name.iter_mut().for_each(|name| self.spanned(name));
        block.title.iter_mut().for_each(|title| self.spanned(title));
        self.body(&mut block.body);
    }

    fn body(&self, body: &mut [Statement]) {
        body.iter_mut().for_each(|statement| self.statement(statement));
    }

    fn statement(&self, statement: &mut Statement) {
        match statement {
            Statement::Field(field) => self.field(field),
            Statement::Block(block) => self.block(block),
            Statement::Every { count, effect, prefix, body, span, .. } => {
                self.span(span);
                self.expr(count);
                self.effect(effect);
                self.spanned(prefix);
                self.body(body);
            }
            Statement::Fault { rotors, effect, span } => {
                self.span(span);
                self.expr(rotors);
                self.effect(effect);
            }
            Statement::Curve { parameter, range, options, body, span, .. } => {
                self.span(span);
                self.spanned(parameter);
                self.expr(range);
                options.iter_mut().for_each(|option| self.field(option));
                self.body(body);
            }
            Statement::Rotor(clauses)
            | Statement::Start(clauses)
            | Statement::Waypoint(clauses)
            | Statement::Strike(clauses) => {
                self.span(&mut clauses.span);
                clauses.name.iter_mut().for_each(|name| self.spanned(name));
                for clause in &mut clauses.clauses {
                    self.spanned(&mut clause.word);
                    clause.how.iter_mut().for_each(|how| self.spanned(how));
                    clause.value.iter_mut().for_each(|value| self.expr(value));
                }
                self.body(&mut clauses.body);
            }
            Statement::Moving { end, span } => {
                self.span(span);
                self.spanned(end);
            }
            Statement::Hold { duration: expr, span } => {
                self.span(span);
                self.expr(expr);
            }
            Statement::WaypointsFrom { path, span } => {
                self.span(span);
                self.spanned(path);
            }
            Statement::Require { name, at_most, span } => {
                self.span(span);
                self.spanned(name);
                self.expr(at_most);
            }
            Statement::Limit { name, relation, span } => {
                self.span(span);
                self.spanned(name);
                let (LimitRelation::AtMost(bound) | LimitRelation::AtLeast(bound) | LimitRelation::In(bound)) =
                    relation;
                self.expr(bound);
            }
            Statement::Broken(span) => self.span(span),
        }
    }

    fn effect(&self, effect: &mut Effect) {
        match effect {
            Effect::Lost(span) => self.span(span),
            Effect::Reduced(expr) | Effect::Stuck(expr) => self.expr(expr),
        }
    }

    fn unit(&self, unit: &mut Option<UnitText>) {
        unit.iter_mut().for_each(|unit| self.spanned(unit));
    }

    fn expr(&self, expr: &mut Expr) {
        self.span(&mut expr.span);
        match &mut expr.kind {
            ExprKind::Number { unit, .. } => self.unit(unit),
            ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Unknown => {}
            ExprKind::Call { function, arguments } => {
                self.spanned(function);
                arguments.iter_mut().for_each(|argument| self.expr(argument));
            }
            ExprKind::Negate(inner) => self.expr(inner),
            ExprKind::Binary { operator, left, right } => {
                self.spanned(operator);
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Interval { value: left, by: right } | ExprKind::Range { low: left, high: right } => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Paren { inner, unit } => {
                self.expr(inner);
                self.unit(unit);
            }
            ExprKind::List { elements, unit } => {
                elements.iter_mut().for_each(|element| self.expr(element));
                self.unit(unit);
            }
        }
    }
}
