//! Families: the modes of `every ... as NAME`, which share the name that theirs begin with.

use super::FaultMode;
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned};
use crate::syntax::ast::Name;
use std::collections::BTreeMap;
use std::ops::Range;

/// All modes of the `every` statements that end in one `as NAME`.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::model) struct Family {
    pub name: String,
    /// Of the name in the first of the statements.
    pub span: Span,
    /// Indices of the modes, ascending: one run for each statement. None is empty, and there is at least one.
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
pub(in crate::model) struct Families {
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

    /// Whether two modes come from one `every`.
    pub fn have_run(&self, one: usize, other: usize) -> bool {
        self.all.iter().flat_map(|family| &family.runs).any(|run| run.contains(&one) && run.contains(&other))
    }

    /// What names the modes at `chosen` in few words: families that are chosen whole by their name.
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

    /// One error for each family that has the name of a mode, since `against` could mean either. `names` has the place of
    /// every mode's name.
    pub fn clashes<'a>(&'a self, names: &'a BTreeMap<String, Span>) -> impl Iterator<Item = Diagnostic> + 'a {
        self.all.iter().filter_map(|family| {
            let mode = *names.get(&family.name)?;
            let (later, first) = if mode < family.span { (family.span, mode) } else { (mode, family.span) };
            let message = format!("`{}` names both a fault mode and the modes of an `every`", family.name);
            let error = Diagnostic::error("mavc::name::duplicate", later, message).here("declared again");
            Some(error.also(first, "first declared here").help("give one of them another name"))
        })
    }
}

/// The error of a family whose name belongs to the language.
pub(super) fn reserved(written: &Name) -> Diagnostic {
    let Spanned { value, span } = written;
    let message = format!("`{value}` belongs to the language and cannot name fault modes");
    Diagnostic::error("mavc::name::reserved", *span, message).here("reserved").help("choose another name")
}
