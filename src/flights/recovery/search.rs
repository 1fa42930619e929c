//! The ways out after the faults of one mode, instant by instant.

mod families;
mod gaps;
mod instants;
mod landings;

use super::carry::{Carried, carry, quiet};
use super::{FoundBranch, ModeRecovery, RESOLUTION, Way};
use crate::admissible::without_yaw::planned::{PlannedCore, Provision};
use crate::admissible::{AdmissibleSet, trimmed};
use crate::cancel;
use crate::energy::Power;
use crate::model::{HeldLimit, LandingSite, Model, Problem, Recovery, Simulation};
use crate::motion::outside::{outside, violation_intervals};
use crate::motion::{NodeState, Trajectory};
use crate::planner::branch::{Branches, Goal, Room, early_set};
use crate::planner::scp::Iterate;
use crate::planner::selection::PlanningSet;
use crate::solve::Effort;
use crate::tolerance::MOST_OUTSIDE;
pub(super) use instants::{at_instants, pieces};
use std::collections::BTreeMap;

/// Times in which a branch goes back to the plan, s, in the order tried. The longer it lasts, the more it can do, and
/// the less its end depends on its start; but it keeps room from the set's facets all the time, which the plan may not.
/// Chosen by hand; in the order 1, 2, 4 s `examples/roof_octo.mav` was covered for the same times, in 1.3 times the
/// processor time.
const BACK_IN: [f64; 3] = [4.0, 1.0, 2.0];

/// Whether rest is outside a set, or inside it with less than the margin that branches keep.
pub(super) fn cannot_hover(model: &Model, set: &PlanningSet) -> bool {
    let (at_rest, margin) = (trimmed(model, &model.environment()), Room::LITTLE.of_set);
    set.rows.iter().any(|row| row.violation(&at_rest) > if row.equality { margin } else { -margin })
}

pub(super) struct Search<'a> {
    problem: Problem<'a>,
    plan: &'a Trajectory,
    mode: usize,
    set: &'a PlanningSet,
    /// The mode's core, if it gives up yaw.
    core: Option<&'a PlannedCore>,
    /// The last instant at which the plan is outside the mode's set, s; minus infinity without one.
    last_outside: f64,
    /// The limits on places that the vehicle may not violate before the fault is known.
    places: Vec<HeldLimit>,
    /// Sought first: those that keep enough room for families about them, if these are sought.
    roomy: Option<Branches<'a>>,
    tight: Branches<'a>,
    simulation: Simulation,
    /// Where the spec asks for charge that is left.
    power: Option<Power>,
    delays: &'a [f64],
    /// The last branch for each way and delay.
    last: BTreeMap<(usize, usize), Iterate>,
    /// For how many instants in a row no branch was found, for each way and delay.
    failed: BTreeMap<(usize, usize), usize>,
}

/// The outcome at one instant, with a branch for each delay.
pub(super) struct Found {
    at: f64,
    way: Option<Way>,
    branches: Vec<FoundBranch>,
    iterates: Vec<Iterate>,
}

impl Found {
    pub fn none(at: f64) -> Self {
        Found::without_branch(at, None)
    }

    pub fn without_branch(at: f64, way: Option<Way>) -> Self {
        Found { at, way, branches: Vec::new(), iterates: Vec::new() }
    }
}

/// Where a branch begins, and what is known of it.
struct Start<'b> {
    /// The place of the delay, and the delay: after the fault, s.
    index: usize,
    delay: f64,
    state: &'b NodeState,
    /// The last branch of this way and delay, and the one at this instant of a longer delay.
    alike: [Option<&'b Iterate>; 2],
    /// For how many instants in a row none was found before this one.
    failed: usize,
}

impl Start<'_> {
    /// Those of some times that are tried: all, or next to instants at which all failed the first one, and each of the
    /// others in turn.
    fn tried(&self, times: impl Iterator<Item = f64>) -> Vec<f64> {
        let all: Vec<f64> = times.collect();
        match (self.failed, &all[..]) {
            (1.., [first, others @ ..]) if others.len() > 1 => vec![*first, others[(self.failed - 1) % others.len()]],
            _ => all,
        }
    }
}

/// The mode for whose faults ways out are sought: its set, and how plans provide for it.
pub(super) struct SoughtMode<'a> {
    pub mode: usize,
    pub set: &'a PlanningSet,
    pub provision: &'a Provision,
}

impl<'a> Search<'a> {
    pub fn new(
        problem: Problem<'a>,
        plan: &'a Trajectory,
        SoughtMode { mode, set, provision }: SoughtMode<'a>,
        healthy: &'a AdmissibleSet,
        delays: &'a [f64],
        between: bool,
    ) -> Self {
        let model = problem.model();
        let intervals = (0..plan.intervals())
            .flat_map(|k| violation_intervals(plan, &model.vehicle, &model.environment(), &set.rows, k).0);
        let last_outside = intervals.map(|interval| interval.to).fold(f64::NEG_INFINITY, f64::max);
        let held = problem.mission().limits_after_fault();
        let places = held.iter().filter(|held| held.limit.volume.is_some()).cloned().collect();
        let core = match provision {
            Provision::WithoutYaw(core) => Some(core),
            Provision::WithYaw | Provision::Capture => None,
        };
        let branches =
            |room: Room| Branches::new(problem, healthy, set, room, plan.model, held.clone()).with_core(core);
        Search {
            roomy: between.then(|| branches(Room::WIDE)),
            tight: branches(Room::LITTLE),
            core,
            simulation: quiet(model),
            power: if model.plan.recovery.keep > 0.0 { Power::of(model) } else { None },
            last: BTreeMap::new(),
            failed: BTreeMap::new(),
            problem,
            plan,
            mode,
            set,
            last_outside,
            places,
            delays,
        }
    }

    /// The outcomes at instants that are [`super::apart`] from each other, and where gaps begin and end to
    /// [`RESOLUTION`].
    pub fn all(&mut self) -> Vec<Found> {
        at_instants(self.plan.duration(), &mut |at| self.at(at))
    }

    /// What the outcomes are, and what [`Search::again`] found later, say of the mode.
    pub fn result(mut self, found: Vec<Found>, fresh: Vec<Found>) -> (ModeRecovery, Vec<FoundBranch>, Effort) {
        let found = self.mended(found, fresh);
        let instants = found.len();
        let families = self.families(&found);
        let (mut pieces, branches) = pieces(found);
        self.look_for_near_misses(&mut pieces);
        let mut effort = self.tight.effort;
        effort += self.roomy.map_or_else(Effort::default, |roomy| roomy.effort);
        let recovery = ModeRecovery { mode: self.mode, not_attempted: None, pieces, instants, families };
        (recovery, branches, effort)
    }

    /// The first way out after a fault at one instant, for the longest delay.
    pub fn first(mut self, at: f64) -> Option<FoundBranch> {
        self.at(at).branches.pop()
    }

    /// The share of the battery's charge that is left after a motion that follows the plan up to a time; `None` if the
    /// spec does not ask for it.
    fn left_after(&self, until: f64, motion: &Trajectory) -> Option<f64> {
        let (power, battery) = (self.power.as_ref()?, self.problem.model().vehicle.battery.as_ref()?);
        let energy = power.along(&self.plan.part(0.0, until)).energy + power.along(motion).energy;
        Some(1.0 - energy / battery.energy())
    }

    /// Whether a motion is outside the set at some instant, also between those at which its rows were imposed.
    fn leaves_the_set(&self, motion: &Trajectory) -> bool {
        let model = self.problem.model();
        let early =
            self.core.and_then(|core| early_set(model, motion.model, core, &motion.nodes[0], motion.duration()));
        let rows = &early.as_ref().unwrap_or(self.set).rows;
        outside(motion, &model.vehicle, &model.environment(), rows).max_violation > MOST_OUTSIDE
    }

    /// Whether too little charge is left after a motion that follows the plan up to a time.
    fn drains(&self, until: f64, motion: &Trajectory) -> bool {
        self.left_after(until, motion).is_some_and(|left| left < self.problem.model().plan.recovery.keep)
    }

    /// The vehicle `delay` s after a fault at `at` s; `None` if it turns over.
    fn carried(&self, at: f64, delay: f64) -> Option<Carried> {
        carry(self.problem.model(), &self.simulation, self.plan, self.mode, at, delay)
    }

    /// The first way out, in the order of the spec, that there is for each delay.
    fn at(&mut self, at: f64) -> Found {
        cancel::checkpoint();
        let Some(carried) = self.all_carried(at) else { return Found::none(at) };
        let order = self.problem.model().recovery(self.mode);
        order.iter().find_map(|recovery| self.way(*recovery, at, &carried)).unwrap_or_else(|| Found::none(at))
    }

    /// The vehicle at the end of each delay; `None` if it turns over or is somewhere it may not be.
    fn all_carried(&self, at: f64) -> Option<Vec<Carried>> {
        let carried: Vec<Carried> = self.delays.iter().map(|delay| self.carried(at, *delay)).collect::<Option<_>>()?;
        let leaves =
            |held: &HeldLimit, p: &[f64; 3]| held.limit.violation_at(*p).is_some_and(|over| over > held.yields);
        let strays = carried.iter().flat_map(|c| &c.path).any(|p| self.places.iter().any(|held| leaves(held, p)));
        (!strays).then_some(carried)
    }

    /// How the vehicle goes on to the end of the plan.
    fn back(&self) -> Way {
        if self.core.is_some() { Way::ContinueSpinning } else { Way::Continue }
    }

    fn way(&mut self, recovery: Recovery, at: f64, carried: &[Carried]) -> Option<Found> {
        match recovery {
            Recovery::Continue => self.continued(at, carried),
            Recovery::LandAt(_) | Recovery::LandAtSites => {
                let sites = self.by_distance(self.problem.mission().sites_of(recovery), &carried[0].state);
                sites.into_iter().find_map(|site| {
                    let LandingSite { at: to, radius, .. } = self.problem.mission().after_fault.sites[site];
                    self.landed(at, carried, Way::LandAt(site), to, radius)
                })
            }
            Recovery::LandHere => self.landed_here(at, carried),
        }
    }

    /// Back to the plan within some time, after which the plan stays inside the set.
    fn continued(&mut self, at: f64, carried: &[Carried]) -> Option<Found> {
        let way = self.back();
        let within = self.problem.model().plan.recovery.within;
        self.for_each_delay(at, carried, way, |search, start| {
            let Start { delay, state, .. } = start;
            let joins_inside = |time: &f64| search.last_outside <= at + delay + time;
            let times = BACK_IN.into_iter().filter(|time| *time <= within).filter(joins_inside);
            let times = start.tried(times);
            let alike = start.alike.map(|known| known.filter(|known| times.contains(&known.grid.total)));
            search.branch(state, alike, &times, |search, time| Goal::Rejoin(search.planned(at + delay + time)))
        })
    }

    /// The state of the plan, at rest after its end.
    fn planned(&self, at: f64) -> NodeState {
        if at < self.plan.duration() {
            return self.plan.at(at);
        }
        self.plan.nodes[self.plan.intervals()].map(|axis| [axis[0], 0.0, 0.0, 0.0, 0.0])
    }

    /// A branch from a state about one of those that are `alike`, or else in one of some times, s; one with room if
    /// there is one.
    fn branch(
        &mut self,
        state: &NodeState,
        alike: [Option<&Iterate>; 2],
        times: &[f64],
        goal: impl Fn(&Self, f64) -> Goal,
    ) -> Option<Iterate> {
        let about: Vec<_> = alike.into_iter().flatten().map(|known| (known, goal(self, known.grid.total))).collect();
        let goals: Vec<(f64, Goal)> = times.iter().map(|time| (*time, goal(self, *time))).collect();
        self.roomy.iter_mut().chain([&mut self.tight]).find_map(|branches| {
            let found = about.iter().find_map(|(known, goal)| branches.find_about(state, goal, known));
            found.or_else(|| goals.iter().find_map(|(time, goal)| branches.find(state, goal, *time)))
        })
    }

    /// A branch for each delay, found from those that are alike; `None` if one is not found.
    fn for_each_delay(
        &mut self,
        at: f64,
        carried: &[Carried],
        way: Way,
        mut find: impl FnMut(&mut Self, Start) -> Option<Iterate>,
    ) -> Option<Found> {
        let (mut branches, mut iterates) = (Vec::with_capacity(carried.len()), Vec::with_capacity(carried.len()));
        // The longest delay is the hardest.
        for (index, carried) in carried.iter().enumerate().rev() {
            let key = (key(way), index);
            let last = self.last.remove(&key);
            let delay = self.delays[index];
            let alike = [last.as_ref(), iterates.last()];
            let failed = self.failed.remove(&key).unwrap_or(0);
            let Some(found) = find(self, Start { index, delay, state: &carried.state, alike, failed }) else {
                self.failed.insert(key, failed + 1);
                return None;
            };
            let (mode, deviation, motion) = (self.mode, carried.deviation, found.trajectory());
            let whole = match way {
                Way::LandAt(_) | Way::LandHere | Way::Caught => motion.clone(),
                // The battery holds the rest of the plan too.
                Way::Continue | Way::ContinueSpinning => {
                    self.plan.part(at + delay, (self.plan.duration() - at - delay).max(RESOLUTION))
                }
            };
            if self.leaves_the_set(&motion) || self.drains(at + delay, &whole) {
                return None;
            }
            branches.push(FoundBranch { mode, way, fault_at: at, delay, motion, deviation });
            iterates.push(found.clone());
            self.last.insert(key, found);
        }
        branches.reverse();
        iterates.reverse();
        Some(Found { at, way: Some(way), branches, iterates })
    }
}

fn key(way: Way) -> usize {
    match way {
        Way::Continue | Way::ContinueSpinning => 0,
        Way::LandHere | Way::Caught => 1,
        Way::LandAt(site) => 2 + site,
    }
}
