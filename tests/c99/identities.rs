//! Identities of emitted C in the numbers of C alone, along its own runs: the power balance, and
//! derivatives compared with differences.

use std::collections::BTreeMap;

use machinist_codegen::emit::c99::{C99Options, Real};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::{Model, StateKind};

use super::compiler::{Compiler, Program};
use super::{SCENES, compiled, driver, options};
use crate::own_scene::{scenes_to_try, whole_model_of_specs};

/// Steps of a run, and steps between two states that are tested.
const STEPS: [usize; 2] = [2000, 400];

/// Shift of a state for a difference of rates, relative to its scale.
const SHIFT: f64 = 1e-6;
/// Shift for a difference of energies, which are nearly quadratic, and small beside their terms for oil.
const ENERGY_SHIFT: f64 = 1e-4;

/// Errors allowed, relative to the sum of the sizes of all terms. Rounding alone is left of a
/// balance; constraints fulfilled by one step of Newton's method leave more.
const BALANCE: [f64; 2] = [1e-10, 1e-6];
/// Errors of differences of rates and of energies: rounding over the shift.
const DIFFERENCES: [f64; 2] = [1e-7, 1e-6];
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

    /// Returns the results at both ends of a shift along a state, relative to its scale, and its length.
    fn around(
        &mut self,
        (time, state): (f64, &[f64]),
        entry: usize,
        shift: f64,
    ) -> ([Values; 2], f64) {
        let shift = shift * self.model.states[entry].scale;
        let ends = [shift, -shift].map(|shift| {
            let mut state = state.to_vec();
            state[entry] += shift;
            (state[entry], self.at(time, &state))
        });
        let [(upper, above), (lower, below)] = ends;
        ([above, below], upper - lower)
    }
}

fn total(values: &Values) -> f64 {
    values["energy"].iter().sum()
}

/// Largest errors at a state: of the power balance, of `dE/dt` by differences of the energy, and of
/// the Jacobian by differences of the rate. Entries at a switching surface are left out.
#[derive(Default)]
struct Errors {
    balance: f64,
    stored_rate: f64,
    jacobian: f64,
    entries: usize,
    left_out: usize,
}

impl Errors {
    fn add(&mut self, machine: &mut Machine<'_>, at: (f64, &[f64])) {
        let model = machine.model;
        let here = machine.at(at.0, at.1);
        let rate = &here["rate"];
        let pattern = &model.rate_jacobian.pattern.entries;
        let scale = |entry: u32| model.states[entry as usize].scale;
        let mut sizes: Vec<f64> = rate.iter().map(|rate| rate.abs()).collect();
        for (&(row, column), value) in
            pattern.iter().zip(here.get("rate_jacobian").into_iter().flatten())
        {
            sizes[row as usize] += (value * scale(column)).abs();
        }
        let (mut sum, mut size) = (0.0, 0.0);
        for (entry, state) in model.states.iter().enumerate() {
            if state.kind == StateKind::Mode {
                continue;
            }
            let ([above, below], length) = machine.around(at, entry, ENERGY_SHIFT);
            let term = (total(&above) - total(&below)) / length * rate[entry];
            sum += term;
            size += term.abs();
            let ([above, below], length) = machine.around(at, entry, SHIFT);
            for (&(row, _), value) in
                (pattern.iter().zip(here.get("rate_jacobian").into_iter().flatten()))
                    .filter(|((_, column), _)| *column as usize == entry)
            {
                let row = row as usize;
                let [upper, middle, lower] = [&above, &here, &below].map(|at| at["rate"][row]);
                let share = state.scale / length;
                self.entries += 1;
                if (upper - middle - (middle - lower)).abs() * share > SURFACE * sizes[row] {
                    self.left_out += 1;
                    continue;
                }
                let error = ((upper - lower) / length - value).abs() * state.scale;
                self.jacobian = self.jacobian.max(error / sizes[row].max(f64::MIN_POSITIVE));
            }
        }
        let [stored_rate, supplied, dissipated] = here["power_balance"][..] else {
            panic!("three powers")
        };
        // Energies may depend on time, as that of a spring with a moving foot.
        let shift = 1e-6 * (model.run.until - model.run.from);
        let [later, earlier] = [shift, -shift].map(|by| total(&machine.at(at.0 + by, at.1)));
        let term = (later - earlier) / (2.0 * shift);
        sum += term;
        size += term.abs() + supplied.abs() + dissipated.abs();
        let size = size.max(f64::MIN_POSITIVE);
        self.balance = self.balance.max((stored_rate - supplied + dissipated).abs() / size);
        self.stored_rate = self.stored_rate.max((stored_rate - sum).abs() / size);
    }
}

#[test]
fn emitted_c_balances_power_and_differentiates_its_own_functions() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for name in scenes_to_try("MACHINIST_C99", &SCENES) {
        let model = whole_model_of_specs(&name, Keep::Needed);
        let method = StepMethod::Rosenbrock2;
        let options = C99Options { method, ..options(Real::Double, &model) };
        let program = compiled(&compiler, &model, &options);
        let [steps, between] = STEPS;
        let step = (model.run.until - model.run.from) / steps as f64;
        let rows = program.run(step, steps, model.states.len());
        let parameters = model.parameters.iter().map(|p| p.value).collect();
        let mut machine = Machine { model: &model, program, parameters };
        let mut errors = Errors::default();
        for (time, state, _) in rows.iter().step_by(between) {
            errors.add(&mut machine, (*time, state));
        }
        let Errors { balance, stored_rate, jacobian, entries, left_out } = errors;
        let said = format!(
            "{name}: power {balance:.1e}, dE/dt {stored_rate:.1e}, Jacobian {jacobian:.1e}, \
             {left_out} of {entries} entries at surfaces"
        );
        println!("{said}");
        assert!(balance <= BALANCE[usize::from(!model.constraints.is_empty())], "{said}");
        let [of_rate, of_energy] = DIFFERENCES;
        assert!(jacobian <= of_rate && stored_rate <= of_energy, "{said}");
        assert!(4 * left_out <= entries, "{said}");
    }
}
