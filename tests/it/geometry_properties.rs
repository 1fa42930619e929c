//! Zonotopes and their facets against brute force, on random vehicles: full of coincidences (positions on a raster)
//! or of none.

use crate::vehicles::{hexacopter, lost, octocopter, quadcopter};
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::{AdmissibleSet, intersection};
use mavc::geometry::polytope::{Polytope, intersect};
use mavc::geometry::zonotope::Zonotope;
use mavc::model::{Model, Rotor, RotorSpread, Spin, Spread};
use mavc::qp::RowOrigin;
use mavc::qp::build::{Affine, Builder};
use mavc::solve::{Outcome, solve};
use nalgebra::DMatrix;
use proptest::prelude::*;

type Set = Zonotope<4>;

fn rotor(x: f64, y: f64, p: bool, thrust: f64) -> Rotor {
    Rotor {
        position: [x, y, 0.0],
        spin: if p { Spin::P } else { Spin::N },
        thrust_coefficient: thrust * 1e-6,
        drag_coefficient: 0.016 * thrust * 1e-6,
        min_speed: 0.0,
        max_speed: 1000.0,
        time_constant: None,
        inertia: 0.0,
        inertia_spread: Spread::NONE,
        motor: None,
        spread: RotorSpread::default(),
    }
}

/// Rotors placed one by one: on a raster with a few sizes, or anywhere.
fn placed(most: usize) -> impl Strategy<Value = Model> {
    let raster = (-3..4i32, -3..4i32, any::<bool>(), 1..4u8)
        .prop_map(|(x, y, p, f)| rotor(0.1 * f64::from(x), 0.1 * f64::from(y), p, 2.0 * f64::from(f)));
    let anywhere = (-0.5..0.5f64, -0.5..0.5f64, any::<bool>(), 1.0..9.0f64).prop_map(|(x, y, p, f)| rotor(x, y, p, f));
    prop_oneof![prop::collection::vec(raster, 4..=most), prop::collection::vec(anywhere, 4..=most)].prop_map(|rotors| {
        let mut model = quadcopter();
        model.vehicle.rotors = rotors;
        model
    })
}

/// Rings with any sequence of spins.
fn ring(most: usize) -> impl Strategy<Value = Model> {
    prop::collection::vec(any::<bool>(), 2..=most / 2).prop_map(|half| {
        let layout: String = half.iter().chain(&half).map(|p| if *p { 'P' } else { 'N' }).collect();
        octocopter(&layout)
    })
}

fn vehicle(most: usize) -> impl Strategy<Value = Model> {
    prop_oneof![placed(most), ring(most)]
}

/// theta: lost, reduced or whole rotors.
fn capacities() -> impl Strategy<Value = Vec<f64>> {
    let one = prop_oneof![2 => Just(1.0), 1 => Just(0.0), 1 => Just(0.6), 1 => 0.05..1.0f64];
    prop::collection::vec(one, 12)
}

fn generators(model: &Model, capacity: &[f64]) -> Set {
    let actuation = Actuation::of(&model.vehicle);
    let generators = (0..actuation.rotors()).map(|k| actuation.full(k) * capacity[k]).collect();
    Zonotope { offset: Wrench::zeros(), generators }
}

fn set() -> impl Strategy<Value = Set> {
    (vehicle(10), capacities(), prop::array::uniform4(-1.0..1.0f64)).prop_map(|(model, capacity, c)| {
        let mut set = generators(&model, &capacity);
        set.offset = Wrench::from(c).component_mul(&Wrench::new(5.0, 0.5, 0.5, 0.05));
        set
    })
}

/// All 2^n sums.
fn corners(set: &Set) -> Vec<Wrench> {
    set.generators.iter().fold(vec![set.offset], |all, g| {
        let shifted: Vec<Wrench> = all.iter().map(|w| w + g).collect();
        all.into_iter().chain(shifted).collect()
    })
}

fn rank(points: &[Wrench], scale: &Wrench) -> usize {
    let m = DMatrix::from_fn(4, points.len(), |r, c| (points[c] - points[0])[r] / scale[r]);
    m.singular_values().iter().filter(|s| **s > 1e-7).count()
}

fn size(set: &Set) -> f64 {
    set.offset.norm() + set.generators.iter().map(nalgebra::Matrix::norm).sum::<f64>()
}

/// A point of the box around the set, a little larger than it.
fn around(set: &Set, at: &[f64; 4]) -> Wrench {
    let (mut low, mut high) = (set.offset, set.offset);
    for g in &set.generators {
        low += g.map(|v| v.min(0.0));
        high += g.map(|v| v.max(0.0));
    }
    let middle = 0.5 * (low + high);
    middle + Wrench::from(*at).component_mul(&(high - low)) * 0.6
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_facet_holds_at_all_corners_and_is_spanned_by_some(set in set()) {
        let corners = corners(&set);
        let (scale, size) = (set.scale(), size(&set));
        let (rank_of_set, polytope) = (set.rank(), set.facets());
        prop_assert_eq!(rank(&corners, &scale), rank_of_set);
        prop_assert_eq!(polytope.equalities.len(), 4 - rank_of_set);
        for e in &polytope.equalities {
            prop_assert!((e.normal.norm() - 1.0).abs() < 1e-12);
            for w in &corners {
                prop_assert!((e.normal.dot(w) - e.offset).abs() < 1e-9 * size);
            }
        }
        for f in &polytope.facets {
            prop_assert!((f.normal.norm() - 1.0).abs() < 1e-12);
            let highest = corners.iter().map(|w| f.normal.dot(w)).fold(f64::NEG_INFINITY, f64::max);
            prop_assert!((highest - f.offset).abs() < 1e-9 * size, "offset {} against {highest}", f.offset);
            prop_assert!((set.support(&f.normal) - f.offset).abs() < 1e-9 * size);
            let touching: Vec<Wrench> = corners.iter().filter(|w| f.slack(w) < 1e-8 * size).copied().collect();
            // More where a further corner lies that near without lying on the plane.
            prop_assert!(rank(&touching, &scale) >= rank_of_set - 1);
        }
        // No two facets share a plane.
        for (i, a) in polytope.facets.iter().enumerate() {
            for b in &polytope.facets[..i] {
                prop_assert!((a.normal - b.normal).component_mul(&scale).amax() > 1e-9 * scale.min());
            }
        }
    }

    /// p is nearest to w exactly when p is in the set and no point of it lies further along w - p; and the facets
    /// hold a point exactly when it is its own nearest point.
    #[test]
    fn nearest_points_are_optimal_and_agree_with_the_facets(set in set(), at in prop::array::uniform4(-1.0..1.0f64)) {
        let (w, size, polytope) = (around(&set, &at), size(&set), set.facets());
        let p = set.nearest(&w);
        prop_assert!(polytope.contains(&p, 1e-8 * size), "nearest point is outside by {}", -polytope.margin(&p));
        let out = w - p;
        // |p - nearest|^2 is at most this gap: p is right to 1e-7 of the size, and far out to better.
        let gap = set.support(&out) - out.dot(&p);
        prop_assert!(gap <= 1e-8 * size * out.norm() + (1e-7 * size).powi(2), "gap {gap}, distance {}", out.norm());
        let (distance, off) = (out.norm(), polytope.off_plane(&w));
        if polytope.contains(&w, 0.0) {
            prop_assert!(distance < 1e-7 * size);
        }
        if distance < 1e-9 * size {
            prop_assert!(polytope.contains(&w, 1e-8 * size));
        }
        // The most violated plane is never further than the nearest point.
        prop_assert!(distance >= (-polytope.margin(&w)).max(off) - 1e-8 * size);
    }

    #[test]
    fn losses_only_shrink_a_set(model in vehicle(12), one in capacities(), two in capacities()) {
        let healthy = generators(&model, &[1.0; 12]);
        let both: Vec<f64> = one.iter().zip(&two).map(|(a, b)| a.min(*b)).collect();
        let (single, double) = (generators(&model, &one), generators(&model, &both));
        for (inner, outer) in [(&single, &healthy), (&double, &single)] {
            let polytope = outer.facets();
            for f in &polytope.facets {
                prop_assert!(inner.support(&f.normal) <= f.offset + 1e-9 * size(&healthy));
            }
            for e in &polytope.equalities {
                prop_assert!(inner.width(&e.normal) < 1e-9 * size(&healthy));
            }
        }
    }

    #[test]
    fn shrinking_is_scaling_about_the_point(
        set in set(),
        at in prop::array::uniform4(-1.0..1.0f64),
        share in 0.0..0.95f64,
    ) {
        let polytope = set.facets();
        let middle = set.generators.iter().fold(set.offset, |c, g| c + 0.5 * g);
        let shrunk = polytope.shrink_about(&middle, share);
        let w = around(&set, &at);
        let stretched = middle + (w - middle) / (1.0 - share);
        let (a, b) = (shrunk.margin(&w), (1.0 - share) * polytope.margin(&stretched));
        // A point has no facets: both margins are infinite.
        prop_assert!(a == b || (a - b).abs() < 1e-9 * size(&set));
        prop_assert_eq!(&shrunk.equalities, &polytope.equalities);
    }

    #[test]
    fn chords_end_on_the_boundary(
        set in set(),
        at in prop::array::uniform4(-1.0..1.0f64),
        direction in prop::array::uniform4(-1.0..1.0f64),
    ) {
        let (polytope, size) = (set.facets(), size(&set));
        let tolerance = 1e-8 * size;
        let start = set.nearest(&around(&set, &at));
        let direction = Wrench::from(direction).component_mul(&set.scale());
        prop_assume!(direction.norm() > 1e-3 * size);
        let chord = polytope.chord(&start, &direction, tolerance);
        prop_assert!(chord.is_some(), "the line starts in the set");
        let (low, high) = chord.unwrap_or_default();
        prop_assert!(low <= 1e-6 && high >= -1e-6, "{low} .. {high}");
        for t in [low, 0.5 * (low + high), high] {
            prop_assert!(polytope.contains(&(start + direction * t), 1e-6 * size));
        }
        if set.rank() == 4 {
            prop_assert!(polytope.margin(&(start + direction * low)).abs() < 1e-7 * size);
            prop_assert!(polytope.margin(&(start + direction * (high + 0.01))) < 1e-12 * size);
        } else {
            prop_assert!(high - low < 1e-6, "a random line leaves a flat set's plane at once");
            let off = start + polytope.equalities[0].normal * (0.01 * size);
            let along = set.generators.iter().sum::<Wrench>();
            prop_assume!(along.norm() > 0.0);
            prop_assert_eq!(polytope.chord(&off, &along, tolerance), None);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 5_000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Sums with many rotors at rest or at full thrust lie on the boundary or near it.
    #[test]
    fn points_of_a_set_are_their_own_nearest(
        model in vehicle(12),
        capacity in capacities(),
        shares in prop::collection::vec(prop_oneof![Just(0.0), Just(1.0), Just(0.5), 0.0..1.0f64], 12),
    ) {
        let set = generators(&model, &capacity);
        let w = set.generators.iter().zip(&shares).fold(set.offset, |sum, (g, t)| sum + g * *t);
        let apart = (set.nearest(&w) - w).norm();
        prop_assert!(apart <= 1e-9 * size(&set), "{apart:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn intersection_is_the_conjunction_without_a_row_too_many(
        model in vehicle(9),
        capacity in prop::collection::vec(capacities(), 1..4),
        points in prop::collection::vec((0..4usize, prop::array::uniform4(-1.0..1.0f64)), 40),
    ) {
        let sets: Vec<Set> = capacity.iter().map(|c| generators(&model, c)).collect();
        let least: Vec<f64> = (0..12).map(|k| capacity.iter().map(|c| c[k]).fold(1.0, f64::min)).collect();
        let core = generators(&model, &least);
        let inside = core.generators.iter().fold(core.offset, |c, g| c + 0.5 * g);
        let polytopes: Vec<_> = sets.iter().map(Zonotope::facets).collect();
        let scale = generators(&model, &[1.0; 12]).scale();
        let joint = intersect(&polytopes.iter().collect::<Vec<_>>(), &inside, &scale);
        let size = size(&generators(&model, &[1.0; 12]));
        for (which, at) in &points {
            let set = &sets[which % sets.len()];
            // Inside one of the sets, so that the others decide; flat ones are met exactly.
            let w = set.nearest(&around(set, at));
            let all = polytopes.iter().map(|p| p.margin(&w).min(-p.off_plane(&w))).fold(f64::INFINITY, f64::min);
            let of_joint = joint.margin(&w).min(-joint.off_plane(&w));
            if all > -1e-9 * size {
                prop_assert!(of_joint > -1e-7 * size, "{of_joint} where all sets say {all}");
            }
            if all < -1e-6 * size {
                prop_assert!(of_joint < -1e-9 * size, "{of_joint} where some set says {all}");
            }
        }
        let full = joint.equalities.is_empty() && joint.margin(&inside) > 1e-4 * size;
        if full {
            for i in 0..joint.facets.len() {
                let reach = furthest_without(&joint, i, &scale);
                prop_assert!(reach > 1e-9, "row {i} of {} is implied by the others: {reach:e}", joint.facets.len());
            }
        }
    }
}

/// How far past row `i` the other rows let a point go, in units of the scaled row, at most 1.
fn furthest_without<O: Clone>(set: &Polytope<4, O>, i: usize, scale: &Wrench) -> f64 {
    let row = |j: usize| {
        let f = &set.facets[j];
        let n = f.normal.component_mul(scale);
        let terms = (0..4).map(|c| (c, -n[c] / n.norm())).collect();
        Affine { terms, constant: f.offset / n.norm() }
    };
    let mut builder = Builder::new(4);
    for j in 0..set.facets.len() {
        let slack = if j == i { row(j).plus_constant(1.0) } else { row(j) };
        builder.nonnegative(slack, RowOrigin::Overshoot);
    }
    for &(c, coefficient) in &row(i).terms {
        builder.linear(c, coefficient);
    }
    match solve(&builder.finish()).0 {
        Outcome::Solved(s) => -row(i).at(&s.x),
        other => panic!("{other:?}"),
    }
}

#[test]
fn quadcopter_with_one_rotor_lost_is_a_flat_box() {
    for k in 1..=4 {
        let mut model = quadcopter();
        model.modes.push(lost(&model, &[k]));
        let set = AdmissibleSet::of_mode(&model, 0);
        assert_eq!((set.rank, set.polytope.equalities.len(), set.polytope.facets.len()), (3, 1, 6));
        let corners = corners(&set.zonotope);
        assert!(corners.iter().all(|w| set.polytope.contains(w, 1e-12)));
        // The healthy vehicle leaves the plane.
        let full = Actuation::of(&model.vehicle).full(k - 1);
        assert!(set.polytope.off_plane(&full) > 1e-3);
        // The middle of the box is inside; a facet's outer side is not.
        let middle = set.zonotope.generators.iter().fold(Wrench::zeros(), |c, g| c + 0.5 * g);
        assert!(set.polytope.margin(&middle) > 1e-3 && set.polytope.off_plane(&middle) < 1e-12);
        assert!(!set.polytope.contains(&(2.1 * middle), 1e-9));
    }
}

#[test]
fn flat_sets_meet_in_their_common_plane() {
    // Opposite rotors lost: roll or pitch and yaw are tied. Two such sets meet in a plane of the wrench space.
    let mut model = hexacopter("PNPNPN");
    for pair in [[1, 4], [2, 5]] {
        model.modes.push(lost(&model, &pair));
    }
    let sets: Vec<AdmissibleSet> = (0..2).map(|i| AdmissibleSet::of_mode(&model, i)).collect();
    assert!(sets.iter().all(|s| s.rank == 3));
    let joint = intersection(&sets.iter().collect::<Vec<_>>());
    assert_eq!(joint.equalities.len(), 2);
    let hover = sets[0].hover;
    assert!(joint.margin(&hover) > 0.01 && joint.off_plane(&hover) < 1e-12);
    // Points of the common plane, near and far: both sets and their intersection agree.
    let [first, second] = [joint.equalities[0].normal, joint.equalities[1].normal];
    let second = (second - first * first.dot(&second)).normalize();
    let mut seen = [0, 0];
    for i in 0..400 {
        let f = f64::from(i);
        let mut d = Wrench::new((0.7 * f).sin() * 10.0, (1.3 * f).cos(), (2.1 * f).sin(), (0.9 * f).cos() * 0.1);
        for n in [first, second] {
            d -= n * n.dot(&d);
        }
        let w = hover + d;
        let all = sets.iter().all(|s| s.polytope.contains(&w, 1e-9));
        assert_eq!(all, joint.contains(&w, 1e-9));
        seen[usize::from(all)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{seen:?}");
}
