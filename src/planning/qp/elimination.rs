//! Elimination of a program's equations: some variables are written in the others.
//!
//! In the linear systems of an interior-point method an equation has no pivot but the solver's regularisation, which
//! then limits how closely the equation holds. Without equations the solver needs hardly any. Equations that share
//! variables form a block, which is solved by Gaussian elimination with full pivoting (Golub and Van Loan, *Matrix
//! Computations*, section 3.4).

use super::{QuadraticProgram, Sparse};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Equations with more variables than this stay: their elimination would fill other rows. Chosen by hand.
const MOST_TERMS: usize = 8;

/// Blocks with more equations than this stay: each of their variables could end in all rows of the block.
/// Chosen by hand.
const MOST_EQUATIONS: usize = 24;

/// A pivot smaller than this share of the largest entry of its row counts as zero. Chosen by hand.
const LEAST_PIVOT: f64 = 1e-9;

/// A sum of variables, by index with their weights, and a constant.
type Sum = (Vec<(usize, f64)>, f64);

/// What a variable becomes.
#[derive(Debug, Clone, PartialEq)]
enum Variable {
    /// The variable of this index.
    Free(usize),
    Sum(Sum),
}

/// Equations that determine as many variables.
#[derive(Debug, Clone, PartialEq)]
struct Block {
    rows: Vec<usize>,
    determined: Vec<usize>,
    /// The inverse of their coefficients on these variables: a row for each variable, a column for each equation.
    inverse: DMatrix<f64>,
}

/// Which equations and variables of a program are eliminated.
#[derive(Debug, Clone, PartialEq)]
pub struct Elimination {
    variables: Vec<Variable>,
    free: usize,
    blocks: Vec<Block>,
    /// The rows that stay, in their order.
    pub kept: Vec<usize>,
}

/// Sets that are joined one by one (disjoint-set forest).
struct Sets(Vec<usize>);

impl Sets {
    fn of(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.of(i), self.of(j));
        self.0[i.max(j)] = i.min(j);
    }
}

impl Elimination {
    /// The elimination of the equations among the first `equations` rows of `A x + s = b`, s = 0 there.
    pub fn of(a: &Sparse, b: &[f64], equations: usize) -> Elimination {
        let mut terms: Vec<Vec<(usize, f64)>> = vec![Vec::new(); equations];
        for c in 0..a.cols {
            for i in a.colptr[c]..a.colptr[c + 1] {
                if a.rowval[i] < equations && a.nzval[i] != 0.0 {
                    terms[a.rowval[i]].push((c, a.nzval[i]));
                }
            }
        }
        let short = |row: &usize| (1..=MOST_TERMS).contains(&terms[*row].len());
        let mut sets = Sets((0..equations).collect());
        let mut first_with: BTreeMap<usize, usize> = BTreeMap::new();
        for row in (0..equations).filter(short) {
            for &(variable, _) in &terms[row] {
                let first = *first_with.entry(variable).or_insert(row);
                sets.join(first, row);
            }
        }
        let mut rows_of: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        (0..equations).filter(short).for_each(|row| rows_of.entry(sets.of(row)).or_default().push(row));
        let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
        let mut blocks = Vec::new();
        for rows in rows_of.into_values().filter(|rows| rows.len() <= MOST_EQUATIONS) {
            let Some((block, determined)) = solved(&rows, &terms, b) else { continue };
            sums.extend(block.determined.iter().copied().zip(determined));
            blocks.push(block);
        }
        let mut gone = vec![false; a.rows];
        blocks.iter().flat_map(|block: &Block| &block.rows).for_each(|&row| gone[row] = true);
        let mut index = vec![0; a.cols];
        let mut free = 0;
        for (variable, index) in index.iter_mut().enumerate() {
            *index = free;
            free += usize::from(!sums.contains_key(&variable));
        }
        let variable = |v: usize| match sums.remove(&v) {
            Some((terms, constant)) => {
                Variable::Sum((terms.into_iter().map(|(v, w)| (index[v], w)).collect(), constant))
            }
            None => Variable::Free(index[v]),
        };
        let variables = (0..a.cols).map(variable).collect();
        let kept = (0..a.rows).filter(|&row| !gone[row]).collect();
        Elimination { variables, free, blocks, kept }
    }

    /// A variable as a sum of free ones, without its constant.
    fn terms<'s>(&'s self, variable: usize, alone: &'s mut [(usize, f64); 1]) -> &'s [(usize, f64)] {
        match &self.variables[variable] {
            Variable::Free(index) => {
                *alone = [(*index, 1.0)];
                alone
            }
            Variable::Sum((terms, _)) => terms,
        }
    }

    /// The number of free variables.
    pub fn free(&self) -> usize {
        self.free
    }

    /// The variables of the program at these values of the free ones.
    pub fn variables(&self, free: &[f64]) -> Vec<f64> {
        let value = |variable: &Variable| match variable {
            Variable::Free(index) => free[*index],
            Variable::Sum((terms, constant)) => terms.iter().map(|&(i, w)| w * free[i]).sum::<f64>() + constant,
        };
        self.variables.iter().map(value).collect()
    }

    /// A gradient with respect to the program's variables, with respect to the free ones.
    pub fn gradient(&self, gradient: &[f64]) -> Vec<f64> {
        let mut reduced = vec![0.0; self.free];
        for (variable, g) in gradient.iter().enumerate() {
            self.terms(variable, &mut Default::default()).iter().for_each(|&(i, w)| reduced[i] += w * g);
        }
        reduced
    }

    /// The rows that stay, in the free variables.
    pub fn matrix(&self, a: &Sparse) -> Sparse {
        let mut place = vec![None; a.rows];
        self.kept.iter().enumerate().for_each(|(new, &row)| place[row] = Some(new));
        let mut entries = Vec::with_capacity(a.nzval.len());
        for c in 0..a.cols {
            let mut alone = Default::default();
            let terms = self.terms(c, &mut alone);
            for i in a.colptr[c]..a.colptr[c + 1] {
                if let Some(row) = place[a.rowval[i]] {
                    entries.extend(terms.iter().map(|&(v, w)| (row, v, w * a.nzval[i])));
                }
            }
        }
        Sparse::from_entries(self.kept.len(), self.free, &entries)
    }

    /// The upper triangle of the quadratic term in the free variables, from that of the program.
    pub fn hessian(&self, p: &Sparse) -> Sparse {
        let mut entries = Vec::with_capacity(p.nzval.len());
        for c in 0..p.cols {
            for i in p.colptr[c]..p.colptr[c + 1] {
                let (r, value) = (p.rowval[i], p.nzval[i]);
                let (mut one, mut other) = Default::default();
                let (rows, columns) = (self.terms(r, &mut one), self.terms(c, &mut other));
                for &(a, wa) in rows {
                    for &(b, wb) in columns {
                        // An entry beside the diagonal stands for two.
                        match (r == c, a == b) {
                            (true, _) if a > b => {}
                            (false, true) => entries.push((a, a, 2.0 * value * wa * wb)),
                            _ => entries.push((a.min(b), a.max(b), value * wa * wb)),
                        }
                    }
                }
            }
        }
        Sparse::from_entries(self.free, self.free, &entries)
    }

    /// The multipliers of all rows, from those of the rows that stay, `P x + q` at the solution and the program: those
    /// of eliminated equations make the Lagrangian stationary in the variables that they determine.
    pub fn multipliers(&self, kept: &[f64], gradient: &[f64], program: &QuadraticProgram) -> Vec<f64> {
        let mut z = vec![0.0; program.b.len()];
        self.kept.iter().zip(kept).for_each(|(&row, value)| z[row] = *value);
        let of_rows = program.a.transposed_times(&z);
        for Block { rows, determined, inverse } in &self.blocks {
            let rest = DVector::from_iterator(determined.len(), determined.iter().map(|&v| -gradient[v] - of_rows[v]));
            let solved = inverse.transpose() * rest;
            rows.iter().zip(solved.iter()).for_each(|(&row, value)| z[row] = *value);
        }
        z
    }
}

/// The equations of a block solved for as many of its variables: each as a sum of the others, by index with their
/// weights, and a constant. `None` if the equations depend on each other.
fn solved(rows: &[usize], terms: &[Vec<(usize, f64)>], b: &[f64]) -> Option<(Block, Vec<Sum>)> {
    let mut names: Vec<usize> = rows.iter().flat_map(|&row| terms[row].iter().map(|term| term.0)).collect();
    names.sort_unstable();
    names.dedup();
    if names.len() < rows.len() {
        return None;
    }
    // Each equation divided by its largest coefficient, so that pivots compare.
    let largest = |row: usize| terms[row].iter().fold(0.0_f64, |most, term| most.max(term.1.abs()));
    let mut matrix = DMatrix::<f64>::zeros(rows.len(), names.len());
    for (i, &row) in rows.iter().enumerate() {
        for &(variable, value) in &terms[row] {
            matrix[(i, names.binary_search(&variable).ok()?)] += value / largest(row);
        }
    }
    let mut order: Vec<usize> = (0..names.len()).collect();
    let mut left = matrix.clone();
    for step in 0..rows.len() {
        let (mut best, mut at) = (0.0, (step, step));
        for i in step..rows.len() {
            for j in step..names.len() {
                if left[(i, j)].abs() > best {
                    (best, at) = (left[(i, j)].abs(), (i, j));
                }
            }
        }
        if best < LEAST_PIVOT {
            return None;
        }
        left.swap_rows(step, at.0);
        left.swap_columns(step, at.1);
        order.swap(step, at.1);
        for i in step + 1..rows.len() {
            let factor = left[(i, step)] / left[(step, step)];
            for j in step..names.len() {
                left[(i, j)] -= factor * left[(step, j)];
            }
        }
    }
    let (pivots, others) = order.split_at(rows.len());
    let square = DMatrix::from_fn(rows.len(), rows.len(), |i, j| matrix[(i, pivots[j])]);
    let mut inverse = square.try_inverse()?;
    let rest = DMatrix::from_fn(rows.len(), others.len(), |i, j| matrix[(i, others[j])]);
    let weights = -(&inverse * rest);
    for (i, &row) in rows.iter().enumerate() {
        inverse.column_mut(i).scale_mut(1.0 / largest(row));
    }
    let constants = &inverse * DVector::from_iterator(rows.len(), rows.iter().map(|&row| b[row]));
    let sum = |k: usize| {
        let terms = others.iter().enumerate().map(|(j, &other)| (names[other], weights[(k, j)]));
        (terms.filter(|term| term.1 != 0.0).collect(), constants[k])
    };
    let determined = pivots.iter().map(|&pivot| names[pivot]).collect();
    let sums = (0..rows.len()).map(sum).collect();
    Some((Block { rows: rows.to_vec(), determined, inverse }, sums))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::qp::RowOrigin;
    use crate::qp::build::{Affine, Builder};

    /// Least (x0 - 1)^2 + (x1 - 2)^2 + (x2 - 3)^2 + x0 x1 with x0 + 2 x1 = 1, 3 x1 - x2 = 2 and x2 <= 9.
    fn program() -> QuadraticProgram {
        let mut builder = Builder::new(3);
        let origin = RowOrigin::Violation;
        builder.zero(Affine::term(0, 1.0).plus(1, 2.0).plus_constant(-1.0), origin);
        builder.zero(Affine::term(1, 3.0).plus(2, -1.0).plus_constant(-2.0), origin);
        builder.nonnegative(Affine::term(2, -1.0).plus_constant(9.0), origin);
        for i in 0..3 {
            builder.product(i, i, 1.0);
            builder.linear(i, -2.0 * (i + 1) as f64);
        }
        builder.product(0, 1, 1.0);
        builder.finish()
    }

    #[test]
    fn eliminated_programs_have_the_same_values() {
        let program = program();
        let elimination = Elimination::of(&program.a, &program.b, 2);
        assert_eq!((elimination.free, elimination.kept.as_slice()), (1, &[2][..]));
        let constants = elimination.variables(&[0.0]);
        let p = elimination.hessian(&program.p);
        let q = elimination.gradient(&program.gradient(&constants));
        let a = elimination.matrix(&program.a);
        for t in [-2.0, 0.0, 0.7, 5.0] {
            let x = elimination.variables(&[t]);
            assert!(program.slack(&x)[..2].iter().all(|s| s.abs() < 1e-12));
            let value = program.objective(&constants) + q[0] * t + 0.5 * p.nzval[0] * t * t;
            assert!((program.objective(&x) - value).abs() < 1e-12);
            let slack = program.slack(&constants)[2] - a.nzval[0] * t;
            assert!((program.slack(&x)[2] - slack).abs() < 1e-12);
        }
        // At the least value of the objective the multipliers make the Lagrangian stationary.
        let x = elimination.variables(&[-q[0] / p.nzval[0]]);
        let gradient = program.gradient(&x);
        let z = elimination.multipliers(&[0.0], &gradient, &program);
        let of_rows = program.a.transposed_times(&z);
        assert!(gradient.iter().zip(of_rows).all(|(g, r)| (g + r).abs() < 1e-12));
    }

    /// Equations that depend on each other stay.
    #[test]
    fn dependent_equations_stay() {
        let a = Sparse::from_entries(2, 2, &[(0, 0, 1.0), (0, 1, 2.0), (1, 0, 2.0), (1, 1, 4.0)]);
        let elimination = Elimination::of(&a, &[1.0, 2.0], 2);
        assert_eq!((elimination.free, elimination.kept.len()), (2, 2));
    }
}
