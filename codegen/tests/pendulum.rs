//! Comparison of a derived chain of pendulums with the equations written by hand:
//!
//! ```text
//! sum_j w_ij cos(th_i - th_j) th_j'' + w_ij sin(th_i - th_j) th_j'^2 + (n - i) g sin th_i = 0
//! w_ij = n - max(i, j)
//! ```

use crate::support;
use machinist_algebra::cas::{Algebra, session};
use machinist_algebra::expr::{CoordinateId, Expr, Function, ParameterId, Symbol};
use machinist_codegen::lower::lower;
use machinist_codegen::lower::structure::Structure;
use machinist_codegen::mechanics::lagrange;
use machinist_codegen::mechanics::linearize::linearize;
use machinist_codegen::scene::system::{Coordinate, GeneralizedForce, LagrangianSystem, Parameter};
use machinist_contract::PowerBalance;
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{Model, ModelSimulator, Tape};
use num_rational::BigRational;

fn number(n: i64) -> Expr {
    Expr::Number(BigRational::from_integer(n.into()))
}

fn squared(expr: Expr) -> Expr {
    Expr::Power(Box::new(expr), Box::new(number(2)))
}

fn empty_system() -> LagrangianSystem {
    LagrangianSystem {
        coordinates: vec![],
        first_order: vec![],
        parameters: vec![],
        outputs: vec![],
        checks: vec![],
        tables: vec![],
        discontinuities: vec![],
        events: vec![],
        constraints: vec![],
        generalized_force: vec![],
        ..support::pendulum_system()
    }
}

/// Returns n unit masses on unit links, by absolute angles. The velocities of the masses are
/// written out in Cartesian components: T = sum of (x'^2 + y'^2)/2.
fn chain(n: u32) -> LagrangianSystem {
    let angle = |i| Expr::Symbol(Symbol::Coordinate(CoordinateId(i)));
    let speed = |i| Expr::Symbol(Symbol::Velocity(CoordinateId(i)));
    let call = |function, i| Expr::Call(function, vec![angle(i)]);
    let gravity = Expr::Symbol(Symbol::Parameter(ParameterId(0)));
    let half = Expr::Number(BigRational::new(1.into(), 2.into()));
    let component = |function, mass: u32| {
        let links = 0..=mass;
        squared(Expr::Sum(
            links.map(|i| Expr::Product(vec![speed(i), call(function, i)])).collect(),
        ))
    };
    let kinetic = (0..n)
        .flat_map(|mass| [component(Function::Cos, mass), component(Function::Sin, mass)])
        .map(|square| Expr::Product(vec![half.clone(), square]));
    let potential = (0..n).map(|i| {
        let weight = number(-i64::from(n - i));
        Expr::Product(vec![weight, gravity.clone(), call(Function::Cos, i)])
    });
    let mut system = empty_system();
    system.kinetic = Expr::Sum(kinetic.collect());
    system.potential = Expr::Sum(potential.collect());
    system.coordinates = (0..n)
        .map(|i| Coordinate {
            position: support::quantity(&format!("th_{i}"), "rad", "angle"),
            velocity: support::quantity(&format!("th_{i}_dot"), "rad/s", "speed"),
            identified: vec![],
            initial: [number(0), number(0)],
            is_given: [true; 2],
            scale: [1.0, 5.0],
        })
        .collect();
    let none = GeneralizedForce { total: number(0), conversion: number(0) };
    system.generalized_force = vec![none; n as usize];
    system.parameters = vec![Parameter {
        quantity: support::quantity("g", "m/s^2", "gravity"),
        value: 9.81,
        tunable: true,
    }];
    system
}

fn program(system: LagrangianSystem) -> Model {
    let linearization = session("a test", Algebra::default(), move |cas| {
        let equations = lagrange::derive(cas, &system);
        linearize(cas, &equations)
    });
    lower(&linearization.expect("a session"))
}

fn evaluate(tape: &Tape, state: &[f64]) -> Vec<f64> {
    let mut results = vec![0.0; tape.results.len()];
    let inputs = Inputs { state, parameters: &[9.81], ..Inputs::default() };
    Evaluator::new(tape).evaluate(&inputs, &mut results);
    results
}

/// Returns pseudorandom angles and speeds.
fn states(n: usize) -> impl Iterator<Item = Vec<f64>> {
    let mut seed = 7_u64;
    let mut next = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 * 6.0 - 3.0
    };
    std::iter::repeat_with(move || (0..2 * n).map(|_| next()).collect())
}

#[test]
fn derived_equations_are_the_ones_of_the_textbook() {
    for n in [1_usize, 2, 3, 5] {
        let program = program(chain(n as u32));
        for state in states(n).take(50) {
            let (angle, speed) = state.split_at(n);
            let weight = |i: usize, j: usize| (n - i.max(j)) as f64;
            let mass = evaluate(&program.mass_matrix.tape, &state);
            for ((i, j), value) in program.mass_matrix.pattern.entries.iter().zip(mass) {
                let (i, j) = (*i as usize, *j as usize);
                let expected = weight(i, j) * (angle[i] - angle[j]).cos();
                assert!((value - expected).abs() < 1e-13 * n as f64, "M[{i}][{j}] of {n}");
            }
            let forcing = evaluate(&program.forcing, &state);
            for i in 0..n {
                let centrifugal: f64 = (0..n)
                    .map(|j| weight(i, j) * (angle[i] - angle[j]).sin() * speed[j] * speed[j])
                    .sum();
                let expected = -centrifugal - (n - i) as f64 * 9.81 * angle[i].sin();
                assert!((forcing[i] - expected).abs() < 1e-12 * n as f64, "f[{i}] of {n}");
            }
        }
    }
}

#[test]
fn accelerations_solve_the_mass_matrix() {
    let n = 4;
    let program = program(chain(n as u32));
    for state in states(n).take(20) {
        let rate = evaluate(&program.rate, &state);
        let mass = evaluate(&program.mass_matrix.tape, &state);
        let mut residual = evaluate(&program.forcing, &state);
        for ((i, j), value) in program.mass_matrix.pattern.entries.iter().zip(mass) {
            residual[*i as usize] -= value * rate[n + *j as usize];
        }
        let largest = residual.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
        assert!(largest < 1e-10, "residual {largest}");
    }
}

#[test]
fn jacobian_of_a_full_mass_matrix_agrees_with_differences() {
    // Solved on the graph, and in a loop.
    for (n, is_looped) in [(3, false), (10, true)] {
        let program = program(chain(n as u32));
        assert_eq!(program.rate_jacobian.solve.is_some(), is_looped);
        let pattern = program.rate_jacobian.pattern.entries.clone();
        let rate = program.rate.clone();
        let simulator = ModelSimulator::interpreted(program);
        for state in states(n).take(if is_looped { 2 } else { 10 }) {
            let mut jacobian = vec![0.0; pattern.len()];
            simulator.single().rate_jacobian(0.0, &state, &[9.81], &mut jacobian);
            let mut dense = vec![vec![0.0; 2 * n]; 2 * n];
            for ((i, j), value) in pattern.iter().zip(jacobian) {
                dense[*i as usize][*j as usize] = value;
            }
            for column in 0..2 * n {
                assert_column_is_of_differences(&rate, &state, &dense, column);
            }
        }
    }
}

fn assert_column_is_of_differences(rate: &Tape, state: &[f64], dense: &[Vec<f64>], column: usize) {
    // Richardson's extrapolation of two central differences, order 4.
    let slope = |h: f64| {
        let moved = |by: f64| {
            let mut moved = state.to_vec();
            moved[column] += by;
            evaluate(rate, &moved)
        };
        let (plus, minus) = (moved(h), moved(-h));
        let each = plus.into_iter().zip(minus).map(move |(p, m)| (p - m) / (2.0 * h));
        each.collect::<Vec<f64>>()
    };
    let (coarse, fine) = (slope(2e-3), slope(1e-3));
    for row in 0..state.len() {
        let expected = (4.0 * fine[row] - coarse[row]) / 3.0;
        let scale = 1.0 + expected.abs();
        assert!((dense[row][column] - expected).abs() < 1e-6 * scale, "({row}, {column})");
    }
}

#[test]
fn a_conservative_chain_neither_gains_nor_loses_energy() {
    // Functions of ten links share the motion.
    for n in [5, 10] {
        let program = program(chain(n));
        assert_eq!(program.motion.is_some(), n == 10);
        let simulator = ModelSimulator::interpreted(program);
        for state in states(n as usize).take(20) {
            let balance = simulator.single().power_balance(0.0, &state, &[9.81]);
            let PowerBalance { stored_rate, supplied, dissipated } = balance;
            assert!(supplied == 0.0 && dissipated == 0.0, "nothing supplied, nothing lost");
            assert!(stored_rate.abs() < 1e-8, "stored rate {stored_rate}");
        }
    }
}

#[test]
fn cartesian_components_are_put_together_by_the_addition_theorem() {
    let program = program(chain(5));
    let cosines = |tape: &Tape| {
        let nodes = tape.nodes.iter();
        nodes.filter(|node| format!("{:?}", node.op).starts_with("Call(Cos")).count()
    };
    assert_eq!(cosines(&program.mass_matrix.tape), 10, "one for each pair of links");
}

#[test]
fn links_are_coupled_by_their_angles_which_follow_their_speeds() {
    let two = Structure::of(&program(chain(2)));
    assert!(!two.constant_mass && !two.diagonal_mass && two.autonomous);
    assert_eq!((two.linear_rows, two.linear_part), (vec![0, 1], vec![]));
    assert_eq!(two.subsystems, [[0, 1, 2, 3]]);
    // Two masses that are independent of each other.
    let speed = |i| squared(Expr::Symbol(Symbol::Velocity(CoordinateId(i))));
    let apart = LagrangianSystem {
        kinetic: Expr::Sum(vec![speed(0), speed(1)]),
        potential: number(0),
        ..chain(2)
    };
    let apart = Structure::of(&program(apart));
    assert!(apart.constant_mass && apart.diagonal_mass && apart.is_linear());
    assert_eq!(apart.subsystems, [[0, 2], [1, 3]]);
}
