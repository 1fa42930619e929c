//! Half-space descriptions `{ w : C w = d, N w <= e }`, equalities first, and their minimal intersections.

mod rays;
mod shadow;

use super::cone::{Ray, cone_residual, distance_to_cone};
use nalgebra::SVector;
use std::cmp::Ordering;

/// The equality `normal.w = offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Equality<const D: usize> {
    /// Normal of length 1 in the plain norm.
    pub normal: SVector<f64, D>,
    /// Right-hand side.
    pub offset: f64,
}

/// The inequality `normal.w <= offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Facet<const D: usize, O> {
    /// Outward normal of length 1 in the plain norm.
    pub normal: SVector<f64, D>,
    /// Right-hand side.
    pub offset: f64,
    /// Where the row comes from; the caller defines its meaning.
    pub origin: O,
}

impl<const D: usize, O> Facet<D, O> {
    /// Signed distance from `w` to the facet's plane, `offset - normal.w`: positive inside.
    pub fn slack(&self, w: &SVector<f64, D>) -> f64 {
        self.offset - self.normal.dot(w)
    }
}

/// The set of points that satisfy all equalities and all facets.
#[derive(Debug, Clone, PartialEq)]
pub struct Polytope<const D: usize, O> {
    /// Equalities; empty for a full-dimensional set.
    pub equalities: Vec<Equality<D>>,
    /// Inequalities. Whether they are minimal depends on the function that made them.
    pub facets: Vec<Facet<D, O>>,
}

impl<const D: usize, O: Clone> Polytope<D, O> {
    /// The smallest facet slack of `w`. Inside a full-dimensional set this is the distance to the boundary; outside it
    /// is minus the largest violation of a facet, whose absolute value is at most the distance to the set. Infinite for
    /// a set without facets.
    pub fn margin(&self, w: &SVector<f64, D>) -> f64 {
        self.facets.iter().map(|f| f.slack(w)).fold(f64::INFINITY, f64::min)
    }

    /// The largest distance of `w` from the planes of the equalities; 0 for a full-dimensional set.
    pub fn off_plane(&self, w: &SVector<f64, D>) -> f64 {
        self.equalities.iter().map(|e| (e.normal.dot(w) - e.offset).abs()).fold(0.0, f64::max)
    }

    /// Whether `w` violates no row by more than `tolerance`, as a distance from the row's plane.
    pub fn contains(&self, w: &SVector<f64, D>, tolerance: f64) -> bool {
        self.margin(w) >= -tolerance && self.off_plane(w) <= tolerance
    }

    /// The closed interval of parameters t with `start + t direction` in the set; `None` if the line misses the set.
    ///
    /// `tolerance` is the distance by which a plane parallel to the line may be violated, and by which the planes of a
    /// flat set may miss a common parameter. Ends are infinite where the set is unbounded along the line.
    pub fn chord(&self, start: &SVector<f64, D>, direction: &SVector<f64, D>, tolerance: f64) -> Option<(f64, f64)> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let parallel = 1e-12 * direction.norm();
        for e in &self.equalities {
            let (rate, gap) = (e.normal.dot(direction), e.offset - e.normal.dot(start));
            if rate.abs() > parallel {
                low = low.max(gap / rate);
                high = high.min(gap / rate);
            } else if gap.abs() > tolerance {
                return None;
            }
        }
        for f in &self.facets {
            let (rate, gap) = (f.normal.dot(direction), f.slack(start));
            if rate > parallel {
                high = high.min(gap / rate);
            } else if rate < -parallel {
                low = low.max(gap / rate);
            } else if gap < -tolerance {
                return None;
            }
        }
        // The planes of a flat set give the same parameter only up to rounding.
        let slip = tolerance / direction.norm();
        (low <= high + slip).then(|| if low <= high { (low, high) } else { ((low + high) / 2.0, (low + high) / 2.0) })
    }

    /// The rows without their origins.
    pub fn without_origins(&self) -> Polytope<D, ()> {
        let facets = self.facets.iter().map(|f| Facet { normal: f.normal, offset: f.offset, origin: () });
        Polytope { equalities: self.equalities.clone(), facets: facets.collect() }
    }

    /// The set shrunk about `point` by `share` (0 to 1): `{ w : point + (w - point) / (1 - share) in self }`, the
    /// reserve of `docs/method/sets.md`. `point` must satisfy the equalities. Facets that it violates stay as
    /// they are, so that the result is a part of the set in any case.
    pub fn shrink_about(&self, point: &SVector<f64, D>, share: f64) -> Self {
        let mut shrunk = self.clone();
        for f in &mut shrunk.facets {
            let at = f.normal.dot(point);
            f.offset = at + (1.0 - share) * (f.offset - at).max(0.0) + (f.offset - at).min(0.0);
        }
        shrunk
    }
}

/// Two unit normals are treated as equal if no component differs by more than this.
const SAME_NORMAL: f64 = 1e-9;

/// A row is redundant if the distance of its unit ray from the cone of the others is at most this.
const REDUNDANT: f64 = 1e-9;

/// The minimal description of an intersection (`docs/method/sets.md`).
///
/// Dependent equalities are dropped, then of the facets with one normal the one with the smallest offset is kept, then
/// redundant rows are dropped. `inside` is a point of every set. `scale` has one positive length for each axis; normals
/// are compared in coordinates divided by it. The origin of each row lists the origins of all given facets in the same
/// plane.
pub fn intersect<const D: usize, O: Clone>(
    sets: &[&Polytope<D, O>],
    inside: &SVector<f64, D>,
    scale: &SVector<f64, D>,
) -> Polytope<D, Vec<O>> {
    let equalities = independent(sets.iter().flat_map(|s| &s.equalities), scale);
    let mut rows = tightest(sets, scale);
    // A row whose normal lies in the span of the equalities' normals is constant on the set, which holds `inside`.
    rows.retain(|row| remainder(&row.normal, &equalities, scale).norm() > SAME_NORMAL);
    let facets = irredundant(rows, &equalities, inside, scale);
    Polytope { equalities, facets }
}

/// A maximal linearly independent subset, in the given order.
fn independent<'a, const D: usize>(
    all: impl Iterator<Item = &'a Equality<D>>,
    scale: &SVector<f64, D>,
) -> Vec<Equality<D>> {
    let mut kept: Vec<Equality<D>> = Vec::new();
    for e in all {
        if remainder(&e.normal, &kept, scale).norm() > SAME_NORMAL {
            kept.push(e.clone());
        }
    }
    kept
}

/// The component of `normal` (a unit vector in scaled coordinates) orthogonal to the normals of the equalities.
fn remainder<const D: usize>(
    normal: &SVector<f64, D>,
    equalities: &[Equality<D>],
    scale: &SVector<f64, D>,
) -> SVector<f64, D> {
    let mut basis: Vec<SVector<f64, D>> = Vec::new();
    for e in equalities {
        let v = deflate(e.normal.component_mul(scale).normalize(), &basis);
        if v.norm() > SAME_NORMAL {
            basis.push(v.normalize());
        }
    }
    deflate(normal.component_mul(scale).normalize(), &basis)
}

/// The component of `v` orthogonal to an orthonormal basis, by Gram-Schmidt.
fn deflate<const D: usize>(mut v: SVector<f64, D>, basis: &[SVector<f64, D>]) -> SVector<f64, D> {
    // A second pass restores orthogonality to rounding ("twice is enough", Kahan).
    for _ in 0..2 {
        for b in basis {
            v -= b * b.dot(&v);
        }
    }
    v
}

/// One row for each normal: the one with the smallest offset, with the origins of all rows in that plane.
fn tightest<const D: usize, O: Clone>(sets: &[&Polytope<D, O>], scale: &SVector<f64, D>) -> Vec<Facet<D, Vec<O>>> {
    let unit = |f: &Facet<D, O>| f.normal.component_mul(scale).normalize();
    let mut all: Vec<(SVector<f64, D>, &Facet<D, O>)> =
        sets.iter().flat_map(|s| &s.facets).map(|f| (unit(f), f)).collect();
    // Coordinates that agree to rounding compare as equal, so that equal normals are neighbours after sorting.
    let cell = |v: f64| (v / (4.0 * SAME_NORMAL)).round();
    let order = |a: &SVector<f64, D>, b: &SVector<f64, D>| {
        a.iter().zip(b.iter()).map(|(x, y)| cell(*x).total_cmp(&cell(*y))).find(|o| *o != Ordering::Equal)
    };
    all.sort_by(|a, b| order(&a.0, &b.0).unwrap_or(Ordering::Equal));
    let mut groups: Vec<(SVector<f64, D>, Vec<&Facet<D, O>>)> = Vec::new();
    for (n, f) in all {
        // A coordinate may round to either side of a cell boundary, so the preceding groups are searched too.
        let near = groups.iter_mut().rev().take(64).find(|(m, _)| (m - n).amax() < SAME_NORMAL);
        match near {
            Some((_, group)) => group.push(f),
            None => groups.push((n, vec![f])),
        }
    }
    groups
        .into_iter()
        .map(|(_, group)| {
            let tight = group.iter().map(|f| f.offset).fold(f64::INFINITY, f64::min);
            let height = tight.abs().max(1e-6);
            let kept: Vec<_> = group.iter().filter(|f| f.offset <= tight + 1e-9 * height).collect();
            Facet { normal: kept[0].normal, offset: tight, origin: kept.iter().map(|f| f.origin.clone()).collect() }
        })
        .collect()
}

/// Drops every row that the others imply.
///
/// Relative to a point of the set the rows read n.w <= s with slacks s >= 0. Row i is implied by the others if and only
/// if n_i = sum l_j n_j and sum l_j s_j <= s_i for some l >= 0 (Farkas; Ziegler, *Lectures on Polytopes*, section 1.4),
/// that is, if (n_i, s_i) lies in the cone of the other (n_j, s_j) and (0, 1). If a row at distance d from that cone is
/// dropped, a point w that satisfies the others violates it by at most d |(w, 1)|.
fn irredundant<const D: usize, O: Clone>(
    rows: Vec<Facet<D, O>>,
    equalities: &[Equality<D>],
    inside: &SVector<f64, D>,
    scale: &SVector<f64, D>,
) -> Vec<Facet<D, O>> {
    let ray = |r: &Facet<D, O>| {
        let length = r.normal.component_mul(scale).norm();
        Ray::new(remainder(&r.normal, equalities, scale), r.slack(inside).max(0.0) / length)
    };
    let rays: Vec<Ray<D>> = rows.iter().map(ray).collect();
    let (needed, _) = needed(&rays);
    rows.into_iter().zip(needed).filter(|(_, n)| *n).map(|(r, _)| r).collect()
}

/// Which rays are not in the cone of the others and `(0, 1)`, and how many cones of other rays were searched for that.
///
/// Searches of the whole cone take nearly all of the time, so they are left to the rays about which nothing simpler is
/// known. A witness shows that a ray is needed, and one in the cone of the witnessed rays alone is in the larger cone
/// too.
fn needed<const D: usize>(rays: &[Ray<D>]) -> (Vec<bool>, usize) {
    let up = Ray::new(SVector::zeros(), 1.0);
    let is_witnessed: Vec<bool> = (0..rays.len()).map(|i| has_witness(rays, i)).collect();
    let witnessed: Vec<Ray<D>> =
        std::iter::once(up).chain((0..rays.len()).filter(|&i| is_witnessed[i]).map(|i| rays[i])).collect();
    let in_cone = |i: usize, cone: &[Ray<D>]| distance_to_cone(&rays[i], cone, REDUNDANT) <= REDUNDANT;
    let mut needed: Vec<bool> = vec![true; rays.len()];
    let mut searches = 0;
    for i in (0..rays.len()).filter(|&i| !is_witnessed[i]) {
        needed[i] = !in_cone(i, &witnessed) && {
            searches += 1;
            let others = (0..rays.len()).filter(|&j| j != i && needed[j]).map(|j| rays[j]);
            !in_cone(i, &std::iter::once(up).chain(others).collect::<Vec<_>>())
        };
    }
    (needed, searches)
}

/// Projections after which [`has_witness`] gives up; nine of ten facets of the sets of 32 rotors need at most three,
/// measured.
const PROJECTIONS: usize = 12;

/// Each projection leads beyond the row by half of the violation and this share of |(x, 1)|.
const BEYOND: f64 = 1e-4;

/// Whether a point x shows that row i is needed: it lies in the plane of row i and satisfies all others by a `gap`.
/// `(x, -1)` is then negative on every other ray, and after moving x outwards by the gap it is positive on ray i: its
/// distance from the cone of the others is at least `gap |n_i| / (|(x, 1)| + gap)`.
///
/// x starts at the point of the plane nearest to the origin and is projected, within the plane, on the row that it
/// violates most (S. Agmon, *The relaxation method for linear inequalities*, 1954).
fn has_witness<const D: usize>(rays: &[Ray<D>], i: usize) -> bool {
    let (normal, square) = (rays[i].head, rays[i].head.norm_squared());
    let mut x = normal * (rays[i].last / square);
    for _ in 0..PROJECTIONS {
        let violation = |j: usize| rays[j].head.dot(&x) - rays[j].last;
        let others = (0..rays.len()).filter(|&j| j != i).map(|j| (j, violation(j)));
        let Some((worst, violation)) = others.max_by(|a, b| a.1.total_cmp(&b.1)) else { return true };
        let size = x.norm().hypot(1.0);
        let gap = -violation;
        if gap > 0.0 && gap * square.sqrt() > 2.0 * REDUNDANT * (size + gap) {
            return true;
        }
        let across = rays[worst].head - normal * (rays[worst].head.dot(&normal) / square);
        let length = across.norm_squared();
        // A row parallel to row i, or one that touches it nowhere.
        if length <= SAME_NORMAL * SAME_NORMAL {
            return false;
        }
        x -= across * ((1.5 * violation.max(0.0) + BEYOND * size) / length);
    }
    false
}

/// The set is empty if `last` of the residual below is at most this. `last` is the squared length of the residual, and
/// the target has length 1.
const EMPTY: f64 = 1e-12;

impl<const D: usize, O: Clone> Polytope<D, O> {
    /// The point of the set nearest to `w` in the plain Euclidean norm; `None` for an empty set.
    ///
    /// With `x = p - w` the problem is to minimise |x| subject to `n_i.x <= s_i`, where s_i are the slacks at w. Let r
    /// be `(0, 1)` minus its nearest point in the cone of the rays `(-n_i, -s_i)`. Then `x = -r_head / r_last`, and r
    /// is zero if and only if no x is feasible.
    pub fn nearest(&self, w: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        // Slacks are scaled by the largest violation; without a violation w itself is the nearest point.
        let mut rows: Vec<(SVector<f64, D>, f64)> = self.facets.iter().map(|f| (f.normal, f.slack(w))).collect();
        for e in &self.equalities {
            let slack = e.offset - e.normal.dot(w);
            rows.extend([(e.normal, slack), (-e.normal, -slack)]);
        }
        let passed = rows.iter().map(|r| -r.1).fold(0.0, f64::max);
        if passed == 0.0 {
            return Some(*w);
        }
        let rays: Vec<Ray<D>> = rows.iter().map(|(n, slack)| Ray::new(-n, -slack / passed)).collect();
        let rest = cone_residual(&Ray::new(SVector::zeros(), 1.0), &rays, 0.0);
        (rest.last > EMPTY).then(|| w - rest.head * (passed / rest.last))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::zonotope::Zonotope;

    /// The rays that are needed by the definition: each is searched for in the cone of all others that are left.
    fn searched(rays: &[Ray<4>]) -> Vec<bool> {
        let up = Ray::new(SVector::zeros(), 1.0);
        let mut needed = vec![true; rays.len()];
        for i in 0..rays.len() {
            let others = (0..rays.len()).filter(|&j| j != i && needed[j]).map(|j| rays[j]);
            let cone: Vec<Ray<4>> = std::iter::once(up).chain(others).collect();
            needed[i] = distance_to_cone(&rays[i], &cone, REDUNDANT) > REDUNDANT;
        }
        needed
    }

    /// The facets of a zonotope, some of which are copied with a larger offset (redundant), a smaller one, or as they
    /// are.
    #[test]
    fn few_cones_are_searched_and_the_same_rows_are_needed() {
        let mut seed = 11_u64;
        let mut number = || {
            seed = seed * 48_271 % 0x7fff_ffff;
            seed as f64 / f64::from(0x7fff_ffff) - 0.5
        };
        for count in [4, 7, 10] {
            let generators: Vec<_> = (0..count).map(|_| SVector::<f64, 4>::from_fn(|_, _| number())).collect();
            let middle = generators.iter().sum::<SVector<f64, 4>>() * 0.5;
            let facets = Zonotope { offset: -middle, generators }.facets().facets;
            let mut rays: Vec<Ray<4>> = facets.iter().map(|f| Ray::new(f.normal, f.offset)).collect();
            for (i, f) in facets.iter().enumerate().step_by(3) {
                let turned = (f.normal + SVector::from_fn(|_, _| 0.1 * number())).normalize();
                let longer = [1.5, 1.0, 0.97][i % 3];
                rays.push(Ray::new(turned, longer * f.offset));
            }
            let (found, searches) = needed(&rays);
            assert_eq!(found, searched(&rays), "{count} generators");
            assert!(found.contains(&false) && 10 * searches <= rays.len(), "{searches} of {} rays", rays.len());
        }
    }
}
