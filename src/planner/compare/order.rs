//! The order of times: a plan inside a smaller set is one inside a larger set, so that RIP takes no longer than RSP, RSP no
//! longer than the joint RCP, and RCP against one mode no longer than against all.

use super::{Ending, Found, Solved};
use crate::planner::rows::Planned;
use crate::planner::search::Shortest;

impl Found {
    /// The same, or another set's plan where that is shorter and this set allows what that one does: steps that find and do not
    /// prove can end with a longer plan for the larger set.
    pub(super) fn or_shorter(mut self, other: &Planned) -> Found {
        let (own, proved) = match &self.result {
            Ok(s) => (s.time, s.infeasible_at),
            Err(_) => (f64::INFINITY, None),
        };
        let time = other.profile.total;
        if time < own {
            let infeasible_at = proved.filter(|&below| below < time);
            self.result = Ok(Shortest { time, planned: other.clone(), infeasible_at, infeasible_above: Vec::new() });
        }
        self
    }
}

/// RIP's ending with RSP's plan, where that is shorter: the healthy set allows it.
pub(super) fn shorter(rip: &Ending, rsp: &Ending) -> Option<Ending> {
    let (Ending::Solved(rip), Ending::Solved(rsp)) = (rip, rsp) else { return None };
    let infeasible_at = rip.infeasible_at.filter(|&below| below < rsp.time);
    let solved = || Solved { infeasible_at, infeasible_above: Vec::new(), ..(**rsp).clone() };
    (rsp.time < rip.time).then(|| Ending::Solved(Box::new(solved())))
}
