use super::{FINE, Problem, USAGE, files};
use crate::lsp::{Ending, serve_stdio};

/// `mavc lsp`
pub fn run() -> Result<u8, Problem> {
    match serve_stdio() {
        Ok(Ending::Agreed) => Ok(FINE),
        Ok(Ending::Abrupt) => Ok(USAGE),
        Err(error) => Err(format!("the conversation with the editor broke off: {}", files::reason(&error))),
    }
}
