//! What reports say to people: what times are, what is said once, what `--quiet` keeps.

use super::*;

/// An octocopter on a short way against two losses.
const TURN: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }
}
faults { every 1 rotor lost as M { rate = 1e-5 1/h } }
mission turn {
    start at [0, 0, 2] m
    waypoint at [3, 1, 3] m
    waypoint at [5, 0, 2] m
}
plan { model = hover; timing = proportional; planner = rsp; against = [M1, M2]; time = 9 s; samples = 20; reserve = 0 % }
"#;

fn compared(set: &[&str]) -> String {
    let mut args = vec!["compare", "-v", "-"];
    set.iter().for_each(|set| args.extend(["--set", set]));
    let ran = mavc_with(&args, TURN);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    out(&ran)
}

#[test]
fn comparisons_say_what_their_times_are() {
    let text = compared(&[]);
    let said = flat(&text);
    assert!(said.contains("The spec requires 9 s; these times were searched for in addition"), "{text}");
    assert!(said.contains("RSP's shortest time is for the facets selected at RCP's shortest time."), "{text}");
    assert!(said.contains("All planners at the common time T_d = 9 s, the time that the spec requires"), "{text}");
    // No table of the paper's is one of this mission.
    assert!(!said.contains("Table"), "{text}");

    let free = flat(&compared(&["plan.time=minimum"]));
    assert!(!free.contains("The spec requires") && free.contains("RSP uses the facets selected at T_d"), "{free}");
    assert!(free.contains("the shortest time of RCP against all modes jointly"), "{free}");
    let alone = flat(&compared(&["plan.time=minimum", "plan.against=[M1]"]));
    assert!(alone.contains(", RCP's shortest time planner"), "{alone}");

    let due = TURN.replace("[5, 0, 2] m", "[5, 0, 2] m  time 9 s").replace("time = 9 s;", "");
    let ran = mavc_with(&["compare", "-v", "-"], &due);
    let said = flat(&out(&ran));
    assert!(said.contains("at the only time that the mission's fixed times allow"), "{said}");
    assert!(said.contains("T_d = 9 s, the time that the mission's fixed times give"), "{said}");
    assert!(!said.contains("requires"), "{said}");
}

/// A plan that is unsafe after a mode in `against` is found all the same, unless the user denies it; RSP's says what
/// covers all modes.
#[test]
fn unsafe_plans_can_be_denied() {
    let plan = |planner: &str, more: &[&str]| {
        let planner = format!("plan.planner={planner}");
        let args = [&["plan", "-", "--set", "plan.time=minimum", "--set", &planner, "-o", "-"], more].concat();
        mavc_with(&args, TURN)
    };
    let ignored = plan("rip", &[]);
    let denied = plan("rip", &["--deny", "unsafe"]);
    assert_eq!((code(&ignored), code(&denied)), (0, 4));
    assert!(!out(&ignored).is_empty() && out(&denied) == out(&ignored));
    assert_eq!(code(&plan("rcp", &["--deny", "unsafe"])), 0);
    let fast = ["plan", "-", "--set", "plan.time=1.9s", "--set", "plan.against=all"];
    let said = flat(&out(&mavc_with(&fast, TURN)));
    let [bad, advice] = ["UNSAFE until 1.71 s: after M1", "`--set plan.planner=rcp` may cover them."];
    assert!(said.contains(bad) && said.find(bad) < said.find(advice), "{said}");
    // What is unsafe comes before what is covered.
    assert!(said.find(bad) < said.find("at any instant the remaining rotors"), "{said}");
}

/// One line where there is nothing to explain.
#[test]
fn no_risk_takes_one_line() {
    for hold in ["continue", "hold"] {
        let meaning = "the plan never violates the set of a mode with a rate.";
        let ran = mavc_with(&["plan", "-v", "-", "--set", &format!("plan.after_fault={hold}")], TURN);
        let text = out(&ran);
        let line = text.lines().find(|line| line.trim_start().starts_with("Risk ")).unwrap();
        assert!(line.starts_with("  Risk 0: ") && line.contains(meaning), "{text}");
        assert!(!text.contains("treated as independent"), "{text}");
    }
    let text =
        flat(&out(&mavc_with(&["plan", "-v", "-", "--set", "plan.time=minimum", "--set", "plan.planner=rip"], TURN)));
    assert!(text.contains("Modes are treated as independent"), "{text}");
    let apart = compared(&["plan.reserve=30%", "plan.time=20s", "plan.planner=rip"]);
    assert_eq!(
        apart.matches("risk 0: these plans").count() + apart.matches("risk: the probability").count(),
        1,
        "{apart}"
    );
}

/// RSP has the facets that RIP's plan at T_d passes, so without that plan there is no RSP, at no time.
#[test]
fn without_a_plan_to_select_by_there_is_no_rsp() {
    let text = out(&mavc_with(&["compare", "-v", "-", "--set", "plan.time=0.5s"], TURN));
    assert!(
        text.contains("No RIP plan was found at T_d = 0.5 s to select facets from, so RSP selects none."),
        "{text}"
    );
    // A proof for RIP is one for RSP at that time. RSP's shortest time is that of `plan` without a time.
    let rows: Vec<&str> = text.lines().filter_map(|line| line.trim().strip_prefix("RSP  ")).map(str::trim).collect();
    let least = out(&mavc_with(&["plan", "-", "--set", "plan.time=minimum"], TURN));
    let least = least.lines().find_map(|line| line.trim().strip_prefix("PLAN FOUND, ")?.split(" s,").next());
    assert_eq!((rows[0].split("  ").next(), rows[1]), (least, "proved infeasible"), "{text}");
    assert!(!text.contains("RSP guards"), "{text}");
    assert!(!text.contains("Margin of each plan"), "a heading without plans:\n{text}");
}

/// What to protect is chosen from a first plan: where there is none no table stands, least of all an empty one.
#[test]
fn without_a_first_plan_there_is_nothing_to_protect() {
    let requiring = TURN.replacen("plan {", "plan { require risk <= 1e-9;", 1);
    assert_ne!(requiring, TURN);
    let told =
        |time: &str| out(&mavc_with(&["plan", "-v", "-", "--set", "plan.planner=rsp", "--set", time], &requiring));
    assert!(told("plan.time=1.7s").contains("Protection for a risk"), "{}", told("plan.time=1.7s"));
    let early = told("plan.time=0.1s");
    assert!(early.contains("RSP: ") && !early.contains("Protection for a risk"), "{early}");
}

/// A plan that is outside, while a stop is found wherever a fault may strike.
#[test]
fn zero_risk_with_stops_is_reported_as_such() {
    let told = |spec: &str, after: &str| {
        let after = format!("plan.after_fault={after}");
        let fast = ["plan", "-v", "-", "--set", "plan.time=1.8s", "--set", "plan.planner=rip", "--set", &after];
        flat(&out(&mavc_with(&fast, spec)))
    };
    let text = told(TURN, "hold");
    assert!(text.contains("1.80 s hold never"), "{text}");
    assert!(
        text.contains("Risk 0: the plan violates only the sets of modes after which the mission holds, and from"),
        "{text}"
    );
    // What never strikes may well be outside.
    let text = told(&TURN.replace("rate = 1e-5 1/h", "rate = 0 1/h"), "continue");
    assert!(text.contains(" 1.80 s "), "{text}");
    assert!(text.contains("Risk 0: the plan never violates the set of a mode with a rate above zero."), "{text}");
}

#[test]
fn the_analysis_says_what_its_words_mean() {
    let spec =
        format!("{TURN}faults {{ mode near {{ rotors [1, 2] lost }}; mode half {{ rotors [1, 2, 3, 4] lost }} }}");
    let text = out(&mavc_with(&["analyze", "-v", "-"], &spec));
    let row = |mode: &str| text.lines().filter(move |line| line.starts_with(mode)).map(flat).collect::<Vec<_>>();
    let [one, free, left] = &row("near")[..] else { panic!("{text}") };
    assert!(one.starts_with("near flies on, heading not held stabilizable inside, yaw free"), "{one}");
    assert!(free.starts_with("near interior ") && free.ends_with(" unknown"), "{free}");
    assert_eq!(left, "near heading not held");
    let [one, free, left] = &row("half")[..] else { panic!("{text}") };
    assert!(one.starts_with("half lost unstable outside"), "{one}");
    assert_eq!(free, "half none");
    assert_eq!(left, "half no hover");
    for word in ["yaw free", "margin", "heaviest", "facets", "rank", "|e_p|", "disc", "level", "torque", "spin"] {
        assert_eq!(text.lines().filter(|line| line.starts_with(&format!("{word} "))).count(), 1, "{word}: {text}");
    }
}

#[test]
fn no_two_columns_of_the_analysis_have_one_heading() {
    let text = out(&mavc_with(&["analyze", "-v", "-"], TURN));
    let headings: Vec<&str> = text
        .lines()
        .find(|line| line.starts_with("mode "))
        .unwrap()
        .split("  ")
        .map(str::trim)
        .filter(|h| !h.is_empty())
        .collect();
    assert!(headings.len() >= 12 && headings[0] == "mode", "{headings:?}");
    let mut once = headings.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), headings.len(), "{headings:?}");
}

/// Results and errors stay; warnings, progress and notes go.
#[test]
fn quiet_keeps_results_and_errors() {
    // Eight modes, two of them planned against: the others are warned of.
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    std::fs::write(at("turn.mav"), TURN.replace("vehicle octo", "let spare = 3 m\nvehicle octo")).unwrap();
    let (spec, table, proof) = (at("turn.mav"), at("t.csv"), at("cert.json"));
    let plan = |quiet: &[&str]| {
        let args = ["plan", "-v", text(&spec), "-o", text(&table), "--certificate", text(&proof)];
        mavc(&[&args, quiet].concat())
    };
    let (loud, quiet) = (plan(&[]), plan(&["--quiet"]));
    assert!(
        err(&loud).contains("mavc::name::unused") && out(&loud).contains("Trajectory written to"),
        "{}",
        err(&loud)
    );
    assert_eq!(err(&quiet), "");
    let report = out(&loud);
    assert_eq!(out(&quiet), report[..report.find("\nTrajectory written").unwrap()]);
    assert!(table.exists() && proof.exists());

    let verify = |quiet: &[&str]| out(&mavc(&[&["verify", text(&proof), text(&spec)], quiet].concat()));
    assert_eq!(verify(&["--quiet"]), verify(&[]));

    // What `check` is asked for it tells.
    let check = |quiet: &[&str]| out(&mavc(&[&["check", text(&spec)], quiet].concat()));
    assert!(check(&[]).contains("1 warning"), "{}", check(&[]));
    let told = check(&["--quiet"]);
    assert!(told.contains("mavc::name::unused") && !told.contains("1 warning"), "{told}");

    let new = mavc(&["new", text(&at("new.mav")), "--quiet"]);
    assert_eq!((code(&new), out(&new), err(&new)), (0, String::new(), String::new()));
    // Why there is no plan is an error.
    let none = mavc(&["plan", "-v", text(&spec), "--quiet", "--set", "plan.time=0.5s"]);
    assert_eq!(code(&none), 3);
    assert!(err(&none).contains("mavc::plan::conflict"), "{}", err(&none));
}
