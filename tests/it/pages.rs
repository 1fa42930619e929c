//! The report page: one file that loads nothing, says what the records say, and takes nothing in a spec for its own.

use crate::cli::mavc;
use serde_json::Value;
use std::path::Path;
use std::process::Output;

const CASE_1: &str = "specs/paper/case1.mav";

/// Enough samples to draw, and a third of the time to plan.
const FEWER: &str = "plan.samples=60";

/// A spec that plans in a moment, with the worst names and comments that its words can hold.
const HOSTILE: &str = r#"
// </script><script>alert("comment")</script> <img src=x onerror=alert(1)> <!-- <script>
/// Quad </style></pre><b onmouseover="alert(2)">&amp; bold</b>
vehicle quad {
    layout  = "PNPNPNPN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }
}
faults {
    mode bad "</script><script>alert('title')</script>" { rotor 1 lost }
    /// A mode that nothing is planned against.
    mode idle "'><svg onload=alert(3)>" { rotor 2 reduced to 80 % }
}
/// </script><script>alert("doc")</script>
mission hop {
    start at [0, 0, 2] m
    waypoint at [3, 1, 4] m  within 5 cm
    limits { speed <= 9 m/s; tilt <= 60 deg; yaw_rate <= 90 deg/s }
}
plan { model = hover; planner = rip; against = [bad]; time = 6 s; samples = 40; reserve = 5 % }
"#;

fn page(args: &[&str], dir: &Path) -> (Output, String) {
    let path = dir.join("report.html");
    let ran = mavc(&[args, &["--html", path.to_str().unwrap()]].concat());
    (ran, std::fs::read_to_string(path).unwrap_or_default())
}

/// The element's text, as a browser would cut it out: up to the first closing tag.
fn between<'a>(page: &'a str, open: &str, close: &str) -> &'a str {
    let from = page.find(open).unwrap_or_else(|| panic!("no {open}")) + open.len();
    &page[from..from + page[from..].find(close).unwrap()]
}

fn content(page: &str) -> Value {
    serde_json::from_str(between(page, r#"<script id="content" type="application/json">"#, "</script>")).unwrap()
}

/// The page without what it was bundled with.
fn own(page: &str) -> String {
    let style = between(page, "<style>", "</style>");
    let script = &page[page.rfind("<script>").unwrap()..];
    page.replace(style, "").replace(script, "")
}

fn written(dir: &Path, spec: &str) -> String {
    let path = dir.join("spec.mav");
    std::fs::write(&path, spec).unwrap();
    path.to_str().unwrap().to_string()
}

#[test]
fn pages_stand_alone_and_come_out_alike() {
    let dir = tempfile::tempdir().unwrap();
    let (ran, first) = page(&["plan", CASE_1, "--set", FEWER], dir.path());
    assert_eq!(ran.status.code(), Some(0));
    let (_, second) = page(&["plan", CASE_1, "--set", FEWER], dir.path());
    assert_eq!(first, second);
    assert!(first.len() < 3_000_000, "{}", first.len());
    assert!(first.starts_with("<!DOCTYPE html>"));
    // Nothing is loaded: no address but the names of namespaces, and a policy that forbids it.
    for (i, _) in first.match_indices("://") {
        let around = &first[i.saturating_sub(5)..(i + 40).min(first.len())];
        assert!(around.contains("http://www.w3.org/"), "{around}");
    }
    assert!(first.contains("default-src 'none'; script-src 'sha256-"));
    let own = own(&first);
    for loader in [" src=", "<link", "@import", "url(", "<iframe", "<object", "<base"] {
        assert!(!own.contains(loader), "{loader}");
    }
    // The licences of what is bundled go with it.
    for holder in ["Leon Sorokin", "three.js authors", "Permission is hereby granted"] {
        assert!(first.contains(holder), "{holder}");
    }
}

#[test]
fn nothing_in_a_spec_becomes_markup_or_script() {
    let dir = tempfile::tempdir().unwrap();
    let spec = written(dir.path(), HOSTILE);
    for command in ["plan", "compare"] {
        let (ran, page) = page(&[command, &spec], dir.path());
        assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
        let own = own(&page);
        // The elements that the page itself has, and no more.
        assert_eq!((own.matches("<script").count(), own.matches("</script").count()), (1, 1));
        for tag in ["<img", "<svg", "<b ", "<!--", "onmouseover=\"", "<style></style></pre>"] {
            assert!(!own.contains(tag), "{tag}");
        }
        assert!(own.contains("&lt;/script&gt;&lt;script&gt;alert(&quot;comment&quot;)"));
        let sets = content(&page)["sets"].clone();
        assert_eq!(sets[1]["title"], "</script><script>alert('title')</script>");
    }
}

#[test]
fn pages_say_what_the_records_say() {
    let dir = tempfile::tempdir().unwrap();
    let report = dir.path().join("report.json");
    for command in ["plan", "compare"] {
        let (_, page) = page(&[command, CASE_1, "--set", FEWER, "--report", report.to_str().unwrap()], dir.path());
        let record: Value = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
        let content = content(&page);
        assert_eq!(content["record"], record);
        // The curves are those of the plans: the least margin drawn is near the record's, and never below it.
        for (run, told) in content["runs"].as_array().unwrap().iter().zip(record["planners"].as_array().unwrap()) {
            let time = run["columns"]["t"].as_array().unwrap().last().unwrap().as_f64().unwrap();
            assert_eq!(time, told["time_s"].as_f64().unwrap());
            let worst = -100.0 * told["modes"][0]["max_violation"].as_f64().unwrap();
            let margins = run["columns"]["margin_1"].as_array().unwrap();
            let cells = run["strips"][0]["margins"].as_array().unwrap();
            for drawn in [margins, cells] {
                let least = drawn.iter().map(|m| m.as_f64().unwrap()).fold(f64::INFINITY, f64::min);
                assert!(least >= worst - 0.01 && least <= worst + 1.0, "{least} {worst}");
            }
        }
    }
}

/// What the script is given of a set and of a wrench gives the margin that the planner's own rows give.
#[test]
fn rows_on_the_page_are_those_of_the_sets() {
    let dir = tempfile::tempdir().unwrap();
    let spec = written(dir.path(), HOSTILE);
    let (_, page) = page(&["plan", &spec], dir.path());
    let content = content(&page);
    let columns = &content["runs"][0]["columns"];
    let at = |name: &str, k: usize| columns[name][k].as_f64().unwrap();
    let rows = content["sets"][1]["rows"].as_array().unwrap();
    assert!(rows.len() > 10);
    for k in 0..columns["t"].as_array().unwrap().len() {
        let w = ["thrust", "tau_x", "tau_y", "tau_z"].map(|name| at(name, k));
        let slack = |row: &Value| {
            let n = |i: usize| row[i].as_f64().unwrap();
            n(4) - (0..4).map(|i| n(i) * w[i]).sum::<f64>()
        };
        let least = rows.iter().map(slack).fold(f64::INFINITY, f64::min);
        assert!((100.0 * least - at("margin_1", k)).abs() < 0.01, "{least} at {k}");
    }
    // Modes that nothing is planned against are shown without margins of their own.
    assert_eq!(content["sets"][2]["name"], "idle");
    assert_eq!(content["sets"][2]["planned"], false);
    assert!(columns.get("margin_2").is_none());
}

#[test]
fn a_page_without_a_plan_explains_itself_in_the_spec() {
    let dir = tempfile::tempdir().unwrap();
    // Proved impossible, with what stands in the way labelled in place.
    let (ran, text) = page(&["plan", CASE_1, "--set", "plan.time=5s"], dir.path());
    assert_eq!(ran.status.code(), Some(3));
    assert!(text.contains("mavc::plan::conflict") && text.contains("class=\"remark error\""));
    assert!(content(&text)["runs"].as_array().unwrap().is_empty());
    assert!(text.contains("cannot hold together"));
    assert!(String::from_utf8_lossy(&ran.stdout).contains("Page written to "));
    // Statements in the order of the text, and no columns of dashes for a plan that is not there.
    let found = between(&text, "id=\"found\"", "</section>");
    let lines = |found: &str| -> Vec<usize> {
        found.split("line ").skip(1).filter_map(|after| after.split(':').next()?.parse().ok()).collect()
    };
    assert!(!found.contains('`'), "{found}");
    assert!(!text.contains("Committed"));
    // What the command line says is no line of the spec, and stands after what the spec says.
    assert_eq!(lines(found), [13], "{found}");
    assert!(found.contains("<code>--set plan.time=5s</code>: in 5\u{a0}s"), "{found}");
    let spec_part = between(&text, "<section id=\"spec\">", "</section>");
    let (_, set) = spec_part.split_once("Set on the command line").unwrap();
    assert!(set.contains("--set plan.<mark class=\"error\">time=5s</mark>"), "{set}");
    assert!(!set.contains("line 1"), "{set}");
    let both = std::fs::read_to_string(CASE_1).unwrap().replace("= minimum", "= 5 s");
    let both = both.replace("../vehicles/", concat!(env!("CARGO_MANIFEST_DIR"), "/specs/vehicles/"));
    let (_, text) = page(&["plan", &written(dir.path(), &both)], dir.path());
    let in_spec = lines(between(&text, "id=\"found\"", "</section>"));
    assert!(in_spec.len() > 1 && in_spec.is_sorted(), "{in_spec:?}");
    assert!(!text.contains("Set on the command line"));
    // A mode that cannot be stood.
    let spec = HOSTILE.replace("rotor 1 lost", "rotors [1, 2, 3, 4] lost");
    let (ran, text) = page(&["plan", &written(dir.path(), &spec)], dir.path());
    assert_eq!(ran.status.code(), Some(3));
    assert!(text.contains("Nothing was planned") && text.contains("mavc::analysis::cannot_hover"));
    assert!(String::from_utf8_lossy(&ran.stdout).contains("Page written to "));
    assert!(between(&text, "id=\"found\"", "</section>").contains("To fix it: "));
    assert!(text.contains("against bad, ") && !text.contains("Committed"));
    // Mistakes are told where they were made: nothing is written.
    std::fs::remove_file(dir.path().join("report.html")).unwrap();
    let (ran, text) = page(&["plan", &written(dir.path(), &HOSTILE.replace("1.8 kg", "1.8 m"))], dir.path());
    assert_eq!((ran.status.code(), text.as_str()), (Some(1), ""));
}

#[test]
fn pages_keep_to_the_rules_of_results() {
    let dir = tempfile::tempdir().unwrap();
    let spec = written(dir.path(), HOSTILE);
    let one = dir.path().join("one");
    let one = one.to_str().unwrap();
    for other in ["--report", "-o", "--certificate"] {
        let ran = mavc(&["plan", "-v", &spec, "--html", one, other, one]);
        assert_eq!(ran.status.code(), Some(2), "{other}");
        assert!(String::from_utf8_lossy(&ran.stderr).contains("same place"));
    }
    let ran = mavc(&["plan", "-v", &spec, "--html", &spec]);
    assert_eq!(ran.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&spec).unwrap(), HOSTILE);
    // Standard output has a page to itself.
    let ran = mavc(&["plan", "-v", &spec, "--html", "-"]);
    let text = String::from_utf8(ran.stdout).unwrap();
    assert!(text.starts_with("<!DOCTYPE html>") && text.ends_with("</html>"));
    assert!(String::from_utf8_lossy(&ran.stderr).contains("RIP: found, 6 s"));
}

/// Long flights, large vehicles and many modes make a page that is still small.
#[test]
#[ignore = "long"]
fn pages_stay_small() {
    let dir = tempfile::tempdir().unwrap();
    let spec = HOSTILE
        .replace("PNPNPNPN", &"PN".repeat(6))
        .replace("against = [bad]", "against = all")
        .replace("samples = 40", "samples = 1200")
        .replace("/// A mode that nothing", "every 2 rotors reduced to 70 % as R\n    /// A mode that nothing");
    let filler = format!("// {}\n", "<&\"'>".repeat(60)).repeat(2_500);
    let (ran, text) = page(&["plan", &written(dir.path(), &(spec + &filler))], dir.path());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    assert!(text.len() < 3_000_000, "{}", text.len());
    assert!(text.contains("lines omitted"));
    assert!(content(&text)["sets"].as_array().unwrap().len() <= 25);
}

#[test]
fn flights_and_campaigns_have_pages() {
    let dir = tempfile::tempdir().unwrap();
    let spec = written(
        dir.path(),
        &HOSTILE.replace("yaw_rate <= 90 deg/s }", "yaw_rate <= 90 deg/s }\n}\nsimulate { fault bad at 3 s"),
    );
    let report = dir.path().join("report.json");
    let recorded = || -> Value { serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap() };
    let (ran, text) = page(&["simulate", &spec, "--report", report.to_str().unwrap()], dir.path());
    assert!(matches!(ran.status.code(), Some(0 | 6)), "{}", String::from_utf8_lossy(&ran.stderr));
    let drawn = content(&text);
    assert_eq!(drawn["record"], recorded());
    // The flight first, then the plan it was flown along.
    assert_eq!(drawn["runs"][0]["label"], "the flight");
    assert_eq!(drawn["runs"].as_array().unwrap().len(), 2);
    let columns = &drawn["runs"][0]["columns"];
    let farthest = columns["error"].as_array().unwrap().iter().map(|e| e.as_f64().unwrap()).fold(0.0, f64::max);
    let told = recorded()["max_error_m"].as_f64().unwrap();
    assert!(farthest <= told * 1.001 && farthest > 0.9 * told, "{farthest} {told}");
    // The heading flown against the one planned, and their difference as the record has it.
    let chart = drawn["runs"][0]["charts"].as_array().unwrap().iter().find(|c| c["id"] == "yaw").unwrap();
    let lines: Vec<_> = chart["lines"].as_array().unwrap().iter().map(|l| l["column"].as_str().unwrap()).collect();
    assert_eq!((lines, &chart["unit"]), (vec!["heading", "yaw_ref"], &"deg".into()));
    let column = |name: &str| columns[name].as_array().unwrap().iter().map(|v| v.as_f64().unwrap());
    let worst = column("heading").zip(column("yaw_ref")).map(|(flown, due)| (flown - due).abs()).fold(0.0, f64::max);
    let told = recorded()["max_heading_error_rad"].as_f64().unwrap().to_degrees();
    assert!(worst > 0.0 && worst <= told * 1.001 && worst > 0.8 * told, "{worst} {told}");
    assert_eq!(drawn["runs"][0]["marks"][0]["t"], 3.0);
    // The page opens where the vehicle is farthest off.
    let at = columns["t"].as_array().unwrap().iter().position(|t| *t == drawn["opens"]["t"]).unwrap();
    assert_eq!(columns["error"][at].as_f64().unwrap(), farthest);
    // Before the fault, under it, and where it was detected from then on.
    let phases: Vec<(f64, &str)> = drawn["runs"][0]["phases"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| (p["from"].as_f64().unwrap(), p["label"].as_str().unwrap()))
        .collect();
    let mut expected = vec![(0.0, "no fault"), (3.0, "bad undetected")];
    expected.extend(recorded()["faults"][0]["detected_after_s"].as_f64().map(|d| (3.0 + d, "bad detected")));
    assert_eq!(phases, expected);
    let (ran, text) =
        page(&["campaign", &spec, "--times", "3", "--seeds", "1", "--report", report.to_str().unwrap()], dir.path());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    assert_eq!(content(&text)["record"], recorded());
    // Every cell of the map is one of the record.
    let map = &recorded()["planners"][0]["modes"][0]["times"];
    let cell = |k: usize| format!("{}/{}</td>", map[k]["lost"], map[k]["struck"]);
    assert!((0..3).all(|k| map[k]["struck"] == 0 || text.contains(&cell(k))));
    assert!(!own(&text).contains("<img"));
    // Why there is no phi, in words.
    let undefined = recorded()["agreement"][0]["by_flight"][0]["phi"].is_null();
    assert_eq!(
        undefined,
        text.contains("the prediction of losses cannot be judged") || text.contains("carries no information")
    );
}

/// The page tells a lost flight, and the delay of detection, in the words of the text.
#[test]
fn a_lost_flight_is_reported_as_in_the_text() {
    let dir = tempfile::tempdir().unwrap();
    let spec = HOSTILE.replace(
        "yaw_rate <= 90 deg/s }",
        "yaw_rate <= 90 deg/s }\n}\nsimulate { fault bad at 3 s; detection = 20 ms; lost_beyond = 1 cm",
    );
    let spec = written(dir.path(), &spec);
    let (ran, text) = page(&["simulate", &spec], dir.path());
    assert_eq!(ran.status.code(), Some(6), "{}", String::from_utf8_lossy(&ran.stderr));
    let told = String::from_utf8(ran.stdout).unwrap();
    let cause = "more than 0.01 m off the plan";
    assert!(told.contains(cause), "{told}");
    let text = own(&text).replace('\u{a0}', " ");
    assert!(text.contains(cause), "{}", between(&text, "headline", "</h2>"));
    assert_eq!(text.matches("etection: after 20 ms").count(), 2);
    let (ran, text) = page(&["campaign", &spec, "--times", "2", "--seeds", "1"], dir.path());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    assert!(own(&text).contains("Detection: after 20 ms"));
}

/// Modes with one margin: whatever tells the nearest names the first.
#[test]
fn of_equal_modes_the_first_is_named_everywhere() {
    let dir = tempfile::tempdir().unwrap();
    let modes: String = (0..4).map(|k| format!("    mode m{k} {{ rotor 1 lost }}\n")).collect();
    let spec = HOSTILE.replace("faults {\n", &format!("faults {{\n{modes}")).replace("[bad]", "[m0, m1, m2, m3]");
    let (ran, text) = page(&["plan", &written(dir.path(), &spec)], dir.path());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    assert!(text.contains("in the set of m0,"));
    // There the page opens.
    let drawn = content(&text);
    assert_eq!(drawn["sets"][drawn["opens"]["set"].as_u64().unwrap() as usize]["name"], "m0");
    let column = |name: &str| drawn["runs"][0]["columns"][name].as_array().unwrap().clone();
    let margins: Vec<f64> = column("margin_1").iter().map(|m| m.as_f64().unwrap()).collect();
    let at = column("t").iter().position(|t| *t == drawn["opens"]["t"]).unwrap();
    assert_eq!(margins[at], margins.iter().copied().fold(f64::INFINITY, f64::min));
    let charts = content(&text)["runs"][0]["charts"].clone();
    let headline = charts[0]["headline"].as_str().unwrap();
    assert!(headline.ends_with("m0"), "{headline}");
    // A number and its unit stay on one line.
    assert!(between(&text, "<h2 class=\"headline\">", "</h2>").contains("6\u{a0}s"));
}

#[test]
fn charts_become_svg_files() {
    let dir = tempfile::tempdir().unwrap();
    let spec = written(dir.path(), HOSTILE);
    let (one, two) = (dir.path().join("one"), dir.path().join("two/deep"));
    for folder in [&one, &two] {
        let ran = mavc(&["plan", "-v", &spec, "--svg", folder.to_str().unwrap()]);
        assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
        let told = format!("Figures written to {}", folder.display());
        assert!(String::from_utf8_lossy(&ran.stdout).contains(&told));
    }
    let mut names: Vec<String> =
        std::fs::read_dir(&one).unwrap().map(|f| f.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    for name in
        ["margin.svg", "position.svg", "rotors.svg", "set-bad.svg", "set-healthy.svg", "speed.svg", "thrust.svg"]
    {
        assert!(names.contains(&name.to_string()), "{name}: {names:?}");
    }
    for name in &names {
        let text = std::fs::read_to_string(one.join(name)).unwrap();
        assert_eq!(text, std::fs::read_to_string(two.join(name)).unwrap());
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>") && !text.contains("<script"));
        assert!(text.contains("<poly"), "{name} has no curve");
    }
    let read = |name: &str| std::fs::read_to_string(one.join(name)).unwrap();
    // A long label of the axis up is told in lines, each whole: the axis is 870 high, a letter some 20 wide.
    let margin = read("margin.svg");
    let texts = |svg: &str| -> Vec<String> {
        svg.lines().filter(|l| !l.starts_with('<') && !l.is_empty()).map(str::to_string).collect()
    };
    let label = ["Spare in each fault mode&apos;s set, in", "widths of the healthy set [%]"];
    assert!(label.iter().all(|line| texts(&margin).contains(&line.to_string())), "{:?}", texts(&margin));
    // Areas, path and cross are named.
    for name in ["healthy", "bad", "planned wrench", "hover"] {
        assert!(texts(&read("set-bad.svg")).contains(&name.to_string()), "{name}");
    }
    assert!(!texts(&read("set-healthy.svg")).contains(&"bad".to_string()));
    // The legend of the rotors stands above the curves, and only the first is drawn in one line.
    let rotors = read("rotors.svg");
    let drawn: Vec<usize> = ["#0072B2", "#D55E00", "#009E73"]
        .iter()
        .map(|color| rotors.matches(&format!("stroke=\"{color}\"")).count())
        .collect();
    assert!(drawn[0] == 2 && drawn[1] > 20 && drawn[2] > 20, "{drawn:?}");
    // Planners side by side: every one's figures have its name.
    let side_by_side = dir.path().join("side by side");
    let ran = mavc(&["compare", "-v", CASE_1, "--set", FEWER, "--svg", side_by_side.to_str().unwrap()]);
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    let drawn = |name: &str| std::fs::read_to_string(side_by_side.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    for name in ["thrust-RIP.svg", "thrust-RCP-M1.svg", "set-M1-RIP.svg", "set-healthy-RSP.svg"] {
        assert!(drawn(name).contains("<poly"), "{name}");
    }
    assert!(drawn("set-M1-RIP.svg") != drawn("set-M1-RSP.svg"));
    assert!(!side_by_side.join("thrust.svg").exists());
    // What cannot be a folder is refused before anything is planned or written.
    let page = dir.path().join("page.html");
    for folder in [spec.clone(), format!("{spec}/deep")] {
        let ran = mavc(&["plan", "-v", &spec, "--html", page.to_str().unwrap(), "--svg", &folder]);
        assert_eq!((ran.status.code(), ran.stdout.len()), (Some(2), 0), "{folder}");
        assert!(!page.exists());
    }
    assert_eq!(std::fs::read_to_string(&spec).unwrap(), HOSTILE);
}
