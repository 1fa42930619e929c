//! Ways out after faults, for flights that take one: found elsewhere, when the fault becomes known.

use crate::motion::Trajectory;
use std::fmt;

/// What a vehicle does after a fault, from its state when the fault becomes known.
#[derive(Debug, Clone, PartialEq)]
pub enum WayOut {
    /// It leaves the plan along a motion.
    Branch {
        motion: Trajectory,
        /// Whether the motion ends in the plan, which is followed then; otherwise it ends at rest on the ground.
        returns: bool,
        /// `lands at depot`
        words: String,
    },
    /// It stops and descends.
    Stop { words: String },
}

impl WayOut {
    pub fn words(&self) -> &str {
        match self {
            WayOut::Branch { words, .. } | WayOut::Stop { words } => words,
        }
    }
}

/// Finds a way out after a fault: `None` if none was found.
#[derive(Clone, Copy)]
pub struct WaysOut<'a> {
    /// The mode's index, the times at which its fault strikes and becomes known, s since the start of the plan.
    pub find: &'a (dyn Fn(usize, f64, f64) -> Option<WayOut> + Sync),
}

impl fmt::Debug for WaysOut<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("WaysOut")
    }
}

/// The way out that a flight took.
#[derive(Debug, Clone, PartialEq)]
pub struct TakenWay {
    /// When the fault became known, s since the start.
    pub at: f64,
    /// The words of the way out; `None` if none was found, so that the vehicle flew on as planned.
    pub words: Option<String>,
}
