//! What an airframe script of PX4 says beside parameters: its class and type, the mixer of versions before 1.14, the
//! scripts that it runs.

use crate::import::at;
use crate::source::{Source, Span};
use std::ops::Range;

/// A script that sets no geometry of a multirotor.
pub enum Reason {
    /// `@class` or `@type` names another aircraft.
    Other(Span, String),
    /// Parameters of the first versions of control allocation, `CA_MC_R0_PX`.
    OldNames(Span),
    /// `set MIXER quad_x`
    Mixer(Span),
    /// Another script that it runs, which is none of the defaults of a kind of vehicle.
    Runs(Span, String),
    /// Only the defaults of a kind of vehicle are run.
    Defaults(Span),
}

/// Beginnings of types that stand in the class `Copter` and are not multirotors with parallel rotors.
const OTHER_TYPES: [&str; 4] = ["Helicopter", "Coaxial Helicopter", "Bicopter", "Tricopter"];

/// Why a script has no geometry; `None` if the file is not such a script.
pub fn reason(source: &Source) -> Option<Reason> {
    let text = source.text.as_str();
    let runs = lines(text).filter_map(|(start, line)| run(start, line)).collect::<Vec<_>>();
    let mixer = text.find("set MIXER").filter(|from| !["none", "skip"].iter().any(|word| mixer_is(text, *from, word)));
    if let Some((span, other)) = other_aircraft(text) {
        return Some(Reason::Other(span, other));
    }
    if let Some(from) = text.find("CA_MC_R0_") {
        return Some(Reason::OldNames(at(from..from + "CA_MC_R0_".len())));
    }
    if let Some(from) = mixer {
        return Some(Reason::Mixer(at(from..from + "set MIXER".len())));
    }
    // The defaults of a kind of vehicle (rc.mc_defaults) set no places.
    let is_defaults = |name: &str| name.starts_with("rc.") && name.ends_with("_defaults");
    if let Some((range, name)) = runs.iter().find(|(_, name)| !is_defaults(name)) {
        return Some(Reason::Runs(at(range.clone()), name.clone()));
    }
    runs.first().map(|(range, _)| Reason::Defaults(at(range.clone())))
}

/// The aircraft that `# @class` or `# @type` names, or whose defaults are run, if it is not a multirotor; and its
/// place.
pub fn other_aircraft(text: &str) -> Option<(Span, String)> {
    let class = tag(text, "@class").filter(|(_, class)| *class != "Copter");
    let kind = tag(text, "@type").filter(|(_, kind)| OTHER_TYPES.iter().any(|other| kind.starts_with(other)));
    let found = class.or(kind).map(|(range, name)| (range, name.to_string()));
    let (range, name) = found.or_else(|| lines(text).find_map(|(start, line)| other_defaults(start, line)))?;
    Some((at(range), name.chars().take(40).collect()))
}

/// The aircraft whose defaults a line runs: `. ${R}etc/init.d/rc.fw_defaults` those of planes.
fn other_defaults(start: usize, line: &str) -> Option<(Range<usize>, String)> {
    let (range, name) = run(start, line)?;
    let kind = match name.strip_prefix("rc.")?.strip_suffix("_defaults")? {
        "mc" | "board" => return None,
        "fw" => "Plane",
        "vtol" => "VTOL",
        other => other,
    };
    Some((range, kind.to_string()))
}

/// The name of a script: `# @name Generic Quadcopter`.
pub fn title(text: &str) -> Option<String> {
    tag(text, "@name").map(|(_, name)| name.to_string())
}

/// The rest of the line of a tag, with its place.
fn tag<'t>(text: &'t str, name: &str) -> Option<(Range<usize>, &'t str)> {
    lines(text).take(100).find_map(|(_, line)| {
        let value = line.trim_start().strip_prefix('#')?.trim_start().strip_prefix(name)?;
        let value = value.strip_prefix([' ', '\t'])?.trim();
        let from = value.as_ptr() as usize - text.as_ptr() as usize;
        (!value.is_empty()).then_some((from..from + value.len(), value))
    })
}

/// Lines without their ends, each with its start.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.split_inclusive('\n').scan(0, |start, line| {
        let from = *start;
        *start += line.len();
        Some((from, line.trim_end()))
    })
}

/// A line `. ${R}etc/init.d/airframes/4001_quad_x`: its place and the name of the script that it runs.
fn run(start: usize, line: &str) -> Option<(Range<usize>, String)> {
    let code = line.trim_start();
    let path = code.strip_prefix(". ").or_else(|| code.strip_prefix("sh "))?.trim();
    let name = path.split_once("etc/init.d")?.1.rsplit('/').next()?;
    let name: String = name.split_whitespace().next()?.chars().take(60).collect();
    Some((start + line.len() - code.len()..start + line.len(), name))
}

fn mixer_is(text: &str, from: usize, word: &str) -> bool {
    text[from + "set MIXER".len()..].split_whitespace().next() == Some(word)
}
