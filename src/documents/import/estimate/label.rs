//! The spec of a vehicle of which only what its parts are labelled with is known.

use super::{
    EFFICIENCY, GRAVITY, INERTIA, Known, POWER_RANGE, POWER_TO_THRUST, SIDEWAYS_RANGE, SPEED_RANGE, THRUST_COEFFICIENT,
    THRUST_RANGE, THRUST_TO_WEIGHT, shown,
};
use crate::diagnostic::Severity;
use crate::format::format;
use crate::number::significant;
use crate::source::{FileId, Source};
use crate::spec::Compiler;
use crate::unit::parse_unit;

/// Volts of a cell of lithium polymer.
const CELL: f64 = 3.7;

/// More motors are an error of the spec, which the text need not hold all of.
const MOST_MOTORS: usize = 40;

/// A battery by its label: cells in series and charge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Battery {
    pub cells: u32,
    /// A s
    pub charge: f64,
}

/// What a builder knows before the first measurement, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Label {
    /// kg
    pub mass: f64,
    /// An even number from 4 to 32.
    pub motors: usize,
    /// From motor to motor across the middle, m.
    pub diagonal: f64,
    /// Diameter of a propeller, m.
    pub propeller: f64,
    pub battery: Option<Battery>,
    /// Full thrust of a rotor, N; assumed if it is not known.
    pub thrust: Option<f64>,
}

/// A spec from a label.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimated {
    pub text: String,
    /// The spec with the middle of each interval alone, in which one estimate after another can be varied.
    pub middle: String,
    /// The estimates on which verdicts depend, as `mavc analyze --sweep` takes them, over their ranges.
    pub sweeps: Vec<String>,
}

/// A line without its ` +- 50 %`, if it has one before its comment.
fn without_interval(line: &str) -> String {
    let code = line.split("//").next().unwrap_or(line);
    format!("{}\n", code.split(" +- ").next().unwrap_or(code))
}

impl Label {
    /// The spec of the vehicle, without errors.
    ///
    /// # Errors
    /// The first message of a spec with these figures, such as a number of motors that is odd.
    pub fn spec(&self) -> Result<Estimated, String> {
        let known = Known {
            mass: self.mass,
            rotors: self.motors,
            radius: 0.5 * self.diagonal,
            diameter: self.propeller,
            drag: None,
        };
        let full = self.thrust.unwrap_or(THRUST_TO_WEIGHT * known.hover_thrust());
        let text = format(FileId(0), &Source::new("", self.text(&known, full)));
        let text = text.value.unwrap_or_default();
        let compiled = Compiler::new().text("<estimated>", text.as_bytes());
        if compiled.spec.is_none() {
            let error = compiled.diagnostics.iter().find(|d| d.severity == Severity::Error);
            return Err(error.map_or_else(String::new, |error| error.message.clone()));
        }
        let sweep = |field: &str, middle: f64, range: f64, unit: &str| {
            let [low, high] = [1.0 - range, 1.0 + range].map(|share| significant(share * middle, 3));
            format!("{field}={low}..{high}{unit}")
        };
        let mut sweeps = Vec::new();
        if self.thrust.is_none() {
            sweeps.push(sweep("rotor.max_thrust", full, THRUST_RANGE, "N"));
        }
        let torque = known.torque_per_thrust();
        sweeps.push(sweep("rotor.torque_per_thrust", 1e3 * torque, POWER_RANGE, "mm"));
        sweeps.push(sweep("yaw_drag", known.yaw_drag(), SIDEWAYS_RANGE, "N*m*s/rad"));
        let middle = text.lines().map(without_interval).collect();
        Ok(Estimated { text, middle, sweeps })
    }

    fn text(&self, known: &Known, full: f64) -> String {
        // With the nose between two rotors, as autopilots number their X frames.
        let first = if self.motors.is_multiple_of(4) { 180.0 / self.motors as f64 } else { 0.0 };
        let [x, y, z] = known.inertia().map(shown);
        let [(_, drag, of_drag), (_, yaw_drag, of_yaw_drag), (_, rotor_inertia, of_rotor_inertia)] = known.lines();
        let percent = |range: f64| shown(100.0 * range);
        let thrust = match self.thrust {
            Some(thrust) => format!("{} N  // as given", significant(thrust, 6)),
            None => format!(
                "{} N +- {} %  // estimate: {THRUST_TO_WEIGHT} times the weight, as camera and cargo multirotors have",
                shown(full),
                percent(THRUST_RANGE)
            ),
        };
        let battery = self.battery.map_or(String::new(), |battery| {
            format!(
                "battery {{\ncapacity = {} mA*h\nvoltage = {} V  // {} cells of {CELL} V\n\
                 hover_power = {} W  // estimate: torque times speed at {} % efficiency\n}}\n",
                significant(battery.charge / 3.6, 6),
                significant(f64::from(battery.cells) * CELL, 4),
                battery.cells,
                shown(known.hover_power()),
                percent(EFFICIENCY)
            )
        });
        format!(
            "// Written by `mavc new --vehicle`. Lines with `estimate` are not measured: replace them, first those\n\
             // on which an outcome depends (`mavc analyze --sweep`).\n\n\
             vehicle copter {{\n\
             layout = \"{layout}\"  // neighbours turn opposite ways\n\
             first = {first} deg\n\
             arm = {arm} m  // half of the diagonal\n\
             propeller_radius = {propeller} m  // half of the diameter\n\
             mass = {mass} kg  // as given\n\
             inertia = [{x}, {y}, {z}] kg*m^2  // estimate, half to twice: [{ix}, {iy}, {iz}] m R^2\n\
             drag = {drag}  // {of_drag}\n\
             yaw_drag = {yaw_drag}  // {of_yaw_drag}\n\
             rotor {{\n\
             max_thrust = {thrust}\n\
             torque_per_thrust = {torque} mm +- {torque_range} %  // estimate: C_P/C_T of {POWER_TO_THRUST} at rest\n\
             max_speed = {speed} rad/s +- {speed_range} %  // estimate: C_T of {THRUST_COEFFICIENT}\n\
             rotor_inertia = {rotor_inertia}  // {of_rotor_inertia}\n\
             }}\n{battery}}}\n\nfaults {{ every 1 rotor lost as M }}\n",
            layout =
                "PN".repeat(self.motors.min(MOST_MOTORS).div_ceil(2)).chars().take(self.motors).collect::<String>(),
            arm = significant(known.radius, 6),
            propeller = significant(0.5 * self.propeller, 6),
            mass = significant(self.mass, 6),
            ix = INERTIA[0],
            iy = INERTIA[1],
            iz = INERTIA[2],
            torque = shown(1e3 * known.torque_per_thrust()),
            torque_range = percent(POWER_RANGE),
            speed = shown(known.speed(full)),
            speed_range = percent(SPEED_RANGE),
        )
    }
}

/// A number with a unit of a spec, or inches as `10in`, above zero and in the SI unit `si`: `1.5kg`, `55 cm`.
///
/// # Errors
/// What is wrong, and an example.
pub fn quantity(text: &str, si: &str, example: &str) -> Result<f64, String> {
    let text = text.trim();
    let end = text.find(|c: char| c.is_alphabetic() || c == '"' || c == '%').unwrap_or(text.len());
    let (number, unit) = (text[..end].trim(), text[end..].trim());
    let unit = if matches!(unit, "in" | "\"") { "inch" } else { unit };
    let found = number.parse::<f64>().ok().zip(parse_unit(unit, GRAVITY).ok());
    let due = parse_unit(si, GRAVITY).map_err(|_| format!("`{si}` is not a unit"))?;
    match found.filter(|(_, unit)| unit.dimension == due.dimension) {
        Some((number, unit)) if number > 0.0 && number.is_finite() => Ok(number * unit.numerator / unit.denominator),
        _ => Err(format!("write a number above zero with its unit, such as {example}")),
    }
}

/// A propeller by its diameter, `10in` or `254mm`, or by its label, `10x4.5`: the diameter, m.
///
/// # Errors
/// What to write.
pub fn propeller(text: &str) -> Result<f64, String> {
    let label = text.split_once(['x', 'X']).filter(|(_, pitch)| pitch.parse::<f64>().is_ok());
    let inches = label.and_then(|(diameter, _)| diameter.parse::<f64>().ok());
    match inches {
        Some(inches) => quantity(&format!("{inches}in"), "m", "10in"),
        None => quantity(text, "m", "10in or 10x4.5"),
    }
}

/// A battery by its label: `4S5000mAh`, `6s 10Ah`.
///
/// # Errors
/// What to write.
pub fn battery(text: &str) -> Result<Battery, String> {
    let wrong = || "write cells in series and charge, such as 4S5000mAh".to_string();
    let (cells, charge) = text.split_once(['s', 'S']).ok_or_else(wrong)?;
    let cells: u32 = cells.trim().parse().ok().filter(|cells| (1..=100).contains(cells)).ok_or_else(wrong)?;
    let charge = charge.trim().replace("Ah", "A*h");
    let charge = quantity(&charge, "A*h", "5000mAh").map_err(|_| wrong())?;
    Ok(Battery { cells, charge })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_as_they_are_printed() {
        assert_eq!(quantity("1.5kg", "kg", ""), Ok(1.5));
        assert_eq!(quantity("550 mm", "m", ""), Ok(0.55));
        for text in ["10in", "10 inch", "10\"", "10x4.5", "254mm"] {
            assert!(propeller(text).is_ok_and(|diameter| (diameter - 0.254).abs() < 1e-12), "{text}");
        }
        assert_eq!(battery("4S5000mAh"), Ok(Battery { cells: 4, charge: 18000.0 }));
        assert_eq!(battery("6s 10Ah"), Ok(Battery { cells: 6, charge: 36000.0 }));
        for wrong in ["1.5", "-1 kg", "1 m", "kg", "1e999 kg", "nan kg"] {
            assert!(quantity(wrong, "kg", "1kg").is_err(), "{wrong}");
        }
        assert!(propeller("10").is_err() && battery("5000mAh").is_err() && battery("0S5Ah").is_err());
    }
}
