//! The page's charts and sections as SVG files (`--svg`), for publications.

use super::chart::{Bound, Chart};
use super::content::{Content, RunContent};
use super::sets::SetContent;
use crate::number::number;
use crate::source::visible;
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;

/// Size in the backend's units; its coordinates are integers, so the drawing is large.
const SIZE: (u32, u32) = (2000, 1150);
const SQUARE: (u32, u32) = (1400, 1350);
const TEXT: u32 = 46;
const MARGIN: u32 = 50;
/// Height of the horizontal axis with its label.
const BELOW: u32 = 130;
/// Width of the vertical axis with one line of its label.
const BESIDE: u32 = 190;
/// From one line of text to the next.
const LINE: u32 = 60;
/// Width of a letter, also in wide fonts: the font depends on the reader's machine.
const LETTER: u32 = 24;
/// Width of a legend's sample with the gap after it.
const SAMPLE: i32 = 110;

/// Okabe and Ito's colours, which colour-blind people can distinguish.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(120, 120, 120),
];
/// Dashes of the lines, each with the gap after it: colours cannot be distinguished on every print.
const DASHES: [Option<Dash>; 8] = [
    None,
    Some((40, 14)),
    Some((18, 12)),
    Some((7, 12)),
    Some((60, 12)),
    Some((34, 28)),
    Some((18, 28)),
    Some((7, 22)),
];
/// Dashes of limits and reference levels.
const LEVEL: Dash = (24, 14);
const LIMIT: RGBColor = RGBColor(179, 38, 30);
const GRID: RGBColor = RGBColor(225, 228, 232);

type Drawn = Result<String, String>;
type Dash = (i32, i32);
type Failure = DrawingAreaErrorKind<std::io::Error>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Context<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// File names and texts: for every plan that is drawn, its charts and each set's section at hover with its path; only the
/// sections if there is no plan.
///
/// # Errors
/// The drawing library's message if it cannot draw.
pub fn files(content: &Content) -> Result<Vec<(String, String)>, String> {
    let mut drawn: Vec<(Option<&RunContent>, &str)> =
        content.runs.iter().filter_map(|run| Some((Some(run), run.figures.as_deref()?))).collect();
    if drawn.is_empty() {
        drawn.push((None, ""));
    }
    let mut files = Vec::new();
    for (run, plan) in drawn {
        for (run, chart) in run.iter().flat_map(|run| run.charts.iter().map(move |chart| (run, chart))) {
            files.push((format!("{}{plan}.svg", chart.id.replace('_', "-")), curves(run, chart)?));
        }
        for set in content.sets.iter().filter(|s| s.equalities.is_empty()) {
            files.push((format!("set-{}{plan}.svg", set.name), section(content, set, run)?));
        }
    }
    for (name, text) in &mut files {
        *text = visible::text(text).into_owned();
        *name = name.chars().map(|c| if c.is_alphanumeric() || "_-.".contains(c) { c } else { '-' }).collect();
    }
    Ok(files)
}

/// An entry of a legend with its sample.
struct Entry {
    label: String,
    sample: Sample,
}

#[derive(Clone, Copy)]
enum Sample {
    Line(ShapeStyle, Option<Dash>),
    /// A filled area with its edge: colour, and the share of it that fills.
    Area(RGBColor, f64),
    Cross,
}

impl Sample {
    /// Draws it from `x` on, in the middle of a line of text whose top is at `y`.
    fn draw(self, area: &Area, (x, y): (i32, i32)) -> Result<(), Failure> {
        let end = x + SAMPLE - 20;
        let middle = y + LINE as i32 / 2;
        match self {
            Sample::Line(style, None) => area.draw(&PathElement::new([(x, middle), (end, middle)], style)),
            Sample::Line(style, Some((dash, gap))) => {
                area.draw(&DashedPathElement::new([(x, middle), (end, middle)], dash, gap, style))
            }
            Sample::Area(color, share) => {
                let (top, bottom) = (middle - 16, middle + 16);
                area.draw(&Rectangle::new([(x, top), (end, bottom)], color.mix(share).filled()))?;
                // The edge of a rectangle has no width in the library.
                let edge = [(x, top), (end, top), (end, bottom), (x, bottom), (x, top)];
                area.draw(&PathElement::new(edge, color.stroke_width(5)))
            }
            Sample::Cross => area.draw(&Cross::new(((x + end) / 2, middle), 16, BLACK.stroke_width(4))),
        }
    }
}

/// Positions of a legend's entries, row by row within a width, and the height of the legend.
fn placed(entries: &[Entry], width: u32) -> (Vec<(i32, i32)>, u32) {
    let (left, right) = ((MARGIN + BESIDE) as i32, (width - MARGIN) as i32);
    let mut at = (left, MARGIN as i32);
    let mut places = Vec::new();
    for entry in entries {
        let wide = SAMPLE + LETTER as i32 * entry.label.chars().count() as i32;
        if at.0 > left && at.0 + wide > right {
            at = (left, at.1 + LINE as i32);
        }
        places.push(at);
        at.0 += wide + 30;
    }
    let height = places.last().map_or(0, |last| last.1 as u32 + LINE);
    (places, height)
}

/// An empty chart over the given ranges, drawn on by `work`, below a legend of `entries`.
fn chart(
    size: (u32, u32),
    (x, y): (Range<f64>, Range<f64>),
    (across, up): (&str, &str),
    entries: &[Entry],
    work: impl FnOnce(&mut Context) -> Result<(), Failure>,
) -> Drawn {
    let mut text = String::new();
    let (places, height) = placed(entries, size.0);
    let tall = size.1 - 2 * MARGIN - BELOW;
    let up = textwrap::wrap(up, (tall / LETTER) as usize);
    let draw = |text: &mut String| {
        let whole = SVGBackend::with_string(text, (size.0, size.1 + height)).into_drawing_area();
        whole.fill(&WHITE)?;
        let font = ("sans-serif", TEXT).into_text_style(&whole);
        let beside = font.pos(Pos::new(HPos::Left, VPos::Center));
        for (entry, &(x, y)) in entries.iter().zip(&places) {
            entry.sample.draw(&whole, (x, y))?;
            whole.draw(&Text::new(entry.label.as_str(), (x + SAMPLE, y + LINE as i32 / 2), beside.clone()))?;
        }
        let (_, area) = whole.split_vertically(height);
        // The library's own label of this axis is a single line and is cut off if it is too long.
        let upwards = font.transform(FontTransform::Rotate270).pos(Pos::new(HPos::Center, VPos::Top));
        for (line, x) in up.iter().zip((MARGIN..).step_by(LINE as usize)) {
            area.draw(&Text::new(line.as_ref(), (x as i32, (MARGIN + tall / 2) as i32), upwards.clone()))?;
        }
        let mut chart = ChartBuilder::on(&area)
            .margin(MARGIN)
            .x_label_area_size(BELOW)
            .y_label_area_size(BESIDE + LINE * (up.len() as u32 - 1))
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID.stroke_width(2))
            .axis_style(BLACK.stroke_width(3))
            .label_style(("sans-serif", TEXT))
            .axis_desc_style(("sans-serif", TEXT))
            .x_desc(across)
            .draw()?;
        work(&mut chart)?;
        whole.present()
    };
    draw(&mut text).map_err(|e| e.to_string())?;
    Ok(text)
}

fn curves(run: &RunContent, spec: &Chart) -> Drawn {
    let times = run.columns.get("t").map_or(&[][..], Vec::as_slice);
    let line = |column: &str| run.columns.get(column).map_or(&[][..], Vec::as_slice);
    let values = spec.lines.iter().flat_map(|l| line(&l.column)).copied();
    let drawn = range(values);
    let span = drawn.end - drawn.start;
    // Limits far from the curves would flatten them.
    let near = |v: &f64| (drawn.start - span..drawn.end + span).contains(v);
    let bounds: Vec<_> = spec.bounds.iter().filter(|b| near(&b.value)).collect();
    let y = padded(range(bounds.iter().map(|b| b.value).chain([drawn.start, drawn.end])));
    let end = times.last().copied().unwrap_or(1.0);
    let up = format!("{} [{}]", spec.title, spec.unit);
    let style = |i: usize| (COLORS[i % COLORS.len()].stroke_width(5), DASHES[i % DASHES.len()]);
    let level = |b: &Bound| if b.is_reference { COLORS[7] } else { LIMIT }.stroke_width(3);
    let mut entries = Vec::new();
    if spec.lines.len() > 1 {
        entries.extend(spec.lines.iter().enumerate().map(|(i, curve)| {
            let (style, dash) = style(i);
            Entry { label: curve.label.clone(), sample: Sample::Line(style, dash) }
        }));
    }
    for bound in &bounds {
        let label = format!("{} {} {}", bound.label, number(bound.value), spec.unit);
        entries.push(Entry { label, sample: Sample::Line(level(bound), Some(LEVEL)) });
    }
    chart(SIZE, (0.0..end, y), ("time [s]", &up), &entries, |chart| {
        for (i, curve) in spec.lines.iter().enumerate() {
            let points = times.iter().copied().zip(line(&curve.column).iter().copied()).filter(|p| p.1.is_finite());
            match style(i) {
                (style, None) => chart.draw_series(LineSeries::new(points, style))?,
                (style, Some((dash, gap))) => chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?,
            };
        }
        for bound in bounds {
            let ends = [(0.0, bound.value), (end, bound.value)];
            chart.draw_series(DashedLineSeries::new(ends, LEVEL.0, LEVEL.1, level(bound)))?;
        }
        Ok(())
    })
}

/// Torques about x and y at hover, as the paper's Figures 7 to 9, with those of the plan.
fn section(content: &Content, set: &SetContent, run: Option<&RunContent>) -> Drawn {
    let healthy = content.sets.first().unwrap_or(set);
    let [_, x, y, _] = content.extents;
    // Equal scales.
    let reach = 1.08 * [x, y].as_flattened().iter().fold(0.0_f64, |m, v| m.max(v.abs())).max(1e-9);
    let column = |name: &str| run.and_then(|r| r.columns.get(name)).map_or(&[][..], Vec::as_slice).iter().copied();
    let mut areas = vec![(healthy, COLORS[7], 0.12), (set, COLORS[0], 0.2)];
    // The healthy set is listed once.
    areas.dedup_by_key(|(set, ..)| &set.name);
    let mut entries: Vec<Entry> = areas
        .iter()
        .map(|(set, color, share)| Entry { label: set.name.clone(), sample: Sample::Area(*color, *share) })
        .collect();
    let path = BLACK.mix(0.6).stroke_width(3);
    entries.extend(run.map(|run| Entry { label: run.wrench.into(), sample: Sample::Line(path, None) }));
    entries.push(Entry { label: "hover".into(), sample: Sample::Cross });
    chart(SQUARE, (-reach..reach, -reach..reach), ("torque about x [N m]", "torque about y [N m]"), &entries, |chart| {
        for (set, color, share) in areas {
            let corners = corners(set, &content.hover, reach);
            if corners.len() < 3 {
                continue;
            }
            let closed = corners.iter().chain(corners.first()).copied().collect::<Vec<_>>();
            chart.draw_series([Polygon::new(corners.clone(), color.mix(share))])?;
            chart.draw_series([PathElement::new(closed, color.stroke_width(5))])?;
        }
        let points = column("tau_x").zip(column("tau_y"));
        chart.draw_series(LineSeries::new(points, path))?;
        chart.draw_series([Cross::new((0.0, 0.0), 16, BLACK.stroke_width(4))])?;
        Ok(())
    })
}

/// The section of a set through hover along the torques about x and y, by clipping a square with every row (Sutherland and
/// Hodgman).
fn corners(set: &SetContent, hover: &[f64; 4], reach: f64) -> Vec<(f64, f64)> {
    let square = vec![(-reach, -reach), (reach, -reach), (reach, reach), (-reach, reach)];
    set.rows.iter().fold(square, |polygon, row| {
        let bound = row[4] - row[0] * hover[0] - row[3] * hover[3];
        let over = |p: (f64, f64)| row[1] * p.0 + row[2] * p.1 - bound;
        let next = polygon.iter().cycle().skip(1);
        let sides = polygon.iter().zip(next).map(|(&p, &q)| (p, q, over(p), over(q)));
        sides
            .flat_map(|(p, q, a, b)| {
                let t = a / (a - b);
                let cut = ((a < 0.0) != (b < 0.0)).then_some((p.0 + t * (q.0 - p.0), p.1 + t * (q.1 - p.1)));
                (a <= 0.0).then_some(p).into_iter().chain(cut)
            })
            .collect()
    })
}

fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let ends =
        values.filter(|v| v.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |e, v| (e.0.min(v), e.1.max(v)));
    if ends.0 > ends.1 { 0.0..1.0 } else { ends.0..ends.1 }
}

fn padded(range: Range<f64>) -> Range<f64> {
    let room = 0.06 * (range.end - range.start).max(1e-9);
    range.start - room..range.end + room
}
