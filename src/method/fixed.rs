//! Own methods with steps of fixed length, to measure orders.

use super::explicit::ExplicitSteps;
use super::one_step::{OneStep, Trial};
use super::radau::RadauSteps;
use super::rosenbrock::RosenbrockSteps;
use super::tableau::{DOP853, RODAS5P, TSIT5};
use super::{Stretch, System};

/// A method with given steps.
#[derive(Debug)]
pub struct Fixed {
    /// Name of the method.
    pub name: &'static str,
    make: for<'a> fn(&'a Stretch<'a>) -> Box<dyn OneStep + 'a>,
    /// Order of convergence.
    pub order: u32,
    /// True if it is for stiff machines.
    pub is_implicit: bool,
}

/// All of them; Radau's by their numbers of stages.
pub const FIXED: [Fixed; 6] = [
    Fixed {
        name: "tsit5",
        make: |stretch| Box::new(ExplicitSteps::new(&TSIT5, stretch)),
        order: 5,
        is_implicit: false,
    },
    Fixed {
        name: "dop853",
        make: |stretch| Box::new(ExplicitSteps::new(&DOP853, stretch)),
        order: 8,
        is_implicit: false,
    },
    Fixed {
        name: "rodas5p",
        make: |stretch| Box::new(RosenbrockSteps::new(&RODAS5P, stretch)),
        order: 5,
        is_implicit: true,
    },
    Fixed {
        name: "radau, 3 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(3)),
        order: 5,
        is_implicit: true,
    },
    Fixed {
        name: "radau, 5 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(5)),
        order: 9,
        is_implicit: true,
    },
    Fixed {
        name: "radau, 7 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(7)),
        order: 13,
        is_implicit: true,
    },
];

impl Fixed {
    /// Takes equal steps from 0 to `until`, and passes the number of each with the states at 0.3 of
    /// it and at its end. Returns false, and stops, if a step's equations cannot be solved.
    pub fn run(
        &self,
        system: &System<'_>,
        start: &[f64],
        (until, steps): (f64, usize),
        mut at: impl FnMut(usize, &[f64], &[f64]),
    ) -> bool {
        let atol = vec![1e-6; start.len()];
        let stretch = Stretch::without_control(system, 0.0, until, &atol);
        let mut method = (self.make)(&stretch);
        method.begin(0.0, start);
        let step = until / steps as f64;
        let mut between = vec![0.0; start.len()];
        for index in 0..steps {
            // The error estimate of the method does not matter here.
            if !matches!(method.attempt(step), Trial::Error(_)) {
                return false;
            }
            method.interpolate((index as f64 + 0.3) * step, &mut between);
            at(index, &between, method.end());
            method.accept();
        }
        true
    }

    /// Takes steps of given lengths, forward and back, and returns the state at the end.
    ///
    /// # Panics
    /// If a step's equations cannot be solved.
    #[must_use]
    pub fn walk(&self, system: &System<'_>, start: &[f64], steps: &[f64]) -> Vec<f64> {
        let atol = vec![1e-6; start.len()];
        let stretch = Stretch::without_control(system, -1.0, 8.0, &atol);
        let mut method = (self.make)(&stretch);
        method.begin(0.0, start);
        for step in steps {
            assert!(matches!(method.attempt(*step), Trial::Error(_)), "{}", self.name);
            method.accept();
        }
        method.end().to_vec()
    }
}
