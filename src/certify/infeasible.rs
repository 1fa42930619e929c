//! A certificate that there is no plan: multipliers from the program (of the exact model: its relaxation) that asks how
//! far waypoints would have to be overshot. Those of the dynamics are left out; the checker works them out itself.

use super::facet::facet_of;
use super::plan::motion;
use crate::admissible::AdmissibleSet;
use crate::admissible::row::SetRow;
use crate::certificate::{
    Certificate, Claim, DynamicModel, FacetRecord, FacetWeight, InfeasibleClaim, MAX_FACETS, MAX_MULTIPLIERS,
    Multiplier, RowRecord, SCHEMA, Side,
};
use crate::model::{LimitKind, Mission, Model, PlanModel};
use crate::motion::time_grid::time_grid;
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{Trajectory, YAW};
use crate::planner::hover::HoverPlanner;
use crate::planner::scp::{Relaxed, ScpPlanner};
use crate::planner::studies::PlannerRun;
use crate::planner::transcription::{Purpose, Transcription};
use crate::planner::yaw::YawPlan;
use crate::qp::{Cone, QuadraticProgram, RowOrigin};
use crate::solve::{Outcome, solve_graded};
use crate::verify::{self, Settings};

/// Of a plan that is missing for one motion of yaw only.
const YAW_FIRST: &str = "in the hover model a yaw that changes is planned first, and that there is no plan is shown for that \
                         yaw alone; with `model = exact` it may be shown for all";

const NO_TIME: &str = "fixed times and holds leave some leg no time";

/// Weight of the inputs' cost beside the overshoot: enough to make the solution unique, too little to matter.
const COST: f64 = 1e-12;

/// Multipliers below this share of the largest are left out, if the others show it still.
const NEGLIGIBLE: [f64; 4] = [1e-6, 1e-8, 1e-10, 0.0];

/// The program whose multipliers are wanted.
struct Asked {
    program: QuadraticProgram,
    /// Unit of time of its variables at each node, s.
    taus: Vec<f64>,
    /// In the exact model: of the set's rows, see `MostThrust::weights`.
    thrust: Vec<f64>,
}

/// The certificate that `run` has no plan at `total` seconds.
///
/// # Errors
/// Where the mission does not begin and end as the checker asks, in the hover model where yaw changes, where some facet
/// has no name, or where the multipliers found do not show it.
pub fn certificate(
    model: &Model,
    mission: &Mission,
    run: &PlannerRun,
    total: f64,
    (selected_by, sha256): (&[Trajectory], String),
) -> Result<Certificate, String> {
    let healthy = AdmissibleSet::healthy(model);
    let mut engine = HoverPlanner::new(model, mission, &healthy);
    let (kind, asked) = match model.plan.model {
        PlanModel::Hover => (DynamicModel::Hover, about_hover(&mut engine, run, total)?),
        PlanModel::Exact => (DynamicModel::Exact, relaxed(&mut engine, run, total)?),
    };
    let z = match solve_graded(&asked.program).0 {
        Outcome::Solved(solution) => solution.z,
        Outcome::Infeasible { certificate } => certificate,
        Outcome::Inconclusive { .. } => return Err("no multipliers were found".into()),
    };
    let (facets, thrust) = match kind {
        DynamicModel::Hover => (named(model, run.set.rows.iter())?, Vec::new()),
        DynamicModel::Exact => weighed(model, run, &asked.thrust)?,
    };
    let every = multipliers(&asked.program, &z, &asked.taus, mission).ok_or("a row of the program has no name")?;
    if facets.len() > MAX_FACETS || every.len() > MAX_MULTIPLIERS {
        return Err("it has more rows than a certificate may hold".into());
    }
    let size = |m: &Multiplier| m.z.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let largest = every.iter().map(size).fold(0.0, f64::max);
    let about = |part: Part, share: f64| InfeasibleClaim {
        selected_by: selected_by.iter().map(motion).collect(),
        facets: facets.clone(),
        thrust: thrust.clone(),
        multipliers: every.iter().filter(|m| part.has(&m.row, mission) && size(m) > share * largest).cloned().collect(),
    };
    // Position and yaw are not tied together in the relaxation: where one shows it, what is left of the other is dust.
    let parts: &[Part] = if kind == DynamicModel::Hover { &[Part::Both] } else { &[Part::Position, Part::Yaw] };
    let tried = parts.iter().flat_map(|&part| NEGLIGIBLE.iter().map(move |&share| (part, share)));
    let mut last = String::from("no multipliers were found");
    for (part, share) in tried {
        let claim = Claim::Infeasible(about(part, share));
        let certificate = Certificate { schema: SCHEMA, spec_sha256: sha256.clone(), model: kind, claim };
        // What does not show it is not written.
        match verify::decide(&certificate, model, Settings::default()) {
            Ok(_) => return Ok(certificate),
            Err(refusal) => last = refusal.sentence(),
        }
    }
    Err(format!("the multipliers found do not show it ({last})"))
}

/// The hover model's program, asked how far waypoints would have to be overshot.
fn about_hover(engine: &mut HoverPlanner, run: &PlannerRun, total: f64) -> Result<Asked, String> {
    let (model, mission) = (engine.model, engine.mission);
    let layout = match engine.layout(total, model.plan.samples) {
        Ok(Some(layout)) => layout,
        Ok(None) => return Err(NO_TIME.into()),
        Err(_) => return Err("yaw alone has no plan".into()),
    };
    let YawPlan::Free { .. } = layout.yaw else {
        return Err(YAW_FIRST.into());
    };
    let maps = layout.yaw.maps(model, layout.flown.nodes());
    let leads = layout.commands(model);
    let form = Transcription::new(model, mission, &layout.flown, &run.set, &maps, layout.yaw.axes())
        .with_commands(leads.as_ref());
    Ok(Asked {
        program: form.full_program(Purpose::Overshoot { epsilon: COST }),
        taus: form.taus(),
        thrust: Vec::new(),
    })
}

/// The exact model's relaxation, asked the same.
fn relaxed(engine: &mut HoverPlanner, run: &PlannerRun, total: f64) -> Result<Asked, String> {
    let flown = time_grid(engine.mission, total, engine.model.plan.samples).ok_or(NO_TIME)?.flown();
    let Relaxed { program, taus, thrust } =
        ScpPlanner::new(engine, WrenchModel::Exact, &run.set).overshoot(&flown, COST);
    Ok(Asked { program, taus, thrust: thrust.weights })
}

fn named<'r>(model: &Model, rows: impl Iterator<Item = &'r SetRow>) -> Result<Vec<FacetRecord>, String> {
    let records = rows.map(|row| facet_of(model, row)).collect::<Option<Vec<_>>>();
    records.ok_or_else(|| "a flat set has facets that no three rotors span".into())
}

/// The facets that bound the thrust, with their weights.
fn weighed(model: &Model, run: &PlannerRun, weights: &[f64]) -> Result<(Vec<FacetRecord>, Vec<FacetWeight>), String> {
    let largest = weights.iter().copied().fold(0.0, f64::max);
    let counts = |weight: f64| weight > NEGLIGIBLE[0] * largest;
    let bounding = || run.set.rows.iter().zip(weights).filter(move |&(_, &w)| counts(w));
    let facets = named(model, bounding().map(|(row, _)| row))?;
    let thrust = bounding().enumerate().map(|(facet, (_, &weight))| FacetWeight { facet, weight }).collect();
    Ok((facets, thrust))
}

/// What multipliers are about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Both,
    Position,
    Yaw,
}

impl Part {
    fn has(self, row: &RowRecord, mission: &Mission) -> bool {
        let of_yaw = match *row {
            RowRecord::Rest { axis, .. } => axis == YAW,
            RowRecord::WaypointYaw { .. } => true,
            RowRecord::Limit { limit, .. } => {
                matches!(mission.limits[limit].kind, LimitKind::Yaw | LimitKind::YawRate | LimitKind::YawAcceleration)
            }
            _ => false,
        };
        self == Part::Both || of_yaw == (self == Part::Yaw)
    }
}

/// The multipliers of all rows but the dynamics'. Rows of one origin follow each other in the program: the sides of a
/// limit, the parts of a cone.
fn multipliers(program: &QuadraticProgram, z: &[f64], taus: &[f64], mission: &Mission) -> Option<Vec<Multiplier>> {
    let mut found: Vec<Multiplier> = Vec::new();
    let mut at = 0;
    let mut seen: std::collections::BTreeMap<(usize, usize), usize> = Default::default();
    for cone in &program.cones {
        // Rows of the zero and the nonnegative cone stand alone, a second-order cone's belong together.
        let size = if let Cone::SecondOrder(n) = cone { *n } else { 1 };
        for first in (at..at + cone.rows()).step_by(size) {
            let mut values = z[first..first + size].to_vec();
            let row = match program.row_origin[first] {
                RowOrigin::Dynamics { .. } | RowOrigin::Overshoot | RowOrigin::Violation => continue,
                // Rows of the exact model's steps, which are no relaxation of it, and of stops.
                RowOrigin::Upright { .. } | RowOrigin::Duration { .. } | RowOrigin::Stop { .. } => return None,
                RowOrigin::Lag { facet, node, after } => {
                    let interval = if after { node } else { node.checked_sub(1)? };
                    RowRecord::Commands { facet, node, interval }
                }
                RowOrigin::Thrust { node } => RowRecord::Thrust { node },
                RowOrigin::Rest { node, axis, derivative } => {
                    values[0] *= taus[node].powi(derivative as i32);
                    RowRecord::Rest { node, axis, derivative }
                }
                RowOrigin::Facet { facet, node } => RowRecord::Facet { facet, node },
                RowOrigin::Waypoint { waypoint } => RowRecord::Waypoint { waypoint },
                RowOrigin::WaypointYaw { waypoint } => {
                    let count = seen.entry((usize::MAX, waypoint)).or_default();
                    *count += 1;
                    // The transcription writes `tolerance + (psi - due)` first: what bounds psi from below.
                    let side = if *count == 1 { Side::Lower } else { Side::Upper };
                    RowRecord::WaypointYaw { waypoint, side }
                }
                RowOrigin::Limit { limit, node } => {
                    let count = seen.entry((limit, node)).or_default();
                    *count += 1;
                    let sides = [
                        mission.limits[limit].upper.map(|_| Side::Upper),
                        mission.limits[limit].lower.map(|_| Side::Lower),
                    ];
                    // A jerk limit has a cone for each interval beside its node, from the left.
                    let interval = node.saturating_sub(1) + *count - 1;
                    match sides.into_iter().flatten().nth(*count - 1) {
                        Some(side) if size == 1 => RowRecord::Limit { limit, node, side },
                        _ if size > 1 => RowRecord::LimitNorm { limit, node, interval },
                        _ => return None,
                    }
                }
            };
            // Dust of an interior point: no multiplier of an inequality is negative.
            if !matches!(cone, Cone::Zero(_)) {
                let rest = values[1..].iter().map(|v| v * v).sum::<f64>().sqrt() * (1.0 + 1e-14);
                values[0] = values[0].max(rest);
            }
            found.push(Multiplier { row, z: values });
        }
        at += cone.rows();
    }
    Some(found)
}
