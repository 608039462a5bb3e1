//! Sensitivities of states and outputs as columns of a trajectory.

use machinist_contract::{Dual, DualFunction, Quantity, Simulator};

use super::{By, Tangents};
use crate::trajectory::{Column, ColumnKind, sensitivity_name};

/// `d(y)/d(p)` of every state, then of every output, by each p in turn.
///
/// `rows` are states of so many entries each at `times`.
pub(crate) fn columns(
    simulator: &dyn Simulator<f64>,
    tangents: &Tangents<'_>,
    times: &[f64],
    (rows, width): (&[f64], usize),
) -> Vec<Column> {
    let sensitivities = tangents.take_rows();
    let shape = simulator.shape();
    let by = tangents.by().to_vec();
    let count = by.len();
    let rows_of_tangents = || sensitivities.chunks_exact(tangents.len().max(1));
    let mut outputs = vec![Vec::with_capacity(times.len()); shape.outputs * count];
    let mut results = vec![Dual::constant(0.0); shape.outputs];
    for directions in tangents.chunks() {
        let parameters = tangents.parameters_along(&directions);
        let states = rows.chunks_exact(width).zip(rows_of_tangents());
        for (time, (row, s)) in times.iter().zip(states) {
            let state = tangents.state_along(row, s, &directions);
            let (function, time) = (DualFunction::Outputs, Dual::constant(*time));
            tangents.derivatives.on_duals(function, time, &state, &parameters, &mut results);
            for (columns, result) in outputs.chunks_exact_mut(count).zip(&results) {
                let columns = &mut columns[directions.clone()];
                columns
                    .iter_mut()
                    .zip(result.slopes)
                    .for_each(|(column, slope)| column.push(slope));
            }
        }
    }
    let states = (0..shape.states()).flat_map(|index| (0..count).map(move |k| (index, k)));
    let of_states = states.map(|(index, k)| {
        let values = rows_of_tangents().map(|row| row[index * count + k]).collect();
        column(simulator.state(index), by[k], simulator, values)
    });
    let of_outputs = outputs.into_iter().enumerate().map(|(place, values)| {
        column(simulator.output(place / count), by[place % count], simulator, values)
    });
    of_states.chain(of_outputs).collect()
}

fn column(of: Quantity<'_>, by: By, simulator: &dyn Simulator<f64>, values: Vec<f64>) -> Column {
    let quantity = by.quantity(simulator);
    let what = match by {
        By::Parameter(_) => "",
        By::Initial(_) => "the initial value of ",
    };
    Column {
        name: sensitivity_name(of.name, quantity.name),
        unit: unit(of.unit, quantity.unit),
        kind: ColumnKind::Sensitivity,
        doc: format!("derivative of `{}` by {what}`{}`", of.name, quantity.name),
        values,
    }
}

/// One unit over another.
fn unit(of: &str, by: &str) -> String {
    let is_one_word = by.chars().all(|c| c.is_alphanumeric() || c == '^');
    match (of, by) {
        (_, "1") => of.to_owned(),
        _ if of == by => "1".to_owned(),
        _ if is_one_word => format!("{of}/{by}"),
        _ => format!("{of}/({by})"),
    }
}

#[cfg(test)]
mod tests {
    use super::unit;

    #[test]
    fn units_divide() {
        for (of, by, wanted) in [
            ("N m", "1", "N m"),
            ("N m", "N m/rad", "N m/(N m/rad)"),
            ("rad", "s", "rad/s"),
            ("1", "kg m^2", "1/(kg m^2)"),
            ("m", "m", "1"),
        ] {
            assert_eq!(unit(of, by), wanted);
        }
    }
}
