//! Curves through the knots of a table.

/// Kind of curve between the knots of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Course {
    /// A natural cubic spline: twice differentiable.
    Natural,
    /// Straight lines, with a kink at each knot.
    Linear,
    /// Cubics that rise and fall only where the knots do: once differentiable.
    Monotone,
}

/// Returns the coefficients of the curve, as [`natural`] does.
pub fn through(course: Course, x: &[f64], y: &[f64]) -> Option<Vec<[f64; 4]>> {
    match course {
        Course::Natural => natural(x, y),
        Course::Linear => cubics(x, y, |d, _| d.iter().map(|d| [*d, *d]).collect()),
        Course::Monotone => cubics(x, y, monotone),
    }
}

/// Returns cubics with given slopes at both ends of each interval, from the slopes of its chords
/// and its lengths.
fn cubics(
    x: &[f64],
    y: &[f64],
    slopes: impl Fn(&[f64], &[f64]) -> Vec<[f64; 2]>,
) -> Option<Vec<[f64; 4]>> {
    if x.len() < 2 || x.len() != y.len() || x.windows(2).any(|pair| pair[0] >= pair[1]) {
        return None;
    }
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let d: Vec<f64> = y.windows(2).zip(&h).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    let rows = slopes(&d, &h).into_iter().enumerate().map(|(k, [before, after])| {
        let c2 = (3.0 * d[k] - 2.0 * before - after) / h[k];
        let c3 = (before + after - 2.0 * d[k]) / (h[k] * h[k]);
        [y[k], before, c2, c3]
    });
    let rows: Vec<[f64; 4]> = rows.collect();
    rows.iter().flatten().all(|c| c.is_finite()).then_some(rows)
}

/// Returns the slopes at the ends of intervals: 0 where the slopes of chords change sign, else
/// their weighted harmonic mean. At the ends of the table they are given by three-point formulas,
/// limited to keep the sign (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984; Moler,
/// Numerical Computing with MATLAB, section 3.4).
fn monotone(d: &[f64], h: &[f64]) -> Vec<[f64; 2]> {
    let last = d.len();
    let end = |near: f64, far: f64, d0: f64, d1: f64| {
        let slope = ((2.0 * near + far) * d0 - near * d1) / (near + far);
        if slope * d0 <= 0.0 {
            0.0
        } else if d0 * d1 <= 0.0 && slope.abs() > 3.0 * d0.abs() {
            3.0 * d0
        } else {
            slope
        }
    };
    let at = |knot: usize| match knot {
        _ if last == 1 => d[0],
        0 => end(h[0], h[1], d[0], d[1]),
        knot if knot == last => end(h[last - 1], h[last - 2], d[last - 1], d[last - 2]),
        knot if d[knot - 1] * d[knot] <= 0.0 => 0.0,
        knot => {
            let (w1, w2) = (2.0 * h[knot] + h[knot - 1], h[knot] + 2.0 * h[knot - 1]);
            (w1 + w2) / (w1 / d[knot - 1] + w2 / d[knot])
        }
    };
    (0..last).map(|k| [at(k), at(k + 1)]).collect()
}

/// Returns the coefficients of the natural cubic spline through (x, y), one row per interval:
/// y = c0 + c1 u + c2 u^2 + c3 u^3 with u = x - x_k.
///
/// The second derivatives m_k at the knots solve, with h_k = x_(k+1) - x_k,
/// h_(k-1) m_(k-1) + 2 (h_(k-1) + h_k) m_k + h_k m_(k+1)
///   = 6 (d_k - d_(k-1)), d_k = (y_(k+1) - y_k)/h_k, m_0 = m_N = 0
/// (Stoer and Bulirsch, Introduction to Numerical Analysis, 2.4.2). The matrix is
/// diagonally dominant, so that elimination needs no pivots.
///
/// Returns `None` if there are fewer than two points, if they are not sorted, or if they are so
/// far apart that a coefficient is not finite.
pub fn natural(x: &[f64], y: &[f64]) -> Option<Vec<[f64; 4]>> {
    if x.len() < 2 || x.len() != y.len() || x.windows(2).any(|pair| pair[0] >= pair[1]) {
        return None;
    }
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slope: Vec<f64> = y.windows(2).zip(&h).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    let m = second_derivatives(&h, &slope);
    let rows = (0..h.len()).map(|k| {
        let c1 = slope[k] - h[k] * (2.0 * m[k] + m[k + 1]) / 6.0;
        [y[k], c1, m[k] / 2.0, (m[k + 1] - m[k]) / (6.0 * h[k])]
    });
    let rows: Vec<[f64; 4]> = rows.collect();
    rows.iter().flatten().all(|c| c.is_finite()).then_some(rows)
}

/// Solves for the inner knots by the Thomas algorithm; 0 at both ends.
fn second_derivatives(h: &[f64], slope: &[f64]) -> Vec<f64> {
    let last = h.len();
    let mut m = vec![0.0; last + 1];
    let mut upper = vec![0.0; last + 1];
    for k in 1..last {
        let pivot = 2.0 * (h[k - 1] + h[k]) - h[k - 1] * upper[k - 1];
        upper[k] = h[k] / pivot;
        m[k] = (6.0 * (slope[k] - slope[k - 1]) - h[k - 1] * m[k - 1]) / pivot;
    }
    for k in (1..last).rev() {
        m[k] -= upper[k] * m[k + 1];
    }
    m
}

/// Number of rows on either side of an interval that its curve is compared with. The influence of
/// a row on a natural spline decays by 2 - sqrt(3) = 0.27 per row, so rows beyond have less than
/// a hundredth.
const ROWS_AROUND: usize = 4;

/// The part of a curve that overshoots its data most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overshoot {
    /// Index of the first row of its interval.
    pub row: usize,
    /// The extreme value of the curve.
    pub reached: f64,
    /// Least and greatest value of the neighbouring rows.
    pub range: [f64; 2],
}

/// Finds where a curve leaves the range of the neighbouring rows most, if by more than it could
/// with evenly spaced rows.
///
/// A cardinal cubic spline through data within +-1 stays within its Lebesgue constant, (1 + 3
/// sqrt(3))/4 = 1.549 (Richards, Aequationes Math. 9, 1973), so it leaves a range by at most
/// (1.549 - 1)/2 = 0.27 of it.
pub fn overshoot(x: &[f64], y: &[f64], coefficients: &[[f64; 4]]) -> Option<Overshoot> {
    let most = 3.0 * (3.0_f64.sqrt() - 1.0) / 8.0;
    let mut furthest: Option<(f64, Overshoot)> = None;
    for (row, (cubic, ends)) in coefficients.iter().zip(x.windows(2)).enumerate() {
        let around = &y[(row + 1).saturating_sub(ROWS_AROUND)..y.len().min(row + 1 + ROWS_AROUND)];
        let low = around.iter().copied().fold(f64::INFINITY, f64::min);
        let high = around.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for reached in extremes(cubic, ends[1] - ends[0]) {
            let beyond = (reached - high).max(low - reached);
            // If all rows are equal, the remaining influence of a jump elsewhere does not count.
            if high > low
                && beyond > most * (high - low)
                && furthest.as_ref().is_none_or(|(far, _)| beyond > *far)
            {
                furthest = Some((beyond, Overshoot { row, reached, range: [low, high] }));
            }
        }
    }
    furthest.map(|(_, overshoot)| overshoot)
}

/// Iterates over the values of a cubic where its slope is zero within (0, h).
fn extremes(&[c0, c1, c2, c3]: &[f64; 4], h: f64) -> impl Iterator<Item = f64> {
    // Solves c1 + 2 c2 u + 3 c3 u^2 = 0, first with the sum of equal signs.
    let root = (c2 * c2 - 3.0 * c1 * c3).sqrt();
    let sum = -(c2 + root.copysign(c2));
    let roots = [sum / (3.0 * c3), c1 / sum];
    let inside = roots.into_iter().filter(move |u| *u > 0.0 && *u < h);
    inside.map(move |u| c0 + u * (c1 + u * (c2 + u * c3)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the overshoot for a step from 0 to 1 between rows 3 and 4, which are evenly spaced
    /// except for the step.
    fn step_within(width: f64) -> Option<Overshoot> {
        let x: Vec<f64> =
            (0..8).map(|k| f64::from(k) + if k > 3 { width - 1.0 } else { 0.0 }).collect();
        let y: Vec<f64> = (0..8).map(|k| f64::from(u8::from(k > 3))).collect();
        overshoot(&x, &y, &natural(&x, &y)?)
    }

    #[test]
    fn a_step_that_is_shorter_than_its_neighbours_overshoots_the_more_the_shorter() {
        assert_eq!(step_within(1.0), None);
        let mut before = 0.0;
        for width in [0.1, 0.01, 1e-3, 1e-6] {
            let found = step_within(width).expect("an overshoot");
            let beyond = (found.reached - 1.0).max(-found.reached);
            assert!(beyond > before, "{width}: {found:?}");
            assert_eq!(found.range.map(f64::to_bits), [0.0_f64, 1.0].map(f64::to_bits));
            assert!(found.row == 2 || found.row == 4, "beside the step: {found:?}");
            // A step of slope 1/width between chords of slope 0: the spline overshoots by a
            // fraction of slope times the neighbour's length.
            assert!((0.1..0.3).contains(&(beyond * width)), "{width}: {beyond}");
            before = beyond;
        }
    }

    #[test]
    fn what_a_curve_reaches_is_found_between_samples_too() {
        let x = [0.0, 1.0, 1.001, 2.0];
        let y = [0.0, 0.0, 100.0, 100.0];
        let rows = natural(&x, &y).expect("a spline");
        let found = overshoot(&x, &y, &rows).expect("an overshoot");
        let beyond = |value: f64| (value - 100.0).max(-value);
        let ends = [(0, 1.0), (2, 0.999)];
        let sampled = ends.into_iter().flat_map(|(row, length)| {
            let rows = &rows;
            (0..1000).map(move |k| beyond(at(&rows[row], length * f64::from(k) / 1000.0)[0]))
        });
        let (greatest, reached) = (sampled.fold(0.0, f64::max), beyond(found.reached));
        assert!(greatest <= reached && greatest > reached * (1.0 - 1e-5), "{greatest} {found:?}");
    }

    #[test]
    fn no_data_at_even_spaces_overshoot() {
        // The sign of each row is the worst for one place, and many others.
        let x: Vec<f64> = (0..14).map(f64::from).collect();
        for signs in 0..1 << 14 {
            let y: Vec<f64> = (0..14).map(|k| f64::from(signs >> k & 1)).collect();
            let rows = natural(&x, &y).expect("a spline");
            assert_eq!(overshoot(&x, &y, &rows), None, "{y:?}");
        }
    }

    #[test]
    fn smooth_data_at_uneven_spaces_do_not_overshoot() {
        for ratio in [1.1, 1.5, 2.0] {
            let mut x = vec![0.0];
            for k in 0..40 {
                let last = x[k];
                x.push(last + if k % 2 == 0 { 0.3 } else { 0.3 / ratio });
            }
            let y: Vec<f64> = x.iter().map(|x: &f64| x.sin() + 0.2 * (3.0 * x).cos()).collect();
            let rows = natural(&x, &y).expect("a spline");
            assert_eq!(overshoot(&x, &y, &rows), None, "{ratio}");
        }
    }

    /// Returns the value and the first two derivatives of a row at u.
    fn at(c: &[f64; 4], u: f64) -> [f64; 3] {
        [
            c[0] + u * (c[1] + u * (c[2] + u * c[3])),
            c[1] + u * (2.0 * c[2] + u * 3.0 * c[3]),
            2.0 * c[2] + 6.0 * c[3] * u,
        ]
    }

    #[test]
    fn three_points_give_the_spline_worked_by_hand() {
        // m_1 = 6 (-1 - 1)/(2 (1 + 1)) = -3.
        let rows = natural(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0]);
        assert_eq!(rows, Some(vec![[0.0, 1.5, 0.0, -0.5], [1.0, 0.0, -1.5, 0.5]]));
    }

    #[test]
    fn a_straight_line_is_reproduced() {
        let x = [-1.0, 0.5, 2.0, 4.0];
        let y = x.map(|x| 2.0 * x - 1.0);
        for (row, (x, y)) in natural(&x, &y).unwrap_or_default().iter().zip(x.iter().zip(y)) {
            assert!((row[0] - y).abs() < 1e-14 && (row[1] - 2.0).abs() < 1e-14, "{x}");
            assert!(row[2].abs() < 1e-14 && row[3].abs() < 1e-14);
        }
    }

    #[test]
    fn value_slope_and_curvature_are_continuous_and_curvature_ends_at_zero() {
        let x = [0.0, 0.3, 1.0, 1.1, 2.5, 4.0];
        let y = [1.0, -2.0, 0.5, 0.4, 3.0, -1.0];
        let rows = natural(&x, &y).unwrap_or_default();
        assert_eq!(rows.len(), 5);
        for k in 1..5 {
            let (left, right) = (at(&rows[k - 1], x[k] - x[k - 1]), at(&rows[k], 0.0));
            for (left, right) in left.iter().zip(right) {
                assert!((left - right).abs() < 1e-10 * (1.0 + right.abs()), "knot {k}");
            }
        }
        assert!((at(&rows[4], 1.5)[0] + 1.0).abs() < 1e-12);
        assert!(at(&rows[0], 0.0)[2].abs() < 1e-15);
        assert!(at(&rows[4], 1.5)[2].abs() < 1e-10);
    }

    #[test]
    fn points_that_make_no_spline_are_refused() {
        assert_eq!(natural(&[0.0], &[0.0]), None);
        assert_eq!(natural(&[0.0, 0.0], &[0.0, 1.0]), None);
        assert_eq!(natural(&[0.0, 1e-300], &[0.0, 1e300]), None);
    }
}
