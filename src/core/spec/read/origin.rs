//! `origin_latitude`, `origin_longitude` and `origin_altitude` of a mission.

use super::context::Context;
use super::fields::Fields;
use super::written::Written;
use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::language::table::mission as table;
use crate::model::Origin;
use crate::number::number;

const CODE: &str = "mavc::mission::origin";

const FIELDS: [&Entry; 3] = [&table::ORIGIN_LATITUDE, &table::ORIGIN_LONGITUDE, &table::ORIGIN_ALTITUDE];

/// The lowest and highest `origin_altitude`, m: below the deepest mine, above the highest mountain.
const ALTITUDES: (f64, f64) = (-5000.0, 10_000.0);

/// The origin of a mission.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Written<Origin> {
    let given = FIELDS.map(|entry| fields.get(entry.name));
    let Some(first) = given.iter().flatten().next() else { return Written::Absent };
    if let Some(missing) = FIELDS.iter().zip(given).find(|(_, expr)| expr.is_none()).map(|(entry, _)| entry.name) {
        let error = Diagnostic::error(CODE, first.span, format!("the origin of the mission needs `{missing}` too"));
        let error = error.here("one of three fields of the origin");
        cx.report(error.help("give `origin_latitude`, `origin_longitude` and `origin_altitude`, or none of them"));
        return Written::Faulty;
    }
    let quarter = std::f64::consts::FRAC_PI_2;
    let bounds = [(-quarter, quarter), (-2.0 * quarter, 2.0 * quarter), ALTITUDES];
    let mut values = [None; 3];
    for (k, (entry, expr)) in FIELDS.into_iter().zip(given).enumerate() {
        let Some(expr) = expr else { continue };
        let Some(value) = cx.quantity(entry, expr, CODE) else { continue };
        let (low, high) = bounds[k];
        if (low..=high).contains(&value) {
            values[k] = Some(value);
            continue;
        }
        let shown = |x: f64| if k < 2 { format!("{} deg", number(x.to_degrees())) } else { format!("{} m", number(x)) };
        let message = format!("`{}` must be between {} and {}", entry.name, shown(low), shown(high));
        let error = Diagnostic::error(CODE, expr.span, message).here(format!("this is {}", shown(value)));
        cx.report(error.help("write the place as a map gives it: `origin_latitude = 47.397742 deg`"));
    }
    let [Some(latitude), Some(longitude), Some(altitude)] = values else { return Written::Faulty };
    Written::Value(Origin { latitude, longitude, altitude })
}
