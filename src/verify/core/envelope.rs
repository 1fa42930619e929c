//! The rows of a core that bound it, in the plane of thrust and torque: the lower envelope of their lines.

use super::Row;

/// Lines closer than this, relative to their size, count as one.
const SAME: f64 = 1e-9;

/// The rows without those that others imply by a margin that rounding cannot close; equal ones become their hull.
pub(super) fn irredundant(rows: Vec<Row>) -> Vec<Row> {
    let (lines, mut kept): (Vec<Row>, Vec<Row>) = rows.into_iter().partition(|row| row.line().is_some());
    let mut lines: Vec<((f64, f64), Row)> = lines.into_iter().filter_map(|row| Some((row.line()?, row))).collect();
    let size = |of: fn(&(f64, f64)) -> f64| lines.iter().map(|(line, _)| of(line).abs()).fold(0.0, f64::max);
    let (slope, height) = (SAME * size(|l| l.0), SAME * size(|l| l.1));
    // By falling slope: the lower envelope from small to large thrusts.
    lines.sort_by(|(a, _), (b, _)| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
    let mut merged: Vec<((f64, f64), Row)> = Vec::new();
    for (line, row) in lines {
        let parallel = merged.iter_mut().rev().take_while(|(other, _)| (other.0 - line.0).abs() <= slope);
        match { parallel }.find(|(other, _)| (other.1 - line.1).abs() <= height) {
            Some((_, same)) => *same = same.hull(&row),
            None => merged.push((line, row)),
        }
    }
    let mut envelope: Vec<((f64, f64), Row)> = Vec::new();
    for next in merged {
        // Of parallel lines the lowest comes first.
        if envelope.last().is_some_and(|(last, _)| (last.0 - next.0.0).abs() <= slope && next.0.1 > last.1 + height) {
            continue;
        }
        while let [.., (a, _), (b, _)] = &envelope[..] {
            // b is above the meeting point of a and the next line.
            let (run, rise) = (a.0 - next.0.0, next.0.1 - a.1);
            let share = (a.0 - b.0) / run;
            match run > slope && a.1 + share * rise + height < b.1 {
                true => envelope.pop(),
                false => break,
            };
        }
        envelope.push(next);
    }
    kept.extend(envelope.into_iter().map(|(_, row)| row));
    kept
}
