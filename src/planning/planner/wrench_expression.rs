//! The wrench at an instant in a program's variables, built once for all facets there.

use crate::actuation::Wrench;
use crate::motion::hover_map::WrenchMap;
use crate::planner::commands::CommandAt;
use crate::planner::transcription::Transcription;
use crate::qp::build::Affine;

/// `constant + sum of coefficient times variable`, N and N m; each variable once.
pub struct WrenchExpression {
    terms: Vec<(usize, Wrench)>,
    constant: Wrench,
}

impl WrenchExpression {
    /// A constant and expressions with their coefficients.
    fn of(constant: Wrench, parts: impl IntoIterator<Item = (Affine, Wrench)>) -> Self {
        let mut expression = WrenchExpression { terms: Vec::with_capacity(32), constant };
        for (part, c) in parts {
            expression.constant += c * part.constant;
            for (variable, coefficient) in part.terms {
                match expression.terms.iter_mut().find(|t| t.0 == variable) {
                    Some(term) => term.1 += c * coefficient,
                    None => expression.terms.push((variable, c * coefficient)),
                }
            }
        }
        expression
    }

    /// Component `n . w`.
    pub fn along(&self, n: &Wrench) -> Affine {
        let terms = self.terms.iter().map(|(variable, c)| (*variable, n.dot(c))).filter(|t| t.1 != 0.0);
        Affine { terms: terms.collect(), constant: n.dot(&self.constant) }
    }
}

impl Transcription<'_> {
    /// The wrench at an instant, by its map among [`Self::maps`].
    pub(super) fn wrench_expression(&self, instant: usize) -> WrenchExpression {
        let map = &self.maps[instant];
        let parts = map.terms.iter().map(|&(axis, order, c)| (self.derivative(instant, axis, order), c));
        WrenchExpression::of(map.constant, parts)
    }

    /// The commanded wrench by its map. `None` if there is no such interval.
    pub(super) fn command_expression(&self, map: &WrenchMap, at: CommandAt) -> Option<WrenchExpression> {
        let part = |&(axis, order, c): &(usize, usize, Wrench)| Some((self.command_derivative(at, axis, order)?, c));
        let parts: Option<Vec<_>> = map.terms.iter().map(part).collect();
        Some(WrenchExpression::of(map.constant, parts?))
    }
}
