//! The one layout: what it looks like, that it changes no meaning and loses no comment, and the command that writes it.

mod command;

use crate::syntax::{bare, block, parse, tree};
use mavc::diagnostic::Checked;
use mavc::format::format;
use mavc::read::{elaborate, load};
use mavc::source::{FileId, Source};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn checked(text: &str) -> Checked<String> {
    format(FileId(0), &Source::new("t.mav", text))
}

fn formatted(text: &str) -> String {
    let checked = checked(text);
    checked.value.unwrap_or_else(|| panic!("{:#?}\n{text}", checked.diagnostics))
}

/// Every spec under a folder of the repository, in order.
fn specs_in(folder: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let all = walkdir::WalkDir::new(root).sort_by_file_name().into_iter().map(|e| e.unwrap().into_path());
    all.filter(|path| path.extension().is_some_and(|e| e == "mav")).collect()
}

/// What a text holds whatever its layout: its words and marks, and its comments, each with how many bytes of these
/// stand before it and whether it has its line to itself. Separators and commas may come and go. A `///` that describes
/// what follows goes to a line of its own, and a byte order mark goes.
fn substance(text: &str) -> (String, Vec<(usize, String, bool)>) {
    let (mut words, mut comments) = (String::new(), Vec::new());
    for line in text.trim_start_matches('\u{feff}').lines() {
        let (mut rest, mut alone) = (line, true);
        while let Some(c) = rest.chars().next() {
            let length = match c {
                '"' => rest[1..].find('"').unwrap() + 2,
                '/' if rest.starts_with("//") => {
                    let describes = rest.starts_with("///") && !rest.starts_with("////");
                    comments.push((words.len(), rest.trim_end().to_string(), alone || describes));
                    break;
                }
                _ => c.len_utf8(),
            };
            if !c.is_whitespace() && !matches!(c, ';' | ',') {
                words.push_str(&rest[..length]);
                alone = false;
            }
            rest = &rest[length..];
        }
    }
    (words, comments)
}

/// The layout of a text without errors: the same substance and tree, and a layout that stays.
fn faithful(text: &str) -> String {
    let laid_out = formatted(text);
    assert_eq!(substance(&laid_out), substance(text), "\n{text}\n---\n{laid_out}");
    assert_eq!(bare(&parse(&laid_out).value.unwrap()), bare(&parse(text).value.unwrap()), "\n{text}\n---\n{laid_out}");
    assert_eq!(formatted(&laid_out), laid_out, "\n{text}");
    assert!(laid_out.lines().all(|line| line.trim_end() == line), "{laid_out}");
    laid_out
}

#[test]
fn the_layout_is_this() {
    insta::assert_snapshot!(faithful(include_str!("../specs/formatting/untidy.mav")));
}

#[test]
fn shipped_specs_are_laid_out() {
    let paths = [specs_in("specs"), specs_in("examples"), specs_in("src")].concat();
    assert!(paths.len() > 15);
    for path in paths {
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(faithful(&text) == text, "mavc fmt {}", path.display());
    }
}

/// Every complete spec in the README and the pages.
#[test]
fn specs_in_the_documents_are_laid_out() {
    for (name, page) in [
        ("README.md", include_str!("../../README.md")),
        ("language.md", include_str!("../../docs/language.md")),
        ("formatting.md", include_str!("../../docs/formatting.md")),
    ] {
        let specs: Vec<&str> = page.split("```mav\n").skip(1).map(|t| t.split("```").next().unwrap()).collect();
        assert!(!specs.is_empty());
        for spec in specs {
            assert_eq!(faithful(spec), spec, "{name}");
        }
    }
}

#[test]
fn every_valid_spec_keeps_its_tree_and_its_model() {
    let (mut trees, mut models) = (0, 0);
    for path in [specs_in("specs"), specs_in("src"), specs_in("tests/specs")].concat() {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        if parse(&text).has_errors() || parse(&text).value.is_none() {
            continue;
        }
        trees += 1;
        let laid_out = faithful(&text);
        let model = |text: &str| {
            let folder = path.parent().unwrap();
            let (files, _) = load("t.mav", text.as_bytes(), &|used| std::fs::read(folder.join(used)));
            elaborate(&files, &[]).value.map(|model| model.to_string())
        };
        let before = model(&text);
        models += usize::from(before.is_some());
        assert_eq!(model(&laid_out), before, "{}", path.display());
    }
    assert!(trees > 200 && models > 50, "{trees} {models}");
}

#[test]
fn errors_of_syntax_have_no_layout() {
    for path in specs_in("tests/specs/errors/syntax") {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let (own, parsed) = (checked(&text), parse(&text));
        assert_eq!(own.value.is_none(), parsed.value.is_none() || parsed.has_errors(), "{}", path.display());
        assert_eq!(own.diagnostics, parsed.diagnostics);
    }
}

#[test]
fn line_ends_are_those_of_the_first_line() {
    assert_eq!(formatted("a=1\r\n// β\n\r\n\nb  = 2"), "a = 1\r\n// β\r\n\r\nb = 2\r\n");
    assert_eq!(formatted("a=1\n// β\r\nb  = 2\r\n"), "a = 1\n// β\nb = 2\n");
    assert_eq!(formatted("\u{feff}a=1"), "a = 1\n");
    for empty in ["", "\n\n", " \t\r\n"] {
        assert_eq!(formatted(empty), "");
    }
}

#[test]
fn operators_are_tight_unless_a_unit_would_go_on_over_them() {
    for (written, laid_out) in [
        ("2 * a*( 1+cos( s ) )", "2*a*(1 + cos(s))"),
        ("4 m * a * b", "4 m * a * b"),
        ("a * 4 m / b", "a * 4 m / b"),
        ("a * 4 m", "a*4 m"),
        ("[1 , 2]m *2", "[1, 2] m * 2"),
        ("4 m ^2 * b", "4 m ^ 2 * b"),
        ("a ^ - 2 ^ b", "a^-2^b"),
        ("- 2+-3- -4", "-2 +- 3 - -4"),
        ("60%", "60 %"),
        ("0..4 * pi", "0 .. 4*pi"),
        ("5 min/min( a,1 s )", "5 min / min(a, 1 s)"),
        ("(1e-5 1/h)*2", "(1e-5 1/h)*2"),
    ] {
        assert_eq!(faithful(&format!("x={written}")), format!("x = {laid_out}\n"));
    }
}

#[test]
fn long_lines_move_nothing_else() {
    let name = "n".repeat(300_000);
    let text = format!("a = 1 // c\n{name} = 2\nb = 3 // {name}\nbc = \"{name}\" // d\n");
    let column = format!("{:34}", "a = 1");
    assert!(faithful(&text).starts_with(&format!("{column}// c\n{name} = 2\nb  = 3")), "moved");
}

#[test]
fn what_would_grow_past_a_file_is_refused() {
    let text = format!("plan {{\n{}}}\n", "a=1\n".repeat(9000));
    let text = format!("{text}// {}\n", "c".repeat((1 << 20) - text.len() - 10));
    assert!(!parse(&text).has_errors());
    let checked = checked(&text);
    assert!(checked.value.is_none());
    assert_eq!(checked.diagnostics.last().unwrap().code, "mavc::file::too_large");
}

/// A text mangled by choices: other blanks, other line breaks, `;` and comments wherever these may stand.
struct Mangler<'c> {
    choices: &'c [u8],
    at: usize,
    out: String,
    comments: usize,
    /// Also line breaks and comments, on which the layout depends.
    breaks: bool,
}

impl Mangler<'_> {
    fn choose(&mut self, among: u8) -> u8 {
        self.at += 1;
        self.choices[self.at % self.choices.len()].wrapping_mul(31).wrapping_add(self.at as u8) % among
    }

    fn comment(&mut self, mark: &str) {
        self.comments += 1;
        self.out.push_str(&format!("{mark} c{}; {{ [ \" \n", self.comments));
    }

    /// Where blanks may stand; `least` is what has to.
    fn blanks(&mut self, least: &str, in_brackets: bool) {
        match self.choose(if in_brackets && self.breaks { 9 } else { 5 }) {
            0 | 1 => self.out.push_str(least),
            2 => self.out.push(' '),
            3 => self.out.push_str("   "),
            4 => self.out.push_str(" \t"),
            5 => self.out.push_str("\n  "),
            6 => self.out.push_str("\n\n\n"),
            7 => self.comment("//"),
            _ => {
                self.out.push('\n');
                self.comment("///");
            }
        }
    }

    /// Where a statement or a line ends.
    fn end(&mut self, after_word: bool) {
        if after_word && self.choose(3) == 0 {
            self.out.push_str(" ; ;");
        }
        if !self.breaks {
            let end = ["\n", " \n", "\r\n"][self.choose(3) as usize];
            self.out.push_str(end);
            return;
        }
        match self.choose(8) {
            0 if after_word => self.out.push(';'),
            1 => self.comment(" //"),
            2 => self.comment("///"),
            3 => self.out.push_str("\n\n\n \n"),
            _ => self.out.push('\n'),
        }
        if self.choose(6) == 0 && self.out.ends_with('\n') {
            self.comment(["//", "  ///", "////"][self.comments % 3]);
        }
    }

    fn mangle(mut self, text: &str) -> String {
        let mut brackets = 0_usize;
        for line in text.lines() {
            let mut rest = line.trim();
            let mut last = ' ';
            while let Some(c) = rest.chars().next() {
                if rest.starts_with("//") {
                    self.out.push_str(rest);
                    last = '/';
                    break;
                }
                let length = if c == '"' { rest[1..].find('"').unwrap() + 2 } else { c.len_utf8() };
                match c {
                    ' ' | '\t' => {
                        self.blanks(" ", brackets > 0);
                        rest = rest.trim_start();
                        continue;
                    }
                    '(' | '[' => {
                        self.out.push(c);
                        brackets += 1;
                        self.blanks("", true);
                    }
                    ')' | ']' => {
                        self.blanks("", true);
                        brackets -= 1;
                        self.out.push(c);
                    }
                    '{' => {
                        self.blanks("", false);
                        self.out.push(c);
                        if self.breaks && self.choose(4) == 0 {
                            self.end(false);
                        }
                    }
                    '}' => {
                        if self.breaks && self.choose(4) == 0 {
                            self.end(last != '{' && !self.out.ends_with('\n'));
                        }
                        self.out.push(c);
                    }
                    _ => self.out.push_str(&rest[..length]),
                }
                last = c;
                rest = &rest[length..];
            }
            match (brackets, last) {
                (0, '/') => self.out.push('\n'),
                (0, last) => self.end(!matches!(last, '{' | ' ')),
                _ => self.out.push('\n'),
            }
            if brackets == 0 {
                self.blanks("", false);
            }
        }
        self.out
    }
}

fn mangled(text: &str, choices: &[u8], breaks: bool) -> String {
    Mangler { choices, at: 0, out: String::new(), comments: 0, breaks }.mangle(text)
}

const SPECS: [&str; 5] = [
    include_str!("../specs/syntax/everything.mav"),
    include_str!("../../specs/missions/inspection.mav"),
    include_str!("../../specs/paper/case1.mav"),
    include_str!("../../specs/vehicles/coaxial_x8.mav"),
    include_str!("../../src/template.mav"),
];

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn mangled_specs_keep_their_substance(spec in 0..SPECS.len(), choices in prop::collection::vec(any::<u8>(), 7..97)) {
        let text = mangled(SPECS[spec], &choices, true);
        prop_assert!(!parse(&text).has_errors(), "{:#?}\n{}", parse(&text).diagnostics, text);
        faithful(&text);
    }

    #[test]
    fn blanks_and_separators_have_no_say(spec in 0..SPECS.len(), choices in prop::collection::vec(any::<u8>(), 7..97)) {
        let text = mangled(SPECS[spec], &choices, false);
        prop_assert_eq!(formatted(&text).replace("\r\n", "\n"), formatted(SPECS[spec]), "{}", text);
    }

    #[test]
    fn generated_specs_keep_their_substance(
        blocks in prop::collection::vec(block(), 1..4),
        choices in prop::collection::vec(any::<u8>(), 7..97),
    ) {
        let text = blocks.concat();
        // A range inside a range is the one thing that these texts can get wrong.
        prop_assume!(!parse(&text).has_errors());
        faithful(&text);
        // The same from its tree, printed with every blank that may be.
        let laid_out = faithful(&tree(&text).to_string());
        prop_assert_eq!(bare(&tree(&laid_out)), bare(&tree(&text)));
        let text = mangled(&text, &choices, true);
        prop_assert!(!parse(&text).has_errors(), "{:#?}\n{}", parse(&text).diagnostics, text);
        faithful(&text);
    }

    /// Whatever is no spec is refused; whatever is one, however odd, keeps its substance.
    #[test]
    fn odd_texts_are_refused_or_keep_their_substance(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..12)) {
        let text = pieces.concat();
        match checked(&text).value {
            Some(_) => drop(faithful(&text)),
            None => prop_assert!(parse(&text).has_errors()),
        }
    }
}

const PIECES: &[&str] = &[
    "let a",
    "=",
    "=1",
    "[1,2\n]",
    " m",
    "*",
    "^",
    "/",
    "-",
    " ",
    "\t",
    "\n",
    "\r\n",
    ";",
    "{",
    "}",
    "//c\n",
    "///d\n",
    "\"t\"",
    "plan{",
    "plan {}",
    "faults{",
    "mode A{",
    "a=1",
    "b = (1 // c\n)",
    ",",
    "%",
    "+-",
    "..",
    "α",
    "// β",
    "\u{feff}",
    "a",
];
