//! A convex relaxation (74), whose infeasibility proves that there is no plan.
//!
//! The motion keeps its waypoints, rests and limits (the tilt cone among them), and its thrust m |a + g| stays within
//! the largest thrust of the set. Torques are left free.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner};
use crate::motion::time_grid::TimeGrid;
use crate::planner::hover::{FEASIBLE, LEEWAY};
use crate::planner::transcription::Purpose;
use crate::planner::transcription::RowAt;
use crate::qp::build::{Affine, Builder};
use crate::qp::{QuadraticProgram, RowOrigin};
use crate::solve::{Outcome, Solution, solve_graded};
use std::collections::BTreeSet;

/// The largest thrust of a set, with the multipliers that prove it.
#[derive(Debug, Clone, PartialEq)]
pub struct MostThrust {
    /// N
    pub newtons: f64,
    /// One per row of the set, N: `T <= sum of weight x offset`, because the normals with these weights add up to the
    /// axis of T.
    pub weights: Vec<f64>,
}

/// The relaxation as a program that is always feasible.
pub struct Relaxed {
    pub program: QuadraticProgram,
    /// The unit of time that scales its variables at each node, s.
    pub taus: Vec<f64>,
    pub thrust: MostThrust,
}

/// The outcome of the relaxation over a time grid.
pub(super) enum RelaxationOutcome {
    /// Proved infeasible by multipliers that are checked in plain arithmetic; they are left in
    /// `HoverPlanner::weights` by row.
    Infeasible,
    /// The solution of least cost, which keeps every limit at the nodes; `None` where none was found.
    Feasible(Option<Iterate>),
}

impl ScpPlanner<'_, '_> {
    /// Solves the relaxation over a time grid (without holds).
    pub(super) fn relaxed(&mut self, grid: &TimeGrid) -> RelaxationOutcome {
        self.hover.weights.clear();
        let thrust = self.most_thrust().newtons;
        if !self.environment.has_drag() && self.out_of_reach(grid, thrust) {
            return RelaxationOutcome::Infeasible;
        }
        let form = self.transcription(grid, &[]);
        let rows: BTreeSet<RowAt> = self.limits_at_nodes(grid, |_| true).collect();
        let program = |rows: &[RowAt]| form.relaxed_program(Purpose::Plan { slack: FEASIBLE }, rows, thrust);
        let (program, outcome) = self.solve_with_volumes(&form, rows, PARTS, program);
        let iterate = match outcome {
            // The proof is not extended to drag: its bounds on inputs assume that the thrust bounds the acceleration.
            Outcome::Infeasible { .. } if self.environment.has_drag() => None,
            Outcome::Infeasible { certificate } => {
                self.hover.weights = program.weights(&certificate);
                return RelaxationOutcome::Infeasible;
            }
            Outcome::Solved(Solution { x, .. }) => {
                Some(Iterate { grid: grid.clone(), states: form.states(&x), model: self.wrench })
            }
            Outcome::Inconclusive { .. } => None,
        };
        RelaxationOutcome::Feasible(iterate)
    }

    /// The relaxation over a time grid (without holds) that minimises by how much waypoints are overshot, m, plus
    /// `epsilon` times the inputs' cost.
    pub fn overshoot(&mut self, grid: &TimeGrid, epsilon: f64) -> Relaxed {
        let thrust = self.most_thrust();
        let form = self.transcription(grid, &[]);
        let rows: BTreeSet<RowAt> = self.limits_at_nodes(grid, |_| true).collect();
        let program = |rows: &[RowAt]| form.relaxed_program(Purpose::Overshoot { epsilon }, rows, thrust.newtons);
        let program = match self.has_many_volumes(grid) {
            true => self.solve_with_volumes(&form, rows, PARTS, program).0,
            false => program(&rows.into_iter().collect::<Vec<_>>()),
        };
        Relaxed { program, taus: form.taus(), thrust }
    }

    /// Whether some waypoint lies further from the start than the largest acceleration, thrust / m + g, carries the
    /// vehicle from rest in time. Such short times are beyond the solver, whose numbers then span too many decades.
    fn out_of_reach(&self, grid: &TimeGrid, thrust: f64) -> bool {
        let (model, mission) = (self.model(), self.mission());
        let most = LEEWAY * (thrust / model.vehicle.mass + model.gravity);
        let start = &mission.waypoints[0];
        mission.start_at_rest
            && mission.waypoints.iter().zip(&grid.waypoint_nodes).any(|(w, &node)| {
                let apart = (0..3).map(|i| (w.position[i] - start.position[i]).powi(2)).sum::<f64>().sqrt();
                let allowed = LEEWAY * (start.within + w.within + 2.0 * FEASIBLE);
                apart - allowed > 0.5 * most * grid.node_times[node].powi(2)
            })
    }

    /// The largest thrust of the set over all torques.
    fn most_thrust(&mut self) -> MostThrust {
        let mut builder = Builder::new(4);
        let scale = self.model().vehicle.rotors.iter().map(crate::model::Rotor::max_thrust).sum::<f64>();
        // Thrust in units of full thrust, torques in those of the rows.
        let sides = |equality: bool| if equality { &[1.0, -1.0][..] } else { &[1.0] };
        let mut of_row = Vec::new();
        for (facet, row) in self.set.rows.iter().enumerate() {
            for side in sides(row.equality) {
                let mut slack = Affine::constant(side * row.offset);
                for (i, n) in row.normal.iter().enumerate() {
                    slack = slack.plus(i, -side * n * if i == 0 { scale } else { 1.0 });
                }
                builder.nonnegative(slack, RowOrigin::Facet { facet, node: 0 });
                of_row.push((facet, side * scale));
            }
        }
        builder.linear(0, -1.0);
        let (outcome, effort) = solve_graded(&builder.finish());
        self.hover.effort += effort;
        let mut weights = vec![0.0; self.set.rows.len()];
        // The dual objective bounds the thrust from above.
        let Outcome::Solved(solution) = outcome else { return MostThrust { newtons: scale, weights } };
        for (&(facet, factor), z) in of_row.iter().zip(&solution.z) {
            weights[facet] += factor * z;
        }
        MostThrust { newtons: (-solution.bound).min(1.0) * scale, weights }
    }
}
