//! By how much a plan may miss the spec and still count as keeping it, at the nodes that the spec's samples ask for.
//! docs/certificates.md states what follows from these.

/// A waypoint may be missed by this beside its tolerance, m and rad.
pub const MOST_MISS: f64 = 1e-5;

/// A limit may be exceeded by this share of its size ([`crate::model::Limit::size`]).
pub const MOST_PAST_LIMIT: f64 = 1e-4;

/// A set may be left by this share of the healthy set's width, as reports count violations.
pub const MOST_OUTSIDE: f64 = 1e-4;

/// Upper end of the usual range of a limit on the speed, and of the speed of a plan without one, m/s
/// (docs/diagnostics/sense.md).
pub const USUAL_SPEED: f64 = 60.0;
