//! Figures of a vehicle that nobody has measured, estimated from mass, size and propeller. Every estimate is marked as
//! one, with its range.
//!
//! Sources:
//! - M. W. Mueller, R. D'Andrea, ICRA 2014, doi 10.1109/ICRA.2014.6906588: a quadcopter of 0.5 kg with its yaw drag;
//! - the AscTec Hummingbird of RotorPy (`hummingbird_params.py`);
//! - the Hummingbird and the Neo 11 of RotorS (`hummingbird.xacro`, `neo11.xacro`).
//!
//! The tests compare each rule with the figures of these vehicles. All are inside the stated ranges, except the torque
//! of RotorPy's Hummingbird.

mod label;

use crate::number::significant;
pub use label::{Battery, Estimated, Label, battery, propeller, quantity};
use std::f64::consts::TAU;

/// m/s^2, and kg/m^3 at sea level.
pub const GRAVITY: f64 = 9.81;
const AIR_DENSITY: f64 = 1.225;
/// Static thrust coefficient C_T = T/(rho n^2 D^4). APC's 10x4.7 has 0.104 to 0.127 (UIUC propeller data), the vehicles
/// of the sources have 0.067 to 0.13.
const THRUST_COEFFICIENT: f64 = 0.1;
/// Share by which a speed that follows from it may be wrong: with the square root of the coefficient.
const SPEED_RANGE: f64 = 0.25;
/// C_P/C_T of a propeller at rest, and its range: 0.42 for APC's 10x4.7 (UIUC), 0.53 for the vehicle of Mueller and
/// D'Andrea, 0.38 for the Neo 11.
const POWER_TO_THRUST: f64 = 0.45;
const POWER_RANGE: f64 = 0.2;
/// The drag of a rotor across its axis, over its thrust, times the speed of its tips over that of the air; and its
/// range. The vehicles of the sources have 0.85 to 2.3.
const SIDEWAYS: f64 = 1.55;
const SIDEWAYS_RANGE: f64 = 0.5;
/// Moments of inertia over m R^2, with R from the middle to a rotor: about x and y, and about z. The vehicles of the
/// sources have 0.21 to 0.25 and 0.38 to 0.52; the range, half to twice, is chosen by hand.
const INERTIA: [f64; 3] = [0.25, 0.25, 0.45];
/// Moment of inertia of a propeller with its motor bell, kg m^2, and the diameter that it belongs to, m (Mueller and
/// D'Andrea). Of similar propellers the mass grows with the third power of the diameter, so this with the fifth.
const PROPELLER_INERTIA: (f64, f64) = (1.5e-5, 0.2);
/// The middle of the range from half to twice a value, over it, and the half width over the middle.
const HALF_TO_TWICE: (f64, f64) = (1.25, 0.6);
/// Full thrust over weight, for which camera and cargo multirotors are built, and the range that is assumed.
const THRUST_TO_WEIGHT: f64 = 2.0;
const THRUST_RANGE: f64 = 0.2;
/// Electrical to mechanical power of motor and controller: motors reach 50 to 90 %, controllers 90 to 98 %.
const EFFICIENCY: f64 = 0.75;

/// The diameter (m) of a usual propeller that gives a thrust (N) at a speed (rad/s).
pub fn diameter(thrust: f64, speed: f64) -> f64 {
    (thrust * (TAU / speed).powi(2) / (THRUST_COEFFICIENT * AIR_DENSITY)).powf(0.25)
}

/// What is known of a vehicle, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Known {
    /// kg
    pub mass: f64,
    pub rotors: usize,
    /// Distance of the rotors from the middle, m.
    pub radius: f64,
    /// Of a propeller, m.
    pub diameter: f64,
    /// Drag over speed, if it is known, N s/m.
    pub drag: Option<f64>,
}

impl Known {
    fn hover_thrust(&self) -> f64 {
        self.mass * GRAVITY / self.rotors as f64
    }

    /// Speed of a rotor that gives a thrust (N), rad/s.
    fn speed(&self, thrust: f64) -> f64 {
        TAU * (thrust / (THRUST_COEFFICIENT * AIR_DENSITY * self.diameter.powi(4))).sqrt()
    }

    /// Drag of the vehicle divided by its speed, N s/m: that of rotors that move across their axes.
    pub fn drag(&self) -> f64 {
        let tips = 0.5 * self.diameter * self.speed(self.hover_thrust());
        self.drag.unwrap_or(SIDEWAYS * self.mass * GRAVITY / tips)
    }

    /// Yaw drag, N m s/rad: the same drag, as a turn about z moves every rotor across its axis.
    pub fn yaw_drag(&self) -> f64 {
        self.drag() * self.radius * self.radius
    }

    /// Ixx, Iyy, Izz, kg m^2.
    pub fn inertia(&self) -> [f64; 3] {
        INERTIA.map(|share| share * self.mass * self.radius * self.radius)
    }

    /// Moment of inertia of a rotor, kg m^2.
    pub fn rotor_inertia(&self) -> f64 {
        let (inertia, diameter) = PROPELLER_INERTIA;
        inertia * (self.diameter / diameter).powi(5)
    }

    /// m
    pub fn torque_per_thrust(&self) -> f64 {
        POWER_TO_THRUST * self.diameter / TAU
    }

    /// Electrical power in hover, W: torque times speed of all rotors over the efficiency of motors and controllers.
    fn hover_power(&self) -> f64 {
        self.torque_per_thrust() * self.mass * GRAVITY * self.speed(self.hover_thrust()) / EFFICIENCY
    }

    /// The lines of drag, yaw drag and rotor inertia, each a field with its value and a comment that marks it.
    pub fn lines(&self) -> [(&'static str, String, String); 3] {
        [
            (
                "drag",
                format!("{} N*s/m +- {} %", shown(self.drag()), shown(100.0 * SIDEWAYS_RANGE)),
                format!("estimate: {SIDEWAYS} m g over the speed of the tips in hover"),
            ),
            (
                "yaw_drag",
                format!("{} N*m*s/rad +- {} %", shown(self.yaw_drag()), shown(100.0 * SIDEWAYS_RANGE)),
                "estimate: that drag times the square of the arm".into(),
            ),
            (
                "rotor_inertia",
                format!(
                    "{} kg*m^2 +- {} %",
                    shown(HALF_TO_TWICE.0 * self.rotor_inertia()),
                    shown(100.0 * HALF_TO_TWICE.1)
                ),
                "estimate: half to twice 1.5e-5 kg*m^2 times (diameter/20 cm)^5".into(),
            ),
        ]
    }
}

/// How a figure that a file lacks is estimated by hand, for the comment behind its `?`; `None` for one that only the
/// user knows, such as the mass.
pub fn rule(field: &str) -> Option<String> {
    let percent = |range: f64| shown(100.0 * range);
    Some(match field {
        "inertia" => format!("estimate, half to twice: {INERTIA:?} m R^2, with the distance R of a rotor"),
        "max_thrust" => format!(
            "estimate, +- {} %: {THRUST_TO_WEIGHT} times the weight over the number of motors",
            percent(THRUST_RANGE)
        ),
        "torque_per_thrust" => format!(
            "estimate, +- {} %: {POWER_TO_THRUST} D/(2 pi), with the diameter D of a propeller",
            percent(POWER_RANGE)
        ),
        "max_speed" => {
            format!("estimate, +- {} %: 2 pi sqrt(max_thrust/({THRUST_COEFFICIENT} rho D^4))", percent(SPEED_RANGE))
        }
        _ => return None,
    })
}

fn shown(value: f64) -> String {
    significant(value, 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published vehicles: mass, rotors, radius, diameter; thrust coefficient (N s^2), torque per thrust (m), Ixx and
    /// Izz (kg m^2).
    const SOURCES: [(&str, Known, f64, f64, [f64; 2]); 3] = [
        (
            "Mueller and D'Andrea",
            Known { mass: 0.5, rotors: 4, radius: 0.17, diameter: 0.2, drag: None },
            6.41e-6,
            1.69e-2,
            [3.2e-3, 5.5e-3],
        ),
        (
            "RotorPy's Hummingbird",
            Known { mass: 0.5, rotors: 4, radius: 0.17, diameter: 0.2, drag: None },
            5.57e-6,
            1.36e-7 / 5.57e-6,
            [3.65e-3, 7.03e-3],
        ),
        (
            "RotorS's Neo 11",
            Known { mass: 3.42, rotors: 6, radius: 0.2895, diameter: 0.2794, drag: None },
            1.269e-5,
            0.016754,
            [6.0887e-2, 0.148916],
        ),
    ];

    fn within(value: f64, middle: f64, range: f64) -> bool {
        (value / middle - 1.0).abs() <= range
    }

    #[test]
    fn sideways_drag_of_published_rotors_is_in_the_range() {
        // Rotor drag over thrust, k_d/k_f, times the radius: RotorS's Hummingbird and Neo 11, RotorPy's Hummingbird.
        for (drag, thrust, radius) in
            [(8.06428e-5, 8.54858e-6, 0.1), (2.0673e-4, 1.269e-5, 0.1397), (1.19e-4, 5.57e-6, 0.1)]
        {
            assert!(within(drag / thrust * radius, SIDEWAYS, SIDEWAYS_RANGE), "{}", drag / thrust * radius);
        }
        // The measured yaw drag, from the speeds of the measured rotors.
        let (_, known, coefficient, _, _) = SOURCES[0];
        let speed = (known.hover_thrust() / coefficient).sqrt();
        let sideways = 2.75e-3 / known.radius.powi(2) * speed * 0.1 / (known.mass * GRAVITY);
        assert!(within(sideways, SIDEWAYS, SIDEWAYS_RANGE), "{sideways}");
        assert!(within(2.75e-3, known.yaw_drag(), SIDEWAYS_RANGE + SPEED_RANGE), "{}", known.yaw_drag());
    }

    #[test]
    fn other_figures_of_published_vehicles_are_in_their_ranges() {
        for (name, known, coefficient, torque, [about_x, about_z]) in SOURCES {
            let [x, _, z] = known.inertia();
            assert!((0.5..=2.0).contains(&(about_x / x)) && (0.5..=2.0).contains(&(about_z / z)), "{name}");
            // Its 24 mm are a C_P/C_T of 0.77.
            if name != "RotorPy's Hummingbird" {
                assert!(within(torque, known.torque_per_thrust(), POWER_RANGE), "{name}: {torque}");
            }
            let speed = (known.hover_thrust() / coefficient).sqrt();
            assert!(within(speed, known.speed(known.hover_thrust()), SPEED_RANGE), "{name}: {speed}");
        }
        assert!(within(SOURCES[0].1.rotor_inertia(), 1.5e-5, 1e-12));
        // 9 g of RotorS's Hummingbird as a rod of 20 cm.
        assert!((0.5..=2.0).contains(&(0.009 * 0.04 / 12.0 / SOURCES[0].1.rotor_inertia())));
    }

    #[test]
    fn the_rules_by_hand() {
        let known = Known { mass: 1.5, rotors: 6, radius: 0.275, diameter: 0.254, drag: None };
        // T = 2.4525 N of each rotor at n = sqrt(T/(0.1 rho D^4)) = 69.4 1/s.
        let turns = (2.4525_f64 / (0.1 * 1.225 * 0.254_f64.powi(4))).sqrt();
        assert!((known.speed(2.4525) - TAU * turns).abs() < 1e-9 && (turns - 69.36).abs() < 0.01, "{turns}");
        let drag = 1.55 * 1.5 * 9.81 / (std::f64::consts::PI * turns * 0.254);
        assert!((known.drag() - drag).abs() < 1e-12 && (known.yaw_drag() - drag * 0.275 * 0.275).abs() < 1e-12);
        assert!((known.torque_per_thrust() - 0.45 * 0.254 / TAU).abs() < 1e-15);
        assert!((diameter(2.4525, TAU * turns) - 0.254).abs() < 1e-12);
    }
}
