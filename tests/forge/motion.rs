//! Motions in closed form, made without the planner: the least snap through waypoints at given times, splines added to
//! them, nodes put in.

use mavc::certificate::{Certificate, Claim, DynamicModel, MotionRecord, PlanClaim, SCHEMA, Vertical};
use mavc::model::grid::{leg_durations, pieces};
use mavc::model::{Mission, Model, PlanModel};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z, state_between};
use nalgebra::{DMatrix, DVector};

pub const AXES: [usize; 4] = [X, Y, Z, YAW];

/// The equations of a spec.
pub fn equations(model: &Model) -> WrenchModel {
    let mission = model.mission.as_ref().expect("every spec here has a mission");
    match model.plan.model {
        PlanModel::Exact => WrenchModel::Exact,
        PlanModel::Hover if mission.has_one_yaw() => WrenchModel::HoverAt(mission.waypoints[0].yaw),
        PlanModel::Hover => WrenchModel::HoverFollowing,
    }
}

/// When nodes are, and which of them are waypoints.
#[derive(Debug, Clone)]
pub struct Timetable {
    /// s
    pub times: Vec<f64>,
    pub waypoint_nodes: Vec<usize>,
}

impl Timetable {
    /// From holds (s), the legs' durations (s) and where nodes are within each leg, as shares that end in 1.
    pub fn of(holds: &[f64], durations: &[f64], within: &[Vec<f64>]) -> Self {
        let (mut times, mut waypoint_nodes, mut now) = (vec![0.0], vec![0], 0.0);
        for (leg, &duration) in durations.iter().enumerate() {
            if holds[leg] > 0.0 {
                now += holds[leg];
                times.push(now);
            }
            times.extend(within[leg].iter().map(|share| now + share * duration));
            now += duration;
            waypoint_nodes.push(times.len() - 1);
        }
        if holds[durations.len()] > 0.0 {
            times.push(now + holds[durations.len()]);
        }
        Timetable { times, waypoint_nodes }
    }

    /// The nodes that the spec asks for, for a mission of `total` s.
    pub fn asked(model: &Model, total: f64) -> Option<Self> {
        let mission = model.mission.as_ref()?;
        let durations = leg_durations(mission, total)?;
        let counts = pieces(mission, &durations, model.plan.samples);
        let even = counts.iter().map(|&n| evenly(n)).collect::<Vec<_>>();
        Some(Timetable::of(&holds(mission), &durations, &even))
    }
}

/// Shares of `n` pieces of equal duration.
pub fn evenly(n: usize) -> Vec<f64> {
    (1..=n).map(|i| i as f64 / n as f64).collect()
}

pub fn holds(mission: &Mission) -> Vec<f64> {
    mission.waypoints.iter().map(|w| w.hold).collect()
}

/// What a motion is to do.
#[derive(Debug, Clone)]
pub struct Wish {
    /// x, y, z (m) and yaw (rad) of each waypoint.
    pub places: Vec<[f64; 4]>,
    pub start_at_rest: bool,
    pub end_at_rest: bool,
    /// Whether the motion stands still from a waypoint to the node after it.
    pub held: Vec<bool>,
    /// Whether it comes to rest at a waypoint.
    pub stops: Vec<bool>,
    /// Velocities (m/s) at waypoints that are flown through.
    pub velocities: Vec<(usize, [f64; 3])>,
}

impl Wish {
    pub fn of(mission: &Mission) -> Self {
        let place = |w: &mavc::model::Waypoint| [w.position[0], w.position[1], w.position[2], w.yaw];
        Wish {
            places: mission.waypoints.iter().map(place).collect(),
            start_at_rest: mission.start_at_rest,
            end_at_rest: mission.end_at_rest,
            held: mission.waypoints.iter().map(|w| w.hold > 0.0).collect(),
            stops: mission.waypoints.iter().map(|w| w.stop).collect(),
            velocities: Vec::new(),
        }
    }

    /// Derivatives that are given, each with its value: (node, derivative, value).
    fn given(&self, table: &Timetable, axis: usize, order: usize) -> Vec<(usize, usize, f64)> {
        let last = table.times.len() - 1;
        let mut given = Vec::new();
        for (i, (place, &node)) in self.places.iter().zip(&table.waypoint_nodes).enumerate() {
            given.push((node, 0, place[axis]));
            if self.held[i] {
                given.extend((1..=order).map(|i| (node, i, 0.0)));
                given.push((node + 1, order, 0.0));
            } else if self.stops[i] {
                // Without an input the legs on both sides do not depend on each other.
                given.extend((1..=order).map(|i| (node, i, 0.0)));
            }
        }
        let of_axis = self.velocities.iter().filter(|_| axis != YAW);
        given.extend(of_axis.map(|&(waypoint, velocity)| (table.waypoint_nodes[waypoint], 1, velocity[axis])));
        for (node, rests) in [(0, self.start_at_rest), (last, self.end_at_rest)] {
            let here = given.iter().any(|g| g.0 == node && g.1 == 1);
            // A hold at the very end holds its second node still by the first.
            let follows = node == last && self.held.last() == Some(&true);
            if rests && !here && !follows {
                // Without an input the legs on both sides do not depend on each other.
                given.extend((1..=order).map(|i| (node, i, 0.0)));
            }
        }
        given
    }

    /// The motion of least snap, of least acceleration in order-2 axes, that does it; `None` where there is none.
    pub fn motion(&self, table: &Timetable, model: WrenchModel) -> Option<Trajectory> {
        let mut nodes = vec![NodeState::default(); table.times.len()];
        for (axis, order) in AXES.into_iter().zip(model.orders()) {
            let given = self.given(table, axis, order);
            let inputs = least(&table.times, order, &given)?;
            lay(&mut nodes, &table.times, axis, order, &inputs, &given, model);
        }
        for (&node, &held) in table.waypoint_nodes.iter().zip(&self.held) {
            if held {
                nodes[node + 1] = nodes[node];
            }
        }
        let motion =
            Trajectory { times: table.times.clone(), nodes, waypoint_nodes: table.waypoint_nodes.clone(), model };
        (widest_gap(&motion) < 1e-7).then_some(motion)
    }
}

/// The widest gap at any joint, in units of 1 of every derivative below the input's.
fn widest_gap(motion: &Trajectory) -> f64 {
    let mut widest = 0.0_f64;
    for k in 0..motion.intervals() {
        let end = motion.within(k, motion.times[k + 1] - motion.times[k]);
        for (axis, order) in AXES.into_iter().zip(motion.model.orders()) {
            for (a, b) in end[axis].iter().zip(&motion.nodes[k + 1][axis]).take(order) {
                let gap = (a - b).abs();
                widest = if gap.is_nan() { f64::INFINITY } else { widest.max(gap) };
            }
        }
    }
    widest
}

/// Start derivatives below `order`, then the input at each node: the least weighted squares that meet what is given.
fn least(times: &[f64], order: usize, given: &[(usize, usize, f64)]) -> Option<Vec<f64>> {
    let total = times[times.len() - 1];
    let unknowns = order + times.len();
    // Time in units of the mission's keeps numbers of like size.
    let mut state: Vec<DVector<f64>> = (0..order).map(|i| unit(unknowns, i)).collect();
    let mut rows: Vec<DVector<f64>> = Vec::new();
    let mut values = Vec::new();
    for node in 0..times.len() {
        if node > 0 {
            state = carried(&state, (times[node] - times[node - 1]) / total, order, node, unknowns);
        }
        for &(at, i, value) in given.iter().filter(|g| g.0 == node) {
            rows.push(if i == order { unit(unknowns, order + at) } else { state[i].clone() });
            values.push(value * total.powi(i as i32));
        }
    }
    // Inputs weigh by the time they act; the start, where it is free, hardly.
    let freedom = |u: usize| match u.checked_sub(order) {
        None => 1e3,
        Some(node) => {
            let left = if node == 0 { 0.0 } else { times[node] - times[node - 1] };
            let right = times.get(node + 1).map_or(0.0, |next| next - times[node]);
            (2.0 * total / (left + right).max(1e-9 * total)).sqrt()
        }
    };
    let mut matrix = DMatrix::from_fn(rows.len(), unknowns, |r, u| rows[r][u] * freedom(u));
    for (r, value) in values.iter_mut().enumerate() {
        let size = matrix.row(r).norm();
        matrix.row_mut(r).scale_mut(1.0 / size);
        *value /= size;
    }
    let found = matrix.svd(true, true).solve(&DVector::from_vec(values), 1e-13).ok()?;
    let scaled = |u: usize| {
        let power = if u < order { u } else { order };
        found[u] * freedom(u) / total.powi(power as i32)
    };
    Some((0..unknowns).map(scaled).collect())
}

fn unit(n: usize, at: usize) -> DVector<f64> {
    DVector::from_fn(n, |i, _| f64::from(u8::from(i == at)))
}

/// Derivatives one piece of duration `h` later, as rows over the unknowns; the input is linear in between.
fn carried(state: &[DVector<f64>], h: f64, order: usize, node: usize, unknowns: usize) -> Vec<DVector<f64>> {
    let over = |n: usize| (1..=n).fold(1.0, |p, i| p * h / i as f64);
    let of = |i: usize| {
        let known = (i..order).fold(DVector::zeros(unknowns), |sum, j| sum + &state[j] * over(j - i));
        let m = order - i;
        let late = over(m) / (m + 1) as f64;
        known + unit(unknowns, order + node - 1) * (over(m) - late) + unit(unknowns, order + node) * late
    };
    (0..order).map(of).collect()
}

/// Lays an axis along the nodes by its inputs; what is given is set exactly.
fn lay(
    nodes: &mut [NodeState],
    times: &[f64],
    axis: usize,
    order: usize,
    inputs: &[f64],
    given: &[(usize, usize, f64)],
    model: WrenchModel,
) {
    nodes[0][axis][..order].copy_from_slice(&inputs[..order]);
    for (node, input) in nodes.iter_mut().zip(&inputs[order..]) {
        node[axis][order] = *input;
    }
    let exact = |nodes: &mut [NodeState], node: usize| {
        for &(_, i, value) in given.iter().filter(|g| g.0 == node) {
            nodes[node][axis][i] = value;
        }
    };
    exact(nodes, 0);
    for k in 1..times.len() {
        exact(nodes, k);
        let end = state_between(&nodes[k - 1], &nodes[k], times[k] - times[k - 1], times[k] - times[k - 1], model);
        nodes[k][axis][..order].copy_from_slice(&end[axis][..order]);
        exact(nodes, k);
    }
}

/// Adds a B-spline to an axis on the nodes from `first` on, so that the largest size of its derivative `peak` at a node
/// is `size`: joints stay as they are. `None` where there are too few nodes.
pub fn add_spline(motion: &mut Trajectory, axis: usize, first: usize, peak: usize, size: f64) -> Option<()> {
    let order = motion.model.orders()[axis];
    let knots: Vec<f64> = motion.times.get(first..first + order + 3)?.to_vec();
    let degree = order as i32 + 1;
    let scale = knots[order + 2] - knots[0];
    let weight = |j: usize| -> f64 {
        let others = (0..knots.len()).filter(|&i| i != j);
        others.map(|i| scale / (knots[j] - knots[i])).product()
    };
    let weights: Vec<f64> = (0..knots.len()).map(weight).collect();
    // Derivative i of (t - knot)_+^degree.
    let power = |t: f64, i: i32| -> f64 {
        let falling = (0..i).fold(1.0, |p, n| p * f64::from(degree - n));
        falling * (t.max(0.0) / scale).powi(degree - i) / scale.powi(i)
    };
    let value =
        |t: f64, i: usize| -> f64 { knots.iter().zip(&weights).map(|(knot, w)| w * power(t - knot, i as i32)).sum() };
    let inner = 1..order + 2;
    let most = inner.clone().map(|n| value(knots[n], peak).abs()).fold(0.0, f64::max);
    if !(most > 0.0 && most.is_finite()) {
        return None;
    }
    for n in inner {
        for i in 0..=order {
            motion.nodes[first + n][axis][i] += value(knots[n], i) * size / most;
        }
    }
    Some(())
}

/// Puts `more` nodes evenly into a piece; nothing else changes.
pub fn split(motion: &mut Trajectory, piece: usize, more: usize) {
    let h = motion.times[piece + 1] - motion.times[piece];
    let within = |i: usize| h * i as f64 / (more + 1) as f64;
    let nodes: Vec<NodeState> = (1..=more).map(|i| clean(motion.within(piece, within(i)), motion.model)).collect();
    let times: Vec<f64> = (1..=more).map(|i| motion.times[piece] + within(i)).collect();
    motion.nodes.splice(piece + 1..piece + 1, nodes);
    motion.times.splice(piece + 1..piece + 1, times);
    motion.waypoint_nodes.iter_mut().filter(|n| **n > piece).for_each(|n| *n += more);
}

/// Without the slope that stands above an input.
pub fn clean(mut state: NodeState, model: WrenchModel) -> NodeState {
    for (axis, order) in AXES.into_iter().zip(model.orders()) {
        state[axis][order + 1..].fill(0.0);
    }
    state
}

pub fn record(motion: &Trajectory) -> MotionRecord {
    let vertical = |s: &NodeState| match motion.model {
        WrenchModel::Exact => Vertical::Exact(s[Z]),
        _ => Vertical::Hover([s[Z][0], s[Z][1], s[Z][2]]),
    };
    MotionRecord {
        times_s: motion.times.clone(),
        x: motion.nodes.iter().map(|s| s[X]).collect(),
        y: motion.nodes.iter().map(|s| s[Y]).collect(),
        z: motion.nodes.iter().map(vertical).collect(),
        yaw: motion.nodes.iter().map(|s| [s[YAW][0], s[YAW][1], s[YAW][2]]).collect(),
        waypoint_nodes: motion.waypoint_nodes.clone(),
    }
}

/// What a record's numbers are as a motion; they may be nonsense, but have to be as many as there are nodes.
pub fn of_record(record: &MotionRecord, model: WrenchModel) -> Option<Trajectory> {
    let n = record.times_s.len();
    let lengths = [record.x.len(), record.y.len(), record.z.len(), record.yaw.len()];
    let fits = record.z.iter().all(|z| z.derivatives().len() == model.orders()[Z] + 1);
    if n < 2 || !fits || lengths.iter().any(|&l| l != n) {
        return None;
    }
    let node = |k: usize| {
        let mut state = [record.x[k], record.y[k], [0.0; 5], [0.0; 5]];
        let z = record.z[k].derivatives();
        state[Z][..z.len()].copy_from_slice(z);
        state[YAW][..3].copy_from_slice(&record.yaw[k]);
        state
    };
    Some(Trajectory {
        times: record.times_s.clone(),
        nodes: (0..n).map(node).collect(),
        waypoint_nodes: record.waypoint_nodes.clone(),
        model,
    })
}

/// The certificate that claims a motion to be a plan.
pub fn certificate(motion: &Trajectory, selected_by: &[Trajectory]) -> Certificate {
    let claim = PlanClaim {
        motion: record(motion),
        selected_by: selected_by.iter().map(record).collect(),
        without_yaw: vec![],
        least_time_s: None,
        weights: Vec::new(),
        recovery: None,
    };
    let model = if motion.model == WrenchModel::Exact { DynamicModel::Exact } else { DynamicModel::Hover };
    Certificate {
        schema: SCHEMA,
        spec_sha256: super::SHA.into(),
        model,
        capture_height_m: None,
        claim: Claim::Plan(claim),
    }
}
