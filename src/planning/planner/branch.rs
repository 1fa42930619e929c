//! Branches: motions that leave a plan after a fault, inside the admissible set of the fault mode.
//!
//! When a fault strikes, position, velocity, attitude, body rates, yaw and its rate do not change; thrust and torques
//! may jump. A branch ends at rest or joins a motion. Its duration is given, so several are tried. A branch that is
//! found is checked by plain evaluation at the instants of its grid; if none is found, one may still exist.

mod ends;

use crate::admissible::AdmissibleSet;
use crate::admissible::without_yaw::early::Begins;
use crate::admissible::without_yaw::planned::PlannedCore;
use crate::model::grid::Spacing;
use crate::model::{
    DistanceFrom, Heading, HeldLimit, Leg, Limit, LimitKind, Mission, Model, OnLeg, Part, Problem, STOPS_TURNING,
    TOUCHDOWN, Waypoint,
};
use crate::motion::checks::violation;
use crate::motion::time_grid::{LegGrid, TimeGrid};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::settings::StopSettings;
use crate::planner::scp::{Iterate, ScpPlanner, ScpSettings};
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::UNBOUNDED;
use crate::solve::Effort;
use crate::source::Span;
use std::sync::Arc;

/// The state in which a branch begins, and how it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    pub from: NodeState,
    pub to: Ending,
}

/// How a branch ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending {
    /// Level, without velocity and body rates, where limits allow it.
    Rest,
    /// In this state.
    Joins(NodeState),
}

/// What a branch leads to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// The state of a plan at some instant.
    Rejoin(NodeState),
    /// Rest anywhere.
    Rest,
    /// The ground: rest within `radius` (m) of `at` (m), coming down from above it.
    Ground { at: [f64; 3], radius: f64 },
}

/// A descent begins at most this high above its place of landing, m, and within the radius of it. Chosen by hand.
const DESCENT_FROM: f64 = 3.0;

/// The mean speed of a descent as a share of the limit on it, or of [`DESCENT_SPEED`]. Chosen by hand.
const DESCENT_SHARE: f64 = 0.4;

/// The fastest descent that is tried, m/s, whatever the limit. Chosen by hand.
const DESCENT_SPEED: f64 = 2.0;

/// The least time of a descent, s. Chosen by hand.
const SHORTEST_DESCENT: f64 = 1.5;

/// A branch to the ground begins with a part in which body rates are stopped and one in which the vehicle is levelled,
/// s; both need short steps. Chosen by hand.
const TURN: f64 = 0.5;
const LEVEL: f64 = 1.0;

/// The shortest part between these and the descent, s. Chosen by hand.
const SHORTEST_WAY: f64 = 0.5;

/// Distances to the middle of a place of landing count in radii of it, which count as this much at least, m. Chosen by
/// hand.
const SMALLEST_PLACE: f64 = 0.1;

/// About the length of an interval in that part, s, and its least and largest number of intervals. Chosen by hand.
const STEP_OF_WAY: f64 = 0.8;
const INTERVALS_OF_WAY: [usize; 2] = [4, 12];

/// Intervals of a descent. Chosen by hand.
const INTERVALS_OF_DESCENT: usize = 8;

/// Limits are widened by this share of themselves, places by this much (m or rad): a plan holds them to tolerances
/// only, and a fault may strike at a limit. Chosen by hand.
const LEEWAY: f64 = 1e-4;

/// What branches keep free at the instants of their grids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Room {
    /// From the facets of the mode's set, in widths of the healthy set.
    pub of_set: f64,
    /// From limits, as a share of these.
    pub of_limits: f64,
    /// From limits on places, m or rad.
    pub of_places: f64,
    /// From the ground, m.
    pub of_ground: f64,
}

impl Room {
    /// Hardly any. Between instants branches were seen up to 3.5e-4 outside the set. Chosen by hand.
    pub const LITTLE: Room = Room { of_set: 1e-3, of_limits: -LEEWAY, of_places: -LEEWAY, of_ground: 0.0 };

    /// A set with this room.
    fn of(self, mut set: PlanningSet) -> PlanningSet {
        set.rows.iter_mut().filter(|row| !row.equality).for_each(|row| row.offset -= self.of_set);
        set
    }

    /// What families of branches need, whose motions are shown to hold limits at every instant. Chosen by hand.
    pub const WIDE: Room = Room { of_set: 0.03, of_limits: 0.02, of_places: 0.05, of_ground: 0.25 * TOUCHDOWN };
}

/// Looks for branches inside the set of one fault mode.
pub struct Branches<'a> {
    /// The problem of the plan; the limits of its mission are replaced by `limits`.
    problem: Problem<'a>,
    healthy: &'a AdmissibleSet,
    /// The admissible set of the fault mode, as far as branches may use it.
    set: PlanningSet,
    /// The mode's core, if it gives up yaw.
    core: Option<&'a PlannedCore>,
    /// The wrench model of the plan, and of branches.
    wrench: WrenchModel,
    /// The limits that hold on branches.
    limits: Vec<HeldLimit>,
    room: Room,
    pub effort: Effort,
}

impl<'a> Branches<'a> {
    /// `set` is the admissible set of the fault mode, `wrench` the model that the plan was made with.
    pub fn new(
        problem: Problem<'a>,
        healthy: &'a AdmissibleSet,
        set: &PlanningSet,
        room: Room,
        wrench: WrenchModel,
        limits: Vec<HeldLimit>,
    ) -> Self {
        let within = |held: HeldLimit| HeldLimit { limit: room.within(&held.limit), ..held };
        let limits = limits.into_iter().map(within).collect();
        let set = room.of(set.clone());
        Branches { problem, healthy, set, core: None, wrench, limits, room, effort: Effort::default() }
    }

    /// With the core of the mode, whose rows are wider for short branches: yaw has just been given up.
    pub fn with_core(self, core: Option<&'a PlannedCore>) -> Self {
        Branches { core, ..self }
    }

    /// A branch of `duration` s from a state to a goal; `None` if none is found.
    pub fn find(&mut self, from: &NodeState, goal: &Goal, duration: f64) -> Option<Iterate> {
        self.attempt(from, goal, duration, |steps, grid| match goal {
            Goal::Ground { at, .. } => steps.branch_along(grid, position(from), *at),
            Goal::Rejoin(_) | Goal::Rest => steps.branch(grid),
        })
    }

    /// A branch with another one as the initial guess, and its duration; `None` if none is found.
    pub fn find_about(&mut self, from: &NodeState, goal: &Goal, other: &Iterate) -> Option<Iterate> {
        self.attempt(from, goal, other.grid.total, |steps, grid| {
            (other.grid.node_times == grid.node_times).then(|| steps.branch_about(other.clone()))?
        })
    }

    fn attempt(
        &mut self,
        from: &NodeState,
        goal: &Goal,
        duration: f64,
        steps: impl FnOnce(&mut ScpPlanner, &TimeGrid) -> Option<Iterate>,
    ) -> Option<Iterate> {
        let mut settings = ScpSettings::DEFAULT;
        settings.subproblem.slack_of_working_set = settings.stops.slack_of_working_set;
        settings.subproblem.many_facets = settings.stops.many_facets;
        let course = self.course(from, goal, duration, &settings.stops)?;
        let model = self.problem.with_mission(course.mission);
        let problem = Problem::of(&model)?;
        let grid = TimeGrid::with_legs(problem.mission(), &course.legs, duration);
        let to = match goal {
            Goal::Rejoin(state) => Ending::Joins(*state),
            Goal::Rest | Goal::Ground { .. } => Ending::Rest,
        };
        let early = self.core.and_then(|core| early_set(problem.model(), self.wrench, core, from, duration));
        let early = early.map(|set| self.room.of(set));
        let set = early.as_ref().unwrap_or(&self.set);
        let mut hover = HoverPlanner::new(problem, self.healthy);
        hover.branch = Some(Branch { from: *from, to });
        let found = steps(&mut ScpPlanner::with_settings(&mut hover, self.wrench, set, settings), &grid);
        self.effort += hover.effort;
        found
    }

    /// A branch as a mission, whose waypoints only divide its duration: the way in parts, then a descent to the ground
    /// if it leads there. `None` where the duration is too short for its descent.
    fn course(&self, from: &NodeState, goal: &Goal, duration: f64, settings: &StopSettings) -> Option<Course> {
        let mut limits = self.limits_from(from, matches!(goal, Goal::Ground { .. }));
        let mut legs: Vec<LegGrid> = match goal {
            Goal::Rejoin(_) | Goal::Rest => {
                let all: f64 = settings.shares.iter().sum();
                let of_part = |share| LegGrid::new(duration * share / all, settings.intervals_per_part);
                settings.shares.map(of_part).to_vec()
            }
            Goal::Ground { at, .. } => {
                let way = duration - self.descent_time((from[Z][0] - at[2]).clamp(0.0, DESCENT_FROM));
                let [turn, level, rest] = [TURN, LEVEL, way - TURN - LEVEL];
                if rest < SHORTEST_WAY {
                    return None;
                }
                let intervals = ((rest / STEP_OF_WAY).round() as usize).clamp(INTERVALS_OF_WAY[0], INTERVALS_OF_WAY[1]);
                vec![LegGrid::new(turn, 5), LegGrid::new(level, 4), LegGrid::new(rest, intervals)]
            }
        };
        if let Goal::Ground { at, radius } = *goal {
            let parts = legs.len();
            let above = (from[Z][0] - at[2]).clamp(0.0, DESCENT_FROM);
            legs.push(LegGrid::new(self.descent_time(above), INTERVALS_OF_DESCENT));
            let size = self.problem.model().vehicle.radius();
            let inside = self.room.of_places.max(0.0);
            let floor = if from[Z][0] > at[2] + size + inside { at[2] + size + inside } else { at[2] };
            let (ground, inner) = (at[2] + self.room.of_ground, radius - inside);
            let on = |leg: usize, part: Part, kind: LimitKind, lower: Option<f64>, upper: Option<f64>| {
                let on = OnLeg { leg, part, name: "landing".into() };
                Limit { kind, lower, upper, span: Span::default(), volume: None, leg: Some(Arc::new(on)) }
            };
            let axis = LimitKind::Distance(DistanceFrom::Axis([at[0], at[1]]));
            limits
                .extend((0..parts).map(|leg| on(leg, Part::Whole, LimitKind::Z, Some(floor.min(at[2] + above)), None)));
            limits.push(on(parts, Part::Start, LimitKind::Z, Some(at[2] + 0.9 * above), None));
            limits.push(on(parts, Part::Whole, axis, None, Some(inner)));
            limits.push(on(parts, Part::Whole, LimitKind::Z, Some(ground), None));
            limits.push(on(parts, Part::End, LimitKind::Z, None, Some(at[2] + TOUCHDOWN)));
        }
        let flown = self.problem.mission();
        let waypoint = Waypoint {
            name: None,
            position: position(from),
            yaw: from[YAW][0],
            within: UNBOUNDED,
            yaw_within: UNBOUNDED,
            weight: 0.0,
            time: None,
            hold: 0.0,
            stop: false,
            heading: Heading::Given,
            span: flown.span,
            time_span: None,
            hold_span: None,
        };
        let mut waypoints = vec![waypoint; legs.len() + 1];
        if let (Goal::Ground { at, radius }, Some(last)) = (*goal, waypoints.last_mut()) {
            // The middle of the place is preferred: by the initial guess, and by every step.
            (last.position, last.weight) = (at, radius.max(SMALLEST_PLACE).powi(-2));
        }
        let mission = Mission {
            waypoints,
            legs: legs.iter().map(|leg| Leg { share: leg.duration }).collect(),
            spacing: Spacing::Even,
            start_at_rest: false,
            end_at_rest: false,
            limits,
            ..flown.clone()
        };
        Some(Course { mission, legs })
    }

    /// The limits on a branch from a state: each widened as far as it yields to that state, and without lower bounds on
    /// the height if the branch `lands`.
    fn limits_from(&self, from: &NodeState, lands: bool) -> Vec<Limit> {
        let environment = self.problem.model().environment();
        let of = |held: &HeldLimit| {
            let over = violation(&held.limit, from, &environment);
            let over = match held.limit.kind {
                LimitKind::Tilt => over + turns_further(from, environment.gravity),
                _ => over,
            };
            let by = if over > 0.0 { (over + LEEWAY * over.max(1.0)).min(held.yields) } else { 0.0 };
            let limit = held.limit.widened(by);
            match lands && limit.kind == LimitKind::Z {
                true => Limit { lower: None, ..limit },
                false => limit,
            }
        };
        let all = self.limits.iter().map(of);
        all.filter(|limit| limit.lower.is_some() || limit.upper.is_some()).collect()
    }

    /// The smallest upper bound on quantities of these kinds, or `otherwise`.
    fn bound(&self, kinds: &[LimitKind], otherwise: f64) -> f64 {
        let limits = self.limits.iter().map(|held| &held.limit).filter(|limit| kinds.contains(&limit.kind));
        limits.filter_map(|limit| limit.upper).fold(otherwise, f64::min)
    }

    /// The time of a descent from a height, s.
    fn descent_time(&self, height: f64) -> f64 {
        let speed = self.bound(&[LimitKind::Descent], DESCENT_SPEED);
        (height / (DESCENT_SHARE * speed)).max(SHORTEST_DESCENT)
    }

    /// A duration in which a branch may well reach its goal, s: the distances at half of the speeds that limits allow,
    /// and time to turn and to come to rest.
    pub fn likely_duration(&self, from: &NodeState, goal: &Goal) -> f64 {
        let speed = self.bound(&[LimitKind::Speed, LimitKind::SpeedHorizontal], SPEED_WITHOUT_LIMIT);
        let moving = [X, Y, Z].map(|axis| from[axis][1]).iter().map(|v| v * v).sum::<f64>().sqrt();
        let turning = SHORTEST_TURN + moving / BRAKING;
        match goal {
            Goal::Rejoin(_) | Goal::Rest => turning,
            Goal::Ground { at, .. } => {
                let aside = (from[X][0] - at[0]).hypot(from[Y][0] - at[1]);
                let above = (from[Z][0] - at[2]).max(0.0);
                let last = above.min(DESCENT_FROM);
                let down = (above - last) / (0.5 * self.bound(&[LimitKind::Descent], SPEED_WITHOUT_LIMIT));
                turning + (aside / (0.5 * speed)).max(down) + self.descent_time(last)
            }
        }
    }
}

/// The set of a core for a branch of `duration` s from a state; `None` where the
/// core's own holds.
pub fn early_set(
    model: &Model,
    wrench: WrenchModel,
    core: &PlannedCore,
    from: &NodeState,
    duration: f64,
) -> Option<PlanningSet> {
    let begins = Begins::of(&wrench.turning(&model.vehicle, &model.environment(), from));
    Some(PlanningSet { rows: core.rows_for(model, begins, duration)? })
}

/// By how much a vehicle tilts further before its turning is stopped, rad, at about the rate at which its thrust turns.
fn turns_further(state: &NodeState, gravity: f64) -> f64 {
    let rate = state[X][3].hypot(state[Y][3]) / (state[X][2].powi(2) + state[Y][2].powi(2) + gravity.powi(2)).sqrt();
    rate * rate / (2.0 * STOPS_TURNING)
}

/// Speed where no limit bounds it, m/s. Chosen by hand.
const SPEED_WITHOUT_LIMIT: f64 = 8.0;

/// Time to turn at any speed, s. Chosen by hand.
const SHORTEST_TURN: f64 = 1.0;

/// Deceleration, m/s^2. Chosen by hand.
const BRAKING: f64 = 3.0;

/// A branch as a mission, and the grids of its legs.
struct Course {
    mission: Mission,
    legs: Vec<LegGrid>,
}

fn position(state: &NodeState) -> [f64; 3] {
    [state[X][0], state[Y][0], state[Z][0]]
}

impl Room {
    /// A limit with this room kept free.
    fn within(self, limit: &Limit) -> Limit {
        let by = |bound: f64| if limit.kind.is_of_place() { self.of_places } else { self.of_limits * bound.abs() };
        Limit { lower: limit.lower.map(|b| b + by(b)), upper: limit.upper.map(|b| b - by(b)), ..limit.clone() }
    }
}
