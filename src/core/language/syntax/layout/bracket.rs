//! `( )` and `[ ]`: a statement must close what it opens.

use super::{Scanner, is_name};
use crate::diagnostic::Diagnostic;
use crate::language::{Place, is_clause};

impl Scanner<'_> {
    /// A bracket of the wrong kind is read as the right one; a bracket that closes nothing is skipped.
    pub(super) fn close_bracket(&mut self, at: usize) {
        let closer = self.text.as_bytes()[at];
        let span = self.span(at, at + 1);
        let found = closer as char;
        let Some(opener) = self.brackets.pop() else {
            let diagnostic =
                Diagnostic::error("mavc::syntax::stray_bracket", span, format!("`{found}` closes nothing"));
            self.report(diagnostic.here("nothing is open here").help("remove it").fix(span, ""));
            self.out[at] = b' ';
            return;
        };
        let wanted = self.closer_of(opener);
        if wanted == closer {
            return;
        }
        let encloses = self.brackets.last().is_some_and(|&outer| self.closer_of(outer) == closer);
        if encloses {
            self.report_unclosed(&[opener], at);
            self.brackets.pop();
            return;
        }
        let opened = self.text.as_bytes()[opener] as char;
        self.report(
            Diagnostic::error("mavc::syntax::stray_bracket", span, format!("`{opened}` is closed by `{found}`"))
                .here(format!("expected `{}`", wanted as char))
                .also(self.span(opener, opener + 1), "opened here")
                .help(format!("write `{}`", wanted as char))
                .fix(span, (wanted as char).to_string()),
        );
        self.out[at] = wanted;
    }

    /// The statement is over at `at`: whatever it left open is reported, once.
    pub(super) fn close_brackets(&mut self, at: usize) {
        let open = std::mem::take(&mut self.brackets);
        self.report_unclosed(&open, at);
    }

    fn report_unclosed(&mut self, open: &[usize], end: usize) {
        let Some((&last, others)) = open.split_last() else {
            return;
        };
        let opened = self.text.as_bytes()[last] as char;
        let closers: String = open.iter().rev().map(|&o| self.closer_of(o) as char).collect();
        let kept = self.out[..end].iter().rposition(|b| !b.is_ascii_whitespace()).map_or(end, |i| i + 1);
        let kept = if others.is_empty() { self.closing_place(last, kept) } else { kept };
        let mut diagnostic = Diagnostic::error(
            "mavc::syntax::unclosed_bracket",
            self.span(last, last + 1),
            format!("`{opened}` is never closed"),
        )
        .here("opened here")
        .help(format!("write `{closers}` where it should end"))
        .fix(self.span(kept, kept), closers);
        for &other in others.iter().rev().take(3) {
            diagnostic = diagnostic.also(self.span(other, other + 1), "neither is this one");
        }
        self.report(diagnostic);
    }

    /// Where the bracket at `opener` should close, if the statement ends at `end`: before the words that go on with the
    /// statement, and before a unit that is meant for the whole list.
    fn closing_place(&self, opener: usize, end: usize) -> usize {
        let Ok(inside) = std::str::from_utf8(&self.out[opener + 1..end]) else { return end };
        let goes_on = |word: &str| is_clause(word) || ["lost", "reduced", "stuck"].contains(&word);
        let words = inside.split([' ', '\t']).map(|word| (word.as_ptr() as usize - inside.as_ptr() as usize, word));
        let over = words.filter(|(at, word)| *at > 0 && goes_on(word)).map(|(at, _)| at).next();
        let inside = inside[..over.unwrap_or(inside.len())].trim_end();
        let last = inside.rfind([',', '+', '(', '[']).map_or(0, |comma| comma + 1);
        let unit = inside.rfind([' ', '\t']).map_or(0, |blank| blank + 1);
        let element = inside[..unit].trim_end();
        let is_unit = inside[unit..].starts_with(|c: char| c.is_ascii_alphabetic() || c == '%');
        let operand = element.get(last..).unwrap_or("").trim();
        let is_number = operand.ends_with(|c: char| c.is_ascii_digit()) && operand.parse::<f64>().is_ok();
        // A name takes no unit; a number's is its own, unless the others have none.
        let others = || inside[..last].trim_end_matches(',').split(',').map(str::trim);
        let for_all = || !others().any(|e| e.contains(' ')) && others().any(|e| e.parse::<f64>().is_ok());
        let is_name = operand.ends_with(is_name) && !is_number;
        let length = if is_unit && (is_name || is_number && for_all()) { element.len() } else { inside.len() };
        opener + 1 + length
    }

    fn closer_of(&self, opener: usize) -> u8 {
        if self.text.as_bytes()[opener] == b'(' { b')' } else { b']' }
    }

    /// Whether the line at `at` cannot go on inside a bracket: `name =`, `name <=`, `name value` and `}` never
    /// are part of an expression.
    pub(super) fn statement_begins(&self, at: usize) -> bool {
        let (name, next) = self.name_at(at);
        let rest = &self.text.as_bytes()[next..];
        match rest.first() {
            _ if name.is_empty() => rest.first() == Some(&b'}'),
            Some(b'=' | b'<' | b'>' | b'"' | b'[' | b'{') => true,
            Some(b) if is_name(*b as char) => true,
            // A keyword alone after the end of an element, without a comma that announces another element.
            None | Some(b'\r' | b'\n') => Place::opens_statement(name) && self.element_is_over(at),
            Some(_) => false,
        }
    }

    /// Whether an element can end before `at`.
    fn element_is_over(&self, at: usize) -> bool {
        let last = self.out[..at].iter().rfind(|b| !b.is_ascii_whitespace());
        last.is_some_and(|b| is_name(*b as char) || matches!(b, b')' | b']' | b'%'))
    }
}
