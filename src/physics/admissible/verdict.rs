//! The paper's verdicts (its section 3.2) with margins: whether a mode can hover. See `docs/method/verdicts.md`.

use super::airspeed::Airspeed;
use super::edge::{self, HoverPlace};
use super::interval::{Robust, robust};
use super::outcome::{Outcome, Verdicts};
use super::parallel::{Parallel, nearest_rows};
use super::without_yaw::{self, WithoutYaw, YawFree};
use super::{AdmissibleSet, hover, mass_at_rest};
use crate::actuation::Wrench;
use crate::geometry::polytope::Polytope;
use crate::geometry::zonotope::Zonotope;
use crate::model::{Allocation, Model};
use nalgebra::{SVector, Vector3};
use serde::Serialize;

/// Tolerance of chords, as a share of the set's extent in thrust.
const ROUNDING: f64 = 1e-9;

/// Whether hover can be reached, by the residual (31).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum HoverVerdict {
    /// Hover is in the set.
    Controllable,
    /// Hover is in the projection of the set on (T, tau_x, tau_y), that is, if yaw is given up.
    Stabilizable,
    /// Hover cannot be reached.
    Unstable,
}

#[deprecated = "renamed to `HoverVerdict`"]
pub type Verdict = HoverVerdict;

impl HoverVerdict {
    /// The word that reports print.
    pub fn name(self) -> &'static str {
        match self {
            HoverVerdict::Controllable => "controllable",
            HoverVerdict::Stabilizable => "stabilizable",
            HoverVerdict::Unstable => "unstable",
        }
    }
}

/// Distances from hover to the boundary along an axis, [down, up], both at least 0; N for thrust, N m for torques.
type BothWays = [f64; 2];

/// Distances from hover to the boundary along each axis, with the other three axes held. Each is [down, up], at least
/// 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Headroom {
    /// Along T, N.
    #[cfg_attr(test, schemars(inner(range(min = 0))))]
    pub thrust: BothWays,
    /// Along tau_x, N m.
    #[cfg_attr(test, schemars(inner(range(min = 0))))]
    pub tau_x: BothWays,
    /// Along tau_y, N m.
    #[cfg_attr(test, schemars(inner(range(min = 0))))]
    pub tau_y: BothWays,
    /// Along tau_z, N m.
    #[cfg_attr(test, schemars(inner(range(min = 0))))]
    pub tau_z: BothWays,
}

/// The analysis of one mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModeAnalysis {
    /// The name of the mode; the vehicle without faults is `healthy`.
    pub name: String,
    /// Rotors with capacity 0, counted from 1.
    #[cfg_attr(test, schemars(inner(range(min = 1))))]
    pub lost: Vec<usize>,
    /// The capacity theta_k of (32) of each rotor, in the spec's order; 1 for stuck rotors.
    #[cfg_attr(test, schemars(inner(range(min = 0, max = 1))))]
    pub capacity: Vec<f64>,
    /// For each rotor the share of full thrust at which it is stuck; null for a rotor that is not.
    #[cfg_attr(test, schemars(inner(range(min = 0, max = 1))))]
    pub stuck: Vec<Option<f64>>,
    /// What the mode leaves of the vehicle. Of the healthy vehicle: what it can do.
    pub outcome: Outcome,
    /// Whether hover can be reached.
    pub verdict: HoverVerdict,
    /// How the mode hovers with yaw given up.
    pub yaw_free: YawFree,
    /// Where hover lies relative to the set that the verdict is about: that of the full wrench, or of (T, tau_x,
    /// tau_y) where the verdict is stabilizable.
    pub hover: HoverPlace,
    /// Whether hover lies inside that set.
    pub interior: bool,
    /// Dimension of the set of wrenches.
    #[cfg_attr(test, schemars(range(max = 4)))]
    pub rank: usize,
    /// Number of facets of the minimal description; null if the set is flat.
    pub facets: Option<usize>,
    /// The margin, which is the available control authority index of Du and Quan (2015): the smallest facet slack of
    /// hover in the plain norm of N and N m. Inside it is the distance to the boundary; outside it is minus the
    /// largest violation of a facet. null if the set is flat.
    pub acai: Option<f64>,
    /// The margin in (T, tau_x, tau_y), for the yaw-free set, N and N m.
    pub acai_yaw_free: Option<f64>,
    /// The largest mass that can hover, kg; null if no mass can.
    pub critical_mass_kg: Option<f64>,
    /// The largest mass that can hover if yaw is given up, kg; null if no mass can.
    pub critical_mass_yaw_free_kg: Option<f64>,
    /// Lightest mass that can hover, kg; above 0 if rotors may not stop or are stuck. null if no mass can.
    pub least_mass_kg: Option<f64>,
    /// What the mode can do with yaw given up; null if `yaw_free` is `none`.
    pub without_yaw: Option<WithoutYaw>,
    /// The residual e_p = A Omega_s - u_ref of (31), [N, N m, N m, N m]; zero if hover can be reached.
    pub residual4: [f64; 4],
    /// The residual of (31) without tau_z, [N, N m, N m].
    pub residual3: [f64; 3],
    /// The largest steady airspeed in level flight with the plan's reserve; omitted for a vehicle without drag.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub airspeed: Option<Airspeed>,
    /// From hover to the boundary along each axis; null if hover is outside the set.
    pub headroom: Option<Headroom>,
    /// The share of the zonotope's volume that the pseudo-inverse does not reach without clipping. null with the
    /// bounded allocation, which reaches all of it, and if the set is flat.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub unreached_share: Option<f64>,
    /// The two rows of the actuation matrix with the smallest angle between them; null if fewer than two rows are
    /// nonzero.
    pub nearest_rows: Option<Parallel>,
    /// Verdict and margin over the spec's intervals; null if it has none.
    pub robust: Option<Robust>,
}

impl ModeAnalysis {
    /// Whether hover is controllable and strictly inside the set. Only such modes can keep a reserve.
    pub fn keeps_full_control(&self) -> bool {
        self.verdict == HoverVerdict::Controllable && self.hover == HoverPlace::Inside
    }

    /// Where hover lies relative to the mode's set with all four axes controlled, yaw included.
    pub fn hover_all_axes(&self) -> HoverPlace {
        if self.verdict == HoverVerdict::Controllable { self.hover } else { HoverPlace::Outside }
    }

    /// Where hover lies, in the words of all reports: for example `inside`, `on the edge, yaw free` or
    /// `spinning, yaw free`.
    pub(crate) fn hover_words(&self) -> String {
        let free = if self.verdict == HoverVerdict::Stabilizable { ", yaw free" } else { "" };
        format!("{}{free}", self.edge_words().unwrap_or(self.hover.word()))
    }

    /// What reports say of hover on the boundary of the verdict's set: `on the edge`, or `spinning` where this makes it
    /// controllable. `None` elsewhere.
    pub(crate) fn edge_words(&self) -> Option<&'static str> {
        match (self.hover, self.verdict) {
            (HoverPlace::OnEdge, HoverVerdict::Stabilizable) => Some(self.yaw_free.word()),
            (HoverPlace::OnEdge, _) => Some(self.hover.word()),
            _ => None,
        }
    }
}

/// Analyses the given sets, in their order.
pub fn analyze_all(model: &Model, sets: &[AdmissibleSet]) -> Vec<ModeAnalysis> {
    sets.iter().map(|s| analyze(model, s)).collect()
}

/// Analyses the healthy vehicle and every mode of a model, one at a time, without keeping the sets.
pub(crate) fn analyze_each(model: &Model) -> Vec<ModeAnalysis> {
    AdmissibleSet::each(model).map(|set| analyze(model, &set)).collect()
}

/// The outcome in the mode of one set of the model, before sensors are considered: that of [`analyze`] without its
/// figures, of which the equilibria take long.
pub fn outcome(model: &Model, set: &AdmissibleSet) -> Outcome {
    Standing::of(model, set).outcome
}

/// The words of a mode without its figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Standing {
    /// Before sensors are considered.
    pub outcome: Outcome,
    pub verdict: HoverVerdict,
    pub hover: HoverPlace,
    pub yaw_free: YawFree,
}

impl Standing {
    /// Those of [`analyze`].
    pub fn of(model: &Model, set: &AdmissibleSet) -> Self {
        let found = Basis::of(model, set);
        let verdicts = found.verdicts(model, set);
        Standing {
            outcome: Outcome::of(model, set, &verdicts),
            verdict: found.verdict,
            hover: found.hover,
            yaw_free: verdicts.yaw_free,
        }
    }
}

/// What the verdicts on a set follow from.
struct Basis {
    yaw_free: Polytope<3, ()>,
    residual4: Wrench,
    residual3: Vector3<f64>,
    acai: Option<f64>,
    acai_yaw_free: Option<f64>,
    verdict: HoverVerdict,
    hover: HoverPlace,
    place_yaw_free: HoverPlace,
}

impl Basis {
    fn of(model: &Model, set: &AdmissibleSet) -> Self {
        let u_ref = hover(model);
        let u_ref3 = u_ref.fixed_rows::<3>(0).into_owned();
        let Reach { nearest, nearest3, yaw_free } = Reach::of(set, &u_ref, &u_ref3);
        let edge = edge::width(&u_ref);
        let residual4 = clean(nearest - u_ref, edge);
        let residual3 = clean(nearest3 - u_ref3, edge);
        let verdict = if residual4.norm() < edge {
            HoverVerdict::Controllable
        } else if residual3.norm() < edge {
            HoverVerdict::Stabilizable
        } else {
            HoverVerdict::Unstable
        };
        let acai = signed_margin(&set.polytope, &u_ref, edge);
        let acai_yaw_free = signed_margin(&yaw_free, &u_ref3, edge);
        let place_yaw_free = HoverPlace::new(acai_yaw_free, residual3.norm(), edge);
        let hover = match verdict {
            HoverVerdict::Controllable => HoverPlace::new(acai, residual4.norm(), edge),
            HoverVerdict::Stabilizable => place_yaw_free,
            HoverVerdict::Unstable => HoverPlace::Outside,
        };
        Basis { yaw_free, residual4, residual3, acai, acai_yaw_free, verdict, hover, place_yaw_free }
    }

    fn verdicts(&self, model: &Model, set: &AdmissibleSet) -> Verdicts {
        let (yaw_free, could_spin) = without_yaw::word(model, set, &self.yaw_free, self.place_yaw_free);
        Verdicts { verdict: self.verdict, place: self.hover, yaw_free, could_spin, robust: robust(model, set) }
    }
}

/// Analyses one set of the model.
///
/// # Panics
/// If the set is not of this model.
pub fn analyze(model: &Model, set: &AdmissibleSet) -> ModeAnalysis {
    let rotors = model.vehicle.rotors.len();
    let (lost, capacity, stuck) = match set.mode.checked_sub(1) {
        Some(i) => (model.modes[i].lost(), model.modes[i].capacities(), model.modes[i].stuck()),
        None => (Vec::new(), vec![1.0; rotors], vec![None; rotors]),
    };
    let u_ref = hover(model);
    let found = Basis::of(model, set);
    let verdicts = found.verdicts(model, set);
    let Basis { yaw_free, verdict, hover, .. } = &found;
    let size = set.zonotope.scale()[0];
    ModeAnalysis {
        name: set.name.clone(),
        lost,
        capacity,
        stuck,
        outcome: Outcome::of(model, set, &verdicts),
        verdict: *verdict,
        yaw_free: verdicts.yaw_free,
        hover: *hover,
        interior: *hover == HoverPlace::Inside,
        rank: set.rank,
        facets: set.polytope.equalities.is_empty().then_some(set.polytope.facets.len()),
        acai: found.acai,
        acai_yaw_free: found.acai_yaw_free,
        critical_mass_kg: heaviest(&set.polytope, size).and_then(|t| mass_at_rest(model, t)),
        critical_mass_yaw_free_kg: heaviest(yaw_free, size).and_then(|t| mass_at_rest(model, t)),
        // A thrust that the wind alone takes up holds no mass: any lighter vehicle needs more thrust.
        least_mass_kg: lift(&set.polytope, size).map(|(low, _)| mass_at_rest(model, low).unwrap_or(0.0)),
        airspeed: Airspeed::of(model, set),
        without_yaw: without_yaw::figures(model, set, yaw_free, found.place_yaw_free),
        residual4: found.residual4.into(),
        residual3: found.residual3.into(),
        headroom: (*verdict == HoverVerdict::Controllable).then(|| headroom(set, &u_ref, size)),
        unreached_share: unreached_share(set),
        nearest_rows: nearest_rows(set),
        robust: verdicts.robust,
    }
}

/// The data of the verdict: the points of the set and of its yaw-free projection nearest to hover, and the rows of the
/// projection.
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
            // If the lowest speeds leave the pseudo-inverse no unclipped wrench, the wrench of all rotors at their
            // lowest speeds is used.
            Reach {
                nearest: inside.unwrap_or(set.zonotope.offset),
                nearest3: yaw_free.nearest(hover3).unwrap_or(shadow.offset),
                yaw_free,
            }
        };
        match set.allocation {
            Allocation::Bounded => by_zonotope(),
            Allocation::PseudoInverse => by_rows(),
        }
    }
}

/// The yaw-free set: the projection of the zonotope on (T, tau_x, tau_y), with tau_z left free.
pub fn without_yaw(zonotope: &Zonotope<4>) -> Zonotope<3> {
    let drop = |w: &Wrench| Vector3::new(w[0], w[1], w[2]);
    Zonotope { offset: drop(&zonotope.offset), generators: zonotope.generators.iter().map(drop).collect() }
}

/// The residual with rounding errors set to zero.
fn clean<const D: usize>(e: SVector<f64, D>, edge: f64) -> SVector<f64, D> {
    if e.norm() < edge { SVector::zeros() } else { e.map(|v| if v.abs() < 1e-12 { 0.0 } else { v }) }
}

/// The margin of a point, exactly 0 on the edge; `None` if the set is flat.
fn signed_margin<const D: usize, O: Clone>(polytope: &Polytope<D, O>, at: &SVector<f64, D>, edge: f64) -> Option<f64> {
    if !polytope.equalities.is_empty() {
        return None;
    }
    let margin = polytope.margin(at);
    Some(if margin.abs() <= edge { 0.0 } else { margin })
}

/// The smallest and the largest T >= 0 with [T, 0, ..] in the set, N. `size` is the set's extent in thrust, N.
pub(super) fn lift<const D: usize, O: Clone>(polytope: &Polytope<D, O>, size: f64) -> Option<(f64, f64)> {
    let mut thrust = SVector::<f64, D>::zeros();
    thrust[0] = 1.0;
    let (low, high) = polytope.chord(&SVector::zeros(), &thrust, ROUNDING * size)?;
    let dust = |t: f64| if t <= ROUNDING * size { 0.0 } else { t };
    (high >= -ROUNDING * size).then(|| (dust(low), dust(high)))
}

/// The largest T with [T, 0, ..] in the set, N.
fn heaviest<const D: usize, O: Clone>(polytope: &Polytope<D, O>, size: f64) -> Option<f64> {
    lift(polytope, size).map(|(_, high)| high)
}

/// The share of the set that the allocation does not reach; see [`ModeAnalysis::unreached_share`].
fn unreached_share(set: &AdmissibleSet) -> Option<f64> {
    if set.allocation == Allocation::Bounded || !set.polytope.equalities.is_empty() {
        return None;
    }
    let middle = set.zonotope.offset + 0.5 * set.zonotope.generators.iter().sum::<Wrench>();
    let kept = match set.polytope.nearest(&middle) {
        Some(inside) => set.polytope.volume(&inside, &set.zonotope.scale()),
        None => 0.0,
    };
    Some((1.0 - kept / set.zonotope.volume()).clamp(0.0, 1.0))
}

/// The distances from `at` to the boundary along each axis. `size` is the extent of the set in thrust, N.
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
