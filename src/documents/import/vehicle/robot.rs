//! Vehicles of simulators: URDF, SDF and MJCF. Masses and inertias are those of all parts together, places those from
//! their common centre of gravity.

mod lenient;
mod mjcf;
mod sdf;
mod urdf;
mod xml;

use super::draft::{Draft, Field, Figure, Rotor, name_from, name_from_file};
use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, Outcome, SYNTAX, UNSUPPORTED, at, estimate};
use crate::read::vehicle::ROTORS;
use crate::source::{Source, Span};
use nalgebra::{Matrix3, Vector3};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::{HashMap, HashSet};

/// The most elements and texts of a file: a robot has thousands.
const MOST_NODES: u32 = 500_000;

/// The most attributes of one element, and the most namespaces of a file: the parser compares each with all others.
const MOST_ATTRIBUTES: usize = 1_000;

/// Rotors beyond this are too many for a spec, and not looked at.
const MOST_ROTORS: usize = *ROTORS.end();

/// Products of inertia above this share of the smallest moment are named: a spec has none.
const MOST_PRODUCT: f64 = 0.02;

/// Why a file is not read as a vehicle, with the place in it.
type RobotError = Box<Diagnostic>;

/// Whether a text is XML.
pub fn is_one(text: &str) -> bool {
    text.trim_start().starts_with('<')
}

/// The joint that holds a link.
pub struct Joint<'a> {
    pub parent: String,
    /// `fixed`, `revolute` and so on.
    pub kind: &'a str,
}

/// Refuses a rotor whose link is on an arm that turns: its own joint is that of the propeller, and every joint between
/// its arm and the vehicle must be fixed. `joints` are by the link that they hold.
fn turning_arm(link: &str, joints: &HashMap<String, Joint>, rotor: Node) -> Result<(), RobotError> {
    let mut arm = joints.get(link).map(|own| own.parent.as_str());
    let mut passed = 0;
    while let Some(joint) = arm.and_then(|arm| joints.get(arm)) {
        if joint.kind != "fixed" {
            let shown: String = arm.unwrap_or_default().chars().take(40).collect();
            let message = format!("a rotor is on the arm `{shown}`, which turns or slides");
            let error = Diagnostic::error(UNSUPPORTED, xml::tag(rotor), message).here("a motor");
            let kind: String = joint.kind.chars().take(20).collect();
            return Err(Box::new(error.help(format!(
                "its joint is `{kind}`: a spec has rotors with fixed axes only; make it `fixed` if the arm never moves"
            ))));
        }
        passed += 1;
        arm = Some(joint.parent.as_str()).filter(|_| passed <= joints.len());
    }
    Ok(())
}

/// What a file says of a vehicle.
#[derive(Default)]
pub struct Robot {
    pub name: Option<String>,
    pub format: &'static str,
    /// Rigid parts; empty if the file gives no masses.
    pub parts: Vec<Part>,
    pub rotors: Vec<RobotRotor>,
    /// Radius of the propellers, m.
    pub radius: Option<f64>,
    /// What was left out.
    pub dropped: Vec<String>,
    pub warnings: Vec<Diagnostic>,
}

/// A rigid part in the frame of the whole: mass (kg), centre of gravity (m), inertia about it (kg m^2).
pub struct Part {
    pub mass: f64,
    pub centre: Vector3<f64>,
    pub inertia: Matrix3<f64>,
}

/// A rotor in the frame of the whole; `None` where the file does not say. N s^2/rad^2, m, rad/s, N, N, s, kg m^2.
#[derive(Default, Clone)]
pub struct RobotRotor {
    pub place: Vector3<f64>,
    /// Whether it turns counter-clockwise seen from above.
    pub is_ccw: Option<bool>,
    pub motor: usize,
    pub figures: [Option<f64>; 7],
    /// The force of the air across its axis, for each unit of its speed (rad/s) and of the air's (m/s), N s^2/m.
    pub drag: Option<f64>,
}

/// The fields of [`RobotRotor::figures`] and their units.
const FIGURES: [(&str, &str); 7] = [
    ("thrust_coefficient", "N*s^2/rad^2"),
    ("torque_per_thrust", "m"),
    ("max_speed", "rad/s"),
    ("max_thrust", "N"),
    ("min_thrust", "N"),
    ("time_constant", "s"),
    ("rotor_inertia", "kg*m^2"),
];

/// The place of `rotor_inertia` in [`FIGURES`].
const ROTOR_INERTIA: usize = 6;

/// The vehicle of an XML file.
pub fn vehicle(source: &Source, found: &mut Vec<Diagnostic>) -> Outcome {
    if let Some(place) = xml::crowded(&source.text, MOST_ATTRIBUTES) {
        let message = format!("an element has more than {MOST_ATTRIBUTES} attributes, or the file as many namespaces");
        let error = Diagnostic::error(SYNTAX, at(place), message).here("this one is too many");
        return Err(Box::new(error.help("name the file of one robot")));
    }
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let text = lenient::accepted(&source.text);
    let document = Document::parse_with_options(&text, options).map_err(|error| Box::new(not_xml(source, &error)))?;
    let root = document.root_element();
    let robot = match root.tag_name().name() {
        "robot" => urdf::read(source, root)?,
        "sdf" => sdf::read(root)?,
        "mujoco" => mjcf::read(root)?,
        other => {
            let shown: String = other.chars().take(24).collect();
            let error =
                Diagnostic::error(UNSUPPORTED, xml::tag(root), format!("`{shown}` is not a robot that mavc reads"));
            return Err(Box::new(error.here("the root").help("name a file whose root is `robot`, `sdf` or `mujoco`")));
        }
    };
    let whole = robot_text(source, robot, xml::tag(root), found)?;
    Ok(whole)
}

fn not_xml(source: &Source, error: &roxmltree::Error) -> Diagnostic {
    let place = error.pos();
    let line = source.line((place.row as usize).max(1));
    let column = (place.col as usize).saturating_sub(1);
    let from = source.text[line.clone()].char_indices().nth(column).map_or(line.end, |(i, _)| line.start + i);
    let to = source.text[from..].chars().next().filter(|c| *c != '\n').map_or(from, |c| from + c.len_utf8());
    let words = error.to_string();
    // The place is shown below.
    let words = words.rsplit_once(" at ").map_or(words.as_str(), |(words, _)| words).to_string();
    let error = Diagnostic::error(SYNTAX, at(from..to), format!("the file is not well-formed XML: {words}"));
    error.here("here").help("save the file again, or mend this place")
}

fn robot_text(source: &Source, mut robot: Robot, root: Span, found: &mut Vec<Diagnostic>) -> Outcome {
    found.append(&mut robot.warnings);
    if !ROTORS.contains(&robot.rotors.len()) {
        let message = match robot.rotors.len() {
            0 => "no rotor was found in the file".to_string(),
            n => format!("a spec has 4 to 32 rotors, and the file {n}"),
        };
        let error = Diagnostic::error(UNSUPPORTED, root, message).here(format!("this {} file", robot.format));
        return Err(Box::new(error.help(
            "rotors are plugins of a motor model (SDF, URDF), links `prop0_link` beside `properties` (URDF), or \
             motors at sites (MJCF); without them, `mavc new --vehicle` makes a spec from mass, size and propellers",
        )));
    }
    let whole = Part::whole(&robot.parts);
    let centre = whole.as_ref().map_or(Vector3::zeros(), |whole| whole.centre);
    let (mass, inertia) = match &whole {
        Some(whole) => {
            let smallest = whole.inertia.diagonal().min();
            let products = [whole.inertia.m12, whole.inertia.m13, whole.inertia.m23];
            if products.iter().any(|p| p.abs() > MOST_PRODUCT * smallest) {
                let warning = Diagnostic::warning(UNSUPPORTED, root, "products of inertia are left out");
                found.push(
                    warning.here("the axes are not principal axes").help("a spec has moments about x, y and z only"),
                );
            }
            let moments = whole.inertia.diagonal();
            let list = [moments.x, moments.y, moments.z].map(rounded);
            let figure = Figure::Known(format!("[{}, {}, {}] kg*m^2", list[0], list[1], list[2]));
            let inertia = if smallest > 0.0 { figure } else { Figure::Unknown };
            (Figure::Known(format!("{} kg", rounded(whole.mass))), inertia)
        }
        None => (Figure::Unknown, Figure::Unknown),
    };
    if let Some(what) = not_finite(whole.as_ref(), centre, &robot.rotors) {
        let error = Diagnostic::error(SYNTAX, root, format!("{what} is not a finite number"));
        return Err(Box::new(error.here("follows from the numbers of this file").help("correct the numbers")));
    }
    let (shared, own) = rotor_figures(&robot.rotors);
    let mut numbers: Vec<usize> = robot.rotors.iter().map(|rotor| rotor.motor).collect();
    if numbers.iter().collect::<HashSet<_>>().len() < numbers.len() {
        let message = "several motors have the same number, or none: the spec numbers them in the file's order";
        let warning = Diagnostic::warning(ASSUMED, root, message).here("this file");
        found.push(warning.help("correct the numbers after `motor`, which exports for autopilots use"));
        numbers = (1..=numbers.len()).collect();
    }
    let rotors = robot.rotors.iter().zip(own).zip(numbers).map(|((rotor, own), motor)| {
        let [x, y, z] = <[f64; 3]>::from(rotor.place - centre).map(rounded);
        Rotor {
            place: format!("[{x}, {y}, {z}] m"),
            spin: rotor.is_ccw.map_or(Figure::Unknown, |ccw| Figure::Known(if ccw { "P" } else { "N" }.into())),
            motor,
            own,
            remark: rotor.is_ccw.is_none().then(|| "spin seen from above: P counter-clockwise, N clockwise".into()),
        }
    });
    let drag = whole.as_ref().and_then(|whole| drag(whole.mass, &robot.rotors));
    let mut estimates = whole.as_ref().map_or_else(Vec::new, |whole| estimates(whole.mass, centre, &robot, drag));
    let has_inertia = robot.rotors.iter().any(|rotor| rotor.figures[ROTOR_INERTIA].is_some());
    estimates.retain(|(name, ..)| !(*name == "drag" && drag.is_some() || *name == "rotor_inertia" && has_inertia));
    let mut fields = vec![Field::new("mass", mass), Field::new("inertia", inertia)];
    let radius = robot.radius.map(|radius| Figure::Known(format!("{} m", shortest(radius))));
    fields.extend(radius.map(|radius| Field::new("propeller_radius", radius)));
    fields.extend(drag.map(|drag| {
        let figure = Figure::Known(format!("[{0}, {0}, 0] N*s/m", shortest(drag)));
        Field::new("drag", figure).remark("rotorDragCoefficient, at the speeds of hover")
    }));
    let draft = Draft {
        name: robot.name.as_deref().map_or_else(|| name_from_file(&source.name), name_from),
        from: vec![
            format!("From {}. Figures that it does not give are `?`.", robot.format),
            "x forward, y left, z up from the centre of gravity of all parts.".into(),
        ],
        title: None,
        lets: Vec::new(),
        fields,
        estimates,
        shared,
        rotors: rotors.collect(),
        battery: Vec::new(),
    };
    Ok((draft.text(), robot.dropped))
}

/// The drag across the vertical axis of a vehicle of `mass` kg, N s/m, by rotors that hover at equal speeds; `None` if
/// a rotor has no coefficient of it, or of thrust.
fn drag(mass: f64, rotors: &[RobotRotor]) -> Option<f64> {
    let sum = |of: fn(&RobotRotor) -> Option<f64>| rotors.iter().map(of).sum::<Option<f64>>();
    let speed = (mass * estimate::GRAVITY / sum(|rotor| rotor.figures[0])?).sqrt();
    let drag: f64 = format!("{:.3e}", sum(|rotor| rotor.drag)? * speed).parse().ok()?;
    (drag.is_finite() && drag > 0.0).then_some(drag)
}

/// Drag, yaw drag and rotor inertia, where the file has none, from the mass (kg) and the rotors about the centre of
/// gravity; nothing if the file does not give their thrust and speed.
fn estimates(
    mass: f64,
    centre: Vector3<f64>,
    Robot { rotors, radius: propeller_radius, .. }: &Robot,
    drag: Option<f64>,
) -> Vec<(&'static str, String, String)> {
    let thrust = |rotor: &RobotRotor| {
        let [coefficient, _, speed, thrust, ..] = rotor.figures;
        thrust.or(coefficient.zip(speed).map(|(coefficient, speed)| coefficient * speed * speed)).zip(speed)
    };
    let from_thrust = |rotor: &RobotRotor| thrust(rotor).map(|(thrust, speed)| estimate::diameter(thrust, speed));
    let all: Option<Vec<f64>> = match propeller_radius {
        Some(radius) => Some(vec![2.0 * *radius]),
        None => rotors.iter().map(from_thrust).collect(),
    };
    let distance = |rotor: &RobotRotor| (rotor.place - centre).xy().norm();
    let radius = rotors.iter().map(distance).sum::<f64>() / rotors.len() as f64;
    let diameter = all.map(|all| all.iter().sum::<f64>() / all.len() as f64);
    let known = diameter.map(|diameter| estimate::Known { mass, rotors: rotors.len(), radius, diameter, drag });
    let is_usable = |known: &estimate::Known| {
        [known.mass, known.radius, known.diameter].iter().all(|x| x.is_finite() && *x > 0.0)
            && known.yaw_drag().is_finite()
    };
    known.filter(is_usable).map_or_else(Vec::new, |known| known.lines().into())
}

/// Numbers of the file may be so large or small that products and ratios of them are infinite.
fn not_finite(whole: Option<&Part>, centre: Vector3<f64>, rotors: &[RobotRotor]) -> Option<String> {
    let is_part = |part: &Part| part.mass.is_finite() && part.centre.iter().chain(&part.inertia).all(|x| x.is_finite());
    if !whole.is_none_or(is_part) {
        return Some("the mass, centre of gravity or inertia".into());
    }
    for rotor in rotors {
        let figure = rotor.figures.iter().zip(FIGURES).find(|(figure, _)| figure.is_some_and(|x| !x.is_finite()));
        if let Some((_, (name, _))) = figure {
            return Some(format!("`{name}` of motor {}", rotor.motor));
        }
        if !(rotor.place - centre).iter().all(|x| x.is_finite()) {
            return Some(format!("the place of motor {}", rotor.motor));
        }
    }
    None
}

type Own = Vec<Vec<(&'static str, Figure)>>;

/// What all rotors share, and what each has of its own.
fn rotor_figures(rotors: &[RobotRotor]) -> (Vec<Field>, Own) {
    let mut shared = Vec::new();
    let mut own: Own = vec![Vec::new(); rotors.len()];
    let text = |value: f64, unit: &str| Figure::Known(format!("{} {unit}", shortest(value)));
    for (i, (name, unit)) in FIGURES.into_iter().enumerate() {
        let first = rotors[0].figures[i];
        let is_one = rotors.iter().all(|rotor| rotor.figures[i] == first);
        // Full thrust follows from the coefficient, and a rotor need not have an idle speed or a time constant.
        let others = |j: usize| rotors.iter().all(|rotor| rotor.figures[j].is_some());
        let is_needed = match name {
            "thrust_coefficient" => false,
            "max_thrust" => !others(0),
            "torque_per_thrust" | "max_speed" => true,
            _ => false,
        };
        match first {
            Some(value) if is_one => shared.push(Field::new(name, text(value, unit))),
            None if is_one && is_needed => shared.push(Field::new(name, Figure::Unknown)),
            None if is_one => {}
            _ => {
                for (rotor, own) in rotors.iter().zip(&mut own) {
                    match rotor.figures[i] {
                        Some(value) => own.push((name, text(value, unit))),
                        None if is_needed => own.push((name, Figure::Unknown)),
                        None => {}
                    }
                }
            }
        }
    }
    (shared, own)
}

impl Part {
    /// All parts as one rigid body; `None` without a mass. Moments are moved by Steiner's theorem.
    fn whole(parts: &[Part]) -> Option<Part> {
        let mass: f64 = parts.iter().map(|part| part.mass).sum();
        if mass <= 0.0 {
            return None;
        }
        let centre = parts.iter().map(|part| part.centre * part.mass).sum::<Vector3<f64>>() / mass;
        let moved = |part: &Part| {
            let r = part.centre - centre;
            part.inertia + (Matrix3::identity() * r.dot(&r) - r * r.transpose()) * part.mass
        };
        Some(Part { mass, centre, inertia: parts.iter().map(moved).sum() })
    }
}

/// To twelve significant digits, which hides the rounding of sums; without the sign of a zero.
fn rounded(value: f64) -> f64 {
    if value.abs() < 1e-12 { 0.0 } else { format!("{value:.11e}").parse().unwrap_or(value) }
}

/// In the shortest form, with an exponent for small numbers.
fn shortest(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-3 { format!("{value:e}") } else { format!("{value}") }
}
