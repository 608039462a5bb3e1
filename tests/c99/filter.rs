//! The extended Kalman filter of emitted C, compared with that of Rust.

use machinist::estimator::{Estimator, EstimatorDesign, EstimatorIndices};
use machinist_codegen::emit::c99::{C99Options, EstimatorOptions, Real, emit};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::{Model, ModelSimulator};

use super::compiler::{Compiler, Program};
use super::{options, options_with};
use crate::own_scene::model_of_specs;
use crate::wasm::assert_same;

/// A filter of a scene, and its steps.
struct Case {
    scene: &'static str,
    measured: &'static [(&'static str, f64)],
    estimated: &'static [&'static str],
    noise: &'static [(&'static str, f64)],
    start: &'static [(&'static str, f64)],
    step: f64,
    steps: usize,
}

/// Motor with a jump of its torque; brake, lossy gear and constraints in modes; friction; rebound;
/// constraints; a motion that functions share.
const CASES: [Case; 6] = [
    Case {
        scene: "saw_gin",
        measured: &[("motor_speed", 0.1), ("stator_current", 0.5)],
        estimated: &["load.mean"],
        noise: &[("load.mean", 5.0), ("motor.phase_voltage", 0.05), ("motor.omega", 0.01)],
        start: &[("motor.omega", 0.1), ("load.mean", 10.0)],
        step: 1e-3,
        steps: 300,
    },
    Case {
        scene: "drives/winch",
        measured: &[("speed", 0.5), ("current", 1.0)],
        estimated: &[],
        noise: &[("load.mass", 0.2)],
        start: &[("motor.omega", 0.5), ("load.v", 0.01), ("load.x", 1e-3)],
        step: 5e-4,
        steps: 2000,
    },
    Case {
        scene: "stick_slip",
        measured: &[("deflection", 1e-3)],
        estimated: &["belt_speed"],
        noise: &[("belt_speed", 1e-3)],
        start: &[("slider.x", 1e-3)],
        step: 1e-3,
        steps: 1500,
    },
    Case {
        scene: "bouncing_mass",
        measured: &[],
        estimated: &[],
        noise: &[],
        start: &[],
        step: 1e-3,
        steps: 700,
    },
    Case {
        scene: "pendulum_constrained",
        measured: &[],
        estimated: &[],
        noise: &[],
        start: &[],
        step: 1e-3,
        steps: 200,
    },
    Case {
        scene: "pendulum_chain",
        measured: &[],
        estimated: &[],
        noise: &[],
        start: &[],
        step: 1e-3,
        steps: 100,
    },
];

impl Case {
    /// Returns the design; where the case names nothing, the first output is measured and every
    /// state is uncertain.
    fn indices(&self, simulator: &dyn Simulator<f64>, method: StepMethod) -> EstimatorIndices {
        let list = |of: &[(&str, f64)]| {
            of.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect::<Vec<_>>()
        };
        let (mut measured, mut start) = (list(self.measured), list(self.start));
        if measured.is_empty() {
            measured.push((simulator.output(0).name.to_owned(), 0.1));
            let states = (0..simulator.shape().states()).filter(|at| !simulator.is_mode(*at));
            start = states
                .map(|at| (simulator.state(at).name.to_owned(), 1e-3 * simulator.state_scale(at)))
                .collect();
        }
        let design = EstimatorDesign {
            method,
            measured,
            estimated: self.estimated.iter().map(|name| (*name).to_owned()).collect(),
            noise: list(self.noise),
            start,
        };
        design.indices(simulator).unwrap_or_else(|error| panic!("{}: {error}", self.scene))
    }
}

fn emitted(indices: &EstimatorIndices) -> EstimatorOptions {
    let EstimatorIndices { measured, estimated, diffusing, disturbed, start, .. } = indices.clone();
    EstimatorOptions { measured, estimated, diffusing, disturbed, start }
}

/// Returns a program that takes a step and measured outputs, and answers with state, root of the
/// covariance and normalized innovation.
fn driver(model: &Model, indices: &EstimatorIndices, real: Real) -> String {
    let (name, real) = (&model.name, real.name());
    let (measured, states) = (indices.measured.len(), model.states.len());
    let size = indices.start.len();
    let count = measured + 1;
    format!(
        "#include \"{name}.h\"\n#include <stdio.h>\n#include <string.h>\n#include <stdlib.h>\n\
         static void put({real} number)\n{{\n    double wide = (double)number;\n    \
             if (fwrite(&wide, sizeof wide, 1, stdout) != 1) {{\n        exit(1);\n    }}\n}}\n\
         int main(void)\n{{\n    static {name}_estimator_t estimator;\n    double in[{count}];\n    \
             {real} numbers[{measured}], state[{states}];\n    {name}_measured_t measured;\n    \
             size_t k, row;\n    {name}_estimator_begin(&estimator);\n    \
             while (fread(in, sizeof in[0], {count}, stdin) == {count}) {{\n        \
                 {real} normalized;\n        \
                 for (k = 0; k < {measured}; ++k) {{\n            numbers[k] = ({real})in[k + 1];\n        }}\n        \
                 memcpy(&measured, numbers, sizeof measured);\n        \
                 (void){name}_estimator_predict(&estimator, ({real})in[0]);\n        \
                 normalized = {name}_estimator_correct(&estimator, &measured);\n        \
                 memcpy(state, &estimator.machine.state, sizeof state);\n        \
                 for (k = 0; k < {states}; ++k) {{\n            put(state[k]);\n        }}\n        \
                 for (k = 0; k < {size}; ++k) {{\n            \
                     for (row = 0; row < {size}; ++row) {{\n                put(estimator.root[k][row]);\n            }}\n        }}\n        \
                 put(normalized);\n        fflush(stdout);\n    }}\n    return 0;\n}}\n"
    )
}

/// Runs both filters; calls with the answers of C and of Rust after each step.
fn compare(
    case: &Case,
    (real, method): (Real, StepMethod),
    compiler: &Compiler,
    mut compare: impl FnMut(usize, &[f64], &[f64]),
) {
    let model = model_of_specs(case.scene, Keep::Needed);
    let simulator = ModelSimulator::interpreted(model.clone());
    let indices = case.indices(&simulator, method);
    let options = options_with(real, &model, emitted(&indices), method);
    let start = options.start.clone().unwrap_or_else(|| {
        let p: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
        let mut state = vec![0.0; model.states.len()];
        simulator.initial_state(&p, &mut state);
        state
    });
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let files = emit(&model, &options).unwrap_or_else(|error| panic!("{}: {error}", case.scene));
    let mut program: Program = compiler.build(&model.name, &files, &driver(&model, &indices, real));
    let mut estimator = Estimator::at(&simulator, &indices, model.run.from, &start, &parameters);
    let mut ahead = Estimator::at(&simulator, &indices, model.run.from, &start, &parameters);
    let size = indices.start.len();
    for step in 0..case.steps {
        let _ = ahead.predict(case.step);
        let outputs = ahead.outputs();
        let measured: Vec<f64> = indices
            .measured
            .iter()
            .enumerate()
            .map(|(row, (output, deviation))| {
                // One of ten measurements is missing.
                let is_missing = (step + row) % 10 == 9;
                let noise = ((step * 7 + row * 3) as f64 * 0.37).sin() * deviation;
                if is_missing { f64::NAN } else { outputs[*output] + noise }
            })
            .collect();
        let _ = estimator.predict(case.step);
        let correction = estimator.correct(&measured);
        program.send(&[&[case.step], &measured[..]].concat());
        let found = program.receive(model.states.len() + size * size + 1);
        let wanted = [estimator.state(), estimator.root(), &[correction.innovation]].concat();
        compare(step, &found, &wanted);
    }
}

#[test]
fn filters_in_c_give_the_digits_of_filters_in_rust() {
    let Some(compiler) = Compiler::found() else { return };
    for case in &CASES {
        for method in [StepMethod::RungeKutta4, StepMethod::Heun] {
            compare(case, (Real::Double, method), &compiler, |step, found, wanted| {
                // Zeros may have either sign.
                let signless = |values: &[f64]| values.iter().map(|x| x + 0.0).collect::<Vec<_>>();
                let what = format!("{} by {method:?}: step {step}", case.scene);
                assert_same(&what, &signless(found), &signless(wanted));
            });
        }
    }
}

#[test]
fn filters_in_float_follow_those_in_double() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for (case, allowed) in [(&CASES[0], 1e-2), (&CASES[5], 1e-2)] {
        let model = model_of_specs(case.scene, Keep::Needed);
        let method = StepMethod::RungeKutta4;
        compare(case, (Real::Float, method), &compiler, |step, found, wanted| {
            let size = found.len() - model.states.len() - 1;
            let size = (size as f64).sqrt() as usize;
            for (entry, state) in model.states.iter().enumerate() {
                let deviation = |answer: &[f64]| {
                    let root = &answer[model.states.len()..];
                    let row = (0..size).map(|column| root[column * size + entry].powi(2));
                    row.sum::<f64>().sqrt()
                };
                let off = (deviation(found) - deviation(wanted)).abs();
                let name = &state.quantity.name.path;
                let least = 1e-6 * state.scale;
                assert!(
                    off <= allowed * deviation(wanted) + least,
                    "{}: step {step}, {name}: {off:e} of {:e}",
                    case.scene,
                    deviation(wanted)
                );
            }
        });
    }
}

#[test]
fn a_rosenbrock_step_has_no_filter() {
    let model = model_of_specs("saw_gin", Keep::Needed);
    let options = C99Options {
        method: StepMethod::Rosenbrock2,
        estimator: Some(EstimatorOptions::default()),
        ..options(Real::Double, &model)
    };
    let error = emit(&model, &options).expect_err("refused").to_string();
    assert!(error.contains("second derivatives"), "{error}");
}
