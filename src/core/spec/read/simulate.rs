//! The `simulate` block: how the plan is flown, and which faults strike during the flight.

mod checks;
mod strike;
mod word_or_value;

pub use checks::{coarse_step, past_the_end, too_many_steps};

use super::context::Context;
use super::defaulted::Defaulted;
use super::expected::Expected;
use super::fault::family::Families;
use super::fields::Fields;
use super::mission::{MAX_DURATION, ground_too_high, too_long};
use super::plausibility;
use crate::diagnostic::Diagnostic;
use crate::language::table::simulate as table;
use crate::language::{Entry, Group, Range, Takes};
use crate::model::MOTOR_TIME_CONSTANT;
use crate::model::{
    AfterFault, Attitude, Controller, DefaultUsed, FaultMode, FlownVehicle, Gains, Mission, Simulation, Vehicle,
};
use crate::number::number;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr};

const CHOICE: &str = "mavc::simulate::choice";
const POSITIVE: &str = "mavc::simulate::not_positive";
const NEGATIVE: &str = "mavc::simulate::negative";

/// The parts of the spec against which the flight blocks are checked.
pub(super) struct Around<'m> {
    pub modes: &'m [FaultMode],
    pub families: &'m Families,
    /// Some mode has an error, so that an unknown name may be the name of that mode.
    pub incomplete: bool,
    pub vehicle: Option<&'m Vehicle>,
    pub mission: Option<&'m Mission>,
    /// The plan's time where it is fixed, s, and its place.
    pub plan_time: Option<(f64, Span)>,
    /// The place of the plan, which stands in for blocks that are not written.
    pub fallback: Span,
}

impl Around<'_> {
    /// The drag of the vehicle, N s/m.
    fn drag(&self) -> [f64; 3] {
        self.vehicle.map_or([0.0; 3], |vehicle| vehicle.drag)
    }

    /// The wind of the mission, m/s.
    fn wind(&self) -> [f64; 3] {
        self.mission.map_or([0.0; 3], |mission| mission.air.wind)
    }

    /// The gusts of the mission, m/s.
    fn gusts(&self) -> f64 {
        self.mission.map_or(0.0, |mission| mission.air.gusts)
    }
}

/// Reads the block. The simulation is `None` where it has errors; defaults are listed only if the block is written.
/// `campaign` is the place of a `campaign` block, which flies with the same settings.
pub(super) fn elaborate<'a>(
    cx: &mut Context<'a>,
    block: Option<&'a Block>,
    campaign: Option<Span>,
    around: &Around,
) -> (Option<Simulation>, Vec<DefaultUsed>) {
    let Some(block) = block else {
        let ground = own_ground(around.mission).unwrap_or_else(|| {
            lowest(around.mission).filter(|(z, _)| *z <= 0.0).map_or(table::GROUND.value(), |(z, _)| z - BELOW)
        });
        let rate_span = campaign.unwrap_or(around.fallback);
        let simulation = Simulation {
            drag: around.drag(),
            wind: around.wind(),
            gusts: around.gusts(),
            ground,
            span: around.fallback,
            rate_span,
            ..Simulation::default()
        };
        if let (Some(_), Some(vehicle)) = (campaign, around.vehicle)
            && let Some(error) = checks::coarse(&simulation, vehicle)
        {
            cx.report(error);
            return (None, Vec::new());
        }
        return (Some(simulation), Vec::new());
    };
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, "`simulate`".into(), span, &block.body, Group::Simulate);
    let mut reader = Reader { fields: Defaulted::new("simulate", fields), fine: block.is_whole() };
    let simulation = reader.read(cx, block, around);
    if around.vehicle.is_some_and(|v| v.rotors.iter().any(|r| r.time_constant.is_none())) {
        let (field, value) =
            ("vehicle.rotor.time_constant".to_string(), format!("{} ms", number(MOTOR_TIME_CONSTANT * 1e3)));
        reader.fields.used.push(DefaultUsed { field, value, reason: "time constant of rotors in simulations".into() });
    }
    (simulation.filter(|_| reader.fine), reader.fields.used)
}

/// Height (m) and place of the lowest waypoint.
fn lowest(mission: Option<&Mission>) -> Option<(f64, Span)> {
    super::mission::lowest(&mission?.waypoints)
}

/// The ground of the mission, if that gives it, m. Where the mission begins or ends on it, flights have it
/// [`BELOW`] that: a vehicle whose centre of gravity is at the ground is down.
fn own_ground(mission: Option<&Mission>) -> Option<f64> {
    let ground = mission?.ground?;
    Some(if lowest(mission).is_some_and(|(z, _)| z <= ground) { ground - BELOW } else { ground })
}

/// How far the ground of flights is below a waypoint on the ground, m.
const BELOW: f64 = 1.0;

/// The seed of the random noise: a plain whole number.
pub(super) fn seed<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<u64> {
    let value = cx.number(Expected::of(&table::SEED), expr)?;
    if value.fract() == 0.0 && value >= 0.0 && value <= table::SEED.whole().1 as f64 {
        return Some(value as u64);
    }
    let error = Diagnostic::error("mavc::simulate::seed", expr.span, "`seed` must be a whole number from 0 to 2^53");
    cx.report(error.here(format!("this is {}", number(value))).help("write a whole number such as `1`"));
    None
}

struct Reader<'a> {
    fields: Defaulted<'a>,
    /// Whether the block has no errors so far.
    fine: bool,
}

impl<'a> Reader<'a> {
    fn read(&mut self, cx: &mut Context<'a>, block: &'a Block, around: &Around) -> Option<Simulation> {
        let span = block.keyword.span;
        let duration = self.duration(cx);
        let rate = self.quantity(cx, &table::RATE);
        let control_rate = self.quantity(cx, &table::CONTROL_RATE);
        let estimator_rate = self.quantity(cx, &table::ESTIMATOR_RATE);
        let controllers = [Controller::Geometric, Controller::Pd];
        let controller = self.fields.choice_or(cx, &table::CONTROLLER, CHOICE, &controllers, Controller::Geometric);
        let detection = self.detection(cx);
        let reactions = [AfterFault::Continue, AfterFault::Hold, AfterFault::Land, AfterFault::Recovery];
        let after_fault = self.fields.choice_or(cx, &table::AFTER_FAULT, CHOICE, &reactions, AfterFault::Continue);
        let gains = self.gains(cx);
        let forgetting = self.forgetting(cx);
        let threshold = self.quantity(cx, &table::THRESHOLD);
        let gyroscope_noise = self.quantity(cx, &table::GYROSCOPE_NOISE);
        let gyroscope_range = self.quantity(cx, &table::GYROSCOPE_RANGE);
        let assumed_gyroscope_noise = self
            .fields
            .written("assumed_gyroscope_noise", |expr| cx.quantity(&table::ASSUMED_GYROSCOPE_NOISE, expr, NEGATIVE));
        let attitudes = [Attitude::Exact, Attitude::Estimated];
        let attitude = self.fields.choice_or(cx, &table::ATTITUDE, CHOICE, &attitudes, Attitude::Exact);
        let position_noise = self.quantity(cx, &table::POSITION_NOISE);
        let drag = self.value_or_planned(&table::DRAG, around.drag(), [table::DRAG.value(); 3], |expr| {
            cx.drag(&table::DRAG, expr, NEGATIVE)
        });
        let wind = self.value_or_planned(&table::WIND, around.wind(), [0.0; 3], |expr| {
            cx.triple(Expected::of(&table::WIND), expr)
        });
        let gusts = self.value_or_planned(&table::GUSTS, around.gusts(), table::GUSTS.value(), |expr| {
            cx.quantity(&table::GUSTS, expr, NEGATIVE)
        });
        let gust_length = self.quantity(cx, &table::GUST_LENGTH);
        let torque_gusts = self.quantity(cx, &table::TORQUE_GUSTS);
        let spreads = [FlownVehicle::Middle, FlownVehicle::Drawn];
        let spread = self.fields.choice_or(cx, &table::SPREAD, CHOICE, &spreads, FlownVehicle::Middle);
        let centre_offset = self.quantity(cx, &table::CENTRE_OFFSET);
        let seed = self.fields.value_or(&table::SEED, table::SEED.value() as u64, |expr| seed(cx, expr));
        let lost_beyond = self.quantity(cx, &table::LOST_BEYOND);
        let upside_down = self.quantity(cx, &table::UPSIDE_DOWN);
        let lost_yaw = self.lost_yaw(cx);
        let lost_yaw_after = self.quantity(cx, &table::LOST_YAW_AFTER);
        let ground = self.ground(cx, around.mission);
        self.warn_other_air(cx, around, drag, wind);
        if let (Some(drag), Some(wind), Some(gusts)) = (drag, wind, gusts) {
            self.warn_no_drag(cx, drag, wind, gusts);
        }
        let end = self.fields.get("duration").map(|expr| (duration.value(), expr.span, "the flight lasts this long"));
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
            duration: duration.optional().ok()?,
            rate: rate?,
            control_rate: control_rate?,
            estimator_rate: estimator_rate?,
            controller: controller?,
            detection: detection?,
            after_fault: after_fault?,
            gains: gains?,
            forgetting: forgetting?,
            threshold: threshold?,
            gyroscope_noise: gyroscope_noise?,
            gyroscope_range: gyroscope_range?,
            assumed_gyroscope_noise: assumed_gyroscope_noise.optional().ok()?,
            attitude: attitude?,
            position_noise: position_noise?,
            drag: drag?,
            wind: wind?,
            gusts: gusts?,
            gust_length: gust_length?,
            torque_gusts: torque_gusts?,
            spread: spread?,
            centre_offset: centre_offset?,
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
            plausibility::check_air(cx, &simulation, around.vehicle, &self.fields, span);
            plausibility::check_noise(cx, &simulation, &self.fields, span);
            plausibility::check_estimator(cx, &simulation, &self.fields, span);
            plausibility::check_loss(cx, &simulation, &self.fields, span);
        }
        if let Some(vehicle) = around.vehicle.filter(|_| self.fine) {
            plausibility::check_gains(cx, &simulation, vehicle, &self.fields, span);
        }
        Some(simulation)
    }

    /// A field that is as planned where it is not written; where nothing is planned either, the default is recorded.
    fn value_or_planned<T: PartialEq>(
        &mut self,
        entry: &Entry,
        planned: T,
        default: T,
        read: impl FnOnce(&'a Expr) -> Option<T>,
    ) -> Option<T> {
        let written = self.fields.written(entry.name, read);
        written.or_default(|| if planned == default { self.fields.default(entry, default) } else { planned })
    }

    /// Warns of drag (N s/m) and wind (m/s) that differ from those of the plan, if that has drag.
    fn warn_other_air(&self, cx: &mut Context<'a>, around: &Around, drag: Option<[f64; 3]>, wind: Option<[f64; 3]>) {
        if around.drag() == [0.0; 3] {
            return;
        }
        let differs = [
            ("drag", "the vehicle's `drag`", drag.is_some_and(|drag| drag != around.drag())),
            ("wind", "the mission's `air`", wind.is_some_and(|wind| wind != around.wind())),
        ];
        for (field, help, _) in differs.iter().filter(|row| row.2) {
            let Some(span) = self.fields.span_of(field) else { continue };
            let message = format!("flights have another `{field}` than the plan");
            let warning = Diagnostic::warning("mavc::simulate::other_air", span, message).here("used by flights alone");
            cx.report(warning.help(format!("remove it to fly with {help}, by which the mission is planned")));
        }
    }

    fn quantity(&mut self, cx: &mut Context<'a>, entry: &'static Entry) -> Option<f64> {
        let code = if matches!(entry.takes, Takes::Quantity(_, Range::NotNegative)) { NEGATIVE } else { POSITIVE };
        self.fields.quantity_or_default(cx, entry, code)
    }

    /// Not written: as long as the plan.
    fn duration(&mut self, cx: &mut Context<'a>) -> Written<f64> {
        let duration = self.fields.written("duration", |expr| {
            let duration = cx.quantity(&table::DURATION, expr, POSITIVE)?;
            if duration > MAX_DURATION {
                cx.report(too_long(expr.span, duration));
            }
            (duration <= MAX_DURATION).then_some(duration)
        });
        if duration.is_absent() { self.fields.default(&table::DURATION, duration) } else { duration }
    }

    fn gains(&mut self, cx: &mut Context<'a>) -> Option<Gains> {
        let position = self.quantity(cx, &table::POSITION_GAIN);
        let velocity = self.quantity(cx, &table::VELOCITY_GAIN);
        let altitude = self.quantity(cx, &table::ALTITUDE_GAIN);
        let climb = self.quantity(cx, &table::CLIMB_GAIN);
        let attitude = self.quantity(cx, &table::ATTITUDE_GAIN);
        let attitude_rate = self.quantity(cx, &table::ATTITUDE_RATE_GAIN);
        let yaw = self.quantity(cx, &table::YAW_GAIN);
        let yaw_rate = self.quantity(cx, &table::YAW_RATE_GAIN);
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
        self.fields.value_or(&table::FORGETTING, table::FORGETTING.value(), |expr| {
            let value = cx.number(Expected::of(&table::FORGETTING), expr)?;
            if value > 0.0 && value < 1.0 {
                return Some(value);
            }
            let message = "`forgetting` must be greater than 0 and less than 1";
            let error = Diagnostic::error("mavc::simulate::forgetting", expr.span, message);
            cx.report(error.here(format!("this is {}", number(value))).help("write a number such as `0.95`"));
            None
        })
    }

    fn ground(&mut self, cx: &mut Context<'a>, mission: Option<&Mission>) -> Option<f64> {
        let lowest = lowest(mission);
        let Some(expr) = self.fields.get("ground") else {
            if let Some(ground) = own_ground(mission) {
                return Some(ground);
            }
            return Some(match lowest.filter(|(z, _)| *z <= 0.0) {
                Some((z, _)) => {
                    self.fields.used.push(DefaultUsed {
                        field: "simulate.ground".into(),
                        value: format!("{} m", number(z - BELOW)),
                        reason: "1 m below the lowest waypoint".into(),
                    });
                    z - BELOW
                }
                None => self.fields.default(&table::GROUND, table::GROUND.value()),
            });
        };
        let ground = cx.quantity(&table::GROUND, expr, POSITIVE)?;
        match lowest.filter(|(z, _)| *z <= ground) {
            Some(lowest) => {
                cx.report(ground_too_high(
                    "mavc::simulate::ground",
                    "be below every waypoint",
                    expr.span,
                    ground,
                    lowest,
                ));
                None
            }
            None => Some(ground),
        }
    }

    /// Warns of wind or gusts without drag, which have no effect.
    fn warn_no_drag(&self, cx: &mut Context<'a>, drag: [f64; 3], wind: [f64; 3], gusts: f64) {
        let given = [("wind", wind != [0.0; 3]), ("gusts", gusts > 0.0)];
        let Some((name, expr)) = given.iter().find(|g| g.1).and_then(|(name, _)| Some((name, self.fields.get(name)?)))
        else {
            return;
        };
        if drag != [0.0; 3] {
            return;
        }
        let warning = Diagnostic::warning(
            "mavc::simulate::no_drag",
            expr.span,
            format!("`{name}` has no effect, because `drag` is 0 N*s/m"),
        );
        let warning = warning.here("acts only through drag");
        let warning = match self.fields.get("drag") {
            Some(drag) => warning.also(drag.span, "no drag"),
            None => warning,
        };
        let example = "drag = 0.3 N*s/m";
        let warning = warning.help(format!("give a `drag` above zero, such as `{example}`"));
        cx.report(match self.fields.get("drag") {
            Some(drag) => warning.fix(drag.span, "0.3 N*s/m"),
            None => self.fields.add(cx, warning, example),
        });
    }
}
