//! The names that a spec declares.

use crate::source::Span;
use crate::syntax::ast::*;
use std::collections::HashMap;

/// What a name is the name of. Names of one kind differ; those of different kinds may be alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NameKind {
    Let,
    Vehicle,
    Mission,
    Mode,
    /// The modes of an `every`, by what their names begin with.
    Modes,
    Waypoint,
    LandingSite,
    /// The parameter of a curve.
    Parameter,
}

impl NameKind {
    /// In words.
    pub fn phrase(self) -> &'static str {
        match self {
            NameKind::Let => "let",
            NameKind::Vehicle => "vehicle",
            NameKind::Mission => "mission",
            NameKind::Mode => "fault mode",
            NameKind::Modes => "fault modes",
            NameKind::Waypoint => "waypoint",
            NameKind::LandingSite => "landing site",
            NameKind::Parameter => "curve parameter",
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    pub kind: NameKind,
    pub name: String,
    /// The span of the name.
    pub span: Span,
    /// The span of the whole statement.
    pub statement: Span,
    pub doc: Option<String>,
    pub title: Option<String>,
}

/// Every name that a file set declares.
#[derive(Debug, Clone, Default)]
pub struct Names {
    pub definitions: Vec<Definition>,
    by_span: HashMap<Span, usize>,
    by_name: HashMap<(NameKind, String), usize>,
}

impl Names {
    pub fn of(trees: &[SpecFile]) -> Self {
        let mut names = Names::default();
        for item in trees.iter().flat_map(|tree| &tree.items) {
            match item {
                Item::Let(field) => names.add(NameKind::Let, &field.name, field.span, &field.doc, None),
                Item::Block(block) => names.block(block),
                _ => {}
            }
        }
        names
    }

    fn block(&mut self, block: &Block) {
        let kind = match block.keyword.value.as_str() {
            "vehicle" => Some(NameKind::Vehicle),
            "mission" => Some(NameKind::Mission),
            "mode" => Some(NameKind::Mode),
            "landing_site" => Some(NameKind::LandingSite),
            _ => None,
        };
        if let (Some(kind), Some(name)) = (kind, &block.name) {
            self.add(kind, name, block.span, &block.doc, block.title.as_ref().map(|t| t.value.clone()));
        }
        for statement in &block.body {
            let span = statement.span();
            match statement {
                Statement::Block(inner) => self.block(inner),
                Statement::Every { prefix, doc, .. } => self.add(NameKind::Modes, prefix, span, doc, None),
                Statement::Curve { parameter, doc, .. } => self.add(NameKind::Parameter, parameter, span, doc, None),
                Statement::Waypoint(Clauses { name: Some(name), doc, .. }) => {
                    self.add(NameKind::Waypoint, name, span, doc, None);
                }
                _ => {}
            }
        }
    }

    fn add(&mut self, kind: NameKind, name: &Name, statement: Span, doc: &Option<String>, title: Option<String>) {
        let index = self.definitions.len();
        let (span, doc) = (name.span, doc.clone());
        self.definitions.push(Definition { kind, name: name.value.clone(), span, statement, doc, title });
        self.by_span.insert(span, index);
        // Of several definitions of one name, a reference means the first.
        self.by_name.entry((kind, name.value.clone())).or_insert(index);
    }

    /// The definition whose name is at `span`.
    pub fn declared_at(&self, span: Span) -> Option<usize> {
        self.by_span.get(&span).copied()
    }

    fn named(&self, kind: NameKind, name: &str) -> Option<usize> {
        self.by_name.get(&(kind, name.to_string())).copied()
    }

    pub fn binding(&self, name: &str) -> Option<usize> {
        self.named(NameKind::Let, name)
    }

    pub fn waypoint(&self, name: &str) -> Option<usize> {
        self.named(NameKind::Waypoint, name)
    }

    pub fn landing_site(&self, name: &str) -> Option<usize> {
        self.named(NameKind::LandingSite, name)
    }

    pub fn vehicle(&self, name: &str) -> Option<usize> {
        self.named(NameKind::Vehicle, name)
    }

    pub fn mission(&self, name: &str) -> Option<usize> {
        self.named(NameKind::Mission, name)
    }

    /// A mode by its name: one declared alone, all modes of an `every`, or one of them, `M1_6` of `as M`.
    pub fn mode(&self, name: &str) -> Option<usize> {
        let whole = self.named(NameKind::Mode, name).or_else(|| self.named(NameKind::Modes, name));
        whole.or_else(|| {
            let prefixes = (1..name.len()).rev().filter(|&end| {
                let is_number = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
                name.is_char_boundary(end) && name[end..].split('_').all(is_number)
            });
            prefixes.filter_map(|end| self.named(NameKind::Modes, &name[..end])).next()
        })
    }

    /// The definitions of one name: itself, and for modes every `every` with the same name after `as`.
    pub fn alike(&self, index: usize) -> Vec<usize> {
        let definition = &self.definitions[index];
        if definition.kind != NameKind::Modes {
            return vec![index];
        }
        let is_alike = |d: &Definition| d.kind == NameKind::Modes && d.name == definition.name;
        (0..self.definitions.len()).filter(|&k| is_alike(&self.definitions[k])).collect()
    }

    /// The names of one kind, in the order declared.
    pub fn of_kind(&self, kind: NameKind) -> impl Iterator<Item = &Definition> {
        self.definitions.iter().filter(move |d| d.kind == kind)
    }
}
