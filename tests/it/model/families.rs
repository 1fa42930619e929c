//! `against` by families and ranges of fault modes.

use super::QUAD;

const FAULTS: &str = "faults {
 mode worn { rotor 2 reduced to 80 % }
 every 1 rotor reduced to 90 % as W
 every 2 rotors reduced to 90 % as W
 every 1 rotor reduced to 80 % as L
}
mission m {
 start at [0, 0, 2] m
 waypoint at [4, 0, 2] m
}
";

fn spec(against: &str) -> String {
    format!("{QUAD}{FAULTS}plan {{ time = 20 s; against = {against} }}\n")
}

/// The modes that an `against` chooses, and the codes of what is reported of it beside modes that are not used.
fn chosen(against: &str) -> (Vec<String>, Vec<&'static str>) {
    let (model, diagnostics) = super::check(&spec(against));
    let codes = diagnostics.iter().map(|d| d.code).filter(|code| *code != "mavc::fault::unused").collect();
    let names = model.map(|m| m.plan.against.iter().map(|&k| m.modes[k].name.clone()).collect());
    (names.unwrap_or_default(), codes)
}

#[test]
fn families_and_ranges_are_the_modes_they_declare() {
    let singles = ["W1", "W2", "W3", "W4"];
    let doubles = ["W1_2", "W1_3", "W1_4", "W2_3", "W2_4", "W3_4"];
    let both: Vec<&str> = singles.iter().chain(&doubles).copied().collect();
    for (against, wanted) in [
        ("W", &both[..]),
        ("[W]", &both[..]),
        ("W1 .. W4", &singles[..]),
        ("W2..W3", &["W2", "W3"]),
        ("W3 .. W3", &["W3"]),
        ("W1_3 .. W2_3", &["W1_3", "W1_4", "W2_3"]),
        ("[W2 .. W3, worn, L]", &["W2", "W3", "worn", "L1", "L2", "L3", "L4"]),
        ("[L, W1]", &["L1", "L2", "L3", "L4", "W1"]),
    ] {
        assert_eq!(chosen(against), (wanted.iter().map(ToString::to_string).collect(), vec![]), "{against}");
    }
    // As an option of the command line, too.
    let read = |_: &std::path::Path| Err(std::io::Error::from(std::io::ErrorKind::NotFound));
    let (mut files, _) = mavc::read::load("spec.mav", spec("all").as_bytes(), &read);
    let given = mavc::read::parse_override("plan.against=[W2..W4, worn]", &mut files.sources).unwrap();
    let model = mavc::read::elaborate(&files, &[given]).value.unwrap();
    let names: Vec<&str> = model.plan.against.iter().map(|&k| model.modes[k].name.as_str()).collect();
    assert_eq!(names, ["W2", "W3", "W4", "worn"]);
}

#[test]
fn what_is_listed_twice_counts_once_and_the_part_that_may_go_is_named() {
    for (against, count, warned) in [
        ("[W, W1]", 10, &["W1"][..]),
        ("[W1, W]", 10, &["W1"]),
        ("[W1 .. W3, W2]", 3, &["W2"]),
        ("[L, L]", 4, &["L"]),
        ("[W1 .. W2, W3 .. W4, W]", 10, &["W1 .. W2", "W3 .. W4"]),
        // Neither can go: each has a mode of its own.
        ("[W1 .. W3, W3 .. W4]", 4, &[]),
    ] {
        let text = spec(against);
        let (model, diagnostics) = super::check(&text);
        assert_eq!(model.unwrap().plan.against.len(), count, "{against}");
        let twice: Vec<_> = diagnostics.iter().filter(|d| d.code == "mavc::plan::listed_twice").collect();
        let at: Vec<&str> = twice.iter().map(|d| &text[d.span.start as usize..d.span.end as usize]).collect();
        assert_eq!(at, warned, "{against}");
        // What is offered mends it and changes no mode.
        for fix in twice.iter().filter_map(|d| d.fix.as_ref()).take(1) {
            let mut mended = text.clone();
            mended.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.text);
            let (model, left) = super::check(&mended);
            assert_eq!(model.unwrap().plan.against.len(), count, "{mended}");
            let left = left.iter().filter(|d| d.code == "mavc::plan::listed_twice").count();
            assert_eq!(left, twice.len() - 1, "{mended}");
        }
    }
}

#[test]
fn many_ranges_take_no_longer_for_it() {
    // Every range covers nearly all modes; what they choose is counted once.
    let faults = "faults { every 1 rotor reduced to 90 % as W; every 2 rotors reduced to 90 % as W }\n";
    let listed = "W1 .. W4, W, W1_2 .. W3_4, ".repeat(8_000);
    let text = format!("{QUAD}{faults}plan {{ against = [{listed}] }}\n");
    assert_eq!(super::codes(&text).len(), 501);
}

#[test]
fn a_strike_takes_one_mode_of_a_family() {
    let text = format!("{}simulate {{ fault W at 2 s }}\n", spec("W"));
    let (_, diagnostics) = super::check(&text);
    let error = diagnostics.iter().find(|d| d.code == "mavc::simulate::choice").unwrap();
    assert_eq!(error.message, "`W` names 10 fault modes, but only one can strike at a time");
    assert_eq!(error.fix.as_ref().unwrap().text, "W1");
}

#[test]
fn ranges_are_laid_out_with_blanks() {
    use mavc::source::{FileId, Source};
    let text = "plan { against=[W1..W4,L] }\n";
    let laid_out = mavc::format::format(FileId(0), &Source::new("t.mav", text)).value.unwrap();
    assert_eq!(laid_out, "plan { against = [W1 .. W4, L] }\n");
}
