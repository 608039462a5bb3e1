//! Benchmark models M1 to M6, and the simulator of each. The outputs of an expanded scene are the
//! states of the model's definition, in their order. Its own states are fewer or different, where
//! fewer are sufficient. The states of a field are the model's, in another order.

use machinist::field::{Discretisation, FieldSimulator};
use machinist_bench_scenes as bench;
use machinist_contract::{Describe as _, Simulator};

/// A benchmark model and its simulator.
pub struct Model {
    /// `M3:10`.
    pub key: String,
    /// `m3_10`.
    pub scene: String,
    /// The simulator.
    pub simulator: &'static dyn Simulator<f64>,
    /// For a field, its states in the model's order.
    order: Option<Vec<usize>>,
    parameters: Vec<f64>,
}

impl Model {
    /// Returns the model of a key such as `M3:10`, expanded or as a field; `None` if there is no
    /// such scene.
    pub fn find(key: &str) -> Option<Self> {
        let scene = key.to_lowercase().replace(':', "_");
        let Some(simulator) = bench::find_f64(&scene) else { return Self::of_field(key) };
        let parameters = defaults(simulator);
        Some(Self { key: key.to_owned(), scene, simulator, order: None, parameters })
    }

    /// Returns the model of a key such as `M4:70` as a field, with as many elements.
    pub fn of_field(key: &str) -> Option<Self> {
        let (family, count) = key.split_once(':')?;
        let count: usize = count.parse().ok()?;
        let scene = family.to_lowercase();
        let elements = match family {
            "M3" => count.checked_sub(1)?,
            "M4" if count.is_multiple_of(7) => count,
            _ => return None,
        };
        let discretisation = Discretisation { elements: Some(elements), order: None };
        let simulator = FieldSimulator::new(bench::find_field(&scene)?, discretisation).ok()?;
        // For as long as the program runs.
        let simulator: &'static FieldSimulator<'static, f64> = Box::leak(Box::new(simulator));
        let order = Some(order(simulator));
        let mut parameters = defaults(simulator);
        for (index, value) in parameters.iter_mut().enumerate() {
            if simulator.parameter(index).name == "shaft.pieces" {
                *value = count as f64;
            }
        }
        Some(Self { key: key.to_owned(), scene, simulator, order, parameters })
    }

    /// Returns whether it is a field.
    pub fn is_field(&self) -> bool {
        self.order.is_some()
    }

    /// Returns the values of the parameters.
    pub fn parameters(&self) -> Vec<f64> {
        self.parameters.clone()
    }

    /// Returns the typical sizes of the simulator's states.
    pub fn scales(&self) -> Vec<f64> {
        let count = self.simulator.shape().states();
        (0..count).map(|index| self.simulator.state_scale(index)).collect()
    }

    /// Returns the model's states at a state of the simulator.
    pub fn states(&self, time: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
        if let Some(order) = &self.order {
            return order.iter().map(|index| state[*index]).collect();
        }
        let mut states = vec![f64::NAN; self.simulator.shape().outputs];
        self.simulator.outputs(time, state, parameters, &mut states);
        states
    }
}

fn defaults(simulator: &dyn Simulator<f64>) -> Vec<f64> {
    let count = simulator.shape().parameters;
    (0..count).map(|index| simulator.parameter_default(index)).collect()
}

/// Returns the order of fluxes, then of angle and speed of the rotor, then of those of every node
/// by x, as far as they exist.
fn order(simulator: &FieldSimulator<'_, f64>) -> Vec<usize> {
    let shape = simulator.shape();
    let n = shape.coordinates;
    let mut order: Vec<usize> = (2 * n..shape.states()).collect();
    let rotor = (0..n).find(|index| simulator.state(*index).name == "motor.phi");
    let mut nodes = vec![0.0; shape.states()];
    for (index, number) in nodes[..n].iter_mut().enumerate() {
        *number = index as f64;
    }
    // In a state that holds the number of each entry, the values at nodes are their indices.
    let by_x = simulator.values(0, &nodes).into_iter().map(|number| number as usize);
    order.extend(rotor.into_iter().chain(by_x).flat_map(|index| [index, index + n]));
    order
}
