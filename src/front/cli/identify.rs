//! `mavc identify`: the spec of the vehicle that flew.

use super::diagnose::{eprint, open};
use super::target::{Target, write};
use super::{CommandError, FINE, IdentifyArgs, Options, SPEC_ERRORS, files};
use crate::pipeline::{Identified, Undiagnosed, identify};
use std::path::Path;

pub fn run(args: &IdentifyArgs, options: &Options) -> Result<u8, CommandError> {
    let target = args.output.as_deref().map(Target::new).transpose()?;
    if let Some((target, path)) = target.as_ref().zip(args.output.as_deref()) {
        target.must_spare([args.log.as_str()])?;
        // An identified spec is filled in by hand, which must not be lost.
        if path.is_file() {
            return Err(format!("{} exists already; nothing was written", files::shown(path)));
        }
    }
    match identify(&mut open(&args.log)?, &args.mass) {
        Err(Undiagnosed::Io(e)) => Err(files::cannot_read(Path::new(&args.log), &e)),
        Err(Undiagnosed::Not(found)) => {
            eprint(&args.log, found, options);
            Ok(SPEC_ERRORS)
        }
        Ok(Identified { text, diagnostics, .. }) => {
            eprint(&args.log, diagnostics, options);
            match &target {
                Some(target) => write(&[(target, text.as_bytes())])?,
                None => files::print_result(text.as_bytes())?,
            }
            Ok(FINE)
        }
    }
}
