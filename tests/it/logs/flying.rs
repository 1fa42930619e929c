//! A hexacopter X of ArduPilot that hovers under a simple controller, and its log: enough of physics to show a fault.

/// Angle clockwise from the nose and yaw torque of each motor, in ArduPilot's order: `FRAME_CLASS` 2, `FRAME_TYPE` 1.
const MOTORS: [(f64, f64); 6] = [(90.0, 1.0), (-90.0, -1.0), (-30.0, 1.0), (150.0, -1.0), (30.0, -1.0), (-150.0, 1.0)];
const STEP: f64 = 0.0025;
const HOVER: f64 = 0.4;
/// Angular acceleration for each unit of torque command, rad/s^2.
const GAINS: [f64; 3] = [50.0, 50.0, 6.0];

/// What goes wrong with one motor (from 1), and when, s after the start of the flight.
#[derive(Clone, Copy)]
pub enum Fault {
    None,
    /// It gives this share of its thrust.
    Capacity(usize, f64, f64),
    /// Its share falls from 1 to this one in so many seconds.
    Fades(usize, f64, f64, f64),
    /// Its output is switched off.
    Off(usize, f64),
    /// Its output stays at this pulse.
    Held(usize, f64, u16),
    /// It gives this share of full thrust whatever its output.
    Stuck(usize, f64, f64),
    /// None: quick steps of pitch, faster than outputs at 10 Hz show.
    Steps,
}

/// Numbers from a linear congruence: roughly normal, the same on every machine.
pub struct Noise(pub u64);

impl Noise {
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

/// Writes messages.
struct Log(Vec<u8>);

impl Log {
    fn format(&mut self, kind: u8, length: usize, name: &str, types: &str, labels: &str) {
        let mut text = [0_u8; 84];
        text[..name.len()].copy_from_slice(name.as_bytes());
        text[4..4 + types.len()].copy_from_slice(types.as_bytes());
        text[20..20 + labels.len()].copy_from_slice(labels.as_bytes());
        self.0.extend([0xa3, 0x95, 128, kind, length as u8]);
        self.0.extend(text);
    }

    fn message(&mut self, kind: u8, time: f64, rest: &[u8]) {
        self.0.extend([0xa3, 0x95, kind]);
        self.0.extend(((time * 1e6) as u64).to_le_bytes());
        self.0.extend(rest);
    }

    fn parameter(&mut self, name: &str, value: f32) {
        let mut rest = [0_u8; 20];
        rest[..name.len()].copy_from_slice(name.as_bytes());
        rest[16..].copy_from_slice(&value.to_le_bytes());
        self.message(1, 1e-6, &rest);
    }
}

/// The thrust curve of the default parameters, from a share of full thrust to a pulse in us.
fn pulse(share: f64) -> u16 {
    let x = (-0.35 + (0.35_f64.powi(2) + 4.0 * 0.65 * share.clamp(0.0, 1.0)).sqrt()) / 1.3;
    (1150.0 + 800.0 * x).round() as u16
}

fn share(pulse: f64) -> f64 {
    let x = ((pulse - 1150.0) / 800.0).clamp(0.0, 1.0);
    0.35 * x + 0.65 * x * x
}

/// The log of a flight of `seconds` that takes off at 5 s: outputs at `outputs` Hz, rates at `rates` Hz.
pub fn log(fault: Fault, seconds: f64, outputs: f64, rates: f64, seed: u64) -> Vec<u8> {
    let mut noise = Noise(seed);
    let mut log = Log(Vec::new());
    log.format(1, 31, "PARM", "QNf", "TimeUS,Name,Value");
    log.format(2, 23, "RCOU", "QHHHHHH", "TimeUS,C1,C2,C3,C4,C5,C6");
    log.format(4, 27, "RATE", "Qffff", "TimeUS,ROut,POut,YOut,AOut");
    log.format(3, 36, "IMU", "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ");
    for (name, value) in [("FRAME_CLASS", 2.0), ("FRAME_TYPE", 1.0), ("MOT_PWM_MIN", 1000.0), ("MOT_PWM_MAX", 2000.0)] {
        log.parameter(name, value);
    }
    for (name, value) in [("MOT_SPIN_MIN", 0.15), ("MOT_SPIN_MAX", 0.95), ("MOT_THST_EXPO", 0.65)] {
        log.parameter(name, value);
    }
    (1..=6).for_each(|k| log.parameter(&format!("SERVO{k}_FUNCTION"), 32.0 + k as f32));
    let place = |(angle, spin): (f64, f64)| [-angle.to_radians().sin(), -angle.to_radians().cos(), spin];
    let effects = MOTORS.map(place);
    let largest: [f64; 3] = std::array::from_fn(|k| effects.iter().map(|e| e[k].abs()).fold(0.0, f64::max));
    let (mut angles, mut turns, mut thrusts) = ([0.0; 3], [0.0; 3], [HOVER; 6]);
    let mut gust = [0.0; 3];
    let (mut due_outputs, mut due_rates) = (0.0, 0.0);
    for i in 0..(seconds / STEP) as usize {
        let t = i as f64 * STEP;
        let wanted: [f64; 3] = std::array::from_fn(|k| {
            let step = matches!(fault, Fault::Steps) && k == 1 && (6.0..9.0).contains(&(t % 12.0));
            let aim = if step {
                0.3
            } else if k < 2 {
                0.1 * (0.7 * t + k as f64).sin()
            } else {
                0.0
            };
            let stiff = [60.0, 60.0, 4.0][k];
            (stiff * (aim - angles[k]) - 1.5 * f64::sqrt(stiff) * turns[k]) / GAINS[k]
        });
        let mut pulses: [u16; 6] = std::array::from_fn(|m| {
            let torque: f64 = (0..3).map(|k| effects[m][k] * wanted[k] / if k < 2 { 3.0 } else { 6.0 }).sum();
            pulse(HOVER + torque)
        });
        let mut capacity = [1.0; 6];
        let mut stuck = [None; 6];
        match fault {
            Fault::Stuck(m, at, share) if t >= at => stuck[m - 1] = Some(share),
            Fault::Capacity(m, at, c) if t >= at => capacity[m - 1] = c,
            Fault::Fades(m, at, c, lasts) if t >= at => capacity[m - 1] = 1.0 - (1.0 - c) * ((t - at) / lasts).min(1.0),
            Fault::Off(m, at) if t >= at => pulses[m - 1] = 1000,
            Fault::Held(m, at, output) if t >= at => pulses[m - 1] = output,
            _ => {}
        }
        let given: [f64; 6] = std::array::from_fn(|m| stuck[m].unwrap_or(capacity[m] * share(f64::from(pulses[m]))));
        for m in 0..6 {
            thrusts[m] += STEP / 0.04 * (given[m] - thrusts[m]);
        }
        for k in 0..3 {
            gust[k] += -STEP * gust[k] + 0.05 * STEP.sqrt() * noise.normal();
            let torque: f64 = (0..6).map(|m| effects[m][k] * thrusts[m]).sum();
            turns[k] += STEP * (GAINS[k] * torque + gust[k]);
            angles[k] += STEP * turns[k];
        }
        let time = 5.0 + t;
        if t >= due_outputs {
            due_outputs += 1.0 / outputs;
            // What the mixer adds to the motors of the largest effect, doubled; forward, right, down.
            let demand = [2.0 / 3.0, -2.0 / 3.0, -2.0 / 6.0];
            let demands = (0..3).map(|k| demand[k] * largest[k] * wanted[k]).chain([HOVER]);
            log.message(4, time, &demands.flat_map(|x| (x as f32).to_le_bytes()).collect::<Vec<u8>>());
            log.message(2, time, &pulses.iter().flat_map(|p| p.to_le_bytes()).collect::<Vec<u8>>());
        }
        if t >= due_rates {
            due_rates += 1.0 / rates;
            let force = 9.81 * thrusts.iter().sum::<f64>() / (6.0 * HOVER);
            let mut rest = vec![0_u8];
            let mut add = |x: f64| rest.extend((x as f32).to_le_bytes());
            [1.0, -1.0, -1.0].iter().zip(turns).for_each(|(sign, w)| add(sign * w + 0.003 * noise.normal()));
            [0.0, 0.0, -force].iter().for_each(|f| add(f + 0.2 * noise.normal()));
            log.message(3, time, &rest);
        }
    }
    log.0
}
