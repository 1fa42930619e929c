//! Multirotors of ArduPilot: the frame by `FRAME_CLASS` and `FRAME_TYPE`; its parameters give neither arms nor masses.
//! Full thrust follows from the mass by `MOT_THST_HOVER`, which the autopilot learns in flight, unless it is the
//! default. Sources: `AP_MotorsMulticopter.cpp` and `AP_BattMonitor_Params.cpp` of ArduPilot 4.5.

use super::draft::{Draft, Field, Figure, Rotor, battery, full_thrust_from_hover, name_from_file};
use super::frames::{FRAMES, Frame, Motors, OTHER_CLASSES};
use super::parameters::{Parameter, Parameters, set_twice};
use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, Outcome, UNSUPPORTED};
use crate::number::number as shown;
use crate::source::Source;

/// The frame where a file gives no `FRAME_TYPE`: X.
const DEFAULT_TYPE: u32 = 1;

/// Defaults: the share of full thrust in hover, and mA h of a battery.
const DEFAULT_HOVER: f64 = 0.35;
const DEFAULT_CAPACITY: f64 = 3300.0;
/// The voltage of a full cell of a lithium polymer battery, and its nominal voltage, V.
const FULL_CELL: f64 = 4.2;
const CELL: f64 = 3.7;

/// The class of three arms with two motors each.
const Y6: u32 = 5;

/// Beginnings of names that only one kind of vehicle has, with the vehicle and what the name is. Rovers and boats have
/// `FRAME_CLASS` too.
const OTHER_VEHICLES: [(&str, &str, &str); 14] = [
    ("Q_FRAME_CLASS", "a quadplane, a VTOL aircraft", "its lifting rotors alone"),
    ("ATC_STR_RAT_", "a rover or boat", "a gain of its steering"),
    ("ATC_STR_ANG_P", "a rover or boat", "a gain of its steering"),
    ("ATC_SPEED_", "a rover or boat", "a gain of its speed"),
    ("ATC_BRAKE", "a rover or boat", "whether it brakes"),
    ("ATC_BAL_", "a rover or boat", "a gain of its balance"),
    ("CRUISE_THROTTLE", "a rover or boat", "its throttle"),
    ("TURN_RADIUS", "a rover or boat", "the radius of its turns"),
    ("MODE_CH", "a rover or boat", "the channel of its modes"),
    ("FRAME_CONFIG", "a submarine", "its frame"),
    ("H_RSC_", "a helicopter", "the speed of its rotor"),
    ("H_SW", "a helicopter", "its swash plate"),
    ("TECS_", "a plane", "the control of its speed and height"),
    ("RLL2SRV_", "a plane", "a gain of its ailerons"),
];

/// The error for parameters of another vehicle of ArduPilot, or of versions in which the firmware has the class; `None`
/// if they are none of these.
pub fn other_vehicle(parameters: &Parameters) -> Option<Diagnostic> {
    let of = |name: &str| parameters.get(name);
    let begins = |prefix: &str| parameters.names().find(|name| name.starts_with(prefix)).and_then(of);
    let found = OTHER_VEHICLES.iter().find_map(|(prefix, what, here)| {
        // A class of a helicopter has an error of its own.
        let is_known = *what != "a helicopter" || of("FRAME_CLASS").is_none();
        begins(prefix).filter(|_| is_known).map(|parameter| (parameter, *what, *here))
    });
    if let Some((parameter, what, here)) = found {
        let error = Diagnostic::error(UNSUPPORTED, parameter.span, format!("these are parameters of {what}"));
        return Some(error.here(here).help("name the parameters of a multirotor with `FRAME_CLASS`"));
    }
    let kind = of("FRAME").filter(|_| of("FRAME_CLASS").is_none())?;
    let message = "these are parameters of ArduCopter before 3.5, whose firmware has the class of the frame";
    let help = "write a line `FRAME_CLASS,1` for a quadcopter, 2 for a hexa-, 3 for an octocopter, 4 for an X8 or 5 \
                for a Y6, and `FRAME_TYPE` with this value, into a copy of the file";
    Some(Diagnostic::error(UNSUPPORTED, kind.span, message).here("its type").help(help))
}

/// The vehicle of some parameters with `FRAME_CLASS`.
pub fn vehicle(source: &Source, parameters: &Parameters, found: &mut Vec<Diagnostic>) -> Outcome {
    let class = parameters.get("FRAME_CLASS").expect("the caller looked");
    let kind = parameters.get("FRAME_TYPE");
    let number = |parameter: Parameter| match parameter.value {
        value if value >= 0.0 && value.fract() == 0.0 && value < 1000.0 => Some(value as u32),
        _ => None,
    };
    let kind_number = kind.map_or(Some(DEFAULT_TYPE), number);
    let frame = number(class).zip(kind_number).and_then(|(c, k)| frame_of(c, k));
    let Some(frame) = frame else { return Err(Box::new(no_frame(class, kind, number(class)))) };
    if let Motors::No(why) = frame.motors {
        let at = kind.unwrap_or(class).span;
        let error = Diagnostic::error(UNSUPPORTED, at, format!("a spec cannot say the frame \"{}\"", frame.name));
        return Err(Box::new(error.here(why).help("write the vehicle by hand if it is close enough")));
    }
    if kind.is_none() && FRAMES.iter().filter(|other| other.class == frame.class).count() > 1 {
        let message = format!("the file has no `FRAME_TYPE`: ArduPilot takes {DEFAULT_TYPE}, \"{}\"", frame.name);
        let warning = Diagnostic::warning(ASSUMED, class.span, message).here("has several types");
        found.push(warning.help("add `FRAME_TYPE` if the vehicle has another"));
    }
    let names = ["FRAME_CLASS", "FRAME_TYPE"];
    let read = parameters.repeated().filter(|(name, ..)| names.contains(name));
    found.extend(read.map(|(name, first, last)| set_twice(name, first, last)));
    let figures = Figures::of(parameters);
    if let Some(hover) = parameters.get("MOT_THST_HOVER").filter(|_| figures.hover.is_some()) {
        let message = "full thrust is computed from the mass and the thrust with which the vehicle hovers";
        let warning = Diagnostic::warning(ASSUMED, hover.span, message).here("the share of full thrust in hover");
        found.push(warning.help("it is as exact as `MOT_THST_EXPO`: measure full thrust if you can"));
    }
    let text = draft(source, frame, &figures).text();
    let kept = |name: &&str| matches!(*name, "FRAME_CLASS" | "FRAME_TYPE") || figures.used.contains(name);
    Ok((text, parameters.names().filter(|name| !kept(name)).map(String::from).collect()))
}

/// Figures of a vehicle that the parameters hold, and these parameters; a default was never measured, and gives none.
struct Figures {
    /// The share of full thrust with which the vehicle hovers.
    hover: Option<f64>,
    /// The fields of `battery`.
    battery: Vec<Field>,
    used: Vec<&'static str>,
}

impl Figures {
    fn of(parameters: &Parameters) -> Self {
        let value = |name: &str| parameters.get(name).map(|parameter| parameter.value).filter(|x| *x > 0.0);
        let hover = value("MOT_THST_HOVER").filter(|x| *x < 1.0 && *x as f32 != DEFAULT_HOVER as f32);
        let capacity = value("BATT_CAPACITY").filter(|x| *x != DEFAULT_CAPACITY);
        let cells = value("MOT_BAT_VOLT_MAX").map(|volts| (volts / FULL_CELL).round()).filter(|cells| *cells >= 1.0);
        let voltage = cells.map(|n| (CELL * n, format!("{n} cells of {CELL} V, from MOT_BAT_VOLT_MAX")));
        let voltage_used = capacity.is_some() && voltage.is_some();
        let battery = capacity.map_or(Vec::new(), |capacity| battery(capacity, "BATT_CAPACITY", voltage));
        let used = [
            ("MOT_THST_HOVER", hover.is_some()),
            ("BATT_CAPACITY", capacity.is_some()),
            ("MOT_BAT_VOLT_MAX", voltage_used),
        ];
        let used = used.into_iter().filter(|(_, is_used)| *is_used).map(|(name, _)| name).collect();
        Figures { hover, battery, used }
    }
}

/// A Y6 of any other type is the Y6 of type 0.
fn frame_of(class: u32, kind: u32) -> Option<&'static Frame> {
    let find = |kind: u32| FRAMES.iter().find(|frame| (frame.class, frame.kind) == (class, kind));
    find(kind).or_else(|| find(0).filter(|_| class == Y6))
}

fn no_frame(class: Parameter, kind: Option<Parameter>, number: Option<u32>) -> Diagnostic {
    let known = number.filter(|class| FRAMES.iter().any(|frame| frame.class == *class));
    let other = number.and_then(|class| OTHER_CLASSES.iter().find(|(c, _)| *c == class));
    let help = "name the parameters of a multirotor whose frame is in ArduPilot's tables of motors";
    match (known, kind, other) {
        (Some(class), Some(kind), _) => {
            let message = format!("`FRAME_CLASS` {class} has no frame type {}", shown(kind.value));
            Diagnostic::error(UNSUPPORTED, kind.span, message).here("no table of motors").help(help)
        }
        (_, _, Some((_, what))) => {
            let message = format!("`FRAME_CLASS` {} is {what}", shown(class.value));
            let help = if class.value == 0.0 {
                "choose the frame in the ground station, and save the parameters again"
            } else {
                help
            };
            Diagnostic::error(UNSUPPORTED, class.span, message).here("no multirotor").help(help)
        }
        _ => {
            let message = format!("`FRAME_CLASS` {} is unknown", shown(class.value));
            Diagnostic::error(UNSUPPORTED, class.span, message).here("no table of motors").help(help)
        }
    }
}

fn draft(source: &Source, frame: &Frame, figures: &Figures) -> Draft {
    let (places, arm) = match frame.motors {
        Motors::Ring(text) => {
            (text.split(' ').map(on_ring).collect::<Vec<_>>(), "from the centre of gravity to a motor")
        }
        Motors::Places(text) => (
            text.split(' ').map(placed).collect(),
            "forward to the foremost motors; the others in proportion, as ArduPilot mixes",
        ),
        Motors::No(_) => (Vec::new(), ""),
    };
    let rotor = |(i, (place, spin)): (usize, (String, String))| Rotor {
        place,
        spin: Figure::Known(spin),
        motor: i + 1,
        own: Vec::new(),
        remark: None,
    };
    let unknown = |name| Field::new(name, Figure::Unknown);
    let mut lets = vec![unknown("arm").remark(arm)];
    let (mut mass, mut thrust) = (unknown("mass"), unknown("max_thrust"));
    if let Some(share) = figures.hover {
        let (figure, remark) = full_thrust_from_hover(places.len(), share, "MOT_THST_HOVER");
        lets.push(std::mem::replace(&mut mass, Field::new("mass", Figure::Known("mass".into()))));
        thrust = Field::new("max_thrust", figure).remark(remark);
    }
    Draft {
        name: name_from_file(&source.name),
        from: vec![
            format!(
                "From parameters of ArduPilot: FRAME_CLASS {}, FRAME_TYPE {}, \"{}\".",
                frame.class, frame.kind, frame.name
            ),
            "Figures that they do not give are `?`. Motors have ArduPilot's numbers.".into(),
        ],
        title: None,
        lets,
        fields: vec![mass, unknown("inertia").remark("[Ixx, Iyy, Izz]")],
        estimates: Vec::new(),
        shared: vec![thrust, unknown("torque_per_thrust"), unknown("max_speed")],
        rotors: places.into_iter().enumerate().map(rotor).collect(),
        battery: figures.battery.clone(),
    }
}

/// `-22.5P`: degrees clockwise from the nose.
fn on_ring(text: &str) -> (String, String) {
    let (angle, spin) = text.split_at(text.len() - 1);
    let place = match angle {
        "0" => "[arm, 0 m, 0 m]".to_string(),
        "180" => "[-arm, 0 m, 0 m]".to_string(),
        "90" => "[0 m, -arm, 0 m]".to_string(),
        "-90" => "[0 m, arm, 0 m]".to_string(),
        _ => {
            let left = angle.strip_prefix('-').map_or_else(|| format!("-{angle}"), str::to_string);
            format!("[arm*cos({left} deg), arm*sin({left} deg), 0 m]")
        }
    };
    (place, spin.to_string())
}

/// `0.34,-1P`: shares of the arm forward and to the left.
fn placed(text: &str) -> (String, String) {
    let (pair, spin) = text.split_at(text.len() - 1);
    let share = |text: &str| match text {
        "0" => "0 m".to_string(),
        "1" => "arm".to_string(),
        "-1" => "-arm".to_string(),
        other => format!("{other}*arm"),
    };
    let (forward, left) = pair.split_once(',').expect("the table has pairs");
    (format!("[{}, {}, 0 m]", share(forward), share(left)), spin.to_string())
}
