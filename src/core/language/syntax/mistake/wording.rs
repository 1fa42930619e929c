//! Words, marks and brackets that people bring along from speech, drawings and data files.

use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, is_clause};
use crate::syntax::cut;

/// Tried before the habits that apply to any statement; each looks for one wording.
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
    super::effect::rotor_numbers,
    super::effect::motors,
    super::effect::choice,
    super::effect::effect_word,
    super::effect::reduced_by,
    joined_conditions,
    per,
    limit_range,
    indexed,
    positive_sign,
    super::clause::of_waypoint,
    super::effect::all_rotors,
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
    let diagnostic = unexpected(statement, failure.at, failure.at + 1, format!("`{word}` takes no `:`"));
    let diagnostic = diagnostic.here("not expected");
    let form = super::form(word, statement.place).unwrap_or(word);
    Some(match is_block {
        true => diagnostic.help(format!("a block takes braces: `{}`", form.split(" {").next()?.to_owned() + " { .. }")),
        false => diagnostic.help("remove it").fix(statement.span(failure.at, failure.at + 1), ""),
    })
}

/// `use parts/quad.mav`
fn bare_path(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let path = statement.text[failure.at..].trim_end();
    let is_path = path.ends_with(".mav") && path.chars().all(|c| is_name(c) || "./-\\".contains(c));
    (statement.word() == "use" && is_path && statement.before(failure.at).1 == "use").then(|| {
        let end = failure.at + path.len();
        unexpected(statement, failure.at, end, "a path needs double quotes")
            .here("no quotes")
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
    let fixed = name.replace('-', "_");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, format!("the name `{}` has a `-` in it", cut(name)))
            .here("a name is made of letters, digits and `_`")
            .help(format!("write `{}`", cut(&fixed)))
            .fix(span, fixed),
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
        Diagnostic::error("mavc::syntax::unexpected", span, "`in` is not a unit")
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
        unexpected(statement, start, start + word.len(), "there is a word between `hold` and its time")
            .here("not expected")
            .help(format!("write `hold {}`", cut(value)))
            .fix(statement.span(start, failure.at), "")
    })
}

/// `2 pi m`, `2*pi m`: a unit follows a number or parentheses.
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
    if !number.starts_with(|c: char| c.is_ascii_digit()) || is_clause(unit) || is_field {
        return None;
    }
    let span = statement.span(from, failure.at + unit.len());
    let fixed = format!("({number}*pi) {unit}");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, "`pi` is a name, and a name takes no unit")
            .here("a unit follows a number, `)` or `]`, not a name")
            .help(format!("write `{}`", cut(&fixed)))
            .fix(span, fixed),
    )
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
    let fixed = format!("in {low} .. {high}");
    Some(
        Diagnostic::error("mavc::syntax::range", span, "a limit takes a range with `in` and `..`")
            .here("expected `in` before this")
            .help(format!("write `{}`", cut(&format!("{name} {fixed}"))))
            .fix(span, fixed),
    )
}

/// `k[0]`, as in other languages
fn indexed(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, name) = statement.before(failure.at);
    let touches = start + name.len() == failure.at && name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if statement.found(failure.at) != "[" || !touches || !failure.expects(Expected::Operator) {
        return None;
    }
    // What comes before may be the unit of a number.
    if statement.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || ")]*/^".contains(c)) {
        return None;
    }
    let end = statement.text[failure.at..].find(']').map_or(failure.at + 1, |i| failure.at + i + 1);
    Some(
        unexpected(statement, failure.at, end, "an element of a list cannot be selected by its number")
            .here(format!("follows the name `{}`", cut(name)))
            .help("give the element a name of its own with `let`, and write that name here"),
    )
}

/// `+5 m`
fn positive_sign(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let value = statement.text[failure.at..].strip_prefix('+')?;
    let begins = value.trim_start().starts_with(|c: char| is_name(c) || c == '(');
    (failure.expects(Expected::Value) && begins).then(|| {
        unexpected(statement, failure.at, failure.at + 1, "a value must not begin with `+`")
            .here("not expected")
            .help("remove the `+`")
            .fix(statement.span(failure.at, failure.at + 1), "")
    })
}

/// `arm = 0.2 m,` at the end of a line
fn comma_at_end(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_last = statement.text[failure.at..].trim_end() == ",";
    (is_last && failure.expects(Expected::End)).then(|| {
        let span = statement.span(failure.at, failure.at + 1);
        Diagnostic::error("mavc::syntax::unexpected", span, "a statement does not end with a comma")
            .here("not expected")
            .help("remove it: the end of the line is enough")
            .fix(span, "")
    })
}
