//! The extended Kalman filter of emitted C, compared with that of Rust.

use std::fmt::Write as _;

use machinist::estimator::{Estimator, EstimatorDesign, EstimatorIndices};
use machinist_codegen::emit::c99::{C99File, EstimatorOptions, Real, emit};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::fixed_step::{FixedMethod, StepMethod};
use machinist_model::{Elimination, Model, ModelSimulator};

use super::compiler::{Compiler, Program};
use super::{board, options_with, print_run};
use crate::fixed_steps::difference;
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
    fn indices<'m>(
        &self,
        simulator: &dyn Simulator<f64>,
        method: FixedMethod<'m>,
    ) -> EstimatorIndices<'m> {
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

fn emitted(indices: &EstimatorIndices<'_>) -> EstimatorOptions {
    let EstimatorIndices { measured, estimated, diffusing, disturbed, start, .. } = indices.clone();
    EstimatorOptions { measured, estimated, diffusing, disturbed, start }
}

/// Returns a program that takes a step and measured outputs, and answers with state, root of the
/// covariance and normalized innovation.
fn driver(model: &Model, indices: &EstimatorIndices<'_>, real: Real) -> String {
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
    let list = Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries);
    let indices = case.indices(&simulator, method.with(list.borrowed()));
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
        for method in StepMethod::ALL {
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
fn filters_in_c_turn_quaternions_as_filters_in_rust() {
    let Some(compiler) = Compiler::found() else { return };
    let case = Case {
        scene: "parts/spatial/revolute_constraint",
        measured: &[],
        estimated: &[],
        noise: &[],
        start: &[],
        step: 1e-3,
        steps: 100,
    };
    // C turns quaternions by a formula, and Rust by differences of rates.
    for method in StepMethod::ALL {
        compare(&case, (Real::Double, method), &compiler, |step, found, wanted| {
            let size = wanted.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (found, wanted) in found.iter().zip(wanted) {
                let off = (found - wanted).abs();
                assert!(off <= 1e-9 * size, "{method:?}: step {step}: {found:e}, {wanted:e}");
            }
        });
    }
}

/// Returns a function in C that steps a machine and measures it with noise of whole numbers.
fn measuring(model: &Model, indices: &EstimatorIndices<'_>) -> String {
    let name = &model.name;
    let mut text = format!(
        "static void measure({name}_machine_t *truth, REAL step, long k, {name}_measured_t *m)\n\
         {{\n    {name}_outputs_t outputs;\n    (void){name}_step(truth, step);\n    \
         {name}_outputs(truth->time, &truth->state, &truth->p, &truth->c, &outputs);\n"
    );
    for (row, (output, deviation)) in indices.measured.iter().enumerate() {
        let member = &model.wanted[*output].name.ident;
        let _ = writeln!(
            text,
            "    m->{member} = outputs.{member} + (REAL)((7 * k + {row}) % 11 - 5) * \
             (REAL){deviation:?} * (REAL)0.25;"
        );
    }
    text + "}\n"
}

#[test]
fn microcontrollers_estimate_with_the_digits_of_the_host() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    if !board::are_here() {
        return;
    }
    for (case, method) in [
        (&CASES[0], StepMethod::RungeKutta4),
        (&CASES[0], StepMethod::Rosenbrock2),
        (&CASES[1], StepMethod::RungeKutta4),
    ] {
        let model = model_of_specs(case.scene, Keep::Needed);
        let simulator = ModelSimulator::interpreted(model.clone());
        let list = Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries);
        let indices = case.indices(&simulator, method.with(list.borrowed()));
        let steps = case.steps.min(300);
        let measure = measuring(&model, &indices);
        for real in [Real::Double, Real::Float] {
            let options = options_with(real, &model, emitted(&indices), method);
            let files = emit(&model, &options).expect("emitted");
            let host = on_host(&compiler, &model, (&files, real), (&measure, case.step, steps));
            for board in &board::BOARDS {
                let scene = (&*model.name, &files[..], real);
                let ran = board.run(scene, (case.step, steps), Some(&measure));
                let what = format!("filter of {} by {method:?} on {}", case.scene, board.processor);
                let states = model.states.len();
                let error = difference(&model, &ran.state[..states], &host[..states]);
                match real {
                    Real::Double => assert_same(&what, &ran.state, &host),
                    Real::Float => assert!(error < 1e-3, "{what}: off by {error:e}"),
                }
                print_run((case.scene, real), board, &ran, error);
            }
        }
    }
}

/// Returns state and root of a filter after its run on this machine.
fn on_host(
    compiler: &Compiler,
    model: &Model,
    (files, real): (&[C99File], Real),
    (measure, step, steps): (&str, f64, usize),
) -> Vec<f64> {
    let (name, number) = (&model.name, real.name());
    let count = model.states.len();
    let main = format!(
        "#include \"{name}.h\"\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n\
         #define REAL {number}\n{measure}\n\
         static void put(const void *from, size_t count)\n{{\n    size_t k;\n    \
         for (k = 0; k < count; ++k) {{\n        {number} number;\n        double wide;\n        \
         memcpy(&number, (const char *)from + k * sizeof number, sizeof number);\n        \
         wide = (double)number;\n        \
         if (fwrite(&wide, sizeof wide, 1, stdout) != 1) {{\n            exit(1);\n        }}\n    }}\n}}\n\
         int main(void)\n{{\n    static {name}_machine_t machine;\n    \
         static {name}_estimator_t runner;\n    long k;\n    {name}_begin(&machine);\n    \
         {name}_estimator_begin(&runner);\n    \
         for (k = 0; k < {steps}; ++k) {{\n        {name}_measured_t measured;\n        \
         measure(&machine, ({number}){step:e}, k, &measured);\n        \
         (void){name}_estimator_predict(&runner, ({number}){step:e});\n        \
         (void){name}_estimator_correct(&runner, &measured);\n    }}\n    \
         put(&runner.machine.state, {count});\n    \
         put(runner.root, sizeof runner.root / sizeof({number}));\n    fflush(stdout);\n    \
         while (getchar() != EOF) {{\n    }}\n    return 0;\n}}\n"
    );
    let mut program = compiler.build(name, files, &main);
    program.receive(count + roots(files, name))
}

/// Returns the number of entries of a root, from the header.
fn roots(files: &[C99File], name: &str) -> usize {
    let size = |what: &str| -> usize {
        let start = format!("#define {}_{what} ", name.to_ascii_uppercase());
        let line = files[0].text.lines().find_map(|line| line.strip_prefix(&*start));
        line.and_then(|line| line.trim_end_matches('u').parse().ok()).expect("a size")
    };
    size("COLUMNS") * size("ENTRIES")
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
