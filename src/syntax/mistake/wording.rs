//! Words, marks and brackets that people bring along from speech, drawings and data files.

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::Place;
use crate::source::Span;
use crate::syntax::cut;

/// Asked before the habits that hold for any statement; each looks for one wording.
pub(super) const WORDINGS: &[fn(&Broken, &Failure) -> Option<Diagnostic>] = &[
    keyword_colon,
    super::strike::recognise,
    super::clause::of_rotor,
    super::flight::landing,
    super::flight::takeoff,
    bare_path,
    name_form,
    inch,
    hold_for,
    pi_and_unit,
    super::list::range_in_parentheses,
    super::list::position_in_parentheses,
    super::list::position_without_brackets,
    super::list::listed_names,
    rotor_numbers,
    motors,
    choice,
    effect_word,
    reduced_by,
    joined_conditions,
    per,
    limit_range,
    indexed,
    positive_sign,
    super::clause::of_waypoint,
    all_rotors,
    comma_at_end,
];

pub(super) fn unexpected(statement: &Broken, from: usize, to: usize, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("mavc::syntax::unexpected", statement.span(from, to), message)
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
    let diagnostic = unexpected(statement, failure.at, failure.at + 1, format!("no `:` follows `{word}`"));
    let diagnostic = diagnostic.here("not expected");
    let form = super::form(word, statement.place).unwrap_or(word);
    Some(match is_block {
        true => {
            diagnostic.help(format!("a block stands in braces: `{}`", form.split(" {").next()?.to_owned() + " { .. }"))
        }
        false => diagnostic.help("remove it").fix(statement.span(failure.at, failure.at + 1), ""),
    })
}

/// `use parts/quad.mav`
fn bare_path(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let path = statement.text[failure.at..].trim_end();
    let is_path = path.ends_with(".mav") && path.chars().all(|c| is_name(c) || "./-\\".contains(c));
    (statement.word() == "use" && is_path && statement.before(failure.at).1 == "use").then(|| {
        let end = failure.at + path.len();
        unexpected(statement, failure.at, end, "a path stands in double quotes")
            .here("has none")
            .help(format!("write `use \"{}\"`", cut(path)))
            .fix(statement.span(failure.at, end), format!("\"{path}\""))
    })
}

/// `mission my-mission {`, `mission 3d {`
fn name_form(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (start, before) = statement.before(failure.at);
    let is_head = statement.has_body && Place::of_block(statement.word()).is_some();
    let end = failure.at + token(statement.text, failure.at, |c| is_name(c) || c == '-').len();
    let is_field = start == 0 && !statement.has_body && statement.text[end..].trim_start().starts_with('=');
    let declares = is_head || is_field || statement.word() == "let";
    if is_head && failure.expects(Expected::Name) && found.starts_with(|c: char| c.is_ascii_digit()) {
        let message = format!("the name `{}` begins with a digit", cut(found));
        let diagnostic = unexpected(statement, failure.at, failure.at + found.len(), message);
        let at = statement.span(failure.at, failure.at);
        return Some(diagnostic.here("a letter comes first").help("begin it with a letter or `_`").fix(at, "_"));
    }
    let follows = statement.text.as_bytes().get(failure.at + 1).is_some_and(u8::is_ascii_alphanumeric);
    let touches = failure.at > 0 && is_name(statement.text.as_bytes()[failure.at - 1] as char);
    if !declares || found != "-" || !follows || !touches || !before.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let name = token(statement.text, start, |c| is_name(c) || c == '-');
    let span = statement.span(start, start + name.len());
    let mended = name.replace('-', "_");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("the name `{}` has a `-` in it", cut(name)))
            .here("a name is made of letters, digits and `_`")
            .help(format!("write `{}`", cut(&mended)))
            .fix(span, mended),
    )
}

/// `arm = 8 in`: a keyword, so no unit.
fn inch(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (_, before) = statement.before(failure.at);
    let after_value = before.starts_with(|c: char| c.is_ascii_digit() || c == ')' || c == ']');
    if statement.found(failure.at) != "in" || !failure.expects(Expected::Operator) || !after_value {
        return None;
    }
    let span = statement.span(failure.at, failure.at + 2);
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, "`in` is no unit")
            .here("a word of the language")
            .help("the inch is written `inch`")
            .fix(span, "inch"),
    )
}

/// `hold for 3 s`, where any word looks like the name of a time.
fn hold_for(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, word) = statement.before(failure.at);
    let is_filler = matches!(word, "for" | "about" | "at" | "during" | "of" | "still");
    let follows = statement.text[..start].trim_end() == "hold";
    let value = statement.text[failure.at..].trim_end();
    (statement.word() == "hold" && is_filler && follows && !value.is_empty()).then(|| {
        unexpected(statement, start, start + word.len(), "a word between `hold` and its time")
            .here("not expected")
            .help(format!("write `hold {}`", cut(value)))
            .fix(statement.span(start, failure.at), "")
    })
}

/// `rotors 1, 2 lost`, `rotors 1 and 2 lost`
fn rotor_numbers(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_fault = matches!(statement.word(), "rotor" | "rotors") && failure.expects(Expected::Effect);
    let found = statement.found(failure.at);
    let (start, before) = statement.before(failure.at);
    let at = match (found, before) {
        (_, "and" | "or") => start,
        ("," | "and" | "or" | "&" | "&&" | "-", _) => failure.at,
        _ => return None,
    };
    let mark = token(statement.text, at, |c| is_name(c) || "&,-".contains(c));
    let diagnostic = unexpected(statement, at, at + mark.len().max(1), "several rotors stand in a list");
    let diagnostic = diagnostic.here("does not join rotors").help("write them like `rotors [1, 2] lost`");
    if !is_fault {
        return None;
    }
    // `1, 2 and 3`
    let numbers = statement.text[statement.word().len()..].trim_start();
    let from = statement.text.len() - numbers.len();
    let effects = ["lost", "reduced", "stuck"].into_iter().filter_map(|word| numbers.find(word));
    let Some(end) = effects.min() else { return Some(diagnostic) };
    let listed = numbers[..end].trim_end();
    let each: Vec<&str> =
        listed.split([',', '&']).flat_map(|part| part.split("and")).map(str::trim).filter(|n| !n.is_empty()).collect();
    let plain = each.len() > 1 && each.iter().all(|n| n.chars().all(|c| c.is_ascii_digit()));
    Some(match plain {
        true => diagnostic.fix(statement.span(from, from + listed.len()), format!("[{}]", each.join(", "))),
        false => diagnostic,
    })
}

/// `2 pi m`, `2*pi m`: a unit goes with a number or with what stands in parentheses.
fn pi_and_unit(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    let unit = token(statement.text, failure.at, |c| is_name(c) || "*/^".contains(c));
    if before != "pi" || !failure.expects(Expected::Operator) || !unit.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let head = statement.text[..start].trim_end();
    let factor = |c: char| is_name(c) || ".*/".contains(c);
    let from = head.rfind(|c| !factor(c)).map_or(0, |i| i + 1);
    let number = head[from..].trim_end_matches('*');
    // Otherwise it is a name, or more than a product.
    let is_field = statement.text[failure.at + unit.len()..].trim_start().starts_with('=');
    if !number.starts_with(|c: char| c.is_ascii_digit()) || super::CLAUSES.contains(&unit) || is_field {
        return None;
    }
    let span = statement.span(from, failure.at + unit.len());
    let mended = format!("({number}*pi) {unit}");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, "`pi` is a number by name, and takes no unit")
            .here("a unit follows a number, `)` or `]`, never a name")
            .help(format!("write `{}`", cut(&mended)))
            .fix(span, mended),
    )
}

/// `every 1 motor lost as M`, where any word after a number looks like a unit.
fn motors(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, word) = statement.before(failure.at);
    let is_rotor = matches!(word, "motor" | "motors" | "propeller" | "propellers" | "prop" | "props");
    (statement.word() == "every" && is_rotor && failure.expects(Expected::Word("rotors"))).then(|| {
        let span = statement.span(start, start + word.len());
        let ours = if word.ends_with('s') { "rotors" } else { "rotor" };
        unexpected(statement, start, start + word.len(), format!("no `{word}` stands in an `every`"))
            .here(format!("expected `{ours}`"))
            .help(format!("write `{ours}`"))
            .fix(span, ours)
    })
}

/// `every 2 neighbours lost as W`, where any word after a number looks like a unit.
fn choice(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, word) = statement.before(failure.at);
    let is_word = word.starts_with(|c: char| c.is_ascii_alphabetic());
    let follows_number = statement.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit());
    let is_choice =
        statement.word() == "every" && is_word && follows_number && failure.expects(Expected::Word("rotors"));
    is_choice.then(|| no_choice(statement.span(start, start + word.len()), word))
}

/// The error for a word that would restrict which rotors an `every` covers.
pub fn no_choice(span: Span, word: &str) -> Diagnostic {
    let word = cut(word);
    Diagnostic::error(
        "mavc::syntax::unexpected",
        span,
        format!("`every` cannot select rotors by `{word}`"),
    )
    .here("expected `rotors`")
    .help("`every 2 rotors` covers every pair; to cover only some, write a mode for each: `mode W1 { rotors [1, 2] lost }`")
}

/// `rotor 1 fails`, where any word after a number looks like a unit.
fn effect_word(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if !matches!(statement.word(), "rotor" | "rotors" | "every") || !failure.expects(Expected::Effect) {
        return None;
    }
    let (start, before) = statement.before(failure.at);
    let number = |text: &str| text.trim_end().ends_with(|c: char| c.is_ascii_digit() || c == ']');
    let found = statement.found(failure.at);
    let is_word = |w: &str| w.starts_with(|c: char| c.is_ascii_alphabetic());
    let (at, word) = match () {
        _ if is_word(before) && number(&statement.text[..start]) && !matches!(before, "rotor" | "rotors") => {
            (start, before)
        }
        _ if is_word(found) => (failure.at, found),
        _ => return None,
    };
    let meant = match word {
        "fails" | "failed" | "fail" | "failing" | "failure" | "dead" | "dies" | "off" | "out" | "broken" | "gone"
        | "missing" | "stops" => "lost",
        "jammed" | "locked" | "fixed" | "frozen" => "stuck at 50 %",
        "limited" | "degraded" | "weak" | "worn" | "down" => "reduced to 60 %",
        _ if nearest(word, ["lost", "reduced", "stuck"]).is_some() => return None,
        _ => "",
    };
    let message = format!("`{}` is not said of a rotor", cut(word));
    let diagnostic = unexpected(statement, at, at + word.len(), message);
    let diagnostic = diagnostic.here("expected `lost`, `reduced to` or `stuck at`");
    Some(match meant {
        "" if statement.word() == "every" => diagnostic.help("write it like `every 1 rotor lost as M`"),
        "" => diagnostic.help("write it like `rotor 3 lost`, `rotor 3 reduced to 60 %` or `rotor 3 stuck at 50 %`"),
        meant => diagnostic.help(format!("write `{meant}`")).fix(statement.span(at, at + word.len()), meant),
    })
}

/// `rotor 1 reduced by 10 %`
fn reduced_by(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_by = statement.found(failure.at) == "by" && statement.before(failure.at).1 == "reduced";
    if !is_by {
        return None;
    }
    let message = "a rotor is reduced `to` what is left, not `by` what is lost";
    let diagnostic = unexpected(statement, failure.at, failure.at + 2, message).here("expected `to`");
    let rest = statement.text[failure.at + 2..].trim_start();
    let digits = token(rest, 0, |c| c.is_ascii_digit());
    let unit = rest[digits.len()..].trim_start();
    Some(match digits.parse::<u32>().ok().filter(|lost| *lost <= 100 && unit.starts_with('%')) {
        Some(lost) => {
            let mended = format!("to {} %", 100 - lost);
            let end = statement.text.len() - unit.len() + 1;
            diagnostic.help(format!("write `{mended}`")).fix(statement.span(failure.at, end), mended)
        }
        None => diagnostic.help("say what is left: a tenth lost is `reduced to 90 %`"),
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

/// `1e-5 per hour`
fn per(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    let (at, found) = (failure.at, statement.found(failure.at));
    let at = if before == "per" { start } else { at };
    let is_word = before == "per" || found == "per";
    if !is_word || !failure.expects(Expected::Operator) {
        return None;
    }
    let diagnostic = unexpected(statement, at, at + 3, "`per` is written `/`")
        .here("a word, where a unit is one run of names and marks")
        .help("write units like `m/s` or `1/h`");
    let (_, counted) = statement.before(at);
    let rest = &statement.text[at + 3..];
    let unit = token(rest.trim_start(), 0, is_name);
    let slash = if counted.ends_with(|c: char| c.is_ascii_digit()) { " 1/" } else { "/" };
    let known = match unit {
        "hour" => "h",
        "second" | "sec" => "s",
        "minute" => "min",
        short => short,
    };
    let from = statement.text[..at].trim_end().len();
    let end = statement.text.len() - rest.trim_start().len() + unit.len();
    Some(match unit.is_empty() {
        true => diagnostic,
        false => diagnostic.fix(statement.span(from, end), format!("{slash}{known}")),
    })
}

/// `altitude 1..3 m`, `altitude between 1 m and 3 m`
fn limit_range(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if statement.place != Place::Limits || !failure.expects(Expected::Relation) {
        return None;
    }
    let rest = statement.text[failure.at..].trim_end();
    let value = rest.strip_prefix("between ").or_else(|| rest.strip_prefix("from ")).unwrap_or(rest).trim_start();
    let joints = if value.len() < rest.len() { [" and ", " to ", ".."].as_slice() } else { &[" to ", ".."] };
    let (low, high) = joints.iter().find_map(|joint| value.split_once(joint))?;
    let (low, high) = (low.trim(), high.trim());
    let begins = |end: &str| end.starts_with(|c: char| c.is_ascii_alphanumeric() || "-(".contains(c));
    if !begins(low) || !begins(high) || high.contains("..") {
        return None;
    }
    let name = statement.text[..failure.at].trim_end();
    let span = statement.span(failure.at, failure.at + rest.len());
    let mended = format!("in {low} .. {high}");
    Some(
        Diagnostic::error("mavc::syntax::range", span, "a limit takes a range with `in` and `..`")
            .here("expected `in` before this")
            .help(format!("write `{}`", cut(&format!("{name} {mended}"))))
            .fix(span, mended),
    )
}

/// `k[0]`, as in other languages
fn indexed(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, name) = statement.before(failure.at);
    let touches = start + name.len() == failure.at && name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if statement.found(failure.at) != "[" || !touches || !failure.expects(Expected::Operator) {
        return None;
    }
    // What stands before may be the unit of a number.
    if statement.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || ")]*/^".contains(c)) {
        return None;
    }
    let end = statement.text[failure.at..].find(']').map_or(failure.at + 1, |i| failure.at + i + 1);
    Some(
        unexpected(statement, failure.at, end, "an element of a list cannot be asked for by its number")
            .here(format!("follows the name `{}`", cut(name)))
            .help("give the element a name of its own with `let`, and write that name here"),
    )
}

/// `+5 m`
fn positive_sign(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let value = statement.text[failure.at..].strip_prefix('+')?;
    let begins = value.trim_start().starts_with(|c: char| is_name(c) || c == '(');
    (failure.expects(Expected::Value) && begins).then(|| {
        unexpected(statement, failure.at, failure.at + 1, "a value has no sign `+`")
            .here("not expected")
            .help("take the `+` out")
            .fix(statement.span(failure.at, failure.at + 1), "")
    })
}

/// `all rotors lost`
fn all_rotors(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let is_all = statement.place == Place::Mode && matches!(statement.word(), "all" | "both" | "any");
    let word = statement.word();
    is_all.then(|| {
        unexpected(statement, 0, word.len(), format!("no fault begins with `{word}`"))
            .here("expected `rotor` or `rotors`")
            .help("say which rotors: `rotors [1, 2] lost`")
    })
}

/// `arm = 0.2 m,` at the end of a line
fn comma_at_end(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_last = statement.text[failure.at..].trim_end() == ",";
    (is_last && failure.expects(Expected::End)).then(|| {
        let span = statement.span(failure.at, failure.at + 1);
        Diagnostic::error("mavc::syntax::unexpected", span, "no comma ends a statement")
            .here("not expected")
            .help("remove it: the end of the line is enough")
            .fix(span, "")
    })
}
