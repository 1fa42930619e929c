//! The frames of a model: links, joints, frames and models within it, each placed relative to another. Source:
//! SDFormat, "Pose Frame Semantics" (1.7 and later). In older versions every pose is relative to the model, or for a
//! joint to its child, which is the same without attributes.

use super::super::RobotError;
use super::super::xml::{children, sdf_pose, tag, text};
use crate::diagnostic::Diagnostic;
use crate::import::{SYNTAX, UNSUPPORTED};
use nalgebra::Isometry3;
use roxmltree::Node;
use std::cell::RefCell;
use std::collections::HashMap;

/// Models within models beyond this are not a vehicle.
const MOST_DEEP: usize = 20;

/// The key of an element of a scope: `arm::link`, or that of the scope itself for `__model__` and no name.
pub fn key(scope: &str, name: &str) -> String {
    match (scope, name) {
        (_, "" | "__model__") => scope.into(),
        ("", name) => name.into(),
        (scope, name) => format!("{scope}::{name}"),
    }
}

/// A model and all models within it, each with its scope; that of the first is empty.
pub fn scopes<'a, 'i>(model: Node<'a, 'i>) -> Vec<(String, Node<'a, 'i>)> {
    let mut found = vec![(String::new(), model)];
    let mut next = 0;
    while let Some((scope, model)) = found.get(next).cloned() {
        next += 1;
        if scope.matches("::").count() < MOST_DEEP {
            let inner = children(model, "model");
            found.extend(inner.map(|inner| (key(&scope, inner.attribute("name").unwrap_or("model")), inner)));
        }
    }
    found
}

/// Where an element is, and relative to which key.
struct Placed<'a, 'i> {
    own: Isometry3<f64>,
    to: String,
    node: Node<'a, 'i>,
}

pub struct Frames<'a, 'i> {
    placed: HashMap<String, Placed<'a, 'i>>,
    known: RefCell<HashMap<String, Isometry3<f64>>>,
}

impl<'a, 'i> Frames<'a, 'i> {
    pub fn of(scopes: &[(String, Node<'a, 'i>)]) -> Result<Self, RobotError> {
        let mut placed = HashMap::new();
        for (scope, model) in scopes {
            for node in model.children().filter(Node::is_element) {
                let default = match node.tag_name().name() {
                    "link" => "",
                    "frame" => node.attribute("attached_to").unwrap_or_default(),
                    "joint" => text(node, "child").unwrap_or_default(),
                    "model" if node.has_attribute("placement_frame") => {
                        let message = "a model is placed by one of its own frames, which is not read";
                        let error = Diagnostic::error(UNSUPPORTED, tag(node), message).here("`placement_frame`");
                        return Err(Box::new(error.help("name a file such as `gz sdf -p model.sdf` prints")));
                    }
                    "model" => "",
                    _ => continue,
                };
                let pose = children(node, "pose").next();
                let to = pose.and_then(|pose| pose.attribute("relative_to")).filter(|to| !to.is_empty());
                let own = sdf_pose(node)?.unwrap_or_else(Isometry3::identity);
                let name = key(scope, node.attribute("name").unwrap_or_default());
                if name != *scope {
                    placed.entry(name).or_insert(Placed { own, to: key(scope, to.unwrap_or(default)), node });
                }
            }
        }
        let known = HashMap::from([(String::new(), Isometry3::identity())]);
        Ok(Frames { placed, known: RefCell::new(known) })
    }

    pub fn has(&self, key: &str) -> bool {
        self.placed.contains_key(key)
    }

    /// The pose of an element in the outermost model.
    ///
    /// # Errors
    /// It is placed relative to what is not there, or in a circle.
    pub fn pose(&self, key: &str) -> Result<Isometry3<f64>, RobotError> {
        let mut known = self.known.borrow_mut();
        let (mut at, mut way) = (key, Vec::new());
        while !known.contains_key(at) {
            let Some(placed) = self.placed.get(at) else {
                // A link without a name is where its model is.
                let Some(last) = way.last().and_then(|last: &&str| self.placed.get(*last)) else {
                    return Ok(Isometry3::identity());
                };
                let shown: String = at.chars().take(40).collect();
                let message =
                    format!("`{}` is placed relative to `{shown}`, which is not in the file", name(last.node));
                let error = Diagnostic::error(UNSUPPORTED, tag(last.node), message).here("its pose");
                return Err(Box::new(error.help("name a file with all frames, such as `gz sdf -p model.sdf` prints")));
            };
            way.push(at);
            if way.len() > self.placed.len() {
                let error = Diagnostic::error(SYNTAX, tag(placed.node), "frames are placed relative to each other");
                return Err(Box::new(error.here("in a circle").help("place one of them relative to the model")));
            }
            at = &placed.to;
        }
        let mut whole = known[at];
        for key in way.into_iter().rev() {
            whole *= self.placed[key].own;
            known.insert(key.into(), whole);
        }
        Ok(whole)
    }
}

fn name<'a>(node: Node<'a, '_>) -> &'a str {
    node.attribute("name").unwrap_or("an element")
}
