//! A reader of JSON (RFC 8259) that keeps the place of every value, so that a mistake in a file has one.
//!
//! Time and memory are bounded by the length of the text, [`DEPTH`] and [`MOST_VALUES`].

use super::{SYNTAX, at};
use crate::diagnostic::Diagnostic;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;
use std::collections::HashSet;
use std::ops::Range;

const AGAIN: &str = "write the file again with the program that made it";

/// Lists and objects within each other.
pub const DEPTH: usize = 64;
/// Values of one text; each takes about 60 bytes.
pub const MOST_VALUES: usize = 1_000_000;

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Json {
    pub kind: JsonValue,
    pub span: Range<usize>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum JsonValue {
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
            JsonValue::Object(members) => members.iter().find(|member| member.key == key).map(|member| &member.value),
            _ => None,
        }
    }

    pub fn number(&self) -> Option<f64> {
        if let JsonValue::Number(x) = self.kind { Some(x) } else { None }
    }

    pub fn list(&self) -> Option<&[Json]> {
        if let JsonValue::List(all) = &self.kind { Some(all) } else { None }
    }

    pub fn text(&self) -> Option<&str> {
        if let JsonValue::Text(text) = &self.kind { Some(text) } else { None }
    }

    /// The kind of the value in messages: `a number`, `true or false`.
    pub fn what(&self) -> &'static str {
        match self.kind {
            JsonValue::Null => "null",
            JsonValue::Bool(_) => "true or false",
            JsonValue::Number(_) => "a number",
            JsonValue::Text(_) => "a text",
            JsonValue::List(_) => "a list",
            JsonValue::Object(_) => "an object",
        }
    }
}

/// Reads a text, by the rules of [`serde_json`].
///
/// # Errors
/// The first place that JSON does not allow, a key that an object has twice, a number that no double holds, or a text
/// that is too deep or too long.
pub fn parse(text: &str) -> Result<Json, Box<Diagnostic>> {
    let whole: &RawValue = serde_json::from_str(text).map_err(|error| refused(text, 0, &error))?;
    Reader { text, values: 0 }.value(whole, 0)
}

struct Reader<'t> {
    text: &'t str,
    values: usize,
}

impl<'t> Reader<'t> {
    fn value(&mut self, raw: &'t RawValue, depth: usize) -> Result<Json, Box<Diagnostic>> {
        let part = raw.get();
        let start = place(self.text, part);
        let span = start..start + part.len();
        self.values += 1;
        let limit = |message: String, here: &str| {
            Err(Box::new(Diagnostic::error(SYNTAX, at(start..start + 1), message).here(here).help(AGAIN)))
        };
        if self.values > MOST_VALUES {
            return limit(format!("the file has more than {MOST_VALUES} values"), "the first that is too many");
        }
        if depth > DEPTH {
            return limit(format!("lists and objects are more than {DEPTH} deep"), "the first that is too deep");
        }
        let refused = |error| refused(self.text, start, &error);
        let kind = match part.as_bytes()[0] {
            b'{' => {
                let Members(members) = serde_json::from_str(part).map_err(refused)?;
                JsonValue::Object(self.members(members, depth)?)
            }
            b'[' => {
                let all: Vec<&RawValue> = serde_json::from_str(part).map_err(refused)?;
                JsonValue::List(all.into_iter().map(|raw| self.value(raw, depth + 1)).collect::<Result<_, _>>()?)
            }
            b'"' => JsonValue::Text(serde_json::from_str(part).map_err(refused)?),
            b't' | b'f' => JsonValue::Bool(part == "true"),
            b'n' => JsonValue::Null,
            _ => JsonValue::Number(serde_json::from_str(part).map_err(refused)?),
        };
        Ok(Json { kind, span })
    }

    fn members(
        &mut self,
        raw: Vec<(&'t RawValue, &'t RawValue)>,
        depth: usize,
    ) -> Result<Vec<Member>, Box<Diagnostic>> {
        // A key that occurs twice means one thing to one reader and another to the next.
        let mut keys = HashSet::new();
        let mut members = Vec::new();
        for (key, value) in raw {
            let start = place(self.text, key.get());
            let name: String = serde_json::from_str(key.get()).map_err(|error| refused(self.text, start, &error))?;
            if !keys.insert(name.clone()) {
                let span = at(start..start + key.get().len());
                let error = Diagnostic::error(SYNTAX, span, "an object has the same key twice");
                return Err(Box::new(error.here("the second time").help("remove one of the two")));
            }
            members.push(Member { key: name, value: self.value(value, depth + 1)? });
        }
        Ok(members)
    }
}

/// The keys and values of an object, in order.
struct Members<'t>(Vec<(&'t RawValue, &'t RawValue)>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Members<'de>;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut all = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    all.push(pair);
                }
                Ok(Members(all))
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}

/// Where a part of a text begins in it.
fn place(text: &str, part: &str) -> usize {
    part.as_ptr() as usize - text.as_ptr() as usize
}

/// The error of a part that begins at `start`.
fn refused(text: &str, start: usize, error: &serde_json::Error) -> Box<Diagnostic> {
    let lines = text[start..].split_inclusive('\n').take(error.line().saturating_sub(1));
    let before: usize = lines.map(str::len).sum();
    let place = (start + before + error.column().saturating_sub(1)).min(text.len());
    let place = (0..=place).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let length = text[place..].chars().next().map_or(0, char::len_utf8);
    let message = error.to_string();
    let message = format!("no JSON: {}", message.split(" at line ").next().unwrap_or(&message));
    let here = if length == 0 { "the text ends here" } else { "not expected" };
    Box::new(Diagnostic::error(SYNTAX, at(place..place + length), message).here(here).help(AGAIN))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value without its places, by the reader that everybody uses.
    fn plain(json: &Json) -> serde_json::Value {
        match &json.kind {
            JsonValue::Null => serde_json::Value::Null,
            JsonValue::Bool(b) => (*b).into(),
            JsonValue::Number(x) => (*x).into(),
            JsonValue::Text(t) => t.clone().into(),
            JsonValue::List(all) => all.iter().map(plain).collect(),
            JsonValue::Object(members) => {
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
    fn mistakes_have_their_places() {
        for (text, place) in [("", 0), ("[1,]", 3), ("{\"a\":1,\n\"b\" 1}", 12), ("[1] x", 4)] {
            let error = parse(text).unwrap_err();
            assert_eq!(error.span.start, place, "{text}: {error:?}");
        }
        for text in ["[1e999]", "[\"\\é\"]", "[\"a", "[01]", "[\"a\nb\"]"] {
            let error = parse(text).unwrap_err();
            assert!(error.span.end as usize <= text.len() && error.span.start > 0, "{text}: {error:?}");
        }
        assert_eq!(parse("{\"a\":1,\"a\":2}").unwrap_err().span.start, 7);
        assert!(parse(&"[".repeat(1_000_000)).is_err());
        assert!(parse(&("[".repeat(70) + &"]".repeat(70))).is_err());
        assert!(parse(&format!("[{}1]", "1,".repeat(MOST_VALUES))).is_err());
    }
}
