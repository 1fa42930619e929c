//! The rows that a plan keeps against a mode in which yaw is given up. See `docs/method/without-yaw.md`, "Plans".

use super::YawFree;
use super::core::disc;
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::admissible::{AdmissibleSet, FacetOf, edge, hover, verdict};
use crate::geometry::polytope::{Facet, Polytope, intersect};
use crate::geometry::zonotope::Spanning;
use crate::model::{Allocation, GiveUpYaw, LimitKind, Model, Spin, YawDrag};
use crate::tolerance::MOST_OUTSIDE;
use nalgebra::{SVector, Vector2};

/// What a row of a core depends on, whatever the heading of the body: T (N), the two components of `s x s''` (1/s^2),
/// those of s' (1/s), both in one frame that stands across s, and the rate of the body about s (rad/s). s is the
/// direction of the thrust.
pub type Turning = SVector<f64, 6>;

/// What a row of a core adds to the bound `a T <= e` on the thrust; both are divided by the healthy set's width along
/// the row:
///
/// ```text
/// (98)  a T + b rho <= e,   rho = |J s x s'' + H s'| + |delta| |s x s'' + 2 r s'|
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoreRow {
    /// b, 1/(N m); at least 0.
    pub torque: f64,
    /// J, the mean of the moments of inertia about x and y, kg m^2.
    pub inertia: f64,
    /// delta, half their difference.
    pub unevenness: f64,
    /// H, the momentum of body and rotors about s, N m s.
    pub momentum: f64,
    /// r, rad/s.
    pub spin: f64,
}

impl CoreRow {
    /// Whether this is the bound on how fast the direction of the thrust turns, a premise of the other rows.
    pub fn bounds_turning(&self) -> bool {
        self.inertia == 0.0
    }

    /// `J s x s'' + H s'` and `s x s'' + 2 r s'`.
    pub fn torques(&self, turning: &Turning) -> [Vector2<f64>; 2] {
        let (swing, rate) = (turning.fixed_rows::<2>(1).into_owned(), turning.fixed_rows::<2>(3).into_owned());
        [swing * self.inertia + rate * self.momentum, swing + rate * (2.0 * self.spin)]
    }

    /// b rho, in widths of the healthy set.
    pub fn share(&self, turning: &Turning) -> f64 {
        let [even, uneven] = self.torques(turning);
        self.torque * (even.norm() + self.unevenness.abs() * uneven.norm())
    }
}

/// The core of a mode as planned against.
#[derive(Debug, Clone, PartialEq)]
pub struct PlannedCore {
    /// Index into `Model::modes`.
    pub mode: usize,
    /// The rates of the body about the thrust (rad/s) that it never leaves after the fault, given yaw torques in
    /// `yaw_torque_n_m`; they contain the rates at which the plan turns, with a factor of two.
    pub spin_rad_s: [f64; 2],
    /// The yaw torques (N m) that are used: the smallest interval about zero with which the disc at hover is whole.
    pub yaw_torque_n_m: [f64; 2],
    /// The largest rate at which the direction of the thrust may turn, rad/s, where the moments of inertia about x and
    /// y differ.
    pub turning_rad_s: Option<f64>,
    /// In widths of the healthy set.
    pub rows: Vec<SetRow>,
}

/// How a plan provides for a mode.
#[derive(Debug, Clone, PartialEq)]
pub enum Provision {
    /// The wrench stays in the mode's set, yaw included.
    WithYaw,
    /// Yaw is given up after the fault, and the motion stays in the core.
    WithoutYaw(PlannedCore),
    /// Yaw is given up, and the mode has no core, but its spin controls the thrust's direction: no rows. The vehicle is
    /// caught and landed, which flights judge.
    Capture,
}

/// Why no rows without yaw can be made for a spec, whatever the mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Obstacle {
    /// `yaw_drag` is not given, so nothing bounds the spin.
    NoYawDrag,
    /// Commands of lagging rotors turn with the body.
    LaggingRotors,
    /// More than one wind is possible.
    Winds,
    /// The drag is not the same for all axes of the body, so that the motion depends on the heading.
    DragOfAxes,
}

impl Obstacle {
    /// The first obstacle in a spec.
    pub fn of(model: &Model) -> Option<Self> {
        let environment = model.environment();
        let found = [
            (model.vehicle.yaw_drag.is_none(), Obstacle::NoYawDrag),
            (model.thrust_lag().is_some(), Obstacle::LaggingRotors),
            (environment.is_uncertain(), Obstacle::Winds),
            (!environment.is_isotropic(), Obstacle::DragOfAxes),
        ];
        found.into_iter().find(|(is_there, _)| *is_there).map(|(_, obstacle)| obstacle)
    }
}

impl Provision {
    /// How a plan provides for the mode of a set. With yaw where the spec has an [`Obstacle`], or where the mode can
    /// neither be planned nor caught without yaw.
    pub fn of(model: &Model, set: &AdmissibleSet, healthy: &AdmissibleSet) -> Self {
        if !gives_up_yaw(model, set) || Obstacle::of(model).is_some() {
            return Provision::WithYaw;
        }
        match PlannedCore::of(model, set, healthy) {
            Some(core) => Provision::WithoutYaw(core),
            None if verdict::analyze(model, set).yaw_free == YawFree::Spinning => Provision::Capture,
            None => Provision::WithYaw,
        }
    }

    /// The rows of the core, if there is one.
    pub fn core_rows(&self) -> &[SetRow] {
        match self {
            Provision::WithoutYaw(core) => &core.rows,
            Provision::WithYaw | Provision::Capture => &[],
        }
    }
}

/// Half the range of the rates (rad/s) at which a plan may turn where it limits no yaw rate.
pub const YAW_RATE: f64 = 1.0;

/// With an uneven inertia, turning takes this share of the largest drag of the spin, as long as the bound on the rate
/// of turning stays in [`TURNING`]. Chosen by hand.
const TURNING_SHARE: f64 = 0.25;

/// The least and the largest bound on the rate at which the thrust's direction turns, rad/s. A larger bound widens the
/// range of spins: the shortest plan of `specs/missions/ridge_hexa.mav` takes 31.76 s with 2 rad/s and 32.10 s with 5
/// rad/s. Below 1 rad/s, chosen by hand, the bound would hold up plans that the core itself allows.
const TURNING: [f64; 2] = [1.0, 2.0];

/// Halvings of the interval of yaw torques.
const HALVINGS: usize = 30;

/// A disc counts as whole if it is smaller by at most this share.
const WHOLE: f64 = 1e-6;

/// The smallest share of the yaw torques of hover that is tried.
const LEAST_SHARE: f64 = 0.01;

/// Whether yaw is given up after a fault of the mode whose set this is, by the spec and its set.
pub fn gives_up_yaw(model: &Model, set: &AdmissibleSet) -> bool {
    let Some(mode) = set.mode.checked_sub(1) else { return false };
    match model.gives_up_yaw(mode) {
        GiveUpYaw::Never => false,
        GiveUpYaw::WhereNeeded => !set.has_hover_inside(),
        GiveUpYaw::Always => true,
    }
}

/// The largest rate of yaw of the mission's limits, or else [`YAW_RATE`]; rad/s.
pub fn yaw_rate(model: &Model) -> f64 {
    let limits = model.mission.iter().flat_map(|mission| &mission.limits);
    let of_rate = limits.filter(|limit| limit.kind == LimitKind::YawRate && limit.is_general());
    let largest = of_rate.filter_map(|limit| Some(limit.upper?.abs().max(limit.lower?.abs())));
    largest.reduce(f64::min).unwrap_or(YAW_RATE)
}

impl PlannedCore {
    /// The core of a mode, for every value of the spec's intervals and shrunk by the plan's reserve; `None` if hover is
    /// not inside it, or if `yaw_drag` is unknown. `set` is the mode's whole set.
    pub fn of(model: &Model, set: &AdmissibleSet, healthy: &AdmissibleSet) -> Option<Self> {
        let mode = set.mode.checked_sub(1)?;
        let [slow_drag, _] = model.vehicle.yaw_drag?.ends();
        let guaranteed = set.guaranteed(model);
        let slice = Slice::of(model, set, &guaranteed.polytope)?;
        let torques = slice.least_torques()?;
        let turning = TurningBound::of(model, &slow_drag, torques);
        let spin = spin_range(model, &slow_drag, torques, turning.map_or(0.0, |bound| bound.coupling));
        let kept = 1.0 - model.plan.reserve;
        let [jx, jy, _] = model.vehicle.inertia;
        let mut rows = Vec::new();
        for (index, facet) in slice.polygon(torques)?.facets.into_iter().enumerate() {
            let [thrust, torque] = [facet.normal.x, facet.normal.y.max(0.0)];
            let at_hover = thrust * slice.hover[0];
            let offset = at_hover + kept * (facet.offset - at_hover);
            let width = width(healthy, thrust, torque);
            // The momentum does not matter for a bound on the thrust.
            let corners = if torque == 0.0 { vec![(0.0, 0.0)] } else { momenta(model, spin) };
            rows.extend(corners.into_iter().map(|(momentum, spin)| SetRow {
                normal: Wrench::new(thrust / width, 0.0, 0.0, 0.0),
                offset: offset / width,
                equality: false,
                origin: vec![FacetOf { mode: set.mode, facet: index, spanning: Spanning(0) }],
                core: Some(CoreRow {
                    torque: torque / width,
                    inertia: 0.5 * (jx + jy),
                    unevenness: 0.5 * (jx - jy),
                    momentum,
                    spin,
                }),
            }));
        }
        let facet = rows.last().map_or(0, |row| row.origin[0].facet + 1);
        rows.extend(turning.map(|bound| bound.row(FacetOf { mode: set.mode, facet, spanning: Spanning(0) })));
        let turning_rad_s = turning.map(|bound| bound.rate);
        Some(PlannedCore { mode, spin_rad_s: spin, yaw_torque_n_m: torques, turning_rad_s, rows })
    }
}

/// A bound on how fast the direction of the thrust turns. By Euler's equation `Jz r' = tau_z + (Jx - Jy) p q` turning
/// accelerates the spin of a body with uneven inertia, by at most `|Jx - Jy| |s'|^2/2`, because p and q are the
/// components of s'.
#[derive(Debug, Clone, Copy)]
struct TurningBound {
    /// rad/s
    rate: f64,
    /// The yaw torque that is left for it, N m.
    coupling: f64,
}

impl TurningBound {
    /// The bound for the yaw torques that plans use; `None` with equal moments of inertia.
    fn of(model: &Model, drag: &YawDrag, torques: [f64; 2]) -> Option<Self> {
        let [jx, jy, _] = model.vehicle.inertia;
        let uneven = (jx - jy).abs();
        let of_drag =
            spin_range(model, drag, torques, 0.0).map(|rate| drag.torque(rate).abs()).into_iter().fold(0.0, f64::max);
        let [least, most] = TURNING;
        let rate = (2.0 * TURNING_SHARE * of_drag / uneven).sqrt().clamp(least, most);
        (uneven > 0.0).then_some(TurningBound { rate, coupling: coupling(uneven, rate) })
    }

    /// `|s'| <= rate` as a row: (98) with b = 1/rate, J = 0, H = 1 and e = 1.
    fn row(&self, origin: FacetOf) -> SetRow {
        SetRow {
            normal: Wrench::zeros(),
            offset: 1.0,
            equality: false,
            origin: vec![origin],
            core: Some(CoreRow { torque: 1.0 / self.rate, inertia: 0.0, unevenness: 0.0, momentum: 1.0, spin: 0.0 }),
        }
    }
}

/// The yaw torque of turns of an uneven body at this rate (rad/s), N m. The check of plans lets the rate pass by its
/// tolerance, and torques by rounding.
pub(super) fn coupling(uneven: f64, rate: f64) -> f64 {
    0.5 * uneven * (rate * (1.0 + 2.0 * MOST_OUTSIDE)).powi(2)
}

/// The rates that the body does not leave: its drag at either end is at least the yaw torque there and that of
/// `coupling` (N m).
fn spin_range(model: &Model, drag: &YawDrag, [low, high]: [f64; 2], coupling: f64) -> [f64; 2] {
    let planned = 2.0 * yaw_rate(model);
    [drag.spin(low - coupling).min(-planned), drag.spin(high + coupling).max(planned)]
}

/// The corners of the box of momenta (N m s) and rates (rad/s); rho is convex in both.
fn momenta(model: &Model, spin: [f64; 2]) -> Vec<(f64, f64)> {
    let inertia = model.vehicle.inertia[2];
    let (mut low, mut high) = (0.0, 0.0);
    for rotor in &model.vehicle.rotors {
        // The highest speed over the intervals of b w_max^2 and of b.
        let fastest = (rotor.spread.full_thrust.high / rotor.spread.idle_thrust.low).sqrt();
        // Of an interval the largest inertia: the box of momenta grows with it.
        let largest = rotor.inertia * rotor.inertia_spread.high;
        let most = largest * rotor.max_speed * fastest;
        // Below zero for a rotor that may reverse.
        let least = largest * rotor.min_speed.min(0.0);
        match rotor.spin {
            Spin::P => (low, high) = (low + least, high + most),
            Spin::N => (low, high) = (low - most, high - least),
        }
    }
    let of_rotors = if low == high { vec![low] } else { vec![low, high] };
    spin.iter().flat_map(|r| of_rotors.iter().map(move |h| (inertia * r + h, *r))).collect()
}

/// The healthy set's width along the normal (a, b u, 0), in the direction u in which it is largest of x and y.
fn width(healthy: &AdmissibleSet, thrust: f64, torque: f64) -> f64 {
    let along = |x: f64, y: f64| healthy.zonotope.width(&Wrench::new(thrust, x, y, 0.0));
    along(torque, 0.0).max(along(0.0, torque))
}

/// The set about hover.
struct Slice<'a, O> {
    hover: Wrench,
    /// The yaw torques (N m) of the set at hover.
    yaw: [f64; 2],
    polytope: &'a Polytope<4, O>,
    /// Its projection on (T, tau_x, tau_y).
    shadow: Polytope<3, ()>,
    scale: Wrench,
}

impl<'a, O: Clone> Slice<'a, O> {
    /// `polytope` is the part of a mode's set that plans use; `None` if hover is outside.
    fn of(model: &Model, set: &AdmissibleSet, polytope: &'a Polytope<4, O>) -> Option<Self> {
        let (hover, yaw, scale) = (hover(model), Wrench::new(0.0, 0.0, 0.0, 1.0), set.zonotope.scale());
        let (low, high) = polytope.chord(&hover, &yaw, edge::width(&hover))?;
        let shadow = match set.allocation {
            Allocation::Bounded if !model.vehicle.is_uncertain() => {
                verdict::without_yaw(&set.zonotope).facets().without_origins()
            }
            _ => polytope.shadow(Some(&(hover + yaw * (0.5 * (low + high)))), &scale),
        };
        Some(Slice { hover, yaw: [low, high], polytope, shadow, scale })
    }

    /// The projection on (T, tau_x, tau_y) of the wrenches whose yaw torque lies between two bounds, N m.
    fn projection(&self, torques: [f64; 2]) -> Polytope<3, ()> {
        self.polytope.shadow_between(&self.shadow, torques, &self.scale)
    }

    fn disc(&self, torques: [f64; 2]) -> f64 {
        let tolerance = edge::width(&self.hover);
        disc(&self.projection(torques), self.hover[0], [0.0; 2], tolerance).unwrap_or(0.0)
    }

    /// The smallest interval of yaw torques about zero, of those of hover scaled alike, with which the disc at hover is
    /// as large as with all of them; `None` if there is no disc.
    fn least_torques(&self) -> Option<[f64; 2]> {
        let [low, high] = self.yaw;
        let share_of = |share: f64| [(share * low).min(0.0), (share * high).max(0.0)];
        let whole = self.disc(share_of(1.0));
        if whole <= edge::width(&self.hover) {
            return None;
        }
        let is_whole = |share: f64| self.disc(share_of(share)) >= (1.0 - WHOLE) * whole;
        let (mut too_small, mut enough) = (0.0, 1.0);
        if is_whole(LEAST_SHARE) {
            return Some(share_of(LEAST_SHARE));
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (too_small + enough);
            if is_whole(middle) { enough = middle } else { too_small = middle }
        }
        Some(share_of(enough))
    }

    /// The core: all (T, rho) such that the disc of radius rho at T lies in the projection, without the bound rho >= 0.
    fn polygon(&self, torques: [f64; 2]) -> Option<Polytope<2, ()>> {
        let disc = self.disc(torques);
        let whole = self.projection(torques);
        let edge = |f: &Facet<3, ()>| {
            let (normal, across) = (f.normal, f.normal.fixed_rows::<2>(1).norm());
            let size = normal.x.hypot(across);
            Facet { normal: Vector2::new(normal.x, across) / size, offset: f.offset / size, origin: () }
        };
        let floor = Facet { normal: Vector2::new(0.0, -1.0), offset: 0.0, origin: () };
        let facets = whole.facets.iter().map(edge).chain([floor]).collect();
        let all = Polytope { equalities: Vec::new(), facets };
        let scale = Vector2::new(self.scale[0], self.scale[1].max(self.scale[2]));
        let inside = Vector2::new(self.hover[0], 0.5 * disc);
        let mut core = intersect(&[&all], &inside, &scale).without_origins();
        core.facets.retain(|facet| facet.normal.y > -0.5);
        Some(core)
    }
}
