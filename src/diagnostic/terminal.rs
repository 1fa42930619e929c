//! Diagnostics for people: the headline, the lines it speaks of, one action.

use super::{Diagnostic, Label, Severity, codes};
use crate::source::{Source, SourceMap, Span};
use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan,
    SpanContents,
};
use std::fmt;

/// One report a problem, in the order given, a blank line between two. `width` is in columns.
pub fn render_human(diagnostics: &[Diagnostic], sources: &SourceMap, width: usize, color: bool) -> String {
    render_linked(diagnostics, sources, width, color, None)
}

/// The same, where each code leads to its page (OSC 8) under `docs`, the address of the documentation's folder.
pub fn render_linked(
    diagnostics: &[Diagnostic],
    sources: &SourceMap,
    width: usize,
    color: bool,
    docs: Option<&str>,
) -> String {
    let theme = if color { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(width)
        .with_links(docs.is_some())
        .with_link_display_text("")
        .with_cause_chain()
        .with_context_lines(1)
        .tab_width(4);
    let mut text = String::new();
    for diagnostic in diagnostics {
        let report = Report::new(diagnostic, sources, docs);
        if handler.render_report(&mut text, &report).is_err() {
            // Only a span outside its file leads here; the facts still reach the reader.
            text.push_str(&super::render_short(std::slice::from_ref(diagnostic), sources));
        }
        for elsewhere in &report.elsewhere {
            // As above; what matters has been said.
            let _ = handler.render_report(&mut text, elsewhere);
        }
        text.push('\n');
    }
    text
}

/// A diagnostic as miette wants it; labels in other files, or far along a line, become
/// reports beside it.
struct Report<'a> {
    diagnostic: &'a Diagnostic,
    /// The page of its code.
    url: Option<String>,
    excerpt: Excerpt<'a>,
    labels: Vec<LabeledSpan>,
    elsewhere: Vec<Elsewhere<'a>>,
}

impl<'a> Report<'a> {
    fn new(diagnostic: &'a Diagnostic, sources: &'a SourceMap, docs: Option<&str>) -> Self {
        let own = diagnostic.span;
        let source = sources.get(own.file);
        let near = |span: Span| {
            let line = source.place(own.start as usize).line;
            let beside = source.place(span.start as usize).line == line;
            let shown = if source.line(line).len() > LONGEST { MARGIN } else { LONGEST };
            span.file == own.file && (!beside || span.start.abs_diff(own.start) as usize <= shown)
        };
        let (here, apart): (Vec<_>, Vec<_>) = diagnostic.labels.iter().partition(|l| near(l.span));
        let mut labels = vec![LabeledSpan::new_primary_with_span(worded(&diagnostic.label), place(source, own))];
        labels.extend(here.iter().map(|l| LabeledSpan::new_with_span(worded(&l.message), place(source, l.span))));
        let last = apart.len();
        let elsewhere: Vec<_> = (1..)
            .zip(apart)
            .map(|(k, label)| Elsewhere {
                label,
                excerpt: Excerpt(sources.get(label.span.file)),
                help: diagnostic.help.as_deref().filter(|_| k == last),
            })
            .collect();
        let url = docs.and_then(|docs| Some(codes::lookup(diagnostic.code)?.url(docs)));
        Report { diagnostic, url, excerpt: Excerpt(source), labels, elsewhere }
    }
}

fn worded(message: &str) -> Option<String> {
    (!message.is_empty()).then(|| message.to_string())
}

/// Where a span is drawn: its beginning, where it is very long.
fn place(source: &Source, span: Span) -> SourceSpan {
    let (start, end) = (span.start as usize, span.end as usize);
    let end = end.min(boundary(&source.text, start + LONGEST)).max(start);
    (start, end - start).into()
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.diagnostic.message)
    }
}

impl fmt::Debug for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Report<'_> {}

impl miette::Diagnostic for Report<'_> {
    fn code<'b>(&'b self) -> Option<Box<dyn fmt::Display + 'b>> {
        Some(Box::new(self.diagnostic.code))
    }

    fn url<'b>(&'b self) -> Option<Box<dyn fmt::Display + 'b>> {
        self.url.as_ref().map(|url| Box::new(url) as Box<dyn fmt::Display>)
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.diagnostic.severity {
            Severity::Error => miette::Severity::Error,
            Severity::Warning => miette::Severity::Warning,
            Severity::Advice => miette::Severity::Advice,
        })
    }

    fn help<'b>(&'b self) -> Option<Box<dyn fmt::Display + 'b>> {
        // What to do comes after all that is shown.
        let help = self.diagnostic.help.as_ref().filter(|_| self.elsewhere.is_empty());
        help.map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}

/// A label in another file than its diagnostic.
struct Elsewhere<'a> {
    label: &'a Label,
    excerpt: Excerpt<'a>,
    /// The diagnostic's, where this is its last place.
    help: Option<&'a str>,
}

impl fmt::Display for Elsewhere<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label.message)
    }
}

impl fmt::Debug for Elsewhere<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Elsewhere<'_> {}

impl miette::Diagnostic for Elsewhere<'_> {
    fn severity(&self) -> Option<miette::Severity> {
        Some(miette::Severity::Advice)
    }

    fn help<'b>(&'b self) -> Option<Box<dyn fmt::Display + 'b>> {
        self.help.map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(std::iter::once(LabeledSpan::new_primary_with_span(
            None,
            place(self.excerpt.0, self.label.span),
        ))))
    }
}

/// Reads lines by the source's own index, so that many reports on a long file cost little.
struct Excerpt<'a>(&'a Source);

/// Lines are shown from their beginning and to their end where a span is no further than so many bytes from either.
const LONGEST: usize = 400;

/// Bytes shown on a side of a span where the line goes on for longer: a line may be as long as a file.
const MARGIN: usize = 60;

impl SourceCode for Excerpt<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let (source, text) = (self.0, &self.0.text);
        let (start, end) = (span.offset(), span.offset() + span.len());
        if !text.is_char_boundary(start) || !text.is_char_boundary(end) {
            return Err(MietteError::OutOfBounds);
        }
        let first = source.place(start).line.saturating_sub(before).max(1);
        let last = source.place(end.saturating_sub(1).max(start)).line + after;
        let from = if before == 0 { start } else { source.line(first).start };
        // Without the line before, where that one is long.
        let own = source.line(source.place(start).line).start;
        let whole = [from, own].into_iter().find(|from| start <= from + LONGEST);
        let from = whole.unwrap_or_else(|| boundary(text, start - MARGIN));
        let to = source.line(last).end.max(end);
        let to = if to > end + LONGEST { boundary(text, end + MARGIN) } else { to };
        let place = source.place(from);
        let contents = MietteSpanContents::new_named(
            source.name.clone(),
            &text.as_bytes()[from..to],
            (from, to - from).into(),
            place.line - 1,
            place.column - 1,
            last.saturating_sub(place.line) + 1,
        );
        Ok(Box::new(contents))
    }
}

/// The last place at or before `at` where a character begins.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}
