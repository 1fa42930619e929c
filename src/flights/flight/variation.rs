//! Vehicles whose parameters have other values of the spec's intervals than the middles, which the controller assumes.

use crate::model::{DynamicFigure, RotorSpread, Spread, Vehicle};
use rand_distr::{Distribution, StandardUniform};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;

/// Up to this many intervals every corner is taken: 32 corners.
const MOST_INTERVALS: usize = 5;
/// With more intervals, this many values of all of them are drawn in addition to the ends of each.
const DRAWN: usize = 16;
/// Seed of these draws: corners are the same for every flight of a spec.
const SEED: u64 = 1;

/// A parameter that has an interval; each takes its values independently of the others.
#[derive(Debug, Clone, Copy)]
enum Parameter {
    Mass,
    Dynamic(DynamicFigure),
    /// Of a rotor, by its index.
    Thrust(usize),
    TorquePerThrust(usize),
}

impl Parameter {
    /// Those of a vehicle that have an interval.
    fn of(vehicle: &Vehicle) -> Vec<Parameter> {
        let rotors = (0..vehicle.rotors.len()).flat_map(|k| [Parameter::Thrust(k), Parameter::TorquePerThrust(k)]);
        let dynamic = DynamicFigure::ALL.map(Parameter::Dynamic);
        let all = [Parameter::Mass].into_iter().chain(dynamic).chain(rotors);
        all.filter(|parameter| !parameter.spread(vehicle).is_none()).collect()
    }

    fn spread(self, vehicle: &Vehicle) -> Spread {
        match self {
            Parameter::Mass => vehicle.mass_spread,
            Parameter::Dynamic(figure) => figure.spread(vehicle),
            Parameter::Thrust(k) => vehicle.rotors[k].spread.full_thrust,
            Parameter::TorquePerThrust(k) => vehicle.rotors[k].spread.torque_per_thrust,
        }
    }

    /// Moves the parameter to a share of its interval: 0 at the lower end, 1 at the upper one.
    fn place(self, vehicle: &mut Vehicle, share: f64) {
        let Spread { low, high } = self.spread(vehicle);
        let factor = low + share * (high - low);
        match self {
            Parameter::Mass => vehicle.mass *= factor,
            Parameter::Dynamic(figure) => figure.place(vehicle, share),
            // The speed that is commanded stays, and thrust and torque of that speed change.
            Parameter::Thrust(k) => {
                vehicle.rotors[k].thrust_coefficient *= factor;
                vehicle.rotors[k].drag_coefficient *= factor;
            }
            Parameter::TorquePerThrust(k) => vehicle.rotors[k].drag_coefficient *= factor,
        }
    }
}

/// A vehicle of the intervals: `shares` are 0 at the lower and 1 at the upper end, one for each parameter.
fn at(vehicle: &Vehicle, parameters: &[Parameter], shares: &[f64]) -> Vehicle {
    let mut varied = vehicle.clone();
    for (parameter, share) in parameters.iter().zip(shares) {
        parameter.place(&mut varied, *share);
    }
    varied.mass_spread = Spread::NONE;
    varied.rotors.iter_mut().for_each(|rotor| rotor.spread = RotorSpread::default());
    varied
}

/// The vehicles at the corners of the intervals: all of up to five intervals; of more the two ends of each with the
/// others in the middle, and sixteen drawn evenly from all. The vehicle itself if nothing has an interval.
pub fn corners(vehicle: &Vehicle) -> Vec<Vehicle> {
    let parameters = Parameter::of(vehicle);
    let n = parameters.len();
    if n == 0 {
        return vec![vehicle.clone()];
    }
    if n <= MOST_INTERVALS {
        let shares =
            |corner: usize| (0..n).map(|bit| f64::from(u8::from(corner >> bit & 1 == 1))).collect::<Vec<f64>>();
        return (0..1 << n).map(|corner| at(vehicle, &parameters, &shares(corner))).collect();
    }
    let middle = |parameter: &Parameter| {
        let Spread { low, high } = parameter.spread(vehicle);
        if high > low { (1.0 - low) / (high - low) } else { 0.5 }
    };
    let middles: Vec<f64> = parameters.iter().map(middle).collect();
    let ends = (0..n).flat_map(|k| [(k, 0.0), (k, 1.0)]).map(|(k, end)| {
        let mut shares = middles.clone();
        shares[k] = end;
        at(vehicle, &parameters, &shares)
    });
    let mut random = Pcg64Mcg::seed_from_u64(SEED);
    let drawn: Vec<Vehicle> = (0..DRAWN).map(|_| draw(vehicle, &mut random)).collect();
    ends.chain(drawn).collect()
}

/// A vehicle with every parameter drawn evenly from its interval.
pub fn draw(vehicle: &Vehicle, random: &mut Pcg64Mcg) -> Vehicle {
    let parameters = Parameter::of(vehicle);
    let shares: Vec<f64> = parameters.iter().map(|_| StandardUniform.sample(random)).collect();
    at(vehicle, &parameters, &shares)
}

/// The vehicle with its centre of gravity off by up to `most` (m) along x and along y of the body, drawn evenly.
pub fn off_centre(vehicle: &Vehicle, most: f64, random: &mut Pcg64Mcg) -> Vehicle {
    let mut varied = vehicle.clone();
    let [x, y] = [0, 1].map(|_| {
        let share: f64 = StandardUniform.sample(random);
        most * (2.0 * share - 1.0)
    });
    for rotor in &mut varied.rotors {
        rotor.position[0] -= x;
        rotor.position[1] -= y;
    }
    varied
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vehicle(text: &str) -> Vehicle {
        let spec = crate::compile(text).into_result().unwrap();
        spec.model().vehicle.clone()
    }

    const RING: &str = "layout = \"PNPN\"; arm = 20 cm; inertia = [0.01, 0.01, 0.02] kg*m^2";

    #[test]
    fn few_intervals_are_flown_at_every_corner() {
        let two = format!(
            "vehicle v {{ {RING}; mass = 1 kg +- 10 %; yaw_drag = 4e-3 N*m*s/rad +- 50 %
                rotor {{ max_thrust = 8 N; torque_per_thrust = 15 mm; max_speed = 800 rad/s }} }}"
        );
        let all: Vec<[f64; 2]> = corners(&vehicle(&two)).iter().map(|v| [v.mass, v.yaw_drag.unwrap().linear]).collect();
        let expected = [[0.9, 2e-3], [1.1, 2e-3], [0.9, 6e-3], [1.1, 6e-3]];
        assert_eq!(all.len(), 4);
        for corner in expected {
            let is_near = |found: &&[f64; 2]| (0..2).all(|k| (found[k] / corner[k] - 1.0).abs() < 1e-12);
            assert_eq!(all.iter().filter(is_near).count(), 1, "{corner:?} {all:?}");
        }
        let none = two.replace(" +- 10 %", "").replace(" +- 50 %", "");
        assert_eq!(corners(&vehicle(&none)), [vehicle(&none)]);
    }

    /// Four rotors with two intervals each: sixteen ends and sixteen draws, all within the intervals. The thrust of a
    /// speed changes, and the largest speed does not.
    #[test]
    fn many_intervals_are_flown_one_at_a_time_and_drawn() {
        let many = vehicle(&format!(
            "vehicle v {{ {RING}; mass = 1 kg
                rotor {{ max_thrust = 8 N +- 5 %; torque_per_thrust = 15 mm +- 20 %; max_speed = 800 rad/s }} }}"
        ));
        let found = corners(&many);
        assert_eq!(found.len(), 16 + 16);
        let ratios = |v: &Vehicle| {
            let of = |k: usize| {
                let [a, b] = [&v.rotors[k], &many.rotors[k]];
                let thrust = a.max_thrust() / b.max_thrust();
                [thrust, a.drag_coefficient / b.drag_coefficient / thrust]
            };
            [of(0), of(1), of(2), of(3)]
        };
        for one in &found[..16] {
            assert_eq!(ratios(one).iter().flatten().filter(|r| (*r - 1.0).abs() > 1e-9).count(), 1);
        }
        for one in &found {
            assert!(ratios(one).iter().all(|[t, k]| (t - 1.0).abs() < 0.0501 && (k - 1.0).abs() < 0.2001));
            assert!(one.rotors.iter().zip(&many.rotors).all(|(a, b)| a.max_speed == b.max_speed));
        }
        assert!(ratios(&found[16]).iter().flatten().all(|r| (*r - 1.0).abs() > 1e-9));
    }
}
