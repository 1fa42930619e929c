//! A flight as ULog, the format of PX4's logs. Topics have the names, fields and frames of PX4's where these exist
//! (`vehicle_local_position`, `vehicle_attitude`, `vehicle_angular_velocity`, `trajectory_setpoint`, `sensor_combined`,
//! `actuator_motors`); topics of mavc begin with `mavc_`. <https://docs.px4.io/main/en/dev_log/ulog_file_format.html>

use super::Row;
use crate::exchange::bytes::Bytes;
use crate::exchange::frames::{Frame, wrapped};

const MAGIC: &[u8] = b"ULog\x01\x12\x35";
const VERSION: u8 = 1;

/// A topic: its name, the declaration of its fields after the time, and its values at an instant.
struct Topic {
    name: &'static str,
    fields: String,
    values: fn(&Row) -> Vec<f64>,
}

/// The topics of a vehicle; that of commands only where PX4's has room for its motors.
fn topics(rotors: usize, has_commands: bool) -> Vec<Topic> {
    let each = |names: &[&str]| {
        let of_rotor = |k: usize| names.iter().map(move |name| format!("float {name}_{k};"));
        (1..=rotors).flat_map(of_rotor).collect::<String>()
    };
    let topic = |name, fields: &str, values| Topic { name, fields: fields.into(), values };
    let commands = topic("actuator_motors", "float[12] control;", |row| row.commands.into_iter().flatten().collect());
    let mut topics = vec![
        topic("vehicle_local_position", "float x;float y;float z;float vx;float vy;float vz;float heading;", |row| {
            let [position, velocity] = [row.position, row.velocity].map(|v| Frame::NedFrd.world(v));
            [&position[..], &velocity, &[wrapped(Frame::NedFrd.yaw(row.angles[2]))]].concat()
        }),
        topic("vehicle_attitude", "float[4] q;", |row| {
            let [w, x, y, z] = row.attitude;
            let attitude = nalgebra::UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, x, y, z));
            Frame::NedFrd.quaternion(attitude.to_rotation_matrix().matrix()).to_vec()
        }),
        topic("vehicle_angular_velocity", "float[3] xyz;", |row| Frame::NedFrd.body(row.rates).to_vec()),
        topic("trajectory_setpoint", "float[3] position;float[3] velocity;float yaw;float yawspeed;", |row| {
            let [position, velocity] = [row.reference, row.reference_velocity].map(|v| Frame::NedFrd.world(v));
            let [yaw, rate] = row.reference_yaw;
            let heading = [wrapped(Frame::NedFrd.yaw(yaw)), Frame::NedFrd.yaw_rate(rate)];
            [&position[..], &velocity, &heading].concat()
        }),
        topic("mavc_errors", "float position;float heading;float tilt;", |row| {
            vec![row.error, row.heading_error, row.tilt]
        }),
        topic(
            "mavc_wrench",
            "float thrust;float tau_x;float tau_y;float tau_z;float thrust_cmd;float tau_x_cmd;float tau_y_cmd;float \
             tau_z_cmd;",
            |row| {
                let turned = |[thrust, x, y, z]: [f64; 4]| {
                    let torque = Frame::NedFrd.body([x, y, z]);
                    [thrust, torque[0], torque[1], torque[2]]
                };
                [turned(row.wrench), turned(row.demanded)].concat()
            },
        ),
        topic("mavc_rotors", &each(&["omega", "theta", "believed"]), |row| row.rotors.concat()),
        // NaN as long as nothing is estimated.
        topic("mavc_estimator", "float regressor_rank;float regressor_condition;", |row| {
            row.regressor.unwrap_or([f64::NAN; 2]).to_vec()
        }),
        // Measured, while the topics of `vehicle_` are true.
        topic("sensor_combined", "float[3] gyro_rad;float[3] accelerometer_m_s2;", |row| {
            row.inertial.map(|reading| Frame::NedFrd.body(reading)).concat()
        }),
    ];
    topics.extend(has_commands.then_some(commands));
    topics
}

/// The whole log. Numbers are float32, times microseconds.
pub(super) fn bytes(rows: &[Row]) -> Vec<u8> {
    let mut out = Bytes(MAGIC.to_vec());
    out.u8(VERSION).u64(0);
    // No flags, no appended data.
    message(&mut out, b'B', &[0; 40]);
    let first = rows.first();
    let topics = topics(first.map_or(0, |row| row.rotors.len()), first.is_some_and(|row| row.commands.is_some()));
    for (key, value) in [("sys_name", "mavc"), ("ver_sw", env!("CARGO_PKG_VERSION"))] {
        let key = format!("char[{}] {key}", value.len());
        let mut content = Bytes::default();
        content.u8(key.len() as u8).raw(key.as_bytes()).raw(value.as_bytes());
        message(&mut out, b'I', &content.0);
    }
    for Topic { name, fields, .. } in &topics {
        message(&mut out, b'F', format!("{name}:uint64_t timestamp;{fields}").as_bytes());
    }
    for (id, topic) in topics.iter().enumerate() {
        let mut content = Bytes::default();
        content.u8(0).u16(id as u16).raw(topic.name.as_bytes());
        message(&mut out, b'A', &content.0);
    }
    for row in rows {
        for (id, topic) in topics.iter().enumerate() {
            let mut content = Bytes::default();
            content.u16(id as u16).u64((row.time * 1e6).round() as u64);
            (topic.values)(row).into_iter().for_each(|value| {
                content.f32(value as f32);
            });
            message(&mut out, b'D', &content.0);
        }
    }
    out.0
}

/// A message: size and kind before the content.
fn message(out: &mut Bytes, kind: u8, content: &[u8]) {
    out.u16(content.len() as u16).u8(kind).raw(content);
}
