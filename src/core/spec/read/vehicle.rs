//! `vehicle` blocks.

mod battery;
mod mounts;
mod parts;
mod reverse;
mod rotor;
mod rotor_table;
mod whole;

use super::context::{Context, second_block};
use super::defaulted::Defaulted;
use super::expected::Expected;
use super::fields::Fields;
use super::load::FileSet;
use super::plausibility::{Measured, RotorSpans, VehicleSpans, check_battery, check_parts, check_vehicle};
use super::written::Written;
use super::yaw_drag;
use crate::diagnostic::Diagnostic;
use crate::language::table::vehicle as table;
use crate::language::{Entry, Group};
use crate::model::{Allocation, DefaultUsed, Rotor, Spread, Vehicle};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr, ExprKind, Statement};
pub use mounts::ROTORS;
use rotor_table::RotorTable;

const POSITIVE: &str = "mavc::vehicle::not_positive";
const ALLOCATION: &str = "mavc::vehicle::allocation";
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

pub(super) fn elaborate<'a>(cx: &mut Context<'a>, block: &'a Block, files: &FileSet) -> Outline {
    let name = block.name.as_ref().map_or("vehicle", |n| &n.value).to_string();
    let span = block.name.as_ref().map_or(block.keyword.span, |n| n.span);
    let fields = Fields::of_block(cx, format!("vehicle `{name}`"), span, &block.body, Group::Vehicle);
    let fields = Defaulted::new("vehicle", fields);
    let mut reader = Reader { fields, blocks: Blocks::of(cx, block), count: None, table: Written::Absent };
    let vehicle = reader.read(cx, block, &name, files);
    Outline { name, span, rotors: reader.count, vehicle, defaults: reader.fields.used }
}

/// The blocks inside a vehicle.
#[derive(Default)]
struct Blocks<'a> {
    /// `rotor { }`
    shared: Option<&'a Block>,
    /// `rotors { }`
    placed: Option<&'a Block>,
    battery: Option<&'a Block>,
    parts: Option<&'a Block>,
    /// Whether the block `rotor` or `rotors` occurs twice, or `battery` or `parts` does, which is reported.
    twice: bool,
    battery_twice: bool,
    parts_twice: bool,
}

impl<'a> Blocks<'a> {
    fn of(cx: &mut Context<'a>, block: &'a Block) -> Self {
        let mut blocks = Blocks::default();
        for statement in &block.body {
            let Statement::Block(inner) = statement else {
                continue;
            };
            let (slot, twice) = match inner.keyword.value.as_str() {
                "rotors" => (&mut blocks.placed, &mut blocks.twice),
                "battery" => (&mut blocks.battery, &mut blocks.battery_twice),
                "parts" => (&mut blocks.parts, &mut blocks.parts_twice),
                _ => (&mut blocks.shared, &mut blocks.twice),
            };
            match slot {
                Some(first) => {
                    let message = format!("a vehicle may have only one `{}` block", inner.keyword.value);
                    cx.report(second_block(message, inner, first));
                    *twice = true;
                }
                None => *slot = Some(inner),
            }
        }
        blocks
    }
}

struct Reader<'a> {
    fields: Defaulted<'a>,
    blocks: Blocks<'a>,
    /// The number of rotors, once it is known, errors or not.
    count: Option<usize>,
    /// That of the `rotor` block, once it is read.
    table: Written<RotorTable>,
}

/// The whole as a rigid body, with the place of its mass in the text.
struct Body {
    mass: f64,
    mass_spread: Spread,
    mass_span: Span,
    inertia: [f64; 3],
    centre_of_gravity: Option<[f64; 3]>,
}

/// The rotors, and where the numbers of each are written.
struct Rotors {
    list: Vec<Rotor>,
    spans: Vec<RotorSpans>,
}

impl<'a> Reader<'a> {
    fn read(&mut self, cx: &mut Context<'a>, block: &'a Block, name: &str, files: &FileSet) -> Option<Vehicle> {
        let parts = self.parts(cx);
        let mass = self.unless_parts(cx, &table::MASS, "mass = 1.8 kg", |cx, expr| {
            cx.interval(Expected::of(&table::MASS), expr, POSITIVE)
        });
        let example = "inertia = [0.04, 0.04, 0.07] kg*m^2";
        let inertia = self.unless_parts(cx, &table::INERTIA, example, inertia_of);
        let centre =
            self.fields.written("centre_of_gravity", |expr| cx.triple(Expected::of(&table::CENTRE_OF_GRAVITY), expr));
        let rotors = self.rotors(cx, files);
        let propeller_radius = self.fields.quantity(cx, &table::PROPELLER_RADIUS, POSITIVE);
        let size = self.fields.quantity(cx, &table::SIZE, POSITIVE);
        let drag = self.fields.written("drag", |expr| cx.drag_interval(&table::DRAG, expr, POSITIVE));
        let yaw_drag = yaw_drag::read(cx, &self.fields);
        let allocation = self.fields.choice_or(cx, &table::ALLOCATION, ALLOCATION, &ALLOCATIONS, Allocation::Bounded);
        let battery = self.battery(cx);
        let (mut rotors, battery) = (rotors?, battery.optional().ok()?);
        let measured = Measured {
            mass: mass.optional().ok()?.map(|(mass, spread)| (mass, spread, self.value_span("mass"))),
            inertia: inertia.optional().ok()?.map(|inertia| (inertia, self.value_span("inertia"))),
            centre_of_gravity: centre.optional().ok()?.map(|centre| (centre, self.value_span("centre_of_gravity"))),
        };
        let Body { mass, mass_spread, mass_span, inertia, centre_of_gravity } =
            self.body(cx, parts.optional().ok()?, &measured, &rotors.list)?;
        let hover_thrust = mass * cx.gravity / rotors.list.len() as f64;
        let battery = match battery {
            Some(draft) => Some(draft.finish(cx, &self.table, rotors.list.len(), hover_thrust)?),
            None => None,
        };
        if let Some(centre) = centre_of_gravity {
            for rotor in &mut rotors.list {
                rotor.position = std::array::from_fn(|axis| rotor.position[axis] - centre[axis]);
            }
        }
        let (drag, drag_spread) = drag.or_default(|| ([0.0; 3], Spread::NONE))?;
        let mut vehicle = Vehicle {
            name: name.to_string(),
            doc: block.doc.clone(),
            layout: self.layout(),
            mass,
            mass_spread,
            inertia,
            centre_of_gravity,
            drag,
            drag_spread,
            drag_span: self.fields.span_of("drag"),
            yaw_drag: yaw_drag.optional().ok()?,
            propeller_radius: propeller_radius.optional().ok()?,
            size: size.optional().ok()?,
            rotors: rotors.list,
            allocation: allocation?,
            battery: battery.as_ref().map(|read| read.battery.clone()),
            span: self.fields.span,
            mass_span,
        };
        (block.is_whole() && self.check(cx, &mut vehicle, rotors.spans, battery)).then_some(vehicle)
    }

    /// Where the value of a field of the vehicle is written.
    fn value_span(&self, name: &str) -> Span {
        self.fields.get(name).map_or(self.fields.span, |expr| expr.span)
    }

    /// A field that is required unless the vehicle has `parts`.
    fn unless_parts<T>(
        &self,
        cx: &mut Context<'a>,
        entry: &'static Entry,
        example: &str,
        read: impl FnOnce(&mut Context<'a>, &'a Expr) -> Option<T>,
    ) -> Written<T> {
        let has_parts = self.blocks.parts.is_some();
        let expr = match has_parts {
            true => self.fields.get(entry.name),
            false => self.fields.demand_own(cx, entry.name, example),
        };
        match expr {
            Some(expr) => Written::of(read(cx, expr)),
            None if has_parts && !self.fields.may_have(entry.name) => Written::Absent,
            None => Written::Faulty,
        }
    }

    fn parts(&self, cx: &mut Context<'a>) -> Written<parts::Read> {
        let Some(block) = self.blocks.parts else { return Written::Absent };
        let read = parts::read(cx, block, &self.fields.owner);
        Written::of(read.filter(|_| !self.blocks.parts_twice))
    }

    /// Mass, inertia and centre of gravity as measured, or else as the parts give them; warns where the two differ.
    /// `rotors` have places from the frame's origin.
    fn body(
        &self,
        cx: &mut Context<'a>,
        parts: Option<parts::Read>,
        measured: &Measured,
        rotors: &[Rotor],
    ) -> Option<Body> {
        let Some(parts) = parts else {
            let (mass, mass_spread, mass_span) = measured.mass?;
            let centre_of_gravity = measured.centre_of_gravity.map(|(centre, _)| centre);
            return Some(Body { mass, mass_spread, mass_span, inertia: measured.inertia?.0, centre_of_gravity });
        };
        let composite = parts.composite(cx, rotors)?;
        let (mass, mass_spread, mass_span) = measured.mass.unwrap_or((composite.mass, Spread::NONE, parts.span));
        let inertia = match measured.inertia {
            Some((inertia, _)) => inertia,
            None => parts.inertia(cx, &composite, &self.fields.owner)?,
        };
        let distance = |rotor: &Rotor| rotor.position.iter().map(|x| x * x).sum::<f64>().sqrt();
        let reach = rotors.iter().map(distance).fold(0.0, f64::max);
        check_parts(cx, &self.fields.owner, &composite, measured, reach, parts.span);
        let centre_of_gravity = measured.centre_of_gravity.map_or(composite.centre_of_gravity, |(centre, _)| centre);
        Some(Body { mass, mass_spread, mass_span, inertia, centre_of_gravity: Some(centre_of_gravity) })
    }

    /// Whether the vehicle as a whole can be right; reports what is not, and warns of numbers that do not fit together.
    /// Lowers the full thrust of its rotors to what the battery leaves.
    fn check(
        &mut self,
        cx: &mut Context<'a>,
        vehicle: &mut Vehicle,
        rotors: Vec<RotorSpans>,
        battery: Option<battery::Read<'a>>,
    ) -> bool {
        if vehicle.allocation == Allocation::PseudoInverse && vehicle.has_uncertain_rotors() {
            let message = "`allocation = pseudo_inverse` cannot be combined with intervals on rotors";
            let at = self.fields.span_of("allocation").unwrap_or(vehicle.span);
            cx.report(
                Diagnostic::error("mavc::vehicle::conflict", at, message)
                    .here("needs exact coefficients and speeds")
                    .help("write `allocation = bounded`, or remove the intervals from the rotors; `mass` may keep one"),
            );
        }
        whole::check(cx, vehicle);
        let spans = VehicleSpans {
            mass: vehicle.mass_span,
            inertia: self.fields.span_of("inertia").unwrap_or(vehicle.span),
            yaw_drag: self.fields.span_of("yaw_drag").unwrap_or(vehicle.span),
            propeller_radius: self.fields.span_of("propeller_radius"),
            rotors,
        };
        let mut fits = cx.has_magnitude(vehicle, |k| [spans.rotors[k].thrust, spans.rotors[k].torque]);
        if fits {
            check_vehicle(cx, vehicle, &spans);
        }
        if let Some(mut read) = battery {
            check_battery(cx, vehicle, &read.battery, &read.fields);
            let thrust_at_empty = read.fields.span_of("thrust_at_empty").unwrap_or(read.battery.span);
            fits &= battery::lower_full_thrust(cx, vehicle, thrust_at_empty);
            self.fields.used.append(&mut read.fields.used);
        }
        reverse::check(cx, vehicle, |k| spans.rotors[k].min_speed);
        fits
    }

    /// The layout of a ring, as written.
    fn layout(&self) -> Option<String> {
        match (self.blocks.placed, self.fields.get("layout").map(|e| &e.kind)) {
            (None, Some(ExprKind::Text(text))) => Some(text.clone()),
            _ => None,
        }
    }

    fn battery(&self, cx: &mut Context<'a>) -> Written<battery::Draft<'a>> {
        let Some(block) = self.blocks.battery else { return Written::Absent };
        let read = battery::read(cx, block, &self.fields.owner, &self.table);
        Written::of(read.filter(|_| !self.blocks.battery_twice))
    }

    fn rotors(&mut self, cx: &mut Context<'a>, files: &FileSet) -> Option<Rotors> {
        let owner = format!("`rotor` of {}", self.fields.owner);
        let of_block = |block: &'a Block| Fields::of_block(cx, owner, block.keyword.span, &block.body, Group::Rotor);
        let shared = self.blocks.shared.map(of_block);
        let mounts = match self.blocks.placed {
            Some(placed) => mounts::one_by_one(cx, &self.fields, placed),
            None => mounts::ring(cx, &self.fields),
        };
        self.count = mounts.count;
        let base = shared.as_ref().map(|fields| {
            let written = rotor::PartialRotor::read(cx, fields);
            self.table = rotor_table::read(cx, fields, files);
            if let Written::Value(table) = &self.table {
                written.compare(cx, fields, table);
                table.note(cx, fields);
                self.fields.used.extend(table.used(fields));
            }
            written.over(&rotor::PartialRotor::of_table(&self.table))
        });
        if base.is_none() && self.blocks.placed.is_none() && !self.fields.may_have("rotor") {
            let example = "rotor { max_thrust = 9 N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }";
            self.fields.missing(cx, "a `rotor` block", example);
        }
        let Some(mounts) = mounts.list else {
            // The `rotor` block holds for every rotor, wherever the rotors are.
            if let (None, Some(base), Some(fields)) = (self.blocks.placed, &base, &shared) {
                base.check(cx, fields);
            }
            return None;
        };
        // With a duplicate block the rotors are unknown.
        if self.blocks.twice {
            return None;
        }
        let spans = rotor::spans(&mounts, &self.fields, shared.as_ref());
        Some(Rotors { list: rotor::give_all(cx, mounts, shared.as_ref(), base)?, spans })
    }
}

fn inertia_of<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<[f64; 3]> {
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
