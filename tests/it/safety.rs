//! `mavc safety`: the files of an assessment agree with each other and with what they are written from, and each broken
//! link is reported by the file that it is in.

use crate::cli::mavc_in;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

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
    ground = 0 m
    start at [0, 0, 2] m
    waypoint mid at [10, 0, 8] m
    hold 1 s
    waypoint at [20, 0, 8] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [10, 6, 0] m; radius = 2 m }
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
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "field.mav", SPEC);
    let (code, text, errors) = mavc_in(folder.path(), &["safety", "field.mav", "-o", "out"]);
    assert_eq!(code, 0, "{text}{errors}");
    assert!(text.starts_with("field: loss of control ") && text.contains("without ice, which has no rate"), "{text}");
    folder
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
        let float = parameters[name].children().find(|node| node.has_tag_name("float")).unwrap();
        float.attribute("value").unwrap().parse().unwrap()
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

#[test]
fn the_files_of_an_assessment_agree() {
    let folder = assessed();
    let out = folder.path().join("out");
    let quantities = json(&out, "quantities.json");
    let (probability, cut_sets) = enumerated(&read(&out, "faulttree.xml"));
    let stated = quantities["loss_of_control"]["per_mission"].as_f64().unwrap();
    assert!(close(stated, probability), "{stated} {probability}");
    let listed: BTreeSet<BTreeSet<String>> = quantities["cut_sets"]
        .as_array()
        .unwrap()
        .iter()
        .map(|set| set["events"].as_array().unwrap().iter().map(|event| event.as_str().unwrap().into()).collect())
        .collect();
    assert_eq!(listed, cut_sets);
    assert!(cut_sets.iter().any(|set| set.len() == 2) && cut_sets.iter().any(|set| set.len() == 1), "{cut_sets:?}");
    let interval = quantities["loss_of_control"]["per_mission_over_rate_intervals"].as_array().unwrap();
    assert!(interval[0].as_f64().unwrap() < stated && stated < interval[1].as_f64().unwrap());

    // The worksheet accounts for every second of every mode, and exposes those that the fault tree counts.
    let sheet = rows(&read(&out, "fmea.csv"));
    for (mode, rate) in [("M1", Some(1e-5)), ("board", Some(2e-6)), ("ice", None)] {
        let own: Vec<_> = sheet.iter().filter(|row| row["mode"] == mode).collect();
        let sum = |column: &str| own.iter().map(|row| row[column].parse::<f64>().unwrap()).sum::<f64>();
        assert!((sum("effect_s") - 12.0).abs() < 1e-9, "{mode}");
        assert!(own.iter().all(|row| row["rate_per_h"].parse().ok() == rate), "{mode}");
        let counted = quantities["modes"].as_array().unwrap().iter().find(|found| found["mode"] == mode);
        if let Some(counted) = counted {
            assert!((counted["uncovered_s"].as_f64().unwrap() - sum("exposure_s")).abs() < 1e-9, "{mode}");
        }
        let landed = own.iter().filter(|row| row["site"] == "pad");
        assert!(landed.clone().count() > 0 && landed.clone().all(|row| !row["provision"].is_empty()), "{mode}");
    }
    assert!(sheet.iter().filter(|row| row["mode"] == "M1").all(|row| row["RPN"] == "48"));
    assert!(sheet.iter().filter(|row| row["mode"] == "board").all(|row| row["title"] == "'=front board"));

    // The hazards are the worksheet, summed.
    let hazards = rows(&read(&out, "fha.csv"));
    let seconds: f64 = hazards.iter().map(|row| row["mode_seconds"].parse::<f64>().unwrap()).sum();
    assert!((seconds - 3.0 * 12.0).abs() < 1e-9, "{seconds}");

    // Each answer of the page is one, or says that it is not covered.
    let page = read(&out, "index.html");
    let answers: Vec<&str> = page.split("<dd>").skip(1).map(|rest| rest.split("</dd>").next().unwrap()).collect();
    assert!(answers.len() == 10 && answers.iter().all(|answer| answer.len() > 10), "{answers:?}");
    assert!(DERIVED[..6].iter().all(|name| page.contains(&format!("href=\"{name}\""))));
}

#[test]
fn the_argument_keeps_the_rules_of_its_notation() {
    let folder = assessed();
    let out = folder.path().join("out");
    let argument = json(&out, "argument.json");
    let nodes: BTreeMap<&str, &Value> =
        argument["nodes"].as_array().unwrap().iter().map(|node| (node["id"].as_str().unwrap(), node)).collect();
    let of = |node: &'_ Value, member: &str| -> Vec<String> {
        node[member].as_array().unwrap().iter().map(|id| id.as_str().unwrap().to_string()).collect()
    };
    let mut reached = BTreeSet::new();
    let mut next = vec![(argument["root"].as_str().unwrap().to_string(), 0)];
    while let Some((id, depth)) = next.pop() {
        assert!(depth < nodes.len(), "a circle through {id}");
        let node = nodes[id.as_str()];
        let kind = node["type"].as_str().unwrap();
        let (supports, contexts) = (of(node, "supported_by"), of(node, "in_context_of"));
        let allowed: &[&str] = match kind {
            "goal" => &["goal", "strategy", "solution"],
            "strategy" => &["goal"],
            _ => &[],
        };
        assert!(supports.iter().all(|id| allowed.contains(&nodes[id.as_str()]["type"].as_str().unwrap())), "{node}");
        let is_context =
            |id: &String| ["context", "assumption"].contains(&nodes[id.as_str()]["type"].as_str().unwrap());
        assert!(contexts.iter().all(is_context), "{node}");
        assert!(contexts.is_empty() || ["goal", "strategy"].contains(&kind), "{node}");
        let needs = ["goal", "strategy"].contains(&kind);
        assert_eq!(node["undeveloped"].as_bool().unwrap(), needs && supports.is_empty(), "{node}");
        if kind == "solution" {
            let bytes = std::fs::read(out.join(node["file"].as_str().unwrap())).unwrap();
            let hash: String = Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect();
            assert_eq!(node["sha256"], Value::String(hash));
        }
        next.extend(supports.into_iter().chain(contexts).map(|id| (id, depth + 1)));
        reached.insert(id);
    }
    assert_eq!(nodes[argument["root"].as_str().unwrap()]["type"], "goal");
    assert_eq!(reached.len(), nodes.len(), "a node hangs loose");
    let drawing = read(&out, "argument.svg");
    roxmltree::Document::parse(&drawing).unwrap();
    assert!(nodes.keys().all(|id| drawing.contains(&format!(">{id}"))), "a node is not drawn");
    // Ice has no rate and no way out for part of the time.
    assert!(nodes.values().any(|node| node["undeveloped"] == true && node["text"].as_str().unwrap().contains("ice")));
}

#[test]
fn each_broken_link_is_reported_where_it_is() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let check = || mavc_in(folder, &["safety", "field.mav", "-o", "out", "--check", "-q"]);
    assert_eq!(check().0, 0);

    // A file that was edited by hand, and one that is missing.
    for name in DERIVED {
        let text = read(&out, name);
        write(&out, name, &text.replacen("M1", "M9", 1));
        let (code, _, errors) = check();
        assert_eq!(code, 5, "{errors}");
        assert!(errors.contains(&format!("mavc: {name}: does not follow")) && errors.lines().count() == 1, "{errors}");
        std::fs::remove_file(out.join(name)).unwrap();
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains(&format!("cannot read out/{name}")), "{errors}");
        write(&out, name, &text);
    }

    // A rate or a site: the folder is that of another spec, and every file of the new one differs.
    let moved = ("at = [10, 6, 0] m", "at = [10, 12, 0] m");
    for (from, to) in [moved, ("2e-6 1/h", "3e-6 1/h")] {
        write(folder, "field.mav", &SPEC.replace(from, to));
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains("mavc::verify::other_spec"), "{errors}");
        let (code, text, errors) = mavc_in(folder, &["safety", "field.mav", "-o", "new"]);
        assert_eq!(code, 0, "{text}{errors}");
        assert!(DERIVED.iter().all(|name| read(&out, name) != read(&folder.join("new"), name)), "{to}");
    }
    let mixed = |report: &str, certificate: &str| {
        let args = ["safety", "field.mav", "-o", "mixed", "--report", report, "--certificate", certificate];
        let (code, text, errors) = mavc_in(folder, &args);
        assert!(code != 0 && !folder.join("mixed").exists(), "{text}{errors}");
        (code, errors)
    };
    let (code, errors) = mixed("out/report.json", "new/certificate.json");
    assert!(code == 2 && errors.contains("cannot use report.json: it is the report of another spec"), "{errors}");

    // A certificate that does not verify.
    write(folder, "field.mav", SPEC);
    let mut forged = json(&out, "certificate.json");
    let height = &mut forged["claim"]["plan"]["motion"]["z"][20][0];
    assert!(height.is_number(), "the record of a motion changed");
    *height = Value::from(7.0);
    write(folder, "forged.json", &forged.to_string());
    let (code, errors) = mixed("out/report.json", "forged.json");
    assert!(code == 5 && errors.contains("the certificate is rejected"), "{errors}");

    // A site, a mode, a time and an outcome that the spec does not have.
    let report = read(&out, "report.json");
    for (from, to, why) in [
        ("\"site\": \"pad\"", "\"site\": \"pod\"", "`pod`, which is not a landing site"),
        (
            "\"name\": \"board\",\n        \"pieces\"",
            "\"name\": \"plank\",\n        \"pieces\"",
            "its modes, M1, plank, ice,",
        ),
        ("\"to_s\": 12.0", "\"to_s\": 11.0", "end at 11 s, the plan at 12 s"),
        ("\"outcome\": \"none\"", "\"outcome\": \"flies\"", "the unknown outcome `flies`"),
    ] {
        assert!(report.contains(from), "{from}");
        write(folder, "broken.json", &report.replacen(from, to, 1));
        let (code, errors) = mixed("broken.json", "out/certificate.json");
        assert!(code == 2 && errors.contains("cannot use report.json") && errors.contains(why), "{errors}");
    }
}

#[test]
fn the_target_of_the_spec_decides_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    for (target, expected, word) in [("1e-9", 4, "exceeds"), ("1e-3", 7, "meets")] {
        let plan = format!("planner = rsp; require risk <= {target}");
        write(folder.path(), "field.mav", &SPEC.replace("planner = rip", &plan));
        let (code, text, errors) = mavc_in(folder.path(), &["safety", "field.mav", "-o", "out"]);
        assert_eq!(code, expected, "{text}{errors}");
        assert!(text.contains(&format!("{word} the target of the spec")), "{text}");
        let left = json(&folder.path().join("out"), "quantities.json")["left_of_target"].as_f64().unwrap();
        assert_eq!(left < 0.0, word == "exceeds");
    }
}

#[test]
fn without_rates_there_are_cut_sets_and_no_probability() {
    let folder = tempfile::tempdir().unwrap();
    let spec = SPEC.replace("rate = 1e-5 1/h +- 50 %; ", "").replace("; rate = 2e-6 1/h", "");
    write(folder.path(), "field.mav", &spec);
    let (code, text, errors) = mavc_in(folder.path(), &["safety", "field.mav", "-o", "out"]);
    assert_eq!(code, 0, "{text}{errors}");
    assert!(text.contains("no mode has a rate"), "{text}");
    let out = folder.path().join("out");
    assert!(json(&out, "quantities.json")["loss_of_control"]["per_mission"].is_null());
    let (_, cut_sets) = enumerated(&read(&out, "faulttree.xml"));
    assert_eq!(json(&out, "quantities.json")["cut_sets"].as_array().unwrap().len(), cut_sets.len());
    let doubles = cut_sets.iter().filter(|set| set.len() == 2).count();
    assert!(doubles == 3 && cut_sets.len() > 3, "{cut_sets:?}");
}

/// Refused before the search.
#[test]
fn too_many_modes_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let modes = |count: usize| {
        let share = |k: usize| 0.25 * k as f64;
        let mode = |k: usize| format!("mode m{k} {{ rotors [1] reduced to {} %; rate = 1e-6 1/h }}\n", share(k));
        (1..=count).map(mode).collect::<String>()
    };
    let [before, after] = [SPEC.find("    mode M1").unwrap(), SPEC.find("}\nmission").unwrap()];
    let spec = format!("{}{}{}", &SPEC[..before], modes(201), &SPEC[after..]).replace("[M1, board]", "[m201]");
    write(folder.path(), "field.mav", &spec);
    let (code, text, errors) = mavc_in(folder.path(), &["safety", "field.mav", "-o", "out", "-q"]);
    assert!(code == 2 && errors.contains("pairs of 201 modes, at most 200"), "{text}{errors}");
    assert!(!folder.path().join("out").exists());
}
