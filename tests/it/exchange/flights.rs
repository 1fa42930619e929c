//! Flight logs: ULog walked message by message, MCAP with its JSON.

use super::TURN;
use crate::cli::{err, mavc_with};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// Flies the turn; the log, its layout, and the same flight's table.
fn flown(format: &str) -> (Vec<u8>, String, Vec<Vec<f64>>) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let run = |arguments: &[&str]| {
        let ran = mavc_with(&[&["simulate", "-", "-q"], arguments].concat(), TURN);
        assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    };
    let name = |path: &Path| path.to_str().unwrap().to_string();
    let (log, layout, csv) = (name(&at("log")), name(&at("layout")), name(&at("flight.csv")));
    run(&["-o", &log, "--format", format, "--layout", &layout]);
    run(&["-o", &csv]);
    let text = std::fs::read_to_string(csv).unwrap();
    // Only the first columns: those of the estimator are empty at first.
    let rows = text.lines().skip(1).map(|line| line.split(',').take(7).map(|cell| cell.parse().unwrap()).collect());
    (std::fs::read(log).unwrap(), std::fs::read_to_string(layout).unwrap(), rows.collect())
}

#[test]
fn ulog_is_whole_and_in_the_frames_of_px4() {
    let (bytes, layout, rows) = flown("ulog");
    assert!(bytes.starts_with(b"ULog\x01\x12\x35\x01") && rows.len() > 300);
    let (mut formats, mut names, mut local) = (BTreeMap::new(), BTreeMap::new(), Vec::new());
    let mut at = 16;
    let mut kinds = String::new();
    while at < bytes.len() {
        let size = usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
        let (kind, content) = (bytes[at + 2], &bytes[at + 3..at + 3 + size]);
        kinds.push(kind.into());
        match kind {
            b'F' => {
                let text = String::from_utf8(content.to_vec()).unwrap();
                let (name, fields) = text.split_once(':').unwrap();
                formats.insert(name.to_string(), fields.to_string());
            }
            b'A' => {
                let id = u16::from_le_bytes([content[1], content[2]]);
                names.insert(id, String::from_utf8(content[3..].to_vec()).unwrap());
            }
            b'D' => {
                let name = &names[&u16::from_le_bytes([content[0], content[1]])];
                assert_eq!(content.len(), 2 + size_of_fields(&formats[name]), "{name}");
                if name == "vehicle_local_position" {
                    let time = u64::from_le_bytes(content[2..10].try_into().unwrap());
                    let floats = content[10..].chunks(4).map(|c| f32::from_le_bytes(c.try_into().unwrap()));
                    local.push((time, floats.collect::<Vec<f32>>()));
                }
            }
            _ => assert!([b'B', b'I'].contains(&kind)),
        }
        at += 3 + size;
    }
    assert_eq!(at, bytes.len());
    assert!(kinds.starts_with("BII") && local.len() == rows.len(), "{kinds:.40}");
    for ((time, floats), row) in local.iter().zip(&rows) {
        assert_eq!(*time, (row[0] * 1e6).round() as u64);
        let ned = [row[2], row[1], -row[3], row[5], row[4], -row[6]].map(|x| x as f32);
        assert_eq!(floats[..6], ned);
    }
    // Curves of the layout are fields of the log.
    let curves: Vec<&str> =
        layout.split("<curve name=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert!(curves.len() >= 16 && curves.contains(&"mavc_rotors/theta_4"), "{curves:?}");
    for curve in curves {
        let (topic, field) = curve.split_once('/').unwrap();
        assert!(formats[topic].contains(&format!("float {field};")), "{curve}");
    }
}

fn size_of_fields(fields: &str) -> usize {
    let sizes = fields.split(';').filter(|field| !field.is_empty()).map(|field| {
        let kind = field.split(' ').next().unwrap();
        let (kind, count) =
            kind.split_once('[').map_or((kind, 1), |(k, n)| (k, n.trim_end_matches(']').parse().unwrap()));
        count * if kind == "uint64_t" { 8 } else { 4 }
    });
    sizes.sum()
}

#[test]
fn mcap_has_every_number_of_the_table() {
    let (bytes, layout, rows) = flown("mcap");
    // JSON of the topic /flight begins with its time; other topics do not.
    let text = String::from_utf8_lossy(&bytes);
    let starts = text.match_indices("{\"t\":").map(|(at, _)| &text[at..]);
    let messages: Vec<Value> =
        starts.map(|rest| serde_json::Deserializer::from_str(rest).into_iter().next().unwrap().unwrap()).collect();
    assert!(messages.len() == rows.len() && rows.len() > 300);
    for (message, row) in messages.iter().zip(&rows) {
        let of = |group: &str| ["x", "y", "z"].map(|axis| message[group][axis].as_f64().unwrap());
        assert_eq!(message["t"].as_f64().unwrap(), row[0]);
        assert_eq!([of("position"), of("velocity")].concat(), row[1..7]);
        assert_eq!(message["rotors"].as_array().unwrap().len(), 4);
    }
    assert_eq!(text.matches("foxglove.PosesInFrame").count(), 4, "name and title, in the data and in the summary");
    let layout: Value = serde_json::from_str(&layout).unwrap();
    let panels = layout["configById"].as_object().unwrap();
    let paths = panels.values().flat_map(|panel| panel["paths"].as_array().into_iter().flatten());
    let paths: Vec<&str> = paths.map(|path| path["value"].as_str().unwrap()).collect();
    assert!(paths.contains(&"/flight.rotors[3].omega") && paths.contains(&"/flight.reference.z"), "{paths:?}");
}
