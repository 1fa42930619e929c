//! Convex bodies in space: the distance of a point, and the plane that separates it.

/// A convex body; lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// A vertical prism over a convex polygon with at least three corners, counter-clockwise seen from above.
    Prism {
        corners: Vec<[f64; 2]>,
        bottom: f64,
        top: f64,
    },
    /// A vertical cylinder.
    Cylinder {
        centre: [f64; 2],
        radius: f64,
        bottom: f64,
        top: f64,
    },
    Ball {
        centre: [f64; 3],
        radius: f64,
    },
    /// `{ p : normal . p <= offset }` with a unit normal.
    HalfSpace {
        normal: [f64; 3],
        offset: f64,
    },
}

/// The plane that separates a point from a body best: among all unit normals n it maximises `n.p - h(n)`, where h is
/// the support function of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Unit normal, from the body to the point.
    pub normal: [f64; 3],
    /// h(normal), m: no point of the body has a larger `normal . p`.
    pub support: f64,
    /// `normal . p - support`, m: the distance of the point from the body, or inside it the negative depth.
    pub distance: f64,
}

impl Body {
    /// The separation of the point `p` (m). The gradient of the distance is its normal; where the nearest point is not
    /// unique, it is one of several.
    pub fn separation(&self, p: [f64; 3]) -> Separation {
        let (normal, distance) = match self {
            Body::Prism { bottom, top, .. } | Body::Cylinder { bottom, top, .. } => {
                let (across, distance) = self.seen_from_above([p[0], p[1]]);
                upright(across, distance, p[2], *bottom, *top)
            }
            Body::Ball { centre, radius } => {
                let (direction, length) = unit([0, 1, 2].map(|i| p[i] - centre[i]), [1.0, 0.0, 0.0]);
                (direction, length - radius)
            }
            Body::HalfSpace { normal, offset } => (*normal, dot(*normal, p) - offset),
        };
        Separation { normal, support: dot(normal, p) - distance, distance }
    }

    /// The gradient and the signed distance (m, negative inside) of a point from the body's outline seen from above. A
    /// half space has none unless its boundary is vertical, and covers everything otherwise.
    pub fn seen_from_above(&self, p: [f64; 2]) -> ([f64; 2], f64) {
        match self {
            Body::Prism { corners, .. } => outline(corners, p),
            Body::Cylinder { centre, radius, .. } => {
                let (direction, length) = unit([p[0] - centre[0], p[1] - centre[1]], [1.0, 0.0]);
                (direction, length - radius)
            }
            Body::Ball { centre, radius } => {
                let (direction, length) = unit([p[0] - centre[0], p[1] - centre[1]], [1.0, 0.0]);
                (direction, length - radius)
            }
            Body::HalfSpace { normal: [x, y, 0.0], offset } => ([*x, *y], x * p[0] + y * p[1] - offset),
            Body::HalfSpace { .. } => ([1.0, 0.0], f64::NEG_INFINITY),
        }
    }
}

impl Body {
    /// The lowest and the highest coordinates of the body, m; infinite for a half space.
    pub fn extent(&self) -> ([f64; 3], [f64; 3]) {
        match self {
            Body::Prism { corners, bottom, top } => {
                let ends = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
                    corners.iter().map(|c| c[axis]).fold(start, pick)
                };
                let low = |axis| ends(axis, f64::min, f64::INFINITY);
                let high = |axis| ends(axis, f64::max, f64::NEG_INFINITY);
                ([low(0), low(1), *bottom], [high(0), high(1), *top])
            }
            Body::Cylinder { centre: [x, y], radius, bottom, top } => {
                ([x - radius, y - radius, *bottom], [x + radius, y + radius, *top])
            }
            Body::Ball { centre, radius } => (centre.map(|c| c - radius), centre.map(|c| c + radius)),
            Body::HalfSpace { .. } => ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]),
        }
    }
}

/// The box about a body, which is much quicker to measure from than a polygon of many corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    /// The lowest coordinates, m.
    pub low: [f64; 3],
    /// The highest coordinates, m.
    pub high: [f64; 3],
}

impl BoundingBox {
    /// The box about a body.
    pub fn of(body: &Body) -> Self {
        let (low, high) = body.extent();
        BoundingBox { low, high }
    }

    /// Whether every point of the box is further than `distance` (m) from `p`, with room for rounding. The distance of
    /// `p` from the body is then larger too.
    pub fn is_further(&self, p: [f64; 3], distance: f64) -> bool {
        let off = |i: usize| (self.low[i] - p[i]).max(p[i] - self.high[i]).max(0.0);
        let square: f64 = (0..3).map(|i| off(i) * off(i)).sum();
        square > ((distance + ROUNDING) * (1.0 + ROUNDING)).max(0.0).powi(2)
    }
}

/// A body with the box about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    pub body: Body,
    pub around: BoundingBox,
}

impl Obstacle {
    pub fn of(body: Body) -> Self {
        Obstacle { around: BoundingBox::of(&body), body }
    }
}

/// Room for rounding in [`BoundingBox::is_further`], m and as a share.
const ROUNDING: f64 = 1e-6;

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The unit vector along `v` and the length of `v`; `otherwise` for the zero vector.
fn unit<const N: usize>(v: [f64; N], otherwise: [f64; N]) -> ([f64; N], f64) {
    let length = dot(v, v).sqrt();
    if length > 0.0 { (v.map(|x| x / length), length) } else { (otherwise, 0.0) }
}

/// The gradient and signed distance of a point from a convex polygon in the plane.
fn outline(corners: &[[f64; 2]], p: [f64; 2]) -> ([f64; 2], f64) {
    let mut nearest = ([1.0, 0.0], f64::INFINITY);
    let mut inside = ([1.0, 0.0], f64::NEG_INFINITY);
    for (i, &a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let ([x, y], length) = unit([b[0] - a[0], b[1] - a[1]], [1.0, 0.0]);
        let outward = [y, -x];
        let from = [p[0] - a[0], p[1] - a[1]];
        let depth = dot(outward, from);
        if depth > inside.1 {
            inside = (outward, depth);
        }
        let along = dot([x, y], from).clamp(0.0, length);
        let (direction, distance) = unit([from[0] - along * x, from[1] - along * y], outward);
        if distance < nearest.1 {
            nearest = (direction, distance);
        }
    }
    if inside.1 > 0.0 { nearest } else { inside }
}

/// The gradient and signed distance from a body with vertical walls, from those of its outline.
fn upright(across: [f64; 2], distance: f64, z: f64, bottom: f64, top: f64) -> ([f64; 3], f64) {
    let (up, vertical) = if z - top > bottom - z { (1.0, z - top) } else { (-1.0, bottom - z) };
    let [x, y] = across;
    if distance > 0.0 && vertical > 0.0 {
        let (direction, length) = unit([distance, vertical], [1.0, 0.0]);
        return ([x * direction[0], y * direction[0], up * direction[1]], length);
    }
    if distance >= vertical { ([x, y, 0.0], distance) } else { ([0.0, 0.0, up], vertical) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bodies() -> Vec<Body> {
        vec![
            Body::Prism { corners: vec![[0.0, 0.0], [4.0, 1.0], [3.0, 3.0]], bottom: -1.0, top: 2.0 },
            Body::Cylinder { centre: [1.0, -2.0], radius: 1.5, bottom: 0.0, top: 5.0 },
            Body::Ball { centre: [1.0, 2.0, 3.0], radius: 2.0 },
            Body::HalfSpace { normal: [0.6, 0.0, 0.8], offset: 1.0 },
        ]
    }

    /// Points on a lattice, and those of them that lie in a body.
    fn lattice() -> impl Iterator<Item = [f64; 3]> {
        let steps = || (-16..=16).map(|i| 0.5 * f64::from(i));
        steps().flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| [x, y, z])))
    }

    /// A box that is further than a distance shows that its body is, and shows it for almost all points that are much
    /// further.
    #[test]
    fn boxes_are_no_further_than_their_bodies() {
        for body in bodies() {
            let around = BoundingBox::of(&body);
            let (mut further, mut shown) = (0, 0);
            for p in lattice().step_by(7) {
                let distance = body.separation(p).distance;
                for least in [-1.0, 0.0, 0.3, 2.0] {
                    let is_shown = around.is_further(p, least);
                    assert!(distance > least || !is_shown, "{body:?} {p:?} {least}");
                    let is_near = distance < least + 3.0;
                    (further, shown) = (further + usize::from(!is_near), shown + usize::from(!is_near && is_shown));
                }
            }
            let is_bounded = !matches!(body, Body::HalfSpace { .. });
            assert!(!is_bounded || (further > 1_000 && 100 * shown > 90 * further), "{body:?}: {shown} of {further}");
        }
    }

    /// No point of the body lies beyond the plane, and the distance of some point of the body is near the one claimed.
    #[test]
    fn planes_separate_and_distances_are_attained() {
        for body in bodies() {
            let contained: Vec<[f64; 3]> = lattice().filter(|p| body.separation(*p).distance <= 0.0).collect();
            assert!(contained.len() > 30, "{body:?}");
            for p in lattice().step_by(97) {
                let Separation { normal, support, distance } = body.separation(p);
                assert!((dot(normal, normal) - 1.0).abs() < 1e-12);
                let beyond = contained.iter().map(|q| dot(normal, *q)).fold(f64::NEG_INFINITY, f64::max);
                assert!(beyond <= support + 1e-9, "{body:?} {p:?}");
                let apart = |q: &[f64; 3]| [0, 1, 2].map(|i| (p[i] - q[i]).powi(2)).iter().sum::<f64>().sqrt();
                let nearest = contained.iter().map(apart).fold(f64::INFINITY, f64::min);
                // The lattice has a point of a body within 1.1 m of each of its points.
                assert!(distance <= nearest + 1e-9 && nearest < distance.max(0.0) + 1.1, "{body:?} {p:?} {nearest}");
            }
        }
    }
}
