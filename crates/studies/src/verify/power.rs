//! Errors of the power balance at a state and of the energy balance of a run.

use machinist::trajectory::EnergyBalance;
use machinist_contract::Simulator;

use super::machine::Point;
use super::worse;

/// Returns |dE/dt - supplied + lost|, relative to |supplied| + |lost| + `terms`, the sum of
/// |dE/dy_i y_i'| and |dE/dt| at rest.
pub(super) fn residual(simulator: &dyn Simulator<f64>, point: &Point, terms: f64) -> f64 {
    let power = simulator.power_balance(point.time, &point.state, &point.parameters);
    relative(simulator, point, power.residual().abs(), terms)
}

/// Returns an error of a power, relative to the sizes of the balanced terms.
pub(super) fn relative(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    error: f64,
    terms: f64,
) -> f64 {
    let power = simulator.power_balance(point.time, &point.state, &point.parameters);
    let size = terms + power.supplied.abs() + power.dissipated.abs();
    // Constraints may leave no motion that stores energy.
    let stored = simulator.energy(point.time, &point.state, &point.parameters);
    let least = if simulator.constraints() > 0 { stored.kinetic } else { 0.0 };
    if error == 0.0 { 0.0 } else { error / size.max(least) }
}

/// Returns the largest residual of the balance, divided by the integral of |supplied| + |lost|
/// power. If neither flows, the divisor is the largest energy in motion; it is at least `least`
/// \[J\]. The result is 0 if there is no residual.
pub(super) fn account_error(balance: &EnergyBalance, least: f64) -> f64 {
    let largest = balance.residual.iter().fold(0.0, |most, r| worse(most, r.abs()));
    let passed = balance.passed.last().copied().unwrap_or(0.0);
    let flows = passed > 1e-12 * balance.largest_active;
    let scale = if flows { passed } else { balance.largest_active }.max(least);
    // A machine at rest has nothing to lose.
    if largest == 0.0 { 0.0 } else { largest / scale }
}
