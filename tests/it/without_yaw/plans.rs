//! Plans against modes without yaw: rows of cores against brute force over headings and spins, the turning of a motion
//! against differences, plans in both models with their certificates, and changed certificates.

use super::without;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::SetRow;
use mavc::admissible::without_yaw::early::Begins;
use mavc::admissible::without_yaw::planned::{CoreRow, PlannedCore, Provision, Turning};
use mavc::certificate::{Certificate, Claim, PlanClaim};
use mavc::model::{Environment, Model, Spread, YawDrag};
use mavc::motion::turning::TurningMap;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, X, Y, YAW, Z};
use mavc::spec::Spec;
use mavc::{certify, compile, plan, verify};
use nalgebra::{Matrix3, Vector3, Vector4};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

fn core(model: &Model) -> PlannedCore {
    let healthy = AdmissibleSet::healthy(model);
    match Provision::of(model, &AdmissibleSet::of_mode(model, 0), &healthy) {
        Provision::WithoutYaw(core) => core,
        other => panic!("{other:?}"),
    }
}

/// A turning with this thrust and torque rho if nothing else turns: `s x s''` alone.
fn turning(thrust: f64, swing: f64) -> Turning {
    Turning::from([thrust, swing, 0.0, 0.0, 0.0, 0.0])
}

/// Just inside every row there is, for every heading, a yaw torque in the core's range with which the wrench is in the
/// set; just outside of some row there is a heading without one.
#[test]
fn rows_are_what_every_heading_leaves() {
    for (kind, layout, rotors) in [
        ("hexa", "PNPNPN", &[1][..]),
        ("hexa", "PNPNPN", &[1, 3]),
        ("octo", "PPNNPPNN", &[1, 2]),
        ("hexa", "PPNNPN", &[6]),
    ] {
        let model = without(kind, layout, rotors);
        let (core, set) = (core(&model), AdmissibleSet::of_mode(&model, 0));
        let [least, most] = core.yaw_torque_n_m;
        let yaw = Vector4::new(0.0, 0.0, 0.0, 1.0);
        let exists = |thrust: f64, torque: f64, heading: f64| {
            let w = Vector4::new(thrust, torque * heading.cos(), torque * heading.sin(), 0.0);
            let chord = set.polytope.chord(&w, &yaw, 1e-9);
            chord.is_some_and(|(low, high)| low.max(least) <= high.min(most) + 1e-9)
        };
        let everywhere =
            |thrust: f64, torque: f64| (0..720).all(|i| exists(thrust, torque, f64::from(i).to_radians() / 2.0));
        let inertia = model.vehicle.inertia[0];
        let worst = |thrust: f64, torque: f64| {
            let at = turning(thrust, torque / inertia);
            let of = |row: &SetRow| row.normal[0] * at[0] - row.offset + row.of_core(Some(&at));
            core.rows.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
        };
        let mut seen = [0, 0];
        for i in 1..24 {
            let thrust = 1.2 * f64::from(i) / 24.0 * set.hover[0] * 2.0;
            let (mut low, mut high) = (0.0, 5.0);
            if worst(thrust, 0.0) >= 0.0 {
                seen[0] += 1;
                assert!(!everywhere(thrust, 1e-3), "{layout} {rotors:?} {thrust}");
                continue;
            }
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if worst(thrust, middle) <= 0.0 { low = middle } else { high = middle }
            }
            seen[1] += 1;
            assert!(everywhere(thrust, low - 1e-6), "{layout} {rotors:?} {thrust} {low}");
            assert!(!everywhere(thrust, low + 2e-4), "{layout} {rotors:?} {thrust} {low}");
        }
        assert!(seen[0] > 0 && seen[1] > 3, "{seen:?}");
        // The body cannot leave its rates: at either end the drag is at least the torque.
        let drag = YawDrag { linear: 2.75e-3, ..model.vehicle.yaw_drag.unwrap() };
        let [slow, fast] = core.spin_rad_s.map(|rate| drag.torque(rate));
        assert!(slow <= least + 1e-12 && fast >= most - 1e-12, "{slow} {least} {fast} {most}");
    }
}

fn within(random: &mut Pcg64Mcg, most: f64) -> f64 {
    most * (2.0 * (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 - 1.0)
}

/// A smooth motion by its derivatives at t = 0: x, y and z are polynomials of degree 4 and yaw one of degree 2.
fn state(random: &mut Pcg64Mcg) -> NodeState {
    let mut state = NodeState::default();
    for axis in [X, Y, Z] {
        state[axis][1..].iter_mut().for_each(|d| *d = within(random, 4.0));
    }
    state[YAW][..3].iter_mut().for_each(|d| *d = within(random, 1.0));
    state
}

/// The thrust over mass of the motion after t s.
fn thrust(state: &NodeState, t: f64) -> Vector3<f64> {
    let at = |axis: usize| state[axis][2] + state[axis][3] * t + state[axis][4] * t * t / 2.0;
    Vector3::new(at(X), at(Y), at(Z) + 9.81)
}

/// The torque of a body that turns at the rate r about its thrust: differences of its rotation matrix, and Euler's
/// equation. Its norm across the thrust is the row's rho, whatever the heading.
#[test]
fn the_torque_of_a_spinning_body_is_the_rows() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    for _ in 0..60 {
        let (state, heading, spin) = (state(&mut random), within(&mut random, 3.0), within(&mut random, 40.0));
        let frame = |t: f64| {
            let s = thrust(&state, t).normalize();
            let right = s.cross(&Vector3::x()).normalize();
            Matrix3::from_columns(&[right.cross(&s), right, s])
        };
        let h = 1e-4;
        let skew = |of: &dyn Fn(f64) -> Matrix3<f64>, t: f64| {
            let change = of(t).transpose() * (of(t + h) - of(t - h)) / (2.0 * h);
            Vector3::new(change[(2, 1)], change[(0, 2)], change[(1, 0)])
        };
        let own = |t: f64| skew(&frame, t).z;
        let (now, slope) = (own(0.0), (own(h) - own(-h)) / (2.0 * h));
        let body = |t: f64| {
            let angle = heading + (spin - now) * t - slope * t * t / 2.0;
            frame(t) * nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner()
        };
        let w = skew(&body, 0.0);
        let change = (skew(&body, 5.0 * h) - skew(&body, -5.0 * h)) / (10.0 * h);
        let inertia = Vector3::new(0.017, 0.017, 0.031);
        let torque = inertia.component_mul(&change) + w.cross(&inertia.component_mul(&w));
        let model = without("hexa", "PNPNPN", &[1]);
        let turning = WrenchModel::Exact.turning(&model.vehicle, &model.environment(), &state);
        let row = CoreRow { torque: 1.0, inertia: 0.017, unevenness: 0.0, momentum: 0.031 * spin, spin };
        let (across, rho) = (torque.xy().norm(), row.share(&turning));
        assert!((w.z - spin).abs() < 1e-3 && (across - rho).abs() < 2e-3 * (1.0 + rho), "{across} {rho}");
        // Unequal moments: never more than the row says, and as much at some heading.
        let uneven = Vector3::new(0.019, 0.015, 0.031);
        let torque = uneven.component_mul(&change) + w.cross(&uneven.component_mul(&w));
        let bound = CoreRow { unevenness: 0.002, ..row }.share(&turning);
        assert!(torque.xy().norm() < bound + 2e-3 * (1.0 + bound), "{} {bound}", torque.xy().norm());
    }
}

/// The exact model's linearisation against differences, with drag and without, and the models about hover near hover.
#[test]
fn the_turning_is_linearised() {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut model = without("hexa", "PNPNPN", &[1]);
    for drag in [0.0, 0.4] {
        model.vehicle.drag = [drag; 3];
        let environment = Environment { wind: [2.0, -1.0, 0.5], ..model.environment() };
        for _ in 0..20 {
            let at = state(&mut random);
            let of = |s: &NodeState| WrenchModel::Exact.turning(&model.vehicle, &environment, s);
            let map: TurningMap = WrenchModel::Exact.turning_map(&model.vehicle, &environment, &at);
            assert!((map.at(&at) - of(&at)).amax() < 1e-9 * (1.0 + of(&at).amax()));
            let mut change = state(&mut random);
            change.iter_mut().flatten().for_each(|d| *d *= 1e-5);
            let moved = |sign: f64| -> NodeState {
                std::array::from_fn(|axis| std::array::from_fn(|i| at[axis][i] + sign * change[axis][i]))
            };
            let by_differences = (of(&moved(1.0)) - of(&moved(-1.0))) / 2.0;
            let by_map = (map.at(&moved(1.0)) - map.at(&moved(-1.0))) / 2.0;
            assert!((by_differences - by_map).amax() < 1e-6 * (1e-3 + by_map.amax()), "{by_differences} {by_map}");
        }
    }
    model.vehicle.drag = [0.0; 3];
    let mut small = state(&mut random);
    small.iter_mut().flatten().for_each(|d| *d *= 1e-4);
    small[YAW][0] = 0.0;
    let [exact, hover] = [WrenchModel::Exact, WrenchModel::HoverFollowing]
        .map(|wrench| wrench.turning(&model.vehicle, &model.environment(), &small));
    assert!((exact - hover).amax() < 1e-6, "{exact} {hover}");
}

/// A hexacopter PNPNPN with 20 samples against the loss of rotors 1 and 2.
fn spec(more: &str) -> Spec {
    let text = format!(
        "vehicle hexa {{ layout = \"PNPNPN\"; arm = 0.211 m; mass = 1.54 kg; inertia = [0.0168, 0.0168, 0.0308] kg*m^2
             yaw_drag = 2.75e-3 N*m*s/rad
             rotor {{ thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }} }}
         faults {{ mode one {{ rotor 1 lost }}
                   mode two {{ rotor 2 lost }} }}
         mission dash {{ start at [0, 0, 30] m yaw 20 deg
             waypoint at [12, 4, 31] m yaw 20 deg
             limits {{ speed <= 8 m/s; tilt <= 30 deg }} }}
         plan {{ planner = rcp; samples = 20; reserve = 10 %; {more} }}"
    );
    compile(&text).into_result().unwrap_or_else(|e| panic!("{e}"))
}

fn changed(certificate: &Certificate, change: impl Fn(&mut PlanClaim)) -> Vec<u8> {
    let mut changed = certificate.clone();
    let Claim::Plan(claim) = &mut changed.claim else { panic!("no plan") };
    change(claim);
    serde_json::to_vec(&changed).unwrap()
}

/// Plans in both models are found and accepted, with the cores proved at every instant, and no changed record of a spin
/// passes.
#[test]
fn plans_are_certified() {
    for (model, time) in [("hover", "4.6 s"), ("exact", "4.6 s")] {
        let spec = spec(&format!("model = {model}; time = {time}"));
        let planning = plan(&spec).unwrap();
        let found = planning.plan().unwrap_or_else(|| panic!("{model}: {:?}", planning.verdict()));
        assert!(found.outside.iter().all(|o| o.last.is_none() && o.max_violation < 1e-4), "{model}");
        let certificate = certify(&spec, &planning).unwrap();
        let accepted = verify(&changed(&certificate, |_| {}), &spec).unwrap();
        assert!(accepted.weaker.is_empty(), "{:?}", accepted.weaker);
        let statements: Vec<&str> = accepted.shown.iter().map(|s| s.statement.as_str()).collect();
        assert_eq!(statements.iter().filter(|s| s.contains("inside the core of")).count(), 2, "{statements:?}");
        let rejected = |why: &str, change: &dyn Fn(&mut PlanClaim)| {
            let refused = verify(&changed(&certificate, change), &spec);
            assert!(refused.is_err(), "{model}: {why}");
        };
        // A much narrower range leaves hardly a yaw torque, and a wider one has larger momenta.
        rejected("narrower", &|claim| claim.without_yaw[0].spin_rad_s = [0.0, 0.5]);
        rejected("wider", &|claim| claim.without_yaw[0].spin_rad_s = [-400.0, 400.0]);
        rejected("without zero", &|claim| claim.without_yaw[0].spin_rad_s = [1.0, 70.0]);
        rejected("not a number", &|claim| claim.without_yaw[0].spin_rad_s = [0.0, f64::MAX]);
        rejected("unknown", &|claim| claim.without_yaw[0].mode = "three".into());
        rejected("left out", &|claim| drop(claim.without_yaw.remove(1)));
        // A jerkier motion: the torque of a spinning body is mostly H s'.
        rejected("changed", &|claim| claim.motion.x[5][3] += 5.0);
    }
}

/// RSP selects rows of cores like facets.
#[test]
fn rsp_selects_rows_of_cores() {
    let spec = spec("model = exact; time = 4.25 s").set("plan.planner=rsp").unwrap();
    let planning = plan(&spec).unwrap();
    assert!(planning.plan().is_some(), "{:?}", planning.verdict());
    assert!(planning.comparison().selected.iter().any(|row| row.core.is_some()));
    let certificate = certify(&spec, &planning).unwrap();
    let accepted = verify(&changed(&certificate, |_| {}), &spec).unwrap();
    assert!(accepted.shown.iter().any(|s| s.statement.contains("selected rows of the core of")));
}

/// An interval of `rotor_inertia` counts by its largest value, in the planner's rows and in the checker's.
#[test]
fn the_largest_inertia_of_an_interval_counts() {
    let with = |model: &Model, inertia: f64, spread: Spread| {
        let mut model = model.clone();
        for rotor in &mut model.vehicle.rotors {
            (rotor.inertia, rotor.inertia_spread) = (inertia, spread);
        }
        model
    };
    let wide = Spread { low: 0.5, high: 1.5 };
    let bare = without("hexa", "PNPNPN", &[1]);
    let [of_interval, of_largest, of_middle] =
        [(2e-5, wide), (3e-5, Spread::NONE), (2e-5, Spread::NONE)].map(|(inertia, of)| core(&with(&bare, inertia, of)));
    // 1.5 times 2e-5 is 3e-5 up to rounding.
    for (a, b) in of_interval.rows.iter().zip(&of_largest.rows) {
        assert!((a.offset - b.offset).abs() < 1e-9 && (a.normal - b.normal).amax() < 1e-9, "{a:?} {b:?}");
        let [a, b] = [a, b].map(|row| row.core.map(|core| core.momentum));
        assert!(a.zip(b).is_none_or(|(a, b)| (a - b).abs() < 1e-9), "{a:?} {b:?}");
    }
    let momenta = |core: &PlannedCore| core.rows.iter().filter_map(|row| row.core).map(|core| core.momentum).collect();
    let [largest, middle]: [Vec<f64>; 2] = [momenta(&of_largest), momenta(&of_middle)];
    assert!(largest.iter().zip(&middle).any(|(a, b)| (a - b).abs() > 1e-9), "{largest:?} {middle:?}");

    let spec = spec("model = hover; time = 4.6 s");
    let certificate = certify(&spec, &plan(&spec).unwrap()).unwrap();
    let decided = |inertia: f64, spread: Spread| {
        let model = with(spec.model(), inertia, spread);
        verify::decide(&certificate, &model, verify::Settings::default()).map_err(|refusal| refusal.sentence())
    };
    assert!(decided(1e-9, wide).is_ok());
    let high = Spread { low: 0.5, high: 1e6 };
    let [interval, largest] = [decided(1e-9, high), decided(1e-3, Spread::NONE)];
    assert!(interval.is_err() && largest.is_err() && decided(1e-9, Spread::NONE).is_ok(), "{interval:?} {largest:?}");
}

/// Just after a fault the spin is slow: rows for a short motion reach only as far as yaw torques and the coupling of
/// turns can bring it, and never less far; where that leaves the core's own rates, they are the core's own.
#[test]
fn rows_for_a_short_motion_reach_as_far_as_the_spin() {
    let model = without("hexa", "PNPNPN", &[1]);
    let (uneven, core) = {
        let mut uneven = model.clone();
        uneven.vehicle.inertia[0] *= 1.15;
        let core = core(&uneven);
        (uneven, core)
    };
    let [jx, jy, jz] = uneven.vehicle.inertia;
    let (begins, lasts) = (Begins { spin: 0.3, turning: 2.5 }, 0.5);
    let rows = core.rows_for(&uneven, begins, lasts).expect("inside the core's rates");
    let bound = rows.iter().filter_map(|row| row.core).find(CoreRow::bounds_turning).unwrap();
    let fastest = 1.0 / bound.torque;
    assert!(fastest >= begins.turning, "{fastest}");
    let spins = |rows: &[SetRow]| {
        let cores = rows.iter().filter_map(|row| row.core).filter(|core| core.torque > 0.0 && !core.bounds_turning());
        cores.map(|core| core.spin).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], r| [a.min(r), b.max(r)])
    };
    let [slowest, most] = spins(&rows);
    assert!(most < 0.2 * spins(&core.rows)[1], "{most} of {:?}", spins(&core.rows));
    // Momenta follow the spin: without rotors' inertia, H = Jz r.
    for row in rows.iter().filter_map(|row| row.core).filter(|core| core.torque > 0.0 && !core.bounds_turning()) {
        assert!((row.momentum - jz * row.spin).abs() < 1e-12, "{row:?}");
    }
    // Euler's equation with yaw torques at either end, or drawn, and turns at the bound in every direction.
    let [drag, _] = uneven.vehicle.yaw_drag.unwrap().ends();
    let [least, greatest] = core.yaw_torque_n_m;
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let mut share = || f64::from(random.next_u32()) / f64::from(u32::MAX);
    let mut reached = [f64::INFINITY, f64::NEG_INFINITY];
    for case in 0..300 {
        let (steps, mut spin) = (500, begins.spin);
        for _ in 0..steps {
            let [torque, angle] = match case {
                0 => [greatest, 0.25],
                1 => [least, 0.75],
                _ => [least + share() * (greatest - least), share()],
            };
            let coupling = (jx - jy) * 0.5 * fastest.powi(2) * (std::f64::consts::TAU * angle).sin();
            spin += (torque - spin.signum() * drag.torque(spin).abs() + coupling) / jz * lasts / f64::from(steps);
            reached = [reached[0].min(spin), reached[1].max(spin)];
        }
    }
    assert!(slowest <= reached[0] && reached[1] <= most, "{reached:?} of {slowest} to {most}");
    assert!(reached[1] > 0.8 * most, "{reached:?} of {most}");
    assert!(core.rows_for(&uneven, begins, 1e3).is_none());
    assert!(core.rows_for(&uneven, Begins { spin: 1e3, ..begins }, lasts).is_none());
}
