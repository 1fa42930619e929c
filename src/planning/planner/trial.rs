//! Where a search for a plan stands, for a line of progress.

/// The mission time that is tried next, and what is known of others.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Trial {
    /// s
    pub time: f64,
    /// The shortest time of a feasible iterate, s, on whatever grid. Only the plan that a search ends with is checked.
    pub feasible: Option<f64>,
    /// The last time at which no feasible iterate was found, s.
    pub failed: Option<f64>,
    /// The share of the solver's budget that is left; `None` without a budget, as in the hover model.
    pub budget_left: Option<f64>,
}

impl Trial {
    /// A time (s), of which nothing else is known.
    pub fn at(time: f64) -> Trial {
        Trial { time, ..Trial::default() }
    }

    /// Keeps what came of a time, s.
    pub(super) fn note(&mut self, time: f64, is_feasible: bool) {
        match is_feasible {
            true => self.feasible = Some(self.feasible.map_or(time, |known| known.min(time))),
            false => self.failed = Some(time),
        }
    }
}

/// Receives each trial before it begins.
pub type OnTrial<'a> = Option<&'a (dyn Fn(Trial) + Sync)>;
