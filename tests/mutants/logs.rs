//! Logs of both autopilots with one to six changes, through `mavc diagnose` and `mavc identify`.
//!
//! A log is a list of messages, and most changes are of that list: definitions left out, twice or elsewhere, lengths and
//! declarations that contradict it, numbers that are none, times that go backwards or race. A few bytes are changed
//! besides, and the end is cut.

use crate::flying::{self, Fault};
use crate::mutate::Numbers;
use mavc::exchange::flight::{Format, Recorder};
use mavc::flight::Sample;
use mavc::observer::Silent;
use mavc::pipeline::{Undiagnosed, Why, diagnose, fly_plan, identify};
use mavc::report::diagnosis::{DiagnosisRecord, screen};

/// A quadcopter that loses half of a rotor's thrust, in the frame of the parameters of [`ulog`].
const SPEC: &str = "vehicle v {
    layout = \"PNPN\"; arm = 0.2 m; first = 45 deg; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
    rotor { max_thrust = 6 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s; time_constant = 30 ms }
}
faults { mode F { rotor 1 reduced to 50 % } }
mission m { start at [0, 0, 20] m; waypoint at [4, 0, 22] m }
plan { planner = rip; against = []; time = 8 s; samples = 20 }
simulate { fault F at 4.5 s; duration = 6 s; detection = never; lost_beyond = 15 m; lost_yaw = off; control_rate = 200 Hz }
";

/// What stands in place of a number of a message, as its bytes.
const FLOATS: [f32; 10] =
    [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45, -0.0, 1e9, -1.0, 65_536.0];
/// Times, us.
const TIMES: [u64; 8] = [0, 1, u64::MAX, u64::MAX / 2, 1 << 53, 1 << 32, 3_600_000_000, 1_000_000_000_000_000];
/// Parts of definitions that are replaced by one another.
const WORDS: [&str; 18] = [
    "float",
    "double",
    "uint8_t",
    "uint64_t",
    "int32_t",
    "float[3]",
    "float[60000]",
    "[65535]",
    "[0]",
    "[]",
    "timestamp",
    "TimeUS",
    "GyrX",
    "C1",
    "sensor_combined",
    "actuator_motors",
    ";",
    ":",
];

/// A format of logs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    DataFlash,
    Ulog,
}

/// A log as its messages; the first is the head of the file, which ULog has.
pub struct Log {
    kind: Kind,
    messages: Vec<Vec<u8>>,
}

/// The logs that are changed.
pub fn corpus() -> Vec<Log> {
    let simulated = ulog();
    let mut px4 = Log { kind: Kind::Ulog, messages: simulated.messages.clone() };
    // Without mavc's own topic it is a log of PX4.
    px4.messages.retain(|message| !String::from_utf8_lossy(message).contains("mavc_"));
    let faults = [
        Fault::None,
        Fault::Capacity(3, 4.0, 0.0),
        Fault::Off(2, 4.0),
        Fault::Held(2, 4.0, 1500),
        Fault::Stuck(1, 4.0, 0.2),
        Fault::Steps,
        Fault::Fades(3, 3.0, 0.2, 2.0),
    ];
    // Each autopilot equally often.
    let repeated = [&simulated, &px4, &simulated, &px4, &simulated]
        .map(|log| Log { kind: log.kind, messages: log.messages.clone() });
    faults.map(dataflash).into_iter().chain([simulated, px4]).chain(repeated).collect()
}

/// A DataFlash log with every kind of message that is read.
fn dataflash(fault: Fault) -> Log {
    let mut bytes = flying::log(fault, 5.5, 10.0, 25.0, 3);
    let kinds: [(u8, &str, &str, &str); 8] = [
        (10, "ATT", "Qffffff", "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw"),
        (11, "BARO", "QBf", "TimeUS,I,Alt"),
        (12, "XKF1", "QBffffff", "TimeUS,C,VN,VE,VD,PN,PE,PD"),
        (13, "BAT", "QBff", "TimeUS,Inst,Volt,Curr"),
        (14, "ESC", "QBf", "TimeUS,Instance,RPM"),
        (15, "EV", "QB", "TimeUS,Id"),
        (16, "RCO2", "QHHHH", "TimeUS,C15,C16,C17,C18"),
        (17, "ARM", "QB", "TimeUS,ArmState"),
    ];
    for (number, name, types, labels) in kinds {
        let size: usize = types
            .bytes()
            .map(|kind| match kind {
                b'Q' => 8,
                b'f' => 4,
                b'H' => 2,
                _ => 1,
            })
            .sum();
        let mut text = [0_u8; 84];
        text[..name.len()].copy_from_slice(name.as_bytes());
        text[4..4 + types.len()].copy_from_slice(types.as_bytes());
        text[20..20 + labels.len()].copy_from_slice(labels.as_bytes());
        bytes.extend([0xa3, 0x95, 128, number, (3 + size) as u8]);
        bytes.extend(text);
        for step in 0..28_u64 {
            bytes.extend([0xa3, 0x95, number]);
            bytes.extend((5_000_000 + 250_000 * step).to_le_bytes());
            for kind in types.bytes().skip(1) {
                match kind {
                    b'f' => bytes.extend((step as f32).to_le_bytes()),
                    b'H' => bytes.extend((1100 + step as u16).to_le_bytes()),
                    _ => bytes.push(if name == "EV" { 10 } else { (step % 4) as u8 }),
                }
            }
        }
    }
    Log { kind: Kind::DataFlash, messages: split(Kind::DataFlash, &bytes) }
}

/// The ULog of a simulated flight, with parameters that place its motors and a topic within another.
fn ulog() -> Log {
    let spec = mavc::compile(SPEC).spec.expect("a spec");
    let Ok(planning) = mavc::plan(&spec) else { panic!("a plan") };
    let solved = planning.plan().expect("a plan");
    let mut recorder = Recorder::new(Format::Ulog, spec.model(), Some(25.0), solved.time).expect("a log");
    let mut record = |sample: &Sample| recorder.add(sample);
    fly_plan(&spec, solved, Some(&mut record), &Silent);
    let mut messages = split(Kind::Ulog, &recorder.finish());
    let mut added = Vec::new();
    let mut add = |kind: u8, body: &[u8]| {
        added.push([&(body.len() as u16).to_le_bytes()[..], &[kind], body].concat());
    };
    let mut parameter = |name: String, value: f32| {
        let key = format!("float {name}");
        add(b'P', &[&[key.len() as u8], key.as_bytes(), &value.to_le_bytes()].concat());
    };
    parameter("CA_ROTOR_COUNT".into(), 4.0);
    for (k, (x, y, turn)) in
        [(0.14, 0.14, 0.05), (-0.14, -0.14, 0.05), (0.14, -0.14, -0.05), (-0.14, 0.14, -0.05)].into_iter().enumerate()
    {
        [("PX", x), ("PY", y), ("PZ", 0.0), ("KM", turn), ("CT", 6.5)]
            .into_iter()
            .for_each(|(name, value)| parameter(format!("CA_ROTOR{k}_{name}"), value));
    }
    add(b'F', b"esc_report:uint64_t timestamp;int32_t esc_rpm;float esc_voltage;uint8_t[4] _padding0;");
    add(b'F', b"esc_status:uint64_t timestamp;uint16_t counter;esc_report[8] esc;uint8_t[6] _padding0;");
    add(b'A', b"\0\x40\0esc_status");
    for step in 0..40_u64 {
        let mut body = vec![0x40, 0];
        body.extend((200_000 * step).to_le_bytes());
        body.extend(1_u16.to_le_bytes());
        for motor in 0..8_i32 {
            body.extend((200_000 * step).to_le_bytes());
            body.extend((5000 + 10 * motor).to_le_bytes());
            body.extend([0; 8]);
        }
        add(b'D', &body);
    }
    // After the head and the flags.
    messages.splice(2..2, added);
    Log { kind: Kind::Ulog, messages }
}

fn split(kind: Kind, bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut messages = Vec::new();
    let mut at = 0;
    let mut lengths = [0_usize; 256];
    lengths[128] = 89;
    while at < bytes.len() {
        let length = match kind {
            Kind::Ulog if at == 0 => 16,
            Kind::Ulog => 3 + usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]])),
            Kind::DataFlash => lengths[usize::from(bytes[at + 2])],
        };
        let message = bytes[at..at + length].to_vec();
        if kind == Kind::DataFlash && message[2] == 128 {
            lengths[usize::from(message[3])] = usize::from(message[4]);
        }
        messages.push(message);
        at += length;
    }
    messages
}

/// What a mutant of the corpus is: the bytes of a file.
pub fn mutant(corpus: &[Log], numbers: &mut Numbers) -> Vec<u8> {
    let log = &corpus[numbers.below(corpus.len())];
    let mut messages = log.messages.clone();
    for _ in 0..=numbers.below(6) {
        changed(log.kind, &mut messages, corpus, numbers);
    }
    let mut bytes = messages.concat();
    if numbers.below(5) == 0 {
        bytes.truncate(numbers.below(bytes.len() + 1));
    }
    if numbers.below(4) == 0 {
        for _ in 0..numbers.below(20) {
            let at = numbers.below(bytes.len());
            if let Some(byte) = bytes.get_mut(at) {
                *byte ^= 1 << numbers.below(8);
            }
        }
    }
    bytes
}

/// Whether a message is a definition or a parameter, and not a sample.
fn is_definition(kind: Kind, message: &[u8]) -> bool {
    match kind {
        Kind::Ulog => message.get(2).is_some_and(|kind| b"FAP".contains(kind)),
        Kind::DataFlash => message.get(2).is_some_and(|kind| [128, 1].contains(kind)),
    }
}

/// Where the time of a sample begins.
fn time_at(kind: Kind, message: &[u8]) -> Option<usize> {
    match kind {
        Kind::Ulog => (message.get(2) == Some(&b'D') && message.len() >= 13).then_some(5),
        Kind::DataFlash => (message.get(2) != Some(&128) && message.len() >= 11).then_some(3),
    }
}

fn put(message: &mut [u8], at: usize, bytes: &[u8]) {
    if let Some(place) = message.get_mut(at..at + bytes.len()) {
        place.copy_from_slice(bytes);
    }
}

fn changed(kind: Kind, messages: &mut Vec<Vec<u8>>, corpus: &[Log], numbers: &mut Numbers) {
    if messages.is_empty() {
        return;
    }
    let of = |wanted: bool, messages: &[Vec<u8>]| -> Vec<usize> {
        (0..messages.len()).filter(|i| is_definition(kind, &messages[*i]) == wanted).collect()
    };
    let pick = |places: &[usize], numbers: &mut Numbers| places.get(numbers.below(places.len())).copied().unwrap_or(0);
    let (definitions, samples) = (of(true, messages), of(false, messages));
    let (definition, sample) = (pick(&definitions, numbers), pick(&samples, numbers));
    let other = numbers.below(messages.len());
    match numbers.below(13) {
        0 => {
            messages.remove(definition);
        }
        1 => messages.insert(other, messages[definition].clone()),
        2 => messages.swap(definition, other),
        3 => {
            // The length of a definition, or that of a sample.
            let (place, at) = if numbers.below(2) == 0 { (definition, 4) } else { (sample, 0) };
            let at = if kind == Kind::Ulog { 0 } else { at };
            let value = [0, 1, 2, 3, 88, 127, 255, numbers.below(256) as u8][numbers.below(8)];
            put(&mut messages[place], at, &[value]);
        }
        4 => words(&mut messages[definition], kind, numbers),
        5 => {
            let at = numbers.below(messages[sample].len());
            put(&mut messages[sample], at, &FLOATS[numbers.below(FLOATS.len())].to_le_bytes());
        }
        6 => {
            // The same odd number in many samples of a kind.
            let (like, length) = (messages[sample][2], messages[sample].len());
            let at = numbers.below(length);
            let value = FLOATS[numbers.below(FLOATS.len())].to_le_bytes();
            let every = 1 + numbers.below(20);
            let same = messages.iter_mut().filter(|message| message.get(2) == Some(&like) && message.len() == length);
            same.step_by(every).for_each(|message| put(message, at, &value));
        }
        7 => {
            if let Some(at) = time_at(kind, &messages[sample]) {
                put(&mut messages[sample], at, &TIMES[numbers.below(TIMES.len())].to_le_bytes());
            }
        }
        8 => messages.swap(sample, other),
        9 => rates(kind, messages, numbers),
        10 => {
            // The value of a parameter.
            let parameters: Vec<usize> = (0..messages.len())
                .filter(|i| messages[*i].get(2) == Some(if kind == Kind::Ulog { &b'P' } else { &1 }))
                .collect();
            let place = pick(&parameters, numbers);
            let at = if kind == Kind::Ulog { messages[place].len().saturating_sub(4) } else { 27 };
            let value =
                if numbers.below(2) == 0 { numbers.below(100) as f32 } else { FLOATS[numbers.below(FLOATS.len())] };
            put(&mut messages[place], at, &value.to_le_bytes());
        }
        11 => {
            let (from, to) = (other.min(sample), other.max(sample).min(other.min(sample) + 60));
            let part: Vec<Vec<u8>> = messages[from..to].to_vec();
            match numbers.below(3) {
                0 => drop(messages.drain(from..to)),
                _ => (0..=numbers.below(8)).for_each(|_| drop(messages.splice(to..to, part.iter().cloned()))),
            }
        }
        _ => {
            let log = &corpus[numbers.below(corpus.len())];
            let from = numbers.below(log.messages.len());
            let part = log.messages[from..(from + 20).min(log.messages.len())].to_vec();
            messages.splice(other..other, part);
        }
    }
}

/// A part of a definition replaced by another.
fn words(message: &mut Vec<u8>, kind: Kind, numbers: &mut Numbers) {
    let word = WORDS[numbers.below(WORDS.len())].as_bytes();
    let at = 3 + numbers.below(message.len().saturating_sub(3));
    if kind == Kind::DataFlash {
        put(message, at, word);
        return;
    }
    let end = (at + numbers.below(2 * word.len())).min(message.len());
    message.splice(at.min(end)..end, word.iter().copied());
    let length = (message.len().saturating_sub(3) as u16).to_le_bytes();
    put(message, 0, &length);
}

/// All samples, or those of a kind, at another rate: times multiplied, or all but every so many left out.
fn rates(kind: Kind, messages: &mut Vec<Vec<u8>>, numbers: &mut Numbers) {
    let like = messages[numbers.below(messages.len())].get(2..5).map(<[u8]>::to_vec);
    let is_all = numbers.below(2) == 0;
    let is_like = |message: &[u8]| is_all || message.get(2..5).map(<[u8]>::to_vec) == like;
    if numbers.below(3) == 0 {
        let every = 2 + numbers.below(30);
        let mut seen = 0;
        messages.retain(|message| {
            seen += usize::from(is_like(message) && time_at(kind, message).is_some());
            !is_like(message) || time_at(kind, message).is_none() || seen.is_multiple_of(every)
        });
        return;
    }
    let factor = 10_f64.powi(numbers.below(19) as i32 - 6);
    for message in messages.iter_mut().filter(|message| is_like(message)) {
        if let Some(at) = time_at(kind, message) {
            let time = u64::from_le_bytes(message[at..at + 8].try_into().expect("eight bytes"));
            put(message, at, &((time as f64 * factor) as u64).to_le_bytes());
        }
    }
}

/// What the commands do with a log; whether it has an answer. Every fourth one is also identified, which takes as long.
pub fn check(bytes: &[u8], index: u64) -> bool {
    let is_diagnosed = match diagnose(&mut &bytes[..], None, &[], &mut []) {
        Ok(found) => {
            for loss in found.diagnosis.losses() {
                let [low, high] = loss.capacity_interval;
                assert!(loss.time.is_finite() && 0.0 <= low && low <= high && high <= 1.0, "{loss:?}");
            }
            let record = serde_json::to_string(&DiagnosisRecord::new(&found.diagnosis)).expect("a record");
            let screen = screen(&found.diagnosis);
            let lines: Vec<&str> = screen.lines().map(|(_, line)| line).collect();
            assert!(record.len() < 1 << 16 && lines.len() < 60, "{lines:#?}");
            true
        }
        Err(Undiagnosed { why: Why::Not(found), .. }) => {
            assert!(!found.is_empty());
            false
        }
        Err(Undiagnosed { why: Why::Io(error), .. }) => panic!("{error}"),
        Err(Undiagnosed { why: Why::Argument(why), .. }) => panic!("{why}"),
    };
    if !index.is_multiple_of(4) {
        return is_diagnosed;
    }
    match identify(&mut &bytes[..], "2 kg") {
        Ok(found) => {
            let compiled = mavc::compile(&found.text);
            assert!(compiled.diagnostics.iter().all(|d| !d.code.starts_with("mavc::syntax")), "{}", found.text);
        }
        Err(Undiagnosed { why: Why::Not(found), .. }) => assert!(!found.is_empty()),
        Err(Undiagnosed { why: Why::Io(error), .. }) => panic!("{error}"),
        Err(Undiagnosed { why: Why::Argument(why), .. }) => panic!("{why}"),
    }
    is_diagnosed
}
