//! Conclusion of the reed study: a stiffer contact with the cloth fell changes the motion little
//! and the stress markedly. Compares runs with a fell that only pushes, as in the real machine, and
//! with one that also pulls.

use machinist_contract::field::FieldScene;
use machinist_scenes::scenes::reed_beat_up::ReedBeatUp;
use machinist_scenes::scenes::reed_beat_up_one_sided::ReedBeatUpOneSided;

use crate::reed_cells::Fell;
use crate::verify::machine::reed_beat_up;
use crate::verify::{CheckFailure, largest};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};

/// Compared outputs of the scene, with their units.
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
    /// Ratio C2/C1.
    pub share: f64,
    /// Output times \[s\].
    pub times: Vec<f64>,
    /// Columns of [`COMPARED`].
    pub columns: [Vec<f64>; 5],
}

impl Beat {
    /// Returns the largest absolute value of each column.
    #[must_use]
    pub fn largest(&self) -> [f64; 5] {
        self.columns.each_ref().map(|column| largest(column))
    }

    /// Returns the change of the largest values from this run to another, in percent.
    #[must_use]
    pub fn change_to(&self, other: &Beat) -> [f64; 5] {
        let (from, to) = (self.largest(), other.largest());
        [0, 1, 2, 3, 4].map(|index| 100.0 * (to[index] / from[index] - 1.0))
    }

    /// Returns the largest angle of the reed forward, into the fell \[rad\].
    #[must_use]
    pub fn forward(&self) -> f64 {
        self.columns[1].iter().fold(0.0, |most: f64, angle| most.max(*angle))
    }
}

/// Runs over a period of the drive with C2 = 0, C1/2 and C1.
///
/// # Errors
/// [`CheckFailure`] if the scene does not run.
pub fn beats(fell: Fell) -> Result<[Beat; 3], CheckFailure> {
    Ok([beat(fell, 0.0)?, beat(fell, 0.5)?, beat(fell, 1.0)?])
}

/// Runs over a period of the drive with C2 equal to `share` times C1.
///
/// # Errors
/// [`CheckFailure`] if the scene does not run.
pub fn beat(fell: Fell, share: f64) -> Result<Beat, CheckFailure> {
    // Both scenes have the same parameters and outputs.
    let machine = reed_beat_up();
    let scene: &dyn FieldScene<f64> = match fell {
        Fell::PushesAndPulls => &ReedBeatUp,
        Fell::OnlyPushes => &ReedBeatUpOneSided,
    };
    let wanted = Discretisation { elements: Some(14), order: Some(4) };
    let simulator = FieldSimulator::new(scene, wanted)?;
    let stiffness = machine.value("reed.stiffness")?;
    let run = Simulation::new(simulator.single())
        .parameters(&machine.parameters(&[("fell.stiffness", share * stiffness)])?)
        .rtol(1e-6)
        .method(Method::Dop853)
        .run()?;
    let mut columns = [const { Vec::new() }; 5];
    for (column, (name, _)) in columns.iter_mut().zip(COMPARED) {
        *column = machine.column(&run, name)?.to_vec();
    }
    Ok(Beat { share, times: run.times.clone(), columns })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn against_a_fell_that_only_pushes_stiffer_contact_changes_motion_little_and_stress_markedly() {
        let beats = beats(Fell::OnlyPushes).unwrap();
        let [shaft, reed, before, _, fell] = beats[1].change_to(&beats[2]);
        // The cells give +2.0 %, -0.5 %, +28.0 %.
        assert!((shaft - 2.0).abs() < 0.2 && (reed + 0.55).abs() < 0.2, "{shaft} {reed}");
        assert!((before - 28.0).abs() < 1.0 && fell > 30.0, "{before} {fell}");
        assert!(beats[0].largest()[4] == 0.0);
        let forward = 100.0 * (beats[2].forward() / beats[1].forward() - 1.0);
        assert!((forward + 32.5).abs() < 1.0, "{forward}");
        let softest = beats[2].columns[4].iter().fold(0.0_f64, |least, torque| least.min(*torque));
        assert!(softest == 0.0, "a fell that only pushes pulls with {softest} N m");
    }

    #[test]
    fn a_fell_that_also_pulls_would_change_the_reed_s_motion_as_much_as_its_stress() {
        let beats = beats(Fell::PushesAndPulls).unwrap();
        let [shaft, reed, before, _, fell] = beats[1].change_to(&beats[2]);
        assert!(shaft.abs() < 12.0 && reed < -20.0, "{shaft} {reed}");
        assert!(before > 20.0 && fell > 30.0, "{before} {fell}");
    }
}
