//! The `campaign` block: how many flights with faults are flown, and with the plans of which planners.

use super::context::{Context, either};
use super::defaulted::Defaulted;
use super::edits;
use super::fields::Fields;
use super::simulate::{Around, seed};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::Group;
use crate::language::table::campaign as table;
use crate::model::{Campaign, DefaultUsed, PlannerKind};
use crate::number::{number, plural};
use crate::source::Span;
use crate::syntax::ast::{Block, Expr, ExprKind};

const CHOICE: &str = "mavc::campaign::choice";
const COUNT: &str = "mavc::campaign::count";
/// The most flights that one campaign may have.
const MAX_FLIGHTS: f64 = 1e8;
const PLANNERS: [PlannerKind; 3] = [PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp];

/// Reads the block. The campaign is `None` where it has errors; defaults are listed only if the block is written.
pub(super) fn elaborate<'a>(
    cx: &mut Context<'a>,
    block: Option<&'a Block>,
    around: &Around,
) -> (Option<Campaign>, Vec<DefaultUsed>) {
    let Some(block) = block else {
        return (Some(Campaign { span: around.fallback, ..Campaign::default() }), Vec::new());
    };
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, "`campaign`".into(), span, &block.body, Group::Campaign);
    let mut fields = Defaulted::new("campaign", fields);
    let campaign = read(cx, block, &mut fields, around);
    (campaign, fields.used)
}

fn read<'a>(cx: &mut Context<'a>, block: &'a Block, fields: &mut Defaulted<'a>, around: &Around) -> Option<Campaign> {
    let span = block.keyword.span;
    let times = fields.count_or_default(cx, &table::TIMES, COUNT);
    let seeds = fields.count_or_default(cx, &table::SEEDS, COUNT);
    let planners = fields.value_or(&table::PLANNERS, PLANNERS.to_vec(), |expr| planners(cx, expr));
    let seed = fields.value_or(&table::SEED, table::SEED.value() as u64, |expr| seed(cx, expr));
    if around.modes.is_empty() && !around.incomplete {
        let message = "the campaign has no fault modes";
        let warning = Diagnostic::warning("mavc::campaign::no_modes", span, message).here("no flight has a fault");
        cx.report(warning.help("declare fault modes, as in `faults { every 1 rotor lost as M }`"));
    }
    let campaign = Campaign { times: times?, seeds: seeds?, planners: planners?, seed: seed?, written: true, span };
    let place = fields.get("seeds").or(fields.get("times")).map_or(span, |expr| expr.span);
    (block.is_whole() && few_enough(cx, &campaign, around.modes.len(), place)).then_some(campaign)
}

/// One name or a list of them.
fn planners<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<Vec<PlannerKind>> {
    let elements = match &expr.kind {
        ExprKind::Name(_) => std::slice::from_ref(expr),
        ExprKind::List { elements, unit: None } => elements,
        _ => {
            let error = Diagnostic::error(CHOICE, expr.span, "`planners` takes a planner or a list of planners");
            cx.report(error.here("not a planner").help("write `[rip, rsp, rcp]`"));
            return None;
        }
    };
    if elements.is_empty() {
        let error = Diagnostic::error(CHOICE, expr.span, "a campaign needs at least one planner");
        cx.report(error.here("empty list").help("write `[rip, rsp, rcp]`, or remove `planners`"));
        return None;
    }
    let (mut chosen, mut fine) = (Vec::new(), true);
    for element in elements {
        match planner(cx, element) {
            Some(planner) if chosen.contains(&planner) => {
                let message = format!("`{}` is listed twice", planner.name());
                let warning = Diagnostic::warning("mavc::campaign::listed_twice", element.span, message);
                let again = edits::element(cx.sources.get(element.span.file), element.span);
                cx.report(warning.here("already listed").help("remove it").fix(again, ""));
            }
            Some(planner) => chosen.push(planner),
            None => fine = false,
        }
    }
    fine.then_some(chosen)
}

fn planner(cx: &mut Context, expr: &Expr) -> Option<PlannerKind> {
    let names = PLANNERS.map(PlannerKind::name);
    let word = if let ExprKind::Name(name) = &expr.kind { name.as_str() } else { "" };
    if let Some(k) = names.iter().position(|name| *name == word) {
        return Some(PLANNERS[k]);
    }
    let error = Diagnostic::error(CHOICE, expr.span, format!("a planner must be {}", either(&names)));
    let error = error.here("not a planner");
    cx.report(match nearest(word, names) {
        Some(near) => error.help(format!("did you mean `{near}`?")).fix(expr.span, near),
        None => error.help("list the planners, as in `[rip, rsp]`"),
    });
    None
}

/// Whether there are few enough flights: one for each time, seed, mode and planner.
fn few_enough(cx: &mut Context, campaign: &Campaign, modes: usize, span: Span) -> bool {
    let parts = [campaign.times, campaign.seeds, modes, campaign.planners.len()];
    let flights: f64 = parts.iter().map(|&n| n as f64).product();
    if flights <= MAX_FLIGHTS {
        return true;
    }
    let [times, seeds, modes, planners] = parts;
    let message = format!("a campaign may have at most 100 million flights, not {}", number(flights));
    let error = Diagnostic::error("mavc::campaign::too_many_flights", span, message).here(format!(
        "{}, {}, {} and {}",
        plural(times, "time"),
        plural(seeds, "seed"),
        plural(modes, "mode"),
        plural(planners, "planner")
    ));
    cx.report(error.help("reduce `times` or `seeds`; 10 seeds are usual"));
    false
}
