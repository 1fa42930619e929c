//! A campaign: everything that predicts losses against the flights, and plans against what the path suffers.

use super::prose::true_minus;
use super::table::{Frame, counts, table, words};
use crate::campaign::predictors::{ClassCount, Forecast};
use crate::campaign::statistics::Interval;
use crate::number::{fixed, part_of_all};
use crate::report::campaign_record::CampaignRecord;
use maud::{Markup, html};

/// Predictors with phi and Brier scores, and the classes that they distinguish.
pub fn predictors(record: &CampaignRecord) -> Markup {
    let score = |score: Option<f64>| score.map_or("\u{2013}".into(), |s| true_minus(&fixed(s, 3)));
    let measured = ["Hits", "Misses", "False alarms", "Correct negatives", "phi", "Brier", "by class", "base rate"];
    let heads: Vec<_> =
        [words("Predictor")].into_iter().chain(measured.map(counts)).chain([words("Lost, by class")]).collect();
    let rows = html! {
        @for p in &record.predictors {
            tr {
                th scope="row" { (p.predictor.words()) }
                td.n { (p.counts.hits) }
                td.n { (p.counts.misses) }
                td.n { (p.counts.false_alarms) }
                td.n { (p.counts.correct_negatives) }
                td.n { (p.phi.map_or("\u{2013}".into(), |phi| true_minus(&fixed(phi, 2)))) }
                td.n { (score(p.brier)) }
                td.n { (score(p.brier_by_class)) }
                td.n { (score(p.brier_base)) }
                td { (classes(p)) }
            }
        }
    };
    html! {
        h3 { "Predicted against flown" }
        p.note {
            "Over all modes and all distinct plans. Brier: mean squared error of the predicted probability of loss, 0 \
             is best: of the prediction as 0 or 1; of the share lost in the same class with the other modes; and of \
             the share lost with the other modes, which a predictor has to beat."
        }
        (table(Frame { label: "Predictors", ..Frame::default() }, &heads, rows))
    }
}

/// `controllable: 0 of 96 (0 %)`
fn classes(predictor: &Forecast) -> String {
    let class = |c: &ClassCount| {
        format!("{}: {} of {} ({} %)", c.class, c.lost, c.struck, part_of_all(c.lost as f64 / c.struck as f64))
    };
    predictor.classes.iter().map(class).collect::<Vec<_>>().join("; ")
}

/// Rank correlations of the quality of plans with what the path suffers.
pub fn harm(record: &CampaignRecord) -> Markup {
    let value = |r: Option<f64>| r.map_or("\u{2013}".into(), |r| true_minus(&fixed(r, 2)));
    let (Some(all), Some(inside)) = (record.agreement.first(), record.agreement.last()) else { return html! {} };
    let measured = ["All modes", "95 % interval", "Hover inside", "Within modes"];
    let heads: Vec<_> = [words("Quality"), words("Harm")].into_iter().chain(measured.map(counts)).collect();
    let interval = |range: Interval| true_minus(&format!("{} to {}", fixed(range.low, 2), fixed(range.high, 2)));
    let rows = html! {
        @for (a, i) in all.harm.iter().zip(&inside.harm) {
            tr {
                th scope="row" { (a.quality.words()) }
                td { (a.harm.words()) }
                td.n { (value(a.rank_correlation)) }
                td.n { (a.interval.map_or("\u{2013}".into(), interval)) }
                td.n { (value(i.rank_correlation)) }
                td.n { (value(i.within_modes)) }
            }
        }
    };
    html! {
        h3 { "Do worse plans do more harm?" }
        p.note {
            "Spearman's rank correlation over pairs of plan and mode, with its 95 % interval as if pairs were \
             independent, which they are not. Within modes: over ranks within each mode with hover inside its set, so \
             that plans are compared and not modes."
        }
        (table(Frame { label: "Quality of plans and harm to the path", ..Frame::default() }, &heads, rows))
    }
}
