//! The rows of a core for a short motion after a fault, while the spin is still slow. See `docs/method/without-yaw.md`,
//! "After a fault".

use super::planned::{CoreRow, PlannedCore, Turning, coupling};
use crate::admissible::row::SetRow;
use crate::model::Model;

/// A motion that begins turning may turn faster by this factor. Chosen by hand.
const TURNS_MORE: f64 = 1.5;

/// How a motion begins: the rate of the body about the thrust, and that at which the direction of the thrust turns,
/// rad/s.
#[derive(Debug, Clone, Copy)]
pub struct Begins {
    pub spin: f64,
    pub turning: f64,
}

impl Begins {
    pub fn of(turning: &Turning) -> Self {
        Begins { spin: turning[5], turning: turning.fixed_rows::<2>(3).norm() }
    }
}

impl PlannedCore {
    /// The rows for a motion of `duration` s: (98) at the ends of the rates that the yaw torques, and the coupling of
    /// turns, can reach in that time, with a bound on turns that leaves room for those of its beginning. `None` where
    /// that could leave the core's own rates, which hold for any time.
    pub fn rows_for(&self, model: &Model, begins: Begins, duration: f64) -> Option<Vec<SetRow>> {
        let [jx, jy, jz] = model.vehicle.inertia;
        let bound = self.turning_rad_s.map(|own| own.max(TURNS_MORE * begins.turning));
        let coupling = bound.map_or(0.0, |rate| coupling((jx - jy).abs(), rate));
        // Without the drag, which only slows the spin.
        let [low, high] = self.yaw_torque_n_m.map(|torque| torque / jz * duration);
        let more = coupling / jz * duration;
        let spin = [begins.spin.min(0.0) + low - more, begins.spin.max(0.0) + high + more];
        if spin[0] < self.spin_rad_s[0] || spin[1] > self.spin_rad_s[1] {
            return None;
        }
        let reached = |row: &SetRow| {
            let core = row.core.map(|core| match bound {
                Some(rate) if core.bounds_turning() => CoreRow { torque: 1.0 / rate, ..core },
                _ if core.torque == 0.0 => core,
                _ => {
                    let end = usize::from(core.spin == self.spin_rad_s[1]);
                    CoreRow { momentum: core.momentum + jz * (spin[end] - core.spin), spin: spin[end], ..core }
                }
            });
            SetRow { core, ..row.clone() }
        };
        Some(self.rows.iter().map(reached).collect())
    }
}
