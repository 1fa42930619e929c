//! Rows of the actuation matrix that a fault makes nearly parallel: two axes that the rotors hardly tell apart.

use super::AdmissibleSet;
use serde::Serialize;

/// How far a row of the actuation matrix may be off, in shares of its length: what differences between rotors, battery
/// and bench leave of coefficients.
const ROW_ERROR: f64 = 0.1;

/// A row shorter than this share of the longest, in shares of the set's extent, is no axis at all.
const NO_ROW: f64 = 1e-9;

const AXES: [&str; 4] = ["thrust", "tau_x", "tau_y", "tau_z"];

/// Two axes and the angle between their rows, rad, from 0 to a right angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parallel {
    pub axes: [&'static str; 2],
    pub angle: f64,
}

/// Rows at a smaller angle than this, rad, can coincide by errors of a tenth of their length each: 2 asin(0.1), 11.5
/// degrees.
pub fn least_angle() -> f64 {
    2.0 * ROW_ERROR.asin()
}

/// The two rows of `A_theta` at the smallest angle, columns in shares of each rotor's range of thrust; `None` where
/// fewer than two rows hold anything.
///
/// The angle between two rows does not depend on their units. It is that between lines: rows that point apart are as
/// parallel as rows that point one way.
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
        // Half the angle by the halves' tangent: exact for small angles, where an arc cosine is not.
        let sum = |sign: f64| {
            let each = rows[i].iter().zip(&rows[j]).map(|(u, v)| u / a + sign * v / b);
            each.map(|v| v * v).sum::<f64>().sqrt()
        };
        let (apart, along) = (sum(-1.0), sum(1.0));
        let angle = 2.0 * apart.min(along).atan2(apart.max(along));
        // Rounding dust.
        if angle < 1e-12 { 0.0 } else { angle }
    };
    let all = pairs.map(|(i, j)| Parallel { axes: [AXES[i], AXES[j]], angle: angle(i, j) });
    all.min_by(|a, b| a.angle.total_cmp(&b.angle))
}
