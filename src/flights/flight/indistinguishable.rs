//! Indistinguishable fault modes: modes whose torques differ too little for the estimator. See `docs/flight.md`,
//! section 4.

use super::estimate::{LEAST_SHIFT, torque_noise};
use crate::actuation::{Actuation, Wrench};
use crate::admissible::allocation::Allocator;
use crate::admissible::{HEALTHY, hover};
use crate::diagnostic::Diagnostic;
use crate::model::{Detection, Model};
use crate::motion::Trajectory;
use nalgebra::Vector3;

/// The number of modes, and of groups, that a message names; if there are more, it gives the number of the others.
const SHOWN: usize = 6;

/// Code: modes are indistinguishable in hover for the estimator that the spec configures.
pub(crate) const ALIKE: &str = "mavc::simulate::alike";

/// Code: the spec configures the estimator for a mode with a stuck rotor.
const STUCK: &str = "mavc::simulate::stuck";

/// The squared rotor speeds (rad^2/s^2) with which the healthy vehicle produces a wrench.
fn squares(allocator: &Allocator, wrench: &Wrench) -> Vec<f64> {
    allocator.speeds(wrench).iter().map(|w| w * w.abs()).collect()
}

/// Groups of two or more indistinguishable modes. In a group 0 is the healthy vehicle and i + 1 is `Model::modes[i]`.
/// `instants` has the squared rotor speeds (rad^2/s^2) at each instant.
///
/// A fault mode is indistinguishable from the healthy vehicle if at every instant the difference of their torques is at
/// most the estimator's threshold for the mean of its samples in still air. Two fault modes are if it is at most the
/// threshold for one sample over the square root of the number of samples that the forgetting factor keeps, 1/(1 -
/// lambda). The relation is not transitive: a mode joins the first group whose first member it cannot be distinguished
/// from.
fn indistinguishable(model: &Model, instants: &[Vec<f64>]) -> Vec<Vec<usize>> {
    let simulation = &model.simulation;
    let noise = torque_noise(model, simulation.gyroscope_noise, 1.0 / simulation.estimator_rate);
    let columns: Vec<Vector3<f64>> = Actuation::of(&model.vehicle)
        .effectiveness
        .column_iter()
        .map(|c| c.fixed_rows::<3>(1).component_div(&noise))
        .collect();
    let healthy = |squares: &Vec<f64>| columns.iter().zip(squares).map(|(c, s)| c * *s).sum::<Vector3<f64>>();
    let mut torques: Vec<Vec<Vector3<f64>>> = vec![instants.iter().map(healthy).collect()];
    torques.extend(model.modes.iter().map(|mode| {
        let under = |squares: &Vec<f64>| {
            let rotors = columns.iter().zip(squares).zip(&model.vehicle.rotors).enumerate();
            rotors
                .map(|(k, ((c, s), r))| match mode.rotors[k].stuck_at() {
                    Some(share) => c * (share * r.max_speed * r.max_speed),
                    None => c * (mode.rotors[k].capacity() * s),
                })
                .sum()
        };
        instants.iter().map(under).collect()
    }));
    let kept = 1.0 / (1.0 - simulation.forgetting);
    let near = |d: Vector3<f64>, healthy: bool| match healthy {
        true => d.amax() <= simulation.threshold * LEAST_SHIFT,
        false => d.norm() * kept.sqrt() <= simulation.threshold,
    };
    let alike = |a: usize, b: usize| torques[a].iter().zip(&torques[b]).all(|(x, y)| near(x - y, a == 0));
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for mode in 0..torques.len() {
        match groups.iter_mut().find(|g| alike(g[0], mode)) {
            Some(group) => group.push(mode),
            None => groups.push(vec![mode]),
        }
    }
    groups.retain(|g| g.len() > 1);
    groups
}

/// The largest number of nodes of a plan at which modes are compared; with thousands of modes all nodes would take too
/// long.
const INSTANTS: usize = 200;

/// Groups of modes that are indistinguishable for the estimator all along a plan, compared at up to 200 of its nodes;
/// none without an estimator. In a group 0 is the healthy vehicle and i + 1 is `Model::modes[i]`.
pub fn along(model: &Model, trajectory: &Trajectory) -> Vec<Vec<usize>> {
    if model.simulation.detection != Detection::Estimator {
        return Vec::new();
    }
    let wrenches = trajectory.node_wrenches(&model.vehicle, &model.environment());
    let every = wrenches.len().div_ceil(INSTANTS);
    let allocator = Allocator::new(&model.vehicle);
    let instants: Vec<Vec<f64>> = wrenches.iter().step_by(every).map(|w| squares(&allocator, w)).collect();
    indistinguishable(model, &instants)
}

/// The names of the modes of a group, in its order.
pub fn names<'a>(model: &'a Model, group: &[usize]) -> Vec<&'a str> {
    group.iter().map(|&m| if m == 0 { HEALTHY } else { model.modes[m - 1].name.as_str() }).collect()
}

/// Warnings if the spec configures the estimator and the modes that `simulate` or `campaign` may strike have a stuck
/// rotor or are indistinguishable in hover. Hover is compared because plans from rest to rest, and holds, begin and end
/// there.
pub fn diagnose(model: &Model) -> Vec<Diagnostic> {
    let written = model.simulation.written || model.campaign.written;
    if !written || model.simulation.detection != Detection::Estimator || model.modes.is_empty() {
        return Vec::new();
    }
    let struck: Vec<usize> = model.simulation.faults.iter().map(|s| s.mode + 1).collect();
    let span = if model.simulation.written { model.simulation.span } else { model.campaign.span };
    let warning =
        |code, message: String| Diagnostic::warning(code, span, message).here("capacities are estimated here");
    let mut found = Vec::new();
    let is_struck = |mode: usize| model.campaign.written || struck.contains(&(mode + 1));
    let pinned = |mode: usize| model.modes[mode].has_stuck();
    let stuck: Vec<&str> =
        (0..model.modes.len()).filter(|m| is_struck(*m) && pinned(*m)).map(|m| model.modes[m].name.as_str()).collect();
    if !stuck.is_empty() {
        let what = if stuck.len() == 1 { "a stuck rotor" } else { "stuck rotors" };
        let message = format!("the estimator mistakes {what} for losses: {}", listed(&stuck));
        found.push(
            warning(STUCK, message).help(
                "a capacity describes a loss of thrust, not a rotor that gives too much: write `detection = 50 ms`",
            ),
        );
    }
    let groups = indistinguishable(model, &[squares(&Allocator::new(&model.vehicle), &hover(model))]);
    let matters = |group: &&Vec<usize>| model.campaign.written || group.iter().any(|m| struck.contains(m));
    let pairs = |group: &Vec<usize>| {
        let names = names(model, group);
        format!("{} from {}", listed(&names[1..]), names[0])
    };
    let pairs: Vec<String> = groups.iter().filter(matters).map(pairs).collect();
    if pairs.is_empty() {
        return found;
    }
    let some = if pairs.len() > SHOWN { format!("; and {} more groups", pairs.len() - SHOWN) } else { String::new() };
    let message =
        format!("in hover the estimator may not distinguish {}{some}", pairs[..pairs.len().min(SHOWN)].join("; nor "));
    found.push(warning(ALIKE, message).help(
        "their torques in hover differ by less than the threshold: write `detection = 50 ms` if \
         something else reports the faults",
    ));
    found
}

/// Names as a list in a sentence: `healthy and M1_5`. Of many names the first ones and the number of the others.
pub fn listed(names: &[&str]) -> String {
    match names {
        [one] => one.to_string(),
        [all @ .., last] if names.len() <= SHOWN => format!("{} and {last}", all.join(", ")),
        _ => format!("{} and {} more", names[..SHOWN].join(", "), names.len() - SHOWN),
    }
}
