//! Capture heights, which the checker takes from the certificate: what is not a height, what the motion does not keep,
//! and whether a height that nobody simulated is called a claim.

use super::{Kind, Known, evaluated, grown};
use crate::numbers::Numbers;
use crate::specs::Spec;
use crate::truth::Falsehood;
use mavc::certificate::Certificate;
use mavc::motion::{X, Y, Z};
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("a capture height that is not a height", &[], |s, n| {
        let height = [0.0, -0.0, -n.magnitude(1e-6, 1e6), f64::NAN, f64::INFINITY, f64::NEG_INFINITY][n.below(6)];
        s.capture_height.and_then(|_| given(s, Some(height)))
    }),
    evaluated("a capture height that the spec does not require", &[], |s, n| match s.capture_height {
        None => given(s, Some(n.magnitude(1e-3, 1e3))),
        Some(_) => None,
    }),
    evaluated("a capture height above the motion's", &[], above),
    evaluated("a capture height left", &[Premise::Limits], left),
    Kind {
        name: "a capture height that nobody simulated",
        known: Known::Weaker("the certificate claims"),
        premises: &[],
        make: unsimulated,
    },
    Kind {
        name: "a capture height left out",
        known: Known::Weaker("the certificate gives no height"),
        premises: &[],
        make: |s, _| s.capture_height.and_then(|_| given(s, None)),
    },
];

fn given(spec: &Spec, height: Option<f64>) -> Option<Certificate> {
    Some(Certificate { capture_height_m: height, ..spec.certificate() })
}

/// Above the waypoints that keep it.
fn above(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    given(spec, Some(spec.capture_height? * (1.0 + numbers.magnitude(2e-3, 100.0))))
}

/// Below what the motion keeps, which is therefore true; where it comes from is not known.
fn unsimulated(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let height = spec.capture_height?;
    given(spec, Some(height * numbers.between(0.9, 0.999)))
}

/// Too low on the way, or too far from start and end while it is low.
fn left(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let height = spec.capture_height?;
    let axis = [X, Y, Z][numbers.below(3)];
    let is_left = |motion: &mavc::motion::Trajectory, found: Option<Falsehood>| {
        found.is_none() && !spec.truth.keeps_height(motion, height)
    };
    let motion = grown(spec, numbers, (axis, 0), is_left)?;
    Some(spec.claiming(&motion))
}
