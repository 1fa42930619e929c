//! `mavc emit`: prints what one stage of the compiler makes of a spec.

use super::progress::Watch;
use super::results::compact_json;
use super::spec::{self, Findings, Start};
use super::{CommandError, EmitArgs, EmitFormat, FINE, NO_PLAN, Options, SPEC_ERRORS, Stage, USAGE, files};
use crate::diagnostic::sort;
use crate::observer::Silent;
use crate::pipeline::{Task, actuation_text, mjcf_text, model_record, px4_params_text, sets_text};
use crate::read::FlightBlocks;
use crate::source::visible;
use crate::spec::Spec;

pub fn run(args: &EmitArgs, options: &Options) -> Result<u8, CommandError> {
    if !args.has_format() {
        return Err("--format json is for the stages model and qp".into());
    }
    let watch = Watch::new(options);
    if args.stage == Stage::Ast {
        return ast(spec::parse(&args.spec, &watch)?, options);
    }
    let flights = if args.is_flown() { FlightBlocks::Used } else { FlightBlocks::Unused };
    let (spec, mut findings) = spec::read(&args.spec, flights, &watch)?;
    if let (Some(spec), Stage::Constraints | Stage::Qp) = (&spec, args.stage) {
        return planned(args, spec, &mut findings, options);
    }
    if let Some(spec) = &spec {
        files::print(&match args.stage {
            Stage::Model if args.format == EmitFormat::Json => compact_json(&model_record(spec))?,
            Stage::Model => spec.model().to_string(),
            Stage::Actuation => actuation_text(spec),
            Stage::Sets => sets_text(spec),
            Stage::Mjcf => mjcf_text(spec),
            Stage::Px4Params => px4_params_text(spec),
            Stage::Ast | Stage::Constraints | Stage::Qp => String::new(),
        })?;
    }
    findings.eprint(options);
    Ok(if spec.is_some() { FINE } else { SPEC_ERRORS })
}

/// The stage that needs only syntax.
fn ast(mut findings: Findings, options: &Options) -> Result<u8, CommandError> {
    sort(&mut findings.diagnostics);
    findings.eprint(options);
    let code = if findings.has_errors() { SPEC_ERRORS } else { FINE };
    for file in findings.files.files.iter().filter(|_| code == FINE) {
        files::print(&format!("// {}\n{file}", visible::line(&findings.files.sources.get(file.file).name)))?;
    }
    Ok(code)
}

/// The stages that need the planner's choice of rows and a mission time.
fn planned(args: &EmitArgs, spec: &Spec, findings: &mut Findings, options: &Options) -> Result<u8, CommandError> {
    let task = match findings.start(Some(spec), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => return Ok(NO_PLAN),
        Start::Ended(code) => return Ok(code),
    };
    let planning = task.plan(&Silent);
    if args.stage == Stage::Constraints {
        return files::print(&planning.set().to_string()).map(|()| FINE);
    }
    let program = match task.program(&planning) {
        Ok(Some(program)) => program,
        Ok(None) => return Err(format!("the mission has no time grid over {} s", planning.time())),
        Err(refusal) => {
            files::eprint(&refusal.to_string());
            return Ok(USAGE);
        }
    };
    let text = match args.format {
        EmitFormat::Text => program.to_text(),
        EmitFormat::Json => compact_json(&program)?,
    };
    files::print(&text).map(|()| FINE)
}
