//! Multirotors of PX4's control allocation: `CA_ROTORi_PX`, `_PY`, `_PZ` (m; forward, right, down from the centre of
//! gravity), `_AX`, `_AY`, `_AZ` (axis), `_CT` (thrust at full command, N) and `_KM` (torque per thrust, m, above zero
//! for a rotor that turns counter-clockwise seen from above). Source: PX4 user guide, "Control Allocation", and its
//! parameter reference.

mod figures;
pub mod script;

use super::draft::{Draft, Field, Figure, Rotor, full_thrust_from_hover, name_from_file};
use super::parameters::{Parameters, set_twice};
use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, Outcome, SYNTAX, UNSUPPORTED, at};
use crate::number::number;
use crate::read::vehicle::ROTORS;
use crate::source::{Source, Span};
use figures::Figures;
use script::Reason;

/// What each value of `CA_AIRFRAME` means, where it is not a multirotor.
const AIRFRAMES: [(f64, &str); 15] = [
    (1.0, "a fixed-wing aircraft"),
    (2.0, "a VTOL aircraft"),
    (3.0, "a tiltrotor VTOL aircraft"),
    (4.0, "a tailsitter"),
    (5.0, "a rover"),
    (6.0, "a rover"),
    (7.0, "a vehicle of six degrees of freedom"),
    (8.0, "a multirotor with tilting rotors"),
    (9.0, "a vehicle of its own kind (`Custom`)"),
    (10.0, "a helicopter"),
    (11.0, "a helicopter"),
    (12.0, "a coaxial helicopter"),
    (13.0, "a rover"),
    (14.0, "a spacecraft"),
    (15.0, "a spacecraft"),
];

/// PX4's defaults (`control_allocator/module.yaml`, 1.15): full thrust of a rotor in N, and its torque per thrust in m.
const DEFAULT_CT: f32 = 6.5;
const DEFAULT_KM: f32 = 0.05;

/// The keys of a rotor that a spec keeps.
const KEPT: [&str; 8] = ["PX", "PY", "PZ", "AX", "AY", "AZ", "CT", "KM"];

/// The vehicle of some parameters.
pub fn vehicle(source: &Source, parameters: &Parameters, found: &mut Vec<Diagnostic>) -> Outcome {
    let reader = Reader { parameters };
    if let Some(kind) = parameters.get("CA_AIRFRAME").filter(|kind| kind.value != 0.0) {
        let known = AIRFRAMES.iter().find(|(value, _)| *value == kind.value).map(|(_, what)| what.to_string());
        let named = || script::other_aircraft(&source.text).map(|(_, name)| format!("of the kind `{name}`"));
        let what = known.or_else(named).unwrap_or("no multirotor".into());
        let error = Diagnostic::error(UNSUPPORTED, kind.span, format!("this airframe is {what}"));
        return Err(Box::new(
            error.here("`CA_AIRFRAME` of a multirotor is 0").help("name the parameters of a multirotor"),
        ));
    }
    // Scripts of planes leave the airframe to the defaults of planes, which they run.
    if let Some((span, name)) = script::other_aircraft(&source.text) {
        let error = Diagnostic::error(UNSUPPORTED, span, format!("this airframe is of the kind `{name}`"));
        return Err(Box::new(error.here("no multirotor").help("name the airframe of a multirotor")));
    }
    reader.every_value_is_known()?;
    let count = reader.count(source)?;
    let mut rotors = (0..count).map(|i| reader.rotor(i)).collect::<Result<Vec<_>, _>>()?;
    reader.warn(&rotors, found);
    reader.drop_defaults(&mut rotors, found);
    for i in (0..count).filter(|i| rotors[*i].thrust.is_none()) {
        let others = rotors.iter().any(|rotor| rotor.thrust.is_some());
        if let Some(span) = reader.any(i).filter(|_| others) {
            let message = format!("motor {} has no `CA_ROTOR{i}_CT`, although others have one", i + 1);
            found.push(
                Diagnostic::warning(UNSUPPORTED, span, message)
                    .here("its thrust becomes `?`")
                    .help("write it in the spec"),
            );
        }
    }
    let figures = figures::read(parameters);
    reader.warn_of_thrust_from_hover(&rotors, &figures, found);
    let text = draft(source, rotors, &figures).text();
    let kept = |name: &str| {
        let key = name.strip_prefix("CA_ROTOR").and_then(|rest| rest.split_once('_'));
        let is_rotor =
            |(index, key): (&str, &str)| index.parse::<usize>().is_ok_and(|index| index < count) && KEPT.contains(&key);
        let is_figure = figures.used.contains(&name);
        matches!(name, "CA_ROTOR_COUNT" | "CA_AIRFRAME") || is_figure || key.is_some_and(is_rotor)
    };
    Ok((text, parameters.names().filter(|name| !kept(name)).map(String::from).collect()))
}

/// Whether places seem to be proportions: every coordinate is 0, 1 or -1, or every motor is 1 m from the centre.
fn are_shares(rotors: &[Px4Rotor]) -> bool {
    let is_unit = |rotor: &Px4Rotor| (rotor.place[0].hypot(rotor.place[1]) - 1.0).abs() < 2e-3;
    rotors.iter().all(|rotor| rotor.place.iter().all(|x| matches!(x.abs(), 0.0 | 1.0))) || rotors.iter().all(is_unit)
}

/// The error for a file in which no parameter places a rotor; `None` if it has no parameter either and is not a script.
pub fn without_geometry(source: &Source, first: Option<Span>) -> Option<Diagnostic> {
    let error = |span: Span, message: &str| Diagnostic::error(UNSUPPORTED, span, message);
    Some(match (script::reason(source), first) {
        (Some(Reason::Other(span, name)), _) => error(span, &format!("this airframe is of the kind `{name}`"))
            .here("no multirotor")
            .help("name the airframe of a multirotor"),
        (Some(Reason::OldNames(span)), _) => error(span, "names of parameters that PX4 has no more")
            .here("now `CA_ROTOR0_PX` and so on")
            .help("name the airframe of version 1.14 or later"),
        (Some(Reason::Mixer(span)), _) => error(span, "this airframe names a mixer, which another file defines")
            .here("of PX4 before version 1.14")
            .help("name the airframe of a later version, which has `CA_ROTOR0_PX`"),
        (Some(Reason::Runs(span, name)), _) => {
            error(span, &format!("no parameter of the script places a rotor, but it runs `{name}`"))
                .here("may have the places")
                .help(format!("name `{name}`; or put its lines in the place of this one"))
        }
        (Some(Reason::Defaults(span)), None) => error(span, "no parameter of the script places a rotor")
            .here("the defaults have no places of rotors")
            .help("name an airframe that sets `CA_ROTOR0_PX`"),
        (_, Some(first)) => error(first, "no parameter of the file places a rotor")
            .here("`CA_ROTOR0_PX` (PX4) or `FRAME_CLASS` (ArduPilot) is missing")
            .help("name a file that has it; a script may leave it to another that it runs"),
        (None, None) => return None,
    })
}

struct Reader<'p, 's> {
    parameters: &'p Parameters<'s>,
}

/// A rotor in PX4's frame.
struct Px4Rotor {
    place: [f32; 3],
    thrust: Option<f32>,
    torque: f32,
    has_torque: bool,
    /// The torque is PX4's default, as that of all others.
    is_unmeasured: bool,
    may_reverse: bool,
}

impl Reader<'_, '_> {
    fn value(&self, rotor: usize, key: &str) -> Option<(f32, Span)> {
        self.parameters.get(&format!("CA_ROTOR{rotor}_{key}")).map(|p| (p.value as f32, p.span))
    }

    /// A place of some parameter of a rotor.
    fn any(&self, rotor: usize) -> Option<Span> {
        KEPT.iter().find_map(|key| self.value(rotor, key)).map(|(_, span)| span)
    }

    fn count(&self, source: &Source) -> Result<usize, Box<Diagnostic>> {
        let Some(given) = self.parameters.get("CA_ROTOR_COUNT").filter(|count| count.value != 0.0) else {
            let placed = (0..*ROTORS.end()).take_while(|i| self.any(*i).is_some()).count();
            let first = self.any(0).or(self.parameters.first());
            let help = match placed {
                0 => "name a file that sets it; a script may leave it to another that it runs".to_string(),
                n => format!("add it: the file places {n} motors"),
            };
            let without = (placed == 0).then(|| without_geometry(source, first)).flatten();
            let error = without.unwrap_or_else(|| {
                let error = Diagnostic::error(UNSUPPORTED, first.unwrap_or(at(0..0)), "`CA_ROTOR_COUNT` is missing");
                error.here("PX4 has no rotors without it").help(help)
            });
            return Err(Box::new(error));
        };
        let count = given.value as usize;
        if given.value.fract() != 0.0 || !ROTORS.contains(&count) || given.value < 0.0 {
            let message = format!("a spec has 4 to 32 rotors, and the file {}", number(given.value));
            let error = Diagnostic::error(UNSUPPORTED, given.span, message).here("the number of rotors");
            return Err(Box::new(error.help("name the parameters of a multirotor with at least 4 rotors")));
        }
        Ok(count)
    }

    /// A script may work out values itself, and not only those that no spec keeps.
    fn every_value_is_known(&self) -> Result<(), Box<Diagnostic>> {
        let Some((name, span)) = self.parameters.worked_out("CA_") else { return Ok(()) };
        let error = Diagnostic::error(SYNTAX, span, format!("the script works out the value of `{name}` when it runs"));
        Err(Box::new(error.here("no number").help("write the number, or name parameters that a ground station saved")))
    }

    fn warn(&self, rotors: &[Px4Rotor], found: &mut Vec<Diagnostic>) {
        if let Some(first) = self.any(0).or(self.parameters.first()).filter(|_| are_shares(rotors)) {
            let message = "the places of the motors seem to be proportions and not metres";
            let warning = Diagnostic::warning(ASSUMED, first, message)
                .here("they are 0 or 1 along each axis, or 1 from the centre");
            found.push(warning.help("PX4 needs proportions only: measure the arms, and write them in the spec"));
        }
        let of_rotors = self.parameters.repeated().filter(|(name, ..)| name.starts_with("CA_"));
        found.extend(of_rotors.map(|(name, first, last)| set_twice(name, first, last)));
        self.warn_of_rotors_unlike_the_others(rotors, found);
        let is_placed = |i: &usize| ["PX", "PY"].iter().any(|key| self.value(*i, key).is_some());
        let span = self.parameters.get("CA_ROTOR_COUNT").map(|count| count.span);
        for (i, span) in (0..rotors.len()).filter(|i| !is_placed(i)).filter_map(|i| Some((i, span?))) {
            let message = format!("the file gives no place of motor {}: PX4 takes the centre", i + 1);
            let warning = Diagnostic::warning(ASSUMED, span, message).here(format!("{} motors", rotors.len()));
            found.push(
                warning.help(format!("set `CA_ROTOR{i}_PX` and `CA_ROTOR{i}_PY`, or correct the number of motors")),
            );
        }
    }

    /// A saved file has every parameter of every rotor, and motors with another torque than PX4's default were
    /// measured.
    fn warn_of_rotors_unlike_the_others(&self, rotors: &[Px4Rotor], found: &mut Vec<Diagnostic>) {
        let mut warn = |span: Span, message: String, here: &str, help: String| {
            found.push(Diagnostic::warning(ASSUMED, span, message).here(here).help(help));
        };
        let is_measured = rotors.iter().any(|rotor| rotor.has_torque && rotor.torque.abs() != DEFAULT_KM);
        for (i, rotor) in rotors.iter().enumerate() {
            let Some(span) = self.any(i) else { continue };
            let missing = |key: &str| self.value(i, key).is_none();
            if let Some(key) = ["PX", "PY"].iter().find(|key| self.parameters.is_saved() && missing(key)) {
                let message = format!("motor {} has no `CA_ROTOR{i}_{key}`: PX4 takes 0 m", i + 1);
                warn(span, message, "has other parameters", "save the file again, or add the line".into());
            }
            if !rotor.has_torque && (is_measured || self.parameters.is_saved()) {
                let message = format!("motor {} has no `CA_ROTOR{i}_KM`: PX4 takes {DEFAULT_KM} m", i + 1);
                warn(span, message, "has other parameters", "write its torque per thrust in the spec".into());
            }
        }
        for i in rotors.len()..*ROTORS.end() {
            let elsewhere = ["PX", "PY"].iter().filter_map(|key| self.value(i, key)).find(|(x, _)| *x != 0.0);
            if let Some((_, span)) = elsewhere {
                let message = format!("the file places motor {}, but `CA_ROTOR_COUNT` is {}", i + 1, rotors.len());
                warn(
                    span,
                    message,
                    "left out",
                    "correct the number of motors, or remove the parameters of this one".into(),
                );
                return;
            }
        }
    }

    /// Thrusts and torques that are PX4's defaults at every motor are nobody's measurements: of the torques only the
    /// signs say something.
    fn drop_defaults(&self, rotors: &mut [Px4Rotor], found: &mut Vec<Diagnostic>) {
        let mut warn = |key: &str, default: f32, unit: &str, field: &str| {
            let span = (0..rotors.len()).find_map(|i| self.value(i, key)).map(|(_, span)| span);
            let message = format!("`{key}` of every motor is PX4's default, {default} {unit}, which nobody measured");
            let Some(span) = span else { return };
            let warning = Diagnostic::warning(ASSUMED, span, message).here(format!("`{field}` becomes `?`"));
            found.push(warning.help("measure it on a thrust stand, or take it from the data of motor and propeller"));
        };
        let is_default = rotors.iter().all(|rotor| rotor.thrust == Some(DEFAULT_CT));
        let has_default_torque = rotors.iter().all(|rotor| rotor.torque.abs() == DEFAULT_KM);
        if is_default {
            warn("CT", DEFAULT_CT, "N", "max_thrust");
        }
        if has_default_torque {
            warn("KM", DEFAULT_KM, "m", "torque_per_thrust");
        }
        for rotor in rotors {
            rotor.thrust = rotor.thrust.filter(|_| !is_default);
            rotor.is_unmeasured = has_default_torque;
        }
    }

    fn warn_of_thrust_from_hover(&self, rotors: &[Px4Rotor], figures: &Figures, found: &mut Vec<Diagnostic>) {
        if figures.thrust.is_some() {
            return;
        }
        let Some(hover) = self.parameters.get("MPC_THR_HOVER").filter(|_| figures.hover.is_some()) else { return };
        if rotors.iter().any(|rotor| rotor.thrust.is_none()) {
            let message = "full thrust is computed from the mass and the thrust with which the vehicle hovers";
            let warning = Diagnostic::warning(ASSUMED, hover.span, message).here("the share of full thrust in hover");
            let help = "PX4 takes thrust to follow the command by `THR_MDL_FAC`: measure full thrust if you can";
            found.push(warning.help(help));
        }
    }

    fn rotor(&self, i: usize) -> Result<Px4Rotor, Box<Diagnostic>> {
        let or = |key: &str, default: f32| self.value(i, key).map_or(default, |(value, _)| value);
        let axis = [or("AX", 0.0), or("AY", 0.0), or("AZ", -1.0)];
        if axis[0] != 0.0 || axis[1] != 0.0 || axis[2] >= 0.0 {
            let span =
                ["AX", "AY", "AZ"].iter().find_map(|key| self.value(i, key).filter(|(v, _)| *v != 0.0 || *key == "AZ"));
            let span = span.map_or(at(0..0), |(_, span)| span);
            let error = Diagnostic::error(UNSUPPORTED, span, format!("the axis of motor {} is not upright", i + 1));
            let here = format!("its axis is ({}, {}, {}) forward, right, down", axis[0], axis[1], axis[2]);
            return Err(Box::new(error.here(here).help("a spec has rotors with parallel, upright axes only")));
        }
        if let Some((tilt, span)) = self.value(i, "TILT").filter(|(tilt, _)| *tilt != 0.0) {
            let error = Diagnostic::error(UNSUPPORTED, span, format!("motor {} tilts by servo {tilt}", i + 1));
            return Err(Box::new(error.here("a tilting rotor").help("a spec has rotors with fixed axes only")));
        }
        let reverse = self.parameters.get("CA_R_REV").map_or(0, |bits| bits.value as u32);
        Ok(Px4Rotor {
            place: [or("PX", 0.0), or("PY", 0.0), or("PZ", 0.0)],
            thrust: self.value(i, "CT").map(|(value, _)| value).filter(|thrust| *thrust > 0.0),
            torque: or("KM", DEFAULT_KM),
            has_torque: self.value(i, "KM").is_some(),
            is_unmeasured: false,
            may_reverse: i < 32 && reverse & (1 << i) != 0,
        })
    }
}

fn draft(source: &Source, rotors: Vec<Px4Rotor>, known: &Figures) -> Draft {
    let same = |of: fn(&Px4Rotor) -> Option<f32>| {
        let first = of(&rotors[0]);
        rotors.iter().all(|rotor| of(rotor) == first).then_some(first)
    };
    let thrust = same(|rotor| rotor.thrust);
    let torque = same(|rotor| Some(rotor.torque.abs()));
    let is_unmeasured = rotors[0].is_unmeasured;
    let ratio = |torque: f32| match torque == 0.0 || is_unmeasured {
        true => Figure::Unknown,
        false => Figure::single(torque.abs(), "m"),
    };
    let newtons = |thrust: Option<f32>| thrust.map_or(Figure::Unknown, |thrust| Figure::single(thrust, "N"));
    let mut shared = Vec::new();
    let (mass, binding) = known.mass();
    match (thrust, known.hover.filter(|_| known.thrust.is_none())) {
        (Some(None), None) if known.thrust.is_some() => {
            let figure = known.thrust.map_or(Figure::Unknown, |thrust| Figure::single(thrust as f32, "N"));
            shared.push(Field::new("max_thrust", figure).remark("SIH_T_MAX"));
        }
        (Some(None), Some(share)) => {
            let (figure, remark) = full_thrust_from_hover(rotors.len(), share, "MPC_THR_HOVER");
            shared.push(Field::new("max_thrust", figure).remark(remark));
        }
        (Some(thrust), _) => shared.push(Field::new("max_thrust", newtons(thrust)).remark("CT")),
        (None, _) => {}
    }
    if let Some(torque) = torque {
        let is_default = rotors.iter().any(|rotor| !rotor.has_torque);
        let remark = match (is_unmeasured, is_default) {
            (true, _) => "KM is PX4's default",
            (false, true) => "KM; where the file gives none, PX4's default, which nobody measured",
            _ => "KM",
        };
        let (figure, remark) = match known.ratio.filter(|_| is_unmeasured) {
            Some(ratio) => (Figure::single(ratio as f32, "m"), "SIH_Q_MAX/SIH_T_MAX"),
            None => (ratio(torque.unwrap_or(0.0)), remark),
        };
        shared.push(Field::new("torque_per_thrust", figure).remark(remark));
    }
    shared.push(Field::new("max_speed", Figure::Unknown).remark("at full thrust"));
    let rotor = |(i, rotor): (usize, &Px4Rotor)| {
        let [x, y, z] = rotor.place;
        let mut own = Vec::new();
        if thrust.is_none() {
            own.push(("max_thrust", newtons(rotor.thrust)));
        }
        let mut remark = None;
        if torque.is_none() {
            own.push(("torque_per_thrust", ratio(rotor.torque)));
            remark = (!rotor.has_torque).then(|| "torque_per_thrust is PX4's default, which nobody measured".into());
        }
        if rotor.may_reverse {
            own.push(("min_thrust", Figure::Unknown));
        }
        Rotor {
            place: format!("[{}, {}, {}] m", tidy(x), tidy(-y), tidy(-z)),
            spin: match rotor.torque {
                torque if torque > 0.0 => Figure::Known("P".into()),
                torque if torque < 0.0 => Figure::Known("N".into()),
                _ => Figure::Unknown,
            },
            motor: i + 1,
            own,
            remark,
        }
    };
    let placed = rotors.iter().enumerate().map(rotor).collect();
    Draft {
        name: name_from_file(&source.name),
        from: vec![
            "From parameters of PX4. Figures that they do not give are `?`.".into(),
            "x forward, y left, z up from the centre of gravity; motors as PX4 numbers them, from 1.".into(),
        ],
        title: script::title(&source.text),
        lets: binding.into_iter().collect(),
        fields: vec![mass, known.inertia()],
        estimates: Vec::new(),
        shared,
        rotors: placed,
        battery: known.battery.clone(),
    }
}

/// Without the sign of a zero.
fn tidy(value: f32) -> f32 {
    if value == 0.0 { 0.0 } else { value }
}
