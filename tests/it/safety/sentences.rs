//! Sentences and exit codes with few rates or none, with intervals and with a target.

use super::{SPEC, assessed, enumerated, json, read, unwrapped, write};
use crate::cli::mavc_in;
use serde_json::Value;

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
