//! Specs that some kinds of forgery are about: reserves about nothing, rotors that reverse, yaws that follow from the
//! motion, tolerances of their own, sides that differ, capture heights.

use super::Draft;
use super::list::{OCTO, compiled, elevator, exact, octo, shuttle, uncertain, weakened, with};
use crate::motion::{Timetable, equations};
use crate::truth::Outline;
use crate::vehicles::{limit, mission, waypoint};
use mavc::model::{
    GiveUpYaw, LandingSite, LimitKind, Mission, MissionTime, Model, PlannerKind, Recovery, Rotor, RotorState, Spread,
    YawDrag,
};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, Z};
use std::f64::consts::TAU;

/// A fall with one acceleration (m/s^2) from the first waypoint to the last, straight below it.
pub fn falling(mission: &Mission, table: &Timetable, acceleration: f64, model: WrenchModel) -> Trajectory {
    let (first, last) = (&mission.waypoints[0], &mission.waypoints[mission.waypoints.len() - 1]);
    let total = table.times[table.times.len() - 1];
    let speed = (last.position[2] - first.position[2]) / total - 0.5 * acceleration * total;
    let node = |&t: &f64| {
        let mut state = NodeState::default();
        (state[0][0], state[1][0], state[3][0]) = (first.position[0], first.position[1], first.yaw);
        let height = first.position[2] + speed * t + 0.5 * acceleration * t * t;
        state[Z][..3].copy_from_slice(&[height, speed + acceleration * t, acceleration]);
        state
    };
    let nodes = table.times.iter().map(node).collect();
    Trajectory { times: table.times.clone(), nodes, waypoint_nodes: table.waypoint_nodes.clone(), model }
}

/// A mode too weak to hover, flown with both ends moving, and a reserve about hover.
fn void(name: &'static str, mut model: Model, acceleration: f64) -> Draft {
    let total = 2.0;
    model.plan.time = MissionTime::Fixed(total);
    let mission = model.mission.as_mut().expect("a mission");
    (mission.start_at_rest, mission.end_at_rest) = (false, false);
    let table = Timetable::asked(&model, total).expect("a grid");
    let motion = falling(model.mission.as_ref().expect("a mission"), &table, acceleration, equations(&model));
    Draft { motion: Some(motion), ..Draft::new(name, total, model, &[]) }
}

fn weak(planner: PlannerKind, share: f64) -> Model {
    with(weakened(octo(elevator(-30.0), planner, 20)), |m| {
        let mission = m.mission.as_mut().expect("a mission");
        mission.waypoints.iter_mut().for_each(|w| w.position[2] += 40.0);
        m.modes.last_mut().expect("a mode").rotors.fill(RotorState::Reduced(share));
        m.plan.reserve = 0.1;
    })
}

/// A quadcopter whose rotors give as much thrust backwards, 198 m above its goal.
fn reversing(waypoints: &str, plan: &str) -> Model {
    compiled(&format!(
        "vehicle acro {{
            layout = \"PNPN\"
            arm = 20 cm
            mass = 1 kg
            inertia = [0.01, 0.01, 0.02] kg*m^2
            rotor {{ max_thrust = 6 N; min_thrust = -100 %; torque_per_thrust = 15 mm; max_speed = 900 rad/s }}
        }}
        mission drop {{ start at [0, 0, 200] m; {waypoints} }}
        plan {{ model = hover; planner = rip; within = 1 cm; samples = 48; {plan} }}"
    ))
}

/// Down with one thrust and stopped by another: the shortest falls are not symmetric. Where there is a waypoint on the
/// way, it is moved to where the motion is at its time.
fn dropped(name: &'static str, total: f64, mut model: Model) -> Draft {
    let table = Timetable::asked(&model, total).expect("a grid");
    let times = &table.times;
    let last = times.len() - 1;
    let switch = (0.38 * last as f64) as usize;
    let shapes = [1..switch, switch + 1..last];
    let is_on = |k: usize, shape: usize| f64::from(u8::from(shapes[shape].contains(&k)));
    // z' and z after an input that is linear between nodes.
    let moved = |inputs: &dyn Fn(usize) -> f64| {
        let mut states = vec![[0.0, 0.0]];
        for k in 0..last {
            let (h, a, b, [z, v]) = (times[k + 1] - times[k], inputs(k), inputs(k + 1), states[k]);
            states.push([z + v * h + h * h * (2.0 * a + b) / 6.0, v + 0.5 * h * (a + b)]);
        }
        states
    };
    let ends = [0, 1].map(|shape| moved(&|k| is_on(k, shape))[last]);
    let mission = model.mission.as_ref().expect("a mission");
    let fall = mission.waypoints[mission.waypoints.len() - 1].position[2] - mission.waypoints[0].position[2];
    // Both sizes from z' = 0 and the height at the end.
    let determinant = ends[0][0] * ends[1][1] - ends[1][0] * ends[0][1];
    let sizes = [fall * ends[1][1] / determinant, -fall * ends[0][1] / determinant];
    let input = |k: usize| sizes[0] * is_on(k, 0) + sizes[1] * is_on(k, 1);
    let states = moved(&input);
    let node = |k: usize| {
        let mut state = NodeState::default();
        state[Z][..3].copy_from_slice(&[mission.waypoints[0].position[2] + states[k][0], states[k][1], input(k)]);
        state
    };
    let mut nodes: Vec<NodeState> = (0..=last).map(node).collect();
    nodes[last][Z][1] = 0.0;
    let motion = Trajectory {
        nodes,
        times: times.clone(),
        waypoint_nodes: table.waypoint_nodes.clone(),
        model: equations(&model),
    };
    for (point, &node) in model.mission.iter_mut().flat_map(|m| &mut m.waypoints).zip(&table.waypoint_nodes) {
        point.position[2] = motion.nodes[node][Z][0];
    }
    Draft { motion: Some(motion), ..Draft::new(name, total, model, &[]) }
}

/// In the exact model, with other fields of the plan.
fn flown(mission: &str, plan: &str) -> Model {
    compiled(&format!("{OCTO}; mission flown {{ {mission} }}; plan {{ planner = rip; samples = 32; {plan} }}"))
}

/// Straight on, with the yaw by a rule at the start; the tolerance of the yaw is that of the plan.
fn straight_on(rule: &str, within: &str) -> Model {
    let mission = format!(
        "start at [0, 0, 5] m  yaw {rule}
        waypoint at [4, 1, 6] m
        waypoint at [8, 2, 5] m"
    );
    flown(&mission, &format!("time = 9 s; yaw_within = {within}"))
}

/// Past volumes with these outlines.
fn among_outlines(name: &'static str, outlines: Vec<Outline>) -> Draft {
    let volume = |(index, outline): (usize, &Outline)| {
        let corners: Vec<String> = outline.corners.iter().map(|[x, y]| format!("[{x}, {y}]")).collect();
        let kind = if outline.keep_in { "keep_in" } else { "keep_out" };
        let (corners, Outline { bottom, top, .. }) = (corners.join(", "), outline);
        format!("{kind} v{index} {{ shape = polygon; corners = [{corners}] m; bottom = {bottom} m; top = {top} m }}")
    };
    let volumes: Vec<String> = outlines.iter().enumerate().map(volume).collect();
    let mission = format!("start at [0, 0, 2] m\n waypoint at [4, 1, 2.5] m\n{}", volumes.join("\n"));
    Draft { outlines, ..Draft::new(name, 6.0, flown(&mission, "time = 6 s"), &[]) }
}

/// Corners around a centre, counter-clockwise, at distances that change in turn.
fn around(centre: [f64; 2], count: usize, distances: [f64; 2], keep_in: bool) -> Outline {
    let corner = |i: usize| {
        let (sine, cosine) = (TAU * (i as f64 + 0.3) / count as f64).sin_cos();
        [centre[0] + distances[i % 2] * cosine, centre[1] + distances[i % 2] * sine]
    };
    Outline { corners: (0..count).map(corner).collect(), bottom: -1.0, top: 6.0, keep_in }
}

/// A hexacopter that gives up yaw after the loss of a rotor, even where it could keep it.
fn freed(inertia: &str, more: &str, turn: &str, plan: &str) -> Model {
    compiled(&format!(
        "vehicle hexa {{
            layout = \"PNPNPN\"
            arm = 25 cm
            mass = 1.6 kg
            inertia = {inertia} kg*m^2
            yaw_drag = 2.75e-3 N*m*s/rad
            rotor {{ max_thrust = 6 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s; {more} }}
        }}
        faults {{ mode L {{ rotor 1 lost; without_yaw = always }} }}
        mission go {{
            start at [0, 0, 10] m
            waypoint at [5, 2, 11] m  yaw {turn}
            waypoint at [8, 0, 10] m
        }}
        plan {{ against = [L]; samples = 28; {plan} }}"
    ))
}

const EVEN: &str = "[0.02, 0.02, 0.035]";
const UNEVEN: &str = "[0.016, 0.03, 0.035]";

/// Through hover from one side to the other with a thrust whose direction turns at 1 rad/s, which takes a yaw torque
/// of a body so uneven, and hardly any other torque of one whose drag keeps it from spinning fast.
fn swinging(name: &'static str, total: f64) -> Draft {
    let model = with(freed("[0.01, 0.04, 0.035]", "", "0 deg", "planner = rcp; model = hover"), |m| {
        let mission = m.mission.as_mut().expect("a mission");
        (mission.start_at_rest, mission.end_at_rest) = (false, false);
        mission.waypoints.remove(1);
        mission.legs.pop();
        m.vehicle.yaw_drag = Some(YawDrag { linear: 0.1, spread: Spread::NONE, quadratic: 0.0 });
        m.plan.time = MissionTime::Fixed(total);
    });
    let table = Timetable::asked(&model, total).expect("a grid");
    let points = &model.mission.as_ref().expect("a mission").waypoints;
    let (from, to, jerk) = (points[0].position, points[1].position, model.gravity);
    let speed = (to[0] - from[0]) / total + jerk * total * total / 12.0;
    let node = |&t: &f64| {
        let mut state = NodeState::default();
        let x = from[0] + speed * t + jerk * (t * t * t / 6.0 - total * t * t / 4.0);
        let x_rate = speed + jerk * (0.5 * t * t - 0.5 * total * t);
        state[0][..4].copy_from_slice(&[x, x_rate, jerk * (t - 0.5 * total), jerk]);
        state[Z][0] = from[2];
        state
    };
    let nodes = table.times.iter().map(node).collect();
    let (times, waypoint_nodes) = (table.times.clone(), table.waypoint_nodes.clone());
    let motion = Trajectory { times, nodes, waypoint_nodes, model: equations(&model) };
    Draft { motion: Some(motion), ..Draft::new(name, total, model, &[]) }
}

/// Of the octocopter, beside a mode that keeps its yaw and one in which it would be given up only where needed.
fn beside_others() -> Model {
    with(exact(octo(shuttle(), PlannerKind::Rcp, 36)), |m| {
        m.vehicle.yaw_drag = Some(YawDrag { linear: 2.75e-3, spread: Spread { low: 0.8, high: 1.2 }, quadratic: 1e-5 });
        m.modes[0].without_yaw = Some(GiveUpYaw::Always);
        m.modes[4].without_yaw = Some(GiveUpYaw::Never);
        m.plan.against = vec![0, 4, 2];
        m.plan.time = MissionTime::Fixed(11.0);
    })
}

/// A short leg beside a landing site, so wide that the vehicle comes down inside it after the loss of its first rotor.
fn beside_a_site() -> Draft {
    let flight = mission(vec![waypoint([0.0, 0.0, 4.0], 0.0), waypoint([3.0, 0.0, 4.5], 0.0)]);
    let mut model = octo(flight, PlannerKind::Rip, 12);
    model.modes.truncate(1);
    let site = |name: &str, x: f64| LandingSite {
        name: name.into(),
        at: [x, 1.0, 0.0],
        radius: 6.0,
        span: Default::default(),
    };
    let flown = model.mission.as_mut().expect("a mission");
    flown.ground = Some(0.0);
    flown.limits = vec![limit(LimitKind::Speed, 6.0), limit(LimitKind::Descent, 3.0)];
    flown.after_fault.sites = vec![site("pad", 2.0), site("far", 60.0)];
    model.plan.reserve = 0.1;
    model.plan.time = MissionTime::Fixed(4.0);
    model.plan.recovery.order = vec![Recovery::LandAtSites];
    model.plan.recovery.detection = [0.1, 0.15];
    model.plan.recovery.within = 15.0;
    Draft { ways: true, ..Draft::new("beside a landing site", 4.0, model, &[]) }
}

/// A slow leg, a quick one that is outside the set without the first rotor, and a hold. Ways lead back to the hold.
fn quick_at_last() -> Draft {
    let places = [[0.0, 0.0, 4.0], [2.5, 0.0, 4.0], [2.5, 4.0, 4.0]];
    let mut flight = mission(places.map(|place| waypoint(place, 0.0)).to_vec());
    flight.waypoints[1].stop = true;
    flight.waypoints[1].time = Some(CALM);
    flight.waypoints[2].hold = 1.0;
    let mut model = octo(flight, PlannerKind::Rip, 30);
    model.modes.truncate(1);
    model.plan.reserve = 0.1;
    model.plan.time = MissionTime::Fixed(8.1);
    model.plan.recovery.order = vec![Recovery::Continue];
    model.plan.recovery.detection = [0.1, 0.15];
    model.plan.recovery.within = 6.0;
    Draft { ways: true, calm_until: Some(CALM), ..Draft::new("quick at last", 8.1, model, &[]) }
}

/// When the quick leg begins, s.
const CALM: f64 = 5.5;

/// Every draft.
pub fn drafts() -> Vec<Draft> {
    use PlannerKind::{Rcp, Rsp};
    let mut list = vec![
        beside_a_site(),
        quick_at_last(),
        void("reserve about nothing", weak(Rcp, 0.1), -8.0),
        void("reserve about nothing, exact", exact(weak(Rcp, 0.1)), -8.0),
        void("reserve about nothing, RSP", exact(weak(Rsp, 0.1)), -8.0),
    ];
    // Enough for the middle of the mass's interval, and not for its upper end.
    let nearly = with(uncertain(weak(Rcp, 0.1)), |m| {
        let (mass, g) = (m.vehicle.mass, m.gravity);
        m.vehicle.rotors.iter_mut().for_each(|rotor| rotor.spread = Default::default());
        m.vehicle.mass_spread = Spread { low: 0.96, high: 1.04 };
        let full: f64 = m.vehicle.rotors.iter().map(Rotor::max_thrust).sum();
        m.modes.last_mut().expect("a mode").rotors.fill(RotorState::Reduced(1.02 * mass * g / full));
    });
    list.push(void("reserve about nothing, an interval of the mass", nearly, -2.0));

    let drop = "waypoint at [0, 0, 2] m";
    let halfway = "waypoint at [0, 0, 100] m  time 3.5 s; waypoint at [0, 0, 2] m";
    list.push(dropped("reversing rotors", 7.2, reversing(drop, "time = 7.2 s")));
    list.push(dropped("reversing rotors, free total", 7.2, reversing(drop, "time = minimum")));
    list.push(dropped("reversing rotors, fixed waypoint", 7.2, reversing(halfway, "time = 7.2 s")));
    list.push(Draft { harder: true, ..dropped("reversing rotors, slow", 8.4, reversing(drop, "time = 8.4 s")) });

    let towards = "towards [400, 100, 0] m";
    for (name, rule, within) in [
        ("yaw towards, 1e-5 rad", towards, "1e-5 rad"),
        ("yaw towards, 0.005 deg", towards, "0.005 deg"),
        ("yaw towards, 1 deg", towards, "1 deg"),
        ("yaw towards, 30 deg", towards, "30 deg"),
        ("yaw towards, 80 deg", towards, "80 deg"),
        ("yaw along path, 1e-5 rad", "along path", "1e-5 rad"),
        ("yaw along path, 5 deg", "along path", "5 deg"),
        ("yaw along path, 80 deg", "along path", "80 deg"),
    ] {
        list.push(Draft::new(name, 9.0, straight_on(rule, within), &[]));
    }
    let landing = flown(
        "start at [0, 0, 8] m
        waypoint at [0, 0, 5] m  arrive from [0, 0, 1]
        waypoint at [0, 0, 2] m",
        "time = 7 s",
    );
    list.push(Draft::new("exact arrival from above", 7.0, landing, &[]));

    let own = "start at [0, 0, 2] m  within 1 cm  yaw_within 0.5 deg
        waypoint at [3, 1, 3] m  within 60 cm  yaw_within 20 deg
        waypoint at [5, 0, 2.5] m  within 10 cm  yaw_within 2 deg
        waypoint at [6, 0, 2.5] m  within 50 cm  yaw_within 25 deg";
    list.push(Draft::new("own tolerances", 10.0, flown(own, "model = hover; time = 10 s"), &[]));
    list.push(Draft::new("exact own tolerances", 10.0, flown(own, "time = 10 s"), &[]));
    let start = |rule: &str| {
        format!(
            "start at [0, 0, 5] m  yaw {rule}  yaw_within 0.1 deg
            waypoint at [4, 1, 6] m  yaw_within 80 deg
            waypoint at [8, 2, 5] m  yaw_within 70 deg"
        )
    };
    list.push(Draft::new("a narrow yaw at the start", 9.0, flown(&start(towards), "time = 9 s"), &[]));
    let moving = format!("start moving; end moving; {}", start("along path"));
    list.push(Draft::new("a narrow yaw at a moving start", 6.0, flown(&moving, "time = 6 s"), &[]));
    let begins = |rule: &str| {
        format!(
            "start at [0, 0, 5] m  yaw 20 deg  yaw_within 5 deg
            waypoint at [4, 1, 6] m  yaw {rule}  yaw_within 0.1 deg
            waypoint at [8, 2, 5] m  yaw_within 80 deg
            waypoint at [12, 3, 5] m  yaw_within 60 deg"
        )
    };
    list.push(Draft::new("a rule begins in mid-mission", 10.0, flown(&begins(towards), "time = 10 s"), &[]));
    list.push(Draft::new("along path from mid-mission", 10.0, flown(&begins("along path"), "time = 10 s"), &[]));

    let turn = |limits: &str| {
        format!(
            "start at [0, 0, 5] m  yaw 0 deg  yaw_within 0.2 deg
            waypoint at [2, 0, 5] m  yaw -90 deg  yaw_within 0.2 deg
            limits {{ {limits} }}"
        )
    };
    let both = "yaw_rate in -90 deg/s .. 10 deg/s; yaw_acceleration in -60 deg/s^2 .. 40 deg/s^2";
    list.push(Draft::new("uneven sides", 5.0, flown(&turn(both), "time = 5 s"), &[]));
    let hover = flown(&turn(both), "model = hover; time = minimum");
    list.push(Draft::new("uneven sides, hover, free total", 5.5, hover, &[]));
    let wide = flown(&turn("yaw_rate in -14 deg/s .. 4 deg/s"), "time = 16 s");
    list.push(Draft::new("uneven yaw rate", 16.0, wide, &[]));
    let rate = flown(&turn("yaw_rate in -90 deg/s .. 10 deg/s"), "time = 9.1 s");
    list.push(Draft { harder: true, ..Draft::new("uneven sides, slow", 9.1, rate, &[]) });

    let delivery = |model: &str| {
        compiled(&format!(
            "vehicle quad {{
                layout = \"PNPN\"
                arm = 23 cm
                mass = 1.9 kg
                inertia = [0.018, 0.018, 0.033] kg*m^2
                yaw_drag = 2.75e-3 N*m*s/rad
                rotor {{ max_thrust = 11 N; torque_per_thrust = 15 mm; max_speed = 8000 rpm; time_constant = 20 ms }}
            }}
            faults {{ every 1 rotor lost as L }}
            mission delivery {{
                ground = 0 m
                start at [0, 0, 2] m
                waypoint at [0, 0, 15] m  vertical  stop
                waypoint at [14, 0, 15] m
                waypoint at [14, 0, 4] m
                limits {{ speed <= 8 m/s }}
            }}
            plan {{
                planner = rip; model = {model}; samples = 42; time = 20 s
                require capture_height {{ radius = 1.2 m; detection = 100 ms }}
            }}"
        ))
    };
    let bay = [[1.0, -1.5], [6.0, -1.5], [6.0, 3.0], [1.0, 3.0], [1.0, 2.2], [5.0, 2.2], [5.0, -0.7], [1.0, -0.7]];
    let bay = Outline { corners: bay.to_vec(), bottom: 0.0, top: 5.0, keep_in: false };
    for (name, outlines) in [
        ("keep-outs of many corners", vec![around([2.2, -1.7], 60, [1.0; 2], false)]),
        ("a star between", vec![around([2.0, 2.4], 24, [1.0, 0.6], false), around([2.2, -1.7], 40, [1.0; 2], false)]),
        ("into a bay", vec![bay]),
        ("a keep-in of many corners", vec![around([2.0, 0.5], 60, [3.2; 2], true)]),
    ] {
        list.push(among_outlines(name, outlines));
    }

    for (name, inertia, more, turn, plan) in [
        ("core, hover", EVEN, "", "0 deg", "planner = rcp; model = hover"),
        ("core", EVEN, "", "100 deg", "planner = rcp; reserve = 5 %"),
        ("uneven core, hover", UNEVEN, "rotor_inertia = 2e-5 kg*m^2", "0 deg", "planner = rcp; model = hover"),
        ("uneven core", UNEVEN, "", "-50 deg", "planner = rcp"),
        ("core of RSP, hover", EVEN, "", "40 deg", "planner = rsp; model = hover"),
        ("core of RSP", EVEN, "rotor_inertia = 2e-5 kg*m^2", "0 deg", "planner = rsp"),
        ("uneven core of RSP, hover", UNEVEN, "", "0 deg", "planner = rsp; model = hover"),
        ("uneven core of RSP", UNEVEN, "", "30 deg", "planner = rsp"),
    ] {
        // Long pieces leave time for a fast yaw.
        let plan = format!("{plan}; time = 12 s");
        list.push(Draft::new(name, 12.0, freed(inertia, more, turn, &plan), &[]));
    }
    list.push(swinging("uneven core that swings", 1.6));
    list.push(Draft::new("core beside other modes", 11.0, beside_others(), &[]));
    let weak_core = with(exact(weak(Rcp, 0.1)), |m| {
        m.vehicle.yaw_drag = Some(YawDrag { linear: 2.75e-3, spread: Spread::NONE, quadratic: 0.0 });
        m.modes.last_mut().expect("a mode").without_yaw = Some(GiveUpYaw::Always);
    });
    list.push(void("reserve about nothing, core", weak_core, -8.0));

    for (name, model) in [("capture height", "exact"), ("capture height, hover", "hover")] {
        let draft = Draft::new(name, 20.0, delivery(model), &[]);
        list.push(Draft { capture_height: Some(14.95), ..draft });
    }
    list
}
