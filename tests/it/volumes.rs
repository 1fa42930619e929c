//! Volumes, nearest points and shadows of half-space descriptions, against those of zonotopes and closed forms.

use mavc::actuation::Wrench;
use mavc::admissible::verdict::without_yaw;
use mavc::geometry::polytope::{Equality, Facet, Polytope};
use mavc::geometry::zonotope::Zonotope;
use nalgebra::{DMatrix, SVector, Vector4};
use proptest::prelude::*;

/// On a raster, full of coincidences, or anywhere.
fn zonotope() -> impl Strategy<Value = Zonotope<4>> {
    let raster = prop::array::uniform4(-2..3i32).prop_map(|v| Wrench::from(v.map(f64::from)));
    let anywhere = prop::array::uniform4(-2.0..2.0f64).prop_map(Wrench::from);
    let generators = prop_oneof![prop::collection::vec(raster, 4..8), prop::collection::vec(anywhere, 4..8)];
    (prop::array::uniform4(-2.0..2.0f64), generators)
        .prop_map(|(offset, generators)| Zonotope { offset: Wrench::from(offset), generators })
}

/// `n.x <= offset` with a normal of any length.
fn row<const D: usize>(n: SVector<f64, D>, offset: f64) -> Facet<D, ()> {
    Facet { normal: n.normalize(), offset: offset / n.norm(), origin: () }
}

#[test]
fn volumes_in_closed_form() {
    let ones = Vector4::repeat(1.0);
    let unit = |i: usize| Vector4::from_fn(|k, _| if k == i { 1.0 } else { 0.0 });
    let below = (0..4).map(|i| row(-unit(i), 0.0));
    // The simplex 0 <= x, sum x <= 2, with a row too many: 2^4/4!.
    let mut simplex: Vec<Facet<4, ()>> = below.clone().chain([row(ones, 2.0), row(ones, 2.5)]).collect();
    let inside = Vector4::repeat(0.3);
    let volume = |facets: &[Facet<4, ()>]| {
        Polytope { equalities: Vec::new(), facets: facets.to_vec() }.volume(&inside, &Vector4::new(1.0, 2.0, 0.5, 3.0))
    };
    assert!((volume(&simplex) - 16.0 / 24.0).abs() < 1e-12);
    // Its corner at x_1 >= 1 cut off: a simplex half as large.
    simplex.push(row(unit(0), 1.0));
    assert!((volume(&simplex) - 15.0 / 24.0).abs() < 1e-12);
    // A box of 1 x 2 x 3 x 4, and the same as a flat set.
    let sides = (0..4).map(|i| row(unit(i), i as f64 + 1.0));
    let mut cuboid: Vec<Facet<4, ()>> = below.chain(sides).collect();
    assert!((volume(&cuboid) - 24.0).abs() < 1e-12);
    let flat = Polytope { equalities: vec![Equality { normal: unit(0), offset: 0.3 }], facets: cuboid.clone() };
    assert_eq!(flat.volume(&inside, &ones), 0.0);
    // Empty.
    cuboid.push(row(unit(2), -1.0));
    assert!(volume(&cuboid).abs() < 1e-12);
    assert!(Polytope { equalities: Vec::new(), facets: cuboid }.nearest(&inside).is_none());
}

/// The distance from `w` by brute force: each of 3^n choices.
fn by_all_faces(set: &Zonotope<4>, w: &Wrench) -> f64 {
    let n = set.generators.len();
    let mut least = f64::INFINITY;
    for choice in 0..3_usize.pow(n as u32) {
        let place = |k: usize| choice / 3_usize.pow(k as u32) % 3;
        let free: Vec<usize> = (0..n).filter(|&k| place(k) == 2).collect();
        if free.len() > 4 {
            continue; // a face's point needs no more than four between
        }
        let corner = (0..n).filter(|&k| place(k) == 1).fold(set.offset, |sum, k| sum + set.generators[k]);
        let mut point = corner;
        if !free.is_empty() {
            let columns = DMatrix::from_fn(4, free.len(), |r, c| set.generators[free[c]][r]);
            let shares = columns.pseudo_inverse(1e-9).unwrap() * (w - corner);
            if shares.iter().any(|t| !(0.0..=1.0).contains(t)) {
                continue;
            }
            point = free.iter().zip(&shares).fold(corner, |sum, (&k, t)| sum + set.generators[k] * *t);
        }
        least = least.min((point - w).norm());
    }
    least
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn zonotopes_and_their_facets_have_one_volume(set in zonotope()) {
        let middle = set.offset + 0.5 * set.generators.iter().sum::<Wrench>();
        let tiled = set.volume();
        let by_rows = set.facets().volume(&middle, &set.scale());
        let size: f64 = set.generators.iter().map(nalgebra::Matrix::norm).sum();
        prop_assert!((tiled - by_rows).abs() < 1e-9 * size.powi(4), "{tiled} {by_rows}");
    }

    /// The nearest point lies inside some face: of all choices of rotors at their least, at their most and between,
    /// those between by least squares, the nearest point that keeps the bounds.
    #[test]
    fn nearest_points_are_those_of_all_faces(set in zonotope(), at in prop::array::uniform4(-9.0..9.0f64)) {
        let w = Wrench::from(at);
        let apart = (set.nearest(&w) - w).norm() - by_all_faces(&set, &w);
        prop_assert!(apart.abs() < 1e-8, "{apart:e}");
    }

    #[test]
    fn nearest_points_by_rows_are_those_by_vertices(set in zonotope(), at in prop::array::uniform4(-9.0..9.0f64)) {
        let (w, polytope) = (Wrench::from(at), set.facets());
        let by_rows = polytope.nearest(&w).unwrap();
        let apart = (by_rows - set.nearest(&w)).norm();
        prop_assert!(apart < 1e-7, "{apart:e}");
        prop_assert!(polytope.contains(&by_rows, 1e-8));
    }

    #[test]
    fn shadows_by_rows_are_those_by_generators(set in zonotope()) {
        let middle = set.offset + 0.5 * set.generators.iter().sum::<Wrench>();
        let by_rows = set.facets().shadow(Some(&middle), &set.scale());
        let by_generators = without_yaw(&set).facets();
        let size: f64 = set.generators.iter().map(nalgebra::Matrix::norm).sum();
        prop_assert_eq!(by_rows.equalities.len(), by_generators.equalities.len());
        if by_rows.equalities.is_empty() {
            // One set to 1e-9 of its size: each row supports it, and none of its facets is missing; nor is one too
            // many, but where facets are that near to each other.
            let shadow = without_yaw(&set);
            for f in &by_rows.facets {
                let apart = shadow.support(&f.normal) - f.offset;
                prop_assert!(apart.abs() < 1e-9 * size, "{apart:e}");
            }
            for f in &by_generators.facets {
                let twin = by_rows.facets.iter().any(|g| {
                    (g.normal - f.normal).amax() < 1e-7 && (g.offset - f.offset).abs() < 1e-7 * size
                });
                prop_assert!(twin, "{f:?}");
            }
            prop_assert_eq!(by_rows.facets.len(), by_generators.facets.len());
        }
    }
}
