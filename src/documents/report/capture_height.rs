//! The height that a fault without control of yaw costs, and how long a plan flies lower. The heights are simulated.

use super::caveats::{Caveat, CaveatKind};
use crate::flight::capture::Capture;
use crate::flight::capture::exposed::Exposed;
use crate::flight::capture::heights::CaptureHeights;
use crate::flight::indistinguishable::listed;
use crate::model::Model;
use crate::number::{fixed, number, plural, significant};
use crate::text_table::{Table, indented};
use serde::Serialize;

/// The height that a fault without control of yaw costs, by simulation.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CaptureRecord {
    /// z of the ground, m.
    pub ground_m: f64,
    /// Delay after which a fault is known, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub delay_s: f64,
    /// The height above the ground that the plan keeps, m; omitted without `require capture_height`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_m: Option<f64>,
    /// The horizontal distance from start and end within which it is not required, m; omitted without `require
    /// capture_height`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
    /// Modes that are concerned and were not simulated.
    pub modes_left_out: usize,
    /// For each mode, at each speed.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub captures: Vec<Capture>,
}

impl CaptureRecord {
    /// The record of a spec with a ground; `None` without one.
    pub fn new(model: &Model, heights: &CaptureHeights) -> Option<Self> {
        let required = model.plan.require_capture.filter(|required| required.height.is_some());
        Some(CaptureRecord {
            ground_m: model.mission.as_ref()?.ground?,
            delay_s: heights.delay,
            height_m: required.and_then(|required| required.height),
            radius_m: required.map(|required| required.radius),
            modes_left_out: heights.left_out,
            captures: heights.cases.clone(),
        })
    }

    /// What the heights are and what the plan keeps, in one sentence.
    pub fn headline(&self) -> String {
        let known = format!("with the fault known after {} ms", number(1e3 * self.delay_s));
        match self.height_m.zip(self.radius_m) {
            Some((height, radius)) => format!(
                "{known}. The plan keeps {} m above the ground outside {} m of start and end",
                significant(height, 3),
                number(radius)
            ),
            None => known,
        }
    }
}

/// The height that a plan keeps and what remains, in one line: `6.64 m kept above the ground outside 5 m of start and
/// end; for up to 8.65 s near them the fall after L1 and L4 may end on the ground (simulated)`; `None` where the spec
/// requires none.
pub fn figure(record: &CaptureRecord, exposed: &[ExposedRecord]) -> Option<String> {
    let (height, radius) = record.height_m.zip(record.radius_m)?;
    let worst = exposed.iter().max_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let near = worst.map_or(String::new(), |worst| {
        let seconds = significant(worst.seconds, 3);
        let modes: Vec<&str> = exposed.iter().map(|of_mode| of_mode.mode.as_str()).collect();
        let modes = listed(&modes);
        format!("; for up to {seconds} s near them the fall after {modes} may end on the ground (simulated)")
    });
    let [height, radius] = [height, radius].map(|m| significant(m, 3));
    Some(format!("{height} m kept above the ground outside {radius} m of start and end{near}"))
}

/// When a plan is lower than the captures of a mode ask for.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ExposedRecord {
    /// The mode's name.
    pub mode: String,
    /// How long the plan is lower than the captures of the mode ask for at its speed, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub seconds: f64,
    /// When it is lower, s, ascending.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub intervals_s: Vec<[f64; 2]>,
    /// The largest height that is missing, m; null where no height is known to be enough.
    pub short_m: Option<f64>,
    /// When it is missing, s.
    pub short_at_s: f64,
}

impl ExposedRecord {
    pub fn new(exposed: &Exposed) -> Self {
        ExposedRecord {
            mode: exposed.mode.clone(),
            seconds: exposed.seconds,
            intervals_s: exposed.intervals.clone(),
            short_m: exposed.short.is_finite().then_some(exposed.short),
            short_at_s: exposed.short_at,
        }
    }

    /// `from 0 s to 4.31 s and from 20.1 s to 25 s`; of many intervals the longest.
    pub fn when(&self) -> String {
        const MOST: usize = 3;
        let mut shown = self.intervals_s.clone();
        shown.sort_by(|a, b| (b[1] - b[0]).total_cmp(&(a[1] - a[0])));
        shown.truncate(MOST);
        shown.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let parts: Vec<String> =
            shown.iter().map(|[from, to]| format!("from {} s to {} s", fixed(*from, 2), fixed(*to, 2))).collect();
        let more = match self.intervals_s.len() - shown.len() {
            0 => String::new(),
            n => format!(", and {n} times more"),
        };
        match parts.as_slice() {
            [rest @ .., last] if !rest.is_empty() => format!("{} and {last}{more}", rest.join(", ")),
            _ => parts.concat(),
        }
    }
}

/// The caveat of a plan that flies lower than its captures ask for although its spec does not require the height: that
/// of the mode to which it is exposed longest.
pub fn caveat(record: &CaptureRecord, exposed: &[ExposedRecord]) -> Option<Caveat> {
    if record.height_m.is_some() {
        return None;
    }
    let worst = exposed.iter().reduce(|a, b| if b.seconds > a.seconds { b } else { a })?;
    let (strikes, modes) = (format!("If mode {} strikes {}", worst.mode, worst.when()), exposed.len() - 1);
    let message = match worst.short_m {
        Some(short) => format!(
            "{strikes}, the plan is too low to regain level flight above the ground, by up to {} m at {} s; simulated, \
             not proved.{} Add `require capture_height {{ }}` to `plan`, or fly higher.",
            significant(short, 3),
            fixed(worst.short_at_s, 2),
            if modes > 0 { format!(" It is too low for {}.", plural(modes, "more mode")) } else { String::new() }
        ),
        None => format!(
            "{strikes}, some simulated flights never regain level flight, so no height was shown to be enough.{}",
            if modes > 0 { format!(" The plan is exposed to {}.", plural(modes, "more mode")) } else { String::new() }
        ),
    };
    let at_s = worst.short_at_s;
    Some(Caveat { kind: CaveatKind::CaptureHeight, limit: None, value: worst.seconds, at_s, message })
}

/// The worst height of a case, m: `7.5`, rounded up; `-` if not every flight regains level flight.
pub fn worst(case: &Capture) -> String {
    match case.height_m {
        Some([_, _, largest]) if case.regained == case.flights => fixed((10.0 * largest).ceil() / 10.0, 1),
        _ => "-".into(),
    }
}

/// Terminal output: the captures, and for each mode how long the plan is lower.
pub fn text(record: &CaptureRecord, exposed: &[ExposedRecord]) -> String {
    let flights = record.captures.first().map_or(0, |case| case.flights);
    let head = format!(
        "Height [m] that a fault costs until level flight is regained, {}. The most of {flights} flights each, \
         however far they drift: simulated, not proved",
        record.headline()
    );
    let wrap = |text: &str| format!("\n{}", indented(text));
    let mut out = wrap(&head);
    let modes: Vec<&[Capture]> = record.captures.chunk_by(|a, b| a.mode == b.mode).collect();
    let speeds = modes.first().map_or(&[][..], |of_mode| of_mode);
    let columns = speeds.iter().map(|case| format!("{} m/s", significant(case.speed_m_per_s, 3)));
    let headings: Vec<String> = std::iter::once("mode".to_string())
        .chain(columns)
        .chain(["exposed", "lowest by", "at"].map(String::from))
        .collect();
    let mut table = Table::new(&headings.iter().map(String::as_str).collect::<Vec<_>>());
    for of_mode in &modes {
        let mut cells = vec![of_mode[0].mode.clone()];
        cells.extend(of_mode.iter().map(worst));
        match exposed.iter().find(|exposed| exposed.mode == of_mode[0].mode) {
            Some(found) => {
                let short = found.short_m.map_or("-".into(), |short| format!("{} m", significant(short, 3)));
                let at = format!("{} s", fixed(found.short_at_s, 2));
                cells.extend([format!("{} s", significant(found.seconds, 3)), short, at]);
            }
            None => cells.extend(["0 s", "-", "-"].map(String::from)),
        }
        table.row(cells);
    }
    out.push_str(&table.render(2));
    if record.modes_left_out > 0 {
        out.push_str(&format!("  {} more modes were not simulated\n", record.modes_left_out));
    }
    if let Some(caveat) = caveat(record, exposed) {
        out.push_str(&wrap(&caveat.message));
    }
    out
}
