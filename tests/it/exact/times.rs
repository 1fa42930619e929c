//! `timing = optimal`: never slower than given shares, against all shares of a grid, with fixed times and holds.

use super::plans::planned;
use super::{last, planning, solved, turning};
use crate::vehicles::{limit, mission, waypoint};
use mavc::model::grid::Spacing;
use mavc::model::{Leg, LimitKind, Mission, MissionTime, Model, PlannerKind};
use mavc::planner::studies::{PlanOutcome, Proof};
use std::sync::LazyLock;

/// Legs of very different lengths.
fn uneven() -> Mission {
    let points = vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([1.0, 0.5, 2.5], 0.3), waypoint([6.0, 2.0, 4.0], 0.6)];
    Mission {
        limits: vec![limit(LimitKind::Tilt, 35f64.to_radians()), limit(LimitKind::Speed, 4.0)],
        ..mission(points)
    }
}

fn quick(mission: Mission, chooses_times: bool) -> Model {
    let mut model = planning(mission, PlannerKind::Rip, &[], MissionTime::Minimum);
    model.plan.samples = 24;
    model.plan.chooses_times = chooses_times;
    model
}

fn shortest(model: &Model) -> f64 {
    solved(last(&planned(model))).time
}

/// Of [`uneven`], with even and with chosen times; several tests ask.
static EVEN: LazyLock<f64> = LazyLock::new(|| shortest(&quick(uneven(), false)));
static CHOSEN: LazyLock<f64> = LazyLock::new(|| shortest(&quick(uneven(), true)));

/// At a time that even shares cannot meet, chosen ones can.
#[test]
fn a_time_too_short_for_even_legs_is_met() {
    let mut model = quick(uneven(), true);
    model.plan.time = MissionTime::Fixed((0.9 * *EVEN * 100.0).round() / 100.0);
    planned(&model);
}

#[test]
#[ignore = "long"]
fn fixed_times_and_holds_are_kept() {
    let mut held = uneven();
    held.waypoints[1].hold = 1.0;
    let [given, chosen] = [false, true].map(|chooses| shortest(&quick(held.clone(), chooses)));
    assert!(chosen <= given, "{chosen} s, {given} s with even times");
    held.waypoints[1].time = Some(2.5);
    let [given, chosen] = [false, true].map(|chooses| shortest(&quick(held.clone(), chooses)));
    // With its first leg fixed the mission has only one left, and nothing to choose.
    assert_eq!(chosen, given);
    let mut met = turning();
    met.waypoints[2].time = Some(4.0);
    let mut model = quick(met, true);
    model.plan.time = MissionTime::Fixed(7.0);
    planned(&model);
}

/// A short way, up at 1 m/s, and along at 4 m/s to a waypoint with a fixed time: what lengths and limits ask for by
/// themselves leaves no plan, other divisions of that time do, whether the mission's time is free or given.
#[test]
#[ignore = "long"]
fn legs_between_fixed_times_divide_their_time_anew() {
    let at = |x: f64, y: f64, z: f64| waypoint([x, y, z], 0.0);
    let mut points =
        vec![at(0.0, 0.0, 2.0), at(0.5, 0.0, 2.0), at(0.5, 0.0, 6.0), at(12.5, 0.0, 6.0), at(12.5, 3.0, 6.0)];
    points[3].time = Some(8.5);
    let limits = vec![limit(LimitKind::Climb, 1.0), limit(LimitKind::Speed, 4.0), limit(LimitKind::Tilt, 0.5)];
    let mission = Mission { limits, spacing: Spacing::Graded, ..mission(points) };
    let mut model = quick(mission.clone(), true);
    let shortest = |model: &Model| {
        let found = planned(model);
        let plan = &solved(last(&found)).trajectory;
        let arrivals: Vec<f64> = plan.waypoint_nodes.iter().map(|&node| plan.times[node]).collect();
        assert_eq!(arrivals[3], 8.5);
        (arrivals, plan.duration())
    };
    let (arrivals, time) = shortest(&model);
    assert!(time < 10.0, "{time}");
    let (up, along) = (arrivals[2] - arrivals[1], arrivals[3] - arrivals[2]);
    // By lengths the climb would take a third of the time along.
    assert!(up > along, "{arrivals:?}");
    model.plan.time = MissionTime::Fixed(11.0);
    assert_eq!(shortest(&model).1, 11.0);
    // The division by lengths, for the planner to keep.
    let legs = [0.5, 4.0, 12.0, 3.0].map(|share| Leg { share }).to_vec();
    let kept = quick(Mission { legs, ..mission }, false);
    assert!(!matches!(last(&super::compared(&kept)).outcome, PlanOutcome::Planned(_)));
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn chosen_times_are_never_slower_than_even_ones() {
        let turned = [false, true].map(|chooses| shortest(&quick(turning(), chooses)));
        for [given, chosen] in [turned, [*EVEN, *CHOSEN]] {
            assert!(chosen <= given, "{chosen} s, {given} s with even times");
        }
    }

    /// The shortest time over shares of the first leg from 15 % to 60 %, each planned for itself.
    #[test]
    #[ignore = "long"]
    fn chosen_times_are_as_good_as_the_best_shares_of_a_grid() {
        let chosen = *CHOSEN;
        let with_share = |percent: u32| -> Option<f64> {
            let first = f64::from(percent) / 100.0;
            let legs = vec![Leg { share: first }, Leg { share: 1.0 - first }];
            let comparison = super::super::compared(&quick(Mission { legs, ..uneven() }, false));
            match &last(&comparison).outcome {
                PlanOutcome::Planned(solved) => Some(solved.time),
                _ => None,
            }
        };
        let tried: Vec<(u32, f64)> = (15..=60).step_by(5).filter_map(|p| Some((p, with_share(p)?))).collect();
        let best = tried.iter().map(|t| t.1).fold(f64::INFINITY, f64::min);
        let worst = tried.iter().map(|t| t.1).fold(0.0, f64::max);
        println!("chosen {chosen}, tried {tried:?}");
        assert!(worst > 1.2 * best, "shares make no difference: {tried:?}");
        assert!(chosen <= 1.02 * best, "{chosen} s, and {best} s with shares of a grid: {tried:?}");
    }

    /// Who chooses times can choose these, so what is proved of all times is proved of these.
    #[test]
    #[ignore = "long"]
    fn a_proof_covers_every_division_of_time() {
        let at = |mission: Mission, chooses_times: bool| {
            let mut model = quick(mission, chooses_times);
            model.plan.time = MissionTime::Fixed(2.3);
            last(&super::super::compared(&model)).outcome.clone()
        };
        let legs = vec![Leg { share: 0.27 }, Leg { share: 0.73 }];
        let given = at(Mission { legs, ..uneven() }, false);
        let chosen = at(uneven(), true);
        assert!(!matches!(given, PlanOutcome::Infeasible(Proof { .. })), "{given:?}");
        assert!(
            !matches!(chosen, PlanOutcome::Infeasible(Proof { .. })),
            "{chosen:?}, but {given:?} with legs of 27 % and 73 %"
        );
    }
}
