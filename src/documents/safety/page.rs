//! The page that links the files of the folder and answers an assessor's questions.

use super::inputs::{SUMS, TABLES};
use super::quantities::by_importance;
use super::questions::questions;
use super::{CERTIFICATE, Case, REPORT, SEVERITIES, sha256, short};
use crate::number::fixed;
use maud::{DOCTYPE, Markup, html};

/// Few rules, so that the page prints.
const STYLE: &str = "body{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}\
                     table{border-collapse:collapse;margin:1rem 0}\
                     td,th{border:1px solid #bbb;padding:.2rem .6rem;text-align:left;vertical-align:top}\
                     code{word-break:break-all}dt{font-weight:bold;margin-top:.8rem}img{max-width:100%}";

/// The page loads nothing but its drawing, and runs no script.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src 'self'";

/// What none of the files covers.
const NOT_COVERED: [&str; 13] = [
    "faults that the spec does not declare, and undetected ones",
    "ways out after a second fault",
    "take-off and landing outside the waypoints of the mission",
    "faults during a way out, and after the end of the mission",
    "false alarms, and a fault that is taken for another one",
    "how the result changes with the delay until a fault is known: only that of the spec, or else mavc's default, is \
     looked at",
    "instants between those that were looked at, except where the certificate proves ways out",
    "causes of failures, and the source of rates",
    "real flights: no plan of mavc has flown; simulated flights were compared with MuJoCo (documentation of mavc, \
     Flight)",
    "failures of structure, battery, sensors, link, software and pilot, unless they are modes of the spec",
    "harm to people and property on the ground: the outcomes are those of the vehicle",
    "that the controller of the real vehicle follows a way out",
    "compliance with any regulation or standard",
];

/// The forms of the files, with the editions that are meant.
const FORMS: [&str; 6] = [
    "fmea.csv: a worksheet of failure modes and effects with the usual columns. S, O, D and RPN are the spec's and \
     belong to the mode; severity_class belongs to the row, and follows from its outcome. effect_s is the time of the \
     phase for which a strike has the outcome of the row; exposure_s is the part of it that counts as a loss of \
     control, so it is effect_s or 0. provision names the tables of the ways out at the instants of effect_times_s and \
     next to them; a way out whose instant lies between failed flights is in no row. The standard for such worksheets, \
     IEC 60812:2018, was not read and is not quoted; conformity is not claimed.",
    "fha.csv: a list of functional hazards. mode_seconds is effect_s summed over the modes of the row; the heights are \
     those of the plan at these times, above the mission's ground or else above the origin of its coordinates. \
     probability_of_modes_with_rate is that one of those modes strikes then, in the \
     middle of the intervals of the rates. Its columns and severity classes are mavc's, from no standard.",
    "quantities.json: uncovered_s is the time that counts as a loss of control, the sum of none_found_s, without a way \
     out, and failed_flights_s; uncovered_s in report.json is none_found_s. proved_s is the time that counts as \
     covered and that the certificate proves.",
    "branches/index.csv: one row for each way out. deviation_m is the largest distance from the plan before the fault \
     is known, seed that of its simulated flight, flight how this ended.",
    "faulttree.xml: Open-PSA Model Exchange Format, version 2.0, as scram 0.16.2 reads it. A rate that is an interval \
     is a uniform distribution over it: mavc's choice, because the spec gives the ends alone. scram takes its mean, or \
     draws from it.",
    "argument.svg and argument.json: Goal Structuring Notation; meant is the Community Standard, Version 3. Goals are \
     supported by goals, strategies and solutions, strategies by goals; both hold in contexts and assumptions.",
];

/// The files, and what is in each.
const FILES: [(&str, &str); 8] = [
    ("fmea.csv", "FMEA worksheet: one row for each mode, phase and outcome"),
    ("fha.csv", "functional hazards: failure condition, phase, outcome, severity"),
    ("faulttree.xml", "fault tree (Open-PSA model exchange format)"),
    ("quantities.json", "probabilities, cut sets, what matters most"),
    ("argument.svg", "the argument in goal structuring notation"),
    ("argument.json", "the same for programs"),
    (REPORT, "the plan and the outcomes of faults, from which the files above are written"),
    (CERTIFICATE, "the certificate of the plan, which mavc verify accepted"),
];

/// The page.
pub fn page(case: &Case) -> String {
    let (q, model, mission) = (&case.quantities, case.problem.model(), case.problem.mission());
    let title = format!("Safety assessment of {} on {}", model.vehicle.name, mission.name);
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { (title) }
                style { (maud::PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                p {
                    "Written by mavc " (case.inputs.written_by) " from the spec with the hash "
                    code { (case.spec_sha256) } ". Change the spec and write the folder again; edit no file by hand. "
                    code { "mavc safety SPEC -o DIR --check" } " finds files that do not follow from the spec, the \
                     report and the certificate."
                }
                (spec(case))
                h2 { "Files" }
                table {
                    @for (name, what) in FILES { tr { td { a href=(name) { (name) } } td { (what) } } }
                    @if !case.inputs.tables.is_empty() {
                        @let index = format!("{TABLES}/index.csv");
                        tr { td { a href=(index) { (index) } } td { "the tables of the ways out, and what each is" } }
                        tr { td { a href=(SUMS) { (SUMS) } } td { "the SHA-256 of each of them" } }
                    }
                }
                p {
                    (REPORT) " " code { (sha256(case.inputs.report)) }
                    br;
                    (CERTIFICATE) " " code { (sha256(case.inputs.certificate)) }
                    @if let Some(hash) = case.inputs.tables_sha256() {
                        br;
                        (SUMS) " " code { (hash) }
                    }
                }
                h2 { "Questions of an assessor" }
                dl {
                    @for (question, answer) in questions(case) { dt { (question) } dd { (answer) } }
                }
                @if q.probability.is_some() {
                    h2 { "What matters most" }
                    p { "In the middle of the intervals of the rates." }
                    (importance(case))
                }
                h2 { "Each mode" }
                (modes(case))
                h2 { "Severities" }
                p {
                    "mavc's own proposal, derived from the outcome alone; S in fmea.csv is severity of the spec. Put \
                     classes of your own into your own documents: --check expects the files as they were written."
                }
                table {
                    tr { th { "outcome" } th { "effect" } th { "severity class" } }
                    @for (outcome, effect, word) in SEVERITIES { tr { td { (outcome) } td { (effect) } td { (word) } } }
                }
                h2 { "Forms" }
                ul { @for form in FORMS { li { (form) } } }
                h2 { "Assumptions" }
                ol { @for text in case.assumptions() { li { (text) } } }
                h2 { "Not covered" }
                ul { @for text in NOT_COVERED { li { (text) } } }
                h2 { "Argument" }
                img src="argument.svg" alt="The argument; argument.json has its text";
            }
        }
    };
    markup.into_string() + "\n"
}

/// What the spec is, so that it can be found again.
fn spec(case: &Case) -> Markup {
    html! {
        table {
            tr { th { "text of the spec" } th { "SHA-256 of the file" } }
            @for text in &case.texts {
                tr { td { a href=(text.file) { (text.file) } } td { code { (sha256(text.text.as_bytes())) } } }
            }
        }
        @if !case.set.is_empty() { p { "With --set: " (case.set.join(", ")) } }
        p {
            "The files are those that were read, without byte order marks. The hash of the spec is the SHA-256 of \
             these texts in this order, and then of the values of --set except plan.effort, each after its length in \
             bytes as an integer of 8 bytes, the lowest first."
        }
        p {
            "report.json, certificate.json and the files in branches are results of the search; all others follow from \
             the first two and the spec. The certificate is verified; the report is not, and `mavc safety` without \
             --report repeats its search."
        }
    }
}

fn importance(case: &Case) -> Markup {
    let q = &case.quantities;
    html! {
        table {
            tr {
                th { "mode" }
                th { "rate, 1/h" }
                th { "saved if it never strikes" }
                th { "saved by a second more covered" }
            }
            @for (at, saved) in by_importance(q) {
                @let one = &q.rated[at];
                tr {
                    td { (case.problem.model().modes[one.mode].name) }
                    td {
                        (short(one.rate_per_h))
                        @let [low, high] = one.interval().map(short);
                        @if !one.spread.is_none() { " (" (low) " to " (high) ")" }
                    }
                    td { (short(saved)) }
                    td { @if one.exposed.is_empty() { "always covered" } @else { (short(q.saved_by_a_second(at))) } }
                }
            }
        }
    }
}

fn modes(case: &Case) -> Markup {
    let of_modes = case.problem.model().modes.iter().zip(&case.evidence.modes);
    html! {
        table {
            tr { th { "mode" } th { "outcomes, s" } th { "counted as lost, s" } th { "covered and proved, s" } }
            @for ((mode, evidence), why) in of_modes.zip(&case.not_sought) {
                tr {
                    td { (mode.name) }
                    td {
                        @for (outcome, (word, ..)) in SEVERITIES.iter().enumerate() {
                            @let seconds = evidence.with_outcome(outcome);
                            @if seconds > 0.0 { (word) ": " (fixed(seconds, 2)) br; }
                        }
                        @if let Some(why) = why { (why) }
                    }
                    td { (fixed(evidence.uncovered(), 2)) }
                    td { (fixed(evidence.proved(), 2)) }
                }
            }
        }
    }
}
