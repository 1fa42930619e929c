//! MJCF of MuJoCo: motors at sites of one body. A motor's `gear` gives its force along z and the torque about z,
//! `ctrlrange` the least and the largest control. Source: MuJoCo's XML reference, `actuator/motor`, `body/inertial` and
//! `default`.

use super::xml::{attribute, child, children, symmetric, tag};
use super::{Part, Robot, RobotError, RobotRotor};
use crate::diagnostic::Diagnostic;
use crate::import::UNSUPPORTED;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use roxmltree::{Node, NodeId};
use std::collections::HashMap;

pub fn read(root: Node) -> Result<Robot, RobotError> {
    let mut robot = Robot { name: root.attribute("model").map(String::from), format: "MJCF", ..Robot::default() };
    let Some(actuators) = child(root, "actuator") else { return Ok(robot) };
    let mut body: Option<Node> = None;
    let defaults = Defaults::of(root);
    let mut sites: HashMap<&str, Node> = HashMap::new();
    for site in root.descendants().filter(|node| node.tag_name().name() == "site") {
        if let Some(name) = site.attribute("name") {
            sites.entry(name).or_insert(site);
        }
    }
    for actuator in actuators.children().filter(Node::is_element) {
        let name = actuator.tag_name().name();
        let site = defaults.inherited(actuator, "site").and_then(|owner| owner.attribute("site"));
        let Some(site) = site.and_then(|site| sites.get(site).copied()) else {
            robot.dropped.push(format!("actuator/{name}"));
            continue;
        };
        let own = site.parent_element();
        if body.is_some_and(|body| Some(body) != own) {
            let error =
                Diagnostic::error(UNSUPPORTED, tag(site), "motors are at sites of several bodies").here("another body");
            return Err(Box::new(error.help("a spec has one rigid body")));
        }
        body = own;
        robot.rotors.push(motor(&defaults, actuator, site, robot.rotors.len() + 1)?);
    }
    if let Some(body) = body {
        if children(body, "body").next().is_some() {
            let warning = Diagnostic::warning(UNSUPPORTED, tag(body), "bodies within the vehicle's body are left out");
            robot.warnings.push(warning.here("has bodies of its own").help("add their mass and inertia in the spec"));
        }
        robot.parts.extend(part(body)?);
    }
    Ok(robot)
}

/// The actuators that are motors.
const KINDS: [&str; 2] = ["motor", "general"];

/// The attributes of a motor that a class may give.
const INHERITED: [&str; 3] = ["site", "gear", "ctrlrange"];

/// For each of [`KINDS`] and [`INHERITED`] the element that gives the attribute.
type Owners<'a, 'i> = [[Option<Node<'a, 'i>>; INHERITED.len()]; KINDS.len()];

/// The default classes of a file, each with what it gives, itself or by a class around it: read once, as there may be
/// as many classes as motors.
struct Defaults<'a, 'i> {
    owners: HashMap<NodeId, Owners<'a, 'i>>,
    /// The first of a name counts.
    by_class: HashMap<&'a str, NodeId>,
    outermost: Option<NodeId>,
}

impl<'a, 'i> Defaults<'a, 'i> {
    fn of(root: Node<'a, 'i>) -> Self {
        let mut found = Defaults { owners: HashMap::new(), by_class: HashMap::new(), outermost: None };
        // A class comes after the class around it.
        for class in root.descendants().filter(|node| node.tag_name().name() == "default") {
            let around = class.parent_element().filter(|parent| parent.tag_name().name() == "default");
            let mut given: Owners = [[None; INHERITED.len()]; KINDS.len()];
            for element in class.children() {
                let Some(kind) = KINDS.iter().position(|kind| *kind == element.tag_name().name()) else { continue };
                for (owner, name) in given[kind].iter_mut().zip(INHERITED) {
                    *owner = owner.or(Some(element).filter(|element| element.has_attribute(name)));
                }
            }
            if let Some(around) = around.and_then(|around| found.owners.get(&around.id())) {
                for (owner, around) in given.as_flattened_mut().iter_mut().zip(around.as_flattened()) {
                    *owner = owner.or(*around);
                }
            }
            found.owners.insert(class.id(), given);
            if let Some(name) = class.attribute("class") {
                found.by_class.entry(name).or_insert(class.id());
            }
            if around.is_none() && class.parent_element().is_some() {
                found.outermost.get_or_insert(class.id());
            }
        }
        found
    }

    /// The element that gives an attribute of an actuator: itself, or the default of its class or of a class around it.
    /// `None` for actuators that are no motors.
    fn inherited(&self, actuator: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
        let kind = KINDS.iter().position(|kind| *kind == actuator.tag_name().name())?;
        if actuator.has_attribute(name) {
            return Some(actuator);
        }
        let class = match actuator.attribute("class") {
            Some(class) => self.by_class.get(class).copied(),
            None => self.outermost,
        };
        let place = INHERITED.iter().position(|inherited| *inherited == name)?;
        self.owners.get(&class?)?[kind][place]
    }
}

fn motor(defaults: &Defaults, actuator: Node, site: Node, number: usize) -> Result<RobotRotor, RobotError> {
    let of = |name: &'static str| defaults.inherited(actuator, name);
    let gear = of("gear").map(|owner| attribute::<6>(owner, "gear")).transpose()?.flatten().unwrap_or_default();
    let range = of("ctrlrange").map(|owner| attribute::<2>(owner, "ctrlrange")).transpose()?.flatten();
    let [fx, fy, force, tx, ty, torque] = gear;
    if [fx, fy, tx, ty].iter().any(|part| *part != 0.0) || force <= 0.0 {
        let error = Diagnostic::error(UNSUPPORTED, tag(actuator), "a motor does not push along z of its site")
            .here("its `gear`");
        return Err(Box::new(error.help("a spec has rotors with parallel, upright axes only")));
    }
    if let Some(turned) =
        ["quat", "euler", "axisangle", "zaxis", "xyaxes"].iter().find(|name| site.attribute(**name).is_some())
    {
        let error = Diagnostic::error(UNSUPPORTED, tag(site), format!("the site of a motor is turned by `{turned}`"));
        return Err(Box::new(error.here("its site").help("a spec has rotors with parallel, upright axes only")));
    }
    let place = attribute::<3>(site, "pos")?.map_or_else(Vector3::zeros, Vector3::from);
    let thrust = |control: f64| Some(control * force).filter(|thrust| *thrust != 0.0);
    Ok(RobotRotor {
        place,
        // The body feels the torque against the turning rotor.
        is_ccw: (torque != 0.0).then_some(torque < 0.0),
        motor: number,
        figures: [
            None,
            Some((torque / force).abs()).filter(|ratio| *ratio > 0.0),
            None,
            range.and_then(|[_, most]| thrust(most)),
            range.and_then(|[least, _]| thrust(least)),
            None,
        ],
    })
}

/// The body's `inertial`; `None` where masses follow from its shapes.
fn part(body: Node) -> Result<Option<Part>, RobotError> {
    let Some(inertial) = child(body, "inertial") else { return Ok(None) };
    let Some([mass]) = attribute::<1>(inertial, "mass")? else { return Ok(None) };
    let centre = attribute::<3>(inertial, "pos")?.map_or_else(Vector3::zeros, Vector3::from);
    let diagonal = attribute::<3>(inertial, "diaginertia")?.map(|d| Matrix3::from_diagonal(&Vector3::from(d)));
    let full = attribute::<6>(inertial, "fullinertia")?.map(symmetric);
    let turn = attribute::<4>(inertial, "quat")?.map_or_else(UnitQuaternion::identity, |[w, x, y, z]| {
        UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
    });
    let rotation = turn.to_rotation_matrix();
    let inertia = diagonal.or(full).unwrap_or_else(Matrix3::zeros);
    Ok(Some(Part { mass, centre, inertia: rotation.matrix() * inertia * rotation.matrix().transpose() }))
}
