//! Solving programs with Clarabel, by the crate `mavc-solver`. No other module imports it.
//!
//! A result of the solver is reported only after it has been checked in plain arithmetic on the program's data:
//! `docs/method/hover-model.md`.

use crate::cancel;
use crate::qp::{Cone, QuadraticProgram, Sparse};
use mavc_solver::{Conic, CscMatrix, DefaultSettings, Ended, SolverStatus, Stop, SupportedConeT};
use std::time::{Duration, Instant};

/// The largest violation of a row in a solution; rows are scaled to order one.
const PRIMAL_TOLERANCE: f64 = 1e-6;

/// Iterations after which the solver stops. The programs of this crate take 8 to 60; one that takes more has stalled,
/// and another form of it is solved faster.
const MOST_ITERATIONS: u32 = 80;

/// A solution of a program with n variables and m rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The variables (n).
    pub x: Vec<f64>,
    /// The multipliers (m): P x + q + A'z = 0, z in the dual cone.
    pub z: Vec<f64>,
    /// The objective at x.
    pub objective: f64,
    /// A lower bound on the objective of every feasible point whose entries are at most [`reach()`]: the dual value at
    /// z, lowered by what the residual of stationarity could make up for. Minus infinity in the result of `solve_step`.
    pub bound: f64,
}

/// The result of a solve.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The program has this solution.
    Solved(Solution),
    /// No point whose entries are at most [`reach()`] satisfies all rows.
    Infeasible {
        /// Multipliers z (m) in the dual cone with b'z < 0 and A'z close to 0.
        certificate: Vec<f64>,
    },
    /// The solver stopped without a result that the checks confirm.
    Inconclusive {
        /// The solver's status, or why it did not start.
        status: String,
        /// The variables (n) where it stopped, if there are any.
        point: Option<Vec<f64>>,
    },
}

/// The solver's work, summed over calls.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Effort {
    /// Number of programs given to the solver; a second attempt counts again.
    pub solves: usize,
    /// Iterations of the solver.
    pub iterations: usize,
    /// Iterations, each times the entries of its program's matrices, rows and variables: proportional to the solver's
    /// time within a factor of three (docs/performance.md), and the same on every machine.
    pub work: u64,
    /// Initial guesses from which searches for a mission time started.
    pub starts: usize,
    /// Wall time inside the solver.
    pub time: Duration,
}

impl std::ops::AddAssign for Effort {
    fn add_assign(&mut self, other: Effort) {
        self.solves += other.solves;
        self.iterations += other.iterations;
        self.work += other.work;
        self.starts += other.starts;
        self.time += other.time;
    }
}

/// Absolute residuals of the optimality (KKT) conditions, in the program's own scaling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals {
    /// The violation of b - A x in K.
    pub primal: f64,
    /// The largest |entry| of P x + q + A'z.
    pub stationarity: f64,
    /// The violation of z in the dual cone.
    pub dual: f64,
    /// |s'z| with s = b - A x.
    pub complementarity: f64,
}

/// The residuals of a solution, computed from the program's data.
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

/// Programs with more second-order cones or more variables than this are first solved without Clarabel's equilibration
/// of rows and columns. It scales a cone only as a whole: with it, missions with a cone or two at each node took three
/// times the iterations and ended without a verdict far more often, and so did programs in stage variables for long
/// missions or fine grids (measured).
const SCALED: (usize, usize) = (32, 4_500);

/// The accuracy to which a program is solved.
#[derive(Clone, Copy)]
struct Tolerance {
    /// Duality gap, absolute and relative.
    gap: f64,
    /// Residuals of the rows and of stationarity, relative.
    feasibility: f64,
    /// Static regularisation of the solver's linear systems, whose effect iterative refinement removes from the
    /// solution.
    regularization: f64,
    /// Residual of the linear systems at which refinement ends, relative and absolute.
    refinement: (f64, f64),
}

/// For verdicts, and for plans of the hover model: the solver's defaults.
const CLOSE: Tolerance = Tolerance { gap: 1e-8, feasibility: 1e-8, regularization: 1e-8, refinement: (1e-13, 1e-12) };

/// For steps of a sequence, which evaluates what they reach.
///
/// With residuals of 1e-8 a third of the programs of 200 intervals took all iterations and ended no closer. In the
/// differences from an iterate a gap of 1e-4 and residuals of 1e-5 took 0.67 and 0.74 times the work of 1e-5 and 1e-6
/// (RIP on `slalom_quad` and `pick_x8` of `benches/missions/known`), with times of flight the same to 0.8 %. Residuals
/// of 1e-4, as large as the margin of the steps, took less still, and a curve of the paper was not planned.
///
/// The regularisation is ten times the solver's default. Measured on programs of steps of three missions (every sixth,
/// and all that were not solved to tolerance): with the default, 75 of 165 programs with equilibration and 6 of 44
/// without ended with a numerical error; with this value none does. Programs of the hover model do not need it, and
/// their refinement took a fifth more time with it.
///
/// Refinement to the solver's default residual took a quarter of the time of an iteration and saved no iterations
/// (measured on five missions).
const STEP: Tolerance = Tolerance { gap: 1e-4, feasibility: 1e-5, regularization: 1e-7, refinement: (1e-10, 1e-10) };

/// For [`solve_graded`].
const GRADED: Tolerance = Tolerance { regularization: STEP.regularization, ..CLOSE };

/// Solves a program on one thread. The result is deterministic: equal programs give equal bits.
///
/// If the solver stops without a verdict, the program is solved a second time with equilibration switched on if it was
/// off, and off if it was on. A program with a number that is not finite is [`Outcome::Inconclusive`].
pub fn solve(program: &QuadraticProgram) -> (Outcome, Effort) {
    decide(program, CLOSE)
}

/// Solves a program with more regularisation than [`solve`]: for programs of the exact model, whose graded grids have
/// short intervals next to long ones, and for multipliers that are used in a proof.
pub(crate) fn solve_graded(program: &QuadraticProgram) -> (Outcome, Effort) {
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

/// A point that is accurate enough for a step of sequential convex programming, which evaluates what the step reaches.
#[derive(Debug, Clone)]
pub(crate) struct StepSolution {
    pub(crate) solution: Solution,
    /// Whether the solver met its tolerances or its reduced tolerances; otherwise it stopped early.
    pub(crate) is_optimal: bool,
}

/// A point that satisfies the rows of a program to [`PRIMAL_TOLERANCE`], with its multipliers; `None` if the solver
/// reaches none. `scaled` switches the solver's equilibration of rows and columns on.
///
/// The solver gets the program in the differences from a point near the solution: its tolerances are relative, and
/// large terms that cancel would leave it no digits.
pub(crate) fn solve_step(program: &QuadraticProgram, scaled: bool, near: &[f64]) -> (Option<StepSolution>, Effort) {
    let (raw, effort) = call(program, scaled, STEP, near);
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

/// The solver's unchecked result.
struct Raw {
    status: SolverStatus,
    x: Vec<f64>,
    z: Vec<f64>,
}

/// One checked call of the solver, with or without its equilibration.
fn attempt(program: &QuadraticProgram, scaled: bool, tolerance: Tolerance) -> (Outcome, Effort) {
    match call(program, scaled, tolerance, &[]) {
        (Some(Raw { status, x, z }), effort) => (judge(program, status, x, z), effort),
        (None, effort) => {
            let status = "the program contains a number that is not finite, or the solver rejected it".into();
            (Outcome::Inconclusive { status, point: None }, effort)
        }
    }
}

/// One call of the solver, on the program in the differences from `near` unless that is empty; `None` if the program
/// contains a number that is not finite or the solver rejects it.
fn call(program: &QuadraticProgram, scaled: bool, tolerance: Tolerance, near: &[f64]) -> (Option<Raw>, Effort) {
    let finite = |v: &[f64]| v.iter().all(|x| x.is_finite());
    // P (near + d) + q and b - A (near + d)
    let (mut q, mut b) = (program.q.clone(), program.b.clone());
    if !near.is_empty() {
        q.iter_mut().zip(program.hessian_times(near)).for_each(|(q, px)| *q += px);
        b = program.slack(near);
    }
    if ![&program.p.nzval[..], &q, &program.a.nzval, &b].into_iter().all(finite) {
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
        tol_feas: tolerance.feasibility,
        tol_gap_abs: tolerance.gap,
        tol_gap_rel: tolerance.gap,
        ..DefaultSettings::default()
    };
    let begin = Instant::now();
    let stop = cancel::current().map(|cancel| -> Stop { Box::new(move || cancel.is_cancelled()) });
    let conic = Conic { p: &matrix(&program.p), q: &q, a: &matrix(&program.a), b: &b, cones: &cones };
    let ended = mavc_solver::solve(&conic, settings, stop);
    cancel::checkpoint();
    let Some(Ended { status, mut x, z, iterations }) = ended else { return (None, Effort::default()) };
    let iterations = iterations as usize;
    let size = program.p.nzval.len() + program.a.nzval.len() + program.q.len() + program.b.len();
    let work = (iterations * size) as u64;
    let effort = Effort { solves: 1, iterations, work, starts: 0, time: begin.elapsed() };
    x.iter_mut().zip(near).for_each(|(x, near)| *x += near);
    (Some(Raw { status, x, z }), effort)
}

/// The bound X on the entries of points for which infeasibility is proved, in the program's scaling: ten times the
/// largest number on a right-hand side (which contains the waypoints), at least 100. A proof in floating-point
/// arithmetic needs such a bound, because A'z is not exactly zero.
pub fn reach(program: &QuadraticProgram) -> f64 {
    program.b.iter().fold(10.0_f64, |m, b| m.max(b.abs())) * 10.0
}

/// Accepts the solver's status only if plain arithmetic confirms it: `docs/method/hover-model.md`, "A plan" and 1.
fn judge(program: &QuadraticProgram, status: SolverStatus, x: Vec<f64>, z: Vec<f64>) -> Outcome {
    let stopped = |x: Option<Vec<f64>>| Outcome::Inconclusive { status: format!("{status:?}"), point: x };
    match status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            let objective = program.objective(&x);
            let px = program.hessian_times(&x);
            let quadratic: f64 = x.iter().zip(&px).map(|(x, p)| x * p).sum();
            let bz: f64 = program.b.iter().zip(&z).map(|(b, z)| b * z).sum();
            // f(y) >= f(x) + f'(x)(y - x) by convexity and f'(x) = r - A'z, so the dual value is off by at most |r'(y -
            // x)|.
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
            // A feasible x would give 0 <= z's = b'z - (A'z)'x, which is negative if no entry of x exceeds the reach.
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
