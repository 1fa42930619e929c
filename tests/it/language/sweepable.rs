//! The column `sweepable` against an experiment: each field is changed and left out, and the analyses are compared.

use mavc::language::{Group, Takes, sweepable};
use mavc::{Spec, analyze, compile};
use std::collections::BTreeSet;

/// A value for every field that takes a number and that the path of an override reaches, for a ring of four rotors in
/// wind.
const VALUES: [(Group, &[(&str, &str)]); 6] = [
    (Group::Top, &[("gravity", "9.81 m/s^2")]),
    (
        Group::Vehicle,
        &[
            ("first", "10 deg"),
            ("arm", "0.25 m"),
            ("mass", "1 kg"),
            ("propeller_radius", "0.1 m"),
            ("drag", "0.3 N*s/m"),
            ("yaw_drag", "3e-3 N*m*s/rad"),
            ("yaw_drag_quadratic", "1e-5 N*m*s^2/rad^2"),
            ("size", "0.4 m"),
        ],
    ),
    (
        Group::Rotor,
        &[
            ("thrust_coefficient", "9e-6 N*s^2/rad^2"),
            ("max_thrust", "7 N"),
            ("drag_coefficient", "1.5e-7 N*m*s^2/rad^2"),
            ("torque_per_thrust", "16 mm"),
            ("min_speed", "200 rad/s"),
            ("min_thrust", "5 %"),
            ("max_speed", "880 rad/s"),
            ("time_constant", "30 ms"),
            ("rotor_inertia", "4e-5 kg*m^2"),
        ],
    ),
    (
        Group::Battery,
        &[
            ("capacity", "5 A*h"),
            ("voltage", "22.2 V"),
            ("hover_power", "220 W"),
            ("keep", "20 %"),
            ("thrust_at_empty", "90 %"),
        ],
    ),
    (Group::Parts, &[("motor_mass", "0.15 kg"), ("arm_mass", "0.1 kg")]),
    (Group::Air, &[("gusts", "1 m/s"), ("density", "1.15 kg/m^3"), ("altitude", "500 m")]),
];

/// Shares of its value that a field takes in the experiment.
const SHARES: [f64; 4] = [0.5, 0.8, 1.25, 2.0];

/// The spec with every field of [`VALUES`] except those in `without` and the rivals of `field` and of earlier fields;
/// `field` has this share of its value.
fn spec(field: (Group, &str), share: f64, without: &[&str]) -> Option<Spec> {
    // Parts decide only what is not measured.
    let without = &[without, if field.0 == Group::Parts { &["mass"] } else { &[] }].concat();
    let block = |group: Group| {
        let values = VALUES.iter().find(|(of, _)| *of == group).unwrap().1;
        let own = values.iter().filter(|(name, _)| (group, *name) == field);
        let mut written: Vec<(&str, String)> = Vec::new();
        for (name, value) in own.chain(values) {
            let is_taken =
                |(other, _): &(&str, String)| other == name || group.rivals(name).any(|rival| rival == *other);
            if without.contains(name) || written.iter().any(is_taken) {
                continue;
            }
            let (number, unit) = value.split_once(' ').unwrap();
            let share = if (group, *name) == field { share } else { 1.0 };
            written.push((*name, format!("{name} = {} {unit}\n", share * number.parse::<f64>().unwrap())));
        }
        written.into_iter().map(|(_, line)| line).collect::<String>()
    };
    let text = format!(
        "{}vehicle v {{\nlayout = \"PNPN\"\ninertia = [0.03, 0.05, 0.07] kg*m^2\n{}\
         rotor {{\n{}}}\nbattery {{\n{}}}\nparts {{\n{}}}\n}}\n\
         faults {{ mode one {{ rotor 1 lost }}\nmode weak {{ rotor 1 reduced to 50 % }} }}\n\
         mission m {{ start at [0, 0, 5] m\nwaypoint at [5, 0, 5] m\nair {{ wind = [4, 0, 0] m/s\n{}}} }}\n",
        block(Group::Top),
        block(Group::Vehicle),
        block(Group::Rotor),
        block(Group::Battery),
        block(Group::Parts),
        block(Group::Air),
    );
    compile(&text).into_result().ok()
}

/// Whether the verdict, the place of hover, the yaw-free word or a margin of some mode differs.
fn differ(a: &Spec, b: &Spec) -> bool {
    // Rounding alone, as by another angle of the whole ring, is no difference.
    let same = |a: Option<f64>, b: Option<f64>| a == b || a.zip(b).is_some_and(|(a, b)| (a - b).abs() < 1e-9);
    analyze(a).iter().zip(analyze(b)).any(|(a, b)| {
        (a.verdict, a.hover, a.yaw_free) != (b.verdict, b.hover, b.yaw_free)
            || !same(a.acai, b.acai)
            || !same(a.acai_yaw_free, b.acai_yaw_free)
    })
}

/// Whether a verdict depends on the field, among vehicles without the fields `without`.
fn matters(field: (Group, &str), without: &[&str]) -> bool {
    let base = spec(field, 1.0, without).unwrap_or_else(|| panic!("the spec for {field:?} has errors"));
    let changed: Vec<Spec> = SHARES.iter().filter_map(|share| spec(field, *share, without)).collect();
    assert!(!changed.is_empty(), "{field:?} has no other value without errors");
    // A field that may be left out.
    let left_out = spec(field, 1.0, &[without, &[field.1]].concat());
    changed.iter().chain(&left_out).any(|other| differ(&base, other))
}

#[test]
fn what_may_be_swept_is_what_verdicts_depend_on() {
    let (mut due, mut looked_at) = (BTreeSet::new(), 0);
    for group in VALUES.map(|(group, _)| group) {
        let is_number = |takes| {
            matches!(takes, Takes::Quantity(..) | Takes::QuantityOrVector(..) | Takes::Share)
                || matches!(takes, Takes::QuantityOrShare(..))
        };
        for entry in group.entries().iter().filter(|entry| is_number(entry.takes)) {
            let field = (group, entry.name);
            let has_value = VALUES.iter().any(|(of, values)| *of == group && values.iter().any(|v| v.0 == entry.name));
            assert!(has_value, "give {field:?} a value in this test");
            // Rotors that may stop leave hover on the edge of a set, where the yaw-free word depends on `yaw_drag`,
            // without which `yaw_drag_quadratic` is an error. With `rotor_inertia` the analysis of such a mode takes
            // a second.
            let stopping = ["min_speed", "min_thrust", "rotor_inertia", "yaw_drag_quadratic"];
            if matters(field, &[]) || !stopping.contains(&entry.name) && matters(field, &stopping) {
                due.insert(format!("{}{}", group.path().unwrap(), entry.name));
            }
            looked_at += 1;
        }
    }
    assert_eq!(sweepable().collect::<BTreeSet<String>>(), due);
    assert!(looked_at > 20, "{looked_at}");
}
