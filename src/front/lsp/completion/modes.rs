//! Fault modes by name: one by one, all of an `every`, and the end of a range of them.

use super::context::Context;
use super::{ItemKind, Offer};
use crate::lsp::names::NameKind;
use crate::lsp::workspace::Spec;
use crate::model::FaultMode;

/// Modes offered by name.
const MOST_MODES: usize = 500;

/// The modes that the list around does not have yet.
pub(super) fn offers(spec: &Spec, context: &Context, list: &mut Vec<Offer>) {
    let modes = spec.understanding.modes.iter().filter(|mode| !context.listed.contains(&mode.name));
    list.extend(modes.take(MOST_MODES).map(offer));
    // Modes that could not be made out, for an error of theirs or of the vehicle, have a name all the same.
    let known = |name: &str| spec.understanding.modes.iter().any(|mode| mode.name == name);
    let rest = spec.names().of_kind(NameKind::Mode).filter(|d| !known(&d.name) && !context.listed.contains(&d.name));
    list.extend(rest.map(|d| Offer::new(&d.name, ItemKind::Event, 1)));
}

/// The names for all modes of an `every`.
pub(super) fn families(spec: &Spec, context: &Context, list: &mut Vec<Offer>) {
    let names = spec.names();
    for (index, definition) in names.definitions.iter().enumerate().filter(|(_, d)| d.kind == NameKind::Modes) {
        let alike = names.alike(index);
        if alike[0] != index || context.listed.contains(&definition.name) {
            continue;
        }
        let is_one = |mode: &&FaultMode| alike.iter().any(|&k| names.definitions[k].statement == mode.span);
        let modes: Vec<&FaultMode> = spec.understanding.modes.iter().filter(is_one).collect();
        let offer = Offer::new(&definition.name, ItemKind::Event, 0).documented(definition.doc.clone());
        list.push(match modes.as_slice() {
            [first, .., last] => offer.detail(format!("{} modes: {} ... {}", modes.len(), first.name, last.name)),
            _ => offer,
        });
    }
}

/// The modes at which a range from `first` may end: those that follow it in its `every`.
pub(super) fn range(spec: &Spec, first: &str, list: &mut Vec<Offer>) {
    let modes = &spec.understanding.modes;
    let Some(start) = modes.iter().position(|mode| mode.name == first) else { return };
    let following = modes[start + 1..].iter().filter(|mode| mode.span == modes[start].span);
    list.extend(following.take(MOST_MODES).map(offer));
}

fn offer(mode: &FaultMode) -> Offer {
    let offer = Offer::new(&mode.name, ItemKind::Event, 1).documented(mode.doc.clone());
    match &mode.title {
        Some(title) => offer.detail(title),
        None => offer,
    }
}
