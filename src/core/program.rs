//! The program `mavc-verify CERTIFICATE SPEC`: decides a certificate as `mavc verify` does, without planner and solver.

use crate::certificate::MAX_BYTES;
use crate::diagnostic::render_human;
use crate::input::{self, MAX_FILE_BYTES};
use crate::source::{FileId, visible};
use crate::spec::{Compiled, Compiler};
use crate::text_table::WIDTH;
use crate::verify::cost::Budget;
use crate::verify::text::verification;
use crate::verify::{TOO_COSTLY, read, verify_within};
use std::io::Write;

// The exit codes are those of `mavc verify`: docs/certificates.md.
const ACCEPTED: u8 = 0;
const SPEC_ERRORS: u8 = 1;
const USAGE: u8 = 2;
const REJECTED: u8 = 5;
const WEAKER: u8 = 7;
const OVER_BUDGET: u8 = 8;

const HELP: &str = "\
Decides whether a certificate of `mavc plan --certificate` holds for a spec.

Usage: mavc-verify [--budget 10s,500MB] [--set FIELD=VALUE]... CERTIFICATE SPEC

A certificate or a spec named `-` is read from standard input.

Exit codes: 0 accepted; 7 accepted, but weaker than the spec requires;
5 rejected; 8 not decided, over the budget; 1 the spec has errors; 2 wrong
usage, or a file that cannot be read
";

struct Arguments {
    certificate: String,
    spec: String,
    budget: Budget,
    set: Vec<String>,
}

impl Arguments {
    fn read(words: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let (mut names, mut set, mut budget) = (Vec::new(), Vec::new(), Budget::default());
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            // `--set=F=V` as well as `--set F=V`.
            let (option, joined) = match word.split_once('=') {
                Some((option, value)) if option.starts_with("--") => (option.to_string(), Some(value.to_string())),
                _ => (word, None),
            };
            let mut value = || joined.clone().or_else(|| words.next()).ok_or(format!("`{option}` needs a value"));
            match option.as_str() {
                "--budget" => budget = value()?.parse()?,
                "--set" => set.push(value()?),
                _ if option.len() > 1 && option.starts_with('-') => return Err(format!("unknown option `{option}`")),
                _ => names.push(option),
            }
        }
        let [certificate, spec] = <[String; 2]>::try_from(names)
            .map_err(|names| format!("expected a certificate and its spec, found {} names", names.len()))?;
        if certificate == "-" && spec == "-" {
            return Err("only one of the certificate and the spec can be standard input".into());
        }
        Ok(Arguments { certificate, spec, budget, set })
    }
}

fn name(file: &str) -> &str {
    if file == "-" { "<stdin>" } else { file }
}

fn bytes(file: &str, most: usize) -> Result<Vec<u8>, String> {
    input::given(file, most).map_err(|e| format!("cannot read {}: {}", visible::line(file), input::reason(&e)))
}

/// Decides, and gives the exit code.
///
/// # Errors
/// A file cannot be read, or the two names are the wrong way round.
fn decide(arguments: &Arguments, out: &mut dyn Write, err: &mut dyn Write) -> Result<u8, String> {
    let certificate = bytes(&arguments.certificate, MAX_BYTES)?;
    let text = bytes(&arguments.spec, MAX_FILE_BYTES)?;
    let compiler = arguments.set.iter().fold(Compiler::new().without_flights(), Compiler::set);
    let compiled = compiler.text(name(&arguments.spec), &text);
    let Compiled { spec: Some(spec), .. } = &compiled else {
        if std::str::from_utf8(&text).is_ok_and(|text| read(text.as_bytes(), FileId::default()).is_ok()) {
            let name = visible::line(&arguments.spec);
            return Err(format!("{name} is a certificate; give the certificate first, then its spec"));
        }
        print(err, &visible::text(&compiled.render()));
        return Ok(SPEC_ERRORS);
    };
    match verify_within(arguments.budget, name(&arguments.certificate), &certificate, spec) {
        Ok(verdict) => {
            let shown = visible::line(name(&arguments.certificate)).into_owned();
            print(out, &visible::text(&verification(&shown, &verdict)));
            Ok(if verdict.weaker.is_empty() { ACCEPTED } else { WEAKER })
        }
        Err(rejected) => {
            let found = std::slice::from_ref(&*rejected.diagnostic);
            print(err, &visible::text(&render_human(found, &rejected.sources, WIDTH, false)));
            Ok(if rejected.diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED })
        }
    }
}

/// Prints a text. A reader that has gone away changes nothing about the verdict.
fn print(stream: &mut dyn Write, text: &str) {
    let _ = stream.write_all(text.as_bytes());
}

/// Runs the program with the words after its name, writes to `out` and `err`, and gives the exit code: 0 accepted,
/// 7 accepted but weaker than the spec requires, 5 rejected, 8 over the budget, 1 errors in the spec, 2 wrong usage.
pub fn run(words: impl IntoIterator<Item = String>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let words: Vec<String> = words.into_iter().collect();
    if words.iter().any(|word| word == "--help" || word == "-h") {
        print(out, HELP);
        return ACCEPTED;
    }
    if words.iter().any(|word| word == "--version" || word == "-V") {
        print(out, concat!("mavc-verify ", env!("CARGO_PKG_VERSION"), "\n"));
        return ACCEPTED;
    }
    Arguments::read(words).and_then(|arguments| decide(&arguments, out, err)).unwrap_or_else(|why| {
        print(err, &format!("mavc-verify: {why}\n"));
        USAGE
    })
}
