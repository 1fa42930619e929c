//! The pages of diagnostic codes, read from `docs/diagnostics/`: `mavc explain` prints the documentation itself.

use std::sync::LazyLock;

/// A code and its page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodePage {
    /// `mavc::unit::mismatch`
    pub code: &'static str,
    /// The first line of the page: one sentence.
    pub title: &'static str,
    /// The file with its page: `syntax`, `model`, `sense`, `analysis`, `import` or `log`.
    pub book: &'static str,
    /// What the code means, an example, and how to fix it, in Markdown; with the title, without the heading.
    pub page: &'static str,
}

const BOOKS: [(&str, &str); 6] = [
    ("syntax", include_str!("../../pages/syntax.md")),
    ("model", include_str!("../../pages/model.md")),
    ("sense", include_str!("../../pages/sense.md")),
    ("analysis", include_str!("../../pages/analysis.md")),
    ("import", include_str!("../../pages/import.md")),
    ("log", include_str!("../../pages/log.md")),
];

static PAGES: LazyLock<Vec<CodePage>> =
    LazyLock::new(|| BOOKS.into_iter().flat_map(|(book, text)| pages(book, text)).collect());

/// Every code, in the order of the documentation.
pub fn all() -> &'static [CodePage] {
    &PAGES
}

/// The page of a code; `syntax::depth` finds `mavc::syntax::depth`.
pub fn lookup(code: &str) -> Option<&'static CodePage> {
    let wanted = code.strip_prefix("mavc::").unwrap_or(code);
    PAGES.iter().find(|p| p.code.strip_prefix("mavc::") == Some(wanted))
}

impl CodePage {
    /// `mismatch` of `mavc::unit::mismatch`.
    pub fn last_word(&self) -> &'static str {
        self.code.rsplit("::").next().unwrap_or(self.code)
    }

    /// The address of the page; `docs` is the address of the documentation's folder, without a trailing slash. Anchors
    /// drop punctuation from headings, as GitHub does.
    pub fn url(&self, docs: &str) -> String {
        format!("{docs}/diagnostics/{}.md#{}", self.book, self.code.replace(':', ""))
    }
}

/// The sections of one file that begin with `## mavc::..`.
fn pages(book: &'static str, text: &'static str) -> impl Iterator<Item = CodePage> {
    text.split("\n## ").skip(1).filter_map(move |section| {
        let (code, page) = section.split_once('\n')?;
        let page = page.trim();
        let title = page.lines().next()?;
        code.starts_with("mavc::").then_some(CodePage { code: code.trim(), title, book, page })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_found_by_full_and_short_code() {
        let page = lookup("mavc::syntax::depth").unwrap();
        assert_eq!(lookup("syntax::depth"), Some(page));
        assert!(page.page.starts_with(page.title));
        assert_eq!(lookup("mavc::syntax::nothing"), None);
        assert_eq!(lookup(""), None);
    }

    #[test]
    fn titles_are_sentences() {
        let broken: Vec<&str> = all().iter().filter(|page| !page.title.ends_with('.')).map(|page| page.code).collect();
        assert!(broken.is_empty(), "the first line of a page is one sentence: {broken:?}");
    }

    #[test]
    fn no_code_has_two_pages() {
        let mut codes: Vec<_> = all().iter().map(|p| p.code).collect();
        codes.sort_unstable();
        let count = codes.len();
        codes.dedup();
        assert_eq!(codes.len(), count);
    }
}
