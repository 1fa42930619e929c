//! Which statements belong in which block.

use super::statements::{BLOCKS, OPENERS};
use crate::diagnostic::nearest;

/// Where a statement is: the top level, or the block around it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    Top,
    Vehicle,
    /// `rotor { }` in a vehicle.
    Rotor,
    /// `rotors { }` in a vehicle.
    Rotors,
    /// `battery { }` in a vehicle.
    Battery,
    Faults,
    /// `mode` in `faults`.
    Mode,
    /// `every` in `faults`.
    Every,
    Mission,
    Curve,
    Limits,
    /// `keep_in { }` in a mission.
    KeepIn,
    /// `keep_out { }` in a mission.
    KeepOut,
    /// `air { }` in a mission.
    Air,
    Plan,
    /// `require capture_height { }` in a plan.
    Requirement,
    Simulate,
    Campaign,
    /// A block that could not be recognised: anything is allowed in it.
    Unknown,
}

/// The kind of a statement, as far as its place is concerned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Use,
    Let,
    Field,
    Block(Place),
    Every,
    Fault,
    RotorAt,
    /// `fault` in `simulate`.
    Strike,
    Curve,
    /// `start`, `end`, `waypoint`, `waypoints`, `hold`
    Flight,
    Limit,
    /// `require` in `plan`.
    Require,
}

/// Words that other languages and ground stations use, each with the word of this language. A word with several entries
/// means the first that fits its place, or else the first.
pub const OTHER_WORDS: &[(&str, &str)] = &[
    ("import", "use"),
    ("include", "use"),
    ("require", "use"),
    ("const", "let"),
    ("var", "let"),
    ("def", "let"),
    ("drone", "vehicle"),
    ("aircraft", "vehicle"),
    ("copter", "vehicle"),
    ("uav", "vehicle"),
    ("failures", "faults"),
    ("failure", "faults"),
    ("failure", "mode"),
    ("failure", "fault"),
    ("fault", "mode"),
    ("fail", "fault"),
    ("fails", "fault"),
    ("inject", "fault"),
    ("strike", "fault"),
    ("sim", "simulate"),
    ("montecarlo", "campaign"),
    ("monte_carlo", "campaign"),
    ("trials", "campaign"),
    ("flight", "mission"),
    ("goal", "waypoint"),
    ("target", "waypoint"),
    ("destination", "waypoint"),
    ("finish", "waypoint"),
    ("landing", "waypoint"),
    ("goto", "waypoint"),
    ("fly", "waypoint"),
    ("wait", "hold"),
    ("hover", "hold"),
    ("loiter", "hold"),
    ("takeoff", "start"),
    ("geofence", "keep_in"),
    ("fence", "keep_in"),
    ("obstacle", "keep_out"),
    ("no_fly", "keep_out"),
    ("weather", "air"),
    ("atmosphere", "air"),
    ("motor", "rotor"),
    ("motors", "rotors"),
    ("propeller", "rotor"),
    ("accumulator", "battery"),
    ("accu", "battery"),
];

impl Place {
    /// The block that `keyword` opens.
    pub fn of_block(keyword: &str) -> Option<Place> {
        BLOCKS.iter().find(|b| b.keyword == keyword).map(|b| b.place)
    }

    /// Whether `word` begins a statement in any block.
    pub fn opens_statement(word: &str) -> bool {
        OPENERS.iter().any(|o| o.1.contains(&word))
    }

    /// Whether `word` begins a statement without braces and is not a misspelling of a block that is allowed here: `fault {`
    /// at the top level is a misspelt `faults {`.
    pub fn has_braceless(self, word: &str) -> bool {
        let is_slip = || {
            self.meant(word).is_some_and(|meant| Place::of_block(meant).is_some() && self.openers().contains(&meant))
        };
        let fits = self.openers().contains(&word);
        Place::opens_statement(word) && Place::of_block(word).is_none() && (fits || !is_slip())
    }

    /// The block that a broken head was probably meant to open.
    pub fn of_head(word: &str) -> Option<Place> {
        match word {
            "curve" => Some(Place::Curve),
            "every" => Some(Place::Every),
            _ => Place::of_block(word),
        }
    }

    /// The keyword that opens this block, if it has a simple head.
    pub fn keyword(self) -> Option<&'static str> {
        BLOCKS.iter().find(|b| b.place == self).map(|b| b.keyword)
    }

    /// Whether the block has a name.
    pub fn is_named(self) -> bool {
        BLOCKS.iter().any(|b| b.place == self && b.is_named)
    }

    /// As messages name it: "in a `mission`".
    pub fn phrase(self) -> &'static str {
        match self {
            Place::Top => "at the top level",
            Place::Vehicle => "in a `vehicle`",
            Place::Rotor => "in a `rotor` block",
            Place::Rotors => "in a `rotors` block",
            Place::Battery => "in a `battery` block",
            Place::Faults => "in `faults`",
            Place::Mode => "in a `mode`",
            Place::Every => "in an `every` block",
            Place::Mission => "in a `mission`",
            Place::Curve => "in a `curve`",
            Place::Limits => "in `limits`",
            Place::KeepIn => "in a `keep_in`",
            Place::KeepOut => "in a `keep_out`",
            Place::Air => "in `air`",
            Place::Plan => "in a `plan`",
            Place::Requirement => "in a `require` block",
            Place::Simulate => "in `simulate`",
            Place::Campaign => "in `campaign`",
            Place::Unknown => "in this block",
        }
    }

    /// As messages name it after "of": "a `mission`".
    pub fn phrase_alone(self) -> &'static str {
        let phrase = self.phrase();
        phrase.strip_prefix("in ").unwrap_or(phrase)
    }

    /// The words that begin statements here.
    pub fn openers(self) -> &'static [&'static str] {
        OPENERS.iter().find(|o| o.0 == self).map_or(&[], |o| o.1)
    }

    /// The opening word that `word` was probably meant to be, preferably one that is allowed here.
    pub fn meant(self, word: &str) -> Option<&'static str> {
        let all = || OPENERS.iter().flat_map(|o| o.1.iter().copied());
        let others = || OTHER_WORDS.iter().filter(|(other, _)| *other == word).map(|(_, ours)| *ours);
        let other = || others().find(|ours| self.openers().contains(ours)).or_else(|| others().next());
        nearest(word, self.openers().iter().copied()).or_else(other).or_else(|| nearest(word, all()))
    }
}

impl Kind {
    /// Where such a statement belongs; `None` for fields, which occur in many places.
    pub fn home(self) -> Option<Place> {
        match self {
            Kind::Field => None,
            Kind::Use | Kind::Let => Some(Place::Top),
            Kind::Block(block) => BLOCKS.iter().find(|b| b.place == block).map(|b| b.within),
            Kind::Every => Some(Place::Faults),
            Kind::Fault => Some(Place::Mode),
            Kind::RotorAt => Some(Place::Rotors),
            Kind::Strike => Some(Place::Simulate),
            Kind::Require => Some(Place::Plan),
            Kind::Curve | Kind::Flight => Some(Place::Mission),
            Kind::Limit => Some(Place::Limits),
        }
    }

    /// Whether such a statement is allowed in `place`.
    pub fn fits(self, place: Place) -> bool {
        match self {
            _ if place == Place::Unknown => true,
            Kind::Field => !matches!(place, Place::Limits | Place::Rotors),
            _ => self.home() == Some(place),
        }
    }
}
