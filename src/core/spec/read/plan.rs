//! The `plan` block and its defaults.

pub(super) mod against;
pub(super) mod capture_height;
mod fit;
mod require;

use super::context::Context;
use super::fault::Modes;
use super::fields::Fields;
use super::mission::{MAX_DURATION, WaypointDefaults, too_long};
use super::{after_fault, edits, without_yaw};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::table::plan as table;
use crate::language::{Entry, Group};
use crate::model::grid::Spacing;
use crate::model::legs::Timing;
use crate::model::{
    AfterFault, DefaultUsed, GiveUpYaw, MAX_SAMPLES_OF_A_SEARCH, Mission, MissionTime, Plan, PlanModel, PlanRotors,
    PlannerKind,
};
use crate::read::written::Written;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Block, Expr, ExprKind, Field, FieldValue, Statement};

const CHOICE: &str = "mavc::plan::choice";
/// The numbers of a fault mode that `where` can compare.
pub(super) const MODE_NUMBERS: [&str; 5] = ["rpn", "severity", "occurrence", "detection", "rate"];

/// A `plan` block before the modes and the mission are known.
pub(super) struct Draft<'a> {
    fields: Option<Fields<'a>>,
    /// `against` is kept apart, because it may be a condition.
    against: Option<&'a Field>,
    /// The bound of `require risk`, `None` if it has an error, and its place.
    require: Option<(Option<f64>, Span)>,
    /// `require capture_height`.
    pub capture_height: Written<capture_height::Required>,
    /// Whether some statement of the block could not be parsed.
    broken: bool,
    /// Whether the planner chooses waypoint times.
    chooses_times: bool,
    pub span: Option<Span>,
    pub defaults: Vec<DefaultUsed>,
}

impl<'a> Draft<'a> {
    pub fn read(cx: &mut Context<'a>, block: Option<&'a Block>) -> Self {
        let mut draft = Draft {
            fields: None,
            against: None,
            require: None,
            capture_height: Written::Absent,
            broken: false,
            chooses_times: false,
            span: None,
            defaults: Vec::new(),
        };
        let Some(block) = block else { return draft };
        draft.span = Some(block.keyword.span);
        draft.broken = block.body.iter().any(|s| matches!(s, Statement::Broken(_)));
        let mut fields = Fields::of_block(cx, "`plan`".into(), block.keyword.span, &[], Group::Plan);
        draft.require = require::read(cx, &block.body);
        draft.capture_height = capture_height::read(cx, &block.body, &mut draft.defaults);
        for statement in &block.body {
            let Statement::Field(field) = statement else {
                continue;
            };
            if field.name.value != "against" {
                fields.take_field(cx, field, Group::Plan);
            } else if let Some(first) = draft.against {
                let error =
                    Diagnostic::error("mavc::name::duplicate", field.name.span, "`against` is given twice in `plan`");
                let again = edits::removal(cx.sources.get(field.span.file), field.span);
                let error = error.here("given again").also(first.name.span, "first given here");
                cx.report(error.help("remove one").fix(again, ""));
            } else {
                draft.against = Some(field);
            }
        }
        draft.fields = Some(fields);
        draft
    }

    fn get(&self, name: &str) -> Option<&'a Expr> {
        self.fields.as_ref().and_then(|f| f.get(name))
    }

    /// Returns `value` and records it as the default of a field that is not written.
    fn default<T>(&mut self, entry: &Entry, value: T) -> T {
        self.defaults.push(DefaultUsed::of("plan", entry));
        value
    }

    /// Whether `against` lists modes by name, so that a mode may have been left out by mistake.
    pub fn names_modes(&self) -> bool {
        self.against.is_some_and(|field| matches!(field.value, FieldValue::Expr(_)))
    }

    /// The place of `against` if it is the empty list.
    pub fn empty_against(&self) -> Option<Span> {
        self.against.and_then(against::empty_list)
    }

    /// The name given for `vehicle` or `mission`.
    pub fn chosen(&self, cx: &mut Context<'a>, what: &str) -> Option<Spanned<&'a str>> {
        let expr = self.get(what)?;
        match &expr.kind {
            ExprKind::Name(name) => Some(Spanned::new(name, expr.span)),
            _ => {
                let error = Diagnostic::error(CHOICE, expr.span, format!("`{what}` takes the name of a {what}"));
                cx.report(error.here("not a name"));
                None
            }
        }
    }

    /// The values that apply to waypoints without their own, and whether they have no errors; a default replaces a
    /// value with an error.
    pub fn manner(&mut self, cx: &mut Context<'a>) -> (WaypointDefaults, bool) {
        const TOLERANCE: &str = "mavc::mission::tolerance";
        let mut fine = true;
        let mut keep = |value: Option<f64>, instead: f64| {
            fine &= value.is_some();
            value.unwrap_or(instead)
        };
        let within = match self.get("within") {
            Some(e) => keep(cx.quantity(&table::WITHIN, e, TOLERANCE), table::WITHIN.value()),
            None => self.default(&table::WITHIN, table::WITHIN.value()),
        };
        let yaw_within = match self.get("yaw_within") {
            Some(e) => keep(cx.quantity(&table::YAW_WITHIN, e, TOLERANCE), table::YAW_WITHIN.value()),
            None => self.default(&table::YAW_WITHIN, table::YAW_WITHIN.value()),
        };
        let weight = match self.get("weight") {
            Some(e) => keep(cx.quantity(&table::WEIGHT, e, "mavc::mission::weight"), table::WEIGHT.value()),
            None => self.default(&table::WEIGHT, table::WEIGHT.value()),
        };
        let timing = match self.word(cx, &table::TIMING) {
            Written::Value("uniform") => Timing::Uniform,
            Written::Value("distance") => Timing::Distance,
            Written::Value("optimal") => Timing::Optimal,
            Written::Value(_) => Timing::Proportional,
            Written::Faulty => {
                fine = false;
                Timing::Proportional
            }
            Written::Absent => self.default(&table::TIMING, Timing::Optimal),
        };
        self.chooses_times = timing == Timing::Optimal;
        // The hover model keeps the paper's grid.
        let about_hover = matches!(self.get("model").map(|e| &e.kind), Some(ExprKind::Name(name)) if name == "hover");
        let spacing = if timing == Timing::Optimal && !about_hover { Spacing::Graded } else { Spacing::Even };
        (WaypointDefaults { within, yaw_within, weight, timing, spacing }, fine)
    }

    /// A field that takes one of a few words: [`Fields::word`].
    fn word(&self, cx: &mut Context<'a>, entry: &'static Entry) -> Written<&'a str> {
        self.fields.as_ref().map_or(Written::Absent, |fields| fields.word(cx, CHOICE, entry))
    }

    /// Checks the block against modes and mission: the plan, `None` where it has errors; its time with its place, if
    /// that is fixed; and the defaults used.
    pub fn finish(
        mut self,
        cx: &mut Context<'a>,
        modes: &Modes,
        modes_incomplete: bool,
        mission: Option<&Mission>,
        fallback: Span,
    ) -> (Option<Plan>, Option<(f64, Span)>, Vec<DefaultUsed>) {
        let span = self.span.unwrap_or(fallback);
        let planner = self.word(cx, &table::PLANNER).and_then(|w| match w {
            "rip" => Some(PlannerKind::Rip),
            "rcp" => Some(PlannerKind::Rcp),
            "rsp" => Some(PlannerKind::Rsp),
            _ => None,
        });
        let planner = planner.or_default(|| self.default(&table::PLANNER, PlannerKind::Rsp));
        let wrench = self.word(cx, &table::MODEL).and_then(|w| match w {
            "hover" => Some(PlanModel::Hover),
            "exact" => Some(PlanModel::Exact),
            _ => None,
        });
        let wrench = wrench.or_default(|| self.default(&table::MODEL, PlanModel::Exact));
        let rotors = self.word(cx, &table::ROTORS).and_then(|w| match w {
            "lagging" => Some(PlanRotors::Lagging),
            "instant" => Some(PlanRotors::Instant),
            _ => None,
        });
        let rotors = rotors.or_default(|| self.default(&table::ROTORS, PlanRotors::Instant));
        let against = match self.against {
            Some(field) => against::read(cx, field, modes, modes_incomplete),
            None => {
                let all = (0..modes.modes.len()).collect();
                Some(self.default(&table::AGAINST, all))
            }
        };
        let require = match self.require {
            Some((bound, place)) => {
                require::check(cx, bound, place, planner, against.as_deref(), &modes.modes).map(Some)
            }
            None => Some(None),
        };
        let time = self.time(cx);
        let samples = match self.get("samples") {
            Some(e) => cx.count(&table::SAMPLES, "`samples`", e, "mavc::plan::samples"),
            None => Some(self.default(&table::SAMPLES, table::SAMPLES.value() as usize)),
        };
        let rounds = match self.get("rounds") {
            Some(e) => cx.count(&table::ROUNDS, "`rounds`", e, "mavc::plan::rounds"),
            None => Some(self.default(&table::ROUNDS, table::ROUNDS.value() as usize)),
        };
        let after_fault = self.fields.as_ref().map_or(Written::Absent, |fields| after_fault::read(cx, fields));
        let after_fault = after_fault.or_default(|| self.default(&table::AFTER_FAULT, AfterFault::Continue));
        let without_yaw = self.fields.as_ref().map_or(Written::Absent, |fields| without_yaw::read(cx, fields));
        let without_yaw = without_yaw.or_default(|| self.default(&table::WITHOUT_YAW, GiveUpYaw::WhereNeeded));
        let reserve = match self.get("reserve") {
            Some(e) => self.reserve(cx, e),
            None => Some(self.default(&table::RESERVE, table::RESERVE.value())),
        };
        let mut weight = |entry: &'static Entry| match self.get(entry.name) {
            Some(e) => cx.quantity(entry, e, "mavc::plan::weight"),
            None => Some(self.default(entry, entry.value())),
        };
        let snap = weight(&table::SNAP);
        let acceleration = weight(&table::ACCELERATION);
        let place = |name: &str| self.fields.as_ref().and_then(|f| f.span_of(name)).unwrap_or(span);
        let (time_span, samples_span, reserve_span) = (place("time"), place("samples"), place("reserve"));
        if let Some(mission) = mission {
            if let Some(samples) = samples {
                fit::check_samples(cx, samples, self.get("samples"), samples_span, mission);
            }
            let ends_at = mission.waypoints.last().and_then(|w| w.time);
            self.chooses_times &= mission.leaves_times_free();
            let is_search = self.chooses_times || (time == Some(MissionTime::Minimum) && ends_at.is_none());
            if let (Some(samples), Some(given)) =
                (samples.filter(|&n| is_search && n > MAX_SAMPLES_OF_A_SEARCH), self.get("samples"))
            {
                fit::too_many_for_a_search(cx, samples, given.span);
            }
            if let Some(samples) = samples.filter(|_| self.chooses_times && time == Some(MissionTime::Minimum)) {
                fit::warn_of_dependence(cx, samples, self.get("samples"), samples_span, mission);
            }
            if let Some(MissionTime::Fixed(time)) = time {
                fit::check_time(cx, time, time_span, mission);
            }
        }
        let plan = match (
            planner,
            wrench.zip(rotors),
            against,
            time,
            samples,
            rounds,
            require,
            reserve,
            snap,
            acceleration,
            after_fault.zip(without_yaw),
        ) {
            (
                Some(planner),
                Some((model, rotors)),
                Some(against),
                Some(time),
                Some(samples),
                Some(rounds),
                Some(require_risk),
                Some(reserve),
                Some(snap_weight),
                Some(acceleration_weight),
                Some((after_fault, without_yaw)),
            ) if !self.broken && !self.capture_height.is_faulty() => Some(Plan {
                planner,
                model,
                rotors,
                chooses_times: self.chooses_times,
                against,
                time,
                samples,
                rounds,
                require_risk,
                require_capture: None,
                after_fault,
                without_yaw,
                require_span: self.require.map_or(span, |r| r.1),
                reserve,
                snap_weight,
                acceleration_weight,
                span,
                against_span: self.against.map_or(span, |f| f.span),
                time_span,
                samples_span,
                reserve_span,
                rotors_span: place("rotors"),
            }),
            _ => None,
        };
        let fixed = if let Some(MissionTime::Fixed(time)) = time { Some((time, time_span)) } else { None };
        (plan, fixed, self.defaults)
    }

    fn time(&mut self, cx: &mut Context<'a>) -> Option<MissionTime> {
        let Some(expr) = self.get("time") else {
            return Some(self.default(&table::TIME, MissionTime::Minimum));
        };
        if matches!(&expr.kind, ExprKind::Name(name) if name == "minimum") {
            return Some(MissionTime::Minimum);
        }
        if let ExprKind::Name(name) = &expr.kind
            && !cx.in_scope(name)
            && (["min", "shortest", "fastest"].contains(&name.as_str()) || nearest(name, ["minimum"]).is_some())
        {
            let error = Diagnostic::error(CHOICE, expr.span, "`time` must be `minimum` or a time such as `20 s`");
            cx.report(error.here("neither of these").help("did you mean `minimum`?").fix(expr.span, "minimum"));
            return None;
        }
        let time = cx.quantity(&table::TIME, expr, "mavc::plan::time")?;
        if time > MAX_DURATION {
            cx.report(too_long(expr.span, time));
            return None;
        }
        Some(MissionTime::Fixed(time))
    }

    fn reserve(&mut self, cx: &mut Context<'a>, expr: &'a Expr) -> Option<f64> {
        const CODE: &str = "mavc::plan::reserve";
        let reserve = cx.share("`reserve`", expr, CODE)?;
        if reserve < 1.0 {
            return Some(reserve);
        }
        let error = Diagnostic::error(CODE, expr.span, "`reserve` must be below 100 %");
        cx.report(
            error.here("leaves nothing to fly with").help("write `10 %`, the usual value").fix(expr.span, "10 %"),
        );
        None
    }
}
