//! `mavc emit mjcf`: the model of MuJoCo, read back as text. `benches/peers/mujoco_flights.py` loads and flies it.

use crate::cli::{err, mavc, out};
use mavc::Compiler;
use mavc::actuation::{Actuation, Wrench};

/// The elements of one kind, in order, as functions from the name of an attribute to its numbers.
fn elements<'a>(xml: &'a str, kind: &'a str) -> impl Iterator<Item = impl Fn(&str) -> Vec<f64> + 'a> + 'a {
    let is_one = move |line: &&str| line.trim_start().starts_with(&format!("<{kind} "));
    xml.lines().filter(is_one).map(|line| {
        move |attribute: &str| {
            let value = line.split(&format!(" {attribute}=\"")).nth(1).unwrap_or_else(|| panic!("{attribute}: {line}"));
            value.split('"').next().unwrap().split(' ').map(|x| x.parse().unwrap()).collect()
        }
    })
}

#[test]
fn the_actuators_of_every_shipped_vehicle_give_its_wrenches() {
    let mut count = 0;
    for entry in std::fs::read_dir("specs/vehicles").unwrap() {
        let path = entry.unwrap().path();
        let spec = Compiler::new().file(&path).unwrap().into_result().unwrap();
        let vehicle = &spec.model().vehicle;
        let ran = mavc(&["emit", "mjcf", path.to_str().unwrap()]);
        assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
        let xml = out(&ran);
        let inertial = elements(&xml, "inertial").next().unwrap();
        assert_eq!((inertial("mass"), inertial("diaginertia")), (vec![vehicle.mass], vehicle.inertia.to_vec()));
        let sites: Vec<Vec<f64>> = elements(&xml, "site").map(|site| site("pos")).collect();
        let actuation = Actuation::of(vehicle);
        let motors: Vec<_> = elements(&xml, "motor").collect();
        assert_eq!((sites.len(), motors.len()), (vehicle.rotors.len(), vehicle.rotors.len()));
        for (k, (site, motor)) in sites.iter().zip(&motors).enumerate() {
            let (gear, range) = (motor("gear"), motor("ctrlrange"));
            assert_eq!(gear[..5], [0.0, 0.0, 1.0, 0.0, 0.0]);
            // A thrust F e_z at the site r and the torque of the gear: F (1, y, -x, gear).
            for (thrust, expected) in [(range[1], actuation.full(k)), (range[0], actuation.idle(k))] {
                let wrench = Wrench::new(1.0, site[1], -site[0], gear[5]) * thrust;
                assert!((wrench - expected).amax() < 1e-12, "{path:?} {k}: {wrench} {expected}");
            }
        }
        count += 1;
    }
    assert!(count >= 9, "{count}");
}

#[test]
fn the_mission_is_drawn_and_names_are_escaped() {
    let spec = "/// Nothing special.
vehicle quad { layout = \"PNPN\"; arm = 0.2 m; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
    rotor { max_thrust = 6 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s } }
mission hop { start at [1, 2, 3] m  yaw 90 deg
    waypoint at [4, 2, 3] m }
simulate { rate = 500 Hz }
";
    let ran = crate::cli::mavc_with(&["emit", "mjcf", "-"], spec);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let xml = out(&ran);
    let option = elements(&xml, "option").next().unwrap();
    assert_eq!((option("timestep"), option("gravity")), (vec![0.002], vec![0.0, 0.0, -9.81]));
    let body = elements(&xml, "body").next().unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert_eq!(body("pos"), [1.0, 2.0, 3.0]);
    assert!(body("quat").iter().zip([half, 0.0, 0.0, half]).all(|(a, b)| (a - b).abs() < 1e-15));
    let waypoints: Vec<Vec<f64>> = elements(&xml, "site").take(2).map(|site| site("pos")).collect();
    assert_eq!(waypoints, [[1.0, 2.0, 3.0], [4.0, 2.0, 3.0]]);
    assert_eq!(elements(&xml, "geom").next().unwrap()("fromto"), [1.0, 2.0, 3.0, 4.0, 2.0, 3.0]);
    // As many elements are opened as closed.
    let opened = xml.matches('<').count() - xml.matches("</").count() - xml.matches("<!--").count();
    assert_eq!(opened, xml.matches("/>").count() + xml.matches("</").count(), "{xml}");
}
