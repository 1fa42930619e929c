//! Ways out after a fault: each one found against what a way out is, closed forms, and the command.

use crate::cli::mavc_in;
use crate::vehicles::{limit, lost, mission, octocopter, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::model::{
    FaultMode, LandingSite, LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem, Recovery,
    RotorState,
};
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::planner::selection::PlanningSet;
use mavc::planner::selection::sets::of_one_mode;
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use mavc::recovery::carry::{carry, quiet};
use mavc::recovery::replanning::replanned;
use mavc::recovery::{FoundBranch, ModeRecovery, Way, recovery};
use mavc::source::Span;
use nalgebra::Vector3;

fn planned(model: &Model) -> Trajectory {
    let comparison = run_planners(Problem::of(model).unwrap(), Scope::Plan, None);
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(plan) => plan.trajectory.clone(),
        other => panic!("{other:?}"),
    }
}

fn site(at: [f64; 3], radius: f64) -> LandingSite {
    LandingSite { name: "pad".into(), at, radius, span: Span::default() }
}

/// An octocopter that loses rotor 1 on its way over two legs, with a site beside them.
fn over_a_site(wrench: PlanModel) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[1])];
    let points = [[0.0, 0.0, 4.0], [12.0, 0.0, 8.0], [12.0, 8.0, 5.0]].map(|p| waypoint(p, 0.0));
    let limits = vec![limit(LimitKind::Speed, 6.0), limit(LimitKind::Descent, 3.0)];
    let mut flown = Mission { limits, ground: Some(0.0), ..mission(points.to_vec()) };
    flown.after_fault.sites = vec![site([6.0, 4.0, 0.0], 1.5)];
    model.mission = Some(flown);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = wrench;
    model.plan.samples = 40;
    model.plan.reserve = 0.1;
    model.plan.time = MissionTime::Fixed(8.0);
    model.plan.recovery.detection = [0.1, 0.1];
    model.plan.recovery.within = 20.0;
    model
}

/// The direction of the thrust of a motion in still air.
fn thrust(state: &NodeState, gravity: f64) -> Vector3<f64> {
    Vector3::new(state[X][2], state[Y][2], state[Z][2] + gravity).normalize()
}

/// A branch begins where the fault left the vehicle, stays inside the set and the limits, and ends on the site, at rest
/// near the fault, or in the plan. Evaluated at instants of its own.
fn is_a_way_out(model: &Model, set: &PlanningSet, plan: &Trajectory, branch: &FoundBranch) {
    let FoundBranch { way, fault_at, delay, motion, .. } = branch;
    let carried = carry(model, &quiet(model), plan, branch.mode, *fault_at, *delay).expect("it does not turn over");
    let begin = motion.at(0.0);
    for axis in [X, Y, Z, YAW] {
        for (order, (is, due)) in begin[axis].iter().zip(&carried.state[axis]).take(2).enumerate() {
            assert!((is - due).abs() < 1e-4, "{axis} {order}: {is}, {due}");
        }
    }
    if motion.model == mavc::motion::wrench_model::WrenchModel::Exact {
        let apart = (thrust(&begin, model.gravity) - thrust(&carried.state, model.gravity)).norm();
        assert!(apart < 1e-4, "the attitude jumps by {apart}");
    }
    let environment = model.environment();
    let steps = 37 * motion.intervals();
    let mission = model.mission.as_ref().unwrap();
    let speed = |s: &NodeState| [X, Y, Z].map(|axis| s[axis][1].powi(2)).iter().sum::<f64>().sqrt();
    for i in 0..=steps {
        let state = motion.at(motion.duration() * i as f64 / steps as f64);
        let wrench = motion.wrench(&model.vehicle, &environment, &state);
        for row in &set.rows {
            let over = row.violation(&wrench);
            assert!(over <= 1e-4, "{way:?} from {fault_at} s, {i} of {steps}: {over}");
        }
        assert!(speed(&state) <= 6.0f64.max(speed(&carried.state)) + 1e-2, "{} m/s", speed(&state));
        assert!(state[Z][0] >= -1e-3, "below the ground: {}", state[Z][0]);
    }
    let end = motion.nodes.last().unwrap();
    match way {
        Way::Continue | Way::ContinueSpinning => {
            let joined = plan.at(fault_at + delay + motion.duration());
            for axis in [X, Y, Z, YAW] {
                assert!((end[axis][0] - joined[axis][0]).abs() < 1e-4 && (end[axis][1] - joined[axis][1]).abs() < 1e-3);
            }
        }
        Way::LandAt(_) | Way::LandHere | Way::Caught => {
            assert!(speed(end) < 1e-4 && (0.0..0.03).contains(&(end[Z][0] + 1e-3)), "{end:?}");
            assert!(motion.duration() <= model.plan.recovery.within + 1e-9);
        }
    }
    if let Way::LandAt(index) = way {
        let site = &mission.after_fault.sites[*index];
        let aside = (end[X][0] - site.at[0]).hypot(end[Y][0] - site.at[1]);
        assert!(aside <= site.radius + 1e-3, "{aside} m from the middle of the site");
    }
}

fn finds_ways_out(wrench: PlanModel, orders: &[Recovery]) {
    let mut model = over_a_site(wrench);
    let plan = planned(&model);
    let healthy = AdmissibleSet::healthy(&model);
    let (set, _) = of_one_mode(&model, 0, &healthy);
    for order in orders {
        model.plan.recovery.order = vec![*order];
        let found = recovery(Problem::of(&model).unwrap(), &plan, false);
        println!("{wrench:?} {order:?}: {:?}", found.modes[0].pieces);
        assert!(found.branches.len() > 4, "{order:?}: {} branches", found.branches.len());
        found.branches.iter().for_each(|branch| is_a_way_out(&model, &set, &plan, branch));
    }
}

/// To the ground the search is the same at a site and where the vehicle comes to rest.
#[test]
#[ignore = "long"]
fn what_is_found_is_a_way_out() {
    finds_ways_out(PlanModel::Exact, &[Recovery::Continue, Recovery::LandAtSites]);
}

#[test]
fn what_is_found_in_the_hover_model_is_a_way_out() {
    finds_ways_out(PlanModel::Hover, &[Recovery::Continue, Recovery::LandAtSites, Recovery::LandHere]);
}

/// What is left of each rotor.
const LEFT: f64 = 0.4;

/// Without torques the remaining thrust brakes at `a = T/m - g`: where a descent at v is nearer to the ground than
/// `v^2/(2 a)`, nothing can be done, and well before there is.
#[test]
fn a_descent_that_cannot_be_braked_has_no_way_out() {
    some_descents_cannot_be_braked(PlanModel::Hover);
}

fn some_descents_cannot_be_braked(wrench: PlanModel) {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![FaultMode { rotors: vec![RotorState::Reduced(LEFT); 8], ..lost(&model, &[]) }];
    let points = vec![waypoint([0.0, 0.0, 40.0], 0.0), waypoint([0.0, 0.0, 1.0], 0.0)];
    model.mission = Some(Mission { ground: Some(0.0), ..mission(points) });
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = wrench;
    model.plan.samples = 40;
    model.plan.time = MissionTime::Fixed(6.0);
    model.plan.recovery.detection = [0.05, 0.05];
    model.plan.recovery.order = vec![Recovery::LandHere];
    let plan = planned(&model);
    let vehicle = &model.vehicle;
    let thrust: f64 = vehicle.rotors.iter().map(|r| LEFT * r.max_thrust()).sum();
    let brakes = thrust / vehicle.mass - model.gravity;
    assert!(brakes > 0.5, "{brakes}");
    // The height that is needed over the one that there is, where the fault becomes known.
    let share = |at: f64| {
        let state = carry(&model, &quiet(&model), &plan, 0, at, 0.05).unwrap().state;
        let down = (-state[Z][1]).max(0.0);
        down * down / (2.0 * brakes) / state[Z][0]
    };
    let found = recovery(Problem::of(&model).unwrap(), &plan, false);
    println!("{wrench:?}: {:?}", found.modes[0].pieces);
    let (mut hopeless, mut easy) = (0, 0);
    for k in 0..=60 {
        let at = plan.duration() * f64::from(k) / 60.0;
        let has_one = |piece: &&mavc::recovery::Piece| piece.from <= at && at <= piece.to;
        let way = found.modes[0].pieces.iter().find(has_one).and_then(|piece| piece.way);
        if share(at) > 1.0 {
            hopeless += 1;
            assert_eq!(way, None, "{wrench:?}: {at} s needs {} of the height", share(at));
        }
        if share(at) < 0.4 && at < 2.0 {
            easy += 1;
            assert_eq!(way, Some(Way::LandHere), "{wrench:?}: {at} s needs {} of the height", share(at));
        }
    }
    assert!(hopeless > 5 && easy > 5, "{hopeless} {easy}");
}

/// A site that cannot be reached in the time is none; with more time it is one; its near miss says so.
#[test]
fn a_site_out_of_reach_is_no_way_out() {
    let mut model = over_a_site(PlanModel::Hover);
    let mission = model.mission.as_mut().unwrap();
    mission.after_fault.sites = vec![site([60.0, 0.0, 0.0], 1.0)];
    model.plan.recovery.order = vec![Recovery::LandAtSites];
    let plan = planned(&model);
    let mut before = f64::INFINITY;
    // At 6 m/s, 48 m take 8 s.
    for (within, reached) in [(7.5, false), (16.0, true), (30.0, true)] {
        model.plan.recovery.within = within;
        let found = recovery(Problem::of(&model).unwrap(), &plan, false);
        let open = found.modes[0].uncovered();
        println!("within {within} s: {open} s open, {:?}", found.modes[0].pieces);
        assert!(open <= before, "more time leaves more open");
        assert_eq!(found.branches.is_empty(), !reached);
        if !reached {
            let miss = found.modes[0].pieces[0].near_miss.expect("the site can be reached");
            assert!(miss.site == 0 && miss.takes > within, "{miss:?}");
        }
        before = open;
    }
}

/// A plan that stays inside the set of the fault is flown on from every instant.
#[test]
fn after_rcp_every_fault_is_flown_through() {
    let mut model = over_a_site(PlanModel::Hover);
    model.plan.against = vec![0];
    model.plan.planner = PlannerKind::Rcp;
    model.plan.recovery.detection = [0.02, 0.05];
    let plan = planned(&model);
    let found = recovery(Problem::of(&model).unwrap(), &plan, false);
    let [piece] = &found.modes[0].pieces[..] else { panic!("{:?}", found.modes[0].pieces) };
    assert_eq!((piece.from, piece.to, piece.way), (0.0, plan.duration(), Some(Way::Continue)));
}

const SPEC: &str = "
vehicle octo {
    layout  = \"PPNNPPNN\"
    arm     = 21 cm
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.5 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults {
    mode M1 { rotor 1 lost }
    mode M4 { rotor 4 lost }
    mode M6 { rotor 6 lost }
}
mission field {
    ground = 0 m
    start at [0, 0, 4] m
    waypoint at [30, 0, 10] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [10, 6, 0] m; radius = 2 m }
    keep_off road { shape = box; from = [-50, -4] m; to = [50, 3] m }
}
plan {
    model   = hover
    against = [M1]
    time    = 9 s
    samples = 40
    recovery { order = [land_at_sites]; detection = 100 ms; within = 12 s }
";

#[test]
fn the_command_shows_ways_out_and_writes_them() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("field.mav"), format!("{SPEC}}}")).unwrap();
    let args = ["plan", "field.mav", "--branches", "out", "--report", "report.json"];
    let (code, text, errors) = mavc_in(folder.path(), &args);
    assert_eq!(code, 0, "{errors}");
    assert!(text.contains("AFTER A FAULT known after 100 ms"), "{text}");
    assert!(text.lines().count() <= 25 && text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let report: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("report.json")).unwrap()).unwrap();
    let recovery = &report["recovery"];
    assert_eq!(recovery["basis"], "checked at instants");
    let modes = recovery["modes"].as_array().unwrap();
    assert_eq!(modes.len(), 3);
    let index = std::fs::read_to_string(folder.path().join("out/index.csv")).unwrap();
    let mut listed = 0;
    for piece in modes.iter().flat_map(|mode| mode["pieces"].as_array().unwrap()) {
        for branch in piece["branches"].as_array().unwrap() {
            let name = branch.as_str().unwrap();
            assert!(index.contains(name) && folder.path().join("out").join(name).is_file(), "{name}");
            listed += 1;
        }
    }
    assert!(listed > 8 && index.lines().count() == listed + 1, "{listed}\n{index}");
    // Landings prefer the middle of the site.
    for line in index.lines().skip(1) {
        let name = line.split(',').next().unwrap();
        let table = std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        let last: Vec<f64> = table.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
        assert!((last[1] - 10.0).hypot(last[2] - 6.0) < 0.1, "{name} ends at {last:?}");
    }
}

/// A simulated flight takes the first way out of the order: down on the site, or back to the plan; it flies on where
/// none is found, or where the fault is not known.
#[test]
fn a_flight_takes_the_way_out() {
    let flown = |order: &str, within: &str, detection: &str| {
        let folder = tempfile::tempdir().unwrap();
        let spec = SPEC.replace("order = [land_at_sites]", &format!("order = [{order}]")).replace("12 s", within);
        let simulate = format!("simulate {{ fault M1 at 3 s; detection = {detection}; after_fault = recovery }}");
        std::fs::write(folder.path().join("field.mav"), format!("{spec}}}\n{simulate}")).unwrap();
        let args = ["simulate", "field.mav", "--report", "r.json", "-o", "log.csv"];
        let (code, text, errors) = mavc_in(folder.path(), &args);
        assert_eq!(code, 0, "{text}{errors}");
        let report: serde_json::Value =
            serde_json::from_slice(&std::fs::read(folder.path().join("r.json")).unwrap()).unwrap();
        crate::schemas::schema("simulate").assert_valid(&report);
        let log = std::fs::read_to_string(folder.path().join("log.csv")).unwrap();
        let row = |line: &str| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>();
        (report, row(log.lines().last().unwrap()), text)
    };
    let (landed, last, text) = flown("land_at_sites", "12 s", "100 ms");
    assert_eq!(landed["outcome"]["status"], "landed", "{landed}");
    assert_eq!(landed["way_out"]["way"], "landing at pad");
    // In the middle of the site, which has a radius of 2 m.
    assert!((last[1] - 10.0).hypot(last[2] - 6.0) < 0.5 && last[3] < 0.05, "{last:?}");
    assert!(text.contains("way out from 3.10 s: landing at pad"), "{text}");
    let (back, last, _) = flown("continue", "12 s", "100 ms");
    assert_eq!(
        (&back["outcome"]["status"], &back["way_out"]["way"]),
        (&"flown".into(), &"back to the plan and along it".into())
    );
    assert!((last[1] - 30.0).abs() < 0.5, "{last:?}");
    let (none, _, text) = flown("land_at_sites", "2 s", "100 ms");
    assert!(none["way_out"]["way"].is_null() && text.contains("no way out was found at 3.10 s"), "{text}");
    let (unknown, ..) = flown("land_at_sites", "12 s", "never");
    assert!(unknown.get("way_out").is_none());
    // The estimator needs some time, and the way out begins when it has it.
    let (estimated, ..) = flown("land_at_sites", "12 s", "estimator");
    let at = estimated["way_out"]["at_s"].as_f64().unwrap();
    assert!(at > 3.0 && at < 4.0 && estimated["outcome"]["status"] == "landed", "{estimated}");
}

/// A mission whose faults have no way out at some instants, with a requirement in its `plan`.
pub fn with_gaps(require: &str) -> String {
    let spec = SPEC.replace("time    = 9 s", "time    = 6.5 s").replace("within = 12 s", "within = 4 s");
    let spec = spec.replace("order = [land_at_sites]", "order = [continue]");
    let spec = spec.replace("    mode M4 { rotor 4 lost }\n    mode M6 { rotor 6 lost }\n", "");
    format!("{spec}{require}\n}}")
}

/// A mission whose faults have no way out at some instants is planned again with more room, until they have.
#[test]
fn gaps_are_closed_by_planning_again() {
    let planned = |require: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("field.mav"), with_gaps(require)).unwrap();
        let args = ["plan", "field.mav", "--recovery", "--report", "r.json", "--certificate", "c.json"];
        let (code, text, errors) = mavc_in(folder.path(), &args);
        assert_eq!(code, 0, "{text}{errors}");
        // The plan is one of the spec.
        let (code, _, errors) = mavc_in(folder.path(), &["verify", "c.json", "field.mav", "--budget", "100s"]);
        assert!(code == 0 || code == 7, "{errors}");
        let report = std::fs::read(folder.path().join("r.json")).unwrap();
        let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
        crate::schemas::schema("report").assert_valid(&report);
        (report["recovery"].clone(), text)
    };
    let (open, text) = planned("");
    assert!(open["uncovered"].as_f64().unwrap() > 0.01 && open["replanned"].is_null(), "{text}");
    let (closed, text) = planned("    require uncovered <= 0 %");
    assert_eq!(
        (closed["uncovered"].as_f64(), closed["replanned"]["price_s"].as_f64()),
        (Some(0.0), Some(0.0)),
        "{text}"
    );
    assert_eq!(closed["replanned"]["uncovered_before"], open["uncovered"]);
    let text = crate::cli::flat(&text);
    assert!(text.contains("Planned again for ways out, with ") && text.contains("the time is the same"), "{text}");
}

/// A mode that cannot hover has no way out along any plan: with it planning again ends where all others have one.
#[test]
fn planning_again_ends_where_only_modes_that_cannot_hover_are_left() {
    let spec = with_gaps("").replace("faults {", "faults {\n    mode none { rotors [1, 2, 3, 4, 5, 6, 7, 8] lost }");
    let spec = mavc::compile(&spec).into_result().unwrap();
    let problem = Problem::of(spec.model()).unwrap();
    let first = run_planners(problem, Scope::Plan, None);
    let plan = first.runs.last().unwrap().outcome.plan().unwrap();
    let found = recovery(problem, &plan.trajectory, false);
    let uncovered = |found: &mavc::recovery::Recovery| {
        let all = found.duration * found.modes.len() as f64;
        found.modes.iter().map(ModeRecovery::uncovered).sum::<f64>() / all
    };
    let least = 1.0 / found.modes.len() as f64;
    assert!(uncovered(&found) > least + 0.01, "{}", uncovered(&found));
    let tried = std::cell::Cell::new(0);
    let again = replanned(problem, &first, &found, &uncovered, 0.0, &|_, _| tried.set(tried.get() + 1));
    let left = uncovered(&again.replanned.unwrap().recovery);
    assert!((left - least).abs() < 1e-9 && tried.get() <= 4, "{left} of {least} after {} plans", tried.get());
}

/// If a fixed time leaves no room for ways out, the screen names a longer time that does; the plan stays as it is.
#[test]
fn a_fixed_time_that_is_too_short_has_a_nearest_miss() {
    let folder = tempfile::tempdir().unwrap();
    let spec = with_gaps("    require uncovered <= 0 %").replace("time    = 6.5 s", "time    = 5.8 s");
    std::fs::write(folder.path().join("field.mav"), spec).unwrap();
    let (code, text, errors) = mavc_in(folder.path(), &["plan", "field.mav", "--report", "r.json"]);
    assert_eq!(code, 4, "{text}{errors}");
    let report = std::fs::read(folder.path().join("r.json")).unwrap();
    let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
    crate::schemas::schema("report").assert_valid(&report);
    let found = &report["recovery"];
    let longer = &found["longer"];
    assert_eq!(report["planners"][0]["time_s"], 5.8);
    assert!(longer["time_s"].as_f64().unwrap() > 5.8, "{text}");
    assert!(longer["uncovered"].as_f64().unwrap() < found["uncovered"].as_f64().unwrap(), "{text}");
    assert!(crate::cli::flat(&text).contains("s instead of 5.8 s and leaves"), "{text}");
}

/// A comparison has a row for the plan with ways out, the one of `mavc plan`; without the requirement it says that none
/// was attempted.
#[test]
fn a_comparison_has_the_price_of_ways_out() {
    let compared = |command: &str, require: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("field.mav"), with_gaps(require)).unwrap();
        let (code, text, errors) =
            mavc_in(folder.path(), &[command, "field.mav", "--report", "r.json", "--html", "p.html"]);
        assert_eq!(code, 0, "{text}{errors}");
        let report = std::fs::read(folder.path().join("r.json")).unwrap();
        let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
        crate::schemas::schema("report").assert_valid(&report);
        let page = std::fs::read_to_string(folder.path().join("p.html")).unwrap();
        (report, crate::cli::flat(&text), page)
    };
    let require = "    require uncovered <= 0 %";
    let (report, text, page) = compared("compare", require);
    let (planned, ..) = compared("plan", require);
    let row = &report["recoverable"];
    assert_eq!(row["time_s"], planned["planners"][0]["time_s"], "{row}");
    for field in ["required", "uncovered", "replanned"] {
        assert_eq!(row[field], planned["recovery"][field], "{row}");
    }
    assert!(row["verdict"] == "found" && row["replanned"]["price_s"] == 0.0, "{row}");
    let title = "With ways out after faults, `require uncovered <= 0 %`";
    assert!(text.contains(title) && text.contains("the same time"), "{text}");
    assert!(page.contains("With ways out after faults"), "the page has no row");
    let (report, text, page) = compared("compare", "");
    assert!(report.get("recoverable").is_none() && !text.contains(title), "{text}");
    let words = "Ways out after faults: not sought";
    assert!(page.contains(words), "the page does not say that none was sought");
}

/// On a map: the ground projections of ways out, landing sites as polygons and as rally points of a ground station.
#[test]
fn ways_out_and_sites_are_on_the_map() {
    let folder = tempfile::tempdir().unwrap();
    let place = "mission field {\n    origin_latitude = 47 deg; origin_longitude = 8 deg; origin_altitude = 400 m\n";
    let text = format!("{SPEC}}}").replace("mission field {\n", place);
    std::fs::write(folder.path().join("field.mav"), text).unwrap();
    let json = |name: &str| -> serde_json::Value {
        serde_json::from_slice(&std::fs::read(folder.path().join(name)).unwrap()).unwrap()
    };
    // A metre north and east, by the ellipsoid's radii of curvature at 47 degrees.
    let metres = |place: &serde_json::Value| {
        let [longitude, latitude] = [0, 1].map(|i| place[i].as_f64().unwrap());
        [(longitude - 8.0) * 76_060.0, (latitude - 47.0) * 111_170.0]
    };
    let args = ["plan", "field.mav", "--branches", "out", "-o", "field.plan"];
    let (code, _, errors) = mavc_in(folder.path(), &args);
    assert_eq!(code, 0, "{errors}");
    let lines = json("out/footprints.geojson");
    let lines = lines["features"].as_array().unwrap();
    assert!(lines.len() > 8);
    for line in lines {
        let corners = line["geometry"]["coordinates"].as_array().unwrap();
        let ([x, y], [end_x, end_y]) = (metres(&corners[0]), metres(&corners[corners.len() - 1]));
        assert!((-0.5..=30.5).contains(&x) && y.abs() < 1.0, "the plan goes east: {x} {y}");
        assert!((end_x - 10.0).hypot(end_y - 6.0) < 2.01, "{end_x} {end_y}");
        assert!(folder.path().join("out").join(line["properties"]["file"].as_str().unwrap()).is_file());
    }
    let point = &json("field.plan")["rallyPoints"]["points"][0];
    let [x, y] = metres(&serde_json::json!([point[1], point[0]]));
    assert!((x - 10.0).abs() < 0.01 && (y - 6.0).abs() < 0.01 && point[2] == 10.0, "{point}");
    // The mission that it is imports as the same site.
    let (code, _, errors) = mavc_in(folder.path(), &["import", "mission", "field.plan", "-o", "again.mav"]);
    let again = std::fs::read_to_string(folder.path().join("again.mav")).unwrap();
    assert!(code == 0 && again.contains("landing_site"), "{errors}{again}");
    let (code, _, errors) = mavc_in(folder.path(), &["plan", "field.mav", "-o", "map.geojson"]);
    assert_eq!(code, 0, "{errors}");
    let map = json("map.geojson");
    for (kind, corners) in [("landing_site", 37), ("keep_off", 5)] {
        let found = map["features"].as_array().unwrap().iter().find(|f| f["properties"]["kind"] == kind).unwrap();
        assert_eq!(found["geometry"]["coordinates"][0].as_array().unwrap().len(), corners, "{found}");
    }
}

/// With a bound that is not met the plan and its gaps are written, and the exit code says so.
#[test]
fn a_bound_on_what_is_uncovered_decides_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    for (bound, expected) in [("99 %", 4), ("100 %", 0)] {
        std::fs::write(folder.path().join("field.mav"), format!("{SPEC}    require uncovered <= {bound}\n}}")).unwrap();
        let args = ["plan", "field.mav", "-o", "plan.csv", "--set", "plan.recovery.within=4s"];
        let (code, text, errors) = mavc_in(folder.path(), &args);
        assert_eq!(code, expected, "{text}{errors}");
        assert!(text.contains("none found") && folder.path().join("plan.csv").is_file(), "{text}");
    }
}

/// A hexacopter PNPNPN that loses a rotor loses yaw too. After 0.1 to 0.2 s it is brought back to the plan while it
/// begins to spin, and simulated flights follow every branch.
#[test]
fn a_vehicle_that_begins_to_spin_flies_on() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("hexa.mav"), SPINNING).unwrap();
    let (code, text, errors) = mavc_in(folder.path(), &["plan", "hexa.mav", "--recovery", "--report", "-"]);
    assert_eq!(code, 0, "{text}{errors}");
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    let recovery = &report["recovery"];
    assert_eq!(recovery["uncovered"], 0.0, "{recovery}");
    let pieces = recovery["modes"].as_array().unwrap().iter().flat_map(|mode| mode["pieces"].as_array().unwrap());
    pieces.for_each(|piece| assert_eq!(piece["outcome"], "continue spinning", "{piece}"));
    assert!(recovery["flown"].as_u64().unwrap() > 8 && recovery["flown"] == recovery["survived"], "{recovery}");
}

const SPINNING: &str = r#"
vehicle hexa {
    layout = "PNPNPN"; arm = 0.3 m; mass = 2.4 kg; inertia = [0.041, 0.044, 0.078] kg*m^2
    yaw_drag = 4e-3 N*m*s/rad +- 50 %; propeller_radius = 13 cm
    rotor { max_thrust = 10.5 N; torque_per_thrust = 16 mm; max_speed = 7400 rpm }
}
faults { mode L1 { rotor 1 lost }; mode L4 { rotor 4 lost } }
mission hop {
    ground = 0 m
    start at [0, 0, 10] m  yaw 0 deg
    waypoint there at [4, 0, 11] m
}
plan {
    planner = rcp; against = all; without_yaw = where_needed; reserve = 10 %; time = 4 s; samples = 24
    recovery { order = [continue]; detection = 100 ms .. 200 ms }
}
"#;

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_descent_that_cannot_be_braked_has_no_way_out_in_the_exact_model() {
        some_descents_cannot_be_braked(PlanModel::Exact);
    }

    /// Of `docs/how-to/recovery.md`: planned again, the README's mission has a way out everywhere, and takes no longer.
    #[test]
    #[ignore = "four searches for ways out, minutes each"]
    fn the_mission_of_the_readme_has_ways_out_everywhere() {
        let text = include_str!("../../examples/roof_octo.mav");
        let required = text.replace("samples = 100 }", "samples = 100; require uncovered <= 0 % }");
        assert_ne!(required, text);
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("roof.mav"), required).unwrap();
        let (code, text, errors) = mavc_in(folder.path(), &["plan", "roof.mav"]);
        assert_eq!(code, 0, "{text}{errors}");
        let text = crate::cli::flat(&text);
        assert!(text.contains("PLAN FOUND, 20 s") && text.contains("the time is the same"), "{text}");
    }
}
