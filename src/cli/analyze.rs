use super::spec::{self, timing};
use super::{AnalyzeArgs, FINE, Format, Options, Problem, SPEC_ERRORS, files};
use crate::admissible::AdmissibleSet;
use crate::admissible::verdict::{ModeAnalysis, Verdict, analyze_all};
use crate::model::{FileSet, Model, elaborate, parse_override};
use crate::report::number::significant;
use crate::report::terminal;
use serde::Serialize;
use std::time::Instant;

#[derive(Serialize)]
struct Record<'a> {
    schema: u32,
    vehicle: &'a str,
    rotors: usize,
    modes: &'a [ModeAnalysis],
    #[serde(skip_serializing_if = "Option::is_none")]
    flips: Option<&'a [Flip]>,
}

/// `mavc analyze`
pub fn run(args: &AnalyzeArgs, options: &Options) -> Result<u8, Problem> {
    let mut loaded = spec::read(&args.spec, options)?;
    loaded.tell(options);
    let Some(model) = &loaded.model else { return Ok(SPEC_ERRORS) };
    let begin = Instant::now();
    let sets = AdmissibleSet::all(model);
    timing(options, "sets", begin);
    let begin = Instant::now();
    let modes = analyze_all(model, &sets);
    timing(options, "verdicts", begin);
    let flips = match &args.sweep {
        Some(text) => Some(sweep(text, &loaded.files, &args.spec.set)?),
        None => None,
    };
    match args.format {
        Format::Json => {
            let record = Record {
                schema: 1,
                vehicle: &model.vehicle.name,
                rotors: model.vehicle.rotors.len(),
                modes: &modes,
                flips: flips.as_ref().map(|f| f.flips.as_slice()),
            };
            let text = serde_json::to_string(&record).map_err(|e| e.to_string())?;
            files::print(&(text + "\n"))?;
        }
        Format::Human => match &flips {
            None => files::print(&terminal::analysis(model, &modes))?,
            Some(f) => files::print(&f.to_text(model))?,
        },
    }
    Ok(FINE)
}

/// A verdict that changes at a value of the swept field.
#[derive(Debug, Clone, Serialize)]
struct Flip {
    mode: String,
    /// In the unit of the sweep.
    at: f64,
    below: Verdict,
    above: Verdict,
}

struct Sweep {
    field: String,
    low: f64,
    high: f64,
    unit: String,
    /// Verdicts at the low end.
    start: Vec<(String, Verdict)>,
    flips: Vec<Flip>,
}

/// Looks at this many equal parts, then halves each that holds a flip.
const PARTS: usize = 64;

fn sweep(text: &str, files: &FileSet, set: &[String]) -> Result<Sweep, Problem> {
    let shape = || format!("--sweep {text}: write a field and a range such as mass=1.5..2.5kg");
    let (field, range) = text.split_once('=').ok_or_else(shape)?;
    let (low, high) = range.split_once("..").ok_or_else(shape)?;
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
        t.strip_suffix(unit).unwrap_or(t).trim().parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(shape)
    };
    let (low, high) = (parse(low)?, parse(high)?);
    if low.partial_cmp(&high) != Some(std::cmp::Ordering::Less) {
        return Err(format!("--sweep {text}: the range must rise"));
    }
    let field = field.trim();
    let path = if field.contains('.') { field.to_string() } else { format!("vehicle.{field}") };
    let at = |value: f64| verdicts(&path, value, unit, files, set).map_err(|e| format!("--sweep {text}: {e}"));
    let start = at(low)?;
    let mut flips = Vec::new();
    let mut left = (low, start.clone());
    for i in 1..=PARTS {
        let value = low + (high - low) * i as f64 / PARTS as f64;
        let right = (value, at(value)?);
        for mode in 0..right.1.len() {
            let (below, above) = (left.1[mode].1, right.1[mode].1);
            if below == above {
                continue;
            }
            let (mut a, mut b) = (left.0, right.0);
            while b - a > 1e-7 * (high - low).max(b.abs()) {
                let middle = 0.5 * (a + b);
                if at(middle)?[mode].1 == below { a = middle } else { b = middle }
            }
            flips.push(Flip { mode: right.1[mode].0.clone(), at: 0.5 * (a + b), below, above });
        }
        left = right;
    }
    flips.sort_by(|a, b| a.at.total_cmp(&b.at));
    Ok(Sweep { field: field.into(), low, high, unit: unit.into(), start, flips })
}

/// Every mode's verdict with the field set to a value.
fn verdicts(
    path: &str,
    value: f64,
    unit: &str,
    files: &FileSet,
    set: &[String],
) -> Result<Vec<(String, Verdict)>, Problem> {
    let mut files = files.clone();
    let mut overrides = Vec::new();
    for text in set.iter().cloned().chain([format!("{path}={value}{unit}")]) {
        overrides.push(parse_override(&text, &mut files.sources).map_err(|d| d.message)?);
    }
    let checked = elaborate(&files, &overrides);
    let first = checked.diagnostics.iter().find(|d| d.severity == crate::diagnostic::Severity::Error);
    // A vehicle too heavy to hover is an answer here, not a mistake.
    match (checked.value, first) {
        (Some(model), None) => {
            Ok(analyze_all(&model, &AdmissibleSet::all(&model)).into_iter().map(|m| (m.name, m.verdict)).collect())
        }
        (_, Some(d)) => Err(format!("at {}{unit}: {}", significant(value, 6), d.message)),
        (None, None) => Err(format!("at {}{unit} the spec has no model", significant(value, 6))),
    }
}

impl Sweep {
    fn to_text(&self, model: &Model) -> String {
        let mut out = format!(
            "{}, {} from {} to {} {}\n",
            terminal::vehicle_line(model),
            self.field,
            significant(self.low, 6),
            significant(self.high, 6),
            self.unit
        );
        for (mode, verdict) in &self.start {
            out.push_str(&format!("  {mode}: {}", verdict.name()));
            for f in self.flips.iter().filter(|f| f.mode == *mode) {
                out.push_str(&format!(", {} above {} {}", f.above.name(), significant(f.at, 6), self.unit));
            }
            out.push('\n');
        }
        out.push_str(&format!("Looked at {} values; two flips closer than a step may be missed.\n", PARTS + 1));
        out
    }
}
