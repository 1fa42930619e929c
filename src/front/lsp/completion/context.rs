//! The context of the cursor: the block, the statement, what precedes it. By words and marks alone, because a statement
//! that is being typed has no tree.

use crate::language::{Group, Takes};
use crate::read::vocabulary::mode_numbers;
use crate::syntax::Place;
use crate::syntax::scan::{Lexeme, LexemeKind, lexemes};
use std::collections::BTreeSet;
use std::ops::Range;

/// What precedes the cursor in its statement.
#[derive(Debug, Clone, PartialEq)]
pub enum Before {
    /// A statement begins here.
    Nothing,
    /// Inside the value of a field or clause; `ended` where a unit or an operator may follow.
    Value { field: String, ended: bool },
    /// One of these words has to follow.
    Words(&'static [&'static str]),
    /// The name of a limit.
    LimitName(String),
    /// A word of clauses has to follow.
    Clause,
    /// The name of a fault mode has to follow.
    Mode,
    /// What `where` looks at.
    ModeNumber,
}

#[derive(Debug, Clone)]
pub struct Context {
    /// The block around.
    pub place: Place,
    pub before: Before,
    /// The word that is being typed.
    pub word: Range<usize>,
    /// Fields and blocks that the block already has, before or after the cursor.
    pub present: BTreeSet<String>,
    /// The word that begins the statement.
    pub opener: Option<String>,
    /// The word before the cursor in the statement.
    pub after: String,
    /// The clauses that the statement has already.
    pub clauses: BTreeSet<String>,
    /// Words that may follow a value here.
    pub next: Vec<&'static str>,
    /// The parameter of the curve around.
    pub parameter: Option<String>,
    pub in_brackets: bool,
    /// Inside brackets, the other words of the statement.
    pub listed: BTreeSet<String>,
    /// The word before the `..` that precedes the cursor.
    pub range_from: Option<String>,
}

/// A block that is open at the cursor.
struct Frame {
    place: Place,
    parameter: Option<String>,
    present: BTreeSet<String>,
}

impl Frame {
    fn top() -> Self {
        Frame { place: Place::Top, parameter: None, present: BTreeSet::new() }
    }
}

/// Statements of a mission that one word begins, and the word that follows; `hold` takes a time.
const FLIGHT: [(&str, &[&str]); 3] = [("hold", &[]), ("waypoints", &["from"]), ("end", &["moving"])];

impl Context {
    /// The context of a byte offset; `None` inside comments and texts, where nothing is offered.
    pub fn at(text: &str, offset: usize) -> Option<Self> {
        let all: Vec<Lexeme> = lexemes(text).collect();
        // A comment extends to the end of its line, with trailing blanks.
        let begun = all[..all.partition_point(|l| l.start < offset)].last();
        let under = begun.filter(|l| offset <= l.end);
        let is_comment = begun.is_some_and(|l| matches!(l.kind, LexemeKind::Comment | LexemeKind::Doc));
        if is_comment
            || under.is_some_and(|l| matches!(l.kind, LexemeKind::Text | LexemeKind::UnclosedText) && offset < l.end)
        {
            return None;
        }
        let word = under.filter(|l| l.kind == LexemeKind::Word).map_or(offset..offset, |l| l.start..l.end);
        let word = unit_before(text, &all, offset).map_or(word.clone(), |start| start..word.end);
        let cut = all.partition_point(|l| l.start < word.start);
        let mut frames = vec![Frame::top()];
        let mut statement: Vec<Lexeme> = Vec::new();
        let mut brackets = 0usize;
        for (k, lexeme) in all[..cut].iter().enumerate() {
            step(text, &all, k, lexeme, &mut frames, &mut statement, &mut brackets);
        }
        let frame = frames.pop().unwrap_or_else(Frame::top);
        let mut present = frame.present;
        rest_of_block(text, &all[cut..], &word, &mut present);
        let mut listed = BTreeSet::new();
        if brackets > 0 {
            let behind = all[cut..]
                .iter()
                .take_while(|l| !(l.is(']') || l.kind == LexemeKind::Newline || l.is(';') || l.is('}')));
            let others = statement.iter().chain(behind).filter(|l| l.kind == LexemeKind::Word && l.start != word.start);
            listed.extend(others.map(|l| l.text(text).to_string()));
        }
        let mut context = Context {
            place: frame.place,
            before: Before::Nothing,
            word,
            present,
            opener: statement.first().map(|l| l.text(text).to_string()),
            after: statement.last().map_or("", |l| l.text(text)).to_string(),
            clauses: BTreeSet::new(),
            next: Vec::new(),
            parameter: frame.parameter,
            in_brackets: brackets > 0,
            listed,
            range_from: range_from(text, &statement),
        };
        context.before = context.look(text, &statement);
        Some(context)
    }

    /// The block whose documentation describes a field of this statement.
    pub fn place_of(&self, field: &str) -> Place {
        match (self.place, self.opener.as_deref()) {
            (Place::Faults, Some("every")) => Place::Faults,
            (Place::Mission, Some("curve")) if field == "points" => Place::Curve,
            // `against = where rate > ...`
            (Place::Plan, Some("against")) if mode_numbers().contains(&field) => Place::Mode,
            (place, _) => place,
        }
    }

    /// What the words of the statement before the cursor mean.
    fn look(&mut self, text: &str, statement: &[Lexeme]) -> Before {
        let word = |k: usize| statement.get(k).map_or("", |l| l.text(text));
        let Some(last) = statement.last() else { return Before::Nothing };
        let ended = matches!(last.kind, LexemeKind::Number) || last.is(')') || last.is(']');
        let opener = word(0).to_string();
        // After a unit or a name a value is over, unless an operator continues it.
        let is_over = last.kind == LexemeKind::Word && statement.len() > 1 && last.text(text) != "in" || last.is('%');
        let value = |field: &str| match is_over && !self.in_brackets {
            true => Before::Words(&[]),
            false => Before::Value { field: field.to_string(), ended },
        };
        if let Some(at) = statement.iter().position(|l| l.kind == LexemeKind::Word && l.text(text) == "where") {
            let behind = statement[at + 1..].iter().any(|l| matches!(l.kind, LexemeKind::Mark('<' | '>' | '=')));
            return match (behind, at + 1 == statement.len()) {
                (true, _) => value(word(at + 1)),
                (false, true) => Before::ModeNumber,
                (false, false) => Before::Words(&["<=", ">=", "<", ">", "="]),
            };
        }
        if word(1) == "=" {
            return value(&opener);
        }
        match (self.place, opener.as_str()) {
            (Place::Top, "let") if word(2) == "=" => value(word(1)),
            (place, name) if place.has_limits() => match statement.len() {
                1 => Before::LimitName(name.to_string()),
                _ => value(name),
            },
            (Place::Mission, "start") if statement.len() == 1 => {
                self.next = vec!["moving"];
                Before::Clause
            }
            (Place::Mission, "curve") => {
                let fields =
                    statement.iter().filter(|l| l.kind == LexemeKind::Word && l.text(text) == "points").count();
                match statement.iter().any(|l| l.is(',')) {
                    true if fields > 0 => value("points"),
                    true => Before::Words(&["points ="]),
                    false if statement.len() == 2 => Before::Words(&["in"]),
                    false => value(""),
                }
            }
            (Place::Mission, name) if FLIGHT.iter().any(|row| row.0 == name) => {
                let words = FLIGHT.iter().find(|row| row.0 == name).map_or(&[][..], |row| row.1);
                if words.is_empty() { value("time") } else { Before::Words(words) }
            }
            (Place::Plan, "require") => match statement.len() {
                1 => Before::Words(&["risk <=", "uncovered <=", "capture_height {"]),
                _ => value(""),
            },
            (Place::Simulate, "fault") if statement.len() == 1 => Before::Mode,
            (Place::Mission, "start" | "waypoint") | (Place::Rotors, "rotor") | (Place::Simulate, "fault") => {
                self.in_clauses(text, statement, ended)
            }
            (Place::Mode, "rotor" | "rotors") | (Place::Faults, "every") => self.in_fault(text, statement, ended),
            _ => Before::Words(&[]),
        }
    }

    /// In a statement of clauses: the last clause's value, or the next clause.
    fn in_clauses(&mut self, text: &str, statement: &[Lexeme], ended: bool) -> Before {
        let opener = statement[0].text(text);
        let known = crate::read::vocabulary::clauses(self.place, opener);
        let is_clause = |l: &Lexeme| l.kind == LexemeKind::Word && known.contains(&l.text(text));
        let mut words = statement[1..].iter().filter(|l| is_clause(l));
        self.clauses = words.clone().map(|l| l.text(text).to_string()).collect();
        let (Some(clause), Some(last)) = (words.next_back(), statement.last()) else { return Before::Clause };
        let field = clause.text(text).to_string();
        let entry = Group::of_statement(self.place, opener).entry(&field);
        if entry.is_some_and(|entry| entry.takes == Takes::Nothing) {
            return Before::Clause;
        }
        // `arrive from [0, 0, 1]`
        if field == "arrive" && last.start == clause.start {
            return Before::Words(&["from"]);
        }
        match last.text(text) {
            "from" | "towards" => return Before::Value { field, ended: false },
            "along" if field == "yaw" => return Before::Words(&["path"]),
            "path" | "free" if field == "yaw" => return Before::Clause,
            _ => {}
        }
        // After a unit or a name a value is over, unless an operator continues it.
        let is_over = last.kind == LexemeKind::Word && last.start != clause.start || last.is('%');
        match is_over && !self.in_brackets {
            true => Before::Clause,
            false => Before::Value { field, ended: ended && !(self.in_brackets && last.is(']')) },
        }
    }

    /// `every 2 rotors lost as M`, `rotor 3 reduced to 60 %`.
    fn in_fault(&mut self, text: &str, statement: &[Lexeme], ended: bool) -> Before {
        const EFFECTS: &[&str] = &["lost", "reduced to", "stuck at"];
        let is_every = self.place == Place::Faults;
        let last = statement[statement.len() - 1].text(text);
        match last {
            "every" | "as" => Before::Words(&[]),
            "rotor" | "rotors" if is_every => Before::Words(EFFECTS),
            "reduced" => Before::Words(&["to"]),
            "stuck" => Before::Words(&["at"]),
            "lost" | "%" if is_every => Before::Words(&["as"]),
            "to" | "at" => Before::Value { field: String::new(), ended: false },
            _ if self.in_brackets => Before::Words(&[]),
            _ if ended => {
                let has_effect = statement.iter().any(|l| matches!(l.text(text), "to" | "at"));
                match (has_effect, is_every) {
                    (true, _) => Before::Value { field: String::new(), ended: true },
                    (false, true) => Before::Words(&["rotors", "rotor"]),
                    (false, false) => Before::Words(EFFECTS),
                }
            }
            _ => Before::Words(&[]),
        }
    }
}

/// The word of a statement that ends in it and `..`.
fn range_from(text: &str, statement: &[Lexeme]) -> Option<String> {
    match statement {
        [.., word, dots] if word.kind == LexemeKind::Word && dots.text(text) == ".." => {
            Some(word.text(text).to_string())
        }
        _ => None,
    }
}

/// The start of the unit that ends at `offset` in a mark that continues it, or in the word after one: the `m/` of
/// `3 m/`, the `N*s` of `2 N*s`. A unit follows a number, a `)` or a `]`, as one run without blanks.
fn unit_before(text: &str, all: &[Lexeme], offset: usize) -> Option<usize> {
    let end = all.partition_point(|l| l.start < offset);
    let joins = |l: &Lexeme| l.is('/') || l.is('*') || l.is('^');
    let mut first = end.checked_sub(1).filter(|&k| all[k].end >= offset)?;
    while let Some(before) = first.checked_sub(1)
        && all[before].end == all[first].start
        && (joins(&all[before])
            || joins(&all[first]) && matches!(all[before].kind, LexemeKind::Word | LexemeKind::Number))
    {
        first = before;
    }
    let run = &all[first..end];
    let begins = run[0].kind == LexemeKind::Word || run[0].text(text) == "1" && run.get(1).is_some_and(|l| l.is('/'));
    let behind = first.checked_sub(1).map(|k| all[k])?;
    let has_number = behind.kind == LexemeKind::Number || behind.is(')') || behind.is(']');
    (run.len() > 1 && begins && has_number).then_some(run[0].start)
}

/// The block that a brace opens: after a waypoint, the limits of its leg.
fn of_head(frames: &[Frame], word: &str) -> Place {
    let in_mission = frames.last().is_some_and(|frame| frame.place == Place::Mission);
    match word {
        "waypoint" if in_mission => Place::Limits,
        _ => Place::of_head(word).unwrap_or(Place::Unknown),
    }
}

/// Takes one word or mark before the cursor into account.
fn step(
    text: &str,
    all: &[Lexeme],
    k: usize,
    lexeme: &Lexeme,
    frames: &mut Vec<Frame>,
    statement: &mut Vec<Lexeme>,
    brackets: &mut usize,
) {
    let head = |statement: &[Lexeme]| statement.first().map_or("", |l| l.text(text)).to_string();
    match lexeme.kind {
        LexemeKind::Comment | LexemeKind::Doc => {}
        LexemeKind::Newline => {
            // A bracket continues over lines, unless the next line begins another statement.
            let next = all[k + 1..].iter().find(|l| l.kind != LexemeKind::Newline);
            let begins = next.is_none_or(|l| {
                let word = l.text(text);
                let assigns =
                    all[k + 1..].iter().filter(|l| l.kind != LexemeKind::Newline).nth(1).is_some_and(|l| l.is('='));
                l.is('}') || l.kind == LexemeKind::Word && (assigns || Place::opens_statement(word))
            });
            if *brackets == 0 || begins {
                *brackets = 0;
                statement.clear();
            }
        }
        LexemeKind::Mark(';') => {
            statement.clear();
            *brackets = 0;
        }
        LexemeKind::Mark('{') => {
            let word = head(statement);
            let parameter = (word == "curve").then(|| statement.get(1).map_or("", |l| l.text(text)).to_string());
            frames.push(Frame { place: of_head(frames, &word), parameter, present: BTreeSet::new() });
            statement.clear();
            *brackets = 0;
        }
        LexemeKind::Mark('}') => {
            if frames.len() > 1 {
                frames.pop();
            }
            statement.clear();
            *brackets = 0;
        }
        _ => {
            match lexeme.kind {
                LexemeKind::Mark('(' | '[') => *brackets += 1,
                LexemeKind::Mark(')' | ']') => *brackets = brackets.saturating_sub(1),
                _ => {}
            }
            if statement.is_empty()
                && lexeme.kind == LexemeKind::Word
                && let Some(frame) = frames.last_mut()
            {
                frame.present.insert(lexeme.text(text).to_string());
            }
            statement.push(*lexeme);
        }
    }
}

/// The words that begin the statements between the cursor and the end of its block.
fn rest_of_block(text: &str, rest: &[Lexeme], word: &Range<usize>, present: &mut BTreeSet<String>) {
    let (mut depth, mut begins) = (0usize, false);
    for lexeme in rest {
        match lexeme.kind {
            LexemeKind::Mark('{') => depth += 1,
            LexemeKind::Mark('}') if depth == 0 => return,
            LexemeKind::Mark('}') => depth -= 1,
            LexemeKind::Newline | LexemeKind::Mark(';') => begins = true,
            LexemeKind::Word if begins && depth == 0 && lexeme.start != word.start => {
                present.insert(lexeme.text(text).to_string());
                begins = false;
            }
            LexemeKind::Comment | LexemeKind::Doc => {}
            _ => begins = false,
        }
    }
}
