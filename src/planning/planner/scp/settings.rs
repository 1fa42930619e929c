//! The parameters of the SCP planner, in one struct. `docs/method/exact-planner.md` lists the algorithms.
//! Constants beside the code are what proofs and checks rest on (`FEASIBLE`, `ACCEPTED`, `PARTS`, `UPRIGHT`), the
//! resolution of times, the scaling of programs (`TAU_STEPS`, `EVEN`), the solver's tolerances, rounding, and the rules
//! that both planners share (`timing::kinematics`, `timing::search`).
//!
//! "Violation" is in widths of the healthy set for facets and a share of the bound for limits. Where a field names a
//! measurement, this is what its value was chosen by; the other values were chosen by hand. The values themselves are
//! in [`ScpSettings::DEFAULT`].

mod values;

/// Parameters of [`super::ScpPlanner`]. The planner's results depend on all of them. Their values are not checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScpSettings {
    /// Rows and multipliers of one convex subproblem.
    pub subproblem: SubproblemSettings,
    /// The proximal weight and how it adapts.
    pub proximal: ProximalSettings,
    /// The feasibility phase (restoration).
    pub feasibility: FeasibilitySettings,
    /// The cost phase.
    pub cost: CostSettings,
    /// Constraint tightening.
    pub tightening: TighteningSettings,
    /// Durations of legs as variables: waypoint times.
    pub durations: DurationSettings,
    /// Slowing iterates down.
    pub slowing: SlowingSettings,
    /// The search for the shortest mission time.
    pub search: SearchSettings,
    /// Grids between the coarse and the full one.
    pub grids: GridSettings,
    /// How much of the solver's work a search may take.
    pub budget: BudgetSettings,
    /// The second pass over a plan.
    pub comfort: ComfortSettings,
    /// The program whose multipliers give what limits the time.
    pub sensitivity: SensitivitySettings,
    /// Stops after a fault.
    pub stops: StopSettings,
    /// Waypoints that require nothing, in quick attempts.
    pub guidance: GuidanceSettings,
}

/// Rows and multipliers of one convex subproblem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SubproblemSettings {
    /// Row generation: a row at a node with less slack than this is in the subproblem from the start, and a row of the
    /// working set with more is dropped after the feasibility phase. Widths of the healthy set or shares of a limit.
    pub slack_of_working_set: f64,
    /// Rows of volumes are in every program at every node, unless there are more than this: then programs start without
    /// them, and get them like other rows. A row takes some 800 bytes, most of them in the solver.
    pub max_rows_of_volumes: usize,
    /// An instant with at least this many facets has variables for its wrench. Measured on RIP and RCP of 25 generated
    /// missions, with [`BudgetSettings::finishing_steps`] 15: times were 0.5 % shorter in the mean, 9 % at most, and at
    /// most 0.4 % longer, in 4 % less processor time.
    pub many_facets: usize,
    /// Multipliers below this add no curvature to the Lagrangian.
    pub negligible_multiplier: f64,
    /// Pieces of an iterate join where derivatives on both sides agree to this share of their largest size (at least 1,
    /// in SI units). The solver leaves less, a step that changes durations more.
    pub joined_within: f64,
}

/// The proximal term of (73) and how its weight adapts to the ratio of actual to predicted gain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProximalSettings {
    /// The largest weight: a phase ends where it is exceeded.
    pub max_weight: f64,
    /// The smallest weight.
    pub min_weight: f64,
    /// Where the ratio exceeds this the weight decreases.
    pub good_ratio: f64,
    /// Where the ratio is below this the weight increases.
    pub poor_ratio: f64,
    /// Factor by which it decreases.
    pub decrease: f64,
    /// Factor by which it increases.
    pub increase: f64,
    /// Bounds on the factor by which it increases after a line search that took a share of the step; within them the
    /// factor is the inverse of the share.
    pub increase_after_share: (f64, f64),
    /// The change of psi that counts like a change of an acceleration by itself, rad.
    pub yaw_unit: f64,
    /// Changes of accelerations are relative to at least this share of gravity.
    pub min_acceleration: f64,
    /// Weight of the squared change of inputs, relative to their mean square, between grids and wherever the violation
    /// is below [`FeasibilitySettings::nearly_feasible`]. Changes of accelerations below the solver's gap hide inputs
    /// of any size on a fine grid.
    pub input_weight: f64,
}

/// The feasibility phase, which minimises the violation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeasibilitySettings {
    /// Initial proximal weight: small, so that the phase ends near the nearest feasible iterate.
    pub proximal_weight: f64,
    /// Most steps.
    pub max_steps: usize,
    /// The violation has to fall to the share `required_fall` over this many steps.
    pub patience: usize,
    /// The share to which the violation has to fall over `patience` steps.
    pub required_fall: f64,
    /// Below this violation slow progress is accepted, because each step adds rows at other instants.
    pub nearly_feasible: f64,
    /// The phase fails where the linear model itself predicts more violation than this. Measured: further steps fail,
    /// or reach an iterate at the edge of what can be flown.
    pub max_predicted: f64,
    /// The predicted violation at which the phase fails after a change of the grid or of durations by different shares,
    /// which leave an iterate further from a trajectory.
    pub max_predicted_after_change: f64,
    /// The phase also fails where the linear model predicts more violation than this and more than `steady_ratio` times
    /// the prediction two steps before. Measured: such sequences took all their steps and failed.
    pub unavoidable: f64,
    /// The share of the prediction two steps before above which progress counts as too slow beyond `unavoidable`.
    pub steady_ratio: f64,
    /// Most steps of which no share lowers the violation.
    pub max_rejected: usize,
    /// Factor of the proximal weight after such a step that violates more rows than the working set has, besides that
    /// after a small share.
    pub proximal_increase_after_rejection: f64,
    /// Line search: share of the predicted decrease that a step has to reach.
    pub sufficient_decrease: f64,
    /// Line search: no share below this is tried.
    pub min_share: f64,
}

/// When a cost phase ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoppingRule {
    /// Most steps.
    pub max_steps: usize,
    /// A predicted relative gain of the merit function below this ends the phase.
    pub min_gain: f64,
}

impl StoppingRule {
    /// No cost phase: any feasible iterate will do.
    pub const NO_STEPS: StoppingRule = StoppingRule { max_steps: 0, min_gain: 0.0 };
}

/// The cost phase, which minimises the cost (48) by a merit function with an exact penalty on the violation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CostSettings {
    /// Initial proximal weight of the first phase; later ones start from where the last ended.
    pub proximal_weight: f64,
    /// The largest initial proximal weight.
    pub max_initial_proximal_weight: f64,
    /// The largest proximal weight after the last iterate was restored.
    pub max_proximal_weight_after_restoration: f64,
    /// Initial penalty weight: the violation against the relative cost. Measured: with 20 from the start steps are
    /// rejected.
    pub penalty: f64,
    /// Factor by which the penalty weight grows where the cost outweighs it.
    pub penalty_growth: f64,
    /// The largest penalty weight that still grows.
    pub max_penalty: f64,
    /// Line search: share of the predicted gain of the merit function that a step has to reach.
    pub sufficient_gain: f64,
    /// Line search: the share is halved while it exceeds this, so the last share tried may be smaller.
    pub min_share: f64,
    /// On the way to another mission time, and for the plans of quick searches.
    pub rough: StoppingRule,
    /// Where the way to another mission time is hard, between weights of the cost, and for plans nearly as short as a
    /// larger set's.
    pub medium: StoppingRule,
    /// For a plan that is kept.
    pub close: StoppingRule,
}

/// Constraint tightening: by the margin everywhere, and locally where rows are violated between instants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TighteningSettings {
    /// What every facet and limit keeps free, so that the linearisation error of the last step ends inside; also the
    /// tolerance of a flat set's equalities. Widths of the healthy set or shares of a limit.
    pub margin: f64,
    /// The violation accepted between instants: a fifth of what counts as a violation, because the finer grid has gaps
    /// too. With a half the checker did not prove one plan of 49 that it proves now, in the same time (measured).
    pub max_violation: f64,
    /// Parts of each interval between instants at which it is measured.
    pub parts: usize,
    /// Rows are tightened by their slack and this many times the violation, at the instants on both sides; those on the
    /// commanded wrench by this many times the violation, at all instants.
    pub factor: f64,
    /// Most rounds of evaluation, tightening and restoration. The result of the last restoration is not evaluated, so
    /// one restoration fewer can lead to a plan.
    pub max_rounds: usize,
}

/// Durations of legs as variables, with a trust region on their relative changes: steps to shorter times, and steps in
/// which legs divide the time between two fixed times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DurationSettings {
    /// A change to the grid of the new durations may lengthen the flight up to this factor. Chosen by hand.
    pub longest_on_its_own_grid: f64,
    /// Initial and smallest proximal weight.
    pub proximal_weight: f64,
    /// Factor of the proximal weight after a full step with a ratio of gains above `good_ratio`.
    pub proximal_decrease: f64,
    /// The ratio of actual to predicted gain above which the next step may be longer.
    pub good_ratio: f64,
    /// Trust region: largest relative change of a duration in the first step.
    pub first_radius: f64,
    /// [`Self::first_radius`] on a finer grid or with another weight of the cost, unless the steps before ended with a
    /// larger one.
    pub least_first_radius: f64,
    /// The largest radius.
    pub max_radius: f64,
    /// Factor of the radius after a full step with a ratio of gains above `good_ratio`.
    pub radius_growth: f64,
    /// After a step of which a share was taken, the proximal weight grows by this over the share, and the radius
    /// shrinks by the root of the share, by the share itself if it is the smallest. Measured: with the share itself
    /// missions from rest to rest ended 3 % longer.
    pub proximal_increase: f64,
    /// Steps end below this radius, unless the last one saved at least `min_gain`. Measured: without the exception RCP
    /// of one hexacopter's mission ended at 40.8 instead of 40.3 s.
    pub min_radius: f64,
    /// Penalty weight of the violation in the subproblem, against the relative time: far above the multipliers, so that
    /// steps do not trade time for a violation.
    pub penalty: f64,
    /// The violation's weight in the merit function: this many times the largest sum of multipliers of late.
    pub price_factor: f64,
    /// The least of these weights, relative time by violation. Measured: with 1 the paper's third case in the exact
    /// model ended at 20.7 s, with 0.3 at 19.2 s; its multipliers are 0.01 at first.
    pub least_price: f64,
    /// Factor by which that sum is forgotten from step to step.
    pub price_decay: f64,
    /// Line search: share of the predicted gain that a step has to reach.
    pub sufficient_gain: f64,
    /// Line search: the smallest share tried.
    pub min_share: f64,
    /// Relative weights of the cost, one after the other. Smooth trajectories come far in few steps, because they stay
    /// away from attitudes at which the wrench is most curved; the shortest ones cost many times as much.
    pub cost_weights: [f64; 3],
    /// Those on the coarse grid, whose result is only the initial guess on a finer one.
    pub cost_weights_on_coarse_grid: [f64; 1],
    /// Those on the medium grid.
    pub cost_weights_on_medium_grid: [f64; 2],
    /// Those on the full grid after another grid, and from a warm start.
    pub cost_weights_on_full_grid: [f64; 1],
    /// Weight of the squared relative change of inputs: without it steps swing between nodes, where rows are missing.
    /// Measured: RIP of the generated mission 11 (`benches/missions/generate.py`) takes 21.95 s with it and 109.89 s
    /// without.
    pub input_weight: f64,
    /// A step is slow where the linear model predicts a smaller gain, as a share of the time.
    pub min_gain: f64,
    /// After more slow steps in a row than this the next weight's turn comes.
    pub most_slow: usize,
    /// After more steps in a row than this that leave most of a violation, which the linear model does not remove
    /// either, the steps end.
    pub most_hopeless: usize,
    /// Most steps in all with the weights of one grid.
    pub max_steps: usize,
    /// Steps in which legs divide the time between two fixed times.
    pub between_fixed_times: DivisionSettings,
}

/// Steps in which legs divide the time between two fixed times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DivisionSettings {
    /// Trust region: largest relative change of a duration in the first step.
    pub first_radius: f64,
    /// Factor by which the radius shrinks after a step that fails.
    pub radius_shrink: f64,
    /// Steps end below this radius.
    pub min_radius: f64,
    /// Most steps.
    pub max_steps: usize,
}

impl DurationSettings {
    /// The weights of the cost and the first radius on the full grid after another grid, and from a warm start.
    pub fn on_full_grid(&self) -> (&[f64], f64) {
        (&self.cost_weights_on_full_grid, self.least_first_radius)
    }
}

/// Slowing iterates down until they are feasible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlowingSettings {
    /// An initial guess that cannot be restored at its own time is slowed down by these factors in turn.
    pub slowdowns: [f64; 10],
    /// Relative precision of the slowing down of a minimum-snap initial guess.
    pub precision: f64,
    /// Slowing down: factor from one duration to the next while none is feasible.
    pub bracket_growth: f64,
    /// Slowing down: factor from one duration to the next while all are feasible.
    pub bracket_shrink: f64,
    /// Slowing down: no duration below this many times the initial guess's is sought.
    pub min_factor: f64,
}

/// The search for the shortest mission time around the steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchSettings {
    /// No time longer than this many times the first guess is tried.
    pub max_multiple: f64,
    /// A time that exceeds that of a larger set by no more than this share is not shortened further.
    pub short_enough: f64,
    /// Times after the last fixed time at which a first plan is sought, in initial durations of the legs there.
    pub ample: [f64; 4],
    /// How many ticks of 0.01 s later than the shortest time found a plan is tried.
    pub late: [f64; 6],
    /// The relaxation is first solved at the first guess less this share of the flight after the last fixed time.
    pub first_proof: f64,
    /// After the last fixed time: the relative resolution of the bisection.
    pub resolution: f64,
    /// After the last fixed time: the first stride to longer times, as a share of the first guess of the flight.
    pub first_stride: f64,
    /// Factor by which this stride grows.
    pub stride_growth: f64,
}

/// Grids between the coarse one (see `HoverSettings`) and the full one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridSettings {
    /// Intervals of the medium grid, or those of the coarse grid where that has more.
    pub medium: usize,
    /// Durations are optimised on the medium grid first where the full grid has more than this many times its
    /// intervals. Restoration often fails between grids that differ more, and steps on a fine grid are expensive.
    /// Measured: from 60 to 300 intervals at once, `ferry_octo` took three times as long as by a grid of 150.
    pub refinement: f64,
    /// Factor from one grid to the next while the motion from rest to rest has too few intervals.
    pub growth: f64,
    /// That motion may have this many times the spec's samples: a leg with a turn at either end and a move needs eleven
    /// intervals, and the language asks for five. Chosen by hand.
    pub finest: f64,
    /// On a new grid of the same size, and after steps to shorter times, an iterate is slowed down by these factors in
    /// turn until it can be restored.
    pub slowdowns: [f64; 4],
}

/// How much of the solver's work ([`crate::solve::Effort::work`]) one search may take, and when its parts end, as
/// shares of that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BudgetSettings {
    /// `effort = quick`
    pub quick: f64,
    /// `effort = normal`
    pub normal: f64,
    /// `effort = thorough`
    pub thorough: f64,
    /// Other sides of volumes are tried up to this share.
    pub until_other_sides: f64,
    /// Steps to shorter times on the coarse grid end at this share.
    pub until_coarse_grid: f64,
    /// Those on the medium grid.
    pub until_medium_grid: f64,
    /// Those on the full grid.
    pub until_full_grid: f64,
    /// Steps to shorter times also end where the rest of [`Self::at_most`] is no more than this many steps on the full
    /// grid take, as the last step's work by interval tells: a plan has to be made of the result. Measured on RIP and
    /// RCP of six generated missions whose budget ran out: without it, and with `at_most` 1.5, times were 5 % longer in
    /// the mean, and 56 % at most.
    pub finishing_steps: f64,
    /// Steps of cost phases end at this share.
    pub until_cost: f64,
    /// Second passes have a budget of their own: their steps end at this share, and no program is solved beyond twice
    /// this share.
    pub of_comfort: f64,
    /// No program is solved beyond this share: what is not found by then is not found.
    pub at_most: f64,
}

/// What counts as much as the whole cost (48) in the second pass over a plan. All chosen by hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComfortSettings {
    /// Root mean square of the distance from the legs' lines, m.
    pub distance: f64,
    /// That of the difference from the yaw of legs that keep it, rad.
    pub yaw: f64,
    /// That of the yaw rate, rad/s.
    pub yaw_rate: f64,
    /// Each counts at most this many times as much as the cost (48).
    pub most: f64,
    /// Passes, each from the plan of the last.
    pub passes: usize,
    /// A pass that gains less than this share ends them.
    pub least_gain: f64,
}

/// The program that minimises the time about a plan, for its multipliers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensitivitySettings {
    /// Relative weight of the cost. Measured against plans of relaxed specs (tests/it/exact/binding.rs): with 0.002 the
    /// cost, which rises steeply near the shortest time, takes part of the multipliers.
    pub cost_weight: f64,
    /// Penalty weight of the violation.
    pub penalty: f64,
    /// Proximal weight.
    pub proximal_weight: f64,
    /// Largest relative change of a duration.
    pub radius: f64,
}

/// Steps to a stop after a fault: short attempts, because risk figures need dozens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopSettings {
    /// Proximal weight in the exact model.
    pub proximal_weight: f64,
    /// Proximal weight where the wrench is linear in the motion, and steps need not be short.
    pub proximal_weight_if_linear: f64,
    /// Most steps.
    pub max_steps: usize,
    /// The violation has to fall to the share `required_fall` over this many steps.
    pub patience: usize,
    /// The share to which the violation has to fall over `patience` steps.
    pub required_fall: f64,
    /// Line search: share of the predicted decrease that a step has to reach.
    pub sufficient_decrease: f64,
    /// Line search: no share below this is tried.
    pub min_share: f64,
    /// A stop is divided into parts of these shares of its duration. Body rates are stopped at its beginning and the
    /// vehicle is levelled at its end, which needs shorter steps than braking in between.
    pub shares: [f64; 5],
    /// Intervals in each part.
    pub intervals_per_part: usize,
    /// [`SubproblemSettings::slack_of_working_set`] of branches: their grids are small, and programs that lack rows
    /// give steps that are rejected. Measured on one mode of `specs/missions/tower_hexa.mav`: with 0.1, 2,472 programs
    /// and no branch at 8 % of the instants; with 0.5, 810 programs and a branch at all.
    pub slack_of_working_set: f64,
    /// [`SubproblemSettings::many_facets`] of branches: they have no slack for what these variables leave of accuracy.
    /// Measured: with 8 a landing was not found that is found without.
    pub many_facets: usize,
    /// Weight of the squared distance between the end of a landing and the middle of its place, in radii of the place,
    /// against the violation.
    pub pull_of_place: f64,
    /// The shortest duration tried, s, unless braking with 2 g takes longer; `stop` tries longer ones in a fixed ratio.
    pub min_duration: f64,
}

/// How near waypoints that require nothing are kept in quick attempts: a wide tolerance and a small weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GuidanceSettings {
    /// Weight of the squared distance to the waypoint, 1/m^2.
    pub weight: f64,
    /// The tolerance is at least this distance, m.
    pub min_distance: f64,
    /// The tolerance is at least this many times the largest distance of a waypoint from the first.
    pub lengths: f64,
    /// Tolerance of the yaw, rad.
    pub yaw: f64,
    /// How often the initial guess around a volume is solved again with separating planes about itself.
    pub ways: usize,
    /// Every which instant that guess keeps the volumes.
    pub instants: usize,
    /// How many other sides of volumes than those of the shortest ways are considered.
    pub sides: usize,
    /// On how many of them, the quickest by their initial guesses, a coarse iterate is optimised.
    pub quicker_sides: usize,
}

impl Default for ScpSettings {
    fn default() -> Self {
        ScpSettings::DEFAULT
    }
}
