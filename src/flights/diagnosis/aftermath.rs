//! What a log shows between the first loss of a flight and its end.

use super::ending::{End, Flight};
use super::record::Record;
use super::study::Loss;
use std::ops::Range;

/// A turn about the vertical axis of the body faster than this is not one that was flown, rad/s: missions and pilots
/// turn at up to about 90 degrees a second (chosen by hand).
const FAST: f64 = std::f64::consts::FRAC_PI_2;
/// How long a turn stays so fast before it counts, s: longer than a jolt.
const LASTS: f64 = 0.3;

/// What followed the losses of the flight in which the last loss of a log is.
#[derive(Debug, Clone, PartialEq)]
pub struct Aftermath {
    /// The first loss of the flight, s.
    pub from: f64,
    /// The losses in force when the turn of `fast_from` began; of a flight without one all of it. As indices into the
    /// losses of the log.
    pub losses: Range<usize>,
    /// The last loss of the flight, as such an index.
    pub last: usize,
    /// The end of the flight, s.
    pub to: f64,
    pub end: End,
    /// When the vehicle began to turn faster than 90 deg/s one way for 0.3 s or longer, s, and which way: 1
    /// counter-clockwise seen from above, -1 clockwise.
    pub fast_from: Option<(f64, f64)>,
    /// The fastest turn about the vertical axis of the body the way of `fast_from`, else either way, rad/s; `None`
    /// without rates.
    pub yaw_rate: Option<f64>,
    /// The greatest tilt, rad; `None` without attitudes.
    pub tilt: Option<f64>,
    /// The largest angle between the direction of thrust and that which was commanded, rad; `None` where the log does
    /// not have the command.
    pub off: Option<f64>,
}

impl Aftermath {
    /// `None` without a loss in a flight.
    pub fn of(record: &Record, flights: &[Flight], losses: &[Loss]) -> Option<Self> {
        let is_in = |flight: &Flight, loss: &Loss| loss.time >= flight.from && loss.time <= flight.to;
        let flight = flights.iter().rfind(|flight| losses.iter().any(|loss| is_in(flight, loss)))?;
        let first = losses.iter().position(|loss| is_in(flight, loss))?;
        let (from, to) = (losses[first].time, flight.to);
        let fast_from = fast_from(record, from, to);
        let in_force = |loss: &Loss| is_in(flight, loss) && fast_from.is_none_or(|(fast, _)| loss.time <= fast);
        let count = losses[first..].iter().take_while(|loss| in_force(loss)).count();
        let last = losses.iter().rposition(|loss| is_in(flight, loss))?;
        let that_way = |rate: f64| fast_from.map_or(rate.abs(), |(_, sign)| sign * rate);
        let yaw_rates = record.rates.within(from, to).iter().map(|rates| that_way(f64::from(rates[2])));
        let attitudes = record.attitude.within(from, to);
        let largest = |angles: &mut dyn Iterator<Item = f64>| angles.filter(|x| x.is_finite()).max_by(f64::total_cmp);
        let up = |roll: f32, pitch: f32| {
            let (roll, pitch) = (f64::from(roll), f64::from(pitch));
            [roll.cos() * pitch.sin(), -roll.sin(), roll.cos() * pitch.cos()]
        };
        let between = |a: [f64; 3], b: [f64; 3]| (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).clamp(-1.0, 1.0).acos();
        Some(Aftermath {
            from,
            // At least the loss itself.
            losses: first..first + count.max(1),
            to,
            end: flight.end,
            fast_from,
            last,
            yaw_rate: yaw_rates.max_by(f64::total_cmp),
            tilt: largest(&mut attitudes.iter().map(|a| between(up(a[0], a[1]), [0.0, 0.0, 1.0]))),
            off: largest(&mut attitudes.iter().map(|a| between(up(a[0], a[1]), up(a[3], a[4])))),
        })
    }
}

/// [`Aftermath::fast_from`] between two times, s.
fn fast_from(record: &Record, from: f64, to: f64) -> Option<(f64, f64)> {
    let times = &record.rates.times;
    let [first, last] = [from, to].map(|t| times.partition_point(|x| *x < t));
    let rate = |k: usize| f64::from(record.rates.values[k][2]);
    let mut begun: Option<usize> = None;
    for k in first..last {
        let goes_on = begun.is_some_and(|begun| rate(begun) * rate(k) > 0.0);
        match (rate(k).abs() > FAST, begun) {
            (false, _) => begun = None,
            (true, Some(since)) if goes_on && times[k] - times[since] >= LASTS => {
                return Some((times[since], rate(k).signum()));
            }
            (true, Some(_)) if goes_on => {}
            (true, _) => begun = Some(k),
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::record::Autopilot;
    use super::super::study::{Evidence, Kind};
    use super::*;

    fn loss(motor: usize, time: f64) -> Loss {
        let interval = [time; 2];
        let (capacity_interval, alternatives) = ([0.0; 2], Vec::new());
        let (kind, evidence) = (Kind::Off, Evidence::Output);
        Loss { motor, time, interval, capacity: 0.0, capacity_interval, kind, evidence, alternatives }
    }

    fn flight(from: f64, to: f64, end: End) -> Flight {
        Flight { from, to, end, tilt: None, yaw_rate: None }
    }

    /// A record with a rate of yaw (rad/s) and a roll (rad) at 50 Hz.
    fn record(rate: impl Fn(f64) -> f64, roll: impl Fn(f64) -> f64, wanted: f64) -> Record {
        let mut record = Record::new(Autopilot::ArduPilot);
        for k in 0..1500 {
            let t = 0.02 * f64::from(k);
            record.rates.push(t, [0.0, 0.0, rate(t)]);
            record.attitude.push(t, [roll(t), 0.0, 0.0, wanted, wanted, 0.0]);
        }
        record
    }

    #[test]
    fn a_fast_turn_is_one_way_and_lasts() {
        let jolts = |t: f64| if (10.0..10.2).contains(&t) { 5.0 } else { 0.0 };
        let swings = |t: f64| 4.0 * (20.0 * t).sin();
        let turns = |t: f64| if t > 14.0 { -2.0 } else { 0.0 };
        let flights = [flight(1.0, 20.0, End::Impact(Some([8.0, 9.0])))];
        let of =
            |rate: &dyn Fn(f64) -> f64| Aftermath::of(&record(rate, |_| 0.0, 0.0), &flights, &[loss(0, 8.0)]).unwrap();
        assert_eq!(of(&jolts).fast_from, None);
        assert_eq!(of(&swings).fast_from, None);
        let found = of(&turns);
        let (time, way) = found.fast_from.unwrap();
        assert!((time - 14.0).abs() < 0.03 && way == -1.0, "{found:?}");
        assert_eq!((found.yaw_rate, found.end, found.from, found.to), (Some(2.0), flights[0].end, 8.0, 20.0));
        // A turn before the loss is not its consequence.
        assert_eq!(of(&|t| if t < 7.9 { 3.0 } else { 0.0 }).fast_from, None);
    }

    /// The losses that explain a turn are those before it; all of a flight without one. A loss on the ground is in no
    /// flight.
    #[test]
    fn later_losses_do_not_explain_an_earlier_turn() {
        let flights = [flight(1.0, 9.0, End::Landed), flight(11.0, 25.0, End::Open)];
        let losses = [loss(2, 5.0), loss(0, 12.0), loss(1, 16.0), loss(3, 26.0)];
        let turning = record(|t| if t > 14.0 { 2.0 } else { 0.0 }, |_| 0.0, 0.0);
        let still = record(|_| 0.0, |_| 0.0, 0.0);
        let of = |record: &Record| Aftermath::of(record, &flights, &losses).map(|found| (found.losses, found.last));
        assert_eq!(of(&turning), Some((1..2, 2)));
        assert_eq!(of(&still), Some((1..3, 2)));
        assert_eq!(Aftermath::of(&still, &flights, &losses[3..]), None);
        assert_eq!(Aftermath::of(&still, &flights, &[]), None);
    }

    #[test]
    fn tilt_and_the_angle_to_the_command() {
        let flights = [flight(1.0, 25.0, End::Open)];
        let rolls = |t: f64| if t > 20.0 { 0.7 } else { 0.1 };
        let found = Aftermath::of(&record(|_| 0.0, rolls, 0.0), &flights, &[loss(0, 12.0)]).unwrap();
        assert!((found.tilt.unwrap() - 0.7).abs() < 1e-6 && (found.off.unwrap() - 0.7).abs() < 1e-6, "{found:?}");
        let unknown = Aftermath::of(&record(|_| 0.0, rolls, f64::NAN), &flights, &[loss(0, 12.0)]).unwrap();
        assert_eq!((unknown.off, unknown.tilt.is_some()), (None, true));
        let empty = Record::new(Autopilot::ArduPilot);
        let nothing = Aftermath::of(&empty, &flights, &[loss(0, 12.0)]).unwrap();
        assert_eq!((nothing.yaw_rate, nothing.tilt, nothing.off, nothing.fast_from), (None, None, None, None));
    }
}
