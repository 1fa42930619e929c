//! The pages of other tools: what mavc prints on the way into the tool. Commands of the tools themselves are run by
//! `benches/readers/run`.

use crate::walk::Walk;

/// Follows a page, in which mavc is run and compared at least so many times.
fn follow(path: &'static str, spec: &'static str, least: (usize, usize)) {
    // What the other lines run is Python, or needs the tool.
    let is_run = |line: &str| line.starts_with("mavc ") || line.starts_with("printf ");
    let (commands, outputs) = Walk { path, spec, is_run }.follow();
    assert!(commands >= least.0 && outputs >= least.1, "{path}: {commands} {outputs}");
}

#[test]
fn the_page_of_px4_tells_the_truth() {
    follow("docs/px4.md", "octo.mav", (5, 3));
}

#[test]
fn the_page_of_ardupilot_tells_the_truth() {
    follow("docs/ardupilot.md", "octo.mav", (6, 3));
}

#[test]
fn the_page_of_ros_2_tells_the_truth() {
    follow("docs/ros2.md", "octo.mav", (2, 1));
}

#[test]
fn the_page_of_crazyflie_tells_the_truth() {
    follow("docs/crazyflie.md", "room.mav", (3, 2));
}
