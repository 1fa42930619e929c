//! What each fault mode leaves: the exact set of wrenches, and what follows from it.

pub mod allocation;
pub mod diagnose;
pub mod edge;
pub mod interval;
pub mod parallel;
pub mod pseudo_inverse;
pub mod row;
pub mod verdict;

use crate::actuation::{Actuation, Wrench};
use crate::geometry::polytope::{Equality, Facet, Polytope, intersect};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::{Allocation, Model};
use std::fmt;

/// The mode of the vehicle without faults.
pub const HEALTHY: &str = "healthy";

/// Where a row of a set comes from: a mode (0 is healthy, i + 1 is `Model::modes[i]`) and a facet of its set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct FacetOf {
    pub mode: usize,
    pub facet: usize,
    /// The rotors that span the facet; all others stand at a bound on it.
    pub spanning: Spanning,
}

/// The wrenches [T, tau_x, tau_y, tau_z] (N, N m) that a mode can produce.
#[derive(Debug, Clone, PartialEq)]
pub struct AdmissibleSet {
    /// 0 is healthy, i + 1 is `Model::modes[i]`.
    pub mode: usize,
    pub name: String,
    pub zonotope: Zonotope<4>,
    pub polytope: Polytope<4, FacetOf>,
    /// How wrenches are allocated: with [`Allocation::Bounded`] every wrench of the zonotope is given, and `polytope`
    /// describes it; with [`Allocation::PseudoInverse`] `polytope` holds only those that nothing is clipped for.
    pub allocation: Allocation,
    /// Dimension of the zonotope.
    pub rank: usize,
    /// [m g, 0, 0, 0].
    pub hover: Wrench,
}

impl AdmissibleSet {
    /// The set of a mode, or of the healthy vehicle; `index` counts modes from 0.
    fn new(model: &Model, index: Option<usize>) -> Self {
        let actuation = Actuation::of(&model.vehicle);
        let fault = index.map(|i| &model.modes[i]);
        let (center, generators) = fault.map_or_else(|| actuation.healthy(), |f| actuation.under(f));
        let (mode, name) = (index.map_or(0, |i| i + 1), fault.map_or(HEALTHY, |f| &f.name));
        let zonotope = Zonotope { center, generators };
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
    pub fn of_mode(model: &Model, index: usize) -> Self {
        Self::new(model, Some(index))
    }

    /// Healthy first, then every declared mode; each is made when it is its turn, for all at once may not fit in memory.
    pub fn each(model: &Model) -> impl Iterator<Item = Self> {
        std::iter::once(Self::healthy(model)).chain((0..model.modes.len()).map(|i| Self::of_mode(model, i)))
    }

    /// The same, all at once.
    pub fn all(model: &Model) -> Vec<Self> {
        Self::each(model).collect()
    }

    /// The set shrunk about hover, keeping `reserve` (0..1) of it for feedback.
    pub fn with_reserve(&self, reserve: f64) -> Self {
        let mut kept = self.clone();
        if reserve > 0.0 {
            kept.polytope = kept.polytope.shrink_about(&self.hover, reserve);
        }
        kept
    }
}

/// The hover wrench [m g, 0, 0, 0].
pub fn hover(model: &Model) -> Wrench {
    Wrench::new(model.vehicle.mass * model.gravity, 0.0, 0.0, 0.0)
}

/// Whether every fault set lies inside the healthy one, whatever the mode: losing thrust then only takes wrenches
/// away. It does not hold for rotors that may not stop, for lost ones give less than the healthy vehicle can, nor for
/// the pseudo-inverse, which shares a wrench out otherwise once it knows of a fault.
pub fn faults_only_take(model: &Model) -> bool {
    model.vehicle.allocation == Allocation::Bounded && model.vehicle.rotors.iter().all(|r| r.min_speed == 0.0)
}

/// The rows a planner imposes: equalities, then facets with all the facets each stands for.
pub type Intersection = Polytope<4, Vec<FacetOf>>;

/// Minimal description of the intersection of several sets that all hold hover.
pub fn intersection(sets: &[&AdmissibleSet]) -> Intersection {
    let scale = sets[0].zonotope.scale();
    let polytopes: Vec<_> = sets.iter().map(|s| &s.polytope).collect();
    intersect(&polytopes, &sets[0].hover, &scale)
}

/// One equality or facet as text, coefficients of [T, tau_x, tau_y, tau_z].
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
