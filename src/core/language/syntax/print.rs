//! Tree to text: one canonical spelling, which parses to the same tree again (places aside).
//!
//! For trees without their text (`mavc emit ast`); a text with its comments and line breaks is laid out by
//! [`mod@crate::format`].
//!
//! Brackets are part of the tree, so none are added. Operators have blanks around them, because a unit continues over
//! `*`, `/` and `^` that follow it directly.

use super::ast::*;
use std::fmt::{self, Display, Formatter};

impl Display for SpecFile {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (i, item) in self.items.iter().enumerate() {
            let apart = matches!(item, Item::Block(_)) || i > 0 && matches!(self.items[i - 1], Item::Block(_));
            if i > 0 && apart {
                writeln!(f)?;
            }
            match item {
                Item::Use(path) => writeln!(f, "use \"{}\"", path.value)?,
                Item::Let(field) => {
                    doc(f, 0, &field.doc)?;
                    writeln!(f, "let {field}")?;
                }
                Item::Field(field) => {
                    doc(f, 0, &field.doc)?;
                    writeln!(f, "{field}")?;
                }
                Item::Block(block) => print_block(f, 0, block)?,
                Item::Broken(_) => writeln!(f, "{UNREADABLE}")?,
            }
        }
        Ok(())
    }
}

const UNREADABLE: &str = "// a statement that could not be read";

fn indent(f: &mut Formatter<'_>, depth: usize) -> fmt::Result {
    write!(f, "{:1$}", "", 4 * depth)
}

fn doc(f: &mut Formatter<'_>, depth: usize, doc: &Option<String>) -> fmt::Result {
    for line in doc.iter().flat_map(|d| d.split('\n')) {
        indent(f, depth)?;
        writeln!(f, "{}", format!("/// {line}").trim_end())?;
    }
    Ok(())
}

fn body(f: &mut Formatter<'_>, depth: usize, statements: &[Statement]) -> fmt::Result {
    writeln!(f, " {{")?;
    for statement in statements {
        print_statement(f, depth + 1, statement)?;
    }
    indent(f, depth)?;
    writeln!(f, "}}")
}

fn print_block(f: &mut Formatter<'_>, depth: usize, block: &Block) -> fmt::Result {
    doc(f, depth, &block.doc)?;
    indent(f, depth)?;
    write!(f, "{}", block.keyword.value)?;
    if let Some(name) = &block.name {
        write!(f, " {}", name.value)?;
    }
    if let Some(title) = &block.title {
        write!(f, " \"{}\"", title.value)?;
    }
    body(f, depth, &block.body)
}

fn print_statement(f: &mut Formatter<'_>, depth: usize, statement: &Statement) -> fmt::Result {
    if let Statement::Block(block) = statement {
        return print_block(f, depth, block);
    }
    match statement {
        Statement::Field(Field { doc: text, .. })
        | Statement::Every { doc: text, .. }
        | Statement::Curve { doc: text, .. }
        | Statement::Rotor(Clauses { doc: text, .. })
        | Statement::Start(Clauses { doc: text, .. })
        | Statement::Waypoint(Clauses { doc: text, .. })
        | Statement::Strike(Clauses { doc: text, .. }) => doc(f, depth, text)?,
        _ => {}
    }
    indent(f, depth)?;
    match statement {
        Statement::Field(field) => writeln!(f, "{field}"),
        Statement::Block(_) => Ok(()),
        Statement::Every { count, effect, prefix, body: statements, .. } => {
            let one = matches!(&count.kind, ExprKind::Number { text, .. } if text == "1");
            let rotors = if one { "rotor" } else { "rotors" };
            write!(f, "every {count} {rotors} {effect} as {}", prefix.value)?;
            if statements.is_empty() { writeln!(f) } else { body(f, depth, statements) }
        }
        Statement::Fault { rotors, effect, .. } => {
            let several = matches!(rotors.kind, ExprKind::List { .. });
            writeln!(f, "{} {rotors} {effect}", if several { "rotors" } else { "rotor" })
        }
        Statement::Rotor(clauses) => writeln!(f, "rotor{clauses}"),
        Statement::Curve { parameter, range, options, body: statements, .. } => {
            write!(f, "curve {} in {range}", parameter.value)?;
            options.iter().try_for_each(|option| write!(f, ", {option}"))?;
            body(f, depth, statements)
        }
        Statement::Start(clauses) | Statement::Waypoint(clauses) => {
            let word = if matches!(statement, Statement::Start(_)) { "start" } else { "waypoint" };
            write!(f, "{word}{clauses}")?;
            if clauses.body.is_empty() { writeln!(f) } else { body(f, depth, &clauses.body) }
        }
        Statement::Strike(clauses) => writeln!(f, "fault{clauses}"),
        Statement::Moving { end, .. } => {
            writeln!(f, "{} moving", if end.value { "end" } else { "start" })
        }
        Statement::Hold { duration, .. } => writeln!(f, "hold {duration}"),
        Statement::WaypointsFrom { path, .. } => writeln!(f, "waypoints from \"{}\"", path.value),
        Statement::Require { name, at_most, .. } => writeln!(f, "require {} <= {at_most}", name.value),
        Statement::Limit { name, relation, .. } => writeln!(f, "{} {relation}", name.value),
        Statement::Broken(_) => writeln!(f, "{UNREADABLE}"),
    }
}

/// `name = value`, on one line.
impl Display for Field {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} = ", self.name.value)?;
        match &self.value {
            FieldValue::Expr(expr) => write!(f, "{expr}"),
            FieldValue::Where { field, relation, value } => {
                write!(f, "where {} {} {value}", field.value, relation.value)
            }
        }
    }
}

impl Display for Relation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterEqual => ">=",
            Relation::Equal => "=",
        })
    }
}

impl Display for LimitRelation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            LimitRelation::AtMost(bound) => write!(f, "<= {bound}"),
            LimitRelation::AtLeast(bound) => write!(f, ">= {bound}"),
            LimitRelation::In(range) => write!(f, "in {range}"),
        }
    }
}

impl Display for Effect {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Effect::Lost(_) => f.write_str("lost"),
            Effect::Reduced(share) => write!(f, "reduced to {share}"),
            Effect::Stuck(share) => write!(f, "stuck at {share}"),
        }
    }
}

/// The name and the clauses, a blank before each.
impl Display for Clauses {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.name.iter().try_for_each(|name| write!(f, " {}", name.value))?;
        self.clauses.iter().try_for_each(|clause| {
            write!(f, " {}", clause.word.value)?;
            clause.how.iter().try_for_each(|how| write!(f, " {}", how.value))?;
            clause.value.iter().try_for_each(|value| write!(f, " {value}"))
        })
    }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.kind {
            ExprKind::Number { text, unit, .. } => {
                f.write_str(text)?;
                print_unit(f, unit)
            }
            ExprKind::Text(text) => write!(f, "\"{text}\""),
            ExprKind::Name(name) => f.write_str(name),
            ExprKind::Unknown => f.write_str("?"),
            ExprKind::Call { function, arguments } => {
                write!(f, "{}(", function.value)?;
                separated(f, arguments)?;
                f.write_str(")")
            }
            ExprKind::Negate(operand) => write!(f, "-{operand}"),
            ExprKind::Binary { operator, left, right } => write!(f, "{left} {} {right}", operator.value.symbol()),
            ExprKind::Paren { inner, unit } => {
                write!(f, "({inner})")?;
                print_unit(f, unit)
            }
            ExprKind::List { elements, unit } => {
                f.write_str("[")?;
                separated(f, elements)?;
                f.write_str("]")?;
                print_unit(f, unit)
            }
            ExprKind::Interval { value, by } => write!(f, "{value} +- {by}"),
            ExprKind::Range { low, high } => write!(f, "{low} .. {high}"),
        }
    }
}

fn separated(f: &mut Formatter<'_>, list: &[Expr]) -> fmt::Result {
    list.iter().enumerate().try_for_each(|(i, expr)| write!(f, "{}{expr}", if i == 0 { "" } else { ", " }))
}

fn print_unit(f: &mut Formatter<'_>, unit: &Option<UnitText>) -> fmt::Result {
    unit.iter().try_for_each(|unit| write!(f, " {}", unit.value))
}

impl Operator {
    /// The sign in a spec.
    pub fn symbol(self) -> char {
        match self {
            Operator::Add => '+',
            Operator::Subtract => '-',
            Operator::Multiply => '*',
            Operator::Divide => '/',
            Operator::Power => '^',
        }
    }
}
