//! Stages of sensitivities: of the variational equations at the states of the stages.

use std::ops::Range;

use crate::method::lanes::{Sum, combine_many, padded_many, sum};
use crate::method::sensitivity::{Equations, Tangents};
use crate::method::tableau::Pair;
use crate::method::vectors::{Work, widest};

/// Stages of S' = J S + df/dp. J and df/dp do not depend on S and are evaluated first, at the
/// states of all stages; the stages then consist of sums of products only.
pub(super) struct Carried {
    /// Number of sensitivities plus padding of zeros.
    width: usize,
    /// Number of states plus padding.
    state_width: usize,
    /// S', stage by stage.
    stages: Vec<f64>,
    /// J and dy'/dp of the stages, one after another.
    jacobians: Vec<f64>,
    /// df/dp of the stages.
    drives: Vec<f64>,
    sums: Vec<Sum>,
    estimates: Vec<Sum>,
    dense: Sum,
    argument: Vec<f64>,
    start: Vec<f64>,
    /// States of the stages, one after another.
    states: Vec<f64>,
    /// True if the first stage is known as the last one of the previous step.
    pub(super) has_first_stage: bool,
    pub(super) has_extra_stages: bool,
}

impl Carried {
    pub(super) fn new(pair: &Pair, tangents: &Tangents<'_>, state_width: usize) -> Self {
        let (width, count) = (padded_many(tangents.len()), pair.nodes.len());
        let zeros = || vec![0.0; width];
        Self {
            width,
            state_width,
            stages: vec![0.0; width * count],
            jacobians: vec![0.0; tangents.equations().values() * count],
            drives: vec![0.0; width * count],
            sums: pair.rows.iter().chain(pair.dense.extra).map(|row| sum(row, width)).collect(),
            estimates: pair.estimates.iter().map(|row| sum(row, width)).collect(),
            dense: (0..count).map(|stage| (stage * width, 0.0)).collect(),
            argument: zeros(),
            start: zeros(),
            states: vec![0.0; state_width * count],
            has_first_stage: false,
            has_extra_stages: false,
        }
    }

    /// Returns the state of a stage.
    pub(super) fn state(&mut self, stage: usize) -> &mut [f64] {
        &mut self.states[stage * self.state_width..][..self.state_width]
    }

    /// Starts a step at S.
    pub(super) fn begin(&mut self, start: &[f64]) {
        self.start[..start.len()].copy_from_slice(start);
        self.has_extra_stages = false;
    }

    /// Evaluates J and df/dp of a stage; `evaluate` writes them for its state.
    pub(super) fn linearize(
        &mut self,
        tangents: &Tangents<'_>,
        stage: usize,
        evaluate: impl FnOnce(&[f64], &mut [f64], &mut [f64]),
    ) {
        let values = tangents.equations().values();
        let jacobians = &mut self.jacobians[stage * values..][..values];
        let drive = &mut self.drives[stage * self.width..][..tangents.len()];
        evaluate(&self.states[stage * self.state_width..], jacobians, drive);
    }

    /// Computes some of the stages of a step.
    pub(super) fn add_stages(&mut self, tangents: &Tangents<'_>, stages: Range<usize>, step: f64) {
        widest(Recursion { carried: self, equations: tangents.equations(), stages, step });
    }

    /// Returns S at the last stage computed.
    pub(super) fn reached(&self, count: usize) -> &[f64] {
        &self.argument[..count]
    }

    /// Returns errors of S by one of the pair's estimates.
    pub(super) fn estimate(&mut self, index: usize, step: f64) -> Option<&[f64]> {
        let row = self.estimates.get(index)?;
        let (stages, into) = (&self.stages, &mut self.argument[..]);
        widest(Combination { sum: row, stages, step, start: None, into });
        Some(&self.argument)
    }

    /// Computes S within the step by weights of the stages.
    pub(super) fn interpolate(&mut self, weights: &[f64], step: f64, into: &mut [f64]) {
        for ((_, own), weight) in self.dense.iter_mut().zip(weights) {
            *own = *weight;
        }
        let (sum, stages, start) = (&self.dense, &self.stages, Some(&self.start[..]));
        widest(Combination { sum, stages, step, start, into: &mut self.argument });
        into.copy_from_slice(&self.argument[..into.len()]);
    }

    /// Makes a stage the first one of the next step.
    pub(super) fn restart(&mut self, stage: usize, is_first: bool) {
        self.stages.copy_within(stage * self.width..(stage + 1) * self.width, 0);
        self.has_first_stage = is_first;
    }
}

/// Recursive computation of stages.
struct Recursion<'a> {
    carried: &'a mut Carried,
    equations: &'a Equations,
    stages: Range<usize>,
    step: f64,
}

impl Work for Recursion<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        let Carried { width, stages, jacobians, drives, sums, argument, start, .. } = self.carried;
        let values = self.equations.values();
        for stage in self.stages {
            combine_many(&sums[stage], stages, self.step, Some(start), argument);
            let jacobian = &jacobians[stage * values..][..values];
            let of_stage = stage * *width..(stage + 1) * *width;
            let of = (jacobian, &drives[of_stage.clone()]);
            self.equations.rate(of, argument, &mut stages[of_stage]);
        }
    }
}

/// Weighted sum of stages.
struct Combination<'a> {
    sum: &'a Sum,
    stages: &'a [f64],
    step: f64,
    start: Option<&'a [f64]>,
    into: &'a mut [f64],
}

impl Work for Combination<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        combine_many(self.sum, self.stages, self.step, self.start, self.into);
    }
}
