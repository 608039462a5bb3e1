//! Linear equations of states and waves together, while relations and modes are held:
//!
//! ```text
//! z' = A z,    z = [y, w],    w = s^j e^(g s) (cos w s, sin w s)
//! ```

use std::rc::Rc;

use machinist_contract::linear::LinearEquations;
use nalgebra::{Complex, DMatrix};

use super::piece::Piece;
use super::rows::{Kind, Row, along_surfaces};
use crate::dense::balance;
use crate::method::Stretch;
use crate::method::one_step::Bounded;
use crate::method::sliding::Slide;

/// Maximum number of states and waves.
const MOST_ROWS: usize = 600;
/// Maximum number of equations that are kept.
const KEPT: usize = 256;

/// Nonzero slopes by unknowns.
type Slopes = Vec<(usize, f64)>;

/// Values that determine the equations.
#[derive(Debug, Clone, PartialEq)]
struct Signature {
    /// Slots of relations, then modes.
    held: Vec<f64>,
    slides: Vec<Slide>,
}

impl Signature {
    fn of(stretch: &Stretch<'_>, state: &[f64]) -> Self {
        let mut held = stretch.system.held().slots();
        held.extend(modes(stretch, state));
        Self { held, slides: stretch.system.slides() }
    }

    /// Returns whether it is that of a state.
    fn is_of(&self, stretch: &Stretch<'_>, state: &[f64]) -> bool {
        let system = stretch.system;
        let slots = (0..system.simulator().relations()).map(|index| system.held().slot(index));
        let held = slots.chain(modes(stretch, state)).map(f64::to_bits);
        held.eq(self.held.iter().copied().map(f64::to_bits)) && system.slides_along(&self.slides)
    }
}

/// Iterates over the modes of a state.
fn modes<'s>(stretch: &'s Stretch<'_>, state: &'s [f64]) -> impl Iterator<Item = f64> + 's {
    let entries = state.iter().enumerate().take(stretch.system.states());
    entries.filter(|(entry, _)| stretch.system.simulator().is_mode(*entry)).map(|(_, value)| *value)
}

/// Equations kept for the modes of a run.
#[derive(Debug, Clone, Default)]
pub(in crate::method) struct Known(Vec<Rc<Equations>>);

/// A wave, and the place of its lowest power among the unknowns.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// With the highest power.
    kind: Kind,
    first: usize,
}

impl Place {
    /// Returns the number of unknowns for each power.
    fn parts(&self) -> usize {
        if self.kind.mu.im == 0.0 { 1 } else { 2 }
    }
}

/// Linear equations of states and waves.
#[derive(Debug)]
pub(super) struct Equations {
    signature: Signature,
    /// Span of time in which they hold \[s\].
    from: f64,
    pub(super) until: f64,
    places: Vec<Place>,
    /// Nonzeros of A, row after row.
    matrix: Vec<Vec<(usize, f64)>>,
    /// Slopes of guards of events, then of kinks, by z.
    guards: Vec<Slopes>,
    /// Relations along whose surfaces the motion slides, with the slopes of their shares.
    shares: Vec<(usize, Slopes)>,
    /// Norm of the balanced A \[1/s\].
    pub(super) norm: f64,
}

/// Reason why equations are not known in closed form.
pub(in crate::method) enum Refusal {
    /// The motion along surfaces is not linear.
    Surface,
    /// Another reason.
    Reason(String),
}

impl Equations {
    /// Returns the equations for relations and modes as they are held at a time and state.
    ///
    /// # Errors
    /// [`Refusal`] if they are not linear, too many, or not accurate.
    pub(super) fn at(
        stretch: &Stretch<'_>,
        linear: &dyn LinearEquations<f64>,
        time: f64,
        state: &[f64],
    ) -> Result<Rc<Self>, Refusal> {
        let signature = Signature::of(stretch, state);
        let known = stretch.system.closed_forms().borrow();
        let is_it = |it: &&Rc<Self>| {
            it.signature == signature && it.from <= time && is_before(time, it.until)
        };
        if let Some(found) = known.0.iter().find(is_it) {
            return Ok(Rc::clone(found));
        }
        drop(known);
        let made = Rc::new(Self::new(stretch, linear, signature, (time, state))?);
        let known = &mut stretch.system.closed_forms().borrow_mut().0;
        if known.len() == KEPT {
            known.clear();
        }
        known.push(Rc::clone(&made));
        Ok(made)
    }

    /// Returns whether relations and modes are held as in these equations.
    pub(super) fn are_for(&self, stretch: &Stretch<'_>, time: f64, state: &[f64]) -> bool {
        is_before(time, self.until) && self.signature.is_of(stretch, state)
    }

    fn new(
        stretch: &Stretch<'_>,
        linear: &dyn LinearEquations<f64>,
        signature: Signature,
        (time, state): (f64, &[f64]),
    ) -> Result<Self, Refusal> {
        let system = stretch.system;
        system.count(|work| work.factorizations += 1);
        let rest = Stretch { from: time, ..*stretch };
        let switch = next_switch(stretch, linear, time);
        let until = switch.min(stretch.until);
        let piece = |stretch: &Stretch<'_>| {
            let piece = Piece::new(stretch, linear, (time, until), state);
            piece.map(|piece| (piece.rows(), piece.is_of_powers())).map_err(Refusal::Reason)
        };
        let (mut rows, is_of_powers) = piece(&rest)?;
        let states = system.states();
        let guards = rows.split_off(states);
        let slides = &signature.slides;
        let mut shares = Vec::new();
        if !slides.is_empty() {
            let mut above = Vec::new();
            for slide in slides {
                system.held().set(slide.relation, slide.sides.above);
                let made = piece(&rest);
                system.held().set(slide.relation, slide.sides.below);
                let mut rates = made?.0;
                rates.truncate(states);
                above.push(rates);
            }
            let kinks = &guards[system.simulator().events()..];
            let along = along_surfaces(slides, rows, &above, kinks).ok_or(Refusal::Surface)?;
            (rows, shares) = (along.rates, along.shares);
        }
        let (places, size) = places(states, rows.iter().chain(&guards).chain(&shares));
        if size > MOST_ROWS {
            return Err(Refusal::Reason(format!(
                "{size} states and waves are too many for a closed form between switches (at \
                 most {MOST_ROWS}); try the method `auto`"
            )));
        }
        let on_unknowns = |row: &Row| on_unknowns(&places, row);
        let mut matrix: Vec<_> = rows.iter().map(on_unknowns).collect();
        for place in &places {
            matrix.extend(waves_of(place));
        }
        let norm = balanced_norm(&matrix);
        if !norm.is_finite() {
            let reason = "a coefficient of its equations is not finite".to_owned();
            return Err(Refusal::Reason(reason));
        }
        let shares = slides.iter().zip(&shares);
        Ok(Self {
            from: time,
            // Powers of time are accurate within the span for which they were judged.
            until: if is_of_powers { until } else { switch },
            matrix,
            guards: guards.iter().map(on_unknowns).collect(),
            shares: shares.map(|(slide, row)| (slide.relation, on_unknowns(row))).collect(),
            norm,
            places,
            signature,
        })
    }

    /// Returns the number of unknowns.
    pub(super) fn size(&self) -> usize {
        self.matrix.len()
    }

    /// Computes the waves at a time.
    pub(super) fn waves(&self, time: f64, unknowns: &mut [f64]) {
        for place in &self.places {
            let since = time - place.kind.origin;
            let mut value = (place.kind.mu * since).exp();
            let parts = place.parts();
            for power in 0..=place.kind.power as usize {
                let first = place.first + parts * power;
                unknowns[first] = value.re;
                if parts == 2 {
                    unknowns[first + 1] = value.im;
                }
                value *= since;
            }
        }
    }

    /// Computes factor A z.
    pub(super) fn apply(&self, factor: f64, unknowns: &[f64], into: &mut [f64]) {
        for (into, row) in into.iter_mut().zip(&self.matrix) {
            *into = factor * product(row, unknowns);
        }
    }

    /// Returns the slopes of a function by z; `None` if it is constant.
    pub(super) fn slopes(&self, of: Bounded) -> Option<&[(usize, f64)]> {
        match of {
            Bounded::Guard(index) => Some(&self.guards[index]),
            Bounded::Share(relation) => {
                let found = self.shares.iter().find(|(known, _)| *known == relation);
                found.map(|(_, slopes)| &slopes[..])
            }
        }
    }
}

/// Returns the product of a row with z.
pub(super) fn product(row: &[(usize, f64)], unknowns: &[f64]) -> f64 {
    row.iter().map(|(entry, slope)| slope * unknowns[*entry]).sum()
}

/// Returns the first time after this one at which the excitation switches.
fn next_switch(stretch: &Stretch<'_>, linear: &dyn LinearEquations<f64>, time: f64) -> f64 {
    let mut times = vec![0.0; linear.switches()];
    linear.switch_times(stretch.system.parameters(), &mut times);
    let later = times.into_iter().filter(|switch| is_before(time, *switch));
    later.fold(f64::INFINITY, f64::min)
}

/// Returns whether a time is before another one by more than rounding.
fn is_before(time: f64, end: f64) -> bool {
    const ROUNDINGS: f64 = 4.0;
    end - time > ROUNDINGS * f64::EPSILON * time.abs()
}

/// Returns the places of all waves behind the states, and the number of all unknowns.
fn places<'a>(states: usize, rows: impl Iterator<Item = &'a Row>) -> (Vec<Place>, usize) {
    let mut places: Vec<Place> = Vec::new();
    for (kind, _) in rows.flat_map(|row| &row.waves) {
        let is_it =
            |place: &&mut Place| (place.kind.origin, place.kind.mu) == (kind.origin, kind.mu);
        match places.iter_mut().find(is_it) {
            Some(place) => place.kind.power = place.kind.power.max(kind.power),
            None => places.push(Place { kind: *kind, first: 0 }),
        }
    }
    let mut size = states;
    for place in &mut places {
        place.first = size;
        size += place.parts() * (place.kind.power as usize + 1);
    }
    (places, size)
}

/// Returns a row by states and waves.
fn on_unknowns(places: &[Place], row: &Row) -> Vec<(usize, f64)> {
    let mut slopes: Vec<(usize, f64)> = row.slopes.clone();
    for (kind, amplitude) in &row.waves {
        let is_it = |place: &&Place| (place.kind.origin, place.kind.mu) == (kind.origin, kind.mu);
        let Some(place) = places.iter().find(is_it) else { continue };
        let first = place.first + place.parts() * kind.power as usize;
        slopes.push((first, amplitude.re));
        if place.parts() == 2 {
            // The real part of (re + i im) (cosine + i sine).
            slopes.push((first + 1, -amplitude.im));
        }
    }
    slopes.retain(|(_, slope)| *slope != 0.0);
    slopes
}

/// Returns the rows of A for the powers of a wave: w_j' = mu w_j + j w_(j-1).
fn waves_of(place: &Place) -> Vec<Vec<(usize, f64)>> {
    let (parts, Complex { re: growth, im: frequency }) = (place.parts(), place.kind.mu);
    let mut rows = Vec::new();
    for power in 0..=place.kind.power as usize {
        let first = place.first + parts * power;
        for part in 0..parts {
            let mut row = vec![(first + part, growth)];
            if parts == 2 {
                let (other, sign) = if part == 0 { (first + 1, -1.0) } else { (first, 1.0) };
                row.push((other, sign * frequency));
            }
            if power > 0 {
                row.push((first + part - parts, power as f64));
            }
            row.retain(|(_, value)| *value != 0.0);
            rows.push(row);
        }
    }
    rows
}

/// Returns the largest sum of a column of the balanced matrix.
fn balanced_norm(rows: &[Vec<(usize, f64)>]) -> f64 {
    let mut matrix = DMatrix::zeros(rows.len(), rows.len());
    for (row, entries) in rows.iter().enumerate() {
        for (column, value) in entries {
            matrix[(row, *column)] += value;
        }
    }
    if matrix.iter().any(|value: &f64| !value.is_finite()) {
        return f64::NAN;
    }
    balance(&mut matrix);
    matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max)
}
