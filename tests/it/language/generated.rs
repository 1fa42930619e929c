//! The parts of other files that are written from the table, each between two marks. `MAVC_UPDATE=1 cargo test --test
//! it language` writes them anew.

use super::{read, root, with_tables};
use mavc::language::word_list;
use std::collections::BTreeSet;

/// A file with lists of words on lines of their own: its name, what begins a comment, and what is around and between
/// words.
struct Listing {
    name: &'static str,
    comment: &'static str,
    quote: char,
    between: &'static str,
    /// Whether words stay in their order, because another file was generated from it.
    keeps_order: bool,
    lists: &'static [&'static str],
}

const LISTINGS: [Listing; 5] = [
    Listing {
        name: "grammar/mav.pest",
        comment: "//",
        quote: '"',
        between: " | ",
        keeps_order: false,
        lists: &["clauses with a value", "clauses without a value"],
    },
    // `src/parser.c` numbers the words in this order.
    Listing {
        name: "editors/tree-sitter-mav/grammar.js",
        comment: "//",
        quote: '\'',
        between: ", ",
        keeps_order: true,
        lists: &["statements", "clauses with a value", "clauses without a value"],
    },
    Listing {
        name: "editors/tree-sitter-mav/src/scanner.c",
        comment: "//",
        quote: '"',
        between: ", ",
        keeps_order: false,
        lists: &["clauses"],
    },
    Listing {
        name: "editors/tree-sitter-mav/queries/highlights.scm",
        comment: ";",
        quote: '"',
        between: " ",
        keeps_order: false,
        lists: &[
            "statements of the spec",
            "functions",
            "constants",
            "values of fields",
            "values in lists",
            "values of clauses",
        ],
    },
    Listing {
        name: "editors/emacs/mav-ts-mode.el",
        comment: ";;",
        quote: '"',
        between: " ",
        keeps_order: false,
        lists: &["statements"],
    },
];

const TEXTMATE: &str = "editors/vscode/syntaxes/mav.tmLanguage.json";
const OF_TEXTMATE: [&str; 6] =
    ["clauses", "values of fields", "values in lists", "blocks without a name", "functions", "constants"];
const WIDTH: usize = 118;

fn due(list: &str) -> Vec<&'static str> {
    word_list(list).unwrap_or_else(|| panic!("no list of words is called `{list}`"))
}

impl Listing {
    /// The text with its lists as the language has them.
    fn renewed(&self, text: &str) -> String {
        let begin = format!("{} words: ", self.comment);
        let end = format!("{} end of words", self.comment);
        let (mut out, mut found) = (String::new(), BTreeSet::new());
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            out.push_str(&format!("{line}\n"));
            let Some(list) = line.trim_start().strip_prefix(&begin) else { continue };
            let indent = &line[..line.len() - line.trim_start().len()];
            let old: Vec<&str> = lines.by_ref().take_while(|line| line.trim() != end).collect();
            out.push_str(&self.wrapped(list, &old.join("\n"), indent));
            out.push_str(&format!("{indent}{end}\n"));
            found.insert(list);
        }
        assert_eq!(found, self.lists.iter().copied().collect(), "the marks in {}", self.name);
        out
    }

    fn wrapped(&self, list: &str, old: &str, indent: &str) -> String {
        let mut words = due(list);
        if self.keeps_order {
            let before: Vec<&str> = old.split(self.quote).skip(1).step_by(2).collect();
            words.sort_by_key(|word| before.iter().position(|other| other == word).unwrap_or(before.len()));
        }
        let mut lines = vec![indent.to_string()];
        for (k, word) in words.iter().enumerate() {
            let between = if k + 1 < words.len() { self.between } else { "" };
            let text = format!("{0}{word}{0}{between}", self.quote);
            match lines.last_mut() {
                Some(line) if line.len() + text.trim_end().len() <= WIDTH => line.push_str(&text),
                _ => lines.push(format!("{indent}{text}")),
            }
        }
        lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// The TextMate grammar, whose lists are alternatives of regular expressions between two comments of these: JSON has
/// none.
fn renewed_textmate(text: &str) -> String {
    let mut parts = text.split("(?#words: ");
    let (mut out, mut found) = (parts.next().unwrap().to_string(), BTreeSet::new());
    for part in parts {
        let (list, rest) = part.split_once(')').unwrap();
        let (_, rest) = rest.split_once("(?#end)").unwrap_or_else(|| panic!("`{list}` has no end in {TEXTMATE}"));
        out.push_str(&format!("(?#words: {list}){}(?#end){rest}", due(list).join("|")));
        found.insert(list);
    }
    assert_eq!(found, OF_TEXTMATE.into_iter().collect(), "the marks in {TEXTMATE}");
    out
}

#[test]
fn what_is_written_from_the_table_is_up_to_date() {
    let mut renewed: Vec<(&str, String)> = LISTINGS.iter().map(|l| (l.name, l.renewed(&read(l.name)))).collect();
    renewed.push((TEXTMATE, renewed_textmate(&read(TEXTMATE))));
    renewed.push(("docs/language.md", with_tables(&read("docs/language.md"))));
    let stale: Vec<&(&str, String)> = renewed.iter().filter(|(name, text)| read(name) != *text).collect();
    if std::env::var_os("MAVC_UPDATE").is_some() {
        stale.iter().for_each(|(name, text)| std::fs::write(root().join(name), text).unwrap());
        return;
    }
    let names: Vec<&str> = stale.iter().map(|(name, _)| *name).collect();
    assert!(names.is_empty(), "{names:?} differ from the table: MAVC_UPDATE=1 cargo test --test it language");
}

#[test]
fn a_stale_list_is_found() {
    // Another test is writing these files now.
    if std::env::var_os("MAVC_UPDATE").is_some() {
        return;
    }
    for listing in &LISTINGS {
        let text = read(listing.name);
        let word = format!("{0}{1}{0}", listing.quote, due(listing.lists[0])[0]);
        assert_ne!(listing.renewed(&text.replace(&word, "")), text.replace(&word, ""), "{}", listing.name);
    }
    let text = read(TEXTMATE).replace("|corridor|", "|");
    assert_ne!(renewed_textmate(&text), text);
}

/// Words are tried in their order.
#[test]
fn a_word_comes_before_its_own_beginnings() {
    let words = due("clauses");
    for (k, word) in words.iter().enumerate() {
        let longer = words[k..].iter().skip(1).find(|other| other.starts_with(word));
        assert_eq!(longer, None, "after `{word}`");
    }
}
