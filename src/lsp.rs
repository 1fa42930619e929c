//! The language server: `mavc lsp`, over standard input and output, synchronous.
//!
//! One loop answers the editor, one thread beside it works out verdicts. A spec is compiled by the stages of
//! `mavc check` when somebody asks about it, and again only after a change. The planner never runs.
//!
//! | room | what it does |
//! |---|---|
//! | `server`, `answer`, `publication` | the conversation: which message gets what, what is published when |
//! | `documents`, `workspace` | open texts, the specs they make up |
//! | `verdicts` | analyses of fault modes, beside the conversation |
//! | `names`, `mentions`, `navigation`, `rename` | what every word means, where names are declared and used |
//! | `lexemes` | words and marks of texts that cannot be read |
//! | `documentation` | what the language reference says of a word |
//! | `diagnostics`, `actions`, `hover`, `completion`, `outline`, `tokens`, `hints`, `formatting` | one answer each |

mod actions;
mod answer;
mod completion;
mod diagnostics;
mod documentation;
mod documents;
mod formatting;
mod hints;
mod hover;
mod lexemes;
mod mentions;
mod names;
mod navigation;
mod outline;
mod publication;
mod rename;
mod server;
mod tokens;
mod verdicts;
mod workspace;

pub use documentation::{Entry, field as field_documentation};

use lsp_server::Connection;
use server::Server;

/// How a conversation has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// As agreed: `shutdown`, then `exit`.
    Agreed,
    /// The editor went away without a word, or said `exit` alone.
    Abrupt,
}

/// Serves one editor until it says `exit` or goes away.
pub fn serve(connection: &Connection) -> Ending {
    let Ok((id, params)) = connection.initialize_start() else { return Ending::Abrupt };
    Server::new(connection, id, params).run()
}

/// Serves the editor at standard input and output.
///
/// # Errors
/// Standard input or output failed.
pub fn serve_stdio() -> std::io::Result<Ending> {
    let (connection, threads) = Connection::stdio();
    let ending = serve(&connection);
    // The threads end with their channels.
    drop(connection);
    match ending {
        Ending::Agreed => threads.join().map(|()| ending),
        // The reader may still wait for an editor that says nothing any more.
        Ending::Abrupt => Ok(ending),
    }
}
