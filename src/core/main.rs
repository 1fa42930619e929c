use std::io::{stderr, stdout};
use std::process::ExitCode;

fn main() -> ExitCode {
    // A name that is no text names no file that can be opened by its text: the program says so.
    let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    ExitCode::from(mavc_verify::program::run(words, &mut stdout().lock(), &mut stderr().lock()))
}
