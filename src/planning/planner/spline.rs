//! B-splines with knots at the nodes: all motions whose inputs are continuous and piecewise linear.
//!
//! A chain of r integrators under first-order hold moves along a polynomial of degree r + 1 on each interval, with
//! all derivatives up to the input continuous: exactly the splines of degree r + 1 with simple knots at the nodes
//! (de Boor, *A Practical Guide to Splines*). Their coefficients need no equality rows, while stage variables need
//! r per interval and axis.

mod jump;

pub use jump::JumpAt;

/// A derivative at a node as a combination of coefficients: `(coefficient, weight)` pairs.
pub type Weights = Vec<(usize, f64)>;

/// Values at the nodes of all derivatives up to the input's.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeSpline {
    /// `weights[node][order]`
    weights: Vec<Vec<Weights>>,
    knots: Vec<f64>,
    degree: usize,
}

impl NodeSpline {
    /// Splines of degree `order + 1` over ascending `times` (s).
    pub fn new(times: &[f64], order: usize) -> Self {
        let degree = order + 1;
        let intervals = times.len() - 1;
        let ends = |t: f64| std::iter::repeat_n(t, degree);
        let knots: Vec<f64> = ends(times[0]).chain(times.iter().copied()).chain(ends(times[intervals])).collect();
        let weights = (0..times.len())
            .map(|node| {
                let span = degree + node.min(intervals - 1);
                (0..=order).map(|m| derivative(&knots, degree, span, times[node], m)).collect()
            })
            .collect();
        NodeSpline { weights, knots, degree }
    }

    /// The number of coefficients of one axis.
    pub fn coefficients(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The coefficients of a motion with these derivatives at the nodes, by the dual functionals of de Boor and Fix:
    /// `c_i = sum_r (-1)^(p-r) psi_i^(p-r)(t) f^(r)(t) / p!` with `psi_i(t) = (t_{i+1} - t) .. (t_{i+p} - t)`, for any
    /// t in the support of the i-th B-spline. `derivative(node, order)` gives them up to the input's.
    pub fn coefficients_of(&self, derivative: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let (p, last) = (self.degree, self.weights.len() - 2);
        // The beginning of an interval in the middle of the support.
        let middle = |i: usize| (i + p / 2).clamp(p, p + last);
        (0..self.coefficients()).map(|i| self.coefficient_at(i, middle(i), &derivative)).collect()
    }

    /// The first coefficients, `order + 1` of them, of a motion that begins with these derivatives, up to the input's;
    /// all others are zero, so that the motion has ended at rest in 0 after `order + 1` steps.
    fn beginning_with(&self, derivatives: &[f64]) -> Vec<f64> {
        // The highest derivative has no weight at the beginning, where the knots coincide.
        let derivative = |node: usize, order: usize| if node == 0 { derivatives[order] } else { 0.0 };
        (0..self.degree).map(|i| self.coefficient_at(i, self.degree, &derivative)).collect()
    }

    /// The i-th of [`Self::coefficients_of`], by the derivatives at `knots[span]`.
    fn coefficient_at(&self, i: usize, span: usize, derivative: &impl Fn(usize, usize) -> f64) -> f64 {
        let p = self.degree;
        let factorial = |n: usize| (1..=n).map(|i| i as f64).product::<f64>();
        let (node, t) = (span - p, self.knots[span]);
        // psi_i(t + x) by powers of x.
        let mut psi = vec![1.0];
        for knot in &self.knots[i + 1..=i + p] {
            let mut next = vec![0.0; psi.len() + 1];
            for (power, c) in psi.iter().enumerate() {
                next[power] += c * (knot - t);
                next[power + 1] -= c;
            }
            psi = next;
        }
        let of_order = |r: usize| match r {
            r if r < p => derivative(node, r),
            _ => (derivative(node + 1, p - 1) - derivative(node, p - 1)) / (self.knots[span + 1] - t),
        };
        let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        let terms = (0..=p).map(|r| sign(p - r) * factorial(p - r) * psi[p - r] * of_order(r));
        terms.sum::<f64>() / factorial(p)
    }

    /// The largest weight of a coefficient in the input at any node; it is proportional to the shortest step to the
    /// power minus `order`.
    pub fn steepest(&self) -> f64 {
        let inputs = self.weights.iter().filter_map(|orders| orders.last()).flatten();
        inputs.fold(0.0, |m: f64, (_, w)| m.max(w.abs()))
    }

    /// The derivative of the given order at a node, in the coefficients.
    pub fn at(&self, node: usize, order: usize) -> &Weights {
        &self.weights[node][order]
    }
}

/// Weights of the m-th derivative at t in `[knots[span], knots[span + 1]]`:
/// `s^(m) = sum_j c^(m)_j N_{j, p-m}`, `c^(m)_j = (p-m+1) (c^(m-1)_j - c^(m-1)_{j-1}) / (t_{j+p-m+1} - t_j)`.
fn derivative(knots: &[f64], degree: usize, span: usize, t: f64, m: usize) -> Weights {
    let first = span - degree;
    // c^(m)_j in terms of the degree + 1 coefficients in reach; row j - first.
    let mut rows: Vec<Vec<f64>> =
        (0..=degree).map(|j| (0..=degree).map(|i| f64::from(u8::from(i == j))).collect()).collect();
    for step in 1..=m {
        let q = degree - step + 1;
        for j in (step..=degree).rev() {
            let factor = q as f64 / (knots[first + j + q] - knots[first + j]);
            let earlier = rows[j - 1].clone();
            for (value, before) in rows[j].iter_mut().zip(earlier) {
                *value = factor * (*value - before);
            }
        }
    }
    let mut sum = vec![0.0; degree + 1];
    for (row, value) in rows[m..].iter().zip(basis(knots, degree - m, span, t)) {
        for (s, r) in sum.iter_mut().zip(row) {
            *s += value * r;
        }
    }
    sum.into_iter().enumerate().filter(|(_, w)| *w != 0.0).map(|(i, w)| (first + i, w)).collect()
}

/// N_{j,q}(t) for j = span - q ..= span (Cox and de Boor).
fn basis(knots: &[f64], q: usize, span: usize, t: f64) -> Vec<f64> {
    let mut values = vec![1.0];
    for d in 1..=q {
        let mut next = vec![0.0; d + 1];
        for (i, v) in values.iter().enumerate() {
            // v is N_{j, d-1} with j = span - d + 1 + i.
            let j = span + 1 + i - d;
            let share = v / (knots[j + d] - knots[j]);
            next[i] += share * (knots[j + d] - t);
            next[i + 1] += share * (t - knots[j]);
        }
        values = next;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For any coefficients the derivatives at neighbouring nodes are joined by exact steps under first-order hold.
    #[test]
    fn steps_are_exact() {
        let times = [0.0, 0.5, 0.7, 1.5, 2.0, 2.9];
        for order in [2, 4] {
            let spline = NodeSpline::new(&times, order);
            let c: Vec<f64> = (0..spline.coefficients()).map(|i| ((i * 37 % 11) as f64).sin()).collect();
            let value = |node: usize, m: usize| spline.at(node, m).iter().map(|&(i, w)| w * c[i]).sum::<f64>();
            for k in 0..times.len() - 1 {
                let h = times[k + 1] - times[k];
                for i in 0..order {
                    let (mut expected, mut power) = (0.0, 1.0);
                    for j in i..=order {
                        expected += value(k, j) * power;
                        power *= h / (j - i + 1) as f64;
                    }
                    expected += (value(k + 1, order) - value(k, order)) / h * power;
                    let found = value(k + 1, i);
                    assert!(
                        (found - expected).abs() < 1e-9 * (1.0 + found.abs()),
                        "{order} {k} {i}: {found} {expected}"
                    );
                }
            }
        }
    }

    /// Coefficients found from derivatives at the nodes are those that gave them.
    #[test]
    fn coefficients_come_back() {
        let times = [0.0, 0.5, 0.7, 1.5, 2.0, 2.9];
        for order in [2, 4] {
            let spline = NodeSpline::new(&times, order);
            let c: Vec<f64> = (0..spline.coefficients()).map(|i| ((i * 37 % 11) as f64).sin()).collect();
            let value = |node: usize, m: usize| spline.at(node, m).iter().map(|&(i, w)| w * c[i]).sum::<f64>();
            for (found, c) in spline.coefficients_of(value).into_iter().zip(c) {
                assert!((found - c).abs() < 1e-9, "{order}: {found} {c}");
            }
        }
    }

    #[test]
    fn a_line_is_reproduced() {
        let times = [0.0, 1.0, 1.5, 4.0];
        let spline = NodeSpline::new(&times, 2);
        // Greville abscissae give s(t) = t.
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.5, 4.0, 4.0, 4.0, 4.0];
        let c: Vec<f64> = (0..6).map(|i| (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3.0).collect();
        for (node, t) in times.iter().enumerate() {
            let value = |m: usize| spline.at(node, m).iter().map(|&(i, w)| w * c[i]).sum::<f64>();
            assert!((value(0) - t).abs() < 1e-12 && (value(1) - 1.0).abs() < 1e-12 && value(2).abs() < 1e-12);
        }
    }
}
