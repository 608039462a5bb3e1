//! Matrices of expressions, of which most are zero.

use super::Expr;

/// Rows of (column, entry), columns ascending; what is not there is zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Matrix {
    rows: Vec<Vec<(usize, Expr)>>,
}

impl Matrix {
    /// Adds a row, its columns ascending; entries that are zero are left out.
    pub fn push(&mut self, row: impl IntoIterator<Item = (usize, Expr)>) {
        self.rows.push(row.into_iter().filter(|(_, entry)| !entry.is_zero()).collect());
    }

    /// Adds entries behind those of a row.
    pub fn extend_row(&mut self, row: usize, entries: impl IntoIterator<Item = (usize, Expr)>) {
        self.rows[row].extend(entries.into_iter().filter(|(_, entry)| !entry.is_zero()));
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// (column, entry) of a row.
    #[must_use]
    pub fn row(&self, row: usize) -> &[(usize, Expr)] {
        &self.rows[row]
    }

    /// All rows.
    pub fn rows(&self) -> impl Iterator<Item = &[(usize, Expr)]> {
        self.rows.iter().map(Vec::as_slice)
    }

    /// An entry, if it is there.
    #[must_use]
    pub fn entry(&self, row: usize, column: usize) -> Option<&Expr> {
        let row = &self.rows[row];
        let place = row.binary_search_by_key(&column, |(column, _)| *column).ok()?;
        Some(&row[place].1)
    }

    /// Every entry, row after row.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        self.rows.iter().flatten().map(|(_, entry)| entry)
    }

    /// Every entry, to be changed.
    pub fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.rows.iter_mut().flatten().map(|(_, entry)| entry)
    }
}
