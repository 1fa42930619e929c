//! `mavc import`: writes a spec from the file of another tool, and never overwrites one.

use super::spec::{human, shown};
use super::target::{Target, write};
use super::{CommandError, FINE, ImportArgs, ImportCommand, ImportMissionArgs, Options, SPEC_ERRORS, files};
use crate::diagnostic::Severity;
use crate::foreign;
use crate::import::{Imported, MAX_BYTES, mission, vehicle};
use crate::input::FileKind;
use crate::spec::Compiler;
use crate::text_table::WIDTH;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

/// So many bytes are enough to tell what a file is.
const FIRST_BYTES: u64 = 1 << 16;

pub fn run(what: &ImportCommand, options: &Options) -> Result<u8, CommandError> {
    match what {
        ImportCommand::Vehicle(args) => one(args, vehicle::import, options),
        ImportCommand::Mission(ImportMissionArgs { import, vehicle }) => {
            let used = vehicle.as_deref().map(|path| relative(path, import.output.as_deref())).transpose()?;
            let path = vehicle.as_deref().map(|path| path.display().to_string());
            let taken = path.map_or(Vec::new(), |path| mission::names_in(&path, &Compiler::new()));
            one(import, |name, bytes| mission::import_beside(name, bytes, used.as_deref(), &taken), options)
        }
        ImportCommand::Unsaid(words) => Err(unsaid(&words[0])),
    }
}

/// The error for a file without `vehicle` or `mission` before it.
fn unsaid(file: &str) -> CommandError {
    let named = shown(file);
    let mut bytes = Vec::new();
    // What a file is, its first bytes say.
    let read = std::fs::File::open(file).and_then(|file| file.take(FIRST_BYTES).read_to_end(&mut bytes));
    if read.is_err() {
        return format!("expected `vehicle` or `mission`, found `{named}`: mavc import mission FILE");
    }
    let kind = foreign::of_bytes(&bytes);
    let found = kind.map_or(String::new(), |kind| format!(", {}", kind.what()));
    let help = match kind {
        Some(kind) => kind.help(file),
        None => format!("`mavc import vehicle {named}` or `mavc import mission {named}`"),
    };
    format!("expected `vehicle` or `mission` before {named}{found}: {help}")
}

fn one(args: &ImportArgs, read: impl Fn(&str, &[u8]) -> Imported, options: &Options) -> Result<u8, CommandError> {
    let target = args.output.as_deref().map(Target::new).transpose()?;
    if let Some((target, path)) = target.as_ref().zip(args.output.as_deref()) {
        target.must_spare([args.file.as_str()])?;
        // An imported spec is filled in by hand, which must not be lost.
        if path.is_file() {
            return Err(format!("{} exists already; nothing was written", files::shown(path)));
        }
    }
    let bytes = files::read_spec(&args.file, MAX_BYTES)?;
    let mut imported = read(super::spec::name(&args.file), &bytes);
    if options.quiet {
        imported.diagnostics.retain(|d| d.severity == Severity::Error);
    }
    files::eprint_as_it_is(&human(&imported.diagnostics, &imported.sources, &std::io::stderr()));
    let Some(text) = &imported.text else { return Ok(SPEC_ERRORS) };
    match &target {
        Some(target) => write(&[(target, text.as_bytes())])?,
        None => files::print_result(text.as_bytes())?,
    }
    if !options.quiet {
        files::eprint(&remarks(&imported, args));
    }
    Ok(FINE)
}

/// What was left out, what is to be filled in, and what to do next.
fn remarks(imported: &Imported, args: &ImportArgs) -> String {
    let mut out = String::new();
    if !imported.dropped.is_empty() {
        let list = textwrap::fill(
            &imported.dropped.join(" "),
            textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  "),
        );
        out.push_str(&format!("Left out of {}, because no spec has or needs it:\n{list}\n", shown(&args.file)));
    }
    let text = imported.text.as_deref().unwrap_or_default();
    let unknown = text.lines().filter(|line| line.split("//").next().is_some_and(|code| code.contains('?'))).count();
    let to = args.output.as_deref().map(files::shown);
    if unknown > 0 {
        let lines = if unknown == 1 { "1 line has".into() } else { format!("{unknown} lines have") };
        let next = match &to {
            Some(to) => format!("Fill in what is missing, then: mavc check {to}"),
            None => "Write it to a file by `-o v.mav`, fill in what is missing, then: mavc check v.mav".into(),
        };
        out.push_str(&format!("{lines} a `?` for a figure that the file does not give.\n{next}\n"));
    } else if let Some(to) = to.filter(|to| to != "-") {
        let has_vehicle = text.lines().any(|line| line.starts_with("vehicle ") || line.starts_with("use "));
        let first = if has_vehicle { "" } else { "begin it with `use \"v.mav\"`, your vehicle's spec, then: " };
        out.push_str(&format!("{to} written. Next: {first}mavc check {to}\n"));
    }
    out
}

/// The path of the spec `used` as a spec at `output` names it: relative to the folder of `output`, or to the present
/// one without an output.
fn relative(used: &Path, output: Option<&Path>) -> Result<String, CommandError> {
    let whole = used.canonicalize().map_err(|e| files::cannot_read(used, &e))?;
    super::spec::must_be_one(&used.display().to_string())?;
    if FileKind::of(used) != Some(FileKind::Spec) {
        return Err(format!("--vehicle {}: `use` reads only files whose names end in `.mav`", files::shown(used)));
    }
    let folder = match output.filter(|path| path.as_os_str() != "-").and_then(Path::parent) {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => Path::new("."),
    };
    let folder = folder.canonicalize().map_err(|e| files::cannot_read(folder, &e))?;
    let (from, to): (Vec<Component>, Vec<Component>) = (folder.components().collect(), whole.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // Another drive, of which only the whole path tells.
    let path: PathBuf = match common {
        0 => whole.clone(),
        _ => from[common..].iter().map(|_| Component::ParentDir).chain(to[common..].iter().copied()).collect(),
    };
    match path.to_str() {
        Some(text) => Ok(text.replace('\\', "/")),
        None => Err(format!("{} cannot be named in a spec: its name is not UTF-8", used.display())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_named_from_the_folder_of_the_other() {
        let dir = tempfile::tempdir().unwrap();
        let [vehicle, folder] = ["v/quad.mav", "m/deep"].map(|name| dir.path().join(name));
        std::fs::create_dir_all(vehicle.parent().unwrap()).unwrap();
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(&vehicle, "").unwrap();
        let named = |output: &Path| relative(&vehicle, Some(output)).unwrap();
        assert_eq!(named(&folder.join("out.mav")), "../../v/quad.mav");
        assert_eq!(named(&dir.path().join("v/out.mav")), "quad.mav");
        assert_eq!(named(&dir.path().join("out.mav")), "v/quad.mav");
        assert!(relative(&dir.path().join("none.mav"), None).is_err());
    }
}
