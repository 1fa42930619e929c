//! `mavc identify`: the spec of the vehicle that flew.

use super::diagnose::{eprint, open, refused};
use super::target::{Target, write};
use super::{CommandError, FINE, IdentifyArgs, Options, files};
use crate::pipeline::{Identified, Undiagnosed, identify};

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
        Err(Undiagnosed { why, .. }) => refused(&args.log, why, options),
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
