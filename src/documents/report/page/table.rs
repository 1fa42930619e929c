//! Tables of the page, which scroll by themselves where the screen is narrow.

use maud::{Markup, Render, html};

/// The head of a column: its name, and the unit below it.
pub struct Head {
    name: String,
    unit: Option<String>,
    of_numbers: bool,
}

/// The head of a column of words.
pub fn words(name: &str) -> Head {
    Head { name: name.into(), unit: None, of_numbers: false }
}

/// The head of a column of numbers without a unit.
pub fn counts(name: impl Into<String>) -> Head {
    Head { name: name.into(), unit: None, of_numbers: true }
}

/// The head of a column of numbers in a unit.
pub fn numbers(name: &str, unit: impl Into<String>) -> Head {
    Head { unit: Some(unit.into()), ..counts(name) }
}

impl Render for Head {
    fn render(&self) -> Markup {
        let name = html! { (self.name) @if let Some(unit) = &self.unit { br; span.unit { (unit) } } };
        html! { @if self.of_numbers { th.n scope="col" { (name) } } @else { th scope="col" { (name) } } }
    }
}

/// What is around the rows of a table.
#[derive(Default)]
pub struct Frame<'a> {
    /// The name that screen readers give it.
    pub label: &'a str,
    /// `map` or `compact`.
    pub class: Option<&'static str>,
    /// The `id` of the list that explains its columns ([`super::prose::terms`]).
    pub terms: Option<&'static str>,
    pub caption: Option<Markup>,
}

/// A table with the given rows, each a `tr`.
pub fn table(frame: Frame, heads: &[Head], rows: Markup) -> Markup {
    html! {
        div.scroll tabindex="0" role="region" aria-label=(frame.label) {
            table class=[frame.class] aria-describedby=[frame.terms] {
                @if let Some(caption) = &frame.caption { caption { span { (caption) } } }
                thead { tr { @for head in heads { (head) } } }
                tbody { (rows) }
            }
        }
    }
}
