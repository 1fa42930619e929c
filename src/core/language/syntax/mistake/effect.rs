//! What fails, and how: `rotors 1, 2 lost`, `every 1 motor lost as M`, `rotor 1 fails`.

use super::wording::unexpected;
use super::{Broken, Expected, Failure, is_name, token};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::Place;
use crate::source::Span;
use crate::syntax::cut;

/// `rotors 1, 2 lost`, `rotors 1 and 2 lost`
pub(super) fn rotor_numbers(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_fault = matches!(statement.word(), "rotor" | "rotors") && failure.expects(Expected::Effect);
    let found = statement.found(failure.at);
    let (start, before) = statement.before(failure.at);
    let at = match (found, before) {
        (_, "and" | "or") => start,
        ("," | "and" | "or" | "&" | "&&" | "-", _) => failure.at,
        _ => return None,
    };
    let mark = token(statement.text, at, |c| is_name(c) || "&,-".contains(c));
    let diagnostic = unexpected(statement, at, at + mark.len().max(1), "several rotors need a list");
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

/// `every 1 motor lost as M`, where any word after a number looks like a unit.
pub(super) fn motors(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let (start, word) = statement.before(failure.at);
    let is_rotor = matches!(word, "motor" | "motors" | "propeller" | "propellers" | "prop" | "props");
    (statement.word() == "every" && is_rotor && failure.expects(Expected::Word("rotors"))).then(|| {
        let span = statement.span(start, start + word.len());
        let ours = if word.ends_with('s') { "rotors" } else { "rotor" };
        unexpected(statement, start, start + word.len(), format!("`every` counts rotors, not `{word}`"))
            .here(format!("expected `{ours}`"))
            .help(format!("write `{ours}`"))
            .fix(span, ours)
    })
}

/// `every 2 neighbours lost as W`, where any word after a number looks like a unit.
pub(super) fn choice(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
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
    Diagnostic::error("mavc::syntax::unexpected", span, format!("`every` cannot select rotors by `{word}`"))
        .here("expected `rotors`")
        .help(
            "`every 2 rotors` covers every pair; to cover only some, write a mode for each: `mode W1 \
        { rotors [1, 2] lost }`",
        )
}

/// `rotor 1 fails`, where any word after a number looks like a unit.
pub(super) fn effect_word(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
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
    let message = format!("unknown fault effect `{}`", cut(word));
    let diagnostic = unexpected(statement, at, at + word.len(), message);
    let diagnostic = diagnostic.here("expected `lost`, `reduced to` or `stuck at`");
    Some(match meant {
        "" if statement.word() == "every" => diagnostic.help("write it like `every 1 rotor lost as M`"),
        "" => diagnostic.help("write it like `rotor 3 lost`, `rotor 3 reduced to 60 %` or `rotor 3 stuck at 50 %`"),
        meant => diagnostic.help(format!("write `{meant}`")).fix(statement.span(at, at + word.len()), meant),
    })
}

/// `rotor 1 reduced by 10 %`
pub(super) fn reduced_by(statement: &Broken, failure: &Failure) -> Option<Diagnostic> {
    let is_by = statement.found(failure.at) == "by" && statement.before(failure.at).1 == "reduced";
    if !is_by {
        return None;
    }
    let message = "a rotor is reduced `to` the share that remains, not `by` the share that is lost";
    let diagnostic = unexpected(statement, failure.at, failure.at + 2, message).here("expected `to`");
    let rest = statement.text[failure.at + 2..].trim_start();
    let digits = token(rest, 0, |c| c.is_ascii_digit());
    let unit = rest[digits.len()..].trim_start();
    Some(match digits.parse::<u32>().ok().filter(|lost| *lost <= 100 && unit.starts_with('%')) {
        Some(lost) => {
            let fixed = format!("to {} %", 100 - lost);
            let end = statement.text.len() - unit.len() + 1;
            diagnostic.help(format!("write `{fixed}`")).fix(statement.span(failure.at, end), fixed)
        }
        None => diagnostic.help("write the share that remains: a tenth lost is `reduced to 90 %`"),
    })
}

/// `all rotors lost`
pub(super) fn all_rotors(statement: &Broken, _: &Failure) -> Option<Diagnostic> {
    let is_all = statement.place == Place::Mode && matches!(statement.word(), "all" | "both" | "any");
    let word = statement.word();
    is_all.then(|| {
        unexpected(statement, 0, word.len(), format!("no fault begins with `{word}`"))
            .here("expected `rotor` or `rotors`")
            .help("write which rotors: `rotors [1, 2] lost`")
    })
}
