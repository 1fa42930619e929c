//! Where the text of a fix goes: adding a missing field, removing a surplus statement.

use crate::source::{Source, Span};

/// Where to insert the statement `text` in a block, and with which separators: after `last`, the last statement of its
/// body, or after the brace that follows `head`. `None` where the block has another shape.
pub(super) fn insertion(source: &Source, head: Span, last: Option<Span>, text: &str) -> Option<(Span, String)> {
    let whole = source.text.as_str();
    let line_of = |at: u32| source.line(source.place(at as usize).line);
    if let Some(last) = last {
        let rest_of_line = last.end as usize..line_of(last.end).end;
        let rest = whole.get(rest_of_line.clone())?.trim();
        if !rest.is_empty() && !rest.starts_with("//") {
            return Some((Span { start: last.end, ..last }, format!("; {text}")));
        }
        let at = rest_of_line.end;
        return Some((Span::new(last.file, at, at), format!("\n{}{text}", indent(source, last.start))));
    }
    let rest_of_line = head.end as usize..line_of(head.end).end;
    let brace = rest_of_line.start + whole.get(rest_of_line.clone())?.find('{')? + 1;
    let at = Span::new(head.file, brace, brace);
    match whole.get(brace..rest_of_line.end)?.trim() {
        "" => Some((at, format!("\n{}    {text}", indent(source, head.start)))),
        "}" => Some((at, format!(" {text} "))),
        _ => None,
    }
}

/// The indentation of the line that contains `at`.
fn indent(source: &Source, at: u32) -> &str {
    let line = &source.text[source.line(source.place(at as usize).line)];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

/// The span to delete for the statement at `span`: its line if it is alone there, otherwise the statement and one
/// separator.
pub(super) fn removal(source: &Source, span: Span) -> Span {
    let (start, end) = (span.start as usize, span.end as usize);
    let first = source.line(source.place(start).line).start;
    let last = source.line(source.place(end).line).end;
    let text = source.text.as_str();
    let (before, after) = (text.get(first..start).unwrap_or(""), text.get(end..last).unwrap_or(""));
    let comment = after.trim_start().starts_with("//");
    if before.trim().is_empty() && (after.trim().is_empty() || comment) {
        let line_end = text[last..].find('\n').map_or(text.len(), |n| last + n + 1);
        return Span::new(span.file, first, line_end);
    }
    let spaces = after.len() - after.trim_start().len();
    match after.trim_start().starts_with(';') {
        true => {
            let rest = &after[spaces + 1..];
            Span::new(span.file, start, end + spaces + 1 + rest.len() - rest.trim_start_matches(' ').len())
        }
        // The last statement of its line: delete the separator before it.
        false => match before.trim_end().strip_suffix(';') {
            Some(kept) => Span::new(span.file, first + kept.len(), end),
            None => Span::new(span.file, first + before.trim_end().len(), end),
        },
    }
}

/// The span to delete for an element of a list: the element and one comma.
pub(super) fn element(source: &Source, span: Span) -> Span {
    let (before, after) = source.text.split_at(span.end as usize);
    let before = before.get(..span.start as usize).unwrap_or("");
    let gap = after.len() - after.trim_start().len();
    match (before.trim_end().strip_suffix(','), after.trim_start().strip_prefix(',')) {
        (Some(kept), _) => Span::new(span.file, kept.len(), span.end as usize),
        (None, Some(rest)) => {
            let blanks = rest.len() - rest.trim_start_matches(' ').len();
            Span::new(span.file, span.start as usize, span.end as usize + gap + 1 + blanks)
        }
        (None, None) => span,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::FileId;

    fn at(text: &str, part: &str) -> Span {
        let start = text.find(part).unwrap();
        Span::new(FileId(0), start, start + part.len())
    }

    fn put(text: &str, (span, new): (Span, String)) -> String {
        format!("{}{new}{}", &text[..span.start as usize], &text[span.end as usize..])
    }

    #[test]
    fn statements_go_below_the_last_one_and_removed_ones_leave_no_gap() {
        let inserted = |text: &str, last: Option<&str>| {
            let source = Source::new("t", text);
            put(text, insertion(&source, at(text, "a"), last.map(|last| at(text, last)), "z = 1").unwrap())
        };
        assert_eq!(inserted("v a {\n  b = 2 // c\n}\n", Some("b = 2")), "v a {\n  b = 2 // c\n  z = 1\n}\n");
        assert_eq!(inserted("v a { b = 2 }\n", Some("b = 2")), "v a { b = 2; z = 1 }\n");
        assert_eq!(inserted("v a {\n}\n", None), "v a {\n    z = 1\n}\n");
        assert_eq!(inserted("v a {}\n", None), "v a { z = 1 }\n");
        let removed = |text: &str| put(text, (removal(&Source::new("t", text), at(text, "b = 2")), String::new()));
        assert_eq!(removed("{\n  a = 1\n  b = 2\n  c = 3\n}"), "{\n  a = 1\n  c = 3\n}");
        assert_eq!(removed("{ a = 1; b = 2; c = 3 }"), "{ a = 1; c = 3 }");
        assert_eq!(removed("{ a = 1; b = 2 }"), "{ a = 1 }");
        assert_eq!(removed("w a 1  b = 2  c 3"), "w a 1  c 3");
    }

    #[test]
    fn an_element_takes_one_comma_along() {
        let without = |text: &str| put(text, (element(&Source::new("t", text), at(text, "b")), String::new()));
        assert_eq!(without("[a, b, c]"), "[a, c]");
        assert_eq!(without("[b, c]"), "[c]");
        assert_eq!(without("[a, b]"), "[a]");
        assert_eq!(without("[b]"), "[]");
    }
}
