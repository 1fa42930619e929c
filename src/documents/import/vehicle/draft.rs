//! The text of a vehicle whose figures are known in part.

use crate::format::format;
use crate::import::estimate;
use crate::language::Group;
use crate::source::{FileId, Source};

/// A figure as it is written, with its unit.
#[derive(Debug, Clone, PartialEq)]
pub enum Figure {
    Known(String),
    /// Stands as `?`.
    Unknown,
}

impl Figure {
    /// A number of one precision with its unit, in the shortest form that reads back as the same number.
    pub fn single(value: f32, unit: &str) -> Self {
        Figure::Known(format!("{value} {unit}"))
    }

    fn text(&self) -> &str {
        match self {
            Figure::Known(text) => text,
            Figure::Unknown => "?",
        }
    }
}

/// A field with a remark behind it; an unknown one also has the rule by which it is estimated, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    pub name: &'static str,
    pub figure: Figure,
    pub remark: Option<String>,
}

impl Field {
    pub fn new(name: &'static str, figure: Figure) -> Self {
        Field { name, figure, remark: None }
    }

    pub fn remark(mut self, remark: impl Into<String>) -> Self {
        self.remark = Some(remark.into());
        self
    }

    fn line(&self, indent: &str) -> String {
        let rule = (self.figure == Figure::Unknown).then(|| estimate::rule(self.name)).flatten();
        let remarks: Vec<String> = self.remark.clone().into_iter().chain(rule).collect();
        let remark = if remarks.is_empty() { String::new() } else { format!("  // {}", remarks.join("; ")) };
        format!("{indent}{} = {}{remark}\n", self.name, self.figure.text())
    }
}

/// One rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// `[0.15, -0.2, 0] m`
    pub place: String,
    /// `P` or `N`.
    pub spin: Figure,
    pub motor: usize,
    /// Its own clauses.
    pub own: Vec<(&'static str, Figure)>,
    pub remark: Option<String>,
}

/// A vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct Draft {
    pub name: String,
    /// Where it comes from, for its first lines.
    pub from: Vec<String>,
    /// A documentation comment.
    pub title: Option<String>,
    /// `let` statements.
    pub lets: Vec<Field>,
    pub fields: Vec<Field>,
    /// Fields that the file lacks, estimated: they stand in comments.
    pub estimates: Vec<(&'static str, String, String)>,
    /// The fields of `rotor { }`.
    pub shared: Vec<Field>,
    pub rotors: Vec<Rotor>,
    /// The fields of `battery { }`; without any there is none.
    pub battery: Vec<Field>,
}

/// The fields of `battery { }`: capacity in mA h of the parameter `parameter`, and a voltage with its remark.
pub fn battery(capacity: f64, parameter: &str, voltage: Option<(f64, String)>) -> Vec<Field> {
    let voltage = match voltage {
        Some((volts, remark)) => Field::new("voltage", Figure::single(volts as f32, "V")).remark(remark),
        None => {
            Field::new("voltage", Figure::Unknown).remark("nominal: 3.7 V for each cell of a lithium polymer battery")
        }
    };
    vec![
        Field::new("capacity", Figure::single(capacity as f32, "mA*h")).remark(parameter),
        voltage,
        Field::new("hover_power", Figure::Unknown).remark("as a log of a hover shows it; or remove this block"),
    ]
}

/// Full thrust of one of `rotors` rotors of a vehicle that hovers with a share of it, from the `let` named `mass`, and
/// its remark.
pub fn full_thrust_from_hover(rotors: usize, share: f64, parameter: &str) -> (Figure, String) {
    let weight = format!("mass*{STANDARD_GRAVITY} m/s^2/({rotors}*{})", share as f32);
    (Figure::Known(weight), format!("hovers with {parameter} of full thrust"))
}

/// m/s^2
const STANDARD_GRAVITY: f64 = 9.80665;

impl Draft {
    /// The spec, laid out as `mavc fmt` does.
    pub fn text(&self) -> String {
        let mut out: String = self.from.iter().map(|line| format!("// {}\n", one_line(line))).collect();
        out.push('\n');
        for binding in &self.lets {
            out.push_str(&format!("let {}", binding.line("")));
        }
        out.push('\n');
        if let Some(title) = &self.title {
            out.push_str(&format!("/// {}\n", one_line(title)));
        }
        out.push_str(&format!("vehicle {} {{\n", self.name));
        self.fields.iter().for_each(|field| out.push_str(&field.line("    ")));
        let of_rotor = |(name, ..): &&(&'static str, String, String)| Group::Rotor.has(name);
        let comment = |(name, value, why): &(&'static str, String, String)| format!("// {name} = {value}  ({why})\n");
        let of_vehicle = self.estimates.iter().filter(|one| !of_rotor(one));
        of_vehicle.for_each(|one| out.push_str(&format!("    {}", comment(one))));
        out.push_str("    rotor {\n");
        self.shared.iter().for_each(|field| out.push_str(&field.line("        ")));
        self.estimates.iter().filter(of_rotor).for_each(|one| out.push_str(&format!("        {}", comment(one))));
        out.push_str("    }\n    rotors {\n");
        for rotor in &self.rotors {
            let own: String = rotor.own.iter().map(|(name, figure)| format!("  {name} {}", figure.text())).collect();
            let remark = rotor.remark.as_ref().map_or(String::new(), |text| format!("  // {text}"));
            out.push_str(&format!(
                "        rotor at {}  spin {}  motor {}{own}{remark}\n",
                rotor.place,
                rotor.spin.text(),
                rotor.motor
            ));
        }
        out.push_str("    }\n");
        if !self.battery.is_empty() {
            out.push_str("    battery {\n");
            self.battery.iter().for_each(|field| out.push_str(&field.line("        ")));
            out.push_str("    }\n");
        }
        out.push_str("}\n");
        laid_out(out)
    }
}

/// The text as `mavc fmt` lays it out.
pub fn laid_out(text: String) -> String {
    format(FileId(0), &Source::new("", text.clone())).value.unwrap_or(text)
}

/// A name of the language from any text: letters, digits and `_`, the first no digit.
pub fn name_from(text: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = text.chars().take(40).map(kept).collect();
    let name = name.trim_matches('_').split('_').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_");
    match name.chars().next() {
        None => "vehicle_1".into(),
        Some(first) if first.is_ascii_digit() => format!("v{name}"),
        Some(_) => name,
    }
}

/// A name from that of a file: without its folder and its ending.
pub fn name_from_file(file: &str) -> String {
    let last = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name_from(last.split_once('.').map_or(last, |(stem, _)| stem))
}

/// A foreign text within one comment: no control characters, not too long.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(200).collect()
}
