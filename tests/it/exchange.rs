//! Plans and flights in the formats of other tools: frames, shapes and values against the trajectory.
//! `benches/readers/run` has them read by the tools themselves.

mod command;
mod flights;
mod formats;
mod frames;
mod refits;

use mavc::exchange::trajectory::{Choices, Format, Written, write};
use mavc::model::Model;
use mavc::motion::Trajectory;
use mavc::{PlanOutcome, Spec};
use std::sync::OnceLock;

/// A turn in wind, with the same drag along all axes.
const TURN: &str = r#"
vehicle quad {
    layout  = "PNPN"
    arm     = 0.17 m
    mass    = 0.5 kg
    drag    = 0.1 N*s/m
    inertia = [2.5e-3, 2.5e-3, 4.2e-3] kg*m^2
    rotor { max_thrust = 3.1 N; torque_per_thrust = 24 mm; max_speed = 1500 rad/s }
}
mission turn {
    start at [0, 0, 2] m  yaw 0 deg
    waypoint at [2, 1, 3] m  yaw 60 deg
    waypoint at [3, 3, 2] m  yaw 200 deg
    air { wind = [1, -2, 0] m/s }
}
faults { mode weak { rotor 1 reduced to 80 % } }
plan { planner = rip; time = 6 s; samples = 30 }
simulate { fault weak at 3 s; detection = estimator; duration = 4 s }
"#;

struct Planned {
    spec: Spec,
    trajectory: Trajectory,
}

impl Planned {
    fn model(&self) -> &Model {
        self.spec.model()
    }

    fn written(&self, format: Format) -> Written {
        self.write(&Choices { format, ..Choices::default() })
    }

    fn write(&self, choices: &Choices) -> Written {
        write(&self.trajectory, self.model(), choices).unwrap()
    }

    fn text(&self, format: Format) -> String {
        String::from_utf8(self.written(format).bytes).unwrap()
    }
}

/// The plan of a spec.
fn planned(text: &str) -> Planned {
    let spec = mavc::compile(text).into_result().unwrap();
    let planning = mavc::plan(&spec).unwrap();
    let PlanOutcome::Planned(plan) = planning.outcome() else { panic!("{:?}", planning.outcome()) };
    let trajectory = plan.trajectory.clone();
    Planned { spec, trajectory }
}

/// The plan of [`TURN`], made once.
fn turn() -> &'static Planned {
    static PLANNED: OnceLock<Planned> = OnceLock::new();
    PLANNED.get_or_init(|| planned(TURN))
}

/// The columns of a table by name, row by row; empty cells are NaN.
fn table(text: &str) -> (Vec<&str>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let cell = |cell: &str| if cell.is_empty() { f64::NAN } else { cell.parse().unwrap() };
    let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(cell).collect()).collect();
    assert!(rows.iter().all(|row| row.len() == names.len()));
    (names, rows)
}

/// The values in the columns of these names.
fn pick<const N: usize>(names: &[&str], row: &[f64], wanted: [&str; N]) -> [f64; N] {
    wanted.map(|name| row[names.iter().position(|n| *n == name).unwrap_or_else(|| panic!("{name}"))])
}

fn close(a: &[f64], b: &[f64], tolerance: f64, what: &str) {
    assert_eq!(a.len(), b.len());
    let worst = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst <= tolerance, "{what}: {worst} beyond {tolerance}: {a:?} {b:?}");
}
