//! Fault modes that the torques cannot tell apart.

use super::estimate::{SPEAKS, torque_noise};
use crate::actuation::{Actuation, Wrench};
use crate::admissible::allocation::Allocator;
use crate::admissible::{HEALTHY, hover};
use crate::diagnostic::Diagnostic;
use crate::model::{Detection, Model};
use crate::motion::Trajectory;
use nalgebra::Vector3;

/// Modes, and groups of them, that a message names; of more it gives the number.
const SHOWN: usize = 6;

/// Modes that an estimator is asked to tell apart are alike in hover.
pub const ALIKE: &str = "mavc::simulate::alike";

/// An estimator of capacities is to find a rotor that is stuck.
pub const STUCK: &str = "mavc::simulate::stuck";

/// Squared rotor speeds (rad^2/s^2) with which the healthy vehicle gives a wrench.
fn squares(allocator: &Allocator, wrench: &Wrench) -> Vec<f64> {
    allocator.speeds(wrench).iter().map(|w| w * w).collect()
}

/// Groups of modes (0 is healthy, i + 1 is `Model::modes[i]`) whose torques differ too little at the instants for one sample of the estimator;
/// only groups of two or more. `instants` holds squared rotor speeds.
///
/// A fault is like the healthy vehicle where at every instant the difference of their torques is below the threshold at
/// which the estimator takes a sample in. Two faults are alike where it is below that threshold over the root of the
/// samples that the forgetting factor keeps, 1/(1 - lambda). Being alike is not transitive; a mode joins the first
/// group whose first member it is like.
pub fn twins(model: &Model, instants: &[Vec<f64>]) -> Vec<Vec<usize>> {
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
                .map(|(k, ((c, s), r))| match mode.stuck[k] {
                    Some(share) => c * (share * r.max_speed * r.max_speed),
                    None => c * (mode.capacity[k] * s),
                })
                .sum()
        };
        instants.iter().map(under).collect()
    }));
    let kept = 1.0 / (1.0 - simulation.forgetting);
    let near = |d: Vector3<f64>, healthy: bool| match healthy {
        true => d.amax() <= SPEAKS,
        false => d.norm() * kept.sqrt() <= SPEAKS,
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

/// Instants of a plan at which modes are compared: with thousands of modes every node would be too many.
const INSTANTS: usize = 200;

/// Groups of modes that look alike to the estimator at nodes spread over a plan; none where nothing is estimated.
pub fn along(model: &Model, trajectory: &Trajectory) -> Vec<Vec<usize>> {
    if model.simulation.detection != Detection::Estimator {
        return Vec::new();
    }
    let wrenches = trajectory.node_wrenches(&model.vehicle, model.gravity);
    let every = wrenches.len().div_ceil(INSTANTS);
    let allocator = Allocator::new(&model.vehicle);
    let instants: Vec<Vec<f64>> = wrenches.iter().step_by(every).map(|w| squares(&allocator, w)).collect();
    twins(model, &instants)
}

/// Names of a group's modes, the healthy vehicle's first.
pub fn names<'a>(model: &'a Model, group: &[usize]) -> Vec<&'a str> {
    group.iter().map(|&m| if m == 0 { HEALTHY } else { model.modes[m - 1].name.as_str() }).collect()
}

/// Warns where a written `simulate` asks for estimates and modes that it or a campaign may strike pin a rotor or are
/// alike in hover. Every plan begins and ends there, and so does every hold.
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
    let pinned = |mode: usize| model.modes[mode].stuck.iter().any(Option::is_some);
    let stuck: Vec<&str> =
        (0..model.modes.len()).filter(|m| is_struck(*m) && pinned(*m)).map(|m| model.modes[m].name.as_str()).collect();
    if !stuck.is_empty() {
        let what = if stuck.len() == 1 { "a stuck rotor" } else { "stuck rotors" };
        let message = format!("the estimator takes {what} for losses: {}", listed(&stuck));
        found.push(
            warning(STUCK, message)
                .help("a capacity says how much is lost, not that a rotor gives too much: write `detection = 50 ms`"),
        );
    }
    let groups = twins(model, &[squares(&Allocator::new(&model.vehicle), &hover(model))]);
    let matters = |group: &&Vec<usize>| model.campaign.written || group.iter().any(|m| struck.contains(m));
    let told = |group: &Vec<usize>| {
        let names = names(model, group);
        format!("{} from {}", listed(&names[1..]), names[0])
    };
    let told: Vec<String> = groups.iter().filter(matters).map(told).collect();
    if told.is_empty() {
        return found;
    }
    let some = if told.len() > SHOWN { format!("; and {} more groups", told.len() - SHOWN) } else { String::new() };
    let message = format!("in hover the estimator may not tell {}{some}", told[..told.len().min(SHOWN)].join("; nor "));
    found
        .push(warning(ALIKE, message).help(
            "their torques there differ by less than the threshold for one sample: write `detection = 50 ms` for faults that \
             something else reports",
        ));
    found
}

/// `healthy and M1_5`; of many the first ones and the number.
pub fn listed(names: &[&str]) -> String {
    match names {
        [one] => one.to_string(),
        [all @ .., last] if names.len() <= SHOWN => format!("{} and {last}", all.join(", ")),
        _ => format!("{} and {} more", names[..SHOWN].join(", "), names.len() - SHOWN),
    }
}
