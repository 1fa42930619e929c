//! Volume of a zonotope from its generators, and of a polytope from its rows (`docs/method/verdicts.md`, "Share of
//! the set lost").

use super::polytope::Polytope;
use super::zonotope::Zonotope;
use nalgebra::{Matrix4, Vector4};

/// Two unit normals are treated as equal if no component differs by more than this.
const SAME: f64 = 1e-9;

impl Zonotope<4> {
    /// The volume: the sum of |det(g_i, g_j, g_k, g_l)| over all sets of four generators, because the corresponding
    /// parallelepipeds tile the zonotope (G. C. Shephard, *Combinatorial properties of associated zonotopes*, 1974). 0
    /// for a flat set.
    pub fn volume(&self) -> f64 {
        let g = &self.generators;
        let n = g.len();
        let mut sum = 0.0;
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    for l in k + 1..n {
                        sum += Matrix4::from_columns(&[g[i], g[j], g[k], g[l]]).determinant().abs();
                    }
                }
            }
        }
        sum
    }
}

impl<O: Clone> Polytope<4, O> {
    /// The volume of a bounded set; 0 for a flat one (J. B. Lasserre, *An analytical expression and an algorithm for
    /// the volume of a convex polyhedron in R^n*, 1983).
    ///
    /// `inside` is a point of the set. `scale` has one positive length for each axis; rows are compared in coordinates
    /// divided by it.
    ///
    /// By Euler's theorem on homogeneous functions `d vol = sum b_i/|a_i| vol(facet i)` for the polytope `a_i.x <= b_i`
    /// of dimension d. The volume of a facet follows in the same way from its projection along an axis, which is a
    /// polytope with one row and one dimension less.
    pub fn volume(&self, inside: &Vector4<f64>, scale: &Vector4<f64>) -> f64 {
        if !self.equalities.is_empty() {
            return 0.0;
        }
        let row =
            |n: &Vector4<f64>, slack: f64| Row { normal: n.component_mul(scale).iter().copied().collect(), slack };
        let rows = self.facets.iter().map(|f| row(&f.normal, f.slack(inside))).collect();
        scale.product() * lasserre(rows, 4)
    }
}

/// `normal . x <= slack`
struct Row {
    normal: Vec<f64>,
    slack: f64,
}

/// Volume of the polytope of these rows in `dimension` dimensions.
fn lasserre(rows: Vec<Row>, dimension: usize) -> f64 {
    let Some(rows) = distinct(rows) else { return 0.0 };
    if dimension == 1 {
        let upper = rows.iter().filter(|r| r.normal[0] > 0.0).map(|r| r.slack).fold(f64::INFINITY, f64::min);
        let lower = rows.iter().filter(|r| r.normal[0] < 0.0).map(|r| -r.slack).fold(f64::NEG_INFINITY, f64::max);
        return (upper - lower).max(0.0);
    }
    let cone = |i: usize| {
        let face = &rows[i];
        if face.slack == 0.0 {
            return 0.0;
        }
        let size = |axis: &usize| face.normal[*axis].abs();
        let along = (0..dimension).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(0);
        let project = |r: &Row| {
            let times = r.normal[along] / face.normal[along];
            let entries = (0..dimension).filter(|axis| *axis != along);
            let normal = entries.map(|axis| r.normal[axis] - times * face.normal[axis]).collect();
            Row { normal, slack: r.slack - times * face.slack }
        };
        let others = rows.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, r)| project(r)).collect();
        face.slack / face.normal[along].abs() * lasserre(others, dimension - 1)
    };
    (0..rows.len()).map(cone).sum::<f64>() / dimension as f64
}

/// Rows with unit normals, keeping only the tightest row of each normal, because projection can produce the same plane
/// twice. `None` if a row is infeasible by itself, so that the set is empty.
fn distinct(rows: Vec<Row>) -> Option<Vec<Row>> {
    let mut kept: Vec<Row> = Vec::new();
    for mut row in rows {
        let length = row.normal.iter().map(|v| v * v).sum::<f64>().sqrt();
        if length <= SAME {
            if row.slack < -SAME {
                return None;
            }
            continue;
        }
        row.normal.iter_mut().for_each(|v| *v /= length);
        row.slack /= length;
        let same = |old: &&mut Row| old.normal.iter().zip(&row.normal).all(|(a, b)| (a - b).abs() < SAME);
        match kept.iter_mut().find(same) {
            Some(old) => old.slack = old.slack.min(row.slack),
            None => kept.push(row),
        }
    }
    Some(kept)
}
