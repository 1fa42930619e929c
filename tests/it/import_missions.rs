//! Missions of ground stations: read as specs, checked at their own items, written, and read back.
//! `benches/readers/missions.py` has the written ones read by the tools themselves.

mod checked;
mod flown;
mod hostile;
mod places;
mod read;
mod written;

use mavc::import::Imported;
use mavc::import::mission::import;
use mavc::{Compiler, Severity};

/// A vehicle with drag, so that it has a largest speed.
const HEXA: &str = r#"vehicle hexa {
    layout           = "PPNNPN"
    arm              = 30 cm
    propeller_radius = 12 cm
    mass             = 3.4 kg
    drag             = 1.6 N*s/m
    inertia          = [0.05, 0.05, 0.09] kg*m^2
    rotor { max_thrust = 13 N; torque_per_thrust = 17 mm; max_speed = 7500 rpm }
}
"#;

/// A take-off, a hold with a yaw, a camera, another speed, and back home; two fences.
const PLAN: &str = include_str!("../../examples/field.plan");

/// A take-off, a yaw to the north, a spline and a landing.
const WPL: &str = "QGC WPL 110\r
0\t1\t0\t16\t0\t0\t0\t0\t47.3977507\t8.5456075\t488.9\t1\r
1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\r
2\t0\t3\t16\t2\t0\t0\t360\t47.398\t8.546\t20\t1\r
3\t0\t0\t82\t0\t0\t0\t0\t47.3985\t8.546\t510\t1\r
4\t0\t3\t21\t0\t0\t0\t0\t47.3985\t8.546\t0\t1\r
";

fn read(name: &str, text: &str) -> Imported {
    import(name, text.as_bytes(), None)
}

/// The spec of a file that has one; it compiles with [`HEXA`], and its layout is that of `mavc fmt`.
fn spec(name: &str, text: &str) -> String {
    let imported = read(name, text);
    let spec = imported.text.unwrap_or_else(|| panic!("{:#?}", imported.diagnostics));
    let compiled = Compiler::new().text("joined.mav", format!("{spec}{HEXA}").as_bytes());
    assert!(!compiled.has_errors(), "{}", compiled.render());
    spec
}

/// The codes of the errors and warnings of a file, each with its message.
fn found(text: &str) -> Vec<(&'static str, Severity, String)> {
    let imported = read("a.plan", text);
    let within = |d: &mavc::Diagnostic| {
        d.span.start <= d.span.end && d.span.end as usize <= imported.sources.get(d.span.file).text.len()
    };
    assert!(imported.diagnostics.iter().all(within), "{:?}", imported.diagnostics);
    imported.diagnostics.into_iter().map(|d| (d.code, d.severity, d.message)).collect()
}
