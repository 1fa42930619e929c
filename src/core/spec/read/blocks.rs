//! The top level of a spec: collects the blocks of all files and the statements that could not be parsed.

use super::context::{Context, duplicate, second_block};
use super::fields::elsewhere;
use super::flight_blocks::FlightBlocks;
use crate::diagnostic::{Diagnostic, nearest};
use crate::language::Group;
use crate::source::{SourceMap, Span};
use crate::syntax::ast::{Block, Field, Item, SpecFile, Statement};
use crate::syntax::visit::Visit;

/// The top-level blocks of all files, by keyword, in the order of files and statements.
#[derive(Default)]
pub(super) struct Blocks<'a> {
    pub vehicles: Vec<&'a Block>,
    pub faults: Vec<&'a Block>,
    pub missions: Vec<&'a Block>,
    pub plans: Vec<&'a Block>,
    pub simulations: Vec<&'a Block>,
    pub campaigns: Vec<&'a Block>,
    /// The field `gravity`.
    pub gravity: Option<&'a Field>,
}

impl<'a> Blocks<'a> {
    /// Collects the blocks, reads `allow`, and reports unknown fields and duplicates.
    pub fn collect(cx: &mut Context<'a>, trees: &'a [SpecFile], flights: FlightBlocks) -> Self {
        let mut blocks = Blocks::default();
        let mut allows = Vec::new();
        for tree in trees {
            // After a statement that could not be parsed, a field may belong to the block that it should have opened.
            let mut homeless = false;
            for item in &tree.items {
                match item {
                    Item::Block(block) => match block.keyword.value.as_str() {
                        "vehicle" => blocks.vehicles.push(block),
                        "faults" => blocks.faults.push(block),
                        "mission" => blocks.missions.push(block),
                        "plan" => blocks.plans.push(block),
                        "simulate" => blocks.simulations.push(block),
                        "campaign" => blocks.campaigns.push(block),
                        _ => {}
                    },
                    Item::Field(field) if field.name.value == "allow" => allows.push(field),
                    Item::Field(field) if homeless && field.name.value != "gravity" => cx.lose(&field.name.value),
                    Item::Field(field) => top_field(cx, field, &mut blocks.gravity),
                    // A limit opens no block.
                    Item::Broken(span) => homeless |= !cx.sources.snippet(*span).contains(['<', '>']),
                    Item::Let(_) | Item::Use(_) => {}
                }
            }
        }
        cx.allow(&allows);
        no_second(cx, "vehicle", &blocks.vehicles);
        no_second(cx, "mission", &blocks.missions);
        only_one(cx, &blocks.plans);
        for flown in [&blocks.simulations, &blocks.campaigns] {
            cx.of_flights(flights, None, |cx| only_one(cx, flown));
        }
        blocks
    }
}

/// Reads a field outside all blocks: `gravity`, or an error.
fn top_field<'a>(cx: &mut Context<'a>, field: &'a Field, gravity: &mut Option<&'a Field>) {
    let name = &field.name;
    if name.value != "gravity" {
        let message = format!("unknown top-level field `{}`", name.value);
        let error = Diagnostic::error("mavc::name::unknown_field", name.span, message).here("unknown field");
        let error = match (nearest(&name.value, Group::Top.names()), elsewhere(&name.value)) {
            (Some(near), _) => error.help(format!("did you mean `{near}`?")).fix(name.span, near),
            (None, Some(place)) => error.help(place),
            (None, None) => {
                let value = cx.sources.snippet(field.span);
                let value =
                    if value.len() <= 48 && !value.contains('\n') { value } else { &format!("{} = ...", name.value) };
                let before = Span { end: name.span.start, ..name.span };
                error.help(format!("to declare a value, write `let {value}`")).fix(before, "let ")
            }
        };
        cx.report(error);
        cx.lose(&name.value);
    } else if let Some(first) = gravity {
        cx.report(duplicate("field", name, first.name.span));
    } else {
        *gravity = Some(field);
    }
}

/// Reports blocks of one kind with the same name.
fn no_second(cx: &mut Context, what: &str, blocks: &[&Block]) {
    for (i, block) in blocks.iter().enumerate() {
        let Some(name) = &block.name else { continue };
        let first = blocks[..i].iter().filter_map(|b| b.name.as_ref()).find(|n| n.value == name.value);
        if let Some(first) = first {
            let first = first.span;
            cx.report(duplicate(what, name, first));
        }
    }
}

/// Reports a second block of a kind of which a spec may have only one. A block with a misspelt keyword does not count:
/// the misspelling is reported, and another kind may have been meant.
fn only_one(cx: &mut Context, blocks: &[&Block]) {
    let well_spelt = |block: &Block| cx.sources.snippet(block.keyword.span) == block.keyword.value;
    let spelt: Vec<&Block> = blocks.iter().copied().filter(|block| well_spelt(block)).collect();
    let [first, rest @ ..] = spelt.as_slice() else { return };
    for block in rest {
        let message = format!("a spec may have only one `{}` block", block.keyword.value);
        cx.report(second_block(message, block, first));
    }
}

struct BrokenSpans(Vec<Span>);

impl<'t> Visit<'t> for BrokenSpans {
    fn statement(&mut self, statement: &'t Statement) {
        // Only blocks hold statements that declare names.
        if matches!(statement, Statement::Block(_) | Statement::Broken(_)) {
            self.walk_statement(statement);
        }
    }

    fn broken(&mut self, span: &'t Span) {
        self.0.push(*span);
    }
}

/// Every statement that could not be parsed, of those that may declare names.
pub(super) fn broken(trees: &[SpecFile]) -> Vec<Span> {
    let mut spans = BrokenSpans(Vec::new());
    trees.iter().for_each(|tree| spans.file(tree));
    spans.0
}

/// Whether some `use` could not be parsed: then what it would declare is unknown.
pub(super) fn use_broken(trees: &[SpecFile], sources: &SourceMap) -> bool {
    let brings_in = |span: Span| {
        let text = sources.snippet(span);
        // By its keyword, or by the file it names where the keyword is misspelt or borrowed from another language.
        text.split(|c: char| !c.is_ascii_alphanumeric()).next() == Some("use") || text.contains(".mav")
    };
    trees.iter().flat_map(|tree| &tree.items).any(|item| matches!(item, Item::Broken(span) if brings_in(*span)))
}
