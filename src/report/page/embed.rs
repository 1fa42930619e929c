//! Script, style and data inside a page, so that nothing in a spec can become either.

use crate::source::visible;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use sha2::{Digest, Sha256};

/// Bundled from `assets/page` with the licences of what is in it.
pub const SCRIPT: &str = include_str!("../../../assets/page/dist/page.js");
pub const STYLE: &str = include_str!("../../../assets/page/dist/page.css");

/// What the page may load: nothing from anywhere, and only the script and style it came with.
pub fn policy() -> String {
    let hash = |text: &str| format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text.as_bytes())));
    format!(
        "default-src 'none'; script-src {}; style-src {}; img-src data: blob:; base-uri 'none'; form-action 'none'",
        hash(SCRIPT),
        hash(STYLE)
    )
}

/// JSON that stands in a `script` element: no `<`, `>` or `&` of it is markup, and no line ends where JSON does not.
pub fn json(content: &impl Serialize) -> String {
    let text = visible::json(serde_json::to_string(content).expect("texts and finite numbers always serialise"));
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' | '>' | '&' => safe.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => safe.push(c),
        }
    }
    safe
}
