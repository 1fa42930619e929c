//! The layout of a text, as an edit.

use super::documents::range;
use crate::format::format;
use crate::source::{FileId, Source};
use gen_lsp_types::TextEdit;

/// What is to be put in place of the lines that change; nothing where the text has its layout already, and `None` where
/// it has errors of syntax, and so no layout.
pub fn layout(source: &Source) -> Option<Vec<TextEdit>> {
    let new = format(FileId(0), source).value?;
    let old = source.text.as_str();
    if new == old {
        return Some(Vec::new());
    }
    // Lines that stay at both ends are left alone, so that the cursor stays where it is.
    let lines = |text: &str| text.split_inclusive('\n').map(str::len).collect::<Vec<_>>();
    let same = |a: &str, b: &str| -> usize {
        a.split_inclusive('\n').zip(b.split_inclusive('\n')).take_while(|(a, b)| a == b).map(|(a, _)| a.len()).sum()
    };
    let front = same(old, &new);
    let (old_rest, new_rest) = (&old[front..], &new[front..]);
    let (old_lines, new_lines) = (lines(old_rest), lines(new_rest));
    let (mut old_end, mut new_end) = (old_rest.len(), new_rest.len());
    for (a, b) in old_lines.iter().rev().zip(new_lines.iter().rev()) {
        if old_rest[old_end - a..old_end] != new_rest[new_end - b..new_end] {
            break;
        }
        (old_end, new_end) = (old_end - a, new_end - b);
    }
    let range = range(source, front, front + old_end);
    Some(vec![TextEdit { range, new_text: new_rest[..new_end].to_string() }])
}
