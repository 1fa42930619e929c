//! The parameters of the hover planner. What its proofs rest on ([`super::FEASIBLE`], [`super::ACCEPTED`] and the
//! bounds of `reach`) are constants, and so are the rules of `row_generation` and `timing::search` that have names
//! there. Where a field names a measurement, this is what its value was chosen by; the other values were chosen by
//! hand.

/// Parameters of [`super::HoverPlanner`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoverSettings {
    /// Row generation: rows with more slack than this at a plan are not carried on to other mission times. Widths of
    /// the healthy set or shares of a limit.
    pub kept_slack: f64,
    /// Row generation: after this many rounds every row is imposed, unless there are more than `max_rows_at_once`.
    pub max_rounds: usize,
    /// Most rows that are imposed at once. A row takes some 800 bytes, most of them in the solver.
    pub max_rows_at_once: usize,
    /// Programs with more rows than this are solved in stage variables. Measured.
    pub max_rows_in_splines: usize,
    /// Programs whose `Transcription::stiffness` exceeds this are solved in stage variables. Measured along the paper's
    /// curve: 200 samples in 16 s (2e8) are fine in spline coefficients; 500 samples (1e11), or 200 in 7 s (4e10),
    /// often end without a verdict.
    pub max_stiffness: f64,
    /// The share of the overshoot's objective that the inputs' cost may take at most, m.
    pub cost_share_of_overshoot: f64,
    /// The share of the violation's objective that the inputs' cost may take at most.
    pub cost_share_of_violation: f64,
    /// Intervals per leg (or hold) of the coarse grid.
    pub coarse_intervals_per_leg: usize,
    /// Fewest intervals of the coarse grid, unless the plan has fewer.
    pub min_coarse_intervals: usize,
    /// The search for the shortest time.
    pub search: HoverSearchSettings,
}

/// The search for the shortest mission time in the hover model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoverSearchSettings {
    /// Relative precision of the estimate on the coarse grid.
    pub precision: f64,
    /// With k intervals a leg shortest times are longer by about this share of 1/k^2. 0.85, measured on Viviani's
    /// curve; used for the estimate only.
    pub grid_error: f64,
    /// The estimate ends after this many times tried.
    pub max_steps: usize,
    /// The search ends after more times without a verdict than this.
    pub max_without_verdict: usize,
    /// Multiples of the shortest time at which it is checked that longer times have plans.
    pub longer: [f64; 7],
}

impl HoverSettings {
    /// The values in use.
    pub const DEFAULT: HoverSettings = HoverSettings {
        kept_slack: 0.05,
        max_rounds: 30,
        max_rows_at_once: 300_000,
        max_rows_in_splines: 1_000,
        max_stiffness: 1e9,
        cost_share_of_overshoot: 1e-3,
        cost_share_of_violation: 0.05,
        coarse_intervals_per_leg: 5,
        min_coarse_intervals: 60,
        search: HoverSearchSettings {
            precision: 0.005,
            grid_error: 0.85,
            max_steps: 60,
            max_without_verdict: 20,
            longer: [1.05, 1.1, 1.2, 1.4, 1.7, 2.0, 3.0],
        },
    };
}

impl Default for HoverSettings {
    fn default() -> Self {
        HoverSettings::DEFAULT
    }
}
