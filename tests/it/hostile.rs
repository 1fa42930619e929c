//! Hostile texts: an error with a code, in bounded time and memory, never a panic.

#[cfg(unix)]
mod ending;
mod merging;
#[cfg(unix)]
mod reading;
mod showing;

use mavc::diagnostic::{Diagnostic, render_human, render_short, to_json_line};
use mavc::input::MAX_FILE_BYTES;
use mavc::read::{elaborate, load};
use mavc::source::{FileId, Source, SourceMap};
use mavc::syntax::{MAX_ERRORS, MAX_STATEMENTS, MAX_TOKENS};
use proptest::prelude::*;
use std::io;
use std::path::Path;

/// Parses and renders every way; no diagnostic may point outside the text.
fn parse(text: &str) -> Vec<Diagnostic> {
    let mut sources = SourceMap::default();
    let file = sources.add(Source::new("hostile.mav", text));
    let checked = mavc::syntax::parse(file, sources.get(file));
    assert!(checked.diagnostics.len() <= MAX_ERRORS + 1);
    for d in &checked.diagnostics {
        for span in d.labels.iter().map(|l| l.span).chain([d.span]) {
            assert!(span.start <= span.end && span.end as usize <= text.len(), "{d:?}");
            assert!(text.get(span.start as usize..span.end as usize).is_some(), "{d:?} splits a character");
        }
        let texts = [&d.message, &d.label, d.help.as_ref().unwrap_or(&d.label)];
        assert!(!d.message.is_empty() && texts.iter().all(|t| t.len() < 300), "{}", d.code);
        serde_json::from_str::<serde_json::Value>(&to_json_line(d, &sources)).unwrap();
    }
    assert_eq!(render_short(&checked.diagnostics, &sources).lines().count(), checked.diagnostics.len());
    let human = render_human(&checked.diagnostics, &sources, 100, false);
    assert!(human.len() < 20_000 * (checked.diagnostics.len() + 1), "{} bytes of rendering", human.len());
    assert!(checked.value.is_some() || checked.has_errors());
    if let Some(tree) = checked.value {
        let _ = tree.to_string();
    }
    checked.diagnostics
}

/// The codes a text gives, each once.
fn codes(text: &str) -> Vec<&'static str> {
    let mut codes: Vec<_> = parse(text).iter().map(|d| d.code).collect();
    codes.sort_unstable();
    codes.dedup();
    codes
}

#[test]
fn deep_nesting_is_refused() {
    for (open, close) in [("(", ")"), ("[", "]"), ("f(", ")"), ("{", "}"), ("a {", "}"), ("([", "])")] {
        for depth in [65, 10_000] {
            let whole = format!("let a = {}1{}", open.repeat(depth), close.repeat(depth));
            assert_eq!(codes(&whole), ["mavc::syntax::depth"], "{open} {depth}");
            assert_eq!(codes(&format!("let a = {}", open.repeat(depth))), ["mavc::syntax::depth"], "{open} {depth}");
        }
    }
}

#[test]
fn nesting_up_to_the_limit_is_read() {
    for depth in [1, 22, 64] {
        let text = format!("let a = {}1{}", "(".repeat(depth), ")".repeat(depth));
        assert_eq!(codes(&text), Vec::<&str>::new(), "depth {depth}");
    }
}

#[test]
fn long_chains_are_refused() {
    for link in ["-", "2^", "2^-", "1 + ", "1 - 1 * "] {
        assert_eq!(codes(&format!("let a = {}1", link.repeat(10_000))), ["mavc::syntax::expression"], "{link}");
    }
    // High though no single chain is long.
    let mut text = "1".to_string();
    for _ in 0..60 {
        text = format!("({text}{})", " + 1".repeat(20));
    }
    assert_eq!(codes(&format!("let a = {text}")), ["mavc::syntax::expression"]);
}

#[test]
fn broken_nests_cost_no_more_than_whole_ones() {
    for inner in ["(", "[", "f(", "-(", "1 + (", "[1, "] {
        codes(&format!("let a = {}", inner.repeat(60)));
        codes(&format!("let a = {}1 +", inner.repeat(60)));
        codes(&format!("let a = {}°", inner.repeat(60)));
    }
    for block in ["mission m { ", "mode { ", "{ ", "curve s in 0 .. { ", "every 1 rotor lost as M { "] {
        codes(&block.repeat(60));
        codes(&format!("{}{} junk", block.repeat(60), "}".repeat(60)));
    }
}

#[test]
fn large_files_are_refused_by_size() {
    let garbage: String =
        (0..10_000_000u32).map(|i| char::from(b' ' + (i.wrapping_mul(2654435761) >> 25) as u8 % 95)).collect();
    assert_eq!(codes(&garbage), ["mavc::file::too_large"]);
    assert_eq!(codes(&"x".repeat(MAX_FILE_BYTES + 1)), ["mavc::file::too_large"]);
}

#[test]
#[ignore = "long"]
fn a_megabyte_of_anything_ends() {
    let size = MAX_FILE_BYTES;
    for piece in [
        "x",
        " ",
        "\n",
        "\t",
        ";",
        "(",
        ")",
        "}",
        "{}",
        "{",
        "\"",
        "\"\"",
        "'",
        "''",
        "/*",
        "/* */",
        "#\n",
        "//\n",
        "///\n",
        "1",
        "-",
        "a=1\n",
        "a = [1,\n",
        "a;",
        "}\n",
        "° ",
        "é",
        "aé",
        "\u{4}",
        "\0",
        "\r",
        "\r\n",
        "=",
        ".",
        "..",
        "1 m ",
        "plan {",
        "plan {\n",
        "mission m {\n",
        "\u{feff}",
        "a b ",
        "a(",
        "1/",
        "*/",
        "a{}",
        "use ",
        "a=\"\n",
        "hold 1 s\n",
    ] {
        parse(&piece.repeat(size / piece.len()));
    }
}

#[test]
fn counts_have_limits() {
    assert_eq!(codes(&"a = 1\n".repeat(MAX_STATEMENTS)), Vec::<&str>::new());
    assert_eq!(codes(&"a = 1\n".repeat(MAX_STATEMENTS + 1)), ["mavc::syntax::statements"]);
    assert_eq!(codes(&format!("a = [{}1]", "1,".repeat(MAX_TOKENS / 2))), ["mavc::syntax::tokens"]);
    let many = codes(&"= 1\n".repeat(MAX_ERRORS + 1));
    assert_eq!(many, ["mavc::syntax::too_many", "mavc::syntax::unexpected"]);
}

#[test]
fn numbers_beyond_floats_are_refused() {
    for number in ["1e999".to_string(), "1e-999".to_string(), "9".repeat(400), format!("1e{}", "9".repeat(4000))] {
        assert_eq!(codes(&format!("let a = {number}")), ["mavc::syntax::number"], "{number}");
    }
    assert_eq!(codes("let a = 0e999\nlet b = 0.0e-999\n"), Vec::<&str>::new());
}

#[test]
fn one_error_for_lines_that_end_with_a_carriage_return_alone() {
    assert_eq!(parse(&WHOLE.replace('\n', "\r")).len(), 1);
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    for bytes in [&b"let a = \xff"[..], b"\xe2\x82", b"plan { \xc3( }", b"\xff\xfep\0", b"\xed\xa0\x80"] {
        let error = Source::from_bytes("t.mav", bytes).unwrap_err();
        let mut sources = SourceMap::default();
        let diagnostic = mavc::syntax::not_utf8(sources.add(error.source.clone()), &error);
        assert_eq!(diagnostic.code, "mavc::file::encoding");
        assert_eq!(diagnostic.help.as_ref().unwrap().contains("UTF-16"), bytes.starts_with(b"\xff\xfe"));
        assert!(render_human(&[diagnostic], &sources, 100, false).contains("t.mav"));
    }
}

const WHOLE: &str = include_str!("../specs/syntax/everything.mav");

/// A spec that needs no other file.
const COMPLETE: &str =
    concat!(include_str!("../../specs/vehicles/octo_ppnnppnn.mav"), include_str!("../specs/syntax/complete.mav"));

/// Pieces that change a text's structure when they appear where they should not.
const PIECES: &[&str] = &[
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "\"",
    "\n",
    ";",
    ",",
    "=",
    "==",
    "<=",
    "in",
    "..",
    "-",
    "^",
    "*",
    "/",
    "%",
    "//",
    "///",
    "/*",
    "#",
    "°",
    "µ",
    "–",
    "é",
    "\u{4}",
    "\r",
    "\t",
    " ",
    "1e999",
    "mission m {",
    "plan {",
    "rotor",
    "at",
    "hold",
    ".5",
];

/// Up to eight edits of a text: cut, double, insert.
fn mutated(whole: &'static str) -> impl Strategy<Value = String> {
    let edit = (any::<prop::sample::Index>(), 0..30usize, 0..3u8, prop::sample::select(PIECES));
    prop::collection::vec(edit, 1..8).prop_map(|edits| {
        let mut letters: Vec<char> = whole.chars().collect();
        for (at, length, action, piece) in edits {
            let start = at.index(letters.len());
            let end = (start + length).min(letters.len());
            match action {
                0 => drop(letters.drain(start..end)),
                1 => {
                    let copy = letters[start..end].to_vec();
                    letters.splice(start..start, copy);
                }
                _ => drop(letters.splice(start..start, piece.chars())),
            }
            if letters.is_empty() {
                letters.push('x');
            }
        }
        letters.into_iter().collect()
    })
}

#[test]
fn the_specs_that_are_mutated_are_right() {
    assert_eq!(parse(WHOLE), vec![]);
    let (files, _) = load("t.mav", COMPLETE.as_bytes(), &|_: &Path| unreachable!("it uses no file"));
    let checked = elaborate(&files, &[]);
    assert!(checked.value.is_some(), "{}", render_short(&checked.diagnostics, &files.sources));
}

#[test]
fn blanks_of_unicode_before_a_brace_split_no_character() {
    parse("'{\u{2000}{'");
    parse("\u{3000}{\n}\u{2000}\n\u{a0}{");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_specs_never_panic(text in mutated(WHOLE)) {
        parse(&text);
        let read = |text: &str| mavc::syntax::parse(FileId(0), &Source::new("t.mav", text));
        let checked = read(&text);
        if !checked.has_errors() {
            let printed = checked.value.unwrap().to_string();
            prop_assert!(!read(&printed).has_errors(), "{}", printed);
        }
    }

    #[test]
    fn mutated_specs_elaborate_without_panic(text in mutated(COMPLETE)) {
        let missing = |_: &Path| Err(io::Error::from(io::ErrorKind::NotFound));
        let (files, _) = load("t.mav", text.as_bytes(), &missing);
        let checked = elaborate(&files, &[]);
        for d in &checked.diagnostics {
            prop_assert!(d.span.end as usize <= files.sources.get(d.span.file).text.len(), "{:?}", d);
        }
        render_human(&checked.diagnostics, &files.sources, 100, false);
    }

    #[test]
    fn any_text_never_panics(text in "\\PC{0,200}") {
        parse(&text);
    }
}

/// Sets that are too large for planning take neither time nor memory: the error is reported as soon as the bound is
/// exceeded.
#[test]
fn plans_against_too_many_facets_are_refused() {
    let ring = "PN".repeat(16);
    let spec = format!(
        "vehicle r {{ layout = \"{ring}\"; arm = 1 m; mass = 8 kg; inertia = [0.9, 0.9, 1.6] kg*m^2\n rotor {{ max_thrust = 9 \
         N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }} }}\nfaults {{ every 2 rotors lost as M }}\nmission hop {{ \
         start at [0, 0, 2] m; waypoint at [6, 3, 5] m }}\nplan {{ against = all; time = 12 s }}\n"
    );
    for args in [&["check", "-"][..], &["plan", "-", "-o", "-"], &["emit", "constraints", "-"], &["campaign", "-"]] {
        let ran = crate::cli::mavc_with(args, &spec);
        let told = String::from_utf8([ran.stdout, ran.stderr].concat()).unwrap();
        assert_eq!(ran.status.code(), Some(1), "{told}");
        assert!(told.contains("the 496 fault modes have more than 100000 facets"), "{told}");
    }
}
