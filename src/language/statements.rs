//! Blocks, the words that begin a statement, and what each says.

use super::place::Place;

/// A braced block with a plain head.
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

pub const BLOCKS: &[BlockEntry] = &[
    block("vehicle", Place::Vehicle, true, Place::Top),
    block("faults", Place::Faults, false, Place::Top),
    block("mission", Place::Mission, true, Place::Top),
    block("plan", Place::Plan, false, Place::Top),
    block("simulate", Place::Simulate, false, Place::Top),
    block("campaign", Place::Campaign, false, Place::Top),
    block("rotor", Place::Rotor, false, Place::Vehicle),
    block("rotors", Place::Rotors, false, Place::Vehicle),
    block("mode", Place::Mode, true, Place::Faults),
    block("limits", Place::Limits, false, Place::Mission),
];

/// The words that begin a statement in each place, fields aside.
pub const OPENERS: &[(Place, &[&str])] = &[
    (Place::Top, &["use", "let", "vehicle", "faults", "mission", "plan", "simulate", "campaign"]),
    (Place::Vehicle, &["rotor", "rotors"]),
    (Place::Rotors, &["rotor"]),
    (Place::Faults, &["every", "mode"]),
    (Place::Mode, &["rotor", "rotors"]),
    (Place::Mission, &["curve", "start", "end", "waypoint", "waypoints", "hold", "limits"]),
    (Place::Plan, &["require"]),
    (Place::Simulate, &["fault"]),
];

/// A statement that has a form of its own.
#[derive(Debug, Clone, Copy)]
pub struct StatementEntry {
    /// The word that it begins with.
    pub word: &'static str,
    /// As one writes it.
    pub form: &'static str,
    /// One line of Markdown.
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
            statement("use", "use \"file.mav\"", "brings in the blocks and `let`s of another file"),
            statement("let", "let NAME = EXPRESSION", "names a value, outside all blocks"),
            statement("vehicle", "vehicle NAME { }", "the mass, inertia and rotors of a vehicle"),
            statement("faults", "faults { }", "the fault modes: what may fail, one rotor or several at a time"),
            statement("mission", "mission NAME { }", "where to fly, in the order of flight, and within which limits"),
            statement("plan", "plan { }", "how the mission is planned, and against which fault modes"),
            statement("simulate", "simulate { }", "how the plan is flown, and which faults strike on the way"),
            statement("campaign", "campaign { }", "how many flights are flown, with every fault mode at many instants"),
        ],
    ),
    (
        Place::Faults,
        &[
            statement("mode", "mode NAME \"title\" { }", "one fault mode; the title may be left out"),
            statement(
                "every",
                "every k rotors EFFECT as NAME",
                "a mode for each choice of k rotors, named by the rotors in ascending order",
            ),
        ],
    ),
    (Place::Rotors, &[statement("rotor", "rotor at POSITION spin P", "places one rotor")]),
    (
        Place::Plan,
        &[statement(
            "require",
            "require risk <= BOUND",
            "lets the planner choose what to protect, until the risk of the mission is at most this",
        )],
    ),
    (Place::Simulate, &[statement("fault", "fault NAME at TIME", "a declared fault mode strikes at this time")]),
    (
        Place::Vehicle,
        &[
            statement(
                "rotor",
                "rotor { }",
                "what the rotors have in common; required unless each of `rotors` gives everything itself",
            ),
            statement("rotors", "rotors { }", "places the rotors one by one, in place of `layout`, `arm` and `first`"),
        ],
    ),
    (
        Place::Mission,
        &[
            statement(
                "start",
                "start at POSITION ...",
                "the first waypoint; may be left out, then the flight starts at the first point of what follows",
            ),
            statement(
                "waypoint",
                "waypoint [NAME] at POSITION ...",
                "a point to fly through; its clauses may be in any order",
            ),
            statement(
                "curve",
                "curve NAME in RANGE, points = N { x = ...; y = ...; z = ... }",
                "N waypoints evenly spaced in the parameter, both ends included",
            ),
            statement("waypoints", "waypoints from \"file.csv\"", "takes waypoints from a table, one for each row"),
            statement("hold", "hold TIME", "stays at rest at the waypoint before it"),
            statement("start", "start moving", "leaves out the rest at the start"),
            statement("end", "end moving", "leaves out the rest at the end"),
            statement(
                "limits",
                "limits { }",
                "bounds on the motion of the whole mission, such as `speed <= 8 m/s` ([limits](#limits))",
            ),
        ],
    ),
];

/// What can happen to a rotor in a fault mode: its form, the capacity that remains, and what that means.
pub const EFFECTS: &[(&str, &str, &str, &str)] = &[
    ("lost", "lost", "0", "the rotor gives no thrust and no torque"),
    ("reduced", "reduced to 60 %", "0.6", "the rotor gives this share of what its speed would give"),
    (
        "stuck",
        "stuck at 50 %",
        "1",
        "thrust pinned at this share of full thrust; at 50 % the rotor turns at 71 % of full speed",
    ),
];

/// The functions and constants of expressions, each with what it takes and gives.
pub const FUNCTIONS: &[(&str, &str)] = &[
    ("pi", "a plain number"),
    ("g0", "the spec's gravity, an acceleration"),
    ("sin", "sine of an angle or a plain number (rad)"),
    ("cos", "cosine of an angle or a plain number (rad)"),
    ("tan", "tangent of an angle or a plain number (rad)"),
    ("asin", "of a plain number, an angle"),
    ("acos", "of a plain number, an angle"),
    ("atan", "of a plain number, an angle"),
    ("atan2", "`atan2(y, x)` of two of a kind, an angle"),
    ("sqrt", "halves exponents: the root of `m^2` is `m`"),
    ("abs", "keeps the unit"),
    ("min", "the least of two or more of a kind"),
    ("max", "the largest of two or more of a kind"),
];
