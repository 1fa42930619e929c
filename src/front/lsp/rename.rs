//! Renaming: every place of a name in every spec that knows it, or the reason why not.
//!
//! The specs are compiled again with the new name. Where that makes an error, or the name then means something else
//! somewhere, nothing is renamed.

use super::names::NameKind;
use super::navigation::{Somewhere, declared_in, places, places_in_all};
use super::workspace::{Spec, Workspace};
use crate::language::table::WAYS;
use crate::read::vocabulary::{constants, functions, reserved_modes};
use crate::source::Span;
use crate::syntax::visit::Visit;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

/// The edits that give a definition of `spec` another name, by file name: bytes to replace by `new`.
///
/// # Errors
/// Why it cannot be renamed so, as a sentence.
pub fn rename(
    workspace: &Workspace,
    specs: &[Arc<Spec>],
    spec: &Spec,
    index: usize,
    new: &str,
) -> Result<BTreeSet<Somewhere>, String> {
    let definition = &spec.names().definitions[index];
    let old = definition.name.as_str();
    check_name(definition.kind, new)?;
    if new == old {
        return Ok(BTreeSet::new());
    }
    let span = definition.span;
    let declared = (spec.source(span.file).name.clone(), span.start as usize, span.end as usize);
    let edits = places_in_all(specs, &declared);
    for spec in specs.iter().filter(|spec| declared_in(spec, &declared).is_some()) {
        check_broken(spec, old, definition.kind)?;
        check_meaning(workspace, spec, &edits, &declared, new)?;
    }
    Ok(edits)
}

fn check_name(kind: NameKind, new: &str) -> Result<(), String> {
    let is_word = new.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if new.is_empty() || !is_word || new.starts_with(|c: char| c.is_ascii_digit()) {
        return Err(format!(
            "`{new}` is not a name: a name consists of the letters a to z, digits and `_`, and does not begin with a \
             digit"
        ));
    }
    let reserved = match kind {
        NameKind::Let => functions().contains(&new) || constants().contains(&new),
        NameKind::Mode | NameKind::Modes => reserved_modes().contains(&new),
        NameKind::LandingSite => WAYS.contains(&new),
        _ => false,
    };
    if reserved { Err(format!("`{new}` belongs to the language")) } else { Ok(()) }
}

/// A statement that cannot be read may use the name, and would keep the old one.
fn check_broken(spec: &Spec, old: &str, kind: NameKind) -> Result<(), String> {
    struct Broken(Vec<Span>);
    impl<'t> Visit<'t> for Broken {
        fn broken(&mut self, span: &'t Span) {
            self.0.push(*span);
        }
    }
    let mut broken = Broken(Vec::new());
    spec.files.files.iter().for_each(|tree| broken.file(tree));
    for span in broken.0 {
        let words = spec.snippet(span).split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        let is_meant = |word: &str| word == old || kind == NameKind::Modes && word.starts_with(old);
        if words.into_iter().any(is_meant) {
            let source = spec.source(span.file);
            let line = source.place(span.start as usize).line;
            return Err(format!("line {line} of `{}` cannot be read and may use `{old}`: fix it first", source.name));
        }
    }
    Ok(())
}

/// Compiles the spec with the new name: the same errors as before, and the name in the same places.
fn check_meaning(
    workspace: &Workspace,
    spec: &Spec,
    edits: &BTreeSet<Somewhere>,
    declared: &Somewhere,
    new: &str,
) -> Result<(), String> {
    let mut texts: BTreeMap<&str, String> = BTreeMap::new();
    // From the last place to the first, so that the earlier ones stay where they are.
    for (name, start, end) in edits.iter().rev() {
        if let Some(file) = spec.file(name) {
            let text = texts.entry(name).or_insert_with(|| spec.source(file).text.clone());
            text.replace_range(*start..*end, new);
        }
    }
    let read = |path: &Path| match texts.get(path.display().to_string().as_str()) {
        Some(text) => Ok(text.clone().into_bytes()),
        None => workspace.bytes(path),
    };
    let root = texts.get(spec.root.as_str()).cloned();
    let root = root.or_else(|| spec.file(&spec.root).map(|file| spec.source(file).text.clone())).unwrap_or_default();
    let renamed = Spec::read(&spec.root, &root, &read);
    let codes = |spec: &Spec| {
        let mut codes: Vec<&str> = spec.diagnostics.iter().map(|d| d.code).collect();
        codes.sort_unstable();
        codes
    };
    let before = codes(spec);
    if let Some(error) = renamed.diagnostics.iter().find(|d| count(&codes(&renamed), d.code) > count(&before, d.code)) {
        return Err(format!("with `{new}`, {}", error.message));
    }
    // Edits before the definition in its own file move it.
    let grown = new.len() as i64 - (declared.2 - declared.1) as i64;
    let earlier = edits.iter().filter(|e| e.0 == declared.0 && e.1 < declared.1).count() as i64;
    let start = (declared.1 as i64 + earlier * grown) as usize;
    let moved = (declared.0.clone(), start, start + new.len());
    let found = declared_in(&renamed, &moved).map(|index| places(&renamed, index).len());
    let was = declared_in(spec, declared).map(|index| places(spec, index).len());
    match found == was {
        true => Ok(()),
        false => Err(format!("`{new}` means something else where the name is used")),
    }
}

fn count(codes: &[&str], code: &str) -> usize {
    codes.iter().filter(|c| **c == code).count()
}
