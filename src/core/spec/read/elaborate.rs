//! From the syntax tree to the model: collect blocks, evaluate values, choose vehicle and mission, check.

use super::blocks::{Blocks, broken, use_broken};
use super::context::{Context, State, no_filter};
use super::expected::Expected;
use super::fault::Modes;
use super::flight_blocks::{self, FlightBlocks};
use super::load::FileSet;
use super::overrides::{Override, apply};
use super::plan::{Draft, against, capture_height};
use super::simulate::Around;
use super::understanding::Understanding;
use super::volume;
use super::{air, lag, mission, plausibility, recovery, vehicle};
use crate::diagnostic::{Checked, Diagnostic, Severity, sort};
use crate::language::table;
use crate::model::{DefaultUsed, FaultMode, Mission, Model, PlanSettings, RecoverySettings, Vehicle};
use crate::number::number;
use crate::source::{FileId, Span, Spanned};
use crate::syntax::ast::{Block, Expr, Field, FieldValue, Item, SpecFile};
use crate::unit::GRAVITY;

/// Elaborates a file set into a model. Overrides replace or add fields first, so they are checked like the fields they
/// replace. The model is `None` where there are errors; diagnostics from loading are not repeated.
///
/// # Steps
/// 1. Collect the blocks of all files.
/// 2. Evaluate gravity and every `let`.
/// 3. Elaborate every vehicle, choose one, and elaborate its faults and the missions.
/// 4. Check the plan against modes and mission, then read the blocks that fly it.
pub fn elaborate(files: &FileSet, overrides: &[Override]) -> Checked<Model> {
    elaborate_for(files, overrides, FlightBlocks::Used)
}

/// The model for a command that may not use the flight blocks, with the diagnostics that [`elaborate`] reports: their
/// errors are warnings if `flights` says that they are not used.
pub fn elaborate_for(files: &FileSet, overrides: &[Override], flights: FlightBlocks) -> Checked<Model> {
    understand_for(files, overrides, flights).checked
}

/// Everything that was understood of a spec, whether it has errors or not: the model of [`elaborate`], and the meaning
/// of names and expressions.
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
    // What could not be parsed might change the model, or use a `let`.
    let mut parts = Parts::default();
    let value = whole(&mut cx, &trees, files, flights, &mut parts).filter(|_| whole_text);
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    // What a block with errors would have used is unknown.
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
    Understanding { checked, gravity: cx.gravity, vehicles, modes, readings: cx.readings, from_tables: cx.from_tables }
}

/// The parts of a spec that have no errors of their own.
#[derive(Default)]
struct Parts {
    vehicles: Vec<Vehicle>,
    modes: Vec<FaultMode>,
}

fn whole<'a>(
    cx: &mut Context<'a>,
    trees: &'a [SpecFile],
    files: &'a FileSet,
    flights: FlightBlocks,
    parts: &mut Parts,
) -> Option<Model> {
    let items = || trees.iter().flat_map(|tree| &tree.items);
    let blocks = Blocks::collect(cx, trees, flights);
    let mut defaults = Vec::new();
    cx.declare(items().filter_map(|item| if let Item::Let(field) = item { Some(field) } else { None }));
    settle_gravity(cx, blocks.gravity, &mut defaults);
    cx.settle();

    let vehicles: Vec<_> = blocks.vehicles.iter().map(|block| vehicle::elaborate(cx, block, files)).collect();
    let mut draft = Draft::read(cx, blocks.plans.first().copied());
    let named: Vec<(&str, Span)> = vehicles.iter().map(|v| (v.name.as_str(), v.span)).collect();
    let vehicle = choose(cx, &draft, "vehicle", &named, &blocks.vehicles).map(|index| &vehicles[index]);
    defaults.extend(vehicle.iter().flat_map(|v| v.defaults.iter().cloned()));
    if vehicles.is_empty() {
        report_no_vehicle(cx, trees);
    }

    let mut modes = Modes::default();
    for block in &blocks.faults {
        modes.take(cx, block, vehicle.and_then(|v| v.rotors));
    }
    modes.finish(cx);
    parts.vehicles = vehicles.iter().filter_map(|v| v.vehicle.clone()).collect();
    parts.modes = modes.modes.clone();
    let (of_waypoints, of_waypoints_fine) = draft.waypoint_defaults(cx);
    let read = |block: &&'a Block| mission::elaborate(cx, block, of_waypoints, files);
    let missions: Vec<_> = blocks.missions.iter().map(read).collect();
    let named: Vec<(&str, Span)> = missions.iter().map(|m| (m.name.as_str(), m.span)).collect();
    let mission = choose(cx, &draft, "mission", &named, &blocks.missions).map(|index| &missions[index]);
    defaults.extend(mission.filter(|m| m.yaw_defaulted).map(|mission| default_yaw(&mission.name)));

    let fallback = mission.map(|m| m.span).or(vehicle.map(|v| v.span)).unwrap_or_default();
    let incomplete = modes.incomplete || vehicle.is_none();
    let mut known = vehicle.and_then(|v| v.vehicle.clone());
    if let Some((vehicle, mission)) = known.as_mut().zip(mission.and_then(|m| m.mission.as_ref())) {
        air::impose(vehicle, &mission.air);
    }
    let known = known.as_ref();
    let mut flown = mission.and_then(|m| m.mission.clone());
    if let Some((flown, vehicle)) = flown.as_mut().zip(known) {
        super::heading::impose(flown, vehicle);
    }
    let volumes_fit = flown.as_mut().zip(known).is_none_or(|(flown, vehicle)| volume::impose(cx, flown, vehicle));
    let flown = flown.as_ref();
    let mut plan = draft.finish(cx, &modes, incomplete, flown, fallback);
    if draft.span.is_some() || mission.is_some() {
        defaults.append(&mut draft.fields.used);
    }
    if let Some(flown) = flown {
        plausibility::check_pace(cx, &flown.waypoints, draft.fixed_time);
    }
    let plan_fits = plan_fits(cx, plan.as_ref(), known, flown);
    let around = Around {
        modes: &modes.modes,
        families: &modes.families,
        incomplete,
        vehicle: known,
        mission: flown,
        plan_time: draft.fixed_time,
        fallback: draft.span.unwrap_or(fallback),
    };
    let flight_blocks = [&blocks.simulations, &blocks.campaigns].map(|blocks| blocks.first().copied());
    let (simulation, campaign) = flight_blocks::read(cx, flight_blocks, flights, &around, &mut defaults);
    let mut captures_known = true;
    if let Some((plan, written)) = plan.as_mut().zip(draft.capture_height.value()) {
        let required = capture_height::check(cx, written, flown, known, simulation.as_ref());
        captures_known = required.is_some();
        plan.require_capture = required;
    }
    let places_fit = flown.zip(known).is_none_or(|(mission, vehicle)| {
        // Where the waypoints do not fit, the volumes are reported already.
        !volumes_fit || recovery::check_places(cx, mission, vehicle)
    });
    // The landing sites of a mission with errors are unknown.
    let mut ways_known = true;
    if mission.is_none() || flown.is_some() {
        ways_known = recovery::of_modes(cx, &mut modes, flown);
        if let Some(((plan, vehicle), simulation)) = plan.as_mut().zip(known).zip(simulation.as_ref()) {
            let settings = std::mem::take(&mut draft.recovery).settings(cx, flown, vehicle, simulation, &mut defaults);
            ways_known &= settings.is_some();
            let unsaid = || RecoverySettings::unsaid(simulation);
            plan.recovery = RecoverySettings { require: plan.recovery.require, ..settings.unwrap_or_else(unsaid) };
        }
    }
    let is_fine = places_fit && ways_known && captures_known && of_waypoints_fine && volumes_fit && plan_fits;
    let plan = plan.filter(|_| is_fine)?;
    let (simulation, campaign) = (simulation?, campaign?);
    if mission.is_some() && flown.is_none() {
        return None;
    }
    // A campaign uses every mode, `require capture_height` those that give up yaw, and which modes a block with errors
    // uses is unknown.
    if draft.names_modes() && !campaign.written && plan.require_capture.is_none() && !cx.softened {
        let struck = simulation.faults.iter().map(|fault| fault.mode);
        let used: Vec<usize> = plan.against.iter().copied().chain(struck).collect();
        against::warn_unused(cx, &modes, &plan.against, &used, draft.empty_against());
    }
    Some(Model {
        gravity: cx.gravity,
        vehicle: known?.clone(),
        modes: modes.modes,
        mission: flown.cloned(),
        plan,
        simulation,
        campaign,
        defaults,
    })
}

/// Reports that no vehicle is declared, unless it may be in what could not be read.
fn report_no_vehicle(cx: &mut Context, trees: &[SpecFile]) {
    let items = || trees.iter().flat_map(|tree| &tree.items);
    if items().any(|item| matches!(item, Item::Broken(_))) || cx.may_exist("vehicle") {
        return;
    }
    let span = items().next().map_or(Span::default(), start_of);
    let message = match items().next() {
        Some(_) => "the spec declares no vehicle".to_string(),
        None => format!("`{}` is empty: no vehicle is declared", cx.sources.get(span.file).name),
    };
    let error = Diagnostic::error("mavc::name::no_vehicle", span, message);
    cx.report(error.help("add a `vehicle` block, or include one with `use \"vehicles/...\"`"));
}

fn default_yaw(mission: &str) -> DefaultUsed {
    DefaultUsed {
        field: format!("mission.{mission}.yaw"),
        value: "0 deg".into(),
        reason: "the first waypoint gives no yaw".into(),
    }
}

/// Whether vehicle and mission suit the plan: its model, and its lag and air.
fn plan_fits(
    cx: &mut Context,
    plan: Option<&PlanSettings>,
    vehicle: Option<&Vehicle>,
    mission: Option<&Mission>,
) -> bool {
    let Some(plan) = plan else { return true };
    let lag_fits = vehicle.is_none_or(|vehicle| lag::check(cx, plan, vehicle) && lag::none_reverses(cx, plan, vehicle));
    let model_fits = mission.is_none_or(|mission| {
        let volumes = volume::only_in_the_exact_model(cx, plan, mission);
        super::heading::only_in_the_exact_model(cx, plan, mission) && volumes
    });
    let air_fits = vehicle.is_none_or(|vehicle| air::check(cx, plan, mission, vehicle));
    lag_fits && model_fits && air_fits
}

fn settle_gravity<'a>(cx: &mut Context<'a>, field: Option<&'a Field>, defaults: &mut Vec<DefaultUsed>) {
    match field.map(|f| &f.value) {
        Some(FieldValue::Expr(expr)) => {
            let given = cx.positive(Expected::of(&table::top::GRAVITY), expr, "mavc::vehicle::not_positive");
            if let Some(given) = given.filter(|g| *g != GRAVITY) {
                plausibility::gravity(cx, given, expr.span);
                cx.gravity = given;
                // Values evaluated meanwhile may have used the default gravity.
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
            reason: "the language's default gravity".into(),
        }),
    }
}

/// The index of the vehicle or mission to use: the one that `plan` names, the only one, or the only mission of the spec
/// itself, which goes before those of files that it uses for their vehicles.
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
        // A block whose head could not be parsed may have this name.
        if index.is_none() && !nameless {
            cx.unknown(what, value, span, &names);
        }
        return index;
    }
    match named {
        [] => None,
        [_] => Some(0),
        // Two of the same name are reported already, and `plan` could not distinguish them.
        [first, rest @ ..] if rest.iter().all(|other| other.0 == first.0) => Some(0),
        [..] => {
            // A block with a misspelt keyword may be of another kind: it is neither counted nor suggested.
            let is_sure = |block: &Block| cx.sources.snippet(block.keyword.span) == what;
            let sure: Vec<usize> = (0..named.len()).filter(|&index| is_sure(blocks[index])).collect();
            let [first, second, ..] = sure[..] else {
                return Some(sure.first().copied().unwrap_or(0));
            };
            let mut own = sure.iter().filter(|&&index| named[index].1.file == FileId(0));
            if let ("mission", Some(only), None) = (what, own.next(), own.next()) {
                return Some(*only);
            }
            let (first, second) = (named[first], named[second]);
            let message = format!("the spec has {} {what}s, but `plan` chooses none", sure.len());
            let help = format!("write `{what} = {}` in `plan`", first.0);
            let error = match draft.span {
                Some(plan) => Diagnostic::error("mavc::name::ambiguous", plan, message)
                    .here(format!("no `{what}` field"))
                    .also(first.1, "first candidate"),
                None => Diagnostic::error("mavc::name::ambiguous", first.1, message).here("first candidate"),
            };
            cx.report(error.also(second.1, "second candidate").help(help));
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
