//! Charts of a motion over time: which curves, in which unit, with which limits, under which headline.

use serde::Serialize;
use std::collections::BTreeMap;

/// Numbers over the instants of a motion, by name; `t` is time in s.
pub type Columns = BTreeMap<String, Vec<f64>>;

/// One chart.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Chart {
    pub id: &'static str,
    pub title: &'static str,
    /// A fact: what the curves come to.
    pub headline: String,
    /// For people, with the numbers of the columns in it.
    pub unit: &'static str,
    pub lines: Vec<Line>,
    pub bounds: Vec<Bound>,
    /// The wrench's axis (0 to 3) that it shows, whose room in a mode's set can be drawn around it.
    pub axis: Option<usize>,
}

impl Chart {
    /// The same, its headline with numbers and units on one line.
    pub fn set(mut self) -> Self {
        self.headline = super::prose::unbroken(&self.headline);
        self
    }
}

/// One curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line {
    pub label: String,
    /// Of the columns.
    pub column: String,
    /// What the line before it was to be.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub aim: bool,
}

impl Line {
    pub fn new(label: impl Into<String>, column: impl Into<String>) -> Self {
        Line { label: label.into(), column: column.into(), aim: false }
    }

    /// What the line before it was to be.
    pub fn aim(label: impl Into<String>, column: impl Into<String>) -> Self {
        Line { aim: true, ..Line::new(label, column) }
    }
}

/// A level that may not be passed, or one to compare with.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Bound {
    pub label: String,
    pub value: f64,
    /// A level to compare with, which no rule keeps.
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

/// A length in m, below one in cm, as errors are told in the terminal.
pub fn length(metres: f64) -> String {
    match metres.abs() {
        m if m >= 1.0 => format!("{} m", crate::number::significant(metres, 3)),
        _ => format!("{} cm", crate::number::significant(1e2 * metres, 3)),
    }
}

/// The nearest number with six significant digits, no `-0`: what a chart can show, in short text.
pub fn rounded(x: f64) -> f64 {
    significant(x, 5)
}

/// Numbers of one column, without digits that no chart shows: a hundred thousandth of the largest is the least.
pub fn column(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let largest = values.iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest == 0.0 {
        return values;
    }
    let least = 10f64.powi(largest.log10().floor() as i32 - 5);
    values.into_iter().map(|v| rounded((v / least).round() * least)).collect()
}

/// The same with nine digits, for the rows of sets.
pub fn precise(x: f64) -> f64 {
    significant(x, 8)
}

fn significant(x: f64, decimals: usize) -> f64 {
    let near = format!("{x:.decimals$e}").parse().unwrap_or(x);
    if near == 0.0 { 0.0 } else { near }
}
