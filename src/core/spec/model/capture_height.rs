//! The limits by which a plan keeps a height above the ground: `require capture_height`.
//!
//! The height is required outside a radius about start and end. The waypoints tell where the way up ends: at the first
//! one that is high enough. Up to it the plan stays within the radius about the start, from it on at the height, and
//! from the last one that is high enough within the radius about the end. Each of these limits is convex, and together
//! they leave no instant that is outside the radius and too low.

use super::volume::{Boundary, which};
use super::{DistanceFrom, Limit, LimitKind, Mission, Model, OnLeg, Part, Waypoint};
use crate::diagnostic::Diagnostic;
use crate::number::{number, significant};
use std::sync::Arc;

/// Code: a waypoint is lower than the height that the plan must keep.
pub const LOW: &str = "mavc::plan::capture_low";

/// How messages name the limits.
pub const NAME: &str = "capture height";

/// Rounding of a position, m.
const ROUNDING: f64 = 1e-9;

impl Mission {
    /// The largest horizontal speed that the limits of the whole mission allow, m/s.
    pub fn top_speed(&self) -> Option<f64> {
        let kinds = [LimitKind::Speed, LimitKind::SpeedHorizontal];
        let bounds = self.limits.iter().filter(|limit| limit.is_general() && kinds.contains(&limit.kind));
        bounds.filter_map(|limit| limit.upper).reduce(f64::min)
    }
}

impl Model {
    /// The spec with the limits of its `require capture_height`, for a simulated height above the ground, m.
    /// Without the statement, a mission or its ground it is the spec itself.
    ///
    /// # Errors
    /// A waypoint is too low, or none shows where the way up or down ends.
    pub fn keeping(&self, height: f64) -> Result<Model, Box<Diagnostic>> {
        let mut model = self.clone();
        let Some((required, mission)) = model.plan.require_capture.as_mut().zip(model.mission.as_mut()) else {
            return Ok(model);
        };
        let Some(ground) = mission.ground else { return Ok(model) };
        required.height = Some(height);
        let rule = Rule { mission, level: ground + height, height, radius: required.radius, span: required.span };
        let limits = rule.limits()?;
        mission.limits.extend(limits);
        Ok(model)
    }
}

struct Rule<'m> {
    mission: &'m Mission,
    /// z of the height, m.
    level: f64,
    /// m above the ground
    height: f64,
    radius: f64,
    span: crate::source::Span,
}

impl Rule<'_> {
    fn limits(&self) -> Result<Vec<Limit>, Box<Diagnostic>> {
        let points = &self.mission.waypoints;
        let is_high = |i: &usize| points[*i].position[2] >= self.level - ROUNDING;
        let end = points.len() - 1;
        let (Some(first), Some(last)) = ((0..=end).find(is_high), (0..=end).rfind(is_high)) else {
            return Err(self.never());
        };
        if let Some(low) = (first..last).find(|i| !is_high(i)) {
            return Err(self.too_low(low));
        }
        for (ends, way, of) in [(0, 0..=first, "start"), (end, last..=end, "end")] {
            let centre = points[ends].position;
            let is_far = |i: &usize| horizontal(points[*i].position, centre) > self.radius + ROUNDING;
            match way.clone().find(is_far) {
                Some(_) if way.start() == way.end() => {}
                Some(far) if !is_high(&far) => return Err(self.too_low(far)),
                Some(far) => return Err(self.too_far(far, centre, of)),
                None => {}
            }
        }
        let above = |leg: usize, part: Part| self.limit(LimitKind::Z, Some(self.level), None, leg, part);
        let near = |leg: usize, centre: [f64; 3]| {
            let about = LimitKind::Distance(DistanceFrom::Axis([centre[0], centre[1]]));
            self.limit(about, None, Some(self.radius), leg, Part::Whole)
        };
        let mut limits: Vec<Limit> = (first..last).map(|leg| above(leg, Part::Whole)).collect();
        if first == last {
            // No leg is at the height: its one waypoint is.
            limits.push(if first > 0 { above(first - 1, Part::End) } else { above(0, Part::Start) });
        }
        limits.extend((0..first).map(|leg| near(leg, points[0].position)));
        limits.extend((last..end).map(|leg| near(leg, points[end].position)));
        Ok(limits)
    }

    fn limit(&self, kind: LimitKind, lower: Option<f64>, upper: Option<f64>, leg: usize, part: Part) -> Limit {
        let on = OnLeg { leg, part, name: NAME.into() };
        Limit {
            kind,
            lower,
            upper,
            span: self.span,
            volume: Some(Arc::new(Boundary { name: NAME.into(), half_width: upper })),
            leg: Some(Arc::new(on)),
        }
    }

    /// `9.4 m above the ground`
    fn height(&self) -> String {
        format!("{} m above the ground", significant(self.height, 3))
    }

    fn error(&self, at: &Waypoint, message: String, label: &str) -> Diagnostic {
        let error = Diagnostic::error(LOW, at.span, message).here(label);
        error.also(self.span, format!("requires {}, as simulated", self.height()))
    }

    fn too_low(&self, index: usize) -> Box<Diagnostic> {
        let points = &self.mission.waypoints;
        let at = &points[index];
        let (start, end) = (points[0].position, points[points.len() - 1].position);
        let nearest = horizontal(at.position, start).min(horizontal(at.position, end));
        let message = format!(
            "{} is {} m lower than `require capture_height` allows {} m from start and end",
            which(index, at),
            significant(self.level - at.position[2], 3),
            significant(nearest, 3)
        );
        let error = self.error(at, message, "too low");
        Box::new(error.help(format!("raise it to {} m or more, or enlarge `radius`", self.written(self.level))))
    }

    /// The way up or down ends outside the radius.
    fn too_far(&self, index: usize, centre: [f64; 3], of: &str) -> Box<Diagnostic> {
        let at = &self.mission.waypoints[index];
        let apart = significant(horizontal(at.position, centre), 3);
        let message = format!("no waypoint within {} m of the {of} reaches {}", number(self.radius), self.height());
        let (before, label) = match of {
            "start" => ("before", format!("the first one that high, {apart} m from the start")),
            _ => ("after", format!("the last one that high, {apart} m from the end")),
        };
        let [x, y] = [centre[0], centre[1]].map(number);
        let added = format!("waypoint at [{x}, {y}, {}] m", self.written(self.level));
        let help = format!("add `{added}` {before} it, or enlarge `radius`");
        Box::new(self.error(at, message, &label).help(help))
    }

    /// No waypoint is high enough.
    fn never(&self) -> Box<Diagnostic> {
        let points = self.mission.waypoints.iter().enumerate();
        let highest = points.max_by(|a, b| a.1.position[2].total_cmp(&b.1.position[2]));
        let (index, at) = highest.unwrap_or((0, &self.mission.waypoints[0]));
        let message = format!("no waypoint reaches {}, as `require capture_height` needs", self.height());
        let label = format!("{} is the highest, at {} m", which(index, at), number(at.position[2]));
        let help = format!("raise waypoints to {} m or more", self.written(self.level));
        Box::new(self.error(at, message, &label).help(help))
    }

    /// A height rounded up to a decimetre, m.
    fn written(&self, z: f64) -> String {
        number((10.0 * (z - ROUNDING)).ceil() / 10.0)
    }
}

/// The horizontal distance of two points, m.
fn horizontal(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
