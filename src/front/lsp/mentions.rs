//! Every word of a spec that has a meaning, with its meaning: fields, units, names and what they refer to.

use super::names::{Definition, Names};
use crate::read::vocabulary::words;
use crate::source::{FileId, Span, Spanned};
use crate::syntax::Place;
use crate::syntax::ast::*;
use crate::syntax::visit::Visit;

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
        let mut walk = Walk { names, place: Place::Top, parameter: None, found: Vec::new() };
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
    /// Where the parts being visited are.
    place: Place,
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

    /// Visits parts of another place.
    fn within(&mut self, place: Place, visit: impl FnOnce(&mut Self)) {
        let around = std::mem::replace(&mut self.place, place);
        visit(self);
        self.place = around;
    }

    /// The value of a field, which may take words or names of its own.
    fn value(&mut self, expr: &'a Expr, field: &str) {
        let elements = match &expr.kind {
            ExprKind::List { elements, unit: None } => elements.as_slice(),
            _ => std::slice::from_ref(expr),
        };
        let known = words(self.place, field);
        let of_kind: Option<fn(&Names, &str) -> Option<usize>> = match (self.place, field) {
            (Place::Plan, "against") => Some(Names::mode),
            (Place::Plan, "vehicle") => Some(Names::vehicle),
            (Place::Plan, "mission") => Some(Names::mission),
            (Place::Recovery, "order") | (Place::Mode | Place::Every, "recovery") => Some(Names::landing_site),
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

    fn named(&mut self, name: &str, span: Span) {
        let what = match self.parameter.filter(|parameter| parameter.value == name) {
            Some(parameter) => self.names.declared_at(parameter.span).map(What::Reference),
            None if crate::read::vocabulary::constants().contains(&name) => Some(What::Constant),
            None => self.names.binding(name).map(What::Reference),
        };
        what.into_iter().for_each(|what| self.note(span, what));
    }
}

impl<'a> Visit<'a> for Walk<'a> {
    fn text(&mut self, text: &'a Spanned<String>) {
        self.note(text.span, What::Text);
    }

    fn unit(&mut self, unit: &'a UnitText) {
        self.note(unit.span, What::Unit);
    }

    fn item(&mut self, item: &'a Item) {
        match item {
            Item::Let(field) => {
                self.define(&field.name);
                if let FieldValue::Expr(expr) = &field.value {
                    self.expr(expr);
                }
            }
            _ => self.walk_item(item),
        }
    }

    fn block(&mut self, block: &'a Block) {
        self.note(block.keyword.span, What::Keyword);
        // `require capture_height` defines nothing.
        let defined = block.name.iter().filter(|_| block.keyword.value != "require");
        defined.for_each(|name| self.define(name));
        let place = Place::of_block(&block.keyword.value).unwrap_or(Place::Unknown);
        self.within(place, |walk| walk.walk_block(block));
    }

    fn statement(&mut self, statement: &'a Statement) {
        let place = match statement {
            Statement::Every { prefix, .. } => {
                self.define(prefix);
                Place::Every
            }
            Statement::Curve { parameter, range, options, body, .. } => {
                self.define(parameter);
                self.expr(range);
                return self.within(Place::Curve, |walk| {
                    options.iter().for_each(|option| walk.field(option));
                    walk.parameter = Some(parameter);
                    walk.body(body);
                    walk.parameter = None;
                });
            }
            Statement::Rotor(_) => Place::Rotors,
            Statement::Start(clauses) | Statement::Waypoint(clauses) => {
                clauses.name.iter().for_each(|name| self.define(name));
                Place::Mission
            }
            Statement::Strike(clauses) => {
                clauses.name.iter().for_each(|name| self.mode(&name.value, name.span));
                Place::Simulate
            }
            Statement::Limit { name, .. } => {
                self.note(name.span, What::Field(self.place));
                self.place
            }
            _ => self.place,
        };
        self.within(place, |walk| walk.walk_statement(statement));
    }

    fn clauses(&mut self, clauses: &'a Clauses) {
        for clause in &clauses.clauses {
            self.note(clause.word.span, What::Field(self.place));
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
                self.value(value, &clause.word.value);
            }
        }
        self.within(Place::Limits, |walk| walk.body(&clauses.body));
    }

    fn field(&mut self, field: &'a Field) {
        self.note(field.name.span, What::Field(self.place));
        match &field.value {
            FieldValue::Expr(expr) => self.value(expr, &field.name.value),
            FieldValue::Where { field, value, .. } => {
                self.note(field.span, What::Field(Place::Mode));
                self.expr(value);
            }
        }
    }

    fn expr(&mut self, expr: &'a Expr) {
        match &expr.kind {
            ExprKind::Number { text, unit, .. } => {
                // In a statement read with its fix made, the number in the text may be shorter.
                let most = unit.as_ref().map_or(expr.span.end, |unit| unit.span.start);
                let end = most.min(expr.span.start + text.len() as u32);
                self.note(Span { end, ..expr.span }, What::Number);
            }
            ExprKind::Text(_) => self.note(expr.span, What::Text),
            ExprKind::Unknown => self.note(expr.span, What::Number),
            ExprKind::Name(name) => self.named(name, expr.span),
            ExprKind::Call { function, .. } => self.note(function.span, What::Function),
            _ => {}
        }
        self.walk_expr(expr);
    }
}

/// Where a reference of several modes, such as `M1_2` of `every .. as M`, writes the name that is declared.
pub fn written_name(definition: &Definition, span: Span) -> Span {
    let length = definition.name.len() as u32;
    Span { end: span.end.min(span.start + length), ..span }
}
