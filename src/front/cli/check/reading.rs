//! Reading what `mavc check` checks: a spec, or with `--vehicle` a mission of a ground station.

use crate::cli::progress::Watch;
use crate::cli::spec::{self, Findings};
use crate::cli::{CheckArgs, Options, Problem, SpecArgs, files};
use crate::diagnostic::sort;
use crate::import::{MAX_BYTES, mission};
use crate::pipeline::check;
use crate::read::FlightBlocks;
use crate::source::FileId;
use crate::spec::{Compiler, Spec};
use std::path::Path;

/// The spec, if it has no errors, and everything that is wrong with it.
pub fn read(name: &str, args: &CheckArgs, options: &Options) -> Result<(Option<Spec>, Findings), Problem> {
    let watch = Watch::new(options);
    let Some(vehicle) = &args.vehicle else {
        let args = SpecArgs { spec: name.into(), set: args.set.clone() };
        let (spec, mut findings) = spec::read(&args, FlightBlocks::Used, &watch)?;
        if findings.has_errors() && mission::is_one(&findings.files.sources.get(FileId(0)).text) {
            let name = spec::shown(name);
            return Err(format!(
                "{name} is a mission of a ground station: name the spec of its vehicle by --vehicle v.mav"
            ));
        }
        if let Some(spec) = &spec {
            findings.diagnostics.extend(check(spec));
            sort(&mut findings.diagnostics);
        }
        return Ok((spec, findings));
    };
    // A vehicle that cannot be read is a mistake in the command line, not in the mission.
    files::read_spec(vehicle, 0)?;
    if Path::new(vehicle).file_name().is_none() || vehicle == "-" {
        return Err(format!("--vehicle names a file, not {}", crate::source::visible::line(vehicle)));
    }
    let bytes = files::read_spec(name, MAX_BYTES)?;
    let compiler = args.set.iter().fold(Compiler::new().observed_by(&watch), Compiler::set);
    let joined = mission::join(spec::name(name), &bytes, vehicle, &compiler, check);
    Ok((joined.spec, Findings { files: joined.files, diagnostics: joined.diagnostics }))
}
