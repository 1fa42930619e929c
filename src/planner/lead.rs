//! Rotors that lag behind their commands: rows on the lead wrench.
//!
//! Where every thrust follows its command with f_c = f + tau f', a path w(t) of the wrench can be flown exactly where its
//! lead wrench c = w + tau w' stays admissible as w does (docs/method.md, section 14). So each facet stands for c too.

use super::hover_model::{WrenchMap, X, Y, YAW, YawState, Z};
use super::profile::Profile;
use super::transcribe::{NodeState, Transcription};
use super::yaw::YawPlan;
use crate::actuation::Wrench;
use crate::model::Vehicle;
use crate::qp::build::Affine;
use std::collections::BTreeMap;

/// At a node the inputs bend, and w' jumps: which slope of theirs is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slope {
    /// That of the interval which ends there.
    Before,
    /// That of the interval which begins there; between nodes the only one.
    After,
}

/// An instant (see `Transcription::parts`) and the slope meant there.
pub type LeadAt = (usize, Slope);

/// The interval whose slope is meant; `None` before the first and after the last.
pub(super) fn interval_of((instant, slope): LeadAt, parts: usize, intervals: usize) -> Option<usize> {
    let (interval, part) = (instant / parts, instant % parts);
    match slope {
        Slope::Before if part == 0 => interval.checked_sub(1),
        Slope::Before => None,
        Slope::After => (interval < intervals).then_some(interval),
    }
}

/// Derivatives `[axis][order]` with the slope of each axis's input above the input, SI units.
pub type LeadState = [[f64; 6]; 4];

/// A state within the interval of length `h` s between two nodes, with the slopes there; `orders` as in
/// [`super::wrench_model::WrenchModel::orders`].
pub fn with_slopes(state: &NodeState, [left, right]: [&NodeState; 2], h: f64, orders: [usize; 4]) -> LeadState {
    std::array::from_fn(|axis| {
        let r = orders[axis];
        let mut derivatives = [0.0; 6];
        derivatives[..=r].copy_from_slice(&state[axis][..=r]);
        derivatives[r + 1] = (right[axis][r] - left[axis][r]) / h;
        derivatives
    })
}

/// The lead wrench where rows on it can stand.
pub type LeadMaps = BTreeMap<LeadAt, WrenchMap>;

impl WrenchMap {
    /// The lead wrench c = w + tau w' of the hover model, for a yaw motion with psi''' = `jerk`, rad/s^3.
    ///
    /// g phi = s x'' - c y'', so by Leibniz g phi'' = sum over i of C(2, i) (s^(2-i) x^(2+i) - c^(2-i) y^(2+i)), and g
    /// phi''' alike with C(3, i) and 3 - i, where s^(k), c^(k) are the k-th time derivatives of sin psi and cos psi; g theta
    /// has c and s in their places, both with a plus.
    pub fn leading(vehicle: &Vehicle, gravity: f64, yaw: YawState, jerk: f64, tau: f64) -> Self {
        let (s, c) = yaw.psi.sin_cos();
        let YawState { rate, acceleration, .. } = yaw;
        let square = rate * rate;
        let (along, across) = (jerk - rate * square, 3.0 * rate * acceleration);
        let sin = [s, rate * c, acceleration * c - square * s, along * c - across * s];
        let cos = [c, -rate * s, -acceleration * s - square * c, -along * s - across * c];
        const SECOND: [f64; 3] = [1.0, 2.0, 1.0];
        const THIRD: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
        let weight = |of: &[f64; 4], i: usize| {
            let second = if i < 3 { SECOND[i] * of[2 - i] } else { 0.0 };
            second + tau * THIRD[i] * of[3 - i]
        };
        let [ixx, iyy, izz] = vehicle.inertia;
        let (roll, pitch) = (ixx / gravity, iyy / gravity);
        let mut terms = Vec::new();
        for i in (0..4).rev() {
            let (of_sin, of_cos) = (weight(&sin, i), weight(&cos, i));
            if of_sin != 0.0 || of_cos != 0.0 {
                terms.push((X, 2 + i, Wrench::new(0.0, roll * of_sin, pitch * of_cos, 0.0)));
                terms.push((Y, 2 + i, Wrench::new(0.0, -roll * of_cos, pitch * of_sin, 0.0)));
            }
        }
        terms.push((Z, 2, Wrench::new(vehicle.mass, 0.0, 0.0, 0.0)));
        terms.push((Z, 3, Wrench::new(tau * vehicle.mass, 0.0, 0.0, 0.0)));
        let constant = Wrench::new(vehicle.mass * gravity, 0.0, 0.0, izz * (acceleration + tau * jerk));
        WrenchMap { constant, terms }
    }

    /// The same for a yaw that is itself a variable, linearised at a constant psi.
    pub fn leading_with_free_yaw(vehicle: &Vehicle, gravity: f64, psi: f64, tau: f64) -> Self {
        let mut map = Self::leading(vehicle, gravity, YawState { psi, ..YawState::default() }, 0.0, tau);
        let turn = Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2]);
        map.terms.extend([(YAW, 2, turn), (YAW, 3, tau * turn)]);
        map
    }
}

impl YawPlan {
    /// The lead wrench of the hover model at both ends of every interval.
    pub fn leads(&self, vehicle: &Vehicle, gravity: f64, profile: &Profile, tau: f64) -> LeadMaps {
        let map = |node: usize, jerk: f64| match self {
            YawPlan::Free { psi } => WrenchMap::leading_with_free_yaw(vehicle, gravity, *psi, tau),
            YawPlan::Frozen(states) => WrenchMap::leading(vehicle, gravity, states[node], jerk, tau),
        };
        let ends = |(interval, step): (usize, f64)| {
            let jerk = match self {
                YawPlan::Free { .. } => 0.0,
                YawPlan::Frozen(states) => (states[interval + 1].acceleration - states[interval].acceleration) / step,
            };
            [((interval, Slope::After), map(interval, jerk)), ((interval + 1, Slope::Before), map(interval + 1, jerk))]
        };
        profile.steps().enumerate().flat_map(ends).collect()
    }
}

impl Transcription<'_> {
    /// A derivative, or the slope of an input, where a lead wrench is taken; `bend` is what derivatives (node, axis, order)
    /// have more on the later side of their node. `None` where there is no such interval.
    pub(super) fn lead_derivative(
        &self,
        at: LeadAt,
        (axis, order): (usize, usize),
        bend: &dyn Fn(usize, usize, usize) -> Affine,
    ) -> Option<Affine> {
        let (instant, slope) = at;
        let interval = interval_of(at, self.parts, self.profile.intervals())?;
        let input = self.orders[axis];
        if order <= input {
            let mut derivative = self.derivative(instant, axis, order);
            if slope == Slope::After && instant % self.parts == 0 {
                derivative.add(&bend(interval, axis, order), 1.0);
            }
            return Some(derivative);
        }
        let h = self.profile.node_times[interval + 1] - self.profile.node_times[interval];
        let mut rise = self.at_node(interval + 1, axis, input);
        rise.add(&self.at_node(interval, axis, input), -1.0);
        rise.add(&bend(interval, axis, input), -1.0);
        Some(rise.times(1.0 / h))
    }

    /// The lead wrench of states at a node, by the maps of [`Self::leads`]; `None` without them or without such an
    /// interval.
    pub(super) fn lead_wrench(&self, states: &[NodeState], at: LeadAt) -> Option<Wrench> {
        let map = self.leads?.get(&at)?;
        let interval = interval_of(at, self.parts, self.profile.intervals())?;
        let h = self.profile.node_times[interval + 1] - self.profile.node_times[interval];
        let ends = [&states[interval], &states[interval + 1]];
        Some(map.at(&with_slopes(&states[at.0 / self.parts], ends, h, self.orders)))
    }
}
