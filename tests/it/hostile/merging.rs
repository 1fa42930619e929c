//! Rows of campaigns that were changed, by chance or by somebody, and what only looks like rows.

use mavc::campaign::cases::MAX_FLIGHTS;
use mavc::campaign::merge::{MergeError, merge};
use mavc::campaign::rows::{Row, header};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};
use std::io::{BufReader, Read};

/// A row with a checksum that fits, whatever the cells say.
fn signed(cells: &str) -> String {
    let sum: String = Sha256::digest(cells.as_bytes()).iter().take(4).map(|b| format!("{b:02x}")).collect();
    format!("{cells},{sum}\n")
}

fn cells(cases: &str, case: usize) -> String {
    let planner = ["rip", "rsp", "rcp"][case % 3];
    format!(
        "00ff00ff00ff00ff,{cases},{case},{planner},M{case},0.25,{case},lost,position,1.398,0.{case}1,2.5,1e-7,2.25,0.125,1.6,0.5,0.75,0.7,3,true,4,1,none,0.01,,2,1"
    )
}

fn rows(cases: usize) -> String {
    header() + "\n" + &(0..cases).map(|case| signed(&cells(&cases.to_string(), case))).collect::<String>()
}

fn merged(text: &[u8]) -> Result<Vec<u8>, MergeError> {
    let mut out = Vec::new();
    merge(vec![("rows.csv".to_string(), BufReader::new(text))], &mut out).map(|_| out)
}

#[test]
fn no_random_corruption_passes() {
    const SEED: u64 = 16;
    let whole = rows(40).into_bytes();
    assert_eq!(merged(&whole).unwrap(), whole);
    let mut random = Pcg64Mcg::seed_from_u64(SEED);
    let mut below = |n: usize| (random.next_u64() % n as u64) as usize;
    let first = header().len() + 1;
    for trial in 0..5_000 {
        let mut text = whole.clone();
        let at = first + below(text.len() - first);
        match below(5) {
            0 => text[at] = b"0123456789+-.,abcdefrsp"[below(23)],
            1 => drop(text.remove(at)),
            2 => text.insert(at, b"0123456789+-.,e"[below(15)]),
            3 => {
                let other = first + below(text.len() - first);
                text.swap(at, other);
            }
            _ => text[at] ^= 1 << below(8),
        }
        if text != whole {
            assert!(merged(&text).is_err(), "trial {trial} with seed {SEED}: {}", String::from_utf8_lossy(&text));
        }
    }
}

#[test]
fn numbers_in_another_spelling_are_refused_though_the_checksum_fits() {
    let good = cells("40", 3);
    assert!(Row::read(signed(&good).trim_end()).is_ok());
    for (from, to) in [(",3,", ",+3,"), (",3,", ",03,"), ("0.25", "2.5e-1"), ("2.5,", "2.50,"), ("1.6", "+1.6")] {
        let line = signed(&good.replacen(from, to, 1));
        assert!(Row::read(line.trim_end()).is_err(), "{line}");
    }
    assert!(header().ends_with(",checksum"));
}

#[test]
fn absurd_numbers_of_cases_end_at_once() {
    for cases in [u64::MAX as usize, usize::MAX - 1, MAX_FLIGHTS + 1] {
        let text = header() + "\n" + &signed(&cells(&cases.to_string(), 0));
        let Err(MergeError::Content(what)) = merged(text.as_bytes()) else { panic!("{cases} cases are taken") };
        assert!(what.contains("a campaign has at most 100000000"), "{what}");
    }
    let text = header() + "\n" + &signed(&cells(&MAX_FLIGHTS.to_string(), 2));
    let Err(MergeError::Content(what)) = merged(text.as_bytes()) else { panic!("most are missing") };
    assert_eq!(what, "99999999 of 100000000 cases are missing, cases 0, 1, 3, 4, 5 and 99999994 more");
}

#[test]
fn lines_without_an_end_are_not_read_on() {
    struct Endless(u64);
    impl Read for Endless {
        fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
            self.0 += into.len() as u64;
            assert!(self.0 < 1 << 20, "it reads on");
            into.fill(b'x');
            Ok(into.len())
        }
    }
    let sources = vec![("endless".to_string(), BufReader::new(Endless(0)))];
    assert!(matches!(merge(sources, &mut Vec::new()), Err(MergeError::Read(..))));
}
