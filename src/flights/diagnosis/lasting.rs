//! Whether what a change means lasts: a vehicle that flies on balances a lost rotor by other commands for good. A fast
//! manoeuvre between two samples of the outputs turns the vehicle too, but leaves the commands as they were.

use super::change::Change;
use super::fit::Effect;
use super::samples::{Sample, Samples};

/// The commands are compared from so long before a change to shortly before it, and from soon after it on, s.
const BEFORE: [f64; 2] = [4.0, 0.2];
const AFTER: f64 = 0.5;
/// Until when, s: the first that has enough calm windows, because another rotor may be lost soon.
const UNTIL: [f64; 3] = [2.0, 4.0, 8.0];
/// A window is calm below this rate (rad/s) and this angular acceleration (rad/s^2) of roll and pitch, and this rate of
/// yaw (rad/s): torques balance. In a fast spin those of the body's momentum do, and not those of the commands.
const SLOW: f64 = 1.0;
const SPINS: f64 = std::f64::consts::FRAC_PI_2;
const STEADY: f64 = 3.0;
/// Calm windows after a change that decide, s in all.
const ENOUGH: f64 = 0.7;
/// The least share of the torque that a change takes away by which the commands have to differ.
const LEAST: f64 = 0.5;

/// Whether the commands after a change until the flight ends (s) balance what it takes away; true if too few windows
/// after it are calm, as when the vehicle falls.
pub fn lasts(samples: &Samples, effects: &[Effect], change: &Change, ends: f64) -> bool {
    let levels = |s: &Sample| (0..2).all(|k| s.rates[k].abs() < SLOW && s.turning[k].abs() < STEADY);
    let is_calm = |s: &&Sample| s.is_valid && levels(s) && s.rates[2].abs() < SPINS;
    let within = |from: f64, to: f64| -> Vec<&Sample> {
        let [a, b] = [from, to].map(|t| samples.samples.partition_point(|s| s.time < t));
        samples.samples[a..b.max(a)].iter().filter(is_calm).collect()
    };
    let before = within(change.time - BEFORE[0], change.time - BEFORE[1]);
    let calm = UNTIL.map(|until| within(change.time + AFTER, (change.time + until).min(ends)));
    let Some(after) = calm.into_iter().find(|after| after.len() as f64 * samples.step >= ENOUGH) else { return true };
    if before.is_empty() {
        return true;
    }
    let mean =
        |of: &[&Sample], value: &dyn Fn(&Sample) -> f64| of.iter().map(|s| value(s)).sum::<f64>() / of.len() as f64;
    let lost = mean(&after, &|s| s.commands[change.motor] - change.given(s.commands[change.motor]));
    let (mut along, mut square) = (0.0, 0.0);
    for axis in [1, 2] {
        let torque = |s: &Sample| s.commands.iter().zip(effects).map(|(u, e)| u * e[axis]).sum::<f64>();
        let due = lost * effects[change.motor][axis];
        along += due * (mean(&after, &torque) - mean(&before, &torque));
        square += due * due;
    }
    along > LEAST * square
}
