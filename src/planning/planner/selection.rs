//! The set a planner imposes: RIP the healthy one, RCP an intersection, RSP the healthy one and the facets
//! that the RIP plan violates.

pub mod sets;

use crate::admissible::row::{SetRow, row};
use crate::admissible::{AdmissibleSet, intersection};
use crate::model::Vehicle;
use crate::tolerance;
use crate::verify::most_thrust::multipliers;
use std::fmt;

/// Bounds on the thrust are raised by this share: the checker's planes differ from rows by rounding.
const ROUNDING: f64 = 1e-8;

/// The rows that a planner imposes on the wrench at every node, in widths of the healthy set.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlanningSet {
    pub rows: Vec<SetRow>,
}

impl PlanningSet {
    /// Whether some rows are those of a core, which depend on how the motion turns.
    pub fn has_cores(&self) -> bool {
        self.rows.iter().any(|row| row.core.is_some())
    }

    /// Whether some cores are those of a vehicle whose moments of inertia about x and y differ.
    pub fn has_uneven_cores(&self) -> bool {
        self.rows.iter().any(|row| row.core.is_some_and(|core| core.unevenness != 0.0))
    }

    /// The minimal description of the intersection of `sets`, measured against the healthy set's widths.
    pub fn of(sets: &[&AdmissibleSet], healthy: &AdmissibleSet) -> Self {
        let joint = intersection(sets);
        let equalities = joint.equalities.iter().map(|e| {
            let width = healthy.zonotope.width(&e.normal);
            SetRow {
                normal: e.normal / width,
                offset: e.offset / width,
                equality: true,
                origin: Vec::new(),
                core: None,
            }
        });
        let facets = joint.facets.iter().map(|f| row(f, healthy, f.origin.clone()));
        PlanningSet { rows: equalities.chain(facets).collect() }
    }

    /// An upper bound on the thrust of wrenches in the set, N, which the tolerance of the check of plans widens. Rows
    /// of cores depend on the motion, so that they bound nothing here.
    pub fn most_thrust(&self, vehicle: &Vehicle) -> f64 {
        let sides = |row: &SetRow| {
            let plane = |sign: f64| ((sign * row.normal).into(), sign * row.offset + tolerance::MOST_OUTSIDE);
            [Some(plane(1.0)), row.equality.then(|| plane(-1.0))].into_iter().flatten()
        };
        let rows = self.rows.iter().filter(|row| row.core.is_none());
        let planes: Vec<([f64; 4], f64)> = rows.flat_map(sides).collect();
        let sizes = vehicle.rotors.iter().fold([0.0; 4], |sizes: [f64; 4], rotor| {
            let thrust = 2.0 * rotor.max_thrust() * rotor.spread.full_thrust.high;
            let arms = [1.0, rotor.position[1], rotor.position[0], rotor.drag_coefficient / rotor.thrust_coefficient];
            std::array::from_fn(|k| sizes[k] + thrust * arms[k].abs())
        });
        let mut left = [1.0, 0.0, 0.0, 0.0];
        let mut most = 0.0;
        for (i, weight) in multipliers(&planes, sizes.map(|size| if size > 0.0 { size } else { 1.0 })) {
            most += weight * planes[i].1;
            left = std::array::from_fn(|k| left[k] - weight * planes[i].0[k]);
        }
        (1.0 + ROUNDING) * (0..4).fold(most, |most, k| most + left[k].abs() * sizes[k])
    }

    /// This set with the given facets of other sets added; planes it already has are not added twice.
    pub fn with(&self, extra: Vec<SetRow>) -> Self {
        let mut rows = self.rows.clone();
        for new in extra {
            let same = |old: &SetRow| {
                let (a, b) = (old.normal.normalize(), new.normal.normalize());
                old.equality == new.equality
                    && old.core == new.core
                    && (a - b).amax() < 1e-9
                    && (old.offset - new.offset).abs() < 1e-9 * old.offset.abs().max(1.0)
            };
            match rows.iter_mut().find(|r| same(r)) {
                Some(old) => old.origin.extend(new.origin),
                None => rows.push(new),
            }
        }
        PlanningSet { rows }
    }
}

/// One row per line, in widths of the healthy set: coefficients of [T, tau_x, tau_y, tau_z], the bound, and the facets
/// that it comes from as `mode.facet` (mode 0 is healthy, the others in the order declared).
impl fmt::Display for PlanningSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let n = self.rows.len();
        writeln!(
            f,
            "{n} rows at every node: T, tau_x, tau_y, tau_z; the bound, in widths of the healthy set; mode.facet"
        )?;
        for row in &self.rows {
            for v in row.normal.iter() {
                let v = if v.abs() < 5e-10 { 0.0 } else { *v };
                write!(f, "  {v:>13.9}")?;
            }
            let relation = if row.equality { "= " } else { "<=" };
            let offset = if row.offset.abs() < 5e-10 { 0.0 } else { row.offset };
            let origin: Vec<String> = row.origin.iter().map(|o| format!("{}.{}", o.mode, o.facet)).collect();
            write!(f, "  {relation} {offset:>12.9}   {}", origin.join(" "))?;
            match &row.core {
                // a T + b rho <= e, (98).
                Some(core) => writeln!(
                    f,
                    "   with {:.9} rho, H {:.6} N m s, r {:.4} rad/s",
                    core.torque, core.momentum, core.spin
                )?,
                None => writeln!(f)?,
            }
        }
        Ok(())
    }
}
