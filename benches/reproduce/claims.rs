//! Statements in the paper's text about sets and layouts.

use super::faults::LAST_DIGIT;
use super::judgement::{STATEMENTS, agrees_if, differs, listed, statement};
use super::markdown::{fixed, table};
use super::specs;
use mavc::admissible::allocation::Allocator;
use mavc::admissible::verdict::{HoverVerdict, ModeAnalysis, analyze_all};
use mavc::admissible::{AdmissibleSet, intersection};
use mavc::model::Model;

/// A vehicle with its sets and verdicts, healthy first, then single, then double faults.
struct Studied {
    model: Model,
    sets: Vec<AdmissibleSet>,
    modes: Vec<ModeAnalysis>,
}

fn studied(vehicle: &str) -> Studied {
    let model = specs::vehicle(vehicle);
    let sets = AdmissibleSet::all(&model);
    let modes = analyze_all(&model, &sets);
    Studied { model, sets, modes }
}

impl Studied {
    fn losing(&self, rotors: usize) -> impl Iterator<Item = &ModeAnalysis> {
        self.modes.iter().filter(move |m| m.lost.len() == rotors)
    }

    fn layout(&self) -> &str {
        self.model.vehicle.layout.as_deref().unwrap_or("")
    }

    fn tolerates_every_single(&self) -> bool {
        self.losing(1).all(|m| m.verdict == HoverVerdict::Controllable)
    }

    fn smallest_single_margin(&self) -> f64 {
        self.losing(1).filter_map(|m| m.acai).fold(f64::INFINITY, f64::min)
    }

    fn largest_single_margin(&self) -> f64 {
        self.losing(1).filter_map(|m| m.acai).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Number of double faults after which all four components of hover are kept at a mass, kg.
    fn tolerated_at(&self, mass: f64) -> usize {
        self.losing(2).filter(|m| m.critical_mass_kg.is_some_and(|c| c >= mass)).count()
    }
}

pub fn section() -> String {
    let quad = studied("quad_pnpn");
    let hexas = ["hexa_pnpnpn", "hexa_ppnnpn"].map(studied);
    let octos = ["octo_pnpnpnpn", "octo_ppnnppnn"].map(studied);
    let rows = [
        hover_speed(&quad),
        inequalities(&octos),
        empty(&octos),
        hexacopters(&hexas),
        octocopters(&octos),
        preferred(&octos),
    ];
    table(&STATEMENTS, &rows)
}

fn hover_speed(quad: &Studied) -> Vec<String> {
    const PRINTED: f64 = 569.35;
    let speeds = Allocator::new(&quad.model.vehicle).speeds(&quad.sets[0].hover);
    let furthest = speeds.iter().copied().max_by(|a, b| (a - PRINTED).abs().total_cmp(&(b - PRINTED).abs()));
    let furthest = furthest.expect("a quadcopter has rotors");
    statement(
        format!("the quadcopter hovers with every rotor at {PRINTED} rad/s"),
        format!("{} rad/s", fixed(furthest, 3)),
        agrees_if((furthest - PRINTED).abs() <= LAST_DIGIT, "the parameters give another speed"),
    )
}

fn inequalities(octos: &[Studied; 2]) -> Vec<String> {
    let [healthy, single] = [0, 1].map(|lost| {
        let counts: Vec<usize> = octos.iter().flat_map(|o| o.losing(lost)).filter_map(|m| m.facets).collect();
        (counts.iter().copied().min().unwrap_or(0), counts.iter().copied().max().unwrap_or(0))
    });
    let counted = |(low, high): (usize, usize)| if low == high { low.to_string() } else { format!("{low} to {high}") };
    statement(
        "617 inequalities describe the healthy octocopter's set, 440 the set after one fault",
        format!("{} and {} facets, over both layouts and all faults", counted(healthy), counted(single)),
        agrees_if(
            healthy == (617, 617) && single == (440, 440),
            "these are the facets of a minimal description; a triangulated hull has more, and their number depends on \
             the tool",
        ),
    )
}

fn empty(octos: &[Studied; 2]) -> Vec<String> {
    let joint: Vec<(String, bool)> = octos
        .iter()
        .map(|o| {
            let singles: Vec<&AdmissibleSet> =
                o.sets.iter().zip(&o.modes).filter(|(_, m)| m.lost.len() == 1).map(|(s, _)| s).collect();
            let set = intersection(&singles);
            let margin = set.margin(&o.sets[0].hover);
            let inside = if margin > 0.0 { "inside" } else { "outside" };
            let text =
                format!("{}: {} facets, hover {} {inside}", o.layout(), set.facets.len(), fixed(margin.abs(), 4));
            (text, margin > 0.0)
        })
        .collect();
    let texts: Vec<&str> = joint.iter().map(|(t, _)| t.as_str()).collect();
    statement(
        "the sets of all eight single faults have an empty intersection (Case 3)",
        texts.join("; "),
        agrees_if(
            joint.iter().all(|(_, holds_hover)| !holds_hover),
            "with the paper's own parameters it is not empty; a mission can be infeasible in a given time",
        ),
    )
}

fn hexacopters(hexas: &[Studied; 2]) -> Vec<String> {
    let described = hexas.iter().map(|h| {
        let failing: Vec<String> =
            h.losing(1).filter(|m| m.verdict != HoverVerdict::Controllable).map(|m| m.name.clone()).collect();
        let reach = match failing.as_slice() {
            [] => "hover reachable after every loss".to_string(),
            some => format!("hover not reachable after {}", listed(some)),
        };
        let (least, most) = (fixed(h.smallest_single_margin(), 4), fixed(h.largest_single_margin(), 4));
        let margin = if least == most { format!("margin {least}") } else { format!("margins from {least} to {most}") };
        format!("{}: {reach}, {margin}", h.layout())
    });
    statement(
        "both hexacopters tolerate the loss of any rotor",
        described.collect::<Vec<_>>().join("; "),
        agrees_if(hexas.iter().all(Studied::tolerates_every_single), "see Table 2"),
    )
}

fn octocopters(octos: &[Studied; 2]) -> Vec<String> {
    let margins: Vec<String> = octos
        .iter()
        .map(|o| format!("{}: smallest margin {}", o.layout(), fixed(o.smallest_single_margin(), 4)))
        .collect();
    statement(
        "both octocopters tolerate the loss of any rotor",
        margins.join("; "),
        agrees_if(octos.iter().all(Studied::tolerates_every_single), "see Table 5"),
    )
}

/// Which layout tolerates more double faults depends on the mass alone, and changes only at a mode's largest mass.
fn preferred([alternating, paired]: &[Studied; 2]) -> Vec<String> {
    let better = |mass: f64| paired.tolerated_at(mass) > alternating.tolerated_at(mass);
    let mut bounds: Vec<f64> =
        [alternating, paired].iter().flat_map(|o| o.losing(2)).filter_map(|m| m.critical_mass_kg).collect();
    bounds.push(0.0);
    bounds.sort_by(f64::total_cmp);
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    // There is no range between largest masses that differ by rounding alone.
    for pair in bounds.windows(2).filter(|p| p[1] - p[0] > 1e-9 && better(0.5 * (p[0] + p[1]))) {
        match ranges.last_mut() {
            Some(last) if pair[0] - last[1] <= 1e-9 => last[1] = pair[1],
            _ => ranges.push([pair[0], pair[1]]),
        }
    }
    let ranges: Vec<String> =
        ranges.iter().map(|[from, to]| format!("from {} to {} kg", fixed(*from, 3), fixed(*to, 3))).collect();
    let mass = paired.model.vehicle.mass;
    let [tolerated, tolerated_paired] = [alternating, paired].map(|o| o.tolerated_at(mass));
    let judged = match better(mass) {
        true => "agrees".to_string(),
        false => differs("at this mass PNPNPNPN tolerates as many double faults or more"),
    };
    statement(
        "PPNNPPNN is the better layout if double faults are likely",
        format!(
            "of {} double faults at {mass} kg PNPNPNPN tolerates {tolerated} and PPNNPPNN {tolerated_paired}; PPNNPPNN tolerates more {}",
            paired.losing(2).count(),
            match ranges.as_slice() {
                [] => "at no mass".into(),
                some => listed(some),
            }
        ),
        judged,
    )
}
