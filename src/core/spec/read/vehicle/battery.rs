//! The `battery` block: reads it, and gives the rotors the full thrust that is left at the lowest charge.

use super::POSITIVE;
use super::rotor::MIN_SPEED;
use super::rotor_table::RotorTable;
use crate::diagnostic::Diagnostic;
use crate::language::table::battery as table;
use crate::language::{Entry, Group};
use crate::model::{Battery, DefaultUsed, Rotor, Vehicle};
use crate::number::{number, percent, shortest, significant};
use crate::read::context::Context;
use crate::read::defaulted::Defaulted;
use crate::read::fields::Fields;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr};

const CODE: &str = "mavc::vehicle::battery";
const HOVER_POWER: &str = "hover_power = 220 W";

/// A battery with the places of its fields.
pub(super) struct Read<'a> {
    pub battery: Battery,
    pub fields: Defaulted<'a>,
}

/// A battery whose hover power may be that of a thrust table.
pub(super) struct Draft<'a> {
    capacity: f64,
    voltage: f64,
    /// W; `None` if the table gives it.
    hover_power: Option<f64>,
    keep: f64,
    thrust_at_empty: f64,
    span: Span,
    fields: Defaulted<'a>,
}

/// Reads the block of a vehicle, which messages call `owner`; `None` if it has errors. `table` is that of the rotors.
pub(super) fn read<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    owner: &str,
    table: &Written<RotorTable>,
) -> Option<Draft<'a>> {
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, format!("`battery` of {owner}"), span, &block.body, Group::Battery);
    let mut fields = Defaulted::new("vehicle.battery", fields);
    let capacity = demanded(cx, &fields, &table::CAPACITY, "capacity = 5 A*h");
    let voltage = demanded(cx, &fields, &table::VOLTAGE, "voltage = 22.2 V");
    let hover_power = match table {
        Written::Value(table) if table.has_power() && !fields.may_have(table::HOVER_POWER.name) => Some(None),
        // What the table would give is unknown.
        Written::Faulty if !fields.may_have(table::HOVER_POWER.name) => None,
        _ => demanded(cx, &fields, &table::HOVER_POWER, HOVER_POWER).map(Some),
    };
    let keep = fields.value_or(&table::KEEP, table::KEEP.value(), |expr| {
        let keep = cx.share("`keep`", expr, CODE)?;
        let help = "write the share that a plan should leave, as in `20 %`";
        if keep < 1.0 { Some(keep) } else { out_of_range(cx, expr, "`keep` must be below 100 %", keep, help) }
    });
    let thrust_at_empty = fields.value_or(&table::THRUST_AT_EMPTY, table::THRUST_AT_EMPTY.value(), |expr| {
        let share = cx.share("`thrust_at_empty`", expr, CODE)?;
        let help = "write full thrust with an empty battery as a share of that with a full one, as in `75 %`";
        let message = "`thrust_at_empty` must be above 0 %";
        if share > 0.0 { Some(share) } else { out_of_range(cx, expr, message, share, help) }
    });
    let (capacity, voltage, hover_power) = (capacity?, voltage?, hover_power?);
    let (keep, thrust_at_empty) = (keep?, thrust_at_empty?);
    block.is_whole().then_some(Draft { capacity, voltage, hover_power, keep, thrust_at_empty, span, fields })
}

impl<'a> Draft<'a> {
    /// The battery of a vehicle with so many rotors, each of which carries `thrust` (N) in hover; `None` if the table
    /// gives no power at this thrust, which is reported.
    pub fn finish(
        mut self,
        cx: &mut Context<'a>,
        table: &Written<RotorTable>,
        rotors: usize,
        thrust: f64,
    ) -> Option<Read<'a>> {
        let hover_power = match (self.hover_power, table) {
            (Some(power), _) => power,
            (None, Written::Value(table)) => match table.power(thrust).map(|power| power * rotors as f64) {
                Some(power) if power > 0.0 => {
                    self.fields.used.push(DefaultUsed {
                        field: "vehicle.battery.hover_power".into(),
                        value: format!("{} W", shortest(power)),
                        reason: format!(
                            "{rotors} motors at the power of `{}` for {} N each, without other electronics",
                            table.name(),
                            significant(thrust, 3)
                        ),
                    });
                    power
                }
                _ => {
                    let help = format!(
                        "in hover each rotor carries {} N, for which `{}` has no power: add `{HOVER_POWER}`, with the \
                         value of your vehicle",
                        significant(thrust, 3),
                        table.name()
                    );
                    self.fields.missing_or(cx, "`hover_power`", HOVER_POWER, &help);
                    return None;
                }
            },
            (None, _) => return None,
        };
        let Draft { capacity, voltage, keep, thrust_at_empty, span, fields, .. } = self;
        Some(Read { battery: Battery { capacity, voltage, hover_power, keep, thrust_at_empty, span }, fields })
    }
}

/// A quantity that only the user knows.
fn demanded<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, entry: &'static Entry, example: &str) -> Option<f64> {
    fields.demand_own(cx, entry.name, example).and_then(|expr| cx.quantity(entry, expr, POSITIVE))
}

/// Reports a share out of its range.
fn out_of_range(cx: &mut Context, expr: &Expr, message: &str, share: f64, help: &str) -> Option<f64> {
    let error = Diagnostic::error(CODE, expr.span, message);
    cx.report(error.here(format!("this is {}", percent(share))).help(help));
    None
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
