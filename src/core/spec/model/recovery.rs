//! What a vehicle may do after a fault: where it may come down, what it keeps away from, and in which order the ways
//! out are tried.

use super::{Detection, Limit, LimitKind, Mission, Model, Simulation, Volume};
use crate::body::Body;
use crate::language::table::recovery as table;
use crate::source::Span;

/// A landing ends at rest at most this high above the ground, m: rows of a point alone would leave a solver no room.
pub const TOUCHDOWN: f64 = 0.02;

/// The angular acceleration at which a vehicle's turning is stopped when a fault becomes known, rad/s^2: until then it
/// may tilt further than a limit allows. Chosen by hand.
pub const STOPS_TURNING: f64 = 15.0;

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

/// A limit that holds after a fault.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldLimit {
    /// On whole motions.
    pub limit: Limit,
    /// How far it is widened for a vehicle that exceeds it when the fault becomes known, in the limit's SI unit.
    pub yields: f64,
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

    /// The limits after a fault: `after_fault_limits`, and of the mission's those on places and speeds that they do not
    /// replace. Limits on coordinates and `keep_in`s are widened by the buffer. Volumes yield their clearance, other
    /// limits as much as the fault requires.
    pub fn limits_after_fault(&self) -> Vec<HeldLimit> {
        let rules = &self.after_fault;
        let is_replaced = |limit: &Limit| rules.limits.iter().any(|other| other.kind == limit.kind);
        let of_mission =
            self.limits.iter().filter(|limit| limit.is_general()).filter_map(|limit| match &limit.volume {
                Some(boundary) => {
                    let is_it = |volume: &&Volume| boundary.name == volume.full_name();
                    let clearance = self.volumes.iter().find(is_it).map_or(0.0, |volume| volume.clearance);
                    let by = if limit.kind.is_clearance() { 0.0 } else { rules.buffer };
                    Some(HeldLimit { limit: limit.widened(by), yields: clearance })
                }
                None if is_replaced(limit) || !limit.kind.concerns_safety() => None,
                None => {
                    let is_position = limit.kind.describe().quantity.is_coordinate() && !limit.kind.is_of_yaw();
                    let by = if is_position { rules.buffer } else { 0.0 };
                    Some(HeldLimit { limit: limit.widened(by), yields: f64::INFINITY })
                }
            });
        let own = rules.limits.iter().map(|limit| HeldLimit { limit: limit.clone(), yields: f64::INFINITY });
        of_mission.chain(own).collect()
    }
}

impl Limit {
    /// This limit with bounds that are wider by this much, in its SI unit.
    pub fn widened(&self, by: f64) -> Limit {
        Limit { lower: self.lower.map(|b| b - by), upper: self.upper.map(|b| b + by), ..self.clone() }
    }
}

impl LimitKind {
    /// Whether a limit of the mission on it holds after a fault too. Those on attitude, yaw and accelerations serve the
    /// mission's task: what the vehicle can do is decided by its admissible set.
    fn concerns_safety(&self) -> bool {
        match self {
            LimitKind::X | LimitKind::Y | LimitKind::Z => true,
            LimitKind::Speed | LimitKind::SpeedHorizontal | LimitKind::Climb | LimitKind::Descent => true,
            LimitKind::Face(_) | LimitKind::Distance(_) | LimitKind::Clearance(_) => true,
            LimitKind::Yaw | LimitKind::YawRate | LimitKind::YawAcceleration | LimitKind::Tilt => false,
            LimitKind::Acceleration | LimitKind::AccelerationHorizontal | LimitKind::Jerk => false,
            LimitKind::Arrival(_) | LimitKind::Heading(_) => false,
        }
    }
}

impl KeepOff {
    /// The gradient and the signed distance (m, negative inside) of a point from the area's outline.
    pub fn separation(&self, p: [f64; 2]) -> ([f64; 2], f64) {
        let each = self.bodies.iter().map(|body| body.seen_from_above(p));
        each.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(([1.0, 0.0], f64::INFINITY))
    }
}

impl AfterFaultRules {
    /// By how much a vehicle of this size (m) that touches down at a point is too close to an area to keep off, m, with
    /// the direction away from it; not positive where it is far enough from all.
    pub fn too_close(&self, p: [f64; 2], size: f64) -> ([f64; 2], f64) {
        let each = self.keep_off.iter().map(|area| {
            let (away, distance) = area.separation(p);
            (away, size + area.clearance - distance)
        });
        each.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(([1.0, 0.0], f64::NEG_INFINITY))
    }
}
