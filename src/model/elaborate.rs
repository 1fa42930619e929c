//! From the tree to the model: collect, evaluate, choose, check.

use super::context::{Context, State, duplicate, no_filter};
use super::due::Due;
use super::fault::Modes;
use super::fields::elsewhere;
use super::flight_blocks::{self, FlightBlocks};
use super::load::FileSet;
use super::overrides::{Override, apply};
use super::plan::{Draft, against};
use super::simulate::Around;
use super::understanding::Understanding;
use super::{DefaultUsed, FaultMode, Model, Vehicle, lag, mission, sense, vehicle};
use crate::diagnostic::{Checked, Diagnostic, Severity, nearest, sort};
use crate::language::Group;
use crate::number::number;
use crate::source::{SourceMap, Span, Spanned};
use crate::syntax::ast::{Block, Expr, Field, FieldValue, Item, SpecFile, Statement};
use crate::unit::GRAVITY;

/// Gives a file set its meaning. Overrides replace or add fields before anything is understood, so they are checked
/// like what they replace. The model is missing where there are errors; diagnostics of loading are not repeated.
///
/// # Steps
/// 1. Collect the blocks of all files.
/// 2. Evaluate gravity and every `let`.
/// 3. Elaborate every vehicle, choose one, and give its faults and missions their numbers.
/// 4. Settle the plan against modes and mission, then what flies it.
pub fn elaborate(files: &FileSet, overrides: &[Override]) -> Checked<Model> {
    elaborate_for(files, overrides, FlightBlocks::Used)
}

/// As [`elaborate`], for a command that may fly nothing.
pub fn elaborate_for(files: &FileSet, overrides: &[Override], flights: FlightBlocks) -> Checked<Model> {
    understand_for(files, overrides, flights).checked
}

/// As [`elaborate`], with what was understood on the way, errors or not.
pub fn understand(files: &FileSet, overrides: &[Override]) -> Understanding {
    understand_for(files, overrides, FlightBlocks::Used)
}

fn understand_for(files: &FileSet, overrides: &[Override], flights: FlightBlocks) -> Understanding {
    let mut trees = files.files.clone();
    let mut diagnostics = apply(&mut trees, overrides);
    let broken = broken(&trees);
    let incomplete = files.incomplete || use_broken(&trees, &files.sources);
    let mut cx = Context::new(&files.sources, incomplete, &broken);
    let whole_text = !incomplete && broken.is_empty();
    // What could not be read may be what makes a model of the rest wrong, or a `let` used.
    let mut parts = Parts::default();
    let value = whole(&mut cx, &trees, files, flights, &mut parts).filter(|_| whole_text);
    cx.settle_suspects();
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    // What a block with mistakes would have used is unknown.
    if value.is_some() && !cx.softened && !cx.diagnostics.iter().chain(&diagnostics).any(is_error) {
        cx.warn_unused();
        cx.warn_idle();
    }
    diagnostics.append(&mut cx.diagnostics);
    sort(&mut diagnostics);
    if cx.dropped + cx.dropped_softly > 0 {
        let end = diagnostics.last().map_or(Span::default(), |d| d.span);
        let message = format!("{} more diagnostics are not shown", cx.dropped + cx.dropped_softly);
        let severity = if cx.dropped > 0 { Severity::Error } else { Severity::Warning };
        diagnostics.push(Diagnostic::new(severity, "mavc::name::too_many", end, message));
    }
    let mut checked = Checked { value, diagnostics };
    if checked.has_errors() {
        checked.value = None;
    }
    let Parts { vehicles, modes } = parts;
    Understanding { checked, gravity: cx.gravity, vehicles, modes, readings: cx.readings }
}

/// What could be made out of a spec, errors elsewhere or not.
#[derive(Default)]
struct Parts {
    vehicles: Vec<Vehicle>,
    modes: Vec<FaultMode>,
}

/// Every statement that could not be read.
fn broken(trees: &[SpecFile]) -> Vec<Span> {
    fn within(body: &[Statement], into: &mut Vec<Span>) {
        for statement in body {
            match statement {
                Statement::Broken(span) => into.push(*span),
                Statement::Block(block) => within(&block.body, into),
                _ => {}
            }
        }
    }
    let mut spans = Vec::new();
    for item in trees.iter().flat_map(|tree| &tree.items) {
        match item {
            Item::Broken(span) => spans.push(*span),
            Item::Block(block) => within(&block.body, &mut spans),
            _ => {}
        }
    }
    spans
}

/// Whether some `use` could not be read: then nobody knows what it brings in.
fn use_broken(trees: &[SpecFile], sources: &SourceMap) -> bool {
    let brings_in = |span: Span| {
        let text = sources.snippet(span);
        // By its keyword, or by what it names where the keyword is misspelt or another language's.
        text.split(|c: char| !c.is_ascii_alphanumeric()).next() == Some("use") || text.contains(".mav")
    };
    trees.iter().flat_map(|tree| &tree.items).any(|item| matches!(item, Item::Broken(span) if brings_in(*span)))
}

/// The fields that stand outside all blocks.

#[derive(Default)]
struct Blocks<'a> {
    vehicles: Vec<&'a Block>,
    faults: Vec<&'a Block>,
    missions: Vec<&'a Block>,
    plans: Vec<&'a Block>,
    simulations: Vec<&'a Block>,
    campaigns: Vec<&'a Block>,
}

fn whole<'a>(
    cx: &mut Context<'a>,
    trees: &'a [SpecFile],
    files: &'a FileSet,
    flights: FlightBlocks,
    parts: &mut Parts,
) -> Option<Model> {
    let items = || trees.iter().flat_map(|tree| &tree.items);
    let mut blocks = Blocks::default();
    let mut gravity: Option<&Field> = None;
    let mut allows = Vec::new();
    for tree in trees {
        // Below a statement that could not be read, a field may belong to the block that it should have opened.
        let mut homeless = false;
        for item in &tree.items {
            match item {
                Item::Block(block) => match block.keyword.value.as_str() {
                    "vehicle" => blocks.vehicles.push(block),
                    "faults" => blocks.faults.push(block),
                    "mission" => blocks.missions.push(block),
                    "plan" => blocks.plans.push(block),
                    "simulate" => blocks.simulations.push(block),
                    "campaign" => blocks.campaigns.push(block),
                    _ => {}
                },
                Item::Field(field) if field.name.value == "allow" => allows.push(field),
                Item::Field(field) if homeless && field.name.value != "gravity" => cx.lose(&field.name.value),
                Item::Field(field) => top_field(cx, field, &mut gravity),
                // A limit was to open none.
                Item::Broken(span) => homeless |= !cx.sources.snippet(*span).contains(['<', '>']),
                Item::Let(_) | Item::Use(_) => {}
            }
        }
    }
    cx.allow(&allows);
    no_second(cx, "vehicle", &blocks.vehicles);
    no_second(cx, "mission", &blocks.missions);
    only_one(cx, &blocks.plans);
    for blocks in [&blocks.simulations, &blocks.campaigns] {
        cx.of_flights(flights, None, |cx| only_one(cx, blocks));
    }
    let mut defaults = Vec::new();
    cx.declare(items().filter_map(|item| if let Item::Let(field) = item { Some(field) } else { None }));
    settle_gravity(cx, gravity, &mut defaults);
    cx.settle();

    let vehicles: Vec<_> = blocks.vehicles.iter().map(|block| vehicle::elaborate(cx, block)).collect();
    let mut draft = Draft::read(cx, blocks.plans.first().copied());
    let named: Vec<(&str, Span)> = vehicles.iter().map(|v| (v.name.as_str(), v.span)).collect();
    let vehicle = choose(cx, &draft, "vehicle", &named, &blocks.vehicles).map(|index| &vehicles[index]);
    defaults.extend(vehicle.iter().flat_map(|v| v.defaults.iter().cloned()));
    let readable = items().all(|item| !matches!(item, Item::Broken(_)));
    if vehicles.is_empty() && readable && !cx.may_exist("vehicle") {
        let span = items().next().map_or(Span::default(), start_of);
        let message = match items().next() {
            Some(_) => "the spec describes no vehicle".to_string(),
            None => format!("`{}` holds no statement, so there is no vehicle", cx.sources.get(span.file).name),
        };
        let error = Diagnostic::error("mavc::name::no_vehicle", span, message);
        cx.report(error.help("add a `vehicle` block, or bring one in with `use \"vehicles/...\"`"));
    }

    let mut modes = Modes::default();
    for block in &blocks.faults {
        modes.take(cx, block, vehicle.and_then(|v| v.rotors));
    }
    modes.finish(cx);
    parts.vehicles = vehicles.iter().filter_map(|v| v.vehicle.clone()).collect();
    parts.modes = modes.modes.clone();
    let (manner, manner_fine) = draft.manner(cx);
    let missions: Vec<_> = blocks.missions.iter().map(|block| mission::elaborate(cx, block, manner, files)).collect();
    let named: Vec<(&str, Span)> = missions.iter().map(|m| (m.name.as_str(), m.span)).collect();
    let mission = choose(cx, &draft, "mission", &named, &blocks.missions).map(|index| &missions[index]);
    if let Some(mission) = mission.filter(|m| m.yaw_defaulted) {
        defaults.push(DefaultUsed {
            field: format!("mission.{}.yaw", mission.name),
            value: "0 deg".into(),
            reason: "the first waypoint says no yaw".into(),
        });
    }

    let fallback = mission.map(|m| m.span).or(vehicle.map(|v| v.span)).unwrap_or_default();
    let incomplete = modes.incomplete || vehicle.is_none();
    let flown = mission.and_then(|m| m.mission.as_ref());
    let (names_modes, empty_against) = (draft.names_modes(), draft.empty_against());
    let draft_span = draft.span;
    let (plan, plan_time, plan_defaults) = draft.finish(cx, &modes, incomplete, flown, fallback);
    let plan_written = !blocks.plans.is_empty();
    if plan_written || mission.is_some() {
        defaults.extend(plan_defaults);
    }
    if let Some(flown) = flown {
        sense::check_pace(cx, &flown.waypoints, plan_time);
    }
    let known = vehicle.and_then(|v| v.vehicle.as_ref());
    let lags_known = plan.as_ref().zip(known).is_none_or(|(plan, vehicle)| lag::check(cx, plan, vehicle));
    let around = Around {
        modes: &modes.modes,
        families: &modes.families,
        incomplete,
        vehicle: known,
        mission: flown,
        plan_time,
        fallback: draft_span.unwrap_or(fallback),
    };
    let flight_blocks = [&blocks.simulations, &blocks.campaigns].map(|blocks| blocks.first().copied());
    let (simulation, campaign) = flight_blocks::read(cx, flight_blocks, flights, &around, &mut defaults);
    let plan = plan.filter(|_| manner_fine && lags_known)?;
    let (simulation, campaign) = (simulation?, campaign?);
    if mission.is_some() && flown.is_none() {
        return None;
    }
    // A campaign strikes with every mode, and a block with mistakes with nobody knows which.
    if names_modes && !campaign.written && !cx.softened {
        let struck = simulation.faults.iter().map(|fault| fault.mode);
        let used: Vec<usize> = plan.against.iter().copied().chain(struck).collect();
        against::warn_unused(cx, &modes, &plan.against, &used, empty_against);
    }
    Some(Model {
        gravity: cx.gravity,
        vehicle: vehicle?.vehicle.clone()?,
        modes: modes.modes,
        mission: flown.cloned(),
        plan,
        simulation,
        campaign,
        defaults,
    })
}

fn top_field<'a>(cx: &mut Context<'a>, field: &'a Field, gravity: &mut Option<&'a Field>) {
    let name = &field.name;
    if name.value != "gravity" {
        let message = format!("`{}` is not a field of the top level", name.value);
        let error = Diagnostic::error("mavc::name::unknown_field", name.span, message).here("unknown here");
        let error = match (nearest(&name.value, Group::Top.names()), elsewhere(&name.value)) {
            (Some(near), _) => error.help(format!("did you mean `{near}`?")).fix(name.span, near),
            (None, Some(place)) => error.help(place),
            (None, None) => {
                let value = cx.sources.snippet(field.span);
                let value =
                    if value.len() <= 48 && !value.contains('\n') { value } else { &format!("{} = ...", name.value) };
                let before = Span { end: name.span.start, ..name.span };
                error.help(format!("to name a value, write `let {value}`")).fix(before, "let ")
            }
        };
        cx.report(error);
        cx.lose(&name.value);
    } else if let Some(first) = gravity {
        cx.report(duplicate("field", name, first.name.span));
    } else {
        *gravity = Some(field);
    }
}

fn settle_gravity<'a>(cx: &mut Context<'a>, field: Option<&'a Field>, defaults: &mut Vec<DefaultUsed>) {
    match field.map(|f| &f.value) {
        Some(FieldValue::Expr(expr)) => {
            let given = cx.positive(Due::new("gravity", "m/s^2"), expr, "mavc::vehicle::not_positive");
            if let Some(given) = given.filter(|g| *g != GRAVITY) {
                sense::gravity(cx, given, expr.span);
                cx.gravity = given;
                // What was evaluated on the way may have used the old value.
                cx.lets.values_mut().for_each(|l| {
                    if matches!(l.state, State::Done(Some(_))) {
                        l.state = State::Waiting;
                    }
                });
            }
        }
        Some(FieldValue::Where { field, .. }) => {
            cx.report(no_filter(field.span));
        }
        None => defaults.push(DefaultUsed {
            field: "gravity".into(),
            value: format!("{} m/s^2", number(GRAVITY)),
            reason: "standard gravity of the language".into(),
        }),
    }
}

/// Blocks of one kind have different names.
fn no_second(cx: &mut Context, what: &str, blocks: &[&Block]) {
    for (i, block) in blocks.iter().enumerate() {
        let Some(name) = &block.name else { continue };
        let first = blocks[..i].iter().filter_map(|b| b.name.as_ref()).find(|n| n.value == name.value);
        if let Some(first) = first {
            let first = first.span;
            cx.report(duplicate(what, name, first));
        }
    }
}

/// Of some blocks a spec has one. Of one whose keyword is misspelt that has been told, and the two may not be meant alike.
fn only_one(cx: &mut Context, blocks: &[&Block]) {
    let well_spelt = |block: &Block| cx.sources.snippet(block.keyword.span) == block.keyword.value;
    let spelt: Vec<&Block> = blocks.iter().copied().filter(|block| well_spelt(block)).collect();
    let [first, rest @ ..] = spelt.as_slice() else { return };
    for block in rest {
        let message = format!("a spec has one `{}` block", block.keyword.value);
        let error = Diagnostic::error("mavc::name::duplicate", block.keyword.span, message);
        cx.report(cx.joined(error.here("a second one").also(first.keyword.span, "the first"), first, block));
    }
}

/// The vehicle or mission that is meant: the one `plan` names, or the only one.
fn choose<'a>(
    cx: &mut Context<'a>,
    draft: &Draft<'a>,
    what: &str,
    named: &[(&str, Span)],
    blocks: &[&Block],
) -> Option<usize> {
    let nameless = blocks.iter().any(|block| block.name.is_none());
    let names: Vec<&str> = named.iter().map(|n| n.0).collect();
    if let Some(Spanned { value, span }) = draft.chosen(cx, what) {
        let index = names.iter().position(|n| *n == value);
        // One whose head could not be read may be meant.
        if index.is_none() && !nameless {
            cx.unknown(what, value, span, &names);
        }
        return index;
    }
    match named {
        [] => None,
        [_] => Some(0),
        // Two of one name are told of already, and `plan` could not tell them apart.
        [first, rest @ ..] if rest.iter().all(|other| other.0 == first.0) => Some(0),
        [..] => {
            // A block whose keyword is misspelt may have been meant as another: it is neither counted nor offered.
            let is_sure = |block: &Block| cx.sources.snippet(block.keyword.span) == what;
            let sure: Vec<usize> = (0..named.len()).filter(|&index| is_sure(blocks[index])).collect();
            let [first, second, ..] = sure[..] else {
                return Some(sure.first().copied().unwrap_or(0));
            };
            let (first, second) = (named[first], named[second]);
            let message = format!("the spec has {} {what}s, and none is chosen", sure.len());
            let help = format!("write `{what} = {}` in `plan`", first.0);
            let error = match draft.span {
                Some(plan) => Diagnostic::error("mavc::name::ambiguous", plan, message)
                    .here("which one?")
                    .also(first.1, "this one?"),
                None => Diagnostic::error("mavc::name::ambiguous", first.1, message).here("this one?"),
            };
            cx.report(error.also(second.1, "or this one?").help(help));
            None
        }
    }
}

fn start_of(item: &Item) -> Span {
    match item {
        Item::Use(path) => path.span,
        Item::Let(field) | Item::Field(field) => field.name.span,
        Item::Block(block) => block.keyword.span,
        Item::Broken(span) => *span,
    }
}

/// The expression of a field, where it has one.
pub(super) fn expr_of(field: &Field) -> Option<&Expr> {
    match &field.value {
        FieldValue::Expr(expr) => Some(expr),
        FieldValue::Where { .. } => None,
    }
}
