//! The files of an assessment agree with each other, and the argument keeps the rules of its notation.

use super::{DERIVED, assessed, close, enumerated, json, read, rows};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

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
