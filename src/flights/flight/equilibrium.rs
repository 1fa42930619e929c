//! The spin in which flights without yaw settle: the equilibrium of the controller's primary axis with the slowest yaw
//! torque that the rotors leave (`docs/flight.md`, section 2, "Without yaw").

pub mod flips;

use super::allocate::{Allocator, Belief};
use super::body::Frame;
use super::reduced_attitude::WithoutYaw;
use super::rotors::Rotors;
use crate::actuation::Wrench;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::{self, ModeAnalysis, Standing};
use crate::admissible::{AdmissibleSet, hover};
use crate::model::{Allocation, DynamicFigure, Model, YawDrag};
use nalgebra::Vector3;
use serde::Serialize;
use std::borrow::Cow;

/// Rates at which the balance is evaluated to find its change of sign, and halvings of that interval.
const SCAN: usize = 200;
const HALVINGS: usize = 50;
/// Rates up to the range of the gyroscope at which it is found out whether the spin settles before it.
const STEPS_TO_RANGE: usize = 6;
/// Steps of the momentum of the rotors, which depends on the speeds and they on it.
const STEPS: usize = 10;
/// Share of thrust, roll and pitch that may be missing.
const MISSING: f64 = 1e-3;

/// Where the spin of a mode settles.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SettledSpin {
    /// The mode's name.
    pub mode: String,
    /// The rate about the spin axis, rad/s, counter-clockwise seen from above.
    pub spin_rad_s: f64,
    /// The angle between that axis and z of the body, deg.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub axis_tilt_deg: f64,
    /// Whether a rate about an axis of the body is beyond the range of the gyroscope.
    pub beyond_gyroscope: bool,
}

/// The spins of all modes in which flights give up yaw and can hover, in their order; of a vehicle with an interval of
/// `yaw_drag` or `rotor_inertia` in its middle. Modes without an equilibrium of this kind are left out, and without
/// `yaw_drag` there is none.
pub fn settled_spins(model: &Model) -> Vec<SettledSpin> {
    let Some(drag) = model.vehicle.yaw_drag else { return Vec::new() };
    let mut allocator = Allocator::new(model, Allocation::Bounded);
    (0..model.modes.len()).filter_map(|mode| settled_spin(model, drag, &mut allocator, mode)).collect()
}

/// The analyses of the healthy vehicle and of every mode, with outcomes that consider the gyroscope: see [`outcome`].
pub fn analyze_each(model: &Model) -> Vec<ModeAnalysis> {
    let mut modes = verdict::analyze_each(model);
    if let Some(healthy) = modes.first_mut() {
        healthy.outcome = in_every_drag(model, None, healthy.outcome);
    }
    for (mode, analysis) in modes.iter_mut().skip(1).enumerate() {
        analysis.outcome = outcome(model, mode, analysis.outcome);
    }
    modes
}

/// The outcome in the mode with index `mode`, as in [`analyze_each`].
pub fn outcome_of(model: &Model, mode: usize) -> Outcome {
    outcome(model, mode, verdict::outcome(model, &AdmissibleSet::of_mode(model, mode)))
}

/// The outcomes of the healthy vehicle and of every mode: those of [`analyze_each`] without the figures, which take
/// longer.
pub fn outcomes(model: &Model) -> Vec<Outcome> {
    standings(model).iter().map(|standing| standing.outcome).collect()
}

/// The words of the healthy vehicle and of every mode, with the outcomes of [`analyze_each`].
pub fn standings(model: &Model) -> Vec<Standing> {
    let mut all: Vec<Standing> = AdmissibleSet::each(model).map(|set| Standing::of(model, &set)).collect();
    if let Some(healthy) = all.first_mut() {
        healthy.outcome = in_every_drag(model, None, healthy.outcome);
    }
    for (mode, standing) in all.iter_mut().skip(1).enumerate() {
        standing.outcome = outcome(model, mode, standing.outcome);
    }
    all
}

/// The outcome in the mode with index `mode`, of which the wrenches give `of_wrenches`. A vehicle that flies on, or is
/// caught by spinning, is lost where the spin of its flights settles beyond the range of the gyroscope
/// ([`SettledSpin::beyond_gyroscope`]): the controller loses it some time later. The outcome is undecided where the
/// ends of the intervals of `drag`, `yaw_drag` and `rotor_inertia` differ.
pub fn outcome(model: &Model, mode: usize, of_wrenches: Outcome) -> Outcome {
    let of_wrenches = in_every_drag(model, Some(mode), of_wrenches);
    let Some(drag) = model.vehicle.yaw_drag.filter(|_| matches!(of_wrenches, Outcome::FliesOn | Outcome::Caught))
    else {
        return of_wrenches;
    };
    let mut allocator = Allocator::new(model, Allocation::Bounded);
    let range = model.simulation.gyroscope_range;
    let mut is_beyond = |model: &Model, drag: YawDrag| {
        with_balance(model, drag, &mut allocator, mode, |at, most| most > range && passes(at, range)).unwrap_or(false)
    };
    let drags = if drag.spread.is_none() { vec![drag] } else { drag.ends().to_vec() };
    let with_momenta = match DynamicFigure::RotorInertia.spread(&model.vehicle).is_none() {
        true => vec![Cow::Borrowed(model)],
        false => [0.0, 1.0].map(|share| Cow::Owned(model.at(DynamicFigure::RotorInertia, share))).to_vec(),
    };
    let corners = with_momenta.iter().flat_map(|model| drags.iter().map(move |drag| (model, *drag)));
    let beyond: Vec<bool> = corners.map(|(model, drag)| is_beyond(model, drag)).collect();
    match (beyond.contains(&true), beyond.contains(&false)) {
        (true, false) => Outcome::Lost,
        (false, _) => of_wrenches,
        (true, true) => Outcome::Undecided,
    }
}

/// The outcome that the wrenches of a mode give at both ends of the interval of `drag`, which moves hover in a wind:
/// undecided where they differ from that in the middle.
fn in_every_drag(model: &Model, mode: Option<usize>, in_the_middle: Outcome) -> Outcome {
    let is_still = model.mission.as_ref().is_none_or(|mission| mission.air.wind == [0.0; 3]);
    if model.vehicle.drag_spread.is_none() || is_still {
        return in_the_middle;
    }
    let differs = [0.0, 1.0].into_iter().any(|share| {
        let model = model.at(DynamicFigure::Drag, share);
        let set = mode.map_or_else(|| AdmissibleSet::healthy(&model), |mode| AdmissibleSet::of_mode(&model, mode));
        verdict::outcome(&model, &set) != in_the_middle
    });
    if differs { Outcome::Undecided } else { in_the_middle }
}

fn settled_spin(model: &Model, drag: YawDrag, allocator: &mut Allocator, mode: usize) -> Option<SettledSpin> {
    let w = with_balance(model, drag, allocator, mode, settles)??;
    Some(SettledSpin {
        mode: model.modes[mode].name.clone(),
        spin_rad_s: w.norm().copysign(w.z),
        axis_tilt_deg: w.xy().norm().atan2(w.z.abs()).to_degrees(),
        beyond_gyroscope: w.amax() > model.simulation.gyroscope_range,
    })
}

/// The angular velocity at a rate about the spin axis (rad/s), and the yaw torque beyond what the drag takes (N m).
type Balance<'b> = &'b mut dyn FnMut(f64) -> (Vector3<f64>, f64);

/// The angular velocity where the balance first changes its sign. `most` is the largest rate that is looked at, rad/s.
fn settles(at: Balance, most: f64) -> Option<Vector3<f64>> {
    let begin = at(0.0).1;
    let rate = |k: usize| most.copysign(begin) * k as f64 / SCAN as f64;
    let crossing = (1..=SCAN).find(|&k| (at(rate(k)).1 < 0.0) != (begin < 0.0))?;
    Some(between(at, rate(crossing - 1), rate(crossing), begin))
}

/// Whether the body spins up past a rate on some axis (`range`, rad/s) before the balance changes its sign: as
/// [`settles`] would find, in a few evaluations.
fn passes(at: Balance, range: f64) -> bool {
    let begin = at(0.0).1;
    let mut inside = 0.0;
    for k in 1..=STEPS_TO_RANGE {
        let rate = range.copysign(begin) * k as f64 / STEPS_TO_RANGE as f64;
        let (w, balance) = at(rate);
        match ((balance < 0.0) != (begin < 0.0), w.amax() > range) {
            (true, false) => return false,
            (false, true) => return true,
            (false, false) => inside = rate,
            (true, true) => return between(at, inside, rate, begin).amax() > range,
        }
    }
    true
}

/// The angular velocity where the balance changes its sign between two rates, rad/s.
fn between(at: Balance, mut inside: f64, mut outside: f64, begin: f64) -> Vector3<f64> {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if (at(middle).1 < 0.0) == (begin < 0.0) { inside = middle } else { outside = middle }
    }
    at(outside).0
}

/// Looks at the balance of a mode; `None` where flights do not give up yaw or hover is not possible. The last argument
/// of `look` is the largest rate that matters, rad/s.
fn with_balance<T>(
    model: &Model,
    drag: YawDrag,
    allocator: &mut Allocator,
    mode: usize,
    look: impl FnOnce(Balance, f64) -> T,
) -> Option<T> {
    let fault = &model.modes[mode];
    let belief = Belief { capacity: fault.capacities(), stuck: fault.stuck() };
    let (hover, gains) = (hover(model), &model.simulation.gains);
    if allocator.missing(&hover, &belief) > MISSING {
        return None;
    }
    allocator.believe(&belief);
    let without_yaw = WithoutYaw::of(model.gives_up_yaw(mode), model, allocator, &hover, &belief, gains)?;
    let inertia = Frame::of(model).inertia;
    let slowing = gains.yaw_rate * inertia.z;
    let most = 2.0 * drag.ends()[0].spin(allocator.extent()[3]);
    // The angular velocity at a rate, and the yaw torque beyond what the drag takes.
    let mut at = |r: f64| {
        let (mut momentum, mut found) = (0.0, (Vector3::zeros(), 0.0));
        for _ in 0..STEPS {
            let w = without_yaw.steady(&inertia, r, momentum);
            let torque = w.cross(&(inertia.component_mul(&w) + Vector3::z() * momentum));
            let upright = if r == 0.0 { 1.0 } else { r.abs() / w.norm() };
            let wrench = Wrench::new(hover[0] / upright, torque.x, torque.y, -slowing * r);
            let (given, next) = Rotors::steady(&model.vehicle, &belief, |speeds| {
                allocator.bounded_speeds(&wrench, speeds);
            });
            found = (w, given - drag.torque(r) - torque.z);
            let is_steady = (next - momentum).abs() <= 1e-9 * (1.0 + next.abs());
            momentum = next;
            if is_steady {
                break;
            }
        }
        found
    };
    Some(look(&mut at, most))
}
