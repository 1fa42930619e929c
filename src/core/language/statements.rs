//! Which statements belong in which block: blocks, the words that begin statements, and a line of documentation for
//! each.

use super::place::{Place, StatementKind};
use crate::diagnostic::nearest;

/// A block with a simple head: a keyword, and a name if `is_named`.
#[derive(Debug, Clone, Copy)]
pub struct BlockEntry {
    pub keyword: &'static str,
    pub place: Place,
    /// Whether it has a name of its own.
    pub is_named: bool,
    /// The block around it.
    pub within: Place,
}

const fn block(keyword: &'static str, place: Place, is_named: bool, within: Place) -> BlockEntry {
    BlockEntry { keyword, place, is_named, within }
}

/// Every block with a simple head.
pub const BLOCKS: &[BlockEntry] = &[
    block("vehicle", Place::Vehicle, true, Place::Top),
    block("faults", Place::Faults, false, Place::Top),
    block("mission", Place::Mission, true, Place::Top),
    block("plan", Place::Plan, false, Place::Top),
    block("simulate", Place::Simulate, false, Place::Top),
    block("campaign", Place::Campaign, false, Place::Top),
    block("rotor", Place::Rotor, false, Place::Vehicle),
    block("rotors", Place::Rotors, false, Place::Vehicle),
    block("battery", Place::Battery, false, Place::Vehicle),
    block("parts", Place::Parts, false, Place::Vehicle),
    block("part", Place::Part, true, Place::Parts),
    block("mode", Place::Mode, true, Place::Faults),
    block("limits", Place::Limits, false, Place::Mission),
    block("keep_in", Place::KeepIn, true, Place::Mission),
    block("keep_out", Place::KeepOut, true, Place::Mission),
    block("air", Place::Air, false, Place::Mission),
    block("landing_site", Place::LandingSite, true, Place::Mission),
    block("keep_off", Place::KeepOff, true, Place::Mission),
    block("after_fault_limits", Place::AfterFaultLimits, false, Place::Mission),
    block("require", Place::Requirement, true, Place::Plan),
    block("recovery", Place::Recovery, false, Place::Plan),
];

/// The words that begin a statement in each place, other than fields.
pub const OPENERS: &[(Place, &[&str])] = &[
    (Place::Top, &["use", "let", "vehicle", "faults", "mission", "plan", "simulate", "campaign"]),
    (Place::Vehicle, &["rotor", "rotors", "battery", "parts"]),
    (Place::Parts, &["part"]),
    (Place::Rotors, &["rotor"]),
    (Place::Faults, &["every", "mode"]),
    (Place::Mode, &["rotor", "rotors"]),
    (
        Place::Mission,
        &[
            "curve",
            "start",
            "end",
            "waypoint",
            "waypoints",
            "hold",
            "limits",
            "keep_in",
            "keep_out",
            "air",
            "landing_site",
            "keep_off",
            "after_fault_limits",
        ],
    ),
    (Place::Plan, &["require", "recovery"]),
    (Place::Simulate, &["fault"]),
];

/// A statement other than a field.
#[derive(Debug, Clone, Copy)]
pub struct StatementEntry {
    /// Its first word.
    pub word: &'static str,
    /// Its form, as written in a spec.
    pub form: &'static str,
    /// One line of documentation, in Markdown.
    pub doc: &'static str,
}

const fn statement(word: &'static str, form: &'static str, doc: &'static str) -> StatementEntry {
    StatementEntry { word, form, doc }
}

/// Statements by the place where they belong. docs/language.md lists those of `vehicle` and `mission` in tables.
pub const STATEMENTS: &[(Place, &[StatementEntry])] = &[
    (
        Place::Top,
        &[
            statement("use", "use \"file.mav\"", "includes the blocks and `let`s of another file"),
            statement("let", "let NAME = EXPRESSION", "names a value; outside all blocks"),
            statement("vehicle", "vehicle NAME { }", "the mass, inertia and rotors of a vehicle"),
            statement("faults", "faults { }", "the fault modes: what may fail, one rotor or several at a time"),
            statement("mission", "mission NAME { }", "where to fly, in the order of flight, and within which limits"),
            statement("plan", "plan { }", "how the mission is planned, and against which fault modes"),
            statement("simulate", "simulate { }", "how the plan is flown, and which faults strike during the flight"),
            statement("campaign", "campaign { }", "how many flights are flown, with every fault mode at many instants"),
        ],
    ),
    (
        Place::Faults,
        &[
            statement("mode", "mode NAME \"title\" { }", "one fault mode; the title is optional"),
            statement(
                "every",
                "every k rotors EFFECT as NAME",
                "a mode for each choice of k rotors, named by the rotors in ascending order",
            ),
        ],
    ),
    (Place::Parts, &[statement("part", "part NAME { }", "one part: a box, or a point without `size`")]),
    (Place::Rotors, &[statement("rotor", "rotor at POSITION spin P", "places one rotor")]),
    (
        Place::Plan,
        &[
            statement(
                "require",
                "require risk <= BOUND",
                "lets the planner choose what to protect until the risk of the mission is at most this bound",
            ),
            statement(
                "require",
                "require capture_height { }",
                "keeps the height above the mission's `ground` that a fault without control of yaw costs, as simulated",
            ),
            statement(
                "require",
                "require uncovered <= SHARE",
                "bounds the share of the time without a way out [after a fault](#after-a-fault)",
            ),
            statement(
                "recovery",
                "recovery { }",
                "which ways out [after a fault](#after-a-fault) are sought, and how soon they end",
            ),
        ],
    ),
    (Place::Simulate, &[statement("fault", "fault NAME at TIME", "a declared fault mode strikes at this time")]),
    (
        Place::Vehicle,
        &[
            statement(
                "rotor",
                "rotor { }",
                "the properties that rotors share; required unless each rotor of `rotors` gives all of them itself",
            ),
            statement("rotors", "rotors { }", "places the rotors one by one, instead of `layout`, `arm` and `first`"),
            statement(
                "battery",
                "battery { }",
                "the battery, from which reports compute the charge that a plan leaves ([battery](#battery))",
            ),
            statement(
                "parts",
                "parts { }",
                "the parts, from which mass, centre of gravity and inertia follow ([parts](#parts))",
            ),
        ],
    ),
    (
        Place::Mission,
        &[
            statement(
                "start",
                "start at POSITION ...",
                "the first waypoint; without it the flight starts at the first waypoint that another statement \
                    gives",
            ),
            statement(
                "waypoint",
                "waypoint [NAME] at POSITION ...",
                "a point to fly through; its clauses may be in any order, and limits for the [leg](#legs) that \
                    ends here may follow in braces",
            ),
            statement(
                "curve",
                "curve NAME in RANGE, points = N { x = ...; y = ...; z = ... }",
                "N waypoints evenly spaced in the parameter, including both ends",
            ),
            statement("waypoints", "waypoints from \"file.csv\"", "reads waypoints from a table, one per row"),
            statement("hold", "hold TIME", "stays at rest at the previous waypoint"),
            statement("start", "start moving", "the mission need not start at rest"),
            statement("end", "end moving", "the mission need not end at rest"),
            statement(
                "limits",
                "limits { }",
                "bounds on the motion of the whole mission, such as `speed <= 8 m/s` ([limits](#limits))",
            ),
            statement("keep_in", "keep_in NAME { }", "a volume in which the whole vehicle stays ([volumes](#volumes))"),
            statement(
                "keep_out",
                "keep_out NAME { }",
                "a volume that no part of the vehicle enters ([volumes](#volumes))",
            ),
            statement("air", "air { }", "the wind and the density of the air ([air](#air))"),
            statement(
                "landing_site",
                "landing_site NAME { }",
                "a place where a damaged vehicle may land ([after a fault](#after-a-fault))",
            ),
            statement(
                "keep_off",
                "keep_off NAME { }",
                "an area that a damaged vehicle may fly over, but not land on ([after a fault](#after-a-fault))",
            ),
            statement(
                "after_fault_limits",
                "after_fault_limits { }",
                "limits that replace the mission's on the same quantities [after a fault](#after-a-fault)",
            ),
        ],
    ),
];

/// The effects of a fault on a rotor: keyword, form, remaining capacity, and meaning.
pub const EFFECTS: &[(&str, &str, &str, &str)] = &[
    ("lost", "lost", "0", "the rotor gives no thrust and no torque"),
    (
        "reduced",
        "reduced to 60 %",
        "0.6",
        "the rotor gives this share of the thrust and torque that belong to its speed",
    ),
    (
        "stuck",
        "stuck at 50 %",
        "1",
        "the thrust stays at this share of full thrust; at 50 % the rotor turns at 71 % of full speed",
    ),
];

/// The functions and constants of expressions, each with a line on its arguments and its value.
pub const FUNCTIONS: &[(&str, &str)] = &[
    ("pi", "a plain number"),
    ("g0", "the spec's gravity, an acceleration"),
    ("sin", "sine of an angle or a plain number (rad)"),
    ("cos", "cosine of an angle or a plain number (rad)"),
    ("tan", "tangent of an angle or a plain number (rad)"),
    ("asin", "arcsine of a plain number, an angle"),
    ("acos", "arccosine of a plain number, an angle"),
    ("atan", "arctangent of a plain number, an angle"),
    ("atan2", "`atan2(y, x)`: the angle of the point (x, y), from two values of one dimension"),
    ("sqrt", "square root; the root of `m^2` is `m`"),
    ("abs", "absolute value, with the same unit"),
    ("min", "the smallest of two or more values of one dimension"),
    ("max", "the largest of two or more values of one dimension"),
];

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
    ("geofence", "keep_in"),
    ("fence", "keep_in"),
    ("obstacle", "keep_out"),
    ("no_fly", "keep_out"),
    ("rally", "landing_site"),
    ("rally_point", "landing_site"),
    ("pad", "landing_site"),
    ("landing_pad", "landing_site"),
    ("landing_zone", "landing_site"),
    ("no_landing", "keep_off"),
    ("no_land", "keep_off"),
    ("contingency", "recovery"),
    ("weather", "air"),
    ("atmosphere", "air"),
    ("motor", "rotor"),
    ("motors", "rotors"),
    ("propeller", "rotor"),
    ("accumulator", "battery"),
    ("accu", "battery"),
    ("components", "parts"),
    ("component", "part"),
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

    /// Whether `word` begins a statement without braces and is not a misspelling of a block that is allowed here:
    /// `fault {` at the top level is a misspelt `faults {`.
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

impl StatementKind {
    /// Where such a statement belongs; `None` for fields, which occur in many places.
    pub fn home(self) -> Option<Place> {
        match self {
            StatementKind::Field => None,
            StatementKind::Use | StatementKind::Let => Some(Place::Top),
            StatementKind::Block(block) => BLOCKS.iter().find(|b| b.place == block).map(|b| b.within),
            StatementKind::Every => Some(Place::Faults),
            StatementKind::Fault => Some(Place::Mode),
            StatementKind::RotorAt => Some(Place::Rotors),
            StatementKind::Strike => Some(Place::Simulate),
            StatementKind::Require => Some(Place::Plan),
            StatementKind::Curve | StatementKind::Flight => Some(Place::Mission),
            StatementKind::Limit => Some(Place::Limits),
        }
    }

    /// Whether such a statement is allowed in `place`.
    pub fn fits(self, place: Place) -> bool {
        match self {
            _ if place == Place::Unknown => true,
            StatementKind::Field => !place.has_limits() && place != Place::Rotors,
            StatementKind::Limit => place.has_limits(),
            _ => self.home() == Some(place),
        }
    }
}
