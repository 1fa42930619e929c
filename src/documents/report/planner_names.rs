//! The names of planners in full, with what each does, for a reader who sees the abbreviations for the first time.

use crate::model::PlannerKind;

/// `RIP (risk-insensitive) ignores faults; RSP (risk-sensitive) guards what RIP violates`
pub fn planners_in_full(planners: &[PlannerKind]) -> String {
    let does = |planner: &PlannerKind| match planner {
        PlannerKind::Rip => "ignores faults",
        PlannerKind::Rsp if planners.contains(&PlannerKind::Rip) => "guards what RIP violates",
        PlannerKind::Rsp => "guards what ignoring faults violates",
        PlannerKind::Rcp => "guards every constraint",
    };
    let each = planners
        .iter()
        .map(|planner| format!("{} ({}) {}", planner.name().to_uppercase(), planner.in_full(), does(planner)));
    each.collect::<Vec<_>>().join("; ")
}
