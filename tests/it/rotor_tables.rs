//! Thrust tables of motors: a spec with one is the spec with the values written out, wherever the table lies, and
//! damaged cells end in a message.

use crate::cli::{mavc_in, text};
use mavc::diagnostic::{Diagnostic, render_human};
use mavc::spec::Compiled;
use mavc::{Compiler, PlanOutcome, Spec};
use std::fs;
use std::io::{Error, ErrorKind};
use std::path::Path;

const MADE_UP: &str = include_str!("../../examples/made_up_motor.csv");

/// A quadcopter with these lines in its `rotor` and `battery`, on a mission.
fn quad(rotor: &str, battery: &str) -> String {
    format!(
        "vehicle quad {{
    layout  = \"PNPN\"
    arm     = 0.211 m
    mass    = 1.32 kg
    inertia = [0.0128, 0.0128, 0.0239] kg*m^2
    rotor {{ {rotor} }}
    battery {{ capacity = 5 A*h; voltage = 14.8 V{battery} }}
}}
mission m {{
    start at [0, 0, 2] m
    waypoint at [6, 2, 3] m
    limits {{ speed <= 4 m/s; tilt <= 20 deg }}
}}
plan {{ planner = rip; samples = 30 }}
"
    )
}

fn compiled(spec: &str, table: &[u8]) -> Compiled {
    let read = |path: &Path| match path {
        path if path == Path::new("motor.csv") => Ok(table.to_vec()),
        _ => Err(Error::from(ErrorKind::NotFound)),
    };
    Compiler::new().reading(&read).text("a.mav", spec.as_bytes())
}

fn spec(text: &str, table: &str) -> Spec {
    let compiled = compiled(text, table.as_bytes());
    assert!(compiled.diagnostics.is_empty(), "{}", compiled.render());
    compiled.into_result().unwrap()
}

const WITH_TABLE: &str = "table = \"motor.csv\"";

/// The rows of the example by plain arithmetic: thrust (N), torque (N m), speed (rad/s), power (W).
fn rows() -> Vec<[f64; 4]> {
    let lines = MADE_UP.lines().filter(|line| !line.starts_with(['#', 'T']));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        [cells[1] * 9.80665e-3, cells[2], cells[3] * std::f64::consts::PI / 30.0, cells[6]]
    };
    lines.map(row).collect()
}

#[test]
fn a_spec_with_a_table_is_the_spec_with_its_values() {
    let tabled = spec(&quad(WITH_TABLE, ""), MADE_UP);
    // As the defaults list them, with every digit.
    let default = |field: &str| {
        let defaults = &tabled.model().defaults;
        defaults.iter().find(|d| d.field == field).unwrap_or_else(|| panic!("{field}: {defaults:#?}")).value.clone()
    };
    let rotor = ["max_thrust", "torque_per_thrust", "max_speed"]
        .map(|field| format!("{field} = {}; ", default(&format!("vehicle.rotor.{field}"))));
    let battery = format!("; hover_power = {}", default("vehicle.battery.hover_power"));
    let written = spec(&quad(&rotor.concat(), &battery), "");
    assert_eq!(tabled.model().vehicle.rotors, written.model().vehicle.rotors);
    let battery = |spec: &Spec| spec.model().vehicle.battery.clone().unwrap().hover_power;
    assert_eq!(battery(&tabled), battery(&written));
    let flown = |spec: &Spec| match mavc::plan(spec).unwrap().outcome() {
        PlanOutcome::Planned(plan) => format!("{:?}", plan.trajectory),
        other => panic!("{other:?}"),
    };
    assert_eq!(flown(&tabled), flown(&written));

    // And as plain arithmetic has them.
    let rows = rows();
    let last = rows[rows.len() - 1];
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} is not {b}");
    let one = &tabled.model().vehicle.rotors[0];
    near(one.max_thrust(), last[0]);
    near(one.max_speed, last[2]);
    let (products, squares) = rows.iter().fold((0.0, 0.0), |(p, s), row| (p + row[0] * row[1], s + row[0] * row[0]));
    near(one.drag_coefficient / one.thrust_coefficient, products / squares);
    let hover = 1.32 * 9.81 / 4.0;
    let above = rows.iter().position(|row| row[0] > hover).unwrap();
    let ([t0, .., p0], [t1, .., p1]) = (rows[above - 1], rows[above]);
    near(battery(&tabled), 4.0 * (p0 + (p1 - p0) * (hover - t0) / (t1 - t0)));
}

#[test]
fn what_is_written_beside_a_table_wins() {
    let messages = |rotor: &str| {
        let compiled = compiled(&quad(&format!("{WITH_TABLE}; {rotor}"), "; hover_power = 170 W"), MADE_UP.as_bytes());
        let messages: Vec<String> = compiled.diagnostics.iter().map(|d: &Diagnostic| d.message.clone()).collect();
        (messages, compiled.into_result().unwrap())
    };
    let (warnings, spec) = messages("max_thrust = 7.5 N");
    assert_eq!(warnings, ["`max_thrust` is 7.41 % above that of `motor.csv`"]);
    assert!((spec.model().vehicle.rotors[0].max_thrust() - 7.5).abs() < 1e-12);
    assert_eq!(spec.model().vehicle.battery.as_ref().unwrap().hover_power, 170.0);
    // Rounded, or an interval that contains it.
    assert_eq!(messages("max_thrust = 7 N").0, [""; 0]);
    assert_eq!(messages("max_thrust = 6.5 N +- 10 %").0, [""; 0]);
    let (warnings, spec) = messages("thrust_coefficient = 8e-6 N*s^2/rad^2; max_speed = 9000 rpm");
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(warnings[0].starts_with("`thrust_coefficient` is 19.2 % below"), "{warnings:?}");
    assert!((spec.model().vehicle.rotors[0].thrust_coefficient - 8e-6).abs() < 1e-18);
    let quiet = compiled(
        &format!("allow = [rotor_table]\n{}", quad("table = \"motor.csv\"; max_thrust = 8 N", "")),
        MADE_UP.as_bytes(),
    );
    assert!(quiet.diagnostics.is_empty(), "{}", quiet.render());
}

#[test]
fn a_table_lies_beside_the_file_that_names_it_and_belongs_to_the_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("vehicles")).unwrap();
    fs::create_dir(at("motors")).unwrap();
    let whole = quad("table = \"../motors/motor.csv\"", "");
    let (vehicle, mission) = whole.split_at(whole.find("mission").unwrap());
    fs::write(at("vehicles/quad.mav"), vehicle.replace("table = ", "table=")).unwrap();
    fs::write(at("root.mav"), format!("use \"vehicles/quad.mav\"\n\n{mission}")).unwrap();
    fs::write(at("motors/motor.csv"), MADE_UP).unwrap();
    let stronger = MADE_UP.replace("100,712,", "100,741,");
    fs::write(at("motors/other.csv"), &stronger).unwrap();
    let run = |words: &[&str]| mavc_in(folder.path(), words);

    let (code, shown, _) = run(&["check", "root.mav", "--explain-defaults"]);
    assert!(code == 0 && shown.contains("vehicle.rotor.max_thrust"), "{shown}");
    assert!(shown.contains("6.982334"), "{shown}");
    // An override is written as if in the root file.
    let set = "vehicle.rotor.table=\"motors/other.csv\"";
    let (code, shown, told) = run(&["check", "root.mav", "--explain-defaults", "--set", set]);
    assert!(code == 0 && shown.contains("7.266727"), "{shown}{told}");
    let (code, shown, told) = run(&["check", "root.mav", "--set", "vehicle.rotor.table=\"motors/none.csv\""]);
    assert!(code == 1 && (shown + &told).contains("mavc::file::missing"), "{told}");
    assert_eq!(run(&["fmt", "--check", "vehicles/quad.mav"]).0, 1);
    assert_eq!(run(&["fmt", "vehicles/quad.mav"]).0, 0);
    assert_eq!(run(&["fmt", "--check", "vehicles/quad.mav"]).0, 0);

    let (code, shown, told) = run(&["plan", "root.mav", "-o", "plan.csv", "--certificate", "plan.json"]);
    assert_eq!(code, 0, "{shown}{told}");
    let verify = |more: &[&str]| {
        let mut words = vec!["verify", "plan.json", "root.mav"];
        words.extend(more);
        run(&words)
    };
    let (code, shown, told) = verify(&[]);
    assert_eq!(code, 0, "{shown}{told}");
    // Another table is another spec, even one in which only a comment differs.
    assert_ne!(verify(&["--set", set]).0, 0);
    fs::write(at("motors/motor.csv"), format!("# changed\n{MADE_UP}")).unwrap();
    assert_ne!(verify(&[]).0, 0);
    // The program without planner reads the same numbers.
    fs::write(at("motors/motor.csv"), MADE_UP).unwrap();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let words = [at("plan.json"), at("root.mav")].map(|path| text(&path).to_string());
    let code = mavc_verify::program::run(words, &mut out, &mut err);
    assert_eq!(i32::from(code), 0, "{}", String::from_utf8_lossy(&err));
}

#[test]
fn an_override_of_a_compiled_spec_names_only_tables_that_were_read() {
    let written = quad("max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 8000 rpm", "; hover_power = 170 W");
    let error = spec(&written, "").set("vehicle.rotor.table = \"motor.csv\"").unwrap_err();
    assert_eq!(error.diagnostics[0].code, "mavc::file::missing");
    let again = spec(&quad(WITH_TABLE, ""), MADE_UP).set("vehicle.rotor.table = \"motor.csv\"").unwrap();
    assert!((again.model().vehicle.rotors[0].max_thrust() - 0.712 * 9.80665).abs() < 1e-12);
}

/// Numbers from a seed (xorshift).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n as u64) as usize
    }
}

/// What damages a table more than random bytes.
const TOKENS: [&[u8]; 20] = [
    b",",
    b";",
    b"\"",
    b"\n",
    b"\r",
    b"#",
    b"-",
    b"nan",
    b"1e308",
    b"1e-320",
    b"0",
    b"1,234",
    b"12,5",
    b"(",
    b"]",
    b"\xff",
    b"\0",
    "\u{202f}".as_bytes(),
    "µ".as_bytes(),
    b"Thrust (N)",
];

#[test]
fn damaged_tables_are_read_or_reported() {
    let text = quad(WITH_TABLE, "");
    let (mut read, mut reported) = (0, 0);
    let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
    for _ in 0..1000 {
        let mut table = MADE_UP.as_bytes().to_vec();
        for _ in 0..=numbers.below(4) {
            let at = numbers.below(table.len() + 1);
            let end = (at + numbers.below(12)).min(table.len());
            match numbers.below(4) {
                0 => drop(table.splice(at..end, [])),
                1 => drop(table.splice(at..at, [numbers.below(256) as u8])),
                2 => drop(table.splice(at..end.min(at + 1), TOKENS[numbers.below(TOKENS.len())].iter().copied())),
                _ => {
                    let copy = table[at..end].to_vec();
                    let to = numbers.below(table.len() + 1);
                    drop(table.splice(to..to, copy));
                }
            }
        }
        let compiled = compiled(&text, &table);
        let shown = render_human(&compiled.diagnostics, &compiled.files.sources, 80, false);
        assert_eq!(compiled.spec.is_none(), compiled.has_errors(), "{shown}");
        for diagnostic in &compiled.diagnostics {
            assert!(!diagnostic.message.is_empty() && shown.contains(diagnostic.code), "{shown}");
        }
        match compiled.spec {
            Some(spec) => {
                let vehicle = &spec.model().vehicle;
                let rotor = &vehicle.rotors[0];
                let power = vehicle.battery.as_ref().unwrap().hover_power;
                let all = [rotor.thrust_coefficient, rotor.drag_coefficient, rotor.max_speed, power];
                assert!(all.iter().all(|x| x.is_finite() && *x > 0.0), "{all:?}");
                read += 1;
            }
            None => reported += 1,
        }
    }
    assert!(read > 100 && reported > 100, "{read} read, {reported} reported");
}
