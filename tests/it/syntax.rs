//! Text to tree: every construct, and what stands where.

use mavc::diagnostic::Checked;
use mavc::source::{FileId, Source};
use mavc::syntax::ast::*;

fn parse(text: &str) -> Checked<SpecFile> {
    mavc::syntax::parse(FileId(0), &Source::new("t.mav", text))
}

#[test]
fn every_construct_is_read() {
    let checked = parse(include_str!("../specs/syntax/everything.mav"));
    assert_eq!(checked.diagnostics, vec![]);
    println!("{:#?}", checked.value);
}
