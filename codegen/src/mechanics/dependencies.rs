//! Dependencies between outputs, equations, states and parameters of a scene.
//!
//! Excluded: drawing.

use std::collections::{BTreeSet, HashMap};

use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, ParameterId, Symbol};
use serde::{Deserialize, Serialize};

use crate::mechanics::lagrange::EquationsOfMotion;
use machinist_model::{Reduction, What};

/// A graph of dependencies.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Dependencies {
    /// The nodes, column by column.
    pub nodes: Vec<Node>,
    /// Edges from a dependent node to the node it needs, by index in `nodes`.
    pub edges: Vec<(usize, usize)>,
}

/// Columns of the graph, from outputs to parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Column {
    /// An output.
    Output,
    /// The equation for the rate of a velocity or of a first-order state.
    Equation,
    /// An entry of the state.
    State,
    /// A parameter.
    Parameter,
}

/// A node of the graph.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Node {
    /// Its column.
    pub column: Column,
    /// The name in the spec, with a prime for equations.
    pub name: String,
    /// True if it remains after reduction.
    pub kept: bool,
}

impl Dependencies {
    /// Returns the graph of a whole scene, with the quantities of `reduction` marked as left out.
    #[must_use]
    pub fn new(whole: &EquationsOfMotion, reduction: &Reduction) -> Self {
        let mut graph = Dependencies::default();
        let mut known: HashMap<(Column, Symbol), usize> = HashMap::new();
        let mut left_out: HashMap<&str, Vec<What>> = HashMap::new();
        for thing in &reduction.left_out {
            left_out.entry(&thing.name).or_default().push(thing.what);
        }
        let is_kept = |what: What, name: &str| {
            !left_out.get(name).is_some_and(|things| things.contains(&what))
        };
        let mut add = |column, symbol, name: &str, kept| {
            known.entry((column, symbol)).or_insert(graph.nodes.len());
            graph.nodes.push(Node { column, name: name.to_owned(), kept });
        };
        for output in &whole.system.outputs {
            add(Column::Output, Symbol::Time, &output.quantity.name.path, true);
        }
        let states = || whole.layout.states.iter();
        for state in states() {
            let symbol = state.motion.symbol();
            if !matches!(symbol, Symbol::Coordinate(_)) {
                let name = &state.quantity.name.path;
                add(Column::Equation, symbol, &format!("{name}'"), is_kept(What::State, name));
            }
        }
        for state in states() {
            let name = &state.quantity.name.path;
            add(Column::State, state.motion.symbol(), name, is_kept(What::State, name));
        }
        for (id, parameter) in (0..).zip(&whole.system.parameters) {
            let name = &parameter.quantity.name.path;
            let symbol = Symbol::Parameter(ParameterId(id));
            add(Column::Parameter, symbol, name, is_kept(What::Parameter, name));
        }
        let place = |column, symbol| known.get(&(column, symbol)).copied();
        let mut edges = BTreeSet::new();
        let mut connect = |from: usize, expr: &Expr| {
            for symbol in expr.symbols() {
                let to = match symbol {
                    Symbol::Acceleration(id) => place(Column::Equation, Symbol::Velocity(id)),
                    Symbol::Parameter(_) => place(Column::Parameter, symbol),
                    symbol => place(Column::State, symbol),
                };
                edges.extend(to.map(|to| (from, to)));
            }
        };
        for (index, output) in whole.outputs.iter().enumerate() {
            connect(index, output);
        }
        for (row, force) in whole.forcing.iter().enumerate() {
            let symbol = Symbol::Velocity(CoordinateId(row as u32));
            if let Some(from) = place(Column::Equation, symbol) {
                connect(from, force);
                whole.mass_matrix.row(row).iter().for_each(|(_, entry)| connect(from, entry));
            }
        }
        for (row, rate) in whole.rates.iter().enumerate() {
            let symbol = Symbol::FirstOrder(FirstOrderId(row as u32));
            if let Some(from) = place(Column::Equation, symbol) {
                connect(from, rate);
            }
        }
        graph.edges = edges.into_iter().collect();
        graph
    }
}
