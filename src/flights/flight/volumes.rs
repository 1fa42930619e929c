//! The volumes of a mission in a flight: whether the vehicle enters a `keep_out` or leaves a `keep_in`, and whether a
//! stop would (`docs/flight.md`, section 5).

use super::reference::Stop;
use crate::model::{Limit, LimitKind, Mission, Vehicle, Volume, VolumeSide};
use nalgebra::Vector3;

/// The vehicle has entered a volume, or left it, where some part of it may be this far past the boundary, m. Plans may
/// touch a volume that has no clearance, so less is the tracking error of a flight that keeps to its plan.
pub const PAST_BOUNDARY: f64 = 0.1;

/// A stop is judged at instants this far apart, s.
const STEP: f64 = 0.02;

/// Whose volumes are watched, with the limits on the centre of gravity that keep the vehicle outside or inside.
#[derive(Debug, Clone, Default)]
pub(super) struct Volumes {
    /// Without clearances: for the vehicle itself.
    touched: Vec<KeptLimit>,
    /// With clearances: for the path of a stop.
    kept: Vec<KeptLimit>,
    /// z of the ground, m.
    ground: f64,
    /// How far beyond a `keep_in` a damaged vehicle may be, m.
    buffer: f64,
}

#[derive(Debug, Clone)]
struct KeptLimit {
    limit: Limit,
    is_keep_in: bool,
}

impl KeptLimit {
    /// A landing passes the lower end of a `keep_in`.
    fn holds(&self, lands: bool) -> bool {
        let bounds_below = self.limit.kind == LimitKind::Z && self.limit.lower.is_some();
        !(lands && self.is_keep_in && bounds_below)
    }
}

impl Volumes {
    pub(super) fn of(mission: Option<&Mission>, vehicle: &Vehicle, ground: f64) -> Self {
        let Some(mission) = mission else { return Volumes::default() };
        let size = vehicle.radius();
        let bounds = |clearance: fn(&Volume) -> f64| {
            let of_volume = move |volume: &Volume| {
                let is_keep_in = volume.side == VolumeSide::KeepIn;
                let limits = Volume { clearance: clearance(volume), ..volume.clone() }.limits(size);
                limits.into_iter().map(move |limit| KeptLimit { limit, is_keep_in })
            };
            mission.volumes.iter().flat_map(of_volume).collect()
        };
        Volumes {
            touched: bounds(|_| 0.0),
            kept: bounds(|volume| volume.clearance),
            ground,
            buffer: mission.after_fault.buffer,
        }
    }

    /// From now on the vehicle may be beyond every `keep_in` by the mission's `buffer`.
    pub(super) fn widen(&mut self) {
        let wider = self.touched.iter_mut().filter(|bound| bound.is_keep_in);
        wider.for_each(|bound| bound.limit = bound.limit.widened(self.buffer));
    }

    /// Whether the vehicle at a place (m) is past the boundary of a volume.
    pub(super) fn is_past(&self, place: &Vector3<f64>, lands: bool) -> bool {
        any_past(&self.touched, place, lands, PAST_BOUNDARY)
    }

    /// Whether the path of a stop that begins at `begin` s, and the descent after it if it `lands`, keeps the volumes.
    pub(super) fn are_kept_by(&self, stop: &Stop, begin: f64, lands: bool) -> bool {
        if self.kept.is_empty() {
            return true;
        }
        let steps = ((stop.at_rest() - begin) / STEP).ceil() as usize;
        let rest = stop.place_of_rest();
        let on_the_way = (0..=steps).map(|k| stop.at((begin + STEP * k as f64).min(stop.at_rest())).position);
        let below = if lands { ((rest.z - self.ground) / PAST_BOUNDARY).ceil().max(0.0) as usize } else { 0 };
        let descent = (1..=below).map(|k| Vector3::new(rest.x, rest.y, rest.z - PAST_BOUNDARY * k as f64));
        // The plan itself may be past a limit by what its check accepts.
        !on_the_way.chain(descent).any(|place| any_past(&self.kept, &place, lands, crate::tolerance::MOST_PAST_LIMIT))
    }
}

fn any_past(bounds: &[KeptLimit], place: &Vector3<f64>, lands: bool, by: f64) -> bool {
    let place = (*place).into();
    let is_past = |bound: &&KeptLimit| {
        !bound.limit.is_violated_by_less(place, by) && bound.limit.violation_at(place).is_some_and(|past| past > by)
    };
    bounds.iter().filter(|bound| bound.holds(lands)).any(|bound| is_past(&bound))
}
