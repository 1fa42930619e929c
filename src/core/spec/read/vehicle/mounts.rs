//! Where the rotors of a vehicle are, and how they turn: on a ring, or placed one by one.

use super::{POSITIVE, whole};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::{placed_rotor, vehicle as table};
use crate::model::Spin;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::source::Span;
use crate::syntax::ast::{Block, Clauses, Expr, ExprKind, Statement};
use std::f64::consts::PI;

/// The allowed numbers of rotors.
pub const ROTORS: std::ops::RangeInclusive<usize> = 4..=32;

const MOTOR: &str = "mavc::vehicle::motor";

/// The position and spin of one rotor, and its own clauses.
pub(super) struct Mount<'a> {
    pub position: [f64; 3],
    pub spin: Spin,
    pub motor: Option<u32>,
    pub own: Option<Fields<'a>>,
}

/// The rotors of a vehicle, as far as they are known.
pub(super) struct Mounts<'a> {
    /// Their number, errors or not.
    pub count: Option<usize>,
    /// `None` if one of them has an error.
    pub list: Option<Vec<Mount<'a>>>,
}

/// Reports fields of a ring beside `rotors`.
fn no_ring(cx: &mut Context, fields: &Fields, placed: &Block) {
    for field in Group::Vehicle.rivals("rotors") {
        let Some(at) = fields.span_of(field) else { continue };
        let message = format!("`{field}` describes a ring, but {} places its rotors one by one", fields.owner);
        cx.report(
            Diagnostic::error("mavc::vehicle::conflict", at, message)
                .here("not allowed together with `rotors`")
                .also(placed.keyword.span, "rotors are placed here")
                .help("remove one of the two"),
        );
    }
}

/// Rotors on a circle: rotor k at the angle `first + 2 pi (k-1)/n`, clockwise from +y.
pub(super) fn ring<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Mounts<'a> {
    if !fields.may_have("layout") {
        // A ring needs an arm too; the example adds one, but its absence is reported only where a ring is certain.
        let arm = if fields.may_have("arm") { "" } else { "; arm = 0.2 m" };
        let (example, one_by_one) =
            (format!("layout = \"PPNNPPNN\"{arm}"), "rotors { rotor at [0.2, 0.2, 0] m spin P ... }");
        fields.missing_or(cx, "`layout`", &example, &format!("add `{example}`, or `{one_by_one}`"));
    }
    let layout = fields.get("layout").and_then(|e| spins(cx, e));
    let layout_span = fields.get("layout").map_or(fields.span, |e| e.span);
    layout.iter().for_each(|spins| whole::check_spins(cx, &fields.owner, layout_span, spins));
    // Without a `layout` the vehicle may not be meant as a ring, so that no missing `arm` is reported.
    let arm = match fields.get("layout") {
        Some(_) => fields.demand(cx, "arm", "arm = 0.2 m"),
        None => fields.get("arm"),
    };
    let arm = arm.and_then(|e| cx.quantity(&table::ARM, e, POSITIVE));
    let first = fields.written("first", |expr| cx.number(Expected::of(&table::FIRST), expr)).or_default(|| 0.0);
    let count = layout.as_ref().map(Vec::len);
    let (Some(spins), Some(arm), Some(first)) = (layout, arm, first) else { return Mounts { count, list: None } };
    let n = spins.len() as f64;
    let mounts = spins.into_iter().enumerate().map(|(k, spin)| {
        let (sin, cos) = exact_sin_cos(first + 2.0 * PI * k as f64 / n);
        Mount { position: [arm * sin, arm * cos, 0.0], spin, motor: None, own: None }
    });
    Mounts { count, list: Some(mounts.collect()) }
}

/// Rotors placed one by one.
pub(super) fn one_by_one<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, block: &'a Block) -> Mounts<'a> {
    no_ring(cx, fields, block);
    let owner = &fields.owner;
    let rotors: Vec<&'a Clauses> =
        block.body.iter().filter_map(|s| if let Statement::Rotor(r) = s { Some(r) } else { None }).collect();
    for statement in &block.body {
        if let Statement::Field(field) = statement {
            let message = format!("`rotors` of {owner} has no field `{}`", field.name.value);
            let error = Diagnostic::error("mavc::name::unknown_field", field.name.span, message).here("unknown field");
            cx.report(error.help("write what all rotors share in a `rotor { ... }` block beside it"));
        }
    }
    if block.is_whole() && !ROTORS.contains(&rotors.len()) {
        let message = format!("a vehicle must have 4 to 32 rotors, not {}", rotors.len());
        let error = Diagnostic::error("mavc::vehicle::rotor_count", block.keyword.span, message);
        let help = if rotors.len() < *ROTORS.start() { "add `rotor at` statements" } else { "remove some rotors" };
        let follow =
            if rotors.len() == 1 { "1 rotor follows".to_string() } else { format!("{} rotors follow", rotors.len()) };
        cx.report(error.here(follow).help(help));
        return Mounts { count: None, list: None };
    }
    // With a rotor that could not be parsed, the whole is unknown.
    let mut mounts = block.is_whole().then(Vec::new);
    for (k, rotor) in rotors.iter().enumerate() {
        let mount = placed(cx, rotor, k + 1);
        match (&mut mounts, mount) {
            (Some(list), Some(mount)) => list.push(mount),
            (list, _) => *list = None,
        }
    }
    if let Some(mounts) = &mounts {
        check_motors(cx, mounts);
        let spins: Vec<Spin> = mounts.iter().map(|mount| mount.spin).collect();
        whole::check_spins(cx, owner, fields.span, &spins);
    }
    Mounts { count: block.is_whole().then_some(rotors.len()), list: mounts }
}

/// Sine and cosine, exact at the quarter turns so that a ring is symmetric to the last digit.
fn exact_sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / (PI / 2.0);
    if (quarters - quarters.round()).abs() < 1e-12 {
        return match quarters.round().rem_euclid(4.0) as u8 {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    angle.sin_cos()
}

/// How motors above each other are written.
const COAXIAL: &str = "write motors that share an arm one by one: `rotors { rotor at [0.2, 0.2, 0.03] m  spin \
                                  P; rotor at [0.2, 0.2, -0.03] m  spin N; ... }`";

/// How a frame that is given by its name is written.
fn frame(name: &str) -> Option<&'static str> {
    let name = name.to_ascii_lowercase();
    let has = |parts: &[&str]| parts.iter().any(|part| name.contains(part));
    match () {
        () if has(&["coax", "y6", "x8", "y4", "octoquad", "octaquad"]) => Some(COAXIAL),
        () if has(&["quad", "x4"]) => Some("write the motors' directions in turn, such as `\"PNPN\"`"),
        () if has(&["hex", "x6"]) => Some("write the motors' directions in turn, such as `\"PNPNPN\"`"),
        () if has(&["oct"]) => Some("write the motors' directions in turn, such as `\"PNPNPNPN\"`"),
        () => None,
    }
}

fn spins<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<Vec<Spin>> {
    let ExprKind::Text(text) = &expr.kind else {
        let error =
            Diagnostic::error("mavc::vehicle::layout", expr.span, "`layout` must be text of the letters P and N");
        let error = error.here("not text in quotes");
        cx.report(match &expr.kind {
            ExprKind::Name(name) if name.chars().all(|c| matches!(c.to_ascii_uppercase(), 'P' | 'N')) => {
                let corrected = format!("\"{}\"", name.to_ascii_uppercase());
                error.help(format!("write `{corrected}`")).fix(expr.span, corrected)
            }
            _ => error.help("write `layout = \"PNPN\"`"),
        });
        return None;
    };
    if let Some((at, letter)) = text.char_indices().find(|(_, c)| !matches!(c, 'P' | 'N')) {
        let start = expr.span.start as usize + 1 + at;
        let span = Span::new(expr.span.file, start, start + letter.len_utf8());
        let message = format!("a layout may contain only P and N, not `{letter}`");
        let mut error = Diagnostic::error("mavc::vehicle::layout", span, message).here("neither P nor N");
        let capitals = text.to_ascii_uppercase();
        error = match letter.to_ascii_uppercase() {
            _ if capitals.chars().all(|c| matches!(c, 'P' | 'N')) => {
                let corrected = format!("\"{capitals}\"");
                error.help(format!("write `{corrected}`")).fix(expr.span, corrected)
            }
            upper @ ('P' | 'N') => error.help(format!("write `{upper}`")).fix(span, upper.to_string()),
            _ => error.help(frame(text).unwrap_or("write `P` (counter-clockwise seen from above) or `N` (clockwise)")),
        };
        cx.report(error);
        return None;
    }
    if !text.len().is_multiple_of(2) || !ROTORS.contains(&text.len()) {
        let message = format!("a ring must have an even number of rotors from 4 to 32, not {}", text.len());
        let error = Diagnostic::error("mavc::vehicle::rotor_count", expr.span, message);
        let letters = if text.len() == 1 { "1 letter".to_string() } else { format!("{} letters", text.len()) };
        cx.report(error.here(format!("{letters}, one per rotor")).help(match text.len() {
            few if few < *ROTORS.start() => {
                "write a letter for each rotor: a quadcopter is \"PNPN\", a hexacopter \"PNPNPN\"".to_string()
            }
            many if many > *ROTORS.end() => format!("remove letters until {} are left", ROTORS.end()),
            odd => format!(
                "write {} or {} letters, or place the {odd} rotors one by one: \
                 `rotors {{ rotor at [0.2, 0.15, 0] m  spin P; .. }}`",
                odd - 1,
                odd + 1
            ),
        }));
        return None;
    }
    Some(text.chars().map(|c| if c == 'P' { Spin::P } else { Spin::N }).collect())
}

/// Every rotor has a motor of its own, or none has a number.
fn check_motors(cx: &mut Context, mounts: &[Mount]) {
    let clause = |k: usize| mounts[k].own.as_ref().and_then(|own| own.clause(placed_rotor::MOTOR.name));
    let numbered = mounts.iter().position(|mount| mount.motor.is_some());
    let Some((first, at)) = numbered.and_then(|k| Some((k, clause(k)?))) else { return };
    for (k, mount) in mounts.iter().enumerate() {
        let before = mounts[..k].iter().position(|other| mount.motor.is_some() && other.motor == mount.motor);
        if let (Some(motor), Some((span, other))) = (mount.motor, clause(k).zip(before.and_then(clause))) {
            let message = format!("motor {motor} turns two rotors");
            let error = Diagnostic::error(MOTOR, span, message).here("given again").also(other, "first given here");
            cx.report(error.help("give each rotor the number of its own motor"));
        }
        if let (None, Some(own)) =
            (mount.motor, mount.own.as_ref().filter(|own| !own.may_have(placed_rotor::MOTOR.name)))
        {
            let message = format!("rotor {} has no `motor`, but rotor {} has one", k + 1, first + 1);
            let error = Diagnostic::error(MOTOR, own.span, message).here("no motor").also(at, "a motor");
            cx.report(error.help("number the motors of all rotors, or of none"));
            return;
        }
    }
}

fn placed<'a>(cx: &mut Context<'a>, rotor: &'a Clauses, k: usize) -> Option<Mount<'a>> {
    let own = Fields::of_clauses(cx, format!("rotor {k}"), rotor, Group::PlacedRotor);
    let position =
        own.demand(cx, "at", "at [0.2, 0.15, 0] m").and_then(|e| cx.triple(Expected::of(&placed_rotor::AT), e));
    let spin = own.demand(cx, "spin", "spin P").and_then(|e| match &e.kind {
        ExprKind::Name(name) if name == "P" => Some(Spin::P),
        ExprKind::Name(name) if name == "N" => Some(Spin::N),
        _ => {
            let error = Diagnostic::error("mavc::vehicle::spin", e.span, "`spin` must be `P` or `N`");
            let error = error.here("neither of these");
            let word = cx.sources.snippet(e.span).trim_matches('"').to_ascii_lowercase();
            cx.report(match word.as_str() {
                "p" | "ccw" | "counterclockwise" | "positive" | "left" => {
                    error.help("write `P`, which turns counter-clockwise seen from above").fix(e.span, "P")
                }
                "n" | "cw" | "clockwise" | "negative" | "right" => {
                    error.help("write `N`, which turns clockwise seen from above").fix(e.span, "N")
                }
                _ => error.help("write `P` (counter-clockwise seen from above) or `N` (clockwise)"),
            });
            None
        }
    });
    let motor = own.count(cx, &placed_rotor::MOTOR, MOTOR).and_then(|motor| u32::try_from(motor).ok());
    Some(Mount { position: position?, spin: spin?, motor: motor.optional().ok()?, own: Some(own) })
}
