//! The parts of one statement to its node.

use super::{Built, Rule, expression, span_of, unquote};
use crate::source::{FileId, Span, Spanned};
use crate::syntax::ast::*;
use pest::iterators::{Pair, Pairs};

/// The parts of one statement, taken in the order the grammar gives them.
pub(super) struct Parts<'i> {
    pub file: FileId,
    pub pairs: Pairs<'i, Rule>,
}

impl<'i> Parts<'i> {
    pub fn next(&mut self) -> Pair<'i, Rule> {
        self.pairs.next().expect("the grammar gives every part of a statement")
    }

    /// Takes the next pair if it is of this rule.
    pub fn take(&mut self, rule: Rule) -> Option<Pair<'i, Rule>> {
        if self.pairs.peek().is_some_and(|p| p.as_rule() == rule) { self.pairs.next() } else { None }
    }

    pub fn skip(&mut self, rule: Rule) {
        self.take(rule);
    }

    pub fn name(&mut self) -> Name {
        let pair = self.next();
        Spanned::new(pair.as_str().to_string(), span_of(self.file, &pair))
    }

    pub fn text(&mut self) -> Spanned<String> {
        let pair = self.next();
        Spanned::new(unquote(pair.as_str()), span_of(self.file, &pair))
    }

    pub fn expr(&mut self) -> Built<Expr> {
        expression::expr(self.file, self.next())
    }

    pub fn field(&mut self, span: Span, doc: Option<String>) -> Built<Field> {
        let name = self.name();
        self.skip(Rule::equals);
        let value = match self.take(Rule::filter) {
            Some(filter) => Parts { file: self.file, pairs: filter.into_inner() }.filter()?,
            None => FieldValue::Expr(self.expr()?),
        };
        Ok(Field { name, value, doc, span })
    }

    pub fn filter(&mut self) -> Built<FieldValue> {
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
        Ok(FieldValue::Where { field, relation, value: self.expr()? })
    }

    pub fn limit(&mut self, span: Span) -> Built<Statement> {
        let name = self.name();
        let relation = match self.next().as_rule() {
            Rule::at_most => LimitRelation::AtMost(self.expr()?),
            Rule::at_least => LimitRelation::AtLeast(self.expr()?),
            _ => LimitRelation::In(self.expr()?),
        };
        Ok(Statement::Limit { name, relation, span })
    }

    pub fn requirement(&mut self, span: Span) -> Built<Statement> {
        self.skip(Rule::kw_require);
        let name = self.name();
        self.skip(Rule::at_most);
        Ok(Statement::Require { name, at_most: self.expr()?, span })
    }

    pub fn fault(&mut self, span: Span) -> Built<Statement> {
        self.next();
        Ok(Statement::Fault { rotors: self.expr()?, effect: self.effect()?, span })
    }

    pub fn effect(&mut self) -> Built<Effect> {
        let pair = self.next();
        let rule = pair.as_rule();
        if rule == Rule::kw_lost {
            return Ok(Effect::Lost(span_of(self.file, &pair)));
        }
        let value = pair.into_inner().find(|p| p.as_rule() == Rule::expr).expect("`to` and `at` have values");
        let value = expression::expr(self.file, value)?;
        Ok(if rule == Rule::reduced { Effect::Reduced(value) } else { Effect::Stuck(value) })
    }

    pub fn every(&mut self, span: Span, doc: Option<String>) -> Built<Statement> {
        self.skip(Rule::kw_every);
        let count = self.expr()?;
        self.next();
        let effect = self.effect()?;
        self.skip(Rule::kw_as);
        Ok(Statement::Every { count, effect, prefix: self.name(), body: Vec::new(), doc, span })
    }

    pub fn curve(&mut self, span: Span, doc: Option<String>) -> Built<Statement> {
        self.skip(Rule::kw_curve);
        let parameter = self.name();
        self.skip(Rule::kw_in);
        let range = self.expr()?;
        let mut options = Vec::new();
        for pair in self.pairs.by_ref() {
            if pair.as_rule() == Rule::field {
                let span = span_of(self.file, &pair);
                options.push(Parts { file: self.file, pairs: pair.into_inner() }.field(span, None)?);
            }
        }
        Ok(Statement::Curve { parameter, range, options, body: Vec::new(), doc, span })
    }

    pub fn block(&mut self, span: Span, doc: Option<String>) -> Built<Block> {
        let keyword = self.name();
        let name = self.take(Rule::name).map(|p| Spanned::new(p.as_str().to_string(), span_of(self.file, &p)));
        let title = self.take(Rule::text).map(|p| Spanned::new(unquote(p.as_str()), span_of(self.file, &p)));
        Ok(Block { keyword, name, title, body: Vec::new(), doc, span })
    }

    pub fn clauses(&mut self, span: Span, doc: Option<String>) -> Built<Clauses> {
        self.next();
        let name = self.take(Rule::name).map(|p| Spanned::new(p.as_str().to_string(), span_of(self.file, &p)));
        let mut clauses = Vec::new();
        for pair in self.pairs.by_ref() {
            let mut parts = Parts { file: self.file, pairs: pair.into_inner() };
            let word = parts.name();
            const HOWS: [Rule; 4] = [Rule::from_word, Rule::towards_word, Rule::along_word, Rule::free_word];
            let name = |p: Pair<'_, Rule>| Spanned::new(p.as_str().to_string(), span_of(self.file, &p));
            let how = HOWS.into_iter().find_map(|rule| parts.take(rule)).map(name);
            // `along path` is one word with a blank.
            let path = parts.take(Rule::path_word).map(name);
            let how = match (how, path) {
                (Some(how), Some(path)) => {
                    Some(Spanned::new(format!("{} {}", how.value, path.value), how.span.to(path.span)))
                }
                (how, _) => how,
            };
            let value = if parts.pairs.peek().is_some() { Some(parts.expr()?) } else { None };
            clauses.push(Clause { word, how, value });
        }
        Ok(Clauses { name, clauses, body: Vec::new(), doc, span })
    }

    pub fn moving(&mut self, span: Span) -> Statement {
        let word = self.next();
        let end = Spanned::new(word.as_rule() == Rule::kw_end, span_of(self.file, &word));
        Statement::Moving { end, span }
    }
}
