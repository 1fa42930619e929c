//! Semantic tokens: what every word is, by the tree where there is one, by its form elsewhere.

use super::mentions::What;
use super::names::NameKind;
use super::workspace::Spec;
use crate::source::FileId;
use crate::syntax::Place;
use crate::syntax::scan::{LexemeKind, lexemes};
use gen_lsp_types::{SemanticToken, SemanticTokenModifiers, SemanticTokenTypes, SemanticTokensLegend};
use std::collections::HashMap;

/// The kinds of tokens, in the order of the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token {
    Comment,
    Keyword,
    Property,
    Number,
    Unit,
    Text,
    Function,
    Variable,
    Parameter,
    Word,
    Vehicle,
    Mission,
    Mode,
    Waypoint,
    Operator,
}

const LEGEND: [(Token, SemanticTokenTypes); 15] = [
    (Token::Comment, SemanticTokenTypes::Comment),
    (Token::Keyword, SemanticTokenTypes::Keyword),
    (Token::Property, SemanticTokenTypes::Property),
    (Token::Number, SemanticTokenTypes::Number),
    (Token::Unit, SemanticTokenTypes::Type),
    (Token::Text, SemanticTokenTypes::String),
    (Token::Function, SemanticTokenTypes::Function),
    (Token::Variable, SemanticTokenTypes::Variable),
    (Token::Parameter, SemanticTokenTypes::Parameter),
    (Token::Word, SemanticTokenTypes::EnumMember),
    (Token::Vehicle, SemanticTokenTypes::Class),
    (Token::Mission, SemanticTokenTypes::Namespace),
    (Token::Mode, SemanticTokenTypes::Event),
    (Token::Waypoint, SemanticTokenTypes::Label),
    (Token::Operator, SemanticTokenTypes::Operator),
];

const DECLARATION: u32 = 1;
const DOCUMENTATION: u32 = 2;
const CONSTANT: u32 = 4;

/// Words between the parts of a statement, none of which begins a statement.
const JOINING: [&str; 15] = [
    "at",
    "as",
    "in",
    "to",
    "from",
    "where",
    "until",
    "moving",
    "lost",
    "reduced",
    "stuck",
    "rotor",
    "rotors",
    "risk",
    "uncovered",
];

/// What the numbers in a token mean.
pub fn legend() -> SemanticTokensLegend {
    let modifiers =
        [SemanticTokenModifiers::Declaration, SemanticTokenModifiers::Documentation, SemanticTokenModifiers::Readonly];
    SemanticTokensLegend {
        token_types: LEGEND.into_iter().map(|(_, name)| name.into()).collect(),
        token_modifiers: modifiers.into_iter().map(String::from).collect(),
    }
}

/// Every token of a file, each counted from the one before.
pub fn tokens(spec: &Spec, file: FileId) -> Vec<SemanticToken> {
    let source = spec.source(file);
    let text = source.text.as_str();
    // Without those that only a fix would insert.
    let written = spec.mentions().in_file(file).iter().filter(|m| m.span.start < m.span.end);
    let meant: HashMap<usize, (usize, What)> =
        written.map(|m| (m.span.start as usize, (m.span.end as usize, m.what))).collect();
    let mut encoder = Encoder { text, line: 0, line_start: 0, seen: 0, last: (0, 0), found: Vec::new() };
    let mut until = 0;
    for lexeme in lexemes(text) {
        if lexeme.start < until {
            continue;
        }
        let (mut end, mut modifiers) = (lexeme.end, 0);
        let token = match (meant.get(&lexeme.start), lexeme.kind) {
            (_, LexemeKind::Comment) => Token::Comment,
            (_, LexemeKind::Doc) => {
                modifiers = DOCUMENTATION;
                Token::Comment
            }
            (Some((meant_end, what)), _) => {
                end = *meant_end;
                let (token, of_what) = of(spec, *what);
                modifiers = of_what;
                token
            }
            (None, LexemeKind::Text | LexemeKind::UnclosedText) => Token::Text,
            (None, LexemeKind::Number) => Token::Number,
            (None, LexemeKind::Word) => {
                let word = lexeme.text(text);
                if !Place::opens_statement(word) && !JOINING.contains(&word) {
                    continue;
                }
                Token::Keyword
            }
            (None, LexemeKind::Mark('=' | '<' | '>' | '+' | '-' | '*' | '/' | '^')) => Token::Operator,
            (None, LexemeKind::Pair) if lexeme.text(text) != ".." => Token::Operator,
            (None, LexemeKind::Mark(_) | LexemeKind::Pair | LexemeKind::Newline) => continue,
        };
        until = end;
        encoder.push(lexeme.start, end, token, modifiers);
    }
    encoder.found
}

fn of(spec: &Spec, what: What) -> (Token, u32) {
    let of_name = |index: usize| match spec.names().definitions[index].kind {
        NameKind::Let => Token::Variable,
        NameKind::Vehicle => Token::Vehicle,
        NameKind::Mission => Token::Mission,
        NameKind::Mode | NameKind::Modes => Token::Mode,
        NameKind::Waypoint | NameKind::LandingSite => Token::Waypoint,
        NameKind::Parameter => Token::Parameter,
    };
    match what {
        What::Field(_) => (Token::Property, 0),
        What::Keyword => (Token::Keyword, 0),
        What::Number => (Token::Number, 0),
        What::Unit => (Token::Unit, 0),
        What::Text => (Token::Text, 0),
        What::Function => (Token::Function, 0),
        What::Constant => (Token::Variable, CONSTANT),
        What::Word => (Token::Word, 0),
        What::Definition(index) => (of_name(index), DECLARATION),
        What::Reference(index) => (of_name(index), 0),
    }
}

/// Counts lines and UTF-16 columns along, so that a long line costs no more than its length.
struct Encoder<'t> {
    text: &'t str,
    line: u32,
    /// UTF-16 units of the text before `seen`, on its line.
    line_start: u32,
    seen: usize,
    last: (u32, u32),
    found: Vec<SemanticToken>,
}

impl Encoder<'_> {
    fn push(&mut self, start: usize, end: usize, token: Token, modifiers: u32) {
        for character in self.text[self.seen..start].chars() {
            match character {
                '\n' => (self.line, self.line_start) = (self.line + 1, 0),
                other => self.line_start += other.len_utf16() as u32,
            }
        }
        self.seen = start;
        let (line, column) = (self.line, self.line_start);
        let length = self.text[start..end].encode_utf16().count() as u32;
        let kind = LEGEND.iter().position(|row| row.0 == token).unwrap_or(0) as u32;
        let delta_line = line - self.last.0;
        let delta_start = if delta_line == 0 { column - self.last.1 } else { column };
        self.found.push(SemanticToken {
            delta_line,
            delta_start,
            length,
            token_type: kind,
            token_modifiers_bitset: modifiers,
        });
        self.last = (line, column);
    }
}
