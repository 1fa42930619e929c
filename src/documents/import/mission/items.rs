//! MAVLink's mission items (the commands of `MAV_CMD`, common.xml) as waypoints, as the autopilot flies them: PX4 1.15,
//! `src/modules/navigator`, or ArduCopter 4.5, `mode_auto.cpp`.

mod speeds;
mod turns;
mod vertical;

use super::autopilot::{ARDUPILOT, Autopilot, PX4};
use super::commands::{self, Effect};
use super::draft::{Draft, Home, Mark, Speeds, Stop, Way, Yaw};
use super::{ASSUMED, LEFT_OUT};
use crate::diagnostic::Diagnostic;
use crate::geodesy::{Geodetic, TangentPlane};
use crate::import::{SYNTAX, UNSUPPORTED, at};
use crate::model::MAX_WAYPOINTS;
use crate::number::{number, plural};
use std::ops::Range;

/// An item as the file has it.
#[derive(Debug, Clone)]
pub struct Item {
    pub mark: Mark,
    pub command: f64,
    pub command_span: Range<usize>,
    /// `MAV_FRAME`
    pub frame: f64,
    pub frame_span: Range<usize>,
    /// Parameters 1 to 7; `None` for what the file leaves open (NaN or null).
    pub params: [Option<f64>; 7],
    pub spans: [Range<usize>; 7],
    /// Height above mean sea level that the ground station computed from the terrain, m.
    pub above_sea: Option<f64>,
}

/// What holds for all items of a file.
pub struct FileSettings {
    pub home: Home,
    /// The autopilot is ArduPilot, otherwise PX4.
    pub is_ardupilot: bool,
}

impl FileSettings {
    /// The speeds of the autopilot that flies the mission.
    pub fn of(home: Home, is_ardupilot: bool) -> Self {
        FileSettings { home, is_ardupilot }
    }

    pub fn autopilot(&self) -> &'static Autopilot {
        if self.is_ardupilot { &ARDUPILOT } else { &PX4 }
    }
}

/// How far an item may be from home, m: the bound of a spec, less what rounding adds.
pub(super) const FARTHEST: f64 = 999e3;
/// Heights of items, m.
const HEIGHTS: (f64, f64) = (-10e3, 100e3);
/// `MAV_FRAME` of heights above sea, home or the terrain, and of items without a place.
const FRAMES: [f64; 7] = [0.0, 2.0, 3.0, 5.0, 6.0, 10.0, 11.0];
/// m
const CENTIMETRE: f64 = 0.01;
/// The remark of a landing that ends a return.
pub(super) const LANDS_AT_HOME: &str = "land at home";
/// A take-off or landing nearer than this to the place above or below it is vertical, m.
const SAME_PLACE: f64 = 0.5;

/// The state while items are followed.
struct Follow<'f> {
    setting: &'f FileSettings,
    plane: TangentPlane,
    speeds: Speeds,
    stops: Vec<Stop>,
    found: &'f mut Vec<Diagnostic>,
    /// The item after which nothing more is flown, and those that come after it.
    ended: Option<Mark>,
    late: Vec<Mark>,
    /// Commands without an effect on the flight: the place of the warning in `found`, and how many items have it.
    left_out: Vec<(u32, usize, usize)>,
    /// The last waypoint is of a spline, on which the vehicle leaves too.
    was_spline: bool,
    /// The yaw (deg, counter-clockwise from east) of the next place, which `MAV_CMD_CONDITION_YAW` sets.
    turn: Option<f64>,
    /// The region of interest: x and y, m.
    region: Option<[f64; 2]>,
}

type Read<T> = Result<T, Box<Diagnostic>>;
type Step = Read<()>;

/// Errors that are all reported, the last of them as the outcome.
#[derive(Default)]
pub struct Faults(Vec<Diagnostic>);

impl Faults {
    /// The value, or `None` after an error that is kept.
    pub fn take<T>(&mut self, read: Read<T>) -> Option<T> {
        read.map_err(|fault| self.0.push(*fault)).ok()
    }

    /// # Errors
    /// The last that was kept; those before it are added to `found`.
    pub fn end(mut self, found: &mut Vec<Diagnostic>) -> Step {
        let last = self.0.pop();
        found.extend(self.0);
        last.map_or(Ok(()), |last| Err(Box::new(last)))
    }
}

/// Adds the waypoints of the items to the draft; items that a spec cannot say are left out with a warning in `found`.
///
/// # Errors
/// An item without which the flight would be another one; if there are several, all but the last are added to `found`.
pub fn follow(items: &[Item], setting: &FileSettings, draft: &mut Draft, found: &mut Vec<Diagnostic>) -> Step {
    let plane = TangentPlane::at(setting.home.place);
    let mut follow = Follow {
        setting,
        plane,
        speeds: setting.autopilot().speeds(&setting.home.span),
        stops: Vec::new(),
        found,
        ended: None,
        late: Vec::new(),
        left_out: Vec::new(),
        was_spline: false,
        turn: None,
        region: None,
    };
    let mut faults = Faults::default();
    for item in items {
        let step = follow.item(item);
        faults.take(step);
        if follow.stops.len() > MAX_WAYPOINTS {
            let error = Diagnostic::error(UNSUPPORTED, at(item.mark.span.clone()), "the mission has too many items");
            let error = error.here(format!("a mission may have at most {MAX_WAYPOINTS} waypoints"));
            return Err(Box::new(error.help("divide it into several missions")));
        }
    }
    if let (Some(end), [first, rest @ ..]) = (&follow.ended, &follow.late[..]) {
        let all = rest.last().map_or(String::new(), |last| format!(" to {}", last.name));
        let come = if rest.is_empty() { "comes" } else { "come" };
        let message = format!("{}{all} {come} after {}, which ends the mission", first.name, end.name);
        let warning = Diagnostic::warning(LEFT_OUT, at(first.span.clone()), message);
        follow.found.push(warning.here("left out").also(at(end.span.clone()), "ends the mission"));
    }
    for (_, at, count) in follow.left_out.iter().filter(|(_, _, count)| *count > 1) {
        let warning = &mut follow.found[*at];
        warning.message = format!("{}, here and in {}", warning.message, plural(count - 1, "more item"));
    }
    draft.stops = follow.stops;
    faults.end(found)
}

impl Follow<'_> {
    fn item(&mut self, item: &Item) -> Step {
        if self.ended.is_some() {
            self.late.push(item.mark.clone());
            return Ok(());
        }
        if item.command.fract() != 0.0 || !(0.0..=65535.0).contains(&item.command) {
            return refuse(
                SYNTAX,
                &item.command_span,
                "`command` must be a whole number from 0 to 65535",
                "no command",
            );
        }
        match item.command as u32 {
            16 => self.waypoint(item, item.params[0]),
            82 => {
                self.warn(
                    ASSUMED,
                    item,
                    "a spline becomes a waypoint: mavc plans its own curve through it",
                    "a spline",
                );
                self.waypoint(item, item.params[0])
            }
            17 => {
                self.waypoint(item, None)?;
                self.ended = Some(item.mark.clone());
                Ok(())
            }
            19 => self.waypoint(item, item.params[0]),
            93 => self.delay(item),
            20 => self.back_home(item),
            21 => self.land(item),
            22 => self.take_off(item),
            178 => self.speed(item),
            80 | 195 | 201 => self.look_at(item),
            197 => {
                self.region = None;
                Ok(())
            }
            115 => {
                self.condition_yaw(item);
                Ok(())
            }
            177 if item.params[1] == Some(0.0) => Ok(()),
            other => self.other(item, other),
        }
    }

    fn warn(&mut self, code: &'static str, item: &Item, message: &str, here: &str) {
        let message = format!("{}: {message}", item.mark.name);
        self.found.push(Diagnostic::warning(code, at(item.mark.span.clone()), message).here(here));
    }

    fn warn_with(&mut self, code: &'static str, item: &Item, message: &str, here: &str, help: &str) {
        self.warn(code, item, message, here);
        let warning = self.found.pop().map(|warning| warning.help(help));
        self.found.extend(warning);
    }

    /// A command that this module does not follow.
    fn other(&mut self, item: &Item, command: u32) -> Step {
        let named = commands::name(command).map_or(String::new(), |name| format!(" ({name})"));
        match commands::effect(command, item.params[0]) {
            Effect::Flight => {
                let message = format!("{}: a spec has no word for command {command}{named}", item.mark.name);
                return refuse(UNSUPPORTED, &item.command_span, &message, "changes where the vehicle flies");
            }
            Effect::None => {
                let message =
                    format!("command {command}{named} is left out: it does not change where the vehicle flies");
                match self.left_out.iter_mut().find(|(known, ..)| *known == command) {
                    None => {
                        self.left_out.push((command, self.found.len(), 1));
                        self.warn(LEFT_OUT, item, &message, "left out");
                    }
                    Some((_, _, count)) => *count += 1,
                }
            }
            Effect::Unsure => {
                let message = format!("command {command}{named} is left out, and may change where the vehicle flies");
                let help = "look it up in the autopilot's documentation: if it does, the spec is not this flight";
                self.warn_with(LEFT_OUT, item, &message, "left out", help);
            }
        }
        Ok(())
    }

    /// The position of an item; of latitude and longitude both open or both 0, the present ones.
    fn position(&mut self, item: &Item) -> Result<[f64; 3], Box<Diagnostic>> {
        let (latitude, longitude) = (item.params[4], item.params[5]);
        let height = self.height(item)?;
        let is_open = |x: Option<f64>| x.is_none_or(|x| x == 0.0);
        let [x, y] = match self.stops.last() {
            Some(last) => [last.position[0], last.position[1]],
            None => [0.0; 2],
        };
        if is_open(latitude) && is_open(longitude) {
            let above = self.plane.place([x, y, 0.0]);
            let z = self.plane.local(&Geodetic { height, ..above })[2];
            return Ok([x, y, z]);
        }
        let place = place([latitude, longitude], height, [&item.spans[4], &item.spans[5]])?;
        let position = self.plane.local(&place);
        if position.iter().any(|p| p.abs() > FARTHEST) {
            let far = position.iter().fold(0.0, |sum, p| sum + p * p).sqrt();
            let message = format!("{} is {} km from the planned home", item.mark.name, number(far / 1e3));
            let error = Diagnostic::error(UNSUPPORTED, at(item.mark.span.clone()), message).here("too far for a spec");
            let error = error.also(at(self.setting.home.span.clone()), "the planned home");
            return Err(Box::new(error.help("correct the home: a spec reaches 1000 km from its origin")));
        }
        Ok(position)
    }

    /// Height above the ellipsoid, by the item's frame, m.
    fn height(&mut self, item: &Item) -> Result<f64, Box<Diagnostic>> {
        let home = self.setting.home.place.height;
        // ArduCopter keeps heights in centimetres and takes 0 for the present one (`loc_from_cmd`).
        let is_present = |height: f64| {
            self.setting.is_ardupilot && height.abs() < CENTIMETRE && !matches!(item.command, 21.0 | 22.0)
        };
        let given = item.params[6].filter(|height| !is_present(*height));
        let height = match (item.frame, given) {
            (0.0 | 5.0, Some(height)) => height,
            (3.0 | 6.0, Some(height)) => home + height,
            (10.0 | 11.0, Some(_)) => match item.above_sea {
                Some(height) => {
                    let message = format!(
                        "its height is over the terrain; the ground station computed {} m above mean sea level",
                        number(height)
                    );
                    self.warn(ASSUMED, item, &message, "a spec does not know the terrain");
                    height
                }
                None => {
                    let message =
                        format!("{}: its height is over the terrain, which the file does not give", item.mark.name);
                    return refuse(UNSUPPORTED, &item.frame_span, &message, "a frame of the terrain");
                }
            },
            // Where it is left open, the present height.
            (frame, _) if FRAMES.contains(&frame) => {
                let last = self.stops.last().map_or([0.0; 3], |stop| stop.position);
                self.plane.place(last).height
            }
            _ => return self.refuse_frame(item),
        };
        if !(HEIGHTS.0..=HEIGHTS.1).contains(&height) {
            let message = format!("{}: no vehicle flies at {} m above mean sea level", item.mark.name, number(height));
            return refuse(SYNTAX, &item.spans[6], &message, "too high or too low");
        }
        if matches!(item.command, 16.0 | 19.0 | 82.0) {
            self.warn_below_home(item, height);
        }
        Ok(height)
    }

    /// A height above sea, m.
    fn warn_below_home(&mut self, item: &Item, height: f64) {
        let below = self.setting.home.place.height - height;
        if below > CENTIMETRE {
            let message =
                format!("it is {} m below the planned home; check that the ground is lower there", number(below));
            self.warn(ASSUMED, item, &message, "below the ground at home");
        }
    }

    fn push(&mut self, item: &Item, position: [f64; 3], remark: &'static str) -> &mut Stop {
        self.stops.push(Stop {
            mark: item.mark.clone(),
            remark,
            position,
            yaw: Yaw::Free,
            within: None,
            time: None,
            hold: None,
            way: Way::Straight,
            stops: false,
            speeds: self.speeds.clone(),
        });
        let last = self.stops.len() - 1;
        &mut self.stops[last]
    }

    /// A waypoint, spline or loiter: parameter 1 the seconds at rest, 2 the radius of acceptance of a waypoint.
    fn waypoint(&mut self, item: &Item, hold: Option<f64>) -> Step {
        let position = self.position(item)?;
        let is_waypoint = matches!(item.command, 16.0 | 82.0);
        let yaw = self.yaw(item);
        if is_waypoint && item.params[2].is_some_and(|radius| radius != 0.0) {
            self.warn(LEFT_OUT, item, "parameter 3, by which it is passed at a distance, is left out", "left out");
        }
        let (hold, within) = (hold.filter(|s| *s > 0.0), item.params[1].filter(|r| is_waypoint && *r > 0.0));
        if let Some(seconds) = hold.filter(|s| *s > 1e5) {
            let message = format!("{}: a spec holds at most 100,000 s, not {} s", item.mark.name, number(seconds));
            return refuse(UNSUPPORTED, &item.spans[0], &message, "too long");
        }
        let remark = if is_waypoint { "" } else { "loiter" };
        let is_spline = item.command == 82.0;
        let leaves_spline = std::mem::replace(&mut self.was_spline, is_spline);
        let stop = self.push(item, position, remark);
        (stop.yaw, stop.within) = (yaw, within);
        if is_spline || leaves_spline {
            stop.way = Way::Any;
        }
        stop.hold = hold.map(|seconds| (seconds, item.mark.clone()));
        Ok(())
    }

    fn delay(&mut self, item: &Item) -> Step {
        let Some(seconds) = item.params[0].filter(|s| *s > 0.0 && *s <= 1e5) else {
            let message = format!("{}: a delay until a time of day depends on when the flight starts", item.mark.name);
            return refuse(UNSUPPORTED, &item.spans[0], &message, "no number of seconds");
        };
        match self.stops.last_mut() {
            Some(last) => {
                let before = last.hold.take().map_or(0.0, |(before, _)| before);
                last.hold = Some((before + seconds, item.mark.clone()));
            }
            None => self.warn(LEFT_OUT, item, "a delay before the vehicle has taken off is left out", "left out"),
        }
        Ok(())
    }

    fn refuse_frame<T>(&self, item: &Item) -> Read<T> {
        let message = format!("{}: a spec has no word for frame {}", item.mark.name, number(item.frame));
        refuse(UNSUPPORTED, &item.frame_span, &message, "not a frame of heights above sea or home")
    }

    fn autopilot(&self) -> &'static Autopilot {
        self.setting.autopilot()
    }
}

pub(super) fn refuse<T>(
    code: &'static str,
    span: &Range<usize>,
    message: &str,
    here: &str,
) -> Result<T, Box<Diagnostic>> {
    let help = match code {
        UNSUPPORTED => "take the item out of the mission, or write this part of the spec by hand",
        _ => "correct it in the ground station, and write the file again",
    };
    Err(Box::new(Diagnostic::error(code, at(span.clone()), message).here(here).help(help)))
}

/// A place from degrees; `spans` are those of latitude and longitude.
pub fn place(degrees: [Option<f64>; 2], height: f64, spans: [&Range<usize>; 2]) -> Result<Geodetic, Box<Diagnostic>> {
    let mut values = [0.0; 2];
    for (k, (name, most)) in [("latitude", 90.0), ("longitude", 180.0)].into_iter().enumerate() {
        match degrees[k].filter(|x| x.abs() <= most) {
            Some(x) => values[k] = x,
            None => {
                let message = format!("a {name} must be between -{most} and {most} degrees");
                return refuse(SYNTAX, spans[k], &message, &format!("no {name}"));
            }
        }
    }
    Ok(Geodetic::degrees(values[0], values[1], height))
}
