//! Specs changed at random, through what `mavc check` does and in its renderings, and files of other tools, through
//! `mavc import`: none may panic, take more than a minute of processor time, or make the program grow past 500 MB.
//!
//! `cargo test` runs a few hundred of each. `cargo test --release --test mutants -- --count 1000000 --seed 1` is the
//! long run, whose result CONTRIBUTING.md holds; `--write DIR --count 1000` writes the mutants of specs for
//! tests/mutants/commands.py, which sends them through every command.

mod files;
mod mutate;

use mavc::admissible::diagnose::diagnose;
use mavc::diagnostic::{render_human, render_short, to_json_line};
use mavc::read::{elaborate, load};
use mutate::{Numbers, mutant};
use rayon::prelude::*;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

/// What `cargo test` runs.
const FEW: u64 = 400;

/// Limits on one mutant and on the whole process.
const SECONDS: f64 = 60.0;
const MEGABYTES: u64 = 500;

struct Arguments {
    count: u64,
    seed: u64,
    write: Option<PathBuf>,
}

/// `None` where the words are a filter of other tests.
fn arguments() -> Option<Arguments> {
    let mut found = Arguments { count: FEW, seed: 1, write: None };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || words.next().and_then(|n| n.parse().ok()).expect("a whole number after the option");
        match word.as_str() {
            "--count" => found.count = number(),
            "--seed" => found.seed = number(),
            "--write" => found.write = words.next().map(PathBuf::from),
            option if option.starts_with('-') => {}
            filter if "mutants".contains(filter) => {}
            _ => return None,
        }
    }
    Some(found)
}

/// The texts that are changed: every spec of the repository that stands alone or uses shipped vehicles.
fn corpus() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders = ["specs/paper", "specs/missions", "specs/vehicles", "examples"].map(|f| root.join(f)).to_vec();
    folders.push(root.join("tests/specs/findings"));
    let mut found: Vec<(PathBuf, String)> = Vec::new();
    for folder in folders {
        let entries = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
        let specs = entries.map(|e| e.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "mav"));
        found.extend(specs.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())));
    }
    found.sort();
    assert!(found.len() > 15, "only {} specs", found.len());
    found
}

/// What `mavc check` does with a text, in every rendering. Whether it has no errors.
fn check(path: &Path, text: &[u8]) -> bool {
    let folder = path.parent().unwrap_or(Path::new(""));
    let read = |used: &Path| -> io::Result<Vec<u8>> {
        // Nothing outside the repository's specs is read, whatever a mutant names.
        let name = used.file_name().ok_or(io::ErrorKind::NotFound)?;
        let [beside, vehicles] = [folder.join(name), folder.join("../vehicles").join(name)];
        std::fs::read(if beside.is_file() { beside } else { vehicles })
    };
    let (files, mut diagnostics) = load("mutant.mav", text, &read);
    let checked = elaborate(&files, &[]);
    diagnostics.extend(checked.diagnostics);
    if let Some(model) = &checked.value {
        diagnostics.extend(diagnose(model));
        let _ = model.to_string();
    }
    let _ = render_human(&diagnostics, &files.sources, 100, false);
    let _ = render_short(&diagnostics, &files.sources);
    for d in &diagnostics {
        serde_json::from_str::<serde_json::Value>(&to_json_line(d, &files.sources)).expect("a line of JSON");
    }
    checked.value.is_some()
}

/// What is changed, by which words, and what is done with it.
struct Kind {
    name: &'static str,
    corpus: Vec<(PathBuf, String)>,
    words: &'static [&'static str],
    check: fn(&Path, &[u8]) -> bool,
}

impl Kind {
    fn mutant(&self, seed: u64, index: u64) -> (&Path, Vec<u8>) {
        let mut numbers =
            Numbers(seed.wrapping_mul(0x9e37_79b9).wrapping_add(index).wrapping_mul(0xbf58_476d_1ce4_e5b9));
        let (path, text) = &self.corpus[numbers.below(self.corpus.len())];
        (path, mutant(text, &self.corpus, self.words, &mut numbers))
    }

    /// Checks mutants, and says what became of them; the number of failures.
    fn run(&self, count: u64, seed: u64) -> usize {
        let (slowest, good) = (AtomicU64::new(0), AtomicUsize::new(0));
        let failures: Vec<String> = (0..count)
            .into_par_iter()
            .filter_map(|index| {
                let (path, text) = self.mutant(seed, index);
                let before = processor_time();
                let ended = std::panic::catch_unwind(|| (self.check)(path, &text));
                let took = processor_time() - before;
                slowest.fetch_max((took * 1e6) as u64, Ordering::Relaxed);
                match ended {
                    Err(_) => Some(format!("mutant {index} panics")),
                    Ok(_) if took > SECONDS => Some(format!("mutant {index} takes {took:.0} s")),
                    Ok(fine) => {
                        good.fetch_add(usize::from(fine), Ordering::Relaxed);
                        None
                    }
                }
            })
            .collect();
        println!(
            "{count} mutants of {}, seed {seed}: {} without errors, {} failures; the slowest took {:.3} s of processor time",
            self.name,
            good.into_inner(),
            failures.len(),
            slowest.into_inner() as f64 * 1e-6
        );
        failures.iter().take(20).for_each(|failure| println!("{failure}"));
        failures.len()
    }
}

/// Processor time of this thread, s; 0 where the system does not say.
fn processor_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    stat.split_whitespace().next().and_then(|ns| ns.parse::<f64>().ok()).map_or(0.0, |ns| ns * 1e-9)
}

/// The most memory that the process has had, MB.
fn most_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|l| l.split_whitespace().next()?.parse::<u64>().ok()).map_or(0, |kib| kib / 1000)
}

fn main() -> ExitCode {
    let Some(Arguments { count, seed, write }) = arguments() else {
        println!("test result: ok. 0 passed; 0 failed; 0 ignored; 0 measured; 1 filtered out");
        return ExitCode::SUCCESS;
    };
    let specs = Kind { name: "specs", corpus: corpus(), words: &mutate::WORDS, check };
    if let Some(folder) = write {
        std::fs::create_dir_all(&folder).expect("a folder");
        for index in 0..count {
            std::fs::write(folder.join(format!("{index:06}.mav")), specs.mutant(seed, index).1).expect("a file");
        }
        println!("{count} mutants of seed {seed} written to {}", folder.display());
        return ExitCode::SUCCESS;
    }
    let files =
        Kind { name: "files of other tools", corpus: files::corpus(), words: &files::WORDS, check: files::check };
    let failures = specs.run(count, seed) + files.run(count, seed);
    let memory = most_memory();
    println!("memory was at most {memory} MB");
    let passed = failures == 0 && memory <= MEGABYTES;
    println!(
        "\ntest result: {}. {} passed; {} failed; 0 ignored; 0 measured; 0 filtered out",
        if passed { "ok" } else { "FAILED" },
        2 * count - failures as u64,
        failures.max(usize::from(!passed))
    );
    if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
