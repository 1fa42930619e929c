//! `vehicle` blocks: rings of rotors, and rotors placed one by one.

mod battery;
mod reverse;
mod rotor;
mod whole;

use std::f64::consts::PI;

use super::context::Context;
use super::expected::Expected;
use super::fields::Fields;
use super::plausibility::{Written, check_battery, check_vehicle};
use super::yaw_drag;
use crate::diagnostic::Diagnostic;
use crate::language::table::{placed_rotor, vehicle as table};
use crate::language::{Entry, Group};
use crate::model::{Allocation, DefaultUsed, Spin, Vehicle};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Clauses, Expr, ExprKind, Statement};

/// The allowed numbers of rotors.
pub const ROTORS: std::ops::RangeInclusive<usize> = 4..=32;

const POSITIVE: &str = "mavc::vehicle::not_positive";
const MOTOR: &str = "mavc::vehicle::motor";
const ALLOCATIONS: [Allocation; 2] = [Allocation::Bounded, Allocation::PseudoInverse];

/// What is known of a vehicle, errors or not.
pub(super) struct Outline {
    pub name: String,
    pub span: Span,
    /// The number of rotors, if it is known.
    pub rotors: Option<usize>,
    /// The vehicle, if it has no errors.
    pub vehicle: Option<Vehicle>,
    /// The defaults used for fields that are not written.
    pub defaults: Vec<DefaultUsed>,
}

pub(super) fn elaborate<'a>(cx: &mut Context<'a>, block: &'a Block) -> Outline {
    let name = block.name.as_ref().map_or("vehicle", |n| &n.value).to_string();
    let span = block.name.as_ref().map_or(block.keyword.span, |n| n.span);
    let owner = format!("vehicle `{name}`");
    let fields = Fields::of_block(cx, owner.clone(), span, &block.body, Group::Vehicle);
    let Blocks { shared, placed, battery, twice, battery_twice } = blocks(cx, block);

    let mass_expr = fields.demand_own(cx, "mass", "mass = 1.8 kg");
    let mass = mass_expr.and_then(|e| cx.interval(Expected::of(&table::MASS), e, POSITIVE));
    let inertia = fields.demand_own(cx, "inertia", "inertia = [0.04, 0.04, 0.07] kg*m^2").and_then(|e| inertia(cx, e));
    let rotor_fields =
        shared.map(|b| Fields::of_block(cx, format!("`rotor` of {owner}"), b.keyword.span, &b.body, Group::Rotor));

    let (places, count) = match placed {
        Some(placed) => {
            for field in Group::Vehicle.rivals("rotors") {
                if let Some(at) = fields.span_of(field) {
                    let message = format!("`{field}` describes a ring, but {owner} places its rotors one by one");
                    cx.report(
                        Diagnostic::error("mavc::vehicle::conflict", at, message)
                            .here("not allowed together with `rotors`")
                            .also(placed.keyword.span, "rotors are placed here")
                            .help("remove one of the two"),
                    );
                }
            }
            one_by_one(cx, placed, &owner, span)
        }
        None => ring(cx, &fields),
    };
    let base = rotor_fields.as_ref().map(|fields| rotor::PartialRotor::read(cx, fields));
    if base.is_none() && placed.is_none() && !fields.may_have("rotor") {
        let example = "rotor { max_thrust = 9 N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }";
        fields.missing(cx, "a `rotor` block", example);
    }
    let written = places.as_ref().map(|places| rotor::written(places, &fields, rotor_fields.as_ref()));
    // With a duplicate block the rotors are unknown.
    let rotors = match places {
        Some(places) if !twice => rotor::give_all(cx, places, rotor_fields.as_ref(), base),
        None if placed.is_none() => {
            // The `rotor` block holds for every rotor, wherever the rotors are.
            base.zip(rotor_fields.as_ref()).iter().for_each(|(base, fields)| base.check(cx, fields));
            None
        }
        _ => None,
    };
    let layout = match (placed, fields.get("layout").map(|e| &e.kind)) {
        (None, Some(ExprKind::Text(text))) => Some(text.clone()),
        _ => None,
    };
    let mut length =
        |entry: &'static Entry| fields.written(entry.name, |expr| cx.quantity(entry, expr, POSITIVE)).optional();
    let (propeller_radius, size) = (length(&table::PROPELLER_RADIUS), length(&table::SIZE));
    let drag = match fields.get("drag") {
        Some(expr) => cx.drag(&table::DRAG, expr, POSITIVE),
        None => Some([0.0; 3]),
    };
    let yaw_drag = yaw_drag::read(cx, &fields).optional();
    let allocation = fields.word(cx, "mavc::vehicle::allocation", &table::ALLOCATION);
    let allocation = allocation.and_then(|word| ALLOCATIONS.into_iter().find(|a| a.name() == word));
    let allocation = allocation.or_default(|| Allocation::Bounded);
    let mut defaults = match fields.may_have("allocation") {
        true => Vec::new(),
        false => vec![DefaultUsed::of("vehicle", &table::ALLOCATION)],
    };
    let read = battery.map(|block| battery::read(cx, block, &owner, &mut defaults));
    let battery_fits = !battery_twice && read.as_ref().is_none_or(Option::is_some);
    let read = read.flatten();
    let broken = block.body.iter().any(|s| matches!(s, Statement::Broken(_)));
    let lengths = propeller_radius.zip(size).zip(drag.zip(yaw_drag));
    let mut vehicle = match (mass.zip(allocation).zip(lengths), inertia, rotors, mass_expr) {
        (
            Some((((mass, mass_spread), allocation), ((propeller_radius, size), (drag, yaw_drag)))),
            Some(inertia),
            Some(rotors),
            Some(mass_expr),
        ) if !broken && battery_fits => Some(Vehicle {
            name: name.clone(),
            doc: block.doc.clone(),
            layout,
            mass,
            mass_spread,
            inertia,
            drag,
            drag_span: fields.span_of("drag"),
            yaw_drag,
            propeller_radius,
            size,
            rotors,
            allocation,
            battery: read.as_ref().map(|read| read.battery.clone()),
            span,
            mass_span: mass_expr.span,
        }),
        _ => None,
    };
    let mut vehicle_fits = true;
    if let Some(vehicle) = &mut vehicle {
        if vehicle.allocation == Allocation::PseudoInverse && vehicle.has_uncertain_rotors() {
            let message = "`allocation = pseudo_inverse` cannot be combined with intervals on rotors";
            let at = fields.span_of("allocation").unwrap_or(span);
            cx.report(
                Diagnostic::error("mavc::vehicle::conflict", at, message)
                    .here("needs exact coefficients and speeds")
                    .help("write `allocation = bounded`, or remove the intervals from the rotors; `mass` may keep one"),
            );
        }
        whole::check(cx, vehicle);
        let places = Written {
            mass: vehicle.mass_span,
            inertia: fields.span_of("inertia").unwrap_or(span),
            yaw_drag: fields.span_of("yaw_drag").unwrap_or(span),
            rotors: written.unwrap_or_default(),
        };
        match cx.has_magnitude(vehicle, |k| [places.rotors[k].thrust, places.rotors[k].torque]) {
            true => check_vehicle(cx, vehicle, &places),
            false => vehicle_fits = false,
        }
        if let Some(read) = &read {
            check_battery(cx, vehicle, &read.battery, &read.fields);
            let thrust_at_empty = read.fields.span_of("thrust_at_empty").unwrap_or(read.battery.span);
            vehicle_fits &= battery::lower_full_thrust(cx, vehicle, thrust_at_empty);
        }
        reverse::check(cx, vehicle, |k| places.rotors[k].min_speed);
    }
    let vehicle = vehicle.filter(|_| vehicle_fits);
    Outline { name, span, rotors: count, vehicle, defaults }
}

/// The blocks inside a vehicle.
struct Blocks<'a> {
    /// `rotor { }`
    shared: Option<&'a Block>,
    /// `rotors { }`
    placed: Option<&'a Block>,
    battery: Option<&'a Block>,
    /// Whether the block `rotor` or `rotors` occurs twice, or `battery` does, which is reported.
    twice: bool,
    battery_twice: bool,
}

fn blocks<'a>(cx: &mut Context<'a>, block: &'a Block) -> Blocks<'a> {
    let mut blocks = Blocks { shared: None, placed: None, battery: None, twice: false, battery_twice: false };
    for statement in &block.body {
        let Statement::Block(inner) = statement else {
            continue;
        };
        let (slot, twice) = match inner.keyword.value.as_str() {
            "rotors" => (&mut blocks.placed, &mut blocks.twice),
            "battery" => (&mut blocks.battery, &mut blocks.battery_twice),
            _ => (&mut blocks.shared, &mut blocks.twice),
        };
        match slot {
            Some(first) => {
                let message = format!("a vehicle may have only one `{}` block", inner.keyword.value);
                let error = Diagnostic::error("mavc::name::duplicate", inner.keyword.span, message);
                let error = error.here("second block").also(first.keyword.span, "first block");
                cx.report(error.help("move its contents into the first block, then remove this one"));
                *twice = true;
            }
            None => *slot = Some(inner),
        }
    }
    blocks
}

fn inertia<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<[f64; 3]> {
    let [x, y, z] = cx.triple(Expected::of(&table::INERTIA), expr)?;
    if let Some(bad) = [x, y, z].into_iter().find(|i| *i <= 0.0) {
        let error = Diagnostic::error(POSITIVE, expr.span, "`inertia` must be greater than zero about every axis");
        cx.report(error.here(format!("contains {} kg*m^2", number(bad))).help("write three values above zero"));
        return None;
    }
    // Flat bodies reach equality; the factor allows for rounding.
    let (largest, sum) = (x.max(y).max(z), x + y + z);
    if largest > (sum - largest) * (1.0 + 1e-9) {
        let message = "no body has this inertia: the value of one axis exceeds the sum of the other two";
        cx.report(
            Diagnostic::error("mavc::vehicle::inertia", expr.span, message)
                .here(format!("{} > {}", number(largest), number(sum - largest)))
                .help("check the three numbers and their unit; for a flat vehicle Izz is at most Ixx + Iyy"),
        );
        return None;
    }
    Some([x, y, z])
}

/// The position and spin of one rotor, and its own clauses.
struct Place<'a> {
    position: [f64; 3],
    spin: Spin,
    motor: Option<u32>,
    own: Option<Fields<'a>>,
}

/// Rotors on a circle: rotor k at the angle `first + 2 pi (k-1)/n`, clockwise from +y.
fn ring<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> (Option<Vec<Place<'a>>>, Option<usize>) {
    if !fields.may_have("layout") {
        // A ring needs an arm too; the example adds one, but its absence is reported only where a ring is certain.
        let arm = if fields.may_have("arm") { "" } else { "; arm = 0.2 m" };
        let (example, one_by_one) =
            (format!("layout = \"PPNNPPNN\"{arm}"), "rotors { rotor at [0.2, 0.2, 0] m spin P ... }");
        fields.missing_or(cx, "`layout`", &example, &format!("add `{example}`, or `{one_by_one}`"));
    }
    let layout = fields.get("layout").and_then(|e| spins(cx, e));
    let count = layout.as_ref().map(Vec::len);
    let layout_span = fields.get("layout").map_or(fields.span, |e| e.span);
    layout.iter().for_each(|spins| whole::check_spins(cx, &fields.owner, layout_span, spins));
    // Without a `layout` the vehicle may not be meant as a ring, so that no missing `arm` is reported.
    let arm = match fields.get("layout") {
        Some(_) => fields.demand(cx, "arm", "arm = 0.2 m"),
        None => fields.get("arm"),
    };
    let arm = arm.and_then(|e| cx.quantity(&table::ARM, e, POSITIVE));
    let first = match fields.get("first") {
        Some(expr) => cx.number(Expected::of(&table::FIRST), expr),
        None => Some(0.0),
    };
    let (Some(spins), Some(arm), Some(first)) = (layout, arm, first) else {
        return (None, count);
    };
    let n = spins.len() as f64;
    let places = spins.into_iter().enumerate().map(|(k, spin)| {
        let (sin, cos) = exact_sin_cos(first + 2.0 * PI * k as f64 / n);
        Place { position: [arm * sin, arm * cos, 0.0], spin, motor: None, own: None }
    });
    (Some(places.collect()), count)
}

/// Sine and cosine, exact at the quarter turns so that a ring is symmetric to the last digit.
fn exact_sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / (PI / 2.0);
    if (quarters - quarters.round()).abs() < 1e-12 {
        return match quarters.round().rem_euclid(4.0) as u8 {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    angle.sin_cos()
}

fn spins<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<Vec<Spin>> {
    let ExprKind::Text(text) = &expr.kind else {
        let error =
            Diagnostic::error("mavc::vehicle::layout", expr.span, "`layout` must be text of the letters P and N");
        let error = error.here("not text in quotes");
        cx.report(match &expr.kind {
            ExprKind::Name(name) if name.chars().all(|c| matches!(c.to_ascii_uppercase(), 'P' | 'N')) => {
                let corrected = format!("\"{}\"", name.to_ascii_uppercase());
                error.help(format!("write `{corrected}`")).fix(expr.span, corrected)
            }
            _ => error.help("write `layout = \"PNPN\"`"),
        });
        return None;
    };
    if let Some((at, letter)) = text.char_indices().find(|(_, c)| !matches!(c, 'P' | 'N')) {
        let start = expr.span.start as usize + 1 + at;
        let span = Span::new(expr.span.file, start, start + letter.len_utf8());
        let message = format!("a layout may contain only P and N, not `{letter}`");
        let mut error = Diagnostic::error("mavc::vehicle::layout", span, message).here("neither P nor N");
        let capitals = text.to_ascii_uppercase();
        error = match letter.to_ascii_uppercase() {
            _ if capitals.chars().all(|c| matches!(c, 'P' | 'N')) => {
                let corrected = format!("\"{capitals}\"");
                error.help(format!("write `{corrected}`")).fix(expr.span, corrected)
            }
            upper @ ('P' | 'N') => error.help(format!("write `{upper}`")).fix(span, upper.to_string()),
            _ => error.help("write `P` (counter-clockwise seen from above) or `N` (clockwise)"),
        };
        cx.report(error);
        return None;
    }
    if !text.len().is_multiple_of(2) || !ROTORS.contains(&text.len()) {
        let message = format!("a ring must have an even number of rotors from 4 to 32, not {}", text.len());
        let error = Diagnostic::error("mavc::vehicle::rotor_count", expr.span, message);
        let letters = if text.len() == 1 { "1 letter".to_string() } else { format!("{} letters", text.len()) };
        cx.report(error.here(format!("{letters}, one per rotor")).help(match text.len() {
            few if few < *ROTORS.start() => {
                "write a letter for each rotor: a quadcopter is \"PNPN\", a hexacopter \"PNPNPN\"".to_string()
            }
            many if many > *ROTORS.end() => format!("remove letters until {} are left", ROTORS.end()),
            odd => format!(
                "write {} or {} letters, or place the {odd} rotors one by one: \
                 `rotors {{ rotor at [0.2, 0.15, 0] m  spin P; .. }}`",
                odd - 1,
                odd + 1
            ),
        }));
        return None;
    }
    Some(text.chars().map(|c| if c == 'P' { Spin::P } else { Spin::N }).collect())
}

/// Rotors placed one by one; the second value is their number, errors or not.
fn one_by_one<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    owner: &str,
    span: Span,
) -> (Option<Vec<Place<'a>>>, Option<usize>) {
    let rotors: Vec<&'a Clauses> =
        block.body.iter().filter_map(|s| if let Statement::Rotor(r) = s { Some(r) } else { None }).collect();
    let broken = block.body.iter().any(|s| matches!(s, Statement::Broken(_)));
    for statement in &block.body {
        if let Statement::Field(field) = statement {
            let message = format!("`rotors` of {owner} has no field `{}`", field.name.value);
            let error = Diagnostic::error("mavc::name::unknown_field", field.name.span, message).here("unknown field");
            cx.report(error.help("write what all rotors share in a `rotor { ... }` block beside it"));
        }
    }
    if !broken && !ROTORS.contains(&rotors.len()) {
        let message = format!("a vehicle must have 4 to 32 rotors, not {}", rotors.len());
        let error = Diagnostic::error("mavc::vehicle::rotor_count", block.keyword.span, message);
        let help = if rotors.len() < *ROTORS.start() { "add `rotor at` statements" } else { "remove some rotors" };
        let follow =
            if rotors.len() == 1 { "1 rotor follows".to_string() } else { format!("{} rotors follow", rotors.len()) };
        cx.report(error.here(follow).help(help));
        return (None, None);
    }
    // With a rotor that could not be parsed, the whole is unknown.
    let mut places = (!broken).then(Vec::new);
    for (k, rotor) in rotors.iter().enumerate() {
        let place = placed(cx, rotor, k + 1);
        match (&mut places, place) {
            (Some(list), Some(place)) => list.push(place),
            (list, _) => *list = None,
        }
    }
    places.iter().for_each(|places| check_motors(cx, places));
    let spins: Option<Vec<Spin>> = places.as_ref().map(|places| places.iter().map(|place| place.spin).collect());
    spins.iter().for_each(|spins| whole::check_spins(cx, owner, span, spins));
    (places, (!broken).then_some(rotors.len()))
}

/// Every rotor has a motor of its own, or none has a number.
fn check_motors(cx: &mut Context, places: &[Place]) {
    let clause = |k: usize| places[k].own.as_ref().and_then(|own| own.clause(placed_rotor::MOTOR.name));
    let numbered = places.iter().position(|place| place.motor.is_some());
    let Some((first, at)) = numbered.and_then(|k| Some((k, clause(k)?))) else { return };
    for (k, place) in places.iter().enumerate() {
        let before = places[..k].iter().position(|other| place.motor.is_some() && other.motor == place.motor);
        if let Some((span, other)) = clause(k).zip(before.and_then(clause)) {
            let message = format!("motor {} turns two rotors", place.motor.unwrap_or_default());
            let error = Diagnostic::error(MOTOR, span, message).here("given again").also(other, "first given here");
            cx.report(error.help("give each rotor the number of its own motor"));
        }
        if let (None, Some(own)) =
            (place.motor, place.own.as_ref().filter(|own| !own.may_have(placed_rotor::MOTOR.name)))
        {
            let message = format!("rotor {} has no `motor`, but rotor {} has one", k + 1, first + 1);
            let error = Diagnostic::error(MOTOR, own.span, message).here("no motor").also(at, "a motor");
            cx.report(error.help("number the motors of all rotors, or of none"));
            return;
        }
    }
}

fn placed<'a>(cx: &mut Context<'a>, rotor: &'a Clauses, k: usize) -> Option<Place<'a>> {
    let own = Fields::of_clauses(cx, format!("rotor {k}"), rotor, Group::PlacedRotor);
    let position =
        own.demand(cx, "at", "at [0.2, 0.15, 0] m").and_then(|e| cx.triple(Expected::of(&placed_rotor::AT), e));
    let spin = own.demand(cx, "spin", "spin P").and_then(|e| match &e.kind {
        ExprKind::Name(name) if name == "P" => Some(Spin::P),
        ExprKind::Name(name) if name == "N" => Some(Spin::N),
        _ => {
            let error = Diagnostic::error("mavc::vehicle::spin", e.span, "`spin` must be `P` or `N`");
            let error = error.here("neither of these");
            let word = cx.sources.snippet(e.span).trim_matches('"').to_ascii_lowercase();
            cx.report(match word.as_str() {
                "p" | "ccw" | "counterclockwise" | "positive" | "left" => {
                    error.help("write `P`, which turns counter-clockwise seen from above").fix(e.span, "P")
                }
                "n" | "cw" | "clockwise" | "negative" | "right" => {
                    error.help("write `N`, which turns clockwise seen from above").fix(e.span, "N")
                }
                _ => error.help("write `P` (counter-clockwise seen from above) or `N` (clockwise)"),
            });
            None
        }
    });
    let motor = match own.get(placed_rotor::MOTOR.name) {
        Some(expr) => Some(cx.count(&placed_rotor::MOTOR, "`motor`", expr, MOTOR)? as u32),
        None => None,
    };
    Some(Place { position: position?, spin: spin?, motor, own: Some(own) })
}
