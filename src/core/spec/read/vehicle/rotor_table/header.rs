//! The header of a thrust table: which column is what, and in which unit.

use super::CODE;
use crate::diagnostic::Diagnostic;
use crate::read::context::listed;
use crate::read::csv_rows::Row;
use crate::source::visible;
use crate::unit::{Dimension, Unit, parse_unit};

/// What a column gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Throttle,
    Thrust,
    Torque,
    Speed,
    Current,
    Voltage,
    Power,
}

/// The spellings of a column in lower case, and the units of usual headers that are not the language's, each with the
/// language's.
struct Spelling {
    kind: Kind,
    /// The word for messages, and the SI unit.
    title: &'static str,
    unit: &'static str,
    names: &'static [&'static str],
    units: &'static [(&'static str, &'static str)],
}

const SPELLINGS: [Spelling; Kind::ALL.len()] = [
    Spelling {
        kind: Kind::Throttle,
        title: "throttle",
        unit: "1",
        names: &["throttle", "throttle range", "throttle position"],
        units: &[],
    },
    Spelling {
        kind: Kind::Thrust,
        title: "thrust",
        unit: "N",
        names: &["thrust", "static thrust", "thrust force", "thrust output", "pull", "pull force", "lift"],
        // Scales show the mass that weighs as much.
        units: &[("g", "gf"), ("gr", "gf"), ("gram", "gf"), ("kg", "kgf"), ("lb", "lbf"), ("lbs", "lbf")],
    },
    Spelling {
        kind: Kind::Torque,
        title: "torque",
        unit: "N*m",
        names: &["torque", "motor torque", "propeller torque"],
        units: &[
            ("nm", "N*m"),
            ("mnm", "mN*m"),
            ("ncm", "N*cm"),
            ("kgcm", "kgf*cm"),
            ("kg*cm", "kgf*cm"),
            ("gcm", "gf*cm"),
            ("g*cm", "gf*cm"),
        ],
    },
    Spelling {
        kind: Kind::Speed,
        title: "speed",
        unit: "rad/s",
        names: &[
            "rpm",
            "speed",
            "motor speed",
            "rotor speed",
            "propeller speed",
            "rotation speed",
            "rotational speed",
            "rotating speed",
            "angular speed",
            "motor optical speed",
        ],
        units: &[("r/min", "rpm"), ("1/min", "rpm"), ("min^-1", "rpm"), ("rps", "rev/s"), ("1/s", "rev/s")],
    },
    Spelling {
        kind: Kind::Current,
        title: "current",
        unit: "A",
        names: &["current", "amps", "amperage", "motor current", "input current"],
        units: &[],
    },
    Spelling {
        kind: Kind::Voltage,
        title: "voltage",
        unit: "V",
        names: &["voltage", "volts", "input voltage"],
        units: &[],
    },
    Spelling {
        kind: Kind::Power,
        title: "power",
        unit: "W",
        names: &["power", "watts", "electrical power", "electric power", "input power", "power input"],
        units: &[],
    },
];

/// The acceleration that makes a weight of what a scale shows, whatever the gravity of the spec: makers measure on
/// Earth. m/s^2
const STANDARD_GRAVITY: f64 = 9.80665;

impl Kind {
    pub const ALL: [Kind; 7] =
        [Kind::Throttle, Kind::Thrust, Kind::Torque, Kind::Speed, Kind::Current, Kind::Voltage, Kind::Power];

    fn spelling(self) -> &'static Spelling {
        &SPELLINGS[self as usize]
    }

    /// Its word for messages.
    pub fn title(self) -> &'static str {
        self.spelling().title
    }

    /// The SI unit, `1` for a share.
    pub fn unit(self) -> &'static str {
        self.spelling().unit
    }
}

/// A column of the table that is used.
#[derive(Debug)]
pub(super) struct Column {
    pub kind: Kind,
    /// The cell of each row.
    pub index: usize,
    pub unit: Unit,
}

/// Whether the line below a header gives the units of its columns, as in `Thrust,RPM` above `g,1/min`: it has no
/// number, and a unit of at least one column that the header names.
pub(super) fn is_of_units(header: &Row, below: &Row, separator: u8) -> bool {
    let is_unit = |(name, cell): (&str, &str)| {
        recognised(name).is_some_and(|(kind, _)| bare(cell).is_some_and(|text| unit(kind, text).is_some()))
    };
    !has_number(below, separator) && header.record.iter().zip(&below.record).any(is_unit)
}

fn has_number(row: &Row, separator: u8) -> bool {
    row.record.iter().any(|cell| super::cell::number(cell, separator).is_ok())
}

/// The unit in a cell, `g`, `(g)` or `[g]`; `None` for a column without one, which is empty or a dash.
fn bare(cell: &str) -> Option<&str> {
    let inner = cell.strip_prefix(['(', '[', '（']).and_then(|rest| rest.strip_suffix([')', ']', '）']));
    Some(inner.unwrap_or(cell).trim()).filter(|text| !matches!(*text, "" | "-" | "/" | "—" | "–"))
}

/// The columns that a header names, with the units of the line below it if it has one; those that it does not know are
/// left out.
pub(super) fn columns(row: &Row, units: Option<&Row>, separator: u8) -> Result<Vec<Column>, Box<Diagnostic>> {
    let fail_whole = |message: String| Diagnostic::error(CODE, row.span, message).here("the header");
    if row.record.len() == 1 && row.record[0].contains('\t') {
        let error = fail_whole("the cells of a table must be separated by commas or semicolons".into());
        return Err(Box::new(error.help("save it as `CSV, comma delimited`, with decimal points")));
    }
    let mut columns: Vec<Column> = Vec::new();
    for (index, (cell, &span)) in row.record.iter().zip(&row.cells).enumerate() {
        let Some((kind, written)) = recognised(cell) else { continue };
        let title = kind.title();
        if let Some(first) = columns.iter().find(|column| column.kind == kind) {
            let error = Diagnostic::error(CODE, span, format!("two columns give the {title}")).here("this column");
            let error = error.also(row.cells[first.index], "the other");
            return Err(Box::new(error.help("remove one of them")));
        }
        let example = if kind == Kind::Speed { "RPM".to_string() } else { example(kind) };
        let below = units.and_then(|units| Some((bare(&units.record[index])?, units.cells[index])));
        let (unit_of_name, unit_below) = (written, below.map(|(text, _)| text));
        let span = if written.is_none() { below.map_or(span, |(_, span)| span) } else { span };
        let fail = |message: String| Diagnostic::error(CODE, span, message).here("this column");
        let unit = match unit_of_name.or(unit_below) {
            // Percent, microseconds or steps: only the order of the throttles is used.
            _ if kind == Kind::Throttle => Unit { numerator: 1.0, denominator: 1.0, dimension: Dimension::PLAIN },
            Some(text) => unit(kind, text).ok_or_else(|| {
                let error = fail(format!("`{}` is not a unit of the {title}", visible::line(text)));
                Box::new(error.help(match unit_of_name {
                    Some(_) => format!("write a unit in parentheses, as in `{example}`"),
                    None => format!("write a unit such as `{}`", if kind == Kind::Speed { "RPM" } else { kind.unit() }),
                }))
            })?,
            None => {
                let error = fail(format!("the column of the {title} needs a unit"));
                return Err(Box::new(
                    error.help(format!("write `{example}`, or the units in the line below the names")),
                ));
            }
        };
        let factor = |unit: Unit| unit.numerator / unit.denominator;
        if let (Some(_), Some((text, below))) = (unit_of_name, below)
            && kind != Kind::Throttle
            && self::unit(kind, text).map(factor) != Some(factor(unit))
        {
            let error = Diagnostic::error(CODE, below, format!("the column of the {title} has two units"));
            let error = error.here("another unit").also(row.cells[index], "the unit in its name");
            return Err(Box::new(error.help("keep one of them")));
        }
        columns.push(Column { kind, index, unit });
    }
    if columns.iter().any(|column| column.kind == Kind::Thrust) {
        return Ok(columns);
    }
    let error = match has_number(row, separator) {
        true => fail_whole("the first line of a thrust table must name its columns".into())
            .help("put a line such as `Thrust (g),RPM,Torque (N*m),Power (W)` above it"),
        false => {
            let titles: Vec<&str> = Kind::ALL.iter().map(|kind| kind.title()).collect();
            fail_whole("the table has no column of the thrust".into())
                .help(format!("name it `Thrust (g)` or `Thrust (N)`; mavc knows the columns {}", listed(&titles)))
        }
    };
    Err(Box::new(error))
}

fn example(kind: Kind) -> String {
    let Spelling { title, unit, .. } = kind.spelling();
    let (first, rest) = title.split_at(1);
    format!("{}{rest} ({unit})", first.to_uppercase())
}

/// What a column gives, and its unit as written: `Thrust (g)`, `thrust [N]`, `thrust_g`, `Thrust / g`, `RPM`.
fn recognised(cell: &str) -> Option<(Kind, Option<&str>)> {
    let (name, unit) = match cell.strip_suffix([')', ']']).and_then(|rest| rest.rsplit_once(['(', '[', '（'])) {
        Some((name, unit)) => (name, Some(unit.trim())),
        None => (cell, None),
    };
    let known = |name: &str| {
        let words: Vec<&str> = name.split([' ', '_', '-']).filter(|word| !word.is_empty()).collect();
        let name = words.join(" ").to_lowercase();
        SPELLINGS.iter().find(|spelling| spelling.names.contains(&name.as_str()))
    };
    if let Some(spelling) = known(name) {
        // `RPM` is the name of a speed and its unit.
        let of_name = (name.trim().eq_ignore_ascii_case("rpm")).then_some("rpm");
        return Some((spelling.kind, unit.filter(|unit| !unit.is_empty()).or(of_name)));
    }
    let separators: &[char] = &[' ', '/', ','];
    let parts = cell.rsplit_once(['_', ',', ' ']).into_iter().chain(cell.split_once('/'));
    parts.into_iter().find_map(|(name, unit)| {
        let spelling = known(name.trim_end_matches(separators))?;
        Some((spelling.kind, Some(unit.trim_start_matches(separators))))
    })
}

/// The unit that a header means, if it is one of the column.
fn unit(kind: Kind, text: &str) -> Option<Unit> {
    let text: String = text.chars().filter(|c| *c != ' ').collect();
    // Multiplication signs of usual spellings: `N.m`, `N-m`, `N⋅m`.
    let mut text = text.replace(['.', '⋅', '•', '×', '∙'], "*");
    if !text.contains('^') {
        text = text.replace('-', "*");
    }
    let lower = text.to_lowercase();
    let spelling = kind.spelling();
    let own = spelling.units.iter().find(|(written, _)| *written == lower);
    let due = parse_unit(spelling.unit, STANDARD_GRAVITY).ok()?.dimension;
    let names = [own.map_or(text.as_str(), |(_, ours)| ours), lower.as_str()];
    // Capitals are a habit of headers: `RPM`, `KG`; a unit as written goes first, because `M` is not `m`.
    names.iter().filter_map(|name| parse_unit(name, STANDARD_GRAVITY).ok()).find(|unit| unit.dimension == due)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_headers_are_recognised() {
        let of = |cell: &str| {
            let (kind, text) = recognised(cell)?;
            let factor = text.map(|text| unit(kind, text).map(|unit| unit.numerator / unit.denominator));
            Some((kind, factor))
        };
        let gram = 9.80665e-3;
        let rpm = std::f64::consts::TAU / 60.0;
        for (cell, kind, factor) in [
            ("Throttle", Kind::Throttle, None),
            ("Thrust (g)", Kind::Thrust, Some(gram)),
            ("THRUST(G)", Kind::Thrust, Some(gram)),
            ("Thrust [kgf]", Kind::Thrust, Some(1e3 * gram)),
            ("Thrust (kg)", Kind::Thrust, Some(1e3 * gram)),
            ("Thrust (lbs)", Kind::Thrust, Some(0.45359237 * 9.80665)),
            ("thrust_N", Kind::Thrust, Some(1.0)),
            ("Pull / g", Kind::Thrust, Some(gram)),
            ("Torque (N·m)", Kind::Torque, Some(1.0)),
            ("Torque(Nm)", Kind::Torque, Some(1.0)),
            ("Torque (N.m)", Kind::Torque, Some(1.0)),
            ("Torque (mN*m)", Kind::Torque, Some(1e-3)),
            ("Torque (mNm)", Kind::Torque, Some(1e-3)),
            ("torque_N*cm", Kind::Torque, Some(1e-2)),
            ("Torque (kgf-cm)", Kind::Torque, Some(9.80665e-2)),
            ("RPM", Kind::Speed, Some(rpm)),
            ("rpm (r/min)", Kind::Speed, Some(rpm)),
            ("Rotation Speed (RPM)", Kind::Speed, Some(rpm)),
            ("speed_rad/s", Kind::Speed, Some(1.0)),
            ("Current (A)", Kind::Current, Some(1.0)),
            ("Current, mA", Kind::Current, Some(1e-3)),
            ("Voltage [V]", Kind::Voltage, Some(1.0)),
            ("Electrical Power (W)", Kind::Power, Some(1.0)),
            ("power_kW", Kind::Power, Some(1e3)),
        ] {
            let (found, unit) = of(cell).unwrap_or_else(|| panic!("{cell}"));
            assert_eq!(found, kind, "{cell}");
            match (unit, factor) {
                (None, None) => {}
                (Some(Some(unit)), Some(factor)) => assert!((unit / factor - 1.0).abs() < 1e-12, "{cell}: {unit}"),
                other => panic!("{cell}: {other:?}"),
            }
        }
    }

    #[test]
    fn other_columns_and_units_are_not() {
        for cell in ["Efficiency (g/W)", "Temperature (°C)", "Mechanical Power (W)", "Prop", "", "()", "_", "/"] {
            assert_eq!(recognised(cell), None, "{cell}");
        }
        for (kind, text) in [
            (Kind::Thrust, "W"),
            (Kind::Thrust, "mN*m"),
            (Kind::Torque, "g"),
            (Kind::Speed, "m/s"),
            (Kind::Power, ""),
            (Kind::Current, "mAh"),
            (Kind::Voltage, "^"),
        ] {
            assert_eq!(unit(kind, text), None, "{text}");
        }
    }

    #[test]
    fn the_table_of_spellings_is_in_the_order_of_the_kinds() {
        for (kind, spelling) in Kind::ALL.iter().zip(&SPELLINGS) {
            assert_eq!(*kind, spelling.kind);
        }
    }
}
