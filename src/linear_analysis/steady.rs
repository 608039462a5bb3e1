//! Start in equilibrium, with modes that agree with their guards.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::search::{Balance, Crept, LeastSteps, creep, newton};
use super::{LinearError, Linearization, Point, equilibrium, full, jacobian, rest};
use crate::constraints::consistent;
use crate::error::SimulateError;

/// Minimum growth of deviations over the run, as an exponent of e, that a note reports.
const GROWS: f64 = 1.0;
/// Growth, relative to the fastest motion, below which it is rounding of repeated eigenvalues.
const ROUNDING: f64 = 1e-6;
/// Number of states up to which stability is examined: the cost of eigenvalues grows with its cube.
const MOST_STATES: usize = 300;

/// Callback that corrects modes only.
pub(crate) type Settle<'s> = dyn Fn(&mut Vec<f64>) -> Result<(), SimulateError> + 's;

/// Returns the equilibrium near a guess, as [`equilibrium()`], or downhill of it if there is none
/// nearby, in modes that no event contradicts.
///
/// Entries of the state that are `named` move only as far as the equations require. They make no
/// difference if the equations force them to move, or determine everything.
///
/// # Errors
/// [`LinearError::NoEquilibrium`], [`LinearError::NoModes`], and the errors of `settle`.
pub(crate) fn steady_start(
    simulator: &dyn Simulator<f64>,
    guess: Point,
    named: &[usize],
    settle: &Settle<'_>,
) -> Result<Point, LinearError> {
    let search = Search { simulator, named, settle };
    let mut point = guess;
    search.settled(&mut point)?;
    let mut tried = vec![search.modes(&point)];
    let mut has_crept = false;
    loop {
        let found = match search.near(&point) {
            Err(none @ LinearError::NoEquilibrium { .. }) => {
                // A creep fails if anything besides modes would have to change.
                if has_crept || search.creep(&mut point).is_err() {
                    return Err(none);
                }
                has_crept = true;
                continue;
            }
            found => found?,
        };
        let mut settled = found.clone();
        if !search.settled(&mut settled)? {
            return Ok(found);
        }
        let modes = search.modes(&settled);
        point = settled;
        // Maximum number of changes in succession at any start.
        let most = 2 * simulator.events() + 8;
        if tried.contains(&modes) || tried.len() > most {
            // Modes recur whose equilibrium contradicts them; the creep approaches it slowly.
            let none = search.no_modes(&point);
            if has_crept || search.creep(&mut point).is_err() {
                return Err(none);
            }
            has_crept = true;
            tried.clear();
        }
        tried.push(modes);
    }
}

struct Search<'s> {
    simulator: &'s dyn Simulator<f64>,
    named: &'s [usize],
    settle: &'s Settle<'s>,
}

impl Search<'_> {
    fn near(&self, guess: &Point) -> Result<Point, LinearError> {
        if self.simulator.constraints() > 0 {
            let (balance, start) = rest::Solver::new(self.simulator, guess, self.named)?;
            newton(&balance, start)
        } else {
            let (balance, start) = equilibrium::Solver::new(self.simulator, guess, self.named)?;
            newton(&balance, start)
        }
    }

    /// Lets the point creep to rest, through any modes on the way.
    fn creep(&self, point: &mut Point) -> Result<(), LinearError> {
        for _ in 0..=self.simulator.events() * 4 {
            let crept = if self.simulator.constraints() > 0 {
                let (balance, start) = rest::Solver::new(self.simulator, point, self.named)?;
                self.creep_by(&balance, start, point)?
            } else {
                let (balance, start) = equilibrium::Solver::new(self.simulator, point, self.named)?;
                self.creep_by(&balance, start, point)?
            };
            if crept != Crept::Switched {
                break;
            }
        }
        Ok(())
    }

    fn creep_by(
        &self,
        balance: &impl Balance,
        start: Point,
        point: &mut Point,
    ) -> Result<Crept, LinearError> {
        *point = start;
        creep(balance, point, &|point| self.settled(point))
    }

    /// Corrects the modes of a point and projects it onto the constraints that hold in them.
    /// Returns whether any mode changed.
    fn settled(&self, point: &mut Point) -> Result<bool, LinearError> {
        if self.simulator.events() == 0 {
            return Ok(false);
        }
        let before = self.modes(point);
        (self.settle)(&mut point.state)?;
        if before == self.modes(point) {
            return Ok(false);
        }
        let state = std::mem::take(&mut point.state);
        point.state = consistent(self.simulator, &point.parameters, point.time, state, &|_| false)?;
        Ok(true)
    }

    fn modes(&self, point: &Point) -> Vec<i64> {
        let modes = (0..point.state.len()).filter(|entry| self.simulator.is_mode(*entry));
        modes.map(|entry| point.state[entry].round() as i64).collect()
    }

    fn no_modes(&self, point: &Point) -> LinearError {
        let modes = (0..point.state.len()).filter(|entry| self.simulator.is_mode(*entry));
        let told = |entry: usize| {
            format!("`{}` = {}", self.simulator.state(entry).name, point.state[entry])
        };
        LinearError::NoModes {
            scene: self.simulator.name().to_owned(),
            modes: modes.map(told).collect::<Vec<_>>().join(", "),
        }
    }
}

/// Derivatives of an equilibrium by parameters and by its guess.
pub(crate) struct SteadyTangents {
    /// One column for each direction.
    pub(crate) state: DMatrix<f64>,
    /// True if the equations determine the state, so that the guess does not matter.
    pub(crate) is_determined: bool,
}

/// Computes moves of an equilibrium: from columns dy of `guess`, the moves with the guess, and from
/// rates df/dp,
///
/// ```text
/// F (df/dp + A (dy + T x)) = 0        F: rates as residuals, T x: moves that are allowed
/// ```
///
/// with the least x, as in a search. `onto` restores the constraints.
///
/// # Errors
/// As for [`equilibrium()`], and those of `onto`.
pub(crate) fn steady_tangents(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    named: &[usize],
    (guess, rates): (DMatrix<f64>, &DMatrix<f64>),
    onto: &dyn Fn(&mut DMatrix<f64>) -> Result<(), SimulateError>,
) -> Result<SteadyTangents, LinearError> {
    if simulator.constraints() > 0 {
        let (balance, _) = rest::Solver::new(simulator, point, named)?;
        moves(&balance, simulator, point, (guess, rates), onto)
    } else {
        let (balance, _) = equilibrium::Solver::new(simulator, point, named)?;
        moves(&balance, simulator, point, (guess, rates), onto)
    }
}

fn moves(
    balance: &impl Balance,
    simulator: &dyn Simulator<f64>,
    point: &Point,
    (mut state, rates): (DMatrix<f64>, &DMatrix<f64>),
    onto: &dyn Fn(&mut DMatrix<f64>) -> Result<(), SimulateError>,
) -> Result<SteadyTangents, LinearError> {
    let equations = balance.equations(point)?;
    for mut column in state.column_iter_mut() {
        let mut change = column.clone_owned();
        balance.keep_drift(&equations.frame, &mut change);
        column.copy_from(&change);
    }
    onto(&mut state)?;
    let rates = rates + full(simulator, &jacobian(simulator, point)?)? * &state;
    let least = LeastSteps::new(balance, &equations)?;
    for (mut column, rates) in state.column_iter_mut().zip(rates.column_iter()) {
        let residual: DVector<f64> = balance.measured(&equations.frame, &rates.clone_owned());
        let step = least.solve(&-residual)?;
        column += balance.unfolded(&equations.frame, &step);
    }
    Ok(SteadyTangents { state, is_determined: least.is_determined() })
}

/// Returns the growth rate of deviations from an equilibrium \[1/s\], if it matters within a time
/// `span` \[s\]; `None` for a stable equilibrium, and for too many states.
pub(crate) fn growth(simulator: &dyn Simulator<f64>, point: Point, span: f64) -> Option<f64> {
    if point.state.len() > MOST_STATES {
        return None;
    }
    let modes = Linearization::at(simulator, point).ok()?.modes().ok()?;
    let fastest = modes.iter().fold(0.0, |most: f64, mode| most.max(mode.natural_frequency()));
    let growth = modes.iter().fold(0.0, |most: f64, mode| most.max(mode.real));
    (growth * span > GROWS && growth > ROUNDING * fastest).then_some(growth)
}
