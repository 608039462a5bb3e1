//! Matrices of nodes, of which most are zero.

use std::collections::BTreeMap;

use machinist_algebra::expr::Graph;
use machinist_model::NodeId;

/// Nodes by row and column; what is not there is zero.
#[derive(Debug, Clone, Default)]
pub struct Nonzeros {
    rows: Vec<BTreeMap<usize, NodeId>>,
}

impl Nonzeros {
    /// So many rows without entries.
    pub fn new(rows: usize) -> Self {
        Self { rows: vec![BTreeMap::new(); rows] }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Entries of a row by column.
    pub fn row(&self, row: usize) -> &BTreeMap<usize, NodeId> {
        &self.rows[row]
    }

    /// An entry, if it is not zero.
    pub fn get(&self, row: usize, column: usize) -> Option<NodeId> {
        self.rows[row].get(&column).copied()
    }

    /// Makes an entry what it is now.
    pub fn set(&mut self, graph: &Graph, (row, column): (usize, usize), node: NodeId) {
        if graph.is_zero(node) {
            self.rows[row].remove(&column);
        } else {
            self.rows[row].insert(column, node);
        }
    }
}
