//! The quickest climb of rotors that lag, in closed form.

use super::{lagging, planning, shortest};
use crate::vehicles::{mission, waypoint};
use mavc::model::{MissionTime, Model, PlanModel};

const HEIGHT: f64 = 12.0;
const WITHIN: f64 = 5e-3;

/// The shortest time in which z'' = u, u + tau u' = v with v from -`down` to `up` m/s^2 leads from rest (u = 0 too) to
/// rest `height` m above. Such a system of third order with real modes is fastest with v at its bounds and two switches
/// (Pontryagin): `up` for t1, -`down` for t2, `up` for t3. Integrated, with T = t1 + t2 + t3:
///
/// u(T) = 0, integral of v = 0, integral of (T - t) v = height.
fn quickest(height: f64, up: f64, down: f64, tau: f64) -> f64 {
    let bisect = |mut low: f64, mut high: f64, too_low: &dyn Fn(f64) -> bool| {
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if too_low(middle) { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let middle_of = |t1: f64, t3: f64| up * (t1 + t3) / down;
    let last = |t1: f64| {
        let left = |t3: f64| {
            let t2 = middle_of(t1, t3);
            let fades = |t: f64| (-t / tau).exp();
            up * (1.0 - fades(t1)) * fades(t2 + t3) - down * (1.0 - fades(t2)) * fades(t3) + up * (1.0 - fades(t3))
        };
        bisect(0.0, 100.0 * tau + t1, &|t3| left(t3) < 0.0)
    };
    let reached = |t1: f64| {
        let t3 = last(t1);
        let t2 = middle_of(t1, t3);
        // The integral of (T - t) v, piece by piece.
        up * t1 * (0.5 * t1 + t2 + t3) - down * t2 * (0.5 * t2 + t3) + up * 0.5 * t3 * t3
    };
    let t1 = bisect(0.0, 100.0, &|t1| reached(t1) < height);
    let t3 = last(t1);
    t1 + middle_of(t1, t3) + t3
}

fn climb(model: PlanModel, tau: Option<f64>) -> Model {
    let points = [0.0, HEIGHT].map(|z| {
        let mut point = waypoint([0.0, 0.0, 2.0 + z], 0.0);
        point.within = WITHIN;
        point
    });
    let mut planned = planning(mission(points.to_vec()), model, MissionTime::Minimum);
    planned.plan.samples = 120;
    match tau {
        Some(tau) => lagging(planned, tau),
        None => planned,
    }
}

/// Accelerations up and down that the healthy octocopter can give level, m/s^2.
fn reach(model: &Model) -> (f64, f64) {
    let full: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum();
    (full / model.vehicle.mass - model.gravity, model.gravity)
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// In the exact model the thrust is twice differentiable and never falls below a tenth of the weight.
    #[test]
    #[ignore = "long"]
    fn the_exact_model_climbs_as_quickly_as_it_may() {
        let (up, down) = reach(&climb(PlanModel::Exact, None));
        let tau = 0.2;
        let mut model = climb(PlanModel::Exact, Some(tau));
        model.plan.samples = 40;
        let found = shortest(&model);
        let least = quickest(HEIGHT - 2.0 * WITHIN, up, down, tau);
        let most = 1.06 * quickest(HEIGHT, up, 0.9 * down, tau);
        assert!(found >= least && found <= most, "{found} s with {tau} s, between {least} and {most} s");
    }

    /// The tolerance at both ends shortens the way; the grid costs a little.
    #[test]
    #[ignore = "long"]
    fn the_quickest_climb_is_that_of_the_closed_form() {
        let (up, down) = reach(&climb(PlanModel::Hover, None));
        let mut last = shortest(&climb(PlanModel::Hover, None));
        let at_once = ((2.0 * HEIGHT) * (1.0 / up + 1.0 / down)).sqrt();
        assert!(last > 0.99 * at_once && last < 1.03 * at_once + 0.05, "{last} s, at once {at_once} s");
        for tau in [0.1, 0.2, 0.4] {
            let found = shortest(&climb(PlanModel::Hover, Some(tau)));
            let least = quickest(HEIGHT - 2.0 * WITHIN, up, down, tau);
            let most = 1.02 * quickest(HEIGHT, up, down, tau) + 0.05;
            assert!(found >= least && found <= most, "{found} s with {tau} s, between {least} and {most} s");
            assert!(found > last, "{found} s with {tau} s, {last} s with less");
            last = found;
        }
    }
}
