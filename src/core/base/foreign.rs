//! Files of other tools in the place of a spec: what they are, and which command reads them. They are recognised by
//! their content, and only once they have failed to be a spec.

use super::diagnostic::Diagnostic;
use super::source::{FileId, Source, Span, visible};
use std::path::Path;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Foreign {
    /// A vehicle, as these words say it.
    Vehicle(&'static str),
    /// A mission of a ground station, or waypoints.
    Mission(&'static str),
    /// A text that a program expands before another tool reads it: that program's name.
    Template(&'static str),
    /// A log of a flight.
    Log(&'static str),
    /// A certificate of `mavc plan`.
    Certificate,
    /// A trajectory or a report that mavc wrote.
    Result(&'static str),
    /// A file that mavc never reads, and what to do with it.
    Other(&'static str, &'static str),
}

const PX4_LOG: &str = "a log of PX4";
const ARDUPILOT_LOG: &str = "a log of ArduPilot";

/// First bytes of logs. Sources: ULog file format of PX4; `AP_Logger` of ArduPilot (`HEAD_BYTE1`, `HEAD_BYTE2`); MCAP
/// and rosbag specifications.
const LOGS: [(&[u8], &str); 5] = [
    (b"ULog\x01\x12\x35", PX4_LOG),
    (b"\xa3\x95", ARDUPILOT_LOG),
    (b"\x89MCAP0\r\n", "an MCAP recording"),
    (b"#ROSBAG V2.0", "a ROS bag"),
    (b"SQLite format 3\0", "a database, such as a ROS 2 bag"),
];

const UNPACK: &str = "unpack it, and name a file in it";
const NO_PICTURE: &str = "name a spec, a vehicle, a mission or a log";

/// First bytes of files that mavc never reads, and what to do with them.
const OTHERS: [(&[u8], &str, &str); 10] = [
    (b"PK\x03\x04", "a ZIP archive", UNPACK),
    (b"\x1f\x8b", "a file compressed by gzip", "expand it: `gunzip FILE`"),
    (b"\xfd7zXZ\0", "a file compressed by xz", "expand it: `unxz FILE`"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", UNPACK),
    (b"\x89PNG\r\n", "a picture", NO_PICTURE),
    (b"\xff\xd8\xff", "a picture", NO_PICTURE),
    (b"GIF8", "a picture", NO_PICTURE),
    (b"%PDF-", "a PDF", NO_PICTURE),
    (b"\x7fELF", "a program", NO_PICTURE),
    (b"version https://git-lfs", "a pointer of Git LFS", "fetch the file itself: `git lfs pull`"),
];

/// How many lines of a text are looked at.
const LINES: usize = 400;

/// What kind of file these bytes are; `None` if they may be a spec.
pub fn of_bytes(bytes: &[u8]) -> Option<Foreign> {
    of_first_bytes(bytes).or_else(|| std::str::from_utf8(bytes).ok().and_then(of_text))
}

/// What kind of file it is that begins with these bytes, if they say so.
pub fn of_first_bytes(bytes: &[u8]) -> Option<Foreign> {
    let log = LOGS.iter().find(|(magic, _)| bytes.starts_with(magic)).map(|(_, what)| Foreign::Log(what));
    let other = || OTHERS.iter().find(|(magic, ..)| bytes.starts_with(magic));
    log.or_else(|| other().map(|(_, what, help)| Foreign::Other(what, help)))
}

/// What kind of file a text is; `None` if it may be a spec.
pub fn of_text(text: &str) -> Option<Foreign> {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    if let Some(program) = template(start) {
        return Some(Foreign::Template(program));
    }
    if start.starts_with('<') {
        let roots = [("<mujoco", "a model of MuJoCo"), ("<robot", "a URDF"), ("<sdf", "an SDF")];
        let found = roots.into_iter().find(|(root, _)| start.contains(root)).map(|(_, what)| Foreign::Vehicle(what));
        // An expression of a template stands where XML has none: between tags, or as a whole value.
        let is_template = found.is_some() && [">{{", "\"{{"].iter().any(|mark| start.contains(mark));
        return if is_template { Some(Foreign::Template("Jinja")) } else { found };
    }
    if start.starts_with('{') {
        let has = |key: &str| start.contains(key);
        return match () {
            () if has("\"fileType\"") => Some(Foreign::Mission("a plan of QGroundControl")),
            () if has("\"spec_sha256\"") && has("\"claim\"") => Some(Foreign::Certificate),
            () if has("\"schema\"") => Some(Foreign::Result("a report of mavc")),
            () => None,
        };
    }
    if start.starts_with("QGC WPL") {
        return Some(Foreign::Mission("a mission of MAVLink"));
    }
    if let Some(what) = parameters(text) {
        return Some(Foreign::Vehicle(what));
    }
    let first = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'))?;
    let cells: Vec<&str> = first.split(',').map(str::trim).collect();
    let has = |name: &str| cells.iter().any(|cell| cell.eq_ignore_ascii_case(name));
    if ["t", "x", "vx", "ax"].iter().all(|name| has(name)) {
        return Some(Foreign::Result("a trajectory of mavc"));
    }
    let is_row = cells.len() == 3 && cells.iter().all(|cell| cell.parse::<f64>().is_ok());
    (["x", "y", "z"].iter().all(|name| has(name)) || is_row).then_some(Foreign::Mission("a table of waypoints"))
}

/// The program that expands a template.
fn template(start: &str) -> Option<&'static str> {
    let is_jinja = ["{%", "{#", "{{"].iter().any(|mark| start.starts_with(mark)) || start.contains("{%");
    let head = start.split_once('>').map_or(start, |(head, _)| head);
    match () {
        () if is_jinja => Some("Jinja"),
        () if start.starts_with("<%") || start.starts_with('<') && start.contains("<%") => Some("ERB"),
        () if head.starts_with('<') && start.contains("<xacro:") => Some("xacro"),
        () => None,
    }
}

/// Whose parameters the lines of a text set: a script sets them anywhere, a saved file from its first line that is no
/// comment.
fn parameters(text: &str) -> Option<&'static str> {
    let is_name = |word: &str| {
        word.starts_with(|c: char| c.is_ascii_uppercase())
            && word.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_')
    };
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    let lines = || text.lines().take(LINES).map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let is_script = |line: &str| {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("param") => matches!(words.next(), Some("set" | "set-default")),
            Some(".") => line.contains("init.d"),
            _ => false,
        }
    };
    if lines().any(is_script) {
        return Some("an airframe of PX4");
    }
    let words: Vec<&str> = lines().next()?.split([' ', '\t', ',']).filter(|word| !word.is_empty()).collect();
    match words[..] {
        [vehicle, component, name, value, _]
            if is_name(name) && [vehicle, component, value].iter().all(|word| is_number(word)) =>
        {
            Some("parameters of an autopilot, saved by QGroundControl")
        }
        [name, value] if (name.contains('_') || name == "FRAME") && is_name(name) && is_number(value) => {
            Some("parameters of ArduPilot")
        }
        _ => None,
    }
}

impl Foreign {
    /// `parameters of ArduPilot`
    pub fn what(self) -> String {
        match self {
            Foreign::Vehicle(what) | Foreign::Mission(what) | Foreign::Log(what) => what.into(),
            Foreign::Result(what) | Foreign::Other(what, _) => what.into(),
            Foreign::Template(program) => format!("a template of {program}"),
            Foreign::Certificate => "a certificate".into(),
        }
    }

    /// The command that reads the file `name`, as a help.
    pub fn help(self, name: &str) -> String {
        let path = if name == "<stdin>" { "-" } else { name };
        // `hexa.sdf.jinja` becomes `hexa`.
        let file = Path::new(name).file_name().and_then(|file| file.to_str()).filter(|file| !file.starts_with('<'));
        let stem = file.map(|file| file.split('.').next().unwrap_or(file)).filter(|stem| !stem.is_empty());
        let (path, stem) = (visible::line(path), visible::line(stem.unwrap_or("new")).into_owned());
        match self {
            Foreign::Vehicle(_) => format!("make a spec of it: `mavc import vehicle {path} -o {stem}.mav`"),
            Foreign::Mission(_) => format!(
                "make a spec of it: `mavc import mission {path} --vehicle v.mav -o {stem}.mav`; or check it: `mavc \
                 check {path} --vehicle v.mav`"
            ),
            Foreign::Template("xacro") => {
                format!("expand it first, `xacro {path} > {stem}.urdf`, then: `mavc import vehicle {stem}.urdf`")
            }
            Foreign::Template(_) => {
                format!("expand it first with its own program, then: `mavc import vehicle {stem}.sdf`")
            }
            Foreign::Log(PX4_LOG | ARDUPILOT_LOG) => format!(
                "make a spec of the vehicle that flew: `mavc identify {path} --mass 1.5kg -o {stem}.mav`; or look \
                 for a failed motor: `mavc diagnose {path}`"
            ),
            Foreign::Log(_) => {
                "mavc reads logs of PX4 (`.ulg`) and ArduPilot (`.bin`): `mavc identify LOG --mass 1.5kg`".into()
            }
            Foreign::Certificate => format!("check it with its spec: `mavc verify {path} spec.mav`"),
            Foreign::Result(_) => "name the spec from which it was made".into(),
            Foreign::Other(_, help) => help.into(),
        }
    }

    /// The error for a file in the place of a spec.
    pub fn error(self, file: FileId, source: &Source) -> Diagnostic {
        let first = source.line(1);
        let message = format!("expected a spec, found {}", self.what());
        let error = Diagnostic::error("mavc::file::foreign", Span::new(file, first.start, first.end), message);
        error.here("the first line").help(self.help(&source.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_follow_from_the_content() {
        use Foreign::{Certificate, Log, Mission, Result, Template, Vehicle};
        for (text, due) in [
            ("# a\n1\t1\tCA_ROTOR_COUNT\t4\t6\n", Some(Vehicle("parameters of an autopilot, saved by QGroundControl"))),
            ("FRAME_CLASS,1\n", Some(Vehicle("parameters of ArduPilot"))),
            ("#NOTE\r\nMOT_SPIN_MIN 0.15\r\n", Some(Vehicle("parameters of ArduPilot"))),
            ("#!/bin/sh\nparam set-default VM_MASS 1.5\n", Some(Vehicle("an airframe of PX4"))),
            ("<?xml version='1.0'?>\n<sdf version='1.9'/>", Some(Vehicle("an SDF"))),
            ("<robot name='a'/>", Some(Vehicle("a URDF"))),
            ("<robot xmlns:xacro='a'><xacro:macro/></robot>", Some(Template("xacro"))),
            ("{# a #}\n<sdf/>", Some(Template("Jinja"))),
            ("<?xml version='1.0'?>{%- set a = 1 -%}<sdf/>", Some(Template("Jinja"))),
            ("<sdf><mass>{{ mass }}</mass></sdf>", Some(Template("Jinja"))),
            ("<%= a %><sdf/>", Some(Template("ERB"))),
            ("<mujoco/>", Some(Vehicle("a model of MuJoCo"))),
            ("{\"fileType\": \"Plan\"}", Some(Mission("a plan of QGroundControl"))),
            ("QGC WPL 110\n", Some(Mission("a mission of MAVLink"))),
            ("t,x,y,z\n0,0,0,2\n", Some(Mission("a table of waypoints"))),
            ("0,0,2\n1,2,3\n", Some(Mission("a table of waypoints"))),
            ("t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax\n", Some(Result("a trajectory of mavc"))),
            ("{\"schema\": 1, \"spec_sha256\": \"\", \"claim\": {}}", Some(Certificate)),
            ("{\"schema\": 1}", Some(Result("a report of mavc"))),
            ("vehicle v {{{ }", None),
            ("let A = 1\nMASS = 2\n", None),
            ("vehicle v {\n    MAX_MASS 2\n}\n", None),
            ("MASS 2\n", None),
            ("", None),
            ("<<<<<<< HEAD\nvehicle v {}\n", None),
        ] {
            assert_eq!(of_bytes(text.as_bytes()), due, "{text}");
        }
        assert_eq!(of_bytes(b"ULog\x01\x12\x35\x01\xff\xff"), Some(Log("a log of PX4")));
        assert_eq!(of_bytes(b"\xa3\x95\x80\xff"), Some(Log("a log of ArduPilot")));
        assert_eq!(of_bytes(b"PK\x03\x04\x14\0").map(Foreign::what).as_deref(), Some("a ZIP archive"));
        assert_eq!(of_bytes(b"\x89PNG\r\n\x1a\n").map(Foreign::what).as_deref(), Some("a picture"));
    }
}
