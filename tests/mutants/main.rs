//! Specs changed at random, through what `mavc check` does and in its renderings, files of other tools, through
//! `mavc import`, and logs of flights, through `mavc diagnose` and `mavc identify`: none may panic, take more than a
//! minute of processor time, or make the program grow past 500 MB.
//!
//! `cargo test` runs a few hundred of each, and fewer logs. `cargo test --release --test mutants -- --count 1000000
//! --seed 1` is the long run, whose result CONTRIBUTING.md holds; `--only logs` runs one kind. `--write DIR --count
//! 1000` writes the mutants of specs for tests/mutants/commands.py, which sends them through every command, and with
//! `--only logs` those of logs.

mod files;
#[path = "../it/logs/flying.rs"]
mod flying;
mod logs;
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

/// What `cargo test` runs: of texts, and of logs, each of which takes longer.
const FEW: u64 = 400;
const FEW_LOGS: u64 = 40;

/// Limits on one mutant and on the whole process.
const SECONDS: f64 = 60.0;
const MEGABYTES: u64 = 500;

struct Arguments {
    count: Option<u64>,
    seed: u64,
    /// The kind that runs; all if `None`.
    only: Option<String>,
    write: Option<PathBuf>,
}

/// `None` where the words are a filter of other tests.
fn arguments() -> Option<Arguments> {
    let mut found = Arguments { count: None, seed: 1, only: None, write: None };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || words.next().and_then(|n| n.parse().ok()).expect("a whole number after the option");
        match word.as_str() {
            "--count" => found.count = Some(number()),
            "--seed" => found.seed = number(),
            "--only" => found.only = words.next(),
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

/// The numbers of a mutant.
fn numbers(seed: u64, index: u64) -> Numbers {
    Numbers(seed.wrapping_mul(0x9e37_79b9).wrapping_add(index).wrapping_mul(0xbf58_476d_1ce4_e5b9))
}

impl Kind {
    fn mutant(&self, seed: u64, index: u64) -> (&Path, Vec<u8>) {
        let mut numbers = numbers(seed, index);
        let (path, text) = &self.corpus[numbers.below(self.corpus.len())];
        (path, mutant(text, &self.corpus, self.words, &mut numbers))
    }

    fn run(&self, count: u64, seed: u64) -> usize {
        run(self.name, count, seed, |index| {
            let (path, text) = self.mutant(seed, index);
            (self.check)(path, &text)
        })
    }
}

/// Checks mutants by their numbers, and says what became of them; the number of failures.
fn run(name: &str, count: u64, seed: u64, check: impl Fn(u64) -> bool + Sync + std::panic::RefUnwindSafe) -> usize {
    let (slowest, good) = (AtomicU64::new(0), AtomicUsize::new(0));
    let failures: Vec<String> = (0..count)
        .into_par_iter()
        .filter_map(|index| {
            let before = processor_time();
            let ended = std::panic::catch_unwind(|| check(index));
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
        "{count} mutants of {name}, seed {seed}: {} without errors, {} failures; the slowest took {:.3} s of processor time",
        good.into_inner(),
        failures.len(),
        slowest.into_inner() as f64 * 1e-6
    );
    failures.iter().take(20).for_each(|failure| println!("{failure}"));
    failures.len()
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

/// Writes mutants for other programs.
fn write(folder: &Path, ending: &str, count: u64, seed: u64, mutant: impl Fn(u64) -> Vec<u8>) -> ExitCode {
    std::fs::create_dir_all(folder).expect("a folder");
    for index in 0..count {
        std::fs::write(folder.join(format!("{index:06}.{ending}")), mutant(index)).expect("a file");
    }
    println!("{count} mutants of seed {seed} written to {}", folder.display());
    ExitCode::SUCCESS
}

fn main() -> ExitCode {
    let Some(Arguments { count, seed, only, write: folder }) = arguments() else {
        println!("test result: ok. 0 passed; 0 failed; 0 ignored; 0 measured; 1 filtered out");
        return ExitCode::SUCCESS;
    };
    let runs = |name: &str| only.as_ref().is_none_or(|only| name.contains(only.as_str()));
    let logs = if runs("logs") { logs::corpus() } else { Vec::new() };
    let log = |index: u64| logs::mutant(&logs, &mut numbers(seed, index));
    let specs = Kind { name: "specs", corpus: corpus(), words: &mutate::WORDS, check };
    if let Some(folder) = folder {
        let count = count.unwrap_or(FEW);
        return match only.as_deref() {
            Some("logs") => write(&folder, "log", count, seed, log),
            _ => write(&folder, "mav", count, seed, |index| specs.mutant(seed, index).1),
        };
    }
    let files =
        Kind { name: "files of other tools", corpus: files::corpus(), words: &files::WORDS, check: files::check };
    let (mut failures, mut all) = (0, 0);
    for kind in [&specs, &files].into_iter().filter(|kind| runs(kind.name)) {
        let count = count.unwrap_or(FEW);
        failures += kind.run(count, seed);
        all += count;
    }
    if runs("logs") {
        let count = count.unwrap_or(FEW_LOGS);
        failures += run("logs", count, seed, |index| logs::check(&log(index), index));
        all += count;
    }
    let memory = most_memory();
    println!("memory was at most {memory} MB");
    let passed = failures == 0 && memory <= MEGABYTES;
    println!(
        "\ntest result: {}. {} passed; {} failed; 0 ignored; 0 measured; 0 filtered out",
        if passed { "ok" } else { "FAILED" },
        all - failures as u64,
        failures.max(usize::from(!passed))
    );
    if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
