//! Sensitivities of states and outputs as columns of a trajectory.

use machinist_contract::{Dual, DualFunction, Quantity, Simulator};

use super::{By, Tangents};
use crate::trajectory::{Column, ColumnKind, sensitivity_name};

/// Returns `d(y)/d(p)` of every state, then of every output, for each p in turn.
///
/// `rows` are states with this many entries at `times`.
pub(crate) fn columns(
    simulator: &dyn Simulator<f64>,
    tangents: &Tangents<'_>,
    times: &[f64],
    (rows, width): (&[f64], usize),
) -> Vec<Column> {
    let sensitivities = tangents.take_rows();
    let (by, outputs) = (tangents.by(), simulator.shape().outputs);
    let of_outputs = tangents.of_outputs(outputs, times, (rows, width), &sensitivities);
    let quantities = (0..tangents.states).map(|index| simulator.state(index));
    let quantities = quantities.chain((0..outputs).map(|index| simulator.output(index)));
    let values = transposed(&sensitivities, tangents.len()).into_iter();
    let values = values.chain(transposed(&of_outputs, outputs * by.len()));
    let directions: Vec<_> = by.iter().map(|by| (by, by.quantity(simulator))).collect();
    quantities
        .flat_map(|of| directions.iter().map(move |(by, quantity)| (of, **by, *quantity)))
        .zip(values)
        .map(|((of, by, quantity), values)| column(of, by, quantity, values))
        .collect()
}

impl Tangents<'_> {
    /// Returns derivatives of outputs at states and S of many times, row after row.
    pub(crate) fn of_outputs(
        &self,
        outputs: usize,
        times: &[f64],
        (rows, width): (&[f64], usize),
        sensitivities: &[f64],
    ) -> Vec<f64> {
        let count = self.by.len();
        let mut derivatives = vec![0.0; times.len() * outputs * count];
        let mut results = vec![Dual::constant(0.0); outputs];
        let mut state = vec![Dual::constant(0.0); self.states];
        for directions in self.chunks() {
            // Outputs use live relations at each time, whatever was held at the end of the run.
            let parameters = self.live_parameters_along(&directions);
            let of_each = sensitivities.chunks_exact(self.len().max(1));
            let states = rows.chunks_exact(width).zip(of_each);
            let derivatives = derivatives.chunks_exact_mut((outputs * count).max(1));
            for ((time, (row, s)), derivatives) in times.iter().zip(states).zip(derivatives) {
                self.set_along(row, s, &directions, &mut state);
                let (function, time) = (DualFunction::Outputs, Dual::constant(*time));
                self.derivatives.on_duals(function, time, &state, &parameters, &mut results);
                for (of_output, result) in derivatives.chunks_exact_mut(count).zip(&results) {
                    let along = &mut of_output[directions.clone()];
                    for (lane, slope) in result.slopes.into_iter().enumerate() {
                        if let Some(derivative) = along.get_mut(lane) {
                            *derivative = slope;
                        }
                    }
                }
            }
        }
        derivatives
    }
}

/// Returns the columns of a matrix given row after row; several at once, so that a row is read by
/// whole cache lines.
fn transposed(rows: &[f64], width: usize) -> Vec<Vec<f64>> {
    const BLOCK: usize = 8;
    let count = rows.len().checked_div(width).unwrap_or(0);
    let mut columns: Vec<_> = (0..width).map(|_| vec![0.0; count]).collect();
    for (block, columns) in columns.chunks_mut(BLOCK).enumerate() {
        for (index, row) in rows.chunks_exact(width).enumerate() {
            for (column, value) in columns.iter_mut().zip(&row[block * BLOCK..]) {
                column[index] = *value;
            }
        }
    }
    columns
}

fn column(of: Quantity<'_>, by: By, quantity: Quantity<'_>, values: Vec<f64>) -> Column {
    let what = match by {
        By::Parameter(_) => "",
        By::Initial(_) => "the initial value of ",
    };
    Column {
        name: sensitivity_name(of.name, quantity.name),
        unit: unit(of.unit, quantity.unit),
        kind: ColumnKind::Sensitivity,
        doc: ["derivative of `", of.name, "` by ", what, "`", quantity.name, "`"].concat(),
        values,
    }
}

/// Returns the quotient of two units.
fn unit(of: &str, by: &str) -> String {
    let is_one_word = by.chars().all(|c| c.is_alphanumeric() || c == '^');
    match (of, by) {
        (_, "1") => of.to_owned(),
        _ if of == by => "1".to_owned(),
        _ if is_one_word => [of, "/", by].concat(),
        _ => [of, "/(", by, ")"].concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::{transposed, unit};

    #[test]
    fn rows_become_columns_also_where_there_are_none() {
        let columns = |rows: &[f64]| transposed(rows, 2);
        assert_eq!(columns(&[1.0, 2.0, 3.0, 4.0]), [[1.0, 3.0], [2.0, 4.0]]);
        assert_eq!(columns(&[]), [[0.0; 0]; 2]);
    }

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
