//! Linear least squares for a few columns of similar length.

use nalgebra::{DMatrix, DVector};

/// The weights x (n) that minimise |a x - b| for `a` of m x n and `b` of m entries, by Householder reflections (G. H.
/// Golub, C. F. Van Loan, *Matrix Computations*, section 5.3). `None` if n > m or a column depends on those before it.
///
/// The residual is orthogonal to the columns to rounding, however nearly parallel they are. The nearest-point searches
/// rely on this: with nalgebra's singular value decomposition the residual was occasionally 1e-9 long although the
/// columns reach `b`, and such a search then ends early or cycles.
pub(super) fn least_squares(a: DMatrix<f64>, b: DVector<f64>) -> Option<Vec<f64>> {
    if a.ncols() > a.nrows() {
        return None;
    }
    let qr = a.qr();
    let mut turned = b;
    qr.q_tr_mul(&mut turned);
    let weights = qr.r().solve_upper_triangular(&turned.rows(0, qr.r().ncols()))?;
    weights.iter().all(|w| w.is_finite()).then(|| weights.iter().copied().collect())
}
