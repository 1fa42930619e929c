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
                min_speed: 0.0,
                max_speed,
                time_constant: None,
                inertia: 0.0,
                inertia_spread: Spread::NONE,
                motor: None,
                spread: RotorSpread::default(),
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
            mass_spread: Spread::NONE,
            inertia,
            centre_of_gravity: None,
            battery: None,
            drag: [0.0; 3],
            drag_spread: Spread::NONE,
            drag_span: None,
            yaw_drag: None,
            propeller_radius: None,
            size: None,
            rotors,
            allocation: Allocation::Bounded,
            span,
            mass_span: span,
        },
        modes: Vec::new(),
        mission: None,
        plan: PlanSettings {
            planner: PlannerKind::Rsp,
            model: PlanModel::Hover,
            rotors: PlanRotors::Instant,
            chooses_times: false,
            against: Vec::new(),
            time: MissionTime::Minimum,
            effort: SearchEffort::Normal,
            samples: 200,
            reserve: 0.0,
            snap_weight: 1e-4,
            acceleration_weight: 1e-4,
            span,
            against_span: span,
            time_span: span,
            samples_span: span,
            reserve_span: span,
            rotors_span: span,
            rounds: 1,
            require_capture: None,
            recovery: RecoverySettings::default(),
            require_risk: None,
            after_fault: AfterFault::Continue,
            without_yaw: GiveUpYaw::WhereNeeded,
            require_span: span,
        },
        simulation: Default::default(),
        campaign: Default::default(),
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
        rotors: (1..=n).map(|k| if rotors.contains(&k) { RotorState::Lost } else { RotorState::Sound }).collect(),
        severity: None,
        occurrence: None,
        detection: None,
        rate: None,
        rate_spread: Spread::NONE,
        after_fault: None,
        without_yaw: None,
        recovery: None,
        span: Span::default(),
    }
}

/// The paper's hexacopter.
pub fn hexacopter(layout: &str) -> Model {
    ring_model(layout, 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0)
}

/// The paper's quadcopter.
pub fn quadcopter() -> Model {
    ring_model("PNPN", 1.32, [0.0128, 0.0128, 0.0239], 9.9865e-6, 1.5978e-7, 840.0)
}

/// A waypoint to be met within 5 cm and 0.05 rad, flown through.
pub fn waypoint(position: [f64; 3], yaw: f64) -> Waypoint {
    Waypoint {
        name: None,
        position,
        yaw,
        within: 0.05,
        yaw_within: 0.05,
        weight: 1.0,
        time: None,
        hold: 0.0,
        heading: Heading::Given,
        stop: false,
        span: Span::default(),
        time_span: None,
        hold_span: None,
    }
}

/// A mission from rest to rest with legs of equal share.
pub fn mission(waypoints: Vec<Waypoint>) -> Mission {
    Mission {
        name: "test".into(),
        doc: None,
        legs: vec![Leg { share: 1.0 }; waypoints.len() - 1],
        spacing: grid::Spacing::Even,
        waypoints,
        start_at_rest: true,
        end_at_rest: true,
        limits: Vec::new(),
        volumes: Vec::new(),
        origin: None,
        after_fault: AfterFaultRules::default(),
        ground: None,
        air: Air::still(Span::default()),
        span: Span::default(),
    }
}

pub fn limit(kind: LimitKind, upper: f64) -> Limit {
    let both_ways = matches!(kind, LimitKind::YawRate | LimitKind::YawAcceleration);
    let lower = both_ways.then_some(-upper);
    Limit { kind, lower, upper: Some(upper), span: Span::default(), volume: None, leg: None }
}

/// Viviani's curve of section 5.4 with a = 4 m: 21 points evenly spaced in s and time.
pub fn viviani() -> Mission {
    let a = 4.0;
    let point = |i: i32| {
        let s = 4.0 * std::f64::consts::PI * f64::from(i) / 20.0;
        waypoint([a * (1.0 + s.cos()), a * s.sin(), 10.0 + 2.0 * a * (s / 2.0).sin()], 0.0)
    };
    mission((0..=20).map(point).collect())
}

/// Round a tower: explicit waypoints, a hold, a fixed time, a turning nose.
pub fn inspection() -> Mission {
    let mut points = vec![
        waypoint([0.0, 0.0, 2.0], 1.5),
        waypoint([12.0, 3.0, 18.0], 0.8),
        waypoint([12.0, -3.0, 18.0], -0.4),
        waypoint([0.0, 0.0, 3.0], -1.5),
    ];
    points[1].hold = 4.0;
    points[2].time = Some(18.0);
    Mission { limits: vec![limit(LimitKind::Speed, 6.0)], ..mission(points) }
}

/// The PPNNPPNN octocopter with modes M1 to M8 and M1_6 (indices 0 to 8), on Viviani's curve.
pub fn paper_case(planner: PlannerKind, against: &[usize]) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    model.modes.push(lost(&model, &[1, 6]));
    model.mission = Some(viviani());
    model.plan.planner = planner;
    model.plan.against = against.to_vec();
    model
}
