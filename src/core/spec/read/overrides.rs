//! `--set plan.time=20s`: replaces or adds one field before the spec is elaborated.

use super::elaborate::expr_of;
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::source::{Source, SourceMap, Span, Spanned};
use crate::syntax::ast::{Block, ExprKind, Field, Item, LimitRelation, Name, SpecFile, Statement};
use crate::syntax::parse;

const CODE: &str = "mavc::name::override";
/// The name under which the text of an override appears in the [`SourceMap`].
pub const OVERRIDE: &str = "--set";

/// Whether a span lies in the text of a `--set`.
pub fn is_override(sources: &SourceMap, span: Span) -> bool {
    sources.iter().any(|(file, source)| file == span.file && source.name == OVERRIDE)
}

/// One `--set`: the block and the field to set there.
#[derive(Debug, Clone, PartialEq)]
pub struct Override {
    /// The enclosing blocks, outermost first; empty for `gravity`, `allow` and `let`s.
    pub path: Vec<Name>,
    pub field: Field,
}

/// Statements that look like fields, each as it is written.
const STATEMENTS: [(&str, &str); 12] = [
    ("fault", "simulate { fault M1 at 5 s }"),
    ("start", "start at [0, 0, 2] m"),
    ("waypoint", "waypoint at [10, 0, 5] m"),
    ("hold", "hold 3 s"),
    ("mode", "mode M1 { rotor 1 lost }"),
    ("every", "every 1 rotor lost as M"),
    ("keep_in", "keep_in field { shape = box; from = [0, 0, 0] m; to = [9, 9, 9] m }"),
    ("keep_out", "keep_out wall { shape = box; from = [0, 0, 0] m; to = [9, 9, 9] m }"),
    ("part", "part battery { mass = 1.1 kg; at = [0, 0, -3] cm }"),
    ("landing_site", "landing_site pad { at = [12, -8, 0] m; radius = 2 m }"),
    ("keep_off", "keep_off street { shape = box; from = [0, 0] m; to = [40, 6] m }"),
    ("require", "require uncovered <= 0 %"),
];

/// Reads `plan.time=20s`, `vehicle.mass=2 kg`, `vehicle.rotor.max_speed=700rad/s`, `plan.against=[M1]`,
/// `simulate.rate=2kHz`, `campaign.seeds=3`,
/// `mission.limits.tilt=20deg`, `gravity=1.62 m/s^2`, or `a=5 m` for a `let`. The text is added to `sources` under the
/// name [`OVERRIDE`], so that diagnostics can show it.
///
/// # Errors
/// A diagnostic for the first part of the text that cannot be parsed.
#[expect(clippy::result_large_err, reason = "a few a command line")]
pub fn parse_override(text: &str, sources: &mut SourceMap) -> Result<Override, Diagnostic> {
    let file = sources.add(Source::new(OVERRIDE, text));
    let whole = Span::new(file, 0, text.len());
    let shape = |message: &str| {
        Diagnostic::error(CODE, whole, message).help("write it as in `plan.time=20s` or `vehicle.mass=2kg`")
    };
    let Some((path, value)) = text.split_once('=').filter(|_| !text.contains(['\n', ';', '{'])) else {
        return Err(shape("an override must be a field, `=` and a value"));
    };
    let dot = path.rfind('.').map_or(0, |dot| dot + 1);
    let mut names = Vec::new();
    let mut at = 0;
    for word in path[..dot].split_terminator('.') {
        let name = word.trim();
        if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return Err(shape("the path of an override must consist of names and dots"));
        }
        names.push(Spanned::new(name.to_string(), Span::new(file, at, at + word.len())));
        at += word.len() + 1;
    }
    let field = path[dot..].trim();
    if let Some((_, statement)) = STATEMENTS.iter().find(|(name, _)| dot > 0 && *name == field) {
        let message = format!("`--set` sets fields, and `{field}` is a statement");
        let at = Span::new(file, dot, path.len());
        let error = Diagnostic::error(CODE, at, message).here("not a field");
        // With the mode that was asked for, if it is one.
        let is_name = |word: &str| {
            word.starts_with(|c: char| c.is_ascii_alphabetic())
                && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        let mode = value.split_whitespace().next().filter(|word| field == "fault" && is_name(word));
        let statement = mode.map_or(statement.to_string(), |mode| statement.replace("M1", mode));
        return Err(error.help(format!("write it in the spec: `{statement}`")));
    }
    // The path is replaced by blanks, so that the spans of the field are right.
    let field_alone = " ".repeat(dot) + &text[dot..];
    let checked = parse(file, &Source::new(OVERRIDE, field_alone));
    if let Some(error) = checked.diagnostics.into_iter().next() {
        return Err(error);
    }
    match checked.value.map(|tree| tree.items) {
        Some(mut items) if items.len() == 1 => match items.remove(0) {
            Item::Field(field) => Ok(Override { path: names, field }),
            _ => Err(shape("an override must be a field, `=` and a value")),
        },
        _ => Err(shape("an override must be a field, `=` and a value")),
    }
}

/// Applies every override to the trees; the diagnostics are those of overrides that fit nowhere.
pub(super) fn apply(trees: &mut [SpecFile], overrides: &[Override]) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    // Those of the plan first, because the plan chooses the vehicle and the mission.
    let (plan, other): (Vec<_>, Vec<_>) =
        overrides.iter().partition(|o| o.path.first().is_some_and(|name| name.value == "plan"));
    for item in plan.into_iter().chain(other) {
        if let Err(diagnostic) = place(trees, item) {
            diagnostics.push(*diagnostic);
        }
    }
    diagnostics
}

fn place(trees: &mut [SpecFile], item: &Override) -> Result<(), Box<Diagnostic>> {
    let Some((outer, inner)) = item.path.split_first() else {
        return place_top(trees, &item.field);
    };
    let keyword = outer.value.as_str();
    if !matches!(keyword, "plan" | "simulate" | "campaign" | "vehicle" | "mission") {
        let message = format!("`--set` cannot set fields of `{keyword}`");
        return Err(Box::new(
            Diagnostic::error(CODE, outer.span, message)
                .here("not a block that `--set` knows")
                .help("begin the path with `plan`, `simulate`, `campaign`, `vehicle` or `mission`"),
        ));
    }
    let chosen = chosen(trees, keyword);
    let mut blocks: Vec<&mut Block> = trees
        .iter_mut()
        .flat_map(|tree| &mut tree.items)
        .filter_map(|i| if let Item::Block(block) = i { Some(block) } else { None })
        .filter(|block| block.keyword.value == keyword)
        .filter(|block| chosen.is_none() || block.name.as_ref().map(|n| &n.value) == chosen.as_ref())
        .collect();
    if blocks.is_empty() {
        let may_be_added = matches!(keyword, "plan" | "simulate" | "campaign");
        if !may_be_added || trees.is_empty() {
            let message = format!("the spec has no `{keyword}` block");
            return Err(Box::new(Diagnostic::error(CODE, outer.span, message).here("nothing to set")));
        }
        let mut block = empty(outer);
        set(&mut block, inner, &item.field)?;
        trees[0].items.push(Item::Block(block));
        return Ok(());
    }
    blocks.iter_mut().try_for_each(|block| set(block, inner, &item.field))
}

fn place_top(trees: &mut [SpecFile], field: &Field) -> Result<(), Box<Diagnostic>> {
    let name = &field.name.value;
    for item in trees.iter_mut().flat_map(|tree| &mut tree.items) {
        match item {
            Item::Let(old) | Item::Field(old) if old.name.value == *name => {
                old.value = field.value.clone();
                return Ok(());
            }
            _ => {}
        }
    }
    if Group::Top.has(name)
        && let Some(tree) = trees.first_mut()
    {
        tree.items.push(Item::Field(field.clone()));
        return Ok(());
    }
    Err(Box::new(
        Diagnostic::error(CODE, field.name.span, format!("the spec has no `let` named `{name}`"))
            .here("nothing to set")
            .help("to set a field of a block, write its path, as in `plan.time=20s`"),
    ))
}

/// The name of the vehicle or mission that `plan` chooses.
fn chosen(trees: &[SpecFile], keyword: &str) -> Option<String> {
    let plans = trees.iter().flat_map(|tree| &tree.items).filter_map(|item| match item {
        Item::Block(block) if block.keyword.value == "plan" => Some(block),
        _ => None,
    });
    let mut fields = plans.flat_map(|plan| &plan.body).filter_map(|statement| match statement {
        Statement::Field(field) if field.name.value == keyword => expr_of(field),
        _ => None,
    });
    fields.find_map(|expr| if let ExprKind::Name(name) = &expr.kind { Some(name.clone()) } else { None })
}

/// Sets a field of a block, or of the block inside it that `path` leads to.
fn set(block: &mut Block, path: &[Name], field: &Field) -> Result<(), Box<Diagnostic>> {
    if let Some((next, rest)) = path.split_first() {
        let inner = block.body.iter_mut().find_map(|statement| match statement {
            Statement::Block(inner) if inner.keyword.value == next.value => Some(inner),
            _ => None,
        });
        return match inner {
            Some(inner) => set(inner, rest, field),
            None if matches!(
                (block.keyword.value.as_str(), next.value.as_str()),
                ("vehicle", "rotor" | "battery" | "parts")
                    | ("mission", "limits" | "after_fault_limits")
                    | ("plan", "recovery")
            ) =>
            {
                let mut inner = empty(next);
                set(&mut inner, rest, field)?;
                block.body.push(Statement::Block(inner));
                Ok(())
            }
            None => {
                let message = format!("`{}` has no block `{}`", block.keyword.value, next.value);
                let error = Diagnostic::error(CODE, next.span, message).here("unknown block");
                Err(Box::new(error.help(
                    "use `vehicle.rotor`, `vehicle.battery`, `vehicle.parts`, `mission.limits`, \
                     `mission.after_fault_limits` or `plan.recovery`, the inner blocks that `--set` adds",
                )))
            }
        };
    }
    let name = &field.name.value;
    if matches!(block.keyword.value.as_str(), "limits" | "after_fault_limits") {
        let Some(expr) = expr_of(field).cloned() else {
            return Err(Box::new(Diagnostic::error(CODE, field.span, "a limit takes a value or a range")));
        };
        let relation = match expr.kind {
            ExprKind::Range { .. } => LimitRelation::In(expr),
            _ => LimitRelation::AtMost(expr),
        };
        block.body.retain(|s| !matches!(s, Statement::Limit { name: old, .. } if old.value == *name));
        block.body.push(Statement::Limit { name: field.name.clone(), relation, span: field.span });
        return Ok(());
    }
    block.body.retain(|s| !matches!(s, Statement::Field(old) if old.name.value == *name));
    block.body.push(Statement::Field(field.clone()));
    Ok(())
}

fn empty(keyword: &Name) -> Block {
    Block { keyword: keyword.clone(), name: None, title: None, body: Vec::new(), doc: None, span: keyword.span }
}
