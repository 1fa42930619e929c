//! What a vehicle may do after a fault: where it may come down, what it keeps away from, and in which order the ways
//! out are tried.

use super::{Detection, Limit, Mission, Model, Simulation};
use crate::body::Body;
use crate::language::table::recovery as table;
use crate::source::Span;

/// A place where a damaged vehicle may land: it touches down within `radius` of `at`.
#[derive(Debug, Clone, PartialEq)]
pub struct LandingSite {
    pub name: String,
    /// On the ground, world frame, m.
    pub at: [f64; 3],
    /// m; positive
    pub radius: f64,
    pub span: Span,
}

/// An area where no vehicle lands; it may fly over it.
#[derive(Debug, Clone, PartialEq)]
pub struct KeepOff {
    pub name: String,
    /// Convex bodies, of which only the outline seen from above counts; the area is their union. They are prisms and
    /// cylinders without ends (`bottom` and `top` are infinite), so that the distance from one is horizontal.
    pub bodies: Vec<Body>,
    /// Horizontal distance from the outline that the vehicle keeps in addition to its size where it touches down, m.
    pub clearance: f64,
    pub span: Span,
}

/// What the mission says of the time after a fault.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AfterFaultRules {
    pub sites: Vec<LandingSite>,
    pub keep_off: Vec<KeepOff>,
    /// How far beyond every `keep_in` and every limit on a place the vehicle may be after a fault, m; 0 by default.
    pub buffer: f64,
    /// `after_fault_limits`: each replaces the mission's limit on the same quantity.
    pub limits: Vec<Limit>,
}

/// A way out after a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Recovery {
    /// Back to the plan, and along it to its end.
    Continue,
    /// Down at one landing site, an index into [`AfterFaultRules::sites`].
    LandAt(usize),
    /// Down at any landing site.
    LandAtSites,
    /// Down wherever the vehicle comes to rest, except on an area to keep off.
    LandHere,
}

/// `require uncovered <= 0 %`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recoverable {
    /// The largest share of the time, summed over the modes and weighted with their rates, without a way out.
    pub uncovered: f64,
    /// The place of the statement.
    pub span: Span,
}

/// How ways out are sought: fields of the `plan` block.
#[derive(Debug, Clone, PartialEq)]
pub struct RecoverySettings {
    /// The ways out in the order of preference; a mode may have its own.
    pub order: Vec<Recovery>,
    /// The shortest and the longest delay after which a fault is known, s.
    pub detection: [f64; 2],
    /// The longest time from the fault's detection to touchdown, or back to the plan, s.
    pub within: f64,
    /// The charge that is left after touchdown, as a share of the battery's energy.
    pub keep: f64,
    pub require: Option<Recoverable>,
}

impl Default for RecoverySettings {
    fn default() -> Self {
        RecoverySettings {
            order: vec![Recovery::Continue, Recovery::LandAtSites, Recovery::LandHere],
            detection: [0.2, 0.2],
            within: table::WITHIN.value(),
            keep: table::KEEP.value(),
            require: None,
        }
    }
}

impl RecoverySettings {
    /// The settings of a plan that says nothing of them: a fault is known after the delay of `simulate`, if that gives
    /// one.
    pub fn unsaid(simulation: &Simulation) -> Self {
        let unsaid = RecoverySettings::default();
        match simulation.detection {
            Detection::After(delay) => RecoverySettings { detection: [delay; 2], ..unsaid },
            Detection::Never | Detection::Estimator => unsaid,
        }
    }
}

impl Model {
    /// The ways out after a fault of the mode with index `mode` in [`Model::modes`], in the order of preference: the
    /// mode's own, or else the plan's.
    ///
    /// # Panics
    /// If there is no such mode.
    pub fn recovery(&self, mode: usize) -> &[Recovery] {
        self.modes[mode].recovery.as_deref().unwrap_or(&self.plan.recovery.order)
    }
}

impl Mission {
    /// The landing sites that a way out may lead to, as indices into [`AfterFaultRules::sites`].
    pub fn sites_of(&self, recovery: Recovery) -> Vec<usize> {
        match recovery {
            Recovery::LandAt(site) => vec![site],
            Recovery::LandAtSites => (0..self.after_fault.sites.len()).collect(),
            Recovery::Continue | Recovery::LandHere => Vec::new(),
        }
    }
}
