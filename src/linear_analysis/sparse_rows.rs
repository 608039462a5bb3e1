//! Sparse matrices by rows.

use std::iter::Sum;
use std::ops::Mul;

use machinist_contract::SparsityPattern;
use nalgebra::{DMatrix, DVector, Scalar};

/// A sparse matrix by rows.
#[derive(Debug, Clone)]
pub(super) struct SparseRows {
    columns: usize,
    /// Index of the first entry of each row, and the number of entries.
    starts: Vec<usize>,
    /// (column, entry) of all rows in turn, with ascending columns.
    entries: Vec<(usize, f64)>,
}

impl SparseRows {
    /// Creates a matrix without rows.
    pub(super) fn new(columns: usize) -> Self {
        Self { columns, starts: vec![0], entries: Vec::new() }
    }

    /// Adds a row by its entries, with ascending columns; zeros are left out.
    pub(super) fn push(&mut self, row: impl IntoIterator<Item = (usize, f64)>) {
        self.entries.extend(row.into_iter().filter(|(_, entry)| *entry != 0.0));
        self.starts.push(self.entries.len());
    }

    /// Adds a row by its entries, with each column once; zeros are left out.
    pub(super) fn push_in_any_order(&mut self, mut row: Vec<(usize, f64)>) {
        row.sort_unstable_by_key(|(column, _)| *column);
        self.push(row);
    }

    /// Converts a dense matrix.
    pub(super) fn of(matrix: &DMatrix<f64>) -> Self {
        let mut rows = Self::new(matrix.ncols());
        for row in matrix.row_iter() {
            rows.push(row.iter().copied().enumerate());
        }
        rows
    }

    /// Creates a matrix from values at the entries of a pattern, each of which occurs once.
    pub(super) fn of_pattern(pattern: SparsityPattern<'_>, values: &[f64]) -> Self {
        let mut rows = vec![Vec::new(); pattern.rows];
        for (&(row, column), value) in pattern.entries.iter().zip(values) {
            rows[row as usize].push((column as usize, *value));
        }
        let mut whole = Self::new(pattern.columns);
        for row in rows {
            whole.push_in_any_order(row);
        }
        whole
    }

    pub(super) fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn columns(&self) -> usize {
        self.columns
    }

    /// Returns (column, entry) of a row, ascending.
    pub(super) fn row(&self, row: usize) -> &[(usize, f64)] {
        &self.entries[self.starts[row]..self.starts[row + 1]]
    }

    /// Returns all rows in turn.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[(usize, f64)]> {
        (0..self.rows()).map(|row| self.row(row))
    }

    /// Returns the matrix with each entry replaced by `factor` of row, column and entry.
    pub(super) fn scaled(mut self, factor: impl Fn(usize, usize, f64) -> f64) -> Self {
        for row in 0..self.rows() {
            for (column, entry) in &mut self.entries[self.starts[row]..self.starts[row + 1]] {
                *entry = factor(row, *column, *entry);
            }
        }
        self
    }

    /// Returns the dense matrix.
    pub(super) fn full(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.rows(), self.columns);
        for (row, entries) in self.iter().enumerate() {
            for (column, entry) in entries {
                matrix[(row, *column)] = *entry;
            }
        }
        matrix
    }

    /// Returns A x.
    pub(super) fn times<T>(&self, vector: &DVector<T>) -> DVector<T>
    where
        T: Scalar + Copy + Mul<f64, Output = T> + Sum,
    {
        let row = |row: usize| self.row(row).iter().map(|(at, entry)| vector[*at] * *entry).sum();
        DVector::from_fn(self.rows(), |index, _| row(index))
    }

    /// Returns the Frobenius norm.
    pub(super) fn norm(&self) -> f64 {
        self.entries.iter().map(|(_, entry)| entry * entry).sum::<f64>().sqrt()
    }
}
