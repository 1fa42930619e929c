//! The language server: `mavc lsp`, over standard input and output, synchronous.
//!
//! One loop answers the editor, one thread beside it works out verdicts. A spec is compiled by the stages of
//! `mavc check` when somebody asks about it, and again only after a change. The planner never runs.
//!
//! | module | what it does |
//! |---|---|
//! | `transport` | messages over standard input and output |
//! | `server`, `answer`, `publication` | the conversation: which message gets what, what is published when |
//! | `documents`, `workspace` | open texts, the specs they make up |
//! | `verdicts` | analyses of fault modes, beside the conversation |
//! | `names`, `mentions`, `navigation`, `rename` | what every word means, where names are declared and used |
//! | `documentation` | what the language reference says about a word |
//! | `diagnostics`, `actions`, `hover`, `completion`, `outline`, `tokens`, `hints`, `formatting` | one answer each |

mod actions;
mod answer;
mod completion;
mod diagnostics;
mod documentation;
mod documents;
#[cfg(test)]
mod every_row;
mod formatting;
mod hints;
mod hover;
mod mentions;
mod names;
mod navigation;
mod outline;
mod plain;
mod publication;
mod rename;
mod server;
mod tokens;
mod transport;
mod verdicts;
mod workspace;

pub use documentation::{field as field_documentation, unit as field_unit};

use crossbeam_channel::TryRecvError;
use lsp_server::{Connection, ErrorCode, Message, RequestId, Response};
use server::Server;

/// How a conversation has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The editor sent `shutdown`, then `exit`.
    Agreed,
    /// The editor went away without `shutdown`.
    Abrupt,
}

/// Serves one editor until it sends `exit` or goes away.
pub fn serve(connection: &Connection) -> Ending {
    match first_request(connection) {
        Some((id, params)) => Server::new(connection, id, params).run(),
        None => Ending::Abrupt,
    }
}

/// Waits for `initialize` and refuses every other request until then; `None` where the editor leaves before.
fn first_request(connection: &Connection) -> Option<(RequestId, serde_json::Value)> {
    loop {
        match connection.receiver.recv().ok()? {
            Message::Request(request) if request.method == "initialize" => return Some((request.id, request.params)),
            Message::Request(request) => {
                let message = format!("`{}` came before `initialize`", request.method);
                let refusal = Response::new_err(request.id, ErrorCode::ServerNotInitialized as i32, message);
                connection.sender.send(refusal.into()).ok()?;
            }
            Message::Notification(note) if note.method == "exit" => return None,
            Message::Notification(_) | Message::Response(_) => {}
        }
    }
}

/// Serves the editor at standard input and output.
///
/// # Errors
/// Standard input or output failed, or where a message of the editor ends cannot be known.
pub fn serve_stdio() -> std::io::Result<Ending> {
    let (connection, threads) = transport::stdio();
    let ending = serve(&connection);
    // The reader has gone where there was nothing more to read, or nothing that it could.
    let has_ended = connection.receiver.try_recv().is_err_and(|e| e == TryRecvError::Disconnected);
    // The threads end with their channels.
    drop(connection);
    match ending {
        Ending::Agreed => threads.join().map(|()| ending),
        // The reader may still wait for an editor that sends nothing.
        Ending::Abrupt if !has_ended => Ok(ending),
        Ending::Abrupt => threads.join().map(|()| ending),
    }
}
