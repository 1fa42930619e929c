//! When a vehicle was in the air, and how the flight ended.

use super::record::{Record, median};
use super::samples::Samples;
use nalgebra::{DMatrix, DVector};

/// Thrust commands above this share of those of typical flight are those of flight.
const FLYING: f64 = 0.5;
/// Motors work at all above this share of it. A vehicle sinks above this speed, m/s.
const WORKS: f64 = 0.1;
const SINKS: f64 = 1.0;
/// A flight lasts at least so long, s.
const SHORTEST: f64 = 2.0;
/// Two parts of a flight with less than this between them are one, s.
const JOINED: f64 = 1.0;
/// A specific force beyond this is an impact, m/s^2.
const IMPACT: f64 = 45.0;
/// Above the ground, m.
const ABOVE: f64 = 0.5;
/// A touch of the ground slower than this and more upright than this is a landing, m/s and rad (ArduPilot lands at
/// 0.5 m/s, PX4 at 0.7 m/s by default; skids bear more).
const HARD: f64 = 2.5;
const UPRIGHT: f64 = std::f64::consts::FRAC_PI_4;
/// A log that ends so soon after the motors were last seen to work ends in the air, s.
const CUT: f64 = 1.0;
/// Heights from the second, or for a parabola the third, of these times until the first before an instant show its
/// speed, s.
const SPAN: [f64; 3] = [0.02, 0.65, 1.5];
/// Faster turns about the vertical are not flown, rad/s.
const SPIN: f64 = std::f64::consts::PI;
/// How late heights are logged, s: ten a second, and then filtered.
const LATE: f64 = 0.3;

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// It hit the ground: the least and the greatest speed downwards just before, m/s, that its heights show; `None`
    /// without heights.
    Impact(Option<[f64; 2]>),
    /// Its motors went to rest, and it did not hit the ground.
    Landed,
    /// The log ends before.
    Open,
}

/// One flight of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// Take-off and end, s.
    pub from: f64,
    pub to: f64,
    pub end: End,
    /// The greatest tilt by the autopilot's estimate (rad) and rate of yaw (rad/s); `None` where they are not logged.
    pub tilt: Option<f64>,
    pub yaw_rate: Option<f64>,
}

impl Flight {
    /// Whether it hit the ground after a turn about the vertical that no pilot flies.
    pub fn has_crashed_in_a_spin(&self) -> bool {
        matches!(self.end, End::Impact(_)) && self.yaw_rate > Some(SPIN)
    }
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
        // A vehicle that has lost motors falls with few that work.
        let falls = |j: usize| {
            let s = &samples.samples[j];
            let high = record.height.at(s.time, 1.5).is_some_and(|h| h[0] - ground > 2.0 * ABOVE);
            let sinks = || descent(record, s.time).is_some_and(|[least, _]| least > SINKS);
            has_height && high && (total(&s.commands) > WORKS * typical || sinks())
        };
        let end = (i..samples.samples.len()).find(|j| !flies(*j) && !falls(*j)).unwrap_or(samples.samples.len());
        let (from, to) = (samples.samples[i].time, samples.samples[end - 1].time);
        match found.last_mut() {
            Some(last) if from - last.to < JOINED => last.to = to,
            _ => found.push(Flight { from, to, end: End::Landed, tilt: None, yaw_rate: None }),
        }
        i = end;
    }
    found.retain(|flight| flight.to - flight.from >= SHORTEST);
    let last = samples.samples.last().map_or(0.0, |s| s.time);
    for flight in &mut found {
        end(record, flight, has_height.then_some(ground));
        if flight.end == End::Landed && last - flight.to < CUT.max(2.0 * samples.step) {
            flight.end = End::Open;
        }
    }
    found
}

/// Finds the impact that ends a flight, and what happened until then. `ground` is its height, m, if the log shows it.
fn end(record: &Record, flight: &mut Flight, ground: Option<f64>) {
    let after = flight.to + 3.0;
    let late = flight.from + SHORTEST;
    let force = record.force.times.iter().zip(&record.force.values);
    let size = |f: &[f32; 3]| f.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    let hit = force.filter(|(t, _)| **t > late && **t < after).find(|(_, f)| size(f) > IMPACT).map(|(t, _)| *t);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.filter(|x| x.is_finite()).max_by(f64::total_cmp);
    let tilt = |a: &[f32; 6]| (f64::from(a[0]).cos() * f64::from(a[1]).cos()).clamp(-1.0, 1.0).acos();
    let speed = descent(record, hit.unwrap_or(flight.to));
    if let Some(time) = hit {
        let tilted = largest(&mut record.attitude.within(time - 1.0, time).iter().map(tilt));
        let is_touch = speed.is_some_and(|[_, most]| most < HARD) && tilted.is_none_or(|tilt| tilt < UPRIGHT);
        if !is_touch {
            // It fell until then, whatever its motors did.
            flight.to = time;
            flight.end = End::Impact(speed);
        }
    } else if let Some([least, most]) = speed {
        // Fast near the ground is an impact too, even if the accelerometer is slow. A log may also end in a fall.
        let height = record.height.at(flight.to, 1.5).zip(ground).map(|([height], ground)| height - ground);
        if least > 3.0 && height.is_some_and(|height| height < ABOVE + LATE * most) {
            flight.end = End::Impact(speed);
        }
    }
    // Of two neighbours the lower: one damaged sample is no tilt.
    let attitudes = record.attitude.within(flight.from, flight.to);
    flight.tilt = largest(&mut attitudes.windows(2).map(|pair| tilt(&pair[0]).min(tilt(&pair[1]))));
    let rates = record.rates.within(flight.from, flight.to);
    flight.yaw_rate = largest(&mut rates.iter().map(|w| f64::from(w[2]).abs()));
}

/// The least and the greatest speed downwards at a time (s) that heights show, m/s; `None` without heights. A line
/// through the last of them lags in a fall; a parabola goes beyond what slows it down.
fn descent(record: &Record, time: f64) -> Option<[f64; 2]> {
    let heights = if record.pressure_height.is_empty() { &record.height } else { &record.pressure_height };
    let slope = |span: f64, degree: usize| {
        let [a, b] = [time - span, time - SPAN[0]].map(|t| heights.times.partition_point(|x| *x < t));
        let count = b.saturating_sub(a);
        if count < degree + 2 {
            return None;
        }
        let powers = DMatrix::from_fn(count, degree + 1, |row, k| (heights.times[a + row] - time).powi(k as i32));
        let values = DVector::from_fn(count, |row, _| f64::from(heights.values[a + row][0]));
        let found = powers.svd(true, true).solve(&values, 1e-9).ok()?;
        Some(-found[1])
    };
    let [line, parabola] = [slope(SPAN[1], 1), slope(SPAN[2], 2)];
    let both = [line.or(parabola)?, parabola.or(line)?];
    Some([both[0].min(both[1]).max(0.0), both[0].max(both[1]).max(0.0)])
}

#[cfg(test)]
mod tests {
    use super::super::record::Autopilot;
    use super::*;

    /// A flight of 20 s whose motors rest from `rests` on, that descends from 12 s on at a speed (m/s), with a jolt
    /// (m/s^2) when it reaches the ground; the log ends at `ends`.
    fn flown(speed: f64, jolt: f64, rests: f64, ends: f64) -> Flight {
        let mut record = Record::new(Autopilot::Px4);
        record.is_pulses = false;
        let touches = 12.0 + 20.0 / speed;
        for k in 0..(50.0 * ends) as i32 {
            let t = 0.02 * f64::from(k);
            let works = t > 2.0 && t < rests.min(touches + 0.5);
            let mut outputs = [f64::NAN; super::super::record::MOTORS];
            outputs[..4].fill(if works { 0.5 } else { 0.0 });
            record.outputs.push(t, outputs);
            record.rates.push(t, [0.0; 3]);
            let force = if (t - touches).abs() < 0.03 { jolt } else { 9.81 };
            record.force.push(t, [0.0, 0.0, force]);
            let height = (4.0 * (t - 2.0)).clamp(0.0, 20.0).min((20.0 - speed * (t - 12.0)).max(0.0));
            record.height.push(t, [height]);
            record.pressure_height.push(t, [height]);
        }
        let command = |row: usize, motor: usize| f64::from(record.outputs.values[row][motor]);
        let samples = Samples::of(&record, 4, &command).unwrap();
        let found = flights(&record, &samples);
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].clone()
    }

    #[test]
    fn a_landing_an_impact_and_a_log_that_ends_in_the_air() {
        assert_eq!(flown(0.7, 9.81, 90.0, 60.0).end, End::Landed);
        assert_eq!(flown(0.7, 60.0, 90.0, 60.0).end, End::Landed, "a hard touch of the skids");
        assert_eq!(flown(0.7, 9.81, 90.0, 15.0).end, End::Open);
        let End::Impact(Some([least, most])) = flown(9.0, 80.0, 90.0, 30.0).end else { panic!("an impact") };
        assert!(least <= 9.1 && most >= 8.9 && most - least < 2.0, "{least} to {most}");
        let flight = flown(0.7, 9.81, 90.0, 60.0);
        assert_eq!((flight.tilt, flight.yaw_rate), (None, Some(0.0)), "nothing is said of what is not logged");
    }

    /// The speed is between that of the line and that of the parabola, for a free fall, a steady one, and one that
    /// drag slows down.
    #[test]
    fn the_speed_of_a_fall_is_in_its_interval() {
        let drag = |t: f64| (9.81_f64 * t / 17.0).tanh() * 17.0;
        let falls: [&dyn Fn(f64) -> f64; 3] = [&|t| 9.81 * t, &|_| 9.0, &drag];
        for speed in falls {
            for time in [1.5, 2.0, 3.0] {
                let mut record = Record::new(Autopilot::ArduPilot);
                let mut height = 100.0;
                for k in 0..(1000.0 * time) as i32 {
                    let t = 0.001 * f64::from(k);
                    height -= 0.001 * speed(t);
                    if k % 100 == 0 {
                        record.pressure_height.push(t, [height]);
                    }
                }
                let [least, most] = descent(&record, time).unwrap();
                let true_speed = speed(time);
                assert!(least < true_speed + 0.1 && most > true_speed - 0.1, "{true_speed}: {least} to {most}");
                assert!(most - least < 0.4 * true_speed, "{true_speed}: {least} to {most}");
            }
        }
        assert_eq!(descent(&Record::new(Autopilot::ArduPilot), 2.0), None);
    }
}
