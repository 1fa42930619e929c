//! `mavc view`: serves a page that updates whenever the spec is saved.

use super::progress::Watch;
use super::spec::{self, Findings};
use super::{CommandError, Options, ViewArgs, files};
use crate::front::view::View;
use crate::read::FlightBlocks;
use crate::spec::Compiled;
use std::process::{Command, Stdio};

/// Runs until the process ends, on Ctrl-C.
pub fn run(args: &ViewArgs, options: &Options) -> Result<u8, CommandError> {
    let name = &args.spec.spec;
    if name == "-" {
        return Err("`mavc view` is for files: standard input is read once".into());
    }
    let read = || -> Result<Compiled, CommandError> {
        let watch = Watch::new(options);
        let (spec, Findings { files, diagnostics }) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
        Ok(Compiled { spec, diagnostics, files })
    };
    // A name that cannot be read is a mistake in the command line; later it is a file that went away.
    read()?;
    let view = View::new(args.port)?;
    let address = view.address();
    files::print(&format!("{address}\n"))?;
    if args.open {
        open(&address)?;
    }
    if !options.quiet {
        files::eprint("The page updates whenever you save the spec; press Ctrl-C to stop.\n");
    }
    view.show(name, read)
}

/// Opens an address in the browser of the system.
fn open(address: &str) -> Result<(), CommandError> {
    let opener = match () {
        () if cfg!(target_os = "macos") => "open",
        () if cfg!(windows) => "explorer",
        () => "xdg-open",
    };
    let mut command = Command::new(opener);
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let started = command.spawn();
    started.map(drop).map_err(|e| format!("cannot open a browser by `{opener}`: {}", files::reason(&e)))
}
