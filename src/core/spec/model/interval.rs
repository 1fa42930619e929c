//! Values known only to an interval.

use super::{Model, Vehicle};
use crate::language::{Entry, table};

/// The smallest and largest possible value, as multiples of the middle: 0 < low <= 1 <= high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    pub low: f64,
    pub high: f64,
}

impl Spread {
    /// The value is known exactly.
    pub const NONE: Spread = Spread { low: 1.0, high: 1.0 };

    pub fn is_none(self) -> bool {
        self == Spread::NONE
    }

    /// The spread of a product.
    pub fn times(self, other: Spread) -> Spread {
        Spread { low: self.low * other.low, high: self.high * other.high }
    }

    /// The spread of a quotient of two independent values.
    pub fn over(self, other: Spread) -> Spread {
        Spread { low: self.low / other.high, high: self.high / other.low }
    }
}

impl Default for Spread {
    fn default() -> Self {
        Spread::NONE
    }
}

/// The spreads that follow from the intervals on a rotor's coefficients and speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotorSpread {
    /// Spread of b w_max^2.
    pub full_thrust: Spread,
    /// Spread of b w_min^2.
    pub idle_thrust: Spread,
    /// Spread of d/b.
    pub torque_per_thrust: Spread,
}

impl Vehicle {
    /// Whether the mass or some rotor has an interval.
    pub fn is_uncertain(&self) -> bool {
        !self.mass_spread.is_none() || self.has_uncertain_rotors()
    }

    /// Whether the mass, some rotor or a [`DynamicFigure`] has an interval.
    pub fn has_intervals(&self) -> bool {
        self.is_uncertain() || DynamicFigure::ALL.iter().any(|figure| !figure.spread(self).is_none())
    }

    /// Whether some rotor has an interval of what it gives.
    pub fn has_uncertain_rotors(&self) -> bool {
        self.rotors.iter().any(|r| r.spread != RotorSpread::default())
    }
}

/// A figure with an interval that the sets of thrusts do not know: verdicts and flights take it at an end or in the
/// middle, and a change of an outcome inside the interval is named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DynamicFigure {
    /// `drag`, along all axes at the same share.
    Drag,
    /// `yaw_drag`, its linear part.
    YawDrag,
    /// `rotor_inertia` of all rotors at the same share: the interval is that of one kind of propeller and motor.
    RotorInertia,
}

impl DynamicFigure {
    pub const ALL: [DynamicFigure; 3] = [DynamicFigure::Drag, DynamicFigure::YawDrag, DynamicFigure::RotorInertia];

    /// Its row of the language.
    pub fn entry(self) -> &'static Entry {
        match self {
            DynamicFigure::Drag => &table::vehicle::DRAG,
            DynamicFigure::YawDrag => &table::vehicle::YAW_DRAG,
            DynamicFigure::RotorInertia => &table::rotor::ROTOR_INERTIA,
        }
    }

    /// Its interval; that of rotors is the widest of them.
    pub fn spread(self, vehicle: &Vehicle) -> Spread {
        match self {
            DynamicFigure::Drag => vehicle.drag_spread,
            DynamicFigure::YawDrag => vehicle.yaw_drag.map_or(Spread::NONE, |drag| drag.spread),
            DynamicFigure::RotorInertia => {
                let widest = |a: Spread, b: Spread| if b.high - b.low > a.high - a.low { b } else { a };
                vehicle.rotors.iter().map(|rotor| rotor.inertia_spread).fold(Spread::NONE, widest)
            }
        }
    }

    /// The largest value of the figure along axes or over rotors, in SI units, in the middle of its interval; 0 if the
    /// vehicle does not have it.
    pub fn largest(self, vehicle: &Vehicle) -> f64 {
        match self {
            DynamicFigure::Drag => vehicle.drag.into_iter().fold(0.0, f64::max),
            DynamicFigure::YawDrag => vehicle.yaw_drag.map_or(0.0, |drag| drag.linear),
            DynamicFigure::RotorInertia => vehicle.rotors.iter().map(|rotor| rotor.inertia).fold(0.0, f64::max),
        }
    }

    /// Gives the figure one value of its interval: `share` is 0 at its lower end and 1 at its upper one.
    pub fn place(self, vehicle: &mut Vehicle, share: f64) {
        let within = |Spread { low, high }: Spread| low + share * (high - low);
        match self {
            DynamicFigure::Drag => {
                let factor = within(vehicle.drag_spread);
                (vehicle.drag, vehicle.drag_spread) = (vehicle.drag.map(|drag| factor * drag), Spread::NONE);
            }
            DynamicFigure::YawDrag => {
                if let Some(drag) = &mut vehicle.yaw_drag {
                    (drag.linear, drag.spread) = (within(drag.spread) * drag.linear, Spread::NONE);
                }
            }
            DynamicFigure::RotorInertia => {
                for rotor in &mut vehicle.rotors {
                    rotor.inertia *= within(rotor.inertia_spread);
                    rotor.inertia_spread = Spread::NONE;
                }
            }
        }
    }

    /// Gives the figure the middle of its interval alone.
    pub fn place_middle(self, vehicle: &mut Vehicle) {
        match self {
            DynamicFigure::Drag => vehicle.drag_spread = Spread::NONE,
            DynamicFigure::YawDrag => {
                if let Some(drag) = &mut vehicle.yaw_drag {
                    drag.spread = Spread::NONE;
                }
            }
            DynamicFigure::RotorInertia => {
                vehicle.rotors.iter_mut().for_each(|rotor| rotor.inertia_spread = Spread::NONE);
            }
        }
    }
}

impl Model {
    /// The model with one value of a figure's interval in the vehicle, and in flights where they fly with the drag of
    /// the vehicle: `share` is 0 at the lower end of the interval and 1 at the upper one.
    pub fn at(&self, figure: DynamicFigure, share: f64) -> Model {
        let mut model = self.clone();
        let flies_its_own = model.simulation.drag == model.vehicle.drag;
        figure.place(&mut model.vehicle, share);
        if flies_its_own {
            model.simulation.drag = model.vehicle.drag;
        }
        model
    }
}
