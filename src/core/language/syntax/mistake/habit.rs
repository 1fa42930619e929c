//! Mistakes that people often make, each recognised by where a statement fails and what follows there: here those in
//! the form of a statement, in `value` those in its values.

mod value;

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::{self, Group, Place, is_clause};
use crate::syntax::cut;

/// The first that fits, from the surest to the least sure.
const HABITS: &[fn(&Broken, &Failure) -> Option<Diagnostic>] = &[
    keyword_colon,
    value::pi_and_unit,
    value::way_of_two_words,
    no_such_clause,
    name_form,
    value::in_parentheses,
    joined_conditions,
    per,
    instead,
    all_rotors,
    misspelt_statement,
    misspelt_where,
    unknown_block,
    unknown_statement,
    doubled,
    braceless,
    boundless,
    assignment,
    relation,
    value::decimal_comma,
    value::listless,
    value::number_point,
    value::double_star,
    misspelt_word,
    value::comma_in_curve,
    clause_marks,
    value::spaced_unit,
    value::unit_after_name,
    value::list_comma,
    wrong_start,
];

pub(super) fn recognise(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    HABITS.iter().find_map(|habit| habit(statement, failure))
}

fn unexpected(statement: &Broken, from: usize, to: usize, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("mavc::syntax::unexpected", statement.span(from, to), message)
}

/// Words and marks of speech and of other languages: where they are found, and what is written instead.
const INSTEAD: [(&[&str], Expected, &str); 9] = [
    (&["to"], Expected::Operator, ".."),
    (&["in"], Expected::Operator, "inch"),
    (&["=", ":"], Expected::Word("in"), "in"),
    (&["motor", "propeller", "prop"], Expected::Word("rotors"), "rotor"),
    (&["motors", "propellers", "props"], Expected::Word("rotors"), "rotors"),
    (&["fails", "failed", "fail", "dead", "off", "broken"], Expected::Effect, "lost"),
    (&["jammed", "locked", "frozen"], Expected::Effect, "stuck at 50 %"),
    (&["limited", "degraded", "weak", "worn"], Expected::Effect, "reduced to 60 %"),
    (&["+"], Expected::Value, ""),
];

/// `altitude in 1 m to 30 m`, `rotor 1 fails`, `+5 m`, and a comma at the end of a line.
fn instead(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (at, found) = statement.culprit(failure);
    let is_last = found == "," && statement.text[at..].trim_end() == "," && failure.expects(Expected::End);
    let fits = |(words, expected, _): &&(&[&str], Expected, &str)| words.contains(&found) && failure.expects(*expected);
    let ours = match is_last {
        true => "",
        false => INSTEAD.iter().find(fits)?.2,
    };
    let code = if ours == ".." { "mavc::syntax::range" } else { "mavc::syntax::unexpected" };
    let span = statement.span(at, at + found.len());
    Some(
        match ours {
            "" => Diagnostic::error(code, span, format!("`{found}` is not allowed here"))
                .here("not expected")
                .help("remove it"),
            _ => Diagnostic::error(code, span, format!("`{found}` is written `{ours}`"))
                .here(format!("expected `{ours}`"))
                .help(format!("write `{ours}`")),
        }
        .fix(span, ours),
    )
}

/// `waypoint at [..] m  speed 3 m/s`: a word that begins no clause.
fn no_such_clause(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let group = Group::of_statement(statement.place, statement.word());
    let is_word = found.starts_with(|c: char| c.is_ascii_alphabetic());
    if statement.has_body || !is_word || !failure.expects(Expected::Clause) || nearest(found, group.names()).is_some() {
        return None;
    }
    let names: Vec<String> = group.names().map(|name| format!("`{name}`")).collect();
    let (last, others) = names.split_last()?;
    let message = format!("a `{}` has no `{}`", statement.word(), cut(found));
    let help = match found {
        "heading" | "course" | "bearing" => {
            "write it as `yaw`, counter-clockwise from east: a compass heading h is `yaw 90 deg - h`".to_string()
        }
        "tilt" | "tilted" | "cant" | "canted" | "axis" if statement.word() == "rotor" => {
            "remove it: the axes of all rotors are parallel to the body's z axis".to_string()
        }
        "speed" | "velocity" | "altitude" | "tilt" if statement.word() == "waypoint" => {
            "limits of the leg that arrives go between braces at the end, as in `{ speed <= 3 m/s }`".to_string()
        }
        _ => format!("its clauses are {} and {last}", others.join(", ")),
    };
    Some(unexpected(statement, failure.at, failure.at + found.len(), message).here("not a clause").help(help))
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
    if word == "motor" && meant == "rotor" {
        let message = "no statement begins with `motor`";
        let error = Diagnostic::error("mavc::syntax::unknown_statement", span, message).here("did you mean `rotor`?");
        return Some(error.help(
            "write `rotor` with its place in the list of the vehicle, from 1: where the rotors have a `motor` number, \
             it may be another",
        ));
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
    let is_field = rest.is_empty() && Group::of_block(statement.place).entry(word).is_some();
    let is_marked = is_field || rest.starts_with(['=', ':', '<', '>', ',', '(', '.', '-', '+']);
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

/// `if a > 3 { .. }`: heads that no block has.
fn unknown_block(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    // Limits of a leg may follow a waypoint whose clauses are wrong.
    let is_waypoint = statement.place == Place::Mission
        && matches!(word, "start" | "waypoint")
        && statement.text[failure.at.min(statement.text.len())..].starts_with(|c: char| c.is_ascii_alphabetic());
    let known = Place::of_head(word).is_some() || word.is_empty() || rest.starts_with('=') || is_waypoint;
    let span = statement.span(0, word.len());
    (statement.has_body && !known).then(|| super::block::unknown_block(word, span, statement.place).0)
}

/// Statements that are always blocks.
const BLOCKS: [&str; 13] = [
    "vehicle",
    "faults",
    "mode",
    "mission",
    "limits",
    "parts",
    "part",
    "landing_site",
    "keep_off",
    "after_fault_limits",
    "plan",
    "simulate",
    "campaign",
];

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
    Some(error.help("open them with `{` on this line, and close them with `}` on a line of its own"))
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
        place if place.has_limits() => "a limit",
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
        let (start, word) = statement.before(failure.at);
        if word.starts_with(|c: char| c.is_ascii_alphabetic()) && statement.before(start).1 == "yaw" {
            let message = format!("`{}` does not follow `yaw`", cut(word));
            let error =
                Diagnostic::error("mavc::syntax::unexpected", statement.span(start, start + word.len()), message);
            return Some(
                error
                    .here("expected `towards`")
                    .help("write `towards`")
                    .fix(statement.span(start, start + word.len()), "towards"),
            );
        }
        let at = statement.span(failure.at, failure.at);
        return Some(
            error("a position has no `at` before it")
                .here("expected `at` before this")
                .help("write `at` before the list")
                .fix(at, "at "),
        );
    }
    let next = rest.strip_prefix(',')?.trim_start();
    is_clause(token(next, 0, is_name)).then(|| {
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
    let (at, word) = statement.culprit(failure);
    // `as` is a word of the language, written too early.
    let is_word = word != "as" && word.starts_with(|c: char| c.is_ascii_alphabetic());
    // Two letters are near to `at`, and may be a unit as well.
    let follows = statement.text[at + word.len()..].trim_start();
    let is_sure = |meant: &str| word.len() > 2 || meant != "at" || follows.starts_with(['[', '(']);
    let meant = nearest(word, words.iter().copied()).filter(|meant| is_word && is_sure(meant))?;
    let span = statement.span(at, at + word.len());
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("`{}` is not allowed here", cut(word)))
            .here(format!("did you mean `{meant}`?"))
            .help(format!("write `{meant}`"))
            .fix(span, meant),
    )
}

/// `against = wher rpn >= 30`
fn misspelt_where(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (at, word) = statement.before(failure.at);
    let is_value = statement.text[..at].trim_end().ends_with('=');
    let goes_on = statement.text[failure.at.min(statement.text.len())..].starts_with(|c: char| c.is_ascii_alphabetic());
    if statement.word() != "against" || !is_value || !goes_on || nearest(word, ["where"]).is_none() {
        return None;
    }
    let span = statement.span(at, at + word.len());
    let error = unexpected(statement, at, at + word.len(), format!("`{}` is not allowed here", cut(word)));
    Some(error.here("did you mean `where`?").help("write `where`").fix(span, "where"))
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
                place if place.has_limits() => "begin with the limit: `speed <= 8 m/s`, `altitude in 1 m .. 30 m`",
                _ => "begin with a keyword, or with the name of a field: `name = value`",
            }),
    )
}

/// `vehicle:` and `waypoint: at [..]`, as in YAML.
fn keyword_colon(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let word = statement.word();
    let is_block = Place::of_block(word).is_some();
    if statement.found(failure.at) != ":" || !(is_block || Place::opens_statement(word)) {
        return None;
    }
    if statement.text[..failure.at].trim_end() != word {
        return None;
    }
    let diagnostic = unexpected(statement, failure.at, failure.at + 1, format!("`{word}` takes no `:`"));
    let diagnostic = diagnostic.here("not expected");
    let form = super::form(word, statement.place).unwrap_or(word);
    Some(match is_block {
        true => diagnostic.help(format!("a block takes braces: `{}`", form.split(" {").next()?.to_owned() + " { .. }")),
        false => diagnostic.help("remove it").fix(statement.span(failure.at, failure.at + 1), ""),
    })
}

/// `mission my-mission {`
fn name_form(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (start, before) = statement.before(failure.at);
    let is_head = statement.has_body && Place::of_block(statement.word()).is_some();
    let end = failure.at + token(statement.text, failure.at, |c| is_name(c) || c == '-').len();
    let is_field = start == 0 && !statement.has_body && statement.text[end..].trim_start().starts_with('=');
    let declares = is_head || is_field || statement.word() == "let";
    let follows = statement.text.as_bytes().get(failure.at + 1).is_some_and(u8::is_ascii_alphanumeric);
    let touches = failure.at > 0 && is_name(statement.text.as_bytes()[failure.at - 1] as char);
    if !declares || found != "-" || !follows || !touches || !before.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let name = token(statement.text, start, |c| is_name(c) || c == '-');
    let span = statement.span(start, start + name.len());
    let fixed = name.replace('-', "_");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("the name `{}` has a `-` in it", cut(name)))
            .here("a name is made of letters, digits and `_`")
            .help(format!("write `{}`", cut(&fixed)))
            .fix(span, fixed),
    )
}

/// `1e-5 per hour`
fn per(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    let at = if before == "per" { start } else { failure.at };
    (statement.found(at) == "per" && failure.expects(Expected::Operator)).then(|| {
        let error = unexpected(statement, at, at + 3, "`per` is written `/`").here("not a unit");
        error.help("write units like `m/s` or `1/h`")
    })
}

/// `against = where rpn > 50 and severity > 3`
fn joined_conditions(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (start, before) = statement.before(failure.at);
    let joins = |w: &str| matches!(w, "and" | "or" | "&&" | "||" | "&" | "|");
    let (at, word) = if joins(before) { (start, before) } else { (failure.at, found) };
    let is_filter = statement.text.contains("where") && failure.expects(Expected::Operator) && joins(word);
    is_filter.then(|| {
        unexpected(statement, at, at + word.len(), format!("`{word}` cannot join conditions"))
            .here("a filter has one condition")
            .help("where one condition is not enough, list the modes: `against = [M1, M2]`")
    })
}

/// `all rotors lost`
fn all_rotors(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let is_all = statement.place == Place::Mode && matches!(statement.word(), "all" | "both" | "any");
    let word = statement.word();
    is_all.then(|| {
        unexpected(statement, 0, word.len(), format!("no fault begins with `{word}`"))
            .here("expected `rotor` or `rotors`")
            .help("write which rotors: `rotors [1, 2] lost`")
    })
}
