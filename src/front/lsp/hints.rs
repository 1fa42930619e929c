//! Inlay hints: values in SI, how many modes an `every` declares, how many `against` selects.

use super::documents::{offsets, position};
use super::hover::si;
use super::mentions::What;
use super::names::NameKind;
use super::workspace::Spec;
use crate::source::{FileId, Span};
use crate::syntax::ast::{Field, FieldValue, Item, Statement};
use crate::unit::parse_unit;
use gen_lsp_types::{InlayHint, InlayHintKind, Range};

/// The hints of a range of one file, in the order of their places.
pub fn hints(spec: &Spec, file: FileId, asked: Range) -> Vec<InlayHint> {
    let source = spec.source(file);
    let (start, end) = offsets(source, asked);
    let wanted = |span: Span| span.file == file && span.end as usize >= start && span.end as usize <= end;
    let mut found: Vec<(u32, String)> = Vec::new();
    for reading in spec.understanding.readings.iter().filter(|r| wanted(r.span)) {
        if says_less(spec, reading.span) {
            found.push((reading.span.end, format!("= {}", si(reading))));
        }
    }
    for definition in spec.names().of_kind(NameKind::Modes).filter(|d| wanted(d.span)) {
        let modes = spec.understanding.modes.iter().filter(|mode| mode.span == definition.statement);
        let names: Vec<&str> = modes.map(|mode| mode.name.as_str()).collect();
        if let [first, .., last] = names.as_slice() {
            found.push((definition.span.end, format!("{} modes: {first} ... {last}", names.len())));
        }
    }
    if let Some((field, model)) = against(spec, file).zip(spec.model.as_ref()).filter(|(f, _)| wanted(f.span)) {
        let is_list = matches!(&field.value, FieldValue::Expr(expr) if spec.snippet(expr.span).starts_with('['));
        if !is_list {
            let count = model.plan.against.len();
            found.push((field.span.end, format!("{count} {}", if count == 1 { "mode" } else { "modes" })));
        }
    }
    found.sort();
    // A `let` that is used in place is read twice.
    found.dedup_by_key(|hint| hint.0);
    let hint = |(at, label): (u32, String)| {
        let (at, kind) = (position(source, at as usize), Some(InlayHintKind::Type));
        InlayHint::new(at, label.into(), kind, None, None, Some(true), None, None)
    };
    found.into_iter().map(hint).collect()
}

/// Whether what is written is more than numbers in SI: another unit, a name or a calculation.
fn says_less(spec: &Spec, span: Span) -> bool {
    let is_si = |text: &str| {
        let unit = parse_unit(text, spec.understanding.gravity);
        text == "%" || unit.is_ok_and(|unit| unit.numerator == unit.denominator)
    };
    spec.mentions().within(span).iter().any(|m| match m.what {
        What::Unit => !is_si(spec.snippet(m.span)),
        What::Reference(_) | What::Function => true,
        _ => false,
    })
}

/// The `against` of the plan, if it is in this file.
fn against(spec: &Spec, file: FileId) -> Option<&Field> {
    let tree = spec.files.files.iter().find(|tree| tree.file == file)?;
    let blocks = tree.items.iter().filter_map(|item| if let Item::Block(block) = item { Some(block) } else { None });
    let plan = blocks.filter(|block| block.keyword.value == "plan");
    plan.flat_map(|block| &block.body).find_map(|statement| match statement {
        Statement::Field(field) if field.name.value == "against" => Some(field),
        _ => None,
    })
}
