//! Numbers formatted for people.

/// Range in which numbers are written without a power of ten.
const POSITIONAL: std::ops::Range<f64> = 1e-4..1e7;

/// Formats `value` with at most `digits` significant digits: `77.173`, `1.2e-10`.
pub fn number(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return value.to_string();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let power: i32 = exponent.parse().unwrap_or(0);
    if value == 0.0 {
        "0".to_owned()
    } else if POSITIONAL.contains(&value.abs()) {
        let decimals = usize::try_from(digits as i32 - 1 - power).unwrap_or(0);
        trimmed(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{power}", trimmed(mantissa))
    }
}

/// Formats `value` so that it reads back unchanged: `23065.2`, `9.817e-6`.
pub fn exact(value: f64) -> String {
    if value == 0.0 || POSITIONAL.contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_asked_for_and_no_more() {
        let cases = [
            (0.0, 4, "0"),
            (77.173_039, 5, "77.173"),
            (-78.5, 6, "-78.5"),
            (0.000_123_456, 3, "0.000123"),
            (1.234e-10, 2, "1.2e-10"),
            (843.72, 2, "844"),
            (23_065.2, 6, "23065.2"),
            (4.0e12, 3, "4e12"),
            (999.9999, 4, "1000"),
        ];
        for (value, digits, text) in cases {
            assert_eq!(number(value, digits), text);
        }
        assert_eq!(number(f64::NAN, 3), "NaN");
    }

    #[test]
    fn exact_numbers_read_back_the_same() {
        for value in [23_065.2, 9.817e-6, 128.5346, 7.853_600_1e9, 0.0, -1.0] {
            assert_eq!(exact(value).parse(), Ok(value));
        }
    }
}
