//! Jumps of velocities where the kinetic energy T jumps.
//!
//! The cause of the jump determines the law. With the momentum p = dT/dv, H = v^T p - T and the
//! impulse G^T nu of the constraints,
//!
//! ```text
//! time, events      p(v+) + G^T nu = p(v-)
//! place g(q, t)     p(v+) + G^T nu = p(v-) + kappa g_q,   H(v+) = H(v-) - kappa g_t
//! ```
//!
//! which is the limit of ever steeper changes that are smooth. Let v0 be the velocities by momentum
//! alone and w the velocities by an impulse g_q. Both equations for a place then give
//!
//! ```text
//! g'(v+)^2 = g'(v0)^2 - 2 (g_q w) (H(v0) - H(v-))
//! ```
//!
//! If that is negative, the energy does not suffice to reach the other side, and the motion is
//! thrown back with g'(v+) = -g'(v-). A guard that reads velocities has no such limit.

use machinist_contract::Constraint;
use nalgebra::DVector;

use super::{Stopped, System, Watch};
use crate::dense::dense;
use crate::error::StopCause;

/// Time and state on one side of a jump, and the slots of relations there.
#[derive(Debug, Clone)]
pub(crate) struct Moment {
    pub(crate) time: f64,
    pub(crate) state: Vec<f64>,
    pub(crate) slots: Vec<f64>,
}

/// Cause of a jump of T.
enum Cause<'a> {
    Time,
    /// Events, with the velocities that they do not set.
    Events(&'a [bool]),
    /// A place: g_q, by coordinates, and g' at rest.
    Place(Vec<f64>, f64),
}

/// Velocities after a jump of T.
struct Passage {
    velocities: Vec<f64>,
    is_thrown_back: bool,
}

/// Result of the jumps of T at one time.
#[derive(Debug, Default)]
pub(crate) struct Impulses {
    /// True if velocities jumped.
    pub(crate) has_moved: bool,
    /// Watched functions at which the motion was thrown back.
    pub(crate) thrown_back: Vec<usize>,
    /// Kinetic energy gained where time or a place is the cause \[J\]: it is supplied.
    pub(crate) supplied: f64,
}

impl System<'_> {
    /// Returns a time and a state, with slots as held.
    pub(crate) fn moment(&self, time: f64, state: &[f64]) -> Moment {
        Moment { time, state: state[..self.states()].to_vec(), slots: self.held().slots() }
    }

    /// Lets velocities jump where T jumps between two times. The change of energy is supplied.
    /// Returns true if they jumped.
    ///
    /// # Errors
    /// [`StopCause::InertiaJumps`] if sensitivities are carried.
    pub(crate) fn keep_momentum(
        &self,
        (front, behind): (f64, f64),
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        let states = self.states();
        let (front, behind) = (self.moment(front, state), self.moment(behind, state));
        let Some(passage) = self.pass(&front, &behind, &Cause::Time)? else { return Ok(false) };
        let gained = self.take(&passage, (&front, &behind), state);
        if state.len() > states {
            state[states] += gained;
            state[states + 2] += gained.abs();
        }
        Ok(true)
    }

    /// Lets velocities jump where T jumps because relations changed, borders were crossed or events
    /// happened; `front` is the moment before, and `state` the state after.
    ///
    /// # Errors
    /// [`StopCause::InertiaJumps`] if sensitivities are carried, [`StopCause::InertiaByVelocity`]
    /// if the guard reads velocities.
    pub(crate) fn pass_inertia(
        &self,
        watch: &Watch<'_>,
        front: &Moment,
        state: &mut [f64],
    ) -> Result<Impulses, Stopped> {
        let mut impulses = Impulses::default();
        let record = watch.record();
        if self.simulator().shape().coordinates == 0 {
            return Ok(impulses);
        }
        if record.applied.is_empty() {
            self.pass_kinks((watch, &record.passed), front, state, &mut impulses)?;
        } else {
            self.pass_at_events(front, &record.applied, state, &mut impulses)?;
        }
        if impulses.has_moved {
            let states = (&front.state[..], &*state);
            watch.settle_after_impulses(front.time, states, &impulses.thrown_back)?;
        }
        Ok(impulses)
    }

    /// Passes the surfaces of kinks, one after another.
    fn pass_kinks(
        &self,
        (watch, passed): (&Watch<'_>, &[usize]),
        front: &Moment,
        state: &mut [f64],
        impulses: &mut Impulses,
    ) -> Result<(), Stopped> {
        let slots = self.held().slots();
        let kinks = passed.iter().filter_map(|index| Some((*index, watch.kink_of(*index)?.0)));
        let kinks: Vec<(usize, usize)> = kinks.collect();
        if kinks.is_empty() {
            return Ok(());
        }
        self.held().set_all(&front.slots);
        for (position, &(index, kink)) in kinks.iter().enumerate() {
            let before = self.held().slots();
            let is_last = position + 1 == kinks.len();
            if is_last {
                self.held().set_all(&slots);
            } else if kink < slots.len() {
                self.held().set(kink, slots[kink]);
            }
            let room = watch.rounding_of(index);
            if self.pass_at(kink, (front.time, room), &before, state, impulses)? {
                impulses.thrown_back.push(index);
            }
        }
        Ok(())
    }

    /// Passes the surface of one kink, whose relation has changed from the slots before it. Returns
    /// true if the motion is thrown back.
    fn pass_at(
        &self,
        kink: usize,
        (time, room): (f64, f64),
        before: &[f64],
        state: &mut [f64],
        impulses: &mut Impulses,
    ) -> Result<bool, Stopped> {
        let states = self.states();
        let is_border = kink >= before.len();
        if is_border && !self.simulator().inertia_has_corners() {
            return Ok(false);
        }
        let [front, behind] = [-1.0, 1.0].map(|side| {
            let slots = if side < 0.0 { before.to_vec() } else { self.held().slots() };
            let (time, state) = if is_border {
                self.beside(kink, (time, &state[..states]), side * room)
            } else {
                (time, state[..states].to_vec())
            };
            Moment { time, state, slots }
        });
        if !self.inertia_differs(&front, &behind) {
            return Ok(false);
        }
        let Some(cause) = self.cause(kink, &behind) else {
            // T reads no velocities through a table: the border is another law's.
            return if is_border {
                Ok(false)
            } else {
                Err(Stopped { time, cause: StopCause::InertiaByVelocity })
            };
        };
        let Some(passage) = self.pass(&front, &behind, &cause)? else { return Ok(false) };
        let to = if passage.is_thrown_back { &front } else { &behind };
        self.held().set_all(&to.slots);
        state[..states].copy_from_slice(&to.state);
        impulses.supplied += self.take(&passage, (&front, to), state);
        impulses.has_moved = true;
        Ok(passage.is_thrown_back)
    }

    /// Keeps the momentum of velocities that events do not set.
    fn pass_at_events(
        &self,
        front: &Moment,
        applied: &[usize],
        state: &mut [f64],
        impulses: &mut Impulses,
    ) -> Result<(), Stopped> {
        let simulator = self.simulator();
        let velocities = self.velocities();
        let behind = self.moment(front.time, state);
        // The jump of T alone: at the same positions and velocities.
        let mut front = front.clone();
        for (entry, value) in front.state.iter_mut().enumerate() {
            if !simulator.is_mode(entry) {
                *value = state[entry];
            }
        }
        if !self.inertia_differs(&front, &behind) {
            return Ok(());
        }
        let is_set = |entry: usize| {
            let mut sets = applied.iter().flat_map(|index| simulator.event(*index).sets);
            sets.any(|set| *set as usize == entry)
        };
        let free: Vec<bool> = velocities.map(|entry| !is_set(entry)).collect();
        if let Some(passage) = self.pass(&front, &behind, &Cause::Events(&free))? {
            self.take(&passage, (&front, &behind), state);
            impulses.has_moved = true;
        }
        Ok(())
    }

    /// Returns time and state at which a guard is a distance behind zero, along the motion.
    fn beside(&self, kink: usize, (time, state): (f64, &[f64]), distance: f64) -> (f64, Vec<f64>) {
        let (guard, rate) =
            (self.kink_guards(time, state)[kink], self.kink_rates(time, state)[kink]);
        let by = (distance * rate.signum() - guard) / rate;
        if !by.is_finite() {
            return (time, state.to_vec());
        }
        let mut along = vec![0.0; state.len()];
        self.state_rate(time, state, &mut along);
        let positions = self.simulator().shape().positions;
        let mut there = state.to_vec();
        for (value, rate) in there[..positions].iter_mut().zip(&along) {
            *value += by * rate;
        }
        (time + by, there)
    }

    /// Returns what causes a jump of T at the zero of a guard; `None` if the guard reads
    /// velocities.
    fn cause(&self, kink: usize, at: &Moment) -> Option<Cause<'_>> {
        let (simulator, time) = (self.simulator(), at.time);
        let guard = |state: &[f64]| self.kink_guards(time, state)[kink].to_bits();
        let here = guard(&at.state);
        let reads = |mut entries: std::ops::Range<usize>| {
            entries.any(|entry| {
                let mut shifted = at.state.clone();
                shifted[entry] += simulator.state_scale(entry).max(shifted[entry].abs());
                !simulator.is_mode(entry) && guard(&shifted) != here
            })
        };
        let velocities = self.velocities();
        let reads_positions = reads(0..velocities.start);
        if reads(velocities.clone()) || reads_positions && reads(velocities.end..self.states()) {
            return None;
        }
        if !reads_positions {
            return Some(Cause::Time);
        }
        // g' = g_t + g_q v, so differences are exact.
        let rate = |state: &[f64]| self.kink_rates(time, state)[kink];
        let mut state = at.state.clone();
        state[velocities.clone()].fill(0.0);
        let at_rest = rate(&state);
        let gradient = velocities.map(|entry| {
            let by = simulator.state_scale(entry).max(at.state[entry].abs());
            let [ahead, behind] = [by, -by].map(|by| {
                state[entry] = by;
                rate(&state)
            });
            state[entry] = 0.0;
            (ahead - behind) / (2.0 * by)
        });
        Some(Cause::Place(gradient.collect(), at_rest))
    }

    /// Returns the velocities behind a jump of T, or `None` if momentum does not jump.
    fn pass(
        &self,
        front: &Moment,
        behind: &Moment,
        cause: &Cause<'_>,
    ) -> Result<Option<Passage>, Stopped> {
        /// Momenta that differ by rounding do not jump.
        const ROUNDINGS: f64 = 1e3;
        let [before, after] = [front, behind].map(|moment| self.momentum(moment));
        let size = before.iter().chain(&after).fold(0.0, |most: f64, p| most.max(p.abs()));
        let lost: Vec<f64> = before.iter().zip(&after).map(|(a, b)| a - b).collect();
        if lost.iter().all(|lost| lost.abs() <= ROUNDINGS * f64::EPSILON * size) {
            return Ok(None);
        }
        if self.tangents().is_some() {
            return Err(Stopped { time: behind.time, cause: StopCause::InertiaJumps });
        }
        let [front, behind] = [front, behind].map(|moment| {
            let mut moment = moment.clone();
            self.open_frictions(&mut moment.state);
            moment
        });
        let (front, behind) = (&front, &behind);
        let start = &front.state[self.velocities()];
        let all = vec![true; start.len()];
        let free = if let Cause::Events(free) = cause { free } else { &all[..] };
        let Some(moved) = self.by_impulse(behind, &lost, free) else { return Ok(None) };
        let by_momentum: Vec<f64> = start.iter().zip(&moved).map(|(v, by)| v + by).collect();
        let Cause::Place(gradient, at_rest) = cause else {
            return Ok(Some(Passage { velocities: by_momentum, is_thrown_back: false }));
        };
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let Some(along) = self.by_impulse(behind, gradient, &all) else { return Ok(None) };
        let [speed, first] = [start, &by_momentum].map(|v| at_rest + dot(gradient, v));
        let yields = dot(gradient, &along);
        let missing = self.hamiltonian(behind, &by_momentum) - self.hamiltonian(front, start);
        let left = first * first - 2.0 * yields * missing;
        let add = |start: &[f64], factor: f64, along: &[f64]| {
            start.iter().zip(along).map(|(v, w)| v + factor * w).collect::<Vec<f64>>()
        };
        if left > 0.0 {
            let impulse = (speed.signum() * left.sqrt() - first) / yields;
            let velocities = add(&by_momentum, impulse, &along);
            return Ok(Some(Passage { velocities, is_thrown_back: false }));
        }
        let Some(along) = self.by_impulse(front, gradient, &all) else { return Ok(None) };
        let velocities = add(start, -2.0 * speed / dot(gradient, &along), &along);
        Ok(Some(Passage { velocities, is_thrown_back: true }))
    }

    /// Opens dry frictions, whose finite forces send no impulse: they begin anew behind it.
    fn open_frictions(&self, state: &mut [f64]) {
        let simulator = self.simulator();
        for row in 0..simulator.constraints() {
            if let Some(mode) = simulator.constraint(row).friction {
                state[mode as usize] = Constraint::OPEN;
            }
        }
    }

    /// Gives a state the velocities of a passage, and returns the kinetic energy gained.
    fn take(&self, passage: &Passage, (front, to): (&Moment, &Moment), state: &mut [f64]) -> f64 {
        let velocities = self.velocities();
        let gained = self.kinetic(to, &passage.velocities)
            - self.kinetic(front, &front.state[velocities.clone()]);
        state[velocities].copy_from_slice(&passage.velocities);
        self.open_frictions(state);
        gained
    }

    /// Accounts for the energy of impulses, and for what is lost besides where the potential
    /// energy jumps or events happen.
    pub(crate) fn account(&self, front: &Moment, supplied: f64, state: &mut [f64]) {
        let states = self.states();
        if state.len() == states {
            return;
        }
        let energy = |state: &[f64], parameters: &[f64]| {
            self.simulator().energy(front.time, state, parameters).total()
        };
        let before = energy(&front.state, &self.parameters_at(front));
        let lost = before + supplied - energy(&state[..states], &self.held().all());
        state[states] += supplied;
        state[states + 1] += lost;
        state[states + 2] += lost.abs() + supplied.abs();
    }

    /// Returns the entries of the velocities.
    fn velocities(&self) -> std::ops::Range<usize> {
        let shape = self.simulator().shape();
        shape.positions..shape.positions + shape.coordinates
    }

    /// Returns true if T is not the same function of velocities at two moments. Only equal bits are
    /// the same.
    fn inertia_differs(&self, front: &Moment, behind: &Moment) -> bool {
        let simulator = self.simulator();
        let velocities = self.velocities();
        let probe: Vec<f64> = velocities
            .clone()
            .map(|entry| simulator.state_scale(entry) * (entry as f64).cos())
            .collect();
        let rest = vec![0.0; probe.len()];
        let of = |moment: &Moment| {
            let mut values = vec![0.0; simulator.mass_matrix_pattern().entries.len()];
            let all = self.parameters_at(moment);
            simulator.mass_matrix(moment.time, &moment.state, &all, &mut values);
            values.extend([&probe, &rest].map(|v| self.kinetic(moment, v)));
            values
        };
        of(front) != of(behind)
    }

    fn parameters_at(&self, moment: &Moment) -> Vec<f64> {
        self.parameters().iter().chain(&moment.slots).copied().collect()
    }

    /// Returns T at a moment with other velocities.
    fn kinetic(&self, moment: &Moment, velocities: &[f64]) -> f64 {
        let mut state = moment.state.clone();
        state[self.velocities()].copy_from_slice(velocities);
        self.simulator().energy(moment.time, &state, &self.parameters_at(moment)).kinetic
    }

    /// Returns v^T p - T, the part of T that is quadratic in velocities less the constant one.
    fn hamiltonian(&self, moment: &Moment, velocities: &[f64]) -> f64 {
        let opposite: Vec<f64> = velocities.iter().map(|v| -v).collect();
        let [ahead, behind] = [velocities, &opposite].map(|v| self.kinetic(moment, v));
        0.5 * (ahead + behind) - 2.0 * self.kinetic(moment, &vec![0.0; velocities.len()])
    }

    /// Returns dT/dv at a moment. T is quadratic in velocities, so central differences are exact.
    fn momentum(&self, moment: &Moment) -> Vec<f64> {
        let velocities = self.velocities();
        let mut shifted = moment.state[velocities.clone()].to_vec();
        (0..shifted.len())
            .map(|index| {
                let (value, scale) =
                    (shifted[index], self.simulator().state_scale(velocities.start + index));
                let by = scale.max(value.abs());
                let [ahead, behind] = [by, -by].map(|by| {
                    shifted[index] = value + by;
                    self.kinetic(moment, &shifted)
                });
                shifted[index] = value;
                (ahead - behind) / (2.0 * by)
            })
            .collect()
    }

    /// Returns the change of the free velocities by an impulse, with that of the constraints; `None`
    /// if M is singular.
    fn by_impulse(&self, moment: &Moment, impulse: &[f64], free: &[bool]) -> Option<Vec<f64>> {
        let (simulator, n) = (self.simulator(), impulse.len());
        let held = self.held().slots();
        self.held().set_all(&moment.slots);
        let mut system = if let Some(constraints) = self.constraints() {
            let matrix = constraints.matrix(moment.time, &moment.state);
            constraints.saddle(moment.time, &moment.state, &matrix)
        } else {
            let pattern = simulator.mass_matrix_pattern();
            let mut values = vec![0.0; pattern.entries.len()];
            let all = self.parameters_at(moment);
            simulator.mass_matrix(moment.time, &moment.state, &all, &mut values);
            dense(pattern, &values)
        };
        self.held().set_all(&held);
        let mut right_side = DVector::zeros(system.nrows());
        right_side.rows_mut(0, n).copy_from_slice(impulse);
        for index in (0..n).filter(|index| !free[*index]) {
            system.row_mut(index).fill(0.0);
            system.column_mut(index).fill(0.0);
            system[(index, index)] = 1.0;
            right_side[index] = 0.0;
        }
        let solution = system.lu().solve(&right_side)?;
        let moved = solution.rows(0, n);
        moved.iter().all(|value| value.is_finite()).then(|| moved.iter().copied().collect())
    }
}
