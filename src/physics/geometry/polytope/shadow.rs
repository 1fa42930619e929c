//! The projection ("shadow") of a polytope along its last axis, by Fourier-Motzkin elimination (Ziegler, *Lectures on
//! Polytopes*, section 1.2).

use super::{Equality, Facet, Polytope, intersect};
use nalgebra::{SVector, Vector3, Vector4};

/// A coefficient of a row, scaled so that the largest is 1, counts as zero at or below this.
const NONE: f64 = 1e-12;

/// The row `head.v + last t <= offset`, scaled so that its largest coefficient in units of `scale` is 1.
#[derive(Clone, Copy)]
struct Row {
    head: Vector3<f64>,
    last: f64,
    offset: f64,
}

impl Row {
    fn new(normal: &Vector4<f64>, offset: f64, scale: &Vector4<f64>) -> Self {
        let size = normal.component_mul(scale).amax();
        Row { head: normal.fixed_rows::<3>(0) / size, last: normal[3] / size, offset: offset / size }
    }

    /// The sum of this row and `times` the other one.
    fn plus(&self, other: &Row, times: f64) -> Row {
        Row {
            head: self.head + other.head * times,
            last: self.last + other.last * times,
            offset: self.offset + other.offset * times,
        }
    }

    fn as_facet(&self) -> Facet<3, ()> {
        let length = self.head.norm();
        Facet { normal: self.head / length, offset: self.offset / length, origin: () }
    }
}

impl<O: Clone> Polytope<4, O> {
    /// The projection on the first three axes: all (w_1, w_2, w_3) such that (w_1, w_2, w_3, w_4) is in the set for
    /// some w_4.
    ///
    /// `inside` is a point of the set if there is one; the rows are minimal in that case. `scale` has one positive
    /// length for each axis.
    pub fn shadow(&self, inside: Option<&Vector4<f64>>, scale: &Vector4<f64>) -> Polytope<3, ()> {
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
        let scale3: Vector3<f64> = scale.fixed_rows::<3>(0).into_owned();
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
}

fn equality<const D: usize>(facet: Facet<D, ()>) -> Equality<D> {
    let normal: SVector<f64, D> = facet.normal;
    Equality { normal, offset: facet.offset }
}
