//! The checker's Taylor models in the wind, its bounds in every wind of an interval, and the planner's bounds, against
//! winds inside.

use super::Numbers;
use crate::vehicles::octocopter;
use mavc::actuation::Wrench;
use mavc::admissible::row::SetRow;
use mavc::certificate::DynamicModel;
use mavc::model::{Environment, Vehicle};
use mavc::motion::winds::OverWinds;
use mavc::motion::wrench_model::WrenchModel;
use mavc::verify::interval::Interval;
use mavc::verify::motion::State;
use mavc::verify::series::Scalar;
use mavc::verify::sets::Plane;
use mavc::verify::taylor::{PAIRS, Taylor};
use mavc::verify::wind;
use mavc::verify::wrench::{Dynamics, Held};

/// Time constant of the lag in these tests, s.
const LAG: f64 = 0.05;

/// A function of d, and a model that encloses it.
struct Known {
    model: Taylor,
    at: Box<dyn Fn([f64; 3]) -> f64>,
}

/// A polynomial of second order with a constant of about `constant`, whose coefficients are somewhere in intervals, and
/// a wave within the rest.
fn known(numbers: &mut Numbers, constant: f64) -> Known {
    let mut coefficient = |size: f64| {
        let value = size * numbers.unit();
        (value, Interval::new(value - 1e-3 * numbers.unit().abs(), value + 1e-3 * numbers.unit().abs()))
    };
    let c = coefficient(0.2);
    let linear: [_; 3] = std::array::from_fn(|_| coefficient(0.2));
    let quadratic: [_; 6] = std::array::from_fn(|_| coefficient(0.05));
    let rest = 0.01 * numbers.unit().abs();
    let shift = Interval::point(constant);
    let model = Taylor { constant: c.1 + shift, linear: linear.map(|l| l.1), quadratic: quadratic.map(|q| q.1), rest };
    let at = move |d: [f64; 3]| {
        let of_pairs: f64 = quadratic.iter().zip(PAIRS).map(|(q, (i, j))| q.0 * d[i] * d[j]).sum();
        let wave = rest * (7.0 * d[0] + 5.0 * d[1] - 3.0 * d[2]).sin();
        constant + c.0 + linear.iter().zip(d).map(|(l, d)| l.0 * d).sum::<f64>() + of_pairs + wave
    };
    Known { model, at: Box::new(at) }
}

/// A deviation of the wind; corners of the box as often as others.
fn deviation(numbers: &mut Numbers) -> [f64; 3] {
    let corner = numbers.below(2) == 0;
    std::array::from_fn(|_| if corner { numbers.unit().signum() } else { numbers.unit() })
}

#[test]
fn taylor_models_hold_the_functions_that_they_enclose() {
    let mut numbers = Numbers(31);
    for _ in 0..300 {
        let [a, b] = [0.5, -1.5].map(|constant| known(&mut numbers, constant));
        let c = known(&mut numbers, 2.0);
        let models = [
            a.model + b.model,
            a.model - b.model,
            a.model * b.model,
            a.model.scaled(Interval::point(-3.0)),
            a.model.divided(b.model.as_divisor()),
            c.model.sqrt(),
            (a.model * b.model - c.model).divided((c.model * c.model).sqrt().as_divisor()),
        ];
        for _ in 0..20 {
            let d = deviation(&mut numbers);
            let (x, y, z) = ((a.at)(d), (b.at)(d), (c.at)(d));
            let values = [x + y, x - y, x * y, -3.0 * x, x / y, z.sqrt(), (x * y - z) / z];
            for (which, (model, value)) in models.iter().zip(values).enumerate() {
                assert!(model.at(d).contains(value), "{which}: {value} {:?}", model.at(d));
                assert!(model.range().contains(value) && value <= model.upper().high, "{which}: {value}");
            }
        }
        // What is not defined everywhere in the box is not bounded.
        let through_zero = known(&mut numbers, 0.0).model;
        let near = through_zero - Taylor::of(through_zero.constant);
        assert_eq!((near.as_divisor().range(), near.sqrt().range()), (Interval::WHOLE, Interval::WHOLE));
    }
}

/// The terms of third order of 1/(1 + x) and sqrt(1 + x) are -x^3 and x^3/16.
#[test]
fn rests_are_of_third_order() {
    for size in [1e-1, 1e-2, 1e-3] {
        let x = Taylor::of(Interval::ONE) + Taylor::deviation(0, Interval::point(size));
        for (model, factor) in [(x.as_divisor(), 1.0), (x.sqrt(), 1.0 / 16.0)] {
            let third = factor * size * size * size;
            assert!(third < model.rest && model.rest < third * (1.0 + 6.0 * size), "{size} {}", model.rest);
        }
    }
}

/// Derivatives of x, y, z and yaw as of a brisk mission.
fn lively(numbers: &mut Numbers) -> [[f64; 6]; 4] {
    let sizes = [[1.0, 8.0, 3.0, 5.0, 10.0, 40.0], [1.0, 0.5, 0.5, 1.0, 0.0, 0.0]];
    std::array::from_fn(|axis| std::array::from_fn(|order| numbers.unit() * sizes[axis / 3][order]))
}

fn environment(numbers: &mut Numbers, largest: f64) -> Environment {
    let wind_spread = std::array::from_fn(|_| largest * numbers.unit().abs());
    Environment { gravity: 9.81, drag_rates: [0.194; 3], wind: [5.0, -2.0, 0.3], wind_spread, yaw_at_rest: 0.0 }
}

fn dynamics(vehicle: &Vehicle, environment: Environment) -> Dynamics<'_> {
    Dynamics { vehicle, environment, model: DynamicModel::Exact, one_yaw: None }
}

/// The environment with the wind at d.
fn blowing(environment: &Environment, d: [f64; 3]) -> Environment {
    let wind = std::array::from_fn(|i| environment.wind[i] + environment.wind_spread[i] * d[i]);
    Environment { wind, wind_spread: [0.0; 3], ..*environment }
}

const HELD: [Held; 2] = [Held::Wrench, Held::Commands { tau: Interval { low: LAG, high: LAG } }];

#[test]
fn wrenches_by_wind_hold_those_in_each_wind() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(32);
    // How much wider than the values seen are the enclosures by Taylor models and by plain intervals.
    let (mut by_models, mut by_intervals) = (0.0, 0.0);
    for round in 0..60 {
        let environment = environment(&mut numbers, 2.0);
        // Over a time interval the derivatives are anywhere in theirs.
        let wide = if round % 2 == 0 { 0.0 } else { 1e-3 };
        let path = lively(&mut numbers);
        let state: State = path.map(|axis| axis.map(|x| Interval::new(x - wide, x + wide)));
        let whole = dynamics(&vehicle, environment);
        for held in HELD {
            let model = whole.held_by_wind(held, &state);
            let mut seen = [(f64::INFINITY, f64::NEG_INFINITY); 4];
            for _ in 0..40 {
                let d = deviation(&mut numbers);
                let inside: State = path.map(|axis| axis.map(|x| Interval::point(x + 0.99 * wide * numbers.unit())));
                let found = dynamics(&vehicle, blowing(&environment, d)).held(held, &inside);
                for (i, seen) in seen.iter_mut().enumerate() {
                    let (value, rate) = (found.value[i].middle(), found.rate[i].middle());
                    assert!(model.value[i].at(d).contains(value), "{i}: {value} {:?}", model.value[i].at(d));
                    assert!(model.rate[i].range().contains(rate), "{i}: {rate} {:?}", model.rate[i].range());
                    *seen = (seen.0.min(value), seen.1.max(value));
                }
            }
            if wide == 0.0 && held == Held::Wrench {
                let plain = whole.held(held, &state);
                for (i, seen) in seen.iter().enumerate().skip(1) {
                    let (range, between) = (model.value[i].range(), seen.1 - seen.0);
                    by_models += (range.high - range.low - between) / vehicle.inertia[i - 1];
                    by_intervals += (plain.value[i].high - plain.value[i].low - between) / vehicle.inertia[i - 1];
                }
            }
        }
    }
    assert!(10.0 * by_models < by_intervals, "{by_models} {by_intervals}");
}

/// A facet of about one healthy width for this vehicle.
fn normal(numbers: &mut Numbers) -> [f64; 4] {
    [0.03, 0.4, 0.4, 1.2].map(|size| size * numbers.unit())
}

/// The checker's bound is above every wind inside, the planner's above the checker's, and neither by much.
#[test]
fn bounds_in_every_wind_are_above_each_and_the_planners_above_the_checkers() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(33);
    let (mut variation, mut above, mut kept) = (0.0, 0.0, 0.0);
    for round in 0..120 {
        let environment = environment(&mut numbers, if round % 4 == 0 { 8.0 } else { 2.0 });
        let path = lively(&mut numbers);
        let state: State = path.map(|axis| axis.map(Interval::point));
        let node = path.map(|axis| std::array::from_fn(|i| axis[i]));
        let boxes = wind::boxes(&dynamics(&vehicle, environment));
        for held in HELD {
            let planners = match held {
                Held::Wrench => OverWinds::of_wrench(WrenchModel::Exact, &vehicle, &environment, &node),
                Held::Commands { .. } => OverWinds::of_commands(WrenchModel::Exact, &vehicle, &environment, LAG, &path),
            };
            let n = normal(&mut numbers);
            let (offset, room) = (Interval::ZERO, Interval::WHOLE);
            let plane = Plane { normal: n.map(Interval::point), offset, room, rotors: Vec::new(), is_facet: true };
            let row = SetRow { normal: Wrench::from(n), offset: 0.0, equality: false, origin: Vec::new(), core: None };
            let proved = wind::violations(&boxes, held, &state, &[&plane])[0].value.high;
            let planned = planners.worst(&row);
            let at =
                |d| plane.violation(&dynamics(&vehicle, blowing(&environment, d)).held(held, &state).value).middle();
            let seen = (0..60).map(|_| at(deviation(&mut numbers))).fold(f64::NEG_INFINITY, f64::max);
            assert!(seen <= proved, "{seen} {proved}");
            assert!(proved <= planned + 1e-9, "{proved} {planned} {environment:?} {path:?}");
            assert!((planned - planners.more_in_winds(&row) - at([0.0; 3])).abs() < 1e-9);
            if round % 4 != 0 {
                variation += seen - at([0.0; 3]);
                above += proved - seen;
                kept += planned - seen;
            }
        }
    }
    assert!(above < 0.15 * variation && kept < 0.5 * variation, "{variation} {above} {kept}");
}

/// Boxes together cover the interval, and each is small.
#[test]
fn boxes_cover_the_interval() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(34);
    for round in 0..40 {
        let environment = environment(&mut numbers, [0.5, 3.0, 12.0][round % 3]);
        let boxes = wind::boxes(&dynamics(&vehicle, environment));
        assert!(boxes.len() <= 64 && (round % 3 > 0 || boxes.len() == 1), "{}", boxes.len());
        for part in &boxes {
            let change = part.environment.turning_rate() * part.environment.wind_spread.iter().sum::<f64>();
            assert!(change < 0.1 * 9.81 * (1.0 + 1e-6) || boxes.len() == 64, "{change}");
        }
        for _ in 0..50 {
            let wind = blowing(&environment, deviation(&mut numbers)).wind;
            // The wind itself is rounded.
            let beside = |part: &Environment, i: usize| (wind[i] - part.wind[i]).abs() - part.wind_spread[i];
            let holds = |part: &Environment| (0..3).all(|i| beside(part, i) <= 1e-14);
            assert!(boxes.iter().any(|part| holds(&part.environment)), "{wind:?}");
        }
    }
}
