//! Rounds of selection, and the whole family of double faults of a large vehicle.

use crate::cli::mavc_with;
use crate::vehicles::{limit, lost, mission, octocopter, paper_case, ring_model, viviani, waypoint};
use mavc::admissible::row::VIOLATED;
use mavc::admissible::{AdmissibleSet, faults_only_take};
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::motion::Trajectory;
use mavc::motion::outside::PARTS;
use mavc::planner::hover::{ACCEPTED, Decision, HoverPlanner};
use mavc::planner::selection::PlanningSet;
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, Run, Scope, run_planners};
use mavc::planner::timing::search::Hint;
use mavc::planner::trial::Trial;
use mavc::planner::working_set::WorkingSet;

fn run(model: &Model, scope: Scope) -> Comparison {
    run_planners(Problem::of(model).unwrap(), scope, None)
}

fn only(comparison: &Comparison) -> &MissionPlan {
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(s) => s,
        other => panic!("{other:?}"),
    }
}

fn planned(mut model: Model, planner: PlannerKind, count: usize) -> Comparison {
    model.plan.planner = planner;
    model.plan.rounds = count;
    run(&model, Scope::Plan)
}

/// The paper's first case not far above RCP's shortest time, where one round is not enough.
fn tight() -> Model {
    let mut model = paper_case(PlannerKind::Rsp, &[0]);
    model.plan.samples = 100;
    model.plan.time = MissionTime::Fixed(16.5);
    model
}

#[test]
fn no_round_is_rip_one_is_rsp_and_many_end_at_rcp() {
    let [rip, rcp] = [PlannerKind::Rip, PlannerKind::Rcp].map(|kind| planned(tight(), kind, 1));
    let [none, one, many] = [0, 1, 30].map(|count| planned(tight(), PlannerKind::Rsp, count));
    assert_eq!(only(&none).trajectory, only(&rip).trajectory);
    assert!(none.selected.is_empty() && one.selected.len() < many.selected.len(), "more than one round is needed");
    // The fixed point leaves nothing by more than what counts as a violation.
    let (fixed, conservative) = (only(&many), only(&rcp));
    assert!(fixed.outside[0].max_violation <= VIOLATED);
    let relative = fixed.objective / conservative.objective - 1.0;
    assert!(relative.abs() < 1e-3 && relative < 1e-5, "{} {}", fixed.objective, conservative.objective);
    let apart = |a: &Trajectory, b: &Trajectory| {
        let nodes = a.nodes.iter().zip(&b.nodes);
        nodes.flat_map(|(p, q)| (0..3).map(move |axis| (p[axis][0] - q[axis][0]).abs())).fold(0.0, f64::max)
    };
    let near = apart(&fixed.trajectory, &conservative.trajectory);
    let far = apart(&only(&rip).trajectory, &conservative.trajectory);
    assert!(near < 1e-3 && near < 0.05 * far, "{near} {far}");
}

#[test]
fn all_double_losses_of_sixteen_rotors_at_once() {
    let mut model = ring_model("PNPNPNPNPNPNPNPN", 4.5, [0.2, 0.2, 0.35], 8.5485e-6, 1.3678e-7, 874.0);
    let pairs = (1..=16).flat_map(|i| (i + 1..=16).map(move |j| [i, j]));
    model.modes = pairs.map(|pair| lost(&model, &pair)).collect();
    assert_eq!(model.modes.len(), 120);
    model.plan.samples = 200;
    let corners = [[0.0, 0.0, 2.0], [6.0, 0.0, 3.0], [6.0, 6.0, 4.0], [0.0, 6.0, 3.0], [0.0, 0.0, 2.0]];
    model.mission = Some(mission(corners.map(|corner| waypoint(corner, 0.0)).to_vec()));
    let healthy = AdmissibleSet::healthy(&model);
    assert!(faults_only_take(&model));
    let hover = healthy_hover(&model);
    let sets: Vec<AdmissibleSet> = (0..120).map(|mode| AdmissibleSet::of_mode(&model, mode)).collect();
    let hovering: Vec<&AdmissibleSet> = sets.iter().filter(|s| s.polytope.margin(&hover) > 1e-6).collect();
    assert!(hovering.len() > 60, "{} of 120 can hover", hovering.len());
    let set = PlanningSet::of(&hovering, &healthy);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let shortest = engine.shortest(&set, Hint::default(), &mut WorkingSet::default()).unwrap();
    let plan = shortest.planned;
    // The faults bind: what the healthy vehicle would fly in that time leaves their sets.
    let whole = PlanningSet::of(&[&healthy], &healthy);
    let Decision::Feasible(free) = engine.decide(shortest.time, 200, &whole, &mut WorkingSet::default()) else {
        panic!("fewer rows")
    };
    let wrenches = free.trajectory().node_wrenches(&model.vehicle, &model.environment());
    let excess = |w| set.rows.iter().map(|r| r.violation(w)).fold(f64::NEG_INFINITY, f64::max);
    let worst = wrenches.iter().map(excess).fold(f64::NEG_INFINITY, f64::max);
    assert!(worst > 0.01, "{worst}");
    // Few of all rows were needed, and all hold: those of every single set, not of the intersection alone.
    assert!(plan.rows < set.rows.len() * 201 / 10, "{} rows", plan.rows);
    for w in plan.trajectory().node_wrenches(&model.vehicle, &model.environment()) {
        assert!(set.rows.iter().all(|r| r.violation(&w) <= ACCEPTED));
        assert!(hovering.iter().all(|s| s.polytope.margin(&w) > -1e-4));
    }
}

fn healthy_hover(model: &Model) -> mavc::actuation::Wrench {
    mavc::actuation::Wrench::new(model.vehicle.mass * model.gravity, 0.0, 0.0, 0.0)
}

#[test]
fn rounds_of_a_guarded_plan_change_nothing() {
    // Slow enough, and the RIP plan is inside every set: nothing to select, however often.
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[1])];
    model.mission = Some(viviani());
    model.plan.samples = 60;
    model.plan.against = vec![0];
    model.plan.time = MissionTime::Fixed(40.0);
    let [one, five] = [1, 5].map(|count| planned(model.clone(), PlannerKind::Rsp, count));
    assert!(five.selected.is_empty());
    assert_eq!(only(&one).trajectory, only(&five).trajectory);
}

/// A short way in the exact model, at 1.1 times the shortest time that is found for the healthy vehicle.
fn short() -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[1])];
    let points = vec![waypoint([0.0, 0.0, 3.0], 0.0), waypoint([5.0, 2.0, 4.0], 0.0)];
    model.mission = Some(Mission { limits: vec![limit(LimitKind::Tilt, 40f64.to_radians())], ..mission(points) });
    model.plan.model = PlanModel::Exact;
    model.plan.against = vec![0];
    model.plan.samples = 20;
    let shortest = only(&planned(model.clone(), PlannerKind::Rip, 1)).time;
    model.plan.time = MissionTime::Fixed((110.0 * shortest).round() / 100.0);
    model
}

/// Facets that are violated at any instant are selected, at nodes or only between them, whatever the grid.
#[test]
#[ignore = "long"]
fn facets_passed_only_between_nodes_are_selected() {
    let mut between = 0;
    let short = short();
    let cases = [12, 16, 20].into_iter().flat_map(|samples| [1.88, 1.95, 2.05, 2.2].map(|time| (samples, time)));
    for (samples, time) in cases {
        let mut model = short.clone();
        model.plan.samples = samples;
        model.plan.time = MissionTime::Fixed(time);
        let rip = planned(model.clone(), PlannerKind::Rip, 1);
        // Facets are selected by the plan before the second pass.
        let seen = rip.runs[0].plainer.as_deref().unwrap_or_else(|| only(&rip));
        let rows = &rip.sets[0].rows;
        let mut passed: Vec<usize> = Vec::new();
        for i in 0..=samples * PARTS {
            let t = seen.time * i as f64 / (samples * PARTS) as f64;
            let w = seen.trajectory.wrench(&model.vehicle, &model.environment(), &seen.trajectory.at(t));
            passed.extend((0..rows.len()).filter(|&row| rows[row].violation(&w) > VIOLATED));
        }
        passed.sort_unstable();
        passed.dedup();
        let rsp = planned(model, PlannerKind::Rsp, 1);
        let selected = |row: &usize| rsp.selected.iter().any(|s| s.origin == rows[*row].origin);
        assert!(passed.iter().all(selected), "{samples} samples: {passed:?} {:?}", rsp.selected);
        assert_eq!(rsp.selected.len(), passed.len(), "{samples} samples");
        between += passed.iter().filter(|row| !seen.outside[0].facets.contains(row)).count();
    }
    assert!(between > 0, "every facet is passed at a node: nothing is shown");
}

/// If RIP's plan violates nothing at T_d, RSP's plan there is the same. For RSP's shortest time the facets are selected
/// elsewhere.
#[test]
fn rsp_without_facets_is_rip() {
    let mut model = short();
    model.plan.samples = 12;
    model.plan.time = MissionTime::Fixed(2.5);
    let told = std::sync::Mutex::new(Vec::new());
    let tell = |name: &str, _: Trial| told.lock().unwrap().push(name.to_string());
    let all = run_planners(Problem::of(&model).unwrap(), Scope::Everything, Some(&tell));
    // Progress counts the runs that are in the end there: six with one mode.
    let told = told.into_inner().unwrap();
    assert_eq!(all.runs.len(), 6);
    assert!(told.iter().all(|name| name.ends_with(" of 6 plans done)")), "{told:?}");
    assert!(told[0].contains("(0 of") && told.iter().any(|name| name.contains("(2 of")), "{told:?}");
    assert!(all.selected.is_empty(), "{:?}", all.selected);
    let plan = |planner: PlannerKind, which: Run| {
        let run = all.runs.iter().find(|r| r.planner == planner && r.run == which).unwrap();
        let PlanOutcome::Planned(solved) = &run.outcome else { panic!("{:?}", run.outcome) };
        solved.trajectory.clone()
    };
    assert!(plan(PlannerKind::Rip, Run::Common) == plan(PlannerKind::Rsp, Run::Common));
    let mut open = model.clone();
    open.plan.time = MissionTime::Minimum;
    let alone = run_planners(Problem::of(&open).unwrap(), Scope::Plan, None);
    let least = alone.runs[0].outcome.plan().unwrap();
    assert_eq!(plan(PlannerKind::Rsp, Run::Own).duration(), least.trajectory.duration());
}

/// No round is RIP, and the report says why nothing is guarded.
#[test]
fn zero_rounds_are_reported() {
    let spec = |rounds: usize| {
        format!(
            "use \"quad.mav\"\nuse \"hop.mav\"\nfaults {{ mode W {{ rotor 3 reduced to 90 % }} }}\n\
             plan {{ model = hover; planner = rsp; against = [W]; rounds = {rounds}; time = 8 s; samples = 40 }}\n"
        )
    };
    let folder = tempfile::tempdir().unwrap();
    for part in ["quad.mav", "hop.mav"] {
        std::fs::copy(format!("tests/specs/parts/{part}"), folder.path().join(part)).unwrap();
    }
    let said = |rounds: usize| {
        let path = folder.path().join(format!("{rounds}.mav"));
        std::fs::write(&path, spec(rounds)).unwrap();
        let ran = mavc_with(&["plan", "-v", path.to_str().unwrap()], "");
        let text = String::from_utf8(ran.stdout).unwrap() + &String::from_utf8(ran.stderr).unwrap();
        assert_eq!(ran.status.code(), Some(0), "{text}");
        text.contains("`rounds = 0` selects no facet")
    };
    assert_eq!([0, 1].map(said), [true, false]);
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn rounds_in_the_exact_model_end_inside() {
        let model = short();
        let rip = planned(model.clone(), PlannerKind::Rip, 1);
        let [none, one, many] = [0, 1, 20].map(|count| planned(model.clone(), PlannerKind::Rsp, count));
        assert_eq!(only(&none).trajectory, only(&rip).trajectory);
        assert!(only(&rip).outside[0].max_violation > 0.01, "the plan passes the set");
        assert!(none.selected.is_empty() && !one.selected.is_empty());
        assert!(one.selected.len() <= many.selected.len());
        // Each plan keeps what was selected for it, at instants of its own.
        for plan in [&one, &many] {
            let s = only(plan);
            for i in 0..=5000 {
                let t = s.time * f64::from(i) / 5000.0;
                let w = s.trajectory.wrench(&model.vehicle, &model.environment(), &s.trajectory.at(t));
                assert!(plan.selected.iter().all(|row| row.violation(&w) <= 2e-4), "{t}");
            }
        }
        // The last plan violates nothing at any instant.
        assert!(only(&many).outside[0].violated.is_empty(), "{:?}", only(&many).outside[0]);
    }
}
