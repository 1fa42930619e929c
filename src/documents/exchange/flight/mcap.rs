//! A flight as MCAP with messages in JSON, for Foxglove: the vehicle and its reference as frames (`/tf`), the
//! reference's path (`/path`), and every number of the log (`/flight`).

use super::Row;
use crate::exchange::mcap::{Schema, Writer};
use serde_json::{Value, json};

/// Foxglove's schema of a frame within another.
const FRAME: &str = include_str!("../../../../assets/exchange/frame_transform.json");

/// Foxglove's schema of a path.
const PATH: &str = include_str!("../../../../assets/exchange/poses_in_frame.json");

/// mavc's own schema: groups of numbers in SI units.
const FLIGHT: &str = include_str!("../../../../assets/exchange/flight.json");

/// Most poses of the drawn path.
const POSES: usize = 1000;

/// The whole file; times from 0.
pub(super) fn bytes(rows: &[Row]) -> Vec<u8> {
    let mut writer = Writer::new("");
    let mut channel =
        |topic, name, text| writer.channel(topic, "json", Schema { name, encoding: "jsonschema", text }, &[]);
    let tf = channel("/tf", "foxglove.FrameTransform", FRAME);
    let path = channel("/path", "foxglove.PosesInFrame", PATH);
    let flight = channel("/flight", "mavc.Flight", FLIGHT);
    let mut put = |channel: usize, time: f64, value: Value| {
        writer.message(channel, nanoseconds(time), value.to_string().as_bytes());
    };
    if let Some(first) = rows.first() {
        let every = rows.len().div_ceil(POSES);
        let poses = rows.iter().step_by(every).map(|row| {
            let [w, z] = about_z(row.reference_yaw[0]);
            json!({"position": vector(row.reference), "orientation": {"x": 0.0, "y": 0.0, "z": z, "w": w}})
        });
        let poses: Vec<Value> = poses.collect();
        put(path, first.time, json!({"timestamp": stamp(first.time), "frame_id": "world", "poses": poses}));
    }
    for row in rows {
        let [w, x, y, z] = row.attitude;
        let attitude = json!({"x": x, "y": y, "z": z, "w": w});
        put(tf, row.time, frame("vehicle", row.time, row.position, attitude));
        let [w, z] = about_z(row.reference_yaw[0]);
        put(tf, row.time, frame("reference", row.time, row.reference, json!({"x": 0.0, "y": 0.0, "z": z, "w": w})));
        put(flight, row.time, numbers(row));
    }
    writer.finish()
}

fn frame(name: &str, time: f64, position: [f64; 3], rotation: Value) -> Value {
    json!({
        "timestamp": stamp(time),
        "parent_frame_id": "world",
        "child_frame_id": name,
        "translation": vector(position),
        "rotation": rotation,
    })
}

fn numbers(row: &Row) -> Value {
    let [roll, pitch, yaw] = row.angles;
    let [p, q, r] = row.rates;
    let [x, y, z] = row.reference;
    let wrench = |[thrust, x, y, z]: [f64; 4]| json!({"thrust": thrust, "tau_x": x, "tau_y": y, "tau_z": z});
    let rotors =
        row.rotors.iter().map(|[omega, theta, believed]| json!({"omega": omega, "theta": theta, "believed": believed}));
    json!({
        "t": row.time,
        "position": vector(row.position),
        "velocity": vector(row.velocity),
        "angles": {"roll": roll, "pitch": pitch, "yaw": yaw},
        "rates": {"p": p, "q": q, "r": r},
        "reference": {"x": x, "y": y, "z": z, "yaw": row.reference_yaw[0]},
        "error": row.error,
        "heading_error": row.heading_error,
        "tilt": row.tilt,
        "wrench": wrench(row.wrench),
        "demanded": wrench(row.demanded),
        "rotors": rotors.collect::<Vec<Value>>(),
        "regressor_rank": row.regressor.map(|[rank, _]| rank),
        "regressor_condition": row.regressor.map(|[_, condition]| condition),
    })
}

fn vector([x, y, z]: [f64; 3]) -> Value {
    json!({"x": x, "y": y, "z": z})
}

/// The quaternion w, z of a yaw (rad).
fn about_z(yaw: f64) -> [f64; 2] {
    let (sin, cos) = (0.5 * yaw).sin_cos();
    [cos, sin]
}

fn nanoseconds(time: f64) -> u64 {
    (time * 1e9).round() as u64
}

fn stamp(time: f64) -> Value {
    let all = nanoseconds(time);
    json!({"sec": all / 1_000_000_000, "nsec": all % 1_000_000_000})
}
