//! Random systems, built like a composed scene, without text.

use std::fmt;

use machinist_algebra::expr::{
    ConstraintId, CoordinateId, Expr, FirstOrderId, Function, ParameterId, Symbol,
};
use machinist_model::{Freeze, Name, Quantity, RunDefaults, Table, TableId};
use num_rational::BigRational;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::mechanics::reduce::Keep;
use crate::scene::system::{
    Constraint, Coordinate, Definition, FirstOrderState, GeneralizedForce, LagrangianSystem,
    Parameter,
};
use crate::spatial::orientation::Orientations;

/// A term: a function of positions, time and states, the coordinates, velocities and states it
/// takes, and a factor.
#[derive(Clone)]
pub struct Piece {
    function: u8,
    of: [u8; 3],
    factor: i8,
}

impl fmt::Debug for Piece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [i, j, k] = self.of;
        write!(f, "({} of {i} {j} {k}, {})", self.function, self.factor)
    }
}

/// Recipe of a system. It stays valid if any list is shortened and any number reduced, so a
/// failure can be shrunk to what it needs.
#[derive(Debug, Clone)]
pub struct Recipe {
    coordinates: usize,
    states: usize,
    /// Only differences of positions matter, with a ratio that is 1, 2 or a parameter.
    relative: Option<u8>,
    kinetic: Vec<Piece>,
    gyroscopic: Vec<Piece>,
    potential: Vec<Piece>,
    dissipation: Vec<Piece>,
    forces: Vec<Piece>,
    rates: Vec<Piece>,
    constraints: Vec<(Piece, bool, Option<u8>)>,
    outputs: Vec<Piece>,
    tunable: u8,
    /// Extent of reduction.
    pub keep: Keep,
}

const PARAMETERS: usize = 6;
const MODES: usize = 1;
/// Number of functions that terms are made of; the last ones are rarer.
const FUNCTIONS: u8 = 28;
const COMMON: u8 = 16;

/// Returns systems of one to six coordinates, with up to `most` terms of a kind; few large ones.
pub fn recipes(most: usize) -> impl Strategy<Value = Recipe> {
    let coordinates = prop_oneof![
        4 => 1..=2_usize,
        4 => 3..=4_usize,
        1 => 5..=6_usize,
    ];
    let pieces = |most| vec(piece(), 0..=most);
    let keep = prop_oneof![
        Just(Keep::All),
        Just(Keep::Tunable),
        Just(Keep::Reachable),
        Just(Keep::Exact),
        Just(Keep::Exact)
    ];
    let held = (piece(), any::<bool>(), prop::option::of(0..2_u8));
    let shape = (coordinates, 0..=2_usize, prop::option::of(0..3_u8), any::<u8>(), keep);
    let energies = (pieces(most), pieces(most), pieces(most + 1), pieces(most));
    let others = (pieces(most), pieces(most + 1), vec(held, 0..=2), pieces(most + 1));
    (shape, energies, others).prop_map(|(shape, energies, others)| {
        let (coordinates, states, mut relative, tunable, keep) = shape;
        let (kinetic, gyroscopic, potential, dissipation) = energies;
        let (forces, rates, mut constraints, outputs) = others;
        // Each constraint holds another coordinate, and one remains free.
        constraints.truncate(coordinates - 1);
        // Positions are left out only without constraints.
        if keep == Keep::Exact && tunable >= 64 {
            constraints.clear();
            relative = relative.or(Some(0));
        }
        Recipe {
            coordinates,
            states,
            relative,
            kinetic,
            gyroscopic,
            potential,
            dissipation,
            forces,
            rates,
            constraints,
            outputs,
            tunable,
            keep,
        }
    })
}

fn piece() -> impl Strategy<Value = Piece> {
    let factor = prop_oneof![-6..=-1_i8, 1..=6_i8];
    let function = prop_oneof![3 => 0..COMMON, 1 => COMMON..FUNCTIONS];
    (function, any::<[u8; 3]>(), factor).prop_map(|(function, of, factor)| Piece {
        function,
        of,
        factor,
    })
}

fn sum(terms: Vec<Expr>) -> Expr {
    match terms.len() {
        0 => Expr::integer(0),
        _ => Expr::Sum(terms),
    }
}

fn product(factors: Vec<Expr>) -> Expr {
    Expr::Product(factors)
}

fn power(base: Expr, twice: i64) -> Expr {
    let exponent = BigRational::new(twice.into(), 2.into());
    Expr::Power(Box::new(base), Box::new(Expr::Number(exponent)))
}

fn square(base: Expr) -> Expr {
    power(base, 4)
}

fn call(function: Function, argument: Expr) -> Expr {
    Expr::Call(function, vec![argument])
}

fn quantity(own: &str) -> Quantity {
    let name = Name { path: format!("m.{own}"), ident: format!("m_{own}"), latex: own.to_owned() };
    Quantity { name, unit: "1".to_owned(), doc: String::new() }
}

impl Recipe {
    fn coordinate(&self, index: u8) -> CoordinateId {
        CoordinateId(u32::from(index) % self.coordinates as u32)
    }

    fn velocity(&self, index: u8) -> Expr {
        Expr::Symbol(Symbol::Velocity(self.coordinate(index)))
    }

    /// Returns a position, or one relative to the first.
    fn position(&self, index: u8) -> Expr {
        let symbol = |id| Expr::Symbol(Symbol::Coordinate(CoordinateId(id)));
        let CoordinateId(id) = self.coordinate(index);
        let Some(ratio) = self.relative.filter(|_| self.coordinates > 1) else {
            return symbol(id);
        };
        let ratio = match ratio {
            0 => Expr::integer(-1),
            1 => Expr::integer(-2),
            _ => product(vec![Expr::integer(-1), parameter(5)]),
        };
        Expr::Sum(vec![symbol(id.max(1)), product(vec![ratio, symbol(0)])])
    }

    fn state(&self, index: u8) -> Expr {
        match self.states {
            0 => Expr::integer(1),
            count => Expr::Symbol(Symbol::FirstOrder(FirstOrderId(
                (MODES + usize::from(index) % count) as u32,
            ))),
        }
    }

    /// Returns a function of positions and time, and of first-order states if allowed.
    fn function(&self, piece: &Piece, with_states: bool) -> Expr {
        let [i, j, _] = piece.of;
        let (x, y) = (self.position(i), self.position(j));
        let difference = Expr::Sum(vec![x.clone(), product(vec![Expr::integer(-1), y.clone()])]);
        let time = || Expr::Symbol(Symbol::Time);
        let plus = |n: i64, e: Expr| Expr::Sum(vec![Expr::integer(n), e]);
        match piece.function {
            0 => x,
            1 => call(Function::Cos, x),
            2 => call(Function::Sin, difference),
            3 => power(plus(2, call(Function::Cos, difference)), -2),
            4 => power(plus(1, square(x)), -2),
            5 => call(Function::Exp, product(vec![Expr::integer(-1), square(x)])),
            6 => product(vec![x, y]),
            7 => call(Function::Sin, Expr::Sum(vec![product(vec![Expr::integer(3), time()]), x])),
            8 => power(plus(2, call(Function::Sin, x)), 1),
            9 => call(Function::Tanh, difference),
            10 => power(difference, 6),
            11 if with_states => self.state(j),
            12 if with_states => product(vec![square(self.state(j)), call(Function::Cos, x)]),
            13 => call(Function::Atan, product(vec![parameter(j), x])),
            14 => product(vec![call(Function::Cos, time()), x]),
            15 => {
                let mode = Expr::Symbol(Symbol::FirstOrder(FirstOrderId(0)));
                let half = Expr::Number(BigRational::new(1.into(), 2.into()));
                Expr::Call(Function::SelectLess, vec![mode, half, x, y])
            }
            // Roots of expressions that are negative half of the time, multiplied out again.
            16 => power(square(x), 1),
            17 => power(square(difference), 3),
            18 => call(Function::Abs, product(vec![x, y])),
            19 => call(Function::Ln, plus(2, square(x))),
            20 => call(Function::Asin, call(Function::Tanh, x)),
            21 => call(Function::Sqrt, plus(1, call(Function::Cosh, x))),
            22 => Expr::Call(Function::SelectLess, vec![x.clone(), y.clone(), x, y]),
            23 => power(plus(3, square(difference)), -3),
            24 => Expr::Call(Function::Table { table: TableId(0), order: 0 }, vec![x]),
            25 => call(Function::Tan, call(Function::Atan, difference)),
            26 => power(call(Function::Exp, x), 1),
            27 => call(
                Function::Exp,
                product(vec![Expr::integer(2), call(Function::Ln, power(square(x), 1))]),
            ),
            _ => Expr::integer(1),
        }
    }

    fn factor(piece: &Piece) -> Expr {
        let number = Expr::Number(BigRational::new(piece.factor.into(), 4.into()));
        match piece.of[2] % 3 {
            0 => number,
            1 => product(vec![number, parameter(piece.of[2])]),
            _ => product(vec![number, power(parameter(piece.of[2]), -2)]),
        }
    }

    fn term(&self, piece: &Piece) -> Expr {
        product(vec![Self::factor(piece), self.function(piece, true)])
    }

    /// Returns T: each coordinate has a mass, and each piece adds p (q_i' + f q_j')^2/2.
    fn kinetic(&self) -> Expr {
        let half = |e: Expr| product(vec![Expr::Number(BigRational::new(1.into(), 2.into())), e]);
        let own = (0..self.coordinates as u8)
            .map(|i| half(product(vec![parameter(i), square(self.velocity(i))])));
        let coupled = self.kinetic.iter().map(|piece| {
            let [i, j, k] = piece.of;
            let share = product(vec![self.term(piece), self.velocity(j)]);
            let both = Expr::Sum(vec![self.velocity(i), share]);
            half(product(vec![parameter(k), square(both)]))
        });
        let gyroscopic = self.gyroscopic.iter();
        let gyroscopic = gyroscopic.map(|p| product(vec![self.term(p), self.velocity(p.of[2])]));
        sum(own.chain(coupled).chain(gyroscopic).collect())
    }

    fn dissipation(&self) -> Expr {
        let each = self.dissipation.iter().map(|piece| {
            let [i, j, _] = piece.of;
            let other = product(vec![Expr::integer(-1), self.velocity(j)]);
            let slip = Expr::Sum(vec![self.velocity(i), other]);
            product(vec![self.term(piece), square(slip)])
        });
        sum(each.collect())
    }

    fn force(&self, coordinate: usize) -> Expr {
        let own = self
            .forces
            .iter()
            .filter(|piece| self.coordinate(piece.of[2]) == CoordinateId(coordinate as u32));
        sum(own.map(|p| product(vec![self.term(p), self.velocity(p.of[1])])).collect())
    }

    fn rate(&self, state: usize) -> Expr {
        let own = self.rates.iter().enumerate().filter(|(k, _)| k % self.states == state);
        let own = own.map(|(_, p)| {
            Expr::Sum(vec![self.term(p), product(vec![Self::factor(p), self.velocity(p.of[0])])])
        });
        let decay = product(vec![Expr::integer(-1), self.state(state as u8)]);
        sum(own.chain([decay]).collect())
    }

    /// Returns the k-th constraint, which holds the (k + 1)-th coordinate, by its position or its
    /// velocity.
    fn constraint(&self, k: usize) -> Constraint {
        let (piece, is_of_positions, mode) = &self.constraints[k];
        let id = CoordinateId(k as u32 + 1);
        let part = product(vec![Self::factor(piece), self.function(piece, false)]);
        let expr = if *is_of_positions {
            let own = product(vec![Expr::integer(20), Expr::Symbol(Symbol::Coordinate(id))]);
            Expr::Sum(vec![own, part])
        } else {
            let own = product(vec![Expr::integer(20), Expr::Symbol(Symbol::Velocity(id))]);
            let other = product(vec![part, Expr::Symbol(Symbol::Velocity(CoordinateId(0)))]);
            Expr::Sum(vec![own, other, call(Function::Sin, Expr::Symbol(Symbol::Time))])
        };
        // The function of the mode would depend on a state.
        let expr = expr.replace(&|symbol| {
            (symbol == Symbol::FirstOrder(FirstOrderId(0))).then(|| Expr::integer(0))
        });
        Constraint {
            name: quantity(&format!("c{k}")).name,
            doc: String::new(),
            unit: "1".to_owned(),
            expr,
            is_of_positions: *is_of_positions,
            when: mode.iter().map(|mode| (FirstOrderId(0), i32::from(*mode))).collect(),
            is_dropped: false,
            friction: None,
        }
    }

    fn output(&self, index: usize) -> Definition {
        let piece = &self.outputs[index];
        let [i, j, k] = piece.of;
        let coordinate = self.coordinate(i);
        let other = match k % 4 {
            0 => Expr::Symbol(Symbol::Acceleration(coordinate)),
            1 if !self.constraints.is_empty() => {
                let count = self.constraints.len() as u32;
                Expr::Symbol(Symbol::Multiplier(ConstraintId(u32::from(j) % count)))
            }
            2 => Expr::Symbol(Symbol::Coordinate(coordinate)),
            _ => self.velocity(j),
        };
        let expr = Expr::Sum(vec![self.term(piece), other]);
        Definition { quantity: quantity(&format!("o{index}")), expr }
    }

    /// Returns the system.
    pub fn system(&self) -> LagrangianSystem {
        let n = self.coordinates;
        let start = |k: usize| Expr::Number(BigRational::new((k as i64 - 2).into(), 8.into()));
        let coordinates = (0..n).map(|k| Coordinate {
            position: quantity(&format!("q{k}")),
            velocity: quantity(&format!("q{k}_dot")),
            identified: Vec::new(),
            initial: [start(k), start(k + 3)],
            is_given: [true; 2],
            scale: [1.0; 2],
        });
        let first_order = |name: String, rate: Expr, is_mode: bool| FirstOrderState {
            quantity: quantity(&name),
            rate,
            initial: Expr::integer(1),
            scale: 1.0,
            is_mode,
        };
        let mode = first_order("mode".to_owned(), Expr::integer(0), true);
        let states = (0..self.states).map(|k| first_order(format!("z{k}"), self.rate(k), false));
        let parameters = (0..PARAMETERS).map(|k| Parameter {
            quantity: quantity(&format!("p{k}")),
            value: 0.6 + 0.35 * k as f64,
            tunable: self.tunable & (1 << k) != 0,
        });
        let nothing = || Expr::integer(0);
        LagrangianSystem {
            name: "random".to_owned(),
            title: String::new(),
            doc: String::new(),
            source: String::new(),
            shares_redundant: false,
            coordinates: coordinates.collect(),
            first_order: std::iter::once(mode).chain(states).collect(),
            parameters: parameters.collect(),
            handed: Vec::new(),
            kinetic: self.kinetic(),
            potential: sum(self.potential.iter().map(|piece| self.term(piece)).collect()),
            mechanisms: Vec::new(),
            drawing: Vec::new(),
            orientations: Orientations::default(),
            scalars: Vec::new(),
            springs: Vec::new(),
            dissipation: self.dissipation(),
            generalized_force: (0..n)
                .map(|k| GeneralizedForce { total: self.force(k), conversion: nothing() })
                .collect(),
            stored_energy: nothing(),
            supplied_power: nothing(),
            dissipated_power: nothing(),
            helpers: Vec::new(),
            outputs: (0..self.outputs.len()).map(|k| self.output(k)).collect(),
            checks: Vec::new(),
            tables: vec![table()],
            discontinuities: Vec::new(),
            events: Vec::new(),
            constraints: (0..self.constraints.len()).map(|k| self.constraint(k)).collect(),
            run: RunDefaults {
                from: 0.0,
                until: 2.0,
                points: 2,
                times: Vec::new(),
                rtol: 1e-6,
                method: "dop853".to_owned(),
            },
            freeze: Freeze::default(),
            fields: Vec::new(),
            starts_in_equilibrium: false,
            warnings: Vec::new(),
            notes: Vec::new(),
            requirements: Vec::new(),
            files: Vec::new(),
        }
    }
}

/// Returns a table of a few cubics, constant beyond 1.5.
fn table() -> Table {
    let knots: Vec<f64> = (0..7).map(|k| 0.5 * f64::from(k) - 1.5).collect();
    let coefficients = (0..6_u8).map(|k| {
        let k = f64::from(k);
        [(2.0 * k).sin(), k.cos(), 0.3 * k - 0.7, (3.0 * k).cos()]
    });
    Table { name: quantity("table").name, knots, coefficients: coefficients.collect() }
}

fn parameter(index: u8) -> Expr {
    Expr::Symbol(Symbol::Parameter(ParameterId(u32::from(index) % PARAMETERS as u32)))
}
