//! A Python module with targets at the control rate, as the examples of gym-pybullet-drones hand them to
//! `computeControlFromState`.

use super::{Choices, Exported, list};
use crate::number::shortest;

const TEMPLATE: &str = include_str!("../../../../assets/exchange/gym_pybullet_drones.py");

/// The lines in whose place the plan is written.
const PLACE: &str = "CONTROL_FREQ_HZ, ROWS = 48, []  # the plan\n";
/// What stands for the plan in the first line of the documentation.
const TITLE: &str = "A PLAN";

/// Columns of a row.
const COLUMNS: &str = "x,y,z,roll,pitch,yaw,vx,vy,vz,yaw_rate";

/// Rows at the control rate: position, roll, pitch and yaw of the exact attitude, velocity, yaw rate.
pub(super) fn text(plan: &Exported, choices: &Choices) -> Result<String, String> {
    let rate = choices.rate().unwrap_or_default();
    let mut data = format!("CONTROL_FREQ_HZ = {}\nROWS = [\n", shortest(rate));
    for instant in plan.instants(choices.rate(), COLUMNS)? {
        let attitude = &instant.attitude;
        // ZYX angles of the attitude; the yaw is the plan's own, which is not wrapped.
        let roll = attitude[(2, 1)].atan2(attitude[(2, 2)]);
        let pitch = (-attitude[(2, 0)]).clamp(-1.0, 1.0).asin();
        let [yaw, rate] = instant.yaw;
        let row = instant.position.into_iter().chain([roll, pitch, yaw]).chain(instant.velocity).chain([rate]);
        data.push_str(&format!("    {},\n", list(row)));
    }
    data.push_str("]\n");
    let [subject, version] = plan.origin();
    Ok(TEMPLATE.replacen(PLACE, &data, 1).replacen(TITLE, &format!("{subject}. {version}"), 1))
}
