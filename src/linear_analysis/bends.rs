//! Derivatives of A = dy'/dy along directions.
//!
//! A itself is exact. Its derivative is the limit of central differences, extrapolated step by step
//! (Ridders, Advances in Engineering Software 4, 1982); each entry is taken where it is most
//! consistent. Dual numbers would need no steps, but every emitted scene would have to compile its
//! Jacobian once more: eight times the time of that crate.

use machinist_contract::Simulator;

use super::{LinearError, Point, scales};

/// Number of steps, each half of the one before.
const STEPS: usize = 12;
/// First step, relative to the sizes of the moving variables.
const FIRST: f64 = 0.02;
/// Maximum inconsistency of an entry, relative to the largest derivative of A, or to A over the
/// size of the moving variables.
const SETTLED: f64 = 1e-7;

/// Index of a parameter, if any, and a change of the state.
pub(super) type Direction = (Option<usize>, Vec<f64>);

/// Returns dA along each direction, in the order of the pattern.
///
/// # Errors
/// [`LinearError::NotSmooth`] where differences do not converge, as at a switching surface.
pub(super) fn changes(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    directions: &[Direction],
) -> Result<Vec<Vec<f64>>, LinearError> {
    directions.iter().map(|direction| change(simulator, point, direction)).collect()
}

fn change(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    (parameter, moves): &Direction,
) -> Result<Vec<f64>, LinearError> {
    // Changes of the state are measured by their scales, those of the parameter by its value.
    let scales = scales(simulator);
    let by_state = moves.iter().zip(scales.iter()).map(|(by, scale)| by.abs() / scale);
    let by_parameter = parameter.map(|index| match point.parameters[index].abs() {
        0.0 => 1.0,
        size => 1.0 / size,
    });
    let reach = by_state.chain(by_parameter).fold(0.0, f64::max);
    let entries = simulator.rate_jacobian_pattern().entries.len();
    if reach == 0.0 {
        return Ok(vec![0.0; entries]);
    }
    let at = |by: f64| {
        let mut values = vec![0.0; entries];
        let state: Vec<f64> = point.state.iter().zip(moves).map(|(y, dy)| y + by * dy).collect();
        let mut parameters = point.parameters.clone();
        if let Some(index) = parameter {
            parameters[*index] += by;
        }
        simulator.rate_jacobian(point.time, &state, &parameters, &mut values);
        values
    };
    let mut best = vec![(0.0, f64::INFINITY); entries];
    let mut rows: Vec<Vec<Vec<f64>>> = Vec::new();
    for step in 0..STEPS {
        let by = FIRST / reach / f64::from(1_u32 << step);
        let difference = at(by).iter().zip(at(-by)).map(|(a, b)| (a - b) / (2.0 * by)).collect();
        let mut row: Vec<Vec<f64>> = vec![difference];
        if let Some(before) = rows.last() {
            for (order, coarse) in before.iter().enumerate() {
                let gain = 4.0_f64.powi(order as i32 + 1);
                let fine = &row[order];
                let next: Vec<f64> = fine
                    .iter()
                    .zip(coarse)
                    .map(|(fine, coarse)| (gain * fine - coarse) / (gain - 1.0))
                    .collect();
                for (entry, best) in best.iter_mut().enumerate() {
                    let off = (next[entry] - fine[entry]).abs();
                    let off = off.max((next[entry] - coarse[entry]).abs());
                    if off < best.1 {
                        *best = (next[entry], off);
                    }
                }
                row.push(next);
            }
        }
        rows.push(row);
    }
    let largest = best.iter().fold(0.0, |most: f64, (value, _)| most.max(value.abs()));
    let size = at(0.0).iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let allowed = SETTLED * largest.max(size * reach);
    // This includes NaN, which is never consistent.
    if best.iter().any(|(_, off)| *off > allowed) {
        return Err(LinearError::NotSmooth {
            scene: simulator.name().to_owned(),
            parameter: parameter.map(|index| simulator.parameter(index).name.to_owned()),
        });
    }
    Ok(best.into_iter().map(|(value, _)| value).collect())
}
