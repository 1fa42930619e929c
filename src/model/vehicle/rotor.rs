//! The properties of rotors: those given for all, and those given for one.

use super::{POSITIVE, Place};
use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::language::table::rotor as table;
use crate::model::context::Context;
use crate::model::due::Due;
use crate::model::fields::Fields;
use crate::model::sense::WrittenRotor;
use crate::model::{Rotor, RotorSpread, Spin, Spread};
use crate::number::number;
use crate::source::Span;

pub(super) const MIN_SPEED: &str = "mavc::vehicle::min_speed";

/// Every rotor with its thrust, torque and speed: its own clauses override the `rotor` block.
pub(super) fn give_all<'a>(
    cx: &mut Context<'a>,
    places: Vec<Place<'a>>,
    shared: Option<&Fields<'a>>,
    base: Option<Traits>,
) -> Option<Vec<Rotor>> {
    let mut rotors = Some(Vec::new());
    let mut reported = false;
    for place in &places {
        let own = place.own.as_ref().map(|fields| Traits::read(cx, fields));
        let traits = match (&own, &base) {
            (Some(own), Some(base)) => own.over(base),
            (Some(own), None) => own.clone(),
            (None, Some(base)) => base.clone(),
            (None, None) => return None,
        };
        let owner = shared.filter(|_| own.is_none()).or(place.own.as_ref()).or(shared);
        match (&mut rotors, traits.rotor(cx, place, owner, &mut reported)) {
            (Some(list), Some(rotor)) => list.push(rotor),
            (list, _) => *list = None,
        }
        if rotors.is_none() && place.own.is_none() {
            return None;
        }
    }
    rotors
}

/// Where each rotor's numbers are written: in its own clauses, or else in the `rotor` block. `fields` are those of the
/// vehicle, which give the arm of a ring.
pub(super) fn written(places: &[Place], fields: &Fields, shared: Option<&Fields>) -> Vec<WrittenRotor> {
    let one = |place: &Place| {
        let blocks = [place.own.as_ref(), shared, Some(fields)];
        let of = |names: &[&str]| {
            let found = blocks.iter().flatten().find_map(|block| names.iter().find_map(|name| block.span_of(name)));
            found.unwrap_or(fields.span)
        };
        WrittenRotor {
            place: of(&["at", "arm"]),
            thrust: of(&["thrust_coefficient", "max_thrust"]),
            torque: of(&["drag_coefficient", "torque_per_thrust"]),
            min_speed: of(&["min_speed"]),
            max_speed: of(&["max_speed"]),
            time_constant: of(&["time_constant"]),
        }
    };
    places.iter().map(one).collect()
}

/// A number and how well it is known.
type Known = (f64, Spread);

/// The properties written for a rotor. `Some(None)` is a value with an error.
#[derive(Clone, Default)]
pub(super) struct Traits {
    thrust_coefficient: Option<Option<Known>>,
    max_thrust: Option<Option<Known>>,
    drag_coefficient: Option<Option<Known>>,
    torque_per_thrust: Option<Option<Known>>,
    min_speed: Option<Option<(f64, Span)>>,
    max_speed: Option<Option<Known>>,
    time_constant: Option<Option<f64>>,
    inertia: Option<Option<f64>>,
}

impl Traits {
    pub fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Self {
        let mut take = |entry: &'static Entry, coefficient: bool| {
            let due = Due { coefficient, ..Due::of(entry) };
            match fields.get(entry.name) {
                Some(expr) => Some(cx.interval(due, expr, POSITIVE)),
                None => fields.may_have(entry.name).then_some(None),
            }
        };
        let traits = Traits {
            thrust_coefficient: take(&table::THRUST_COEFFICIENT, true),
            max_thrust: take(&table::MAX_THRUST, false),
            drag_coefficient: take(&table::DRAG_COEFFICIENT, true),
            torque_per_thrust: take(&table::TORQUE_PER_THRUST, false),
            max_speed: take(&table::MAX_SPEED, false),
            time_constant: match fields.get("time_constant") {
                Some(expr) => Some(cx.quantity(&table::TIME_CONSTANT, expr, POSITIVE)),
                None => fields.may_have("time_constant").then_some(None),
            },
            inertia: match fields.get("rotor_inertia") {
                Some(expr) => Some(cx.quantity(&table::ROTOR_INERTIA, expr, POSITIVE)),
                None => fields.may_have("rotor_inertia").then_some(None),
            },
            min_speed: match fields.get("min_speed") {
                Some(expr) => Some(cx.quantity(&table::MIN_SPEED, expr, MIN_SPEED).map(|w| (w, expr.span))),
                None => fields.may_have("min_speed").then_some(None),
            },
        };
        for (a, b) in [("thrust_coefficient", "max_thrust"), ("drag_coefficient", "torque_per_thrust")] {
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
        traits
    }

    /// These properties, completed by `base`; a thrust or torque in one form replaces the other form.
    fn over(&self, base: &Traits) -> Traits {
        let thrust = self.thrust_coefficient.is_some() || self.max_thrust.is_some();
        let torque = self.drag_coefficient.is_some() || self.torque_per_thrust.is_some();
        Traits {
            thrust_coefficient: if thrust { self.thrust_coefficient } else { base.thrust_coefficient },
            max_thrust: if thrust { self.max_thrust } else { base.max_thrust },
            drag_coefficient: if torque { self.drag_coefficient } else { base.drag_coefficient },
            torque_per_thrust: if torque { self.torque_per_thrust } else { base.torque_per_thrust },
            min_speed: self.min_speed.or(base.min_speed),
            max_speed: self.max_speed.or(base.max_speed),
            time_constant: self.time_constant.or(base.time_constant),
            inertia: self.inertia.or(base.inertia),
        }
    }

    /// Reports what these traits, which all rotors share, lack or contradict.
    pub fn check<'a>(&self, cx: &mut Context<'a>, fields: &Fields<'a>) {
        let anywhere = Place { position: [0.0; 3], spin: Spin::P, own: None };
        self.rotor(cx, &anywhere, Some(fields), &mut false);
    }

    fn rotor<'a>(
        &self,
        cx: &mut Context<'a>,
        place: &Place<'a>,
        owner: Option<&Fields<'a>>,
        reported: &mut bool,
    ) -> Option<Rotor> {
        let mut missing = Vec::new();
        if self.max_speed.is_none() {
            missing.push(("`max_speed`", "max_speed = 800 rad/s"));
        }
        if self.thrust_coefficient.is_none() && self.max_thrust.is_none() {
            missing.push(("`thrust_coefficient` or `max_thrust`", "thrust_coefficient = 9e-6 N*s^2/rad^2"));
        }
        if self.drag_coefficient.is_none() && self.torque_per_thrust.is_none() {
            missing.push(("`drag_coefficient` or `torque_per_thrust`", "drag_coefficient = 1.5e-7 N*m*s^2/rad^2"));
        }
        if !missing.is_empty() {
            if let Some(owner) = owner.filter(|_| !*reported) {
                missing.iter().for_each(|(what, example)| owner.missing(cx, what, example));
                *reported = true;
            }
            return None;
        }
        let (max_speed, of_speed) = self.max_speed??;
        let (square, slowest) = (of_speed.times(of_speed), of_speed.low);
        // Full thrust is b w_max^2: where the spec gives the thrust, b follows from it.
        let (thrust_coefficient, full_thrust, of_coefficient) = match self.thrust_coefficient {
            Some(given) => {
                let (b, spread) = given?;
                (b, spread.times(square), spread)
            }
            None => {
                let (thrust, spread) = self.max_thrust??;
                (thrust / (max_speed * max_speed), spread, spread.over(square))
            }
        };
        let (drag_coefficient, torque_per_thrust) = match self.drag_coefficient {
            Some(given) => {
                let (d, spread) = given?;
                (d, spread.over(of_coefficient))
            }
            None => {
                let (ratio, spread) = self.torque_per_thrust??;
                (ratio * thrust_coefficient, spread)
            }
        };
        let spread = RotorSpread { full_thrust, idle_thrust: of_coefficient, torque_per_thrust };
        let min_speed = match self.min_speed {
            Some(given) => {
                let (speed, span) = given?;
                if speed < -max_speed * slowest {
                    if !*reported {
                        *reported = true;
                        cx.report(too_fast_backwards(speed, max_speed * slowest, span));
                    }
                    return None;
                }
                if speed >= max_speed * slowest {
                    if !*reported {
                        *reported = true;
                        cx.report(not_below(speed, max_speed * slowest, span));
                    }
                    return None;
                }
                speed
            }
            None => 0.0,
        };
        let time_constant = match self.time_constant {
            Some(given) => Some(given?),
            None => None,
        };
        let inertia = match self.inertia {
            Some(given) => given?,
            None => 0.0,
        };
        Some(Rotor {
            position: place.position,
            spin: place.spin,
            thrust_coefficient,
            drag_coefficient,
            min_speed,
            max_speed,
            time_constant,
            inertia,
            spread,
        })
    }
}

/// The error for a rotor whose lowest speed is not below its full speed.
fn not_below(min_speed: f64, max_speed: f64, at: Span) -> Diagnostic {
    let message = "`min_speed` must be below `max_speed`";
    Diagnostic::error(MIN_SPEED, at, message)
        .here(format!("{} rad/s, not below {} rad/s", number(min_speed), number(max_speed)))
        .help("write a lower speed, or remove `min_speed` for a rotor that may stop")
}

/// The error for a rotor that turns backwards faster than forwards.
fn too_fast_backwards(min_speed: f64, max_speed: f64, at: Span) -> Diagnostic {
    let message = "`min_speed` must be at least `-max_speed`";
    Diagnostic::error(MIN_SPEED, at, message)
        .here(format!("{} rad/s, below {} rad/s", number(min_speed), number(-max_speed)))
        .help("write a speed nearer to zero: a rotor reverses at most as fast as it turns forwards")
}
