//! The `name = value` statements of a block: reports unknown, repeated and missing fields.

use super::context::{Context, either, listed, no_filter};
use super::edits;
use super::expression::unknown;
use super::overrides::is_override;
use super::written::Written;
use crate::diagnostic::{Diagnostic, nearest, nearest_by_words};
use crate::language::{Entry, Group};
use crate::source::Span;
use crate::syntax::Place;
use crate::syntax::ast::{Clauses, Expr, ExprKind, Field, FieldValue, Name, Statement};

/// Words for something that is written elsewhere or in another form, and where or how.
const ELSEWHERE: &[(&str, &str)] = &[
    ("gravity", "belongs at the top level, outside all blocks"),
    ("allow", "belongs at the top level, outside all blocks"),
    ("points", "goes after the range of a `curve`, separated by a comma"),
    ("fault", "is a statement of `simulate`, written `fault M1 at 5 s`"),
    ("rpn", "is the product of `severity`, `occurrence` and `detection`: write these instead"),
    ("probability", "is given as a failure rate, such as `rate = 1e-5 1/h`"),
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
    (
        "wind",
        "goes into `air { wind = [6, 0, 0] m/s }` of the mission, for plans and flights; `simulate` takes it for \
         flights alone",
    ),
    (
        "gusts",
        "goes into `air { gusts = 1 m/s }` of the mission, for plans and flights; `simulate` takes it for flights \
         alone",
    ),
    (
        "recovery",
        "is a block of `plan`, written `recovery { order = [continue, land_here] }`, and a field of a fault mode, \
         written `recovery = [continue, land_here]`",
    ),
    (
        "coaxial",
        "pairs are written motor by motor, in place of `layout`: `rotors { rotor at [0.2, 0.2, 0.03] m  spin P; \
         rotor at [0.2, 0.2, -0.03] m  spin N; ... }`",
    ),
    ("order", "goes into `recovery { }` of `plan`"),
    ("density", "goes into `air { density = 1.1 kg/m^3 }` of the mission"),
];

/// The owners of the groups of fields, as messages name them.
const OWNERS: [(Group, &str); 11] = [
    (Group::Plan, "of `plan`"),
    (Group::Vehicle, "of `vehicle`"),
    (Group::Rotor, "of `rotor` in a `vehicle`"),
    (Group::Battery, "of `battery` in a `vehicle`"),
    (Group::Parts, "of `parts` in a `vehicle`"),
    (Group::Mission, "of a `mission`"),
    (Group::Curve, "of a `curve`"),
    (Group::Waypoint, "of a `waypoint`"),
    (Group::Mode, "of a fault mode, between the braces of `mode` or `every`,"),
    (Group::Simulate, "of `simulate`"),
    (Group::Campaign, "of `campaign`"),
];

/// Where a field that is written in the wrong place belongs.
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
    /// The name of the block in messages: "vehicle `octo`".
    pub owner: String,
    /// Where a missing field is reported.
    pub span: Span,
    found: Vec<Found<'a>>,
    /// The words between a clause's name and its value, with the name.
    hows: Vec<(&'a str, &'a Name)>,
    /// Known names that are present in an unreadable or misspelt form, so that they are not reported as missing.
    accounted: Vec<&'static str>,
    /// The block has statements that could not be parsed, so that no field is certainly missing.
    broken: bool,
    /// Where a missing field would go.
    slot: Slot,
}

/// A field or clause as it is read.
struct Found<'a> {
    /// The known name: the one meant, if the one written is misspelt.
    field: &'a str,
    /// The name that is written.
    name: &'a Name,
    value: Option<&'a Expr>,
    /// To the end of its value.
    span: Span,
}

/// Where a missing field goes.
enum Slot {
    /// After the last statement of a block, or after the brace of an empty one.
    Block(Option<Span>),
    /// At the end of a statement made of clauses, or of a head.
    End(Span),
}

impl<'a> Fields<'a> {
    /// The fields among the statements of a block.
    pub fn of_block(cx: &mut Context<'a>, owner: String, span: Span, body: &'a [Statement], known: Group) -> Self {
        let slot = Slot::Block(body.last().map(Statement::span));
        let (found, hows) = (Vec::new(), Vec::new());
        let mut fields = Fields { owner, span, found, hows, accounted: Vec::new(), broken: false, slot };
        for statement in body {
            if let Statement::Broken(span) = statement {
                // A broken statement that clearly is one field does not hide the others.
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

    /// Adds one field; the options after a curve's range are read by the same rules as the fields of its body.
    pub fn take_field(&mut self, cx: &mut Context<'a>, field: &'a Field, known: Group) {
        match &field.value {
            FieldValue::Expr(expr) => self.take(cx, &field.name, Some(expr), field.span, known),
            // Misspelt, because no field but `against` takes a condition.
            FieldValue::Where { .. }
                if !known.has(&field.name.value) && nearest(&field.name.value, ["against"]).is_some() =>
            {
                self.unknown(cx, &field.name, known);
            }
            FieldValue::Where { .. } => {
                cx.report(no_filter(field.span));
                self.accounted.extend(known.names().find(|k| *k == field.name.value));
            }
        }
    }

    /// The clauses of a statement.
    pub fn of_clauses(cx: &mut Context<'a>, owner: String, statement: &'a Clauses, known: Group) -> Self {
        let (span, slot) = (statement.head(), Slot::End(statement.head()));
        let (found, hows) = (Vec::new(), Vec::new());
        let mut fields = Fields { owner, span, found, hows, accounted: Vec::new(), broken: false, slot };
        for clause in &statement.clauses {
            let value = clause.value.as_ref();
            let end = value.map(|value| value.span).or(clause.how.as_ref().map(|how| how.span));
            let is_first = fields.clause(&clause.word.value).is_none();
            fields.take(cx, &clause.word, value, end.unwrap_or(clause.word.span), known);
            fields.hows.extend(clause.how.as_ref().filter(|_| is_first).map(|how| (clause.word.value.as_str(), how)));
        }
        fields
    }

    fn take(&mut self, cx: &mut Context<'a>, name: &'a Name, value: Option<&'a Expr>, span: Span, known: Group) {
        if !known.has(&name.value) {
            let meant = self.unknown(cx, name, known);
            // Read as its fix would have it, so that nothing is missing because of a misspelt word.
            self.found.extend(meant.map(|field| Found { field, name, value, span }));
        } else if let Some(first) = self.found.iter().find(|found| found.field == name.value) {
            let message = format!("`{}` is given twice in {}", name.value, self.owner);
            let again = edits::removal(cx.sources.get(span.file), name.span.to(span));
            cx.report(
                Diagnostic::error("mavc::name::duplicate", name.span, message)
                    .here("given again")
                    .also(first.name.span, "first given here")
                    .help("remove one")
                    .fix(again, ""),
            );
        } else if let Some(expr) = value.filter(|expr| expr.kind == ExprKind::Unknown) {
            let message = format!("`{}` of {} is not known yet", name.value, self.owner);
            let help = match known.entry(&name.value).and_then(Entry::unit) {
                Some("1") | None => "write its value in place of `?`".to_string(),
                Some(unit) => format!("write its value with a unit such as `{unit}` in place of `?`"),
            };
            cx.report(unknown(expr.span, message, help));
            self.accounted.extend(known.names().find(|k| *k == name.value));
        } else {
            self.found.push(Found { field: &name.value, name, value, span });
        }
    }

    /// Reports a name that is not a field; the field that is meant, if the error has it as its fix.
    fn unknown(&mut self, cx: &mut Context<'a>, name: &Name, known: Group) -> Option<&'static str> {
        let word = name.value.as_str();
        let message = format!("{} has no field `{word}`", self.owner);
        let mut error = Diagnostic::error("mavc::name::unknown_field", name.span, message).here("unknown field");
        let near = nearest(word, known.names()).or_else(|| nearest_by_words(word, known.names()));
        // `drag` among the fields of a rotor is `drag_coefficient`, `times` in a plan is `time`.
        let begins = |k: &&str| k.strip_prefix(word).is_some_and(|rest| rest.starts_with('_'));
        let begun = known.names().find(|k| Group::Simulate.has(word) && begins(k));
        let plural = |a: &str, b: &str| a.strip_suffix('s') == Some(b);
        let near = near.filter(|near| plural(near, word) || plural(word, near)).or(begun).or(near);
        let surer = near.is_some_and(|near| plural(near, word) || plural(word, near) || begun == Some(near));
        let mut meant = None;
        if matches!(word, "at" | "position") && known.has("x") {
            error = error.help("write the coordinates separately: `x = ..`, `y = ..` and `z = ..`");
            self.accounted.extend(["x", "y", "z"]);
        } else if word == "position" && known.has("at") {
            error = error.help("did you mean `at`?").fix(name.span, "at");
            self.accounted.push("at");
        } else if let Some(place) = elsewhere(word).filter(|_| !surer) {
            error = error.help(place);
        } else if let Some(near) = near.filter(|_| is_override(cx.sources, name.span)) {
            // An override that names a field wrongly is corrected on the command line.
            let written = &cx.sources.get(name.span.file).text;
            let (before, after) = (&written[..name.span.start as usize], &written[name.span.end as usize..]);
            error = error.here(format!("did you mean `{near}`?")).help(format!("write `--set {before}{near}{after}`"));
        } else if let Some(first) = near.and_then(|near| self.found.iter().find(|found| found.field == near)) {
            let message = format!("`{}` is given here", first.name.value);
            error = error.also(first.name.span, message).help("remove one");
        } else if let Some(near) = near {
            error = error.help(format!("did you mean `{near}`?")).fix(name.span, near);
            meant = Some(near);
        } else if matches!(known, Group::Nothing | Group::Mission) {
            let place = if known == Group::Mission { Place::Mission } else { Place::Faults };
            let allowed: Vec<&str> = place.openers().iter().copied().chain(known.names()).collect();
            error = error.help(format!("remove it; only {} are allowed here", listed(&allowed)));
        } else {
            error = error.help(format!("use one of the fields {}", listed(&known.names().collect::<Vec<_>>())));
        }
        if word == "heading" {
            self.accounted.push("yaw");
        }
        self.accounted.extend(known.names().find(|k| Some(*k) == near));
        cx.report(error);
        meant
    }

    pub fn get(&self, name: &str) -> Option<&'a Expr> {
        self.found.iter().find(|found| found.field == name).and_then(|found| found.value)
    }

    /// A field as `read` reads its value; faulty where that gives `None`.
    pub fn written<T>(&self, name: &str, read: impl FnOnce(&'a Expr) -> Option<T>) -> Written<T> {
        self.get(name).map_or(Written::Absent, |expr| Written::of(read(expr)))
    }

    /// A quantity; `code` is the error code for a value out of its range.
    pub fn quantity(&self, cx: &mut Context<'a>, entry: &'static Entry, code: &'static str) -> Written<f64> {
        self.written(entry.name, |expr| cx.quantity(entry, expr, code))
    }

    /// A whole number; `code` is the error code for a value out of its range.
    pub fn count(&self, cx: &mut Context<'a>, entry: &'static Entry, code: &'static str) -> Written<usize> {
        self.written(entry.name, |expr| cx.count(entry, &format!("`{}`", entry.name), expr, code))
    }

    /// One of `choices`, the meanings of the entry's words in the same order; `code` is that of any other word.
    pub fn choice<T: Copy>(
        &self,
        cx: &mut Context<'a>,
        entry: &'static Entry,
        code: &'static str,
        choices: &[T],
    ) -> Written<T> {
        let meaning = |word: &str| entry.words().iter().zip(choices).find(|(w, _)| **w == word).map(|(_, c)| *c);
        self.word(cx, code, entry).and_then(meaning)
    }

    /// The word of a field that takes one of a few words; faulty where its value is not one of them, which is reported.
    pub fn word(&self, cx: &mut Context<'a>, code: &'static str, entry: &'static Entry) -> Written<&'a str> {
        let (field, words) = (entry.name, entry.words());
        let Some(expr) = self.get(field) else { return Written::Absent };
        if let ExprKind::Name(name) = &expr.kind
            && words.contains(&name.as_str())
        {
            return Written::Value(name);
        }
        let error = Diagnostic::error(code, expr.span, format!("`{field}` must be {}", either(words)));
        let error = error.here(if words.len() > 2 { "not one of these" } else { "neither of these" });
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
                error.here("text in quotes").help(format!("remove the quotes: write `{word}`")).fix(expr.span, word)
            }
            Some(near) => error.help(format!("did you mean `{near}`?")).fix(expr.span, near),
            None => error.help(format!("write one of these words, such as `{}`", words[0])),
        });
        Written::Faulty
    }

    /// The words between the name of a clause and its value: `from`, `towards`.
    pub fn how(&self, name: &str) -> Option<&'a Name> {
        self.hows.iter().find(|(word, _)| *word == name).map(|(_, how)| *how)
    }

    /// The clause `name`, from its word to the end of its value.
    pub fn clause(&self, name: &str) -> Option<Span> {
        self.found.iter().find(|found| found.field == name).map(|found| found.name.span.to(found.span))
    }

    /// The whole statement that gives `name`.
    pub fn span_of(&self, name: &str) -> Option<Span> {
        self.found.iter().find(|found| found.field == name).map(|found| found.span)
    }

    /// Whether `name` is given, possibly in a form that could not be parsed.
    pub fn may_have(&self, name: &str) -> bool {
        self.broken || self.accounted.contains(&name) || self.get(name).is_some()
    }

    /// The field `name`; where it is missing, reports that with an example of how to write it.
    pub fn demand(&self, cx: &mut Context<'a>, name: &str, example: &str) -> Option<&'a Expr> {
        let expr = self.get(name);
        if expr.is_none() && !self.may_have(name) {
            self.missing(cx, &format!("`{name}`"), example);
        }
        expr
    }

    /// The field `name`, whose value only the user knows; where it is missing, reports that, and the help says that the
    /// example needs the values of the user's vehicle.
    pub fn demand_own(&self, cx: &mut Context<'a>, name: &str, example: &str) -> Option<&'a Expr> {
        let expr = self.get(name);
        if expr.is_none() && !self.may_have(name) {
            let help = format!("add `{example}`, with the values of your vehicle");
            self.missing_or(cx, &format!("`{name}`"), example, &help);
        }
        expr
    }

    /// Reports that `what` is missing, with a fix that adds `example`.
    pub fn missing(&self, cx: &mut Context<'a>, what: &str, example: &str) {
        self.missing_or(cx, what, example, &format!("add `{example}`"));
    }

    /// Reports that `what` is missing, with a fix that adds `example`, and with `help` where the example is not the
    /// only way.
    pub fn missing_or(&self, cx: &mut Context<'a>, what: &str, example: &str, help: &str) {
        let message = format!("{} is missing {what}", self.owner);
        let error = Diagnostic::error("mavc::name::missing_field", self.span, message).here("required here").help(help);
        cx.report(self.add(cx, error, example));
    }

    /// The error with a fix that adds the field `text` where the other fields are.
    pub fn add(&self, cx: &Context, error: Diagnostic, text: &str) -> Diagnostic {
        let source = cx.sources.get(self.span.file);
        let slot = match self.slot {
            _ if text.starts_with(',') => Some((Span { start: self.span.end, ..self.span }, text.to_string())),
            Slot::Block(last) => edits::insertion(source, self.span, last, text),
            Slot::End(span) => Some((Span { start: span.end, ..span }, format!(" {text}"))),
        };
        match slot {
            Some((span, text)) => error.fix(span, text),
            None => error,
        }
    }
}

/// The field that an unparsable statement was meant to give, if it begins with that name and contains no other.
fn meant_field(text: &str, known: Group) -> Option<&'static str> {
    let mut words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).filter(|word| !word.is_empty());
    let first = words.next()?;
    let field = known.names().find(|field| *field == first).or_else(|| nearest(first, known.names()))?;
    let is_one = !text.contains(['{', '}', '\n']) && !words.any(|word| known.has(word));
    is_one.then_some(field)
}
