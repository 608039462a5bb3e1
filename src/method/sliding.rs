//! Motions that slide along the surfaces of relations (Filippov).
//!
//! If the rate jumps at g = 0 and points at the surface from both sides, the motion stays on it, by
//! the convex combination of both rates:
//!
//! ```text
//! y' = f- + alpha (f+ - f-),    g' = 0          order 1: g' jumps
//!                               g'' = 0         order 2: g' is continuous, g'' jumps
//! ```
//!
//! Forces enter accelerations and multipliers linearly, and so do the alphas of several surfaces,
//! unless forces of different relations are multiplied with each other. The combination is then not
//! unique, and the motion is refused.
//!
//! The surface of a comparison is where its difference is zero. That of `floor(a)` is where a is the
//! upper of the two integers between which the result jumps.

use nalgebra::{DMatrix, DVector};

use super::system::FLOWS;
use super::{Stopped, System};
use crate::error::StopCause;

/// Newton's iteration is at rounding after two rounds; a third is for curved surfaces.
const ROUNDS: usize = 3;
/// Slot that holds a branch below zero.
pub(crate) const BELOW: f64 = f64::NEG_INFINITY;
/// Slot that holds a branch above zero.
pub(crate) const ABOVE: f64 = f64::INFINITY;

/// Derivative of the guard that a sliding motion keeps at zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    /// g', which jumps.
    First,
    /// g'', which jumps where g' does not.
    Second,
}

/// Slots of a relation on both sides of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sides {
    pub(crate) below: f64,
    pub(crate) above: f64,
}

impl Sides {
    /// Returns the sides of a surface from the slot below it.
    pub(crate) fn above_slot(below: f64) -> Self {
        Self { below, above: if below.is_infinite() { ABOVE } else { below + 1.0 } }
    }

    /// Returns the value of the relation's guard on the surface.
    pub(super) fn level(self) -> f64 {
        if self.above.is_infinite() { 0.0 } else { self.above }
    }

    pub(crate) fn both(self) -> [f64; 2] {
        [self.below, self.above]
    }
}

/// A relation along whose surface a motion slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide {
    pub(crate) relation: usize,
    pub(crate) sides: Sides,
    pub(crate) order: Order,
}

/// Rates on the sides of the surfaces, and the combination that stays on them.
struct Combination {
    /// With all relations below, then with each of them above.
    rates: Vec<Vec<f64>>,
    /// Derivatives of guards that must vanish: with all below, then the contribution of each
    /// relation.
    slopes: DMatrix<f64>,
    alphas: DVector<f64>,
}

impl System<'_> {
    /// Lets the motion slide along the given surfaces and no others.
    pub(crate) fn slide(&self, slides: &[Slide]) {
        for slide in slides {
            self.held().set(slide.relation, slide.sides.below);
        }
        self.slides.replace(slides.to_vec());
    }

    /// Returns the surfaces along which the motion slides.
    pub(crate) fn slides(&self) -> Vec<Slide> {
        self.slides.borrow().clone()
    }

    /// Returns whether it slides along these surfaces and no others.
    #[cfg(feature = "implicit")]
    pub(super) fn slides_along(&self, slides: &[Slide]) -> bool {
        *self.slides.borrow() == slides
    }

    /// Returns whether it slides along any surface.
    pub(crate) fn is_sliding(&self) -> bool {
        !self.slides.borrow().is_empty()
    }

    /// Returns the shares of the rates above in the combination.
    pub(crate) fn alphas(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.combination(time, state).alphas.as_slice().to_vec()
    }

    /// Computes y' along the surfaces.
    pub(super) fn sliding_rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let Combination { rates, alphas, .. } = self.combination(time, state);
        rate.copy_from_slice(&rates[0]);
        for (above, alpha) in rates[1..].iter().zip(&alphas) {
            for ((value, above), below) in rate.iter_mut().zip(above).zip(&rates[0]) {
                *value += alpha * (above - below);
            }
        }
    }

    /// Returns the rates of the energy quadratures along the surfaces, combined likewise.
    pub(super) fn sliding_flows(&self, time: f64, state: &[f64]) -> [f64; FLOWS] {
        let mut total = [0.0; 2];
        self.for_each_side(&self.alphas(time, state), |share| {
            let all = self.held().all();
            let power = self.simulator().power_balance(time, &state[..self.states()], &all);
            total[0] += share * power.supplied;
            total[1] += share * power.dissipated;
        });
        [total[0], total[1], total[0].abs() + total[1].abs()]
    }

    /// Calls a function once for every side of the surfaces, with relations held there and its share
    /// in the combination.
    pub(super) fn for_each_side(&self, alphas: &[f64], mut call: impl FnMut(f64)) {
        call(1.0 - alphas.iter().sum::<f64>());
        for (slide, alpha) in self.slides().iter().zip(alphas) {
            self.held().set(slide.relation, slide.sides.above);
            call(*alpha);
            self.held().set(slide.relation, slide.sides.below);
        }
    }

    /// Returns the alphas, and the difference of the rates on both sides of each surface.
    pub(super) fn across_surfaces(&self, time: f64, state: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let Combination { rates, alphas, .. } = self.combination(time, state);
        (alphas.as_slice().to_vec(), differences(&rates))
    }

    /// Returns these differences, and the shares of them that change the rates of guards by the
    /// columns of `right`; `None` if they are not determined.
    pub(super) fn shares_along_surfaces(
        &self,
        time: f64,
        state: &[f64],
        right: &DMatrix<f64>,
    ) -> Option<(Vec<Vec<f64>>, DMatrix<f64>)> {
        let Combination { rates, slopes, .. } = self.combination(time, state);
        let shares = slopes.columns(1, rates.len() - 1).into_owned().lu().solve(right)?;
        Some((differences(&rates), shares))
    }

    /// Returns the derivatives of the alphas by a state or, counted after the states, a parameter,
    /// by central differences. Surfaces are of order one.
    pub(super) fn slopes_of_alphas(&self, time: f64, state: &[f64], by: usize) -> Vec<f64> {
        let states = self.states();
        let all = [&state[..states], &self.held().all()].concat();
        let size = if by < states { self.simulator().state_scale(by) } else { 0.0 };
        let size = all[by].abs().max(size);
        let step = f64::EPSILON.cbrt() * if size > 0.0 { size } else { 1.0 };
        let [ahead, behind] = [step, -step].map(|step| {
            let mut shifted = all.clone();
            shifted[by] += step;
            let (state, parameters) = shifted.split_at_mut(states);
            let slides = self.slides();
            let first = parameters.len() - self.simulator().relations();
            let mut rates = |above: Option<&Slide>| {
                if let Some(slide) = above {
                    parameters[first + slide.relation] = slide.sides.above;
                }
                let mut rates = vec![0.0; self.simulator().kinks()];
                self.simulator().kink_rates(time, state, parameters, &mut rates);
                if let Some(slide) = above {
                    parameters[first + slide.relation] = slide.sides.below;
                }
                DVector::from_iterator(slides.len(), slides.iter().map(|it| rates[it.relation]))
            };
            let below = rates(None);
            let columns: Vec<_> = slides.iter().map(|slide| rates(Some(slide)) - &below).collect();
            DMatrix::from_columns(&columns).lu().solve(&-below)
        });
        match (ahead, behind) {
            (Some(ahead), Some(behind)) => ((ahead - behind) / (2.0 * step)).as_slice().to_vec(),
            _ => vec![f64::NAN; self.slides().len()],
        }
    }

    /// Computes the Jacobian along the surfaces by central differences, in the order of its
    /// pattern.
    pub(super) fn sliding_jacobian(&self, time: f64, state: &[f64], values: &mut [f64]) {
        let states = self.states();
        let mut shifted = state[..states].to_vec();
        let [mut ahead, mut behind] = [(); 2].map(|()| vec![0.0; states]);
        let entries = self.jacobian_pattern().entries;
        for column in 0..states {
            let size = state[column].abs().max(self.simulator().state_scale(column));
            let by = f64::EPSILON.cbrt() * size;
            shifted[column] = state[column] + by;
            self.sliding_rate(time, &shifted, &mut ahead);
            shifted[column] = state[column] - by;
            self.sliding_rate(time, &shifted, &mut behind);
            shifted[column] = state[column];
            let of_column = entries.iter().zip(&mut *values);
            for ((row, _), value) in of_column.filter(|((_, at), _)| *at as usize == column) {
                let row = *row as usize;
                *value = (ahead[row] - behind[row]) / (2.0 * by);
            }
        }
    }

    /// Computes the partial derivative by time along the surfaces, by a central difference.
    pub(super) fn sliding_time_derivative(&self, time: f64, state: &[f64], into: &mut [f64]) {
        let by = f64::EPSILON.cbrt() * time.abs().max(1.0);
        let mut behind = vec![0.0; into.len()];
        self.sliding_rate(time + by, state, into);
        self.sliding_rate(time - by, state, &mut behind);
        for (value, behind) in into.iter_mut().zip(&behind) {
            *value = (*value - behind) / (2.0 * by);
        }
    }

    /// Projects a state onto the surfaces along which it slides, in the directions of their forces.
    ///
    /// # Errors
    /// [`StopCause::OffSurface`] if that does not succeed.
    pub(crate) fn put_onto_surfaces(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let states = self.states();
        let slides = self.slides();
        for _ in 0..ROUNDS {
            let guards = self.kink_guards(time, &state[..states]);
            let off = |slide: &Slide| guards[slide.relation] - slide.sides.level();
            let first = |slide: &Slide| slide.order == Order::First;
            if slides.iter().filter(|slide| first(slide)).all(|slide| off(slide) == 0.0) {
                break;
            }
            let Combination { rates, slopes, .. } = self.combination(time, &state[..states]);
            let count = slides.len();
            let right = DVector::from_iterator(
                count,
                slides.iter().map(|it| if first(it) { -off(it) } else { 0.0 }),
            );
            let Some(shares) = slopes.columns(1, count).into_owned().lu().solve(&right) else {
                let state = self.name(0);
                return Err(Stopped { time, cause: StopCause::OffSurface { state } });
            };
            for (above, share) in rates[1..].iter().zip(&shares) {
                for ((value, above), below) in state.iter_mut().zip(above).zip(&rates[0]) {
                    *value += share * (above - below);
                }
            }
        }
        if slides.iter().any(|slide| slide.order == Order::Second) {
            self.put_onto_flat_surfaces(time, &mut state[..states], &slides);
        }
        Ok(())
    }

    /// Projects onto g = 0 and g' = 0 by the shortest way, measured by the scales of the states.
    fn put_onto_flat_surfaces(&self, time: f64, state: &mut [f64], slides: &[Slide]) {
        let of: Vec<&Slide> = slides.iter().filter(|slide| slide.order == Order::Second).collect();
        let residuals = |state: &[f64]| {
            let (guards, rates) = (self.kink_guards(time, state), self.kink_rates(time, state));
            let pairs = of.iter().flat_map(|slide| {
                [guards[slide.relation] - slide.sides.level(), rates[slide.relation]]
            });
            DVector::from_iterator(2 * of.len(), pairs)
        };
        for _ in 0..ROUNDS {
            let here = residuals(state);
            if here.iter().all(|value| *value == 0.0) {
                return;
            }
            let mut shifted = state.to_vec();
            let columns: Vec<DVector<f64>> = (0..state.len())
                .map(|entry| {
                    if self.simulator().is_mode(entry) {
                        return DVector::zeros(here.len());
                    }
                    let scale = self.simulator().state_scale(entry).max(state[entry].abs());
                    let by = f64::EPSILON.sqrt() * scale;
                    shifted[entry] = state[entry] + by;
                    let column = (residuals(&shifted) - &here) * (scale / by);
                    shifted[entry] = state[entry];
                    column
                })
                .collect();
            let matrix = DMatrix::from_columns(&columns);
            let normal = &matrix * matrix.transpose();
            let Some(factors) = normal.lu().solve(&here) else { return };
            let shares = matrix.transpose() * factors;
            for (entry, share) in shares.iter().enumerate() {
                let scale = self.simulator().state_scale(entry).max(state[entry].abs());
                state[entry] -= scale * share;
            }
        }
    }

    /// Returns the guards of kinks, with relations as held.
    pub(crate) fn kink_guards(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.simulator().kinks()];
        let state = &state[..self.states()];
        self.simulator().kink_guards(time, state, &self.held().all(), &mut values);
        values
    }

    /// Returns the rates of these guards, likewise.
    pub(crate) fn kink_rates(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.simulator().kinks()];
        let state = &state[..self.states()];
        self.simulator().kink_rates(time, state, &self.held().all(), &mut values);
        values
    }

    /// Returns g'' of a guard along a rate, by a central difference of g'.
    pub(crate) fn bend_along(
        &self,
        guard: usize,
        (time, state): (f64, &[f64]),
        rate: &[f64],
    ) -> f64 {
        let state = &state[..self.states()];
        let speed = state.iter().zip(rate).enumerate().map(|(index, (value, rate))| {
            rate.abs() / value.abs().max(self.simulator().state_scale(index))
        });
        let fastest = speed.fold(0.0, f64::max);
        let by = f64::EPSILON.cbrt() / if fastest > 0.0 { fastest } else { 1.0 };
        let [ahead, behind] = [by, -by].map(|by| {
            let there: Vec<f64> = state.iter().zip(rate).map(|(y, f)| y + by * f).collect();
            self.kink_rates(time + by, &there)[guard]
        });
        (ahead - behind) / (2.0 * by)
    }

    fn combination(&self, time: f64, state: &[f64]) -> Combination {
        let (slides, state) = (self.slides(), &state[..self.states()]);
        let rate = || {
            let mut rate = vec![0.0; state.len()];
            self.rate_of_modes(time, state, &mut rate);
            rate
        };
        let slope = |slide: &Slide, rates: &[f64], along: &[f64]| match slide.order {
            Order::First => rates[slide.relation],
            Order::Second => self.bend_along(slide.relation, (time, state), along),
        };
        let mut rates = vec![rate()];
        let mut slopes = DMatrix::zeros(slides.len(), slides.len() + 1);
        let below = self.kink_rates(time, state);
        for (row, slide) in slides.iter().enumerate() {
            slopes[(row, 0)] = slope(slide, &below, &rates[0]);
        }
        for (column, of) in slides.iter().enumerate() {
            self.held().set(of.relation, of.sides.above);
            let (above, along) = (self.kink_rates(time, state), rate());
            for (row, slide) in slides.iter().enumerate() {
                slopes[(row, column + 1)] = slope(slide, &above, &along) - slopes[(row, 0)];
            }
            self.held().set(of.relation, of.sides.below);
            rates.push(along);
        }
        let count = slides.len();
        let right = -slopes.column(0);
        let alphas = slopes.columns(1, count).into_owned().lu().solve(&right);
        let alphas = alphas.unwrap_or_else(|| DVector::from_element(count, f64::NAN));
        Combination { rates, slopes, alphas }
    }
}

/// Returns the rates above surfaces less those below all of them.
fn differences(rates: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let less_below = |above: &Vec<f64>| {
        above.iter().zip(&rates[0]).map(|(above, below)| above - below).collect()
    };
    rates[1..].iter().map(less_below).collect()
}
