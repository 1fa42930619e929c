//! What people see first: answers of one screen, on every shipped spec and on unusual ones; every table with `-v`.

use crate::cli::shipped::planned;
use crate::cli::{code, err, flat, folder, mavc, mavc_with, out};
use std::path::{Path, PathBuf};
use std::process::Output;
use std::sync::LazyLock;

/// Lines and columns of a screen.
const LINES: usize = 25;
const COLUMNS: usize = 80;

/// Whether an output fits on a screen; hints after it count too.
#[track_caller]
fn fits(args: &[&str], ran: &Output) {
    let text = out(ran);
    let (lines, columns) = (text.lines().count(), text.lines().map(|line| line.chars().count()).max().unwrap_or(0));
    assert!(lines > 0, "{args:?} printed nothing\n{}", err(ran));
    assert!(lines <= LINES && columns <= COLUMNS, "{args:?}: {lines} lines of up to {columns} columns\n{text}");
    assert!(!text.contains('\u{1b}'), "{args:?}: escapes in a pipe");
}

/// A comparison and a campaign that several tests read.
const COMPARE: [&str; 2] = ["compare", "specs/paper/case2.mav"];
static COMPARED: LazyLock<Output> = LazyLock::new(|| mavc(&COMPARE));
const FEW: [&str; 6] = ["campaign", "specs/paper/campaign.mav", "--times", "1", "--seeds", "1"];
static FLOWN: LazyLock<Output> = LazyLock::new(|| mavc(&FEW));

/// The specs of this repository.
fn shipped() -> Vec<String> {
    let entries = |folder: &Path| -> Vec<PathBuf> {
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect()
    };
    let folders = ["examples", "specs/missions", "specs/paper", "specs/vehicles"].map(Path::new);
    let files = folders.iter().flat_map(|folder| entries(folder));
    let mut specs: Vec<String> = files.map(|path| path.display().to_string()).filter(|p| p.ends_with(".mav")).collect();
    specs.sort();
    specs
}

#[test]
fn analyses_and_checks_fit_on_a_screen() {
    let specs = shipped();
    assert!(specs.len() > 25, "{specs:?}");
    for spec in &specs {
        let analyzed = mavc(&["analyze", spec]);
        fits(&["analyze", spec], &analyzed);
        assert_eq!(code(&analyzed), 0);
        // Without problems the headline is the first line of both.
        let checked = mavc(&["check", spec]);
        if out(&checked).ends_with(": no problems\n") {
            fits(&["check", spec], &checked);
            assert_eq!(out(&analyzed).lines().next(), out(&checked).lines().next());
        }
    }
    for (kind, text) in mavc::MISSION_TEMPLATES.into_iter().chain([("octo", mavc::TEMPLATE)]) {
        fits(&["analyze", kind], &mavc_with(&["analyze", "-"], text));
    }
}

#[test]
fn plans_and_flights_fit_on_a_screen() {
    for spec in ["examples/survey_hexa.mav", "examples/parcel_quad.mav", "specs/paper/case2.mav"] {
        planned(spec, |plan| fits(&["plan", spec], &plan.output));
    }
    let spec = "specs/paper/figure12.mav";
    fits(&["simulate", spec], &mavc(&["simulate", spec]));
    fits(&COMPARE, &COMPARED);
    fits(&FEW, &FLOWN);
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// Every plan of a shipped spec that has a mission, and its flight. A detour is on the screen, whatever else is.
    #[test]
    #[ignore = "plans every shipped mission three times"]
    fn every_plan_fits_on_a_screen() {
        let has_mission = |spec: &String| std::fs::read_to_string(spec).unwrap().contains("mission ");
        let specs: Vec<String> = shipped().into_iter().filter(has_mission).collect();
        assert!(specs.len() >= 15, "{specs:?}");
        for spec in &specs {
            let dir = folder();
            let report = dir.path().join("plan.json").display().to_string();
            let args = ["plan", spec, "--report", &report];
            let planned = mavc(&args);
            fits(&args, &planned);
            let record: serde_json::Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
            let has_detour = record["planners"]
                .as_array()
                .unwrap()
                .iter()
                .any(|run| run["detours"].as_array().is_some_and(|detours| !detours.is_empty()));
            assert_eq!(has_detour, out(&planned).contains("although no volume is in the way"), "{spec}");
            fits(&["simulate", spec], &mavc(&["simulate", spec]));
        }
        for (kind, text) in mavc::MISSION_TEMPLATES.into_iter().chain([("octo", mavc::TEMPLATE)]) {
            fits(&["plan", kind], &mavc_with(&["plan", "-"], text));
        }
    }

    /// What safety costs, and a small campaign, of specs whose planners take seconds.
    #[test]
    #[ignore = "plans with every planner"]
    fn every_comparison_fits_on_a_screen() {
        let missions = ["facade_hexa", "ridge_hexa", "inspection"].map(|name| format!("specs/missions/{name}.mav"));
        let examples = ["roof_octo", "survey_hexa", "tower_octo"].map(|name| format!("examples/{name}.mav"));
        for spec in missions.iter().chain(&examples) {
            fits(&["compare", spec], &mavc(&["compare", spec]));
            let args = ["campaign", spec, "--times", "2", "--seeds", "1"];
            fits(&args, &mavc(&args));
        }
    }
}

/// A vehicle with fault modes, and a short mission.
fn spec(layout: &str, mass: &str, faults: &str, plan: &str) -> String {
    format!(
        "vehicle v {{
            layout = \"{layout}\"; arm = 40 cm; mass = {mass}; inertia = [0.05, 0.05, 0.09] kg*m^2
            yaw_drag = 20e-3 N*m*s/rad; drag = 0 N*s/m
            rotor {{ max_thrust = 13 N; torque_per_thrust = 17 mm; max_speed = 7500 rpm }}
        }}
        faults {{ {faults} }}
        mission m {{
            start at [0, 0, 2] m
            waypoint at [20, 0, 5] m
            limits {{ speed <= 6 m/s; tilt <= 30 deg }}
        }}
        plan {{ samples = 40; {plan} }}"
    )
}

#[test]
fn unusual_specs_fit_on_a_screen() {
    let long: String = (1..=6).map(|k| format!("mode {}{k} {{ rotor {k} lost }}\n", "n".repeat(58))).collect();
    let many: String =
        (0..300).map(|k| format!("mode x{k} {{ rotor {} reduced to {} % }}\n", k % 6 + 1, 98 - k / 6)).collect();
    let every = "every 1 rotor lost as M\nevery 2 rotors lost as D\nevery 3 rotors lost as T";
    let texts = [
        spec("PPNNPN", "3.4 kg", &long, "against = []; time = 9 s"),
        spec("PPNNPN", "3.4 kg", &many, "against = [x1]; time = 9 s"),
        spec("PNPNPNPN", "4 kg", every, "against = [M1]; time = 9 s"),
        spec("PNPNPN", "3.4 kg +- 10 %", "every 1 rotor lost as M", "time = 9 s"),
        spec("PNPN", "2 kg", "every 1 rotor lost as M", "time = 9 s"),
        spec("PPNNPN", "3.4 kg", "", "time = 9 s"),
    ];
    for text in &texts {
        fits(&["analyze"], &mavc_with(&["analyze", "-"], text));
        fits(&["plan"], &mavc_with(&["plan", "-"], text));
    }
}

/// Many modes: the weakest of each outcome are listed, and the others are counted.
#[test]
fn many_modes_are_counted() {
    let many: String =
        (0..300).map(|k| format!("mode x{k} {{ rotor {} reduced to {} % }}\n", k % 6 + 1, 98 - k / 6)).collect();
    let text = out(&mavc_with(&["analyze", "-"], &spec("PPNNPN", "3.4 kg", &many, "against = [x1]")));
    let (rows, listed): (Vec<&str>, usize) = {
        let rows: Vec<&str> = text.lines().skip_while(|line| !line.contains("after it")).skip(2).collect();
        let rows: Vec<&str> = rows.into_iter().take_while(|line| !line.is_empty()).collect();
        let named = |row: &&&str| !row.trim_start().starts_with("and ");
        (rows.clone(), rows.iter().filter(named).map(|row| modes_named(row)).sum())
    };
    let counted: usize = rows
        .iter()
        .filter_map(|row| row.trim_start().strip_prefix("and ")?.split(' ').next()?.parse::<usize>().ok())
        .sum();
    assert!(counted > 0, "{text}");
    assert_eq!(listed + counted, 300, "{text}");
}

/// How many modes a cell names: `M1 .. M8`, `D1_2, D3_4`, `T1_2_3 and 7 more`.
fn modes_named(row: &str) -> usize {
    let cell = row.trim_start().split("  ").next().unwrap();
    let (names, more) = cell
        .split_once(" and ")
        .map_or((cell, 0), |(names, more)| (names, more.trim_end_matches(" more").parse::<usize>().unwrap()));
    let number = |name: &str| name.trim_start_matches(|c: char| c.is_ascii_alphabetic()).parse::<usize>().unwrap();
    let of_part = |part: &str| part.split_once(" .. ").map_or(1, |(a, b)| number(b) + 1 - number(a));
    names.split(", ").map(of_part).sum::<usize>() + more
}

/// A plan that leaves sets says until when, before any figure; one that covers them says so, and what is not covered.
#[test]
fn the_answer_comes_first() {
    let begin = |text: &str| text.lines().take(8).collect::<Vec<_>>().join(" ");
    let first = |args: &[&str]| begin(&out(&mavc(args)));
    let survey = "examples/survey_hexa.mav";
    let safe = planned(survey, |plan| begin(&out(&plan.output)));
    assert!(
        safe.contains("PLAN FOUND, 35 s") && safe.contains("After M1 .. M4 (one rotor lost) at any instant"),
        "{safe}"
    );
    assert!(safe.contains("NOT covered at any time, not in `against`: M5, M6 (one rotor lost;"), "{safe}");
    let ignoring = first(&["plan", survey, "--set", "plan.planner=rip"]);
    assert!(
        ignoring.contains("UNSAFE until 2.7")
            && ignoring.contains("after M2, M3 (one rotor lost) the remaining rotors"),
        "{ignoring}"
    );
    let early = first(&["plan", survey, "--set", "plan.time=12s"]);
    assert!(early.contains("PROVED INFEASIBLE at 12 s") && !early.contains("PLAN FOUND"), "{early}");
    let text = spec("PPNNPN", "3.4 kg", "every 1 rotor lost as M", "against = [M1]; time = 9 s; planner = rip");
    let none = out(&mavc_with(&["plan", "-"], &spec("PPNNPN", "3.4 kg", "", "time = 9 s")));
    assert!(none.contains("No fault modes are declared: this plan covers none."), "{none}");
    // RSP selects no facet: the RIP plan violates none, or it may not.
    let slow = |plan: &str| {
        let text = spec("PPNNPPNN", "2 kg", "every 1 rotor lost as M", &format!("against = all; time = 30 s; {plan}"));
        flat(&out(&mavc_with(&["plan", "-"], &text)))
    };
    let reasons = [
        "the plan that ignores faults violates no constraint of these modes; RSP adds none",
        "with `rounds = 0` RSP guards no",
    ];
    for (plan, reason) in ["rounds = 1", "rounds = 0"].into_iter().zip(reasons) {
        let text = slow(plan);
        assert!(text.contains(&format!("Sampled along the plan, not proved: {reason}")), "{text}");
    }
    let caught = spec("PNPN", "2 kg", "every 1 rotor lost as M", "time = 9 s");
    let caught = out(&mavc_with(&["plan", "-"], &caught));
    assert!(caught.contains("Not planned for M1") && !caught.contains("at any instant"), "{caught}");
    assert!(out(&mavc_with(&["plan", "-"], &text)).contains("NOT covered at any time, not in `against`: M2"));
}

/// What covering the faults costs: at a fixed time against the RIP plan that RSP selects from, at a shortest time
/// against a bound that no fault enters, and nothing about plans that cover none.
#[test]
fn a_plan_names_its_price() {
    let price = |text: &str| -> Option<String> {
        text.lines().find_map(|line| Some(line.trim_start().strip_prefix("price")?.trim_start().to_string()))
    };
    let survey = "examples/survey_hexa.mav";
    let fixed = planned(survey, |plan| out(&plan.output));
    let priced = price(&fixed).unwrap();
    let ignoring = out(&mavc(&["plan", survey, "--set", "plan.planner=rip"]));
    let until = |text: &str| -> f64 {
        let number =
            flat(text).to_lowercase().split("unsafe until ").nth(1).unwrap().split(" s").next().unwrap().to_string();
        number.parse().unwrap()
    };
    assert!(priced.starts_with("no time: a plan that ignores faults also takes 35 s "), "{fixed}");
    // RSP selects from the plan before its second pass.
    assert!((until(&fixed) - until(&ignoring)).abs() < 0.1, "{fixed}\n{ignoring}");
    assert_eq!(price(&ignoring).as_deref(), Some("none, because this plan ignores faults; `mavc compare` finds what"));

    let text = |plan: &str| spec("PPNNPPNN", "3.4 kg", "every 1 rotor lost as M", plan);
    let shortest = out(&mavc_with(&["plan", "-"], &text("against = [M1]; time = minimum; planner = rcp")));
    let figure = |before: &str, after: &str| -> f64 {
        let words = shortest.split_whitespace().collect::<Vec<_>>().join(" ");
        words.split(before).nth(1).unwrap().split(after).next().unwrap().parse().unwrap()
    };
    let (time, least, most) = (figure("FOUND, ", " s"), figure("faster than ", " s"), figure("at most ", " s"));
    assert!((time - least - most).abs() < 0.02 && most > 0.0, "{shortest}");
    // Faults leave less thrust, so the headline's bound is above that of the price; it has the gap.
    assert!(figure("less than ", " s") > least, "{shortest}");
    let shortest = price(&shortest).unwrap();
    assert!(
        shortest.contains("no motion within limits and thrust is faster than") && !shortest.contains('%'),
        "{shortest}"
    );
    let fixed = out(&mavc_with(&["plan", "-"], &text("against = [M1]; time = 9 s; planner = rcp")));
    assert!(price(&fixed).unwrap().starts_with("no time, because the spec asks for 9 s; `mavc"), "{fixed}");
}

/// All figures of before stand behind `-v`, which every command takes.
#[test]
fn every_table_is_a_flag_away() {
    let survey = "examples/survey_hexa.mav";
    let analysis = out(&mavc(&["analyze", survey, "-v"]));
    for column in ["yaw-free heaviest", "facets", "Headroom from hover", "With yaw given up", "full control"] {
        assert!(analysis.contains(column), "{column}\n{analysis}");
    }
    let plan = out(&mavc(&["plan", "--verbose", survey]));
    assert!(plan.contains("sum of position errors") && plan.contains("last violation"), "{plan}");
}

/// Columns that a first reader does not know have a legend, and planners their names in full, on shipped specs.
#[test]
fn what_is_not_known_is_explained() {
    let survey = "examples/survey_hexa.mav";
    let analysis = flat(&out(&mavc(&["analyze", survey])));
    let masses = "max kg: the largest mass that hovers, turning if the heading is not held; least margin: hover \
                  nearest to the edge";
    assert!(analysis.contains(masses), "{analysis}");
    let plan = planned(survey, |plan| out(&plan.output));
    assert!(plan.contains("planner RSP (risk-sensitive)\n"), "{plan}");
    let (compared, flown) = (flat(&out(&COMPARED)), flat(&out(&FLOWN)));
    let planners = "RIP (risk-insensitive) ignores faults; RSP (risk-sensitive) guards what RIP violates; \
                    RCP (risk-conservative) guards every constraint";
    assert!(compared.contains(planners) && flown.contains(planners), "{compared}\n{flown}");
    assert!(compared.contains("objective: errors and effort, minimised locally"), "{compared}");
    assert!(flown.contains("Waypoints missed after a fault: RIP "), "{flown}");
    for text in [&analysis, &plan, &compared, &flown] {
        assert!(!text.contains("T_d"), "{text}");
    }
}

/// `--help` fits on a terminal, and so does the prose of every table; rows of figures may be wider.
#[test]
fn help_and_prose_are_as_wide_as_a_terminal() {
    let commands = [
        "",
        "new",
        "check",
        "analyze",
        "plan",
        "compare",
        "view",
        "verify",
        "safety",
        "simulate",
        "campaign",
        "diagnose",
        "identify",
        "import",
        "emit",
        "fmt",
        "lsp",
        "explain",
        "completions",
        "man",
    ];
    for command in commands {
        let args: Vec<&str> = [command, "--help"].into_iter().filter(|word| !word.is_empty()).collect();
        let text = out(&mavc(&args));
        assert!(text.lines().all(|line| line.chars().count() <= COLUMNS), "{args:?}\n{text}");
    }
    let is_figures = |line: &str| {
        let last = line.trim_end().rfind("  ").map_or(0, |gap| line[..gap].chars().count());
        last > COLUMNS / 2 && line.trim().split("  ").filter(|cell| !cell.trim().is_empty()).count() > 3
    };
    let survey = "examples/survey_hexa.mav";
    let few = [&FEW[..], &["-v"]].concat();
    // The widths of tables do not depend on the samples.
    let few_samples = ["-v", "--set", "plan.samples=60"];
    let [plan, simulate] = ["plan", "simulate"].map(|command| [&[command, survey], &few_samples[..]].concat());
    let all = [&["analyze", survey, "-v"][..], &plan, &simulate, &few];
    for args in all {
        let text = out(&mavc(args));
        let wide: Vec<&str> = text.lines().filter(|line| line.chars().count() > COLUMNS && !is_figures(line)).collect();
        assert!(wide.is_empty(), "{args:?}\n{}", wide.join("\n"));
    }
}

/// The price is in the report, on the page and with `-v` what it is on the screen, also of a plan that is unsafe.
#[test]
fn the_price_is_one_everywhere() {
    let dir = folder();
    let [report, page] = ["r.json", "p.html"].map(|name| dir.path().join(name).display().to_string());
    let spec = |plan: &str| spec("PPNNPPNN", "3.4 kg", "every 1 rotor lost as M", plan);
    for (plan, is_unsafe) in [
        ("against = [M1]; time = 9 s", false),
        // Selected once, as in the paper's model.
        ("against = [M1]; time = minimum; planner = rip", true),
        ("against = [M1, M2]; time = minimum; model = hover", true),
    ] {
        let args = ["plan", "-", "--report", &report, "--html", &page];
        let text = out(&mavc_with(&args, &spec(plan)));
        let record: serde_json::Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
        let price = &record["planners"][0]["price"];
        assert_eq!(price["still_unsafe"], is_unsafe, "{plan}: {price}\n{text}");
        let sentence = price["sentence"].as_str().unwrap();
        assert!(flat(&text).contains(&format!("price {sentence}")), "{sentence}\n{text}");
        let html = std::fs::read_to_string(&page).unwrap();
        assert!(html.contains("Price of covering the faults"), "{plan}");
        let verbose = flat(&out(&mavc_with(&["plan", "-", "-v"], &spec(plan))));
        assert!(verbose.contains(&format!("price: {sentence}")), "{sentence}\n{verbose}");
        if let (Some(time), Some(base)) = (price["more_time_s"].as_f64(), price["baseline_time_s"].as_f64()) {
            let whole = record["planners"][0]["time_s"].as_f64().unwrap();
            assert!((base + time - whole).abs() < 1e-9, "{price}");
        }
    }
}

/// Colours are for terminals.
#[cfg(unix)]
#[test]
fn pipes_get_no_colour() {
    let dir = folder();
    let file = dir.path().join("out.txt");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(["analyze", "examples/survey_hexa.mav"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("NO_COLOR")
        .stdout(std::fs::File::create(&file).unwrap())
        .status()
        .unwrap();
    assert!(run.success());
    assert!(!std::fs::read_to_string(&file).unwrap().contains('\u{1b}'));
}
