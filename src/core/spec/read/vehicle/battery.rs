//! The `battery` block: reads it, and gives the rotors the full thrust that is left at the lowest charge.

use super::POSITIVE;
use super::rotor::MIN_SPEED;
use crate::diagnostic::Diagnostic;
use crate::language::table::battery as table;
use crate::language::{Entry, Group};
use crate::model::{Battery, DefaultUsed, Rotor, Vehicle};
use crate::number::{number, percent, significant};
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;
use crate::syntax::ast::{Block, Statement};

const CODE: &str = "mavc::vehicle::battery";

/// A battery with the places of its fields.
pub(super) struct Read<'a> {
    pub battery: Battery,
    pub fields: Fields<'a>,
}

/// Reads the block; `None` if it has errors. Notes the defaults that it uses.
pub(super) fn read<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    owner: &str,
    defaults: &mut Vec<DefaultUsed>,
) -> Option<Read<'a>> {
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, format!("`battery` of {owner}"), span, &block.body, Group::Battery);
    let mut own = |entry: &'static Entry, example: &str| {
        fields.demand_own(cx, entry.name, example).and_then(|expr| cx.quantity(entry, expr, POSITIVE))
    };
    let capacity = own(&table::CAPACITY, "capacity = 5 A*h");
    let voltage = own(&table::VOLTAGE, "voltage = 22.2 V");
    let hover_power = own(&table::HOVER_POWER, "hover_power = 220 W");
    let mut share = |entry: &'static Entry, is_allowed: fn(f64) -> bool, rule: &str, help: &str| {
        let Some(expr) = fields.get(entry.name) else {
            if !fields.may_have(entry.name) {
                defaults.push(DefaultUsed::of("vehicle.battery", entry));
            }
            return Some(entry.value());
        };
        let value = cx.share(&format!("`{}`", entry.name), expr, CODE)?;
        if !is_allowed(value) {
            let error = Diagnostic::error(CODE, expr.span, format!("`{}` must be {rule}", entry.name));
            cx.report(error.here(format!("this is {}", percent(value))).help(help));
            return None;
        }
        Some(value)
    };
    let keep =
        share(&table::KEEP, |x| x < 1.0, "below 100 %", "write the share that a plan should leave, as in `20 %`");
    let help = "write full thrust with an empty battery as a share of that with a full one, as in `75 %`";
    let thrust_at_empty = share(&table::THRUST_AT_EMPTY, |x| x > 0.0, "above 0 %", help);
    let is_whole = !block.body.iter().any(|s| matches!(s, Statement::Broken(_)));
    let (capacity, voltage, hover_power) = (capacity?, voltage?, hover_power?);
    let (keep, thrust_at_empty) = (keep?, thrust_at_empty?);
    let battery = Battery { capacity, voltage, hover_power, keep, thrust_at_empty, span };
    is_whole.then_some(Read { battery, fields })
}

/// Lowers the full speed of every rotor to that at the charge `keep`; whether the vehicle can still hover there, which
/// is reported otherwise. The thrust coefficient of a rotor does not depend on the voltage, so full thrust falls with
/// the square of full speed.
pub(super) fn lower_full_thrust(cx: &mut Context, vehicle: &mut Vehicle, thrust_at_empty: Span) -> bool {
    let Some(share) = vehicle.battery.as_ref().map(Battery::lowest_full_thrust).filter(|share| *share < 1.0) else {
        return true;
    };
    let lift = |vehicle: &Vehicle| vehicle.rotors.iter().map(Rotor::max_thrust).sum::<f64>();
    let (weight, full) = (vehicle.mass * cx.gravity, lift(vehicle));
    vehicle.rotors.iter_mut().for_each(|rotor| rotor.max_speed *= share.sqrt());
    let slowest = |rotor: &&Rotor| rotor.min_speed >= rotor.max_speed * (rotor.spread.full_thrust.low).sqrt();
    if let Some(rotor) = vehicle.rotors.iter().find(slowest) {
        let message = "`min_speed` must be below full speed at the charge `keep`";
        let here = format!("{} rad/s, not below {} rad/s", number(rotor.min_speed), number(rotor.max_speed));
        let error = Diagnostic::error(MIN_SPEED, thrust_at_empty, message).here(here);
        cx.report(error.help("write a larger `keep`, or a lower `min_speed`"));
        return false;
    }
    // Without the battery it is too heavy as well, and that is reported.
    if lift(vehicle) > weight || full <= weight {
        return true;
    }
    let message = format!(
        "vehicle `{}` cannot hover at the end of a plan: it weighs {} N, but with the charge `keep` its rotors lift \
         only {} N",
        vehicle.name,
        number(weight),
        significant(lift(vehicle), 3)
    );
    let error = Diagnostic::error("mavc::vehicle::too_heavy", thrust_at_empty, message);
    let error = error.here(format!("leaves {} of full thrust at that charge", percent(share)));
    cx.report(error.also(vehicle.mass_span, "too heavy for it").help("write a larger `keep`, or a lower mass"));
    false
}
