//! Whether the parts of a vehicle agree with what is measured of the whole, and whether its axes are principal ones.

use super::{Usual, short, warning};
use crate::model::{Composite, Spread};
use crate::number::percent;
use crate::read::context::Context;
use crate::source::Span;

/// The mass of the parts over that of the vehicle. Cables, connectors, screws and tape that no list has are up to a
/// tenth; chosen by hand.
const MASS: Usual = Usual::new(0.9, 1.1);
/// A moment of inertia of the parts over the measured one. An error of 10 % in the distance of a part is one of 21 % in
/// its share, and boxes are coarse; chosen by hand.
const INERTIA: Usual = Usual::new(1.0 / 1.5, 1.5);
/// Horizontal distance between the two centres of gravity over that of the outermost rotor: with four rotors 5 % move a
/// tenth of a rotor's hover thrust from one side to the other. The height does not matter, because all rotors are
/// parallel.
const CENTRE: Usual = Usual::new(0.0, 0.05);
/// A product of inertia over the geometric mean of the two moments: at 10 % a torque about one axis turns the body a
/// tenth as fast about the other; chosen by hand.
const COUPLING: Usual = Usual::new(0.0, 0.1);

const CODE: &str = "mavc::sense::parts";

/// What is measured of the whole vehicle, with its places in the text.
pub(in crate::spec::read) struct Measured {
    pub mass: Option<(f64, Spread, Span)>,
    pub inertia: Option<([f64; 3], Span)>,
    pub centre_of_gravity: Option<([f64; 3], Span)>,
}

/// Warns where parts and measurements differ. `reach` is the distance (m) of the outermost rotor from the frame's
/// origin, `parts` the place of the block.
pub(in crate::spec::read) fn check(
    cx: &mut Context,
    owner: &str,
    composite: &Composite,
    measured: &Measured,
    reach: f64,
    parts: Span,
) {
    mass(cx, owner, composite, measured, parts);
    centre(cx, owner, composite, measured, reach, parts);
    inertia(cx, owner, composite, measured, parts);
    // A measured inertia is what the parts are compared with; its axes are those of the measurement.
    if measured.inertia.is_none() {
        coupling(cx, owner, composite, parts);
    }
}

fn mass(cx: &mut Context, owner: &str, composite: &Composite, measured: &Measured, parts: Span) {
    let Some((mass, spread, at)) = measured.mass else { return };
    let nearest = composite.mass.clamp(mass * spread.low, mass * spread.high);
    let ratio = composite.mass / nearest;
    if MASS.has(ratio) {
        return;
    }
    let found = format!("the parts of {owner} have {} times its `mass`", short(ratio));
    let slip = match ratio < 1.0 {
        true => "look for a part that is missing, and for `g` in place of `kg`",
        false => "look for a part that is listed twice, and for `kg` in place of `g`",
    };
    let warning = warning(CODE, at, MASS.outside(found, "times"), slip);
    let warning = warning.here(format!("{} kg as a whole", short(mass)));
    cx.report(warning.also(parts, format!("{} kg together", short(composite.mass))));
}

fn centre(cx: &mut Context, owner: &str, composite: &Composite, measured: &Measured, reach: f64, parts: Span) {
    let Some((centre, at)) = measured.centre_of_gravity else { return };
    let [x, y] = [0, 1].map(|axis| composite.centre_of_gravity[axis] - centre[axis]);
    let distance = x.hypot(y);
    if distance <= CENTRE.high * reach {
        return;
    }
    let message = format!(
        "the parts of {owner} have a centre of gravity that is {} m from its `centre_of_gravity` seen from above, more \
         than {} of the distance of the outermost rotor",
        short(distance),
        percent(CENTRE.high)
    );
    let slip = "check the signs of `at` (x forward, y left, z up), and look for a heavy part that is missing";
    let place = |p: [f64; 3]| format!("[{}, {}] m", short(p[0]), short(p[1]));
    let warning = warning(CODE, at, message, slip).here(place(centre));
    cx.report(warning.also(parts, format!("{} from the parts", place(composite.centre_of_gravity))));
}

fn inertia(cx: &mut Context, owner: &str, composite: &Composite, measured: &Measured, parts: Span) {
    let Some((inertia, at)) = measured.inertia else { return };
    let moments = composite.moments();
    let Some(axis) = (0..3).find(|&axis| !INERTIA.has(moments[axis] / inertia[axis])) else { return };
    let ratio = moments[axis] / inertia[axis];
    let name = ["x", "y", "z"][axis];
    let found = format!("the parts of {owner} have {} times its `inertia` about {name}", short(ratio));
    let slip = match ratio < 1.0 {
        true => "look for heavy parts that are missing, as motors without `motor_mass`, and for parts without a `size`",
        false => "look for wrong places of parts, and check the unit of the inertia",
    };
    let warning = warning(CODE, at, INERTIA.outside(found, "times"), slip);
    let warning = warning.here(format!("{} kg*m^2 as a whole", short(inertia[axis])));
    cx.report(warning.also(parts, format!("{} kg*m^2 from the parts", short(moments[axis]))));
}

fn coupling(cx: &mut Context, owner: &str, composite: &Composite, parts: Span) {
    let (axes, coupling) = composite.coupling();
    if COUPLING.has(coupling) {
        return;
    }
    let [a, b] = axes.map(|axis| ["x", "y", "z"][axis]);
    let message = format!(
        "the parts of {owner} have a product of inertia I{a}{b} of {} of the moments about x, y and z, which mavc \
         leaves out",
        percent(coupling)
    );
    let slip = "check the signs of `at`; turn the frame's axes so that they are axes of symmetry";
    let product = short(composite.inertia[axes[0]][axes[1]]);
    cx.report(
        warning("mavc::sense::products", parts, message, slip)
            .here(format!("{product} kg*m^2; at most {} is usual", percent(COUPLING.high))),
    );
}
