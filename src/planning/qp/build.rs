//! A builder of programs, which takes rows in any order and sorts them by cone.

use super::{Cone, QuadraticProgram, RowOrigin, Sparse};

/// The affine expression `sum of coefficient x_variable + constant`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Affine {
    /// (variable, coefficient). A variable may occur more than once.
    pub terms: Vec<(usize, f64)>,
    /// The constant term.
    pub constant: f64,
}

impl Affine {
    /// An expression without variables.
    pub fn constant(constant: f64) -> Self {
        Affine { terms: Vec::new(), constant }
    }

    /// `coefficient x_variable`.
    pub fn term(variable: usize, coefficient: f64) -> Self {
        Affine { terms: vec![(variable, coefficient)], constant: 0.0 }
    }

    /// The expression plus `coefficient x_variable`.
    pub fn plus(mut self, variable: usize, coefficient: f64) -> Self {
        self.terms.push((variable, coefficient));
        self
    }

    /// The expression plus a constant.
    pub fn plus_constant(mut self, constant: f64) -> Self {
        self.constant += constant;
        self
    }

    /// Adds `factor` times another expression, by appending its terms.
    pub fn add(&mut self, other: &Affine, factor: f64) {
        self.terms.extend(other.terms.iter().map(|&(v, c)| (v, c * factor)));
        self.constant += factor * other.constant;
    }

    /// Adds `factor` times another expression and merges terms of the same variable. For expressions with few variables
    /// only, because it searches them linearly.
    pub(crate) fn gather(&mut self, other: &Affine, factor: f64) {
        for &(variable, coefficient) in &other.terms {
            match self.terms.iter_mut().find(|t| t.0 == variable) {
                Some(term) => term.1 += factor * coefficient,
                None => self.terms.push((variable, factor * coefficient)),
            }
        }
        self.constant += factor * other.constant;
    }

    /// The expression times `factor`.
    pub fn times(mut self, factor: f64) -> Self {
        self.constant *= factor;
        for t in &mut self.terms {
            t.1 *= factor;
        }
        self
    }

    /// The value at x.
    pub fn at(&self, x: &[f64]) -> f64 {
        self.constant + self.terms.iter().map(|&(v, c)| c * x[v]).sum::<f64>()
    }
}

/// A program under construction.
#[derive(Debug, Clone, Default)]
pub struct Builder {
    variables: usize,
    hessian: Vec<(usize, usize, f64)>,
    q: Vec<f64>,
    constant: f64,
    equal: Vec<(Affine, RowOrigin)>,
    nonnegative: Vec<(Affine, RowOrigin)>,
    cones: Vec<(Vec<Affine>, RowOrigin)>,
}

impl Builder {
    /// An empty program with this number of variables.
    pub fn new(variables: usize) -> Self {
        // The objective couples each variable with several dozen others.
        Builder {
            variables,
            hessian: Vec::with_capacity(64 * variables),
            q: vec![0.0; variables],
            ..Builder::default()
        }
    }

    /// Adds the row `expression = 0`.
    pub fn zero(&mut self, expression: Affine, origin: RowOrigin) {
        self.equal.push((expression, origin));
    }

    /// Adds the row `expression >= 0`.
    pub fn nonnegative(&mut self, expression: Affine, origin: RowOrigin) {
        self.nonnegative.push((expression, origin));
    }

    /// The number of rows `expression >= 0` so far, which is the index of the next one among them.
    pub fn inequalities(&self) -> usize {
        self.nonnegative.len()
    }

    /// Adds the second-order cone `expressions[0] >= |(expressions[1], ..)|`.
    pub fn cone(&mut self, expressions: Vec<Affine>, origin: RowOrigin) {
        self.cones.push((expressions, origin));
    }

    /// Adds `coefficient x_variable` to the objective.
    pub fn linear(&mut self, variable: usize, coefficient: f64) {
        self.q[variable] += coefficient;
    }

    /// Adds `coefficient x_i x_j` to the objective.
    pub fn product(&mut self, i: usize, j: usize, coefficient: f64) {
        let value = if i == j { 2.0 * coefficient } else { coefficient };
        self.hessian.push((i.min(j), i.max(j), value));
    }

    /// Adds `factor a b` to the objective.
    pub(crate) fn inner_product(&mut self, a: &Affine, b: &Affine, factor: f64) {
        for &(i, ci) in &a.terms {
            for &(j, cj) in &b.terms {
                // x_i x_j and x_j x_i are added up in one entry of the upper triangle.
                self.product(i, j, factor * ci * cj);
            }
        }
        for (constant, other) in [(a.constant, b), (b.constant, a)] {
            if constant != 0.0 {
                for &(i, c) in &other.terms {
                    self.linear(i, factor * constant * c);
                }
            }
        }
        self.constant += factor * a.constant * b.constant;
    }

    /// Adds `factor` times the sum of the squares of some expressions to the objective. Each pair of variables gives
    /// one entry, however many expressions contain it.
    pub fn squares(&mut self, expressions: &[Affine], factor: f64) {
        let mut variables: Vec<usize> = expressions.iter().flat_map(|e| e.terms.iter().map(|t| t.0)).collect();
        variables.sort_unstable();
        variables.dedup();
        let row = |expression: &Affine| {
            let mut row = vec![0.0; variables.len()];
            for &(variable, coefficient) in &expression.terms {
                if let Ok(place) = variables.binary_search(&variable) {
                    row[place] += coefficient;
                }
            }
            row
        };
        let rows: Vec<Vec<f64>> = expressions.iter().map(row).collect();
        for (i, &u) in variables.iter().enumerate() {
            for (j, &v) in variables.iter().enumerate().skip(i) {
                let sum: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
                if sum != 0.0 {
                    self.product(u, v, if i == j { factor * sum } else { 2.0 * factor * sum });
                }
            }
            let crossed: f64 = rows.iter().zip(expressions).map(|(row, e)| row[i] * e.constant).sum();
            self.linear(u, 2.0 * factor * crossed);
        }
        self.constant += factor * expressions.iter().map(|e| e.constant.powi(2)).sum::<f64>();
    }

    /// The program: equalities first, then inequalities, then second-order cones, each in the order in which they were
    /// added.
    pub fn finish(self) -> QuadraticProgram {
        let grouped_rows: usize = self.cones.iter().map(|c| c.0.len()).sum();
        let rows = self.equal.len() + self.nonnegative.len() + grouped_rows;
        let mut cones = Vec::new();
        if !self.equal.is_empty() {
            cones.push(Cone::Zero(self.equal.len()));
        }
        if !self.nonnegative.is_empty() {
            cones.push(Cone::Nonnegative(self.nonnegative.len()));
        }
        cones.extend(self.cones.iter().map(|c| Cone::SecondOrder(c.0.len())));
        let terms: usize = self.equal.iter().chain(&self.nonnegative).map(|r| r.0.terms.len()).sum();
        let single = self.equal.into_iter().chain(self.nonnegative);
        let grouped = self.cones.into_iter().flat_map(|(rows, origin)| rows.into_iter().map(move |r| (r, origin)));
        let mut entries = Vec::with_capacity(terms);
        let mut b = Vec::with_capacity(rows);
        let mut row_origin = Vec::with_capacity(rows);
        for (row, (expression, origin)) in single.chain(grouped).enumerate() {
            entries.extend(expression.terms.iter().map(|&(v, c)| (row, v, -c)));
            b.push(expression.constant);
            row_origin.push(origin);
        }
        QuadraticProgram {
            p: Sparse::from_entries(self.variables, self.variables, &self.hessian),
            q: self.q,
            constant: self.constant,
            a: Sparse::from_entries(rows, self.variables, &entries),
            b,
            cones,
            row_origin,
        }
    }
}
