//! The how-to pages: what mavc prints for the example that they use.

use crate::walk::Walk;

/// Follows a page with the README's example in its folder; mavc is run and compared so many times. Searches for the
/// shortest time are left out, because they take long.
fn follow(path: &'static str, due: (usize, usize)) {
    let is_run = |line: &str| line.starts_with("mavc ") && !line.contains("plan.time=minimum");
    assert_eq!(Walk { path, spec: "roof_octo.mav", is_run }.follow(), due, "{path}");
}

#[test]
fn the_page_on_missing_plans_tells_the_truth() {
    follow("docs/how-to/no-plan.md", (2, 2));
}

#[test]
fn the_page_on_numbers_tells_the_truth() {
    follow("docs/how-to/numbers.md", (2, 1));
}

#[test]
#[ignore = "long"]
fn the_page_on_planners_tells_the_truth() {
    follow("docs/how-to/planner.md", (2, 2));
}

#[test]
#[ignore = "long"]
fn the_page_on_ways_out_tells_the_truth() {
    follow("docs/how-to/recovery.md", (3, 2));
}

#[test]
#[ignore = "long"]
fn the_page_on_reserves_tells_the_truth() {
    follow("docs/how-to/reserve.md", (1, 0));
}

#[test]
#[ignore = "long"]
fn the_page_on_assessments_tells_the_truth() {
    follow("docs/how-to/safety.md", (2, 2));
}
