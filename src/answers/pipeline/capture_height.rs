//! The height that a fault without control of yaw costs: what plans keep, and how long they fly lower. All of it is
//! simulated.

use super::planned::Planning;
use super::tasks::Task;
use crate::diagnostic::{Diagnostic, Severity};
use crate::flight::capture::Capture;
use crate::flight::capture::exposed::{Exposed, exposed};
use crate::flight::capture::heights::CaptureHeights;
use crate::model::capture_height::LOW;
use crate::model::{GiveUpYaw, Mission, Model};
use crate::motion::{Trajectory, X, Y};
use crate::number::{number, significant};
use crate::planner::studies::{Comparison, PlannerRun};
use crate::report::capture_height::ExposedRecord;
use crate::report::without_yaw::without_rows;
use std::sync::Arc;

/// Code: no mode is concerned by the statement.
const IDLE: &str = "mavc::plan::capture_idle";
/// Code: not every simulated flight regains level flight.
const HOPELESS: &str = "mavc::plan::capture_unregained";

/// Delay after which a fault is known if the spec gives none, s: that of the middle column of `mavc analyze --capture`.
const USUAL_DELAY: f64 = 0.1;
/// The most modes that are simulated for a plan that requires no height.
const MOST_MODES: usize = 8;

/// What the statement of a spec comes to.
#[derive(Debug, Clone)]
pub(super) struct ImposedHeight {
    pub heights: Arc<CaptureHeights>,
    /// The spec with the limits that keep the height.
    pub model: Arc<Model>,
}

/// Simulates the height that `require capture_height` asks for, and imposes it. `None` if the spec does not have the
/// statement or no mode is concerned; in the latter case a warning says so.
///
/// # Errors
/// No height is enough, or the waypoints are too low.
pub(super) fn impose(model: &Model) -> Result<(Option<ImposedHeight>, Option<Diagnostic>), Box<Diagnostic>> {
    let mission = model.mission.as_ref();
    let Some((required, top)) = model.plan.require_capture.zip(mission.and_then(Mission::top_speed)) else {
        return Ok((None, None));
    };
    let Some(heights) = CaptureHeights::simulate(model, required.delay, top, usize::MAX) else {
        let message =
            "`require capture_height` has no effect: no declared fault mode gives up yaw and can hover without it";
        let warning = Diagnostic::warning(IDLE, required.span, message).here("concerns no mode");
        let gives_up = |mode: usize| model.gives_up_yaw(mode) != GiveUpYaw::Never;
        let help = match model.modes.is_empty() || (0..model.modes.len()).any(gives_up) {
            true => {
                "remove it, or declare such a mode, as in `every 1 rotor lost as L` of a quadcopter with `yaw_drag`"
            }
            false => "remove it, or `without_yaw = never`, with which no mode gives up yaw",
        };
        return Ok((None, Some(warning.help(help))));
    };
    if let Some(case) = heights.hopeless() {
        let message = format!(
            "no height is enough after mode {}: with the fault known after {} ms at {} m/s, {} of {} simulated flights \
             regain level flight",
            case.mode,
            number(1e3 * case.delay_s),
            significant(case.speed_m_per_s, 3),
            case.regained,
            case.flights
        );
        let error = Diagnostic::error(HOPELESS, required.span, message).here("cannot be required");
        let help = match model.vehicle.yaw_drag {
            None => "give `yaw_drag` in `vehicle`, without which nothing ends the spin; see `mavc analyze --capture`",
            Some(_) if case.settled_rate_rad_s.is_none_or(|rate| rate > model.simulation.gyroscope_range) => {
                "the spin does not settle in level flight within `gyroscope_range`: see `mavc analyze --capture`"
            }
            Some(_) => "lower the limit on speed or `detection`, or use faster rotors; see `mavc analyze --capture`",
        };
        return Err(Box::new(error.help(help)));
    }
    let kept = model.keeping(heights.greatest())?;
    Ok((Some(ImposedHeight { heights: Arc::new(heights), model: Arc::new(kept) }), None))
}

/// The errors and warnings of the statement, for `mavc check`.
pub(super) fn diagnose(model: &Model) -> Option<Diagnostic> {
    match impose(model) {
        Ok((_, remark)) => remark,
        Err(error) => Some(*error),
    }
}

/// Whether a diagnostic is about the height that faults cost.
pub(super) fn is_about(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity == Severity::Error && [LOW, HOPELESS].contains(&diagnostic.code)
}

/// The captures against which plans are measured, of a spec that does not require the height: at the plans' own speeds.
pub(super) fn at_speeds_of(model: &Model, plans: &[&Trajectory]) -> Option<CaptureHeights> {
    let delay = model.simulation.detection.delay().unwrap_or(USUAL_DELAY);
    let speeds = plans.iter().flat_map(|plan| plan.nodes.iter()).map(|node| node[X][1].hypot(node[Y][1]));
    let top = speeds.reduce(f64::max)?;
    CaptureHeights::simulate(model, delay, top.max(1.0), MOST_MODES)
}

impl Task<'_> {
    /// The captures against which an outcome's plan is measured; simulated once. `None` without a ground or a plan, or
    /// if no mode is concerned.
    pub(super) fn capture_heights(&self, planning: &Planning) -> Option<Arc<CaptureHeights>> {
        planning.capture_heights.get_or_init(|| self.capture_heights_of(planning.comparison())).clone()
    }

    /// The captures over delays of 20 to 300 ms that the page draws: at most two modes, at rest and at the largest
    /// speed.
    pub fn capture_curves(&self, planning: &Planning) -> Vec<Capture> {
        self.capture_heights(planning).map_or(Vec::new(), |heights| heights.curves(self.model()))
    }

    /// The captures against which all plans of a comparison are measured.
    pub(super) fn capture_heights_of(&self, comparison: &Comparison) -> Option<Arc<CaptureHeights>> {
        let plans: Vec<&Trajectory> =
            comparison.runs.iter().filter_map(|run| run.outcome.plan()).map(|plan| &plan.trajectory).collect();
        match &self.imposed {
            _ if plans.is_empty() => None,
            Some(imposed) => Some(imposed.heights.clone()),
            // Without a ground only modes that a plan leaves out need them.
            None if self.mission().ground.is_none() && without_rows(comparison).is_empty() => None,
            None => at_speeds_of(self.model(), &plans).map(Arc::new),
        }
    }

    /// How long each run's plan is lower than the captures ask for, in the order of the runs.
    pub(super) fn exposed(&self, comparison: &Comparison, heights: Option<&CaptureHeights>) -> Vec<Vec<ExposedRecord>> {
        let ground = self.mission().ground;
        let of_run = |run: &PlannerRun| match (run.outcome.plan(), heights, ground) {
            (Some(plan), Some(heights), Some(ground)) => exposed(heights, &plan.trajectory, ground),
            _ => Vec::new(),
        };
        let records = |found: Vec<Exposed>| found.iter().map(ExposedRecord::new).collect();
        comparison.runs.iter().map(of_run).map(records).collect()
    }
}
