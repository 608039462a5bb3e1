//! Roots accurate to the last bit.

/// Returns the place between `low` and `high` at which `is_below` turns from true to false, by
/// bisection until the interval contains no number between its ends.
pub(super) fn turning_point(low: f64, high: f64, is_below: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (low, high);
    loop {
        let middle = f64::midpoint(low, high);
        // This also ends if an end is NaN.
        if !(low < middle && middle < high) {
            return high;
        }
        if is_below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::turning_point;

    #[test]
    fn a_root_is_found_to_the_last_bit() {
        let root = turning_point(1.0, 2.0, |x| x * x < 2.0);
        assert!((root - 2.0f64.sqrt()).abs() <= f64::EPSILON);
        assert!(turning_point(0.0, 3.0, |_| true) >= 3.0);
        assert!(turning_point(f64::NAN, 1.0, |_| true) <= 1.0);
    }
}
