//! Solving programs with Clarabel, by the crate `mavc-solver`. No other module imports it.
//!
//! A result of the solver is reported only after it has been checked in plain arithmetic on the program's data:
//! `docs/method/hover-model.md`.

use crate::cancel;
use crate::qp::elimination::Elimination;
use crate::qp::{Cone, QuadraticProgram, RowOrigin, Sparse};
use mavc_solver::{Conic, CscMatrix, DefaultSettings, Ended, SolverStatus, Stop, SupportedConeT};
use std::iter;
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
    let mut gradient = program.gradient(&solution.x);
    gradient.iter_mut().zip(program.a.transposed_times(&solution.z)).for_each(|(g, az)| *g += az);
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
    /// Residual of the linear systems at which refinement ends, relative and absolute; `None` without refinement.
    refinement: Option<(f64, f64)>,
}

/// For verdicts, and for plans of the hover model: the solver's defaults.
const CLOSE: Tolerance =
    Tolerance { gap: 1e-8, feasibility: 1e-8, regularization: 1e-8, refinement: Some((1e-13, 1e-12)) };

/// For steps of a sequence, which evaluates what they reach.
///
/// Measured on every fifth program of RIP's plans for `specs/missions/tower_hexa.mav` and
/// `benches/missions/known/edge_hexa.mav`, rows scaled by their slack: with a regularisation of 1e-9 to 1e-10 every
/// program was solved; with 1e-7 the objective was off by up to 1e-3. In stage variables, whose equations depend on the
/// regularisation most, it was off by up to ten times the gain of a step. Refinement added a third to the time and
/// changed nothing else.
const STEP: Tolerance = Tolerance { gap: 1e-4, feasibility: 1e-8, regularization: 1e-10, refinement: None };

/// For [`solve_graded`].
///
/// The regularisation is ten times the solver's default: with the default, half of the programs on graded grids ended
/// with a numerical error (measured). Programs of the hover model do not need it, and their refinement took a fifth
/// more time with it.
const GRADED: Tolerance = Tolerance { regularization: 1e-7, ..CLOSE };

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

/// A point that satisfies the rows of a program to [`STEP_VIOLATION`], with its multipliers; `None` if the solver
/// reaches none.
///
/// The solver gets the program without its equations ([`Elimination`]) and in the differences from a point near the
/// solution: its tolerances are relative, and large terms that cancel would leave it no digits. Each row is divided by
/// its size ([`sizes`]), or by so much that its norm is at most [`LARGEST_NORM`]. So the solver begins where slacks and
/// multipliers are of order one. With the solver's own equilibration it took twice the
/// iterations (measured as in [`STEP`]).
///
/// The point is accurate enough for a step of sequential convex programming, which evaluates what the step reaches; it
/// may be one at which the solver stopped without meeting its tolerances.
pub(crate) fn solve_step(program: &QuadraticProgram, near: &[f64]) -> (Option<Solution>, Effort) {
    let slack = program.slack(near);
    let equations = match program.cones.first() {
        Some(Cone::Zero(n)) => *n,
        _ => 0,
    };
    let elimination = Elimination::of(&program.a, &slack, equations);
    let constants = elimination.variables(&vec![0.0; elimination.free()]);
    let begin: Vec<f64> = near.iter().zip(&constants).map(|(near, constant)| near + constant).collect();
    let slack = program.slack(&begin);
    let norms = norms(program);
    let sizes = sizes(program, &slack, &norms);
    let factors: Vec<f64> = sizes.iter().zip(&norms).map(|(size, norm)| 1.0 / size.max(norm / LARGEST_NORM)).collect();
    let (p, a) = (elimination.hessian(&program.p), elimination.matrix(&program.a));
    let mut data = Data {
        p: matrix(&p),
        q: elimination.gradient(&program.gradient(&begin)),
        a: matrix(&a),
        b: elimination.kept.iter().map(|&row| slack[row] * factors[row]).collect(),
    };
    data.q.iter_mut().chain(&mut data.p.nzval).for_each(|value| *value *= OBJECTIVE);
    data.a.nzval.iter_mut().zip(&data.a.rowval).for_each(|(value, &row)| *value *= factors[elimination.kept[row]]);
    let mut cones = program.cones.clone();
    let left = equations - (program.b.len() - elimination.kept.len());
    match cones.first_mut() {
        Some(Cone::Zero(n)) if left > 0 => *n = left,
        Some(Cone::Zero(_)) => drop(cones.remove(0)),
        _ => {}
    }
    let tolerance = Tolerance { gap: OBJECTIVE * STEP.gap, ..STEP };
    let (raw, effort) = call(&data, &cones, false, tolerance);
    let Some(Raw { status, x: free, z: of_kept }) = raw else { return (None, effort) };
    let of_kept: Vec<f64> =
        of_kept.iter().zip(&elimination.kept).map(|(z, &row)| z * factors[row] / OBJECTIVE).collect();
    let x: Vec<f64> = near.iter().zip(elimination.variables(&free)).map(|(near, x)| near + x).collect();
    let z = elimination.multipliers(&of_kept, &program.gradient(&x), program);
    let has_point = matches!(
        status,
        SolverStatus::Solved
            | SolverStatus::AlmostSolved
            | SolverStatus::InsufficientProgress
            | SolverStatus::NumericalError
            | SolverStatus::MaxIterations
    );
    let left: Vec<f64> = program.slack(&x).iter().zip(&sizes).map(|(slack, size)| slack / size).collect();
    let holds =
        has_point && x.iter().chain(&z).all(|v| v.is_finite()) && program.cone_violation(&left) <= STEP_VIOLATION;
    let objective = program.objective(&x);
    (holds.then_some(Solution { bound: f64::NEG_INFINITY, objective, x, z }), effort)
}

/// The largest violation of a row in the solution of a step, relative to its size ([`sizes`]).
const STEP_VIOLATION: f64 = 1e-5;

/// Rows with less slack are divided by this much, in their own units of order one. From 0.003 to 0.3 iterations change
/// by a tenth (measured as in [`STEP`]).
const LEAST_SLACK: f64 = 0.03;

/// The largest norm of a row for the solver. On fine grids rows of the snap have norms up to 1e9 when divided by
/// their sizes, with which 34 of the 147 steps of `edge_hexa` at 800 samples ended with a numerical error at once; with
/// 1e4 six came to no point. The feasibility of [`STEP`] is that close because such rows then count less: with 1e-6 the
/// plan of `slalom_quad` took 11.75 s instead of 11.44 s.
const LARGEST_NORM: f64 = 1e4;

/// The same for equations of variables for the wrench. With less the wrench is less accurate; with 1e4, 48 of 156 steps
/// of one mission failed, with 1e2 two of 82 (measured).
const LARGEST_NORM_OF_WRENCH: f64 = 1e2;

/// The factor of a step's objective for the solver. With 1 it took 5 % more iterations, with 30 as many (measured as in
/// [`STEP`]).
const OBJECTIVE: f64 = 10.0;

/// The solver's unchecked result.
struct Raw {
    status: SolverStatus,
    x: Vec<f64>,
    z: Vec<f64>,
}

/// The numbers of a program in the solver's form.
struct Data {
    p: CscMatrix<f64>,
    q: Vec<f64>,
    a: CscMatrix<f64>,
    b: Vec<f64>,
}

impl Data {
    fn of(program: &QuadraticProgram) -> Data {
        Data { p: matrix(&program.p), q: program.q.clone(), a: matrix(&program.a), b: program.b.clone() }
    }
}

/// One checked call of the solver, with or without its equilibration.
fn attempt(program: &QuadraticProgram, scaled: bool, tolerance: Tolerance) -> (Outcome, Effort) {
    match call(&Data::of(program), &program.cones, scaled, tolerance) {
        (Some(Raw { status, x, z }), effort) => (judge(program, status, x, z), effort),
        (None, effort) => {
            let status = "the program contains a number that is not finite, or the solver rejected it".into();
            (Outcome::Inconclusive { status, point: None }, effort)
        }
    }
}

/// One call of the solver; `None` if the program contains a number that is not finite or the solver rejects it.
fn call(data: &Data, cones: &[Cone], scaled: bool, tolerance: Tolerance) -> (Option<Raw>, Effort) {
    let Data { p, q, a, b } = data;
    let finite = |v: &[f64]| v.iter().all(|x| x.is_finite());
    if ![&p.nzval[..], q, &a.nzval, b].into_iter().all(finite) {
        return (None, Effort::default());
    }
    let of_solver: Vec<SupportedConeT<f64>> = cones
        .iter()
        .map(|c| match *c {
            Cone::Zero(n) => SupportedConeT::ZeroConeT(n),
            Cone::Nonnegative(n) => SupportedConeT::NonnegativeConeT(n),
            Cone::SecondOrder(n) => SupportedConeT::SecondOrderConeT(n),
        })
        .collect();
    let defaults = DefaultSettings::default();
    let (relative, absolute) =
        tolerance.refinement.unwrap_or((defaults.iterative_refinement_reltol, defaults.iterative_refinement_abstol));
    let settings = DefaultSettings {
        verbose: false,
        max_threads: 1,
        presolve_enable: false,
        max_iter: MOST_ITERATIONS,
        equilibrate_enable: scaled,
        static_regularization_constant: tolerance.regularization,
        iterative_refinement_enable: tolerance.refinement.is_some(),
        iterative_refinement_reltol: relative,
        iterative_refinement_abstol: absolute,
        tol_feas: tolerance.feasibility,
        tol_gap_abs: tolerance.gap,
        tol_gap_rel: tolerance.gap,
        ..defaults
    };
    let begin = Instant::now();
    let stop = cancel::current().map(|cancel| -> Stop { Box::new(move || cancel.is_cancelled()) });
    let ended = mavc_solver::solve(&Conic { p, q, a, b, cones: &of_solver }, settings, stop);
    cancel::checkpoint();
    let Some(Ended { status, x, z, iterations }) = ended else { return (None, Effort::default()) };
    let iterations = iterations as usize;
    let size = p.nzval.len() + a.nzval.len() + q.len() + b.len();
    let work = (iterations * size) as u64;
    let effort = Effort { solves: 1, iterations, work, starts: 0, time: begin.elapsed() };
    (Some(Raw { status, x, z }), effort)
}

/// The Euclidean norm of the coefficients of each row; of a cone's rows the largest.
fn norms(program: &QuadraticProgram) -> Vec<f64> {
    let mut norms = vec![0.0_f64; program.b.len()];
    for (value, &row) in program.a.nzval.iter().zip(&program.a.rowval) {
        norms[row] += value * value;
    }
    norms.iter_mut().for_each(|norm| *norm = norm.sqrt());
    let mut first = 0;
    for cone in &program.cones {
        let rows = &mut norms[first..first + cone.rows()];
        if matches!(cone, Cone::SecondOrder(_)) {
            let largest = rows.iter().copied().fold(0.0, f64::max);
            rows.fill(largest);
        }
        first += cone.rows();
    }
    norms
}

/// The size of each row with these slacks at a point near the solution: the slack, of a cone its first, at least
/// [`LEAST_SLACK`]; of an equation the norm of its coefficients. Where variables stand for the wrench it is 1, or by so
/// much more that the norm is at most [`LARGEST_NORM_OF_WRENCH`], because facets need them as closely as their slacks.
fn sizes(program: &QuadraticProgram, slack: &[f64], norms: &[f64]) -> Vec<f64> {
    let mut sizes = Vec::with_capacity(slack.len());
    for cone in &program.cones {
        let first = sizes.len();
        let rows = first..first + cone.rows();
        match cone {
            Cone::Zero(_) => sizes.extend(rows.map(|row| match program.row_origin[row] {
                RowOrigin::Wrench { .. } => (norms[row] / LARGEST_NORM_OF_WRENCH).max(1.0),
                _ if norms[row] > 0.0 => norms[row],
                _ => 1.0,
            })),
            Cone::Nonnegative(_) => sizes.extend(slack[rows].iter().map(|slack| slack.abs().max(LEAST_SLACK))),
            Cone::SecondOrder(n) => sizes.extend(iter::repeat_n(slack[first].abs().max(LEAST_SLACK), *n)),
        }
    }
    sizes
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
