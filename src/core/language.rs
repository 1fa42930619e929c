//! The language as one table: every block, statement, field, clause and limit with its type, its default and one line
//! of documentation.
//!
//! - What comes in: a text, for [`syntax`].
//! - What goes out: its tree; rows of the table.
//! - What it does not know: what a field does to a vehicle or a plan.
//!
//! The readers of specs, completion and hover in editors, `check --explain-defaults` and the builder of specs take
//! names, units, words, ranges and defaults from here. docs/language.md, grammar/mav.pest and the editors'
//! grammars are written from it (tests/it/language/generated.rs). To add a field, add its row in [`table`], read it in
//! `read`, and use it.

mod columns;
pub mod format;
#[cfg(test)]
mod made_up_field;
mod place;
mod render;
mod statements;
pub mod syntax;
pub mod table;
mod words;

pub use columns::{clauses, is_clause, sweepable};
pub use place::{Place, StatementKind};
pub use render::{markdown, statement_markdown};
pub use statements::{BLOCKS, BlockEntry, EFFECTS, FUNCTIONS, OPENERS, OTHER_WORDS, STATEMENTS, StatementEntry};
pub use words::word_list;

/// One field, clause or limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    pub name: &'static str,
    pub takes: Takes,
    pub absent: Absent,
    /// One line of documentation, in Markdown.
    pub doc: &'static str,
    /// Fields and blocks beside which it may not be written. A pair stands in one of its two rows; see
    /// [`Group::rivals`].
    pub excludes: &'static [&'static str],
    /// Whether the verdict, the margin or the yaw-free word of a mode depends on it.
    pub sweepable: bool,
    /// The smallest nonzero and the largest magnitude, in SI units; `None` for the bounds of any quantity
    /// (`spec/read/magnitude.rs`).
    pub bounds: Option<(f64, f64)>,
    /// The units that a bare number was probably meant in; empty where only the usual unit is likely.
    pub likely: Sizes,
    /// The fields for which its value may have been meant.
    pub family: Option<Family>,
}

/// Upper bounds of a number's size in ascending order, each with the likely units of smaller numbers, the likelier
/// first.
pub type Sizes = &'static [(f64, &'static [&'static str])];

/// Related fields of different dimensions: a value of one may have been written for another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    Motion,
    Thrust,
    Torque,
    Mass,
    Tolerance,
}

/// The type of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Takes {
    /// A number with a unit; the usual unit, `1` for a plain number.
    Quantity(&'static str, Range),
    /// `[x, y, z]` with a unit; the usual unit.
    Vector(&'static str, Range),
    /// `[x, y]` or `[x, y, z]` with a unit, of which the height does not matter; the usual unit.
    PlanePoint(&'static str),
    /// A number with a unit, or `[x, y, z]`; the usual unit.
    QuantityOrVector(&'static str, Range),
    /// A number with a unit, or a share of the largest value, as in `-60 %`; the usual unit.
    QuantityOrShare(&'static str, Range),
    /// A bound on a quantity; the usual unit and the allowed forms.
    Bound(&'static str, &'static [&'static str]),
    /// `60 %` or `0.6`.
    Share,
    /// A whole number from the first to the second bound, inclusive.
    Whole(u64, u64),
    /// One of a few words.
    Words(&'static [&'static str]),
    /// A quantity, or one of a few words instead.
    QuantityOr(&'static str, Range, &'static [&'static str]),
    /// A word or a list of words.
    WordList(&'static [&'static str]),
    /// Text in quotes.
    Text,
    /// No value: the word alone.
    Nothing,
    /// A name or a choice of names, explained by the documentation line; words that are accepted as well.
    Names(&'static [&'static str]),
    /// A list of names, explained by the documentation line; words that are accepted as well.
    NameList(&'static [&'static str]),
    /// A list of points in the plane, in m.
    Points,
}

/// The allowed values of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    Any,
    /// Greater than zero.
    Positive,
    /// Zero or above.
    NotNegative,
}

/// What applies if a field is not written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Absent {
    /// The field is required.
    Needed,
    /// The value comes from elsewhere, or another field is required: the text of the table's default column.
    Otherwise(&'static str),
    /// A default value in SI units, as written in a spec, with its meaning.
    Value(f64, &'static str, &'static str),
    /// A default word, list or other text, as written in a spec, with its meaning.
    Written(&'static str, &'static str),
}

/// The fields of one block, or the clauses of one statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    Top,
    Vehicle,
    /// The fields of `rotor { }`.
    Rotor,
    /// The clauses of `rotor` in `rotors { }`.
    PlacedRotor,
    Battery,
    Parts,
    /// The fields of one `part` in `parts { }`.
    Part,
    /// The fields of `mode` and `every`.
    Mode,
    /// The fields of `mission`, beside its statements.
    Mission,
    Curve,
    /// The options after the range of a `curve`.
    CurveHead,
    /// The clauses of `start` and `waypoint`.
    Waypoint,
    Limits,
    /// The fields of `keep_in` and `keep_out`.
    Volume,
    Air,
    LandingSite,
    KeepOff,
    AfterFaultLimits,
    Plan,
    /// The fields of `require capture_height`.
    Requirement,
    /// The fields of `recovery` in `plan`.
    Recovery,
    Simulate,
    /// The clauses of `fault` in `simulate`.
    Strike,
    Campaign,
    /// No fields.
    Nothing,
}

impl Group {
    /// Every group that has entries.
    pub const ALL: [Group; 24] = [
        Group::Top,
        Group::Vehicle,
        Group::Rotor,
        Group::PlacedRotor,
        Group::Battery,
        Group::Parts,
        Group::Part,
        Group::Mode,
        Group::Mission,
        Group::Curve,
        Group::CurveHead,
        Group::Waypoint,
        Group::Limits,
        Group::Volume,
        Group::Air,
        Group::LandingSite,
        Group::KeepOff,
        Group::AfterFaultLimits,
        Group::Plan,
        Group::Requirement,
        Group::Recovery,
        Group::Simulate,
        Group::Strike,
        Group::Campaign,
    ];

    /// The fields of a block.
    pub fn of_block(place: Place) -> Self {
        match place {
            Place::Top => Group::Top,
            Place::Vehicle => Group::Vehicle,
            Place::Rotor => Group::Rotor,
            Place::Battery => Group::Battery,
            Place::Parts => Group::Parts,
            Place::Part => Group::Part,
            Place::Mode | Place::Every => Group::Mode,
            Place::Curve => Group::Curve,
            Place::Limits => Group::Limits,
            Place::KeepIn | Place::KeepOut => Group::Volume,
            Place::Air => Group::Air,
            Place::LandingSite => Group::LandingSite,
            Place::KeepOff => Group::KeepOff,
            Place::AfterFaultLimits => Group::AfterFaultLimits,
            Place::Mission => Group::Mission,
            Place::Plan => Group::Plan,
            Place::Requirement => Group::Requirement,
            Place::Recovery => Group::Recovery,
            Place::Simulate => Group::Simulate,
            Place::Campaign => Group::Campaign,
            Place::Rotors | Place::Faults | Place::Unknown => Group::Nothing,
        }
    }

    /// The clauses of a statement that begins with `opener`, in a block.
    pub fn of_statement(place: Place, opener: &str) -> Self {
        match (place, opener) {
            (Place::Rotors, "rotor") => Group::PlacedRotor,
            (Place::Mission, "start" | "waypoint") => Group::Waypoint,
            (Place::Simulate, "fault") => Group::Strike,
            _ => Group::Nothing,
        }
    }

    /// Every group whose entries may occur in a block: in its fields, its statements or their heads.
    pub fn within(place: Place) -> &'static [Group] {
        match place {
            Place::Rotors => &[Group::PlacedRotor],
            Place::Mission => &[Group::Mission, Group::Waypoint],
            Place::Curve => &[Group::Curve, Group::CurveHead],
            Place::Simulate => &[Group::Simulate, Group::Strike],
            Place::Top => &[Group::Top],
            Place::Vehicle => &[Group::Vehicle],
            Place::Rotor => &[Group::Rotor],
            Place::Battery => &[Group::Battery],
            Place::Parts => &[Group::Parts],
            Place::Part => &[Group::Part],
            Place::Mode | Place::Every => &[Group::Mode],
            Place::Limits => &[Group::Limits],
            Place::KeepIn | Place::KeepOut => &[Group::Volume],
            Place::Air => &[Group::Air],
            Place::LandingSite => &[Group::LandingSite],
            Place::KeepOff => &[Group::KeepOff],
            Place::AfterFaultLimits => &[Group::AfterFaultLimits],
            Place::Plan => &[Group::Plan],
            Place::Requirement => &[Group::Requirement],
            Place::Recovery => &[Group::Recovery],
            Place::Campaign => &[Group::Campaign],
            Place::Faults | Place::Unknown => &[],
        }
    }

    /// The rows of the group, in the order of the table.
    pub fn entries(self) -> &'static [&'static Entry] {
        match self {
            Group::Top => table::top::ENTRIES,
            Group::Vehicle => table::vehicle::ENTRIES,
            Group::Rotor => table::rotor::ENTRIES,
            Group::PlacedRotor => table::placed_rotor::ENTRIES,
            Group::Battery => table::battery::ENTRIES,
            Group::Parts => table::parts::ENTRIES,
            Group::Part => table::part::ENTRIES,
            Group::Mode => table::mode::ENTRIES,
            Group::Mission => table::mission::ENTRIES,
            Group::Curve => table::curve::ENTRIES,
            Group::CurveHead => table::curve_head::ENTRIES,
            Group::Waypoint => table::waypoint::ENTRIES,
            Group::Limits => table::limits::ENTRIES,
            Group::Volume => table::volume::ENTRIES,
            Group::Air => table::air::ENTRIES,
            Group::LandingSite => table::landing_site::ENTRIES,
            Group::KeepOff => table::keep_off::ENTRIES,
            Group::AfterFaultLimits => table::after_fault_limits::ENTRIES,
            Group::Plan => table::plan::ENTRIES,
            Group::Requirement => table::requirement::ENTRIES,
            Group::Recovery => table::recovery::ENTRIES,
            Group::Simulate => table::simulate::ENTRIES,
            Group::Strike => table::strike::ENTRIES,
            Group::Campaign => table::campaign::ENTRIES,
            Group::Nothing => &[],
        }
    }

    /// The row of the field or clause `name`.
    pub fn entry(self, name: &str) -> Option<&'static Entry> {
        self.entries().iter().copied().find(|entry| entry.name == name)
    }

    /// The names of the fields or clauses, in the order of the table.
    pub fn names(self) -> impl Iterator<Item = &'static str> + Clone {
        self.entries().iter().map(|entry| entry.name)
    }

    /// Whether the group has a field or clause `name`.
    pub fn has(self, name: &str) -> bool {
        self.entry(name).is_some()
    }
}

impl Entry {
    const fn new(name: &'static str, takes: Takes, absent: Absent, doc: &'static str) -> Self {
        Entry { name, takes, absent, doc, excludes: &[], sweepable: false, bounds: None, likely: &[], family: None }
    }

    /// The usual unit, `1` for a plain number; `None` for a field that takes no number.
    pub const fn unit(&self) -> Option<&'static str> {
        match self.takes {
            Takes::Quantity(unit, _)
            | Takes::Vector(unit, _)
            | Takes::PlanePoint(unit)
            | Takes::QuantityOrVector(unit, _)
            | Takes::QuantityOrShare(unit, _)
            | Takes::Bound(unit, _)
            | Takes::QuantityOr(unit, _, _) => Some(unit),
            Takes::Share | Takes::Whole(..) => Some("1"),
            Takes::Words(_)
            | Takes::WordList(_)
            | Takes::Text
            | Takes::Nothing
            | Takes::Names(_)
            | Takes::NameList(_)
            | Takes::Points => None,
        }
    }

    /// The words that it accepts as values.
    pub const fn words(&self) -> &'static [&'static str] {
        match self.takes {
            Takes::Words(words)
            | Takes::WordList(words)
            | Takes::QuantityOr(_, _, words)
            | Takes::Names(words)
            | Takes::NameList(words) => words,
            _ => &[],
        }
    }

    /// The relations that a limit accepts, such as `<=`; empty for other fields.
    pub const fn forms(&self) -> &'static [&'static str] {
        match self.takes {
            Takes::Bound(_, forms) => forms,
            _ => &[],
        }
    }

    /// The default, as written in a spec, and its meaning; `None` if there is no fixed default.
    pub const fn default(&self) -> Option<(&'static str, &'static str)> {
        match self.absent {
            Absent::Value(_, written, why) | Absent::Written(written, why) => Some((written, why)),
            Absent::Needed | Absent::Otherwise(_) => None,
        }
    }

    /// The default value in SI units.
    ///
    /// # Panics
    /// If the field has no default value; in a constant this is a compile error.
    pub const fn value(&self) -> f64 {
        match self.absent {
            Absent::Value(value, ..) => value,
            _ => panic!("this entry has no default value"),
        }
    }

    /// The smallest and the largest whole number that it accepts.
    ///
    /// # Panics
    /// If the field takes no whole number; in a constant this is a compile error.
    pub const fn whole(&self) -> (u64, u64) {
        match self.takes {
            Takes::Whole(least, most) => (least, most),
            _ => panic!("this entry takes no whole number"),
        }
    }
}
