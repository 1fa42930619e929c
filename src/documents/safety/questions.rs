//! The ten questions of an assessor, and the answers that the folder gives.

use super::evidence::{FAILED, ModeEvidence, Phase};
use super::quantities::{by_importance, with_interval};
use super::{Case, TARGET, short};
use crate::admissible::outcome::Outcome;
use crate::model::{FaultMode, RecoverySettings};
use crate::number::{fixed, number, plural, significant};

/// Ten questions, and the answers that the folder gives.
pub fn questions(case: &Case) -> Vec<(&'static str, String)> {
    let (q, e) = (&case.quantities, &case.evidence);
    let model = case.problem.model();
    let share = e.largest_share_of_failures();
    let probability = match (q.probability, q.per_flight_hour()) {
        (Some(p), Some(hourly)) => {
            let without = case.of_left_out().map_or(String::new(), |text| format!(" {text}."));
            let failed = q.without_failures.map_or(String::new(), |p| {
                format!(" If ways out whose simulated flight failed covered their time: {} a mission.", short(p))
            });
            let at_bound = match (e.flown, q.if_covered_fail(share)) {
                (0, _) | (_, None) => String::new(),
                (_, Some(p)) => format!(
                    " If {} % of strikes where a mode is covered lost control too, the bound of the simulated flights \
                     at 95 % confidence: {} a mission.",
                    significant(100.0 * share, 2),
                    short(p)
                ),
            };
            format!(
                "{} for each mission of {} s; {} for each flight hour if such missions follow each \
                 other.{failed}{at_bound}{without}",
                with_interval(p, q.interval),
                significant(e.duration, 4),
                short(hourly)
            )
        }
        _ => "Not covered: no mode of the spec has a rate.".into(),
    };
    let target = match (q.target, q.budget()) {
        (Some(target), Some(left)) if left >= 0.0 => {
            let (target, left, highest) = (short(target), short(left), q.at_highest());
            format!("Yes: the spec allows {target}, and {left} of it is left{highest}. {TARGET}.")
        }
        (Some(target), Some(left)) => {
            let (target, over, highest) = (short(target), short(-left), q.at_highest());
            format!("No: the spec allows {target}, exceeded by {over}{highest}. {TARGET}.")
        }
        (Some(_), None) => "Not covered: no mode has a rate.".into(),
        (None, _) => "Not covered: the spec states none (require risk).".into(),
    };
    let open: Vec<String> = (0..model.modes.len())
        .filter(|&mode| e.modes[mode].uncovered() > 0.0)
        .map(|mode| {
            let name = &model.modes[mode].name;
            if let Some(why) = &case.not_sought[mode] {
                return format!("{name} throughout, {why}");
            }
            let [open, failed] = [e.modes[mode].uncovered(), e.modes[mode].with_outcome(FAILED)];
            let failed = match failed > 0.0 {
                true => format!(" ({} s of it because simulated flights failed)", fixed(failed, 2)),
                false => String::new(),
            };
            format!("{name} for {} s{failed}", fixed(open, 2))
        })
        .collect();
    let gaps = match open.is_empty() {
        true => "At every instant that was looked at, yes.".into(),
        false => format!(
            "No. Counted as lost: {}. fmea.csv has the times. Where none was found, the search found no motion of at \
             most {} s within the limits that hold after a fault; that none exists is not shown, and a flight that \
             leaves a limit may survive.",
            open.join(", "),
            number(e.within)
        ),
    };
    let several = model.modes.iter().filter(|mode| mode.capacities().iter().filter(|c| **c < 1.0).count() > 1);
    let rate = |mode: &FaultMode| if mode.rate.is_some() { "with a rate" } else { "without a rate" };
    let several: Vec<String> = several.map(|mode| format!("{} ({})", mode.name, rate(mode))).collect();
    let common = match several.is_empty() {
        true => "Not covered: no mode of the spec affects several rotors by their capacity.".into(),
        false => format!("As modes that the spec declares: {}.", several.join(", ")),
    };
    let most = match q.rated.is_empty() {
        true => by_time(case),
        false => by_probability(case),
    };
    let hovering = |pair: &&([usize; 2], Option<Outcome>)| pair.1 == Some(Outcome::FullControl);
    let count = model.modes.len();
    let omitted = match count * count.saturating_sub(1) / 2 - case.pairs.len() {
        0 => String::new(),
        one @ 1 => format!(" {one} more pair has a mode without a rate, and is not counted."),
        more => format!(" {more} more pairs have a mode without a rate, and are not counted."),
    };
    let rated = if q.rated.is_empty() { "" } else { " of modes with rates" };
    let likely = q.two_strikes(|_| 1.0).map_or(String::new(), |all| {
        let both = q.both_covered(|_| 1.0);
        format!(
            " Two modes strike in one mission with the probability {}; both where they are covered with at most {}.",
            short(all),
            short(both)
        )
    });
    let doubles = match case.pairs.is_empty() {
        true => format!("Not covered: there are no two modes{}.", if rated.is_empty() { "" } else { " with a rate" }),
        false => format!(
            "Each pair counts as a loss of control; no way out is sought. {} of {}{rated} would leave full control in \
             hover.{omitted}{likely}",
            case.pairs.iter().filter(hovering).count(),
            plural(case.pairs.len(), "pair"),
        ),
    };
    let source = match model.plan.recovery.detection == RecoverySettings::default().detection {
        true => "mavc's default, unless the spec states it",
        false => "of the spec",
    };
    let detection = match e.detection[..] {
        [least, most] => format!(
            "A way out was sought after {} and after {} ms, {source}, and not between them; the tables and the \
             simulated flights are those of the longer delay",
            number(1e3 * least),
            number(1e3 * most)
        ),
        _ => format!("{} ms, {source}, is assumed", number(1e3 * e.detection[0])),
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
        _ => format!(
            " With 95 % confidence, at most {} % of such flights fail, as far as they are independent and alike.",
            significant(100.0 * share, 2)
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
    let against = match model.plan.against.is_empty() {
        true => String::new(),
        false => format!(
            " Facets are those of the sets that {} leave (against in the spec): inside them the remaining rotors can \
             still give what the plan needs. Before a fault is known, the vehicle leaves the plan, so that a way out \
             may be missing all the same.",
            case.names(&model.plan.against)
        ),
    };
    let proved = match case.accepted.weaker.is_empty() {
        true => format!("The plan: {}.{against} {between}", case.accepted.headline),
        false => format!(
            "The plan, less than the spec requires: {}. It leaves open: {}.{against} {between}",
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
            format!("{detection}. Not covered: what any other delay would change. An undetected fault is not covered."),
        ),
        (
            "On what do the ways out rest?",
            format!(
                "A search at {} instants, each way out at most {} s long, flown once in simulation with gusts \
                 of {} m/s, the other noise of the spec, or mavc's defaults where it is silent, and with seeds from {} \
                 on: {}.{sample} The column basis of fmea.csv has it for each row; its column provision \
                 names {tables}.",
                e.instants,
                number(e.within),
                number(model.simulation.gusts),
                model.simulation.seed,
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

/// Which fault contributes most to the probability: the mode, then the mode and the phase.
fn by_probability(case: &Case) -> String {
    let (q, model) = (&case.quantities, case.problem.model());
    let singles = q.by_contribution();
    let Some((mode, single)) = singles.first() else {
        return "No single fault with a rate: each such mode is covered throughout.".into();
    };
    let ranked = by_importance(q);
    let (at, saved) = ranked[0];
    format!(
        "Of the modes with a rate: {}, without which the probability is {} less{}. By phase: {} on the {}, {} s, {}{}.",
        model.modes[q.rated[at].mode].name,
        short(saved),
        and_alike(ranked.iter().map(|(_, saved)| *saved)),
        model.modes[*mode].name,
        single.phase.label(),
        fixed(single.seconds, 2),
        short(single.probability),
        and_alike(singles.iter().map(|(_, single)| single.probability)),
    )
}

/// Which fault is uncovered for longest where no mode has a rate: the mode, then the mode and the phase.
fn by_time(case: &Case) -> String {
    let model = case.problem.model();
    let mut modes: Vec<(usize, f64)> =
        case.evidence.modes.iter().map(ModeEvidence::uncovered).enumerate().filter(|(_, open)| *open > 0.0).collect();
    let of_mode = |mode: usize| {
        let evidence = &case.evidence.modes[mode];
        case.evidence.phases.iter().map(move |phase| (mode, phase, evidence.uncovered_within(phase)))
    };
    let mut phases: Vec<(usize, &Phase, f64)> =
        modes.iter().flat_map(|(mode, _)| of_mode(*mode)).filter(|(.., open)| *open > 0.0).collect();
    modes.sort_by(|a, b| b.1.total_cmp(&a.1));
    phases.sort_by(|a, b| b.2.total_cmp(&a.2));
    let ([(longest, of_all), ..], [(mode, phase, seconds), ..]) = (&modes[..], &phases[..]) else {
        return "None: each mode is covered throughout.".into();
    };
    format!(
        "By time, because no mode has a rate: {}, uncovered for {} of {} s{}. By phase: {} on the {}, {} s{}. {} in \
         all.",
        model.modes[*longest].name,
        fixed(*of_all, 2),
        fixed(case.evidence.duration, 2),
        and_alike(modes.iter().map(|(_, open)| *open)),
        model.modes[*mode].name,
        phase.label(),
        fixed(*seconds, 2),
        and_alike(phases.iter().map(|(.., open)| *open)),
        plural(phases.len(), "single cut set")
    )
}

/// By how much numbers may differ that are alike to a reader: a share of the larger one.
const ALIKE: f64 = 1e-6;

/// `, and 3 more alike`: how many of these numbers, in descending order, equal the first one.
fn and_alike(numbers: impl Iterator<Item = f64> + Clone) -> String {
    let first = numbers.clone().next().unwrap_or(f64::NAN);
    match numbers.skip(1).take_while(|other| first - other <= ALIKE * first).count() {
        0 => String::new(),
        more => format!(", and {more} more alike"),
    }
}
