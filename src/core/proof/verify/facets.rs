//! Facets as certificates print them: rotors, with the normal and offset that follow from them.

use super::Rejection;
use super::interval::{Interval, exceeds};
use super::sets::{Facet, Generators, Plane};
use crate::certificate::FacetRecord;
use crate::number::number;

/// Printed normals and offsets may differ by this share.
const PRINTED: f64 = 1e-9;

/// The facet that the rotors name in the set of its mode, whose generators are given. With `strict`, the printed normal
/// and offset are compared with it.
///
/// # Errors
/// The rotors name no facet, or the printed numbers are not those of the facet.
pub fn named(generators: &Generators, record: &FacetRecord, strict: bool) -> Result<Facet, Rejection> {
    let wrong = |why: String| Err(Rejection::new("the facet", why));
    let Some(facet) = generators.named(&record.rotors, &record.normal) else {
        return wrong("these rotors name no facet on that side".into());
    };
    if !strict {
        return Ok(printed_as(record, facet));
    }
    let off = |printed: f64, exact: Interval, size: f64| {
        exceeds((Interval::point(printed) - exact).magnitude(), PRINTED * size)
    };
    if let Some(i) = (0..4).find(|&i| off(record.normal[i], facet.normal[i], 1.0)) {
        let axis = ["T", "tau_x", "tau_y", "tau_z"][i];
        let exact = number(facet.normal[i].middle());
        return wrong(format!("the normal's component along {axis} is {exact}, not {}", number(record.normal[i])));
    }
    if off(record.offset, facet.offset, facet.offset.magnitude().max(1.0)) {
        let [exact, printed] = [facet.offset.middle(), record.offset].map(number);
        return wrong(format!("the offset is {exact}, not {printed} (thrusts in N, torques in N m)"));
    }
    Ok(facet)
}

/// The facet with the printed normal and offset, right or wrong.
fn printed_as(record: &FacetRecord, facet: Facet) -> Facet {
    let scale = |printed: f64, exact: Interval, of: Interval| match exact.contains(0.0) {
        true => of,
        false => of * (Interval::point(printed) / exact),
    };
    let plane = Plane { offset: scale(record.offset, facet.offset, facet.plane.offset), ..facet.plane };
    Facet { plane, ..facet }
}
