//! Run times of the stages, and how they grow. `cargo bench` prints tables: sets and plans of the paper's cases, sets by
//! number of rotors, RIP plans by number of samples, RCP against many modes, flights, and plans of the exact model by
//! samples and by modes. `cargo bench --bench speed -- exact` prints only the tables whose names contain the word.

#[path = "../tests/it/vehicles.rs"]
#[allow(dead_code)]
mod vehicles;

use mavc::actuation::Wrench;
use mavc::admissible::{AdmissibleSet, intersection};
use mavc::flight::{Sortie, fly};
use mavc::model::{Allocation, Controller, Detection, LostYaw, Model, PlannerKind, Problem, Strike};
use mavc::motion::wrench_model::WrenchModel;
use mavc::planner::hover::{Decision, HoverPlanner};
use mavc::planner::scp::ScpPlanner;
use mavc::planner::selection::PlanningSet;
use mavc::planner::timing::search::Hint;
use mavc::planner::working_set::WorkingSet;
use std::hint::black_box;
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use vehicles::{lost, mission, octocopter, paper_case, ring_model, waypoint};

/// Adds every single and double loss to the modes.
fn faults(model: &mut Model) {
    let rotors = model.vehicle.rotors.len();
    for i in 1..=rotors {
        model.modes.push(lost(model, &[i]));
        for j in i + 1..=rotors {
            model.modes.push(lost(model, &[i, j]));
        }
    }
}

fn ring(rotors: usize) -> Model {
    ring_model(&"PN".repeat(rotors / 2), 0.25 * rotors as f64, [0.1, 0.1, 0.2], 8.5485e-6, 1.3678e-7, 874.0)
}

/// The least time of many runs, which other work on the machine changes least.
fn stages() {
    println!("\nStages, least of 200 runs\n  what                                                     ms");
    let row = |what: &str, work: &mut dyn FnMut()| {
        println!("  {what:<52}  {:>6.3}", 1e3 * least(200, work).as_secs_f64());
    };
    let mut model = octocopter("PPNNPPNN");
    model.modes.clear();
    faults(&mut model);
    assert_eq!(model.modes.len(), 36);
    row("octocopter, 36 fault sets", &mut || {
        for mode in 0..model.modes.len() {
            black_box(AdmissibleSet::of_mode(&model, mode));
        }
    });
    let singles: Vec<AdmissibleSet> = (0..model.modes.len())
        .filter(|&i| model.modes[i].name.len() == 2)
        .map(|i| AdmissibleSet::of_mode(&model, i))
        .collect();
    let singles: Vec<&AdmissibleSet> = singles.iter().collect();
    row("octocopter, minimal intersection of the single faults", &mut || drop(black_box(intersection(&singles))));
    let model = paper_case(PlannerKind::Rip, &[]);
    let (healthy, set) = healthy_set(&model);
    row("RIP plan of case 1 at 20 s", &mut || {
        let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
        black_box(planner.decide(20.0, 200, &set, &mut WorkingSet::default()));
    });
}

fn healthy_set(model: &Model) -> (AdmissibleSet, PlanningSet) {
    let healthy = AdmissibleSet::healthy(model);
    let set = PlanningSet::of(&[&healthy], &healthy);
    (healthy, set)
}

/// The shortest time of several runs.
fn least(runs: usize, mut work: impl FnMut()) -> Duration {
    let once = |_| {
        let begin = Instant::now();
        work();
        begin.elapsed()
    };
    (0..runs).map(once).min().expect("at least one run")
}

/// Exponent of growth between two measurements.
fn exponent(sizes: [usize; 2], times: [f64; 2]) -> f64 {
    (times[1] / times[0]).ln() / (sizes[1] as f64 / sizes[0] as f64).ln()
}

fn by_rotors() {
    println!("\nHealthy set of a ring PNPN...\n  rotors  facets        ms  exponent");
    let mut before: Option<(usize, f64)> = None;
    for rotors in [4, 8, 12, 16, 20, 24, 28, 32] {
        let model = ring(rotors);
        let facets = AdmissibleSet::healthy(&model).polytope.facets.len();
        let time = 1e3 * least(20, || drop(black_box(AdmissibleSet::healthy(&model)))).as_secs_f64();
        let grown = before.map_or(String::new(), |(n, t)| format!("{:.2}", exponent([n, rotors], [t, time])));
        println!("  {rotors:>6}  {facets:>6}  {time:>8.3}  {grown:>8}");
        before = Some((rotors, time));
    }
}

fn by_samples() {
    println!(
        "\nRIP plan of case 1 at 20 s\n  samples  solves  iterations  solver s  ms per iteration  us per iteration and sample"
    );
    let model = paper_case(PlannerKind::Rip, &[]);
    let (healthy, set) = healthy_set(&model);
    for samples in [200, 500, 1_000, 2_000, 5_000, 10_000] {
        let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
        let decision = planner.decide(20.0, samples, &set, &mut WorkingSet::default());
        let verdict = if let Decision::Feasible(_) = decision { "" } else { "  no plan" };
        let (solves, iterations) = (planner.effort.solves, planner.effort.iterations);
        let seconds = planner.effort.time.as_secs_f64();
        let each = 1e3 * seconds / iterations as f64;
        let per_sample = 1e3 * each / samples as f64;
        println!(
            "  {samples:>7}  {solves:>6}  {iterations:>10}  {seconds:>8.3}  {each:>16.3}  {per_sample:>27.2}{verdict}"
        );
    }
}

/// Sixteen rotors on a ring with every double loss, and a climbing square.
fn sixteen_rotors() -> Model {
    let mut model = ring_model(&"PN".repeat(8), 4.5, [0.2, 0.2, 0.35], 8.5485e-6, 1.3678e-7, 874.0);
    let pairs = (1..=16).flat_map(|i| (i + 1..=16).map(move |j| [i, j]));
    model.modes = pairs.map(|pair| lost(&model, &pair)).collect();
    let corners = [[0.0, 0.0, 2.0], [6.0, 0.0, 3.0], [6.0, 6.0, 4.0], [0.0, 6.0, 3.0], [0.0, 0.0, 2.0]];
    model.mission = Some(mission(corners.map(|corner| waypoint(corner, 0.0)).to_vec()));
    model
}

/// The modes whose admissible set contains hover in its interior.
fn able(model: &Model) -> Vec<usize> {
    let hover = Wrench::new(model.vehicle.mass * model.gravity, 0.0, 0.0, 0.0);
    let inside = |&m: &usize| AdmissibleSet::of_mode(model, m).polytope.margin(&hover) > 1e-6;
    (0..model.modes.len()).filter(inside).collect()
}

/// RCP against the double losses of a sixteen-rotor vehicle with which it can hover, around a climbing square at 200
/// samples.
fn by_modes() {
    println!(
        "\nRCP around a square in the shortest time, 16 rotors, 200 samples\n  modes  rows at a node  sets s  plan s  solves  rows used"
    );
    let model = sixteen_rotors();
    let healthy = AdmissibleSet::healthy(&model);
    let able = able(&model);
    for share in [8, 4, 2, 1] {
        let chosen: Vec<usize> = able.iter().copied().step_by(share).collect();
        let begin = Instant::now();
        let sets: Vec<AdmissibleSet> = chosen.iter().map(|&m| AdmissibleSet::of_mode(&model, m)).collect();
        let set = PlanningSet::of(&sets.iter().collect::<Vec<_>>(), &healthy);
        let sets_took = begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
        let rows = match planner.shortest(&set, Hint::default(), &mut WorkingSet::default()) {
            Ok(shortest) => shortest.planned.rows.to_string(),
            Err(_) => "no plan".into(),
        };
        let plan_took = begin.elapsed().as_secs_f64();
        let (modes, at_node, solves) = (chosen.len(), set.rows.len(), planner.effort.solves);
        println!("  {modes:>5}  {at_node:>14}  {sets_took:>6.2}  {plan_took:>6.2}  {solves:>6}  {rows:>9}");
    }
}

/// A flight of 20 s along case 1 with rotor 1 lost at 5 s, controller at 500 Hz and estimator at 100 Hz, in several
/// configurations.
fn by_flight() {
    println!("\nA flight of 20 s, 20,000 steps\n  what                       ms  simulated s a second  ns a step");
    let model = paper_case(PlannerKind::Rip, &[0]);
    let (healthy, set) = healthy_set(&model);
    let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let Decision::Feasible(planned) = planner.decide(20.0, 200, &set, &mut WorkingSet::default()) else {
        println!("  no plan");
        return;
    };
    let trajectory = planned.trajectory();
    let strike = Strike { mode: 0, at: 5.0, until: None, span: Default::default(), at_span: Default::default() };
    let row = |what: &str, change: fn(&mut Model)| {
        let mut model = model.clone();
        // Some configurations cannot follow this plan. The limits are lifted so that every flight lasts its full
        // duration.
        model.simulation.lost_beyond = 1e9;
        model.simulation.upside_down = 1e9;
        model.simulation.lost_yaw = LostYaw::Off;
        model.simulation.ground = -1e9;
        change(&mut model);
        let strikes = [strike];
        let sortie = Sortie::along(&model, &trajectory, &strikes, 1);
        let mut steps = 0;
        let seconds = least(7, || steps = black_box(fly(&sortie, None)).steps).as_secs_f64();
        let each = 1e9 * seconds / steps as f64;
        println!("  {what:<22} {:>6.2}  {:>20.0}  {each:>9.0}", 1e3 * seconds, 20.0 / seconds);
    };
    row("geometric, estimator", |_| {});
    row("without estimator", |m| m.simulation.detection = Detection::Never);
    row("PD, pseudo-inverse", |m| {
        m.simulation.controller = Controller::Pd;
        m.vehicle.allocation = Allocation::PseudoInverse;
    });
    row("gusts", |m| {
        m.simulation.gusts = 1.0;
        m.simulation.drag = [0.3; 3];
    });
    row("controller at 1 kHz", |m| m.simulation.control_rate = 1000.0);
}

/// CPU seconds of this thread, which do not include other work on the machine; wall seconds where the system does not
/// report them.
fn thread_seconds() -> f64 {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    let begin = BEGIN.get_or_init(Instant::now);
    let running = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = running.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |ns| 1e-9 * ns)
}

/// RIP along case 1's curve in the exact model, at one mission time.
fn exact_by_samples() {
    println!(
        "\nRIP plan of case 1 in the exact model at 24 s; seconds of the thread's own\n  samples  solves  iterations  plan s  \
         ms per iteration  us per iteration and sample"
    );
    let mut model = paper_case(PlannerKind::Rip, &[]);
    let (healthy, set) = healthy_set(&model);
    for samples in [100, 200, 400, 800, 1_600] {
        model.plan.samples = samples;
        let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
        let begin = thread_seconds();
        let decision = ScpPlanner::new(&mut planner, WrenchModel::Exact, &set).decide(24.0, &[]);
        let seconds = thread_seconds() - begin;
        let verdict = if let Decision::Feasible(_) = decision { "" } else { "  no plan" };
        let (solves, iterations) = (planner.effort.solves, planner.effort.iterations);
        let each = 1e3 * seconds / iterations as f64;
        let per_sample = 1e3 * each / samples as f64;
        println!(
            "  {samples:>7}  {solves:>6}  {iterations:>10}  {seconds:>6.2}  {each:>16.3}  {per_sample:>27.2}{verdict}"
        );
    }
}

/// RCP against double losses of sixteen rotors jointly in the exact model, at one mission time.
fn exact_by_modes() {
    println!(
        "\nRCP around a square in the exact model at {SQUARE} s, 16 rotors, 200 samples; seconds of the thread's own\n  \
         modes  rows at a node  sets s  plan s  solves  iterations  rows used  of"
    );
    let model = sixteen_rotors();
    let healthy = AdmissibleSet::healthy(&model);
    let able = able(&model);
    for count in [1, 15, 30, 60, 120] {
        let chosen: Vec<usize> = able.iter().copied().step_by(able.len() / count).take(count).collect();
        let begin = thread_seconds();
        let sets: Vec<AdmissibleSet> = chosen.iter().map(|&m| AdmissibleSet::of_mode(&model, m)).collect();
        let set = PlanningSet::of(&sets.iter().collect::<Vec<_>>(), &healthy);
        let sets_took = thread_seconds() - begin;
        let begin = thread_seconds();
        let mut planner = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
        let decision = ScpPlanner::new(&mut planner, WrenchModel::Exact, &set).decide(SQUARE, &[]);
        let plan_took = thread_seconds() - begin;
        let rows = match decision {
            Decision::Feasible(planned) => planned.rows.to_string(),
            _ => "no plan".into(),
        };
        let (modes, at_node, effort) = (chosen.len(), set.rows.len(), &planner.effort);
        let (solves, iterations, all) = (effort.solves, effort.iterations, at_node * 201);
        println!(
            "  {modes:>5}  {at_node:>14}  {sets_took:>6.2}  {plan_took:>6.2}  {solves:>6}  {iterations:>10}  {rows:>9}  {all}"
        );
    }
}

/// Mission time of the square in the exact model, s.
const SQUARE: f64 = 6.0;

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let tables: [(&str, fn()); 7] = [
        ("stages", stages),
        ("rotors", by_rotors),
        ("samples", by_samples),
        ("modes", by_modes),
        ("flight", by_flight),
        ("exact samples", exact_by_samples),
        ("exact modes", exact_by_modes),
    ];
    for (name, table) in tables {
        if asked.is_empty() || asked.iter().any(|word| name.contains(word.as_str())) {
            table();
        }
    }
}
