//! Rows with the whole state of a vehicle that follows the plan.

use super::{Choices, Exported};
use crate::report::trajectory_csv::push_row;

const HEADER: &str = "t,x,y,z,vx,vy,vz,ax,ay,az,jx,jy,jz,qw,qx,qy,qz,p,q,r,thrust,thrust_share,yaw,yawspeed,waypoint";

/// The table. The last column is empty in rows that mark no waypoint.
pub(super) fn text(plan: &Exported, choices: &Choices) -> Result<String, String> {
    let frame = choices.frame();
    let mut out = format!("{HEADER}\n");
    for instant in plan.instants(choices.rate(), HEADER)? {
        let mut row = vec![instant.time];
        for vector in [instant.position, instant.velocity, instant.acceleration, instant.jerk] {
            row.extend(frame.world(vector));
        }
        row.extend(frame.quaternion(&instant.attitude));
        row.extend(frame.body(instant.rates));
        row.extend([instant.thrust, instant.share, frame.yaw(instant.yaw[0]), frame.yaw_rate(instant.yaw[1])]);
        push_row(&mut out, &row);
        out.pop();
        out.push(',');
        if instant.waypoint > 0 {
            out.push_str(&instant.waypoint.to_string());
        }
        out.push('\n');
    }
    Ok(out)
}
