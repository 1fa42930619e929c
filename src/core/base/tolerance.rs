//! Tolerances within which a plan counts as satisfying the spec, at the nodes given by the spec's samples.
//! docs/certificates.md states the consequences.

/// A waypoint may be missed by this much more than its tolerance, m and rad.
pub const MOST_MISS: f64 = 1e-5;

/// A limit may be violated by this share of its size ([`crate::model::Limit::size`]).
pub const MOST_PAST_LIMIT: f64 = 1e-4;

/// Hover is on the edge of a set if its distance from the boundary, or from a flat set, is at most this, in N and N m
/// alike; for a vehicle that weighs less than 1 N, times its weight in N.
pub const EDGE: f64 = 1e-6;

/// A set may be violated by this share of the healthy set's width, in which reports measure violations.
pub const MOST_OUTSIDE: f64 = 1e-4;

/// In the exact model the vertical part of the thrust is at least this share of the weight, (68) of docs/method. Closer
/// to free fall, and upside down, ZYX angles jump, and the direction of a vanishing thrust is undefined.
pub const UPRIGHT: f64 = 0.1;

/// Where the drag differs along x and y, `alpha_f beta_f + alpha_u beta_u` is at least this times g^2:
/// docs/method/air.md, (90e).
pub const LEAST_PRODUCT: f64 = 0.5 * UPRIGHT * UPRIGHT;
