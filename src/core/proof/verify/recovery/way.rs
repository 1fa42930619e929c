//! Where the motions of a family lead.

use super::super::motion::{Motion, X, Y, YAW, Z};
use super::tube::Tube;
use crate::certificate::{FamilyRecord, WayRecord};
use crate::model::{Body, DistanceFrom, HeldLimit, Limit, LimitKind, Mission, Model, Obstacle, Recovery, TOUCHDOWN};
use crate::number::number;
use crate::source::Span;
use crate::tolerance::MOST_PAST_LIMIT;
use std::ops::Range;

/// Derivatives at the end of a landing that count as zero, SI.
const AT_REST: f64 = 1e-6;

/// Areas to keep off have no ends; here they reach this far from 0, m.
const FAR: f64 = 1e6;

pub(super) enum Way {
    /// Back to the plan.
    Back,
    /// Down to the ground.
    Down(Place),
}

/// Where a vehicle may touch down.
pub(super) struct Place {
    /// The height of the ground, m.
    ground: f64,
    /// A landing is not lower than this before its last part, m, unless it begins lower.
    floor: f64,
    /// What has to hold in the last part.
    last_part: Vec<Limit>,
}

fn limit(kind: LimitKind, lower: Option<f64>, upper: Option<f64>) -> Limit {
    Limit { kind, lower, upper, span: Span::default(), volume: None, leg: None }
}

impl Way {
    /// # Errors
    /// The spec does not allow this way out after the mode.
    pub fn of(record: &FamilyRecord, model: &Model, mission: &Mission, mode: usize) -> Result<Way, String> {
        let order = model.recovery(mode);
        let rules = &mission.after_fault;
        let size = model.vehicle.radius();
        let down = |ground: f64, last_part: Vec<Limit>| Way::Down(Place { ground, floor: ground + size, last_part });
        let not_allowed = |way: &str| Err(format!("the spec does not allow `{way}` after {}", record.mode));
        match &record.way {
            WayRecord::Continue if order.contains(&Recovery::Continue) => Ok(Way::Back),
            WayRecord::Continue => not_allowed("continue"),
            WayRecord::LandAt(name) => {
                let site = rules.sites.iter().position(|site| site.name == *name);
                let allowed = |site: &usize| order.iter().any(|way| mission.sites_of(*way).contains(site));
                let Some(site) = site.filter(allowed) else { return not_allowed(name) };
                let site = &rules.sites[site];
                let axis = LimitKind::Distance(DistanceFrom::Axis([site.at[0], site.at[1]]));
                Ok(down(site.at[2], vec![limit(axis, None, Some(site.radius))]))
            }
            WayRecord::LandHere if order.contains(&Recovery::LandHere) => {
                let Some(ground) = mission.ground else { return Err("the mission has no `ground`".into()) };
                let areas = rules.keep_off.iter();
                let bodies = areas.flat_map(|area| area.bodies.iter().map(|body| (body, area.clearance)));
                let away = |(body, clearance): (&Body, f64)| {
                    let kind = LimitKind::Clearance(Obstacle::of(with_ends(body)).into());
                    limit(kind, Some(size + clearance), None)
                };
                Ok(down(ground, bodies.map(away).collect()))
            }
            WayRecord::LandHere => not_allowed("land here"),
        }
    }
}

/// A body without ends as one that reaches far up and down.
fn with_ends(body: &Body) -> Body {
    let mut body = body.clone();
    if let Body::Prism { bottom, top, .. } | Body::Cylinder { bottom, top, .. } = &mut body {
        (*bottom, *top) = (bottom.max(-FAR), top.min(FAR));
    }
    body
}

impl Place {
    /// Checks that branches end at rest on the ground. What holds for them holds for their blends, and deviations have
    /// vanished there.
    ///
    /// # Errors
    /// One does not.
    pub fn reached_by(&self, branches: [&Motion; 4]) -> Result<(), String> {
        for branch in branches {
            let last = branch.pieces();
            for (axis, highest) in [(X, 3), (Y, 3), (Z, 1), (YAW, 1)] {
                let moving = |order: &usize| branch.at_node(last, axis, *order).abs() > AT_REST;
                if let Some(order) = (1..=highest).find(moving) {
                    let (name, value) = (["x", "y", "z", "yaw"][axis], number(branch.at_node(last, axis, order)));
                    return Err(format!("a branch ends in motion: derivative {order} of {name} is {value}"));
                }
            }
            let above = branch.at_node(last, Z, 0) - self.ground;
            if above > TOUCHDOWN + MOST_PAST_LIMIT {
                return Err(format!("a branch ends {} m above the ground", number(above)));
            }
        }
        Ok(())
    }

    /// Limits on all motions of a tube, with the pieces in which they hold. Heights yield to a fault near the ground.
    pub fn limits(&self, tube: &Tube) -> Vec<(HeldLimit, Range<usize>)> {
        let branch = tube.branch();
        let pieces = branch.pieces();
        let parts = &branch.waypoint_nodes;
        let begins = parts.len().checked_sub(2).map_or(0, |part| parts[part].min(pieces - 1));
        let above = |height: f64| HeldLimit { limit: limit(LimitKind::Z, Some(height), None), yields: f64::INFINITY };
        let mut all = vec![(above(self.floor), 0..begins), (above(self.ground), 0..pieces)];
        let last_part = |limit: &Limit| (HeldLimit { limit: limit.clone(), yields: 0.0 }, begins..pieces);
        all.extend(self.last_part.iter().map(last_part));
        all.retain(|(_, pieces)| !pieces.is_empty());
        all
    }
}
