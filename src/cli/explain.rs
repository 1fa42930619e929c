use super::{FINE, Problem, USAGE, files};
use crate::diagnostic::{codes, nearest};
use crate::source::visible;

/// Codes that are named instead of one that there is not.
const MOST_OFFERED: usize = 20;

/// `mavc explain`
pub fn run(code: Option<&str>) -> Result<u8, Problem> {
    let Some(code) = code else {
        files::print(&listed(codes::all()))?;
        return Ok(FINE);
    };
    match codes::lookup(code) {
        Some(page) => {
            files::print(&format!("{}\n\n{}\n", page.code, page.page.trim()))?;
            Ok(FINE)
        }
        // The codes of one kind, as in `mavc explain sense`.
        None if of_kind(code).next().is_some() => {
            files::print(&listed(of_kind(code)))?;
            Ok(FINE)
        }
        None => {
            // Several lines, which a problem is not.
            files::tell(&format!("mavc: {}\n", unknown(&visible::line(code))));
            Ok(USAGE)
        }
    }
}

/// The codes whose middle word this is, with or without the first.
fn of_kind(kind: &str) -> impl Iterator<Item = &'static codes::CodePage> {
    let kind = kind.trim().trim_end_matches("::");
    let within = format!("mavc::{}::", kind.strip_prefix("mavc::").unwrap_or(kind).to_lowercase());
    codes::all().iter().filter(move |page| page.code.starts_with(&within))
}

/// One line a code, its title beside it.
fn listed<'p>(pages: impl IntoIterator<Item = &'p codes::CodePage>) -> String {
    let pages: Vec<_> = pages.into_iter().collect();
    let width = pages.iter().map(|page| page.code.len()).max().unwrap_or(0);
    pages.iter().map(|page| format!("{:<width$}  {}\n", page.code, page.title)).collect()
}

/// What to ask for instead of `code`: the codes that have it in them, or else the nearest, by the whole or by its last word.
fn unknown(code: &str) -> String {
    let word = code.to_lowercase().replace(['-', ' '], "_");
    let within: Vec<_> = codes::all().iter().filter(|page| !word.is_empty() && page.code.contains(&word)).collect();
    if let [only] = within[..] {
        return format!("there is no code {code}; did you mean {}?", only.code);
    }
    if (2..=MOST_OFFERED).contains(&within.len()) {
        return format!("there is no code {code}; these have it in them:\n{}", listed(within).trim_end());
    }
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
