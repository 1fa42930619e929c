//! The smallest mission time at which a planner's program is feasible, and what shows it.
//!
//! A coarse program (few intervals) brackets, the full one decides. Times are tried on multiples of
//! [`RESOLUTION`], and on the finer [`GRID`] only where the solver gives no verdict at one of those.

use super::profile::{determined, earliest};
use super::rows::{Decision, Engine, Planned, Pool};
use super::select::PlanningSet;

/// Shortest times are multiples of this, s (unless the spec determines the time).
pub const GRID: f64 = 0.01;

/// A shortest time is claimed only where a time shorter by at most this was shown infeasible, s.
pub const RESOLUTION: f64 = 0.05;

/// No mission is searched beyond this, s.
const LONGEST: f64 = 100_000.0;

/// A shortest time and what shows it.
#[derive(Debug, Clone)]
pub struct Shortest {
    /// s
    pub time: f64,
    pub planned: Planned,
    /// A time shorter by at most [`RESOLUTION`] that was shown infeasible; `None` where fixed times and holds
    /// leave no shorter one.
    pub infeasible_at: Option<f64>,
    /// Longer times that were tried on a coarse grid and found infeasible: feasibility is not monotone here.
    pub infeasible_above: Vec<f64>,
}

/// Why there is no shortest time.
#[derive(Debug, Clone, PartialEq)]
pub enum NoTime {
    /// No time up to the given one is feasible.
    Infeasible { up_to: f64 },
    /// The solver gave no verdict where one was needed.
    Inconclusive { at: f64, status: String },
}

/// What is known before a search, s.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Hint {
    /// Where to start looking.
    pub near: Option<f64>,
    /// Shown infeasible (for a larger set).
    pub infeasible: Option<f64>,
    /// Shown feasible (for a smaller set).
    pub feasible: Option<f64>,
}

/// Mission times in ticks of [`GRID`].
type Ticks = i64;

/// [`RESOLUTION`] in ticks.
const STEP: Ticks = 5;

fn seconds(t: Ticks) -> f64 {
    // Divided, not multiplied, so that 1553 ticks print as 15.53.
    t as f64 / (1.0 / GRID).round()
}

struct Search<'e, 'a> {
    engine: &'e mut Engine<'a>,
    set: &'e PlanningSet,
    pool: &'e mut Pool,
    /// The largest time known to leave some leg no time.
    floor: Ticks,
}

impl<'a> Engine<'a> {
    /// The shortest mission time for a set.
    pub fn shortest(&mut self, set: &PlanningSet, hint: Hint, pool: &mut Pool) -> Result<Shortest, NoTime> {
        let samples = self.model.plan.samples;
        if let Some(total) = determined(self.mission) {
            return match self.decide(total, samples, set, pool) {
                Decision::Feasible(planned) => Ok(Shortest {
                    time: total,
                    planned: *planned,
                    infeasible_at: None,
                    infeasible_above: Vec::new(),
                }),
                Decision::Infeasible => Err(NoTime::Infeasible { up_to: total }),
                Decision::Inconclusive(status) => Err(NoTime::Inconclusive { at: total, status }),
            };
        }
        let floor = (earliest(self.mission) / GRID).floor() as Ticks;
        let floor = floor - floor.rem_euclid(STEP);
        let mut search = Search { engine: self, set, pool, floor };
        let ticks = |t: Option<f64>| t.map(|t| (t / GRID).round() as Ticks);
        let (low, high) = (ticks(hint.infeasible), ticks(hint.feasible));
        // Just above a time known infeasible is where nearly equal sets end.
        let start = match (low, high) {
            (Some(l), _) => l + STEP,
            (None, Some(h)) => h - STEP,
            (None, None) => {
                let guess = hint.near.unwrap_or_else(|| search.engine.guess());
                search.rough(guess)?
            }
        };
        let mut found = search.exact(start, low, high, samples)?;
        found.infeasible_above = search.scan_above(found.time);
        Ok(found)
    }

    /// A first guess, s: each leg flown from rest to rest at half of g.
    pub fn guess(&self) -> f64 {
        let points = &self.mission.waypoints;
        let legs: f64 = points
            .windows(2)
            .map(|w| {
                let d: f64 = (0..3).map(|i| (w[1].position[i] - w[0].position[i]).powi(2)).sum();
                2.0 * (d.sqrt() / (0.5 * self.model.gravity)).sqrt()
            })
            .sum();
        earliest(self.mission) + legs.max(1.0)
    }
}

impl Search<'_, '_> {
    fn try_at(&mut self, t: Ticks, samples: usize) -> Decision {
        if t <= self.floor {
            return Decision::Infeasible;
        }
        self.engine.progress(seconds(t));
        self.engine.decide(seconds(t), samples, self.set, self.pool)
    }

    /// A time feasible on a coarse grid, within 1 % of the shortest there. Claims nothing.
    fn rough(&mut self, guess: f64) -> Result<Ticks, NoTime> {
        let samples = self.engine.coarse_samples();
        let share = |t: Ticks, floor: Ticks, part: f64| steps((t - floor) as f64 * part);
        let mut high = self.floor + steps(guess / GRID - self.floor as f64);
        let mut low;
        if matches!(self.try_at(high, samples), Decision::Feasible(_)) {
            loop {
                let t = high - share(high, self.floor, 0.25);
                if !matches!(self.try_at(t, samples), Decision::Feasible(_)) {
                    low = t;
                    break;
                }
                high = t;
            }
        } else {
            loop {
                low = high;
                high += share(high, self.floor, 0.3);
                if seconds(high) > LONGEST {
                    return Err(NoTime::Infeasible { up_to: seconds(low) });
                }
                if matches!(self.try_at(high, samples), Decision::Feasible(_)) {
                    break;
                }
            }
        }
        while (high - low) as f64 > 0.02 * (high - self.floor) as f64 && high - low > STEP {
            let middle = low + (high - low) / (2 * STEP) * STEP;
            match self.try_at(middle, samples) {
                Decision::Feasible(_) => high = middle,
                _ => low = middle,
            }
        }
        Ok(high)
    }

    /// Brackets and bisects on the full grid, from a time thought near the shortest; `low` is known infeasible and
    /// `known_high` feasible.
    fn exact(
        &mut self,
        start: Ticks,
        low: Option<Ticks>,
        known_high: Option<Ticks>,
        samples: usize,
    ) -> Result<Shortest, NoTime> {
        let mut high: Option<(Ticks, Planned)> = None;
        let mut low = low;
        let mut first = true;
        let mut unknown: Vec<(Ticks, String)> = Vec::new();
        let mut stride = steps((start - self.floor) as f64 * 0.01);
        loop {
            let t: Ticks = match (low, &high) {
                _ if first => start,
                (None, None) => start,
                // A known end halves the interval from the first; it is planned itself only if all else fails.
                (Some(l), None) => match known_high.filter(|h| *h > l) {
                    Some(h) => (l + steps((h - l) as f64 / 2.0)).min(h),
                    None => l + stride,
                },
                (None, Some((h, _))) => (h - stride).max(self.floor),
                (Some(l), Some((h, _))) if h - l > STEP => match between(l, *h, &unknown) {
                    Some(t) => t,
                    None => break,
                },
                _ => break,
            };
            first = false;
            match self.try_at(t, samples) {
                Decision::Feasible(planned) => {
                    if high.is_some() && low.is_none() {
                        stride *= 2;
                    }
                    high = Some((t, *planned));
                }
                Decision::Infeasible => {
                    if low.is_some() && high.is_none() {
                        stride *= 2;
                    }
                    low = Some(t);
                }
                Decision::Inconclusive(status) => {
                    unknown.push((t, status));
                    // Without a verdict here, look for one a little further on.
                    match (low, &high) {
                        (Some(_), Some(_)) => {}
                        (_, None) => low = low.or(Some(t)),
                        (None, Some(_)) => stride *= 2,
                    }
                    if unknown.len() > 20 {
                        break;
                    }
                }
            }
            if low.is_some_and(|l| high.is_none() && seconds(l) > LONGEST) {
                return Err(NoTime::Infeasible { up_to: LONGEST });
            }
        }
        let inconclusive = |unknown: Vec<(Ticks, String)>| {
            let (at, status) = unknown.into_iter().next_back().unwrap_or((0, "no verdict".into()));
            NoTime::Inconclusive { at: seconds(at), status }
        };
        let Some((time, planned)) = high else { return Err(inconclusive(unknown)) };
        let Some(low) = low.filter(|l| !unknown.iter().any(|(u, _)| u == l)) else {
            return Err(inconclusive(unknown));
        };
        if seconds(time - low) > RESOLUTION + 1e-9 {
            return Err(inconclusive(unknown));
        }
        let infeasible_at = (low > self.floor).then(|| seconds(low));
        Ok(Shortest { time: seconds(time), planned, infeasible_at, infeasible_above: Vec::new() })
    }

    /// Without fixed times and holds a plan slowed down stays feasible (every wrench moves towards hover), so only
    /// missions with them are scanned.
    fn scan_above(&mut self, time: f64) -> Vec<f64> {
        if !self.engine.mission.waypoints.iter().any(|w| w.hold > 0.0 || w.time.is_some()) {
            return Vec::new();
        }
        let samples = self.engine.coarse_samples();
        let first = (time / GRID).round() as Ticks;
        [1.05, 1.1, 1.2, 1.4, 1.7, 2.0, 3.0]
            .iter()
            .map(|f| (first as f64 * f) as Ticks)
            .filter(|&t| matches!(self.try_at(t, samples), Decision::Infeasible))
            .map(seconds)
            .collect()
    }
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
