//! The `plan` block and its defaults.

pub(super) mod against;
pub(super) mod capture_height;
mod fit;
mod require;

use super::context::Context;
use super::defaulted::Defaulted;
use super::fault::Modes;
use super::fields::Fields;
use super::mission::{MAX_DURATION, WaypointDefaults, too_long};
use super::{after_fault, edits, recovery, without_yaw};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::Group;
use crate::language::table::plan as table;
use crate::model::grid::Spacing;
use crate::model::legs::Timing;
use crate::model::{
    AfterFault, GiveUpYaw, Mission, MissionTime, PlanModel, PlanRotors, PlanSettings, PlannerKind, Recoverable,
    RecoverySettings, SearchEffort,
};
use crate::read::written::Written;
use crate::source::{Span, Spanned};
use crate::syntax::ast::{Block, Expr, ExprKind, Field, FieldValue, Statement};
use require::Bounded;

const CHOICE: &str = "mavc::plan::choice";
/// The numbers of a fault mode that `where` can compare.
pub(super) const MODE_NUMBERS: [&str; 5] = ["rpn", "severity", "occurrence", "detection", "rate"];

/// A `plan` block before the modes and the mission are known.
pub(super) struct Draft<'a> {
    pub fields: Defaulted<'a>,
    /// `against` is kept apart, because it may be a condition.
    against: Option<&'a Field>,
    require: Option<require::Requirement>,
    /// `require capture_height`.
    pub capture_height: Written<capture_height::Required>,
    /// The `recovery` block.
    pub recovery: recovery::Draft,
    /// Whether every statement of the block could be parsed.
    is_whole: bool,
    /// Whether the planner chooses waypoint times.
    chooses_times: bool,
    /// The place of the block, where it is written.
    pub span: Option<Span>,
    /// The time of the plan where it is fixed, s, and its place, once the plan is read.
    pub fixed_time: Option<(f64, Span)>,
}

impl<'a> Draft<'a> {
    pub fn read(cx: &mut Context<'a>, block: Option<&'a Block>) -> Self {
        let span = block.map(|block| block.keyword.span);
        let body = block.map_or(&[][..], |block| &block.body);
        let mut fields = Fields::of_block(cx, "`plan`".into(), span.unwrap_or_default(), &[], Group::Plan);
        let mut against: Option<&Field> = None;
        for statement in body {
            let Statement::Field(field) = statement else {
                continue;
            };
            if field.name.value != "against" {
                fields.take_field(cx, field, Group::Plan);
            } else if let Some(first) = against {
                let error =
                    Diagnostic::error("mavc::name::duplicate", field.name.span, "`against` is given twice in `plan`");
                let again = edits::removal(cx.sources.get(field.span.file), field.span);
                let error = error.here("given again").also(first.name.span, "first given here");
                cx.report(error.help("remove one").fix(again, ""));
            } else {
                against = Some(field);
            }
        }
        let mut fields = Defaulted::new("plan", fields);
        Draft {
            against,
            require: require::read(cx, body),
            capture_height: capture_height::read(cx, body, &mut fields.used),
            recovery: recovery::Draft::read(cx, body, &mut fields.used),
            is_whole: block.is_none_or(Block::is_whole),
            chooses_times: false,
            span,
            fixed_time: None,
            fields,
        }
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
        let expr = self.fields.get(what)?;
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
    pub fn waypoint_defaults(&mut self, cx: &mut Context<'a>) -> (WaypointDefaults, bool) {
        const TOLERANCE: &str = "mavc::mission::tolerance";
        const TIMINGS: [Timing; 4] = [Timing::Optimal, Timing::Proportional, Timing::Uniform, Timing::Distance];
        let within = self.fields.quantity_or_default(cx, &table::WITHIN, TOLERANCE);
        let yaw_within = self.fields.quantity_or_default(cx, &table::YAW_WITHIN, TOLERANCE);
        let weight = self.fields.quantity_or_default(cx, &table::WEIGHT, "mavc::mission::weight");
        let timing = self.fields.choice_or(cx, &table::TIMING, CHOICE, &TIMINGS, Timing::Optimal);
        let is_fine = within.is_some() && yaw_within.is_some() && weight.is_some() && timing.is_some();
        let timing = timing.unwrap_or(Timing::Proportional);
        self.chooses_times = timing == Timing::Optimal;
        // The hover model keeps the paper's grid.
        let model = self.fields.get("model").map(|e| &e.kind);
        let about_hover = matches!(model, Some(ExprKind::Name(name)) if name == PlanModel::Hover.name());
        let defaults = WaypointDefaults {
            within: within.unwrap_or(table::WITHIN.value()),
            yaw_within: yaw_within.unwrap_or(table::YAW_WITHIN.value()),
            weight: weight.unwrap_or(table::WEIGHT.value()),
            timing,
            spacing: if timing == Timing::Optimal && !about_hover { Spacing::Graded } else { Spacing::Even },
        };
        (defaults, is_fine)
    }

    /// Reads the other fields and checks them against modes and mission; `None` where the block has errors.
    pub fn finish(
        &mut self,
        cx: &mut Context<'a>,
        modes: &Modes,
        modes_incomplete: bool,
        mission: Option<&Mission>,
        fallback: Span,
    ) -> Option<PlanSettings> {
        const PLANNERS: [PlannerKind; 3] = [PlannerKind::Rip, PlannerKind::Rcp, PlannerKind::Rsp];
        const MODELS: [PlanModel; 2] = [PlanModel::Hover, PlanModel::Exact];
        const ROTORS: [PlanRotors; 2] = [PlanRotors::Instant, PlanRotors::Lagging];
        const EFFORTS: [SearchEffort; 3] = [SearchEffort::Quick, SearchEffort::Normal, SearchEffort::Thorough];
        const WEIGHT: &str = "mavc::plan::weight";
        let span = self.span.unwrap_or(fallback);
        let planner = self.fields.choice_or(cx, &table::PLANNER, CHOICE, &PLANNERS, PlannerKind::Rsp);
        let model = self.fields.choice_or(cx, &table::MODEL, CHOICE, &MODELS, PlanModel::Exact);
        let rotors = self.fields.choice_or(cx, &table::ROTORS, CHOICE, &ROTORS, PlanRotors::Instant);
        let effort = self.fields.choice_or(cx, &table::EFFORT, CHOICE, &EFFORTS, SearchEffort::Normal);
        let against = match self.against {
            Some(field) => against::read(cx, field, modes, modes_incomplete),
            None => Some(self.fields.default(&table::AGAINST, (0..modes.modes.len()).collect())),
        };
        let (mut require_risk, mut require_uncovered) = (Written::Absent, Written::Absent);
        let mut require_span = span;
        match &self.require {
            Some(share) if share.bounded == Bounded::Uncovered => {
                let bound = share.at_most.map(|uncovered| Recoverable { uncovered, span: share.span });
                require_uncovered = Written::of(bound);
            }
            Some(unknown) if unknown.bounded == Bounded::Unknown => require_risk = Written::Faulty,
            Some(risk) => {
                require_risk = Written::of(risk.check_risk(cx, planner, against.as_deref(), &modes.modes));
                require_span = risk.span;
            }
            None => {}
        }
        let time = self.time(cx);
        let usual = mission.map_or(table::SAMPLES.value() as usize, fit::usual_samples);
        let samples = self.fields.count(cx, &table::SAMPLES, "mavc::plan::samples");
        let samples = samples.or_default(|| self.fields.default(&table::SAMPLES, usual));
        let rounds = self.fields.count_or_default(cx, &table::ROUNDS, "mavc::plan::rounds");
        let after_fault = after_fault::read(cx, &self.fields);
        let after_fault = after_fault.or_default(|| self.fields.default(&table::AFTER_FAULT, AfterFault::Continue));
        let without_yaw = without_yaw::read(cx, &self.fields);
        let without_yaw = without_yaw.or_default(|| self.fields.default(&table::WITHOUT_YAW, GiveUpYaw::WhereNeeded));
        let reserve = self.fields.value_or(&table::RESERVE, table::RESERVE.value(), |expr| reserve(cx, expr));
        let snap_weight = self.fields.quantity_or_default(cx, &table::SNAP, WEIGHT);
        let acceleration_weight = self.fields.quantity_or_default(cx, &table::ACCELERATION, WEIGHT);
        let [time_span, samples_span, reserve_span, rotors_span] =
            ["time", "samples", "reserve", "rotors"].map(|name| self.fields.span_of(name).unwrap_or(span));
        if let Some(MissionTime::Fixed(time)) = time {
            self.fixed_time = Some((time, time_span));
        }
        if let Some(mission) = mission {
            self.chooses_times &= mission.leaves_times_free();
            let to_minimum = time == Some(MissionTime::Minimum);
            if let Some(number) = samples {
                let samples = fit::Samples { number, given: self.fields.get("samples"), span: samples_span };
                samples.check(cx, mission);
                let is_end_free = mission.waypoints.last().is_none_or(|waypoint| waypoint.time.is_none());
                if self.chooses_times || (to_minimum && is_end_free) {
                    samples.check_search(cx);
                }
                if self.chooses_times && to_minimum {
                    samples.warn_of_dependence(cx, mission);
                }
            }
            if let Some((time, span)) = self.fixed_time {
                fit::check_time(cx, time, span, mission);
            }
        }
        if !self.is_whole || self.capture_height.is_faulty() {
            return None;
        }
        Some(PlanSettings {
            planner: planner?,
            model: model?,
            rotors: rotors?,
            chooses_times: self.chooses_times,
            against: against?,
            time: time?,
            effort: effort?,
            samples: samples?,
            rounds: rounds?,
            require_risk: require_risk.optional().ok()?,
            require_capture: None,
            recovery: RecoverySettings { require: require_uncovered.optional().ok()?, ..RecoverySettings::default() },
            after_fault: after_fault?,
            without_yaw: without_yaw?,
            require_span,
            reserve: reserve?,
            snap_weight: snap_weight?,
            acceleration_weight: acceleration_weight?,
            span,
            against_span: self.against.map_or(span, |f| f.span),
            time_span,
            samples_span,
            reserve_span,
            rotors_span,
        })
    }

    fn time(&mut self, cx: &mut Context<'a>) -> Option<MissionTime> {
        let Some(expr) = self.fields.get("time") else {
            return Some(self.fields.default(&table::TIME, MissionTime::Minimum));
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
}

/// The share of each set that is kept for feedback.
fn reserve<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<f64> {
    const CODE: &str = "mavc::plan::reserve";
    let reserve = cx.share("`reserve`", expr, CODE)?;
    if reserve < 1.0 {
        return Some(reserve);
    }
    let error = Diagnostic::error(CODE, expr.span, "`reserve` must be below 100 %");
    cx.report(error.here("leaves nothing to fly with").help("write `10 %`, the usual value").fix(expr.span, "10 %"));
    None
}
