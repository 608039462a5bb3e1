//! Samples of guards on the dense output of a step.

/// Values of all guards on the dense output of the step.
pub(super) struct Samples {
    times: Vec<f64>,
    /// Values at each time, one after another.
    values: Vec<f64>,
    guards: usize,
}

impl Samples {
    pub(super) fn new(guards: usize) -> Self {
        Self { times: Vec::new(), values: Vec::new(), guards }
    }

    pub(super) fn at(&self, time: f64) -> Option<&[f64]> {
        let place = self.times.iter().position(|it| it.to_bits() == time.to_bits())?;
        Some(&self.values[place * self.guards..][..self.guards])
    }

    pub(super) fn push(&mut self, time: f64, values: impl Iterator<Item = f64>) {
        self.times.push(time);
        self.values.extend(values);
    }

    pub(super) fn last(&self) -> &[f64] {
        &self.values[self.values.len() - self.guards..]
    }

    /// Returns the number of times.
    pub(super) fn count(&self) -> usize {
        self.times.len()
    }

    /// Keeps the first samples.
    pub(super) fn truncate(&mut self, count: usize) {
        self.times.truncate(count);
        self.values.truncate(count * self.guards);
    }

    pub(super) fn clear(&mut self) {
        self.truncate(0);
    }
}
