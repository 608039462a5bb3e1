//! Derivatives of functions without emitted derivatives, by extrapolated differences.

/// Levels of extrapolation; each step is half the previous one.
const LEVELS: usize = 10;
/// Largest step, relative to the size of the argument.
pub const LARGEST: f64 = 0.05;
/// Ratio of an error to the smallest one found at which the search ends.
const WORSE: f64 = 4.0;

/// Returns the derivatives at 0 of all components of `f`, whose argument has the given size.
///
/// Uses central differences with decreasing steps h, extrapolated to h = 0 (C. J. F. Ridders,
/// Accurate computation of F'(x), Advances in Engineering Software 4, 1982). Each component takes
/// the entry of the table with the least difference to its neighbours. Linear functions are
/// differentiated to rounding, smooth ones to about 1e-12; at a kink the result is the mean of both
/// slopes.
pub(super) fn derivative(size: f64, count: usize, f: impl FnMut(f64) -> Vec<f64>) -> Vec<f64> {
    changes(size, count, f).into_iter().map(|(value, _)| value).collect()
}

/// Does the same, and returns with each derivative the difference to its neighbours in the table as
/// an error estimate: unbounded where the differences do not converge.
pub fn changes(size: f64, count: usize, mut f: impl FnMut(f64) -> Vec<f64>) -> Vec<(f64, f64)> {
    let steps: Vec<f64> =
        (0..LEVELS).map(|level| LARGEST * size * 0.5f64.powi(level as i32)).collect();
    let differences: Vec<Vec<f64>> = steps
        .iter()
        .map(|step| {
            let (ahead, behind) = (f(*step), f(-step));
            (0..count).map(|i| (ahead[i] - behind[i]) / (2.0 * step)).collect()
        })
        .collect();
    (0..count)
        .map(|index| extrapolated(&differences.iter().map(|row| row[index]).collect::<Vec<_>>()))
        .collect()
}

/// Returns the best entry of the table of extrapolated differences, whose error is a series in h^2,
/// and the distance to its neighbours.
fn extrapolated(differences: &[f64]) -> (f64, f64) {
    let mut best = differences.first().copied().unwrap_or(f64::NAN);
    let mut least = f64::INFINITY;
    let mut previous = vec![best];
    for difference in differences.iter().skip(1) {
        let mut row = vec![*difference];
        let mut factor = 1.0;
        for order in 1..=previous.len() {
            factor *= 4.0;
            let (fine, coarse) = (row[order - 1], previous[order - 1]);
            let value = fine + (fine - coarse) / (factor - 1.0);
            let error = (value - fine).abs().max((value - coarse).abs());
            if error < least {
                (least, best) = (error, value);
            }
            row.push(value);
        }
        let corner = (row[row.len() - 1] - previous[previous.len() - 1]).abs();
        if least == 0.0 || corner >= WORSE * least {
            break;
        }
        previous = row;
    }
    (best, least)
}

#[cfg(test)]
mod tests {
    use super::derivative;

    #[test]
    fn smooth_functions_have_derivatives_of_twelve_digits() {
        let at = |x: f64| vec![(1.0 + x).sin(), (2.0 * x).exp(), 3.0 * x + 1e6, x.powi(3), 7.0];
        let found = derivative(1.0, 5, at);
        for (found, exact) in found.iter().zip([1.0f64.cos(), 2.0, 3.0, 0.0, 0.0]) {
            let tolerance = if exact > 2.5 { 1e-8 } else { 1e-11 };
            assert!((found - exact).abs() <= tolerance, "{found} is not {exact}");
        }
    }

    #[test]
    fn a_sharp_bend_within_the_first_steps_is_resolved() {
        let found = derivative(1.0, 1, |x| vec![(200.0 * x).tanh()]);
        assert!((found[0] / 200.0 - 1.0).abs() < 1e-5, "{found:?}");
    }
}
