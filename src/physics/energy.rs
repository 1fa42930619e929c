//! Electrical power and energy of a motion (`docs/method/battery.md`).
//!
//! A rotor at the speed w takes the mechanical power d w^3, its drag torque times its speed. The share of the
//! electrical power that becomes mechanical is taken as constant; the power that was measured in hover gives it.

use crate::actuation::Wrench;
use crate::admissible::allocation::Allocator;
use crate::model::{Battery, Environment, Model, Vehicle};
use crate::motion::checks::{Peak, peak};
use crate::motion::{NodeState, Trajectory};

/// Error of an energy, as a share of the energy in hover over the same time, at which the quadrature ends.
const ACCURACY: f64 = 1e-7;

/// Bisections of an interval between nodes after which its estimate stands.
const MOST_BISECTIONS: u32 = 12;

/// The power that a vehicle takes for a wrench.
#[derive(Debug, Clone)]
pub struct Power {
    /// At the largest mass of the spec's interval.
    vehicle: Vehicle,
    /// The middle of the possible winds.
    environment: Environment,
    allocator: Allocator,
    /// Electrical over mechanical power.
    factor: f64,
}

/// The energy that a motion takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Consumption {
    /// J
    pub energy: f64,
    /// Estimated error of the quadrature, J.
    pub error: f64,
    /// The largest power, W.
    pub most: Peak,
}

impl Consumption {
    /// The share of the battery's charge that is left; negative if the motion takes more than the battery holds.
    pub fn left(&self, battery: &Battery) -> f64 {
        1.0 - self.energy / battery.energy()
    }
}

impl Power {
    /// The power of the model's vehicle; `None` without a battery.
    pub fn of(model: &Model) -> Option<Self> {
        let battery = model.vehicle.battery.as_ref()?;
        let allocator = Allocator::new(&model.vehicle);
        // Hover power is measured in still air of the standard density. In thinner air the speeds are higher: with b
        // and d proportional to the density, d w^3 is proportional to its root's inverse.
        let thinness = model.mission.as_ref().map_or(1.0, |mission| mission.air.density_ratio);
        let here = mechanical(&model.vehicle, &allocator.speeds(&level(&model.vehicle, model.gravity)));
        let in_hover = here * thinness.sqrt();
        let mut vehicle = model.vehicle.clone();
        vehicle.mass *= vehicle.mass_spread.high;
        Some(Power { vehicle, environment: model.environment(), allocator, factor: battery.hover_power / in_hover })
    }

    /// Electrical power for a wrench (N and N m) of the healthy vehicle, W.
    pub fn for_wrench(&self, wrench: &Wrench) -> f64 {
        self.factor * mechanical(&self.vehicle, &self.allocator.speeds(wrench))
    }

    /// Electrical power at a state of a trajectory, W.
    pub fn at(&self, trajectory: &Trajectory, state: &NodeState) -> f64 {
        self.for_wrench(&trajectory.wrench(&self.vehicle, &self.environment, state))
    }

    /// The energy that a trajectory takes, by adaptive quadrature on each interval between nodes.
    pub fn along(&self, trajectory: &Trajectory) -> Consumption {
        let hover = self.for_wrench(&level(&self.vehicle, self.environment.gravity));
        let (mut energy, mut error) = (0.0, 0.0);
        for k in 0..trajectory.intervals() {
            let power = |t: f64| self.at(trajectory, &trajectory.within(k, t));
            let (part, part_error) =
                integral(&power, 0.0, trajectory.times[k + 1] - trajectory.times[k], ACCURACY * hover, MOST_BISECTIONS);
            energy += part;
            error += part_error;
        }
        Consumption { energy, error, most: peak(trajectory, |state| self.at(trajectory, state)) }
    }
}

/// The wrench of hover in still air, N and N m.
fn level(vehicle: &Vehicle, gravity: f64) -> Wrench {
    Wrench::new(vehicle.mass * gravity, 0.0, 0.0, 0.0)
}

/// Torque times speed of all rotors at these speeds (rad/s), W.
fn mechanical(vehicle: &Vehicle, speeds: &[f64]) -> f64 {
    vehicle.rotors.iter().zip(speeds).map(|(rotor, w)| rotor.drag_coefficient * w.abs().powi(3)).sum()
}

/// Nodes and weights on [0, 1] (the other half mirrors them) of the Kronrod rule with 15 points, and the weights of the
/// Gauss rule with 7, which uses every second point: Piessens et al., QUADPACK (1983), `qk15`.
const KRONROD: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55, 0.129_484_966_168_869_7),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_66),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4, 0.381_830_050_505_118_9),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.0, 0.209_482_141_084_727_82, 0.417_959_183_673_469_4),
];

/// The integral of `f` from `a` to `b` and its estimated error: the difference of the two rules. The interval is
/// bisected while the difference exceeds `rate` (the unit of `f`) times its length.
fn integral(f: &impl Fn(f64) -> f64, a: f64, b: f64, rate: f64, bisections: u32) -> (f64, f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut fine, mut coarse) = (0.0, 0.0);
    for (x, kronrod, gauss) in KRONROD {
        let value = match x == 0.0 {
            true => f(middle),
            false => f(middle - half * x) + f(middle + half * x),
        };
        fine += kronrod * value;
        coarse += gauss * value;
    }
    let error = half * (fine - coarse).abs();
    if error <= rate * (b - a) || bisections == 0 {
        return (half * fine, error);
    }
    let [left, right] = [(a, middle), (middle, b)].map(|(a, b)| integral(f, a, b, rate, bisections - 1));
    (left.0 + right.0, left.1 + right.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quadrature_is_exact_for_polynomials_and_refines_kinks() {
        // The Kronrod rule with 15 points is exact up to degree 22.
        let (value, error) = integral(&|x: f64| x.powi(13), 0.0, 2.0, 1e-9, 0);
        assert!((value - 2.0_f64.powi(14) / 14.0).abs() < 1e-11 * value, "{value}");
        assert!(error < 1e-10 * value);
        let weights: f64 = KRONROD.iter().map(|(x, w, _)| if *x == 0.0 { *w } else { 2.0 * w }).sum();
        let coarse: f64 = KRONROD.iter().map(|(x, _, w)| if *x == 0.0 { *w } else { 2.0 * w }).sum();
        assert!((weights - 2.0).abs() < 1e-15 && (coarse - 2.0).abs() < 1e-15);
        let (value, error) = integral(&|x: f64| (x - 0.3).abs(), 0.0, 1.0, 1e-9, 40);
        let exact = 0.5 * (0.3_f64.powi(2) + 0.7_f64.powi(2));
        assert!((value - exact).abs() <= error.max(1e-15), "{value} {exact} {error}");
        assert!(error <= 1e-9);
    }
}
