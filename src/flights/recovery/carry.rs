//! What a fault does to the vehicle until it is known: a simulated flight along the plan without noise and gusts.

use crate::flight::body::Body;
use crate::flight::reference::Course;
use crate::flight::{Sample, Sortie, fly};
use crate::model::{Attitude, Detection, Environment, FlownVehicle, Model, Simulation, Strike};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use crate::source::Span;
use crate::tolerance::UPRIGHT;
use nalgebra::{Matrix3, Vector3};
use std::borrow::Cow;
use std::f64::consts::TAU;

/// The vehicle when its fault becomes known.
#[derive(Debug, Clone)]
pub struct Carried {
    /// Derivatives of the position and the yaw, which a branch continues.
    pub state: NodeState,
    /// Where it was since the fault, m, at every act of the controller.
    pub path: Vec<[f64; 3]>,
    /// Its largest distance from the plan since the fault, m.
    pub deviation: f64,
}

/// The flight settings by which faults are carried: those of the spec without noise, gusts and knowledge of the fault.
pub fn quiet(model: &Model) -> Simulation {
    Simulation {
        duration: None,
        detection: Detection::Never,
        gyroscope_noise: 0.0,
        assumed_gyroscope_noise: None,
        attitude: Attitude::Exact,
        position_noise: 0.0,
        gusts: 0.0,
        torque_gusts: 0.0,
        spread: FlownVehicle::Middle,
        centre_offset: 0.0,
        faults: Vec::new(),
        lost_beyond: f64::INFINITY,
        ..model.simulation.clone()
    }
}

/// The vehicle `delay` s after a fault of a mode strikes at `at` s of a plan, while the controller of `simulation`
/// follows the plan and allocates as if there were no fault. `None` if it turns over.
pub fn carry(
    model: &Model,
    simulation: &Simulation,
    plan: &Trajectory,
    mode: usize,
    at: f64,
    delay: f64,
) -> Option<Carried> {
    let part = plan.part(at, delay + 2.0 / simulation.control_rate);
    let span = Span::default();
    let strikes = [Strike { mode, at: 0.0, until: None, at_span: span, span }];
    let sortie = Sortie {
        model,
        vehicle: Cow::Borrowed(&model.vehicle),
        simulation,
        course: Course::Plan(&part),
        mission: None,
        strikes: &strikes,
        seed: 1,
        duration: delay,
        airspeed: 0.0,
        goes_on: false,
        ways_out: None,
    };
    let (mut path, mut deviation, mut last) = (Vec::new(), 0.0, None);
    let mut record = |sample: &Sample| {
        path.push(sample.body.position.into());
        deviation = f64::max(deviation, (sample.body.position - sample.reference.position).norm());
        last = Some(*sample.body);
    };
    fly(&sortie, Some(&mut record));
    let planned = plan.at(at + delay);
    let state = flat_state(&last?, &planned, plan.model, &model.environment())?;
    Some(Carried { state, path, deviation })
}

/// The derivatives of position and yaw of a body with a thrust like that of `planned`: the inverse of the flat
/// output's map. Order 2 and 3 hold what attitude and body rates are, order 4 is zero. `None` if the body is tilted too
/// far for its model.
fn flat_state(body: &Body, planned: &NodeState, model: WrenchModel, environment: &Environment) -> Option<NodeState> {
    let rotation: Matrix3<f64> = *body.rotation().to_rotation_matrix().matrix();
    let [roll, pitch, heading] = body.angles();
    let [p, q, r] = body.rates.into();
    let yaw = planned[YAW][0] + (heading - planned[YAW][0] + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
    let mut state = NodeState::default();
    for (axis, (position, velocity)) in body.position.iter().zip(&body.velocity).enumerate() {
        (state[axis][0], state[axis][1]) = (*position, *velocity);
    }
    state[YAW][0] = yaw;
    if let WrenchModel::HoverAt(_) | WrenchModel::HoverFollowing = model {
        // (19) of the paper and its derivative, as in the controller about hover.
        let (s, c) = match model {
            WrenchModel::HoverAt(psi) => psi.sin_cos(),
            _ => yaw.sin_cos(),
        };
        let g = environment.gravity;
        (state[X][2], state[Y][2]) = (g * (c * pitch + s * roll), g * (s * pitch - c * roll));
        (state[X][3], state[Y][3]) = (g * (c * q + s * p), g * (s * q - c * p));
        (state[Z][2], state[YAW][1]) = (planned[Z][2], r);
        return Some(state);
    }
    let up: Vector3<f64> = rotation.column(2).into();
    if up.z <= UPRIGHT {
        return None;
    }
    // c b_3 = p'' + g e_z + K u with K = R diag(k) R^T and u the velocity through the air; the branch chooses c.
    let rates = Matrix3::from_diagonal(&Vector3::from(environment.drag_rates));
    let spin = body.rates.cross_matrix();
    let k = rotation * rates * rotation.transpose();
    let turning = rotation * (spin * rates - rates * spin) * rotation.transpose();
    let air = body.velocity - Vector3::from(environment.wind);
    let wanted = Vector3::new(planned[X][2], planned[Y][2], planned[Z][2] + environment.gravity) + k * air;
    let thrust = wanted.norm();
    let acceleration = up * thrust - Vector3::z() * environment.gravity - k * air;
    let jerk = rotation * body.rates.cross(&Vector3::z()) * thrust - k * acceleration - turning * air;
    for axis in [X, Y, Z] {
        (state[axis][2], state[axis][3]) = (acceleration[axis], jerk[axis]);
    }
    // The rate of the ZYX angle psi (4).
    state[YAW][1] = (q * roll.sin() + r * roll.cos()) / pitch.cos();
    Some(state)
}
