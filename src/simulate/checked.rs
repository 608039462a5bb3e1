//! Checks of a request: parameters, tolerances, times and guards.

use machinist_contract::{Interval, Simulator};

use super::{MAX_POINTS, Sampling, Simulation};
use crate::error::SimulateError;
use crate::held::Held;
use crate::scales::scales;

/// Checks that no guard is identically zero in the modes in which it is watched, by its range over all times
/// and states, if the simulator gives ranges.
pub(crate) fn require_guards(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
) -> Result<(), SimulateError> {
    let Some(ranges) = simulator.ranges().filter(|_| simulator.events() > 0) else {
        return Ok(());
    };
    let held = Held::live(simulator, parameters);
    let parameters: Vec<_> = held.all().iter().copied().map(Interval::of).collect();
    let guards_in = |modes: &[(u32, f64)]| {
        let mut state = vec![Interval::WHOLE; simulator.shape().states()];
        for (mode, value) in modes {
            state[*mode as usize] = Interval::of(*value);
        }
        let mut guards = vec![Interval::WHOLE; simulator.events() + simulator.kinks()];
        ranges.guard_ranges(Interval::WHOLE, &state, &parameters, &mut guards);
        guards
    };
    let in_any = guards_in(&[]);
    let is_zero = |index: &usize| match simulator.event(*index).when {
        [] => in_any[*index].is_zero(),
        when => guards_in(when)[*index].is_zero(),
    };
    (0..simulator.events()).find(is_zero).map_or(Ok(()), |index| {
        let scene = simulator.name().to_owned();
        let event = simulator.event(index).name.to_owned();
        Err(SimulateError::GuardIsZero { scene, event })
    })
}

impl Simulation<'_> {
    pub(crate) fn checked_parameters(&self) -> Result<&[f64], SimulateError> {
        let name = |index| format!("parameter `{}`", self.simulator.parameter(index).name);
        self.check_list("parameters", &self.parameters, self.simulator.shape().parameters, name)?;
        require_admitted(self.simulator, &self.parameters)?;
        Ok(&self.parameters)
    }

    /// Refuses to keep the energy of a machine that does not conserve it.
    pub(super) fn check_constant_energy(&self) -> Result<(), SimulateError> {
        let conserves = self.simulator.conserves_energy(&self.parameters) == Some(true);
        let why = if !self.keeps_energy {
            return Ok(());
        } else if !conserves {
            "power is supplied or dissipated, or may be"
        } else if self.simulator.constraints() == 0 {
            "it has no constraints"
        } else if !self.sensitivities.is_empty() {
            "sensitivities are not projected"
        } else {
            return Ok(());
        };
        let scene = self.simulator.name().to_owned();
        Err(SimulateError::NoConstantEnergy { scene, why })
    }

    pub(crate) fn checked_jumps(&self) -> Result<Vec<f64>, SimulateError> {
        let count = self.simulator.shape().discontinuities;
        let mut jumps = vec![0.0; count];
        self.simulator.discontinuities(&self.parameters, &mut jumps);
        let name = |index| format!("time of jump number {index}");
        self.check_list("jumps", &jumps, count, name)?;
        Ok(jumps)
    }

    pub(super) fn check_list(
        &self,
        what: &'static str,
        values: &[f64],
        expected: usize,
        name: impl Fn(usize) -> String,
    ) -> Result<(), SimulateError> {
        if values.len() != expected {
            let scene = self.simulator.name().to_owned();
            return Err(SimulateError::WrongLength { scene, what, expected, found: values.len() });
        }
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => {
                Err(SimulateError::NotFinite { what: name(index), value: values[index] })
            }
        }
    }

    pub(crate) fn checked_atol(&self, initial: &[f64]) -> Result<Vec<f64>, SimulateError> {
        if !(self.rtol > 0.0 && self.rtol <= 1.0) {
            return Err(SimulateError::BadTolerance(self.rtol));
        }
        let scaled = || {
            let mut scales = scales(self.simulator, &self.parameters, self.from, initial);
            self.sizes.iter().for_each(|(index, size)| scales[*index] = *size);
            scales.iter().map(|scale| self.rtol * scale).collect()
        };
        let atol = self.atol.clone().unwrap_or_else(scaled);
        if atol.len() != initial.len() {
            let (scene, found) = (self.simulator.name().to_owned(), atol.len());
            let (what, expected) = ("states", initial.len());
            return Err(SimulateError::WrongLength { scene, what, expected, found });
        }
        match atol.iter().position(|value| !(value.is_finite() && *value > 0.0)) {
            None => Ok(atol),
            Some(index) => Err(SimulateError::BadAbsoluteTolerance {
                state: self.simulator.state(index).name.to_owned(),
                value: atol[index],
            }),
        }
    }

    pub(crate) fn checked_times(&self) -> Result<Vec<f64>, SimulateError> {
        let (from, until) = (self.from, self.until);
        if !(from < until && (until - from).is_finite()) {
            return Err(SimulateError::BadSpan { from, until });
        }
        let times = match &self.sampling {
            Sampling::Points(points) if !(2..=MAX_POINTS).contains(points) => {
                return Err(SimulateError::BadPoints(*points));
            }
            Sampling::Points(points) => equally_spaced(from, until, *points),
            Sampling::Times(times) => times.clone(),
            Sampling::Listed(times) => within(times, from, until),
        };
        if !(2..=MAX_POINTS).contains(&times.len()) {
            return Err(SimulateError::BadPoints(times.len()));
        }
        let mut earliest = from;
        for (index, &time) in times.iter().enumerate() {
            if !(earliest <= time && time <= until) {
                return Err(SimulateError::BadTime { index, time, from, until });
            }
            earliest = time;
        }
        Ok(times)
    }
}

/// Refuses parameter values that the spec's checks refuse.
pub(crate) fn require_admitted(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
) -> Result<(), SimulateError> {
    simulator.refusal(parameters).map_or(Ok(()), |refusal| {
        let (scene, rule) = (simulator.name().to_owned(), refusal.rule.to_owned());
        Err(SimulateError::RefusedParameters { scene, rule, value: refusal.value })
    })
}

/// Returns the times that lie within a run, with the end of the run added. The start is added if it
/// cuts off earlier times, or if the end would be alone.
fn within(times: &[f64], from: f64, until: f64) -> Vec<f64> {
    let mut kept: Vec<f64> =
        times.iter().copied().filter(|time| from <= *time && *time <= until).collect();
    if times.first().is_some_and(|first| *first < from) && kept.first() != Some(&from) {
        kept.insert(0, from);
    }
    if kept.last() != Some(&until) {
        kept.push(until);
    }
    if kept.len() == 1 {
        kept.insert(0, from);
    }
    kept
}

/// Returns `points` times from `from` to `until`, both met exactly.
fn equally_spaced(from: f64, until: f64, points: usize) -> Vec<f64> {
    let last = points - 1;
    let time = |index: usize| {
        let share = index as f64 / last as f64;
        if index == last { until } else { (from + (until - from) * share).min(until) }
    };
    (0..points).map(time).collect()
}
