//! The air of a mission, and what it does to the vehicle that flies there.

use super::Model;
use crate::source::Span;

/// Density for which the coefficients of rotors and drag are given: that of the standard atmosphere at sea level,
/// kg/m^3 (ISO 2533).
pub const STANDARD_DENSITY: f64 = 1.225;

/// The air of a mission.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Air {
    /// Middle of the steady winds that are possible, m/s: x east, y north, z up.
    pub wind: [f64; 3],
    /// Largest deviation of the wind from its middle on each axis, m/s; constant during the mission.
    pub wind_spread: [f64; 3],
    /// Standard deviation of the gusts on each axis, m/s. Only flights have gusts.
    pub gusts: f64,
    /// Density divided by [`STANDARD_DENSITY`].
    pub density_ratio: f64,
    /// The place of the block.
    pub span: Span,
}

/// What acts on the vehicle besides its rotors, by the equation of motion
/// `m c b_3 = m (a + g e_z) + R D R^T (v - wind)`, where c is the thrust over mass, b_3 the third axis of the body, R
/// its attitude and D the diagonal matrix of the drag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Environment {
    /// Acceleration of gravity g, m/s^2.
    pub gravity: f64,
    /// Drag over mass along the axes x, y and z of the body, 1/s.
    pub drag_rates: [f64; 3],
    /// Velocity of the air, m/s; the middle of the possible winds.
    pub wind: [f64; 3],
    /// Largest deviation of the wind from its middle on each axis, m/s.
    pub wind_spread: [f64; 3],
    /// The yaw of the mission's start, rad, if the attitude at rest depends on yaw; otherwise 0.
    pub yaw_at_rest: f64,
}

impl Environment {
    /// No drag.
    pub fn vacuum(gravity: f64) -> Self {
        Environment { gravity, drag_rates: [0.0; 3], wind: [0.0; 3], wind_spread: [0.0; 3], yaw_at_rest: 0.0 }
    }

    /// Whether the air acts on the vehicle.
    pub fn has_drag(&self) -> bool {
        self.drag_rates != [0.0; 3]
    }

    /// Whether the drag is the same along all axes of the body.
    pub fn is_isotropic(&self) -> bool {
        self.drag_rates.iter().all(|rate| *rate == self.drag_rates[0])
    }

    /// Whether the drag is the same along x and y, so that the attitude follows from the motion as with the drag of x
    /// along all axes: the drag along z only adds to the thrust.
    pub fn turns_alike(&self) -> bool {
        self.drag_rates[0] == self.drag_rates[1]
    }

    /// The rate of an isotropic drag with the same attitude, 1/s: that of x and y. Where these differ their mean, with
    /// which the attitude is approximate.
    pub fn turning_rate(&self) -> f64 {
        match self.turns_alike() {
            true => self.drag_rates[0],
            false => 0.5 * (self.drag_rates[0] + self.drag_rates[1]),
        }
    }

    /// The smallest and the largest of the three rates, 1/s.
    pub fn extreme_rates(&self) -> [f64; 2] {
        let [x, y, z] = self.drag_rates;
        [x.min(y).min(z), x.max(y).max(z)]
    }

    /// Whether more than one wind is possible, and it matters.
    pub fn is_uncertain(&self) -> bool {
        self.has_drag() && self.wind_spread.iter().any(|spread| *spread > 0.0)
    }

    /// The environments with one wind for each corner of the box of possible winds; itself where only one wind is
    /// possible.
    pub fn corners(&self) -> Vec<Environment> {
        let mut all = vec![Environment { wind_spread: [0.0; 3], ..*self }];
        for axis in (0..3).filter(|&axis| self.has_drag() && self.wind_spread[axis] > 0.0) {
            let moved = |from: &Environment, side: f64| {
                let mut to = *from;
                to.wind[axis] += side * self.wind_spread[axis];
                to
            };
            all = all.iter().flat_map(|from| [moved(from, -1.0), moved(from, 1.0)]).collect();
        }
        all
    }

    /// The thrust over mass at rest with isotropic drag, `g e_z - drag/m wind`, m/s^2: what the rotors give to stay in
    /// place.
    pub fn trim(&self) -> [f64; 3] {
        let [x, y, z] = self.wind.map(|w| -self.drag_rates[0] * w);
        [x, y, z + self.gravity]
    }
}

impl Model {
    /// What acts on the vehicle during the mission.
    pub fn environment(&self) -> Environment {
        let air = self.mission.as_ref().map(|mission| &mission.air);
        let drag_rates = self.vehicle.drag.map(|drag| drag / self.vehicle.mass);
        let start = self.mission.as_ref().and_then(|mission| mission.waypoints.first());
        let yaw = start.filter(|_| drag_rates[0] != drag_rates[1]).map(|start| start.yaw);
        Environment {
            gravity: self.gravity,
            drag_rates,
            wind: air.map_or([0.0; 3], |air| air.wind),
            wind_spread: air.map_or([0.0; 3], |air| air.wind_spread),
            yaw_at_rest: yaw.unwrap_or(0.0),
        }
    }
}

impl Air {
    /// Still air of the standard density.
    pub fn still(span: Span) -> Self {
        Air { density_ratio: 1.0, span, ..Air::default() }
    }
}
