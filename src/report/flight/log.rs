//! The flight log: one row an instant, SI units.

use crate::flight::Sample;
use crate::report::trajectory_csv::push_row;

/// Collects rows as CSV.
#[derive(Debug, Clone)]
pub struct Log {
    pub csv: String,
    /// Every so many samples make a row.
    every: usize,
    count: usize,
    row: Vec<f64>,
}

impl Log {
    pub fn new(rotors: usize, every: usize) -> Self {
        Log { csv: Self::header(rotors) + "\n", every: every.max(1), count: 0, row: Vec::new() }
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

    pub fn add(&mut self, sample: &Sample) {
        self.count += 1;
        if !(self.count - 1).is_multiple_of(self.every) && !sample.is_last {
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
        // Cells are empty where nothing is estimated, or not yet.
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
