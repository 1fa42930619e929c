//! `require capture_height`: the height is a result of simulated flights, which the checker does not repeat. It takes
//! the height from the certificate, decides whether the motion keeps it, and says that nothing more is known of it: a
//! certificate can name any height, simulated or not.

use super::Rejection;
use crate::certificate::Certificate;
use crate::model::Model;
use crate::number::number;
use std::borrow::Cow;

/// The spec with the limits that keep the certificate's height; itself if it requires none, or has them already.
pub fn kept<'m>(certificate: &Certificate, model: &'m Model) -> Result<Cow<'m, Model>, Rejection> {
    let reject = |why: String| Rejection {
        span: model.plan.require_capture.map(|required| required.span),
        ..Rejection::new("the capture height", why)
    };
    match (model.plan.require_capture, certificate.capture_height_m) {
        (None, Some(_)) => Err(reject("the certificate gives one, but the spec requires none".into())),
        (Some(required), Some(height)) if required.height.is_none() => {
            if !(height.is_finite() && height > 0.0) {
                return Err(reject(format!("{} m is not a height", number(height))));
            }
            model.keeping(height).map(Cow::Owned).map_err(|error| reject(error.message.clone()))
        }
        _ => Ok(Cow::Borrowed(model)),
    }
}

/// Why a certificate of a spec that requires the height shows less than the spec asks for, about a plan or about that
/// there is none.
pub fn weaker(model: &Model, of_none: bool) -> Option<String> {
    let required = model.plan.require_capture?;
    Some(match required.height {
        Some(height) if of_none => format!(
            "`require capture_height`: the certificate claims that {} m above the ground are required after a fault; \
             this is not checked, and neither is whether the height was simulated",
            number(height)
        ),
        Some(height) => format!(
            "`require capture_height`: the certificate claims that {} m above the ground is enough after a fault; \
             this is not checked, and neither is whether the height was simulated",
            number(height)
        ),
        None => "`require capture_height` is not checked: the certificate gives no height".into(),
    })
}
