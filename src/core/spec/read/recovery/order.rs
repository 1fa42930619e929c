//! The order of ways out: `order` in `recovery` of the plan, and `recovery` of a fault mode.

use super::{GROUND, ORDER};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::table::WAYS;
use crate::model::{LandingSite, Mission, Recovery};
use crate::read::context::Context;
use crate::read::fault::Modes;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Expr, ExprKind};

/// An order as written, before the landing sites are known: at least one name, without repetitions.
#[derive(Debug, Clone)]
pub struct Order(Vec<Spanned<String>>);

/// Reads the list that is the value of `field`; `None` where it has an error.
pub fn read(cx: &mut Context, field: &str, expr: &Expr) -> Option<Order> {
    let example = format!("write `{field} = [{}]`", WAYS.join(", "));
    let elements = match &expr.kind {
        ExprKind::List { elements, unit: None } => elements,
        kind => {
            let error = Diagnostic::error(ORDER, expr.span, format!("`{field}` takes a list of ways out"));
            let error = error.here("not a list");
            cx.report(match kind {
                ExprKind::Name(name) => {
                    error.help(format!("write `[{name}]`, in brackets")).fix(expr.span, format!("[{name}]"))
                }
                _ => error.help(example),
            });
            return None;
        }
    };
    if elements.is_empty() {
        let error = Diagnostic::error(ORDER, expr.span, format!("`{field}` lists no way out"));
        cx.report(error.here("an empty list").help(format!("{example}, or remove the field")));
        return None;
    }
    let (mut ways, mut is_fine) = (Vec::<Spanned<String>>::new(), true);
    for element in elements {
        let ExprKind::Name(name) = &element.kind else {
            let error = Diagnostic::error(ORDER, element.span, "a way out is a word or the name of a landing site");
            let error = error.here("neither of these");
            cx.report(match &element.kind {
                ExprKind::Text(text) => {
                    error.help(format!("remove the quotes: write `{text}`")).fix(element.span, text.as_str())
                }
                _ => error.help(example.clone()),
            });
            is_fine = false;
            continue;
        };
        if let Some(first) = ways.iter().find(|way| way.value == *name) {
            let error = Diagnostic::error(ORDER, element.span, format!("`{name}` is listed twice in `{field}`"));
            let error = error.here("listed again").also(first.span, "first listed here");
            cx.report(error.help("remove one: each way out is tried once"));
            is_fine = false;
            continue;
        }
        ways.push(Spanned::new(name.clone(), element.span));
    }
    is_fine.then_some(Order(ways))
}

impl Order {
    /// The ways out of a spec with this mission, or with none; `None` where a name is unknown or something that a way
    /// out needs is missing.
    pub fn resolve(&self, cx: &mut Context, mission: Option<&Mission>) -> Option<Vec<Recovery>> {
        let sites = mission.map_or(&[][..], |mission| &mission.after_fault.sites);
        let ways: Vec<Option<Recovery>> = self.0.iter().map(|way| one(cx, way, sites, mission)).collect();
        ways.into_iter().collect()
    }
}

fn one(cx: &mut Context, way: &Spanned<String>, sites: &[LandingSite], mission: Option<&Mission>) -> Option<Recovery> {
    match way.value.as_str() {
        "continue" => Some(Recovery::Continue),
        "land_at_sites" => Some(Recovery::LandAtSites),
        "land_here" => has_ground(cx, way.span, mission).then_some(Recovery::LandHere),
        name => {
            let index = sites.iter().position(|site| site.name == name);
            if index.is_none() {
                let mut known: Vec<&str> = sites.iter().map(|site| site.name.as_str()).collect();
                if !known.is_empty() || nearest(name, WAYS.iter().copied()).is_some() {
                    known.extend(WAYS);
                }
                cx.unknown("landing site", name, way.span, &known);
            }
            index.map(Recovery::LandAt)
        }
    }
}

/// Whether the height at which the vehicle touches down is known; reports that it is not.
fn has_ground(cx: &mut Context, span: Span, mission: Option<&Mission>) -> bool {
    let Some(mission) = mission.filter(|mission| mission.ground.is_none()) else { return true };
    let error = Diagnostic::error(GROUND, span, "`land_here` needs the height of the ground").here("where it lands");
    cx.report(error.also(mission.span, "no `ground`").help("add `ground = 0 m` to the mission"));
    false
}

/// Gives the modes their own orders; whether these have no errors.
pub fn of_modes(cx: &mut Context, modes: &mut Modes, mission: Option<&Mission>) -> bool {
    let mut is_fine = true;
    for (statement, order) in std::mem::take(&mut modes.orders) {
        let ways = order.resolve(cx, mission);
        is_fine &= ways.is_some();
        for (mode, _) in modes.modes.iter_mut().zip(&modes.origin).filter(|(_, origin)| **origin == statement) {
            mode.recovery.clone_from(&ways);
        }
    }
    is_fine
}
