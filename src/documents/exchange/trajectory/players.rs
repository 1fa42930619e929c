//! Scripts in Python that carry a plan and play it to an autopilot.

use super::px4::{heading, single, world};
use super::{Choices, Exported};

const PX4_OFFBOARD: &str = include_str!("../../../../assets/exchange/px4_offboard.py");
const ARDUPILOT_GUIDED: &str = include_str!("../../../../assets/exchange/ardupilot_guided.py");

/// The line of a script in whose place the plan is written.
const PLACE: &str = "SETPOINTS = []  # the plan\n";
/// What stands for the plan in the first line of a script's documentation.
const TITLE: &str = "A PLAN";

/// Columns of a setpoint, to bound the size of the script.
const COLUMNS: &str = "t,n,e,d,vn,ve,vd,an,ae,ad,yaw,yawspeed";

/// For MAVSDK: `set_position_velocity_acceleration_ned`.
pub(super) fn px4_offboard(plan: &Exported, choices: &Choices) -> Result<String, String> {
    script(PX4_OFFBOARD, plan, choices)
}

/// For pymavlink: `SET_POSITION_TARGET_LOCAL_NED` in GUIDED mode.
pub(super) fn ardupilot_guided(plan: &Exported, choices: &Choices) -> Result<String, String> {
    script(ARDUPILOT_GUIDED, plan, choices)
}

fn script(template: &str, plan: &Exported, choices: &Choices) -> Result<String, String> {
    let mut rows = String::from("SETPOINTS = [\n");
    for instant in plan.instants(choices.rate(), COLUMNS)? {
        let vectors = [instant.position, instant.velocity, instant.acceleration].map(world).concat();
        let cells: Vec<String> = vectors.into_iter().chain(heading(&instant)).map(single).collect();
        rows.push_str(&format!("    ({}, {}),\n", crate::number::shortest(instant.time), cells.join(", ")));
    }
    rows.push_str("]\n");
    let [subject, version] = plan.origin();
    Ok(template.replacen(PLACE, &rows, 1).replacen(TITLE, &format!("{subject}. {version}"), 1))
}
