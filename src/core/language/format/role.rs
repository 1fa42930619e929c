//! What the tree knows about words and marks of the same form, by their offset.

use crate::source::Span;
use crate::syntax::ast::*;
use std::collections::HashMap;

/// How a word or mark behaves inside its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A unit, one run up to this byte.
    Unit(usize),
    /// A minus that binds to what follows.
    Sign,
    /// `*`, `/` or `^` without blanks around it.
    Tight,
    /// A function's name: its bracket follows at once.
    Function,
    /// The word of a clause that is not the first of its statement.
    Clause,
}

/// Statements that are lined up with neighbours of their kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// At `=`.
    Field,
    /// At `=`.
    Let,
    /// At the relation.
    Limit,
    /// At each of so many coordinates, to the right.
    Rotor(usize),
}

/// All roles of one file; keys are byte offsets.
#[derive(Debug, Default)]
pub struct Roles {
    pub words: HashMap<usize, Role>,
    /// By the first byte of the statement.
    pub kinds: HashMap<usize, Kind>,
    /// First byte and end of each coordinate of a [`Kind::Rotor`].
    pub coordinates: HashMap<usize, usize>,
}

pub fn roles(file: &SpecFile) -> Roles {
    let mut roles = Roles::default();
    for item in &file.items {
        match item {
            Item::Let(field) => roles.field(field, Some(Kind::Let)),
            Item::Field(field) => roles.field(field, Some(Kind::Field)),
            Item::Block(block) => roles.body(&block.body),
            Item::Use(_) | Item::Broken(_) => {}
        }
    }
    roles
}

fn start(span: Span) -> usize {
    span.start as usize
}

impl Roles {
    fn body(&mut self, statements: &[Statement]) {
        statements.iter().for_each(|statement| self.statement(statement));
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Field(field) => self.field(field, Some(Kind::Field)),
            Statement::Block(block) => self.body(&block.body),
            Statement::Every { count, effect, body, .. } => {
                self.expr(count);
                self.effect(effect);
                self.body(body);
            }
            Statement::Fault { rotors, effect, .. } => {
                self.expr(rotors);
                self.effect(effect);
            }
            Statement::Rotor(clauses) => {
                self.clauses(clauses);
                self.coordinates(clauses);
            }
            Statement::Curve { range, options, body, .. } => {
                self.expr(range);
                options.iter().for_each(|option| self.field(option, None));
                self.body(body);
            }
            Statement::Start(clauses) | Statement::Waypoint(clauses) | Statement::Strike(clauses) => {
                self.clauses(clauses);
            }
            Statement::Hold { duration, .. } => self.expr(duration),
            Statement::Require { at_most, .. } => self.expr(at_most),
            Statement::Limit { relation, span, .. } => {
                self.kinds.insert(start(*span), Kind::Limit);
                let (LimitRelation::AtMost(bound) | LimitRelation::AtLeast(bound) | LimitRelation::In(bound)) =
                    relation;
                self.expr(bound);
            }
            Statement::Moving { .. } | Statement::WaypointsFrom { .. } | Statement::Broken(_) => {}
        }
    }

    fn field(&mut self, field: &Field, kind: Option<Kind>) {
        if let Some(kind) = kind {
            self.kinds.insert(start(field.span), kind);
        }
        let (FieldValue::Expr(value) | FieldValue::Where { value, .. }) = &field.value;
        self.expr(value);
    }

    fn effect(&mut self, effect: &Effect) {
        if let Effect::Reduced(share) | Effect::Stuck(share) = effect {
            self.expr(share);
        }
    }

    fn clauses(&mut self, clauses: &Clauses) {
        for (i, clause) in clauses.clauses.iter().enumerate() {
            if i > 0 {
                self.words.insert(start(clause.word.span), Role::Clause);
            }
            clause.value.iter().for_each(|value| self.expr(value));
        }
        self.body(&clauses.body);
    }

    /// Rotors placed one below the other make a table.
    fn coordinates(&mut self, rotor: &Clauses) {
        let Some(Clause { word, value: Some(Expr { kind: ExprKind::List { elements, .. }, .. }), .. }) =
            rotor.clauses.first()
        else {
            return;
        };
        if word.value == "at" && !elements.is_empty() {
            self.kinds.insert(start(rotor.span), Kind::Rotor(elements.len()));
            self.coordinates.extend(elements.iter().map(|e| (start(e.span), e.span.end as usize)));
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number { unit, .. } => self.unit(unit),
            ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Unknown => {}
            ExprKind::Call { function, arguments } => {
                self.words.insert(start(function.span), Role::Function);
                arguments.iter().for_each(|argument| self.expr(argument));
            }
            ExprKind::Negate(operand) => {
                self.words.insert(start(expr.span), Role::Sign);
                self.expr(operand);
            }
            ExprKind::Binary { operator, left, right } => match operator.value {
                Operator::Add | Operator::Subtract => self.both(left, right),
                Operator::Multiply | Operator::Divide => self.product(expr),
                Operator::Power => {
                    if !ends_in_unit(left) {
                        self.words.insert(start(operator.span), Role::Tight);
                    }
                    self.both(left, right);
                }
            },
            ExprKind::Paren { inner, unit } => {
                self.expr(inner);
                self.unit(unit);
            }
            ExprKind::List { elements, unit } => {
                elements.iter().for_each(|element| self.expr(element));
                self.unit(unit);
            }
            ExprKind::Interval { value: left, by: right } | ExprKind::Range { low: left, high: right } => {
                self.both(left, right);
            }
        }
    }

    fn both(&mut self, left: &Expr, right: &Expr) {
        self.expr(left);
        self.expr(right);
    }

    fn unit(&mut self, unit: &Option<UnitText>) {
        if let Some(unit) = unit {
            self.words.insert(start(unit.span), Role::Unit(unit.span.end as usize));
        }
    }

    /// A chain of `*` and `/` is tight, unless one of them follows a unit, which would continue over the operator.
    fn product(&mut self, expr: &Expr) {
        let (mut operators, mut operands, mut first) = (Vec::new(), Vec::new(), expr);
        while let ExprKind::Binary { operator, left, right } = &first.kind
            && matches!(operator.value, Operator::Multiply | Operator::Divide)
        {
            operators.push(operator);
            operands.push(&**right);
            first = left;
        }
        operands.push(first);
        // The last operand as written comes first here.
        let apart = operands[1..].iter().any(|operand| ends_in_unit(operand)) || operands.iter().any(|o| is_apart(o));
        if !apart {
            self.words.extend(operators.iter().map(|operator| (start(operator.span), Role::Tight)));
        }
        operands.iter().for_each(|operand| self.expr(operand));
    }
}

fn ends_in_unit(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number { unit, .. } | ExprKind::Paren { unit, .. } | ExprKind::List { unit, .. } => unit.is_some(),
        ExprKind::Negate(operand) => ends_in_unit(operand),
        ExprKind::Binary { right, .. } => ends_in_unit(right),
        ExprKind::Interval { by: last, .. } | ExprKind::Range { high: last, .. } => ends_in_unit(last),
        ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Unknown | ExprKind::Call { .. } => false,
    }
}

/// A power with blanks around its mark: looser operators then need blanks too.
fn is_apart(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Negate(operand) => is_apart(operand),
        ExprKind::Binary { operator, left, right } if operator.value == Operator::Power => {
            ends_in_unit(left) || is_apart(right)
        }
        _ => false,
    }
}
