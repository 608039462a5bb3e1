//! Inverse of a small dense matrix, by Gauss-Jordan elimination with full pivoting.
//!
//! The matrix is scaled first, row by row, then column by column, so that units of measure do not
//! affect the choice of pivots.

use machinist_contract::Real;

/// Limit of pivots relative to entries of size 1.
const SINGULAR: f64 = 1e-11;

/// Returns the inverse; `None` if the matrix is singular according to its numbers.
pub fn inverse<R: Real>(mut matrix: Vec<Vec<R>>, to_f64: fn(R) -> f64) -> Option<Vec<Vec<R>>> {
    let n = matrix.len();
    let size = |value: R| to_f64(value).abs();
    let mut rows = vec![R::literal(1.0); n];
    let mut columns = vec![R::literal(1.0); n];
    for _ in 0..2 {
        for i in 0..n {
            let factor = scale(matrix[i].iter().map(|entry| size(*entry)))?;
            rows[i] = rows[i] * R::literal(factor);
            for entry in &mut matrix[i] {
                *entry = *entry * R::literal(factor);
            }
        }
        for j in 0..n {
            let factor = scale(matrix.iter().map(|row| size(row[j])))?;
            columns[j] = columns[j] * R::literal(factor);
            for row in &mut matrix {
                row[j] = row[j] * R::literal(factor);
            }
        }
    }
    let of_scaled = gauss_jordan(matrix, to_f64)?;
    let unscaled = of_scaled.into_iter().zip(columns).map(|(row, column)| {
        row.into_iter().zip(&rows).map(|(entry, row)| column * entry * *row).collect()
    });
    Some(unscaled.collect())
}

/// Returns the power of two that scales the largest size to between 1/2 and 1; `None` if it is 0
/// or not finite.
fn scale(sizes: impl Iterator<Item = f64>) -> Option<f64> {
    let mut largest = 0.0_f64;
    for size in sizes {
        if !size.is_finite() {
            return None;
        }
        largest = largest.max(size);
    }
    (largest > 0.0).then(|| largest.log2().ceil().exp2().recip())
}

fn gauss_jordan<R: Real>(mut a: Vec<Vec<R>>, to_f64: fn(R) -> f64) -> Option<Vec<Vec<R>>> {
    let n = a.len();
    let unit = |i: usize| (0..n).map(move |j| R::literal(if i == j { 1.0 } else { 0.0 }));
    let mut inverse: Vec<Vec<R>> = (0..n).map(|i| unit(i).collect()).collect();
    // The row that is solved for each column.
    let mut row_of = vec![usize::MAX; n];
    let mut used = vec![false; n];
    for _ in 0..n {
        let mut best = (SINGULAR, 0, 0);
        for (i, row) in a.iter().enumerate().filter(|(i, _)| !used[*i]) {
            for (j, entry) in row.iter().enumerate().filter(|(j, _)| row_of[*j] == usize::MAX) {
                let size = to_f64(*entry).abs();
                if size > best.0 {
                    best = (size, i, j);
                }
            }
        }
        let (size, i, j) = best;
        if size <= SINGULAR {
            return None;
        }
        (used[i], row_of[j]) = (true, i);
        let pivot = R::literal(1.0) / a[i][j];
        a[i].iter_mut().chain(&mut inverse[i]).for_each(|entry| *entry = *entry * pivot);
        let (row, own) = (a[i].clone(), inverse[i].clone());
        for k in (0..n).filter(|k| *k != i) {
            let factor = a[k][j];
            if to_f64(factor) == 0.0 {
                continue;
            }
            let entries = a[k].iter_mut().zip(&row).chain(inverse[k].iter_mut().zip(&own));
            entries.for_each(|(entry, other)| *entry = *entry - factor * *other);
        }
    }
    Some(row_of.into_iter().map(|row| std::mem::take(&mut inverse[row])).collect())
}

#[cfg(test)]
mod tests {
    use super::inverse;

    #[test]
    fn a_bordered_matrix_of_any_units() {
        let matrix = vec![vec![2e9, 1e-3, -1.0], vec![1e-3, 4e-9, -3e4], vec![1.0, 3e4, 0.0]];
        let found = inverse(matrix.clone(), |x| x).expect("it has one");
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (row, expected) in matrix.iter().zip(identity) {
            for (j, expected) in expected.into_iter().enumerate() {
                let products = row.iter().zip(&found).map(|(entry, column)| entry * column[j]);
                let size: f64 = products.clone().map(f64::abs).sum();
                let off = products.sum::<f64>() - expected;
                assert!(off.abs() < 1e-14 * size.max(1.0), "column {j}: {off}");
            }
        }
    }

    #[test]
    fn rows_that_say_the_same_have_no_inverse() {
        let same = vec![vec![1e6, 2e6], vec![1e-6, 2e-6]];
        assert!(inverse(same, |x| x).is_none());
        assert!(inverse(vec![vec![f64::NAN]], |x| x).is_none());
        assert!(inverse(vec![vec![0.0]], |x| x).is_none());
    }
}
