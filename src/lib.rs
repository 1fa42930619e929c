#![doc = include_str!("lib.md")]

pub mod actuation;
pub mod admissible;
pub mod builder;
pub mod campaign;
pub mod cancel;
pub mod certificate;
pub mod certify;
#[cfg(feature = "cli")]
pub mod cli;
pub mod diagnostic;
pub mod energy;
pub mod exchange;
pub mod explain;
pub mod flatness;
pub mod flight;
pub mod format;
pub mod geodesy;
pub mod geometry;
pub mod import;
pub mod input;
pub mod language;
#[cfg(feature = "lsp")]
pub mod lsp;
pub mod model;
pub mod motion;
pub mod number;
pub mod observer;
pub mod pipeline;
pub mod planner;
pub mod qp;
pub mod report;
pub mod solve;
pub mod source;
pub mod spec;
pub mod syntax;
pub mod tolerance;
pub mod unit;
pub mod verdict;
pub mod verify;

pub use builder::Builder;
pub use certificate::Certificate;
pub use diagnostic::{Diagnostic, Severity};
pub use observer::Observer;
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
