//! Linear least squares for few columns of like length.

use nalgebra::{DMatrix, DVector};

/// The weights with which the columns of `a` (m x n, n <= m) come nearest to `b`, by Householder's reflections (G. H.
/// Golub, C. F. Van Loan, *Matrix Computations*, section 5.3); `None` where a column depends on those before it.
///
/// What is left is orthogonal to the columns to rounding, however nearly parallel they are. Searches for nearest points rely
/// on it: what nalgebra's singular values left was now and then 1e-9 long where the columns reach `b`, and such a search
/// then ends too early or turns in circles.
pub fn least_squares(a: DMatrix<f64>, b: DVector<f64>) -> Option<Vec<f64>> {
    if a.ncols() > a.nrows() {
        return None;
    }
    let qr = a.qr();
    let mut turned = b;
    qr.q_tr_mul(&mut turned);
    let weights = qr.r().solve_upper_triangular(&turned.rows(0, qr.r().ncols()))?;
    weights.iter().all(|w| w.is_finite()).then(|| weights.iter().copied().collect())
}
