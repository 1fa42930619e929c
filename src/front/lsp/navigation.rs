//! From a name to where it is declared and to where it is used, in all files of a spec.

use super::mentions::{Mention, What, written_name};
use super::names::NameKind;
use super::workspace::Spec;
use crate::source::{FileId, Span};
use std::collections::BTreeSet;

/// The definition that the name at `offset` is or refers to, and where that name is written: of `M1_6`, declared by
/// `every .. as M`, the `M`.
pub fn target(spec: &Spec, file: FileId, offset: usize) -> Option<(usize, Span)> {
    let mention = spec.mentions().at(file, offset)?;
    match mention.what {
        What::Definition(index) | What::Reference(index) => {
            let definition = &spec.names().definitions[index];
            let written = match definition.kind {
                NameKind::Modes => written_name(definition, mention.span),
                _ => mention.span,
            };
            Some((index, written))
        }
        _ => None,
    }
}

/// The file that a text in quotes after `use` or `waypoints from` names.
pub fn file_named_at(spec: &Spec, file: FileId, offset: usize) -> Option<FileId> {
    let mention = spec.mentions().at(file, offset).filter(|m| m.what == What::Text)?;
    let path = spec.snippet(mention.span).trim_matches('"');
    let target = crate::read::resolve(&spec.source(file).name, path).display().to_string();
    spec.file(&target)
}

/// Every place where the name of a definition is written, its own the first.
pub fn places(spec: &Spec, index: usize) -> Vec<Span> {
    let names = spec.names();
    let definition = &names.definitions[index];
    let alike = names.alike(index);
    let is_use = |m: &&Mention| matches!(m.what, What::Reference(to) if alike.contains(&to));
    let uses = spec.mentions().all().iter().filter(is_use);
    let written = uses.map(|m| match definition.kind {
        NameKind::Modes => written_name(definition, m.span),
        _ => m.span,
    });
    let others = alike.iter().filter(|&&other| other != index).map(|&other| names.definitions[other].span);
    std::iter::once(definition.span).chain(others).chain(written).collect()
}

/// A place in a file, whichever spec it is looked at from: the file's name, start and end in bytes.
pub type Somewhere = (String, usize, usize);

/// The places of a name in several specs that share the file that declares it.
pub fn places_in_all(specs: &[std::sync::Arc<Spec>], declared: &Somewhere) -> BTreeSet<Somewhere> {
    let of_spec = |spec: &std::sync::Arc<Spec>| {
        let index = declared_in(spec, declared)?;
        let name = |span: Span| spec.source(span.file).name.clone();
        let all = places(spec, index);
        Some(all.into_iter().map(|s| (name(s), s.start as usize, s.end as usize)).collect::<Vec<_>>())
    };
    specs.iter().filter_map(of_spec).flatten().collect()
}

/// The definition at a place, as an index of this spec.
pub fn declared_in(spec: &Spec, declared: &Somewhere) -> Option<usize> {
    let file = spec.file(&declared.0)?;
    spec.names().declared_at(Span::new(file, declared.1, declared.2))
}
