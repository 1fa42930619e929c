//! Nearly parallel rows of the actuation matrix: two axes of the wrench on which the rotors have almost the same effect
//! (`docs/method/verdicts.md`, "Nearly parallel rows").

use super::AdmissibleSet;
use serde::Serialize;

/// Assumed error of a row of the actuation matrix as a share of its length. Differences between rotors, the battery and
/// the test bench make coefficients about this uncertain in flight.
const ROW_ERROR: f64 = 0.1;

/// A row shorter than this share of the longest, both in shares of the set's extent, counts as zero.
const NO_ROW: f64 = 1e-9;

const AXES: [&str; 4] = ["thrust", "tau_x", "tau_y", "tau_z"];

/// Two rows of the actuation matrix and the angle between them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Parallel {
    /// The axes of the two rows.
    #[cfg_attr(test, schemars(extend("items" = {"enum": AXES})))]
    pub axes: [&'static str; 2],
    /// Angle between the rows as lines, rad, at most a right angle; `analyze` and `check` warn below 0.2003.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub angle: f64,
}

/// The angle, rad, below which errors of 10 % of the length of each of two rows can make the rows coincide: 2
/// asin(0.1), 11.5 degrees.
pub fn least_angle() -> f64 {
    2.0 * ROW_ERROR.asin()
}

/// The two rows of `A_theta` with the smallest angle between them; columns are in shares of each rotor's range of
/// thrust. `None` if fewer than two rows are nonzero.
///
/// The angle does not depend on the units of the axes. It is the angle between lines, so opposite rows count as
/// parallel.
pub fn nearest_rows(set: &AdmissibleSet) -> Option<Parallel> {
    let generators = &set.zonotope.generators;
    let scale = set.zonotope.scale();
    let rows: Vec<Vec<f64>> = (0..4).map(|axis| generators.iter().map(|g| g[axis] / scale[axis]).collect()).collect();
    let length = |row: &[f64]| row.iter().map(|v| v * v).sum::<f64>().sqrt();
    let longest = rows.iter().map(|r| length(r)).fold(0.0, f64::max);
    let axes: Vec<usize> = (0..4).filter(|&i| length(&rows[i]) > NO_ROW * longest).collect();
    let pairs = axes.iter().flat_map(|&i| axes.iter().filter(move |&&j| i < j).map(move |&j| (i, j)));
    let angle = |i: usize, j: usize| {
        let (a, b) = (length(&rows[i]), length(&rows[j]));
        // 2 atan2(|r_i - r_j|, |r_i + r_j|) is accurate for small angles, where the arc cosine is not.
        let sum = |sign: f64| {
            let each = rows[i].iter().zip(&rows[j]).map(|(u, v)| u / a + sign * v / b);
            each.map(|v| v * v).sum::<f64>().sqrt()
        };
        let (apart, along) = (sum(-1.0), sum(1.0));
        let angle = 2.0 * apart.min(along).atan2(apart.max(along));
        // Rounding error.
        if angle < 1e-12 { 0.0 } else { angle }
    };
    let all = pairs.map(|(i, j)| Parallel { axes: [AXES[i], AXES[j]], angle: angle(i, j) });
    all.min_by(|a, b| a.angle.total_cmp(&b.angle))
}
