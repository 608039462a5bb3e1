//! Points near the starts of scenes, in all modes and with other parameters.

use machinist_contract::Simulator;

/// Numbers of a scene at a point.
pub struct Place {
    pub time: f64,
    pub state: Vec<f64>,
    pub parameters: Vec<f64>,
}

impl Place {
    pub fn near_the_start(scene: &dyn Simulator<f64>, seed: u64) -> Self {
        let mut numbers = fastrand::Rng::with_seed(seed);
        let mut about = |value: f64| value * (0.7 + 0.6 * numbers.f64());
        let shape = scene.shape();
        let parameters: Vec<f64> =
            (0..shape.parameters).map(|index| about(scene.parameter_default(index))).collect();
        let mut state = vec![0.0; shape.states()];
        scene.initial_state(&parameters, &mut state);
        for (index, value) in state.iter_mut().enumerate() {
            if scene.is_mode(index) {
                *value = f64::from(numbers.i8(-2..=2));
            } else {
                *value += scene.state_scale(index) * (numbers.f64() - 0.5);
            }
        }
        Self { time: numbers.f64(), state, parameters }
    }
}
