//! What mavc's checker is made of, and nothing of its planner: the language, the spec, the records of certificates and
//! the code that decides them. The program `mavc-verify` ([`program`]) is this crate alone; `mavc` re-exports its
//! modules.
//!
//! ```text
//! Source --syntax::parse--> SpecFile --read::elaborate--> Model --verify::decide(certificate)--> Accepted
//! ```
//!
//! | room | what comes in | what goes out | what it does not know |
//! |---|---|---|---|
//! | `base` | bytes, numbers | texts with places, diagnostics, quantities, tolerances | the language |
//! | [`language`] | texts | trees; the table of all fields | vehicles |
//! | [`spec`] | trees | a [`Spec`](spec::Spec): names resolved, SI units, every number in range | sets, planners |
//! | `proof` | a spec and a certificate | a verdict | how the certificate was made |

mod base;
pub mod language;
pub mod program;
mod proof;
pub mod spec;

pub use base::{
    body, diagnostic, foreign, geodesy, input, number, source, stages, text_table, tolerance, unit, verdict,
};
pub use language::{format, syntax};
pub use proof::{certificate, verify};
pub use spec::{model, read};

#[cfg(test)]
mod tests {
    /// Not beside the records, which know of no other module.
    #[test]
    fn the_schema_of_certificates_is_current() {
        crate::base::schemas::check::<crate::certificate::Certificate>("certificate", "mavc plan --certificate");
    }
}
