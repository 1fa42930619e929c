//! The rows of what concerns the time after a fault: sites, areas to keep off, limits, and `recovery` in `plan`.

use super::*;

/// The words for ways out in an order; the names of landing sites are the others.
pub const WAYS: &[&str] = &["continue", "land_at_sites", "land_here"];

group! {
    /// The fields of `landing_site { }`.
    landing_site:
    AT "at", Vector("m", Any), Needed, "the middle `[x, y, z]` of the site, on the mission's `ground` or above it"
        .bounds(1e-100, ANY);
    RADIUS "radius", Quantity("m", Positive), Needed,
        "the horizontal distance from the middle within which the vehicle touches down";
}

/// The fields of `keep_off { }`: those of a volume without heights.
pub mod keep_off {
    use super::*;

    pub const SHAPE: Entry = Entry::new(
        "shape",
        Words(&["box", "cylinder", "polygon"]),
        Needed,
        "the shape of the area; only its outline from above counts",
    );
    pub const FROM: Entry = Entry::new(
        "from",
        PlanePoint("m"),
        Otherwise("required for a box"),
        "the box corner `[x, y]` with the lowest coordinates",
    );
    pub const TO: Entry = Entry::new(
        "to",
        PlanePoint("m"),
        Otherwise("required for a box"),
        "the box corner `[x, y]` with the highest coordinates",
    );
    pub const TURN: Entry = volume::TURN;
    pub const CENTRE: Entry =
        Entry::new("centre", PlanePoint("m"), Otherwise("required for a cylinder"), "the axis `[x, y]` of a cylinder");
    pub const RADIUS: Entry =
        Entry::new("radius", Quantity("m", Positive), Otherwise("required for a cylinder"), "the radius of a cylinder");
    pub const CORNERS: Entry = volume::CORNERS;
    pub const CLEARANCE: Entry = Entry::new(
        "clearance",
        Quantity("m", NotNegative),
        Value(0.0, "0 m", "the vehicle's `size` alone is kept"),
        "the horizontal distance from the outline that the vehicle keeps where it lands, in addition to its `size`",
    );
    pub const ENTRIES: &[&Entry] = &[&SHAPE, &FROM, &TO, &TURN, &CENTRE, &RADIUS, &CORNERS, &CLEARANCE];
}

/// The statements of `after_fault_limits { }`: those of `limits { }` that bound no place and no yaw.
pub mod after_fault_limits {
    use super::Entry;
    use super::limits::*;

    pub const ENTRIES: &[&Entry] = &[
        &SPEED,
        &SPEED_HORIZONTAL,
        &CLIMB,
        &DESCENT,
        &ACCELERATION,
        &ACCELERATION_HORIZONTAL,
        &JERK,
        &YAW_RATE,
        &YAW_ACCELERATION,
        &TILT,
    ];
}

group! {
    /// The fields of `recovery { }` in `plan`.
    recovery:
    ORDER "order", NameList(WAYS), Written("[continue, land_at_sites, land_here]", "rather on than down"),
        "the ways out in the order of preference, each once: `continue`, back to the plan and along it to its end; \
            the name of a landing site; `land_at_sites`, any site; `land_here`, wherever the vehicle comes to \
            rest. A fault mode may have its own order, `recovery = [...]`";
    DETECTION "detection", Quantity("s", NotNegative), Otherwise("the delay of `simulate`, or 200 ms"),
        "the delay after which a fault is known, or the shortest and the longest delay, as in `100 ms .. 200 ms`"
        .likely(DELAYS);
    WITHIN "within", Quantity("s", Positive), Value(30.0, "30 s", "from the fault's detection to the end of a way out"),
        "the longest time from the fault's detection to the touchdown or the return to the plan".bounds(1e-3, ANY);
    KEEP "keep", Share, Value(0.0, "0 %", "no charge is kept"),
        "the share of the battery's charge that must be left after the touchdown; needs a `battery`";
}
