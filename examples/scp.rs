use mavc::admissible::AdmissibleSet;
use mavc::planner::rows::Engine;
use mavc::planner::select::PlanningSet;
use mavc::planner::successive::Successive;
use mavc::planner::wrench_model::WrenchModel;
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let which = std::env::args().nth(2).unwrap_or("rip".into());
    let bytes = std::fs::read(&path).unwrap();
    let (files, _) = mavc::model::load(&path, &bytes, &|p| std::fs::read(p));
    let mut model = mavc::model::elaborate(&files, &[]).value.unwrap();
    model.plan.chooses_times = std::env::var("OPT").is_ok();
    let mission = model.mission.clone().unwrap();
    let healthy = AdmissibleSet::healthy(&model);
    let r = model.plan.reserve;
    let modes: Vec<AdmissibleSet> = model.plan.against.iter().map(|&i| AdmissibleSet::of_mode(&model, i).with_reserve(r)).collect();
    let shrunk = healthy.with_reserve(r);
    let set = match which.as_str() {
        "rip" => PlanningSet::of(&[&shrunk], &healthy),
        _ => PlanningSet::of(&modes.iter().collect::<Vec<_>>(), &healthy),
    };
    let mut engine = Engine::new(&model, &mission, &healthy);
    let begin = std::time::Instant::now();
    let wrench = if std::env::var("HOVER").is_ok() { WrenchModel::HoverAt(0.0) } else { WrenchModel::Exact };
    let mut s = Successive::new(&mut engine, wrench, &set);
    if let Some(t) = std::env::args().nth(3) {
        let d = s.decide(t.parse().unwrap(), None);
        println!("{}", match d { mavc::planner::rows::Decision::Feasible(p) => format!("feasible {}", p.objective), o => format!("{o:?}").chars().take(80).collect() });
    } else {
        match s.shortest(None) {
            Ok(f) => println!("shortest {} objective {}", f.time, f.planned.objective),
            Err(e) => println!("{e:?}"),
        }
    }
    println!("{:?} in {:?}", engine.effort, begin.elapsed());
}
