//! The tangent plane against formulas that its code does not use.

use mavc::geodesy::{Geodetic, TangentPlane, heading_of_yaw};

const A: f64 = 6378137.0;
const B: f64 = 6356752.314245179;

/// Earth-fixed, by the reduced latitude `tan beta = (b/a) tan phi`: a point of the ellipsoid is
/// `(a cos beta, b sin beta)`, and the height is along `(cos phi, sin phi)`.
fn earth_fixed([latitude, longitude, height]: [f64; 3]) -> [f64; 3] {
    let (phi, lambda) = (latitude.to_radians(), longitude.to_radians());
    let beta = (B * phi.sin()).atan2(A * phi.cos());
    let p = A * beta.cos() + height * phi.cos();
    [p * lambda.cos(), p * lambda.sin(), B * beta.sin() + height * phi.sin()]
}

/// x east, y north, z up: turned by the longitude about the axis of the Earth, then by the latitude about the east.
pub fn local(origin: [f64; 3], place: [f64; 3]) -> [f64; 3] {
    let (phi, lambda) = (origin[0].to_radians(), origin[1].to_radians());
    let (from, to) = (earth_fixed(origin), earth_fixed(place));
    let [x, y, z] = [0, 1, 2].map(|i| to[i] - from[i]);
    let out = x * lambda.cos() + y * lambda.sin();
    let east = y * lambda.cos() - x * lambda.sin();
    [east, z * phi.cos() - out * phi.sin(), out * phi.cos() + z * phi.sin()]
}

#[test]
fn the_tangent_plane_is_that_of_other_formulas() {
    let mut largest = 0.0_f64;
    for origin in [[47.397742, 8.545594, 488.0], [-33.9, -179.9999, -3.0], [0.0, 0.0, 0.0], [89.99, 45.0, 10.0]] {
        let plane = TangentPlane::at(Geodetic::degrees(origin[0], origin[1], origin[2]));
        for (north, east, up) in [(0.0, 0.0, 50.0), (1e-7, -1e-7, 0.0), (0.009, 0.004, 120.0), (-0.9, 1.7, 900.0)] {
            let place = [f64::min(origin[0] + north, 90.0), origin[1] + east, origin[2] + up];
            let ours = plane.local(&Geodetic::degrees(place[0], place[1], place[2]));
            let theirs = local(origin, place);
            let back = plane.place(ours);
            for i in 0..3 {
                largest = largest.max((ours[i] - theirs[i]).abs());
            }
            assert!((back.latitude.to_degrees() - place[0]).abs() < 1e-12, "{place:?} {back:?}");
            assert!((back.height - place[2]).abs() < 1e-7);
        }
    }
    assert!(largest < 1e-8, "{largest:e} m");
}

/// A degree of latitude at 45 degrees is 111,132 m long, and the ground curves down by d^2/2R.
#[test]
fn distances_are_those_of_the_earth() {
    let plane = TangentPlane::at(Geodetic::degrees(45.0, 0.0, 0.0));
    let [east, north, up] = plane.local(&Geodetic::degrees(45.01, 0.0, 0.0));
    assert!(east.abs() < 1e-9 && (north - 1111.32).abs() < 0.02, "{north}");
    assert!((up + north * north / (2.0 * 6_367_000.0)).abs() < 1e-3, "{up}");
    assert_eq!(
        [0.0, 90.0, 180.0, -90.0].map(|yaw: f64| heading_of_yaw(yaw.to_radians()).round()),
        [90.0, 0.0, 270.0, 180.0]
    );
}
