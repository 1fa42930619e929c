//! What `mavc emit` prints of every stage for every shipped spec.
//!
//! Models have their snapshots in `model/shipped.rs`; here it is enough that `emit` prints the same. Everything else
//! is printed with nine decimals at most, while machines differ in the sixteenth, so the text is compared as it
//! stands. The planned stages show only what no solver's digits decide: counts, and rows that are facets of the sets.

use std::path::Path;
use std::process::{Command, Output};

const MISSIONS: [&str; 18] = [
    "missions/facade_hexa",
    "missions/ferry_octo",
    "missions/inspection",
    "missions/inspection_octo",
    "missions/mast_octo",
    "missions/parcel_x8",
    "missions/ridge_hexa",
    "missions/survey_quad",
    "missions/tower_hexa",
    "missions/valley_x8",
    "paper/campaign",
    "paper/case1",
    "paper/case2",
    "paper/case3",
    "paper/figure12",
    "paper/figure3",
    "paper/figure5",
    "paper/tracking",
];

/// Those with another vehicle than the paper's octocopter.
const OTHER_VEHICLE: [&str; 8] = [
    "missions/facade_hexa",
    "missions/inspection_octo",
    "missions/mast_octo",
    "missions/parcel_x8",
    "missions/ridge_hexa",
    "missions/survey_quad",
    "missions/tower_hexa",
    "missions/valley_x8",
];

const VEHICLES: [&str; 9] = [
    "vehicles/coaxial_x8",
    "vehicles/hexa_pnpnpn",
    "vehicles/hexa_ppnnpn",
    "vehicles/octo_pnpnpnpn",
    "vehicles/octo_ppnnppnn",
    "vehicles/octo_ppnnppnn_pseudo_inverse",
    "vehicles/quad_pnpn",
    "vehicles/quad_x",
    "vehicles/ring12",
];

/// Rows of one set that a snapshot shows: all of a quadcopter's, and enough of a larger one's to see its form.
const ROWS: usize = 12;

fn all() -> impl Iterator<Item = &'static str> {
    MISSIONS.into_iter().chain(VEHICLES)
}

/// `mavc emit STAGE specs/NAME.mav`
fn emit(stage: &str, name: &str, more: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(["emit", stage, &format!("specs/{name}.mav")])
        .args(more)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env("NO_COLOR", "1")
        .env_remove("COLUMNS")
        .output()
        .unwrap()
}

/// What a stage prints, which has nothing to complain about.
fn printed(stage: &str, name: &str, more: &[&str]) -> String {
    let output = emit(stage, name, more);
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), told.as_str()), (Some(0), ""), "{stage} {name}");
    String::from_utf8(output.stdout).unwrap()
}

/// One snapshot for a stage and a spec, in `snapshots/stages`.
fn compare(stage: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/stages");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let (_, short) = name.split_once('/').unwrap();
    settings.bind(|| insta::assert_snapshot!(format!("{short}.{stage}"), text));
}

/// The rows of every set past the first [`ROWS`] become their number. A set begins with a line that is not indented.
fn shortened(text: &str) -> String {
    let (mut out, mut rows) = (String::new(), 0);
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        rows = if line.starts_with(' ') { rows + 1 } else { 0 };
        if rows <= ROWS {
            out.push_str(&format!("{line}\n"));
        }
        if rows > ROWS && lines.peek().is_none_or(|next| !next.starts_with(' ')) {
            out.push_str(&format!("  and {} more rows\n", rows - ROWS));
        }
    }
    out
}

/// The planner's rows: those of the healthy set become their number, since `sets` shows them; those of fault modes
/// stay, since the choice of them is what the stage is for.
fn faults_only(text: &str) -> String {
    let of_healthy = |line: &&str| line.split_whitespace().last().is_some_and(|origin| origin.starts_with("0."));
    let kept: String = text.lines().filter(|line| !of_healthy(line)).map(|line| format!("{line}\n")).collect();
    format!("{kept}  and {} rows of the healthy set\n", text.lines().filter(of_healthy).count())
}

/// A mission time at which each case violates facets of its faults' sets, and few samples: no search, small programs,
/// the same rows. Whether a facet is violated does not depend on the solver's last digits.
fn quick(name: &str) -> Vec<&'static str> {
    match name {
        // The last waypoint fixes its time.
        "missions/inspection" => vec!["--set", "plan.samples=60"],
        // Longer missions, with more legs and stops.
        "missions/parcel_x8" | "missions/valley_x8" => vec!["--set", "plan.samples=60", "--set", "plan.time=125s"],
        "missions/tower_hexa" => vec!["--set", "plan.samples=120", "--set", "plan.time=90s"],
        "missions/ferry_octo" => vec!["--set", "plan.samples=60", "--set", "plan.time=120s"],
        "missions/survey_quad" => vec!["--set", "plan.samples=200", "--set", "plan.time=150s"],
        "missions/facade_hexa" => vec!["--set", "plan.samples=120", "--set", "plan.time=40s"],
        "missions/ridge_hexa" => vec!["--set", "plan.samples=60", "--set", "plan.time=40s"],
        // With 60 samples the search for its plan takes ten times as long.
        "missions/mast_octo" => vec!["--set", "plan.samples=40", "--set", "plan.time=20s"],
        _ => vec!["--set", "plan.samples=60", "--set", "plan.time=20s"],
    }
}

#[test]
fn the_list_holds_every_shipped_spec() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs");
    let mut found = Vec::new();
    for folder in std::fs::read_dir(&root).unwrap() {
        for file in std::fs::read_dir(folder.unwrap().path()).unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|e| e == "mav") {
                found.push(path.strip_prefix(&root).unwrap().with_extension("").display().to_string());
            }
        }
    }
    found.sort();
    assert_eq!(found, all().collect::<Vec<_>>());
}

#[test]
fn texts_are_printed_back() {
    all().for_each(|name| compare("ast", name, &printed("ast", name, &[])));
}

#[test]
fn models_are_those_of_the_library() {
    for name in all() {
        let path = format!("specs/{name}.mav");
        let spec = mavc::Compiler::new().file(path).unwrap().into_result().unwrap();
        assert_eq!(printed("model", name, &[]), spec.model().to_string(), "{name}");
    }
}

#[test]
fn actuation_matrices_are_printed() {
    // Most missions fly the octocopter.
    let (own, others): (Vec<_>, Vec<_>) = MISSIONS.into_iter().partition(|name| OTHER_VEHICLE.contains(name));
    VEHICLES.into_iter().chain(own).for_each(|name| compare("actuation", name, &printed("actuation", name, &[])));
    for name in others {
        assert_eq!(printed("actuation", name, &[]), printed("actuation", "vehicles/octo_ppnnppnn", &[]), "{name}");
    }
}

#[test]
fn sets_are_printed() {
    all().for_each(|name| compare("sets", name, &shortened(&printed("sets", name, &[]))));
}

fn rows_are_printed(name: &str) {
    compare("constraints", name, &faults_only(&printed("constraints", name, &quick(name))));
}

fn programs_are_printed(name: &str) {
    compare("qp", name, &printed("qp", name, &quick(name)));
}

#[test]
fn rows_and_programs_of_a_plan_are_printed() {
    rows_are_printed(MISSIONS[0]);
    programs_are_printed(MISSIONS[0]);
}

#[test]
#[ignore = "long"]
fn rows_and_programs_of_all_plans_are_printed() {
    MISSIONS[1..].iter().for_each(|name| rows_are_printed(name));
    MISSIONS[1..].iter().for_each(|name| programs_are_printed(name));
}

#[test]
fn a_vehicle_alone_has_nothing_to_plan() {
    for name in VEHICLES {
        let refused = emit("qp", name, &[]);
        assert_eq!((refused.status.code(), refused.stdout.as_slice()), (Some(1), &b""[..]), "{name}");
        assert_eq!(emit("constraints", name, &[]), refused, "{name}");
        compare("qp", name, &String::from_utf8(refused.stderr).unwrap());
    }
}
