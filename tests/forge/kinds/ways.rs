//! Ways out after faults that are none.

use super::{Kind, evaluated};
use crate::motion::{add_spline, of_record, record};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::{Certificate, MotionRecord, RecoveryClaim, WayRecord};
use mavc::motion::{NodeState, Trajectory, X, Y, Z};
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    evaluated("a way out without the longest delay", &[Premise::WayFollows], hasty),
    evaluated("a way out for an instant twice", &[Premise::WayFollows], twice),
    evaluated("a way out that takes too long", &[Premise::WayTime], slow),
    evaluated("a way out from elsewhere", &[Premise::WayStart], shifted),
    evaluated("a way out beyond the mode's set", &[Premise::WayRows], bent),
    evaluated("a way out from states too far away", &[Premise::WayRows], wide),
    evaluated("a way out to another site", &[Premise::WayEnd], misnamed),
    evaluated("a way out that ends in the air", &[Premise::WayEnd], hovering),
    evaluated("a way back that ends beside the plan", &[Premise::WayRows], beside),
    evaluated("a way back to a plan that leaves the set later", &[Premise::WayEnd], premature),
    evaluated("a way out that is torn", &[Premise::Joints], torn),
    evaluated("a way out that the spec does not allow", &[], forbidden),
];

/// The honest certificate with other ways out.
fn changed(spec: &Spec, change: impl FnOnce(&mut RecoveryClaim) -> Option<()>) -> Option<Certificate> {
    let mut ways = spec.ways.clone()?;
    change(&mut ways)?;
    Some(spec.with_ways(ways))
}

/// Changes every branch of a claim.
fn each(spec: &Spec, ways: &mut RecoveryClaim, change: impl Fn(&mut Trajectory)) -> Option<()> {
    for branch in &mut ways.branches {
        *branch = again(spec, branch, &change)?;
    }
    Some(())
}

fn again(spec: &Spec, branch: &MotionRecord, change: impl Fn(&mut Trajectory)) -> Option<MotionRecord> {
    let mut motion = of_record(branch, spec.honest.model)?;
    change(&mut motion);
    Some(record(&motion))
}

fn hasty(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let longest = spec.model().plan.recovery.detection[1];
    changed(spec, |ways| {
        let last: Vec<usize> = (0..ways.families.len()).filter(|&i| ways.families[i].delays_s[1] == longest).collect();
        let place = *numbers.pick(&last)?;
        match numbers.below(2) {
            0 => {
                ways.families.remove(place);
            }
            _ => ways.families[place].delays_s[1] -= 1e-3 * numbers.between(1.0, 20.0),
        }
        (!ways.families.is_empty()).then_some(())
    })
}

fn twice(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    changed(spec, |ways| {
        let place = numbers.below(ways.families.len());
        ways.families.insert(place, ways.families[place].clone());
        Some(())
    })
}

/// The same places, later.
fn slow(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let within = spec.model().plan.recovery.within;
    let beyond = numbers.between(1.001, 1.5);
    changed(spec, |ways| {
        each(spec, ways, |motion| {
            let factor = beyond * within / motion.duration();
            motion.times.iter_mut().for_each(|time| *time *= factor);
            let later = |state: &mut NodeState| {
                state.iter_mut().for_each(|axis| {
                    axis.iter_mut().enumerate().for_each(|(k, value)| *value /= factor.powi(k as i32));
                });
            };
            motion.nodes.iter_mut().for_each(later);
        })
    })
}

/// Beside where the vehicle can be, and still down within the site.
fn shifted(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let angle = numbers.between(0.0, std::f64::consts::TAU);
    let by = numbers.between(0.3, 1.4);
    changed(spec, |ways| {
        each(spec, ways, |motion| {
            motion.nodes.iter_mut().for_each(|state| {
                state[X][0] += by * angle.cos();
                state[Y][0] += by * angle.sin();
            });
        })
    })
}

/// All branches with a bend; the ends stay.
fn bent(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let axis = [X, Y][numbers.below(2)];
    let size = numbers.sign() * numbers.magnitude(0.5, 50.0);
    let share = numbers.between(0.1, 0.6);
    changed(spec, |ways| {
        each(spec, ways, |motion| {
            let first = (share * motion.nodes.len() as f64) as usize;
            add_spline(motion, axis, first, 2, size);
        })
    })
}

fn wide(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let factor = numbers.magnitude(10.0, 1e4);
    let which = numbers.below(3);
    changed(spec, |ways| {
        for family in &mut ways.families {
            let tolerance = &mut family.tolerance;
            match which {
                0 => tolerance.tilt_rad = factor * tolerance.tilt_rad.max(1e-4),
                1 => tolerance.turning_rad_s = factor * tolerance.turning_rad_s.max(1e-4),
                _ => tolerance.velocity_m_s = factor * tolerance.velocity_m_s.max(1e-3),
            }
        }
        Some(())
    })
}

fn misnamed(spec: &Spec, _: &mut Numbers) -> Option<Certificate> {
    changed(spec, |ways| {
        ways.families.iter_mut().for_each(|family| family.way = WayRecord::LandAt("far".into()));
        Some(())
    })
}

/// The ground is where the branches end; the site is not.
fn hovering(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    // No farther than a vehicle may have risen meanwhile.
    let by = numbers.between(0.03, 0.08);
    changed(spec, |ways| each(spec, ways, |motion| motion.nodes.iter_mut().for_each(|state| state[Z][0] += by)))
}

/// Branches that end beside the plan. The nearer ones return all the same, as the polynomials of their members take them
/// to the plan.
fn beside(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let angle = numbers.between(0.0, std::f64::consts::TAU);
    let far = numbers.magnitude(5.0, 200.0);
    changed(spec, |ways| {
        let is_back = ways.families.iter().all(|family| family.way == WayRecord::Continue);
        is_back.then_some(())?;
        each(spec, ways, |motion| {
            lead_to(motion, X, far * angle.cos());
            lead_to(motion, Y, far * angle.sin());
        })
    })
}

/// Adds `by (5 x^4 - 4 x^5)` with x = t/T, which at the beginning changes nothing below the fourth derivative.
fn lead_to(motion: &mut Trajectory, axis: usize, by: f64) {
    let whole = motion.duration();
    for (time, node) in motion.times.iter().zip(&mut motion.nodes) {
        let x = time / whole;
        let shape = [
            x.powi(4) * (5.0 - 4.0 * x),
            20.0 * x.powi(3) * (1.0 - x),
            20.0 * x * x * (3.0 - 4.0 * x),
            120.0 * x * (1.0 - 2.0 * x),
            120.0 * (1.0 - 4.0 * x),
        ];
        for (order, value) in shape.into_iter().enumerate() {
            node[axis][order] += by * value / whole.powi(order as i32);
        }
    }
}

/// Ways back before the plan leaves the mode's set, with the honest ones after them or without.
fn premature(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut early = spec.too_early.clone()?;
    let with_the_others = numbers.below(2) == 0;
    changed(spec, |ways| {
        let until = early.families.last()?.to_s;
        let first = early.branches.len();
        if with_the_others {
            for mut family in ways.families.drain(..).filter(|family| family.from_s >= until) {
                family.corners.iter_mut().for_each(|corner| *corner += first);
                early.families.push(family);
            }
            early.branches.append(&mut ways.branches);
        }
        *ways = early;
        Some(())
    })
}

fn torn(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let gap = numbers.sign() * numbers.magnitude(1e-4, 0.02);
    let axis = [X, Y][numbers.below(2)];
    changed(spec, |ways| {
        each(spec, ways, |motion| {
            let middle = motion.nodes.len() / 2;
            motion.nodes[middle][axis][0] += gap;
        })
    })
}

fn forbidden(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    changed(spec, |ways| {
        let place = numbers.below(ways.families.len());
        ways.families[place].way = [WayRecord::Continue, WayRecord::LandHere][numbers.below(2)].clone();
        Some(())
    })
}
