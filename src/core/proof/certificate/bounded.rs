//! Lists of bounded length: a certificate that is too large for the checker is refused while it is read, before memory
//! is spent on it.

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// Parts of the largest cone: an upper bound and three components.
const CONE: usize = 4;

/// Rotors that name a facet.
const SPANNING: usize = 3;

/// A list of at most `MOST` entries.
pub(super) fn at_most<'de, const MOST: usize, D: Deserializer<'de>, T: Deserialize<'de>>(
    deserializer: D,
) -> Result<Vec<T>, D::Error> {
    deserializer.deserialize_seq(List::<MOST, T>(PhantomData))
}

/// The multiplier of one row.
pub(super) fn numbers<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    at_most::<CONE, D, f64>(deserializer)
}

/// The rotors of one facet.
pub(super) fn rotors<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<usize>, D::Error> {
    at_most::<SPANNING, D, usize>(deserializer)
}

struct List<const MOST: usize, T>(PhantomData<T>);

impl<'de, const MOST: usize, T: Deserialize<'de>> Visitor<'de> for List<MOST, T> {
    type Value = Vec<T>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "a list of at most {MOST}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<T>, A::Error> {
        let mut found = Vec::new();
        while let Some(entry) = list.next_element()? {
            if found.len() == MOST {
                return Err(A::Error::custom(format!("more than {MOST} entries")));
            }
            found.push(entry);
        }
        Ok(found)
    }
}
