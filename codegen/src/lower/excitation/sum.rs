//! Sums of terms. A term is a coefficient, which depends on parameters only, times an entry of
//! the state or a function of time.

use machinist_algebra::expr::Graph;
use machinist_model::{Excitation, Function, NodeId, Op};

/// Maximum number of terms. With more, stepping is as fast.
const MOST_TERMS: usize = 400;
/// Maximum power of time in a wave, likewise.
const HIGHEST_POWER: i32 = 8;

/// Factor of a coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Basis {
    /// An entry of the state.
    State(u32),
    /// A function of time.
    Wave(Wave),
}

/// A wave t^power e^(growth t) cos(frequency t), or the sine.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Wave {
    power: u32,
    growth: NodeId,
    frequency: NodeId,
    is_sine: bool,
}

/// A sum of terms, each basis once; no term is zero.
#[derive(Debug, Clone, Default)]
pub(super) struct Sum(Vec<(Basis, NodeId)>);

/// Cosine and sine of one kind of wave.
#[derive(Debug, Clone, Copy)]
pub(super) struct WavePair {
    pub power: u32,
    pub growth: NodeId,
    pub frequency: NodeId,
    pub cosine: NodeId,
    pub sine: NodeId,
}

/// Algebra of sums. Coefficients are nodes of one graph, on which equal ones are the same node.
pub(super) struct Algebra {
    graph: Graph,
    zero: NodeId,
    one: NodeId,
    switches: Vec<NodeId>,
}

impl Sum {
    fn symbol(basis: Basis, coefficient: NodeId) -> Self {
        Sum(vec![(basis, coefficient)])
    }

    fn coefficient(&self, basis: Basis) -> Option<NodeId> {
        self.0.iter().find(|(known, _)| *known == basis).map(|(_, coefficient)| *coefficient)
    }

    /// Reports whether every term contains a state.
    pub(super) fn is_of_states(&self) -> bool {
        self.0.iter().all(|(basis, _)| matches!(basis, Basis::State(_)))
    }

    /// Returns the entries of the state with their coefficients.
    pub(super) fn slopes(&self) -> impl Iterator<Item = (u32, NodeId)> {
        self.0.iter().filter_map(|(basis, coefficient)| match basis {
            Basis::State(entry) => Some((*entry, *coefficient)),
            Basis::Wave(_) => None,
        })
    }

    fn depends_on_state(&self) -> bool {
        self.0.iter().any(|(basis, _)| matches!(basis, Basis::State(_)))
    }

    /// Returns the functions of time, with cosine and sine of a kind together.
    pub(super) fn waves(&self, algebra: &Algebra) -> Vec<WavePair> {
        let mut pairs: Vec<WavePair> = Vec::new();
        for (basis, coefficient) in &self.0 {
            let Basis::Wave(wave) = *basis else { continue };
            let Wave { power, growth, frequency, .. } = wave;
            let is_of = |pair: &WavePair| {
                (pair.power, pair.growth, pair.frequency) == (power, growth, frequency)
            };
            let place = pairs.iter().position(is_of).unwrap_or_else(|| {
                let (cosine, sine) = (algebra.zero, algebra.zero);
                pairs.push(WavePair { power, growth, frequency, cosine, sine });
                pairs.len() - 1
            });
            if wave.is_sine {
                pairs[place].sine = *coefficient;
            } else {
                pairs[place].cosine = *coefficient;
            }
        }
        pairs
    }
}

impl Algebra {
    pub(super) fn new() -> Self {
        let mut graph = Graph::new();
        let (zero, one) = (graph.literal(0.0), graph.literal(1.0));
        Algebra { graph, zero, one, switches: Vec::new() }
    }

    pub(super) fn graph(&self) -> &Graph {
        &self.graph
    }

    pub(super) fn switches(&self) -> &[NodeId] {
        &self.switches
    }

    pub(super) fn literal(&mut self, value: f64) -> Sum {
        let node = self.graph.literal(value);
        self.constant(node)
    }

    /// Returns the constant sum of an operation that is known before a run or passed by a field.
    pub(super) fn given(&mut self, op: Op) -> Sum {
        let node = self.graph.insert(op);
        self.constant(node)
    }

    pub(super) fn time(&self) -> Sum {
        Sum::symbol(Basis::Wave(self.power_of_time(1)), self.one)
    }

    pub(super) fn state(&self, entry: u32) -> Sum {
        Sum::symbol(Basis::State(entry), self.one)
    }

    pub(super) fn negative(&mut self, a: &Sum) -> Sum {
        Sum(a.0.iter().map(|(basis, c)| (*basis, self.graph.neg(*c))).collect())
    }

    pub(super) fn sum(&mut self, a: &Sum, b: &Sum) -> Sum {
        let mut sum = a.clone();
        for &(basis, coefficient) in &b.0 {
            self.add(&mut sum, basis, coefficient);
        }
        sum
    }

    /// Multiplies sums. `None` if the product is not linear in the state, or a coefficient of the
    /// state depends on time.
    pub(super) fn product(&mut self, a: &Sum, b: &Sum) -> Option<Sum> {
        if let Some(factor) = self.as_constant(b) {
            return Some(self.scaled(a, factor));
        }
        if let Some(factor) = self.as_constant(a) {
            return Some(self.scaled(b, factor));
        }
        if a.0.len() * b.0.len() > MOST_TERMS {
            return None;
        }
        let mut product = Sum::default();
        for (a, of_a) in &a.0 {
            for (b, of_b) in &b.0 {
                let (&Basis::Wave(a), &Basis::Wave(b)) = (a, b) else { return None };
                if a.power + b.power > Excitation::HIGHEST_POWER {
                    return None;
                }
                let coefficient = self.graph.mul(*of_a, *of_b);
                self.add_product(&mut product, a, b, coefficient);
            }
        }
        Some(product)
    }

    pub(super) fn quotient(&mut self, a: &Sum, b: &Sum) -> Option<Sum> {
        let divisor = self.as_constant(b)?;
        let quotient = a.0.iter().map(|(basis, c)| (*basis, self.graph.div(*c, divisor)));
        Some(Sum(quotient.collect()))
    }

    pub(super) fn power(&mut self, a: &Sum, exponent: i32) -> Option<Sum> {
        if let Some(base) = self.as_constant(a) {
            let power = self.graph.powi(base, exponent);
            return Some(self.constant(power));
        }
        if !(1..=HIGHEST_POWER).contains(&exponent) {
            return None;
        }
        let mut power = a.clone();
        for _ in 1..exponent {
            power = self.product(&power, a)?;
        }
        Some(power)
    }

    /// Applies a function to sums that depend on parameters only.
    pub(super) fn of_constants(
        &mut self,
        arguments: &[&Sum],
        function: impl FnOnce(&mut Graph, &[NodeId]) -> NodeId,
    ) -> Option<Sum> {
        let arguments: Option<Vec<NodeId>> =
            arguments.iter().map(|argument| self.as_constant(argument)).collect();
        let node = function(&mut self.graph, &arguments?);
        Some(self.constant(node))
    }

    /// Applies sine, cosine or exponential to a + b t, or any function to constants.
    pub(super) fn call(&mut self, function: Function, argument: &Sum) -> Option<Sum> {
        if let Some(argument) = self.as_constant(argument) {
            let node = self.graph.call(function, argument);
            return Some(self.constant(node));
        }
        let [offset, slope] = self.as_affine(argument)?;
        match function {
            Function::Sin | Function::Cos => Some(self.wave(function, offset, slope)),
            Function::Exp => Some(self.exponential(offset, slope)),
            Function::Sinh | Function::Cosh => {
                let half = self.graph.literal(0.5);
                let up = self.exponential(offset, slope);
                let [offset, slope] = [offset, slope].map(|node| self.graph.neg(node));
                let mut down = self.exponential(offset, slope);
                if function == Function::Sinh {
                    down = self.negative(&down);
                }
                let both = self.sum(&up, &down);
                Some(self.scaled(&both, half))
            }
            _ => None,
        }
    }

    /// Selects `then` where lhs < rhs. The comparison may depend on time, not on the state.
    pub(super) fn choice(&mut self, lhs: &Sum, rhs: &Sum, branches: [&Sum; 2]) -> Option<Sum> {
        if let (Some(lhs), Some(rhs)) = (self.as_constant(lhs), self.as_constant(rhs)) {
            return Some(self.chosen([lhs, rhs], branches));
        }
        let (lhs, rhs) = (self.as_affine(lhs)?, self.as_affine(rhs)?);
        // Times at which pieces end follow from parameters.
        if !lhs.iter().chain(&rhs).all(|node| self.graph.is_constant(*node)) {
            return None;
        }
        if lhs[1] != rhs[1] {
            let (ahead, faster) = (self.graph.sub(rhs[0], lhs[0]), self.graph.sub(lhs[1], rhs[1]));
            let switch = self.graph.div(ahead, faster);
            if !self.switches.contains(&switch) {
                self.switches.push(switch);
            }
        }
        let sides = [self.at_time(lhs), self.at_time(rhs)];
        Some(self.chosen(sides, branches))
    }

    /// Selects `then` where the slot of a relation holds it below zero, or above if the slot is
    /// subtracted.
    pub(super) fn held_choice(
        &mut self,
        (slot, is_opposite): (Op, bool),
        branches: [&Sum; 2],
    ) -> Sum {
        let slot = self.graph.insert(slot);
        let side = if is_opposite { self.graph.neg(slot) } else { slot };
        self.chosen([side, self.zero], branches)
    }

    /// Selects the first branch where the first node is less than the second.
    fn chosen(&mut self, [lhs, rhs]: [NodeId; 2], branches: [&Sum; 2]) -> Sum {
        let mut bases: Vec<Basis> = Vec::new();
        for (basis, _) in branches.iter().flat_map(|branch| &branch.0) {
            if !bases.contains(basis) {
                bases.push(*basis);
            }
        }
        let mut chosen = Sum::default();
        for basis in bases {
            let [then, otherwise] =
                branches.map(|branch| branch.coefficient(basis).unwrap_or(self.zero));
            let coefficient = self.graph.select_less(lhs, rhs, then, otherwise);
            self.add(&mut chosen, basis, coefficient);
        }
        chosen
    }

    fn constant(&self, node: NodeId) -> Sum {
        if self.graph.is_zero(node) {
            return Sum::default();
        }
        Sum::symbol(Basis::Wave(self.power_of_time(0)), node)
    }

    fn power_of_time(&self, power: u32) -> Wave {
        Wave { power, growth: self.zero, frequency: self.zero, is_sine: false }
    }

    /// Adds a term. Terms that cancel and sines of zero are removed.
    fn add(&mut self, sum: &mut Sum, basis: Basis, coefficient: NodeId) {
        let is_nothing = |wave: &Wave| wave.is_sine && self.graph.is_zero(wave.frequency);
        if matches!(&basis, Basis::Wave(wave) if is_nothing(wave)) {
            return;
        }
        match sum.0.iter_mut().find(|(known, _)| *known == basis) {
            Some((_, known)) => *known = self.graph.add(*known, coefficient),
            None => sum.0.push((basis, coefficient)),
        }
        sum.0.retain(|(_, coefficient)| !self.graph.is_zero(*coefficient));
    }

    fn scaled(&mut self, a: &Sum, factor: NodeId) -> Sum {
        let mut scaled = Sum::default();
        for &(basis, coefficient) in &a.0 {
            let coefficient = self.graph.mul(coefficient, factor);
            self.add(&mut scaled, basis, coefficient);
        }
        scaled
    }

    /// Adds cos a cos b = (cos(a - b) + cos(a + b))/2, and likewise for sines.
    fn add_product(&mut self, product: &mut Sum, a: Wave, b: Wave, coefficient: NodeId) {
        let power = a.power + b.power;
        let growth = self.graph.add(a.growth, b.growth);
        let mut add = |algebra: &mut Self, frequency, is_sine, coefficient| {
            let wave = Wave { power, growth, frequency, is_sine };
            algebra.add(product, Basis::Wave(wave), coefficient);
        };
        if self.graph.is_zero(b.frequency) {
            return add(self, a.frequency, a.is_sine, coefficient);
        }
        if self.graph.is_zero(a.frequency) {
            return add(self, b.frequency, b.is_sine, coefficient);
        }
        let half = self.graph.literal(0.5);
        let half = self.graph.mul(half, coefficient);
        let minus_half = self.graph.neg(half);
        let slow = self.graph.sub(a.frequency, b.frequency);
        let fast = self.graph.add(a.frequency, b.frequency);
        let (is_sine, of_slow, of_fast) = match (a.is_sine, b.is_sine) {
            (false, false) => (false, half, half),
            (true, true) => (false, half, minus_half),
            (true, false) => (true, half, half),
            (false, true) => (true, minus_half, half),
        };
        add(self, slow, is_sine, of_slow);
        add(self, fast, is_sine, of_fast);
    }

    /// Returns the value of a sum that contains neither state nor time.
    fn as_constant(&self, sum: &Sum) -> Option<NodeId> {
        match sum.0.as_slice() {
            [] => Some(self.zero),
            &[(basis, value)] if basis == Basis::Wave(self.power_of_time(0)) => Some(value),
            _ => None,
        }
    }

    /// Returns a and b of a + b t, both constant in time.
    fn as_affine(&self, sum: &Sum) -> Option<[NodeId; 2]> {
        let powers = [0, 1].map(|power| Basis::Wave(self.power_of_time(power)));
        let is_affine = sum.0.iter().all(|(basis, _)| powers.contains(basis));
        let values = powers.map(|basis| sum.coefficient(basis).unwrap_or(self.zero));
        let is_steady = values.iter().all(|value| self.is_steady(*value));
        (is_affine && is_steady && !sum.depends_on_state()).then_some(values)
    }

    /// Returns whether a coefficient is the same on all pieces of time.
    fn is_steady(&self, id: NodeId) -> bool {
        let op = self.graph.op(id);
        op != Op::Time && op.operands().iter().all(|operand| self.is_steady(*operand))
    }

    /// Returns a + b t as a node.
    fn at_time(&mut self, [offset, slope]: [NodeId; 2]) -> NodeId {
        let time = self.graph.time();
        let part = self.graph.mul(slope, time);
        self.graph.add(offset, part)
    }

    /// Returns sin(a + b t) = cos(a) sin(b t) + sin(a) cos(b t), or the cosine.
    fn wave(&mut self, function: Function, offset: NodeId, frequency: NodeId) -> Sum {
        let cosine = self.graph.call(Function::Cos, offset);
        let sine = self.graph.call(Function::Sin, offset);
        let (of_cosine, of_sine) =
            if function == Function::Sin { (sine, cosine) } else { (cosine, self.graph.neg(sine)) };
        let wave = |is_sine| Basis::Wave(Wave { frequency, is_sine, ..self.power_of_time(0) });
        let (cosine, sine) = (wave(false), wave(true));
        let mut sum = Sum::default();
        self.add(&mut sum, cosine, of_cosine);
        self.add(&mut sum, sine, of_sine);
        sum
    }

    /// Returns e^(a + b t).
    fn exponential(&mut self, offset: NodeId, growth: NodeId) -> Sum {
        let size = self.graph.call(Function::Exp, offset);
        let mut sum = Sum::default();
        self.add(&mut sum, Basis::Wave(Wave { growth, ..self.power_of_time(0) }), size);
        sum
    }
}

#[cfg(test)]
mod tests;
