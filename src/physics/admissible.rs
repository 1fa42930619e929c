//! The admissible set of each fault mode, that is, the exact set of wrenches that the vehicle can produce in it, and
//! what follows from the set: verdicts, margins, allocation, intervals. See `docs/method/sets.md` and `verdicts.md`.

pub mod airspeed;
pub mod allocation;
pub mod diagnose;
pub mod edge;
pub mod interval;
pub mod outcome;
pub mod parallel;
pub mod pseudo_inverse;
pub mod row;
pub mod verdict;
pub mod without_yaw;

use crate::actuation::{Actuation, Wrench};
use crate::cancel;
use crate::flatness::rotor_drag;
use crate::geometry::polytope::{Equality, Facet, Polytope, intersect};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::{Allocation, Environment, Model};
use std::fmt;

/// The name of the mode without faults.
pub const HEALTHY: &str = "healthy";

/// The facet of a mode's set that a row comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct FacetOf {
    /// 0 is the healthy vehicle, i + 1 is `Model::modes[i]`.
    pub mode: usize,
    /// Index into the facets of the mode's [`AdmissibleSet::polytope`].
    pub facet: usize,
    /// The rotors that span the facet; on the facet all others are at a bound.
    pub spanning: Spanning,
}

/// The set of wrenches [T, tau_x, tau_y, tau_z] (N, N m) that the vehicle can produce in a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct AdmissibleSet {
    /// 0 is the healthy vehicle, i + 1 is `Model::modes[i]`.
    pub mode: usize,
    /// The name of the mode; [`HEALTHY`] for the healthy vehicle.
    pub name: String,
    /// All wrenches that rotor speeds within their bounds give; one generator for each rotor.
    pub zonotope: Zonotope<4>,
    /// Half-space description of the set. With [`Allocation::Bounded`] it describes `zonotope`; with
    /// [`Allocation::PseudoInverse`] only the wrenches for which (42) clips no rotor speed.
    pub polytope: Polytope<4, FacetOf>,
    /// How wrenches are allocated to the rotors.
    pub allocation: Allocation,
    /// Dimension of the zonotope, at most 4.
    pub rank: usize,
    /// The hover wrench [m g, 0, 0, 0].
    pub hover: Wrench,
}

impl AdmissibleSet {
    /// The set of `model.modes[index]`, or of the healthy vehicle for `None`.
    fn new(model: &Model, index: Option<usize>) -> Self {
        let actuation = Actuation::of(&model.vehicle);
        cancel::checkpoint();
        let fault = index.map(|i| &model.modes[i]);
        let (offset, generators) = fault.map_or_else(|| actuation.healthy(), |f| actuation.under(f));
        let (mode, name) = (index.map_or(0, |i| i + 1), fault.map_or(HEALTHY, |f| &f.name));
        let zonotope = Zonotope { offset, generators };
        let mut description = zonotope.facets();
        let rank = 4 - description.equalities.len();
        let allocation = model.vehicle.allocation;
        if allocation == Allocation::PseudoInverse {
            description.facets = pseudo_inverse::facets(&actuation, fault, &zonotope, &description.equalities);
        }
        let Polytope { equalities, facets } = description;
        let facets = facets
            .into_iter()
            .enumerate()
            .map(|(facet, f)| Facet {
                normal: f.normal,
                offset: f.offset,
                origin: FacetOf { mode, facet, spanning: f.origin },
            })
            .collect();
        AdmissibleSet {
            mode,
            name: name.into(),
            zonotope,
            polytope: Polytope { equalities, facets },
            allocation,
            rank,
            hover: hover(model),
        }
    }

    /// The set of the healthy vehicle.
    pub fn healthy(model: &Model) -> Self {
        Self::new(model, None)
    }

    /// The set of `model.modes[index]`.
    ///
    /// # Panics
    /// If the model has no mode with this index.
    pub fn of_mode(model: &Model, index: usize) -> Self {
        Self::new(model, Some(index))
    }

    /// The set of the healthy vehicle, then that of every declared mode. Each is computed when the iterator reaches it,
    /// because all of them together may not fit in memory.
    pub fn each(model: &Model) -> impl Iterator<Item = Self> {
        std::iter::once(Self::healthy(model)).chain((0..model.modes.len()).map(|i| Self::of_mode(model, i)))
    }

    /// The sets of [`AdmissibleSet::each`], collected.
    pub fn all(model: &Model) -> Vec<Self> {
        Self::each(model).collect()
    }

    /// The set shrunk about hover, so that feedback keeps the share `reserve` (0 to 1) of the way to each facet:
    /// `n.w <= n.h + (1 - reserve) (e - n.h)`.
    pub fn with_reserve(&self, reserve: f64) -> Self {
        let mut kept = self.clone();
        if reserve > 0.0 {
            kept.polytope = kept.polytope.shrink_about(&self.hover, reserve);
        }
        kept
    }
}

/// The hover wrench [m g, 0, 0, 0], N and N m; with drag that of hover in the middle of the possible winds
/// ([`trimmed`]).
pub fn hover(model: &Model) -> Wrench {
    trimmed(model, &model.environment())
}

/// The wrench at rest in a wind, [m |g e_z - drag/m wind|, 0, 0, 0], N and N m: the thrust is tilted against the wind.
/// With a drag for each axis of the body the thrust is that of (90c), at the yaw of the start where it depends on yaw.
pub fn trimmed(model: &Model, environment: &Environment) -> Wrench {
    let [x, y, z] = environment.trim();
    let thrust = match environment.has_drag() {
        true if environment.is_isotropic() => (x * x + y * y + z * z).sqrt(),
        true => rotor_drag::attitude(environment, [0.0; 3], [0.0; 3], environment.yaw_at_rest).thrust,
        false => environment.gravity,
    };
    Wrench::new(model.vehicle.mass * thrust, 0.0, 0.0, 0.0)
}

/// The mass (kg) that a thrust (N) holds at rest in the middle of the possible winds: the inverse of [`hover`]. `None`
/// if the wind is too strong for any mass.
pub fn mass_at_rest(model: &Model, thrust: f64) -> Option<f64> {
    let environment = model.environment();
    let Environment { gravity, wind: [x, y, z], .. } = environment;
    if !environment.has_drag() {
        return Some(thrust / gravity);
    }
    if !environment.is_isotropic() {
        return heaviest_at_rest(model, &environment, thrust);
    }
    let drag = model.vehicle.drag[0];
    let lift = (thrust * thrust - drag * drag * (x * x + y * y)).sqrt();
    let mass = (drag * z + lift) / gravity;
    (mass > 0.0).then_some(mass)
}

/// [`mass_at_rest`] with a drag for each axis of the body, by bisection: between the mass whose weight a vertical wind
/// carries and the one that this thrust cannot hold whatever the wind, the thrust at rest increases with the mass.
fn heaviest_at_rest(model: &Model, environment: &Environment, thrust: f64) -> Option<f64> {
    let drag = model.vehicle.drag;
    let largest = drag.into_iter().fold(0.0, f64::max);
    let speed = environment.wind.iter().map(|w| w * w).sum::<f64>().sqrt();
    let at = |mass: f64| {
        let of_mass = Environment { drag_rates: drag.map(|d| d / mass), ..*environment };
        mass * rotor_drag::attitude(&of_mass, [0.0; 3], [0.0; 3], environment.yaw_at_rest).thrust
    };
    let high = (thrust + largest * speed) / environment.gravity;
    let low = (largest * environment.wind[2]).max(0.0) / environment.gravity;
    let (mut low, mut high) = (low + LEAST_MASS * high, high * (1.0 + LEAST_MASS));
    // Not so where the thrust is negative or too large at once.
    if !(at(low) <= thrust && at(high) >= thrust) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if at(middle) <= thrust { low = middle } else { high = middle }
    }
    Some(low)
}

/// Shares of an upper bound on the mass: the smallest mass that is tried, and by how much the largest exceeds the
/// bound.
const LEAST_MASS: f64 = 1e-6;

/// Halvings of an interval of masses, down to rounding.
const HALVINGS: usize = 60;

/// Whether the set of every fault mode lies inside the healthy set.
///
/// This is false if some rotor may not stop, because a vehicle that lost a rotor can then produce less thrust than the
/// healthy one. It is also false with the pseudo-inverse, which distributes a wrench differently once the fault is
/// known.
pub fn faults_only_take(model: &Model) -> bool {
    model.vehicle.allocation == Allocation::Bounded && model.vehicle.rotors.iter().all(|r| r.min_speed <= 0.0)
}

/// The rows that a planner imposes; each facet lists the facets of all modes that lie in its plane.
type Intersection = Polytope<4, Vec<FacetOf>>;

/// The minimal description of the intersection of several sets. Each set must contain hover.
///
/// # Panics
/// If `sets` is empty.
pub fn intersection(sets: &[&AdmissibleSet]) -> Intersection {
    let scale = sets[0].zonotope.scale();
    let polytopes: Vec<_> = sets.iter().map(|s| &s.polytope).collect();
    intersect(&polytopes, &sets[0].hover, &scale)
}

/// Writes an equality or facet: the coefficients of [T, tau_x, tau_y, tau_z], the relation and the offset.
fn row(f: &mut fmt::Formatter<'_>, n: &Wrench, relation: &str, offset: f64) -> fmt::Result {
    let clean = |v: f64| if v.abs() < 5e-10 { 0.0 } else { v };
    write!(f, "  ")?;
    for v in n.iter() {
        write!(f, "{:>13.9} ", clean(*v))?;
    }
    write!(f, "{relation} {:>12.6}", clean(offset))
}

pub(crate) fn write_equality(f: &mut fmt::Formatter<'_>, e: &Equality<4>) -> fmt::Result {
    row(f, &e.normal, "= ", e.offset)
}

pub(crate) fn write_facet<O>(f: &mut fmt::Formatter<'_>, facet: &Facet<4, O>) -> fmt::Result {
    row(f, &facet.normal, "<=", facet.offset)
}

impl fmt::Display for AdmissibleSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{}: dimension {}, {} facets, {} equalities",
            self.name,
            self.rank,
            self.polytope.facets.len(),
            self.polytope.equalities.len()
        )?;
        for e in &self.polytope.equalities {
            write_equality(f, e)?;
            writeln!(f)?;
        }
        for facet in &self.polytope.facets {
            write_facet(f, facet)?;
            let rotors: Vec<String> = facet.origin.spanning.generators().map(|k| (k + 1).to_string()).collect();
            writeln!(f, "   rotors {}", rotors.join(" "))?;
        }
        Ok(())
    }
}
