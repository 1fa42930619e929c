//! `mavc explain`: every code, and codes that are not quite right.

use super::{code, err, mavc, out};

#[test]
fn every_code_is_explained() {
    let kinds = out(&mavc(&["explain"]));
    assert!(kinds.lines().count() <= 25 && kinds.lines().all(|line| line.len() <= 80), "{kinds}");
    let counted = kinds.lines().filter_map(|line| line.strip_prefix("  ")?.split_once(' '));
    let counted = counted.map(|(kind, count)| (kind, count.trim().parse::<usize>().unwrap()));
    let mut all = 0;
    for (kind, count) in counted {
        let listed = out(&mavc(&["explain", kind]));
        // A kind with one code is that code's page.
        let codes: Vec<&str> = listed.lines().filter(|line| line.starts_with("mavc::")).collect();
        assert!(codes.len() == count, "{kind} {count}: {listed}");
        assert!(count == 1 || listed.lines().all(|line| line.len() <= 80), "{listed}");
        for code_name in codes {
            let ran = mavc(&["explain", code_name]);
            assert_eq!(code(&ran), 0);
            assert!(out(&ran).len() > code_name.len() + 40, "{code_name}");
        }
        all += count;
    }
    assert_eq!(all, mavc::diagnostic::codes::all().len());
}

#[test]
fn a_part_of_a_code_finds_those_that_have_it() {
    let found = |word: &str| {
        let ran = mavc(&["explain", word]);
        assert_eq!(code(&ran), 0, "{word}");
        out(&ran)
    };
    let missing = found("missing");
    let codes: Vec<&str> = missing.lines().filter(|line| !line.starts_with(' ')).collect();
    assert!(codes.contains(&"mavc::name::missing_field") && codes.contains(&"mavc::unit::missing"), "{missing}");
    assert!(codes.iter().all(|code| code.contains("missing")), "{missing}");
    // One alone is explained.
    for (word, code) in [("Limit-Order", "mavc::mission::limit_order"), ("alike", "mavc::simulate::alike")] {
        assert!(found(word).starts_with(&format!("{code}\n\n")), "{word}");
    }
    let said = |word: &str| {
        let ran = mavc(&["explain", word]);
        assert_eq!(code(&ran), 2, "{word}");
        err(&ran)
    };
    assert_eq!(said("rotr_count"), "mavc: there is no code rotr_count; did you mean mavc::vehicle::rotor_count?\n");
    for nowhere in ["banana", "", "::"] {
        assert!(said(nowhere).ends_with("; `mavc explain` lists all\n"), "{nowhere}");
    }
}

#[test]
fn the_codes_of_one_kind_are_listed() {
    for word in ["sense", "mavc::sense", "Sense::"] {
        let ran = mavc(&["explain", word]);
        assert_eq!(code(&ran), 0, "{}", err(&ran));
        let listed = String::from_utf8(ran.stdout).unwrap();
        let codes: Vec<&str> = listed.lines().filter(|line| !line.starts_with(' ')).collect();
        assert!(codes.len() > 10 && codes.iter().all(|code| code.starts_with("mavc::sense::")), "{listed}");
    }
}

#[test]
fn a_code_written_almost_right_is_found() {
    for (written, meant) in [("unit::mismtach", "mavc::unit::mismatch"), ("mavc::sytax::depth", "mavc::syntax::depth")]
    {
        let ran = mavc(&["explain", written]);
        assert_eq!(code(&ran), 2);
        assert_eq!(err(&ran), format!("mavc: there is no code {written}; did you mean {meant}?\n"));
    }
}
