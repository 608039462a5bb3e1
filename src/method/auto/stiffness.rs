//! How it is found that stability, not accuracy, holds the steps of an explicit method, and
//! whether an implicit one is worth its steps.

use machinist_contract::Simulator;

/// So many steps of evidence change the method.
pub(super) const STIFF_STEPS: usize = 15;
/// So many without it make the evidence void.
const EASY_STEPS: usize = 6;
/// Taylor's method looks for stiffness every so many steps, each of which costs as much
/// as this many rates and more, while a look costs a Jacobian.
const LOOKS_EVERY: usize = 8;
/// What is fast and decays has done so after so many explicit steps; an implicit method is not left
/// for steps that are short before.
pub(super) const TRANSIENT: f64 = 10.0;
/// So many steps an implicit method takes at least to find its step and follow a motion.
const IMPLICIT_STEPS: f64 = 150.0;
/// An implicit method begins where an explicit one would take so many times as many steps as
/// make a change worth it.
const CLEARLY: f64 = 1.5;

/// How many times as long as an explicit step an implicit one has to be to pay for its
/// factorization.
///
/// So much a step of `radau` costs of one by `taylor` and `dop853`: of the saw gin's 7 states 5.4
/// and 3.9, of a shaft's 26 2.1 and 2.4, of the loom's 76 3.6 by `dop853`, of 206 in a row 1.1.
pub(super) fn worth(states: usize) -> f64 {
    (1.5 + 20.0 / states as f64).clamp(2.0, 4.0)
}

/// Taylor's method goes on where so many steps more would do, stiff or not.
fn few_steps(states: usize) -> f64 {
    IMPLICIT_STEPS * worth(states)
}

/// Over a stretch of `limits` times the length that is stable at |lambda| = 1, how many steps
/// stability alone would ask of an explicit method, if that is so many that an implicit one is to
/// begin. One that begins for nothing is left soon.
pub(super) fn is_worth_beginning(
    simulator: &dyn Simulator<f64>,
    limits: f64,
    jacobian: impl FnOnce(&mut [f64]),
) -> Option<f64> {
    let mut values = vec![0.0; simulator.rate_jacobian_pattern().entries.len()];
    jacobian(&mut values);
    let steps = limits * SpectralRadius::new(simulator).settled(&values);
    (steps > CLEARLY * few_steps(simulator.shape().states())).then_some(steps)
}

/// How near Taylor's method is to the limit of its stability.
pub(super) struct Strain<'a> {
    radius: SpectralRadius<'a>,
    jacobian: Vec<f64>,
    limit: f64,
    few: f64,
    steps: usize,
    is_near: bool,
}

impl<'a> Strain<'a> {
    pub(super) fn new(simulator: &'a dyn Simulator<f64>, limit: f64) -> Self {
        let entries = simulator.rate_jacobian_pattern().entries.len();
        Self {
            radius: SpectralRadius::new(simulator),
            jacobian: vec![0.0; entries],
            limit,
            few: few_steps(simulator.shape().states()),
            steps: 0,
            is_near: false,
        }
    }

    /// |h lambda| after a step, `left` of the stretch being left: now and then, and after every
    /// one beyond the limit; not where few steps are left.
    pub(super) fn look(
        &mut self,
        left: f64,
        step: f64,
        jacobian: impl FnOnce(&mut [f64]),
    ) -> Option<f64> {
        self.steps += 1;
        let is_due = self.is_near || self.steps.is_multiple_of(LOOKS_EVERY);
        if !is_due || left < self.few * step {
            return None;
        }
        jacobian(&mut self.jacobian);
        self.radius.renew(&self.jacobian);
        let strain = step * self.radius.renew(&self.jacobian);
        self.is_near = strain > self.limit;
        Some(strain)
    }
}

/// Steps that speak for a change, not too far apart (Hairer, Wanner, section
/// IV.2).
pub(super) struct Evidence {
    enough: usize,
    found: usize,
    missed: usize,
}

impl Evidence {
    /// So many steps are enough.
    pub(super) fn of(enough: usize) -> Self {
        Self { enough, found: 0, missed: 0 }
    }

    /// Takes the evidence of one step; true if it is enough.
    pub(super) fn grows(&mut self, is_evidence: bool) -> bool {
        if is_evidence {
            self.missed = 0;
            self.found += 1;
        } else {
            self.missed += 1;
            if self.missed == EASY_STEPS {
                self.found = 0;
            }
        }
        self.found >= self.enough
    }
}

/// Largest |eigenvalue| of the Jacobian, by one more power of it a step.
pub(super) struct SpectralRadius<'a> {
    entries: &'a [(u32, u32)],
    vector: Vec<f64>,
    next: Vec<f64>,
    estimate: f64,
}

impl<'a> SpectralRadius<'a> {
    pub(super) fn new(simulator: &'a dyn Simulator<f64>) -> Self {
        let size = simulator.shape().states();
        // Anything but an eigenvector.
        let vector = (0..size).map(|index| 1.0 + 0.1 * ((index % 7) as f64)).collect();
        let entries = simulator.rate_jacobian_pattern().entries;
        Self { entries, vector, next: vec![0.0; size], estimate: 0.0 }
    }

    /// The estimate after two more multiplications: the square root of the growth
    /// over both, for one alone turns positions into accelerations and says
    /// nothing. It decays slowly, so that a vector that happens to be short of
    /// the fastest motion does not make a machine look easy.
    pub(super) fn renew(&mut self, jacobian: &[f64]) -> f64 {
        let growth = self.multiply(jacobian) * self.multiply(jacobian);
        let radius = growth.sqrt();
        if radius.is_finite() {
            self.estimate = radius.max(0.9 * self.estimate);
        }
        self.estimate
    }

    /// The estimate by so many multiplications that what the vector began with hardly counts.
    fn settled(&mut self, jacobian: &[f64]) -> f64 {
        const ROUNDS: usize = 8;
        (0..ROUNDS).for_each(|_| {
            self.estimate = 0.0;
            self.renew(jacobian);
        });
        self.estimate
    }

    /// vector = J vector, then made of length 1; gives the length it had.
    fn multiply(&mut self, jacobian: &[f64]) -> f64 {
        self.next.fill(0.0);
        for (&(row, column), value) in self.entries.iter().zip(jacobian) {
            self.next[row as usize] += value * self.vector[column as usize];
        }
        let length = |vector: &[f64]| vector.iter().map(|v| v * v).sum::<f64>().sqrt();
        let (before, after) = (length(&self.vector), length(&self.next));
        if after > 0.0 && after.is_finite() {
            for (vector, next) in self.vector.iter_mut().zip(&self.next) {
                *vector = next / after;
            }
        }
        after / before
    }
}
