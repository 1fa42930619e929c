//! Diagnostics for people: the message, the lines of source that it concerns, and the help.

use super::excerpt::{Excerpt, Excerpts, LONGEST, MARGIN, TAB};
use super::{Diagnostic, Label, Severity, codes};
use crate::source::{SourceMap, Span, visible};
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, SourceCode};
use std::fmt::{self, Write};

/// Renders one report for each diagnostic, in the order given and separated by blank lines. `width` is in columns.
pub fn render_human(diagnostics: &[Diagnostic], sources: &SourceMap, width: usize, color: bool) -> String {
    render_linked(diagnostics, sources, width, color, None)
}

/// Renders one report for each diagnostic, separated by blank lines, at most `width` columns wide, except where a line
/// of source is wider. A mistake that is repeated in a file is one report, which lists the other lines. Each code links
/// (OSC 8) to its page under `docs`, the address of the documentation's folder.
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
        .tab_width(TAB)
        .with_word_separator(textwrap::WordSeparator::AsciiSpace)
        .with_word_splitter(textwrap::WordSplitter::NoHyphenation);
    let mut text = String::new();
    let excerpts = Excerpts::new(sources);
    for (i, diagnostic) in diagnostics.iter().enumerate() {
        if diagnostics[..i].iter().any(|first| is_repeated(first, diagnostic)) {
            continue;
        }
        let report = Report::new(diagnostic, &excerpts, docs, width);
        if handler.render_report(&mut text, &report).is_err() {
            // Only a span outside its file can fail; the reader then gets the short form.
            text.push_str(&render_short(std::slice::from_ref(diagnostic), sources));
        }
        for elsewhere in &report.elsewhere {
            // A label that cannot be shown is left out.
            let _ = handler.render_report(&mut text, elsewhere);
        }
        let source = sources.get(diagnostic.span.file);
        let mut lines: Vec<usize> = diagnostics[i + 1..]
            .iter()
            .filter(|other| is_repeated(diagnostic, other))
            .map(|other| source.place(other.span.start as usize).line)
            .collect();
        lines.sort_unstable();
        lines.dedup();
        text.push_str(&also(&lines, width));
        text.push('\n');
    }
    text
}

/// Whether two diagnostics report one mistake at two places of a file.
fn is_repeated(first: &Diagnostic, other: &Diagnostic) -> bool {
    let what = |d: &Diagnostic| (d.code, d.severity, d.span.file, d.labels.is_empty());
    what(first) == what(other)
        && first.labels.is_empty()
        && (&first.message, &first.label, &first.help) == (&other.message, &other.label, &other.help)
}

/// `  also in lines 12, 14 and 20`; empty without lines.
fn also(lines: &[usize], width: usize) -> String {
    let numbers: Vec<String> = lines.iter().map(usize::to_string).collect();
    let text = match numbers.as_slice() {
        [] => return String::new(),
        [one] => format!("also in line {one}"),
        [first @ .., last] => format!("also in lines {} and {last}", first.join(", ")),
    };
    textwrap::fill(&text, in_words(width).initial_indent("  ").subsequent_indent("  ")) + "\n"
}

/// Lines that break at blanks only, not within `1.1 kg/m^3` or a path.
fn in_words(width: usize) -> textwrap::Options<'static> {
    textwrap::Options::new(width)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .word_splitter(textwrap::WordSplitter::NoHyphenation)
}

/// A diagnostic in the form that miette renders. Labels in other files, or far away in a long line, become separate
/// reports.
struct Report<'a> {
    diagnostic: &'a Diagnostic,
    /// The page of its code.
    url: Option<String>,
    excerpt: &'a Excerpt<'a>,
    labels: Vec<LabeledSpan>,
    elsewhere: Vec<Elsewhere<'a>>,
}

impl<'a> Report<'a> {
    fn new(diagnostic: &'a Diagnostic, excerpts: &'a Excerpts<'a>, docs: Option<&str>, width: usize) -> Self {
        let own = diagnostic.span;
        let excerpt = excerpts.get(own.file);
        let (source, start) = (&excerpt.shown, excerpt.start(own));
        let near = |span: Span| {
            if span.file != own.file {
                return false;
            }
            let line = source.place(start).line;
            let at = excerpt.start(span);
            let shown = if source.line(line).len() > LONGEST { MARGIN } else { LONGEST };
            source.place(at).line != line || at.abs_diff(start) <= shown
        };
        let (here, apart): (Vec<_>, Vec<_>) = diagnostic.labels.iter().partition(|l| near(l.span));
        let worded = |message: &str, span: Span| worded(message, excerpt.room(span, width));
        let mut labels = vec![LabeledSpan::new_primary_with_span(worded(&diagnostic.label, own), excerpt.place(own))];
        labels
            .extend(here.iter().map(|l| LabeledSpan::new_with_span(worded(&l.message, l.span), excerpt.place(l.span))));
        let last = apart.len();
        let elsewhere: Vec<_> = (1..)
            .zip(apart)
            .map(|(k, label)| Elsewhere {
                label,
                excerpt: excerpts.get(label.span.file),
                help: diagnostic.help.as_deref().filter(|_| k == last),
            })
            .collect();
        let url = docs.and_then(|docs| Some(codes::lookup(diagnostic.code)?.url(docs)));
        Report { diagnostic, url, excerpt, labels, elsewhere }
    }
}

/// A label in lines of at most `room` columns.
fn worded(message: &str, room: usize) -> Option<String> {
    (!message.is_empty()).then(|| textwrap::fill(&visible::line(message), in_words(room)))
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&visible::line(&self.diagnostic.message))
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
        // The help comes after the last excerpt.
        let help = self.diagnostic.help.as_ref().filter(|_| self.elsewhere.is_empty());
        help.map(|help| Box::new(visible::text(help)) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}

/// A label that is rendered apart from its diagnostic.
struct Elsewhere<'a> {
    label: &'a Label,
    excerpt: &'a Excerpt<'a>,
    /// The help of the diagnostic, if this is its last label.
    help: Option<&'a str>,
}

impl fmt::Display for Elsewhere<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&visible::line(&self.label.message))
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
        self.help.map(|help| Box::new(visible::text(help)) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(std::iter::once(LabeledSpan::new_primary_with_span(None, self.excerpt.place(self.label.span)))))
    }
}

/// Renders each as `file:line:column: error[code]: message` and a newline.
pub fn render_short(diagnostics: &[Diagnostic], sources: &SourceMap) -> String {
    let mut text = String::new();
    for d in diagnostics {
        let source = sources.get(d.span.file);
        let place = source.place(d.span.start as usize);
        let (severity, message) = (d.severity.name(), d.message.replace('\n', " "));
        let (name, message) = (visible::line(&source.name), visible::line(&message));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name}:{}:{}: {severity}[{}]: {message}", place.line, place.column, d.code);
    }
    text
}
