//! MJCF of MuJoCo: motors at sites of one body. A motor's `gear` gives its force along z and the torque about z, `ctrlrange` the least and
//! the largest control. Source: MuJoCo's XML reference, `actuator/motor`, `body/inertial` and `default`.

use super::xml::{attribute, child, children, symmetric, tag};
use super::{Part, Robot, RobotRotor};
use crate::diagnostic::Diagnostic;
use crate::import::UNSUPPORTED;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use roxmltree::Node;

type Problem = Box<Diagnostic>;

pub fn read(root: Node) -> Result<Robot, Problem> {
    let mut robot = Robot { name: root.attribute("model").map(String::from), format: "MJCF", ..Robot::default() };
    let Some(actuators) = child(root, "actuator") else { return Ok(robot) };
    let mut body: Option<Node> = None;
    for actuator in actuators.children().filter(Node::is_element) {
        let name = actuator.tag_name().name();
        let site = inherited(root, actuator, "site").and_then(|owner| owner.attribute("site"));
        let site = site.and_then(|site| {
            root.descendants().find(|node| node.tag_name().name() == "site" && node.attribute("name") == Some(site))
        });
        let (Some(site), true) = (site, matches!(name, "motor" | "general")) else {
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
        robot.rotors.push(motor(root, actuator, site, robot.rotors.len() + 1)?);
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

/// The element that gives an attribute of an actuator: itself, or the default of its class or of a class around it.
fn inherited<'a, 'i>(root: Node<'a, 'i>, actuator: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    if actuator.attribute(name).is_some() {
        return Some(actuator);
    }
    let kind = actuator.tag_name().name();
    let is_class = |node: &Node| {
        let class = actuator.attribute("class");
        let is_outermost = node.parent_element().is_some_and(|parent| parent.tag_name().name() != "default");
        node.tag_name().name() == "default"
            && match class {
                Some(class) => node.attribute("class") == Some(class),
                None => is_outermost,
            }
    };
    let mut class = root.descendants().find(is_class);
    while let Some(of_class) = class.filter(|node| node.tag_name().name() == "default") {
        let found = of_class.children().find(|c| c.tag_name().name() == kind && c.attribute(name).is_some());
        if found.is_some() {
            return found;
        }
        class = of_class.parent_element();
    }
    None
}

fn motor(root: Node, actuator: Node, site: Node, number: usize) -> Result<RobotRotor, Problem> {
    let of = |name: &'static str| inherited(root, actuator, name);
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
fn part(body: Node) -> Result<Option<Part>, Problem> {
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
