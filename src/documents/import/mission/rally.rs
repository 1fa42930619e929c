//! Rally points, to which an autopilot returns instead of home, as landing sites on the ground below them.

use super::draft::{Draft, Mark, Site, Stop};
use super::items::{FARTHEST, FileSettings, Item, LANDS_AT_HOME, place, refuse};
use super::qgc_plan::{listed, numeric};
use super::wpl::cells;
use crate::diagnostic::Diagnostic;
use crate::geodesy::TangentPlane;
use crate::import::json::Json;
use crate::import::{ASSUMED, SYNTAX, UNSUPPORTED, at};
use crate::number::{number, significant};
use std::ops::Range;

type Read<T> = Result<T, Box<Diagnostic>>;

/// The radius of a landing site, m. No format of rally points has one: it is an assumption, which the spec marks as
/// such.
pub(super) const RADIUS: f64 = 2.0;

/// An item below home by more than this is not on the ground of home, m.
const VALLEY: f64 = 0.5;

/// The word that begins a line of the text that Mission Planner and MAVProxy write.
const WORD: &str = "RALLY";

/// A rally point as a file has it.
struct Point {
    degrees: [Option<f64>; 2],
    spans: [Range<usize>; 2],
    /// The height at which the vehicle arrives, as a comment says it.
    arrival: Option<String>,
    span: Range<usize>,
}

/// Adds the points `[latitude, longitude, height above home]` of a plan of QGroundControl.
pub fn of_plan(rally: &Json, setting: &FileSettings, draft: &mut Draft) -> Read<()> {
    let Some(points) = rally.get("points") else { return Ok(()) };
    for point in listed(points, "points")? {
        let [latitude, longitude, rest @ ..] = listed(point, "points")? else {
            let message = "a rally point must be latitude, longitude and altitude";
            return refuse(SYNTAX, &point.span, message, "not three numbers");
        };
        let arrival = match rest.first() {
            Some(height) => Some(above_home(numeric(height, "points")?)),
            None => None,
        };
        let degrees = [Some(numeric(latitude, "points")?), Some(numeric(longitude, "points")?)];
        let spans = [latitude.span.clone(), longitude.span.clone()];
        add(Point { degrees, spans, arrival, span: point.span.clone() }, setting, draft)?;
    }
    Ok(())
}

/// Adds a rally point among the items of MAVLink's plain text.
pub fn of_item(item: &Item, setting: &FileSettings, draft: &mut Draft) -> Read<()> {
    let arrival = item.params[6].map(|height| match item.frame {
        0.0 | 5.0 => format!("{} m above sea", number(height)),
        _ => above_home(height),
    });
    let degrees = [item.params[4], item.params[5]];
    let spans = [item.spans[4].clone(), item.spans[5].clone()];
    add(Point { degrees, spans, arrival, span: item.mark.span.clone() }, setting, draft)
}

/// Whether a line is a rally point of Mission Planner or MAVProxy.
pub fn is_line(text: &str) -> bool {
    text.split_whitespace().next() == Some(WORD)
}

/// Adds the rally point of a line `RALLY latitude longitude altitude ...`, whose altitude is above home.
pub fn of_line(text: &str, span: Range<usize>, setting: &FileSettings, draft: &mut Draft) -> Read<()> {
    let between = |c: char| c.is_ascii_whitespace();
    let cells = cells(text, span.start, between).filter(|(cell, _)| !cell.is_empty()).skip(1).take(3);
    let mut numbers = Vec::new();
    for (cell, at) in cells {
        match cell.parse::<f64>() {
            Ok(value) if value.is_finite() => numbers.push((value, at)),
            _ => return refuse(SYNTAX, &at, "expected a number", "no number"),
        }
    }
    let [(latitude, north), (longitude, east), (height, _)] = &numbers[..] else {
        let message = format!("a line `{WORD}` must have a latitude, a longitude and an altitude");
        return refuse(SYNTAX, &span, &message, "fewer than three numbers");
    };
    let degrees = [Some(*latitude), Some(*longitude)];
    let arrival = Some(above_home(*height));
    add(Point { degrees, spans: [north.clone(), east.clone()], arrival, span }, setting, draft)
}

fn above_home(height: f64) -> String {
    format!("{} m above home", number(height))
}

fn add(point: Point, setting: &FileSettings, draft: &mut Draft) -> Read<()> {
    let home = setting.home.place;
    let mark = Mark { name: format!("rally point {}", draft.sites.len() + 1), span: point.span.clone() };
    let [latitude, longitude] = &point.spans;
    let there = place(point.degrees, home.height, [latitude, longitude])?;
    let position = TangentPlane::at(home).local(&there).map(millimetres);
    if position.iter().any(|p| p.abs() > FARTHEST) {
        let message = format!("{} is more than 1000 km from the planned home", mark.name);
        let error = Diagnostic::error(UNSUPPORTED, at(point.span), message).here("too far for a spec");
        return Err(Box::new(error.help("correct the home: a spec reaches 1000 km from its origin")));
    }
    draft.sites.push(Site { mark, position, arrival: point.arrival });
    Ok(())
}

/// Sets the height of the ground of a mission with landing sites: that of home, or of the lowest item or site. A
/// warning in `found` names an item that is below the height of home.
pub fn set_ground(setting: &FileSettings, draft: &mut Draft, found: &mut Vec<Diagnostic>) {
    if draft.sites.is_empty() {
        return;
    }
    let heights = draft.stops.iter().map(|stop| millimetres(stop.position[2]));
    draft.ground = heights.chain(draft.sites.iter().map(|site| site.position[2])).fold(0.0, f64::min);
    // The axes are those of a plane: far from home the Earth is below it.
    let plane = TangentPlane::at(setting.home.place);
    let below = |stop: &Stop| setting.home.place.height - plane.place(stop.position).height;
    let Some(lowest) = draft.stops.iter().max_by(|a, b| below(a).total_cmp(&below(b))) else { return };
    if below(lowest) > VALLEY {
        let message = format!(
            "{}: the ground of the spec is at its height, {} m below home; landing sites are at the height of home",
            lowest.mark.name,
            significant(below(lowest), 3)
        );
        let warning = Diagnostic::warning(ASSUMED, at(lowest.mark.span.clone()), message).here("the lowest place");
        found.push(warning.help("write the heights of `ground` and of each `landing_site` into the spec"));
    }
}

/// Warns of a return that an autopilot may fly to a rally point (PX4: `RTL_TYPE` 0, its default; ArduCopter:
/// `compute_return_target`).
pub fn warn_of_return(draft: &Draft, setting: &FileSettings, found: &mut Vec<Diagnostic>) {
    let Some(last) = draft.stops.last().filter(|stop| stop.remark == LANDS_AT_HOME && !draft.sites.is_empty()) else {
        return;
    };
    let message = format!(
        "{}: the spec lands at home; {} returns to a rally point if one is nearer",
        last.mark.name,
        setting.autopilot().name
    );
    let warning = Diagnostic::warning(ASSUMED, at(last.mark.span.clone()), message).here("a return");
    found.push(warning.help("if it does, write a waypoint above that landing site, and land there"));
}

/// A length in m, rounded to the millimetre that is written.
fn millimetres(length: f64) -> f64 {
    (length * 1e3).round() / 1e3
}
