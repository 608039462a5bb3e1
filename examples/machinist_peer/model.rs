//! Benchmark models M1 to M6, and the simulator that stands for each. Its outputs
//! are the states of the model's definition, in their order; its own states are
//! fewer or others, where less is enough.

use machinist_scenes::{Simulator, bench};

/// A benchmark model and the simulator that stands for it.
pub struct Model {
    /// `M3:10`.
    pub key: String,
    /// `m3_10`.
    pub scene: String,
    /// The emitted simulator.
    pub simulator: &'static dyn Simulator<f64>,
}

impl Model {
    /// The model of a key such as `M3:10`; nothing if there is no such scene.
    pub fn find(key: &str) -> Option<Self> {
        let scene = key.to_lowercase().replace(':', "_");
        let simulator = bench::find::<f64>(&scene)?;
        Some(Self { key: key.to_owned(), scene, simulator })
    }

    /// Values of the parameters in the spec.
    pub fn parameters(&self) -> Vec<f64> {
        let count = self.simulator.shape().parameters;
        (0..count).map(|index| self.simulator.parameter_default(index)).collect()
    }

    /// Typical sizes of the simulator's states.
    pub fn scales(&self) -> Vec<f64> {
        let count = self.simulator.shape().states();
        (0..count).map(|index| self.simulator.state_scale(index)).collect()
    }

    /// The model's states at a state of the simulator.
    pub fn states(&self, time: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut states = vec![f64::NAN; self.simulator.shape().outputs];
        self.simulator.outputs(time, state, parameters, &mut states);
        states
    }
}
