//! The element `compiler`: how angles are written, and what MuJoCo makes of masses.

use super::super::RobotError;
use super::super::xml::{attribute, children, tag};
use crate::diagnostic::Diagnostic;
use crate::import::{SYNTAX, UNSUPPORTED, at};
use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
use roxmltree::Node;

pub struct Settings {
    /// Radians in the unit of angles.
    angle: f64,
    /// Axes of Euler angles: lower case turns with the body, upper case stays.
    sequence: [char; 3],
    pub from_geoms: FromGeoms,
    /// kg
    pub total_mass: Option<f64>,
}

/// Whether inertias follow from shapes.
#[derive(Clone, Copy, PartialEq)]
pub enum FromGeoms {
    Never,
    /// Where there is no `inertial`.
    Auto,
    Always,
}

/// Attributes that change masses or places and are not followed, unless they have these values.
const REFUSED: [(&str, &[&str]); 5] = [
    ("coordinate", &["local"]),
    ("boundmass", &["0"]),
    ("boundinertia", &["0"]),
    ("balanceinertia", &["false"]),
    ("inertiagrouprange", &["0 5"]),
];

impl Settings {
    pub fn of(root: Node) -> Result<Self, RobotError> {
        let mut found = Settings {
            angle: 1.0_f64.to_radians(),
            sequence: ['x', 'y', 'z'],
            from_geoms: FromGeoms::Auto,
            total_mass: None,
        };
        for compiler in children(root, "compiler") {
            for (name, harmless) in REFUSED {
                if let Some(value) = compiler.attribute(name).filter(|value| !harmless.contains(&value.trim())) {
                    let shown: String = value.chars().take(24).collect();
                    let message = format!("`{name}=\"{shown}\"` of the compiler is not read");
                    let error = Diagnostic::error(UNSUPPORTED, tag(compiler), message).here("changes the vehicle");
                    return Err(Box::new(error.help("name a file as MuJoCo saves it, with the masses that follow")));
                }
            }
            match compiler.attribute("angle") {
                Some("radian") => found.angle = 1.0,
                Some("degree") => found.angle = 1.0_f64.to_radians(),
                _ => {}
            }
            match compiler.attribute("inertiafromgeom") {
                Some("true") => found.from_geoms = FromGeoms::Always,
                Some("false") => found.from_geoms = FromGeoms::Never,
                Some(_) => found.from_geoms = FromGeoms::Auto,
                None => {}
            }
            if let Some(sequence) = compiler.attribute("eulerseq") {
                let letters: Vec<char> = sequence.chars().collect();
                match letters[..] {
                    [a, b, c] if letters.iter().all(|letter| "xyzXYZ".contains(*letter)) => {
                        found.sequence = [a, b, c];
                    }
                    _ => {
                        let error = Diagnostic::error(SYNTAX, tag(compiler), "`eulerseq` is not three of x, y and z");
                        return Err(Box::new(error.here("its `eulerseq`").help("write three letters, such as `xyz`")));
                    }
                }
            }
            found.total_mass = attribute::<1>(compiler, "settotalmass")?
                .map(|[mass]| mass)
                .filter(|mass| *mass > 0.0)
                .or(found.total_mass);
        }
        Ok(found)
    }

    /// How an element is turned in the one around it; `None` if it does not say.
    pub fn turn(&self, node: Node) -> Result<Option<UnitQuaternion<f64>>, RobotError> {
        if let Some([w, x, y, z]) = attribute::<4>(node, "quat")? {
            let quaternion = Quaternion::new(w, x, y, z);
            return match quaternion.norm() > 1e-12 {
                true => Ok(Some(UnitQuaternion::from_quaternion(quaternion))),
                false => Err(no_turn(node, "quat")),
            };
        }
        let axis =
            |[x, y, z]: [f64; 3], name| Unit::try_new(Vector3::new(x, y, z), 1e-12).ok_or_else(|| no_turn(node, name));
        if let Some([x, y, z, angle]) = attribute::<4>(node, "axisangle")? {
            let axis = axis([x, y, z], "axisangle")?;
            return Ok(Some(UnitQuaternion::from_axis_angle(&axis, angle * self.angle)));
        }
        if let Some(angles) = attribute::<3>(node, "euler")? {
            let mut turn = UnitQuaternion::identity();
            for (letter, angle) in self.sequence.into_iter().zip(angles) {
                let axis = match letter.to_ascii_lowercase() {
                    'x' => Vector3::x_axis(),
                    'y' => Vector3::y_axis(),
                    _ => Vector3::z_axis(),
                };
                let next = UnitQuaternion::from_axis_angle(&axis, angle * self.angle);
                turn = if letter.is_lowercase() { turn * next } else { next * turn };
            }
            return Ok(Some(turn));
        }
        if let Some([a, b, c, d, e, f]) = attribute::<6>(node, "xyaxes")? {
            let x = axis([a, b, c], "xyaxes")?;
            let y = Vector3::new(d, e, f) - x.into_inner() * x.dot(&Vector3::new(d, e, f));
            let y = axis([y.x, y.y, y.z], "xyaxes")?;
            let matrix = Matrix3::from_columns(&[x.into_inner(), y.into_inner(), x.cross(&y)]);
            return Ok(Some(UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix))));
        }
        match attribute::<3>(node, "zaxis")? {
            Some(z) => Ok(Some(up_along(&axis(z, "zaxis")?))),
            None => Ok(None),
        }
    }
}

/// The shortest turn of z to a direction.
pub fn up_along(direction: &Unit<Vector3<f64>>) -> UnitQuaternion<f64> {
    let down = || UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI);
    UnitQuaternion::rotation_between(&Vector3::z(), direction).unwrap_or_else(down)
}

fn no_turn(node: Node, name: &str) -> RobotError {
    let place = node.attributes().find(|attribute| attribute.name() == name).map(|found| found.range_value());
    let span = place.map_or_else(|| tag(node), at);
    let error = Diagnostic::error(SYNTAX, span, format!("`{name}` gives no direction")).here("zero or parallel");
    Box::new(error.help("write axes of a length above zero"))
}
