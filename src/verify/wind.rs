//! Planes in an interval of winds: their largest violation over the extreme winds, the corners of the box.
//!
//! Between these winds nothing is proved: interval arithmetic over a box of winds of some m/s bounds the torques far too
//! widely. A certificate of such a spec is therefore weaker than the spec requires.

use super::interval::Interval;
use super::motion::State;
use super::proof::Rated;
use super::sets::{Plane, along};
use super::wrench::{Dynamics, Held};

/// Units of work of a state, as a multiple of those for one wind: eight corners.
pub const COST: u64 = 8;

/// Why a certificate is weaker than the spec requires.
pub const BETWEEN: &str = "the wrench is shown in the extreme winds of the spec's interval, not in winds between them";

/// The largest violation of each plane over `winds`, and a bound on its rate of change.
pub fn violations(winds: &[Dynamics], held: Held, state: &State, planes: &[&Plane]) -> Vec<Rated> {
    let wrenches: Vec<_> = winds.iter().map(|wind| wind.held(held, state)).collect();
    let of_plane = |plane: &&Plane| {
        let each = wrenches
            .iter()
            .map(|wrench| Rated { value: plane.violation(&wrench.value), rate: along(&plane.normal, &wrench.rate) });
        let whole = Rated { value: Interval::WHOLE, rate: Interval::WHOLE };
        each.reduce(worse).unwrap_or(whole)
    };
    planes.iter().map(of_plane).collect()
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
