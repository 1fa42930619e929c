//! What shells, `man` and terminals get.

use super::{code, err, folder, mavc, out, text};
use mavc::diagnostic::{Diagnostic, codes, render_human, render_linked};
use mavc::source::{Source, SourceMap, Span};
use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};

/// The commands that `--help` lists.
fn commands() -> Vec<String> {
    let help = out(&mavc(&["--help"]));
    let list = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.map(|line| line.split_whitespace().next().unwrap().to_string()).filter(|name| name != "help").collect()
}

#[test]
fn completions_know_every_command() {
    assert!(commands().len() > 12);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = mavc(&["completions", shell]);
        assert_eq!((code(&ran), err(&ran).as_str()), (0, ""));
        for command in commands() {
            assert!(out(&ran).contains(&command), "{shell} {command}");
        }
        assert!(out(&ran).contains("explain-defaults"), "{shell}");
        // The others complete no values of arguments without a name. zsh wants colons escaped.
        let codes = out(&ran).replace("\\:", ":").contains("mavc::unit::mismatch");
        assert_eq!(codes, ["bash", "zsh", "fish"].contains(&shell), "{shell}");
    }
    assert_eq!(code(&mavc(&["completions", "cobol"])), 2);
}

/// bash itself completes with it.
#[test]
fn bash_completes_commands_and_options() {
    let dir = folder();
    let script = dir.path().join("mavc.bash");
    std::fs::write(&script, mavc(&["completions", "bash"]).stdout).unwrap();
    let complete = |words: &str, current: &str| {
        let call =
            r#"COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _mavc_words mavc "$1" "${COMP_WORDS[-2]}"; echo ${COMPREPLY[@]}"#;
        let run = format!("source {}; COMP_WORDS=({words} '{current}'); {call}", text(&script));
        let ran = Command::new("bash").args(["--norc", "-c", &run, "bash", current]).output().unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        String::from_utf8(ran.stdout).unwrap().split_whitespace().map(str::to_string).collect::<Vec<_>>()
    };
    assert_eq!(complete("mavc", "che"), ["check"]);
    assert_eq!(complete("mavc fmt", "--ch"), ["--check"]);
    assert_eq!(complete("mavc check --format", "j"), ["json"]);
    assert_eq!(complete("mavc emit", "a"), ["ast", "actuation"]);
    // bash parts a code at its colons; here it is handed over as bash does.
    assert!(complete("mavc explain", "").contains(&"mavc::unit::mismatch".to_string()));
    let coded = |line: &str, words: &str, current: &str| {
        let run = format!(
            "source {}; COMP_LINE='{line}'; COMP_POINT=${{#COMP_LINE}}; COMP_WORDS=({words} '{current}'); \
             COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _mavc_words mavc \"$1\" x; echo ${{COMPREPLY[@]}}",
            text(&script)
        );
        let ran = Command::new("bash").args(["--norc", "-c", &run, "bash", current]).output().unwrap();
        String::from_utf8(ran.stdout).unwrap().trim_end().to_string()
    };
    assert_eq!(coded("mavc explain mavc::unit::mism", "mavc explain mavc :: unit ::", "mism"), "mismatch");
    assert_eq!(coded("mavc explain mavc::analysis::cann", "mavc explain mavc :: analysis ::", "cann"), "cannot_hover");
    // Where no word of mavc is due, bash is left to offer files, or nothing.
    let none: [&str; 0] = [];
    assert_eq!(complete("mavc plan", ""), none);
    assert_eq!(complete("mavc emit ast", ""), none);
}

#[test]
fn every_command_has_a_manual_page() {
    let ran = mavc(&["man"]);
    assert_eq!(code(&ran), 0);
    assert!(out(&ran).contains(".SH \"EXIT STATUS\"") && !out(&ran).contains("EXTRA"), "{}", out(&ran));
    assert!(out(&ran).contains(".TH mavc 1") && out(&ran).contains("Exit codes:"), "{}", out(&ran));
    let dir = folder();
    let ran = mavc(&["man", text(dir.path())]);
    assert_eq!((code(&ran), out(&ran), err(&ran)), (0, String::new(), String::new()));
    let written: BTreeSet<String> =
        std::fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    let pages = commands().iter().map(|command| format!("mavc-{command}.1")).chain(["mavc.1".to_string()]).collect();
    assert_eq!(written, pages);
    let page = std::fs::read_to_string(dir.path().join("mavc-fmt.1")).unwrap();
    assert!(page.contains("mavc fmt") && page.contains("would change"), "{page}");
    // A folder that is missing is made; a file is none.
    let below = dir.path().join("share/man1");
    assert_eq!(code(&mavc(&["man", text(&below)])), 0);
    assert_eq!(std::fs::read_dir(&below).unwrap().count(), written.len());
    let file = mavc(&["man", text(&dir.path().join("mavc.1"))]);
    assert_eq!(code(&file), 2);
    assert!(err(&file).contains("cannot write"), "{}", err(&file));
}

#[test]
fn the_version_is_short_or_tells_of_the_build() {
    let short = format!("mavc {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(out(&mavc(&["-V"])), short);
    let long = out(&mavc(&["--version"]));
    assert!(long.starts_with(&short), "{long}");
    let facts: Vec<&str> = long.lines().skip(1).map(|line| line.split_once("  ").unwrap().0.trim()).collect();
    assert_eq!(facts, ["commit", "target", "profile", "compiler", "features"]);
    assert!(long.contains(std::env::consts::ARCH) && long.contains("rustc 1."), "{long}");
    assert!(long.contains("cli, lsp, report"), "{long}");
}

/// A diagnostic with a code that has a page.
fn diagnostic() -> (Diagnostic, SourceMap) {
    let mut sources = SourceMap::default();
    let file = sources.add(Source::new("t.mav", "let a = 1\n"));
    (Diagnostic::error("mavc::unit::mismatch", Span::new(file, 4, 5), "no").here("here"), sources)
}

#[test]
fn codes_lead_to_their_pages() {
    let (diagnostic, sources) = diagnostic();
    let list = std::slice::from_ref(&diagnostic);
    let linked = render_linked(list, &sources, 100, false, Some("https://example.org/docs"));
    let link = "\u{1b}]8;;https://example.org/docs/diagnostics/model.md#mavcunitmismatch\u{1b}\\";
    assert!(linked.starts_with(&format!("{link}mavc::unit::mismatch")), "{linked:?}");
    // Taken out, what people see is as without it.
    let seen = linked.replace(link, "").replace(" \u{1b}]8;;\u{1b}\\", "");
    assert_eq!(seen, render_human(list, &sources, 100, false));
    assert_eq!(render_linked(list, &sources, 100, false, None), seen);
}

#[test]
fn every_page_is_where_its_link_leads() {
    for page in codes::all() {
        let url = page.url("docs");
        let (file, anchor) = url.split_once('#').unwrap();
        let book = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
        let headings = book.lines().filter_map(|line| line.strip_prefix("## "));
        let anchors: Vec<String> = headings.map(|heading| heading.trim().replace(':', "")).collect();
        assert!(anchors.iter().any(|a| a == anchor), "{url}");
    }
}

/// Even where the environment asks for links, a pipe gets none, in no format.
#[test]
fn pipes_get_no_links() {
    for format in ["human", "short", "json"] {
        let ran = Command::new(env!("CARGO_BIN_EXE_mavc"))
            .args(["check", "tests/specs/errors/unit", "--format", format])
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env("FORCE_HYPERLINK", "1")
            .env("CLICOLOR_FORCE", "1")
            .env("MAVC_DOCS_URL", "https://example.org/docs")
            .stdin(Stdio::null())
            .output()
            .unwrap();
        let told = out(&ran);
        assert!(told.contains("mavc::unit::"), "{told}");
        assert!(!told.contains("\u{1b}]8") && !told.contains("example.org"), "{told:?}");
    }
}
