//! Habits in values: numbers, lists, ranges and units as other formats write them.

use super::super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::Diagnostic;
use crate::language::is_clause;
use crate::syntax::cut;

/// `arm = 0,211 m`, `max_speed = 8,500 rpm`
pub(super) fn decimal_comma(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let bytes = statement.text.as_bytes();
    let at = failure.at;
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    if bytes.get(at) != Some(&b',') || at == 0 || !digit(at - 1) || !digit(at + 1) {
        return None;
    }
    let start = statement.text[..at].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |i| i + 1);
    let end = at + 1 + bytes[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    let number = cut(&statement.text[start..end]);
    let error = |end: usize, message: &str| {
        Diagnostic::error("mavc::syntax::number", statement.span(start, end), message)
            .here("a comma separates the elements of a list")
    };
    if let Some((end, is_certain)) = grouped(statement.text, start, at) {
        let whole = statement.text[start..end].replace(',', "");
        let error = error(end, "a number is written without a comma");
        return Some(match is_certain {
            true => error.help(format!("write `{}`", cut(&whole))).fix(statement.span(start, end), whole),
            false => error.help(format!("write `{whole}` for thousands, or `{}`", decimal(&number))),
        });
    }
    Some(
        error(end, "a number has a decimal point, not a comma")
            .help(format!("write `{}`", number.replace(',', ".")))
            .fix(statement.span(at, at + 1), "."),
    )
}

/// `8,500` as a decimal number, `8.5`.
fn decimal(number: &str) -> String {
    number.replace(',', ".").trim_end_matches('0').trim_end_matches('.').to_string()
}

/// Where a number in groups of three ends, `8,500` or `1,250,000.5`, whose first comma is `at`; and whether the commas
/// cannot be decimal ones. `None` where they can be nothing else.
fn grouped(text: &str, start: usize, at: usize) -> Option<(usize, bool)> {
    let digits = |from: usize| token(text, from, |c| c.is_ascii_digit()).len();
    if !(1..=3).contains(&(at - start)) || text[start..].starts_with('0') {
        return None;
    }
    let (mut end, mut groups) = (at, 0);
    while text[end..].starts_with(',') && digits(end + 1) == 3 {
        end += 4;
        groups += 1;
    }
    let fraction = if text[end..].starts_with('.') { digits(end + 1) } else { 0 };
    let whole = if fraction > 0 { end + 1 + fraction } else { end };
    (groups > 0 && digits(end) == 0).then_some((whole, groups > 1 || fraction > 0))
}

/// `against = M1, M2`
pub(super) fn listless(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (name, values) = statement.text.split_once('=')?;
    let is_field = !statement.has_body && name.trim_end().chars().all(is_name) && failure.expects(Expected::End);
    if statement.found(failure.at) != "," || !is_field || values.contains('=') {
        return None;
    }
    let span = statement.span(failure.at, failure.at + 1);
    let diagnostic = Diagnostic::error("mavc::syntax::unexpected", span, "several values need a list, in `[ ]`")
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
pub(super) fn number_point(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let bytes = statement.text.as_bytes();
    let at = failure.at;
    if at > 0 && bytes[at - 1].is_ascii_digit() && bytes.get(at) == Some(&b'_') {
        let found = statement.found(at);
        let span = statement.span(at, at + found.len());
        let diagnostic = Diagnostic::error("mavc::syntax::number", span, "a number is written without `_`");
        let start = statement.text[..at].rfind(|c: char| !(is_name(c) || c == '.')).map_or(0, |i| i + 1);
        let whole = &statement.text[start..at + found.len()];
        let fixed = whole.replace('_', "");
        let diagnostic = diagnostic.here("not expected in a number");
        return Some(match fixed.chars().all(|c| c.is_ascii_digit() || c == '.') {
            true => diagnostic
                .help(format!("write `{}`", cut(&fixed)))
                .fix(statement.span(start, start + whole.len()), fixed),
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
    if before && after && statement.text[..start].ends_with('^') && !statement.text[start..at].contains('.') {
        return Some(unit_exponent(statement, start, at, end));
    }
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

/// `5 m^2.5`: only a unit's exponent ends before its point. It is at `start..end`, the point at `at`.
fn unit_exponent(statement: &Broken, start: usize, at: usize, end: usize) -> Diagnostic {
    let span = statement.span(start, end);
    let error = Diagnostic::error("mavc::unit::exponent", span, "the exponent of a unit is a whole number");
    let error = error.here("has a decimal point");
    let whole = &statement.text[start..at];
    match statement.text[at..end].trim_end_matches('0') {
        "." => error.help(format!("write `{}`", cut(whole))).fix(span, whole),
        _ => match whole.parse::<u32>() {
            Ok(below) if below < 1000 => error.help(format!("write `{below}` or `{}`", below + 1)),
            _ => error.help("write a whole number, as in `m^2`"),
        },
    }
}

/// `1 m to 30 m`, `1...3`, and `0 .. 1 points = 2` in a curve's head
pub(super) fn range_marks(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let three = found == "." && statement.text[..failure.at].ends_with("..");
    let begins_option = statement.text[failure.at + found.len()..].trim_start().starts_with('=');
    let option = match found {
        "=" => Some(statement.before(failure.at)),
        word if begins_option && word.starts_with(is_name) => Some((failure.at, word)),
        _ => None,
    };
    if let Some((start, word)) = option.filter(|_| statement.word() == "curve" && failure.expects(Expected::End)) {
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
                .here("expected a name before this")
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

/// `s**2`
pub(super) fn double_star(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
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
pub(super) fn spaced_unit(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    if !failure.expects(Expected::Operator) || !(found.starts_with(is_name) || found == "%") {
        return None;
    }
    if !is_factor(found) {
        return None;
    }
    let before = statement.text[..failure.at].trim_end();
    let start = before.rfind(|c: char| !(is_name(c) || "*/^%".contains(c))).map_or(0, |i| i + 1);
    let unit = &before[start..];
    let follows_operand = before[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || c == ')' || c == ']');
    if !follows_operand || !unit.starts_with(|c: char| c.is_ascii_alphabetic() || c == '%') {
        return None;
    }
    let (mut fixed, end) = joined(unit, statement.text, failure.at);
    // Nobody means a square by `ft ft`.
    let is_twice = statement.text[failure.at..end].trim() == unit;
    if is_twice {
        fixed = unit.to_string();
    }
    let span = statement.span(start, end);
    let divides = fixed[unit.len()..].starts_with('/');
    let (written, factor) = (cut(&statement.text[start..end]), cut(&statement.text[failure.at..end]));
    let (unit, shown) = (cut(unit), cut(&fixed));
    let help = match factor.contains([' ', '\t']) {
        _ if is_twice => format!("write it once: `{unit}`"),
        false if divides => format!("write `{shown}`, which is `{unit}*{factor}`"),
        false => {
            // `m2` is a power without its sign.
            let letters = factor.trim_end_matches(|c: char| c.is_ascii_digit());
            let factor = match &factor[letters.len()..] {
                _ if letters.ends_with('^') => factor,
                "" => factor,
                power => format!("{letters}^{power}"),
            };
            format!("write `{unit}*{factor}` for a product, `{unit}/{factor}` for a quotient")
        }
        true => format!("write `{shown}`, with `/` before what divides"),
    };
    Some(
        Diagnostic::error("mavc::syntax::unit_blank", span, format!("the unit `{written}` has a blank in it"))
            .here("a unit is one run without blanks")
            .help(help)
            .fix(span, fixed),
    )
}

/// Whether a word can be a factor of a unit; longer words, and some short ones, begin something else.
fn is_factor(word: &str) -> bool {
    let other = ["and", "or", "to", "of", "for", "let", "use", "as", "in"].contains(&word) || is_clause(word);
    word == "%" || word.len() <= 3 && word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') && !other
}

/// A unit and the factors that follow it from `at` on, in one run; and where they end. `s^-1` becomes a division.
fn joined(unit: &str, text: &str, mut at: usize) -> (String, usize) {
    let (mut whole, mut end) = (unit.to_string(), at);
    while is_factor(token(text, at, is_name)) || text[at..].starts_with('%') {
        let factor = token(text, at, |c| is_name(c) || "*/^%".contains(c));
        let exponent = text[at + factor.len()..].strip_prefix('-').filter(|_| factor.ends_with('^'));
        let power = exponent.map_or("", |rest| token(rest, 0, |c| c.is_ascii_digit()));
        let word = factor.trim_end_matches('^');
        end = at + factor.len() + if power.is_empty() { 0 } else { 1 + power.len() };
        match power {
            "" => whole += &format!("*{factor}"),
            "1" if word.chars().all(is_name) => whole += &format!("/{word}"),
            _ if word.chars().all(is_name) => whole += &format!("/{word}^{power}"),
            _ => whole += &format!("*{factor}-{power}"),
        }
        at = end + (text[end..].len() - text[end..].trim_start().len());
    }
    (whole, end)
}

/// `a m` with a name: only numbers and brackets take a unit.
pub(super) fn unit_after_name(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let (start, name) = statement.before(failure.at);
    let word = |w: &str| w.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if !failure.expects(Expected::Operator) || !word(name) || !(word(found) || found == "%") {
        return None;
    }
    // What comes before may be the end of a unit.
    let is_unit = statement.text[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || ")]*/^".contains(c));
    if is_unit || statement.place.openers().contains(&found) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let (name, found) = (cut(name), cut(found));
    let whole = statement.span(start, failure.at + found.len());
    let diagnostic =
        Diagnostic::error("mavc::syntax::unexpected", span, format!("`{found}` cannot follow the name `{name}`"))
            .here("expected an operator before this")
            .also(statement.span(start, start + name.len()), "a unit follows a number, `)` or `]`, not a name");
    Some(match found.as_str() {
        "%" => diagnostic.help(format!("write `({name}) %`")).fix(whole, format!("({name}) %")),
        _ => {
            diagnostic.help(format!("write `{name}*{found}` to multiply, or `({name}) {found}` if `{found}` is a unit"))
        }
    })
}

/// `[1 2 3]`
pub(super) fn list_comma(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
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
    // If only bare numbers follow in the list, all commas are missing.
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
