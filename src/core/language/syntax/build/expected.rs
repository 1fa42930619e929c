//! Where a broken statement fails, and what could follow there.

use super::{Grammar, Rule};
use crate::language::Place;
use crate::syntax::mistake::{Expected, Failure};
use crate::syntax::scan;
use pest::Parser;
use pest::error::{Error, ErrorVariant, InputLocation};

pub(super) fn position(error: &Error<Rule>) -> usize {
    match error.location {
        InputLocation::Pos(at) => at,
        InputLocation::Span((at, _)) => at,
    }
}

/// Reads one statement alone, by the rule it was probably meant to follow; `None` where it can be read.
pub(super) fn failure(text: &str, place: Place, has_body: bool) -> Option<Failure> {
    let Err(error) = Grammar::parse(strict_rule(text, place, has_body), text) else {
        return None;
    };
    let mut expected: Vec<Expected> = match &error.variant {
        // A word that is not a name here: the grammar forbids nothing else.
        ErrorVariant::ParsingError { positives, negatives } if !negatives.is_empty() => {
            positives.iter().filter_map(|r| meaning(*r)).chain([Expected::Name]).collect()
        }
        ErrorVariant::ParsingError { positives, .. } => positives.iter().filter_map(|r| meaning(*r)).collect(),
        ErrorVariant::CustomError { .. } => Vec::new(),
    };
    // After an operand, `(` would make it a call; no message mentions that.
    if expected.contains(&Expected::Operator) {
        expected.retain(|e| *e != Expected::Value);
    }
    expected.sort();
    expected.dedup();
    Some(Failure { at: position(&error), expected })
}

/// The rule for a statement's first word, here.
fn strict_rule(text: &str, place: Place, has_body: bool) -> Rule {
    let word = scan::run(text, scan::is_name);
    let rest = text[word.len()..].trim_start();
    let is_field = rest.starts_with(['=', ':']);
    match word {
        "every" if !is_field => Rule::strict_every,
        "curve" if !is_field => Rule::strict_curve,
        "waypoint" if has_body && !is_field => Rule::strict_waypoint,
        _ if has_body => Rule::strict_block,
        _ if place.has_limits() => Rule::strict_limit,
        _ if is_field => Rule::strict_field,
        "require" if place == Place::Plan => Rule::strict_require,
        "use" => Rule::strict_import,
        "let" => Rule::strict_binding,
        "hold" => Rule::strict_hold,
        "start" => Rule::strict_moving,
        "end" => Rule::strict_end,
        "waypoint" => Rule::strict_waypoint,
        "waypoints" => Rule::strict_survey,
        "rotor" if matches!(place, Place::Rotors | Place::Vehicle) => Rule::strict_rotor,
        "rotor" | "rotors" => Rule::strict_fault,
        "fault" => Rule::strict_strike,
        _ => Rule::strict_field,
    }
}

fn meaning(rule: Rule) -> Option<Expected> {
    Some(match rule {
        Rule::number
        | Rule::quantity
        | Rule::reference
        | Rule::unknown
        | Rule::call
        | Rule::paren
        | Rule::list
        | Rule::minus
        | Rule::lparen
        | Rule::lbracket
        | Rule::expr
        | Rule::filter
        | Rule::kw_where => Expected::Value,
        Rule::plus | Rule::spread | Rule::dash | Rule::times | Rule::over | Rule::power | Rule::dots => {
            Expected::Operator
        }
        Rule::unit => Expected::Unit,
        Rule::equals => Expected::Equals,
        Rule::name => Expected::Name,
        Rule::text => Expected::Text,
        Rule::at_most | Rule::at_least | Rule::less | Rule::greater => Expected::Relation,
        Rule::comma => Expected::Comma,
        Rule::rparen => Expected::Closing(')'),
        Rule::rbracket => Expected::Closing(']'),
        Rule::clause
        | Rule::clause_word
        | Rule::bare
        | Rule::bare_word
        | Rule::arrival
        | Rule::arrive_word
        | Rule::heading
        | Rule::yaw_word => Expected::Clause,
        Rule::kw_lost | Rule::reduced | Rule::stuck => Expected::Effect,
        Rule::kw_as => Expected::Word("as"),
        Rule::kw_at => Expected::Word("at"),
        Rule::kw_from | Rule::from_word => Expected::Word("from"),
        Rule::kw_in => Expected::Word("in"),
        Rule::path_word => Expected::Word("path"),
        Rule::kw_moving => Expected::Word("moving"),
        Rule::kw_rotor | Rule::kw_rotors => Expected::Word("rotors"),
        Rule::kw_to => Expected::Word("to"),
        Rule::EOI => Expected::End,
        _ => return None,
    })
}
