//! `mavc emit`: what one stage of the compiler makes of a spec.

use super::progress::Watch;
use super::spec::{self, Start, Told};
use super::{EmitArgs, EmitFormat, FINE, NO_PLAN, Options, Problem, SPEC_ERRORS, Stage, USAGE, files};
use crate::actuation::Actuation;
use crate::admissible::AdmissibleSet;
use crate::diagnostic::sort;
use crate::model::FlightBlocks;
use crate::observer::Silent;
use crate::pipeline::Task;
use crate::qp::mps;
use crate::source::visible;
use crate::spec::Spec;

/// MPS cannot say a second-order cone.
pub const NO_CONES_IN_MPS: &str = "mavc::emit::cones";

pub fn run(args: &EmitArgs, options: &Options) -> Result<u8, Problem> {
    if args.stage != Stage::Qp && args.format != EmitFormat::Text {
        return Err("--format json and mps are for the stage qp".into());
    }
    let watch = Watch::new(options);
    if args.stage == Stage::Ast {
        return ast(spec::parse(&args.spec, &watch)?, options);
    }
    // The model is printed with how it is flown; the other stages need no flight.
    let flights = if args.stage == Stage::Model { FlightBlocks::Used } else { FlightBlocks::Unused };
    let (spec, mut told) = spec::read(&args.spec, flights, &watch)?;
    if let (Some(spec), Stage::Constraints | Stage::Qp) = (&spec, args.stage) {
        return planned(args, spec, &mut told, options);
    }
    if let Some(spec) = &spec {
        match args.stage {
            Stage::Model => files::print(&spec.model().to_string())?,
            Stage::Actuation => files::print(&Actuation::of(&spec.model().vehicle).to_string())?,
            Stage::Sets => {
                for (k, set) in AdmissibleSet::each(spec.model()).enumerate() {
                    files::print(&format!("{}{set}", if k > 0 { "\n" } else { "" }))?;
                }
            }
            Stage::Ast | Stage::Constraints | Stage::Qp => {}
        }
    }
    told.tell(options);
    Ok(if spec.is_some() { FINE } else { SPEC_ERRORS })
}

/// The stage that needs no meaning, only syntax.
fn ast(mut told: Told, options: &Options) -> Result<u8, Problem> {
    sort(&mut told.diagnostics);
    told.tell(options);
    if told.has_errors() {
        return Ok(SPEC_ERRORS);
    }
    for file in &told.files.files {
        let name = visible::line(&told.files.sources.get(file.file).name);
        files::print(&format!("// {name}\n{file}"))?;
    }
    Ok(FINE)
}

/// The stages that need the planner's choice of rows and a mission time.
fn planned(args: &EmitArgs, spec: &Spec, told: &mut Told, options: &Options) -> Result<u8, Problem> {
    let task = match told.start(Some(spec), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => return Ok(NO_PLAN),
        Start::Ended(code) => return Ok(code),
    };
    let planning = task.plan(&Silent);
    if args.stage == Stage::Constraints {
        files::print(&planning.set().to_string())?;
        return Ok(FINE);
    }
    let Some(program) = task.program(&planning) else {
        return Err(format!("the mission cannot be laid out over {} s", planning.time()));
    };
    match args.format {
        EmitFormat::Text => files::print(&format!("mission time {} s\n{}", program.time_s, program.program))?,
        EmitFormat::Json => {
            let text = serde_json::to_string(&program).map_err(|e| e.to_string())?;
            files::print(&(visible::json(text) + "\n"))?;
        }
        EmitFormat::Mps => match mps::render(&program.program, "mavc") {
            Some(text) => files::print(&text)?,
            None => {
                files::tell(&format!(
                    "error[{NO_CONES_IN_MPS}]: this program has second-order cones, and MPS cannot express them\n  help: use `--format json`; without waypoint tolerances (`--set plan.within=1e6km`) and without limits on\n        norms there are none\n"
                ));
                return Ok(USAGE);
            }
        },
    }
    Ok(FINE)
}
