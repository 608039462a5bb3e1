//! Cubic interpolation of a measured table.

use crate::Real;

/// A natural cubic spline through measured points, twice continuously differentiable, constant
/// beyond its ends.
///
/// On the k-th interval, with u = x - x_k:
/// `y = c[0] + c[1] u + c[2] u^2 + c[3] u^3`.
#[derive(Debug, Clone, Copy)]
pub struct CubicTable<'a> {
    /// Abscissas x_0 < x_1 < ... < x_N.
    pub knots: &'a [f64],
    /// Coefficients of the N intervals.
    pub coefficients: &'a [[f64; 4]],
}

impl CubicTable<'_> {
    /// Returns the value (`order` 0) or derivative of the given order at `argument`.
    #[must_use]
    pub fn evaluate<R: Real>(&self, order: u32, argument: R) -> R {
        R::interpolate(self, order, argument)
    }

    /// Computes [`CubicTable::evaluate`] for types that carry several values. It walks every
    /// interval with [`Real::select_less`]; its cost is linear in the table's length.
    #[must_use]
    pub fn walk<R: Real>(&self, order: u32, argument: R) -> R {
        let (Some(first), Some(last)) = (self.knots.first(), self.knots.last()) else {
            return R::literal(0.0);
        };
        let mut value = self.end_value(order, 0, *first);
        for (coefficients, &start) in self.coefficients.iter().zip(self.knots) {
            let start = R::literal(start);
            let inside = polynomial(coefficients, order, argument - start);
            value = R::select_less(argument, start, value, inside);
        }
        R::select_less(argument, R::literal(*last), value, self.beyond(order, *last))
    }

    /// Computes [`CubicTable::evaluate`] for types of one value. It finds the interval by
    /// bisection; its cost is logarithmic in the table's length.
    #[must_use]
    pub fn search<R: Real + PartialOrd>(&self, order: u32, argument: R) -> R {
        let (Some(first), Some(last)) = (self.knots.first(), self.knots.last()) else {
            return R::literal(0.0);
        };
        // Written so that NaN takes the same path as in `walk`.
        let is_below = |knot: f64| argument < R::literal(knot);
        if !is_below(*last) {
            return self.beyond(order, *last);
        }
        let begun = self.knots.partition_point(|&knot| !is_below(knot));
        let interval = begun
            .checked_sub(1)
            .and_then(|k| Some((self.coefficients.get(k)?, R::literal(*self.knots.get(k)?))));
        match interval {
            Some((coefficients, start)) => polynomial(coefficients, order, argument - start),
            None => self.end_value(order, 0, *first),
        }
    }

    fn beyond<R: Real>(&self, order: u32, last: f64) -> R {
        self.end_value(order, self.coefficients.len().saturating_sub(1), last)
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

/// Returns the derivative of the given order of c0 + c1 u + c2 u^2 + c3 u^3.
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

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "a table is exact on its knots and beyond its ends")]
mod tests {
    use super::CubicTable;

    /// Natural spline through (0, 0), (1, 1), (3, 0), computed by hand.
    ///
    /// Second derivatives m_0 = m_2 = 0 and, with h_0 = 1, h_1 = 2,
    /// 2 (h_0 + h_1) m_1 = 6 ((0 - 1)/2 - (1 - 0)/1), so m_1 = -3/2.
    const TENT: CubicTable<'static> = CubicTable {
        knots: &[0.0, 1.0, 3.0],
        coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
    };

    const ORDERS: core::ops::Range<u32> = 0..5;

    fn arguments() -> impl Iterator<Item = f64> {
        let awkward = [f64::NEG_INFINITY, -0.0, 1.0 - f64::EPSILON, f64::INFINITY];
        (-400..800).map(|step| f64::from(step) / 128.0).chain(awkward)
    }

    #[test]
    fn search_agrees_with_the_walk_to_the_last_bit() {
        for order in ORDERS {
            for x in arguments() {
                let (found, walked) = (TENT.search(order, x), TENT.walk(order, x));
                assert_eq!(found.to_bits(), walked.to_bits(), "order {order} at {x}");
                #[allow(clippy::cast_possible_truncation)]
                let x = x as f32;
                let (found, walked) = (TENT.search(order, x), TENT.walk(order, x));
                assert_eq!(found.to_bits(), walked.to_bits(), "order {order} at {x} in f32");
            }
        }
    }

    #[test]
    fn knots_are_met_exactly() {
        for (knot, value) in [(0.0, 0.0), (1.0, 1.0), (3.0, 0.0)] {
            assert_eq!(TENT.evaluate::<f64>(0, knot), value);
            assert_eq!(TENT.walk::<f64>(0, knot), value);
        }
    }

    #[test]
    fn two_derivatives_are_continuous_at_an_inner_knot() {
        let step = 1e-9;
        for order in 0..3 {
            let jump: f64 = TENT.evaluate(order, 1.0 + step) - TENT.evaluate(order, 1.0 - step);
            assert!(jump.abs() < 1e-8, "order {order} jumps by {jump}");
        }
        let jump: f64 = TENT.evaluate(3, 1.0 + step) - TENT.evaluate(3, 1.0 - step);
        assert!((jump - 2.25).abs() < 1e-12, "the third derivative is -3/2, then 3/4");
    }

    #[test]
    fn beyond_its_ends_a_table_is_constant() {
        for (x, value) in [(-5.0, 0.0), (-1e-300, 0.0), (3.0 + 1e-9, 0.0), (9.0, 0.0)] {
            assert_eq!(TENT.evaluate::<f64>(0, x), value);
            for order in 1..4 {
                assert_eq!(TENT.evaluate::<f64>(order, x), 0.0);
            }
        }
    }

    #[test]
    fn an_empty_table_is_zero() {
        let empty = CubicTable { knots: &[], coefficients: &[] };
        assert_eq!(empty.search::<f64>(0, 1.0), 0.0);
        assert_eq!(empty.walk::<f64>(0, 1.0), 0.0);
    }

    #[test]
    fn a_nan_takes_the_same_way_in_both() {
        assert_eq!(TENT.search(0, f64::NAN), TENT.walk(0, f64::NAN));
    }
}
