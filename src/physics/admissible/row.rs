//! Facets as dimensionless rows, by which a wrench is compared with a set.

use super::without_yaw::planned::{CoreRow, Turning};
use super::{AdmissibleSet, FacetOf};
use crate::actuation::Wrench;
use crate::geometry::polytope::Facet;

/// A row counts as violated if its [violation](SetRow::violation) is above this share of the healthy set's width, 0.01
/// % (`docs/method/planners.md`).
pub const VIOLATED: f64 = 1e-4;

/// A row of a planning set, divided by the healthy set's width along its normal.
#[derive(Debug, Clone, PartialEq)]
pub struct SetRow {
    /// Normal over the width: 1/N, 1/(N m), 1/(N m), 1/(N m).
    pub normal: Wrench,
    /// Offset over the width, dimensionless.
    pub offset: f64,
    /// `normal.w = offset` instead of `normal.w <= offset`.
    pub equality: bool,
    /// All facets in this plane.
    pub origin: Vec<FacetOf>,
    /// A row of a core, whose `normal` is along T alone; see [`CoreRow`].
    pub core: Option<CoreRow>,
}

impl SetRow {
    /// The violation `(n.w - e) / width` of a wrench, positive outside; `|n.w - e| / width` for an equality.
    pub fn violation(&self, w: &Wrench) -> f64 {
        let v = self.normal.dot(w) - self.offset;
        if self.equality { v.abs() } else { v }
    }

    /// What a core adds to the violation by the thrust; 0 for other rows. Without a `turning` the bound on the thrust
    /// alone is left, which is weaker.
    pub fn of_core(&self, turning: Option<&Turning>) -> f64 {
        self.core.zip(turning).map_or(0.0, |(core, turning)| core.share(turning))
    }
}

impl SetRow {
    /// The largest violation of some wrenches.
    pub fn worst(&self, wrenches: &[Wrench]) -> f64 {
        largest(wrenches.iter().map(|w| self.violation(w)))
    }
}

/// The largest of some violations; infinite where one is not a number, because a wrench that is not finite violates
/// every row.
pub fn largest(violations: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |most: f64, violation: f64| if violation.is_nan() { f64::INFINITY } else { most.max(violation) };
    violations.into_iter().fold(f64::NEG_INFINITY, larger)
}

/// The dimensionless row of a facet: normal and offset divided by the width of the `healthy` zonotope along the normal.
pub fn row<O>(facet: &Facet<4, O>, healthy: &AdmissibleSet, origin: Vec<FacetOf>) -> SetRow {
    let width = healthy.zonotope.width(&facet.normal);
    SetRow { normal: facet.normal / width, offset: facet.offset / width, equality: false, origin, core: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_violates_every_row() {
        assert_eq!(largest([-1.0, f64::NAN, 0.5]), f64::INFINITY);
        assert_eq!((largest([-1.0, 0.5]), largest([])), (0.5, f64::NEG_INFINITY));
        let row = SetRow {
            normal: Wrench::new(1.0, 0.0, 0.0, 0.0),
            offset: 1.0,
            equality: false,
            origin: vec![],
            core: None,
        };
        assert_eq!(row.worst(&[Wrench::zeros(), Wrench::from_element(f64::NAN)]), f64::INFINITY);
    }
}
