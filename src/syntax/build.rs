//! Grammar pairs to tree. Only this room sees the grammar's rules.

mod expected;
mod expression;

use super::ast::*;
use super::layout::{Doc, Layout};
use super::mistake;
use super::place::{Kind, Place};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span, Spanned};
use pest::Parser;
use pest::iterators::{Pair, Pairs};

#[derive(pest_derive::Parser)]
#[grammar = "grammar/mav.pest"]
struct Grammar;

/// A statement, or the one error that keeps it from being one.
type Built<T> = Result<T, Box<Diagnostic>>;

/// Upper bound on rule calls for one parse; a guard that no text within the other limits comes near.
const MAX_CALLS: usize = 200_000_000;

pub(super) fn build(file: FileId, layout: Layout) -> (SpecFile, Vec<Diagnostic>) {
    pest::set_call_limit(std::num::NonZeroUsize::new(MAX_CALLS));
    let Layout {
        text,
        docs,
        diagnostics,
        blocks_unsure,
        ..
    } = layout;
    let starts = diagnostics.iter().map(|d| d.span.start).collect();
    let mut builder = Builder {
        file,
        text: &text,
        docs: docs.into_iter().peekable(),
        diagnostics,
        settled: starts,
        blocks_unsure,
    };
    builder.settled.sort_unstable();
    let items = match Grammar::parse(Rule::file, &text) {
        Ok(mut pairs) => builder.file(pairs.next().expect("`file` gives one pair")),
        Err(error) => {
            let at = Span::new(file, expected::position(&error), text.len());
            builder.diagnostics.push(
                Diagnostic::error(
                    "mavc::syntax::unexpected",
                    at,
                    "the text cannot be read from here on",
                )
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
    docs: std::iter::Peekable<std::vec::IntoIter<Doc>>,
    diagnostics: Vec<Diagnostic>,
    /// Where the layout has reported errors, ascending: a statement around one needs no second error.
    settled: Vec<u32>,
    blocks_unsure: bool,
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
        let items = self.statements(body, Place::Top, |any, span| match any {
            Any::Use(path) => Item::Use(path),
            Any::Let(field) => Item::Let(field),
            Any::Statement(Statement::Field(field)) => Item::Field(field),
            Any::Statement(Statement::Block(block)) => Item::Block(block),
            Any::Statement(_) => Item::Broken(span),
        });
        self.drop_docs(self.text.len());
        items
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
    fn statements<T>(
        &mut self,
        body: Pair<Rule>,
        place: Place,
        wrap: fn(Any, Span) -> T,
    ) -> Vec<T> {
        let mut end_of_block = None;
        let mut list = Vec::new();
        for pair in body.into_inner() {
            let span = self.span(&pair);
            if let Some(end) = end_of_block {
                self.expect_separator(end, span.start as usize);
            }
            end_of_block =
                matches!(pair.as_rule(), Rule::block | Rule::broken).then_some(span.end as usize);
            let doc = self.doc(span.start);
            let any = self
                .statement(pair, place, doc)
                .unwrap_or_else(|diagnostic| {
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

    fn simple(&self, pair: Pair<Rule>, doc: Option<String>) -> Built<(Any, Kind)> {
        let span = self.span(&pair);
        let rule = pair.as_rule();
        let mut parts = Parts {
            file: self.file,
            pairs: pair.into_inner(),
        };
        let (statement, kind) = match rule {
            Rule::import => {
                parts.skip(Rule::kw_use);
                return Ok((Any::Use(parts.text()), Kind::Use));
            }
            Rule::binding => {
                parts.skip(Rule::kw_let);
                return Ok((Any::Let(parts.field(span, doc)?), Kind::Let));
            }
            Rule::field => (Statement::Field(parts.field(span, doc)?), Kind::Field),
            Rule::limit => (parts.limit(span)?, Kind::Limit),
            Rule::fault => (parts.fault(span)?, Kind::Fault),
            Rule::every_head => (parts.every(span, doc)?, Kind::Every),
            Rule::rotor => (Statement::Rotor(parts.clauses(span, doc)?), Kind::RotorAt),
            Rule::start => (Statement::Start(parts.clauses(span, doc)?), Kind::Flight),
            Rule::waypoint => (Statement::Waypoint(parts.clauses(span, doc)?), Kind::Flight),
            Rule::moving => (parts.moving(span), Kind::Flight),
            Rule::hold => {
                parts.skip(Rule::kw_hold);
                (
                    Statement::Hold {
                        duration: parts.expr()?,
                        span,
                    },
                    Kind::Flight,
                )
            }
            _ => {
                parts.skip(Rule::kw_waypoints);
                parts.skip(Rule::kw_from);
                (
                    Statement::WaypointsFrom {
                        path: parts.text(),
                        span,
                    },
                    Kind::Flight,
                )
            }
        };
        Ok((Any::Statement(statement), kind))
    }

    fn block(&mut self, pair: Pair<Rule>, place: Place, doc: Option<String>) -> Built<Statement> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let head = inner.next().expect("a block has a head");
        let body = inner
            .find(|p| p.as_rule() == Rule::body)
            .expect("a block has a body");
        let rule = head.as_rule();
        let mut parts = Parts {
            file: self.file,
            pairs: head.clone().into_inner(),
        };
        let (kind, around) = match rule {
            Rule::every_head => (Kind::Every, Place::Every),
            Rule::curve_head => (Kind::Curve, Place::Curve),
            _ => match self.block_kind(&head, place) {
                Some(inside) => (Kind::Block(inside), inside),
                None => {
                    self.body(body, Place::Unknown);
                    return Ok(Statement::Broken(span));
                }
            },
        };
        let made = match rule {
            Rule::every_head => parts.every(span, doc),
            Rule::curve_head => parts.curve(span, doc),
            _ => parts
                .block(span, doc)
                .and_then(|block| mistake::check_head(block, around)),
        };
        let fits = self.check_place(kind, place, &head);
        let statements = self.body(body, around);
        fits?;
        let mut statement = made?;
        match &mut statement {
            Statement::Block(Block { body, .. })
            | Statement::Every { body, .. }
            | Statement::Curve { body, .. } => {
                *body = statements;
            }
            _ => {}
        }
        Ok(statement)
    }

    /// The block that a head opens; one that is misspelt is reported and taken as the one meant.
    fn block_kind(&mut self, head: &Pair<Rule>, place: Place) -> Option<Place> {
        let keyword = head
            .clone()
            .into_inner()
            .next()
            .expect("a head has a keyword");
        Place::of_block(keyword.as_str()).or_else(|| {
            let (diagnostic, meant) =
                mistake::unknown_block(keyword.as_str(), self.span(&keyword), place);
            self.diagnostics.push(diagnostic);
            meant
        })
    }

    /// Something between separators that is no statement: reported once, then what it encloses is read.
    fn broken(&mut self, pair: Pair<Rule>, place: Place) -> Statement {
        let span = self.span(&pair);
        let mut head = Span {
            end: span.start,
            ..span
        };
        let mut has_body = false;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::broken_text => {
                    head = Span::new(self.file, span.start as usize, part.as_span().end())
                }
                Rule::lbrace => has_body = true,
                Rule::body => {
                    self.explain(head, place, true);
                    let word = self.text[head.start as usize..]
                        .split(|c: char| !c.is_ascii_alphanumeric())
                        .next();
                    let inside = word.and_then(Place::of_block).unwrap_or(Place::Unknown);
                    self.body(part, inside);
                }
                _ => {}
            }
        }
        if !has_body {
            self.explain(head, place, false);
        }
        Statement::Broken(span)
    }

    fn explain(&mut self, head: Span, place: Place, has_body: bool) {
        let text = self.text[head.start as usize..head.end as usize].trim_end();
        let end = head.start as usize + text.len();
        let first = self.settled.partition_point(|&s| s < head.start);
        if self
            .settled
            .get(first)
            .is_some_and(|&s| s as usize <= end.max(head.start as usize))
        {
            return;
        }
        let failure = expected::failure(text, place, has_body);
        let statement = mistake::Broken {
            file: self.file,
            text,
            start: head.start as usize,
            place,
            has_body,
        };
        self.diagnostics
            .push(mistake::explain(&statement, &failure));
    }

    fn check_place(&self, kind: Kind, place: Place, pair: &Pair<Rule>) -> Built<()> {
        if kind.fits(place) || self.blocks_unsure {
            return Ok(());
        }
        let span = self.span(pair);
        let text = pair.as_str().trim_end();
        let word = text
            .split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
            .next()
            .unwrap_or(text);
        let span = Span {
            end: span.start + word.len() as u32,
            ..span
        };
        Err(Box::new(mistake::misplaced(kind, place, word, span)))
    }

    fn expect_separator(&mut self, end: usize, start: usize) {
        if !self.text[end..start].contains(['\n', ';', '\u{4}']) {
            let span = Span::new(self.file, start, start + 1);
            self.diagnostics.push(
                Diagnostic::error(
                    "mavc::syntax::separator",
                    span,
                    "a new line or `;` must follow a block's `}`",
                )
                .here("the next statement begins on the same line")
                .help("start a new line here")
                .fix(
                    Span {
                        end: span.start,
                        ..span
                    },
                    "\n",
                ),
            );
        }
    }

    /// The `///` lines before a statement, joined.
    fn doc(&mut self, start: u32) -> Option<String> {
        let mut lines = Vec::new();
        while let Some(doc) = self.docs.next_if(|d| d.span.start < start) {
            lines.push(doc.text);
        }
        (!lines.is_empty()).then(|| lines.join("\n"))
    }

    /// `///` lines that no statement follows in their block.
    fn drop_docs(&mut self, end: usize) {
        while let Some(doc) = self.docs.next_if(|d| (d.span.start as usize) < end) {
            self.diagnostics.push(
                Diagnostic::warning(
                    "mavc::syntax::dangling_doc",
                    doc.span,
                    "this `///` comment documents nothing",
                )
                .here("no statement follows it")
                .help("write `//` for a comment that belongs to no statement"),
            );
        }
    }

    fn span(&self, pair: &Pair<Rule>) -> Span {
        span_of(self.file, pair)
    }
}

fn span_of(file: FileId, pair: &Pair<Rule>) -> Span {
    let span = pair.as_span();
    Span::new(file, span.start(), span.end())
}

/// The parts of one statement, taken in the order the grammar gives them.
struct Parts<'i> {
    file: FileId,
    pairs: Pairs<'i, Rule>,
}

impl<'i> Parts<'i> {
    fn next(&mut self) -> Pair<'i, Rule> {
        self.pairs
            .next()
            .expect("the grammar gives every part of a statement")
    }

    /// Takes the next pair if it is of this rule.
    fn take(&mut self, rule: Rule) -> Option<Pair<'i, Rule>> {
        if self.pairs.peek().is_some_and(|p| p.as_rule() == rule) {
            self.pairs.next()
        } else {
            None
        }
    }

    fn skip(&mut self, rule: Rule) {
        self.take(rule);
    }

    fn name(&mut self) -> Name {
        let pair = self.next();
        Spanned::new(pair.as_str().to_string(), span_of(self.file, &pair))
    }

    fn text(&mut self) -> Spanned<String> {
        let pair = self.next();
        Spanned::new(unquote(pair.as_str()), span_of(self.file, &pair))
    }

    fn expr(&mut self) -> Built<Expr> {
        expression::expr(self.file, self.next())
    }

    fn field(&mut self, span: Span, doc: Option<String>) -> Built<Field> {
        let name = self.name();
        self.skip(Rule::equals);
        let value = match self.take(Rule::filter) {
            Some(filter) => Parts {
                file: self.file,
                pairs: filter.into_inner(),
            }
            .filter()?,
            None => FieldValue::Expr(self.expr()?),
        };
        Ok(Field {
            name,
            value,
            doc,
            span,
        })
    }

    fn filter(&mut self) -> Built<FieldValue> {
        self.skip(Rule::kw_where);
        let field = self.name();
        let relation = self.next();
        let meaning = match relation.as_rule() {
            Rule::less => Relation::Less,
            Rule::at_most => Relation::LessEqual,
            Rule::greater => Relation::Greater,
            Rule::at_least => Relation::GreaterEqual,
            _ => Relation::Equal,
        };
        let relation = Spanned::new(meaning, span_of(self.file, &relation));
        Ok(FieldValue::Where {
            field,
            relation,
            value: self.expr()?,
        })
    }

    fn limit(&mut self, span: Span) -> Built<Statement> {
        let name = self.name();
        let relation = match self.next().as_rule() {
            Rule::at_most => LimitRelation::AtMost(self.expr()?),
            Rule::at_least => LimitRelation::AtLeast(self.expr()?),
            _ => LimitRelation::In(self.expr()?),
        };
        Ok(Statement::Limit {
            name,
            relation,
            span,
        })
    }

    fn fault(&mut self, span: Span) -> Built<Statement> {
        self.next();
        Ok(Statement::Fault {
            rotors: self.expr()?,
            effect: self.effect()?,
            span,
        })
    }

    fn effect(&mut self) -> Built<Effect> {
        let pair = self.next();
        let rule = pair.as_rule();
        if rule == Rule::kw_lost {
            return Ok(Effect::Lost(span_of(self.file, &pair)));
        }
        let value = pair
            .into_inner()
            .find(|p| p.as_rule() == Rule::expr)
            .expect("`to` and `at` have values");
        let value = expression::expr(self.file, value)?;
        Ok(if rule == Rule::reduced {
            Effect::Reduced(value)
        } else {
            Effect::Stuck(value)
        })
    }

    fn every(&mut self, span: Span, doc: Option<String>) -> Built<Statement> {
        self.skip(Rule::kw_every);
        let count = self.expr()?;
        self.next();
        let effect = self.effect()?;
        self.skip(Rule::kw_as);
        Ok(Statement::Every {
            count,
            effect,
            prefix: self.name(),
            body: Vec::new(),
            doc,
            span,
        })
    }

    fn curve(&mut self, span: Span, doc: Option<String>) -> Built<Statement> {
        self.skip(Rule::kw_curve);
        let parameter = self.name();
        self.skip(Rule::kw_in);
        let range = self.expr()?;
        let mut options = Vec::new();
        while let Some(pair) = self.pairs.next() {
            if pair.as_rule() == Rule::field {
                let span = span_of(self.file, &pair);
                options.push(
                    Parts {
                        file: self.file,
                        pairs: pair.into_inner(),
                    }
                    .field(span, None)?,
                );
            }
        }
        Ok(Statement::Curve {
            parameter,
            range,
            options,
            body: Vec::new(),
            doc,
            span,
        })
    }

    fn block(&mut self, span: Span, doc: Option<String>) -> Built<Block> {
        let keyword = self.name();
        let name = self
            .take(Rule::name)
            .map(|p| Spanned::new(p.as_str().to_string(), span_of(self.file, &p)));
        let title = self
            .take(Rule::text)
            .map(|p| Spanned::new(unquote(p.as_str()), span_of(self.file, &p)));
        Ok(Block {
            keyword,
            name,
            title,
            body: Vec::new(),
            doc,
            span,
        })
    }

    fn clauses(&mut self, span: Span, doc: Option<String>) -> Built<Clauses> {
        self.next();
        let name = self
            .take(Rule::name)
            .map(|p| Spanned::new(p.as_str().to_string(), span_of(self.file, &p)));
        let mut clauses = Vec::new();
        while let Some(pair) = self.pairs.next() {
            let mut parts = Parts {
                file: self.file,
                pairs: pair.into_inner(),
            };
            clauses.push(Clause {
                word: parts.name(),
                value: parts.expr()?,
            });
        }
        Ok(Clauses {
            name,
            clauses,
            doc,
            span,
        })
    }

    fn moving(&mut self, span: Span) -> Statement {
        let word = self.next();
        let end = Spanned::new(word.as_rule() == Rule::kw_end, span_of(self.file, &word));
        Statement::Moving { end, span }
    }
}

fn unquote(text: &str) -> String {
    text.trim_matches('"').to_string()
}
