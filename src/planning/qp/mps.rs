//! Free MPS with a QUADOBJ section, for programs without second-order cones.

use super::{Cone, QuadraticProgram};
use std::fmt::Write;

/// The program in free MPS format; `None` if it has a second-order cone, which MPS cannot represent.
///
/// Rows are `A x = b` and `A x <= b`, and all variables are free. QUADOBJ lists the upper triangle of P for the
/// objective `q'x + 1/2 x'P x`. The constant is written as a negative right-hand side of the objective, as the format
/// requires.
pub fn render(program: &QuadraticProgram, name: &str) -> Option<String> {
    let mut kinds = Vec::with_capacity(program.b.len());
    for cone in &program.cones {
        match cone {
            Cone::Zero(n) => kinds.extend(std::iter::repeat_n('E', *n)),
            Cone::Nonnegative(n) => kinds.extend(std::iter::repeat_n('L', *n)),
            Cone::SecondOrder(_) => return None,
        }
    }
    let mut out = format!("NAME {name}\nROWS\n N cost\n");
    for (i, kind) in kinds.iter().enumerate() {
        let _ = writeln!(out, " {kind} r{i}");
    }
    out.push_str("COLUMNS\n");
    for (c, q) in program.q.iter().enumerate() {
        // A column must be named even if it occurs in no row.
        let _ = writeln!(out, " x{c} cost {q:e}");
        for i in program.a.colptr[c]..program.a.colptr[c + 1] {
            let _ = writeln!(out, " x{c} r{} {:e}", program.a.rowval[i], program.a.nzval[i]);
        }
    }
    out.push_str("RHS\n");
    if program.constant != 0.0 {
        let _ = writeln!(out, " rhs cost {:e}", -program.constant);
    }
    for (i, b) in program.b.iter().enumerate().filter(|(_, b)| **b != 0.0) {
        let _ = writeln!(out, " rhs r{i} {b:e}");
    }
    out.push_str("BOUNDS\n");
    for c in 0..program.q.len() {
        let _ = writeln!(out, " FR bnd x{c}");
    }
    out.push_str("QUADOBJ\n");
    for c in 0..program.p.cols {
        for i in program.p.colptr[c]..program.p.colptr[c + 1] {
            let _ = writeln!(out, " x{} x{c} {:e}", program.p.rowval[i], program.p.nzval[i]);
        }
    }
    out.push_str("ENDATA\n");
    Some(out)
}
