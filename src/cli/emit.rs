use super::plan::no_mission;
use super::spec::{self, Loaded};
use super::{EmitArgs, EmitFormat, FINE, INCONCLUSIVE, NO_PLAN, Options, Problem, SPEC_ERRORS, Stage, USAGE, files};
use crate::actuation::Actuation;
use crate::admissible::AdmissibleSet;
use crate::admissible::diagnose::{diagnose, is_too_large};
use crate::diagnostic::{Severity, sort};
use crate::model::{FlightBlocks, Mission, Model};
use crate::planner::hover::{FEASIBLE, HoverPlanner};
use crate::planner::studies::{NotFound, PlanOutcome, PlannerRun, Proof, Scope, compare};
use crate::planner::transcription::{Purpose, Transcription};
use crate::qp::{QuadraticProgram, mps};
use crate::source::visible;
use serde::Serialize;

/// MPS cannot say a second-order cone.
pub const NO_CONES_IN_MPS: &str = "mavc::emit::cones";

/// `mavc emit`
pub fn run(args: &EmitArgs, options: &Options) -> Result<u8, Problem> {
    if args.stage != Stage::Qp && args.format != EmitFormat::Text {
        return Err("--format json and mps are for the stage qp".into());
    }
    if args.stage == Stage::Ast {
        return ast(args, options);
    }
    // The model is printed with how it is flown; the other stages need no flight.
    let flights = if args.stage == Stage::Model { FlightBlocks::Used } else { FlightBlocks::Unused };
    let mut loaded = spec::read(&args.spec, flights, options)?;
    let Some(model) = loaded.model.clone() else {
        loaded.tell(options);
        return Ok(SPEC_ERRORS);
    };
    match args.stage {
        Stage::Ast => {}
        Stage::Model => files::print(&model.to_string())?,
        Stage::Actuation => files::print(&Actuation::of(&model.vehicle).to_string())?,
        Stage::Sets => {
            for (k, set) in AdmissibleSet::each(&model).enumerate() {
                files::print(&format!("{}{set}", if k > 0 { "\n" } else { "" }))?;
            }
        }
        Stage::Constraints | Stage::Qp => return planned(args, &mut loaded, &model, options),
    }
    loaded.tell(options);
    Ok(FINE)
}

/// The stage that needs no meaning, only syntax.
fn ast(args: &EmitArgs, options: &Options) -> Result<u8, Problem> {
    let (mut loaded, _) = spec::parse(&args.spec, options)?;
    sort(&mut loaded.diagnostics);
    loaded.tell(options);
    if loaded.has_errors() {
        return Ok(SPEC_ERRORS);
    }
    for file in &loaded.files.files {
        let name = visible::line(&loaded.files.sources.get(file.file).name);
        files::print(&format!("// {name}\n{file}"))?;
    }
    Ok(FINE)
}

/// The stages that need the planner's choice of rows and a mission time.
fn planned(args: &EmitArgs, loaded: &mut Loaded, model: &Model, options: &Options) -> Result<u8, Problem> {
    let answers = diagnose(model);
    let is_too_large = is_too_large(&answers);
    loaded.diagnostics.extend(answers);
    loaded.diagnostics.extend(no_mission(model));
    sort(&mut loaded.diagnostics);
    loaded.tell(options);
    let Some(mission) = model.mission.as_ref().filter(|_| !is_too_large) else { return Ok(SPEC_ERRORS) };
    if loaded.diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Ok(NO_PLAN);
    }
    let comparison = compare(model, mission, Scope::Plan, None);
    let Some(run) = comparison.runs.last() else { return Ok(INCONCLUSIVE) };
    if args.stage == Stage::Constraints {
        files::print(&run.set.to_string())?;
        return Ok(FINE);
    }
    let time = match &run.outcome {
        PlanOutcome::Planned(s) => s.time,
        PlanOutcome::Infeasible(Proof { at, .. })
        | PlanOutcome::NotFound(NotFound::Search { at, .. })
        | PlanOutcome::NotFound(NotFound::Check { at, .. })
        | PlanOutcome::NotAttempted { at, .. } => *at,
    };
    let Some(program) = program(model, mission, run, time) else {
        return Err(format!("the mission cannot be laid out over {time} s"));
    };
    match args.format {
        EmitFormat::Text => files::print(&summary(&program, time))?,
        EmitFormat::Json => {
            let text = serde_json::to_string(&Exported::of(&program, time)).map_err(|e| e.to_string())?;
            let text = visible::json(text);
            files::print(&(text + "\n"))?;
        }
        EmitFormat::Mps => match mps::render(&program, "mavc") {
            Some(text) => files::print(&text)?,
            None => {
                files::tell(&format!(
                    "error[{NO_CONES_IN_MPS}]: this program has second-order cones, and MPS cannot say them\n  help: use `--format json`; without waypoint tolerances (`--set plan.within=1e6km`) and without limits on\n        norms there are none\n"
                ));
                return Ok(USAGE);
            }
        },
    }
    Ok(FINE)
}

/// The full-row program of a run at a mission time.
fn program(model: &Model, mission: &Mission, run: &PlannerRun, time: f64) -> Option<QuadraticProgram> {
    let healthy = AdmissibleSet::healthy(model);
    let mut engine = HoverPlanner::new(model, mission, &healthy);
    let layout = engine.layout(time, model.plan.samples).ok()??;
    let maps = layout.yaw.maps(model, layout.flown.nodes());
    let leads = layout.commands(model);
    let transcription = Transcription::new(model, mission, &layout.flown, &run.set, &maps, layout.yaw.axes());
    Some(transcription.with_commands(leads.as_ref()).full_program(Purpose::Plan { slack: FEASIBLE }))
}

/// The program as exported: minimise 1/2 x'P x + q'x + constant subject to A x + s = b, s in the cones.
#[derive(Serialize)]
struct Exported<'a> {
    schema: u32,
    time_s: f64,
    #[serde(flatten)]
    program: &'a QuadraticProgram,
}

impl<'a> Exported<'a> {
    fn of(program: &'a QuadraticProgram, time_s: f64) -> Self {
        Exported { schema: 1, time_s, program }
    }
}

fn summary(program: &QuadraticProgram, time: f64) -> String {
    format!("mission time {time} s\n{program}")
}
