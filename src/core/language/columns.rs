//! The columns of the table that most rows leave at their defaults, and the lists that follow from them.

use super::{Entry, Family, Group, Sizes};

impl Entry {
    /// Sets [`Entry::excludes`].
    pub(super) const fn excludes(self, others: &'static [&'static str]) -> Self {
        Entry { excludes: others, ..self }
    }

    /// Sets [`Entry::sweepable`]; a test compares it with what verdicts depend on (tests/it/language/sweepable.rs).
    pub(super) const fn sweepable(self) -> Self {
        Entry { sweepable: true, ..self }
    }

    /// Sets [`Entry::bounds`].
    pub(super) const fn bounds(self, least: f64, most: f64) -> Self {
        Entry { bounds: Some((least, most)), ..self }
    }

    /// Sets [`Entry::likely`].
    pub(super) const fn likely(self, sizes: Sizes) -> Self {
        Entry { likely: sizes, ..self }
    }

    /// Sets [`Entry::family`].
    pub(super) const fn family(self, family: Family) -> Self {
        Entry { family: Some(family), ..self }
    }
}

impl Group {
    /// The groups whose entries are clauses of a statement: a word and its value, without `=`.
    pub const OF_CLAUSES: [Group; 3] = [Group::Waypoint, Group::PlacedRotor, Group::Strike];

    /// The fields and blocks beside which the field `name` may not be written.
    pub fn rivals(self, name: &str) -> impl Iterator<Item = &'static str> {
        let own = self.entry(name).map_or(&[][..], |entry| entry.excludes).iter().copied();
        let others = self.entries().iter().filter(move |entry| entry.excludes.contains(&name)).map(|entry| entry.name);
        own.chain(others)
    }

    /// What precedes a field of this group in the path of an override (`mavc --set`); `None` where overrides do not
    /// reach.
    pub const fn path(self) -> Option<&'static str> {
        match self {
            Group::Top => Some(""),
            Group::Vehicle => Some("vehicle."),
            Group::Rotor => Some("vehicle.rotor."),
            Group::Battery => Some("vehicle.battery."),
            Group::Parts => Some("vehicle.parts."),
            Group::Mission => Some("mission."),
            Group::Limits => Some("mission.limits."),
            Group::AfterFaultLimits => Some("mission.after_fault_limits."),
            Group::Air => Some("mission.air."),
            Group::Plan => Some("plan."),
            Group::Recovery => Some("plan.recovery."),
            Group::Simulate => Some("simulate."),
            Group::Campaign => Some("campaign."),
            Group::PlacedRotor
            | Group::Part
            | Group::Mode
            | Group::Curve
            | Group::CurveHead
            | Group::Waypoint
            | Group::Volume
            | Group::LandingSite
            | Group::KeepOff
            | Group::Requirement
            | Group::Strike
            | Group::Nothing => None,
        }
    }
}

/// The paths of the fields that a sweep may vary, in the order of the table.
pub fn sweepable() -> impl Iterator<Item = String> {
    let of = |group: Group| {
        let rows = group.entries().iter().filter(|entry| entry.sweepable);
        rows.filter_map(move |entry| Some(format!("{}{}", group.path()?, entry.name)))
    };
    Group::ALL.into_iter().flat_map(of)
}

/// The words that begin a clause in some statement, without repetitions.
pub fn clauses() -> impl Iterator<Item = &'static str> + Clone {
    let all = || Group::OF_CLAUSES.into_iter().flat_map(Group::names);
    all().enumerate().filter(move |(k, word)| all().position(|other| other == *word) == Some(*k)).map(|(_, word)| word)
}

/// Whether `word` begins a clause in some statement.
pub fn is_clause(word: &str) -> bool {
    Group::OF_CLAUSES.into_iter().any(|group| group.has(word))
}
