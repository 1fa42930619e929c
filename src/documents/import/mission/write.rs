//! The text of a spec from a [`Draft`], and the item that each of its lines came from.

use super::draft::{Draft, Mark, Shape, Site, Speeds, Stop, Volume, Way, Yaw};
use super::rally::RADIUS;
use crate::diagnostic::Diagnostic;
use crate::import::{FORMAT, at};
use crate::input::FileKind;
use crate::number::fixed;
use crate::source::{Source, visible};
use std::fmt::Write;
use std::path::Path;

/// Digits after the point of lengths in m: a millimetre.
const MILLIMETRES: usize = 3;
/// Digits of latitudes and longitudes in degrees: 0.1 mm.
const OF_DEGREES: usize = 9;
/// How far below the lowest and above the highest waypoint a fence reaches, m: a fence of a ground station has no
/// heights.
const BEYOND: f64 = 1000.0;
/// Waypoints nearer than this to each other are at one place, m.
const SHORTEST: f64 = 0.01;

/// A spec and where its lines came from.
#[derive(Debug, Clone)]
pub struct Written {
    pub text: String,
    /// For each line of the text, counted from 0, its part of the file.
    pub(super) lines: Vec<Option<Mark>>,
}

struct Writer {
    written: Written,
}

impl Writer {
    fn line(&mut self, text: &str, mark: Option<&Mark>) {
        self.written.text.push_str(text);
        self.written.text.push('\n');
        self.written.lines.push(mark.cloned());
    }
}

/// The spec of a draft with the name `mission`; it uses the spec `vehicle` if one is given.
///
/// # Errors
/// The path of `vehicle` cannot stand in a spec.
pub fn text(source: &Source, draft: &Draft, vehicle: Option<&str>, mission: &str) -> Result<Written, Box<Diagnostic>> {
    let mut writer = Writer { written: Written { text: String::new(), lines: Vec::new() } };
    writer.line(&format!("// From {}, {}.", visible::line(&source.name).replace('\n', " "), draft.format), None);
    draft.remarks.iter().for_each(|remark| writer.line(&format!("// {remark}"), None));
    if let Some(path) = vehicle {
        if path.contains(['"', '\n', '\r']) || path.chars().any(char::is_control) {
            let error = Diagnostic::error(FORMAT, at(0..0), "the path of the vehicle cannot be written in a spec");
            return Err(Box::new(error.help("rename it without quotes and control characters")));
        }
        if FileKind::of(Path::new(path)) != Some(FileKind::Spec) {
            let error = Diagnostic::error(FORMAT, at(0..0), "`use` reads only files whose names end in `.mav`");
            return Err(Box::new(error.help("make a spec of the vehicle first: `mavc import vehicle FILE -o v.mav`")));
        }
        writer.line(&format!("use \"{path}\""), None);
    }
    writer.line("", None);
    writer.line(&format!("mission {mission} {{"), None);
    if let Some(home) = &draft.home {
        let mark = Mark { name: "planned home".into(), span: home.span.clone() };
        let [north, east] =
            [home.place.latitude, home.place.longitude].map(|angle| short(angle.to_degrees(), OF_DEGREES));
        writer.line(&format!("    origin_latitude = {north} deg"), Some(&mark));
        writer.line(&format!("    origin_longitude = {east} deg"), Some(&mark));
        let height = match home.has_height {
            true => format!("{} m", short(home.place.height, MILLIMETRES)),
            false => "?  // above sea; the file does not give it".into(),
        };
        writer.line(&format!("    origin_altitude = {height}"), Some(&mark));
    }
    ground(&mut writer, draft);
    let common = common_speeds(&draft.stops);
    let mut yaw = Yaw::Unsaid;
    for (k, stop) in draft.stops.iter().enumerate() {
        let before = k.checked_sub(1).map(|k| &draft.stops[k]);
        waypoint(&mut writer, before, stop, &mut yaw, &common);
    }
    limits(&mut writer, &common);
    draft.volumes.iter().for_each(|v| volume(&mut writer, v, &draft.stops));
    (1..).zip(&draft.sites).for_each(|(number, s)| site(&mut writer, number, s));
    writer.line("}", None);
    Ok(writer.written)
}

/// The ground, which landing sites need.
fn ground(writer: &mut Writer, draft: &Draft) {
    let Some(first) = draft.sites.first() else { return };
    let whose = if draft.ground == 0.0 { "the height of the planned home" } else { "the height of the lowest place" };
    writer.line(&format!("    ground = {} m  // {whose}", short(draft.ground, MILLIMETRES)), Some(&first.mark));
}

fn site(writer: &mut Writer, number: usize, site: &Site) {
    let mark = Some(&site.mark);
    let arrival = site.arrival.as_ref().map_or(String::new(), |height| format!(", to be reached at {height}"));
    let remark = format!("{}{arrival}: the site is on the ground below", site.mark.name);
    let [x, y, z] = site.position.map(|p| short(p, MILLIMETRES));
    writer.line(&format!("    landing_site rally_{number} {{  // {remark}"), mark);
    writer.line(&format!("        at = [{x}, {y}, {z}] m"), mark);
    writer.line(&format!("        radius = {} m  // assumed", short(RADIUS, MILLIMETRES)), mark);
    writer.line("    }", mark);
}

/// The name of the mission: that of the file, as far as a spec can have it, and none of `taken`.
pub(super) fn name(path: &str, taken: &[String]) -> String {
    let stem = Path::new(path).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().take(40).map(letter).collect();
    let name = name.trim_matches('_');
    let name = match name.chars().next() {
        None => "imported".into(),
        Some(first) if first.is_ascii_digit() => format!("m{name}"),
        Some(_) => name.to_string(),
    };
    let is_free = |name: &String| !taken.contains(name);
    let numbered = (2..).map(|k| format!("{name}_{k}"));
    std::iter::once(name.clone()).chain(numbered).find(is_free).unwrap_or(name)
}

/// A number without needless zeros.
fn short(x: f64, digits: usize) -> String {
    let text = fixed(x, digits);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.to_string() }
}

/// Of each kind of speed the largest of all legs, if every leg has one: `limits` of the mission say it.
fn common_speeds(stops: &[Stop]) -> Speeds {
    let legs = stops.get(1..).unwrap_or_default();
    let largest = |of: fn(&Speeds) -> &Option<(f64, Mark)>| {
        let all: Option<Vec<&(f64, Mark)>> = legs.iter().map(|stop| of(&stop.speeds).as_ref()).collect();
        all?.into_iter().reduce(|most, next| if next.0 > most.0 { next } else { most }).cloned()
    };
    Speeds { horizontal: largest(|s| &s.horizontal), climb: largest(|s| &s.climb), descent: largest(|s| &s.descent) }
}

/// The `limits` of the mission.
fn limits(writer: &mut Writer, common: &Speeds) {
    let line = |(name, (speed, _)): (&str, &(f64, Mark))| format!("{name} <= {} m/s", short(*speed, MILLIMETRES));
    match common.limits().collect::<Vec<_>>()[..] {
        [] => {}
        [one] => writer.line(&format!("    limits {{ {} }}  // {}", line(one), one.1.1.name), Some(&one.1.1)),
        ref all => {
            writer.line("    limits {", None);
            for one in all {
                writer.line(&format!("        {}  // {}", line(*one), one.1.1.name), Some(&one.1.1));
            }
            writer.line("    }", None);
        }
    }
}

fn waypoint(writer: &mut Writer, before: Option<&Stop>, stop: &Stop, yaw: &mut Yaw, common: &Speeds) {
    let is_first = before.is_none();
    let [x, y, z] = stop.position.map(|p| short(p, MILLIMETRES));
    let mut line = format!("    {} at [{x}, {y}, {z}] m", if is_first { "start" } else { "waypoint" });
    if *yaw != stop.yaw {
        match stop.yaw {
            Yaw::Angle(degrees) => line.push_str(&format!("  yaw {} deg", short(turned(degrees), MILLIMETRES))),
            Yaw::Towards([x, y]) => {
                let [x, y] = [x, y].map(|p| short(p, MILLIMETRES));
                let _ = write!(line, "  yaw towards [{x}, {y}, 0] m");
            }
            Yaw::Free => line.push_str("  yaw free"),
            Yaw::Unsaid => {}
        }
        *yaw = stop.yaw;
    }
    if let Some(within) = stop.within {
        let _ = write!(line, "  within {} m", short(within, MILLIMETRES));
    }
    if let Some(time) = stop.time.filter(|_| !is_first) {
        let _ = write!(line, "  time {} s", short(time, OF_DEGREES));
    }
    line.push_str(match stop.way {
        // A line needs a length.
        _ if before.is_none_or(|before| apart(before.position, stop.position) < SHORTEST) => "",
        Way::Any => "",
        Way::Straight => "  straight",
        Way::Vertical => "  vertical",
    });
    if stop.stops && !is_first {
        line.push_str("  stop");
    }
    let limits: Vec<String> = stop
        .speeds
        .limits()
        // The mission says the same.
        .filter(|(name, speed)| !common.limits().any(|(n, most)| n == *name && most.0 <= speed.0))
        .map(|(name, (speed, _))| format!("{name} <= {} m/s", short(*speed, MILLIMETRES)))
        .collect();
    if !is_first && !limits.is_empty() {
        let _ = write!(line, " {{ {} }}", limits.join("; "));
    }
    let remark = if stop.remark.is_empty() { String::new() } else { format!(", {}", stop.remark) };
    let _ = write!(line, "  // {}{remark}", stop.mark.name);
    writer.line(&line, Some(&stop.mark));
    if let Some((seconds, mark)) = &stop.hold {
        writer.line(&format!("    hold {} s  // {}", short(*seconds, OF_DEGREES), mark.name), Some(mark));
    }
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Above -180 deg, up to 180 deg.
fn turned(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}

fn volume(writer: &mut Writer, volume: &Volume, stops: &[Stop]) {
    let heights = || stops.iter().map(|stop| stop.position[2]);
    let bottom = (heights().fold(f64::INFINITY, f64::min) - BEYOND).floor();
    let top = (heights().fold(f64::NEG_INFINITY, f64::max) + BEYOND).ceil();
    let mark = Some(&volume.mark);
    let keyword = if volume.is_inside { "keep_in" } else { "keep_out" };
    writer.line(&format!("    {keyword} {} {{  // {}, which has no heights", volume.name, volume.mark.name), mark);
    match &volume.shape {
        Shape::Polygon(corners) => {
            let corners: Vec<String> = corners
                .iter()
                .map(|[x, y]| format!("[{}, {}]", short(*x, MILLIMETRES), short(*y, MILLIMETRES)))
                .collect();
            writer.line("        shape = polygon", mark);
            writer.line(&format!("        corners = [{}] m", corners.join(", ")), mark);
            writer.line(&format!("        bottom = {} m", short(bottom, MILLIMETRES)), mark);
            writer.line(&format!("        top = {} m", short(top, MILLIMETRES)), mark);
        }
        Shape::Circle { centre: [x, y], radius } => {
            let [x, y, bottom_text] = [*x, *y, bottom].map(|v| short(v, MILLIMETRES));
            writer.line("        shape = cylinder", mark);
            writer.line(&format!("        centre = [{x}, {y}, {bottom_text}] m"), mark);
            writer.line(&format!("        radius = {} m", short(*radius, MILLIMETRES)), mark);
            writer.line(&format!("        height = {} m", short(top - bottom, MILLIMETRES)), mark);
        }
    }
    writer.line("    }", mark);
}
