//! ArduPilot's DataFlash logs (`.bin`): messages of a type each, whose layout an `FMT` message gives. Source:
//! `AP_Logger/LogStructure.h` of ArduPilot 4.5.
//!
//! Bytes that are not a message are passed over to the next head; how many is counted.

use super::bytes::Input;
use super::collect::Collector;
use std::io;

/// The head of a message, and the type of `FMT`.
pub const HEAD: [u8; 2] = [0xa3, 0x95];
const FMT: u8 = 128;
const FMT_LENGTH: usize = 89;

/// The messages that are read, with their fields; a missing field is NaN. The first name of a field that the log has
/// counts.
const WANTED: [(&str, &[&str]); 19] = [
    ("RCOU", &["C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9", "C10", "C11", "C12", "C13", "C14"]),
    ("RCO2", &["C15", "C16", "C17", "C18"]),
    ("IMU", &["I", "GyrX", "GyrY", "GyrZ", "AccX", "AccY", "AccZ"]),
    ("RATE", &["AOut", "ROut", "POut", "YOut", "R", "P", "Y"]),
    ("ATT", &["Roll", "Pitch", "Yaw", "DesRoll", "DesPitch", "DesYaw"]),
    ("BARO", &["I", "Alt"]),
    ("XKF1", &["C", "VN", "VE", "VD", "PN", "PE", "PD"]),
    ("NKF1", &["C", "VN", "VE", "VD", "PN", "PE", "PD"]),
    ("EKF1", &["C", "VN", "VE", "VD", "PN", "PE", "PD"]),
    ("ESC", &["Instance|Inst|I", "RPM"]),
    ("ESC1", &["RPM"]),
    ("ESC2", &["RPM"]),
    ("ESC3", &["RPM"]),
    ("ESC4", &["RPM"]),
    ("ESC5", &["RPM"]),
    ("ESC6", &["RPM"]),
    ("ESC7", &["RPM"]),
    ("ESC8", &["RPM"]),
    ("PARM", &["Value"]),
];

/// Where a field is in a message, and its type.
#[derive(Debug, Clone, Copy)]
struct Field {
    at: usize,
    kind: u8,
}

/// A message that is read.
struct Layout {
    name: &'static str,
    time: Option<Field>,
    fields: Vec<Option<Field>>,
    /// Where the text of a parameter's name begins.
    text: Option<usize>,
}

/// The length of every type of message, and the layout of those that are read.
struct Formats {
    lengths: [usize; 256],
    layouts: Vec<Option<Layout>>,
}

/// The size of a field in bytes by its type.
fn size(kind: u8) -> Option<usize> {
    Some(match kind {
        b'b' | b'B' | b'M' => 1,
        b'h' | b'H' | b'c' | b'C' | b'g' => 2,
        b'i' | b'I' | b'f' | b'n' | b'e' | b'E' | b'L' => 4,
        b'd' | b'q' | b'Q' => 8,
        b'N' => 16,
        b'Z' | b'a' => 64,
        _ => return None,
    })
}

/// The value of a field; NaN for a text or beyond the message.
fn value(field: Field, message: &[u8]) -> f64 {
    let Some(bytes) = size(field.kind).and_then(|n| message.get(field.at..field.at + n)) else { return f64::NAN };
    let mut word = [0_u8; 8];
    word[..bytes.len().min(8)].copy_from_slice(&bytes[..bytes.len().min(8)]);
    let whole = u64::from_le_bytes(word);
    match field.kind {
        b'b' => f64::from(whole as u8 as i8),
        b'h' => f64::from(whole as u16 as i16),
        b'c' => f64::from(whole as u16 as i16) / 100.0,
        b'C' => f64::from(whole as u16) / 100.0,
        b'i' | b'L' => f64::from(whole as u32 as i32),
        b'e' => f64::from(whole as u32 as i32) / 100.0,
        b'E' => f64::from(whole as u32) / 100.0,
        b'f' => f64::from(f32::from_bits(whole as u32)),
        b'd' => f64::from_bits(whole),
        b'q' => whole as i64 as f64,
        b'B' | b'M' | b'H' | b'I' | b'Q' => whole as f64,
        _ => f64::NAN,
    }
}

/// A text that NUL ends.
fn text(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}

impl Formats {
    fn new() -> Self {
        let mut lengths = [0; 256];
        lengths[usize::from(FMT)] = FMT_LENGTH;
        Formats { lengths, layouts: (0..256).map(|_| None).collect() }
    }

    /// Takes a whole `FMT` message; one that contradicts itself is passed over.
    fn define(&mut self, message: &[u8]) {
        let (kind, length) = (message[3], usize::from(message[4]));
        if kind == FMT || length < 3 {
            return;
        }
        let (name, types, labels) = (text(&message[5..9]), &message[9..25], text(&message[25..89]));
        let mut at = 3;
        let mut fields: Vec<(&str, Field)> = Vec::new();
        for (kind, label) in types.iter().zip(labels.split(',')) {
            let Some(n) = size(*kind) else { break };
            fields.push((label, Field { at, kind: *kind }));
            at += n;
        }
        if at > length {
            return;
        }
        self.lengths[usize::from(kind)] = length;
        let find = |names: &str| {
            names.split('|').find_map(|name| fields.iter().find(|(label, _)| *label == name)).map(|(_, field)| *field)
        };
        let wanted = WANTED.iter().find(|(wanted, _)| *wanted == name);
        self.layouts[usize::from(kind)] = wanted.map(|(name, labels)| Layout {
            name,
            time: find("TimeUS|TimeMS"),
            fields: labels.iter().map(|label| find(label)).collect(),
            text: find("Name").filter(|field| field.kind == b'N').map(|field| field.at),
        });
    }
}

/// Reads a whole log, after its first bytes were recognised.
///
/// # Errors
/// The file cannot be read.
pub fn read(input: &mut Input, collector: &mut Collector) -> io::Result<()> {
    let mut formats = Formats::new();
    let mut values = Vec::new();
    loop {
        let head = input.peek(3)?;
        if head.len() < 3 {
            collector.damage.cut += head.len() as u64;
            return Ok(());
        }
        let kind = head[2];
        let length = formats.lengths[usize::from(kind)];
        if head[..2] != HEAD || length == 0 {
            collector.damage.skipped += 1;
            input.skip(1);
            continue;
        }
        let message = input.peek(length)?;
        if message.len() < length {
            collector.damage.cut += message.len() as u64;
            return Ok(());
        }
        if kind == FMT {
            formats.define(message);
        } else if let Some(layout) = &formats.layouts[usize::from(kind)] {
            let time = layout
                .time
                .map_or(f64::NAN, |field| value(field, message) * if field.kind == b'I' { 1e-3 } else { 1e-6 });
            values.clear();
            values.extend(layout.fields.iter().map(|field| field.map_or(f64::NAN, |field| value(field, message))));
            if let Some(at) = layout.text {
                collector.parameter(&text(&message[at..(at + 16).min(length)]), values[0], time);
            } else {
                collector.ardupilot(layout.name, time, &values);
            }
        }
        collector.damage.messages += 1;
        input.skip(length);
    }
}
