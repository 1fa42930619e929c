//! The properties of rotors: those given for all, and those given for one.

use super::POSITIVE;
use super::mounts::Mount;
use super::rotor_table::RotorTable;
use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::language::table::rotor as table;
use crate::model::{Rotor, RotorSpread, Spin, Spread};
use crate::number::{number, significant};
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::plausibility::RotorSpans;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::Expr;
use crate::unit::Dimension;

pub(super) const MIN_SPEED: &str = "mavc::vehicle::min_speed";

/// Every rotor with its thrust, torque and speed: its own clauses override the `rotor` block.
pub(super) fn give_all<'a>(
    cx: &mut Context<'a>,
    mounts: Vec<Mount<'a>>,
    shared: Option<&Fields<'a>>,
    base: Option<PartialRotor>,
) -> Option<Vec<Rotor>> {
    let mut rotors = Some(Vec::new());
    let mut reported = false;
    for mount in &mounts {
        let own = mount.own.as_ref().map(|fields| PartialRotor::read(cx, fields));
        let partial = match (&own, &base) {
            (Some(own), Some(base)) => own.over(base),
            (Some(own), None) => own.clone(),
            (None, Some(base)) => base.clone(),
            (None, None) => return None,
        };
        let owner = shared.filter(|_| own.is_none()).or(mount.own.as_ref()).or(shared);
        match (&mut rotors, partial.rotor(cx, mount, owner, &mut reported)) {
            (Some(list), Some(rotor)) => list.push(rotor),
            (list, _) => *list = None,
        }
        if rotors.is_none() && mount.own.is_none() {
            return None;
        }
    }
    rotors
}

/// Where each rotor's numbers are written: in its own clauses, or else in the `rotor` block. `fields` are those of the
/// vehicle, which give the arm of a ring.
pub(super) fn spans(mounts: &[Mount], fields: &Fields, shared: Option<&Fields>) -> Vec<RotorSpans> {
    let one = |mount: &Mount| {
        let blocks = [mount.own.as_ref(), shared, Some(fields)];
        let of = |names: &[&str]| {
            let found = blocks.iter().flatten().find_map(|block| names.iter().find_map(|name| block.span_of(name)));
            found.unwrap_or(fields.span)
        };
        RotorSpans {
            place: of(&["at", "arm"]),
            thrust: of(&["thrust_coefficient", "max_thrust", "table"]),
            torque: of(&["drag_coefficient", "torque_per_thrust", "table"]),
            min_speed: of(&["min_speed", "min_thrust"]),
            max_speed: of(&["max_speed", "table"]),
            time_constant: of(&["time_constant"]),
        }
    };
    mounts.iter().map(one).collect()
}

/// A number and how well it is known.
type Known = (f64, Spread);

/// The lowest speed of a rotor, as written.
#[derive(Clone, Copy)]
enum Lowest {
    /// rad/s
    Speed(f64),
    /// N
    Thrust(f64),
    /// A share of the thrust at full speed.
    Share(f64),
}

impl Lowest {
    /// The speed (rad/s) that gives it, with the middle of the thrust coefficient b (N s^2/rad^2): the thrust is b w
    /// |w|.
    fn speed(self, thrust_coefficient: f64, max_speed: f64) -> f64 {
        match self {
            Lowest::Speed(speed) => speed,
            Lowest::Thrust(thrust) => (thrust.abs() / thrust_coefficient).sqrt().copysign(thrust),
            Lowest::Share(share) => max_speed * share.abs().sqrt().copysign(share),
        }
    }
}

/// The properties written for a rotor.
#[derive(Clone, Default)]
pub(super) struct PartialRotor {
    thrust_coefficient: Written<Known>,
    max_thrust: Written<Known>,
    drag_coefficient: Written<Known>,
    torque_per_thrust: Written<Known>,
    lowest: Written<(Lowest, Span)>,
    max_speed: Written<Known>,
    time_constant: Written<f64>,
    inertia: Written<Known>,
    /// Whether a thrust table gives what it can.
    has_table: bool,
    /// The torque per thrust that a table without torques suggests.
    estimated_torque: Option<Known>,
}

impl PartialRotor {
    pub fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Self {
        let mut take = |entry: &'static Entry, coefficient: bool| {
            let due = Expected { coefficient, ..Expected::of(entry) };
            meant(fields, entry.name, fields.written(entry.name, |expr| cx.interval(due, expr, POSITIVE)))
        };
        let quantity = |cx: &mut Context<'a>, entry: &'static Entry| {
            meant(fields, entry.name, fields.quantity(cx, entry, POSITIVE))
        };
        let partial = PartialRotor {
            thrust_coefficient: take(&table::THRUST_COEFFICIENT, true),
            max_thrust: take(&table::MAX_THRUST, false),
            drag_coefficient: take(&table::DRAG_COEFFICIENT, true),
            torque_per_thrust: take(&table::TORQUE_PER_THRUST, false),
            max_speed: take(&table::MAX_SPEED, false),
            inertia: take(&table::ROTOR_INERTIA, false),
            time_constant: quantity(cx, &table::TIME_CONSTANT),
            lowest: {
                let speed = fields.written("min_speed", |expr| {
                    cx.quantity(&table::MIN_SPEED, expr, MIN_SPEED).map(|w| (Lowest::Speed(w), expr.span))
                });
                let lowest = match speed.is_absent() {
                    true => fields.written("min_thrust", |expr| Some((lowest_thrust(cx, expr)?, expr.span))),
                    false => speed,
                };
                meant(fields, "min_thrust", meant(fields, "min_speed", lowest))
            },
            has_table: false,
            estimated_torque: None,
        };
        let alike = table::ENTRIES.iter().flat_map(|row| row.excludes.iter().map(|other| (row.name, *other)));
        for (a, b) in alike {
            if let (Some(first), Some(second)) = (fields.span_of(a), fields.span_of(b)) {
                let message = format!("`{a}` and `{b}` cannot both be given");
                let (first, second) = if first.start <= second.start { (first, second) } else { (second, first) };
                cx.report(
                    Diagnostic::error("mavc::vehicle::conflict", second, message)
                        .here("one of the two")
                        .also(first, "the other")
                        .help("remove one of them"),
                );
            }
        }
        partial
    }

    /// What a thrust table gives; faulty if it has errors.
    pub fn of_table(table: &Written<RotorTable>) -> Self {
        let table = match table {
            Written::Absent => return PartialRotor::default(),
            Written::Faulty => {
                let (max_thrust, torque_per_thrust) = (Written::Faulty, Written::Faulty);
                return PartialRotor { max_thrust, torque_per_thrust, max_speed: Written::Faulty, ..Self::default() };
            }
            Written::Value(table) => table,
        };
        let known = |value: Option<f64>| value.map_or(Written::Absent, |value| Written::Value((value, Spread::NONE)));
        PartialRotor {
            max_thrust: known(Some(table.max_thrust())),
            torque_per_thrust: known(table.torque_per_thrust()),
            max_speed: known(table.max_speed()),
            has_table: true,
            estimated_torque: table.estimated_torque_per_thrust(),
            ..Self::default()
        }
    }

    /// Warns of properties that differ from those of a table beside them.
    pub fn compare<'a>(&self, cx: &mut Context<'a>, fields: &Fields<'a>, table: &RotorTable) {
        // Full thrust is b w_max^2, and the torque per thrust d/b, with the table's speed and coefficient.
        let square = table.max_speed().map(|speed| speed * speed);
        let coefficient = square.map(|square| table.max_thrust() / square);
        let scaled = |known: Written<Known>, factor: Option<f64>| {
            known.value().zip(factor).map(|((value, spread), factor)| (value * factor, spread))
        };
        let written = [
            (&table::MAX_THRUST, &table::MAX_THRUST, self.max_thrust.value()),
            (&table::THRUST_COEFFICIENT, &table::MAX_THRUST, scaled(self.thrust_coefficient, square)),
            (&table::TORQUE_PER_THRUST, &table::TORQUE_PER_THRUST, self.torque_per_thrust.value()),
            (
                &table::DRAG_COEFFICIENT,
                &table::TORQUE_PER_THRUST,
                scaled(self.drag_coefficient, coefficient.map(f64::recip)),
            ),
            (&table::MAX_SPEED, &table::MAX_SPEED, self.max_speed.value()),
        ];
        for (field, entry, value) in written {
            if let Some((value, spread)) = value {
                table.compare(cx, fields, field, entry, value, spread);
            }
        }
    }

    /// These properties, completed by `base`; a thrust or torque in one form replaces the other form.
    pub fn over(&self, base: &PartialRotor) -> PartialRotor {
        let thrust = !self.thrust_coefficient.is_absent() || !self.max_thrust.is_absent();
        let torque = !self.drag_coefficient.is_absent() || !self.torque_per_thrust.is_absent();
        PartialRotor {
            thrust_coefficient: if thrust { self.thrust_coefficient } else { base.thrust_coefficient },
            max_thrust: if thrust { self.max_thrust } else { base.max_thrust },
            drag_coefficient: if torque { self.drag_coefficient } else { base.drag_coefficient },
            torque_per_thrust: if torque { self.torque_per_thrust } else { base.torque_per_thrust },
            lowest: self.lowest.or(base.lowest),
            max_speed: self.max_speed.or(base.max_speed),
            time_constant: self.time_constant.or(base.time_constant),
            inertia: self.inertia.or(base.inertia),
            has_table: self.has_table || base.has_table,
            estimated_torque: self.estimated_torque.or(base.estimated_torque),
        }
    }

    /// Reports what these properties, which all rotors share, lack or contradict.
    pub fn check<'a>(&self, cx: &mut Context<'a>, fields: &Fields<'a>) {
        let anywhere = Mount { position: [0.0; 3], spin: Spin::P, motor: None, own: None };
        self.rotor(cx, &anywhere, Some(fields), &mut false);
    }

    /// What is neither written nor in a table.
    fn missing(&self) -> Vec<Missing> {
        let alone = |what, example: &str| {
            let help = match self.has_table {
                false => format!("add `{example}`"),
                true => format!("its table has no such column; add `{example}`, with a value of your own"),
            };
            Missing { what, example: example.to_string(), help }
        };
        let mut missing = Vec::new();
        if self.max_speed.is_absent() {
            missing.push(alone("`max_speed`", "max_speed = 800 rad/s"));
        }
        if self.thrust_coefficient.is_absent() && self.max_thrust.is_absent() {
            missing.push(alone("`thrust_coefficient` or `max_thrust`", "thrust_coefficient = 9e-6 N*s^2/rad^2"));
        }
        if self.drag_coefficient.is_absent() && self.torque_per_thrust.is_absent() {
            let what = "`drag_coefficient` or `torque_per_thrust`";
            missing.push(match self.estimated_torque {
                None => alone(what, "drag_coefficient = 1.5e-7 N*m*s^2/rad^2"),
                Some((value, spread)) => {
                    let example = estimate(value, spread);
                    let help = format!(
                        "its table has no torque; add `{example}`, an estimate by its electrical power for motors of \
                         usual efficiency"
                    );
                    Missing { what, example, help }
                }
            });
        }
        missing
    }

    fn rotor<'a>(
        &self,
        cx: &mut Context<'a>,
        mount: &Mount<'a>,
        owner: Option<&Fields<'a>>,
        reported: &mut bool,
    ) -> Option<Rotor> {
        let missing = self.missing();
        if !missing.is_empty() {
            if let Some(owner) = owner.filter(|_| !*reported) {
                missing.iter().for_each(|Missing { what, example, help }| owner.missing_or(cx, what, example, help));
                *reported = true;
            }
            return None;
        }
        let (max_speed, of_speed) = self.max_speed.value()?;
        let (square, slowest) = (of_speed.times(of_speed), of_speed.low);
        // Full thrust is b w_max^2: where the spec gives the thrust, b follows from it.
        let (thrust_coefficient, full_thrust, of_coefficient) = match self.thrust_coefficient.optional().ok()? {
            Some((b, spread)) => (b, spread.times(square), spread),
            None => {
                let (thrust, spread) = self.max_thrust.value()?;
                (thrust / (max_speed * max_speed), spread, spread.over(square))
            }
        };
        let (drag_coefficient, torque_per_thrust) = match self.drag_coefficient.optional().ok()? {
            Some((d, spread)) => (d, spread.over(of_coefficient)),
            None => {
                let (ratio, spread) = self.torque_per_thrust.value()?;
                (ratio * thrust_coefficient, spread)
            }
        };
        let spread = RotorSpread { full_thrust, idle_thrust: of_coefficient, torque_per_thrust };
        let min_speed = match self.lowest.optional().ok()? {
            Some((lowest, span)) => {
                let speed = lowest.speed(thrust_coefficient, max_speed);
                if let Some(error) = out_of_range(lowest, speed, max_speed * slowest, thrust_coefficient, span) {
                    if !*reported {
                        *reported = true;
                        cx.report(error);
                    }
                    return None;
                }
                speed.max(-max_speed)
            }
            None => 0.0,
        };
        let time_constant = self.time_constant.optional().ok()?;
        let (inertia, inertia_spread) = self.inertia.or_default(|| (0.0, Spread::NONE))?;
        Some(Rotor {
            position: mount.position,
            spin: mount.spin,
            thrust_coefficient,
            drag_coefficient,
            min_speed,
            max_speed,
            time_constant,
            inertia,
            inertia_spread,
            motor: mount.motor,
            spread,
        })
    }
}

/// A property that a rotor lacks.
struct Missing {
    what: &'static str,
    /// How it may be written.
    example: String,
    help: String,
}

/// The field of an estimated torque per thrust (m), with its interval.
fn estimate(value: f64, spread: Spread) -> String {
    format!(
        "torque_per_thrust = {} mm +- {} %",
        significant(1e3 * value, 2),
        significant(100.0 * (spread.high - 1.0), 2)
    )
}

/// A field that is not written is faulty where a mistake may have been meant for it.
fn meant<T>(fields: &Fields, name: &str, written: Written<T>) -> Written<T> {
    if written.is_absent() && fields.may_have(name) { Written::Faulty } else { written }
}

/// `-4 N` or `-60 %`; a number without a unit is a share, of which the range then says more.
fn lowest_thrust<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<Lowest> {
    let due = Expected::of(&table::MIN_THRUST);
    cx.expect_unit(due, expr);
    let found = cx.evaluate_quantity(expr)?;
    if found.dimension == Dimension::PLAIN {
        return cx.lower(Expected::new(table::MIN_THRUST.name, "1"), found, expr).map(Lowest::Share);
    }
    cx.lower(due, found, expr).map(Lowest::Thrust)
}

/// Room for the rounding of a speed from a thrust.
const ROUNDING: f64 = 1e-12;

/// The error for a lowest speed (rad/s) that is not below the full speed, or turns backwards faster than forwards.
fn out_of_range(lowest: Lowest, speed: f64, full: f64, thrust_coefficient: f64, at: Span) -> Option<Diagnostic> {
    let is_too_low = speed < -full * (1.0 + ROUNDING);
    if !is_too_low && speed < full * (1.0 - ROUNDING) {
        return None;
    }
    let full_thrust = thrust_coefficient * full * full;
    let (field, most, unit, value, limit) = match lowest {
        Lowest::Speed(speed) => ("min_speed", "`max_speed`", "rad/s", speed, full),
        Lowest::Thrust(thrust) => ("min_thrust", "the thrust at full speed", "N", thrust, full_thrust),
        Lowest::Share(share) => ("min_thrust", "the thrust at full speed", "%", 100.0 * share, 100.0),
    };
    let (message, here, help) = match is_too_low {
        true => (
            format!("`{field}` must be at least minus {most}"),
            format!("{} {unit}, below {} {unit}", number(value), number(-limit)),
            "write a value nearer to zero: a rotor reverses at most as fast as it turns forwards".to_string(),
        ),
        false => (
            format!("`{field}` must be below {most}"),
            format!("{} {unit}, not below {} {unit}", number(value), number(limit)),
            format!("write a lower value, or remove `{field}` for a rotor that may stop"),
        ),
    };
    let error = Diagnostic::error(MIN_SPEED, at, message).here(here);
    Some(match lowest {
        Lowest::Share(_) => error.help(format!("{help}; newtons have their unit, as in `2 N`")),
        _ => error.help(help),
    })
}
