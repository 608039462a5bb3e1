//! Integrals of the energy flows over a step, for methods that step only the states.

use super::system::FLOWS;

/// One value for each energy flow.
pub(super) type Flows = [f64; FLOWS];

/// Nodes of Lobatto's rule of order 8 on \[0, 1\]; (1 -+ sqrt(3/7))/2 inside.
pub(super) const NODES: [f64; 5] =
    [0.0, 0.172_673_164_646_011_43, 0.5, 0.827_326_835_353_988_6, 1.0];

/// Integral over \[0, theta\] of the polynomial through the flows at the nodes.
///
/// At theta = 1 it is Lobatto's rule. The difference there to Simpson's rule on three of the nodes
/// is the error estimate, of order h^5 like that of the states.
#[derive(Default)]
pub(super) struct Quadrature {
    /// Flows at the start of the step.
    pub(super) at_start: Flows,
    at_end: Flows,
    /// Coefficients of theta, theta^2, .. in the integral of each flow.
    integral: [[f64; 5]; FLOWS],
}

impl Quadrature {
    /// Sets the flows at the nodes of a step; returns the errors of their integrals over it.
    pub(super) fn complete(&mut self, step: f64, flows: [Flows; 5]) -> Flows {
        self.at_end = flows[4];
        let polynomials = lagrange_polynomials();
        for (flow, integral) in self.integral.iter_mut().enumerate() {
            for (power, coefficient) in integral.iter_mut().enumerate() {
                let sum: f64 =
                    flows.iter().zip(&polynomials).map(|(at, basis)| at[flow] * basis[power]).sum();
                *coefficient = step * sum / (power + 1) as f64;
            }
        }
        let gained = self.gained_until(1.0);
        std::array::from_fn(|flow| {
            let simpson = (flows[0][flow] + 4.0 * flows[2][flow] + flows[4][flow]) / 6.0;
            gained[flow] - step * simpson
        })
    }

    /// Returns the integrals from the start of the step to `theta` of it.
    pub(super) fn gained_until(&self, theta: f64) -> Flows {
        let value = |integral: &[f64; 5]| {
            integral.iter().rev().fold(0.0, |sum, coefficient| theta * (sum + coefficient))
        };
        std::array::from_fn(|flow| value(&self.integral[flow]))
    }

    /// Makes the end of the step the start of the next one.
    pub(super) fn advance(&mut self) {
        self.at_start = self.at_end;
    }
}

/// Returns the coefficients of 1, theta, .. theta^4 of the polynomials that are 1 at one node and 0
/// at the others.
fn lagrange_polynomials() -> [[f64; 5]; 5] {
    let mut polynomials = [[0.0; 5]; 5];
    for (index, (node, polynomial)) in NODES.iter().zip(&mut polynomials).enumerate() {
        polynomial[0] = 1.0;
        for (_, other) in NODES.iter().enumerate().filter(|(other, _)| *other != index) {
            // Times (theta - other) / (node - other).
            let mut below = 0.0;
            for coefficient in polynomial.iter_mut() {
                let raised = below;
                below = *coefficient;
                *coefficient = (raised - other * below) / (node - other);
            }
        }
    }
    polynomials
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly_up_to_their_degree() {
        for degree in 0..8 {
            let mut quadrature = Quadrature::default();
            let flows = NODES.map(|node| [node.powi(degree), 1.0, 0.0]);
            let errors = quadrature.complete(2.0, flows);
            let exact = |theta: f64| 2.0 * theta.powi(degree + 1) / f64::from(degree + 1);
            assert!((quadrature.gained_until(1.0)[0] - exact(1.0)).abs() < 1e-14);
            if degree <= 4 {
                assert!((quadrature.gained_until(0.3)[0] - exact(0.3)).abs() < 1e-14);
            }
            assert_eq!(errors[0].abs() < 1e-14, degree <= 3, "degree {degree}: {errors:?}");
        }
    }
}
