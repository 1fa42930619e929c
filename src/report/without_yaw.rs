//! Which modes a plan provides for without yaw, and what that means.

use crate::admissible::without_yaw::planned::Provision;
use crate::flight::indistinguishable::listed;
use crate::model::Problem;
use crate::number::significant;
use crate::planner::studies::{Comparison, Proof};
use crate::planner::timing::kinematics::least_time_within;
use serde::Serialize;

/// How a plan provides for a mode in which it gives up yaw.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WithoutYawRecord {
    /// `core`: the motion stays in the mode's core; `capture`: no rows, the vehicle is caught by its spin and landed.
    pub planned: &'static str,
    /// The rates of the body about the thrust that it does not leave, rad/s; `None` with `capture`.
    pub spin_rad_s: Option<[f64; 2]>,
    /// The yaw torques that are used, N m.
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

/// The sentences of a report's head; empty if the plan gives up no yaw.
pub fn head(comparison: &Comparison) -> Vec<String> {
    let modes = || comparison.modes.iter().map(String::as_str).zip(&comparison.provisions);
    let mut sentences = Vec::new();
    let planned: Vec<(&str, [f64; 2])> = modes()
        .filter_map(|(name, provision)| match provision {
            Provision::WithoutYaw(core) => Some((name, core.spin_rad_s)),
            _ => None,
        })
        .collect();
    if !planned.is_empty() {
        let names: Vec<&str> = planned.iter().map(|(name, _)| *name).collect();
        let low = planned.iter().map(|(_, spin)| spin[0]).fold(f64::INFINITY, f64::min);
        let high = planned.iter().map(|(_, spin)| spin[1]).fold(f64::NEG_INFINITY, f64::max);
        sentences.push(format!(
            "Without yaw after a fault of {}: for every heading and spins of {} to {} rad/s",
            listed(&names),
            significant(low, 3),
            significant(high, 3)
        ));
    }
    let caught: Vec<&str> = modes().filter(|(_, p)| **p == Provision::Capture).map(|(name, _)| name).collect();
    if !caught.is_empty() {
        sentences.push(format!(
            "No rows for {}: caught by its spin and landed, which only flights judge (`mavc analyze --capture`)",
            listed(&caught)
        ));
    }
    sentences
}

/// What a proof of infeasibility at some times (s) does not say, where the plan gives up yaw; nothing where the limits alone prove it.
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
