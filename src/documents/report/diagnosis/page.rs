//! The page of `mavc diagnose --html`: the answer, and curves of the flight as drawings within the page, without a
//! script.

use super::{Diagnosis, screen};
use crate::actuation::Actuation;
use crate::admissible::AdmissibleSet;
use crate::diagnosis::record::{Commands, Record};
use crate::number::{fixed, number};
use crate::report::page::outline::{Point, clipped};
use maud::{DOCTYPE, Markup, html};
use std::fmt::Write;

const STYLE: &str = "body{font:16px/1.5 sans-serif;max-width:64rem;margin:2rem auto;padding:0 1rem}\
                     pre{white-space:pre-wrap}svg{max-width:100%;height:auto}figure{margin:1.5rem 0}\
                     figcaption{font-weight:bold}";
/// The page loads nothing, and runs no script.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";
/// Okabe and Ito's colours, which colour-blind people can distinguish; the second time dashed.
const COLORS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#787878"];
/// Size of a drawing, and the room of its axes.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 260.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 150.0;
const BELOW: f64 = 40.0;
const ABOVE: f64 = 10.0;
/// Instants of a curve: more than a screen has points across.
const INSTANTS: usize = 1000;
/// What is shown before and after a loss, s.
const AROUND: [f64; 2] = [1.5, 2.5];
/// Whose commands are compared with the sets, s before and after a loss.
const COMPARED: f64 = 1.0;
/// Values of a series are joined over gaps up to this, s.
const GAP: f64 = 1.0;
/// Half of the side of the square from which a section is cut, and half of the thickness of a flat one, in widths of
/// the healthy vehicle's section.
const SQUARE: f64 = 2.0;
const FLAT: f64 = 0.004;

/// A curve: its name, and its value (NaN: none) at each instant.
struct Curve {
    name: String,
    values: Vec<f64>,
}

/// The page of a log with a name. `commands` are those of the record's outputs.
pub fn page(name: &str, diagnosis: &Diagnosis, record: &Record, commands: &Commands) -> String {
    let title = format!("Diagnosis of {name}");
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { (title) }
                style { (maud::PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                pre { (screen(diagnosis).to_string()) }
                @if let Some((from, to)) = in_air(diagnosis) {
                    h2 { "The flight" }
                    (curves(diagnosis, record, commands, [from - 1.0, to + 1.0]))
                    (figure("Thrust for its command", &capacities(diagnosis, [from, to])))
                    p {
                        "Until its first loss a motor has the thrust of quiet flight, relative to the strongest; then \
                         the share that is left. Shaded: 95 % intervals."
                    }
                }
                @for (k, loss) in diagnosis.losses().iter().enumerate() {
                    h2 { "Around the loss of motor " (loss.motor + 1) " at " (fixed(loss.time, 2)) " s" }
                    (curves(diagnosis, record, commands, [loss.time - AROUND[0], loss.time + AROUND[1]]))
                    (sections(diagnosis, record, commands, k))
                }
            }
        }
    };
    markup.into_string() + "\n"
}

/// From the first take-off to the last end, s.
fn in_air(diagnosis: &Diagnosis) -> Option<(f64, f64)> {
    let flights = &diagnosis.study.as_ref()?.flights;
    Some((flights.first()?.from, flights.last()?.to))
}

fn figure(title: &str, drawing: &Markup) -> Markup {
    html! { figure { figcaption { (title) } (drawing) } }
}

/// Commands, attitude, rates and height over a range of time, s.
fn curves(diagnosis: &Diagnosis, record: &Record, commands: &Commands, range: [f64; 2]) -> Markup {
    let times: Vec<f64> =
        (0..INSTANTS).map(|k| range[0] + (range[1] - range[0]) * k as f64 / (INSTANTS - 1) as f64).collect();
    let marks: Vec<f64> = diagnosis.losses().iter().map(|loss| loss.time).collect();
    let curve = |name: &str, value: &dyn Fn(f64) -> Option<f64>| Curve {
        name: name.into(),
        values: times.iter().map(|t| value(*t).unwrap_or(f64::NAN)).collect(),
    };
    let outputs = &record.outputs.times;
    // The last output before an instant.
    let row = |t: f64| outputs.partition_point(|x| *x <= t).checked_sub(1).filter(|row| t - outputs[*row] < GAP);
    let motors: Vec<Curve> = (0..diagnosis.motors.len())
        .map(|motor| curve(&format!("motor {}", motor + 1), &|t| row(t).map(|row| 100.0 * commands(row, motor).0)))
        .collect();
    let of = |names: [&str; 3], value: &dyn Fn(f64, usize) -> Option<f64>| -> Vec<Curve> {
        names.iter().enumerate().map(|(axis, name)| curve(name, &|t| value(t, axis).map(f64::to_degrees))).collect()
    };
    let attitude = of(["roll", "pitch", "yaw"], &|t, axis| record.attitude.at(t, GAP).map(|a| a[axis]));
    let rates = of(["roll", "pitch", "yaw"], &|t, axis| record.rates.at(t, GAP).map(|w| w[axis]));
    let height = [curve("height", &|t| record.height.at(t, GAP).map(|h| h[0]))];
    let drawn = |title: &str, curves: &[Curve]| {
        let is_empty = curves.iter().all(|curve| curve.values.iter().all(|v| v.is_nan()));
        (!is_empty).then(|| figure(title, &plot(&times, curves, &[], &marks)))
    };
    html! {
        @for figure in [
            drawn("Commands, % of full thrust", &motors),
            drawn("Attitude, degrees (forward, left, up)", &attitude),
            drawn("Rates of turn, degrees/s", &rates),
            drawn("Height, m", &height),
        ].into_iter().flatten() { (figure) }
    }
}

/// The capacity of each motor over the flight, with its interval.
fn capacities(diagnosis: &Diagnosis, [from, to]: [f64; 2]) -> Markup {
    let marks: Vec<f64> = diagnosis.losses().iter().map(|loss| loss.time).collect();
    // The ends of the flight and both sides of every loss.
    let mut times: Vec<f64> = [from, to].into_iter().chain(marks.iter().flat_map(|t| [*t - 1e-6, *t])).collect();
    times.sort_by(f64::total_cmp);
    let quiet = diagnosis.study.as_ref().and_then(|study| study.capacities.as_ref());
    let of = |motor: usize, t: f64| -> Option<[f64; 3]> {
        match diagnosis.losses().iter().rfind(|loss| loss.motor == motor && loss.time <= t) {
            Some(loss) => Some([loss.capacity, loss.capacity_interval[0], loss.capacity_interval[1]]),
            None => quiet.map(|quiet| [quiet[motor].value, quiet[motor].low, quiet[motor].high]),
        }
    };
    let part =
        |motor: usize, k: usize| times.iter().map(|t| of(motor, *t).map_or(f64::NAN, |c| 100.0 * c[k])).collect();
    let motors = 0..diagnosis.motors.len();
    let curves: Vec<Curve> =
        motors.clone().map(|motor| Curve { name: format!("motor {}", motor + 1), values: part(motor, 0) }).collect();
    let bands: Vec<[Vec<f64>; 2]> = motors.map(|motor| [part(motor, 1), part(motor, 2)]).collect();
    plot(&times, &curves, &bands, &marks)
}

/// Round numbers from the least to the greatest, about five.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let rough = (high - low) / 5.0;
    let power = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|n| n * power).find(|step| *step >= rough).unwrap_or(rough);
    let first = (low / step).ceil() as i64;
    (first..).map(|k| k as f64 * step).take_while(|x| *x <= high + 1e-9 * step).take(12).collect()
}

/// Ends of an axis that has room for some values.
fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values
        .filter(|v| v.is_finite())
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [f64::min(low, v), f64::max(high, v)]);
    if low > high {
        return [0.0, 1.0];
    }
    let room = (0.05 * (high - low)).max(1e-3 * high.abs().max(1.0));
    [low - room, high + room]
}

/// Curves over time with bands below them, and marks at the times of losses.
fn plot(times: &[f64], curves: &[Curve], bands: &[[Vec<f64>; 2]], marks: &[f64]) -> Markup {
    let (Some(from), Some(to)) = (times.first(), times.last()) else { return html! {} };
    let all = curves.iter().flat_map(|curve| &curve.values).chain(bands.iter().flatten().flatten());
    let [low, high] = ends(all.copied());
    let x = |t: f64| LEFT + (t - from) / (to - from) * (WIDTH - LEFT - RIGHT);
    let y = |v: f64| HEIGHT - BELOW - (v - low) / (high - low) * (HEIGHT - BELOW - ABOVE);
    let line = |values: &[f64]| {
        let mut path = String::new();
        let mut is_open = false;
        for (t, v) in times.iter().zip(values) {
            if v.is_finite() {
                let _ = write!(path, "{}{:.1} {:.1}", if is_open { 'L' } else { 'M' }, x(*t), y(*v));
            }
            is_open = v.is_finite();
        }
        path
    };
    let area = |[low, high]: &[Vec<f64>; 2]| {
        let there = times.iter().zip(high).map(|(t, v)| (*t, *v));
        let back = times.iter().zip(low).map(|(t, v)| (*t, *v)).rev();
        let points = there.chain(back).filter(|(_, v)| v.is_finite());
        points.fold(String::new(), |mut out, (t, v)| {
            let _ = write!(out, "{:.1},{:.1} ", x(t), y(v));
            out
        })
    };
    let dash = |k: usize| if k < COLORS.len() { "none" } else { "7 4" };
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BELOW);
    html! {
        svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) width=(WIDTH) height=(HEIGHT)
            font-family="sans-serif" font-size="13" role="img" {
            @for v in ticks(low, high) {
                path d=(format!("M{LEFT} {0:.1}H{right}", y(v))) stroke="#e1e4e8" {}
                text x=(LEFT - 6.0) y=(format!("{:.1}", y(v) + 4.0)) text-anchor="end" { (number(v)) }
            }
            @for t in ticks(*from, *to) {
                path d=(format!("M{0:.1} {ABOVE}V{bottom}", x(t))) stroke="#e1e4e8" {}
                text x=(format!("{:.1}", x(t))) y=(bottom + 18.0) text-anchor="middle" { (number(t)) }
            }
            text x=(right) y=(bottom + 34.0) text-anchor="end" { "time, s" }
            @for (k, band) in bands.iter().enumerate() {
                polygon points=(area(band)) fill=(COLORS[k % COLORS.len()]) fill-opacity="0.15" {}
            }
            @for (k, curve) in curves.iter().enumerate() {
                path d=(line(&curve.values)) fill="none" stroke=(COLORS[k % COLORS.len()])
                    stroke-width="1.6" stroke-dasharray=(dash(k)) {}
                @let at = ABOVE + 12.0 + 15.0 * k as f64;
                path d=(format!("M{} {}h26", right + 12.0, at - 4.0)) stroke=(COLORS[k % COLORS.len()])
                    stroke-width="2.5" stroke-dasharray=(dash(k)) {}
                text x=(right + 44.0) y=(at) { (curve.name) }
            }
            @for mark in marks.iter().filter(|t| *t >= from && *t <= to) {
                path d=(format!("M{0:.1} {ABOVE}V{bottom}", x(*mark))) stroke="#b3261e" stroke-dasharray="5 4" {}
            }
        }
    }
}

/// Roll and pitch torques at hover thrust without a yaw torque that the vehicle can give before and after loss `k`, and
/// those that were commanded just before and after.
fn sections(diagnosis: &Diagnosis, record: &Record, commands: &Commands, k: usize) -> Markup {
    let actuation = Actuation::of(&diagnosis.model.vehicle);
    let healthy = AdmissibleSet::healthy(&diagnosis.model);
    // Half of the healthy vehicle's greatest torques.
    let scale: [f64; 2] = std::array::from_fn(|axis| {
        let span: f64 = healthy.zonotope.generators.iter().map(|g| g[axis + 1].abs()).sum();
        0.5 * span
    });
    let square: Vec<Point> =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|corner: Point| corner.map(|x| SQUARE * x)).into();
    let section = |set: &AdmissibleSet| {
        let mut polygon = square.clone();
        let mut cut = |normal: &crate::actuation::Wrench, offset: f64| {
            let [a, b] = [normal[1] * scale[0], normal[2] * scale[1]];
            let rest = normal[0] * set.hover[0] - offset;
            polygon = clipped(&polygon, |p| a * p[0] + b * p[1] + rest);
        };
        for facet in &set.polytope.facets {
            cut(&facet.normal, facet.offset);
        }
        for flat in &set.polytope.equalities {
            let size = FLAT * (flat.normal[1] * scale[0]).hypot(flat.normal[2] * scale[1]).max(1e-12);
            cut(&flat.normal, flat.offset + size);
            cut(&-flat.normal, size - flat.offset);
        }
        polygon
    };
    let loss = &diagnosis.losses()[k];
    let asked = |from: f64, to: f64| -> Vec<Point> {
        let [a, b] = [from, to].map(|t| record.outputs.times.partition_point(|x| *x < t));
        let every = (b.saturating_sub(a)).div_ceil(200).max(1);
        (a..b)
            .step_by(every)
            .map(|row| {
                let mut torque = [0.0; 2];
                for (rotor, motor) in diagnosis.motors.iter().enumerate() {
                    let full = actuation.full(rotor);
                    (0..2).for_each(|axis| torque[axis] += commands(row, *motor).0 * full[axis + 1]);
                }
                [torque[0] / scale[0], torque[1] / scale[1]]
            })
            .collect()
    };
    let before = k.checked_sub(1).map_or_else(|| healthy.clone(), |k| diagnosis.sets[k].clone());
    let after = diagnosis.sets[k].clone();
    let pair = [
        ("before", section(&before), asked(loss.time - COMPARED, loss.time)),
        ("after", section(&after), asked(loss.time, loss.time + COMPARED)),
    ];
    html! {
        figure {
            figcaption { "Roll and pitch torques at the thrust of hover, without a yaw torque" }
            @for (name, polygon, points) in &pair { (square_plot(name, polygon, points)) }
        }
        p {
            "Area: what the vehicle can give with the losses until then, in shares of the healthy vehicle's greatest \
             torques. Points: what the autopilot commanded, as if every motor followed, within " (fixed(COMPARED, 0))
            " s of the loss. Where the area does not hold the origin, no controller keeps height, attitude and heading."
        }
    }
}

fn square_plot(name: &str, polygon: &[Point], points: &[Point]) -> Markup {
    let side = 320.0;
    let place = |p: &Point| [0.5 * side * (1.0 + p[0] / 1.2), 0.5 * side * (1.0 - p[1] / 1.2)];
    let corners = polygon.iter().map(place).fold(String::new(), |mut out, [x, y]| {
        let _ = write!(out, "{x:.1},{y:.1} ");
        out
    });
    let middle = 0.5 * side;
    html! {
        svg viewBox=(format!("0 0 {side} {}", side + 24.0)) width=(side) height=(side + 24.0)
            font-family="sans-serif" font-size="13" role="img" {
            rect width=(side) height=(side) fill="none" stroke="#bbb" {}
            path d=(format!("M0 {middle}H{side}M{middle} 0V{side}")) stroke="#e1e4e8" {}
            polygon points=(corners) fill="#0072b2" fill-opacity="0.2" stroke="#0072b2" {}
            @for [x, y] in points.iter().map(place).filter(|p| p.iter().all(|x| (0.0..=side).contains(x))) {
                circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r="2" fill="#d55e00" {}
            }
            text x=(middle) y=(side + 17.0) text-anchor="middle" {
                (name) @if polygon.is_empty() { ": nothing" }
            }
        }
    }
}
