//! Certificates that there is no plan: multipliers of the program that minimises by how much waypoint tolerances must
//! be exceeded (in the exact model: of its relaxation). The multipliers of the dynamics are omitted; the checker
//! computes them.

use super::facet::facet_of;
use super::witness::motion;
use crate::admissible::AdmissibleSet;
use crate::admissible::row::SetRow;
use crate::certificate::{
    Certificate, Claim, DynamicModel, FacetRecord, FacetWeight, InfeasibleClaim, MAX_FACETS, MAX_MULTIPLIERS,
    Multiplier, RowRecord, SCHEMA, Side,
};
use crate::model::{Mission, Model, PlanModel, Problem};
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

/// Why there is no certificate for a mission in which yaw changes.
const YAW_FIRST: &str = "in the hover model a yaw that changes is planned first, so infeasibility is shown for that \
    yaw alone; with `model = exact` it may be shown for every yaw";

const TOO_MANY: &str = "it has more rows than a certificate may hold";

const NO_TIME: &str = "fixed times and holds leave no time for some leg";

/// Weight of the inputs' cost relative to the overshoot: large enough to make the solution unique, too small to matter.
/// Chosen by hand.
const COST: f64 = 1e-12;

/// Multipliers below this share of the largest are omitted if the others still prove the claim; tried in turn.
/// Chosen by hand.
const NEGLIGIBLE: [f64; 4] = [1e-6, 1e-8, 1e-10, 0.0];

/// The program whose multipliers are computed.
struct Overshoot {
    program: QuadraticProgram,
    /// Unit of time of its variables at each node, s.
    taus: Vec<f64>,
    /// The node of each waypoint.
    waypoint_nodes: Vec<usize>,
    /// In the exact model: weights of the set's rows, see `MostThrust::weights`.
    thrust: Vec<f64>,
}

/// The certificate that `run` has no plan at `total` seconds.
///
/// # Errors
/// The mission does not begin or end as the checker requires, yaw changes in the hover model, some facet cannot be
/// named by rotors, or the multipliers found do not prove the claim.
pub fn certificate(
    problem: Problem,
    run: &PlannerRun,
    total: f64,
    selected_by: &[Trajectory],
    sha256: String,
) -> Result<Certificate, String> {
    let (model, mission) = (problem.model(), problem.mission());
    let healthy = AdmissibleSet::healthy(model);
    let mut planner = HoverPlanner::new(problem, &healthy);
    let (kind, overshoot) = match model.plan.model {
        PlanModel::Hover => (DynamicModel::Hover, about_hover(&mut planner, run, total)?),
        PlanModel::Exact => (DynamicModel::Exact, relaxed(&mut planner, run, total)?),
    };
    let z = match solve_graded(&overshoot.program).0 {
        Outcome::Solved(solution) => solution.z,
        Outcome::Infeasible { certificate } => certificate,
        Outcome::Inconclusive { .. } => return Err("no multipliers were found".into()),
    };
    let (facets, thrust) = match kind {
        DynamicModel::Hover => (named(model, run.set.rows.iter())?, Vec::new()),
        DynamicModel::Exact => weighed(model, run, &overshoot.thrust)?,
    };
    let every = multipliers(&overshoot, &z, mission).ok_or("a row of the program cannot be named")?;
    if facets.len() > MAX_FACETS || every.len() > MAX_MULTIPLIERS {
        return Err(TOO_MANY.into());
    }
    let size = |m: &Multiplier| m.z.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let largest = every.iter().map(size).fold(0.0, f64::max);
    let about = |part: Part, share: f64| InfeasibleClaim {
        selected_by: selected_by.iter().map(motion).collect(),
        facets: facets.clone(),
        thrust: thrust.clone(),
        multipliers: every.iter().filter(|m| part.has(&m.row, mission) && size(m) > share * largest).cloned().collect(),
    };
    // Position and yaw are independent in the relaxation: if one proves the claim, the other's multipliers are noise.
    let parts: &[Part] = if kind == DynamicModel::Hover { &[Part::Both] } else { &[Part::Position, Part::Yaw] };
    let tried = parts.iter().flat_map(|&part| NEGLIGIBLE.iter().map(move |&share| (part, share)));
    let mut last = String::from("no multipliers were found");
    for (part, share) in tried {
        let claim = Claim::Infeasible(about(part, share));
        let certificate = Certificate {
            schema: SCHEMA,
            spec_sha256: sha256.clone(),
            model: kind,
            capture_height_m: super::height(problem.model()),
            claim,
        };
        // A certificate that does not show its claim is not written.
        match verify::decide(&certificate, model, Settings::default()) {
            Ok(_) => return Ok(certificate),
            Err(refusal) => last = refusal.sentence(),
        }
    }
    Err(format!("the multipliers found do not prove it ({last})"))
}

/// The hover model's program, with the overshoot of waypoint tolerances as its objective.
fn about_hover(planner: &mut HoverPlanner, run: &PlannerRun, total: f64) -> Result<Overshoot, String> {
    let model = planner.model();
    let layout = match planner.layout(total, model.plan.samples) {
        Ok(Some(layout)) => layout,
        Ok(None) => return Err(NO_TIME.into()),
        Err(_) => return Err("yaw alone has no plan".into()),
    };
    let YawPlan::Free { .. } = layout.yaw else {
        return Err(YAW_FIRST.into());
    };
    let maps = layout.yaw.maps(model, layout.flown.nodes());
    let commands = layout.commands(model);
    let form = Transcription::new(planner.problem, &layout.flown, &run.set, &maps, layout.yaw.axes())
        .with_commands(commands.as_ref());
    if form.each_row().take(MAX_MULTIPLIERS + 1).count() > MAX_MULTIPLIERS {
        return Err(TOO_MANY.into());
    }
    Ok(Overshoot {
        program: form.full_program(Purpose::Overshoot { epsilon: COST }),
        taus: form.taus(),
        waypoint_nodes: layout.flown.waypoint_nodes.clone(),
        thrust: Vec::new(),
    })
}

/// The exact model's relaxation, with the same objective.
fn relaxed(planner: &mut HoverPlanner, run: &PlannerRun, total: f64) -> Result<Overshoot, String> {
    let flown = time_grid(planner.mission(), total, planner.model().plan.samples).ok_or(NO_TIME)?.flown();
    let Relaxed { program, taus, thrust } =
        ScpPlanner::new(planner, WrenchModel::Exact, &run.set).overshoot(&flown, COST);
    Ok(Overshoot { program, taus, waypoint_nodes: flown.waypoint_nodes.clone(), thrust: thrust.weights })
}

fn named<'r>(model: &Model, rows: impl Iterator<Item = &'r SetRow>) -> Result<Vec<FacetRecord>, String> {
    let rows: Vec<&SetRow> = rows.collect();
    if rows.iter().any(|row| row.core.is_some()) {
        return Err("the proof uses rows of a core, for which there is no certificate".into());
    }
    let records = rows.into_iter().map(|row| facet_of(model, row)).collect::<Option<Vec<_>>>();
    records.ok_or_else(|| "a flat set has facets that are not spanned by three rotors".into())
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

/// The part of the motion whose multipliers are used.
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
            RowRecord::Limit { limit, .. } => mission.limits[limit].kind.is_of_yaw(),
            _ => false,
        };
        self == Part::Both || of_yaw == (self == Part::Yaw)
    }
}

/// The multipliers of all rows except those of the dynamics. Rows with the same origin are adjacent in the program: the
/// sides of a limit, the parts of a cone.
fn multipliers(overshoot: &Overshoot, z: &[f64], mission: &Mission) -> Option<Vec<Multiplier>> {
    let Overshoot { program, taus, waypoint_nodes, .. } = overshoot;
    let mut found: Vec<Multiplier> = Vec::new();
    let mut at = 0;
    let mut seen: std::collections::BTreeMap<(usize, usize), usize> = Default::default();
    for cone in &program.cones {
        // Rows of the zero and the nonnegative cone are separate; those of a second-order cone belong together.
        let size = if let Cone::SecondOrder(n) = cone { *n } else { 1 };
        for first in (at..at + cone.rows()).step_by(size) {
            let mut values = z[first..first + size].to_vec();
            let row = match program.row_origin[first] {
                RowOrigin::Dynamics { .. } | RowOrigin::Overshoot | RowOrigin::Violation => continue,
                // Rows of the exact model's linearised subproblems, which are not a relaxation of it, and of stops.
                RowOrigin::Upright { .. }
                | RowOrigin::Duration { .. }
                | RowOrigin::Stop { .. }
                | RowOrigin::Wrench { .. } => return None,
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
                    // The transcription writes `tolerance + (psi - due)` first, which bounds psi from below.
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
                    // A jerk limit has a cone for each interval adjacent to its node, from the left; one of a leg none
                    // before it.
                    let begins_here =
                        mission.limits[limit].leg.as_ref().is_some_and(|on| waypoint_nodes[on.leg] == node);
                    let first = if begins_here { node } else { node.saturating_sub(1) };
                    let interval = first + *count - 1;
                    match sides.into_iter().flatten().nth(*count - 1) {
                        Some(side) if size == 1 => RowRecord::Limit { limit, node, side },
                        _ if size > 1 => RowRecord::LimitNorm { limit, node, interval },
                        _ => return None,
                    }
                }
            };
            // Multipliers of inequalities are not negative; the interior-point solution violates this slightly.
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
