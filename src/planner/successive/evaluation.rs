//! How far a motion passes facets and limits, and which rows the next step needs for it.

use super::*;
use crate::model::LimitKind;

impl<'e, 'a> Successive<'e, 'a> {
    pub(super) fn wrench_at(&self, state: &NodeState) -> Wrench {
        self.wrench.wrench(&self.engine.model.vehicle, self.engine.model.gravity, state)
    }

    /// How far a row is passed; a flat set's plane is kept to within [`BACK_OFF`] on both sides.
    pub(super) fn excess_of_row(&self, facet: usize, wrench: &Wrench) -> f64 {
        let row = &self.set.rows[facet];
        let excess = if row.equality { row.excess(wrench) - BACK_OFF } else { row.excess(wrench) };
        // A wrench that is not finite is outside of everything.
        if excess.is_nan() { f64::INFINITY } else { excess }
    }

    /// The excess of every facet and then of every limit for one state.
    pub(super) fn excesses<'s>(
        &'s self,
        form: &'s Transcription<'s>,
        state: &'s NodeState,
    ) -> impl Iterator<Item = f64> + 's {
        let wrench = self.wrench_at(state);
        let facets = (0..self.set.rows.len()).map(move |facet| self.excess_of_row(facet, &wrench));
        // Places have no width to keep a share of free.
        let limits = self
            .engine
            .mission
            .limits
            .iter()
            .map(move |l| form.excess_of(l, state, 0.0) - if place(l.kind) { ACCEPTED } else { 0.0 });
        let exact = self.wrench == WrenchModel::Exact;
        facets.chain(limits).chain(exact.then(|| form.excess_upright(state)))
    }

    /// The same at an instant, each with its place and with what it keeps free between instants.
    pub(super) fn excesses_at<'s>(
        &'s self,
        form: &'s Transcription<'s>,
        state: &'s NodeState,
        instant: usize,
    ) -> impl Iterator<Item = (usize, f64)> + 's {
        let bends = self.bends.get(&instant);
        let bend = move |place: usize| bends.and_then(|b| b.get(&place)).copied().unwrap_or(0.0);
        self.excesses(form, state).enumerate().map(move |(place, excess)| (place, excess + bend(place)))
    }

    /// The largest excess of facets and limits at an instant.
    pub(super) fn excess_at(&self, form: &Transcription, state: &NodeState, instant: usize) -> f64 {
        self.excesses_at(form, state, instant).map(|e| e.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest excess over all instants.
    pub(super) fn excess(&self, motion: &Motion) -> f64 {
        let form = self.transcription(&motion.profile, &[]);
        let at = |i: usize| self.excess_at(&form, &motion.at(i), i).max(self.lead_excess_at(motion, i));
        (0..form.instants()).map(at).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest excess at the nodes and at the instants of `pool`, and where that is none, over all instants.
    pub(super) fn excess_by(&self, motion: &Motion, pool: &BTreeSet<RowAt>) -> f64 {
        let form = self.transcription(&motion.profile, &[]);
        let between: BTreeSet<usize> = pool.iter().map(|r| r.instant).filter(|i| i % PARTS != 0).collect();
        let known = (0..form.instants()).step_by(PARTS).chain(between);
        let at = |i: usize| self.excess_at(&form, &motion.at(i), i).max(self.lead_excess_at(motion, i));
        let excess = known.map(at).fold(f64::NEG_INFINITY, f64::max);
        if excess > 0.0 { excess } else { self.excess(motion) }
    }

    /// Place among the facets and limits of [`Self::excesses`].
    pub(super) fn row(&self, place: usize) -> Row {
        let (facets, limits) = (self.set.rows.len(), self.engine.mission.limits.len());
        match place {
            p if p < facets => Row::Facet(p),
            p if p < facets + limits => Row::Limit(p - facets),
            _ => Row::Upright,
        }
    }

    /// The inverse of [`Self::row`]; rows on the lead wrench have no place there.
    pub(super) fn place(&self, row: Row) -> Option<usize> {
        match row {
            Row::Facet(facet) => Some(facet),
            Row::Limit(limit) => Some(self.set.rows.len() + limit),
            Row::Upright => Some(self.set.rows.len() + self.engine.mission.limits.len()),
            Row::Lead { .. } => None,
        }
    }

    /// What a row keeps free between instants.
    pub(super) fn bend(&self, RowAt { row, instant }: &RowAt) -> f64 {
        let bends = self.bends.get(instant);
        bends.zip(self.place(*row)).and_then(|(bends, place)| bends.get(&place)).copied().unwrap_or(0.0)
    }

    /// Rows with an excess over `threshold` at nodes. Equality rows always stand.
    pub(super) fn rows_at_nodes(&self, motion: &Motion, threshold: f64) -> BTreeSet<RowAt> {
        let form = self.transcription(&motion.profile, &[]);
        let mut found = BTreeSet::new();
        for (node, state) in motion.states.iter().enumerate() {
            let instant = node * PARTS;
            let over = self.excesses_at(&form, state, instant).filter(|(_, e)| *e > threshold);
            found.extend(over.map(|(i, _)| RowAt { row: self.row(i), instant }));
            found.extend(self.lead_rows_at_node(motion, node, threshold));
        }
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// Between nodes each row that is passed, where it is passed most in an interval. (With only the worst facet of each
    /// interval programs are smaller, but fewer motions are restored: shortest times came out up to a fifth longer.)
    pub(super) fn rows_between(&self, motion: &Motion) -> BTreeSet<RowAt> {
        let form = self.transcription(&motion.profile, &[]);
        let mut found = BTreeSet::new();
        for interval in 0..motion.profile.intervals() {
            let mut worst: BTreeMap<usize, (f64, usize)> = BTreeMap::new();
            for instant in interval * PARTS + 1..(interval + 1) * PARTS {
                let state = motion.at(instant);
                for (i, excess) in self.excesses_at(&form, &state, instant).filter(|(_, e)| *e > 0.0) {
                    let entry = worst.entry(i).or_insert((excess, instant));
                    if excess > entry.0 {
                        *entry = (excess, instant);
                    }
                }
            }
            found.extend(worst.into_iter().map(|(i, (_, instant))| RowAt { row: self.row(i), instant }));
            found.extend(self.lead_rows_between(motion, interval));
        }
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// Each row that a motion violates, on each leg at the instant of its largest violation.
    pub(super) fn rows_violated_most(&self, motion: &Motion) -> BTreeSet<RowAt> {
        let form = self.transcription(&motion.profile, &[]);
        let mut worst: BTreeMap<(usize, usize), (f64, usize)> = BTreeMap::new();
        for instant in 0..form.instants() {
            let leg = form.leg_of(instant);
            for (place, excess) in self.excesses_at(&form, &motion.at(instant), instant).filter(|(_, e)| *e > 0.0) {
                let entry = worst.entry((place, leg)).or_insert((excess, instant));
                if excess > entry.0 {
                    *entry = (excess, instant);
                }
            }
        }
        let mut found: BTreeSet<RowAt> =
            worst.into_iter().map(|((place, _), (_, instant))| RowAt { row: self.row(place), instant }).collect();
        found.retain(|r| !matches!(r.row, Row::Facet(f) if self.set.rows[f].equality));
        found
    }

    /// The rows of some limits at every node.
    pub(super) fn limits_at_nodes(
        &self,
        profile: &Profile,
        wanted: impl Fn(&Limit) -> bool,
    ) -> impl Iterator<Item = RowAt> {
        let nodes = 0..profile.nodes();
        let limits = self.engine.mission.limits.iter().enumerate().filter(move |(_, limit)| wanted(limit));
        limits.flat_map(move |(limit, _)| {
            nodes.clone().map(move |node| RowAt { row: Row::Limit(limit), instant: node * PARTS })
        })
    }

    /// The rows of limits on places, at every node.
    pub(super) fn places(&self, profile: &Profile) -> BTreeSet<RowAt> {
        self.limits_at_nodes(profile, |limit| place(limit.kind)).collect()
    }

    /// The rows that each step has at every node: of limits on places, which do not depend on time, and on yaw. Yaw costs
    /// little, and its acceleration would oscillate beyond its bounds wherever no row limits it.
    pub(super) fn rows_everywhere(&self, profile: &Profile) -> BTreeSet<RowAt> {
        let is_yaw = |kind| matches!(kind, LimitKind::YawRate | LimitKind::YawAcceleration);
        self.limits_at_nodes(profile, |limit| place(limit.kind) || is_yaw(limit.kind)).collect()
    }
}
