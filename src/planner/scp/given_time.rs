//! Plans at one mission time, and motions at shorter and shorter ones, each begun from the plan of least cost at the last.

use super::*;
use crate::model::{Leg, Mission};
use crate::motion::time_grid::{has_fixed_times, time_grid};
use crate::planner::hover::Decision;
use crate::planner::scp::phases::{CLOSELY, CLOSER, ROUGHLY, Shorter, StoppingRule, WITHOUT_COST_PHASE};
use crate::planner::scp::relaxation::Verdict;
use crate::planner::timing::kinematics;

/// Beyond this a mission is not searched, s.
const LONGEST: f64 = 100_000.0;

/// Relative precision of changes of time.
const PRECISION: f64 = 1e-4;

/// Relative steps towards shorter times: the first on the coarse and on the full grid, by how much one shrinks where no
/// plan is found, and the least.
pub(super) const COARSE_STEP: f64 = 0.1;
pub(super) const FINE_STEP: f64 = 0.04;
const SHRINK: f64 = 0.3;
const GROW: f64 = 1.5;
pub(super) const LEAST_COARSE: f64 = 0.02;
pub(super) const LEAST_FINE: f64 = 0.0025;

/// Where lines allow less than this share of the least step, it is not worth its while.
const WORTH: f64 = 0.8;

/// Times are as good as equal within this share.
const ROUNDING: f64 = 1e-12;

/// Where an iterate found elsewhere cannot be restored at its own time, it is flown slower by these factors.
const SLOWER: [f64; 10] = [1.0, 1.01, 1.03, 1.06, 1.1, 1.15, 1.25, 1.4, 1.7, 2.5];

/// What is said where no plan is found and none is shown impossible.
pub const NOT_FOUND: &str = "no plan found";

impl ScpPlanner<'_, '_> {
    /// The mission's profile with legs that take `shares` of the time, or their own.
    pub(super) fn lay_out(&self, shares: Option<&[f64]>, total: f64, samples: usize) -> Option<TimeGrid> {
        match shares {
            None => time_grid(self.hover.mission, total, samples),
            Some(shares) => {
                let legs = shares.iter().map(|&share| Leg { share }).collect();
                time_grid(&Mission { legs, ..self.hover.mission.clone() }, total, samples)
            }
        }
    }

    /// The profile that a search at one mission time begins with: the spec's, or where durations are the planner's each leg
    /// with the share that its own limits ask for.
    fn begun(&self, total: f64, samples: usize) -> Option<TimeGrid> {
        let initial = self.chooses_times().then(|| kinematics::initial(self.hover.model, self.hover.mission));
        self.lay_out(initial.as_deref(), total, samples)
    }

    pub(super) fn held(&self) -> f64 {
        self.hover.mission.waypoints.iter().map(|w| w.hold).sum()
    }

    /// The iterate's path in its own shares of time, about as fast as stays inside at the nodes. `None` where no slowing
    /// down helps.
    pub(super) fn timed(&self, iterate: &Iterate) -> Option<Iterate> {
        let form = self.transcription(&iterate.grid, &[]);
        let inside = |factor: f64| {
            let slow = iterate.slower(factor);
            let commands_inside = |node: usize| self.lead_excess_at(&slow, node * PARTS) <= 0.0;
            slow.states.iter().enumerate().all(|(node, s)| self.violation_at(&form, s, node * PARTS) <= 0.0)
                && (0..slow.states.len()).all(commands_inside)
        };
        let (mut low, mut high) = (0.0, 1.0);
        while !inside(high) {
            (low, high) = (high, 1.5 * high);
            if high * iterate.grid.total > LONGEST {
                return None;
            }
        }
        while low == 0.0 || high - low > PRECISION * high {
            let middle = if low == 0.0 { 0.7 * high } else { 0.5 * (low + high) };
            match inside(middle) {
                true => high = middle,
                false => low = middle,
            }
            if high < 1e-3 {
                break;
            }
        }
        Some(iterate.slower(high))
    }

    /// The iterate at the first of [`SLOWER`] times at which it can be restored.
    pub(super) fn restore_feasibility_slower(
        &mut self,
        iterate: &Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        SLOWER.into_iter().find_map(|factor| self.restore_feasibility_at(iterate, factor, working_set))
    }

    /// The iterate `factor` times slower, made to fit.
    fn restore_feasibility_at(
        &mut self,
        iterate: &Iterate,
        factor: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let mut known = working_set.clone();
        let restored = self.restore_feasibility(iterate.slower(factor), &mut known)?;
        *working_set = known;
        Some(self.minimise_cost(restored, ROUGHLY, working_set))
    }

    /// Shorter and shorter times down to `target` s of flight, each from the plan of least cost at the last: smooth motions
    /// stay clear of the attitudes at which the wrench bends most. First as much shorter as the linear model allows, then by small
    /// steps whether or not they do.
    pub(super) fn descend(
        &mut self,
        mut iterate: Iterate,
        (first, least): (f64, f64),
        target: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let mut step = first;
        let mut minimised = false;
        while step >= least && iterate.grid.total > (1.0 + ROUNDING) * target {
            let last = 1.0 - target / iterate.grid.total;
            let shorter = match last <= step {
                true => Shorter::By(last),
                false if minimised => Shorter::By(step),
                false => Shorter::UpTo(step, WORTH * least),
            };
            self.hover.progress((1.0 - step.min(last)) * iterate.grid.total + self.held());
            let mut known = working_set.clone();
            match self.shorten_alike(&iterate, shorter, &mut known) {
                Some(inside) => {
                    *working_set = known;
                    iterate = self.minimise_cost(inside, ROUGHLY, working_set);
                    step = (GROW * step).min(first);
                }
                None => {
                    step *= SHRINK;
                    // The nearer to the least cost, the further an iterate can be shortened, and the wrench may bend to where the
                    // lines do not reach: tried once.
                    if step < least && !minimised {
                        iterate = self.minimise_cost(iterate, CLOSER, working_set);
                        minimised = true;
                        step = least.max(SHRINK * SHRINK * first);
                    }
                }
            }
        }
        iterate
    }

    /// A plan of the mission as an iterate to begin from.
    pub(super) fn motion_of(&self, planned: &Planned) -> Iterate {
        let grid = planned.grid.flown();
        Iterate { states: planned.grid.without_holds(&planned.states), grid, model: self.wrench }
    }

    /// An iterate inside the set made from other plans, the first that will do flown least slower.
    pub(super) fn slowed(
        &mut self,
        initial_guesses: &[&Planned],
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        self.hover.effort.starts += initial_guesses.len();
        let iterates: Vec<Iterate> = initial_guesses.iter().map(|planned| self.motion_of(planned)).collect();
        SLOWER.into_iter().find_map(|factor| {
            iterates.iter().find_map(|iterate| self.restore_feasibility_at(iterate, factor, working_set))
        })
    }

    /// Whether no division of a mission time among the legs has a plan. Where the division is laid down the relaxation shows
    /// more.
    fn is_too_short(&self, total: f64) -> bool {
        let (model, mission) = (self.hover.model, self.hover.mission);
        self.chooses_times() && kinematics::least_time_within(model, mission).is_above(total)
    }

    /// The divisions of a mission time that are tried as they are: the one that [`Self::begun`] gives and, where durations are the
    /// planner's, the one by lengths. None where some leg has no time.
    fn divisions(&self, total: f64) -> Vec<TimeGrid> {
        let samples = self.hover.model.plan.samples;
        let by_length = self.chooses_times().then(|| self.lay_out(None, total, samples)).flatten();
        self.begun(total, samples).into_iter().chain(by_length).collect()
    }

    /// The first plan found on these time grids. The plans in `begins` are initial guesses on the first grid only.
    fn at_one_of(&mut self, divisions: &[TimeGrid], initial_guesses: &[&Planned]) -> Option<Planned> {
        divisions.iter().enumerate().find_map(|(nth, full)| {
            self.hover.progress(full.total);
            self.at_once(full, if nth == 0 { initial_guesses } else { &[] })
        })
    }

    /// A plan on one of the divisions of a mission time, without any other initial guess.
    pub(super) fn soon_decided(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        let divisions = self.divisions(total);
        self.at_one_of(&divisions, initial_guesses)
    }

    /// A plan at one mission time, begun from other plans where there are some, the first that will do.
    pub fn decide(&mut self, total: f64, initial_guesses: &[&Planned]) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let divisions = self.divisions(total);
        let Some(full) = divisions.first() else { return Decision::Infeasible };
        if let Some(planned) = self.at_one_of(&divisions, initial_guesses) {
            return Decision::Feasible(Box::new(planned));
        }
        // What is shown of one division of the time is not shown of all. A proof is cheaper than a plan from further away, and
        // where there is none the relaxation's own motion, which keeps every limit, may be made to fit.
        match self.relaxed(&full.flown()) {
            Verdict::Infeasible if !self.chooses_times() => return Decision::Infeasible,
            Verdict::Feasible(Some(iterate)) => {
                if let Some(planned) = self.about_relaxed(iterate, total) {
                    return Decision::Feasible(Box::new(planned));
                }
            }
            _ => {}
        }
        let further_away = match self.divides_spans() {
            true => self.divided_anew(total, &divisions),
            false => self.begun_further_away(total, initial_guesses),
        };
        match further_away {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// A quick decision at a mission time, for callers that need dozens. A proof by the relaxation is returned as it is; otherwise
    /// the feasibility phase runs with two initial guesses, the relaxation's solution, which keeps every limit, and the
    /// minimum-snap motion. If `minimised`, or with the second guess, a short cost phase follows.
    pub fn attempt(&mut self, total: f64, minimised: bool) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let samples = self.hover.model.plan.samples;
        let Some(full) = self.begun(total, samples) else { return Decision::Infeasible };
        self.hover.progress(total);
        let flown = full.flown();
        let relaxed = match self.relaxed(&flown) {
            // What is shown of one division of the time is not shown of all.
            Verdict::Infeasible if self.chooses_times() => return Decision::Inconclusive(NOT_FOUND.into()),
            Verdict::Infeasible => return Decision::Infeasible,
            Verdict::Feasible(iterate) => iterate,
        };
        let quickly = if minimised { ROUGHLY } else { WITHOUT_COST_PHASE };
        let planned = relaxed
            .and_then(|iterate| self.kept_near(iterate, total, quickly, &mut BTreeSet::new()))
            .or_else(|| self.smooth(&flown).and_then(|m| self.kept_near(m, total, ROUGHLY, &mut BTreeSet::new())));
        match planned {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// A plan over a profile about the smooth motion there, or about another plan flown in the same time: the first that is
    /// found, or one about a cheaper plan that is inside as it is, so that plans of smaller sets are seldom cheaper.
    pub(super) fn at_once(&mut self, full: &TimeGrid, initial_guesses: &[&Planned]) -> Option<Planned> {
        let flown = full.total - self.held();
        let fixed = has_fixed_times(self.hover.mission);
        let mut working_set = BTreeSet::new();
        let smooth = self.smooth(&full.flown());
        let mut found = smooth.and_then(|iterate| self.kept_near(iterate, full.total, CLOSELY, &mut working_set));
        // Where waypoints have times of their own another plan serves only if it has the same: the mission's time, where the legs
        // divide the rest as they like.
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * full.total;
        let divides = self.chooses_times();
        let as_long = |other: &Iterate| {
            let pairs = other.grid.segments.iter().zip(full.segments.iter().filter(|s| !s.hold));
            match divides {
                true => same(other.grid.total, flown),
                false => pairs.into_iter().all(|(a, b)| same(a.duration, b.duration)),
            }
        };
        for planned in initial_guesses {
            let other = self.motion_of(planned);
            if fixed && !as_long(&other) {
                continue;
            }
            let scaled = if fixed { other } else { other.slower(flown / other.grid.total) };
            let worth = |found: &Planned| self.cost(&scaled) < found.objective && self.violation(&scaled) <= 0.0;
            if found.as_ref().is_none_or(worth) {
                let kept = self.kept_near(scaled, full.total, CLOSELY, &mut working_set);
                found = kept.into_iter().chain(found).min_by(|a, b| a.objective.total_cmp(&b.objective));
            }
        }
        found
    }

    /// A plan at one mission time about motions that fit at another: other plans flown slower, or one made from nothing.
    /// Where waypoints have times of their own no motion can be flown slower as a whole.
    fn begun_further_away(&mut self, total: f64, initial_guesses: &[&Planned]) -> Option<Planned> {
        if has_fixed_times(self.hover.mission) {
            return None;
        }
        let slowed = self.slowed(initial_guesses, &mut BTreeSet::new());
        let from_plans = slowed.and_then(|first| self.brought_to(first, total));
        from_plans.or_else(|| self.first(total - self.held()).and_then(|first| self.brought_to(first, total)))
    }

    /// The plan of least cost at a mission time, from an iterate inside the set at another: with all legs changed alike, and if
    /// that fails and durations are the planner's, with each leg shortened by itself.
    fn brought_to(&mut self, first: Iterate, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let alike = self.brought_alike(first.clone(), total);
        if alike.is_some() || !self.chooses_times() || first.grid.total <= flown {
            return alike;
        }
        let shorter = self.optimise_durations(first, &durations::FULL_GRID, flown, &mut BTreeSet::new());
        self.brought_alike(shorter, total)
    }

    /// The same with the legs' shares of time as they are.
    fn brought_alike(&mut self, first: Iterate, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let mut working_set = BTreeSet::new();
        let iterate = match first.grid.total <= flown {
            true => self.restore_feasibility(first.slower(flown / first.grid.total), &mut working_set)?,
            false => self.descend(first, (FINE_STEP, LEAST_FINE), flown, &mut working_set),
        };
        let there = (iterate.grid.total - flown).abs() <= 1e-9 * flown;
        there.then(|| self.kept(iterate, total, CLOSELY, &mut working_set)).flatten()
    }

    /// A plan about the relaxation's motion: of least cost, or as it is where no cheaper one stays inside between instants.
    fn about_relaxed(&mut self, iterate: Iterate, total: f64) -> Option<Planned> {
        let mut working_set = BTreeSet::new();
        let inside = self.restore_feasibility(iterate, &mut working_set)?;
        [CLOSELY, WITHOUT_COST_PHASE]
            .into_iter()
            .find_map(|care| self.kept(inside.clone(), total, care, &mut working_set.clone()))
    }

    /// An iterate made to fit, and the plan of least cost about it.
    pub(super) fn kept_near(
        &mut self,
        iterate: Iterate,
        total: f64,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Planned> {
        let inside = self.restore_feasibility(iterate, working_set)?;
        self.kept(inside, total, care, working_set)
    }

    /// The plan of least cost about an iterate inside the set, with holds.
    fn kept(
        &mut self,
        iterate: Iterate,
        total: f64,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Planned> {
        let mut minimised = self.minimise_cost_between_instants(iterate, care, working_set)?;
        // Interpolation at other nodes leaves rounding errors where the iterate rests.
        for (node, axis, order) in self.transcription(&minimised.grid, &[]).at_rest() {
            minimised.states[node][axis][order] = 0.0;
        }
        let legs: Vec<LegGrid> = minimised.grid.segments.iter().map(Segment::leg_grid).collect();
        let grid = TimeGrid::with_legs(self.hover.mission, &legs, total);
        Some(Planned {
            states: grid.with_holds(&minimised.states),
            grid,
            model: self.wrench,
            objective: self.cost(&minimised),
            rows: working_set.len(),
        })
    }
}
