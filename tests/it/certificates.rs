//! Certificates: what the checker's own arithmetic, sets and wrenches say against other ways to the same, and that no
//! false claim is accepted.

mod alone;
mod arithmetic;
mod between;
mod bounds;
mod checked;
mod command;
mod exact;
mod findings;
mod infeasible;
mod joints;
mod lag;
mod least_time;
mod relaxation;
mod resources;
mod selection;
mod sets;
mod tampering;
mod ways_out;
mod winds;
mod wrench;

use crate::vehicles::{limit, lost, mission, octocopter, waypoint};
use mavc::certificate::Certificate;
use mavc::diagnostic::Diagnostic;
use mavc::model::{LimitKind, MissionTime, Model, PlannerKind, Problem};
use mavc::planner::studies::{Comparison, Scope, run_planners};
use mavc::source::FileId;
use mavc::verify::{Accepted, Refusal, Rejection, Settings};

/// The hash that certificates in these tests carry.
const SHA: &str = "0123";

/// Reads bytes and decides what they claim.
fn verify(bytes: &[u8], model: &Model, sha256: &str) -> Result<Accepted, Box<Diagnostic>> {
    mavc::verify::verify(&mavc::verify::read(bytes, FileId::default())?, model, sha256, Settings::default())
}

/// Decides a certificate within the usual budget.
fn decide(certificate: &Certificate, model: &Model) -> Result<Accepted, Rejection> {
    mavc::verify::decide(certificate, model, Settings::default()).map_err(|refusal| match refusal {
        Refusal::Rejected(rejection) => rejection,
        costly @ Refusal::Budget { .. } => panic!("{costly:?}"),
    })
}

/// Numbers that look random and are the same in every run (splitmix64).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From -1 to 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// An octocopter that hops over a hold against two single losses, within limits that bind.
fn hop(planner: PlannerKind, time: f64) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    let mut flight =
        mission(vec![waypoint([0.0, 0.0, 2.0], 0.3), waypoint([3.0, 1.0, 3.0], 0.3), waypoint([5.0, 0.0, 2.5], 0.3)]);
    flight.waypoints[1].hold = 0.5;
    flight.limits = vec![
        limit(LimitKind::Speed, 2.5),
        limit(LimitKind::Tilt, 0.4),
        limit(LimitKind::Climb, 1.0),
        limit(LimitKind::Z, 4.0),
    ];
    model.mission = Some(flight);
    model.plan.planner = planner;
    model.plan.against = vec![0, 4];
    model.plan.time = MissionTime::Fixed(time);
    model.plan.samples = 30;
    model.plan.reserve = 0.05;
    model
}

fn planned(model: &Model) -> Comparison {
    run_planners(Problem::of(model).unwrap(), Scope::Plan, None)
}

fn certified(model: &Model) -> Option<Certificate> {
    let found = planned(model);
    // Multipliers, where a bound on the time would show it more simply.
    let of = match found.runs.last().is_some_and(|run| run.outcome.plan().is_some()) {
        true => mavc::certify::of,
        false => mavc::certify::by_multipliers,
    };
    of(Problem::of(model).unwrap(), &found, SHA.into()).ok()
}
