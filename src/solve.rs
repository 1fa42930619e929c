//! The only room that knows Clarabel. A verdict is data, and each is checked in plain arithmetic before it
//! is believed.

use crate::qp::{Cone, QuadraticProgram, Sparse};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use std::time::{Duration, Instant};

/// A row may be missed by this much (rows are of order one).
pub const PRIMAL_TOLERANCE: f64 = 1e-6;

/// Iterations after which a solve ends without a verdict. Programs here take 8 to 60; one that takes more has
/// stalled, and another form of it is quicker.
const MOST_ITERATIONS: u32 = 80;

#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    pub x: Vec<f64>,
    /// Multipliers: P x + q + A'z = 0, z in the dual cone.
    pub z: Vec<f64>,
    /// Value of the program at x.
    pub objective: f64,
    /// No feasible point with entries up to [`reach()`] has a smaller objective: the value of the dual function at z,
    /// less what its residual could make up for.
    pub bound: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    Solved(Solution),
    /// A'z = 0, b'z < 0, z in the dual cone: nothing within [`reach`] satisfies all rows.
    Infeasible {
        certificate: Vec<f64>,
    },
    /// The solver stopped without a verdict that can be shown.
    Inconclusive {
        status: String,
        /// Where it stopped, if it got anywhere.
        point: Option<Vec<f64>>,
    },
}

/// What the solver did, summed over calls.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Effort {
    pub solves: usize,
    pub iterations: usize,
    /// Initial guesses that searches for a time began with.
    pub starts: usize,
    /// Time inside the solver's calls.
    pub time: Duration,
}

impl std::ops::AddAssign for Effort {
    fn add_assign(&mut self, other: Effort) {
        self.solves += other.solves;
        self.iterations += other.iterations;
        self.starts += other.starts;
        self.time += other.time;
    }
}

/// Residuals of the optimality conditions, absolute, in the program's own scaling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals {
    /// Distance of b - A x from the cone.
    pub primal: f64,
    /// Largest entry of P x + q + A'z.
    pub stationarity: f64,
    /// Distance of z from the dual cone.
    pub dual: f64,
    /// |s'z|
    pub complementarity: f64,
}

/// KKT residuals of a solution, from the program's data alone.
pub fn residuals(program: &QuadraticProgram, solution: &Solution) -> Residuals {
    let s = program.slack(&solution.x);
    let mut gradient = program.hessian_times(&solution.x);
    for (g, (q, az)) in gradient.iter_mut().zip(program.q.iter().zip(program.a.transposed_times(&solution.z))) {
        *g += q + az;
    }
    Residuals {
        primal: program.cone_violation(&s),
        stationarity: gradient.iter().fold(0.0, |m, v| m.max(v.abs())),
        dual: program.dual_violation(&solution.z),
        complementarity: s.iter().zip(&solution.z).map(|(s, z)| s * z).sum::<f64>().abs(),
    }
}

fn matrix(m: &Sparse) -> CscMatrix<f64> {
    CscMatrix::new(m.rows, m.cols, m.colptr.clone(), m.rowval.clone(), m.nzval.clone())
}

/// Programs with more second-order cones or more variables than this are first solved without Clarabel's own scaling of
/// rows and columns (measured: it scales a cone only as a whole, and missions with a cone or two at each node take three
/// times the iterations with it and end without a verdict far more often; so do programs in stage variables for long
/// missions or fine grids).
const SCALED: (usize, usize) = (32, 4_500);

/// The solver's tolerance on the gap, absolute and relative: its own default, and that of steps.
const GAP: f64 = 1e-8;
const STEP_GAP: f64 = 1e-6;

/// How closely a program is solved.
#[derive(Clone, Copy)]
struct Tolerance {
    /// Between primal and dual objective, absolute and relative.
    gap: f64,
    /// What the solver adds to the diagonal of its linear systems; refinement takes it off the solution again.
    regularization: f64,
    /// Residual of its linear systems, relative and absolute, at which refinement ends.
    refinement: (f64, f64),
}

/// For verdicts and plans of the hover model; regularisation and refinement are the solver's defaults.
const CLOSE: Tolerance = Tolerance { gap: GAP, regularization: 1e-8, refinement: (1e-13, 1e-12) };

/// For steps. The regularisation is ten times the solver's default (measured on programs of steps of three missions, every
/// sixth and all that were not solved to tolerance: of 165 programs that the solver scales 75 ended with a numerical error,
/// and of 44 that it does not scale 6; with this none does). The programs of the hover model have no need of it, and their
/// refinement took a fifth more time. Refinement to the solver's default residual took a quarter of an iteration's time, and as
/// many iterations (measured on five missions).
const STEP: Tolerance = Tolerance { gap: STEP_GAP, regularization: 1e-7, refinement: (1e-10, 1e-10) };
const GRADED: Tolerance = Tolerance { gap: GAP, regularization: STEP.regularization, ..CLOSE };

/// Solves a program on one thread; the same program gives the same bytes.
///
/// Where the solver stops without a verdict it is asked again with its scaling the other way: on or off.
pub fn solve(program: &QuadraticProgram) -> (Outcome, Effort) {
    decide(program, CLOSE)
}

/// The same with more regularisation: for programs of the exact model, whose grids have short pieces beside long ones, and for
/// multipliers that prove something.
pub fn solve_graded(program: &QuadraticProgram) -> (Outcome, Effort) {
    decide(program, GRADED)
}

fn decide(program: &QuadraticProgram, tolerance: Tolerance) -> (Outcome, Effort) {
    let cones = program.cones.iter().filter(|c| matches!(c, Cone::SecondOrder(_))).count();
    let scaled = cones <= SCALED.0 && program.q.len() <= SCALED.1;
    let (outcome, mut effort) = attempt(program, scaled, tolerance);
    let Outcome::Inconclusive { point, .. } = outcome else { return (outcome, effort) };
    let (mut again, more) = attempt(program, !scaled, tolerance);
    effort += more;
    if let Outcome::Inconclusive { point: None, status } = again {
        again = Outcome::Inconclusive { point, status };
    }
    (again, effort)
}

/// A point of a program good enough for a step of a sequence that measures what it reaches.
#[derive(Debug, Clone)]
pub struct StepSolution {
    pub solution: Solution,
    /// Whether the solver met its tolerances, or its reduced ones; otherwise it stopped early.
    pub is_optimal: bool,
}

/// A point that keeps the rows of a program to [`PRIMAL_TOLERANCE`], and its multipliers; `scaled` is whether the solver scales
/// rows and columns.
pub fn solve_step(program: &QuadraticProgram, scaled: bool) -> (Option<StepSolution>, Effort) {
    let (raw, effort) = call(program, scaled, STEP);
    let Some(Raw { status, x, z }) = raw else { return (None, effort) };
    let is_optimal = matches!(status, SolverStatus::Solved | SolverStatus::AlmostSolved);
    let stopped = matches!(
        status,
        SolverStatus::InsufficientProgress | SolverStatus::NumericalError | SolverStatus::MaxIterations
    );
    let holds = (is_optimal || stopped)
        && x.iter().chain(&z).all(|v| v.is_finite())
        && program.cone_violation(&program.slack(&x)) <= PRIMAL_TOLERANCE;
    let objective = program.objective(&x);
    let solution = Solution { bound: f64::NEG_INFINITY, objective, x, z };
    (holds.then_some(StepSolution { solution, is_optimal }), effort)
}

/// What the solver left.
struct Raw {
    status: SolverStatus,
    x: Vec<f64>,
    z: Vec<f64>,
}

/// One call of the solver, with or without its own scaling.
fn attempt(program: &QuadraticProgram, scaled: bool, tolerance: Tolerance) -> (Outcome, Effort) {
    match call(program, scaled, tolerance) {
        (Some(Raw { status, x, z }), effort) => (judge(program, status, x, z), effort),
        (None, effort) => {
            let status = "the program holds a number that is not finite, or the solver refused it".into();
            (Outcome::Inconclusive { status, point: None }, effort)
        }
    }
}

/// `None` where the program holds a number that is not finite or the solver refuses it.
fn call(program: &QuadraticProgram, scaled: bool, tolerance: Tolerance) -> (Option<Raw>, Effort) {
    let finite = |v: &[f64]| v.iter().all(|x| x.is_finite());
    if ![&program.p.nzval[..], &program.q, &program.a.nzval, &program.b].into_iter().all(finite) {
        return (None, Effort::default());
    }
    let cones: Vec<SupportedConeT<f64>> = program
        .cones
        .iter()
        .map(|c| match *c {
            Cone::Zero(n) => SupportedConeT::ZeroConeT(n),
            Cone::Nonnegative(n) => SupportedConeT::NonnegativeConeT(n),
            Cone::SecondOrder(n) => SupportedConeT::SecondOrderConeT(n),
        })
        .collect();
    let settings = DefaultSettings {
        verbose: false,
        max_threads: 1,
        presolve_enable: false,
        max_iter: MOST_ITERATIONS,
        equilibrate_enable: scaled,
        static_regularization_constant: tolerance.regularization,
        iterative_refinement_reltol: tolerance.refinement.0,
        iterative_refinement_abstol: tolerance.refinement.1,
        tol_gap_abs: tolerance.gap,
        tol_gap_rel: tolerance.gap,
        ..DefaultSettings::default()
    };
    let begin = Instant::now();
    let solver = DefaultSolver::new(&matrix(&program.p), &program.q, &matrix(&program.a), &program.b, &cones, settings);
    let Ok(mut solver) = solver else { return (None, Effort::default()) };
    solver.solve();
    let iterations = solver.solution.iterations as usize;
    let effort = Effort { solves: 1, iterations, starts: 0, time: begin.elapsed() };
    let found = solver.solution;
    (Some(Raw { status: found.status, x: found.x, z: found.z }), effort)
}

/// Entries of points that count, in the program's scaling: ten times the largest number on a right-hand side (which
/// holds the waypoints), at least 100. Proofs in floating point need some such bound.
pub fn reach(program: &QuadraticProgram) -> f64 {
    program.b.iter().fold(10.0_f64, |m, b| m.max(b.abs())) * 10.0
}

/// Believes a status only where plain arithmetic agrees.
fn judge(program: &QuadraticProgram, status: SolverStatus, x: Vec<f64>, z: Vec<f64>) -> Outcome {
    let stopped = |x: Option<Vec<f64>>| Outcome::Inconclusive { status: format!("{status:?}"), point: x };
    match status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            let objective = program.objective(&x);
            let px = program.hessian_times(&x);
            let quadratic: f64 = x.iter().zip(&px).map(|(x, p)| x * p).sum();
            let bz: f64 = program.b.iter().zip(&z).map(|(b, z)| b * z).sum();
            // f(y) >= f(x) + f'(x)(y - x) and f'(x) = r - A'z, so r'(y - x) is all that can be missing.
            let reach = reach(program);
            let mut residual = px;
            for (r, (q, az)) in residual.iter_mut().zip(program.q.iter().zip(program.a.transposed_times(&z))) {
                *r += q + az;
            }
            let missing: f64 = residual.iter().zip(&x).map(|(r, x)| r.abs() * (reach + x.abs())).sum();
            let bound = program.constant - 0.5 * quadratic - bz - missing;
            let solution = Solution { bound, objective, x, z };
            let r = residuals(program, &solution);
            let scale = 1.0 + objective.abs();
            let loose = if status == SolverStatus::Solved { 1e3 } else { 1.0 };
            let good = r.primal <= PRIMAL_TOLERANCE
                && r.dual <= 1e-6 * scale * loose
                && r.stationarity <= 1e-6 * scale * loose
                && (solution.objective - solution.bound - missing).abs() <= 1e-6 * scale * loose;
            if good { Outcome::Solved(solution) } else { stopped(Some(solution.x)) }
        }
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
            let bz: f64 = program.b.iter().zip(&z).map(|(b, z)| b * z).sum();
            // 0 <= z's = z'b - (A'z)'x < 0 for every x whose entries are within reach.
            let residual: f64 = program.a.transposed_times(&z).iter().map(|v| v.abs()).sum();
            if bz < 0.0 && residual * reach(program) < 0.5 * bz.abs() && program.dual_violation(&z) <= 1e-9 * bz.abs() {
                Outcome::Infeasible { certificate: z }
            } else {
                stopped(None)
            }
        }
        _ => stopped(None),
    }
}
