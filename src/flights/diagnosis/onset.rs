//! The instant, the rotor and the capacity of a sudden loss, once its neighbourhood is known.
//!
//! Every rotor, instant and time constant is compared on the same windows, by the angular accelerations and the thrust
//! that it predicts; a window in which the loss begins counts in part. For a rotor k with capacity c from an instant on
//! an axis answers with `g (x - (1 - c) v)`: x the command, v the part of rotor k after the instant, g a gain of the
//! whole neighbourhood. So the squared error is a rational function of c, and each instant takes one pass over the
//! windows.

use super::change::Change;
use super::fit::Effect;
use super::record::median;
use super::samples::Samples;

/// Seconds before the neighbourhood, from which the offsets and spreads of a healthy vehicle are taken.
const BEFORE: f64 = 4.0;
/// The instant is sought so long before and after the one that was found, s.
const EARLIER: f64 = 0.6;
const LATER: f64 = 0.1;
/// The neighbourhoods that are tried: the longest that a loss explains is taken, because a vehicle that turns over soon
/// leaves the model. In 600 simulated flights (benches/diagnosis, seeds 1 and 2) true losses leave at most 0.73 in the
/// longest.
const NEIGHBOURHOODS: [Neighbourhood; 3] = [
    Neighbourhood { after: 0.9, explains: 0.65 },
    Neighbourhood { after: 0.45, explains: 0.4 },
    Neighbourhood { after: 0.25, explains: 0.35 },
];
/// Faster turns than this are left out, rad/s.
const FASTEST: f64 = 6.0;
/// Time constants of rotors that are tried, s.
const LAGS: [f64; 8] = [0.0, 0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12];
/// Parts of a window in which a loss may begin.
const PARTS: usize = 4;
/// Capacities that are tried: whole percents.
const PERCENTS: usize = 101;
/// The least standard deviations: of a specific force, m/s^2, because no thrust curve is exact to more than some
/// percent of gravity, and of an angular acceleration, rad/s^2.
const FLOORS: [f64; 4] = [0.5, 0.15, 0.15, 0.15];
/// Share of what an axis shows by which the model may be off.
const MODEL_ERROR: f64 = 0.25;
/// How many times more the squared error varies than that of independent windows would: with it the intervals of
/// capacities hold as often as they should (benches/diagnosis, seeds 1 and 2).
const CORRELATED: f64 = 3.0;
/// Half of the 95 % interval of a capacity by the errors of the model alone (benches/diagnosis).
const SHARE_ERROR: f64 = 0.06;
/// A loss is taken if it lowers the squared error of the healthy vehicle by so many variances. In the same flights true
/// losses lower it by 112 or more, and everything else by at most 35.
const THRESHOLD: f64 = 80.0;
/// A rotor is taken as held if that lowers the squared error below that of a lower capacity by so many variances.
const CLEARLY: f64 = 9.0;
/// How often the search begins again from an instant at its edge.
const AGAIN: usize = 3;

/// The windows by which an instant is judged.
#[derive(Clone, Copy)]
struct Neighbourhood {
    /// How long after it the windows count, s.
    after: f64,
    /// To which share of the healthy vehicle's squared error a loss has to lower theirs.
    explains: f64,
}

/// An axis: what it shows in each window (NaN: nothing), relative to before, with the weight of each.
struct Axis {
    shown: Vec<f64>,
    weight: Vec<f64>,
}

/// Weighted sums of products of the command x, the lost part v and what is shown y.
#[derive(Debug, Clone, Copy, Default)]
struct Products {
    xx: f64,
    xv: f64,
    vv: f64,
    xy: f64,
    vy: f64,
    yy: f64,
}

impl Products {
    fn add(&mut self, weight: f64, [x, v, y]: [f64; 3]) {
        self.xx += weight * x * x;
        self.xv += weight * x * v;
        self.vv += weight * v * v;
        self.xy += weight * x * y;
        self.vy += weight * v * y;
        self.yy += weight * y * y;
    }

    fn plus(&self, other: &Products) -> Products {
        Products {
            xx: self.xx + other.xx,
            xv: self.xv + other.xv,
            vv: self.vv + other.vv,
            xy: self.xy + other.xy,
            vy: self.vy + other.vy,
            yy: self.yy + other.yy,
        }
    }

    /// The squares of the response to a share that is lost, and its product with what is shown.
    fn response(&self, lost: f64) -> [f64; 2] {
        [self.xx - 2.0 * lost * self.xv + lost * lost * self.vv, self.xy - lost * self.vy]
    }
}

/// The best squared error of each capacity for a rotor, and the instant of the best of all.
struct Profile {
    errors: [f64; PERCENTS],
    best: f64,
    /// In windows.
    instant: f64,
    /// The best of each instant, in the order in which they are tried.
    by_instant: Vec<f64>,
}

/// The loss near a time (s) that explains its neighbourhood best; `None` if none does.
pub fn onset(samples: &Samples, effects: &[Effect], range: std::ops::Range<usize>, time: f64) -> Option<Change> {
    NEIGHBOURHOODS.into_iter().find_map(|judged_by| {
        let mut found = near(samples, effects, range.clone(), time, judged_by)?;
        for _ in 0..AGAIN {
            if !found.1 {
                break;
            }
            found = near(samples, effects, range.clone(), found.0.time, judged_by)?;
        }
        Some(found.0)
    })
}

/// The loss, and whether it is at the first instant that was tried.
fn near(
    samples: &Samples,
    effects: &[Effect],
    range: std::ops::Range<usize>,
    time: f64,
    Neighbourhood { after, explains }: Neighbourhood,
) -> Option<(Change, bool)> {
    let windows = |seconds: f64, least: usize| ((seconds / samples.step).round() as usize).max(least);
    let at = samples.samples.partition_point(|s| s.time < time).min(range.end);
    let first = at.saturating_sub(windows(EARLIER, 3)).max(range.start + 2);
    let end = (at + windows(after, 3)).min(range.end);
    let begin = first.saturating_sub(windows(BEFORE, 8)).max(range.start);
    let is_used = |i: &usize| {
        let s = &samples.samples[*i];
        s.is_valid && s.rates.iter().all(|w| w.abs() < FASTEST)
    };
    let rows: Vec<usize> = (begin..end).filter(is_used).collect();
    let early = rows.partition_point(|i| *i + 2 < first);
    if early < windows(BEFORE, 8) / 3 {
        return None;
    }
    let axes: [Axis; 4] = std::array::from_fn(|axis| Axis::of(samples, &rows, early, axis));
    let instants: Vec<f64> = (first..=(at + windows(LATER, 1)).min(end.saturating_sub(2)))
        .flat_map(|start| (0..PARTS).map(move |part| start as f64 + part as f64 / PARTS as f64))
        .collect();
    let mut profiles: Vec<Profile> = (0..2 * effects.len())
        .map(|_| Profile {
            errors: [f64::INFINITY; PERCENTS],
            best: f64::INFINITY,
            instant: at as f64,
            by_instant: vec![f64::INFINITY; instants.len()],
        })
        .collect();
    for lag in LAGS {
        let commands = samples.followed(lag);
        let inputs: [Vec<f64>; 4] = std::array::from_fn(|axis| {
            let sum = |i: &usize| commands[*i].iter().zip(effects).map(|(u, e)| u * e[axis]).sum::<f64>();
            let all: Vec<f64> = rows.iter().map(sum).collect();
            let trim = if axis == 0 { 0.0 } else { all[..early].iter().sum::<f64>() / early as f64 };
            all.iter().map(|x| x - trim).collect()
        });
        if inputs.iter().flatten().any(|x| !x.is_finite()) {
            continue;
        }
        // Before the neighbourhood no instant changes anything.
        let before: [Products; 4] = std::array::from_fn(|axis| {
            let mut sums = Products::default();
            (0..early).for_each(|r| axes[axis].add(&mut sums, r, inputs[axis][r], 0.0));
            sums
        });
        for (number, instant) in instants.iter().enumerate() {
            let share: Vec<f64> = rows[early..].iter().map(|i| lost_share(*i, *instant)).collect();
            for (number_of, profile) in profiles.iter_mut().enumerate() {
                let (motor, is_held) = (number_of % effects.len(), number_of >= effects.len());
                let late: [Products; 4] = std::array::from_fn(|axis| {
                    let mut sums = Products::default();
                    for (r, share) in (early..rows.len()).zip(&share) {
                        let all = share * effects[motor][axis];
                        let lost = commands[rows[r]][motor] * all;
                        let [command, lost] =
                            if is_held { [inputs[axis][r] - lost, all] } else { [inputs[axis][r], lost] };
                        axes[axis].add(&mut sums, r, command, lost);
                    }
                    sums
                });
                profile.take(&before, &late, number, *instant, is_held);
            }
        }
    }
    let strongest = (0..profiles.len()).min_by(|a, b| profiles[*a].best.total_cmp(&profiles[*b].best))?;
    let (motor, least) = (strongest % effects.len(), profiles[strongest].best);
    let healthy = profiles[0].errors[PERCENTS - 1];
    let is_explained = healthy - least > THRESHOLD && least < explains * healthy;
    if !is_explained {
        return None;
    }
    let freedom = samples.share * (4 * (rows.len() - early)).max(1) as f64;
    let noise = (least / freedom).max(1.0);
    let is_held = strongest >= effects.len() && profiles[motor].best > least + CLEARLY * noise;
    let profile = &profiles[if is_held { strongest } else { motor }];
    let is_near = |error: &f64| *error < profile.best + 3.84 * CORRELATED * noise;
    let percent = |k: Option<usize>| k.map(|k| 0.01 * k as f64);
    let capacity = percent((0..PERCENTS).min_by(|a, b| profile.errors[*a].total_cmp(&profile.errors[*b])))?;
    let low = percent(profile.errors.iter().position(is_near))?;
    let high = percent(profile.errors.iter().rposition(is_near))?;
    let time_of = |window: f64| samples.samples[0].time + (window - 0.5) * samples.step;
    let sooner = profile.by_instant.iter().position(is_near).map(|k| time_of(instants[k]))?;
    let later = profile.by_instant.iter().rposition(is_near).map(|k| time_of(instants[k]))?;
    let best = |k: usize| profiles[k].best.min(profiles[k + effects.len()].best);
    let change = Change {
        motor,
        is_held,
        time: time_of(profile.instant),
        interval: [sooner - samples.step, later + samples.step],
        capacity,
        capacity_interval: [
            (capacity - (capacity - low).hypot(SHARE_ERROR)).max(0.0),
            (capacity + (high - capacity).hypot(SHARE_ERROR)).min(1.0),
        ],
        strength: healthy - profile.best,
        alternatives: (0..effects.len()).filter(|k| *k != motor && best(*k) < profile.best + 9.0 * noise).collect(),
    };
    Some((change, profile.instant < instants[0] + 1.0))
}

/// The share of window `i`, as angular accelerations are averaged, that is after an instant (in windows).
fn lost_share(i: usize, instant: f64) -> f64 {
    let after = |i: f64| (i + 1.0 - instant).clamp(0.0, 1.0);
    let i = i as f64;
    0.25 * after(i - 1.0) + 0.5 * after(i) + 0.25 * after(i + 1.0)
}

impl Axis {
    /// What the rows show of thrust (axis 0) or of an angular acceleration, the first `early` of them healthy.
    fn of(samples: &Samples, rows: &[usize], early: usize, axis: usize) -> Self {
        let shown = |i: &usize| match axis {
            0 => samples.samples[*i].force,
            _ => samples.samples[*i].turning[axis - 1],
        };
        let mut healthy: Vec<f64> = rows[..early].iter().map(shown).filter(|y| y.is_finite()).collect();
        let middle = median(&mut healthy).unwrap_or(0.0);
        let mut sizes: Vec<f64> = healthy.iter().map(|y| (y - middle).abs()).collect();
        let spread = (1.4826 * median(&mut sizes).unwrap_or(0.0)).max(FLOORS[axis]);
        let weight = |y: f64| samples.share / (spread.powi(2) + (MODEL_ERROR * (y - middle)).powi(2));
        // Thrust is proportional to its command; a turn only to what differs from the trim.
        let zero = if axis == 0 { 0.0 } else { middle };
        Axis {
            shown: rows.iter().map(|i| shown(i) - zero).collect(),
            weight: rows.iter().map(|i| weight(shown(i))).collect(),
        }
    }

    fn add(&self, sums: &mut Products, row: usize, command: f64, lost: f64) {
        if self.shown[row].is_finite() {
            sums.add(self.weight[row], [command, lost, self.shown[row]]);
        }
    }
}

impl Profile {
    /// Takes the errors of an instant: the gains are those of all windows, the errors those of the neighbourhood.
    fn take(&mut self, before: &[Products; 4], late: &[Products; 4], number: usize, instant: f64, is_held: bool) {
        let all: [Products; 4] = std::array::from_fn(|axis| before[axis].plus(&late[axis]));
        for (percent, least) in self.errors.iter_mut().enumerate() {
            let share = 0.01 * percent as f64;
            let lost = if is_held { -share } else { 1.0 - share };
            let mut error = 0.0;
            for axis in 0..4 {
                let [square, product] = all[axis].response(lost);
                let gain = if square > 0.0 { (product / square).max(0.0) } else { 0.0 };
                let [square, product] = late[axis].response(lost);
                error += late[axis].yy - 2.0 * gain * product + gain * gain * square;
            }
            *least = least.min(error);
            self.by_instant[number] = self.by_instant[number].min(error);
            if error < self.best {
                (self.best, self.instant) = (error, instant);
            }
        }
    }
}
