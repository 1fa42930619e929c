//! `mavc fmt`: formats each file by itself. One that has errors is left as it is and does not stop the others.

mod first_difference;

use super::target::{Target, write};
use super::{FINE, FmtArgs, Options, Problem, SPEC_ERRORS, files, spec, specs, usage};
use crate::diagnostic::{Checked, Severity};
use crate::format::format;
use crate::input::MAX_FILE_BYTES;
use crate::source::{Source, SourceMap};
use crate::syntax::not_utf8;
use first_difference::first_difference;
use std::path::Path;

pub fn run(args: &FmtArgs, options: &Options) -> Result<u8, Problem> {
    let found = specs::find(&args.specs);
    let bad = found.eprint();
    let each = found.specs.iter().map(|name| one(name, args.check, options).unwrap_or_else(|problem| usage(&problem)));
    Ok(specs::worst(each.chain([bad])))
}

fn one(name: &str, check: bool, options: &Options) -> Result<u8, Problem> {
    let bytes = files::read_spec(name, MAX_FILE_BYTES)?;
    let mut sources = SourceMap::default();
    let formatted = match Source::from_bytes(spec::name(name), &bytes) {
        Ok(source) => {
            let file = sources.add(source);
            format(file, sources.get(file))
        }
        Err(broken) => {
            let file = sources.add(broken.source.clone());
            Checked { value: None, diagnostics: vec![not_utf8(file, &broken)] }
        }
    };
    let Some(text) = formatted.value else {
        let errors = formatted.diagnostics.into_iter().filter(|d| d.severity == Severity::Error || !options.quiet);
        files::eprint_as_it_is(&spec::human(&errors.collect::<Vec<_>>(), &sources, &std::io::stderr()));
        return Ok(SPEC_ERRORS);
    };
    let is_same = text.as_bytes() == bytes;
    if check {
        if !is_same {
            // `format` accepted the bytes, so they are UTF-8.
            files::print(&first_difference(
                &spec::shown(name),
                &String::from_utf8_lossy(&bytes),
                &text,
                options.quiet,
            ))?;
        }
        return Ok(if is_same { FINE } else { SPEC_ERRORS });
    }
    if name == "-" || !is_same {
        // The file behind a descriptor may be open for reading only: the text goes to standard output.
        let target = if is_descriptor(name) { "-" } else { name };
        write(&[(&Target::new(Path::new(target))?, text.as_bytes())])?;
    }
    Ok(FINE)
}

/// Whether a name refers to an open descriptor of this process.
fn is_descriptor(name: &str) -> bool {
    name == "/dev/stdin" || name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/")
}
