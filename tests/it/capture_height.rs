//! `require capture_height`: the height that a fault without control of yaw costs, kept by plans.

use crate::cli::flat;
use crate::schemas::{assert_strict, schema};
use mavc::certificate::Certificate;
use mavc::flight::capture::Capture;
use mavc::flight::capture::heights::CaptureHeights;
use mavc::flight::{Outcome, Sortie, fly};
use mavc::model::{AfterFault, Detection, DistanceFrom, LimitKind, Strike};
use mavc::observer::Silent;
use mavc::report::page::{self, Beside, PageKind, Subject};
use mavc::{Planning, Refusal, Spec, Task};

/// A quadcopter that may lose rotor 1, and a mission over a yard; `{ground}`, `{up}` and `{require}` are filled in.
fn text(ground: &str, waypoints: &str, plan: &str) -> String {
    format!(
        "vehicle quad {{
    layout = \"PNPN\"; first = 45 deg; arm = 23 cm; mass = 1.9 kg
    inertia = [0.018, 0.018, 0.033] kg*m^2
    yaw_drag = 5e-3 N*m*s/rad
    rotor {{ max_thrust = 11 N; torque_per_thrust = 15 mm; max_speed = 8000 rpm; time_constant = 20 ms }}
}}
faults {{ mode L {{ rotor 1 lost }} }}
mission yard {{
    {ground}
    start at [0, 0, 2] m
    {waypoints}
    limits {{ speed <= 5 m/s }}
}}
plan {{ against = []; time = 16 s; samples = 40; {plan} }}
"
    )
}

const OVER: &str = "waypoint at [0, 0, 12] m; waypoint at [15, 0, 12] m; waypoint at [15, 0, 3] m";
const REQUIRED: &str = "require capture_height { radius = 4 m; detection = 100 ms }";

fn spec(text: &str) -> Spec {
    mavc::compile(text).into_result().unwrap()
}

fn planned(spec: &Spec) -> Planning {
    let planning = mavc::plan(spec).unwrap();
    assert!(planning.plan().is_some(), "{:?}", planning.outcome());
    planning
}

fn refusal(text: &str) -> Refusal {
    mavc::plan(&spec(text)).unwrap_err()
}

#[test]
fn plans_of_both_models_keep_the_height_and_a_flight_in_it_survives() {
    for model in ["", "; model = hover"] {
        let spec = spec(&text("ground = 0 m", OVER, &format!("{REQUIRED}{model}")));
        let planning = planned(&spec);
        let plan = planning.plan().unwrap();
        // The height is what the flights themselves lose at 0 and 5 m/s: 5.6 and 5.9 m in `mavc analyze --capture`.
        let needed = CaptureHeights::simulate(spec.model(), 0.1, 5.0, 1).unwrap();
        let height = needed.greatest();
        assert!((5.8..6.0).contains(&height), "{height}");
        // Everywhere on the plan: near start or end, or high enough.
        let end = plan.time;
        for k in 0..=1600 {
            let state = plan.trajectory.at(end * k as f64 / 1600.0);
            let [x, y, z] = [state[0][0], state[1][0], state[2][0]];
            let near = x.hypot(y).min((x - 15.0).hypot(y)) <= 4.0 + 1e-3;
            assert!(near || z >= height - 1e-3, "{model}: [{x}, {y}, {z}], {height}");
        }
        let certificate = mavc::certify(&spec, &planning).unwrap();
        assert_eq!(certificate.capture_height_m, Some(height));
        schema("certificate").assert_valid(&serde_json::to_value(&certificate).unwrap());
        let shown = mavc::verify(&serde_json::to_vec(&certificate).unwrap(), &spec).unwrap();
        assert!(shown.shown.iter().any(|shown| shown.statement == "capture height"), "{:?}", shown.shown);
        assert!(shown.weaker.iter().any(|weaker| weaker.contains("the certificate claims that")), "{:?}", shown.weaker);

        // A flight along the plan that loses the rotor at its fastest.
        let mut flown = spec.model().clone();
        (flown.simulation.detection, flown.simulation.after_fault) = (Detection::After(0.1), AfterFault::Hold);
        flown.simulation.lost_beyond = 30.0;
        let speed = |t: f64| plan.trajectory.at(t)[0][1];
        let fastest = (0..=160).map(|k| end * k as f64 / 160.0).max_by(|a, b| speed(*a).total_cmp(&speed(*b))).unwrap();
        let strikes = [Strike { mode: 0, at: fastest, until: None, span: flown.plan.span, at_span: flown.plan.span }];
        let flight = fly(&Sortie::along(&flown, &plan.trajectory, &strikes, 1), None);
        assert_eq!(flight.outcome, Outcome::Flown, "{model} {fastest}");
    }
}

#[test]
fn certificates_of_another_height_are_decided_by_that_height() {
    let required = spec(&text("ground = 0 m", OVER, REQUIRED));
    let certificate = mavc::certify(&required, &planned(&required)).unwrap();
    let decided = |certificate: &Certificate, spec: &Spec| {
        let text = serde_json::to_vec(certificate).unwrap();
        mavc::verify(&text, spec).map_err(|rejected| rejected.diagnostic.message.clone())
    };
    let with = |height: Option<f64>| Certificate { capture_height_m: height, ..certificate.clone() };
    // The plan passes its waypoints at 12 m: it does not keep 11.9 m on the way, and 12.5 m are above the waypoints.
    let rejected = decided(&with(Some(12.5)), &required).unwrap_err();
    assert!(rejected.contains("the capture height") && rejected.contains("12.5 m above the ground"), "{rejected}");
    for height in [-1.0, 0.0] {
        assert!(decided(&with(Some(height)), &required).unwrap_err().contains("is not a height"));
    }
    let unchecked = decided(&with(None), &required).unwrap();
    assert!(unchecked.weaker.iter().any(|weaker| weaker.contains("is not checked")), "{:?}", unchecked.weaker);
    // A motion that dips below the height is no plan.
    let free = spec(&text("ground = 0 m", "waypoint at [15, 0, 3] m", ""));
    let low = mavc::certify(&free, &planned(&free)).unwrap();
    assert_eq!(low.capture_height_m, None);
    let free_sha = Certificate { capture_height_m: Some(7.0), ..low };
    assert!(decided(&free_sha, &free).unwrap_err().contains("the spec requires none"));
}

#[test]
fn a_dip_below_the_height_is_rejected() {
    let both = |z: f64| {
        format!(
            "waypoint at [0, 0, 12] m; waypoint at [8, 0, {z}] m; waypoint at [15, 0, 12] m; waypoint at [15, 0, 3] m"
        )
    };
    let (high, low) = (spec(&text("ground = 0 m", &both(12.0), REQUIRED)), spec(&text("ground = 0 m", &both(6.0), "")));
    let mut dips = mavc::certify(&low, &planned(&low)).unwrap();
    dips.capture_height_m = Some(7.0);
    dips.spec_sha256 = high.sha256().into();
    // Waypoint tolerances aside, the motion misses the height.
    let settings = mavc::verify::Settings::default();
    let kept = high.model().keeping(7.0).unwrap();
    let mut tolerant = kept.clone();
    tolerant.mission.as_mut().unwrap().waypoints.iter_mut().for_each(|point| point.within = 10.0);
    let refused = mavc::verify::decide(&dips, &tolerant, settings).unwrap_err();
    assert!(refused.sentence().contains("capture height"), "{}", refused.sentence());
}

#[test]
fn waypoints_show_where_the_way_up_ends() {
    let model = spec(&text("ground = 1 m", OVER, REQUIRED)).model().keeping(8.0).unwrap();
    let limits = &model.mission.as_ref().unwrap().limits;
    let of_capture = limits.iter().filter(|limit| limit.name() == "capture height");
    let bounds: Vec<_> = of_capture
        .map(|limit| (limit.kind.clone(), limit.leg.as_ref().unwrap().leg, limit.lower, limit.upper))
        .collect();
    let about = [[0.0, 0.0], [15.0, 0.0]].map(|end| LimitKind::Distance(DistanceFrom::Axis(end)));
    let near = |end: usize, leg| (about[end].clone(), leg, None, Some(4.0));
    assert_eq!(bounds, [(LimitKind::Z, 1, Some(9.0), None), near(0, 0), near(1, 2)]);

    let code = |waypoints: &str| match refusal(&text("ground = 0 m", waypoints, REQUIRED)) {
        Refusal::TooLow(found) => {
            let [error] = &found[..] else { panic!("{found:?}") };
            assert_eq!(error.code, "mavc::plan::capture_low");
            format!("{}\n{}", error.message, error.help.clone().unwrap_or_default())
        }
        other => panic!("{other}"),
    };
    let slope = code("waypoint at [15, 0, 12] m; waypoint at [15, 0, 3] m");
    assert!(slope.contains("no waypoint within 4 m of the start"), "{slope}");
    assert!(slope.contains("add `waypoint at [0, 0, 6] m`") && slope.contains("before it"), "{slope}");
    let down = code("waypoint at [0, 0, 12] m; waypoint at [15, 0, 3] m");
    assert!(down.contains("no waypoint within 4 m of the end") && down.contains("after it"), "{down}");
    let between = "waypoint at [0, 0, 12] m; waypoint at [8, 0, 5.5] m; waypoint at [15, 0, 12] m";
    assert!(code(between).contains("waypoint 3 is 0."), "{}", code(between));
    assert!(code("waypoint at [15, 0, 3] m").contains("no waypoint reaches 5.9"));
}

#[test]
fn where_no_height_is_enough_nothing_is_planned() {
    // With slow and weak rotors the loss is not survived at 5 m/s and 100 ms: `mavc analyze --capture`.
    let slow = text("ground = 0 m", OVER, "require capture_height { detection = 100 ms }");
    let slow = slow.replace("20 ms }", "100 ms }").replace("max_thrust = 11 N", "max_thrust = 9.6 N");
    let Refusal::TooLow(found) = refusal(&slow) else { panic!() };
    assert_eq!(found[0].code, "mavc::plan::capture_unregained");
    assert!(found[0].message.contains("after mode L: with the fault known after 100 ms at 5 m/s, 0 of 5"), "{found:?}");
}

#[test]
fn a_mode_that_keeps_yaw_is_not_concerned() {
    let weak = text("ground = 0 m", "waypoint at [15, 0, 5] m", REQUIRED).replace("1 lost", "1 reduced to 80 %");
    let spec = spec(&weak);
    let task = Task::new(&spec).unwrap();
    assert_eq!(task.remarks().iter().map(|remark| remark.code).collect::<Vec<_>>(), ["mavc::plan::capture_idle"]);
    assert_eq!(task.model().mission, spec.model().mission);
    let found = mavc::check(&spec);
    assert!(found.iter().any(|d| d.code == "mavc::plan::capture_idle"));
}

#[test]
fn reports_tell_when_a_plan_is_lower() {
    let report = |text: &str| {
        let spec = spec(text);
        let task = Task::new(&spec).unwrap();
        let planning = task.plan(&Silent);
        let explained = mavc::Explained::default();
        let text = task.text(&planning, &explained, None);
        (serde_json::to_value(task.report(&planning, &explained, None)).unwrap(), text)
    };
    // At 3 m all the way: too low at every instant.
    let low = "waypoint at [15, 0, 3] m";
    let (record, told) = report(&text("ground = 0 m", low, ""));
    let planner = &record["planners"][0];
    assert!((planner["exposed"][0]["seconds"].as_f64().unwrap() - 16.0).abs() < 1e-9, "{planner}");
    assert_eq!(planner["exposed"][0]["intervals_s"], serde_json::json!([[0.0, 16.0]]));
    let kinds: Vec<&str> =
        planner["warnings"].as_array().unwrap().iter().map(|w| w["kind"].as_str().unwrap()).collect();
    assert!(kinds.contains(&"capture_height"), "{kinds:?}");
    assert!(told.contains("If mode L strikes from 0.00 s to 16.00 s, the plan is too low"), "{told}");
    assert_eq!(record["capture_height"]["delay_s"], 0.1);

    // With the statement: the seconds of the way up and down remain, without a warning.
    let (record, told) = report(&text("ground = 0 m", OVER, REQUIRED));
    let planner = &record["planners"][0];
    let intervals = planner["exposed"][0]["intervals_s"].as_array().unwrap();
    assert_eq!((intervals.len(), planner["warnings"].as_array().unwrap().len()), (2, 0), "{planner}");
    assert_eq!((intervals[0][0].as_f64(), intervals[1][1].as_f64()), (Some(0.0), Some(16.0)));
    assert!(flat(&told).contains("m above the ground outside 4 m of start and end"), "{told}");
    assert!(!told.contains("too low"), "{told}");
    assert_eq!(record["capture_height"]["radius_m"], 4.0);
    let of_report = schema("report");
    of_report.assert_valid(&record);
    assert_strict(&of_report, &record, &["capture_height", "exposed", "height_m", "radius_m"]);

    // Without a ground nothing is simulated, and nothing told.
    let (record, told) = report(&text("", low, ""));
    assert!(record.get("capture_height").is_none() && record["planners"][0].get("exposed").is_none());
    assert!(!told.contains("level flight"), "{told}");
}

#[test]
fn the_page_draws_heights_over_delays() {
    let spec = spec(&text("ground = 0 m", OVER, &format!("{REQUIRED}; model = hover")));
    let task = Task::new(&spec).unwrap();
    let planning = task.plan(&Silent);
    let record = task.report(&planning, &mavc::Explained::default(), None);
    let case = |speed: f64, delay: f64, regained: usize| Capture {
        mode: "L".into(),
        lag_s: 0.02,
        speed_m_per_s: speed,
        delay_s: delay,
        flights: 5,
        regained,
        settled_rate_rad_s: Some(20.0),
        height_m: Some([20.0 * delay, 30.0 * delay, 40.0 * delay]),
        drift_m: None,
    };
    let at = |speed: f64, regained: [usize; 5]| {
        (1_u8..).zip(regained).map(move |(k, n)| case(speed, 0.05 * f64::from(k), n))
    };
    // At 5 m/s not all flights regain level flight after 150 ms: the line has a gap there.
    let curves: Vec<Capture> = at(0.0, [5; 5]).chain(at(5.0, [5, 5, 4, 5, 5])).collect();
    let subject = Subject { problem: task.problem(), sources: spec.sources(), diagnostics: &[] };
    let page = page::plans(
        PageKind::Plan,
        &subject,
        planning.comparison(),
        &record,
        Beside { captures: &curves, recovery: None },
    );
    let (_, section) = page.split_once("<section id=\"capture\">").unwrap();
    let (section, _) = section.split_once("</section>").unwrap();
    let lines: Vec<usize> = section
        .split("<polyline points=\"")
        .skip(1)
        .map(|rest| rest.split_once('"').unwrap().0.split(' ').count())
        .collect();
    assert_eq!(lines, [5, 2, 2]);
    // Heights of 30 m a second of delay up to 7.5 m at 0.25 s, on a scale to 10 m: 75 % of the way from 0 (y = 284) to
    // 10 m (14).
    assert!(section.contains("546.0,81.5"), "{section}");
    assert!(section.contains("Simulated: the median of 5 flights") && section.contains("L</th>"));
    let without = page::plans(PageKind::Plan, &subject, planning.comparison(), &record, Beside::default());
    assert!(without.contains("Table of heights") && !without.contains("<polyline"));
}

#[test]
fn flights_have_the_ground_of_the_mission() {
    let of = |ground: &str, simulate: &str| spec(&(text(ground, OVER, "") + simulate)).model().simulation.ground;
    assert_eq!(of("", ""), 0.0);
    assert_eq!(of("ground = -3 m", ""), -3.0);
    assert_eq!(of("ground = -3 m", "simulate { seed = 2 }"), -3.0);
    assert_eq!(of("ground = -3 m", "simulate { ground = 1 m }"), 1.0);
    // The delay of the flights is that of the statement, unless it has its own.
    let delay = |require: &str| {
        let text = text("ground = 0 m", OVER, require) + "simulate { detection = 30 ms }";
        spec(&text).model().plan.require_capture.unwrap().delay
    };
    assert_eq!((delay("require capture_height { }"), delay(REQUIRED)), (0.03, 0.1));
}
