//! A forger of certificates: false ones made on purpose, for specs whose truth is known without the checker, and
//! whether `verify` accepts any. With each premise of the checker switched off some forgery has to pass, or it is not
//! needed.
//!
//! `cargo test --test forge` makes a few hundred, `cargo test --release --test forge -- --count 100000 --seed 7` many;
//! `--kind WORDS` only the kinds whose names contain these words. Nothing depends on anything but the seed.

mod arguments;
mod kinds;
#[path = "../it/members.rs"]
mod members;
mod motion;
mod numbers;
mod specs;
mod tally;
mod truth;
#[allow(dead_code)]
#[path = "../it/vehicles.rs"]
mod vehicles;

use arguments::Arguments;
use kinds::{Kind, Known};
use mavc::certificate::{Certificate, Claim};
use mavc::verify::cost::Budget;
use mavc::verify::{self, Accepted, Premise, Premises, Read, Settings};
use numbers::Numbers;
use rayon::prelude::*;
use specs::Spec;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::Instant;
use tally::{Outcome, Result, Tally};

/// The hash that certificates carry here.
const SHA: &str = "0123456789abcdef";

/// Of each thread, bytes.
const STACK: usize = 64 << 20;

/// Tries for one forgery, each on a spec at random: some kinds fit one spec, and that seldom.
const TRIES: usize = 10_000;

fn main() -> ExitCode {
    let arguments = match Arguments::read(std::env::args().skip(1)) {
        Ok(arguments) => arguments,
        Err(why) => {
            eprintln!("{why}");
            return ExitCode::FAILURE;
        }
    };
    if arguments.filtered_out {
        println!("\nrunning 0 tests\n");
        println!("test result: ok. 0 passed; 0 failed; 0 ignored; 0 measured; 1 filtered out");
        return ExitCode::SUCCESS;
    }
    // A thread that waits for the planner begins other specs on the same stack.
    let threads = rayon::ThreadPoolBuilder::new().stack_size(STACK).build_global();
    threads.expect("no threads were used before");
    let begun = Instant::now();
    let specs = specs::all();
    let mut failed = honest(&specs);
    failed.extend(undecided(specs::flat_inverse()));
    failed.extend(unlisted());
    let kinds: Vec<Kind> = kinds::all().into_iter().filter(|k| k.name.contains(&arguments.kind)).collect();
    // Premises are tried often enough to be seen, and not on every one of many.
    let often = (arguments.count / kinds.len().max(1) / 20).clamp(5, 200);
    let results: Vec<(usize, Result)> = (0..arguments.count)
        .into_par_iter()
        .map(|index| {
            let which = index % kinds.len();
            let mut numbers = Numbers::of(arguments.seed, index as u64);
            let tries_premises = index / kinds.len() < often;
            (which, one(&kinds[which], &specs, &mut numbers, tries_premises))
        })
        .collect();
    let whole = arguments.kind.is_empty();
    let mut tally = Tally::of(&kinds, results, whole);
    tally.failed.extend(failed);
    print!("{}", tally.tables());
    let made = tally.made();
    println!(
        "{made} forgeries of {} kinds on {} specs, seed {}, in {:.0} s",
        kinds.len(),
        specs.len(),
        arguments.seed,
        begun.elapsed().as_secs_f64()
    );
    tally.conclude(specs.len())
}

/// Honest certificates are accepted, or nothing that is rejected means anything; what is wrong otherwise.
fn honest(specs: &[Spec]) -> Vec<String> {
    let refused = |spec: &&Spec| {
        let found = verify::decide_at_nodes(&spec.certificate(), spec.model(), Settings::default());
        Some(format!("the honest certificate of {} is refused: {}", spec.name, found.err()?.sentence()))
    };
    let meant: Vec<&Spec> = specs.iter().filter(|spec| !spec.is_void).collect();
    let with_ways = specs.iter().filter_map(|spec| {
        let found = verify::decide(&spec.with_ways(spec.ways.clone()?), spec.model(), Settings::default());
        Some(format!("the honest ways out of {} are refused: {}", spec.name, found.err()?.sentence()))
    });
    meant.par_iter().filter_map(refused).collect::<Vec<_>>().into_iter().chain(with_ways).collect()
}

/// A set that the checker cannot work out is named, whatever the motion; what is wrong otherwise.
fn undecided(draft: specs::Draft) -> Option<String> {
    let spec = Spec::of(draft);
    match verify::decide_at_nodes(&spec.certificate(), spec.model(), Settings::default()) {
        Ok(verdict) if !verdict.undecided.is_empty() => None,
        found => Some(format!("{} should be undecided: {found:?}", spec.name)),
    }
}

/// A premise that is declared and not in the list of all, so that no kind would be missed; what is wrong otherwise.
fn unlisted() -> Option<String> {
    let source = include_str!("../../src/core/proof/verify/premise.rs");
    let body = source.split_once("pub enum Premise {")?.1.split_once("\n}")?.0;
    let declared = body.lines().filter(|line| line.trim_end().ends_with(',') && !line.trim_start().starts_with("//"));
    let (declared, listed) = (declared.count(), Premise::ALL.len());
    (declared != listed).then(|| format!("{declared} premises are declared, and {listed} are in `Premise::ALL`"))
}

/// One forgery of a kind, and what becomes of it.
fn one(kind: &Kind, specs: &[Spec], numbers: &mut Numbers, tries_premises: bool) -> Result {
    let found = (0..TRIES).find_map(|_| {
        let spec = numbers.pick(specs)?;
        Some((spec, kind.forge(spec, numbers)?))
    });
    let Some((spec, forgery)) = found else { return Result::default() };
    let outcome = decided(spec, &forgery, kind.known);
    let premises = if tries_premises { kind.premises } else { &[] };
    let mut result = Result { spec: spec.name, outcome: Some(outcome), without: Vec::new() };
    for &premise in premises {
        match catch_unwind(AssertUnwindSafe(|| passes_without(spec, &forgery, kind.known, premise))) {
            Ok(passed) => result.without.push((premise, passed)),
            Err(_) => result.outcome = Some(Outcome::Panicked),
        }
    }
    result
}

/// As the command decides it.
fn decided(spec: &Spec, forgery: &Certificate, known: Known) -> Outcome {
    let read = Read { certificate: forgery.clone(), hash: Default::default() };
    let found = catch_unwind(AssertUnwindSafe(|| verify::verify(&read, spec.model(), SHA, Settings::default())));
    let Ok(found) = found else { return Outcome::Panicked };
    match found {
        Ok(verdict) if is_named(&verdict, known) => Outcome::Weaker,
        Ok(verdict) => Outcome::Accepted(format!("{}; weaker: {:?}", verdict.headline, verdict.weaker)),
        Err(diagnostic) if diagnostic.code == verify::TOO_COSTLY => Outcome::Refused,
        Err(_) => Outcome::Rejected,
    }
}

/// Whether a verdict names what the certificate does not show.
fn is_named(verdict: &Accepted, known: Known) -> bool {
    matches!(known, Known::Weaker(words) if verdict.weaker.iter().any(|why| why.contains(words)))
}

/// Whether a forgery is accepted by a checker that does not check one premise.
fn passes_without(spec: &Spec, forgery: &Certificate, known: Known, premise: Premise) -> bool {
    let settings = Settings { premises: Premises::without(premise), ..Settings::default() };
    if premise == Premise::Spec {
        // Little of what holds between nodes has to be proved for this.
        let settings = Settings { budget: Budget { seconds: 0.3, ..Budget::default() }, ..settings };
        let read = Read { certificate: forgery.clone(), hash: Default::default() };
        return verify::verify(&read, spec.model(), SHA, settings).is_ok();
    }
    let found = match &forgery.claim {
        Claim::Plan(claim) if claim.recovery.is_some() => verify::decide(forgery, spec.model(), settings),
        _ => verify::decide_at_nodes(forgery, spec.model(), settings),
    };
    found.is_ok_and(|verdict| !is_named(&verdict, known))
}
