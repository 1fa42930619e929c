//! Finds the layouts of eight rotors that tolerate the loss of any one rotor, and up to which mass:
//! `cargo run --release --example sweep_layouts`.

use mavc::Builder;

/// Every layout of eight rotors, four of each spin, with the first one `P`.
fn layouts() -> impl Iterator<Item = String> {
    let letters = |bits: u32| (0..8).map(|k| if bits >> k & 1 == 1 { 'P' } else { 'N' }).collect();
    (0..256u32).filter(|bits| bits.count_ones() == 4 && bits & 1 == 1).map(letters)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut found = Vec::new();
    for layout in layouts() {
        let vehicle = Builder::new()
            .vehicle("layout", layout.as_str())
            .vehicle("arm", 0.211)
            .vehicle("mass", 1.8)
            .vehicle("inertia", [0.0429, 0.0429, 0.0748])
            .rotor("max_thrust", 6.53)
            .rotor("torque_per_thrust", 0.016)
            .rotor("max_speed", 874.0);
        let spec = (1..=8).fold(vehicle, |vehicle, k| vehicle.lost(&format!("M{k}"), &[k])).build()?;
        // The first analysis is that of the healthy vehicle.
        let modes = mavc::analyze(&spec);
        let heaviest = modes.iter().skip(1).map(|mode| mode.critical_mass_kg.unwrap_or(0.0));
        found.push((heaviest.fold(f64::INFINITY, f64::min), layout));
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (mass, layout) in found {
        println!("{layout}  hovers after the loss of any one rotor up to {mass:.2} kg");
    }
    Ok(())
}
