//! The rows of a core: the thrusts and the roll and pitch torques for which some yaw torque between two bounds is in a
//! set.
//!
//! Elimination after Fourier and Motzkin adds each plane that bounds the yaw torque from above to each that bounds it
//! from below. Those are two planes of the set, or one of them and a bound on the torque. The first kind together bound
//! the shadow of the set along tau_z, which [`Generators::shadow`] gives directly: some hundred rows in place of twenty
//! million for 32 rotors. Only where intervals or the pseudo-inverse move the planes are the pairs taken one after the
//! other.

use super::Row;
use crate::model::{Allocation, Vehicle};
use crate::verify::cost::times;
use crate::verify::interval::Interval;
use crate::verify::sets::{Generators, Plane, planes_at_most, shadow_at_most};

/// The set and the bounds on the yaw torque, N m.
pub(super) struct Elimination<'s> {
    pub planes: &'s [Plane],
    pub generators: &'s Generators,
    pub torques: [Interval; 2],
}

impl Elimination<'_> {
    /// Calls `found` with every row.
    pub fn rows(&self, mut found: impl FnMut(Row)) {
        let [low, high] = self.torques;
        let most = Interval::around_zero(low.magnitude().max(high.magnitude()));
        for plane in self.planes {
            let [t, x, y, z] = plane.normal;
            // The yaw torque that the plane bounds least; whatever it is where the sign of z is open.
            let torque = if z.low > 0.0 {
                low
            } else if z.high < 0.0 {
                high
            } else {
                most
            };
            let row = Row::new([t, x, y], plane.offset - z * torque);
            if row.bounds() {
                found(row);
            }
        }
        match self.generators.shadow() {
            Some(shadow) => of_shadow(&shadow, found),
            None => of_pairs(self.planes, found),
        }
    }
}

/// The rows of the shadow of a set, whatever the yaw torque; `false` if the set cannot be computed.
pub(super) fn shadow_rows(generators: &Generators, mut found: impl FnMut(Row)) -> bool {
    if let Some(shadow) = generators.shadow() {
        of_shadow(&shadow, found);
        return true;
    }
    let Ok(planes) = generators.planes() else { return false };
    for plane in planes.iter().filter(|plane| plane.normal[3].contains(0.0)) {
        let [t, x, y, _] = plane.normal;
        found(Row::new([t, x, y], plane.offset));
    }
    of_pairs(&planes, found);
    true
}

fn of_shadow(shadow: &[Plane], mut found: impl FnMut(Row)) {
    for plane in shadow {
        let [t, x, y, _] = plane.normal;
        found(Row::new([t, x, y], plane.offset));
    }
}

/// Each plane that bounds the yaw torque from above with each that bounds it from below.
fn of_pairs(planes: &[Plane], mut found: impl FnMut(Row)) {
    let over = |plane: &Plane| {
        let [t, x, y, z] = plane.normal;
        ([t / z, x / z, y / z], plane.offset / z)
    };
    let below: Vec<_> = planes.iter().filter(|plane| plane.normal[3].high < 0.0).map(over).collect();
    for (up, above) in planes.iter().filter(|plane| plane.normal[3].low > 0.0).map(over) {
        for (down, below) in &below {
            let head: [Interval; 3] = std::array::from_fn(|i| up[i] - down[i]);
            let row = Row::new(head, above - *below);
            if row.bounds() {
                found(row);
            }
        }
    }
}

impl Row {
    /// Whether it bounds thrust or torque at all.
    fn bounds(&self) -> bool {
        self.thrust.magnitude() > 0.0 || self.torque.magnitude() > 0.0
    }
}

/// Most rows of [`Elimination::rows`].
pub(super) fn rows_at_most(vehicle: &Vehicle) -> u64 {
    planes_at_most(vehicle).saturating_add(shadow_rows_at_most(vehicle))
}

/// Most rows of [`shadow_rows`].
pub(super) fn shadow_rows_at_most(vehicle: &Vehicle) -> u64 {
    let planes = planes_at_most(vehicle);
    match vehicle.is_uncertain() || vehicle.allocation == Allocation::PseudoInverse {
        // Half of them bound the yaw torque from above at most times half of them from below.
        true => times(planes.div_ceil(2), planes.div_ceil(2)).saturating_add(planes),
        false => shadow_at_most(vehicle),
    }
}
