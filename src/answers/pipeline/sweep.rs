//! The values of one field of a spec at which verdicts change (`mavc analyze --sweep`).

use crate::admissible::edge::HoverPlace;
use crate::admissible::verdict::{HoverVerdict, ModeAnalysis, analyze_each};
use crate::admissible::without_yaw::YawFree;
use crate::diagnostic::{Diagnostic, Severity, nearest};
use crate::language;
use crate::model::Model;
use crate::number::significant;
use crate::read::{FileSet, is_override};
use crate::report::terminal;
use crate::source::{SourceMap, Span};
use crate::spec::Spec;
use crate::syntax::ast::Item;
use serde::Serialize;

/// Why a sweep cannot be made, in one sentence.
type SweepError = String;

/// The code of a vehicle that weighs more than all its rotors lift.
const TOO_HEAVY: &str = "mavc::vehicle::too_heavy";

/// A verdict that changes at a value of the swept field.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Flip {
    /// The mode's name.
    mode: String,
    /// Value of the swept field, in the unit of the sweep.
    at: f64,
    /// The verdict below the flip.
    below: HoverVerdict,
    /// Where hover lies below the flip.
    below_hover: HoverPlace,
    /// How the mode hovers with yaw given up below the flip.
    below_yaw_free: YawFree,
    /// The verdict above the flip.
    above: HoverVerdict,
    /// Where hover lies above the flip.
    above_hover: HoverPlace,
    /// How the mode hovers with yaw given up above the flip.
    above_yaw_free: YawFree,
}

/// A sweep over one field: the verdicts at its low end, and the changes above it.
pub struct Sweep {
    field: String,
    low: f64,
    high: f64,
    unit: String,
    /// Verdicts at the low end.
    start: Vec<(String, Standing)>,
    pub flips: Vec<Flip>,
}

impl Flip {
    fn new(mode: String, at: f64, below: Standing, above: Standing) -> Self {
        Flip {
            mode,
            at,
            below: below.verdict,
            below_hover: below.hover,
            below_yaw_free: below.yaw_free,
            above: above.verdict,
            above_hover: above.hover,
            above_yaw_free: above.yaw_free,
        }
    }

    fn above(&self) -> Standing {
        Standing { verdict: self.above, hover: self.above_hover, yaw_free: self.above_yaw_free }
    }
}

/// A mode's verdict, the place of hover, and how it hovers with yaw given up; a change of any of these is a flip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Standing {
    verdict: HoverVerdict,
    hover: HoverPlace,
    yaw_free: YawFree,
}

impl Standing {
    const TOO_HEAVY: Standing =
        Standing { verdict: HoverVerdict::Unstable, hover: HoverPlace::Outside, yaw_free: YawFree::None };

    /// `controllable`, `stabilizable, on the edge`, `stabilizable, spinning`
    fn words(self) -> String {
        match self.hover {
            HoverPlace::OnEdge if self.verdict == HoverVerdict::Stabilizable => {
                format!("{}, {}", self.verdict.name(), self.yaw_free.word())
            }
            HoverPlace::OnEdge => format!("{}, {}", self.verdict.name(), self.hover.word()),
            HoverPlace::Inside | HoverPlace::Outside => self.verdict.name().into(),
        }
    }
}

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
        let standings = |spec: Spec| {
            let modes = analyze_each(spec.model());
            modes.iter().map(|m| Standing { verdict: m.verdict, hover: m.hover, yaw_free: m.yaw_free }).collect()
        };
        let error = match self.spec.set(&format!("{path}={value}{unit}")) {
            Ok(spec) => return Ok(standings(spec)),
            Err(error) => error,
        };
        let mut errors = error.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        match errors.find(|d| !self.is_too_heavy(d, &error.files.sources)) {
            Some(d) => Err(format!("at {}{unit}: {}", significant(value, 6), d.message)),
            None => Ok(vec![Standing::TOO_HEAVY; self.modes.len()]),
        }
    }

    /// A vehicle that is too heavy for all its rotors is a result here, not a mistake: no mode lifts more than they
    /// do. The error is about this vehicle if it points at its name, at its mass or at the value that is swept.
    fn is_too_heavy(&self, error: &Diagnostic, sources: &SourceMap) -> bool {
        let vehicle = &self.spec.model().vehicle;
        let is_of_it = |at: Span| at == vehicle.span || at == vehicle.mass_span || is_override(sources, at);
        error.code == TOO_HEAVY && (is_of_it(error.span) || error.labels.iter().any(|label| is_of_it(label.span)))
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
                        (flip.below, flip.below_hover, flip.below_yaw_free) =
                            (entered.below, entered.below_hover, entered.below_yaw_free);
                    }
                    flips.push(flip);
                    left = (b, above);
                }
            }
            left = right;
        }
        flips.sort_by(|a, b| a.at.total_cmp(&b.at));
        let start = subject.modes.iter().map(|m| m.name.clone()).zip(start).collect();
        Ok(Sweep { field: field.into(), low, high, unit: unit.into(), start, flips })
    }

    pub fn to_text(&self, model: &Model) -> String {
        let mut out = format!(
            "{}, {} from {} to {} {}\n",
            terminal::vehicle_line(model),
            self.field,
            significant(self.low, 6),
            significant(self.high, 6),
            self.unit
        );
        for (mode, verdict) in &self.start {
            out.push_str(&format!("  {mode}: {}", verdict.words()));
            for f in self.flips.iter().filter(|f| f.mode == *mode) {
                out.push_str(&format!("; {} above {} {}", f.above().words(), significant(f.at, 5), self.unit));
            }
            out.push('\n');
        }
        if model.vehicle.is_uncertain() {
            out.push_str("Verdicts are those of the nominal values; the intervals of the spec are ignored.\n");
        }
        out.push_str(&format!("{} values were sampled; two changes within one step can be missed.\n", PARTS + 1));
        out
    }
}
