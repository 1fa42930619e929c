//! Where hover lies relative to a set: inside it, on its edge, or outside. One tolerance for every command.

use super::AdmissibleSet;
use crate::actuation::Wrench;
use serde::Serialize;

/// Hover is on the edge of a set if it lies within this of its boundary, N and N m alike, or within this of a flat set; of a
/// vehicle that weighs less than 1 N, within this share of the weight.
pub const EDGE: f64 = 1e-6;

/// How wide the edge is for a vehicle with this hover, N and N m alike.
pub fn width(hover: &Wrench) -> f64 {
    EDGE * hover[0].abs().min(1.0)
}

/// Where hover lies relative to a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Place {
    #[serde(rename = "inside")]
    Inside,
    /// In some direction the smallest disturbance cannot be countered.
    #[serde(rename = "on the edge")]
    OnEdge,
    #[serde(rename = "outside")]
    Outside,
}

impl Place {
    pub const fn word(self) -> &'static str {
        match self {
            Place::Inside => "inside",
            Place::OnEdge => "on the edge",
            Place::Outside => "outside",
        }
    }

    /// `margin`: signed distance to the boundary, positive inside; `None` where the set is flat and has no inside. `residual`:
    /// distance to the set. Both in N and N m, as is the [`width`] of the edge.
    pub fn new(margin: Option<f64>, residual: f64, width: f64) -> Self {
        match margin {
            _ if residual >= width => Place::Outside,
            Some(margin) if margin > width => Place::Inside,
            _ => Place::OnEdge,
        }
    }
}

impl AdmissibleSet {
    /// Whether hover lies inside, with all of thrust, roll, pitch and yaw in hand.
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
        let told = places.map(|(margin, residual)| Place::new(Some(margin), residual, EDGE).word());
        assert_eq!(told, ["inside", "on the edge", "on the edge", "outside"]);
        assert_eq!(Place::new(None, 0.0, EDGE), Place::OnEdge);
        let hovers = [0.001, 1.0, 20.0].map(|weight| width(&Wrench::new(weight, 0.0, 0.0, 0.0)));
        assert_eq!(hovers, [0.001 * EDGE, EDGE, EDGE]);
    }
}
