//! What elaboration understood of a spec, for editors: available even where errors prevent a model.

use super::context::Context;
use super::expression::Value;
use crate::diagnostic::Checked;
use crate::model::{FaultMode, Model, Vehicle};
use crate::source::Span;
use crate::unit::{Dimension, parse_unit};

/// A value that was read from an expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The place of the expression.
    pub span: Span,
    /// One number, the elements of a list, or the two ends of a range, in SI units.
    pub values: Vec<f64>,
    /// The SI unit of all values, such as `rad/s`; empty for plain numbers.
    pub unit: String,
}

/// A number of the `rotor` block that its thrust table gives.
#[derive(Debug, Clone, PartialEq)]
pub struct FromTable {
    /// The path of the table in the spec.
    pub span: Span,
    pub field: &'static str,
    /// In SI units.
    pub value: f64,
    pub unit: &'static str,
    /// Where in the table it comes from, and how far the rows are from it.
    pub reason: String,
    /// Whether the spec takes it, because it writes none itself.
    pub is_used: bool,
}

/// A spec as far as it could be understood.
#[derive(Debug, Clone)]
pub struct Understanding {
    /// The result of [`super::elaborate()`].
    pub checked: Checked<Model>,
    /// Acceleration of gravity, m/s^2.
    pub gravity: f64,
    /// Every vehicle without errors of its own.
    pub vehicles: Vec<Vehicle>,
    /// Every fault mode without errors of its own, in the order written.
    pub modes: Vec<FaultMode>,
    /// In the order read. Coordinates of curves, which have one value per point, are not included.
    pub readings: Vec<Reading>,
    /// The numbers of all thrust tables without errors.
    pub from_tables: Vec<FromTable>,
}

impl Context<'_> {
    /// Records what was read at `span`: values in SI units, of the dimension of `unit`.
    pub(super) fn note(&mut self, span: Span, values: &[f64], unit: &str) {
        if self.parameter.is_none() {
            let unit = match parse_unit(unit, 1.0) {
                Ok(known) if known.numerator == known.denominator => if unit == "1" { "" } else { unit }.to_string(),
                Ok(known) => si_unit(known.dimension),
                Err(_) => String::new(),
            };
            self.readings.push(Reading { span, values: values.to_vec(), unit });
        }
    }

    /// Records the value of a `let`. Text, and lists of several dimensions, are not recorded.
    pub(super) fn note_value(&mut self, span: Span, value: &Value) {
        let quantities = match value {
            Value::Quantity(q) => vec![*q],
            Value::List(list) => list.clone(),
            Value::Range(low, high) => vec![*low, *high],
            Value::Text(_) => return,
        };
        let Some(first) = quantities.first() else { return };
        if self.parameter.is_none() && quantities.iter().all(|q| q.dimension == first.dimension) {
            let unit = si_unit(first.dimension);
            self.readings.push(Reading { span, values: quantities.iter().map(|q| q.value).collect(), unit });
        }
    }
}

/// The usual SI unit of a dimension; a product of base units where there is none, and nothing for plain numbers.
pub fn si_unit(dimension: Dimension) -> String {
    match dimension.named() {
        Some((_, unit)) => unit.to_string(),
        None if dimension.is_plain() => String::new(),
        None => dimension.to_string(),
    }
}
