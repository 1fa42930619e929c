//! URDF: links placed by joints; rotors as plugins of the motor model (RotorS), or as links `prop0_link`, `prop1_link`,
//! .. beside the element `properties` of gym-pybullet-drones. Source: the URDF specification of ROS, `link` and
//! `joint`; Panerati et al., "Learning to Fly", 2021, whose simulator reads `kf` (N/rpm^2), `km` (N m/rpm^2) and
//! `thrust2weight`.

use super::sdf::motor;
use super::xml::{attribute, child, children, pose, required, symmetric, tag, text, turned};
use super::{Joint, MOST_ROTORS, Part, Robot, RobotError, RobotRotor, turning_arm};
use crate::diagnostic::Diagnostic;
use crate::import::{UNSUPPORTED, at};
use crate::source::Source;
use nalgebra::Isometry3;
use roxmltree::Node;
use std::collections::HashMap;
use std::f64::consts::PI;

/// rad/s
const RPM: f64 = PI / 30.0;

/// m/s^2, as in gym-pybullet-drones.
const GRAVITY: f64 = 9.8;

pub fn read(source: &Source, root: Node) -> Result<Robot, RobotError> {
    if let Some(macros) =
        root.descendants().find(|node| node.tag_name().namespace().is_some_and(|n| n.contains("xacro")))
    {
        let error = Diagnostic::error(UNSUPPORTED, tag(macros), "the file has macros of xacro").here("a macro");
        return Err(Box::new(error.help("expand them first: `xacro robot.urdf.xacro > robot.urdf`")));
    }
    let mut robot = Robot { name: root.attribute("name").map(String::from), format: "URDF", ..Robot::default() };
    let poses = poses(source, root)?;
    for link in children(root, "link") {
        let at = poses.get(link.attribute("name").unwrap_or_default()).copied().unwrap_or_else(Isometry3::identity);
        robot.parts.extend(part(link, &at)?.map(|(part, _)| part));
    }
    let plugins = children(root, "gazebo").flat_map(|gazebo| children(gazebo, "plugin"));
    let joints = joints(root);
    for plugin in plugins {
        let find = |link: &str| Ok(poses.get(link).copied());
        if let Some(rotor) = motor(plugin, &find)? {
            if robot.rotors.len() < MOST_ROTORS {
                turning_arm(text(plugin, "linkName").unwrap_or_default(), &joints, plugin)?;
            }
            robot.rotors.push(rotor);
        }
    }
    if let Some(properties) = child(root, "properties").filter(|_| robot.rotors.is_empty()) {
        robot.rotors = of_properties(root, properties, &poses, &joints)?;
        robot.radius = attribute::<1>(properties, "prop_radius")?.map(|[radius]| radius).filter(|radius| *radius > 0.0);
        let known = ["kf", "km", "thrust2weight", "prop_radius"];
        robot
            .dropped
            .extend(properties.attributes().map(|a| a.name()).filter(|n| !known.contains(n)).map(String::from));
    }
    let kept = ["link", "joint", "gazebo", "properties"];
    let other = root.children().filter(|c| c.is_element() && !kept.contains(&c.tag_name().name()));
    robot.dropped.extend(other.map(|c| c.tag_name().name().to_string()));
    Ok(robot)
}

/// The joint that holds each link.
fn joints<'a>(root: Node<'a, '_>) -> HashMap<String, Joint<'a>> {
    let joint = |joint: Node<'a, '_>| {
        let end = |name| child(joint, name).and_then(|node| node.attribute("link")).unwrap_or_default().to_string();
        // A joint without a type is not URDF; it counts as fixed, as it places its link.
        let kind = joint.attribute("type").unwrap_or("fixed");
        (end("child"), Joint { parent: end("parent"), kind })
    };
    children(root, "joint").map(joint).collect()
}

/// `xyz` and `rpy` of an origin.
fn origin(node: Node) -> Result<Isometry3<f64>, RobotError> {
    let Some(origin) = child(node, "origin") else { return Ok(Isometry3::identity()) };
    let [x, y, z] = attribute::<3>(origin, "xyz")?.unwrap_or_default();
    let [roll, pitch, yaw] = attribute::<3>(origin, "rpy")?.unwrap_or_default();
    Ok(pose([x, y, z, roll, pitch, yaw]))
}

/// The pose of every link in the frame of the root link.
fn poses<'a>(source: &Source, root: Node<'a, '_>) -> Result<HashMap<&'a str, Isometry3<f64>>, RobotError> {
    let mut joints: HashMap<&str, (&str, Isometry3<f64>)> = HashMap::new();
    for joint in children(root, "joint") {
        let end = |name| child(joint, name).and_then(|node| node.attribute("link")).unwrap_or_default();
        joints.insert(end("child"), (end("parent"), origin(joint)?));
    }
    let mut poses = HashMap::new();
    // Names of joints may be those of no link.
    let mut placed: HashMap<&str, Isometry3<f64>> = HashMap::new();
    for link in children(root, "link") {
        let name = link.attribute("name").unwrap_or_default();
        // Up to a link that is placed already, so that every joint is passed once.
        let (mut at, mut way) = (name, Vec::new());
        while let Some((parent, own)) = joints.get(at).filter(|_| !placed.contains_key(at)) {
            way.push((at, own));
            at = parent;
            if way.len() > joints.len() {
                return Err(Box::new(circle(source, link)));
            }
        }
        let mut whole = placed.get(at).copied().unwrap_or_else(Isometry3::identity);
        for (below, own) in way.into_iter().rev() {
            whole *= own;
            placed.insert(below, whole);
        }
        poses.insert(name, whole);
    }
    Ok(poses)
}

fn circle(_: &Source, link: Node) -> Diagnostic {
    let error = Diagnostic::error(crate::import::SYNTAX, tag(link), "joints lead in a circle").here("from this link");
    error.help("give every link one parent")
}

/// A link's mass, and its centre in the frame of the whole.
fn part(link: Node, at: &Isometry3<f64>) -> Result<Option<(Part, Isometry3<f64>)>, RobotError> {
    let Some(inertial) = child(link, "inertial") else { return Ok(None) };
    let whole = at * origin(inertial)?;
    let mass = child(inertial, "mass").map(|mass| required(mass, "value")).transpose()?.unwrap_or(0.0);
    let inertia = match child(inertial, "inertia") {
        None => [0.0; 6],
        Some(inertia) => {
            let one = |name| attribute::<1>(inertia, name).map(|value| value.map_or(0.0, |[value]| value));
            [one("ixx")?, one("iyy")?, one("izz")?, one("ixy")?, one("ixz")?, one("iyz")?]
        }
    };
    let part = Part { mass, centre: whole.translation.vector, inertia: turned(&whole, symmetric(inertia)) };
    Ok(Some((part, whole)))
}

/// The rotors of gym-pybullet-drones: its file does not say how they turn.
fn of_properties(
    root: Node,
    properties: Node,
    poses: &HashMap<&str, Isometry3<f64>>,
    joints: &HashMap<String, Joint>,
) -> Result<Vec<RobotRotor>, RobotError> {
    let [kf, km] = [required(properties, "kf")?, required(properties, "km")?];
    if kf <= 0.0 || km <= 0.0 {
        let error = Diagnostic::error(UNSUPPORTED, at(properties.range()), "`kf` and `km` must be above zero");
        return Err(Box::new(error.here("the coefficients of the rotors").help("write them in N/rpm^2 and N*m/rpm^2")));
    }
    let is_prop = |link: &Node| {
        let name = link.attribute("name").unwrap_or_default();
        let number = name.strip_prefix("prop").and_then(|rest| rest.strip_suffix("_link"));
        number.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    let props: Vec<Node> = children(root, "link").filter(is_prop).collect();
    let mut mass = 0.0;
    for link in children(root, "link") {
        mass += part(link, &Isometry3::identity())?.map_or(0.0, |(part, _)| part.mass);
    }
    let ratio = attribute::<1>(properties, "thrust2weight")?;
    let most = ratio.map(|[ratio]| (ratio * mass * GRAVITY / (props.len() as f64 * kf)).sqrt() * RPM);
    let mut rotors = Vec::new();
    for (k, link) in props.into_iter().enumerate() {
        let frame = poses.get(link.attribute("name").unwrap_or_default()).copied().unwrap_or_else(Isometry3::identity);
        if k < MOST_ROTORS {
            turning_arm(link.attribute("name").unwrap_or_default(), joints, link)?;
        }
        let place = part(link, &frame)?.map_or(frame.translation.vector, |(part, _)| part.centre);
        let figures =
            [Some(kf / (RPM * RPM)), Some(km / kf), most.filter(|w| w.is_finite() && *w > 0.0), None, None, None, None];
        rotors.push(RobotRotor { place, is_ccw: None, motor: k + 1, figures, drag: None });
    }
    Ok(rotors)
}
