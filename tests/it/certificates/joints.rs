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

/// Each gap is within its tolerance, and together they carry the motion away: by closed form, n gaps g in velocity move the
/// end by g times the time that is left after each.
#[test]
fn many_small_gaps_are_too_many() {
    let model = hop(PlannerKind::Rip, 12.0);
    let certificate = certified(&model).unwrap();
    let Claim::Plan(claim) = &certificate.claim else { panic!("no plan") };
    let times = claim.motion.times_s.clone();
    let (first, last) = (2, times.len() - 3);
    // Every other node is off, so that each makes two gaps.
    let nodes: Vec<usize> = (first..last).step_by(2).filter(|n| claim.motion.x[*n][1] != 0.0).collect();
    let end = times[times.len() - 1];
    let moved = |gap: f64| nodes.iter().map(|&n| gap * ((end - times[n]) + (end - times[n + 1]))).sum::<f64>();
    let gap = 0.9 * MOST_GAP[1];
    let too_much = changed(&certificate, |motion| nodes.iter().for_each(|&n| motion.x[n][1] += gap));
    assert!(moved(gap) > MOST_MOVED[0], "{}", moved(gap));
    let told = decide(&too_much, &model).unwrap_err();
    assert!(told.detail.starts_with("together their gaps may move the position by"), "{told:?}");
    let little = 0.2 * MOST_MOVED[0] / moved(1.0);
    decide(&changed(&certificate, |motion| nodes.iter().for_each(|&n| motion.x[n][1] += little)), &model).unwrap();
}
