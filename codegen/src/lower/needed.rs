//! Selection of the substitution steps that affect given columns.

use std::collections::{BTreeMap, BTreeSet};

use super::substitute::Step;

/// The steps that carry values from right sides to the required rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Needed {
    /// The remaining steps.
    pub steps: Vec<Step>,
    /// Rows of right sides that affect the result.
    pub sides: BTreeSet<usize>,
    /// Number of products of nonzeros, in all columns.
    pub products: usize,
    /// For each row, the columns in which it may be nonzero afterwards.
    pub columns: BTreeMap<usize, BTreeSet<usize>>,
}

/// Leaves out steps on structural zeros and steps that no required row needs. `sides` are the
/// (row, column) of nonzeros of right sides.
#[must_use]
pub fn needed(
    steps: &[Step],
    sides: &BTreeSet<(usize, usize)>,
    wanted: &BTreeSet<usize>,
) -> Needed {
    let mut columns: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for &(row, column) in sides {
        columns.entry(row).or_default().insert(column);
    }
    let mut forward = Vec::new();
    for step in steps {
        let terms = step.terms.iter().filter(|(_, from)| columns.contains_key(from));
        let terms: Vec<_> = terms.copied().collect();
        let scale = step.scale.filter(|_| columns.contains_key(&step.row));
        if scale.is_none() && terms.is_empty() {
            continue;
        }
        let more: Vec<usize> = terms.iter().flat_map(|(_, from)| columns[from].clone()).collect();
        let products = more.len();
        columns.entry(step.row).or_default().extend(more);
        forward.push((Step { row: step.row, scale, terms }, products));
    }
    let mut live = wanted.clone();
    let (mut kept, mut products) = (Vec::new(), 0);
    for (step, own) in forward.into_iter().rev() {
        if live.contains(&step.row) {
            live.extend(step.terms.iter().map(|(_, from)| *from));
            kept.push(step);
            products += own;
        }
    }
    kept.reverse();
    Needed { steps: kept, sides: live, products, columns }
}
