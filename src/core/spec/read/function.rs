//! The functions of the language.

use super::context::{Context, FUNCTIONS};
use super::expression::Value;
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::Span;
use crate::syntax::ast::{Expr, Name};
use crate::unit::{Dimension, Quantity, compare, mismatch};

impl<'a> Context<'a> {
    pub(super) fn call(&mut self, function: &'a Name, arguments: &'a [Expr], span: Span) -> Option<Value> {
        let name = function.value.as_str();
        // Arguments are evaluated even for an unknown function, so that their errors are reported in the same run.
        let values: Vec<Option<Quantity>> = arguments.iter().map(|a| self.evaluate_quantity(a)).collect();
        let due = match name {
            "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "sqrt" | "abs" => 1..=1,
            "atan2" => 2..=2,
            "min" | "max" => 2..=usize::MAX,
            _ => {
                let message = format!("unknown function `{name}`");
                let error = Diagnostic::error("mavc::name::unknown", function.span, message).here("not a function");
                self.report(match meant(name) {
                    Some(near) => error.help(format!("did you mean `{near}`?")).fix(function.span, near),
                    None => error.help(format!("use one of the functions {}", FUNCTIONS.join(", "))),
                });
                return None;
            }
        };
        if !due.contains(&arguments.len()) {
            let (count, form) = match name {
                "atan2" => ("two arguments, y and x", "(y, x)"),
                "min" | "max" => ("two or more arguments", "(a, b)"),
                _ => ("one argument", "(x)"),
            };
            let message = format!("`{name}` takes {count}, not {}", arguments.len());
            let error = Diagnostic::error("mavc::unit::argument", span, message).here("wrong number of arguments");
            self.report(error.help(format!("write it like `{name}{form}`")));
            return None;
        }
        let values: Vec<Quantity> = values.into_iter().collect::<Option<_>>()?;
        let x = values[0];
        let plain = |value: f64| Some(Quantity::plain(value));
        let angle = |value: f64| Some(Quantity::new(value, Dimension::ANGLE));
        let result = match name {
            "sin" | "cos" | "tan" => {
                if !x.dimension.is_plain() && x.dimension != Dimension::ANGLE {
                    return self.wrong_argument(name, "an angle or a plain number", x, &arguments[0]);
                }
                plain(match name {
                    "sin" => x.value.sin(),
                    "cos" => x.value.cos(),
                    _ => x.value.tan(),
                })
            }
            "asin" | "acos" | "atan" => {
                if !x.dimension.is_plain() {
                    return self.wrong_argument(name, "a plain number", x, &arguments[0]);
                }
                angle(match name {
                    "asin" => x.value.asin(),
                    "acos" => x.value.acos(),
                    _ => x.value.atan(),
                })
            }
            "sqrt" => x.power(0.5),
            "abs" => Some(Quantity { value: x.value.abs(), ..x }),
            _ => {
                let other = values.iter().zip(arguments).skip(1).find(|(q, _)| q.dimension != x.dimension);
                if let Some((q, argument)) = other {
                    let difference = compare(["first", "other"], x.dimension, q.dimension);
                    let message =
                        format!("`{name}` cannot combine {} and {}", x.dimension.describe(), q.dimension.describe());
                    let error = Diagnostic::error("mavc::unit::mismatch", argument.span, message)
                        .here(format!("this is {}", q.dimension.describe()))
                        .also(arguments[0].span, format!("this is {}", x.dimension.describe()))
                        .help(format!("{}\ngive all arguments the same dimension", difference.table));
                    self.report_of_sides([(&arguments[0], x), (argument, *q)], error);
                    return None;
                }
                match name {
                    "atan2" => angle(x.value.atan2(values[1].value)),
                    "min" => values.iter().copied().reduce(|a, b| if b.value < a.value { b } else { a }),
                    _ => values.iter().copied().reduce(|a, b| if b.value > a.value { b } else { a }),
                }
            }
        };
        match result {
            Some(q) => self.finite(q, span),
            None => {
                let message = "the square root of this unit has too large an exponent";
                let error = Diagnostic::error("mavc::unit::exponent", span, message).here("no square root");
                self.report(error.help("take the root of the number alone, and write the unit after it"));
                None
            }
        }
    }

    fn wrong_argument(&mut self, function: &str, due: &str, found: Quantity, argument: &Expr) -> Option<Value> {
        let message = format!("`{function}` takes {due}, not {}", found.dimension.describe());
        let difference = mismatch(Dimension::PLAIN, found.dimension);
        let unit = found.dimension;
        self.report(
            Diagnostic::error("mavc::unit::mismatch", argument.span, message)
                .here(format!("this is {}", found.dimension.describe()))
                .help(format!("{}\ndivide by {}, as in `/ (1 {unit})`", difference.table, found.dimension.describe())),
        );
        None
    }
}

/// The function that somebody who wrote `name` probably wanted.
fn meant(name: &str) -> Option<&'static str> {
    nearest(name, FUNCTIONS).or_else(|| FUNCTIONS.into_iter().find(|f| name.starts_with(f)))
}
