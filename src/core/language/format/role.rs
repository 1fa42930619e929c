//! What the tree knows about words and marks of the same form, by their offset.

use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::visit::Visit;
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
pub enum Alignment {
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
    pub kinds: HashMap<usize, Alignment>,
    /// First byte and end of each coordinate of an [`Alignment::Rotor`].
    pub coordinates: HashMap<usize, usize>,
}

pub fn roles(file: &SpecFile) -> Roles {
    let mut roles = Roles::default();
    roles.file(file);
    roles
}

fn start(span: Span) -> usize {
    span.start as usize
}

impl<'t> Visit<'t> for Roles {
    fn item(&mut self, item: &'t Item) {
        self.walk_item(item);
        if let Item::Let(field) = item {
            self.kinds.insert(start(field.span), Alignment::Let);
        }
    }

    fn field(&mut self, field: &'t Field) {
        self.kinds.insert(start(field.span), Alignment::Field);
        self.walk_field(field);
    }

    fn statement(&mut self, statement: &'t Statement) {
        match statement {
            Statement::Rotor(clauses) => self.coordinates(clauses),
            Statement::Limit { span, .. } => drop(self.kinds.insert(start(*span), Alignment::Limit)),
            _ => {}
        }
        self.walk_statement(statement);
    }

    fn clauses(&mut self, clauses: &'t Clauses) {
        let later = clauses.clauses.iter().skip(1);
        self.words.extend(later.map(|clause| (start(clause.word.span), Role::Clause)));
        self.walk_clauses(clauses);
    }

    fn unit(&mut self, unit: &'t UnitText) {
        self.words.insert(start(unit.span), Role::Unit(unit.span.end as usize));
    }

    fn expr(&mut self, expr: &'t Expr) {
        match &expr.kind {
            ExprKind::Call { function, .. } => drop(self.words.insert(start(function.span), Role::Function)),
            ExprKind::Negate(_) => drop(self.words.insert(start(expr.span), Role::Sign)),
            ExprKind::Binary { operator, left, .. } => match operator.value {
                Operator::Add | Operator::Subtract => {}
                Operator::Multiply | Operator::Divide => return self.product(expr),
                Operator::Power if ends_in_unit(left) => {}
                Operator::Power => drop(self.words.insert(start(operator.span), Role::Tight)),
            },
            _ => {}
        }
        self.walk_expr(expr);
    }
}

impl Roles {
    /// Rotors placed one below the other make a table.
    fn coordinates(&mut self, rotor: &Clauses) {
        let Some(Clause { word, value: Some(Expr { kind: ExprKind::List { elements, .. }, .. }), .. }) =
            rotor.clauses.first()
        else {
            return;
        };
        if word.value == "at" && !elements.is_empty() {
            self.kinds.insert(start(rotor.span), Alignment::Rotor(elements.len()));
            self.coordinates.extend(elements.iter().map(|e| (start(e.span), e.span.end as usize)));
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
