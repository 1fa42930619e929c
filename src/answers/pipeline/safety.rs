//! The case of a safety assessment: from a report with ways out and an accepted certificate.

use super::tasks::Task;
use crate::certificate::{Certificate, Claim, PlanClaim};
use crate::safety::evidence::{Evidence, Shown};
use crate::safety::inputs::Inputs;
use crate::safety::{CERTIFICATE, Case, MOST_MODES, REPORT, counted};
use crate::verify::Accepted;

impl Task<'_> {
    /// Whether the modes of the spec fit a fault tree, to be asked before minutes of search.
    ///
    /// # Errors
    /// There are too many.
    pub fn fits_fault_tree(&self) -> Result<(), String> {
        let modes = counted(self.model()).len();
        if modes > MOST_MODES {
            return Err(format!(
                "the fault tree would have pairs of {modes} modes, at most {MOST_MODES} are allowed: give a rate to \
                 fewer modes"
            ));
        }
        Ok(())
    }

    /// The case of this spec. The report of `inputs` is that of `mavc plan --recovery`, and `accepted` what the checker
    /// says of their certificate.
    ///
    /// # Errors
    /// Which of the two is wrong, and why: it is not the JSON that it must be, is of another spec, names what the spec
    /// does not have, or the two are of different plans. Or the spec has too many modes for a fault tree.
    pub fn safety_case<'a>(&'a self, inputs: Inputs<'a>, accepted: &'a Accepted) -> Result<Case<'a>, String> {
        self.fits_fault_tree()?;
        let plan = plan_of(inputs.certificate).map_err(|why| format!("cannot use {CERTIFICATE}: {why}"))?;
        let shown = Shown { plan: &plan, ways_out: &accepted.ways_out };
        let evidence = Evidence::read(self.problem(), self.spec().sha256(), inputs.report, &shown)
            .map_err(|why| format!("cannot use {REPORT}: {why}"))?;
        inputs.must_hold(evidence.named.iter()).map_err(|why| format!("cannot use {REPORT}: {why}"))?;
        Ok(Case::new(self.problem(), self.spec(), evidence, inputs, accepted))
    }
}

/// The plan of a certificate.
fn plan_of(certificate: &[u8]) -> Result<PlanClaim, String> {
    let certificate: Certificate = serde_json::from_slice(certificate).map_err(|e| e.to_string())?;
    match certificate.claim {
        Claim::Plan(plan) => Ok(plan),
        Claim::Infeasible(_) | Claim::TooEarly(_) => {
            Err("it proves infeasibility, so there is no plan to assess".into())
        }
    }
}
