//! The argument in goal structuring notation: goals, the strategy over modes, solutions that are files with their
//! hashes, and assumptions.
//!
//! Rules of the notation that hold here and are tested: the root is a goal; goals are supported by goals, strategies
//! and solutions, strategies by goals; solutions, contexts and assumptions support nothing further; nothing is in a
//! circle; a goal or strategy without support is marked as undeveloped.

use super::evidence::FAILED;
use super::inputs::SUMS;
use super::quantities::with_interval;
use super::{CERTIFICATE, Case, REPORT, SEVERITIES, sha256, short};
use crate::number::fixed;
use serde_json::{Value, json};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Goal,
    Strategy,
    Solution,
    Context,
    Assumption,
}

impl Kind {
    fn word(self) -> &'static str {
        match self {
            Kind::Goal => "goal",
            Kind::Strategy => "strategy",
            Kind::Solution => "solution",
            Kind::Context => "context",
            Kind::Assumption => "assumption",
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    pub id: String,
    pub kind: Kind,
    pub text: String,
    /// What supports it, by `id`.
    pub supported_by: Vec<String>,
    /// The contexts and assumptions in which it holds, by `id`.
    pub in_context_of: Vec<String>,
    /// Whether its support is missing.
    pub undeveloped: bool,
    /// Of a solution: the file, and its hash.
    pub file: Option<(&'static str, String)>,
}

/// The nodes, the root first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Argument {
    pub nodes: Vec<Node>,
}

impl Argument {
    /// The node with this `id`.
    pub fn node(&self, id: &str) -> Option<&Node> {
        self.nodes.iter().find(|node| node.id == id)
    }

    fn add(&mut self, kind: Kind, text: impl Into<String>) -> usize {
        let prefix = match kind {
            Kind::Goal => "G",
            Kind::Strategy => "S",
            Kind::Solution => "Sn",
            Kind::Context => "C",
            Kind::Assumption => "A",
        };
        let number = 1 + self.nodes.iter().filter(|node| node.kind == kind).count();
        self.nodes.push(Node {
            id: format!("{prefix}{number}"),
            kind,
            text: text.into(),
            supported_by: Vec::new(),
            in_context_of: Vec::new(),
            undeveloped: false,
            file: None,
        });
        self.nodes.len() - 1
    }

    fn support(&mut self, what: usize, by: usize) {
        let id = self.nodes[by].id.clone();
        self.nodes[what].supported_by.push(id);
    }

    fn hold(&mut self, what: usize, within: usize) {
        let id = self.nodes[within].id.clone();
        self.nodes[what].in_context_of.push(id);
    }

    fn solve(&mut self, goal: usize, file: &'static str, hash: &str, what: &str) {
        let solution = self.add(Kind::Solution, format!("{file}{what}"));
        self.nodes[solution].file = Some((file, hash.into()));
        self.support(goal, solution);
    }

    /// The argument for programs.
    pub fn json(&self, case: &Case) -> Value {
        let nodes = self.nodes.iter().map(|node| {
            let mut value = json!({
                "id": node.id,
                "type": node.kind.word(),
                "text": node.text,
                "supported_by": node.supported_by,
                "in_context_of": node.in_context_of,
                "undeveloped": node.undeveloped,
            });
            if let Some((file, hash)) = &node.file {
                value["file"] = json!(file);
                value["sha256"] = json!(hash);
            }
            value
        });
        json!({"spec_sha256": case.spec_sha256, "root": "G1", "nodes": nodes.collect::<Vec<_>>()})
    }
}

/// What a loss of control is.
const LOST: &str = "Loss of control: a mode strikes where it is uncovered, because no way out is known or its \
                    simulated flight failed, or two modes strike in one mission";

/// The argument of a case.
pub fn argument(case: &Case) -> Argument {
    let (model, q) = (case.problem.model(), &case.quantities);
    let mission = &case.problem.mission().name;
    let vehicle = &model.vehicle.name;
    let hashes = [
        sha256(case.inputs.report),
        sha256(case.inputs.certificate),
        sha256(super::fault_tree::open_psa(case).as_bytes()),
    ];
    let [report, certificate, tree] = &hashes;
    let mut argument = Argument::default();
    let target = match (q.target, q.budget()) {
        (Some(target), Some(left)) if left < 0.0 => format!("; the target {} is not met", short(target)),
        (Some(target), Some(_)) => format!("; the target {} is met", short(target)),
        _ => String::new(),
    };
    let unrated = match &case.left_out()[..] {
        [] => String::new(),
        modes => format!(", {} left out for want of a rate", case.names(modes)),
    };
    let root = argument.add(
        Kind::Goal,
        match q.probability {
            Some(p) => format!(
                "The probability that a declared fault strikes {vehicle} on {mission} and control is lost is {} a \
                 mission{unrated}{target}",
                with_interval(p, q.interval)
            ),
            None => {
                let [_, covered] = case.evidence.proved_and_covered();
                let all = case.evidence.duration * model.modes.len() as f64;
                format!(
                    "After the declared faults of {vehicle} on {mission}, {} of {} s x fault count as covered",
                    fixed(covered, 2),
                    fixed(all, 2)
                )
            }
        },
    );
    let spec = argument.add(Kind::Context, format!("The spec, hash {}; index.html says of what", case.spec_sha256));
    argument.hold(root, spec);
    let lost = argument.add(Kind::Context, LOST);
    argument.hold(root, lost);
    for text in case.assumptions() {
        let assumed = argument.add(Kind::Assumption, text);
        argument.hold(root, assumed);
    }
    let strategy = argument.add(Kind::Strategy, "Over the plan, each declared mode, and two modes in one mission");
    argument.support(root, strategy);
    let plan = argument.add(Kind::Goal, "The motion from which ways out begin is a plan of the spec");
    argument.support(strategy, plan);
    argument.solve(plan, CERTIFICATE, certificate, &format!(": {}", case.accepted.headline));
    for why in &case.accepted.weaker {
        let open = argument.add(Kind::Assumption, format!("The certificate leaves open: {why}"));
        argument.hold(plan, open);
    }
    for mode in 0..model.modes.len() {
        let goal = argument.add(Kind::Goal, of_mode(case, mode));
        argument.support(strategy, goal);
        let name = &model.modes[mode].name;
        let evidence = &case.evidence.modes[mode];
        let [proved, covered] = [evidence.proved(), evidence.covered()];
        if proved > 0.0 {
            let what = format!(": ways out after {name}, proved at every instant of {} s", fixed(proved, 2));
            argument.solve(goal, CERTIFICATE, certificate, &what);
        }
        let what = match () {
            () if case.not_sought[mode].is_some() => format!(": no way out sought after {name}"),
            () if covered == 0.0 => format!(": no way out after {name}"),
            () if proved < covered => {
                let seconds = fixed(covered - proved, 2);
                format!(": ways out after {name}, at instants within {seconds} s, each flown once in simulation")
            }
            () => format!(": outcomes of {name}"),
        };
        argument.solve(goal, REPORT, report, &what);
        if let Some(tables) = case.inputs.tables_sha256().filter(|_| covered > 0.0) {
            argument.solve(goal, SUMS, &tables, &format!(": the tables of the ways out after {name}"));
        }
        if evidence.uncovered() > 0.0 && model.modes[mode].rate.is_none() {
            let unknown =
                argument.add(Kind::Goal, format!("The rate of {name} is established (undeveloped: the spec has none)"));
            argument.support(goal, unknown);
            argument.nodes[unknown].undeveloped = true;
        }
        if q.rated.iter().any(|one| one.mode == mode && !one.exposed.is_empty()) {
            argument.solve(goal, "faulttree.xml", tree, &format!(", gate {name}-uncovered"));
        }
    }
    let pairs = argument.add(Kind::Goal, of_pairs(case));
    argument.support(strategy, pairs);
    match q.doubles().next() {
        Some(_) => argument.solve(pairs, "faulttree.xml", tree, ", gates of two modes"),
        None => argument.nodes[pairs].undeveloped = true,
    }
    argument
}

/// The goal of two modes in one mission.
fn of_pairs(case: &Case) -> String {
    let q = &case.quantities;
    match (q.doubles().next(), q.two_strikes(|spread| spread.high)) {
        (Some(_), Some(all)) => format!(
            "Two modes strike in one mission, both where they are covered, with a probability of at most {}{} (strikes \
             of two modes, covered or not: {})",
            short(q.both_covered(|spread| spread.high)),
            q.at_highest(),
            short(all),
        ),
        (None, Some(_)) => {
            "Where two modes strike in one mission, one of them is uncovered: its own goal counts it".into()
        }
        (_, None) => {
            "The probability of two modes in one mission is unknown, because fewer than two have a rate".into()
        }
    }
}

/// The goal of a mode.
fn of_mode(case: &Case, mode: usize) -> String {
    let (name, evidence) = (&case.problem.model().modes[mode].name, &case.evidence.modes[mode]);
    if evidence.pieces.iter().all(|piece| piece.outcome < FAILED) {
        let mut found: Vec<usize> = evidence.pieces.iter().map(|piece| piece.outcome).collect();
        found.sort_unstable();
        found.dedup();
        let words: Vec<&str> = found.into_iter().map(|outcome| SEVERITIES[outcome].0).collect();
        let when = match evidence.proved() < evidence.covered() {
            true => "at every instant looked at",
            false => "at every instant",
        };
        return format!("{name} has a way out {when}: {}", words.join(", "));
    }
    let [open, failed, all] =
        [evidence.uncovered(), evidence.with_outcome(FAILED), case.evidence.duration].map(|s| fixed(s, 2));
    let why = match &case.not_sought[mode] {
        Some(_) => String::new(),
        None if evidence.with_outcome(FAILED) > 0.0 => format!("; {failed} s of it because simulated flights failed"),
        None => String::new(),
    };
    match case.quantities.uncovered_of(mode) {
        Some([high, middle]) => {
            let middle = match high > middle {
                true => format!(", {} in the middle of the interval of its rate", short(middle)),
                false => String::new(),
            };
            match &case.not_sought[mode] {
                Some(why) => {
                    format!("{name} strikes with a probability of at most {} a mission{middle}; {why}", short(high))
                }
                None => format!(
                    "{name} strikes where it is uncovered with a probability of at most {} a mission{middle}, if every \
                     way out holds ({open} of {all} s{why})",
                    short(high)
                ),
            }
        }
        None => match &case.not_sought[mode] {
            Some(why) => format!("{name} is uncovered throughout; {why}"),
            None => format!("{name} is uncovered for {open} of {all} s{why}"),
        },
    }
}
