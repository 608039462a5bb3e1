//! Responses to s^j e^(mu s) in closed form.

use nalgebra::Complex;

/// Returns `J_j = integral over [0, h] of e^(lambda (h - s)) s^j e^(mu s) ds` for j up to
/// `highest`: the response at h of x' = lambda x + s^j e^(mu s), from rest.
///
/// With z = (mu - lambda) h, `J_j = (h^j e^(mu h) - j J_(j-1))/(mu - lambda)`, or
/// where that would cancel, `e^(lambda h) h^(j+1) sum_m z^m/(m! (m + j + 1))`.
pub(super) fn responses(
    lambda: Complex<f64>,
    mu: Complex<f64>,
    h: f64,
    highest: u32,
) -> Vec<Complex<f64>> {
    let difference = mu - lambda;
    let z = difference * h;
    let (free, forced) = ((lambda * h).exp(), (mu * h).exp());
    let mut responses: Vec<Complex<f64>> = Vec::with_capacity(highest as usize + 1);
    for j in 0..=highest {
        let response = if z.norm() <= f64::from(j) + 1.0 {
            free * h.powi(j as i32 + 1) * series(z, j)
        } else if let Some(before) = responses.last() {
            (forced * h.powi(j as i32) - *before * f64::from(j)) / difference
        } else {
            (forced - free) / difference
        };
        responses.push(response);
    }
    responses
}

/// Returns `sum_m z^m/(m! (m + j + 1))`, the integral over \[0, 1\] of u^j e^(z u).
fn series(z: Complex<f64>, j: u32) -> Complex<f64> {
    const MOST: u32 = 100;
    let mut power = Complex::ONE;
    let mut sum = Complex::ZERO;
    for m in 0..MOST {
        let term = power / f64::from(m + j + 1);
        sum += term;
        if term.norm() <= f64::EPSILON * 0.25 * sum.norm() && f64::from(m) > z.norm() {
            break;
        }
        power *= z / f64::from(m + 1);
    }
    sum
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::responses;

    /// Integrates by Simpson's rule with very many intervals.
    fn by_quadrature(lambda: Complex<f64>, mu: Complex<f64>, h: f64, j: i32) -> Complex<f64> {
        let intervals = 20_000;
        let value = |index: usize| {
            let s = h * index as f64 / intervals as f64;
            (lambda * (h - s)).exp() * (mu * s).exp() * s.powi(j)
        };
        let sum: Complex<f64> = (0..=intervals)
            .map(|index| {
                let weight = match index {
                    0 => 1.0,
                    _ if index == intervals => 1.0,
                    _ if index % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                value(index) * weight
            })
            .sum();
        sum * (h / (3.0 * intervals as f64))
    }

    #[test]
    fn responses_are_those_of_quadrature_at_and_off_resonance() {
        let lambdas = [Complex::new(-0.5, 7.0), Complex::new(0.0, 0.0), Complex::new(-30.0, 0.0)];
        let offsets = [0.0, 1e-12, 1e-6, 1e-2, 0.7, 3.0, 20.0];
        for lambda in lambdas {
            for offset in offsets {
                let mu = lambda + Complex::new(0.3 * offset, offset);
                for h in [0.01, 0.9, 2.5] {
                    let found = responses(lambda, mu, h, 4);
                    for (j, found) in found.iter().enumerate() {
                        let expected = by_quadrature(lambda, mu, h, j as i32);
                        let size = h.powi(j as i32 + 1) * (mu.re.max(lambda.re) * h).exp();
                        let error = (found - expected).norm() / size;
                        assert!(error < 1e-11, "{lambda} {mu} {h} {j}: {found} {expected}");
                    }
                }
            }
        }
    }
}
