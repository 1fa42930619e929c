//! Grammar pairs to tree. Only this module sees the grammar's rules.

mod broken;
mod expected;
mod expression;
mod statement;

use super::ast::*;
use super::layout::{Doc, Layout};
use super::mistake;
use crate::diagnostic::{Diagnostic, Label};
use crate::language::{Place, StatementKind};
use crate::source::{FileId, Span, Spanned, visible};
use pest::Parser;
use pest::iterators::Pair;
use statement::Parts;

#[derive(pest_derive::Parser)]
#[grammar = "grammar/mav.pest"]
struct Grammar;

/// A statement, or the one error that keeps it from being one.
type Built<T> = Result<T, Box<Diagnostic>>;

/// Upper bound on rule calls for one parse: a guard; no text within the other limits comes near.
const MAX_CALLS: usize = 200_000_000;

/// The tree of a laid-out text, and its errors.
pub(super) fn build(file: FileId, layout: &Layout) -> (SpecFile, Vec<Diagnostic>) {
    pest::set_call_limit(std::num::NonZeroUsize::new(MAX_CALLS));
    let Layout { text, docs, diagnostics, blocks_unsure, left_open, .. } = layout;
    let mut builder = Builder {
        file,
        text,
        docs: docs.iter().peekable(),
        diagnostics: diagnostics.clone(),
        settled: diagnostics.iter().map(|d| d.span.start).collect(),
        blocks_unsure: *blocks_unsure,
        left_open: left_open.clone(),
        late_brace: None,
    };
    builder.settled.sort_unstable();
    let items = match Grammar::parse(Rule::file, text) {
        Ok(mut pairs) => builder.file(pairs.next().expect("`file` gives one pair")),
        Err(error) => {
            let at = Span::new(file, expected::position(&error), text.len());
            builder.diagnostics.push(
                Diagnostic::error("mavc::syntax::unexpected", at, "the text cannot be read from here on")
                    .here("here")
                    .help("split the statement"),
            );
            vec![Item::Broken(at)]
        }
    };
    (SpecFile { file, items }, builder.diagnostics)
}

struct Builder<'a> {
    file: FileId,
    /// The laid-out text.
    text: &'a str,
    docs: std::iter::Peekable<std::slice::Iter<'a, Doc>>,
    diagnostics: Vec<Diagnostic>,
    /// Where the layout has reported errors, ascending: a statement around one needs no second error.
    settled: Vec<u32>,
    blocks_unsure: bool,
    /// The opening braces of blocks that were left open.
    left_open: Vec<usize>,
    /// A brace on the line after its head, and the block it opens: the head's error covers both.
    late_brace: Option<(usize, Place)>,
}

/// What a statement turns out to be before its place is looked at.
enum Any {
    Use(Spanned<String>),
    Let(Field),
    Statement(Statement),
}

impl Builder<'_> {
    fn file(&mut self, pair: Pair<Rule>) -> Vec<Item> {
        let body = pair.into_inner().next().expect("a file has a body");
        let unsure = self.blocks_unsure;
        let mut items = self.statements(body, Place::Top, |any, span| match any {
            Any::Use(path) => Item::Use(path),
            Any::Let(field) => Item::Let(field),
            Any::Statement(Statement::Field(field)) => Item::Field(field),
            Any::Statement(Statement::Block(block)) => Item::Block(block),
            Any::Statement(_) => Item::Broken(span),
        });
        // A field after a brace too many belongs to the block that ended there.
        for item in items.iter_mut().filter(|_| unsure) {
            if let Item::Field(field) = item {
                *item = Item::Broken(field.span);
            }
        }
        self.drop_docs(self.text.len());
        self.beside_the_only_one(&items);
        items
    }

    /// A spec has at most one block of some kinds. Correcting the spelling of a second one would not help.
    fn beside_the_only_one(&mut self, items: &[Item]) {
        let keywords = || {
            let blocks = items.iter().filter_map(|item| if let Item::Block(block) = item { Some(block) } else { None });
            blocks.map(|block| &block.keyword)
        };
        let written = |keyword: &Spanned<String>| {
            let Span { start, end, .. } = keyword.span;
            self.text.get(start as usize..end as usize)
        };
        for diagnostic in self.diagnostics.iter_mut().filter(|d| d.code == "mavc::syntax::unknown_statement") {
            let Some(meant) = keywords().find(|k| k.span == diagnostic.span).map(|k| &k.value) else { continue };
            let first = keywords().find(|k| k.value == *meant && written(k) == Some(meant));
            if let Some(first) = first.filter(|_| ["plan", "simulate", "campaign"].contains(&meant.as_str())) {
                diagnostic.labels.push(Label { span: first.span, message: format!("the `{meant}` block is here") });
                diagnostic.help = Some(format!("a spec has one `{meant}` block: move what is missing into it"));
                diagnostic.fix = None;
            }
        }
    }

    fn body(&mut self, pair: Pair<Rule>, place: Place) -> Vec<Statement> {
        let end = pair.as_span().end();
        let statements = self.statements(pair, place, |any, span| match any {
            Any::Statement(statement) => statement,
            Any::Use(_) | Any::Let(_) => Statement::Broken(span),
        });
        self.drop_docs(end);
        statements
    }

    /// Every statement of a body, each wrapped for the list it goes into.
    fn statements<T>(&mut self, body: Pair<Rule>, place: Place, wrap: fn(Any, Span) -> T) -> Vec<T> {
        let mut end_of_block = None;
        let mut list = Vec::new();
        for pair in body.into_inner() {
            let span = self.span(&pair);
            if let Some(end) = end_of_block {
                self.expect_separator(end, span);
            }
            end_of_block = matches!(pair.as_rule(), Rule::block | Rule::broken).then_some(span.end as usize);
            let doc = self.doc(span.start);
            let any = self.statement(pair, place, doc).unwrap_or_else(|diagnostic| {
                self.diagnostics.push(*diagnostic);
                Any::Statement(Statement::Broken(span))
            });
            list.push(wrap(any, span));
        }
        list
    }

    fn statement(&mut self, pair: Pair<Rule>, place: Place, doc: Option<String>) -> Built<Any> {
        match pair.as_rule() {
            Rule::broken => Ok(Any::Statement(self.broken(pair, place))),
            Rule::block => self.block(pair, place, doc).map(Any::Statement),
            _ => {
                let (any, kind) = self.simple(pair.clone(), doc)?;
                self.check_place(kind, place, &pair)?;
                Ok(any)
            }
        }
    }

    fn simple(&self, pair: Pair<Rule>, doc: Option<String>) -> Built<(Any, StatementKind)> {
        let span = self.span(&pair);
        let rule = pair.as_rule();
        let mut parts = Parts { file: self.file, pairs: pair.into_inner() };
        let (statement, kind) = match rule {
            Rule::import => {
                parts.skip(Rule::kw_use);
                return Ok((Any::Use(parts.text()), StatementKind::Use));
            }
            Rule::binding => {
                parts.skip(Rule::kw_let);
                return Ok((Any::Let(parts.field(span, doc)?), StatementKind::Let));
            }
            Rule::field => (Statement::Field(parts.field(span, doc)?), StatementKind::Field),
            Rule::limit => (parts.limit(span)?, StatementKind::Limit),
            Rule::requirement => (parts.requirement(span)?, StatementKind::Require),
            Rule::fault => (parts.fault(span)?, StatementKind::Fault),
            Rule::every_head => (parts.every(span, doc)?, StatementKind::Every),
            Rule::rotor => (Statement::Rotor(parts.clauses(span, doc)?), StatementKind::RotorAt),
            Rule::strike => (Statement::Strike(parts.clauses(span, doc)?), StatementKind::Strike),
            Rule::start => (Statement::Start(parts.clauses(span, doc)?), StatementKind::Flight),
            Rule::waypoint => (Statement::Waypoint(parts.clauses(span, doc)?), StatementKind::Flight),
            Rule::moving => (parts.moving(span), StatementKind::Flight),
            Rule::hold => {
                parts.skip(Rule::kw_hold);
                (Statement::Hold { duration: parts.expr()?, span }, StatementKind::Flight)
            }
            _ => {
                parts.skip(Rule::kw_waypoints);
                parts.skip(Rule::kw_from);
                (Statement::WaypointsFrom { path: parts.text(), span }, StatementKind::Flight)
            }
        };
        Ok((Any::Statement(statement), kind))
    }

    fn block(&mut self, pair: Pair<Rule>, place: Place, doc: Option<String>) -> Built<Statement> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let head = inner.next().expect("a block has a head");
        let opened = inner.next().map_or(span.start as usize, |brace| brace.as_span().start());
        let body = inner.find(|p| p.as_rule() == Rule::body).expect("a block has a body");
        let is_closed = inner.next().is_some();
        let rule = head.as_rule();
        let mut parts = Parts { file: self.file, pairs: head.clone().into_inner() };
        let (kind, around) = match rule {
            Rule::every_head => (StatementKind::Every, Place::Every),
            Rule::curve_head => (StatementKind::Curve, Place::Curve),
            Rule::waypoint | Rule::start => (StatementKind::Flight, Place::Limits),
            _ => match self.block_kind(&head, &body, place) {
                Some(inside) => (StatementKind::Block(inside), inside),
                None => {
                    let word = head.as_str().split(|c: char| !c.is_ascii_alphanumeric()).next();
                    match word.is_some_and(|word| place.has_braceless(word)) {
                        // `start at { 0, 0, 2 } m`: neither what the braces hold nor what follows them is a statement.
                        true => {
                            self.settle(self.text.len() - self.text[span.end as usize..].trim_start_matches(' ').len());
                        }
                        false => drop(self.body(body, Place::Unknown)),
                    }
                    return Ok(Statement::Broken(span));
                }
            },
        };
        let mut wrong_head = None;
        let made = match rule {
            Rule::every_head => parts.every(span, doc),
            Rule::curve_head => parts.curve(span, doc),
            Rule::waypoint => parts.clauses(span, doc).map(Statement::Waypoint),
            Rule::start => parts.clauses(span, doc).map(Statement::Start),
            _ => parts.block(span, doc).map(|mut block| {
                wrong_head = mistake::check_head(&mut block, around);
                Statement::Block(block)
            }),
        };
        let fits = self.check_place(kind, place, &head);
        let mut statements = self.body(body, around);
        fits?;
        if let Some(diagnostic) = wrong_head {
            // The statements of the block are checked all the same. A misspelt keyword and a missing name are one
            // error.
            let is_one = |d: &&mut Diagnostic| d.span == diagnostic.span;
            match self.diagnostics.iter_mut().find(is_one) {
                Some(misspelt) => {
                    misspelt.help = diagnostic.help;
                    misspelt.fix = None;
                }
                None => self.diagnostics.push(diagnostic),
            }
            statements.push(Statement::Broken(self.span(&head)));
        }
        if is_closed && self.left_open.contains(&opened) {
            // It ends with the brace of the block around it, and holds statements of that block.
            return Ok(Statement::Broken(span));
        }
        if !is_closed {
            // What is still to come is unknown.
            statements.push(Statement::Broken(Span { start: span.end, ..span }));
        }
        let mut statement = made?;
        match &mut statement {
            Statement::Block(Block { body, .. })
            | Statement::Every { body, .. }
            | Statement::Curve { body, .. }
            | Statement::Start(Clauses { body, .. })
            | Statement::Waypoint(Clauses { body, .. }) => *body = statements,
            _ => {}
        }
        Ok(statement)
    }

    /// The block that a head opens; one that is misspelt is reported and taken as the one meant.
    fn block_kind(&mut self, head: &Pair<Rule>, body: &Pair<Rule>, place: Place) -> Option<Place> {
        let keyword = head.clone().into_inner().next().expect("a head has a keyword");
        let first = body.clone().into_inner().next();
        if keyword.as_str() == "rotor" && place == Place::Vehicle && first.is_some_and(|s| s.as_rule() == Rule::rotor) {
            self.diagnostics.push(mistake::rotors_without_s(self.span(&keyword)));
            return Some(Place::Rotors);
        }
        Place::of_block(keyword.as_str()).or_else(|| {
            let (diagnostic, meant) = mistake::unknown_block(keyword.as_str(), self.span(&keyword), place);
            self.diagnostics.push(diagnostic);
            meant
        })
    }

    fn check_place(&self, kind: StatementKind, place: Place, pair: &Pair<Rule>) -> Built<()> {
        if kind.fits(place) || self.blocks_unsure {
            return Ok(());
        }
        Err(Box::new(mistake::misplaced(kind, place, pair.as_str().trim_end(), self.span(pair))))
    }

    /// The `///` lines before a statement, joined.
    fn doc(&mut self, start: u32) -> Option<String> {
        let mut lines = Vec::new();
        while let Some(doc) = self.docs.next_if(|d| d.span.start < start) {
            // It is shown, and never read again.
            lines.push(visible::text(&doc.text));
        }
        (!lines.is_empty()).then(|| lines.join("\n"))
    }

    /// `///` lines that no statement follows in their block.
    fn drop_docs(&mut self, end: usize) {
        while let Some(doc) = self.docs.next_if(|d| (d.span.start as usize) < end) {
            self.diagnostics.push(
                Diagnostic::warning("mavc::syntax::dangling_doc", doc.span, "this `///` comment documents nothing")
                    .here("no statement follows it")
                    .help("write `//` for a comment that belongs to no statement")
                    .fix(Span { end: doc.span.start + 3, ..doc.span }, "//"),
            );
        }
    }

    fn span(&self, pair: &Pair<Rule>) -> Span {
        span_of(self.file, pair)
    }
}

/// Without the blanks that an absent optional part leaves at the end.
fn span_of(file: FileId, pair: &Pair<Rule>) -> Span {
    let start = pair.as_span().start();
    Span::new(file, start, start + pair.as_str().trim_end().len())
}

fn unquote(text: &str) -> String {
    text.trim_matches('"').to_string()
}
