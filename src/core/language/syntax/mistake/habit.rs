//! Mistakes that people often make, each recognised by where a statement fails and what follows there: here those in
//! the form of a statement, in `value` those in its values.

mod value;

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::{self, Place, is_clause};
use crate::syntax::cut;

/// The first that fits, from the surest to the least sure.
const HABITS: &[fn(&Broken, &Failure) -> Option<Diagnostic>] = &[
    misspelt_statement,
    unknown_block,
    unknown_statement,
    doubled,
    chained_limit,
    uncounted,
    braceless,
    boundless,
    assignment,
    relation,
    value::decimal_comma,
    value::listless,
    value::number_point,
    value::double_star,
    misspelt_word,
    value::range_marks,
    clause_marks,
    value::spaced_unit,
    value::unit_after_name,
    value::list_comma,
    wrong_start,
];

pub(super) fn recognise(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    HABITS.iter().find_map(|habit| habit(statement, failure))
}

/// `waypont at [0, 0, 2] m`
fn misspelt_statement(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    if word.is_empty() || rest.starts_with(['=', ':', '<', '>', ',', '(']) {
        return None;
    }
    let all = [Place::Top, Place::Vehicle, Place::Faults, Place::Mission, Place::Simulate];
    if all.iter().chain([&statement.place]).any(|p| p.openers().contains(&word)) {
        return None;
    }
    let meant = statement.place.meant(word)?;
    let span = statement.span(0, word.len());
    if word == "def" && rest.contains('(') {
        let error = Diagnostic::error("mavc::syntax::unknown_statement", span, "no functions can be defined");
        return Some(
            error.here("begins no statement").help("write the expression where it is used, or `let` it be a value"),
        );
    }
    let at = if matches!(meant, "start" | "waypoint") && rest.starts_with('[') { " at" } else { "" };
    // The last waypoint is the goal, and may be called so.
    let name = if GOALS.contains(&word) { format!(" {}", word.to_ascii_lowercase()) } else { String::new() };
    let fixed = format!("{meant}{name}{at}");
    let diagnostic =
        Diagnostic::error("mavc::syntax::unknown_statement", span, format!("no statement begins with `{}`", cut(word)))
            .here(format!("did you mean `{meant}`?"))
            .fix(span, &fixed);
    Some(match name.is_empty() {
        true => diagnostic.help(format!("write `{fixed}`")),
        false => diagnostic.help(format!("write `{fixed}`: the last waypoint of a mission is its goal")),
    })
}

const GOALS: [&str; 5] = ["goal", "target", "destination", "finish", "landing"];

/// `dance twice` in a block without fields, where no `=` makes a statement of it.
fn unknown_statement(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    let has_fields = !matches!(statement.place, Place::Mission | Place::Faults | Place::Rotors);
    let is_marked = rest.is_empty() || rest.starts_with(['=', ':', '<', '>', ',', '(', '.', '-', '+']);
    if word.is_empty() || has_fields || is_marked || Place::opens_statement(word) {
        return None;
    }
    let message = format!("no statement of {} begins with `{}`", statement.place.phrase_alone(), cut(word));
    let diagnostic = Diagnostic::error("mavc::syntax::unknown_statement", statement.span(0, word.len()), message);
    Some(diagnostic.here("unknown here").help(super::block::openers(statement.place)))
}

/// `mass = = 1.8 kg`
fn doubled(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    let found = statement.found(failure.at);
    if matches!(found, "=" | ":") && is_clause(before) && failure.expects(Expected::Value) {
        let span = statement.span(failure.at, failure.at + 1);
        let error = Diagnostic::error("mavc::syntax::unexpected", span, format!("`{before}` takes no `{found}`"));
        return Some(error.here("not expected").help("remove it: a clause is a word and its value").fix(span, ""));
    }
    let is_second = found == "=" && before == "=" && failure.expects(Expected::Value);
    is_second.then(|| {
        Diagnostic::error(
            "mavc::syntax::unexpected",
            statement.span(failure.at, failure.at + 1),
            "two `=` before one value",
        )
        .here("one too many")
        .help("remove one `=`")
        .fix(statement.span(start + 1, failure.at + 1), "")
    })
}

/// `1 m <= altitude <= 30 m`
fn chained_limit(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let parts: Vec<&str> = statement.text.split("<=").map(str::trim).collect();
    let [low, name, high] = parts[..] else { return None };
    if statement.place != Place::Limits || !name.chars().all(is_name) || low.is_empty() || high.is_empty() {
        return None;
    }
    let fixed = format!("{name} in {low} .. {high}");
    let span = statement.span(0, statement.text.trim_end().len());
    let error = Diagnostic::error("mavc::syntax::relation", span, "a limit begins with its name");
    let error = error.here("a value before the name");
    Some(error.help(format!("write `{}`", cut(&fixed))).fix(span, fixed))
}

/// `if a > 3 { .. }`: heads that no block has.
fn unknown_block(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    let known = Place::of_head(word).is_some() || word.is_empty() || rest.starts_with('=');
    let span = statement.span(0, word.len());
    (statement.has_body && !known).then(|| super::block::unknown_block(word, span, statement.place).0)
}

/// `every rotor lost as M`
fn uncounted(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let rest = statement.text.strip_prefix("every")?.trim_start();
    let at = statement.text.len() - rest.len();
    let rotors = token(rest, 0, is_name);
    let numbered = rest[rotors.len()..].trim_start();
    if rotors == "rotor" && numbered.starts_with(|c: char| c.is_ascii_digit()) {
        let number = token(numbered, 0, |c| c.is_ascii_digit());
        let span = statement.span(at, statement.text.len() - numbered.len() + number.len());
        let error =
            Diagnostic::error("mavc::syntax::unexpected", span, "`every` takes a number of rotors, not one rotor")
                .here("names one rotor")
                .help("write it like `every 1 rotor lost as M`");
        return Some(if number == "1" { error.fix(span, "1 rotor") } else { error });
    }
    matches!(rotors, "rotor" | "rotors").then(|| {
        let span = statement.span(at, at + rotors.len());
        Diagnostic::error("mavc::syntax::missing_value", span, "`every` has no number of rotors")
            .here("expected a number before this")
            .help("write it like `every 1 rotor lost as M`")
            .fix(statement.span(at, at), "1 ")
    })
}

/// Statements that are always blocks.
const BLOCKS: [&str; 5] = ["vehicle", "faults", "mode", "mission", "limits"];

/// `mode worn rotor 3 lost`
fn braceless(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let marks_value = statement.text[word.len()..].trim_start().starts_with(['=', ':']);
    let is_block = BLOCKS.contains(&word) && !statement.has_body && !statement.text.contains(['{', '}', '\n']);
    if !is_block || marks_value || !failure.expects(Expected::Equals) {
        return None;
    }
    let message = format!("a block `{word}` needs braces");
    let error =
        Diagnostic::error("mavc::syntax::block_head", statement.span(0, word.len()), message).here("no `{` follows");
    Some(match statement.text.find(" rotor").filter(|_| word == "mode") {
        Some(before) => {
            let body = statement.text[before + 1..].trim_end();
            let fixed = format!("{{ {body} }}");
            let span = statement.span(before + 1, before + 1 + body.len());
            error.help(format!("put braces around `{}`", cut(body))).fix(span, fixed)
        }
        None => error.help("open them with `{` on this line, and close them with `}` on a line of its own"),
    })
}

/// `mass: 1.8 kg`, `mass == 1.8 kg`, `mass 1.8 kg`
fn assignment(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !failure.expects(Expected::Equals) || failure.expects(Expected::Relation) || statement.has_body {
        return None;
    }
    let found = statement.found(failure.at);
    let (start, name) = statement.before(failure.at);
    let name_span = statement.span(start, start + name.len());
    let name = cut(name);
    if found.is_empty() {
        let message = format!("`{name}` has no value");
        let diagnostic = Diagnostic::error("mavc::syntax::missing_value", name_span, message);
        return Some(diagnostic.here("`=` and a value must follow").help(format!("write `{name} = ..`")));
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let arrow = statement.text[failure.at..].starts_with("->");
    let (found, span) = match arrow {
        true => ("->", statement.span(failure.at, failure.at + 2)),
        false => (found, span),
    };
    if arrow || found.starts_with([':', '=', '<', '>', '!']) || found.ends_with('=') {
        let message = format!("`{name}` is set with `=`, not `{found}`");
        return Some(
            Diagnostic::error("mavc::syntax::assignment", span, message)
                .here("expected `=`")
                .help("write `=`")
                .fix(span, "="),
        );
    }
    let begins_value = found.starts_with(|c: char| is_name(c) || "\"([-.".contains(c));
    begins_value.then(|| {
        let at = statement.span(failure.at, failure.at);
        Diagnostic::error("mavc::syntax::assignment", span, format!("`{name}` has no `=` before its value"))
            .here("expected `=` before this")
            .help(format!("write `{name} = {}`", cut(&statement.text[failure.at..])))
            .fix(at, "= ")
    })
}

/// `require capture_height`, `require capture_height >= 9 m`
fn boundless(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (_, before) = statement.before(failure.at);
    if statement.word() != "require" || before != "capture_height" || !failure.expects(Expected::Relation) {
        return None;
    }
    let found = statement.found(failure.at);
    let end = statement.text.trim_end().len();
    let (from, label) = match found.is_empty() {
        true => (end - "capture_height".len(), "`{ }` must follow"),
        false => (failure.at, "remove the bound"),
    };
    let message = "`require capture_height` takes a block and no bound: the height is simulated";
    Some(
        Diagnostic::error("mavc::syntax::unexpected", statement.span(from, end.max(from)), message)
            .here(label)
            .help("write `require capture_height { }`; fields in it are `radius` and `detection`")
            .fix(statement.span(failure.at.min(end), end), if found.is_empty() { " { }" } else { "{ }" }),
    )
}

/// `speed =< 8 m/s`, `speed < 8 m/s`, `where rpn => 100`, `require risk < 1e-6`
fn relation(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !failure.expects(Expected::Relation) {
        return None;
    }
    let found = statement.found(failure.at);
    let is_requirement = statement.word() == "require";
    let instead = match found {
        _ if is_requirement && found.starts_with(['>', '=']) && found.contains('>') => {
            let span = statement.span(failure.at, failure.at + found.len());
            let error = Diagnostic::error("mavc::syntax::relation", span, "a requirement is an upper bound");
            return Some(error.here("a lower bound").help("write `<=`"));
        }
        "==" if is_requirement => "<=",
        "=<" | "<" | "<==" | "=" | ":" => "<=",
        "=>" | ">" | ">==" => ">=",
        "==" if failure.expects(Expected::Equals) => "=",
        "==" => "<=",
        _ => return None,
    };
    let span = statement.span(failure.at, failure.at + found.len());
    let what = match statement.place {
        Place::Limits => "a limit",
        _ if is_requirement => "a requirement",
        _ => "a condition",
    };
    let message = format!("{what} is not written with `{found}`");
    Some(
        Diagnostic::error("mavc::syntax::relation", span, message)
            .here(format!("expected `{instead}`"))
            .help(format!("write `{instead}`"))
            .fix(span, instead),
    )
}

/// `start [0, 0, 2] m`, `start at [0, 0, 2] m, yaw 90 deg`
fn clause_marks(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !failure.expects(Expected::Clause) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + 1);
    let rest = &statement.text[failure.at..];
    let error = |message| Diagnostic::error("mavc::syntax::unexpected", span, message);
    let inside = rest.strip_prefix('(').and_then(|rest| rest.split_once(')')).map(|(inside, _)| inside);
    if let Some(inside) = inside.filter(|inside| inside.contains(',') && !inside.contains('(')) {
        let whole = statement.span(failure.at, failure.at + inside.len() + 2);
        let error = error("a position is a list behind `at`, in `[ ]`").here("expected `at` before this");
        return Some(error.help("write `at [x, y, z]` and the unit after it").fix(whole, format!("at [{inside}]")));
    }
    if rest.starts_with('[') {
        let at = statement.span(failure.at, failure.at);
        return Some(
            error("a position has no `at` before it")
                .here("expected `at` before this")
                .help("write `at` before the list")
                .fix(at, "at "),
        );
    }
    let word_follows = rest.strip_prefix(',')?.trim_start().starts_with(|c: char| c.is_ascii_alphabetic());
    word_follows.then(|| {
        error("no comma is allowed between the clauses of a statement")
            .here("not expected")
            .help("remove the comma: a space is enough")
            .fix(span, "")
    })
}

/// A misspelt word inside a statement: `rotor 3 reduce to 60 %`, `witin 10 cm`.
fn misspelt_word(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let mut words: Vec<&str> = Vec::new();
    for expected in &failure.expected {
        match expected {
            Expected::Word(word) => words.push(word),
            Expected::Effect => words.extend(["lost", "reduced", "stuck"]),
            Expected::Clause => words.extend(language::clauses()),
            _ => {}
        }
    }
    // The word before may be the culprit: after a number any word looks like a unit.
    let found = statement.found(failure.at);
    let before = statement.before(failure.at);
    let after_number = failure.expects(Expected::Effect) && !words.contains(&before.1);
    let candidates = [(failure.at, found), if after_number { before } else { (failure.at, "") }];
    let (at, word, meant) = candidates.into_iter().find_map(|(at, word)| {
        // `as` is a word of the language, written too early.
        let is_word = word != "as" && word.starts_with(|c: char| c.is_ascii_alphabetic());
        // Two letters are near to `at`, and may be a unit as well.
        let follows = statement.text[at + word.len()..].trim_start();
        let is_sure = |meant: &str| word.len() > 2 || meant != "at" || follows.starts_with(['[', '(']);
        nearest(word, words.iter().copied()).filter(|meant| is_word && is_sure(meant)).map(|meant| (at, word, meant))
    })?;
    let span = statement.span(at, at + word.len());
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("`{}` is not allowed here", cut(word)))
            .here(format!("did you mean `{meant}`?"))
            .help(format!("write `{meant}`"))
            .fix(span, meant),
    )
}

/// A statement that begins with a number or a mark.
fn wrong_start(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    if !statement.word().is_empty() {
        return None;
    }
    let found = statement.found(0);
    let message = format!("a statement cannot begin with `{}`", cut(found));
    Some(
        Diagnostic::error("mavc::syntax::unexpected", statement.span(0, found.len()), message)
            .here("expected a name or a keyword")
            .help(match statement.place {
                Place::Limits => "begin with the limit: `speed <= 8 m/s`, `altitude in 1 m .. 30 m`",
                _ => "begin with a keyword, or with the name of a field: `name = value`",
            }),
    )
}
