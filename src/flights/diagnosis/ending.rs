//! When a vehicle was in the air, and how the flight ended.

use super::record::{Record, median};
use super::samples::Samples;

/// Thrust commands above this share of those of typical flight are those of flight.
const FLYING: f64 = 0.5;
/// A flight lasts at least so long, s.
const SHORTEST: f64 = 2.0;
/// Two parts of a flight with less than this between them are one, s.
const JOINED: f64 = 1.0;
/// A specific force beyond this is an impact, m/s^2.
const IMPACT: f64 = 45.0;
/// Above the ground, m.
const ABOVE: f64 = 0.5;
/// How late heights are logged, s: ten a second, and then filtered.
const LATE: f64 = 0.3;

/// One flight of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// Take-off and end, s; the end is that of the log, a landing or an impact.
    pub from: f64,
    pub to: f64,
    /// How it hit the ground: time (s) and speed downwards just before (m/s); `None` if it landed or the log ends.
    pub impact: Option<(f64, f64)>,
    /// The greatest tilt (rad) and rate of yaw (rad/s).
    pub tilt: f64,
    pub yaw_rate: f64,
}

/// The flights of a record.
pub fn flights(record: &Record, samples: &Samples) -> Vec<Flight> {
    let total = |commands: &[f64]| commands.iter().filter(|u| u.is_finite()).sum::<f64>();
    let mut sums: Vec<f64> = samples.samples.iter().map(|s| total(&s.commands)).filter(|t| *t > 0.05).collect();
    let Some(typical) = median(&mut sums) else { return Vec::new() };
    let ground = record.height.values.first().map_or(0.0, |h| f64::from(h[0]));
    let reach = record.height.values.iter().map(|h| f64::from(h[0]) - ground).fold(0.0, f64::max);
    // The first height is the ground only if the log begins there. Otherwise, without heights, or on a bench, the
    // commands alone decide whether it flies.
    let begins_in_air = samples.samples.first().is_some_and(|first| total(&first.commands) > FLYING * typical);
    let has_height = !begins_in_air && !record.height.is_empty() && reach > 2.0 * ABOVE;
    let flies = |i: usize| {
        let s = &samples.samples[i];
        let height = || record.height.at(s.time, 1.5).is_none_or(|h| h[0] - ground > ABOVE);
        total(&s.commands) > FLYING * typical && (!has_height || height())
    };
    let mut found: Vec<Flight> = Vec::new();
    let mut i = 0;
    while i < samples.samples.len() {
        if !flies(i) {
            i += 1;
            continue;
        }
        let end = (i..samples.samples.len()).find(|j| !flies(*j)).unwrap_or(samples.samples.len());
        let (from, to) = (samples.samples[i].time, samples.samples[end - 1].time);
        match found.last_mut() {
            Some(last) if from - last.to < JOINED => last.to = to,
            _ => found.push(Flight { from, to, impact: None, tilt: 0.0, yaw_rate: 0.0 }),
        }
        i = end;
    }
    found.retain(|flight| flight.to - flight.from >= SHORTEST);
    found.iter_mut().for_each(|flight| end(record, flight, has_height.then_some(ground)));
    found
}

/// Finds the impact that ends a flight, and what happened until then. `ground` is its height, m, if the log shows it.
fn end(record: &Record, flight: &mut Flight, ground: Option<f64>) {
    let after = flight.to + 3.0;
    let late = flight.from + SHORTEST;
    let force = record.force.times.iter().zip(&record.force.values);
    let size = |f: &[f32; 3]| f.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    let hit = force.filter(|(t, _)| **t > late && **t < after).find(|(_, f)| size(f) > IMPACT).map(|(t, _)| *t);
    let descent = |t: f64| {
        let logged = record.climb.within(t - 0.6, t + 0.05).iter().map(|v| -f64::from(v[0])).fold(0.0, f64::max);
        if !record.climb.is_empty() {
            return logged;
        }
        match (record.height.at(t - 0.6, 1.5), record.height.at(t - 0.1, 1.5)) {
            (Some(a), Some(b)) => (a[0] - b[0]) / 0.5,
            _ => 0.0,
        }
    };
    if let Some(time) = hit {
        // It fell until then, whatever its motors did.
        flight.to = time;
        flight.impact = Some((time, descent(time)));
    } else {
        // Fast near the ground is an impact too, even if the accelerometer is slow. A log may also end in a fall.
        let speed = descent(flight.to);
        let height = record.height.at(flight.to, 1.5).zip(ground).map(|([height], ground)| height - ground);
        let is_low = height.is_some_and(|height| height < ABOVE + LATE * speed);
        flight.impact = (speed > 3.0 && is_low).then_some((flight.to, speed));
    }
    let attitude = record.attitude.within(flight.from, flight.to);
    let tilt = |a: &[f32; 6]| (f64::from(a[0]).cos() * f64::from(a[1]).cos()).clamp(-1.0, 1.0).acos();
    flight.tilt = attitude.iter().map(tilt).fold(0.0, f64::max);
    let rates = record.rates.within(flight.from, flight.to);
    flight.yaw_rate = rates.iter().map(|w| f64::from(w[2]).abs()).fold(0.0, f64::max);
}
