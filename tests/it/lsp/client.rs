//! A client that keeps what it is told, and a spec with a cursor in it.

use lsp_server::{Connection, Message, Notification, Request, RequestId, Response};
use mavc::lsp::{Ending, serve};
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::thread::JoinHandle;
use std::time::Duration;
use url::Url;

/// A server that says nothing for so long is stuck.
const STUCK: Duration = Duration::from_secs(60);

pub struct Client {
    connection: Connection,
    server: Option<JoinHandle<Ending>>,
    requests: i32,
    /// The last diagnostics told of each text.
    pub told: BTreeMap<String, Vec<Value>>,
    /// Of the text that they were told of.
    versions: BTreeMap<String, Value>,
    /// What the server asked or noted beside diagnostics.
    pub others: Vec<Message>,
    /// Answers that nobody has asked for yet.
    responses: HashMap<RequestId, Response>,
    pub capabilities: Value,
}

impl Client {
    /// A client that has been through `initialize`.
    pub fn start() -> Self {
        Client::start_with(json!({ "capabilities": {} }))
    }

    pub fn start_with(params: Value) -> Self {
        let (connection, theirs) = Connection::memory();
        let server = Some(std::thread::spawn(move || serve(&theirs)));
        let capabilities = Value::Null;
        let (told, versions) = (BTreeMap::new(), BTreeMap::new());
        let (others, responses) = (Vec::new(), HashMap::new());
        let mut client = Client { connection, server, requests: 0, told, versions, others, responses, capabilities };
        client.capabilities = client.ask("initialize", params).unwrap()["capabilities"].clone();
        client.note("initialized", json!({}));
        client
    }

    pub fn note(&self, method: &str, params: Value) {
        self.connection.sender.send(Notification::new(method.into(), params).into()).unwrap();
    }

    /// Sends a request and does not wait for its answer.
    pub fn send(&mut self, method: &str, params: Value) -> RequestId {
        self.requests += 1;
        let id = RequestId::from(self.requests);
        let request = Request { id: id.clone(), method: method.into(), params };
        self.connection.sender.send(request.into()).unwrap();
        id
    }

    pub fn ask(&mut self, method: &str, params: Value) -> Result<Value, (i32, String)> {
        let id = self.send(method, params);
        self.response(&id)
    }

    /// The answer to a request; what comes before it is kept.
    pub fn response(&mut self, id: &RequestId) -> Result<Value, (i32, String)> {
        loop {
            if let Some(response) = self.responses.remove(id) {
                return response.response_result.map_err(|error| (error.code, error.message));
            }
            self.take();
        }
    }

    /// Takes one message.
    fn take(&mut self) {
        match self.connection.receiver.recv_timeout(STUCK).expect("the server goes on") {
            Message::Response(response) => {
                let twice = self.responses.insert(response.id.clone(), response);
                assert!(twice.is_none(), "answered twice: {twice:?}");
            }
            Message::Notification(note) if note.method == "textDocument/publishDiagnostics" => {
                let uri = note.params["uri"].as_str().unwrap().to_string();
                let list = note.params["diagnostics"].as_array().unwrap().clone();
                self.versions.insert(uri.clone(), note.params["version"].clone());
                self.told.insert(uri, list);
            }
            other => self.others.push(other),
        }
    }

    pub fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "mav", "version": 1, "text": text });
        self.note("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Puts another text in place of the whole.
    pub fn replace(&mut self, uri: &str, version: i32, text: &str) {
        let document = json!({ "uri": uri, "version": version });
        self.note("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [{ "text": text }] }));
    }

    /// The diagnostics of a text as soon as they are as described.
    pub fn wait(&mut self, uri: &str, version: Option<i32>, fits: impl Fn(&[Value]) -> bool) -> Vec<Value> {
        loop {
            if let Some(list) = self.told.get(uri)
                && fits(list)
                && version.is_none_or(|version| self.versions[uri] == json!(version))
            {
                return list.clone();
            }
            self.take();
        }
    }

    /// The diagnostics that the next publication of a text brings.
    pub fn next(&mut self, uri: &str) -> Vec<Value> {
        self.told.remove(uri);
        self.wait(uri, None, |_| true)
    }

    /// Where the server has said that it made a mistake with what it was told.
    pub fn mistakes(&self) -> Vec<&Message> {
        let is_mistake = |message: &&Message| match message {
            Message::Notification(note) => {
                note.params["message"].as_str().is_some_and(|m| m.contains("mistake in mavc"))
            }
            _ => false,
        };
        self.others.iter().filter(is_mistake).collect()
    }

    /// Says `exit` and no more.
    pub fn stop_at_once(mut self) -> Ending {
        self.note("exit", Value::Null);
        self.server.take().unwrap().join().expect("the server ends without a panic")
    }

    /// Ends the conversation as agreed.
    pub fn stop(mut self) -> Ending {
        self.ask("shutdown", Value::Null).unwrap();
        self.note("exit", Value::Null);
        self.server.take().unwrap().join().expect("the server ends without a panic")
    }
}

/// The URI of a file.
pub fn uri_of(path: &Path) -> String {
    Url::from_file_path(path).unwrap().to_string()
}

/// A text without its marks `|`, and the places where they stood, as the protocol counts.
pub fn marked(text: &str) -> (String, Vec<Value>) {
    let mut places = Vec::new();
    let mut plain = String::new();
    for part in text.split('|') {
        plain.push_str(part);
        let line = plain.matches('\n').count();
        let column = plain.rsplit('\n').next().unwrap().encode_utf16().count();
        places.push(json!({ "line": line, "character": column }));
    }
    places.pop();
    (plain, places)
}

/// A complete spec: a vehicle, all single losses, a mission and a plan.
pub const SPEC: &str = "\
/// A quadcopter that carries a camera.
vehicle quad {
    layout  = \"PNPNPN\"
    arm     = 25 cm
    mass    = 1.6 kg
    inertia = [0.014, 0.014, 0.026] kg*m^2
    rotor {
        max_thrust        = 9 N
        torque_per_thrust = 16 mm
        max_speed         = 8500 rpm
    }
}

faults {
    every 1 rotor reduced to 90 % as weak { rate = 1e-4 1/h }
    mode worn \"worn bearing\" { rotor 2 reduced to 80 % }
}

/// As high as the mast.
let top = 2 * 4 m

mission survey {
    start at [0, 0, 2] m
    waypoint mast at [12 m, 3 m, top]
    limits { tilt <= 20 deg }
}

plan {
    against = [worn, weak1]
    time    = 20 s
}
";
