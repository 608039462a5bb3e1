//! Slow motions of machines that also have fast ones: frequencies against exact counts of
//! eigenvalues.

use machinist::linear_analysis::{Linearization, ModeKind, Point, SecondOrder};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe as _, Simulator};
use nalgebra::DMatrix;
use num_rational::BigRational;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};

use crate::own_scene::of_text;

/// Masses in a row with springs between them, and from both ends to the ground if these are not
/// zero.
struct Chain {
    masses: Vec<f64>,
    springs: Vec<f64>,
}

impl Chain {
    /// Returns springs that are small whole numbers times powers of two, so that their sums are
    /// exact.
    fn random(rng: &mut fastrand::Rng, decades: i32) -> Self {
        let count = rng.usize(2..9);
        let bits = 10 * decades / 3;
        let mut spring = |_| f64::from(rng.u32(1..16)) * 2.0_f64.powi(rng.i32(0..bits));
        let mut springs: Vec<f64> = (0..=count).map(&mut spring).collect();
        springs[count] = if rng.bool() { springs[count] } else { 0.0 };
        let masses = (0..count).map(|_| 2.0_f64.powi(rng.i32(-8..8)) * f64::from(rng.u32(1..8)));
        let masses = masses.collect();
        Self { masses, springs }
    }

    fn stiffness(&self) -> DMatrix<f64> {
        let springs = &self.springs;
        DMatrix::from_fn(self.masses.len(), self.masses.len(), |row, column| {
            match column.abs_diff(row) {
                0 => springs[row] + springs[row + 1],
                1 => -springs[row.max(column)],
                _ => 0.0,
            }
        })
    }

    /// Counts the eigenvalues of K x = w^2 M x below a number, by changes of sign of the leading
    /// determinants of K - w^2 M in exact arithmetic.
    fn count_below(&self, square: &BigRational) -> usize {
        let exact = |value: f64| BigRational::from_float(value).expect("finite");
        let (mut before, mut last) = (BigRational::zero(), exact(1.0));
        let mut changes = 0;
        for (index, mass) in self.masses.iter().enumerate() {
            let springs = [self.springs[index], self.springs[index + 1]].map(exact);
            let pivot = &springs[0] + &springs[1] - square * exact(*mass);
            let beside = if index == 0 { BigRational::zero() } else { &springs[0] * &springs[0] };
            let next = pivot * &last - beside * &before;
            changes += usize::from(next.is_negative() != last.is_negative());
            (before, last) = (last, next);
        }
        changes
    }

    /// Returns whether w is the frequency with this index, to a relative error.
    fn is_frequency(&self, number: usize, w: f64, error: f64) -> bool {
        let square = |factor: f64| {
            let w = BigRational::from_float(w * factor).expect("finite");
            &w * &w
        };
        self.count_below(&square(1.0 - error)) <= number
            && self.count_below(&square(1.0 + error)) > number
    }

    fn spec(&self) -> String {
        use std::fmt::Write as _;
        let mut text = "[scene]\nname = \"chain\"\n[units.chain]\nunit = \"chain\"\n[run]\n\
                        until = 1.0\npoints = 2\nrtol = 1e-9\nmethod = \"auto\"\n\
                        [define.chain.coordinates]\n"
            .to_owned();
        let mut kinetic = Vec::new();
        let mut potential = vec!["s0*x0^2/2".to_owned()];
        for index in 0..self.masses.len() {
            let _ = writeln!(text, "x{index} = {{ unit = \"m\" }}");
            kinetic.push(format!("m{index}*x{index}_dot^2/2"));
            let next = index + 1;
            potential.push(if next == self.masses.len() {
                format!("s{next}*x{index}^2/2")
            } else {
                format!("s{next}*(x{next} - x{index})^2/2")
            });
        }
        text.push_str("[define.chain.parameters]\n");
        for (index, mass) in self.masses.iter().enumerate() {
            let _ = writeln!(text, "m{index} = {{ value = {mass:?}, unit = \"kg\" }}");
        }
        for (index, spring) in self.springs.iter().enumerate() {
            let _ = writeln!(text, "s{index} = {{ value = {spring:?}, unit = \"N/m\" }}");
        }
        let (kinetic, potential) = (kinetic.join(" + "), potential.join(" + "));
        let _ = writeln!(
            text,
            "[define.chain.energy]\nkinetic = \"{kinetic}\"\npotential = \"{potential}\""
        );
        text
    }
}

#[test]
fn frequencies_without_damping_are_exact_over_seven_decades() {
    let mut rng = fastrand::Rng::with_seed(47);
    let mut widest = 1.0_f64;
    for _ in 0..300 {
        let chain = Chain::random(&mut rng, 14);
        let count = chain.masses.len();
        let forms = SecondOrder {
            mass: DMatrix::from_fn(count, count, |i, j| if i == j { chain.masses[i] } else { 0.0 }),
            damping: DMatrix::zeros(count, count),
            stiffness: chain.stiffness(),
        };
        let found = forms.undamped_frequencies().expect("M is positive");
        assert_eq!(found.len(), count);
        widest = widest.max(found[count - 1] / found[0]);
        for (number, w) in found.iter().enumerate() {
            let (masses, springs) = (&chain.masses, &chain.springs);
            assert!(chain.is_frequency(number, *w, 1e-13), "{w}: {masses:?} {springs:?}");
        }
    }
    assert!(widest > 1e7, "{widest:e}");
}

#[test]
fn modes_and_frequencies_without_damping_agree_as_far_as_the_matrix_tells() {
    let mut rng = fastrand::Rng::with_seed(48);
    let mut widest = 1.0_f64;
    for _ in 0..40 {
        let chain = Chain::random(&mut rng, 10);
        let count = chain.masses.len();
        let simulator = of_text(&chain.spec(), Keep::Needed);
        let parameters = (0..simulator.shape().parameters).map(|k| simulator.parameter_default(k));
        let state = vec![0.0; simulator.shape().states()];
        let point = Point { time: 0.0, state, parameters: parameters.collect() };
        let linear = Linearization::at(&simulator as &dyn Simulator<f64>, point).expect("finite");
        let modes = linear.modes().expect("modes");
        let oscillations = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
        let found: Vec<f64> = oscillations.map(|mode| mode.imaginary).collect();
        let without = linear.second_order().expect("small").undamped_frequencies().expect("w");
        assert_eq!([found.len(), without.len()], [count; 2], "{:?}", chain.springs);
        widest = widest.max(found[count - 1] / found[0]);
        for (number, w) in found.iter().chain(&without).enumerate() {
            // The entries of M^-1 K are rounded, each by the size of the largest.
            let lost = (found[count - 1] / w).powi(2);
            let error = 1e-13 + 4.0 * count as f64 * f64::EPSILON * lost;
            let (masses, springs) = (&chain.masses, &chain.springs);
            assert!(chain.is_frequency(number % count, *w, error), "{w}: {masses:?} {springs:?}");
        }
    }
    assert!(widest.to_f64().is_some_and(|widest| widest > 1e5), "{widest:e}");
}
