//! Networks of masses, dampers and springs, or of capacitors, resistors and inductors, whose nodes
//! may lack inertia: every node responds as the matrices of the network say, at any frequency.

use std::fmt::Write as _;

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;
use nalgebra::{Complex, DMatrix, DVector};

use crate::own_scene::{of_text, refusal};

/// A network of nodes: M x'' + D x' + K x = force on the first node, which has a mass.
struct Network {
    /// M, D, K.
    matrices: [DMatrix<f64>; 3],
    text: String,
}

/// Factor of each energy for one half of (a - b)^2, and the kind of the values.
const ELEMENTS: [(&str, &str, &str); 3] =
    [("kinetic", "_dot", "kg"), ("dissipation", "_dot", "N s/m"), ("potential", "", "N/m")];

/// Returns a network of random elements between random nodes.
fn random_network(random: &mut fastrand::Rng) -> Network {
    let nodes = random.usize(2..7);
    let mut matrices = [0, 1, 2].map(|_| DMatrix::zeros(nodes, nodes));
    let mut energies = [String::from("mass0*x0_dot^2/2"), String::new(), String::new()];
    let mut parameters = String::from("mass0 = { value = 1.3, unit = \"kg\" }\n");
    matrices[0][(0, 0)] = 1.3;
    for element in 0..random.usize(nodes..3 * nodes) {
        // Fewer masses than others.
        let kind = [0, 1, 1, 2, 2][random.usize(0..5)];
        let value = 10f64.powf(random.f64() * 2.0 - 1.0);
        let (_, rate, unit) = ELEMENTS[kind];
        let (a, b) = (random.usize(0..nodes), random.usize(0..=nodes));
        if a == b {
            continue;
        }
        writeln!(parameters, "p{element} = {{ value = {value:?}, unit = \"{unit}\" }}")
            .expect("text");
        let other = if b < nodes { format!(" - x{b}{rate}") } else { String::new() };
        write!(energies[kind], " + p{element}*(x{a}{rate}{other})^2/2").expect("text");
        let matrix = &mut matrices[kind];
        matrix[(a, a)] += value;
        if b < nodes {
            matrix[(b, b)] += value;
            matrix[(a, b)] -= value;
            matrix[(b, a)] -= value;
        }
    }
    let mut text = format!(
        "[scene]\nname = \"network\"\n[units.s]\nunit = \"s\"\n[run]\nuntil = 3.0\npoints = 31\n\
         [define.s.parameters]\n{parameters}force = {{ value = 1.0, unit = \"N\" }}\n\
         [[define.s.forces]]\ncoordinate = \"x0\"\nexpression = \"force\"\n[define.s.energy]\n"
    );
    for ((name, ..), energy) in ELEMENTS.iter().zip(&energies) {
        let energy = energy.trim_start_matches(" + ");
        if !energy.is_empty() {
            writeln!(text, "{name} = \"{energy}\"").expect("text");
        }
    }
    for node in 0..nodes {
        writeln!(text, "[define.s.coordinates.x{node}]\nunit = \"m\"").expect("text");
    }
    text.push_str("[outputs]\n");
    for node in 0..nodes {
        writeln!(text, "x{node} = \"s.x{node}\"").expect("text");
    }
    Network { matrices, text }
}

impl Network {
    /// Returns the motion of all nodes by the force at a complex frequency; `None` if it is not
    /// determined.
    fn response(&self, s: Complex<f64>) -> Option<DVector<Complex<f64>>> {
        let [mass, damping, stiffness] = self.matrices.each_ref().map(|m| m.map(Complex::from));
        let matrix = mass * s * s + damping * s + stiffness;
        let nodes = matrix.nrows();
        let svd = matrix.svd(true, true);
        let least = 1e-12 * svd.singular_values.max();
        if svd.singular_values.min() < least {
            return None;
        }
        let mut force = DVector::zeros(nodes);
        force[0] = Complex::from(1.0);
        svd.solve(&force, 0.0).ok()
    }
}

/// Returns the response of the outputs of a linear machine to its parameter `s.force`.
fn response_of(scene: &ModelSimulator, s: Complex<f64>) -> DVector<Complex<f64>> {
    let shape = scene.shape();
    let (states, outputs) = (shape.states(), shape.outputs);
    let mut parameters: Vec<f64> =
        (0..shape.parameters).map(|index| scene.parameter_default(index)).collect();
    let force = (0..shape.parameters)
        .find(|index| scene.parameter(*index).name == "s.force")
        .expect("the force");
    let mut at = |state: &[f64], value: f64| {
        parameters[force] = value;
        let (mut rate, mut output) = (vec![0.0; states], vec![0.0; outputs]);
        scene.rate(0.0, state, &parameters, &mut rate);
        scene.outputs(0.0, state, &parameters, &mut output);
        (DVector::from_vec(rate), DVector::from_vec(output))
    };
    let zero = vec![0.0; states];
    let (rate, output) = at(&zero, 1.0);
    let mut a = DMatrix::zeros(states, states);
    let mut c = DMatrix::zeros(outputs, states);
    for column in 0..states {
        let mut state = zero.clone();
        state[column] = 1.0;
        let (rate, output) = at(&state, 0.0);
        a.set_column(column, &rate);
        c.set_column(column, &output);
    }
    let [a, c] = [a, c].map(|matrix| matrix.map(Complex::from));
    let [b, d] = [rate, output].map(|vector| vector.map(Complex::from));
    let shifted = DMatrix::identity(states, states) * s - a;
    let inner = shifted.lu().solve(&b).expect("no frequency of its own");
    c * inner + d
}

#[test]
fn random_networks_respond_as_their_matrices_do() {
    let mut random = fastrand::Rng::with_seed(20_261_128);
    let (mut without_inertia, mut refused) = (0, 0);
    for case in 0..60 {
        let network = random_network(&mut random);
        let s = Complex::new(0.3, 1.7);
        let Some(exact) = network.response(s) else {
            let said = refusal(&network.text);
            assert!(said.contains("has no inertia") || said.contains("singular"), "{case}: {said}");
            refused += 1;
            continue;
        };
        without_inertia += usize::from(network.matrices[0].clone().rank(1e-9) < exact.len());
        let scene = of_text(&network.text, Keep::Needed);
        for s in [s, Complex::new(0.01, 0.05), Complex::new(2.0, 40.0)] {
            let exact = network.response(s).expect("it is determined");
            let found = response_of(&scene, s);
            let error = (found - &exact).norm() / exact.norm();
            assert!(error < 1e-9, "{case}, {s}: {error:e}\n{}", network.text);
        }
    }
    assert!(without_inertia > 25 && refused > 5, "{without_inertia} {refused}");
}

#[test]
fn energy_of_random_networks_is_accounted_for() {
    let mut random = fastrand::Rng::with_seed(5);
    let mut tried = 0;
    while tried < 12 {
        let network = random_network(&mut random);
        let lacks = network.matrices[0].clone().rank(1e-9) < network.matrices[0].nrows();
        if !lacks || network.response(Complex::new(0.3, 1.7)).is_none() {
            continue;
        }
        tried += 1;
        for keep in [Keep::All, Keep::Needed] {
            let scene = of_text(&network.text, keep);
            let run = Simulation::new(&scene).method(Method::Radau).rtol(1e-9);
            let run = run.with_energy_balance(true).run();
            let run = run.unwrap_or_else(|error| panic!("{error}\n{}", network.text));
            let balance = run.energy_balance.as_ref().expect("an account");
            let residual = balance.max_residual_relative();
            assert!(residual < 1e-6, "{keep:?}: {residual:e}\n{}", network.text);
        }
    }
}

#[test]
fn circuits_of_resistors_need_no_capacitance() {
    let text = r#"
        [scene]
        name = "divider"
        [units.source]
        unit = "electrical/voltage_source"
        inputs = { voltage = "10 [V]" }
        [units.first]
        unit = "electrical/resistor"
        parameters = { resistance = 2 }
        [units.second]
        unit = "electrical/resistor"
        parameters = { resistance = 3 }
        [units.third]
        unit = "electrical/resistor"
        parameters = { resistance = 6 }
        [units.coil]
        unit = "electrical/inductor"
        parameters = { inductance = 0.1 }
        [units.ground]
        unit = "electrical/ground"
        [[joints]]
        connect = ["source.a", "first.a"]
        [[joints]]
        connect = ["first.b", "second.a"]
        [[joints]]
        connect = ["second.b", "ground.a"]
        [[joints]]
        connect = ["first.b", "third.a"]
        [[joints]]
        connect = ["third.b", "coil.a"]
        [[joints]]
        connect = ["coil.b", "ground.a"]
        [outputs]
        node = "second.voltage"
        current = "coil.current"
        [run]
        until = 0.1
        points = 51
        rtol = 1e-9
    "#;
    // Thevenin: 6 V behind 1.2 ohm, then 6 ohm and 0.1 H.
    let scene = of_text(text, Keep::Needed);
    for method in [Method::Auto, Method::Dop853, Method::Radau, Method::Rodas5p] {
        let run = Simulation::new(&scene).method(method).run().expect("it flows");
        let [node, current] = ["node", "current"].map(|name| run.column(name).expect("a column"));
        for (row, time) in run.times.iter().enumerate() {
            let exact = 6.0 / 7.2 * (1.0 - (-72.0 * time).exp());
            assert!((current[row] - exact).abs() < 1e-7, "{method:?} at {time}: {}", current[row]);
            assert!((node[row] - (6.0 - 1.2 * exact)).abs() < 1e-7, "{method:?} at {time}");
        }
    }
}
