//! Vehicles known to within intervals: the wrenches that they give for every value, and those for some.
//!
//! Each rotor's full and idle thrust, and the ratio kappa_k of its drag torque to its thrust, lie anywhere in their
//! intervals, whatever the others do; so does the mass.

use super::edge;
use super::{AdmissibleSet, FacetOf, hover};
use crate::actuation::Wrench;
use crate::geometry::polytope::{Equality, Facet, Polytope};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::{Model, Rotor, Spin};
use serde::Serialize;

/// The rows of a mode's set, each with the facet it is made from.
pub type Rows = Polytope<4, FacetOf>;

/// A coefficient below this share of its row, in shares of the set's extent, is none.
const NONE: f64 = 1e-9;

/// Halvings of the interval of masses in which the largest margin is looked for.
const HALVINGS: usize = 60;

/// A mode's rotors with every kappa_k in the middle of its interval.
struct Middle {
    zonotope: Zonotope<4>,
    /// What each stuck rotor may give more or less than in the middle.
    doubts: Vec<Wrench>,
    /// The largest half width of the intervals of kappa_k: |tau_z| may differ by this much for each newton of thrust.
    delta: f64,
}

impl Middle {
    /// With rotor thrusts in `thrusts`, from idle to full, N; `None` where one has no such thrusts.
    fn of(model: &Model, set: &AdmissibleSet, thrusts: impl Fn(&Rotor) -> [f64; 2]) -> Option<Self> {
        let fault = set.mode.checked_sub(1).map(|i| &model.modes[i]);
        let mut zonotope = Zonotope { center: Wrench::zeros(), generators: Vec::new() };
        let (mut doubts, mut delta) = (Vec::new(), 0.0_f64);
        for (k, rotor) in model.vehicle.rotors.iter().enumerate() {
            let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
            let spread = rotor.spread.torque_per_thrust;
            delta = delta.max(0.5 * (spread.high - spread.low) * ratio);
            let kappa = 0.5 * (spread.high + spread.low) * ratio;
            let [x, y, _] = rotor.position;
            let each = Wrench::new(1.0, y, -x, if rotor.spin == Spin::P { -kappa } else { kappa });
            if let Some(share) = fault.and_then(|f| f.stuck[k]) {
                let full = share * rotor.max_thrust();
                let spread = rotor.spread.full_thrust;
                zonotope.center += each * (0.5 * (spread.high + spread.low) * full);
                doubts.push(each * (0.5 * (spread.high - spread.low) * full));
                zonotope.generators.push(Wrench::zeros());
                continue;
            }
            let capacity = fault.map_or(1.0, |f| f.capacity[k]);
            let [idle, full] = thrusts(rotor);
            if idle > full {
                return None;
            }
            zonotope.center += each * (capacity * idle);
            zonotope.generators.push(each * (capacity * (full - idle)));
        }
        Some(Middle { zonotope, doubts, delta })
    }

    /// How far a row may move for what is not known: by this coefficient on T, and by this offset.
    fn slips(&self, normal: &Wrench) -> (f64, f64) {
        (normal[3].abs() * self.delta, self.doubts.iter().map(|d| normal.dot(d).abs()).sum())
    }

    fn is_sure(&self, normal: &Wrench) -> bool {
        let scale = self.zonotope.scale();
        let length = normal.component_mul(&scale).norm();
        let (slope, offset) = self.slips(normal);
        slope * scale[0] <= NONE * length && offset <= NONE * length
    }
}

/// `n.w + slope T <= offset` with a unit normal.
fn row(normal: &Wrench, slope: f64, offset: f64, origin: FacetOf) -> Facet<4, FacetOf> {
    let normal = normal + Wrench::new(slope, 0.0, 0.0, 0.0);
    let length = normal.norm();
    Facet { normal: normal / length, offset: offset / length, origin }
}

fn named(set: &AdmissibleSet, facet: usize, spanning: Spanning) -> FacetOf {
    FacetOf { mode: set.mode, facet, spanning }
}

/// Wrenches that a mode gives for every value of the rotors' intervals, as long as `T >= 0`, which its last row says;
/// `None` where there is none.
///
/// All of them where no kappa_k has an interval and no rotor both an interval and a stuck fault in a flat set; else
/// perhaps not all. Equation (50) of the method.
pub fn guaranteed(model: &Model, set: &AdmissibleSet) -> Option<Rows> {
    if !model.vehicle.has_uncertain_rotors() {
        return Some(set.polytope.clone());
    }
    let always = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.high, r.max_thrust() * r.spread.full_thrust.low];
    let middle = Middle::of(model, set, always)?;
    let Polytope { equalities, facets } = middle.zonotope.facets();
    if !equalities.iter().all(|e| middle.is_sure(&e.normal)) {
        return None;
    }
    let count = facets.len();
    let mut rows: Vec<Facet<4, FacetOf>> = facets
        .iter()
        .enumerate()
        .map(|(i, f)| {
            let (slope, offset) = middle.slips(&f.normal);
            row(&f.normal, slope, f.offset - offset, named(set, i, f.origin))
        })
        .collect();
    rows.push(row(&Wrench::new(-1.0, 0.0, 0.0, 0.0), 0.0, 0.0, named(set, count, Spanning(0))));
    Some(Polytope { equalities, facets: rows })
}

/// A set that holds every wrench that a mode gives for some values of the rotors' intervals: no larger than need be
/// where neither kappa_k nor stuck or idling rotors have intervals. Equation (51) of the method.
pub fn possible(model: &Model, set: &AdmissibleSet) -> Rows {
    let ever = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.low, r.max_thrust() * r.spread.full_thrust.high];
    let middle = match Middle::of(model, set, ever) {
        Some(middle) if model.vehicle.has_uncertain_rotors() => middle,
        _ => return set.polytope.clone(),
    };
    let Polytope { equalities, facets } = middle.zonotope.facets();
    let (sure, loose): (Vec<Equality<4>>, Vec<Equality<4>>) =
        equalities.into_iter().partition(|e| middle.is_sure(&e.normal));
    let sides = loose.iter().flat_map(|e| [(e.normal, e.offset), (-e.normal, -e.offset)]);
    let sides = sides.map(|(normal, offset)| Facet { normal, offset, origin: Spanning(u64::MAX) });
    let wider = |(i, f): (usize, Facet<4, Spanning>)| {
        let (slope, offset) = middle.slips(&f.normal);
        row(&f.normal, -slope, f.offset + offset, named(set, i, f.origin))
    };
    Polytope { equalities: sure, facets: facets.into_iter().chain(sides).enumerate().map(wider).collect() }
}

impl AdmissibleSet {
    /// The set that plans keep to: nominal wrenches [m (g + z''), ..] that are given for every value of the spec's
    /// intervals, the mass's too. The set itself where nothing has an interval.
    ///
    /// A motion needs the thrust `(M/m) T` where the mass is M, so each row holds for the end of the interval of M/m
    /// that asks most of it: the high end where its coefficient on T is positive, the low end elsewhere.
    pub fn guaranteed(&self, model: &Model) -> AdmissibleSet {
        if !model.vehicle.is_uncertain() {
            return self.clone();
        }
        let mass = model.vehicle.mass_spread;
        let tied = |e: &Equality<4>| e.normal[0].abs() * self.zonotope.scale()[0] > NONE;
        let rows = guaranteed(model, self).filter(|rows| mass.is_none() || !rows.equalities.iter().any(tied));
        let polytope = match rows {
            Some(Polytope { equalities, facets }) => {
                let heavier = |f: &Facet<4, FacetOf>| {
                    let ratio = if f.normal[0] > 0.0 { mass.high } else { mass.low };
                    row(&f.normal, (ratio - 1.0) * f.normal[0], f.offset, f.origin)
                };
                Polytope { equalities, facets: facets.iter().map(heavier).collect() }
            }
            // No thrust is at least nothing and at most a newton downwards.
            None => {
                let along = |sign: f64, offset: f64| {
                    row(&Wrench::new(sign, 0.0, 0.0, 0.0), 0.0, offset, named(self, 0, Spanning(0)))
                };
                Polytope { equalities: Vec::new(), facets: vec![along(1.0, -1.0), along(-1.0, 0.0)] }
            }
        };
        AdmissibleSet { polytope, ..self.clone() }
    }
}

/// Whether a mode hovers, all axes held, over the intervals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Certainty {
    #[serde(rename = "robustly yes")]
    Yes,
    /// On the values, as far as could be shown.
    #[serde(rename = "depends")]
    Depends,
    #[serde(rename = "robustly no")]
    No,
}

impl Certainty {
    pub fn name(self) -> &'static str {
        match self {
            Certainty::Yes => "robustly yes",
            Certainty::Depends => "depends",
            Certainty::No => "robustly no",
        }
    }
}

/// What the intervals make of a mode's verdict and margin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Robust {
    pub hover: Certainty,
    /// Bounds on the margin of hover over all values, N and N m: none is below the first or above the second. They are
    /// the least and the largest where [`guaranteed`] and [`possible`] are exact; `None` where the set is flat, of the first
    /// where some value may take hover out of reach, and of the second where every one does.
    pub acai_worst: Option<f64>,
    pub acai_best: Option<f64>,
}

/// The record of a mode; `None` where nothing has an interval.
pub fn robust(model: &Model, set: &AdmissibleSet) -> Option<Robust> {
    if !model.vehicle.is_uncertain() {
        return None;
    }
    let spread = model.vehicle.mass_spread;
    let [lightest, heaviest] = [spread.low, spread.high].map(|share| hover(model) * share);
    let (sure, possible) = (guaranteed(model, set), possible(model, set));
    let margin = |rows: &Rows, w: &Wrench| rows.margin(w);
    let edge = edge::width(&lightest);
    let hovers = |rows: &Rows| [lightest, heaviest].iter().all(|w| rows.contains(w, edge));
    let certainty = match &sure {
        Some(rows) if hovers(rows) => Certainty::Yes,
        _ if meets(&possible, lightest[0], heaviest[0], edge) => Certainty::Depends,
        _ => Certainty::No,
    };
    let full = |rows: &&Rows| rows.equalities.is_empty();
    // Outside, the margin is the largest facet violation, and that need not grow as the set shrinks.
    let inside = |margin: &f64| *margin >= 0.0;
    Some(Robust {
        hover: certainty,
        acai_worst: sure.as_ref().filter(full).map(|s| margin(s, &lightest).min(margin(s, &heaviest))).filter(inside),
        acai_best: Some(&possible).filter(full).map(|p| largest(&lightest, &heaviest, |w| margin(p, w))).filter(inside),
    })
}

/// Whether the set holds some [T, 0, 0, 0] with T between two thrusts, N.
fn meets(rows: &Rows, low: f64, high: f64, edge: f64) -> bool {
    let thrust = Wrench::new(1.0, 0.0, 0.0, 0.0);
    rows.chord(&Wrench::zeros(), &thrust, edge).is_some_and(|(least, most)| least <= high + edge && most >= low - edge)
}

/// The largest value of a concave function between two points, by ternary search.
fn largest(a: &Wrench, b: &Wrench, f: impl Fn(&Wrench) -> f64) -> f64 {
    let (mut low, mut high) = (*a, *b);
    for _ in 0..HALVINGS {
        let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(&left) < f(&right) { low = left } else { high = right }
    }
    f(&low).max(f(&high))
}
