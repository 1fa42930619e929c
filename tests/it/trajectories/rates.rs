//! The table at a fixed rate.

use super::*;

#[test]
fn a_rate_gives_even_rows_to_the_end_and_marks_waypoints_at_the_nearest() {
    let mut model = paper_case(PlannerKind::Rip, &[]);
    model.plan.samples = 60;
    let flight = planned(Problem::of(&model).unwrap(), 19.37);
    // 100 Hz ends on a row, the others do not; at 0.01 Hz there is the start and what is after the end.
    for (rate, count) in [(100.0, 1938), (50.0, 970), (7.3, 143), (0.01, 2)] {
        let cells = table(&render(&flight, &model, Some(rate)));
        assert_eq!((cells.len(), trajectory_csv::count(&flight, Some(rate))), (count, count as u64), "{rate} Hz");
        assert!(cells.iter().enumerate().all(|(k, row)| row[0] == k as f64 / rate), "{rate} Hz");
        let (last, before) = (cells[count - 1][0], cells[count - 2][0]);
        assert!(before < 19.37 - 1e-9 && last >= 19.37 - 1e-9, "{rate} Hz ends at {last} s");
        // After the end the last state is held.
        let end = table(&render(&flight, &model, None)).pop().unwrap();
        let held = |row: &[f64]| row[1..25].iter().zip(&end[1..25]).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(held(&cells[count - 1]), "{:?} {end:?}", cells[count - 1]);
        let marked: Vec<(usize, f64)> =
            cells.iter().map(|row| (row[row.len() - 1] as usize, row[0])).filter(|row| row.0 > 0).collect();
        assert!(marked.windows(2).all(|w| w[0].0 < w[1].0), "{marked:?}");
        for (waypoint, t) in marked.iter().filter(|_| rate > 1.0) {
            let met = flight.times[flight.waypoint_nodes[waypoint - 1]];
            assert!((t - met).abs() <= 0.5 / rate + 1e-9, "waypoint {waypoint} at {met} s is marked at {t} s");
        }
        assert_eq!(marked.len(), if rate > 1.0 { 21 } else { 1 });
    }
    // Without a rate waypoints lie on nodes.
    let rows = trajectory_csv::rows(&flight, None);
    assert!(rows.iter().zip(&flight.times).all(|(row, t)| row.time == *t));
    let marked: Vec<usize> = (0..rows.len()).filter(|&k| rows[k].waypoint > 0).collect();
    assert_eq!(marked, flight.waypoint_nodes);
}
