//! Lowering of recurrences to two straight-line programs.

use std::collections::HashMap;

use super::Sums;
use super::factors::Factors;
use crate::NodeId;
use crate::series::{Convolution, MassMatrix, Recurrence, TaylorTape};
use crate::straight::{Middles, Region, Step, StepId, Straight};

/// Recurrences as programs.
pub struct Lowered {
    /// Zeroth coefficients and values derived from them, then the first coefficients of the state.
    pub zeroth: Straight,
    /// Coefficients of an order, computed from its numbers, zeroth coefficients and sums. Results
    /// are the left and right factors of sums, then the next coefficients of the state.
    pub higher: Straight,
    /// Number of results of the first program.
    pub constants: usize,
    /// Sums that the second program reads.
    pub sums: Sums,
}

/// Region of the row of order one.
const FIRST: Region = Region::Parameters;

/// Region of the row of the previous order, which ends with the coefficients of the state.
const LAST: Region = Region::State;

/// Numbers of an order that the program reads.
#[derive(Debug, Clone, Copy)]
enum Number {
    /// 1/k.
    Inverse,
    /// k.
    Order,
    /// 1/(k + 1).
    NextInverse,
    /// The k-th coefficient of time.
    Time,
}

/// Orders that a program computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Orders {
    /// The first two: sums are read as they are.
    First,
    /// From the third on: products with the first and the newest factors are added to the sums.
    Later,
}

/// A factor of a sum: its node, and whether it is multiplied by its order.
type Factor = (NodeId, bool);

struct Lowering<'a> {
    tape: &'a TaylorTape,
    orders: Orders,
    zeroth: Straight,
    higher: Straight,
    /// Zeroth coefficients of nodes.
    values: Vec<StepId>,
    /// Coefficients of the current order; `None` for constants.
    newest: Vec<Option<StepId>>,
    /// Values derived from zeroth coefficients that higher orders read, with their places.
    kept: HashMap<StepId, u32>,
    /// Sums of products, then products with series linear in time.
    products: Vec<(Factor, Factor)>,
    lines: Vec<(Factor, Factor)>,
}

impl Lowered {
    /// Lowers a tape. Returns `None` if the programs would be too long.
    pub fn new(tape: &TaylorTape, orders: Orders, tables: usize) -> Option<Self> {
        let mut lowering = Lowering {
            tape,
            orders,
            zeroth: Straight::default(),
            higher: Straight::default(),
            values: vec![],
            newest: vec![],
            kept: HashMap::new(),
            products: vec![],
            lines: vec![],
        };
        lowering.find_sums();
        lowering.zeroth_coefficients(tables)?;
        let factors = match &tape.mass_matrix {
            Some(mass) => Some(Factors::new(&mut lowering.zeroth, mass, &lowering.values)?),
            None => None,
        };
        if let (Some(mass), Some(factors)) = (&tape.mass_matrix, &factors) {
            let right = mass.right_side.iter().map(|id| lowering.values[id.0 as usize]);
            let solution = factors.solve(&mut lowering.zeroth, right.collect(), |_, id| id);
            for (id, value) in mass.accelerations.iter().zip(solution) {
                lowering.values[id.0 as usize] = value;
            }
        }
        for index in 0..tape.nodes.len() {
            let newest = lowering.higher(NodeId(index as u32));
            lowering.newest.push(newest);
        }
        if let (Some(mass), Some(factors)) = (&tape.mass_matrix, &factors) {
            lowering.solve(mass, factors);
        }
        Some(lowering.finish())
    }
}

impl Lowering<'_> {
    /// Numbers the sums. Those with a factor linear in time are a single product.
    fn find_sums(&mut self) {
        for index in 0..self.tape.nodes.len() {
            for Convolution { left, weighted, right } in
                self.tape.all_convolutions(NodeId(index as u32))
            {
                let [is_left, is_right] = [left, right].map(|id| self.tape.is_line(id));
                let (sums, sum) = match (is_left, is_right) {
                    (true, _) => (&mut self.lines, ((left, weighted), (right, false))),
                    (false, true) => (&mut self.lines, ((right, false), (left, weighted))),
                    _ => (&mut self.products, ((left, weighted), (right, false))),
                };
                if !sums.contains(&sum) {
                    sums.push(sum);
                }
            }
        }
    }

    fn zeroth_coefficients(&mut self, tables: usize) -> Option<()> {
        for node in &self.tape.nodes {
            let values = std::mem::take(&mut self.values);
            let of = |id: NodeId| values.get(id.0 as usize).copied();
            let zeroth = &mut self.zeroth;
            let value = match node.recurrence {
                Recurrence::Constant(op) => zeroth.operation(op, of, tables)?,
                Recurrence::Time => zeroth.push(Step::Read(Region::Time, 0)),
                Recurrence::State(entry) => zeroth.push(Step::Read(Region::State, entry)),
                Recurrence::Neg(a) => zeroth.push(Step::Neg(of(a)?)),
                Recurrence::Add(a, b) => zeroth.push(Step::Add(of(a)?, of(b)?)),
                Recurrence::Sub(a, b) => zeroth.push(Step::Sub(of(a)?, of(b)?)),
                Recurrence::Scaled { series: a, factor: b } | Recurrence::Product(a, b) => {
                    zeroth.push(Step::Mul(of(a)?, of(b)?))
                }
                Recurrence::Quotient(a, b) => zeroth.push(Step::Div(of(a)?, of(b)?)),
                Recurrence::Root(a) => zeroth.push(Step::Call(crate::Function::Sqrt, of(a)?)),
                Recurrence::Integral { function, argument, .. }
                | Recurrence::IntegralOver { function, argument, .. } => {
                    zeroth.push(Step::Call(function, of(argument)?))
                }
                Recurrence::Power { base, exponent } => {
                    zeroth.push(Step::Powf(of(base)?, of(exponent)?))
                }
                Recurrence::Select { lhs, rhs, then, otherwise } => {
                    let all = [of(lhs)?, of(rhs)?, of(then)?, of(otherwise)?];
                    zeroth.push(Step::SelectLess(all))
                }
                Recurrence::Table { table, .. } if table.0 as usize >= tables => return None,
                Recurrence::Table { table, order, argument, .. } => {
                    zeroth.push(Step::Table(table, order, of(argument)?))
                }
                Recurrence::Tail(..) | Recurrence::Lagged { .. } | Recurrence::Acceleration(_) => {
                    zeroth.literal(0.0)
                }
            };
            self.values = values;
            self.values.push(value);
        }
        Some(())
    }

    /// Returns the coefficient of the order; `None` if the node is constant or still unknown.
    fn higher(&mut self, id: NodeId) -> Option<StepId> {
        let step = match self.tape[id].recurrence {
            Recurrence::Constant(_) | Recurrence::Acceleration(_) => return None,
            Recurrence::Time => return Some(self.number(Number::Time)),
            Recurrence::State(entry) => Step::Read(LAST, 2 * self.lanes() + entry),
            Recurrence::Neg(a) => Step::Neg(self.newest(a)),
            Recurrence::Add(a, b) => match [a, b].map(|id| self.tape.is_constant(id)) {
                [true, _] => return Some(self.newest(b)),
                [_, true] => return Some(self.newest(a)),
                _ => Step::Add(self.newest(a), self.newest(b)),
            },
            Recurrence::Sub(a, b) => match [a, b].map(|id| self.tape.is_constant(id)) {
                [true, _] => Step::Neg(self.newest(b)),
                [_, true] => return Some(self.newest(a)),
                _ => Step::Sub(self.newest(a), self.newest(b)),
            },
            Recurrence::Scaled { series, factor } => {
                Step::Mul(self.newest(series), self.zeroth(factor))
            }
            Recurrence::Product(a, b) => return Some(self.product(id, a, b)),
            Recurrence::Tail(a, b) => return Some(self.sum(a, false, b)),
            Recurrence::Quotient(a, b) => {
                let sum = self.sum(b, false, id);
                let product = self.times(b, id);
                let known = self.higher.push(Step::Add(sum, product));
                let rest = if self.tape.is_constant(a) {
                    Step::Neg(known)
                } else {
                    Step::Sub(self.newest(a), known)
                };
                let (rest, inverse) = (self.higher.push(rest), self.inverse(b));
                Step::Mul(rest, inverse)
            }
            Recurrence::Root(a) => {
                let sum = self.sum(id, false, id);
                let rest = Step::Sub(self.newest(a), sum);
                let value = self.values[id.0 as usize];
                let twice = self.zeroth.push(Step::Add(value, value));
                let inverse = self.inverse_of(twice);
                Step::Mul(self.higher.push(rest), inverse)
            }
            Recurrence::Integral { argument, integrand, minus, .. } => {
                let sum = self.share(argument, integrand);
                let product = self.times(argument, integrand);
                let sum = self.higher.push(Step::Add(sum, product));
                return Some(self.signed(minus, sum));
            }
            Recurrence::IntegralOver { argument, divisor, minus, .. } => {
                let newest = self.newest(argument);
                let newest = self.signed(minus, newest);
                let rest = Step::Sub(newest, self.share(id, divisor));
                let (rest, inverse) = (self.higher.push(rest), self.inverse(divisor));
                Step::Mul(rest, inverse)
            }
            Recurrence::Power { base, exponent } => self.power(id, base, exponent),
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                let all = [self.zeroth(lhs), self.zeroth(rhs)];
                let [then, otherwise] = [then, otherwise].map(|id| self.newest(id));
                Step::SelectLess([all[0], all[1], then, otherwise])
            }
            Recurrence::Table { table, order, argument, square, cube } => {
                let at = self.values[argument.0 as usize];
                let terms = [(argument, 1, 1.0), (square, 2, 2.0), (cube, 3, 6.0)];
                let [first, second, third] = terms.map(|(id, more, divisor)| {
                    let slope = self.zeroth.push(Step::Table(table, order + more, at));
                    let divisor = self.zeroth.literal(divisor);
                    let slope = self.zeroth.push(Step::Div(slope, divisor));
                    let (slope, newest) = (self.keep(slope), self.newest(id));
                    self.higher.push(Step::Mul(slope, newest))
                });
                let sum = self.higher.push(Step::Add(first, second));
                Step::Add(sum, third)
            }
            Recurrence::Lagged { entry, acceleration } => {
                let sum = self.sum(entry, false, acceleration);
                Step::Add(sum, self.times(entry, acceleration))
            }
        };
        Some(self.higher.push(step))
    }

    /// Returns `S + a_k b_0 + b_k a_0`, with the factor that is known last multiplied last.
    fn product(&mut self, id: NodeId, a: NodeId, b: NodeId) -> StepId {
        debug_assert!(matches!(self.tape[id].recurrence, Recurrence::Product(..)));
        let sum = self.sum(a, false, b);
        if a == b {
            let value = self.values[a.0 as usize];
            let twice = self.zeroth.push(Step::Add(value, value));
            let (twice, newest) = (self.keep(twice), self.newest(a));
            let product = self.higher.push(Step::Mul(newest, twice));
            return self.higher.push(Step::Add(sum, product));
        }
        let (first, last) = (a.min(b), a.max(b));
        let product = self.times(first, last);
        let sum = self.higher.push(Step::Add(sum, product));
        let product = self.times(last, first);
        self.higher.push(Step::Add(sum, product))
    }

    /// Returns `(c y_0 x_k + (c S(x', y) - S(y', x))/k)/x_0`.
    fn power(&mut self, id: NodeId, base: NodeId, exponent: NodeId) -> Step {
        let c = self.zeroth(exponent);
        let sum = self.sum(base, true, id);
        let scaled = self.higher.push(Step::Mul(c, sum));
        let sum = self.sum(id, true, base);
        let sums = self.higher.push(Step::Sub(scaled, sum));
        let inverse = self.number(Number::Inverse);
        let sums = self.higher.push(Step::Mul(inverse, sums));
        let [c, value] = [exponent, id].map(|id| self.values[id.0 as usize]);
        let slope = self.zeroth.push(Step::Mul(c, value));
        let (slope, newest) = (self.keep(slope), self.newest(base));
        let product = self.higher.push(Step::Mul(newest, slope));
        let all = self.higher.push(Step::Add(sums, product));
        Step::Mul(all, self.inverse(base))
    }

    /// Returns `a_k b_0`.
    fn times(&mut self, newest: NodeId, zeroth: NodeId) -> StepId {
        let product = Step::Mul(self.newest(newest), self.zeroth(zeroth));
        self.higher.push(product)
    }

    fn signed(&mut self, minus: bool, value: StepId) -> StepId {
        if minus { self.higher.push(Step::Neg(value)) } else { value }
    }

    fn number(&mut self, number: Number) -> StepId {
        self.higher.push(Step::Read(Region::Time, number as u32))
    }

    /// Returns the coefficient of the order.
    fn newest(&mut self, id: NodeId) -> StepId {
        match self.newest.get(id.0 as usize).copied().flatten() {
            Some(newest) => newest,
            None => self.higher.literal(0.0),
        }
    }

    /// Returns the zeroth coefficient.
    fn zeroth(&mut self, id: NodeId) -> StepId {
        self.keep(self.values[id.0 as usize])
    }

    /// Reads a value derived from zeroth coefficients, and keeps it for all orders.
    fn keep(&mut self, value: StepId) -> StepId {
        if let Step::Literal(literal) = self.zeroth.step(value) {
            return self.higher.literal(literal);
        }
        let next = self.kept.len() as u32;
        let place = *self.kept.entry(value).or_insert(next);
        self.higher.push(Step::Read(Region::Constants, place))
    }

    fn inverse(&mut self, id: NodeId) -> StepId {
        self.inverse_of(self.values[id.0 as usize])
    }

    fn inverse_of(&mut self, value: StepId) -> StepId {
        let one = self.zeroth.literal(1.0);
        let inverse = self.zeroth.push(Step::Div(one, value));
        self.keep(inverse)
    }

    /// Returns `S(left', right)/k`.
    fn share(&mut self, left: NodeId, right: NodeId) -> StepId {
        let (sum, inverse) = (self.sum(left, true, right), self.number(Number::Inverse));
        self.higher.push(Step::Mul(inverse, sum))
    }

    fn lanes(&self) -> u32 {
        (self.products.len() + self.lines.len()) as u32
    }

    /// Returns a sum of the order.
    fn sum(&mut self, left: NodeId, weighted: bool, right: NodeId) -> StepId {
        let (left, right) = ((left, weighted), (right, false));
        // Sums of products are found by their left factor: rounding distinguishes the sides.
        let of_products = self.products.iter().position(|sum| *sum == (left, right));
        let mut lines = self.lines.iter();
        let line = lines.position(|sum| *sum == (left, right) || *sum == (right, left));
        let lane = of_products
            .or_else(|| Some(self.products.len() + line?))
            .expect("sums are numbered before they are read") as u32;
        if self.orders == Orders::First {
            return self.middle(lane);
        }
        let (left, right) = (lane, self.lanes() + lane);
        let [first_left, first_right, last_left, last_right] =
            [(FIRST, left), (FIRST, right), (LAST, left), (LAST, right)]
                .map(|(row, lane)| self.higher.push(Step::Read(row, lane)));
        let product = self.higher.push(Step::Mul(first_left, last_right));
        if of_products.is_none() {
            return product;
        }
        let other = self.higher.push(Step::Mul(last_left, first_right));
        let ends = self.higher.push(Step::Add(product, other));
        let middle = self.middle(lane);
        self.higher.push(Step::Add(middle, ends))
    }

    /// Reads the part of a sum that is known before the previous order is.
    fn middle(&mut self, lane: u32) -> StepId {
        let before = 2 * self.lanes() + self.tape.rate.len() as u32;
        self.higher.push(Step::Read(Region::Results, before + lane))
    }

    fn solve(&mut self, mass: &MassMatrix, factors: &Factors) {
        let right = mass.right_side.iter().map(|&id| self.newest(id)).collect();
        let mut higher = std::mem::take(&mut self.higher);
        let solution = factors.solve(&mut higher, right, |higher, id| {
            let next = self.kept.len() as u32;
            let place = *self.kept.entry(id).or_insert(next);
            higher.push(Step::Read(Region::Constants, place))
        });
        self.higher = higher;
        for (id, value) in mass.accelerations.iter().zip(solution) {
            self.newest[id.0 as usize] = Some(value);
        }
    }

    /// Lists the results to write and returns the programs.
    fn finish(mut self) -> Lowered {
        let sums = Sums { products: self.products.len(), lines: self.lines.len() };
        let lanes = sums.lanes() as u32;
        let order = self.number(Number::Order);
        let all: Vec<(Factor, Factor)> = [&self.products[..], &self.lines].concat();
        for (lane, (left, right)) in all.into_iter().enumerate() {
            for (side, (id, weighted)) in [left, right].into_iter().enumerate() {
                let newest = self.newest(id);
                let factor =
                    if weighted { self.higher.push(Step::Mul(order, newest)) } else { newest };
                self.higher.writes.push((side as u32 * lanes + lane as u32, factor));
            }
        }
        let next = self.number(Number::NextInverse);
        let kept = self.kept.len() as u32;
        for (entry, &rate) in self.tape.rate.iter().enumerate() {
            let newest = self.newest(rate);
            let coefficient = self.higher.push(Step::Mul(newest, next));
            self.higher.writes.push((2 * lanes + entry as u32, coefficient));
            self.zeroth.writes.push((kept + entry as u32, self.values[rate.0 as usize]));
        }
        let mut writes: Vec<(u32, StepId)> =
            self.kept.into_iter().map(|(id, at)| (at, id)).collect();
        writes.sort_unstable();
        self.zeroth.writes.extend(writes);
        let constants = kept + self.tape.rate.len() as u32;
        if self.orders == Orders::Later && sums.products > 0 {
            self.higher.middles = Some(Middles {
                count: sums.products,
                left: 0,
                right: sums.lanes(),
                sums: 2 * sums.lanes() + self.tape.rate.len(),
                row: sums.row(self.tape.rate.len()),
            });
        }
        let (zeroth, higher) = (self.zeroth.pruned(), self.higher.pruned());
        Lowered { zeroth, higher, constants: constants as usize, sums }
    }
}
