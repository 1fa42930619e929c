//! Findings about modes in which a plan gives up yaw, or would have to.

use super::Answer;
use crate::admissible::AdmissibleSet;
use crate::admissible::verdict::ModeAnalysis;
use crate::admissible::without_yaw::YawFree;
use crate::admissible::without_yaw::planned::{Obstacle, Provision};
use crate::diagnostic::Severity;
use crate::model::{GiveUpYaw, Model};

/// Code: the plan gives up yaw after a fault of a mode.
const YAW_GIVEN_UP: &str = "mavc::analysis::yaw_given_up";
/// Code: a mode adds no rows to the plan; the vehicle is caught and landed.
const CAPTURE: &str = "mavc::analysis::capture";
/// Code: the spec asks to give up yaw where plans cannot.
const YAW_KEPT: &str = "mavc::analysis::yaw_kept";

/// What is found about a mode with regard to yaw.
pub(super) enum YawFinding {
    /// Yaw is kept: the mode is judged as one with yaw.
    YawKept,
    /// Yaw is given up, and there is nothing to report.
    Nothing,
    Answer(Answer),
}

pub(super) fn judge(model: &Model, mode: &ModeAnalysis, index: usize) -> YawFinding {
    let asked = model.gives_up_yaw(index);
    let is_needed = !mode.keeps_full_control();
    if asked == GiveUpYaw::Never || (asked == GiveUpYaw::WhereNeeded && !is_needed) {
        return YawFinding::YawKept;
    }
    // One statement for all modes alike, where the plan is asked for.
    let span = match model.defaults.iter().any(|default| default.field == "plan.against") {
        true => model.plan.span,
        false => model.plan.against_span,
    };
    let answer =
        |severity, code, what, label, help| YawFinding::Answer(Answer::new(severity, code, span, what, label, help));
    if let Some(obstacle) = Obstacle::of(model) {
        // Where yaw has to be given up, the finding about the mode itself says more.
        return match is_needed {
            true => YawFinding::YawKept,
            false => {
                answer(Severity::Error, YAW_KEPT, "no plan can give up yaw", why(obstacle).into(), remedy(obstacle))
            }
        };
    }
    let set = AdmissibleSet::of_mode(model, index);
    let healthy = AdmissibleSet::healthy(model);
    let is_default = model.defaults.iter().any(|default| default.field == "plan.without_yaw");
    let is_written = model.modes[index].without_yaw.is_some() || !is_default;
    match Provision::of(model, &set, &healthy) {
        Provision::WithYaw => YawFinding::YawKept,
        // Who writes the word knows.
        Provision::WithoutYaw(_) if is_written => YawFinding::Nothing,
        Provision::WithoutYaw(_) => answer(
            Severity::Warning,
            YAW_GIVEN_UP,
            "the plan gives up yaw",
            "the motion stays in the core of the mode, and the body turns as it may".into(),
            "accept this by writing the default, `without_yaw = where_needed`, in `plan`; `never` keeps yaw",
        ),
        Provision::Capture => answer(
            Severity::Warning,
            CAPTURE,
            "the plan imposes nothing: no torque is left in some direction",
            "after the fault the vehicle is caught by its spin and landed; flights judge it: `mavc analyze --capture`"
                .into(),
            "leave the mode out of `against` if it need not be survived",
        ),
    }
}

/// What would let a plan give up yaw for a mode, as an addition to the help of its finding; `None` if nothing in the
/// spec prevents it.
pub(super) fn could_be_planned(model: &Model, mode: &ModeAnalysis, index: usize) -> Option<&'static str> {
    let allowed = model.gives_up_yaw(index) != GiveUpYaw::Never;
    let obstacle =
        Obstacle::of(model).filter(|_| allowed && matches!(mode.yaw_free, YawFree::Interior | YawFree::Spinning))?;
    Some(remedy(obstacle))
}

fn why(obstacle: Obstacle) -> &'static str {
    match obstacle {
        Obstacle::NoYawDrag => "without `yaw_drag` nothing bounds the spin",
        Obstacle::LaggingRotors => "with `rotors = lagging` the commands would turn with the body",
        Obstacle::Winds => "a plan without yaw is made for one wind",
        Obstacle::DragOfAxes => "with a drag for each axis of the body the motion depends on the heading",
    }
}

fn remedy(obstacle: Obstacle) -> &'static str {
    match obstacle {
        Obstacle::NoYawDrag => "with `yaw_drag` in `vehicle` the plan gives up yaw for the mode",
        Obstacle::LaggingRotors => "with `rotors = instant` the plan gives up yaw for the mode",
        Obstacle::Winds => "with one wind the plan gives up yaw for the mode",
        Obstacle::DragOfAxes => "with one `drag` for all axes the plan gives up yaw for the mode",
    }
}
