//! Rows of cores as quantities along a motion.

use super::super::cost;
use super::super::interval::Interval;
use super::super::motion::State;
use super::super::proof::{Family, Measure, Rated};
use super::super::series::{Series, Vector};
use super::super::wrench::{Dynamics, Turned};
use std::collections::HashMap;

/// A row at one momentum and rate: `thrust T + torque rho <= offset`, over a width of the healthy set.
#[derive(Debug, Clone, Copy)]
pub struct Member {
    pub thrust: Interval,
    pub torque: Interval,
    pub offset: Interval,
    pub inertia: Interval,
    pub unevenness: Interval,
    pub momentum: Interval,
    pub spin: Interval,
}

impl Member {
    /// `|s'| <= rate` (rad/s), as a share of the rate.
    pub fn turning(rate: Interval) -> Self {
        let zero = Interval::ZERO;
        let torque = Interval::ONE / rate;
        let (momentum, offset) = (Interval::ONE, Interval::ONE);
        Member { thrust: zero, torque, offset, inertia: zero, unevenness: zero, momentum, spin: zero }
    }

    fn violation(&self, turned: &Turned, rho: Series<2>) -> Series<2> {
        turned.thrust.times(self.thrust) + rho.times(self.torque) - Series::constant(self.offset)
    }

    /// The numbers on which rho depends.
    fn of_body(&self) -> [u64; 8] {
        let [a, b, c, d] = [self.inertia, self.unevenness, self.momentum, self.spin];
        [a.low, a.high, b.low, b.high, c.low, c.high, d.low, d.high].map(f64::to_bits)
    }

    /// `|J s x s'' + H s'| + |delta| |s x s'' + 2 r s'|`
    fn rho(&self, turned: &Turned) -> Series<2> {
        let combined = |swing: Interval, rate: Interval| -> Vector<2> {
            std::array::from_fn(|i| turned.swing[i].times(swing) + turned.rate[i].times(rate))
        };
        let even = length(&combined(self.inertia, self.momentum));
        if self.unevenness == Interval::ZERO {
            return even;
        }
        let uneven = combined(Interval::ONE, self.spin * Interval::point(2.0));
        even + length(&uneven).times(self.unevenness)
    }
}

/// The violations of rows along a motion; with a range of rates (rad/s) also by how much the motion's own rate leaves
/// it at either end, rad/s.
pub fn family<'a>(dynamics: &Dynamics<'a>, rows: Vec<Member>, spin: Option<[f64; 2]>) -> Family<'a> {
    let dynamics = dynamics.clone();
    let members = rows.len() + if spin.is_some() { 2 } else { 0 };
    // Many rows share their momentum and rate, and so rho. The first row of each stands for them.
    let mut bodies: HashMap<[u64; 8], usize> = HashMap::new();
    let mut firsts = Vec::new();
    let body_of = |(member, row): (usize, &Member)| {
        *bodies.entry(row.of_body()).or_insert_with(|| {
            firsts.push(member);
            firsts.len() - 1
        })
    };
    let body: Vec<usize> = rows.iter().enumerate().map(body_of).collect();
    let overhead = cost::OF_EXACT_WRENCH + cost::times(firsts.len() as u64, cost::COST_PER_SPIN);
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        let turned = dynamics.turned(state);
        let beyond = |side: usize| {
            let (sign, end) = (if side == 0 { -1.0 } else { 1.0 }, spin.map_or(0.0, |ends| ends[side]));
            turned.spin.times(Interval::point(sign)) - Series::constant(Interval::point(sign * end))
        };
        let mut rhos: Vec<Option<Series<2>>> = vec![None; firsts.len()];
        let member = |&member: &usize| match rows.get(member) {
            Some(row) => {
                let rho = *rhos[body[member]].get_or_insert_with(|| row.rho(&turned));
                row.violation(&turned, rho)
            }
            None => beyond(member - rows.len()),
        };
        wanted.iter().map(member).map(|s| Rated { value: s.value(), rate: s.slope() }).collect()
    };
    Family {
        members,
        evaluate: Box::new(evaluate),
        linear: false,
        jumps: false,
        within: None,
        at_nodes_only: false,
        measure: Measure::WIDTH,
        overhead,
        of_a_member: cost::COST_PER_ROW,
    }
}

/// The length of a vector; its rate of change is at most that of the vector.
fn length(parts: &Vector<2>) -> Series<2> {
    let sum =
        |of: &dyn Fn(&Series<2>) -> Interval| parts.iter().fold(Interval::ZERO, |sum, p| sum + of(p).square()).sqrt();
    let value = sum(&|p| p.value());
    let steepest = Interval::around_zero(sum(&|p| p.slope()).high);
    let along = parts.iter().fold(Interval::ZERO, |sum, p| sum + p.value() * p.slope());
    Series::of_derivatives(&[value, (along / value).meet(steepest)])
}
