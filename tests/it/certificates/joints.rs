//! Joints of motions: gaps that are absolute, and what they move together.

use super::{certified, decide, hop};
use mavc::certificate::{Certificate, Claim, MotionRecord};
use mavc::model::PlannerKind;
use mavc::verify::joints::{MOST_GAP, MOST_MOVED};

fn changed(certificate: &Certificate, change: impl Fn(&mut MotionRecord)) -> Certificate {
    let mut changed = certificate.clone();
    let Claim::Plan(claim) = &mut changed.claim else { panic!("no plan") };
    change(&mut claim.motion);
    changed
}

/// One derivative at one node, off by a little more or less than a joint may be.
#[test]
fn each_derivative_has_its_tolerance() {
    let model = hop(PlannerKind::Rip, 12.0);
    let certificate = certified(&model).unwrap();
    for (order, most) in MOST_GAP.into_iter().enumerate() {
        let off = |by: f64| changed(&certificate, |motion| motion.x[8][order] += by);
        let told = decide(&off(1.1 * most), &model).unwrap_err();
        assert_eq!(told.claim, "the joints of the motion", "{told:?}");
    }
    // A gap in yaw counts alike.
    let told = decide(&changed(&certificate, |motion| motion.yaw[8][0] += 2e-6), &model).unwrap_err();
    assert!(told.claim == "the joints of the motion" && told.detail.contains("rad in yaw"), "{told:?}");
    // A gap that nothing is moved by is let be.
    decide(&changed(&certificate, |motion| motion.x[8][0] += 1e-7), &model).unwrap();
}

/// Each gap is within its tolerance, and together they carry the motion away: by closed form, n gaps g in velocity move
/// the end by g times the time that is left after each.
#[test]
fn many_small_gaps_are_too_many() {
    let mut model = hop(PlannerKind::Rip, 12.0);
    model.plan.samples = 60;
    let certificate = certified(&model).unwrap();
    let Claim::Plan(claim) = &certificate.claim else { panic!("no plan") };
    let times = claim.motion.times_s.clone();
    // Every other node is off, except at rest: the piece before misses it in velocity, and the piece after begins with
    // a velocity that takes its end away in position and velocity.
    let moving = |n: usize| claim.motion.x[n][1] != 0.0 && claim.motion.x[n + 1][1] != 0.0;
    let nodes: Vec<usize> = (2..times.len() - 2).step_by(2).filter(|&n| moving(n)).collect();
    let end = times[times.len() - 1];
    let longest = nodes.iter().map(|&n| times[n + 1] - times[n]).fold(0.0, f64::max);
    let moved = |gap: f64| {
        let each = |&n: &usize| gap * ((end - times[n]) + (end - times[n + 1]) + (times[n + 1] - times[n]));
        nodes.iter().map(each).sum::<f64>()
    };
    let with = |gap: f64| changed(&certificate, |motion| nodes.iter().for_each(|&n| motion.x[n][1] += gap));
    let gap = 0.9 * (MOST_GAP[0] / longest).min(MOST_GAP[1]);
    assert!(moved(gap) > MOST_MOVED[0], "{}", moved(gap));
    let told = decide(&with(gap), &model).unwrap_err();
    assert!(told.detail.starts_with("together the gaps may change the position by"), "{told:?}");
    decide(&with(0.5 * gap * MOST_MOVED[0] / moved(gap)), &model).unwrap();
}
