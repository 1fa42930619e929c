//! A reader of JSON (RFC 8259) that keeps the place of every value, so that a mistake in a file has one.
//!
//! Time and memory are bounded by the length of the text, [`DEPTH`] and [`MOST_VALUES`].

use super::{SYNTAX, at};
use crate::diagnostic::Diagnostic;
use std::ops::Range;

/// Lists and objects within each other.
pub const DEPTH: usize = 64;
/// Values of one text; each takes about 60 bytes.
pub const MOST_VALUES: usize = 1_000_000;

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Json {
    pub kind: Kind,
    pub span: Range<usize>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Json>),
    /// Members in the order of the text; no key occurs twice.
    Object(Vec<Member>),
}

/// `"key": value`
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    pub key: String,
    pub value: Json,
}

impl Json {
    /// The member of an object.
    pub fn get(&self, key: &str) -> Option<&Json> {
        match &self.kind {
            Kind::Object(members) => members.iter().find(|member| member.key == key).map(|member| &member.value),
            _ => None,
        }
    }

    pub fn number(&self) -> Option<f64> {
        if let Kind::Number(x) = self.kind { Some(x) } else { None }
    }

    pub fn list(&self) -> Option<&[Json]> {
        if let Kind::List(all) = &self.kind { Some(all) } else { None }
    }

    pub fn text(&self) -> Option<&str> {
        if let Kind::Text(text) = &self.kind { Some(text) } else { None }
    }

    /// As messages name it.
    pub fn what(&self) -> &'static str {
        match self.kind {
            Kind::Null => "null",
            Kind::Bool(_) => "true or false",
            Kind::Number(_) => "a number",
            Kind::Text(_) => "a text",
            Kind::List(_) => "a list",
            Kind::Object(_) => "an object",
        }
    }
}

/// Reads a text.
///
/// # Errors
/// The first place that JSON does not allow, a key that an object has twice, a number that no double holds, or a text
/// that is too deep or too long.
pub fn parse(text: &str) -> Result<Json, Box<Diagnostic>> {
    let mut reader = Reader { text, bytes: text.as_bytes(), at: 0, values: 0 };
    let value = reader.value(0)?;
    reader.blanks();
    if reader.at < text.len() {
        return reader.fail("text after the end of the JSON value", "not part of it");
    }
    Ok(value)
}

struct Reader<'t> {
    text: &'t str,
    bytes: &'t [u8],
    at: usize,
    values: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    /// The error at the next character.
    fn fail<T>(&self, message: &str, here: &str) -> Result<T, Box<Diagnostic>> {
        let length = self.text.get(self.at..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
        let error = Diagnostic::error(SYNTAX, at(self.at..self.at + length), message);
        let here = if length == 0 { "the text ends here" } else { here };
        Err(Box::new(error.here(here).help("write the file again with the program that made it")))
    }

    fn value(&mut self, depth: usize) -> Result<Json, Box<Diagnostic>> {
        self.blanks();
        self.values += 1;
        if self.values > MOST_VALUES {
            return self.fail(&format!("the file has more than {MOST_VALUES} values"), "the first that is too many");
        }
        if depth > DEPTH {
            return self.fail(&format!("lists and objects are more than {DEPTH} deep"), "the first that is too deep");
        }
        let start = self.at;
        let kind = match self.peek() {
            Some(b'{') => self.object(depth)?,
            Some(b'[') => self.list(depth)?,
            Some(b'"') => Kind::Text(self.string()?),
            Some(b'-' | b'0'..=b'9') => self.number()?,
            _ => self.word()?,
        };
        Ok(Json { kind, span: start..self.at })
    }

    fn word(&mut self) -> Result<Kind, Box<Diagnostic>> {
        let words = [("null", Kind::Null), ("true", Kind::Bool(true)), ("false", Kind::Bool(false))];
        for (word, kind) in words {
            if self.bytes[self.at..].starts_with(word.as_bytes()) {
                self.at += word.len();
                return Ok(kind);
            }
        }
        self.fail("expected a JSON value", "no JSON value")
    }

    fn list(&mut self, depth: usize) -> Result<Kind, Box<Diagnostic>> {
        self.at += 1;
        let mut all = Vec::new();
        loop {
            self.blanks();
            if all.is_empty() && self.peek() == Some(b']') {
                break;
            }
            all.push(self.value(depth + 1)?);
            self.blanks();
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b']') => break,
                _ => return self.fail("expected `,` or `]` in a list", "neither"),
            }
        }
        self.at += 1;
        Ok(Kind::List(all))
    }

    fn object(&mut self, depth: usize) -> Result<Kind, Box<Diagnostic>> {
        self.at += 1;
        let mut members: Vec<Member> = Vec::new();
        // A key that occurs twice means one thing to one reader and another to the next.
        let mut keys = std::collections::HashSet::new();
        loop {
            self.blanks();
            match self.peek() {
                Some(b'}') if members.is_empty() => break,
                Some(b'"') => {}
                _ => return self.fail("expected a key in quotes", "no key"),
            }
            let start = self.at;
            let key = self.string()?;
            if !keys.insert(key.clone()) {
                let error = Diagnostic::error(SYNTAX, at(start..self.at), "an object has the same key twice");
                return Err(Box::new(error.here("the second time").help("remove one of the two")));
            }
            self.blanks();
            if self.peek() != Some(b':') {
                return self.fail("expected `:` after a key", "no `:`");
            }
            self.at += 1;
            let value = self.value(depth + 1)?;
            members.push(Member { key, value });
            self.blanks();
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b'}') => break,
                _ => return self.fail("expected `,` or `}` in an object", "neither"),
            }
        }
        self.at += 1;
        Ok(Kind::Object(members))
    }

    /// A number, by the rules of [`serde_json`].
    fn number(&mut self) -> Result<Kind, Box<Diagnostic>> {
        let start = self.at;
        let length = self.bytes[start..]
            .iter()
            .take_while(|b| matches!(b, b'+' | b'-' | b'.' | b'e' | b'E' | b'0'..=b'9'))
            .count();
        match serde_json::from_str::<f64>(&self.text[start..start + length]) {
            Ok(x) if x.is_finite() => {
                self.at += length;
                Ok(Kind::Number(x))
            }
            _ => {
                let error = Diagnostic::error(SYNTAX, at(start..start + length), "not a number that JSON allows");
                Err(Box::new(error.here("no number").help("write digits, as in `-12.5`")))
            }
        }
    }

    /// A text in quotes, by the rules of [`serde_json`].
    fn string(&mut self) -> Result<String, Box<Diagnostic>> {
        let start = self.at;
        self.at += 1;
        loop {
            match self.peek() {
                Some(b'\\') => self.at = (self.at + 2).min(self.bytes.len()),
                Some(b'"') => break,
                Some(_) => self.at += 1,
                None => return self.fail("a text has no closing quote", ""),
            }
        }
        self.at += 1;
        // The byte after a backslash may begin a longer character, whose others are no quotes.
        let quoted = self.text.get(start..self.at).unwrap_or_default();
        serde_json::from_str(quoted).map_err(|_| {
            let error = Diagnostic::error(SYNTAX, at(start..self.at), "not a text that JSON allows");
            Box::new(error.here("has an unknown escape or a control character").help("write it without escapes"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value without its places, by the reader that everybody uses.
    fn plain(json: &Json) -> serde_json::Value {
        match &json.kind {
            Kind::Null => serde_json::Value::Null,
            Kind::Bool(b) => (*b).into(),
            Kind::Number(x) => (*x).into(),
            Kind::Text(t) => t.clone().into(),
            Kind::List(all) => all.iter().map(plain).collect(),
            Kind::Object(members) => {
                serde_json::Value::Object(members.iter().map(|m| (m.key.clone(), plain(&m.value))).collect())
            }
        }
    }

    #[test]
    fn values_are_those_of_serde_json_and_know_their_places() {
        let text = r#" {"a": [1, -2.5e3, null, true, {"b\u00e9\"": "x\\"}], "c": {}, "d": [] } "#;
        let json = parse(text).unwrap();
        let floats: serde_json::Value = serde_json::from_str(&text.replace("[1,", "[1.0,")).unwrap();
        assert_eq!(plain(&json), floats);
        let second = &json.get("a").unwrap().list().unwrap()[1];
        assert_eq!(&text[second.span.clone()], "-2.5e3");
    }

    #[test]
    fn what_serde_json_refuses_is_refused() {
        let wrong = [
            "",
            "{",
            "[1,]",
            "{\"a\":1,}",
            "[1 2]",
            "{\"a\" 1}",
            "nul",
            "01",
            "1.",
            "+1",
            "NaN",
            "1e999",
            "\"\\q\"",
            "\"a\nb\"",
            "\"a",
            "[1] x",
            "{a:1}",
            "\"\\",
            "[\"\\é\"]",
        ];
        for text in wrong {
            assert!(serde_json::from_str::<serde_json::Value>(text).is_err(), "{text}");
            let error = parse(text).unwrap_err();
            assert!(error.span.end as usize <= text.len() && error.span.start <= error.span.end, "{text}: {error:?}");
        }
        assert!(parse("{\"a\":1,\"a\":2}").is_err());
        assert!(parse(&"[".repeat(1_000_000)).is_err());
        assert!(parse(&format!("[{}1]", "1,".repeat(MOST_VALUES))).is_err());
    }
}
