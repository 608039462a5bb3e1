//! Initial state of a run: from the spec, from the caller, or in a nearby equilibrium.

#[cfg(feature = "linear")]
use super::Problem;
use super::Simulation;
use crate::constraints::{consistent, require_independent};
use crate::error::SimulateError;
#[cfg(feature = "linear")]
use crate::linear_analysis::{LinearError, Point, growth, steady_start};
use crate::method::System;
use crate::method::sensitivity::{By, Tangents};
#[cfg(feature = "linear")]
use crate::method::{StepTolerance, Stopped};

/// Variants with a motion whose kinetic energy decreases with speed.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct NegativeInertias {
    /// Number of these variants.
    pub count: usize,
    /// Index of the first.
    pub first: usize,
    /// Note on the first, as of [`Simulation::negative_inertia`].
    pub note: String,
}

impl Simulation<'_> {
    pub(crate) fn checked_initial_state(&self) -> Result<Vec<f64>, SimulateError> {
        let states = self.simulator.shape().states();
        let state = self.guess();
        let name = |index| format!("initial value of `{}`", self.simulator.state(index).name);
        self.check_list("states", &state, states, name)?;
        if self.starts_in_equilibrium() {
            return self.balanced(state, &self.named());
        }
        // A state from the caller fulfils the constraints nearly, or is a guess.
        let is_spec = self.initial_state.is_none();
        let is_given = |index| is_spec && self.simulator.is_given(index);
        let state = consistent(self.simulator, &self.parameters, self.from, state, &is_given)?;
        require_independent(self.simulator, &self.parameters, self.from, &state)?;
        self.require_inertia(&state)?;
        Ok(state)
    }

    /// Returns the initial state as given.
    fn guess(&self) -> Vec<f64> {
        let mut state = self.initial_state.clone().unwrap_or_else(|| {
            let mut state = vec![0.0; self.simulator.shape().states()];
            self.simulator.initial_state(&self.parameters, &mut state);
            state
        });
        for (index, value) in &self.initial_values {
            if let Some(entry) = state.get_mut(*index) {
                *entry = *value;
            }
        }
        state
    }

    /// Returns the indices of the states that the spec or the caller names.
    pub(super) fn named(&self) -> Vec<usize> {
        let is_spec = self.initial_state.is_none();
        let is_set = |index: usize| self.initial_values.iter().any(|(set, _)| *set == index);
        let is_named = |index: &usize| is_spec && self.simulator.is_given(*index) || is_set(*index);
        (0..self.simulator.shape().states()).filter(is_named).collect()
    }

    /// Returns whether to start in equilibrium; a state from the caller prevents it unless
    /// requested.
    pub(super) fn starts_in_equilibrium(&self) -> bool {
        let is_of_spec = self.initial_state.is_none();
        self.in_equilibrium.unwrap_or(is_of_spec && self.simulator.starts_in_equilibrium())
    }

    /// Returns the equilibrium near a state. The `named` entries move only as far as necessary.
    #[cfg(feature = "linear")]
    pub(crate) fn balanced(
        &self,
        guess: Vec<f64>,
        named: &[usize],
    ) -> Result<Vec<f64>, SimulateError> {
        let parameters = self.checked_parameters()?;
        // Constraints are fulfilled as for any start if possible, otherwise by moving any entry.
        let given = |index| named.contains(&index);
        let state = consistent(self.simulator, parameters, self.from, guess.clone(), &given);
        let state = state
            .or_else(|_| consistent(self.simulator, parameters, self.from, guess, &|_| false))?;
        require_independent(self.simulator, parameters, self.from, &state)?;
        let guess = Point { time: self.from, state, parameters: parameters.to_vec() };
        let settle = |state: &mut Vec<f64>| self.settle(state);
        let found = steady_start(self.simulator, guess, named, &settle);
        Ok(found.map_err(LinearError::of_start)?.state)
    }

    #[cfg(not(feature = "linear"))]
    pub(crate) fn balanced(&self, _: Vec<f64>, _: &[usize]) -> Result<Vec<f64>, SimulateError> {
        let scene = self.simulator.name();
        Err(SimulateError::NoEquilibrium(format!(
            "the search for the equilibrium of scene `{scene}` is not compiled in. Hint: turn on \
             the feature `linear` of the crate machinist"
        )))
    }

    /// Sets the modes of a start so that they agree with their guards.
    #[cfg(feature = "linear")]
    pub(super) fn settle(&self, state: &mut [f64]) -> Result<(), SimulateError> {
        let system = System::new(self.simulator, &self.parameters, false);
        let problem = Problem {
            system: &system,
            from: self.from,
            until: self.until,
            times: &[],
            initial: state.to_vec(),
            jumps: Vec::new(),
            tolerance: StepTolerance::new(
                (self.chosen_method()?, self.auto),
                (self.simulator, &self.parameters),
                (self.rtol, self.checked_atol(state)?),
            ),
            auto: self.auto,
            max_steps: self.max_steps,
        };
        problem.settle(state).map_err(|Stopped { cause, .. }| {
            SimulateError::NoEquilibrium(format!("{}: {cause}", self.simulator.name()))
        })
    }

    /// Adds a note on given entries of the start that violated the constraints by less than the
    /// tolerance, and were moved onto them.
    pub(super) fn note_projected(&self, system: &System<'_>, initial: &[f64]) {
        const SHOWN: usize = 3;
        if self.starts_in_equilibrium() || self.initial_state.is_some() {
            return;
        }
        let given = self.guess();
        let moved = (0..given.len())
            .filter(|index| self.simulator.is_given(*index))
            .map(|index| (self.simulator.state(index), initial[index] - given[index]))
            .filter(|(_, moved)| *moved != 0.0)
            .map(|(state, moved)| format!("`{}` by {moved:.1e} {}", state.name, state.unit));
        let moved: Vec<String> = moved.collect();
        if !moved.is_empty() {
            let more = if moved.len() > SHOWN { ", ..." } else { "" };
            let shown = moved.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
            system.note(format!(
                "the start violated constraints by less than the tolerance of its scene, and is \
                 projected onto them: {shown}{more}"
            ));
        }
    }

    /// Adds a note if the run starts in an unstable equilibrium.
    #[cfg(feature = "linear")]
    pub(super) fn note_unstable(&self, system: &System<'_>, state: &[f64]) {
        if !self.starts_in_equilibrium() {
            return;
        }
        let (state, parameters) = (state.to_vec(), self.parameters.clone());
        let point = Point { time: self.from, state, parameters };
        if let Some(growth) = growth(self.simulator, point, self.until - self.from) {
            system.note(format!(
                "the equilibrium at the start is unstable: deviations grow by e in {:.3e} s",
                1.0 / growth
            ));
        }
    }

    /// Returns a note on a motion whose kinetic energy decreases with speed, for example because a
    /// mass has the wrong sign: every force then accelerates it in the opposite direction. The mass
    /// matrix is evaluated at the start as given, before any search for an equilibrium. Returns
    /// `None` for a run that would be refused.
    #[must_use]
    pub fn negative_inertia(&self) -> Option<String> {
        self.checked_parameters().ok()?;
        let state = self.guess();
        let is_whole = state.len() == self.simulator.shape().states();
        is_whole.then(|| self.negative_inertia_at(&state)).flatten()
    }

    /// Returns which variants, each with all its parameters, have such a motion; `None` if there
    /// are none.
    #[must_use]
    pub fn negative_inertias(&self, variants: &[Vec<f64>]) -> Option<NegativeInertias> {
        let told = |all: &Vec<f64>| self.clone().parameters(all).negative_inertia();
        let mut found =
            variants.iter().enumerate().filter_map(|(index, all)| Some((index, told(all)?)));
        let (first, note) = found.next()?;
        Some(NegativeInertias { first, note, count: 1 + found.count() })
    }

    /// Compares the first-order motion of an equilibrium that its equations leave partly open with
    /// differences of the search.
    pub(super) fn check_tangents(
        &self,
        tangents: &Tangents<'_>,
        initial: &[f64],
    ) -> Result<(), SimulateError> {
        const NEAR: f64 = 1e-4;
        for (direction, by) in self.sensitivities.iter().enumerate() {
            let quantity = by.quantity(self.simulator);
            let size = match by {
                By::Parameter(index) => self.parameters[*index].abs(),
                By::Initial(index) => self.simulator.state_scale(*index),
            };
            let step = 1e-6 * if size > 0.0 { size } else { 1.0 };
            let at = |shift: f64| {
                let mut moved = self.clone();
                match by {
                    By::Parameter(index) => moved.parameters[*index] += shift,
                    By::Initial(index) => {
                        let value = self.guess()[*index] + shift;
                        moved.initial_values.retain(|(other, _)| other != index);
                        moved.initial_values.push((*index, value));
                    }
                }
                moved.checked_initial_state()
            };
            let (ahead, behind) = (at(step)?, at(-step)?);
            for (index, tangent) in tangents.start_of(direction).enumerate() {
                let scale = self.simulator.state_scale(index).max(initial[index].abs());
                let difference = (ahead[index] - behind[index]) / (2.0 * step);
                if (difference - tangent).abs() * size.max(step) > NEAR * scale {
                    return Err(SimulateError::NotDifferentiable {
                        name: quantity.name.to_owned(),
                        why: "moves an equilibrium that its equations do not determine, so it \
                              depends on the search; give more initial values in [initial]"
                            .to_owned(),
                    });
                }
            }
        }
        Ok(())
    }
}
