//! ArduPilot's mixer: what share of full thrust each motor is commanded, from what the controller demands.
//!
//! After `AP_MotorsMatrix::output_armed_stabilizing` (ArduCopter 4.5), without the boost for a motor that it believes
//! lost. Roll and pitch come first, then as much yaw as leaves room, then the thrust nearest to the demanded one.

use super::fit::Effect;

/// The largest factor of roll, pitch and yaw (`normalise_rpy_factors`).
const LARGEST: f64 = 0.5;
/// The share of full thrust about which the mixer measures the room for yaw.
const MIDDLE: f64 = 0.5;

/// The mixer of a frame.
pub struct Mixer {
    /// Factors of roll, pitch and yaw by motor.
    factors: Vec<[f64; 3]>,
    /// Factors for each unit of an effect.
    scales: [f64; 3],
    /// The yaw that always has room (`MOT_YAW_HEADROOM`), as a share.
    headroom: f64,
}

impl Mixer {
    /// `None` if the rotors give no torque about an axis.
    pub fn of(effects: &[Effect], headroom: f64) -> Option<Self> {
        let largest = |axis: usize| effects.iter().map(|effect| effect[axis + 1].abs()).fold(0.0, f64::max);
        let scales: [f64; 3] = std::array::from_fn(|axis| LARGEST / largest(axis));
        let factor = |effect: &Effect| std::array::from_fn(|axis| effect[axis + 1] * scales[axis]);
        scales.iter().all(|scale| scale.is_finite()).then(|| Mixer {
            factors: effects.iter().map(factor).collect(),
            scales,
            headroom,
        })
    }

    /// What the outputs give of demands of thrust, roll, pitch and yaw, in units of effects, and whether all of them
    /// fit.
    pub fn mix(&self, [thrust, roll, pitch, yaw]: [f64; 4]) -> (Effect, bool) {
        let thrust_in = thrust.clamp(0.0, 1.0);
        let level: Vec<f64> = self.factors.iter().map(|[r, p, _]| roll * r + pitch * p).collect();
        let room = |(turned, [_, _, factor]): (&f64, &[f64; 3])| {
            let at = MIDDLE + turned;
            let left = if yaw * factor > 0.0 { 1.0 - at } else { at };
            if *factor == 0.0 { f64::INFINITY } else { left.max(0.0) / factor.abs() }
        };
        let most = level.iter().zip(&self.factors).map(room).fold(1.0, f64::min).max(self.headroom);
        let given = yaw.clamp(-most, most);
        let turned: Vec<f64> = level.iter().zip(&self.factors).map(|(level, f)| level + given * f[2]).collect();
        let low = turned.iter().copied().fold(f64::INFINITY, f64::min);
        let high = turned.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // All of the range, and with the most thrust no motor below zero.
        let scale = [1.0, 1.0 / (high - low), if low < 0.0 { -1.0 / low } else { 1.0 }].into_iter().fold(1.0, f64::min);
        let (low, high) = (scale * low, scale * high);
        let base = if scale < 1.0 { -low } else { thrust_in.min(1.0 - high).max(-low) };
        let fits = scale == 1.0 && given == yaw && base == thrust;
        let [roll, pitch, yaw] = [roll, pitch, given].map(|part| scale * part);
        ([base, roll * self.scales[0], pitch * self.scales[1], yaw * self.scales[2]], fits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quadcopter in X; by hand after the rule.
    #[test]
    fn demands_beyond_the_range_give_up_thrust_then_yaw() {
        let effects = [[1.0, 1.0, 1.0, 1.0], [1.0, -1.0, -1.0, 1.0], [1.0, 1.0, -1.0, -1.0], [1.0, -1.0, 1.0, -1.0]];
        let mixer = Mixer::of(&effects, 0.2).unwrap();
        let outputs = |demands: [f64; 4]| {
            let (given, fits) = mixer.mix(demands);
            let output = |effect: &Effect| effect.iter().zip(given).map(|(e, d)| e * d).sum();
            (effects.iter().map(output).collect::<Vec<f64>>(), fits)
        };
        for (demands, expected, fits) in [
            ([0.4, 0.1, 0.0, 0.0], [0.45, 0.35, 0.45, 0.35], true),
            ([0.4, 0.0, 0.1, 0.2], [0.55, 0.45, 0.25, 0.35], true),
            // Less thrust, so that the strongest motor is at its most.
            ([0.9, 0.6, 0.0, 0.0], [1.0, 0.4, 1.0, 0.4], false),
            // More, so that the weakest is not below none.
            ([0.1, 0.6, 0.0, 0.0], [0.6, 0.0, 0.6, 0.0], false),
            // Roll and pitch within the range.
            ([0.5, 1.5, 1.5, 0.0], [1.0, 0.0, 0.5, 0.5], false),
            // Yaw within the room that roll leaves, 0.2/0.5.
            ([0.5, 0.6, 0.0, 1.0], [1.0, 0.4, 0.6, 0.0], false),
            // But at least the headroom.
            ([0.5, 1.0, 0.0, 1.0], [1.0, 1.0 / 6.0, 5.0 / 6.0, 0.0], false),
        ] {
            let (found, all) = outputs(demands);
            assert_eq!(all, fits, "{demands:?}: {found:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-12, "{demands:?}: {found:?}");
            }
        }
    }
}
