//! Changes to a text: of bytes, of words, of lines, and with parts of other texts.

use std::path::PathBuf;

/// Numbers that look random and are the same in every run (splitmix64).
pub struct Numbers(pub u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// What takes the place of a number or a word.
const EXTREMES: [&str; 26] = [
    "0",
    "-0",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "1e400",
    "1e-400",
    "0.1",
    "1e9",
    "1e-9",
    "99999999999999999999",
    "18446744073709551615",
    "NaN",
    "inf",
    "1/0",
    "0/0",
    "1e300*1e300",
    "pi",
    "-2^2",
    "10000",
    "100000",
    "32",
    "(((1)))",
    "[]",
];
/// What takes the place of a word of a spec, beside numbers.
pub const WORDS: [&str; 30] = [
    "m",
    "kg",
    "deg",
    "rad/s",
    "%",
    "N*s^2/rad^2",
    "vehicle",
    "mission",
    "faults",
    "plan",
    "simulate",
    "campaign",
    "every",
    "lost",
    "reduced to",
    "stuck at",
    "against = all",
    "time = minimum",
    "hold 1 s",
    "let",
    "use",
    "curve",
    "waypoint at",
    "limits {",
    "}",
    "{",
    "\"",
    "+-",
    "..",
    "rotor",
];
const ODD: [&str; 12] =
    ["\u{202e}", "\u{1b}[31m", "\0", "\u{feff}", "\r", "°", "µ", "\u{2028}", "é", "\t", "/*", "///"];

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || "._".contains(c)
}

/// The words of a text, as byte ranges.
fn words(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut begin = None;
    for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
        match (is_word(c), begin) {
            (true, None) => begin = Some(at),
            (false, Some(from)) => {
                found.push((from, at));
                begin = None;
            }
            _ => {}
        }
    }
    found
}

fn numbers_of(text: &str) -> Vec<(usize, usize)> {
    let is_number = |&(a, b): &(usize, usize)| text[a..b].starts_with(|c: char| c.is_ascii_digit());
    words(text).into_iter().filter(is_number).collect()
}

/// A text with one to five changes.
pub fn mutant(text: &str, corpus: &[(PathBuf, String)], by: &[&str], numbers: &mut Numbers) -> Vec<u8> {
    let mut text = text.to_string();
    for _ in 0..=numbers.below(5) {
        if text.len() > 20_000 {
            break;
        }
        changed(&mut text, corpus, by, numbers);
    }
    let mut bytes = text.into_bytes();
    // Now and then what is not text at all.
    if numbers.below(20) == 0 && !bytes.is_empty() {
        let at = numbers.below(bytes.len());
        bytes[at] = numbers.below(256) as u8;
    }
    bytes
}

fn changed(text: &mut String, corpus: &[(PathBuf, String)], by: &[&str], numbers: &mut Numbers) {
    match numbers.below(10) {
        0..=2 => replace(text, numbers_of, &EXTREMES, numbers),
        3 => replace(text, words, by, numbers),
        4 => replace(text, words, &EXTREMES, numbers),
        5 => {
            let at = boundary(text, numbers);
            text.insert_str(at, ODD[numbers.below(ODD.len())]);
        }
        6 => scaled(text, numbers),
        7 | 8 => lines(text, corpus, numbers),
        _ => {
            let (a, b) = (boundary(text, numbers), boundary(text, numbers));
            let (a, b) = (a.min(b), a.max(b));
            match numbers.below(3) {
                0 => text.replace_range(a..b, ""),
                1 => text.truncate(b),
                _ => {
                    let part = text[a..b].chars().take(400).collect::<String>();
                    text.insert_str(a, &part);
                }
            }
        }
    }
}

fn boundary(text: &str, numbers: &mut Numbers) -> usize {
    let at = numbers.below(text.len() + 1);
    (0..=at).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

fn replace(text: &mut String, places: fn(&str) -> Vec<(usize, usize)>, by: &[&str], numbers: &mut Numbers) {
    let places = places(text);
    if let Some(&(a, b)) = places.get(numbers.below(places.len())) {
        text.replace_range(a..b, by[numbers.below(by.len())]);
    }
}

/// A number times a power of ten.
fn scaled(text: &mut String, numbers: &mut Numbers) {
    let places = numbers_of(text);
    let Some(&(a, b)) = places.get(numbers.below(places.len())) else { return };
    if let Ok(value) = text[a..b].parse::<f64>() {
        let power = numbers.below(25) as i32 - 12;
        text.replace_range(a..b, &format!("{}", value * 10f64.powi(power)));
    }
}

/// A line left out, twice, elsewhere, or some of another text.
fn lines(text: &mut String, corpus: &[(PathBuf, String)], numbers: &mut Numbers) {
    let mut all: Vec<&str> = text.lines().collect();
    if all.is_empty() {
        return;
    }
    let (from, to) = (numbers.below(all.len()), numbers.below(all.len()));
    match numbers.below(4) {
        0 => {
            all.remove(from);
        }
        1 => all.insert(to, all[from]),
        2 => all.swap(from, to),
        _ => {
            let other: Vec<&str> = corpus[numbers.below(corpus.len())].1.lines().collect();
            let begin = numbers.below(other.len());
            let end = (begin + 1 + numbers.below(8)).min(other.len());
            all.splice(to..to, other[begin..end].iter().copied());
        }
    }
    *text = all.join("\n") + "\n";
}
