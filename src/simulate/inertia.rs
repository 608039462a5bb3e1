//! Starts at which inertia is negative, or coordinates move together without any, or nearly so.

use nalgebra::{DMatrix, DVector};

use super::Simulation;
use crate::constraints::Constraints;
use crate::dense::dense;
use crate::error::SimulateError;
use crate::method::System;

/// Number of coordinates up to which the mass matrix is examined.
const WHOLE: usize = 64;

/// A motion whose inertia is a small share of those of its coordinates alone.
struct Weakest {
    share: f64,
    coordinates: Vec<String>,
}

impl Simulation<'_> {
    /// Refuses a start at which coordinates move together without inertia: no equation determines their
    /// accelerations.
    pub(super) fn require_inertia(&self, state: &[f64]) -> Result<(), SimulateError> {
        match self.weakest(state, self.rounding()) {
            Some(Weakest { coordinates, .. }) => Err(SimulateError::SingularInertia {
                scene: self.simulator.name().to_owned(),
                coordinates: together(&coordinates),
            }),
            None => Ok(()),
        }
    }

    /// Adds a note if rounding changes accelerations at the start by more than the tolerance, because
    /// coordinates move together with little inertia.
    pub(super) fn note_little_inertia(&self, system: &System<'_>, state: &[f64]) {
        let weakest = self.weakest(state, f64::EPSILON / self.rtol);
        let Some(Weakest { share, coordinates }) = weakest else { return };
        let error = f64::EPSILON / share;
        system.note(format!(
            "{} little inertia at the start, {share:.0e} of what they have alone: rounding changes \
             their accelerations by a share of about {error:.0e}; give the body that they move an \
             inertia about its centre",
            together(&coordinates)
        ));
    }

    /// Returns the motion with the least inertia that constraints admit, for coordinates in units in which
    /// each alone has the inertia 1, if it has no more than a limit.
    fn weakest(&self, state: &[f64], limit: f64) -> Option<Weakest> {
        let pattern = self.simulator.mass_matrix_pattern();
        if pattern.rows > WHOLE || pattern.entries.is_empty() {
            return None;
        }
        let values = self.inertias(state);
        let mut mass = dense(pattern, &values);
        let own = mass.diagonal();
        if let Some(constraints) = Constraints::of(self.simulator, &self.parameters) {
            // What violates a constraint is stiffened by the inertias that it joins; coordinates without
            // any count as the largest.
            let largest = own.max();
            for row in constraints.matrix(self.from, state).row_iter() {
                let inertia = |own: f64| if own > 0.0 { own } else { largest };
                let mobility =
                    row.iter().zip(&own).map(|(slope, own)| slope * slope / inertia(*own));
                let mobility: f64 = mobility.sum();
                if mobility > 0.0 {
                    mass += row.transpose() * row / mobility;
                }
            }
        }
        let own = mass.diagonal();
        let is_sound = mass.iter().all(|value| value.is_finite());
        if !is_sound || own.iter().any(|own| *own <= 0.0) {
            return None;
        }
        let scaled = DMatrix::from_fn(mass.nrows(), mass.ncols(), |i, k| {
            mass[(i, k)] / (own[i].sqrt() * own[k].sqrt())
        });
        // The eigenvalues have a mean of 1, so the least is more than 1/e of their product.
        if let Some(factor) = scaled.clone().cholesky()
            && factor.determinant() > limit * std::f64::consts::E
        {
            return None;
        }
        let found = scaled.clone().symmetric_eigen();
        let (least, share) = found.eigenvalues.argmin();
        if share.abs() > limit {
            return None;
        }
        let motion = found.eigenvectors.column(least);
        // The fewest coordinates that have nearly as little inertia.
        let enough = 2.0 * share.abs().max(self.rounding());
        let mut order: Vec<usize> = (0..motion.len()).collect();
        order.sort_by(|i, k| motion[*k].abs().total_cmp(&motion[*i].abs()));
        let mut part = DVector::zeros(motion.len());
        let needed = order.iter().position(|at| {
            part[*at] = motion[*at];
            part.dot(&(&scaled * &part)) <= enough * part.norm_squared()
        });
        order.truncate(needed.map_or(order.len(), |last| last + 1));
        order.sort_unstable();
        let name = |at: usize| self.simulator.coordinate(at).name.to_owned();
        Some(Weakest { share, coordinates: order.into_iter().map(name).collect() })
    }

    /// Returns a note if forces move a coordinate or some motion the other way.
    pub(super) fn negative_inertia_at(&self, state: &[f64]) -> Option<String> {
        const ROUNDING: f64 = 1e-9;
        let pattern = self.simulator.mass_matrix_pattern();
        let values = self.inertias(state);
        let mut entries = pattern.entries.iter().zip(&values);
        if let Some(((row, _), value)) = entries.find(|((row, c), v)| row == c && **v < 0.0) {
            let name = self.simulator.coordinate(*row as usize).name;
            return Some(format!(
                "the inertia of `{name}` is negative at the start, {value:.3e}: forces move it the \
                 other way; look for a parameter of the wrong sign"
            ));
        }
        let is_looked_at = pattern.rows <= WHOLE && self.simulator.constraints() == 0;
        if !is_looked_at || values.iter().any(|value| !value.is_finite()) || values.is_empty() {
            return None;
        }
        let mass = dense(pattern, &values);
        if mass.clone().cholesky().is_some() {
            return None;
        }
        let inertias = mass.symmetric_eigenvalues();
        (inertias.min() < -ROUNDING * inertias.max()).then(|| {
            "some motion has a negative kinetic energy at the start: forces move it the other way; \
             look for a parameter of the wrong sign"
                .to_owned()
        })
    }

    /// Returns the entries of the mass matrix at the start.
    fn inertias(&self, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.simulator.mass_matrix_pattern().entries.len()];
        self.simulator.mass_matrix(self.from, state, &self.parameters, &mut values);
        values
    }

    /// Returns the share of inertia that is zero but for rounding.
    fn rounding(&self) -> f64 {
        self.simulator.shape().coordinates as f64 * f64::EPSILON
    }
}

/// Returns the beginning of a sentence on coordinates.
fn together(coordinates: &[String]) -> String {
    const SHOWN: usize = 6;
    let names: Vec<String> =
        coordinates.iter().take(SHOWN).map(|name| format!("`{name}`")).collect();
    let more = if coordinates.len() > SHOWN { ", ..." } else { "" };
    let names = names.join(", ");
    if coordinates.len() == 1 {
        format!("coordinate {names} moves with")
    } else {
        format!("coordinates {names}{more} move together with")
    }
}
