//! Files with mistakes, on purpose or not: an error at a place of the file, and never a panic.

use super::{PLAN, WPL, found, read};
use mavc::Severity;
use mavc::format::format;
use mavc::source::{FileId, Source};

fn refused(text: &str, code: &str) {
    let found = found(text);
    assert!(found.iter().any(|f| f.0 == code && f.1 == Severity::Error), "{}: {found:?}", &text[..text.len().min(80)]);
    assert!(read("x", text).text.is_none());
}

#[test]
fn mistakes_have_a_code_and_a_place() {
    const SYNTAX: &str = "mavc::import::syntax";
    const FORMAT: &str = "mavc::import::format";
    const UNSUPPORTED: &str = "mavc::import::unsupported";
    let with = |from: &str, to: &str| {
        assert!(PLAN.contains(from), "{from}");
        PLAN.replacen(from, to, 1)
    };
    for length in [1, 40, 900, PLAN.len() - 3] {
        refused(&PLAN[..length], SYNTAX);
    }
    refused(&with("47.3977507,", "97.3977507,"), SYNTAX);
    refused(&with("47.3977507,", "\"47.3977507\","), SYNTAX);
    refused(&with("47.3977507,", "NaN,"), SYNTAX);
    refused(&with("47.3977507,", "1e999,"), SYNTAX);
    refused(&with("488.931", "4889310"), SYNTAX);
    refused(&with("\"command\": 22", "\"command\": 22.5"), SYNTAX);
    refused(&with("\"command\": 22", "\"command\": \"22\""), SYNTAX);
    refused(&with("\"command\": 22,", ""), SYNTAX);
    refused(&with("[15, 0, 0, null,", "[15, 0, 0,"), SYNTAX);
    refused(&with("\"items\": [", "\"items\": 7, \"others\": ["), SYNTAX);
    refused(&with("\"doJumpId\": 1,", "\"command\": 16,"), SYNTAX);
    refused(&with("\"inclusion\": true", "\"inclusion\": 1"), SYNTAX);
    refused(&with("\"radius\": 150", "\"radius\": -150"), SYNTAX);
    refused(&with("[1, 8, -1", "[1, 0, -1"), SYNTAX);
    refused(&with("\"fileType\": \"Plan\"", "\"fileType\": \"Parameters\""), FORMAT);
    refused(&with("[3, 1.5, 0, 90, 47.39777106, 8.5466122,", "[3, 1.5, 0, 90, -47.4, 8.5,"), UNSUPPORTED);
    refused(&with("8.5466122, 50]", "8.5466122, 1e30]"), SYNTAX);
    refused(&with("\"version\": 2\n    },\n    \"rally", "\"version\": 3\n    },\n    \"rally"), UNSUPPORTED);
    refused(&with("[47.39810, 8.5459],\n                    [47.39810, 8.5463],", ""), UNSUPPORTED);
    let rally = |points: &str| with("\"points\": [\n        ]", &format!("\"points\": {points}"));
    for points in [
        "7",
        "[7]",
        "[[47.4]]",
        "[[47.4, \"8.5\", 3]]",
        "[[97, 8.5, 3]]",
        "[[47.4, 8.5, \"up\"]]",
        "[[47.4, 1e999, 3]]",
    ] {
        refused(&rally(points), SYNTAX);
    }
    refused(&rally("[[-47.4, 8.5, 3]]"), UNSUPPORTED);
    for line in ["RALLY 47.398", "RALLY 47.398 8.546 up", "RALLY 47.398 NaN 3", "RALLY 97 8.546 3"] {
        refused(&format!("{WPL}{line}\n"), SYNTAX);
    }
    refused("#saved by Mission Planner\nRALLY\t47.398\t8.546\t50\t0\t0\t0\n", FORMAT);
    for text in ["", "\n", "<xml/>", "vehicle v { }", "QGC WPL 120\n", "QGC WPL", "1,2\n3,4\n"] {
        refused(text, FORMAT);
    }
    assert!(found("CA_ROTOR_COUNT\t4\n")[0].2.contains("a vehicle and no mission"));
    refused("QGC WPL 110\n", SYNTAX);
    refused(&WPL.replace("\t47.398\t", "\tnorth\t"), SYNTAX);
    refused(&WPL.replace("\t47.398\t", "\tinf\t"), SYNTAX);
    refused(&WPL.replace("\t47.398\t", "\tNaN\t"), SYNTAX);
    refused(&WPL.replace("\t47.398\t", "\t"), SYNTAX);
    refused(&WPL.replace("47.3977507\t8.5456075", "0\t0"), UNSUPPORTED);
    refused("x,y,z\n1,2,3\n1,2\n", SYNTAX);
    refused("x,y,z\n1,2,3\n1,2,abc\n", SYNTAX);
    refused("x,y,z\n1,2,3\n1,2,NaN\n", UNSUPPORTED);
    refused("x,y,z,x\n1,2,3,4\n1,2,3,4\n", SYNTAX);
    refused("1,2,3\n", UNSUPPORTED);
}

#[test]
fn bombs_end_soon() {
    refused(&format!("{{\"fileType\":{}", "[".repeat(3_000_000)), "mavc::import::syntax");
    refused(&format!("{{\"fileType\":[{}0]}}", "0,".repeat(1_100_000)), "mavc::import::syntax");
    let item = r#"{"type":"SimpleItem","command":16,"frame":3,"params":[0,0,0,null,47.3977507,8.5456075,50]},"#;
    let many = PLAN.replacen("\"items\": [", &format!("\"items\": [{}", item.repeat(100_000)), 1);
    refused(&many, "mavc::import::syntax");
    let fewer = PLAN.replacen("\"items\": [", &format!("\"items\": [{}", item.repeat(20_000)), 1);
    refused(&fewer, "mavc::import::unsupported");
    refused(&"1,2,3\n".repeat(100_000), "mavc::import::unsupported");
    refused(
        &format!("{WPL}{}", "5\t0\t3\t16\t0\t0\t0\t0\t47.398\t8.546\t20\t1\n".repeat(100_000)),
        "mavc::import::unsupported",
    );
}

/// A generator of Lehmer, modulo 2^31 - 1.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0 * 48271 % 0x7fff_ffff;
        self.0 as usize % n
    }
}

/// Bytes changed, taken out, doubled and exchanged for words that matter.
fn mutant(text: &str, dice: &mut Dice) -> Vec<u8> {
    const WORDS: [&str; 18] = [
        "null", "-1", "1e308", "NaN", "\"", "{", "]", ",", "\t", "\n", "90.5", "-180", "0", "\\u0000", "é", "22", "10",
        "true",
    ];
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=dice.below(3) {
        let at = dice.below(bytes.len());
        let end = (at + 1 + dice.below(6)).min(bytes.len());
        match dice.below(4) {
            0 => bytes[at] = dice.below(256) as u8,
            1 => drop(bytes.drain(at..end)),
            2 => drop(bytes.splice(at..at, bytes[at..end].to_vec())),
            _ => drop(bytes.splice(at..end, WORDS[dice.below(WORDS.len())].bytes())),
        }
    }
    bytes
}

#[test]
fn mutants_never_panic_and_specs_of_mutants_can_be_parsed() {
    let mut dice = Dice(20);
    let (mut specs, mut refusals) = (0, 0);
    let table = "x,y,z,heading,t\n0,0,2,0,0\n10,0,2,90,3\n10,10,5,180,5.5\n";
    for text in [PLAN, WPL, table] {
        for _ in 0..250 {
            let bytes = mutant(text, &mut dice);
            let imported = mavc::import::mission::import("m\u{202e}.plan", &bytes, Some("../v.mav"));
            for d in &imported.diagnostics {
                let length = imported.sources.get(d.span.file).text.len();
                assert!(d.span.start <= d.span.end && d.span.end as usize <= length, "{d:?}");
            }
            let Some(spec) = imported.text else {
                assert!(imported.diagnostics.iter().any(|d| d.severity == Severity::Error));
                refusals += 1;
                continue;
            };
            let again = format(FileId(0), &Source::new("m.mav", spec.as_str()));
            assert_eq!(again.value.as_deref(), Some(spec.as_str()), "{:?}", again.diagnostics);
            specs += 1;
        }
    }
    assert!(specs > 50 && refusals > 200, "{specs} {refusals}");
}

/// A file that neither import reads is not called what the other one reads.
#[test]
fn files_of_neither_kind_are_not_called_the_other() {
    use mavc::import::vehicle;
    let message = |imported: mavc::import::Imported| imported.diagnostics.last().unwrap().clone();
    for text in ["<kml><Document/></kml>", "<gpx version='1.1'/>", "{\"waypoints\": []}", "x = 3\n", "a: 1\n"] {
        for error in [message(read("a", text)), message(vehicle::import("a", text.as_bytes()))] {
            let words = ["a vehicle and no mission", "this is a mission", "spec of mavc"];
            assert!(!words.iter().any(|words| error.message.contains(words)), "{text}: {error:?}");
        }
    }
    assert!(message(read("a", "<sdf version='1.9'/>")).message.contains("a vehicle and no mission"));
    assert!(message(vehicle::import("a", PLAN.as_bytes())).message.contains("this is a mission"));
    let older = message(read("a.mission", "{\"MAV_AUTOPILOT\": 3, \"items\": []}"));
    assert!(older.help.unwrap().contains("an older form"));
}
