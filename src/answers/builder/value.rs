//! Values of a builder's calls, and how they are written.

use crate::language::{Entry, Takes};
use crate::unit::parse_unit;
use std::fmt;

/// The value of a field.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number, in SI units.
    Number(f64),
    /// Three numbers, in SI units.
    Vector([f64; 3]),
    /// A word of the language, a name, or a text.
    Word(String),
    /// Several words or names.
    Names(Vec<String>),
    /// Points `[x, y]` of a plane, in SI units.
    Points(Vec<[f64; 2]>),
}

/// Values of other types, each with the expression that makes a [`Value`] of `given`.
macro_rules! values {
    ($($type:ty $([$n:ident])? => |$given:ident| $value:expr;)*) => {$(
        impl $(<const $n: usize>)? From<$type> for Value {
            fn from($given: $type) -> Self {
                $value
            }
        }
    )*};
}

values! {
    f64 => |number| Value::Number(number);
    i32 => |number| Value::Number(number.into());
    u32 => |number| Value::Number(number.into());
    usize => |number| Value::Number(number as f64);
    [f64; 3] => |vector| Value::Vector(vector);
    &str => |word| Value::Word(word.into());
    String => |word| Value::Word(word);
    [&str; N] [N] => |names| Value::Names(names.map(String::from).into());
    Vec<String> => |names| Value::Names(names);
    [[f64; 2]; N] [N] => |points| Value::Points(points.into());
    Vec<[f64; 2]> => |points| Value::Points(points);
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(number) => write!(f, "the number {number}"),
            Value::Vector(_) => f.write_str("three numbers"),
            Value::Word(word) => write!(f, "{word:?}"),
            Value::Names(_) => f.write_str("a list of names"),
            Value::Points(_) => f.write_str("a list of points"),
        }
    }
}

/// A number that the compiler rejects as too large. It replaces a value with a [`super::BuildProblem`], so that its
/// field is not missing.
pub(super) const NOT_FINITE: &str = "1e999";

/// A number with all its digits, so that reading it gives the same number.
pub(super) fn digits(number: f64) -> String {
    match number.abs() {
        _ if !number.is_finite() => NOT_FINITE.into(),
        size if size == 0.0 || (1e-5..1e15).contains(&size) => format!("{number}"),
        _ => format!("{number:e}"),
    }
}

/// A word as a name of the language: with `_` for every character that a name may not have there.
pub(super) fn word(text: &str) -> String {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    let first = if text.starts_with(is_letter) { "" } else { "_" };
    let rest = text.chars().map(|c| if is_letter(c) || c.is_ascii_digit() { c } else { '_' });
    first.chars().chain(rest).collect()
}

/// The SI unit of an entry after a space; empty for a plain number.
pub(super) fn unit(entry: &Entry) -> String {
    let Some((usual, unit)) = entry.unit().and_then(|unit| Some((unit, parse_unit(unit, 1.0).ok()?))) else {
        return String::new();
    };
    match usual {
        "1" => String::new(),
        _ if unit.numerator == unit.denominator => format!(" {usual}"),
        _ => format!(" {}", unit.dimension),
    }
}

/// A description of the values that an entry takes.
pub(super) fn taken(entry: &Entry) -> String {
    let words = entry.words().iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
    match entry.takes {
        Takes::Quantity(..) | Takes::QuantityOrShare(..) | Takes::Bound(..) | Takes::Share | Takes::Whole(..) => {
            "a number".into()
        }
        Takes::Vector(..) | Takes::PlanePoint(_) => "three numbers".into(),
        Takes::QuantityOrVector(..) => "a number or three numbers".into(),
        Takes::QuantityOr(..) => format!("a number or one of {words}"),
        Takes::Words(_) => format!("one of {words}"),
        Takes::WordList(_) => format!("one or more of {words}"),
        Takes::Nothing => "no value".into(),
        Takes::Text => "a text without quotes and control characters".into(),
        Takes::Names(_) => "a name or a list of names".into(),
        Takes::NameList(_) => "a list of names".into(),
        Takes::Points => "a list of points".into(),
    }
}
