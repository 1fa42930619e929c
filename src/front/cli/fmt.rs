//! `mavc fmt`: formats each file by itself. One that has errors is left as it is and does not stop the others.

use super::target::{Target, write};
use super::{CommandError, FINE, FmtArgs, Options, SPEC_ERRORS, files, spec, specs, usage};
use crate::diagnostic::{Checked, Severity};
use crate::foreign;
use crate::format::format;
use crate::input::MAX_FILE_BYTES;
use crate::source::{Source, SourceMap};
use crate::syntax::not_utf8;
use std::path::Path;

pub fn run(args: &FmtArgs, options: &Options) -> Result<u8, CommandError> {
    let found = specs::find(&args.specs);
    let bad = found.eprint();
    let each = found.specs.iter().map(|name| one(name, args.check, options).unwrap_or_else(|problem| usage(&problem)));
    Ok(specs::worst(each.chain([bad])))
}

fn one(name: &str, check: bool, options: &Options) -> Result<u8, CommandError> {
    let bytes = files::read_spec(name, MAX_FILE_BYTES)?;
    let mut sources = SourceMap::default();
    let formatted = match Source::from_bytes(spec::name(name), &bytes) {
        Ok(source) => {
            let file = sources.add(source);
            let formatted = format(file, sources.get(file));
            match foreign::of_text(&sources.get(file).text).filter(|_| formatted.value.is_none()) {
                Some(kind) => Checked { value: None, diagnostics: vec![kind.error(file, sources.get(file))] },
                None => formatted,
            }
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

const BYTE_ORDER_MARK: char = '\u{feff}';

/// The name of a file that would change, with its first line that would, before and after; the name alone if `brief`.
fn first_difference(name: &str, before: &str, after: &str, brief: bool) -> String {
    if brief {
        return format!("{name}\n");
    }
    let (mut old, mut new) = (before.split_inclusive('\n'), after.split_inclusive('\n'));
    let mut line = 1;
    let (old, new) = loop {
        match (old.next(), new.next()) {
            (old, new) if old == new && old.is_some() => line += 1,
            pair => break pair,
        }
    };
    let head = format!("{name}:{line}: would be reformatted\n");
    let shown = |sign: char, text: &str| format!("  {sign} {text}\n");
    let (was, is) = (old.unwrap_or("").trim_end(), new.unwrap_or("").trim_end());
    // A difference behind the last visible character has to be described.
    if was == is && old.is_some() && new.is_some() || was == format!("{BYTE_ORDER_MARK}{is}") {
        return head + &shown('~', unseen(old.unwrap_or(""), new.unwrap_or("")));
    }
    match (old, new) {
        (Some(_), _) if was.is_empty() => head + &shown('-', "an empty line"),
        (_, Some(_)) if is.is_empty() => head + &shown('+', "an empty line"),
        (Some(_), Some(_)) => head + &shown('-', was) + &shown('+', is),
        (Some(_), None) => head + &shown('-', was),
        (None, _) => head + &shown('+', is),
    }
}

/// The difference between two lines that look the same.
fn unseen(old: &str, new: &str) -> &'static str {
    if old.starts_with(BYTE_ORDER_MARK) {
        return "a byte order mark at the beginning";
    }
    match (old.ends_with('\n'), new.ends_with('\n'), old.ends_with("\r\n"), new.ends_with("\r\n")) {
        (false, true, ..) => "no line end at the end of the file",
        (.., true, false) => "a carriage return at the line's end, where the first line has none",
        (.., false, true) => "no carriage return at the line's end, where the first line has one",
        _ => "blanks at the line's end",
    }
}
