//! Verdicts of section 3.2 with margins: what a mode can still do about hover.

use super::edge::{self, Place};
use super::interval::{Robust, robust};
use super::parallel::{Parallel, nearest_rows};
use super::{AdmissibleSet, hover};
use crate::actuation::Wrench;
use crate::geometry::polytope::Polytope;
use crate::geometry::zonotope::Zonotope;
use crate::model::{Allocation, Model};
use nalgebra::{SVector, Vector3};
use serde::Serialize;

/// Chords are measured to this share of the set's thrust range.
const ROUNDING: f64 = 1e-9;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Hover is reachable.
    Controllable,
    /// Hover is reachable when yaw is given up.
    Stabilizable,
    Unstable,
}

impl Verdict {
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Controllable => "controllable",
            Verdict::Stabilizable => "stabilizable",
            Verdict::Unstable => "unstable",
        }
    }
}

/// Distances from hover to the boundary along an axis: [down, up], both at least 0; N or N m.
pub type BothWays = [f64; 2];

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Headroom {
    pub thrust: BothWays,
    pub tau_x: BothWays,
    pub tau_y: BothWays,
    pub tau_z: BothWays,
}

/// One mode's record; the fields of `mavc analyze --format json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeAnalysis {
    pub name: String,
    /// Rotors with capacity 0, from 1.
    pub lost: Vec<usize>,
    pub capacity: Vec<f64>,
    pub stuck: Vec<Option<f64>>,
    pub verdict: Verdict,
    /// Where hover lies relative to the set that the verdict is about: the yaw-free set for stabilizable.
    pub hover: Place,
    /// Whether it lies inside.
    pub interior: bool,
    /// Dimension of the set.
    pub rank: usize,
    /// Inequalities of the minimal description; `None` where the set is flat.
    pub facets: Option<usize>,
    /// Available control authority index (Du, Quan, Cai 2015): signed distance from hover to the boundary
    /// in the plain (N, N m) norm, outside the most violated facet's negative slack; `None` where flat.
    pub acai: Option<f64>,
    /// The same in (T, tau_x, tau_y).
    pub acai_yaw_free: Option<f64>,
    /// Heaviest mass that hovers, kg; `None` where no mass does.
    pub critical_mass_kg: Option<f64>,
    pub critical_mass_yaw_free_kg: Option<f64>,
    /// Lightest mass that hovers, kg: above 0 where rotors may not stop or are stuck.
    pub least_mass_kg: Option<f64>,
    /// e_p = A Omega_s - u_ref of (31), [N, N m, N m, N m].
    pub residual4: [f64; 4],
    /// The same without tau_z.
    pub residual3: [f64; 3],
    /// `None` where hover is outside the set.
    pub headroom: Option<Headroom>,
    /// Share of the zonotope's volume that the pseudo-inverse does not reach without clipping; `None` with the bounded
    /// allocation, which reaches all, and where the set is flat.
    pub given_away: Option<f64>,
    /// The two rows of the actuation matrix at the smallest angle.
    pub nearest_rows: Option<Parallel>,
    /// What the spec's intervals make of it; `None` where it has none.
    pub robust: Option<Robust>,
}

impl ModeAnalysis {
    /// Whether the mode keeps full control at hover with some of it to spare. Only such modes can keep a reserve.
    pub fn keeps_full_control(&self) -> bool {
        self.verdict == Verdict::Controllable && self.hover == Place::Inside
    }

    /// Where hover lies relative to the mode's set with every axis held, yaw too.
    pub fn hover_all_axes(&self) -> Place {
        if self.verdict == Verdict::Controllable { self.hover } else { Place::Outside }
    }

    /// `inside`, `on the edge, yaw free`: where hover lies, in the words of every report.
    pub fn hover_words(&self) -> String {
        let free = if self.verdict == Verdict::Stabilizable { ", yaw free" } else { "" };
        format!("{}{free}", self.hover.word())
    }
}

/// Analyses every set in `sets` (healthy first, as [`AdmissibleSet::all`] gives them).
pub fn analyze_all(model: &Model, sets: &[AdmissibleSet]) -> Vec<ModeAnalysis> {
    sets.iter().map(|s| analyze(model, s)).collect()
}

/// Analyses every set of a spec, healthy first, one at a time.
pub fn analyze_each(model: &Model) -> Vec<ModeAnalysis> {
    AdmissibleSet::each(model).map(|set| analyze(model, &set)).collect()
}

/// The record of one mode, with the residual e_p of (31).
pub fn analyze(model: &Model, set: &AdmissibleSet) -> ModeAnalysis {
    let rotors = model.vehicle.rotors.len();
    let (lost, capacity, stuck) = match set.mode.checked_sub(1) {
        Some(i) => (model.modes[i].lost(), model.modes[i].capacity.clone(), model.modes[i].stuck.clone()),
        None => (Vec::new(), vec![1.0; rotors], vec![None; rotors]),
    };
    let u_ref = hover(model);
    let u_ref3 = u_ref.fixed_rows::<3>(0).into_owned();
    let Reach { nearest, nearest3, yaw_free } = Reach::of(set, &u_ref, &u_ref3);
    let edge = edge::width(&u_ref);
    let residual4 = clean(nearest - u_ref, edge);
    let residual3 = clean(nearest3 - u_ref3, edge);
    let verdict = if residual4.norm() < edge {
        Verdict::Controllable
    } else if residual3.norm() < edge {
        Verdict::Stabilizable
    } else {
        Verdict::Unstable
    };
    let size = set.zonotope.scale()[0];
    let acai = signed_margin(&set.polytope, &u_ref, edge);
    let acai_yaw_free = signed_margin(&yaw_free, &u_ref3, edge);
    let hover = match verdict {
        Verdict::Controllable => Place::new(acai, residual4.norm(), edge),
        Verdict::Stabilizable => Place::new(acai_yaw_free, residual3.norm(), edge),
        Verdict::Unstable => Place::Outside,
    };
    ModeAnalysis {
        name: set.name.clone(),
        lost,
        capacity,
        stuck,
        verdict,
        hover,
        interior: hover == Place::Inside,
        rank: set.rank,
        facets: set.polytope.equalities.is_empty().then_some(set.polytope.facets.len()),
        acai,
        acai_yaw_free,
        critical_mass_kg: heaviest(&set.polytope, size).map(|t| t / model.gravity),
        critical_mass_yaw_free_kg: heaviest(&yaw_free, size).map(|t| t / model.gravity),
        least_mass_kg: lift(&set.polytope, size).map(|(low, _)| low / model.gravity),
        residual4: residual4.into(),
        residual3: residual3.into(),
        headroom: (verdict == Verdict::Controllable).then(|| headroom(set, &u_ref, size)),
        given_away: given_away(set),
        nearest_rows: nearest_rows(set),
        robust: robust(model, set),
    }
}

/// What the verdict is made of: the points nearest to hover, and the rows of the shadow.
struct Reach {
    nearest: Wrench,
    nearest3: Vector3<f64>,
    yaw_free: Polytope<3, ()>,
}

impl Reach {
    fn of(set: &AdmissibleSet, hover: &Wrench, hover3: &Vector3<f64>) -> Self {
        let shadow = without_yaw(&set.zonotope);
        let by_zonotope = || Reach {
            nearest: set.zonotope.nearest(hover),
            nearest3: shadow.nearest(hover3),
            yaw_free: shadow.facets().without_origins(),
        };
        let by_rows = || {
            let inside = set.polytope.nearest(hover);
            let yaw_free = set.polytope.shadow(inside.as_ref(), &set.zonotope.scale());
            // Where idling rotors stand in its way the pseudo-inverse gives nothing unclipped; all idling is what is left.
            Reach {
                nearest: inside.unwrap_or(set.zonotope.center),
                nearest3: yaw_free.nearest(hover3).unwrap_or(shadow.center),
                yaw_free,
            }
        };
        match set.allocation {
            Allocation::Bounded => by_zonotope(),
            Allocation::PseudoInverse => by_rows(),
        }
    }
}

/// The shadow of the set in (T, tau_x, tau_y): what can be had when tau_z is left free.
pub fn without_yaw(zonotope: &Zonotope<4>) -> Zonotope<3> {
    let drop = |w: &Wrench| Vector3::new(w[0], w[1], w[2]);
    Zonotope { center: drop(&zonotope.center), generators: zonotope.generators.iter().map(drop).collect() }
}

/// Rounding dust in a residual is zero.
fn clean<const D: usize>(e: SVector<f64, D>, edge: f64) -> SVector<f64, D> {
    if e.norm() < edge { SVector::zeros() } else { e.map(|v| if v.abs() < 1e-12 { 0.0 } else { v }) }
}

/// Signed distance to the boundary; `None` where the set is flat, exactly 0 on the boundary.
fn signed_margin<const D: usize, O: Clone>(polytope: &Polytope<D, O>, at: &SVector<f64, D>, edge: f64) -> Option<f64> {
    if !polytope.equalities.is_empty() {
        return None;
    }
    let margin = polytope.margin(at);
    Some(if margin.abs() <= edge { 0.0 } else { margin })
}

/// Least and largest T >= 0 with [T, 0, ...] in the set, N.
fn lift<const D: usize, O: Clone>(polytope: &Polytope<D, O>, size: f64) -> Option<(f64, f64)> {
    let mut thrust = SVector::<f64, D>::zeros();
    thrust[0] = 1.0;
    let (low, high) = polytope.chord(&SVector::zeros(), &thrust, ROUNDING * size)?;
    let dust = |t: f64| if t <= ROUNDING * size { 0.0 } else { t };
    (high >= -ROUNDING * size).then(|| (dust(low), dust(high)))
}

/// Largest T with [T, 0, ...] in the set, N.
fn heaviest<const D: usize, O: Clone>(polytope: &Polytope<D, O>, size: f64) -> Option<f64> {
    lift(polytope, size).map(|(_, high)| high)
}

/// See [`ModeAnalysis::given_away`].
fn given_away(set: &AdmissibleSet) -> Option<f64> {
    if set.allocation == Allocation::Bounded || !set.polytope.equalities.is_empty() {
        return None;
    }
    let middle = set.zonotope.center + 0.5 * set.zonotope.generators.iter().sum::<Wrench>();
    let kept = match set.polytope.nearest(&middle) {
        Some(inside) => set.polytope.volume(&inside, &set.zonotope.scale()),
        None => 0.0,
    };
    Some((1.0 - kept / set.zonotope.volume()).clamp(0.0, 1.0))
}

fn headroom(set: &AdmissibleSet, at: &Wrench, size: f64) -> Headroom {
    let along = |axis: usize| {
        let mut direction = Wrench::zeros();
        direction[axis] = 1.0;
        match set.polytope.chord(at, &direction, ROUNDING * size) {
            Some((low, high)) => [low, high].map(|t| if t.abs() <= ROUNDING * size { 0.0 } else { t.abs() }),
            None => [0.0, 0.0],
        }
    };
    Headroom { thrust: along(0), tau_x: along(1), tau_y: along(2), tau_z: along(3) }
}
