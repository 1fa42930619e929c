//! Whether the gains suit the controller's rate and the motors: the phase margin of every control loop.

use nalgebra::Complex;

use super::{short, warning};
use crate::model::{Rotor, Simulation, Vehicle};
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;

/// Least phase margin, rad: 15 degrees. Autopilots are tuned to 30 to 60; with less than this a vehicle oscillates for
/// long.
const LEAST_MARGIN: f64 = 15.0 * std::f64::consts::PI / 180.0;
/// A loop with a crossover, rad/s, or a ratio of gains, 1/s, below this takes longer than ten seconds to recover.
const SLOWEST: f64 = 0.1;
/// Lowest frequency at which a crossover is searched, rad/s.
const LOWEST: f64 = 1e-6;
/// How many factors of ten the search covers, and how many frequencies per factor of ten.
const DECADES: usize = 14;
const PER_DECADE: usize = 100;

/// The dynamics between a command of the controller and the torque or thrust: motors and sampling.
#[derive(Clone, Copy)]
struct Actuator {
    /// Time constant of the slowest rotor, s.
    lag: f64,
    /// Mean delay because a command is held for a period, s: half the period.
    delay: f64,
}

impl Actuator {
    fn response(self, frequency: f64) -> Complex<f64> {
        Complex::from_polar(1.0, -self.delay * frequency) / Complex::new(1.0, self.lag * frequency)
    }
}

/// One loop around a double integrator: gains on the deviation, 1/s^2, and on its rate, 1/s.
struct Loop {
    name: &'static str,
    fields: [&'static str; 2],
    gains: [f64; 2],
    /// The gains of the inner loop: position is controlled through tilt.
    inner: Option<[f64; 2]>,
}

impl Loop {
    /// The frequency response of the open loop.
    fn response(&self, actuator: Actuator, frequency: f64) -> Complex<f64> {
        let own = controller(self.gains, frequency);
        match self.inner {
            None => own * actuator.response(frequency),
            Some(inner) => {
                let open = controller(inner, frequency) * actuator.response(frequency);
                own * open / (open + 1.0)
            }
        }
    }

    /// The smallest phase margin over all crossovers, rad, and that crossover, rad/s.
    fn margin(&self, actuator: Actuator) -> Option<(f64, f64)> {
        let frequency = |k: usize| LOWEST * 10f64.powf(k as f64 / PER_DECADE as f64);
        let size = |frequency: f64| self.response(actuator, frequency).norm();
        let ends = (0..DECADES * PER_DECADE).map(|k| (frequency(k), frequency(k + 1)));
        let crossings = ends.filter(|(low, high)| (size(*low) - 1.0) * (size(*high) - 1.0) <= 0.0);
        let margins = crossings.map(|(low, high)| {
            let at = (low * high).sqrt();
            // The argument wraps at a lag of half a turn; these open loops never lead.
            let phase = self.response(actuator, at).arg();
            let phase = if phase > 0.0 { phase - 2.0 * std::f64::consts::PI } else { phase };
            (phase + std::f64::consts::PI, at)
        });
        margins.min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// (K_d s + K_p)/s^2 at s = j frequency.
fn controller([deviation, rate]: [f64; 2], frequency: f64) -> Complex<f64> {
    Complex::new(deviation, rate * frequency) / -(frequency * frequency)
}

fn loops(simulation: &Simulation) -> [Loop; 4] {
    let g = &simulation.gains;
    let attitude = [g.attitude, g.attitude_rate];
    let one = |name, fields, gains, inner| Loop { name, fields, gains, inner };
    [
        one("roll and pitch", ["attitude_gain", "attitude_rate_gain"], attitude, None),
        one("yaw", ["yaw_gain", "yaw_rate_gain"], [g.yaw, g.yaw_rate], None),
        one("height", ["altitude_gain", "climb_gain"], [g.altitude, g.climb], None),
        one("position", ["position_gain", "velocity_gain"], [g.position, g.velocity], Some(attitude)),
    ]
}

/// Warns of loops that oscillate or hardly act with these motors and this rate. `fields` are those of the `simulate`
/// block at `block`.
pub(in crate::spec::read) fn check(
    cx: &mut Context,
    simulation: &Simulation,
    vehicle: &Vehicle,
    fields: &Fields,
    block: Span,
) {
    let lag = vehicle.rotors.iter().map(Rotor::lag).fold(0.0, f64::max);
    let actuator = Actuator { lag, delay: 0.5 / simulation.control_rate };
    let mut swings = false;
    for each in loops(simulation) {
        // A vehicle that cannot hold its attitude cannot hold its position either: one warning suffices.
        if each.inner.is_some() && swings {
            continue;
        }
        let Some((margin, crossover)) = each.margin(actuator) else { continue };
        let (text, slip) = if margin < LEAST_MARGIN {
            swings = true;
            let degrees = margin.to_degrees();
            let state = if margin <= 0.0 { "is unstable" } else { "is poorly damped" };
            let text = format!("{state}: its phase margin is {} degrees, 30 to 60 are usual", short(degrees));
            (text, "check the gains, or lower them until they suit motors and rates")
        } else if let Some(rate) = [crossover, each.gains[0] / each.gains[1]].into_iter().find(|r| *r < SLOWEST) {
            // With strong damping a deviation decays at the ratio of the gains.
            let text = format!("hardly acts: it needs {} s to recover, less than 10 s is usual", short(1.0 / rate));
            (text, "check the gains, which are per unit of mass or inertia")
        } else {
            continue;
        };
        let span = each.fields.iter().find_map(|name| fields.span_of(name)).unwrap_or(block);
        let [deviation, rate] = each.gains;
        let here = format!(
            "{} {} 1/s^2 and {} {} 1/s cross over at {} rad/s",
            each.fields[0],
            short(deviation),
            each.fields[1],
            short(rate),
            short(crossover)
        );
        let message = format!("the control of {} {text}", each.name);
        let warning = warning("mavc::sense::gains", span, message, slip).here(here);
        let motors = format!("its rotors have a time constant of {} ms", short(1e3 * lag));
        let warning = warning.also(vehicle.span, motors);
        cx.report(match fields.span_of("control_rate") {
            Some(rate) => {
                warning.also(rate, format!("the controller acts every {} ms", short(1e3 / simulation.control_rate)))
            }
            None => warning,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn margin(gains: [f64; 2], lag: f64, delay: f64) -> (f64, f64) {
        let each = Loop { name: "", fields: [""; 2], gains, inner: None };
        each.margin(Actuator { lag, delay }).unwrap()
    }

    #[test]
    fn margins_are_those_of_the_closed_form() {
        // Without lag and delay |L| = 1 at w^2 = (Kd^2 + sqrt(Kd^4 + 4 Kp^2))/2, and the margin is atan(Kd w/Kp).
        let (found, at) = margin([100.0, 16.0], 0.0, 0.0);
        let crossover = ((256.0 + (256f64.powi(2) + 4e4).sqrt()) / 2.0).sqrt();
        assert!((at / crossover - 1.0).abs() < 0.03 && (found - (0.16 * crossover).atan()).abs() < 0.02);
        // Routh: s^2 (1 + tau s) + Kd s + Kp is stable just where Kd > tau Kp.
        assert!(margin([100.0, 16.0], 0.15, 0.0).0 > 0.0);
        assert!(margin([100.0, 16.0], 0.17, 0.0).0 < 0.0);
        // A delay costs w times itself.
        let (delayed, at) = margin([100.0, 16.0], 0.0, 0.01);
        assert!((found - delayed - 0.01 * at).abs() < 1e-9);
    }
}
