//! Landings and holds that begin at any instant of a mission: the reference itself does not hit the ground.

use super::strike;
use mavc::PlanOutcome;
use mavc::flight::reference::{Course, DESCENT, Stop};
use mavc::flight::{Outcome, Sortie, fly};
use mavc::model::{AfterFault, Detection, FaultMode, Model, RotorState};
use mavc::motion::Trajectory;
use std::sync::LazyLock;

/// Specs, and what keeps their plans quick to make: any plan will do.
const MISSIONS: [(&str, &[&str]); 6] = [
    ("tests/specs/landing/tower.mav", &[]),
    ("tests/specs/landing/return.mav", &[]),
    ("specs/paper/campaign.mav", &["plan.planner=rip"]),
    ("specs/paper/tracking.mav", &["plan.time=25s"]),
    ("src/template.mav", &["plan.planner=rip"]),
    ("examples/survey_hexa.mav", &["plan.planner=rip", "plan.samples=60"]),
];

static PLANS: LazyLock<Vec<(&str, Model, Trajectory)>> =
    LazyLock::new(|| MISSIONS.iter().map(|(name, settings)| planned(name, settings)).collect());

fn planned(name: &'static str, settings: &[&str]) -> (&'static str, Model, Trajectory) {
    let path = format!("{}/{name}", env!("CARGO_MANIFEST_DIR"));
    let compiler = settings.iter().fold(mavc::Compiler::new(), |compiler, setting| compiler.set(*setting));
    let spec = compiler.file(path).unwrap().into_result().unwrap();
    match mavc::plan(&spec).unwrap().outcome() {
        PlanOutcome::Planned(solved) => (name, spec.model().clone(), solved.trajectory.clone()),
        other => panic!("{name}: {other:?}"),
    }
}

/// Samples of a stop that begins at `begin`, until it is at rest or well below the ground: time, height over the
/// ground, vertical speed and acceleration.
fn way(plan: &Trajectory, begin: f64, lands: bool, ground: f64) -> Vec<[f64; 4]> {
    let stop = Stop::from(&Course::Plan(plan).at(begin), begin, lands, ground);
    let end = stop.at_rest() + if lands { stop.place_of_rest().z - ground + 3.0 } else { 1.0 };
    let course = Course::Stop(Box::new(stop));
    let steps = ((end - begin) / 2e-3) as usize;
    let at = |k: usize| begin + 2e-3 * k as f64;
    let row = |t: f64| {
        let r = course.at(t);
        [t, r.position.z - ground, r.velocity.z, r.acceleration.z]
    };
    (0..=steps).map(|k| row(at(k))).collect()
}

const INSTANTS: usize = 60;

/// A stop that must not use up its height brakes no harder than this, m/s^2.
const MOST_BRAKING: f64 = 8.0;

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// A sound vehicle that takes itself for faulty lands, whenever that comes. What it meets is its own path.
    #[test]
    #[ignore = "long"]
    fn landings_from_any_instant_end_on_the_ground_and_not_in_it() {
        for (name, model, plan) in PLANS.iter() {
            let mut model = model.clone();
            let rotors = model.vehicle.rotors.len();
            model.modes = vec![FaultMode {
                rotors: vec![RotorState::Sound; rotors],
                ..model.modes.first().cloned().unwrap_or_else(|| crate::vehicles::lost(&model, &[1]))
            }];
            (model.simulation.detection, model.simulation.after_fault) = (Detection::After(0.0), AfterFault::Land);
            for k in 0..10 {
                // Most of them late, where the ground is near.
                let begin = plan.duration() * (1.0 - (f64::from(k) / 10.0).powi(2)) - 0.01;
                let strikes = [strike(0, begin)];
                let flight = fly(&Sortie::along(&model, plan, &strikes, 1), None);
                assert!(matches!(flight.outcome, Outcome::Landed { .. }), "{name} from {begin}: {flight:?}");
            }
        }
    }

    #[test]
    #[ignore = "long"]
    fn no_stop_leads_into_the_ground() {
        let mut saved = 0;
        for (name, model, plan) in PLANS.iter() {
            let ground = model.simulation.ground;
            for k in 0..=INSTANTS {
                let begin = plan.duration() * k as f64 / INSTANTS as f64;
                for lands in [false, true] {
                    let way = way(plan, begin, lands, ground);
                    let touches = way.iter().find(|[_, height, ..]| *height <= 0.0);
                    match touches {
                        Some([t, _, speed, _]) => {
                            assert!(lands && *speed >= -DESCENT - 1e-9, "{name} from {begin}: {speed} m/s at {t}");
                        }
                        None => assert!(!lands, "{name} from {begin}: it never lands"),
                    }
                    // It can be followed.
                    let hardest = way.iter().map(|[.., a]| a.abs()).fold(0.0, f64::max);
                    let most = MOST_BRAKING.max(1.2 * Course::Plan(plan).at(begin).acceleration.norm());
                    assert!(hardest < most, "{name} from {begin}: {hardest} m/s^2");
                }
                // A stop that knows of no ground.
                let far = -1000.0;
                let strikes = |[_, height, ..]: &[f64; 4]| height + far <= ground;
                saved += usize::from(way(plan, begin, false, far).iter().any(strikes));
            }
        }
        assert!(saved > 10, "only {saved} stops would have struck the ground: the test shows little");
    }
}
