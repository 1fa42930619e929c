//! From names to their declarations and uses, and other names for them, across `use`.

use super::client::{Client, SPEC, marked, uri_of};
use serde_json::{Value, json};
use std::path::PathBuf;

struct Pair {
    client: Client,
    library: PathBuf,
    root: PathBuf,
    /// Where the root's text is marked.
    places: Vec<Value>,
    _folder: tempfile::TempDir,
}

/// A vehicle, modes and a `let` in one file; a mission and a plan, marked, in another that is open.
fn pair(root_text: &str) -> Pair {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    let (library, root) = (path.join("library.mav"), path.join("root.mav"));
    std::fs::write(&library, &SPEC[..SPEC.find("mission").unwrap()]).unwrap();
    let (text, places) = marked(root_text);
    std::fs::write(&root, &text).unwrap();
    let folders = json!([{ "uri": uri_of(&path), "name": "specs" }]);
    let mut client = Client::start_with(json!({ "capabilities": {}, "workspaceFolders": folders }));
    client.open(&uri_of(&root), &text);
    Pair { client, library, root, places, _folder: folder }
}

const ROOT: &str = "use \"libr|ary.mav\"\nmission m {\n    start at [0, 0, t|op]\n    waypoint at [5 m, 0 m, top]\n}\n\
    plan {\n    vehicle = qu|ad\n    against = [we|ak1, wo|rn, weak2]\n    time = 20 s\n}\nsimulate { fault weak1 at 1 s }\n";

impl Pair {
    fn at(&self, place: usize) -> Value {
        json!({ "textDocument": { "uri": uri_of(&self.root) }, "position": self.places[place] })
    }

    fn rename(&mut self, place: usize, new: &str) -> Result<Value, (i32, String)> {
        let mut params = self.at(place);
        params["newName"] = json!(new);
        self.client.ask("textDocument/rename", params)
    }

    /// Both texts after an edit.
    fn edited(&self, edit: &Value) -> (String, String) {
        let apply = |path: &PathBuf| {
            let source = mavc::source::Source::new("", std::fs::read_to_string(path).unwrap());
            let mut edits: Vec<(usize, usize, &str)> = edit["changes"][uri_of(path)]
                .as_array()
                .into_iter()
                .flatten()
                .map(|e| {
                    let at = |end: &str| {
                        let place = &e["range"][end];
                        let number = |of: &str| place[of].as_u64().unwrap() as u32;
                        source.offset_utf16(number("line"), number("character"))
                    };
                    (at("start"), at("end"), e["newText"].as_str().unwrap())
                })
                .collect();
            edits.sort();
            let mut text = source.text.clone();
            for (start, end, new) in edits.into_iter().rev() {
                text.replace_range(start..end, new);
            }
            text
        };
        (apply(&self.library), apply(&self.root))
    }
}

#[test]
fn names_lead_to_their_declaration_in_another_file() {
    let mut pair = pair(ROOT);
    let library = uri_of(&pair.library);
    let text = std::fs::read_to_string(&pair.library).unwrap();
    let line_of = |part: &str| text.lines().position(|l| l.contains(part)).unwrap();
    for (place, line) in [
        (0, 0),
        (1, line_of("let top")),
        (2, line_of("vehicle quad")),
        (3, line_of("as weak")),
        (4, line_of("mode worn")),
    ] {
        let params = pair.at(place);
        let found = pair.client.ask("textDocument/definition", params).unwrap();
        assert_eq!(found["uri"], library, "place {place}");
        assert_eq!(found["range"]["start"]["line"], line, "place {place}: {found}");
    }
    pair.client.stop();
}

#[test]
fn references_are_found_in_all_files() {
    let mut pair = pair(ROOT);
    let mut count = |place: usize, declaration: bool| {
        let mut params = pair.at(place);
        params["context"] = json!({ "includeDeclaration": declaration });
        pair.client.ask("textDocument/references", params).unwrap().as_array().unwrap().len()
    };
    assert_eq!(count(1, true), 3, "`top`");
    assert_eq!(count(1, false), 2, "`top`");
    assert_eq!(count(3, true), 4, "`weak`: declared once, then weak1, weak2 and the strike");
    pair.client.stop();
}

#[test]
fn renaming_changes_every_file_and_keeps_the_meaning() {
    let mut pair = pair(ROOT);
    let edit = pair.rename(1, "summit").unwrap();
    let (library, root) = pair.edited(&edit);
    assert!(library.contains("let summit = 2 * 4 m"), "{library}");
    assert_eq!(root.matches("summit").count(), 2, "{root}");
    // Of the modes of an `every` the prefix is renamed.
    let params = pair.at(3);
    let offered = pair.client.ask("textDocument/prepareRename", params).unwrap();
    assert_eq!(offered["placeholder"], "weak");
    let edit = pair.rename(3, "tired").unwrap();
    let (library, root) = pair.edited(&edit);
    assert!(library.contains("as tired {"), "{library}");
    assert!(root.contains("[tired1, worn, tired2]") && root.contains("fault tired1 at"), "{root}");
    pair.client.stop();
}

/// The orders of plan and modes name the sites of the mission, which another file may declare.
#[test]
fn landing_sites_are_found_explained_and_renamed() {
    let root = "use \"library.mav\"\nfaults { mode gone { rotor 1 lost; recovery = [continue, p|ad] } }\nmission m {\n    ground = 0 m\n\
        \x20   start at [0, 0, 2] m\n    waypoint at [5, 0, 2] m\n    landing_site p|ad { at = [4, -8, 0] m; radius = 2 m }\n}\n\
        plan { against = []; recovery { order = [pa|d, land_h|ere] } }\n";
    let mut pair = pair(root);
    for place in [0, 2] {
        let params = pair.at(place);
        let found = pair.client.ask("textDocument/definition", params).unwrap();
        assert_eq!(found["range"]["start"], json!({ "line": 6, "character": 17 }), "{found}");
        let params = pair.at(place);
        let shown = pair.client.ask("textDocument/hover", params).unwrap()["contents"]["value"].to_string();
        assert!(shown.contains("landing site **pad**") && shown.contains("[4, -8, 0] m"), "{shown}");
    }
    let params = pair.at(3);
    let shown = pair.client.ask("textDocument/hover", params).unwrap()["contents"]["value"].to_string();
    assert!(shown.contains("land_here") && shown.contains("comes to rest"), "{shown}");
    let edit = pair.rename(0, "meadow").unwrap();
    let (_, renamed) = pair.edited(&edit);
    assert_eq!(renamed, root.replace('|', "").replace("pad", "meadow"));
    for (new, why) in [("continue", "belongs to the language"), ("2nd", "is not a name")] {
        assert!(pair.rename(1, new).unwrap_err().1.contains(why), "{new}");
    }
    pair.client.stop();
}

#[test]
fn families_and_ranges_are_found_and_renamed() {
    let root = ROOT.replace("[we|ak1, wo|rn, weak2]", "[we|ak, weak2 .. weak5]");
    let mut pair = pair(&format!("{root}faults {{ every 2 rotors reduced to 95 % as weak }}\n"));
    let mut params = pair.at(3);
    params["context"] = json!({ "includeDeclaration": true });
    let found = pair.client.ask("textDocument/references", params).unwrap();
    assert_eq!(found.as_array().unwrap().len(), 6, "two declarations, the family, two ends, the strike: {found}");
    let edit = pair.rename(3, "tired").unwrap();
    let (library, root) = pair.edited(&edit);
    assert!(library.contains("as tired {") && root.contains("as tired }"), "{library}{root}");
    assert!(root.contains("[tired, tired2 .. tired5]") && root.contains("fault tired1 at"), "{root}");
    let (_, message) = pair.rename(3, "worn").unwrap_err();
    assert!(message.contains("`worn` names both a fault mode and the modes of an `every`"), "{message}");
    pair.client.stop();
}

#[test]
fn edits_name_the_versions_of_open_texts_where_the_editor_asks_for_it() {
    let edit = json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } });
    let mut client = Client::start_with(json!({ "capabilities": edit }));
    let uri = "untitled:a";
    client.open(uri, "let a = 1 m\n");
    client.replace(uri, 7, "let a = 1 m\nlet b = a\n");
    let position = json!({ "line": 0, "character": 4 });
    let params = json!({ "textDocument": { "uri": uri }, "position": position, "newName": "c" });
    let edit = client.ask("textDocument/rename", params).unwrap();
    assert!(edit.get("changes").is_none(), "{edit}");
    let change = &edit["documentChanges"][0];
    assert_eq!(change["textDocument"], json!({ "uri": uri, "version": 7 }));
    assert_eq!(change["edits"].as_array().unwrap().len(), 2, "{edit}");
    // So do quick fixes.
    client.replace(uri, 8, "let a 1 m\nlet b = a\n");
    let (start, end) = (json!({ "line": 0, "character": 6 }), json!({ "line": 0, "character": 7 }));
    let params = json!({ "textDocument": { "uri": uri }, "range": { "start": start, "end": end }, "context": { "diagnostics": [] } });
    let actions = client.ask("textDocument/codeAction", params).unwrap();
    let edit = &actions[0]["edit"];
    assert!(edit.get("changes").is_none(), "{edit}");
    let change = &edit["documentChanges"][0];
    assert_eq!(change["textDocument"], json!({ "uri": uri, "version": 8 }));
    assert_eq!(change["edits"][0]["newText"], "= ", "{edit}");
    client.stop();
}

#[test]
fn renaming_reaches_files_that_are_not_open() {
    let mut pair = pair(ROOT);
    let text = std::fs::read_to_string(&pair.library).unwrap();
    let uri = uri_of(&pair.library);
    pair.client.note("textDocument/didClose", json!({ "textDocument": { "uri": uri_of(&pair.root) } }));
    pair.client.open(&uri, &text);
    let line = text.lines().position(|l| l.starts_with("let top")).unwrap();
    let position = json!({ "line": line, "character": 5 });
    let params = json!({ "textDocument": { "uri": uri }, "position": position, "newName": "summit" });
    let edit = pair.client.ask("textDocument/rename", params).unwrap();
    let (library, root) = pair.edited(&edit);
    assert!(library.contains("let summit"), "{library}");
    assert_eq!(root.matches("summit").count(), 2, "{root}");
    pair.client.stop();
}

#[test]
fn names_that_are_no_names_or_would_mean_something_else_are_refused() {
    let mut pair = pair(ROOT);
    for (place, new, why) in [
        (1, "2nd", "is not a name"),
        (1, "", "is not a name"),
        (1, "gipfel höhe", "is not a name"),
        (1, "sin", "belongs to the language"),
        (4, "all", "belongs to the language"),
        (4, "weak3", "fault mode `weak3` is declared twice"),
    ] {
        let (code, message) = pair.rename(place, new).unwrap_err();
        assert_eq!(code, -32803, "{new}: {message}");
        assert!(message.contains(why), "{new}: {message}");
    }
    pair.client.stop();
    let mut pair = self::pair(
        "let a = 1 m\nuse \"library.mav\"\nmission m {\n curve s in 0 .. 1, points = 3 { x = a|*s; y = a + s*1 m; z = top }\n}\n",
    );
    let (_, message) = pair.rename(0, "s").unwrap_err();
    assert!(message.contains('s'), "{message}");
    pair.client.stop();
    // A statement that cannot be read would keep the old name.
    let mut pair =
        self::pair("use \"library.mav\"\nmission m {\n start at [0 m, 0 m, t|op]\n waypoint at [top ???\n}\n");
    let (_, message) = pair.rename(0, "summit").unwrap_err();
    assert!(message.contains("fix it first"), "{message}");
    pair.client.stop();
}
