//! Whether a plan's certificate is false, decided without the checker: by the planner's sets, plain numbers and ten times
//! the checker's tolerances.
//!
//! A motion is false where it is not one (numbers missing, not finite, times that do not rise), where it keeps another
//! schedule, where pieces do not join, where it moves where it should rest, misses a waypoint or breaks a row; and under
//! RSP where the plans it selects by are none, or facets that they violate are broken. Rows count at nodes, and between
//! them where they are broken throughout for as long as the spec's own pieces last: no pieces as short as these could
//! step over it. What is broken for a shorter time makes a claim weaker and not false, and so do fewer pieces whose rows
//! hold, a mission of free time that takes longer than it must, and selected rows of sets that are flat, uncertain or the
//! pseudo-inverse's, whose facets the checker says it cannot tell. None of these is made here as a forgery.

use super::motion::{AXES, equations, of_record};
use mavc::actuation::Wrench;
use mavc::admissible::row::SetRow;
use mavc::certificate::{Certificate, Claim, DynamicModel, PlanClaim};
use mavc::model::grid::{leg_durations, pieces};
use mavc::model::{
    Environment, Heading, Limit, LimitKind, Mission, MissionTime, Model, Part, PlanModel, PlannerKind, SLOWEST,
};
use mavc::motion::checks::past;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z, in_air};
use mavc::planner::selection::PlanningSet;
use mavc::planner::selection::sets::PlanningSets;
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
    Times,
    Joints,
    Rest,
    Waypoint,
    Limit(usize),
    Set,
    Commands,
    Upright,
    Selection,
    /// The yaw at a waypoint is off the direction that it follows, by more than the waypoint's own tolerance.
    Heading(usize),
    /// A capture height that is not one, that the spec does not require, or that the motion does not keep.
    Height,
    /// The spec requires a reserve about hover, which lies outside a set that it shrinks.
    Reserve,
}

/// Which rows a motion has to keep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Asked,
    Selecting,
}

/// A spec with its sets.
pub struct Truth {
    pub model: Model,
    sets: PlanningSets,
    asked: PlanningSet,
    pub equations: WrenchModel,
}

impl Truth {
    pub fn of(model: &Model) -> Self {
        let sets = PlanningSets::of(model);
        let asked = match model.plan.planner {
            PlannerKind::Rcp => sets.joint.clone(),
            _ => sets.rip.clone(),
        };
        Truth { model: model.clone(), equations: equations(model), asked, sets }
    }

    pub fn mission(&self) -> &Mission {
        self.model.mission.as_ref().expect("every spec here has a mission")
    }

    /// Whether a row to keep is an equality: some set is flat.
    pub fn has_equalities(&self) -> bool {
        self.asked.rows.iter().any(|row| row.equality)
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
        self.of_claim(claim).or_else(|| of_height.map(|_| Falsehood::Height))
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

    /// Whether hover lies outside a set that the spec's reserve shrinks. A set without hover stays as it is where hover is outside,
    /// so that the planner's rows show it.
    pub fn reserves_about_nothing(&self) -> bool {
        let hover = mavc::admissible::hover(&self.model);
        let shrunk = self.asked.rows.iter().chain(self.sets.modes.iter().flat_map(|set| &set.rows));
        let is_outside = |row: &SetRow| row.violation(&hover) > TIMES * ROW;
        self.model.plan.reserve > 0.0 && shrunk.into_iter().any(is_outside)
    }

    fn of_claim(&self, claim: &PlanClaim) -> Option<Falsehood> {
        let Some(motion) = of_record(&claim.motion, self.equations) else { return Some(Falsehood::Shape) };
        let plan = &self.model.plan;
        let selects = plan.planner == PlannerKind::Rsp && plan.rounds > 0 && !plan.against.is_empty();
        let count = claim.selected_by.len();
        let wanted = if selects { 1..=plan.rounds } else { 0..=0 };
        let wrong_count = !wanted.contains(&count);
        let mut before: Vec<Trajectory> = Vec::new();
        for record in &claim.selected_by {
            let Some(other) = of_record(record, self.equations) else { return Some(Falsehood::Shape) };
            if self.of_motion(&other, Role::Selecting).is_some() || self.breaks_selection(&other, &before) {
                return Some(Falsehood::Selection);
            }
            before.push(other);
        }
        let own = self.of_motion(&motion, Role::Asked);
        own.or_else(|| (wrong_count || self.breaks_selection(&motion, &before)).then_some(Falsehood::Selection))
    }

    /// Why a motion is not a plan by itself, if it is not.
    pub fn of_plan(&self, motion: &Trajectory) -> Option<Falsehood> {
        self.of_motion(motion, Role::Asked)
    }

    /// The same of a motion that facets are selected by.
    pub fn of_selecting(&self, motion: &Trajectory) -> Option<Falsehood> {
        self.of_motion(motion, Role::Selecting)
    }

    fn of_motion(&self, motion: &Trajectory, role: Role) -> Option<Falsehood> {
        shaped(motion, self.mission())
            .or_else(|| (!self.on_time(motion)).then_some(Falsehood::Times))
            .or_else(|| (!joins(motion)).then_some(Falsehood::Joints))
            .or_else(|| (!self.rests(motion)).then_some(Falsehood::Rest))
            .or_else(|| (!self.arrives(motion)).then_some(Falsehood::Waypoint))
            .or_else(|| self.broken(motion, role))
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

    /// A waypoint at which the yaw does not follow from the motion within the waypoint's own tolerance, whatever limits the
    /// compiler derives from it.
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
    fn broken(&self, motion: &Trajectory, role: Role) -> Option<Falsehood> {
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
                let rows = self.excesses(motion, k, at, role);
                let over: Vec<Falsehood> = rows.iter().filter(|r| exceeds(r.1, TIMES)).map(|r| r.0).collect();
                let now = motion.times[k] + at;
                if i == 0 || i == between {
                    over.iter().copied().for_each(&mut note);
                }
                since.retain(|(what, _)| over.contains(what));
                // A yaw that follows from the motion is required at nodes alone.
                let is_of_nodes = |what: &Falsehood| match what {
                    Falsehood::Limit(i) => self.mission().limits[*i].kind == LimitKind::Heading,
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

    /// Every kind of row with its largest excess in tolerances, `at` seconds into a piece; in an interval of winds in the worst of
    /// its corners.
    fn excesses(&self, motion: &Trajectory, k: usize, at: f64, role: Role) -> Vec<(Falsehood, f64)> {
        let state = motion.within(k, at);
        let environment = self.model.environment();
        let winds = environment.corners();
        let worst = |of: &dyn Fn(&Environment) -> f64| winds.iter().map(of).fold(f64::NEG_INFINITY, larger);
        let g = self.model.gravity;
        let lift = |wind: &Environment| in_air(&state, wind)[Z][2] + g;
        let limits = self.mission().limits.iter().enumerate().filter(|(_, limit)| self.holds(limit, motion, k, at));
        let mut found: Vec<(Falsehood, f64)> = limits
            .map(|(i, limit)| {
                let over = match (limit.kind, limit.upper) {
                    (LimitKind::Tilt, Some(upper)) => worst(&|wind| {
                        let felt = in_air(&state, wind);
                        (felt[X][2].hypot(felt[Y][2]) * upper.cos() - lift(wind) * upper.sin()) / g
                    }),
                    _ => past(limit, &state, &environment),
                };
                (Falsehood::Limit(i), over / (ROW * limit.size()))
            })
            .collect();
        let rows = if role == Role::Asked { &self.asked.rows } else { &self.sets.rip.rows };
        let vehicle = &self.model.vehicle;
        found.push((Falsehood::Set, worst(&|wind| most(rows, &motion.wrench(vehicle, wind, &state))) / ROW));
        if let Some(tau) = self.model.thrust_lag() {
            let lead = |wind: &Environment| most(rows, &motion.commanded(vehicle, wind, tau, k, &state));
            found.push((Falsehood::Commands, worst(&lead) / ROW));
        }
        if self.equations == WrenchModel::Exact {
            found.push((Falsehood::Upright, worst(&|wind| UPRIGHT - lift(wind) / g) / ROW));
        }
        found
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
        let rows = ends.flat_map(|(k, at)| self.excesses(motion, k, at, Role::Asked));
        rows.map(|r| r.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether a motion to select by keeps its own rows without a tolerance.
    pub fn keeps_own(&self, motion: &Trajectory) -> bool {
        let ends = (0..motion.intervals()).flat_map(|k| [(k, 0.0), (k, motion.times[k + 1] - motion.times[k])]);
        ends.flat_map(|(k, at)| self.excesses(motion, k, at, Role::Selecting)).all(|r| r.1 <= 0.0)
    }

    /// Facets of the modes' sets that some motion is beyond by `share` of the healthy set's width.
    pub fn selected(&self, motions: &[Trajectory], share: f64) -> Vec<SetRow> {
        let parts = if self.equations == WrenchModel::Exact { PARTS } else { 1 };
        let wrench =
            |motion: &Trajectory, s: &NodeState| motion.wrench(&self.model.vehicle, &self.model.environment(), s);
        let seen: Vec<Wrench> = motions
            .iter()
            .flat_map(|motion| {
                let looks = (0..motion.intervals()).flat_map(move |k| (0..=parts).map(move |i| (k, i)));
                looks.map(move |(k, i)| {
                    let h = motion.times[k + 1] - motion.times[k];
                    wrench(motion, &motion.within(k, h * i as f64 / parts as f64))
                })
            })
            .collect();
        let rows = self.sets.modes.iter().flat_map(|set| &set.rows);
        rows.filter(|row| seen.iter().any(|w| row.violation(w) > share)).cloned().collect()
    }

    /// Whether a facet that the motions before are clearly beyond is broken at a node.
    pub fn breaks_selection(&self, motion: &Trajectory, before: &[Trajectory]) -> bool {
        let rows = self.selected(before, TIMES * ROW);
        let beyond = |s: &NodeState| {
            most(&rows, &motion.wrench(&self.model.vehicle, &self.model.environment(), s)) > TIMES * ROW
        };
        motion.nodes.iter().any(beyond)
    }

    /// How far a motion leaves the modes' sets at nodes, as a share of the healthy set's width.
    pub fn beyond_modes(&self, motion: &Trajectory) -> f64 {
        let rows: Vec<SetRow> = self.sets.modes.iter().flat_map(|set| set.rows.clone()).collect();
        let wrenches = motion.node_wrenches(&self.model.vehicle, &self.model.environment());
        wrenches.iter().map(|w| most(&rows, w)).fold(f64::NEG_INFINITY, f64::max)
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
