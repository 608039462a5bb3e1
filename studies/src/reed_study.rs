//! What the reed study concludes: a stiffer contact with the cloth fell changes the
//! motion little and the stress markedly. Runs of `reed_beat_up`, compared.

use machinist_scenes::scenes::reed_beat_up::ReedBeatUp;

use crate::verify::CheckFailure;
use crate::verify::machine::reed_beat_up;
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};

/// What is compared, with its unit: outputs of the scene.
pub const COMPARED: [(&str, &str); 5] = [
    ("shaft_angle", "rad"),
    ("reed_angle", "rad"),
    ("stress_before", "Pa"),
    ("stress_after", "Pa"),
    ("fell_torque", "N m"),
];

/// A run with one stiffness of the contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Beat {
    /// C2/C1.
    pub share: f64,
    /// Output times \[s\].
    pub times: Vec<f64>,
    /// The columns of [`COMPARED`].
    pub columns: [Vec<f64>; 5],
}

impl Beat {
    /// Largest size of each column.
    #[must_use]
    pub fn largest(&self) -> [f64; 5] {
        let size = |column: &Vec<f64>| column.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        [0, 1, 2, 3, 4].map(|index| size(&self.columns[index]))
    }

    /// Change of the largest sizes from this run to another, in per cent.
    #[must_use]
    pub fn change_to(&self, other: &Beat) -> [f64; 5] {
        let (from, to) = (self.largest(), other.largest());
        [0, 1, 2, 3, 4].map(|index| 100.0 * (to[index] / from[index] - 1.0))
    }
}

/// Runs over a period of the drive with C2 = 0, C1/2 and C1.
///
/// # Errors
/// [`CheckFailure`] if the scene does not run.
pub fn beats() -> Result<Vec<Beat>, CheckFailure> {
    let machine = reed_beat_up();
    let wanted = Discretisation { elements: Some(6), order: Some(4) };
    let simulator = FieldSimulator::new(&ReedBeatUp, wanted)?;
    let stiffness = machine.value("reed.stiffness")?;
    let beat = |share: f64| -> Result<Beat, CheckFailure> {
        let run = Simulation::new(&simulator)
            .parameters(&machine.parameters(&[("fell.stiffness", share * stiffness)])?)
            .rtol(1e-6)
            .method(Method::Dop853)
            .run()?;
        let mut columns = [const { Vec::new() }; 5];
        for (column, (name, _)) in columns.iter_mut().zip(COMPARED) {
            *column = machine.column(&run, name)?.to_vec();
        }
        Ok(Beat { share, times: run.times.clone(), columns })
    };
    [0.0, 0.5, 1.0].into_iter().map(beat).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stiffer_contact_changes_the_motion_of_the_shaft_less_than_its_stress() {
        let beats = beats().unwrap();
        let [shaft, reed, before, after, fell] = beats[1].change_to(&beats[2]);
        println!("{shaft} {reed} {before} {after} {fell}");
        assert!(shaft.abs() < 12.0, "{shaft}");
        assert!(before > 20.0 && fell > 30.0, "{before} {fell}");
        assert!(beats[0].largest()[4] == 0.0);
    }
}
