//! Comparison of both derivations for random systems, and of the second one with closed forms.
//!
//! `MACHINIST_SYSTEMS=10000 cargo test --release -p machinist-codegen --lib random_systems --
//! --nocapture` derives as many by each algebra, from seed `MACHINIST_SEED`;
//! `MACHINIST_ALGEBRA=plain` uses that algebra only.

use std::cell::RefCell;
use std::str::FromStr;

use machinist_algebra::cas::Algebra;
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Function, Symbol};
use machinist_model::ModelSimulator;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::formula::Formula;
use super::motion::{Machine, Place};
use super::random::Random;
use super::systems::{Recipe, recipes};
use super::{Comparison, Deviation};
use crate::pipeline;
use crate::scene::along::{NoRate, rate};
use crate::scene::system::LagrangianSystem;

/// Default number of systems.
const SYSTEMS: u32 = 50;
/// Default seed.
const SEED: u64 = 0x5eed;
/// Numbers of terms of a kind, by default and as set by the environment.
const FEW_TERMS: usize = 1;
const TERMS: usize = 3;
/// Number of places for each system.
const PLACES: usize = 6;
/// Limit for rounding of both derivations, mainly of factors of bordered matrices.
pub const LIMIT: f64 = 1e-10;

/// Returns the deviation of a system's model, derived by some algebra, from its second
/// derivation.
pub fn deviation(recipe: &Recipe, algebra: Algebra) -> Deviation {
    let system = recipe.system();
    let model = pipeline::compile_by(algebra, system.clone(), recipe.keep)
        .unwrap_or_else(|errors| panic!("{}", errors.render()));
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let simulator = ModelSimulator::interpreted(model);
    let comparison =
        Comparison::<f64>::new(&system, &simulator, |x| x).unwrap_or_else(|e| panic!("{e}"));
    comparison.at_random(PLACES, &parameters, 1)
}

/// Returns a number set by the environment.
fn asked<N: FromStr>(variable: &str) -> Option<N> {
    let text = std::env::var(variable).ok()?;
    let number = text.parse();
    Some(number.unwrap_or_else(|_| panic!("{variable} is no number: {text}")))
}

/// Returns the algebras set by the environment: one by its name, or all.
fn algebras() -> Vec<Algebra> {
    let wanted = std::env::var("MACHINIST_ALGEBRA").ok();
    let is_wanted = |algebra: &Algebra| wanted.as_ref().is_none_or(|name| name == algebra.name());
    let found: Vec<Algebra> = Algebra::ALL.iter().copied().filter(is_wanted).collect();
    assert!(!found.is_empty(), "there is no algebra {wanted:?} here");
    found
}

#[test]
fn random_systems_are_derived_alike() {
    let systems = asked("MACHINIST_SYSTEMS");
    let terms = if systems.is_some() { TERMS } else { FEW_TERMS };
    let seed = asked("MACHINIST_SEED").unwrap_or(SEED);
    for algebra in algebras() {
        derived_alike(algebra, systems.unwrap_or(SYSTEMS), seed, terms);
    }
}

/// Checks that random systems agree with their energies, and prints the largest deviation.
fn derived_alike(algebra: Algebra, systems: u32, seed: u64, terms: usize) {
    let config = Config {
        cases: systems,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        ..Config::default()
    };
    let worst = RefCell::new(Deviation::default());
    let outcome = TestRunner::new(config).run(&recipes(terms), |recipe| {
        let found = deviation(&recipe, algebra);
        prop_assert!(found.error <= LIMIT, "{:e}: {}", found.error, found.place);
        prop_assert!(found.compared > 0, "nothing was compared");
        let before = worst.take();
        worst.replace(before.or(found));
        Ok(())
    });
    let worst = worst.into_inner();
    println!(
        "{systems} systems of seed {seed} by {}: {} numbers, the worst {:.1e}, {}",
        algebra.name(),
        worst.compared,
        worst.error,
        worst.place
    );
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// Compares `der` of the expressions of random constraints with its rate by numbers that carry
/// derivatives.
#[test]
fn rates_of_random_expressions_are_those_along_the_motion() {
    const SYSTEMS: u32 = 400;
    let config = Config {
        cases: SYSTEMS,
        rng_seed: RngSeed::Fixed(0xde7),
        failure_persistence: None,
        ..Config::default()
    };
    let compared = RefCell::new(0);
    let outcome = TestRunner::new(config).run(&recipes(TERMS), |recipe| {
        let mut system = recipe.system();
        system.constraints.iter_mut().for_each(|held| held.when.clear());
        let machine = Machine::new(&system, |x: f64| x);
        let mut random = Random(u64::from(SYSTEMS));
        let mut some = |count: usize| (0..count).map(|_| random.signed()).collect::<Vec<f64>>();
        let [n, states] = [system.coordinates.len(), system.first_order.len()];
        let parameters = system.parameters.iter().map(|parameter| parameter.value).collect();
        let (q, v, z) = (some(n), some(n), some(states));
        let place = Place { time: 0.3, q, v, z, parameters };
        let constraints = system.constraints.iter().enumerate();
        for (index, held) in constraints.filter(|(_, held)| held.is_of_positions) {
            let velocity = |symbol| match symbol {
                Symbol::Coordinate(id) => Some(Expr::Symbol(Symbol::Velocity(id))),
                _ => None,
            };
            let (rate, _) = rate(&held.expr, 100_000, &velocity).expect("it has one");
            let Some([_, expected]) = machine.held(index, &place) else { continue };
            let found = machine.value(&Formula::new(&rate), &place, None);
            let off = (found.value - expected.value).abs() / expected.size.max(1e-300);
            prop_assert!(off < 1e-13, "{off:e} of {:?}", held.expr);
            *compared.borrow_mut() += 1;
        }
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
    assert!(compared.into_inner() > 100);
}

#[test]
fn a_rate_beyond_its_limit_is_not_made() {
    let symbol = |id| Expr::Symbol(Symbol::Coordinate(CoordinateId(id)));
    let product = Expr::Product((0..100).map(symbol).collect());
    let velocity = |_| Some(Expr::integer(1));
    assert_eq!(rate(&product, 5000, &velocity), Err(NoRate::TooLarge));
    assert!(rate(&product, 20_000, &velocity).is_ok());
    let state = Expr::Symbol(Symbol::FirstOrder(FirstOrderId(0)));
    let unknown = NoRate::Unknown(Symbol::FirstOrder(FirstOrderId(0)));
    assert_eq!(rate(&state, 10, &|_| None), Err(unknown));
}

/// A pendulum on a pushed cart; a bob held by a rod in x and y; a growing mass in a shaken frame;
/// a winch whose rope is cut by a mode.
const MACHINES: &str = r#"
[scene]
name = "machines"
source = "Textbooks."

[units.m]
unit = "machines"

[run]
until = 1.0
points = 2
rtol = 1e-6
method = "dop853"

[define.machines.coordinates]
s = { unit = "m" }
phi = { unit = "rad" }
x = { unit = "m" }
y = { unit = "m" }
u = { unit = "m" }
h = { unit = "m" }

[define.machines.parameters]
cart = { value = 3.0, unit = "kg" }
bob = { value = 0.7, unit = "kg" }
length = { value = 1.3, unit = "m" }
gravity = { value = 9.81, unit = "m/s^2" }
push = { value = 2.5, unit = "N" }
drag = { value = 0.4, unit = "N s/m" }
flow = { value = 0.2, unit = "kg/s" }
speed = { value = 0.9, unit = "m/s" }
turn = { value = 4.0, unit = "1/s" }

[define.machines.states.load]
unit = "kg"
rate = "flow"
initial = 2

[define.machines.modes.tied]
initial = 1

[define.machines.energy]
kinetic = """cart*s_dot^2/2 + bob*((s_dot + length*cos(phi)*phi_dot)^2
    + (length*sin(phi)*phi_dot)^2)/2 + bob*(x_dot^2 + y_dot^2)/2
    + load*(u_dot + speed*sin(turn*t))^2/2 + bob*h_dot^2/2"""
potential = "-bob*gravity*length*cos(phi) + bob*gravity*y + bob*gravity*h"
dissipation = "drag*u_dot^2/2"

[[define.machines.forces]]
coordinate = "s"
expression = "push"

[define.machines.constraints.rod]
expression = "x^2 + y^2 - length^2"

[define.machines.constraints.rope]
expression = "h_dot - speed*cos(turn*t)"
when = { tied = 1 }
"#;

fn machines() -> LagrangianSystem {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("machines.toml");
    std::fs::write(&path, MACHINES).expect("written");
    pipeline::check(&path).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

/// Compares with accelerations and forces of textbooks, written by hand.
#[test]
fn machines_move_as_textbooks_say() {
    let system = machines();
    let machine = Machine::<f64>::new(&system, |x| x);
    let parameters: Vec<f64> = system.parameters.iter().map(|p| p.value).collect();
    let [cart, bob, length, gravity, push, drag, flow, speed, turn] = parameters[..] else {
        panic!("nine parameters")
    };
    for (time, tied) in [(0.0, 1.0), (0.37, 0.0), (2.1, 1.0)] {
        let [s, phi, x, y, u, h] = [0.1, 0.8 - time, 0.6, 1.1 - time, 0.3, 0.2];
        let [s_dot, w, x_dot, y_dot, u_dot, h_dot] = [0.5, 1.9, -0.4, 0.7, time - 1.0, 0.1];
        let load = 2.0 + time;
        let place = Place {
            time,
            q: vec![s, phi, x, y, u, h],
            v: vec![s_dot, w, x_dot, y_dot, u_dot, h_dot],
            z: machine_states(&system, load, tied),
            parameters: parameters.clone(),
        };
        let motion = machine.motion(&place).expect("it moves");
        let (sine, cosine) = phi.sin_cos();
        let pushed = push + bob * length * sine * w * w + bob * gravity * sine * cosine;
        let cart = pushed / (cart + bob * sine * sine);
        let rod = bob * (gravity * y - x_dot * x_dot - y_dot * y_dot) / (2.0 * (x * x + y * y));
        let shaken = speed * turn * (turn * time).cos();
        let arriving = flow * (u_dot + speed * (turn * time).sin());
        let hoisted = -speed * turn * (turn * time).sin();
        let accelerations = [
            cart,
            -(cosine * cart + gravity * sine) / length,
            2.0 * x * rod / bob,
            2.0 * y * rod / bob - gravity,
            -(drag * u_dot + arriving) / load - shaken,
            if tied > 0.5 { hoisted } else { -gravity },
        ];
        let rope = if tied > 0.5 { bob * (gravity + hoisted) } else { 0.0 };
        let found = motion.accelerations.iter().chain(&motion.multipliers);
        for (found, expected) in found.zip(accelerations.into_iter().chain([rod, rope])) {
            let error = (found.value - expected).abs();
            assert!(error < 1e-13 * found.size.max(1.0), "{} is not {expected}", found.value);
        }
    }
}

/// Returns first-order states by name, because modes may precede others.
fn machine_states(system: &LagrangianSystem, load: f64, tied: f64) -> Vec<f64> {
    let states = system.first_order.iter();
    states.map(|z| if z.quantity.name.path == "m.tied" { tied } else { load }).collect()
}

/// Expressions nest as deep as possible with helpers expanded, on the smallest stack that a
/// program has.
#[test]
fn deep_expressions_have_room() {
    let deepest = (0..600).fold(Expr::Symbol(Symbol::Time), |inner, _| {
        Expr::Call(Function::Sin, vec![Expr::Sum(vec![inner, Expr::integer(1)])])
    });
    let machine = Machine::<f64>::new(&machines(), |x| x);
    let place = Place { time: 0.3, ..Place::of_parameters(Vec::new()) };
    let look = move || machine.value(&Formula::new(&deepest), &place, None).value;
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(look);
    let found = thread.expect("a thread").join().expect("room");
    let expected = (0..600).fold(0.3_f64, |inner, _| (inner + 1.0).sin());
    assert!((found - expected).abs() < 1e-13, "{found} is not {expected}");
}
