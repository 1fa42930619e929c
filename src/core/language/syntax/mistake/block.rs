//! Mistakes about blocks: unknown, unnamed, headless, and statements in the wrong one.

use super::{Broken, form};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, StatementKind};
use crate::source::Span;
use crate::syntax::ast::Block;
use crate::syntax::cut;

/// A block whose keyword is unknown, and the block that was probably meant.
pub(in crate::language::syntax) fn unknown_block(word: &str, span: Span, place: Place) -> (Diagnostic, Option<Place>) {
    let meant = place.meant(word);
    let shown = cut(word);
    if place.has_braceless(word) {
        let message = format!("`{shown}` takes no braces");
        let diagnostic = Diagnostic::error("mavc::syntax::block_head", span, message).here("a `{` follows");
        let help = match form(word, place) {
            Some(form) => format!("write it like `{form}`"),
            None => "remove the braces".to_string(),
        };
        return (diagnostic.help(help), None);
    }
    let diagnostic =
        Diagnostic::error("mavc::syntax::unknown_statement", span, format!("there is no block called `{shown}`"));
    let diagnostic = match meant {
        Some(meant) => {
            diagnostic.here(format!("did you mean `{meant}`?")).help(format!("write `{meant}`")).fix(span, meant)
        }
        None => diagnostic.here("unknown here").help(openers(place)),
    };
    (diagnostic, meant.and_then(Place::of_block))
}

/// A block `rotor` that places rotors.
pub(in crate::language::syntax) fn rotors_without_s(span: Span) -> Diagnostic {
    let message = "`rotor at` belongs in a `rotors` block, not in a `rotor` block";
    let diagnostic = Diagnostic::error("mavc::syntax::misplaced", span, message);
    diagnostic.here("did you mean `rotors`?").help("write `rotors`").fix(span, "rotors")
}

/// A keyword's block has a name, or it has none; what is wrong with its head, if anything.
pub(in crate::language::syntax) fn check_head(block: &mut Block, kind: Place) -> Option<Diagnostic> {
    let keyword = kind.keyword().unwrap_or(&block.keyword.value).to_string();
    let code = "mavc::syntax::block_head";
    let form = form(&keyword, Place::Unknown).unwrap_or("limits { .. }");
    block.keyword.value = keyword.clone();
    if let Some(name) = block.name.as_ref().filter(|_| !kind.is_named()) {
        let message = format!("`{keyword}` takes no name");
        let behind = Span { start: block.keyword.span.end, ..name.span };
        let error = Diagnostic::error(code, name.span, message).here("not expected");
        let error = error.help("remove the name").fix(behind, "");
        block.name = None;
        return Some(error);
    }
    if block.name.is_none() && kind.is_named() {
        let message = format!("this `{keyword}` has no name");
        let diagnostic = Diagnostic::error(code, block.keyword.span, message).here("a name must follow");
        let diagnostic = diagnostic.help(format!("write it like `{form}`"));
        let behind = Span { start: block.keyword.span.end, ..block.keyword.span };
        return Some(match kind {
            Place::Vehicle => diagnostic.fix(behind, " octo"),
            Place::Mission => diagnostic.fix(behind, " survey"),
            // Modes differ by their names.
            _ => diagnostic,
        });
    }
    if let Some(title) = block.title.as_ref().filter(|_| kind != Place::Mode) {
        let message = format!("`{keyword}` takes no title");
        let diagnostic = Diagnostic::error(code, title.span, message).here("only a `mode` has a title");
        return Some(diagnostic.help("write it as a `///` comment above the block"));
    }
    None
}

/// A statement that belongs elsewhere.
pub(in crate::language::syntax) fn misplaced(kind: StatementKind, place: Place, text: &str, span: Span) -> Diagnostic {
    let word = super::token(text, 0, super::is_name);
    let (whole, span) = (span, Span { end: span.start + word.len() as u32, ..span });
    if kind == StatementKind::Field && place.has_limits() {
        let value = text.split_once('=').map_or("", |(_, value)| value.trim());
        let (limit, relation) = match (word.strip_prefix("max_"), word.strip_prefix("min_")) {
            _ if value.contains("..") => (word, "in"),
            (Some(limit), _) => (limit, "<="),
            (_, Some(limit @ ("x" | "y" | "z" | "altitude" | "yaw"))) => (limit, ">="),
            _ => (word, "<="),
        };
        return Diagnostic::error("mavc::syntax::relation", span, format!("the limit `{word}` is set with `=`"))
            .here("a limit is a bound, not a single value")
            .help(format!("write `{limit} {relation} {}`", cut(value)))
            .fix(whole, format!("{limit} {relation} {value}"));
    }
    let what = match kind {
        StatementKind::RotorAt => "`rotor at`".to_string(),
        StatementKind::Fault => "a rotor's fault".to_string(),
        _ => format!("`{}`", cut(word)),
    };
    let Some(home) = kind.home() else {
        return Diagnostic::error(
            "mavc::syntax::misplaced",
            span,
            format!("fields are not allowed {}", place.phrase()),
        )
        .here("does not belong here")
        .help(openers(place));
    };
    let help = match home {
        Place::Top => "move it out of the block",
        Place::Vehicle => "move it into a `vehicle`",
        Place::Rotors => "put it into `rotors { .. }` in the vehicle",
        Place::Parts => "move it into `parts { .. }` in the vehicle",
        Place::Faults => "move it into `faults { .. }`",
        Place::Mode => "name the fault in `faults`: `mode NAME { .. }`",
        Place::Limits => "put it into `limits { .. }` in the mission",
        Place::Simulate if matches!(place, Place::Faults | Place::Mode) => {
            "declare a mode with `mode NAME { rotor 1 lost }`, and give the time of the fault in `simulate`"
        }
        Place::Simulate if place == Place::Campaign => {
            "a campaign sets its own faults: remove it, or move it into `simulate { .. }`"
        }
        Place::Simulate => "move it into `simulate { .. }`",
        Place::Plan => "move it into `plan { .. }`",
        _ => "move it into a `mission`",
    };
    let message = format!("{what} belongs {}, not {}", home.phrase(), place.phrase());
    Diagnostic::error("mavc::syntax::misplaced", span, message).here("does not belong here").help(help)
}

/// Braces without a keyword, and keywords without braces.
pub(super) fn headless(statement: &Broken) -> Option<Diagnostic> {
    if statement.text.is_empty() {
        let message = "a block begins with a keyword";
        return Some(
            Diagnostic::error("mavc::syntax::block_head", statement.span(0, 1), message)
                .here("no keyword before this brace")
                .help(openers(statement.place)),
        );
    }
    let word = statement.word();
    let rest = statement.text[word.len()..].trim_start();
    if !statement.has_body && opens_block(word, rest) {
        let message = format!("`{}` has no `{{` on its line", cut(statement.text));
        let end = statement.text.len();
        let diagnostic = Diagnostic::error("mavc::syntax::missing_brace", statement.span(0, end), message)
            .here("a block must open on this line");
        return Some(match statement.brace_below {
            Some(gap) => {
                let diagnostic = diagnostic.help("move the `{` below to the end of this line");
                // What may be a comment is not to be lost.
                let bare = gap.strip_prefix(' ').unwrap_or(gap).strip_prefix('\n').is_some_and(|g| !g.contains('\n'));
                match bare {
                    true => diagnostic.fix(statement.span(end, end + gap.len() + 1), " {"),
                    false => diagnostic,
                }
            }
            None => diagnostic.help("write `{` at the end of this line").fix(statement.span(end, end), " {"),
        });
    }
    let equals = rest.trim_end_matches([' ', '=', ':']).is_empty() && !rest.is_empty();
    (statement.has_body && equals).then(|| {
        let at = statement.text.len() - rest.len();
        let span = statement.span(at, statement.text.len());
        let message = format!("the block `{}` takes no `{rest}`", cut(word));
        Diagnostic::error("mavc::syntax::block_head", span, message)
            .here("not expected before `{`")
            .help("remove it")
            .fix(span, "")
    })
}

/// Whether a word and what follows it are exactly the head of a block.
fn opens_block(word: &str, rest: &str) -> bool {
    let title_or_nothing = rest.is_empty() || rest.starts_with('"');
    match word {
        "vehicle" | "mission" | "mode" | "landing_site" | "keep_off" | "part" => {
            title_or_nothing || rest.trim_start_matches(super::is_name).trim_start().chars().all(|c| c == '"')
        }
        "faults" | "plan" | "simulate" | "campaign" | "limits" | "after_fault_limits" | "recovery" | "rotor"
        | "rotors" | "battery" | "parts" => title_or_nothing,
        "curve" => rest.contains(".."),
        _ => false,
    }
}

/// What begins a statement here.
pub(super) fn openers(place: Place) -> String {
    let words: Vec<String> = place.openers().iter().map(|w| format!("`{w}`")).collect();
    match words.split_last() {
        _ if place == Place::Rotors => {
            "only `rotor at [..] m  spin P` is allowed here; what all rotors share goes into a `rotor { .. }` block \
             beside it"
                .to_string()
        }
        _ if place.has_limits() => "a limit is written like `speed <= 8 m/s`".to_string(),
        Some((last, others)) if place == Place::Mission => {
            format!("write {} or {last}; the last waypoint is the goal", others.join(", "))
        }
        Some((last, others)) if place == Place::Faults => format!("write {} or {last}", others.join(", ")),
        Some((last, [])) => format!("write {last}, or a field like `name = value`"),
        Some((last, others)) => format!("write {} or {last}, or a field like `name = value`", others.join(", ")),
        None => format!("only fields like `name = value` are allowed {}", place.phrase()),
    }
}
