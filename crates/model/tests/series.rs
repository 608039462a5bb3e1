//! Compiled recurrences are compared with interpreted ones, and two lanes with each number alone,
//! to the last bit.

mod support;

use fastrand::Rng;
use machinist_contract::Simulator;
use machinist_contract::taylor::TaylorSeries;
use machinist_model::{
    F64x2, Function, MatrixTape, Model, ModelSimulator, NodeId, Op, Running, TableId, Tape,
};

use support::{PARAMETERS, Writer, matrix, model, numbers, random_tape, tape};

fn assert_same(found: &[f64], expected: &[f64], what: &str) {
    for (index, (a, b)) in found.iter().zip(expected).enumerate() {
        let is_same = a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        assert!(is_same, "{what}: number {index} is {a:e} and should be {b:e}");
    }
}

fn series<R: machinist_model::Lane>(
    simulator: &ModelSimulator,
    (time, state, parameters): (R, &[R], &[R]),
    order: usize,
) -> Vec<R>
where
    ModelSimulator: Simulator<R>,
{
    let mut coefficients = vec![R::literal(0.0); state.len() * (order + 1)];
    let series: &dyn TaylorSeries<R> = simulator.taylor().expect("no constraints");
    // Filled with NaN, to show that no initial value is read.
    let mut workspace = vec![R::literal(f64::NAN); series.series_workspace(order)];
    series.series(time, state, parameters, &mut coefficients, &mut workspace);
    coefficients
}

/// Compares the series of a model in all four ways.
fn check(rng: &mut Rng, model: &Model, what: &str) {
    let states = model.states.len();
    let compiled = ModelSimulator::compiled_at_once(model.clone());
    let interpreted = ModelSimulator::interpreted(model.clone());
    assert_eq!(interpreted.running(), Running::Interpreted);
    for order in [0, 1, 2, 3, 4, 5, 9, 20] {
        let times = [rng.f64(), rng.f64()];
        let state = [(); 2].map(|()| numbers(rng, states));
        let parameters = [(); 2].map(|()| numbers(rng, PARAMETERS));
        let both = |[a, b]: &[Vec<f64>; 2]| -> Vec<F64x2> {
            a.iter().zip(b).map(|(a, b)| F64x2([*a, *b])).collect()
        };
        let sides = (F64x2(times), &both(&state)[..], &both(&parameters)[..]);
        let [side_by_side, also] =
            [&compiled, &interpreted].map(|simulator| series(simulator, sides, order));
        for lane in 0..2 {
            let of_lane = (times[lane], &state[lane][..], &parameters[lane][..]);
            let expected = series(&interpreted, of_lane, order);
            let found = series(&compiled, of_lane, order);
            assert_same(&found, &expected, &format!("{what}, order {order}"));
            for all in [&side_by_side, &also] {
                let found: Vec<f64> = all.iter().map(|sides| sides.0[lane]).collect();
                assert_same(&found, &expected, &format!("{what}, order {order}, lane {lane}"));
            }
        }
    }
}

/// A model with every function and operation that has a recurrence.
fn one_of_each() -> Model {
    let mut writer = Writer::default();
    let push = &mut |op| writer.push(op);
    let (time, x, v, z) =
        (push(Op::Time), push(Op::State(0)), push(Op::State(1)), push(Op::State(2)));
    let [p, half, two] = [Op::Parameter(0), Op::Literal(0.5), Op::Literal(2.5)].map(&mut *push);
    let turning = push(Op::Mul(time, p));
    let mut terms = Vec::new();
    for (function, _) in Function::ALL {
        for argument in [x, turning] {
            let small = push(Op::Mul(argument, half));
            terms.push(push(Op::Call(function, small)));
        }
    }
    for op in [
        Op::Mul(x, v),
        Op::Mul(time, v),
        Op::Mul(time, time),
        Op::Div(p, v),
        Op::Div(z, turning),
        Op::Div(x, z),
        Op::Powi(x, 3),
        Op::Powi(v, -2),
        Op::Powf(z, two),
        Op::Powf(z, x),
        Op::Sub(p, x),
        Op::Sub(x, p),
        Op::SelectLess { lhs: x, rhs: v, then: p, otherwise: z },
        Op::Table { table: TableId(0), order: 0, argument: z },
        Op::Table { table: TableId(0), order: 1, argument: turning },
    ] {
        terms.push(push(op));
    }
    let mut sum = p;
    for term in terms {
        let scaled = push(Op::Mul(term, half));
        sum = push(Op::Add(sum, scaled));
    }
    let bounded = push(Op::Call(Function::Sin, sum));
    let rate = writer.finish(&[v, bounded, bounded]);
    let one = tape(&[Op::Literal(1.0)], &[0]);
    model(1, rate, matrix(1, 1, &[(0, 0)], one.clone()), one)
}

#[test]
fn every_recurrence_gives_the_same_bits() {
    let mut rng = Rng::with_seed(1);
    for _ in 0..20 {
        check(&mut rng, &one_of_each(), "one of each");
    }
}

/// A variable mass matrix with structural zeros: M_ii = 4 + sin(q_i), M_ij = cos(q_j)/2 for some.
fn coupled(n: usize, entries: &[(u32, u32)]) -> Model {
    let mut writer = Writer::default();
    let push = &mut |op| writer.push(op);
    let [four, half] = [4.0, 0.5].map(|value| push(Op::Literal(value)));
    let q: Vec<NodeId> = (0..n as u32).map(|index| push(Op::State(index))).collect();
    let mut all: Vec<(u32, u32)> = (0..n as u32).map(|index| (index, index)).collect();
    all.extend(entries.iter().flat_map(|&(row, column)| [(row, column), (column, row)]));
    all.sort_unstable();
    let values: Vec<NodeId> = all
        .iter()
        .map(|&(row, column)| {
            let place = q[row.max(column) as usize];
            if row == column {
                let sine = push(Op::Call(Function::Sin, place));
                push(Op::Add(four, sine))
            } else {
                let cosine = push(Op::Call(Function::Cos, place));
                push(Op::Mul(cosine, half))
            }
        })
        .collect();
    let mass = matrix(n, n, &all, writer.finish(&values));
    let mut writer = Writer::default();
    let q: Vec<NodeId> = (0..2 * n as u32).map(|index| writer.push(Op::State(index))).collect();
    let forces: Vec<NodeId> =
        (0..n).map(|index| writer.push(Op::Mul(q[index], q[(index + n + 1) % (2 * n)]))).collect();
    let forcing = writer.finish(&forces);
    // The rates of velocities are not read: accelerations are solved for.
    let rate: Vec<Op> = (0..=2 * n as u32).map(Op::State).collect();
    let results: Vec<u32> = (n as u32..=2 * n as u32).chain(0..n as u32).collect();
    model(n, tape(&rate, &results), mass, forcing)
}

#[test]
fn mass_matrices_that_move_give_the_same_bits() {
    let mut rng = Rng::with_seed(2);
    check(&mut rng, &coupled(2, &[(1, 0)]), "two bodies");
    check(&mut rng, &coupled(5, &[(1, 0), (4, 1), (3, 2), (3, 0)]), "five bodies");
    let all: Vec<(u32, u32)> =
        (0..9).flat_map(|row| (0..row).map(move |column| (row, column))).collect();
    check(&mut rng, &coupled(9, &all), "nine bodies, all of them coupled");
}

/// A random rate, without inputs that a model does not have.
fn random_rate(rng: &mut Rng, length: usize) -> Tape {
    let mut rate = random_tape(rng, length, 0.2);
    for node in &mut rate.nodes {
        match node.op {
            Op::Constant(entry) | Op::Handed(entry) => node.op = Op::Parameter(entry % 5),
            Op::State(entry) => node.op = Op::State(entry % 5),
            _ => {}
        }
    }
    rate.results.truncate(5);
    rate
}

fn random_model(rng: &mut Rng, length: usize) -> Model {
    let ones = tape(&[Op::Literal(1.0)], &[0, 0]);
    let mass: MatrixTape = matrix(2, 2, &[(0, 0), (1, 1)], ones.clone());
    model(2, random_rate(rng, length), mass, ones)
}

#[test]
fn random_rates_have_the_same_series() {
    let mut rng = Rng::with_seed(3);
    for round in 0..60 {
        let length = rng.usize(8..150);
        let model = random_model(&mut rng, length);
        model.validate().expect("a model");
        check(&mut rng, &model, &format!("round {round}"));
    }
}

#[test]
fn series_go_on_the_same_where_machine_code_takes_over() {
    const CALLS: usize = 1100;
    const ORDER: usize = 8;
    let mut rng = Rng::with_seed(5);
    let model = random_model(&mut rng, 60);
    let states = model.states.len();
    let interpreted = ModelSimulator::interpreted(model.clone());
    let both = ModelSimulator::new(model);
    // Requested once, as methods do.
    let mut workspace = vec![f64::NAN; TaylorSeries::<f64>::series_workspace(&both, ORDER)];
    let mut found = vec![f64::NAN; (ORDER + 1) * states];
    for call in 0..CALLS {
        let (time, state) = (rng.f64(), numbers(&mut rng, states));
        let parameters = numbers(&mut rng, PARAMETERS);
        both.series(time, &state, &parameters, &mut found, &mut workspace);
        let expected = series(&interpreted, (time, &state[..], &parameters[..]), ORDER);
        assert_same(&found, &expected, &format!("call {call}"));
    }
}

#[test]
fn functions_are_the_same_in_lanes_and_on_threads() {
    let mut rng = Rng::with_seed(4);
    for length in [30, 300, 3000] {
        let model = random_model(&mut rng, length);
        let compiled = ModelSimulator::compiled_at_once(model.clone());
        let interpreted = ModelSimulator::interpreted(model);
        let states: Vec<Vec<f64>> = (0..8).map(|_| numbers(&mut rng, 5)).collect();
        let parameters = numbers(&mut rng, PARAMETERS);
        let rate = |simulator: &ModelSimulator, state: &[f64]| {
            let mut rate = [0.0; 5];
            simulator.rate(0.25, state, &parameters, &mut rate);
            rate
        };
        std::thread::scope(|scope| {
            for pair in states.chunks(2) {
                let (compiled, interpreted, parameters) = (&compiled, &interpreted, &parameters);
                scope.spawn(move || {
                    let state: [F64x2; 5] =
                        std::array::from_fn(|index| F64x2([pair[0][index], pair[1][index]]));
                    let wide: Vec<F64x2> = parameters.iter().map(|p| F64x2([*p; 2])).collect();
                    let mut rates = [[F64x2([0.0; 2]); 5]; 2];
                    for (simulator, rate) in [compiled, interpreted].into_iter().zip(&mut rates) {
                        simulator.rate(F64x2([0.25; 2]), &state, &wide, rate);
                    }
                    for (lane, state) in pair.iter().enumerate() {
                        let expected = rate(interpreted, state);
                        assert_same(&rate(compiled, state), &expected, "alone");
                        for all in &rates {
                            assert_same(&all.map(|sides| sides.0[lane]), &expected, "in lanes");
                        }
                    }
                });
            }
        });
        let constants = Simulator::<f64>::constants(&compiled);
        let mut known = vec![0.0; constants];
        compiled.prepare(&parameters, &mut known);
        let mut prepared = [0.0; 5];
        compiled.prepared_rate(0.25, &states[0], &parameters, &known, &mut prepared);
        assert_same(&prepared, &rate(&interpreted, &states[0]), "prepared");
    }
}
