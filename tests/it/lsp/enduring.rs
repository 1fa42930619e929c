//! What the server has to bear: broken, half-typed and empty texts, places that are not there, requests nobody knows,
//! closed texts, cancelled questions, and edits faster than it answers.

use super::client::{Client, SPEC};
use lsp_server::{Connection, Message, Notification, Request, RequestId};
use mavc::lsp::{Ending, serve};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Output, Stdio};

const TEXTS: [&str; 6] = [
    SPEC,
    "",
    "\u{feff}vehicle v { mass = 1 kg\r\n",
    "let α = \"😀\"\nlet a = b + c\nlet b = a\nuse \"nowhere.mav\"\nuse \"untitled:b\"\n",
    "plan { against = [M1, ; time = 2 } mission { curve s in 0 .. 1, points = 9 { x = s }\n}}}} ((([[[ /* ??? */ # \" \n",
    "vehicle q { layout = \"PNPN\" }\nfaults { every 2 rotors lost as M; mode all { rotor 9 lost } }\nplan { time = minimum }",
];

const PIECES: [&str; 16] = [
    "",
    "\n",
    " ",
    "}",
    "{",
    "mass = ",
    "1.6 kg",
    "[",
    "😀",
    "\"",
    "//",
    "weak1",
    "/// doc\n",
    "\r\n",
    "let top = 1 m\n",
    "..",
];

const METHODS: [&str; 15] = [
    "textDocument/formatting",
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/documentHighlight",
    "textDocument/prepareRename",
    "textDocument/rename",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/semanticTokens/full",
    "textDocument/codeAction",
    "textDocument/inlayHint",
    "textDocument/nobodyKnows",
    "workspace/symbol",
];

const URIS: [&str; 4] = ["untitled:a", "untitled:b", "file:///nowhere/c.mav", "no uri"];

#[derive(Debug, Clone)]
enum Step {
    Open(usize, usize),
    Close(usize),
    Edit(usize, [u32; 4], usize),
    Ask(usize, usize, [u32; 4]),
    /// A request without sound parameters.
    Garbage(usize),
    Cancel(i32),
}

/// Mostly a place in a text, sometimes far outside.
fn coordinate() -> impl Strategy<Value = u32> {
    prop_oneof![8 => 0u32..40, 1 => Just(u32::MAX), 1 => 40u32..5000]
}

fn step() -> impl Strategy<Value = Step> {
    let place = || proptest::array::uniform4(coordinate());
    prop_oneof![
        2 => (0..URIS.len(), 0..TEXTS.len()).prop_map(|(uri, text)| Step::Open(uri, text)),
        1 => (0..URIS.len()).prop_map(Step::Close),
        5 => (0..URIS.len(), place(), 0..PIECES.len()).prop_map(|(uri, at, piece)| Step::Edit(uri, at, piece)),
        8 => (0..URIS.len(), 0..METHODS.len(), place()).prop_map(|(uri, method, at)| Step::Ask(uri, method, at)),
        1 => (0..METHODS.len()).prop_map(Step::Garbage),
        1 => (1..30).prop_map(Step::Cancel),
    ]
}

fn range(at: &[u32; 4]) -> Value {
    json!({ "start": { "line": at[0], "character": at[1] }, "end": { "line": at[2], "character": at[3] } })
}

fn take(client: &mut Client, step: &Step, version: i32, asked: &mut Vec<RequestId>) {
    match step {
        Step::Open(uri, text) => client.open(URIS[*uri], TEXTS[*text]),
        Step::Close(uri) => {
            client.note("textDocument/didClose", json!({ "textDocument": { "uri": URIS[*uri] } }));
        }
        Step::Edit(uri, at, piece) => {
            let change = json!({ "range": range(at), "text": PIECES[*piece] });
            let document = json!({ "uri": URIS[*uri], "version": version });
            let params = json!({ "textDocument": document, "contentChanges": [change] });
            client.note("textDocument/didChange", params);
        }
        Step::Ask(uri, method, at) => {
            let params = json!({
                "textDocument": { "uri": URIS[*uri] },
                "position": { "line": at[0], "character": at[1] },
                "range": range(at),
                "context": { "diagnostics": [], "includeDeclaration": true },
                "newName": PIECES[at[3] as usize % PIECES.len()],
            });
            asked.push(client.send(METHODS[*method], params));
        }
        Step::Garbage(method) => asked.push(client.send(METHODS[*method], json!([1, "two", { "textDocument": null }]))),
        Step::Cancel(id) => client.note("$/cancelRequest", json!({ "id": id })),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn whatever_it_receives_it_answers_every_question_once(steps in proptest::collection::vec(step(), 1..40)) {
        let mut client = Client::start();
        let mut asked = Vec::new();
        client.open(URIS[0], SPEC);
        for (version, step) in steps.iter().enumerate() {
            take(&mut client, step, version as i32, &mut asked);
        }
        for id in &asked {
            if let Err((code, message)) = client.response(id) {
                prop_assert_ne!(code, -32603, "a mistake of its own: {}", message);
            }
        }
        prop_assert!(client.mistakes().is_empty());
        prop_assert_eq!(client.stop(), Ending::Agreed);
    }
}

#[test]
fn a_newer_edit_supersedes_older_questions() {
    let mut client = Client::start();
    client.open("untitled:a", SPEC);
    let at = json!({ "textDocument": { "uri": "untitled:a" }, "position": { "line": 1, "character": 9 } });
    // While the server is busy with the first question, the others and an edit come in.
    let asked: Vec<RequestId> = (0..50).map(|_| client.send("textDocument/hover", at.clone())).collect();
    client.replace("untitled:a", 2, "vehicle b {}\n");
    let last = client.send("textDocument/documentSymbol", at);
    let outcomes: Vec<_> = asked.iter().map(|id| client.response(id)).collect();
    for outcome in &outcomes {
        match outcome {
            Ok(shown) => assert!(shown["contents"]["value"].as_str().unwrap().contains("thrust to weight")),
            Err((code, _)) => assert_eq!(*code, -32801, "content modified"),
        }
    }
    assert_eq!(client.response(&last).unwrap()[0]["name"], "b");
    client.stop();
}

#[test]
fn questions_that_nobody_knows_and_late_ones_are_refused() {
    let mut client = Client::start();
    assert_eq!(client.ask("mavc/nothing", json!({})).unwrap_err().0, -32601);
    assert_eq!(client.ask("textDocument/hover", json!({ "textDocument": 3 })).unwrap_err().0, -32602);
    let nowhere = json!({ "textDocument": { "uri": "untitled:x" }, "position": { "line": 3, "character": 4 } });
    assert_eq!(client.ask("textDocument/hover", nowhere.clone()), Ok(Value::Null));
    client.ask("shutdown", Value::Null).unwrap();
    assert_eq!(client.ask("textDocument/hover", nowhere).unwrap_err().0, -32600);
    assert_eq!(client.stop_at_once(), Ending::Agreed);
    let client = Client::start();
    assert_eq!(client.stop_at_once(), Ending::Abrupt);
}

#[test]
fn requests_before_initialize_are_refused_in_words() {
    let (ours, theirs) = Connection::memory();
    let server = std::thread::spawn(move || serve(&theirs));
    let request = Request { id: 1.into(), method: "textDocument/hover".into(), params: json!({}) };
    ours.sender.send(request.into()).unwrap();
    let Message::Response(refused) = ours.receiver.recv().unwrap() else { panic!("no response") };
    let error = refused.response_result.unwrap_err();
    assert_eq!((error.code, error.message.as_str()), (-32002, "`textDocument/hover` came before `initialize`"));
    ours.sender.send(Notification::new("exit".into(), Value::Null).into()).unwrap();
    assert_eq!(server.join().unwrap(), Ending::Abrupt);
}

/// What `mavc lsp` answers to an input, and how it ends.
fn spoken_to(input: &str) -> Output {
    let mut server = Command::new(env!("CARGO_BIN_EXE_mavc"));
    let pipes = server.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut server = pipes.spawn().unwrap();
    server.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    server.wait_with_output().unwrap()
}

fn framed(body: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{body}", body.len())
}

/// Where nobody can know where the next message begins the server ends, and says why; no length makes it take memory.
#[test]
fn headers_that_cannot_be_read_end_the_server_in_words() {
    let long = "x".repeat(20_000);
    let wrong = [
        "Content-Length: many\r\n\r\n{}",
        "Content-Length: 99999999999\r\n\r\n{}",
        "Content-Length: 18446744073709551615\r\n\r\n",
        "Content-Length: 30\r\n\r\n{}",
        "hello\r\n\r\n",
        &long,
    ];
    for wrong in wrong {
        let ended = spoken_to(wrong);
        let told = String::from_utf8(ended.stderr).unwrap();
        assert_eq!(ended.status.code(), Some(2), "{wrong:.60?}");
        let expected = "mavc: the connection to the editor was lost: ";
        assert!(told.starts_with(expected) && told.lines().count() == 1, "{wrong:.60?}: {told:?}");
    }
}

/// A message that is none is passed over, and told to the editor.
#[test]
fn messages_that_cannot_be_read_are_passed_over() {
    let initialize = r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#;
    let shutdown = r#"{"jsonrpc":"2.0","id":2,"method":"shutdown"}"#;
    let exit = r#"{"jsonrpc":"2.0","method":"exit"}"#;
    let said = ["{a}", initialize, "[1, 2]", "\u{1}", shutdown, exit].map(framed).concat();
    let ended = spoken_to(&said);
    let (told, answers) = (String::from_utf8(ended.stderr).unwrap(), String::from_utf8(ended.stdout).unwrap());
    assert_eq!((ended.status.code(), told.as_str()), (Some(0), ""));
    assert_eq!(answers.matches("mavc passes over a message that it cannot read: ").count(), 3, "{answers}");
    assert!(answers.contains(r#""id":1"#) && answers.contains(r#""id":2"#), "{answers}");
}

#[test]
fn places_within_pairs_of_surrogates_and_behind_the_end_are_taken_for_the_nearest() {
    let mut client = Client::start();
    let uri = "untitled:a";
    client.open(uri, "// 😀\nlet a = 1\n");
    let change = |from: [u32; 2], to: [u32; 2], text: &str| json!({ "range": range(&[from[0], from[1], to[0], to[1]]), "text": text });
    // From the middle of the smiley to the end of its line; far behind the last line; and back to front.
    let changes = [change([0, 4], [0, 99], "b"), change([9, 9], [9, 9], "let c = a\n"), change([1, 5], [1, 4], "d")];
    let document = json!({ "uri": uri, "version": 2 });
    client.note("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    let symbols = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } })).unwrap();
    let names: Vec<&str> = symbols.as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["d", "c"]);
    client.stop();
}
