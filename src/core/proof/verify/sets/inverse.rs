//! The wrenches that the pseudo-inverse (42) gives without clipping, in exact arithmetic.
//!
//! Let a_k be the wrench of rotor k for one unit of squared speed, times its capacity, `G = sum of a_k a_k'`, and c the
//! wrench of stuck rotors. The squared speeds are `a_k . G^-1 (w - c)`. Using the adjugate instead of the inverse
//! avoids division: for each working rotor
//!
//! `det G w_min^2 <= (adj G a_k) . (w - c) <= det G w_max^2`.

use super::{Exact, is_zero, scaled, sum, wrench_at, zero};
use crate::model::{FaultMode, RotorState, Vehicle};
use crate::verify::dyadic::{Dyadic, dot, orthogonal};
use std::cmp::Ordering;

/// A row `n.w <= e`.
type Row = (Exact, Dyadic);

/// Why there are no rows.
pub(super) const NOT_ALL_GIVEN: &str =
    "the rotors do not give all four dimensions, so the checked formula of the pseudo-inverse does not apply";

/// Rows for each rotor, from 1.
#[derive(Debug, Clone)]
pub struct Inverse {
    /// `(rotor, upper, lower)`; empty if the rotors do not give all four dimensions.
    rows: Vec<(usize, Row, Row)>,
}

impl Inverse {
    pub(super) fn of(vehicle: &Vehicle, mode: Option<&FaultMode>) -> Self {
        let one = Dyadic::of(1.0);
        let mut offset = zero();
        let mut columns = Vec::new();
        for (k, rotor) in vehicle.rotors.iter().enumerate() {
            let unit = wrench_at(rotor, 1.0, &one, &one);
            columns.push(match mode.map_or(RotorState::Sound, |mode| mode.rotors[k]) {
                RotorState::Sound => unit,
                RotorState::Reduced(capacity) => scaled(&unit, capacity),
                RotorState::Stuck(share) => {
                    offset = sum(&offset, &scaled(&wrench_at(rotor, rotor.max_speed, &one, &one), share));
                    zero()
                }
                RotorState::Lost => zero(),
            });
        }
        let square: [Exact; 4] = std::array::from_fn(|i| {
            std::array::from_fn(|j| columns.iter().fold(Dyadic::zero(), |sum, a| sum.plus(&a[i].times(&a[j]))))
        });
        // Row i of the adjugate is orthogonal to all columns of G except the i-th; columns equal rows, as G is
        // symmetric.
        let adjugate: [Exact; 4] = std::array::from_fn(|i| {
            let others: Vec<&Exact> = (0..4).filter(|&j| j != i).map(|j| &square[j]).collect();
            let minors = orthogonal(others[0], others[1], others[2]);
            if i % 2 == 0 { minors } else { minors.map(|m| m.negated()) }
        });
        let determinant = dot(&adjugate[0], &square[0]);
        if determinant.sign() != Ordering::Greater {
            return Inverse { rows: Vec::new() };
        }
        let bounds = |(k, column): (usize, &Exact)| {
            let normal: Exact = adjugate.each_ref().map(|row| dot(row, column));
            let [least, most] = [vehicle.rotors[k].min_speed, vehicle.rotors[k].max_speed].map(|speed| {
                let speed = Dyadic::of(speed);
                determinant.times(&speed).times(&speed).plus(&dot(&normal, &offset))
            });
            let opposite = normal.each_ref().map(Dyadic::negated);
            (k + 1, (normal, most), (opposite, least.negated()))
        };
        Inverse { rows: columns.iter().enumerate().filter(|(_, a)| !is_zero(a)).map(bounds).collect() }
    }

    /// Both rows of a rotor, from 1.
    pub(super) fn bounds(&self, rotor: usize) -> Option<[Row; 2]> {
        let (_, upper, lower) = self.rows.iter().find(|r| r.0 == rotor)?;
        Some([upper.clone(), lower.clone()])
    }

    /// All rows with their rotors.
    ///
    /// # Errors
    /// The rotors do not give all four dimensions.
    pub(super) fn rows(&self) -> Result<Vec<(usize, Exact, Dyadic)>, String> {
        if self.rows.is_empty() {
            return Err(NOT_ALL_GIVEN.into());
        }
        let both = |(k, upper, lower): &(usize, Row, Row)| [upper, lower].map(|(n, e)| (*k, n.clone(), e.clone()));
        Ok(self.rows.iter().flat_map(both).collect())
    }
}
