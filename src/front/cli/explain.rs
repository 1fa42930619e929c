//! `mavc explain`: prints the page of a diagnostic code, or lists the codes of a kind, or the kinds.

use super::{CommandError, FINE, USAGE, files};
use crate::diagnostic::{codes, nearest};
use crate::report::screen::WIDTH;
use crate::source::visible;
use std::collections::BTreeMap;

pub fn run(code: Option<&str>) -> Result<u8, CommandError> {
    let Some(code) = code else {
        files::print(&kinds())?;
        return Ok(FINE);
    };
    if let Some(page) = codes::lookup(code) {
        files::print(&whole(page))?;
        return Ok(FINE);
    }
    let kind: Vec<_> = of_kind(code).collect();
    let found = if kind.is_empty() { by_part(code) } else { kind };
    match found[..] {
        [] => {
            files::eprint(&format!("mavc: {}\n", unknown(&visible::line(code))));
            Ok(USAGE)
        }
        [only] => files::print(&whole(only)).map(|()| FINE),
        _ => files::print(&listed(found)).map(|()| FINE),
    }
}

/// A page below its code.
fn whole(page: &codes::CodePage) -> String {
    format!("{}\n\n{}\n", page.code, page.page.trim())
}

/// The codes that contain `part`.
fn by_part(part: &str) -> Vec<&'static codes::CodePage> {
    let part = part.trim().trim_matches(':').to_lowercase().replace(['-', ' '], "_");
    codes::all().iter().filter(|page| !part.is_empty() && page.code.contains(&part)).collect()
}

/// The codes whose middle word is `kind`, given with or without `mavc::`.
fn of_kind(kind: &str) -> impl Iterator<Item = &'static codes::CodePage> {
    let kind = kind.trim().trim_end_matches("::");
    let within = format!("mavc::{}::", kind.strip_prefix("mavc::").unwrap_or(kind).to_lowercase());
    codes::all().iter().filter(move |page| page.code.starts_with(&within))
}

/// Each code, with its title below.
fn listed(pages: Vec<&codes::CodePage>) -> String {
    let below = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
    pages.into_iter().map(|page| format!("{}\n{}\n", page.code, textwrap::fill(page.title, &below))).collect()
}

/// The kinds of codes, the middle words, with the number of codes of each.
fn kinds() -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for page in codes::all() {
        *counts.entry(page.code.split("::").nth(1).unwrap_or_default()).or_default() += 1;
    }
    let mut text = "Kinds of codes, and how many there are:\n".to_string();
    text.extend(counts.iter().map(|(kind, count)| format!("  {kind:<10} {count:>3}\n")));
    text + "`mavc explain KIND` lists the codes of a kind, `mavc explain CODE` explains one.\n"
}

/// The message about an unknown code, with the nearest one, by the whole code or by its last word.
fn unknown(code: &str) -> String {
    let word = code.to_lowercase().replace(['-', ' '], "_");
    let written = if word.starts_with("mavc::") { word.clone() } else { format!("mavc::{word}") };
    let whole = || nearest(&written, codes::all().iter().map(|page| page.code));
    let by_last_word = || {
        let near = nearest(&word, codes::all().iter().map(codes::CodePage::last_word))?;
        codes::all().iter().find(|page| page.last_word() == near).map(|page| page.code)
    };
    match whole().or_else(by_last_word) {
        Some(near) => format!("there is no code {code}; did you mean {near}?"),
        None => format!("there is no code {code}; `mavc explain` lists all"),
    }
}
