//! Predictions against flights, and plans against what the path suffers.

use crate::campaign::agreement::{Scope, Strength};
use crate::campaign::correlations::Correlation;
use crate::campaign::predictors::{ClassCount, Forecast, Predictor};
use crate::campaign::statistics::Contingency;
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
    /// Spearman's, between `violation_duration_s` and the share lost, over pairs of plan and mode.
    pub rank_correlation: Option<f64>,
    /// The strength of this correlation.
    pub rank_strength: Strength,
    /// Pairs of plan and mode with struck flights.
    pub pairs: usize,
    /// Whether worse plans do more harm to the path: every quality of a plan against every harm.
    pub harm: Vec<Correlation>,
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

/// A predictor against the flights of all distinct plans. Only flights still flying when the fault struck.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PredictorRecord {
    /// What predicts; docs/campaigns.md states when each predicts a loss.
    pub predictor: Predictor,
    #[serde(flatten)]
    pub counts: Contingency,
    /// Phi coefficient; null if predictions or outcomes are all the same.
    pub phi: Option<f64>,
    /// The strength of this coefficient.
    pub strength: Strength,
    /// Brier score of the prediction as 0 or 1: the share that it gets wrong.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier: Option<f64>,
    /// Of the share lost in the same class with the other modes, (lost + 1)/(struck + 2).
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier_by_class: Option<f64>,
    /// Of the share lost with the other modes, whatever the class: the score to beat.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier_base: Option<f64>,
    /// The classes of flights that it distinguishes.
    pub classes: Vec<ClassCount>,
}

impl PredictorRecord {
    pub(super) fn new(forecast: Forecast) -> Self {
        PredictorRecord {
            predictor: forecast.predictor,
            counts: forecast.counts,
            phi: forecast.counts.phi(),
            strength: forecast.strength(),
            brier: forecast.brier,
            brier_by_class: forecast.brier_by_class,
            brier_base: forecast.brier_base,
            classes: forecast.classes,
        }
    }
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
            rank_correlation: scope.rank_correlation,
            rank_strength: Strength::of(scope.rank_correlation),
            pairs: scope.pairs,
            harm: scope.harm.clone(),
        }
    }
}
