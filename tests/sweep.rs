//! Sweeps of many variants equal single runs to the last bit.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use crate::own_scene::model_of_specs;
use machinist::error::StopCause;
use machinist::lanes::{F64x4, F64x8, Lanes};
use machinist::sweep::{InLanes, Sweepable, VariantRun, each_on_its_own, one};
use machinist::{Method, SimulateError, Simulation, Sweep};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, F64x2, Real, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes::{
    bouncing_mass, pendulum_chain, saw_gin, two_mass, winder_nonlinear,
};

/// Returns the results of single runs, one after another.
fn one_by_one<'a, S: Sweepable>(
    machine: &'a S,
    name: &str,
    values: &[f64],
    each: impl Fn(Simulation<'a>) -> Simulation<'a>,
) -> Vec<Vec<f64>> {
    let runs = values.iter().map(|value| {
        let simulation = each(Simulation::new(machine.single())).with_small_states_held(false);
        let simulation = simulation.parameter(name, *value);
        let run = simulation.expect("a parameter").run().expect("a run");
        let shape = machine.single().shape();
        let columns = run.columns[..shape.states() + shape.outputs].iter();
        columns.flat_map(|column| column.values.clone()).collect()
    });
    runs.collect()
}

/// Returns the numbers of a run, column after column.
fn columns(run: &VariantRun) -> Vec<f64> {
    let of = |rows: &[Vec<f64>]| -> Vec<f64> {
        let width = rows.first().map_or(0, Vec::len);
        (0..width).flat_map(|column| rows.iter().map(move |row| row[column])).collect()
    };
    [of(&run.states), of(&run.outputs)].concat()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

fn assert_same<'a, S: Sweepable>(
    machine: &'a S,
    name: &str,
    values: &[f64],
    each: impl Fn(Simulation<'a>) -> Simulation<'a> + Sync + Copy + 'a,
) {
    let expected = one_by_one(machine, name, values, each);
    for threads in [1, 2] {
        let sweep = Sweep::new(machine).each(each).vary(name, values).expect("a parameter");
        let runs = sweep.threads(threads).run();
        assert_eq!(runs.len(), values.len());
        for ((run, expected), value) in runs.iter().zip(&expected).zip(values) {
            let run = run.as_ref().expect("a run");
            assert_eq!(bits(&columns(run)), bits(expected), "{name} = {value}, {threads} threads");
        }
    }
}

fn spread(from: f64, until: f64, count: usize) -> Vec<f64> {
    let share = |index: usize| index as f64 / (count - 1) as f64;
    (0..count).map(|index| from * (until / from).powf(share(index))).collect()
}

#[test]
fn lanes_give_the_bits_of_single_runs_whatever_the_threads() {
    // More variants than a chunk, not a multiple of the lanes, with jumps at different times.
    assert_same(&saw_gin::SawGin, "coupling.stiffness", &spread(1e3, 1e5, 75), |run| {
        run.until(0.15).points(4).rtol(1e-7).method(Method::Taylor)
    });
    assert_same(&pendulum_chain::PendulumChain, "chain.l_1", &spread(0.5, 2.0, 11), |run| {
        run.until(1.0).points(7).rtol(1e-9).method(Method::Taylor)
    });
    assert_same(
        &winder_nonlinear::WinderNonlinear,
        "holder.package_radius",
        &spread(0.06, 0.12, 9),
        |run| run.until(0.3).points(5).rtol(1e-10).method(Method::Taylor),
    );
}

#[test]
fn auto_in_lanes_gives_the_bits_of_single_runs() {
    // `auto` checks within steps, and leaves Taylor's method where the coupling is stiff, in some
    // variants from the start.
    assert_same(&saw_gin::SawGin, "coupling.stiffness", &spread(1e3, 1e9, 75), |run| {
        run.until(0.3).points(4).rtol(1e-6).method(Method::Auto)
    });
    let all = Sweep::new(&saw_gin::SawGin)
        .each(|run| run.until(0.3).points(4).rtol(1e-6).method(Method::Auto))
        .vary("coupling.stiffness", &spread(1e3, 1e9, 75))
        .expect("a parameter");
    let steps: Vec<u64> = all.run().iter().map(|run| run.as_ref().expect("a run").steps).collect();
    let alone = spread(1e3, 1e9, 75).into_iter().map(|stiffness| {
        let run = Simulation::new(&saw_gin::SawGin).until(0.3).points(4).rtol(1e-6);
        let run = run.with_small_states_held(false);
        let run = run.method(Method::Auto).parameter("coupling.stiffness", stiffness);
        run.expect("a parameter").run().expect("a run")
    });
    let (mut changed, mut stayed) = (0, 0);
    for (run, steps) in alone.zip(steps) {
        assert_eq!(run.work.steps, steps);
        let changes = run.notes.iter().any(|note| note.contains("radau"));
        if changes { changed += 1 } else { stayed += 1 }
    }
    assert!(changed >= 3 && stayed > 3, "{changed} change the method, {stayed} do not");
    // Tolerances looser than those of steps, linear machines, sums too long for series, and events.
    assert_same(&pendulum_chain::PendulumChain, "chain.l_1", &spread(0.5, 2.0, 11), |run| {
        run.until(1.0).points(7).rtol(1e-3).method(Method::Auto)
    });
    assert_same(&two_mass::TwoMass, "coupling.stiffness", &spread(1e2, 1e6, 9), |run| {
        run.until(0.2).points(3).rtol(1e-6).method(Method::Auto)
    });
    let name = <_ as Describe>::parameter(&bouncing_mass::BouncingMass, 0).name;
    assert_same(&bouncing_mass::BouncingMass, name, &[0.9, 1.0], |run| {
        run.until(0.5).points(5).method(Method::Auto)
    });
}

/// A model with two variants at a time.
struct InPairs(ModelSimulator);

impl Sweepable for InPairs {
    fn single(&self) -> &dyn Simulator<f64> {
        self.0.single()
    }
    fn in_lanes(&self) -> Option<InLanes<'_>> {
        Some(InLanes::Two(self.0.in_pairs()))
    }
}

#[test]
fn models_in_pairs_give_the_bits_of_single_runs() {
    for make in [ModelSimulator::compiled_at_once, ModelSimulator::interpreted] {
        let machine = InPairs(make(model_of_specs("saw_gin", Keep::Needed)));
        for method in [Method::Taylor, Method::Auto] {
            assert_same(&machine, "coupling.stiffness", &spread(1e3, 1e7, 9), |run| {
                run.until(0.1).points(4).rtol(1e-7).method(method)
            });
        }
    }
}

#[test]
fn machines_that_threads_do_not_share_give_the_same_on_any_number() {
    let lengths: Vec<Vec<f64>> =
        spread(0.5, 2.0, 40).into_iter().map(|length| vec![length]).collect();
    let runs = |threads: usize| {
        let make = || Ok::<_, SimulateError>(pendulum_chain::PendulumChain);
        let run = |machine: &pendulum_chain::PendulumChain, variant: &[f64]| {
            let run = Simulation::new(machine).parameter("chain.l_1", variant[0])?;
            one(&run.until(0.1).points(3))
        };
        each_on_its_own(&lengths, threads, make, run).expect("machines")
    };
    let alone = runs(1);
    assert_eq!(alone.len(), 40);
    assert!(alone.iter().all(Result::is_ok) && alone == runs(2));
    let none = || Err::<pendulum_chain::PendulumChain, _>("no machine");
    let never = |_: &pendulum_chain::PendulumChain, _: &[f64]| unreachable!("there is none");
    assert_eq!(each_on_its_own(&lengths, 2, none, never), Err("no machine"));
}

#[test]
fn other_methods_share_threads_and_keep_their_bits() {
    assert_same(&two_mass::TwoMass, "coupling.stiffness", &spread(1e2, 1e6, 70), |run| {
        run.until(0.2).points(3).rtol(1e-6).method(Method::Radau)
    });
}

#[test]
fn a_variant_that_cannot_be_run_leaves_the_others_alone() {
    let values = [1e4, f64::NAN, 2e4, 3e4];
    let each =
        |run: Simulation<'static>| run.until(0.02).points(2).rtol(1e-6).method(Method::Taylor);
    let sweep = Sweep::new(&saw_gin::SawGin).each(each).vary("coupling.stiffness", &values);
    let runs = sweep.expect("a parameter").run();
    assert!(matches!(&runs[1], Err(SimulateError::NotFinite { .. })), "{:?}", runs[1]);
    let alone = one_by_one(&saw_gin::SawGin, "coupling.stiffness", &[1e4, 2e4, 3e4], each);
    for (run, alone) in [&runs[0], &runs[2], &runs[3]].into_iter().zip(&alone) {
        assert_eq!(bits(&columns(run.as_ref().expect("a run"))), bits(alone));
    }
    let few = Sweep::new(&saw_gin::SawGin).each(move |run| each(run).max_steps(2)).run();
    match &few[0] {
        Err(SimulateError::Stopped { cause: StopCause::TooManySteps { limit: 2 }, .. }) => {}
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_leaves_doubles_stops_as_alone_and_leaves_its_neighbours() {
    // Torques are squares of fluxes, which are proportional to the voltage.
    let values = [220.0, 1e80, 1e153, 230.0, 1e155, 1e200, 1e290, 240.0, 1e154, 250.0];
    let of = |run: Simulation<'static>| run.until(0.02).points(3).method(Method::Taylor);
    for rtol in [1e-3, 1e-9] {
        let each = move |run| of(run).rtol(rtol).max_steps(400);
        let sweep = Sweep::new(&saw_gin::SawGin).each(each).vary("motor.phase_voltage", &values);
        let runs = sweep.expect("a parameter").threads(1).run();
        let mut stopped = 0;
        for (run, value) in runs.iter().zip(values) {
            let alone = each(Simulation::new(&saw_gin::SawGin))
                .parameter("motor.phase_voltage", value)
                .and_then(|run| run.run());
            match (run, alone) {
                (Ok(run), Ok(alone)) => {
                    let shape = saw_gin::SawGin.shape();
                    let all = alone.columns[..shape.states() + shape.outputs].iter();
                    let all: Vec<f64> = all.flat_map(|column| column.values.clone()).collect();
                    assert_eq!(bits(&columns(run)), bits(&all), "{value:e}");
                }
                (Err(in_lanes), Err(alone)) => {
                    assert_eq!(in_lanes.to_string(), alone.to_string(), "{value:e}");
                    stopped += 1;
                }
                (in_lanes, alone) => panic!("{value:e}: {in_lanes:?}, alone {alone:?}"),
            }
        }
        // The other variants are like those of the study.
        assert!((3..=6).contains(&stopped), "{stopped} at {rtol:e}");
    }
}

#[test]
fn a_variant_whose_steps_lead_nowhere_stops_as_alone_and_leaves_its_neighbours() {
    fn each(run: Simulation<'_>) -> Simulation<'_> {
        run.until(0.5).points(2).rtol(1e-6).max_steps(2_000_000).method(Method::Taylor)
    }
    // Steps of some 1e-14 of the run, and runs with many steps that end.
    let values = [1e4, 1e28, 1e13, 2e4];
    let machine =
        InPairs(ModelSimulator::compiled_at_once(model_of_specs("saw_gin", Keep::Needed)));
    let sweep = Sweep::new(&machine).each(each).vary("coupling.stiffness", &values);
    let runs = sweep.expect("a parameter").run();
    for (run, value) in runs.iter().zip(values) {
        let alone = each(Simulation::new(machine.single())).parameter("coupling.stiffness", value);
        let alone = one(&alone.expect("a parameter"));
        let is_hopeless =
            matches!(run, Err(SimulateError::Stopped { cause: StopCause::TooSlowPace { .. }, .. }));
        assert_eq!(is_hopeless, value > 1e20, "{value:e}: {run:?}");
        match (run, alone) {
            (Ok(run), Ok(alone)) => {
                assert_eq!(run.steps, alone.steps, "{value:e}");
                assert_eq!(bits(&columns(run)), bits(&columns(&alone)), "{value:e}");
            }
            (Err(run), Err(alone)) => assert_eq!(run.to_string(), alone.to_string()),
            other => panic!("{value:e}: {other:?}"),
        }
    }
}

#[test]
fn a_variant_that_takes_too_long_stops_and_leaves_its_neighbours() {
    // Steps of some 1e-14 of the run.
    let values = [1e4, 1e28, 2e4, 3e4, 1e28];
    let machine =
        InPairs(ModelSimulator::compiled_at_once(model_of_specs("saw_gin", Keep::Needed)));
    for method in [Method::Taylor, Method::Tsit5] {
        fn settings(run: Simulation<'_>, method: Method) -> Simulation<'_> {
            let run = run.until(0.5).points(2).rtol(1e-6).max_steps(usize::MAX).method(method);
            run.time_limit(Duration::from_secs(2))
        }
        let start = Instant::now();
        let sweep = Sweep::new(&machine)
            .each(|run| settings(run, method))
            .vary("coupling.stiffness", &values);
        let runs = sweep.expect("a parameter").run();
        assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
        for (run, value) in runs.iter().zip(values) {
            match run {
                Ok(run) => {
                    let alone = settings(Simulation::new(machine.single()), method);
                    let alone = alone.parameter("coupling.stiffness", value);
                    let alone = one(&alone.expect("a parameter")).expect("a run");
                    assert_eq!(bits(&columns(run)), bits(&columns(&alone)), "{value:e}");
                }
                Err(SimulateError::Stopped { cause: StopCause::TooSlow { seconds }, .. }) => {
                    assert_eq!((value, *seconds), (1e28, 2.0));
                }
                Err(error) => panic!("{value:e}: {error}"),
            }
        }
        assert_eq!(runs.iter().filter(|run| run.is_err()).count(), 2);
    }
}

#[test]
fn a_flag_stops_variants_in_lanes() {
    let flag = AtomicBool::new(true);
    for method in [Method::Taylor, Method::Auto] {
        let sweep = Sweep::new(&saw_gin::SawGin)
            .each(|run| run.until(1e9).points(2).method(method).until_flagged(&flag));
        for run in sweep.vary("coupling.stiffness", &[1e4, 2e4]).expect("a parameter").run() {
            let Err(SimulateError::Stopped { cause, .. }) = run else { panic!("{run:?}") };
            assert_eq!(cause, StopCause::Interrupted);
        }
    }
}

#[test]
fn machines_with_events_run_one_by_one() {
    let machine = &bouncing_mass::BouncingMass;
    let name = <_ as Describe>::parameter(machine, 0).name;
    let default = <_ as Describe>::parameter_default(machine, 0);
    assert_same(machine, name, &[default, 1.5 * default], |run| {
        run.until(0.5).points(5).method(Method::Taylor)
    });
    let run = Simulation::new(machine).until(0.5).points(5).method(Method::Taylor).run();
    assert!(!run.expect("a run").switches.is_empty());
}

#[test]
fn a_grid_takes_every_pair_with_the_last_parameter_fastest() {
    let sweep = Sweep::new(&two_mass::TwoMass)
        .each(|run| run.until(0.01).points(2).method(Method::Exact))
        .vary("coupling.stiffness", &[1e3, 1e4])
        .and_then(|sweep| sweep.vary("load_torque", &[10.0, 20.0, 30.0]))
        .expect("parameters");
    let runs: Vec<VariantRun> = sweep.run().into_iter().map(|run| run.expect("a run")).collect();
    assert_eq!(runs.len(), 6);
    let end = |index: usize| runs[index].states[1].clone();
    assert_ne!(end(0), end(1));
    assert_ne!(end(0), end(3));
    assert!(Sweep::new(&two_mass::TwoMass).vary("coupling.stifness", &[1.0]).is_err());
}

type Operation = fn(f64, f64) -> f64;

#[test]
fn lanes_round_as_single_numbers_do() {
    fn check<R: Lanes>() {
        let numbers = [0.0, -0.0, 1.5, -2.25, 1e-300, 3e200, f64::INFINITY, f64::NAN, 0.7];
        let pairs = numbers.iter().flat_map(|a| numbers.iter().map(move |b| (*a, *b)));
        let pairs: Vec<(f64, f64)> = pairs.collect();
        for chunk in pairs.chunks(R::COUNT) {
            let (mut a, mut b) = (R::splat(1.0), R::splat(1.0));
            for (lane, (x, y)) in chunk.iter().enumerate() {
                a.set_lane(lane, *x);
                b.set_lane(lane, *y);
            }
            let operations: [(R, Operation); 16] = [
                (a + b, |x, y| x + y),
                (a - b, |x, y| x - y),
                (a * b, |x, y| x * y),
                (a / b, |x, y| x / y),
                (-a, |x, _| -x),
                (Real::sqrt(a), |x, _| x.sqrt()),
                (Real::abs(a), |x, _| x.abs()),
                (R::select_less(a, b, a, b), |x, y| if x < y { x } else { y }),
                (Real::sin(a), |x, _| Real::sin(x)),
                (Real::exp(a), |x, _| Real::exp(x)),
                (Real::tanh(a), |x, _| Real::tanh(x)),
                (Real::tanh_each([a, b])[1], |_, y| Real::tanh(y)),
                (Real::sin_cos_each([b, a])[1].1, |x, _| Real::cos(x)),
                (Real::atan(a), |x, _| x.atan()),
                (Real::powf(a, b), f64::powf),
                (Real::powi(a, 5), |x, _| Real::powi(x, 5)),
            ];
            for (number, (found, expected)) in operations.iter().enumerate() {
                for (lane, (x, y)) in chunk.iter().enumerate() {
                    let (found, expected) = (found.lane(lane), expected(*x, *y));
                    let same = found.to_bits() == expected.to_bits()
                        || (found.is_nan() && expected.is_nan());
                    assert!(same, "operation {number} of {x} and {y}: {found} for {expected}");
                }
            }
        }
    }
    check::<F64x2>();
    check::<F64x4>();
    check::<F64x8>();
}

#[test]
fn simulators_run_on_lanes_as_on_single_numbers() {
    let machine = saw_gin::SawGin;
    let single: &dyn Simulator<f64> = &machine;
    let lanes: &dyn Simulator<F64x4> = &machine;
    let shape = single.shape();
    let parameters: Vec<f64> =
        (0..shape.parameters).map(|index| single.parameter_default(index)).collect();
    let state = |lane: usize| -> Vec<f64> {
        (0..shape.states()).map(|index| (1.0 + index as f64 + 0.3 * lane as f64).sin()).collect()
    };
    let wide_state: Vec<F64x4> = (0..shape.states())
        .map(|index| F64x4::from(std::array::from_fn(|lane| state(lane)[index])))
        .collect();
    let wide_parameters: Vec<F64x4> = parameters.iter().map(|p| F64x4::splat(*p)).collect();
    let mut wide_rate = vec![F64x4::splat(0.0); shape.states()];
    lanes.rate(F64x4::splat(0.3), &wide_state, &wide_parameters, &mut wide_rate);
    for lane in 0..4 {
        let mut rate = vec![0.0; shape.states()];
        single.rate(0.3, &state(lane), &parameters, &mut rate);
        let found: Vec<f64> = wide_rate.iter().map(|rate| rate.lane(lane)).collect();
        assert_eq!(bits(&found), bits(&rate));
    }
}
