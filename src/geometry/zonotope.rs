//! Zonotopes `{ c + sum_k t_k g_k : 0 <= t_k <= 1 }` and their exact facets.
//!
//! A facet's normal is orthogonal to r - 1 independent generators, r the dimension of the set; the offset
//! is the support function. So all facets follow from the (r-1)-subsets of the generators, merged where they
//! span one plane: no hull, no vertices.

use super::polytope::{Equality, Facet, Polytope};
use nalgebra::{SMatrix, SVector};

/// Directions closer to dependence than this (in scaled coordinates) count as dependent.
const DEPENDENT: f64 = 1e-7;
/// A generator lies in a facet's plane when its unit direction leaves it by less.
const IN_PLANE: f64 = 1e-8;

/// At most 64 generators.
#[derive(Debug, Clone, PartialEq)]
pub struct Zonotope<const D: usize> {
    pub center: SVector<f64, D>,
    pub generators: Vec<SVector<f64, D>>,
}

/// The generators that span a facet: bit k stands for generator k.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Spanning(pub u64);

impl Spanning {
    /// Generators counted from 0.
    pub fn generators(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |k| self.0 >> k & 1 == 1)
    }
}

impl<const D: usize> Zonotope<D> {
    /// Largest `n.w` over the set.
    pub fn support(&self, n: &SVector<f64, D>) -> f64 {
        n.dot(&self.center) + self.generators.iter().map(|g| n.dot(g).max(0.0)).sum::<f64>()
    }

    /// A vertex with the smallest `n.w`.
    pub fn lowest(&self, n: &SVector<f64, D>) -> SVector<f64, D> {
        self.generators.iter().filter(|g| n.dot(g) < 0.0).fold(self.center, |sum, g| sum + g)
    }

    /// Width along n: the largest minus the smallest `n.w`.
    pub fn width(&self, n: &SVector<f64, D>) -> f64 {
        self.generators.iter().map(|g| n.dot(g).abs()).sum()
    }

    /// Extent along each axis, so that coordinates divided by it are of like size; 1 where the set has none
    /// but rounding dust.
    pub fn scale(&self) -> SVector<f64, D> {
        let extent = self.generators.iter().fold(SVector::<f64, D>::zeros(), |sum, g| sum + g.abs());
        let dust = 1e-12 * extent.max();
        extent.map(|e| if e > dust { e } else { 1.0 })
    }

    /// Point of the set nearest to `w` in the plain Euclidean norm.
    pub fn nearest(&self, w: &SVector<f64, D>) -> SVector<f64, D> {
        let size = self.generators.iter().map(nalgebra::Matrix::norm).sum::<f64>() + w.norm();
        let shifted = Zonotope { center: self.center - w, generators: self.generators.clone() };
        let start = shifted.lowest(&shifted.center);
        w + super::nearest::nearest_to_origin(start, |v| shifted.lowest(v), 1e-13 * size)
    }

    /// Dimension of the set's affine hull, its unit directions and an orthonormal complement, in scaled
    /// coordinates.
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

    /// Unit direction of each generator in scaled coordinates; `None` for a zero generator.
    fn directions(&self, scale: &SVector<f64, D>) -> Vec<Option<SVector<f64, D>>> {
        self.generators
            .iter()
            .map(|g| {
                let v = g.component_div(scale);
                (v.norm() > 1e-12).then(|| v.normalize())
            })
            .collect()
    }

    /// Dimension of the set (the rank of its generators).
    pub fn rank(&self) -> usize {
        self.frame(&self.scale()).0
    }

    /// The minimal half-space description: one row per facet, unit normals in the plain norm; equality rows
    /// where the set is flat. Cost: C(n, r-1) n for n generators and rank r.
    pub fn facets(&self) -> Polytope<D, Spanning> {
        let scale = self.scale();
        let directions = self.directions(&scale);
        let (rank, complement) = self.frame(&scale);
        let used: Vec<usize> = (0..directions.len()).filter(|&k| directions[k].is_some()).collect();
        let equalities = complement
            .iter()
            .map(|c| {
                let normal = c.component_div(&scale).normalize();
                Equality { normal, offset: normal.dot(&self.center) }
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

    /// The support function, leaving out the generators in the plane, which only add rounding.
    fn support_outside(&self, n: &SVector<f64, D>, plane: u64) -> f64 {
        let outside = self.generators.iter().enumerate().filter(|(k, _)| plane >> k & 1 == 0);
        n.dot(&self.center) + outside.map(|(_, g)| n.dot(g).max(0.0)).sum::<f64>()
    }

    /// Walks all `more`-subsets of the used generators, eliminating as it goes.
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
                // A zero generator lies in every plane; it spans none.
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

/// Up to D - 1 independent rows in echelon form with column pivoting, grown and shrunk at the end.
struct Elimination<const D: usize> {
    rows: SMatrix<f64, D, D>,
    pivots: [usize; D],
    count: usize,
}

impl<const D: usize> Elimination<D> {
    fn new() -> Self {
        Elimination { rows: SMatrix::zeros(), pivots: [0; D], count: 0 }
    }

    /// Adds a row unless it depends on those before.
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

    /// The unit vector orthogonal to D - 1 rows.
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
