//! Habits in values: numbers, lists, ranges and units as other formats write them.

use super::super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::Diagnostic;
use crate::language::is_clause;
use crate::syntax::cut;

/// `arm = 0,211 m`, `max_speed = 8,500 rpm`
pub(super) fn decimal_comma(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (text, at) = (statement.text, failure.at);
    let digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    if !text[at..].starts_with(',') || at == 0 || !digit(at - 1) || !digit(at + 1) {
        return None;
    }
    let start = text[..at].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |i| i + 1);
    let number = token(text, start, |c| c.is_ascii_digit() || ",.".contains(c)).trim_end_matches([',', '.']);
    let groups: Vec<&str> = number.split('.').next().unwrap_or("").split(',').collect();
    // `8,500`, `1,250,000.5`
    let is_grouped =
        !number.starts_with('0') && groups[0].len() <= 3 && groups[1..].iter().all(|group| group.len() == 3);
    let span = statement.span(start, start + number.len());
    let (whole, decimal) = (number.replace(',', ""), cut(&number.replace(',', ".")));
    let error = |message| {
        Diagnostic::error("mavc::syntax::number", span, message).here("a comma separates the elements of a list")
    };
    Some(match (is_grouped, number.matches([',', '.']).count()) {
        (true, 1) => {
            error("a number is written without a comma").help(format!("write `{whole}` for thousands, or `{decimal}`"))
        }
        (true, _) => {
            error("a number is written without a comma").help(format!("write `{}`", cut(&whole))).fix(span, whole)
        }
        _ => error("a number has a decimal point, not a comma")
            .help(format!("write `{decimal}`"))
            .fix(statement.span(at, at + 1), "."),
    })
}

/// `against = M1, M2`
pub(super) fn listless(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (name, values) = statement.text.split_once('=')?;
    let is_field = !statement.has_body && name.trim_end().chars().all(is_name) && failure.expects(Expected::End);
    if statement.found(failure.at) != "," || !is_field || values.contains('=') {
        return None;
    }
    let span = statement.span(failure.at, failure.at + 1);
    let start = statement.text.len() - values.trim_start().len();
    let values = values.trim();
    let list = format!("[{values}]");
    Some(
        Diagnostic::error("mavc::syntax::unexpected", span, "several values need a list, in `[ ]`")
            .here("separates the elements of a list")
            .help(format!("write `{}`", cut(&list)))
            .fix(statement.span(start, start + values.len()), list),
    )
}

/// `.5`, `5.`, `1.2.3`
pub(super) fn number_point(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let bytes = statement.text.as_bytes();
    let at = failure.at;
    if at > 0 && bytes[at - 1].is_ascii_digit() && bytes.get(at) == Some(&b'_') {
        let found = statement.found(at);
        let span = statement.span(at, at + found.len());
        let error = Diagnostic::error("mavc::syntax::number", span, "a number is written without `_`");
        return Some(error.here("not expected in a number").help("leave out the `_`"));
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
        // Only the exponent of a unit ends before a point.
        let error = Diagnostic::error("mavc::unit::exponent", span, "the exponent of a unit is a whole number");
        return Some(error.here("has a decimal point").help("write a whole number, as in `m^2`"));
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

/// `curve s in 0 .. 1 points = 2`
pub(super) fn comma_in_curve(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let found = statement.found(failure.at);
    let begins_option = statement.text[failure.at + found.len()..].trim_start().starts_with('=');
    let (start, word) = match found {
        "=" => statement.before(failure.at),
        word if begins_option && word.starts_with(is_name) => (failure.at, word),
        _ => return None,
    };
    (statement.word() == "curve" && failure.expects(Expected::End)).then(|| {
        let message = format!("a comma is missing before `{}`", cut(word));
        Diagnostic::error("mavc::syntax::unexpected", statement.span(start, start + word.len()), message)
            .here("expected `,` before this")
            .help("write `,` after the range")
            .fix(statement.span(start, start), ", ")
    })
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
    let is_unit = failure.expects(Expected::Operator) && !failure.expects(Expected::Effect);
    if !is_unit || !is_factor(found) {
        return None;
    }
    let before = statement.text[..failure.at].trim_end();
    let start = before.rfind(|c: char| !(is_name(c) || "*/^%".contains(c))).map_or(0, |i| i + 1);
    let unit = &before[start..];
    let follows_operand = before[..start].trim_end().ends_with(|c: char| c.is_ascii_digit() || c == ')' || c == ']');
    if !follows_operand || !unit.starts_with(|c: char| c.is_ascii_alphabetic() || c == '%') {
        return None;
    }
    let mut end = failure.at;
    let mut factors = vec![unit];
    while is_factor(token(statement.text, end, is_name)) || statement.text[end..].starts_with('%') {
        let factor = token(statement.text, end, |c| is_name(c) || "*/^%-".contains(c));
        factors.push(factor);
        let behind = &statement.text[end + factor.len()..];
        end += factor.len() + behind.len() - behind.trim_start_matches([' ', '\t']).len();
    }
    let written = statement.text[start..end].trim_end();
    let span = statement.span(start, start + written.len());
    let message = format!("the unit `{}` has a blank in it", cut(written));
    let error = Diagnostic::error("mavc::syntax::unit_blank", span, message).here("a unit is one run without blanks");
    // Nobody means a square by `ft ft`.
    if factors[1..] == [unit] {
        return Some(error.help(format!("write it once: `{}`", cut(unit))).fix(span, unit));
    }
    let mut fixed = unit.to_string();
    for factor in &factors[1..] {
        match factor.split_once("^-") {
            Some((name, "1")) => fixed += &format!("/{name}"),
            Some((name, power)) => fixed += &format!("/{name}^{power}"),
            None => fixed += &format!("*{factor}"),
        }
    }
    Some(error.help(format!("write `{}`, with `/` before what divides", cut(&fixed))).fix(span, fixed))
}

/// Whether a word can be a factor of a unit; longer words, and some short ones, begin something else.
fn is_factor(word: &str) -> bool {
    let other = ["and", "or", "to", "of", "for", "let", "use", "as", "in"].contains(&word) || is_clause(word);
    word == "%" || word.len() <= 3 && word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') && !other
}

/// `[continue, land here]`, `[land at pad]`
pub(super) fn way_of_two_words(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    if before != "land" || !matches!(statement.word(), "order" | "recovery") {
        return None;
    }
    let (end, written) = match statement.found(failure.at) {
        "here" => (failure.at + "here".len(), "land_here"),
        "at" => {
            let rest = &statement.text[failure.at + "at".len()..];
            let at = statement.text.len() - rest.trim_start().len();
            let name = statement.found(at);
            let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
            (at + name.len(), if name == "sites" { "land_at_sites" } else { Some(name).filter(|_| is_name)? })
        }
        _ => return None,
    };
    let span = statement.span(start, end);
    let message = format!("`{}` is not one word", cut(&statement.text[start..end]));
    let error = Diagnostic::error("mavc::syntax::unexpected", span, message);
    let error = error.here("a way out is one word, or the name of a landing site");
    Some(error.help(format!("write `{}`", cut(written))).fix(span, written))
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
    // Modes, planners and rotors have no units.
    let is_choice = matches!(statement.word(), "against" | "planners" | "every");
    if is_unit || is_choice || statement.place.openers().contains(&found) {
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
    // `k[0]` is not an element.
    let is_index = found == "[" && statement.text[..failure.at].ends_with(is_name);
    if is_index || !failure.expects(Expected::Closing(']')) && !failure.expects(Expected::Closing(')')) {
        return None;
    }
    let span = statement.span(failure.at, failure.at + found.len());
    let gap = statement.text[..failure.at].trim_end().len();
    let error = Diagnostic::error("mavc::syntax::unexpected", span, "a comma is missing between two elements")
        .here("expected `,` before this")
        .help("write `,` between them");
    // If only bare numbers follow in the list, all commas are missing.
    let rest = statement.text[failure.at..].split(']').next().unwrap_or("");
    let others: Vec<&str> = rest.split_whitespace().collect();
    let bare = others.iter().all(|n| n.starts_with(|c: char| c.is_ascii_digit() || c == '-') && !n.contains(','));
    Some(match bare {
        true => error.fix(statement.span(gap, failure.at + rest.len()), format!(", {}", others.join(", "))),
        false => error.fix(statement.span(gap, failure.at), ", "),
    })
}

/// `start at (0, 0, 2) m`, `altitude in (1, 30) m`
pub(super) fn in_parentheses(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    if statement.found(failure.at) != "," || !failure.expects(Expected::Closing(')')) {
        return None;
    }
    // No bracket between the parenthesis and the comma, or the comma would belong to another bracket.
    let open =
        statement.text[..failure.at].rfind(['(', ')', '[', ']']).filter(|&i| statement.text[i..].starts_with('('))?;
    let span = statement.span(open, open + 1);
    if statement.place.has_limits() {
        let error = Diagnostic::error("mavc::syntax::range", span, "a range is written with `..`, not with a comma");
        return Some(error.here("not a range").help("write it like `altitude in 1 m .. 30 m`"));
    }
    let diagnostic = Diagnostic::error("mavc::syntax::unexpected", span, "a list takes `[ ]`, not `( )`")
        .here("opens an expression, which has no commas")
        .help("write `[x, y, z]` and the unit after it");
    let inside = &statement.text[open + 1..];
    Some(match inside.find(['(', ')', '[', ']']).filter(|&i| inside[i..].starts_with(')')) {
        Some(length) => {
            let span = statement.span(open, open + length + 2);
            diagnostic.fix(span, format!("[{}]", &inside[..length]))
        }
        None => diagnostic,
    })
}

/// `2 pi m`, `0.5*pi rad/s`
pub(super) fn pi_and_unit(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, before) = statement.before(failure.at);
    let unit = token(statement.text, failure.at, |c| is_name(c) || "*/^".contains(c));
    let is_field = statement.text[failure.at + unit.len()..].trim_start().starts_with('=');
    let is_unit = unit.starts_with(|c: char| c.is_ascii_alphabetic()) && !is_clause(unit) && !is_field;
    if before != "pi" || !is_unit || !failure.expects(Expected::Operator) {
        return None;
    }
    let head = statement.text[..start].trim_end();
    let from = head.rfind(|c| !(is_name(c) || ".*/".contains(c))).map_or(0, |i| i + 1);
    let number = head[from..].trim_end_matches('*');
    let span = statement.span(from, failure.at + unit.len());
    let error = Diagnostic::error("mavc::syntax::unexpected", span, "`pi` is a name, and a name takes no unit");
    let fixed = format!("({number}*pi) {unit}");
    number.starts_with(|c: char| c.is_ascii_digit()).then(|| {
        error
            .here("a unit follows a number, `)` or `]`, not a name")
            .help(format!("write `{}`", cut(&fixed)))
            .fix(span, fixed)
    })
}
