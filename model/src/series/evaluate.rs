//! Recurrences run as they are, in `f64`.
//!
//! Excluded: side-by-side sums, compilation. Sums are formed one by one and none
//! is left out for a factor that is linear in time, so that this is a check on
//! emitted code as well.

use super::{Convolution, MassMatrix, Recurrence, TaylorTape};
use crate::evaluate::{Inputs, call, interpolate, operate};
use crate::{NodeId, Op};

/// A tape of recurrences with room for its coefficients: evaluating it allocates
/// nothing, unless an order is asked for that is higher than any before.
#[derive(Debug, Clone)]
pub struct SeriesEvaluator {
    tape: TaylorTape,
    states: usize,
    /// Coefficients, one node after another.
    values: Vec<f64>,
    /// Coefficients a node has room for.
    room: usize,
    /// L below the diagonal, 1/D on it, by rows.
    factors: Vec<f64>,
    solution: Vec<f64>,
}

impl SeriesEvaluator {
    /// Prepares a tape.
    #[must_use]
    pub fn new(tape: TaylorTape) -> Self {
        let states = tape.rate.len();
        let n = tape.mass_matrix.as_ref().map_or(0, |mass| mass.right_side.len());
        let (factors, solution) = (vec![0.0; n * n], vec![0.0; n]);
        Self { tape, states, values: vec![], room: 0, factors, solution }
    }

    /// Writes normalized coefficients of the solution, order after order, each
    /// as long as the state; the highest order is what there is room for.
    ///
    /// # Panics
    /// If `coefficients` has no room for the state, or if `inputs` lack an entry that the
    /// tape reads.
    pub fn evaluate(&mut self, inputs: &Inputs<'_>, coefficients: &mut [f64]) {
        let orders = coefficients.len() / self.states.max(1);
        self.make_room(orders);
        coefficients[..self.states].copy_from_slice(&inputs.state[..self.states]);
        for order in 0..orders.saturating_sub(1) {
            for index in 0..self.tape.nodes.len() {
                let id = NodeId(index as u32);
                self.values[index * self.room + order] = if order == 0 {
                    self.zeroth(id, inputs)
                } else {
                    self.higher(id, order, inputs, coefficients)
                };
            }
            self.solve(order);
            let (known, next) = coefficients.split_at_mut((order + 1) * self.states);
            debug_assert!(!known.is_empty());
            for (next, &rate) in next.iter_mut().zip(&self.tape.rate) {
                *next = self.at(rate, order) / (order + 1) as f64;
            }
        }
    }

    fn make_room(&mut self, orders: usize) {
        if orders > self.room {
            self.room = orders;
            self.values = vec![0.0; self.tape.nodes.len() * orders];
        }
    }

    fn at(&self, id: NodeId, order: usize) -> f64 {
        self.values[id.0 as usize * self.room + order]
    }

    fn zeroth(&self, id: NodeId, inputs: &Inputs<'_>) -> f64 {
        let value = |id| self.at(id, 0);
        match self.tape[id].recurrence {
            Recurrence::Constant(op) => operate(op, value, inputs),
            Recurrence::Time => inputs.time,
            Recurrence::State(entry) => inputs.state[entry as usize],
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
                operate(Op::SelectLess { lhs, rhs, then, otherwise }, value, inputs)
            }
            Recurrence::Table { table, order, argument, .. } => {
                interpolate(&inputs.tables[table.0 as usize], order, value(argument))
            }
            Recurrence::Tail(..) | Recurrence::Lagged { .. } | Recurrence::Acceleration(_) => 0.0,
        }
    }

    /// The coefficient of order `k`, from 1 on.
    fn higher(&self, id: NodeId, k: usize, inputs: &Inputs<'_>, coefficients: &[f64]) -> f64 {
        let zeroth = |id| self.at(id, 0);
        let newest = |id| self.at(id, k);
        let inverse = 1.0 / k as f64;
        match self.tape[id].recurrence {
            Recurrence::Constant(_) | Recurrence::Acceleration(_) => 0.0,
            Recurrence::Time => f64::from(u8::from(k == 1)),
            Recurrence::State(entry) => coefficients[k * self.states + entry as usize],
            Recurrence::Neg(a) => -newest(a),
            Recurrence::Add(a, b) => newest(a) + newest(b),
            Recurrence::Sub(a, b) => newest(a) - newest(b),
            Recurrence::Scaled { series, factor } => newest(series) * zeroth(factor),
            Recurrence::Product(a, b) => {
                zeroth(a) * newest(b) + newest(a) * zeroth(b) + self.sum(a, b, k)
            }
            Recurrence::Tail(a, b) => self.sum(a, b, k),
            Recurrence::Quotient(a, b) => {
                (newest(a) - newest(b) * zeroth(id) - self.sum(b, id, k)) / zeroth(b)
            }
            Recurrence::Root(a) => (newest(a) - self.sum(id, id, k)) / (2.0 * zeroth(id)),
            Recurrence::Integral { argument, integrand, minus, .. } => {
                let sum = self.weighted_sum(argument, integrand, k);
                signed(minus, newest(argument) * zeroth(integrand) + inverse * sum)
            }
            Recurrence::IntegralOver { argument, divisor, minus, .. } => {
                let sum = self.weighted_sum(id, divisor, k);
                (signed(minus, newest(argument)) - inverse * sum) / zeroth(divisor)
            }
            Recurrence::Power { base, exponent } => {
                let c = zeroth(exponent);
                let sums = c * self.weighted_sum(base, id, k) - self.weighted_sum(id, base, k);
                (c * newest(base) * zeroth(id) + inverse * sums) / zeroth(base)
            }
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                newest(if zeroth(lhs) < zeroth(rhs) { then } else { otherwise })
            }
            Recurrence::Table { table, order, argument, square, cube } => {
                let derivative = |more| {
                    interpolate(&inputs.tables[table.0 as usize], order + more, zeroth(argument))
                };
                derivative(1) * newest(argument)
                    + derivative(2) / 2.0 * newest(square)
                    + derivative(3) / 6.0 * newest(cube)
            }
            Recurrence::Lagged { entry, acceleration } => {
                newest(entry) * zeroth(acceleration) + self.sum(entry, acceleration, k)
            }
        }
    }

    fn sum(&self, left: NodeId, right: NodeId, order: usize) -> f64 {
        self.convolve(Convolution { left, weighted: false, right }, order)
    }

    fn weighted_sum(&self, left: NodeId, right: NodeId, order: usize) -> f64 {
        self.convolve(Convolution { left, weighted: true, right }, order)
    }

    fn convolve(&self, Convolution { left, weighted, right }: Convolution, order: usize) -> f64 {
        let weight = |j: usize| if weighted { j as f64 } else { 1.0 };
        (1..order).map(|j| weight(j) * self.at(left, j) * self.at(right, order - j)).sum()
    }

    /// Puts the accelerations of one order in their place.
    fn solve(&mut self, order: usize) {
        let Some(mass) = self.tape.mass_matrix.take() else { return };
        if order == 0 {
            self.factor(&mass);
        }
        let n = mass.right_side.len();
        for row in 0..n {
            let known = (0..row).map(|j| self.factors[row * n + j] * self.solution[j]);
            let known: f64 = known.sum();
            self.solution[row] = self.at(mass.right_side[row], order) - known;
        }
        for row in (0..n).rev() {
            let known = (row + 1..n).map(|j| self.factors[j * n + row] * self.solution[j]);
            let known: f64 = known.sum();
            self.solution[row] = self.solution[row] * self.factors[row * n + row] - known;
        }
        for (id, value) in mass.accelerations.iter().zip(&self.solution) {
            self.values[id.0 as usize * self.room + order] = *value;
        }
        self.tape.mass_matrix = Some(mass);
    }

    fn factor(&mut self, mass: &MassMatrix) {
        let n = mass.right_side.len();
        self.factors.fill(0.0);
        for &(row, column, entry) in &mass.lower {
            self.factors[row as usize * n + column as usize] = self.at(entry, 0);
        }
        for column in 0..n {
            let inverse = 1.0 / self.factors[column * n + column];
            for row in column + 1..n {
                let scaled = self.factors[row * n + column] * inverse;
                for other in column + 1..=row {
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

fn signed(minus: bool, value: f64) -> f64 {
    if minus { -value } else { value }
}
