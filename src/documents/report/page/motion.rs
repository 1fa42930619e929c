//! A planned trajectory as columns and charts.

use super::chart::{Bound, Chart, Columns, Line, column, length, rounded};
use super::instants::instants;
use super::sets::ShownSet;
use super::volumes;
use crate::admissible::allocation::Allocator;
use crate::admissible::hover;
use crate::admissible::row::VIOLATED;
use crate::energy::Power;
use crate::model::{LimitKind, Mission, Model, Problem};
use crate::motion::checks::peak;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z, roll_pitch, tilt};
use crate::number::{fixed, percent, significant, tenths};
use crate::planner::studies::MissionPlan;
use crate::report::battery;
use crate::report::record::errors;

/// Fewest instants of a curve: if there are fewer nodes, instants between them are added so that curves have their
/// shape.
const FEWEST: usize = 400;

/// Limits on norms of derivatives: kind, column, axes, order of the derivative.
const NORMS: [(LimitKind, &str, &[usize], usize); 5] = [
    (LimitKind::Speed, "speed", &[X, Y, Z], 1),
    (LimitKind::SpeedHorizontal, "speed_horizontal", &[X, Y], 1),
    (LimitKind::Acceleration, "acceleration", &[X, Y, Z], 2),
    (LimitKind::AccelerationHorizontal, "acceleration_horizontal", &[X, Y], 2),
    (LimitKind::Jerk, "jerk", &[X, Y, Z], 3),
];

/// Limited derivatives of yaw: kind, column, order.
const YAW_RATES: [(LimitKind, &str, usize); 2] =
    [(LimitKind::YawRate, "yaw_rate", 1), (LimitKind::YawAcceleration, "yaw_acceleration", 2)];

fn norm(state: &NodeState, axes: &[usize], order: usize) -> f64 {
    axes.iter().map(|&a| state[a][order].powi(2)).sum::<f64>().sqrt()
}

/// States at about [`FEWEST`] instants or at the nodes, at most about `most`; always including the waypoints.
fn states(trajectory: &Trajectory, most: usize) -> Vec<(f64, NodeState)> {
    if trajectory.times.len() > most {
        let rate = most as f64 / trajectory.duration();
        return instants(trajectory, rate).into_iter().map(|t| (t, trajectory.at(t))).collect();
    }
    let parts = FEWEST.min(most).div_ceil(trajectory.intervals());
    let within = |k: usize| {
        let (begin, h) = (trajectory.times[k], trajectory.times[k + 1] - trajectory.times[k]);
        (0..parts).map(move |p| h * p as f64 / parts as f64).map(move |t| (begin + t, trajectory.within(k, t)))
    };
    let end = trajectory.duration();
    (0..trajectory.intervals()).flat_map(within).chain([(end, trajectory.at(end))]).collect()
}

/// Columns of a trajectory: SI units, except angles in degrees and margins in percent of the healthy set's width.
pub fn columns(problem: Problem, solved: &MissionPlan, shown: &[ShownSet], most: usize) -> Columns {
    let model = problem.model();
    let trajectory = &solved.trajectory;
    let environment = model.environment();
    let states = states(trajectory, most);
    let mut columns = Columns::new();
    let mut add = |name: &str, value: &dyn Fn(&NodeState) -> f64| {
        columns.insert(name.to_string(), column(states.iter().map(|(_, s)| value(s))));
    };
    for (name, axis) in [("x", X), ("y", Y), ("z", Z)] {
        add(name, &|s| s[axis][0]);
    }
    add("yaw", &|s| s[YAW][0].to_degrees());
    add("yaw_rate", &|s| s[YAW][1].to_degrees());
    add("climb", &|s| s[Z][1]);
    add("tilt", &|s| tilt(s, &environment).to_degrees());
    add("roll", &|s| roll_pitch(s, &environment).0.to_degrees());
    add("pitch", &|s| roll_pitch(s, &environment).1.to_degrees());
    for (kind, name, axes, order) in NORMS {
        if kind == LimitKind::Speed || limited(model, &[kind]) {
            add(name, &|s| norm(s, axes, order));
        }
    }
    if limited(model, &[LimitKind::YawAcceleration]) {
        add("yaw_acceleration", &|s| s[YAW][2].to_degrees());
    }
    let wrenches: Vec<_> = states.iter().map(|(_, s)| trajectory.wrench(&model.vehicle, &environment, s)).collect();
    let turning = |s: &NodeState| trajectory.model.turning(&model.vehicle, &environment, s);
    let turnings: Vec<_> = states.iter().map(|(_, s)| turning(s)).collect();
    columns.insert("t".into(), states.iter().map(|(t, _)| rounded(*t)).collect());
    for (axis, name) in WRENCH.iter().enumerate() {
        columns.insert((*name).into(), column(wrenches.iter().map(|w| w[axis])));
    }
    let allocator = Allocator::new(&model.vehicle);
    let speeds: Vec<Vec<f64>> = wrenches.iter().map(|w| allocator.speeds(w)).collect();
    for k in 0..model.vehicle.rotors.len() {
        columns.insert(format!("omega_{}", k + 1), column(speeds.iter().map(|row| row[k])));
    }
    if let Some(power) = Power::of(model) {
        columns.insert("power".into(), column(states.iter().map(|(_, s)| power.at(trajectory, s))));
    }
    for (i, set) in shown.iter().enumerate().filter(|(_, s)| s.against.is_some()) {
        // Thousandths of a percent.
        let margins = wrenches.iter().zip(&turnings).map(|(w, turning)| (1e5 * set.margin(w, turning)).round() / 1e3);
        columns.insert(format!("margin_{i}"), margins.collect());
    }
    let distances = volumes::distances(problem, solved, states.iter().map(|(_, s)| s));
    columns.extend(distances.into_iter().map(|(name, values)| (name, column(values.into_iter()))));
    columns
}

/// Names of the wrench's columns.
pub const WRENCH: [&str; 4] = ["thrust", "tau_x", "tau_y", "tau_z"];

fn limited(model: &Model, kinds: &[LimitKind]) -> bool {
    model.mission.iter().flat_map(|m| &m.limits).any(|l| kinds.contains(&l.kind))
}

/// The bounds of the mission's limits of these kinds, in display units.
fn bounds(mission: &Mission, kinds: &[LimitKind]) -> Vec<Bound> {
    let mut found = Vec::new();
    for limit in mission.limits.iter().filter(|l| l.is_general() && kinds.contains(&l.kind)) {
        let description = limit.kind.describe();
        let (name, factor) = (description.name, description.factor());
        let name = if limit.volume.is_some() { limit.name() } else { name };
        // A descent is drawn as a negative climb.
        let (name, factor, words) = match limit.kind {
            LimitKind::Descent => (LimitKind::Climb.describe().name, -factor, ["at least", "at most"]),
            _ => (name, factor, ["at most", "at least"]),
        };
        let sides = [limit.upper, limit.lower].into_iter().zip(words);
        found.extend(sides.filter_map(|(side, word)| Some(Bound::limit(format!("{name} {word}"), factor * side?))));
    }
    found
}

/// The charts of a plan, each with its main fact as the headline.
pub fn charts(problem: Problem, solved: &MissionPlan, shown: &[ShownSet]) -> Vec<Chart> {
    let (model, mission) = (problem.model(), problem.mission());
    let mut charts = Vec::new();
    if shown.iter().any(|s| s.against.is_some()) {
        charts.push(margins(solved, shown));
    }
    charts.push(position(mission, solved));
    charts.extend(volumes::chart(problem, solved));
    charts.extend([speed(mission, solved), tilts(problem, solved)]);
    charts.extend(yaw(mission, solved));
    for (id, title, unit, kinds) in RARE {
        charts.extend(rare(mission, solved, id, title, unit, kinds));
    }
    charts.extend(wrench(model, solved));
    charts.push(rotors(model, solved));
    charts.extend(power(model, solved));
    charts
}

fn at(value: f64, unit: &str, t: f64) -> String {
    format!("{} {unit} at {} s", significant(value, 3), fixed(t, 2))
}

fn margins(solved: &MissionPlan, shown: &[ShownSet]) -> Chart {
    let sets = || shown.iter().enumerate().filter_map(|(i, s)| Some((i, s, s.against?)));
    let least = nearest(solved).and_then(|n| sets().find(|(.., against)| *against == n));
    let headline = match least.map(|(_, s, against)| (s, -solved.outside[against].max_violation)) {
        Some((set, margin)) if margin < 0.0 => {
            format!("The smallest spare is {}, outside {}", signed_percent(margin), set.name)
        }
        Some((set, margin)) => format!("The smallest spare is {}, in {}", signed_percent(margin), set.name),
        None => "No fault mode is planned against".into(),
    };
    Chart {
        id: "margin",
        title: "Spare in each fault mode's set, in widths of the healthy set",
        headline,
        unit: "%",
        lines: sets().map(|(i, s, _)| Line::new(s.name.clone(), format!("margin_{i}"))).collect(),
        bounds: vec![Bound::limit("edge", 0.0)],
        axis: None,
    }
}

/// Index of the mode planned against with the smallest margin; the first of several whose margins print the same.
pub fn nearest(solved: &MissionPlan) -> Option<usize> {
    // Modes without rows have no margin.
    let worst = solved.outside.iter().map(|o| o.max_violation).filter(|v| v.is_finite()).max_by(f64::total_cmp)?;
    // Thousandths of a percent, as in the columns of margins.
    solved.outside.iter().position(|o| o.max_violation >= worst - 1e-5)
}

/// A spare in percent with its sign: `+3.2 %`, `−14.6 %`.
pub fn signed_percent(share: f64) -> String {
    let digits = tenths(share.abs());
    match share {
        // Smaller than what counts as a violation, or than the digits show.
        s if s.abs() < VIOLATED / 2.0 || digits == tenths(0.0) => tenths(0.0),
        s if s < 0.0 => format!("\u{2212}{digits}"),
        _ => format!("+{digits}"),
    }
}

fn position(mission: &Mission, solved: &MissionPlan) -> Chart {
    let e = errors(mission, solved);
    let n = mission.waypoints.len();
    Chart {
        id: "position",
        title: "Position",
        headline: format!("{n} waypoints are met, with errors of at most {}", length(e.largest)),
        unit: "m",
        lines: ["x", "y", "z"].map(|name| Line::new(name, name)).to_vec(),
        bounds: bounds(mission, &[LimitKind::X, LimitKind::Y, LimitKind::Z]),
        axis: None,
    }
}

/// `, of 6 m/s allowed`, or `, without a limit`.
fn allowed(mission: &Mission, kind: &LimitKind) -> String {
    let description = kind.describe();
    let (unit, factor) = (description.unit, description.factor());
    match mission.limits.iter().find(|l| l.is_general() && l.kind == *kind).and_then(|l| l.upper) {
        Some(most) => format!(", of {} {unit} allowed", significant(factor * most, 3)),
        None => ", without a limit".into(),
    }
}

fn speed(mission: &Mission, solved: &MissionPlan) -> Chart {
    let kinds = [LimitKind::Speed, LimitKind::SpeedHorizontal, LimitKind::Climb, LimitKind::Descent];
    let top = peak(&solved.trajectory, |s| norm(s, &[X, Y, Z], 1));
    let mut lines = vec![Line::new("speed", "speed"), Line::new("climb", "climb")];
    if mission.limits.iter().any(|l| l.kind == LimitKind::SpeedHorizontal) {
        lines.insert(1, Line::new("horizontal", "speed_horizontal"));
    }
    Chart {
        id: "speed",
        title: "Speed",
        headline: format!("Speed reaches {}{}", at(top.value, "m/s", top.at), allowed(mission, &LimitKind::Speed)),
        unit: "m/s",
        lines,
        bounds: bounds(mission, &kinds),
        axis: None,
    }
}

fn tilts(problem: Problem, solved: &MissionPlan) -> Chart {
    let (environment, mission) = (problem.model().environment(), problem.mission());
    let top = peak(&solved.trajectory, |s| tilt(s, &environment));
    let reached = at(top.value.to_degrees(), "deg", top.at);
    Chart {
        id: "tilt",
        title: "Tilt",
        headline: format!("Tilt reaches {reached}{}", allowed(mission, &LimitKind::Tilt)),
        unit: "deg",
        lines: vec![Line::new("tilt", "tilt"), Line::new("roll", "roll"), Line::new("pitch", "pitch")],
        bounds: bounds(mission, &[LimitKind::Tilt]),
        axis: None,
    }
}

fn yaw(mission: &Mission, solved: &MissionPlan) -> Option<Chart> {
    let kinds = [LimitKind::Yaw, LimitKind::YawRate, LimitKind::YawAcceleration];
    let fixed = mission.has_one_yaw() && !mission.limits.iter().any(|l| kinds.contains(&l.kind));
    let top = peak(&solved.trajectory, |s| s[YAW][1].abs());
    (!fixed).then(|| Chart {
        id: "yaw",
        title: "Yaw",
        headline: format!("The yaw rate reaches {}", at(top.value.to_degrees(), "deg/s", top.at)),
        unit: "deg",
        lines: vec![Line::new("yaw", "yaw")],
        bounds: bounds(mission, &[LimitKind::Yaw]),
        axis: None,
    })
}

/// Charts that are drawn only if their quantity is limited.
const RARE: [(&str, &str, &str, &[LimitKind]); 4] = [
    ("yaw_rate", "Yaw rate", "deg/s", &[LimitKind::YawRate]),
    ("yaw_acceleration", "Yaw acceleration", "deg/s^2", &[LimitKind::YawAcceleration]),
    ("acceleration", "Acceleration", "m/s^2", &[LimitKind::Acceleration, LimitKind::AccelerationHorizontal]),
    ("jerk", "Jerk", "m/s^3", &[LimitKind::Jerk]),
];

fn rare(
    mission: &Mission,
    solved: &MissionPlan,
    id: &'static str,
    title: &'static str,
    unit: &'static str,
    kinds: &[LimitKind],
) -> Option<Chart> {
    let first = mission.limits.iter().find(|l| kinds.contains(&l.kind))?;
    let of_yaw = |kind: &LimitKind| YAW_RATES.iter().find(|of_yaw| of_yaw.0 == *kind);
    let of_norm = |kind: &LimitKind| NORMS.iter().find(|norm| norm.0 == *kind);
    let column_of = |kind: &LimitKind| of_yaw(kind).map(|of_yaw| of_yaw.1).or(of_norm(kind).map(|norm| norm.1));
    let top = match (of_yaw(&first.kind), of_norm(&first.kind)) {
        (Some((_, _, order)), _) => peak(&solved.trajectory, |s| s[YAW][*order].abs().to_degrees()),
        (None, Some((_, _, axes, order))) => peak(&solved.trajectory, |s| norm(s, axes, *order)),
        (None, None) => return None,
    };
    let limited = kinds.iter().filter(|k| mission.limits.iter().any(|l| l.kind == **k));
    let lines = limited.filter_map(|kind| Some(Line::new(kind.describe().name, column_of(kind)?))).collect();
    let name = first.kind.describe().name;
    Some(Chart {
        id,
        title,
        headline: format!(
            "{}{} reaches {}{}",
            name[..1].to_uppercase(),
            &name[1..],
            at(top.value, unit, top.at),
            allowed(mission, &first.kind)
        ),
        unit,
        lines,
        bounds: bounds(mission, kinds),
        axis: None,
    })
}

fn wrench(model: &Model, solved: &MissionPlan) -> Vec<Chart> {
    let trajectory = &solved.trajectory;
    let environment = model.environment();
    let of = |s: &NodeState, axis: usize| trajectory.wrench(&model.vehicle, &environment, s)[axis];
    let (most, least) = (peak(trajectory, |s| of(s, 0)), peak(trajectory, |s| -of(s, 0)));
    let full: f64 = model.vehicle.rotors.iter().map(crate::model::Rotor::max_thrust).sum();
    let idle: f64 = model.vehicle.rotors.iter().map(crate::model::Rotor::idle_thrust).sum();
    let clean = |v: f64| if v.abs() < 1e-6 * full { 0.0 } else { v };
    let thrust = Chart {
        id: "thrust",
        title: "Thrust",
        headline: format!(
            "Thrust lies between {} N and {} N, of {} N at full speed",
            significant(clean(-least.value), 3),
            significant(clean(most.value), 3),
            significant(full, 3)
        ),
        unit: "N",
        lines: vec![Line::new("planned", "thrust")],
        bounds: vec![
            Bound::limit("full thrust", full),
            Bound::limit("least thrust", idle),
            Bound::reference("weight", hover(model)[0]),
        ],
        axis: Some(0),
    };
    let torques = [("tau_x", "Torque about x"), ("tau_y", "Torque about y"), ("tau_z", "Torque about z")];
    let torque = |(i, (id, title)): (usize, (&'static str, &'static str))| {
        let top = peak(trajectory, |s| of(s, i + 1).abs());
        Chart {
            id,
            title,
            headline: format!(
                "{title} stays within \u{b1}{} N m, largest at {} s",
                significant(top.value, 3),
                fixed(top.at, 2)
            ),
            unit: "N m",
            lines: vec![Line::new("planned", id)],
            bounds: Vec::new(),
            axis: Some(i + 1),
        }
    };
    std::iter::once(thrust).chain(torques.into_iter().enumerate().map(torque)).collect()
}

fn rotors(model: &Model, solved: &MissionPlan) -> Chart {
    let rotors = &model.vehicle.rotors;
    let allocator = Allocator::new(&model.vehicle);
    let environment = model.environment();
    let top = peak(&solved.trajectory, |s| {
        let wrench = solved.trajectory.wrench(&model.vehicle, &environment, s);
        let shares = allocator.speeds(&wrench).into_iter().zip(rotors).map(|(w, r)| w.abs() / r.max_speed);
        shares.fold(0.0, f64::max)
    });
    let mut bounds = Vec::new();
    for (word, speed) in [("top", 0), ("least", 1)] {
        let of = |k: usize| if speed == 0 { rotors[k].max_speed } else { rotors[k].min_speed };
        let mut values: Vec<f64> = (0..rotors.len()).map(of).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        // A lowest speed of zero is not worth a line.
        values.retain(|&v| v != 0.0);
        bounds.extend(values.into_iter().map(|v| Bound::limit(format!("{word} speed"), v)));
    }
    Chart {
        id: "rotors",
        title: "Rotor speeds, healthy",
        headline: format!("Rotors reach at most {} of their top speed, at {} s", percent(top.value), fixed(top.at, 2)),
        unit: "rad/s",
        lines: (1..=rotors.len()).map(|k| Line::new(format!("rotor {k}"), format!("omega_{k}"))).collect(),
        bounds,
        axis: None,
    }
}

fn power(model: &Model, solved: &MissionPlan) -> Option<Chart> {
    let battery = model.vehicle.battery.as_ref()?;
    let record = battery::record(model, &solved.trajectory)?;
    Some(Chart {
        id: "power",
        title: "Electrical power",
        headline: format!("The plan takes {}: {}", record.used(), record.powers()),
        unit: "W",
        lines: vec![Line::new("power", "power")],
        bounds: vec![Bound::reference("hover", battery.hover_power)],
        axis: None,
    })
}
