//! Rows of the actuation matrix that a fault makes nearly parallel, against geometry that can be done by hand.

use crate::vehicles::{hexacopter, lost, octocopter, paper_case};
use mavc::actuation::Actuation;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::diagnose::{PARALLEL_ROWS, diagnose};
use mavc::admissible::parallel::{least_angle, nearest_rows};
use mavc::admissible::verdict::{HoverVerdict, analyze};
use mavc::diagnostic::Severity;
use mavc::model::{Model, PlannerKind};
use nalgebra::{DVector, Matrix2, Vector2};

/// Six rotors, one at `lean` times its neighbours' drag: without rotors 1 and 4 yaw is nearly a multiple of roll.
fn leaning(lean: f64) -> Model {
    let mut model = hexacopter("PNPNPN");
    model.modes.push(lost(&model, &[1, 4]));
    model.vehicle.rotors[1].drag_coefficient *= lean;
    model
}

#[test]
fn the_angle_of_opposite_losses() {
    // Left are rotors 2, 3, 5, 6 with y = 1, -1, -1, 1 (times half the arm) and spins N, P, N, P.
    let exact = AdmissibleSet::of_mode(&leaning(1.0), 0);
    let rows = nearest_rows(&exact).unwrap();
    assert_eq!(exact.rank, 3);
    assert!(rows.axes[1] == "tau_z" && rows.angle < 1e-9, "{rows:?}");
    // tau_z = (lean, -1, 1, -1) and its line's angle to the torque with the same signs.
    for lean in [1.05, 1.2, 1.5, 3.0] {
        let model = leaning(lean);
        let set = AdmissibleSet::of_mode(&model, 0);
        let (one, other) = (DVector::from_vec(vec![lean, 1.0, 1.0, 1.0]), DVector::from_element(4, 1.0));
        let cosine: f64 = one.dot(&other) / (one.norm() * other.norm());
        let rows = nearest_rows(&set).unwrap();
        assert!((rows.angle - cosine.acos()).abs() < 1e-7, "{rows:?} {}", cosine.acos());
        assert_eq!(set.rank, 4);
    }
}

/// The angle is that of the rows of A whatever their units, and healthy rings are far from parallel.
#[test]
fn units_do_not_matter() {
    let model = octocopter("PPNNPPNN");
    let set = AdmissibleSet::healthy(&model);
    let a = Actuation::of(&model.vehicle).effectiveness;
    let mut least = f64::INFINITY;
    for i in 0..4 {
        for j in 0..i {
            let cosine = (a.row(i).dot(&a.row(j)) / (a.row(i).norm() * a.row(j).norm())).abs();
            least = least.min(cosine.min(1.0).acos());
        }
    }
    assert!((nearest_rows(&set).unwrap().angle - least).abs() < 1e-9);
    assert!(least > 2.0 * least_angle());
}

/// Two unit rows in a plane: errors below sin(phi/2) never make them dependent, that size does.
#[test]
fn the_threshold_is_where_a_tenth_can_make_rows_coincide() {
    let determinant = |phi: f64, size: f64, at: [f64; 2]| {
        let row = |angle: f64, error: f64| {
            Vector2::new(angle.cos(), angle.sin()) + size * Vector2::new(error.cos(), error.sin())
        };
        let (a, b) = (row(-phi / 2.0, at[0]), row(phi / 2.0, at[1]));
        Matrix2::from_columns(&[a, b]).determinant()
    };
    let turns = |k: i32| f64::from(k) * std::f64::consts::TAU / 360.0;
    let lowest = |phi: f64| {
        let all = (0..360).flat_map(|i| (0..360).map(move |j| [turns(i), turns(j)]));
        all.map(|at| determinant(phi, 0.1, at)).fold(f64::INFINITY, f64::min)
    };
    // Towards each other, the rows coincide at the threshold; a little farther apart nothing turns them round.
    let quarter = std::f64::consts::FRAC_PI_2;
    assert!(determinant(least_angle(), 0.1, [quarter, -quarter]).abs() < 1e-12);
    assert!(lowest(1.01 * least_angle()) > 0.0 && lowest(0.97 * least_angle()) < 0.0);
}

#[test]
fn plans_against_such_modes_are_warned_of() {
    // Drag 10 % up in front and 10 % down behind: equal thrusts still balance, and yaw is atan(0.1) off roll.
    let mut shape = leaning(1.0);
    for (k, rotor) in shape.vehicle.rotors.iter_mut().enumerate() {
        rotor.drag_coefficient *= [1.0, 1.1, 1.1, 1.0, 0.9, 0.9][k];
    }
    let angle = nearest_rows(&AdmissibleSet::of_mode(&shape, 0)).unwrap().angle;
    assert!((angle - 0.1_f64.atan()).abs() < 1e-9, "{angle}");
    let mut model = paper_case(PlannerKind::Rcp, &[0]);
    (model.vehicle, model.modes) = (shape.vehicle, shape.modes);
    let record = analyze(&model, &AdmissibleSet::of_mode(&model, 0));
    let found = diagnose(&model);
    assert_eq!((record.verdict, record.interior), (HoverVerdict::Controllable, true));
    assert_eq!(found.iter().map(|d| (d.code, d.severity)).collect::<Vec<_>>(), [(PARALLEL_ROWS, Severity::Warning)]);
    assert!(found[0].message.contains("tau_z") && found[0].message.contains("degrees"), "{}", found[0].message);
    // The paper's single losses are none of these.
    let model = paper_case(PlannerKind::Rcp, &[0, 1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(diagnose(&model), vec![]);
}
