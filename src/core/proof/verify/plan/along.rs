//! Bounds along a motion: limits, sets and facets, and an upright thrust. The nodes decide; between them, bounds are
//! proved at every instant or checked on a grid.

use super::super::cost::{self, WorkLeft};
use super::super::heading;
use super::super::interval::{Interval, exceeds};
use super::super::limits;
use super::super::motion::{Motion, State, YAW, series};
use super::super::premise::Premise;
use super::super::proof::{
    Failure, Family, Measure, Rated, Throughout, above_at_nodes, cost_at_nodes, cost_of_grid, largest_on_grid,
    throughout, worse,
};
use super::super::series::Series;
use super::super::sets::{Plane, along, innermost};
use super::super::wind;
use super::super::wrench::{Dynamics, Held, thrust_over_mass};
use super::super::{Reach, Rejection, Scope, Shown, schedule};
use super::{
    Checked, Found, Group, LEAST_PRODUCT, MOST_OUTSIDE, MOST_PAST_LIMIT, Setting, UPRIGHT, all_planes, is_linear,
    of_groups,
};
use crate::certificate::DynamicModel;
use crate::model::{Environment, Limit, LimitKind, Part, Quantity, Target};
use crate::number::{number, significant};
use std::collections::BTreeSet;

/// Points inside a piece at which bounds that are not proved are checked; 64 with one of the ends.
pub const POINTS_OF_A_GRID: usize = 63;

/// Work for a proof that may be in vain, as a multiple of that at the nodes.
const TRIED: u64 = 8;

/// A violation between nodes is reported with a bound at every instant if that bound, the grid's value plus this share
/// of the limit's size, can be proved.
const MISSED: f64 = 1e-3;

impl<'a> Setting<'a> {
    pub(super) fn limits_at_nodes(&self, motion: &Motion) -> Result<(), Rejection> {
        if !self.premises.has(Premise::Limits) {
            return Ok(());
        }
        for (index, limit) in self.mission().limits.iter().enumerate() {
            let family = self.family_of(limit, motion);
            let most = MOST_PAST_LIMIT * limit.size();
            let keeps = |about: Limit| above_at_nodes(&self.family_of(&about, motion), motion, most).is_none();
            if limits::about(limit).is_some_and(keeps) {
                continue;
            }
            if let Some(failure) = above_at_nodes(&family, motion, most) {
                let claim = format!("limit {} ({})", index + 1, limit.name());
                return Err(Rejection { span: Some(limit.span), ..violated(claim, &failure, family.measure, most) });
            }
        }
        Ok(())
    }

    /// A limit as a quantity along a motion whose times agree with the spec, on the part of it where the limit holds.
    pub fn family_of<'l>(&self, limit: &'l Limit, motion: &Motion) -> Family<'l> {
        let within = limit.leg.as_ref().map(|on| {
            let (first, last) = (on.leg, motion.waypoint_nodes[on.leg + 1]);
            // A hold belongs to no leg. Where its end is not found, the leg is taken to begin before it.
            let first = schedule::held_until(self.mission(), motion, first).unwrap_or(motion.waypoint_nodes[first]);
            match on.part {
                Part::Start => (first, first),
                Part::End => (last, last),
                Part::Whole => (first, last),
            }
        });
        limits::family(limit, &self.dynamics.environment, within)
    }

    pub(super) fn upright_at_nodes(&self, motion: &Motion) -> Result<(), Rejection> {
        if self.dynamics.model == DynamicModel::Hover {
            return Ok(());
        }
        let family = upright(&self.dynamics.environment);
        match above_at_nodes(&family, motion, MOST_PAST_LIMIT) {
            Some(f) => Err(violated("the upright thrust".into(), &f, family.measure, MOST_PAST_LIMIT)),
            None => Ok(()),
        }
    }

    /// Checks that the wrench and, if rotors lag, the commanded wrench are inside every group's planes.
    pub(super) fn inside_at_nodes(&self, motion: &Motion, groups: &[Group]) -> Result<(), Rejection> {
        let planes = all_planes(groups);
        let innermost = innermost(&planes);
        let members: Vec<usize> = (0..planes.len()).filter(|&member| innermost[member] == member).collect();
        for held in self.held() {
            let family = of_groups(self, held, members.iter().map(|&member| planes[member]).collect());
            if let Some(failure) = above_at_nodes(&family, motion, MOST_OUTSIDE) {
                let failure = Failure { member: members[failure.member], ..failure };
                return Err(self.outside(groups, &failure, held));
            }
        }
        Ok(())
    }

    /// The quantities that must stay in sets.
    pub fn held(&self) -> Vec<Held> {
        let wrench = self.premises.has(Premise::Sets).then_some(Held::Wrench);
        let commands = self.commands.filter(|_| self.premises.has(Premise::Commands));
        wrench.into_iter().chain(commands).collect()
    }

    fn outside(&self, groups: &[Group], failure: &Failure, held: Held) -> Rejection {
        let Some((group, member)) = group_of(groups, failure.member) else {
            return violated("a set".into(), failure, Measure::WIDTH, MOST_OUTSIDE);
        };
        let rotors = &group.planes[member].rotors;
        let plane = if rotors.is_empty() { String::new() } else { format!(", at the plane of rotors {rotors:?}") };
        let subject = if held == Held::Wrench { "" } else { "the commands in " };
        let claim = format!("{subject}{}{plane}", group.name());
        Rejection { span: group.span, ..violated(claim, failure, Measure::WIDTH, MOST_OUTSIDE) }
    }

    /// The quantity in words. Statements about the linear model's wrench are not statements about the vehicle's.
    fn words(&self, held: Held) -> &'static str {
        match (self.dynamics.model, held) {
            (DynamicModel::Hover, Held::Wrench) => "linear model's wrench",
            (DynamicModel::Hover, Held::Commands { .. }) => "linear model's commands",
            (DynamicModel::Exact, Held::Wrench) => "wrench",
            (DynamicModel::Exact, Held::Commands { .. }) => "commands",
        }
    }
}

/// Whether two limits are parts of one volume, which is one statement of the spec.
fn same_volume(a: &Limit, b: &Limit) -> bool {
    a.volume.is_some() && a.span == b.span
}

/// A limit as the subject of a statement.
fn limited(limit: &Limit) -> String {
    if limit.volume.is_some() { limit.name().to_string() } else { format!("limit on {}", limit.name()) }
}

/// The rejection for a row that is violated at a node.
pub(super) fn violated(claim: String, failure: &Failure, measure: Measure, most: f64) -> Rejection {
    let of = measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
    let detail = format!("violated by {}{of}; at most {} is allowed", measure.of(failure.violation), measure.of(most));
    Rejection { at: Some(failure.at), ..Rejection::new(claim, detail) }
}

/// The group that a member of [`all_planes`] belongs to, and which of its planes that is.
fn group_of(groups: &[Group], member: usize) -> Option<(&Group, usize)> {
    let mut first = 0;
    for group in groups {
        if member < first + group.planes.len() {
            return Some((group, member - first));
        }
        first += group.planes.len();
    }
    None
}

/// Normals of planes, in widths of the healthy set, with a smaller relative difference count as equal.
const SAME_NORMAL: f64 = 1e-6;

impl Group {
    /// The number of different facets: several triples of rotors may span the same one.
    fn facets(&self) -> usize {
        let direction = |plane: &Plane| {
            let normal = plane.normal.map(Interval::middle);
            let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
            normal.map(|n| (n / length / SAME_NORMAL).round() as i64)
        };
        self.planes.iter().map(direction).collect::<BTreeSet<_>>().len()
    }

    fn name(&self) -> String {
        match self.whole {
            true => format!("the set of {}", self.mode),
            false => format!("a facet of {} that RSP selects", self.mode),
        }
    }
}

impl Checked<'_> {
    /// Checks limits, sets and facets between the nodes, as far as the remaining work allows.
    pub(super) fn check_between(&self, purse: &mut WorkLeft, found: &mut Found) {
        let setting = self.setting;
        let before = purse.0;
        for limits in setting.mission().limits.chunk_by(same_volume) {
            match limits[0].kind.describe().quantity {
                // It holds at one node, where it has been decided.
                Quantity::Arrival(_) => {
                    found.shown.push(Shown::at_nodes(limited(&limits[0])));
                    continue;
                }
                Quantity::Heading(target) => {
                    found.shown.push(Shown::at_nodes(self.followed(&limits[0], target, purse)));
                    continue;
                }
                Quantity::Axis { .. } | Quantity::Norm { .. } | Quantity::Tilt => {}
                Quantity::Along(_) | Quantity::Distance(_) | Quantity::Clearance(_) => {}
            }
            let reach = |limit: &Limit| {
                let most = MOST_PAST_LIMIT * limit.size();
                if limits::about(limit).is_some_and(|about| self.keeps_throughout(&about, most, purse)) {
                    return Reach::EVERY_INSTANT;
                }
                let family = setting.family_of(limit, &self.motion);
                self.reach(&family, most, limit.size(), purse)
            };
            if let Some(reach) = limits.iter().map(reach).reduce(Reach::weakest) {
                found.add(limited(&limits[0]), reach);
            }
        }
        if setting.dynamics.model == DynamicModel::Exact {
            let reach = self.reach(&upright(&setting.dynamics.environment), MOST_PAST_LIMIT, 1.0, purse);
            let statement = match setting.dynamics.environment.is_isotropic() {
                true => "vertical thrust of at least a tenth of the weight",
                false => {
                    "upright attitude, with a vertical thrust before the drag along the body's z axis of at least a \
                     tenth of the weight"
                }
            };
            found.add(statement.into(), reach);
        } else if setting.mission().limits.iter().any(|limit| limit.kind == LimitKind::Tilt) {
            // The linear model's thrust may vanish, and its direction is then undefined.
            let reach = self.reach(&upright(&setting.dynamics.environment), MOST_PAST_LIMIT, 1.0, purse);
            if reach.weaker("").is_some() {
                let at = reach.beyond.map_or(String::new(), |beyond| format!(", at {} s", number(beyond.at)));
                found.weaker.push(format!(
                    "limit on tilt: it is not shown that the thrust stays above a tenth of the weight{at}; a thrust \
                     that nearly vanishes satisfies any limit on its direction within the tolerance"
                ));
            }
        }
        for held in [Some(Held::Wrench), setting.commands].into_iter().flatten() {
            self.groups_between(held, purse, found);
        }
        self.cores_between(purse, found);
        if purse.0 == 0 && before > 0 {
            found.weaker.push("the budget ended before every row was proved; a larger `--budget` may show more".into());
        }
    }

    /// A yaw that follows from the motion, with the largest error that a grid shows.
    fn followed(&self, limit: &Limit, target: Target, purse: &mut WorkLeft) -> String {
        let family = self.setting.family_of(limit, &self.motion);
        let (first, last) = family.within.unwrap_or((0, self.motion.pieces()));
        if !purse.spend(cost_of_grid(&family, &self.motion, 1, POINTS_OF_A_GRID)) {
            return limited(limit);
        }
        let Some(allowed) = limit.upper.map(|upper| number(upper.to_degrees())) else { return limited(limit) };
        match heading::largest(target, &self.motion, first..=last, POINTS_OF_A_GRID) {
            Some((error, at)) => format!(
                "{} within {allowed} deg (between the nodes {} deg on a grid, at {} s)",
                limit.name(),
                significant(error.to_degrees(), 3),
                significant(at, 4)
            ),
            None => format!("{} not required anywhere", limit.name()),
        }
    }

    /// Adds the statements that a check of the nodes alone shows.
    pub(super) fn nodes_only(&self, found: &mut Found) {
        for limits in self.setting.mission().limits.chunk_by(same_volume) {
            found.add(limited(&limits[0]), Reach::NODES);
        }
        for group in &self.groups {
            found.shown.push(Shown::new(self.statement(group, Held::Wrench), Reach::NODES));
        }
        self.cores_at_nodes(found);
    }

    fn statement(&self, group: &Group, held: Held) -> String {
        let (held, count) = (self.setting.words(held), group.facets());
        let winds = if self.setting.dynamics.is_in_winds() { ", in every wind" } else { "" };
        match group.whole {
            true => format!("{held} inside the set of {}{winds}", group.mode),
            false if count == 1 => format!("{held} inside 1 selected facet of {}{winds}", group.mode),
            false => format!("{held} inside {count} selected facets of {}{winds}", group.mode),
        }
    }

    fn groups_between(&self, held: Held, purse: &mut WorkLeft, found: &mut Found) {
        let planes = all_planes(&self.groups);
        let Throughout { proved, refuted } = self.planes_throughout(&planes, held, purse);
        let family = of_groups(self.setting, held, planes);
        let mut first = 0;
        for group in &self.groups {
            let members: Vec<usize> = (first..first + group.planes.len()).collect();
            first += group.planes.len();
            let open: Vec<usize> = members.iter().copied().filter(|&member| !proved[member]).collect();
            let reach = self.on_grid(&family, &open, &refuted, MOST_OUTSIDE, purse);
            found.add(self.statement(group, held), reach);
        }
    }

    /// Whether the quantity `held` stays within each plane. Most planes of a mode are parallel to those of others, and
    /// only the innermost of parallel planes is proved; if that fails, the others are tried.
    fn planes_throughout(&self, planes: &[&Plane], held: Held, purse: &mut WorkLeft) -> Throughout {
        let innermost = innermost(planes);
        let mut all = Throughout { proved: vec![false; planes.len()], refuted: Vec::new() };
        let mut try_these = |members: &[usize], all: &mut Throughout| {
            let family = of_groups(self.setting, held, members.iter().map(|&member| planes[member]).collect());
            let found = throughout(&family, &self.motion, MOST_OUTSIDE, purse);
            for (&member, proved) in members.iter().zip(found.proved) {
                all.proved[member] = proved;
            }
            let named = |failure: Failure| Failure { member: members[failure.member], ..failure };
            all.refuted.extend(found.refuted.into_iter().map(named));
        };
        let (first, others): (Vec<usize>, Vec<usize>) =
            (0..planes.len()).partition(|&member| innermost[member] == member);
        try_these(&first, &mut all);
        let (within, open): (Vec<usize>, Vec<usize>) =
            others.into_iter().partition(|&member| all.proved[innermost[member]]);
        within.into_iter().for_each(|member| all.proved[member] = true);
        if !open.is_empty() {
            try_these(&open, &mut all);
        }
        all
    }

    /// Whether a limit that another one follows from is proved, with a small part of the remaining work: if it is not,
    /// that was in vain.
    fn keeps_throughout(&self, limit: &Limit, most: f64, purse: &mut WorkLeft) -> bool {
        let family = self.setting.family_of(limit, &self.motion);
        let share = purse.0.min(cost_at_nodes(&family, &self.motion).saturating_mul(TRIED));
        let mut own = WorkLeft(share);
        let kept = throughout(&family, &self.motion, most, &mut own).is_proved();
        purse.spend(share - own.0);
        kept
    }

    pub(super) fn reach(&self, family: &Family, most: f64, size: f64, purse: &mut WorkLeft) -> Reach {
        let Throughout { proved, refuted } = throughout(family, &self.motion, most, purse);
        let open: Vec<usize> = (0..family.members).filter(|&member| !proved[member]).collect();
        let mut reach = self.on_grid(family, &open, &refuted, most, purse);
        // A violation between nodes is bounded at every instant, if that can be proved.
        if let Some(beyond) = reach.beyond.as_mut() {
            let violation = beyond.violation + MISSED * size;
            if throughout(family, &self.motion, violation, purse).is_proved() {
                (beyond.violation, beyond.throughout) = (violation, true);
            }
        }
        reach
    }

    /// The result on a grid for members that are not proved, of which some may be `refuted` between its points.
    fn on_grid(&self, family: &Family, open: &[usize], refuted: &[Failure], most: f64, purse: &mut WorkLeft) -> Reach {
        if open.is_empty() {
            return Reach::EVERY_INSTANT;
        }
        let is_paid = purse.spend(cost_of_grid(family, &self.motion, open.len(), POINTS_OF_A_GRID));
        let on_grid = is_paid.then(|| largest_on_grid(family, &self.motion, open, POINTS_OF_A_GRID)).flatten();
        let between = refuted.iter().copied().filter(|failure| open.contains(&failure.member));
        match between.map(Some).fold(on_grid, worse) {
            Some(worst) if exceeds(worst.violation, most) => Reach::violated(worst, family.measure),
            _ if is_paid => Reach { scope: Scope::Grid, beyond: None },
            _ => Reach::NODES,
        }
    }
}

impl Found {
    /// Adds a statement; one that is not shown at every instant makes the result weaker.
    pub(super) fn add(&mut self, statement: String, reach: Reach) {
        if let Some(why) = reach.weaker(&statement) {
            self.weaker.push(why);
        }
        self.shown.push(Shown::new(statement, reach));
    }
}

/// `0.1 - (z'' + g)/g`: by how much the vertical part of the thrust is below a tenth of the weight, in weights.
///
/// With a drag for each axis of the body, the thrust before the drag along that axis. Where the drag differs along x
/// and y, this of alpha and of beta, and `0.005 - (alpha_f beta_f + alpha_u beta_u)/g^2`: where all three hold, the
/// body's z axis points up.
pub fn upright(environment: &Environment) -> Family<'static> {
    let environment = *environment;
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        let g = Interval::point(environment.gravity);
        let [x, y, _] = environment.drag_rates;
        let of_rate = |rate: f64| {
            let [.., lift] = thrust_over_mass::<2>(state, &environment, rate);
            let short = Series::constant(Interval::point(UPRIGHT) * g) + -lift;
            Rated { value: short.value() / g, rate: short.slope() / g }
        };
        let of_product = || {
            let (sine, cosine) = series(&state[YAW], 0).sin_cos();
            let [alpha, beta] = [x, y].map(|rate| {
                let [x, y, lift] = thrust_over_mass::<2>(state, &environment, rate);
                [cosine * x + sine * y, lift]
            });
            let product = alpha[0] * beta[0] + alpha[1] * beta[1];
            let short = Series::constant(Interval::point(LEAST_PRODUCT) * g * g) + -product;
            Rated { value: short.value() / (g * g), rate: short.slope() / (g * g) }
        };
        let member = |&member: &usize| match member {
            0 => of_rate(x),
            1 => of_rate(y),
            _ => of_product(),
        };
        wanted.iter().map(member).collect()
    };
    let members = if environment.turns_alike() { 1 } else { 3 };
    let measure = Measure { factor: 100.0, unit: "%", whole: Some("of the weight") };
    let evaluate = Box::new(evaluate);
    Family {
        members,
        evaluate,
        linear: false,
        jumps: false,
        within: None,
        at_nodes_only: false,
        measure,
        overhead: cost::COST_PER_LIMIT,
        of_a_member: 1,
    }
}

/// The violation of each plane by the quantity `held`.
pub fn wrench_family<'a: 'b, 'b>(dynamics: &Dynamics<'a>, held: Held, planes: Vec<&'b Plane>) -> Family<'b> {
    let linear = is_linear(dynamics);
    let dynamics = dynamics.clone();
    let is_windy = dynamics.is_in_winds();
    let boxes = if is_windy { wind::boxes(&dynamics) } else { Vec::new() };
    let overhead = if is_windy { wind::cost(&dynamics) } else { 1 } * cost::OF_EXACT_WRENCH;
    let of_a_member = if is_windy { wind::cost_of_a_plane(&dynamics) } else { cost::COST_PER_ROW };
    let members = planes.len();
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        if is_windy {
            let planes: Vec<&Plane> = wanted.iter().filter_map(|&m| planes.get(m).copied()).collect();
            return wind::violations(&boxes, held, state, &planes);
        }
        let found = dynamics.held(held, state);
        let planes = wanted.iter().filter_map(|&m| planes.get(m));
        planes.map(|p| Rated { value: p.violation(&found.value), rate: along(&p.normal, &found.rate) }).collect()
    };
    // The rate of the wrench contains the slopes of the inputs, which change at nodes.
    let jumps = held != Held::Wrench;
    let measure = Measure::WIDTH;
    let (within, at_nodes_only) = (None, false);
    Family {
        members,
        evaluate: Box::new(evaluate),
        linear,
        jumps,
        within,
        at_nodes_only,
        measure,
        overhead,
        of_a_member,
    }
}
