//! A ROS 2 bag, in MCAP storage, with one `trajectory_msgs/msg/MultiDOFJointTrajectory`.

use super::{Choices, Exported};
use crate::exchange::cdr::Message;
use crate::exchange::frames::Frame;
use crate::exchange::mcap::{Schema, Writer};

/// The topic that controllers of mav_msgs listen to.
const TOPIC: &str = "/command/trajectory";
const KIND: &str = "trajectory_msgs/msg/MultiDOFJointTrajectory";
const DEFINITION: &str = include_str!("../../../../assets/exchange/MultiDOFJointTrajectory.msg");

/// Columns of a point, to bound the size of the message.
const COLUMNS: &str = "x,y,z,qx,qy,qz,qw,vx,vy,vz,p,q,r,ax,ay,az,p1,q1,r1,t";

/// The only message is at time 0, and so are start and end of the bag.
pub(super) fn mcap(plan: &Exported, choices: &Choices) -> Result<Vec<u8>, String> {
    let instants = plan.instants(choices.rate(), COLUMNS)?;
    let mut message = Message::new();
    message.time(0.0).text("world");
    message.u32(1).text("vehicle").u32(instants.len() as u32);
    for instant in instants {
        let [w, x, y, z] = Frame::EnuFlu.quaternion(&instant.attitude);
        // Rates in the frame of the header, as mav_msgs has them; R (w x w) = 0, so their derivative is R w'.
        let world = |body: [f64; 3]| -> [f64; 3] { (instant.attitude * nalgebra::Vector3::from(body)).into() };
        message.u32(1).f64s(&instant.position).f64s(&[x, y, z, w]);
        message.u32(1).f64s(&instant.velocity).f64s(&world(instant.rates));
        message.u32(1).f64s(&instant.acceleration).f64s(&world(instant.turning));
        message.time(instant.time);
    }
    let mut writer = Writer::new("ros2");
    let channel = writer.channel(
        TOPIC,
        "cdr",
        Schema { name: KIND, encoding: "ros2msg", text: DEFINITION },
        &[("offered_qos_profiles", "")],
    );
    writer.message(channel, 0, &message.finish());
    Ok(writer.finish())
}

/// The file `metadata.yaml` of the bag in the file `name`.
pub(super) fn metadata(name: &str) -> String {
    format!(
        "rosbag2_bagfile_information:
  version: 5
  storage_identifier: mcap
  duration:
    nanoseconds: 0
  starting_time:
    nanoseconds_since_epoch: 0
  message_count: 1
  topics_with_message_count:
    - topic_metadata:
        name: {TOPIC}
        type: {KIND}
        serialization_format: cdr
        offered_qos_profiles: \"\"
      message_count: 1
  compression_format: \"\"
  compression_mode: \"\"
  relative_file_paths:
    - {name}
  files:
    - path: {name}
      starting_time:
        nanoseconds_since_epoch: 0
      duration:
        nanoseconds: 0
      message_count: 1
"
    )
}
