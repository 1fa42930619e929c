//! RSP: plans to select by that are none, and facets that are not kept.

use super::{Kind, evaluated};
use crate::motion::{Timetable, Wish, evenly, holds};
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::Certificate;
use mavc::model::grid::leg_durations;
use mavc::motion::Trajectory;
use mavc::verify::Premise;

const SELECTED: &[Premise] = &[Premise::SelectedBy];

pub const KINDS: &[Kind] = &[
    evaluated("selected by a slow motion", SELECTED, slow),
    evaluated("selected by a motion elsewhere", SELECTED, elsewhere),
    evaluated("selected by a motion that does not join", SELECTED, torn),
    evaluated("selected by a motion outside the healthy set", SELECTED, outside),
    evaluated("no plan to select by", SELECTED, none),
    evaluated("more plans to select from than rounds", SELECTED, surplus),
    evaluated("a plan to select by without a selection", SELECTED, unasked),
    evaluated("rounds swapped", &[Premise::SelectedBy, Premise::Selection], swapped),
    evaluated("facets not kept", &[Premise::Selection], unkept),
    evaluated("the plan to select by as the plan", &[Premise::Selection], itself),
];

/// In place of one of the plans to select by, another motion; the plan is one that breaks what the true one selects.
fn replaced(spec: &Spec, numbers: &mut Numbers, by: Trajectory) -> Option<Certificate> {
    let mut selected_by = spec.selected_by.clone();
    *selected_by.first_mut()? = by;
    let claimed = [&spec.honest, spec.selected_by.first()?][numbers.below(2)];
    Some(spec.claim(claimed, &selected_by))
}

/// The mission in another time, which violates nothing.
fn slow(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.is_rsp() {
        return None;
    }
    let mission = spec.truth.mission();
    let durations = leg_durations(mission, spec.total())?;
    let factor = numbers.between(1.2, 3.0);
    // Where the total is free only the share of one leg is wrong.
    let legs = if spec.has_one_grid() { durations.len() } else { 1 };
    let slower: Vec<f64> = durations.iter().enumerate().map(|(i, d)| if i < legs { d * factor } else { *d }).collect();
    let counts = mavc::model::grid::pieces(mission, &slower, spec.model().plan.samples);
    let even: Vec<Vec<f64>> = counts.iter().map(|&n| evenly(n)).collect();
    let table = Timetable::of(&holds(mission), &slower, &even);
    replaced(spec, numbers, Wish::of(mission).motion(&table, spec.truth.equations)?)
}

/// Standing about at the start.
fn elsewhere(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.is_rsp() {
        return None;
    }
    let mission = spec.truth.mission();
    let table = Timetable::asked(spec.model(), spec.total())?;
    let mut wish = Wish::of(mission);
    let share = numbers.between(0.0, 0.9);
    let start = wish.places[0];
    wish.places.iter_mut().for_each(|p| (0..4).for_each(|i| p[i] = start[i] + share * (p[i] - start[i])));
    replaced(spec, numbers, wish.motion(&table, spec.truth.equations)?)
}

fn torn(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.is_rsp() {
        return None;
    }
    let mut motion = spec.honest.clone();
    let node = 1 + numbers.below(motion.nodes.len() - 2);
    let derivative = numbers.below(4);
    let tolerance = 1e-6 * 10f64.powi(derivative as i32);
    motion.nodes[node][numbers.below(2)][derivative] += numbers.sign() * tolerance * numbers.magnitude(11.0, 1e4);
    replaced(spec, numbers, motion)
}

fn outside(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.is_rsp() {
        return None;
    }
    let axis = super::axis(numbers);
    let healthy = |motion: &Trajectory| spec.truth.of_selecting(motion) == Some(crate::truth::Falsehood::Set);
    let motion = super::grown(spec, numbers, (axis, 2), |motion, _| healthy(motion))?;
    replaced(spec, numbers, motion)
}

fn none(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let claimed = [Some(&spec.honest), spec.selected_by.first()][numbers.below(2)]?;
    spec.is_rsp().then(|| spec.claim(claimed, &[]))
}

fn surplus(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut selected_by = spec.selected_by.clone();
    let again = numbers.pick(&spec.selected_by)?.clone();
    for _ in 0..=numbers.below(3) {
        selected_by.push(if numbers.below(2) == 0 { again.clone() } else { spec.honest.clone() });
    }
    Some(spec.claim(&spec.honest, &selected_by))
}

/// Of a planner that selects nothing.
fn unasked(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let selected_by = vec![spec.honest.clone(); 1 + numbers.below(2)];
    (!spec.is_rsp()).then(|| spec.claim(&spec.honest, &selected_by))
}

fn swapped(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let [first, second] = &spec.selected_by[..] else { return None };
    // The motion that is the plan, or the round that broke what the other selects.
    let claimed = [&spec.honest, second, first][numbers.below(3)];
    Some(spec.claim(claimed, &[second.clone(), first.clone()]))
}

/// A plan of the healthy set that is beyond a facet which the plan carried violates.
fn unkept(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    if !spec.is_rsp() {
        return None;
    }
    let axis = super::axis(numbers);
    let breaks = |motion: &Trajectory| spec.truth.breaks_selection(motion, &spec.selected_by);
    let motion = super::grown(spec, numbers, (axis, 2), |motion, found| found.is_none() && breaks(motion))?;
    Some(spec.claiming(&motion))
}

fn itself(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let motion = numbers.pick(&spec.selected_by)?;
    Some(spec.claiming(motion))
}
