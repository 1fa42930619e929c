//! The conversation: messages in their order, and what is to be done when there is a moment's quiet.

use super::Ending;
use super::answer;
use super::documents::name_of;
use super::hover::{Shown, verdicts};
use super::plain::plainly;
use super::publication::Progress;
use super::verdicts::{Found, Verdicts};
use super::workspace::{Spec, Workspace};
use crate::diagnostic::Diagnostic;
use crossbeam_channel::{RecvTimeoutError, select};
use gen_lsp_types as lsp;
use gen_lsp_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
};
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, RequestId, Response};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use url::Url;

pub struct Server<'c> {
    connection: &'c Connection,
    pub workspace: Workspace,
    /// The editor's folders, where files may use the open ones.
    pub folders: Vec<PathBuf>,
    pub verdicts: Verdicts,
    /// Messages that have come and are not looked at yet.
    inbox: VecDeque<Message>,
    /// What the editor shows now.
    pub(super) published: BTreeMap<Url, Vec<lsp::Diagnostic>>,
    /// The verdicts of the sets, by root, with their spec.
    pub(super) answers: BTreeMap<String, (Arc<Spec>, Vec<Diagnostic>)>,
    pub(super) progress: Progress,
    /// Hovers that wait for verdicts, by ticket.
    waiting: HashMap<u64, Waiting>,
    tickets: u64,
    is_shut_down: bool,
    watches_files: bool,
    pub client: Client,
}

/// What the editor can take beyond the least.
#[derive(Debug, Clone, Copy)]
pub struct Client {
    /// Completions with places for the cursor.
    pub snippets: bool,
    /// Edits of several texts that name the version of each.
    pub versioned_edits: bool,
}

struct Waiting {
    id: RequestId,
    spec: Arc<Spec>,
    shown: Shown,
    withdrawn: Arc<AtomicBool>,
}

impl<'c> Server<'c> {
    /// Answers `initialize`.
    pub fn new(connection: &'c Connection, id: RequestId, params: Value) -> Self {
        let can = |what: &str| params.pointer(&format!("/capabilities/{what}")) == Some(&Value::Bool(true));
        let client = Client {
            snippets: can("textDocument/completion/completionItem/snippetSupport"),
            versioned_edits: can("workspace/workspaceEdit/documentChanges"),
        };
        let folders = params.get("workspaceFolders").and_then(Value::as_array).into_iter().flatten();
        let folders = folders.filter_map(|folder| folder.get("uri")).chain(params.get("rootUri"));
        let mut server = Server {
            connection,
            workspace: Workspace::default(),
            folders: folders.filter_map(|uri| Url::parse(uri.as_str()?).ok()?.to_file_path().ok()).collect(),
            verdicts: Verdicts::start(),
            inbox: VecDeque::new(),
            published: BTreeMap::new(),
            answers: BTreeMap::new(),
            progress: Progress::Published,
            waiting: HashMap::new(),
            tickets: 0,
            is_shut_down: false,
            watches_files: can("workspace/didChangeWatchedFiles/dynamicRegistration"),
            client,
        };
        server.folders.dedup();
        let version = env!("CARGO_PKG_VERSION");
        let result = json!({
            "capabilities": answer::capabilities(),
            "serverInfo": { "name": "mavc", "version": version },
        });
        server.send(Response::new_ok(id, result));
        server
    }

    pub fn run(mut self) -> Ending {
        loop {
            self.inbox.extend(self.connection.receiver.try_iter());
            if let Some(message) = self.inbox.pop_front() {
                if let Some(ending) = self.take(message) {
                    return ending;
                }
                continue;
            }
            match self.progress {
                Progress::Due => self.look_again(),
                Progress::Asked { until: Some(until), round } if Instant::now() >= until => {
                    self.progress = Progress::Asked { round, until: None };
                    self.publish();
                }
                _ => {
                    if let Err(ending) = self.wait() {
                        return ending;
                    }
                }
            }
        }
    }

    /// Waits for whatever comes next.
    fn wait(&mut self) -> Result<(), Ending> {
        let patience = match self.progress {
            Progress::Asked { until: Some(until), .. } => until.saturating_duration_since(Instant::now()),
            _ => Duration::from_secs(3600),
        };
        let found = self.verdicts.found.clone();
        select! {
            recv(self.connection.receiver) -> message => match message {
                Ok(message) => self.inbox.push_back(message),
                Err(_) => return Err(Ending::Abrupt),
            },
            recv(found) -> found => match found {
                Ok(found) => self.take_in(found),
                // Without the thread there are no verdicts; everything else works.
                Err(_) => {
                    for (_, Waiting { id, spec, shown, .. }) in std::mem::take(&mut self.waiting) {
                        self.send(answer::hover_response(id, &spec, shown));
                    }
                    match self.connection.receiver.recv_timeout(patience) {
                        Ok(message) => self.inbox.push_back(message),
                        Err(RecvTimeoutError::Timeout) => {}
                        Err(RecvTimeoutError::Disconnected) => return Err(Ending::Abrupt),
                    }
                }
            },
            default(patience) => {}
        }
        Ok(())
    }

    fn take(&mut self, message: Message) -> Option<Ending> {
        match message {
            Message::Request(request) => {
                self.request(request);
                None
            }
            Message::Notification(note) if note.method == "exit" => {
                Some(if self.is_shut_down { Ending::Agreed } else { Ending::Abrupt })
            }
            Message::Notification(note) => {
                // A bug in one answer must not stop the server.
                let outcome = catch_unwind(AssertUnwindSafe(|| self.notification(note)));
                if outcome.is_err() {
                    self.log("a notification could not be dealt with: a mistake in mavc");
                }
                None
            }
            Message::Response(_) => None,
        }
    }

    fn request(&mut self, request: Request) {
        let id = request.id.clone();
        if self.is_shut_down {
            return self.fail(id, ErrorCode::InvalidRequest as i32, "the server is shut down");
        }
        if request.method == "shutdown" {
            self.is_shut_down = true;
            return self.send(Response::new_ok(id, ()));
        }
        if self.is_cancelled(&id) {
            return self.fail(id, ErrorCode::RequestCanceled as i32, "cancelled");
        }
        if self.is_superseded(&request) {
            return self.fail(id, ErrorCode::ContentModified as i32, "the text has changed since");
        }
        match catch_unwind(AssertUnwindSafe(|| answer::answer(self, request))) {
            Ok(Some(response)) => self.send(response),
            Ok(None) => {}
            Err(_) => self.fail(id, ErrorCode::InternalError as i32, "a mistake in mavc"),
        }
    }

    fn is_cancelled(&self, id: &RequestId) -> bool {
        self.inbox.iter().any(|message| match message {
            Message::Notification(note) => note.method == "$/cancelRequest" && cancelled(note).as_ref() == Some(id),
            _ => false,
        })
    }

    /// Whether a newer text of the document that a request is about is here already.
    fn is_superseded(&self, request: &Request) -> bool {
        const URI: &str = "/textDocument/uri";
        let Some(uri) = request.params.pointer(URI) else { return false };
        self.inbox.iter().any(|message| match message {
            Message::Notification(note) => {
                note.method == "textDocument/didChange" && note.params.pointer(URI) == Some(uri)
            }
            _ => false,
        })
    }

    fn notification(&mut self, note: Notification) {
        match note.method.as_str() {
            "initialized" if self.watches_files => {
                let patterns = ["**/*.mav", "**/*.csv", "**/*.txt"];
                let watchers = json!(patterns.map(|pattern| json!({ "globPattern": pattern })));
                let registration = json!({
                    "id": "files",
                    "method": "workspace/didChangeWatchedFiles",
                    "registerOptions": { "watchers": watchers },
                });
                let params = json!({ "registrations": [registration] });
                let id = RequestId::from("watch".to_string());
                self.send(Request { id, method: "client/registerCapability".into(), params });
            }
            "textDocument/didOpen" => self.with(note, |server, params: DidOpenTextDocumentParams| {
                let document = params.text_document;
                server.workspace.open(document.uri, document.version, document.text);
            }),
            "textDocument/didChange" => self.with(note, |server, params: DidChangeTextDocumentParams| {
                let name = name_of(&params.text_document.text_document_identifier.uri);
                server.workspace.change(&name, params.text_document.version, params.content_changes);
            }),
            "textDocument/didClose" => self.with(note, |server, params: DidCloseTextDocumentParams| {
                server.workspace.close(&name_of(&params.text_document.uri));
            }),
            "workspace/didChangeWatchedFiles" => self.with(note, |server, params: DidChangeWatchedFilesParams| {
                params.changes.iter().for_each(|change| server.workspace.changed(&name_of(&change.uri)));
            }),
            "workspace/didChangeWorkspaceFolders" => {
                let paths = |field: &str| -> Vec<PathBuf> {
                    let folders = note.params.pointer(field).and_then(Value::as_array).into_iter().flatten();
                    folders.filter_map(|f| Url::parse(f.get("uri")?.as_str()?).ok()?.to_file_path().ok()).collect()
                };
                let removed = paths("/event/removed");
                self.folders.retain(|folder| !removed.contains(folder));
                self.folders.extend(paths("/event/added"));
            }
            "$/cancelRequest" => {
                let id = cancelled(&note);
                let ticket = self.waiting.iter().find(|(_, w)| Some(&w.id) == id.as_ref()).map(|(ticket, _)| *ticket);
                if let Some(waiting) = ticket.and_then(|ticket| self.waiting.remove(&ticket)) {
                    waiting.withdrawn.store(true, Ordering::Relaxed);
                    self.fail(waiting.id, ErrorCode::RequestCanceled as i32, "cancelled");
                }
            }
            _ => {}
        }
    }

    /// A notification about texts; diagnostics follow. A notification with other parameters is ignored.
    fn with<P: DeserializeOwned>(&mut self, note: Notification, take: impl FnOnce(&mut Self, P)) {
        match serde_json::from_value(note.params) {
            Ok(params) => {
                take(self, params);
                self.progress = Progress::Due;
            }
            Err(error) => self.log(&format!("{} is not understood: {error}", note.method)),
        }
    }

    fn take_in(&mut self, found: Found) {
        match found {
            Found::Answers { round, root, diagnostics } => self.take_answers(round, root, diagnostics),
            Found::Verdicts { ticket, analyses } => {
                let Some(Waiting { id, spec, mut shown, .. }) = self.waiting.remove(&ticket) else { return };
                if let Some(wanted) = shown.wanted.take() {
                    shown.text.push_str(&format!("\n\n{}", verdicts(&wanted.model, &analyses)));
                }
                self.send(answer::hover_response(id, &spec, shown));
            }
        }
    }

    /// Keeps a hover until its verdicts are there.
    pub fn wait_for_verdicts(&mut self, id: RequestId, spec: Arc<Spec>, shown: Shown) {
        let Some(wanted) = &shown.wanted else { return };
        self.tickets += 1;
        match self.verdicts.ask_modes(self.tickets, &wanted.model, wanted.modes.clone()) {
            Some(withdrawn) => drop(self.waiting.insert(self.tickets, Waiting { id, spec, shown, withdrawn })),
            None => self.send(answer::hover_response(id, &spec, shown)),
        }
    }

    fn log(&self, message: &str) {
        let params = json!({ "type": 1, "message": message });
        self.send(Notification::new("window/logMessage".into(), params));
    }

    pub fn send(&self, message: impl Into<Message>) {
        // The reader notices that the editor is gone.
        let _ = self.connection.sender.send(plainly(message.into()));
    }

    fn fail(&self, id: RequestId, code: i32, message: &str) {
        self.send(Response::new_err(id, code, message.to_string()));
    }
}

/// The request that `$/cancelRequest` is about.
fn cancelled(note: &Notification) -> Option<RequestId> {
    match note.params.get("id")? {
        Value::Number(number) => i32::try_from(number.as_i64()?).ok().map(RequestId::from),
        Value::String(text) => Some(RequestId::from(text.clone())),
        _ => None,
    }
}
