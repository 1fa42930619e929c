//! How a row is judged: always from numbers, so that a row whose numbers change does not keep its old judgement.

/// **agrees**, or **differs** with the reason.
pub fn agrees_if(holds: bool, otherwise: &str) -> String {
    if holds { "agrees".into() } else { differs(otherwise) }
}

pub fn differs(reason: &str) -> String {
    format!("**differs**: {reason}")
}

pub fn not_comparable(missing: &str) -> String {
    format!("not comparable: {missing}")
}

/// A statement of the paper, the result of mavc, and the judgement of the row.
pub fn statement(paper: impl Into<String>, here: impl Into<String>, judged: impl Into<String>) -> Vec<String> {
    vec![paper.into(), here.into(), judged.into()]
}

pub const STATEMENTS: [&str; 3] = ["the paper", "mavc", "row"];

/// `M1, M2 and M5`
pub fn listed(names: &[String]) -> String {
    match names {
        [] => "none".into(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
