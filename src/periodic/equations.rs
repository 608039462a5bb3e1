//! Equations of multiple shooting, and their linearization.
//!
//! ```text
//! phi(x_i, t_i, t_{i+1}) - x_{i+1} = 0     i = 0 .. m - 1,   x_m = x_0 + 2 pi k,   t_i = t_0 + i T/m
//! ```
//!
//! Unknowns and equations are scaled by the scales of the states.

use nalgebra::{DMatrix, DVector};

use super::error::CycleError;
use super::shot::{Directions, Shot};
use crate::simulate::Simulation;

/// Period of the motion.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Period {
    /// Period \[s\].
    Fixed(f64),
    /// Period determined by a parameter p: `multiple` times `turns`/|p|, or p if there are none.
    OfParameter { index: usize, turns: Option<f64>, multiple: f64 },
    /// Solved for.
    Unknown,
}

impl Period {
    /// Returns the period \[s\] with these parameters, unless it is solved for.
    pub(super) fn of(&self, parameters: &[f64]) -> Option<f64> {
        match self {
            Self::Fixed(period) => Some(*period),
            Self::OfParameter { index, turns, multiple } => {
                let value = parameters[*index];
                Some(multiple * turns.map_or(value, |turns| turns / value.abs()))
            }
            Self::Unknown => None,
        }
    }

    /// Returns the derivative of a given period by a parameter.
    fn slope(&self, period: f64, parameter: usize, value: f64) -> f64 {
        match self {
            Self::OfParameter { index, turns, .. } if *index == parameter => {
                period / if turns.is_some() { -value } else { value }
            }
            _ => 0.0,
        }
    }
}

/// Machine, period and segments of a search.
pub(super) struct Problem<'a> {
    pub(super) run: Simulation<'a>,
    /// Indices of the states that are not modes.
    pub(super) free: Vec<usize>,
    /// Advance of every state in a period, in its unit.
    pub(super) advance: Vec<f64>,
    pub(super) period: Period,
    pub(super) segments: usize,
    /// Scales of the free states.
    pub(super) scales: Vec<f64>,
    /// Start time of the run \[s\].
    pub(super) origin: f64,
    /// Parameter that is solved for.
    pub(super) varied: Option<usize>,
}

/// Unknowns of the equations.
#[derive(Debug, Clone)]
pub(super) struct Guess {
    /// State at the start of each segment, with modes.
    pub(super) nodes: Vec<Vec<f64>>,
    /// Period \[s\], used if it is solved for.
    pub(super) period: f64,
    /// Number of periods from the start of the run to the start of the motion.
    pub(super) skipped: f64,
    /// Value of the varied parameter.
    pub(super) value: f64,
}

/// Linearized equations `matrix` dx + `by_period` dT/T + `by_parameter` dp = -`residual`, with the
/// phase condition `phase`^T dx = 0.
pub(super) struct Linear {
    pub(super) matrix: DMatrix<f64>,
    pub(super) residual: DVector<f64>,
    /// Column and phase condition of an unknown period.
    pub(super) by_period: Option<(DVector<f64>, DVector<f64>)>,
    /// Column of the varied parameter, per its unit.
    pub(super) by_parameter: Option<DVector<f64>>,
}

impl<'a> Problem<'a> {
    pub(super) fn new(
        run: Simulation<'a>,
        free: Vec<usize>,
        advance: Vec<f64>,
        period: Period,
        segments: usize,
    ) -> Self {
        let simulator = run.simulator();
        let scales = free.iter().map(|index| simulator.state_scale(*index)).collect();
        let origin = run.start_time();
        Self { run, free, advance, period, segments, scales, origin, varied: None }
    }

    /// Returns the relative tolerance of the search.
    pub(super) fn tolerance(&self) -> f64 {
        10.0 * self.run.relative_tolerance()
    }

    /// Returns the run with the value of the varied parameter.
    pub(super) fn run_at(&self, guess: &Guess) -> Simulation<'a> {
        let run = self.run.clone();
        match self.varied {
            Some(index) => run.parameter_at(index, guess.value),
            None => run,
        }
    }

    /// Returns start and length of the period \[s\].
    pub(super) fn span_of(&self, guess: &Guess) -> (f64, f64) {
        match self.period.of(self.run_at(guess).parameter_values()) {
            Some(period) => (self.origin + guess.skipped * period, period),
            None => (self.origin, guess.period),
        }
    }

    /// Runs over all segments.
    pub(super) fn shots(&self, guess: &Guess) -> Result<Vec<Shot>, CycleError> {
        let run = self.run_at(guess);
        let (start, period) = self.span_of(guess);
        let time = |index: usize| start + period * (index as f64 / self.segments as f64);
        let by = Directions { states: &self.free, parameter: self.varied, scales: &self.scales };
        let shot = |(index, node): (usize, &Vec<f64>)| {
            let run = run.clone().from(time(index)).until(time(index + 1));
            Ok(Shot::new(&run.shot_from(node), by)?)
        };
        guess.nodes.iter().enumerate().map(shot).collect()
    }

    /// Returns the difference of the end of a segment from the start of the next one, of all
    /// states.
    pub(super) fn gap(&self, shots: &[Shot], index: usize) -> Vec<f64> {
        let is_last = index + 1 == shots.len();
        let next = if is_last { &shots[0].start } else { &shots[index + 1].start };
        let advance = |state: usize| if is_last { self.advance[state] } else { 0.0 };
        let end = shots[index].end.iter().zip(next).enumerate();
        end.map(|(state, (end, next))| end - next - advance(state)).collect()
    }

    /// Returns the largest difference over the sum of scale and size, its state, and its value.
    pub(super) fn largest_gap(&self, shots: &[Shot]) -> (f64, usize, f64) {
        let mut largest = (0.0, self.free.first().copied().unwrap_or(0), 0.0);
        for (segment, shot) in shots.iter().enumerate() {
            let gap = self.gap(shots, segment);
            for (state, scale) in self.free.iter().zip(&self.scales) {
                let size = scale + shot.end[*state].abs().max(shot.start[*state].abs());
                let share = gap[*state].abs() / size;
                if share > largest.0 || share.is_nan() {
                    largest = (share, *state, gap[*state]);
                }
            }
        }
        largest
    }

    /// Returns a mode that differs from one segment to the next: its state, its values.
    pub(super) fn other_mode(&self, shots: &[Shot]) -> Option<(usize, f64, f64)> {
        let simulator = self.run.simulator();
        (0..shots.len()).find_map(|segment| {
            let gap = self.gap(shots, segment);
            let state = (0..gap.len()).find(|at| simulator.is_mode(*at) && gap[*at].abs() > 0.5)?;
            let end = shots[segment].end[state];
            Some((state, end - gap[state], end))
        })
    }

    /// Returns y' of the free states over their scales.
    pub(super) fn scaled_rate(&self, guess: &Guess, time: f64, state: &[f64]) -> DVector<f64> {
        let run = self.run_at(guess);
        let mut rate = vec![0.0; state.len()];
        run.simulator().rate(time, state, run.parameter_values(), &mut rate);
        let scaled = self.free.iter().zip(&self.scales).map(|(index, scale)| rate[*index] / scale);
        DVector::from_iterator(self.free.len(), scaled)
    }

    /// Returns W^-1 A W with the scales W.
    pub(super) fn scaled(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let scales = &self.scales;
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
            matrix[(row, column)] * scales[column] / scales[row]
        })
    }

    /// Returns W^-1 v.
    fn over_scales(&self, vector: &DVector<f64>) -> DVector<f64> {
        vector.component_div(&DVector::from_column_slice(&self.scales))
    }

    /// Linearizes the equations.
    pub(super) fn linear(&self, guess: &Guess, shots: &[Shot]) -> Linear {
        let (n, m) = (self.free.len(), shots.len());
        let mut matrix = DMatrix::zeros(n * m, n * m);
        let mut residual = DVector::zeros(n * m);
        for (index, shot) in shots.iter().enumerate() {
            let next = (index + 1) % m;
            let mut put = |column: usize, sign: f64, block: &DMatrix<f64>| {
                let mut place = matrix.view_mut((index * n, column * n), (n, n));
                place += sign * self.scaled(block);
            };
            put(index, 1.0, &shot.transition);
            put(next, -1.0, &shots[next].projection);
            let gap = self.gap(shots, index);
            let gap = DVector::from_iterator(n, self.free.iter().map(|state| gap[*state]));
            residual.rows_mut(index * n, n).copy_from(&self.over_scales(&gap));
        }
        Linear {
            matrix,
            residual,
            by_period: (self.period == Period::Unknown).then(|| self.by_period(guess, shots)),
            by_parameter: self.varied.map(|index| self.by_parameter(guess, shots, index)),
        }
    }

    /// Returns the column of an unknown period, and its phase condition.
    fn by_period(&self, guess: &Guess, shots: &[Shot]) -> (DVector<f64>, DVector<f64>) {
        let (n, m) = (self.free.len(), shots.len());
        let (start, period) = self.span_of(guess);
        let mut column = DVector::zeros(n * m);
        for (index, shot) in shots.iter().enumerate() {
            // The machine does not depend on time.
            let rate = self.scaled_rate(guess, start, &shot.end);
            column.rows_mut(index * n, n).copy_from(&(rate * (period / m as f64)));
        }
        let mut phase = DVector::zeros(n * m);
        let rate = self.scaled_rate(guess, start, &shots[0].start);
        let size = rate.norm();
        if size > 0.0 {
            phase.rows_mut(0, n).copy_from(&(rate / size));
        }
        (column, phase)
    }

    /// Returns the column of the varied parameter, with the times of the segments, which move with
    /// the period:
    ///
    /// ```text
    /// d phi/dp = S_p + f(end) dt_{i+1}/dp - M f(start) dt_i/dp
    /// ```
    ///
    /// The start of the next segment moves too, where constraints depend on time, such as those of
    /// a prescribed angle. With P the derivative of the start by the initial values,
    ///
    /// ```text
    /// d start/dp = S_p + (1 - P) f(start) dt/dp
    /// ```
    fn by_parameter(&self, guess: &Guess, shots: &[Shot], parameter: usize) -> DVector<f64> {
        let (n, m) = (self.free.len(), shots.len());
        let (start, period) = self.span_of(guess);
        let slope = self.period.slope(period, parameter, guess.value);
        let mut column = DVector::zeros(n * m);
        for (index, shot) in shots.iter().enumerate() {
            let next = (index + 1) % m;
            let ends = (&shot.by_parameter, &shots[next].by_parameter);
            let (Some([_, end]), Some([start_of_next, _])) = ends else { continue };
            let mut derivative = self.over_scales(&(end - start_of_next));
            if slope != 0.0 {
                let share = |index: usize| index as f64 / m as f64;
                let time = |index: usize| start + period * share(index);
                let moves = |index: usize| slope * (guess.skipped + share(index));
                derivative +=
                    self.scaled_rate(guess, time(index + 1), &shot.end) * moves(index + 1);
                let from = self.scaled_rate(guess, time(index), &shot.start);
                derivative -= self.scaled(&shot.transition) * from * moves(index);
                let led = self.scaled_rate(guess, time(next), &shots[next].start);
                let free = self.scaled(&shots[next].projection) * &led;
                derivative -= (led - free) * moves(next);
            }
            column.rows_mut(index * n, n).copy_from(&derivative);
        }
        column
    }

    /// Returns the guess moved along a scaled direction, with the modes in which the motion
    /// arrived.
    pub(super) fn moved(&self, guess: &Guess, shots: &[Shot], step: &Step) -> Guess {
        let (n, m) = (self.free.len(), shots.len());
        let nodes = shots.iter().enumerate().map(|(index, shot)| {
            let mut node = shots[(index + m - 1) % m].end.clone();
            for (at, (state, scale)) in self.free.iter().zip(&self.scales).enumerate() {
                node[*state] = shot.start[*state] + scale * step.states[index * n + at];
            }
            node
        });
        Guess {
            nodes: nodes.collect(),
            period: guess.period * (1.0 + step.period),
            value: guess.value + step.value,
            skipped: guess.skipped,
        }
    }
}

/// Change of the unknowns.
#[derive(Debug, Clone)]
pub(super) struct Step {
    /// Changes of the states over their scales.
    pub(super) states: DVector<f64>,
    /// Relative change of the period.
    pub(super) period: f64,
    /// Change of the parameter.
    pub(super) value: f64,
}

impl Step {
    /// Returns a share of the change.
    pub(super) fn times(&self, share: f64) -> Self {
        let Self { states, period, value } = self;
        Self { states: states * share, period: period * share, value: value * share }
    }
}
