//! A flight as a run of the page, compared with its plan.

use super::chart::{Bound, Chart, Columns, Line, column};
use super::content::{DIVERGED as DIVERGED_AT, LOST, Mark, Phase, RunContent, TRESPASSED as TRESPASSED_AT};
use super::motion::WRENCH;
use super::table::{Frame, numbers, table, words};
use crate::admissible::hover;
use crate::flight::{Sample, Sortie};
use crate::model::Model;
use crate::motion::Trajectory;
use crate::number::{fixed, number, significant};
use crate::report::simulation::{
    DIVERGED, FaultRecord, FlightRecord, OutcomeRecord, detection, duration, landed, length, loss, no_fault,
    to_its_end, trespass, turned,
};
use maud::{Markup, html};

/// Most instants that are kept.
const MOST_INSTANTS: f64 = 1_000.0;

/// Collects the data that a page shows of a flight.
#[derive(Debug, Clone)]
pub struct Track {
    columns: Columns,
    /// One of this many samples is kept.
    every: usize,
    count: usize,
}

impl Track {
    /// For a flight along a plan.
    pub fn along(model: &Model, trajectory: &Trajectory) -> Self {
        Track::new(model, Sortie::along(model, trajectory, &[], 0).duration)
    }

    /// For a flight of `duration` s.
    pub fn new(model: &Model, duration: f64) -> Self {
        let samples = duration * model.simulation.control_rate;
        Track { columns: Columns::new(), every: (samples / MOST_INSTANTS).ceil().max(1.0) as usize, count: 0 }
    }

    /// Adds a sample if one is due, or if it is the last.
    pub fn add(&mut self, sample: &Sample) {
        self.count += 1;
        if !(self.count - 1).is_multiple_of(self.every) && !sample.is_last {
            return;
        }
        let Sample { body, reference, .. } = sample;
        let mut put = |name: &str, value: f64| self.columns.entry(name.to_string()).or_default().push(value);
        put("t", sample.time);
        let [roll, pitch, yaw] = body.angles().map(f64::to_degrees);
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            put(name, body.position[axis]);
            put(&format!("{name}_ref"), reference.position[axis]);
        }
        for (name, value) in [("roll", roll), ("pitch", pitch), ("yaw", yaw)] {
            put(name, value);
        }
        let planned = reference.yaw[0];
        put("heading", (planned + sample.heading.turned()).to_degrees());
        put("yaw_ref", planned.to_degrees());
        put("speed", body.velocity.norm());
        put("tilt", body.tilt().to_degrees());
        put("error", (body.position - reference.position).norm());
        for (axis, name) in WRENCH.into_iter().enumerate() {
            put(name, sample.wrench[axis]);
            put(&format!("{name}_cmd"), sample.wanted[axis]);
        }
        for (k, speed) in sample.speeds.iter().enumerate() {
            put(&format!("omega_{}", k + 1), *speed);
        }
        for (k, theta) in sample.estimated.iter().enumerate() {
            put(&format!("theta_{}", k + 1), *theta);
        }
    }

    /// The flight as the page shows it; `record` has its outcome.
    pub fn run(self, model: &Model, record: &FlightRecord) -> RunContent {
        let columns: Columns = self.columns.into_iter().map(|(name, v)| (name, column(v.into_iter()))).collect();
        let charts = charts(model, &columns, record).into_iter().map(Chart::set).collect();
        RunContent {
            label: "the flight".into(),
            leads: true,
            figures: None,
            wrench: "actual wrench",
            columns,
            charts,
            passed: Vec::new(),
            strips: Vec::new(),
            marks: marks(record),
            phases: phases(record),
            nearest: Vec::new(),
        }
    }
}

/// The outcome in one sentence.
pub fn headline(model: &Model, record: &FlightRecord) -> String {
    match record.outcome {
        OutcomeRecord::Flown => format!("{}{}", to_its_end(model, record), no_fault(record)),
        OutcomeRecord::Trespassed { at_s } => format!("Not survived: {}", trespass(at_s)),
        OutcomeRecord::Landed { at_s, place_m, speed_m_s } => landed(at_s, place_m, speed_m_s),
        OutcomeRecord::Lost { at_s, cause, at_end } => {
            format!("Lost at {} s: {}", fixed(at_s, 2), loss(model, cause, at_end))
        }
        OutcomeRecord::Diverged { at_s } => format!("Diverged at {} s: {DIVERGED}", fixed(at_s, 2)),
    }
}

fn struck(record: &FlightRecord) -> impl Iterator<Item = &FaultRecord> {
    record.faults.iter().filter(|f| f.struck)
}

fn marks(record: &FlightRecord) -> Vec<Mark> {
    let mut marks = Vec::new();
    for fault in struck(record) {
        marks.push(Mark { t: fault.at_s, label: format!("{} strikes", fault.mode) });
        marks.extend(fault.detected_after_s.map(|d| Mark { t: fault.at_s + d, label: String::new() }));
        marks.extend(fault.until_s.map(|t| Mark { t, label: format!("{} ends", fault.mode) }));
    }
    match record.outcome {
        OutcomeRecord::Lost { at_s, .. } => marks.push(Mark { t: at_s, label: LOST.into() }),
        OutcomeRecord::Diverged { at_s } => marks.push(Mark { t: at_s, label: DIVERGED_AT.into() }),
        OutcomeRecord::Trespassed { at_s } => marks.push(Mark { t: at_s, label: TRESPASSED_AT.into() }),
        OutcomeRecord::Flown | OutcomeRecord::Landed { .. } => {}
    }
    marks
}

/// Periods of the flight with the same faults in force.
fn phases(record: &FlightRecord) -> Vec<Phase> {
    let changes = struck(record)
        .flat_map(|f| [Some(f.at_s), f.detected_after_s.map(|d| f.at_s + d), f.until_s].into_iter().flatten());
    let mut instants: Vec<f64> = std::iter::once(0.0).chain(changes.filter(|t| *t <= record.end_s)).collect();
    instants.sort_by(f64::total_cmp);
    let mut phases: Vec<Phase> =
        instants.into_iter().map(|from| Phase { from, label: faults_at(record, from) }).collect();
    // Of several changes at one instant, the last applies.
    phases.reverse();
    phases.dedup_by(|next, kept| next.from == kept.from);
    phases.reverse();
    phases.dedup_by(|next, kept| next.label == kept.label);
    phases
}

/// `no fault`, `M3 undetected`, `M3 detected`; just `M3` if faults are never detected.
fn faults_at(record: &FlightRecord, t: f64) -> String {
    let present = struck(record).filter(|f| f.at_s <= t && f.until_s.is_none_or(|until| t < until));
    let words: Vec<String> = present
        .map(|f| match f.detected_after_s {
            Some(after) if f.at_s + after <= t => format!("{} detected", f.mode),
            _ if record.detection == "never" => f.mode.clone(),
            _ => format!("{} undetected", f.mode),
        })
        .collect();
    if words.is_empty() { "no fault".into() } else { words.join(", ") }
}

fn charts(model: &Model, columns: &Columns, record: &FlightRecord) -> Vec<Chart> {
    let most = |name: &str| columns.get(name).map_or(0.0, |v| v.iter().fold(0.0, |m: f64, x| m.max(x.abs())));
    let plain = |id, title, headline: String, unit, lines: Vec<Line>| Chart {
        id,
        title,
        headline,
        unit,
        lines,
        bounds: Vec::new(),
        axis: None,
    };
    let places = ["x", "y", "z"].into_iter();
    let rms = length(record.rms_error_m);
    let mut charts = vec![
        plain(
            "position",
            "Position",
            format!("The position error is {rms} root mean square; largest {}", length(record.max_error_m)),
            "m",
            places.flat_map(|n| [Line::new(n, n), Line::aim(format!("{n} planned"), format!("{n}_ref"))]).collect(),
        ),
        Chart {
            bounds: vec![Bound::limit("lost beyond", model.simulation.lost_beyond)],
            ..plain(
                "error",
                "Position error",
                match record.rms_error_after_m {
                    Some(e) => format!("Since the first fault the error is {} root mean square", length(e)),
                    None => format!("The error is {rms} root mean square"),
                },
                "m",
                vec![Line::new("error", "error")],
            )
        },
        plain(
            "yaw",
            "Heading",
            yaw_headline(record),
            "deg",
            vec![Line::new("heading", "heading"), Line::aim("heading planned", "yaw_ref")],
        ),
        plain(
            "speed",
            "Speed",
            format!("Speed reaches {} m/s", significant(most("speed"), 3)),
            "m/s",
            vec![Line::new("speed", "speed")],
        ),
        plain(
            "tilt",
            "Tilt",
            format!("Tilt reaches {} deg", significant(record.max_tilt_rad.to_degrees(), 3)),
            "deg",
            ["tilt", "roll", "pitch"].map(|n| Line::new(n, n)).to_vec(),
        ),
    ];
    let wrench = [
        ("thrust", "Thrust", "N"),
        ("tau_x", "Torque about x", "N m"),
        ("tau_y", "Torque about y", "N m"),
        ("tau_z", "Torque about z", "N m"),
    ];
    charts.extend(wrench.into_iter().enumerate().map(|(axis, (id, title, unit))| Chart {
        axis: Some(axis),
        bounds: if axis == 0 { vec![Bound::reference("weight", hover(model)[0])] } else { Vec::new() },
        ..plain(
            id,
            title,
            format!("{title} reaches {} {unit}", significant(most(id), 3)),
            unit,
            vec![Line::new("actual", id), Line::aim("commanded", format!("{id}_cmd"))],
        )
    }));
    let rotors = model.vehicle.rotors.len();
    let numbered =
        |column: &str| (1..=rotors).map(|k| Line::new(format!("rotor {k}"), format!("{column}_{k}"))).collect();
    let fastest = (1..=rotors).map(|k| most(&format!("omega_{k}"))).fold(0.0, f64::max);
    charts.push(plain(
        "rotors",
        "Rotor speeds",
        format!("Rotor speeds reach {} rad/s", significant(fastest, 3)),
        "rad/s",
        numbered("omega"),
    ));
    if columns.contains_key("theta_1") {
        charts.push(plain("estimates", "Estimated rotor capacities", estimates(record), "share", numbered("theta")));
    }
    charts
}

/// The heading error, and the number of whole turns.
fn yaw_headline(record: &FlightRecord) -> String {
    let degrees = |angle: f64| significant(angle.to_degrees(), 3);
    let rms = degrees(record.rms_heading_error_rad);
    let largest = degrees(record.max_heading_error_rad);
    format!("The heading error is {rms} deg root mean square; largest {largest} deg{}", turned(record.turns))
}

fn estimates(record: &FlightRecord) -> String {
    let alarms = match record.false_alarms {
        0 => "no false alarm".to_string(),
        1 => "1 false alarm".to_string(),
        n => format!("{n} false alarms"),
    };
    match struck(record).next().map(|f| (&f.mode, f.isolated_after_s)) {
        Some((mode, Some(after))) => {
            format!("{mode} is isolated after {}, with {alarms}", duration(after))
        }
        Some((mode, None)) => format!("{mode} is never isolated, with {alarms}"),
        None => format!("No fault strikes; {alarms}"),
    }
}

/// The table of faults.
pub fn section(record: &FlightRecord) -> Markup {
    let after = |t: Option<f64>| t.map_or("never".to_string(), |t| significant(1e3 * t, 3));
    let heads = [
        words("Mode"),
        numbers("Strikes", "s"),
        numbers("Ends", "s"),
        numbers("Detected after", "ms"),
        numbers("Isolated after", "ms"),
    ];
    let caption = html! {
        "Detection: " (detection(record.detection, record.detection_delay_s)) "; after a fault: " (record.after_fault)
        @if let Some(way) = &record.way_out { "; " (way.words()) }
    };
    let rows = html! {
        @for fault in &record.faults {
            tr {
                th scope="row" { (fault.mode) }
                td.n { (number(fault.at_s)) }
                td.n { (fault.until_s.map_or("never".into(), number)) }
                td.n { @if fault.struck { (after(fault.detected_after_s)) } @else { "not struck" } }
                td.n { @if fault.struck { (after(fault.isolated_after_s)) } @else { "not struck" } }
            }
        }
    };
    let frame = Frame { label: "Table of faults", class: Some("compact"), caption: Some(caption), ..Frame::default() };
    html! {
        h2 {
            @match struck(record).count() {
                0 => { "No fault strikes in this flight" }
                1 => { "1 fault strikes in this flight" }
                n => { (n) " faults strike in this flight" }
            }
        }
        (table(frame, &heads, rows))
    }
}
