//! Every word of a spec that has a meaning, with its meaning: fields, units, names and what they refer to.

use super::names::{Definition, Names};
use crate::read::vocabulary::words;
use crate::source::{FileId, Span};
use crate::syntax::Place;
use crate::syntax::ast::*;

/// What a word is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// The name of a field, a clause or a limit in a block.
    Field(Place),
    /// The keyword of a block.
    Keyword,
    Number,
    Unit,
    /// A text in quotes.
    Text,
    Function,
    /// `pi` and `g0`.
    Constant,
    /// A word that a field takes, such as `minimum`.
    Word,
    /// Where a name is declared: index into [`Names::definitions`].
    Definition(usize),
    /// Where a name is used.
    Reference(usize),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mention {
    pub span: Span,
    pub what: What,
}

/// The mentions of one file set, by file and place.
#[derive(Debug, Clone, Default)]
pub struct Mentions {
    all: Vec<Mention>,
}

impl Mentions {
    pub fn of(trees: &[SpecFile], names: &Names) -> Self {
        let mut walk = Walk { names, parameter: None, found: Vec::new() };
        trees.iter().for_each(|tree| walk.file(tree));
        let mut all = walk.found;
        all.sort_by_key(|m| m.span);
        Mentions { all }
    }

    pub fn all(&self) -> &[Mention] {
        &self.all
    }

    /// Those of one file, in their order.
    pub fn in_file(&self, file: FileId) -> &[Mention] {
        let start = self.all.partition_point(|m| m.span.file < file);
        let end = self.all.partition_point(|m| m.span.file <= file);
        &self.all[start..end]
    }

    /// Those that begin within a span.
    pub fn within(&self, span: Span) -> &[Mention] {
        let of_file = self.in_file(span.file);
        let start = of_file.partition_point(|m| m.span.start < span.start);
        let end = of_file.partition_point(|m| m.span.start < span.end);
        &of_file[start..end.max(start)]
    }

    /// The one that holds the byte at `offset`, or ends there.
    pub fn at(&self, file: FileId, offset: usize) -> Option<Mention> {
        let of_file = self.in_file(file);
        let until = of_file.partition_point(|m| m.span.start as usize <= offset);
        // A number ends where its unit begins, so the later one takes precedence.
        of_file[..until].iter().rev().take(2).find(|m| offset <= m.span.end as usize).copied()
    }
}

struct Walk<'a> {
    names: &'a Names,
    /// The parameter of the curve around.
    parameter: Option<&'a Name>,
    found: Vec<Mention>,
}

impl<'a> Walk<'a> {
    fn note(&mut self, span: Span, what: What) {
        self.found.push(Mention { span, what });
    }

    fn define(&mut self, name: &Name) {
        if let Some(index) = self.names.declared_at(name.span) {
            self.note(name.span, What::Definition(index));
        }
    }

    fn file(&mut self, tree: &'a SpecFile) {
        for item in &tree.items {
            match item {
                Item::Use(path) => self.note(path.span, What::Text),
                Item::Let(field) => {
                    self.define(&field.name);
                    if let FieldValue::Expr(expr) = &field.value {
                        self.expr(expr);
                    }
                }
                Item::Field(field) => self.field(field, Place::Top),
                Item::Block(block) => self.block(block),
                Item::Broken(_) => {}
            }
        }
    }

    fn block(&mut self, block: &'a Block) {
        self.note(block.keyword.span, What::Keyword);
        // `require capture_height` defines nothing.
        let defined = block.name.iter().filter(|_| block.keyword.value != "require");
        defined.for_each(|name| self.define(name));
        block.title.iter().for_each(|title| self.note(title.span, What::Text));
        let place = Place::of_block(&block.keyword.value).unwrap_or(Place::Unknown);
        self.statements(&block.body, place);
    }

    fn statements(&mut self, body: &'a [Statement], place: Place) {
        body.iter().for_each(|statement| self.statement(statement, place));
    }

    fn statement(&mut self, statement: &'a Statement, place: Place) {
        match statement {
            Statement::Field(field) => self.field(field, place),
            Statement::Block(block) => self.block(block),
            Statement::Every { count, effect, prefix, body, .. } => {
                self.expr(count);
                self.effect(effect);
                self.define(prefix);
                self.statements(body, Place::Every);
            }
            Statement::Fault { rotors, effect, .. } => {
                self.expr(rotors);
                self.effect(effect);
            }
            Statement::Curve { parameter, range, options, body, .. } => {
                self.define(parameter);
                self.expr(range);
                options.iter().for_each(|field| self.field(field, Place::Curve));
                self.parameter = Some(parameter);
                self.statements(body, Place::Curve);
                self.parameter = None;
            }
            Statement::Rotor(clauses) => self.clauses(clauses, Place::Rotors),
            Statement::Start(clauses) => self.clauses(clauses, Place::Mission),
            Statement::Waypoint(clauses) => {
                clauses.name.iter().for_each(|name| self.define(name));
                self.clauses(clauses, Place::Mission);
            }
            Statement::Strike(clauses) => {
                clauses.name.iter().for_each(|name| self.mode(&name.value, name.span));
                self.clauses(clauses, Place::Simulate);
            }
            Statement::Hold { duration, .. } => self.expr(duration),
            Statement::WaypointsFrom { path, .. } => self.note(path.span, What::Text),
            Statement::Require { at_most, .. } => self.expr(at_most),
            Statement::Limit { name, relation, .. } => {
                self.note(name.span, What::Field(place));
                match relation {
                    LimitRelation::AtMost(expr) | LimitRelation::AtLeast(expr) | LimitRelation::In(expr) => {
                        self.expr(expr);
                    }
                }
            }
            Statement::Moving { .. } | Statement::Broken(_) => {}
        }
    }

    fn effect(&mut self, effect: &'a Effect) {
        match effect {
            Effect::Lost(_) => {}
            Effect::Reduced(expr) | Effect::Stuck(expr) => self.expr(expr),
        }
    }

    fn clauses(&mut self, clauses: &'a Clauses, place: Place) {
        for clause in &clauses.clauses {
            self.note(clause.word.span, What::Field(place));
            let is_goal = clause.how.as_ref().is_some_and(|how| how.value == "towards");
            if let Some(value) = &clause.value {
                // `yaw towards tower`: a waypoint, unless a `let` has the name.
                if let ExprKind::Name(name) = &value.kind
                    && is_goal
                    && self.names.binding(name).is_none()
                {
                    let goal = self.names.waypoint(name);
                    goal.into_iter().for_each(|index| self.note(value.span, What::Reference(index)));
                    continue;
                }
                self.value(value, place, &clause.word.value);
            }
        }
        self.statements(&clauses.body, Place::Limits);
    }

    fn field(&mut self, field: &'a Field, place: Place) {
        self.note(field.name.span, What::Field(place));
        match &field.value {
            FieldValue::Expr(expr) => self.value(expr, place, &field.name.value),
            FieldValue::Where { field, value, .. } => {
                self.note(field.span, What::Field(Place::Mode));
                self.expr(value);
            }
        }
    }

    /// The value of a field, which may take words or names of its own.
    fn value(&mut self, expr: &'a Expr, place: Place, field: &str) {
        let elements = match &expr.kind {
            ExprKind::List { elements, unit: None } => elements.as_slice(),
            _ => std::slice::from_ref(expr),
        };
        let known = words(place, field);
        let of_kind: Option<fn(&Names, &str) -> Option<usize>> = match (place, field) {
            (Place::Plan, "against") => Some(Names::mode),
            (Place::Plan, "vehicle") => Some(Names::vehicle),
            (Place::Plan, "mission") => Some(Names::mission),
            _ => None,
        };
        // The ends of a range of modes are names of modes, like the elements of a list.
        let ends = |element: &'a Expr| match &element.kind {
            ExprKind::Range { low, high } if of_kind.is_some() => vec![&**low, &**high],
            _ => vec![element],
        };
        for element in elements.iter().flat_map(ends) {
            match &element.kind {
                ExprKind::Name(name) if known.contains(&name.as_str()) => self.note(element.span, What::Word),
                ExprKind::Name(name) if of_kind.is_some() => {
                    if let Some(index) = of_kind.and_then(|find| find(self.names, name)) {
                        self.note(element.span, What::Reference(index));
                    }
                }
                // Where words are expected, a name is not a `let`, except for times and delays.
                ExprKind::Name(_) if !known.is_empty() && !matches!(field, "time" | "detection") => {}
                _ => self.expr(element),
            }
        }
    }

    fn mode(&mut self, name: &str, span: Span) {
        if let Some(index) = self.names.mode(name) {
            self.note(span, What::Reference(index));
        }
    }

    fn unit(&mut self, unit: &Option<UnitText>) {
        unit.iter().for_each(|unit| self.note(unit.span, What::Unit));
    }

    fn expr(&mut self, expr: &'a Expr) {
        match &expr.kind {
            ExprKind::Number { text, unit, .. } => {
                // In a statement read with its fix made, the number in the text may be shorter.
                let most = unit.as_ref().map_or(expr.span.end, |unit| unit.span.start);
                let end = most.min(expr.span.start + text.len() as u32);
                self.note(Span { end, ..expr.span }, What::Number);
                self.unit(unit);
            }
            ExprKind::Text(_) => self.note(expr.span, What::Text),
            ExprKind::Unknown => self.note(expr.span, What::Number),
            ExprKind::Name(name) => self.named(name, expr.span),
            ExprKind::Call { function, arguments } => {
                self.note(function.span, What::Function);
                arguments.iter().for_each(|argument| self.expr(argument));
            }
            ExprKind::Negate(inner) => self.expr(inner),
            ExprKind::Binary { left, right, .. }
            | ExprKind::Interval { value: left, by: right }
            | ExprKind::Range { low: left, high: right } => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Paren { inner, unit } => {
                self.expr(inner);
                self.unit(unit);
            }
            ExprKind::List { elements, unit } => {
                elements.iter().for_each(|element| self.expr(element));
                self.unit(unit);
            }
        }
    }

    fn named(&mut self, name: &str, span: Span) {
        let what = match self.parameter.filter(|parameter| parameter.value == name) {
            Some(parameter) => self.names.declared_at(parameter.span).map(What::Reference),
            None if crate::read::vocabulary::constants().contains(&name) => Some(What::Constant),
            None => self.names.binding(name).map(What::Reference),
        };
        what.into_iter().for_each(|what| self.note(span, what));
    }
}

/// Where a reference of several modes, such as `M1_2` of `every .. as M`, writes the name that is declared.
pub fn written_name(definition: &Definition, span: Span) -> Span {
    let length = definition.name.len() as u32;
    Span { end: span.end.min(span.start + length), ..span }
}
