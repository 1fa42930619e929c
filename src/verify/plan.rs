//! Decides what a certificate claims of a plan: here its motion, in `bounds` what is bounded along it.

mod bounds;

use super::interval::{Interval, exceeds};
use super::motion::{Motion, X, Y, YAW, Z};
use super::proof::{Budget, Family, holds, kept};
use super::wrench::{Dynamics, Held};
use super::{Rejection, Shown, lag, mode_named, required};
use crate::certificate::{Bound, DynamicModel, MotionRecord, PlanClaim};
use crate::model::{Mission, MissionTime, Model};
use crate::report::number::number;
use crate::source::Span;

use bounds::Direction;
use std::collections::BTreeSet;

pub use bounds::wrench_family;

/// Pieces of a plan join within this, m and rad.
pub const MOST_GAP: f64 = 1e-5;
/// A waypoint may be missed by this beside its tolerance, m and rad.
pub const MOST_MISS: f64 = 1e-5;
/// A limit may be passed by this at the nodes, in its SI unit, and by this share of itself.
pub const MOST_PAST_LIMIT: f64 = 1e-4;
/// A set may be left by this share of the healthy set's width, as reports count violations.
pub const MOST_OUTSIDE: f64 = 1e-4;
/// Two instants are one, s.
const SAME_TIME: f64 = 1e-9;
/// Evaluations that one certificate may cost.
pub const EVALUATIONS: usize = 200_000_000;

/// Decides claims about one motion.
pub struct Checker<'a> {
    model: &'a Model,
    mission: &'a Mission,
    dynamics: Dynamics<'a>,
    motion: Motion,
    /// Of rotors that lag.
    commands: Option<Held>,
    budget: Budget,
    triples: usize,
    /// Of the facets decided.
    directions: BTreeSet<Direction>,
}

impl<'a> Checker<'a> {
    pub fn new(
        model: &'a Model,
        mission: &'a Mission,
        kind: DynamicModel,
        motion: &MotionRecord,
    ) -> Result<Self, Rejection> {
        let motion = Motion::new(motion, kind).map_err(|why| Rejection::new("the motion", why))?;
        let first = mission.waypoints.first().map_or(0.0, |w| w.yaw);
        // As the language says: one yaw throughout is linearised there.
        let one_yaw = mission.waypoints.iter().all(|w| (w.yaw - first).abs() < 1e-12).then_some(first);
        let dynamics = Dynamics { vehicle: &model.vehicle, gravity: model.gravity, model: kind, one_yaw };
        let commands = lag::constant(model).map(|tau| Held::Commands { tau });
        Ok(Checker {
            model,
            mission,
            dynamics,
            motion,
            commands,
            budget: Budget(EVALUATIONS),
            triples: 0,
            directions: BTreeSet::new(),
        })
    }

    /// What turns the motion into wrenches.
    pub fn dynamics(&self) -> &Dynamics<'a> {
        &self.dynamics
    }

    /// What rotors are commanded, where they lag.
    pub fn commands(&self) -> Option<Held> {
        self.commands
    }

    /// So many evaluations from now on, and as many sets as at first.
    pub fn allow(&mut self, evaluations: usize) {
        self.budget = Budget(evaluations);
        self.triples = 0;
    }

    /// Evaluations that are left.
    pub fn left(&self) -> usize {
        self.budget.0
    }

    /// The quantities of a family that are shown to keep to a bound along the motion.
    pub fn kept(&mut self, family: &Family, bound: &Bound) -> Vec<usize> {
        kept(family, &self.motion, bound, &mut self.budget)
    }

    /// Whether all quantities of a family are shown to keep to a bound along the motion.
    pub fn keeps(&mut self, family: &Family, bound: &Bound) -> bool {
        holds(family, &self.motion, bound, &mut self.budget).is_ok()
    }

    /// Everything that is claimed, and that nothing is missing.
    pub fn decide(&mut self, claim: &PlanClaim) -> Result<Vec<Shown>, Rejection> {
        self.times()?;
        self.joins(claim)?;
        self.rest()?;
        self.waypoints(claim)?;
        let mut shown = vec![
            Shown::at_nodes(format!("{} pieces join", self.motion.pieces())),
            Shown::at_nodes(format!(
                "{} waypoints met, and rest where the spec asks for it",
                self.mission.waypoints.len()
            )),
        ];
        if claim.limits.len() != self.mission.limits.len() {
            let counts = format!(
                "the mission has {}, the certificate tells of {}",
                self.mission.limits.len(),
                claim.limits.len()
            );
            return Err(Rejection::new("the limits", counts));
        }
        for (index, limit) in claim.limits.iter().enumerate() {
            let reach = self.limit(index, limit)?;
            shown.push(Shown::new(format!("limit on {}", limit.limit), reach));
        }
        for mode in required(self.model) {
            if !claim.sets.iter().any(|s| s.mode == mode) {
                let why = "the planner is to stay inside it, and the certificate says nothing of it".to_string();
                return Err(Rejection {
                    span: self.span_of(&mode),
                    ..Rejection::new(format!("the set of {mode}"), why)
                });
            }
        }
        self.sets(&claim.sets, &mut shown)?;
        self.facets(&claim.facets, &mut shown)?;
        Ok(shown)
    }

    fn span_of(&self, mode: &str) -> Option<Span> {
        mode_named(self.model, mode).map(|m| m.span)
    }

    /// Node times: from zero, with fixed arrivals, holds and the mission's time as the spec says.
    fn times(&self) -> Result<(), Rejection> {
        let (times, nodes) = (&self.motion.times, &self.motion.waypoint_nodes);
        let wrong = |why: String, span: Option<Span>| Err(Rejection { span, ..Rejection::new("the times", why) });
        let points = &self.mission.waypoints;
        if times[0] != 0.0 {
            return wrong(format!("the motion begins at {} s", number(times[0])), None);
        }
        let within = nodes.iter().all(|&n| n < times.len()) && nodes.windows(2).all(|w| w[0] < w[1]);
        if nodes.len() != points.len() || !within || nodes.first() != Some(&0) {
            return wrong(
                "each waypoint needs a node of its own, in flight order, the first at the start".into(),
                None,
            );
        }
        for (i, (point, &node)) in points.iter().zip(nodes).enumerate() {
            if let Some(fixed) = point.time.filter(|t| exceeds((t - times[node]).abs(), SAME_TIME * t.max(1.0))) {
                let why = format!(
                    "waypoint {} is due at {} s and reached at {} s",
                    i + 1,
                    number(fixed),
                    number(times[node])
                );
                return wrong(why, point.time_span);
            }
            let Some(leaves) = self.held_until(i) else {
                let why = format!("the motion does not stay {} s at waypoint {}", number(point.hold), i + 1);
                return wrong(why, point.hold_span);
            };
            if i + 1 == points.len() && leaves + 1 != times.len() {
                return wrong("the motion goes on after the last waypoint".into(), Some(point.span));
            }
        }
        match self.model.plan.time {
            MissionTime::Fixed(total)
                if exceeds((total - times[times.len() - 1]).abs(), SAME_TIME * total.max(1.0)) =>
            {
                let why = format!(
                    "the mission is to take {} s and takes {} s",
                    number(total),
                    number(times[times.len() - 1])
                );
                wrong(why, Some(self.model.plan.time_span))
            }
            _ => Ok(()),
        }
    }

    /// The node at which a waypoint's hold ends; its own where there is none.
    fn held_until(&self, waypoint: usize) -> Option<usize> {
        let node = self.motion.waypoint_nodes[waypoint];
        let hold = self.mission.waypoints[waypoint].hold;
        let ends = self.motion.times[node] + hold;
        let is_end = |&n: &usize| (self.motion.times[n] - ends).abs() <= SAME_TIME * ends.max(1.0);
        if hold > 0.0 { (node + 1..self.motion.times.len()).find(is_end) } else { Some(node) }
    }

    fn joins(&self, claim: &PlanClaim) -> Result<(), Rejection> {
        allowed("joins_within", claim.joins_within, MOST_GAP, "(m or rad)")?;
        if claim.joins_within < 0.0 {
            return Err(Rejection::new(
                "joins_within",
                format!("{} (m or rad) is below zero", number(claim.joins_within)),
            ));
        }
        for piece in 0..self.motion.pieces() {
            let gap = self.motion.gap(piece);
            if exceeds(gap, claim.joins_within) {
                let why = format!(
                    "piece {} misses the next by {} (m or rad), not by {} at most",
                    piece + 1,
                    number(gap),
                    number(claim.joins_within)
                );
                return Err(Rejection { at: Some(self.motion.times[piece + 1]), ..Rejection::new("the pieces", why) });
            }
        }
        Ok(())
    }

    /// Rest at both ends (unless `moving`) and in holds: derivatives are zero, in holds the inputs too.
    fn rest(&self) -> Result<(), Rejection> {
        let last = self.motion.times.len() - 1;
        let ends = [(0, self.mission.start_at_rest), (last, self.mission.end_at_rest)];
        let mut still: Vec<(usize, bool)> = ends.iter().filter(|e| e.1).map(|e| (e.0, false)).collect();
        for (i, point) in self.mission.waypoints.iter().enumerate().filter(|(_, w)| w.hold > 0.0) {
            let until = self.held_until(i).unwrap_or(self.motion.waypoint_nodes[i]);
            if until == self.motion.waypoint_nodes[i] {
                let why = format!("the motion does not stay at waypoint {}", i + 1);
                return Err(Rejection { span: point.hold_span, ..Rejection::new("rest", why) });
            }
            still.extend((self.motion.waypoint_nodes[i]..=until).map(|node| (node, true)));
        }
        for (node, held) in still {
            for axis in [X, Y, Z, YAW] {
                // At rest the jerk vanishes beside velocity and acceleration, where it is no input's slope.
                let highest = if held { self.motion.order(axis) } else { self.motion.order(axis).min(3) };
                if let Some(order) = (1..=highest).find(|&i| self.motion.at_node(node, axis, i) != 0.0) {
                    let name = ["x", "y", "z", "yaw"][axis];
                    let why = format!("derivative {order} of {name} is not zero");
                    return Err(Rejection { at: Some(self.motion.times[node]), ..Rejection::new("rest", why) });
                }
            }
        }
        Ok(())
    }

    fn waypoints(&self, claim: &PlanClaim) -> Result<(), Rejection> {
        allowed("position_excess_m", claim.position_excess_m, MOST_MISS, "m")?;
        allowed("yaw_excess_rad", claim.yaw_excess_rad, MOST_MISS, "rad")?;
        // A tolerance of a kilometre binds nothing.
        const UNBOUNDED: f64 = 1e3;
        for (i, (point, &node)) in self.mission.waypoints.iter().zip(&self.motion.waypoint_nodes).enumerate() {
            let apart =
                |axis: usize, due: f64| Interval::point(self.motion.at_node(node, axis, 0)) - Interval::point(due);
            let [x, y, z] = point.position;
            let distance = [(X, x), (Y, y), (Z, z)]
                .iter()
                .fold(Interval::ZERO, |sum, &(axis, due)| sum + apart(axis, due).square())
                .sqrt();
            let position = distance - Interval::point(point.within);
            let yaw = apart(YAW, point.yaw).abs() - Interval::point(point.yaw_within);
            let missed = |what: &str, by: Interval, most: f64, unit: &str| {
                let tolerance = |by: f64| match by > 0.0 {
                    true => format!("missed by {} {unit} more than its tolerance", number(by)),
                    false => format!("met with {} {unit} to spare", number(-by)),
                };
                let why = format!("the {what} is {}; claimed: {}", tolerance(by.high), tolerance(most));
                Err(Rejection {
                    at: Some(self.motion.times[node]),
                    span: Some(point.span),
                    ..Rejection::new(format!("waypoint {}", i + 1), why)
                })
            };
            if point.within < UNBOUNDED && exceeds(position.high, claim.position_excess_m) {
                return missed("position", position, claim.position_excess_m, "m");
            }
            if exceeds(yaw.high, claim.yaw_excess_rad) {
                return missed("yaw", yaw, claim.yaw_excess_rad, "rad");
            }
        }
        Ok(())
    }
}

/// A tolerance that a certificate allows itself, and no more than means something.
fn allowed(name: &str, claimed: f64, most: f64, unit: &str) -> Result<(), Rejection> {
    if claimed <= most {
        return Ok(());
    }
    let [claimed, most] = [claimed, most].map(number);
    Err(Rejection::new(name, format!("{claimed} {unit} is more than the {most} that a plan may miss")))
}
