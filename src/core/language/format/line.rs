//! Tokens to lines. Lines break where the author broke them; a block that is not on one line has a line for its head,
//! and one for its closing brace.

use super::role::{Alignment, Role, Roles};
use super::token::{Sort, Token};
use std::fmt;
use std::ops::Range;

/// Blanks of one step of indentation.
const STEP: usize = 4;

/// One line of the result.
#[derive(Debug, Default)]
pub struct Line<'a> {
    /// Blanks before the text.
    pub indent: usize,
    /// Without the comment; empty where a comment has the line to itself.
    pub text: String,
    pub comment: Option<Comment<'a>>,
    pub blank_before: bool,
    /// Lines of one number follow each other and may be lined up.
    pub run: usize,
    pub kind: Option<Alignment>,
    /// Where lines of one kind are lined up.
    pub stops: Vec<Stop>,
}

#[derive(Debug, Clone, Copy)]
pub struct Comment<'a> {
    pub text: &'a str,
    /// Blanks between the text and the comment.
    pub gap: usize,
}

/// A piece of [`Line::text`], in bytes, whose end is moved to the column of its neighbours' by blanks before it.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    pub start: usize,
    pub end: usize,
}

impl fmt::Display for Line<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.blank_before {
            f.write_str("\n")?;
        }
        write!(f, "{:1$}{2}", "", self.indent, self.text)?;
        if let Some(comment) = self.comment {
            write!(f, "{:1$}{2}", "", comment.gap, comment.text)?;
        }
        f.write_str("\n")
    }
}

pub fn lines<'a>(tokens: &[Token<'a>], roles: &Roles) -> Vec<Line<'a>> {
    let mut writer = Writer { tokens, roles, at: 0, depth: 0, lines: Vec::new(), run: 0 };
    writer.statements();
    writer.lines
}

struct Writer<'t, 'a> {
    tokens: &'t [Token<'a>],
    roles: &'t Roles,
    /// Index of the next token.
    at: usize,
    /// Open blocks.
    depth: usize,
    lines: Vec<Line<'a>>,
    run: usize,
}

impl<'a> Writer<'_, 'a> {
    /// Everything up to the brace that ends the block.
    fn statements(&mut self) {
        let mut first = true;
        while let Some(&token) = self.tokens.get(self.at) {
            match token {
                Token { text: "}", .. } => return,
                Token { text: ";", .. } => self.at += 1,
                _ if token.is_comment() => {
                    first &= self.comment(token, first, self.depth * STEP);
                    self.at += 1;
                }
                _ => {
                    self.statement(first);
                    first = false;
                }
            }
        }
    }

    /// Puts a comment after the text of its line, and returns true, or on a line of its own.
    fn comment(&mut self, token: Token<'a>, first: bool, indent: usize) -> bool {
        let comment = Some(Comment { text: token.text, gap: 0 });
        let beside = !token.begins_line() && token.sort != Sort::Doc;
        if let Some(line) = self.lines.last_mut().filter(|line| beside && line.comment.is_none()) {
            line.comment = comment;
            return true;
        }
        let blank_before = token.breaks > 1 && !first;
        self.lines.push(Line { indent, comment, blank_before, ..Line::default() });
        self.run += 1;
        false
    }

    /// A statement, with its block and with those that follow it on its line after `;`.
    fn statement(&mut self, first: bool) {
        let start = self.at;
        let (mut from, mut count) = (start, 0);
        while let Some(end) = self.on_one_line(from) {
            self.at = end;
            count += 1;
            if self.text(end) != ";" {
                break;
            }
            from = end + 1;
        }
        if count > 0 {
            return self.text_lines(start..self.at, count, first);
        }
        self.at = self.end_of_statement(start);
        if self.text(self.at) == "{" {
            self.block(start, first);
        } else {
            self.text_lines(start..self.at, 1, first);
        }
    }

    /// Head, body and brace on lines of their own; the next token is the opening brace.
    fn block(&mut self, head: usize, first: bool) {
        self.run += 1;
        self.at += 1;
        self.text_lines(head..self.at, 0, first);
        self.run += 1;
        self.depth += 1;
        self.statements();
        self.depth -= 1;
        self.run += 1;
        if self.text(self.at) == "}" {
            self.at += 1;
            self.text_lines(self.at - 1..self.at, 0, true);
        }
        self.run += 1;
    }

    /// A word or mark; nothing for a comment and past the end.
    fn text(&self, at: usize) -> &'a str {
        self.tokens.get(at).filter(|t| !t.is_comment()).map_or("", |t| t.text)
    }

    /// The token after the statement that begins at `from`, if it is on one line with its block.
    fn on_one_line(&self, from: usize) -> Option<usize> {
        let end = self.end_of_statement(from);
        if self.tokens[from..end].iter().skip(1).any(|t| t.begins_line() || t.is_comment()) {
            return None;
        }
        if self.text(end) == "{" { self.end_of_line_block(end) } else { Some(end) }
    }

    /// The token after the statement that begins at `from`, its block left out.
    fn end_of_statement(&self, from: usize) -> usize {
        let mut brackets = 0_usize;
        for (i, token) in self.tokens.iter().enumerate().skip(from) {
            let is_end = matches!(self.text(i), "{" | "}" | ";") || token.begins_line() || token.is_comment();
            if brackets == 0 && i > from && is_end {
                return i;
            }
            match self.text(i) {
                "(" | "[" => brackets += 1,
                ")" | "]" => brackets = brackets.saturating_sub(1),
                _ => {}
            }
        }
        self.tokens.len()
    }

    /// The token after the `}` of a block that is on one line, or empty.
    fn end_of_line_block(&self, brace: usize) -> Option<usize> {
        if self.text(brace + 1) == "}" {
            return Some(brace + 2);
        }
        let mut open = 0_usize;
        for (i, token) in self.tokens.iter().enumerate().skip(brace) {
            if i > brace && (token.begins_line() || token.is_comment()) {
                return None;
            }
            match token.text {
                "{" => open += 1,
                "}" if open == 1 => return Some(i + 1),
                "}" => open -= 1,
                _ => {}
            }
        }
        None
    }

    /// The line of these tokens, which make `count` whole statements; several lines where they break inside brackets.
    fn text_lines(&mut self, range: Range<usize>, count: usize, first: bool) {
        let (from, head) = (range.start, self.lines.len());
        let kind = self.roles.kinds.get(&self.tokens[from].start).copied().filter(|_| count == 1);
        // Tokens of the first line, and where they begin in it.
        let mut placed: Vec<(Token, usize)> = Vec::new();
        // The line of each open bracket, counted from the first of this statement.
        let mut brackets: Vec<usize> = Vec::new();
        let mut row = 0;
        for i in range {
            let token = self.tokens[i];
            let (closes, opens) = (matches!(self.text(i), ")" | "]"), matches!(self.text(i), "(" | "["));
            if closes {
                brackets.pop();
            }
            let after_opener = i == from && first || i > from && self.follows_opener(i);
            let mut rows = brackets.clone();
            rows.dedup();
            let indent = (self.depth + rows.len()) * STEP;
            if token.is_comment() {
                self.comment(token, after_opener, indent);
                continue;
            }
            if i == from || token.begins_line() {
                let blank_before = token.breaks > 1 && !closes && !after_opener;
                // Lines inside brackets are not aligned with those around them.
                self.run += usize::from(blank_before || row == 1);
                row += 1;
                if token.text == "]" && !matches!(self.before(i), "," | "[") {
                    self.end_with_comma();
                }
                self.lines.push(Line { indent, blank_before, run: self.run, ..Line::default() });
            } else if token.text == "," && self.text(i + 1) == "]" && !self.tokens[i + 1].begins_line() {
                continue;
            }
            if opens {
                brackets.push(row);
            }
            let gap = if i == from || token.begins_line() { "" } else { self.gap(i) };
            let Some(line) = self.lines.last_mut() else { continue };
            line.text.push_str(gap);
            if row == 1 {
                placed.push((token, line.text.len()));
            }
            line.text.push_str(token.text);
        }
        self.run += usize::from(row > 1);
        if let (Some(kind), Some(line)) = (kind, self.lines.get_mut(head)) {
            line.stops = stops(kind, &placed, self.roles);
            line.kind = Some(kind);
        }
    }

    /// The word or mark before token `i`, comments passed over.
    fn before(&self, i: usize) -> &'a str {
        let earlier = self.tokens[..i].iter().rev().find(|t| !t.is_comment());
        earlier.map_or("", |t| t.text)
    }

    /// Whether token `i` begins what a bracket holds, the comment beside the bracket passed over.
    fn follows_opener(&self, i: usize) -> bool {
        let beside = self.tokens[..i].iter().rev().find(|t| !t.is_comment() || t.begins_line());
        beside.is_some_and(|t| matches!(t.text, "(" | "["))
    }

    /// A list whose bracket has a line to itself ends with a comma.
    fn end_with_comma(&mut self) {
        if let Some(line) = self.lines.iter_mut().rev().find(|line| !line.text.is_empty()) {
            line.text.push(',');
        }
    }

    /// The blanks between a token and the one before it on its line.
    fn gap(&self, i: usize) -> &'static str {
        let (before, token) = (&self.tokens[i - 1], &self.tokens[i]);
        let role = |token: &Token| self.roles.words.get(&token.start).copied();
        match (before.text, token.text) {
            (_, "," | ";" | ")" | "]") | ("(" | "[", _) => "",
            (_, "(") if role(before) == Some(Role::Function) => "",
            _ if role(before) == Some(Role::Sign) => "",
            _ if role(before) == Some(Role::Tight) || role(token) == Some(Role::Tight) => "",
            _ if role(token) == Some(Role::Clause) => "  ",
            _ => " ",
        }
    }
}

/// Where a statement of this kind is aligned; `placed` are its tokens and their offsets.
fn stops(kind: Alignment, placed: &[(Token, usize)], roles: &Roles) -> Vec<Stop> {
    let at = |found: Option<&(Token, usize)>| found.map(|&(_, at)| Stop { start: at, end: at });
    match kind {
        Alignment::Field | Alignment::Let => {
            at(placed.iter().find(|(token, _)| token.text == "=")).into_iter().collect()
        }
        Alignment::Limit => at(placed.get(1)).into_iter().collect(),
        Alignment::Rotor(_) => {
            let coordinate = |&(token, start): &(Token, usize)| {
                let end = roles.coordinates.get(&token.start)?;
                let (last, at) = placed.iter().take_while(|(token, _)| token.start < *end).last()?;
                Some(Stop { start, end: at + last.text.len() })
            };
            placed.iter().filter_map(coordinate).collect()
        }
    }
}
