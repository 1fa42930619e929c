//! The height that a fault without control of yaw costs: a chart over delays, and the table against which the plan was measured.

use super::document::Section;
use super::prose::unbroken;
use crate::flight::capture::Capture;
use crate::number::{fixed, number, significant};
use crate::report::capture_height::{CaptureRecord, ExposedRecord, worst};
use crate::report::record::Record;
use maud::{Markup, html};

/// Size of the chart, and its margins left, top, right and below, in the units of its view box.
const SIZE: [f64; 2] = [560.0, 330.0];
const MARGINS: [f64; 4] = [46.0, 14.0, 14.0, 46.0];

/// A colour for each mode, with a contrast of at least 3 on the paper of both themes, and dashes for each speed.
const COLORS: [&str; 2] = ["#2a7fc4", "#d55e00"];
const DASHES: [&str; 2] = ["none", "7 4"];

/// The section of a plan that was measured; `curves` are captures over delays, at rest and at the largest speed, in the order of the
/// modes, then by speed and delay.
pub fn section(record: &Record, curves: &[Capture]) -> Option<Section> {
    let captures = record.capture_height.as_ref()?;
    let exposed = record.planners.last().map_or(&[][..], |planner| &planner.exposed);
    let body = html! {
        h2 { (unbroken(&headline(captures, exposed))) }
        p.note {
            "After such a fault the vehicle gives up yaw and falls until it flies level again. The heights are simulated, not proved: "
            "another controller, or another course of events, may lose more or less."
        }
        div.pair {
            @if !curves.is_empty() { (figure(captures, curves)) }
            (table(captures, exposed))
        }
    };
    Some(Section::new("capture", "Capture height", body))
}

fn headline(captures: &CaptureRecord, exposed: &[ExposedRecord]) -> String {
    let known = format!("with the fault known after {} ms", number(1e3 * captures.delay_s));
    if captures.captures.iter().any(|case| heights(case).is_none()) {
        return format!("After some faults without control of yaw no height is known to be enough, {known}");
    }
    let greatest = captures.captures.iter().filter_map(|case| case.height_m).map(|[_, _, most]| most).fold(0.0, f64::max);
    let costs = format!("A fault without control of yaw costs up to {} m, {known}", significant(greatest, 3));
    match (captures.height_m, exposed.iter().reduce(|a, b| if b.seconds > a.seconds { b } else { a })) {
        (Some(height), _) => format!("{costs}; the plan keeps {} m outside of start and end", significant(height, 3)),
        (None, Some(worst)) => format!("{costs}; the plan is too low for {} s", significant(worst.seconds, 3)),
        (None, None) => format!("{costs}; the plan is never lower"),
    }
}

/// The heights at which a case counts: of the flights that all regained level flight.
fn heights(case: &Capture) -> Option<[f64; 3]> {
    case.height_m.filter(|_| case.regained == case.flights)
}

/// Where the chart draws a delay (s) and a height (m).
struct Scale {
    longest: f64,
    highest: f64,
    step: f64,
}

impl Scale {
    fn of(curves: &[Capture]) -> Self {
        let longest = curves.iter().map(|case| case.delay_s).fold(0.0, f64::max);
        let highest = curves.iter().filter_map(heights).map(|[_, _, most]| most).fold(0.1, f64::max);
        // Four to nine steps of 1, 2 or 5 times a power of ten.
        let rough = highest / 4.0;
        let power = 10f64.powf(rough.log10().floor());
        let step = [5.0, 2.0, 1.0].map(|f| f * power).into_iter().find(|step| *step <= rough).unwrap_or(power);
        Scale { longest, highest: (highest / step).ceil() * step, step }
    }

    fn x(&self, delay: f64) -> f64 {
        MARGINS[0] + (SIZE[0] - MARGINS[0] - MARGINS[2]) * delay / self.longest
    }

    fn y(&self, height: f64) -> f64 {
        SIZE[1] - MARGINS[3] - (SIZE[1] - MARGINS[1] - MARGINS[3]) * height / self.highest
    }

    fn points(&self, line: &[(f64, f64)]) -> String {
        let point = |(delay, height): &(f64, f64)| format!("{},{}", fixed(self.x(*delay), 1), fixed(self.y(*height), 1));
        line.iter().map(point).collect::<Vec<_>>().join(" ")
    }
}

fn figure(captures: &CaptureRecord, curves: &[Capture]) -> Markup {
    let scale = Scale::of(curves);
    let lines: Vec<&[Capture]> =
        curves.chunk_by(|a, b| a.mode == b.mode && a.speed_m_per_s == b.speed_m_per_s).collect();
    let modes: Vec<&str> = lines.chunk_by(|a, b| a[0].mode == b[0].mode).map(|of| of[0][0].mode.as_str()).collect();
    let color = |line: &[Capture]| {
        COLORS[modes.iter().position(|mode| *mode == line[0].mode).unwrap_or(0) % COLORS.len()]
    };
    let dash = |line: &[Capture]| if line[0].speed_m_per_s > 0.0 { DASHES[1] } else { DASHES[0] };
    let flights = curves.first().map_or(0, |case| case.flights);
    let [left, right] = [scale.x(0.0), scale.x(scale.longest)];
    let [bottom, top] = [scale.y(0.0), scale.y(scale.highest)];
    let heights_of_grid = (0..=(scale.highest / scale.step).round() as usize).map(|k| k as f64 * scale.step);
    let delays_of_grid: Vec<f64> = (0..=6).map(|k| scale.longest * f64::from(k) / 6.0).collect();
    let view = format!("0 0 {} {}", SIZE[0], SIZE[1]);
    html! {
        figure {
            div.legend {
                @for line in &lines {
                    span.entry {
                        svg width="26" height="10" aria-hidden="true" {
                            line x1="0" y1="5" x2="26" y2="5" stroke=(color(line)) stroke-width="2.5" stroke-dasharray=(dash(line)) { }
                        }
                        (line[0].mode) " at " (unbroken(&format!("{} m/s", significant(line[0].speed_m_per_s, 3))))
                    }
                }
            }
            svg viewBox=(view) width="100%" role="img" aria-label="Height lost against the delay until the fault is known, simulated" {
                @for height in heights_of_grid {
                    line x1=(left) x2=(right) y1=(fixed(scale.y(height), 1)) y2=(fixed(scale.y(height), 1)) stroke="var(--grid)" { }
                    text x=(left - 7.0) y=(fixed(scale.y(height) + 4.0, 1)) text-anchor="end" font-size="12" fill="var(--soft)" { (number(height)) }
                }
                @for delay in &delays_of_grid {
                    line x1=(fixed(scale.x(*delay), 1)) x2=(fixed(scale.x(*delay), 1)) y1=(top) y2=(bottom) stroke="var(--grid)" { }
                    text x=(fixed(scale.x(*delay), 1)) y=(bottom + 17.0) text-anchor="middle" font-size="12" fill="var(--soft)" { (number(1e3 * delay)) }
                }
                text x=(0.5 * (left + right)) y=(SIZE[1] - 8.0) text-anchor="middle" font-size="12" fill="var(--soft)" { "delay until the fault is known, ms" }
                text transform={ "rotate(-90) translate(" (-0.5 * (top + bottom)) " 12)" } text-anchor="middle" font-size="12" fill="var(--soft)" { "height lost, m" }
                @if captures.delay_s <= scale.longest {
                    line x1=(fixed(scale.x(captures.delay_s), 1)) x2=(fixed(scale.x(captures.delay_s), 1)) y1=(top) y2=(bottom) stroke="var(--soft)" stroke-dasharray="2 3" { }
                }
                @for line in &lines {
                    @for part in parts(line) {
                        @let spread: Vec<(f64, f64)> = part.iter().map(|(t, h)| (*t, h[0])).chain(part.iter().rev().map(|(t, h)| (*t, h[2]))).collect();
                        @let middle: Vec<(f64, f64)> = part.iter().map(|(t, h)| (*t, h[1])).collect();
                        polygon points=(scale.points(&spread)) fill=(color(line)) fill-opacity="0.22" stroke="none" { }
                        polyline points=(scale.points(&middle)) fill="none" stroke=(color(line)) stroke-width="2.2" stroke-dasharray=(dash(line)) { }
                        @for (delay, height) in &middle {
                            circle cx=(fixed(scale.x(*delay), 1)) cy=(fixed(scale.y(*height), 1)) r="2.6" fill=(color(line)) { }
                        }
                    }
                }
            }
            figcaption.note {
                "Simulated: the median of " (flights) " flights with different noise and gusts, and their range as a band. A line ends where not "
                "every flight regains level flight. The dotted line is the delay of the table."
                @if captures.captures.iter().any(|case| !modes.contains(&case.mode.as_str())) { " Modes that cost less are not drawn." }
            }
        }
    }
}

/// The pieces of a line without the delays after which not every flight regains level flight.
fn parts(line: &[Capture]) -> Vec<Vec<(f64, [f64; 3])>> {
    let pieces = line.chunk_by(|a, b| heights(a).is_some() == heights(b).is_some());
    let known = |piece: &[Capture]| -> Vec<(f64, [f64; 3])> {
        piece.iter().filter_map(|case| Some((case.delay_s, heights(case)?))).collect()
    };
    pieces.map(known).filter(|piece| !piece.is_empty()).collect()
}

fn table(captures: &CaptureRecord, exposed: &[ExposedRecord]) -> Markup {
    let modes: Vec<&[Capture]> = captures.captures.chunk_by(|a, b| a.mode == b.mode).collect();
    let of = |mode: &str| exposed.iter().find(|exposed| exposed.mode == mode);
    let dash = "\u{2013}";
    html! {
        div.scroll tabindex="0" role="region" aria-label="Table of heights" {
            table {
                caption { span { "The most that a flight lost, m, " (unbroken(&captures.headline())) } }
                thead {
                    tr {
                        th scope="col" { "Mode" }
                        @for case in modes.first().map_or(&[][..], |of| of) {
                            th.n scope="col" { "At" br; span.unit { (unbroken(&format!("{} m/s", significant(case.speed_m_per_s, 3)))) } }
                        }
                        th.n scope="col" { "Too low" br; span.unit { "s" } }
                        th.n scope="col" { "By up to" br; span.unit { "m" } }
                        th.n scope="col" { "At" br; span.unit { "s" } }
                    }
                }
                tbody {
                    @for of_mode in &modes {
                        tr {
                            th scope="row" { (of_mode[0].mode) }
                            @for case in *of_mode { td.n { (worst(case)) } }
                            @match of(&of_mode[0].mode) {
                                Some(found) => {
                                    td.n { (significant(found.seconds, 3)) }
                                    td.n { (found.short_m.map_or(dash.into(), |short| significant(short, 3))) }
                                    td.n { (fixed(found.short_at_s, 2)) }
                                }
                                None => { td.n { "0" } td.n { (dash) } td.n { (dash) } }
                            }
                        }
                    }
                }
            }
            @if captures.modes_left_out > 0 { p.note { (captures.modes_left_out) " more modes were not simulated." } }
        }
    }
}
