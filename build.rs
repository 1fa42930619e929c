//! What `mavc --version` tells of the build. Nothing that is missing stops the build.

use std::env::{var, vars};
use std::path::Path;
use std::process::Command;

/// What mavc is built from; the documentation of the codes is part of it.
const SOURCES: [&str; 6] = ["Cargo.toml", "Cargo.lock", "build.rs", "src", "grammar", "docs/diagnostics"];

fn main() {
    let or_unknown = |text: Option<String>| text.unwrap_or_else(|| "unknown".into());
    let variable = |name: &str| or_unknown(var(name).ok());
    let profile = variable("PROFILE");
    println!("cargo::rerun-if-changed=build.rs");
    // A development build changes with every edit; to follow the commits too would only build more often.
    let commit =
        if profile == "release" { or_unknown(commit()) } else { "not looked up in a development build".into() };
    let compiler = or_unknown(answer(&variable("RUSTC"), &["--version"]));
    let features: Vec<String> = vars()
        .filter_map(|(name, _)| Some(name.strip_prefix("CARGO_FEATURE_")?.to_lowercase().replace('_', "-")))
        .filter(|name| name != "default")
        .collect();
    let features = if features.is_empty() { "none".into() } else { features.join(", ") };
    let facts = [
        ("commit", commit),
        ("target", variable("TARGET")),
        ("profile", format!("{profile}, opt-level {}", variable("OPT_LEVEL"))),
        ("compiler", compiler),
        ("features", features),
    ];
    let lines = facts.map(|(name, fact)| format!("{name:<9} {fact}"));
    let text = format!("{}\n{}", variable("CARGO_PKG_VERSION"), lines.join("\n"));
    let file = Path::new(&variable("OUT_DIR")).join("version.txt");
    std::fs::write(&file, text).expect("the folder for what is built can be written");
}

/// The commit, and whether what is built differs from it: from the checkout, or from a package's record of one.
fn commit() -> Option<String> {
    let root = var("CARGO_MANIFEST_DIR").ok()?;
    let git = |arguments: &[&str]| answer("git", &[&["-C", root.as_str()], arguments].concat());
    let top = git(&["rev-parse", "--show-toplevel"]).and_then(|top| Path::new(&top).canonicalize().ok());
    // A package that is unpacked inside another repository is none of its commits.
    if top.is_none() || top != Path::new(&root).canonicalize().ok() {
        let record = std::fs::read_to_string(Path::new(&root).join(".cargo_vcs_info.json")).ok()?;
        return record.split('"').skip_while(|part| *part != "sha1").nth(2).map(|hash| hash.chars().take(12).collect());
    }
    let log = git(&["rev-parse", "--git-path", "logs/HEAD"])?;
    SOURCES.iter().chain([&log.as_str()]).for_each(|path| println!("cargo::rerun-if-changed={path}"));
    let changes = git(&[&["status", "--porcelain", "--"], &SOURCES[..]].concat())?;
    let hash = git(&["rev-parse", "--short=12", "HEAD"])?;
    Some(if changes.is_empty() { hash } else { format!("{hash}, with changes") })
}

/// What a program prints, trimmed; nothing where it is missing or fails.
fn answer(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_string())
}
