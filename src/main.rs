//! The command `mavc`. The library does everything; this file only sets the exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(mavc::cli::run())
}
