//! Whether a plan's certificate is false, decided without the checker: by the planner's sets, plain numbers and ten
//! times the checker's tolerances.
//!
//! A motion is false where it is not one (numbers missing, not finite, times that do not rise), where it keeps another
//! schedule, where pieces do not join, where it moves where it should rest, misses a waypoint or breaks a row; and
//! under RSP where the plans it selects by are none, or facets that they violate are broken. Rows count at nodes, and
//! between them where they are broken throughout for as long as the spec's own pieces last: no pieces as short as these
//! could step over it. What is broken for a shorter time makes a claim weaker and not false, and so do fewer pieces
//! whose rows hold, a mission of free time that takes longer than it must, and selected rows of sets that are flat,
//! uncertain or the pseudo-inverse's, whose facets the checker says it cannot tell. None of these is made here as a
//! forgery.

mod cores;
mod outline;
mod ways;

use super::motion::{AXES, equations, of_record};
use cores::Core;
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::SetRow;
use mavc::admissible::without_yaw::planned::{Provision, Turning};
use mavc::certificate::{Certificate, Claim, DynamicModel, PlanClaim, SpinRecord};
use mavc::model::grid::{leg_durations, pieces};
use mavc::model::{
    Environment, Heading, Limit, LimitKind, Mission, MissionTime, Model, Part, PlanModel, PlannerKind, SLOWEST,
};
use mavc::motion::checks::violation;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z, in_air};
use mavc::planner::selection::PlanningSet;
use mavc::planner::selection::sets::PlanningSets;
pub use outline::Outline;
use std::f64::consts::TAU;

/// Falsehoods count from this many tolerances on.
pub const TIMES: f64 = 10.0;

/// The checker's tolerances, written down anew.
const GAPS: [f64; 4] = [1e-6, 1e-5, 1e-4, 1e-3];
const MOVED: [f64; 4] = [1e-3, 1e-3, 1e-2, 1e-1];
const MISS: f64 = 1e-5;
const ROW: f64 = 1e-4;
const INSTANT: f64 = 1e-9;
const UPRIGHT: f64 = 0.1;

/// A derivative that should vanish does not: its tolerance is nothing, so this is far from rounding.
const MOVES: f64 = 1e-6;

/// Looks between two nodes of the spec's own grid.
const LOOKS: usize = 16;

/// Parts of a piece in which the exact model's selection is looked for.
const PARTS: usize = 16;

/// What makes a claim false.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Falsehood {
    Shape,
    Equations,
    /// A record of a mode without yaw that the spec does not have or allow, or whose range is not one.
    Record,
    Times,
    Joints,
    Rest,
    Waypoint,
    Limit(usize),
    Set,
    Commands,
    Upright,
    /// By its index among the records: a motion outside a core, turning or spinning faster than the record says.
    Core(usize),
    Turning(usize),
    Spin(usize),
    Selection,
    /// A volume by its outline, whatever the compiler made of it.
    Outline(usize),
    /// The yaw at a waypoint is off the direction that it follows, by more than the waypoint's own tolerance.
    Heading(usize),
    /// A capture height that is not one, that the spec does not require, or that the motion does not keep.
    Height,
    /// The spec requires a reserve about hover, which lies outside a set that it shrinks.
    Reserve,
    /// A way out that is none.
    Way,
}

/// What a motion has to keep.
#[derive(Debug, Clone, Default)]
struct Imposed {
    /// Rows of sets that hold throughout.
    sets: Vec<SetRow>,
    /// Rows of the modes' sets, of which RSP selects.
    of_modes: Vec<SetRow>,
    cores: Vec<Core>,
    /// Whether all of a core holds, and not what RSP selects of it.
    whole: bool,
}

/// A spec with its sets.
pub struct Truth {
    pub model: Model,
    sets: PlanningSets,
    /// Modes planned against without yaw, with the rows of their whole sets.
    freed: Vec<(String, Vec<SetRow>)>,
    /// What an honest certificate says of them.
    pub records: Vec<SpinRecord>,
    asked: Imposed,
    selecting: Imposed,
    pub equations: WrenchModel,
    /// Outlines of volumes, with the distance (m) that is kept from each.
    pub outlines: Vec<(Outline, f64)>,
}

/// Rows that are those of sets.
fn of_sets(rows: &[SetRow]) -> Vec<SetRow> {
    rows.iter().filter(|row| row.core.is_none()).cloned().collect()
}

impl Truth {
    pub fn of(model: &Model) -> Self {
        let sets = PlanningSets::of(model);
        let (mut freed, mut records) = (Vec::new(), Vec::new());
        let modes = model.plan.against.iter().filter(|_| model.plan.planner != PlannerKind::Rip);
        for (&mode, provision) in modes.zip(&sets.provisions) {
            let Provision::WithoutYaw(core) = provision else { continue };
            let name = model.modes[mode].name.clone();
            let own = AdmissibleSet::of_mode(model, mode).guaranteed(model).with_reserve(model.plan.reserve);
            freed.push((name.clone(), PlanningSet::of(&[&own], &sets.healthy).rows));
            records.push(SpinRecord { mode: name, spin_rad_s: core.spin_rad_s, turning_rad_s: core.turning_rad_s });
        }
        let selecting = Imposed { sets: sets.rip.rows.clone(), ..Imposed::default() };
        let (asked, equations) = (selecting.clone(), equations(model));
        let (model, outlines) = (model.clone(), Vec::new());
        let mut truth = Truth { model, sets, freed, records, asked, selecting, equations, outlines };
        truth.asked = truth.imposed(&truth.records).expect("honest records");
        truth
    }

    /// What the planner of the spec imposes with these records; `None` where one is of no mode whose yaw the spec
    /// gives up, or has a range that is not one.
    fn imposed(&self, records: &[SpinRecord]) -> Option<Imposed> {
        let mut cores = Vec::new();
        for record in records {
            let mode = self.model.modes.iter().find(|mode| mode.name == record.mode)?;
            let [low, high] = record.spin_rad_s;
            let is_range = low.is_finite() && high.is_finite() && low <= high;
            let is_rate = record.turning_rad_s.is_none_or(|rate| rate.is_finite() && rate > 0.0);
            if !is_range || !is_rate || self.freed.iter().all(|(name, _)| *name != mode.name) {
                return None;
            }
            cores.push(Core::of(&self.model, mode, record)?);
        }
        let missing = self.freed.iter().filter(|(name, _)| records.iter().all(|record| record.mode != *name));
        let missing: Vec<SetRow> = missing.flat_map(|(_, rows)| rows.clone()).collect();
        let mut of_modes: Vec<SetRow> = self.sets.modes.iter().flat_map(|set| of_sets(&set.rows)).collect();
        of_modes.extend(missing.clone());
        let (whole, mut sets) = match self.model.plan.planner {
            PlannerKind::Rcp => (true, of_sets(&self.sets.joint.rows)),
            _ => (false, of_sets(&self.sets.rip.rows)),
        };
        sets.extend(missing.into_iter().filter(|_| whole));
        Some(Imposed { sets, of_modes, cores, whole })
    }

    pub fn mission(&self) -> &Mission {
        self.model.mission.as_ref().expect("every spec here has a mission")
    }

    /// Whether a row to keep is an equality: some set is flat.
    pub fn has_equalities(&self) -> bool {
        self.asked.sets.iter().any(|row| row.equality)
    }

    /// Why a certificate of a plan is false, if it is.
    pub fn falsehood(&self, certificate: &Certificate) -> Option<Falsehood> {
        let Claim::Plan(claim) = &certificate.claim else { return None };
        let exact = certificate.model == DynamicModel::Exact;
        if exact != (self.model.plan.model == PlanModel::Exact) {
            return Some(Falsehood::Equations);
        }
        let keeps_height = |height: f64| {
            let motion = of_record(&claim.motion, self.equations);
            self.requires_height(height) && motion.is_some_and(|motion| self.keeps_height(&motion, height))
        };
        let of_height = certificate.capture_height_m.filter(|&height| !keeps_height(height));
        self.of_claim(claim).or_else(|| of_height.map(|_| Falsehood::Height)).or_else(|| self.misleads(claim))
    }

    /// Whether the ways out of a claim are none.
    fn misleads(&self, claim: &PlanClaim) -> Option<Falsehood> {
        let plan = of_record(&claim.motion, self.equations)?;
        claim.recovery.as_ref().filter(|ways| ways::are_false(&self.model, &plan, ways)).map(|_| Falsehood::Way)
    }

    /// Whether a certificate of the spec may give this height, m above the ground.
    fn requires_height(&self, height: f64) -> bool {
        self.model.plan.require_capture.is_some() && height.is_finite() && height > 0.0
    }

    /// (102) of the method at nodes: high enough, or near the start or the end.
    pub fn keeps_height(&self, motion: &Trajectory, height: f64) -> bool {
        let mission = self.mission();
        let Some((required, ground)) = self.model.plan.require_capture.zip(mission.ground) else { return true };
        let ends = [&mission.waypoints[0], &mission.waypoints[mission.waypoints.len() - 1]];
        motion.nodes.iter().all(|s| {
            let near = ends.iter().any(|end| {
                let apart = (s[X][0] - end.position[0]).hypot(s[Y][0] - end.position[1]);
                apart <= required.radius + TIMES * ROW
            });
            near || s[Z][0] >= ground + height - TIMES * ROW
        })
    }

    /// Whether hover lies outside a set that the spec's reserve shrinks. A set without hover stays as it is where
    /// hover is outside, so that the planner's rows show it.
    pub fn reserves_about_nothing(&self) -> bool {
        let hover = mavc::admissible::hover(&self.model);
        let shrunk = self.asked.sets.iter().chain(&self.asked.of_modes);
        let is_outside = |row: &SetRow| row.violation(&hover) > TIMES * ROW;
        self.model.plan.reserve > 0.0 && shrunk.into_iter().any(is_outside)
    }

    fn of_claim(&self, claim: &PlanClaim) -> Option<Falsehood> {
        let Some(motion) = of_record(&claim.motion, self.equations) else { return Some(Falsehood::Shape) };
        let plan = &self.model.plan;
        let selects = plan.planner == PlannerKind::Rsp && plan.rounds > 0 && !plan.against.is_empty();
        let Some(imposed) = self.imposed(&claim.without_yaw) else { return Some(Falsehood::Record) };
        let count = claim.selected_by.len();
        let wanted = if selects { 1..=plan.rounds } else { 0..=0 };
        let wrong_count = !wanted.contains(&count);
        let mut before: Vec<Trajectory> = Vec::new();
        for record in &claim.selected_by {
            let Some(other) = of_record(record, self.equations) else { return Some(Falsehood::Shape) };
            if self.of_motion(&other, &self.selecting).is_some() || self.breaks(&other, &before, &imposed) {
                return Some(Falsehood::Selection);
            }
            before.push(other);
        }
        let own = self.of_motion(&motion, &imposed);
        own.or_else(|| (wrong_count || self.breaks(&motion, &before, &imposed)).then_some(Falsehood::Selection))
    }

    /// Why a motion is not a plan by itself, if it is not.
    pub fn of_plan(&self, motion: &Trajectory) -> Option<Falsehood> {
        self.of_motion(motion, &self.asked)
    }

    /// The same of a motion that facets are selected by.
    pub fn of_selecting(&self, motion: &Trajectory) -> Option<Falsehood> {
        self.of_motion(motion, &self.selecting)
    }

    fn of_motion(&self, motion: &Trajectory, imposed: &Imposed) -> Option<Falsehood> {
        shaped(motion, self.mission())
            .or_else(|| (!self.on_time(motion)).then_some(Falsehood::Times))
            .or_else(|| (!joins(motion)).then_some(Falsehood::Joints))
            .or_else(|| (!self.rests(motion)).then_some(Falsehood::Rest))
            .or_else(|| (!self.arrives(motion)).then_some(Falsehood::Waypoint))
            .or_else(|| self.broken(motion, imposed))
            .or_else(|| self.misled(motion))
            .or_else(|| self.reserves_about_nothing().then_some(Falsehood::Reserve))
    }

    /// Schedule of the spec: start, fixed times, holds, shares of the legs.
    fn on_time(&self, motion: &Trajectory) -> bool {
        let (mission, plan) = (self.mission(), &self.model.plan);
        let end = motion.times[motion.times.len() - 1];
        let same = |a: f64, b: f64| (a - b).abs() <= TIMES * INSTANT * end.max(1.0);
        let fixed = match (mission.waypoints.last().and_then(|w| w.time), plan.time) {
            (None, MissionTime::Fixed(total)) => Some(total),
            _ => None,
        };
        if motion.times[0] != 0.0 || fixed.is_some_and(|total| !same(total, end)) {
            return false;
        }
        let mut due = Some(0.0);
        let durations = leg_durations(mission, end);
        for (i, point) in mission.waypoints.iter().enumerate() {
            let arrival = motion.times[motion.waypoint_nodes[i]];
            if !plan.chooses_times && i > 0 {
                let hold = mission.waypoints[i - 1].hold;
                due = due.zip(durations.as_ref()).map(|(due, durations)| due + hold + durations[i - 1]);
                if due.is_none_or(|due| !same(due, arrival)) {
                    return false;
                }
            }
            if point.time.is_some_and(|fixed| !same(fixed, arrival)) || self.leaves(motion, i).is_none() {
                return false;
            }
        }
        let last = mission.waypoints.len() - 1;
        self.leaves(motion, last) == Some(motion.times.len() - 1)
    }

    /// The node at which a waypoint is left.
    fn leaves(&self, motion: &Trajectory, waypoint: usize) -> Option<usize> {
        let (node, hold) = (motion.waypoint_nodes[waypoint], self.mission().waypoints[waypoint].hold);
        let next = motion.waypoint_nodes.get(waypoint + 1).copied().unwrap_or(motion.times.len());
        let until = motion.times[node] + hold;
        let end = motion.times[motion.times.len() - 1];
        let stays = |n: &usize| (motion.times[*n] - until).abs() <= TIMES * INSTANT * end.max(1.0);
        if hold > 0.0 { (node + 1..next).find(stays) } else { Some(node) }
    }

    fn rests(&self, motion: &Trajectory) -> bool {
        let mission = self.mission();
        let still = |node: usize, held: bool| {
            AXES.into_iter().zip(motion.model.orders()).all(|(axis, order)| {
                let highest = if held { order } else { order.min(3) };
                motion.nodes[node][axis][1..=highest].iter().all(|d| d.abs() <= MOVES)
            })
        };
        let last = motion.times.len() - 1;
        let ends = (!mission.start_at_rest || still(0, false)) && (!mission.end_at_rest || still(last, false));
        let holds = mission.waypoints.iter().enumerate().filter(|(_, w)| w.hold > 0.0);
        let mut held = holds.map(|(i, _)| (motion.waypoint_nodes[i], self.leaves(motion, i).unwrap_or(last)));
        let mut stops = mission.waypoints.iter().zip(&motion.waypoint_nodes).filter(|(point, _)| point.stop);
        let stopped = stops.all(|(_, &node)| still(node, false));
        ends && stopped && held.all(|(from, to)| (from..=to).all(|node| still(node, true)))
    }

    fn arrives(&self, motion: &Trajectory) -> bool {
        let met = |(point, &node): (&mavc::model::Waypoint, &usize)| {
            let state = &motion.nodes[node];
            let distance = (0..3).map(|i| (state[i][0] - point.position[i]).powi(2)).sum::<f64>().sqrt();
            let turned = (state[YAW][0] - point.yaw).abs();
            // A yaw that follows from the motion is another matter, and may be off by whole turns.
            let points = point.heading != Heading::Given || turned - point.yaw_within <= TIMES * MISS;
            distance - point.within <= TIMES * MISS && points
        };
        self.mission().waypoints.iter().zip(&motion.waypoint_nodes).all(met)
    }

    /// A waypoint at which the yaw does not follow from the motion within the waypoint's own tolerance, whatever
    /// limits the compiler derives from it.
    fn misled(&self, motion: &Trajectory) -> Option<Falsehood> {
        let is_off = |(point, &node): (&mavc::model::Waypoint, &usize)| {
            let s = &motion.nodes[node];
            let (x, y, least) = match point.heading {
                Heading::Towards(goal) => (goal[0] - s[X][0], goal[1] - s[Y][0], self.model.vehicle.radius()),
                Heading::AlongPath => (s[X][1], s[Y][1], SLOWEST),
                Heading::Given | Heading::Free => return false,
            };
            let off = (y.atan2(x) - s[YAW][0]).rem_euclid(TAU);
            x.hypot(y) >= least && exceeds(off.min(TAU - off) - point.yaw_within, TIMES * ROW)
        };
        let mut points = self.mission().waypoints.iter().zip(&motion.waypoint_nodes);
        points.position(is_off).map(Falsehood::Heading)
    }

    /// A row that is broken by ten tolerances at a node, or between nodes for as long as a piece of the spec lasts.
    fn broken(&self, motion: &Trajectory, imposed: &Imposed) -> Option<Falsehood> {
        let mut worst: Option<Falsehood> = None;
        let mut note = |found: Falsehood| worst = Some(worst.map_or(found, |w| w.min(found)));
        let asked = self.longest_pieces(motion);
        // Since when each row has been broken, s.
        let mut since: Vec<(Falsehood, f64)> = Vec::new();
        for (k, &longest) in asked.iter().enumerate() {
            let h = motion.times[k + 1] - motion.times[k];
            let looks = ((h / longest * LOOKS as f64).ceil() as usize).clamp(1, 4000);
            let between = if h > longest * (1.0 + 1e-6) { looks } else { 1 };
            for i in 0..=between {
                let at = if i == between { h } else { h * i as f64 / between as f64 };
                let rows = self.excesses(motion, k, at, imposed);
                let over: Vec<Falsehood> = rows.iter().filter(|r| exceeds(r.1, TIMES)).map(|r| r.0).collect();
                let now = motion.times[k] + at;
                if i == 0 || i == between {
                    over.iter().copied().for_each(&mut note);
                }
                since.retain(|(what, _)| over.contains(what));
                // A yaw that follows from the motion is required at nodes alone.
                let is_of_nodes = |what: &Falsehood| match what {
                    Falsehood::Limit(i) => self.mission().limits[*i].kind.is_heading(),
                    _ => false,
                };
                for what in over.into_iter().filter(|what| !is_of_nodes(what)) {
                    match since.iter().find(|(known, _)| *known == what) {
                        Some((_, from)) if now - from >= 1.001 * longest => note(what),
                        Some(_) => {}
                        None => since.push((what, now)),
                    }
                }
            }
        }
        worst
    }

    /// How long the spec's pieces are where each of the motion's is, s.
    fn longest_pieces(&self, motion: &Trajectory) -> Vec<f64> {
        let mission = self.mission();
        let legs = 0..mission.legs.len();
        let spans: Vec<(usize, usize)> =
            legs.map(|i| (self.leaves(motion, i).unwrap_or(0), motion.waypoint_nodes[i + 1])).collect();
        let durations: Vec<f64> = spans.iter().map(|&(a, b)| motion.times[b] - motion.times[a]).collect();
        let counts = pieces(mission, &durations, self.model.plan.samples);
        let of = |k: usize| {
            let leg = spans.iter().position(|&(a, b)| a <= k && k < b);
            // In holds nothing changes.
            leg.map_or(f64::INFINITY, |leg| durations[leg] / counts[leg] as f64)
        };
        (0..motion.intervals()).map(of).collect()
    }

    /// Every kind of row with its largest excess in tolerances, `at` seconds into a piece; in an interval of winds in
    /// the worst of its corners.
    fn excesses(&self, motion: &Trajectory, k: usize, at: f64, imposed: &Imposed) -> Vec<(Falsehood, f64)> {
        let state = motion.within(k, at);
        let environment = self.model.environment();
        let winds = environment.corners();
        let worst = |of: &dyn Fn(&Environment) -> f64| winds.iter().map(of).fold(f64::NEG_INFINITY, larger);
        let g = self.model.gravity;
        let lift = |wind: &Environment| in_air(&state, wind)[Z][2] + g;
        let limits = self.mission().limits.iter().enumerate().filter(|(_, limit)| self.holds(limit, motion, k, at));
        let mut found: Vec<(Falsehood, f64)> = limits
            .map(|(i, limit)| {
                let over = match (&limit.kind, limit.upper) {
                    (LimitKind::Tilt, Some(upper)) => worst(&|wind| {
                        let felt = in_air(&state, wind);
                        (felt[X][2].hypot(felt[Y][2]) * upper.cos() - lift(wind) * upper.sin()) / g
                    }),
                    _ => violation(limit, &state, &environment),
                };
                (Falsehood::Limit(i), over / (ROW * limit.size()))
            })
            .collect();
        let rows = &imposed.sets;
        let vehicle = &self.model.vehicle;
        found.push((Falsehood::Set, worst(&|wind| most(rows, &motion.wrench(vehicle, wind, &state))) / ROW));
        if let Some(tau) = self.model.thrust_lag() {
            let lead = |wind: &Environment| most(rows, &motion.commanded(vehicle, wind, tau, k, &state));
            found.push((Falsehood::Commands, worst(&lead) / ROW));
        }
        if self.equations == WrenchModel::Exact {
            found.push((Falsehood::Upright, worst(&|wind| UPRIGHT - lift(wind) / g) / ROW));
        }
        let outlines = 0..self.outlines.len();
        found.extend(outlines.map(|i| (Falsehood::Outline(i), self.past_outline(i, &state) / ROW)));
        for (index, core) in imposed.cores.iter().enumerate().filter(|_| imposed.whole) {
            let turning = self.turning(&state);
            found.push((Falsehood::Core(index), core.worst(&turning) / ROW));
            found.push((Falsehood::Turning(index), core.turns_beyond(&turning) / ROW));
            found.push((Falsehood::Spin(index), core.spins_beyond(&turning) / ROW));
        }
        found
    }

    /// By how much each outline is passed, m.
    fn past_outline(&self, index: usize, s: &NodeState) -> f64 {
        let (outline, margin) = &self.outlines[index];
        outline.past([s[X][0], s[Y][0], s[Z][0]], *margin)
    }

    /// Whether a motion is clearly past an outline at a node.
    pub fn is_past(&self, motion: &Trajectory, index: usize) -> bool {
        motion.nodes.iter().any(|s| self.past_outline(index, s) > TIMES * ROW)
    }

    /// How the direction of the thrust turns.
    fn turning(&self, state: &NodeState) -> Turning {
        self.equations.turning(&self.model.vehicle, &self.model.environment(), state)
    }

    /// Whether a limit holds `at` seconds into a piece: always, or on its leg, which begins after a hold.
    fn holds(&self, limit: &Limit, motion: &Trajectory, k: usize, at: f64) -> bool {
        let Some(on) = limit.leg.as_deref() else { return true };
        let (first, last) = (self.leaves(motion, on.leg), motion.waypoint_nodes[on.leg + 1]);
        let first = first.unwrap_or(motion.waypoint_nodes[on.leg]);
        let is_end = at == motion.times[k + 1] - motion.times[k];
        match on.part {
            Part::Whole => first <= k && k < last,
            Part::Start => k == first && at == 0.0,
            Part::End => k + 1 == last && is_end,
        }
    }

    /// The largest excess of any row at a node in tolerances: not above 0 where the motion keeps everything.
    pub fn tightest(&self, motion: &Trajectory) -> f64 {
        let ends = (0..motion.intervals()).flat_map(|k| [(k, 0.0), (k, motion.times[k + 1] - motion.times[k])]);
        let rows = ends.flat_map(|(k, at)| self.excesses(motion, k, at, &self.asked));
        rows.map(|r| r.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether a motion to select by keeps its own rows without a tolerance.
    pub fn keeps_own(&self, motion: &Trajectory) -> bool {
        let ends = (0..motion.intervals()).flat_map(|k| [(k, 0.0), (k, motion.times[k + 1] - motion.times[k])]);
        ends.flat_map(|(k, at)| self.excesses(motion, k, at, &self.selecting)).all(|r| r.1 <= 0.0)
    }

    /// What RSP selects by some motions that are beyond it by `share` of the healthy set's width: rows of the modes'
    /// sets, and rows of cores by their indices.
    fn selected(&self, motions: &[Trajectory], share: f64, imposed: &Imposed) -> (Vec<SetRow>, Vec<(usize, usize)>) {
        let parts = if self.equations == WrenchModel::Exact { PARTS } else { 1 };
        let seen: Vec<(Wrench, Turning)> = motions
            .iter()
            .flat_map(|motion| {
                let looks = (0..motion.intervals()).flat_map(move |k| (0..=parts).map(move |i| (k, i)));
                looks.map(move |(k, i)| {
                    let h = motion.times[k + 1] - motion.times[k];
                    let state = motion.within(k, h * i as f64 / parts as f64);
                    (self.wrench(motion, &state), self.turning(&state))
                })
            })
            .collect();
        let rows = imposed.of_modes.iter().filter(|row| seen.iter().any(|(w, _)| row.violation(w) > share));
        let of_core = |(index, core): (usize, &Core)| {
            let mut over = vec![false; core.edges().len()];
            for (_, turning) in &seen {
                let found = core.violations(turning).into_iter().zip(core.edges());
                over.iter_mut().zip(found).for_each(|(over, (v, edge))| *over |= edge && v > share);
            }
            let members = (0..over.len()).filter(|&member| over[member]);
            members.map(|member| (index, member)).collect::<Vec<_>>()
        };
        (rows.cloned().collect(), imposed.cores.iter().enumerate().flat_map(of_core).collect())
    }

    fn wrench(&self, motion: &Trajectory, state: &NodeState) -> Wrench {
        motion.wrench(&self.model.vehicle, &self.model.environment(), state)
    }

    /// Whether what RSP selects by some motions is broken by more than `share` of a width at a node: a row, or what is
    /// a premise of every row of a core.
    fn beyond_selected(&self, motion: &Trajectory, before: &[Trajectory], share: f64, imposed: &Imposed) -> bool {
        // Nearly all that is clearly selected, where nothing may be broken.
        let (rows, members) = self.selected(before, if share < TIMES * ROW { 1e-5 } else { TIMES * ROW }, imposed);
        motion.nodes.iter().any(|s| {
            let turning = self.turning(s);
            let is_broken = |&(index, member): &(usize, usize)| {
                let core: &Core = &imposed.cores[index];
                let premise = core.turns_beyond(&turning).max(core.spins_beyond(&turning));
                core.violations(&turning)[member].max(premise) > share
            };
            most(&rows, &self.wrench(motion, s)) > share || members.iter().any(is_broken)
        })
    }

    fn breaks(&self, motion: &Trajectory, before: &[Trajectory], imposed: &Imposed) -> bool {
        self.model.plan.planner == PlannerKind::Rsp && self.beyond_selected(motion, before, TIMES * ROW, imposed)
    }

    /// Whether a row that the motions before are clearly beyond is broken at a node.
    pub fn breaks_selection(&self, motion: &Trajectory, before: &[Trajectory]) -> bool {
        self.breaks(motion, before, &self.asked)
    }

    /// Whether all that the motions before are beyond is kept, and nothing of it is near.
    pub fn is_clear_of_selection(&self, motion: &Trajectory, before: &[Trajectory]) -> bool {
        !self.beyond_selected(motion, before, 5e-5, &self.asked)
    }

    /// Whether RSP selects something by a motion.
    pub fn selects_by(&self, motion: &Trajectory) -> bool {
        let (rows, members) = self.selected(std::slice::from_ref(motion), 3e-3, &self.asked);
        !rows.is_empty() || !members.is_empty()
    }

    /// How far a motion leaves the modes' sets and cores at nodes, as a share of the healthy set's width.
    pub fn beyond_modes(&self, motion: &Trajectory) -> f64 {
        let of_node = |s: &NodeState| {
            let turning = self.turning(s);
            let of_cores = self.asked.cores.iter().map(|core| core.worst(&turning));
            of_cores.fold(most(&self.asked.of_modes, &self.wrench(motion, s)), f64::max)
        };
        motion.nodes.iter().map(of_node).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Whether a number is above another; what is no number is above everything.
fn exceeds(x: f64, most: f64) -> bool {
    x.partial_cmp(&most).is_none_or(std::cmp::Ordering::is_gt)
}

/// The larger of two numbers; what is no number stays.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

fn most(rows: &[SetRow], wrench: &Wrench) -> f64 {
    rows.iter().map(|row| row.violation(wrench)).fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { b } else { a.max(b) })
}

/// A motion at all, with a node for each waypoint in flight order.
fn shaped(motion: &Trajectory, mission: &Mission) -> Option<Falsehood> {
    let numbers = motion.times.iter().chain(motion.nodes.iter().flatten().flatten());
    let rising = motion.times.windows(2).all(|w| w[0] < w[1]);
    let nodes = &motion.waypoint_nodes;
    let in_order = nodes.windows(2).all(|w| w[0] < w[1]) && nodes.iter().all(|&n| n < motion.times.len());
    let each = nodes.len() == mission.waypoints.len() && nodes.first() == Some(&0);
    let is_one = numbers.into_iter().all(|v| v.is_finite()) && rising && in_order && each;
    (!is_one).then_some(Falsehood::Shape)
}

/// Pieces meet, one by one and all together.
fn joins(motion: &Trajectory) -> bool {
    let mut moved = [[0.0_f64; 4]; 4];
    for k in 0..motion.intervals() {
        let h = motion.times[k + 1] - motion.times[k];
        let end = motion.within(k, h);
        for (axis, order) in AXES.into_iter().zip(motion.model.orders()) {
            let mut sums = [0.0; 4];
            for (j, sum) in sums.iter_mut().enumerate() {
                let mut power = 1.0;
                for (n, by) in moved[axis][j..].iter().enumerate() {
                    power *= if n == 0 { 1.0 } else { h / n as f64 };
                    *sum += by * power;
                }
            }
            for i in 0..order {
                let gap = (end[axis][i] - motion.nodes[k + 1][axis][i]).abs();
                if exceeds(gap, TIMES * GAPS[i]) {
                    return false;
                }
                sums[i] += gap;
            }
            moved[axis] = sums;
        }
    }
    let place = |i: usize| [X, Y, Z].iter().map(|&axis| moved[axis][i].powi(2)).sum::<f64>().sqrt();
    (0..4).all(|i| place(i) <= TIMES * MOVED[i] && moved[YAW][i] <= TIMES * MOVED[i])
}
