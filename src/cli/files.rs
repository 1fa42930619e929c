//! Reading specs, and what is told on standard output and standard error.

use super::Problem;
use crate::input::{Kind, at_most, open_regular, read_named};
use crate::source::visible;
use std::io::{Error, ErrorKind, IsTerminal, Write};
use std::path::Path;

/// The bytes of a spec or a certificate, at most one more than `most`; `-` is standard input. A name that ends as a spec's
/// is held to what `use` is held to: somebody else may have put a link or a pipe there. Any other name is that of a stream
/// or a file that the user means, `/dev/fd/63` among them.
pub fn read_spec(name: &str, most: usize) -> Result<Vec<u8>, Problem> {
    let path = Path::new(name);
    let result = if name == "-" {
        at_most(std::io::stdin().lock(), most)
    } else if Kind::of(path) == Some(Kind::Spec) {
        // Past its limit a spec is an error of the spec, told with a code.
        match read_named(path) {
            Err(e) if e.kind() == ErrorKind::FileTooLarge => open_regular(path).and_then(|file| at_most(file, most)),
            read => read,
        }
    } else {
        std::fs::File::open(path).and_then(|file| at_most(file, most))
    };
    result.map_err(|e| cannot_read(path, &e))
}

/// The name of a file on one line of a terminal.
pub fn shown(path: &Path) -> String {
    visible::line(&path.display().to_string()).into_owned()
}

pub fn cannot_read(path: &Path, e: &Error) -> Problem {
    format!("cannot read {}: {}", path.display(), reason(e))
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

/// Prints to standard output what is there to be read: disguises of others are shown as escapes.
pub fn print(text: &str) -> Result<(), Problem> {
    print_as_it_is(&visible::text(text))
}

/// The same where mavc itself paints with colours ([`crate::report::heat`]): these escapes stay.
pub fn print_painted(text: &str) -> Result<(), Problem> {
    print_as_it_is(&painted(text))
}

/// Prints a result, byte by byte as a file would get it; only on a terminal are disguises shown as escapes.
pub fn print_result(text: &str) -> Result<(), Problem> {
    if std::io::stdout().is_terminal() {
        return print(text);
    }
    let mut stream = std::io::stdout().lock();
    told(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// Prints what is free of disguises with the colours and links that belong there.
pub fn print_as_it_is(text: &str) -> Result<(), Problem> {
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

/// Tells something on standard error; where that fails, nobody is left to be told. Disguises are shown as escapes.
pub fn tell(text: &str) {
    tell_as_it_is(&visible::text(text));
}

/// As [`print_painted`], on standard error.
pub fn tell_painted(text: &str) {
    tell_as_it_is(&painted(text));
}

/// The text with all disguises as escapes, except for the colours of one mavc paints with.
fn painted(text: &str) -> String {
    let mut pieces = text.split('\u{1b}');
    let mut out = visible::text(pieces.next().unwrap_or_default()).into_owned();
    for piece in pieces {
        let digits = piece.strip_prefix('[').map(|p| p.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';'));
        let is_color = digits.is_some_and(|rest| rest.starts_with('m'));
        out.push_str(if is_color { "\u{1b}" } else { "\\u{1b}" });
        out.push_str(&visible::text(piece));
    }
    out
}

/// Tells on standard error what is free of disguises, with the colours and links that belong there.
pub fn tell_as_it_is(text: &str) {
    let _ = anstream::stderr().write_all(text.as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_all_escapes_only_colours_stay_where_mavc_paints() {
        assert_eq!(painted("a\x1b[48;5;71m \x1b[0mb"), "a\x1b[48;5;71m \x1b[0mb");
        assert_eq!(painted("a\x1b[2Jb\x1b]8;;c\x07\x1b\u{202e}"), "a\\u{1b}[2Jb\\u{1b}]8;;c\\u{7}\\u{1b}\\u{202e}");
    }
}
