//! Logs of good flights with which that of `diagnose` is compared.

use super::diagnosis::{Vehicle, Why, missing, read};
use crate::diagnosis::capacity::{Capacity, student};
use crate::diagnosis::ending::End;
use crate::diagnosis::record::Record;
use crate::diagnosis::study::Study;
use crate::log;
use crate::number::fixed;
use crate::report::diagnosis::Against;
use std::io::Read;

/// A change of less than this is none: a thrust curve is not known better.
const LEAST: f64 = 0.02;

/// A log: one flight has the same times, number and last row of outputs. Baselines are of one frame.
struct Identity {
    times: Option<(f64, f64)>,
    outputs: usize,
    last: Vec<f32>,
    frame: Option<String>,
}

impl Identity {
    fn of(record: &Record) -> Self {
        let outputs = &record.outputs;
        Identity {
            times: outputs.times.first().copied().zip(outputs.times.last().copied()),
            outputs: outputs.len(),
            last: outputs.values.last().map_or(Vec::new(), |row| row.iter().map(|v| v.max(0.0)).collect()),
            frame: log::frame(record).ok().map(|(text, _)| text),
        }
    }

    fn is_same(&self, other: &Identity) -> bool {
        self.times == other.times && self.outputs == other.outputs && self.last == other.last
    }
}

/// The capacities of good flights, and those to compare with them.
pub(super) struct Baseline {
    own: Option<Vec<Capacity>>,
    /// The log itself, then those that were taken.
    logs: Vec<Identity>,
    good: Vec<Vec<Capacity>>,
}

impl Baseline {
    pub fn new(record: &Record, study: Option<&Study>) -> Self {
        let own = study.and_then(|study| study.capacities.clone());
        Baseline { own, logs: vec![Identity::of(record)], good: Vec::new() }
    }

    /// Takes the log of a good flight of the vehicle.
    ///
    /// # Errors
    /// It cannot be read, is one that is there already, is of another frame, has a loss or an impact, or no quiet part.
    pub fn take(&mut self, vehicle: &Vehicle, source: &mut dyn Read) -> Result<(), Why> {
        let (record, _) = read(source)?;
        let not = |message: String, help: &str| Err(Why::Not(vec![*missing(message, help)]));
        let identity = Identity::of(&record);
        match self.logs.iter().position(|known| known.is_same(&identity)) {
            Some(0) => {
                return not("the baseline is the log itself".into(), "name logs of other flights, known to be good");
            }
            Some(_) => {
                return not("the baseline names this flight twice".into(), "name each good flight once");
            }
            None => {}
        }
        let frames = self.logs[0].frame.as_ref().zip(identity.frame.as_ref());
        if frames.is_some_and(|(own, other)| own != other) {
            return not(
                "the baseline is of another frame".into(),
                "name flights of the same vehicle with the same load",
            );
        }
        let study = vehicle.study(&record, &[]).map_err(|error| Why::Not(vec![*error]))?;
        let help = "name flights that are known to be good";
        if let Some(loss) = study.as_ref().and_then(|study| study.losses.first()) {
            let (motor, time) = (loss.motor + 1, fixed(loss.time, 1));
            return not(format!("the baseline is not of a good flight: motor {motor} loses thrust at {time} s"), help);
        }
        if study.iter().flat_map(|study| &study.flights).any(|flight| matches!(flight.end, End::Impact(_))) {
            return not("the baseline is not of a good flight: it ends with an impact".into(), help);
        }
        let Some(capacities) = study.and_then(|study| study.capacities) else {
            return not(
                "the baseline has less than 8 s of quiet flight".into(),
                "name flights with a hover of 15 s or more",
            );
        };
        self.logs.push(identity);
        self.good.push(capacities);
        Ok(())
    }

    /// The capacities against those of good flights; `None` for fewer than two of them, or without capacities. The
    /// spread between flights is taken as that of all rotors alike, because a few flights show too little of each; that
    /// within this flight comes to it.
    pub fn against(&self) -> Option<Vec<Against>> {
        let own = self.own.as_ref().filter(|_| self.good.len() >= 2)?;
        let (n, flights) = (own.len(), self.good.len() as f64);
        let mean = |k: usize| self.good.iter().map(|flight| flight[k].value).sum::<f64>() / flights;
        let means: Vec<f64> = (0..n).map(mean).collect();
        let of_flight = |flight: &Vec<Capacity>| -> f64 {
            flight.iter().zip(&means).map(|(capacity, mean)| (capacity.value - mean).powi(2)).sum()
        };
        let freedom = n * (self.good.len() - 1);
        let variance = self.good.iter().map(of_flight).sum::<f64>() / freedom as f64;
        let between = student(freedom) * (variance * (1.0 + 1.0 / flights)).sqrt();
        let against = |(motor, capacity): (usize, &Capacity)| Against {
            motor,
            mean: means[motor],
            change: capacity.value - means[motor],
            half: between.hypot(0.5 * (capacity.high - capacity.low)).max(LEAST),
        };
        Some(own.iter().enumerate().map(against).collect())
    }
}
