//! Sparse matrices of expressions.

use super::Expr;

/// Rows of (column, entry) with ascending columns; missing entries are zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Matrix {
    rows: Vec<Vec<(usize, Expr)>>,
}

impl<Row: IntoIterator<Item = (usize, Expr)>> FromIterator<Row> for Matrix {
    /// Returns the matrix of rows as [`Matrix::push`] adds them.
    fn from_iter<Rows: IntoIterator<Item = Row>>(rows: Rows) -> Self {
        let mut matrix = Self::default();
        rows.into_iter().for_each(|row| matrix.push(row));
        matrix
    }
}

impl Matrix {
    /// Adds a row with ascending columns; zero entries are left out.
    pub fn push(&mut self, row: impl IntoIterator<Item = (usize, Expr)>) {
        self.rows.push(row.into_iter().filter(|(_, entry)| !entry.is_zero()).collect());
    }

    /// Adds entries behind those of a row.
    pub fn extend_row(&mut self, row: usize, entries: impl IntoIterator<Item = (usize, Expr)>) {
        self.rows[row].extend(entries.into_iter().filter(|(_, entry)| !entry.is_zero()));
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Returns (column, entry) of a row.
    #[must_use]
    pub fn row(&self, row: usize) -> &[(usize, Expr)] {
        &self.rows[row]
    }

    /// Returns all rows.
    pub fn rows(&self) -> impl Iterator<Item = &[(usize, Expr)]> {
        self.rows.iter().map(Vec::as_slice)
    }

    /// Returns an entry, or `None` if it is zero.
    #[must_use]
    pub fn entry(&self, row: usize, column: usize) -> Option<&Expr> {
        let row = &self.rows[row];
        let place = row.binary_search_by_key(&column, |(column, _)| *column).ok()?;
        Some(&row[place].1)
    }

    /// Returns all entries, row by row.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        self.rows.iter().flatten().map(|(_, entry)| entry)
    }

    /// Returns all entries for modification.
    pub fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.rows.iter_mut().flatten().map(|(_, entry)| entry)
    }
}
