//! T_d, the mission time at which planners are compared, and all planners at it: the plans that a campaign flies.

use super::found::Found;
use super::{Comparison, NOTHING_TO_SELECT_BY, PlanOutcome, Run, Setting};
use crate::model::PlannerKind;
use crate::planner::timing::search::Hint;
use crate::planner::working_set::WorkingSet;
use crate::planner::{Decision, Planned};

impl Setting<'_> {
    /// RIP, RCP jointly and RSP at T_d; no runs without such a time, and no RCP without modes.
    pub(super) fn at_common_time(&self) -> Comparison {
        let mut out = self.without_runs();
        let joint = self.seek_common_time(&mut out);
        let Some(time) = out.common_time else { return out };
        let joint_plan = joint.as_ref().and_then(Found::planned);
        let (rip, rcp) = rayon::join(
            || self.rip_at("RIP", time, joint_plan, None),
            || {
                (!self.sets.names.is_empty()).then(|| match &joint {
                    Some(found) => self.at_or_own("RCP", &self.sets.joint, time, found, None),
                    None => self.at("RCP", &self.sets.joint, time, WorkingSet::default(), &[]),
                })
            },
        );
        let (rip_decision, effort) = rip;
        out.effort += effort;
        let rsp_set = match &rip_decision {
            Decision::Feasible(planned) => self.select(time, planned, joint_plan, &mut out),
            _ => self.sets.rip.clone(),
        };
        // If nothing is selected, RSP's plan is RIP's; if RIP has none, RSP has nothing to select by.
        let rsp = match (&rip_decision, out.selected.is_empty()) {
            (Decision::Feasible(_), true) => self.common(time, &rip_decision),
            (Decision::Infeasible | Decision::Inconclusive(_), _) => self.without_rip(time, &rip_decision),
            (Decision::Feasible(_), false) => {
                let rcp_plan = rcp.as_ref().and_then(|r| r.0.planned());
                let first: Vec<&Planned> =
                    rip_decision.planned().into_iter().chain(self.at_its_time(joint_plan)).collect();
                let (decision, effort) = self.rsp_at("RSP", &rsp_set, time, &first, rcp_plan);
                out.effort += effort;
                self.common(time, &decision)
            }
        };
        let outcome = self.common(time, &rip_decision);
        out.runs.push(self.run(PlannerKind::Rip, &[], Run::Common, outcome, &self.sets.rip));
        if let Some((decision, effort)) = rcp {
            out.effort += effort;
            let outcome = self.common(time, &decision);
            out.runs.push(self.run(PlannerKind::Rcp, &self.sets.names, Run::Common, outcome, &self.sets.joint));
        }
        out.runs.push(self.run(PlannerKind::Rsp, &self.sets.names, Run::Common, rsp, &rsp_set));
        out
    }

    /// Steps (b) and (c): T_d if the spec does not fix it, which is the joint RCP's shortest time or else the largest
    /// single-mode one; it stays `None` if no mode has a plan at any time. Returns the joint RCP's search, if there was
    /// one.
    pub(super) fn seek_common_time(&self, out: &mut Comparison) -> Option<Found> {
        if out.common_time.is_some() {
            return None;
        }
        let joint = self.search("RCP", &self.sets.joint, Hint::default(), WorkingSet::default());
        out.effort += joint.effort;
        out.covering_time = joint.planned().map(|planned| planned.grid.total);
        out.common_time = match &joint.result {
            Ok(s) => Some(s.time),
            Err(_) => {
                let rip = self.search("RIP", &self.sets.rip, Hint::default(), WorkingSet::default());
                out.effort += rip.effort;
                let hint = Hint { infeasible: rip.time_below(), near: rip.time(), ..Hint::default() };
                let singles: Vec<Found> = self.singles_own(&rip, hint);
                singles.iter().for_each(|f| out.effort += f.effort);
                singles.iter().filter_map(|f| Some(f.result.as_ref().ok()?.time)).max_by(f64::total_cmp)
            }
        };
        Some(joint)
    }

    /// RSP's outcome if RIP has no plan at T_d = `time`: every plan of RSP is one of RIP, so a proof for RIP is one for
    /// RSP; without a proof there is nothing to select facets by, and RSP is not attempted.
    pub(super) fn without_rip(&self, time: f64, rip: &Decision) -> PlanOutcome {
        match rip {
            Decision::Infeasible => PlanOutcome::proved_infeasible(&[time]),
            _ => PlanOutcome::NotAttempted { at: time, why: NOTHING_TO_SELECT_BY.into() },
        }
    }
}
