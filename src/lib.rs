#![doc = include_str!("lib.md")]

mod answers;
pub mod cancel;
mod documents;
mod flights;
mod front;
mod physics;
mod planning;

pub use answers::{builder, observer, pipeline};
#[cfg(feature = "report")]
pub use documents::safety;
pub use documents::{exchange, import, log, report};
pub use flights::{campaign, diagnosis, flight, recovery};
#[cfg(feature = "cli")]
pub use front::cli;
#[cfg(feature = "lsp")]
pub use front::lsp;
pub use mavc_verify::{
    body, certificate, diagnostic, foreign, format, geodesy, input, language, model, number, read, source, spec,
    syntax, text_table, tolerance, unit, verdict, verify,
};
pub use physics::{actuation, admissible, energy, flatness, geometry, motion};
pub use planning::{certify, explain, planner, qp, solve};

pub use builder::Builder;
pub use certificate::Certificate;
pub use diagnostic::{Diagnostic, Severity};
pub use observer::{Observer, Trial};
pub use pipeline::{
    Explained, NoFlight, OtherSpec, Planning, Refusal, Rejected, Task, Uncertified, Unexplained, analyze, campaign,
    capture, certify, check, compare, compile, explain, fly, format, plan, verify,
};
pub use planner::studies::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof};
pub use spec::{CompileError, Compiled, Compiler, Spec};
pub use verdict::Verdict;

/// A commented spec that plans as it is written: what `mavc new` writes.
pub const TEMPLATE: &str = include_str!("template.mav");

/// Commented specs of whole missions, each with its kind: what `mavc new --mission KIND` writes.
pub const MISSION_TEMPLATES: [(&str, &str); 4] = [
    ("inspection", include_str!("template/inspection.mav")),
    ("delivery", include_str!("template/delivery.mav")),
    ("survey", include_str!("template/survey.mav")),
    ("room", include_str!("template/room.mav")),
];

#[cfg(test)]
mod tests {
    use crate::documents::schemas::check;
    use crate::report::{analysis_record, campaign_record, diagnosis, model_record, record, simulation};

    /// With `MAVC_UPDATE=1` they are written anew.
    #[test]
    fn the_schemas_of_the_records_are_current() {
        check::<analysis_record::AnalysisRecord<crate::pipeline::Flip>>("analyze", "mavc analyze --format json");
        check::<analysis_record::OutcomesRecord>("outcomes", "mavc check --format json, last line");
        check::<crate::pipeline::Program>("qp", "mavc emit qp --format json");
        check::<model_record::ModelRecord>("model", "mavc emit model --format json");
        check::<record::Record>("report", "mavc plan --report, mavc compare --report");
        check::<simulation::FlightRecord>("simulate", "mavc simulate --report");
        check::<campaign_record::CampaignRecord>("campaign", "mavc campaign --report");
        check::<diagnosis::DiagnosisRecord>("diagnose", "mavc diagnose --format json");
    }
}
