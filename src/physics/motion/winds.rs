//! The wrench of a motion over an interval of winds, to second order in the wind's deviation from its middle, and a
//! bound on its violation of a facet in every wind: `docs/method/air.md`, (91) to (93).

use super::wrench_model::{WrenchModel, command_flat, flat};
use super::{CommandState, NodeState, X, Y, YAW, Z, in_air};
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::Turning;
use crate::flatness::{self, ByAcceleration, PAIRS};
use crate::model::{Environment, Vehicle};

/// The wrench in every wind of an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct OverWinds {
    /// The wrench in the middle of the winds, N and N m.
    pub middle: Wrench,
    /// One for each of [`boxes`]; none where one wind is possible.
    parts: Vec<Part>,
    /// How the motion turns, for rows of cores, which a spec with more than one wind does not have.
    turning: Option<Turning>,
}

/// The wrench `w + sum over i of l_i d_i + sum over i <= j of q_ij d_i d_j` (91), N and N m, in a box of winds, for
/// every deviation d in [-1, 1]^3 from its middle, in units of the largest.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    middle: Wrench,
    linear: [Wrench; 3],
    /// By [`PAIRS`].
    quadratic: [Wrench; 6],
    /// Bounds on the absolute values of the terms of higher order.
    rest: Wrench,
}

impl OverWinds {
    /// The wrench of a state in each wind of an interval.
    pub fn of_wrench(model: WrenchModel, vehicle: &Vehicle, environment: &Environment, state: &NodeState) -> Self {
        let of_box = |winds: &Environment| {
            let felt = in_air(state, winds);
            let middle = model.wrench(vehicle, winds, state);
            let by = flatness::wrench_by_acceleration(vehicle, winds.gravity, &flat(&felt));
            Part::new(middle, by, winds, rest(vehicle, winds, &felt, 0.0))
        };
        let middle = model.wrench(vehicle, environment, state);
        OverWinds { middle, parts: boxes(model, environment).iter().map(of_box).collect(), turning: None }
    }

    /// These wrenches with how the motion turns.
    pub fn turning(self, turning: Turning) -> Self {
        OverWinds { turning: Some(turning), ..self }
    }

    /// The commanded wrench of rotors with a lag of time constant `lag`, s, in each wind of an interval.
    pub fn of_commands(
        model: WrenchModel,
        vehicle: &Vehicle,
        environment: &Environment,
        lag: f64,
        state: &CommandState,
    ) -> Self {
        let of_box = |winds: &Environment| {
            let felt = in_air(state, winds);
            let middle = model.commanded(vehicle, winds, lag, state);
            let by = flatness::commanded_by_acceleration(vehicle, winds.gravity, lag, &command_flat(&felt));
            Part::new(middle, by, winds, rest(vehicle, winds, &felt, lag))
        };
        let middle = model.commanded(vehicle, environment, lag, state);
        OverWinds { middle, parts: boxes(model, environment).iter().map(of_box).collect(), turning: None }
    }

    /// An upper bound of a row's violation in every wind; where one wind is possible, its violation.
    pub fn worst(&self, row: &SetRow) -> f64 {
        if self.parts.is_empty() {
            return row.violation(&self.middle) + row.of_core(self.turning.as_ref());
        }
        let of_part = |part: &Part| match row.equality {
            true => (part.most(&row.normal) - row.offset).max(part.most(&-row.normal) + row.offset),
            false => part.most(&row.normal) - row.offset,
        };
        // NaN stays.
        let worse = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
        self.parts.iter().map(of_part).fold(f64::NEG_INFINITY, worse)
    }

    /// By how much [`Self::worst`] is above the violation in the middle of the winds.
    pub fn more_in_winds(&self, row: &SetRow) -> f64 {
        let more = self.worst(row) - row.violation(&self.middle) - row.of_core(self.turning.as_ref());
        if more.is_finite() { more } else { 0.0 }
    }
}

/// In a box of winds the thrust over mass changes along the three axes by at most this share of gravity in all.
const WIDEST: f64 = 0.1;

/// Most boxes.
const MOST_BOXES: usize = 64;

/// Boxes that cover the interval of winds, each small enough for terms of third order to be small; none if one wind is
/// possible.
fn boxes(model: WrenchModel, environment: &Environment) -> Vec<Environment> {
    if model != WrenchModel::Exact || !environment.is_uncertain() {
        return Vec::new();
    }
    let mut all = vec![*environment];
    let mut spread = environment.wind_spread;
    let change = |spread: &[f64; 3]| environment.turning_rate() * spread.iter().sum::<f64>();
    while change(&spread) > WIDEST * environment.gravity && 2 * all.len() <= MOST_BOXES {
        let widest = [X, Y, Z].into_iter().fold(X, |a, b| if spread[b] > spread[a] { b } else { a });
        spread[widest] *= 0.5;
        let half = |of: &Environment, side: f64| {
            let mut half = Environment { wind_spread: spread, ..*of };
            half.wind[widest] += side * spread[widest];
            half
        };
        all = all.iter().flat_map(|of| [half(of, -1.0), half(of, 1.0)]).collect();
    }
    all
}

impl Part {
    /// From derivatives with respect to the acceleration, which a deviation d of the wind changes by
    /// `-drag/m spread d`.
    fn new(
        middle: Wrench,
        ByAcceleration { slopes, curvatures }: ByAcceleration,
        winds: &Environment,
        rest: Wrench,
    ) -> Self {
        let unit = winds.wind_spread.map(|spread| -winds.turning_rate() * spread);
        let quadratic = |p: usize| {
            let (i, j) = PAIRS[p];
            // Half of the Hessian, which has each square once and each other product twice.
            let share = if i == j { 0.5 } else { 1.0 };
            curvatures[p] * (share * unit[i] * unit[j])
        };
        Part {
            middle,
            linear: std::array::from_fn(|i| slopes[i] * unit[i]),
            quadratic: std::array::from_fn(quadratic),
            rest,
        }
    }

    /// The bound (92) on `n . w(d)` over all d.
    fn most(&self, n: &Wrench) -> f64 {
        let linear: f64 = self.linear.iter().map(|l| n.dot(l).abs()).sum();
        let of_pair = |(q, (i, j)): (&Wrench, (usize, usize))| {
            let c = n.dot(q);
            if i == j { c.max(0.0) } else { c.abs() }
        };
        let quadratic: f64 = self.quadratic.iter().zip(PAIRS).map(of_pair).sum();
        n.dot(&self.middle) + linear + quadratic + n.abs().dot(&self.rest)
    }
}

/// Factors of the bound (93) for the thrust and each torque, chosen to cover what the checker of certificates leaves to
/// its own rest at random states (`tests/it/certificates/winds.rs`).
const FACTORS: [f64; 4] = [1.0, 14.0, 14.0, 22.0];

/// The bound (93) on the terms of third and higher order, for the commanded wrench of rotors with a lag of time
/// constant `lag` (s), 0 for the wrench. `felt` is a state [`in_air`]. With c the thrust over mass and k its part in
/// the plane of forward and up, the wind changes c by at most the share rho of k.
fn rest<const N: usize>(vehicle: &Vehicle, winds: &Environment, felt: &[[f64; N]; 4], lag: f64) -> Wrench {
    let derivative = |axis: usize, order: usize| felt[axis].get(order).copied().unwrap_or(0.0);
    let norm = |order: usize| [X, Y, Z].map(|axis| derivative(axis, order).powi(2)).iter().sum::<f64>().sqrt();
    let (s, c) = felt[YAW][0].sin_cos();
    let k = (c * felt[X][2] + s * felt[Y][2]).hypot(felt[Z][2] + winds.gravity);
    let rho = winds.turning_rate() * winds.wind_spread.iter().sum::<f64>() / k;
    if rho >= 1.0 {
        return Wrench::from_element(f64::INFINITY);
    }
    let third = (rho / (1.0 - rho)).powi(3);
    // Sizes of the body rates and of their derivatives.
    let rate = norm(3) / k + derivative(YAW, 1).abs();
    let acceleration = norm(4) / k + derivative(YAW, 2).abs() + rate * rate;
    let jerk = norm(5) / k + derivative(YAW, 3).abs() + rate * acceleration;
    // tau = J omega' + omega x J omega, and the lag times its derivative.
    let (turning, crossed) = (acceleration + lag * jerk, rate * rate + 2.0 * lag * rate * acceleration);
    let [x, y, z] = vehicle.inertia;
    let torque = |own: f64, others: f64| own * turning + others * crossed;
    let sizes =
        Wrench::new(vehicle.mass * k * (1.0 + lag * rate), torque(x, y + z), torque(y, z + x), torque(z, x + y));
    Wrench::from(FACTORS).component_mul(&sizes) * third
}
