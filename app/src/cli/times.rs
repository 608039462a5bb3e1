//! Output times of a run, as options take them.

use machinist::Simulation;

use super::amount::Amount;
use super::range::ends;
use crate::failure::Failure;

/// Value of `--times`.
#[derive(Debug, Clone, PartialEq)]
pub enum Times {
    /// Listed times.
    Listed(Vec<Amount>),
    /// Times from the first after the start to the last, at equal ratios of the time since the
    /// start.
    Ratios([Amount; 2]),
}

/// Parses `0,0.1,0.5` or `1e-3..10:log`.
pub fn times(text: &str) -> Result<Times, String> {
    const EXAMPLE: &str = "write it as 0,0.1,0.5 or 1e-3..10:log";
    if text.contains("..") {
        let (values, spacing) = text.rsplit_once(':').unwrap_or((text, ""));
        if spacing != "log" {
            return Err(format!("a range of times must be logarithmic; {EXAMPLE}"));
        }
        return ends(values, EXAMPLE).map(Times::Ratios);
    }
    let times = text.split(',').map(Amount::parse).collect::<Result<Vec<_>, _>>()?;
    if times.len() < 2 || times.windows(2).any(|pair| pair[0].value >= pair[1].value) {
        return Err(format!("give two or more times that increase; {EXAMPLE}"));
    }
    Ok(Times::Listed(times))
}

impl Times {
    /// Prepares a run at these times, which ends at the last of them unless the options set the
    /// end.
    pub fn asked_of<'a>(
        &self,
        run: Simulation<'a>,
        [from, until]: [Option<f64>; 2],
        points: Option<usize>,
    ) -> Result<Simulation<'a>, Failure> {
        let defaults = run.simulator().run_defaults();
        let from = from.unwrap_or(defaults.from);
        let all = match self {
            Self::Listed(times) => times.as_slice(),
            Self::Ratios(ends) => ends.as_slice(),
        };
        all.iter().try_for_each(|time| time.check("a time", "s"))?;
        let times: Vec<f64> = match self {
            Self::Listed(times) => {
                if points.is_some() {
                    let message = "--points: `--times` lists the output times";
                    return Err(Failure::input(message, "leave one of them out"));
                }
                times.iter().map(|time| time.value).collect()
            }
            Self::Ratios([first, last]) => {
                let points = points.unwrap_or(defaults.points);
                let (first, last) = (first.value - from, last.value - from);
                if !(first > 0.0 && last > first && points >= 3) {
                    let message = format!(
                        "--times: {points} logarithmic times cannot lead from {first} s to \
                         {last} s after the start"
                    );
                    return Err(Failure::input(
                        message,
                        "the first time must be after the start, the last after the first",
                    ));
                }
                let ratios = (points - 2) as f64;
                let grown = |index: usize| first * (last / first).powf(index as f64 / ratios);
                let between = (0..points - 2).map(|index| from + grown(index).min(last));
                std::iter::once(from).chain(between).chain([from + last]).collect()
            }
        };
        let last = times.last().copied().unwrap_or(defaults.until);
        Ok(run.until(until.unwrap_or(last)).times(&times))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_a_list_or_a_range_at_equal_ratios() {
        let numbers = |text| match times(text) {
            Ok(Times::Listed(all)) => all.iter().map(|time| time.value).collect::<Vec<_>>(),
            other => panic!("{other:?}"),
        };
        assert_eq!(numbers("0,0.1, 0.5"), [0.0, 0.1, 0.5]);
        assert!(matches!(times("1e-3..10:log"), Ok(Times::Ratios(_))));
        for (bad, reason) in [
            ("0", "two or more"),
            ("0,0.2,0.1", "increase"),
            ("0,x", "not a number"),
            ("0..1", "logarithmic"),
            ("0..1:lin", "logarithmic"),
        ] {
            assert!(times(bad).unwrap_err().contains(reason), "{bad}");
        }
    }
}
