//! Clarabel (P. J. Goulart, Y. Chen, 2024) as mavc calls it.
//!
//! Clarabel is generic over its numbers, so its code is compiled in the crate that calls it. Here that is a crate of a
//! few lines, which the profile of tests optimises as a whole and without overflow checks (`Cargo.toml`); inside mavc,
//! whose own code keeps these checks, a solve took a third longer (measured).

pub use clarabel::algebra::CscMatrix;
pub use clarabel::solver::{DefaultSettings, SolverStatus, SupportedConeT};

use clarabel::solver::{DefaultSolver, IPSolver};

/// Decides between iterations whether to stop.
pub type Stop = Box<dyn Fn() -> bool + Send + Sync>;

/// Minimise x'Px/2 + q'x such that b - A x lies in the product of the cones: n variables, m rows.
pub struct Conic<'a> {
    /// The upper triangle (n x n).
    pub p: &'a CscMatrix<f64>,
    /// n entries.
    pub q: &'a [f64],
    /// m x n.
    pub a: &'a CscMatrix<f64>,
    /// m entries.
    pub b: &'a [f64],
    /// Of m rows together.
    pub cones: &'a [SupportedConeT<f64>],
}

/// Where the solver ended, not checked.
pub struct Ended {
    pub status: SolverStatus,
    /// The variables (n).
    pub x: Vec<f64>,
    /// The multipliers (m).
    pub z: Vec<f64>,
    pub iterations: u32,
}

/// Solves a program, until `stop` is true. `None` if the solver rejects the program.
pub fn solve(program: &Conic, settings: DefaultSettings<f64>, stop: Option<Stop>) -> Option<Ended> {
    let Conic { p, q, a, b, cones } = *program;
    let mut solver = DefaultSolver::new(p, q, a, b, cones, settings).ok()?;
    if let Some(stop) = stop {
        solver.set_termination_callback(move |_| stop());
    }
    solver.solve();
    let found = solver.solution;
    Some(Ended { status: found.status, x: found.x, z: found.z, iterations: found.iterations })
}
