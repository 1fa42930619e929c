//! Everything that formats write of a trajectory at an instant.

use crate::flatness::rotor_drag;
use crate::model::Model;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use crate::number::number;
use crate::report::trajectory_csv::{Row, rows};
use nalgebra::{Matrix3, Vector3};

/// The state of a vehicle that follows the trajectory exactly, with thrust and attitude by differential flatness,
/// whatever model planned it (`docs/method/exact-model.md`). World x east, y north, z up; body x forward, y left, z up;
/// SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    /// s since the start.
    pub time: f64,
    pub position: [f64; 3],
    pub velocity: [f64; 3],
    pub acceleration: [f64; 3],
    pub jerk: [f64; 3],
    /// From body to world.
    pub attitude: Matrix3<f64>,
    /// Rates of the body about its own axes, rad/s.
    pub rates: [f64; 3],
    /// Derivatives of the rates, rad/s^2.
    pub turning: [f64; 3],
    /// N.
    pub thrust: f64,
    /// Share of the greatest thrust: that of all rotors of the healthy vehicle at their greatest speed.
    pub share: f64,
    /// rad, and its rate, rad/s.
    pub yaw: [f64; 2],
    /// The waypoint that is reached in this row, from 1; 0 for none.
    pub waypoint: usize,
}

impl Instant {
    /// # Errors
    /// The attitude is not defined.
    fn new(row: &Row, state: &NodeState, model: &Model) -> Result<Self, String> {
        let environment = model.environment();
        let order = |order: usize| [X, Y, Z].map(|axis| state[axis][order]);
        let yaw = [state[YAW][0], state[YAW][1]];
        let [attitude, change] = rotor_drag::rotation(&environment, [order(1), order(2), order(3)], yaw);
        // R' = R [w]x
        let skew = attitude.transpose() * change;
        let rates = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]);
        // (67): tau = J w' + w x J w
        let inertia = Vector3::from(model.vehicle.inertia);
        let wrench = WrenchModel::Exact.wrench(&model.vehicle, &environment, state);
        let torque = Vector3::new(wrench[1], wrench[2], wrench[3]);
        let turning = (torque - rates.cross(&inertia.component_mul(&rates))).component_div(&inertia);
        let most: f64 = model.vehicle.rotors.iter().map(crate::model::Rotor::max_thrust).sum();
        if !attitude.iter().chain(&rates).chain(&turning).chain(wrench.iter()).all(|x| x.is_finite()) {
            let time = number(row.time);
            return Err(format!(
                "the attitude is not defined at {time} s, where the plan needs no thrust or a roll of 90 degrees: \
                 --format csv has the motion alone"
            ));
        }
        Ok(Instant {
            time: row.time,
            position: order(0),
            velocity: order(1),
            acceleration: order(2),
            jerk: order(3),
            attitude,
            rates: rates.into(),
            turning: turning.into(),
            thrust: wrench[0],
            share: wrench[0] / most,
            yaw,
            waypoint: row.waypoint,
        })
    }
}

/// One instant for each row of the table, by nodes or at a rate (Hz).
///
/// # Errors
/// The attitude is not defined at one of them.
pub fn all(trajectory: &Trajectory, model: &Model, rate: Option<f64>) -> Result<Vec<Instant>, String> {
    rows(trajectory, rate).iter().map(|row| Instant::new(row, &trajectory.at(row.time), model)).collect()
}
