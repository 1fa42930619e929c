//! Modes without yaw: motions outside their cores, ranges of spins that the body leaves or that hide a broken row,
//! records of modes that the spec does not free, bounds on turning.

use super::{Kind, Known, evaluated, grown};
use crate::numbers::Numbers;
use crate::specs::Spec;
use crate::truth::Falsehood;
use mavc::certificate::{Certificate, Claim, SpinRecord};
use mavc::motion::{Trajectory, X, Y, YAW};
use mavc::verify::Premise;

const CORES: &[Premise] = &[Premise::Cores];
const SPIN: &[Premise] = &[Premise::Spin];

pub const KINDS: &[Kind] = &[
    evaluated("a motion outside a core", CORES, outside),
    evaluated("a yaw rate beyond the range of spins", SPIN, spinning),
    evaluated("a range of spins that the motion's own rate leaves", SPIN, own_rate),
    evaluated("a range of spins without zero", &[], without_zero),
    evaluated("a range of spins that is not a range", &[], no_range),
    evaluated("a narrower range of spins", CORES, |s, n| scaled(s, n, 1e-4, 0.9)),
    evaluated("a wider range of spins", CORES, |s, n| scaled(s, n, 1.5, 60.0)),
    evaluated("a range of spins that hides a broken row", &[], hiding),
    evaluated("a mode without yaw that the spec does not have", &[], unknown),
    evaluated("a mode without yaw whose yaw the spec keeps", &[], kept),
    evaluated("a mode without yaw left out", &[Premise::Sets], left_out),
    evaluated("an uneven body without a bound on turning", SPIN, |s, n| bounded(s, n, Bound::Missing)),
    evaluated("a bound on turning that is not one", SPIN, |s, n| bounded(s, n, Bound::NotOne)),
    evaluated("a bound on turning that the motion exceeds", SPIN, |s, n| bounded(s, n, Bound::Exceeded)),
    evaluated("a bound on turning that leaves no yaw torque", SPIN, |s, n| bounded(s, n, Bound::TooLarge)),
    evaluated("a selected row of a core left", CORES, selected),
    evaluated("a mode without yaw left out of a selection", &[Premise::Selection], left_out_of_selection),
    Kind {
        name: "a selection that selects nothing of what the motion leaves",
        known: Known::Weaker("the included plan selects no facet"),
        premises: &[Premise::Selection],
        make: nothing_selected,
    },
];

/// A certificate with other records.
fn with(certificate: Certificate, change: impl FnOnce(&mut Vec<SpinRecord>)) -> Option<Certificate> {
    let mut certificate = certificate;
    let Claim::Plan(claim) = &mut certificate.claim else { return None };
    change(&mut claim.without_yaw);
    Some(certificate)
}

/// The honest certificate with one of its records changed.
fn changed(spec: &Spec, numbers: &mut Numbers, change: impl FnOnce(&mut SpinRecord)) -> Option<Certificate> {
    altered(spec, numbers, &spec.honest, change)
}

fn altered(
    spec: &Spec,
    numbers: &mut Numbers,
    motion: &Trajectory,
    change: impl FnOnce(&mut SpinRecord),
) -> Option<Certificate> {
    let index = numbers.below(spec.truth.records.len());
    spec.truth.records.get(index)?;
    with(spec.claiming(motion), |records| change(&mut records[index]))
}

fn has_core(spec: &Spec) -> bool {
    !spec.truth.records.is_empty()
}

fn outside(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !has_core(spec) {
        return None;
    }
    let axis = super::axis(numbers);
    let motion = grown(spec, numbers, (axis, 2), |_, found| matches!(found, Some(Falsehood::Core(_))))?;
    Some(spec.claiming(&motion))
}

/// Beyond a range that the honest motion stays in.
fn spinning(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !has_core(spec) {
        return None;
    }
    let low = own_rates(spec)[0] - numbers.between(0.05, 0.5);
    let is_beyond = |motion: &Trajectory| motion.nodes.iter().any(|s| s[YAW][1] < low - 2e-3);
    let motion = grown(spec, numbers, (YAW, 1), |motion, found| found.is_none() && is_beyond(motion))?;
    altered(spec, numbers, &motion, |record| record.spin_rad_s[0] = low)
}

/// The honest motion's own rates go from `low` to `high`, rad/s.
fn own_rates(spec: &Spec) -> [f64; 2] {
    let rates = spec.honest.nodes.iter().map(|s| s[YAW][1]);
    rates.fold([0.0, 0.0], |[low, high], rate| [low.min(rate), high.max(rate)])
}

fn own_rate(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let [low, high] = own_rates(spec);
    let share = numbers.between(0.0, 0.95);
    // The side to which the motion turns, so that nothing else of the core changes much.
    let side = usize::from(high > -low);
    changed(spec, numbers, |record| record.spin_rad_s[side] = share * [low, high][side])
}

fn without_zero(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let by = numbers.magnitude(2e-3, 2.0);
    let side = numbers.below(2);
    changed(spec, numbers, |record| record.spin_rad_s[side] = if side == 0 { by } else { -by })
}

fn no_range(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let (how, side) = (numbers.below(4), numbers.below(2));
    changed(spec, numbers, |record| match how {
        0 => record.spin_rad_s.swap(0, 1),
        1 => record.spin_rad_s[side] = f64::NAN,
        2 => record.spin_rad_s[1] = f64::INFINITY,
        _ => record.spin_rad_s[0] = f64::NEG_INFINITY,
    })
}

/// With less yaw torque, or more momentum, than the motion allows.
fn scaled(spec: &Spec, numbers: &mut Numbers, least: f64, most: f64) -> Option<Certificate> {
    let factor = numbers.magnitude(least, most);
    let side = numbers.below(3);
    changed(spec, numbers, |record| {
        let sides = if side == 2 { 0..2 } else { side..side + 1 };
        record.spin_rad_s[sides].iter_mut().for_each(|rate| *rate *= factor);
    })
}

/// A motion outside the honest core, with a range with which it would be inside: one that the body does not stay in.
fn hiding(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !has_core(spec) {
        return None;
    }
    let axis = [X, Y][numbers.below(2)];
    let motion = grown(spec, numbers, (axis, 2), |_, found| matches!(found, Some(Falsehood::Core(_))))?;
    (0..30).find_map(|_| {
        let low = numbers.magnitude(2e-3, 30.0);
        let high = low * numbers.between(1.0, 4.0);
        let forged = altered(spec, numbers, &motion, |record| record.spin_rad_s = [low, high])?;
        matches!(spec.truth.falsehood(&forged), Some(Falsehood::Spin(_))).then_some(forged)
    })
}

fn unknown(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let name = ["", "healthy", "M99", "m1"][numbers.below(4)];
    let added = SpinRecord { mode: name.into(), spin_rad_s: [-2.0, 40.0], turning_rad_s: None };
    let renames = numbers.below(2) == 0;
    has_core(spec).then(|| {
        with(spec.certificate(), |records| match records.first_mut().filter(|_| renames) {
            Some(record) => record.mode = name.into(),
            None => records.push(added),
        })
    })?
}

/// Besides a motion that leaves this mode's set, or the honest one.
fn kept(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let plan = &spec.model().plan;
    let kept: Vec<&str> = plan.against.iter().map(|&mode| spec.model().modes[mode].name.as_str()).collect();
    let kept: Vec<&str> = kept.into_iter().filter(|name| spec.truth.records.iter().all(|r| r.mode != *name)).collect();
    let mode = numbers.pick(&kept)?.to_string();
    let spin_rad_s = match spec.truth.records.first() {
        Some(record) if numbers.below(2) == 0 => record.spin_rad_s,
        _ => [-numbers.between(0.1, 3.0), numbers.magnitude(1.0, 100.0)],
    };
    let axis = super::axis(numbers);
    let motion = match numbers.below(2) {
        0 => spec.honest.clone(),
        _ => grown(spec, numbers, (axis, 2), |_, found| found == Some(Falsehood::Set))?,
    };
    with(spec.claiming(&motion), |records| records.push(SpinRecord { mode, spin_rad_s, turning_rad_s: None }))
}

/// Of a motion inside the core and outside the whole set.
fn left_out(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let index = numbers.below(spec.truth.records.len());
    spec.truth.records.get(index)?;
    with(spec.certificate(), |records| drop(records.remove(index)))
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Bound {
    Missing,
    NotOne,
    Exceeded,
    TooLarge,
}

/// Of a body whose moments of inertia about x and y differ. The range is narrowed until the coupling of yaw with
/// turning matters.
fn bounded(spec: &Spec, numbers: &mut Numbers, how: Bound) -> Option<Certificate> {
    let [jx, jy, _] = spec.model().vehicle.inertia;
    let honest = spec.truth.records.first()?.turning_rad_s?;
    if jx == jy {
        return None;
    }
    let drag = spec.model().vehicle.yaw_drag?;
    let rate = match how {
        Bound::Missing => None,
        Bound::NotOne => Some([0.0, -honest, f64::NAN, f64::INFINITY][numbers.below(4)]),
        Bound::Exceeded => Some(honest * numbers.magnitude(1e-4, 0.9)),
        Bound::TooLarge => {
            let torque = drag.torque(spec.truth.records[0].spin_rad_s[1]).max(1e-6);
            Some((2.0 * torque / (jx - jy).abs()).sqrt() * numbers.magnitude(1.05, 100.0))
        }
    };
    if how == Bound::Missing && own_rates(spec) != [0.0, 0.0] {
        return None;
    }
    if how != Bound::Missing {
        return changed(spec, numbers, |record| record.turning_rad_s = rate);
    }
    // The widest range that is too narrow, and would not be if turning took no yaw torque.
    let narrowed = |share: f64| {
        let mut numbers = numbers.clone();
        changed(spec, &mut numbers, |record| {
            record.turning_rad_s = None;
            record.spin_rad_s = [-0.01, share * record.spin_rad_s[1]];
        })
    };
    let is_false = |share: f64| narrowed(share).is_some_and(|forged| spec.truth.falsehood(&forged).is_some());
    let (mut too_narrow, mut enough) = (0.0, 1.0);
    for _ in 0..12 {
        let middle = 0.5 * (too_narrow + enough);
        if is_false(middle) { too_narrow = middle } else { enough = middle }
    }
    narrowed(too_narrow)
}

/// A motion beyond a row of a core that the plan to select by is beyond.
fn selected(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !has_core(spec) || !spec.is_rsp() {
        return None;
    }
    let axis = super::axis(numbers);
    let breaks = |motion: &Trajectory| spec.truth.breaks_selection(motion, &spec.selected_by);
    let motion = grown(spec, numbers, (axis, 2), |motion, found| found.is_none() && breaks(motion))?;
    Some(spec.claiming(&motion))
}

/// Then RSP selects of the whole set, of which the motion breaks something.
fn left_out_of_selection(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !has_core(spec) || !spec.is_rsp() {
        return None;
    }
    let motion = [&spec.honest, &spec.selected_by[0]][numbers.below(2)];
    with(spec.claiming(motion), Vec::clear)
}

/// Selected by a plan that leaves nothing, which the claimed one does.
fn nothing_selected(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let leaving = numbers.pick(&spec.selected_by)?;
    let leaves_none = spec.truth.beyond_modes(&spec.honest) < 0.0 && !spec.truth.selects_by(&spec.honest);
    leaves_none.then(|| spec.claim(leaving, std::slice::from_ref(&spec.honest)))
}
