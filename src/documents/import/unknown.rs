//! The figures of a text that stand as `?`.

use crate::source::{FileId, Source};
use crate::syntax::ast::{Block, ExprKind, Field, FieldValue, Item, Statement};
use crate::syntax::parse;

/// The paths by which `--set` fills the figures that stand as `?`, in their order: `arm`, `vehicle.mass`,
/// `vehicle.rotor.max_speed`. Those of single rotors have no path, and are left out.
pub fn paths(text: &str) -> Vec<String> {
    let tree = parse(FileId(0), &Source::new("", text)).value;
    let items = tree.map_or(Vec::new(), |tree| tree.items);
    let mut found = Vec::new();
    for item in &items {
        match item {
            Item::Let(field) | Item::Field(field) if is_unknown(field) => found.push(field.name.value.clone()),
            Item::Block(block) => within(block, "", &mut found),
            _ => {}
        }
    }
    found
}

fn within(block: &Block, outer: &str, found: &mut Vec<String>) {
    let path = format!("{outer}{}.", block.keyword.value);
    for statement in &block.body {
        match statement {
            Statement::Field(field) if is_unknown(field) => found.push(format!("{path}{}", field.name.value)),
            Statement::Block(inner) => within(inner, &path, found),
            _ => {}
        }
    }
}

fn is_unknown(field: &Field) -> bool {
    matches!(&field.value, FieldValue::Expr(expr) if expr.kind == ExprKind::Unknown)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Compiler;

    #[test]
    fn every_path_can_be_set() {
        let text = "let arm = ?\nvehicle v {\n    layout = \"PPNN\"\n    arm = arm\n    mass = ?\n    inertia = [0.01, \
            0.01, 0.02] kg*m^2\n    rotor { max_thrust = 8 N; torque_per_thrust = ?; max_speed = ? }\n}\n";
        let found = paths(text);
        assert_eq!(found, ["arm", "vehicle.mass", "vehicle.rotor.torque_per_thrust", "vehicle.rotor.max_speed"]);
        let figures = ["0.2 m", "1 kg", "15 mm", "900 rad/s"];
        let sets = found.iter().zip(figures).map(|(path, figure)| format!("{path} = {figure}"));
        let compiled = sets.fold(Compiler::new(), Compiler::set).text("v.mav", text.as_bytes());
        assert!(compiled.spec.is_some(), "{}", compiled.render());
    }

    #[test]
    fn figures_of_single_rotors_have_no_path() {
        assert!(paths("vehicle v { rotors { rotor at [1, 0, 0] m spin ? } }").is_empty());
        assert!(paths("vehicle {{{").is_empty());
    }
}
