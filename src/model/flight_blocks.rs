//! Errors of `simulate` and `campaign` in commands that fly nothing: they are warned of, and do not stand in the way.

use super::context::Context;
use super::simulate::Around;
use super::{Campaign, DefaultUsed, Simulation, campaign, simulate};
use crate::diagnostic::{Label, Severity};
use crate::source::Span;
use crate::syntax::ast::Block;

/// Whether a model is made to be flown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlightBlocks {
    /// Mistakes in `simulate` and `campaign` are errors.
    Used,
    /// They are warnings, and a block that has some counts as one that is not written.
    Unused,
}

/// `simulate` and `campaign`; `None` for one that has errors.
pub(super) fn read<'a>(
    cx: &mut Context<'a>,
    [simulate, campaign]: [Option<&'a Block>; 2],
    flights: FlightBlocks,
    around: &Around,
    defaults: &mut Vec<DefaultUsed>,
) -> (Option<Simulation>, Option<Campaign>) {
    let place = |block: Option<&Block>| block.map(|block| block.keyword.span);
    let campaign_span = place(campaign);
    let (mut simulation, mut used) = cx.of_flights(flights, place(simulate).or(campaign_span), |cx| {
        simulate::elaborate(cx, simulate, campaign_span, around)
    });
    defaults.append(&mut used);
    let (mut flown, mut used) = cx.of_flights(flights, campaign_span, |cx| campaign::elaborate(cx, campaign, around));
    defaults.append(&mut used);
    if flights == FlightBlocks::Unused {
        let span = around.fallback;
        simulation.get_or_insert_with(|| Simulation { span, rate_span: span, ..Simulation::default() });
        flown.get_or_insert_with(|| Campaign { span, ..Campaign::default() });
    }
    (simulation, flown)
}

impl<'a> Context<'a> {
    /// Reads a block that only flights need, whose keyword stands at `block`.
    pub(super) fn of_flights<T>(
        &mut self,
        flights: FlightBlocks,
        block: Option<Span>,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let (told, dropped) = (self.diagnostics.len(), self.dropped);
        let value = read(self);
        if flights == FlightBlocks::Used {
            return value;
        }
        for diagnostic in self.diagnostics[told..].iter_mut().filter(|d| d.severity == Severity::Error) {
            diagnostic.severity = Severity::Warning;
            self.softened = true;
            if let Some(span) = block.filter(|span| *span != diagnostic.span) {
                diagnostic.labels.push(Label { span, message: "this block is not used here".into() });
            }
        }
        // As long as there was room for all that came before, nothing else was dropped.
        if dropped == 0 {
            self.dropped_softly += std::mem::take(&mut self.dropped);
        }
        value
    }
}
