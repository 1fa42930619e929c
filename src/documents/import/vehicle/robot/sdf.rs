//! SDFormat: the links of a model and of models within it, and plugins of the motor model of RotorS, Gazebo classic and
//! Gazebo Sim. Source: the specification of SDFormat 1.11, `pose`, `frame` and `inertial`, and its "Pose Frame
//! Semantics"; Furrer et al., "RotorS", 2016, for the elements of the plugin.

mod frames;

use super::xml::{child, children, content, is_upright, sdf_pose, symmetric, tag, text, turned};
use super::{Joint, MOST_ROTORS, Part, ROTOR_INERTIA, Robot, RobotError, RobotRotor, turning_arm};
use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, SYNTAX, UNSUPPORTED};
use frames::{Frames, key};
use nalgebra::Isometry3;
use roxmltree::Node;
use std::collections::HashMap;

/// The default of `rotorVelocitySlowdownSim`, in RotorS and Gazebo.
const SLOWDOWN: f64 = 10.0;
/// Elements of the motor model that a spec has no word for.
const UNUSED: [&str; 2] = ["timeConstantDown", "rollingMomentCoefficient"];

pub fn read(root: Node) -> Result<Robot, RobotError> {
    let worlds = children(root, "world").flat_map(|world| children(world, "model"));
    let models: Vec<Node> = children(root, "model").chain(worlds).collect();
    // A world has a ground and other models beside the vehicle.
    let flies = |model: &&Node| model.descendants().any(|node| node.tag_name().name() == "motorConstant");
    let included = children(root, "world").flat_map(|world| children(world, "include"));
    if let (None, Some(include)) = (models.iter().find(flies), included.into_iter().next()) {
        return Err(elsewhere(include, "the world includes its vehicles, which are not models of this file"));
    }
    let Some(model) = models.iter().find(flies).or(models.first()).copied() else {
        let error = Diagnostic::error(UNSUPPORTED, tag(root), "the file has no model").here("no `model` in it");
        return Err(Box::new(error.help("name the file of a model")));
    };
    let mut robot = Robot { name: model.attribute("name").map(String::from), format: "SDF", ..Robot::default() };
    let mut massless: Vec<Node> = Vec::new();
    let scopes = frames::scopes(model);
    let frames = Frames::of(&scopes)?;
    let joints = joints(&scopes);
    let links: HashMap<String, Node> = scopes
        .iter()
        .flat_map(|(scope, model)| {
            children(*model, "link").map(move |link| (key(scope, link.attribute("name").unwrap_or_default()), link))
        })
        .collect();
    for (scope, model) in &scopes {
        if let Some(include) = child(*model, "include") {
            return Err(elsewhere(include, "the model includes another, whose mass and rotors are not in this file"));
        }
        for link in children(*model, "link") {
            let at = frames.pose(&key(scope, link.attribute("name").unwrap_or_default()))?;
            match part(link, &at)? {
                Some(part) => robot.parts.push(part),
                None => massless.push(link),
            }
        }
        for plugin in children(*model, "plugin") {
            let find = |link: &str| {
                let key = key(scope, link);
                frames.has(&key).then(|| frames.pose(&key)).transpose()
            };
            let Some(mut rotor) = motor(plugin, &find)? else {
                robot.warnings.extend(lift(plugin));
                continue;
            };
            let link = key(scope, text(plugin, "linkName").unwrap_or_default());
            if robot.rotors.len() < MOST_ROTORS {
                turning_arm(&link, &joints, plugin)?;
            }
            let spinning = links.get(&link).map(|link| spinning(*link, plugin)).transpose()?.flatten();
            rotor.figures[ROTOR_INERTIA] = spinning;
            robot.rotors.push(rotor);
        }
    }
    let is_ardupilots =
        |plugin: &Node| plugin.attribute("filename").is_some_and(|name| name.contains("ArduPilotPlugin"));
    let all = scopes.iter().flat_map(|(_, model)| children(*model, "plugin"));
    if let (true, Some(plugin)) = (robot.rotors.is_empty(), all.into_iter().find(is_ardupilots)) {
        let message = "the rotors of ArduPilot's plugin are blades with lift and drag, without figures of a rotor";
        let error = Diagnostic::error(UNSUPPORTED, tag(plugin), message).here("the motors");
        return Err(Box::new(
            error.help("read the vehicle's parameters, as ArduPilot's `.parm` or `.param` file has them"),
        ));
    }
    if let (Some(first), false) = (massless.first(), robot.rotors.is_empty()) {
        let message = format!("{} of the model have no `inertial`: Gazebo takes 1 kg for each", massless.len());
        let warning = Diagnostic::warning(ASSUMED, tag(*first), message).here("a link without a mass");
        robot.warnings.push(warning.help("the spec leaves them out: give every link its mass and inertia"));
    }
    let plugins: Vec<Node> = scopes.iter().flat_map(|(_, model)| children(*model, "plugin")).collect();
    for name in UNUSED {
        if plugins.iter().any(|plugin| text(*plugin, name).is_some()) {
            robot.dropped.push(name.into());
        }
    }
    let kept = ["link", "plugin", "joint", "pose", "static", "self_collide", "frame", "model"];
    let other = model.children().filter(|c| c.is_element() && !kept.contains(&c.tag_name().name()));
    robot.dropped.extend(other.map(|c| c.tag_name().name().to_string()));
    Ok(robot)
}

fn elsewhere(include: Node, message: &str) -> RobotError {
    let error = Diagnostic::error(UNSUPPORTED, tag(include), message).here("another file");
    Box::new(error.help("name a file with all links, such as `gz sdf -p model.sdf` prints"))
}

/// The joint that holds each link, of all scopes.
fn joints<'a>(scopes: &[(String, Node<'a, '_>)]) -> HashMap<String, Joint<'a>> {
    let mut found = HashMap::new();
    for (scope, model) in scopes {
        for joint in children(*model, "joint") {
            let end = |name| key(scope, text(joint, name).unwrap_or_default());
            let kind = joint.attribute("type").unwrap_or_default();
            found.entry(end("child")).or_insert(Joint { parent: end("parent"), kind });
        }
    }
    found
}

/// The warning for wings and control surfaces.
fn lift(plugin: Node) -> Option<Diagnostic> {
    let names = ["name", "filename"].iter().filter_map(|name| plugin.attribute(*name)).collect::<String>();
    let letters: String = names.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
    letters.contains("liftdrag").then(|| {
        let warning = Diagnostic::warning(UNSUPPORTED, tag(plugin), "lift and drag of a surface are left out");
        warning
            .here("a wing or control surface")
            .help("a spec has rotors alone: plans of an aircraft with wings are wrong")
    })
}

fn part(link: Node, at: &Isometry3<f64>) -> Result<Option<Part>, RobotError> {
    let Some(inertial) = child(link, "inertial") else { return Ok(None) };
    if inertial.attribute("auto").is_some_and(|word| matches!(word, "true" | "1")) {
        let message = "the inertia of a link follows from its shapes, which are not read";
        let error = Diagnostic::error(UNSUPPORTED, tag(inertial), message).here("`auto`");
        return Err(Box::new(error.help("write its mass and inertia, as `gz sdf --inertial-stats` prints them")));
    }
    let own = sdf_pose(inertial)?.unwrap_or_else(Isometry3::identity);
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

/// The moment of inertia of a rotor about its axis, kg m^2, with which its real speed gives the angular momentum of the
/// simulation: there the rotor turns slower, by `rotorVelocitySlowdownSim`.
fn spinning(link: Node, plugin: Node) -> Result<Option<f64>, RobotError> {
    let Some(inertia) = child(link, "inertial").and_then(|inertial| child(inertial, "inertia")) else {
        return Ok(None);
    };
    let izz = content::<1>(inertia, "izz")?.map(|[izz]| izz);
    let slower = content::<1>(plugin, "rotorVelocitySlowdownSim")?.map_or(SLOWDOWN, |[slower]| slower);
    Ok(izz.map(|izz| izz / slower).filter(|inertia| *inertia > 0.0 && inertia.is_finite()))
}

/// The pose of a link in the whole; `None` if there is no such link.
type Found = Result<Option<Isometry3<f64>>, RobotError>;

/// A rotor of a plugin; `None` for a plugin that is not a motor model. `find` gives the pose of a link.
pub fn motor(plugin: Node, find: &dyn Fn(&str) -> Found) -> Result<Option<RobotRotor>, RobotError> {
    let Some(constant) = content::<1>(plugin, "motorConstant")? else { return Ok(None) };
    let link = text(plugin, "linkName").unwrap_or_default();
    let Some(pose) = find(link)? else {
        let shown: String = link.chars().take(40).collect();
        let error =
            Diagnostic::error(UNSUPPORTED, tag(plugin), format!("the link `{shown}` of a motor is not in the file"));
        let help = "name a file with all links, such as `gz sdf -p model.sdf` prints";
        return Err(Box::new(error.here("a motor").help(help)));
    };
    if !is_upright(&pose) {
        let error = Diagnostic::error(UNSUPPORTED, tag(plugin), "the axis of a rotor is not upright").here("a motor");
        return Err(Box::new(error.help("a spec has rotors with parallel, upright axes only")));
    }
    // Gazebo Sim has both names, of which the first wins; RotorS and Gazebo classic have the second.
    let number = match content::<1>(plugin, "actuator_number")? {
        None => content::<1>(plugin, "motorNumber")?,
        given => given,
    };
    let number = number.map_or(0.0, |[number]| number);
    if number < 0.0 || number.fract() != 0.0 || number > 31.0 {
        let error = Diagnostic::error(SYNTAX, tag(plugin), "the number of a motor is not a whole number from 0 to 31");
        return Err(Box::new(error.here("`motorNumber` or `actuator_number`").help("number motors from 0")));
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
            None,
        ],
        drag: one("rotorDragCoefficient")?,
    }))
}
