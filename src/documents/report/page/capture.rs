//! The height that a fault without control of yaw costs: a chart over delays, and the table against which the plan was
//! measured.

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

/// The section of a plan that was measured; `curves` are captures over delays, at rest and at the largest speed, in the
/// order of the modes, then by speed and delay.
pub fn section(record: &Record, curves: &[Capture]) -> Option<Section> {
    let captures = record.capture_height.as_ref()?;
    let exposed = record.planners.last().map_or(&[][..], |planner| &planner.exposed);
    let body = html! {
        h2 { (unbroken(&headline(captures, exposed))) }
        p.note {
            "After such a fault the vehicle gives up yaw and falls until it flies level again. The heights are \
             simulated, not proved: another controller, or another course of events, may lose more or less."
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
    let greatest =
        captures.captures.iter().filter_map(|case| case.height_m).map(|[_, _, most]| most).fold(0.0, f64::max);
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
        let point =
            |(delay, height): &(f64, f64)| format!("{},{}", fixed(self.x(*delay), 1), fixed(self.y(*height), 1));
        line.iter().map(point).collect::<Vec<_>>().join(" ")
    }
}

/// One curve: a mode at a speed, over delays.
struct Curve<'a> {
    cases: &'a [Capture],
    color: &'static str,
    dash: &'static str,
}

fn figure(captures: &CaptureRecord, drawn: &[Capture]) -> Markup {
    let scale = Scale::of(drawn);
    let of: Vec<&[Capture]> = drawn.chunk_by(|a, b| a.mode == b.mode && a.speed_m_per_s == b.speed_m_per_s).collect();
    let modes: Vec<&str> = of.chunk_by(|a, b| a[0].mode == b[0].mode).map(|of| of[0][0].mode.as_str()).collect();
    let curve = |cases: &&'_ [Capture]| {
        let mode = modes.iter().position(|mode| *mode == cases[0].mode).unwrap_or(0);
        (COLORS[mode % COLORS.len()], DASHES[usize::from(cases[0].speed_m_per_s > 0.0)])
    };
    let curves: Vec<Curve> = of
        .iter()
        .map(|cases| {
            let (color, dash) = curve(cases);
            Curve { cases, color, dash }
        })
        .collect();
    let flights = drawn.first().map_or(0, |case| case.flights);
    html! {
        figure {
            div.legend { @for curve in &curves { (curve.entry()) } }
            svg viewBox={ "0 0 " (SIZE[0]) " " (SIZE[1]) } width="100%" role="img" aria-label="Height lost against \
                the delay until the fault is known, simulated" {
                (scale.axes())
                @if captures.delay_s <= scale.longest { (scale.upright(captures.delay_s, "var(--soft)", "2 3")) }
                @for curve in &curves { (curve.draw(&scale)) }
            }
            figcaption.note {
                "Simulated: the median of " (flights) " flights with different noise and gusts, and their range as a \
                 band. A line ends where not every flight regains level flight. The dotted line is the delay of the \
                 table."
                @if captures.captures.iter().any(|case| !modes.contains(&case.mode.as_str())) { " Modes that cost \
                    less are not drawn." }
            }
        }
    }
}

impl Scale {
    /// A vertical line at a delay.
    fn upright(&self, delay: f64, stroke: &str, dash: &str) -> Markup {
        let x = fixed(self.x(delay), 1);
        let (top, bottom) = (self.y(self.highest), self.y(0.0));
        html! { line x1=(x) x2=(x) y1=(top) y2=(bottom) stroke=(stroke) stroke-dasharray=(dash) { } }
    }

    /// Grid, numbers and names of both axes.
    fn axes(&self) -> Markup {
        let [left, right] = [self.x(0.0), self.x(self.longest)];
        let [bottom, top] = [self.y(0.0), self.y(self.highest)];
        let heights = (0..=(self.highest / self.step).round() as usize).map(|k| k as f64 * self.step);
        let delays = (0..=6).map(|k| self.longest * f64::from(k) / 6.0);
        let words = |x: f64, y: f64, anchor: &str, text: &str| {
            let [x, y] = [x, y].map(|place| fixed(place, 1));
            html! { text x=(x) y=(y) text-anchor=(anchor) font-size="12" fill="var(--soft)" { (text) } }
        };
        let turned = format!("rotate(-90) translate({} 12)", fixed(-0.5 * (top + bottom), 1));
        html! {
            @for height in heights {
                @let y = fixed(self.y(height), 1);
                line x1=(left) x2=(right) y1=(y) y2=(y) stroke="var(--grid)" { }
                (words(left - 7.0, self.y(height) + 4.0, "end", &number(height)))
            }
            @for delay in delays {
                (self.upright(delay, "var(--grid)", "none"))
                (words(self.x(delay), bottom + 17.0, "middle", &number(1e3 * delay)))
            }
            (words(0.5 * (left + right), SIZE[1] - 8.0, "middle", "delay until the fault is known, ms"))
            g transform=(turned) { (words(0.0, 0.0, "middle", "height lost, m")) }
        }
    }
}

impl Curve<'_> {
    /// Its entry of the legend.
    fn entry(&self) -> Markup {
        let Capture { mode, speed_m_per_s, .. } = &self.cases[0];
        html! {
            span.entry {
                svg width="26" height="10" aria-hidden="true" {
                    line x1="0" y1="5" x2="26" y2="5" stroke=(self.color) stroke-width="2.5"
                        stroke-dasharray=(self.dash) { }
                }
                (mode) " at " (unbroken(&format!("{} m/s", significant(*speed_m_per_s, 3))))
            }
        }
    }

    /// The median as a line, and the range as a band.
    fn draw(&self, scale: &Scale) -> Markup {
        let of = |part: &[(f64, [f64; 3])], which: usize| -> Vec<(f64, f64)> {
            part.iter().map(|(delay, heights)| (*delay, heights[which])).collect()
        };
        html! {
            @for part in parts(self.cases) {
                @let spread: Vec<(f64, f64)> = of(&part, 0).into_iter().chain(of(&part, 2).into_iter().rev()).collect();
                polygon points=(scale.points(&spread)) fill=(self.color) fill-opacity="0.22" stroke="none" { }
                polyline points=(scale.points(&of(&part, 1))) fill="none" stroke=(self.color) stroke-width="2.2"
                    stroke-dasharray=(self.dash) { }
                @for (delay, height) in of(&part, 1) {
                    circle cx=(fixed(scale.x(delay), 1)) cy=(fixed(scale.y(height), 1)) r="2.6" fill=(self.color) { }
                }
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
                            @let speed = format!("{} m/s", significant(case.speed_m_per_s, 3));
                            th.n scope="col" { "At" br; span.unit { (unbroken(&speed)) } }
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
