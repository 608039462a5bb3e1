//! Events and constraints along a run.

use machinist_model::NodeId;

use super::Build;

impl Build<'_> {
    /// Returns guards, their rates along the motion, and resets.
    pub(super) fn events(&mut self) -> [Vec<NodeId>; 3] {
        let linearization = self.linearization;
        let events = &linearization.equations.events;
        let guards = events.iter().map(|event| self.lower(&event.guard)).collect();
        let indices = 0..events.len();
        let mut rates: Vec<NodeId> =
            indices.map(|index| self.total_derivative(|p| &p.guards[index])).collect();
        if !linearization.guards_by_forces.is_empty() {
            let forces = self.rates_of_forces();
            for (slopes, force) in linearization.guards_by_forces.iter().zip(forces) {
                for (rate, slope) in rates.iter_mut().zip(slopes) {
                    let slope = self.lower(slope);
                    let part = self.graph.mul(slope, force);
                    *rate = self.graph.add(*rate, part);
                }
            }
        }
        let values = events.iter().flat_map(|event| &event.set);
        let resets = values.map(|(_, value)| self.lower(value)).collect();
        [guards, rates, resets]
    }

    /// Returns dlambda/dt along the motion, from the same equations differentiated by time.
    fn rates_of_forces(&mut self) -> Vec<NodeId> {
        let linearization = self.linearization;
        let zero = self.graph.literal(0.0);
        let mut sides = vec![zero; self.solution.len()];
        for (row, node) in self.side(&linearization.time) {
            sides[row] = node;
        }
        for (index, partials) in linearization.state.iter().enumerate() {
            for (row, node) in self.side(partials) {
                let part = self.graph.mul(node, self.rate[index]);
                sides[row] = self.graph.add(sides[row], part);
            }
        }
        let solution = self.reactions.solve(&mut self.graph, &self.substitution, sides);
        let negative = &solution[self.coordinates()..];
        negative.iter().map(|node| self.graph.neg(*node)).collect()
    }

    /// Returns g and g' of constraints that hold.
    pub(super) fn constraints(&mut self) -> [Vec<NodeId>; 2] {
        let constraints = &self.linearization.equations.constraints;
        [&constraints.values, &constraints.rates].map(|exprs| {
            let held = exprs.iter().enumerate().map(|(index, expr)| constraints.held(index, expr));
            held.map(|expr| self.lower(&expr)).collect()
        })
    }
}
