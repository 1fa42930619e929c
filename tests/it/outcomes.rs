//! The scale of outcomes, and the first line of every answer.

use mavc::admissible::outcome::Outcome;
use mavc::report::headline::{by_rotors, headline};

/// A vehicle with these fields beside those of a ring with arms of 30 cm, and these fault modes.
fn spec(layout: &str, mass: &str, rotor: &str, more: &str, faults: &str) -> mavc::Spec {
    let text = format!(
        "vehicle v {{
            layout = \"{layout}\"; arm = 30 cm; mass = {mass}; inertia = [0.05, 0.05, 0.09] kg*m^2; {more}
            rotor {{ {rotor}; max_speed = 7500 rpm }}
        }}
        faults {{ {faults} }}"
    );
    mavc::compile(&text).into_result().unwrap_or_else(|e| panic!("{e}"))
}

const ROTOR: &str = "max_thrust = 13 N; torque_per_thrust = 17 mm";
const DRAG: &str = "yaw_drag = 20e-3 N*m*s/rad";

fn line(spec: &mavc::Spec) -> String {
    headline(spec.model(), &mavc::analyze(spec))
}

fn outcomes(spec: &mavc::Spec) -> Vec<Outcome> {
    mavc::analyze(spec).iter().skip(1).map(|mode| mode.outcome).collect()
}

#[test]
fn a_headline_counts_modes_of_each_kind() {
    let hexa = |faults: &str| line(&spec("PPNNPN", "3.4 kg", ROTOR, "", faults));
    let every = "every 1 rotor lost as M";
    assert_eq!(hexa(every), "v: any single rotor lost: 4 of 6 full control, 2 of 6 fly on, heading not held");
    assert_eq!(hexa(""), "v: full control without a fault; no fault modes declared");
    assert_eq!(hexa("mode a { rotor 1 lost }"), "v: a (one rotor lost): full control");
    assert_eq!(hexa("mode a { rotor 5 lost }"), "v: a (one rotor lost): flies on, heading not held");
    assert_eq!(
        hexa("mode a { rotor 1 lost }; mode b { rotor 5 lost }"),
        "v: 2 single losses: 1 of 2 full control, 1 of 2 flies on, heading not held"
    );
    // The same loss twice is not every loss.
    let twice = "every 1 rotor lost as M; mode again { rotor 1 lost }";
    assert_eq!(hexa(twice), "v: 7 single losses: 5 of 7 full control, 2 of 7 fly on, heading not held");
    let mixed = "mode gone { rotors [1, 2, 3, 4, 5, 6] lost }
        mode weak { rotor 1 reduced to 60 % }; mode weaker { rotor 2 reduced to 50 % }
        mode jam { rotor 2 stuck at 50 % }; mode both { rotor 1 lost; rotor 2 reduced to 90 % }
        mode nothing { rotor 1 reduced to 100 % }";
    assert_eq!(
        hexa(mixed),
        "v: gone (6 rotors lost): lost; 2 modes of reduced thrust: 2 of 2 full control; jam (stuck): full control; \
         both (mixed faults): full control; nothing (nothing fails): full control"
    );
    let one_way = |faults: &str| line(&spec("PPPPPN", "3.4 kg", ROTOR, "", faults));
    assert_eq!(one_way(""), "v: without a fault: flies on, heading not held; no fault modes declared");
    assert_eq!(
        one_way("mode a { rotor 1 lost }"),
        "v: without a fault: flies on, heading not held; a (one rotor lost): flies on, heading not held"
    );
    let doubles = line(&spec("PPNNPPNN", "3.4 kg", ROTOR, "", "every 1 rotor lost as M; every 2 rotors lost as D"));
    assert!(doubles.starts_with("v: any single rotor lost: 8 of 8 full control; any two rotors lost: "), "{doubles}");
}

/// Where the name of a mode does not have the numbers of its rotors, they are listed.
#[test]
fn rotors_of_named_modes_are_listed() {
    let spec = spec(
        "PPNNPN",
        "3.4 kg",
        ROTOR,
        "",
        "every 2 rotors lost as M; mode arm { rotors [4, 2] lost }; mode b2_and_4 { rotors [2, 4] lost }
        mode weak { rotor 3 reduced to 60 % }; mode jam { rotors [1, 6] stuck at 50 % }
        mode ice { rotors [1, 2, 3, 4, 5, 6] reduced to 80 % }; mode both { rotor 1 lost; rotor 2 reduced to 90 % }",
    );
    let listed: Vec<String> =
        spec.model().modes.iter().filter_map(|mode| Some(format!("{}: {}", mode.name, by_rotors(mode)?))).collect();
    assert_eq!(
        listed,
        ["arm: rotors 2, 4 lost", "weak: rotor 3 reduced to 60 %", "jam: rotors 1, 6 stuck at 50 %"].map(String::from)
    );
}

/// Rings whose outcomes are known from theory: PNPNPN keeps roll, pitch and thrust after a loss and has no margin of
/// yaw (Du and Quan: uncontrollable); a quadcopter must spin (Mueller and D'Andrea), and without the drag of its
/// spin nothing says how fast; the two rotors that are left on one arm cannot steer about it.
#[test]
fn outcomes_are_those_of_theory() {
    let of = |layout: &str, mass: &str, more: &str, faults: &str| outcomes(&spec(layout, mass, ROTOR, more, faults));
    let single = "every 1 rotor lost as M";
    assert_eq!(of("PNPNPN", "3.4 kg", "", single), [Outcome::FliesOn; 6]);
    assert_eq!(of("PNPN", "2 kg", "", single), [Outcome::Undecided; 4]);
    assert_eq!(of("PNPN", "2 kg", DRAG, single), [Outcome::Caught; 4]);
    // Half the thrust is left.
    assert_eq!(of("PNPN", "2.7 kg", DRAG, single), [Outcome::Lost; 4]);
    assert_eq!(of("PNPNPNPN", "3.4 kg", "", single), [Outcome::FullControl; 8]);
    // Only two opposite rotors are left, which turn against each other in a hexacopter of this layout.
    let two = "mode two { rotors [2, 3, 5, 6] lost }";
    assert_eq!(of("PNPNPN", "2 kg", DRAG, two), [Outcome::NoMargin]);
    assert_eq!(of("PNPNPN", "3.4 kg", DRAG, two), [Outcome::Lost]);
    // Two neighbours cannot hover.
    assert_eq!(of("PNPN", "1 kg", DRAG, "mode side { rotors [1, 2] lost }"), [Outcome::Lost]);
}

/// An outcome holds for every vehicle of the intervals, or it is undecided.
#[test]
fn outcomes_of_intervals() {
    let of = |layout: &str, mass: &str, rotor: &str, more: &str, faults: &str| {
        outcomes(&spec(layout, mass, rotor, more, faults))[0]
    };
    let one = "mode a { rotor 1 lost }";
    assert_eq!(of("PPNNPN", "3.4 kg +- 5 %", ROTOR, "", one), Outcome::FullControl);
    // Full control ends at 5.30 kg.
    assert_eq!(of("PPNNPN", "5.2 kg +- 5 %", ROTOR, "", one), Outcome::Undecided);
    assert_eq!(of("PNPNPN", "3.4 kg +- 5 %", ROTOR, "", one), Outcome::FliesOn);
    // Unequal torques per thrust may leave a margin of yaw.
    let torques = "max_thrust = 13 N; torque_per_thrust = 17 mm +- 5 %";
    assert_eq!(of("PNPNPN", "3.4 kg", torques, "", one), Outcome::Undecided);
    // Two opposite rotors carry 2.65 kg.
    assert_eq!(of("PNPN", "2 kg +- 5 %", ROTOR, DRAG, one), Outcome::Caught);
    assert_eq!(of("PNPN", "2.6 kg +- 5 %", ROTOR, DRAG, one), Outcome::Undecided);
    assert_eq!(of("PNPN", "2.7 kg +- 1 %", ROTOR, DRAG, one), Outcome::Lost);
    let thrusts = "max_thrust = 13 N +- 5 %; torque_per_thrust = 17 mm";
    assert_eq!(of("PNPN", "2.6 kg", thrusts, DRAG, one), Outcome::Undecided);
    let two = "mode two { rotors [2, 3, 5, 6] lost }";
    assert_eq!(of("PNPNPN", "2 kg +- 5 %", ROTOR, DRAG, two), Outcome::NoMargin);
    assert_eq!(of("PNPNPN", "2.6 kg +- 5 %", ROTOR, DRAG, two), Outcome::Undecided);
}

/// A spin beyond the gyroscope loses the vehicle; where only the smaller drag leads beyond it, that is undecided.
#[test]
fn outcomes_consider_the_gyroscope() {
    let model = |drag: &str| {
        let drag = format!("yaw_drag = {drag}");
        spec("PNPN", "2 kg", ROTOR, &drag, "mode a { rotor 1 lost }").model().clone()
    };
    let rate = |drag: &str| mavc::flight::equilibrium::settled_spins(&model(drag))[0].spin_rad_s.abs();
    let of = |drag: &str, range: f64| {
        let mut model = model(drag);
        model.simulation.gyroscope_range = range;
        mavc::flight::equilibrium::analyze_each(&model)[1].outcome
    };
    let [slow, fast] = ["6e-3 N*m*s/rad", "2e-3 N*m*s/rad"].map(rate);
    assert!(slow < 0.7 * fast, "{slow} {fast}");
    assert_eq!(of("6e-3 N*m*s/rad", 1.01 * slow), Outcome::Caught);
    // No component of a vector is larger than the vector, and one is at least its 0.577-th part.
    assert_eq!(of("6e-3 N*m*s/rad", 0.57 * slow), Outcome::Lost);
    assert_eq!(of("4e-3 N*m*s/rad +- 50 %", 1.01 * fast), Outcome::Caught);
    assert_eq!(of("4e-3 N*m*s/rad +- 50 %", 0.57 * slow), Outcome::Lost);
    assert_eq!(of("4e-3 N*m*s/rad +- 50 %", 1.01 * slow), Outcome::Undecided);
}
