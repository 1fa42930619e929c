//! The places of statements.

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
    /// `parts { }` in a vehicle.
    Parts,
    /// `part { }` in `parts`.
    Part,
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
    /// `landing_site { }` in a mission.
    LandingSite,
    /// `keep_off { }` in a mission.
    KeepOff,
    /// `after_fault_limits { }` in a mission.
    AfterFaultLimits,
    Plan,
    /// `require capture_height { }` in a plan.
    Requirement,
    /// `recovery { }` in a plan.
    Recovery,
    Simulate,
    Campaign,
    /// A block that could not be recognised: anything is allowed in it.
    Unknown,
}

/// The kind of a statement, as far as its place is concerned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatementKind {
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

impl Place {
    /// The phrase of messages for being here: "in a `mission`".
    pub fn phrase(self) -> &'static str {
        match self {
            Place::Top => "at the top level",
            Place::Vehicle => "in a `vehicle`",
            Place::Rotor => "in a `rotor` block",
            Place::Rotors => "in a `rotors` block",
            Place::Battery => "in a `battery` block",
            Place::Parts => "in `parts`",
            Place::Part => "in a `part`",
            Place::Faults => "in `faults`",
            Place::Mode => "in a `mode`",
            Place::Every => "in an `every` block",
            Place::Mission => "in a `mission`",
            Place::Curve => "in a `curve`",
            Place::Limits => "in `limits`",
            Place::KeepIn => "in a `keep_in`",
            Place::KeepOut => "in a `keep_out`",
            Place::Air => "in `air`",
            Place::LandingSite => "in a `landing_site`",
            Place::KeepOff => "in a `keep_off`",
            Place::AfterFaultLimits => "in `after_fault_limits`",
            Place::Plan => "in a `plan`",
            Place::Requirement => "in a `require` block",
            Place::Recovery => "in `recovery`",
            Place::Simulate => "in `simulate`",
            Place::Campaign => "in `campaign`",
            Place::Unknown => "in this block",
        }
    }

    /// Whether the statements of the block are limits.
    pub fn has_limits(self) -> bool {
        matches!(self, Place::Limits | Place::AfterFaultLimits)
    }

    /// The phrase of messages after "of": "a `mission`".
    pub fn phrase_alone(self) -> &'static str {
        let phrase = self.phrase();
        phrase.strip_prefix("in ").unwrap_or(phrase)
    }
}
