//! Escapes characters that disguise a text in what an editor shows; text edits and file names are not changed.

use crate::source::visible;
use lsp_server::Message;
use serde_json::Value;

/// Members whose text is shown and nothing else.
const SHOWN: [&str; 6] = ["message", "value", "detail", "documentation", "title", "description"];

/// The message, with control and bidirectional characters in what is shown as escapes.
pub fn plainly(mut message: Message) -> Message {
    match &mut message {
        Message::Request(request) => plain(&mut request.params),
        Message::Notification(note) => plain(&mut note.params),
        Message::Response(response) => match &mut response.response_result {
            Ok(result) => plain(result),
            Err(error) => error.message = visible::text(&error.message).into_owned(),
        },
    }
    message
}

fn plain(value: &mut Value) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(plain),
        Value::Object(members) => members.iter_mut().for_each(|(name, member)| match member {
            Value::String(text) if SHOWN.contains(&name.as_str()) => {
                if let std::borrow::Cow::Owned(shown) = visible::text(text) {
                    *text = shown;
                }
            }
            member => plain(member),
        }),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lsp_server::{RequestId, Response};
    use serde_json::json;

    #[test]
    fn only_what_is_shown_has_escapes() {
        let result = json!({
            "contents": { "kind": "markdown", "value": "a\u{1b}[31m\nb" },
            "edits": [{ "newText": "\u{202e}", "title": "\u{202e}" }],
        });
        let Message::Response(shown) = plainly(Response::new_ok(RequestId::from(1), result).into()) else { panic!() };
        let result = &serde_json::to_value(&shown).unwrap()["result"];
        assert_eq!(result["contents"]["value"], "a\\u{1b}[31m\nb");
        assert_eq!(result["edits"][0], json!({ "newText": "\u{202e}", "title": "\\u{202e}" }));
    }
}
