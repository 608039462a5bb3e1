//! Lists for [`machinist_contract::elimination`], computed from a sparsity pattern.

use std::collections::BTreeSet;

use machinist_contract::elimination as contract;

/// The elimination of `I - scale J` for a pattern of `J`. The order of unknowns minimizes fill-in
/// greedily, one unknown at a time (Markowitz).
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Elimination {
    places: usize,
    entries: Vec<u32>,
    pivots: Vec<contract::Pivot>,
    rows: Vec<u32>,
    products: Vec<(u32, u32, u32)>,
    unknowns: Vec<contract::Unknown>,
    lower: Vec<(u32, u32)>,
    upper: Vec<(u32, u32)>,
}

/// Places of entries, numbered in the order of the requests.
struct Places {
    /// (column, place) of the entries of each row, sorted by column.
    rows: Vec<Vec<(u32, u32)>>,
    count: u32,
}

impl Places {
    fn of(&mut self, row: u32, column: u32) -> u32 {
        let entries = &mut self.rows[row as usize];
        match entries.binary_search_by_key(&column, |&(column, _)| column) {
            Ok(at) => entries[at].1,
            Err(at) => {
                entries.insert(at, (column, self.count));
                self.count += 1;
                self.count - 1
            }
        }
    }

    fn find(&self, row: u32, column: u32) -> Option<u32> {
        let entries = &self.rows[row as usize];
        let at = entries.binary_search_by_key(&column, |&(column, _)| column).ok()?;
        Some(entries[at].1)
    }
}

impl Elimination {
    /// Computes the lists from the structural nonzeros of a square matrix with `size` rows.
    #[must_use]
    pub fn new(size: usize, nonzeros: &[(u32, u32)]) -> Self {
        let mut places = Places { rows: vec![Vec::new(); size], count: 0 };
        let mut list = Self::default();
        (0..size as u32).for_each(|row| {
            places.of(row, row);
        });
        list.entries = nonzeros.iter().map(|&(row, column)| places.of(row, column)).collect();
        let order = list.eliminate(size, &mut places);
        list.places = places.count as usize;
        list.substitute(&order, &places);
        list
    }

    /// Eliminates every unknown and returns their order.
    fn eliminate(&mut self, size: usize, places: &mut Places) -> Vec<u32> {
        // Rows and columns of the remaining matrix.
        let mut rows: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); size];
        let mut columns: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); size];
        for (row, entries) in places.rows.iter().enumerate() {
            for &(column, _) in entries.iter().filter(|(column, _)| *column as usize != row) {
                rows[row].insert(column);
                columns[column as usize].insert(row as u32);
            }
        }
        let mut left: BTreeSet<u32> = (0..size as u32).collect();
        let mut order = Vec::with_capacity(size);
        let cost = |rows: &[BTreeSet<u32>], columns: &[BTreeSet<u32>], unknown: u32| {
            rows[unknown as usize].len() * columns[unknown as usize].len()
        };
        while let Some(&pivot) = left.iter().min_by_key(|&&unknown| cost(&rows, &columns, unknown))
        {
            left.remove(&pivot);
            order.push(pivot);
            let of_row = std::mem::take(&mut rows[pivot as usize]);
            let of_column = std::mem::take(&mut columns[pivot as usize]);
            for &row in &of_column {
                self.rows.push(places.of(row, pivot));
            }
            for &row in &of_column {
                rows[row as usize].remove(&pivot);
                for &column in &of_row {
                    let factors = (places.of(row, pivot), places.of(pivot, column));
                    let place = places.of(row, column);
                    self.products.push((place, factors.0, factors.1));
                    if row != column {
                        rows[row as usize].insert(column);
                        columns[column as usize].insert(row);
                    }
                }
            }
            for &column in &of_row {
                columns[column as usize].remove(&pivot);
            }
            self.pivots.push(contract::Pivot {
                place: places.of(pivot, pivot),
                rows_end: self.rows.len() as u32,
                products_end: self.products.len() as u32,
            });
        }
        order
    }

    /// Lists the terms of the substitution.
    fn substitute(&mut self, order: &[u32], places: &Places) {
        let mut rank = vec![0; order.len()];
        for (at, &unknown) in order.iter().enumerate() {
            rank[unknown as usize] = at;
        }
        let side = |unknown: u32, is_lower: bool| {
            let entries = places.rows[unknown as usize].iter();
            let at = rank[unknown as usize];
            let of = |&&(column, _): &&(u32, u32)| {
                let of = rank[column as usize];
                if is_lower { of < at } else { of > at }
            };
            entries.filter(of).map(|&(column, place)| (place, column)).collect::<Vec<_>>()
        };
        let ends: Vec<u32> = order
            .iter()
            .map(|&unknown| {
                self.lower.extend(side(unknown, true));
                self.lower.len() as u32
            })
            .collect();
        for (&unknown, &end) in order.iter().zip(&ends) {
            let diagonal = places.find(unknown, unknown).unwrap_or_default();
            self.unknowns.push(contract::Unknown { row: unknown, diagonal, terms_end: [end, 0] });
        }
        for at in (0..order.len()).rev() {
            self.upper.extend(side(order[at], false));
            self.unknowns[at].terms_end[1] = self.upper.len() as u32;
        }
    }

    /// Returns the lists as the contract takes them.
    #[must_use]
    pub fn borrowed(&self) -> contract::Elimination<'_> {
        contract::Elimination {
            places: self.places,
            entries: &self.entries,
            pivots: &self.pivots,
            rows: &self.rows,
            products: &self.products,
            unknowns: &self.unknowns,
            lower: &self.lower,
            upper: &self.upper,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Elimination;

    /// Returns a value for an entry, always the same for the same entry.
    fn value(row: u32, column: u32) -> f64 {
        (f64::from(row) * 1.7 + f64::from(column) * 2.9 + 0.3).sin()
    }

    /// Solves by the lists and returns the largest residual.
    fn residual(size: usize, nonzeros: &[(u32, u32)]) -> f64 {
        let list = Elimination::new(size, nonzeros);
        let of = list.borrowed();
        let jacobian: Vec<f64> = nonzeros.iter().map(|&(row, column)| value(row, column)).collect();
        let (scale, b) = (0.1, (0..size).map(|k| 1.0 + k as f64).collect::<Vec<_>>());
        let mut factors = vec![f64::NAN; of.places];
        of.factor(scale, &jacobian, &mut factors);
        let mut x = b.clone();
        of.solve(&factors, &mut x);
        let mut left: Vec<f64> = x.iter().zip(&b).map(|(x, b)| x - b).collect();
        for (&(row, column), value) in nonzeros.iter().zip(&jacobian) {
            left[row as usize] -= scale * value * x[column as usize];
        }
        left.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    }

    #[test]
    fn what_it_solves_fulfils_the_equations() {
        let chain: Vec<(u32, u32)> =
            (0..12).flat_map(|k: u32| [(k, k), (k, (k + 1) % 12), ((k + 1) % 12, k)]).collect();
        let arrow: Vec<(u32, u32)> = (0..9).flat_map(|k: u32| [(0, k), (k, 0), (k, k)]).collect();
        let mut arrow = arrow;
        arrow.sort_unstable();
        arrow.dedup();
        let full: Vec<(u32, u32)> = (0..6).flat_map(|r| (0..6).map(move |c| (r, c))).collect();
        let motion = [(0, 2), (1, 3), (2, 0), (2, 1), (2, 2), (3, 1), (3, 3)];
        for (size, nonzeros) in
            [(12, chain), (9, arrow), (6, full), (4, motion.to_vec()), (3, vec![])]
        {
            assert!(residual(size, &nonzeros) < 1e-13, "{nonzeros:?}");
        }
    }

    #[test]
    fn an_arrow_fills_nothing_in() {
        // The head of the arrow is eliminated last.
        let arrow: Vec<(u32, u32)> =
            (1..9).flat_map(|k: u32| [(0, k), (k, 0), (k, k)]).chain([(0, 0)]).collect();
        assert_eq!(Elimination::new(9, &arrow).borrowed().places, 25);
    }
}
