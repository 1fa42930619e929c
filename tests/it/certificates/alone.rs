//! The program `mavc-verify` says what `mavc verify` says.

use crate::cli::mavc;
use std::path::{Path, PathBuf};

/// What `mavc-verify` gives: exit code, standard output, standard error.
fn alone(words: &[&str]) -> (i32, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = mavc_verify::program::run(words.iter().map(ToString::to_string), &mut out, &mut err);
    (i32::from(code), String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

fn compared(words: &[&str]) -> i32 {
    let (code, out, err) = alone(words);
    let whole = mavc(&[&["verify"], words].concat());
    assert_eq!(whole.status.code(), Some(code), "{words:?}: {err}");
    assert_eq!(String::from_utf8(whole.stdout).unwrap(), out, "{words:?}");
    let told = |text: &str| -> Vec<String> { text.split_whitespace().map(String::from).collect() };
    let of_whole = String::from_utf8(whole.stderr).unwrap();
    let of_whole = of_whole.replace("mavc: ", "mavc-verify: ");
    assert_eq!(told(&of_whole), told(&err), "{words:?}");
    code
}

fn files(ending: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/findings");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = paths.filter(|path| path.to_string_lossy().ends_with(ending)).collect();
    paths.sort();
    paths
}

#[test]
fn forgeries_get_the_same_sentences_and_exit_codes() {
    let forged = files(".forged.json");
    assert!(forged.len() > 20, "{forged:?}");
    for certificate in forged {
        let spec = certificate.to_string_lossy().replace(".forged.json", ".mav");
        compared(&[certificate.to_str().unwrap(), &spec]);
    }
}

#[test]
fn honest_certificates_get_the_same_words() {
    let folder = tempfile::tempdir().unwrap();
    let mut codes = Vec::new();
    for spec in ["examples/survey_hexa.mav", "specs/paper/case2.mav", "src/template.mav"] {
        let (spec, certificate) = (Path::new(env!("CARGO_MANIFEST_DIR")).join(spec), folder.path().join("plan.json"));
        let (spec, certificate) = (spec.to_str().unwrap(), certificate.to_str().unwrap());
        let csv = folder.path().join("plan.csv");
        let planned = mavc(&["plan", "-v", spec, "--certificate", certificate, "-o", csv.to_str().unwrap()]);
        assert!(planned.status.success(), "{}", String::from_utf8_lossy(&planned.stderr));
        codes.push(compared(&[certificate, spec]));
        codes.push(compared(&[certificate, spec, "--budget", "0.001s,500MB"]));
        codes.push(compared(&["--set", "gravity=9.7m/s^2", certificate, spec]));
    }
    for code in [0, 8, 5] {
        assert!(codes.contains(&code), "{codes:?}");
    }
}

#[test]
fn wrong_usage_ends_with_two() {
    let spec = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/template.mav");
    let spec = spec.to_str().unwrap();
    for words in [&[][..], &["one"], &["-", "-"], &["--speed", "a", "b"], &["a", spec], &["--budget", "soon", "a", "b"]]
    {
        let (code, out, err) = alone(words);
        assert_eq!((code, out.as_str()), (2, ""), "{words:?}");
        assert!(err.starts_with("mavc-verify: "), "{err}");
    }
    assert_eq!(alone(&["--help"]).0, 0);
    assert!(alone(&["-V"]).1.starts_with("mavc-verify "));
}
