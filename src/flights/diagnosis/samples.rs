//! A record cut into windows of equal length: mean commands, rates, angular acceleration and thrust of each.

use super::change::Change;
use super::record::Record;

/// The shortest and the longest window, s. Longer ones hide what a vehicle does after a fault.
const SHORTEST: f64 = 0.02;
const LONGEST: f64 = 0.25;
/// Windows are at least so long, as a share of the time between two samples of the outputs.
const FINER: f64 = 0.2;
/// The most windows: longer records get longer windows.
const MOST: f64 = 400_000.0;
/// A gap of a series that is not filled, in windows or in samples, whichever is longer.
const GAP: f64 = 2.5;

/// One window.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Its middle, s.
    pub time: f64,
    /// Share of full thrust that each motor is commanded.
    pub commands: Vec<f64>,
    /// rad/s.
    pub rates: [f64; 3],
    /// Angular acceleration, rad/s^2.
    pub turning: [f64; 3],
    /// Specific force upwards in the body, m/s^2; NaN where it is not logged.
    pub force: f64,
    /// Whether the sample says something: in the air, every series there.
    pub is_valid: bool,
}

/// The windows of a record.
#[derive(Debug, Clone)]
pub struct Samples {
    /// Length of a window, s.
    pub step: f64,
    /// How much a window counts: the windows between two samples of the outputs are one observation, because what the
    /// commands are between them is assumed.
    pub share: f64,
    pub samples: Vec<Sample>,
}

impl Samples {
    /// Cuts a record into windows; `command` is the share of full thrust by row of the outputs and by motor. `None` if
    /// commands or rates are too few or too slow.
    pub fn of(record: &Record, motors: usize, command: &dyn Fn(usize, usize) -> f64) -> Option<Self> {
        let times = &record.outputs.times;
        let (first, last) = (*times.first()?, *times.last()?);
        let slowest = record.outputs.period().max(record.rates.period());
        if slowest.is_nan() || slowest > LONGEST || times.len() < 20 {
            return None;
        }
        // Turns are logged more often than outputs: between two samples of these the commands are known.
        let step = record.rates.period().max(FINER * record.outputs.period()).max(SHORTEST).max((last - first) / MOST);
        let gaps = [record.outputs.period(), record.rates.period(), record.force.period()].map(|p| GAP * step.max(p));
        let count = ((last - first) / step).floor() as usize;
        let mut samples: Vec<Sample> = (0..count)
            .map(|i| {
                let (from, to) = (first + i as f64 * step, first + (i + 1) as f64 * step);
                let time = 0.5 * (from + to);
                let commands = mean_command(times, gaps[0], command, [from, to], motors);
                let rates = mean(record.rates.within(from, to)).or(record.rates.at(time, gaps[1]));
                let force = mean(record.force.within(from, to)).or(record.force.at(time, gaps[2]));
                let is_valid = rates.is_some() && commands.iter().all(|u| u.is_finite());
                Sample {
                    time,
                    commands,
                    rates: rates.unwrap_or([f64::NAN; 3]),
                    turning: [f64::NAN; 3],
                    force: force.map_or(f64::NAN, |f| f[2]),
                    is_valid,
                }
            })
            .collect();
        for i in 1..samples.len().saturating_sub(1) {
            let turning = std::array::from_fn(|k| (samples[i + 1].rates[k] - samples[i - 1].rates[k]) / (2.0 * step));
            samples[i].turning = turning;
        }
        samples.iter_mut().for_each(|s| s.is_valid &= s.turning.iter().all(|x| x.is_finite()));
        Some(Samples { step, share: (step / slowest).min(1.0), samples })
    }

    /// What each rotor gives of its command if some of them changed, as commands.
    pub fn with(&self, changes: &[Change]) -> Self {
        let mut changed = self.clone();
        for change in changes {
            for sample in changed.samples.iter_mut().filter(|sample| sample.time > change.time) {
                let command = &mut sample.commands[change.motor];
                *command = change.given(*command);
            }
        }
        changed
    }

    /// The commands as the rotors follow them with a time constant (s), averaged as the angular acceleration is.
    pub fn followed(&self, lag: f64) -> Vec<Vec<f64>> {
        // What a rotor approaches of a constant command in a window, and its mean distance from it on the way.
        let share = if lag > 0.0 { 1.0 - (-self.step / lag).exp() } else { 1.0 };
        let distance = lag / self.step * share;
        let mut state: Vec<f64> = Vec::new();
        let lagged: Vec<Vec<f64>> = self
            .samples
            .iter()
            .map(|sample| {
                if state.iter().any(|x| !x.is_finite()) || state.is_empty() {
                    state.clone_from(&sample.commands);
                }
                let mean = state.iter().zip(&sample.commands).map(|(x, u)| u + distance * (x - u)).collect();
                state.iter_mut().zip(&sample.commands).for_each(|(x, u)| *x += share * (u - *x));
                mean
            })
            .collect();
        let n = lagged.len();
        let smooth = |i: usize| {
            let (a, b, c) = (&lagged[i.saturating_sub(1)], &lagged[i], &lagged[(i + 1).min(n - 1)]);
            a.iter().zip(b).zip(c).map(|((a, b), c)| 0.25 * a + 0.5 * b + 0.25 * c).collect()
        };
        (0..n).map(smooth).collect()
    }
}

fn mean(values: &[[f32; 3]]) -> Option<[f64; 3]> {
    let count = values.len() as f64;
    (!values.is_empty()).then(|| std::array::from_fn(|k| values.iter().map(|v| f64::from(v[k])).sum::<f64>() / count))
}

/// The mean of the commands in a window: of those in it, or else at its middle between the one before and the one
/// after, or the last if that is not long ago.
fn mean_command(
    times: &[f64],
    gap: f64,
    command: &dyn Fn(usize, usize) -> f64,
    [from, to]: [f64; 2],
    motors: usize,
) -> Vec<f64> {
    let [a, b] = [from, to].map(|t| times.partition_point(|x| *x < t));
    if b > a {
        return (0..motors).map(|k| (a..b).map(|row| command(row, k)).sum::<f64>() / (b - a) as f64).collect();
    }
    let Some(before) = a.checked_sub(1).filter(|row| from - times[*row] < gap) else { return vec![f64::NAN; motors] };
    let share = match times.get(a) {
        Some(after) if after - times[before] < gap => (0.5 * (from + to) - times[before]) / (after - times[before]),
        _ => return (0..motors).map(|k| command(before, k)).collect(),
    };
    (0..motors).map(|k| (1.0 - share) * command(before, k) + share * command(a, k)).collect()
}
