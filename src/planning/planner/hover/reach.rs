//! Upper bounds on the reach and the cost of every plan, from the healthy set alone, without a program.

use super::{FEASIBLE, HoverPlanner, Layout};
use crate::actuation::Wrench;
use crate::planner::transcription::UNBOUNDED;
use crate::planner::yaw::YawPlan;

/// Bounds on inputs are widened by this factor in proofs, because rows hold to tolerances only. Chosen by hand.
pub(in crate::planning::planner) const LEEWAY: f64 = 1.001;

/// Number of directions in which the largest torque is evaluated. Chosen by hand.
const DIRECTIONS: usize = 64;

impl HoverPlanner<'_> {
    /// An upper bound on (48) over all feasible plans: the largest inputs that the healthy set allows, waypoints at the
    /// edge of their tolerance. `None` if yaw was planned first, because rows then depend on states too.
    pub(super) fn largest_cost(&self, layout: &Layout) -> Option<f64> {
        let bounded = self.mission().waypoints.iter().all(|w| w.within < UNBOUNDED || w.weight == 0.0);
        (bounded && matches!(layout.yaw, YawPlan::Free { .. })).then(|| self.cost_scale(layout))
    }

    /// The bound itself; if yaw was planned first, only an order of magnitude.
    pub(super) fn cost_scale(&self, layout: &Layout) -> f64 {
        let [snap, climb, turn] = self.largest_inputs();
        let plan = &self.model().plan;
        let inputs = plan.snap_weight * snap * snap + plan.acceleration_weight * (climb * climb + turn * turn);
        let misses =
            self.mission().waypoints.iter().map(|w| {
                w.weight * ((w.within + FEASIBLE).powi(2) + (w.yaw_within * (1.0 + FEASIBLE / w.within)).powi(2))
            });
        inputs * layout.flown.total + misses.sum::<f64>()
    }

    /// Upper bounds on the inputs that the healthy set allows: |(x'''', y'''')| (m/s^4, with one yaw throughout),
    /// |z''| (m/s^2) and |psi''| (rad/s^2).
    fn largest_inputs(&self) -> [f64; 3] {
        let zonotope = &self.healthy.zonotope;
        let reach = |n: Wrench| zonotope.support(&n).abs().max(zonotope.support(&-n).abs());
        let unit = |axis: usize| Wrench::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
        let vehicle = &self.model().vehicle;
        let [ixx, iyy, izz] = vehicle.inertia;
        // x^2 + y^2 does not depend on psi: it is (g tau_x / Ixx)^2 + (g tau_y / Iyy)^2. Its root is at most
        // the largest support over directions, and a circle about 2 n supporting lines is a little larger.
        let (roll, pitch) = (self.model().gravity / ixx, self.model().gravity / iyy);
        let slice = std::f64::consts::PI / DIRECTIONS as f64;
        let widest = (0..DIRECTIONS)
            .map(|i| {
                let (sin, cos) = (slice * i as f64).sin_cos();
                reach(Wrench::new(0.0, roll * cos, pitch * sin, 0.0))
            })
            .fold(0.0, f64::max);
        let snap = widest / (slice / 2.0).cos();
        // With rotors that reverse the least thrust is below zero.
        let (most, least) = (zonotope.support(&unit(0)), (-zonotope.support(&-unit(0))).min(0.0));
        let g = self.model().gravity;
        let climb = (most / vehicle.mass - g).abs().max(g - least / vehicle.mass);
        let turn = reach(unit(3)) / izz;
        [snap, climb, turn]
    }

    /// Whether some waypoint lies further from the start than the largest inputs carry the vehicle from rest:
    /// |x(t) - x(0)| <= t^4/4! max |x''''| and |z(t) - z(0)| <= t^2/2! max |z''|. Such short times are beyond the
    /// solver, whose numbers then span too many decades.
    pub(super) fn out_of_reach(&self, layout: &Layout) -> bool {
        if !self.mission().start_at_rest {
            return false;
        }
        let [snap, climb, _] = self.largest_inputs().map(|u| LEEWAY * u);
        let start = &self.mission().waypoints[0];
        self.mission().waypoints.iter().zip(&layout.flown.waypoint_nodes).any(|(w, &node)| {
            let t = layout.flown.node_times[node];
            let apart: [f64; 3] = std::array::from_fn(|i| w.position[i] - start.position[i]);
            let allowed = LEEWAY * (start.within + w.within + 2.0 * FEASIBLE);
            let horizontally = matches!(layout.yaw, YawPlan::Free { .. })
                && apart[0].hypot(apart[1]) - allowed > snap * t.powi(4) / 24.0;
            horizontally || apart[2].abs() - allowed > climb * t.powi(2) / 2.0
        })
    }
}
