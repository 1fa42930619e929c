//! Vehicles with parameters known only to within intervals: the wrenches that are possible for every value of the
//! parameters, and those that are possible for some value. See `docs/method/verdicts.md`, "Intervals", (50) and (51).
//!
//! The parameters are the full and the idle thrust of each rotor, the ratio kappa_k of its drag torque to its thrust,
//! and the mass. Each may take any value of its interval independently of the others.

use super::edge;
use super::{AdmissibleSet, FacetOf, hover};
use crate::actuation::Wrench;
use crate::geometry::polytope::{Equality, Facet, Polytope};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::{Model, Rotor, Spin};
use serde::Serialize;

/// The rows of a mode's set, each with the facet it is made from.
type Rows = Polytope<4, FacetOf>;

/// A coefficient counts as zero at or below this share of its row, both in units of the set's extent.
const NONE: f64 = 1e-9;

/// Steps of the ternary search for the largest margin over the interval of the mass.
const STEPS: usize = 60;

/// The rotors of a mode with every kappa_k in the middle of its interval.
pub(super) struct Middle {
    pub zonotope: Zonotope<4>,
    /// r_k of (50) for each stuck rotor: the largest deviation of its wrench from the middle.
    pub deviations: Vec<Wrench>,
    /// delta of (50), m: the largest half width of the intervals of kappa_k. tau_z may differ by this for each newton
    /// of thrust.
    delta: f64,
}

impl Middle {
    /// The rotors with thrusts from `thrusts(rotor)[0]` to `thrusts(rotor)[1]`, N; `None` if the range of some rotor is
    /// empty.
    pub fn of(model: &Model, set: &AdmissibleSet, thrusts: impl Fn(&Rotor) -> [f64; 2]) -> Option<Self> {
        let fault = set.mode.checked_sub(1).map(|i| &model.modes[i]);
        let mut zonotope = Zonotope { offset: Wrench::zeros(), generators: Vec::new() };
        let (mut deviations, mut delta) = (Vec::new(), 0.0_f64);
        for (k, rotor) in model.vehicle.rotors.iter().enumerate() {
            let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
            let spread = rotor.spread.torque_per_thrust;
            delta = delta.max(0.5 * (spread.high - spread.low) * ratio);
            let kappa = 0.5 * (spread.high + spread.low) * ratio;
            let [x, y, _] = rotor.position;
            let each = Wrench::new(1.0, y, -x, if rotor.spin == Spin::P { -kappa } else { kappa });
            if let Some(share) = fault.and_then(|f| f.rotors[k].stuck_at()) {
                let full = share * rotor.max_thrust();
                let spread = rotor.spread.full_thrust;
                zonotope.offset += each * (0.5 * (spread.high + spread.low) * full);
                deviations.push(each * (0.5 * (spread.high - spread.low) * full));
                zonotope.generators.push(Wrench::zeros());
                continue;
            }
            let capacity = fault.map_or(1.0, |f| f.rotors[k].capacity());
            let [idle, full] = thrusts(rotor);
            if idle > full {
                return None;
            }
            zonotope.offset += each * (capacity * idle);
            zonotope.generators.push(each * (capacity * (full - idle)));
        }
        Some(Middle { zonotope, deviations, delta })
    }

    /// How far the intervals may move a row: the coefficient `|n_z| delta` on T and the offset `sum |n.r_k|` of (50)
    /// and (51).
    fn row_shift(&self, normal: &Wrench) -> (f64, f64) {
        (normal[3].abs() * self.delta, self.deviations.iter().map(|d| normal.dot(d).abs()).sum())
    }

    /// Whether the intervals do not move a row with this normal.
    fn is_fixed(&self, normal: &Wrench) -> bool {
        let scale = self.zonotope.scale();
        let length = normal.component_mul(&scale).norm();
        let (slope, offset) = self.row_shift(normal);
        slope * scale[0] <= NONE * length && offset <= NONE * length
    }
}

/// The row `normal.w + slope T <= offset`, scaled to a unit normal.
fn row(normal: &Wrench, slope: f64, offset: f64, origin: FacetOf) -> Facet<4, FacetOf> {
    let normal = normal + Wrench::new(slope, 0.0, 0.0, 0.0);
    let length = normal.norm();
    Facet { normal: normal / length, offset: offset / length, origin }
}

fn named(set: &AdmissibleSet, facet: usize, spanning: Spanning) -> FacetOf {
    FacetOf { mode: set.mode, facet, spanning }
}

/// (50): wrenches that a mode can produce for every value of the rotors' intervals. The last row is `T >= 0`. `None` if
/// no wrench is guaranteed.
///
/// The set is exact if no kappa_k has an interval and, in a flat set, no stuck rotor has one. Otherwise it may leave
/// out wrenches that are possible for every value. The interval of the mass plays no part here; see
/// [`AdmissibleSet::guaranteed`].
pub fn guaranteed(model: &Model, set: &AdmissibleSet) -> Option<Rows> {
    if !model.vehicle.has_uncertain_rotors() {
        return Some(set.polytope.clone());
    }
    let always = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.high, r.max_thrust() * r.spread.full_thrust.low];
    let middle = Middle::of(model, set, always)?;
    let Polytope { equalities, facets } = middle.zonotope.facets();
    if !equalities.iter().all(|e| middle.is_fixed(&e.normal)) {
        return None;
    }
    let count = facets.len();
    let mut rows: Vec<Facet<4, FacetOf>> = facets
        .iter()
        .enumerate()
        .map(|(i, f)| {
            let (slope, offset) = middle.row_shift(&f.normal);
            row(&f.normal, slope, f.offset - offset, named(set, i, f.origin))
        })
        .collect();
    rows.push(row(&Wrench::new(-1.0, 0.0, 0.0, 0.0), 0.0, 0.0, named(set, count, Spanning(0))));
    Some(Polytope { equalities, facets: rows })
}

/// (51): a set that contains every wrench that a mode can produce for some value of the rotors' intervals. It is exact
/// if neither a kappa_k nor a stuck or idling rotor has an interval.
pub fn possible(model: &Model, set: &AdmissibleSet) -> Rows {
    let ever = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.low, r.max_thrust() * r.spread.full_thrust.high];
    let middle = match Middle::of(model, set, ever) {
        Some(middle) if model.vehicle.has_uncertain_rotors() => middle,
        _ => return set.polytope.clone(),
    };
    let Polytope { equalities, facets } = middle.zonotope.facets();
    let (sure, loose): (Vec<Equality<4>>, Vec<Equality<4>>) =
        equalities.into_iter().partition(|e| middle.is_fixed(&e.normal));
    let sides = loose.iter().flat_map(|e| [(e.normal, e.offset), (-e.normal, -e.offset)]);
    let sides = sides.map(|(normal, offset)| Facet { normal, offset, origin: Spanning(u64::MAX) });
    let wider = |(i, f): (usize, Facet<4, Spanning>)| {
        let (slope, offset) = middle.row_shift(&f.normal);
        row(&f.normal, -slope, f.offset + offset, named(set, i, f.origin))
    };
    Polytope { equalities: sure, facets: facets.into_iter().chain(sides).enumerate().map(wider).collect() }
}

impl AdmissibleSet {
    /// The set that plans keep to: the nominal wrenches `[m (g + z''), ..]` that are possible for every value of all
    /// intervals, the mass included. The set itself if nothing has an interval.
    ///
    /// A vehicle of mass M needs the thrust `(M/m) T`, so the coefficient of a row on T is multiplied by the largest
    /// M/m if it is positive and by the smallest otherwise (`docs/method/verdicts.md`, "Plans").
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
            // Nothing is guaranteed: the rows T <= -1 N and T >= 0 describe an empty set.
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

/// Whether a mode hovers with all four axes controlled, over the values of the intervals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub enum Certainty {
    /// Hover at every mass of its interval satisfies (50).
    #[serde(rename = "robustly yes")]
    Yes,
    /// Neither of the others was shown.
    #[serde(rename = "depends")]
    Depends,
    /// Hover at no mass of its interval satisfies (51).
    #[serde(rename = "robustly no")]
    No,
}

impl Certainty {
    /// The words that reports print.
    pub fn name(self) -> &'static str {
        match self {
            Certainty::Yes => "robustly yes",
            Certainty::Depends => "depends",
            Certainty::No => "robustly no",
        }
    }
}

/// Hover over the values of the spec's intervals.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Robust {
    /// Whether the mode hovers with all axes controlled, over the intervals.
    pub hover: Certainty,
    /// Lower bound on the margin of hover over all values, N and N m; attained if [`guaranteed`] is exact. null if
    /// the set is flat or hover may be out of reach for some value.
    pub acai_worst: Option<f64>,
    /// Upper bound on the margin of hover over all values, N and N m; attained if [`possible`] is exact. null if the
    /// set is flat or hover is out of reach for every value.
    pub acai_best: Option<f64>,
}

/// Verdict and margin of a mode over the intervals; `None` if nothing has an interval.
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
    // Outside a set the margin is minus the largest facet violation, which is not monotone in the set, so it is no
    // bound.
    let inside = |margin: &f64| *margin >= 0.0;
    Some(Robust {
        hover: certainty,
        acai_worst: sure.as_ref().filter(full).map(|s| margin(s, &lightest).min(margin(s, &heaviest))).filter(inside),
        acai_best: Some(&possible).filter(full).map(|p| largest(&lightest, &heaviest, |w| margin(p, w))).filter(inside),
    })
}

/// Whether the set contains [T, 0, 0, 0] for some T from `low` to `high`, N.
fn meets(rows: &Rows, low: f64, high: f64, edge: f64) -> bool {
    let thrust = Wrench::new(1.0, 0.0, 0.0, 0.0);
    rows.chord(&Wrench::zeros(), &thrust, edge).is_some_and(|(least, most)| least <= high + edge && most >= low - edge)
}

/// The largest value of a concave function on the segment between two points, by ternary search.
fn largest(a: &Wrench, b: &Wrench, f: impl Fn(&Wrench) -> f64) -> f64 {
    let (mut low, mut high) = (*a, *b);
    for _ in 0..STEPS {
        let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(&left) < f(&right) { low = left } else { high = right }
    }
    f(&low).max(f(&high))
}
