//! The energy of a plan, and the charge that it leaves.

use crate::energy::{Consumption, Power};
use crate::model::{Battery, Model};
use crate::motion::Trajectory;
use crate::number::{fixed, percent, significant};
use serde::Serialize;

/// The energy that a plan takes from the battery.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BatteryRecord {
    /// Electrical energy of the plan, J, at the largest mass of the spec's interval.
    pub energy_j: f64,
    /// Estimated error of the quadrature, J.
    pub quadrature_error_j: f64,
    /// Energy of the full battery, J.
    pub battery_j: f64,
    /// Share of the charge at the end; negative if the plan takes more than the battery holds.
    pub left: f64,
    /// The `keep` of the spec.
    pub keep: f64,
    /// Mean electrical power, W.
    pub mean_power_w: f64,
    /// Largest electrical power, W.
    pub largest_power_w: f64,
    /// When the power is largest, s.
    pub largest_at_s: f64,
    /// Full thrust with the charge `keep` as a share of that with a full battery; sets and plans use it.
    pub full_thrust: f64,
}

/// The record of a plan; `None` without a battery.
pub fn record(model: &Model, trajectory: &Trajectory) -> Option<BatteryRecord> {
    let (battery, power) = (model.vehicle.battery.as_ref()?, Power::of(model)?);
    let consumption = power.along(trajectory);
    let Consumption { energy, error, most } = consumption;
    Some(BatteryRecord {
        energy_j: energy,
        quadrature_error_j: error,
        battery_j: battery.energy(),
        left: consumption.left(battery),
        keep: battery.keep,
        mean_power_w: energy / trajectory.duration(),
        largest_power_w: most.value,
        largest_at_s: most.at,
        full_thrust: battery.lowest_full_thrust(),
    })
}

/// Joules as watt hours, with three digits.
pub(super) fn watt_hours(joules: f64) -> String {
    format!("{} W*h", significant(joules / 3600.0, 3))
}

impl BatteryRecord {
    /// Whether the plan leaves less charge than `keep`.
    pub fn is_short(&self) -> bool {
        self.left < self.keep
    }

    /// `2.11 W*h of 111 W*h (1.9 %)`
    pub fn used(&self) -> String {
        format!("{} of {} ({})", watt_hours(self.energy_j), watt_hours(self.battery_j), self.share())
    }

    /// `2.11 W*h, 1.9 %`, for a column of the energy and its share of the battery.
    pub fn cell(&self) -> String {
        format!("{}, {}", watt_hours(self.energy_j), self.share())
    }

    /// The energy as a share of the full battery.
    fn share(&self) -> String {
        percent(self.energy_j / self.battery_j)
    }

    /// `mean power 217 W, largest 221 W at 3.20 s`
    pub fn powers(&self) -> String {
        let [mean, largest] = [self.mean_power_w, self.largest_power_w].map(|power| significant(power, 3));
        format!("mean power {mean} W, largest {largest} W at {} s", fixed(self.largest_at_s, 2))
    }

    /// The caveat of a plan that leaves too little.
    pub fn caveat(&self) -> Option<String> {
        let keep = percent(self.keep);
        let (left, used) = (percent(self.left.max(0.0)), self.used());
        let thrust = match self.full_thrust < 1.0 {
            true => " The admissible sets hold down to this charge; below it the rotors give less thrust.",
            false => "",
        };
        self.is_short().then(|| match self.left < 0.0 {
            true => format!(
                "The plan takes more energy than the battery holds: {used}. Shorten the mission or its holds, or use a \
                 larger battery."
            ),
            false => format!(
                "The plan leaves {left} of the charge, and `keep` requires {keep}.{thrust} Shorten the mission or its \
                 holds, or use a larger battery."
            ),
        })
    }
}

/// Terminal text; empty without a battery.
pub fn text(model: &Model, trajectory: &Trajectory) -> String {
    record(model, trajectory).map_or(String::new(), |record| {
        let left = if record.left < 0.0 { "none".to_string() } else { percent(record.left) };
        format!("  battery: {}, {left} left ({} to keep); {}\n", record.used(), percent(record.keep), record.powers())
    })
}

/// The line on the full thrust that sets and plans use; empty if it does not depend on the charge.
pub fn full_thrust(model: &Model) -> String {
    let lowered = |b: &&Battery| b.lowest_full_thrust() < 1.0;
    model.vehicle.battery.as_ref().filter(lowered).map_or(String::new(), |battery| {
        format!(
            "Full thrust is that with {} of the charge: {} of that with a full battery\n",
            percent(battery.keep),
            percent(battery.lowest_full_thrust())
        )
    })
}
