//! Specs from Rust values instead of text.

mod after_fault;
mod mission;
mod problem;
mod text;
mod value;

#[allow(deprecated)]
pub use problem::Problem;
pub use problem::{BuildError, BuildProblem};
pub use value::Value;

use crate::diagnostic::{Diagnostic, Severity, nearest};
use crate::language::{Entry, Group, Takes};
use crate::spec::{Compiled, Compiler, Spec};
use problem::BuildCode;
use std::fmt::Write;
use std::io::ErrorKind;
use text::{Line, Mode, Named};
use value::{NOT_FINITE, digits, taken, unit, word};

/// The name of a built text among the sources of its spec.
const NAME: &str = "<builder>";

/// Builds a [`Spec`] from values in SI units. Fields of the language are set by their names (docs/language.md); a field
/// that is not set has the default of the language. [`Spec::set`] writes what has no Rust value, such as an interval
/// (`spec.set("vehicle.mass = 1.8 kg +- 0.1 kg")`).
///
/// The builder writes a text ([`Builder::text`]) and compiles it. So a built spec is checked like a written one, it can
/// be saved, and certificates refer to this text. [`Builder::build`] reports all mistakes together, those of the calls
/// before those that a text is checked for.
///
/// ```
/// use mavc::builder::Builder;
///
/// let spec = Builder::new()
///     .vehicle("layout", "PPNNPPNN")
///     .vehicle("arm", 0.211)
///     .vehicle("mass", 1.8)
///     .vehicle("inertia", [0.0429, 0.0429, 0.0748])
///     .rotor("max_thrust", 6.53)
///     .rotor("torque_per_thrust", 0.016)
///     .rotor("max_speed", 874.0)
///     .lost("M1", &[1])
///     .waypoint([0.0, 0.0, 2.0])
///     .waypoint([10.0, 0.0, 5.0])
///     .at_most("speed", 6.0)
///     .plan("planner", "rip")
///     .plan("samples", 60)
///     .build()?;
/// assert_eq!(spec.model().modes.len(), 1);
/// # Ok::<(), mavc::builder::BuildError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Builder {
    top: Vec<Line>,
    vehicle: Vec<Line>,
    rotor: Vec<Line>,
    placed: Vec<Line>,
    battery: Vec<Line>,
    parts: Vec<Line>,
    /// The blocks `part` within `parts`.
    part: Vec<Named>,
    modes: Vec<Mode>,
    mission: Vec<Line>,
    limits: Vec<Line>,
    volumes: Vec<Named>,
    /// Landing sites and areas to keep off.
    places: Vec<Named>,
    after_fault_limits: Vec<Line>,
    plan: Vec<Line>,
    recovery: Vec<Line>,
    simulate: Vec<Line>,
    campaign: Vec<Line>,
    waypoints: usize,
    problems: Vec<BuildProblem>,
}

impl Builder {
    pub fn new() -> Self {
        Builder::default()
    }

    /// Sets a field outside all blocks, such as `gravity` (m/s^2).
    pub fn top(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Top, "", field, value.into(), " = ");
        self.top.push(line);
        self
    }

    /// Sets a field of the vehicle, such as `mass` (kg) or `layout`.
    pub fn vehicle(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Vehicle, "vehicle.", field, value.into(), " = ");
        self.vehicle.push(line);
        self
    }

    /// Sets a field of all rotors, such as `max_thrust` (N).
    pub fn rotor(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Rotor, "vehicle.rotor.", field, value.into(), " = ");
        self.rotor.push(line);
        self
    }

    /// Sets a field of the vehicle's battery: `capacity` (A s), `voltage` (V), `hover_power` (W), `keep` or
    /// `thrust_at_empty` (shares, 0 to 1).
    pub fn battery(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Battery, "vehicle.battery.", field, value.into(), " = ");
        self.battery.push(line);
        self
    }

    /// Sets a field of the vehicle's parts: `motor_mass` or `arm_mass` (kg).
    pub fn parts(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Parts, "vehicle.parts.", field, value.into(), " = ");
        self.parts.push(line);
        self
    }

    /// Adds a part of the vehicle: its mass (kg), and the place of its centre from the frame's origin (m). It is a box
    /// with the sides `size` (m), or a point. With parts the vehicle needs no `mass` and no `inertia`.
    ///
    /// ```
    /// use mavc::builder::Builder;
    ///
    /// let spec = Builder::new()
    ///     .vehicle("layout", "PNPN")
    ///     .vehicle("arm", 0.25)
    ///     .rotor("max_thrust", 8.0)
    ///     .rotor("torque_per_thrust", 0.016)
    ///     .rotor("max_speed", 900.0)
    ///     .parts("motor_mass", 0.1)
    ///     .part("battery", 0.6, [0.0, 0.0, -0.03], Some([0.15, 0.07, 0.05]))
    ///     .part("electronics", 0.4, [0.0, 0.0, 0.02], None)
    ///     .build()?;
    /// assert!((spec.model().vehicle.mass - 1.4).abs() < 1e-12);
    /// # Ok::<(), mavc::builder::BuildError>(())
    /// ```
    pub fn part(mut self, name: &str, mass: f64, at: [f64; 3], size: Option<[f64; 3]>) -> Self {
        let path = format!("vehicle.parts.{name}");
        self.name(&path, name);
        let given = [("mass", Value::from(mass)), ("at", Value::from(at))];
        let given = given.into_iter().chain(size.map(|size| ("size", Value::from(size))));
        let field = |(field, value): (&str, Value)| self.field(Group::Part, &format!("{path}."), field, value, " = ");
        let fields = given.map(field).collect();
        self.part.push(Named { path, keyword: "part", name: name.into(), fields });
        self
    }

    /// Adds a rotor at a position (m from the frame's origin, which is the centre of gravity unless parts or
    /// `centre_of_gravity` give it), with spin `P` (counter-clockwise seen from above) or
    /// `N`. `fields` are those that it does not share with the other rotors. Use this instead of a `layout`.
    pub fn placed_rotor(mut self, position: [f64; 3], spin: &str, fields: &[(&str, f64)]) -> Self {
        let path = format!("vehicle.rotors[{}].", self.placed.len() + 1);
        let given = [("at", Value::from(position)), ("spin", Value::from(spin))];
        let given = given.into_iter().chain(fields.iter().map(|(name, value)| (*name, Value::from(*value))));
        let line = self.clauses(Group::PlacedRotor, &path, "rotor", given);
        self.placed.push(line);
        self
    }

    /// Adds a fault mode in which the given rotors, counted from 1, are lost. If the mode exists already, it loses
    /// these too.
    pub fn lost(self, mode: &str, rotors: &[usize]) -> Self {
        self.effect(mode, rotors, "lost".into(), &[])
    }

    /// Adds a fault mode in which rotors (numbered from 1) give at most a share of their thrust, 0 to 1.
    pub fn reduced(self, mode: &str, rotors: &[usize], share: f64) -> Self {
        self.effect(mode, rotors, format!("reduced to {}", digits(share)), &[share])
    }

    /// Adds a fault mode in which rotors (numbered from 1) are stuck at a share of their full thrust, 0 to 1.
    pub fn stuck(self, mode: &str, rotors: &[usize], share: f64) -> Self {
        self.effect(mode, rotors, format!("stuck at {}", digits(share)), &[share])
    }

    fn effect(mut self, mode: &str, rotors: &[usize], effect: String, numbers: &[f64]) -> Self {
        let path = format!("modes.{mode}");
        let before = self.problems.len();
        self.name(&path, mode);
        self.finite(&path, numbers);
        let rotors: Vec<String> = rotors.iter().map(usize::to_string).collect();
        let line = self.line(before, path, format!("rotors [{}] {effect}", rotors.join(", ")));
        match self.modes.iter_mut().find(|known| known.name == mode) {
            Some(known) => known.effects.push(line),
            None => self.modes.push(Mode { name: mode.into(), effects: vec![line], fields: Vec::new() }),
        }
        self
    }

    /// Sets a field of a fault mode that was added before, such as `rate` (1/s).
    pub fn mode(mut self, mode: &str, field: &str, value: impl Into<Value>) -> Self {
        let path = format!("modes.{mode}.");
        let line = self.field(Group::Mode, &path, field, value.into(), " = ");
        match self.modes.iter_mut().find(|known| known.name == mode) {
            Some(known) => known.fields.push(line),
            None => {
                let message = format!("unknown fault mode `{mode}`");
                let help = "add it before its fields, for example by `lost`";
                self.problem(path.trim_end_matches('.'), BuildCode::UnknownMode, message, Some(help.into()));
            }
        }
        self
    }

    /// A statement with clauses: `waypoint at [0, 0, 2] m yaw 0.5 rad`.
    fn clauses<'v>(
        &mut self,
        group: Group,
        path: &str,
        head: &str,
        given: impl Iterator<Item = (&'v str, Value)>,
    ) -> Line {
        let before = self.problems.len();
        let mut text = head.to_string();
        for (name, value) in given {
            let _ = write!(text, " {}", self.field(group, path, name, value, " ").text);
        }
        self.line(before, path.trim_end_matches('.'), text)
    }

    /// Sets a field of the plan, such as `time` (s), `planner` or `against`.
    pub fn plan(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Plan, "plan.", field, value.into(), " = ");
        self.plan.push(line);
        self
    }

    /// Sets a field of the simulation, such as `drag` (N s/m).
    pub fn simulate(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Simulate, "simulate.", field, value.into(), " = ");
        self.simulate.push(line);
        self
    }

    /// Lets a fault mode strike in the simulation, at a time in s after the start.
    pub fn strike(mut self, mode: &str, at: f64) -> Self {
        let path = format!("simulate.fault.{mode}");
        let before = self.problems.len();
        self.name(&path, mode);
        self.finite(&path, &[at]);
        let line = self.line(before, path, format!("fault {} at {} s", word(mode), digits(at)));
        self.simulate.push(line);
        self
    }

    /// Sets a field of the campaign, such as `seeds`.
    pub fn campaign(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Campaign, "campaign.", field, value.into(), " = ");
        self.campaign.push(line);
        self
    }

    /// Builds the spec.
    ///
    /// # Errors
    /// The error lists every mistake with the call that made it: a field that does not exist, a value that is not
    /// finite or of the wrong kind, and everything that a text is checked for.
    pub fn build(self) -> Result<Spec, BuildError> {
        self.build_with_warnings().map(|(spec, _)| spec)
    }

    /// The spec, with the warnings and the advice about it.
    ///
    /// # Errors
    /// Those of [`Builder::build`].
    pub fn build_with_warnings(self) -> Result<(Spec, Vec<BuildProblem>), BuildError> {
        let lines = self.lines();
        let text = self.text();
        let no_files = |_: &std::path::Path| Err(ErrorKind::NotFound.into());
        let Compiled { spec, diagnostics, files } = Compiler::new().reading(&no_files).text(NAME, text.as_bytes());
        let line_of = |d: &Diagnostic| {
            let line = files.sources.get(d.span.file).place(d.span.start as usize).line;
            lines.get(line.saturating_sub(1))
        };
        let mut problems = self.problems;
        let is_new = |d: &&Diagnostic| line_of(d).is_none_or(|line| !line.is_reported);
        let (errors, warnings): (Vec<_>, Vec<_>) =
            diagnostics.iter().filter(is_new).partition(|d| d.severity == Severity::Error);
        let problem = |d: &Diagnostic| BuildProblem {
            field: line_of(d).map_or(String::new(), |line| line.path.clone()),
            code: d.code,
            message: d.message.clone(),
            label: Some(d.label.clone()).filter(|label| !label.is_empty()),
            help: d.help.clone(),
        };
        problems.extend(errors.into_iter().map(problem));
        match spec {
            Some(spec) if problems.is_empty() => Ok((spec, warnings.into_iter().map(problem).collect())),
            _ => Err(BuildError { problems, text }),
        }
    }

    fn problem(&mut self, field: &str, code: BuildCode, message: String, help: Option<String>) {
        self.problems.push(BuildProblem { field: field.into(), code: code.code(), message, label: None, help });
    }

    /// The line of a call that began with `before` problems.
    fn line(&self, before: usize, path: impl Into<String>, text: String) -> Line {
        Line { is_reported: self.problems.len() > before, ..Line::new(path, text) }
    }

    fn finite(&mut self, path: &str, numbers: &[f64]) {
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            self.problem(path, BuildCode::NotFinite, format!("{number} is not a finite number"), None);
        }
    }

    fn name(&mut self, path: &str, name: &str) {
        if word(name) != name {
            let help = "use letters, digits and `_`, and start with a letter or `_`";
            self.problem(path, BuildCode::NotAName, format!("{name:?} is not a name"), Some(help.into()));
        }
    }

    fn entry(&mut self, group: Group, path: &str, field: &str) -> Option<&'static Entry> {
        let entry = group.entry(field);
        if entry.is_none() {
            let help = nearest(field, group.names()).map(|near| format!("did you mean `{near}`?"));
            self.problem(path, BuildCode::UnknownField, format!("there is no field `{field}` here"), help);
        }
        entry
    }

    /// `field = value`, or `field value` for a clause.
    fn field(&mut self, group: Group, path: &str, field: &str, value: Value, sign: &str) -> Line {
        let path = format!("{path}{field}");
        let before = self.problems.len();
        let Some(entry) = self.entry(group, &path, field) else {
            return self.line(before, path, format!("{}{sign}{NOT_FINITE}", word(field)));
        };
        let written = match (&value, entry.takes) {
            (
                Value::Number(number),
                Takes::Quantity(..) | Takes::QuantityOr(..) | Takes::QuantityOrVector(..) | Takes::QuantityOrShare(..),
            ) => {
                self.finite(&path, &[*number]);
                format!("{}{}", digits(*number), unit(entry))
            }
            (Value::Number(number), Takes::Share | Takes::Whole(..)) => {
                self.finite(&path, &[*number]);
                digits(*number)
            }
            (Value::Vector(vector), Takes::Vector(..) | Takes::QuantityOrVector(..) | Takes::PlanePoint(_)) => {
                self.finite(&path, vector);
                format!("[{}]{}", vector.map(digits).join(", "), unit(entry))
            }
            (Value::Word(text), Takes::Text) if !text.contains(|c: char| c.is_control() || matches!(c, '"' | '\\')) => {
                format!("\"{text}\"")
            }
            (Value::Word(text), Takes::Words(_) | Takes::WordList(_) | Takes::Names(_) | Takes::QuantityOr(..)) => {
                self.name(&path, text);
                word(text)
            }
            (Value::Names(names), Takes::WordList(_) | Takes::Names(_) | Takes::NameList(_)) => {
                names.iter().for_each(|name| self.name(&path, name));
                format!("[{}]", names.iter().map(|name| word(name)).collect::<Vec<_>>().join(", "))
            }
            (Value::Points(points), Takes::Points) => {
                points.iter().for_each(|point| self.finite(&path, point));
                let points: Vec<String> = points.iter().map(|p| format!("[{}]", p.map(digits).join(", "))).collect();
                format!("[{}] m", points.join(", "))
            }
            _ => {
                let message = format!("`{field}` takes {}, not {value}", taken(entry));
                self.problem(&path, BuildCode::WrongKind, message, None);
                NOT_FINITE.into()
            }
        };
        self.line(before, path, format!("{field}{sign}{written}"))
    }
}
