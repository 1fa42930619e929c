//! Diagnostics while typing: those of `mavc check`, in all files, until the mistakes are fixed.

use super::client::{Client, SPEC, uri_of};
use lsp_server::Message;
use mavc::admissible::diagnose::diagnose;
use mavc::diagnostic::{Diagnostic, Severity, sort};
use mavc::flight::indistinguishable;
use mavc::input::read_named;
use mavc::read::{elaborate, entries, load_among};
use mavc::source::SourceMap;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// What `mavc check` says of a file.
fn check(path: &Path) -> (Vec<Diagnostic>, SourceMap) {
    let bytes = std::fs::read(path).unwrap();
    let (files, mut diagnostics) = load_among(path.to_str().unwrap(), &bytes, &read_named, &entries);
    let checked = elaborate(&files, &[]);
    diagnostics.extend(checked.diagnostics);
    let broken = diagnostics.iter().any(|d| d.severity == Severity::Error);
    if let Some(model) = checked.value.filter(|_| !broken) {
        diagnostics.extend(diagnose(&model));
        diagnostics.extend(indistinguishable::diagnose(&model));
    }
    sort(&mut diagnostics);
    (diagnostics, files.sources)
}

/// Code, severity, place and related places of a diagnostic of one file, as the protocol has them.
fn as_told(diagnostic: &Diagnostic, sources: &SourceMap) -> Value {
    let range = |span: mavc::source::Span| {
        let source = sources.get(span.file);
        let place = |at: u32| {
            let (line, character) = source.place_utf16(at as usize);
            json!({ "line": line, "character": character })
        };
        json!({ "start": place(span.start), "end": place(span.end) })
    };
    let severity = match diagnostic.severity {
        Severity::Error => 1,
        Severity::Warning => 2,
        Severity::Advice => 3,
    };
    let related: Vec<Value> = diagnostic
        .labels
        .iter()
        .map(|l| json!({ "message": l.message, "range": range(l.span), "file": sources.get(l.span.file).name }))
        .collect();
    json!({ "code": diagnostic.code, "severity": severity, "range": range(diagnostic.span), "related": related })
}

fn shortened(told: &Value) -> Value {
    let related = told["relatedInformation"].as_array().cloned().unwrap_or_default();
    let related: Vec<Value> = related
        .iter()
        .map(|r| {
            let uri: url::Url = r["location"]["uri"].as_str().unwrap().parse().unwrap();
            let file = uri.to_file_path().unwrap();
            json!({ "message": r["message"], "range": r["location"]["range"], "file": file.to_str().unwrap() })
        })
        .collect();
    json!({ "code": told["code"], "severity": told["severity"], "range": told["range"], "related": related })
}

fn specs_below(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            specs_below(&path, into);
        } else if path.extension().is_some_and(|e| e == "mav") {
            into.push(path);
        }
    }
}

#[test]
fn every_spec_gets_the_diagnostics_of_check() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    specs_below(&root.join("specs"), &mut paths);
    specs_below(&root.join("tests/specs"), &mut paths);
    paths.sort();
    assert!(paths.len() > 300, "{} specs", paths.len());
    let mut client = Client::start();
    let mut places = 0;
    for path in paths {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let (diagnostics, sources) = check(&path);
        let name = path.to_str().unwrap();
        let wanted: Vec<Value> = diagnostics
            .iter()
            .filter(|d| sources.get(d.span.file).name == name)
            .map(|d| as_told(d, &sources))
            .collect();
        places += wanted.len();
        let uri = uri_of(&path);
        client.open(&uri, &text);
        // Those of the fault sets may come in a second publication, and no other set of them ever does.
        let told = client.wait(&uri, None, |told| told.len() >= wanted.len());
        assert_eq!(told.iter().map(shortened).collect::<Vec<_>>(), wanted, "{name}");
        client.note("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    }
    assert!(places > 300, "{places} diagnostics");
    assert!(client.mistakes().is_empty());
    client.stop();
}

#[test]
fn mistakes_are_reported_until_they_are_fixed() {
    let mut client = Client::start();
    let uri = "untitled:survey";
    client.open(uri, SPEC);
    client.wait(uri, Some(1), <[Value]>::is_empty);
    // One character at a time, as one types.
    let line = SPEC.lines().position(|l| l.contains("mass")).unwrap();
    let column = SPEC.lines().nth(line).unwrap().find("1.6 kg").unwrap();
    let change = |version: i32, from: usize, to: usize, text: &str| {
        let at = |c: usize| json!({ "line": line, "character": column + c });
        json!({
            "textDocument": { "uri": uri, "version": version },
            "contentChanges": [{ "range": { "start": at(from), "end": at(to) }, "text": text }],
        })
    };
    client.note("textDocument/didChange", change(2, 3, 6, ""));
    let told = client.wait(uri, Some(2), |told| told.len() == 1);
    assert_eq!(told[0]["code"], "mavc::unit::missing");
    assert_eq!(told[0]["severity"], 1);
    assert_eq!(told[0]["source"], "mavc");
    assert_eq!(told[0]["range"]["start"], json!({ "line": line, "character": column }));
    assert!(told[0]["message"].as_str().unwrap().contains("write `1.6 kg`"), "{told:?}");
    client.note("textDocument/didChange", change(3, 3, 3, " kg"));
    client.wait(uri, Some(3), <[Value]>::is_empty);
    client.stop();
}

#[test]
fn warnings_and_their_places_are_reported_in_files_that_are_used() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let (library, root) = (folder.join("library.mav"), folder.join("root.mav"));
    let (faults, rest) = SPEC.split_at(SPEC.find("/// As high").unwrap());
    std::fs::write(&library, format!("{faults}let spare = 3 m\nlet top = 2 m\n")).unwrap();
    let text = format!("use \"library.mav\"\n{rest}");
    let mut client = Client::start();
    let (library_uri, root_uri) = (uri_of(&library), uri_of(&root));
    client.open(&root_uri, &text);
    // The file that is not open is told of too, and a label leads from one file to the other.
    let duplicate = |told: &[Value]| told.iter().any(|d| d["code"] == "mavc::name::duplicate");
    let told = client.wait(&library_uri, None, duplicate);
    assert_eq!(told[0]["relatedInformation"][0]["location"]["uri"], json!(root_uri), "{told:?}");
    // Mended in the editor and not yet stored, it is the editor's text that counts.
    let mended = std::fs::read_to_string(&library).unwrap().replace("let top = 2 m\n", "");
    client.open(&library_uri, &mended);
    let told = client.wait(&library_uri, Some(1), |told| told.len() == 1);
    assert_eq!(told[0]["code"], "mavc::name::unused");
    assert_eq!((&told[0]["severity"], &told[0]["tags"]), (&json!(2), &json!([1])));
    client.wait(&root_uri, None, <[Value]>::is_empty);
    // Closed, the stored text counts again; with the root closed too, nothing is told of either.
    client.note("textDocument/didClose", json!({ "textDocument": { "uri": library_uri } }));
    client.wait(&library_uri, None, duplicate);
    client.note("textDocument/didClose", json!({ "textDocument": { "uri": root_uri } }));
    client.wait(&root_uri, None, <[Value]>::is_empty);
    client.wait(&library_uri, None, <[Value]>::is_empty);
    client.stop();
}

/// An editor that can watch files is asked to watch specs, and reports those that change.
#[test]
fn files_that_change_on_disk_are_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let (library, root) = (folder.join("library.mav"), folder.join("root.mav"));
    let (faults, rest) = SPEC.split_at(SPEC.find("/// As high").unwrap());
    let rest = rest.replace("let top = 2 * 4 m\n", "");
    std::fs::write(&library, format!("{faults}let top = 8 m\n")).unwrap();
    let watching = json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    let mut client = Client::start_with(json!({ "capabilities": watching }));
    let root_uri = uri_of(&root);
    client.open(&root_uri, &format!("use \"library.mav\"\n{rest}"));
    client.wait(&root_uri, Some(1), <[Value]>::is_empty);
    let asked = client.others.iter().filter_map(|message| match message {
        Message::Request(request) => Some((request.method.as_str(), &request.params["registrations"][0]["method"])),
        _ => None,
    });
    let watch = json!("workspace/didChangeWatchedFiles");
    assert_eq!(asked.collect::<Vec<_>>(), [("client/registerCapability", &watch)]);
    std::fs::write(&library, faults).unwrap();
    let changed = json!([{ "uri": uri_of(&library), "type": 2 }]);
    client.note("workspace/didChangeWatchedFiles", json!({ "changes": changed }));
    let told = client.wait(&root_uri, None, |told| !told.is_empty());
    assert_eq!(told[0]["code"], "mavc::name::unknown");
    client.stop();
}

/// Neither waits the server for a pipe, nor does it quote what is no spec.
#[cfg(unix)]
#[test]
fn pipes_and_links_to_other_files_are_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    std::fs::write(folder.join("secret.key"), "token = hunter2\n").unwrap();
    std::os::unix::fs::symlink("secret.key", folder.join("link.mav")).unwrap();
    let made = std::process::Command::new("mkfifo").args(["pipe.mav", "pipe.csv"]).current_dir(&folder).status();
    assert!(made.unwrap().success());
    let mut client = Client::start();
    let uri = uri_of(&folder.join("root.mav"));
    for (version, statement) in (2..).zip([
        "use \"link.mav\"",
        "use \"pipe.mav\"",
        "use \"secret.key\"",
        "mission m { waypoints from \"pipe.csv\" }",
        "mission m { waypoints from \"/dev/zero\" }",
    ]) {
        if version == 2 {
            client.open(&uri, "let a = 1\n");
        }
        client.replace(&uri, version, &format!("{statement}\n"));
        let told = client.wait(&uri, Some(version), |_| true);
        assert!(told.iter().any(|d| d["code"] == "mavc::file::kind"), "{statement}: {told:?}");
        assert!(!format!("{told:?}{:?}", client.told).contains("hunter2"), "{told:?}");
    }
    client.stop();
}

#[test]
fn what_is_shown_has_escapes_for_control_and_bidirectional_characters() {
    let mut client = Client::start();
    let uri = "untitled:a";
    client.open(uri, "/// \u{1b}[31m\u{202e}\nlet a = 1\nlet c = b\u{1b}[2J\u{202e}\n");
    let told = client.wait(uri, Some(1), |told| !told.is_empty());
    let place = json!({ "textDocument": { "uri": uri }, "position": { "line": 1, "character": 4 } });
    let hover = client.ask("textDocument/hover", place).unwrap();
    for shown in [told.iter().map(|d| d["message"].to_string()).collect(), hover.to_string()] {
        let text: String = serde_json::from_str::<Value>(&shown).map_or(shown.clone(), |v| v.to_string());
        assert!(!text.contains(mavc::source::visible::is_disguise) && !text.contains("\\u001b"), "{text}");
    }
    assert!(hover.to_string().contains("\\\\u{1b}[31m\\\\u{202e}"), "{hover}");
    client.stop();
}
