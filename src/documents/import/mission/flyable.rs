//! What the items of a mission ask of a vehicle beyond the rules of a spec: speeds and times that it cannot reach.

use super::draft::Draft;
use super::{SPEED, TOO_SOON};
use crate::admissible::AdmissibleSet;
use crate::admissible::airspeed::Airspeed;
use crate::diagnostic::Diagnostic;
use crate::import::at;
use crate::number::{number, significant};
use crate::planner::timing::kinematics::least_time_within;
use crate::spec::Spec;

/// A tenth of a per cent: a speed that the vehicle reaches to within this is one that it reaches.
const SAME_SPEED: f64 = 1e-3;

pub fn check(spec: &Spec, draft: &Draft) -> Vec<Diagnostic> {
    let mut found = speeds(spec, draft);
    found.extend(too_soon(spec, draft));
    found
}

/// Items that set a larger horizontal speed than the healthy vehicle holds in level flight in still air
/// (`docs/method/air.md`). Without `drag` no speed is known to be too large.
fn speeds(spec: &Spec, draft: &Draft) -> Vec<Diagnostic> {
    let model = spec.model();
    let airspeed = Airspeed::of(model, &AdmissibleSet::healthy(model));
    let Some(most) = airspeed.and_then(|airspeed| airspeed.largest_m_per_s) else { return Vec::new() };
    let mut found: Vec<Diagnostic> = Vec::new();
    for (speed, mark) in draft.stops.iter().flat_map(|stop| &stop.speeds.horizontal) {
        let span = at(mark.span.clone());
        if *speed <= most * (1.0 + SAME_SPEED) || found.iter().any(|d| d.span == span) {
            continue;
        }
        let message = format!("{} sets {} m/s, which the vehicle does not hold", mark.name, number(*speed));
        let here = format!("at most {} m/s in level flight", significant(most, 3));
        found.push(Diagnostic::warning(SPEED, span, message).here(here).help("the plan will be slower: set less"));
    }
    found
}

/// The first waypoint whose time is earlier than the limits of the mission allow.
fn too_soon(spec: &Spec, draft: &Draft) -> Option<Diagnostic> {
    let (index, seconds) = least_time_within(spec.problem()?).too_early?;
    let stop = draft.stops.get(index)?;
    let due = stop.time?;
    let message =
        format!("{} cannot be reached at {} s: the limits of the mission do not allow it", stop.mark.name, number(due));
    let here = format!("not before {} s", significant(seconds, 4));
    let error = Diagnostic::error(TOO_SOON, at(stop.mark.span.clone()), message).here(here);
    Some(error.help("set a later time for it, and for those after it"))
}
