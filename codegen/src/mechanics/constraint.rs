//! Differentiation of constraints, as needed for accelerations.
//!
//! ```text
//! g(q, t) = 0              g' = G q' + g_t     G = dg/dq
//! a(q, t) q' + b(q, t) = 0 g' = a q' + b       G = a
//! G q'' = gamma            gamma = -(dg'/dq q' + dg'/dt)
//! M q'' = f + G^T lambda   lambda acts towards growing g
//! ```
//!
//! The derivative by q is along the motion that q' is the rate of: for the rates of an orientation, by
//! a small rotation.
//!
//! A constraint that holds in some modes only has a factor s, 1 while it holds and else 0:
//! s G q'' + (1 - s) lambda = s gamma, M q'' = f + s G^T lambda.

use crate::mechanics::lagrange::{EquationsOfMotion, along_velocity};
use crate::scene::system::LagrangianSystem;
use machinist_algebra::cas::{Cas, Form};
use machinist_algebra::expr::rank::null_columns;
use machinist_algebra::expr::{ConstraintId, CoordinateId, Expr, Matrix, Symbol};
use machinist_algebra::unless_faulty;

/// The constraints of a system in terms of positions, velocities and accelerations; m rows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Constraints {
    /// g; 0 for a constraint on velocities.
    pub values: Vec<Expr>,
    /// g'.
    pub rates: Vec<Expr>,
    /// G, m by n.
    pub matrix: Vec<Vec<Expr>>,
    /// gamma.
    pub accelerations: Vec<Expr>,
    /// s; 1 for a constraint that always holds.
    pub holds: Vec<Expr>,
}

impl Constraints {
    /// Differentiates the constraints of a system.
    pub fn derive(cas: &mut Cas, system: &LagrangianSystem) -> Self {
        let ids: Vec<CoordinateId> =
            (0..system.coordinates.len() as u32).map(CoordinateId).collect();
        let mut constraints = Constraints::default();
        for constraint in &system.constraints {
            let form = cas.form(&constraint.expr);
            let (value, rate, row) = if constraint.is_of_positions {
                let row = by_positions(cas, system, &form);
                let rate = along(cas, &form, &row, &ids);
                (cas.expr(&form), rate, row)
            } else {
                let by = ids.iter().map(|id| cas.derivative(&form, Symbol::Velocity(*id)));
                let row = by.collect::<Vec<_>>();
                (Expr::integer(0), form, row)
            };
            let slopes = by_positions(cas, system, &rate);
            let bend = along(cas, &rate, &slopes, &ids);
            let gamma = unless_faulty!("gamma", -&bend, bend);
            constraints.values.push(value);
            constraints.rates.push(cas.simplify(&rate));
            let line = unless_faulty!("an entry of G", row, [&[-&row[0]], &row[1..]].concat());
            constraints.matrix.push(line.iter().map(|entry| cas.simplify(entry)).collect());
            constraints.accelerations.push(cas.simplify(&gamma));
            let holds = cas.form(&constraint.holds());
            constraints.holds.push(cas.expr(&holds));
        }
        constraints
    }

    /// Returns the number of constraints.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rates.len()
    }

    /// Reports whether there are no constraints.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rates.is_empty()
    }

    /// Returns the power that each moving constraint supplies, -lambda g' at q' = 0.
    #[must_use]
    pub fn supplied_power(&self) -> Vec<Expr> {
        let at_rest = |rate: &Expr| {
            rate.replace(&|symbol| matches!(symbol, Symbol::Velocity(_)).then(|| Expr::integer(0)))
        };
        let ids = (0..).map(ConstraintId);
        let powers = ids.zip(&self.rates).map(|(id, rate)| {
            let multiplier = Expr::Symbol(Symbol::Multiplier(id));
            Expr::Product(vec![Expr::integer(-1), multiplier, at_rest(rate)])
        });
        powers.collect()
    }

    /// Iterates over the coordinates whose rates a constraint depends on.
    pub fn coordinates(&self, constraint: usize) -> impl Iterator<Item = usize> {
        let row = self.matrix[constraint].iter().enumerate();
        row.filter(|(_, entry)| !entry.is_zero()).map(|(column, _)| column)
    }

    /// Iterates over all expressions of a constraint.
    pub fn of(&self, constraint: usize) -> impl Iterator<Item = &Expr> {
        let others = [&self.values, &self.rates, &self.accelerations, &self.holds];
        let others = others.map(|exprs| &exprs[constraint]);
        self.matrix[constraint].iter().chain(others)
    }

    /// Iterates over all expressions.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        let matrix = self.matrix.iter().flatten();
        let all = self.values.iter().chain(&self.rates).chain(matrix);
        all.chain(&self.accelerations).chain(&self.holds)
    }

    /// Iterates over the same, mutably.
    pub fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let matrix = self.matrix.iter_mut().flatten();
        let all = self.values.iter_mut().chain(&mut self.rates).chain(matrix);
        all.chain(&mut self.accelerations).chain(&mut self.holds)
    }

    /// Returns an expression of a constraint, multiplied by 0 while it does not hold.
    #[must_use]
    pub fn held(&self, constraint: usize, expr: &Expr) -> Expr {
        let holds = &self.holds[constraint];
        if *holds == Expr::integer(1) || expr.is_zero() {
            return expr.clone();
        }
        Expr::Product(vec![holds.clone(), expr.clone()])
    }

    /// Returns s - 1, the diagonal entry of the bordered matrix.
    fn diagonal(&self, constraint: usize) -> Expr {
        let holds = &self.holds[constraint];
        if *holds == Expr::integer(1) {
            return Expr::integer(0);
        }
        Expr::Sum(vec![holds.clone(), Expr::integer(-1)])
    }
}

/// Returns the derivatives of an expression along the motion of each velocity.
fn by_positions(cas: &mut Cas, system: &LagrangianSystem, form: &Form) -> Vec<Form> {
    let ids = (0..system.coordinates.len() as u32).map(CoordinateId);
    let slope = |cas: &mut Cas, id| cas.derivative(form, Symbol::Coordinate(id));
    ids.map(|id| along_velocity(cas, &system.orientations, id, &slope)).collect()
}

/// Returns dx/dt of an expression that does not depend on velocities, or its part without
/// accelerations.
fn along(cas: &mut Cas, form: &Form, slopes: &[Form], ids: &[CoordinateId]) -> Form {
    let rate = cas.derivative(form, Symbol::Time);
    let mut rate = unless_faulty!("dg/dt", rate, -&rate);
    for (slope, id) in slopes.iter().zip(ids) {
        let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(*id)));
        rate = &rate + &(slope * &velocity);
    }
    rate
}

impl EquationsOfMotion {
    /// Returns the linear equations of \[q'', -lambda\],
    ///
    /// ```text
    /// | M  G^T | | q''     |   | f     |
    /// | G   0  | | -lambda | = | gamma |
    /// ```
    ///
    /// as a symmetric matrix and the right side. With M positive definite and G of full rank the
    /// matrix has an L D L^T without pivoting, in this order. M may be singular if constraints
    /// hold parts without inertia. For a constraint that holds in some modes only, the row is s
    /// G, s - 1 on the diagonal, and s gamma.
    #[must_use]
    pub fn bordered(&self) -> (Matrix, Vec<Expr>) {
        let constraints = &self.constraints;
        let held = |(index, line): (usize, &Vec<Expr>)| -> Vec<Expr> {
            line.iter().map(|entry| constraints.held(index, entry)).collect()
        };
        let border: Vec<Vec<Expr>> = constraints.matrix.iter().enumerate().map(held).collect();
        let mut matrix = self.mass_matrix.clone();
        let n = matrix.len();
        for column in 0..n {
            let beside = border.iter().map(|line| line[column].clone());
            matrix.extend_row(column, (n..).zip(beside));
        }
        for (index, line) in border.into_iter().enumerate() {
            let corner = (n + index, constraints.diagonal(index));
            matrix.push(line.into_iter().enumerate().chain([corner]));
        }
        let accelerations = constraints.accelerations.iter().enumerate();
        let accelerations = accelerations.map(|(index, gamma)| constraints.held(index, gamma));
        let right_side = self.forcing.iter().cloned().chain(accelerations).collect();
        (matrix, right_side)
    }

    /// Returns the equations for partial derivatives at fixed q'', if they differ.
    #[must_use]
    pub fn at_given_accelerations(&self) -> Option<Self> {
        let (mass_matrix, forcing) = self.at_accelerations.clone()?;
        Some(EquationsOfMotion { mass_matrix, forcing, ..self.clone() })
    }

    /// Reports whether M alone is singular, so that constraints have to compensate: some motion
    /// of all coordinates has no kinetic energy for any parameter values, except those that the
    /// spec sets to zero.
    #[must_use]
    pub fn is_singular(&self) -> bool {
        !self.constraints.is_empty() && null_columns(&self.given(&self.mass_matrix)).is_some()
    }

    /// Returns the entries without the parameters that the spec sets to zero.
    fn given(&self, matrix: &Matrix) -> Matrix {
        let mut given = matrix.clone();
        given.exprs_mut().for_each(|entry| *entry = self.system.given(entry));
        given
    }

    /// Returns coordinates that can move together although neither an inertia nor a constraint
    /// that always holds determines their motion. `None` if the motion is determined.
    #[must_use]
    pub fn undecided(&self) -> Option<Vec<usize>> {
        // The mass matrix of bodies may be singular without constraints too; the energies in the
        // spec have been checked before.
        let bodies_are_singular = || {
            !self.system.mechanisms.is_empty()
                && null_columns(&self.given(&self.mass_matrix)).is_some()
        };
        if !self.is_singular() && !bodies_are_singular() {
            return None;
        }
        let always = |row: &usize| self.constraints.holds[*row] == Expr::integer(1);
        let (bordered, _) = self.bordered();
        let n = self.mass_matrix.len();
        let rows: Vec<usize> =
            (0..n).chain((0..self.constraints.len()).filter(always).map(|row| n + row)).collect();
        let place = |row: usize| rows.binary_search(&row).ok();
        let mut part = Matrix::default();
        for row in &rows {
            let entries = bordered.row(*row).iter();
            part.push(entries.filter_map(|(column, entry)| Some((place(*column)?, entry.clone()))));
        }
        let columns: Vec<usize> =
            null_columns(&self.given(&part))?.into_iter().filter(|column| *column < n).collect();
        // Redundant constraints are reported for the start of a run.
        (!columns.is_empty()).then_some(columns)
    }
}
