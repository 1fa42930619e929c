//! The vehicle from above, x up and y to the left, with the rotors that a fault takes marked; drawn without a script.

use super::chart::rounded;
use crate::model::{FaultMode, Model, RotorState, Spin};
use maud::{Markup, html};

/// Half the width of a view, in units of the drawing, and the part of it that rotors reach.
const HALF: f64 = 100.0;
const INSIDE: f64 = 96.0;
/// Radius of a rotor as a share of the least distance between two, and of the largest from the middle, at most.
const OF_GAP: f64 = 0.46;
const OF_REACH: f64 = 0.75;
/// Rotors nearer to each other than this share of the reach are one over the other.
const SAME_PLACE: f64 = 1e-3;
/// Each of the rotors at one place is drawn smaller than the one before by this share.
const SMALLER: f64 = 0.3;

/// Places of the rotors and their radii, in units of the drawing.
struct Layout {
    /// Middle, radius and the place of the number of each rotor.
    rotors: Vec<Disc>,
}

struct Disc {
    at: [f64; 2],
    radius: f64,
    label: [f64; 2],
    is_alone: bool,
}

impl Layout {
    fn of(model: &Model) -> Self {
        // x forward is up, y to the left is left.
        let places: Vec<[f64; 2]> = model.vehicle.rotors.iter().map(|r| [-r.position[1], -r.position[0]]).collect();
        let apart = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let reach = places.iter().map(|at| at[0].hypot(at[1])).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        let is_same = |a: &[f64; 2], b: &[f64; 2]| apart(a, b) <= SAME_PLACE * reach;
        let pairs = places.iter().enumerate().flat_map(|(i, a)| places[i + 1..].iter().map(move |b| (a, b)));
        let gap = pairs.filter(|(a, b)| !is_same(a, b)).map(|(a, b)| apart(a, b)).fold(2.0 * reach, f64::min);
        let radius = (OF_GAP * gap).min(OF_REACH * reach);
        let scale = INSIDE / (reach + radius);
        let disc = |(k, at): (usize, &[f64; 2])| {
            let before = places[..k].iter().filter(|other| is_same(at, other)).count();
            let all = places.iter().filter(|other| is_same(at, other)).count();
            let drawn = scale * radius * (1.0 - SMALLER * before as f64).max(0.1);
            let down = (before as f64 - 0.5 * (all as f64 - 1.0)) * scale * radius * 0.62;
            let middle = at.map(|x| scale * x);
            Disc { at: middle, radius: drawn, label: [middle[0], middle[1] + down], is_alone: all == 1 }
        };
        Layout { rotors: places.iter().enumerate().map(disc).collect() }
    }
}

/// The vehicle with the numbers of its rotors and the directions in which they turn.
pub fn drawing(model: &Model) -> Markup {
    let of = |letter: Spin| model.vehicle.rotors.iter().filter(|rotor| rotor.spin == letter).count();
    let label = format!("{} from above, nose up, with {} rotors", model.vehicle.name, model.vehicle.rotors.len());
    html! {
        figure #airframe {
            (view(model, None, &label))
            figcaption.note {
                "From above, nose up. P turns counter-clockwise (" (of(Spin::P)) "), N clockwise (" (of(Spin::N))
                "). In the table: " span.lost-word { "red, dashed" } " is lost, " span.weak-word { "amber" }
                " is reduced or stuck."
            }
        }
    }
}

/// A small view with the rotors that a mode takes marked.
pub fn small(model: &Model, mode: &FaultMode) -> Markup {
    let each = mode.rotors.iter().enumerate().filter_map(|(k, state)| match state {
        RotorState::Sound => None,
        RotorState::Lost => Some(format!("rotor {} lost", k + 1)),
        RotorState::Reduced(_) => Some(format!("rotor {} reduced", k + 1)),
        RotorState::Stuck(_) => Some(format!("rotor {} stuck", k + 1)),
    });
    let label = format!("{}: {}", mode.name, each.collect::<Vec<_>>().join(", "));
    view(model, Some(mode), &label)
}

fn letter(spin: Spin) -> &'static str {
    match spin {
        Spin::P => "P",
        Spin::N => "N",
    }
}

fn view(model: &Model, mode: Option<&FaultMode>, label: &str) -> Markup {
    let layout = Layout::of(model);
    let state = |k: usize| mode.map_or(RotorState::Sound, |mode| mode.rotors[k]);
    let class = |k: usize| match state(k) {
        RotorState::Sound => "rotor",
        RotorState::Lost => "rotor lost",
        RotorState::Reduced(_) | RotorState::Stuck(_) => "rotor weak",
    };
    let [low, size] = [-HALF, 2.0 * HALF].map(rounded);
    html! {
        svg.airframe viewBox={ (low) " " (low) " " (size) " " (size) } role="img" aria-label=(label) {
            @for disc in &layout.rotors {
                line.arm x1="0" y1="0" x2=(rounded(disc.at[0])) y2=(rounded(disc.at[1])) {}
            }
            path.nose d="M 0 -22 L 9 2 L 0 -4 L -9 2 Z" {}
            @for (k, disc) in layout.rotors.iter().enumerate() {
                @let [x, y] = disc.at.map(rounded);
                circle class=(class(k)) cx=(x) cy=(y) r=(rounded(disc.radius)) {}
                @if disc.is_alone && state(k) == RotorState::Lost {
                    @let half = 0.62 * disc.radius;
                    @let [left, right, top, bottom] = [x - half, x + half, y - half, y + half].map(rounded);
                    line.cross x1=(left) y1=(top) x2=(right) y2=(bottom) {}
                    line.cross x1=(left) y1=(bottom) x2=(right) y2=(top) {}
                }
            }
            @if mode.is_none() {
                @for (k, disc) in layout.rotors.iter().enumerate() {
                    text x=(rounded(disc.label[0])) y=(rounded(disc.label[1])) {
                        (k + 1) " " (letter(model.vehicle.rotors[k].spin))
                    }
                }
            }
        }
    }
}
