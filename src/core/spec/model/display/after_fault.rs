//! What holds after a fault, as text.

use super::{list, place};
use crate::model::{AfterFaultRules, Body, KeepOff, Model, Recoverable, Recovery, RecoverySettings};
use crate::number::number;
use std::fmt;

/// The lines of a mission.
pub(super) fn rules(f: &mut fmt::Formatter<'_>, rules: &AfterFaultRules) -> fmt::Result {
    for site in &rules.sites {
        writeln!(f, "  landing_site {} at {} m, radius {} m", site.name, place(&site.at), number(site.radius))?;
    }
    for KeepOff { name, bodies, clearance, .. } in &rules.keep_off {
        writeln!(f, "  keep_off {name}, clearance {} m", number(*clearance))?;
        bodies.iter().try_for_each(|body| outline(f, body))?;
    }
    if rules.buffer > 0.0 {
        writeln!(f, "  buffer {} m", number(rules.buffer))?;
    }
    rules.limits.iter().try_for_each(|limit| writeln!(f, "  limit after a fault {limit}"))
}

/// A body of an area, seen from above.
fn outline(f: &mut fmt::Formatter<'_>, body: &Body) -> fmt::Result {
    match body {
        Body::Prism { corners, .. } => {
            let corners: Vec<String> = corners.iter().map(|corner| list(corner)).collect();
            writeln!(f, "    corners [{}] m", corners.join(", "))
        }
        Body::Cylinder { centre, radius, .. } => {
            writeln!(f, "    centre {} m, radius {} m", list(centre), number(*radius))
        }
        // No area has such a body.
        Body::Ball { .. } | Body::HalfSpace { .. } => Ok(()),
    }
}

/// The lines of the plan: its settings where they are not the defaults.
pub(super) fn settings(f: &mut fmt::Formatter<'_>, model: &Model) -> fmt::Result {
    let RecoverySettings { order: ways, detection: [first, last], within, keep, require } = &model.plan.recovery;
    if let Some(Recoverable { uncovered, .. }) = require {
        writeln!(f, "  uncovered at most {} %", number(uncovered * 100.0))?;
    }
    let unsaid = RecoverySettings { require: *require, ..RecoverySettings::unsaid(&model.simulation) };
    if model.plan.recovery == unsaid {
        return Ok(());
    }
    write!(f, "  recovery {}, detection {}", order(ways, model), number(*first))?;
    if last > first {
        write!(f, " .. {}", number(*last))?;
    }
    writeln!(f, " s, within {} s, keep {} %", number(*within), number(keep * 100.0))
}

/// Ways out in the words of a spec.
pub(super) fn order(ways: &[Recovery], model: &Model) -> String {
    let site = |index: usize| model.mission.as_ref().and_then(|mission| mission.after_fault.sites.get(index));
    let word = |way: &Recovery| match way {
        Recovery::Continue => "continue",
        Recovery::LandAt(index) => site(*index).map_or("", |site| &site.name),
        Recovery::LandAtSites => "land_at_sites",
        Recovery::LandHere => "land_here",
    };
    format!("[{}]", ways.iter().map(word).collect::<Vec<_>>().join(", "))
}
