//! Eigenvalues of symmetric matrices in place.

/// Sweeps over all pairs of rows. Convergence is quadratic, so a few sweeps suffice.
const MOST_SWEEPS: usize = 30;

/// Writes the eigenvalues of a symmetric matrix (n x n, row-major) to `values` (n entries), in no particular order, by
/// Jacobi rotations (G. H. Golub, C. F. Van Loan, *Matrix Computations*, section 8.5).
///
/// The contents of `matrix` are overwritten. Allocates no memory, because the estimator calls it during a flight.
///
/// # Panics
/// If `matrix` has fewer than n^2 entries.
pub(crate) fn eigenvalues(matrix: &mut [f64], values: &mut [f64]) {
    let n = values.len();
    let scale = matrix.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
    for _ in 0..MOST_SWEEPS {
        let mut beside: f64 = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                let off = matrix[p * n + q];
                beside = beside.max(off.abs());
                if off.abs() <= 1e-16 * scale {
                    continue;
                }
                let theta = (matrix[q * n + q] - matrix[p * n + p]) / (2.0 * off);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for k in 0..n {
                    let (a, b) = (matrix[k * n + p], matrix[k * n + q]);
                    matrix[k * n + p] = c * a - s * b;
                    matrix[k * n + q] = s * a + c * b;
                }
                for k in 0..n {
                    let (a, b) = (matrix[p * n + k], matrix[q * n + k]);
                    matrix[p * n + k] = c * a - s * b;
                    matrix[q * n + k] = s * a + c * b;
                }
            }
        }
        if beside <= 1e-15 * scale {
            break;
        }
    }
    (0..n).for_each(|k| values[k] = matrix[k * n + k]);
}

#[cfg(test)]
mod tests {
    use super::eigenvalues;
    use nalgebra::DMatrix;

    #[test]
    fn eigenvalues_are_those_of_nalgebra() {
        for n in 1..=12 {
            let square = DMatrix::from_fn(n, n, |i, j| ((3 * i + 7 * j) as f64).sin() + ((i * j) as f64).cos());
            // Of rank below n where n is odd.
            let half = square.columns(0, n - n % 2 * (n > 1) as usize).into_owned();
            let symmetric = &half * half.transpose();
            let mut values = vec![0.0; n];
            eigenvalues(&mut symmetric.as_slice().to_vec(), &mut values);
            values.sort_by(f64::total_cmp);
            let mut due: Vec<f64> = symmetric.symmetric_eigenvalues().iter().copied().collect();
            due.sort_by(f64::total_cmp);
            for (a, b) in values.iter().zip(&due) {
                assert!((a - b).abs() < 1e-12 * due[n - 1].max(1.0), "{values:?} {due:?}");
            }
        }
    }
}
