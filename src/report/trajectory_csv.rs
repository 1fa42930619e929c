//! The trajectory table that scripts rely on.

use crate::admissible::allocation::Allocator;
use crate::model::Model;
use crate::planner::hover_model::{X, Y, YAW, Z};
use crate::trajectory::{Trajectory, roll_pitch};

/// Instants of the table: every node, or a fixed rate with the waypoints' nodes kept.
pub fn instants(trajectory: &Trajectory, rate: Option<f64>) -> Vec<f64> {
    let Some(rate) = rate else { return trajectory.times.clone() };
    let end = trajectory.duration();
    let mut times: Vec<f64> = (0..).map(|i| f64::from(i) / rate).take_while(|&t| t < end).collect();
    times.extend(trajectory.waypoint_nodes.iter().map(|&n| trajectory.times[n]));
    times.push(end);
    times.sort_by(f64::total_cmp);
    // A waypoint that falls on the raster up to rounding is kept, the raster's row is not.
    let waypoints: Vec<f64> = trajectory.waypoint_nodes.iter().map(|&n| trajectory.times[n]).collect();
    let near = 1e-9 * end.max(1.0);
    let mut kept: Vec<f64> = Vec::with_capacity(times.len());
    for t in times {
        match kept.last_mut() {
            Some(last) if t - *last <= near => {
                if waypoints.contains(&t) {
                    *last = t;
                }
            }
            _ => kept.push(t),
        }
    }
    kept
}

/// The table as CSV text, one line per instant, shortest round-trip numbers, `\n` line ends.
pub fn render(trajectory: &Trajectory, model: &Model, rate: Option<f64>) -> String {
    let allocator = Allocator::new(&model.vehicle);
    let mut out = String::from(
        "t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax,ay,az,yaw_acc,jx,jy,jz,sx,sy,sz,roll,pitch,thrust,tau_x,tau_y,tau_z",
    );
    for k in 1..=model.vehicle.rotors.len() {
        out.push_str(&format!(",omega_{k}"));
    }
    out.push('\n');
    for t in instants(trajectory, rate) {
        let s = trajectory.at(t);
        let (roll, pitch) = roll_pitch(&s, model.gravity);
        let wrench = trajectory.wrench(&model.vehicle, model.gravity, &s);
        let mut row = vec![t];
        row.extend([s[X][0], s[Y][0], s[Z][0], s[YAW][0]]);
        row.extend([s[X][1], s[Y][1], s[Z][1], s[YAW][1]]);
        row.extend([s[X][2], s[Y][2], s[Z][2], s[YAW][2]]);
        row.extend([s[X][3], s[Y][3], s[Z][3]]);
        row.extend([s[X][4], s[Y][4], s[Z][4]]);
        row.extend([roll, pitch]);
        row.extend(wrench.iter());
        row.extend(allocator.speeds(&wrench));
        push_row(&mut out, &row);
    }
    out
}

/// Adds a line of numbers, each the shortest text that reads back as the same number; no `-0`.
pub fn push_row(out: &mut String, row: &[f64]) {
    for (k, v) in row.iter().enumerate() {
        if k > 0 {
            out.push(',');
        }
        push_shortest(out, *v);
    }
    out.push('\n');
}

/// Adds the shortest text that reads back as the same number; no `-0`.
fn push_shortest(out: &mut String, v: f64) {
    use std::fmt::Write;
    let v = if v == 0.0 { 0.0 } else { v };
    let written = match v != 0.0 && (v.abs() < 1e-5 || v.abs() >= 1e15) {
        true => write!(out, "{v:e}"),
        false => write!(out, "{v}"),
    };
    written.expect("a string takes what is written");
}

/// The shortest text that reads back as the same number; no `-0`.
pub fn shortest(v: f64) -> String {
    let mut text = String::new();
    push_shortest(&mut text, v);
    text
}
