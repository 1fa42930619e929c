//! Families of branches between instants, as the checker of certificates accepts them.
//!
//! The instants between two with a way out, and the delays, are divided until what a fault does to the vehicle
//! is nearly linear in both. Branches with the same times at the corners, their blends and all motions near these are
//! a family, if it passes the checker.

use super::super::{Families, NotProved, Way};
use super::landings::HERE;
use super::{Found, Search};
use crate::certificate::{FamilyRecord, StateTolerance, WayRecord};
use crate::certify::{self, model_of};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z, in_air};
use crate::planner::branch::Goal;
use crate::planner::scp::Iterate;
use crate::verify::Premises;
use crate::verify::cost::WorkLeft;
use crate::verify::motion::Motion;
use crate::verify::plan::Setting;
use crate::verify::recovery::{Missed, Recovering};
use nalgebra::Vector3;

/// Instants are divided until they are this close, s. Chosen by hand.
const CLOSEST: f64 = 0.1;

/// Delays are divided into at most this many parts. Chosen by hand.
const PARTS: usize = 8;

/// The smallest tolerances of a family. Chosen by hand.
const LEAST: StateTolerance = StateTolerance {
    position_m: 0.001,
    velocity_m_s: 0.005,
    tilt_rad: 0.001,
    turning_rad_s: 0.005,
    yaw_rad: 0.001,
    yaw_rate_rad_s: 0.005,
};

/// Instants and delays are divided until tolerances are at most these. Chosen by hand.
const MOST: StateTolerance = StateTolerance {
    position_m: 0.02,
    velocity_m_s: 0.05,
    tilt_rad: 0.004,
    turning_rad_s: 0.03,
    yaw_rad: 0.005,
    yaw_rate_rad_s: 0.03,
};

/// Tolerances are this many times the largest deviation that was seen. Chosen by hand.
const MORE: f64 = 1.5;

/// How many branches are remembered for the next family.
const REMEMBERED: usize = 64;

/// The work for one family, in the units of the checker.
const WORK: u64 = 4_000_000;

/// A branch that families refer to.
struct Known {
    at: f64,
    delay: f64,
    way: Way,
    /// Its index in the list of branches, and of its motion.
    index: usize,
    iterate: Iterate,
}

/// The vehicle when a fault becomes known, and where the plan is then.
struct Seen {
    flown: NodeState,
    planned: NodeState,
}

/// Builds the families of one mode.
struct Builder<'b, 's, 'a> {
    search: &'b mut Search<'a>,
    recovering: Recovering<'s, 'a>,
    setting: &'s Setting<'a>,
    motions: Vec<Motion>,
    /// Of the last instants.
    known: Vec<Known>,
    all: Families,
}

impl<'a> Search<'a> {
    /// The families between the instants of `found` that both have a way out; `None` if none are sought. None are
    /// sought for modes without yaw, whose sets have no planes for the yaw torque.
    pub(super) fn families(&mut self, found: &[Found]) -> Option<Families> {
        self.roomy.as_ref()?;
        if self.core.is_some() {
            return Some(Families::default());
        }
        let setting = Setting::new(self.problem, model_of(self.plan), Premises::default());
        let plan = setting.motion(&certify::motion(self.plan)).ok()?;
        let recovering = Recovering::new(&setting, &plan);
        let (motions, known, all) = (Vec::new(), Vec::new(), Families::default());
        let mut builder = Builder { search: self, recovering, setting: &setting, motions, known, all };
        for pair in found.windows(2) {
            let [from, to] = pair else { continue };
            let like = [from, to].map(|found| Some((found.way?, found.iterates.last()?)));
            match like {
                [Some(first), Some(second)] if first.0 != second.0 => {
                    builder.between([from.at, to.at], &[first, second]);
                }
                [Some(first), Some(_)] => builder.between([from.at, to.at], &[first]),
                _ => {}
            }
        }
        Some(builder.all)
    }
}

impl Builder<'_, '_, '_> {
    /// Adds families between two instants, in the order of time, of the first of some ways for which there are any,
    /// with branches about given ones.
    fn between(&mut self, [from, to]: [f64; 2], ways: &[(Way, &Iterate)]) {
        let mut why = String::new();
        for (way, like) in ways {
            crate::cancel::checkpoint();
            match self.rectangle([from, to], *way, like) {
                Ok(families) => return self.all.proved.extend(families),
                Err(missed) => why = missed,
            }
        }
        if to - from >= 2.0 * CLOSEST {
            let middle = 0.5 * (from + to);
            self.between([from, middle], ways);
            return self.between([middle, to], ways);
        }
        if self.all.not_proved.as_ref().is_none_or(|longest| to - from > longest.to - longest.from) {
            self.all.not_proved = Some(NotProved { from, to, why });
        }
    }

    /// Families for all delays between two instants.
    ///
    /// # Errors
    /// Why there are none.
    fn rectangle(&mut self, instants: [f64; 2], way: Way, like: &Iterate) -> Result<Vec<FamilyRecord>, String> {
        let (delays, tolerances) =
            self.divided(instants).ok_or("a simulated flight turns over, or too fast a change")?;
        let mut families = Vec::with_capacity(tolerances.len());
        let mut rows: Vec<[usize; 2]> = Vec::with_capacity(delays.len());
        // The longest delay is the hardest.
        for delay in delays.iter().rev() {
            let [Some(from), Some(to)] = instants.map(|at| self.branch(at, *delay, way, like)) else {
                return Err("no branches with the same times were found".into());
            };
            rows.push([from, to]);
        }
        rows.reverse();
        let model = self.search.problem.model();
        let sites = &self.search.problem.mission().after_fault.sites;
        let record_of_way = match way {
            Way::Continue | Way::ContinueSpinning => WayRecord::Continue,
            Way::LandAt(site) => WayRecord::LandAt(sites[site].name.clone()),
            Way::LandHere | Way::Caught => WayRecord::LandHere,
        };
        for (part, tolerance) in tolerances.into_iter().enumerate() {
            let last = (part + 1).min(rows.len() - 1);
            let [[a, b], [c, d]] = [rows[part], rows[last]];
            let record = FamilyRecord {
                mode: model.modes[self.search.mode].name.clone(),
                from_s: instants[0],
                to_s: instants[1],
                delays_s: [delays[part], delays[last]],
                way: record_of_way.clone(),
                corners: [a, b, c, d],
                tolerance,
            };
            let motions = record.corners.map(|index| &self.motions[index]);
            match self.recovering.family(&record, motions, &mut WorkLeft(WORK)) {
                Ok(Ok(())) => families.push(record),
                Ok(Err(Missed { row, at, value })) => {
                    let [low, high] = [value.low, value.high].map(|bound| format!("{bound:.2e}"));
                    return Err(format!("{row}, {at:.3} s after the fault is known: only bounded by {low} and {high}"));
                }
                Err(rejection) => return Err(rejection.detail),
            }
        }
        Ok(families)
    }

    /// The delays, so close to each other that states between them and between two instants are nearly those that are
    /// expected, and the tolerances of each part; `None` if a flight turns over, or none are close enough.
    fn divided(&self, instants: [f64; 2]) -> Option<(Vec<f64>, Vec<StateTolerance>)> {
        let [least, most] = [self.search.delays[0], self.search.delays[self.search.delays.len() - 1]];
        if least == most {
            let tolerance = self.tolerance(instants, [most; 2])?;
            return is_within(&tolerance).then_some((vec![most], vec![tolerance]));
        }
        let mut parts = 1;
        while parts <= PARTS {
            let delays: Vec<f64> = (0..=parts).map(|i| least + (most - least) * i as f64 / parts as f64).collect();
            let pairs = delays.windows(2).map(|pair| self.tolerance(instants, [pair[0], pair[1]]));
            let tolerances: Vec<StateTolerance> = pairs.collect::<Option<_>>()?;
            if tolerances.iter().all(is_within) {
                return Some((delays, tolerances));
            }
            parts *= 2;
        }
        None
    }

    /// A branch about another one, with its times: its index.
    fn branch(&mut self, at: f64, delay: f64, way: Way, like: &Iterate) -> Option<usize> {
        let is_it = |known: &&Known| {
            known.at == at
                && known.delay == delay
                && known.way == way
                && known.iterate.grid.node_times == like.grid.node_times
        };
        if let Some(known) = self.known.iter().rev().find(is_it) {
            return Some(known.index);
        }
        let search = &mut *self.search;
        let carried = search.carried(at, delay)?;
        let goal = match way {
            Way::Continue | Way::ContinueSpinning => Goal::Rejoin(search.planned(at + delay + like.grid.total)),
            Way::LandAt(site) => {
                let site = &search.problem.mission().after_fault.sites[site];
                Goal::Ground { at: site.at, radius: site.radius }
            }
            Way::LandHere | Way::Caught => {
                let end = &like.states[like.states.len() - 1];
                Goal::Ground { at: [end[X][0], end[Y][0], search.problem.mission().ground?], radius: HERE }
            }
        };
        let iterate = search.roomy.as_mut()?.find_about(&carried.state, &goal, like)?;
        let record = certify::motion(&iterate.trajectory());
        self.motions.push(self.setting.motion(&record).ok()?);
        self.all.branches.push(record);
        let index = self.motions.len() - 1;
        if self.known.len() > REMEMBERED {
            self.known.remove(0);
        }
        self.known.push(Known { at, delay, way, index, iterate });
        Some(index)
    }

    fn seen(&self, at: f64, delay: f64) -> Option<Seen> {
        Some(Seen { flown: self.search.carried(at, delay)?.state, planned: self.search.planned(at + delay) })
    }

    /// How far states between two instants and two delays are from the expected ones, with some more; `None` if a
    /// flight turns over.
    fn tolerance(&self, [from, to]: [f64; 2], [least, most]: [f64; 2]) -> Option<StateTolerance> {
        let corners = [self.seen(from, least)?, self.seen(to, least)?, self.seen(from, most)?, self.seen(to, most)?];
        let mut places = vec![(0.25, 0.0), (0.5, 0.0), (0.75, 0.0)];
        if least < most {
            places.extend([(0.5, 1.0), (0.0, 0.5), (0.5, 0.5), (1.0, 0.5)]);
        }
        let mut all = LEAST;
        for (s, r) in places {
            let Seen { flown, planned } = self.seen(from + s * (to - from), least + r * (most - least))?;
            let weights = [(1.0 - r) * (1.0 - s), (1.0 - r) * s, r * (1.0 - s), r * s];
            let expected: NodeState = std::array::from_fn(|axis| {
                std::array::from_fn(|i| {
                    let each = corners.iter().zip(weights);
                    let from_plan: f64 = each.map(|(seen, w)| w * (seen.flown[axis][i] - seen.planned[axis][i])).sum();
                    planned[axis][i] + from_plan
                })
            });
            self.widen(&mut all, &expected, &flown);
        }
        Some(all)
    }

    /// Widens tolerances about a state until they contain another one.
    fn widen(&self, all: &mut StateTolerance, expected: &NodeState, state: &NodeState) {
        let apart = |order: usize| {
            [X, Y, Z].iter().map(|&axis| (expected[axis][order] - state[axis][order]).powi(2)).sum::<f64>().sqrt()
        };
        let (a, b) = (self.direction(expected), self.direction(state));
        let widen = |tolerance: &mut f64, seen: f64| *tolerance = tolerance.max(MORE * seen);
        widen(&mut all.position_m, apart(0));
        widen(&mut all.velocity_m_s, apart(1));
        widen(&mut all.tilt_rad, (a[0] - b[0]).norm());
        widen(&mut all.turning_rad_s, (a[1] - b[1]).norm());
        widen(&mut all.yaw_rad, (expected[YAW][0] - state[YAW][0]).abs());
        widen(&mut all.yaw_rate_rad_s, (expected[YAW][1] - state[YAW][1]).abs());
    }

    /// The direction of the thrust and its rate of change; in the hover model to first order.
    fn direction(&self, state: &NodeState) -> [Vector3<f64>; 2] {
        let environment = self.search.problem.model().environment();
        let g = environment.gravity;
        if self.search.plan.model != WrenchModel::Exact {
            return [2, 3].map(|order| Vector3::new(state[X][order] / g, state[Y][order] / g, 0.0));
        }
        let felt = in_air(state, &environment);
        let thrust = Vector3::new(felt[X][2], felt[Y][2], felt[Z][2] + g);
        let rate = Vector3::new(felt[X][3], felt[Y][3], felt[Z][3]);
        let n = thrust.normalize();
        [n, (rate - n * n.dot(&rate)) / thrust.norm()]
    }
}

/// Whether tolerances are small enough for a family.
fn is_within(all: &StateTolerance) -> bool {
    all.position_m <= MOST.position_m
        && all.velocity_m_s <= MOST.velocity_m_s
        && all.tilt_rad <= MOST.tilt_rad
        && all.turning_rad_s <= MOST.turning_rad_s
        && all.yaw_rad <= MOST.yaw_rad
        && all.yaw_rate_rad_s <= MOST.yaw_rate_rad_s
}
