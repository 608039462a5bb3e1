//! Identities of emitted C in the numbers of C alone, at states of runs: the power balance, and
//! derivatives compared with differences.

use std::collections::BTreeMap;

use machinist::Simulation;
use machinist::trajectory::ColumnKind;
use machinist_codegen::emit::c99::Real;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::{Model, ModelSimulator, StateKind};

use super::compiler::{Compiler, Program};
use super::{SCENES, compiled, driver, options};
use crate::own_scene::{scenes_to_try, whole_model_of_specs};

/// Number of states of a run that are tested.
const STATES: usize = 6;

/// Shift of a state for a difference of rates, relative to its scale or value, the larger of both.
const SHIFT: f64 = 1e-6;
/// Shift for an extrapolated difference of energies where the other leaves rounding, as for oil,
/// whose energies are small beside their terms. Contacts need the other. The better of both counts.
const LONG_SHIFT: f64 = 1e-4;

/// Error of a balance, relative to the largest sum of the sizes of its terms: rounding.
const BALANCE: f64 = 1e-10;
/// Error of a difference: rounding over the shift.
const DIFFERENCE: f64 = 1e-6;
/// Change of a slope within a shift that only a switching surface causes; a curve's is of the size
/// of the shift.
const SURFACE: f64 = 100.0 * SHIFT;

type Values = BTreeMap<&'static str, Vec<f64>>;

struct Machine<'a> {
    model: &'a Model,
    program: Program,
    parameters: Vec<f64>,
}

impl Machine<'_> {
    /// Returns the results of all functions.
    fn at(&mut self, time: f64, state: &[f64]) -> Values {
        self.program.send(&[&[time], state, &self.parameters].concat());
        let rows = driver::functions(self.model).into_iter();
        rows.map(|row| (row.name, self.program.receive((row.results)(self.model)))).collect()
    }

    /// Returns the results at both ends of a shift along a state, relative to its scale or value, and its length.
    fn around(
        &mut self,
        (time, state): (f64, &[f64]),
        entry: usize,
        shift: f64,
    ) -> ([Values; 2], f64) {
        let shift = shift * self.model.states[entry].scale.max(state[entry].abs());
        let ends = [shift, -shift].map(|shift| {
            let mut state = state.to_vec();
            state[entry] += shift;
            (state[entry], self.at(time, &state))
        });
        let [(upper, above), (lower, below)] = ends;
        ([above, below], upper - lower)
    }

    /// Returns the central difference of the energy over a state.
    fn energy_slope(&mut self, at: (f64, &[f64]), entry: usize, shift: f64) -> f64 {
        let ([above, below], length) = self.around(at, entry, shift);
        (total(&above) - total(&below)) / length
    }

    /// Returns dE/dt by the chain rule over the slopes of the energy, and the sum of the sizes of
    /// its terms. Energies may depend on time, as that of a spring with a moving foot.
    fn energy_rate(
        &mut self,
        at: (f64, &[f64]),
        here: &Values,
        slope: impl Fn(&mut Self, usize) -> f64,
    ) -> (f64, f64) {
        let model = self.model;
        let span = SHIFT * (model.run.until - model.run.from);
        let [later, earlier] = [span, -span].map(|by| total(&self.at(at.0 + by, at.1)));
        let mut terms = vec![(later - earlier) / (2.0 * span)];
        for (entry, state) in model.states.iter().enumerate() {
            if state.kind != StateKind::Mode {
                terms.push(slope(self, entry) * here["rate"][entry]);
            }
        }
        (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
    }
}

fn total(values: &Values) -> f64 {
    values["energy"].iter().sum()
}

/// Largest errors along a run: of the power balance, of `dE/dt` by differences of the energy, and of
/// the Jacobian by differences of the rate, over the largest sizes of their terms along the run.
/// Entries at a switching surface are left out.
#[derive(Default)]
struct Errors {
    balance: f64,
    stored_rate: f64,
    /// Largest sum of the sizes of powers.
    size: f64,
    jacobian: f64,
    /// Largest sum of the sizes of the terms of each rate.
    rates: Vec<f64>,
    entries: usize,
    left_out: usize,
}

/// Returns rows, columns and values of the Jacobian.
fn entries(model: &Model, here: &Values) -> Vec<(usize, usize, f64)> {
    let values = here.get("rate_jacobian").into_iter().flatten();
    let entries = model.rate_jacobian.pattern.entries.iter().zip(values);
    entries.map(|(&(row, column), &value)| (row as usize, column as usize, value)).collect()
}

impl Errors {
    /// Raises the sizes of rates to those at a state.
    fn look(&mut self, machine: &mut Machine<'_>, at: (f64, &[f64])) {
        let here = machine.at(at.0, at.1);
        let mut sizes: Vec<f64> = here["rate"].iter().map(|rate| rate.abs()).collect();
        for (row, column, value) in entries(machine.model, &here) {
            sizes[row] += (value * machine.model.states[column].scale).abs();
        }
        self.rates.resize(sizes.len(), 0.0);
        let (states, run) = (&machine.model.states, &machine.model.run);
        for ((most, size), state) in self.rates.iter_mut().zip(sizes).zip(states) {
            // What constraints hold has rates of rounding.
            *most = most.max(size).max(state.scale / (run.until - run.from));
        }
    }

    fn add(&mut self, machine: &mut Machine<'_>, at: (f64, &[f64])) {
        let here = machine.at(at.0, at.1);
        self.compare_jacobian(machine, at, &here);
        let [stored_rate, supplied, dissipated] = here["power_balance"][..] else {
            panic!("three powers")
        };
        let near = |machine: &mut Machine<'_>, entry| machine.energy_slope(at, entry, SHIFT);
        let extrapolated = |machine: &mut Machine<'_>, entry| {
            let [long, short] =
                [LONG_SHIFT, LONG_SHIFT / 2.0].map(|shift| machine.energy_slope(at, entry, shift));
            short + (short - long) / 3.0
        };
        let (by_near, size) = machine.energy_rate(at, &here, near);
        let (by_extrapolated, _) = machine.energy_rate(at, &here, extrapolated);
        self.size = self.size.max(size + supplied.abs() + dissipated.abs());
        self.balance = self.balance.max((stored_rate - supplied + dissipated).abs());
        let [near, extrapolated] = [by_near, by_extrapolated].map(|sum| (stored_rate - sum).abs());
        self.stored_rate = self.stored_rate.max(near.min(extrapolated));
    }

    fn compare_jacobian(&mut self, machine: &mut Machine<'_>, at: (f64, &[f64]), here: &Values) {
        let model = machine.model;
        let entries = entries(model, here);
        for (entry, state) in model.states.iter().enumerate() {
            if state.kind == StateKind::Mode {
                continue;
            }
            let ([above, below], length) = machine.around(at, entry, SHIFT);
            for &(row, _, value) in entries.iter().filter(|(_, column, _)| *column == entry) {
                let [upper, middle, lower] = [&above, here, &below].map(|at| at["rate"][row]);
                let share = state.scale / length;
                self.entries += 1;
                let bend = (upper - middle - (middle - lower)).abs() * share;
                if bend > SURFACE * self.rates[row] {
                    self.left_out += 1;
                    continue;
                }
                // A surface within the shift that bends less is off by no more than that.
                let error = ((upper - lower) / length - value).abs() * state.scale - bend;
                self.jacobian = self.jacobian.max(error / self.rates[row]);
            }
        }
    }
}

/// Returns times and states of the spec's run.
fn states(model: &Model) -> Vec<(f64, Vec<f64>)> {
    let simulator = ModelSimulator::new(model.clone());
    let run = Simulation::new(&simulator).run().expect("a run");
    let columns: Vec<_> = run.of_kind(ColumnKind::State).collect();
    let last = run.times.len() - 1;
    let places = (0..STATES).map(|index| index * last / (STATES - 1));
    places.map(|at| (run.times[at], columns.iter().map(|of| of.values[at]).collect())).collect()
}

#[test]
fn emitted_c_balances_power_and_differentiates_its_own_functions() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for name in scenes_to_try("MACHINIST_C99", &SCENES) {
        let model = whole_model_of_specs(&name, Keep::Needed);
        let states = states(&model);
        let program = compiled(&compiler, &model, &options(Real::Double, &model));
        let parameters = model.parameters.iter().map(|p| p.value).collect();
        let mut machine = Machine { model: &model, program, parameters };
        let mut errors = Errors::default();
        for (time, state) in &states {
            errors.look(&mut machine, (*time, state));
        }
        for (time, state) in &states {
            errors.add(&mut machine, (*time, state));
        }
        let Errors { jacobian, entries, left_out, .. } = errors;
        let size = errors.size.max(f64::MIN_POSITIVE);
        let [balance, stored_rate] = [errors.balance, errors.stored_rate].map(|off| off / size);
        let said = format!(
            "{name}: power {balance:.1e}, dE/dt {stored_rate:.1e}, Jacobian {jacobian:.1e}, \
             {left_out} of {entries} entries at surfaces"
        );
        println!("{said}");
        assert!(balance <= BALANCE, "{said}");
        assert!(stored_rate <= DIFFERENCE && jacobian <= DIFFERENCE, "{said}");
        assert!(4 * left_out <= entries, "{said}");
    }
}
