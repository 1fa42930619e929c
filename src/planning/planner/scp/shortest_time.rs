//! The search for the shortest mission time of a plan.

use super::iterate::Iterate;
use super::{ScpPlanner, settings};
use crate::model::SearchEffort;
use crate::motion::time_grid::{determined, earliest};
use crate::planner::scp::given_time::NOT_FOUND;
use crate::planner::scp::relaxation::RelaxationOutcome;
use crate::planner::timing::kinematics;
use crate::planner::timing::search::{GRID, NoTime, Shortest};
use crate::planner::transcription::RowAt;
use crate::planner::{Decision, Planned};
use settings::StoppingRule;
use std::collections::BTreeSet;

fn not_found(at: f64) -> NoTime {
    NoTime::Inconclusive { at, status: NOT_FOUND.into() }
}

impl ScpPlanner<'_, '_> {
    /// The shortest mission time found, on multiples of [`GRID`], and the plan of least cost there. `initial_guesses`
    /// are plans of other sets, for a warm start. Shorter times are sought until one is nearly as short as `larger`,
    /// the time (s) found for a larger set; the cost is then minimised less closely.
    ///
    /// # Errors
    /// [`NoTime`], if each time tried is proved infeasible or if no plan is found.
    pub fn shortest(&mut self, initial_guesses: &[&Planned], larger: Option<f64>) -> Result<Shortest, NoTime> {
        if let Some(total) = determined(self.mission()) {
            return match self.decide(total, initial_guesses) {
                Decision::Feasible(planned) => Ok(Shortest::new(total, *planned)),
                Decision::Infeasible => Err(NoTime::Infeasible { times: vec![total] }),
                Decision::Inconclusive(status) => Err(NoTime::Inconclusive { at: total, status }),
            };
        }
        if kinematics::least_time_within(self.problem()).too_early.is_some() {
            // A fixed time is too early whatever the mission time: one is named for all.
            let time = (self.hover.guess() / GRID).ceil() / (1.0 / GRID).round();
            return Err(NoTime::Infeasible { times: vec![time] });
        }
        if self.mission().has_fixed_times() {
            return match self.chooses_times() {
                true => self.shortest_about_fixed_times(initial_guesses),
                false => self.shortest_after_fixed_times(initial_guesses),
            };
        }
        let mut working_set = BTreeSet::new();
        let settings = self.settings;
        let warm_start = self.warm_start(initial_guesses, &mut working_set);
        let enough = larger.map_or(0.0, |larger| (1.0 + settings.search.short_enough) * larger - self.held());
        let rule = match self.model().plan.effort {
            SearchEffort::Quick => settings.cost.rough,
            _ if larger.is_some() => settings.cost.medium,
            _ => settings.cost.close,
        };
        let guess = self.hover.guess();
        let mut iterate = match warm_start {
            Some(first) => {
                let (weights, radius) = settings.durations.on_full_grid();
                self.shorten(first.clone(), weights, radius, enough, &mut working_set).unwrap_or(first)
            }
            None => match self.first_feasible(0.0) {
                Some(first) => first,
                None => return Err(self.none_at_all(guess)),
            },
        };
        iterate = self.on_its_own_grid(iterate, &mut working_set);
        let found = self.rounded_up(&iterate, rule, &mut working_set).or_else(|none| {
            self.is_slowed = true;
            self.flown_slower(&iterate).or_else(|| self.at_rest_between()).ok_or(none)
        })?;
        Ok(Shortest { is_slowed: self.is_slowed, ..found })
    }

    /// The plan along the motion of a feasible iterate, flown slower: where the budget ends before the iterate itself
    /// is complete. Slower, its wrench is closer to that of hover, so that it may need no step. `None` if none of
    /// [`settings::SlowingSettings::slowdowns`] is enough.
    fn flown_slower(&mut self, iterate: &Iterate) -> Option<Shortest> {
        let slower = self.settings.slowing.slowdowns;
        let plan = |factor: f64| {
            let mut working_set = BTreeSet::new();
            self.rounded_up(&iterate.slower(factor), StoppingRule::NO_STEPS, &mut working_set).ok()
        };
        slower.into_iter().find_map(plan)
    }

    /// The plan in closed form ([`Self::rest_to_rest`]), which takes no program: where the budget ends before a shorter
    /// one is complete. `None` if there is no such motion on the full grid.
    fn at_rest_between(&mut self) -> Option<Shortest> {
        let slow = self.rest_to_rest_in_full()?;
        // It satisfies every row at the instants; between these it may need a little more time.
        let slower = self.settings.grids.slowdowns;
        let plan = |factor: f64| {
            let mut working_set = BTreeSet::new();
            self.rounded_up(&slow.slower(factor), StoppingRule::NO_STEPS, &mut working_set).ok()
        };
        slower.into_iter().find_map(plan)
    }

    /// The plan of least cost from a feasible iterate, at its time rounded up to [`GRID`], or later by the first of
    /// [`settings::SearchSettings::late`] at which there is one: a plan flown a little slower is nearly always still
    /// one.
    fn rounded_up(
        &mut self,
        iterate: &Iterate,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Result<Shortest, NoTime> {
        // Rows hold at nodes only, so that an iterate could be shorter than the bound.
        let least = kinematics::least_time_within(self.problem()).seconds;
        let ticks = ((iterate.grid.total + self.held()) / GRID - 1e-6).ceil().max((least / GRID).ceil());
        for late in self.settings.search.late {
            let time = (ticks + late) / (1.0 / GRID).round();
            let slower = self.lasting(iterate, time - self.held());
            self.begins_trial(time);
            let planned = self.restored_plan(slower, time, rule, working_set);
            self.hover.trial.note(time, planned.is_some());
            if let Some(planned) = planned {
                return Ok(Shortest::new(time, planned));
            }
        }
        Err(not_found(iterate.grid.total + self.held()))
    }

    /// Where some waypoints have fixed times and the planner chooses the others': starts from the plan of another set,
    /// or from one with ample time after the last fixed time, and shortens the durations.
    fn shortest_about_fixed_times(&mut self, initial_guesses: &[&Planned]) -> Result<Shortest, NoTime> {
        let mission = self.mission();
        let after = self.spans().last().map_or(0, |span| span.end);
        let initial_total: f64 = kinematics::initial(self.problem())[after..].iter().sum();
        let mut tried: Vec<f64> = initial_guesses.iter().map(|planned| planned.grid.total).collect();
        tried.sort_by(f64::total_cmp);
        tried.dedup();
        let of_other_sets = tried.len();
        tried.extend(
            self.settings
                .search
                .ample
                .map(|factor| ((earliest(mission) + factor * initial_total) / GRID).ceil() / (1.0 / GRID).round()),
        );
        let mut found =
            (0..tried.len()).find_map(|nth| Some((nth, self.on_first_divisions(tried[nth], initial_guesses)?)));
        let ample = tried.len() - 1;
        if found.is_none()
            && let Decision::Feasible(planned) = self.decide(tried[ample], &[])
        {
            found = Some((ample, *planned));
        }
        let Some((nth, planned)) = found else { return Err(not_found(tried[ample])) };
        let settings = self.settings;
        let durations = &settings.durations;
        let (weights, radius) = match nth < of_other_sets {
            true => durations.on_full_grid(),
            false => (&durations.cost_weights[..], durations.first_radius),
        };
        let mut working_set = BTreeSet::new();
        let first = self.iterate_of(&planned);
        let iterate = self.shorten(first.clone(), weights, radius, 0.0, &mut working_set).unwrap_or(first);
        let iterate = self.on_its_own_grid(iterate, &mut working_set);
        let shorter = self.rounded_up(&iterate, settings.cost.close, &mut working_set);
        match &shorter {
            Ok(found) if found.time < planned.grid.total => shorter,
            _ => Ok(Shortest::new(planned.grid.total, planned)),
        }
    }

    /// The verdict where no plan was found from a first guess of the time, nor at slower ones: proved infeasible, if
    /// the relaxation proves it from a quarter of that flight on, at times each twice the last; else not found.
    fn none_at_all(&mut self, time: f64) -> NoTime {
        let samples = self.model().plan.samples;
        let mut at = time - self.settings.search.first_proof * (time - earliest(self.mission()));
        let mut proved = Vec::new();
        while !self.chooses_times() {
            let Some(full) = self.lay_out(None, at, samples) else { break };
            if !matches!(self.relaxed(&full.flown()), RelaxationOutcome::Infeasible) {
                break;
            }
            proved.push(at);
            if at > self.settings.search.max_multiple * time {
                return NoTime::Infeasible { times: proved };
            }
            at *= 2.0;
        }
        not_found(time)
    }

    /// Where only the legs after the last fixed time are free: bisection, from the time of another set's plan or from
    /// the first of ever longer times with a plan.
    fn shortest_after_fixed_times(&mut self, initial_guesses: &[&Planned]) -> Result<Shortest, NoTime> {
        let floor = earliest(self.mission());
        let settings = self.settings.search;
        let resolution = settings.resolution;
        let mut low = floor;
        let mut stride = (settings.first_stride * (self.hover.guess() - floor)).max(GRID);
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
        while best.as_ref().is_none_or(|b| b.0 - low > (resolution * b.0).max(GRID)) {
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
            stride *= settings.stride_growth;
            if low > settings.max_multiple * self.hover.guess() {
                return Err(if all_proved { NoTime::Infeasible { times: proved } } else { not_found(low) });
            }
        }
        let (time, planned) = best.ok_or_else(|| not_found(low))?;
        Ok(Shortest::new(time, planned))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Problem;
    use crate::motion::wrench_model::WrenchModel;
    use crate::planner::hover::HoverPlanner;
    use crate::planner::scp::settings::ScpSettings;
    use crate::planner::selection::sets::PlanningSets;

    /// A search that may solve one program only still has the plan in closed form.
    #[test]
    fn without_budget_the_plan_rests_at_every_waypoint() {
        let spec = crate::compile(
            "vehicle v { layout = \"PNPNPN\"; arm = 0.4 m; mass = 3 kg; inertia = [0.05, 0.06, 0.1] kg*m^2
    rotor { max_thrust = 9 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s } }
mission m {
    start at [0, 0, 2] m
    waypoint at [9, 0, 4] m
    waypoint at [9, 7, 4] m  yaw 90 deg
    keep_out pole { shape = box; from = [3, 3, 0] m; to = [5, 5, 9] m }
    limits { speed <= 4 m/s; tilt <= 25 deg }
}
plan { planner = rip; against = []; samples = 100 }",
        );
        let spec = spec.into_result().unwrap();
        let sets = PlanningSets::of(spec.model());
        let problem = Problem::of(spec.model()).unwrap();
        let shortest = |budget: f64| {
            let mut settings = ScpSettings::DEFAULT;
            settings.budget.normal = budget;
            let mut hover = HoverPlanner::new(problem, &sets.healthy);
            ScpPlanner::with_settings(&mut hover, WrenchModel::Exact, &sets.rip, settings).shortest(&[], None)
        };
        let (slow, quick) = (shortest(1.0).unwrap(), shortest(ScpSettings::DEFAULT.budget.normal).unwrap());
        assert!(slow.time > 1.2 * quick.time, "{} {}", slow.time, quick.time);
        assert!(slow.is_slowed && !quick.is_slowed);
        let node = slow.planned.grid.waypoint_nodes[1];
        assert!((0..4).all(|axis| slow.planned.states[node][axis][1].abs() < 1e-9));
    }
}
