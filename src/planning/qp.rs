//! Convex programs in the solver's standard form, with the origin of every row:
//!
//! ```text
//! minimise    1/2 x'P x + q'x + constant
//! subject to  A x + s = b,  s in K
//! ```
//!
//! where K is a product of {0}, the nonnegative orthant and second-order cones, in this order. What the planners put
//! into a program is described in `docs/method/hover-model.md` and `exact-planner.md`.

pub mod build;
pub mod elimination;

use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// A matrix in compressed sparse column format, indices from 0.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Sparse {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub cols: usize,
    /// The entries of column c are those from `colptr[c]` up to `colptr[c + 1]`; length `cols + 1`.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub colptr: Vec<usize>,
    /// The row of each entry, ascending within a column.
    pub rowval: Vec<usize>,
    /// The value of each entry.
    pub nzval: Vec<f64>,
}

/// The entries sorted by row, stable within a row.
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
    /// A `rows` x `cols` matrix from entries (row, column, value) in any order. Values of equal positions are added.
    ///
    /// # Panics
    /// If an entry lies outside the matrix.
    pub fn from_entries(rows: usize, cols: usize, entries: &[(usize, usize, f64)]) -> Self {
        // Counting sort by row, unless the entries are already in this order, then by column. This takes linear time,
        // and row indices ascend within each column.
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

/// A factor of the cone K, with its number of rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
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
    /// The number of rows.
    pub fn rows(self) -> usize {
        match self {
            Cone::Zero(n) | Cone::Nonnegative(n) | Cone::SecondOrder(n) => n,
        }
    }
}

/// The statement of the spec, the fault mode and the node that a row comes from. Nodes and intervals are those of
/// the time grid without holds, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", tag = "row")]
pub enum RowOrigin {
    /// The dynamics of one derivative of an axis over an interval.
    Dynamics {
        /// Interval.
        interval: usize,
        /// 0 x, 1 y, 2 z, 3 yaw.
        #[cfg_attr(test, schemars(range(max = 3)))]
        axis: usize,
        /// Order of the derivative.
        #[cfg_attr(test, schemars(range(max = 4)))]
        derivative: usize,
    },
    /// A derivative that is zero at rest (start, end, hold).
    Rest {
        /// Node.
        node: usize,
        /// 0 x, 1 y, 2 z, 3 yaw.
        #[cfg_attr(test, schemars(range(max = 3)))]
        axis: usize,
        /// Order of the derivative.
        #[cfg_attr(test, schemars(range(max = 4)))]
        derivative: usize,
    },
    /// The continuity of a derivative at the fault from which a stop begins, or a derivative that is zero at the end of
    /// the stop.
    #[cfg_attr(test, schemars(skip))]
    Stop { node: usize, axis: usize, derivative: usize },
    /// An equation of variables for the wrench, at a node or after it.
    #[cfg_attr(test, schemars(skip))]
    Wrench { node: usize },
    /// A row of the planning set at a node.
    Facet {
        /// Row of the set, from 0.
        facet: usize,
        /// Node.
        node: usize,
    },
    /// A row of the planning set for the commanded wrench of lagging rotors.
    Lag {
        /// Row of the set, from 0.
        facet: usize,
        /// Node.
        node: usize,
        /// Whether the wrench changes as in the interval after the node, or as in the one before.
        after: bool,
    },
    /// A limit of the mission at a node.
    Limit {
        /// Limit, in the order written, from 0.
        limit: usize,
        /// Node.
        node: usize,
    },
    /// The position tolerance of a waypoint.
    Waypoint {
        /// Waypoint, from 0.
        waypoint: usize,
    },
    /// The yaw tolerance of a waypoint.
    WaypointYaw {
        /// Waypoint, from 0.
        waypoint: usize,
    },
    /// (68), z'' + g >= 0.1 g at a node.
    #[cfg_attr(test, schemars(skip))]
    Upright { node: usize },
    /// (74), m |a| <= T_max at a node.
    #[cfg_attr(test, schemars(skip))]
    Thrust { node: usize },
    /// The bound on the change of the duration of leg `leg`.
    #[cfg_attr(test, schemars(skip))]
    Duration { leg: usize },
    /// The bound on the variable by which position tolerances are widened (docs/method/hover-model.md, 3).
    Overshoot,
    /// The lower bound on the violation sigma.
    #[cfg_attr(test, schemars(skip))]
    Violation,
}

/// A convex quadratic program with n variables and m rows: minimise `1/2 x'P x + q'x + constant` subject to `A x + s =
/// b`, s in K. All numbers must be finite.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct QuadraticProgram {
    /// P (n x n), upper triangle only.
    #[serde(rename = "P")]
    pub p: Sparse,
    /// q (n).
    pub q: Vec<f64>,
    /// The constant term of the objective.
    pub constant: f64,
    /// A (m x n).
    #[serde(rename = "A")]
    pub a: Sparse,
    /// b (m).
    pub b: Vec<f64>,
    /// The factors of K, in the order of the rows: {0}, then the nonnegative orthant, then second-order cones.
    pub cones: Vec<Cone>,
    /// The origin of each row (m).
    pub row_origin: Vec<RowOrigin>,
}

impl RowOrigin {
    /// The kind of row, in the words that `mavc emit qp` prints.
    pub fn kind(&self) -> &'static str {
        match self {
            RowOrigin::Dynamics { .. } => "dynamics",
            RowOrigin::Rest { .. } => "rest",
            RowOrigin::Stop { .. } => "stop",
            RowOrigin::Wrench { .. } => "wrench",
            RowOrigin::Facet { .. } => "facets",
            RowOrigin::Lag { .. } => "lag",
            RowOrigin::Limit { .. } => "limits",
            RowOrigin::Waypoint { .. } => "waypoints",
            RowOrigin::WaypointYaw { .. } => "waypoint yaw",
            RowOrigin::Upright { .. } => "upright",
            RowOrigin::Thrust { .. } => "thrust",
            RowOrigin::Duration { .. } => "durations",
            RowOrigin::Overshoot => "overshoot",
            RowOrigin::Violation => "violation",
        }
    }
}

/// Prints the sizes of the program and the number of rows of each kind.
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
        writeln!(f, "equalities {}, inequalities {}, second-order cones {}", cones[0], cones[1], cones[2])
    }
}

impl QuadraticProgram {
    /// The number of variables n.
    pub fn variables(&self) -> usize {
        self.q.len()
    }

    /// P x.
    pub(crate) fn hessian_times(&self, x: &[f64]) -> Vec<f64> {
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

    /// P x + q.
    pub(crate) fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let mut gradient = self.hessian_times(x);
        gradient.iter_mut().zip(&self.q).for_each(|(sum, q)| *sum += q);
        gradient
    }

    /// The objective 1/2 x'P x + q'x + constant.
    pub fn objective(&self, x: &[f64]) -> f64 {
        let px = self.hessian_times(x);
        x.iter().zip(&px).zip(&self.q).map(|((x, px), q)| x * (0.5 * px + q)).sum::<f64>() + self.constant
    }

    /// The slack s = b - A x.
    pub fn slack(&self, x: &[f64]) -> Vec<f64> {
        let negative: Vec<f64> = x.iter().map(|v| -v).collect();
        let mut s = self.b.clone();
        self.a.multiply_into(&negative, &mut s);
        s
    }

    /// The violation of `s in K`, 0 if it holds: the largest of |s| on rows of {0}, -s on nonnegative rows and |(s_1,
    /// ..)| - s_0 on second-order cones.
    pub(crate) fn cone_violation(&self, s: &[f64]) -> f64 {
        self.outside(s, f64::abs)
    }

    /// The violation of `z in K*`, 0 if it holds. The dual cone K* is like K, except that rows of {0} are free.
    pub fn dual_violation(&self, z: &[f64]) -> f64 {
        self.outside(z, |_| 0.0)
    }

    /// The weight in the multipliers z (m) of each row of {0} and of the nonnegative orthant, |z|, and of each
    /// second-order cone, z_0, which bounds the others.
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

    /// The largest violation of the cones by `s`; `zero` gives that of an entry in a row of {0}.
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
