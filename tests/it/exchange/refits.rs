//! Polynomials of a Crazyflie: as many as are needed, within the tolerance, joined with continuous acceleration.

use super::{Planned, close, table, turn};
use mavc::exchange::trajectory::{Choices, Format, write};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, YAW, state_between};

/// A trajectory with steps of 0.3 s whose fifth derivatives jump.
fn rough(count: usize) -> Trajectory {
    let h = 0.3;
    let mut nodes = vec![NodeState::default()];
    for k in 0..count {
        let left = nodes[k];
        let mut right = left;
        for axis in 0..4 {
            right[axis][if axis == YAW { 2 } else { 4 }] =
                (1.7 * k as f64 + axis as f64).sin() * if axis == YAW { 2.0 } else { 60.0 };
        }
        nodes.push(state_between(&left, &right, h, h, WrenchModel::Exact));
    }
    let times = (0..=count).map(|k| h * k as f64).collect();
    Trajectory { times, nodes, waypoint_nodes: vec![0, count], model: WrenchModel::Exact }
}

fn refitted(planned: &Planned, trajectory: &Trajectory, tolerance: f64) -> Result<(Vec<Vec<f64>>, String), String> {
    let choices = Choices { format: Format::Crazyflie, tolerance: Some(tolerance), ..Choices::default() };
    let written = write(trajectory, planned.model(), &choices)?;
    let text = String::from_utf8(written.bytes).unwrap();
    let (names, rows) = table(&text);
    assert!(names.len() == 33 && text.starts_with("duration,x^0,x^1,") && names[32] == "yaw^7");
    assert!((2..=31).contains(&rows.len()), "{}", rows.len());
    // What a Crazyflie gets.
    let rows = rows.iter().map(|row| row.iter().map(|cell| f64::from(*cell as f32)).collect()).collect();
    Ok((rows, written.remark.unwrap()))
}

/// Derivative `order` of the axis `t` s after the start of a piece.
fn value(row: &[f64], axis: usize, order: usize, t: f64) -> f64 {
    let falling = |i: usize| (0..order).map(|k| (i - k) as f64).product::<f64>();
    (order..8).map(|i| row[1 + 8 * axis + i] * falling(i) * t.powi((i - order) as i32)).sum()
}

/// Largest errors of position and yaw; the joints are checked on the way.
fn errors(rows: &[Vec<f64>], trajectory: &Trajectory) -> [f64; 2] {
    let (mut begin, mut worst) = (0.0, [0.0f64; 2]);
    for (k, row) in rows.iter().enumerate() {
        for i in 0..=100 {
            let t = row[0] * f64::from(i) / 100.0;
            let state = trajectory.at(begin + t);
            let off: [f64; 4] = std::array::from_fn(|axis| value(row, axis, 0, t) - state[axis][0]);
            worst[0] = worst[0].max(off[..3].iter().map(|d| d * d).sum::<f64>().sqrt());
            worst[1] = worst[1].max(off[3].abs());
        }
        if let Some(next) = rows.get(k + 1) {
            for order in 0..3 {
                let [end, start] =
                    [(row, row[0]), (next, 0.0)].map(|(row, t)| [0, 1, 2, 3].map(|axis| value(row, axis, order, t)));
                let size = end.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
                // Seven digits of a coefficient of t^7, seconds after the beginning of its piece.
                close(&end, &start, 5e-5 * size, "joint");
            }
        }
        begin += row[0];
    }
    close(&[begin], &[trajectory.duration()], 1e-5, "duration");
    worst
}

/// A tolerance that a message proposes is one that the same plan reaches.
#[test]
fn a_proposed_tolerance_is_enough() {
    let planned = turn();
    let mut refused = 0;
    for count in [40, 90, 150] {
        let trajectory = rough(count);
        for tolerance in [1e-6, 1e-4, 3e-3, 1e-2] {
            let Err(message) = refitted(planned, &trajectory, tolerance) else { continue };
            refused += 1;
            let proposed = message.split("use --tolerance ").nth(1).unwrap().split("mm").next().unwrap();
            let proposed = 1e-3 * proposed.parse::<f64>().unwrap();
            assert!(proposed > tolerance, "{message}");
            let (rows, _) = refitted(planned, &trajectory, proposed).unwrap_or_else(|e| panic!("{message}\n{e}"));
            let [position, yaw] = errors(&rows, &trajectory);
            assert!(position <= 1.01 * proposed && yaw <= 1.01 * proposed, "{proposed} {position} {yaw}");
        }
    }
    assert!(refused >= 6, "{refused}");
}

#[test]
fn the_refit_is_within_the_tolerance() {
    let planned = turn();
    for tolerance in [0.05, 0.01, 1e-3] {
        let (rows, remark) = refitted(planned, &planned.trajectory, tolerance).unwrap();
        let [position, yaw] = errors(&rows, &planned.trajectory);
        assert!(position <= tolerance && yaw <= tolerance, "{position} {yaw}");
        let stated: f64 =
            remark.split("position within ").nth(1).unwrap().split(" mm").next().unwrap().parse().unwrap();
        assert!((1e3 * position - stated).abs() <= 0.02 * stated, "{position} {remark}");
    }
    let count = |tolerance| refitted(planned, &planned.trajectory, tolerance).unwrap().0.len();
    assert!(count(1e-3) > count(0.05), "fewer pieces where they suffice");
}

#[test]
fn what_does_not_fit_is_refused_with_a_tolerance_that_does() {
    let (planned, trajectory) = (turn(), rough(80));
    let why = refitted(planned, &trajectory, 1e-5).unwrap_err();
    assert!(why.starts_with("the trajectory does not fit the 31 pieces of a Crazyflie within 0.01 mm"), "{why}");
    let suggested: f64 = why.split("--tolerance ").nth(1).unwrap().split("mm").next().unwrap().parse().unwrap();
    let (rows, _) = refitted(planned, &trajectory, 1e-3 * suggested).unwrap();
    let [position, yaw] = errors(&rows, &trajectory);
    assert!(position.max(yaw) <= 1e-3 * suggested, "{position} {yaw} {suggested}");
    assert!(position.max(yaw) > 1e-5);
}

/// Loaders fail on one piece; one interval is cut in two. A tolerance below what float32 takes is refused, not sought
/// for ever.
#[test]
fn the_smallest_and_the_finest() {
    let planned = turn();
    let trajectory = rough(1);
    let (rows, _) = refitted(planned, &trajectory, 1e-3).unwrap();
    assert_eq!(rows.len(), 2);
    assert!(errors(&rows, &trajectory)[0] < 1e-6);
    let mut far = rough(3);
    far.nodes.iter_mut().for_each(|node| node[0][0] += 3000.0);
    assert!(refitted(planned, &far, 1e-6).unwrap_err().contains("does not fit"));
}
