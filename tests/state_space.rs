//! State-space models against references by SciPy and mpmath, differences of runs, and null spaces.

mod along;
mod scenes;

use machinist::linear_analysis::{Hold, Rows, StateSpace, Weight};
use serde::Deserialize;

/// A system of `state_space/references.py`.
#[derive(Deserialize)]
struct Reference {
    name: String,
    a: Rows,
    b: Rows,
    c: Rows,
    d: Rows,
    inputs: Vec<f64>,
    outputs: Vec<f64>,
    period: Option<f64>,
    gain: Rows,
    #[serde(default)]
    zeros: Vec<[f64; 2]>,
    step: Option<f64>,
    zoh: Option<[Rows; 4]>,
    tustin: Option<[Rows; 4]>,
}

impl Reference {
    fn all() -> Vec<Self> {
        serde_json::from_str(include_str!("state_space/references.json")).expect("references")
    }

    fn model(&self) -> StateSpace {
        let matrices = [&self.a, &self.b, &self.c, &self.d].map(Clone::clone);
        StateSpace::of_matrices(matrices, self.period).expect("shapes fit")
    }

    fn weights(&self) -> Vec<Weight> {
        let named = |letter: &'static str, sizes: &[f64]| -> Vec<Weight> {
            let weight = |(number, deviation): (usize, &f64)| Weight {
                name: format!("{letter}{number}"),
                deviation: *deviation,
            };
            (1..).zip(sizes).map(weight).collect()
        };
        [named("u", &self.inputs), named("y", &self.outputs)].concat()
    }
}

/// Returns the largest difference of two matrices, relative to the largest entry of the second.
fn distance(found: &Rows, wanted: &Rows) -> f64 {
    assert_eq!(found.len(), wanted.len());
    let largest = wanted.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    let pairs = found.iter().flatten().zip(wanted.iter().flatten());
    pairs.map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max) / largest
}

#[test]
fn regulators_have_the_gains_of_eleven_references_of_sixty_digits() {
    for reference in Reference::all() {
        let regulator = reference.model().lqr(&reference.weights());
        let regulator = regulator.unwrap_or_else(|error| panic!("{}: {error}", reference.name));
        let error = distance(&regulator.gain, &reference.gain);
        println!("{:30} {error:.1e}", reference.name);
        assert!(error < 1e-10, "{}: {error:e}", reference.name);
    }
}

#[test]
fn estimators_are_regulators_of_the_transposed_system() {
    for reference in Reference::all() {
        let transposed = |rows: &Rows| -> Rows {
            (0..rows[0].len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect()
        };
        let [a, b, c, d] = [&reference.a, &reference.c, &reference.b, &reference.d].map(transposed);
        let dual = StateSpace::of_matrices([a, b, c, d], reference.period).expect("shapes fit");
        // Noise and deviations change places: the cost of an input is the variance of an output.
        let inverse = |sizes: &[f64]| sizes.iter().map(|size| 1.0 / size).collect();
        let (inputs, outputs) = (inverse(&reference.outputs), inverse(&reference.inputs));
        let dual_weights = Reference { inputs, outputs, ..reference }.weights();
        let again = Reference::all().into_iter();
        let reference = again.into_iter().find(|other| other.a == transposed(&dual.a)).expect("it");
        let estimator = dual.kalman(&dual_weights).expect("it exists");
        let error = distance(&estimator.gain, &transposed(&reference.gain));
        assert!(error < 1e-10, "{}: {error:e}", reference.name);
    }
}

#[test]
fn sampled_models_are_those_of_scipy() {
    for reference in Reference::all() {
        let Some(step) = reference.step else { continue };
        let holds = [(Hold::Zoh, &reference.zoh), (Hold::Tustin, &reference.tustin)];
        for (hold, wanted) in holds {
            let found = reference.model().sampled(step, hold).expect("it exists");
            let [a, b, c, d] = wanted.as_ref().expect("SciPy's");
            for (found, wanted) in [(&found.a, a), (&found.b, b), (&found.c, c)] {
                let error = distance(found, wanted);
                assert!(error < 1e-12, "{} {hold:?}: {error:e}", reference.name);
            }
            let through = found.d.iter().flatten().zip(d.iter().flatten());
            let largest = d.iter().flatten().fold(1e-300_f64, |most, value| most.max(value.abs()));
            for (found, wanted) in through {
                assert!((found - wanted).abs() <= 1e-12 * largest, "{}", reference.name);
            }
        }
    }
}

#[test]
fn zeros_are_the_finite_eigenvalues_of_the_pencil() {
    let mut tried = 0;
    for reference in Reference::all().iter().filter(|reference| !reference.zeros.is_empty()) {
        let found = reference.model().zeros().expect("an iteration that converges");
        assert_eq!(found.len(), reference.zeros.len(), "{}", reference.name);
        for [real, imaginary] in &reference.zeros {
            let size = real.hypot(*imaginary);
            let off = found.iter().map(|zero| (zero.re - real).hypot(zero.im - imaginary));
            let off = off.fold(f64::INFINITY, f64::min);
            assert!(off <= 1e-8 * size.max(1e-6), "{}: {found:?}", reference.name);
        }
        tried += 1;
    }
    assert!(tried >= 2, "{tried} systems have zeros");
}
