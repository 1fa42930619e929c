//! Script, style and data embedded in a page, such that no text of a spec can act as script or markup.

use crate::source::visible;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use sha2::{Digest, Sha256};

/// Bundled from `assets/page`, with the licences of its dependencies.
pub const SCRIPT: &str = include_str!("../../../../assets/page/dist/page.js");
pub const STYLE: &str = include_str!("../../../../assets/page/dist/page.css");

/// The page's content security policy: nothing may be loaded, and only the embedded script and style are used. A page
/// that `listens` may connect to its own server.
pub fn policy(listens: bool) -> String {
    let hash = |text: &str| format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text.as_bytes())));
    format!(
        "default-src 'none'; {}script-src {}; style-src {}; img-src data: blob:; base-uri 'none'; form-action 'none'",
        if listens { "connect-src 'self'; " } else { "" },
        hash(SCRIPT),
        hash(STYLE)
    )
}

/// JSON for a `script` element: `<`, `>` and `&` are escaped, so that none of them is markup.
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
