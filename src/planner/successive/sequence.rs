//! Sequences of steps at one mission time: into the set, then down to the least cost there.

use super::*;

/// Proximity of steps that restore feasibility: they seek nearly the nearest motion that does.
pub(super) const RESTORING: f64 = 0.1;

/// Most steps to restore feasibility; over each [`PATIENCE`] of them the excess has to fall to this share of what it was.
const MOST_RESTORING: usize = 12;
const PATIENCE: usize = 2;
/// See [`Step::calming`].
pub(super) const CALMING: f64 = 1e-3;
const MOST_REJECTED: usize = 3;
const FALL: f64 = 0.4;

/// Below this excess rows at other instants take turns, and each step that adds them is worth its while.
const NEARLY: f64 = 1e-2;

/// Where even the lines leave this much excess, restoring is given up: what comes after takes many steps to nothing, or to
/// a motion at the edge of what flies (measured).
const HOPELESS: f64 = 1e-2;

/// Restoration is given up where the linear model predicts more excess than the first, and more than this share of what it
/// predicted two steps before (measured: such sequences took all their steps and failed).
const UNAVOIDABLE: f64 = 2e-4;
const STEADY: f64 = 0.9;

/// Proximity at which steps towards the least cost begin.
pub(super) const SETTLING: f64 = 0.03;

/// And at which they begin at most, where the last ones found the motion to bend much.
const MOST_SETTLING: f64 = 1e3;

/// And where they go on from a motion that was restored.
const MOST_RESTORED: f64 = 1.0;

/// Steps to another time.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shorter {
    /// By as much as the lines about the motion allow, at most by the first share of the time. Where they allow less than the
    /// second, they allow nothing.
    UpTo(f64, f64),
    /// By this share, even where the lines leave some excess: what bends may still be restored.
    By(f64),
}

/// Their weight of the excess; and, where the time is the lines' to choose and where it is not, their proximity and the weight of
/// the relative cost.
const HASTENED: f64 = 20.0;
const CHOOSING: (f64, f64) = (3.0, 0.01);
const HASTENING: (f64, f64) = (1.0, 0.05);

/// Weight of the excess against the relative cost, at first.
const PENALTY: f64 = 6.0;

/// Its growth where the cost tempts steps out of the set, and the most.
const DEARER: f64 = 5.0;
const MOST_PENALTY: f64 = 1e4;

/// A step that keeps less than this share of itself is not worth a try.
const LEAST_SHARE: f64 = 0.05;

/// What may be passed between the instants, in widths of the healthy set or shares of a limit; on a grid so much finer; by
/// what factor of it rows keep more free; and how often that is tried. Half of what counts as a violation, for the grid has
/// gaps as well.
const BETWEEN: f64 = 5e-5;
pub(super) const FINER: usize = 4;
const BENT: f64 = 1.5;
const MOST_BENDS: usize = 8;

/// How closely the least cost is sought.
#[derive(Debug, Clone, Copy)]
pub(super) struct Care {
    steps: usize,
    /// Relative gain that ends the sequence.
    small: f64,
}

/// Where any motion inside will do.
pub(super) const NOT_AT_ALL: Care = Care { steps: 0, small: 0.0 };
/// On the way to another time.
pub(super) const ROUGHLY: Care = Care { steps: 2, small: 0.03 };
/// Where the way to another time is hard.
pub(super) const CLOSER: Care = Care { steps: 6, small: 0.01 };
/// For a plan that is kept.
pub(super) const CLOSELY: Care = Care { steps: 12, small: 2e-3 };

/// Where a sequence of steps towards the least cost stands.
struct Descent {
    /// Steps that it may still take.
    left: usize,
    trust: Trust,
    weights: Weights,
}

impl Successive<'_, '_> {
    pub(super) fn durations_stand(&self) -> Durations {
        Durations { legs: vec![None; self.engine.mission.legs.len()], range: (0.0, 0.0), spans: Vec::new() }
    }

    /// A motion made to fit in a shorter time: the lines about the motion as it was tell how, for the motion merely flown
    /// faster can be far outside, where they say nothing.
    pub(super) fn hasten(&mut self, motion: &Motion, shorter: Shorter, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        let (range, objective, (proximity, smoothing), least) = match shorter {
            Shorter::UpTo(share, least) => ((-share, 0.0), Objective::Time, CHOOSING, least),
            Shorter::By(share) => ((-share, -share), Objective::Cost, HASTENING, 0.0),
        };
        let durations = Durations { legs: vec![Some(0); self.engine.mission.legs.len()], range, spans: Vec::new() };
        let weights = Weights { objective, penalty: HASTENED, smoothing, calming: 0.0 };
        let stepped = self.step(motion, &durations, Trust { proximity }, weights, pool)?;
        if stepped.changes[0] > -least {
            return None;
        }
        if stepped.sigma > HOPELESS {
            return None;
        }
        self.restore(motion.stepped(&stepped.states, &stepped.changes), pool)
    }

    /// Steps towards the least excess, until the motion is inside at every instant. `None` where it does not get there.
    pub(super) fn restore(&mut self, motion: Motion, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        self.restore_unless(motion, HOPELESS, pool)
    }

    /// The same, given up where the lines leave more excess than `hopeless`.
    pub(super) fn restore_unless(
        &mut self,
        mut motion: Motion,
        hopeless: f64,
        pool: &mut BTreeSet<RowAt>,
    ) -> Option<Motion> {
        let durations = self.durations_stand();
        let mut trust = Trust { proximity: RESTORING };
        let mut excess = self.excess_by(&motion, pool);
        // A motion that nearly fits has no need of other inputs.
        let calming = if excess < NEARLY { self.calming } else { 0.0 };
        let mut weights = Weights { objective: Objective::Excess, penalty: 1.0, smoothing: 0.0, calming };
        let mut history = Vec::new();
        let mut lines: Vec<f64> = Vec::new();
        let mut rejected = 0;
        self.forget_multipliers();
        while excess > 0.0 {
            history.push(excess);
            let stuck =
                excess > NEARLY && history.len() > PATIENCE && excess > FALL * history[history.len() - 1 - PATIENCE];
            if history.len() > MOST_RESTORING || stuck || trust.exhausted() {
                return None;
            }
            pool.extend(self.rows_between(&motion));
            let stepped = self.step(&motion, &durations, trust, weights, pool)?;
            lines.push(stepped.sigma);
            let is_stuck = matches!(lines[..], [.., before, _, last] if last > f64::max(UNAVOIDABLE, STEADY * before));
            if stepped.sigma > hopeless || is_stuck {
                if weights.calming == 0.0 {
                    return None;
                }
                // Where most inputs are small every change is a large share of them: other inputs after all, from now on.
                (self.calming, weights.calming) = (0.0, 0.0);
                lines.clear();
                history.clear();
                continue;
            }
            // If only a share of this step is taken, the next program still needs the rows that the full step violates.
            let whole = motion.with_states(stepped.states.clone());
            pool.extend(self.rows_violated_most(&whole));
            excess = self.excess_by(&motion, pool);
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = motion.with_states(motion.towards(&stepped.states, share));
                let now = self.excess_by(&reached, pool);
                if now <= excess - 0.2 * share * (excess - stepped.sigma) || share < 2.0 * LEAST_SHARE {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                trust = trust.less();
            }
            if now < excess {
                (motion, excess) = (reached, now);
            } else {
                // Too many rows were unknown to the program for any share of its step: it gets all of them.
                pool.extend(self.rows_at_nodes(&whole, 0.0));
                pool.extend(self.rows_between(&whole));
                history.pop();
                rejected += 1;
                if rejected > MOST_REJECTED {
                    return None;
                }
            }
        }
        // Steps of which only a share was taken, or none, leave gaps at waypoints where durations have changed.
        if !motion.is_joined() {
            let joined = self.joined(&motion, pool)?;
            return self.restore_unless(joined, hopeless, pool);
        }
        self.prune(&motion, pool);
        Some(motion)
    }

    /// Steps towards the least cost. Both the motion given and the one returned are inside at every instant; in between
    /// merit is the cost and a penalty on the excess.
    pub(super) fn settle(&mut self, motion: Motion, care: Care, pool: &mut BTreeSet<RowAt>) -> Motion {
        let weights = Weights { objective: Objective::Cost, penalty: PENALTY, smoothing: 1.0, calming: 0.0 };
        let mut descent = Descent { left: care.steps, trust: Trust { proximity: self.settling }, weights };
        let mut best = (self.cost(&motion), motion);
        loop {
            let outside = self.lower(&mut best, &mut descent, care.small, pool);
            self.settling = descent.trust.proximity.min(MOST_SETTLING);
            // Where the last motion is still outside, the nearest one inside may well be the best, or lead to it.
            let mut known = pool.clone();
            let Some(inside) = outside.and_then(|outside| self.restore(outside, &mut known)) else { return best.1 };
            let (cost, was) = (self.cost(&inside), best.0);
            if cost < was {
                *pool = known;
                best = (cost, inside);
            }
            if descent.left == 0 || cost > (1.0 - care.small) * was {
                return best.1;
            }
            descent.trust.proximity = descent.trust.proximity.min(MOST_RESTORED);
        }
    }

    /// The steps of [`Self::settle`] from `best`, which is inside, and keeps the cheapest motion inside that they meet. Also the
    /// motion that they end with, where that is outside and cheaper.
    fn lower(
        &mut self,
        best: &mut (f64, Motion),
        Descent { left, trust, weights }: &mut Descent,
        small: f64,
        pool: &mut BTreeSet<RowAt>,
    ) -> Option<Motion> {
        let durations = self.durations_stand();
        let (mut at, mut excess) = (best.1.clone(), 0.0);
        while *left > 0 {
            *left -= 1;
            let here = self.cost(&at);
            let Some(stepped) = self.step(&at, &durations, *trust, *weights, pool) else { break };
            // A sigma within the back-off is inside.
            let sigma = stepped.sigma - BACK_OFF;
            // Lines that leave an excess were tempted by the cost: asked again, with less temptation.
            if sigma > 0.0 && weights.penalty < MOST_PENALTY {
                weights.penalty *= DEARER;
                continue;
            }
            let penalty = weights.penalty;
            let merit = |cost: f64, excess: f64| cost / here + penalty * f64::max(excess, 0.0);
            let was = merit(here, excess);
            let towards = |s: &Self, pool: &BTreeSet<RowAt>, share: f64| {
                let reached = at.with_states(at.towards(&stepped.states, share));
                (s.cost(&reached), s.excess_by(&reached, pool), reached)
            };
            let expected = was - merit(self.cost(&at.with_states(stepped.states.clone())), sigma);
            if expected <= 0.0 && sigma <= 0.0 {
                break; // the lines themselves promise nothing
            }
            let mut share = 1.0;
            let (mut cost, mut now, mut reached) = towards(self, pool, share);
            while was - merit(cost, now) < 0.3 * share * expected && share > LEAST_SHARE {
                share *= 0.5;
                (cost, now, reached) = towards(self, pool, share);
            }
            let gained = was - merit(cost, now);
            if now <= 0.0 && cost < best.0 {
                *best = (cost, reached.clone());
            }
            pool.extend(self.rows_between(&reached));
            *trust = match share {
                1.0 if expected > 0.0 => trust.after(gained, expected),
                _ => trust.shared(share),
            };
            if gained > 0.0 {
                // Measured again, with the instants that the pool has now.
                at = reached;
                excess = self.excess_by(&at, pool);
            }
            if expected < small && sigma <= 0.0 || trust.exhausted() {
                break;
            }
        }
        (excess > 0.0 && self.cost(&at) < best.0).then_some(at)
    }

    /// Settles, and looks between the instants until no row is passed there by more than [`BETWEEN`]. `None` where that does
    /// not end. What rows keep free for it is this motion's own: other times and other grids have instants of theirs.
    pub(super) fn settle_between(&mut self, motion: Motion, care: Care, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        let kept = self.bend_until_inside(motion, care, pool);
        self.bends.clear();
        self.lag.iter_mut().for_each(|lag| lag.bends.fill(0.0));
        kept
    }

    /// Rows that are passed between the instants keep that much more free at the instants beside, and the motion is restored.
    fn bend_until_inside(&mut self, motion: Motion, care: Care, pool: &mut BTreeSet<RowAt>) -> Option<Motion> {
        let mut motion = self.settle(motion, care, pool);
        for _ in 0..MOST_BENDS {
            let over = self.between_instants(&motion);
            let leads_over = self.leads_between_instants(&motion);
            if over.is_empty() && leads_over.iter().all(|excess| *excess <= BETWEEN) {
                return Some(motion);
            }
            for (at, excess) in over {
                let Some(place) = self.place(at.row) else { continue };
                for instant in [at.instant, at.instant + 1] {
                    *self.bends.entry(instant).or_default().entry(place).or_default() += BENT * excess;
                    pool.insert(RowAt { instant, ..at });
                }
            }
            let lead_bends = self.lag.iter_mut().flat_map(|lag| &mut lag.bends);
            for (bend, excess) in lead_bends.zip(&leads_over) {
                *bend += BENT * excess.max(0.0);
            }
            motion = self.restore(motion, pool)?;
        }
        None
    }

    /// The rows passed by more than [`BETWEEN`] on a grid [`FINER`] times finer than the instants, each at the instant before
    /// with its largest excess until the next.
    fn between_instants(&self, motion: &Motion) -> Vec<(RowAt, f64)> {
        let form = self.transcription(&motion.profile, &[]);
        let mut over: BTreeMap<RowAt, f64> = BTreeMap::new();
        let parts = PARTS * FINER;
        for interval in 0..motion.profile.intervals() {
            for part in 0..parts {
                let state = motion.inside(interval, part as f64 / parts as f64);
                let instant = interval * PARTS + part / FINER;
                for (place, excess) in self.excesses(&form, &state).enumerate().filter(|(_, e)| *e > BETWEEN) {
                    let entry = over.entry(RowAt { row: self.row(place), instant }).or_default();
                    *entry = entry.max(excess);
                }
            }
        }
        // Places have no width to keep a share of free.
        let limits = &self.engine.mission.limits;
        over.retain(|at, _| !matches!(at.row, Row::Limit(limit) if place(limits[limit].kind)));
        over.into_iter().collect()
    }

    pub(super) fn cost(&self, motion: &Motion) -> f64 {
        self.transcription(&motion.profile, &[]).cost_of(&motion.states)
    }

    /// Drops the rows that a motion keeps well clear of.
    fn prune(&self, motion: &Motion, pool: &mut BTreeSet<RowAt>) {
        let form = self.transcription(&motion.profile, &[]);
        pool.retain(|r| {
            let state = motion.at(r.instant);
            let excess = match r.row {
                Row::Facet(facet) => self.excess_of_row(facet, &self.wrench_at(&state)),
                Row::Limit(limit) => form.excess_of(&self.engine.mission.limits[limit], &state, 0.0),
                Row::Upright => form.excess_upright(&state),
                Row::Lead { facet, slope } => self.lead_excess_of(motion, facet, (r.instant, slope)),
            };
            excess > -NEAR
        });
    }
}
