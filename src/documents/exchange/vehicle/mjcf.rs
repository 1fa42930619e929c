//! The vehicle and the mission as a model of MuJoCo (MJCF, XML): `mavc emit mjcf`.
//!
//! The frames are mavc's: world x east, y north, z up, body x forward, y left, z up. Each rotor is an actuator whose
//! control is its thrust in newtons; its torque about z follows from the gear. Drag, yaw drag, the lag of rotors and
//! faults are not part of the model: who simulates applies them.

use crate::model::{Model, Spin};
use crate::number::shortest;
use crate::source::visible;
use std::fmt::Write;

/// Looks alone: no mass and no contact.
const LOOKS: &str = "contype=\"0\" conaffinity=\"0\" mass=\"0\"";

/// Radius of the arms and of the path as drawn, m.
const LINE: f64 = 0.01;

/// The model as XML text.
pub fn text(model: &Model) -> String {
    let vehicle = &model.vehicle;
    let mut out = format!(
        "<mujoco model=\"{}\">\n  <!-- Controls are thrusts in newtons. Drag, yaw drag, the lag of rotors and faults \
         are left to the simulation. The path is drawn as straight legs between the waypoints. -->\n  <compiler \
         angle=\"radian\" inertiafromgeom=\"false\"/>\n  <option timestep=\"{}\" gravity=\"0 0 {}\" \
         integrator=\"RK4\"/>\n  <worldbody>\n    <light pos=\"0 0 100\" directional=\"true\"/>\n",
        escaped(&vehicle.name),
        shortest(1.0 / model.simulation.rate),
        shortest(-model.gravity)
    );
    let (place, yaw) = mission(model, &mut out);
    body(model, place, yaw, &mut out);
    out.push_str("  </worldbody>\n  <actuator>\n");
    for (k, rotor) in vehicle.rotors.iter().enumerate() {
        let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
        let torque = if rotor.spin == Spin::P { -ratio } else { ratio };
        let _ = writeln!(
            out,
            "    <motor name=\"rotor_{0}\" site=\"rotor_{0}\" gear=\"0 0 1 0 0 {1}\" ctrllimited=\"true\" \
             ctrlrange=\"{2}\"/>",
            k + 1,
            shortest(torque),
            list(&[rotor.idle_thrust(), rotor.max_thrust()])
        );
    }
    out.push_str("  </actuator>\n</mujoco>\n");
    out
}

/// Waypoints and the legs between them; returns position (m) and yaw (rad) of the first.
fn mission(model: &Model, out: &mut String) -> ([f64; 3], f64) {
    let Some(mission) = &model.mission else { return ([0.0; 3], 0.0) };
    for (k, waypoint) in mission.waypoints.iter().enumerate() {
        let place = list(&waypoint.position);
        let _ = writeln!(
            out,
            "    <site name=\"waypoint_{}\" pos=\"{place}\" size=\"{}\" rgba=\"0.1 0.5 0.1 0.6\"/>",
            k + 1,
            shortest(5.0 * LINE)
        );
    }
    for pair in mission.waypoints.windows(2) {
        if pair[0].position != pair[1].position {
            let ends = [list(&pair[0].position), list(&pair[1].position)].join(" ");
            let size = shortest(LINE);
            let _ = writeln!(
                out,
                "    <geom type=\"capsule\" fromto=\"{ends}\" size=\"{size}\" rgba=\"0.1 0.5 0.1 0.3\" {LOOKS}/>"
            );
        }
    }
    (mission.waypoints[0].position, mission.waypoints[0].yaw)
}

/// The body with its rotors, at a position (m) with a yaw (rad).
fn body(model: &Model, place: [f64; 3], yaw: f64, out: &mut String) {
    let vehicle = &model.vehicle;
    let (sin, cos) = (0.5 * yaw).sin_cos();
    let _ = write!(
        out,
        "    <body name=\"vehicle\" pos=\"{}\" quat=\"{}\">\n      <freejoint name=\"vehicle\"/>\n      <inertial \
         pos=\"0 0 0\" mass=\"{}\" diaginertia=\"{}\"/>\n",
        list(&place),
        list(&[cos, 0.0, 0.0, sin]),
        shortest(vehicle.mass),
        list(&vehicle.inertia)
    );
    for (k, rotor) in vehicle.rotors.iter().enumerate() {
        let at = list(&rotor.position);
        let size = rotor.position.iter().map(|x| x * x).sum::<f64>().sqrt();
        if size > LINE {
            let line = shortest(LINE);
            let _ = writeln!(
                out,
                "      <geom type=\"capsule\" fromto=\"0 0 0 {at}\" size=\"{line}\" rgba=\"0.3 0.3 0.3 1\" {LOOKS}/>"
            );
        }
        let radius = vehicle.propeller_radius.unwrap_or(0.4 * size.max(0.1));
        let colour = if rotor.spin == Spin::P { "0.8 0.3 0.2 0.6" } else { "0.2 0.4 0.8 0.6" };
        let disc = list(&[radius, 0.3 * LINE]);
        let _ = writeln!(out, "      <geom type=\"cylinder\" pos=\"{at}\" size=\"{disc}\" rgba=\"{colour}\" {LOOKS}/>");
        let _ = writeln!(out, "      <site name=\"rotor_{}\" pos=\"{at}\" size=\"{}\"/>", k + 1, shortest(LINE));
    }
    out.push_str("    </body>\n");
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| shortest(*x)).collect::<Vec<_>>().join(" ")
}

/// A name as the value of an attribute.
fn escaped(name: &str) -> String {
    let name = visible::line(name).to_string();
    name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
