//! `mavc lsp`: runs the language server.

use super::{CommandError, FINE, USAGE, files};
use crate::lsp::{Ending, serve_stdio};

pub fn run() -> Result<u8, CommandError> {
    match serve_stdio() {
        Ok(Ending::Agreed) => Ok(FINE),
        Ok(Ending::Abrupt) => Ok(USAGE),
        Err(error) => Err(format!("the connection to the editor was lost: {}", files::reason(&error))),
    }
}
