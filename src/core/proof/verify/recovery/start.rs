//! The states in which a fault may become known.

use super::super::interval::{Interval, exceeds};
use super::super::motion::{Motion, State, X, Y, YAW, Z};
use super::super::plan::Setting;
use super::super::wrench::thrust_over_mass;
use super::tube::{Cell, Deviations};
use crate::certificate::{DynamicModel, FamilyRecord, StateTolerance};
use crate::model::Rotor;
use crate::number::number;

/// The states of a family when its faults become known: near the blends of its branches' initial states.
pub(super) struct StartAbout<'s, 'a> {
    setting: &'s Setting<'a>,
    tolerance: StateTolerance,
    /// The first and the last instant of the fault, s.
    pub faults: [f64; 2],
    /// The shortest and the longest delay until it is known, s.
    pub delays: [f64; 2],
}

impl<'s, 'a> StartAbout<'s, 'a> {
    /// # Errors
    /// A tolerance is negative or not a number.
    pub fn new(record: &FamilyRecord, setting: &'s Setting<'a>) -> Result<Self, String> {
        let t = record.tolerance;
        let all = [t.position_m, t.velocity_m_s, t.tilt_rad, t.turning_rad_s, t.yaw_rad, t.yaw_rate_rad_s];
        if all.iter().any(|value| !(value.is_finite() && *value >= 0.0)) {
            return Err("a tolerance is negative or not a number".into());
        }
        Ok(StartAbout { setting, tolerance: t, faults: [record.from_s, record.to_s], delays: record.delays_s })
    }

    /// The instants at which the faults of a cell become known, s.
    pub fn known(&self, [s, r]: Cell) -> Interval {
        let [from, to] = self.faults.map(Interval::point);
        let [least, most] = self.delays.map(Interval::point);
        from + s * (to - from) + least + r * (most - least)
    }

    pub fn gravity(&self) -> f64 {
        self.setting.dynamics().environment.gravity
    }

    /// Deviations that make up all states within the tolerances, from the expected initial states `of` a cell.
    ///
    /// The thrust over mass `a = p_2 + g e_z + k (p_1 - w)`, with p_i the i-th derivative of the position, keeps its
    /// size c and its rate of change c'; its direction n and n' deviate by at most the tolerances e and e'. Then a
    /// deviates by at most c e, a' by at most |c'| e + c e', and `p_2 = a - g e_z - k (p_1 - w)` and `p_3 = a' - k p_2`
    /// follow. In the hover model, c = g and c' = 0.
    pub fn deviations(&self, of: &State) -> Deviations {
        let t = &self.tolerance;
        let dynamics = self.setting.dynamics();
        let environment = &dynamics.environment;
        let [position, velocity, tilt, turning] =
            [t.position_m, t.velocity_m_s, t.tilt_rad, t.turning_rad_s].map(Interval::point);
        let (second, third, vertical) = match dynamics.model {
            DynamicModel::Hover => {
                let g = Interval::point(environment.gravity);
                (g * tilt, g * turning, 2)
            }
            DynamicModel::Exact => {
                let rate = environment.turning_rate();
                let thrust = thrust_over_mass::<2>(of, environment, rate);
                let length =
                    |order: usize| thrust.iter().fold(Interval::ZERO, |sum, part| sum + part.0[order].square()).sqrt();
                let k = Interval::point(rate.abs());
                // The winds other than the middle one, to which the direction of the thrust belongs.
                let spread = environment.wind_spread.map(Interval::point);
                let winds = spread.iter().fold(Interval::ZERO, |sum, part| sum + part.square()).sqrt();
                let second = length(0) * tilt + k * (velocity + winds);
                (second, length(1) * tilt + length(0) * turning + k * second, 4)
            }
        };
        let around = |by: f64| Interval::around_zero(by);
        let mut all = [[Interval::ZERO; 4]; 4];
        for axis in [X, Y, Z] {
            let kept = if axis == Z { vertical } else { 4 };
            for (slot, by) in all[axis].iter_mut().zip([position, velocity, second, third]).take(kept) {
                *slot = around(by.high);
            }
        }
        (all[YAW][0], all[YAW][1]) = (around(t.yaw_rad), around(t.yaw_rate_rad_s));
        all
    }

    /// Checks that branches begin where the vehicle can be: a fault changes the thrust over mass by at most the
    /// largest thrust and that of the plan, so that after a delay d position and velocity are at most `a d^2 / 2` and
    /// `a d` away from those of the plan.
    ///
    /// # Errors
    /// One begins farther away.
    pub fn near_the_plan(&self, corners: [&Motion; 4], plan: &Motion) -> Result<(), String> {
        let vehicle = &self.setting.model().vehicle;
        let environment = &self.setting.dynamics().environment;
        let largest: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
        for (index, branch) in corners.into_iter().enumerate() {
            let (fault, delay) = (self.faults[index % 2], self.delays[index / 2]);
            let flown = along(plan, Interval::new(fault, fault + delay));
            let thrust = thrust_over_mass::<2>(&flown, environment, environment.turning_rate());
            let planned = thrust.iter().fold(Interval::ZERO, |sum, part| sum + part.value().square()).sqrt();
            let a = Interval::point(largest) / Interval::point(vehicle.mass) + planned;
            let d = Interval::point(delay);
            let there = along(plan, Interval::point(fault) + d);
            let allowed = [(a * d * d * Interval::point(0.5), "m from"), (a * d, "m/s faster or slower than")];
            for (order, (allowed, what)) in allowed.into_iter().enumerate() {
                let apart = |axis: usize| Interval::point(branch.at_node(0, axis, order)) - there[axis][order];
                let distance = [X, Y, Z].map(apart).into_iter().fold(Interval::ZERO, |sum, d| sum + d.square()).sqrt();
                if exceeds(distance.low, allowed.high) {
                    return Err(format!(
                        "a branch begins {} {what} the plan at {} s, which no fault explains after {} s",
                        number(distance.low),
                        number(fault + delay),
                        number(delay)
                    ));
                }
            }
        }
        Ok(())
    }
}

/// Enclosures of the derivatives along a plan over some times, s; after its end it is at rest.
pub(super) fn along(plan: &Motion, times: Interval) -> State {
    let last = plan.pieces();
    let mut all: Option<State> = None;
    let mut add = |state: State| {
        let hull = |a: Interval, b: Interval| Interval::new(a.low.min(b.low), a.high.max(b.high));
        all = Some(match all {
            Some(all) => std::array::from_fn(|axis| std::array::from_fn(|i| hull(all[axis][i], state[axis][i]))),
            None => state,
        });
    };
    for piece in 0..last {
        let [left, right] = [plan.times[piece], plan.times[piece + 1]];
        if times.high >= left && times.low <= right {
            let part = Interval::new(times.low.max(left), times.high.min(right)) - Interval::point(left);
            add(plan.over(piece, part));
        }
    }
    if times.high > plan.times[last] {
        let mut rest = [[Interval::ZERO; 6]; 4];
        rest.iter_mut().enumerate().for_each(|(axis, of)| of[0] = Interval::point(plan.at_node(last, axis, 0)));
        add(rest);
    }
    all.unwrap_or([[Interval::WHOLE; 6]; 4])
}
