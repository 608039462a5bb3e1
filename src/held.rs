//! Parameters followed by the slots of relations, as steps hold them.

use std::cell::{Ref, RefCell};
use std::rc::Rc;

use machinist_contract::Simulator;

/// Parameters and slots of a run, shared by everything that evaluates its machine.
#[derive(Debug, Clone)]
pub(crate) struct Held {
    all: Rc<RefCell<Vec<f64>>>,
    /// Index of the first slot.
    first: usize,
}

impl Held {
    /// Returns parameters with live relations.
    pub(crate) fn live(simulator: &dyn Simulator<f64>, parameters: &[f64]) -> Self {
        let slots = (0..simulator.relations()).map(|index| simulator.relation(index).kind.live());
        let all = parameters.iter().copied().chain(slots).collect();
        Self { all: Rc::new(RefCell::new(all)), first: parameters.len() }
    }

    /// Returns the parameters, followed by the slots.
    #[inline]
    pub(crate) fn all(&self) -> Ref<'_, [f64]> {
        Ref::map(self.all.borrow(), Vec::as_slice)
    }

    /// Returns the slot of a relation.
    pub(crate) fn slot(&self, relation: usize) -> f64 {
        self.all.borrow()[self.first + relation]
    }

    /// Returns all slots.
    pub(crate) fn slots(&self) -> Vec<f64> {
        self.all.borrow()[self.first..].to_vec()
    }

    /// Sets the slot of a relation.
    pub(crate) fn set(&self, relation: usize, slot: f64) {
        self.all.borrow_mut()[self.first + relation] = slot;
    }

    /// Sets the slots of all relations.
    pub(crate) fn set_all(&self, slots: &[f64]) {
        self.all.borrow_mut()[self.first..].copy_from_slice(slots);
    }
}
