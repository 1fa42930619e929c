//! The premises of the theorem in docs/certificates.md, each checked in one place. Only a test disables them, one by
//! one, to show that a forgery is accepted without the premise.

/// A condition that every accepted certificate was checked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Premise {
    /// The certificate carries the hash of the spec given.
    Spec,
    /// The equations are those of the spec's `model`.
    Equations,
    /// Every number is finite, node times increase and every node has all derivatives.
    Shape,
    /// Start, end, fixed times, holds and the shares of legs are the spec's.
    Times,
    /// Rows are checked at least as densely as the spec's samples.
    Density,
    /// The pieces join.
    Joints,
    /// Derivatives vanish where the spec requires rest.
    Rest,
    /// Every waypoint is met.
    Waypoints,
    /// Every limit is satisfied.
    Limits,
    /// The wrench stays in the sets that the spec's planner imposes.
    Sets,
    /// The commanded wrench of lagging rotors stays in these sets too.
    Commands,
    /// Hover, about which a reserve shrinks sets, lies in them.
    Reserve,
    /// The motion stays in the cores of modes without yaw.
    Cores,
    /// The range of spins of a core is one that the body cannot leave, and the motion's own rate lies in it.
    Spin,
    /// The thrust's vertical part stays above a tenth of the weight.
    Upright,
    /// RSP: the certificate includes the plans from which facets are selected, and they are plans.
    SelectedBy,
    /// RSP: the motion satisfies every facet that they violate.
    Selection,
    /// Multipliers lie in the dual cone.
    DualCone,
    /// Rows are those that every plan of the spec satisfies.
    Rows,
    /// A facet's normal and offset are those of its rotors.
    Facets,
    /// Inputs that the multipliers do not cancel count with their bounds.
    Inputs,
    /// No least time is above the bound from distances, limits and thrust.
    LeastTime,
    /// The families of ways out of a mode follow each other, and take in every delay.
    WayFollows,
    /// Ways out take no longer than the spec allows.
    WayTime,
    /// They begin where a fault can bring the vehicle.
    WayStart,
    /// They stay inside the mode's set and within the limits after a fault.
    WayRows,
    /// They lead to where they say.
    WayEnd,
}

impl Premise {
    pub const ALL: [Premise; 27] = [
        Premise::Spec,
        Premise::Equations,
        Premise::Shape,
        Premise::Times,
        Premise::Density,
        Premise::Joints,
        Premise::Rest,
        Premise::Waypoints,
        Premise::Limits,
        Premise::Sets,
        Premise::Reserve,
        Premise::Cores,
        Premise::Spin,
        Premise::Commands,
        Premise::Upright,
        Premise::SelectedBy,
        Premise::Selection,
        Premise::DualCone,
        Premise::Rows,
        Premise::Facets,
        Premise::Inputs,
        Premise::LeastTime,
        Premise::WayFollows,
        Premise::WayTime,
        Premise::WayStart,
        Premise::WayRows,
        Premise::WayEnd,
    ];
}

/// The premises that are checked: all of them, outside the tests of the checker itself.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Premises {
    without: Option<Premise>,
}

impl Premises {
    /// All but one. A certificate accepted under these proves nothing.
    pub fn without(premise: Premise) -> Self {
        Premises { without: Some(premise) }
    }

    pub(super) fn has(self, premise: Premise) -> bool {
        self.without != Some(premise)
    }
}
