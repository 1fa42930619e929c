//! Plans a mission from Rust values, without a spec file: `cargo run --release --example plan_without_text`.

use mavc::{Builder, PlanOutcome};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rotors = [("max_thrust", 6.53), ("torque_per_thrust", 0.016), ("max_speed", 874.0)];
    let vehicle = Builder::new().vehicle("layout", "PPNNPPNN").vehicle("arm", 0.211).vehicle("mass", 1.8);
    let vehicle = vehicle.vehicle("inertia", [0.0429, 0.0429, 0.0748]);
    let vehicle = rotors.into_iter().fold(vehicle, |vehicle, (field, value)| vehicle.rotor(field, value));
    let mission = vehicle.lost("M1", &[1]).waypoint([0.0, 0.0, 2.0]).waypoint([10.0, 0.0, 5.0]).at_most("speed", 6.0);
    let spec = mission.plan("planner", "rcp").plan("samples", 30).build()?;
    match mavc::plan(&spec)?.outcome() {
        PlanOutcome::Planned(plan) => println!("found: {:.2} s, inside the set without rotor 1", plan.time),
        PlanOutcome::Infeasible(proof) => println!("proved infeasible at {:?} s", proof.proved),
        PlanOutcome::NotFound(why) => println!("not found: {why}"),
        PlanOutcome::NotAttempted { why, .. } => println!("not attempted: {why}"),
    }
    Ok(())
}
