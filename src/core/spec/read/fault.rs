//! `faults` blocks: single modes and all combinations of k rotors.

pub(super) mod family;

use std::collections::BTreeMap;

use super::context::{Context, duplicate};
use super::expected::Expected;
use super::expression::Value;
use super::fields::Fields;
use super::{after_fault, plausibility, recovery, without_yaw};
use crate::diagnostic::Diagnostic;
use crate::language::table::mode as table;
use crate::language::{Entry, Group};
use crate::model::{AfterFault, FaultMode, GiveUpYaw, RotorState, Spread};
use crate::number::number;
use crate::source::{Span, Spanned, visible};
use crate::syntax::ast::{Block, Effect, Expr, ExprKind, Name, Statement};
use crate::unit::parse_unit;
use family::Families;

/// The most fault modes that one spec may have.
pub const MAX_MODES: usize = 10_000;

pub(super) const RESERVED: [&str; 2] = ["all", "healthy"];

/// The fault modes read so far, and what is known about their names.
#[derive(Default)]
pub(super) struct Modes {
    pub modes: Vec<FaultMode>,
    /// The statement each came from, by its index.
    pub origin: Vec<usize>,
    pub statements: usize,
    pub families: Families,
    /// The orders of ways out that modes have of their own, each with its statement, by its index.
    pub orders: Vec<(usize, recovery::Order)>,
    names: BTreeMap<String, Span>,
    /// Some statement gave no modes because of an error: names may be missing.
    pub incomplete: bool,
}

impl Modes {
    /// Reads one `faults` block. `rotors` is the vehicle's number of rotors, if it is known.
    pub fn take<'a>(&mut self, cx: &mut Context<'a>, block: &'a Block, rotors: Option<usize>) {
        let owner = "`faults`".to_string();
        Fields::of_block(cx, owner, block.keyword.span, &block.body, Group::Nothing);
        for statement in &block.body {
            match statement {
                Statement::Block(mode) => self.single(cx, mode, rotors),
                Statement::Every { .. } => self.every(cx, statement, rotors),
                Statement::Broken(span) => {
                    self.incomplete = true;
                    // The name of a broken `mode` is among the lost words; the names that an `every` makes are not.
                    let text = cx.sources.snippet(*span);
                    cx.modes_unnamed |= text.is_empty() || text.contains("every");
                }
                _ => continue,
            }
            self.statements += 1;
        }
    }

    fn single<'a>(&mut self, cx: &mut Context<'a>, block: &'a Block, rotors: Option<usize>) {
        let Some(name) = &block.name else {
            // The head could not be parsed, but the body may have errors of its own.
            (self.incomplete, cx.modes_unnamed) = (true, true);
            let owner = format!("this `{}`", block.keyword.value);
            if block.keyword.value == "mode" {
                Effects::read(cx, block, &owner, rotors);
            }
            Numbers::read(cx, owner, block.keyword.span, &block.body);
            return;
        };
        let owner = format!("mode `{}`", name.value);
        let effects = Effects::read(cx, block, &owner, rotors);
        let numbers = Numbers::read(cx, owner, name.span, &block.body);
        self.note_order(numbers.as_ref());
        let known = self.admit(cx, name, &name.value);
        let (Some(effects), Some(numbers), Some(rotors), true) = (effects, numbers, rotors, known) else {
            cx.lose(&name.value);
            self.incomplete = true;
            return;
        };
        let mut mode = numbers.mode(name.value.clone(), rotors, name.span);
        mode.title = block.title.as_ref().map(|t| visible::line(&t.value).into_owned());
        mode.doc = block.doc.clone();
        effects.iter().for_each(|(k, effect)| mode.rotors[k - 1] = *effect);
        self.push(mode);
    }

    fn every<'a>(&mut self, cx: &mut Context<'a>, statement: &'a Statement, rotors: Option<usize>) {
        let Statement::Every { count, effect, prefix, body, doc, span } = statement else { return };
        if let ExprKind::Number { unit: Some(word), .. } = &count.kind
            && parse_unit(&word.value, cx.gravity).is_err()
        {
            let message = format!("`every` cannot select rotors by `{}`", word.value);
            let error = Diagnostic::error("mavc::syntax::unexpected", word.span, message).here("expected `rotors`");
            cx.report(error.help("`every 2 rotors` covers every pair; to cover only some, write a mode for each"));
            (self.incomplete, cx.modes_unnamed) = (true, true);
            return;
        }
        let effect = left_by(cx, effect);
        let numbers = Numbers::read(cx, format!("`every ... as {}`", prefix.value), *span, body);
        self.note_order(numbers.as_ref());
        let most = rotors.unwrap_or(*super::vehicle::ROTORS.end());
        let count = cx.whole("the number of rotors", count, 1..=most, "mavc::fault::count").map(|k| (k, count.span));
        let (Some((k, at)), Some(n)) = (count, rotors) else {
            (self.incomplete, cx.modes_unnamed) = (true, true);
            return;
        };
        if RESERVED.contains(&prefix.value.as_str()) {
            cx.report(family::reserved(prefix));
            (self.incomplete, cx.modes_unnamed) = (true, true);
            return;
        }
        let total = (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64).round();
        if total + self.modes.len() as f64 > MAX_MODES as f64 {
            let message = format!(
                "{k} of {n} rotors make {} combinations; a spec may have at most {MAX_MODES} fault modes",
                number(total)
            );
            let error = Diagnostic::error("mavc::fault::too_many", at, message);
            let help = "choose fewer rotors, or declare only the modes that matter";
            cx.report(error.here("too many combinations").help(help));
            (self.incomplete, cx.modes_unnamed) = (true, true);
            return;
        }
        let first = self.modes.len();
        for rotors in combinations(n, k) {
            let numbers_text: Vec<String> = rotors.iter().map(usize::to_string).collect();
            let name = format!("{}{}", prefix.value, numbers_text.join("_"));
            if !self.admit(cx, prefix, &name) {
                (self.incomplete, cx.modes_unnamed) = (true, true);
                return;
            }
            let (Some(effect), Some(numbers)) = (effect, &numbers) else {
                // The names are known, whatever is wrong with the rest.
                cx.lose(name);
                cx.lose(&prefix.value);
                self.incomplete = true;
                continue;
            };
            let mut mode = numbers.mode(name, n, *span);
            mode.doc = doc.clone();
            rotors.iter().for_each(|&rotor| mode.rotors[rotor - 1] = effect);
            self.push(mode);
        }
        if self.modes.len() > first {
            self.families.add(prefix, first..self.modes.len());
        }
    }

    /// Reports names that belong to both a mode and a family, which only all blocks together show.
    pub fn finish(&self, cx: &mut Context) {
        self.families.clashes(&self.names).for_each(|error| cx.report(error));
    }

    /// Remembers the order of the statement that is being read, until the landing sites are known.
    fn note_order(&mut self, numbers: Option<&Numbers>) {
        let order = numbers.and_then(|numbers| numbers.recovery.clone());
        self.orders.extend(order.map(|order| (self.statements, order)));
    }

    fn push(&mut self, mode: FaultMode) {
        self.modes.push(mode);
        self.origin.push(self.statements);
    }

    /// Registers a mode's name; `false` where it is reserved or taken, which is reported.
    fn admit(&mut self, cx: &mut Context, written: &Name, name: &str) -> bool {
        if RESERVED.contains(&name) {
            let message = format!("`{name}` is reserved and cannot name a fault mode");
            let error = Diagnostic::error("mavc::name::reserved", written.span, message);
            cx.report(error.here("reserved name").help("choose another name"));
            return false;
        }
        if let Some(&first) = self.names.get(name) {
            let written = Spanned::new(name.to_string(), written.span);
            cx.report(duplicate("fault mode", &written, first));
            return false;
        }
        if self.modes.len() >= MAX_MODES {
            let message = format!("a spec may have at most {MAX_MODES} fault modes");
            let error = Diagnostic::error("mavc::fault::too_many", written.span, message).here("one too many");
            cx.report(error.help("declare only the modes that matter"));
            return false;
        }
        self.names.insert(name.to_string(), written.span);
        true
    }
}

/// Every choice of `k` from 1..=n, in lexicographic order.
fn combinations(n: usize, k: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next = (k <= n).then(|| (1..=k).collect::<Vec<_>>());
    std::iter::from_fn(move || {
        let current = next.clone()?;
        next = (0..k).rev().find(|&i| current[i] < n - (k - 1 - i)).map(|i| {
            let mut following = current.clone();
            following[i] += 1;
            (i + 1..k).for_each(|j| following[j] = following[j - 1] + 1);
            following
        });
        Some(current)
    })
}

/// What an effect leaves of a rotor.
fn left_by<'a>(cx: &mut Context<'a>, effect: &'a Effect) -> Option<RotorState> {
    const CODE: &str = "mavc::fault::percent";
    match effect {
        Effect::Lost(_) => Some(RotorState::Lost),
        Effect::Reduced(to) => {
            let remaining = cx.share("the remaining thrust of a rotor", to, CODE)?;
            plausibility::effect(cx, remaining, to.span);
            Some(RotorState::of_capacity(remaining))
        }
        Effect::Stuck(at) => cx.share("the thrust a rotor is stuck at", at, CODE).map(RotorState::Stuck),
    }
}

/// The rotors that a mode affects, each with its fault.
struct Effects;

impl Effects {
    fn read<'a>(
        cx: &mut Context<'a>,
        block: &'a Block,
        owner: &str,
        rotors: Option<usize>,
    ) -> Option<Vec<(usize, RotorState)>> {
        let mut all = Some(Vec::new());
        let mut touched: BTreeMap<usize, Span> = BTreeMap::new();
        let mut any = false;
        for statement in &block.body {
            let (list, effect) = match statement {
                Statement::Fault { rotors, effect, .. } => (rotors, effect),
                Statement::Broken(_) => {
                    (any, all) = (true, None);
                    continue;
                }
                _ => continue,
            };
            let loss = left_by(cx, effect);
            let indices = indices(cx, list, rotors);
            any |= indices.as_ref().is_none_or(|known| !known.is_empty());
            for &(k, span) in indices.iter().flatten() {
                if let Some(&first) = touched.get(&k) {
                    let message = format!("rotor {k} is listed twice in {owner}");
                    let error = Diagnostic::error("mavc::fault::rotor_twice", span, message).here("listed again");
                    cx.report(
                        error.also(first, "first listed here").help("remove one: a rotor has one fault per mode"),
                    );
                    all = None;
                } else {
                    touched.insert(k, span);
                }
            }
            match (&mut all, indices, loss) {
                (Some(list), Some(indices), Some(loss)) => list.extend(indices.into_iter().map(|(k, _)| (k, loss))),
                (list, ..) => *list = None,
            }
        }
        if !any {
            let span = block.name.as_ref().map_or(block.keyword.span, |n| n.span);
            let error = Diagnostic::error("mavc::fault::empty", span, format!("{owner} affects no rotor"));
            cx.report(error.here("nothing fails").help("add a fault, such as `rotor 3 lost`"));
            return None;
        }
        all
    }
}

/// `3` or `[1, 6]` as rotor numbers with their places.
fn indices<'a>(cx: &mut Context<'a>, expr: &'a Expr, rotors: Option<usize>) -> Option<Vec<(usize, Span)>> {
    let values = match cx.evaluate(expr)? {
        Value::Quantity(q) => vec![q],
        Value::List(list) => list,
        other => return cx.wrong_kind(&other, "a rotor number or a list of rotor numbers", expr.span),
    };
    let most = rotors.unwrap_or(*super::vehicle::ROTORS.end());
    let mut indices = Some(Vec::new());
    for (i, q) in values.into_iter().enumerate() {
        let place = match &expr.kind {
            ExprKind::List { elements, .. } => elements.get(i).unwrap_or(expr),
            _ => expr,
        };
        let index = cx.lower(Expected::new("rotor", "1"), q, place).and_then(|value| {
            cx.whole_value("a rotor number", value, place.span, 1..=most, "mavc::fault::rotor_index")
        });
        match (&mut indices, index) {
            (Some(list), Some(k)) => list.push((k, place.span)),
            (list, _) => *list = None,
        }
    }
    indices
}

/// The fields of a mode: rate, FMEA numbers, and the reaction to the fault.
struct Numbers {
    after_fault: Option<AfterFault>,
    without_yaw: Option<GiveUpYaw>,
    recovery: Option<recovery::Order>,
    rate: Option<f64>,
    rate_spread: Spread,
    severity: Option<u8>,
    occurrence: Option<u8>,
    detection: Option<u8>,
}

impl Numbers {
    fn read<'a>(cx: &mut Context<'a>, owner: String, span: Span, body: &'a [Statement]) -> Option<Self> {
        let fields = Fields::of_block(cx, owner, span, body, Group::Mode);
        let rate = fields.written(table::RATE.name, |expr| cx.maybe_interval(&table::RATE, expr, "mavc::fault::rate"));
        let mut fmea =
            |entry: &'static Entry| fields.count(cx, entry, "mavc::fault::fmea").and_then(|x| u8::try_from(x).ok());
        let severity = fmea(&table::SEVERITY);
        let occurrence = fmea(&table::OCCURRENCE);
        let detection = fmea(&table::DETECTION);
        let after_fault = after_fault::read(cx, &fields);
        let without_yaw = without_yaw::read(cx, &fields);
        let recovery = fields.written("recovery", |expr| recovery::order(cx, "recovery", expr));
        let rate = rate.optional().ok()?;
        Some(Numbers {
            after_fault: after_fault.optional().ok()?,
            without_yaw: without_yaw.optional().ok()?,
            recovery: recovery.optional().ok()?,
            rate: rate.map(|(rate, _)| rate),
            rate_spread: rate.map_or(Spread::NONE, |(_, spread)| spread),
            severity: severity.optional().ok()?,
            occurrence: occurrence.optional().ok()?,
            detection: detection.optional().ok()?,
        })
    }

    fn mode(&self, name: String, rotors: usize, span: Span) -> FaultMode {
        FaultMode {
            name,
            title: None,
            doc: None,
            rotors: vec![RotorState::Sound; rotors],
            severity: self.severity,
            occurrence: self.occurrence,
            detection: self.detection,
            rate: self.rate,
            rate_spread: self.rate_spread,
            after_fault: self.after_fault,
            without_yaw: self.without_yaw,
            recovery: None,
            span,
        }
    }
}
