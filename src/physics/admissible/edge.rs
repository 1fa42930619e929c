//! Where hover lies relative to a set: inside, on the edge, or outside. All commands use this one tolerance
//! (`docs/method/verdicts.md`, "Reachable is not interior").

use super::AdmissibleSet;
use crate::actuation::Wrench;
use serde::Serialize;

pub use crate::tolerance::EDGE;

/// The width of the edge for a vehicle with this hover wrench, in N and N m alike: `EDGE * min(m g, 1 N)`.
pub fn width(hover: &Wrench) -> f64 {
    EDGE * hover[0].abs().min(1.0)
}

/// Where hover lies relative to a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub enum HoverPlace {
    /// Inside by more than the width of the edge.
    #[serde(rename = "inside")]
    Inside,
    /// On the boundary or in a flat set: in some direction even the smallest disturbance cannot be countered.
    #[serde(rename = "on the edge")]
    OnEdge,
    /// Outside by at least the width of the edge.
    #[serde(rename = "outside")]
    Outside,
}

#[deprecated = "renamed to `HoverPlace`"]
pub type Place = HoverPlace;

impl HoverPlace {
    /// The word that reports print: `inside`, `on the edge` or `outside`.
    pub const fn word(self) -> &'static str {
        match self {
            HoverPlace::Inside => "inside",
            HoverPlace::OnEdge => "on the edge",
            HoverPlace::Outside => "outside",
        }
    }

    /// Decides from the signed distance `margin` to the boundary (positive inside; `None` for a flat set, which has no
    /// inside) and the distance `residual` to the set. Both are in N and N m, like the [`width`] of the edge.
    pub fn new(margin: Option<f64>, residual: f64, width: f64) -> Self {
        match margin {
            _ if residual >= width => HoverPlace::Outside,
            Some(margin) if margin > width => HoverPlace::Inside,
            _ => HoverPlace::OnEdge,
        }
    }
}

impl AdmissibleSet {
    /// Whether hover lies inside the set with all four axes controlled: thrust, roll, pitch and yaw.
    pub fn has_hover_inside(&self) -> bool {
        self.polytope.equalities.is_empty() && self.polytope.margin(&self.hover) > width(&self.hover)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_is_as_wide_on_both_sides() {
        let places = [(2.0 * EDGE, 0.0), (0.5 * EDGE, 0.0), (-0.5 * EDGE, 0.5 * EDGE), (-2.0 * EDGE, 2.0 * EDGE)];
        let words = places.map(|(margin, residual)| HoverPlace::new(Some(margin), residual, EDGE).word());
        assert_eq!(words, ["inside", "on the edge", "on the edge", "outside"]);
        assert_eq!(HoverPlace::new(None, 0.0, EDGE), HoverPlace::OnEdge);
        let hovers = [0.001, 1.0, 20.0].map(|weight| width(&Wrench::new(weight, 0.0, 0.0, 0.0)));
        assert_eq!(hovers, [0.001 * EDGE, EDGE, EDGE]);
    }
}
