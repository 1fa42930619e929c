//! Predictions against flights, and the path, worked out again from the rows.

use super::*;

/// Counts of predictions and of the path again, from the rows and the plans' last violations.
pub(super) fn are_those_of_the_rows(desk: &Desk, record: &Value) {
    desk.run(&["hop.mav", "--times", "3", "--seeds", "2", "-o", "rows.csv", "--quiet"], 0);
    let rows: Vec<Row> = desk.lines("rows.csv")[1..].iter().map(|line| Row::read(line).unwrap()).collect();
    for (p, planner) in ["rip", "rsp", "rcp"].into_iter().enumerate() {
        let mut table = [0_u64; 4];
        for (m, mode) in ["gone", "weak"].into_iter().enumerate() {
            let own: Vec<&Row> = rows.iter().filter(|r| r.planner == planner && r.mode == mode).collect();
            let found = &record["planners"][p]["modes"][m];
            let last = found["last_violation_s"].as_f64();
            for row in &own {
                let predicted = last.is_some_and(|last| row.fault_time.unwrap() < last);
                table[usize::from(!predicted) + 2 * usize::from(!row.is_lost())] += 1;
            }
            let path = &found["flights"]["path"];
            let sum = |of: fn(&mavc::campaign::rows::Path) -> usize| {
                own.iter().filter_map(|r| r.path.as_ref()).map(of).sum::<usize>()
            };
            assert_eq!(path["waypoints_due"], sum(|p| p.due));
            assert_eq!(path["waypoints_missed"], sum(|p| p.missed));
            assert_eq!(path["heading_broken"], sum(|p| usize::from(p.heading_broken)));
            assert_eq!(path["limits_broken"], sum(|p| usize::from(p.limits.any())));
            let mean = own.iter().filter_map(|r| r.max_error_after).sum::<f64>() / own.len() as f64;
            assert!((path["deviation_m"]["mean"].as_f64().unwrap() - mean).abs() < 1e-9);
            assert!(own.iter().all(|r| r.max_error_after.unwrap() <= r.max_error));
        }
        let counted = &record["agreement"][0]["by_flight"][1 + p];
        assert_eq!(counted["planner"], planner);
        let counted = ["hits", "misses", "false_alarms", "correct_negatives"].map(|of| counted[of].as_u64().unwrap());
        assert_eq!(counted, table, "{planner}");
        assert!(table[0] > 0 && table.iter().sum::<u64>() == 12, "{table:?}");
    }
}
