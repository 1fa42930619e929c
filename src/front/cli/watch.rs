//! `mavc check --watch`: checks again whenever a file that was read changes, appears or goes away.

use super::check::round;
use super::{CheckArgs, CheckFormat, CommandError, Options, files, usage};
use crate::front::watched::Watched;
use std::io::IsTerminal;

/// The screen, its history and the place of the cursor.
const CLEARED: &str = "\u{1b}[2J\u{1b}[3J\u{1b}[H";

/// Runs until the process ends, on Ctrl-C.
pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, CommandError> {
    if args.specs.iter().any(|name| name == "-") {
        return Err("--watch is for files: standard input is read once".into());
    }
    let mut watched = Watched::new()?;
    // Before the first round, so that no change is missed.
    watched.add(&args.specs)?;
    loop {
        if args.format == CheckFormat::Human && std::io::stdout().is_terminal() {
            files::print_as_it_is(CLEARED)?;
        }
        match round(args, options) {
            Ok(round) => watched.add(&round.files)?,
            Err(problem) => drop(usage(&problem)),
        }
        if !options.quiet {
            files::eprint("Watching for changes; press Ctrl-C to stop.\n");
        }
        watched.wait()?;
    }
}
