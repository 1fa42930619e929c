//! Which modes a plan provides for without yaw, and what that means.

use crate::admissible::without_yaw::planned::Provision;
use crate::flight::capture::heights::CaptureHeights;
use crate::flight::indistinguishable::listed;
use crate::model::Problem;
use crate::number::{number, significant};
use crate::planner::studies::{Comparison, Proof};
use crate::planner::timing::kinematics::least_time_within;
use serde::Serialize;

/// How a plan provides for a mode in which it gives up yaw.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WithoutYawRecord {
    /// core: the motion stays in the mode's core; capture: no rows, the vehicle is caught by its spin and landed.
    #[cfg_attr(test, schemars(extend("enum" = ["core", "capture"])))]
    pub planned: &'static str,
    /// Rates of the body about the thrust that it does not leave, rad/s; null with `capture`.
    pub spin_rad_s: Option<[f64; 2]>,
    /// Yaw torques that are used, N m; null with `capture`.
    pub yaw_torque_n_m: Option<[f64; 2]>,
}

/// The record of a mode; `None` where yaw is kept.
pub fn record(provision: &Provision) -> Option<WithoutYawRecord> {
    match provision {
        Provision::WithYaw => None,
        Provision::WithoutYaw(core) => Some(WithoutYawRecord {
            planned: "core",
            spin_rad_s: Some(core.spin_rad_s),
            yaw_torque_n_m: Some(core.yaw_torque_n_m),
        }),
        Provision::Capture => Some(WithoutYawRecord { planned: "capture", spin_rad_s: None, yaw_torque_n_m: None }),
    }
}

/// What plans are measured by against the modes: the admissible set of a mode, its core where yaw is given up, or some
/// by each.
pub fn measured_by(comparison: &Comparison) -> &'static str {
    let has = |wanted: fn(&Provision) -> bool| comparison.provisions.iter().any(wanted);
    match (has(|p| matches!(p, Provision::WithYaw)), has(|p| matches!(p, Provision::WithoutYaw(_)))) {
        (_, false) => "admissible set",
        (false, true) => "core",
        (true, true) => "admissible set, or its core where yaw is given up",
    }
}

/// `the set of L1`, `the sets of L1 and L2`, `the set of L1 and the cores of L4 and L5`: what plans are measured by
/// against some modes, given by their indices in the comparison.
pub fn sets_of(comparison: &Comparison, modes: &[usize]) -> String {
    let is_core = |i: &usize| matches!(comparison.provisions[*i], Provision::WithoutYaw(_));
    let (cores, sets): (Vec<usize>, Vec<usize>) = modes.iter().partition(|i| is_core(i));
    let named = |word: &str, modes: Vec<usize>| {
        let names: Vec<&str> = modes.iter().map(|i| comparison.modes[*i].as_str()).collect();
        match names[..] {
            [] => None,
            [one] => Some(format!("the {word} of {one}")),
            _ => Some(format!("the {word}s of {}", listed(&names))),
        }
    };
    let both: Vec<String> = [named("set", sets), named("core", cores)].into_iter().flatten().collect();
    both.join(" and ")
}

/// Modes with the same spins together, in the order of the first of each: `L1 and L2 (for every spin from -64 to 64
/// rad/s)`.
fn by_spin(planned: &[(&str, [f64; 2])]) -> String {
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for (name, [low, high]) in planned {
        let spins = format!("{} to {} rad/s", significant(*low, 3), significant(*high, 3));
        match groups.iter_mut().find(|(of, _)| *of == spins) {
            Some((_, names)) => names.push(name),
            None => groups.push((spins, vec![name])),
        }
    }
    let each: Vec<String> =
        groups.iter().map(|(spins, names)| format!("{} (for every spin from {spins})", listed(names))).collect();
    each.join("; ")
}

/// The sentences of a report's head, with the heights that faults cost if they were simulated; empty if the plan gives
/// up no yaw.
pub fn head(comparison: &Comparison, heights: Option<&CaptureHeights>) -> Vec<String> {
    let modes = || comparison.modes.iter().map(String::as_str).zip(&comparison.provisions);
    let mut sentences = Vec::new();
    let planned: Vec<(&str, [f64; 2])> = modes()
        .filter_map(|(name, provision)| match provision {
            Provision::WithoutYaw(core) => Some((name, core.spin_rad_s)),
            _ => None,
        })
        .collect();
    if !planned.is_empty() {
        sentences.push(format!(
            "Without yaw after a fault, whatever the heading, and proved for every spin that the yaw torques of hover \
             allow, which flights hardly use: {}",
            by_spin(&planned)
        ));
    }
    sentences.extend(not_planned(comparison, heights));
    sentences
}

/// The modes that add no rows to a plan.
pub fn without_rows(comparison: &Comparison) -> Vec<&str> {
    let modes = comparison.modes.iter().map(String::as_str).zip(&comparison.provisions);
    modes.filter(|(_, provision)| **provision == Provision::Capture).map(|(name, _)| name).collect()
}

/// What a plan does not say about the modes that add no rows to it, and the height that flights lose; `None` if there
/// are none.
pub fn not_planned(comparison: &Comparison, heights: Option<&CaptureHeights>) -> Option<String> {
    let modes = without_rows(comparison);
    let height = |heights: &CaptureHeights| {
        let known = format!("with the fault known after {} ms", number(1e3 * heights.delay));
        match heights.greatest() {
            height if height.is_finite() => {
                format!("by up to {} m {known} (simulated)", significant((10.0 * height).ceil() / 10.0, 3))
            }
            _ => format!("and some simulated flights {known} do not recover from any height"),
        }
    };
    let falls = heights.map_or("by a height that `mavc analyze --capture` simulates".into(), height);
    (!modes.is_empty()).then(|| {
        format!(
            "Not planned for {}: no torque is left in some direction, whatever the path. The vehicle falls until its \
             spin catches it, {falls}; not proved.",
            listed(&modes)
        )
    })
}

/// `; not planned for M1 and M2`: an addition to the verdict on a plan.
pub fn beside_the_verdict(comparison: &Comparison) -> String {
    match without_rows(comparison) {
        modes if modes.is_empty() => String::new(),
        modes => format!("; not planned for {}", listed(&modes)),
    }
}

/// What a proof of infeasibility at some times (s) does not say, where the plan gives up yaw; nothing where the limits
/// alone prove it.
pub fn of_proof(problem: Problem, comparison: &Comparison, proof: &Proof) -> Option<&'static str> {
    if least_time_within(problem).is_above(proof.at) {
        return None;
    }
    let has_core = |p: &Provision| matches!(p, Provision::WithoutYaw(_));
    comparison
        .provisions
        .iter()
        .any(has_core)
        .then_some("This is about motions inside the cores of modes without yaw; the vehicle may fly others.")
}
