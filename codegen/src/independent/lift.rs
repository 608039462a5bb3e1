//! Map from the state of a simulator, which lacks the states its outputs do not need, to a place
//! of the whole system.
//!
//! ```text
//! u = B q        u' = B q'       positions of the state, and of the system
//! ```
//!
//! B is computed from the simulator: its rates of positions are linear in velocities. Missing
//! states are random, because nothing that is left may depend on them. A position that was left
//! out although it matters then shows as a difference.

use machinist_algebra::expr::Expr;
use machinist_contract::{Real, Simulator, StateKind};

use super::compare::{At, Unlike};
use super::formula::Formula;
use super::motion::{Machine, Place};
use super::random::Random;
use super::solve::inverse;
use crate::scene::system::{FirstOrderState, LagrangianSystem};

/// Distance of missing states from their initial values, relative to their scale.
const ASIDE: f64 = 0.25;

/// Places of the entries of a simulator's state in a system, found by name.
#[derive(Debug, Clone)]
pub struct Entries {
    /// Entries that are positions.
    pub positions: Vec<usize>,
    /// (entry, coordinate) of velocities.
    pub velocities: Vec<(usize, usize)>,
    /// (entry, state) of first-order states.
    pub first_order: Vec<(usize, usize)>,
    /// Parameter of the system for each of the simulator's.
    pub parameters: Vec<usize>,
}

impl Entries {
    /// Finds the places by name.
    ///
    /// # Errors
    /// The first entry or parameter that the system does not have.
    pub fn new(system: &LagrangianSystem, simulator: &dyn Simulator<f64>) -> Result<Self, Unlike> {
        let unlike = |name: &str| Unlike(name.to_owned());
        let mut entries = Entries {
            positions: Vec::new(),
            velocities: Vec::new(),
            first_order: Vec::new(),
            parameters: Vec::new(),
        };
        for entry in 0..simulator.shape().states() {
            let name = simulator.state(entry).name;
            match simulator.state_kind(entry) {
                StateKind::Position => entries.positions.push(entry),
                StateKind::Velocity => {
                    let mut all = system.coordinates.iter();
                    let found = all.position(|q| q.velocity.name.path == name);
                    entries.velocities.push((entry, found.ok_or_else(|| unlike(name))?));
                }
                StateKind::FirstOrder => {
                    let mut all = system.first_order.iter();
                    let found = all.position(|z| z.quantity.name.path == name);
                    entries.first_order.push((entry, found.ok_or_else(|| unlike(name))?));
                }
            }
        }
        for index in 0..simulator.shape().parameters {
            let name = simulator.parameter(index).name;
            let mut all = system.parameters.iter();
            let found = all.position(|p| p.quantity.name.path == name);
            entries.parameters.push(found.ok_or_else(|| unlike(name))?);
        }
        Ok(entries)
    }

    /// Returns the parameters of the system, with those of a simulator in their places.
    pub fn parameters<R: Real>(&self, system: &LagrangianSystem, given: &[f64]) -> Vec<R> {
        let own = system.parameters.iter().map(|parameter| R::literal(parameter.value));
        let mut all: Vec<R> = own.collect();
        for (place, value) in self.parameters.iter().zip(given) {
            all[*place] = R::literal(*value);
        }
        all
    }

    /// Returns B, a row for each position, a column for each coordinate.
    pub fn positions_by_coordinates(
        &self,
        simulator: &dyn Simulator<f64>,
        at: &At<'_>,
        coordinates: usize,
    ) -> Vec<Vec<f64>> {
        let mut state = at.state.to_vec();
        for (entry, _) in &self.velocities {
            state[*entry] = 0.0;
        }
        let rates = |state: &[f64]| {
            let mut rate = vec![0.0; state.len()];
            simulator.rate(at.time, state, at.parameters, &mut rate);
            rate
        };
        let rest = rates(&state);
        let mut rows = vec![vec![0.0; coordinates]; self.positions.len()];
        for (entry, coordinate) in &self.velocities {
            state[*entry] = 1.0;
            let moved = rates(&state);
            state[*entry] = 0.0;
            for (row, position) in rows.iter_mut().zip(&self.positions) {
                row[*coordinate] = moved[*position] - rest[*position];
            }
        }
        rows
    }

    /// Returns a place of the system at which a simulator's state is as given; `None` if there is
    /// none.
    pub fn place<R: Real>(
        &self,
        system: &LagrangianSystem,
        machine: &Machine<R>,
        at: &At<'_>,
        by_coordinates: &[Vec<f64>],
        random: &mut Random,
    ) -> Option<Place<R>> {
        let mut place = Place::of_parameters(self.parameters(system, at.parameters));
        let mut aside = |start: &Expr, scale: f64| {
            let start = machine.value(&Formula::new(start), &place, None).value;
            start + R::literal(ASIDE * scale * random.signed())
        };
        let coordinates = &system.coordinates;
        let q = coordinates.iter().map(|q| aside(&q.initial[0], q.scale[0])).collect();
        let v = coordinates.iter().map(|q| aside(&q.initial[1], q.scale[1])).collect();
        let states = system.first_order.iter();
        let scale = |z: &FirstOrderState| if z.is_mode { 0.0 } else { 0.1 * z.scale };
        let z = states.map(|z| aside(&z.initial, scale(z))).collect();
        place = Place { time: R::literal(at.time), q, v, z, ..place };
        for (entry, state) in &self.first_order {
            place.z[*state] = R::literal(at.state[*entry]);
        }
        if !system.orientations.is_empty() {
            // Nothing is left out of a state with quaternions.
            place.q = self.positions.iter().map(|entry| R::literal(at.state[*entry])).collect();
            for (entry, coordinate) in &self.velocities {
                place.v[*coordinate] = R::literal(at.state[*entry]);
            }
            return Some(place);
        }
        let normals = machine.normals(&place)?;
        let zero = R::literal(0.0);
        let number = |row: &[f64]| row.iter().map(|entry| R::literal(*entry)).collect::<Vec<R>>();
        let positions = by_coordinates.iter().zip(&self.positions);
        let mut rows: Vec<(Vec<R>, R)> =
            positions.map(|(row, entry)| (number(row), R::literal(at.state[*entry]))).collect();
        rows.extend(normals.iter().map(|normal| (normal.clone(), zero)));
        put_on(&mut place.q, &rows, machine.to_f64)?;
        let velocities = self.velocities.iter().map(|(entry, coordinate)| {
            let unit = (0..coordinates.len()).map(|k| if k == *coordinate { 1.0 } else { 0.0 });
            (number(&unit.collect::<Vec<f64>>()), R::literal(at.state[*entry]))
        });
        let mut rows: Vec<(Vec<R>, R)> = velocities.collect();
        rows.extend(normals.into_iter().map(|normal| (normal, zero)));
        put_on(&mut place.v, &rows, machine.to_f64)?;
        Some(place)
    }
}

/// Changes x as little as possible so that each row times x has its given value. Rows that set a
/// single entry set it exactly.
fn put_on<R: Real>(x: &mut [R], rows: &[(Vec<R>, R)], to_f64: fn(R) -> f64) -> Option<()> {
    let is_given = |row: &[R]| {
        let mut nonzero = row.iter().enumerate().filter(|(_, entry)| to_f64(**entry) != 0.0);
        match (nonzero.next(), nonzero.next()) {
            (Some((k, entry)), None) if to_f64(*entry).to_bits() == 1.0_f64.to_bits() => Some(k),
            _ => None,
        }
    };
    let mut is_free = vec![true; x.len()];
    let mut others = Vec::new();
    for (row, value) in rows {
        match is_given(row) {
            Some(k) if is_free[k] => (x[k], is_free[k]) = (*value, false),
            _ => others.push((row, *value)),
        }
    }
    let zero = R::literal(0.0);
    let product = |row: &[R], x: &[R]| row.iter().zip(x).fold(zero, |sum, (a, b)| sum + *a * *b);
    let free: Vec<Vec<R>> = others
        .iter()
        .map(|(row, _)| {
            let entries = row.iter().zip(&is_free);
            entries.map(|(entry, is_free)| if *is_free { *entry } else { zero }).collect()
        })
        .collect();
    if others.is_empty() {
        return Some(());
    }
    let gram = free.iter().map(|a| free.iter().map(|b| product(a, b)).collect()).collect();
    let inverse = inverse(gram, to_f64)?;
    let missing: Vec<R> = others.iter().map(|(row, value)| *value - product(row, x)).collect();
    for (row, inverse) in free.iter().zip(&inverse) {
        let step = product(inverse, &missing);
        for (x, entry) in x.iter_mut().zip(row) {
            *x = *x + step * *entry;
        }
    }
    Some(())
}
