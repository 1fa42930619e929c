//! Double losses struck into hover, against the verdicts on what they leave.

use super::{quiet, sortie, staying, strike};
use crate::vehicles::{hexacopter, lost, octocopter, quadcopter};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::verdict::{Verdict, analyze};
use mavc::flight::fly;
use mavc::model::{Detection, Model};

/// All losses of two rotors.
fn with_pairs(mut model: Model) -> Model {
    let n = model.vehicle.rotors.len();
    let pairs = (1..=n).flat_map(|i| (i + 1..=n).map(move |j| [i, j]));
    model.modes = pairs.map(|pair| lost(&model, &pair)).collect();
    model
}

/// Verdict and margin: of the whole wrench, or without yaw where yaw is what is lost.
fn margin(model: &Model, mode: usize) -> (Verdict, f64) {
    let record = analyze(model, &AdmissibleSet::of_mode(model, mode));
    let margin = match record.verdict {
        Verdict::Controllable => record.acai,
        _ => record.acai_yaw_free,
    };
    (record.verdict, margin.unwrap_or(0.0))
}

/// Struck at 2 s into hover at 10 m; whether the vehicle is still there at 12 s.
fn survives(model: &Model, mode: usize) -> bool {
    let plan = staying([0.0, 0.0, 10.0], 0.0, 12.0);
    let f = fly(&sortie(model, &plan, &[strike(mode, 2.0)]), None);
    eprintln!("{} {} {:?} {:?} tilt {:.2} err {:.3} {:?}", model.vehicle.layout.as_ref().unwrap(), model.modes[mode].name, margin(model, mode), f.outcome, f.max_tilt, f.max_error, f.found);
    !f.outcome.is_lost()
}

fn told(model: Model) -> Model {
    let mut model = quiet(model);
    model.simulation.detection = Detection::After(0.1);
    model
}

#[test]
fn probe() {
    for layout in ["PPNNPPNN", "PNPNPNPN"] {
        let model = told(with_pairs(octocopter(layout)));
        for mode in 0..28 { survives(&model, mode); }
    }
    for layout in ["PNPNPN", "PPNNPN"] {
        let model = told(with_pairs(hexacopter(layout)));
        for mode in 0..15 { survives(&model, mode); }
    }
    let mut quad = told(quadcopter());
    quad.modes = (1..=4).map(|k| lost(&quad, &[k])).collect();
    for mode in 0..4 { survives(&quad, mode); }
    let model = with_pairs(octocopter("PPNNPPNN"));
    eprintln!("ESTIMATED");
    for mode in 0..28 { survives(&model, mode); }
}
