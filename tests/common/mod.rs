//! Simulators written by hand, for tests of the runtime.
#![allow(dead_code, unused_imports)]

pub mod hard_spring;
pub mod oscillator;
pub mod scalar;

pub use hard_spring::HardSpring;
pub use oscillator::Oscillator;
pub use scalar::Scalar;

use machinist::Trajectory;

/// Returns the values of a column of a run.
pub fn column<'t>(run: &'t Trajectory, name: &str) -> &'t [f64] {
    run.column(name).unwrap_or_else(|| panic!("no column {name}"))
}

/// Returns the closed form of [`Oscillator`] with its default parameters: angle and speed.
pub fn oscillator_state(time: f64) -> [f64; 2] {
    const START: f64 = 0.7;
    const OFFSET: f64 = 30.0 / 50.0;
    let before = free_motion(time.min(START), [0.4, 0.0]);
    if time <= START {
        return before;
    }
    let [angle, speed] = free_motion(time - START, [before[0] - OFFSET, before[1]]);
    [angle + OFFSET, speed]
}

/// Returns angle and speed of 2 q'' + 0.8 q' + 50 q = 0 from a given start.
fn free_motion(time: f64, [angle, speed]: [f64; 2]) -> [f64; 2] {
    let (decay, frequency) = (0.2, (25.0f64 - 0.04).sqrt());
    let (sin, cos) = (frequency * time).sin_cos();
    let b = (speed + decay * angle) / frequency;
    let envelope = (-decay * time).exp();
    [
        envelope * (angle * cos + b * sin),
        envelope * ((-decay * angle + frequency * b) * cos - (decay * b + frequency * angle) * sin),
    ]
}
