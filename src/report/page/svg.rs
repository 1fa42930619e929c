//! The page's charts and sections as SVG files, for papers (`--svg`).

use super::chart::Chart;
use super::content::{Content, RunContent};
use super::sets::SetContent;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use std::ops::Range;

/// Backend units: its coordinates are whole numbers, so the drawing is large.
const SIZE: (u32, u32) = (2000, 1150);
const SQUARE: (u32, u32) = (1400, 1350);
const TEXT: u32 = 46;

/// Okabe and Ito's colours, told apart by colour-blind people.
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
const LIMIT: RGBColor = RGBColor(179, 38, 30);
const GRID: RGBColor = RGBColor(225, 228, 232);

type Drawn = Result<String, String>;
type Context<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// File names and texts: every chart of the run that is shown first, and every set's section at hover.
///
/// # Errors
/// What the drawing library says, where it cannot draw.
pub fn files(content: &Content) -> Result<Vec<(String, String)>, String> {
    let run = content.runs.get(content.first);
    let mut files = Vec::new();
    for (run, chart) in run.iter().flat_map(|run| run.charts.iter().map(move |chart| (run, chart))) {
        files.push((format!("{}.svg", chart.id.replace('_', "-")), curves(run, chart)?));
    }
    for set in content.sets.iter().filter(|s| s.equalities.is_empty()) {
        let name: String = set.name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '-' }).collect();
        files.push((format!("set-{name}.svg"), section(content, set, run)?));
    }
    Ok(files)
}

/// An empty chart over the given ranges, drawn on by `work`.
fn chart(
    size: (u32, u32),
    (x, y): (Range<f64>, Range<f64>),
    (across, up): (&str, &str),
    work: impl FnOnce(&mut Context) -> Result<(), DrawingAreaErrorKind<std::io::Error>>,
) -> Drawn {
    let mut text = String::new();
    let draw = |text: &mut String| {
        let area = SVGBackend::with_string(text, size).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(50)
            .x_label_area_size(130)
            .y_label_area_size(190)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID.stroke_width(2))
            .axis_style(BLACK.stroke_width(3))
            .label_style(("sans-serif", TEXT))
            .axis_desc_style(("sans-serif", TEXT))
            .x_desc(across)
            .y_desc(up)
            .draw()?;
        work(&mut chart)?;
        area.present()
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
    chart(SIZE, (0.0..end, y), ("time [s]", &up), |chart| {
        for (i, curve) in spec.lines.iter().enumerate() {
            let style = COLORS[i % COLORS.len()].stroke_width(5);
            let points = times.iter().copied().zip(line(&curve.column).iter().copied());
            let series = chart.draw_series(LineSeries::new(points.filter(|p| p.1.is_finite()), style))?;
            if spec.lines.len() > 1 {
                series.label(&curve.label).legend(move |(x, y)| PathElement::new([(x, y), (x + 70, y)], style));
            }
        }
        for bound in bounds {
            let style = if bound.is_reference { COLORS[7] } else { LIMIT }.stroke_width(3);
            chart.draw_series(DashedLineSeries::new([(0.0, bound.value), (end, bound.value)], 24, 14, style))?;
        }
        if spec.lines.len() > 1 {
            let mut labels = chart.configure_series_labels();
            labels.position(SeriesLabelPosition::UpperRight).legend_area_size(90).margin(20);
            labels.label_font(("sans-serif", TEXT)).background_style(WHITE.mix(0.8)).draw()?;
        }
        Ok(())
    })
}

/// Torques about x and y at hover, as the paper's Figures 7 to 9, with those of the plan.
fn section(content: &Content, set: &SetContent, run: Option<&RunContent>) -> Drawn {
    let healthy = content.sets.first().unwrap_or(set);
    let [_, x, y, _] = content.extents;
    // As many units either way.
    let reach = 1.08 * [x, y].as_flattened().iter().fold(0.0_f64, |m, v| m.max(v.abs())).max(1e-9);
    let column = |name: &str| run.and_then(|r| r.columns.get(name)).map_or(&[][..], Vec::as_slice).iter().copied();
    chart(SQUARE, (-reach..reach, -reach..reach), ("torque about x [N m]", "torque about y [N m]"), |chart| {
        for (set, color, share) in [(healthy, COLORS[7], 0.12), (set, COLORS[0], 0.2)] {
            let corners = corners(set, &content.hover, reach);
            if corners.len() < 3 {
                continue;
            }
            let closed = corners.iter().chain(corners.first()).copied().collect::<Vec<_>>();
            chart.draw_series([Polygon::new(corners.clone(), color.mix(share))])?;
            chart.draw_series([PathElement::new(closed, color.stroke_width(5))])?;
        }
        let points = column("tau_x").zip(column("tau_y"));
        chart.draw_series(LineSeries::new(points, BLACK.mix(0.6).stroke_width(3)))?;
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
