//! All planners at one mission time: what a campaign flies.

use super::{Comparison, Run, Setting, plan_found, planned_of};
use crate::model::PlannerKind;
use crate::planner::pool::Pool;
use crate::planner::rows::{Decision, Planned};

impl Setting<'_> {
    /// RIP, RCP jointly and RSP at T_d; no runs where there is no such time, and no RCP without modes.
    pub(super) fn at_common_time(&self) -> Comparison {
        let mut out = self.begun();
        let joint = self.seek_common_time(&mut out);
        let Some(time) = out.common_time else { return out };
        let joint_plan = joint.as_ref().and_then(plan_found);
        let (rip, rcp) = rayon::join(
            || self.rip_at("RIP", time, joint_plan, None),
            || {
                (!self.sets.names.is_empty()).then(|| match &joint {
                    Some(found) => self.at_or_own("RCP", &self.sets.joint, time, found, None),
                    None => self.at("RCP", &self.sets.joint, time, Pool::default(), &[]),
                })
            },
        );
        let (rip_decision, effort) = rip;
        out.effort += effort;
        let rsp_set = match &rip_decision {
            Decision::Feasible(planned) => self.select(time, planned, joint_plan, &mut out),
            _ => self.sets.rip.clone(),
        };
        // Where nothing is selected RSP's plan is RIP's, and where RIP has none RSP has nothing to select by.
        let rsp = match (&rip_decision, out.selected.is_empty()) {
            (Decision::Feasible(_), true) => self.common(time, &rip_decision),
            (Decision::Infeasible | Decision::Inconclusive(_), _) => self.without_rip(time, &rip_decision),
            (Decision::Feasible(_), false) => {
                let rcp_plan = rcp.as_ref().and_then(|r| planned_of(&r.0));
                let first: Vec<&Planned> =
                    planned_of(&rip_decision).into_iter().chain(self.at_its_time(joint_plan)).collect();
                let (decision, effort) = self.rsp_at("RSP", &rsp_set, time, &first, rcp_plan);
                out.effort += effort;
                self.common(time, &decision)
            }
        };
        let ending = self.common(time, &rip_decision);
        out.runs.push(self.run(PlannerKind::Rip, &[], Run::Common, ending, &self.sets.rip));
        if let Some((decision, effort)) = rcp {
            out.effort += effort;
            let ending = self.common(time, &decision);
            out.runs.push(self.run(PlannerKind::Rcp, &self.sets.names, Run::Common, ending, &self.sets.joint));
        }
        out.runs.push(self.run(PlannerKind::Rsp, &self.sets.names, Run::Common, rsp, &rsp_set));
        out
    }
}
