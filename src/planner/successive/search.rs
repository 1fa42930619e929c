//! Plans at one mission time, and motions at shorter and shorter ones, each begun from the plan of least cost at the last.

use super::super::kinematics;
use super::super::rows::Decision;
use super::relaxation::Verdict;
use super::sequence::{CLOSELY, CLOSER, Care, NOT_AT_ALL, ROUGHLY, Shorter};
use super::*;
use crate::model::{Leg, Mission};
use crate::motion::time_grid::{has_fixed_times, profile};

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

/// Where a motion found elsewhere cannot be restored at its own time, it is flown slower by these factors.
const SLOWER: [f64; 10] = [1.0, 1.01, 1.03, 1.06, 1.1, 1.15, 1.25, 1.4, 1.7, 2.5];

/// What is said where no plan is found and none is shown impossible.
pub const NOT_FOUND: &str = "no plan found";

impl Successive<'_, '_> {
    /// The mission's profile with legs that take `shares` of the time, or their own.
    pub(super) fn lay_out(&self, shares: Option<&[f64]>, total: f64, samples: usize) -> Option<Profile> {
        match shares {
            None => profile(self.engine.mission, total, samples),
            Some(shares) => {
                let legs = shares.iter().map(|&share| Leg { share }).collect();
                profile(&Mission { legs, ..self.engine.mission.clone() }, total, samples)
            }
        }
    }

    /// The profile that a search at one mission time begins with: the spec's, or where durations are the planner's each leg
    /// with the share that its own limits ask for.
    fn begun(&self, total: f64, samples: usize) -> Option<Profile> {
        let initial = self.chooses_times().then(|| kinematics::initial(self.engine.model, self.engine.mission));
        self.lay_out(initial.as_deref(), total, samples)
    }

    pub(super) fn held(&self) -> f64 {
        self.engine.mission.waypoints.iter().map(|w| w.hold).sum()
    }

    /// The motion's path in its own shares of time, about as fast as stays inside at the nodes. `None` where no slowing
    /// down helps.
    pub(super) fn timed(&self, motion: &Motion) -> Option<Motion> {
        let form = self.transcription(&motion.profile, &[]);
        let inside = |factor: f64| {
            let slow = motion.slower(factor);
            let leads_inside = |node: usize| self.lead_excess_at(&slow, node * PARTS) <= 0.0;
            slow.states.iter().enumerate().all(|(node, s)| self.excess_at(&form, s, node * PARTS) <= 0.0)
                && (0..slow.states.len()).all(leads_inside)
        };
        let (mut low, mut high) = (0.0, 1.0);
        while !inside(high) {
            (low, high) = (high, 1.5 * high);
            if high * motion.profile.total > LONGEST {
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
        Some(motion.slower(high))
    }

    /// The motion at the first of [`SLOWER`] times at which it can be restored.
    pub(super) fn restore_slower(&mut self, motion: &Motion, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        SLOWER.into_iter().find_map(|factor| self.restore_at(motion, factor, pool))
    }

    /// The motion `factor` times slower, made to fit.
    fn restore_at(&mut self, motion: &Motion, factor: f64, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        let mut known = pool.clone();
        let restored = self.restore(motion.slower(factor), &mut known)?;
        *pool = known;
        Some(self.settle(restored, ROUGHLY, pool))
    }

    /// Shorter and shorter times down to `target` s of flight, each from the plan of least cost at the last: smooth motions
    /// stay clear of the attitudes at which the wrench bends most. First as much shorter as the lines allow, then by small
    /// steps whether or not they do.
    pub(super) fn descend(
        &mut self,
        mut motion: Motion,
        (first, least): (f64, f64),
        target: f64,
        pool: &mut BTreeSet<RowAt>,
    ) -> Motion {
        let mut step = first;
        let mut settled = false;
        while step >= least && motion.profile.total > (1.0 + ROUNDING) * target {
            let last = 1.0 - target / motion.profile.total;
            let shorter = match last <= step {
                true => Shorter::By(last),
                false if settled => Shorter::By(step),
                false => Shorter::UpTo(step, WORTH * least),
            };
            self.engine.progress((1.0 - step.min(last)) * motion.profile.total + self.held());
            let mut known = pool.clone();
            match self.hasten(&motion, shorter, &mut known) {
                Some(inside) => {
                    *pool = known;
                    motion = self.settle(inside, ROUGHLY, pool);
                    step = (GROW * step).min(first);
                }
                None => {
                    step *= SHRINK;
                    // The nearer to the least cost, the further a motion can be hastened, and the wrench may bend to where the
                    // lines do not reach: tried once.
                    if step < least && !settled {
                        motion = self.settle(motion, CLOSER, pool);
                        settled = true;
                        step = least.max(SHRINK * SHRINK * first);
                    }
                }
            }
        }
        motion
    }

    /// A plan of the mission as a motion to begin from.
    pub(super) fn motion_of(&self, planned: &Planned) -> Motion {
        let profile = planned.profile.flown();
        Motion { states: planned.profile.without_holds(&planned.states), profile, model: self.wrench }
    }

    /// A motion inside the set made from other plans, the first that will do flown least slower.
    pub(super) fn slowed(&mut self, begins: &[&Planned], pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        self.engine.effort.starts += begins.len();
        let motions: Vec<Motion> = begins.iter().map(|planned| self.motion_of(planned)).collect();
        SLOWER.into_iter().find_map(|factor| motions.iter().find_map(|motion| self.restore_at(motion, factor, pool)))
    }

    /// Whether no division of a mission time among the legs has a plan. Where the division is laid down the relaxation shows
    /// more.
    fn is_too_short(&self, total: f64) -> bool {
        let (model, mission) = (self.engine.model, self.engine.mission);
        self.chooses_times() && kinematics::least_time_within(model, mission).is_above(total)
    }

    /// The divisions of a mission time that are tried as they are: the one that [`Self::begun`] gives and, where durations are the
    /// planner's, the one by lengths. None where some leg has no time.
    fn divisions(&self, total: f64) -> Vec<Profile> {
        let samples = self.engine.model.plan.samples;
        let by_length = self.chooses_times().then(|| self.lay_out(None, total, samples)).flatten();
        self.begun(total, samples).into_iter().chain(by_length).collect()
    }

    /// The first plan found on these time grids. The plans in `begins` are initial guesses on the first grid only.
    fn at_one_of(&mut self, divisions: &[Profile], begins: &[&Planned]) -> Option<Planned> {
        divisions.iter().enumerate().find_map(|(nth, full)| {
            self.engine.progress(full.total);
            self.at_once(full, if nth == 0 { begins } else { &[] })
        })
    }

    /// A plan on one of the divisions of a mission time, without any other initial guess.
    pub(super) fn soon_decided(&mut self, total: f64, begins: &[&Planned]) -> Option<Planned> {
        let divisions = self.divisions(total);
        self.at_one_of(&divisions, begins)
    }

    /// A plan at one mission time, begun from other plans where there are some, the first that will do.
    pub fn decide(&mut self, total: f64, begins: &[&Planned]) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let divisions = self.divisions(total);
        let Some(full) = divisions.first() else { return Decision::Infeasible };
        if let Some(planned) = self.at_one_of(&divisions, begins) {
            return Decision::Feasible(Box::new(planned));
        }
        // What is shown of one division of the time is not shown of all. A proof is cheaper than a plan from further away, and
        // where there is none the relaxation's own motion, which keeps every limit, may be made to fit.
        match self.relaxed(&full.flown()) {
            Verdict::Infeasible if !self.chooses_times() => return Decision::Infeasible,
            Verdict::Feasible(Some(motion)) => {
                if let Some(planned) = self.about_relaxed(motion, total) {
                    return Decision::Feasible(Box::new(planned));
                }
            }
            _ => {}
        }
        let further_away = match self.divides_spans() {
            true => self.divided_anew(total, &divisions),
            false => self.begun_further_away(total, begins),
        };
        match further_away {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// Whether there is a plan at a mission time, for questions that are asked by the dozen: what the relaxation proves, else
    /// a motion made to fit, begun from the relaxation's own, which keeps every limit, and then from the smooth one. It is
    /// made (roughly) the cheapest where it is to be `settled`, or where it does not fit otherwise.
    pub fn attempt(&mut self, total: f64, settled: bool) -> Decision {
        if self.is_too_short(total) {
            return Decision::Infeasible;
        }
        let samples = self.engine.model.plan.samples;
        let Some(full) = self.begun(total, samples) else { return Decision::Infeasible };
        self.engine.progress(total);
        let flown = full.flown();
        let relaxed = match self.relaxed(&flown) {
            // What is shown of one division of the time is not shown of all.
            Verdict::Infeasible if self.chooses_times() => return Decision::Inconclusive(NOT_FOUND.into()),
            Verdict::Infeasible => return Decision::Infeasible,
            Verdict::Feasible(motion) => motion,
        };
        let quickly = if settled { ROUGHLY } else { NOT_AT_ALL };
        let planned = relaxed
            .and_then(|motion| self.kept_near(motion, total, quickly, &mut BTreeSet::new()))
            .or_else(|| self.smooth(&flown).and_then(|m| self.kept_near(m, total, ROUGHLY, &mut BTreeSet::new())));
        match planned {
            Some(planned) => Decision::Feasible(Box::new(planned)),
            None => Decision::Inconclusive(NOT_FOUND.into()),
        }
    }

    /// A plan over a profile about the smooth motion there, or about another plan flown in the same time: the first that is
    /// found, or one about a cheaper plan that is inside as it is, so that plans of smaller sets are seldom cheaper.
    pub(super) fn at_once(&mut self, full: &Profile, begins: &[&Planned]) -> Option<Planned> {
        let flown = full.total - self.held();
        let fixed = has_fixed_times(self.engine.mission);
        let mut pool = BTreeSet::new();
        let smooth = self.smooth(&full.flown());
        let mut found = smooth.and_then(|motion| self.kept_near(motion, full.total, CLOSELY, &mut pool));
        // Where waypoints have times of their own another plan serves only if it has the same: the mission's time, where the legs
        // divide the rest as they like.
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * full.total;
        let divides = self.chooses_times();
        let as_long = |other: &Motion| {
            let pairs = other.profile.segments.iter().zip(full.segments.iter().filter(|s| !s.hold));
            match divides {
                true => same(other.profile.total, flown),
                false => pairs.into_iter().all(|(a, b)| same(a.duration, b.duration)),
            }
        };
        for planned in begins {
            let other = self.motion_of(planned);
            if fixed && !as_long(&other) {
                continue;
            }
            let scaled = if fixed { other } else { other.slower(flown / other.profile.total) };
            let worth = |found: &Planned| self.cost(&scaled) < found.objective && self.excess(&scaled) <= 0.0;
            if found.as_ref().is_none_or(worth) {
                let kept = self.kept_near(scaled, full.total, CLOSELY, &mut pool);
                found = kept.into_iter().chain(found).min_by(|a, b| a.objective.total_cmp(&b.objective));
            }
        }
        found
    }

    /// A plan at one mission time about motions that fit at another: other plans flown slower, or one made from nothing.
    /// Where waypoints have times of their own no motion can be flown slower as a whole.
    fn begun_further_away(&mut self, total: f64, begins: &[&Planned]) -> Option<Planned> {
        if has_fixed_times(self.engine.mission) {
            return None;
        }
        let slowed = self.slowed(begins, &mut BTreeSet::new());
        let from_plans = slowed.and_then(|first| self.brought_to(first, total));
        from_plans.or_else(|| self.first(total - self.held()).and_then(|first| self.brought_to(first, total)))
    }

    /// The plan of least cost at a mission time, from a motion inside the set at another: with all legs changed alike, and if
    /// that fails and durations are the planner's, with each leg shortened by itself.
    fn brought_to(&mut self, first: Motion, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let alike = self.brought_alike(first.clone(), total);
        if alike.is_some() || !self.chooses_times() || first.profile.total <= flown {
            return alike;
        }
        let shorter = self.better_times(first, &times::FULL_GRID, flown, &mut BTreeSet::new());
        self.brought_alike(shorter, total)
    }

    /// The same with the legs' shares of time as they are.
    fn brought_alike(&mut self, first: Motion, total: f64) -> Option<Planned> {
        let flown = total - self.held();
        let mut pool = BTreeSet::new();
        let motion = match first.profile.total <= flown {
            true => self.restore(first.slower(flown / first.profile.total), &mut pool)?,
            false => self.descend(first, (FINE_STEP, LEAST_FINE), flown, &mut pool),
        };
        let there = (motion.profile.total - flown).abs() <= 1e-9 * flown;
        there.then(|| self.kept(motion, total, CLOSELY, &mut pool)).flatten()
    }

    /// A plan about the relaxation's motion: of least cost, or as it is where no cheaper one stays inside between instants.
    fn about_relaxed(&mut self, motion: Motion, total: f64) -> Option<Planned> {
        let mut pool = BTreeSet::new();
        let inside = self.restore(motion, &mut pool)?;
        [CLOSELY, NOT_AT_ALL].into_iter().find_map(|care| self.kept(inside.clone(), total, care, &mut pool.clone()))
    }

    /// A motion made to fit, and the plan of least cost about it.
    pub(super) fn kept_near(
        &mut self,
        motion: Motion,
        total: f64,
        care: Care,
        pool: &mut BTreeSet<RowAt>,
    ) -> Option<Planned> {
        let inside = self.restore(motion, pool)?;
        self.kept(inside, total, care, pool)
    }

    /// The plan of least cost about a motion inside the set, with holds.
    fn kept(&mut self, motion: Motion, total: f64, care: Care, pool: &mut BTreeSet<RowAt>) -> Option<Planned> {
        let mut settled = self.settle_between(motion, care, pool)?;
        // Interpolation at other nodes leaves rounding errors where the motion rests.
        for (node, axis, order) in self.transcription(&settled.profile, &[]).at_rest() {
            settled.states[node][axis][order] = 0.0;
        }
        let legs: Vec<LegGrid> = settled.profile.segments.iter().map(Segment::grid).collect();
        let profile = Profile::with_legs(self.engine.mission, &legs, total);
        Some(Planned {
            states: profile.with_holds(&settled.states),
            profile,
            model: self.wrench,
            objective: self.cost(&settled),
            rows: pool.len(),
        })
    }
}
