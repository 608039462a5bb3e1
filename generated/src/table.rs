//! Cubic interpolation of a measured table.

use crate::Real;

/// A natural cubic spline through measured points, twice continuously
/// differentiable, constant beyond its ends.
///
/// On the k-th interval, with u = x - x_k:
/// `y = c[0] + c[1] u + c[2] u^2 + c[3] u^3`.
#[derive(Debug, Clone, Copy)]
pub struct CubicTable<'a> {
    /// Abscissae x_0 < x_1 < ... < x_N.
    pub knots: &'a [f64],
    /// Coefficients of each interval, N of them.
    pub coefficients: &'a [[f64; 4]],
}

impl CubicTable<'_> {
    /// Value (`order` 0) or derivative of the given order at `argument`.
    ///
    /// Walks the intervals with [`Real::select_less`], so that it holds for
    /// types that carry several values; cost is linear in the table's length.
    #[must_use]
    pub fn evaluate<R: Real>(&self, order: u32, argument: R) -> R {
        let zero = R::literal(0.0);
        let (Some(first), Some(last)) = (self.knots.first(), self.knots.last()) else {
            return zero;
        };
        let mut value = self.end_value(order, 0, *first);
        for (coefficients, &start) in self.coefficients.iter().zip(self.knots) {
            let inside = polynomial(coefficients, order, argument - R::literal(start));
            value = R::select_less(argument, R::literal(start), value, inside);
        }
        let beyond = self.end_value(order, self.coefficients.len().saturating_sub(1), *last);
        R::select_less(argument, R::literal(*last), value, beyond)
    }

    fn end_value<R: Real>(&self, order: u32, interval: usize, end: f64) -> R {
        match (order, self.coefficients.get(interval), self.knots.get(interval)) {
            (0, Some(coefficients), Some(&start)) => {
                polynomial(coefficients, 0, R::literal(end - start))
            }
            _ => R::literal(0.0),
        }
    }
}

/// Derivative of the given order of c0 + c1 u + c2 u^2 + c3 u^3.
fn polynomial<R: Real>(c: &[f64; 4], order: u32, u: R) -> R {
    let [c0, c1, c2, c3] = c.map(R::literal);
    let (two, three, six) = (R::literal(2.0), R::literal(3.0), R::literal(6.0));
    match order {
        0 => ((c3 * u + c2) * u + c1) * u + c0,
        1 => (three * c3 * u + two * c2) * u + c1,
        2 => six * c3 * u + two * c2,
        3 => six * c3,
        _ => R::literal(0.0),
    }
}
