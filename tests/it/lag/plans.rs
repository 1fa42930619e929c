//! Plans for rotors that lag keep their rows at every instant, and cost time.

use super::{compared, lagging, planning, shortest, shuttle, solved, turning, with_commands};
use crate::vehicles::lost;
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::SetRow;
use mavc::model::{Mission, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::motion::{Trajectory, YAW};
use mavc::planner::hover::{Decision, FEASIBLE, HoverPlanner};
use mavc::planner::selection::PlanningSet;
use mavc::planner::transcription::{Purpose, Transcription};
use mavc::planner::working_set::WorkingSet;
use mavc::qp::RowOrigin;
use mavc::solve::{Outcome, solve};

const TAU: f64 = 0.1;

/// The set that RIP, or RCP against all of `against`, imposes.
fn imposed(model: &Model) -> Vec<SetRow> {
    let healthy = AdmissibleSet::healthy(model);
    let modes: Vec<AdmissibleSet> = model.plan.against.iter().map(|&m| AdmissibleSet::of_mode(model, m)).collect();
    let sets: Vec<AdmissibleSet> = match model.plan.planner {
        PlannerKind::Rip => vec![healthy.clone()],
        _ => modes,
    };
    let shrunk: Vec<AdmissibleSet> = sets.iter().map(|s| s.with_reserve(model.plan.reserve)).collect();
    PlanningSet::of(&shrunk.iter().collect::<Vec<_>>(), &healthy).rows
}

/// The largest violation of all rows by w and by w + tau w'.
fn excesses(model: &Model, plan: &Trajectory, tau: f64, looks: usize) -> (f64, f64) {
    let rows = imposed(model);
    let most = |w: &Wrench, so_far: f64| rows.iter().map(|r| r.violation(w)).fold(so_far, f64::max);
    let nothing = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    with_commands(model, plan, tau, looks)
        .iter()
        .fold(nothing, |(own, commanded), (w, c)| (most(w, own), most(c, commanded)))
}

/// A plan with lagging rotors, and how far it would pass the lag's rows had it been made for instant ones.
fn kept(model: &Model, allowed: f64) -> (f64, f64) {
    let lagged = lagging(model.clone(), TAU);
    let comparison = compared(&lagged);
    let plan = &solved(&comparison).trajectory;
    let (own, commanded) = excesses(&lagged, plan, TAU, 9);
    assert!(
        own <= allowed && commanded <= allowed,
        "w violates a row by {own:e}, the commanded wrench by {commanded:e}"
    );
    let comparison = compared(model);
    let without = excesses(model, &solved(&comparison).trajectory, TAU, 9).1;
    (commanded, without)
}

fn conservative(mut model: Model) -> Model {
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    model.plan.planner = PlannerKind::Rcp;
    model.plan.against = vec![0];
    model.plan.reserve = 0.05;
    model
}

#[test]
fn rows_hold_at_every_instant_in_the_hover_model() {
    let rip = planning(shuttle(), PlanModel::Hover, MissionTime::Minimum);
    for model in [rip.clone(), conservative(rip)] {
        let (commanded, without) = kept(&model, 2e-6);
        assert!(commanded > -1e-3, "no row of the lag binds: {commanded}");
        assert!(without > 0.05, "rotors at once keep them too: {without}");
    }
}

/// Under a frozen yaw the wrench bends between nodes. At both ends of every interval rows hold; a fine grid leaves
/// little between.
#[test]
fn rows_hold_at_the_nodes_under_a_changing_yaw() {
    let model = planning(turning(), PlanModel::Hover, MissionTime::Minimum);
    let lagged = lagging(model, TAU);
    let comparison = compared(&lagged);
    let plan = &solved(&comparison).trajectory;
    let rows = imposed(&lagged);
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        let d = 1e-4 * h;
        for (t, side) in [(0.0, 1.0), (h, -1.0)] {
            let w =
                |steps: f64| plan.wrench(&lagged.vehicle, &lagged.environment(), &plan.within(k, t + side * steps * d));
            // One-sided, of third order.
            let rate: Wrench = (w(0.0) * -11.0 + w(1.0) * 18.0 - w(2.0) * 9.0 + w(3.0) * 2.0) * (side / (6.0 * d));
            let commanded = w(0.0) + rate * TAU;
            let worst = rows.iter().map(|r| r.violation(&commanded)).fold(f64::NEG_INFINITY, f64::max);
            assert!(worst < 1e-5, "interval {k}, side {side}: {worst:e}");
        }
    }
    assert!(plan.nodes.iter().any(|s| s[YAW][1].abs() > 0.3), "a plan that hardly turns shows little");
}

#[test]
fn rows_hold_at_every_instant_in_the_exact_model() {
    let rip = planning(turning(), PlanModel::Exact, MissionTime::Fixed(4.2));
    for model in [rip.clone(), conservative(planning(turning(), PlanModel::Exact, MissionTime::Fixed(5.0)))] {
        let (commanded, without) = kept(&model, 1.1e-4);
        assert!(commanded > -0.02, "no row of the lag is near: {commanded}");
        assert!(without > 0.01, "rotors at once keep them too: {without}");
    }
}

#[test]
#[ignore = "long"]
fn shortest_times_of_the_exact_model_keep_the_rows() {
    let mut model = lagging(planning(turning(), PlanModel::Exact, MissionTime::Minimum), TAU);
    model.plan.samples = 24;
    let comparison = compared(&model);
    let (own, commanded) = excesses(&model, &solved(&comparison).trajectory, TAU, 9);
    assert!(own <= 1.1e-4 && commanded <= 1.1e-4, "w violates a row by {own:e}, the commanded wrench by {commanded:e}");
}

fn time_grows(mission: Mission) {
    let instant = planning(mission, PlanModel::Hover, MissionTime::Minimum);
    let at_once = shortest(&instant);
    let with = |tau: f64| shortest(&lagging(instant.clone(), tau));
    assert_eq!(with(1e-6), at_once);
    let times = [0.02, 0.1, 0.3].map(with);
    // Times are multiples of 0.05 s.
    assert!(times[0] - at_once < 0.3 && times[0] >= at_once, "{times:?}, {at_once} s at once");
    assert!(times[0] < times[1] && times[1] < times[2], "{times:?}, {at_once} s at once");
}

/// Slower rotors take longer; ever quicker ones tend to rotors that follow at once.
#[test]
fn time_grows_with_the_constant_and_vanishes_with_it() {
    time_grows(shuttle());
}

/// Rows on demand give the optimum of the program with all rows, that of `emit qp`.
#[test]
fn rows_on_demand_lose_nothing() {
    for mission in [shuttle(), turning()] {
        let mut model = lagging(planning(mission, PlanModel::Hover, MissionTime::Minimum), TAU);
        let time = 1.03 * shortest(&model);
        model.plan.time = MissionTime::Fixed(time);
        let problem = Problem::of(&model).unwrap();
        let healthy = AdmissibleSet::healthy(&model);
        let set = PlanningSet::of(&[&healthy], &healthy);
        let mut engine = HoverPlanner::new(problem, &healthy);
        let Decision::Feasible(planned) = engine.decide(time, model.plan.samples, &set, &mut WorkingSet::default())
        else {
            panic!("no plan at {time} s")
        };
        let layout = engine.layout(time, model.plan.samples).unwrap().unwrap();
        let (maps, leads) = (layout.yaw.maps(&model, layout.flown.nodes()), layout.commands(&model));
        let form = Transcription::new(problem, &layout.flown, &set, &maps, layout.yaw.axes());
        let without = form.full_program(Purpose::Plan { slack: FEASIBLE });
        let form = form.with_commands(leads.as_ref());
        let program = form.full_program(Purpose::Plan { slack: FEASIBLE });
        let count = |lag: bool| {
            let of = |o: &&RowOrigin| {
                if lag { matches!(o, RowOrigin::Lag { .. }) } else { matches!(o, RowOrigin::Facet { .. }) }
            };
            program.row_origin.iter().filter(of).count()
        };
        // Two ends of each interval, against one node.
        assert_eq!(count(true), 2 * layout.flown.intervals() * set.rows.len());
        assert_eq!(count(false), layout.flown.nodes() * set.rows.len());
        let objective = |program| match solve(program).0 {
            Outcome::Solved(solution) => solution.objective,
            other => panic!("{other:?}"),
        };
        let (full, less) = (objective(&program), objective(&without));
        assert!((planned.objective / full - 1.0).abs() < 1e-5, "{} and {full}", planned.objective);
        assert!(full > less * (1.0 + 1e-4), "{full}, and {less} without the lag");
    }
}

/// Very long; a command of their own runs these (CONTRIBUTING.md).
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn the_exact_models_time_grows_too() {
        let mut instant = planning(shuttle(), PlanModel::Exact, MissionTime::Minimum);
        instant.plan.samples = 16;
        let at_once = shortest(&instant);
        let [quick, slow] = [1e-6, 0.3].map(|tau| shortest(&lagging(instant.clone(), tau)));
        // Both are found, not proved.
        assert!((quick / at_once - 1.0).abs() < 0.05, "{quick} s and {at_once} s");
        assert!(slow > 1.1 * at_once.max(quick), "{slow} s, {at_once} s and {quick} s");
    }

    #[test]
    #[ignore = "long"]
    fn time_grows_under_a_changing_yaw_too() {
        time_grows(turning());
    }
}
