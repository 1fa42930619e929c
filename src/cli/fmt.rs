use super::target::{Target, write};
use super::{FINE, FmtArgs, Options, Problem, SPEC_ERRORS, files, spec, specs, usage};
use crate::diagnostic::{Checked, Severity};
use crate::format::format;
use crate::source::{Source, SourceMap};
use crate::syntax::{MAX_FILE_BYTES, not_utf8};
use std::path::Path;

/// `mavc fmt`: each file by itself; one that cannot be laid out is left as it is and does not keep the others waiting.
pub fn run(args: &FmtArgs, options: &Options) -> Result<u8, Problem> {
    let found = specs::find(&args.specs)?;
    Ok(specs::worst(found.iter().map(|name| one(name, args.check, options).unwrap_or_else(|problem| usage(&problem)))))
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
        files::tell(&spec::human(&errors.collect::<Vec<_>>(), &sources, &std::io::stderr()));
        return Ok(SPEC_ERRORS);
    };
    let is_same = text.as_bytes() == bytes;
    if check {
        if !is_same {
            files::print(&format!("{}\n", spec::name(name)))?;
        }
        return Ok(if is_same { FINE } else { SPEC_ERRORS });
    }
    if name == "-" || !is_same {
        write(&[(&Target::new(Path::new(name))?, text)])?;
    }
    Ok(FINE)
}
