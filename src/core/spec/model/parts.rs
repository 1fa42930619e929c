//! A rigid vehicle from its parts: mass, centre of gravity, and inertia by the parallel-axis theorem (Huygens-Steiner).

/// A homogeneous part of a vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// kg
    pub mass: f64,
    /// Its centre of gravity from the frame's origin, m.
    pub centre: [f64; 3],
    pub shape: Shape,
}

/// The shape of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    Point,
    /// A box with these sides along the axes x, y and z, m.
    Box([f64; 3]),
    /// A thin rod; the vector from one end to the other, m.
    Rod([f64; 3]),
}

/// What parts make together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Composite {
    /// kg
    pub mass: f64,
    /// From the frame's origin, m.
    pub centre_of_gravity: [f64; 3],
    /// The inertia matrix about the centre of gravity, kg m^2, symmetric.
    pub inertia: [[f64; 3]; 3],
}

/// A centre of gravity nearer than this to the origin along an axis is on it, m: what the rounding of sums leaves of a
/// symmetric frame. Rotors then stay exactly symmetric.
const ON_AXIS: f64 = 1e-12;

/// `|r|^2 I - r r^T`: the inertia of a unit mass at r about the origin.
fn of_point(r: [f64; 3]) -> [[f64; 3]; 3] {
    let square = r.iter().map(|x| x * x).sum::<f64>();
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { square - r[i] * r[i] } else { -r[i] * r[j] }))
}

impl Part {
    /// The inertia matrix of a unit mass of this shape about its own centre, m^2.
    fn own(&self) -> [[f64; 3]; 3] {
        match self.shape {
            Shape::Point => [[0.0; 3]; 3],
            Shape::Box(sides) => {
                let [x, y, z] = sides.map(|side| side * side / 12.0);
                [[y + z, 0.0, 0.0], [0.0, x + z, 0.0], [0.0, 0.0, x + y]]
            }
            Shape::Rod(length) => of_point(length).map(|row| row.map(|x| x / 12.0)),
        }
    }
}

impl Composite {
    /// The whole of the parts; their total mass must be above zero.
    pub fn of(parts: &[Part]) -> Self {
        let mass: f64 = parts.iter().map(|part| part.mass).sum();
        let moment = |axis: usize| parts.iter().map(|part| part.mass * part.centre[axis]).sum::<f64>();
        let centre_of_gravity =
            [0, 1, 2].map(|axis| Some(moment(axis) / mass).filter(|c| c.abs() >= ON_AXIS).unwrap_or_default());
        let mut inertia = [[0.0; 3]; 3];
        for part in parts {
            let arm = std::array::from_fn(|axis| part.centre[axis] - centre_of_gravity[axis]);
            let (own, steiner) = (part.own(), of_point(arm));
            for (i, row) in inertia.iter_mut().enumerate() {
                row.iter_mut().enumerate().for_each(|(j, x)| *x += part.mass * (own[i][j] + steiner[i][j]));
            }
        }
        Composite { mass, centre_of_gravity, inertia }
    }

    /// The moments of inertia Ixx, Iyy, Izz, kg m^2.
    pub fn moments(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.inertia[axis][axis])
    }

    /// The two axes that a product of inertia couples most, and that product over the geometric mean of their moments:
    /// from 0 to 1.
    pub fn coupling(&self) -> ([usize; 2], f64) {
        let of = |[i, j]: [usize; 2]| {
            let scale = (self.inertia[i][i] * self.inertia[j][j]).sqrt();
            ([i, j], if scale > 0.0 { self.inertia[i][j].abs() / scale } else { 0.0 })
        };
        let pairs = [[0, 1], [0, 2], [1, 2]].map(of);
        pairs.into_iter().fold(pairs[0], |most, pair| if pair.1 > most.1 { pair } else { most })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12 * b.abs().max(1e-3), "{a} is not {b}");
    }

    fn part(mass: f64, centre: [f64; 3], shape: Shape) -> Part {
        Part { mass, centre, shape }
    }

    #[test]
    fn a_box_and_its_halves() {
        // m/12 (b^2 + c^2) and so on, wherever the box is.
        let whole = Composite::of(&[part(1.2, [0.3, -0.2, 0.1], Shape::Box([0.15, 0.07, 0.05]))]);
        assert_eq!(whole.centre_of_gravity, [0.3, -0.2, 0.1]);
        for (moment, expected) in
            whole.moments().into_iter().zip([0.1 * (0.0049 + 0.0025), 0.1 * (0.0225 + 0.0025), 0.1 * (0.0225 + 0.0049)])
        {
            near(moment, expected);
        }
        let halves = [-1.0, 1.0]
            .map(|side| part(0.6, [0.3 + side * 0.15 / 4.0, -0.2, 0.1], Shape::Box([0.15 / 2.0, 0.07, 0.05])));
        let halves = Composite::of(&halves);
        near(halves.mass, 1.2);
        for (of_halves, of_whole) in halves.moments().into_iter().zip(whole.moments()) {
            near(of_halves, of_whole);
        }
        near(halves.coupling().1, 0.0);
    }

    #[test]
    fn two_points_are_a_dumbbell() {
        // 1 kg and 3 kg at a distance of 0.4 m: the centre a quarter of the way from the heavy one, the inertia that of
        // the reduced mass 3/4 kg.
        let both = Composite::of(&[part(1.0, [0.4, 0.0, 0.0], Shape::Point), part(3.0, [0.0, 0.0, 0.0], Shape::Point)]);
        near(both.centre_of_gravity[0], 0.1);
        near(both.moments()[0], 0.0);
        near(both.moments()[1], 0.75 * 0.16);
        near(both.moments()[2], 0.75 * 0.16);
    }

    #[test]
    fn a_rod_about_its_end_and_aslant() {
        // From the origin to a heavy point there, which is then the centre of gravity: m l^2/3 about the end.
        let rod = part(0.06, [0.15, 0.0, 0.0], Shape::Rod([0.3, 0.0, 0.0]));
        let opposite = part(0.06, [-0.15, 0.0, 0.0], Shape::Rod([-0.3, 0.0, 0.0]));
        let pair = Composite::of(&[rod, opposite]);
        near(pair.moments()[2], 2.0 * 0.06 * 0.09 / 3.0);
        near(pair.moments()[0], 0.0);
        // At 45 degrees in the plane: m l^2/12 about z, half of it about x and y, and Ixy = -m l^2/24.
        let side = 0.3 / 2.0_f64.sqrt();
        let aslant = Composite::of(&[part(0.06, [0.0; 3], Shape::Rod([side, side, 0.0]))]);
        let about_z = 0.06 * 0.09 / 12.0;
        near(aslant.moments()[2], about_z);
        near(aslant.moments()[0], about_z / 2.0);
        near(aslant.inertia[0][1], -about_z / 2.0);
        let (axes, coupling) = aslant.coupling();
        assert_eq!(axes, [0, 1]);
        near(coupling, 1.0);
    }

    #[test]
    fn a_symmetric_frame_is_centred_exactly() {
        let corner = |k: u32| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::PI / 3.0).sin_cos();
            part(0.13, [0.3 * cos, 0.3 * sin, 0.0], Shape::Point)
        };
        let ring = Composite::of(&(0..6).map(corner).collect::<Vec<_>>());
        assert_eq!(ring.centre_of_gravity, [0.0; 3]);
        // A ring of masses: m R^2 about z, half of it about x and y.
        near(ring.moments()[2], 0.78 * 0.09);
        near(ring.moments()[0], 0.39 * 0.09);
        near(ring.moments()[1], 0.39 * 0.09);
    }
}
