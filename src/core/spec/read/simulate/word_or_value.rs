//! Fields that take a word or a quantity: `detection = never` or `50 ms`, `lost_yaw = off` or `45 deg`.

use super::{CHOICE, NEGATIVE, Reader};
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::table::simulate as table;
use crate::model::{Detection, LostYaw};
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::syntax::ast::{Expr, ExprKind};
use std::f64::consts::PI;

const LOST_YAW: &str = "mavc::simulate::lost_yaw";
const OFF: &str = "off";

impl<'a> Reader<'a> {
    pub(super) fn detection(&mut self, cx: &mut Context<'a>) -> Option<Detection> {
        let Some(expr) = self.fields.get("detection") else {
            return Some(self.fields.default(&table::DETECTION, Detection::Estimator));
        };
        match word(cx, expr, table::DETECTION.words()) {
            Some("estimator") => Some(Detection::Estimator),
            Some("never") => Some(Detection::Never),
            Some(other) => {
                let message = "`detection` must be `estimator`, `never` or a delay such as `50 ms`";
                let error = Diagnostic::error(CHOICE, expr.span, message).here("none of these");
                cx.report(match nearest(other, table::DETECTION.words().iter().copied()) {
                    Some(near) => error.help(format!("did you mean `{near}`?")).fix(expr.span, near),
                    None => error.help("write one of these, such as `estimator`"),
                });
                None
            }
            None => cx.quantity(&table::DETECTION, expr, NEGATIVE).map(Detection::After),
        }
    }

    pub(super) fn lost_yaw(&mut self, cx: &mut Context<'a>) -> Option<LostYaw> {
        let Some(expr) = self.fields.get("lost_yaw") else {
            return Some(self.fields.default(&table::LOST_YAW, LostYaw::Beyond(table::LOST_YAW.value())));
        };
        let message = "`lost_yaw` must be an angle between 0 and 180 deg, or `off`";
        let error = Diagnostic::error(LOST_YAW, expr.span, message);
        match word(cx, expr, &[OFF]) {
            Some(OFF) => Some(LostYaw::Off),
            Some(other) => {
                let error = error.here("neither of these");
                cx.report(match nearest(other, [OFF]) {
                    Some(near) => error.help(format!("did you mean `{near}`?")).fix(expr.span, near),
                    None => error.help("write `off`, or an angle such as `90 deg`"),
                });
                None
            }
            None => {
                let angle = cx.number(Expected::of(&table::LOST_YAW), expr)?;
                if angle > 0.0 && angle < PI {
                    return Some(LostYaw::Beyond(angle));
                }
                let error = error.here(format!("this is {} deg", number(angle.to_degrees())));
                cx.report(match angle > 0.0 {
                    true => error.help("write `off`: no heading error exceeds 180 deg").fix(expr.span, OFF),
                    false => error.help("write an angle such as `90 deg`"),
                });
                None
            }
        }
    }
}

/// A word written instead of a quantity, one of `known` or not; `None` for a quantity and for a name that may be a
/// `let`.
fn word<'e>(cx: &Context, expr: &'e Expr, known: &[&str]) -> Option<&'e str> {
    match &expr.kind {
        ExprKind::Name(name) if known.contains(&name.as_str()) => Some(name),
        ExprKind::Name(name) if !cx.in_scope(name) && !cx.may_exist(name) => Some(name),
        _ => None,
    }
}
