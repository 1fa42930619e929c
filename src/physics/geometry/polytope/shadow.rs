//! The projection ("shadow") of a polytope along its last axis, by [`rays`], or for a flat set by Fourier-Motzkin
//! elimination (Ziegler, *Lectures on Polytopes*, section 1.2).

use super::rays::{self, Row};
use super::{Equality, Facet, Polytope, intersect};
use nalgebra::{SVector, Vector3, Vector4};

/// A coefficient of a row, scaled so that the largest is 1, counts as zero at or below this.
const NONE: f64 = 1e-12;

impl<O: Clone> Polytope<4, O> {
    /// The projection on the first three axes: all (w_1, w_2, w_3) such that (w_1, w_2, w_3, w_4) is in the set for
    /// some w_4.
    ///
    /// `inside` is a point of the set if there is one; the rows are minimal in that case. `scale` has one positive
    /// length for each axis.
    pub fn shadow(&self, inside: Option<&Vector4<f64>>, scale: &Vector4<f64>) -> Polytope<3, ()> {
        let scale3: Vector3<f64> = scale.fixed_rows::<3>(0).into_owned();
        if let Some(inside) = inside
            && let Some(facets) = self.shadow_by_rays(inside, scale)
        {
            let whole = Polytope { equalities: Vec::new(), facets };
            return intersect(&[&whole], &inside.fixed_rows::<3>(0).into_owned(), &scale3).without_origins();
        }
        let row = |normal: &Vector4<f64>, offset: f64| Row::new(normal, offset, scale);
        let mut equal: Vec<Row> = self.equalities.iter().map(|e| row(&e.normal, e.offset)).collect();
        let mut rows: Vec<Row> = self.facets.iter().map(|f| row(&f.normal, f.offset)).collect();
        let depends = |r: &Row| r.last.abs() * scale[3] > NONE;
        if let Some(pivot) = equal.iter().position(depends) {
            // This equality determines w_4; it is substituted in the other rows.
            let pivot = equal.swap_remove(pivot);
            for r in equal.iter_mut().chain(&mut rows) {
                *r = r.plus(&pivot, -r.last / pivot.last);
            }
        } else {
            let (upper, other): (Vec<Row>, Vec<Row>) = rows.iter().partition(|r| depends(r) && r.last > 0.0);
            let (lower, free): (Vec<Row>, Vec<Row>) = other.iter().partition(|r| depends(r));
            rows = free;
            for u in &upper {
                rows.extend(lower.iter().map(|l| u.plus(l, -u.last / l.last)));
            }
        }
        let counts = |r: &Row| r.head.component_mul(&scale3).amax() > NONE;
        let whole = Polytope {
            equalities: equal.iter().filter(|r| counts(r)).map(Row::as_facet).map(equality).collect(),
            facets: rows.iter().filter(|r| counts(r)).map(Row::as_facet).collect(),
        };
        match inside {
            Some(w) => intersect(&[&whole], &w.fixed_rows::<3>(0).into_owned(), &scale3).without_origins(),
            None => whole,
        }
    }

    /// Rows of the projection by [`rays::projected`]; `None` for a flat set and for a point on the boundary.
    pub(super) fn shadow_by_rays(&self, inside: &Vector4<f64>, scale: &Vector4<f64>) -> Option<Vec<Facet<3, ()>>> {
        if !self.equalities.is_empty() {
            return None;
        }
        let scaled = |f: &Facet<4, O>| {
            let normal = f.normal.component_mul(scale);
            let row = Row::new(&normal, f.slack(inside), &Vector4::repeat(1.0));
            Row { last: if row.last.abs() > NONE { row.last } else { 0.0 }, ..row }
        };
        let rows: Vec<Row> = self.facets.iter().map(scaled).collect();
        let (scale, inside) = (scale.fixed_rows::<3>(0), inside.fixed_rows::<3>(0));
        let facet = |row: Row| {
            let head = row.head.component_div(&scale);
            Row { head, offset: row.offset + head.dot(&inside), ..row }.as_facet()
        };
        Some(rays::projected(&rows)?.into_iter().map(facet).collect())
    }

    /// The projection of the points whose last coordinate lies from `low` to `high`, given the `shadow` of all points.
    /// Its rows are not minimal.
    ///
    /// By elimination they come from pairs of rows. The pairs of two rows of the set itself, a million for 2,000
    /// facets, do not depend on the bounds: they describe the shadow. Each other row is one row of the set at one of
    /// the bounds.
    pub fn shadow_between(
        &self,
        shadow: &Polytope<3, ()>,
        [low, high]: [f64; 2],
        scale: &Vector4<f64>,
    ) -> Polytope<3, ()> {
        let bounds = [(-1.0, -low), (1.0, high)];
        let [at_low, at_high] = bounds.map(|(sign, offset)| Row::new(&(Vector4::w() * sign), offset, scale));
        let at_bound = |normal: &Vector4<f64>, offset: f64| {
            let row = Row::new(normal, offset, scale);
            let bound = if row.last > 0.0 { &at_low } else { &at_high };
            (row.last.abs() * scale[3] > NONE).then(|| row.plus(bound, -row.last / bound.last))
        };
        let sides = |e: &Equality<4>| [(e.normal, e.offset), (-e.normal, -e.offset)];
        let rows = self.facets.iter().map(|f| (f.normal, f.offset)).chain(self.equalities.iter().flat_map(sides));
        let rows = rows.filter_map(|(normal, offset)| at_bound(&normal, offset));
        let scale3: Vector3<f64> = scale.fixed_rows::<3>(0).into_owned();
        let rows = rows.filter(|row| row.head.component_mul(&scale3).amax() > NONE);
        let facets = shadow.facets.iter().cloned().chain(rows.map(|row| row.as_facet())).collect();
        Polytope { equalities: shadow.equalities.clone(), facets }
    }
}

fn equality<const D: usize>(facet: Facet<D, ()>) -> Equality<D> {
    let normal: SVector<f64, D> = facet.normal;
    Equality { normal, offset: facet.offset }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::zonotope::Zonotope;

    /// Against the elimination with the bounds as two more rows of the set.
    #[test]
    fn shadows_between_bounds_have_one_row_for_each_facet_at_a_bound() {
        let mut seed = 5_u64;
        let mut number = || {
            seed = seed * 48_271 % 0x7fff_ffff;
            seed as f64 / f64::from(0x7fff_ffff) - 0.5
        };
        // The last two are flat: in one the fourth coordinate follows from the others, in the other a first one is 0.
        for (count, flat) in [(5, None), (9, None), (14, None), (6, Some(3)), (6, Some(1))] {
            let mut generators: Vec<_> = (0..count).map(|_| Vector4::from_fn(|_, _| number())).collect();
            for g in &mut generators {
                match flat {
                    Some(3) => g[3] = 0.3 * g[0] - 0.2 * g[2],
                    Some(axis) => g[axis] = 0.0,
                    None => {}
                }
            }
            let middle = generators.iter().sum::<Vector4<f64>>() * 0.5;
            let heads = generators.iter().map(|g| g.fixed_rows::<3>(0).into_owned()).collect();
            let shadow = Zonotope { offset: -middle.fixed_rows::<3>(0).into_owned(), generators: heads };
            let shadow = shadow.facets().without_origins();
            let zonotope = Zonotope { offset: -middle, generators };
            let (set, scale) = (zonotope.facets().without_origins(), zonotope.scale());
            let reach = 0.5 * zonotope.width(&Vector4::w());
            let [low, high] = [-0.4 * reach, 0.1 * reach];
            let bound = |sign: f64, offset: f64| Facet { normal: Vector4::w() * sign, offset, origin: () };
            let mut bounded = set.clone();
            bounded.facets.extend([bound(1.0, high), bound(-1.0, -low)]);
            let (pairs, found) = (bounded.shadow(None, &scale), set.shadow_between(&shadow, [low, high], &scale));
            assert!(found.facets.len() <= set.facets.len() + 2 * set.equalities.len() + shadow.facets.len());
            for _ in 0..2_000 {
                let mut p = Vector3::from_fn(|i, _| 1.2 * scale[i] * number());
                if let Some(axis) = flat.filter(|&axis| axis < 3) {
                    p[axis] = 0.0;
                }
                let (one, other) = (pairs.margin(&p), found.margin(&p));
                // Outside, rows that no point of the set touches may be violated more.
                assert!((one > 1e-9) == (other > 1e-9) || one.abs().min(other.abs()) < 1e-8, "{one} {other}");
                assert!(one < 0.0 || (one - other).abs() < 1e-9, "{one} {other}");
            }
        }
    }
}
