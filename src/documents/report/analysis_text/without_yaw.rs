//! What the modes can do with yaw given up, as text.

use crate::admissible::verdict::ModeAnalysis;
use crate::admissible::without_yaw::relaxed_hover::RelaxedHover;
use crate::admissible::without_yaw::{WithoutYaw, YawFree};
use crate::flight::equilibrium::SettledSpin;
use crate::number::{down, significant};
use crate::text_table::Table;

/// Meaning of the columns.
const LEGEND: &str = "\
hover     interior: inside the set of thrust, roll and pitch; on the edge: on its boundary; spinning: on its \
boundary, but \
the spin makes the direction of the thrust controllable; none: outside
disc      the largest roll and pitch torque in every direction [N m], and as angular acceleration
level     the largest thrust without roll and pitch torques
torque    the yaw torques that are possible in hover
spin      the turning rates about z that they keep up against `yaw_drag`, counter-clockwise: plans without yaw are \
proved for all \
of them, and flights settle at one of their own (below)
";

/// The table of all modes, with the equilibria whose axis is tilted below it.
pub fn table(modes: &[ModeAnalysis]) -> String {
    let mut table = Table::new(&["mode", "hover", "disc", "", "level", "torque [N m]", "spin [rad/s]"]);
    for mode in modes {
        table.row(match &mode.without_yaw {
            Some(figures) => row(&mode.name, mode.yaw_free, figures),
            None => vec![mode.name.clone(), mode.yaw_free.word().into()],
        });
    }
    let mut out =
        format!("\nWith yaw given up, about hover with a spin axis along z of the body\n{}{LEGEND}", table.render(0));
    if modes.iter().filter_map(|mode| mode.without_yaw.as_ref()).any(|figures| figures.spin_rad_s.is_none()) {
        out.push_str(
            "          unknown without `yaw_drag` of the vehicle; where the torques exclude 0, hover needs a spin\n",
        );
    }
    let tilted = |figures: &WithoutYaw| figures.relaxed_hover.iter().find(|found| found.axis_tilt_deg > 0.0).cloned();
    let mut equilibria = Table::new(&["mode", "disc", "tilt", "spin", "circle", "power", "thrusts [N]"]);
    for (mode, found) in modes.iter().filter_map(|mode| Some((mode, tilted(mode.without_yaw.as_ref()?)?))) {
        equilibria.row(equilibrium(&mode.name, &found));
    }
    let equilibria = equilibria.render(0);
    if equilibria.lines().count() > 1 {
        out.push_str(
            "\nThe equilibrium with the largest disc, with an axis that is tilted in the body, of modes \
            without a disc\n",
        );
        out.push_str(&equilibria);
    }
    out
}

/// Where flights settle.
pub fn settled(spins: &[SettledSpin]) -> String {
    if spins.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["mode", "spin [rad/s]", "axis tilted by", "gyroscope"]);
    for SettledSpin { mode, spin_rad_s, axis_tilt_deg, beyond_gyroscope } in spins {
        // Not a negative zero.
        let spin = if spin_rad_s.abs() < 1e-3 { 0.0 } else { *spin_rad_s };
        table.row(vec![
            mode.clone(),
            significant(spin, 3),
            format!("{} deg", significant(*axis_tilt_deg, 3)),
            if *beyond_gyroscope { "beyond its range" } else { "-" }.into(),
        ]);
    }
    format!("\nThe equilibrium in which flights settle, with the gains of `simulate`\n{}", table.render(0))
}

fn row(name: &str, word: YawFree, figures: &WithoutYaw) -> Vec<String> {
    let range = |[low, high]: [f64; 2], digits: usize| match low == high {
        true => significant(low, digits),
        false => format!("{} .. {}", significant(low, digits), significant(high, digits)),
    };
    vec![
        name.into(),
        word.word().into(),
        format!("{} N m", down(figures.disc_n_m, 4)),
        format!("{} rad/s^2", down(figures.disc_rad_s2, 3)),
        format!("{} N", down(figures.level_thrust_n, 4)),
        range(figures.yaw_torque_n_m, 4),
        figures.spin_rad_s.map_or("unknown".into(), |spin| range(spin, 3)),
    ]
}

fn equilibrium(name: &str, found: &RelaxedHover) -> Vec<String> {
    let [p, q, r] = found.body_rates_rad_s;
    let thrusts: Vec<String> = found.thrusts_n.iter().map(|thrust| significant(*thrust, 3)).collect();
    vec![
        name.into(),
        format!("{} N m", down(found.disc_n_m, 3)),
        format!("{} deg", significant(found.axis_tilt_deg, 3)),
        format!("{} rad/s", significant((p * p + q * q + r * r).sqrt().copysign(r), 3)),
        format!("{} mm", significant(1000.0 * found.circle_radius_m, 2)),
        format!("{} % of hover", significant(100.0 * found.power_ratio, 3)),
        thrusts.join(", "),
    ]
}
