//! Comparisons tell runs with one plan in one line.

use super::*;

/// A slow hop, in which losing a little is felt by no planner; quickly flown it is.
const SLOW: &str = r#"
vehicle hexa {
    layout  = "PNPNPN"
    arm     = 25 cm
    mass    = 1.6 kg
    inertia = [0.014, 0.014, 0.026] kg*m^2
    rotor { max_thrust = 9 N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }
}
faults {
    every 1 rotor reduced to 90 % as W
    mode worn { rotor 1 reduced to 40 % }
}
mission hop {
    start at [0, 0, 2] m
    waypoint at [6, 0, 5] m
}
plan { model = hover; time = 8 s; samples = 30 }
"#;

/// The lines of a table, from the heading that ends in `what` to the first line of something else.
fn table<'t>(text: &'t str, what: &str) -> Vec<&'t str> {
    let begin = text.find(what).unwrap_or_else(|| panic!("no {what}:\n{text}"));
    text[begin..].lines().skip(2).take_while(|line| line.starts_with("  ")).collect()
}

#[test]
fn runs_with_one_plan_take_one_line_that_names_them_all() {
    let dir = folder();
    let report = dir.path().join("report.json");
    let ran = mavc_with(&["compare", "-v", "-", "--report", text(&report)], SLOW);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    let said = out(&ran);
    let rows = table(&said, "All planners at the common time T_d = 8 s");
    assert!(rows[0].starts_with("  RIP and 9 more "), "{said}");
    assert_eq!(rows[1..], ["  RIP and 9 more: RIP, RCP W1 .. W6, worn, RCP jointly, RSP."], "{said}");
    assert_eq!(table(&said, "(last violation): all planners at T_d").len(), 1, "{said}");
    // Quickly flown the plans differ, though their times do not.
    let own = table(&said, "Each planner alone");
    assert!(own.iter().any(|row| row.starts_with("  RCP W1 ")), "{said}");
    assert!(own.iter().any(|row| row.starts_with("  RCP worn")), "{said}");
    // Reports have every run.
    let record: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
    let planners = record["planners"].as_array().unwrap();
    assert_eq!(planners.len(), 2 * (1 + 7 + 1 + 1));
    // RCP's runs that ended without a plan are told together, too.
    let said = out(&mavc_with(&["compare", "-v", "-", "--set", "plan.time=0.3s"], SLOW));
    let rows = table(&said, "All planners at the common time T_d = 0.3 s");
    let names: Vec<&str> = rows.iter().filter_map(|row| row.trim().split("  ").next()).collect();
    assert_eq!(names, ["RIP", "RCP W1 .. W6, worn", "RCP jointly", "RSP"], "{said}");
}
