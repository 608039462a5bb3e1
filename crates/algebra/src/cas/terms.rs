//! A sum indexed by the symbols of its terms, so that the cost of a derivative of a sum of
//! thousands of terms depends only on those with the symbol.

use std::collections::HashMap;

use super::{Cas, Form};
use crate::expr::Symbol;

/// The terms of a form, and the places of each symbol.
pub struct Terms {
    terms: Vec<Form>,
    places: HashMap<Symbol, Vec<usize>>,
}

impl Terms {
    pub(super) fn of(cas: &Cas, form: &Form) -> Self {
        let terms = form.terms();
        let mut places: HashMap<Symbol, Vec<usize>> = HashMap::new();
        for (place, term) in terms.iter().enumerate() {
            for symbol in cas.expr(term).symbols() {
                places.entry(symbol).or_default().push(place);
            }
        }
        Terms { terms, places }
    }

    /// Returns the sum.
    #[must_use]
    pub fn form(&self, cas: &Cas) -> Form {
        cas.sum(self.terms.clone())
    }

    /// Returns whether any term contains a symbol.
    #[must_use]
    pub fn mention(&self, symbol: Symbol) -> bool {
        self.places.contains_key(&symbol)
    }

    /// Returns the symbols that `pick` accepts, as `pick` maps them, in order.
    pub fn symbols<T: Ord>(&self, pick: impl Fn(Symbol) -> Option<T>) -> Vec<T> {
        let mut symbols: Vec<T> = self.places.keys().filter_map(|symbol| pick(*symbol)).collect();
        symbols.sort_unstable();
        symbols
    }

    /// Returns the partial derivative by one symbol.
    pub fn derivative(&self, cas: &mut Cas, symbol: Symbol) -> Form {
        let Some(places) = self.places.get(&symbol) else { return cas.zero() };
        let sum = cas.sum(places.iter().map(|place| self.terms[*place].clone()).collect());
        cas.derivative(&sum, symbol)
    }
}
