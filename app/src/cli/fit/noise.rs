//! Noise of a column, as the command line and experiments give it.

use machinist::fit::Noise;

/// Parses a standard deviation: `2e-4`, `2 %` of the measured value, or `2e-4 + 2 %`.
pub fn noise(text: &str) -> Result<Noise, String> {
    const EXAMPLE: &str = "write it as a number in the unit of the column, relative to the \
                           measured value, or both: 0.02, 1 %, 0.02 + 1 %";
    let (mut absolute, mut share) = (0.0, 0.0);
    for part in text.split(" + ").flat_map(|part| split_plain(part.trim())) {
        let (number, place, factor) = match part.strip_suffix('%') {
            Some(number) => (number, &mut share, 0.01),
            None => (part, &mut absolute, 1.0),
        };
        let value: f64 = number.trim().parse().map_err(|_| EXAMPLE)?;
        if *place != 0.0 {
            return Err(EXAMPLE.to_owned());
        }
        if !(value.is_finite() && value > 0.0) {
            return Err(format!("{value} is not above 0"));
        }
        *place = factor * value;
    }
    Ok(Noise::Of { absolute, share })
}

/// Splits at each `+` that is not the sign of an exponent.
fn split_plain(text: &str) -> Vec<&str> {
    let is_between = |(at, _): &(usize, &str)| {
        let before = text[..*at].trim_end();
        !before.is_empty() && !before.ends_with(['e', 'E'])
    };
    match text.match_indices('+').find(is_between) {
        None => vec![text],
        Some((at, _)) => vec![text[..at].trim(), text[at + 1..].trim()],
    }
}

/// Parses `output=noise`, as `--sigma` takes it.
pub fn of_output(text: &str) -> Result<(String, Noise), String> {
    let (name, value) =
        text.split_once('=').ok_or("write it as OUTPUT=VALUE, such as twist=2e-4 or twist=1%")?;
    let noise = noise(value).map_err(|why| format!("{}: {why}", name.trim()))?;
    Ok((name.trim().to_owned(), noise))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_absolute_relative_or_both() {
        let of = |absolute, share| Ok(Noise::Of { absolute, share });
        assert_eq!(noise("2e-4"), of(2e-4, 0.0));
        assert_eq!(noise("2 %"), of(0.0, 0.02));
        for both in ["1e+2 + 2 %", "1e+2+2%", "2% + 100"] {
            assert_eq!(noise(both), of(100.0, 0.02), "{both}");
        }
        for bad in ["", "x", "0", "-1", "1 + 2", "1 % + 2 %", "inf", "1 [m]", "1+2+3"] {
            assert!(noise(bad).is_err(), "{bad}");
        }
        assert_eq!(of_output("a.b = 3"), Ok(("a.b".to_owned(), Noise::constant(3.0))));
        assert!(of_output("a.b").is_err());
    }
}
