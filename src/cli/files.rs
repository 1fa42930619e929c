//! Reading specs, and what is told on standard output and standard error.

use super::Problem;
use std::io::{Error, ErrorKind, Read, Write};

/// The bytes of a spec, at most one more than `most`; `-` is standard input.
pub fn read_spec(name: &str, most: usize) -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    let limit = most as u64 + 1;
    let result = if name == "-" {
        std::io::stdin().lock().take(limit).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(name).and_then(|f| f.take(limit).read_to_end(&mut bytes))
    };
    match result {
        Ok(_) => Ok(bytes),
        Err(e) => Err(format!("cannot read {name}: {}", reason(&e))),
    }
}

/// An input-output error without the operating system's number.
pub fn reason(e: &Error) -> String {
    match e.kind() {
        ErrorKind::NotFound => "no such file".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        _ => {
            let text = e.to_string();
            text.split(" (os error").next().unwrap_or(&text).to_string()
        }
    }
}

/// Prints to standard output.
pub fn print(text: &str) -> Result<(), Problem> {
    let mut stream = anstream::stdout().lock();
    told(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// Whether standard output took what was printed; a reader that has gone away is no error.
pub fn told(outcome: std::io::Result<()>) -> Result<(), Problem> {
    unless_gone(outcome).map_err(|e| format!("cannot write to standard output: {}", reason(&e)))
}

/// A reader that has gone away has seen all that it wanted.
pub fn unless_gone(outcome: std::io::Result<()>) -> std::io::Result<()> {
    outcome.or_else(|e| if e.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(e) })
}

/// Tells something on standard error; where that fails, nobody is left to be told.
pub fn tell(text: &str) {
    let _ = anstream::stderr().write_all(text.as_bytes());
}
