//! The rows of a core that bound it, in the plane of thrust and torque: the lower envelope of their lines.

use super::Row;
use crate::verify::interval::Interval;

/// Lines closer than this at every thrust, relative to the largest height, count as one.
const SAME: f64 = 1e-9;

/// Rows are collected up to this many, of which those that others imply are then dropped: memory does not grow with
/// their number.
pub(super) const BATCH: usize = 1 << 15;

/// A row as a line `rho <= slope T + height`.
#[derive(Clone, Copy)]
struct Line {
    slope: f64,
    height: f64,
    row: Row,
}

/// The rows found so far, without those that others imply.
pub(super) struct Envelope {
    /// The largest thrust, N.
    thrust: f64,
    lines: Vec<Line>,
    /// The bound on the thrust alone from above, and from below.
    on_thrust: [Option<Row>; 2],
    /// How many lines were left when some were dropped last.
    left: usize,
}

impl Envelope {
    /// An envelope for thrusts of at most `thrust`, N.
    pub fn new(thrust: f64) -> Self {
        Envelope { thrust, lines: Vec::new(), on_thrust: [None; 2], left: 0 }
    }

    pub fn add(&mut self, row: Row) {
        let Some((slope, height)) = row.line() else {
            let bound = &mut self.on_thrust[usize::from(row.thrust.middle() < 0.0)];
            *bound = Some(bound.map_or(row, |other| other.stricter(&row)));
            return;
        };
        self.lines.push(Line { slope, height, row });
        if self.lines.len() >= self.left + BATCH {
            self.lines = irredundant(std::mem::take(&mut self.lines), self.thrust);
            self.left = self.lines.len();
        }
    }

    /// The rows without those that others imply by a margin that rounding cannot close; equal ones become their hull.
    pub fn rows(self) -> Vec<Row> {
        let lines = irredundant(self.lines, self.thrust);
        self.on_thrust.into_iter().flatten().chain(lines.into_iter().map(|line| line.row)).collect()
    }
}

impl Row {
    /// A row that implies two bounds on the thrust alone, over the same width: neither torque counts for more than
    /// rounding.
    fn stricter(&self, other: &Row) -> Row {
        let hull = self.hull(other);
        let least = |end: fn(&Row) -> f64| end(self).min(end(other));
        Row { offset: Interval::new(least(|row| row.offset.low), least(|row| row.offset.high)), ..hull }
    }
}

fn irredundant(mut lines: Vec<Line>, thrust: f64) -> Vec<Line> {
    let height = SAME * lines.iter().map(|line| line.height.abs()).fold(0.0, f64::max);
    // Lines whose slopes differ by no more than this are this close at every thrust.
    let slope = height / thrust;
    let are_parallel = |a: &Line, b: &Line| (a.slope - b.slope).abs() <= slope;
    // By falling slope: the lower envelope from small to large thrusts.
    lines.sort_unstable_by(|a, b| b.slope.total_cmp(&a.slope).then(a.height.total_cmp(&b.height)));
    let mut merged: Vec<Line> = Vec::new();
    for next in lines {
        // Of parallel lines the lowest counts.
        while merged.last().is_some_and(|last| are_parallel(last, &next) && next.height < last.height - height) {
            merged.pop();
        }
        match merged.last_mut().filter(|last| are_parallel(last, &next)) {
            Some(last) if next.height <= last.height + height => last.row = last.row.hull(&next.row),
            Some(_) => {}
            None => merged.push(next),
        }
    }
    let mut envelope: Vec<Line> = Vec::new();
    for next in merged {
        while let [.., a, b] = &envelope[..] {
            // b is above the meeting point of a and the next line.
            let (run, rise) = (a.slope - next.slope, next.height - a.height);
            let share = (a.slope - b.slope) / run;
            match run > slope && a.height + share * rise + height < b.height {
                true => envelope.pop(),
                false => break,
            };
        }
        envelope.push(next);
    }
    envelope
}
