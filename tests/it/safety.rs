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

/// By how much a height may change between two instants at which the search has different outcomes, m: less than
/// 62.5 ms at 6 m/s.
const GAP_M: f64 = 0.375;

/// When a mode has an outcome within a phase, by the report.
fn pieces_within(out: &Path, mode: &str, outcome: &str, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    let report = json(out, "report.json");
    let modes = report["recovery"]["modes"].as_array().unwrap();
    let own = modes.iter().find(|found| found["name"] == mode).unwrap();
    let pieces = own["pieces"].as_array().unwrap().iter().filter(|piece| piece["outcome"] == outcome);
    let times = pieces.map(|piece| ["from_s", "to_s"].map(|member| piece[member].as_f64().unwrap()));
    times.map(|[a, b]| [a.max(from), b.min(to)]).filter(|[a, b]| a < b).collect()
}

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
    assert!(
        text.starts_with("field: loss of control ")
            && unwrapped(&text).contains("ice has no rate: left out of these numbers"),
        "{text}"
    );
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

/// The lowest and the highest of many heights of a plan in the hover model between two times, m.
fn sampled_heights(motion: &Value, from: f64, to: f64) -> [f64; 2] {
    let (times, nodes) = (motion["times_s"].as_array().unwrap(), motion["z"].as_array().unwrap());
    let number = |value: &Value| value.as_f64().unwrap();
    let mut all = Vec::new();
    for (times, nodes) in times.windows(2).zip(nodes.windows(2)) {
        let [begin, end] = [number(&times[0]), number(&times[1])];
        let [z, v, a] = [0, 1, 2].map(|i| number(&nodes[0][i]));
        let jerk = (number(&nodes[1][2]) - a) / (end - begin);
        let inside = (0..=200).map(|k| (end - begin) * f64::from(k) / 200.0);
        let inside = inside.filter(|t| (from - 1e-9..=to + 1e-9).contains(&(begin + t)));
        all.extend(inside.map(|t| z + t * (v + t * (a / 2.0 + t * jerk / 6.0))));
    }
    let [least, most] = [f64::min, f64::max].map(|pick| all.iter().copied().reduce(pick).unwrap());
    [least, most]
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
    assert_eq!(quantities["modes"][0]["rate_interval_per_h"], serde_json::json!([5e-6, 1.5e-5]));
    let deviate = "<uniform-deviate>\n        <float value=\"5e-6\"/>\n        <float value=\"0.000015\"/>";
    assert_eq!(read(&out, "faulttree.xml").matches(deviate).count(), 1);

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
    let motion = &json(&out, "certificate.json")["claim"]["plan"]["motion"];
    let mut parts_of_phases = 0;
    for row in &hazards {
        let own = |other: &&BTreeMap<String, String>| {
            other["phase"] == row["phase"]
                && other["end_effect"] == row["effect"]
                && row["modes"].split(' ').any(|mode| mode == other["mode"])
        };
        // When the modes of the row have its outcome; the report's pieces, each within the phase.
        let mut times: Vec<[f64; 2]> = Vec::new();
        for mode in sheet.iter().filter(own) {
            let [from, to] = ["phase_from_s", "phase_to_s"].map(|column| mode[column].parse::<f64>().unwrap());
            let seconds: f64 = mode["effect_s"].parse().unwrap();
            match (seconds - (to - from)).abs() < 1e-9 {
                true => times.push([from, to]),
                false => times.extend(pieces_within(&out, &mode["mode"], &row["outcome"], [from, to])),
            }
            parts_of_phases += usize::from(seconds < to - from - 1e-9);
        }
        let sampled: Vec<[f64; 2]> = times.iter().map(|[from, to]| sampled_heights(motion, *from, *to)).collect();
        let least = sampled.iter().map(|heights| heights[0]).fold(f64::INFINITY, f64::min);
        let most = sampled.iter().map(|heights| heights[1]).fold(f64::NEG_INFINITY, f64::max);
        let [low, high] = ["lowest_height_m", "highest_height_m"].map(|column| row[column].parse::<f64>().unwrap());
        // The spec's ground is at 1 m; samples may miss an extreme by little, and rounding is less. A gap between two
        // pieces, at most the resolution of the search, belongs to one of them.
        let missed = [least - 1.0 - low, high - (most - 1.0)];
        assert!(missed.iter().all(|by| (-1e-9..GAP_M).contains(by)), "{row:?} {missed:?}");
        assert_eq!(row["heights_above"], "ground");
    }
    assert!(parts_of_phases > 0, "no outcome takes a part of a phase");

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
    let all = argument["nodes"].as_array().unwrap();
    let nodes: BTreeMap<&str, &Value> = all.iter().map(|node| (node["id"].as_str().unwrap(), node)).collect();
    assert_eq!(nodes.len(), all.len(), "two nodes have one name");
    assert!(all.iter().all(|node| !node["text"].as_str().unwrap().is_empty()));
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
    // Ice has no rate and no way out for part of the time: what is known is supported, the rest undeveloped.
    let with = |text: &str| nodes.values().find(|node| node["text"].as_str().unwrap().starts_with(text)).unwrap();
    assert_eq!(with("The rate of ice is established (undeveloped: the spec has none)")["undeveloped"], true);
    let files: BTreeSet<String> = of(with("ice is uncovered for "), "supported_by")
        .iter()
        .filter_map(|id| nodes[id.as_str()]["file"].as_str().map(str::to_string))
        .collect();
    assert_eq!(files.into_iter().collect::<Vec<_>>(), ["branches/SHA256SUMS", "report.json"]);
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
    let moved = ("at = [10, 6, 1] m", "at = [10, 12, 1] m");
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

/// A report that contradicts the certificate, the spec or itself is refused, and the message names it.
#[test]
fn a_report_that_contradicts_itself_or_the_certificate_is_refused() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let report = json(&out, "report.json");
    let modes = report["recovery"]["modes"].as_array().unwrap();
    let has_none = |mode: &Value| mode["pieces"].as_array().unwrap().iter().any(|piece| piece["outcome"] == "none");
    let open = modes.iter().position(has_none).unwrap();
    let refused = |why: &str, change: &dyn Fn(&mut Value)| {
        let mut forged = report.clone();
        change(&mut forged);
        assert_ne!(forged, report, "{why}");
        write(folder, "forged.json", &forged.to_string());
        let args = ["--report", "forged.json", "--certificate", "out/certificate.json"];
        let (code, text, errors) = mavc_in(folder, &[&["safety", "field.mav", "-o", "forged"], &args[..]].concat());
        assert!(
            code == 2 && errors.contains("cannot use report.json") && errors.contains(why),
            "{why}: {text}{errors}"
        );
        assert!(!folder.join("forged").exists());
    };
    let pieces = |report: &mut Value, change: &dyn Fn(&mut Vec<Value>)| {
        change(report["recovery"]["modes"][open]["pieces"].as_array_mut().unwrap());
    };
    let without_gaps = |report: &mut Value| pieces(report, &|all| all.retain(|piece| piece["outcome"] != "none"));
    // The sums of an honest report, so that only what is tested contradicts them.
    let summed = |report: &mut Value| {
        let recovery = &mut report["recovery"];
        let all = recovery["modes"].as_array_mut().unwrap();
        for mode in all.iter_mut() {
            let none = mode["pieces"].as_array().unwrap().iter().filter(|piece| piece["outcome"] == "none");
            let sum: f64 = none.map(|piece| piece["to_s"].as_f64().unwrap() - piece["from_s"].as_f64().unwrap()).sum();
            mode["uncovered_s"] = Value::from(sum);
        }
        let open: f64 = all.iter().map(|mode| mode["uncovered_s"].as_f64().unwrap()).sum();
        recovery["uncovered"] = Value::from(open / (12.0 * all.len() as f64));
    };
    // Without the times that have no way out, and with the next ones over these times.
    refused("s, the plan at 12 s", &|forged| without_gaps(forged));
    // A hole beside a time without a way out, an overlap, and an end before that of the plan.
    for (member, by, why) in [
        ("from_s", 0.01, "do not follow each other"),
        ("from_s", -0.01, "do not follow each other"),
        ("to_s", -1.0, "end at 11 s, the plan at 12 s"),
    ] {
        refused(why, &|forged| {
            pieces(forged, &|all| {
                let last = all.last_mut().unwrap();
                assert_eq!(last["outcome"], "none", "the spec gave another mission");
                last[member] = Value::from(last[member].as_f64().unwrap() + by);
            });
            summed(forged);
        });
    }
    refused("do not cover the time from 0 to", &|forged| {
        without_gaps(forged);
        pieces(forged, &|all| {
            let mut reached = 0.0;
            for piece in all.iter_mut() {
                piece["from_s"] = Value::from(reached);
                reached = piece["to_s"].as_f64().unwrap();
            }
            all.last_mut().unwrap()["to_s"] = Value::from(12.0);
        });
        summed(forged);
    });
    refused("its share without a way out", &|forged| forged["recovery"]["uncovered"] = Value::from(0.001));
    refused("is uncovered for 0 s", &|forged| forged["recovery"]["modes"][open]["uncovered_s"] = Value::from(0.0));
    refused("it reaches waypoint 2 at", &|forged| {
        let waypoints = forged["planners"].as_array_mut().unwrap().last_mut().unwrap();
        let at = &mut waypoints["waypoints"][1]["at_s"];
        *at = Value::from(at.as_f64().unwrap() + 0.5);
    });
    refused("its plan takes 13 s, that of the certificate 12 s", &|forged| {
        forged["planners"].as_array_mut().unwrap().last_mut().unwrap()["time_s"] = Value::from(13.0);
    });
    refused("not those of the spec", &|forged| forged["recovery"]["detection_s"] = serde_json::json!([0.05]));
    refused("ways out, and counts", &|forged| {
        for count in ["flown", "survived"] {
            let counted = forged["recovery"][count].as_u64().unwrap();
            forged["recovery"][count] = Value::from(counted + 1);
        }
    });
    refused("whether a way out was sought after M1 does not follow from the spec", &|forged| {
        forged["recovery"]["modes"][open]["not_attempted"] = Value::from("no hover");
    });
    for by in [-20, 100] {
        refused("a search of its outcomes does not look at", &|forged| {
            let instants = forged["recovery"]["instants"].as_i64().unwrap();
            forged["recovery"]["instants"] = Value::from(instants + by);
        });
    }
}

/// The folder has the spec, and says of what its hash is; a copy of the spec gives the same assessment.
#[test]
fn the_folder_identifies_its_spec_and_its_program() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir_all(folder.join("missions")).unwrap();
    let vehicle = &SPEC[SPEC.find("vehicle").unwrap()..SPEC.find("faults").unwrap()];
    let spec = SPEC.replace(vehicle, "use \"../octo.mav\"\n");
    write(folder, "octo.mav", vehicle);
    write(folder, "missions/field.mav", &spec);
    let set = "plan.reserve=11%";
    let assess = |spec: &str, out: &str, more: &[&str]| {
        let (code, text, errors) =
            mavc_in(folder, &[&["safety", spec, "-o", out, "--set", set, "--set", "plan.effort=quick"], more].concat());
        assert_eq!(code, 0, "{text}{errors}");
        text
    };
    assess("missions/field.mav", "out", &[]);
    let out = folder.join("out");
    let quantities = json(&out, "quantities.json");
    assert_eq!(quantities["set"], serde_json::json!([set, "plan.effort=quick"]));
    let files: Vec<&str> =
        quantities["spec"].as_array().unwrap().iter().map(|text| text["file"].as_str().unwrap()).collect();
    assert_eq!(files, ["spec/missions/field.mav", "spec/octo.mav"]);
    let page = read(&out, "index.html");
    let mut whole = Sha256::new();
    let hex = |hash: Sha256| hash.finalize().iter().map(|b| format!("{b:02x}")).collect::<String>();
    for (name, text) in [(files[0], spec.as_str()), (files[1], vehicle)] {
        assert_eq!(read(&out, name), text);
        let own = hex(Sha256::new_with_prefix(text));
        assert!(page.contains(&own), "{name}");
    }
    for text in [spec.as_str(), vehicle, set] {
        whole.update((text.len() as u64).to_le_bytes());
        whole.update(text);
    }
    let whole = hex(whole);
    assert!(quantities["spec_sha256"] == whole.as_str() && page.contains(&whole));
    let version = mavc_in(folder, &["--version"]).1;
    let mut facts = version.lines();
    let number = facts.next().unwrap().trim_start_matches("mavc ");
    let commit = facts.next().unwrap().split_once("commit").unwrap().1.trim();
    assert_eq!(quantities["written_by"], format!("{number}, commit {commit}"));
    assert!(page.contains(&format!("{number}, commit {commit}")));

    // The copy is the spec, whatever its name, and a copy that was edited is reported.
    write(folder, "missions/renamed.mav", &spec);
    assess("missions/renamed.mav", "out", &["--check"]);
    assess("out/spec/missions/field.mav", "out", &["--check"]);
    write(&out, "spec/octo.mav", &vehicle.replace("2.3 kg", "2.4 kg"));
    let args = ["safety", "missions/field.mav", "-o", "out", "--set", set, "--check", "-q"];
    let (code, _, errors) = mavc_in(folder, &args);
    assert!(code == 5 && errors.contains("mavc: spec/octo.mav: does not follow"), "{errors}");
}

/// Files that the others are written from are compared with the hashes that the folder states.
#[test]
fn a_changed_report_certificate_or_table_is_named() {
    let folder = assessed();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let check = || mavc_in(folder, &["safety", "field.mav", "-o", "out", "--check", "-q"]);
    let (code, text, _) = check();
    assert!(
        code == 0 && text.starts_with("8 files follow from the spec, report.json and certificate.json\n"),
        "{text}"
    );
    assert!(text.contains("report.json itself is not proved"), "{text}");

    // The tables of the worksheet are in the folder, as `plan --branches` writes them.
    let sheet = rows(&read(&out, "fmea.csv"));
    let tables: BTreeSet<&str> = sheet.iter().flat_map(|row| row["provision"].split_whitespace()).collect();
    assert!(tables.len() > 4, "{tables:?}");
    let index = rows(&read(&out, "branches/index.csv"));
    assert_eq!(index.iter().map(|row| row["file"].as_str()).collect::<BTreeSet<_>>(), tables);
    assert!(text.contains(&format!("{} files in branches", tables.len() + 1)), "{text}");
    // With a certificate, as here: ways out that leave room for a proof are then sought first.
    mavc_in(folder, &["plan", "field.mav", "--branches", "planned", "--certificate", "c.json", "-q"]);
    let table = format!("branches/{}", tables.first().unwrap());
    assert!(read(&out, &table) == read(&folder.join("planned"), tables.first().unwrap()), "{table}");

    for name in ["report.json", "certificate.json", "branches/SHA256SUMS", &table] {
        let text = read(&out, name);
        for changed in [format!("{text} "), text.replacen('1', "2", 1), String::new()] {
            write(&out, name, &changed);
            let (code, _, errors) = check();
            let due = format!("mavc: {name}: changed since the folder was written");
            assert!(code == 5 && errors.contains(&due) && !errors.contains("does not follow"), "{errors}");
        }
        std::fs::remove_file(out.join(name)).unwrap();
        let (code, _, errors) = check();
        assert!(code == 5 && errors.contains(&format!("mavc: {name}: cannot read")), "{errors}");
        write(&out, name, &text);
    }
    assert_eq!(check().0, 0);
    // Files that the assessment does not have, of another one or anyone's.
    write(&out, "branches/M9_1.000s_100ms.csv", "t\n");
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("branches/M9_1.000s_100ms.csv: not of this assessment"), "{errors}");
    let args = ["--report", "out/report.json", "--certificate", "out/certificate.json", "-q"];
    let (code, _, errors) = mavc_in(folder, &[&["safety", "field.mav", "-o", "out"], &args[..]].concat());
    assert!(code == 0 && errors.starts_with("mavc: branches: not of this assessment"), "{errors}");
    assert_eq!(check().0, 5);
    std::fs::remove_dir_all(out.join("branches")).unwrap();
    assert_eq!(check().0, 0);
    write(&out, "fmea_old.csv", "mode\n");
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("mavc: fmea_old.csv: not of this assessment"), "{errors}");
    std::fs::remove_file(out.join("fmea_old.csv")).unwrap();
    assert_eq!(mavc_in(folder, &["safety", "field.mav", "-o", "out", "-q"]).0, 0);
    assert_eq!(check().0, 0);
    // Where every file states the hash of a forged report, the report is refused.
    let forged = read(&out, "report.json").replace("\"detection_s\": [", "\"detection_s\": [0.05, ");
    let hash = |text: &str| Sha256::digest(text).iter().map(|b| format!("{b:02x}")).collect::<String>();
    let honest = hash(&read(&out, "report.json"));
    write(&out, "report.json", &forged);
    for name in DERIVED {
        write(&out, name, &read(&out, name).replace(&honest, &hash(&forged)));
    }
    let (code, _, errors) = check();
    assert!(code == 5 && errors.contains("cannot use report.json: its delays"), "{errors}");
}

/// Sentences hold for a spec with fewer than two rates and with intervals.
#[test]
fn sentences_are_true_with_few_rates_and_with_intervals() {
    let folder = assessed();
    let out = folder.path().join("out");
    let (page, argument) = (read(&out, "index.html"), read(&out, "argument.json"));
    let quantities = json(&out, "quantities.json");
    let modes = quantities["modes"].as_array().unwrap();
    let left_out: Vec<&Value> = modes.iter().filter(|mode| mode["in_fault_tree"] == false).collect();
    assert!(left_out.len() == 1 && left_out[0]["mode"] == "ice" && left_out[0]["rate_per_h"].is_null());
    let open = left_out[0]["uncovered_s"].as_f64().unwrap();
    let sentence = format!(
        "ice has no rate: left out of these numbers, of the fault tree and of its cut sets; uncovered for {open:.2} of \
         12.00 s x fault"
    );
    for name in ["index.html", "faulttree.xml"] {
        assert!(read(&out, name).contains(&sentence), "{name}: {sentence}");
    }
    for text in
        ["board (with a rate), ice (without a rate)", "of 1 pair of modes with rates", "2 more pairs have a mode"]
    {
        assert!(page.contains(text), "{text}: {page}");
    }
    assert!(argument.contains("ice is uncovered for "));
    assert!(!argument.contains("covered throughout"));

    // The bound of a mode is that of its highest rate.
    let uncovered = quantities["modes"][0]["uncovered_s"].as_f64().unwrap() / 3600.0;
    let of = |rate: f64| format!("{:.3e}", rate * uncovered);
    let bound = format!("M1 strikes where it is uncovered with a probability of at most {}", of(1.5e-5));
    assert!(argument.contains(&bound), "{bound}: {argument}");
    assert!(argument.contains(&format!("{} in the middle of the interval of its rate", of(1e-5))), "{argument}");

    // Both strike: without regard to cover more often than both where they are covered.
    let two = &quantities["two_modes_strike"];
    let p = |member: &str| two[member].as_f64().unwrap();
    let hours = 12.0 / 3600.0;
    assert!((p("per_mission") / (1e-5 * hours * 2e-6 * hours) - 1.0).abs() < 1e-6);
    assert!(p("both_where_covered_at_most") < p("per_mission"));
    assert!(page.contains(&format!("{:.3e}", p("per_mission"))), "{page}");
    // The argument has both at one end of the rates: that of M1 is an interval.
    let high = 1.5e-5 * hours * 2e-6 * hours;
    assert!(argument.contains(&format!("with the highest rates (strikes of two modes, covered or not: {high:.3e})")));

    // No more is saved by a second than there is.
    for mode in modes.iter().filter(|mode| mode["in_fault_tree"] == true) {
        let parts = ["none_found_s", "failed_flights_s"].map(|member| mode[member].as_f64().unwrap());
        assert!((mode["uncovered_s"].as_f64().unwrap() - parts[0] - parts[1]).abs() < 1e-12, "{mode}");
        let open = mode["uncovered_s"].as_f64().unwrap().min(1.0);
        let saved = mode["saved_by_a_second_more_covered"].as_f64().unwrap();
        assert!((saved - mode["rate_per_h"].as_f64().unwrap() * open / 3600.0).abs() <= 1e-8 * saved, "{mode}");
    }
    let flights = &quantities["flights"];
    let [flown, failed] = ["flown", "failed"].map(|member| flights[member].as_f64().unwrap());
    let share = flights["largest_share_of_failures_at_95_percent"].as_f64().unwrap();
    assert!(failed / flown < share && share < 1.0, "{flights}");
    if failed == 0.0 {
        assert!((share - (1.0 - 0.05_f64.powf(1.0 / flown))).abs() < 1e-12, "{flights}");
    }
}

/// A vehicle beside its landing site, for which nearly every way out is proved between the instants too.
const PROVED: &str = r#"
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 21 cm
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.5 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults { mode M1 { rotors [1] lost; rate = 1e-5 1/h }; mode M2 { rotors [2, 3, 4] lost; rate = 1e-7 1/h } }
mission hop {
    ground = 0 m
    start at [0, 0, 4] m
    waypoint at [8, 0, 5] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [4, 4, 0] m; radius = 1.5 m }
}
plan {
    model = hover
    planner = rip
    against = [M1]
    time = 6 s
    samples = 30
    recovery { order = [land_at_sites]; detection = 200 ms; within = 15 s }
}
"#;

/// A folder with this spec, and what the command makes of it in `out`.
fn proved() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "hop.mav", PROVED);
    let (code, text, errors) = mavc_in(folder.path(), &["safety", "hop.mav", "-o", "out"]);
    assert_eq!(code, 0, "{text}{errors}");
    folder
}

/// A flight that failed takes the time to the instants around it from the cover, in every file, also where the rotors
/// are proved to be able to fly it.
#[test]
fn a_way_out_whose_simulated_flight_failed_is_no_cover() {
    let folder = proved();
    let (folder, out) = (folder.path(), folder.path().join("out"));
    let mut report = json(&out, "report.json");
    let recovery = &mut report["recovery"];
    let survived = recovery["survived"].as_u64().unwrap();
    assert_eq!(survived, recovery["flown"].as_u64().unwrap());
    let mode = &mut recovery["modes"][0];
    assert_eq!(mode["name"], "M1");
    let long = |piece: &&mut Value| piece["branches"].as_array().unwrap().len() > 4;
    let piece = mode["pieces"].as_array_mut().unwrap().iter_mut().find(long).unwrap();
    let struck = |k: usize| -> f64 {
        let name = piece["branches"][k].as_str().unwrap().strip_prefix("M1_").unwrap();
        name.split_once('s').unwrap().0.parse().unwrap()
    };
    let seconds = struck(4) - struck(1);
    let of =
        |k: usize| serde_json::json!({"branch": piece["branches"][k], "from_s": struck(k - 1), "to_s": struck(k + 1)});
    let failed = [of(2), of(3)];
    let names: Vec<String> = failed.iter().map(|flight| flight["branch"].as_str().unwrap().to_string()).collect();
    piece["failed"] = Value::from(failed.to_vec());
    let assess = |report: &Value, name: &str| {
        write(folder, "failed.json", &report.to_string());
        let args = ["--report", "failed.json", "--certificate", "out/certificate.json"];
        mavc_in(folder, &[&["safety", "hop.mav", "-o", name], &args[..]].concat())
    };
    let (code, _, errors) = assess(&report, "miscounted");
    assert!(code == 2 && errors.contains("it does not name every simulated flight that failed"), "{errors}");
    report["recovery"]["survived"] = Value::from(survived - 2);
    // A failed flight that counts for less than the time to the instants around it.
    let mut shorter = report.clone();
    let pieces = shorter["recovery"]["modes"][0]["pieces"].as_array_mut().unwrap();
    let piece = pieces.iter_mut().find(|piece| !piece["failed"].as_array().is_none_or(Vec::is_empty)).unwrap();
    let from = &mut piece["failed"][0]["from_s"];
    *from = Value::from(from.as_f64().unwrap() + 0.1);
    let (code, _, errors) = assess(&shorter, "shorter");
    assert!(code == 2 && errors.contains("does not count for the time around it"), "{errors}");
    let (code, text, errors) = assess(&report, "failed");
    assert_eq!(code, 0, "{text}{errors}");
    assert!(text.contains("if ways out whose simulated flight failed covered their time: "), "{text}");

    let (before, after) = (json(&out, "quantities.json"), json(&folder.join("failed"), "quantities.json"));
    let of_mode = |quantities: &Value, member: &str| quantities["modes"][0][member].as_f64().unwrap();
    assert!((of_mode(&after, "failed_flights_s") - seconds).abs() < 1e-9);
    let more = of_mode(&after, "uncovered_s") - of_mode(&before, "uncovered_s");
    let less = of_mode(&before, "proved_s") - of_mode(&after, "proved_s");
    assert!((more - seconds).abs() < 1e-9 && (less - seconds).abs() < 1e-9, "{more} {less} {seconds}");
    let p = |quantities: &Value, member: &str| quantities["loss_of_control"][member].as_f64();
    let member = "per_mission_if_failed_flights_were_covered";
    assert_eq!(p(&before, member), None);
    assert_eq!(p(&after, member), p(&before, "per_mission"));
    assert!(p(&after, "per_mission") > p(&after, member));
    let (probability, _) = enumerated(&read(&folder.join("failed"), "faulttree.xml"));
    assert!(close(p(&after, "per_mission").unwrap(), probability));

    let sheet = rows(&read(&folder.join("failed"), "fmea.csv"));
    let rows_of = |is_failed: bool| {
        let basis = "found at an instant, but its simulated flight failed";
        sheet.iter().filter(move |row| row["mode"] == "M1" && (row["basis"] == basis) == is_failed)
    };
    let exposed: f64 = rows_of(true).map(|row| row["exposure_s"].parse::<f64>().unwrap()).sum();
    assert!((exposed - seconds).abs() < 1e-9, "{exposed}");
    let provisions =
        |is_failed: bool| rows_of(is_failed).map(|row| row["provision"].clone()).collect::<Vec<_>>().join(" ");
    assert_eq!(provisions(true), names.join(" "));
    assert!(names.iter().all(|name| !provisions(false).contains(name)));
    let argument = read(&folder.join("failed"), "argument.json");
    assert!(argument.contains(&format!("{seconds:.2} s of it because simulated flights failed")), "{argument}");
    let flights = &after["flights"];
    assert!(flights["failed"] == 2 && flights["failed_where_a_way_out_is_proved"] == 2, "{flights}");
    let flown = &flights["flown"];
    let counted = format!("2 of {flown} simulated flights failed, 2 of them where the certificate proves a way out");
    assert!(
        unwrapped(&text).contains(&counted) && read(&folder.join("failed"), "index.html").contains(&counted),
        "{text}"
    );
}

#[test]
fn the_argument_uses_ways_out_that_the_certificate_proves() {
    let folder = proved();
    let out = folder.path().join("out");
    let proved = json(&out, "quantities.json")["modes"][0]["proved_s"].as_f64().unwrap();
    assert!(proved > 0.9 * 6.0, "{proved}");
    // The report counts what its search proved; the certificate decides.
    let reported = json(&out, "report.json")["recovery"]["modes"][0]["proved_s"].as_f64().unwrap();
    assert!((proved - reported).abs() < 1e-9, "{proved} {reported}");
    let sheet = rows(&read(&out, "fmea.csv"));
    let of = |mode: &str, basis: &str| -> f64 {
        let rows = sheet.iter().filter(|row| row["mode"] == mode && row["basis"] == basis);
        rows.map(|row| row["effect_s"].parse::<f64>().unwrap()).sum()
    };
    let checked = of("M1", "checked at the instants looked at, and simulated");
    assert!((of("M1", "proved at every instant, and simulated") - proved).abs() < 1e-9);
    assert!((checked + proved - 6.0).abs() < 1e-9, "{checked}");
    assert!((of("M2", "none sought: hover is lost") - 6.0).abs() < 1e-9);
    // One reason in one wording.
    for name in ["index.html", "argument.json"] {
        assert!(read(&out, name).contains("none sought: hover is lost"), "{name}");
    }

    let argument = json(&out, "argument.json");
    let texts = |kind: &str| -> Vec<String> {
        let nodes = argument["nodes"].as_array().unwrap().iter().filter(|node| node["type"] == kind);
        nodes.map(|node| format!("{} {}", node["text"].as_str().unwrap(), node["sha256"])).collect()
    };
    let certificate: String = Sha256::digest(std::fs::read(out.join("certificate.json")).unwrap())
        .iter()
        .map(|b| format!("{b:02x}"))
        .collect();
    let due =
        format!("certificate.json: ways out after M1, proved at every instant of {proved:.2} s \"{certificate}\"");
    assert!(texts("solution").contains(&due), "{:?}", texts("solution"));
    let between = match checked > 1e-9 {
        true => format!("The certificate proves {proved:.2} s of the {:.2} s x fault", proved + checked),
        false => "from there a way out is proved at every instant".into(),
    };
    assert!(texts("assumption").iter().any(|text| text.contains(&between)), "{:?}", texts("assumption"));

    // A certificate of the same plan without these families proves none of it.
    let mut bare = json(&out, "certificate.json");
    assert!(bare["claim"]["plan"]["recovery"]["families"].as_array().is_some_and(|all| !all.is_empty()));
    bare["claim"]["plan"]["recovery"] = Value::Null;
    write(folder.path(), "bare.json", &bare.to_string());
    let args = ["safety", "hop.mav", "-o", "bare", "--report", "out/report.json", "--certificate", "bare.json"];
    let (code, text, errors) = mavc_in(folder.path(), &args);
    assert_eq!(code, 0, "{text}{errors}");
    let bare = folder.path().join("bare");
    assert_eq!(json(&bare, "quantities.json")["modes"][0]["proved_s"], 0.0);
    assert!(read(&bare, "argument.json").contains("Ways out hold between the instants looked at; this is not shown."));
    assert!(!read(&bare, "fmea.csv").contains("proved at every instant"));
}

#[test]
fn the_target_of_the_spec_decides_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    for (target, expected, word) in [("1e-9", 4, "exceeds"), ("1e-3", 7, "meets")] {
        let plan = format!("planner = rsp; require risk <= {target}");
        write(folder.path(), "field.mav", &SPEC.replace("planner = rip", &plan));
        let (code, text, errors) = mavc_in(folder.path(), &["safety", "field.mav", "-o", "out"]);
        assert_eq!(code, expected, "{text}{errors}");
        let text = unwrapped(&text);
        assert!(text.contains(&format!("{word} the target of the spec")), "{text}");
        assert!(text.contains("compared is the loss of control"), "{text}");
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
    let quantities = json(&out, "quantities.json");
    assert!(quantities["modes"].as_array().unwrap().iter().all(|mode| mode["in_fault_tree"] == true));
    let page = read(&out, "index.html");
    let singles = format!("{} single cut sets in all", cut_sets.len() - doubles);
    assert!(
        page.contains("By time, because no mode has a rate: M1, uncovered for ") && page.contains(&singles),
        "{page}"
    );
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
