//! Interpretation of recurrences, in `f64`.
//!
//! Excluded: sums in lanes, compilation. Coefficients are computed one by one, by the equations of
//! [`Recurrence`] with products in place of quotients (by 1/k, and by the inverse of the divisor at
//! order zero). Results can therefore be compared with those of emitted and compiled code; the
//! latter agree to the last bit.

use super::{Convolution, MassMatrix, Recurrence, TaylorTape};
use crate::evaluate::{Inputs, call, interpolate, operate};
use crate::room::with_room;
use crate::{NodeId, Op};

/// A tape of recurrences to interpret. An evaluation allocates nothing, except for memory that
/// later evaluations of the same thread reuse.
#[derive(Debug, Clone)]
pub struct SeriesEvaluator {
    tape: TaylorTape,
    states: usize,
    /// Nonzeros of the factors of the mass matrix, by rows; below the diagonal and on it.
    filled: Vec<bool>,
}

/// One evaluation.
struct Run<'a> {
    tape: &'a TaylorTape,
    inputs: &'a Inputs<'a>,
    filled: &'a [bool],
    /// Coefficients, one node after another.
    values: &'a mut [f64],
    /// Number of coefficients of each node.
    orders: usize,
    /// L below the diagonal, 1/D on it, by rows.
    factors: &'a mut [f64],
    solution: &'a mut [f64],
}

impl SeriesEvaluator {
    /// Prepares a tape.
    #[must_use]
    pub fn new(tape: TaylorTape) -> Self {
        let states = tape.rate.len();
        let filled = tape.mass_matrix.as_ref().map_or_else(Vec::new, filled);
        Self { tape, states, filled }
    }

    /// Writes normalized coefficients of the solution, order by order, each as long as the state.
    /// The length of `coefficients` determines the highest order.
    ///
    /// # Panics
    /// If `coefficients` is shorter than the state, or if `inputs` lack an entry that the tape
    /// reads.
    pub fn evaluate(&self, inputs: &Inputs<'_>, coefficients: &mut [f64]) {
        let orders = coefficients.len() / self.states.max(1);
        let mass = self.tape.mass_matrix.as_ref();
        let n = mass.map_or(0, |mass| mass.right_side.len());
        let nodes = self.tape.nodes.len();
        with_room(nodes * orders + self.filled.len() + n, |room| {
            let (values, room) = room.split_at_mut(nodes * orders);
            let (factors, solution) = room.split_at_mut(self.filled.len());
            let (tape, filled) = (&self.tape, &self.filled[..]);
            let mut run = Run { tape, inputs, filled, values, orders, factors, solution };
            coefficients[..self.states].copy_from_slice(&inputs.state[..self.states]);
            for order in 0..orders.saturating_sub(1) {
                let (known, next) = coefficients.split_at_mut((order + 1) * self.states);
                run.coefficients(order, &known[order * self.states..]);
                let inverse = 1.0 / (order + 1) as f64;
                for (next, &rate) in next.iter_mut().zip(&tape.rate) {
                    *next = run.at(rate, order) * inverse;
                }
            }
        });
    }
}

impl Run<'_> {
    /// Computes the coefficients of one order, from those of the state.
    fn coefficients(&mut self, order: usize, state: &[f64]) {
        for index in 0..self.tape.nodes.len() {
            let id = NodeId(index as u32);
            self.values[index * self.orders + order] =
                if order == 0 { self.zeroth(id) } else { self.higher(id, order, state) };
        }
        if let Some(mass) = &self.tape.mass_matrix {
            if order == 0 {
                self.factor(mass);
            }
            self.solve(mass, order);
        }
    }

    fn at(&self, id: NodeId, order: usize) -> f64 {
        self.values[id.0 as usize * self.orders + order]
    }

    fn zeroth(&self, id: NodeId) -> f64 {
        let value = |id| self.at(id, 0);
        match self.tape[id].recurrence {
            Recurrence::Constant(op) => operate(op, value, self.inputs),
            Recurrence::Time => self.inputs.time,
            Recurrence::State(entry) => self.inputs.state[entry as usize],
            Recurrence::Neg(a) => -value(a),
            Recurrence::Add(a, b) => value(a) + value(b),
            Recurrence::Sub(a, b) => value(a) - value(b),
            Recurrence::Scaled { series: a, factor: b } | Recurrence::Product(a, b) => {
                value(a) * value(b)
            }
            Recurrence::Quotient(a, b) => value(a) / value(b),
            Recurrence::Root(a) => value(a).sqrt(),
            Recurrence::Integral { function, argument, .. }
            | Recurrence::IntegralOver { function, argument, .. } => {
                call(function, value(argument))
            }
            Recurrence::Power { base, exponent } => value(base).powf(value(exponent)),
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                operate(Op::SelectLess { lhs, rhs, then, otherwise }, value, self.inputs)
            }
            Recurrence::Table { table, order, argument, .. } => {
                interpolate(&self.inputs.tables[table.0 as usize], order, value(argument))
            }
            Recurrence::Tail(..) | Recurrence::Lagged { .. } | Recurrence::Acceleration(_) => 0.0,
        }
    }

    /// Returns the coefficient of order `k`, from 1 on. Coefficients of constants vanish and are
    /// left out of sums.
    fn higher(&self, id: NodeId, k: usize, state: &[f64]) -> f64 {
        let zeroth = |id| self.at(id, 0);
        let newest = |id| self.at(id, k);
        let is_constant = |id| self.tape.is_constant(id);
        let inverse = 1.0 / k as f64;
        match self.tape[id].recurrence {
            Recurrence::Constant(_) | Recurrence::Acceleration(_) => 0.0,
            Recurrence::Time => f64::from(u8::from(k == 1)),
            Recurrence::State(entry) => state[entry as usize],
            Recurrence::Neg(a) => -newest(a),
            Recurrence::Add(a, b) if is_constant(a) => newest(b),
            Recurrence::Add(a, b) | Recurrence::Sub(a, b) if is_constant(b) => newest(a),
            Recurrence::Add(a, b) => newest(a) + newest(b),
            Recurrence::Sub(a, b) if is_constant(a) => -newest(b),
            Recurrence::Sub(a, b) => newest(a) - newest(b),
            Recurrence::Scaled { series, factor } => newest(series) * zeroth(factor),
            Recurrence::Product(a, b) if a == b => {
                self.sum(a, b, k) + newest(a) * (zeroth(a) + zeroth(a))
            }
            Recurrence::Product(a, b) => {
                let (first, last) = (a.min(b), a.max(b));
                self.sum(a, b, k) + newest(first) * zeroth(last) + newest(last) * zeroth(first)
            }
            Recurrence::Tail(a, b) => self.sum(a, b, k),
            Recurrence::Quotient(a, b) => {
                let known = self.sum(b, id, k) + newest(b) * zeroth(id);
                let rest = if is_constant(a) { -known } else { newest(a) - known };
                rest * (1.0 / zeroth(b))
            }
            Recurrence::Root(a) => {
                let twice = zeroth(id) + zeroth(id);
                (newest(a) - self.sum(id, id, k)) * (1.0 / twice)
            }
            Recurrence::Integral { argument, integrand, minus, .. } => {
                let sum = inverse * self.weighted_sum(argument, integrand, k);
                signed(minus, sum + newest(argument) * zeroth(integrand))
            }
            Recurrence::IntegralOver { argument, divisor, minus, .. } => {
                let sum = inverse * self.weighted_sum(id, divisor, k);
                (signed(minus, newest(argument)) - sum) * (1.0 / zeroth(divisor))
            }
            Recurrence::Power { base, exponent } => {
                let c = zeroth(exponent);
                let sums = c * self.weighted_sum(base, id, k) - self.weighted_sum(id, base, k);
                let all = inverse * sums + newest(base) * (c * zeroth(id));
                all * (1.0 / zeroth(base))
            }
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                newest(if zeroth(lhs) < zeroth(rhs) { then } else { otherwise })
            }
            Recurrence::Table { table, order, argument, square, cube } => {
                let table = &self.inputs.tables[table.0 as usize];
                let derivative = |more| interpolate(table, order + more, zeroth(argument));
                derivative(1) * newest(argument)
                    + derivative(2) / 2.0 * newest(square)
                    + derivative(3) / 6.0 * newest(cube)
            }
            Recurrence::Lagged { entry, acceleration } => {
                self.sum(entry, acceleration, k) + newest(entry) * zeroth(acceleration)
            }
        }
    }

    fn sum(&self, left: NodeId, right: NodeId, order: usize) -> f64 {
        self.convolve(Convolution { left, weighted: false, right }, order)
    }

    fn weighted_sum(&self, left: NodeId, right: NodeId, order: usize) -> f64 {
        self.convolve(Convolution { left, weighted: true, right }, order)
    }

    /// Adds the sum over even orders, that over odd ones, and the products with coefficients of the
    /// previous order. The latter come last, as where sums are formed in lanes.
    fn convolve(&self, Convolution { left, weighted, right }: Convolution, order: usize) -> f64 {
        let weight = |j: usize| if weighted { j as f64 } else { 1.0 };
        let product = |j: usize| weight(j) * self.at(left, j) * self.at(right, order - j);
        if order < 2 {
            return 0.0;
        }
        if self.tape.is_line(left) {
            return product(1);
        }
        if self.tape.is_line(right) || order == 2 {
            return product(order - 1);
        }
        let mut sums = [0.0; 2];
        for j in 2..order - 1 {
            sums[j % 2] += product(j);
        }
        (sums[0] + sums[1]) + (product(1) + product(order - 1))
    }

    /// Writes the accelerations of one order.
    fn solve(&mut self, mass: &MassMatrix, order: usize) {
        let n = mass.right_side.len();
        for row in 0..n {
            self.solution[row] = self.at(mass.right_side[row], order);
            for column in (0..row).filter(|column| self.filled[row * n + column]) {
                self.solution[row] -= self.factors[row * n + column] * self.solution[column];
            }
        }
        for row in (0..n).rev() {
            self.solution[row] *= self.factors[row * n + row];
            for below in (row + 1..n).filter(|below| self.filled[below * n + row]) {
                self.solution[row] -= self.factors[below * n + row] * self.solution[below];
            }
        }
        for (id, value) in mass.accelerations.iter().zip(&*self.solution) {
            self.values[id.0 as usize * self.orders + order] = *value;
        }
    }

    fn factor(&mut self, mass: &MassMatrix) {
        let n = mass.right_side.len();
        self.factors.fill(0.0);
        for &(row, column, entry) in &mass.lower {
            self.factors[row as usize * n + column as usize] = self.at(entry, 0);
        }
        let is_filled = |row: usize, column: usize| self.filled[row * n + column];
        for column in 0..n {
            let inverse = 1.0 / self.factors[column * n + column];
            for row in (column + 1..n).filter(|row| is_filled(*row, column)) {
                let scaled = self.factors[row * n + column] * inverse;
                for other in (column + 1..=row).filter(|other| is_filled(*other, column)) {
                    self.factors[row * n + other] -= scaled * self.factors[other * n + column];
                }
            }
            for row in column + 1..n {
                self.factors[row * n + column] *= inverse;
            }
            self.factors[column * n + column] = inverse;
        }
    }
}

/// Returns the nonzeros of the factors of a mass matrix, including fill-in.
fn filled(mass: &MassMatrix) -> Vec<bool> {
    let n = mass.right_side.len();
    let mut filled = vec![false; n * n];
    for &(row, column, _) in &mass.lower {
        filled[row as usize * n + column as usize] = true;
    }
    for column in 0..n {
        for row in column + 1..n {
            for other in column + 1..=row {
                let meets = filled[row * n + column] && filled[other * n + column];
                filled[row * n + other] |= meets;
            }
        }
    }
    filled
}

fn signed(minus: bool, value: f64) -> f64 {
    if minus { -value } else { value }
}
