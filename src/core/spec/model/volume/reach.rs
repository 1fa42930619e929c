//! The box that has everything that a body and its margin forbid: beyond it nothing has to be computed from the body's
//! corners.

use crate::body::BoundingBox;
use crate::model::{Limit, LimitKind};

/// Lowest and highest coordinates, m.
#[derive(Debug, Clone, Copy)]
pub struct Reach {
    low: [f64; 3],
    high: [f64; 3],
}

impl Reach {
    /// The reach of a limit that keeps out of a body; `None` for any other limit.
    pub fn of(limit: &Limit) -> Option<Self> {
        let LimitKind::Clearance(obstacle) = &limit.kind else { return None };
        let margin = limit.lower?;
        let BoundingBox { low, high } = obstacle.around;
        Some(Reach { low: low.map(|x| x - margin), high: high.map(|x| x + margin) })
    }

    pub fn contains(&self, p: [f64; 3]) -> bool {
        (0..3).all(|i| self.low[i] <= p[i] && p[i] <= self.high[i])
    }

    /// Whether the straight line between two points passes through the box.
    pub fn meets(&self, [a, b]: [[f64; 3]; 2]) -> bool {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for i in 0..3 {
            let way = b[i] - a[i];
            if way == 0.0 {
                if a[i] < self.low[i] || a[i] > self.high[i] {
                    return false;
                }
                continue;
            }
            let [one, other] = [self.low[i], self.high[i]].map(|plane| (plane - a[i]) / way);
            (first, last) = (first.max(one.min(other)), last.min(one.max(other)));
        }
        first <= last
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;
    use crate::model::{Volume, VolumeSide};
    use crate::source::Span;

    /// What a limit forbids lies in its box.
    #[test]
    fn nothing_is_forbidden_beyond() {
        let bodies = [
            Body::Prism { corners: vec![[0.0, 0.0], [3.0, 1.0], [1.0, 2.5]], bottom: -1.0, top: 2.0 },
            Body::Cylinder { centre: [1.0, -2.0], radius: 1.5, bottom: 0.0, top: 3.0 },
            Body::Ball { centre: [1.0, 2.0, 1.0], radius: 2.0 },
            Body::HalfSpace { normal: [0.6, 0.0, 0.8], offset: 1.0 },
        ];
        for body in bodies {
            let (side, span) = (VolumeSide::KeepOut, Span::default());
            let volume = Volume { name: "x".into(), side, bodies: vec![body], clearance: 0.4, span };
            let limit = &volume.limits(0.3)[0];
            let reach = Reach::of(limit).unwrap();
            let steps = || (-12..=12).map(|i| 0.5 * f64::from(i));
            let all = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z])));
            let forbidden: Vec<[f64; 3]> = all.filter(|p| limit.violation_at(*p).unwrap() > 0.0).collect();
            assert!(forbidden.len() > 100 && forbidden.iter().all(|p| reach.contains(*p)), "{volume:?}");
        }
    }

    #[test]
    fn lines_meet_the_box_where_points_of_them_lie_in_it() {
        let mut seed = 11_u64;
        let mut place = || {
            [0; 3].map(|_| {
                seed = seed * 48_271 % 0x7fff_ffff;
                (seed % 9) as f64 - 4.0
            })
        };
        let reach = Reach { low: [-1.5, -2.5, -0.5], high: [1.5, 0.5, 2.5] };
        let mut met = 0;
        for _ in 0..2_000 {
            let (a, b) = (place(), place());
            let point = |k: i32| [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * f64::from(k) / 840.0);
            // With steps of 1/840 no plane at a half is passed between two points, whatever the whole numbers.
            let is_met = (0..=840).any(|k| reach.contains(point(k)));
            assert!(!is_met || reach.meets([a, b]), "{a:?} {b:?}");
            // A line may touch an edge of the box between two points.
            let grown = Reach { low: reach.low.map(|x| x - 0.02), high: reach.high.map(|x| x + 0.02) };
            assert!(!reach.meets([a, b]) || (0..=840).any(|k| grown.contains(point(k))), "{a:?} {b:?}");
            met += usize::from(is_met);
        }
        assert!(met > 300 && met < 1_900, "{met}");
    }
}
