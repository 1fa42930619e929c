//! Tables 1 to 7: residuals of (31) and verdicts.

use super::alternatives::{clipped_pseudo_inverse, mass_that_leaves, torque_with_thrust_held, with_printed_twelve};
use super::judgement::differs;
use super::markdown::{as_printed, fixed, none, paragraph, table, vector};
use super::paper_faults::{Row, TABLES, Table};
use super::specs;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::edge::{EDGE, HoverPlace};
use mavc::admissible::verdict::{HoverVerdict, ModeAnalysis, analyze_all};
use mavc::model::{Model, Spread, YawDrag};

/// One unit of the paper's last digit, and rounding.
pub const LAST_DIGIT: f64 = 0.0101;

pub fn sections() -> String {
    explanation() + &TABLES.iter().map(section).collect::<String>()
}

fn explanation() -> String {
    let held = Study::of("hexa_pnpnpn");
    let neighbours = &[1, 2];
    let printed = TABLES.iter().filter(|t| t.number == 3).flat_map(|t| t.rows).find(|r| r.rotors == neighbours);
    let printed = printed.expect("Table 3 holds the loss of rotors 1 and 2");
    paragraph(
        "e_p is A Omega_s - u_ref of (31) in N and N m, first with all four components, then without tau_z. (The \
         heading of Table 1 prints u - A Omega_s, but its signs are those of A Omega_s - u_ref.) The verdict of the \
         paper follows from its zeros. The margin is the signed distance from hover to the boundary of the set in \
         the plain (N, N m) norm (the index of Du and Quan; outside the set it is that of the most violated facet), \
         or `flat` if the set has no interior. The last mass is the heaviest that can hover with all four components \
         held. The paper has no counterpart to the column on yaw given up: how the vehicle hovers then, and the largest \
         roll and pitch torque in N m that it gives in every direction ([method](method/without-yaw.md)). Whether a spin \
         helps is decided with a yaw drag of 2.75e-3 N m s/rad, which the paper does not give.",
    ) + &paragraph(&format!(
        "A row agrees if the verdict is the same and no component differs by more than one unit of the paper's last \
         digit (0.01). The least residual of a bounded least-squares problem is unique, so a printed vector longer \
         than it does not solve (31) with the printed parameters, and a shorter one requires other parameters. The \
         paper does not say how its solver weighs newtons against newton metres. With the thrust held exactly at m g \
         the torque residual is {} N m for rotors 1 and 2 of PNPNPN, while Table 3 prints {}.",
        fixed(torque_with_thrust_held(&held.model, held.set(neighbours)), 3),
        fixed(norm(&printed.full[1..]), 3),
    ))
}

/// The yaw drag of every vehicle, N m s/rad: that of a published quadcopter (Mueller and D'Andrea, ICRA 2014).
const YAW_DRAG: f64 = 2.75e-3;

/// A vehicle with its sets and the analysis of hover in each.
struct Study {
    model: Model,
    sets: Vec<AdmissibleSet>,
    found: Vec<ModeAnalysis>,
}

impl Study {
    fn of(vehicle: &str) -> Self {
        Self::of_model(specs::vehicle(vehicle))
    }

    fn of_model(mut model: Model) -> Self {
        model.vehicle.yaw_drag = Some(YawDrag { linear: YAW_DRAG, spread: Spread::NONE, quadratic: 0.0 });
        let sets = AdmissibleSet::all(&model);
        let found = analyze_all(&model, &sets);
        Study { model, sets, found }
    }

    fn place(&self, lost: &[usize]) -> usize {
        self.found.iter().position(|m| m.lost == lost).unwrap_or_else(|| panic!("no mode loses {lost:?}"))
    }

    fn mode(&self, lost: &[usize]) -> &ModeAnalysis {
        &self.found[self.place(lost)]
    }

    fn set(&self, lost: &[usize]) -> &AdmissibleSet {
        &self.sets[self.place(lost)]
    }
}

fn section(paper: &Table) -> String {
    let study = Study::of(paper.vehicle);
    let printed_twelve = (paper.vehicle == "hexa_ppnnpn").then(|| Study::of_model(with_printed_twelve(&study.model)));
    let of = |row: &Row| study.mode(row.rotors);
    let rows: Vec<Vec<String>> = paper
        .rows
        .iter()
        .map(|r| {
            let judged = match paper_verdict(r) == of(r).verdict {
                true => judged_numbers(r, of(r)),
                false => differs(&other_verdict(r, of(r), &study.model, printed_twelve.as_ref())),
            };
            cells(r, of(r), judged)
        })
        .collect();
    let layout = study.model.vehicle.layout.as_deref().unwrap_or("");
    let heading = format!("### Table {}: {} ({layout})\n\n", paper.number, paper.title);
    let header = [
        "lost",
        "e_p, paper",
        "e_p",
        "e_p without tau_z, paper",
        "e_p without tau_z",
        "verdict, paper",
        "verdict",
        "margin",
        "heaviest kg",
        "yaw given up",
        "row",
    ];
    let note = printed_twelve.as_ref().map(|t| two_matrices(paper, &study, t)).unwrap_or_default();
    heading + &table(&header, &rows) + &totals(paper, &of) + &note
}

/// Which of the two matrices for PPNNPN the table of the paper matches.
fn two_matrices(paper: &Table, geometry: &Study, printed: &Study) -> String {
    let misfits = |s: &Study| paper.rows.iter().filter(|r| s.mode(r.rotors).verdict != paper_verdict(r)).count();
    paragraph(&format!(
        "Of these {} verdicts of the paper, {} differ from those of evenly spaced rotors, and {} from those of (12) \
         with its third row as printed.",
        paper.rows.len(),
        misfits(geometry),
        misfits(printed)
    ))
}

/// How many faults lose control, and how many lose hover altogether.
fn totals<'a>(paper: &Table, of: &dyn Fn(&Row) -> &'a ModeAnalysis) -> String {
    let rows = paper.rows.len();
    let compared = |lost: &dyn Fn(HoverVerdict) -> bool| {
        let printed = paper.rows.iter().filter(|r| lost(paper_verdict(r))).count();
        let here = paper.rows.iter().filter(|r| lost(of(r).verdict)).count();
        let share = |n: usize| format!("{n} of {rows} ({:.0} %)", 100.0 * n as f64 / rows as f64);
        let judged = if printed == here { "agrees" } else { "**differs**" };
        format!("paper {}, here {}: {judged}.", share(printed), share(here))
    };
    paragraph(&format!(
        "Control lost: {} Unstable: {}",
        compared(&|v| v != HoverVerdict::Controllable),
        compared(&|v| v == HoverVerdict::Unstable)
    ))
}

/// Zeros with tau_z: controllable; zeros without: stabilizable. Table 1 prints no second residual, and the text
/// calls its rows stabilizable.
fn paper_verdict(row: &Row) -> HoverVerdict {
    let zero = |v: &[f64]| v.iter().all(|&x| x == 0.0);
    match row.yaw_free {
        _ if zero(&row.full) => HoverVerdict::Controllable,
        Some(e) if !zero(&e) => HoverVerdict::Unstable,
        _ => HoverVerdict::Stabilizable,
    }
}

fn cells(row: &Row, found: &ModeAnalysis, judged: String) -> Vec<String> {
    let rotors: Vec<String> = row.rotors.iter().map(usize::to_string).collect();
    vec![
        rotors.join(", "),
        as_printed(&row.full),
        vector(&found.residual4, 4),
        row.yaw_free.map_or_else(none, |e| as_printed(&e)),
        vector(&found.residual3, 4),
        paper_verdict(row).name().into(),
        found.verdict.name().into(),
        found.acai.map_or("flat".into(), |a| fixed(a, 4)),
        found.critical_mass_kg.map_or_else(none, |m| fixed(m, 3)),
        without_yaw(found),
        judged,
    ]
}

/// `interior, 1.162`: how the mode hovers with yaw given up, and its disc in N m.
fn without_yaw(found: &ModeAnalysis) -> String {
    let disc = found.without_yaw.as_ref().map_or_else(String::new, |w| format!(", {}", fixed(w.disc_n_m, 3)));
    format!("{}{disc}", found.yaw_free.word())
}

/// Why the paper's verdict differs, if another reading of (31) explains it.
fn other_verdict(row: &Row, found: &ModeAnalysis, model: &Model, printed_twelve: Option<&Study>) -> String {
    let mut reason = match found.critical_mass_kg {
        Some(mass) => format!("with these parameters the vehicle hovers up to {} kg", fixed(mass, 3)),
        None => "with these parameters the vehicle hovers at no mass".into(),
    };
    if printed_twelve.is_some_and(|t| t.mode(row.rotors).verdict == paper_verdict(row)) {
        reason +=
            "; the verdict matches (12) with its third row as printed, in which rotors 2 and 6, and 3 and 5, coincide";
    }
    if found.verdict == HoverVerdict::Controllable {
        if let Some((mass, left)) = mass_that_leaves(model, row.rotors, norm(&row.full)) {
            let apart = |sign: f64| row.full.iter().zip(&left).map(|(p, l)| (sign * p - l).abs()).fold(0.0, f64::max);
            // Rounding alone: a whole unit is as long as these vectors.
            let rounding = 0.5 * LAST_DIGIT;
            let sign = match (apart(1.0) <= rounding, apart(-1.0) <= rounding) {
                (true, _) => Some(""),
                (false, true) => Some(", with opposite sign"),
                _ => None,
            };
            if let Some(sign) = sign {
                reason += &format!("; the printed residual is that of {} kg{sign}", fixed(mass, 2));
            }
        }
        let clipped = clipped_pseudo_inverse(model, row.rotors);
        if clipped.norm() > EDGE {
            let clipped = vector(clipped.as_slice(), 4);
            reason += &format!("; a pseudo-inverse clipped to the rotors' range misses hover by {clipped}");
        }
    }
    reason
}

/// The verdict is the same; are the residuals?
fn judged_numbers(row: &Row, found: &ModeAnalysis) -> String {
    let pairs = [(&row.full[..], &found.residual4[..])]
        .into_iter()
        .chain(row.yaw_free.as_ref().map(|e| (&e[..], &found.residual3[..])));
    for (printed, least) in pairs {
        let apart = printed.iter().zip(least).map(|(p, l)| (p - l).abs()).fold(0.0, f64::max);
        if apart > LAST_DIGIT {
            let (p, l) = (norm(printed), norm(least));
            let reason = match p - l {
                d if d > LAST_DIGIT => "longer than the least residual",
                d if d < -LAST_DIGIT => "shorter than the least residual",
                _ => "as long as the least residual but in another direction",
            };
            return format!("**differs** in numbers, same verdict: {} is {reason}, {}", fixed(p, 2), fixed(l, 2));
        }
    }
    let remark = match (found.hover, found.verdict) {
        (HoverPlace::OnEdge, HoverVerdict::Controllable) => {
            "; hover lies on the boundary, which Du and Quan call uncontrollable"
        }
        (HoverPlace::OnEdge, HoverVerdict::Stabilizable) => "; without tau_z hover lies on the boundary",
        _ => "",
    };
    let misprint = match row.rotors {
        [3, 8] => " (printed as a second M37)",
        _ => "",
    };
    format!("agrees{remark}{misprint}")
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
