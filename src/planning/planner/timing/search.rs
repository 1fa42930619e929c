//! The smallest mission time at which the hover planner's program is feasible, and what proves it.
//!
//! The violation on a coarse grid gives an estimate, the full program decides. Times are tried on multiples of
//! [`RESOLUTION`], and on the finer [`GRID`] only where the solver gives no verdict at one of those.

use crate::motion::time_grid::{determined, earliest};
use crate::planner::hover::HoverPlanner;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::MAX_MISSION_TIME;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};

/// Shortest times are multiples of this, s (unless the spec determines the time).
pub const GRID: f64 = 0.01;

/// A shortest time is claimed only if a time shorter by at most this was proved infeasible, s.
pub const RESOLUTION: f64 = 0.05;

/// A shortest time with its plan and its proof.
#[derive(Debug, Clone)]
pub struct Shortest {
    /// s
    pub time: f64,
    pub planned: Planned,
    /// A time shorter by at most [`RESOLUTION`] that was proved infeasible, s; `None` where fixed times and holds leave
    /// no shorter one, and in the exact model.
    pub infeasible_at: Option<f64>,
    /// Longer times that were tried and proved infeasible, s: feasibility is not monotone here.
    pub infeasible_above: Vec<f64>,
    /// Whether the plan is another motion flown slower, because the budget ended before a shorter one was complete, or
    /// because that motion could not be shortened on the full grid.
    pub is_slowed: bool,
}

impl Shortest {
    /// A time, s, of which nothing is proved.
    pub fn new(time: f64, planned: Planned) -> Self {
        Shortest { time, planned, infeasible_at: None, infeasible_above: Vec::new(), is_slowed: false }
    }
}

/// Why there is no shortest time.
#[derive(Debug, Clone, PartialEq)]
pub enum NoTime {
    /// Each time tried was proved infeasible: these, s, in the order of the search.
    Infeasible { times: Vec<f64> },
    /// No plan was found, and some time tried was not proved infeasible.
    Inconclusive { at: f64, status: String },
}

/// What a search can use of earlier results.
#[derive(Debug, Clone, Default)]
pub struct Hint {
    /// A first guess, s.
    pub near: Option<f64>,
    /// A time proved infeasible (for a larger set), s.
    pub infeasible: Option<f64>,
    /// A time known to be feasible (from a smaller set), s.
    pub feasible: Option<f64>,
    /// A plan of this very set at `feasible`.
    pub planned: Option<Box<Planned>>,
    /// Plans of any set, for the warm start of the SCP planner.
    pub initial_guesses: Vec<Planned>,
    /// The time found for a larger set, s: the SCP planner does not shorten a plan that is nearly as short.
    pub larger: Option<f64>,
}

/// Mission times in ticks of [`GRID`].
type Ticks = i64;

/// Estimate: the slack of hover counts as at least this (widths of the healthy set), because precision is relative to
/// it. Chosen by hand.
const MIN_HOVER_MARGIN: f64 = 1e-3;
/// Estimate: a violation beyond this share of its (negative) lower bound is neither minimised further nor interpolated.
/// Chosen by hand.
pub(crate) const NEAR_LEAST: f64 = 0.99;
/// Estimate: interpolation changes the time by factors between these, because the rule 1/T^2 holds only nearby.
/// Chosen by hand.
const MIN_RATIO: f64 = 0.4;
/// Estimate: the largest factor by which interpolation changes the time; see [`MIN_RATIO`].
const MAX_RATIO: f64 = 2.5;
/// Estimate without interpolation: factor to the next time while none is known to be feasible. Chosen by hand.
const LONGER: f64 = 1.3;
/// Estimate without interpolation: factor to the next time while all are feasible. Chosen by hand.
const SHORTER: f64 = 0.7;

/// [`RESOLUTION`] in ticks.
const STEP: Ticks = 5;

fn seconds(t: Ticks) -> f64 {
    // Divided, not multiplied, so that 1553 ticks print as 15.53.
    t as f64 / (1.0 / GRID).round()
}

/// What a search on the full grid starts from.
struct Known {
    low: Option<Ticks>,
    high: Option<Ticks>,
    planned: Option<Box<Planned>>,
}

struct Search<'e, 'a> {
    planner: &'e mut HoverPlanner<'a>,
    set: &'e PlanningSet,
    working_set: &'e mut WorkingSet,
    /// The largest time known to leave some leg no time.
    floor: Ticks,
}

impl<'a> HoverPlanner<'a> {
    /// The shortest mission time for a set.
    ///
    /// # Errors
    /// [`NoTime`], if each time tried is proved infeasible or the search ends without a proof.
    pub fn shortest(
        &mut self,
        set: &PlanningSet,
        hint: Hint,
        working_set: &mut WorkingSet,
    ) -> Result<Shortest, NoTime> {
        let samples = self.model().plan.samples;
        if let Some(total) = determined(self.mission()) {
            return match self.decide(total, samples, set, working_set) {
                Decision::Feasible(planned) => Ok(Shortest::new(total, *planned)),
                Decision::Infeasible => Err(NoTime::Infeasible { times: vec![total] }),
                Decision::Inconclusive(status) => Err(NoTime::Inconclusive { at: total, status }),
            };
        }
        let floor = (earliest(self.mission()) / GRID).floor() as Ticks;
        let floor = floor - floor.rem_euclid(STEP);
        let mut search = Search { planner: self, set, working_set, floor };
        let ticks = |t: Option<f64>| t.map(|t| (t / GRID).round() as Ticks);
        let (low, high) = (ticks(hint.infeasible), ticks(hint.feasible));
        let start = match (low, high) {
            (Some(l), Some(h)) if hint.planned.is_some() && h - l <= STEP => None,
            // A smaller set's shortest time is often this set's too.
            (_, Some(h)) if hint.planned.is_some() => Some(h - STEP),
            _ => {
                let time = search.estimate(hint.near, samples);
                let start = ((time / RESOLUTION - 0.1).ceil() as Ticks) * STEP;
                let least = low.map_or(start, |l| l + STEP);
                Some(start.clamp(least, high.unwrap_or(start).max(least)))
            }
        };
        let mut found = search.bisect(start, Known { low, high, planned: hint.planned }, samples)?;
        found.infeasible_above = search.scan_above(&found, samples);
        Ok(found)
    }

    /// A first guess of the mission time, s: each leg flown from rest to rest at half of g.
    pub fn guess(&self) -> f64 {
        let points = &self.mission().waypoints;
        let legs: f64 = points
            .windows(2)
            .map(|w| {
                let d: f64 = (0..3).map(|i| (w[1].position[i] - w[0].position[i]).powi(2)).sum();
                2.0 * (d.sqrt() / (0.5 * self.model().gravity)).sqrt()
            })
            .sum();
        earliest(self.mission()) + legs.max(1.0)
    }
}

impl Search<'_, '_> {
    fn try_at(&mut self, t: Ticks, samples: usize) -> Decision {
        if t <= self.floor {
            return Decision::Infeasible;
        }
        self.planner.begins_trial(seconds(t));
        let decision = self.planner.decide(seconds(t), samples, self.set, self.working_set);
        self.planner.trial.note(seconds(t), matches!(decision, Decision::Feasible(_)));
        decision
    }

    /// An estimate of the shortest time, s, from the coarse grid, corrected for the error of that grid. It proves
    /// nothing.
    fn estimate(&mut self, guess: Option<f64>, samples: usize) -> f64 {
        let coarse = self.planner.coarse_samples();
        let floor = seconds(self.floor);
        let near = guess.unwrap_or_else(|| self.planner.guess());
        let found = self.root(near, coarse);
        // The error of a grid is proportional to the square of its step.
        let legs = self.planner.mission().legs.len() as f64;
        let grid_error = self.planner.settings.search.grid_error;
        let late = |n: usize| 1.0 + grid_error * (legs / n as f64).powi(2);
        floor + (found - floor) * late(samples) / late(coarse)
    }

    /// The time at which the violation vanishes, by interpolation in 1/T^2: accelerations are proportional to 1/T^2,
    /// and the wrench to accelerations where torques are small.
    fn root(&mut self, guess: f64, samples: usize) -> f64 {
        let settings = self.planner.settings.search;
        let floor = seconds(self.floor);
        let hover = self.planner.hover_margin(self.set).max(MIN_HOVER_MARGIN);
        // For very long times the plan has the slack of hover.
        let mut known: Vec<(f64, f64)> = vec![(0.0, -hover)];
        let (mut low, mut high) = (0.0_f64, f64::INFINITY);
        let mut time = (guess - floor).max(GRID);
        for _ in 0..settings.max_steps {
            if floor + time > MAX_MISSION_TIME {
                return guess; // the full grid decides whether there is any time at all
            }
            let violation =
                self.planner.violation(floor + time, samples, self.set, self.working_set, settings.precision * hover);
            match violation {
                Some(e) if e.sigma <= 0.0 => high = high.min(time),
                _ => low = low.max(time),
            }
            let interpolated = violation.filter(|e| e.sigma > NEAR_LEAST * e.least).and_then(|e| {
                known.push((time.powi(-2), e.sigma));
                Some(root_of(&known)?.powf(-0.5).clamp(MIN_RATIO * time, MAX_RATIO * time))
            });
            let next = match interpolated {
                Some(next) if low < next && next < high => next,
                _ if high.is_infinite() => LONGER * low,
                _ if low == 0.0 => SHORTER * high,
                _ => 0.5 * (low + high),
            };
            if (next - time).abs() <= settings.precision * time {
                return floor + next;
            }
            time = next;
        }
        floor + if high.is_finite() { high } else { low }
    }

    fn roughly_feasible(&mut self, t: Ticks) -> bool {
        if t <= self.floor {
            return false;
        }
        self.planner.begins_trial(seconds(t));
        matches!(self.planner.decide_roughly(seconds(t), self.set, self.working_set), Decision::Feasible(_))
    }

    /// Brackets and bisects on the full grid, from an estimate of the shortest time; without one if both ends are
    /// known.
    fn bisect(&mut self, start: Option<Ticks>, known: Known, samples: usize) -> Result<Shortest, NoTime> {
        let mut high: Option<(Ticks, Planned)> = known.high.and_then(|h| Some((h, *known.planned?)));
        let mut low = known.low;
        // A lower end known beforehand may be far below; one found here is near, and bisection pays.
        let mut near = false;
        let mut unknown: Vec<(Ticks, String)> = Vec::new();
        let mut proved: Vec<f64> = low.map(seconds).into_iter().collect();
        let mut stride = STEP;
        let mut next = start;
        while let Some(t) = next {
            match self.try_at(t, samples) {
                Decision::Feasible(planned) => high = Some((t, *planned)),
                Decision::Infeasible => {
                    (low, near) = (Some(t), true);
                    proved.push(seconds(t));
                }
                Decision::Inconclusive(status) => unknown.push((t, status)),
            }
            let highest = unknown.iter().map(|u| u.0).chain(low).max().unwrap_or(self.floor);
            next = match (low, &high) {
                _ if unknown.len() > self.planner.settings.search.max_without_verdict => None,
                (_, None) if seconds(highest) > MAX_MISSION_TIME && unknown.is_empty() => {
                    return Err(NoTime::Infeasible { times: proved });
                }
                (_, None) if seconds(highest) > MAX_MISSION_TIME => None,
                (_, None) => {
                    let up = highest + stride;
                    stride *= 2;
                    Some(known.high.filter(|h| *h > highest).map_or(up, |h| up.min(h)))
                }
                (Some(l), Some((h, _))) if h - l <= STEP => None,
                (Some(l), Some((h, _))) if near || h - l <= 2 * stride => between(l, *h, &unknown),
                (_, Some((h, _))) => {
                    let lowest = unknown.iter().map(|u| u.0).chain([*h]).min().unwrap_or(*h);
                    let down = lowest - stride;
                    stride *= 2;
                    Some(down.max(self.floor))
                }
            };
        }
        let inconclusive = |unknown: Vec<(Ticks, String)>| {
            let (at, status) = unknown.into_iter().next_back().unwrap_or((0, "no verdict".into()));
            NoTime::Inconclusive { at: seconds(at), status }
        };
        let Some((time, planned)) = high else { return Err(inconclusive(unknown)) };
        let Some(low) = low else { return Err(inconclusive(unknown)) };
        if seconds(time - low) > RESOLUTION + 1e-9 {
            return Err(inconclusive(unknown));
        }
        let infeasible_at = (low > self.floor).then(|| seconds(low));
        Ok(Shortest { infeasible_at, ..Shortest::new(seconds(time), planned) })
    }

    /// Longer times proved infeasible. A time at which the plan found is still one when flown slower is not tried; at
    /// the others the coarse grid is tried first and, if it finds no plan, the full one.
    fn scan_above(&mut self, found: &Shortest, samples: usize) -> Vec<f64> {
        let first = (found.time / GRID).round();
        let longer = self.planner.settings.search.longer.map(|f| steps(first * f));
        let mut infeasible = |t: &Ticks| {
            !self.planner.is_plan_when_slowed(&found.planned, self.set, seconds(*t) / found.time)
                && !self.roughly_feasible(*t)
                && matches!(self.try_at(*t, samples), Decision::Infeasible)
        };
        longer.into_iter().filter(&mut infeasible).map(seconds).collect()
    }
}

/// Where the line through the two points nearest to zero vanishes.
fn root_of(known: &[(f64, f64)]) -> Option<f64> {
    let mut nearest = known.to_vec();
    nearest.sort_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let [(qa, a), (qb, b), ..] = nearest[..] else { return None };
    let q = qa - a * (qb - qa) / (b - a);
    (q.is_finite() && q > 0.0).then_some(q)
}

/// A whole number of steps, at least one, in ticks.
fn steps(ticks: f64) -> Ticks {
    ((ticks / STEP as f64).round() as Ticks).max(1) * STEP
}

/// The middle of an open interval: the untried step nearest to it, else the untried tick.
fn between(low: Ticks, high: Ticks, tried: &[(Ticks, String)]) -> Option<Ticks> {
    let middle = low + (high - low) / 2;
    let nearest = |every: Ticks| {
        (0..high - low)
            .flat_map(|d| [middle + d, middle - d])
            .find(|t| t % every == 0 && *t > low && *t < high && !tried.iter().any(|(u, _)| u == t))
    };
    nearest(STEP).or_else(|| nearest(1))
}
