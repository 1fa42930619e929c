//! What the sets say about the spec: modes that the plan must stand but cannot.

use super::AdmissibleSet;
use super::verdict::{ModeAnalysis, Verdict, analyze};
use crate::diagnostic::Diagnostic;
use crate::model::Model;
use crate::report::number::{number, significant};

/// A mode that the plan must stand has lost control over some axis.
pub const CANNOT_HOVER: &str = "mavc::analysis::cannot_hover";
/// Hover lies on the edge of a set.
pub const HOVER_ON_EDGE: &str = "mavc::analysis::hover_on_edge";

/// Diagnostics of the healthy vehicle and of every mode that the plan stands against.
///
/// A mode without full control, or with hover on its edge where a reserve is asked for, is an error; it is an
/// answer about the spec rather than a mistake in it, and has an exit code of its own.
pub fn diagnose(model: &Model) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let healthy = analyze(model, &AdmissibleSet::healthy(model));
    judge(model, &healthy, None, &mut found);
    for &index in &model.plan.against {
        let set = AdmissibleSet::of_mode(model, index);
        judge(model, &analyze(model, &set), Some(index), &mut found);
    }
    found
}

fn judge(model: &Model, mode: &ModeAnalysis, index: Option<usize>, found: &mut Vec<Diagnostic>) {
    let who = match index {
        Some(_) => format!("with fault mode {}", mode.name),
        None => "even without a fault".to_string(),
    };
    let span = index.map_or(model.vehicle.mass_span, |i| model.modes[i].span);
    let planned = |d: Diagnostic| match index {
        Some(_) => d.also(model.plan.against_span, "the plan must stand it"),
        None => d,
    };
    match (mode.verdict, mode.interior) {
        (Verdict::Controllable, true) => {}
        (Verdict::Controllable, false) if model.plan.reserve > 0.0 => {
            let share = number(100.0 * model.plan.reserve);
            found.push(planned(
                Diagnostic::error(
                    HOVER_ON_EDGE,
                    span,
                    format!("{who} hover lies on the edge of what the vehicle can do, so no reserve is left"),
                )
                .here(format!("nothing of the {share} % reserve can be kept"))
                .also(model.plan.reserve_span, "the reserve asked for")
                .help("set `reserve = 0 %`, or leave the mode out of `against`"),
            ));
        }
        (Verdict::Controllable, false) => found.push(planned(
            Diagnostic::warning(
                HOVER_ON_EDGE,
                span,
                format!("{who} hover lies on the edge of what the vehicle can do"),
            )
            .here("the smallest disturbance in one direction cannot be countered")
            .help("a lighter vehicle or another layout moves hover inside; `mavc analyze` shows by how much"),
        )),
        (verdict, _) => {
            let lacking = match verdict {
                Verdict::Stabilizable => "cannot hold its yaw",
                _ => "cannot hover",
            };
            let mass = match mode.critical_mass_kg {
                Some(m) if m > 0.0 => format!(
                    "it could at {} kg or less; the spec says {} kg",
                    significant(m, 4),
                    number(model.vehicle.mass)
                ),
                _ => "no mass makes it possible".to_string(),
            };
            let help = match index {
                Some(_) => "leave the mode out of `against`, make the vehicle lighter or change its layout",
                None => "make the vehicle lighter or change its layout",
            };
            found.push(planned(
                Diagnostic::error(CANNOT_HOVER, span, format!("{who} the vehicle {lacking}")).here(mass).help(help),
            ));
        }
    }
}
