//! Modes without yaw in plain numbers: whether the thrusts of a mode give what a motion needs, at headings and spins
//! of a claimed range, while some yaw torque keeps the body's rate in the range.
//!
//! The wrenches (T, tau_x, tau_y) of the mode, with a yaw torque between the drags at both ends of the range, are a
//! convex set. Its facets are orthogonal to two or three rotors' wrenches; how far it reaches along a normal is a
//! knapsack of the thrusts. Torques follow from Euler's equation for a body that is turned by a heading and turns at a
//! spin. The checker eliminates the yaw torque from planes instead.

use mavc::admissible::without_yaw::planned::Turning;
use mavc::certificate::SpinRecord;
use mavc::model::{FaultMode, Model, Spin, YawDrag};
use std::f64::consts::TAU;

/// Headings that are tried.
const HEADINGS: usize = 24;

/// Normals that differ by less count as one.
const SAME: f64 = 1e-9;

/// One rotor of the mode: T, tau_x, tau_y and tau_z for a thrust of 1 N, and its bounds, N.
#[derive(Debug, Clone, Copy)]
struct Rotor {
    wrench: [f64; 4],
    least: f64,
    most: f64,
}

/// A normal in (T, tau_x, tau_y) over the healthy set's width along it, with the reach of the mode's wrenches.
#[derive(Debug, Clone, Copy)]
struct Facet {
    normal: [f64; 3],
    reach: f64,
    /// Whether some T and rho violate it alone.
    is_edge: bool,
}

/// The core that a record claims.
#[derive(Debug, Clone)]
pub struct Core {
    rotors: Vec<Rotor>,
    drag: YawDrag,
    inertia: [f64; 3],
    /// Momenta of the rotors, N m s.
    momenta: Vec<f64>,
    range: [f64; 2],
    turning: Option<f64>,
    /// [m g] and what the reserve leaves.
    hover: f64,
    kept: f64,
    facets: Vec<Facet>,
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| a * b).sum()
}

fn head([t, x, y, _]: [f64; 4]) -> [f64; 3] {
    [t, x, y]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The first three components of the vector orthogonal to three vectors of four.
fn orthogonal(a: [f64; 4], b: [f64; 4], c: [f64; 4]) -> [f64; 3] {
    let minor = |i: usize, j: usize, k: usize| {
        let pick = |v: [f64; 4]| [v[i], v[j], v[k]];
        dot(pick(a), cross(pick(b), pick(c)))
    };
    [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3)]
}

impl Core {
    /// The core of a mode with a range of spins.
    pub fn of(model: &Model, mode: &FaultMode, record: &SpinRecord) -> Option<Self> {
        let vehicle = &model.vehicle;
        let rotor = |(rotor, share): (&mavc::model::Rotor, &f64)| {
            let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
            let about_z = if rotor.spin == Spin::P { -ratio } else { ratio };
            let wrench = [1.0, rotor.position[1], -rotor.position[0], about_z];
            Rotor { wrench, least: share * rotor.idle_thrust(), most: share * rotor.max_thrust() }
        };
        let (mut low, mut high) = (0.0, 0.0);
        for rotor in &vehicle.rotors {
            let most = rotor.inertia * rotor.max_speed;
            if rotor.spin == Spin::P { high += most } else { low -= most }
        }
        let momenta = if low == high { vec![low] } else { vec![low, high] };
        let mut core = Core {
            rotors: vehicle.rotors.iter().zip(&mode.capacities()).map(rotor).collect(),
            drag: vehicle.yaw_drag?,
            inertia: vehicle.inertia,
            momenta,
            range: record.spin_rad_s,
            turning: record.turning_rad_s.filter(|_| vehicle.inertia[0] != vehicle.inertia[1]),
            hover: vehicle.mass * model.gravity,
            kept: 1.0 - model.plan.reserve,
            facets: Vec::new(),
        };
        let full: Vec<[f64; 3]> = vehicle
            .rotors
            .iter()
            .map(|r| [1.0, r.position[1], -r.position[0]].map(|part| part * r.max_thrust()))
            .collect();
        let torques = core.yaw_torques(core.turning.unwrap_or(0.0));
        let of_normal = |normal: [f64; 3]| {
            let width: f64 = full.iter().map(|wrench| dot(normal, *wrench).abs()).sum();
            let normal = normal.map(|n| n / width);
            Facet { normal, reach: core.reach(normal, torques), is_edge: false }
        };
        let mut facets: Vec<Facet> = core.normals().into_iter().map(of_normal).collect();
        for index in 0..facets.len() {
            facets[index].is_edge = is_edge(&facets, index);
        }
        core.facets = facets;
        Some(core)
    }

    /// All normals that a facet may have, and those of a bound on the thrust.
    fn normals(&self) -> Vec<[f64; 3]> {
        let used: Vec<[f64; 4]> = self.rotors.iter().filter(|r| r.most > r.least).map(|r| r.wrench).collect();
        let mut found: Vec<[f64; 3]> = vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
        let mut add = |normal: [f64; 3]| {
            let size = dot(normal, normal).sqrt();
            for sign in [1.0, -1.0] {
                let unit = normal.map(|n| sign * n / size);
                let is_new = |other: &[f64; 3]| (0..3).any(|i| (other[i] - unit[i]).abs() > SAME);
                if size > SAME && found.iter().all(is_new) {
                    found.push(unit);
                }
            }
        };
        for (i, &a) in used.iter().enumerate() {
            for (j, &b) in used.iter().enumerate().skip(i + 1) {
                add(cross(head(a), head(b)));
                used[j + 1..].iter().for_each(|&c| add(orthogonal(a, b, c)));
            }
        }
        found
    }

    /// The yaw torques with which the spin stays in the range while the thrust's direction turns at up to a rate
    /// (rad/s), N m: the drag is the smallest of its interval. Euler's equation has `(Jx - Jy) p q` about z, at most
    /// half the rate's square.
    fn yaw_torques(&self, turning: f64) -> [f64; 2] {
        let coupled = 0.5 * (self.inertia[0] - self.inertia[1]).abs() * turning * turning;
        let drag = |rate: f64| self.drag.linear * self.drag.spread.low * rate + self.drag.quadratic * rate * rate.abs();
        let [low, high] = self.range.map(drag);
        [low + coupled, high - coupled]
    }

    /// The most of `normal . (T, tau_x, tau_y)` with a yaw torque between two bounds, less the reserve; -infinity
    /// where there is no such torque. The price of the yaw torque is where some rotor's thrust no longer matters.
    fn reach(&self, normal: [f64; 3], [low, high]: [f64; 2]) -> f64 {
        let sum = |of: &dyn Fn(&Rotor) -> f64| self.rotors.iter().map(of).sum::<f64>();
        let ends = |r: &Rotor| [r.wrench[3] * r.least, r.wrench[3] * r.most];
        let least = sum(&|r| ends(r)[0].min(ends(r)[1]));
        let most = sum(&|r| ends(r)[0].max(ends(r)[1]));
        if !(low <= high && least <= high && low <= most) {
            return f64::NEG_INFINITY;
        }
        let at_price = |price: f64| {
            let worth = |r: &Rotor| dot(normal, head(r.wrench)) - price * r.wrench[3];
            sum(&|r| (worth(r) * r.least).max(worth(r) * r.most)) + (price * high).max(price * low)
        };
        let prices = self.rotors.iter().map(|r| dot(normal, head(r.wrench)) / r.wrench[3]);
        let reach = prices.chain([0.0]).map(at_price).fold(f64::INFINITY, f64::min);
        let at_hover = normal[0] * self.hover;
        at_hover + self.kept * (reach - at_hover)
    }

    /// Violations of every facet at the ends of the range and of the momenta, and in the middle, at the worst of the
    /// headings; in widths of the healthy set.
    pub fn violations(&self, turning: &Turning) -> Vec<f64> {
        let [low, high] = self.range;
        // Without a bound on turning, nothing but the motion itself says how much of the yaw torque its turning takes.
        let is_open = self.turning.is_none() && self.inertia[0] != self.inertia[1];
        let torques = self.yaw_torques(turning[3].hypot(turning[4]));
        let spins = [low, high, 0.5 * (low + high)];
        let corners = spins.iter().flat_map(|&spin| self.momenta.iter().map(move |&momentum| (spin, momentum)));
        let needed: Vec<Vec<[f64; 3]>> = corners
            .map(|(spin, momentum)| {
                let heading = |i: usize| self.needed(turning, spin, momentum, TAU * i as f64 / HEADINGS as f64);
                (0..HEADINGS).map(heading).collect()
            })
            .collect();
        let of_facet = |facet: &Facet| {
            let reach = if is_open { self.reach(facet.normal, torques) } else { facet.reach };
            let most = |at: &Vec<[f64; 3]>| at.iter().map(|w| dot(facet.normal, *w) - reach).fold(f64::MIN, f64::max);
            needed.iter().map(most).collect::<Vec<_>>()
        };
        self.facets.iter().flat_map(of_facet).collect()
    }

    /// Thrust and torques about x and y of the body at a heading (rad) relative to the frame of the motion's turning,
    /// by Euler's equation.
    fn needed(&self, turning: &Turning, spin: f64, momentum: f64, heading: f64) -> [f64; 3] {
        let [jx, jy, jz] = self.inertia;
        let (sine, cosine) = heading.sin_cos();
        let in_body = |x: f64, y: f64| [cosine * x + sine * y, cosine * y - sine * x];
        let [swing_x, swing_y] = in_body(turning[1], turning[2]);
        // s' = (q, -p) and s x s'' = (p' - q r, q' + p r).
        let [q, minus_p] = in_body(turning[3], turning[4]);
        let p = -minus_p;
        let (p_rate, q_rate) = (swing_x + q * spin, swing_y - p * spin);
        let about_x = jx * p_rate + (jz - jy) * q * spin + momentum * q;
        let about_y = jy * q_rate + (jx - jz) * p * spin - momentum * p;
        [turning[0], about_x, about_y]
    }

    /// The largest violation of a facet.
    pub fn worst(&self, turning: &Turning) -> f64 {
        self.violations(turning).into_iter().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Facets, at each corner, that no others imply: those that RSP may select.
    pub fn edges(&self) -> Vec<bool> {
        let corners = 3 * self.momenta.len();
        // What is in the middle of the range is none of the ends.
        let is_end = |corner: usize| corner < 2 * self.momenta.len();
        self.facets.iter().flat_map(|f| (0..corners).map(move |corner| f.is_edge && is_end(corner))).collect()
    }

    /// By how much the direction of the thrust turns faster than the record says, as a share.
    pub fn turns_beyond(&self, turning: &Turning) -> f64 {
        self.turning.map_or(f64::NEG_INFINITY, |rate| turning[3].hypot(turning[4]) / rate - 1.0)
    }

    /// By how much the motion's own rate leaves the range, rad/s.
    pub fn spins_beyond(&self, turning: &Turning) -> f64 {
        (self.range[0] - turning[5]).max(turning[5] - self.range[1])
    }
}

/// Whether some T and rho violate a facet's row and no other one's: at a corner of the others.
fn is_edge(facets: &[Facet], index: usize) -> bool {
    let row = |f: &Facet| [f.normal[0], f.normal[1].hypot(f.normal[2]), f.reach];
    let own = row(&facets[index]);
    let same = |r: &[f64; 3]| (0..3).all(|i| (r[i] - own[i]).abs() < SAME);
    let mut others: Vec<[f64; 3]> = facets.iter().map(row).filter(|r| !same(r)).collect();
    others.push([0.0, -1.0, 0.0]);
    let meets = |a: &[f64; 3], b: &[f64; 3]| {
        let size = a[0] * b[1] - a[1] * b[0];
        let point = [(a[2] * b[1] - a[1] * b[2]) / size, (a[0] * b[2] - a[2] * b[0]) / size];
        (size.abs() > SAME).then_some(point)
    };
    let over = |r: &[f64; 3], [t, rho]: [f64; 2]| r[0] * t + r[1] * rho - r[2];
    others.iter().enumerate().any(|(i, a)| {
        others[i + 1..].iter().filter_map(|b| meets(a, b)).any(|point| {
            // By more than the rounding of a corner.
            over(&own, point) > 1e-6 && others.iter().all(|r| over(r, point) < SAME)
        })
    })
}
