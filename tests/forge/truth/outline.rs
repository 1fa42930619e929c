//! Volumes whose outline is a polygon, as the spec's text has it: before the compiler divides it into convex parts.

/// A prism that is not entered or not left.
#[derive(Debug, Clone)]
pub struct Outline {
    /// In order along the edge, m.
    pub corners: Vec<[f64; 2]>,
    pub bottom: f64,
    pub top: f64,
    /// A `keep_in`, whose outline is convex.
    pub keep_in: bool,
}

impl Outline {
    /// Whether a point lies inside, by the edges that a ray along x crosses.
    fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let crossed =
            self.edges().filter(|([a, b], [c, d])| (*b > y) != (*d > y) && x < a + (y - b) / (d - b) * (c - a));
        crossed.count() % 2 == 1
    }

    fn edges(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
        self.corners.iter().copied().zip(self.corners.iter().copied().cycle().skip(1))
    }

    /// The distance of a point from the edge, m.
    fn edge_distance(&self, [x, y]: [f64; 2]) -> f64 {
        let from = |([a, b], [c, d]): ([f64; 2], [f64; 2])| {
            let (u, v) = (c - a, d - b);
            let share = (((x - a) * u + (y - b) * v) / (u * u + v * v)).clamp(0.0, 1.0);
            (x - a - share * u).hypot(y - b - share * v)
        };
        self.edges().map(from).fold(f64::INFINITY, f64::min)
    }

    /// By how much a point comes nearer than a margin to what it may not enter, m.
    pub fn past(&self, [x, y, z]: [f64; 3], margin: f64) -> f64 {
        let (is_inside, edge) = (self.contains([x, y]), self.edge_distance([x, y]));
        let kept = match self.keep_in {
            true => if is_inside { edge } else { -edge }.min(z - self.bottom).min(self.top - z),
            false => {
                let across = if is_inside { 0.0 } else { edge };
                across.hypot((self.bottom - z).max(z - self.top).max(0.0))
            }
        };
        margin - kept
    }
}
