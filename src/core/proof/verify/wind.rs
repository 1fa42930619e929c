//! Planes in an interval of winds: a bound on their violation in every wind of the box.
//!
//! The wrench is a Taylor model in the wind's deviation from its middle, and so is the violation of a plane. What is
//! proved to be small is the upper bound of this model, a function of time like the violation in one wind. A wide
//! interval is divided into boxes, so that the terms that the models bound coarsely are small.

use super::interval::Interval;
use super::motion::State;
use super::proof::Rated;
use super::series::Scalar;
use super::sets::Plane;
use super::taylor::Taylor;
use super::wrench::{Dynamics, Held};
use crate::model::Environment;

/// Units of work of a state for each box, as a multiple of those for one wind (measured: 14 to 24).
const COST_PER_BOX: u64 = 25;

/// Units of work of a plane in each box: its violation is a Taylor model too (measured: 9 to 12).
const COST_PER_PLANE_IN_BOX: u64 = 12;

/// In a box of winds the thrust over mass changes along the three axes by at most this share of gravity in all.
const WIDEST: f64 = 0.1;

/// Most boxes. With wider ones the bounds are wide, and prove less.
const MOST_BOXES: usize = 64;

/// Halves may differ from exact ones by rounding; each is taken wider by this share, so that together they cover the
/// whole.
const OVERLAP: f64 = 1e-9;

/// The equations in each of some boxes that together cover the interval of winds.
pub fn boxes<'a>(dynamics: &Dynamics<'a>) -> Vec<Dynamics<'a>> {
    let whole = dynamics.environment;
    let mut spread = whole.wind_spread;
    let mut middles = vec![whole.wind];
    let is_wide = |spread: &[f64; 3]| whole.turning_rate() * spread.iter().sum::<f64>() > WIDEST * whole.gravity;
    while is_wide(&spread) && 2 * middles.len() <= MOST_BOXES {
        let axis = (1..3).fold(0, |widest, axis| if spread[axis] > spread[widest] { axis } else { widest });
        spread[axis] *= 0.5;
        let moved = |middle: &[f64; 3], by: f64| {
            let mut moved = *middle;
            moved[axis] += by;
            moved
        };
        middles = middles.iter().flat_map(|m| [moved(m, -spread[axis]), moved(m, spread[axis])]).collect();
    }
    let overlap = if middles.len() > 1 { 1.0 + OVERLAP } else { 1.0 };
    let wind_spread = spread.map(|s| s * overlap);
    let of_box = |wind: [f64; 3]| Environment { wind, wind_spread, ..whole };
    middles.into_iter().map(|m| Dynamics { environment: of_box(m), ..dynamics.clone() }).collect()
}

/// Units of work of a state, as a multiple of those for one wind.
pub fn cost(dynamics: &Dynamics) -> u64 {
    COST_PER_BOX.saturating_mul(boxes(dynamics).len() as u64)
}

/// Units of work of a plane at a state.
pub fn cost_of_a_plane(dynamics: &Dynamics) -> u64 {
    COST_PER_PLANE_IN_BOX.saturating_mul(boxes(dynamics).len() as u64)
}

/// An upper bound of each plane's violation over all winds of the `boxes`, and bounds on the violation's rate of change
/// in each of these winds.
pub fn violations(boxes: &[Dynamics], held: Held, state: &State, planes: &[&Plane]) -> Vec<Rated> {
    let wrenches: Vec<_> = boxes.iter().map(|winds| winds.held_by_wind(held, state)).collect();
    let of_plane = |plane: &&Plane| {
        let each = wrenches.iter().map(|wrench| Rated {
            value: along(&plane.normal, &wrench.value).upper() - plane.offset,
            rate: along(&plane.normal, &wrench.rate).range(),
        });
        each.reduce(worse).unwrap_or(Rated { value: Interval::WHOLE, rate: Interval::WHOLE })
    };
    planes.iter().map(of_plane).collect()
}

/// The scalar product.
fn along(normal: &[Interval; 4], vector: &[Taylor; 4]) -> Taylor {
    (0..4).fold(Taylor::of(Interval::ZERO), |sum, i| sum + vector[i].scaled(normal[i]))
}

/// The larger of two quantities: its value, and bounds on its rate of change, which is that of either.
fn worse(a: Rated, b: Rated) -> Rated {
    // NaN stays.
    let larger = |x: f64, y: f64| if x.is_nan() || x > y { x } else { y };
    let [low, high] = [larger(a.value.low, b.value.low), larger(a.value.high, b.value.high)];
    let smaller = |x: f64, y: f64| if x.is_nan() || x < y { x } else { y };
    let rate = Interval { low: smaller(a.rate.low, b.rate.low), high: larger(a.rate.high, b.rate.high) };
    Rated { value: Interval { low, high }, rate }
}
