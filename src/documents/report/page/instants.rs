//! The instants at which a long trajectory is drawn.

use crate::motion::Trajectory;

/// Instants at a fixed rate (Hz), together with the waypoints' nodes and the end, s.
pub fn instants(trajectory: &Trajectory, rate: f64) -> Vec<f64> {
    let end = trajectory.duration();
    let waypoints: Vec<f64> = trajectory.waypoint_nodes.iter().map(|&n| trajectory.times[n]).collect();
    let mut times: Vec<f64> = (0..).map(|i| f64::from(i) / rate).take_while(|&t| t < end).collect();
    times.extend(&waypoints);
    times.push(end);
    times.sort_by(f64::total_cmp);
    // Where a waypoint coincides with a regular instant up to rounding, the waypoint is kept.
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
