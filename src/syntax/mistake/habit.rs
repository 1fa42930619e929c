//! Mistakes that people often make, each recognised by where a statement fails and what stands there.

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::{Diagnostic, nearest};
use crate::syntax::cut;
use crate::syntax::place::Place;

/// The first that fits, from the surest to the least sure.
const HABITS: &[fn(&Broken, &Failure) -> Option<Diagnostic>] = &[
    misspelt_statement,
    unknown_block,
    unknown_statement,
    doubled,
    chained_limit,
    uncounted,
    assignment,
    relation,
    decimal_comma,
    listless,
    number_point,
    double_star,
    misspelt_word,
    range_marks,
    clause_marks,
    spaced_unit,
    unit_after_name,
    list_comma,
    wrong_start,
];

pub(super) const CLAUSES: [&str; 15] = [
    "at",
    "yaw",
    "yaw_within",
    "within",
    "weight",
    "time",
    "spin",
    "min_speed",
    "max_speed",
    "max_thrust",
    "time_constant",
    "thrust_coefficient",
    "drag_coefficient",
    "torque_per_thrust",
    "until",
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
    if all.iter().any(|p| p.openers().contains(&word)) {
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
    let mended = format!("{meant}{name}{at}");
    let diagnostic =
        Diagnostic::error("mavc::syntax::unknown_statement", span, format!("no statement begins with `{}`", cut(word)))
            .here(format!("did you mean `{meant}`?"))
            .fix(span, &mended);
    Some(match name.is_empty() {
        true => diagnostic.help(format!("write `{mended}`")),
        false => diagnostic.help(format!("write `{mended}`: the last waypoint of a mission is its goal")),
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
    if matches!(found, "=" | ":") && CLAUSES.contains(&before) && failure.expects(Expected::Value) {
        let span = statement.span(failure.at, failure.at + 1);
        let error = Diagnostic::error("mavc::syntax::unexpected", span, format!("no `{found}` follows `{before}`"));
        return Some(error.here("not expected").help("remove it: a clause is a word and its value").fix(span, ""));
    }
    let is_second = found == "=" && before == "=" && failure.expects(Expected::Value);
    is_second.then(|| {
        Diagnostic::error(
            "mavc::syntax::unexpected",
            statement.span(failure.at, failure.at + 1),
            "`=` stands twice before one value",
        )
        .here("one too many")
        .help("take one `=` out")
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
    let mended = format!("{name} in {low} .. {high}");
    let span = statement.span(0, statement.text.trim_end().len());
    let error = Diagnostic::error("mavc::syntax::relation", span, "a limit has its name in front");
    let error = error.here("a value stands before the name");
    Some(error.help(format!("write `{}`", cut(&mended))).fix(span, mended))
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
    matches!(rotors, "rotor" | "rotors").then(|| {
        let span = statement.span(at, at + rotors.len());
        Diagnostic::error("mavc::syntax::missing_value", span, "`every` does not say how many rotors")
            .here("a number must stand before this")
            .help("write it like `every 1 rotor lost as M`")
            .fix(statement.span(at, at), "1 ")
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

/// `speed =< 8 m/s`, `speed < 8 m/s`, `where rpn => 100`
fn relation(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !failure.expects(Expected::Relation) {
        return None;
    }
    let found = statement.found(failure.at);
    let instead = match found {
        "=<" | "<" | "<==" | "=" | ":" => "<=",
        "=>" | ">" | ">==" => ">=",
        "==" if failure.expects(Expected::Equals) => "=",
        "==" => "<=",
        _ => return None,
    };
    let span = statement.span(failure.at, failure.at + found.len());
    let what = if statement.place == Place::Limits { "a limit" } else { "a condition" };
    let message = format!("{what} is not written with `{found}`");
    Some(
        Diagnostic::error("mavc::syntax::relation", span, message)
            .here(format!("expected `{instead}`"))
            .help(format!("write `{instead}`"))
            .fix(span, instead),
    )
}

/// `arm = 0,211 m`
fn decimal_comma(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let bytes = statement.text.as_bytes();
    let at = failure.at;
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    if bytes.get(at) != Some(&b',') || at == 0 || !digit(at - 1) || !digit(at + 1) {
        return None;
    }
    let start = statement.text[..at].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |i| i + 1);
    let end = at + 1 + bytes[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    let number = cut(&statement.text[start..end]);
    Some(
        Diagnostic::error("mavc::syntax::number", statement.span(start, end), "a number has a decimal point, no comma")
            .here("a comma separates the elements of a list")
            .help(format!("write `{}`", number.replace(',', ".")))
            .fix(statement.span(at, at + 1), "."),
    )
}

/// `against = M1, M2`
fn listless(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (name, values) = statement.text.split_once('=')?;
    let is_field = !statement.has_body && name.trim_end().chars().all(is_name) && failure.expects(Expected::End);
    if statement.found(failure.at) != "," || !is_field || values.contains('=') {
        return None;
    }
    let span = statement.span(failure.at, failure.at + 1);
    let diagnostic = Diagnostic::error("mavc::syntax::unexpected", span, "several values stand in a list, in `[ ]`")
        .here("separates the elements of a list");
    let values = values.trim();
    Some(match values.chars().all(|c| is_name(c) || ", ".contains(c)) && values.len() <= 48 {
        true => {
            let start = statement.text.len() - statement.text[name.len() + 1..].trim_start().len();
            let list = format!("[{values}]");
            diagnostic.help(format!("write `{list}`")).fix(statement.span(start, start + values.len()), list)
        }
        false => {
            let start = statement.text.len() - statement.text[name.len() + 1..].trim_start().len();
            let span = statement.span(start, start + values.len());
            diagnostic.help("put them into `[ ]`, as in `[1, 2, 3] m`").fix(span, format!("[{values}]"))
        }
    })
}

/// `.5`, `5.`, `1.2.3`
fn number_point(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let bytes = statement.text.as_bytes();
    let at = failure.at;
    if at > 0 && bytes[at - 1].is_ascii_digit() && bytes.get(at) == Some(&b'_') {
        let found = statement.found(at);
        let span = statement.span(at, at + found.len());
        let diagnostic = Diagnostic::error("mavc::syntax::number", span, "a number is written without `_`");
        let start = statement.text[..at].rfind(|c: char| !(is_name(c) || c == '.')).map_or(0, |i| i + 1);
        let whole = &statement.text[start..at + found.len()];
        let mended = whole.replace('_', "");
        let diagnostic = diagnostic.here("not expected in a number");
        return Some(match mended.chars().all(|c| c.is_ascii_digit() || c == '.') {
            true => diagnostic
                .help(format!("write `{}`", cut(&mended)))
                .fix(statement.span(start, start + whole.len()), mended),
            false => diagnostic.help("leave out the `_`"),
        });
    }
    if bytes.get(at) != Some(&b'.') || bytes.get(at + 1) == Some(&b'.') || statement.text[..at].ends_with('.') {
        return None;
    }
    let digit = |b: Option<&u8>| b.is_some_and(u8::is_ascii_digit);
    let (before, after) = (at > 0 && digit(bytes.get(at - 1)), digit(bytes.get(at + 1)));
    let start = statement.text[..at].rfind(|c: char| !(c.is_ascii_digit() || c == '.')).map_or(0, |i| i + 1);
    let end = at + statement.text[at..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(bytes.len() - at);
    let span = statement.span(start, end);
    let error = |message: &str| Diagnostic::error("mavc::syntax::number", span, message);
    let number = cut(&statement.text[start..end]);
    Some(match (before, after) {
        (false, true) => error("a number begins with a digit")
            .here("no digit before the point")
            .help(format!("write `0{number}`"))
            .fix(statement.span(at, at), "0"),
        (true, false) => error("a number ends with a digit")
            .here("no digit after the point")
            .help(format!("write `{number}0`"))
            .fix(statement.span(at + 1, at + 1), "0"),
        (true, true) => error("a number has one point").here("more than one point").help("remove all but one"),
        (false, false) => return None,
    })
}

/// `1 m to 30 m`, `1...3`, and `0 .. 1 points = 2` in a curve's head
fn range_marks(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let three = found == "." && statement.text[..failure.at].ends_with("..");
    if statement.word() == "curve" && found == "=" && failure.expects(Expected::End) {
        let (start, word) = statement.before(failure.at);
        let message = format!("a comma is missing before `{}`", cut(word));
        return Some(
            Diagnostic::error("mavc::syntax::unexpected", statement.span(start, start + word.len()), message)
                .here("expected `,` before this")
                .help("write `,` after the range")
                .fix(statement.span(start, start), ", "),
        );
    }
    if let Some(diagnostic) = curve_head(statement, failure) {
        return Some(diagnostic);
    }
    let instead_of = match found {
        "to" if failure.expects(Expected::Operator) => "to",
        _ if three => "...",
        _ => return None,
    };
    let start = if three { failure.at - 2 } else { failure.at };
    let span = statement.span(start, start + instead_of.len());
    Some(
        Diagnostic::error("mavc::syntax::range", span, format!("a range is written with `..`, not `{instead_of}`"))
            .here("expected `..`")
            .help("write `..`")
            .fix(span, ".."),
    )
}

/// `curve in 0 .. 1`, `curve s = 0 .. 1`, `curve s in 0 .. 1, points 21`
fn curve_head(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (_, before) = statement.before(failure.at);
    if statement.word() != "curve" {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let here = statement.span(failure.at, failure.at);
    let error = |message: String| Diagnostic::error("mavc::syntax::unexpected", span, message);
    match found {
        "in" if before == "curve" => Some(
            error("`curve` names no parameter".into())
                .here("a name must stand before this")
                .help("write it like `curve s in 0 .. 2*pi`")
                .fix(here, "s "),
        ),
        "=" | ":" if failure.expects(Expected::Word("in")) => Some(
            error(format!("the range of `{}` is given with `in`, not `{found}`", cut(before)))
                .here("expected `in`")
                .help("write `in`")
                .fix(span, "in"),
        ),
        _ if failure.expects(Expected::Equals) && found.starts_with(|c: char| c.is_ascii_digit()) => Some(
            error(format!("`{}` has no `=` before its value", cut(before)))
                .here("expected `=` before this")
                .help(format!("write `{} = {}`", cut(before), cut(found)))
                .fix(here, "= "),
        ),
        _ => None,
    }
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
        return Some(error.help("write `at [x, y, z]`, the unit behind it").fix(whole, format!("at [{inside}]")));
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
        error("no comma stands between the clauses of a statement")
            .here("not expected")
            .help("remove it; blanks separate clauses")
            .fix(span, "")
    })
}

/// `s**2`
fn double_star(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let at = failure.at;
    if at == 0 || !statement.text[at - 1..].starts_with("**") {
        return None;
    }
    let span = statement.span(at - 1, at + 1);
    Some(
        Diagnostic::error("mavc::syntax::power", span, "powers are written with `^`, not `**`")
            .here("expected `^`")
            .help("write `^`")
            .fix(span, "^"),
    )
}

/// `0.5 N m`: a unit is one run without blanks.
fn spaced_unit(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    if !failure.expects(Expected::Operator) || !(found.starts_with(is_name) || found == "%") {
        return None;
    }
    // Longer words, and these, are no units but the beginning of something else.
    let short = found.len() <= 3 && !["and", "or", "to", "of", "for", "let", "use", "as"].contains(&found);
    if found.starts_with(|c: char| c.is_ascii_digit()) || CLAUSES.contains(&found) || !short {
        return None;
    }
    let before = statement.text[..failure.at].trim_end();
    let start = before.rfind(|c: char| !(is_name(c) || "*/^%".contains(c))).map_or(0, |i| i + 1);
    let unit = &before[start..];
    let follows_operand = before[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || c == ')' || c == ']');
    if !follows_operand || !unit.starts_with(|c: char| c.is_ascii_alphabetic() || c == '%') {
        return None;
    }
    let found = token(statement.text, failure.at, |c| is_name(c) || "*/^%".contains(c));
    // `s^-1`, where the sign belongs to the exponent.
    let exponent = statement.text[failure.at + found.len()..].strip_prefix('-').filter(|_| found.ends_with('^'));
    let digits = exponent.map_or("", |rest| token(rest, 0, |c| c.is_ascii_digit()));
    let end = failure.at + found.len() + if digits.is_empty() { 0 } else { 1 + digits.len() };
    let span = statement.span(start, end);
    let whole = &statement.text[failure.at..end];
    let (unit, found) = (cut(unit), cut(whole));
    if let Some((word, _)) = whole.split_once("^-").filter(|(word, _)| word.chars().all(is_name)) {
        let factor = if digits == "1" { word.to_string() } else { format!("{word}^{digits}") };
        let mended = format!("{unit}/{}", cut(&factor));
        return Some(
            Diagnostic::error("mavc::syntax::unit_blank", span, format!("the unit `{unit} {found}` has a blank in it"))
                .here("a unit is one run without blanks")
                .help(format!("write `{mended}`, which is `{unit}*{found}`"))
                .fix(span, mended),
        );
    }
    Some(
        Diagnostic::error("mavc::syntax::unit_blank", span, format!("the unit `{unit} {found}` has a blank in it"))
            .here("a unit is one run without blanks")
            .help(format!("write `{unit}*{found}` for a product, `{unit}/{found}` for a quotient"))
            .fix(span, format!("{unit}*{found}")),
    )
}

/// `a m` with a name: only numbers and brackets take a unit.
fn unit_after_name(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (start, name) = statement.before(failure.at);
    let word = |w: &str| w.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if !failure.expects(Expected::Operator) || !word(name) || !(word(found) || found == "%") {
        return None;
    }
    // What stands before may be the end of a unit.
    let is_unit = statement.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || ")]*/^".contains(c));
    if is_unit || statement.place.openers().contains(&found) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let (name, found) = (cut(name), cut(found));
    let whole = statement.span(start, failure.at + found.len());
    let diagnostic =
        Diagnostic::error("mavc::syntax::unexpected", span, format!("`{found}` cannot follow the name `{name}`"))
            .here("an operator must stand before this")
            .also(statement.span(start, start + name.len()), "a unit follows a number, `)` or `]`, never a name");
    Some(match found.as_str() {
        "%" => diagnostic.help(format!("write `({name}) %`")).fix(whole, format!("({name}) %")),
        _ => {
            diagnostic.help(format!("write `{name}*{found}` to multiply, or `({name}) {found}` if `{found}` is a unit"))
        }
    })
}

/// `[1 2 3]`
fn list_comma(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    if !failure.expects(Expected::Comma) || !found.starts_with(|c: char| is_name(c) || "\"([".contains(c)) {
        return None;
    }
    if !failure.expects(Expected::Closing(']')) && !failure.expects(Expected::Closing(')')) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let gap = statement.text[..failure.at].trim_end().len();
    let error = Diagnostic::error("mavc::syntax::unexpected", span, "a comma is missing between two elements")
        .here("expected `,` before this")
        .help("write `,` between them");
    // Bare numbers up to the end of the list lack every comma.
    let rest = &statement.text[failure.at..];
    let others: Vec<&str> = rest.split(']').next().unwrap_or("").split_whitespace().collect();
    let bare = others.iter().all(|n| n.starts_with(|c: char| c.is_ascii_digit() || c == '-') && !n.contains(','));
    Some(match bare && rest.contains(']') && !others.is_empty() {
        true => {
            let end = failure.at + rest.find(']').unwrap_or(0);
            error.fix(statement.span(gap, end), format!(", {}", others.join(", ")))
        }
        false => error.fix(statement.span(gap, failure.at), ", "),
    })
}

/// A misspelt word inside a statement: `rotor 3 reduce to 60 %`, `witin 10 cm`.
fn misspelt_word(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let mut words: Vec<&str> = Vec::new();
    for expected in &failure.expected {
        match expected {
            Expected::Word(word) => words.push(word),
            Expected::Effect => words.extend(["lost", "reduced", "stuck"]),
            Expected::Clause => words.extend(CLAUSES),
            _ => {}
        }
    }
    // The word before may be the culprit: after a number any word looks like a unit.
    let found = statement.found(failure.at);
    let before = statement.before(failure.at);
    let after_number = failure.expects(Expected::Effect) && !words.contains(&before.1);
    let candidates = [(failure.at, found), if after_number { before } else { (failure.at, "") }];
    let (at, word, meant) = candidates.into_iter().find_map(|(at, word)| {
        let is_word = word.starts_with(|c: char| c.is_ascii_alphabetic());
        nearest(word, words.iter().copied()).filter(|_| is_word).map(|meant| (at, word, meant))
    })?;
    let span = statement.span(at, at + word.len());
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("`{}` cannot stand here", cut(word)))
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
