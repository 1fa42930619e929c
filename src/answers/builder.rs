//! Specs from Rust values instead of text.

mod after_fault;
mod mission;

use crate::diagnostic::{Diagnostic, Severity, nearest};
use crate::format;
use crate::language::{Entry, Group, Takes};
use crate::spec::{Compiled, Compiler, Spec};
use crate::unit::parse_unit;
use std::error::Error;
use std::fmt::{self, Write};
use std::io::ErrorKind;

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

/// A statement, with the call of the builder that it comes from.
#[derive(Debug, Clone)]
struct Line {
    path: String,
    text: String,
    /// The call has a [`BuildProblem`] already; what the compiler finds in its line is not reported again.
    is_reported: bool,
}

impl Line {
    fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Line { path: path.into(), text: text.into(), is_reported: false }
    }
}

/// A block with a name.
#[derive(Debug, Clone)]
struct Named {
    /// What calls are named by.
    path: String,
    keyword: &'static str,
    name: String,
    fields: Vec<Line>,
}

#[derive(Debug, Clone)]
struct Mode {
    name: String,
    effects: Vec<Line>,
    fields: Vec<Line>,
}

/// The value of a field.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number, in SI units.
    Number(f64),
    /// Three numbers, in SI units.
    Vector([f64; 3]),
    /// A word of the language, a name, or a text.
    Word(String),
    /// Several words or names.
    Names(Vec<String>),
    /// Points `[x, y]` of a plane, in SI units.
    Points(Vec<[f64; 2]>),
}

/// Values of other types, each with the expression that makes a [`Value`] of `given`.
macro_rules! values {
    ($($type:ty $([$n:ident])? => |$given:ident| $value:expr;)*) => {$(
        impl $(<const $n: usize>)? From<$type> for Value {
            fn from($given: $type) -> Self {
                $value
            }
        }
    )*};
}

values! {
    f64 => |number| Value::Number(number);
    i32 => |number| Value::Number(number.into());
    u32 => |number| Value::Number(number.into());
    usize => |number| Value::Number(number as f64);
    [f64; 3] => |vector| Value::Vector(vector);
    &str => |word| Value::Word(word.into());
    String => |word| Value::Word(word);
    [&str; N] [N] => |names| Value::Names(names.map(String::from).into());
    Vec<String> => |names| Value::Names(names);
    [[f64; 2]; N] [N] => |points| Value::Points(points.into());
    Vec<[f64; 2]> => |points| Value::Points(points);
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

    /// The formatted text of the spec so far. Where a call has a problem, another word or number that is wrong too
    /// replaces the value.
    pub fn text(&self) -> String {
        let text: String = self.lines().into_iter().map(|line| line.text + "\n").collect();
        // Formatting keeps lines, so each line still belongs to the same call.
        format(&text).unwrap_or(text)
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

    /// The text, each line with the call that it comes from.
    fn lines(&self) -> Vec<Line> {
        let mut lines = self.top.clone();
        let mut block = |path: &str, head: &str, body: Vec<Line>| {
            let line = |text: String| Line::new(path, text);
            lines.push(line(format!("{head} {{")));
            lines.extend(body.into_iter().map(|inner| Line { text: format!("    {}", inner.text), ..inner }));
            lines.push(line("}".into()));
        };
        let nested = |path: &str, head: &str, body: &[Line]| -> Vec<Line> {
            let line = |text: String| Line::new(path, text);
            let inner = body.iter().map(|inner| Line { text: format!("    {}", inner.text), ..inner.clone() });
            [line(format!("{head} {{"))].into_iter().chain(inner).chain([line("}".into())]).collect()
        };
        let mut vehicle = self.vehicle.clone();
        let part =
            |Named { path, keyword, name, fields }: &Named| nested(path, &format!("{keyword} {}", word(name)), fields);
        let parts: Vec<Line> = self.parts.iter().cloned().chain(self.part.iter().flat_map(part)).collect();
        for (path, head, body) in [
            ("vehicle.rotor", "rotor", &self.rotor),
            ("vehicle.rotors", "rotors", &self.placed),
            ("vehicle.battery", "battery", &self.battery),
            ("vehicle.parts", "parts", &parts),
        ] {
            if !body.is_empty() {
                vehicle.extend(nested(path, head, body));
            }
        }
        block("vehicle", "vehicle craft", vehicle);
        if !self.modes.is_empty() {
            let of_mode = |mode: &Mode| {
                let body: Vec<Line> = mode.effects.iter().chain(&mode.fields).cloned().collect();
                nested(&format!("modes.{}", mode.name), &format!("mode {}", word(&mode.name)), &body)
            };
            block("modes", "faults", self.modes.iter().flat_map(of_mode).collect());
        }
        let mut mission = self.mission.clone();
        for Named { path, keyword, name, fields } in self.volumes.iter().chain(&self.places) {
            mission.extend(nested(path, &format!("{keyword} {}", word(name)), fields));
        }
        for (path, head, body) in [
            ("mission.limits", "limits", &self.limits),
            ("mission.after_fault_limits", "after_fault_limits", &self.after_fault_limits),
        ] {
            if !body.is_empty() {
                mission.extend(nested(path, head, body));
            }
        }
        let mut plan = self.plan.clone();
        if !self.recovery.is_empty() {
            plan.extend(nested("plan.recovery", "recovery", &self.recovery));
        }
        if !(mission.is_empty() && plan.is_empty()) {
            block("mission", "mission flight", mission);
        }
        for (name, body) in [("plan", plan), ("simulate", self.simulate.clone()), ("campaign", self.campaign.clone())] {
            if !body.is_empty() {
                block(name, name, body);
            }
        }
        lines
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
            // No other field takes points.
            (Value::Points(points), Takes::Names(_)) if matches!(group, Group::Volume | Group::KeepOff) => {
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

/// A number that the compiler rejects as too large. It replaces a value with a [`BuildProblem`], so that its field is
/// not missing.
const NOT_FINITE: &str = "1e999";

/// A number with all its digits, so that reading it gives the same number.
fn digits(number: f64) -> String {
    match number.abs() {
        _ if !number.is_finite() => NOT_FINITE.into(),
        size if size == 0.0 || (1e-5..1e15).contains(&size) => format!("{number}"),
        _ => format!("{number:e}"),
    }
}

/// A word as a name of the language: with `_` for every character that a name may not have there.
fn word(text: &str) -> String {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    let first = if text.starts_with(is_letter) { "" } else { "_" };
    let rest = text.chars().map(|c| if is_letter(c) || c.is_ascii_digit() { c } else { '_' });
    first.chars().chain(rest).collect()
}

/// The SI unit of an entry after a space; empty for a plain number.
fn unit(entry: &Entry) -> String {
    let Some((usual, unit)) = entry.unit().and_then(|unit| Some((unit, parse_unit(unit, 1.0).ok()?))) else {
        return String::new();
    };
    match usual {
        "1" => String::new(),
        _ if unit.numerator == unit.denominator => format!(" {usual}"),
        _ => format!(" {}", unit.dimension),
    }
}

/// A description of the values that an entry takes.
fn taken(entry: &Entry) -> String {
    let words = entry.words().iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
    match entry.takes {
        Takes::Quantity(..) | Takes::QuantityOrShare(..) | Takes::Bound(..) | Takes::Share | Takes::Whole(..) => {
            "a number".into()
        }
        Takes::Vector(..) | Takes::PlanePoint(_) => "three numbers".into(),
        Takes::QuantityOrVector(..) => "a number or three numbers".into(),
        Takes::QuantityOr(..) => format!("a number or one of {words}"),
        Takes::Words(_) => format!("one of {words}"),
        Takes::WordList(_) => format!("one or more of {words}"),
        Takes::Nothing => "no value".into(),
        Takes::Text => "a text without quotes and control characters".into(),
        Takes::Names(_) => "a name or a list of names".into(),
        Takes::NameList(_) => "a list of names".into(),
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(number) => write!(f, "the number {number}"),
            Value::Vector(_) => f.write_str("three numbers"),
            Value::Word(word) => write!(f, "{word:?}"),
            Value::Names(_) => f.write_str("a list of names"),
            Value::Points(_) => f.write_str("a list of points"),
        }
    }
}

/// Mistakes that the builder finds before the text is compiled.
enum BuildCode {
    NotFinite,
    NotAName,
    UnknownField,
    UnknownMode,
    UnknownVolume,
    WrongKind,
}

impl BuildCode {
    fn code(self) -> &'static str {
        match self {
            BuildCode::NotFinite => "mavc::unit::not_finite",
            BuildCode::NotAName => "mavc::name::reserved",
            BuildCode::UnknownField => "mavc::name::unknown_field",
            BuildCode::UnknownMode | BuildCode::UnknownVolume => "mavc::name::unknown",
            BuildCode::WrongKind => "mavc::unit::kind",
        }
    }
}

/// One mistake in a built spec, or a warning about it.
#[derive(Debug, Clone, PartialEq)]
pub struct BuildProblem {
    /// The call that made it, such as `plan.samples` or `mission.waypoints[2]`; the block, if something is missing in
    /// it.
    pub field: String,
    /// The code of the mistake, for `mavc explain`.
    pub code: &'static str,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What is wrong with the value that was given, such as `this is 9`.
    pub label: Option<String>,
    /// One action that fixes the problem.
    pub help: Option<String>,
}

#[deprecated = "renamed to `BuildProblem`"]
pub type Problem = BuildProblem;

/// `{field}: {message}: {label}; {help} ({code})`
impl fmt::Display for BuildProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.field, self.message)?;
        if let Some(label) = &self.label {
            write!(f, ": {label}")?;
        }
        if let Some(help) = &self.help {
            write!(f, "; {}", help.lines().map(str::trim).collect::<Vec<_>>().join("; "))?;
        }
        write!(f, " ({})", self.code)
    }
}

/// The mistakes in a built spec.
#[derive(Clone, PartialEq)]
pub struct BuildError {
    pub problems: Vec<BuildProblem>,
    /// The text that was built.
    pub text: String,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.problems.iter().map(BuildProblem::to_string).collect::<Vec<_>>().join("\n"))
    }
}

/// The text of `Display` on a new line, because a `main` that returns the error prints it so.
impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for BuildError {}
