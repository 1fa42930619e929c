//! `require capture_height { }`: the height above the ground that a plan keeps, because a fault that leaves no control
//! of yaw costs it. The height itself is simulated once the model is complete (`crate::flight::capture`).

use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::requirement as table;
use crate::model::{CaptureHeight, DefaultUsed, Detection, Mission, Rotor, Simulation, Vehicle};
use crate::read::context::Context;
use crate::read::defaulted::Defaulted;
use crate::read::fields::Fields;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr, ExprKind, Statement};

const CODE: &str = "mavc::plan::capture_height";

/// The statement before the mission and the flights are known.
#[derive(Debug, Clone, Copy)]
pub struct Required {
    /// m
    radius: f64,
    /// Its own delay, s.
    detection: Option<f64>,
    span: Span,
}

/// Whether a block of a plan is this statement, or was meant to be.
pub fn is_one(block: &Block) -> bool {
    block.keyword.value == "require"
}

/// Reads the statement.
pub fn read<'a>(cx: &mut Context<'a>, body: &'a [Statement], defaults: &mut Vec<DefaultUsed>) -> Written<Required> {
    let mut blocks = body.iter().filter_map(|s| if let Statement::Block(block) = s { Some(block) } else { None });
    let Some(first) = blocks.find(|block| is_one(block)) else { return Written::Absent };
    if let Some(second) = blocks.find(|block| is_one(block)) {
        let message = "`require capture_height` is given twice in `plan`";
        let error = Diagnostic::error("mavc::name::duplicate", head(second), message).here("given again");
        cx.report(error.also(head(first), "first given here").help("remove one"));
        return Written::Faulty;
    }
    Written::of(one(cx, first, defaults))
}

/// From the keyword to the name.
fn head(block: &Block) -> Span {
    block.name.as_ref().map_or(block.keyword.span, |name| block.keyword.span.to(name.span))
}

fn one<'a>(cx: &mut Context<'a>, block: &'a Block, defaults: &mut Vec<DefaultUsed>) -> Option<Required> {
    let span = head(block);
    match block.name.as_ref().map(|name| (name.value.as_str(), name.span)) {
        Some(("capture_height", _)) => {}
        Some(("risk", at)) => {
            let error = Diagnostic::error("mavc::plan::require", at, "`require risk` takes a bound, not a block");
            cx.report(error.here("needs a bound").help("write `require risk <= 1e-6`"));
            return None;
        }
        Some(("uncovered", at)) => {
            let message = "`require uncovered` takes a bound, not a block";
            let error = Diagnostic::error("mavc::plan::require", at, message).here("needs a bound");
            cx.report(error.help("write `require uncovered <= 0 %`; its settings go into `recovery { }`"));
            return None;
        }
        Some((other, at)) => {
            let error = Diagnostic::error("mavc::plan::require", at, format!("`{other}` cannot be required"));
            let error = error.here("none of `risk`, `uncovered` and `capture_height`");
            cx.report(error.help("write `require capture_height { }`").fix(at, "capture_height"));
            return None;
        }
        // A block without its name is an error of the syntax.
        None => return None,
    }
    let fields = Fields::of_block(cx, "`require capture_height`".into(), span, &block.body, Group::Requirement);
    let mut fields = Defaulted::new("plan.require", fields);
    let radius = fields.quantity_or_default(cx, &table::RADIUS, CODE);
    let detection = fields.written(table::DETECTION.name, |expr| match expr {
        Expr { kind: ExprKind::Name(word), span } if word == "never" || word == "estimator" => {
            let error = Diagnostic::error(CODE, *span, format!("`{word}` says no delay after which a fault is known"));
            cx.report(
                error.here("a delay is needed").help("write a delay, such as `100 ms`: the height depends on it"),
            );
            None
        }
        expr => cx.quantity(&table::DETECTION, expr, CODE),
    });
    defaults.append(&mut fields.used);
    let required = Required { radius: radius?, detection: detection.optional().ok()?, span };
    block.is_whole().then_some(required)
}

/// The requirement, if the rest of the spec gives what it needs: a ground, a bound on the speed, the lag of every
/// rotor, and the delay after which a fault is known. Reports what is missing.
pub fn check(
    cx: &mut Context,
    required: Required,
    mission: Option<&Mission>,
    vehicle: Option<&Vehicle>,
    simulation: Option<&Simulation>,
) -> Option<CaptureHeight> {
    let Required { radius, detection, span } = required;
    let mut fine = true;
    let mut needs = |what: &str, at: Option<Span>, label: &str, help: &str| {
        let error =
            Diagnostic::error(CODE, span, format!("`require capture_height` needs {what}")).here("required here");
        let error = at.map_or(error.clone(), |at| error.also(at, label));
        cx.report(error.help(help));
        fine = false;
    };
    if let Some(mission) = mission {
        if mission.ground.is_none() {
            needs("the height of the ground", Some(mission.span), "no `ground`", "add `ground = 0 m` to the mission");
        }
        if mission.top_speed().is_none() {
            let help = "add `limits { speed <= 8 m/s }` to the mission";
            needs("a limit on the speed, on which the height depends", Some(mission.span), "no such limit", help);
        }
    }
    let silent = |rotor: &Rotor| rotor.time_constant.is_none();
    if let Some(vehicle) = vehicle.filter(|vehicle| vehicle.rotors.iter().any(silent)) {
        let which = match vehicle.rotors.iter().position(silent) {
            Some(first) if vehicle.rotors.iter().any(|rotor| !silent(rotor)) => format!("rotor {} has none", first + 1),
            _ => "its rotors have none".to_string(),
        };
        let help = "add `time_constant = 20 ms` to the vehicle's `rotor` block, with its own value";
        needs("the `time_constant` of every rotor", Some(vehicle.span), &which, help);
    }
    let of_flights = simulation.and_then(|simulation| match simulation.detection {
        Detection::After(delay) => Some(delay),
        Detection::Never | Detection::Estimator => None,
    });
    let delay = detection.or(of_flights);
    if delay.is_none() && simulation.is_some() {
        let help = "write `require capture_height { detection = 100 ms }`, or a delay as `detection` in `simulate`";
        needs("the delay after which a fault is known", None, "", help);
    }
    delay.filter(|_| fine).map(|delay| CaptureHeight { radius, delay, height: None, span })
}
