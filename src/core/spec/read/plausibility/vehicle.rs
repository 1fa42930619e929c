//! Whether the numbers of a vehicle fit together: thrust and weight, inertia and size, propellers and torque.

use std::f64::consts::PI;

use super::{Usual, short, warning};
use crate::diagnostic::Diagnostic;
use crate::model::{Rotor, Vehicle};
use crate::read::context::Context;
use crate::source::Span;

/// Full thrust over weight: below the range little is left to climb and steer; racing quadcopters reach 15.
const THRUST_TO_WEIGHT: Usual = Usual::new(1.2, 20.0);
/// Moment of inertia about an axis over m R^2, with R the distance of the outermost rotor.
const INERTIA: Usual = Usual::new(0.02, 2.0);
/// Distance of the outermost rotor over the diameter of the largest propeller.
const ARM: Usual = Usual::new(0.3, 10.0);
/// Torque per thrust over the propeller's diameter.
const TORQUE: Usual = Usual::new(0.01, 0.3);
/// Torque per thrust in m, where the diameter cannot be estimated: for propellers from 15 mm to 4 m.
const TORQUE_ALONE: Usual = Usual::new(0.001, 0.3);
/// Diameter of a propeller over the one that thrust and speed suggest: the thrust coefficients of real propellers, from
/// 0.03 to 0.25, give 0.8 to 1.35.
const PROPELLER: Usual = Usual::new(0.6, 1.7);
/// Rotors nearer than this to each other are at one place, m.
const SAME_PLACE: f64 = 1e-3;
/// Speed of a propeller's tips, m/s: the upper end is close to the speed of sound.
const TIP_SPEED: Usual = Usual::new(30.0, 300.0);
/// Time constant with which a rotor's speed follows, s.
const TIME_CONSTANT: Usual = Usual::new(0.001, 1.0);
/// Rate at which the drag balances the drag torque of rotors that carry the weight and all turn in one direction,
/// rad/s. Measured values give 31 rad/s for a quadcopter of 0.5 kg (Mueller and D'Andrea, ICRA 2014).
const FULL_SPIN: Usual = Usual::new(3.0, 2000.0);

/// Static thrust coefficient C_T = T/(rho n^2 D^4) used to estimate diameters. The estimate depends on its fourth root:
/// half or twice the coefficient changes the diameter by 19 %.
const THRUST_COEFFICIENT: f64 = 0.1;
/// Density of air at sea level, kg/m^3.
const AIR_DENSITY: f64 = 1.225;

/// Where a vehicle's numbers are written.
pub(in crate::spec::read) struct VehicleSpans {
    pub mass: Span,
    pub inertia: Span,
    pub yaw_drag: Span,
    pub propeller_radius: Option<Span>,
    /// One for each rotor, in the same order.
    pub rotors: Vec<RotorSpans>,
}

/// Where a rotor's numbers are written.
#[derive(Clone, Copy)]
pub(in crate::spec::read) struct RotorSpans {
    /// The arm of a ring, or the rotor's position.
    pub place: Span,
    pub thrust: Span,
    pub torque: Span,
    pub min_speed: Span,
    pub max_speed: Span,
    pub time_constant: Span,
}

impl Rotor {
    /// Diameter of a propeller with the usual thrust coefficient that gives this thrust at this speed, m.
    fn diameter(&self) -> f64 {
        let revolutions = 2.0 * PI;
        (self.thrust_coefficient * revolutions * revolutions / (THRUST_COEFFICIENT * AIR_DENSITY)).powf(0.25)
    }

    /// Speed of its tips at full speed, from the estimated diameter, m/s.
    fn tip_speed(&self) -> f64 {
        0.5 * self.max_speed * self.diameter()
    }
}

/// Warns of numbers that do not fit together; each check warns at most once, for the first rotor concerned.
pub(in crate::spec::read) fn check(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    thrust_to_weight(cx, vehicle, written);
    inertia(cx, vehicle, written);
    let odd_tips = tip_speed(cx, vehicle, written);
    // With an implausible tip speed the estimated diameter is meaningless.
    if !odd_tips {
        arm(cx, vehicle, written);
        propeller(cx, vehicle, written);
    }
    coincident(cx, vehicle, written);
    torque_ratio(cx, vehicle, written);
    time_constant(cx, vehicle, written);
    yaw_drag(cx, vehicle, written);
}

fn yaw_drag(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let Some(drag) = vehicle.yaw_drag else { return };
    let ratios = vehicle.rotors.iter().map(|rotor| rotor.drag_coefficient / rotor.thrust_coefficient);
    let torque = ratios.fold(0.0, f64::max) * vehicle.mass * cx.gravity;
    let spin = drag.spin(torque);
    if FULL_SPIN.has(spin) {
        return;
    }
    let found = format!(
        "vehicle `{}` would turn at {} rad/s if all rotors that carry it turned in one direction",
        vehicle.name,
        short(spin)
    );
    let message = FULL_SPIN.outside(found, "rad/s");
    let slip = match spin > FULL_SPIN.high {
        true => "look for an exponent that is too small, and for `mN` in place of `N`",
        false => "look for an exponent that is too large or lost",
    };
    let warning = warning("mavc::sense::yaw_drag", written.yaw_drag, message, slip);
    cx.report(warning.here(format!("balances {} N*m at that rate", short(torque))));
}

fn thrust_to_weight(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let thrust: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let weight = vehicle.mass * cx.gravity;
    let ratio = thrust / weight;
    // A vehicle that cannot lift itself is an error and is reported elsewhere.
    if THRUST_TO_WEIGHT.has(ratio) || ratio <= 1.0 {
        return;
    }
    let found = format!("the rotors of vehicle `{}` lift {} times its weight", vehicle.name, short(ratio));
    let message = THRUST_TO_WEIGHT.outside(found, "times");
    let slip = match ratio > THRUST_TO_WEIGHT.high {
        true => {
            "look for `g` in place of `kg` in the mass, for `N` in place of `gf` and for a thrust coefficient without \
             its e-6"
        }
        false => "check mass and thrust: little thrust is left to climb and steer",
    };
    let at = written.rotors[0].thrust;
    let here = format!("{} kg weigh {} N", short(vehicle.mass), short(weight));
    let warning = warning("mavc::sense::thrust_to_weight", written.mass, message, slip).here(here);
    let rotors = vehicle.rotors.len();
    cx.report(warning.also(at, format!("{rotors} rotors give {} N at full speed", short(thrust))));
}

/// The distance of the outermost rotor from the centre of gravity, m, and its index.
fn outermost(vehicle: &Vehicle) -> (f64, usize) {
    let distances = vehicle.rotors.iter().map(|rotor| rotor.position.iter().map(|p| p * p).sum::<f64>().sqrt());
    distances.enumerate().fold((0.0, 0), |far, (k, distance)| if distance > far.0 { (distance, k) } else { far })
}

fn inertia(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let (reach, rotor) = outermost(vehicle);
    let unit = vehicle.mass * reach * reach;
    let ratio = |axis: usize| vehicle.inertia[axis] / unit;
    let Some(axis) = (0..3).find(|&axis| !INERTIA.has(ratio(axis))) else { return };
    let name = ["x", "y", "z"][axis];
    let found = format!("the inertia of vehicle `{}` about {name} is {} m R^2", vehicle.name, short(ratio(axis)));
    let message = INERTIA.outside(found, "m R^2");
    let slip = match ratio(axis) > INERTIA.high {
        true => "look for `g` in place of `kg` in the mass, and check inertia and arm with their units",
        false => "look for a wrong prefix in the inertia (`g*m^2`, `kg*cm^2`), and check mass and arm with their units",
    };
    let (low, high) = (INERTIA.low * unit, INERTIA.high * unit);
    let usual = Usual::new(low, high).text("kg*m^2");
    let here = format!("{} kg*m^2; {usual} is usual", short(vehicle.inertia[axis]));
    let warning = warning("mavc::sense::inertia", written.inertia, message, slip).here(here);
    let warning = warning.also(written.mass, format!("m is {} kg", short(vehicle.mass)));
    let farthest = format!("R is {} m, the distance of the outermost rotor", short(reach));
    cx.report(warning.also(written.rotors[rotor].place, farthest));
}

/// Warns of propeller tips that are too slow or too fast; whether there are some.
fn tip_speed(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) -> bool {
    let Some(k) = vehicle.rotors.iter().position(|rotor| !TIP_SPEED.has(rotor.tip_speed())) else { return false };
    let rotor = &vehicle.rotors[k];
    let found =
        format!("the propeller tips of vehicle `{}` move at about {} m/s", vehicle.name, short(rotor.tip_speed()));
    let message = TIP_SPEED.outside(found, "m/s");
    let slip = match rotor.tip_speed() > TIP_SPEED.high {
        true => "look for `rad/s` in place of `rpm`, for `N` in place of `gf` and for a coefficient without its e-6",
        false => "look for `rpm` in place of `rad/s`, for `gf` in place of `N` and for an exponent too large",
    };
    let at = written.rotors[k];
    let here = format!("full speed is {} rad/s", short(rotor.max_speed));
    let diameter = format!(
        "{} N at that speed suggest a propeller of about {} m",
        short(rotor.max_thrust()),
        short(rotor.diameter())
    );
    cx.report(warning("mavc::sense::tip_speed", at.max_speed, message, slip).here(here).also(at.thrust, diameter));
    true
}

fn arm(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let (reach, k) = outermost(vehicle);
    let diameter = vehicle.rotors.iter().map(Rotor::diameter).fold(0.0, f64::max);
    let ratio = reach / diameter;
    if ARM.has(ratio) {
        return;
    }
    let found = format!(
        "the rotors of vehicle `{}` are {} propeller diameters from its centre of gravity",
        vehicle.name,
        short(ratio)
    );
    let message = ARM.outside(found, "diameters");
    let at = written.rotors[k];
    let warning =
        warning("mavc::sense::arm", at.place, message, "look for `m` in place of `cm` or `mm`, or the other way round");
    let warning = warning.here(format!("{} m to the outermost rotor", short(reach)));
    cx.report(warning.also(at.thrust, estimate(diameter)));
}

fn propeller(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let (Some(radius), Some(span)) = (vehicle.propeller_radius, written.propeller_radius) else { return };
    let (k, largest) = vehicle
        .rotors
        .iter()
        .map(Rotor::diameter)
        .enumerate()
        .fold((0, 0.0), |most, (k, diameter)| if diameter > most.1 { (k, diameter) } else { most });
    let ratio = 2.0 * radius / largest;
    if PROPELLER.has(ratio) {
        return;
    }
    let found = format!(
        "the propellers of vehicle `{}` have {} times the diameter that their thrust and speed suggest",
        vehicle.name,
        short(ratio)
    );
    let message = PROPELLER.outside(found, "times");
    let slip = match ratio > PROPELLER.high {
        true => "look for a diameter in place of the radius, which is half of it",
        false => "look for a radius that is halved once more, and check its unit",
    };
    let warning = warning("mavc::sense::propeller", span, message, slip);
    let warning = warning.here(format!("a diameter of {} m", short(2.0 * radius)));
    cx.report(warning.also(written.rotors[k].thrust, estimate(largest)));
}

/// Warns of rotors at one place if others are alone: on a coaxial vehicle each has another above or below it.
fn coincident(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let apart = |a: &Rotor, b: &Rotor| {
        a.position.iter().zip(b.position).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt() >= SAME_PLACE
    };
    let rotors = &vehicle.rotors;
    let twin = |k: usize| (0..rotors.len()).find(|other| *other != k && !apart(&rotors[k], &rotors[*other]));
    let twins: Vec<Option<usize>> = (0..rotors.len()).map(twin).collect();
    let Some((second, first)) = twins.iter().enumerate().find_map(|(k, twin)| twin.filter(|t| *t < k).map(|t| (k, t)))
    else {
        return;
    };
    let Some(alone) = twins.iter().position(Option::is_none) else { return };
    let message = format!("rotors {} and {} of vehicle `{}` are at one place", first + 1, second + 1, vehicle.name);
    let slip = format!("correct one of them; coaxial rotors are pairs throughout, but rotor {} is alone", alone + 1);
    let warning = warning("mavc::sense::coincident", written.rotors[second].place, message, &slip);
    cx.report(warning.here("the same place").also(written.rotors[first].place, format!("rotor {}", first + 1)));
}

fn torque_ratio(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let odd = vehicle.rotors.iter().enumerate().find_map(|(k, rotor)| odd_torque(rotor).map(|odd| (k, odd)));
    let Some((k, Odd { usual, diameter })) = odd else { return };
    let rotor = &vehicle.rotors[k];
    let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
    let found =
        format!("the rotors of vehicle `{}` have a drag torque of {} m times their thrust", vehicle.name, short(ratio));
    let message = usual.outside(found, "m");
    let slip = match ratio > usual.high {
        true => "look for `m` in place of `mm` or `cm`, and for a drag coefficient without its e-7",
        false => "look for `mm` in place of `cm`, and for an exponent of the drag coefficient that is too small",
    };
    let at = written.rotors[k];
    let torque = ratio * rotor.max_thrust();
    let warning = warning("mavc::sense::torque_ratio", at.torque, message, slip);
    let warning = warning.here(format!("{} N*m at full speed", short(torque)));
    let of_thrust = format!("{} N at full speed", short(rotor.max_thrust()));
    cx.report(warning.also(at.thrust, diameter.map_or(of_thrust.clone(), |d| format!("{of_thrust}: {}", estimate(d)))));
}

/// A rotor whose torque per thrust is outside the usual range.
struct Odd {
    /// The usual range for this rotor, m.
    usual: Usual,
    /// The propeller's diameter, m, where it can be estimated.
    diameter: Option<f64>,
}

fn odd_torque(rotor: &Rotor) -> Option<Odd> {
    let diameter = Some(rotor.diameter()).filter(|_| TIP_SPEED.has(rotor.tip_speed()));
    let usual = diameter.map_or(TORQUE_ALONE, |d| Usual::new(TORQUE.low * d, TORQUE.high * d));
    (!usual.has(rotor.drag_coefficient / rotor.thrust_coefficient)).then_some(Odd { usual, diameter })
}

fn estimate(diameter: f64) -> String {
    format!("thrust and speed suggest a propeller of about {} m", short(diameter))
}

fn time_constant(cx: &mut Context, vehicle: &Vehicle, written: &VehicleSpans) {
    let lags = vehicle.rotors.iter().map(|rotor| rotor.time_constant);
    let odd = lags.enumerate().find_map(|(k, lag)| lag.filter(|lag| !TIME_CONSTANT.has(*lag)).map(|lag| (k, lag)));
    let Some((k, lag)) = odd else { return };
    let found = format!("the rotors of vehicle `{}` have a time constant of {} ms", vehicle.name, short(1e3 * lag));
    let message = Usual::new(1e3 * TIME_CONSTANT.low, 1e3 * TIME_CONSTANT.high).outside(found, "ms");
    let warning: Diagnostic = warning(
        "mavc::sense::time_constant",
        written.rotors[k].time_constant,
        message,
        "look for `s` in place of `ms`, or `us`",
    );
    cx.report(warning.here(format!("{} s", short(lag))));
}
