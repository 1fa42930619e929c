//! Parallel planes: those of several modes through the same three generators, of which only the innermost has to be
//! looked at.

use super::{Plane, planes_at_most};
use crate::model::{Allocation, Vehicle};
use std::collections::HashMap;

/// For each plane the innermost one that is parallel to it, possibly itself: what stays inside that one by some bound
/// stays inside this one. Normals count as parallel if they have the same enclosure, because a bound is computed for
/// all vectors of an enclosure.
pub fn innermost(planes: &[&Plane]) -> Vec<usize> {
    let direction = |plane: &Plane| plane.normal.map(|part| [part.low, part.high].map(f64::to_bits));
    let mut innermost: HashMap<_, usize> = HashMap::new();
    for (index, plane) in planes.iter().enumerate() {
        let known = innermost.entry(direction(plane)).or_insert(index);
        if plane.offset.low < planes[*known].offset.low {
            *known = index;
        }
    }
    // A plane whose offset is not a number is its own.
    let is_outside = |index: usize, inner: usize| planes[inner].offset.low <= planes[index].offset.low;
    let of_plane = |(index, plane): (usize, &&Plane)| {
        innermost.get(&direction(plane)).copied().filter(|&inner| is_outside(index, inner)).unwrap_or(index)
    };
    planes.iter().enumerate().map(of_plane).collect()
}

/// Most planes through three of `n` generators.
pub(super) fn through_three_at_most(n: u64) -> u64 {
    n * n.saturating_sub(1) * n.saturating_sub(2) / 3
}

/// Most planes of some modes' sets that [`innermost`] leaves: those through three generators are parallel.
pub fn innermost_at_most(vehicle: &Vehicle, sets: u64) -> u64 {
    let all = planes_at_most(vehicle);
    let n = vehicle.rotors.len() as u64;
    let parallel = match vehicle.allocation {
        Allocation::PseudoInverse => 0,
        _ => through_three_at_most(n),
    };
    (all - parallel).saturating_mul(sets).saturating_add(parallel)
}
