//! The core of a mode in which yaw is given up: the thrusts and roll and pitch torques that rotors give in every
//! heading while the body's rate stays in a range that it cannot leave. docs/method/without-yaw.md, "Plans".

mod elimination;
mod envelope;
mod family;

use super::interval::{Interval, exceeds};
use super::premise::{Premise, Premises};
use super::proof::Family;
use super::sets::{Generators, Plane, ROUNDING, Sets, shrunk};
use super::wrench::Dynamics;
use super::{Rejection, cost, lag};
use crate::certificate::SpinRecord;
use crate::model::{FaultMode, GiveUpYaw, Model, Rotor, RotorSpread, Spin, Spread, YawDrag};
use crate::tolerance::{EDGE, MOST_OUTSIDE};
use elimination::Elimination;
use envelope::Envelope;
pub use family::{Member, family};
use std::collections::HashSet;

/// A row `thrust T + torque rho <= offset` for both ends of the spin; over a width of the healthy set.
#[derive(Debug, Clone, Copy)]
struct Row {
    thrust: Interval,
    torque: Interval,
    offset: Interval,
}

/// The rows of a mode.
#[derive(Debug, Clone)]
pub struct Core {
    pub mode: String,
    rows: Vec<Row>,
    /// Momenta about the thrust (N m s), each with its rate (rad/s).
    corners: Vec<(Interval, Interval)>,
    /// The least and the largest rate, rad/s.
    spin: [f64; 2],
    /// The largest rate at which the direction of the thrust turns, rad/s, where the inertia is uneven.
    turning: Option<f64>,
    /// Mean moment of inertia about x and y, and half their difference, kg m^2.
    inertia: Interval,
    unevenness: Interval,
}

/// How the plan's modes are judged.
#[derive(Debug, Clone, Default)]
pub struct WithoutYaw {
    pub cores: Vec<Core>,
    /// Modes that add no rows: nothing is left to torques in some direction.
    pub caught: Vec<String>,
    /// The modes of both.
    freed: HashSet<String>,
}

impl WithoutYaw {
    /// The cores of a claim's modes, and the modes without one, for the spec's `against`.
    ///
    /// # Errors
    /// A record names a mode whose yaw the spec does not give up, a mode named before, or a range of rates that is not
    /// one.
    pub fn of(sets: &Sets, records: &[SpinRecord], premises: Premises) -> Result<Self, Rejection> {
        let model = sets.model();
        let mut found = WithoutYaw::default();
        for record in records {
            // A second record would add nothing but work.
            if !found.freed.insert(record.mode.clone()) {
                let named = format!("the mode {} without yaw", record.mode);
                return Err(Rejection::new(named, "the certificate names it more than once"));
            }
            found.cores.push(Core::of(sets, record, premises)?);
        }
        for mode in model.plan.against.iter().filter_map(|&i| model.modes.get(i)) {
            if !found.freed.contains(&mode.name) && may_be_freed(sets, mode) && is_on_edge(model, mode) {
                found.caught.push(mode.name.clone());
            }
        }
        found.freed.extend(found.caught.iter().cloned());
        Ok(found)
    }

    /// Every mode of `against` in which plans may give up yaw, without rows.
    pub fn wherever_possible(sets: &Sets) -> Self {
        let model = sets.model();
        let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i));
        let caught: Vec<String> =
            against.filter(|mode| may_be_freed(sets, mode)).map(|mode| mode.name.clone()).collect();
        WithoutYaw { cores: Vec::new(), freed: caught.iter().cloned().collect(), caught }
    }

    /// Whether the set of a mode is not imposed whole.
    pub fn frees(&self, mode: &str) -> bool {
        self.freed.contains(mode)
    }
}

/// Units of work and bytes for the cores of some records and for the modes of the spec's `against` that may be without
/// one. The planes of sets are not included: [`modes_looked_at`].
pub fn cost_of(model: &Model, records: &[SpinRecord]) -> cost::Estimate {
    let mut all = cost::Estimate::default();
    if obstacle(model).is_some() {
        return all;
    }
    let rows = elimination::rows_at_most(&model.vehicle);
    let held = rows.min(2 * envelope::BATCH as u64);
    let cores = (records.len() as u64).min(model.modes.len() as u64);
    let of_core = cost::times(rows, cost::COST_PER_CORE_ROW);
    all.add(cost::times(cores, of_core), cost::times(held, cost::BYTES_OF_A_CORE_ROW));
    let shadow = elimination::shadow_rows_at_most(&model.vehicle);
    let others = model.plan.against.iter().filter_map(|&i| model.modes.get(i)).filter(|mode| may_give_up(model, mode));
    all.add(cost::times(others.count() as u64, shadow), 0);
    all
}

/// The modes of the spec's `against` whose planes decide whether their yaw is given up.
pub fn modes_looked_at(model: &Model) -> impl Iterator<Item = &FaultMode> {
    let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i));
    against.filter(|mode| obstacle(model).is_none() && wanted(model, mode) == GiveUpYaw::WhereNeeded)
}

/// Why the spec's plans cannot give up yaw.
fn obstacle(model: &Model) -> Option<&'static str> {
    let environment = model.environment();
    let all = [
        (model.vehicle.yaw_drag.is_none(), "the spec gives no `yaw_drag`"),
        (lag::constant(model).is_some(), "the rotors lag"),
        (environment.is_uncertain(), "more than one wind is possible"),
        (!environment.is_isotropic(), "the drag is not the same for all axes of the body"),
    ];
    all.into_iter().find(|(is_there, _)| *is_there).map(|(_, why)| why)
}

fn wanted(model: &Model, mode: &FaultMode) -> GiveUpYaw {
    mode.without_yaw.unwrap_or(model.plan.without_yaw)
}

/// Whether plans might give up yaw after a fault of the mode, whatever its set.
fn may_give_up(model: &Model, mode: &FaultMode) -> bool {
    obstacle(model).is_none() && wanted(model, mode) != GiveUpYaw::Never
}

/// Whether the spec lets plans give up yaw after a fault of the mode.
fn gives_up_yaw(sets: &Sets, mode: &FaultMode) -> bool {
    match wanted(sets.model(), mode) {
        GiveUpYaw::Never => false,
        GiveUpYaw::Always => true,
        GiveUpYaw::WhereNeeded => !sets.has_hover(&mode.name, || controls_all(sets, mode)),
    }
}

/// Whether plans may be made without yaw for a mode, so that its whole set proves nothing about them.
pub fn may_be_freed(sets: &Sets, mode: &FaultMode) -> bool {
    may_give_up(sets.model(), mode) && gives_up_yaw(sets, mode)
}

fn generators(model: &Model, mode: &FaultMode) -> Generators {
    Generators::new(&model.vehicle, &model.environment(), Some(mode), 0.0)
}

/// The width of the edge: distances up to it, in N and N m, count as none.
fn width_of_edge(hover: f64) -> f64 {
    EDGE * hover.abs().min(1.0)
}

/// Whether hover lies inside the whole set of a mode by more than the width of the edge.
fn controls_all(sets: &Sets, mode: &FaultMode) -> bool {
    let hover = generators(sets.model(), mode).hover_thrust().middle();
    let Ok(Ok(planes)) = sets.planes(&mode.name) else { return false };
    // The reserve leaves this share of the distance from hover to each plane.
    let kept = 1.0 - sets.model().plan.reserve;
    let slack = |plane: &Plane| {
        let normal = plane.normal.map(Interval::middle);
        let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
        (plane.offset.middle() - normal[0] * hover) / (length * kept)
    };
    planes.iter().map(slack).fold(f64::INFINITY, f64::min) > width_of_edge(hover)
}

/// Whether hover lies on the boundary of the projection of a mode's set, in the middle of all intervals. Inside there
/// is a core, and a mode outside cannot even hover while it spins, so that nothing catches it.
fn is_on_edge(model: &Model, mode: &FaultMode) -> bool {
    let mut vehicle = model.vehicle.clone();
    vehicle.mass_spread = Spread::NONE;
    vehicle.rotors.iter_mut().for_each(|rotor| rotor.spread = RotorSpread::default());
    let generators = Generators::new(&vehicle, &model.environment(), Some(mode), 0.0);
    let hover = generators.hover_thrust().middle();
    let mut least = f64::INFINITY;
    let is_known = elimination::shadow_rows(&generators, |row: Row| {
        let [a, b, e] = [row.thrust, row.torque, row.offset].map(Interval::middle);
        least = least.min((e - a * hover) / a.hypot(b));
    });
    // Without planes it is not known, and the mode's whole set would not be decided either.
    !is_known || least.abs() <= width_of_edge(hover)
}

impl Core {
    fn of(sets: &Sets, record: &SpinRecord, premises: Premises) -> Result<Self, Rejection> {
        let model = sets.model();
        let named = || format!("the mode {} without yaw", record.mode);
        let wrong = |why: &str| Err(Rejection::new(named(), why));
        let Some(mode) = sets.mode(&record.mode) else { return wrong("the spec has no such mode") };
        if let Some(why) = obstacle(model) {
            return wrong(why);
        }
        if !gives_up_yaw(sets, mode) {
            return wrong("the spec does not give up its yaw");
        }
        let Some(drag) = model.vehicle.yaw_drag else { return wrong("the spec gives no `yaw_drag`") };
        let spin @ [low, high] = record.spin_rad_s;
        if !(low <= 0.0 && high >= 0.0 && low.is_finite() && high.is_finite()) {
            return wrong("the range of its spin does not contain zero");
        }
        let [jx, jy, _] = model.vehicle.inertia.map(Interval::point);
        let turning = match record.turning_rad_s {
            _ if model.vehicle.inertia[0] == model.vehicle.inertia[1] || !premises.has(Premise::Spin) => None,
            None => return wrong("the moments of inertia about x and y differ, so that it needs `turning_rad_s`"),
            Some(rate) if !(rate.is_finite() && rate > 0.0) => return wrong("`turning_rad_s` is not above zero"),
            rate => rate,
        };
        let coupled = turning.map_or(Interval::ZERO, |rate| coupling(jx, jy, rate));
        let torques = [balanced(&drag, low) + coupled, balanced(&drag, high) - coupled];
        if exceeds(torques[0].high, torques[1].low) {
            return wrong("no yaw torque keeps its spin in the range while the direction of the thrust turns");
        }
        // The reserve is taken of the rows: hover may lie outside the whole set, yaw included.
        let whole = generators(model, mode);
        let hover = whole.hover_thrust();
        let planes = sets.planes(&mode.name)?.map_err(|why| Rejection::new(named(), why))?;
        let planes: Vec<Plane> = planes.iter().map(|plane| plane.without_reserve(hover)).collect();
        let kept = Interval::ONE - Interval::point(model.plan.reserve);
        let full = |rotor: &Rotor| rotor.max_thrust() * rotor.spread.full_thrust.high;
        let most = model.vehicle.rotors.iter().map(full).sum();
        let (mut envelope, mut excludes_hover, mut is_bounded) = (Envelope::new(most), false, true);
        Elimination { planes: &planes, generators: &whole, torques }.rows(|mut row| {
            let width = width(model, &row);
            // Along a direction that the healthy rotors do not give, a plane has no width.
            is_bounded &= [row.thrust, row.torque, row.offset].iter().all(|part| part.magnitude().is_finite());
            if model.plan.reserve > 0.0 {
                let at_hover = row.thrust * hover;
                let room = row.offset - at_hover;
                excludes_hover |= exceeds(-room.low, ROUNDING * width);
                row.offset = at_hover + shrunk(room, kept);
            }
            // Two opposite planes add up to a row that bounds nothing: its normal is zero up to rounding.
            if width > NEGLIGIBLE * row.offset.low {
                envelope.add(row.over(width));
            }
        });
        if !is_bounded {
            return wrong("the rotors do not give all torques, so that its set has no width to measure by");
        }
        if excludes_hover && premises.has(Premise::Reserve) {
            return wrong(
                "the reserve is a share of the way from hover to its core's boundary, but hover lies outside",
            );
        }
        let half = Interval::point(0.5);
        Ok(Core {
            mode: mode.name.clone(),
            rows: envelope.rows(),
            corners: corners(model, spin),
            spin,
            turning,
            inertia: (jx + jy) * half,
            unevenness: ((jx - jy) * half).abs(),
        })
    }

    /// The rates of the body, rad/s.
    pub fn spin(&self) -> [f64; 2] {
        self.spin
    }

    /// Every row at every corner of momenta and rates; then the bound on how fast the direction of the thrust turns, if
    /// there is one.
    fn members(&self) -> Vec<Member> {
        let of_row = |row: &Row| {
            let Row { thrust, torque, offset } = *row;
            let at = move |&(momentum, spin): &(Interval, Interval)| Member {
                thrust,
                torque,
                offset,
                inertia: self.inertia,
                unevenness: self.unevenness,
                momentum,
                spin,
            };
            self.corners.iter().map(at).collect::<Vec<_>>()
        };
        let rows = self.rows.iter().flat_map(of_row);
        rows.chain(self.turning.map(|rate| Member::turning(Interval::point(rate)))).collect()
    }

    /// The largest rate at which the direction of the thrust turns, rad/s, where the inertia is uneven.
    pub fn turning(&self) -> Option<f64> {
        self.turning
    }

    /// How many members of the family, the last ones, are premises of the others: they hold wherever some member is
    /// imposed. The last two are the ends of the spin, after the rate of turning where that is bounded.
    pub fn premises(&self) -> usize {
        2 + usize::from(self.turning.is_some())
    }

    /// The violation of every row at every corner, then those of [`Core::premises`]: of the rate at which the direction
    /// of the thrust turns, and by how much the plan itself turns faster than at the ends of the spin.
    pub fn family<'a>(&self, dynamics: &Dynamics<'a>) -> Family<'a> {
        family(dynamics, self.members(), Some(self.spin))
    }
}

/// The largest torque, in size, up to which every drag of the interval keeps a body from turning faster than `rate`,
/// rad/s; N m.
fn balanced(drag: &YawDrag, rate: f64) -> Interval {
    let [linear, share, quadratic, rate] = [drag.linear, drag.spread.low, drag.quadratic, rate].map(Interval::point);
    linear * share * rate + quadratic * rate * rate.abs()
}

/// The largest yaw torque with which a turning thrust accelerates the spin of a body with uneven inertia: by Euler's
/// equation `Jz r' = tau_z + (Jx - Jy) p q`, and `|p q| <= |s'|^2/2`, as p and q are the components of s' in the body;
/// N m.
fn coupling(jx: Interval, jy: Interval, rate: f64) -> Interval {
    let rate = Interval::point(rate) * (Interval::ONE + Interval::point(MOST_OUTSIDE));
    (jx - jy).abs() * rate.square() * Interval::point(0.5)
}

/// The highest speed of a rotor over its intervals, rad/s: those of b w_max^2 and of b may be as far apart as that of
/// the speed makes them.
fn fastest(rotor: &Rotor) -> Interval {
    let [thrust, coefficient] = [rotor.spread.full_thrust.high, rotor.spread.idle_thrust.low].map(Interval::point);
    let speed = Interval::point(rotor.max_speed);
    if thrust == coefficient { speed } else { speed * (thrust / coefficient).sqrt() }
}

/// The corners of the box of momenta and rates, in which rho is convex.
fn corners(model: &Model, spin: [f64; 2]) -> Vec<(Interval, Interval)> {
    let inertia = Interval::point(model.vehicle.inertia[2]);
    let (mut low, mut high) = (Interval::ZERO, Interval::ZERO);
    for rotor in &model.vehicle.rotors {
        // Of an interval the largest: the box contains that of every smaller one.
        let largest = Interval::point(rotor.inertia) * Interval::point(rotor.inertia_spread.high);
        let most = largest * fastest(rotor);
        match rotor.spin {
            Spin::P => high = high + most,
            Spin::N => low = low - most,
        }
        if rotor.is_reversible() {
            let least = largest * Interval::point(rotor.min_speed);
            match rotor.spin {
                Spin::P => low = low + least,
                Spin::N => high = high - least,
            }
        }
    }
    let of_rotors = if low == high { vec![low] } else { vec![low, high] };
    let of_rate = |rate: f64| {
        let rate = Interval::point(rate);
        of_rotors.iter().map(move |h| (inertia * rate + *h, rate)).collect::<Vec<_>>()
    };
    spin.into_iter().flat_map(of_rate).collect()
}

impl Row {
    fn new(head: [Interval; 3], offset: Interval) -> Self {
        let [thrust, x, y] = head;
        Row { thrust, torque: (x.square() + y.square()).sqrt(), offset }
    }

    fn over(&self, width: f64) -> Self {
        let width = Interval::point(width);
        Row { thrust: self.thrust / width, torque: self.torque / width, offset: self.offset / width }
    }

    /// The smallest row that implies both.
    fn hull(&self, other: &Row) -> Self {
        let hull = |a: Interval, b: Interval| Interval::new(a.low.min(b.low), a.high.max(b.high));
        Row {
            thrust: hull(self.thrust, other.thrust),
            torque: hull(self.torque, other.torque),
            offset: hull(self.offset, other.offset),
        }
    }

    /// `(slope, height)` of the row written as `rho <= slope T + height`; `None` for a bound on the thrust.
    fn line(&self) -> Option<(f64, f64)> {
        let [a, b, e] = [self.thrust, self.torque, self.offset].map(Interval::middle);
        (b > 1e-9 * a.abs()).then(|| (-a / b, e / b))
    }
}

/// A width of the healthy set along a row, by which violations are measured.
fn width(model: &Model, row: &Row) -> f64 {
    let (a, b) = (row.thrust.middle(), row.torque.middle());
    let along = |x: f64, y: f64| -> f64 {
        let of_rotor = |rotor: &Rotor| {
            let full = rotor.thrust_coefficient * (rotor.max_speed.powi(2) - rotor.min_speed * rotor.min_speed.abs());
            (full * (a + x * rotor.position[1] - y * rotor.position[0])).abs()
        };
        model.vehicle.rotors.iter().map(of_rotor).sum()
    };
    along(b, 0.0).max(along(0.0, b))
}

/// A row whose normal takes a smaller share of its offset over the whole healthy set bounds nothing.
const NEGLIGIBLE: f64 = 1e-9;
