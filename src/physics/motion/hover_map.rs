//! The paper's linear wrench map about hover, (19), (20) and (22), for a given yaw motion:
//! `docs/method/hover-model.md`.

use super::{X, Y, YAW, Z};
use crate::actuation::Wrench;
use crate::model::{Environment, Vehicle};

/// The order of the derivative that is the input of each axis: x and y are quadruple integrators (45), z and yaw double
/// ones (44).
pub const ORDER: [usize; 4] = [4, 4, 2, 2];

/// The yaw motion at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct YawState {
    /// psi, rad.
    pub psi: f64,
    /// psi', rad/s.
    pub rate: f64,
    /// psi'', rad/s^2.
    pub acceleration: f64,
}

/// The wrench as an affine function of the derivatives of the axes: `constant + sum of coefficient * derivative`.
#[derive(Debug, Clone, PartialEq)]
pub struct WrenchMap {
    /// The wrench with all derivatives zero, N and N m.
    pub constant: Wrench,
    /// (axis, order of the derivative, coefficient).
    pub terms: Vec<(usize, usize, Wrench)>,
}

impl WrenchMap {
    /// The map for a given yaw motion. With c, s the cosine and sine of psi:
    ///
    /// ```text
    /// T     = m (g + z'')
    /// tau_x = Ixx phi''       phi   = (s x'' - c y'') / g
    /// tau_y = Iyy theta''     theta = (c x'' + s y'') / g
    /// tau_z = Izz psi''
    /// g phi''   = s x'''' - c y'''' + 2 psi' (c x''' + s y''') + psi'' (c x'' + s y'') - psi'^2 (s x'' - c y'')
    /// g theta'' = c x'''' + s y'''' - 2 psi' (s x''' - c y''') - psi'' (s x'' - c y'') - psi'^2 (c x'' + s y'')
    /// ```
    pub fn new(vehicle: &Vehicle, gravity: f64, yaw: YawState) -> Self {
        let (s, c) = yaw.psi.sin_cos();
        let YawState { rate, acceleration, .. } = yaw;
        let [ixx, iyy, izz] = vehicle.inertia;
        let (roll, pitch) = (ixx / gravity, iyy / gravity);
        let tau = |x: f64, y: f64| Wrench::new(0.0, roll * x, pitch * y, 0.0);
        let mut terms = vec![(X, 4, tau(s, c)), (Y, 4, tau(-c, s)), (Z, 2, Wrench::new(vehicle.mass, 0.0, 0.0, 0.0))];
        if rate != 0.0 || acceleration != 0.0 {
            terms.push((X, 3, tau(2.0 * rate * c, -2.0 * rate * s)));
            terms.push((Y, 3, tau(2.0 * rate * s, 2.0 * rate * c)));
            let square = rate * rate;
            terms.push((X, 2, tau(acceleration * c - square * s, -acceleration * s - square * c)));
            terms.push((Y, 2, tau(acceleration * s + square * c, acceleration * c - square * s)));
        }
        let constant = Wrench::new(vehicle.mass * gravity, 0.0, 0.0, izz * acceleration);
        WrenchMap { constant, terms }
    }

    /// The map with yaw as a variable, linearised at a constant psi (rad): tau_z = Izz psi'' ("One yaw throughout").
    pub fn with_free_yaw(vehicle: &Vehicle, gravity: f64, psi: f64) -> Self {
        let mut map = Self::new(vehicle, gravity, YawState { psi, ..YawState::default() });
        map.terms.push((YAW, 2, Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2])));
        map
    }

    /// The wrench (N and N m) for `derivatives[axis][order]`, a [`NodeState`](super::NodeState) or
    /// [`CommandState`](super::CommandState).
    pub fn at<const N: usize>(&self, derivatives: &[[f64; N]; 4]) -> Wrench {
        self.terms.iter().fold(self.constant, |w, &(axis, order, c)| w + c * derivatives[axis][order])
    }
}

impl WrenchMap {
    /// The map of a motion in air, for this map of the thrust over mass and its derivatives: the chain rule with
    /// [`in_air`](super::in_air).
    pub fn of_motion_in(mut self, environment: &Environment) -> Self {
        if !environment.has_drag() {
            return self;
        }
        let rate = environment.turning_rate();
        let felt: Vec<_> = self.terms.iter().filter(|term| term.0 != YAW).copied().collect();
        for (axis, order, coefficient) in felt {
            if order == 2 {
                self.constant -= coefficient * (rate * environment.wind[axis]);
            }
            match self.terms.iter_mut().find(|term| (term.0, term.1) == (axis, order - 1)) {
                Some(term) => term.2 += coefficient * rate,
                None => self.terms.push((axis, order - 1, coefficient * rate)),
            }
        }
        self
    }
}

/// The commanded wrench c = w + tau w' of rotors with a first-order lag of `tau` s (`docs/method/rotor-lag.md`).
impl WrenchMap {
    /// The commanded wrench of the hover model for a yaw motion with psi''' = `jerk` (rad/s^3), by (83):
    ///
    /// ```text
    /// g phi''  = sum_i C(2,i) (s^(2-i) x^(2+i) - c^(2-i) y^(2+i))
    /// g phi''' = sum_i C(3,i) (s^(3-i) x^(2+i) - c^(3-i) y^(2+i))
    /// ```
    ///
    /// where s^(k) and c^(k) are the k-th time derivatives of sin psi and cos psi. theta has c for s and s for -c.
    pub fn commanded(vehicle: &Vehicle, gravity: f64, yaw: YawState, jerk: f64, tau: f64) -> Self {
        let (s, c) = yaw.psi.sin_cos();
        let YawState { rate, acceleration, .. } = yaw;
        let square = rate * rate;
        let (along, across) = (jerk - rate * square, 3.0 * rate * acceleration);
        let sin = [s, rate * c, acceleration * c - square * s, along * c - across * s];
        let cos = [c, -rate * s, -acceleration * s - square * c, -along * s - across * c];
        const SECOND: [f64; 3] = [1.0, 2.0, 1.0];
        const THIRD: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
        let weight = |of: &[f64; 4], i: usize| {
            let second = if i < 3 { SECOND[i] * of[2 - i] } else { 0.0 };
            second + tau * THIRD[i] * of[3 - i]
        };
        let [ixx, iyy, izz] = vehicle.inertia;
        let (roll, pitch) = (ixx / gravity, iyy / gravity);
        let mut terms = Vec::new();
        for i in (0..4).rev() {
            let (of_sin, of_cos) = (weight(&sin, i), weight(&cos, i));
            if of_sin != 0.0 || of_cos != 0.0 {
                terms.push((X, 2 + i, Wrench::new(0.0, roll * of_sin, pitch * of_cos, 0.0)));
                terms.push((Y, 2 + i, Wrench::new(0.0, -roll * of_cos, pitch * of_sin, 0.0)));
            }
        }
        terms.push((Z, 2, Wrench::new(vehicle.mass, 0.0, 0.0, 0.0)));
        terms.push((Z, 3, Wrench::new(tau * vehicle.mass, 0.0, 0.0, 0.0)));
        let constant = Wrench::new(vehicle.mass * gravity, 0.0, 0.0, izz * (acceleration + tau * jerk));
        WrenchMap { constant, terms }
    }

    /// The commanded wrench with yaw as a variable, linearised at a constant psi (rad).
    pub fn commanded_with_free_yaw(vehicle: &Vehicle, gravity: f64, psi: f64, tau: f64) -> Self {
        let mut map = Self::commanded(vehicle, gravity, YawState { psi, ..YawState::default() }, 0.0, tau);
        let turn = Wrench::new(0.0, 0.0, 0.0, vehicle.inertia[2]);
        map.terms.extend([(YAW, 2, turn), (YAW, 3, tau * turn)]);
        map
    }
}
