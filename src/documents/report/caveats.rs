//! Caveats of a plan: limits exceeded between nodes, a coarser grid, an unusual speed, a speed at which drag
//! matters, the linear model outside its range.

use super::battery;
use super::screen::Keep;
use crate::admissible::row::VIOLATED;
use crate::model::{DynamicFigure, LimitKind, Model, USUAL_SPEED};
use crate::motion::NodeState;
use crate::motion::checks::{
    LimitViolation, coarser_legs, limit_violations, linear_range, peak, peak_of, violation_as_checked,
};
use crate::motion::wrench_model::WrenchModel;
use crate::number::{fixed, percent, significant};
use crate::planner::studies::MissionPlan;
use crate::tolerance::MOST_PAST_LIMIT;
use serde::Serialize;

/// A caveat of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Caveat {
    /// What the caveat is about.
    pub kind: CaveatKind,
    /// The exceeded limit, in words; null for other caveats.
    pub limit: Option<String>,
    /// SI: by how much the limit is exceeded; the number of legs with fewer pieces; the highest speed, m/s; the
    /// largest tilt, rad; the smallest thrust, N; the share of the charge that is left; the time during which the
    /// plan is too low, s; how far the plan climbs, strays or begins from the start, m; the largest violation
    /// of a set at an end of the interval of `drag`, in widths of the healthy set, negative where all hold.
    pub value: f64,
    /// The worst instant, s since the start.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// The caveat as a sentence.
    pub message: String,
}

/// What a caveat is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum CaveatKind {
    /// A limit holds at the nodes and is exceeded between them.
    LimitBetweenSamples,
    /// Some leg has fewer pieces than the spec's samples give.
    FewerPieces,
    /// The speed is above 60 m/s, which is unusual for multirotors, and the mission does not limit it.
    Speed,
    /// The plan is faster than 5 m/s and the vehicle has no `drag`.
    NoDrag,
    /// The plan is made for the middle of an interval of `drag`, and holds for no other value for certain.
    DragInterval,
    /// The tilt is over 20 degrees, outside the range of the small-angle approximation.
    Tilt,
    /// The thrust is within 2 % of zero, or negative.
    Thrust,
    /// The plan leaves less charge than the battery's `keep`.
    Charge,
    /// The plan is too low to regain level flight after a fault, as simulated.
    CaptureHeight,
    /// The plan climbs above both waypoints of a leg although no volume is in the way.
    Climb,
    /// The plan strays from a straight leg although no volume is in the way.
    Deviation,
    /// The plan begins away from the start, as the tolerance there allows.
    Start,
}

impl CaveatKind {
    /// Whether the model of the plan does not hold where the plan goes.
    pub fn is_outside_the_model(self) -> bool {
        matches!(self, CaveatKind::Tilt | CaveatKind::Thrust)
    }

    /// How long a screen keeps the caveat: what the model leaves out gives way to what the plan does.
    pub fn keep(self) -> Keep {
        match self {
            CaveatKind::NoDrag | CaveatKind::FewerPieces | CaveatKind::Speed => Keep::Advice,
            _ => Keep::Finding,
        }
    }
}

/// The limits that a plan exceeds between its nodes by more than the check of plans tolerates, in the spec's order.
pub fn exceeded_limits(model: &Model, solved: &MissionPlan) -> Vec<LimitViolation> {
    let limits = model.mission.as_ref().map_or(&[][..], |m| &m.limits);
    let mut exceeded = limit_violations(&solved.trajectory, model, 0.0);
    let environment = model.environment();
    exceeded.retain(|violation| {
        let limit = &limits[violation.limit];
        // A yaw that follows from the motion is required at nodes only.
        if limit.kind.is_heading() {
            return false;
        }
        let Some(mission) = &model.mission else { return false };
        let worst =
            peak_of(limit, mission, &solved.trajectory, |state| violation_as_checked(limit, state, &environment));
        worst.value > MOST_PAST_LIMIT * limit.size()
    });
    exceeded
}

/// The caveat of a grid with fewer pieces than the spec's samples give.
fn coarser(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    let mission = model.mission.as_ref()?;
    let (legs, samples) = (coarser_legs(&solved.trajectory, mission, model.plan.samples), model.plan.samples);
    let message = format!(
        "On {} of {} legs the plan has fewer pieces than {samples} samples give for its waypoint times; `mavc verify` \
         therefore reports a weaker result.",
        legs,
        mission.legs.len()
    );
    let caveat = Caveat { kind: CaveatKind::FewerPieces, limit: None, value: legs as f64, at_s: 0.0, message };
    (legs > 0).then_some(caveat)
}

/// Speed, m/s, from which a plan without `drag` has a caveat. With a drag of 0.35 N s/m the paper's octocopter has to
/// tilt by 5.7 degrees to hold this speed.
const FAST_WITHOUT_AIR: f64 = 5.0;

/// The caveat of an unusually high speed in a mission that does not limit it. Plans ignore air resistance.
fn too_fast(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    let mut limits = model.mission.as_ref()?.limits.iter();
    if limits.any(|limit| limit.kind == LimitKind::Speed && limit.is_general()) {
        return None;
    }
    let speed = peak(&solved.trajectory, speed);
    let message = format!(
        "The plan reaches {} m/s at {} s; multirotors usually stay below {} m/s, and the mission does not limit the \
         speed. Add `limits {{ speed <= ... }}`.",
        significant(speed.value, 3),
        fixed(speed.at, 2),
        significant(USUAL_SPEED, 3)
    );
    let caveat = Caveat { kind: CaveatKind::Speed, limit: None, value: speed.value, at_s: speed.at, message };
    (speed.value > USUAL_SPEED).then_some(caveat)
}

/// The caveat of a plan that leaves too little charge.
fn charge(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    let battery = battery::record(model, &solved.trajectory)?;
    let message = battery.caveat()?;
    let at_s = solved.trajectory.duration();
    Some(Caveat { kind: CaveatKind::Charge, limit: None, value: battery.left, at_s, message })
}

/// The caveat of a plan that is fast enough for drag to matter, of a vehicle without `drag`. `drag = 0 N*s/m` says that
/// it was not forgotten.
fn without_air(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    if model.vehicle.drag_span.is_some() {
        return None;
    }
    let speed = peak(&solved.trajectory, speed);
    let message = format!(
        "The plan reaches {} m/s at {} s and ignores drag: vehicle `{}` has no `drag`.",
        significant(speed.value, 3),
        fixed(speed.at, 2),
        model.vehicle.name
    );
    let caveat = Caveat { kind: CaveatKind::NoDrag, limit: None, value: speed.value, at_s: speed.at, message };
    (speed.value > FAST_WITHOUT_AIR).then_some(caveat)
}

/// The caveat of a plan of a vehicle with an interval of `drag`: no value of it is the worst, because drag slows the
/// vehicle down and the wind acts through it, so that the plan is made for the middle.
fn one_drag(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    let ends = solved.at_ends_of_drag?;
    let (drag, spread) = (DynamicFigure::Drag.largest(&model.vehicle), model.vehicle.drag_spread);
    let [middle, low, high] = [1.0, spread.low, spread.high].map(|share| significant(share * drag, 3));
    let beyond = |(end, violation): (&str, f64)| match violation {
        v if v > VIOLATED => Some(format!("at {end} N*s/m it leaves an admissible set by {} of its width", percent(v))),
        _ => None,
    };
    let left: Vec<String> = [(&*low, ends[0]), (&*high, ends[1])].into_iter().filter_map(beyond).collect();
    let at_ends = match left.is_empty() {
        true => format!("; at {low} and at {high} N*s/m it stays in the same admissible sets"),
        false => format!("; {}", left.join(", ")),
    };
    let message = format!(
        "The plan is made, and proved, for `drag` = {middle} N*s/m alone, the middle of its interval{at_ends}. Measure \
         `drag`, or plan at both ends: `--set drag={low}N*s/m`."
    );
    let value = ends[0].max(ends[1]);
    Some(Caveat { kind: CaveatKind::DragInterval, limit: None, value, at_s: 0.0, message })
}

/// Plans that begin farther from the start than this have a caveat, m: more than twice the tolerance of a waypoint
/// without `within`. Chosen by hand.
pub(super) const AWAY_FROM_START: f64 = 0.1;

/// The caveat of a plan that begins away from the start: flights and figures are those of a vehicle that is there.
fn away_from_start(model: &Model, solved: &MissionPlan) -> Option<Caveat> {
    let start = model.mission.as_ref()?.waypoints.first()?.position;
    let begins = solved.trajectory.nodes.first()?;
    let distance = (0..3).map(|axis| (begins[axis][0] - start[axis]).powi(2)).sum::<f64>().sqrt();
    let message = format!(
        "The plan begins {} m from the start, as the tolerance there allows; the vehicle has to be there first. \
         `within 5 cm` after `start` forbids it.",
        significant(distance, 2)
    );
    let caveat = Caveat { kind: CaveatKind::Start, limit: None, value: distance, at_s: 0.0, message };
    (distance > AWAY_FROM_START).then_some(caveat)
}

/// The speed of a state, m/s.
fn speed(state: &NodeState) -> f64 {
    (0..3).map(|axis| state[axis][1].powi(2)).sum::<f64>().sqrt()
}

/// All caveats of a plan: exceeded limits first, in the spec's order.
pub fn caveats(model: &Model, solved: &MissionPlan) -> Vec<Caveat> {
    let limits = model.mission.as_ref().map_or(&[][..], |m| &m.limits);
    let exceeded = exceeded_limits(model, solved).into_iter().map(|e| {
        let description = limits[e.limit].kind.describe();
        let (unit, factor) = (description.unit, description.factor());
        let name = limits[e.limit].name();
        Caveat {
            kind: CaveatKind::LimitBetweenSamples,
            limit: Some(name.to_string()),
            value: e.by,
            at_s: e.at,
            message: format!(
                "Between samples the {} is exceeded by {} {unit} at {} s; try more samples.",
                if limits[e.limit].is_general() { format!("{name} limit") } else { format!("limit on {name}") },
                significant(e.by * factor, 3),
                fixed(e.at, 2)
            ),
        }
    });
    let all = exceeded.chain(coarser(model, solved)).chain(too_fast(model, solved));
    let all = all.chain(away_from_start(model, solved)).chain(without_air(model, solved));
    let all = all.chain(one_drag(model, solved)).chain(charge(model, solved));
    if solved.trajectory.model == WrenchModel::Exact {
        return all.collect();
    }
    let s = linear_range(&solved.trajectory, model);
    let tilt = s.tilts_too_far().then(|| Caveat {
        kind: CaveatKind::Tilt,
        limit: None,
        value: s.tilt.value,
        at_s: s.tilt.at,
        message: format!(
            "The plan tilts to {} degrees at {} s, and the linear model holds up to about 20: the real wrench differs \
             from the planned one there. Fly slower, limit the tilt or plan with `model = exact`.",
            fixed(s.tilt.value.to_degrees(), 1),
            fixed(s.tilt.at, 2)
        ),
    });
    let thrust = s.nearly_falls().then(|| {
        let share = s.least_thrust.value / s.full_thrust;
        let falls = match share {
            x if x.abs() < 1e-6 => "to zero".to_string(),
            x if x < 0.0 => "below zero".to_string(),
            x => format!("to {} N, {} of full thrust,", significant(s.least_thrust.value, 3), percent(x)),
        };
        Caveat {
            kind: CaveatKind::Thrust,
            limit: None,
            value: s.least_thrust.value,
            at_s: s.least_thrust.at,
            message: format!(
                "Thrust falls {falls} at {} s, outside the linear model's range: tilting does not steer a vehicle \
                 without thrust. Limit the descent or the vertical acceleration.",
                fixed(s.least_thrust.at, 2)
            ),
        }
    });
    all.chain(tilt).chain(thrust).collect()
}
