//! Choices that the paper does not print about its plans, and those of the cases in `specs/paper`.

use super::markdown::{fixed, paragraph, printed, table};
use super::paper_plans::{WAYPOINTS, own_times};
use super::plans::{self, Plans};
use mavc::admissible::row::VIOLATED;
use mavc::model::Waypoint;
use mavc::motion::checks::linear_range;
use mavc::number::{number, percent};
use mavc::planner::studies::Run;
use mavc::planner::timing::search::RESOLUTION;

pub fn section() -> String {
    let cases = [1, 2, 3].map(plans::of_case);
    let header = ["what", "the paper", "specs/paper/case1.mav to case3.mav"];
    [introduction(), table(&header, &rows(&cases)), marks(), linear(&cases)].concat()
}

fn introduction() -> String {
    paragraph(
        "Tables 8 to 13 depend on choices that the paper does not print, so their digits cannot be compared. Orders \
         can be compared: which planner is faster than which, and which violations vanish.",
    )
}

fn marks() -> String {
    paragraph(&format!(
        "A facet counts as violated if the wrench exceeds it by more than {} of the healthy set's width along its \
         normal. *Positions* are nodes with a violated facet, *pairs* are violated facets counted at every node, \
         *worst* is the largest violation as a share of that width, *outside* is the time spent outside and *last* \
         the last violation. The paper counts the inequalities of a hull where mavc counts the facets of a minimal \
         description. The counts cannot be compared, but zero means the same in both.",
        percent(VIOLATED)
    ))
}

/// How far the plans at their own shortest times tilt beyond the linear model.
fn linear(cases: &[&Plans]) -> String {
    let tilts = cases.iter().flat_map(|c| {
        let plans = c.runs(Run::Own).filter_map(plans::solved);
        plans.map(|s| linear_range(&s.trajectory, &c.model).tilt.value.to_degrees())
    });
    let (least, most) = tilts.fold((f64::INFINITY, 0.0_f64), |(low, high), t| (low.min(t), high.max(t)));
    paragraph(&format!(
        "The paper and mavc plan with a model that is linear about hover. The cases have no tilt limit, and at their \
         own shortest times the plans here tilt to between {} and {} degrees, far beyond small angles. The paper \
         prints no tilt.",
        fixed(least, 0),
        fixed(most, 0)
    ))
}

/// One value that all cases share.
fn shared<T: PartialEq + Clone>(cases: &[&Plans], of: impl Fn(&Plans) -> T) -> T {
    let first = of(cases[0]);
    assert!(cases.iter().all(|c| of(c) == first), "the cases are set up alike");
    first
}

/// Do all plans take the same time from each waypoint to the next?
fn even_times(cases: &[&Plans]) -> bool {
    cases.iter().flat_map(|c| &c.comparison.runs).filter_map(plans::solved).all(|s| {
        let times: Vec<f64> = s.trajectory.waypoint_nodes.iter().map(|&n| s.trajectory.times[n]).collect();
        let leg = s.time / (times.len() - 1) as f64;
        times.windows(2).all(|pair| (pair[1] - pair[0] - leg).abs() < 1e-9)
    })
}

fn rows(cases: &[&Plans]) -> Vec<Vec<String>> {
    let row = |what: &str, paper: String, here: String| vec![what.into(), paper, here];
    let waypoints = shared(cases, |c| c.mission.waypoints.iter().map(|w| w.position).collect::<Vec<_>>());
    let middle = waypoints[0][0] / 2.0;
    let altitude = waypoints[0][2];
    assert!(
        waypoints.iter().enumerate().all(|(i, p)| {
            let s = 4.0 * std::f64::consts::PI * i as f64 / (waypoints.len() - 1) as f64;
            let curve = [middle * (1.0 + s.cos()), middle * s.sin(), altitude + 2.0 * middle * (0.5 * s).sin()];
            (0..3).all(|k| (p[k] - curve[k]).abs() < 1e-9)
        }),
        "the curve is as described below"
    );
    let [within, yaw_within, weight] = shared(cases, |c| {
        let manner = |w: &Waypoint| [w.within, w.yaw_within, w.weight];
        let first = manner(&c.mission.waypoints[0]);
        assert!(c.mission.waypoints.iter().all(|w| manner(w) == first), "the waypoints are treated alike");
        first
    });
    let limits = shared(cases, |c| c.mission.limits.len());
    let samples = shared(cases, |c| c.model.plan.samples);
    let times: Vec<String> = cases.iter().map(|c| format!("{} s", number(c.common_time()))).collect();
    let even = own_times().all(|t| t % 2.0 == 0.0);
    vec![
        row(
            "layout",
            "not named in section 5.4; section 2.4 flies the curve with PPNNPPNN".into(),
            shared(cases, |c| c.model.vehicle.layout.clone()).unwrap_or_default(),
        ),
        row(
            "curve",
            "Viviani's; neither size nor orientation is given".into(),
            format!(
                "x = a (1 + cos s), y = a sin s, z = {} m + 2 a sin(s/2), a = {} m, s from 0 to 4 pi",
                number(altitude),
                number(middle)
            ),
        ),
        row(
            "waypoints",
            format!("{WAYPOINTS}, uniformly along the curve"),
            format!("{}, evenly spaced in s{}", waypoints.len(), if even_times(cases) { " and in time" } else { "" }),
        ),
        row(
            "start and end",
            "not given".into(),
            match shared(cases, |c| (c.mission.start_at_rest, c.mission.end_at_rest)) {
                (true, true) => "at rest".into(),
                (start, end) => format!("start at rest: {start}, end at rest: {end}"),
            },
        ),
        row(
            "positions",
            "210 in Case 1".into(),
            format!("{} nodes, {} intervals from waypoint to waypoint", samples + 1, samples / (waypoints.len() - 1)),
        ),
        row(
            "feasible",
            "\"passing through waypoints\"".into(),
            format!("every waypoint within {} cm and {} rad", number(100.0 * within), number(yaw_within)),
        ),
        row(
            "bounds on q and its derivatives",
            "in (48), without values".into(),
            if limits == 0 { "none".into() } else { format!("{limits} limits") },
        ),
        row(
            "weights of (48)",
            "alpha_i = 1; scaling and sampling of the derivative term are not given".into(),
            format!(
                "alpha_i = {}/m^2; integrals of squared snap and acceleration times {} and {}",
                number(weight),
                number(shared(cases, |c| c.model.plan.snap_weight)),
                number(shared(cases, |c| c.model.plan.acceleration_weight))
            ),
        ),
        row(
            "shortest time",
            format!(
                "found by decreasing the time; the step is not given{}",
                if even { ", and every printed time is an even number of seconds" } else { "" }
            ),
            format!("a time at most {} s shorter is proved infeasible", printed(RESOLUTION)),
        ),
        row(
            "common time T_d",
            "the largest RCP time: 20, 26 and 28 s".into(),
            format!("the shortest time of RCP against all modes at once: {}", times.join(", ")),
        ),
        row("reserve for feedback", "none".into(), percent(shared(cases, |c| c.model.plan.reserve))),
    ]
}
