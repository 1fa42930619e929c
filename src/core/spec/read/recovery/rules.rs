//! The blocks of a mission that concern the time after a fault.

use super::{VALUE, sites};
use crate::language::Group;
use crate::language::table::mission as table;
use crate::model::AfterFaultRules;
use crate::read::context::{Context, second_block};
use crate::read::fields::Fields;
use crate::read::written::Written;
use crate::read::{limits, plausibility, volume};
use crate::syntax::Place;
use crate::syntax::ast::Block;

/// The blocks of one mission, in the order written.
#[derive(Default)]
pub struct Blocks<'a> {
    sites: Vec<&'a Block>,
    keep_off: Vec<&'a Block>,
    limits: Option<&'a Block>,
}

impl<'a> Blocks<'a> {
    /// Takes a block of the mission if it is one of these; whether it is.
    pub fn take(&mut self, cx: &mut Context<'a>, block: &'a Block) -> bool {
        match Place::of_block(&block.keyword.value) {
            Some(Place::LandingSite) => self.sites.push(block),
            Some(Place::KeepOff) => self.keep_off.push(block),
            Some(Place::AfterFaultLimits) => match self.limits {
                Some(first) => {
                    let message = "a mission may have only one `after_fault_limits` block";
                    cx.report(second_block(message.into(), block, first));
                }
                None => self.limits = Some(block),
            },
            _ => return false,
        }
        true
    }

    /// Reads them, and the mission's `buffer` among its fields; `None` where something has an error.
    pub fn read(self, cx: &mut Context<'a>, fields: &Fields<'a>, ground: Written<f64>) -> Option<AfterFaultRules> {
        let sites = sites::read(cx, &self.sites, ground, fields.span);
        let keep_off = volume::read_keep_off(cx, &self.keep_off);
        let buffer = fields.quantity(cx, &table::BUFFER, VALUE).or_default(|| table::BUFFER.value());
        let body = self.limits.map_or(&[][..], |block| &block.body);
        let (limits, is_whole) = limits::read(cx, body, Group::AfterFaultLimits);
        plausibility::check_limits(cx, &limits);
        let rules = AfterFaultRules { sites: sites?, keep_off: keep_off?, buffer: buffer?, limits };
        is_whole.then_some(rules)
    }
}
