//! Masses, centres and inertias of bodies: their `inertial`, or what follows from their shapes, solid and of one
//! density, as MuJoCo computes it (`user_objects.cc`, `mjCGeom::SetInertia`, 3.x).

use super::super::xml::{attribute, children, symmetric, tag, upto};
use super::super::{Part, RobotError};
use super::compiler::{FromGeoms, Settings, up_along};
use super::defaults::Defaults;
use super::pose_of;
use crate::diagnostic::Diagnostic;
use crate::import::SYNTAX;
use nalgebra::{Isometry3, Matrix3, Translation3, Unit, UnitQuaternion, Vector3};
use roxmltree::Node;
use std::f64::consts::PI;

/// kg/m^3 of a geom that gives neither mass nor density.
const DENSITY: f64 = 1000.0;

pub struct Masses<'d, 'a, 'i> {
    pub settings: &'d Settings,
    pub defaults: &'d Defaults<'a, 'i>,
    /// The first shape whose mass is not computed.
    pub unknown: Option<Node<'a, 'i>>,
    /// The first joint of a body within the first.
    pub inner_joint: Option<Node<'a, 'i>>,
}

/// Mass (kg), pose and moments about its own axes (kg m^2) of a shape.
type Solid = (f64, Isometry3<f64>, Vector3<f64>);

/// A body or frame that is still to be added, with the pose of the elements around it.
struct Open<'a, 'i> {
    node: Node<'a, 'i>,
    at: Isometry3<f64>,
    class: Option<&'a str>,
    is_first: bool,
}

impl<'a, 'i> Masses<'_, 'a, 'i> {
    /// Adds a body and all within it; `at` is the pose of the first, whose own place in the world does not count if
    /// `is_first`.
    pub fn add(
        &mut self,
        body: Node<'a, 'i>,
        at: &Isometry3<f64>,
        is_first: bool,
        parts: &mut Vec<Part>,
    ) -> Result<(), RobotError> {
        let class = body.ancestors().find_map(|node| node.attribute("childclass"));
        let mut open = vec![Open { node: body, at: *at, class, is_first }];
        while let Some(Open { node, at, class, is_first }) = open.pop() {
            let class = node.attribute("childclass").or(class);
            if node.tag_name().name() == "body" {
                self.body(node, &at, class, parts)?;
            } else {
                self.geoms(node, &at, class, parts)?;
            }
            if !is_first && self.inner_joint.is_none() {
                self.inner_joint = children(node, "joint").next();
            }
            for inner in node.children().filter(|inner| matches!(inner.tag_name().name(), "body" | "frame")) {
                open.push(Open { node: inner, at: at * pose_of(inner, self.settings)?, class, is_first: false });
            }
        }
        Ok(())
    }

    fn body(
        &mut self,
        body: Node<'a, 'i>,
        at: &Isometry3<f64>,
        class: Option<&'a str>,
        parts: &mut Vec<Part>,
    ) -> Result<(), RobotError> {
        let inertial = children(body, "inertial").next();
        match (self.settings.from_geoms, inertial) {
            (FromGeoms::Always, _) | (FromGeoms::Auto, None) => self.geoms(body, at, class, parts),
            (_, Some(inertial)) => {
                parts.extend(self.inertial(inertial, at)?);
                Ok(())
            }
            (FromGeoms::Never, None) => Ok(()),
        }
    }

    fn inertial(&self, inertial: Node, at: &Isometry3<f64>) -> Result<Option<Part>, RobotError> {
        let Some([mass]) = attribute::<1>(inertial, "mass")? else { return Ok(None) };
        let diagonal = attribute::<3>(inertial, "diaginertia")?.map(|d| Matrix3::from_diagonal(&Vector3::from(d)));
        let full = attribute::<6>(inertial, "fullinertia")?.map(symmetric);
        let pose = at * pose_of(inertial, self.settings)?;
        Ok(Some(part(mass, &pose, diagonal.or(full).unwrap_or_else(Matrix3::zeros))))
    }

    /// The shapes of a body, without those of bodies within it.
    fn geoms(
        &mut self,
        body: Node<'a, 'i>,
        at: &Isometry3<f64>,
        class: Option<&'a str>,
        parts: &mut Vec<Part>,
    ) -> Result<(), RobotError> {
        for geom in children(body, "geom") {
            match self.geom(geom, class)? {
                Some((mass, pose, moments)) => {
                    parts.push(part(mass, &(at * pose), Matrix3::from_diagonal(&moments)));
                }
                None => self.unknown = self.unknown.or(Some(geom)),
            }
        }
        Ok(())
    }

    /// Mass, pose and moments of a shape; `None` if they are not known.
    fn geom(&self, geom: Node<'a, 'i>, class: Option<&str>) -> Result<Option<Solid>, RobotError> {
        let of = |name: &'static str| self.defaults.of_geom(geom, class, name);
        let number = |name: &'static str| {
            of(name).map(|owner| attribute::<1>(owner, name)).transpose().map(|n| n.flatten().map(|[n]| n))
        };
        let mass = number("mass")?;
        let density = number("density")?.unwrap_or(DENSITY);
        let kind = of("type").and_then(|owner| owner.attribute("type")).unwrap_or("sphere");
        let none = Some((0.0, Isometry3::identity(), Vector3::zeros()));
        if mass == Some(0.0) || mass.is_none() && density == 0.0 || kind == "plane" {
            return Ok(none);
        }
        if of("shellinertia").is_some_and(|owner| owner.attribute("shellinertia") == Some("true")) {
            return Ok(None);
        }
        let size = of("size").map(|owner| upto::<3>(owner, "size")).transpose()?.flatten().unwrap_or_default();
        let along = of("fromto").map(|owner| attribute::<6>(owner, "fromto")).transpose()?.flatten();
        let turned = ["quat", "axisangle", "euler", "xyaxes", "zaxis"].iter().find_map(|name| of(name));
        let turn = turned.map(|owner| self.settings.turn(owner)).transpose()?.flatten();
        let place = of("pos").map(|owner| attribute::<3>(owner, "pos")).transpose()?.flatten().unwrap_or_default();
        let mut pose = Isometry3::from_parts(
            Translation3::from(Vector3::from(place)),
            turn.unwrap_or_else(UnitQuaternion::identity),
        );
        let mut half = size;
        if let Some([a, b, c, d, e, f]) = along {
            let (from, to) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
            let Some(direction) = Unit::try_new(to - from, 1e-12) else {
                let error = Diagnostic::error(SYNTAX, tag(geom), "`fromto` has no length").here("a shape");
                return Err(Box::new(error.help("write two points")));
            };
            pose = Isometry3::from_parts(Translation3::from((from + to) * 0.5), up_along(&direction));
            let length = 0.5 * (to - from).norm();
            half =
                if matches!(kind, "box" | "ellipsoid") { [size[0], size[0], length] } else { [size[0], length, 0.0] };
        }
        let Some((volume, moments)) = solid(kind, half) else { return Ok(None) };
        let mass = mass.unwrap_or(density * volume);
        Ok(Some((mass, pose, moments * mass)))
    }
}

/// Volume (m^3) and moments for a mass of 1 kg (m^2) of a solid about its own axes.
fn solid(kind: &str, [a, b, c]: [f64; 3]) -> Option<(f64, Vector3<f64>)> {
    let crossed = |a: f64, b: f64, c: f64| Vector3::new(b * b + c * c, a * a + c * c, a * a + b * b);
    Some(match kind {
        "sphere" => (4.0 / 3.0 * PI * a * a * a, Vector3::repeat(0.4 * a * a)),
        "box" => (8.0 * a * b * c, crossed(a, b, c) / 3.0),
        "ellipsoid" => (4.0 / 3.0 * PI * a * b * c, crossed(a, b, c) / 5.0),
        "cylinder" => {
            let side = (3.0 * a * a + 4.0 * b * b) / 12.0;
            (2.0 * PI * a * a * b, Vector3::new(side, side, 0.5 * a * a))
        }
        "capsule" => {
            let (height, ends) = (2.0 * b, 4.0 * a / (4.0 * a + 6.0 * b));
            let middle = 1.0 - ends;
            let side = middle * (3.0 * a * a + height * height) / 12.0
                + ends * (0.4 * a * a + height * (3.0 * a + 2.0 * height) / 8.0);
            let along = middle * 0.5 * a * a + ends * 0.4 * a * a;
            (PI * a * a * (height + 4.0 / 3.0 * a), Vector3::new(side, side, along))
        }
        _ => return None,
    })
}

fn part(mass: f64, pose: &Isometry3<f64>, inertia: Matrix3<f64>) -> Part {
    Part { mass, centre: pose.translation.vector, inertia: super::super::xml::turned(pose, inertia) }
}
