//! The flight simulator, each part against something that shares no code with it.

mod air;
mod allocation;
mod body;
mod control;
mod damage;
mod disturbed;
mod estimation;
mod faults;
mod headings;
mod landings;
mod motion;
mod plans;
mod reference;
mod settled;
mod sorties;
mod volumes;
mod without_yaw;

use mavc::flight::body::Body;
use mavc::flight::reference::Course;
use mavc::flight::{Flight, Sample, Sortie, fly};
use mavc::model::{Detection, Model, Strike};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::source::Span;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// A plan that stays at a place.
fn staying(place: [f64; 3], yaw: f64, duration: f64) -> Trajectory {
    let mut node = NodeState::default();
    for (axis, value) in [(X, place[0]), (Y, place[1]), (Z, place[2]), (YAW, yaw)] {
        node[axis][0] = value;
    }
    Trajectory {
        times: vec![0.0, duration],
        nodes: vec![node, node],
        waypoint_nodes: vec![0, 1],
        model: WrenchModel::HoverFollowing,
    }
}

/// Without noise, and with a controller that never learns of faults.
fn quiet(mut model: Model) -> Model {
    model.simulation.gyroscope_noise = 0.0;
    model.simulation.position_noise = 0.0;
    model.simulation.detection = Detection::Never;
    model
}

fn strike(mode: usize, at: f64) -> Strike {
    Strike { mode, at, until: None, span: Span::default(), at_span: Span::default() }
}

fn sortie<'a>(model: &'a Model, along: &'a Trajectory, strikes: &'a [Strike]) -> Sortie<'a> {
    Sortie {
        model,
        vehicle: std::borrow::Cow::Borrowed(&model.vehicle),
        simulation: &model.simulation,
        course: Course::Plan(along),
        mission: None,
        strikes,
        seed: 7,
        duration: along.duration(),
        airspeed: 0.0,
        goes_on: false,
        ways_out: None,
    }
}

/// Flies, and keeps what `look` sees of every sample.
fn seen<T>(sortie: &Sortie, mut look: impl FnMut(&Sample) -> T) -> (Flight, Vec<T>) {
    let mut all = Vec::new();
    let flight = fly(sortie, Some(&mut |sample| all.push(look(sample))));
    (flight, all)
}

/// A body that moves and turns about all axes.
fn moving() -> Body {
    Body {
        position: Vector3::new(0.5, -1.0, 2.0),
        velocity: Vector3::new(1.0, 2.0, -0.5),
        attitude: turned(0.3, -0.2, 0.7),
        rates: Vector3::new(1.2, -0.8, 2.1),
    }
}

/// Rz Ry Rx of (4) as a product of three half turns' quaternions.
fn turned(roll: f64, pitch: f64, yaw: f64) -> Quaternion<f64> {
    let about = |axis: [f64; 3], angle: f64| {
        let (s, c) = (0.5 * angle).sin_cos();
        Quaternion::new(c, s * axis[0], s * axis[1], s * axis[2])
    };
    about([0.0, 0.0, 1.0], yaw) * about([0.0, 1.0, 0.0], pitch) * about([1.0, 0.0, 0.0], roll)
}

/// Angle between two attitudes, rad.
fn angle_between(a: &Body, b: &Body) -> f64 {
    let turn: UnitQuaternion<f64> = a.rotation().rotation_to(&b.rotation());
    2.0 * turn.imag().norm().atan2(turn.w.abs())
}

fn normal(random: &mut Pcg64Mcg) -> f64 {
    StandardNormal.sample(random)
}

/// Evenly from `low` to `high`.
fn between(random: &mut Pcg64Mcg, low: f64, high: f64) -> f64 {
    rand_distr::Uniform::new(low, high).unwrap().sample(random)
}
