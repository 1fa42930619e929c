//! The page that links the files of the folder and answers an assessor's questions.

use super::evidence::FAILED;
use super::inputs::{SUMS, TABLES};
use super::quantities::{by_importance, largest_share, with_interval};
use super::{CERTIFICATE, Case, REPORT, SEVERITIES, TARGET, sha256, short};
use crate::admissible::outcome::Outcome;
use crate::model::FaultMode;
use crate::number::{fixed, number, plural, significant};
use maud::{DOCTYPE, Markup, html};

/// Few rules, so that the page prints.
const STYLE: &str = "body{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}\
                     table{border-collapse:collapse;margin:1rem 0}\
                     td,th{border:1px solid #bbb;padding:.2rem .6rem;text-align:left;vertical-align:top}\
                     code{word-break:break-all}dt{font-weight:bold;margin-top:.8rem}img{max-width:100%}";

/// The page loads nothing but its drawing, and runs no script.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src 'self'";

/// What none of the files covers.
const NOT_COVERED: [&str; 12] = [
    "faults that the spec does not declare, and undetected ones",
    "ways out after a second fault",
    "take-off and landing outside the waypoints of the mission",
    "faults during a way out, and after the end of the mission",
    "false alarms, and a fault that is taken for another one",
    "how the result changes with the delay until a fault is known: only that of the spec, or else mavc's default, is \
     looked at",
    "instants between those that were looked at, except where the certificate proves ways out",
    "causes of failures, and the source of rates",
    "failures of structure, battery, sensors, link, software and pilot, unless they are modes of the spec",
    "harm to people and property on the ground: the outcomes are those of the vehicle",
    "that the controller of the real vehicle follows a way out",
    "compliance with any regulation or standard",
];

/// The forms of the files, with the editions that are meant.
const FORMS: [&str; 4] = [
    "fmea.csv: a worksheet of failure modes and effects with the usual columns. S, O, D and RPN are the spec's and \
     belong to the mode; severity_class belongs to the row, and follows from its outcome. effect_s is the time of the \
     phase for which a strike has the outcome of the row; exposure_s is the part of it that counts as a loss of \
     control, so it is effect_s or 0. The standard for such worksheets, IEC 60812:2018, was not read and is not \
     quoted; conformity is not claimed.",
    "fha.csv: a list of functional hazards. mode_seconds is effect_s summed over the modes of the row; \
     probability_per_mission is that one of them strikes then, in the middle of the intervals of the rates. Its \
     columns and severity classes are mavc's, from no standard.",
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
    (REPORT, "the plan and the ways out, from which all of these are written"),
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
                p { "mavc's own proposal, derived from the outcome alone. Replace it by your own." }
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
            "All files but report.json and certificate.json follow from these two and the spec. The certificate is \
             verified; the report is not, and `mavc safety` without --report repeats its search."
        }
    }
}

/// Ten questions, and the answers that the folder gives.
fn questions(case: &Case) -> Vec<(&'static str, String)> {
    let (q, e) = (&case.quantities, &case.evidence);
    let model = case.problem.model();
    let probability = match (q.probability, q.per_flight_hour()) {
        (Some(p), Some(hourly)) => {
            let unrated = case.unrated();
            let without = match unrated.is_empty() {
                true => String::new(),
                false => format!(" Not included, for want of a rate: {}.", unrated.join(", ")),
            };
            let failed = q.without_failures.map_or(String::new(), |p| {
                format!(" If ways out whose simulated flight failed covered their time: {} a mission.", short(p))
            });
            format!(
                "{} for each mission of {} s; {} for each flight hour if such missions follow each \
                 other.{failed}{without}",
                with_interval(p, q.interval),
                significant(e.duration, 4),
                short(hourly)
            )
        }
        _ => "Not covered: no mode of the spec has a rate.".into(),
    };
    let target = match (q.target, q.budget()) {
        (Some(target), Some(left)) if left >= 0.0 => {
            format!("Yes: the spec allows {}, and {} of it is left. {TARGET}.", short(target), short(left))
        }
        (Some(target), Some(left)) => {
            format!("No: the spec allows {}, exceeded by {}. {TARGET}.", short(target), short(-left))
        }
        (Some(_), None) => "Not covered: no mode has a rate.".into(),
        (None, _) => "Not covered: the spec states none (require risk).".into(),
    };
    let open: Vec<String> = (0..model.modes.len())
        .filter(|&mode| e.modes[mode].uncovered() > 0.0)
        .map(|mode| {
            let [open, failed] = [e.modes[mode].uncovered(), e.modes[mode].with_outcome(FAILED)];
            let failed = match failed > 0.0 {
                true => format!(" ({} s of it because simulated flights failed)", fixed(failed, 2)),
                false => String::new(),
            };
            format!("{} for {} s{failed}", model.modes[mode].name, fixed(open, 2))
        })
        .collect();
    let gaps = match open.is_empty() {
        true => "At every instant that was looked at, yes.".into(),
        false => format!("No: {}. fmea.csv has the phases.", open.join(", ")),
    };
    let all = q.by_contribution();
    let most = all.first().map_or_else(
        || by_time(case),
        |(mode, single)| {
            let alike = all.iter().filter(|(_, other)| other.probability == single.probability).count();
            format!(
                "{} on the {}: {} s, {}{}. By mode: the table What matters most.",
                model.modes[*mode].name,
                single.phase.label(),
                fixed(single.seconds, 2),
                short(single.probability),
                if alike > 1 { format!(", and {} more alike", alike - 1) } else { String::new() }
            )
        },
    );
    let several = model.modes.iter().filter(|mode| mode.capacities().iter().filter(|c| **c < 1.0).count() > 1);
    let rate = |mode: &FaultMode| if mode.rate.is_some() { "with a rate" } else { "without a rate" };
    let several: Vec<String> = several.map(|mode| format!("{} ({})", mode.name, rate(mode))).collect();
    let common = match several.is_empty() {
        true => "Not covered: no mode of the spec affects several rotors by their capacity.".into(),
        false => format!("As modes that the spec declares: {}.", several.join(", ")),
    };
    let hovering = |pair: &&([usize; 2], Option<Outcome>)| pair.1 == Some(Outcome::FullControl);
    let count = model.modes.len();
    let omitted = match count * count.saturating_sub(1) / 2 - case.pairs.len() {
        0 => String::new(),
        one @ 1 => format!(" {one} more pair has a mode without a rate, and is not counted."),
        more => format!(" {more} more pairs have a mode without a rate, and are not counted."),
    };
    let rated = if q.rated.is_empty() { "" } else { " of modes with rates" };
    let likely = q.two_strikes().map_or(String::new(), |all| {
        let both = q.both_covered(|_| 1.0);
        format!(
            " Two modes strike in one mission with the probability {}; both where they are covered with at most {}.",
            short(all),
            short(both)
        )
    });
    let doubles = format!(
        "Each pair counts as a loss of control; no way out is sought. {} of {}{rated} would leave full control in \
         hover.{omitted}{likely}",
        case.pairs.iter().filter(hovering).count(),
        plural(case.pairs.len(), "pair"),
    );
    let detection = match e.detection[..] {
        [least, most] => format!("{} to {} ms", number(1e3 * least), number(1e3 * most)),
        _ => format!("{} ms", number(1e3 * e.detection[0])),
    };
    let [shown, covered] = e.proved_and_covered();
    let failed = match e.failed_where_proved {
        0 => String::new(),
        count => format!(
            " The certificate proves ways out for {} s; simulated flights after a fault in them failed: {count}. These \
             times count as a loss of control.",
            fixed(e.families_s, 2)
        ),
    };
    let tables = match case.inputs.tables.is_empty() {
        true => {
            "tables that are not in the folder, because it was written with --report; mavc plan --branches writes them"
        }
        false => "tables in the folder branches",
    };
    let sample = match e.flown {
        0 => String::new(),
        flown => format!(
            " With 95 % confidence, at most {} % of such flights fail, as far as they are independent and alike.",
            significant(100.0 * largest_share(flown - e.survived, flown), 2)
        ),
    };
    let between = match shown > 0.0 {
        true => format!(
            "Ways out: at every instant of {} s of the {} s x fault that count as covered, from the states within the \
             certificate's tolerances; that a fault leads to one is simulated.{failed}",
            fixed(shown, 2),
            fixed(covered, 2)
        ),
        false => format!("No way out that counts as covered is proved; the search checks them at instants.{failed}"),
    };
    let proved = match case.accepted.weaker.is_empty() {
        true => format!("The plan: {}. {between}", case.accepted.headline),
        false => format!(
            "The plan, less than the spec requires: {}. It leaves open: {}. {between}",
            case.accepted.headline,
            case.accepted.weaker.join("; ")
        ),
    };
    vec![
        ("How likely is a loss of control?", probability),
        ("Is the target met?", target),
        ("Is there a way out after every single fault?", gaps),
        ("Which fault contributes most, and when?", most),
        ("What of common causes?", common),
        ("What of two faults in one mission?", doubles),
        (
            "How soon must a fault be known?",
            format!(
                "Not covered: {detection}, of the spec or else mavc's default, is assumed and no other delay looked \
                 at. An undetected fault is not covered."
            ),
        ),
        (
            "On what do the ways out rest?",
            format!(
                "A search at {} instants, each way out at most {} s long, flown once in simulation with the noise and \
                 gusts of the spec, or mavc's defaults where it is silent: {}.{sample} The column basis of fmea.csv \
                 has it for each row; its column provision names {tables}.",
                e.instants,
                number(e.within),
                case.flights(),
            ),
        ),
        ("What is proved?", proved),
        (
            "What of people on the ground?",
            "Not covered: phases, heights and sites are in fha.csv and fmea.csv, densities of people are not.".into(),
        ),
    ]
}

/// Which fault contributes most where no mode with a rate is uncovered.
fn by_time(case: &Case) -> String {
    if !case.quantities.rated.is_empty() {
        return "No single fault with a rate: each such mode is covered throughout.".into();
    }
    let model = case.problem.model();
    let each = (0..model.modes.len()).flat_map(|mode| {
        let evidence = &case.evidence.modes[mode];
        case.evidence.phases.iter().map(move |phase| (mode, phase, evidence.uncovered_within(phase)))
    });
    let open: Vec<_> = each.filter(|(.., seconds)| *seconds > 0.0).collect();
    let longest = open.iter().max_by(|a, b| a.2.total_cmp(&b.2).then(b.0.cmp(&a.0)));
    match longest {
        Some((mode, phase, seconds)) => format!(
            "By time, because no mode has a rate: {} on the {}, {} s. {} in all.",
            model.modes[*mode].name,
            phase.label(),
            fixed(*seconds, 2),
            plural(open.len(), "single cut set")
        ),
        None => "None: each mode is covered throughout.".into(),
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
            tr { th { "mode" } th { "outcomes, s" } th { "uncovered, s" } th { "proved, s" } }
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
