//! Families: the modes of `every ... as NAME`, whose names begin with the family's name.

use super::FaultMode;
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned};
use crate::syntax::ast::Name;
use std::collections::BTreeMap;
use std::ops::Range;

/// All modes of the `every` statements that end in the same `as NAME`.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::spec::read) struct Family {
    pub name: String,
    /// The place of the name in the first of the statements.
    pub span: Span,
    /// Indices of the modes, ascending: one run for each statement. There is at least one run, and no run is empty.
    pub runs: Vec<Range<usize>>,
}

impl Family {
    pub fn count(&self) -> usize {
        self.runs.iter().map(ExactSizeIterator::len).sum()
    }

    /// The mode declared first.
    pub fn first(&self) -> usize {
        self.runs[0].start
    }

    /// The mode declared last.
    pub fn last(&self) -> usize {
        self.runs[self.runs.len() - 1].end - 1
    }
}

/// The families of one spec, in the order declared.
#[derive(Debug, Default)]
pub(in crate::spec::read) struct Families {
    all: Vec<Family>,
}

impl Families {
    /// Adds the modes of one `every ... as prefix`.
    pub fn add(&mut self, prefix: &Name, modes: Range<usize>) {
        if modes.is_empty() {
            return;
        }
        match self.all.iter_mut().find(|family| family.name == prefix.value) {
            Some(family) => family.runs.push(modes),
            None => self.all.push(Family { name: prefix.value.clone(), span: prefix.span, runs: vec![modes] }),
        }
    }

    pub fn find(&self, name: &str) -> Option<&Family> {
        self.all.iter().find(|family| family.name == name)
    }

    /// Whether two modes come from the same `every`.
    pub fn have_run(&self, one: usize, other: usize) -> bool {
        self.all.iter().flat_map(|family| &family.runs).any(|run| run.contains(&one) && run.contains(&other))
    }

    /// Short names for the modes at `chosen`: a family that is chosen completely appears by its name.
    pub fn named<'m>(&'m self, chosen: &[usize], modes: &'m [FaultMode]) -> Vec<&'m str> {
        let is_whole = |family: &&Family| family.runs.iter().cloned().flatten().all(|mode| chosen.contains(&mode));
        let whole: Vec<&Family> = self.all.iter().filter(is_whole).collect();
        let mut names: Vec<&str> = Vec::new();
        for &mode in chosen {
            let family = whole.iter().find(|family| family.runs.iter().any(|run| run.contains(&mode)));
            let name = family.map_or(modes[mode].name.as_str(), |family| family.name.as_str());
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    pub fn names(&self) -> Vec<&str> {
        self.all.iter().map(|family| family.name.as_str()).collect()
    }

    /// One error for each family with the name of a mode, because `against` could mean either. `names` maps every
    /// mode's name to its place.
    pub fn clashes<'a>(&'a self, names: &'a BTreeMap<String, Span>) -> impl Iterator<Item = Diagnostic> + 'a {
        self.all.iter().filter_map(|family| {
            let mode = *names.get(&family.name)?;
            let (later, first) = if mode < family.span { (family.span, mode) } else { (mode, family.span) };
            let message = format!("`{}` names both a fault mode and the modes of an `every`", family.name);
            let error = Diagnostic::error("mavc::name::duplicate", later, message).here("declared again");
            Some(error.also(first, "first declared here").help("rename one of them"))
        })
    }
}

/// The error for a family with a reserved name.
pub(super) fn reserved(written: &Name) -> Diagnostic {
    let Spanned { value, span } = written;
    let message = format!("`{value}` is reserved and cannot name fault modes");
    Diagnostic::error("mavc::name::reserved", *span, message).here("reserved name").help("choose another name")
}
