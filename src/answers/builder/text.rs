//! The text of a built spec, from the lines of the calls.

use super::Builder;
use super::value::word;
use crate::format;

/// A statement, with the call of the builder that it comes from.
#[derive(Debug, Clone)]
pub(super) struct Line {
    pub path: String,
    pub text: String,
    /// The call has a [`super::BuildProblem`] already; what the compiler finds in its line is not reported again.
    pub is_reported: bool,
}

impl Line {
    pub fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Line { path: path.into(), text: text.into(), is_reported: false }
    }
}

/// A block with a name.
#[derive(Debug, Clone)]
pub(super) struct Named {
    /// What calls are named by.
    pub path: String,
    pub keyword: &'static str,
    pub name: String,
    pub fields: Vec<Line>,
}

#[derive(Debug, Clone)]
pub(super) struct Mode {
    pub name: String,
    pub effects: Vec<Line>,
    pub fields: Vec<Line>,
}

impl Builder {
    /// The formatted text of the spec so far. Where a call has a problem, another word or number that is wrong too
    /// replaces the value.
    pub fn text(&self) -> String {
        let text: String = self.lines().into_iter().map(|line| line.text + "\n").collect();
        // Formatting keeps lines, so each line still belongs to the same call.
        format(&text).unwrap_or(text)
    }

    /// The text, each line with the call that it comes from.
    pub(super) fn lines(&self) -> Vec<Line> {
        let mut lines = self.top.clone();
        let mut block = |path: &str, head: &str, body: Vec<Line>| {
            let line = |text: String| Line::new(path, text);
            lines.push(line(format!("{head} {{")));
            lines.extend(body.into_iter().map(|inner| Line { text: format!("    {}", inner.text), ..inner }));
            lines.push(line("}".into()));
        };
        let nested = |path: &str, head: &str, body: &[Line]| -> Vec<Line> {
            let line = |text: String| Line::new(path, text);
            let inner = body.iter().map(|inner| Line { text: format!("    {}", inner.text), ..inner.clone() });
            [line(format!("{head} {{"))].into_iter().chain(inner).chain([line("}".into())]).collect()
        };
        let mut vehicle = self.vehicle.clone();
        let part =
            |Named { path, keyword, name, fields }: &Named| nested(path, &format!("{keyword} {}", word(name)), fields);
        let parts: Vec<Line> = self.parts.iter().cloned().chain(self.part.iter().flat_map(part)).collect();
        for (path, head, body) in [
            ("vehicle.rotor", "rotor", &self.rotor),
            ("vehicle.rotors", "rotors", &self.placed),
            ("vehicle.battery", "battery", &self.battery),
            ("vehicle.parts", "parts", &parts),
        ] {
            if !body.is_empty() {
                vehicle.extend(nested(path, head, body));
            }
        }
        block("vehicle", "vehicle craft", vehicle);
        if !self.modes.is_empty() {
            let of_mode = |mode: &Mode| {
                let body: Vec<Line> = mode.effects.iter().chain(&mode.fields).cloned().collect();
                nested(&format!("modes.{}", mode.name), &format!("mode {}", word(&mode.name)), &body)
            };
            block("modes", "faults", self.modes.iter().flat_map(of_mode).collect());
        }
        let mut mission = self.mission.clone();
        for Named { path, keyword, name, fields } in self.volumes.iter().chain(&self.places) {
            mission.extend(nested(path, &format!("{keyword} {}", word(name)), fields));
        }
        for (path, head, body) in [
            ("mission.limits", "limits", &self.limits),
            ("mission.after_fault_limits", "after_fault_limits", &self.after_fault_limits),
        ] {
            if !body.is_empty() {
                mission.extend(nested(path, head, body));
            }
        }
        let mut plan = self.plan.clone();
        if !self.recovery.is_empty() {
            plan.extend(nested("plan.recovery", "recovery", &self.recovery));
        }
        if !(mission.is_empty() && plan.is_empty()) {
            block("mission", "mission flight", mission);
        }
        for (name, body) in [("plan", plan), ("simulate", self.simulate.clone()), ("campaign", self.campaign.clone())] {
            if !body.is_empty() {
                block(name, name, body);
            }
        }
        lines
    }
}
