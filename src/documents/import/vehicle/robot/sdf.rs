//! SDFormat: the links of a model, and plugins of the motor model of RotorS, Gazebo classic and Gazebo Sim. Source: the
//! specification of SDFormat, `pose` and `inertial`; Furrer et al., "RotorS", 2016, for the elements of the plugin.

use super::xml::{child, children, content, is_upright, pose, symmetric, tag, text, turned};
use super::{Part, Robot, RobotError, RobotRotor};
use crate::diagnostic::Diagnostic;
use crate::import::{SYNTAX, UNSUPPORTED};
use nalgebra::Isometry3;
use roxmltree::Node;
use std::collections::HashMap;

pub fn read(root: Node) -> Result<Robot, RobotError> {
    let model = child(root, "model").or_else(|| child(root, "world").and_then(|world| child(world, "model")));
    let Some(model) = model else {
        let error = Diagnostic::error(UNSUPPORTED, tag(root), "the file has no model").here("no `model` in it");
        return Err(Box::new(error.help("name the file of a model")));
    };
    let mut robot = Robot { name: model.attribute("name").map(String::from), format: "SDF", ..Robot::default() };
    let poses = poses(model)?;
    for link in children(model, "link") {
        let at = poses.get(link.attribute("name").unwrap_or_default()).copied().unwrap_or_else(Isometry3::identity);
        robot.parts.extend(part(link, &at)?);
    }
    for plugin in children(model, "plugin") {
        robot.rotors.extend(motor(plugin, &poses, model)?);
    }
    let kept = ["link", "plugin", "joint", "pose", "static", "self_collide"];
    let other = model.children().filter(|c| c.is_element() && !kept.contains(&c.tag_name().name()));
    robot.dropped.extend(other.map(|c| c.tag_name().name().to_string()));
    Ok(robot)
}

/// The pose of every link in the frame of the model; links may be placed relative to links before them.
fn poses<'a>(model: Node<'a, '_>) -> Result<HashMap<&'a str, Isometry3<f64>>, RobotError> {
    let mut poses: HashMap<&str, Isometry3<f64>> = HashMap::new();
    for link in children(model, "link") {
        let own = content::<6>(link, "pose")?.map_or_else(Isometry3::identity, pose);
        let relative = child(link, "pose").and_then(|pose| pose.attribute("relative_to")).filter(|to| !to.is_empty());
        let placed = match relative {
            None | Some("__model__") => own,
            Some(to) => match poses.get(to) {
                Some(frame) => frame * own,
                None => {
                    let error = Diagnostic::error(
                        UNSUPPORTED,
                        tag(link),
                        "a link is placed relative to what is no link before it",
                    );
                    return Err(Box::new(
                        error.here("its pose").help("write poses relative to the model or to links before"),
                    ));
                }
            },
        };
        poses.insert(link.attribute("name").unwrap_or_default(), placed);
    }
    Ok(poses)
}

fn part(link: Node, at: &Isometry3<f64>) -> Result<Option<Part>, RobotError> {
    let Some(inertial) = child(link, "inertial") else { return Ok(None) };
    let own = content::<6>(inertial, "pose")?.map_or_else(Isometry3::identity, pose);
    let whole = at * own;
    let mass = content::<1>(inertial, "mass")?.map_or(0.0, |[mass]| mass);
    let inertia = match child(inertial, "inertia") {
        None => [0.0; 6],
        Some(inertia) => {
            let one = |name| content::<1>(inertia, name).map(|value| value.map_or(0.0, |[value]| value));
            [one("ixx")?, one("iyy")?, one("izz")?, one("ixy")?, one("ixz")?, one("iyz")?]
        }
    };
    Ok(Some(Part { mass, centre: whole.translation.vector, inertia: turned(&whole, symmetric(inertia)) }))
}

/// A rotor of a plugin; `None` for a plugin that is no motor model.
pub fn motor(
    plugin: Node,
    poses: &HashMap<&str, Isometry3<f64>>,
    whole: Node,
) -> Result<Option<RobotRotor>, RobotError> {
    let Some(constant) = content::<1>(plugin, "motorConstant")? else { return Ok(None) };
    let link = text(plugin, "linkName").unwrap_or_default();
    let Some(pose) = poses.get(link) else {
        let shown: String = link.chars().take(40).collect();
        let include = whole.descendants().any(|node| node.tag_name().name() == "include");
        let help = match include {
            true => "the file includes another model; name a file with all links, such as `gz sdf -p` prints",
            false => "name a file that has the link",
        };
        let error =
            Diagnostic::error(UNSUPPORTED, tag(plugin), format!("the link `{shown}` of a motor is not in the file"));
        return Err(Box::new(error.here("a motor").help(help)));
    };
    if !is_upright(pose) {
        let error = Diagnostic::error(UNSUPPORTED, tag(plugin), "the axis of a rotor is not upright").here("a motor");
        return Err(Box::new(error.help("a spec has rotors with parallel, upright axes only")));
    }
    let number = content::<1>(plugin, "motorNumber")?.map_or(0.0, |[number]| number);
    if number < 0.0 || number.fract() != 0.0 || number > 31.0 {
        let error = Diagnostic::error(SYNTAX, tag(plugin), "the number of a motor is not a whole number from 0 to 31");
        return Err(Box::new(error.here("`motorNumber`").help("number motors from 0")));
    }
    let one = |name| content::<1>(plugin, name).map(|value| value.map(|[value]| value).filter(|value| *value > 0.0));
    Ok(Some(RobotRotor {
        place: pose.translation.vector,
        is_ccw: match text(plugin, "turningDirection") {
            Some("ccw") => Some(true),
            Some("cw") => Some(false),
            _ => None,
        },
        motor: number as usize + 1,
        figures: [
            Some(constant[0]).filter(|value| *value > 0.0),
            one("momentConstant")?,
            one("maxRotVelocity")?,
            None,
            None,
            one("timeConstantUp")?,
        ],
    }))
}
