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
