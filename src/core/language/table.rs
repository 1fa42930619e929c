//! The rows of the language table, group by group, in the order in which docs/language.md explains them.

use super::Absent::{Needed, Otherwise, Value, Written};
use super::Range::{Any, NotNegative, Positive};
use super::Takes::{
    Bound, NameList, Names, Nothing, PlanePoint, Points, Quantity, QuantityOr, QuantityOrShare, QuantityOrVector,
    Share, Text, Vector, Whole, WordList, Words,
};
use super::{Absent, Entry, Family, Sizes, Takes};
pub use after_fault::{WAYS, after_fault_limits, keep_off, landing_site, recovery};
use std::f64::consts::{FRAC_PI_2, PI};

/// Defines a constant for each row of a group, and the list of all rows. After its line of documentation a row may have
/// further columns, the methods of [`Entry`] in `columns.rs`: `.bounds(1e-6, 1e6)`. A row without them excludes
/// nothing, may not be swept, has the bounds of any quantity and suggests its usual unit alone.
macro_rules! group {
    ($(#[$doc:meta])* $group:ident: $(
        $(#[$condition:meta])*
        $name:ident $written:literal, $takes:expr, $absent:expr, $doc_line:literal
        $(.$column:ident($($value:expr),*))*;
    )*) => {
        $(#[$doc])*
        pub mod $group {
            use super::*;
            $(
                $(#[$condition])*
                pub const $name: Entry =
                    Entry::new($written, $takes, $absent, $doc_line)$(.$column($($value),*))*;
            )*
            pub const ENTRIES: &[&Entry] = &[$($(#[$condition])* &$name),*];
        }
    };
}

mod after_fault;

const NO_DEFAULT: Absent = Otherwise("");

/// The names of warnings; `crate::model` has the list and checks that each name is in it.
const WARNINGS: Takes = Names(&[]);

// Typical sizes for multirotors: two units where both are possible.
const ANY: f64 = f64::INFINITY;
const LENGTHS: Sizes = &[(5.0, &["m"]), (60.0, &["cm"]), (100.0, &["cm", "mm"]), (ANY, &["mm"])];
const MASSES: Sizes = &[(50.0, &["kg"]), (1000.0, &["g", "kg"]), (ANY, &["g"])];
const THRUSTS: Sizes = &[(100.0, &["N"]), (500.0, &["N", "gf"]), (ANY, &["gf", "N"])];
const LEVERS: Sizes = &[(0.5, &["m"]), (5.0, &["cm", "mm"]), (ANY, &["mm"])];
/// The smallest rotors reach 4000 rad/s, the largest less than 1500 rpm.
const SPEEDS: Sizes = &[(50.0, &["rad/s"]), (1500.0, &["rad/s", "rpm"]), (4000.0, &["rpm", "rad/s"]), (ANY, &["rpm"])];
/// Packs of small quadcopters hold 0.1 A*h, those of the largest multirotors less than 200 A*h.
const CHARGES: Sizes = &[(90.0, &["A*h"]), (200.0, &["A*h", "mA*h"]), (ANY, &["mA*h"])];
const LAGS: Sizes = &[(1.0, &["s"]), (ANY, &["ms"])];
const DELAYS: Sizes = &[(1.0, &["s"]), (10.0, &["s", "ms"]), (ANY, &["ms"])];
const TOLERANCES: Sizes = &[(1.0, &["m"]), (ANY, &["cm"])];

/// The time of `hold`, which is a statement and not a field. Upper bounds of times are checked where they are read.
pub const HOLD: Entry =
    Entry::new("hold", Quantity("s", Positive), Needed, "stays at rest at the previous waypoint").bounds(0.0, ANY);

/// The least bound of a rate or a tilt: with smaller ones nothing can move, and the least times they imply overflow.
const LEAST_RATE: f64 = 1e-9;
const MOST: f64 = 1e12;

group! {
    /// Outside all blocks.
    top:
    GRAVITY "gravity", Quantity("m/s^2", Positive), Value(9.81, "9.81 m/s^2", "the language's default gravity"),
        "the acceleration of gravity, `g0` in expressions; written outside all blocks: `gravity = 9.80665 m/s^2`"
        .sweepable().bounds(1e-3, 1e4);
    ALLOW "allow", WARNINGS, Written("[]", "every warning is shown"),
        "warnings to suppress, named by the last part of their codes; written outside all blocks: `allow = \
            [tip_speed]`";
}

group! {
    /// The fields of `vehicle { }`.
    vehicle:
    LAYOUT "layout", Text, Otherwise("required for a ring"),
        "puts the rotors on a ring; a letter for each, `P` or `N`, gives the direction in which it turns, as in \
            `\"PNPN\"`"
        .excludes(&["rotors"]);
    FIRST "first", Quantity("deg", Any), Value(0.0, "0 deg", "the first rotor is on +y"),
        "the angle from +y to the first rotor of a ring, clockwise".excludes(&["rotors"]);
    ARM "arm", Quantity("m", Positive), Otherwise("required for a ring"),
        "the radius of a ring about the frame's origin"
        .excludes(&["rotors"]).sweepable().bounds(1e-4, 1e4).likely(LENGTHS);
    MASS "mass", Quantity("kg", Positive), Otherwise("required, or `parts`"),
        "the mass of the whole vehicle in flight, including its payload"
        .sweepable().bounds(1e-6, 1e6).likely(MASSES).family(Family::Mass);
    PROPELLER_RADIUS "propeller_radius", Quantity("m", Positive), Otherwise("unknown"),
        "the radius of a propeller".bounds(1e-4, 1e4).likely(LENGTHS);
    DRAG "drag", QuantityOrVector("N*s/m", NotNegative), Otherwise("plans take no air into account"),
        "the drag force divided by the speed through the [air](#air): one number for all directions, or `[x, y, \
            z]` along the axes of the body, such as `[0.35, 0.35, 0.2] N*s/m`. For an interval, plans hold only \
            for its middle".sweepable();
    YAW_DRAG "yaw_drag", Quantity("N*m*s/rad", Positive), Otherwise("unknown"),
        "the torque of the air about z divided by the rate at which the body turns about z. It limits the spin of a \
         vehicle that [gives up yaw](#without-yaw)".sweepable().bounds(1e-12, 1e6);
    YAW_DRAG_QUADRATIC "yaw_drag_quadratic", Quantity("N*m*s^2/rad^2", NotNegative),
        Value(0.0, "0 N*m*s^2/rad^2", "the drag is linear"),
        "a further torque of the air about z, divided by the square of the turning rate".bounds(0.0, 1e6);
    SIZE "size", Quantity("m", Positive), Otherwise("the largest arm plus the propeller's radius"),
        "the radius about the centre of gravity within which the whole vehicle stays; the centre keeps this \
            distance from [volumes](#volumes)"
        .bounds(1e-4, 1e4).likely(LENGTHS);
    INERTIA "inertia", Vector("kg*m^2", Positive), Otherwise("required, or `parts`"),
        "the moments of inertia `[Ixx, Iyy, Izz]` about the centre of gravity".bounds(1e-15, 1e9).family(Family::Mass);
    CENTRE_OF_GRAVITY "centre_of_gravity", Vector("m", Any), Otherwise("that of `parts`, or the frame's origin"),
        "the centre of gravity `[x, y, z]` from the frame's origin".bounds(1e-100, ANY);
    ALLOCATION "allocation", Words(&["bounded", "pseudo_inverse"]),
        Written("bounded", "reaches all that the rotors can give"),
        "how a wrench becomes rotor speeds. `bounded` respects the limits of the rotors; an infeasible wrench \
            loses yaw first. `pseudo_inverse` is the paper's method, clipped to the limits; verdicts and plans \
            then use only wrenches that it reaches without clipping";
}

group! {
    /// The fields of `rotor { }`.
    rotor:
    TABLE "table", Text, Otherwise("none"),
        "a CSV file with the motor maker's thrust table, for the numbers that the spec omits";
    THRUST_COEFFICIENT "thrust_coefficient", Quantity("N*s^2/rad^2", Positive), Otherwise("required, or `max_thrust`"),
        "a rotor's thrust divided by the square of its speed"
        .excludes(&["max_thrust"]).sweepable().family(Family::Thrust);
    MAX_THRUST "max_thrust", Quantity("N", Positive), Otherwise("required, or `thrust_coefficient` or `table`"),
        "a rotor's thrust at full speed".sweepable().bounds(1e-6, 1e6).likely(THRUSTS).family(Family::Thrust);
    DRAG_COEFFICIENT "drag_coefficient", Quantity("N*m*s^2/rad^2", Positive),
        Otherwise("required, or `torque_per_thrust`"),
        "a rotor's drag torque divided by the square of its speed"
        .excludes(&["torque_per_thrust"]).sweepable().family(Family::Torque);
    TORQUE_PER_THRUST "torque_per_thrust", Quantity("m", Positive),
        Otherwise("required, or `drag_coefficient` or `table`"),
        "a rotor's drag torque divided by its thrust"
        .sweepable().bounds(1e-12, 1e4).likely(LEVERS).family(Family::Torque);
    MIN_SPEED "min_speed", Quantity("rad/s", Any), Otherwise("0"),
        "the lowest speed: above zero for a rotor that cannot stop unless it is lost, below zero for one that can \
         reverse"
        .excludes(&["min_thrust"]).sweepable().bounds(0.0, 1e6).likely(SPEEDS);
    MIN_THRUST "min_thrust", QuantityOrShare("N", Any), Otherwise("0, or that of `min_speed`"),
        "the lowest thrust instead of the lowest speed, in newtons or as a share of the thrust at full speed: `-60 \
            %` for a rotor whose reverse thrust reaches 60 %".sweepable().bounds(0.0, 1e9);
    MAX_SPEED "max_speed", Quantity("rad/s", Positive), Otherwise("required, or `table`"),
        "the full speed, the highest at which a rotor turns".sweepable().bounds(0.1, 1e6).likely(SPEEDS);
    TIME_CONSTANT "time_constant", Quantity("s", Positive), Otherwise("20 ms in simulations"),
        "the time constant with which the speed w follows its command, w' = (command - w)/time_constant; \
         [plans](#plan) use it with `rotors = lagging`".bounds(1e-6, 1e4).likely(LAGS);
    ROTOR_INERTIA "rotor_inertia", Quantity("kg*m^2", Positive), Otherwise("0: the momentum of rotors is neglected"),
        "the moment of inertia of a rotor about its axis, propeller and motor bell together, for the equilibria of a \
         vehicle that [gives up yaw](#without-yaw)".bounds(1e-15, 1e6);
    // `made_up_field.rs` looks for it in everything that follows from the table.
    #[cfg(test)]
    MADE_UP "made_up", Quantity("s", Positive), Otherwise("nothing"), "a field of the tests, which no reader uses"
        .excludes(&["time_constant"]).sweepable().bounds(1e-3, 1e3).likely(DELAYS).family(Family::Thrust);
}

/// The clauses of `rotor at` in `rotors { }`: three of its own, and the fields of [`rotor`] except `table`, which
/// gives the numbers of all rotors.
pub mod placed_rotor {
    use super::*;

    pub const AT: Entry =
        Entry::new("at", Vector("m", Any), Needed, "the position `[x, y, z]` from the frame's origin")
            .bounds(1e-100, ANY);
    pub const SPIN: Entry = Entry::new("spin", Words(&["P", "N"]), Needed, "the direction in which the rotor turns");
    pub const MOTOR: Entry = Entry::new(
        "motor",
        Whole(1, 32),
        Otherwise("the rotor's number"),
        "the autopilot's number for its motor, if it differs from the rotor's",
    );
    const OWN: [&Entry; 3] = [&AT, &SPIN, &MOTOR];
    const SHARED: &[&Entry] = rotor::ENTRIES.split_at(1).1;
    pub const ENTRIES: &[&Entry] = &joined(OWN, SHARED);

    const fn joined(own: [&'static Entry; 3], shared: &[&'static Entry]) -> [&'static Entry; OWN.len() + SHARED.len()] {
        let mut all = [own[0]; OWN.len() + SHARED.len()];
        let mut k = 0;
        while k < all.len() {
            all[k] = if k < own.len() { own[k] } else { shared[k - own.len()] };
            k += 1;
        }
        all
    }
}

group! {
    /// The fields of `battery { }`.
    battery:
    CAPACITY "capacity", Quantity("A*h", Positive), Needed, "the charge that the full battery gives until it is empty"
        .bounds(1e-3, MOST).likely(CHARGES);
    VOLTAGE "voltage", Quantity("V", Positive), Needed,
        "the mean voltage from full to empty: for lithium polymer about 3.7 V per cell in series".bounds(1e-3, 1e6);
    HOVER_POWER "hover_power", Quantity("W", Positive), Otherwise("required, or `table` of `rotor`"),
        "the electrical power that the whole vehicle takes in hover at its `mass`, as measured".bounds(1e-6, 1e9);
    KEEP "keep", Share, Value(0.2, "20 %", "a fifth of the charge stays in reserve"),
        "the share of the charge that a plan should leave; below 100 %".sweepable();
    THRUST_AT_EMPTY "thrust_at_empty", Share, Value(1.0, "100 %", "full thrust does not depend on the charge"),
        "the share of full thrust that remains with an empty battery; from full to empty, full thrust falls linearly \
         with the charge".sweepable();
}

group! {
    /// The fields of `parts { }`.
    parts:
    MOTOR_MASS "motor_mass", Quantity("kg", Positive), Otherwise("0"),
        "the mass of a motor with its propeller: a point at the place of each rotor"
        .sweepable().bounds(1e-6, 1e6).likely(MASSES);
    ARM_MASS "arm_mass", Quantity("kg", Positive), Otherwise("0"),
        "the mass of an arm: a thin rod from the frame's origin to each rotor"
        .sweepable().bounds(1e-6, 1e6).likely(MASSES);
}

group! {
    /// The fields of `part { }`.
    part:
    MASS "mass", Quantity("kg", Positive), Needed, "the mass of the part"
        .bounds(1e-6, 1e6).likely(MASSES).family(Family::Mass);
    AT "at", Vector("m", Any), Needed, "its centre `[x, y, z]` from the frame's origin".bounds(1e-100, ANY);
    SIZE "size", Vector("m", Positive), Otherwise("a point"), "the sides `[x, y, z]` of a homogeneous box"
        .bounds(1e-4, 1e4).likely(LENGTHS);
}

group! {
    /// The fields of `mode { }` and `every { }`.
    mode:
    RATE "rate", Quantity("1/h", NotNegative), NO_DEFAULT,
        "the failure rate, or an interval such as `1e-5 1/h +- 50 %`, which `mavc safety` uses";
    SEVERITY "severity", Whole(1, 10), NO_DEFAULT,
        "the FMEA severity; its product with `occurrence` and `detection` is `rpn`";
    OCCURRENCE "occurrence", Whole(1, 10), NO_DEFAULT, "the FMEA occurrence";
    DETECTION "detection", Whole(1, 10), NO_DEFAULT, "the FMEA detection";
    AFTER_FAULT "after_fault", Words(&["continue", "hold"]), Otherwise("as in `plan`"),
        "the reaction that the mission's risk assumes after this fault";
    WITHOUT_YAW "without_yaw", Words(&["never", "where_needed", "always"]), Otherwise("as in `plan`"),
        "whether plans and flights give up yaw after this fault";
    RECOVERY "recovery", NameList(WAYS), Otherwise("that of `recovery` in `plan`"),
        "the list of ways out [after this fault](#after-a-fault), in order of preference";
}

group! {
    /// The fields in the braces of `curve`.
    curve:
    X "x", Quantity("m", Any), Needed, "the coordinate to the east, as an expression of the parameter";
    Y "y", Quantity("m", Any), Needed, "the coordinate to the north, as an expression of the parameter";
    Z "z", Quantity("m", Any), Needed, "the height, as an expression of the parameter";
    YAW "yaw", Quantity("deg", Any), Otherwise("that of the previous waypoint; 0 deg for the first"),
        "the direction in which the vehicle points";
    WITHIN "within", Quantity("cm", Positive), Otherwise("as in `plan`"),
        "the position tolerance of each waypoint, a distance"
        .bounds(1e-9, 1e9).likely(TOLERANCES).family(Family::Tolerance);
    YAW_WITHIN "yaw_within", Quantity("deg", Positive), Otherwise("as in `plan`"), "the yaw tolerance of each waypoint"
        .bounds(1e-9, 1e9).family(Family::Tolerance);
    WEIGHT "weight", Quantity("1", NotNegative), Otherwise("as in `plan`"),
        "the weight of the squared errors in position and yaw".bounds(0.0, MOST);
}

group! {
    /// The options after the range of a `curve`, each preceded by a comma.
    curve_head:
    POINTS "points", Whole(2, 10_000), Needed,
        "the number of waypoints, including both ends; follows the range after a comma";
}

group! {
    /// The clauses of `start` and `waypoint`.
    waypoint:
    AT "at", Vector("m", Any), Needed, "the position `[x, y, z]`".bounds(1e-100, ANY);
    YAW "yaw", Quantity("deg", Any), Otherwise("that of the previous waypoint; 0 deg for the first"),
        "the direction in which the vehicle points; or `towards` a point or a waypoint, `along path`, or `free` \
         ([yaw](#yaw))";
    WITHIN "within", Quantity("cm", Positive), Otherwise("as in `plan`"), "the position tolerance, a distance"
        .bounds(1e-9, 1e9).likely(TOLERANCES).family(Family::Tolerance);
    YAW_WITHIN "yaw_within", Quantity("deg", Positive), Otherwise("as in `plan`"), "the yaw tolerance"
        .bounds(1e-9, 1e9).family(Family::Tolerance);
    WEIGHT "weight", Quantity("1", NotNegative), Otherwise("as in `plan`"),
        "the weight of the squared errors in position and yaw".bounds(0.0, MOST);
    TIME "time", Quantity("s", NotNegative), Otherwise("free"),
        "the time of arrival, counted from the start of the mission"
        .bounds(1e-9, ANY);
    STRAIGHT "straight", Nothing, NO_DEFAULT,
        "the leg that arrives here is a `corridor` whose radius is the larger `within` of its two waypoints \
         ([legs](#legs))"
        .excludes(&["vertical", "corridor"]);
    VERTICAL "vertical", Nothing, NO_DEFAULT, "as `straight`, but an error unless one waypoint is above the other"
        .excludes(&["corridor"]);
    CORRIDOR "corridor", Quantity("m", Positive), NO_DEFAULT,
        "how far the leg that arrives here may be from the line through its waypoints";
    ARRIVE "arrive", Vector("1", Any), NO_DEFAULT,
        "after `from`: the direction `[x, y, z]` from which the vehicle comes, as in `arrive from [0, 0, 1]`";
    STOP "stop", Nothing, Otherwise("`pass`"), "comes to rest here, without a `hold`".excludes(&["pass"]);
    PASS "pass", Nothing, NO_DEFAULT, "flies through; the opposite of `stop`";
}

const COORDINATE: &[&str] = &["<=", ">=", "in"];
const NORM: &[&str] = &["<="];
const RATE_FORMS: &[&str] = &["<=", "in"];

group! {
    /// The statements of `limits { }`.
    limits:
    X "x", Bound("m", COORDINATE), NO_DEFAULT, "bounds the coordinate to the east";
    Y "y", Bound("m", COORDINATE), NO_DEFAULT, "bounds the coordinate to the north";
    Z "z", Bound("m", COORDINATE), NO_DEFAULT, "bounds the height";
    ALTITUDE "altitude", Bound("m", COORDINATE), NO_DEFAULT, "bounds the height; the same as `z`";
    YAW "yaw", Bound("deg", COORDINATE), NO_DEFAULT,
        "bounds the yaw, unwrapped from the start";
    SPEED "speed", Bound("m/s", NORM), NO_DEFAULT, "bounds the magnitude of the velocity"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
    SPEED_HORIZONTAL "speed_horizontal", Bound("m/s", NORM), NO_DEFAULT,
        "bounds the magnitude of the horizontal velocity"
        .bounds(LEAST_RATE, MOST);
    CLIMB "climb", Bound("m/s", NORM), NO_DEFAULT, "bounds the upward speed".bounds(LEAST_RATE, MOST);
    DESCENT "descent", Bound("m/s", NORM), NO_DEFAULT, "bounds the downward speed".bounds(LEAST_RATE, MOST);
    ACCELERATION "acceleration", Bound("m/s^2", NORM), NO_DEFAULT, "bounds the magnitude of the acceleration"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
    ACCELERATION_HORIZONTAL "acceleration_horizontal", Bound("m/s^2", NORM), NO_DEFAULT,
        "bounds the magnitude of the horizontal acceleration".bounds(LEAST_RATE, MOST);
    JERK "jerk", Bound("m/s^3", NORM), NO_DEFAULT, "bounds the magnitude of the jerk"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
    YAW_RATE "yaw_rate", Bound("deg/s", RATE_FORMS), NO_DEFAULT,
        "bounds how fast the yaw changes; `<=` bounds both directions"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
    YAW_ACCELERATION "yaw_acceleration", Bound("deg/s^2", RATE_FORMS), NO_DEFAULT,
        "bounds how fast the yaw rate changes; `<=` bounds both directions"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
    TILT "tilt", Bound("deg", NORM), NO_DEFAULT,
        "bounds the angle between the thrust and the vertical; the bound is below 90 deg"
        .bounds(LEAST_RATE, MOST).family(Family::Motion);
}

group! {
    /// The fields of `keep_in { }` and `keep_out { }`.
    volume:
    SHAPE "shape", Words(&["box", "cylinder", "polygon", "sphere", "half_space"]), Needed, "the shape of the volume";
    FROM "from", Vector("m", Any), Otherwise("required for a box"), "the lowest corner `[x, y, z]` of a box";
    TO "to", Vector("m", Any), Otherwise("required for a box"), "the highest corner `[x, y, z]` of a box";
    TURN "turn", Quantity("deg", Any), Value(0.0, "0 deg", "the sides of the box point along x and y"),
        "how far a box is turned about the vertical axis through its centre, counter-clockwise";
    CENTRE "centre", Vector("m", Any), Otherwise("required for a cylinder or sphere"),
        "the centre of a sphere, or of the lower end of a cylinder";
    RADIUS "radius", Quantity("m", Positive), Otherwise("required for a cylinder or sphere"),
        "the radius of a cylinder or sphere";
    HEIGHT "height", Quantity("m", Positive), Otherwise("required for a cylinder"), "the height of a cylinder";
    CORNERS "corners", Points, Otherwise("required for a polygon"),
        "the corners `[[x, y], [x, y], ...] m` of a polygon, in order along its edge";
    BOTTOM "bottom", Quantity("m", Any), Otherwise("required for a polygon"),
        "the height of the lower end of a polygon";
    TOP "top", Quantity("m", Any), Otherwise("required for a polygon"), "the height of the upper end of a polygon";
    POINT "point", Vector("m", Any), Otherwise("required for a half space"), "a point on the boundary of a half space";
    NORMAL "normal", Vector("1", Any), Otherwise("required for a half space"),
        "the outward normal `[x, y, z]` of a half space";
    CLEARANCE "clearance", Quantity("m", NotNegative), Value(0.0, "0 m", "the vehicle's `size` alone is kept"),
        "the distance from the boundary that the vehicle keeps, in addition to its `size`";
}

group! {
    /// The fields of `air { }`.
    air:
    WIND "wind", Vector("m/s", Any), Written("[0, 0, 0] m/s", "still air"),
        "the velocity of the air, x east, y north, z up. With `+- 2 m/s`, or `+- [2, 2, 0] m/s`, every constant \
            wind of this interval is possible".bounds(0.0, 1e4);
    GUSTS "gusts", Quantity("m/s", NotNegative), Value(0.0, "0 m/s", "no gusts"),
        "the standard deviation of the gusts on each axis; plans ignore gusts"
        .bounds(0.0, 1e4);
    DENSITY "density", Quantity("kg/m^3", Positive), Otherwise("1.225 kg/m^3"),
        "the density of the air: thrust, torque and drag are proportional to it; the spec gives them at 1.225 \
            kg/m^3"
        .excludes(&["altitude"]).sweepable().bounds(1e-3, 1e3);
    ALTITUDE "altitude", Quantity("m", Any), Otherwise("0 m"),
        "instead of `density`: the site's height above sea level, which gives the density of the standard atmosphere"
        .sweepable();
}

group! {
    /// The fields of `mission { }`, beside its statements.
    mission:
    GROUND "ground", Quantity("m", Any), Otherwise("unknown"),
        "the height of the ground, not above any waypoint. [`require capture_height`](#capture-height) counts from \
            it. Flights use it, lowered by 1 m if a waypoint is on it, unless `simulate` gives another ground";
    ORIGIN_LATITUDE "origin_latitude", Quantity("deg", Any), Otherwise("unknown"),
        "the latitude of the point `[0, 0, 0] m` on the ellipsoid WGS 84, north positive; needs `origin_longitude` and \
         `origin_altitude`. Missions for [ground stations](missions.md) use it; plans do not";
    ORIGIN_LONGITUDE "origin_longitude", Quantity("deg", Any), Otherwise("unknown"), "the origin's longitude, east \
        positive";
    ORIGIN_ALTITUDE "origin_altitude", Quantity("m", Any), Otherwise("unknown"), "the origin's height above mean \
        sea level";
    BUFFER "buffer", Quantity("m", NotNegative), Value(0.0, "0 m", "the same places before and after a fault"),
        "how far outside a `keep_in` or position limit the vehicle may be [after a fault](#after-a-fault)"
        .bounds(1e-9, 1e6);
}

group! {
    /// The fields of `plan { }`.
    plan:
    MODEL "model", Words(&["hover", "exact"]), Written("exact", "how the required thrust and torques are computed"),
        "the model of the thrust and torques that a motion requires: `exact`, at any tilt, or `hover`, the paper's, \
         linear about hover";
    ROTORS "rotors", Words(&["instant", "lagging"]), Written("instant", "thrusts follow their commands at once"),
        "how rotors follow their commands: `instant`, at once, or `lagging`, with a `time_constant`, which each rotor \
         then needs";
    PLANNER "planner", Words(&["rip", "rcp", "rsp"]), Written("rsp", "the risk-sensitive planner"),
        "`rip` uses the healthy set alone. `rcp` stays inside the sets of all modes at all times. `rsp` uses the \
         healthy set and those facets of the modes' sets that the `rip` plan would violate";
    ROUNDS "rounds", Whole(0, 100), Value(1.0, "1", "how often rsp selects facets"),
        "how often `rsp` selects facets, always at the same mission time: 0 gives `rip`, 1 gives the paper's \
            `rsp`. Each further round adds the facets that the plan of the previous round would violate";
    AFTER_FAULT "after_fault", Words(&["continue", "hold"]), Written("continue", "the mission continues"),
        "the reaction that the mission's risk assumes after a fault: `continue`, or `hold` (come to rest and stay)";
    WITHOUT_YAW "without_yaw", Words(&["never", "where_needed", "always"]),
        Written("where_needed", "yaw is given up where a fault leaves no control of it"),
        "whether plans and flights [give up yaw](#without-yaw) after a fault: `never`, `always`, or `where_needed` \
            (in modes whose remaining rotors do not control all axes about hover)";
    AGAINST "against", Names(&["all"]), Written("all", "every declared fault mode"),
        "the modes to tolerate: `all`; a mode `M1`; all modes `M` of `every ... as M`; a range of them, `M1 .. \
            M4`; a list of these, `[M1 .. M4, worn]`; or `where FIELD RELATION VALUE` with `rpn`, `severity`, \
            `occurrence`, `detection` or `rate` as FIELD and `< <= > >= =` as RELATION; modes without that number \
            are skipped. `[]` chooses no mode";
    TIME "time", QuantityOr("s", Positive, &["minimum"]),
        Written("minimum", "the shortest time that the planner finds"),
        "the time of the whole mission, including holds, or `minimum`: as short as the planner can make it"
        .bounds(1e-9, ANY);
    WITHIN "within", Quantity("cm", Positive), Value(0.05, "5 cm", "position tolerance of each waypoint"),
        "the position tolerance of each waypoint, a distance"
        .bounds(1e-9, 1e9).likely(TOLERANCES).family(Family::Tolerance);
    YAW_WITHIN "yaw_within", Quantity("deg", Positive), Value(PI / 90.0, "2 deg", "yaw tolerance of each waypoint"),
        "the yaw tolerance of each waypoint".bounds(1e-9, 1e9).family(Family::Tolerance);
    SAMPLES "samples", Whole(1, 3_000), Value(200.0, "200", "intervals of the whole mission"),
        "the number of pieces of the whole mission; above 200 by default if its legs need more than 120. Every \
            waypoint lies on a [node](glossary.md#words). A hold takes one piece. Legs share the others: a leg \
            from rest to rest gets at least 10, one from or to rest at least 5 ([grid](#grid))";
    RESERVE "reserve", Share, Value(0.1, "10 %", "share of each set kept for feedback"),
        "the share of each set that is kept for feedback: sets are shrunk about hover; below 100 %";
    SNAP "snap", Quantity("1", NotNegative),
        Value(1e-4, "1e-4", "weight of snap: horizontal, in the exact model vertical too"),
        "the weight of the integral of the squared horizontal snap, s^7/m^2".bounds(0.0, MOST);
    ACCELERATION "acceleration", Quantity("1", NotNegative),
        Value(1e-4, "1e-4", "weight of vertical and yaw acceleration"),
        "the weight of the integral of the squared vertical acceleration (s^3/m^2) and yaw acceleration (s^3/rad^2)"
        .bounds(0.0, MOST).family(Family::Motion);
    WEIGHT "weight", Quantity("1", NotNegative), Value(1.0, "1", "weight of the squared distance to each waypoint"),
        "the weight of the squared distance to each waypoint, 1/m^2, and of the squared yaw error there, 1/rad^2"
        .bounds(0.0, MOST);
    TIMING "timing", Words(&["optimal", "proportional", "uniform", "distance"]),
        Written("optimal", "the planner chooses the waypoint times"),
        "`optimal`: the planner searches for the waypoint times of the shortest mission (a local optimum). \
         `proportional`: legs share the time as described under [mission](#mission). `uniform`: all legs take the same \
         time. `distance`: each leg takes time in proportion to its length, on curves too";
    EFFORT "effort", Words(&["quick", "normal", "thorough"]), Written("normal", "how much work a search may take"),
        "how much work the solver may spend on a search for a plan in the exact model, whatever the machine: `quick` a \
         fifth of `normal`, `thorough` ten times `normal`";
    VEHICLE "vehicle", Names(&[]), Otherwise("the only one"), "the name of the vehicle to use, if the spec has several";
    MISSION "mission", Names(&[]), Otherwise("the spec's only one"),
        "the name of the mission to plan, if the spec has several";
}

group! {
    /// The fields of `require capture_height { }`.
    requirement:
    RADIUS "radius", Quantity("m", Positive), Value(5.0, "5 m", "room to take off and to land"),
        "the horizontal distance from start and end within which the vehicle may be lower, on its way up and down";
    DETECTION "detection", Quantity("s", NotNegative), Otherwise("that of `simulate`"),
        "the delay after which a fault is known; required unless `simulate` gives a delay".likely(DELAYS);
}

group! {
    /// The fields of `simulate { }`.
    simulate:
    DURATION "duration", Quantity("s", Positive), Written("that of the plan", "how long the flight is simulated"),
        "how long the flight is simulated; a stop or a landing after a fault is simulated to its end".bounds(1e-9, ANY);
    RATE "rate", Quantity("Hz", Positive), Value(1000.0, "1 kHz", "steps of the integration"),
        "integration steps per second (fourth-order Runge-Kutta); at most 100 kHz, and a step is at most half of the \
         shortest `time_constant`";
    CONTROL_RATE "control_rate", Quantity("Hz", Positive), Value(500.0, "500 Hz", "how often the controller acts"),
        "how often the controller acts; `rate` must be a whole multiple of it";
    ESTIMATOR_RATE "estimator_rate", Quantity("Hz", Positive),
        Value(100.0, "100 Hz", "how often capacities are estimated"),
        "how often the rotors' capacities are estimated; `control_rate` must be a whole multiple of it";
    CONTROLLER "controller", Words(&["geometric", "pd"]), Written("geometric", "tracks far from hover too"),
        "`geometric` tracks the plan on SE(3), also far from hover. `pd` is the paper's controller about hover";
    DETECTION "detection", QuantityOr("s", NotNegative, &["estimator", "never"]),
        Written("estimator", "how the controller learns of a fault"),
        "how the controller learns of a fault: `estimator`, from the estimated capacities; `never`; or a delay after \
         which it knows the mode".likely(DELAYS);
    AFTER_FAULT "after_fault", Words(&["continue", "hold", "land", "recovery"]),
        Written("continue", "flies on as planned"),
        "the reaction to a detected fault: `continue` the plan, `hold` where the vehicle comes to rest, `land` there, \
         or `recovery`: take the first way out found in the plan's `order`";
    POSITION_GAIN "position_gain", Quantity("1/s^2", Positive),
        Value(4.0, "4 1/s^2", "gain on the deviation in x and y"),
        "gain on the deviation in x and y";
    VELOCITY_GAIN "velocity_gain", Quantity("1/s", Positive),
        Value(3.2, "3.2 1/s", "gain on the deviation of the horizontal velocity"),
        "gain on the deviation of the horizontal velocity";
    ALTITUDE_GAIN "altitude_gain", Quantity("1/s^2", Positive), Value(6.0, "6 1/s^2", "gain on the deviation in z"),
        "gain on the deviation in z";
    CLIMB_GAIN "climb_gain", Quantity("1/s", Positive),
        Value(4.0, "4 1/s", "gain on the deviation of the vertical velocity"),
        "gain on the deviation of the vertical velocity";
    ATTITUDE_GAIN "attitude_gain", Quantity("1/s^2", Positive),
        Value(100.0, "100 1/s^2", "gain on the deviation in roll and pitch"),
        "gain on the deviation in roll and pitch";
    ATTITUDE_RATE_GAIN "attitude_rate_gain", Quantity("1/s", Positive),
        Value(16.0, "16 1/s", "gain on the deviation of the roll and pitch rates"),
        "gain on the deviation of the roll and pitch rates";
    YAW_GAIN "yaw_gain", Quantity("1/s^2", Positive), Value(4.0, "4 1/s^2", "gain on the deviation in yaw"),
        "gain on the deviation in yaw";
    YAW_RATE_GAIN "yaw_rate_gain", Quantity("1/s", Positive),
        Value(3.2, "3.2 1/s", "gain on the deviation of the yaw rate"),
        "gain on the deviation of the yaw rate";
    FORGETTING "forgetting", Quantity("1", Positive),
        Value(0.95, "0.95", "forgetting factor of the estimator per sample"),
        "the forgetting factor of the estimator per sample, between 0 and 1";
    THRESHOLD "threshold", Quantity("1", Positive),
        Value(6.0, "6", "standard deviations beyond which the estimator uses a sample"),
        "the estimator uses a sample, and the nineteen after it, if its residual exceeds this many standard \
            deviations of the torque noise".bounds(1e-3, 1e6);
    GYROSCOPE_NOISE "gyroscope_noise", Quantity("rad/s", NotNegative),
        Value(0.005, "0.005 rad/s", "standard deviation of a sample of a small MEMS gyroscope"),
        "the standard deviation of the noise in samples of each body rate";
    GYROSCOPE_RANGE "gyroscope_range", Quantity("deg/s", Positive),
        Value(34.906_585_039_886_59, "2000 deg/s", "range of the gyroscopes of most flight controllers"),
        "the largest body rate on each axis that the gyroscope measures; larger rates read as this rate";
    ASSUMED_GYROSCOPE_NOISE "assumed_gyroscope_noise", Quantity("rad/s", NotNegative), Otherwise("`gyroscope_noise`"),
        "the gyroscope noise that the estimator assumes, to simulate worse sensors";
    ATTITUDE "attitude", Words(&["exact", "estimated"]), Written("exact", "the controller knows the attitude"),
        "`exact`: the controller knows the attitude; `estimated`: it integrates the gyroscope, with its noise and \
         range, and corrects it slowly";
    POSITION_NOISE "position_noise", Quantity("m", NotNegative),
        Value(0.01, "1 cm", "standard deviation of a sample on each axis"),
        "the standard deviation of the noise in position samples, on each axis";
    DRAG "drag", QuantityOrVector("N*s/m", NotNegative), Value(0.0, "0 N*s/m", "as in the paper's model"),
        "the drag force divided by the speed through the air, one number or `[x, y, z]` along the axes of the \
            body; the vehicle's, if any, replaces the default";
    WIND "wind", Vector("m/s", Any), Written("[0, 0, 0] m/s", "still air"),
        "the velocity of the air, x east, y north, z up; the mission's [air](#air) replaces the default. Wind acts \
            only through `drag`"
        .bounds(0.0, 1e4);
    GUSTS "gusts", Quantity("m/s", NotNegative), Value(0.0, "0 m/s", "still air"),
        "the standard deviation of the gusts on each axis; the mission's [air](#air) replaces the default"
        .bounds(0.0, 1e4);
    GUST_LENGTH "gust_length", Quantity("m", Positive), Value(50.0, "50 m", "length scale of gusts"),
        "the length scale of the gusts (Dryden)".bounds(1e-6, 1e9);
    TORQUE_GUSTS "torque_gusts", Quantity("N*m", NotNegative), Value(0.0, "0 N*m", "gusts do not turn the vehicle"),
        "the standard deviation of the torque of gusts about each axis of the body".bounds(0.0, 1e4);
    SPREAD "spread", Words(&["middle", "drawn"]), Written("middle", "the vehicle that the controller assumes"),
        "the vehicle that flies: with the `middle` of each interval, as the controller assumes, or with values \
            `drawn` evenly from the intervals by the seed";
    CENTRE_OFFSET "centre_offset", Quantity("m", NotNegative),
        Value(0.0, "0 m", "the centre of gravity is where the spec places it"),
        "the largest offset of the centre of gravity along x and y of the body, drawn evenly by the seed and unknown \
         to the controller".bounds(0.0, 1e4);
    SEED "seed", Whole(0, 1 << 53), Value(1.0, "1", "seed of noise and gusts"),
        "the seed of noise and gusts: the same seed gives the same flight";
    LOST_BEYOND "lost_beyond", Quantity("m", Positive),
        Value(2.0, "2 m", "farther from its reference the vehicle is lost"),
        "the vehicle is lost when it is farther than this from its reference";
    UPSIDE_DOWN "upside_down", Quantity("s", Positive),
        Value(0.5, "0.5 s", "tilted past 90 degrees for longer, the vehicle is lost"),
        "the vehicle is lost when it is tilted past 90 deg for longer than this, or at the end of the flight";
    LOST_YAW "lost_yaw", QuantityOr("deg", Positive, &["off"]),
        Value(FRAC_PI_2, "90 deg", "with a larger heading error the vehicle is lost"),
        "the vehicle is lost when its heading error exceeds this for longer than `lost_yaw_after`, or at the end of \
         the flight; below 180 deg. `off`: the heading does not matter";
    LOST_YAW_AFTER "lost_yaw_after", Quantity("s", Positive),
        Value(1.0, "1 s", "how long the heading error may exceed `lost_yaw`"),
        "how long the heading error may exceed `lost_yaw` ([how it is \
         counted](flight.md#5-after-a-fault-and-when-the-vehicle-is-lost))";
    GROUND "ground", Quantity("m", Any), Value(0.0, "0 m", "height of the ground"),
        "the height of the ground, below every waypoint. The [mission](#mission)'s, if any, replaces the default; \
            otherwise, if the lowest waypoint is not above 0 m, the default is 1 m below it";
}

group! {
    /// The clauses of `fault` in `simulate`.
    strike:
    AT "at", Quantity("s", NotNegative), Needed, "when the fault strikes, counted from the start of the mission";
    UNTIL "until", Quantity("s", Any), Otherwise("the fault stays"), "when the faulty rotors recover, counted as \
        for `at`";
}

group! {
    /// The fields of `campaign { }`.
    campaign:
    TIMES "times", Whole(1, 10_000), Value(20.0, "20", "fault instants along the mission"),
        "the number of fault instants, evenly spread over the mission";
    SEEDS "seeds", Whole(1, 1_000_000), Value(10.0, "10", "flights for each mode and instant"),
        "the number of flights for each mode and instant, each with its own noise";
    PLANNERS "planners", WordList(&["rip", "rsp", "rcp"]), Written("[rip, rsp, rcp]", "planners whose plans are flown"),
        "the planners whose plans are flown: one, or a list";
    SEED "seed", Whole(0, 1 << 53), Value(1.0, "1", "seed from which the seeds of the flights are drawn"),
        "the seed from which the seeds of the flights are drawn";
}
