//! Whether a field is written, and whether its value is sound.

/// What a block says of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Written<T> {
    /// Nothing.
    #[default]
    Absent,
    /// A value with an error, which is reported, or that may have been meant.
    Faulty,
    Value(T),
}

/// A field is written with an error, which has been reported.
#[derive(Debug)]
pub struct Faulty;

impl<T> Written<T> {
    /// A field that is there, with its value unless that had an error.
    pub fn of(value: Option<T>) -> Self {
        value.map_or(Written::Faulty, Written::Value)
    }

    pub fn is_absent(&self) -> bool {
        matches!(self, Written::Absent)
    }

    pub fn is_faulty(&self) -> bool {
        matches!(self, Written::Faulty)
    }

    /// The value, or that of a field that is not written; `None` for a faulty one.
    pub fn or_default(self, default: impl FnOnce() -> T) -> Option<T> {
        match self {
            Written::Absent => Some(default()),
            Written::Faulty => None,
            Written::Value(value) => Some(value),
        }
    }

    /// The value, which a field that is not written does not have.
    ///
    /// # Errors
    /// [`Faulty`] for a faulty one.
    pub fn optional(self) -> Result<Option<T>, Faulty> {
        match self {
            Written::Absent => Ok(None),
            Written::Faulty => Err(Faulty),
            Written::Value(value) => Ok(Some(value)),
        }
    }

    /// The value, if there is a sound one.
    pub fn value(self) -> Option<T> {
        match self {
            Written::Absent | Written::Faulty => None,
            Written::Value(value) => Some(value),
        }
    }

    /// This field, or another one where it is not written.
    pub fn or(self, other: Self) -> Self {
        if self.is_absent() { other } else { self }
    }

    /// Another value; faulty where there is none.
    pub fn and_then<U>(self, of: impl FnOnce(T) -> Option<U>) -> Written<U> {
        match self {
            Written::Absent => Written::Absent,
            Written::Faulty => Written::Faulty,
            Written::Value(value) => Written::of(of(value)),
        }
    }
}
