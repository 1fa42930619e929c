//! The one walk over the tree: for visitors that read it, and for one that changes it.

use super::ast::*;
use crate::source::{Span, Spanned};

/// Declares a trait with a method for each kind of part, whose argument has the given type of reference. A method
/// visits the parts inside its part, in the order written; one that is overridden calls the `walk_` method to go
/// deeper.
macro_rules! visitor {
    ($(#[$doc:meta])* $visitor:ident by $($reference:tt)+) => {
        $(#[$doc])*
        pub trait $visitor<'t> {
            fn span(&mut self, _: $($reference)+ Span) {}

            fn spanned<T>(&mut self, part: $($reference)+ Spanned<T>) {
                let Spanned { span, .. } = part;
                self.span(span);
            }

            fn name(&mut self, name: $($reference)+ Name) {
                self.spanned(name);
            }

            /// A text in quotes, except as a value.
            fn text(&mut self, text: $($reference)+ Spanned<String>) {
                self.spanned(text);
            }

            fn unit(&mut self, unit: $($reference)+ UnitText) {
                self.spanned(unit);
            }

            /// A statement that could not be parsed.
            fn broken(&mut self, span: $($reference)+ Span) {
                self.span(span);
            }

            fn file(&mut self, file: $($reference)+ SpecFile) {
                let SpecFile { items, .. } = file;
                for item in items {
                    self.item(item);
                }
            }

            fn item(&mut self, item: $($reference)+ Item) {
                self.walk_item(item);
            }

            fn walk_item(&mut self, item: $($reference)+ Item) {
                match item {
                    Item::Use(path) => self.text(path),
                    Item::Let(field) | Item::Field(field) => self.field(field),
                    Item::Block(block) => self.block(block),
                    Item::Broken(span) => self.broken(span),
                }
            }

            fn field(&mut self, field: $($reference)+ Field) {
                self.walk_field(field);
            }

            /// An option in the head of a curve.
            fn option(&mut self, field: $($reference)+ Field) {
                self.walk_field(field);
            }

            fn walk_field(&mut self, field: $($reference)+ Field) {
                let Field { name, value, span, .. } = field;
                self.span(span);
                self.name(name);
                match value {
                    FieldValue::Expr(expr) => self.expr(expr),
                    FieldValue::Where { field, relation, value } => {
                        self.name(field);
                        self.spanned(relation);
                        self.expr(value);
                    }
                }
            }

            fn block(&mut self, block: $($reference)+ Block) {
                self.walk_block(block);
            }

            fn walk_block(&mut self, block: $($reference)+ Block) {
                let Block { keyword, name, title, body, span, .. } = block;
                self.span(span);
                self.name(keyword);
                if let Some(name) = name {
                    self.name(name);
                }
                if let Some(title) = title {
                    self.text(title);
                }
                self.body(body);
            }

            fn body(&mut self, body: $($reference)+ Vec<Statement>) {
                for statement in body {
                    self.statement(statement);
                }
            }

            fn statement(&mut self, statement: $($reference)+ Statement) {
                self.walk_statement(statement);
            }

            fn walk_statement(&mut self, statement: $($reference)+ Statement) {
                match statement {
                    Statement::Field(field) => self.field(field),
                    Statement::Block(block) => self.block(block),
                    Statement::Every { count, effect, prefix, body, span, .. } => {
                        self.span(span);
                        self.expr(count);
                        self.effect(effect);
                        self.name(prefix);
                        self.body(body);
                    }
                    Statement::Fault { rotors, effect, span } => {
                        self.span(span);
                        self.expr(rotors);
                        self.effect(effect);
                    }
                    Statement::Curve { parameter, range, options, body, span, .. } => {
                        self.span(span);
                        self.name(parameter);
                        self.expr(range);
                        for option in options {
                            self.option(option);
                        }
                        self.body(body);
                    }
                    Statement::Rotor(clauses)
                    | Statement::Start(clauses)
                    | Statement::Waypoint(clauses)
                    | Statement::Strike(clauses) => self.clauses(clauses),
                    Statement::Moving { end, span } => {
                        self.span(span);
                        self.spanned(end);
                    }
                    Statement::Hold { duration, span } => {
                        self.span(span);
                        self.expr(duration);
                    }
                    Statement::WaypointsFrom { path, span } => {
                        self.span(span);
                        self.text(path);
                    }
                    Statement::Require { name, at_most, span } => {
                        self.span(span);
                        self.name(name);
                        self.expr(at_most);
                    }
                    Statement::Limit { name, relation, span } => {
                        self.span(span);
                        self.name(name);
                        match relation {
                            LimitRelation::AtMost(bound) | LimitRelation::AtLeast(bound) | LimitRelation::In(bound) => {
                                self.expr(bound);
                            }
                        }
                    }
                    Statement::Broken(span) => self.broken(span),
                }
            }

            fn clauses(&mut self, clauses: $($reference)+ Clauses) {
                self.walk_clauses(clauses);
            }

            fn walk_clauses(&mut self, clauses: $($reference)+ Clauses) {
                let Clauses { name, clauses, body, span, .. } = clauses;
                self.span(span);
                if let Some(name) = name {
                    self.name(name);
                }
                for Clause { word, how, value } in clauses {
                    self.name(word);
                    if let Some(how) = how {
                        self.name(how);
                    }
                    if let Some(value) = value {
                        self.expr(value);
                    }
                }
                self.body(body);
            }

            fn effect(&mut self, effect: $($reference)+ Effect) {
                match effect {
                    Effect::Lost(span) => self.span(span),
                    Effect::Reduced(expr) | Effect::Stuck(expr) => self.expr(expr),
                }
            }

            fn expr(&mut self, expr: $($reference)+ Expr) {
                self.walk_expr(expr);
            }

            fn walk_expr(&mut self, expr: $($reference)+ Expr) {
                let Expr { kind, span } = expr;
                self.span(span);
                match kind {
                    ExprKind::Number { unit, .. } => self.units(unit),
                    ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Unknown => {}
                    ExprKind::Call { function, arguments } => {
                        self.name(function);
                        for argument in arguments {
                            self.expr(argument);
                        }
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
                        self.units(unit);
                    }
                    ExprKind::List { elements, unit } => {
                        for element in elements {
                            self.expr(element);
                        }
                        self.units(unit);
                    }
                }
            }

            fn units(&mut self, unit: $($reference)+ Option<UnitText>) {
                if let Some(unit) = unit {
                    self.unit(unit);
                }
            }
        }
    };
}

visitor! {
    /// Reads a tree.
    Visit by &'t
}

visitor! {
    /// Changes a tree.
    VisitMut by &'t mut
}
