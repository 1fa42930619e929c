//! The convex program every planner ends in, in the solver's standard form, and every row's origin.
//!
//! minimise 1/2 x'P x + q'x + constant  subject to  A x + s = b, s in K,
//! K a product of {0}, the nonnegative orthant and second-order cones, in that order.

pub mod build;
pub mod mps;

use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// Compressed sparse columns; row indices ascend within a column.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sparse {
    pub rows: usize,
    pub cols: usize,
    pub colptr: Vec<usize>,
    pub rowval: Vec<usize>,
    pub nzval: Vec<f64>,
}

/// Entries in ascending order of their rows, those of one row in the order given.
fn sorted_by_row(rows: usize, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
    let mut next = vec![0usize; rows + 1];
    for &(r, _, _) in entries {
        next[r + 1] += 1;
    }
    for r in 0..rows {
        next[r + 1] += next[r];
    }
    let mut sorted = vec![(0usize, 0usize, 0.0f64); entries.len()];
    for &entry in entries {
        sorted[next[entry.0]] = entry;
        next[entry.0] += 1;
    }
    sorted
}

impl Sparse {
    /// From (row, column, value) entries in any order; entries at one place add up.
    pub fn from_entries(rows: usize, cols: usize, entries: &[(usize, usize, f64)]) -> Self {
        // Counting sort by row, where they are not in that order anyway, then by column: linear, and rows come out
        // ascending in each column.
        let by_row = if entries.is_sorted_by_key(|e| e.0) { None } else { Some(sorted_by_row(rows, entries)) };
        let entries = by_row.as_deref().unwrap_or(entries);
        let mut start = vec![0usize; cols + 1];
        for &(_, c, _) in entries {
            start[c + 1] += 1;
        }
        for c in 0..cols {
            start[c + 1] += start[c];
        }
        let mut next = start.clone();
        let mut sorted = vec![(0usize, 0.0f64); entries.len()];
        for &(r, c, v) in entries {
            sorted[next[c]] = (r, v);
            next[c] += 1;
        }
        let mut sparse = Sparse { rows, cols, colptr: vec![0], rowval: Vec::new(), nzval: Vec::new() };
        for c in 0..cols {
            let first = sparse.rowval.len();
            for &(r, v) in &sorted[start[c]..start[c + 1]] {
                if sparse.rowval.len() > first && sparse.rowval.last() == Some(&r) {
                    if let Some(last) = sparse.nzval.last_mut() {
                        *last += v;
                    }
                } else {
                    sparse.rowval.push(r);
                    sparse.nzval.push(v);
                }
            }
            sparse.colptr.push(sparse.rowval.len());
        }
        sparse
    }

    /// y += M x.
    pub fn multiply_into(&self, x: &[f64], y: &mut [f64]) {
        for (c, &v) in x.iter().enumerate() {
            for i in self.colptr[c]..self.colptr[c + 1] {
                y[self.rowval[i]] += self.nzval[i] * v;
            }
        }
    }

    /// M' x.
    pub fn transposed_times(&self, x: &[f64]) -> Vec<f64> {
        (0..self.cols)
            .map(|c| (self.colptr[c]..self.colptr[c + 1]).map(|i| self.nzval[i] * x[self.rowval[i]]).sum())
            .collect()
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case", tag = "cone", content = "rows")]
pub enum Cone {
    /// s = 0
    Zero(usize),
    /// s >= 0
    Nonnegative(usize),
    /// s_0 >= |(s_1, ..)|
    SecondOrder(usize),
}

impl Cone {
    pub fn rows(self) -> usize {
        match self {
            Cone::Zero(n) | Cone::Nonnegative(n) | Cone::SecondOrder(n) => n,
        }
    }
}

/// Which statement of the spec, fault mode and sample a row stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case", tag = "row")]
pub enum RowOrigin {
    /// The step of one derivative of an axis over an interval.
    Dynamics { interval: usize, axis: usize, derivative: usize },
    /// A derivative that is zero at rest (start, end, hold).
    Rest { node: usize, axis: usize, derivative: usize },
    /// What a fault leaves as it is where it strikes, and what is nothing where the vehicle has stopped.
    Stop { node: usize, axis: usize, derivative: usize },
    /// Row `facet` of the planner's set (see `PlanningSet::rows`) at a node.
    Facet { facet: usize, node: usize },
    /// The same facet for the lead wrench of rotors that lag, with the slopes of the interval after or before the node.
    Lag { facet: usize, node: usize, after: bool },
    /// `Mission::limits[limit]` at a node.
    Limit { limit: usize, node: usize },
    /// The position tolerance of `Mission::waypoints[waypoint]`.
    Waypoint { waypoint: usize },
    /// Its yaw tolerance.
    WaypointYaw { waypoint: usize },
    /// The thrust at a node points upwards.
    Upright { node: usize },
    /// The thrust at a node is at most what any attitude gives.
    Thrust { node: usize },
    /// How much the duration of leg `leg` may change.
    Duration { leg: usize },
    /// The overshoot may not exceed what makes tolerances meaningless.
    Overshoot,
    /// The excess is not less than it needs to be.
    Violation,
}

/// The program; [`crate::solve::solve`] refuses data that is not finite.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QuadraticProgram {
    /// Upper triangle.
    #[serde(rename = "P")]
    pub p: Sparse,
    pub q: Vec<f64>,
    pub constant: f64,
    #[serde(rename = "A")]
    pub a: Sparse,
    pub b: Vec<f64>,
    pub cones: Vec<Cone>,
    /// One per row of A.
    pub row_origin: Vec<RowOrigin>,
}

impl RowOrigin {
    /// The kind of row in a word or two.
    pub fn kind(&self) -> &'static str {
        match self {
            RowOrigin::Dynamics { .. } => "dynamics",
            RowOrigin::Rest { .. } => "rest",
            RowOrigin::Stop { .. } => "stop",
            RowOrigin::Facet { .. } => "facets",
            RowOrigin::Lag { .. } => "lag",
            RowOrigin::Limit { .. } => "limits",
            RowOrigin::Waypoint { .. } => "waypoints",
            RowOrigin::WaypointYaw { .. } => "waypoint yaw",
            RowOrigin::Upright { .. } => "upright",
            RowOrigin::Thrust { .. } => "thrust",
            RowOrigin::Duration { .. } => "durations",
            RowOrigin::Overshoot => "overshoot",
            RowOrigin::Violation => "excess",
        }
    }
}

/// Sizes, and rows by origin.
impl fmt::Display for QuadraticProgram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "variables {}", self.variables())?;
        writeln!(f, "rows {} with {} entries; P has {} entries", self.b.len(), self.a.nzval.len(), self.p.nzval.len())?;
        let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
        for origin in &self.row_origin {
            *kinds.entry(origin.kind()).or_default() += 1;
        }
        for (kind, rows) in kinds {
            writeln!(f, "  {kind}: {rows}")?;
        }
        let mut cones = [0; 3];
        for cone in &self.cones {
            match cone {
                Cone::Zero(n) => cones[0] += n,
                Cone::Nonnegative(n) => cones[1] += n,
                Cone::SecondOrder(_) => cones[2] += 1,
            }
        }
        writeln!(f, "equal {}, inequal {}, second-order cones {}", cones[0], cones[1], cones[2])
    }
}

impl QuadraticProgram {
    pub fn variables(&self) -> usize {
        self.q.len()
    }

    /// P x, from the upper triangle.
    pub fn hessian_times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.p.transposed_times(x);
        self.p.multiply_into(x, &mut y);
        for c in 0..self.p.cols {
            for i in self.p.colptr[c]..self.p.colptr[c + 1] {
                if self.p.rowval[i] == c {
                    y[c] -= self.p.nzval[i] * x[c];
                }
            }
        }
        y
    }

    /// 1/2 x'P x + q'x + constant.
    pub fn objective(&self, x: &[f64]) -> f64 {
        let px = self.hessian_times(x);
        x.iter().zip(&px).zip(&self.q).map(|((x, px), q)| x * (0.5 * px + q)).sum::<f64>() + self.constant
    }

    /// b - A x.
    pub fn slack(&self, x: &[f64]) -> Vec<f64> {
        let negative: Vec<f64> = x.iter().map(|v| -v).collect();
        let mut s = self.b.clone();
        self.a.multiply_into(&negative, &mut s);
        s
    }

    /// How far `s` lies outside K: the largest of |s| on zero rows, -s on nonnegative rows and |s_rest| - s_0
    /// on cones.
    pub fn cone_violation(&self, s: &[f64]) -> f64 {
        self.outside(s, f64::abs)
    }

    /// The same for the dual cone, in which the rows of {0} are free.
    pub fn dual_violation(&self, z: &[f64]) -> f64 {
        self.outside(z, |_| 0.0)
    }

    /// What each row, or each second-order cone, weighs in multipliers z: |z| on a row of {0}, z on a nonnegative one, and
    /// z_0 on a cone, which the others cannot exceed.
    pub fn weights(&self, z: &[f64]) -> Vec<(RowOrigin, f64)> {
        let mut weights = Vec::with_capacity(z.len());
        let mut at = 0;
        for cone in &self.cones {
            let weighing = match cone {
                Cone::SecondOrder(_) => 1,
                Cone::Zero(n) | Cone::Nonnegative(n) => *n,
            };
            weights.extend((at..at + weighing).map(|row| (self.row_origin[row], z[row].abs())));
            at += cone.rows();
        }
        weights
    }

    fn outside(&self, s: &[f64], zero: impl Fn(f64) -> f64) -> f64 {
        let mut worst = 0.0_f64;
        let mut at = 0;
        for cone in &self.cones {
            let part = &s[at..at + cone.rows()];
            at += cone.rows();
            let violation = match cone {
                Cone::Zero(_) => part.iter().map(|&v| zero(v)).fold(0.0, f64::max),
                Cone::Nonnegative(_) => part.iter().map(|v| -v).fold(0.0, f64::max),
                Cone::SecondOrder(_) => part[1..].iter().map(|v| v * v).sum::<f64>().sqrt() - part[0],
            };
            worst = worst.max(violation);
        }
        worst
    }
}
