//! The page's charts and sections as SVG files (`--svg`), for publications.

use super::chart::{Bound, Chart};
use super::content::{Content, RunContent};
use super::outline::{Outline, View, clipped};
use super::sets::SetContent;
use super::volumes::VolumeContent;
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

/// File names and texts. For every plan there are its charts, the section of each set at hover with the path of the
/// wrench, and, if the mission has volumes, the flight path from above and from the side. Without a plan there are only
/// the sections.
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
        for (name, view) in [("path-above", View::Above), ("path-side", View::Side)] {
            if let Some(run) = run.filter(|_| !content.volumes.is_empty()) {
                files.push((format!("{name}{plan}.svg"), path(content, run, view)?));
            }
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
    Circle,
    Diamond,
}

impl Sample {
    /// Draws it from `x` on, in the middle of a line of text whose top is at `y`.
    fn draw(self, area: &Area, x: i32, y: i32) -> Result<(), Failure> {
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
            Sample::Circle => area.draw(&Circle::new(((x + end) / 2, middle), 12, BLACK.stroke_width(4))),
            Sample::Diamond => area.draw(&diamond(((x + end) / 2, middle), 14)),
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

/// The ranges of a chart, and the labels of its axes.
struct Axes<'t> {
    x: Range<f64>,
    y: Range<f64>,
    across: &'t str,
    up: &'t str,
}

/// An empty chart, drawn on by `work`, below a legend of `entries`.
fn chart(
    size: (u32, u32),
    axes: Axes,
    entries: &[Entry],
    work: impl FnOnce(&mut Context) -> Result<(), Failure>,
) -> Drawn {
    let mut text = String::new();
    let (places, height) = placed(entries, size.0);
    let tall = size.1 - 2 * MARGIN - BELOW;
    let up = textwrap::wrap(axes.up, (tall / LETTER) as usize);
    let draw = |text: &mut String| {
        let whole = SVGBackend::with_string(text, (size.0, size.1 + height)).into_drawing_area();
        whole.fill(&WHITE)?;
        let font = ("sans-serif", TEXT).into_text_style(&whole);
        let beside = font.pos(Pos::new(HPos::Left, VPos::Center));
        for (entry, &(x, y)) in entries.iter().zip(&places) {
            entry.sample.draw(&whole, x, y)?;
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
            .build_cartesian_2d(axes.x, axes.y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID.stroke_width(2))
            .axis_style(BLACK.stroke_width(3))
            .label_style(("sans-serif", TEXT))
            .axis_desc_style(("sans-serif", TEXT))
            .x_desc(axes.across)
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
    let axes = Axes { x: 0.0..end, y, across: "time [s]", up: &up };
    chart(SIZE, axes, &entries, |chart| {
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

/// A rhomb about a place, `reach` wide on each side.
fn diamond<N>((x, y): (N, N), reach: N) -> Polygon<(N, N)>
where
    N: Copy + std::ops::Add<Output = N> + std::ops::Sub<Output = N>,
{
    Polygon::new(vec![(x + reach, y), (x, y + reach), (x - reach, y), (x, y - reach)], BLACK.filled())
}

/// The path of a plan among the volumes. Both axes have the same scale.
fn path(content: &Content, run: &RunContent, view: View) -> Drawn {
    let [i, j] = view.axes();
    let names = ["x", "y", "z"];
    let column = |axis: usize| run.columns.get(names[axis]).map_or(&[][..], Vec::as_slice).iter().copied();
    let shown = |volume: &VolumeContent| if view == View::Above { volume.above.clone() } else { volume.side.clone() };
    // The path and the volumes, as far as these are not farther from it than half its length.
    let of_path = [i, j].map(|axis| range(column(axis).chain(content.waypoints.iter().map(|w| w.at[axis]))));
    let room = 0.5 * of_path.iter().map(|r| r.end - r.start).fold(0.5, f64::max);
    let ends = [0, 1].map(|k| {
        let Range { start, end } = of_path[k].clone();
        let edges = content.volumes.iter().flat_map(|volume| shown(volume).edge);
        let near =
            edges.flatten().map(|p| p[k]).filter(|v| v.abs() < FARTHEST).map(|v| v.clamp(start - room, end + room));
        padded(range(near.chain([start, end]).collect::<Vec<_>>().into_iter()))
    });
    let pixels = [SIZE.0 - 2 * MARGIN - BESIDE, SIZE.1 - 2 * MARGIN - BELOW];
    let per = [0, 1].map(|k| (ends[k].end - ends[k].start) / f64::from(pixels[k])).into_iter().fold(0.0, f64::max);
    let [x, y] = [0, 1].map(|k| {
        let (middle, half) = (0.5 * (ends[k].start + ends[k].end), 0.5 * per * f64::from(pixels[k]));
        middle - half..middle + half
    });
    let edge = |volume: &VolumeContent| if volume.keeps_in { COLORS[2] } else { LIMIT };
    let mut entries = Vec::new();
    for (keeps_in, words) in [(false, "keep_out"), (true, "keep_in")] {
        let Some(volume) = content.volumes.iter().find(|volume| volume.keeps_in == keeps_in) else { continue };
        let sample = match keeps_in {
            false => Sample::Area(edge(volume), 0.2),
            true => Sample::Line(edge(volume).stroke_width(5), None),
        };
        entries.push(Entry { label: words.into(), sample });
        let label = format!("kept by the centre of gravity ({words})");
        entries.push(Entry { label, sample: Sample::Line(edge(volume).stroke_width(3), Some(KEPT)) });
    }
    let style = COLORS[0].stroke_width(6);
    entries.push(Entry { label: "path".into(), sample: Sample::Line(style, None) });
    entries.push(Entry { label: "waypoint".into(), sample: Sample::Circle });
    entries.push(Entry { label: "smallest distance".into(), sample: Sample::Diamond });
    let frame = [x.clone(), y.clone()];
    let (across, up) = (format!("{} [m]", names[i]), format!("{} [m]", names[j]));
    chart(SIZE, Axes { x, y, across: &across, up: &up }, &entries, |chart| {
        let plot = &frame;
        for volume in &content.volumes {
            let outline = shown(volume);
            for area in outline.areas.iter().filter(|_| !volume.keeps_in) {
                let area = in_frame(area, plot);
                if area.len() > 2 {
                    chart.draw_series([Polygon::new(area, edge(volume).mix(0.2))])?;
                }
            }
            for line in outline.edge.iter().flat_map(|line| cut(line, plot)) {
                chart.draw_series([PathElement::new(line, edge(volume).stroke_width(5))])?;
            }
            for line in outline.kept.iter().flat_map(|line| cut(line, plot)) {
                let style = edge(volume).stroke_width(3);
                chart.draw_series([DashedPathElement::new(line, KEPT.0, KEPT.1, style)])?;
            }
        }
        let points: Vec<[f64; 2]> = column(i).zip(column(j)).map(|(x, y)| [x, y]).collect();
        for line in cut(&points, plot) {
            chart.draw_series([PathElement::new(line, style)])?;
        }
        for waypoint in &content.waypoints {
            let place = (waypoint.at[i], waypoint.at[j]);
            chart.draw_series([Circle::new(place, 12, BLACK.stroke_width(4))])?;
        }
        for near in &run.nearest {
            chart.draw_series([diamond((near.at[i], near.at[j]), 14.0 * per)])?;
        }
        for volume in &content.volumes {
            let font = ("sans-serif", TEXT).into_font().color(&edge(volume)).pos(Pos::new(HPos::Center, VPos::Bottom));
            let Outline { edge: own, kept, .. } = shown(volume);
            let lines = if volume.keeps_in { own } else { kept };
            let lines = lines.iter().flat_map(|line| cut(line, plot)).collect::<Vec<_>>();
            let top = lines.iter().flatten().copied().max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((x, y)) = top else { continue };
            // Whole within the frame.
            let half = 0.5 * per * f64::from(LETTER) * volume.name.chars().count() as f64;
            let x = x.clamp(plot[0].start + half, (plot[0].end - half).max(plot[0].start + half));
            let y = (y + 6.0 * per).min(plot[1].end - 1.2 * per * f64::from(TEXT));
            chart.draw_series([Text::new(volume.name.clone(), (x, y), font)])?;
        }
        Ok(())
    })
}

/// Coordinates beyond this are those of a half space, m.
const FARTHEST: f64 = 2e6;

/// Dashes of the boundary that the centre of gravity keeps.
const KEPT: Dash = (18, 12);

/// The part of a convex polygon in a frame.
fn in_frame(polygon: &[[f64; 2]], frame: &[Range<f64>; 2]) -> Vec<(f64, f64)> {
    let mut kept = polygon.to_vec();
    for (axis, Range { start, end }) in frame.iter().enumerate() {
        kept = clipped(&kept, |p| p[axis] - end);
        kept = clipped(&kept, |p| start - p[axis]);
    }
    kept.into_iter().map(|p| (p[0], p[1])).collect()
}

/// The parts of a line in a frame (Liang and Barsky): the drawing library moves points outside to its edge.
fn cut(line: &[[f64; 2]], frame: &[Range<f64>; 2]) -> Vec<Vec<(f64, f64)>> {
    let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut is_open = false;
    for ends in line.windows(2) {
        let (a, b) = (ends[0], ends[1]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (axis, Range { start, end }) in frame.iter().enumerate() {
            let d = b[axis] - a[axis];
            for (slope, room) in [(-d, a[axis] - start), (d, end - a[axis])] {
                match slope {
                    s if s < 0.0 => from = from.max(room / s),
                    s if s > 0.0 => to = to.min(room / s),
                    _ if room < 0.0 => to = -1.0,
                    _ => {}
                }
            }
        }
        if from > to {
            is_open = false;
            continue;
        }
        let at = |t: f64| (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
        match parts.last_mut() {
            Some(part) if is_open && from == 0.0 => part.push(at(to)),
            _ => parts.push(vec![at(from), at(to)]),
        }
        is_open = to == 1.0;
    }
    parts
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
    let axes = Axes { x: -reach..reach, y: -reach..reach, across: "torque about x [N m]", up: "torque about y [N m]" };
    chart(SQUARE, axes, &entries, |chart| {
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

/// The section of a set through hover along the torques about x and y, by clipping a square with every row (Sutherland
/// and Hodgman).
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
