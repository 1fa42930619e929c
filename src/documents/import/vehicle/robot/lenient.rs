//! What the parsers of Gazebo (tinyxml2), MuJoCo (tinyxml2) and ROS (urdfdom) accept although XML forbids it, in the
//! form of XML: comments with `--` within, and prefixes of names that no `xmlns` declares, such as the `gz:` of
//! Gazebo Sim.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

/// The text in a form that a strict parser accepts; of the same length, so that places stay.
///
/// Comments become blanks, and the colon after a prefix that is declared nowhere becomes `_`.
pub fn accepted(text: &str) -> Cow<'_, str> {
    let mut changes: Vec<(Range<usize>, u8)> = Vec::new();
    let declared = declared(text);
    let mut from = 0;
    while let Some(tag) = text[from..].find('<').map(|at| from + at) {
        let rest = &text[tag..];
        from = if let Some(comment) = rest.strip_prefix("<!--") {
            let Some(end) = comment.find("-->") else { break };
            let inner = tag + "<!--".len()..tag + "<!--".len() + end;
            if text[inner.clone()].contains("--") || text[inner.clone()].ends_with('-') {
                changes.push((inner.clone(), b' '));
            }
            inner.end
        } else if let Some((_, end)) = [("<![CDATA[", "]]>"), ("<?", "?>")].iter().find(|(b, _)| rest.starts_with(b)) {
            let Some(end) = rest.find(end) else { break };
            tag + end
        } else {
            tag + colons(&text[tag..], tag, &declared, &mut changes)
        };
    }
    if changes.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bytes = text.as_bytes().to_vec();
    for (range, with) in changes {
        bytes[range].iter_mut().filter(|byte| **byte != b'\n').for_each(|byte| *byte = with);
    }
    // Whole characters are replaced.
    String::from_utf8(bytes).map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Adds the colons after undeclared prefixes of the tag with which `rest` begins, at `tag`, and returns its length.
fn colons(rest: &str, tag: usize, declared: &HashSet<&str>, changes: &mut Vec<(Range<usize>, u8)>) -> usize {
    let (mut quote, mut name) = (None, 1);
    for (i, byte) in rest.bytes().enumerate().skip(1) {
        match (quote, byte) {
            (Some(open), _) if byte == open => (quote, name) = (None, i + 1),
            (Some(_), _) => {}
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'>') => return i + 1,
            (None, b'/') => name = i + 1,
            (None, b':') => {
                let prefix = rest.get(name..i).unwrap_or_default();
                if !matches!(prefix, "xmlns" | "xml") && !declared.contains(prefix) {
                    changes.push((tag + i..tag + i + 1, b'_'));
                }
            }
            (None, _) if byte.is_ascii_whitespace() => name = i + 1,
            (None, _) => {}
        }
    }
    rest.len()
}

/// The prefixes that some element declares.
fn declared(text: &str) -> HashSet<&str> {
    let after = text.match_indices("xmlns:").map(|(at, found)| &text[at + found.len()..]);
    let name = |rest: &'_ str| rest.find(|c: char| c.is_whitespace() || matches!(c, '=' | ':' | '<' | '>'));
    after.filter_map(|rest| name(rest).map(|end| &rest[..end])).collect()
}

#[cfg(test)]
mod tests {
    use super::accepted;

    #[test]
    fn places_stay_and_well_formed_text_is_not_touched() {
        let strict = "<?xml version='1.0'?><a xmlns:g='u'><!-- a - b --><g:c g:d='x:y'/><![CDATA[<!-- -- -->]]></a>";
        assert_eq!(accepted(strict), strict);
        let text = "<a><!-- ä -- \n b --><s gz:type='q:r' t=\"1\"/><gz:p></gz:p><!----></a>";
        let given = accepted(text);
        assert_eq!(given.len(), text.len());
        assert!(given.contains("gz_type='q:r'") && given.contains("<gz_p></gz_p>"), "{given}");
        assert!(given.starts_with("<a><!--       \n   --><s"), "{given}");
        assert!(roxmltree::Document::parse(text).is_err() && roxmltree::Document::parse(&given).is_ok());
        for cut in ["<a", "<a b:", "<!-- -- ", "<", "<a:b:c", "<![CDATA[", "<a 'x"] {
            assert_eq!(accepted(cut).len(), cut.len());
        }
    }
}
