//! The parameters in a file of an autopilot, with their places. Three forms are read:
//!
//! ```text
//! param set-default CA_ROTOR0_PX 0.15        airframe scripts of PX4
//! 1<tab>1<tab>CA_ROTOR0_PX<tab>0.15<tab>9    parameters saved by QGroundControl: vehicle, component, name, value, type
//! FRAME_CLASS,1                              parameters of ArduPilot; also with blanks in place of the comma
//! ```
//!
//! The columns of the second form may have blanks between them, as scripts of pymavlink print them. As ArduPilot reads
//! its files, a value may be hexadecimal (`0x0F`), and `@include FILE` names another file.

use crate::diagnostic::Diagnostic;
use crate::import::{ASSUMED, SYNTAX, at};
use crate::source::{Source, Span};
use std::collections::BTreeMap;

/// One parameter; of several with one name the last counts, as when an autopilot reads the file.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    pub value: f64,
    /// The place of the value.
    pub span: Span,
}

/// All parameters of a file.
#[derive(Debug, Default)]
pub struct Parameters<'s> {
    by_name: BTreeMap<&'s str, Parameter>,
    /// Whether a ground station saved them, which saves all.
    is_saved: bool,
    /// Values that a script works out, by name.
    worked_out: BTreeMap<&'s str, Span>,
    /// The first file that this one includes, with its place.
    included: Option<(&'s str, Span)>,
    /// Names that are set to different values: the place of one value and that of the last.
    repeated: BTreeMap<&'s str, (Span, Span)>,
}

impl<'s> Parameters<'s> {
    pub fn get(&self, name: &str) -> Option<Parameter> {
        self.by_name.get(name).copied()
    }

    pub fn is_of(&self, name: &str) -> bool {
        self.by_name.contains_key(name)
    }

    /// Whether some name begins so.
    pub fn has_prefix(&self, prefix: &str) -> bool {
        self.names().any(|name| name.starts_with(prefix))
    }

    pub fn names(&self) -> impl Iterator<Item = &'s str> {
        self.by_name.keys().copied()
    }

    /// The first parameter whose name begins so and whose value a script works out.
    pub fn worked_out(&self, prefix: &str) -> Option<(&'s str, Span)> {
        self.worked_out.iter().map(|(name, span)| (*name, *span)).find(|(name, _)| name.starts_with(prefix))
    }

    /// Names that are set to different values, with the place of one value and that of the last.
    pub fn repeated(&self) -> impl Iterator<Item = (&'s str, Span, Span)> {
        self.repeated.iter().map(|(name, (first, last))| (*name, *first, *last))
    }

    /// The first file that this one includes, which is not read.
    pub fn included(&self) -> Option<(&'s str, Span)> {
        self.included
    }

    /// Whether QGroundControl saved the file, with every parameter that the vehicle has.
    pub fn is_saved(&self) -> bool {
        self.is_saved
    }

    fn set(&mut self, name: &'s str, parameter: Parameter) {
        self.worked_out.remove(name);
        if let Some(before) = self.by_name.insert(name, parameter)
            && before.value != parameter.value
        {
            self.repeated.insert(name, (before.span, parameter.span));
        }
    }

    /// The place of the first value in the file.
    pub fn first(&self) -> Option<Span> {
        self.by_name.values().map(|parameter| parameter.span).min()
    }
}

/// The warning for a name that is set to different values, of those of [`Parameters::repeated`].
pub fn set_twice(name: &str, first: Span, last: Span) -> Diagnostic {
    let warning = Diagnostic::warning(ASSUMED, last, format!("`{name}` is set twice: the spec has this value"));
    let warning = warning.here("the last").also(first, "another value");
    warning.help("if both are in conditional parts, keep only the one that applies")
}

/// Reads the parameters; lines of a script that set none are passed over.
///
/// # Errors
/// A line that begins like a parameter and is none: a part is missing, or its value is not a finite number.
pub fn read(source: &Source) -> Result<Parameters<'_>, Box<Diagnostic>> {
    let mut found = Parameters::default();
    let mut start = 0;
    for line in source.text.split_inclusive('\n') {
        let code = &line[..line.find('#').unwrap_or(line.len())];
        if let Some(name) = code.strip_prefix("@include").map(str::trim).filter(|name| !name.is_empty()) {
            let from = start + (name.as_ptr() as usize - code.as_ptr() as usize);
            found.included.get_or_insert((name, at(from..from + name.len())));
        }
        if let Some((name, value)) = parts(code) {
            found.is_saved |= code.starts_with(|c: char| c.is_ascii_digit());
            let value = value.ok_or_else(|| incomplete(source, start, code, name))?;
            if value.starts_with(['$', '`']) {
                let from = start + (value.as_ptr() as usize - code.as_ptr() as usize);
                found.worked_out.insert(name, at(from..from + value.len()));
            } else {
                found.set(name, number(source, start, code, value)?);
            }
        }
        start += line.len();
    }
    Ok(found)
}

/// The name and the value of a line, the value `None` where the line ends before it; `None` if no parameter is set.
fn parts(code: &str) -> Option<(&str, Option<&str>)> {
    let is_name = |word: &&str| {
        let fits = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
        word.starts_with(|c: char| c.is_ascii_uppercase()) && word.len() > 2 && word.chars().all(fits)
    };
    let mut words = code.split_whitespace();
    let first = words.next()?;
    if first == "param" {
        words.next().filter(|verb| matches!(*verb, "set" | "set-default"))?;
        // Options of the command are passed over.
        let mut rest = words.skip_while(|word| word.starts_with('-'));
        return Some((rest.next().filter(is_name)?, rest.next()));
    }
    if first.bytes().all(|b| b.is_ascii_digit()) {
        // Ground stations put tabs between the columns, scripts of pymavlink blanks.
        let (tabs, blanks) = (code.trim_end().split('\t').map(str::trim), code.split_whitespace());
        let mut columns: Box<dyn Iterator<Item = &str>> =
            if code.contains('\t') { Box::new(tabs) } else { Box::new(blanks) };
        let name = columns.nth(2).filter(is_name)?;
        let value = columns.next().filter(|value| !value.is_empty());
        // The type ends a whole line.
        return Some((name, value.filter(|_| columns.next().is_some())));
    }
    let mut pieces = code.split([',', ' ', '\t', '\r', '\n', '=']).filter(|piece| !piece.is_empty());
    let name = pieces.next().filter(is_name).filter(|name| name.contains('_') || *name == "FRAME")?;
    Some((name, pieces.next()))
}

fn number(source: &Source, start: usize, code: &str, value: &str) -> Result<Parameter, Box<Diagnostic>> {
    let from = start + (value.as_ptr() as usize - code.as_ptr() as usize);
    let span = at(from..from + value.len());
    let hexadecimal = value.strip_prefix("0x").or_else(|| value.strip_prefix("0X"));
    let parsed = match hexadecimal {
        Some(digits) => u32::from_str_radix(digits, 16).ok().map(f64::from),
        None => value.parse::<f64>().ok(),
    };
    // Autopilots keep parameters in single precision.
    match parsed.filter(|value| (*value as f32).is_finite()) {
        Some(value) => Ok(Parameter { value, span }),
        None => {
            let shown: String = value.chars().take(24).collect();
            let error =
                Diagnostic::error(SYNTAX, span, format!("`{shown}` is not a finite number of single precision"));
            let line = source.place(from).line;
            Err(Box::new(error.here("the value of a parameter").help(format!("mend line {line}, or remove it"))))
        }
    }
}

fn incomplete(source: &Source, start: usize, code: &str, name: &str) -> Box<Diagnostic> {
    let from = start + (name.as_ptr() as usize - code.as_ptr() as usize);
    let end = (start + code.trim_end().len()).max(from + name.len());
    let error = Diagnostic::error(SYNTAX, at(from..end), format!("the line of `{name}` is not complete"));
    let line = source.place(from).line;
    Box::new(error.here("no value, or no type after it").help(format!("save the file again, or remove line {line}")))
}
