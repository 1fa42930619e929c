//! Diagnostics from the admissible sets: fault modes the plan must tolerate but cannot.

mod wind;
mod without_yaw;

use super::edge::{self, HoverPlace};
use super::interval::{Certainty, Robust};
use super::parallel::{Parallel, least_angle};
use super::verdict::{HoverVerdict, ModeAnalysis, analyze};
use super::{AdmissibleSet, HEALTHY};
use crate::diagnostic::{Diagnostic, Severity};
use crate::model::Model;
use crate::number::{down, number, significant, up};
use crate::source::Span;

/// Code: in a mode that the plan must tolerate some axis cannot be controlled at hover.
const CANNOT_HOVER: &str = "mavc::analysis::cannot_hover";
/// Code: hover lies on the edge of a set.
const HOVER_ON_EDGE: &str = "mavc::analysis::hover_on_edge";

/// Code: a mode that the plan must tolerate hovers only for some values of the spec's intervals.
pub const NOT_ROBUST: &str = "mavc::analysis::not_robust";

/// Code: a fault mode makes two rows of the actuation matrix nearly parallel.
pub const PARALLEL_ROWS: &str = "mavc::analysis::parallel_rows";

/// Code: the sets of the modes that the plan must tolerate have more than [`MAX_FACETS`] facets.
const TOO_MANY_FACETS: &str = "mavc::plan::too_many_facets";

/// The largest number of facets of all modes that the plan must tolerate. Before planning each set is reduced to its
/// minimal description in time quadratic in its facets: 1.1 s for a ring of 32 rotors, so about a minute for this many.
pub(crate) const MAX_FACETS: usize = 100_000;

/// Number of modes that a message names individually. If there are more, it names this many and gives the total.
const NAMED: usize = 8;

/// Diagnostics about the healthy vehicle and about every mode that the plan must tolerate; without a mission, about the
/// healthy vehicle only. Modes with the same result at the same place in the spec share one diagnostic.
///
/// A mode without full control is an error, and so is one with hover on the edge of its set if a reserve is required.
/// Both are findings about the spec rather than mistakes in it, so the command has a separate exit code for them.
pub fn diagnose(model: &Model) -> Vec<Diagnostic> {
    let analysis = |mode: Option<usize>| {
        let set = mode.map_or_else(|| AdmissibleSet::healthy(model), |mode| AdmissibleSet::of_mode(model, mode));
        Some(analyze(model, &set))
    };
    diagnose_by(model, analysis).unwrap_or_default()
}

/// The errors and warnings of [`diagnose`], for which the caller provides the analyses: of the healthy vehicle for
/// `None`, and of a mode for its index. Returns `None` as soon as the caller returns `None`.
pub(crate) fn diagnose_by(
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
        let answer = match without_yaw::judge(model, &mode, index) {
            without_yaw::YawFinding::YawKept => judge(model, &mode, span),
            without_yaw::YawFinding::Nothing => None,
            without_yaw::YawFinding::Answer(answer) => Some(answer),
        };
        let Some(mut answer) = answer.or_else(faint) else { continue };
        answer.also = without_yaw::could_be_planned(model, &mode, index).filter(|_| answer.severity == Severity::Error);
        match found.iter_mut().find(|earlier| earlier.is_same(&answer)) {
            Some(earlier) => {
                earlier.modes.push(mode.name);
                if earlier.span != span && !earlier.others.contains(&span) {
                    earlier.others.push(span);
                }
            }
            None => found.push(Answer { modes: vec![mode.name], ..answer }),
        }
    }
    let healthy = judge(model, &healthy, model.vehicle.mass_span);
    Some(healthy.into_iter().chain(found).map(|answer| answer.diagnostic(model)).collect())
}

/// A finding about the healthy vehicle or about some modes.
struct Answer {
    severity: Severity,
    code: &'static str,
    span: Span,
    /// The headline without the names of the modes: "the vehicle cannot hover".
    what: String,
    label: String,
    help: &'static str,
    /// Whether to point at the reserve as part of the problem.
    reserve: bool,
    /// Names of the modes; empty for the healthy vehicle.
    modes: Vec<String>,
    /// The other places of these modes.
    others: Vec<Span>,
    /// A further way to plan.
    also: Option<&'static str>,
}

impl Answer {
    fn new(severity: Severity, code: &'static str, span: Span, what: &str, label: String, help: &'static str) -> Self {
        Answer {
            severity,
            code,
            span,
            what: what.into(),
            label,
            help,
            reserve: false,
            modes: Vec::new(),
            others: Vec::new(),
            also: None,
        }
    }

    /// Whether two modes have the same finding, wherever they stand.
    fn is_same(&self, other: &Answer) -> bool {
        let of = |answer: &Answer| (answer.code, answer.help, answer.also);
        of(self) == of(other) && (&self.what, &self.label) == (&other.what, &other.label)
    }

    fn diagnostic(self, model: &Model) -> Diagnostic {
        let who = match self.modes.as_slice() {
            [] => "even without a fault".to_string(),
            [mode] => format!("in fault mode {mode}"),
            [first @ .., last] if first.len() < NAMED => {
                format!("in each of the fault modes {} and {last}", first.join(", "))
            }
            many => format!("in each of {} fault modes ({}, ...)", many.len(), many[..NAMED].join(", ")),
        };
        let message = format!("{who} {}", self.what);
        let pointed = !self.modes.is_empty() && is_written(model, "plan.against");
        let help = if self.modes.len() > 1 { self.help.replace("the mode", "these modes") } else { self.help.into() };
        // Without `against` the plan must tolerate every mode, and there is no list to take a mode out of.
        let listing = "out by listing the others in `against`";
        let help = if pointed { help } else { help.replace("out of `against`", listing) };
        let help = self
            .also
            .filter(|also| !help.contains(also))
            .map_or(help.clone(), |also| format!("{also}; otherwise {help}"));
        let mut diagnostic = Diagnostic::new(self.severity, self.code, self.span, message).here(self.label).help(help);
        if self.reserve && is_written(model, "plan.reserve") {
            diagnostic = diagnostic.also(model.plan.reserve_span, "the required reserve");
        }
        for &other in self.others.iter().take(NAMED) {
            diagnostic = diagnostic.also(other, "likewise");
        }
        let them = if self.modes.len() == 1 { "it" } else { "them" };
        if pointed {
            diagnostic.also(model.plan.against_span, format!("the plan must tolerate {them}"))
        } else {
            diagnostic
        }
    }
}

/// Whether one of the diagnostics is that the spec has too many facets, which is a mistake in the spec.
pub(crate) fn is_too_large(answers: &[Diagnostic]) -> bool {
    answers.iter().any(|answer| answer.code == TOO_MANY_FACETS)
}

fn too_many_facets(model: &Model) -> Diagnostic {
    let modes = model.plan.against.len();
    let span = if is_written(model, "plan.against") { model.plan.against_span } else { model.vehicle.span };
    let message = format!("the admissible sets of the {modes} fault modes have more than {MAX_FACETS} facets together");
    Diagnostic::error(TOO_MANY_FACETS, span, message)
        .here(format!("{} rotors and {modes} modes", model.vehicle.rotors.len()))
        .help("list fewer modes in `against`, such as the most likely ones; `mavc analyze` accepts all of them")
}

/// A warning if errors of 10 % of their length can make the two rows coincide.
fn nearly_parallel(row: &Parallel, span: Span) -> Option<Answer> {
    let [a, b] = row.axes;
    (row.angle < least_angle()).then(|| Answer {
        severity: Severity::Warning,
        code: PARALLEL_ROWS,
        span,
        what: format!(
            "the effects of the rotors on {a} and {b} are nearly parallel: the rows of the actuation matrix are {} \
             degrees apart",
            significant(row.angle.to_degrees(), 3)
        ),
        label: format!(
            "errors of 10 % can make rows less than {} degrees apart coincide",
            significant(least_angle().to_degrees(), 3)
        ),
        help: "leave the mode out of `against`, or place the rotors so that the remaining ones separate the two axes",
        reserve: false,
        modes: Vec::new(),
        others: Vec::new(),
        also: None,
    })
}

/// Whether the spec contains a field instead of leaving it at its default.
fn is_written(model: &Model, field: &str) -> bool {
    model.defaults.iter().all(|default| default.field != field)
}

/// The masses, kg, at which a mode has full control at hover. The spec's mass is not one of them.
#[derive(Clone, Copy)]
enum Possible {
    UpTo(f64),
    /// From the first to the second: rotors that cannot stop or are stuck lift at least the first.
    Between(f64, f64),
    Never,
}

impl Possible {
    fn of(mode: &ModeAnalysis) -> Self {
        match (mode.critical_mass_kg, mode.least_mass_kg) {
            (Some(most), Some(least)) if least > 0.0 => Possible::Between(least, most),
            (Some(most), _) if most > 0.0 => Possible::UpTo(most),
            _ => Possible::Never,
        }
    }
}

/// The finding about the healthy vehicle or a mode; `None` if hover lies inside its set.
fn judge(model: &Model, mode: &ModeAnalysis, span: Span) -> Option<Answer> {
    match (mode.verdict, mode.hover) {
        (HoverVerdict::Controllable, HoverPlace::Inside) => not_robust(model, mode, span),
        (HoverVerdict::Controllable, HoverPlace::OnEdge | HoverPlace::Outside) => Some(on_the_edge(model, mode, span)),
        (HoverVerdict::Stabilizable | HoverVerdict::Unstable, _) => Some(cannot_hover(model, mode, span)),
    }
}

/// Hover is inside the set, but not for every value of the spec's intervals, or not by a margin.
fn not_robust(model: &Model, mode: &ModeAnalysis, span: Span) -> Option<Answer> {
    let sure = |r: &Robust| {
        r.hover == Certainty::Yes
            && (model.plan.reserve == 0.0
                || r.acai_worst.is_some_and(|worst| worst > edge::width(&super::hover(model))))
    };
    let robust = mode.robust.filter(|r| !sure(r))?;
    let label = match (robust.acai_worst, robust.acai_best) {
        (Some(worst), Some(best)) => {
            format!("the margin of hover is between {} and {}", significant(worst, 3), significant(best, 3))
        }
        (None, Some(best)) => {
            format!("the margin of hover is at most {}, and hover may be unreachable", significant(best, 3))
        }
        _ => "no wrench is guaranteed for all values of the intervals".to_string(),
    };
    let help = match mode.name == HEALTHY {
        true => "narrow the intervals, make the vehicle lighter or change its layout",
        false => "leave the mode out of `against`, narrow the intervals or make the vehicle lighter",
    };
    let what = "hover is not guaranteed over the spec's intervals";
    Some(Answer::new(Severity::Error, NOT_ROBUST, span, what, label, help))
}

fn on_the_edge(model: &Model, mode: &ModeAnalysis, span: Span) -> Answer {
    let is_healthy = mode.name == HEALTHY;
    // If hover is on the edge although a heavier vehicle could hover, it is on the edge at every mass.
    let at_heaviest = mode.critical_mass_kg.is_some_and(|most| most <= model.vehicle.mass * (1.0 + 1e-6));
    let answer = |severity, what, label, help| Answer::new(severity, HOVER_ON_EDGE, span, what, label, help);
    if model.plan.reserve > 0.0 {
        let share = number(100.0 * model.plan.reserve);
        let error = answer(
            Severity::Error,
            "hover lies on the edge of the admissible set, so no reserve is left",
            format!("the {share} % reserve cannot be kept"),
            match (is_healthy, at_heaviest) {
                (true, true) => "set `reserve = 0 %` in `plan`, make the vehicle lighter or change its layout",
                (true, false) => "set `reserve = 0 %` in `plan`, or change the vehicle's layout",
                (false, _) => "set `reserve = 0 %` in `plan`, or leave the mode out of `against`",
            },
        );
        return Answer { reserve: true, ..error };
    }
    // Roll, pitch and thrust cannot be controlled independently with fewer than three dimensions.
    if mode.rank < 3 {
        return answer(
            Severity::Warning,
            "the vehicle cannot be steered, although thrust and torques balance in hover",
            format!("the admissible set has {} of 4 dimensions, so almost no disturbance can be countered", mode.rank),
            match is_healthy {
                true => "change the vehicle's layout",
                false => "leave the mode out of `against`, or change the vehicle's layout",
            },
        );
    }
    answer(
        Severity::Warning,
        "hover lies on the edge of the admissible set",
        "even the smallest disturbance in one direction cannot be countered".into(),
        match at_heaviest && mode.facets.is_some() {
            true => "a lighter vehicle or another layout moves hover inside; `mavc analyze` shows by how much",
            false => "another layout moves hover inside; `mavc analyze` shows by how much",
        },
    )
}

fn cannot_hover(model: &Model, mode: &ModeAnalysis, span: Span) -> Answer {
    let mass = model.vehicle.mass;
    let possible = Possible::of(mode);
    let without_yaw = mode.critical_mass_yaw_free_kg.filter(|most| *most > 0.0 && *most < mass);
    let what = match mode.verdict {
        HoverVerdict::Stabilizable => "the vehicle cannot hold its yaw",
        HoverVerdict::Controllable | HoverVerdict::Unstable => "the vehicle cannot hover",
    };
    let (label, help) = match wind::is_the_cause(model, mode) {
        Some(label) => (label, wind::HELP),
        None => (
            possible_masses(possible, mass, without_yaw.filter(|_| mode.verdict != HoverVerdict::Stabilizable)),
            help_to_hover(possible, model, mode, without_yaw.is_some()),
        ),
    };
    Answer::new(Severity::Error, CANNOT_HOVER, span, what, label, help)
}

/// At which masses (kg) the mode could hover, where the spec's is `mass`; `without_yaw` is the largest with yaw given
/// up.
fn possible_masses(possible: Possible, mass: f64, without_yaw: Option<f64>) -> String {
    let given = format!("; the spec's mass is {} kg", number(mass));
    match possible {
        Possible::UpTo(most) => format!("possible at {} kg or less{given}", down(most, 4)),
        Possible::Between(least, most) if up(least, 4) != down(most, 4) && least < most * (1.0 - 1e-3) => {
            format!("possible between {} and {} kg{given}", up(least, 4), down(most, 4))
        }
        Possible::Between(least, most) => {
            format!("possible only at {} kg{given}", significant(0.5 * (least + most), 6))
        }
        Possible::Never => match without_yaw {
            Some(most) => {
                format!("with control of yaw at no mass; with yaw given up at {} kg or less{given}", down(most, 4))
            }
            None => "not possible at any mass".to_string(),
        },
    }
}

fn help_to_hover(possible: Possible, model: &Model, mode: &ModeAnalysis, has_mass_without_yaw: bool) -> &'static str {
    let is_stuck = mode.stuck.iter().any(Option::is_some);
    let idles = model.vehicle.rotors.iter().any(|r| r.min_speed > 0.0) && !is_stuck;
    let too_light = matches!(possible, Possible::Between(least, _) if model.vehicle.mass < least);
    match (possible, mode.name == HEALTHY) {
        (Possible::Never, false) if has_mass_without_yaw => {
            "leave the mode out of `against`, make the vehicle lighter or change its layout"
        }
        (Possible::UpTo(_), true) => "make the vehicle lighter or change its layout",
        (Possible::UpTo(_), false) => "leave the mode out of `against`, make the vehicle lighter or change its layout",
        (Possible::Between(..), true) if too_light && idles => {
            "lower `min_speed` or `min_thrust`, or change the layout"
        }
        (Possible::Between(..), false) if too_light && idles => {
            "leave the mode out of `against`, or lower `min_speed` or `min_thrust`"
        }
        (Possible::Between(..), true) if !too_light => "make the vehicle lighter or change its layout",
        (Possible::Between(..), false) if !too_light => {
            "leave the mode out of `against`, make the vehicle lighter or change its layout"
        }
        (_, true) => "change the vehicle's layout",
        (_, false) => "leave the mode out of `against`, or change the vehicle's layout",
    }
}
