//! Every command finds one plan: times in the order of the sets, the same from `plan`, `compare` and a campaign, and
//! plans at longer times than the shortest.

use super::{last, planning, solved};
use crate::vehicles::{limit, mission, waypoint};
use mavc::model::grid::Spacing;
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlannerKind, Problem};
use mavc::planner::studies::{Comparison, PlanOutcome, PlannerRun, Run, Scope, run_planners};
use rand_distr::{Distribution, Uniform};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;
use rayon::prelude::*;

/// Two to four legs of 2 to 20 m with turns, under limits.
fn random_mission(seed: u64) -> Mission {
    let mut random = Pcg64::seed_from_u64(seed);
    let mut between = |low: f64, high: f64| Uniform::new(low, high).unwrap().sample(&mut random);
    let (mut at, mut yaw) = ([0.0, 0.0, 5.0], 0.0);
    let mut points = vec![waypoint(at, yaw)];
    for _ in 0..between(2.0, 5.0) as usize {
        let (length, heading): (f64, f64) = (between(2.0, 20.0), between(0.0, std::f64::consts::TAU));
        at = [
            at[0] + length * heading.cos(),
            at[1] + length * heading.sin(),
            f64::max(2.0, at[2] + between(-0.3, 0.3) * length),
        ];
        yaw += between(-0.6, 0.6);
        points.push(waypoint(at, yaw));
    }
    let limits = vec![
        limit(LimitKind::Tilt, f64::to_radians(between(20.0, 40.0))),
        limit(LimitKind::Speed, between(3.0, 10.0)),
        limit(LimitKind::Descent, between(1.0, 3.0)),
    ];
    Mission { limits, ..mission(points) }
}

fn free(mission: Mission, planner: PlannerKind) -> Model {
    let mut model = planning(Mission { spacing: Spacing::Graded, ..mission }, planner, &[0, 1], MissionTime::Minimum);
    model.plan.samples = 24;
    model.plan.chooses_times = model.mission.as_ref().is_some_and(Mission::leaves_times_free);
    model
}

fn found(model: &Model, scope: Scope) -> Comparison {
    run_planners(Problem::of(model).unwrap(), scope, None)
}

fn run(comparison: &Comparison, planner: PlannerKind, against: usize, which: Run) -> &PlannerRun {
    let is_it = |r: &&PlannerRun| r.planner == planner && r.against.len() == against && r.run == which;
    comparison.runs.iter().find(is_it).unwrap()
}

/// RIP's, RSP's and the joint RCP's own time in a comparison, after their order is checked.
fn own_times(compared: &Comparison) -> [f64; 3] {
    let own = |planner, against| solved(run(compared, planner, against, Run::Own)).time;
    let [rip, rsp, joint] = [own(PlannerKind::Rip, 0), own(PlannerKind::Rsp, 2), own(PlannerKind::Rcp, 2)];
    assert!(rip <= rsp && rsp <= joint, "{rip} {rsp} {joint}");
    for single in compared.runs.iter().filter(|r| r.planner == PlannerKind::Rcp && r.run == Run::Own) {
        let time = solved(single).time;
        assert!(rip <= time && time <= joint, "{rip} {time} {joint}");
    }
    [rip, rsp, joint]
}

fn commands_agree(mission: &Mission, samples: usize) {
    let free = |planner| {
        let mut model = free(mission.clone(), planner);
        model.plan.samples = samples;
        model
    };
    let compared = found(&free(PlannerKind::Rsp), Scope::Everything);
    let times = own_times(&compared);
    for (planner, due) in [PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp].into_iter().zip(times) {
        let planned = found(&free(planner), Scope::Plan);
        let own = solved(last(&planned));
        assert!((own.time - due).abs() <= 5e-3 * due, "{planner:?}: {} {due}", own.time);
        takes_a_shorter_plan(&compared, planner, planned.clone());
    }
}

/// A plan that was found otherwise, and is shorter, is the planner's own, and the times stay in order.
fn takes_a_shorter_plan(compared: &Comparison, planner: PlannerKind, mut shorter: Comparison) {
    let is_own = |run: &PlannerRun| {
        run.run == Run::Own && run.planner == planner && (planner == PlannerKind::Rip || run.against.len() == 2)
    };
    let place = compared.runs.iter().position(is_own).unwrap();
    let PlanOutcome::Planned(plan) = &mut shorter.runs.last_mut().unwrap().outcome else { unreachable!() };
    plan.time = 0.9 * solved(&compared.runs[place]).time;
    let (time, mut taken) = (plan.time, compared.clone());
    taken.take_own(place, shorter);
    let [rip, rsp, joint] = own_times(&taken);
    assert_eq!(solved(&taken.runs[place]).time, time);
    assert!(rip <= rsp && rsp <= joint, "{rip} {rsp} {joint}");
}

/// At a time that the spec fixes a campaign flies, and a comparison shows, the plan of `plan`, each planner's.
fn one_plan_at_a_time(scope: Scope, planners: &[PlannerKind]) {
    let at_30_s = |planner: PlannerKind| {
        let mut model = free(random_mission(3), planner);
        model.plan.time = MissionTime::Fixed(30.0);
        model
    };
    let all = found(&at_30_s(planners[0]), scope);
    for &planner in planners {
        let against = if planner == PlannerKind::Rip { 0 } else { 2 };
        let planned = found(&at_30_s(planner), Scope::Plan);
        let shown = solved(run(&all, planner, against, Run::Common));
        assert_eq!(shown.trajectory, solved(last(&planned)).trajectory, "{planner:?}");
    }
}

#[test]
fn a_campaign_flies_the_plan() {
    one_plan_at_a_time(Scope::Common, &[PlannerKind::Rsp]);
}

/// RSP leaves a mode's set at its shortest time only where that saves time beside RCP, which leaves none.
#[test]
fn a_shortest_plan_leaves_sets_only_for_time() {
    for seed in [3, 5] {
        let planned = found(&free(random_mission(seed), PlannerKind::Rsp), Scope::Plan);
        let (plan, rcp) = (solved(last(&planned)), planned.covering_time.unwrap());
        let leaves = plan.outside.iter().any(|outside| outside.last.is_some());
        assert!(!leaves || plan.time < rcp - (3e-3 * plan.time).max(0.05), "{seed}: {} {rcp}", plan.time);
    }
}

/// The time that the spec fixes does not matter for the shortest time: RSP's facets are selected at RCP's.
#[test]
#[ignore = "long"]
fn a_fixed_time_leaves_rsps_shortest_time() {
    let mut fixed = free(random_mission(3), PlannerKind::Rsp);
    let planned = found(&fixed, Scope::Plan);
    let least = solved(last(&planned)).time;
    fixed.plan.time = MissionTime::Fixed(30.0);
    let compared = found(&fixed, Scope::Everything);
    let own = solved(run(&compared, PlannerKind::Rsp, 2, Run::Own));
    assert!(least < 30.0 && (own.time - least).abs() <= 5e-3 * least, "{} {least}", own.time);
    let mut checked = compared.clone();
    mavc::certify::check(Problem::of(&fixed).unwrap(), &mut checked);
    assert!(checked.runs.iter().all(|run| run.outcome.plan().is_some()));
}

#[test]
#[ignore = "long"]
fn a_comparison_shows_the_plan() {
    one_plan_at_a_time(Scope::Everything, &[PlannerKind::Rip, PlannerKind::Rcp, PlannerKind::Rsp]);
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// With one leg there is nothing to choose but the mission time; RIP's own search ends longer than RCP's here.
    #[test]
    #[ignore = "long"]
    fn a_single_leg_has_the_same_time_in_every_command() {
        let mut leg = mission(vec![waypoint([0.0, 0.0, 5.0], 0.0), waypoint([3.8, -9.7, 8.6], 0.0)]);
        leg.limits = vec![limit(LimitKind::Tilt, f64::to_radians(35.0))];
        commands_agree(&leg, 16);
    }

    #[test]
    #[ignore = "long"]
    fn every_command_finds_the_same_times_in_the_order_of_the_sets() {
        commands_agree(&random_mission(0), 24);
    }

    /// Times 1.02 to 2 times the shortest, without lower bounds on rates. `benches/longer.py` tries 200 missions.
    #[test]
    #[ignore = "long"]
    fn longer_times_have_plans() {
        let asked = |seed: u64| -> Vec<(u64, f64)> {
            let mission = random_mission(seed);
            let shortest = solved(last(&found(&free(mission.clone(), PlannerKind::Rip), Scope::Plan))).time;
            let is_missed = |factor: &f64| {
                let mut model = free(mission.clone(), PlannerKind::Rip);
                model.plan.time = MissionTime::Fixed(factor * shortest);
                !matches!(last(&found(&model, Scope::Plan)).outcome, PlanOutcome::Planned(_))
            };
            [1.02, 1.05, 1.1, 1.3, 2.0].into_iter().filter(is_missed).map(|factor| (seed, factor)).collect()
        };
        let missed: Vec<(u64, f64)> = (0..4).into_par_iter().flat_map(asked).collect();
        assert!(missed.is_empty(), "of 20 times: {missed:?}");
    }
}
