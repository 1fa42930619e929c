//! The inputs of a simulated flight.

use super::reference::{Course, DESCENT};
use super::way_out::WaysOut;
use super::{LANDING_MARGIN, capture};
use crate::model::{AfterFault, GiveUpYaw, Mission, Model, Simulation, Strike, Vehicle};
use crate::motion::{NodeState, Trajectory, X, Y, Z};
use std::borrow::Cow;

/// The inputs of one simulated flight.
#[derive(Debug, Clone)]
pub struct Sortie<'a> {
    /// The vehicle and its fault modes, as the controller knows them.
    pub model: &'a Model,
    /// The vehicle that flies: that of the model, or another one of the spec's intervals.
    pub vehicle: Cow<'a, Vehicle>,
    /// Rates, gains, sensors, detection, reaction to faults, and the limits beyond which the vehicle counts as lost.
    pub simulation: &'a Simulation,
    /// The course that is followed until a fault is known.
    pub course: Course<'a>,
    /// The mission whose waypoints and limits the path is judged by, if the course is its plan.
    pub mission: Option<&'a Mission>,
    /// The faults, in the order of their times.
    pub strikes: &'a [Strike],
    /// Seed of gusts and sensor noise.
    pub seed: u64,
    /// Duration of the flight without a stop, s.
    pub duration: f64,
    /// The vehicle's mean speed, m/s, which is added to the speed of the mean wind to give the V of the gust model
    /// ([`super::air`]).
    pub airspeed: f64,
    /// Whether a flight with yaw given up goes on after its duration until the spin has settled, for at most five time
    /// constants Jz/`yaw_drag`.
    pub goes_on: bool,
    /// For [`AfterFault::Recovery`]: how a way out is found.
    pub ways_out: Option<WaysOut<'a>>,
}

impl<'a> Sortie<'a> {
    /// A flight along a plan, with the duration that the spec configures or else that of the plan. A plan that does not
    /// end at rest limits the duration to its own, because there is no reference after its end. The airspeed is the
    /// plan's mean speed.
    pub fn along(model: &'a Model, trajectory: &'a Trajectory, strikes: &'a [Strike], seed: u64) -> Self {
        let place = |s: &NodeState| nalgebra::Vector3::new(s[X][0], s[Y][0], s[Z][0]);
        let legs = trajectory.nodes.windows(2).map(|pair| (place(&pair[1]) - place(&pair[0])).norm());
        let longest = if trajectory.ends_at_rest() { f64::INFINITY } else { trajectory.duration() };
        Sortie {
            model,
            vehicle: Cow::Borrowed(&model.vehicle),
            simulation: &model.simulation,
            course: Course::Plan(trajectory),
            mission: model.mission.as_ref(),
            strikes,
            seed,
            duration: model.simulation.duration.unwrap_or(trajectory.duration()).min(longest),
            airspeed: legs.sum::<f64>() / trajectory.duration(),
            goes_on: model.simulation.duration.is_none() && trajectory.ends_at_rest(),
            ways_out: None,
        }
    }
}

/// An upper bound (s) on the duration of a flight along a plan of `time` s, including a landing but not the duration of
/// a stop. With `yaw_drag` a flight without yaw may take until its spin has settled.
pub fn longest(model: &Model, time: f64) -> f64 {
    let simulation = &model.simulation;
    let settles = match simulation.faults.iter().any(|strike| model.gives_up_yaw(strike.mode) != GiveUpYaw::Never) {
        true => capture::settled::settling_time(&model.vehicle).unwrap_or(0.0),
        false => 0.0,
    };
    let flown = simulation.duration.unwrap_or(time + settles);
    let heights = model.mission.iter().flat_map(|m| m.waypoints.iter().map(|w| w.position[2] - simulation.ground));
    match simulation.after_fault {
        AfterFault::Land => flown + heights.fold(0.0, f64::max) / DESCENT + LANDING_MARGIN,
        AfterFault::Recovery => flown + model.plan.recovery.within + LANDING_MARGIN,
        AfterFault::Continue | AfterFault::Hold => flown,
    }
}
