//! Files of the command, and its standard input, output and error.

use super::{CommandError, links};
use crate::input;
pub use crate::input::reason;
use crate::report::screen::{Screen, Tone};
use crate::source::visible;
use crate::text_table::hanging;
use std::io::{Error, ErrorKind, IsTerminal, Write};
use std::path::Path;

/// The bytes of a spec or a certificate ([`input::given`]), at most one more than `most`.
pub fn read_spec(name: &str, most: usize) -> Result<Vec<u8>, CommandError> {
    input::given(name, most).map_err(|e| cannot_read(Path::new(name), &e))
}

/// The name of a file on one line of a terminal.
pub fn shown(path: &Path) -> String {
    visible::line(&path.display().to_string()).into_owned()
}

pub fn cannot_read(path: &Path, e: &Error) -> CommandError {
    format!("cannot read {}: {}", path.display(), reason(e))
}

/// Prints a text for people to standard output, disguised characters as escapes.
pub fn print(text: &str) -> Result<(), CommandError> {
    print_as_it_is(&visible::text(text))
}

/// Prints a text for people to standard output, in colours where a terminal shows them.
pub fn print_screen(screen: &Screen) -> Result<(), CommandError> {
    print_as_it_is(&painted(screen, &std::io::stdout()))
}

/// Prints a text for people to standard error; see `eprint`.
pub fn eprint_screen(screen: &Screen) {
    eprint_as_it_is(&painted(screen, &std::io::stderr()));
}

/// The text with the escapes of its colours if `stream` shows them, disguised characters as escapes.
fn painted(screen: &Screen, stream: &impl IsTerminal) -> String {
    let is_colored = links::colored(stream);
    let line = |(tone, text): (Tone, &str)| {
        let text = visible::text(text);
        let code = match tone {
            Tone::Plain => "",
            Tone::Good => "32;1",
            Tone::Bad => "31;1",
            Tone::Warning => "33",
            Tone::Strong => "1",
        };
        match is_colored && !code.is_empty() {
            true => format!("\u{1b}[{code}m{text}\u{1b}[0m\n"),
            false => format!("{text}\n"),
        }
    };
    screen.lines().map(line).collect()
}

/// Prints a result with the bytes that a file would get; on a terminal disguised characters are shown as escapes, and
/// bytes that are not text are refused.
pub fn print_result(bytes: &[u8]) -> Result<(), CommandError> {
    if std::io::stdout().is_terminal() {
        return match std::str::from_utf8(bytes) {
            Ok(text) => print(text),
            Err(_) => Err("the result is binary and standard output a terminal: name a file with -o".into()),
        };
    }
    let mut stream = std::io::stdout().lock();
    written(stream.write_all(bytes).and_then(|()| stream.flush()))
}

/// Prints a text without disguised characters, with its colours and links.
pub fn print_as_it_is(text: &str) -> Result<(), CommandError> {
    let mut stream = anstream::stdout().lock();
    written(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// Whether standard output took the text; a reader that has gone away is not an error.
pub fn written(outcome: std::io::Result<()>) -> Result<(), CommandError> {
    unless_gone(outcome).map_err(|e| format!("cannot write to standard output: {}", reason(&e)))
}

/// Ignores that the reader has gone away: it has seen all that it wanted.
pub fn unless_gone(outcome: std::io::Result<()>) -> std::io::Result<()> {
    outcome.or_else(|e| if e.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(e) })
}

/// Prints to standard error, disguised characters as escapes; on a terminal the sentences of mavc in lines that fit.
/// Failures are ignored: there is no other place to report them.
pub fn eprint(text: &str) {
    let text = visible::text(text);
    match std::io::stderr().is_terminal() {
        true => {
            let fitted = |line: &str| if line.starts_with("mavc: ") { hanging(line) } else { format!("{line}\n") };
            eprint_as_it_is(&text.lines().map(fitted).collect::<String>());
        }
        false => eprint_as_it_is(&text),
    }
}

/// Prints a text with its colours and links to standard error.
pub fn eprint_as_it_is(text: &str) {
    let _ = anstream::stderr().write_all(text.as_bytes());
}
