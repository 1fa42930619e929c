//! The fault tree in the Open-PSA model exchange format.

use super::quantities::{Rated, hours, written};
use super::{Case, REPORT, escaped, sha256};
use crate::model::RotorState;
use std::fmt::Write;

/// The tree: control is lost if one mode strikes where it is uncovered, without a way out or with one whose simulated
/// flight failed, or if two modes strike. The rate of a mode is a parameter; one that is known to an interval is a
/// uniform deviate, whose mean is the rate.
///
/// Names of modes are letters, digits and `_`, so that a `-` separates the parts of a name.
pub fn open_psa(case: &Case) -> String {
    let mut tree = Tree { case, gates: String::new(), top: Vec::new(), data: String::new() };
    match case.quantities.rated.is_empty() {
        true => tree.without_rates(),
        false => tree.with_rates(),
    }
    tree.text()
}

struct Tree<'c, 'a> {
    case: &'c Case<'a>,
    gates: String,
    /// The gates below the top one.
    top: Vec<String>,
    data: String,
}

impl Tree<'_, '_> {
    fn name(&self, mode: usize) -> &str {
        &self.case.problem.model().modes[mode].name
    }

    /// A gate over events, or nothing if there are none.
    fn gate(&mut self, name: &str, label: &str, kind: &str, of: &[String]) {
        if of.is_empty() {
            return;
        }
        let _ = writeln!(self.gates, "    <define-gate name=\"{name}\">\n      <label>{}</label>", escaped(label));
        // A gate of one event takes no connective.
        let (open, close) = match of.len() {
            1 => (String::new(), String::new()),
            _ => (format!("      <{kind}>\n"), format!("      </{kind}>\n")),
        };
        self.gates += &open;
        for event in of {
            let _ = writeln!(self.gates, "        {event}");
        }
        self.gates += &close;
        self.gates += "    </define-gate>\n";
    }

    fn with_rates(&mut self) {
        let q = &self.case.quantities;
        for one in &q.rated {
            let name = self.name(one.mode).to_string();
            self.rate(&name, one);
            let mut open = Vec::new();
            for (phase, seconds) in &one.exposed {
                let event = format!("{name}-uncovered-{}", phase.tag());
                self.parameter(&format!("time-{event}"), "hours", hours(*seconds));
                self.event(&event, &format!("{name} strikes uncovered, {}", phase.label()), &name);
                open.push(basic(&event));
            }
            let gate = format!("{name}-uncovered");
            self.gate(&gate, &format!("{name} strikes where it is uncovered"), "or", &open);
            if !open.is_empty() {
                self.top.push(format!("<gate name=\"{gate}\"/>"));
            }
            if one.covered_h(q.duration) > 0.0 {
                let event = format!("{name}-covered");
                self.parameter(&format!("time-{event}"), "hours", one.covered_h(q.duration));
                self.event(&event, &format!("{name} strikes where it is covered"), &name);
            }
        }
        let doubles: Vec<[usize; 2]> = q.doubles().map(|(pair, _)| pair).collect();
        self.pairs(&doubles);
        for mode in self.case.left_out() {
            let name = self.name(mode).to_string();
            let _ = writeln!(
                self.data,
                "    <define-house-event name=\"{name}\">\n      <label>{name} has no rate in the spec: left out of \
                 the tree</label>\n      <constant value=\"false\"/>\n    </define-house-event>"
            );
        }
    }

    /// Without rates only cut sets can be found: a mode that is uncovered somewhere, and all pairs.
    fn without_rates(&mut self) {
        let modes = 0..self.case.problem.model().modes.len();
        for mode in modes {
            let name = self.name(mode).to_string();
            let evidence = &self.case.evidence.modes[mode];
            let open: Vec<_> =
                self.case.evidence.phases.iter().filter(|phase| evidence.uncovered_within(phase) > 0.0).collect();
            let mut events = Vec::new();
            for phase in open {
                let event = format!("{name}-uncovered-{}", phase.tag());
                let label = format!("{name} strikes uncovered, {}", phase.label());
                self.event_without_rate(&event, &label);
                events.push(basic(&event));
            }
            let gate = format!("{name}-uncovered");
            self.gate(&gate, &format!("{name} strikes where it is uncovered"), "or", &events);
            if !events.is_empty() {
                self.top.push(format!("<gate name=\"{gate}\"/>"));
            }
            if evidence.uncovered() < self.case.evidence.duration {
                self.event_without_rate(&format!("{name}-covered"), &format!("{name} strikes where it is covered"));
            }
        }
        let doubles = self.case.pairs_with_ways_out();
        self.pairs(&doubles);
    }

    fn pairs(&mut self, pairs: &[[usize; 2]]) {
        for pair in pairs {
            let [a, b] = pair.map(|mode| self.name(mode).to_string());
            let gate = format!("{a}-and-{b}");
            let joint = self.case.pairs.iter().find(|(other, _)| other == pair).and_then(|(_, outcome)| *outcome);
            let with_both = match joint {
                Some(outcome) => format!("in hover with both: {}", outcome.word()),
                None => "hover with both: not looked at".into(),
            };
            let label = format!("{a} and {b} in one mission; {with_both}; no way out is sought");
            self.gate(&gate, &label, "and", &[basic(&format!("{a}-covered")), basic(&format!("{b}-covered"))]);
            self.top.push(format!("<gate name=\"{gate}\"/>"));
        }
    }

    fn rate(&mut self, mode: &str, of: &Rated) {
        if of.spread.is_none() {
            return self.parameter(&format!("rate-{mode}"), "hours-1", of.rate_per_h);
        }
        let [low, high] = of.interval();
        let _ = writeln!(
            self.data,
            "    <define-parameter name=\"rate-{mode}\" unit=\"hours-1\">\n      <uniform-deviate>\n        <float \
             value=\"{}\"/>\n        <float value=\"{}\"/>\n      </uniform-deviate>\n    </define-parameter>",
            written(low),
            written(high)
        );
    }

    fn parameter(&mut self, name: &str, unit: &str, value: f64) {
        let _ = writeln!(
            self.data,
            "    <define-parameter name=\"{name}\" unit=\"{unit}\">\n      <float value=\"{}\"/>\n    \
             </define-parameter>",
            written(value)
        );
    }

    /// An event with the rate of a mode, and the time of its own parameter.
    fn event(&mut self, name: &str, label: &str, mode: &str) {
        let _ = writeln!(
            self.data,
            "    <define-basic-event name=\"{name}\">\n      <label>{}</label>\n      <exponential>\n        \
             <parameter name=\"rate-{mode}\"/>\n        <parameter name=\"time-{name}\"/>\n      </exponential>\n    \
             </define-basic-event>",
            escaped(label)
        );
    }

    fn event_without_rate(&mut self, name: &str, label: &str) {
        let _ = writeln!(
            self.data,
            "    <define-basic-event name=\"{name}\">\n      <label>{}</label>\n    </define-basic-event>",
            escaped(label)
        );
    }

    fn text(mut self) -> String {
        let (gates, top) = (std::mem::take(&mut self.gates), std::mem::take(&mut self.top));
        let mission = &self.case.problem.mission().name;
        match top.is_empty() {
            // A tree without a way to fail has a top that never occurs.
            true => {
                self.gate("loss-of-control", NOTHING, "or", &["<constant value=\"false\"/>".into()]);
            }
            false => self.gate("loss-of-control", &format!("loss of control on the mission {mission}"), "or", &top),
        }
        let top = std::mem::take(&mut self.gates);
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<opsa-mef>\n  <label>{}</label>\n  <attributes>\n{}  \
             </attributes>\n  <define-fault-tree name=\"{mission}\">\n{top}{gates}  </define-fault-tree>\n  \
             <model-data>\n{}  </model-data>\n</opsa-mef>\n",
            escaped(&self.label()),
            self.attributes(),
            self.data
        )
    }

    fn label(&self) -> String {
        let common = self
            .case
            .problem
            .model()
            .modes
            .iter()
            .filter(|mode| mode.rotors.iter().filter(|state| **state != RotorState::Sound).count() > 1);
        let common: Vec<&str> = common.map(|mode| mode.name.as_str()).collect();
        let of_several = match common.is_empty() {
            true => "no mode of the spec is a common cause of several rotors".to_string(),
            false => format!("common causes of several rotors: {}", common.join(", ")),
        };
        let left_out = self.case.of_left_out().map_or(String::new(), |text| format!(" {text}."));
        format!(
            "Loss of control after a fault. {} The spec: {of_several}.{left_out}",
            self.case.assumptions()[..6].join(" ")
        )
    }

    fn attributes(&self) -> String {
        let one = |name: &str, value: &str| format!("    <attribute name=\"{name}\" value=\"{value}\"/>\n");
        one("spec_sha256", self.case.spec_sha256)
            + &one(&format!("{}_sha256", REPORT.trim_end_matches(".json")), &sha256(self.case.inputs.report))
            + &one("certificate_sha256", &sha256(self.case.inputs.certificate))
            + &one("mission_s", &written(self.case.evidence.duration))
    }
}

/// The label of a tree without a way to fail.
const NOTHING: &str = "no mode strikes where it is uncovered, and no two modes with rates can strike";

fn basic(name: &str) -> String {
    format!("<basic-event name=\"{name}\"/>")
}
