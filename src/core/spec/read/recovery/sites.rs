//! Reads `landing_site` blocks.

use super::{GROUND, SITE, TOO_MANY, VALUE};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::{WAYS, landing_site as table};
use crate::model::LandingSite;
use crate::number::number;
use crate::read::context::{Context, duplicate};
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::mission::MAX_DISTANCE;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::Block;

/// The most landing sites of a mission: a way out may be sought to each of them, at every instant and for every mode.
const MOST: usize = 100;

/// Reads the blocks of the mission at `mission`, in the order written; `None` where one has an error.
pub fn read<'a>(
    cx: &mut Context<'a>,
    blocks: &[&'a Block],
    ground: Written<f64>,
    mission: Span,
) -> Option<Vec<LandingSite>> {
    if let Some(block) = blocks.get(MOST) {
        let message = format!("a mission may have at most {MOST} landing sites");
        let error = Diagnostic::error(TOO_MANY, block.keyword.span, message).here("the limit is exceeded here");
        cx.report(error.help("leave out those far from the path"));
        return None;
    }
    let (mut sites, mut is_fine) = (Vec::<LandingSite>::new(), true);
    for block in blocks {
        let site = one(cx, block);
        if let Some(name) = &block.name {
            if WAYS.contains(&name.value.as_str()) {
                let message = format!("`{}` is reserved and cannot name a landing site", name.value);
                let error = Diagnostic::error("mavc::name::reserved", name.span, message);
                cx.report(error.here("a way out without a place").help("choose another name"));
                is_fine = false;
            } else if let Some(first) = sites.iter().find(|site| site.name == name.value) {
                cx.report(duplicate("landing site", name, first.span));
                is_fine = false;
            }
            if site.is_none() {
                // An order may name it, whatever is wrong with it.
                cx.lose(name.value.clone());
            }
        }
        is_fine &= site.is_some();
        sites.extend(site);
    }
    is_fine &= stand_on_ground(cx, &sites, ground, mission);
    is_fine.then_some(sites)
}

fn one<'a>(cx: &mut Context<'a>, block: &'a Block) -> Option<LandingSite> {
    let (name, span) = match &block.name {
        Some(name) => (name.value.clone(), name.span),
        None => (String::new(), block.keyword.span),
    };
    let fields = Fields::of_block(cx, format!("landing site `{name}`"), span, &block.body, Group::LandingSite);
    let at = fields.demand(cx, "at", "at = [12, -8, 0] m").and_then(|expr| {
        let at = cx.triple(Expected::of(&table::AT), expr)?;
        let Some(far) = at.iter().find(|x| x.abs() > MAX_DISTANCE) else { return Some(at) };
        let message = format!("{} lies more than 1000 km from the origin", fields.owner);
        let error = Diagnostic::error(SITE, expr.span, message);
        let error = error.here(format!("a coordinate of {} km", number(far / 1e3)));
        cx.report(error.help("place the origin where the mission starts, and write lengths in m"));
        None
    });
    let radius = fields.demand(cx, "radius", "radius = 2 m").and_then(|expr| {
        let radius = cx.quantity(&table::RADIUS, expr, VALUE)?;
        if radius <= MAX_DISTANCE {
            return Some(radius);
        }
        let error = Diagnostic::error(VALUE, expr.span, "the radius of a landing site must be at most 1000 km");
        cx.report(error.here(format!("this is {} km", number(radius / 1e3))).help("write lengths in m"));
        None
    });
    let site = LandingSite { name, at: at?, radius: radius?, span };
    (block.name.is_some() && block.is_whole()).then_some(site)
}

/// Whether the ground is known and no site is below it; reports the first site for which that fails.
fn stand_on_ground(cx: &mut Context, sites: &[LandingSite], ground: Written<f64>, mission: Span) -> bool {
    let error = |site: &LandingSite, what: String| {
        Diagnostic::error(GROUND, site.span, format!("landing site `{}` {what}", site.name))
    };
    match (ground, sites.first()) {
        (Written::Absent, Some(site)) => {
            let error = error(site, "needs the height of the ground".into()).here("on the ground or above it");
            cx.report(error.also(mission, "no `ground`").help("add `ground = 0 m` to the mission"));
            false
        }
        (Written::Value(ground), Some(_)) => {
            let Some(site) = sites.iter().find(|site| site.at[2] < ground - 1e-9) else { return true };
            let below = number(ground - site.at[2]);
            let error = error(site, format!("is {below} m below the ground")).here(format!("{} m", number(site.at[2])));
            let help = format!("write its height, at least {} m, as the third number of `at`", number(ground));
            cx.report(error.help(help));
            false
        }
        _ => true,
    }
}
