//! A start in equilibrium, in modes that agree with their guards.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::search::{Balance, Crept, LeastSteps, creep, newton};
use super::{LinearError, Linearization, Point, equilibrium, full, jacobian, rest};
use crate::constraints::consistent;
use crate::error::SimulateError;

/// Growth of deviations that a start tells of: by e over the run, at least.
const GROWS: f64 = 1.0;
/// Beside the fastest motion, growth below this is rounding of eigenvalues that repeat.
const ROUNDING: f64 = 1e-6;
/// States up to which that is looked at: eigenvalues take the cube of them.
const MOST_STATES: usize = 300;

/// Sets modes right, and nothing else.
pub(crate) type Settle<'s> = dyn Fn(&mut Vec<f64>) -> Result<(), SimulateError> + 's;

/// The equilibrium near a guess, as [`equilibrium()`], or downhill of it if there is none near, in
/// modes that no event contradicts.
///
/// Entries of the state that are `named` move only as far as the equations ask for. Where they
/// leave no choice but to move, or decide everything, that makes no difference.
///
/// # Errors
/// [`LinearError::NoEquilibrium`], [`LinearError::NoModes`], and those of `settle`.
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
                // A way on which something else than modes would have to change leads nowhere.
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
        // As many as may follow on one another at any start.
        let most = 2 * simulator.events() + 8;
        if tried.contains(&modes) || tried.len() > most {
            // Modes come back that have no equilibrium which agrees with them: go there slowly.
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

    /// Lets the point creep to rest, through whatever modes it passes.
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

    /// Sets the modes of a point right, and puts it onto what holds in them; whether they were
    /// others.
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
        point.state = consistent(self.simulator, &point.parameters, point.time, state, |_| false)?;
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

/// How an equilibrium moves with parameters and with the guess it was found from.
pub(crate) struct SteadyTangents {
    /// A column for each direction.
    pub(crate) state: DMatrix<f64>,
    /// Whether the equations leave nothing open, so that the guess does not matter.
    pub(crate) is_determined: bool,
}

/// Moves of an equilibrium: of columns dy of `guess`, by which it would move if it moved with the
/// guess, and rates df/dp,
///
/// ```text
/// F (df/dp + A (dy + T x)) = 0        F: rates as residuals, T x: moves that are allowed
/// ```
///
/// with the least x, as a search takes it. `onto` makes up for what constraints ask for.
///
/// # Errors
/// As [`equilibrium()`], and those of `onto`.
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

/// How fast deviations from an equilibrium grow \[1/s\], if that shows within so many seconds;
/// nothing of an equilibrium that is stable, or too large to tell.
pub(crate) fn growth(simulator: &dyn Simulator<f64>, point: Point, span: f64) -> Option<f64> {
    if point.state.len() > MOST_STATES {
        return None;
    }
    let modes = Linearization::at(simulator, point).ok()?.modes().ok()?;
    let fastest = modes.iter().fold(0.0, |most: f64, mode| most.max(mode.natural_frequency()));
    let growth = modes.iter().fold(0.0, |most: f64, mode| most.max(mode.real));
    (growth * span > GROWS && growth > ROUNDING * fastest).then_some(growth)
}
