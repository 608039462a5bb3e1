//! Coefficients of a series, one line each.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::needs::{Needs, in_order, line_and_other};
use super::{LANES, Names};
use crate::emit::EmitError;
use crate::emit::rust::Scene;
use crate::emit::rust::body::{self, Scope};
use crate::emit::rust::operation::{Expressions, Strength, Written};
use machinist_model::series::{Convolution, MassMatrix, Recurrence, TaylorTape};
use machinist_model::{Function, NodeId, Op};

/// Arguments that the function reads, for names in its signature.
#[derive(Default)]
pub(super) struct Reads {
    /// Arguments of any function.
    pub(super) given: body::Reads,
    /// True if the order is read as a number.
    pub(super) order: bool,
    newest_states: BTreeSet<usize>,
}

/// Writes coefficients and records their names.
pub(super) struct Writer<'a> {
    scope: Scope<'a>,
    tape: &'a TaylorTape,
    needs: &'a Needs,
    names: Names,
    /// Zeroth coefficients; `None` if zero.
    values: Vec<Option<TokenStream>>,
    /// First coefficients of lines.
    slopes: Vec<Option<TokenStream>>,
    /// Newest coefficients; `None` if zero.
    newest: Vec<Option<TokenStream>>,
    befores: Vec<Option<Ident>>,
    /// Reciprocals by which nodes multiply instead of dividing.
    inverses: Vec<Option<Ident>>,
    /// First, halved second and sixth of the third derivative of tables.
    derivatives: Vec<Option<[Ident; 3]>>,
    newest_states: Vec<Ident>,
    temporaries: u32,
    pub(super) reads: Reads,
}

impl Expressions for Writer<'_> {
    /// Returns the zeroth coefficient of an operand.
    fn operand(&mut self, id: NodeId) -> Result<Written, EmitError> {
        Ok(Written::call(self.value(id)))
    }

    fn scope(&self) -> &Scope<'_> {
        &self.scope
    }

    fn reads(&mut self) -> &mut body::Reads {
        &mut self.reads.given
    }

    fn function(&self) -> &'static str {
        "series"
    }
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        scene: &'a Scene<'a>,
        tape: &'a TaylorTape,
        needs: &'a Needs,
        mut names: Names,
    ) -> Self {
        let newest_states =
            scene.states.iter().map(|state| names.namer.claim(&format!("{state}_k")));
        let newest_states = newest_states.collect();
        let count = tape.nodes.len();
        Self {
            scope: scene.scope(&[]),
            tape,
            needs,
            names,
            values: vec![None; count],
            slopes: vec![None; count],
            newest: vec![None; count],
            befores: vec![None; count],
            inverses: vec![None; count],
            derivatives: vec![None; count],
            newest_states,
            temporaries: 0,
            reads: Reads::default(),
        }
    }

    /// Returns the zeroth coefficients of all nodes, and slopes of lines that are read.
    pub(super) fn zeroth(&mut self) -> Result<Vec<TokenStream>, EmitError> {
        let mut statements = Vec::new();
        for id in self.ids() {
            let (value, is_atom) = self.zeroth_of(id)?;
            if let (false, Some(value)) = (is_atom, &value) {
                let name = self.name(id);
                statements.push(quote!(let #name = #value;));
                self.values[index(id)] = Some(quote!(#name));
            } else {
                self.values[index(id)] = value;
            }
        }
        for id in self.ids() {
            self.table_derivatives(id, &mut statements)?;
            let line = match self.tape[id].recurrence {
                Recurrence::Integral { argument, .. } => Some(argument),
                _ => line_and_other(self.tape, id).map(|(line, _)| line),
            };
            if let Some(line) = line.filter(|&line| self.tape.is_line(line)) {
                self.slope(line, &mut statements);
            }
            if let Some((name, divisor)) = self.inverse_of(id) {
                statements.push(quote!(let #name = R::literal(1.0) / #divisor;));
            }
        }
        Ok(statements)
    }

    /// Returns the newest coefficients of all nodes that are read.
    pub(super) fn higher(&mut self) -> Vec<TokenStream> {
        let mut statements = Vec::new();
        let is_written = |needs: &Needs, id| needs.newest[index(id)] && !needs.within[index(id)];
        for id in self.ids().filter(|&id| is_written(self.needs, id)) {
            let (value, is_atom) = self.higher_of(id);
            if let (false, Some(value)) = (is_atom, &value) {
                let name = self.newest_name(id);
                statements.push(quote!(let #name = #value;));
                self.newest[index(id)] = Some(quote!(#name));
            } else {
                self.newest[index(id)] = value;
            }
        }
        statements
    }

    fn ids(&self) -> impl Iterator<Item = NodeId> + use<> {
        (0..self.tape.nodes.len()).map(|index| NodeId(index as u32))
    }

    /// Returns the zeroth coefficient, and whether it needs no `let`.
    fn zeroth_of(&mut self, id: NodeId) -> Result<(Option<TokenStream>, bool), EmitError> {
        let recurrence = self.tape[id].recurrence;
        let op = match recurrence {
            Recurrence::Constant(op) => op,
            Recurrence::Time => Op::Time,
            Recurrence::State(entry) => Op::State(entry),
            Recurrence::Tail(..) | Recurrence::Lagged { .. } | Recurrence::Acceleration(_) => {
                return Ok((None, true));
            }
            Recurrence::Add(..) | Recurrence::Sub(..) | Recurrence::Neg(_) => {
                return Ok(linear(&recurrence, |id| self.values[index(id)].clone()));
            }
            Recurrence::Scaled { series: a, factor: b } | Recurrence::Product(a, b) => {
                Op::Mul(a, b)
            }
            Recurrence::Quotient(a, b) => Op::Div(a, b),
            Recurrence::Root(a) => Op::Call(Function::Sqrt, a),
            Recurrence::Integral { function, argument, .. }
            | Recurrence::IntegralOver { function, argument, .. } => Op::Call(function, argument),
            Recurrence::Power { base, exponent } => Op::Powf(base, exponent),
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                Op::SelectLess { lhs, rhs, then, otherwise }
            }
            Recurrence::Table { table, order, argument, .. } => {
                Op::Table { table, order, argument }
            }
        };
        Ok((Some(self.operation(&op)?.tokens), !op.is_arithmetic()))
    }

    /// Returns the newest coefficient, and whether it needs no `let`.
    fn higher_of(&mut self, id: NodeId) -> (Option<TokenStream>, bool) {
        let recurrence = self.tape[id].recurrence;
        let names = self.names.clone();
        let (order, inverse) = (&names.order, &names.inverse);
        let sums: Vec<TokenStream> =
            self.tape.convolutions(id).into_iter().map(|sum| self.sum(sum)).collect();
        let newest = |id| self.newest_or_zero(id);
        let value = match recurrence {
            Recurrence::Constant(_) => return (None, true),
            Recurrence::Time => {
                quote!(R::literal(if #order == 1 { 1.0 } else { 0.0 }))
            }
            Recurrence::State(entry) => {
                self.reads.newest_states.insert(entry as usize);
                let name = &self.newest_states[entry as usize];
                return (Some(quote!(#name)), true);
            }
            Recurrence::Acceleration(_) => return (self.newest[index(id)].clone(), true),
            Recurrence::Add(a, b) | Recurrence::Sub(a, b) => {
                let is_difference = matches!(recurrence, Recurrence::Sub(..));
                return match self.fused(a, b, is_difference) {
                    Some(fused) => (Some(fused), false),
                    None => linear(&recurrence, |id| self.newest_or_product(id)),
                };
            }
            Recurrence::Neg(_) => return linear(&recurrence, |id| self.newest[index(id)].clone()),
            Recurrence::Scaled { .. } => return (self.newest_or_product(id), false),
            Recurrence::Product(a, b) => self.product(id, [a, b], &sums),
            Recurrence::Tail(..) => return (Some(quote!(#(#sums)*)), true),
            Recurrence::Quotient(a, b) => {
                let ratio = self.value(id);
                let inverse_of = &self.inverses[index(id)];
                let b = newest(b);
                if self.tape.is_constant(a) {
                    let b = receiver(&b);
                    quote!(-#b.mul_add(#ratio, #(#sums)*) * #inverse_of)
                } else {
                    let a = newest(a);
                    quote!((-#b).mul_add(#ratio, #a - #(#sums)*) * #inverse_of)
                }
            }
            Recurrence::Root(a) => {
                let (a, inverse_of) = (newest(a), &self.inverses[index(id)]);
                quote!((#a - #(#sums)*) * #inverse_of)
            }
            Recurrence::Integral { argument, integrand, minus, .. } => {
                self.integral(argument, integrand, minus, &sums)
            }
            Recurrence::IntegralOver { argument, minus, .. } => {
                let (argument, inverse_of) = (newest(argument), &self.inverses[index(id)]);
                let minus = minus.then(|| quote!(-));
                quote!((#minus #argument - #inverse * #(#sums)*) * #inverse_of)
            }
            Recurrence::Power { base, exponent } => {
                let inverse_of = &self.inverses[index(id)];
                let (power, exponent) = (self.value(id), self.value(exponent));
                let base = receiver(&newest(base));
                let (first, second) = (&sums[0], &sums[1]);
                quote!(
                    (#exponent * #base.mul_add(#power, #inverse * #first) - #inverse * #second)
                        * #inverse_of
                )
            }
            Recurrence::Select { lhs, rhs, then, otherwise } => {
                let [lhs, rhs] = [lhs, rhs].map(|id| self.value(id));
                let [then, otherwise] = [then, otherwise].map(newest);
                quote!(R::select_less(#lhs, #rhs, #then, #otherwise))
            }
            Recurrence::Table { argument, square, cube, .. } => {
                let derivatives = self.derivatives[index(id)].iter().flatten();
                let powers = [argument, square, cube].map(newest);
                let terms =
                    derivatives.zip(&powers).map(|(factor, power)| quote!(#factor * #power));
                let terms = terms.reduce(|sum, term| quote!(#sum + #term));
                quote!(#terms)
            }
            Recurrence::Lagged { entry, acceleration } => {
                let (entry, acceleration) = (receiver(&newest(entry)), self.value(acceleration));
                quote!(#entry.mul_add(#acceleration, #(#sums)*))
            }
        };
        (Some(value), false)
    }

    /// Returns the newest coefficient of a node; a product with a constant is written out.
    fn newest_or_product(&self, id: NodeId) -> Option<TokenStream> {
        if let Some(known) = &self.newest[index(id)] {
            return Some(known.clone());
        }
        let Recurrence::Scaled { series, factor } = self.tape[id].recurrence else { return None };
        let (series, factor) = (self.newest[index(series)].as_ref()?, self.value(factor));
        Some(quote!(#series * #factor))
    }

    /// Returns a + b or a - b if one of them is a product written within.
    fn fused(&self, a: NodeId, b: NodeId, is_difference: bool) -> Option<TokenStream> {
        let parts = |id: NodeId| match self.tape[id].recurrence {
            Recurrence::Scaled { series, factor } if self.needs.within[index(id)] => {
                Some((self.newest[index(series)].clone()?, self.value(factor)))
            }
            _ => None,
        };
        let other = |id: NodeId| self.newest_or_product(id);
        if let (Some((series, factor)), Some(a)) = (parts(b), other(a)) {
            let series = if is_difference { quote!((-#series)) } else { receiver(&series) };
            return Some(quote!(#series.mul_add(#factor, #a)));
        }
        let ((series, factor), b) = (parts(a)?, other(b)?);
        let minus = is_difference.then(|| quote!(-));
        let series = receiver(&series);
        Some(quote!(#series.mul_add(#factor, #minus #b)))
    }

    fn product(&self, id: NodeId, [id_a, id_b]: [NodeId; 2], sums: &[TokenStream]) -> TokenStream {
        if let Some((line, other)) = line_and_other(self.tape, id) {
            let (value, slope) = (self.value(line), self.slope_name(line));
            let (newest, before) = (self.newest_or_zero(other), &self.befores[index(other)]);
            return quote!(#value.mul_add(#newest, #slope * #before));
        }
        let ([a_value, b_value], [a, b]) =
            ([id_a, id_b].map(|id| self.value(id)), [id_a, id_b].map(|id| self.newest_or_zero(id)));
        if id_a == id_b {
            return quote!((#a_value + #a_value).mul_add(#a, #(#sums)*));
        }
        // The product that is ready last is multiplied last.
        let depth = |id| self.needs.depth[index(id)];
        if depth(id_a) > depth(id_b) {
            quote!(#b_value.mul_add(#a, #a_value.mul_add(#b, #(#sums)*)))
        } else {
            quote!(#a_value.mul_add(#b, #b_value.mul_add(#a, #(#sums)*)))
        }
    }

    fn integral(
        &self,
        argument: NodeId,
        integrand: NodeId,
        minus: bool,
        sums: &[TokenStream],
    ) -> TokenStream {
        let inverse = &self.names.inverse;
        if self.tape.is_line(argument) {
            let (slope, before) = (self.slope_name(argument), &self.befores[index(integrand)]);
            let minus = minus.then(|| quote!(-));
            return quote!(#minus #inverse * #slope * #before);
        }
        let value = self.value(integrand);
        let newest = receiver(&self.newest_or_zero(argument));
        if minus {
            quote!(-#newest.mul_add(#value, #inverse * #(#sums)*))
        } else {
            quote!(#newest.mul_add(#value, #inverse * #(#sums)*))
        }
    }

    /// Returns the expression of a sum.
    fn sum(&mut self, convolution: Convolution) -> TokenStream {
        let convolution = in_order(convolution);
        let lane = self.needs.convolutions.iter().position(|known| *known == convolution);
        let lane = lane.unwrap_or_default();
        self.reads.order |= convolution.weighted;
        let sums = self.names.sums(lane / LANES);
        let lane = Literal::usize_unsuffixed(lane % LANES);
        quote!(#sums[#lane])
    }

    pub(super) fn left_factor(&self, convolution: &Convolution) -> TokenStream {
        let left = self.newest_or_zero(convolution.left);
        let k = &self.names.k;
        if convolution.weighted { quote!(#k * #left) } else { left }
    }

    /// Returns the zeroth coefficient of a node.
    pub(super) fn value(&self, id: NodeId) -> TokenStream {
        self.values[index(id)].clone().unwrap_or_else(zero)
    }

    /// Returns the newest coefficient of a node.
    pub(super) fn newest_or_zero(&self, id: NodeId) -> TokenStream {
        self.newest[index(id)].clone().unwrap_or_else(zero)
    }

    fn slope_name(&self, id: NodeId) -> TokenStream {
        self.slopes[index(id)].clone().unwrap_or_else(zero)
    }

    /// Returns the first coefficient of a line, written once.
    fn slope(&mut self, id: NodeId, statements: &mut Vec<TokenStream>) -> Option<TokenStream> {
        if self.tape.is_constant(id) {
            return None;
        }
        if let Some(known) = &self.slopes[index(id)] {
            return Some(known.clone());
        }
        let recurrence = self.tape[id].recurrence;
        let (slope, is_atom) = match recurrence {
            Recurrence::Time => (Some(quote!(R::literal(1.0))), true),
            Recurrence::Scaled { series, factor } => {
                let is_time = matches!(self.tape[series].recurrence, Recurrence::Time);
                let (series, factor) = (self.slope(series, statements)?, self.value(factor));
                let slope = if is_time { factor } else { quote!(#series * #factor) };
                (Some(slope), is_time)
            }
            _ => {
                let operands = recurrence.reads();
                for operand in &operands {
                    self.slope(*operand, statements);
                }
                linear(&recurrence, |id| self.slopes[index(id)].clone())
            }
        };
        let mut slope = slope?;
        if !is_atom {
            let name = self.claim(&format!("{}_slope", self.word(id)));
            statements.push(quote!(let #name = #slope;));
            slope = quote!(#name);
        }
        self.slopes[index(id)] = Some(slope.clone());
        Some(slope)
    }

    /// Returns name and divisor of the reciprocal by which a node multiplies.
    fn inverse_of(&mut self, id: NodeId) -> Option<(Ident, TokenStream)> {
        let (of, divisor) = match self.tape[id].recurrence {
            Recurrence::Quotient(_, b) => (b, self.value(b)),
            Recurrence::IntegralOver { divisor, .. } => (divisor, self.value(divisor)),
            Recurrence::Power { base, .. } => (base, self.value(base)),
            Recurrence::Root(_) => {
                let root = self.value(id);
                (id, quote!((#root + #root)))
            }
            _ => return None,
        };
        let name = self.claim(&format!("inverse_{}", self.word(of)));
        self.inverses[index(id)] = Some(name.clone());
        Some((name, divisor))
    }

    /// Returns the derivatives of a table at the zeroth coefficient, divided by factorials.
    fn table_derivatives(
        &mut self,
        id: NodeId,
        statements: &mut Vec<TokenStream>,
    ) -> Result<(), EmitError> {
        let Recurrence::Table { table, order, argument, .. } = self.tape[id].recurrence else {
            return Ok(());
        };
        let word = self.word(id);
        let names =
            ["first", "second", "third"].map(|which| self.claim(&format!("{word}_{which}")));
        let factors =
            [None, Some(quote!(R::literal(0.5) *)), Some(quote!(R::literal(1.0 / 6.0) *))];
        for ((name, factor), more) in names.iter().zip(factors).zip(1..) {
            let value = self.operation(&Op::Table { table, order: order + more, argument })?;
            let value = value.at_least(Strength::Call);
            statements.push(quote!(let #name = #factor #value;));
        }
        self.derivatives[index(id)] = Some(names);
        Ok(())
    }

    pub(super) fn rates(&self) -> Vec<TokenStream> {
        self.tape.rate.iter().map(|&id| self.value(id)).collect()
    }

    pub(super) fn higher_rates(&self) -> Vec<TokenStream> {
        self.tape.rate.iter().map(|&id| self.newest_or_zero(id)).collect()
    }

    /// Returns the initial values of coefficients that are kept for the next order.
    pub(super) fn befores(&mut self) -> Vec<TokenStream> {
        let mut statements = Vec::new();
        for id in self.ids().filter(|&id| self.needs.before[index(id)]) {
            let name = self.claim(&format!("{}_before", self.word(id)));
            let value = self.value(id);
            statements.push(quote!(let mut #name = #value;));
            self.befores[index(id)] = Some(name);
        }
        statements
    }

    pub(super) fn keep_befores(&self) -> Vec<TokenStream> {
        let kept = self.ids().filter_map(|id| {
            let (name, newest) = (self.befores[index(id)].as_ref()?, self.newest_or_zero(id));
            Some(quote!(#name = #newest;))
        });
        kept.collect()
    }

    /// Returns names for the zeroth accelerations.
    pub(super) fn accelerations(&mut self, mass: &MassMatrix) -> Vec<Ident> {
        let names = mass.accelerations.iter().map(|&id| {
            let name = self.name(id);
            self.values[index(id)] = Some(quote!(#name));
            name
        });
        names.collect()
    }

    /// Returns names for the newest accelerations.
    pub(super) fn higher_accelerations(&mut self, mass: &MassMatrix) -> Vec<Ident> {
        let names = mass.accelerations.iter().map(|&id| {
            let name = self.newest_name(id);
            self.newest[index(id)] = Some(quote!(#name));
            name
        });
        names.collect()
    }

    /// Binds the states.
    pub(super) fn states(&self) -> Option<TokenStream> {
        pattern(self.scope.states, &self.reads.given.state)
            .map(|pattern| quote!(let #pattern = *state;))
    }

    /// Binds the newest coefficients of the states.
    pub(super) fn newest_states(&self) -> Option<TokenStream> {
        let newest = &self.names.newest;
        pattern(&self.newest_states, &self.reads.newest_states)
            .map(|pattern| quote!(let #pattern = *#newest;))
    }

    /// Returns a new name for a node.
    fn name(&mut self, id: NodeId) -> Ident {
        let name = self.tape[id].name.clone().or_else(|| self.describe(id));
        let wanted = name.filter(|name| name.len() <= 36).unwrap_or_else(|| {
            let wanted = format!("t{}", self.temporaries);
            self.temporaries += 1;
            wanted
        });
        self.claim(&wanted)
    }

    fn claim(&mut self, wanted: &str) -> Ident {
        self.names.namer.claim(wanted)
    }

    fn newest_name(&mut self, id: NodeId) -> Ident {
        let word = self.word(id);
        self.names.namer.claim(&format!("{word}_k"))
    }

    fn describe(&self, id: NodeId) -> Option<String> {
        match self.tape[id].recurrence {
            Recurrence::Integral { function, argument, .. }
            | Recurrence::IntegralOver { function, argument, .. } => {
                self.function_of(function, argument)
            }
            _ => None,
        }
    }

    fn function_of(&self, function: Function, argument: NodeId) -> Option<String> {
        Some(format!("{}_{}", function.name(), self.telling(argument)?))
    }

    /// Returns the name of a node, if it is descriptive.
    fn telling(&self, id: NodeId) -> Option<String> {
        let name = self.values[index(id)].as_ref()?.to_string();
        let is_number = name.strip_prefix('t').is_some_and(|rest| rest.parse::<u32>().is_ok());
        (!is_number && syn::parse_str::<Ident>(&name).is_ok()).then_some(name)
    }

    /// Returns a word for a node, descriptive or not.
    fn word(&self, id: NodeId) -> String {
        let name = self.values[index(id)].as_ref().map(ToString::to_string);
        let name = name.filter(|name| syn::parse_str::<Ident>(name).is_ok());
        name.unwrap_or_else(|| format!("n{}", id.0))
    }
}

fn index(id: NodeId) -> usize {
    id.0 as usize
}

fn zero() -> TokenStream {
    quote!(R::literal(0.0))
}

/// Returns the pattern `[a, _, c]` of the names that are read.
fn pattern(names: &[Ident], read: &BTreeSet<usize>) -> Option<TokenStream> {
    let last = *read.last()?;
    let entries = names.iter().enumerate().take(last + 1);
    let entries =
        entries.map(|(at, name)| if read.contains(&at) { quote!(#name) } else { quote!(_) });
    let rest = (last + 1 < names.len()).then(|| quote!(, ..));
    Some(quote!([#(#entries),* #rest]))
}

/// Returns a sum, difference or negation of coefficients, some of which are zero, and whether it
/// needs no `let`.
fn linear(
    recurrence: &Recurrence,
    of: impl Fn(NodeId) -> Option<TokenStream>,
) -> (Option<TokenStream>, bool) {
    match *recurrence {
        Recurrence::Add(a, b) => match (of(a), of(b)) {
            (Some(a), Some(b)) => (Some(quote!(#a + #b)), false),
            (one, other) => (one.or(other), true),
        },
        Recurrence::Sub(a, b) => match (of(a), of(b)) {
            (Some(a), Some(b)) => (Some(quote!(#a - #b)), false),
            (None, Some(b)) => (Some(quote!(-#b)), false),
            (a, None) => (a, true),
        },
        Recurrence::Neg(a) => (of(a).map(|a| quote!(-#a)), false),
        _ => (None, true),
    }
}

/// Returns the receiver of a method call. It is in parentheses if it is more than a name or a
/// call, because the call would bind only to a part of it.
fn receiver(tokens: &TokenStream) -> TokenStream {
    match syn::parse2(tokens.clone()) {
        Ok(syn::Expr::Binary(_) | syn::Expr::Unary(_)) => quote!((#tokens)),
        _ => tokens.clone(),
    }
}
