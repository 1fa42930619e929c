//! Facets named by the rotors that span them.

use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::admissible::{AdmissibleSet, FacetOf};
use crate::certificate::FacetRecord;
use crate::model::{Allocation, Model};
use nalgebra::Matrix4;

/// The first facet that a row comes from; `None` if rotors do not name it.
pub(super) fn facet_of(model: &Model, row: &SetRow) -> Option<FacetRecord> {
    record(model, *row.origin.first()?)
}

/// `None` if rotors do not name the facet: in a flat set, and for the row T >= 0.
fn record(model: &Model, FacetOf { mode, facet, spanning }: FacetOf) -> Option<FacetRecord> {
    let set = set_of(model, mode).guaranteed(model);
    let plane = set.polytope.facets.get(facet)?;
    let spanning: Vec<usize> = spanning.generators().collect();
    let rotors = match set.allocation {
        Allocation::Bounded => steepest(&set.zonotope.generators, &spanning, &plane.normal)?.map(|k| k + 1).to_vec(),
        // The one rotor that does not span the facet.
        Allocation::PseudoInverse => {
            (1..=model.vehicle.rotors.len()).find(|k| !spanning.contains(&(k - 1))).into_iter().collect()
        }
    };
    Some(FacetRecord { mode: set.name, rotors, normal: plane.normal.into(), offset: plane.offset })
}

/// The three rotors of a facet whose wrenches span the largest volume, in coordinates scaled to equal extents.
fn steepest(generators: &[Wrench], rotors: &[usize], normal: &Wrench) -> Option<[usize; 3]> {
    let extent = generators.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
    let scaled = |v: &Wrench| v.component_div(&extent.map(|e| if e > 0.0 { e } else { 1.0 })).normalize();
    let up = normal.component_mul(&extent).normalize();
    let mut best: Option<(f64, [usize; 3])> = None;
    for (i, &a) in rotors.iter().enumerate() {
        for (j, &b) in rotors.iter().enumerate().skip(i + 1) {
            for &c in &rotors[j + 1..] {
                let [p, q, r] = [a, b, c].map(|k| scaled(&generators[k]));
                let volume = Matrix4::from_columns(&[p, q, r, up]).determinant().abs();
                if volume.is_finite() && best.is_none_or(|(most, _)| volume > most) {
                    best = Some((volume, [a, b, c]));
                }
            }
        }
    }
    best.filter(|(volume, _)| *volume > 1e-6).map(|(_, rotors)| rotors)
}

fn set_of(model: &Model, mode: usize) -> AdmissibleSet {
    match mode.checked_sub(1) {
        None => AdmissibleSet::healthy(model),
        Some(index) => AdmissibleSet::of_mode(model, index),
    }
}
