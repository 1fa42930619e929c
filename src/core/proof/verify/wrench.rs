//! The wrench of a motion, computed with series in time, so that no derivative has an explicit formula.

use super::interval::Interval;
use super::motion::{State, X, Y, YAW, Z, series};
use super::series::{Scalar, Series, Vector, cross, dot, unit};
use super::taylor::Taylor;
use crate::certificate::DynamicModel;
use crate::model::{Environment, Vehicle};

/// A quantity that must stay in a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Held {
    /// The wrench w of the motion.
    Wrench,
    /// The commanded wrench of rotors that lag by `tau` s: w + tau w' (docs/method/rotor-lag.md, (81)).
    Commands { tau: Interval },
}

/// Value and rate of change of T, tau_x, tau_y, tau_z: N, N m and per second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench<S = Interval> {
    pub value: [S; 4],
    pub rate: [S; 4],
}

/// What a motion takes whatever the heading: the thrust T, N, `s x s''` and s' with s the direction of the thrust, and
/// the rate about s of a body with the motion's yaw, rad/s. Value and rate of change.
#[derive(Debug, Clone, Copy)]
pub struct Turned {
    pub thrust: Series<2>,
    pub swing: Vector<2>,
    pub rate: Vector<2>,
    pub spin: Series<2>,
}

/// The equations that give the wrench of a motion.
#[derive(Debug, Clone)]
pub struct Dynamics<'a> {
    pub vehicle: &'a Vehicle,
    /// Gravity, drag and the possible winds.
    pub environment: Environment,
    pub model: DynamicModel,
    /// If all waypoints have the same yaw, the yaw at which the hover model is linearised, rad.
    pub one_yaw: Option<f64>,
}

impl Dynamics<'_> {
    /// The wrench at a state and its rate of change.
    pub fn wrench(&self, state: &State) -> Wrench {
        // A torque needs the attitude's second derivative, and its rate of change the third.
        rated(self.series::<4>(state))
    }

    /// T, tau_x, tau_y, tau_z without rates: N, N m. A torque needs the attitude's second derivative.
    pub fn value(&self, state: &State) -> [Interval; 4] {
        self.series::<3>(state).map(|part| part.value())
    }

    /// Whether more than one wind is possible, and the equations depend on it.
    pub fn is_in_winds(&self) -> bool {
        self.model == DynamicModel::Exact && self.environment.is_uncertain()
    }

    /// These equations in each of the extreme winds.
    pub fn in_each_wind(&self) -> Vec<Self> {
        self.environment.corners().into_iter().map(|environment| Dynamics { environment, ..self.clone() }).collect()
    }

    /// The quantity `held` at a state whose inputs have the slopes of its piece.
    pub fn held(&self, held: Held, state: &State) -> Wrench {
        match held {
            Held::Wrench => self.wrench(state),
            Held::Commands { tau } => rated(self.series::<5>(state).map(|w| w + w.rate().times(tau))),
        }
    }

    /// The quantity `held` in the exact model as a function of the wind's deviation from its middle.
    pub fn held_by_wind(&self, held: Held, state: &State) -> Wrench<Taylor> {
        match held {
            Held::Wrench => rated(self.exact::<4, _>(state, &[self.thrust_by_wind(state); 3])),
            Held::Commands { tau } => {
                let wrench = self.exact::<5, _>(state, &[self.thrust_by_wind(state); 3]);
                rated(wrench.map(|w| w + w.rate().times(tau)))
            }
        }
    }

    /// The quantity `held` of motions whose derivatives are functions of parameters, in one wind, about the yaw of
    /// `state`, which encloses all of them.
    pub fn held_by_models(&self, held: Held, state: &State, models: &Models) -> Wrench<Taylor> {
        match held {
            Held::Wrench => rated(self.by_models::<4>(state, models)),
            Held::Commands { tau } => rated(self.by_models::<5>(state, models).map(|w| w + w.rate().times(tau))),
        }
    }

    fn by_models<const N: usize>(&self, state: &State, models: &Models) -> [Series<N, Taylor>; 4] {
        match self.model {
            DynamicModel::Hover => self.hover(state, [X, Y, Z, YAW].map(|axis| of_models(&models[axis], 2))),
            DynamicModel::Exact => {
                let along = |rate: f64| {
                    let mut thrust = [X, Y, Z].map(|axis| of_models::<N>(&models[axis], 2));
                    thrust[Z] = thrust[Z] + Series::constant(Taylor::of(Interval::point(self.environment.gravity)));
                    if self.environment.has_drag() {
                        for axis in [X, Y, Z] {
                            let wind = Series::constant(Taylor::of(Interval::point(self.environment.wind[axis])));
                            let air = of_models::<N>(&models[axis], 1) - wind;
                            thrust[axis] = thrust[axis] + air.times(Interval::point(rate));
                        }
                    }
                    thrust
                };
                self.exact(state, &self.environment.drag_rates.map(along))
            }
        }
    }

    /// The thrust over mass as a function of the wind's deviation, which changes its value and none of its derivatives,
    /// m/s^2. An interval of winds has the same drag along all axes.
    fn thrust_by_wind<const N: usize>(&self, state: &State) -> Vector<N, Taylor> {
        let wind_spread = self.environment.wind_spread;
        let drag_rate = self.environment.turning_rate();
        let middle = Environment { wind_spread: [0.0; 3], ..self.environment };
        let mut thrust = thrust_over_mass::<N>(state, &middle, drag_rate).map(|part| part.lifted());
        for (axis, part) in thrust.iter_mut().enumerate() {
            let largest = -(Interval::point(drag_rate) * Interval::point(wind_spread[axis]));
            *part = *part + Series::constant(Taylor::deviation(axis, largest));
        }
        thrust
    }

    /// How the motion turns, in one wind and with the same drag along all axes.
    pub fn turned(&self, state: &State) -> Turned {
        let begin = |s: Series<4>| Series([s.0[0], s.0[1]]);
        let mass = Interval::point(self.vehicle.mass);
        let g = Interval::point(self.environment.gravity);
        match self.model {
            // s = (x''/g, y''/g, 1) to first order.
            DynamicModel::Hover => {
                let over_g =
                    |axis: usize, order: usize| begin(Series(series::<4>(&state[axis], order).0.map(|c| c / g)));
                let zero = Series::constant(Interval::ZERO);
                let lift = series::<4>(&state[Z], 2) + Series::constant(g);
                Turned {
                    thrust: begin(lift.times(mass)),
                    swing: [-over_g(Y, 4), over_g(X, 4), zero],
                    rate: [over_g(X, 3), over_g(Y, 3), zero],
                    spin: begin(series(&state[YAW], 1)),
                }
            }
            DynamicModel::Exact => {
                let (sine, cosine) = series::<4>(&state[YAW], 0).sin_cos();
                let a: Vector<4> = thrust_over_mass(state, &self.environment, self.environment.turning_rate());
                let b3 = unit(&a);
                let b1 = unit(&cross(&[-sine, cosine, Series::constant(Interval::ZERO)], &b3));
                let b2 = cross(&b3, &b1);
                let rate = b3.map(|part| part.rate());
                Turned {
                    thrust: begin(dot(&a, &a).sqrt().times(mass)),
                    swing: cross(&b3, &rate.map(|part| part.rate())).map(begin),
                    rate: rate.map(begin),
                    spin: begin(dot(&b2, &b1.map(|part| part.rate()))),
                }
            }
        }
    }

    fn series<const N: usize>(&self, state: &State) -> [Series<N>; 4] {
        match self.model {
            DynamicModel::Hover => self.about_hover(state),
            DynamicModel::Exact => {
                let environment = &self.environment;
                self.exact(state, &environment.drag_rates.map(|rate| thrust_over_mass(state, environment, rate)))
            }
        }
    }

    /// T = m (g + z''), tau = (Ixx phi'', Iyy theta'', Izz psi'') with phi = (s x'' - c y'')/g, theta = (c x'' + s
    /// y'')/g: the series of phi and theta hold their second derivatives.
    fn about_hover<const N: usize>(&self, state: &State) -> [Series<N>; 4] {
        self.hover(state, [X, Y, Z, YAW].map(|axis| series(&state[axis], 2)))
    }

    /// The wrench about hover with the second derivatives given.
    fn hover<const N: usize, S: Scalar>(&self, state: &State, second: [Series<N, S>; 4]) -> [Series<N, S>; 4] {
        let g = Interval::point(self.environment.gravity);
        let [ax, ay, az, yaw_acceleration] = second;
        let yaw = match self.one_yaw {
            Some(psi) => Series::constant(Interval::point(psi)),
            None => series(&state[YAW], 0),
        };
        let (s, c): (Series<N>, Series<N>) = yaw.sin_cos();
        let (s, c) = (s.lifted(), c.lifted());
        let over_g = |a: Series<N, S>| a.times(Interval::ONE / g);
        let roll = over_g(s * ax - c * ay).rate().rate();
        let pitch = over_g(c * ax + s * ay).rate().rate();
        let [ixx, iyy, izz] = self.vehicle.inertia.map(Interval::point);
        let lift = az + Series::constant(S::of(g));
        let thrust = lift.times(Interval::point(self.vehicle.mass));
        [thrust, roll.times(ixx), pitch.times(iyy), yaw_acceleration.times(izz)]
    }

    /// The thrust carries m (p'' + g e_z) and the drag along b_3; of ZYX angles the heading is that of b_1, which is
    /// therefore orthogonal to y_C = (-s, c, 0). With R' = R S(omega), S the matrix of the cross product: p =
    /// -b_2.b_3', q = b_1.b_3', r = b_2.b_1'; then tau = J omega' + omega x J omega.
    ///
    /// With a drag for each axis of the body, alpha, beta and gamma are the thrust over mass of the isotropic drags
    /// along x, y and z: b_1 is orthogonal to y_C and alpha, b_2 to b_1 and beta, and the thrust is m b_3.gamma
    /// (docs/method/air.md, (90a) to (90c)).
    fn exact<const N: usize, S: Scalar>(&self, state: &State, thrusts: &[Vector<N, S>; 3]) -> [Series<N, S>; 4] {
        let environment = &self.environment;
        let [a, beta, gamma] = thrusts;
        let (s, c) = series(&state[YAW], 0).sin_cos();
        let left: Vector<N> = [-s, c, Series::constant(Interval::ZERO)];
        let left = left.map(|part| part.lifted());
        let (b1, b2, b3) = match environment.turns_alike() {
            true => {
                let b3 = unit(a);
                let b1 = unit(&cross(&left, &b3));
                (b1, cross(&b3, &b1), b3)
            }
            false => {
                let b1 = unit(&cross(&left, a));
                let b2 = unit(&cross(beta, &b1));
                (b1, b2, cross(&b1, &b2))
            }
        };
        let (b1_rate, b3_rate) = (b1.map(|x| x.rate()), b3.map(|x| x.rate()));
        let omega: Vector<N, S> = [-dot(&b2, &b3_rate), dot(&b1, &b3_rate), dot(&b2, &b1_rate)];
        let inertia = self.vehicle.inertia.map(Interval::point);
        let momentum: Vector<N, S> = std::array::from_fn(|i| omega[i].times(inertia[i]));
        let gyroscopic = cross(&omega, &momentum);
        let tau: Vector<N, S> = std::array::from_fn(|i| momentum[i].rate() + gyroscopic[i]);
        let size = match environment.is_isotropic() {
            true => dot(a, a).sqrt(),
            false => dot(&b3, gamma),
        };
        let thrust = size.times(Interval::point(self.vehicle.mass));
        [thrust, tau[0], tau[1], tau[2]]
    }
}

/// Derivatives as functions of parameters: `[axis][order]`.
pub type Models = [[Taylor; 6]; 4];

/// The series of an axis's derivative of some order.
fn of_models<const N: usize>(axis: &[Taylor; 6], order: usize) -> Series<N, Taylor> {
    let mut factorial = 1.0;
    Series(std::array::from_fn(|n| {
        factorial *= n.max(1) as f64;
        match axis.get(order + n) {
            Some(&derivative) if n < 2 => derivative,
            Some(&derivative) => derivative.scaled(Interval::ONE / Interval::point(factorial)),
            None => Taylor::of(Interval::ZERO),
        }
    }))
}

/// The thrust over mass with the same drag along all axes, `p'' + g e_z + rate (p' - wind)`, over all possible winds,
/// m/s^2.
pub fn thrust_over_mass<const N: usize>(state: &State, environment: &Environment, rate: f64) -> Vector<N> {
    let mut thrust = [X, Y, Z].map(|axis| series(&state[axis], 2));
    thrust[Z] = thrust[Z] + Series::constant(Interval::point(environment.gravity));
    if environment.has_drag() {
        let rate = Interval::point(rate);
        for axis in [X, Y, Z] {
            let spread = Interval::around_zero(environment.wind_spread[axis]);
            let wind = Interval::point(environment.wind[axis]) + spread;
            thrust[axis] = thrust[axis] + (series(&state[axis], 1) - Series::constant(wind)).times(rate);
        }
    }
    thrust
}

fn rated<const N: usize, S: Scalar>(parts: [Series<N, S>; 4]) -> Wrench<S> {
    Wrench { value: parts.map(|p| p.value()), rate: parts.map(|p| p.slope()) }
}
