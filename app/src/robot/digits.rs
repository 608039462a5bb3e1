//! Rounding of numbers in files, by their digits.

/// Digits with which a file writes numbers. Programs write a number of decimals, or of significant
/// digits, and leave zeros at the end out; the longest numbers of a file show both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Digits {
    decimals: i32,
    significant: i32,
}

impl Digits {
    /// Returns the digits of the longest of some numbers, in texts that are separated by spaces.
    pub fn of<'a>(texts: impl Iterator<Item = &'a str>) -> Self {
        let all = texts.flat_map(str::split_whitespace).filter_map(Self::of_number);
        all.fold(Digits::default(), |most, own| Digits {
            decimals: most.decimals.max(own.decimals),
            significant: most.significant.max(own.significant),
        })
    }

    /// Returns the digits of a number; `None` for an integer, which is exact.
    fn of_number(text: &str) -> Option<Self> {
        let mut halves = text.split(['e', 'E']);
        let (mantissa, exponent) = (halves.next()?, halves.next());
        let exponent: i32 = exponent.map_or(Some(0), |text| text.parse().ok())?;
        let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if exponent == 0 && after.is_empty() {
            return None;
        }
        let digits = before.chars().chain(after.chars()).filter(char::is_ascii_digit);
        let significant = digits.skip_while(|digit| *digit == '0').count();
        let decimals = i32::try_from(after.len()).ok()?.checked_sub(exponent)?;
        Some(Digits { decimals, significant: i32::try_from(significant).ok()? })
    }

    /// Returns the sum of the largest roundings of some numbers: each is half a unit of the last decimal
    /// or of the last significant digit of the file, whichever is larger.
    pub fn rounding<'a>(self, numbers: impl Iterator<Item = &'a str>) -> f64 {
        numbers.map(|number| self.of_one(number)).sum()
    }

    fn of_one(self, number: &str) -> f64 {
        let Ok(value) = number.parse::<f64>() else { return 0.0 };
        if Self::of_number(number).is_none() {
            return 0.0;
        }
        let first = if value == 0.0 { i32::MIN / 2 } else { value.abs().log10().floor() as i32 };
        0.5 * 10.0_f64.powi((-self.decimals).max(first + 1 - self.significant))
    }
}

#[cfg(test)]
mod tests {
    use super::Digits;

    fn rounding(file: &str, number: &str) -> f64 {
        Digits::of(std::iter::once(file)).rounding(std::iter::once(number))
    }

    #[test]
    fn roundings_are_half_a_unit_of_the_last_digit() {
        for (file, number, half_unit) in [
            // As `%g` writes them: quarter turns have a zero as sixth digit.
            ("0.00132298 -2.68468 1.5708", "1.5708", 5e-6),
            ("0.00132298 -2.68468 1.5708", "0.0150", 5e-8),
            // As `%.4f` does.
            ("0.0123 1.5708", "0.0123", 5e-5),
            ("0.0123 1.5708", "-0.0000", 5e-5),
            ("6.123e-17 1.571", "6.123e-17", 5e-21),
            ("1.57 2", "2", 0.0),
            ("1.57 2", "-12", 0.0),
            ("12.5e3 1.25e2", "1.25e2", 0.5),
        ] {
            let found = rounding(file, number);
            assert!((found - half_unit).abs() <= 1e-9 * half_unit, "{file}, {number}: {found}");
        }
    }
}
