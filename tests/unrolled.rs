//! The generic element of a field against the same chain written out, node by node, as an ordinary
//! machine, which also passes through Symbolica.

use std::fmt::Write as _;

use machinist::field::{Discretisation, FieldSimulator, Lobatto};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::field::FieldScene;
use machinist_contract::{Describe as _, Simulator};
use machinist_scenes::scenes::shaft_with_rotors::ShaftWithRotors;

use crate::own_scene::of_text;

/// A field with everything that may vary, an inner port and machines at two of three ports.
const BENT: &str = r#"
[scene]
name = "bent"

[define.rod.fields.phi]
unit = "rad"
over = "length"
kinetic = "density*(1 + x/length)*phi_dot^2/2"
potential = "stiffness*(2 - x/length)*(phi_x^2/2 + bend*phi_x^4) + hold*(1 - cos(phi))"
dissipation = "drag*phi_dot^2/2 + damping*exp(x/length)*phi_x_dot^2/2"
force = "pull*sin(x/length + 3 [1/s]*t)"
[define.rod.ports.inner]
kind = "rotational"
field = "phi"
at = "length/3"
[define.rod.ports.end]
kind = "rotational"
field = "phi"
at = "length"
[define.rod.parameters]
length = { value = 1.3, unit = "m" }
density = { value = 0.7, unit = "kg m" }
stiffness = { value = 11.0, unit = "N m^2" }
bend = { value = 0.3, unit = "m^2" }
hold = { value = 5.0, unit = "N" }
drag = { value = 0.2, unit = "N s" }
damping = { value = 0.01, unit = "N m^2 s" }
pull = { value = 2.0, unit = "N" }

[define.mass.coordinates.a]
unit = "rad"
[define.mass.ports.shaft]
kind = "rotational"
coordinate = "a"
[define.mass.energy]
kinetic = "0.4 [kg m^2]*a_dot^2/2"
potential = "3 [N m/rad]*a^4/4"

[units.rod]
unit = "rod"
fields = { phi = { elements = 6, order = 1 } }
[units.mass]
unit = "mass"
[[joints]]
connect = ["mass.shaft", "rod.inner"]
[[forces]]
port = "rod.end"
expression = "2 [N m]"
[run]
until = 1.0
points = 2
rtol = 1e-8
method = "radau"
"#;

/// Densities of a field with its parameters, and the additional energies and forces at its ports,
/// by the node's coordinate: kinetic, potential, force.
struct Chain {
    kinetic: &'static str,
    potential: &'static str,
    dissipation: &'static str,
    force: &'static str,
    parameters: &'static [(&'static str, f64, &'static str)],
    /// x, kinetic, potential and force at a port, with `q` for its coordinate.
    ports: &'static [(f64, [&'static str; 3])],
}

const OF_BENT: Chain = Chain {
    kinetic: "density*(1 + x/length)*phi_dot^2/2",
    potential: "stiffness*(2 - x/length)*(phi_x^2/2 + bend*phi_x^4) + hold*(1 - cos(phi))",
    dissipation: "drag*phi_dot^2/2 + damping*exp(x/length)*phi_x_dot^2/2",
    force: "pull*sin(x/length + 3 [1/s]*t)",
    parameters: &[
        ("length", 1.3, "m"),
        ("density", 0.7, "kg m"),
        ("stiffness", 11.0, "N m^2"),
        ("bend", 0.3, "m^2"),
        ("hold", 5.0, "N"),
        ("drag", 0.2, "N s"),
        ("damping", 0.01, "N m^2 s"),
        ("pull", 2.0, "N"),
    ],
    ports: &[
        (1.3 / 3.0, ["0.4 [kg m^2]*q_dot^2/2", "3 [N m/rad]*q^4/4", ""]),
        (1.3, ["", "", "2 [N m]"]),
    ],
};

const OF_SHAFT: Chain = Chain {
    kinetic: "density*phi_dot^2/2",
    potential: "stiffness*phi_x^2/2",
    dissipation: "damping_time*stiffness*phi_x_dot^2/2",
    force: "",
    parameters: &[
        ("density", 0.535_745_047_372_954_3, "kg m"),
        ("stiffness", 785_360.0, "N m^2"),
        ("damping_time", 1e-5, "s"),
    ],
    ports: &[
        (0.0, ["4.2 [kg m^2]*q_dot^2/2", "", ""]),
        (2.322, ["1.244 [kg m^2]*q_dot^2/2", "", ""]),
    ],
};

/// Replaces names by expressions.
fn put(text: &str, names: &[(&str, String)]) -> String {
    let mut result = String::new();
    let mut rest = text;
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    while let Some(first) = rest.chars().next() {
        let end = if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = rest.split_at(end);
        let known = names.iter().find(|(name, _)| *name == word);
        result.push_str(known.map_or(word, |(_, expression)| expression));
        rest = after;
    }
    result
}

/// Returns the scene with every node a coordinate q0, q1, ... and every sum written out.
fn written_out(chain: &Chain, x: &[f64], order: usize) -> String {
    let lobatto = Lobatto::new(order);
    let rule = lobatto.rule();
    let mut text = String::from("[scene]\nname = \"written_out\"\n");
    for node in 0..x.len() {
        let _ = write!(text, "[define.chain.coordinates.q{node}]\nunit = \"rad\"\n");
    }
    for (name, value, unit) in chain.parameters {
        let _ = write!(
            text,
            "[define.chain.parameters.{name}]\nvalue = {value:?}\nunit = \"{unit}\"\n"
        );
    }
    let mut energies = [const { Vec::<String>::new() }; 3];
    let mut forces = String::new();
    let mut force = |node: usize, expression: &str| {
        let _ = write!(
            forces,
            "[[define.chain.forces]]\ncoordinate = \"q{node}\"\nexpression = \"{expression}\"\n"
        );
    };
    for first in (0..x.len() - 1).step_by(order) {
        let h = x[first + order] - x[first];
        for point in 0..rule.len() {
            let node = first + point;
            let slope = |dot: &str| {
                let terms = (0..rule.len()).map(|i| {
                    let slope = rule.slopes[point * rule.len() + i] / h;
                    format!("({slope:?} [1/m])*q{}{dot}", first + i)
                });
                format!("({})", terms.collect::<Vec<_>>().join(" + "))
            };
            let names = [
                ("phi", format!("q{node}")),
                ("phi_dot", format!("q{node}_dot")),
                ("phi_x", slope("")),
                ("phi_x_dot", slope("_dot")),
                ("x", format!("({:?} [m])", x[node])),
            ];
            let share = format!("({:?} [m])", h * rule.weights[point]);
            let densities = [chain.kinetic, chain.potential, chain.dissipation];
            for (energy, density) in energies.iter_mut().zip(densities) {
                energy.push(format!("{share}*({})", put(density, &names)));
            }
            if !chain.force.is_empty() {
                force(node, &format!("{share}*({})", put(chain.force, &names)));
            }
        }
    }
    for (place, [kinetic, potential, push]) in chain.ports {
        let node = x.iter().position(|x| (x - place).abs() < 1e-12).unwrap();
        let names = [("q", format!("q{node}")), ("q_dot", format!("q{node}_dot"))];
        for (energy, part) in energies.iter_mut().zip([kinetic, potential]) {
            energy.extend((!part.is_empty()).then(|| put(part, &names)));
        }
        if !push.is_empty() {
            force(node, push);
        }
    }
    text.push_str("[define.chain.energy]\n");
    for (name, energy) in ["kinetic", "potential", "dissipation"].iter().zip(energies) {
        let _ = writeln!(text, "{name} = \"{}\"", energy.join(" + "));
    }
    text.push_str(&forces);
    text.push_str(
        "[define.chain.unit]\nname = \"chain\"\n[units.chain]\nunit = \"chain\"\n\
         [run]\nuntil = 1.0\npoints = 2\nrtol = 1e-8\nmethod = \"radau\"\n",
    );
    text
}

/// Returns the largest difference over the largest entry.
fn distance(ours: &[f64], known: &[f64]) -> f64 {
    assert_eq!(ours.len(), known.len());
    let size = known.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let largest = ours.iter().zip(known).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    largest / size
}

/// Returns dy'/dy, row by row.
fn jacobian(s: &dyn Simulator<f64>, (t, y, p): (f64, &[f64], &[f64])) -> Vec<f64> {
    let pattern = s.rate_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    s.rate_jacobian(t, y, p, &mut values);
    let mut full = vec![0.0; y.len() * y.len()];
    for ((row, column), value) in pattern.entries.iter().zip(values) {
        full[*row as usize * y.len() + *column as usize] = value;
    }
    full
}

fn parameters(s: &dyn Simulator<f64>) -> Vec<f64> {
    (0..s.shape().parameters).map(|index| s.parameter_default(index)).collect()
}

/// Compares rates and Jacobians of both at pseudorandom states.
fn agree(scene: &dyn FieldScene<f64>, chain: &Chain, order: usize) {
    let wanted = Discretisation { elements: Some(6), order: Some(order) };
    let simulator = FieldSimulator::new(scene, wanted).unwrap();
    let p = parameters(&simulator);
    let x = simulator.places(0, &p);
    let twin = of_text(&written_out(chain, &x, order), Keep::All);
    let q = parameters(&twin);
    let n = x.len();
    assert_eq!((n, simulator.shape().states()), (6 * order + 1, twin.shape().states()));
    // Index of each node's coordinate among those of the field.
    let numbers: Vec<f64> = (0..2 * n).map(|index| index as f64).collect();
    let places: Vec<usize> = simulator.values(0, &numbers).iter().map(|v| *v as usize).collect();
    let places: Vec<usize> = places.iter().copied().chain(places.iter().map(|v| v + n)).collect();
    for round in 0..4_u32 {
        let t = 0.1 * f64::from(round);
        let y: Vec<f64> = (0..2 * n).map(|i| ((i as f64 + 1.7) * (2.3 + t)).sin()).collect();
        let of_twin: Vec<f64> = places.iter().map(|place| y[*place]).collect();
        let (mut ours, mut known) = (vec![0.0; 2 * n], vec![0.0; 2 * n]);
        simulator.rate(t, &y, &p, &mut ours);
        twin.rate(t, &of_twin, &q, &mut known);
        let ours: Vec<f64> = places.iter().map(|place| ours[*place]).collect();
        let error = distance(&ours, &known);
        assert!(error < 1e-13, "order {order}, rate: {error:e}");
        let (ours, known) = (jacobian(&simulator, (t, &y, &p)), jacobian(&twin, (t, &of_twin, &q)));
        let ours: Vec<f64> = places
            .iter()
            .flat_map(|row| places.iter().map(move |column| (row * 2 * n, column)))
            .map(|(row, column)| ours[row + column])
            .collect();
        let error = distance(&ours, &known);
        assert!(error < 1e-13, "order {order}, Jacobian: {error:e}");
        let (ours, known) = (simulator.energy(t, &y, &p), twin.energy(t, &of_twin, &q));
        assert!((ours.total() / known.total() - 1.0).abs() < 1e-13);
        let balance = simulator.power_balance(t, &y, &p);
        let known = twin.power_balance(t, &of_twin, &q);
        // Powers are sums of forces at the nodes, which cancel.
        let mut forces = vec![0.0; n];
        simulator.forcing(t, &y, &p, &mut forces);
        let size: f64 = forces.iter().zip(&y[n..]).map(|(force, rate)| (force * rate).abs()).sum();
        for (ours, known) in [
            (balance.supplied, known.supplied),
            (balance.dissipated, known.dissipated),
            (balance.stored_rate, known.stored_rate),
        ] {
            assert!((ours - known).abs() < 1e-13 * size, "{ours} for {known} of {size}");
        }
    }
}

#[test]
fn the_emitted_element_computes_what_six_elements_written_out_compute() {
    for order in [1, 2, 3] {
        agree(&ShaftWithRotors, &OF_SHAFT, order);
    }
}

#[test]
fn an_element_that_is_bent_and_varies_along_x_computes_what_six_written_out_compute() {
    let scene = of_text(BENT, Keep::All);
    for order in [1, 2] {
        agree(&scene, &OF_BENT, order);
    }
}
