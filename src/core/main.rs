//! The program `mavc-verify`: decides a certificate for a spec without the code that made it.

use std::io::{stderr, stdout};
use std::process::ExitCode;

fn main() -> ExitCode {
    // A file cannot be opened by a name that is not text: the program then says so.
    let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    ExitCode::from(mavc_verify::program::run(words, &mut stdout().lock(), &mut stderr().lock()))
}
