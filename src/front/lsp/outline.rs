//! The outline of a file, and its folds.

use super::documents::range;
use super::workspace::Spec;
use crate::source::{FileId, Source, Span};
use crate::syntax::ast::{Block, Clauses, Field, Item, Name, Statement};
use crate::syntax::scan::{LexemeKind, lexemes};
use gen_lsp_types::{DocumentSymbol, FoldingRange, FoldingRangeKind, SymbolKind};

/// Blocks, statements that have names, and fields, nested as in the text.
pub fn symbols(spec: &Spec, file: FileId) -> Vec<DocumentSymbol> {
    let Some(tree) = spec.files.files.iter().find(|tree| tree.file == file) else { return Vec::new() };
    let source = spec.source(file);
    let item = |item: &Item| match item {
        Item::Let(field) => Some(named(source, &field.name, "let", field.span, SymbolKind::Variable)),
        Item::Field(field) => Some(self::field(source, field)),
        Item::Block(block) => Some(self::block(source, block)),
        Item::Use(_) | Item::Broken(_) => None,
    };
    tree.items.iter().filter_map(item).collect()
}

fn block(source: &Source, block: &Block) -> DocumentSymbol {
    let kind = match block.keyword.value.as_str() {
        "vehicle" => SymbolKind::Class,
        "mission" => SymbolKind::Function,
        "mode" => SymbolKind::Event,
        "landing_site" => SymbolKind::Constant,
        "rotor" | "rotors" | "battery" | "parts" | "part" => SymbolKind::Struct,
        _ => SymbolKind::Module,
    };
    let keyword = &block.keyword;
    let mut symbol = match &block.name {
        Some(name) => named(source, name, &keyword.value, block.span, kind),
        None => named(source, keyword, "", block.span, kind),
    };
    if let Some(title) = &block.title {
        symbol.detail = Some(format!("{} “{}”", keyword.value, title.value));
    }
    symbol.children = Some(block.body.iter().filter_map(|s| statement(source, s)).collect());
    symbol
}

fn statement(source: &Source, statement: &Statement) -> Option<DocumentSymbol> {
    let children = |body: &[Statement]| Some(body.iter().filter_map(|s| self::statement(source, s)).collect());
    Some(match statement {
        Statement::Field(field) => self::field(source, field),
        Statement::Block(block) => self::block(source, block),
        Statement::Every { prefix, body, span, .. } => {
            let symbol = named(source, prefix, "every", *span, SymbolKind::Event);
            DocumentSymbol { children: children(body), ..symbol }
        }
        Statement::Curve { parameter, body, span, .. } => {
            let symbol = named(source, parameter, "curve", *span, SymbolKind::Function);
            DocumentSymbol { children: children(body), ..symbol }
        }
        Statement::Waypoint(Clauses { name: Some(name), span, .. }) => {
            named(source, name, "waypoint", *span, SymbolKind::Constant)
        }
        Statement::Strike(Clauses { name: Some(name), span, .. }) => {
            named(source, name, "fault", *span, SymbolKind::Event)
        }
        Statement::Limit { name, span, .. } => named(source, name, "limit", *span, SymbolKind::Property),
        _ => return None,
    })
}

fn field(source: &Source, field: &Field) -> DocumentSymbol {
    named(source, &field.name, "", field.span, SymbolKind::Property)
}

fn named(source: &Source, name: &Name, detail: &str, span: Span, kind: SymbolKind) -> DocumentSymbol {
    // The name lies within the statement, as clients insist.
    let whole = span.to(name.span);
    let at = |span: Span| range(source, span.start as usize, span.end as usize);
    let detail = (!detail.is_empty()).then(|| detail.to_string());
    DocumentSymbol::new(name.value.clone(), detail, kind, None, None, at(whole), at(name.span), None)
}

/// Braces and brackets over several lines, and runs of comments; whether or not the text can be read.
pub fn folds(source: &Source) -> Vec<FoldingRange> {
    let line = |at: usize| source.place_utf16(at).0;
    let mut found = Vec::new();
    let mut open: Vec<(char, u32)> = Vec::new();
    let mut comments: Option<(u32, u32)> = None;
    let mut fold = |first: u32, last: u32, kind: Option<FoldingRangeKind>| {
        if first < last {
            found.push(FoldingRange::new(first, None, last, None, kind, None));
        }
    };
    for lexeme in lexemes(&source.text) {
        match lexeme.kind {
            LexemeKind::Comment | LexemeKind::Doc => {
                let at = line(lexeme.start);
                let alone = source.text[source.line(at as usize + 1).start..lexeme.start].trim().is_empty();
                comments = match comments {
                    Some((first, last)) if alone && last + 1 == at => Some((first, at)),
                    earlier => {
                        earlier.iter().for_each(|c| fold(c.0, c.1, Some(FoldingRangeKind::Comment)));
                        alone.then_some((at, at))
                    }
                };
            }
            LexemeKind::Mark(mark @ ('{' | '[' | '(')) => open.push((mark, line(lexeme.start))),
            LexemeKind::Mark(mark @ ('}' | ']' | ')')) => {
                let opening = match mark {
                    '}' => '{',
                    ']' => '[',
                    _ => '(',
                };
                // Brackets still open inside were never closed.
                if let Some(at) = open.iter().rposition(|o| o.0 == opening) {
                    let first = open[at].1;
                    open.truncate(at);
                    // The closing mark stays in sight.
                    fold(first, line(lexeme.start).saturating_sub(1), None);
                }
            }
            _ => {}
        }
    }
    comments.iter().for_each(|c| fold(c.0, c.1, Some(FoldingRangeKind::Comment)));
    found.sort_by_key(|f| (f.start_line, f.end_line));
    found
}
