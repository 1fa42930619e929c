//! The command `mavc`. Everything is in the library; here is only the exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(mavc::cli::run())
}
