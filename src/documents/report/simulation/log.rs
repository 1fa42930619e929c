//! The flight log: one row per instant, SI units.

use crate::flight::Sample;
use crate::model::Model;
use crate::number::number;
use crate::report::trajectory_csv::{few_enough, push_row};

/// Collects rows as CSV.
#[derive(Debug, Clone)]
pub struct Log {
    pub csv: String,
    pub thinning: Thinning,
    row: Vec<f64>,
}

/// Which samples become rows.
#[derive(Debug, Clone, Default)]
pub struct Thinning {
    /// Samples per row.
    every: usize,
    count: usize,
    /// A message if the rate is not the requested one.
    pub remark: Option<String>,
}

/// Default rate of the log, Hz.
const RATE: f64 = 100.0;

impl Thinning {
    /// Whether the next sample becomes a row. The last always does.
    pub fn is_due(&mut self, sample: &Sample) -> bool {
        self.count += 1;
        (self.count - 1).is_multiple_of(self.every) || sample.is_last
    }
}

impl Log {
    /// An empty log with one row for `every` samples.
    pub fn new(rotors: usize, every: usize) -> Self {
        let thinning = Thinning { every: every.max(1), ..Thinning::default() };
        Log { csv: Self::header(rotors) + "\n", thinning, row: Vec::new() }
    }

    /// The log of a flight of at most `duration` s with rows at about `rate` Hz: the controller runs a whole number of
    /// times between two rows.
    ///
    /// # Errors
    /// The log would have too many numbers.
    pub fn at(model: &Model, rate: Option<f64>, duration: f64) -> Result<Self, String> {
        let control = model.simulation.control_rate;
        let every = (control / rate.unwrap_or(RATE)).round().max(1.0);
        let rotors = model.vehicle.rotors.len();
        few_enough("log", (duration * control / every).ceil() as u64, &Self::header(rotors))?;
        let got = control / every;
        let remark = rate.filter(|wanted| (got - wanted).abs() > 1e-6 * wanted).map(|wanted| {
            let [wanted, got, control] = [wanted, got, control].map(number);
            format!("the log has rows at {got} Hz, not {wanted}: the controller runs at {control} Hz")
        });
        let mut log = Log::new(rotors, every as usize);
        log.thinning.remark = remark;
        Ok(log)
    }

    /// The names of the columns.
    pub fn header(rotors: usize) -> String {
        let mut csv = String::from(
            "t,x,y,z,vx,vy,vz,roll,pitch,yaw,p,q,r,x_ref,y_ref,z_ref,yaw_ref,error,heading_error,tilt,\
             thrust,tau_x,tau_y,tau_z,thrust_cmd,tau_x_cmd,tau_y_cmd,tau_z_cmd",
        );
        for name in ["omega", "theta", "believed"] {
            (1..=rotors).for_each(|k| csv.push_str(&format!(",{name}_{k}")));
        }
        csv + ",regressor_rank,regressor_condition"
    }

    /// Adds a row if one is due, or if the sample is the last.
    pub fn add(&mut self, sample: &Sample) {
        if !self.thinning.is_due(sample) {
            return;
        }
        let Sample { body, reference, .. } = sample;
        let row = &mut self.row;
        row.clear();
        row.push(sample.time);
        row.extend(body.position.iter());
        row.extend(body.velocity.iter());
        row.extend(body.angles());
        row.extend(body.rates.iter());
        row.extend(reference.position.iter());
        row.push(reference.yaw[0]);
        row.push((body.position - reference.position).norm());
        row.push(sample.heading.error());
        row.push(body.tilt());
        row.extend(sample.wrench.iter());
        row.extend(sample.wanted.iter());
        row.extend(sample.speeds);
        row.extend(sample.estimated);
        row.extend(sample.believed);
        push_row(&mut self.csv, row);
        // These cells are empty as long as nothing is estimated.
        self.csv.pop();
        match sample.regressor {
            Some((rank, condition)) => {
                self.csv.push(',');
                push_row(&mut self.csv, &[rank as f64, condition]);
            }
            None => self.csv.push_str(",,\n"),
        }
    }
}
