//! Several mistakes in one file, all reported in one run, in order, and each once: every file of `tests/specs/several`
//! names at its top the line and the code of every diagnostic that it gives.

use super::errors::{compile, specs};

/// `// 12 mavc::unit::missing`, one for each comment line at the top of the file, after a byte order mark if there is
/// one.
fn expected(text: &str) -> Vec<(usize, &str)> {
    let header = text.trim_start_matches('\u{feff}').lines().map_while(|line| line.strip_prefix("// "));
    let told = header.map_while(|line| line.split_once(' '));
    told.map_while(|(line, code)| Some((line.parse().ok()?, code))).collect()
}

#[test]
fn every_mistake_is_reported_once_and_in_order() {
    let (mut files, mut failures) = (0, Vec::new());
    for path in specs(&["several"]) {
        let bytes = std::fs::read(&path).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let (diagnostics, sources) = compile(&path, &|_, bytes| bytes);
        let found: Vec<(usize, &str)> =
            diagnostics.iter().map(|d| (sources.get(d.span.file).place(d.span.start as usize).line, d.code)).collect();
        let wanted = expected(&text);
        files += 1;
        // One mistake alone is no test of many.
        if found != wanted || wanted.len() < 3 {
            let rendered = mavc::diagnostic::render_human(&diagnostics, &sources, 100, false);
            failures.push(format!("{} names {wanted:#?} and gives {found:#?}\n{rendered}", path.display()));
        }
    }
    assert!(failures.is_empty(), "{} files differ\n{}", failures.len(), failures.join("\n"));
    assert!(files >= 30, "{files} files");
}

/// Words of the language that shipped specs use.
const WORDS: [&str; 36] = [
    "vehicle",
    "mission",
    "planner",
    "rotor",
    "rotors",
    "waypoint",
    "faults",
    "mode",
    "every",
    "lost",
    "reduced",
    "plan",
    "limits",
    "start",
    "hold",
    "within",
    "towards",
    "corridor",
    "vertical",
    "arrive",
    "where",
    "against",
    "ground",
    "drag",
    "propeller_radius",
    "size",
    "rate",
    "mass",
    "inertia",
    "layout",
    "simulate",
    "campaign",
    "samples",
    "reserve",
    "landing_site",
    "battery",
];

/// The most lines of diagnostics for one misspelt word.
const MOST_LINES: usize = 15;

/// Where a word of a spec stands outside comments and texts.
fn place_of(text: &str, word: &str) -> Option<usize> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let is_code = |at: usize| {
        let line = &text[text[..at].rfind('\n').map_or(0, |i| i + 1)..at];
        !line.contains("//") && line.matches('"').count().is_multiple_of(2)
    };
    let is_alone = |at: usize| !text[..at].ends_with(is_name) && !text[at + word.len()..].starts_with(is_name);
    text.match_indices(word).map(|(at, _)| at).find(|&at| is_code(at) && is_alone(at))
}

/// A misspelt keyword of a shipped spec gives a few lines, which name the word that was meant.
#[test]
fn a_misspelt_keyword_takes_few_lines() {
    let mut tried = 0;
    for path in specs(&["../../specs/missions", "../../specs/vehicles", "../../specs/paper", "../../examples"]) {
        let name = path.file_name().unwrap().to_str().unwrap().to_string();
        let text = std::fs::read_to_string(&path).unwrap();
        for word in WORDS {
            let Some(at) = place_of(&text, word) else { continue };
            let short = &word[..word.len() - 1];
            let swapped = format!("{}{}{}{}", &word[..1], &word[2..3], &word[1..2], &word[3..]);
            // Without its last letter `rotors` is another word.
            for wrong in [short, &swapped].into_iter().filter(|wrong| !WORDS.contains(wrong) && *wrong != word) {
                let spoilt = format!("{}{wrong}{}", &text[..at], &text[at + word.len()..]);
                let (found, sources) =
                    compile(&path, &|file, bytes| if file == name { spoilt.clone().into_bytes() } else { bytes });
                let shown = mavc::diagnostic::render_human(&found, &sources, 80, false);
                let is_guessed = ["did you mean `", "write `", "expected `"]
                    .iter()
                    .any(|before| shown.contains(&format!("{before}{word}")));
                assert!(is_guessed, "{name}: {wrong}\n{shown}");
                assert!(shown.trim_end().lines().count() <= MOST_LINES, "{name}: {wrong}\n{shown}");
                tried += 1;
            }
        }
    }
    assert!(tried > 200, "{tried}");
}
