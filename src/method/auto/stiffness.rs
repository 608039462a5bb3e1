//! How it is found that stability, not accuracy, holds the steps of an explicit method, and
//! whether an implicit one is worth its steps.

use machinist_contract::{Describe, Real, Simulator};

use crate::method::Stretch;

/// So many steps of evidence change the method.
pub(super) const STIFF_STEPS: usize = 15;
/// So many without it make the evidence void.
const EASY_STEPS: usize = 6;
/// Taylor's method looks for stiffness every so many steps, each of which costs as much
/// as this many rates and more, while a look costs a Jacobian.
pub(super) const LOOKS_EVERY: usize = 8;
/// Steps of a pair show most of it themselves.
pub(super) const LOOKS_OF_PAIR_EVERY: usize = 24;
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
pub(super) fn few_steps(states: usize) -> f64 {
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
    (steps > worth_beginning(simulator.shape().states())).then_some(steps)
}

/// An implicit method begins where stability would ask for more steps than so many.
pub(super) fn worth_beginning(states: usize) -> f64 {
    CLEARLY * few_steps(states)
}

/// How near an explicit method is to the limit of its stability.
pub(super) struct Strain<'a> {
    radius: SpectralRadius<'a, f64>,
    jacobian: Vec<f64>,
    limit: f64,
    few: f64,
    every: usize,
    steps: usize,
    is_near: bool,
}

impl<'a> Strain<'a> {
    /// Looked at every so many steps.
    pub(super) fn new(simulator: &'a dyn Simulator<f64>, limit: f64, every: usize) -> Self {
        let entries = simulator.rate_jacobian_pattern().entries.len();
        Self {
            radius: SpectralRadius::new(simulator),
            jacobian: vec![0.0; entries],
            limit,
            few: few_steps(simulator.shape().states()),
            every,
            steps: 0,
            is_near: false,
        }
    }

    /// |h lambda| after a step to a time and a state: now and then, and after every one beyond
    /// the limit; not where few steps are left.
    pub(super) fn look(
        &mut self,
        stretch: &Stretch<'_>,
        (time, state): (f64, &[f64]),
        step: f64,
    ) -> Option<f64> {
        self.steps += 1;
        let is_due = self.is_near || self.steps.is_multiple_of(self.every);
        if !is_due || stretch.until - time < self.few * step {
            return None;
        }
        stretch.jacobian(time, state, &mut self.jacobian);
        let strain = step * self.radius.looked_at(&self.jacobian, 1.0);
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

/// Doubt whether it was right to leave an implicit method because its steps were short.
///
/// An explicit method that is held by stability may never show it: at tolerances near rounding, what
/// is rounded of a stiff force is an error of a step, and makes it shorter than stability would.
/// After very many steps near what stability allows the implicit method is tried once more, which is
/// left soon if its steps are short again.
pub(super) struct Doubt {
    steps: f64,
    enough: f64,
}

impl Doubt {
    pub(super) fn new(states: usize) -> Self {
        Self { steps: 0.0, enough: worth_beginning(states) }
    }

    /// The explicit method goes on; a doubt that was wrong is not repeated as soon.
    pub(super) fn begin(&mut self, was_wrong: bool) {
        self.steps = 0.0;
        if was_wrong {
            self.enough *= 2.0;
        }
    }

    /// Takes a step of so much of what is stable; true if another try is due.
    pub(super) fn grows(&mut self, strain: f64) -> bool {
        /// Steps nearer than this may be held by stability.
        const NEAR: f64 = 1.0 / 3.0;
        self.steps += 1.0;
        self.steps > self.enough && strain > NEAR
    }
}

/// Largest |eigenvalue| of the Jacobian, by two more powers of it a step; of numbers in lanes each
/// on its own.
pub(super) struct SpectralRadius<'a, R> {
    entries: &'a [(u32, u32)],
    /// Of length 1.
    vector: Vec<R>,
    between: Vec<R>,
    next: Vec<R>,
    estimate: R,
}

impl<'a, R: Real> SpectralRadius<'a, R> {
    pub(super) fn new(simulator: &'a (impl Describe + ?Sized)) -> Self {
        let zeros = || vec![R::literal(0.0); simulator.shape().states()];
        let entries = simulator.rate_jacobian_pattern().entries;
        let estimate = R::literal(0.0);
        let (vector, between, next) = (zeros(), zeros(), zeros());
        let mut radius = Self { entries, vector, between, next, estimate };
        radius.begin(R::literal(1.0));
        radius
    }

    /// Forgets what it knows where this is 1.
    pub(super) fn begin(&mut self, takes: R) {
        // Anything but an eigenvector.
        let value = |index: usize| 1.0 + 0.1 * ((index % 7) as f64);
        let squares: f64 = (0..self.vector.len()).map(|index| value(index) * value(index)).sum();
        let (half, zero) = (R::literal(0.5), R::literal(0.0));
        for (index, known) in self.vector.iter_mut().enumerate() {
            let first = R::literal(value(index) / squares.sqrt());
            *known = R::select_less(half, takes, first, *known);
        }
        self.estimate = R::select_less(half, takes, zero, self.estimate);
    }

    /// The estimate after two more multiplications, where `takes` is 1: the square root of the
    /// growth over both, for one alone turns positions into accelerations and says
    /// nothing. It decays slowly, so that a vector that happens to be short of
    /// the fastest motion does not make a machine look easy.
    pub(super) fn renew(&mut self, jacobian: &[R], takes: R) -> R {
        let radius = self.grow(jacobian, takes).sqrt();
        let kept = R::literal(0.9) * self.estimate;
        let larger = R::select_less(kept, radius, radius, kept);
        let larger = R::select_less(R::literal(0.5), takes, larger, self.estimate);
        self.estimate = R::select_less(radius, R::literal(f64::INFINITY), larger, self.estimate);
        self.estimate
    }

    /// The estimate that a look gives: by twice as many multiplications.
    pub(super) fn looked_at(&mut self, jacobian: &[R], takes: R) -> R {
        self.renew(jacobian, takes);
        self.renew(jacobian, takes)
    }

    /// The estimate by so many multiplications that what the vector began with hardly counts.
    pub(super) fn settled(&mut self, jacobian: &[R]) -> R {
        const ROUNDS: usize = 8;
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        self.begin(one);
        for _ in 1..ROUNDS {
            self.grow(jacobian, one);
        }
        self.estimate = zero;
        self.renew(jacobian, one)
    }

    /// vector = J J vector, then made of length 1, where `takes` is 1; gives the length it had.
    fn grow(&mut self, jacobian: &[R], takes: R) -> R {
        multiply(self.entries, jacobian, &self.vector, &mut self.between);
        multiply(self.entries, jacobian, &self.between, &mut self.next);
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        let squares = self.next.iter().fold(zero, |sum, value| sum + *value * *value);
        let length = squares.sqrt();
        let takes = R::select_less(length, R::literal(f64::INFINITY), takes, zero);
        let takes = R::select_less(zero, length, takes, zero);
        let inverse = one / length;
        for (value, next) in self.vector.iter_mut().zip(&self.next) {
            *value = R::select_less(R::literal(0.5), takes, *next * inverse, *value);
        }
        length
    }
}

/// product = J vector.
fn multiply<R: Real>(entries: &[(u32, u32)], jacobian: &[R], vector: &[R], product: &mut [R]) {
    let zero = R::literal(0.0);
    product.fill(zero);
    // Sums of neighbouring entries of a row do not go through memory.
    let (mut at, mut sum) = (0, zero);
    for (&(row, column), value) in entries.iter().zip(jacobian) {
        if row != at {
            product[at as usize] = product[at as usize] + sum;
            (at, sum) = (row, zero);
        }
        sum = sum + *value * vector[column as usize];
    }
    if let Some(last) = product.get_mut(at as usize) {
        *last = *last + sum;
    }
}
