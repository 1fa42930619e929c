//! The `simulate` block: how the plan is flown, and which faults strike on the way.

mod checks;
mod strike;
mod word_or_value;

pub use checks::{coarse_step, past_the_end, too_many_steps};
pub(super) use strike::CLAUSES as STRIKE_CLAUSES;

use super::context::Context;
use super::due::Due;
use super::fault::family::Families;
use super::fields::Fields;
use super::flight::{MOTOR_TIME_CONSTANT, Written, default};
use super::mission::{MAX_DURATION, too_long};
use super::{AfterFault, Controller, DefaultUsed, FaultMode, Gains, Mission, Simulation, Vehicle, sense};
use crate::diagnostic::Diagnostic;
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr, Statement};

pub(super) const FIELDS: [&str; 28] = [
    "duration",
    "rate",
    "control_rate",
    "estimator_rate",
    "controller",
    "detection",
    "after_fault",
    "position_gain",
    "velocity_gain",
    "altitude_gain",
    "climb_gain",
    "attitude_gain",
    "attitude_rate_gain",
    "yaw_gain",
    "yaw_rate_gain",
    "forgetting",
    "gyroscope_noise",
    "position_noise",
    "drag",
    "wind",
    "gusts",
    "gust_length",
    "seed",
    "lost_beyond",
    "upside_down",
    "lost_yaw",
    "lost_yaw_after",
    "ground",
];

const CHOICE: &str = "mavc::simulate::choice";
const POSITIVE: &str = "mavc::simulate::not_positive";
const NEGATIVE: &str = "mavc::simulate::negative";
/// Largest seed, 2^53: every whole number up to it is an `f64`.
const MAX_SEED: f64 = 9_007_199_254_740_992.0;

/// What the block is read beside.
pub(super) struct Around<'m> {
    pub modes: &'m [FaultMode],
    pub families: &'m Families,
    /// Some mode has an error of its own: an unknown name may be its name.
    pub incomplete: bool,
    pub vehicle: Option<&'m Vehicle>,
    pub mission: Option<&'m Mission>,
    /// The plan's time where it is fixed, s, and its place.
    pub plan_time: Option<(f64, Span)>,
    /// The plan's place, for blocks that are not written.
    pub fallback: Span,
}

/// The simulation, `None` where it has errors, and the defaults of a block that is written. `campaign` is the place of
/// a `campaign` block, which flies by the same settings.
pub(super) fn elaborate<'a>(
    cx: &mut Context<'a>,
    block: Option<&'a Block>,
    campaign: Option<Span>,
    around: &Around,
) -> (Option<Simulation>, Vec<DefaultUsed>) {
    let Some(block) = block else {
        let ground = lowest(around.mission).filter(|(z, _)| *z <= 0.0).map_or(default::GROUND.0, |(z, _)| z - 1.0);
        let rate_span = campaign.unwrap_or(around.fallback);
        let simulation = Simulation { ground, span: around.fallback, rate_span, ..Simulation::default() };
        if let (Some(_), Some(vehicle)) = (campaign, around.vehicle)
            && let Some(error) = checks::coarse(&simulation, vehicle)
        {
            cx.report(error);
            return (None, Vec::new());
        }
        return (Some(simulation), Vec::new());
    };
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, "`simulate`".into(), span, &block.body, &FIELDS);
    let broken = block.body.iter().any(|s| matches!(s, Statement::Broken(_)));
    let mut reader = Reader { fields, defaults: Vec::new(), fine: !broken };
    let simulation = reader.read(cx, block, around);
    if around.vehicle.is_some_and(|v| v.rotors.iter().any(|r| r.time_constant.is_none())) {
        let (field, value) =
            ("vehicle.rotor.time_constant".to_string(), format!("{} ms", number(MOTOR_TIME_CONSTANT * 1e3)));
        reader.defaults.push(DefaultUsed { field, value, reason: "how fast rotors follow in a simulation".into() });
    }
    (simulation.filter(|_| reader.fine), reader.defaults)
}

/// Height and place of the lowest waypoint.
fn lowest(mission: Option<&Mission>) -> Option<(f64, Span)> {
    let heights = mission?.waypoints.iter().map(|w| (w.position[2], w.span));
    heights.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// A plain whole number that noise is drawn from.
pub(super) fn seed<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<u64> {
    let value = cx.number(Due::new("seed", "1"), expr)?;
    if value.fract() == 0.0 && (0.0..=MAX_SEED).contains(&value) {
        return Some(value as u64);
    }
    let error = Diagnostic::error("mavc::simulate::seed", expr.span, "`seed` is a whole number from 0 to 2^53");
    cx.report(error.here(format!("this is {}", number(value))).help("write a whole number such as `1`"));
    None
}

struct Reader<'a> {
    fields: Fields<'a>,
    defaults: Vec<DefaultUsed>,
    /// Nothing in the block has an error.
    fine: bool,
}

impl<'a> Reader<'a> {
    fn read(&mut self, cx: &mut Context<'a>, block: &'a Block, around: &Around) -> Option<Simulation> {
        use default::*;
        let span = block.keyword.span;
        let duration = self.duration(cx);
        let rate = self.positive(cx, "rate", "Hz", RATE);
        let control_rate = self.positive(cx, "control_rate", "Hz", CONTROL_RATE);
        let estimator_rate = self.positive(cx, "estimator_rate", "Hz", ESTIMATOR_RATE);
        let choice =
            self.choice(cx, "controller", &[("geometric", Controller::Geometric), ("pd", Controller::Pd)], CONTROLLER);
        let detection = self.detection(cx);
        let reactions = [("continue", AfterFault::Continue), ("hold", AfterFault::Hold), ("land", AfterFault::Land)];
        let after_fault = self.choice(cx, "after_fault", &reactions, AFTER_FAULT);
        let gains = self.gains(cx);
        let forgetting = self.forgetting(cx);
        let gyroscope_noise = self.not_negative(cx, "gyroscope_noise", "rad/s", GYROSCOPE_NOISE);
        let position_noise = self.not_negative(cx, "position_noise", "m", POSITION_NOISE);
        let drag = self.not_negative(cx, "drag", "N*s/m", DRAG);
        let wind = match self.fields.get("wind") {
            Some(expr) => cx.triple(Due::new("wind", "m/s"), expr),
            None => Some(self.default("wind", WIND)),
        };
        let gusts = self.not_negative(cx, "gusts", "m/s", GUSTS);
        let gust_length = self.positive(cx, "gust_length", "m", GUST_LENGTH);
        let seed = match self.fields.get("seed") {
            Some(expr) => seed(cx, expr),
            None => Some(self.default("seed", SEED)),
        };
        let lost_beyond = self.positive(cx, "lost_beyond", "m", LOST_BEYOND);
        let upside_down = self.positive(cx, "upside_down", "s", UPSIDE_DOWN);
        let lost_yaw = self.lost_yaw(cx);
        let lost_yaw_after = self.positive(cx, "lost_yaw_after", "s", LOST_YAW_AFTER);
        let ground = self.ground(cx, around.mission);
        if let (Some(drag), Some(wind), Some(gusts)) = (drag, wind, gusts) {
            self.warn_no_drag(cx, drag, wind, gusts);
        }
        let end = self.fields.get("duration").map(|expr| (duration.flatten(), expr.span, "the flight lasts this long"));
        // A `duration` with an error leaves the end unknown.
        let end = match end {
            Some((duration, span, why)) => duration.map(|d| (d, span, why)),
            None => checks::fixed_end(around.plan_time, around.mission),
        };
        let faults = strike::read_all(cx, block, around, end);
        let rates = [rate, control_rate, estimator_rate];
        if !checks::rates(cx, &self.fields, rates, around.vehicle, span) {
            self.fine = false;
        }
        if let (Some(rate), Some((end, at, _))) = (rate, end)
            && let Some(error) = checks::steps(end, rate, at)
        {
            cx.report(error);
            self.fine = false;
        }
        let simulation = Simulation {
            duration: duration?,
            rate: rate?,
            control_rate: control_rate?,
            estimator_rate: estimator_rate?,
            controller: choice?,
            detection: detection?,
            after_fault: after_fault?,
            gains: gains?,
            forgetting: forgetting?,
            gyroscope_noise: gyroscope_noise?,
            position_noise: position_noise?,
            drag: drag?,
            wind: wind?,
            gusts: gusts?,
            gust_length: gust_length?,
            seed: seed?,
            faults: faults?,
            lost_beyond: lost_beyond?,
            upside_down: upside_down?,
            lost_yaw: lost_yaw?,
            lost_yaw_after: lost_yaw_after?,
            ground: ground?,
            written: true,
            span,
            rate_span: self.fields.get("rate").map_or(span, |expr| expr.span),
        };
        if let Some(error) = around.vehicle.and_then(|vehicle| checks::coarse_drag(&simulation, vehicle)) {
            cx.report(error);
            self.fine = false;
        } else if self.fine {
            sense::check_air(cx, &simulation, around.vehicle, &self.fields, span);
            sense::check_noise(cx, &simulation, &self.fields, span);
            sense::check_estimator(cx, &simulation, &self.fields, span);
            sense::check_loss(cx, &simulation, &self.fields, span);
        }
        if let Some(vehicle) = around.vehicle.filter(|_| self.fine) {
            sense::check_gains(cx, &simulation, vehicle, &self.fields, span);
        }
        Some(simulation)
    }

    fn default<T>(&mut self, field: &str, (value, text, reason): (T, &str, &str)) -> T {
        let (field, text) = (format!("simulate.{field}"), text.to_string());
        self.defaults.push(DefaultUsed { field, value: text, reason: reason.to_string() });
        value
    }

    fn positive(&mut self, cx: &mut Context<'a>, name: &str, unit: &'static str, default: Written<f64>) -> Option<f64> {
        match self.fields.get(name) {
            Some(expr) => cx.positive(Due::new(name, unit), expr, POSITIVE),
            None => Some(self.default(name, default)),
        }
    }

    fn not_negative(
        &mut self,
        cx: &mut Context<'a>,
        name: &str,
        unit: &'static str,
        default: Written<f64>,
    ) -> Option<f64> {
        match self.fields.get(name) {
            Some(expr) => cx.not_negative(Due::new(name, unit), expr, NEGATIVE),
            None => Some(self.default(name, default)),
        }
    }

    fn choice<T: Copy>(
        &mut self,
        cx: &mut Context<'a>,
        name: &str,
        choices: &[(&str, T)],
        default: Written<T>,
    ) -> Option<T> {
        let words: Vec<&str> = choices.iter().map(|c| c.0).collect();
        match self.fields.word(cx, CHOICE, name, &words) {
            Some(word) => choices.iter().find(|c| Some(c.0) == word).map(|c| c.1),
            None => Some(self.default(name, default)),
        }
    }

    /// `Some(None)`: as long as the plan.
    fn duration(&mut self, cx: &mut Context<'a>) -> Option<Option<f64>> {
        let Some(expr) = self.fields.get("duration") else {
            return Some(self.default("duration", default::DURATION));
        };
        let duration = cx.positive(Due::new("duration", "s"), expr, POSITIVE)?;
        if duration > MAX_DURATION {
            cx.report(too_long(expr.span, duration));
            return None;
        }
        Some(Some(duration))
    }

    fn gains(&mut self, cx: &mut Context<'a>) -> Option<Gains> {
        use default::*;
        const DEVIATION: &str = "1/s^2";
        const RATE: &str = "1/s";
        let position = self.positive(cx, "position_gain", DEVIATION, POSITION_GAIN);
        let velocity = self.positive(cx, "velocity_gain", RATE, VELOCITY_GAIN);
        let altitude = self.positive(cx, "altitude_gain", DEVIATION, ALTITUDE_GAIN);
        let climb = self.positive(cx, "climb_gain", RATE, CLIMB_GAIN);
        let attitude = self.positive(cx, "attitude_gain", DEVIATION, ATTITUDE_GAIN);
        let attitude_rate = self.positive(cx, "attitude_rate_gain", RATE, ATTITUDE_RATE_GAIN);
        let yaw = self.positive(cx, "yaw_gain", DEVIATION, YAW_GAIN);
        let yaw_rate = self.positive(cx, "yaw_rate_gain", RATE, YAW_RATE_GAIN);
        Some(Gains {
            position: position?,
            velocity: velocity?,
            altitude: altitude?,
            climb: climb?,
            attitude: attitude?,
            attitude_rate: attitude_rate?,
            yaw: yaw?,
            yaw_rate: yaw_rate?,
        })
    }

    fn forgetting(&mut self, cx: &mut Context<'a>) -> Option<f64> {
        let Some(expr) = self.fields.get("forgetting") else {
            return Some(self.default("forgetting", default::FORGETTING));
        };
        let value = cx.number(Due::new("forgetting", "1"), expr)?;
        if value > 0.0 && value < 1.0 {
            return Some(value);
        }
        let error = Diagnostic::error(
            "mavc::simulate::forgetting",
            expr.span,
            "`forgetting` lies between 0 and 1, both left out",
        );
        cx.report(error.here(format!("this is {}", number(value))).help("write a number such as `0.95`"));
        None
    }

    fn ground(&mut self, cx: &mut Context<'a>, mission: Option<&Mission>) -> Option<f64> {
        let lowest = lowest(mission);
        let Some(expr) = self.fields.get("ground") else {
            return Some(match lowest.filter(|(z, _)| *z <= 0.0) {
                Some((z, _)) => {
                    let text = format!("{} m", number(z - 1.0));
                    self.default("ground", (z - 1.0, text.as_str(), "1 m below the lowest waypoint"))
                }
                None => self.default("ground", default::GROUND),
            });
        };
        let ground = cx.number(Due::new("ground", "m"), expr)?;
        match lowest.filter(|(z, _)| *z <= ground) {
            Some((z, span)) => {
                let message = format!("the ground at {} m is not below every waypoint", number(ground));
                let error = Diagnostic::error("mavc::simulate::ground", expr.span, message).here("too high");
                cx.report(error.also(span, format!("the lowest waypoint is at {} m", number(z))).help(format!(
                    "write a height below {} m, such as `{} m`",
                    number(z),
                    number(z - 1.0)
                )));
                None
            }
            None => Some(ground),
        }
    }

    /// Warns of wind that moves nothing.
    fn warn_no_drag(&self, cx: &mut Context<'a>, drag: f64, wind: [f64; 3], gusts: f64) {
        let given = [("wind", wind != [0.0; 3]), ("gusts", gusts > 0.0)];
        let Some((name, expr)) = given.iter().find(|g| g.1).and_then(|(name, _)| Some((name, self.fields.get(name)?)))
        else {
            return;
        };
        if drag > 0.0 {
            return;
        }
        let warning = Diagnostic::warning(
            "mavc::simulate::no_drag",
            expr.span,
            format!("`{name}` moves nothing, for `drag` is 0 N*s/m"),
        );
        let warning = warning.here("acts through drag alone");
        let warning = match self.fields.get("drag") {
            Some(drag) => warning.also(drag.span, "no drag"),
            None => warning,
        };
        let example = "drag = 0.3 N*s/m";
        let warning = warning.help(format!("add a `drag` above zero, such as `{example}`"));
        cx.report(match self.fields.get("drag") {
            Some(drag) => warning.fix(drag.span, "0.3 N*s/m"),
            None => self.fields.add(cx, warning, example),
        });
    }
}
