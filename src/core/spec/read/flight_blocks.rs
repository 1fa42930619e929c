//! `simulate` and `campaign` in commands that fly nothing: their errors become warnings.

use super::context::Context;
use super::simulate::Around;
use super::{campaign, simulate};
use crate::diagnostic::{Label, Severity};
use crate::model::{Campaign, DefaultUsed, Simulation};
use crate::source::Span;
use crate::syntax::ast::Block;

/// Whether the model is to be flown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlightBlocks {
    /// Errors in `simulate` and `campaign` are errors.
    Used,
    /// They become warnings, and a block with errors counts as not written.
    Unused,
}

/// Reads `simulate` and `campaign`; `None` for a block with errors.
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
    /// Reads a block that only flights need, with its keyword at `block`. If flights are not used, its errors become
    /// warnings.
    pub(super) fn of_flights<T>(
        &mut self,
        flights: FlightBlocks,
        block: Option<Span>,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let (before, dropped) = (self.diagnostics.len(), self.dropped);
        let value = read(self);
        if flights == FlightBlocks::Used {
            return value;
        }
        for diagnostic in self.diagnostics[before..].iter_mut().filter(|d| d.severity == Severity::Error) {
            diagnostic.severity = Severity::Warning;
            self.softened = true;
            if let Some(span) = block.filter(|span| *span != diagnostic.span) {
                diagnostic.labels.push(Label { span, message: "this block is not used here".into() });
            }
        }
        // If nothing was dropped before, all dropped diagnostics concern this block.
        if dropped == 0 {
            self.dropped_softly += std::mem::take(&mut self.dropped);
        }
        value
    }
}
