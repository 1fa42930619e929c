//! Facets as certificates print them: rotors, and the normal and offset that follow from them.

use super::Rejection;
use super::interval::{Interval, exceeds};
use super::sets::{Facet, Generators};
use crate::certificate::FacetRecord;
use crate::model::Model;
use crate::report::number::number;

/// Printed normals and offsets may be off by this share.
const PRINTED: f64 = 1e-9;

/// Facets of one certificate.
const MAX_FACETS: usize = 50_000;

pub(super) fn few<T>(facets: &[T]) -> Result<(), Rejection> {
    if facets.len() <= MAX_FACETS {
        return Ok(());
    }
    Err(Rejection::new("the facets", format!("there are {}, and {MAX_FACETS} are checked at once", facets.len())))
}

/// The facet that the rotors name, once the printed normal and offset are found to be its.
pub fn named(model: &Model, record: &FacetRecord) -> Result<Facet, Rejection> {
    let wrong = |why: String| Err(Rejection::new("the facet", why));
    let generators = Generators::of(model, &record.mode)?;
    let Some(facet) = generators.named(&record.rotors, &record.normal) else {
        return wrong("these rotors name no facet on that side".into());
    };
    let off = |printed: f64, exact: Interval, size: f64| {
        exceeds((Interval::point(printed) - exact).magnitude(), PRINTED * size)
    };
    if let Some(i) = (0..4).find(|&i| off(record.normal[i], facet.normal[i], 1.0)) {
        let axis = ["T", "tau_x", "tau_y", "tau_z"][i];
        let exact = number(facet.normal[i].middle());
        return wrong(format!("the normal's part along {axis} is {exact}, not {}", number(record.normal[i])));
    }
    if off(record.offset, facet.offset, facet.offset.magnitude().max(1.0)) {
        let [exact, printed] = [facet.offset.middle(), record.offset].map(number);
        return wrong(format!("the offset is {exact}, not {printed} (thrusts in N, torques in N m)"));
    }
    Ok(facet)
}
