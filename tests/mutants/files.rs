//! Files of other tools, through `mavc import` and `mavc check MISSION --vehicle`: a spec that is laid out as
//! `mavc fmt` does, or an error at a place of the file.

use mavc::diagnostic::{render_human, render_short, to_json_line};
use mavc::format::format;
use mavc::import::{Imported, mission, vehicle};
use mavc::source::{FileId, Source, SourceMap};
use mavc::{Compiler, Diagnostic, Severity};
use std::path::{Path, PathBuf};

/// What takes the place of a word, beside numbers.
pub const WORDS: [&str; 66] = [
    "CA_ROTOR0_PX",
    "CA_ROTOR_COUNT",
    "CA_AIRFRAME",
    "FRAME_CLASS",
    "FRAME_TYPE",
    "param",
    "set-default",
    "set",
    "MIXER",
    "null",
    "true",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "</",
    "/>",
    "<link>",
    "<!--",
    "]]>",
    "&amp;",
    "&x;",
    "<!DOCTYPE a [",
    "joint",
    "pose",
    "site",
    "gear",
    "motor",
    "ccw",
    "QGC WPL 110",
    "polygon",
    "inclusion",
    "SimpleItem",
    "ComplexItem",
    "\t",
    "16",
    "19",
    "21",
    "22",
    "115",
    "177",
    "178",
    "201",
    "VM_MASS",
    "MPC_THR_HOVER",
    "BAT1_CAPACITY",
    "MOT_THST_HOVER",
    "Q_FRAME_CLASS",
    "frame",
    "model",
    "relative_to",
    "attached_to",
    "degrees",
    "rotation_format",
    "inertial",
    "default",
    "geom",
    "fromto",
    "euler",
    "general",
    "gainprm",
    "settotalmass",
    "revolute",
];

const VEHICLES: [&str; 6] = ["quad_script.sh", "hexa.params", "octa.param", "quad.sdf", "nano.urdf", "hexa.xml"];
const MISSIONS: [&str; 3] = ["field.waypoints", "table.csv", "../../../examples/field.plan"];

/// The texts that are changed: one file of each format that `mavc import` reads, and those that it once misread.
pub fn corpus() -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mutants/files");
    let read = |name: &&str| {
        let path = folder.join(name);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        (path, text)
    };
    let mut found: Vec<(PathBuf, String)> = VEHICLES.iter().chain(&MISSIONS).map(read).collect();
    let findings = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/findings/files");
    let entries = std::fs::read_dir(&findings).unwrap_or_else(|e| panic!("{}: {e}", findings.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    found.extend(paths.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())));
    found
}

/// Whether the file at a path is a mission.
fn is_mission(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    matches!(ending, Some("waypoints" | "csv" | "plan" | "txt"))
}

/// What the commands do with a file; whether a spec came of it.
pub fn check(path: &Path, bytes: &[u8]) -> bool {
    // A name that a terminal or a spec must not repeat as it is.
    let name = "a\u{202e}\u{1b}[31m\" b.params";
    let imported = vehicle::import(name, bytes);
    let is_vehicle = looked_at(&imported);
    let imported = mission::import(name, bytes, Some("../v.mav"));
    let has_mission = looked_at(&imported);
    if is_mission(path) {
        let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs/vehicles/octo_ppnnppnn.mav");
        let joined = mission::join(name, bytes, &beside.display().to_string(), &Compiler::new(), mavc::check);
        shown(&joined.diagnostics, &joined.files.sources);
        assert!(joined.spec.is_some() || has_error(&joined.diagnostics));
    }
    is_vehicle || has_mission
}

/// Every diagnostic has a place and can be shown, and a spec is one; whether there is one.
fn looked_at(imported: &Imported) -> bool {
    shown(&imported.diagnostics, &imported.sources);
    let Some(text) = &imported.text else {
        assert!(has_error(&imported.diagnostics), "neither a spec nor an error");
        return false;
    };
    let again = format(FileId(0), &Source::new("imported.mav", text.as_str()));
    assert_eq!(again.value.as_deref(), Some(text.as_str()), "{:?}", again.diagnostics);
    let compiled = Compiler::new().text("imported.mav", text.as_bytes());
    assert!(compiled.diagnostics.iter().all(|d| !d.code.starts_with("mavc::syntax")), "{text}");
    true
}

fn has_error(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| d.severity == Severity::Error)
}

fn shown(diagnostics: &[Diagnostic], sources: &SourceMap) {
    for d in diagnostics {
        for span in d.labels.iter().map(|label| label.span).chain([d.span]) {
            let text = &sources.get(span.file).text;
            assert!(text.get(span.start as usize..span.end as usize).is_some(), "no place in the file: {d:?}");
        }
        serde_json::from_str::<serde_json::Value>(&to_json_line(d, sources)).expect("a line of JSON");
    }
    let _ = render_short(diagnostics, sources);
    let human = render_human(diagnostics, sources, 100, false);
    assert!(!human.contains(['\u{202e}', '\u{1b}']), "a control character reaches the terminal: {human:?}");
}
