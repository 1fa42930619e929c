//! The `name = value` statements of a block: known names, no repetition, nothing due left out.

use super::context::{Context, listed, no_filter};
use super::mend;
use super::overrides::is_override;
use crate::diagnostic::{Diagnostic, nearest, nearest_by_words};
use crate::language::{Entry, Group};
use crate::source::Span;
use crate::syntax::Place;
use crate::syntax::ast::{Clauses, Expr, ExprKind, Field, FieldValue, Name, Statement};

/// Units that show a number to be a time.
const TIMES: [&str; 4] = ["s", "ms", "min", "h"];

/// Words that people use for something that is not a field, or a field whose place its table does not tell.
const ELSEWHERE: &[(&str, &str)] = &[
    ("gravity", "stands at the top level, outside all blocks"),
    ("allow", "stands at the top level, outside all blocks"),
    ("points", "follows the range of a `curve`, after a comma"),
    ("fault", "is a statement of `simulate`, written `fault M1 at 5 s`"),
    ("rpn", "is the product of `severity`, `occurrence` and `detection`: write those"),
    ("probability", "is written as a failure rate, such as `rate = 1e-5 1/h`"),
    ("speed", "is a limit, written `speed <= 8 m/s` in `limits`"),
    ("tilt", "is a limit, written `tilt <= 35 deg` in `limits`"),
    ("heading", "is written `yaw`, counter-clockwise from east: a compass heading h is `yaw = 90 deg - h`"),
    ("altitude", "is a limit, written `altitude in 1 m .. 30 m` in `limits`"),
    ("name", "is written after the block's keyword, as in `vehicle octo`"),
    ("start", "is a statement of a `mission`, written `start at [0, 0, 2] m`"),
    ("waypoint", "is a statement of a `mission`, written `waypoint at [10, 0, 5] m`"),
    ("waypoints", "is a statement of a `mission`, written `waypoint at [10, 0, 5] m` for each of them"),
    ("goal", "is the last waypoint of a `mission`, written `waypoint goal at [10, 0, 5] m`"),
    ("hold", "is a statement of a `mission`, written `hold 3 s`"),
];

/// Whose fields these are, as one says it.
const OWNERS: [(Group, &str); 8] = [
    (Group::Plan, "of `plan`"),
    (Group::Vehicle, "of `vehicle`"),
    (Group::Rotor, "of `rotor` in a `vehicle`"),
    (Group::Curve, "of a `curve`"),
    (Group::Waypoint, "of a `waypoint`"),
    (Group::Mode, "of a fault mode, between the braces of `mode` or `every`,"),
    (Group::Simulate, "of `simulate`"),
    (Group::Campaign, "of `campaign`"),
];

/// Where a field that people write in the wrong place belongs.
pub(super) fn elsewhere(word: &str) -> Option<String> {
    if let Some((_, place)) = ELSEWHERE.iter().find(|(field, _)| *field == word) {
        return Some(format!("`{word}` {place}"));
    }
    let owners: Vec<&str> = OWNERS.iter().filter(|(group, _)| group.has(word)).map(|(_, owner)| *owner).collect();
    let owners = match owners.as_slice() {
        [] => return None,
        [one] => one.trim_end_matches(',').to_string(),
        [first @ .., last] => format!("{} and {last}", first.join(", ").replace(",,", ",")),
    };
    Some(format!("`{word}` is a field {owners}"))
}

/// The fields or clauses of one block or statement, by name.
pub(super) struct Fields<'a> {
    /// As one says it: "vehicle `octo`".
    pub owner: String,
    /// Where a missing field is reported.
    pub span: Span,
    found: Vec<(&'a Name, &'a Expr, Span)>,
    /// Known names that stand here in some unreadable or misspelled form, so that they are not missing.
    accounted: Vec<&'static str>,
    /// The block holds statements that could not be read: nothing is surely missing.
    broken: bool,
    /// Where a missing field would go.
    room: Room,
}

/// Where a field that is missing goes.
enum Room {
    /// Below the last statement of a block, or behind the brace of an empty one.
    Block(Option<Span>),
    /// At the end of a statement made of clauses, or of a head.
    End(Span),
}

impl<'a> Fields<'a> {
    /// The fields among the statements of a block.
    pub fn of_block(cx: &mut Context<'a>, owner: String, span: Span, body: &'a [Statement], known: Group) -> Self {
        let room = Room::Block(body.last().map(Statement::span));
        let mut fields = Fields { owner, span, found: Vec::new(), accounted: Vec::new(), broken: false, room };
        for statement in body {
            if let Statement::Broken(span) = statement {
                // What plainly is one field is no other.
                match meant_field(cx.sources.snippet(*span), known) {
                    Some(field) => fields.accounted.push(field),
                    None => fields.broken = true,
                }
            }
        }
        for statement in body {
            if let Statement::Field(field) = statement {
                fields.take_field(cx, field, known);
            }
        }
        fields
    }

    /// The options behind a curve's range and the fields of its body are read by the same rules.
    pub fn take_field(&mut self, cx: &mut Context<'a>, field: &'a Field, known: Group) {
        match &field.value {
            FieldValue::Expr(expr) => self.take(cx, &field.name, expr, field.span, known),
            FieldValue::Where { .. } => {
                cx.report(no_filter(field.span));
                self.accounted.extend(known.names().find(|k| *k == field.name.value));
            }
        }
    }

    /// The `word value` clauses of a statement.
    pub fn of_clauses(cx: &mut Context<'a>, owner: String, statement: &'a Clauses, known: Group) -> Self {
        let (span, room) = (statement.span, Room::End(statement.span));
        let mut fields = Fields { owner, span, found: Vec::new(), accounted: Vec::new(), broken: false, room };
        for clause in &statement.clauses {
            fields.take(cx, &clause.word, &clause.value, clause.value.span, known);
        }
        fields
    }

    fn take(&mut self, cx: &mut Context<'a>, name: &'a Name, value: &'a Expr, span: Span, known: Group) {
        if !known.has(&name.value) {
            self.unknown(cx, name, known);
        } else if let Some((first, ..)) = self.found.iter().find(|(n, ..)| n.value == name.value) {
            // Between `at` a place and `at` a time a reader sees no mistake.
            let is_time =
                matches!(&value.kind, ExprKind::Number { unit: Some(unit), .. } if TIMES.contains(&unit.value.trim()));
            if name.value == "at" && is_time && known.has("time") {
                let message = format!("{} takes a place after `at`, not a time", self.owner);
                let error = Diagnostic::error("mavc::name::duplicate", name.span, message).here("`at` for a time");
                cx.report(error.help("write `time` for when it is reached").fix(name.span, "time"));
                return;
            }
            let message = format!("`{}` is given twice in {}", name.value, self.owner);
            let again = mend::removal(cx.sources.get(span.file), name.span.to(span));
            cx.report(
                Diagnostic::error("mavc::name::duplicate", name.span, message)
                    .here("given again")
                    .also(first.span, "first given here")
                    .help("take one out")
                    .fix(again, ""),
            );
        } else {
            self.found.push((name, value, span));
        }
    }

    fn unknown(&mut self, cx: &mut Context<'a>, name: &Name, known: Group) {
        let word = name.value.as_str();
        let message = format!("{} has no field `{word}`", self.owner);
        let mut error = Diagnostic::error("mavc::name::unknown_field", name.span, message).here("unknown here");
        let near = nearest(word, known.names()).or_else(|| nearest_by_words(word, known.names()));
        // `drag` among the fields of a rotor is `drag_coefficient`, `times` in a plan is `time`.
        let begins = |k: &&str| k.strip_prefix(word).is_some_and(|rest| rest.starts_with('_'));
        let begun = known.names().find(|k| Group::Simulate.has(word) && begins(k));
        let plural = |a: &str, b: &str| a.strip_suffix('s') == Some(b);
        let near = near.filter(|near| plural(near, word) || plural(word, near)).or(begun).or(near);
        let surer = near.is_some_and(|near| plural(near, word) || plural(word, near) || begun == Some(near));
        if matches!(word, "at" | "position") && known.has("x") {
            error = error.help("write its coordinates one by one: `x = ..`, `y = ..` and `z = ..`");
            self.accounted.extend(["x", "y", "z"]);
        } else if let Some(place) = elsewhere(word).filter(|_| !surer) {
            error = error.help(place);
        } else if let Some(near) = near.filter(|_| is_override(cx.sources, name.span)) {
            // What the spec says of the field is what an override is to replace.
            let written = &cx.sources.get(name.span.file).text;
            let (before, after) = (&written[..name.span.start as usize], &written[name.span.end as usize..]);
            error = error.here(format!("did you mean `{near}`?")).help(format!("write `--set {before}{near}{after}`"));
        } else if let Some((first, ..)) = near.and_then(|near| self.found.iter().find(|(n, ..)| n.value == near)) {
            let message = format!("`{}` is given already", first.value);
            error = error.also(first.span, message).help("take one out");
        } else if let Some(near) = near {
            error = error.help(format!("did you mean `{near}`?")).fix(name.span, near);
        } else if known == Group::Nothing {
            let place = if self.owner.starts_with("mission") { Place::Mission } else { Place::Faults };
            error = error.help(format!("take it out: only {} stand here", listed(place.openers())));
        } else {
            error = error.help(format!("its fields are {}", listed(&known.names().collect::<Vec<_>>())));
        }
        if word == "heading" {
            self.accounted.push("yaw");
        }
        self.accounted.extend(known.names().find(|k| Some(*k) == near));
        cx.report(error);
    }

    pub fn get(&self, name: &str) -> Option<&'a Expr> {
        self.found.iter().find(|(n, ..)| n.value == name).map(|(_, expr, _)| *expr)
    }

    /// The word of a field that takes one of a few; `Some(None)` where something else is written.
    pub fn word(&self, cx: &mut Context<'a>, code: &'static str, entry: &'static Entry) -> Option<Option<&'a str>> {
        let (field, words) = (entry.name, entry.words());
        let expr = self.get(field)?;
        if let ExprKind::Name(name) = &expr.kind
            && words.contains(&name.as_str())
        {
            return Some(Some(name));
        }
        let error = Diagnostic::error(code, expr.span, format!("`{field}` is one of {}", listed(words)));
        let error = error.here("none of them");
        let near = match &expr.kind {
            ExprKind::Name(name) => nearest(name, words.iter().copied()),
            _ => None,
        };
        let quoted = match &expr.kind {
            ExprKind::Text(text) => words.iter().find(|word| *word == text),
            _ => None,
        };
        cx.report(match near {
            _ if quoted.is_some() => {
                let word = quoted.copied().unwrap_or_default();
                error.here("a text").help(format!("take out the quotes: write `{word}`")).fix(expr.span, word)
            }
            Some(near) => error.help(format!("did you mean `{near}`?")).fix(expr.span, near),
            None => error.help(format!("write one of them, such as `{}`", words[0])),
        });
        Some(None)
    }

    /// The whole statement that gives `name`.
    pub fn span_of(&self, name: &str) -> Option<Span> {
        self.found.iter().find(|(n, ..)| n.value == name).map(|(.., span)| *span)
    }

    /// Whether `name` is given, if only in a form that could not be read.
    pub fn may_have(&self, name: &str) -> bool {
        self.broken || self.accounted.contains(&name) || self.get(name).is_some()
    }

    /// The field `name`, or an error that it is missing, with an example of how to write it.
    pub fn demand(&self, cx: &mut Context<'a>, name: &str, example: &str) -> Option<&'a Expr> {
        let expr = self.get(name);
        if expr.is_none() && !self.may_have(name) {
            self.missing(cx, &format!("`{name}`"), example);
        }
        expr
    }

    /// As [`Fields::demand`], of a figure that nobody but the user knows.
    pub fn demand_own(&self, cx: &mut Context<'a>, name: &str, example: &str) -> Option<&'a Expr> {
        let expr = self.get(name);
        if expr.is_none() && !self.may_have(name) {
            let help = format!("add `{example}`, with the figures of your vehicle");
            self.missing_or(cx, &format!("`{name}`"), example, &help);
        }
        expr
    }

    pub fn missing(&self, cx: &mut Context<'a>, what: &str, example: &str) {
        self.missing_or(cx, what, example, &format!("add `{example}`"));
    }

    /// As [`Fields::missing`], with a help of its own where the example is not the only way.
    pub fn missing_or(&self, cx: &mut Context<'a>, what: &str, example: &str, help: &str) {
        let error = Diagnostic::error("mavc::name::missing_field", self.span, format!("{} has no {what}", self.owner))
            .here("needed here")
            .help(help);
        cx.report(self.add(cx, error, example));
    }

    /// The error with `text`, a field that is to be added, put where fields of these stand.
    pub fn add(&self, cx: &Context, error: Diagnostic, text: &str) -> Diagnostic {
        let source = cx.sources.get(self.span.file);
        let room = match self.room {
            _ if text.starts_with(',') => Some((Span { start: self.span.end, ..self.span }, text.to_string())),
            Room::Block(last) => mend::insertion(source, self.span, last, text),
            Room::End(span) => Some((Span { start: span.end, ..span }, format!(" {text}"))),
        };
        match room {
            Some((span, text)) => error.fix(span, text),
            None => error,
        }
    }
}

/// The field that a statement which could not be read was to give, if it begins with its name and speaks of no other.
fn meant_field(text: &str, known: Group) -> Option<&'static str> {
    let mut words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).filter(|word| !word.is_empty());
    let first = words.next()?;
    let field = known.names().find(|field| *field == first).or_else(|| nearest(first, known.names()))?;
    let is_one = !text.contains(['{', '}', '\n']) && !words.any(|word| known.has(word));
    is_one.then_some(field)
}
