//! Records that are no motion of the spec: numbers that are none, times that turn back, other equations, another spec.

use super::{Kind, Known, evaluated};
use crate::motion::{Timetable, Wish, record};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::{Certificate, Claim, MotionRecord, Vertical};
use mavc::model::PlanModel;
use mavc::motion::wrench_model::WrenchModel;
use mavc::verify::Premise;

const SHAPE: &[Premise] = &[Premise::Shape];

pub const KINDS: &[Kind] = &[
    evaluated("not finite", SHAPE, infinite),
    evaluated("times that turn back", SHAPE, back),
    evaluated("waypoint nodes out of order", &[], out_of_order),
    evaluated("numbers missing", &[], missing),
    evaluated("the hover model for the exact one", &[Premise::Equations], hover),
    Kind { name: "the hash of another spec", known: Known::OtherHash, premises: &[Premise::Spec], make: other_hash },
];

/// The honest certificate with its motion changed.
fn changed(spec: &Spec, change: impl FnOnce(&mut MotionRecord)) -> Option<Certificate> {
    let mut certificate = spec.certificate();
    let Claim::Plan(claim) = &mut certificate.claim else { return None };
    change(&mut claim.motion);
    Some(certificate)
}

fn infinite(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let value = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -f64::NAN][numbers.below(4)];
    let count = spec.honest.nodes.len();
    let (node, order, what) = (numbers.below(count), numbers.below(5), numbers.below(5));
    changed(spec, |motion| match what {
        0 => motion.times_s[node] = value,
        1 => motion.x[node][order] = value,
        2 => motion.y[node][order] = value,
        3 => motion.yaw[node][order.min(2)] = value,
        _ => match &mut motion.z[node] {
            Vertical::Hover(z) => z[order.min(2)] = value,
            Vertical::Exact(z) => z[order] = value,
        },
    })
}

/// Some nodes back and forth again: the same polynomials, flown backwards in between.
fn back(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut motion = spec.honest.clone();
    let last = motion.nodes.len() - 1;
    let far = 1 + numbers.below(3);
    let from = far + numbers.below(last - far);
    // Within a leg, so that waypoint nodes keep their order.
    if motion.waypoint_nodes.iter().any(|&n| (from - far..=from).contains(&n)) {
        return None;
    }
    let again: Vec<usize> = (from - far..from).rev().chain(from - far + 1..=from).collect();
    let times: Vec<f64> = again.iter().map(|&k| motion.times[k]).collect();
    let nodes: Vec<_> = again.iter().map(|&k| motion.nodes[k]).collect();
    let added = times.len();
    motion.times.splice(from + 1..from + 1, times);
    motion.nodes.splice(from + 1..from + 1, nodes);
    motion.waypoint_nodes.iter_mut().filter(|n| **n > from).for_each(|n| *n += added);
    Some(spec.claiming(&motion))
}

fn out_of_order(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let which = numbers.below(6);
    let huge = [usize::MAX, usize::MAX - 1, 1 << 63, 1 << 32][numbers.below(4)];
    let at = numbers.below(spec.honest.waypoint_nodes.len());
    changed(spec, |motion| match which {
        0 => motion.waypoint_nodes.reverse(),
        1 => motion.waypoint_nodes[at] = huge,
        2 => motion.waypoint_nodes[0] = 1,
        3 => motion.waypoint_nodes.push(huge),
        4 => drop(motion.waypoint_nodes.pop()),
        _ => motion.waypoint_nodes[at] = motion.waypoint_nodes[(at + 1) % motion.waypoint_nodes.len()],
    })
}

fn missing(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let which = numbers.below(6);
    changed(spec, |motion| match which {
        0 => drop(motion.x.pop()),
        1 => drop(motion.y.pop()),
        2 => drop(motion.yaw.pop()),
        3 => motion.z.truncate(1),
        4 => motion.times_s.clear(),
        _ => {
            let last = motion.z.len() - 1;
            motion.z[last] = match motion.z[last] {
                Vertical::Hover(_) => Vertical::Exact([0.0; 5]),
                Vertical::Exact(_) => Vertical::Hover([0.0; 3]),
            };
        }
    })
}

/// A motion of the hover model, whose thrust has kinks, for a spec of the exact one; in all else a plan of it.
fn hover(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if spec.model().plan.model != PlanModel::Exact {
        return None;
    }
    let mission = spec.truth.mission();
    let yaw = mission.waypoints[0].yaw;
    let model = if mission.has_one_yaw() { WrenchModel::HoverAt(yaw) } else { WrenchModel::HoverFollowing };
    let table = Timetable::asked(spec.model(), spec.total())?;
    let mut wish = Wish::of(mission);
    // Anywhere within the tolerance.
    let last = wish.places.len() - 1;
    wish.places[last][2] += 0.9 * mission.waypoints[last].within * numbers.between(-1.0, 1.0);
    let motion = wish.motion(&table, model)?;
    let mut forged = spec.claim(&motion, &[]);
    let Claim::Plan(claim) = &mut forged.claim else { return None };
    claim.selected_by = spec.selected_by.iter().map(record).collect();
    Some(forged)
}

fn other_hash(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let hash = format!("{:016x}{:016x}", numbers.next(), numbers.next());
    Some(Certificate { spec_sha256: hash, ..spec.certificate() })
}
