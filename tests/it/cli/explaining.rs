//! `mavc explain`: every code, and codes that are not quite right.

use super::{code, err, mavc, out};

#[test]
fn every_code_is_explained() {
    let listed = out(&mavc(&["explain"]));
    assert!(listed.lines().count() > 40);
    for line in listed.lines() {
        let (code_name, title) = line.split_once("  ").unwrap();
        let ran = mavc(&["explain", code_name]);
        assert_eq!(code(&ran), 0);
        assert!(out(&ran).len() > code_name.len() + 40, "{code_name}");
        assert!(out(&ran).contains(title.trim()), "{line}");
    }
}

#[test]
fn a_part_of_a_code_finds_those_that_have_it() {
    let said = |word: &str| {
        let ran = mavc(&["explain", word]);
        assert_eq!(code(&ran), 2);
        err(&ran)
    };
    let missing = said("missing");
    let (head, listed) = missing.split_once('\n').unwrap();
    assert_eq!(head, "mavc: there is no code missing; these have it in them:");
    let codes: Vec<&str> = listed.lines().map(|line| line.split("  ").next().unwrap()).collect();
    assert!(codes.contains(&"mavc::name::missing_field") && codes.contains(&"mavc::unit::missing"), "{missing}");
    assert!(codes.iter().all(|code| code.contains("missing")), "{missing}");
    assert_eq!(said("Limit-Order"), "mavc: there is no code Limit-Order; did you mean mavc::mission::limit_order?\n");
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
        assert!(listed.lines().count() > 10 && listed.lines().all(|l| l.starts_with("mavc::sense::")), "{listed}");
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
