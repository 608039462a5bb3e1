//! Numbers of a run that are only rounding, which are shown as zero.

use machinist::trajectory::{Column, Trajectory};

/// Rounding relative to the largest value of the same column.
const OF_COLUMN: f64 = 1e-14;
/// Rounding relative to the largest value of all columns of the unit: below the last bit of any
/// number from which the value was computed.
const OF_UNIT: f64 = 1e-17;

/// Sizes below which the numbers of a run are rounding.
#[derive(Debug)]
pub struct Rounding<'a> {
    /// Largest value of all columns of each unit.
    of_units: Vec<(&'a str, f64)>,
}

impl<'a> Rounding<'a> {
    /// Compares with the columns of a run.
    pub fn of(trajectory: &'a Trajectory) -> Self {
        let mut of_units: Vec<(&str, f64)> = Vec::new();
        for column in &trajectory.columns {
            let own = largest(&column.values);
            match of_units.iter_mut().find(|(unit, _)| *unit == column.unit) {
                Some((_, of_unit)) => *of_unit = of_unit.max(own),
                None => of_units.push((&column.unit, own)),
            }
        }
        Self { of_units }
    }

    /// Returns the values of a column of the run, with zero in place of rounding.
    pub fn rid(&self, column: &Column) -> Vec<f64> {
        let same = self.of_units.iter().find(|(unit, _)| *unit == column.unit);
        let of_unit = same.map_or(0.0, |(_, of_unit)| *of_unit);
        let least = (OF_COLUMN * largest(&column.values)).max(OF_UNIT * of_unit);
        column.values.iter().map(|value| if value.abs() < least { 0.0 } else { *value }).collect()
    }
}

fn largest(values: &[f64]) -> f64 {
    let sizes = values.iter().map(|value| value.abs()).filter(|size| size.is_finite());
    sizes.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist::Simulation;
    use machinist_scenes::scenes::find_f64;

    #[test]
    fn rounding_is_zero_and_small_numbers_stay() {
        let simulator = find_f64("two_mass").expect("a scene");
        let mut run = Simulation::new(simulator).points(3).run().expect("a run");
        let column = |name: &str, unit: &str, values: [f64; 3]| Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            values: values.to_vec(),
            ..run.columns[0].clone()
        };
        let columns = [
            column("speed", "rpm", [1500.0, 8.87e-15, -2e-13]),
            column("small", "m", [3e-9, -1e-20, f64::NAN]),
            column("noise", "rpm", [8.87e-15, -1e-15, 0.0]),
            column("clean", "N", [1e-300, -1e-310, 0.0]),
        ];
        run.columns = columns.to_vec();
        let rid = |k: usize| Rounding::of(&run).rid(&run.columns[k]);
        assert_eq!(rid(0), [1500.0, 0.0, 0.0]);
        assert_eq!(rid(1)[..2], [3e-9, -1e-20]);
        assert!(rid(1)[2].is_nan());
        assert_eq!(rid(2), [0.0; 3]);
        assert_eq!(rid(3), [1e-300, -1e-310, 0.0]);
    }
}
