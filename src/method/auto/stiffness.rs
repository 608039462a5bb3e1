//! Detection of explicit steps that are limited by stability and not by accuracy, and the decision
//! whether an implicit method is worth its steps.

use machinist_contract::{Describe, Real, Simulator};

use crate::method::Stretch;

/// Number of steps of evidence after which the method changes.
pub(super) const STIFF_STEPS: usize = 15;
/// Number of steps without evidence after which earlier evidence is void.
const EASY_STEPS: usize = 6;
/// Number of steps of Taylor's method between checks for stiffness. Each step costs at least as
/// much as this many rates, and a check costs a Jacobian.
pub(super) const LOOKS_EVERY: usize = 8;
/// Number of steps of a pair between checks; its steps show most of the stiffness themselves.
pub(super) const LOOKS_OF_PAIR_EVERY: usize = 24;
/// Number of explicit steps after which fast motions have decayed. Before that, short steps are no
/// reason to leave an implicit method.
pub(super) const TRANSIENT: f64 = 10.0;
/// Minimum number of steps of an implicit method to find its step and follow a motion.
const IMPLICIT_STEPS: f64 = 150.0;
/// Factor of the number of explicit steps worth a change, above which an implicit method begins.
const CLEARLY: f64 = 1.5;

/// Returns the ratio of an implicit to an explicit step length at which its factorization pays.
///
/// Measured cost of a step of `radau` over one of `taylor` and `dop853`: with the saw gin's 7
/// states 5.4 and 3.9, with a shaft's 26 states 2.1 and 2.4, with the loom's 76 states 3.6 over
/// `dop853`, with 206 states in a row 1.1.
pub(super) fn worth(states: usize) -> f64 {
    (1.5 + 20.0 / states as f64).clamp(2.0, 4.0)
}

/// Returns the number of remaining steps with which Taylor's method continues, stiff or not.
pub(super) fn few_steps(states: usize) -> f64 {
    IMPLICIT_STEPS * worth(states)
}

/// Returns the number of explicit steps that stability alone would require over a stretch of
/// `limits` times the length that is stable at |lambda| = 1, if an implicit method should begin.
/// One that begins in vain is soon left.
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

/// Returns the number of steps required by stability above which an implicit method begins.
pub(super) fn worth_beginning(states: usize) -> f64 {
    CLEARLY * few_steps(states)
}

/// Distance of an explicit method from its stability limit.
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
    /// Returns a strain that is checked once every `every` steps.
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

    /// Returns |h lambda| after a step to a time and a state. It is evaluated occasionally, after
    /// every step beyond the limit, and not if few steps are left.
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

/// Steps that are evidence for a change, not too far apart (Hairer, Wanner, section IV.2).
pub(super) struct Evidence {
    enough: usize,
    found: usize,
    missed: usize,
}

impl Evidence {
    /// Returns evidence for which this number of steps is enough.
    pub(super) fn of(enough: usize) -> Self {
        Self { enough, found: 0, missed: 0 }
    }

    /// Takes the evidence of one step; returns whether it is enough.
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

/// Decides when an explicit method retries the implicit one that it left because of short steps.
///
/// An explicit method limited by stability may never show it. At tolerances near rounding, the
/// rounding of a stiff force is an error of a step, and makes the step shorter than stability
/// would. After very many steps near the stability limit, the implicit method is tried once more;
/// it is soon left if its steps are short again.
pub(super) struct Retry {
    steps: f64,
    enough: f64,
}

impl Retry {
    pub(super) fn new(states: usize) -> Self {
        Self { steps: 0.0, enough: worth_beginning(states) }
    }

    /// Continues with the explicit method; after a wrong retry, the next one takes longer.
    pub(super) fn begin(&mut self, was_wrong: bool) {
        self.steps = 0.0;
        if was_wrong {
            self.enough *= 2.0;
        }
    }

    /// Takes a step, as a share of the stability limit; returns whether another try is due.
    pub(super) fn grows(&mut self, strain: f64) -> bool {
        /// Share of the stability limit above which stability may limit steps.
        const NEAR: f64 = 1.0 / 3.0;
        self.steps += 1.0;
        self.steps > self.enough && strain > NEAR
    }
}

/// Largest |eigenvalue| of the Jacobian, estimated by two more powers per step; for numbers in
/// lanes, separately for each lane.
pub(super) struct SpectralRadius<'a, R> {
    entries: &'a [(u32, u32)],
    /// Unit vector.
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

    /// Resets the estimate where `takes` is 1.
    pub(super) fn begin(&mut self, takes: R) {
        // Any vector that is not an eigenvector.
        let value = |index: usize| 1.0 + 0.1 * ((index % 7) as f64);
        let squares: f64 = (0..self.vector.len()).map(|index| value(index) * value(index)).sum();
        let (half, zero) = (R::literal(0.5), R::literal(0.0));
        for (index, known) in self.vector.iter_mut().enumerate() {
            let first = R::literal(value(index) / squares.sqrt());
            *known = R::select_less(half, takes, first, *known);
        }
        self.estimate = R::select_less(half, takes, zero, self.estimate);
    }

    /// Returns the estimate after two more multiplications, where `takes` is 1: the square root of
    /// the growth over both, because a single one turns positions into accelerations and tells
    /// nothing. It decays slowly, so a vector that happens to have a small part of the fastest
    /// motion does not make the machine look easy.
    pub(super) fn renew(&mut self, jacobian: &[R], takes: R) -> R {
        let radius = self.grow(jacobian, takes).sqrt();
        let kept = R::literal(0.9) * self.estimate;
        let larger = R::select_less(kept, radius, radius, kept);
        let larger = R::select_less(R::literal(0.5), takes, larger, self.estimate);
        self.estimate = R::select_less(radius, R::literal(f64::INFINITY), larger, self.estimate);
        self.estimate
    }

    /// Returns the estimate of a check, by twice as many multiplications.
    pub(super) fn looked_at(&mut self, jacobian: &[R], takes: R) -> R {
        self.renew(jacobian, takes);
        self.renew(jacobian, takes)
    }

    /// Returns the estimate after enough multiplications to make the initial vector irrelevant.
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

    /// Sets vector = J J vector, normalized, where `takes` is 1; returns the previous length.
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

/// Computes product = J vector.
fn multiply<R: Real>(entries: &[(u32, u32)], jacobian: &[R], vector: &[R], product: &mut [R]) {
    let zero = R::literal(0.0);
    product.fill(zero);
    // Sums of neighbouring entries of a row stay in registers.
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
