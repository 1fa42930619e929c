//! The default classes of a file, each with what it gives, itself or by a class around it: read once, as there may be
//! as many classes as motors.

use roxmltree::{Node, NodeId};
use std::collections::HashMap;

/// The kinds of elements whose attributes a class can give.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Actuator,
    Geom,
}

impl Kind {
    fn of(name: &str) -> Option<Kind> {
        match name {
            "motor" | "general" => Some(Kind::Actuator),
            "geom" => Some(Kind::Geom),
            _ => None,
        }
    }
}

/// The attributes that are read, of each kind.
const ACTUATOR: [&str; 11] = [
    "site",
    "gear",
    "ctrlrange",
    "ctrllimited",
    "forcerange",
    "forcelimited",
    "gainprm",
    "gaintype",
    "biastype",
    "dyntype",
    "dynprm",
];
const GEOM: [&str; 12] = [
    "type",
    "size",
    "mass",
    "density",
    "fromto",
    "shellinertia",
    "pos",
    "quat",
    "euler",
    "axisangle",
    "xyaxes",
    "zaxis",
];

/// The element that gives an attribute, for each that is given.
type Owners<'a, 'i> = Vec<(Kind, &'static str, Node<'a, 'i>)>;

pub struct Defaults<'a, 'i> {
    owners: HashMap<NodeId, Owners<'a, 'i>>,
    /// The first of a name counts.
    by_class: HashMap<&'a str, NodeId>,
    outermost: Option<NodeId>,
}

impl<'a, 'i> Defaults<'a, 'i> {
    pub fn of(root: Node<'a, 'i>) -> Self {
        let mut found = Defaults { owners: HashMap::new(), by_class: HashMap::new(), outermost: None };
        // A class comes after the class around it.
        for class in root.descendants().filter(|node| node.tag_name().name() == "default") {
            let around = class.parent_element().filter(|parent| parent.tag_name().name() == "default");
            let mut given: Owners = Vec::new();
            let mut add = |kind: Kind, name: &'static str, owner: Node<'a, 'i>| {
                if !given.iter().any(|(k, n, _)| (*k, *n) == (kind, name)) {
                    given.push((kind, name, owner));
                }
            };
            for element in class.children() {
                let Some(kind) = Kind::of(element.tag_name().name()) else { continue };
                let names: &[&'static str] = if kind == Kind::Geom { &GEOM } else { &ACTUATOR };
                names.iter().filter(|name| element.has_attribute(**name)).for_each(|name| add(kind, name, element));
            }
            if let Some(around) = around.and_then(|around| found.owners.get(&around.id())) {
                around.iter().for_each(|(kind, name, owner)| add(*kind, name, *owner));
            }
            found.owners.insert(class.id(), given);
            if let Some(name) = class.attribute("class") {
                found.by_class.entry(name).or_insert(class.id());
            }
            if around.is_none() && class.parent_element().is_some() {
                found.outermost.get_or_insert(class.id());
            }
        }
        found
    }

    /// The element that gives an attribute of an actuator: itself, or the default of its class or of a class around it.
    pub fn of_actuator(&self, actuator: Node<'a, 'i>, name: &'static str) -> Option<Node<'a, 'i>> {
        self.inherited(Kind::Actuator, actuator, actuator.attribute("class"), name)
    }

    /// The element that gives an attribute of a geom; `class` is the `childclass` around it.
    pub fn of_geom(&self, geom: Node<'a, 'i>, class: Option<&str>, name: &'static str) -> Option<Node<'a, 'i>> {
        self.inherited(Kind::Geom, geom, geom.attribute("class").or(class), name)
    }

    fn inherited(
        &self,
        kind: Kind,
        element: Node<'a, 'i>,
        class: Option<&str>,
        name: &'static str,
    ) -> Option<Node<'a, 'i>> {
        if element.has_attribute(name) {
            return Some(element);
        }
        let class = match class {
            Some(class) => self.by_class.get(class).copied(),
            None => self.outermost,
        };
        let given = self.owners.get(&class?)?;
        given.iter().find(|(k, n, _)| (*k, *n) == (kind, name)).map(|(.., owner)| *owner)
    }
}
