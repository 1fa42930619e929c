//! Models built in code, for tests that need no text.

use mavc::model::*;
use mavc::source::Span;

/// A ring of rotors, first on +y, clockwise; arm 0.211 m; no modes, no mission.
pub fn ring_model(layout: &str, mass: f64, inertia: [f64; 3], b: f64, d: f64, max_speed: f64) -> Model {
    let n = layout.len();
    let rotors = layout
        .chars()
        .enumerate()
        .map(|(k, c)| {
            let a = 2.0 * std::f64::consts::PI * k as f64 / n as f64;
            Rotor {
                position: [0.211 * a.sin(), 0.211 * a.cos(), 0.0],
                spin: if c == 'P' { Spin::P } else { Spin::N },
                thrust_coefficient: b,
                drag_coefficient: d,
                max_speed,
                time_constant: None,
            }
        })
        .collect();
    let span = Span::default();
    Model {
        gravity: 9.81,
        vehicle: Vehicle {
            name: "ring".into(),
            doc: None,
            layout: Some(layout.into()),
            mass,
            inertia,
            rotors,
            span,
            mass_span: span,
        },
        modes: Vec::new(),
        mission: None,
        plan: Plan {
            planner: PlannerKind::Rsp,
            against: Vec::new(),
            time: MissionTime::Minimum,
            samples: 200,
            reserve: 0.0,
            snap_weight: 1e-4,
            acceleration_weight: 1e-4,
            span,
            against_span: span,
            time_span: span,
            samples_span: span,
            reserve_span: span,
        },
        defaults: Vec::new(),
    }
}

/// The paper's octocopter.
pub fn octocopter(layout: &str) -> Model {
    ring_model(layout, 1.8, [0.0429, 0.0429, 0.0748], 8.5485e-6, 1.3678e-7, 874.0)
}

/// The mode in which `rotors` (from 1) are lost.
pub fn lost(model: &Model, rotors: &[usize]) -> FaultMode {
    let n = model.vehicle.rotors.len();
    let names: Vec<String> = rotors.iter().map(usize::to_string).collect();
    FaultMode {
        name: format!("M{}", names.join("_")),
        title: None,
        doc: None,
        capacity: (1..=n).map(|k| if rotors.contains(&k) { 0.0 } else { 1.0 }).collect(),
        stuck: vec![None; n],
        severity: None,
        occurrence: None,
        detection: None,
        rate: None,
        span: Span::default(),
    }
}
