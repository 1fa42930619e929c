//! Branches in simulated flights: with the noise and gusts of the spec, from the fault on.

use super::{FoundBranch, Recovery, Way};
use crate::flight::reference::{Branching, Course};
use crate::flight::{Outcome, Sortie, fly};
use crate::model::{AfterFault, Detection, LostYaw, Model, Simulation, Strike};
use crate::motion::Trajectory;
use crate::source::Span;
use rayon::prelude::*;
use std::borrow::Cow;

/// How long a flight goes on after its branch has ended on the ground, s.
const AT_REST: f64 = 1.0;

/// The ground of these flights lies this much lower, m: their references come to rest on it, and errors of tracking are
/// no crashes.
const BELOW: f64 = 1.0;

/// How a branch is flown: from the fault, while the vehicle follows the plan exactly, to the end of the branch, and of
/// the plan where it returns there. The fault is known when the branch begins.
pub fn fly_branch(model: &Model, plan: &Trajectory, branch: &FoundBranch, seed: u64) -> Outcome {
    let FoundBranch { mode, way, fault_at, delay, motion, .. } = branch;
    let (returns, spins) = match way {
        Way::Continue => (true, false),
        Way::ContinueSpinning => (true, true),
        Way::LandAt(_) | Way::LandHere | Way::Caught => (false, false),
    };
    let rest = plan.part(*fault_at, (plan.duration() - fault_at).max(delay + motion.duration()));
    let simulation = Simulation {
        duration: None,
        detection: Detection::After(*delay),
        after_fault: AfterFault::Continue,
        faults: Vec::new(),
        ground: model.simulation.ground.min(model.mission.as_ref().and_then(|m| m.ground).unwrap_or(f64::INFINITY))
            - BELOW,
        lost_yaw: if spins { LostYaw::Off } else { model.simulation.lost_yaw },
        ..model.simulation.clone()
    };
    let span = Span::default();
    let strikes = [Strike { mode: *mode, at: 0.0, until: None, at_span: span, span }];
    let ends = delay + motion.duration() + AT_REST;
    let sortie = Sortie {
        model,
        vehicle: Cow::Borrowed(&model.vehicle),
        simulation: &simulation,
        course: Course::Branch(Box::new(Branching {
            plan: &rest,
            begins: *delay,
            motion: Cow::Borrowed(motion),
            returns,
            sink: 0.0,
        })),
        mission: None,
        strikes: &strikes,
        seed,
        duration: if returns { rest.duration().max(ends) } else { ends },
        airspeed: 0.0,
        goes_on: false,
        ways_out: None,
    };
    fly(&sortie, None).outcome
}

/// The seed of the one simulated flight of a branch: the seeds count from that of the spec, in the order of branches.
pub fn flight_seed(model: &Model, branch: usize) -> u64 {
    model.simulation.seed.wrapping_add(branch as u64)
}

/// The branches that do not end as planned in one simulated flight each; as indices, ascending.
pub fn failures(model: &Model, plan: &Trajectory, recovery: &Recovery) -> Vec<usize> {
    let fails = |(index, branch): (usize, &FoundBranch)| {
        let outcome = fly_branch(model, plan, branch, flight_seed(model, index));
        (!matches!(outcome, Outcome::Flown)).then_some(index)
    };
    recovery.branches.par_iter().enumerate().filter_map(fails).collect()
}
