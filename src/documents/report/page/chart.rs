//! Charts of a trajectory over time: curves, unit, limits and headline.

use serde::Serialize;
use std::collections::BTreeMap;

/// Numbers over the instants of a trajectory, by name; `t` is time in s.
pub type Columns = BTreeMap<String, Vec<f64>>;

/// One chart.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Chart {
    pub id: &'static str,
    pub title: &'static str,
    /// The fact that the curves show.
    pub headline: String,
    /// Unit of the columns' numbers.
    pub unit: &'static str,
    pub lines: Vec<Line>,
    pub bounds: Vec<Bound>,
    /// The component of the wrench (0 to 3) that it shows, around which the range left by a mode's set can be drawn.
    pub axis: Option<usize>,
}

impl Chart {
    /// The chart with a headline that does not break between a number and its unit.
    pub fn set(mut self) -> Self {
        self.headline = super::prose::unbroken(&self.headline);
        self
    }
}

/// One curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line {
    pub label: String,
    /// Name of its column.
    pub column: String,
    /// Whether it is the reference of the line before it.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub aim: bool,
}

impl Line {
    /// A curve of its own.
    pub fn new(label: impl Into<String>, column: impl Into<String>) -> Self {
        Line { label: label.into(), column: column.into(), aim: false }
    }

    /// The reference of the line before it.
    pub fn aim(label: impl Into<String>, column: impl Into<String>) -> Self {
        Line { aim: true, ..Line::new(label, column) }
    }
}

/// A level that must not be exceeded, or a reference level.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Bound {
    pub label: String,
    pub value: f64,
    /// A level for comparison, which is not a constraint.
    pub is_reference: bool,
}

impl Bound {
    pub fn limit(label: impl Into<String>, value: f64) -> Self {
        Bound { label: label.into(), value: rounded(value), is_reference: false }
    }

    pub fn reference(label: impl Into<String>, value: f64) -> Self {
        Bound { is_reference: true, ..Bound::limit(label, value) }
    }
}

/// A length in m, or in cm below 1 m, as in the terminal.
pub fn length(metres: f64) -> String {
    match metres.abs() {
        m if m >= 1.0 => format!("{} m", crate::number::significant(metres, 3)),
        _ => format!("{} cm", crate::number::significant(1e2 * metres, 3)),
    }
}

/// The nearest number with six significant digits, no `-0`: enough for a chart, and short as text.
pub fn rounded(x: f64) -> f64 {
    significant(x, 5)
}

/// The numbers of one column, rounded to a hundred thousandth of the largest: charts show no more.
pub fn column(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let largest = values.iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest == 0.0 {
        return values;
    }
    let least = 10f64.powi(largest.log10().floor() as i32 - 5);
    values.into_iter().map(|v| rounded((v / least).round() * least)).collect()
}

/// The nearest number with nine significant digits, for the rows of sets.
pub fn precise(x: f64) -> f64 {
    significant(x, 8)
}

fn significant(x: f64, decimals: usize) -> f64 {
    let near = format!("{x:.decimals$e}").parse().unwrap_or(x);
    if near == 0.0 { 0.0 } else { near }
}
