//! The projection of a polytope by outer approximation: rows are found where rays from an inner point leave it.
//!
//! ```text
//! P = a box around the projection
//! while P has a vertex v that is not known to be in the projection:
//!     t = where the ray to v leaves the projection       the linear program max t, w_4 free
//!     t >= 1:  v is in the projection
//!     t < 1:   P = P without the part beyond the row that is active at t
//! ```
//!
//! Elimination has a row for each pair of facets, a million for the sets of 32 rotors; here the work is that of the
//! rows and vertices of the projection, about 2,000, times the number of facets.

use super::Facet;
use nalgebra::{Matrix3, Vector3, Vector4};
use std::collections::HashMap;

/// A vertex is in the projection if the ray to it leaves at least at this share of its length.
const REACHED: f64 = 1.0 - 1e-9;

/// Half the side of the first box, in units of the scale.
const BOX: f64 = 1e3;

/// Offsets are moved outwards by up to this share, so that no more than three planes meet in a vertex.
const MOVED: f64 = 1e-11;

/// More rows than this are not searched for.
const MOST_ROWS: usize = 20_000;

/// The row `head.v + last t <= offset`, scaled so that its largest coefficient in units of `scale` is 1.
#[derive(Clone, Copy)]
pub(super) struct Row {
    pub head: Vector3<f64>,
    pub last: f64,
    pub offset: f64,
}

impl Row {
    pub fn new(normal: &Vector4<f64>, offset: f64, scale: &Vector4<f64>) -> Self {
        let size = normal.component_mul(scale).amax();
        Row { head: normal.fixed_rows::<3>(0) / size, last: normal[3] / size, offset: offset / size }
    }

    /// The sum of this row and `times` the other one.
    pub fn plus(&self, other: &Row, times: f64) -> Row {
        Row {
            head: self.head + other.head * times,
            last: self.last + other.last * times,
            offset: self.offset + other.offset * times,
        }
    }

    pub fn as_facet(&self) -> Facet<3, ()> {
        let length = self.head.norm();
        Facet { normal: self.head / length, offset: self.offset / length, origin: () }
    }
}

/// A vertex of the outer approximation: the three rows that meet in it.
struct Vertex {
    rows: [usize; 3],
    at: Vector3<f64>,
    /// Whether it is known to be in the projection.
    reached: bool,
}

/// The outer approximation `{ y : normal.y <= offset }`; the first six rows are the box.
struct Outer {
    rows: Vec<(Vector3<f64>, f64)>,
    vertices: Vec<Vertex>,
}

impl Outer {
    fn new() -> Self {
        let signs = [-1.0, 1.0];
        let rows = (0..3).flat_map(|axis| signs.map(|sign| (Vector3::ith(axis, sign), BOX))).collect();
        let corner = |i: usize| {
            let side = [i & 1, i >> 1 & 1, i >> 2];
            let at = Vector3::from_fn(|axis, _| BOX * signs[side[axis]]);
            Vertex { rows: [side[0], 2 + side[1], 4 + side[2]], at, reached: false }
        };
        Outer { rows, vertices: (0..8).map(corner).collect() }
    }

    /// Where three planes meet; `None` if two of them are parallel.
    fn meeting(&self, rows: [usize; 3]) -> Option<Vector3<f64>> {
        let planes = rows.map(|row| &self.rows[row]);
        let normals = Matrix3::from_rows(&planes.map(|plane| plane.0.transpose()));
        normals.lu().solve(&Vector3::from(planes.map(|plane| plane.1)))
    }

    /// Cuts off what violates a row. Each edge that has one end beyond it gets a vertex; `None` if that is not found.
    fn cut(&mut self, normal: Vector3<f64>, offset: f64) -> Option<()> {
        let new = self.rows.len();
        // Fractions of the golden ratio are spread evenly and never repeat.
        let moved = 1.0 + MOVED * (new as f64 * 0.618_033_988_749_895).fract();
        self.rows.push((normal, offset * moved));
        let is_beyond = |v: &Vertex| normal.dot(&v.at) > offset * moved;
        let (beyond, kept): (Vec<Vertex>, Vec<Vertex>) = self.vertices.drain(..).partition(is_beyond);
        self.vertices = kept;
        let mut ends: HashMap<[usize; 2], usize> = HashMap::new();
        for [a, b, c] in beyond.iter().map(|v| v.rows) {
            for edge in [[a, b], [a, c], [b, c]] {
                *ends.entry(edge).or_default() += 1;
            }
        }
        let mut crossing: Vec<[usize; 2]> = ends.into_iter().filter(|(_, ends)| *ends == 1).map(|(e, _)| e).collect();
        crossing.sort_unstable();
        for [a, b] in crossing {
            let at = self.meeting([a, b, new])?;
            self.vertices.push(Vertex { rows: [a, b, new], at, reached: false });
        }
        Some(())
    }
}

/// The rows of the projection on the first three axes of `{ w : head.w + last w_4 <= offset }`, each a row or the sum
/// of two rows without w_4, and possibly a few that are implied by others. Lengths are divided by a scale and measured
/// from an inner point, so that offsets are positive. `None` if the projection is unbounded or the point on its
/// boundary.
pub(super) fn projected(rows: &[Row]) -> Option<Vec<Row>> {
    if rows.iter().any(|row| row.offset <= MOVED) {
        return None;
    }
    let mut outer = Outer::new();
    let mut found = Vec::new();
    while let Some(next) = outer.vertices.iter().position(|v| !v.reached) {
        let Some(row) = leaving(rows, &outer.vertices[next].at) else {
            outer.vertices[next].reached = true;
            continue;
        };
        let length = row.head.norm();
        outer.cut(row.head / length, row.offset / length)?;
        found.push(row);
        if found.len() > MOST_ROWS {
            return None;
        }
    }
    let is_bounded = outer.vertices.iter().all(|v| v.rows.iter().all(|&row| row >= 6));
    is_bounded.then_some(found)
}

/// The row through which the ray from 0 to y leaves the projection before it reaches y, if it does.
///
/// Along the ray a pair of rows leaves w_4 an interval, whose length is linear in t. The least of them over all pairs
/// is concave in t, so that Newton's steps from a point outside descend to its zero and end at a pair that is active
/// there.
fn leaving(rows: &[Row], y: &Vector3<f64>) -> Option<Row> {
    // (growth, last, row): growth t + last w_4 <= offset on the ray.
    let along: Vec<(f64, &Row)> = rows.iter().map(|row| (row.head.dot(y), row)).collect();
    let (mut t, mut active) = (1.0, None);
    for &(growth, row) in along.iter().filter(|(_, row)| row.last == 0.0) {
        if growth * t > row.offset {
            (t, active) = (row.offset / growth, Some(*row));
        }
    }
    loop {
        let (mut upper, mut lower) = ((f64::INFINITY, None), (f64::NEG_INFINITY, None));
        for &(growth, row) in along.iter().filter(|(_, row)| row.last != 0.0) {
            let bound = (row.offset - growth * t) / row.last;
            if row.last > 0.0 && bound < upper.0 {
                upper = (bound, Some(row));
            } else if row.last < 0.0 && bound > lower.0 {
                lower = (bound, Some(row));
            }
        }
        let ((high, Some(u)), (low, Some(l))) = (upper, lower) else { break };
        let pair = u.plus(l, -u.last / l.last);
        let growth = pair.head.dot(y);
        if low <= high || growth <= 0.0 || pair.offset / growth >= t {
            break;
        }
        (t, active) = (pair.offset / growth, Some(pair));
    }
    active.filter(|_| t < REACHED)
}

#[cfg(test)]
mod tests {
    use crate::geometry::polytope::{Facet, Polytope, intersect};
    use crate::geometry::zonotope::Zonotope;
    use nalgebra::{Vector3, Vector4};

    fn random(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state * 48_271 % 0x7fff_ffff;
            state as f64 / f64::from(0x7fff_ffff) - 0.5
        }
    }

    /// The set of rotors evenly on a circle, in which many facets meet at a vertex, or of random generators.
    fn set(count: usize, number: Option<&mut dyn FnMut() -> f64>) -> Zonotope<4> {
        let on_circle = |k: usize| {
            let (angle, sign) = (std::f64::consts::TAU * k as f64 / count as f64, [1.0, -1.0][k % 2]);
            Vector4::new(1.0, angle.sin(), -angle.cos(), 0.1 * sign)
        };
        let generators: Vec<Vector4<f64>> = match number {
            Some(number) => (0..count).map(|_| Vector4::from_fn(|_, _| number())).collect(),
            None => (0..count).map(on_circle).collect(),
        };
        Zonotope { offset: -generators.iter().sum::<Vector4<f64>>() * 0.5, generators }
    }

    /// The rows of `{ w : w moved by +-shear T along the last axis is in the set }`.
    fn sheared(set: &Polytope<4, ()>, shear: f64) -> Polytope<4, ()> {
        let row = |f: &Facet<4, ()>| {
            let normal = f.normal + Vector4::x() * (f.normal[3].abs() * shear);
            Facet { normal: normal / normal.norm(), offset: f.offset / normal.norm(), origin: () }
        };
        Polytope { equalities: Vec::new(), facets: set.facets.iter().map(row).collect() }
    }

    fn same(a: &Polytope<3, ()>, b: &Polytope<3, ()>) {
        assert_eq!(a.facets.len(), b.facets.len());
        for f in &a.facets {
            let near = |g: &Facet<3, ()>| (f.normal - g.normal).amax() < 1e-8 && (f.offset - g.offset).abs() < 1e-8;
            assert!(b.facets.iter().any(near), "{f:?}");
        }
    }

    /// Against elimination, and the facets of the projected generators.
    #[test]
    fn the_rows_are_those_of_elimination() {
        let mut number = random(5);
        for (count, is_random) in [(4, false), (6, false), (8, false), (5, true), (8, true)] {
            let zonotope = set(count, is_random.then_some(&mut number as &mut dyn FnMut() -> f64));
            let (whole, scale) = (zonotope.facets().without_origins(), zonotope.scale());
            let inside = Vector4::from_fn(|i, _| 0.05 * scale[i] * number());
            let heads = zonotope.generators.iter().map(|g| g.fixed_rows::<3>(0).into_owned()).collect();
            let head = Zonotope { offset: zonotope.offset.fixed_rows::<3>(0).into_owned(), generators: heads };
            let rows = whole.shadow_by_rays(&inside, &scale).unwrap();
            let scale3 = scale.fixed_rows::<3>(0).into_owned();
            let rows = Polytope { equalities: Vec::new(), facets: rows };
            let found = intersect(&[&rows], &inside.fixed_rows::<3>(0).into_owned(), &scale3).without_origins();
            same(&found, &head.facets().without_origins());
            let tight = sheared(&whole, 0.01);
            let middle3: Vector3<f64> = inside.fixed_rows::<3>(0).into_owned();
            let pairs = intersect(&[&tight.shadow(None, &scale)], &middle3, &scale3).without_origins();
            same(&tight.shadow(Some(&inside), &scale), &pairs);
        }
    }

    #[test]
    fn without_an_inner_point_or_a_bound_there_are_no_rows() {
        let zonotope = set(8, None);
        let (mut whole, scale) = (zonotope.facets().without_origins(), zonotope.scale());
        let vertex = zonotope.offset + zonotope.generators.iter().sum::<Vector4<f64>>();
        assert!(whole.shadow_by_rays(&vertex, &scale).is_none());
        whole.facets.retain(|f| f.normal[0] < 1e-9);
        assert!(whole.shadow_by_rays(&Vector4::zeros(), &scale).is_none());
    }
}
