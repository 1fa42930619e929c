//! Elements, attributes and lists of numbers of an XML file, each with its place.

use super::RobotError;
use crate::diagnostic::Diagnostic;
use crate::import::{SYNTAX, at};
use crate::source::Span;
use nalgebra::{Isometry3, Matrix3, Quaternion, Translation3, UnitQuaternion, Vector3};
use roxmltree::Node;
use std::f64::consts::PI;
use std::ops::Range;

/// The first attribute of an element beyond `most`, or the first namespace of the file beyond as many. It looks at the
/// text as far as needed for that and no further: whether the file is well-formed is the parser's matter.
pub fn crowded(text: &str, most: usize) -> Option<Range<usize>> {
    let mut namespaces = 0;
    let mut from = 0;
    while let Some(tag) = text[from..].find('<').map(|at| from + at) {
        let rest = &text[tag..];
        // No attributes are within these.
        let whole = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        if let Some((_, end)) = whole.iter().find(|(begin, _)| rest.starts_with(begin)) {
            from = tag + rest.find(end)?;
            continue;
        }
        let (mut attributes, mut quote) = (0, None);
        let mut end = text.len();
        for (i, byte) in rest.bytes().enumerate() {
            match (quote, byte) {
                (Some(open), _) if byte == open => quote = None,
                (Some(_), _) => {}
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => {
                    attributes += 1;
                    let name = rest[..i]
                        .rsplit(|c: char| c.is_whitespace() || matches!(c, '"' | '\''))
                        .next()
                        .unwrap_or_default();
                    namespaces += usize::from(name.starts_with("xmlns"));
                    if attributes > most || namespaces > most {
                        return Some(tag + i - name.len()..tag + i);
                    }
                }
                (None, b'>') => {
                    end = tag + i + 1;
                    break;
                }
                (None, _) => {}
            }
        }
        from = end;
    }
    None
}

/// The opening tag of an element, without its attributes.
pub fn tag(node: Node) -> Span {
    let range = node.range();
    at(range.start..(range.start + 1 + node.tag_name().name().len()).min(range.end))
}

/// The child elements of a name.
pub fn children<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |child| child.tag_name().name() == name)
}

/// The first child element of a name.
pub fn child<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> Option<Node<'a, 'i>> {
    children(node, name).next()
}

/// The trimmed text of a child element.
pub fn text<'a>(node: Node<'a, '_>, name: &'static str) -> Option<&'a str> {
    child(node, name)?.text().map(str::trim)
}

/// Numbers in a text: exactly `N`, finite.
fn numbers<const N: usize>(text: &str, span: Span, what: &str) -> Result<[f64; N], RobotError> {
    let mut found = [0.0; N];
    let mut words = text.split_whitespace();
    let is_whole = found.iter_mut().all(|slot| {
        let value = words.next().and_then(|word| word.parse::<f64>().ok()).filter(|value| value.is_finite());
        value.map(|value| *slot = value).is_some()
    });
    if is_whole && words.next().is_none() {
        return Ok(found);
    }
    let expected = if N == 1 { "a finite number".to_string() } else { format!("{N} finite numbers") };
    let error = Diagnostic::error(SYNTAX, span, format!("`{what}` needs {expected}"));
    Err(Box::new(error.here("this does not fit").help(format!("write {expected}"))))
}

/// The numbers of an attribute, if it is there.
pub fn attribute<const N: usize>(node: Node, name: &str) -> Result<Option<[f64; N]>, RobotError> {
    let found = node.attributes().find(|attribute| attribute.name() == name);
    found.map(|attribute| numbers(attribute.value(), at(attribute.range_value()), name)).transpose()
}

/// The numbers of an attribute, if it is there: at most `N`, zeros in place of the rest.
pub fn upto<const N: usize>(node: Node, name: &str) -> Result<Option<[f64; N]>, RobotError> {
    let Some(found) = node.attributes().find(|attribute| attribute.name() == name) else { return Ok(None) };
    let count = found.value().split_whitespace().count();
    if count == 0 || count > N {
        let error = Diagnostic::error(SYNTAX, at(found.range_value()), format!("`{name}` needs 1 to {N} numbers"));
        return Err(Box::new(error.here("this does not fit").help("write numbers with blanks between them")));
    }
    let padded = format!("{}{}", found.value(), " 0".repeat(N - count));
    numbers(&padded, at(found.range_value()), name).map(Some)
}

/// The number of an attribute that must be there.
pub fn required(node: Node, name: &str) -> Result<f64, RobotError> {
    attribute::<1>(node, name)?.map(|[value]| value).ok_or_else(|| {
        let element = node.tag_name().name();
        let error = Diagnostic::error(SYNTAX, tag(node), format!("`{element}` has no `{name}`"));
        Box::new(error.here("needs it").help(format!("write `{name}=\"..\"`")))
    })
}

/// The numbers in a child element, if it is there.
pub fn content<const N: usize>(node: Node, name: &'static str) -> Result<Option<[f64; N]>, RobotError> {
    child(node, name).map(|found| numbers(found.text().unwrap_or_default(), tag(found), name)).transpose()
}

/// The pose in an element `pose` of SDF, if it is there: six numbers, angles in radians or degrees, or seven with a
/// quaternion; an empty element means no displacement.
pub fn sdf_pose(node: Node) -> Result<Option<Isometry3<f64>>, RobotError> {
    let Some(found) = child(node, "pose") else { return Ok(None) };
    let text = found.text().unwrap_or_default();
    if text.trim().is_empty() {
        return Ok(Some(Isometry3::identity()));
    }
    if found.attribute("rotation_format") == Some("quat_xyzw") {
        let [x, y, z, i, j, k, w] = numbers::<7>(text, tag(found), "pose")?;
        let quaternion = Quaternion::new(w, i, j, k);
        if quaternion.norm() < 1e-12 {
            let error = Diagnostic::error(SYNTAX, tag(found), "the quaternion of `pose` is zero").here("no rotation");
            return Err(Box::new(error.help("write `0 0 0 1` for no rotation")));
        }
        let turn = UnitQuaternion::from_quaternion(quaternion);
        return Ok(Some(Isometry3::from_parts(Translation3::new(x, y, z), turn)));
    }
    let [x, y, z, roll, pitch, yaw] = numbers::<6>(text, tag(found), "pose")?;
    let unit =
        if found.attribute("degrees").is_some_and(|word| matches!(word, "true" | "1")) { PI / 180.0 } else { 1.0 };
    Ok(Some(pose([x, y, z, roll * unit, pitch * unit, yaw * unit])))
}

/// A pose from a place (m) and roll, pitch and yaw (rad): first about x, then y, then z, all fixed axes.
pub fn pose([x, y, z, roll, pitch, yaw]: [f64; 6]) -> Isometry3<f64> {
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}

/// A symmetric matrix from its elements xx, yy, zz, xy, xz, yz.
pub fn symmetric([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// A matrix of inertia in other axes: `R I R^T`.
pub fn turned(pose: &Isometry3<f64>, inertia: Matrix3<f64>) -> Matrix3<f64> {
    let rotation = pose.rotation.to_rotation_matrix();
    rotation.matrix() * inertia * rotation.matrix().transpose()
}

/// Whether the z axis of a pose points up, to a degree.
pub fn is_upright(pose: &Isometry3<f64>) -> bool {
    (pose.rotation * Vector3::z()).z > 1.0_f64.to_radians().cos()
}
