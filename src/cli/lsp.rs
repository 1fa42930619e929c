use super::{FINE, Problem, USAGE, files};
use crate::lsp::{FlightOutcome, serve_stdio};

/// `mavc lsp`
pub fn run() -> Result<u8, Problem> {
    match serve_stdio() {
        Ok(FlightOutcome::Agreed) => Ok(FINE),
        Ok(FlightOutcome::Abrupt) => Ok(USAGE),
        Err(error) => Err(format!("the conversation with the editor broke off: {}", files::reason(&error))),
    }
}
