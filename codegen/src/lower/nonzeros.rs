//! Sparse matrices of nodes.

use std::collections::BTreeMap;

use machinist_algebra::expr::Graph;
use machinist_model::NodeId;

/// Nodes by row and column; missing entries are zero.
#[derive(Debug, Clone, Default)]
pub struct Nonzeros {
    rows: Vec<BTreeMap<usize, NodeId>>,
}

impl Nonzeros {
    /// Returns a matrix of `rows` empty rows.
    pub fn new(rows: usize) -> Self {
        Self { rows: vec![BTreeMap::new(); rows] }
    }

    /// Returns the number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns the entries of a row by column.
    pub fn row(&self, row: usize) -> &BTreeMap<usize, NodeId> {
        &self.rows[row]
    }

    /// Returns an entry, if it is not zero.
    pub fn get(&self, row: usize, column: usize) -> Option<NodeId> {
        self.rows[row].get(&column).copied()
    }

    /// Sets an entry.
    pub fn set(&mut self, graph: &Graph, (row, column): (usize, usize), node: NodeId) {
        if graph.is_zero(node) {
            self.rows[row].remove(&column);
        } else {
            self.rows[row].insert(column, node);
        }
    }
}
