//! Predictions of plans against flights.

use crate::campaign::agreement::Scope;
use crate::campaign::statistics::{Contingency, Strength};
use serde::Serialize;

/// Whether the plans predict which flights are lost.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct AgreementRecord {
    /// All declared modes, or those with hover inside their sets.
    #[cfg_attr(test, schemars(extend("enum" = ["all", "inside"])))]
    pub modes: &'static str,
    /// Number of these modes.
    pub mode_count: usize,
    /// All plans, then each planner; a plan that several planners share counts once among all. Predicted lost: the
    /// fault strikes before `last_violation_s`. Only flights still flying when the fault struck.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub by_flight: Vec<TableRecord>,
}

/// Predictions of plans against flights.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TableRecord {
    /// null: all of them.
    #[cfg_attr(test, schemars(extend("enum" = ["rip", "rcp", "rsp", null])))]
    pub planner: Option<&'static str>,
    #[serde(flatten)]
    pub counts: Contingency,
    /// Share lost; null without flights.
    pub base_rate: Option<f64>,
    /// Phi coefficient; null if predictions or losses are all the same.
    pub phi: Option<f64>,
    /// The strength of this coefficient.
    pub strength: Strength,
}

impl AgreementRecord {
    pub(super) fn new(modes: &'static str, scope: &Scope) -> Self {
        let table = |planner: Option<&'static str>, counts: &Contingency| TableRecord {
            planner,
            counts: *counts,
            base_rate: counts.base_rate(),
            phi: counts.phi(),
            strength: Strength::of(counts.phi()),
        };
        let each = scope.planners.iter().map(|(planner, counts)| table(Some(planner.name()), counts));
        AgreementRecord {
            modes,
            mode_count: scope.modes,
            by_flight: std::iter::once(table(None, &scope.total)).chain(each).collect(),
        }
    }
}
