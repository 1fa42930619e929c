//! Zonotopes `{ c + sum_k t_k g_k : 0 <= t_k <= 1 }` and their exact facets (`docs/method/sets.md`).
//!
//! The normal of a facet is orthogonal to r - 1 independent generators, where r is the dimension of the set, and the
//! offset is the support function. All facets therefore follow from the (r-1)-subsets of the generators; subsets that
//! span the same plane are merged. No convex hull is computed and no vertices are listed.

use super::polytope::{Equality, Facet, Polytope};
use nalgebra::{SMatrix, SVector};

/// A unit direction depends on others if its component orthogonal to them, in scaled coordinates, is at most this.
const DEPENDENT: f64 = 1e-7;
/// A generator lies in the plane of a facet if the component of its unit direction along the normal is at most this.
const IN_PLANE: f64 = 1e-8;

/// The set `{ offset + sum_k t_k generators[k] : 0 <= t_k <= 1 }`, with at most 64 generators.
#[derive(Debug, Clone, PartialEq)]
pub struct Zonotope<const D: usize> {
    /// The vertex at t = 0; not the centre of symmetry.
    pub offset: SVector<f64, D>,
    /// One for each rotor in this crate; zero for a rotor without freedom.
    pub generators: Vec<SVector<f64, D>>,
}

/// The generators that span a facet, as a bit set: bit k stands for generator k.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Spanning(
    /// Bit k is set if generator k lies in the plane of the facet.
    pub u64,
);

impl Spanning {
    /// Indices of the generators, from 0, ascending.
    pub fn generators(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |k| self.0 >> k & 1 == 1)
    }
}

impl<const D: usize> Zonotope<D> {
    /// The support function: the largest `n.w` over the set.
    pub fn support(&self, n: &SVector<f64, D>) -> f64 {
        n.dot(&self.offset) + self.generators.iter().map(|g| n.dot(g).max(0.0)).sum::<f64>()
    }

    /// A vertex that minimises `n.w`.
    pub fn lowest(&self, n: &SVector<f64, D>) -> SVector<f64, D> {
        self.generators.iter().filter(|g| n.dot(g) < 0.0).fold(self.offset, |sum, g| sum + g)
    }

    /// The width along n: the largest minus the smallest `n.w` over the set.
    pub fn width(&self, n: &SVector<f64, D>) -> f64 {
        self.generators.iter().map(|g| n.dot(g).abs()).sum()
    }

    /// The extent `sum_k |g_k,i|` along each axis i, by which coordinates are divided to make them comparable; 1 for an
    /// axis whose extent is rounding error.
    pub fn scale(&self) -> SVector<f64, D> {
        let extent = self.generators.iter().fold(SVector::<f64, D>::zeros(), |sum, g| sum + g.abs());
        let dust = 1e-12 * extent.max();
        extent.map(|e| if e > dust { e } else { 1.0 })
    }

    /// The point of the set nearest to `w` in the plain Euclidean norm.
    pub fn nearest(&self, w: &SVector<f64, D>) -> SVector<f64, D> {
        let size = self.generators.iter().map(nalgebra::Matrix::norm).sum::<f64>() + w.norm();
        let shifted = Zonotope { offset: self.offset - w, generators: self.generators.clone() };
        let start = shifted.lowest(&shifted.offset);
        w + super::nearest::nearest_to_origin(start, |v| shifted.lowest(v), 1e-13 * size)
    }

    /// The dimension of the set's affine hull, and an orthonormal basis of the complement of its directions, both in
    /// scaled coordinates.
    fn frame(&self, scale: &SVector<f64, D>) -> (usize, Vec<SVector<f64, D>>) {
        // Rank-revealing Gram-Schmidt with pivoting on the unit directions.
        let mut left: Vec<SVector<f64, D>> = self.directions(scale).into_iter().flatten().collect();
        let mut basis: Vec<SVector<f64, D>> = Vec::new();
        while let Some(v) = left.iter().copied().max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared())) {
            if v.norm() <= DEPENDENT || basis.len() == D {
                break;
            }
            let b = v.normalize();
            for l in &mut left {
                *l -= b * b.dot(l);
            }
            basis.push(b);
        }
        let rank = basis.len();
        let mut complement = Vec::new();
        while basis.len() < D {
            let axis = (0..D)
                .map(|i| {
                    let mut e = SVector::<f64, D>::zeros();
                    e[i] = 1.0;
                    for _ in 0..2 {
                        for b in &basis {
                            e -= b * b.dot(&e);
                        }
                    }
                    e
                })
                .max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared()))
                .unwrap_or_else(SVector::zeros)
                .normalize();
            basis.push(axis);
            complement.push(axis);
        }
        (rank, complement)
    }

    /// The unit direction of each generator in scaled coordinates; `None` for a zero generator.
    fn directions(&self, scale: &SVector<f64, D>) -> Vec<Option<SVector<f64, D>>> {
        self.generators
            .iter()
            .map(|g| {
                let v = g.component_div(scale);
                (v.norm() > 1e-12).then(|| v.normalize())
            })
            .collect()
    }

    /// The dimension of the set, which is the rank of its generators.
    pub fn rank(&self) -> usize {
        self.frame(&self.scale()).0
    }

    /// The minimal half-space description: one row for each facet, with normals of length 1 in the plain norm, and `D -
    /// rank` equalities if the set is flat. The two facets of each plane are neighbours. The cost is C(n, r-1) n for n
    /// generators and rank r.
    pub fn facets(&self) -> Polytope<D, Spanning> {
        let scale = self.scale();
        let directions = self.directions(&scale);
        let (rank, complement) = self.frame(&scale);
        let used: Vec<usize> = (0..directions.len()).filter(|&k| directions[k].is_some()).collect();
        let equalities = complement
            .iter()
            .map(|c| {
                let normal = c.component_div(&scale).normalize();
                Equality { normal, offset: normal.dot(&self.offset) }
            })
            .collect();
        let mut planes: Vec<(u64, SVector<f64, D>)> = Vec::new();
        if rank > 0 {
            let mut rows = Elimination::new();
            for c in &complement {
                rows.push(c);
            }
            self.planes(&directions, &used, rank - 1, &mut rows, &mut planes);
        }
        planes.sort_by_key(|p| p.0);
        planes.dedup_by_key(|p| p.0);
        let facets = planes
            .iter()
            .flat_map(|(key, n)| {
                let normal = n.component_div(&scale).normalize();
                [normal, -normal].map(|normal| Facet {
                    normal,
                    offset: self.support_outside(&normal, *key),
                    origin: Spanning(*key),
                })
            })
            .collect();
        Polytope { equalities, facets }
    }

    /// The support function without the generators in the plane, which would only add rounding errors.
    fn support_outside(&self, n: &SVector<f64, D>, plane: u64) -> f64 {
        let outside = self.generators.iter().enumerate().filter(|(k, _)| plane >> k & 1 == 0);
        n.dot(&self.offset) + outside.map(|(_, g)| n.dot(g).max(0.0)).sum::<f64>()
    }

    /// Extends `rows` by every subset of `more` generators out of `used` and collects the planes that they span.
    fn planes(
        &self,
        directions: &[Option<SVector<f64, D>>],
        used: &[usize],
        more: usize,
        rows: &mut Elimination<D>,
        planes: &mut Vec<(u64, SVector<f64, D>)>,
    ) {
        if more == 0 {
            let Some(n) = rows.orthogonal() else { return };
            let mut key = 0;
            for (k, d) in directions.iter().enumerate() {
                // A zero generator lies in every plane and spans none.
                if d.is_some_and(|d| n.dot(&d).abs() <= IN_PLANE) {
                    key |= 1 << k;
                }
            }
            planes.push((key, n));
            return;
        }
        for (i, &k) in used.iter().enumerate() {
            let Some(d) = directions[k] else { continue };
            if rows.push(&d) {
                self.planes(directions, &used[i + 1..], more - 1, rows, planes);
                rows.pop();
            }
        }
    }
}

/// A stack of up to D - 1 independent rows in echelon form with column pivoting.
struct Elimination<const D: usize> {
    rows: SMatrix<f64, D, D>,
    pivots: [usize; D],
    count: usize,
}

impl<const D: usize> Elimination<D> {
    fn new() -> Self {
        Elimination { rows: SMatrix::zeros(), pivots: [0; D], count: 0 }
    }

    /// Adds a row unless it depends on those before; returns whether it was added.
    fn push(&mut self, v: &SVector<f64, D>) -> bool {
        if self.count + 1 > D {
            return false;
        }
        let mut row = *v;
        for i in 0..self.count {
            let factor = row[self.pivots[i]];
            if factor != 0.0 {
                for c in 0..D {
                    row[c] -= factor * self.rows[(i, c)];
                }
                row[self.pivots[i]] = 0.0;
            }
        }
        let pivot = row.iamax();
        if row[pivot].abs() <= DEPENDENT {
            return false;
        }
        for c in 0..D {
            self.rows[(self.count, c)] = row[c] / row[pivot];
        }
        self.pivots[self.count] = pivot;
        self.count += 1;
        true
    }

    fn pop(&mut self) {
        self.count -= 1;
    }

    /// The unit vector orthogonal to D - 1 rows; `None` with fewer rows.
    fn orthogonal(&self) -> Option<SVector<f64, D>> {
        if self.count + 1 != D {
            return None;
        }
        let free = (0..D).find(|c| !self.pivots[..self.count].contains(c))?;
        let mut n = SVector::<f64, D>::zeros();
        n[free] = 1.0;
        for i in (0..self.count).rev() {
            let sum: f64 = (0..D).filter(|&c| c != self.pivots[i]).map(|c| self.rows[(i, c)] * n[c]).sum();
            n[self.pivots[i]] = -sum;
        }
        Some(n.normalize())
    }
}
