//! The shape of a plan: greatest height, largest deviation from the straight legs, turning of the yaw; and remarks
//! where it climbs or strays although no volume is in the way.

use super::caveats::{Caveat, CaveatKind};
use super::waypoints;
use crate::explain::detour::{Detour, DetourKind, Forbids, is_cheap};
use crate::model::{Limit, LimitKind, Mission, MissionTime, Problem};
use crate::motion::shape::{Place, Shape};
use crate::motion::time_grid::determined;
use crate::number::{fixed, number, significant};
use crate::planner::studies::MissionPlan;
use serde::Serialize;

/// How high a plan rises, how far it strays from the straight legs, and how far it turns.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShapeRecord {
    pub height: HeightRecord,
    pub deviation: DeviationRecord,
    /// null where no leg has a given yaw at both ends.
    pub yaw: Option<TurnRecord>,
}

/// The greatest height of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct HeightRecord {
    /// The greatest z, m.
    pub z_m: f64,
    /// When it is attained, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// The waypoint where it is attained, from 1; null on a leg.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub waypoint: Option<usize>,
    /// The leg on which it is attained, from 1; leg k arrives at waypoint k + 1. null at a waypoint.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub leg: Option<usize>,
    /// How much higher it is than the highest waypoint, m; negative if the plan stays below it.
    pub above_waypoints_m: f64,
}

/// The largest deviation of a plan from the straight legs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DeviationRecord {
    /// The largest distance from the segment between the two waypoints of a leg, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub distance_m: f64,
    /// On which leg, from 1; leg k arrives at waypoint k + 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub leg: usize,
    /// When, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// Distance between the two waypoints, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub leg_length_m: f64,
}

/// How far the yaw turns on the legs that have a given yaw at both ends.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TurnRecord {
    /// Total variation of the yaw, rad.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub turned_rad: f64,
    /// The least that the waypoints require, rad: the sum of the differences between their yaws.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub required_rad: f64,
}

/// Legs on which a plan climbs or strays although no volume is in the way.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DetourRecord {
    /// climb: above the higher waypoint of the leg. deviation: from the straight line of the leg.
    #[cfg_attr(test, schemars(extend("enum" = ["climb", "deviation"])))]
    pub kind: &'static str,
    /// The legs, from 1, ascending; leg k arrives at waypoint k + 1.
    #[cfg_attr(test, schemars(length(min = 1), inner(range(min = 1))))]
    pub legs: Vec<usize>,
    /// The leg with the largest detour.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub leg: usize,
    /// How far the plan climbs or strays there, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub by_m: f64,
    /// When, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// The statement that forbids it on that leg, in the words of the spec.
    pub statement: String,
    /// Where the statement belongs: the block of limits, or the waypoint at which the leg arrives.
    #[cfg_attr(test, schemars(extend("enum" = ["limits", "waypoint"])))]
    pub place: &'static str,
    /// Mission time, s, of a plan that was found with the statements against all detours; null if none was found or
    /// searched for.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub found_with_it_s: Option<f64>,
}

/// The record of a plan.
pub fn record(problem: Problem, solved: &MissionPlan) -> ShapeRecord {
    let shape = Shape::of(&solved.trajectory, problem.mission());
    let leg = shape.farthest();
    let (waypoint, on_leg) = match shape.top_place {
        Place::Waypoint(waypoint) => (Some(waypoint + 1), None),
        Place::Leg(leg) => (None, Some(leg + 1)),
    };
    ShapeRecord {
        height: HeightRecord {
            z_m: shape.top.value,
            at_s: shape.top.at,
            waypoint,
            leg: on_leg,
            above_waypoints_m: shape.above,
        },
        deviation: DeviationRecord {
            distance_m: shape.legs[leg].deviation.value,
            leg: leg + 1,
            at_s: shape.legs[leg].deviation.at,
            leg_length_m: shape.legs[leg].length,
        },
        yaw: shape.yaw.map(|yaw| TurnRecord { turned_rad: yaw.turned, required_rad: yaw.required }),
    }
}

/// Metres to a centimetre, with at most `digits` digits.
fn metres(value: f64, digits: usize) -> String {
    format!("{} m", significant((100.0 * value).round() / 100.0, digits))
}

/// Degrees to a tenth.
fn degrees(value: f64) -> String {
    format!("{} deg", significant((10.0 * value.to_degrees()).round() / 10.0, 4))
}

/// ``waypoint 3 `mast` ``; `index` from 0.
fn waypoint(mission: &Mission, index: usize) -> String {
    waypoints::waypoint(index + 1, mission.waypoints[index].name.as_deref())
}

/// `leg to waypoint 3 mast`; `leg` from 1.
fn leg_to(mission: &Mission, leg: usize) -> String {
    format!("leg to {}", waypoint(mission, leg))
}

impl HeightRecord {
    /// `40.1 m`
    pub fn value(&self) -> String {
        metres(self.z_m, 5)
    }

    /// `15.1 m above the highest waypoint`
    pub fn relation(&self) -> String {
        match (100.0 * self.above_waypoints_m).round() {
            0.0 => "that of the highest waypoint".into(),
            above if above > 0.0 => format!("{} above the highest waypoint", metres(self.above_waypoints_m, 3)),
            _ => format!("{} below the highest waypoint", metres(-self.above_waypoints_m, 3)),
        }
    }

    /// `leg to waypoint 3, 12.31 s`
    pub fn place(&self, mission: &Mission) -> String {
        let place = match (self.waypoint, self.leg) {
            (None, Some(leg)) => leg_to(mission, leg),
            (number, _) => waypoint(mission, number.map_or(0, |number| number - 1)),
        };
        format!("{place}, {} s", fixed(self.at_s, 2))
    }
}

impl DeviationRecord {
    /// `7.2 m`
    pub fn value(&self) -> String {
        metres(self.distance_m, 3)
    }

    /// `leg to waypoint 3, 9.87 s`
    pub fn place(&self, mission: &Mission) -> String {
        format!("{}, {} s", leg_to(mission, self.leg), fixed(self.at_s, 2))
    }
}

impl TurnRecord {
    /// `93 deg`
    pub fn value(&self) -> String {
        degrees(self.turned_rad)
    }

    /// `the waypoints require 90 deg`
    pub fn relation(&self) -> String {
        format!("the waypoints require {}", degrees(self.required_rad))
    }
}

/// Terminal text: a line for each figure.
pub fn text(problem: Problem, solved: &MissionPlan) -> String {
    let mission = problem.mission();
    let ShapeRecord { height, deviation, yaw } = record(problem, solved);
    let yaw = yaw.map_or(String::new(), |yaw| format!("  yaw turns {}; {}\n", yaw.value(), yaw.relation()));
    format!(
        "  height up to {}, {} ({})\n  up to {} from the straight leg ({})\n{yaw}",
        height.value(),
        height.relation(),
        height.place(mission),
        deviation.value(),
        deviation.place(mission)
    )
}

/// The statement against a detour in the words of the spec, and where it belongs.
fn statement(mission: &Mission, forbids: Forbids) -> (String, &'static str) {
    let bounds_height = |limit: &&Limit| limit.kind == LimitKind::Z && limit.is_general() && limit.volume.is_none();
    match forbids {
        Forbids::Altitude(height) => {
            let lower = mission.limits.iter().find(bounds_height).and_then(|limit| limit.lower);
            let bound = match lower {
                Some(lower) => format!("altitude in {} m .. {} m", number(lower), number(height)),
                None => format!("altitude <= {} m", number(height)),
            };
            (bound, "limits")
        }
        Forbids::AltitudeOfLeg(height) => (format!("{{ altitude <= {} m }}", number(height)), "waypoint"),
        Forbids::Corridor(radius) => (format!("corridor {} m", number(radius)), "waypoint"),
    }
}

/// The records of the detours of a plan.
pub fn detour_records(problem: Problem, detours: &[Detour]) -> Vec<DetourRecord> {
    let record = |detour: &Detour| {
        let (statement, place) = statement(problem.mission(), detour.forbids);
        DetourRecord {
            kind: match detour.kind {
                DetourKind::Climb => "climb",
                DetourKind::Deviation => "deviation",
            },
            legs: detour.legs.iter().map(|leg| leg + 1).collect(),
            leg: detour.leg + 1,
            by_m: detour.by,
            at_s: detour.at,
            statement,
            place,
            found_with_it_s: detour.tried,
        }
    };
    detours.iter().map(record).collect()
}

/// What a quick search with the statements against all detours found, with `with` for these statements: `. A quick
/// search with it found a plan of 91.2 s, 1.1 s longer`, or that it found none or was not attempted.
fn price(problem: Problem, solved: &MissionPlan, detour: &Detour, with: &str) -> String {
    let Some(time) = detour.tried else {
        return match is_cheap(problem) {
            true => format!(". A quick search {with} found no plan"),
            false => ". No value was tried".into(),
        };
    };
    if detour.covers_less {
        return format!(". A quick search {with} found only a plan that covers fewer fault modes");
    }
    let is_fixed =
        matches!(problem.model().plan.time, MissionTime::Fixed(_)) || determined(problem.mission()).is_some();
    let longer = (100.0 * (time - solved.time)).round() / 100.0;
    let found = match longer {
        _ if is_fixed => "a plan at the same time".to_string(),
        longer if longer > 0.0 => format!("a plan of {} s, {} s longer", number(time), significant(longer, 3)),
        _ => format!("a plan of {} s, which is not longer", number(time)),
    };
    format!(". A quick search {with} found {found}")
}

/// The statement of one detour for [`price`].
fn alone(detour: &Detour) -> &'static str {
    match detour.legs.len() {
        2.. if !matches!(detour.forbids, Forbids::Altitude(_)) => "with it on each of these legs",
        _ => "with it",
    }
}

/// `climbs 2.3 m above both waypoints of the leg to waypoint 3, at 12.31 s`
fn what(mission: &Mission, detour: &Detour) -> String {
    let (leg, by) = (leg_to(mission, detour.leg + 1), metres(detour.by, 3));
    let at = fixed(detour.at, 2);
    let others = match detour.legs.len() - 1 {
        0 => String::new(),
        1 => " (and 1 more leg)".into(),
        n => format!(" (and {n} more legs)"),
    };
    match detour.kind {
        DetourKind::Climb => format!("climbs {by} above both waypoints of the {leg}{others}, at {at} s"),
        DetourKind::Deviation => format!("strays {by} from the straight {leg}{others}, at {at} s"),
    }
}

/// `` `corridor 2 m` on waypoint 6 ``: what forbids a detour; without a value unless it was tried.
fn forbidden_by(mission: &Mission, detour: &Detour) -> String {
    let (statement, _) = statement(mission, detour.forbids);
    let arrival = format!("waypoint {}", detour.leg + 2);
    match (detour.forbids, detour.tried) {
        (Forbids::Altitude(_), Some(_)) => format!("`{statement}` in `limits`"),
        (Forbids::Altitude(_), None) => "`altitude <= ...` in `limits`".into(),
        (Forbids::AltitudeOfLeg(_), Some(_)) => format!("`{statement}` after {arrival}"),
        (Forbids::AltitudeOfLeg(_), None) => format!("`{{ altitude <= ... }}` after {arrival}"),
        (Forbids::Corridor(_), Some(_)) => format!("`{statement}` on {arrival}"),
        (Forbids::Corridor(_), None) => format!("`straight` or `corridor ...` on {arrival}"),
    }
}

/// The remarks about the detours of a plan.
pub fn caveats(problem: Problem, solved: &MissionPlan, detours: &[Detour]) -> Vec<Caveat> {
    let mission = problem.mission();
    let caveat = |detour: &Detour| {
        let kind = match detour.kind {
            DetourKind::Climb => CaveatKind::Climb,
            DetourKind::Deviation => CaveatKind::Deviation,
        };
        let with = if detours.len() > 1 { "with the statements of both remarks" } else { alone(detour) };
        let message = format!(
            "The plan {}, although no volume is in the way; {} forbids it{}.",
            what(mission, detour),
            forbidden_by(mission, detour),
            price(problem, solved, detour, with)
        );
        Caveat { kind, limit: None, value: detour.by, at_s: detour.at, message }
    };
    detours.iter().map(caveat).collect()
}

/// The remarks of [`caveats`] as one; `None` without detours.
pub fn remark(problem: Problem, solved: &MissionPlan, detours: &[Detour]) -> Option<String> {
    let mission = problem.mission();
    match detours {
        [climb, deviation] => Some(format!(
            "The plan {}, and {}, although no volume is in the way; {} and {} forbid it{}.",
            what(mission, climb),
            what(mission, deviation),
            forbidden_by(mission, climb),
            forbidden_by(mission, deviation),
            price(problem, solved, climb, "with both")
        )),
        _ => caveats(problem, solved, detours).into_iter().map(|caveat| caveat.message).next(),
    }
}
