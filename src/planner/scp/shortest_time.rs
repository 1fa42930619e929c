//! The shortest mission time of a plan, and what is said where there is none.

use super::*;
use crate::motion::time_grid::{determined, earliest, has_fixed_times};
use crate::planner::hover::Decision;
use crate::planner::scp::given_time::{FINE_STEP, LEAST_FINE, NOT_FOUND};
use crate::planner::scp::phases::{CLOSELY, CLOSER, StoppingRule};
use crate::planner::scp::relaxation::Verdict;
use crate::planner::timing::kinematics;
use crate::planner::timing::search::{GRID, NoTime, Shortest};

/// Times without a plan are not tried beyond this many times the first guess.
const SLOWEST: f64 = 20.0;

/// A time that is longer than that of a larger set by no more than this share is short enough.
const AS_SHORT: f64 = 3e-3;

/// Times after the last fixed time that a first plan is sought with, in initial durations of the legs there.
const AMPLE: [f64; 4] = [1.0, 1.5, 2.5, 5.0];

fn shortest(time: f64, planned: Planned) -> Shortest {
    Shortest { time, planned, infeasible_at: None, infeasible_above: Vec::new() }
}

fn not_found(at: f64) -> NoTime {
    NoTime::Inconclusive { at, status: NOT_FOUND.into() }
}

impl ScpPlanner<'_, '_> {
    /// The shortest mission time found, on multiples of [`GRID`], and the plan of least cost there; begun from plans of
    /// other sets where there are some. Shorter times are sought until one is nearly as short as `larger`, the time (s) found for a
    /// larger set, and the cost is then lowered less closely.
    pub fn shortest(&mut self, initial_guesses: &[&Planned], larger: Option<f64>) -> Result<Shortest, NoTime> {
        if let Some(total) = determined(self.hover.mission) {
            return match self.decide(total, initial_guesses) {
                Decision::Feasible(planned) => Ok(shortest(total, *planned)),
                Decision::Infeasible => Err(NoTime::Infeasible { times: vec![total] }),
                Decision::Inconclusive(status) => Err(NoTime::Inconclusive { at: total, status }),
            };
        }
        let (model, mission) = (self.hover.model, self.hover.mission);
        if kinematics::least_time_within(model, mission).too_early.is_some() {
            // No mission time is long enough: one stands for all.
            let time = (self.hover.guess() / GRID).ceil() / (1.0 / GRID).round();
            return Err(NoTime::Infeasible { times: vec![time] });
        }
        if has_fixed_times(mission) {
            return match self.chooses_times() {
                true => self.shortest_about_fixed_times(initial_guesses),
                false => self.shortest_after_fixed_times(initial_guesses),
            };
        }
        let mut working_set = BTreeSet::new();
        let slowed = self.slowed(initial_guesses, &mut working_set);
        let enough = larger.map_or(0.0, |larger| (1.0 + AS_SHORT) * larger - self.held());
        let care = if larger.is_some() { CLOSER } else { CLOSELY };
        let has_good_times = slowed.is_some() || self.medium_grid().is_some();
        let smoothing: &[f64] = if has_good_times { &durations::WARM_START } else { &durations::FULL_GRID };
        let guess = self.hover.guess();
        let Some(mut iterate) = slowed.or_else(|| self.first(0.0)) else { return Err(self.none_at_all(guess)) };
        if iterate.grid.total > enough {
            iterate = match self.chooses_times() {
                true => self.optimise_durations(iterate, smoothing, enough, &mut working_set),
                false => self.descend(iterate, (FINE_STEP, LEAST_FINE), enough, &mut working_set),
            };
        }
        self.rounded_up(&iterate, care, &mut working_set)
    }

    /// The plan of least cost about an iterate, at its time rounded up to [`GRID`]: flown a little slower a plan is one still, or
    /// nearly always.
    fn rounded_up(
        &mut self,
        iterate: &Iterate,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Result<Shortest, NoTime> {
        let ticks = ((iterate.grid.total + self.held()) / GRID - 1e-6).ceil();
        for late in [0.0, 1.0, 2.0, 4.0, 8.0, 16.0] {
            let time = (ticks + late) / (1.0 / GRID).round();
            let slower = self.lasting(iterate, time - self.held());
            if let Some(planned) = self.kept_near(slower, time, care, working_set) {
                return Ok(shortest(time, planned));
            }
        }
        Err(not_found(iterate.grid.total + self.held()))
    }

    /// Where waypoints have fixed times and the others' are the planner's: the plan of another set, or one with ample time after
    /// the last fixed time, and steps towards shorter times from there.
    fn shortest_about_fixed_times(&mut self, initial_guesses: &[&Planned]) -> Result<Shortest, NoTime> {
        let mission = self.hover.mission;
        let after = self.spans().last().map_or(0, |span| span.end);
        let unhurried: f64 = kinematics::initial(self.hover.model, mission)[after..].iter().sum();
        let mut tried: Vec<f64> = initial_guesses.iter().map(|planned| planned.grid.total).collect();
        tried.sort_by(f64::total_cmp);
        tried.dedup();
        let begun = tried.len();
        tried.extend(
            AMPLE.map(|factor| ((earliest(mission) + factor * unhurried) / GRID).ceil() / (1.0 / GRID).round()),
        );
        let mut found = (0..tried.len()).find_map(|nth| Some((nth, self.soon_decided(tried[nth], initial_guesses)?)));
        let ample = tried.len() - 1;
        if found.is_none()
            && let Decision::Feasible(planned) = self.decide(tried[ample], &[])
        {
            found = Some((ample, *planned));
        }
        let Some((nth, planned)) = found else { return Err(not_found(tried[ample])) };
        let smoothing: &[f64] = if nth < begun { &durations::WARM_START } else { &durations::FULL_GRID };
        let mut working_set = BTreeSet::new();
        let iterate = self.optimise_durations(self.motion_of(&planned), smoothing, 0.0, &mut working_set);
        let shorter = self.rounded_up(&iterate, CLOSELY, &mut working_set);
        match &shorter {
            Ok(found) if found.time < planned.grid.total => shorter,
            _ => Ok(shortest(planned.grid.total, planned)),
        }
    }

    /// Why no plan was found about a time, nor slower: none was found, or there is none from a quarter of that flight on, at
    /// times each twice the last.
    fn none_at_all(&mut self, time: f64) -> NoTime {
        let samples = self.hover.model.plan.samples;
        let mut at = time - 0.75 * (time - earliest(self.hover.mission));
        let mut proved = Vec::new();
        while !self.chooses_times() {
            let Some(full) = self.lay_out(None, at, samples) else { break };
            if !matches!(self.relaxed(&full.flown()), Verdict::Infeasible) {
                break;
            }
            proved.push(at);
            if at > SLOWEST * time {
                return NoTime::Infeasible { times: proved };
            }
            at *= 2.0;
        }
        not_found(time)
    }

    /// Where only the legs after the last fixed time are free: the time of another set's plan, or the first of ever longer times
    /// with a plan, then bisection.
    fn shortest_after_fixed_times(&mut self, initial_guesses: &[&Planned]) -> Result<Shortest, NoTime> {
        let floor = earliest(self.hover.mission);
        let mut low = floor;
        let mut stride = (0.25 * (self.hover.guess() - floor)).max(GRID);
        let mut best: Option<(f64, Planned)> = None;
        let (mut proved, mut all_proved) = (Vec::new(), true);
        let mut known: Vec<f64> = initial_guesses.iter().map(|planned| planned.grid.total).collect();
        known.sort_by(f64::total_cmp);
        known.dedup();
        for time in known {
            match self.decide(time, initial_guesses) {
                Decision::Feasible(planned) => {
                    best = Some((time, *planned));
                    break;
                }
                decision => {
                    match decision {
                        Decision::Infeasible => proved.push(time),
                        _ => all_proved = false,
                    }
                    low = time;
                }
            }
        }
        while best.as_ref().is_none_or(|b| b.0 - low > (LEAST_FINE * b.0).max(GRID)) {
            let try_at = best.as_ref().map_or(low + stride, |b| 0.5 * (low + b.0));
            let time = (try_at / GRID).ceil() / (1.0 / GRID).round();
            match self.decide(time, initial_guesses) {
                Decision::Feasible(planned) => best = Some((time, *planned)),
                _ if best.as_ref().is_some_and(|b| time >= b.0) => break,
                decision => {
                    match decision {
                        Decision::Infeasible => proved.push(time),
                        _ => all_proved = false,
                    }
                    low = time;
                }
            }
            stride *= 1.5;
            if low > SLOWEST * self.hover.guess() {
                return Err(if all_proved { NoTime::Infeasible { times: proved } } else { not_found(low) });
            }
        }
        let (time, planned) = best.ok_or_else(|| not_found(low))?;
        Ok(shortest(time, planned))
    }
}
