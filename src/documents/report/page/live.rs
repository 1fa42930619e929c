//! Pages that renew themselves: what `mavc view` serves.
//!
//! A page is the report page with one more element, in which the script shows the state of the spec, and with a policy
//! that lets it listen to its own server.

use super::{document, embed};
use maud::{DOCTYPE, PreEscaped, html};

/// The content security policy of a live page, as its head has it: nothing may be loaded but the events of its own
/// server.
pub fn policy() -> String {
    embed::policy(true)
}

/// The live form of a page of this report; `number` counts the pages that a browser is told of.
///
/// # Panics
/// Never, for a page of this module's neighbours: each has one policy, and one body with this mark at its start.
pub fn live(page: &str, number: u64) -> String {
    let place = html! { div #live role="status" data-page=(number) {} }.into_string();
    let (head, body) = page.split_once("<body>").expect("a page has a body");
    let head = head.replacen(&escaped(&embed::policy(false)), &escaped(&policy()), 1);
    // Without one of its own a browser asks the server for an icon.
    let icon = html! { link rel="icon" href="data:,"; }.into_string();
    let head = head.replacen("</head>", &format!("{icon}</head>"), 1);
    format!("{head}<body>{place}{body}")
}

/// A text as an attribute has it.
fn escaped(text: &str) -> String {
    html! { (text) }.into_string()
}

/// The live page before there is a result for the spec `name`.
pub fn waiting(name: &str, number: u64) -> String {
    let nothing = serde_json::json!({ "runs": [], "sets": [], "opens": { "t": 0, "set": 0 } });
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (document::head(name))
            body {
                header.top {
                    div { h1 { (name) } }
                    button #theme type="button" hidden { "Dark theme" }
                }
                main #main { p.note { "There is no plan yet." } }
                script #content type="application/json" { (PreEscaped(embed::json(&nothing))) }
                script { (PreEscaped(embed::SCRIPT)) }
            }
        }
    };
    live(&crate::source::visible::text(&page.into_string()), number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_live_page_may_listen_to_its_server_and_nothing_else_changes() {
        let page = waiting("<b>.mav", 7);
        assert_eq!(page.matches("connect-src 'self'").count() + page.matches("connect-src &#39;self&#39;").count(), 1);
        assert_eq!(page.matches("id=\"live\"").count(), 1, "one place for the state");
        assert!(page.contains("data-page=\"7\"") && page.contains("&lt;b&gt;.mav"));
        assert!(policy().starts_with("default-src 'none'; connect-src 'self'; "));
    }
}
