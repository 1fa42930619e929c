//! What the sets say about the spec: modes that the plan must stand but cannot.

use super::edge::{self, Place};
use super::interval::{Certainty, Robust};
use super::parallel::{Parallel, least_angle};
use super::verdict::{ModeAnalysis, Verdict, analyze};
use super::{AdmissibleSet, HEALTHY};
use crate::diagnostic::{Diagnostic, Severity};
use crate::model::Model;
use crate::number::{down, number, significant, up};
use crate::source::Span;

/// A mode that the plan must stand has lost control over some axis.
pub const CANNOT_HOVER: &str = "mavc::analysis::cannot_hover";
/// Hover lies on the edge of a set.
pub const HOVER_ON_EDGE: &str = "mavc::analysis::hover_on_edge";

/// A mode that the plan must stand hovers only for some values of the spec's intervals.
pub const NOT_ROBUST: &str = "mavc::analysis::not_robust";

/// Two rows of the actuation matrix are nearly parallel once a mode strikes.
pub const PARALLEL_ROWS: &str = "mavc::analysis::parallel_rows";

/// The sets of the modes that the plan is against have more facets than can be planned with.
pub const TOO_MANY_FACETS: &str = "mavc::plan::too_many_facets";

/// Facets of all modes together that a plan can be against. Before anything is planned each set is reduced to its least
/// description, in time quadratic in its facets: 1.1 s for a ring of 32 rotors, so about a minute up to here.
pub const MAX_FACETS: usize = 100_000;

/// Modes named one by one in a message; of more, the first ones and the number.
const NAMED: usize = 8;

/// Diagnostics of the healthy vehicle and of every mode that the plan stands against; where no mission is planned,
/// of the healthy vehicle alone. Modes of one statement with the same answer share a diagnostic.
///
/// A mode without full control, or with hover on its edge where a reserve is asked for, is an error; it is an
/// answer about the spec rather than a mistake in it, and has an exit code of its own.
pub fn diagnose(model: &Model) -> Vec<Diagnostic> {
    let analysis = |mode: Option<usize>| {
        let set = mode.map_or_else(|| AdmissibleSet::healthy(model), |mode| AdmissibleSet::of_mode(model, mode));
        Some(analyze(model, &set))
    };
    diagnose_by(model, analysis).unwrap_or_default()
}

/// As [`diagnose`], by analyses that somebody else makes or keeps: of the healthy vehicle (`None`) and of modes, by their
/// index. `None` as soon as one of them is not to be had.
pub fn diagnose_by(
    model: &Model,
    mut analysis: impl FnMut(Option<usize>) -> Option<ModeAnalysis>,
) -> Option<Vec<Diagnostic>> {
    let healthy = analysis(None)?;
    let before = |row: &Parallel| healthy.nearest_rows.is_some_and(|r| r.axes == row.axes && r.angle < least_angle());
    let mut found: Vec<Answer> = Vec::new();
    let against = if model.mission.is_some() { model.plan.against.as_slice() } else { &[] };
    let mut facets = 0;
    for &index in against {
        let mode = analysis(Some(index))?;
        facets += mode.facets.unwrap_or(0);
        if facets > MAX_FACETS {
            return Some(vec![too_many_facets(model)]);
        }
        let span = model.modes[index].span;
        let faint = || mode.nearest_rows.filter(|row| !before(row)).and_then(|row| nearly_parallel(&row, span));
        let Some(answer) = judge(model, &mode, span).or_else(faint) else { continue };
        match found.iter_mut().find(|earlier| earlier.is_same(&answer)) {
            Some(earlier) => earlier.modes.push(mode.name),
            None => found.push(Answer { modes: vec![mode.name], ..answer }),
        }
    }
    let healthy = judge(model, &healthy, model.vehicle.mass_span);
    Some(healthy.into_iter().chain(found).map(|answer| answer.diagnostic(model)).collect())
}

/// What is wrong with the healthy vehicle or with some modes.
struct Answer {
    severity: Severity,
    code: &'static str,
    span: Span,
    /// The headline without its subject: "the vehicle cannot hover".
    what: String,
    label: String,
    help: &'static str,
    /// The reserve is a part of the problem.
    reserve: bool,
    /// None for the healthy vehicle.
    modes: Vec<String>,
}

impl Answer {
    fn is_same(&self, other: &Answer) -> bool {
        (self.span, &self.what, &self.label) == (other.span, &other.what, &other.label)
    }

    fn diagnostic(self, model: &Model) -> Diagnostic {
        let who = match self.modes.as_slice() {
            [] => "even without a fault".to_string(),
            [mode] => format!("with fault mode {mode}"),
            [first @ .., last] if first.len() < NAMED => {
                format!("with each of the fault modes {} and {last}", first.join(", "))
            }
            many => format!("with each of {} fault modes ({}, ...)", many.len(), many[..NAMED].join(", ")),
        };
        let message = format!("{who} {}", self.what);
        let pointed = !self.modes.is_empty() && is_written(model, "plan.against");
        let help = if self.modes.len() > 1 { self.help.replace("the mode", "these modes") } else { self.help.into() };
        // Without `against` the plan stands every mode, and no place asks for these.
        let listing = "out by listing the others in `against`";
        let help = if pointed { help } else { help.replace("out of `against`", listing) };
        let mut diagnostic = Diagnostic::new(self.severity, self.code, self.span, message).here(self.label).help(help);
        if self.reserve && is_written(model, "plan.reserve") {
            diagnostic = diagnostic.also(model.plan.reserve_span, "the reserve asked for");
        }
        let them = if self.modes.len() == 1 { "it" } else { "them" };
        if pointed {
            diagnostic.also(model.plan.against_span, format!("the plan must stand {them}"))
        } else {
            diagnostic
        }
    }
}

/// Whether an answer is that the spec is too large, which is a mistake in it.
pub fn is_too_large(answers: &[Diagnostic]) -> bool {
    answers.iter().any(|answer| answer.code == TOO_MANY_FACETS)
}

fn too_many_facets(model: &Model) -> Diagnostic {
    let modes = model.plan.against.len();
    let span = if is_written(model, "plan.against") { model.plan.against_span } else { model.vehicle.span };
    let message = format!("the sets of the {modes} fault modes planned against have more than {MAX_FACETS} facets");
    Diagnostic::error(TOO_MANY_FACETS, span, message)
        .here(format!("{} rotors and {modes} modes", model.vehicle.rotors.len()))
        .help("list fewer modes in `against`, such as those that are most likely; `mavc analyze` takes all of them")
}

/// A warning where two rows can coincide by a tenth of their length.
fn nearly_parallel(row: &Parallel, span: Span) -> Option<Answer> {
    let [a, b] = row.axes;
    (row.angle < least_angle()).then(|| Answer {
        severity: Severity::Warning,
        code: PARALLEL_ROWS,
        span,
        what: format!(
            "the rotors hardly tell {a} from {b}: their rows are {} degrees apart",
            significant(row.angle.to_degrees(), 3)
        ),
        label: format!("rows less than {} degrees apart can coincide", significant(least_angle().to_degrees(), 3)),
        help: "leave the mode out of `against`, or place the rotors so that what is left of them tells the two apart",
        reserve: false,
        modes: Vec::new(),
    })
}

/// Whether the spec says a field rather than leaving it to its default.
fn is_written(model: &Model, field: &str) -> bool {
    model.defaults.iter().all(|default| default.field != field)
}

/// The masses with which a mode hovers, where the spec's is none of them, kg.
#[derive(Clone, Copy)]
enum Possible {
    UpTo(f64),
    /// At least the first, because rotors that cannot stop or are stuck lift that much, and at most the second.
    Between(f64, f64),
    Never,
}

fn judge(model: &Model, mode: &ModeAnalysis, span: Span) -> Option<Answer> {
    let is_healthy = mode.name == HEALTHY;
    // Hover on the edge at less than the heaviest mass lies on it at all masses.
    let at_heaviest = mode.critical_mass_kg.is_some_and(|most| most <= model.vehicle.mass * (1.0 + 1e-6));
    let answer = |severity, code, what: &str, label: String, help| {
        Some(Answer { severity, code, span, what: what.into(), label, help, reserve: false, modes: Vec::new() })
    };
    match (mode.verdict, mode.hover) {
        (Verdict::Controllable, Place::Inside) => {
            let sure = |r: &Robust| {
                r.hover == Certainty::Yes
                    && (model.plan.reserve == 0.0
                        || r.acai_worst.is_some_and(|worst| worst > edge::width(&super::hover(model))))
            };
            let robust = mode.robust.filter(|r| !sure(r))?;
            let label = match (robust.acai_worst, robust.acai_best) {
                (Some(worst), Some(best)) => {
                    format!("its margin lies between {} and {}", significant(worst, 3), significant(best, 3))
                }
                (None, Some(best)) => {
                    format!("its margin is at most {}, and hover can be out of reach", significant(best, 3))
                }
                _ => "no wrench is sure to be given".to_string(),
            };
            let help = match is_healthy {
                true => "narrow the intervals, make the vehicle lighter or change its layout",
                false => "leave the mode out of `against`, narrow the intervals or make the vehicle lighter",
            };
            answer(Severity::Error, NOT_ROBUST, "hover is not sure over the spec's intervals", label, help)
        }
        (Verdict::Controllable, _) if model.plan.reserve > 0.0 => {
            let share = number(100.0 * model.plan.reserve);
            let error = answer(
                Severity::Error,
                HOVER_ON_EDGE,
                "hover lies on the edge of what the vehicle can do, so no reserve is left",
                format!("nothing of the {share} % reserve can be kept"),
                match (is_healthy, at_heaviest) {
                    (true, true) => "set `reserve = 0 %` in `plan`, make the vehicle lighter or change its layout",
                    (true, false) => "set `reserve = 0 %` in `plan`, or change the vehicle's layout",
                    (false, _) => "set `reserve = 0 %` in `plan`, or leave the mode out of `against`",
                },
            );
            error.map(|error| Answer { reserve: true, ..error })
        }
        // Roll, pitch and thrust cannot be controlled independently with fewer than three dimensions.
        (Verdict::Controllable, _) if mode.rank < 3 => answer(
            Severity::Warning,
            HOVER_ON_EDGE,
            "the vehicle cannot be steered, although thrust and torques balance in hover",
            format!("the admissible set has {} of 4 dimensions, so almost no disturbance can be countered", mode.rank),
            match is_healthy {
                true => "change the vehicle's layout",
                false => "leave the mode out of `against`, or change the vehicle's layout",
            },
        ),
        (Verdict::Controllable, _) => answer(
            Severity::Warning,
            HOVER_ON_EDGE,
            "hover lies on the edge of what the vehicle can do",
            "the smallest disturbance in one direction cannot be countered".into(),
            match at_heaviest && mode.facets.is_some() {
                true => "a lighter vehicle or another layout moves hover inside; `mavc analyze` shows by how much",
                false => "another layout moves hover inside; `mavc analyze` shows by how much",
            },
        ),
        (verdict, _) => {
            let mass = model.vehicle.mass;
            let possible = match (mode.critical_mass_kg, mode.least_mass_kg) {
                (Some(most), Some(least)) if least > 0.0 => Possible::Between(least, most),
                (Some(most), _) if most > 0.0 => Possible::UpTo(most),
                _ => Possible::Never,
            };
            let says = format!("; the spec says {} kg", number(mass));
            let label = match possible {
                Possible::UpTo(most) => format!("it could at {} kg or less{says}", down(most, 4)),
                Possible::Between(least, most) if up(least, 4) != down(most, 4) && least < most * (1.0 - 1e-3) => {
                    format!("it could between {} and {} kg{says}", up(least, 4), down(most, 4))
                }
                Possible::Between(least, most) => {
                    format!("it could only at {} kg{says}", significant(0.5 * (least + most), 6))
                }
                Possible::Never => "no mass makes it possible".to_string(),
            };
            let what = match verdict {
                Verdict::Stabilizable => "the vehicle cannot hold its yaw",
                _ => "the vehicle cannot hover",
            };
            let is_stuck = mode.stuck.iter().any(Option::is_some);
            let idles = model.vehicle.rotors.iter().any(|r| r.min_speed > 0.0) && !is_stuck;
            let too_light = matches!(possible, Possible::Between(least, _) if mass < least);
            let help = match (possible, is_healthy) {
                (Possible::UpTo(_), true) => "make the vehicle lighter or change its layout",
                (Possible::UpTo(_), false) => {
                    "leave the mode out of `against`, make the vehicle lighter or change its layout"
                }
                (Possible::Between(..), true) if too_light && idles => "lower `min_speed` or change the layout",
                (Possible::Between(..), false) if too_light && idles => {
                    "leave the mode out of `against`, or lower `min_speed`"
                }
                (Possible::Between(..), true) if !too_light => "make the vehicle lighter or change its layout",
                (Possible::Between(..), false) if !too_light => {
                    "leave the mode out of `against`, make the vehicle lighter or change its layout"
                }
                (_, true) => "change the vehicle's layout",
                (_, false) => "leave the mode out of `against`, or change the vehicle's layout",
            };
            answer(Severity::Error, CANNOT_HOVER, what, label, help)
        }
    }
}
