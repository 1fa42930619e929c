//! The upright rule of the exact model, (68) of `docs/method/exact-model.md`, and (90e) where the drag differs
//! along x and y.

use crate::flatness::rotor_drag::Attitude;
use crate::model::Environment;
use crate::motion::{NodeState, Z, attitude, in_air};
use crate::planner::limits::Widening;
use crate::planner::transcription::Transcription;
use crate::qp::RowOrigin;
use crate::qp::build::Builder;
use crate::tolerance::{LEAST_PRODUCT, UPRIGHT};

impl Transcription<'_> {
    /// The row (68): z'' + g >= [`UPRIGHT`] g, with drag in addition; of the extreme winds the last, which lifts most.
    pub(super) fn upright(&self, builder: &mut Builder, instant: usize, widening: &Widening) {
        // The vertical part does not depend on the horizontal wind.
        let Some(wind) = self.winds.last() else { return };
        // Where the drag differs along x and y, one row for each of alpha and beta (90e).
        let [x, y, _] = wind.drag_rates;
        let rates = if wind.turns_alike() { vec![x] } else { vec![x, y] };
        for rate in rates {
            let [.., z] = self.thrust(instant, &Environment { drag_rates: [rate; 3], ..*wind });
            let mut row = z.plus_constant(-wind.gravity);
            row.add(&widening.bound(wind.gravity, 2, 1.0), 1.0 - UPRIGHT);
            builder.nonnegative(row, RowOrigin::Upright { node: instant / self.parts });
        }
    }

    /// The violation of (68) by a state, as a share of gravity; negative inside.
    pub(super) fn violation_upright(&self, state: &NodeState) -> f64 {
        let short = |wind: &Environment| match wind.turns_alike() {
            true => UPRIGHT - 1.0 - in_air(state, wind)[Z][2] / wind.gravity,
            false => {
                let Attitude { lift, product, .. } = attitude(state, wind);
                (UPRIGHT - lift).max(LEAST_PRODUCT - product)
            }
        };
        self.winds.iter().map(short).fold(f64::NEG_INFINITY, f64::max)
    }
}
