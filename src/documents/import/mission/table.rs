//! Tables of waypoints, as uav_trajectories reads them: `x,y,z` in metres on each line, or a header that names `x,y,z`
//! and, if it has them, `heading` (degrees clockwise from +y, the compass heading if y is north) and `t` (seconds).

use super::draft::{Draft, Mark, Speeds, Stop, Way, Yaw};
use super::items::refuse;
use super::wpl::{cells, lines};
use super::{ASSUMED, LEFT_OUT};
use crate::diagnostic::Diagnostic;
use crate::import::{SYNTAX, UNSUPPORTED, at};
use crate::model::MAX_WAYPOINTS;
use crate::source::Source;
use std::ops::Range;

type Read<T> = Result<T, Box<Diagnostic>>;

/// Columns that a header may name.
const NAMES: [&str; 5] = ["x", "y", "z", "heading", "t"];
const HEADING: usize = 3;
const TIME: usize = 4;
const FARTHEST: f64 = 999e3;
/// Rows nearer together than this, but farther than [`FAR`] from the origin, are not those of a flight in metres.
const DEGREES_APART: f64 = 1.0;
const FAR: f64 = 5.0;

/// The lines that count: not empty, not a comment.
fn rows(text: &str) -> impl Iterator<Item = (&str, Range<usize>)> {
    lines(text).filter(|(line, _)| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
}

/// The cells of a line without the blanks around them.
fn split(line: &str, start: usize) -> Vec<(&str, Range<usize>)> {
    cells(line, start, |c| c == ',')
        .map(|(cell, span)| {
            let start = span.start + cell.len() - cell.trim_start().len();
            (cell.trim(), start..start + cell.trim().len())
        })
        .collect()
}

pub fn is_one(text: &str) -> bool {
    let Some((line, _)) = rows(text).next() else { return false };
    let cells = split(line, 0);
    let is_header = NAMES[..3].iter().all(|name| cells.iter().any(|(cell, _)| cell.eq_ignore_ascii_case(name)));
    is_header || cells.len() == 3 && cells.iter().all(|(cell, _)| cell.parse::<f64>().is_ok())
}

pub fn read(source: &Source, found: &mut Vec<Diagnostic>) -> Read<Draft> {
    let mut rows = rows(&source.text).peekable();
    let mut columns = [Some(0), Some(1), Some(2), None, None];
    let mut draft = Draft { format: "a table of waypoints", ..Draft::default() };
    let header =
        rows.peek().map(|(line, span)| split(line, span.start)).filter(|cells| cells[0].0.parse::<f64>().is_err());
    let count = header.as_ref().map_or(3, Vec::len);
    if let Some(header) = &header {
        rows.next();
        columns = name(header, found)?;
    }
    let (mut first_time, mut row) = (None, 0);
    for (line, span) in rows {
        let cells = split(line, span.start);
        if cells.len() != count {
            let here = format!("{} values", cells.len());
            return refuse(SYNTAX, &span, &format!("a row of this table must have {count} values"), &here);
        }
        row += 1;
        let stop = stop(&cells, &columns, row, span.clone(), &mut first_time)?;
        if !pauses(draft.stops.last_mut(), &stop) {
            draft.stops.push(stop);
        }
        if draft.stops.len() > MAX_WAYPOINTS {
            let message = format!("a mission may have at most {MAX_WAYPOINTS} waypoints");
            return refuse(UNSUPPORTED, &span, &message, "the first too many");
        }
    }
    if draft.stops.len() < 2 {
        return refuse(UNSUPPORTED, &(0..source.text.len().min(1)), "the table has fewer than two rows", "no mission");
    }
    if header.is_none() && is_of_degrees(&draft.stops) {
        let message = "the rows seem to be latitudes and longitudes in degrees: as metres all are within a metre";
        let error = Diagnostic::error(UNSUPPORTED, at(draft.stops[0].mark.span.clone()), message).here("no metres");
        return Err(Box::new(error.help(
            "write x (east), y (north) and z (up) in metres; a plan of QGroundControl (`.plan`) takes degrees",
        )));
    }
    if columns[HEADING].is_some() {
        let header = header.iter().flatten().find(|(cell, _)| cell.eq_ignore_ascii_case("heading"));
        let span = header.map_or(0..0, |(_, span)| span.clone());
        let message = "`heading` is taken as degrees clockwise from +y, as on a compass with y north";
        found.push(Diagnostic::warning(ASSUMED, at(span), message).here("the file does not give its unit or zero"));
    }
    Ok(draft)
}

/// Whether positions are places on the Earth rather than metres: far from the origin, and with steps of millimetres.
fn is_of_degrees(stops: &[Stop]) -> bool {
    let spread = |axis: usize| {
        let of = || stops.iter().map(|stop| stop.position[axis]);
        [of().fold(f64::INFINITY, f64::min), of().fold(f64::NEG_INFINITY, f64::max)]
    };
    let [[west, east], [south, north]] = [spread(0), spread(1)];
    let (size, far) =
        ((east - west).hypot(north - south), west.abs().max(east.abs()).hypot(south.abs().max(north.abs())));
    let is_fine = |x: f64| (x * 1e3).fract() != 0.0;
    let fine = stops.iter().filter(|stop| is_fine(stop.position[0]) && is_fine(stop.position[1])).count();
    size > 0.0 && size < DEGREES_APART && far > FAR && 2 * fine > stops.len()
}

/// Whether a row only says that the vehicle is still where the row before was, which then holds until that time.
fn pauses(before: Option<&mut Stop>, row: &Stop) -> bool {
    let Some((before, (from, until))) = before.and_then(|b| Some((b.time?, row.time?)).map(|times| (b, times))) else {
        return false;
    };
    let is_same = before.position == row.position && before.yaw == row.yaw && until > from;
    if is_same {
        before.hold = Some((until - from, row.mark.clone()));
    }
    is_same
}

/// The column of each of [`NAMES`].
fn name(header: &[(&str, Range<usize>)], found: &mut Vec<Diagnostic>) -> Read<[Option<usize>; 5]> {
    let mut columns = [None; 5];
    for (k, (cell, span)) in header.iter().enumerate() {
        match NAMES.iter().position(|name| cell.eq_ignore_ascii_case(name)) {
            Some(which) if columns[which].is_none() => columns[which] = Some(k),
            Some(_) => return refuse(SYNTAX, span, "the header names a column twice", "the second"),
            None => {
                let message = "a column is left out: those that are read are x, y, z, heading and t";
                found.push(Diagnostic::warning(LEFT_OUT, at(span.clone()), message).here("left out"));
            }
        }
    }
    Ok(columns)
}

fn stop(
    cells: &[(&str, Range<usize>)],
    columns: &[Option<usize>; 5],
    row: usize,
    span: Range<usize>,
    first_time: &mut Option<f64>,
) -> Read<Stop> {
    let value = |which: usize| -> Read<Option<f64>> {
        let Some((cell, span)) = columns[which].map(|k| &cells[k]) else { return Ok(None) };
        match cell.parse::<f64>() {
            Ok(x) if x.abs() <= FARTHEST => Ok(Some(x)),
            Ok(_) => refuse(UNSUPPORTED, span, "a spec takes numbers up to 999,000", "too large"),
            Err(_) => refuse(SYNTAX, span, "expected a number", "no number"),
        }
    };
    let mut position = [0.0; 3];
    for (k, p) in position.iter_mut().enumerate() {
        *p = value(k)?.unwrap_or(0.0);
    }
    let time = value(TIME)?;
    let start = *first_time.get_or_insert(time.unwrap_or(0.0));
    Ok(Stop {
        mark: Mark { name: format!("row {row}"), span },
        remark: "",
        position,
        yaw: value(HEADING)?.map_or(Yaw::Unsaid, |heading| Yaw::Angle(90.0 - heading)),
        within: None,
        time: time.map(|time| time - start),
        hold: None,
        way: Way::Any,
        stops: false,
        speeds: Speeds::default(),
    })
}
