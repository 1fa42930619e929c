//! Response times of the language server on a spec of 2,000 lines: `cargo bench --bench editor`. Every request follows
//! an edit, so each response includes compiling the whole text again.

use lsp_server::{Connection, Message, Notification, Request, RequestId};
use serde_json::{Value, json};
use std::fmt::Write;
use std::time::{Duration, Instant};

const URI: &str = "untitled:large";
/// Edits measured for each kind of request.
const EDITS: usize = 200;

const QUESTIONS: [&str; 9] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/semanticTokens/full",
    "textDocument/inlayHint",
    "textDocument/codeAction",
];

/// A vehicle of eight rotors, 500 `let`s, 600 fault modes and 880 waypoints.
fn spec() -> String {
    let mut text = String::from(
        "vehicle octo {\n    layout = \"PPNNPPNN\"\n    arm = 21.1 cm\n    mass = 1.8 kg\n    \
         inertia = [0.0429, 0.0429, 0.0748] kg*m^2\n    rotor {\n        max_thrust = 666 gf\n        \
         torque_per_thrust = 16 mm\n        max_speed = 8350 rpm\n    }\n}\n",
    );
    for k in 0..500 {
        let before = if k == 0 { "1 m".to_string() } else { format!("h{}", k - 1) };
        writeln!(text, "let h{k} = {before} * 0.99 + {} cm", k % 7).unwrap();
    }
    text.push_str("faults {\n");
    for k in 0..600 {
        let (rotor, left) = (k % 8 + 1, 40 + k / 10);
        writeln!(text, "    mode f{k} \"number {k}\" {{ rotor {rotor} reduced to {left} %; rate = 1e-5 1/h }}")
            .unwrap();
    }
    text.push_str("}\nmission grid {\n    start at [0, 0, 2] m\n");
    for k in 0..880 {
        let (x, y) = (k % 40, k / 40);
        writeln!(text, "    waypoint w{k} at [{x} m, {y} m, 2 m + h{}]  within 20 cm  // row {y}", k % 500).unwrap();
    }
    text.push_str("}\nplan {\n    samples = 2000\n    time = 2000 s\n}\n");
    text
}

struct Client {
    connection: Connection,
    requests: i32,
    version: i32,
}

impl Client {
    fn note(&self, method: &str, params: Value) {
        self.connection.sender.send(Notification::new(method.into(), params).into()).unwrap();
    }

    fn send(&mut self, method: &str, params: Value) -> RequestId {
        self.requests += 1;
        let id = RequestId::from(self.requests);
        self.connection.sender.send(Request { id: id.clone(), method: method.into(), params }.into()).unwrap();
        id
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.send(method, params);
        loop {
            match self.connection.receiver.recv().unwrap() {
                Message::Response(response) if response.id == id => return response.response_result.unwrap(),
                _ => {}
            }
        }
    }

    /// Changes a digit of the vehicle's mass at this line and column.
    fn edit(&mut self, (line, column): (usize, usize)) {
        self.version += 1;
        let digit = (b'5' + (self.version % 4) as u8) as char;
        let at = |c: usize| json!({ "line": line, "character": c });
        let change = json!({ "range": { "start": at(column), "end": at(column + 1) }, "text": digit.to_string() });
        let document = json!({ "uri": URI, "version": self.version });
        self.note("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    }

    /// Waits for the diagnostics of the last edit.
    fn wait_for_diagnostics(&mut self) {
        loop {
            if let Message::Notification(note) = self.connection.receiver.recv().unwrap()
                && note.params["version"] == json!(self.version)
            {
                return;
            }
        }
    }
}

fn row(name: &str, mut times: Vec<Duration>) {
    times.sort();
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize].as_secs_f64() * 1e3;
    println!("{name:<36} {:>8.1} {:>8.1} {:>8.1}", at(0.5), at(0.99), at(1.0));
}

fn main() {
    let (connection, server) = Connection::memory();
    let thread = std::thread::spawn(move || mavc::lsp::serve(&server));
    let mut client = Client { connection, requests: 0, version: 1 };
    client.ask("initialize", json!({ "capabilities": {} }));
    client.note("initialized", json!({}));
    let text = spec();
    let document = json!({ "uri": URI, "languageId": "mav", "version": 1, "text": text });
    client.note("textDocument/didOpen", json!({ "textDocument": document }));
    client.wait_for_diagnostics();
    let line_of = |part: &str| {
        let line = text.lines().position(|l| l.contains(part)).unwrap();
        (line, text.lines().nth(line).unwrap().find(part).unwrap())
    };
    let digit = line_of("8 kg");
    println!("{} lines, {} kB; {EDITS} edits each\n", text.lines().count(), text.len() / 1000);
    println!("{:<36} {:>8} {:>8} {:>8}", "after an edit, ms", "median", "99 %", "worst");
    let places = [("h7 * 0.99", 1), ("mode f300", 6), ("within 20 cm", 1)];
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 3000, "character": 0 } });
    for question in QUESTIONS {
        let mut times = Vec::new();
        for k in 0..EDITS {
            let (part, inside) = places[k % places.len()];
            let (line, column) = line_of(part);
            let params = json!({
                "textDocument": { "uri": URI },
                "position": { "line": line, "character": column + inside },
                "range": whole,
                "context": { "diagnostics": [], "includeDeclaration": true, "triggerKind": 1 },
            });
            let begin = Instant::now();
            client.edit(digit);
            client.ask(question, params);
            times.push(begin.elapsed());
        }
        row(question, times);
    }
    let mut times = Vec::new();
    for _ in 0..EDITS {
        let begin = Instant::now();
        client.edit(digit);
        client.wait_for_diagnostics();
        times.push(begin.elapsed());
    }
    row("diagnostics", times);
    let mut times = Vec::new();
    for _ in 0..EDITS / 10 {
        let begin = Instant::now();
        for _ in 0..100 {
            client.edit(digit);
            client.send("textDocument/semanticTokens/full", json!({ "textDocument": { "uri": URI } }));
        }
        client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": URI } }));
        times.push(begin.elapsed());
    }
    row("100 edits and questions at once", times);
    client.ask("shutdown", Value::Null);
    client.note("exit", Value::Null);
    thread.join().unwrap();
}
