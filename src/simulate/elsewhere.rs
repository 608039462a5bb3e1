//! Settings of a run without its simulator, for threads that have their own simulator.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use machinist_contract::Simulator;

use super::{Sampling, Simulation};
use crate::method::patience::Patience;
use crate::method::sensitivity::By;
use crate::method::{Auto, Method};

/// A [`Simulation`] without its simulator, which threads may share. [`Simulation::until_told`] is
/// left out, since its function belongs to one thread.
#[derive(Clone)]
#[expect(clippy::struct_excessive_bools, reason = "settings that do not depend on each other")]
pub(crate) struct Settings<'a> {
    parameters: Vec<f64>,
    initial_state: Option<Vec<f64>>,
    initial_values: Vec<(usize, f64)>,
    in_equilibrium: Option<bool>,
    from: f64,
    until: f64,
    sampling: Sampling,
    rtol: f64,
    atol: Option<Vec<f64>>,
    sizes: Vec<(usize, f64)>,
    holds_small: bool,
    is_refined: bool,
    method: Option<Method>,
    auto: Auto,
    max_steps: usize,
    energy_balance: bool,
    keeps_energy: bool,
    sensitivities: Vec<By>,
    controls_sensitivities: bool,
    limit: Option<Duration>,
    flag: Option<&'a AtomicBool>,
}

impl<'a> Simulation<'a> {
    /// Returns the settings, unless [`Simulation::until_told`] is set.
    pub(crate) fn settings(&self) -> Option<Settings<'a>> {
        let own = self.clone();
        own.patience.asked.is_none().then_some(Settings {
            parameters: own.parameters,
            initial_state: own.initial_state,
            initial_values: own.initial_values,
            in_equilibrium: own.in_equilibrium,
            from: own.from,
            until: own.until,
            sampling: own.sampling,
            rtol: own.rtol,
            atol: own.atol,
            sizes: own.sizes,
            holds_small: own.holds_small,
            is_refined: own.is_refined,
            method: own.method,
            auto: own.auto,
            max_steps: own.max_steps,
            energy_balance: own.energy_balance,
            keeps_energy: own.keeps_energy,
            sensitivities: own.sensitivities,
            controls_sensitivities: own.controls_sensitivities,
            limit: own.patience.limit,
            flag: own.patience.flag,
        })
    }
}

impl<'a> Settings<'a> {
    /// Returns the run of a simulator of the same machine.
    pub(crate) fn of(self, simulator: &'a dyn Simulator<f64>) -> Simulation<'a> {
        Simulation {
            simulator,
            parameters: self.parameters,
            initial_state: self.initial_state,
            initial_values: self.initial_values,
            in_equilibrium: self.in_equilibrium,
            from: self.from,
            until: self.until,
            sampling: self.sampling,
            rtol: self.rtol,
            atol: self.atol,
            sizes: self.sizes,
            holds_small: self.holds_small,
            is_refined: self.is_refined,
            method: self.method,
            auto: self.auto,
            max_steps: self.max_steps,
            energy_balance: self.energy_balance,
            keeps_energy: self.keeps_energy,
            sensitivities: self.sensitivities,
            controls_sensitivities: self.controls_sensitivities,
            patience: Patience { flag: self.flag, asked: None, limit: self.limit },
        }
    }
}
