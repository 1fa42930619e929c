//! MJCF of MuJoCo: motors at sites of one vehicle. A motor's `gear` gives its force along z and the torque about z,
//! `ctrlrange` the least and the largest control. What would change the vehicle and is not read is refused. Source:
//! MuJoCo's XML reference (3.x), `actuator/general`, `compiler`, `body/inertial`, `geom` and `default`.

mod compiler;
mod defaults;
mod mass;

use super::xml::{attribute, child, children, tag, upto};
use super::{Part, Robot, RobotError, RobotRotor};
use crate::diagnostic::Diagnostic;
use crate::import::UNSUPPORTED;
use compiler::Settings;
use defaults::Defaults;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use roxmltree::Node;
use std::collections::HashMap;

pub fn read(root: Node) -> Result<Robot, RobotError> {
    let mut robot = Robot { name: root.attribute("model").map(String::from), format: "MJCF", ..Robot::default() };
    let Some(actuators) = child(root, "actuator") else {
        let included = root.descendants().find(|node| node.tag_name().name() == "include");
        let Some((include, name)) = included.and_then(|node| Some((node, node.attribute("file")?))) else {
            return Ok(robot);
        };
        let name: String = name.chars().take(60).collect();
        let message = format!("the file has no motors itself, but includes `{name}`");
        let error = Diagnostic::error(UNSUPPORTED, tag(include), message).here("may have the vehicle");
        return Err(Box::new(error.help(format!("name `{name}`, or the file of the vehicle"))));
    };
    let settings = Settings::of(root)?;
    let defaults = Defaults::of(root);
    let mut sites: HashMap<&str, Node> = HashMap::new();
    for site in root.descendants().filter(|node| node.tag_name().name() == "site") {
        if let Some(name) = site.attribute("name") {
            sites.entry(name).or_insert(site);
        }
    }
    let mut vehicle: Option<Node> = None;
    for actuator in actuators.children().filter(Node::is_element) {
        let name = actuator.tag_name().name();
        let site = Some(actuator).filter(|_| matches!(name, "motor" | "general"));
        let site = site.and_then(|actuator| defaults.of_actuator(actuator, "site"));
        let Some(site) = site.and_then(|owner| sites.get(owner.attribute("site")?).copied()) else {
            robot.dropped.push(format!("actuator/{name}"));
            continue;
        };
        let (own, pose) = place(site, &settings)?;
        if vehicle.is_some_and(|vehicle| Some(vehicle) != own) {
            let error =
                Diagnostic::error(UNSUPPORTED, tag(site), "motors are at sites of several bodies").here("another body");
            return Err(Box::new(error.help("a spec has one rigid body")));
        }
        vehicle = own;
        robot.rotors.push(motor(&defaults, actuator, site, &pose, robot.rotors.len() + 1)?);
    }
    if let Some(vehicle) = vehicle {
        whole(root, vehicle, &mut robot, &settings, &defaults)?;
    }
    Ok(robot)
}

/// Adds the parts of the vehicle, whose masses `settotalmass` of the compiler scales together with all others.
fn whole(
    root: Node,
    vehicle: Node,
    robot: &mut Robot,
    settings: &Settings,
    defaults: &Defaults,
) -> Result<(), RobotError> {
    if let Some(other) =
        root.descendants().find(|node| matches!(node.tag_name().name(), "include" | "attach" | "replicate"))
    {
        let message =
            format!("the file has `{}`, which adds parts that it does not have itself", other.tag_name().name());
        let error = Diagnostic::error(UNSUPPORTED, tag(other), message).here("another part");
        return Err(Box::new(
            error.help("name a file with all parts, such as MuJoCo saves: `to_xml()` of a compiled `mujoco.MjSpec`"),
        ));
    }
    let mut masses = mass::Masses { settings, defaults, unknown: None, inner_joint: None };
    masses.add(vehicle, &Isometry3::identity(), true, &mut robot.parts)?;
    if let Some(shape) = masses.unknown {
        let warning = Diagnostic::warning(UNSUPPORTED, tag(shape), "the mass of this shape is not computed");
        robot.warnings.push(warning.here("mass and inertia become `?`").help(
            "write them in the spec, as MuJoCo computes them: `body_subtreemass` and the inertia about the centre",
        ));
        robot.parts.clear();
        return Ok(());
    }
    if let Some(joint) = masses.inner_joint {
        let warning = Diagnostic::warning(UNSUPPORTED, tag(joint), "a part that moves counts as rigid");
        robot.warnings.push(warning.here("its joint").help("a spec has one rigid body"));
    }
    if let Some(total) = settings.total_mass {
        let mut all = Vec::new();
        let worlds = root.children().filter(|node| node.tag_name().name() == "worldbody");
        let bodies = worlds.flat_map(|world| children(world, "body"));
        let mut others = mass::Masses { settings, defaults, unknown: None, inner_joint: None };
        for body in bodies {
            others.add(body, &Isometry3::identity(), true, &mut all)?;
        }
        let factor = total / all.iter().map(|part: &Part| part.mass).sum::<f64>();
        for part in robot.parts.iter_mut().filter(|_| factor.is_finite()) {
            part.mass *= factor;
            part.inertia *= factor;
        }
    }
    Ok(())
}

/// The outermost body around a site, and the pose of the site in it.
fn place<'a, 'i>(
    site: Node<'a, 'i>,
    settings: &Settings,
) -> Result<(Option<Node<'a, 'i>>, Isometry3<f64>), RobotError> {
    let mut pose = pose_of(site, settings)?;
    let mut at = site.parent_element();
    let mut own = None;
    while let Some(node) = at {
        let next = node.parent_element();
        let is_outermost = next.is_none_or(|next| !matches!(next.tag_name().name(), "body" | "frame"));
        if is_outermost || node.tag_name().name() != "body" && node.tag_name().name() != "frame" {
            return Ok((Some(node), pose));
        }
        if node.tag_name().name() == "body" {
            let is_own = own.is_none();
            own = Some(node);
            turns_only(node, is_own)?;
        }
        pose = pose_of(node, settings)? * pose;
        at = next;
    }
    Ok((None, pose))
}

/// Refuses joints between the vehicle and a rotor, but a hinge about z of the rotor's own body: that of a propeller.
fn turns_only(body: Node, is_own: bool) -> Result<(), RobotError> {
    for joint in children(body, "joint") {
        let axis = attribute::<3>(joint, "axis")?.unwrap_or([0.0, 0.0, 1.0]);
        let is_upright = axis[0] == 0.0 && axis[1] == 0.0;
        if !(is_own && is_upright && matches!(joint.attribute("type"), None | Some("hinge"))) {
            let error = Diagnostic::error(UNSUPPORTED, tag(joint), "a rotor is on an arm that moves");
            return Err(Box::new(error.here("the joint of the arm").help("a spec has rotors with fixed axes only")));
        }
    }
    Ok(())
}

/// The pose of an element in the one around it.
fn pose_of(node: Node, settings: &Settings) -> Result<Isometry3<f64>, RobotError> {
    let place = attribute::<3>(node, "pos")?.map_or_else(Vector3::zeros, Vector3::from);
    Ok(Isometry3::from_parts(Translation3::from(place), settings.turn(node)?.unwrap_or_else(UnitQuaternion::identity)))
}

fn motor(
    defaults: &Defaults,
    actuator: Node,
    site: Node,
    pose: &Isometry3<f64>,
    number: usize,
) -> Result<RobotRotor, RobotError> {
    let of = |name: &'static str| defaults.of_actuator(actuator, name);
    let refuse = |message: String, here: &str| {
        let error = Diagnostic::error(UNSUPPORTED, tag(actuator), message).here(here.to_string());
        Err(Box::new(error.help("a motor of a spec has a thrust in proportion to its control, along z of its site")))
    };
    let gear = of("gear").map(|owner| upto::<6>(owner, "gear")).transpose()?.flatten();
    let [fx, fy, force, tx, ty, torque] = gear.unwrap_or_default();
    if [fx, fy, force] == [0.0; 3] && [tx, ty, torque] != [0.0; 3] {
        let message = "this actuator is a moment of the whole body, not the thrust of a rotor";
        let error = Diagnostic::error(UNSUPPORTED, tag(actuator), message).here("its `gear` has no force");
        let help = "a spec needs each rotor: write a motor at a site for each, or the vehicle by hand";
        return Err(Box::new(error.help(help)));
    }
    if [fx, fy, tx, ty].iter().any(|part| *part != 0.0) || force <= 0.0 {
        let error = Diagnostic::error(UNSUPPORTED, tag(actuator), "a motor does not push along z of its site")
            .here("its `gear`");
        return Err(Box::new(error.help("a spec has rotors with parallel, upright axes only")));
    }
    if !super::xml::is_upright(pose) {
        let error = Diagnostic::error(UNSUPPORTED, tag(site), "the site of a motor is turned");
        return Err(Box::new(error.here("its site").help("a spec has rotors with parallel, upright axes only")));
    }
    let mut gain = 1.0;
    let mut lag = None;
    // `motor` fixes the gain at 1, without bias or dynamics.
    if actuator.tag_name().name() == "general" {
        let word = |name| of(name).and_then(|owner| owner.attribute(name));
        let first = |name| of(name).map(|owner| upto::<10>(owner, name)).transpose().map(Option::flatten);
        if word("gaintype").is_some_and(|kind| kind != "fixed") || word("biastype").is_some_and(|kind| kind != "none") {
            return refuse("a motor has a gain or bias that depends on its motion".into(), "`gaintype` or `biastype`");
        }
        gain = first("gainprm")?.map_or(1.0, |list| list[0]);
        let dynamics = word("dyntype").unwrap_or("none");
        lag = match dynamics {
            "none" => None,
            "filter" | "filterexact" => Some(first("dynprm")?.map_or(1.0, |list| list[0])).filter(|lag| *lag > 0.0),
            _ => return refuse(format!("a motor has the dynamics `{dynamics}`"), "`dyntype`"),
        };
    }
    let is_limited = |name| of(name).and_then(|owner| owner.attribute(name)) != Some("false");
    let range = of("ctrlrange").filter(|_| is_limited("ctrllimited"));
    let range = range.map(|owner| attribute::<2>(owner, "ctrlrange")).transpose()?.flatten();
    let bounds = of("forcerange").filter(|_| is_limited("forcelimited"));
    let bounds = bounds.map(|owner| attribute::<2>(owner, "forcerange")).transpose()?.flatten();
    let [low, high] = bounds.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let ends = range.map(|[least, most]| [least * gain, most * gain]);
    if gain <= 0.0 || ends.is_some_and(|[least, most]| least > most) || low > high {
        return refuse("the thrust of a motor falls with its control".into(), "its gain or range");
    }
    let ends = match (ends, bounds) {
        (Some(ends), _) => Some(ends.map(|end| end.clamp(low, high))),
        (None, bounds) => bounds,
    };
    let thrust = |end: f64| Some(end * force).filter(|thrust| *thrust != 0.0);
    Ok(RobotRotor {
        place: pose.translation.vector,
        // The body feels the torque against the turning rotor.
        is_ccw: (torque != 0.0).then_some(torque < 0.0),
        motor: number,
        figures: [
            None,
            Some((torque / force).abs()).filter(|ratio| *ratio > 0.0),
            None,
            ends.and_then(|[_, most]| thrust(most)),
            ends.and_then(|[least, _]| thrust(least)),
            lag,
            None,
        ],
        drag: None,
    })
}
