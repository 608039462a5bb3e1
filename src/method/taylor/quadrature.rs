//! Gauss-Legendre quadrature of energy flows over a step.

use crate::legendre::legendre;

/// Nodes and weights on \[-1, 1\], exact for polynomials of degree 2 `points` - 1.
#[derive(Debug, Clone)]
pub(in crate::method) struct Gauss {
    points: Vec<(f64, f64)>,
}

impl Gauss {
    /// Creates a rule: roots of the Legendre polynomial by Newton's iteration, weights
    /// `2/((1 - x^2) P'(x)^2)`.
    pub(in crate::method) fn new(points: usize) -> Self {
        let n = points as f64;
        let point = |index: usize| {
            let mut x = (std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5)).cos();
            for _ in 0..8 {
                let [value, slope] = legendre(points, x);
                x -= value / slope;
            }
            let [_, slope] = legendre(points, x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        };
        Self { points: (0..points).map(point).collect() }
    }

    /// Returns nodes and weights on \[from, until\].
    pub(in crate::method) fn points(
        &self,
        from: f64,
        until: f64,
    ) -> impl Iterator<Item = (f64, f64)> {
        let (middle, half) = (0.5 * (from + until), 0.5 * (until - from));
        self.points.iter().map(move |(x, weight)| (middle + half * x, half * weight))
    }
}

#[cfg(test)]
mod tests {
    use super::Gauss;

    #[test]
    fn polynomials_up_to_twice_the_points_are_integrated_exactly() {
        for points in 2..20 {
            let rule = Gauss::new(points);
            let degree = 2 * points as i32 - 1;
            let sum: f64 = rule.points(0.5, 2.0).map(|(x, weight)| weight * x.powi(degree)).sum();
            let power = degree + 1;
            let exact = (2_f64.powi(power) - 0.5_f64.powi(power)) / f64::from(power);
            assert!((sum / exact - 1.0).abs() < 1e-13, "{points} points: {sum} and {exact}");
        }
    }
}
