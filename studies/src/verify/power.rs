//! The power balance at a state and the energy account of a run, as errors.

use machinist::trajectory::EnergyBalance;
use machinist_contract::Simulator;

use super::machine::Point;
use super::worse;

/// |dE/dt - supplied + lost|, relative to |supplied| + |lost| + `terms`, the sum of
/// |dE/dy_i y_i'| and |dE/dt| at rest.
pub(super) fn residual(simulator: &dyn Simulator<f64>, point: &Point, terms: f64) -> f64 {
    let power = simulator.power_balance(point.time, &point.state, &point.parameters);
    relative(simulator, point, power.residual().abs(), terms)
}

/// An error of a power, relative to the sizes of what is balanced.
pub(super) fn relative(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    error: f64,
    terms: f64,
) -> f64 {
    let power = simulator.power_balance(point.time, &point.state, &point.parameters);
    let size = terms + power.supplied.abs() + power.dissipated.abs();
    // Constraints may leave nothing that moves and stores energy.
    let stored = simulator.energy(point.time, &point.state, &point.parameters);
    let least = if simulator.constraints() > 0 { stored.kinetic } else { 0.0 };
    if error == 0.0 { 0.0 } else { error / size.max(least) }
}

/// Largest residual of the account, divided by the integral of |supplied| + |lost| power, or
/// where none of either flows by the largest energy in motion, and by no less than `least` \[J\];
/// 0 if nothing is off.
pub(super) fn account_error(balance: &EnergyBalance, least: f64) -> f64 {
    let largest = balance.residual.iter().fold(0.0, |most, r| worse(most, r.abs()));
    let passed = balance.passed.last().copied().unwrap_or(0.0);
    let flows = passed > 1e-12 * balance.largest_active;
    let scale = if flows { passed } else { balance.largest_active }.max(least);
    // Nothing that moves has nothing to lose.
    if largest == 0.0 { 0.0 } else { largest / scale }
}
