//! The README is short, and it and the page of the command quote what the commands print.

use crate::cli::{folder, mavc, out, text};
use crate::walk::{is_updating, matches, updated};

const MOST_WORDS: usize = 700;
const ROOF: &str = "examples/roof_octo.mav";

fn read(path: &str) -> String {
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn the_readme_is_short_and_shows_the_example() {
    let readme = read("README.md");
    let words = readme.split_whitespace().count();
    assert!(words <= MOST_WORDS, "{words} words");
    for command in ["plan", "simulate"] {
        assert!(readme.contains(&format!("cargo run --release -- {command} {ROOF}")), "{command}");
    }
    let shown: Vec<&str> = readme.split("```mav\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(shown.len(), 1);
    assert!(read(ROOF).contains(shown[0]), "the README shows the example's text");
}

/// Outputs in the README and in docs/command.md are what the commands print: words alike, numbers to 2 %. A line `...`
/// stands for any lines. A quote is known by its first line, which names the mission.
#[test]
fn the_readme_and_the_page_of_the_command_show_true_outputs() {
    let dir = folder();
    for (path, command, spec, written) in [
        ("README.md", "plan", ROOF, "traj.csv"),
        ("docs/command.md", "plan", "specs/paper/case1.mav", "traj.csv"),
        ("docs/command.md", "simulate", "specs/paper/figure12.mav", "flight.csv"),
    ] {
        let table = dir.path().join(written);
        let ran = mavc(&[command, spec, "-o", text(&table)]);
        let printed = out(&ran).replace(text(&table), written);
        let document = read(path);
        let quoted = document.split("```text\n").skip(1).map(|t| t.split("```").next().unwrap());
        let first = printed.lines().next();
        let quoted: Vec<&str> = quoted.filter(|block| block.lines().next() == first).collect();
        assert_eq!(quoted.len(), 1, "{path}: {first:?}");
        let lines: Vec<&str> = printed.trim_end().lines().collect();
        let quoted: Vec<&str> = quoted[0].lines().collect();
        let is_true = matches(&quoted, &lines, &about_the_same);
        if !is_true && is_updating() {
            let new = document.replacen(&(quoted.join("\n") + "\n"), &updated(&quoted, &lines), 1);
            std::fs::write(path, new).unwrap();
        } else {
            assert!(is_true, "{spec} prints\n{printed}");
        }
    }
}

/// Words alike, numbers to 2 %.
fn about_the_same(quoted: &str, printed: &str) -> bool {
    let words = |line: &str| -> Vec<String> { line.split_whitespace().map(str::to_string).collect() };
    let (quoted, printed) = (words(quoted), words(printed));
    let are_alike = |(a, b): (&String, &String)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(x), Ok(y)) => (x - y).abs() <= 0.02 * x.abs().max(0.5),
        _ => a == b,
    };
    quoted.len() == printed.len() && quoted.iter().zip(&printed).all(are_alike)
}
