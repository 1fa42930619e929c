//! The specs, in code: vehicles, planners, models, holds, fixed and free times, lag, intervals, flat sets, limits.

use super::Draft;
use crate::vehicles::{hexacopter, lost, mission, octocopter, quadcopter, waypoint};
use mavc::body::Body;
use mavc::model::{
    Allocation, LimitKind, Mission, MissionTime, Model, PlanModel, PlanRotors, PlannerKind, RotorSpread, RotorState,
    Spread,
};
use mavc::model::{Volume, VolumeSide};
use mavc::source::Span;

/// There and back over a hold, one yaw.
fn hop() -> Mission {
    let mut flight =
        mission(vec![waypoint([0.0, 0.0, 2.0], 0.3), waypoint([3.0, 1.0, 3.0], 0.3), waypoint([5.0, 0.0, 2.5], 0.3)]);
    flight.waypoints[1].hold = 0.5;
    flight
}

fn line() -> Mission {
    mission(vec![waypoint([0.0, 0.0, 2.0], 0.3), waypoint([4.0, 1.0, 2.5], 0.3)])
}

/// Along x alone, where a hexacopter with a flat set can go.
fn beam() -> Mission {
    mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([4.0, 0.0, 2.5], 0.0)])
}

pub fn shuttle() -> Mission {
    mission(vec![
        waypoint([0.0, 0.0, 2.0], 0.3),
        waypoint([4.0, 1.0, 4.0], 0.3),
        waypoint([7.0, -2.0, 3.0], 0.3),
        waypoint([3.0, 0.0, 2.0], 0.3),
    ])
}

fn turning() -> Mission {
    let mut flight = shuttle();
    flight.waypoints.iter_mut().zip([0.0, 0.7, 1.3, 0.4]).for_each(|(w, yaw)| w.yaw = yaw);
    flight
}

pub fn elevator(height: f64) -> Mission {
    mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([0.0, 0.0, 2.0 + height], 0.0)])
}

fn moving(mut flight: Mission) -> Mission {
    (flight.start_at_rest, flight.end_at_rest) = (false, false);
    flight
}

/// A vehicle with single losses as modes, planned for by `planner`.
pub fn plan(mut vehicle: Model, flight: Mission, planner: PlannerKind, samples: usize) -> Model {
    let rotors = vehicle.vehicle.rotors.len();
    vehicle.modes = (1..=rotors).map(|k| lost(&vehicle, &[k])).collect();
    vehicle.mission = Some(flight);
    vehicle.plan.planner = planner;
    vehicle.plan.samples = samples;
    if planner != PlannerKind::Rip {
        vehicle.plan.against = vec![0];
    }
    vehicle
}

pub fn octo(flight: Mission, planner: PlannerKind, samples: usize) -> Model {
    plan(octocopter("PPNNPPNN"), flight, planner, samples)
}

fn lagging(mut model: Model, time_constant: f64) -> Model {
    model.plan.rotors = PlanRotors::Lagging;
    model.vehicle.rotors.iter_mut().for_each(|r| r.time_constant = Some(time_constant));
    model
}

pub fn uncertain(mut model: Model) -> Model {
    let about = |share: f64| Spread { low: 1.0 - share, high: 1.0 + share };
    model.vehicle.mass_spread = about(0.04);
    let spread = RotorSpread { full_thrust: about(0.08), idle_thrust: about(0.05), torque_per_thrust: about(0.02) };
    model.vehicle.rotors.iter_mut().for_each(|r| r.spread = spread);
    model
}

pub fn exact(mut model: Model) -> Model {
    model.plan.model = PlanModel::Exact;
    model
}

pub fn with(mut model: Model, change: impl Fn(&mut Model)) -> Model {
    change(&mut model);
    model
}

/// A mode in which every rotor gives two fifths of its thrust.
pub fn weakened(mut model: Model) -> Model {
    let mut weak = lost(&model, &[]);
    weak.name = "weak".into();
    weak.rotors.fill(RotorState::Reduced(0.4));
    model.modes.push(weak);
    model.plan.against = vec![model.modes.len() - 1];
    model
}

/// Without two opposite rotors roll and yaw torques are tied to each other, up to the rounding of the rotors' places.
fn flat() -> Model {
    with(plan(hexacopter("PNPNPN"), beam(), PlannerKind::Rcp, 24), |m| {
        m.modes = vec![lost(m, &[1, 4])];
        m.plan.reserve = 0.1;
    })
}

/// A flat set of the pseudo-inverse, which the checker does not work out: not among the specs for forgeries.
pub fn flat_inverse() -> Draft {
    let model = with(flat(), |m| {
        m.vehicle.allocation = Allocation::PseudoInverse;
        m.plan.time = MissionTime::Fixed(6.0);
    });
    Draft::new("RCP flat pseudo-inverse", 6.0, model, &[])
}

/// The `index`-th volume of a mission; its clearance is set from the honest plan.
fn volume(index: u32, side: VolumeSide, body: Body) -> Volume {
    let span = Span { start: index, end: index + 1, ..Span::default() };
    Volume { name: format!("v{index}"), side, bodies: vec![body], clearance: 0.0, span }
}

/// The line past one volume of each shape.
fn among_volumes() -> Vec<Volume> {
    let corners = vec![[1.0, -2.0], [3.0, -2.2], [3.0, -0.6]];
    [
        Body::Prism { corners, bottom: 0.0, top: 5.0 },
        Body::Cylinder { centre: [2.0, 2.0], radius: 0.5, bottom: -1.0, top: 5.0 },
        Body::Ball { centre: [2.0, 0.5, 4.0], radius: 0.8 },
        Body::HalfSpace { normal: [0.0, 0.0, 1.0], offset: 1.0 },
    ]
    .into_iter()
    .zip(1..)
    .map(|(body, index)| volume(index, VolumeSide::KeepOut, body))
    .collect()
}

/// The line within one volume of each shape.
fn in_volumes() -> Vec<Volume> {
    let corners = vec![[2.0, -3.5], [6.0, 0.5], [2.0, 4.5], [-2.0, 0.5]];
    [
        Body::Prism { corners, bottom: 0.0, top: 5.0 },
        Body::Cylinder { centre: [2.0, 0.5], radius: 3.2, bottom: -1.0, top: 5.0 },
        Body::Ball { centre: [2.0, 0.5, 2.25], radius: 3.3 },
        Body::HalfSpace { normal: [0.8, 0.6, 0.0], offset: 4.6 },
    ]
    .into_iter()
    .zip(1..)
    .map(|(body, index)| volume(index, VolumeSide::KeepIn, body))
    .collect()
}

/// Strong drag in a strong wind, which is one of an interval.
fn in_air(mut model: Model, spread: [f64; 3]) -> Model {
    model.vehicle.drag = [0.6; 3];
    let air = &mut model.mission.as_mut().expect("a mission").air;
    (air.wind, air.wind_spread) = ([-7.0, 3.0, 0.5], spread);
    exact(model)
}

/// A spec in text, for what the compiler derives: the limits of legs, and a yaw that follows from the motion.
fn written(waypoints: &str, plan: &str) -> Model {
    compiled(&format!("{OCTO}; mission legs {{ {waypoints} }}; plan {{ planner = rip; {plan} }}"))
}

/// The octocopter of [`octo`] in text.
pub const OCTO: &str = "
    vehicle octo {
        layout = \"PPNNPPNN\"
        arm = 0.211 m
        mass = 1.8 kg
        inertia = [0.0429, 0.0429, 0.0748] kg*m^2
        rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
    }";

/// # Panics
/// The text is not a spec: a mistake in the list.
pub fn compiled(text: &str) -> Model {
    let spec = mavc::Compiler::new().text("forge.mav", text.as_bytes()).into_result();
    let spec = spec.unwrap_or_else(|why| panic!("{text}\n{why}"));
    spec.model().clone()
}

/// Legs of every shape, with stops between them: a motion from rest to rest stays on its line.
const LEGS: &str = "
    start at [0, 0, 2] m
    waypoint at [0, 0, 5] m  vertical  stop
    waypoint at [4, 1, 5] m  straight  stop { speed <= 2.6 m/s }
    waypoint at [6, -1, 4] m  corridor 40 cm  stop
    waypoint at [3, 0, 4] m { climb <= 0.3 m/s }";

/// Fewer, for the exact model.
const TWO_LEGS: &str = "
    start at [0, 0, 2] m
    waypoint at [3, 1, 4] m  straight  stop { speed <= 2.3 m/s }
    waypoint at [6, -1, 3] m  corridor 40 cm";

/// Through the second waypoint the motion flies along the line of all three.
const ARRIVAL: &str = "
    start at [0, 0, 2] m
    waypoint at [3, 1.5, 2] m  arrive from [-2, -1, 0]
    waypoint at [6, 3, 2] m";

/// Towards a point so far away that the yaw changes almost as the position.
const TOWARDS: &str = "
    start at [0, 0, 2] m  yaw towards [2, 40, 0] m
    waypoint at [4, 1, 2.5] m";

/// Every draft.
pub fn drafts() -> Vec<Draft> {
    use LimitKind::{
        Acceleration, AccelerationHorizontal, Climb, Descent, Jerk, Speed, SpeedHorizontal, Tilt, X, Y, Yaw,
        YawAcceleration, YawRate, Z,
    };
    use PlannerKind::{Rcp, Rip, Rsp};
    let every = [
        (X, 1.2),
        (Y, 1.2),
        (Z, 1.2),
        (Yaw, 1.1),
        (YawRate, 1.1),
        (YawAcceleration, 1.1),
        (Climb, 1.1),
        (Descent, 1.1),
        (Speed, 1.1),
        (SpeedHorizontal, 1.1),
        (Acceleration, 1.1),
        (AccelerationHorizontal, 1.1),
        (Jerk, 1.1),
        (Tilt, 1.1),
    ];
    let mut list: Vec<Draft> = Vec::new();
    let mut add = |name, total: f64, model: Model, limits: &[(LimitKind, f64)]| {
        let model = with(model, |m| {
            if m.plan.time == MissionTime::Fixed(0.0) {
                m.plan.time = MissionTime::Fixed(total);
            }
        });
        list.push(Draft::new(name, total, model, limits));
    };
    // The total is filled in.
    let fixed = |model: Model| with(model, |m| m.plan.time = MissionTime::Fixed(0.0));
    add("line", 6.0, fixed(octo(line(), Rip, 24)), &[(Speed, 1.02), (Tilt, 1.5)]);
    add("hop with a hold", 8.0, fixed(octo(hop(), Rip, 30)), &[(Speed, 1.02), (Climb, 1.05), (Z, 1.3)]);
    add("shuttle, free total", 10.0, octo(shuttle(), Rip, 36), &[(AccelerationHorizontal, 1.1)]);
    add("in a box", 10.0, fixed(octo(turning(), Rip, 40)), &[(X, 1.01), (Y, 1.01), (Z, 1.01), (Yaw, 1.01)]);
    add("turning", 10.0, fixed(octo(turning(), Rip, 36)), &[(YawRate, 1.1), (YawAcceleration, 1.2)]);
    add("moving ends", 8.0, fixed(octo(moving(shuttle()), Rip, 24)), &[(Speed, 1.3), (Jerk, 1.5)]);
    let timed = with(octo(hop(), Rip, 30), |m| {
        let flight = m.mission.as_mut().expect("a mission");
        flight.waypoints[1].time = Some(3.2);
    });
    add("fixed waypoint", 8.0, fixed(timed), &[(SpeedHorizontal, 1.2)]);
    add(
        "free waypoint times",
        10.0,
        with(octo(shuttle(), Rip, 36), |m| m.plan.chooses_times = true),
        &[(Descent, 1.3)],
    );
    add("reserve", 6.0, fixed(with(octo(line(), Rip, 24), |m| m.plan.reserve = 0.2)), &[]);
    add("quadcopter", 6.0, fixed(plan(quadcopter(), line(), Rip, 24)), &[(Acceleration, 1.1)]);
    add("every limit", 10.0, fixed(octo(turning(), Rip, 40)), &every);
    add("RCP line", 6.0, fixed(octo(line(), Rcp, 24)), &[(Speed, 1.02)]);
    let two = with(octo(hop(), Rcp, 30), |m| m.plan.against = vec![0, 4]);
    add("RCP hop against two", 8.0, fixed(with(two, |m| m.plan.reserve = 0.05)), &[(Speed, 1.3), (Tilt, 1.5)]);
    add("RCP turning", 12.0, octo(turning(), Rcp, 36), &[]);
    let inverse = with(octo(line(), Rcp, 24), |m| m.vehicle.allocation = Allocation::PseudoInverse);
    add("RCP pseudo-inverse", 7.0, fixed(inverse), &[]);
    add("RCP intervals", 7.0, fixed(uncertain(octo(line(), Rcp, 24))), &[]);
    let idle = with(octo(line(), Rcp, 24), |m| m.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 150.0));
    add("RCP idling rotors", 7.0, fixed(idle), &[]);
    add("RCP lag", 10.0, fixed(lagging(octo(shuttle(), Rcp, 36), 0.15)), &[]);
    add("RCP flat set", 6.0, fixed(flat()), &[(Speed, 1.02)]);
    add("lag", 6.0, fixed(lagging(octo(line(), Rip, 24), 0.2)), &[(Tilt, 1.3)]);
    add("intervals", 8.0, fixed(uncertain(octo(hop(), Rip, 30))), &[]);
    add("RSP line", 6.0, fixed(octo(line(), Rsp, 24)), &[]);
    let two = with(octo(hop(), Rsp, 36), |m| m.plan.against = vec![0, 4]);
    add("RSP hop against two", 8.0, fixed(two), &[(Speed, 1.5)]);
    add("RSP two rounds", 10.0, with(octo(shuttle(), Rsp, 36), |m| m.plan.rounds = 2), &[]);
    add("exact line", 6.0, fixed(exact(octo(line(), Rip, 24))), &[(Speed, 1.02), (Tilt, 1.2)]);
    add(
        "exact turning with a hold",
        11.0,
        fixed(exact(with(octo(turning(), Rip, 40), |m| {
            m.mission.as_mut().expect("a mission").waypoints[2].hold = 0.8;
        }))),
        &[(YawRate, 1.2), (Jerk, 1.3)],
    );
    add("exact RCP line", 7.0, fixed(exact(octo(line(), Rcp, 24))), &[]);
    add("exact RSP line", 7.0, fixed(exact(octo(line(), Rsp, 24))), &[]);
    add("exact elevator", 5.0, fixed(exact(octo(elevator(4.0), Rip, 24))), &[]);
    add("exact lag", 7.0, fixed(lagging(exact(octo(line(), Rip, 24)), 0.2)), &[]);
    add("exact moving ends", 7.0, fixed(exact(octo(moving(line()), Rip, 20))), &[(Speed, 1.3)]);
    add("weak mode unguarded", 2.4, fixed(weakened(octo(elevator(5.0), Rip, 24))), &[(Climb, 1.1)]);
    add("weak mode unguarded, exact", 2.4, fixed(weakened(exact(octo(elevator(5.0), Rip, 24)))), &[(Climb, 1.1)]);
    let between = |model: Model, volumes: fn() -> Vec<Volume>| {
        with(model, |m| m.mission.as_mut().expect("a mission").volumes = volumes())
    };
    add("exact among volumes", 6.0, fixed(exact(between(octo(line(), Rip, 24), among_volumes))), &[]);
    add("in volumes", 6.0, fixed(between(octo(line(), Rip, 24), in_volumes)), &[(Speed, 1.02)]);
    add("exact RCP in volumes", 7.0, fixed(exact(between(octo(line(), Rcp, 24), in_volumes))), &[]);
    add("legs", 14.0, fixed(written(LEGS, "model = hover; samples = 56")), &[]);
    add("exact legs", 8.0, fixed(written(TWO_LEGS, "samples = 24")), &[]);
    add("arrival", 7.0, fixed(written(ARRIVAL, "model = hover; samples = 28")), &[]);
    add("exact yaw towards a point", 7.0, fixed(written(TOWARDS, "samples = 28")), &[]);
    add("in air", 7.0, fixed(in_air(octo(line(), Rip, 24), [0.0; 3])), &[(Tilt, 1.05)]);
    add("RCP in winds", 9.0, fixed(in_air(octo(line(), Rcp, 24), [1.5, 1.5, 0.5])), &[(Tilt, 1.2)]);
    add("lag in winds", 9.0, fixed(lagging(in_air(octo(line(), Rip, 24), [1.5, 0.0, 0.0]), 0.1)), &[]);
    let harder = [
        "line",
        "hop with a hold",
        "fixed waypoint",
        "RCP line",
        "RCP hop against two",
        "lag",
        "intervals",
        "RCP pseudo-inverse",
        "exact line",
        "exact elevator",
        "weak mode unguarded",
        "weak mode unguarded, exact",
    ];
    list.iter_mut().for_each(|draft| draft.harder = harder.contains(&draft.name));
    list
}
