//! Plans of QGroundControl, JSON of `"fileType": "Plan"` (version 1 with a mission of version 2).

use super::draft::{Draft, Home, Mark};
use super::items::{Faults, FileSettings, Item, follow, place, refuse};
use super::{LEFT_OUT, fence, rally};
use crate::diagnostic::Diagnostic;
use crate::import::json::{Json, JsonValue, parse};
use crate::import::{FORMAT, SYNTAX, UNSUPPORTED, at};
use crate::source::Source;
use std::ops::Range;

type Read<T> = Result<T, Box<Diagnostic>>;

/// `MAV_AUTOPILOT_ARDUPILOTMEGA`
const ARDUPILOT: f64 = 3.0;
/// Values of `MAV_TYPE` that are multirotors, and 0, a generic vehicle: quadrotor, helicopter, hexa-, octo-, tricopter,
/// dodeca- and decarotor.
const MULTIROTORS: [f64; 8] = [0.0, 2.0, 4.0, 13.0, 14.0, 15.0, 29.0, 35.0];

pub fn read(source: &Source, found: &mut Vec<Diagnostic>) -> Read<Draft> {
    let plan = parse(&source.text)?;
    if plan.get("fileType").and_then(Json::text) != Some("Plan") {
        let here = plan.get("fileType").map_or(0..1, |there| there.span.clone());
        let message = "this JSON is not a plan of QGroundControl: it needs `\"fileType\": \"Plan\"`";
        let error = Diagnostic::error(FORMAT, at(here), message).here("not a plan");
        // Missions before plans had these members themselves.
        let is_older = plan.get("MAV_AUTOPILOT").is_some() || plan.get("plannedHomePosition").is_some();
        return Err(Box::new(error.help(match is_older {
            true => "it is an older form of a mission: open it in QGroundControl, and save it as a plan",
            false => "name a mission as QGroundControl saves it, in a file that ends in `.plan`",
        })));
    }
    let mission = member(&plan, "mission")?;
    version(&plan, 1.0)?;
    version(mission, 2.0)?;
    let home = home(mission)?;
    let firmware = mission.get("firmwareType").and_then(Json::number);
    check_vehicle(mission, found);
    let setting = FileSettings::of(home.clone(), firmware == Some(ARDUPILOT));
    let mut items = Vec::new();
    let list = member(mission, "items")?;
    let mut faults = Faults::default();
    for item in listed(list, "items")? {
        let collected = collect(item, &mut items, found);
        faults.take(collected);
    }
    let mut draft = Draft { format: "a plan of QGroundControl", home: Some(home), ..Draft::default() };
    let followed = follow(&items, &setting, &mut draft, found);
    faults.take(followed);
    faults.end(found)?;
    if draft.stops.len() < 2 {
        let message = "the mission has fewer than two places to fly to";
        let error = Diagnostic::error(UNSUPPORTED, at(list.span.clone()), message).here("the items");
        return Err(Box::new(error.help("add waypoints in the ground station")));
    }
    if let Some(fences) = plan.get("geoFence") {
        fence::read(fences, &setting, &mut draft)?;
    }
    if let Some(points) = plan.get("rallyPoints") {
        rally::of_plan(points, &setting, &mut draft)?;
        rally::set_ground(&setting, &mut draft, found);
    }
    // With them QGroundControl estimates how long the mission takes; the autopilot does not get them.
    let unused = ["cruiseSpeed", "hoverSpeed"].into_iter().filter(|name| mission.get(name).is_some());
    draft.dropped.extend(unused.map(String::from));
    rally::warn_of_return(&draft, &setting, found);
    Ok(draft)
}

fn member<'j>(object: &'j Json, key: &str) -> Read<&'j Json> {
    match (object.get(key), &object.kind) {
        (Some(value), _) => Ok(value),
        (None, JsonValue::Object(_)) => {
            let start = object.span.start;
            refuse(SYNTAX, &(start..start + 1), &format!("the object has no `{key}`"), &format!("needs `{key}`"))
        }
        (None, _) => refuse(SYNTAX, &object.span, &format!("expected an object, found {}", object.what()), "no object"),
    }
}

pub(super) fn listed<'j>(value: &'j Json, what: &str) -> Read<&'j [Json]> {
    match value.list() {
        Some(list) => Ok(list),
        None => refuse(SYNTAX, &value.span, &format!("`{what}` must be a list, not {}", value.what()), "no list"),
    }
}

pub(super) fn numeric(value: &Json, what: &str) -> Read<f64> {
    match value.number() {
        Some(number) => Ok(number),
        None => refuse(SYNTAX, &value.span, &format!("`{what}` must be a number, not {}", value.what()), "no number"),
    }
}

fn version(object: &Json, due: f64) -> Read<()> {
    let version = member(object, "version")?;
    if numeric(version, "version")? == due {
        return Ok(());
    }
    let message = format!("this is not version {due} of the format");
    let error = Diagnostic::error(UNSUPPORTED, at(version.span.clone()), message).here("another version");
    Err(Box::new(error.help("open the plan in a present QGroundControl, and save it again")))
}

fn home(mission: &Json) -> Read<Home> {
    let home = member(mission, "plannedHomePosition")?;
    let [latitude, longitude, altitude] = listed(home, "plannedHomePosition")? else {
        let message = "`plannedHomePosition` must be latitude, longitude and altitude";
        return refuse(SYNTAX, &home.span, message, "not three numbers");
    };
    let height = numeric(altitude, "plannedHomePosition")?;
    if !(-5e3..=10e3).contains(&height) {
        return refuse(
            SYNTAX,
            &altitude.span,
            "the planned home is not between -5 and 10 km above sea level",
            "no height",
        );
    }
    let degrees = [Some(numeric(latitude, "plannedHomePosition")?), Some(numeric(longitude, "plannedHomePosition")?)];
    super::wpl::is_there(degrees, &(latitude.span.start..longitude.span.end))?;
    let place = place(degrees, height, [&latitude.span, &longitude.span])?;
    Ok(Home { place, span: latitude.span.clone(), has_height: true })
}

fn check_vehicle(mission: &Json, found: &mut Vec<Diagnostic>) {
    let Some(kind) = mission.get("vehicleType") else { return };
    if kind.number().is_none_or(|kind| !MULTIROTORS.contains(&kind)) {
        let message = "the plan is not one of a multirotor: other vehicles fly its items in other ways";
        let warning = Diagnostic::warning(super::ASSUMED, at(kind.span.clone()), message);
        found.push(warning.here("not a multirotor (`MAV_TYPE`)").help("check each item in the spec"));
    }
}

/// Adds an item, or those that a survey consists of.
fn collect(item: &Json, items: &mut Vec<Item>, found: &mut Vec<Diagnostic>) -> Read<()> {
    let kind = member(item, "type")?;
    match kind.text() {
        Some("SimpleItem") => {
            let simple = simple(item, items.len() + 1)?;
            items.push(simple);
            Ok(())
        }
        Some("ComplexItem") => {
            let inner = item.get("TransectStyleComplexItem").and_then(|inner| inner.get("Items")).and_then(Json::list);
            let Some(inner) = inner else {
                let name = item.get("complexItemType").unwrap_or(kind);
                if item.get("TransectStyleComplexItem").is_some() {
                    let error =
                        Diagnostic::error(UNSUPPORTED, at(name.span.clone()), "the file lacks the items of a survey");
                    let error = error.here("only its area");
                    return Err(Box::new(error.help("open the plan in QGroundControl, and save it again")));
                }
                let message = "a spec has no word for this complex item";
                return refuse(UNSUPPORTED, &name.span, message, "not a survey of waypoints");
            };
            let first = items.len() + 1;
            for item in inner {
                let simple = simple(item, items.len() + 1)?;
                items.push(simple);
            }
            let message = format!("a survey becomes its items {first} to {}: the area itself is left out", items.len());
            found.push(Diagnostic::warning(LEFT_OUT, at(kind.span.clone()), message).here("a survey"));
            Ok(())
        }
        _ => refuse(SYNTAX, &kind.span, "the type of an item must be `SimpleItem` or `ComplexItem`", "another type"),
    }
}

fn simple(item: &Json, number: usize) -> Read<Item> {
    let params = member(item, "params")?;
    let list = listed(params, "params")?;
    if list.len() != 7 {
        return refuse(SYNTAX, &params.span, "`params` must be seven numbers", &format!("{} values", list.len()));
    }
    let mut values = [None; 7];
    let mut spans: [Range<usize>; 7] = Default::default();
    for (k, param) in list.iter().enumerate() {
        spans[k] = param.span.clone();
        values[k] = match param.kind {
            JsonValue::Null => None,
            _ => Some(numeric(param, "params")?),
        };
    }
    let (command, frame) = (member(item, "command")?, member(item, "frame")?);
    Ok(Item {
        // Its number in the file, since the whole item is a page of lines.
        mark: Mark { name: format!("item {number}"), span: item.get("doJumpId").unwrap_or(command).span.clone() },
        command: numeric(command, "command")?,
        command_span: command.span.clone(),
        frame: numeric(frame, "frame")?,
        frame_span: frame.span.clone(),
        params: values,
        spans,
        above_sea: item.get("AMSLAltAboveTerrain").and_then(Json::number),
    })
}
