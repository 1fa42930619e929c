//! The verdict on the question "is there a plan?": one type, and one word for the terminal, JSON and the page.

use serde::Serialize;
use std::fmt;

/// The answer to the question whether there is a plan. No report makes a stronger claim than this word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Verdict {
    /// There is a plan, and it was returned.
    #[serde(rename = "found")]
    Found,
    /// There is no plan: a proof of exactly the statement printed with this word was checked.
    #[serde(rename = "proved infeasible")]
    ProvedInfeasible,
    /// The search ended without a plan and without a proof.
    #[serde(rename = "not found")]
    NotFound,
    /// No plan was searched for, because something that the search needs is missing.
    #[default]
    #[serde(rename = "not attempted")]
    NotAttempted,
}

impl Verdict {
    pub const ALL: [Verdict; 4] = [Verdict::Found, Verdict::ProvedInfeasible, Verdict::NotFound, Verdict::NotAttempted];

    /// The word for terminal, JSON and page.
    pub const fn word(self) -> &'static str {
        match self {
            Verdict::Found => "found",
            Verdict::ProvedInfeasible => "proved infeasible",
            Verdict::NotFound => "not found",
            Verdict::NotAttempted => "not attempted",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// The word for a flight, whatever its outcome.
pub const SIMULATED: &str = "simulated";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_and_text_have_the_same_words() {
        for verdict in Verdict::ALL {
            assert_eq!(serde_json::to_value(verdict).unwrap(), verdict.word());
        }
    }
}
