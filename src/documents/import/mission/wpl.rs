//! MAVLink's plain text of missions, `QGC WPL 110`: a line for each item with twelve columns between tabs or blanks,
//! the first of which is the planned home.

use super::commands::{is_fence, is_rally_point};
use super::draft::{Draft, Home, Mark};
use super::items::{FileSettings, Item, follow, place, refuse};
use super::rally;
use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, FORMAT, SYNTAX, UNSUPPORTED, at};
use crate::source::Source;
use std::ops::Range;

type Read<T> = Result<T, Box<Diagnostic>>;

const COLUMNS: usize = 12;
/// Lines beyond this are not a mission.
const MOST_LINES: usize = 100_000;

pub fn read(source: &Source, found: &mut Vec<Diagnostic>) -> Read<Draft> {
    let mut lines = lines(&source.text).filter(|(text, _)| !text.trim().is_empty());
    let (head, span) = lines.next().unwrap_or(("", 0..0));
    let words: Vec<&str> = head.split_whitespace().collect();
    if words != ["QGC", "WPL", "110"] {
        return refuse(FORMAT, &span, "only version 110 of this format has the planned home", "not `QGC WPL 110`");
    }
    let (mut items, mut rallies) = (Vec::new(), Vec::new());
    for (k, (text, span)) in lines.enumerate() {
        if k >= MOST_LINES {
            return refuse(
                UNSUPPORTED,
                &span,
                &format!("the file has more than {MOST_LINES} items"),
                "the first too many",
            );
        }
        if rally::is_line(text) {
            rallies.push((text, span));
        } else if !text.trim_start().starts_with('#') {
            items.push(item(text, span)?);
        }
    }
    let Some((first, rest)) = items.split_first() else {
        return refuse(SYNTAX, &span, "the file has no items", "nothing follows");
    };
    other_list(&items, first)?;
    // Some writers begin with the take-off, as if there were no home.
    let (home, rest) = match first.command {
        TAKE_OFF => (under_take_off(first, &items, found)?, &items[..]),
        _ => (home(first)?, rest),
    };
    if home.has_height && !matches!(first.frame, 0.0 | 5.0) {
        let message = "the first line is taken for the planned home, but its height is above home: a mission whose \
                       home was left out would lose its first item";
        let warning = Diagnostic::warning(ASSUMED, at(first.mark.span.clone()), message).here("taken for the home");
        found.push(warning.help("write the home into the first line, as `0 1 0 16 0 0 0 0` and its place"));
    }
    let mut draft =
        Draft { format: "a mission of MAVLink (`QGC WPL 110`)", home: Some(home.clone()), ..Draft::default() };
    // Files of this format are ArduPilot's.
    let setting = FileSettings::of(home, true);
    let (points, flown): (Vec<Item>, Vec<Item>) = rest.iter().cloned().partition(|item| is_rally_point(item.command));
    follow(&flown, &setting, &mut draft, found)?;
    if draft.stops.len() < 2 {
        return refuse(
            UNSUPPORTED,
            &first.mark.span,
            "the mission has fewer than two places to fly to",
            "the planned home",
        );
    }
    for point in &points {
        rally::of_item(point, &setting, &mut draft)?;
    }
    for (text, span) in rallies {
        rally::of_line(text, span, &setting, &mut draft)?;
    }
    rally::set_ground(&setting, &mut draft, found);
    rally::warn_of_return(&draft, &setting, found);
    Ok(draft)
}

/// Lines with their places, without their ends.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (&str, Range<usize>)> {
    let mut start = 0;
    text.split_inclusive('\n').map(move |line| {
        let at = start;
        start += line.len();
        let line = line.trim_end_matches(['\n', '\r']);
        (line, at..at + line.len())
    })
}

/// The pieces of a line with their places.
pub(super) fn cells(
    line: &str,
    start: usize,
    is_between: fn(char) -> bool,
) -> impl Iterator<Item = (&str, Range<usize>)> {
    line.split(is_between).map(move |cell| {
        let offset = start + (cell.as_ptr() as usize - line.as_ptr() as usize);
        (cell, offset..offset + cell.len())
    })
}

/// Refuses the other lists that autopilots keep, and ground stations save in the same format: fences and rally points.
/// They have a home in the first line, or none.
fn other_list(items: &[Item], first: &Item) -> Read<()> {
    let rest = if items.len() > 1 && first.command == WAYPOINT { &items[1..] } else { items };
    let what = match () {
        () if rest.iter().all(|item| is_fence(item.command)) => "a geofence",
        () if rest.iter().all(|item| is_rally_point(item.command)) => "a list of rally points",
        () => return Ok(()),
    };
    Err(Box::new(no_mission(what, rest[0].command_span.clone())))
}

/// The error for a list of something else at its first item.
pub(super) fn no_mission(what: &str, first: Range<usize>) -> Diagnostic {
    let error = Diagnostic::error(FORMAT, at(first), format!("this is {what}, not a mission")).here("its first item");
    error.help(
        "name the file of the mission: a plan of QGroundControl (`.plan`) has it with its fence and its rally points; \
         the lines of rally points may also follow those of a mission in one `QGC WPL` file",
    )
}

fn home(item: &Item) -> Read<Home> {
    let height = item.params[6].unwrap_or(0.0);
    if !(-5e3..=10e3).contains(&height) {
        return refuse(
            SYNTAX,
            &item.spans[6],
            "the planned home is not between -5 and 10 km above sea level",
            "no height",
        );
    }
    let span = item.spans[4].start..item.spans[5].end;
    is_there([item.params[4], item.params[5]], &span)?;
    let place = place([item.params[4], item.params[5]], height, [&item.spans[4], &item.spans[5]])?;
    Ok(Home { place, span: item.mark.span.clone(), has_height: true })
}

/// A home below a take-off in the first line. Its height above sea is in no such file, and so no item can be above sea.
fn under_take_off(item: &Item, items: &[Item], found: &mut Vec<Diagnostic>) -> Read<Home> {
    let span = item.spans[4].start..item.spans[5].end;
    is_there([item.params[4], item.params[5]], &span)?;
    let place = place([item.params[4], item.params[5]], 0.0, [&item.spans[4], &item.spans[5]])?;
    let has_place = |item: &&Item| matches!(item.command, 16.0 | 17.0 | 19.0 | 21.0 | 22.0 | 82.0);
    if let Some(above_sea) = items.iter().filter(has_place).find(|item| matches!(item.frame, 0.0 | 5.0)) {
        let message = format!("{}: its height is above sea, and the file has no home", above_sea.mark.name);
        return refuse(UNSUPPORTED, &above_sea.frame_span, &message, "not a height above home");
    }
    let message = "the first item is a take-off: the file has no planned home, and the spec takes the ground below it";
    let warning = Diagnostic::warning(ASSUMED, at(item.mark.span.clone()), message).here("in place of the home");
    found.push(warning.help("ArduPilot would take this line for the home: write the home into the first line"));
    Ok(Home { place, span: item.mark.span.clone(), has_height: false })
}

/// `MAV_CMD_NAV_WAYPOINT`, as which a home is written.
const WAYPOINT: f64 = 16.0;
/// `MAV_CMD_NAV_TAKEOFF`
const TAKE_OFF: f64 = 22.0;

/// Refuses a home at latitude and longitude 0, which ground stations write where none was set.
pub(super) fn is_there(degrees: [Option<f64>; 2], span: &Range<usize>) -> Read<()> {
    if degrees.iter().any(|x| x.is_some_and(|x| x != 0.0)) {
        return Ok(());
    }
    let error = Diagnostic::error(UNSUPPORTED, at(span.clone()), "the planned home is at 0, 0: the file has no home");
    Err(Box::new(error.here("no home").help(
        "set the home in the ground station and save the mission again, or write the latitude, longitude and altitude \
         of the take-off here",
    )))
}

/// `index current frame command param1 .. param4 latitude longitude altitude autocontinue`
fn item(line: &str, span: Range<usize>) -> Read<Item> {
    let cells: Vec<(&str, Range<usize>)> =
        cells(line, span.start, |c| c.is_ascii_whitespace()).filter(|(cell, _)| !cell.is_empty()).collect();
    if cells.len() != COLUMNS {
        let here = format!("this line has {}", cells.len());
        return refuse(SYNTAX, &span, &format!("an item must have {COLUMNS} columns"), &here);
    }
    let mut values = [0.0; COLUMNS];
    for (value, (cell, span)) in values.iter_mut().zip(&cells) {
        // Readers of this format take NaN for a parameter that is left open.
        *value = match cell.parse::<f64>() {
            Ok(number) if !number.is_infinite() => number,
            _ => return refuse(SYNTAX, span, "expected a number", "no number"),
        };
    }
    let params = std::array::from_fn(|k| Some(values[k + 4]).filter(|x| !x.is_nan()));
    Ok(Item {
        mark: Mark { name: format!("item {}", values[0]), span: span.clone() },
        command: values[3],
        command_span: cells[3].1.clone(),
        frame: values[2],
        frame_span: cells[2].1.clone(),
        params,
        spans: std::array::from_fn(|k| cells[k + 4].1.clone()),
        above_sea: None,
    })
}
