//! The tutorial's commands do what the page says.

use crate::walk::Walk;

#[test]
#[ignore = "long"]
fn the_tutorial_tells_the_truth() {
    let (commands, outputs) = Walk { path: "docs/tutorial.md", spec: "roof.mav", is_run: |_| true }.follow();
    assert!(commands > 10 && outputs > 10, "{commands} {outputs}");
}
