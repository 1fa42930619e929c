//! `mavc safety`: the files of an assessment agree with each other and with what they are written from, and each broken
//! link is reported by the file that it is in.

mod agreement;
mod links;
mod sentences;
mod simulated;

use crate::cli::mavc_in;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// M1 and the board have a way out for part of the mission, ice has no rate.
const SPEC: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 21 cm
    mass    = 2.3 kg
    inertia = [0.043, 0.043, 0.075] kg*m^2
    rotor { max_thrust = 6.5 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults {
    mode M1 { rotors [1] lost; rate = 1e-5 1/h +- 50 %; severity = 8; occurrence = 3; detection = 2 }
    mode board "=front board" { rotors [2, 3] lost; rate = 2e-6 1/h }
    mode ice { rotors [1, 2, 3, 4, 5, 6, 7, 8] reduced to 95 % }
}
mission field {
    ground = 1 m
    start at [0, 0, 3] m
    waypoint mid at [10, 0, 9] m
    hold 1 s
    waypoint at [20, 0, 9] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [10, 6, 1] m; radius = 2 m }
}
plan {
    model = hover
    planner = rip
    against = [M1, board]
    time = 12 s
    samples = 40
    recovery { order = [land_at_sites]; detection = 100 ms; within = 5 s }
}
"#;

/// The files that are written from the report and the certificate.
const DERIVED: [&str; 7] =
    ["fmea.csv", "fha.csv", "faulttree.xml", "quantities.json", "argument.json", "argument.svg", "index.html"];

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap()
}

fn json(folder: &Path, name: &str) -> Value {
    serde_json::from_str(&read(folder, name)).unwrap()
}

/// A folder with the spec, and what the command makes of it in `out`.
fn assessed() -> tempfile::TempDir {
    static FILES: OnceLock<Files> = OnceLock::new();
    written(FILES.get_or_init(|| {
        let (text, files) = assess("field.mav", SPEC);
        assert!(
            text.starts_with("field: loss of control ")
                && unwrapped(&text).contains("ice has no rate: left out of these numbers"),
            "{text}"
        );
        files
    }))
}

/// The files of a folder by their paths from it.
type Files = BTreeMap<PathBuf, Vec<u8>>;

/// What the command prints of a spec, and the folder after it. Tests share it, each in a copy that it may change.
fn assess(name: &str, spec: &str) -> (String, Files) {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), name, spec);
    let (code, text, errors) = mavc_in(folder.path(), &["safety", name, "-o", "out"]);
    assert_eq!(code, 0, "{text}{errors}");
    let mut files = Files::new();
    let mut folders = vec![folder.path().to_path_buf()];
    while let Some(next) = folders.pop() {
        for path in std::fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
            match path.is_dir() {
                true => folders.push(path),
                false => {
                    let name = path.strip_prefix(folder.path()).unwrap().to_path_buf();
                    files.insert(name, std::fs::read(path).unwrap());
                }
            }
        }
    }
    (text, files)
}

/// A folder of its own with these files.
fn written(files: &Files) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    folder
}

/// A text for people in one line.
fn unwrapped(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn rows(text: &str) -> Vec<BTreeMap<String, String>> {
    let mut table = csv::Reader::from_reader(text.as_bytes());
    table.deserialize().map(|row| row.unwrap()).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// The probability of the top event, by all combinations of the basic events of the file, and its minimal cut sets.
fn enumerated(tree: &str) -> (f64, BTreeSet<BTreeSet<String>>) {
    let tree = roxmltree::Document::parse(tree).unwrap();
    let named = |element: &'static str| {
        let all = tree.descendants().filter(move |node| node.has_tag_name(element));
        all.map(|node| (node.attribute("name").unwrap(), node)).collect::<BTreeMap<_, _>>()
    };
    let parameters = named("define-parameter");
    let value = |name: &str| -> f64 {
        // A number, or the two ends of a uniform deviate, for which its mean is taken.
        let floats = parameters[name].descendants().filter(|node| node.has_tag_name("float"));
        let floats: Vec<f64> = floats.map(|node| node.attribute("value").unwrap().parse().unwrap()).collect();
        assert!(floats.len() == 1 || floats.len() == 2 && floats[0] < floats[1], "{name}: {floats:?}");
        floats.iter().sum::<f64>() / floats.len() as f64
    };
    let events: Vec<(&str, f64)> = named("define-basic-event")
        .into_iter()
        .map(|(name, node)| {
            let of = node.descendants().filter(|node| node.has_tag_name("parameter"));
            let product: f64 = of.map(|node| value(node.attribute("name").unwrap())).product();
            (name, -(-product).exp_m1())
        })
        .collect();
    let gates = named("define-gate");
    fn holds(gates: &BTreeMap<&str, roxmltree::Node>, node: roxmltree::Node, is: &dyn Fn(&str) -> bool) -> bool {
        let mut inner = node.children().filter(roxmltree::Node::is_element).filter(|node| !node.has_tag_name("label"));
        match node.tag_name().name() {
            "and" => inner.all(|node| holds(gates, node, is)),
            "or" => inner.any(|node| holds(gates, node, is)),
            "define-gate" => holds(gates, inner.next().unwrap(), is),
            "gate" => holds(gates, gates[node.attribute("name").unwrap()], is),
            "basic-event" => is(node.attribute("name").unwrap()),
            other => panic!("{other}"),
        }
    }
    let (mut probability, mut failing) = (0.0, Vec::new());
    for which in 0_u32..1 << events.len() {
        let occurring: BTreeSet<&str> =
            events.iter().enumerate().filter(|(k, _)| which >> k & 1 == 1).map(|(_, event)| event.0).collect();
        if holds(&gates, gates["loss-of-control"], &|name| occurring.contains(name)) {
            let weight = |(name, p): &(&str, f64)| if occurring.contains(name) { *p } else { 1.0 - p };
            probability += events.iter().map(weight).product::<f64>();
            failing.push(occurring);
        }
    }
    let is_minimal =
        |set: &&BTreeSet<&str>| !failing.iter().any(|other| other.len() < set.len() && other.is_subset(set));
    let minimal = failing.iter().filter(is_minimal);
    (probability, minimal.map(|set| set.iter().map(ToString::to_string).collect()).collect())
}
