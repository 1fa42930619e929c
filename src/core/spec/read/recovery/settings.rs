//! `recovery { }` in `plan`: which ways out are sought, and how soon they end.

use super::order::{self, Order};
use super::{BATTERY, VALUE};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::recovery as table;
use crate::model::{DefaultUsed, Mission, Recovery, RecoverySettings, Simulation, Vehicle};
use crate::number::number;
use crate::read::context::{Context, second_block};
use crate::read::defaulted::Defaulted;
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::mission::MAX_DURATION;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::Place;
use crate::syntax::ast::{Block, Expr, ExprKind, Statement};

/// The block before the mission, the vehicle and the flights are known.
#[derive(Default)]
pub struct Draft {
    order: Written<Order>,
    /// The shortest and the longest delay, s.
    detection: Written<[f64; 2]>,
    /// s
    within: Written<f64>,
    /// A share, with its place.
    keep: Written<(f64, Span)>,
    is_written: bool,
    is_broken: bool,
}

impl Draft {
    /// Reads the block of a plan, if there is one.
    pub fn read<'a>(cx: &mut Context<'a>, body: &'a [Statement], defaults: &mut Vec<DefaultUsed>) -> Self {
        let is_one = |block: &&Block| Place::of_block(&block.keyword.value) == Some(Place::Recovery);
        let blocks = body.iter().filter_map(|s| if let Statement::Block(block) = s { Some(block) } else { None });
        let mut blocks = blocks.filter(is_one);
        let Some(first) = blocks.next() else { return Draft::default() };
        for second in blocks {
            cx.report(second_block("a plan may have only one `recovery` block".into(), second, first));
        }
        let fields = Fields::of_block(cx, "`recovery`".into(), first.keyword.span, &first.body, Group::Recovery);
        let mut fields = Defaulted::new("plan.recovery", fields);
        let order = fields.written("order", |expr| order::read(cx, "order", expr));
        let detection = fields.written("detection", |expr| detection(cx, expr));
        let within = fields.written("within", |expr| {
            let within = cx.quantity(&table::WITHIN, expr, VALUE)?;
            is_short(cx, "within", within, expr.span).then_some(within)
        });
        let keep = fields.written("keep", |expr| keep(cx, expr).map(|share| (share, expr.span)));
        for (entry, is_absent) in
            [(&table::ORDER, order.is_absent()), (&table::WITHIN, within.is_absent()), (&table::KEEP, keep.is_absent())]
        {
            if is_absent {
                fields.default(entry, ());
            }
        }
        defaults.append(&mut fields.used);
        Draft { order, detection, within, keep, is_written: true, is_broken: !first.is_whole() }
    }

    /// The settings, without `require`; `None` where something has an error. `mission` is `None` for a spec without
    /// one.
    pub fn settings(
        self,
        cx: &mut Context,
        mission: Option<&Mission>,
        vehicle: &Vehicle,
        simulation: &Simulation,
        defaults: &mut Vec<DefaultUsed>,
    ) -> Option<RecoverySettings> {
        let unsaid = RecoverySettings::unsaid(simulation);
        if self.is_written && self.detection.is_absent() {
            defaults.push(DefaultUsed {
                field: "plan.recovery.detection".into(),
                value: format!("{} s", number(unsaid.detection[0])),
                reason: "the delay of `simulate`, or 200 ms".into(),
            });
        }
        let order: Option<Vec<Recovery>> = match self.order {
            Written::Absent => Some(unsaid.order),
            Written::Faulty => None,
            Written::Value(order) => order.resolve(cx, mission),
        };
        if let (Written::Value((_, span)), None) = (self.keep, &vehicle.battery) {
            let error = Diagnostic::error(BATTERY, span, "`keep` needs the battery of the vehicle");
            let error = error.here("a share of its charge").also(vehicle.span, "no `battery`");
            let example = "battery { capacity = 10 A*h; voltage = 22.2 V; hover_power = 600 W }";
            cx.report(error.help(format!("remove `keep`, or add `{example}` with the values of your vehicle")));
            return None;
        }
        let keep = self.keep.or_default(|| (unsaid.keep, Span::default()));
        (!self.is_broken).then_some(RecoverySettings {
            order: order?,
            detection: self.detection.or_default(|| unsaid.detection)?,
            within: self.within.or_default(|| unsaid.within)?,
            keep: keep?.0,
            require: None,
        })
    }
}

/// `200 ms`, or the shortest and the longest delay, `100 ms .. 200 ms`, s.
fn detection<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<[f64; 2]> {
    if let Expr { kind: ExprKind::Name(word), span } = expr
        && (word == "never" || word == "estimator")
    {
        let error = Diagnostic::error(VALUE, *span, format!("`{word}` is not a delay after which a fault is known"));
        cx.report(error.here("a delay is needed").help("write the shortest and the longest: `100 ms .. 200 ms`"));
        return None;
    }
    let written = cx.let_behind(expr).map_or(expr, |(_, value)| value);
    if !matches!(written.kind, ExprKind::Range { .. }) {
        let delay = cx.quantity(&table::DETECTION, expr, VALUE)?;
        return is_short(cx, "detection", delay, expr.span).then_some([delay; 2]);
    }
    let (low, high) = cx.range_of(Expected::of(&table::DETECTION), expr)?;
    if low < 0.0 || low > high {
        let (message, help) = match low < 0.0 {
            true => ("a fault cannot be known before it happens", "write a range that begins at 0 s or later"),
            false => ("the longest delay is below the shortest", "swap the two ends"),
        };
        let error = Diagnostic::error(VALUE, expr.span, message);
        cx.report(error.here(format!("from {} s to {} s", number(low), number(high))).help(help));
        return None;
    }
    is_short(cx, "detection", high, expr.span).then_some([low, high])
}

/// Whether a time is at most the longest mission; reports that it is not.
fn is_short(cx: &mut Context, field: &str, time: f64, span: Span) -> bool {
    if time <= MAX_DURATION {
        return true;
    }
    let error = Diagnostic::error(VALUE, span, format!("`{field}` may be at most 100,000 s, over a day"));
    cx.report(error.here(format!("this is {} s", number(time))).help("write a shorter time, or correct the unit"));
    false
}

/// The share of the charge that is left.
fn keep<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<f64> {
    let keep = cx.share("`keep`", expr, VALUE)?;
    if keep < 1.0 {
        return Some(keep);
    }
    let error = Diagnostic::error(VALUE, expr.span, "`keep` must be below 100 %");
    cx.report(error.here("leaves nothing to fly with").help("write the share that is left, such as `15 %`"));
    None
}
