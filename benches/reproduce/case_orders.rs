//! Statements of the paper about its cases, in words or by the order of its numbers, and whether they hold here.

use super::case_plans::{paper_seconds, seconds};
use super::judgement::{STATEMENTS, agrees_if, listed, not_comparable, statement};
use super::markdown::{fixed, printed, table};
use super::paper_plans::{
    CASE_1_RIP, CASE_2_RIP, CASE_2_RSP, Common, Own, TABLE_8, TABLE_9, TABLE_10, TABLE_11, TABLE_12, TABLE_13,
};
use super::plans::{self, JOINTLY, Plans};
use mavc::planner::studies::Run;
use mavc::report::record::errors;

pub fn section(number: usize) -> String {
    let rows = match number {
        1 => first(plans::of_case(1)),
        2 => second(plans::of_case(2), plans::of_case(1)),
        _ => third(plans::of_case(3), plans::of_case(1)),
    };
    format!("### Statements about Case {number}\n\n") + &table(&STATEMENTS, &rows)
}

type Rows = Vec<Vec<String>>;

fn own(table: &'static [Own], planner: &str) -> &'static Own {
    table.iter().find(|row| row.planner == planner).unwrap_or_else(|| panic!("no row for {planner}"))
}

fn common(table: &'static [Common], planner: &str) -> &'static Common {
    table.iter().find(|row| row.planner == planner).unwrap_or_else(|| panic!("no row for {planner}"))
}

/// `5 facets, 9 times at 7 of 201 positions`
fn violations(plans: &Plans, planner: &str, mode: &str) -> String {
    let out = plans.outside(planner, mode);
    let positions = plans.model.plan.samples + 1;
    format!("{} facets, {} times at {} of {positions} positions", out.facets.len(), out.rows, out.positions)
}

fn selected(plans: &Plans) -> usize {
    plans.comparison.selected.len()
}

fn first(plans: &Plans) -> Rows {
    let [rip, rcp, rsp] = ["RIP", "RCP M1", "RSP"].map(|p| plans.errors(p, Run::Common).position);
    let rows_of = |planner: &str| plans.outside(planner, "M1").rows;
    let table_9 = common(&TABLE_9, "RIP").violated;
    let [early, late] = [plans.errors("RIP", Run::Own).position, rip];
    let nearness = match plans.shortest("RSP") == plans.common_time() {
        true => "RSP's error is nearer RCP's; the common time is also the shortest time of RSP",
        false => "RSP's error is nearer RCP's",
    };
    let turned = plans.runs(Run::Own).chain(plans.runs(Run::Common)).filter_map(plans::solved);
    let turned = turned.map(|s| errors(&plans.mission, s).yaw).fold(0.0, f64::max);
    let paper_turned = TABLE_8.iter().map(|r| r.yaw[0]).chain(TABLE_9.iter().filter_map(|r| Some(r.errors?[1])));
    let paper_turned = paper_turned.fold(0.0, f64::max);
    vec![
        statement(
            format!(
                "RIP is faster than RCP: {} against {}",
                paper_seconds(own(&TABLE_8, "RIP").time),
                paper_seconds(own(&TABLE_8, "RCP M1").time)
            ),
            format!("{} against {}", seconds(plans.shortest("RIP")), seconds(plans.shortest("RCP M1"))),
            agrees_if(plans.shortest("RIP") < plans.shortest("RCP M1"), "RCP is as fast"),
        ),
        statement(
            "RCP never violates its own set",
            violations(plans, "RCP M1", "M1"),
            agrees_if(rows_of("RCP M1") == 0, "it does"),
        ),
        statement(
            format!(
                "RSP violates fewer than RIP, but not none: {} against {}",
                common(&TABLE_9, "RSP").violated,
                common(&TABLE_9, "RIP").violated
            ),
            format!("{} against {} pairs", rows_of("RSP"), rows_of("RIP")),
            agrees_if(0 < rows_of("RSP") && rows_of("RSP") < rows_of("RIP"), "the order is different"),
        ),
        statement(
            format!(
                "RIP at 20 s violates two inequalities {} times at {} positions by the text, at {table_9} by Table 9",
                CASE_1_RIP.times, CASE_1_RIP.positions
            ),
            format!("at {}: {}", seconds(plans.common_time()), violations(plans, "RIP", "M1")),
            not_comparable(match CASE_1_RIP.positions == table_9 {
                true => "facets are not hull inequalities",
                false => "the paper's two counts exclude each other, and facets are not hull inequalities",
            }),
        ),
        statement(
            "RSP selects two inequalities of 440",
            format!("{} facets of {}", selected(plans), facets_of_mode(plans)),
            not_comparable("inequalities of a triangulated hull, and a curve of unknown size"),
        ),
        statement(
            "at the common time RSP meets the waypoints as well as RIP, and RCP less well: e_R 0.038, 0.038 and \
             0.057 m",
            format!("RIP {}, RSP {}, RCP {} m", fixed(rip, 4), fixed(rsp, 4), fixed(rcp, 4)),
            agrees_if((rsp - rip).abs() < (rsp - rcp).abs(), nearness),
        ),
        statement(
            format!(
                "with more time RIP meets the waypoints better: e_R {} m at 16 s, {} m at 20 s",
                printed(own(&TABLE_8, "RIP").position[0]),
                printed(common(&TABLE_9, "RIP").errors.map_or(f64::NAN, |e| e[0]))
            ),
            format!(
                "{} m at {}, {} m at {}",
                fixed(early, 4),
                seconds(plans.shortest("RIP")),
                fixed(late, 4),
                seconds(plans.common_time())
            ),
            agrees_if(plans.common_time() > plans.shortest("RIP") && late < early, "it does not"),
        ),
        statement(
            format!("no plan of Tables 8 and 9 turns: e_psi is {} rad at most", printed(paper_turned)),
            format!("{} rad at most", fixed(turned, 4)),
            agrees_if(
                turned < 1e-6,
                &format!(
                    "each waypoint allows {} rad here, and the plans use it; the paper names no bound",
                    printed(plans.mission.waypoints[0].yaw_within)
                ),
            ),
        ),
    ]
}

/// Facets of the first mode's set.
fn facets_of_mode(plans: &Plans) -> usize {
    let run = plans.runs(Run::Own).find(|r| r.against.len() == 1).expect("a planner against one mode");
    run.set.rows.len()
}

fn second(plans: &Plans, single: &Plans) -> Rows {
    const MODE: &str = "M1_6";
    let rows_of = |planner: &str| plans.outside(planner, MODE).rows;
    let [rip, rcp, rsp] = ["RIP", "RCP M1_6", "RSP"].map(|p| plans.shortest(p));
    let [e_rip, e_rcp, e_rsp] = ["RIP", "RCP M1_6", "RSP"].map(|p| plans.errors(p, Run::Own).position);
    let paper = |planner: &str| own(&TABLE_10, planner);
    let single_rcp = single.shortest("RCP M1");
    vec![
        statement(
            format!(
                "RIP is faster than RSP: {} against {}",
                paper_seconds(paper("RIP").time),
                paper_seconds(paper("RSP").time)
            ),
            format!("{} against {}", seconds(rip), seconds(rsp)),
            agrees_if(rip < rsp, "RSP is as fast"),
        ),
        statement(
            format!(
                "RSP is faster than RCP: {} against {}",
                paper_seconds(paper("RSP").time),
                paper_seconds(paper("RCP M1_6").time)
            ),
            format!("{} against {}", seconds(rsp), seconds(rcp)),
            agrees_if(
                rsp < rcp,
                &format!(
                    "with the {} facets that RIP violates at {} RSP needs as much time as RCP",
                    selected(plans),
                    seconds(plans.common_time())
                ),
            ),
        ),
        statement(
            format!(
                "two lost rotors cost RCP more time than one: {} for M1_6, {} for M1",
                paper_seconds(paper("RCP M1_6").time),
                paper_seconds(own(&TABLE_8, "RCP M1").time)
            ),
            format!("{} against {}", seconds(rcp), seconds(single_rcp)),
            agrees_if(rcp > single_rcp, "they do not"),
        ),
        statement(
            format!(
                "at its own shortest time RIP meets the waypoints best, then RSP, then RCP: e_R {}, {} and {} m",
                printed(paper("RIP").position[0]),
                printed(paper("RSP").position[0]),
                printed(paper("RCP M1_6").position[0])
            ),
            format!("RIP {}, RSP {}, RCP {} m", fixed(e_rip, 4), fixed(e_rsp, 4), fixed(e_rcp, 4)),
            agrees_if(
                e_rip < e_rsp && e_rsp < e_rcp,
                match e_rip > e_rsp && e_rip > e_rcp {
                    true => "here every plan has the same tolerance at the waypoints, and the fastest one misses most",
                    false => "the order is different",
                },
            ),
        ),
        statement(
            "RCP never violates its own set",
            violations(plans, "RCP M1_6", MODE),
            agrees_if(rows_of("RCP M1_6") == 0, "it does"),
        ),
        statement(
            format!(
                "at the common time RSP violates fewer than RIP: {} against {}",
                common(&TABLE_11, "RSP").violated,
                common(&TABLE_11, "RIP").violated
            ),
            format!("{} against {} pairs", rows_of("RSP"), rows_of("RIP")),
            agrees_if(rows_of("RSP") < rows_of("RIP"), "it does not"),
        ),
        statement(
            "at the common time RSP still violates some",
            format!("{} pairs", rows_of("RSP")),
            agrees_if(
                rows_of("RSP") > 0,
                &format!(
                    "the plan that keeps the {} selected facets keeps all others of the set as well",
                    selected(plans)
                ),
            ),
        ),
        statement(
            format!(
                "RIP violates inequalities {} times at {} positions, RSP {} times at {}",
                CASE_2_RIP.times, CASE_2_RIP.positions, CASE_2_RSP.times, CASE_2_RSP.positions
            ),
            format!("RIP: {}; RSP: {}", violations(plans, "RIP", MODE), violations(plans, "RSP", MODE)),
            not_comparable("inequalities of a triangulated hull, a curve of unknown size and another time"),
        ),
    ]
}

/// `RCP M1`
fn single(mode: &str) -> String {
    format!("RCP {mode}")
}

fn third(plans: &Plans, first: &Plans) -> Rows {
    let modes = &plans.comparison.modes;
    let rip = plans.shortest("RIP");
    let rsp = plans.shortest("RSP");
    let times: Vec<f64> = modes.iter().map(|m| plans.shortest(&single(m))).collect();
    let paper_times: Vec<f64> = modes.iter().map(|m| own(&TABLE_12, &single(m)).time).collect();
    let least = |times: &[f64]| times.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |times: &[f64]| times.iter().copied().fold(0.0, f64::max);
    let slowest: Vec<String> =
        modes.iter().zip(&times).filter(|(_, t)| **t == most(&times)).map(|(m, _)| m.clone()).collect();
    let places = 0..modes.len();
    let same_order = places
        .clone()
        .all(|i| places.clone().all(|k| times[i].total_cmp(&times[k]) == paper_times[i].total_cmp(&paper_times[k])));
    let joint = plans.found(JOINTLY, Run::Own).map(|s| s.time);
    let own_kept = modes.iter().filter(|m| plans.outside(&single(m), m).rows == 0).count();
    vec![
        statement(
            format!(
                "RIP is faster than every RCP: {} against {} and more",
                paper_seconds(own(&TABLE_12, "RIP").time),
                paper_seconds(least(&paper_times))
            ),
            format!("{} against {} and more", seconds(rip), seconds(least(&times))),
            agrees_if(rip < least(&times), "some RCP is as fast"),
        ),
        statement(
            "M4 costs RCP most time (28 s), then M5 and M6 (24 s), the others the same (20 s)",
            modes.iter().zip(&times).map(|(m, t)| format!("{m} {}", seconds(*t))).collect::<Vec<_>>().join(", "),
            agrees_if(
                same_order,
                &format!(
                    "{} costs most; a curve turned by 180 degrees exchanges rotor k with k + 4, and the paper does not \
                     give its orientation",
                    listed(&slowest)
                ),
            ),
        ),
        statement(
            "RCP cannot tolerate all eight single faults at once: the set would be empty",
            match joint {
                Some(time) => format!("planned in {}", seconds(time)),
                None => "no plan".into(),
            },
            agrees_if(joint.is_none(), "the set is not empty, and the mission has a plan in it"),
        ),
        statement(
            format!(
                "RSP plans with all eight, and needs no less time than any RCP against one: {} against {} at most",
                paper_seconds(own(&TABLE_12, "RSP").time),
                paper_seconds(most(&paper_times))
            ),
            format!("{} against {} at most", seconds(rsp), seconds(most(&times))),
            agrees_if(rsp >= most(&times), "it needs less than some"),
        ),
        statement(
            "every RCP keeps its own set",
            format!("{own_kept} of {} do", modes.len()),
            agrees_if(own_kept == modes.len(), "some do not"),
        ),
    ]
    .into_iter()
    .chain(third_violations(plans, first))
    .collect()
}

/// A planner's counts of Table 13, added up.
fn paper_sum(counts: &[usize; 8]) -> usize {
    counts.iter().sum()
}

/// The statements around Table 13 about its counts.
fn third_violations(plans: &Plans, first: &Plans) -> Rows {
    let modes = &plans.comparison.modes;
    let singles: Vec<String> = modes.iter().map(|m| single(m)).collect();
    let in_paper: Vec<&str> = TABLE_13.iter().map(|(p, _)| *p).collect();
    let at_least_one = |mode: &str, of: &[&str]| of.iter().filter(|p| plans.outside(p, mode).rows > 0).count();
    let counts = |planner: &str| TABLE_13.iter().find(|(p, _)| *p == planner).expect("a row of Table 13").1;
    let sums: Vec<(usize, &str)> = TABLE_13.iter().map(|(p, c)| (paper_sum(c), *p)).collect();
    let most_in_paper = sums.iter().max().expect("Table 13 has rows");
    let least_in_paper = sums.iter().filter(|(_, p)| *p != "RSP").map(|(sum, _)| *sum).min().unwrap_or(0);
    let rip = plans.violations("RIP");
    let rsp = plans.violations("RSP");
    let worst_single = singles.iter().map(|p| plans.violations(p)).max().unwrap_or(0);
    let best_single = singles.iter().map(|p| plans.violations(p)).min().unwrap_or(0);
    let most: Vec<String> = singles.iter().filter(|p| plans.violations(p) > rip).cloned().collect();
    let rip_inside: Vec<String> = modes.iter().filter(|m| plans.outside("RIP", m).rows == 0).cloned().collect();
    let others: Vec<&str> = in_paper.iter().copied().filter(|p| *p != "RCP M3").collect();
    let keep_m3: Vec<String> =
        others.iter().filter(|p| plans.outside(p, "M3").rows == 0).map(ToString::to_string).collect();
    let m3 = others.len() - keep_m3.len();
    let [m2_by, m5_by] = ["M2", "M5"].map(|m| at_least_one(m, &in_paper));
    let [early, late] = [first, plans].map(|p| p.outside("RIP", "M1").rows);
    let paper_rip = counts("RIP");
    let same_as_rip = ["RCP M2", "RCP M5"].iter().all(|p| counts(p) == paper_rip);
    let contradiction = not_comparable(match paper_rip[1] == 0 && paper_rip[4] == 0 && !same_as_rip {
        true => "the paper's rows contradict each other",
        false => "a curve of unknown size",
    });
    let rip_inside = match rip_inside.as_slice() {
        [] => "RIP's plan lies in no mode's set".to_string(),
        some => format!("RIP's plan lies in the sets of {}", listed(some)),
    };
    vec![
        statement(
            "the sets of M2 and M5 are violated by no plan of Table 13",
            format!("M2's by {m2_by} and M5's by {m5_by} of the same {} plans", in_paper.len()),
            agrees_if(
                m2_by == 0 && m5_by == 0,
                "the paper gives neither the size of its curve nor its orientation, and T_d here is as short as a plan \
                 in all eight sets allows",
            ),
        ),
        statement(
            "the plan of RIP at 28 s lies in the sets of M2 and M5, which lie in the healthy one; so it is also the plan \
             of RCP M2 and of RCP M5, as (48) has one minimiser; but Table 13 prints other counts for these",
            rip_inside,
            contradiction,
        ),
        statement(
            format!(
                "RSP violates significantly fewer than all others: {} against {} and more over all modes",
                paper_sum(&counts("RSP")),
                least_in_paper
            ),
            format!("{rsp} pairs against {rip} of RIP and {best_single} to {worst_single} of RCP against one mode"),
            // Significant: less than half of any other.
            agrees_if(2 * rsp < rip.min(best_single), "not by half"),
        ),
        statement(
            format!(
                "RIP violates most; by the sums of Table 13 it is {}: {} against {}",
                most_in_paper.1,
                most_in_paper.0,
                paper_sum(&paper_rip)
            ),
            format!("RIP {rip} pairs; more: {}", listed(&most)),
            agrees_if(most.is_empty(), "staying in the set of one fault moves the plan out of others"),
        ),
        statement(
            "M3's set is violated by every plan but RCP M3's",
            format!("by {m3} of the other {} plans", others.len()),
            agrees_if(m3 == others.len(), &format!("not by {}", listed(&keep_m3))),
        ),
        statement(
            format!(
                "more time does not bring RIP into M1's set: {} violations at 20 s (Table 9), {} at 28 s (Table 13)",
                common(&TABLE_9, "RIP").violated,
                paper_rip[0]
            ),
            format!("{early} pairs at {}, {late} at {}", seconds(first.common_time()), seconds(plans.common_time())),
            agrees_if(late >= early, "it violates fewer with more time"),
        ),
    ]
}
