//! The map between the frames, against rotation matrices and against what a compass shows.

use super::close;
use mavc::exchange::frames::{Frame, wrapped};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

fn attitudes() -> impl Iterator<Item = Rotation3<f64>> {
    (0..60).map(|k| {
        let k = f64::from(k);
        Rotation3::from_euler_angles((0.7 * k).sin() * 1.4, (1.3 * k).sin() * 1.4, k)
    })
}

fn matrix(of: impl Fn([f64; 3]) -> [f64; 3]) -> Matrix3<f64> {
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|unit| Vector3::from(of(unit)));
    Matrix3::from_columns(&columns)
}

fn rotated(q: [f64; 4]) -> Matrix3<f64> {
    let [w, x, y, z] = q;
    assert!(w >= 0.0 && (q.iter().map(|part| part * part).sum::<f64>() - 1.0).abs() < 1e-12, "{q:?}");
    UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, x, y, z)).to_rotation_matrix().into_inner()
}

#[test]
fn both_maps_are_rotations_and_their_own_inverses() {
    for map in [matrix(|v| Frame::NedFrd.world(v)), matrix(|v| Frame::NedFrd.body(v))] {
        assert_eq!((map * map, map.determinant()), (Matrix3::identity(), 1.0));
    }
    // East is the second axis, north the first, up the negative third.
    assert_eq!(Frame::NedFrd.world([1.0, 2.0, 3.0]), [2.0, 1.0, -3.0]);
    assert_eq!(Frame::NedFrd.body([1.0, 2.0, 3.0]), [1.0, -2.0, -3.0]);
}

#[test]
fn attitudes_turn_a_vector_of_the_body_into_the_same_vector_of_the_world() {
    let arm = [0.3, -1.2, 0.5];
    for attitude in attitudes() {
        let world: [f64; 3] = (attitude * Vector3::from(arm)).into();
        let ned = rotated(Frame::NedFrd.quaternion(attitude.matrix()));
        let turned: [f64; 3] = (ned * Vector3::from(Frame::NedFrd.body(arm))).into();
        close(&turned, &Frame::NedFrd.world(world), 1e-12, "turned");
        close(
            rotated(Frame::EnuFlu.quaternion(attitude.matrix())).as_slice(),
            attitude.matrix().as_slice(),
            1e-12,
            "kept",
        );
    }
}

/// The angles of both conventions: the same roll, the opposite pitch, and the yaw of a compass.
#[test]
fn the_angles_are_those_of_a_compass() {
    for attitude in attitudes() {
        let (roll, pitch, yaw) = attitude.euler_angles();
        let ned = Rotation3::from_matrix_unchecked(rotated(Frame::NedFrd.quaternion(attitude.matrix())));
        let (r, p, y) = ned.euler_angles();
        close(&[r, p, 0.0], &[roll, -pitch, wrapped(y - Frame::NedFrd.yaw(yaw))], 1e-9, "angles");
        // The compass shows the direction of the nose, clockwise from north.
        let nose = attitude * Vector3::x();
        close(&[wrapped(nose.x.atan2(nose.y) - y)], &[0.0], 1e-9, "compass");
    }
    assert_eq!(
        (Frame::NedFrd.yaw(0.0), Frame::NedFrd.yaw(FRAC_PI_2), Frame::NedFrd.yaw_rate(1.0)),
        (FRAC_PI_2, 0.0, -1.0)
    );
}

#[test]
fn angles_are_wrapped_to_one_turn() {
    for k in -40..40 {
        let angle = 0.37 * f64::from(k);
        let once = wrapped(angle);
        assert!(once.abs() <= PI, "{once}");
        close(&[once.sin(), once.cos()], &[angle.sin(), angle.cos()], 1e-12, "wrapped");
    }
}
