//! A block whose fields have defaults, with a record of those that were used.

use super::context::Context;
use super::fields::Fields;
use crate::language::Entry;
use crate::model::DefaultUsed;
use crate::syntax::ast::Expr;
use std::ops::Deref;

/// The fields of one block. What reads a field gives its value, or the default of a field that is not written, which
/// is recorded; `None` for a value with an error, which is reported.
pub(super) struct Defaulted<'a> {
    fields: Fields<'a>,
    /// The block as the record of a default names it, such as `vehicle.battery`.
    path: &'static str,
    /// The defaults used so far, in the order read.
    pub used: Vec<DefaultUsed>,
}

impl<'a> Deref for Defaulted<'a> {
    type Target = Fields<'a>;

    fn deref(&self) -> &Fields<'a> {
        &self.fields
    }
}

impl<'a> Defaulted<'a> {
    pub fn new(path: &'static str, fields: Fields<'a>) -> Self {
        Defaulted { fields, path, used: Vec::new() }
    }

    /// Returns `value` and records it as the default of a field that is not written.
    pub fn default<T>(&mut self, entry: &Entry, value: T) -> T {
        self.used.push(DefaultUsed::of(self.path, entry));
        value
    }

    /// A field as `read` reads its value.
    pub fn value_or<T>(&mut self, entry: &Entry, default: T, read: impl FnOnce(&'a Expr) -> Option<T>) -> Option<T> {
        self.written(entry.name, read).or_default(|| self.default(entry, default))
    }

    /// A quantity, in SI units; `code` is the error code for a value out of its range.
    pub fn quantity_or_default(
        &mut self,
        cx: &mut Context<'a>,
        entry: &'static Entry,
        code: &'static str,
    ) -> Option<f64> {
        self.quantity(cx, entry, code).or_default(|| self.default(entry, entry.value()))
    }

    /// A whole number; `code` is the error code for a value out of its range.
    pub fn count_or_default(
        &mut self,
        cx: &mut Context<'a>,
        entry: &'static Entry,
        code: &'static str,
    ) -> Option<usize> {
        self.count(cx, entry, code).or_default(|| self.default(entry, entry.value() as usize))
    }

    /// One of `choices`, as [`Fields::choice`] reads it.
    pub fn choice_or<T: Copy>(
        &mut self,
        cx: &mut Context<'a>,
        entry: &'static Entry,
        code: &'static str,
        choices: &[T],
        default: T,
    ) -> Option<T> {
        self.choice(cx, entry, code, choices).or_default(|| self.default(entry, default))
    }
}
