//! PX4's ULog: definitions of topics, then samples of subscribed topics. Source: PX4's documentation, "ULog File
//! Format".
//!
//! After a message that cannot be one (an unknown kind, a sample of an unknown topic or of the wrong length) the bytes
//! up to the next one that can be are passed over and counted.

use super::bytes::Input;
use super::collect::Collector;
use std::collections::HashMap;
use std::io;

/// The first bytes; the version and the time of the start follow.
pub const MAGIC: [u8; 7] = *b"ULog\x01\x12\x35";
const HEADER: usize = 16;

/// Bounds of definitions: more are passed over.
const MOST_FORMATS: usize = 2000;
const DEEPEST: usize = 6;

/// The topics that are read, with their fields; a missing field is NaN. The first name of a field that the log has
/// counts. `name[3]` is three fields.
const WANTED: [(&str, &[&str]); 9] = [
    ("actuator_motors", &["control[12]"]),
    ("actuator_outputs", &["noutputs", "output[16]"]),
    ("vehicle_angular_velocity", &["xyz[3]"]),
    ("sensor_combined", &["gyro_rad[3]", "accelerometer_m_s2[3]"]),
    ("vehicle_attitude", &["q[4]"]),
    ("vehicle_local_position", &["z", "vz"]),
    ("vehicle_air_data", &["baro_alt_meter"]),
    ("esc_status", &["esc.esc_rpm[8]"]),
    // Of simulated flights of mavc.
    (
        "mavc_rotors",
        &[
            "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "omega_7", "omega_8", "omega_9",
            "omega_10", "omega_11", "omega_12", "omega_13", "omega_14", "omega_15", "omega_16",
        ],
    ),
];

/// A number in a sample.
#[derive(Debug, Clone, Copy)]
struct Field {
    at: usize,
    kind: Kind,
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    Signed(usize),
    Unsigned(usize),
    Float,
    Double,
}

impl Kind {
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "int8_t" => Kind::Signed(1),
            "int16_t" => Kind::Signed(2),
            "int32_t" => Kind::Signed(4),
            "int64_t" => Kind::Signed(8),
            "uint8_t" | "bool" | "char" => Kind::Unsigned(1),
            "uint16_t" => Kind::Unsigned(2),
            "uint32_t" => Kind::Unsigned(4),
            "uint64_t" => Kind::Unsigned(8),
            "float" => Kind::Float,
            "double" => Kind::Double,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Kind::Signed(n) | Kind::Unsigned(n) => n,
            Kind::Float => 4,
            Kind::Double => 8,
        }
    }
}

/// The value of a field; NaN beyond the message.
fn value(field: Field, message: &[u8]) -> f64 {
    let n = field.kind.size();
    let Some(bytes) = message.get(field.at..field.at + n) else { return f64::NAN };
    let mut word = [0_u8; 8];
    word[..n].copy_from_slice(bytes);
    let whole = u64::from_le_bytes(word);
    match field.kind {
        Kind::Float => f64::from(f32::from_bits(whole as u32)),
        Kind::Double => f64::from_bits(whole),
        Kind::Unsigned(_) => whole as f64,
        Kind::Signed(n) => (((whole << (64 - 8 * n)) as i64) >> (64 - 8 * n)) as f64,
    }
}

/// A topic as the log defines it: type, number and name of its fields.
type Format = Vec<(String, usize, String)>;

#[derive(Default)]
struct Definitions {
    formats: HashMap<String, Format>,
    sizes: HashMap<String, Option<usize>>,
    /// By the number of the subscription.
    topics: HashMap<u16, Topic>,
}

/// A subscribed topic.
struct Topic {
    /// The least and the greatest length of its samples: padding at the end is not written.
    lengths: [usize; 2],
    /// `None` if it is not read.
    wanted: Option<Wanted>,
}

/// What is read of a topic.
struct Wanted {
    name: &'static str,
    fields: Vec<Option<Field>>,
    time: Option<Field>,
}

/// `float[3] xyz` to type, number and name.
fn declared(text: &str) -> Option<(String, usize, String)> {
    let (kind, name) = text.trim().split_once(' ')?;
    let (kind, count) = match kind.split_once('[') {
        Some((kind, count)) => (kind, count.strip_suffix(']')?.parse().ok().filter(|n| *n <= 65_536)?),
        None => (kind, 1),
    };
    Some((kind.to_string(), count, name.to_string()))
}

impl Definitions {
    fn define(&mut self, text: &str) {
        let Some((name, fields)) = text.split_once(':') else { return };
        let fields: Option<Format> = fields.split(';').filter(|f| !f.trim().is_empty()).map(declared).collect();
        if let Some(fields) = fields.filter(|_| self.formats.len() < MOST_FORMATS) {
            self.formats.insert(name.to_string(), fields);
        }
    }

    /// The size of a type in bytes; `None` if it is not defined, contains itself or is too large.
    fn size(&mut self, kind: &str, depth: usize) -> Option<usize> {
        if let Some(basic) = Kind::of(kind) {
            return Some(basic.size());
        }
        if let Some(known) = self.sizes.get(kind) {
            return *known;
        }
        let fields = self.formats.get(kind).filter(|_| depth < DEEPEST)?.clone();
        let mut total: Option<usize> = Some(0);
        for (kind, count, _) in &fields {
            let size = self.size(kind, depth + 1).and_then(|size| size.checked_mul(*count));
            total = total.zip(size).map(|(a, b)| a + b).filter(|sum| *sum <= 65_535);
        }
        self.sizes.insert(kind.to_string(), total);
        total
    }

    /// The place of a field in a type: `xyz`, or `esc.esc_rpm` of the `index`-th element.
    fn field(&mut self, kind: &str, path: &str, index: usize) -> Option<Field> {
        let (name, inner) = path.split_once('.').map_or((path, None), |(name, inner)| (name, Some(inner)));
        let fields = self.formats.get(kind)?.clone();
        let mut at = 0;
        for (kind, count, own) in &fields {
            let size = self.size(kind, 0)?;
            if own == name {
                let at = at + size * index;
                return match inner {
                    _ if index >= *count => None,
                    Some(inner) => self.field(kind, inner, 0).map(|field| Field { at: field.at + at, ..field }),
                    None => Kind::of(kind).map(|kind| Field { at, kind }),
                };
            }
            at += size * count;
        }
        None
    }

    /// Takes a subscription.
    fn subscribe(&mut self, instance: u8, number: u16, name: &str) {
        let Some(size) = self.size(name, 0) else { return };
        let last = self.formats.get(name).and_then(|fields| fields.last()).cloned();
        let padding = match last {
            Some((kind, count, name)) if name.starts_with("_padding") => {
                self.size(&kind, 0).map_or(0, |size| size * count)
            }
            _ => 0,
        };
        let wanted = WANTED.iter().find(|(topic, _)| *topic == name && instance == 0).map(|(topic, paths)| {
            let mut fields = Vec::new();
            for path in *paths {
                let (path, count) = match path.split_once('[') {
                    Some((path, count)) => (path, count.trim_end_matches(']').parse().unwrap_or(1)),
                    None => (*path, 1),
                };
                fields.extend((0..count).map(|k| self.field(name, path, k)));
            }
            Wanted { name: topic, fields, time: self.field(name, "timestamp", 0) }
        });
        self.topics.insert(number, Topic { lengths: [size.saturating_sub(padding), size], wanted });
    }
}

/// Whether bytes may be the head of a message: length and kind.
fn may_be(length: usize, kind: u8) -> bool {
    match kind {
        b'B' => length == 40,
        b'F' | b'I' | b'M' | b'P' | b'Q' | b'A' => (3..=8192).contains(&length),
        b'R' | b'O' => length == 2,
        b'L' | b'C' => (9..=4096).contains(&length),
        b'S' => length == 8,
        b'D' => length >= 2,
        _ => false,
    }
}

/// The parameter of a message: its name and value.
fn parameter(body: &[u8]) -> Option<(&str, f64)> {
    let (length, rest) = body.split_first()?;
    let key = std::str::from_utf8(rest.get(..usize::from(*length))?).ok()?;
    let bytes: [u8; 4] = rest.get(usize::from(*length)..)?.try_into().ok()?;
    let (kind, name) = key.split_once(' ')?;
    match kind {
        "int32_t" => Some((name, f64::from(i32::from_le_bytes(bytes)))),
        "float" => Some((name, f64::from(f32::from_le_bytes(bytes)))),
        _ => None,
    }
}

/// Reads a whole log, after its first bytes were recognised.
///
/// # Errors
/// The file cannot be read.
pub fn read(input: &mut Input, collector: &mut Collector) -> io::Result<()> {
    input.peek(HEADER)?;
    input.skip(HEADER);
    let mut known = Definitions::default();
    let mut values = Vec::new();
    loop {
        let head = input.peek(5)?;
        if head.len() < 3 {
            collector.damage.cut += head.len() as u64;
            return Ok(());
        }
        let (length, kind) = (usize::from(u16::from_le_bytes([head[0], head[1]])), head[2]);
        let number = u16::from_le_bytes([head.get(3).copied().unwrap_or(0), head.get(4).copied().unwrap_or(0)]);
        let topic = known.topics.get(&number);
        let fits = match topic {
            _ if kind != b'D' => may_be(length, kind),
            Some(topic) => (topic.lengths[0]..=topic.lengths[1]).contains(&length.wrapping_sub(2)),
            None => false,
        };
        if !fits {
            collector.damage.skipped += 1;
            input.skip(1);
            continue;
        }
        let message = input.peek(3 + length)?;
        if message.len() < 3 + length {
            collector.damage.cut += message.len() as u64;
            return Ok(());
        }
        let body = &message[3..];
        match kind {
            b'F' => {
                if let Ok(text) = std::str::from_utf8(body) {
                    known.define(text);
                }
            }
            b'A' => {
                if let Ok(name) = std::str::from_utf8(&body[3..]) {
                    known.subscribe(body[0], u16::from_le_bytes([body[1], body[2]]), name);
                }
            }
            b'P' => {
                if let Some((name, value)) = parameter(body) {
                    collector.parameter(name, value, f64::NAN);
                }
            }
            b'D' => {
                if let Some(Wanted { name, fields, time }) = topic.and_then(|topic| topic.wanted.as_ref()) {
                    let sample = &body[2..];
                    let time = time.map_or(f64::NAN, |field| value(field, sample) * 1e-6);
                    values.clear();
                    values.extend(fields.iter().map(|field| field.map_or(f64::NAN, |field| value(field, sample))));
                    collector.px4(name, time, &values);
                }
            }
            _ => {}
        }
        collector.damage.messages += 1;
        input.skip(3 + length);
    }
}
