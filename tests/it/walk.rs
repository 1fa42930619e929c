//! Pages that a reader walks through: their commands do what the page says, in its order, in one folder, one line of
//! shell after another.
//!
//! - ` ```sh `: each line that is to be run here is run. It must end with 0, or with the code in its comment `# exit
//!   code N`.
//! - ` ```diff NAME `: an edit of the spec of this name, or of the page's one spec. The text of the lines with `
//!   ` and `-` must occur in it exactly once.
//! - ` ```text `: the output of the commands of the block before, unless none of them was run. A line `...` stands for
//!   any lines, and ` ...` at the end of a line for any rest of it; everything else is compared letter by letter.
//! - ` ```python NAME `: a file of the reader's, which is written.

use std::path::Path;
use std::process::Command;

/// A page, and what of it is run.
pub struct Walk {
    /// From the root of the repository.
    pub path: &'static str,
    /// The spec that edits without a name are made in. An example of this name is there from the beginning.
    pub spec: &'static str,
    /// Whether a line of shell is run here.
    pub is_run: fn(&str) -> bool,
}

impl Walk {
    /// Follows the page in a new folder; how many commands were run, and how many outputs compared. With
    /// `MAVC_UPDATE=1` quotes that differ are written anew.
    pub fn follow(&self) -> (usize, usize) {
        let before = std::fs::read_to_string(self.path).unwrap();
        let mut page = before.clone();
        let folder = tempfile::tempdir().unwrap();
        let example = Path::new("examples").join(self.spec);
        if example.exists() {
            std::fs::copy(example, folder.path().join(self.spec)).unwrap();
        }
        let mut printed = None;
        let (mut commands, mut outputs) = (0, 0);
        // How far the page was followed, so that of blocks with the same text the right one is written.
        let mut at = 0;
        for (language, text, line) in blocks(&before) {
            let fence = format!("```{language}\n");
            at += page[at..].find(&format!("{fence}{text}")).unwrap() + fence.len();
            let place = format!("{}:{line}", self.path);
            let (kind, name) = language.split_once(' ').unwrap_or((language, self.spec));
            match kind {
                "sh" => {
                    let lines = text.lines().filter(|line| (self.is_run)(line));
                    let shown: Vec<String> = lines.map(|line| ran(folder.path(), line, &place)).collect();
                    commands += shown.len();
                    printed = (!shown.is_empty()).then(|| shown.concat());
                }
                "diff" => {
                    let spec = folder.path().join(name);
                    let old = std::fs::read_to_string(&spec).unwrap();
                    std::fs::write(&spec, edited(&old, text)).unwrap();
                }
                "python" => std::fs::write(folder.path().join(name), text).unwrap(),
                "text" => {
                    let Some(printed) = &printed else { continue };
                    let lines: Vec<&str> = printed.trim_matches('\n').lines().collect();
                    let quoted: Vec<&str> = text.lines().collect();
                    let is_true = matches(&quoted, &lines, &same);
                    if !is_true && is_updating() {
                        page.replace_range(at..at + text.len(), &updated(&quoted, &lines));
                    } else {
                        assert!(is_true, "{place} shows\n{text}\nand mavc prints\n{printed}");
                    }
                    outputs += 1;
                }
                other => panic!("{place}: a block of this page cannot be `{other}`"),
            }
        }
        if page != before {
            std::fs::write(self.path, page).unwrap();
        }
        (commands, outputs)
    }
}

/// What a line of shell prints; it ends with the code that it names.
fn ran(folder: &Path, line: &str, place: &str) -> String {
    let (code, shown) = run(folder, line);
    let due = line.split_once("# exit code ").map_or(0, |(_, code)| code.parse().unwrap());
    assert_eq!(code, Some(due), "{place}: {line}\n{shown}");
    // On a slow machine the command says that it is still at work.
    let kept = shown.lines().filter(|l| !(l.starts_with("mavc: ") && l.contains(" s so far; ")));
    kept.map(|l| format!("{l}\n")).collect()
}

/// The blocks of a page in order: language, text, and the line of the page where the text begins.
fn blocks(page: &str) -> Vec<(&str, &str, usize)> {
    let mut line = 1;
    let pieces = page.split("```").enumerate().filter_map(|(k, piece)| {
        let begun = line;
        line += piece.matches('\n').count();
        let (language, text) = piece.split_once('\n')?;
        (k % 2 == 1).then_some((language, text, begun + 1))
    });
    pieces.collect()
}

/// Runs a line of shell in a folder where `mavc` is the one built here. Exit code, and what a terminal would show.
fn run(folder: &Path, line: &str) -> (Option<i32>, String) {
    let built = Path::new(env!("CARGO_BIN_EXE_mavc")).parent().unwrap();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths([built.to_path_buf()].into_iter().chain(std::env::split_paths(&path))).unwrap();
    let output = Command::new("sh")
        .args(["-c", &format!("exec 2>&1\n{line}")])
        .current_dir(folder)
        .env("PATH", path)
        .env("NO_COLOR", "1")
        .env_remove("COLUMNS")
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

/// A spec with a `diff` block's edit made.
fn edited(spec: &str, diff: &str) -> String {
    let side = |left_out: char| -> String {
        let kept = diff.lines().filter(|line| !line.starts_with(left_out));
        kept.map(|line| format!("{}\n", line.get(1..).unwrap_or_default())).collect()
    };
    let (old, new) = (side('+'), side('-'));
    assert_eq!(spec.matches(&old).count(), 1, "stands once:\n{old}\nin:\n{spec}");
    spec.replace(&old, &new)
}

/// Whether a line of the tutorial stands for a printed one.
fn same(quoted: &str, printed: &str) -> bool {
    match quoted.strip_suffix(" ...") {
        Some(beginning) if !beginning.trim().is_empty() => printed.starts_with(beginning),
        _ => quoted == printed.trim_end(),
    }
}

/// Whether the lines of a page stand for the printed ones: `...` for any lines, another for one that is the `same`.
pub fn matches(quoted: &[&str], printed: &[&str], same: &dyn Fn(&str, &str) -> bool) -> bool {
    match quoted.split_first() {
        None => printed.is_empty(),
        Some((first, rest)) if first.trim() == "..." => (0..=printed.len()).any(|k| matches(rest, &printed[k..], same)),
        Some((first, rest)) => {
            printed.split_first().is_some_and(|(p, more)| same(first, p) && matches(rest, more, same))
        }
    }
}

/// Quotes of a page brought up to date: the lines that stand for printed ones are replaced, `...` stays.
pub fn updated(quoted: &[&str], printed: &[&str]) -> String {
    let parts: Vec<&[&str]> = quoted.split(|line| line.trim() == "...").collect();
    let dots: Vec<&&str> = quoted.iter().filter(|line| line.trim() == "...").collect();
    let mut lines = Vec::new();
    let mut at = 0;
    for (k, part) in parts.iter().enumerate() {
        lines.extend(k.checked_sub(1).map(|k| dots[k].to_string()));
        let end = printed.len().saturating_sub(part.len());
        let (first, length) = match k {
            0 if dots.is_empty() => (0, printed.len()),
            0 => (0, part.len()),
            k if k == dots.len() => (end.max(at), part.len()),
            // The first of the places that have most words in common with the part.
            _ => (
                (at..=end.max(at)).rev().max_by_key(|&first| common_words(part, &printed[first..])).unwrap(),
                part.len(),
            ),
        };
        at = (first + length).min(printed.len());
        for (j, line) in printed[first.min(at)..at].iter().enumerate() {
            let old = part.get(j).and_then(|old| old.strip_suffix(" ...")).filter(|old| !old.trim().is_empty());
            lines.push(
                old.map_or(line.to_string(), |old| format!("{} ...", beginning(line, old.split_whitespace().count()))),
            );
        }
    }
    lines.into_iter().map(|line| line.trim_end().to_string() + "\n").collect()
}

/// Words that lines have in common with those beside them.
fn common_words(a: &[&str], b: &[&str]) -> usize {
    let common =
        |(a, b): (&&str, &&str)| a.split_whitespace().zip(b.split_whitespace()).filter(|(a, b)| a == b).count();
    a.iter().zip(b).map(common).sum()
}

/// A line up to its `count`-th word.
fn beginning(line: &str, count: usize) -> &str {
    let mut ends =
        line.char_indices().filter(|&(i, c)| !c.is_whitespace() && line[i + c.len_utf8()..].starts_with([' ', '\n']));
    ends.nth(count.saturating_sub(1)).map_or(line, |(i, c)| &line[..i + c.len_utf8()])
}

/// Whether pages are to be written with new quotes instead of being compared: `MAVC_UPDATE=1 cargo test`.
pub fn is_updating() -> bool {
    std::env::var_os("MAVC_UPDATE").is_some()
}

#[test]
fn dots_stand_for_what_is_left_out_and_nothing_else_does() {
    let printed = ["a 1.5 s", "", "b", "c"];
    let told = |lines: &[&str]| matches(lines, &printed, &same);
    assert!(told(&["a 1.5 s", "", "b", "c"]));
    assert!(told(&["a 1.5 ...", "...", "c"]));
    assert!(told(&["...", "", "b", "  ...", "c", "..."]));
    assert!(!told(&["a 1.5 s", "", "b"]));
    assert!(!told(&["a 1.6 ...", "", "b", "c"]));
    assert!(!told(&["a 1.5 s", "b", "c"]));
    assert!(!told(&["...", "b"]));
    assert!(!told(&["a 1.5 s", "", "b", "c", "d"]));
}

#[test]
fn quotes_are_brought_up_to_date() {
    let printed = ["plan of 21 s", "", "  a  1 s", "  b  2 s", "done it", "more"];
    let new = |lines: &[&str]| updated(lines, &printed);
    assert_eq!(new(&["plan of 20 s", "", "a"]), printed.join("\n") + "\n");
    assert_eq!(new(&["plan of ...", "...", "  b  3 s", "  ...", "less"]), "plan of ...\n...\n  b  2 s\n  ...\nmore\n");
    assert_eq!(new(&["plan of 20 s", "..."]), "plan of 21 s\n...\n");
}

#[test]
#[should_panic(expected = "stands once")]
fn an_edit_of_what_is_not_there_is_refused() {
    edited("mass = 1.8 kg\n", "-mass = 1.9 kg\n+mass = 2 kg\n");
}
