//! Vehicles that have to be caught after a fault: at which instants simulated flights catch and land them.

use super::search::{Found, at_instants, pieces};
use super::{ModeRecovery, Way};
use crate::cancel;
use crate::flight::{Outcome, Sortie, fly};
use crate::model::{AfterFault, Detection, LostYaw, Model, Problem, Recovery, Simulation, Strike};
use crate::motion::Trajectory;
use crate::recovery::carry::quiet;
use crate::source::Span;

/// Whether the spec allows a vehicle that is caught after a fault of a mode to come down: there is a ground, and a
/// landing in the order of ways out.
pub fn may_land(model: &Model, mode: usize) -> bool {
    let Some(mission) = model.mission.as_ref().filter(|mission| mission.ground.is_some()) else { return false };
    model.recovery(mode).iter().any(|way| *way == Recovery::LandHere || !mission.sites_of(*way).is_empty())
}

/// Where along a plan a vehicle is caught and lands after faults of one mode. Simulated flights along the plan stop and
/// descend once the fault is known. Two are flown for each delay, without and with noise and gusts, and both have to
/// land in time where the spec allows it.
pub fn caught(problem: Problem, plan: &Trajectory, mode: usize, delays: &[f64]) -> ModeRecovery {
    let flights = [quiet(problem.model()), problem.model().simulation.clone()];
    let mut at = |at: f64| {
        cancel::checkpoint();
        let lands = |delay: &f64| flights.iter().all(|flight| lands(problem, plan, [at, *delay], mode, flight));
        Found::without_branch(at, delays.iter().all(lands).then_some(Way::Caught))
    };
    let found = at_instants(plan.duration(), &mut at);
    let instants = found.len();
    ModeRecovery { mode, not_attempted: None, pieces: pieces(found).0, instants, families: None }
}

/// Whether the vehicle lands after a fault at some time of the plan that is known some delay later, s.
fn lands(problem: Problem, plan: &Trajectory, [at, delay]: [f64; 2], mode: usize, flight: &Simulation) -> bool {
    let (model, mission) = (problem.model(), problem.mission());
    let Some(ground) = mission.ground else { return false };
    let within = model.plan.recovery.within;
    let simulation = Simulation {
        duration: None,
        detection: Detection::After(delay),
        after_fault: AfterFault::Land,
        faults: Vec::new(),
        ground,
        lost_yaw: LostYaw::Off,
        lost_beyond: f64::INFINITY,
        ..flight.clone()
    };
    let span = Span::default();
    let strikes = [Strike { mode, at, until: None, at_span: span, span }];
    let along = Sortie::along(model, plan, &strikes, model.simulation.seed);
    let ends = if plan.ends_at_rest() { at + delay + within } else { plan.duration() };
    let sortie = Sortie { simulation: &simulation, duration: ends.max(plan.duration()), goes_on: false, ..along };
    let Outcome::Landed { at: touched, place: [x, y, _], .. } = fly(&sortie, None).outcome else { return false };
    let rules = &mission.after_fault;
    let allowed = |way: &Recovery| match way {
        Recovery::LandHere => rules.too_close([x, y], model.vehicle.radius()).1 <= 0.0,
        way => mission.sites_of(*way).iter().any(|&site| {
            let site = &rules.sites[site];
            (x - site.at[0]).hypot(y - site.at[1]) <= site.radius
        }),
    };
    touched <= at + delay + within && model.recovery(mode).iter().any(allowed)
}
