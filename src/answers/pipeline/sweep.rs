//! The values of one field of a spec at which outcomes and verdicts change (`mavc analyze --sweep`).

use crate::admissible::edge::HoverPlace;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::{HoverVerdict, ModeAnalysis, Standing};
use crate::admissible::without_yaw::YawFree;
use crate::diagnostic::{Diagnostic, Severity, nearest};
use crate::flight::equilibrium::standings;
use crate::language;
use crate::model::Model;
use crate::number::significant;
use crate::read::{FileSet, is_override};
use crate::report::mode_names::within;
use crate::report::screen::WIDTH;
use crate::report::terminal;
use crate::source::{SourceMap, Span};
use crate::spec::Spec;
use crate::syntax::ast::Item;
use serde::Serialize;

/// Why a sweep cannot be made, in one sentence.
type SweepError = String;

/// The code of a vehicle that weighs more than all its rotors lift.
const TOO_HEAVY_CODE: &str = "mavc::vehicle::too_heavy";

/// A change of a mode at a value of the swept field: of its outcome or of a verdict.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Flip {
    /// The mode's name.
    mode: String,
    /// Value of the swept field, in the unit of the sweep.
    at: f64,
    /// The outcome below the flip.
    below_outcome: Outcome,
    /// The verdict below the flip.
    below: HoverVerdict,
    /// Where hover lies below the flip.
    below_hover: HoverPlace,
    /// How the mode hovers with yaw given up below the flip.
    below_yaw_free: YawFree,
    /// The outcome above the flip.
    above_outcome: Outcome,
    /// The verdict above the flip.
    above: HoverVerdict,
    /// Where hover lies above the flip.
    above_hover: HoverPlace,
    /// How the mode hovers with yaw given up above the flip.
    above_yaw_free: YawFree,
}

/// A sweep over one field: the outcomes at its low end, and the changes above it.
pub struct Sweep {
    field: String,
    low: f64,
    high: f64,
    unit: String,
    /// Outcomes at the low end, of the healthy vehicle and of every mode.
    start: Vec<(String, Outcome)>,
    pub flips: Vec<Flip>,
}

impl Flip {
    fn new(mode: String, at: f64, below: Standing, above: Standing) -> Self {
        Flip {
            mode,
            at,
            below_outcome: below.outcome,
            below: below.verdict,
            below_hover: below.hover,
            below_yaw_free: below.yaw_free,
            above_outcome: above.outcome,
            above: above.verdict,
            above_hover: above.hover,
            above_yaw_free: above.yaw_free,
        }
    }

    /// The flip that begins below an earlier one and ends above this one.
    fn since(mut self, earlier: Flip) -> Self {
        (self.below_outcome, self.below) = (earlier.below_outcome, earlier.below);
        (self.below_hover, self.below_yaw_free) = (earlier.below_hover, earlier.below_yaw_free);
        self
    }
}

/// A mode of a vehicle that all its rotors do not lift.
const TOO_HEAVY: Standing = Standing {
    outcome: Outcome::Lost,
    verdict: HoverVerdict::Unstable,
    hover: HoverPlace::Outside,
    yaw_free: YawFree::None,
};

/// The path of the override for a swept field: a field of the table's column `sweepable`, where `vehicle.` may be
/// left out, or a `let`.
fn path(field: &str, files: &FileSet) -> Result<String, SweepError> {
    let short = |path: String| path.strip_prefix(VEHICLE).map(String::from).unwrap_or(path);
    let known: Vec<String> = language::sweepable().map(short).collect();
    let inner = field.strip_prefix(VEHICLE).unwrap_or(field);
    if let Some(path) = language::sweepable().find(|path| *path == field || path.strip_prefix(VEHICLE) == Some(inner)) {
        return Ok(path);
    }
    let items = files.files.iter().flat_map(|file| &file.items);
    let lets: Vec<&str> =
        items.filter_map(|item| if let Item::Let(l) = item { Some(l.name.value.as_str()) } else { None }).collect();
    if lets.contains(&field) {
        return Ok(field.into());
    }
    let names = || known.iter().map(String::as_str);
    let of_block = names().find(|name| name.rsplit_once('.').is_some_and(|(_, last)| last == inner));
    Err(match of_block.or_else(|| nearest(inner, names().chain(lets))) {
        Some(near) => format!("no verdict depends on a field `{field}`; did you mean `{near}`?"),
        None => format!("no verdict depends on `{field}`; sweep {} or a `let`", known.join(", ")),
    })
}

const VEHICLE: &str = "vehicle.";

/// The range is divided into this many equal parts; a part that contains a flip is bisected.
const PARTS: usize = 64;

/// Most columns of the names of modes in a line.
const NAMES: usize = 32;

/// The field that a sweep varies, and its range.
struct Range<'a> {
    field: &'a str,
    low: f64,
    high: f64,
    unit: &'a str,
}

/// Reads `mass=1.5..2.5kg`; `None` if the text has another form.
fn range(text: &str) -> Option<Range<'_>> {
    let (field, range) = text.split_once('=')?;
    let (low, high) = range.split_once("..")?;
    let unit_at = high
        .char_indices()
        .find(|&(i, c)| {
            let exponent = matches!(c, 'e' | 'E')
                && high[i + 1..].starts_with(|n: char| n.is_ascii_digit() || n == '-' || n == '+');
            !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | ' ') || exponent)
        })
        .map_or(high.len(), |(i, _)| i);
    let (high, unit) = high.split_at(unit_at);
    let unit = unit.trim();
    let parse = |t: &str| {
        let t = t.trim();
        t.strip_suffix(unit).unwrap_or(t).trim().parse::<f64>().ok().filter(|v| v.is_finite())
    };
    Some(Range { field: field.trim(), low: parse(low)?, high: parse(high)?, unit })
}

/// The spec that is swept, and the analyses of its modes as it is written.
struct Subject<'a> {
    spec: &'a Spec,
    modes: &'a [ModeAnalysis],
}

impl Subject<'_> {
    /// Every mode's verdict with the field set to a value, in the order of the modes.
    fn verdicts(&self, path: &str, value: f64, unit: &str) -> Result<Vec<Standing>, SweepError> {
        let error = match self.spec.set(&format!("{path}={value}{unit}")) {
            Ok(spec) => return Ok(standings(spec.model())),
            Err(error) => error,
        };
        let mut errors = error.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        match errors.find(|d| !self.is_too_heavy(d, &error.files.sources)) {
            Some(d) => Err(format!("at {}{unit}: {}", significant(value, 6), d.message)),
            None => Ok(vec![TOO_HEAVY; self.modes.len()]),
        }
    }

    /// A vehicle that is too heavy for all its rotors is a result here, not a mistake: no mode lifts more than they
    /// do. The error is about this vehicle if it points at its name, at its mass or at the value that is swept.
    fn is_too_heavy(&self, error: &Diagnostic, sources: &SourceMap) -> bool {
        let vehicle = &self.spec.model().vehicle;
        let is_of_it = |at: Span| at == vehicle.span || at == vehicle.mass_span || is_override(sources, at);
        error.code == TOO_HEAVY_CODE && (is_of_it(error.span) || error.labels.iter().any(|label| is_of_it(label.span)))
    }
}

impl Sweep {
    /// Runs the sweep that `text` describes, such as `mass=1.5..2.5kg`: a field of the vehicle, gravity or a `let`,
    /// and a range in one unit. `modes` are the analyses of the spec as it is written ([`crate::analyze`]).
    ///
    /// # Errors
    /// The text has another form, no verdict depends on the field, or the spec has errors at a value of the field.
    pub fn run(text: &str, spec: &Spec, modes: &[ModeAnalysis]) -> Result<Sweep, SweepError> {
        let subject = Subject { spec, modes };
        let fail = |why: String| format!("--sweep {text}: {why}");
        let Range { field, low, high, unit } =
            range(text).ok_or_else(|| fail("write a field and a range such as mass=1.5..2.5kg".into()))?;
        if low.partial_cmp(&high) != Some(std::cmp::Ordering::Less) {
            return Err(fail("the range must start with the smaller value".into()));
        }
        let path = path(field, spec.files()).map_err(fail)?;
        let at = |value: f64| subject.verdicts(&path, value, unit).map_err(fail);
        let start = at(low)?;
        let mut flips = Vec::new();
        let mut left = (low, start.clone());
        for i in 1..=PARTS {
            let value = low + (high - low) * i as f64 / PARTS as f64;
            let right = (value, at(value)?);
            for (k, mode) in subject.modes.iter().enumerate() {
                // Between two sampled values a verdict may change more than once.
                let mut left = (left.0, left.1[k]);
                // Hover is on the edge of a set within a tolerance, so it passes that state; only a lasting one is
                // listed.
                let is_passed = |flip: &Flip, at: f64| {
                    flip.mode == mode.name
                        && flip.above_hover == HoverPlace::OnEdge
                        && at - flip.at <= 1e-4 * (high - low)
                };
                while left.1 != right.1[k] {
                    let (mut a, mut b, mut above) = (left.0, right.0, right.1[k]);
                    while b - a > 1e-7 * (high - low).max(b.abs()) {
                        let middle = 0.5 * (a + b);
                        match at(middle)?[k] {
                            same if same == left.1 => a = middle,
                            other => (b, above) = (middle, other),
                        }
                    }
                    let mut flip = Flip::new(mode.name.clone(), 0.5 * (a + b), left.1, above);
                    if let Some(entered) = flips.pop_if(|before| is_passed(before, flip.at)) {
                        flip = flip.since(entered);
                    }
                    flips.push(flip);
                    left = (b, above);
                }
            }
            left = right;
        }
        flips.sort_by(|a, b| a.at.total_cmp(&b.at));
        let outcomes = start.iter().map(|standing| standing.outcome);
        let start = subject.modes.iter().map(|m| m.name.clone()).zip(outcomes).collect();
        Ok(Sweep { field: field.into(), low, high, unit: unit.into(), start, flips })
    }

    /// The field with its range, and the outcomes of the modes over it.
    pub fn outcomes(&self) -> String {
        let [low, high] = [self.low, self.high].map(|value| significant(value, 6));
        let mut out = format!("{} from {low} to {high} {}\n", self.field, self.unit);
        let mut rows: Vec<(String, Vec<usize>)> = Vec::new();
        for (k, (mode, outcome)) in self.start.iter().enumerate() {
            let mut text = outcome.word().to_string();
            let mut last = *outcome;
            for flip in self.flips.iter().filter(|flip| flip.mode == *mode) {
                if flip.above_outcome != last {
                    last = flip.above_outcome;
                    text.push_str(&format!("; above {}\u{a0}{} {}", significant(flip.at, 5), self.unit, last.word()));
                }
            }
            match rows.iter_mut().find(|(same, _)| *same == text) {
                Some((_, modes)) => modes.push(k),
                None => rows.push((text, vec![k])),
            }
        }
        let names: Vec<String> = self.start.iter().map(|(mode, _)| mode.clone()).collect();
        for (text, modes) in &rows {
            let row = format!("{}: {text}", within(&names, modes, NAMES));
            let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("    ");
            out.push_str(&format!("{}\n", textwrap::fill(&row, options).replace('\u{a0}', " ")));
        }
        out
    }

    pub fn to_text(&self, model: &Model) -> String {
        let mut out = format!("{}, {}", terminal::vehicle_line(model), self.outcomes());
        if model.vehicle.is_uncertain() {
            out.push_str("Outcomes hold for all values of the spec's intervals, or are undecided.\n");
        }
        out.push_str(&format!("{} values were sampled; two changes within one step can be missed.\n", PARTS + 1));
        out
    }
}
