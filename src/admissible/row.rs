//! Facets as rows without dimension, on which a wrench is held against a set.

use super::{AdmissibleSet, FacetOf};
use crate::actuation::Wrench;
use crate::geometry::polytope::Facet;

/// A facet counts as violated when it is passed by more than this share of the healthy set's width along
/// its normal.
pub const VIOLATED: f64 = 1e-4;

/// One row of a planning set, made dimensionless by the healthy set's width along its normal.
#[derive(Debug, Clone, PartialEq)]
pub struct SetRow {
    /// 1/N and 1/(N m)
    pub normal: Wrench,
    pub offset: f64,
    /// normal . w = offset instead of <=.
    pub equality: bool,
    /// All facets with this plane.
    pub origin: Vec<FacetOf>,
}

impl SetRow {
    /// (n.w - e) / width: positive outside.
    pub fn violation(&self, w: &Wrench) -> f64 {
        let v = self.normal.dot(w) - self.offset;
        if self.equality { v.abs() } else { v }
    }
}

/// A facet of a set as a dimensionless row.
pub fn row<O>(facet: &Facet<4, O>, healthy: &AdmissibleSet, origin: Vec<FacetOf>) -> SetRow {
    let width = healthy.zonotope.width(&facet.normal);
    SetRow { normal: facet.normal / width, offset: facet.offset / width, equality: false, origin }
}
