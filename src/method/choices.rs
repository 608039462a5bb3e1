//! Choices of `auto` that a run may make differently.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::method_table::Method;

/// Choices of [`Method::Auto`].
///
/// ```
/// use machinist::Simulation;
/// use machinist::method::{Auto, ExplicitMethod};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), machinist::SimulateError> {
/// # #[cfg(feature = "implicit")] {
/// let choices = Auto { explicit: Some(ExplicitMethod::Tsit5), ..Auto::default() };
/// let run = Simulation::new(&Oscillator).auto(choices).run()?;
/// assert!(run.notes[0].starts_with("starts with tsit5"), "{:?}", run.notes);
///
/// assert_eq!("explicit=tsit5".parse(), Ok(choices));
/// # }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Auto {
    /// True to solve linear machines in closed form where that is accurate enough.
    pub exact: bool,
    /// Method while a machine is not stiff; `None` to choose by the machine.
    pub explicit: Option<ExplicitMethod>,
    /// Method while a machine is stiff; `None` to choose by tolerance and number of states.
    pub implicit: Option<ImplicitMethod>,
    /// Loosest relative tolerance of steps. Steps that hold a hundredth skip whole periods of an
    /// oscillation, and their error is then no measure of that of the motion.
    pub loosest: f64,
    /// Loosest relative tolerance of steps where errors add up: over thousands of periods, steps at
    /// 1e-3 end anywhere.
    pub loosest_kept: f64,
}

/// Explicit method of [`Auto`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExplicitMethod {
    /// Taylor series; `dop853` where a machine has none.
    Taylor,
    /// Runge-Kutta pair of order 8.
    Dop853,
    /// Runge-Kutta pair of order 5.
    Tsit5,
}

/// Implicit method of [`Auto`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImplicitMethod {
    /// Rosenbrock method of order 5; `radau` for runs with sensitivities.
    Rodas5p,
    /// Radau IIA of orders 5, 9 and 13.
    Radau,
}

/// A choice of `auto` that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "auto::", serialize_all = "kebab-case")]
pub enum BadChoice {
    /// A part of the text is not of this form.
    #[error(
        "`{0}` is not a choice of auto: give exact, explicit, implicit, loosest or loosest_kept, as in `explicit=tsit5`"
    )]
    UnknownKey(String),
    /// A value is invalid.
    #[error("`{value}` is not a value of {key}: {known}")]
    BadValue {
        /// Key.
        key: &'static str,
        /// Value as given.
        value: String,
        /// Values that are known.
        known: &'static str,
    },
}

impl BadChoice {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

impl Default for Auto {
    fn default() -> Self {
        Self { exact: true, explicit: None, implicit: None, loosest: 1e-3, loosest_kept: 1e-5 }
    }
}

/// Writes choices as they are read.
impl fmt::Display for Auto {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "exact={}", if self.exact { "yes" } else { "no" })?;
        let explicit = self.explicit.map(|method| match method {
            ExplicitMethod::Taylor => "taylor",
            ExplicitMethod::Dop853 => "dop853",
            ExplicitMethod::Tsit5 => "tsit5",
        });
        let implicit = self.implicit.map(|method| match method {
            ImplicitMethod::Rodas5p => "rodas5p",
            ImplicitMethod::Radau => "radau",
        });
        for (key, method) in [("explicit", explicit), ("implicit", implicit)] {
            method.map_or(Ok(()), |method| write!(formatter, ",{key}={method}"))?;
        }
        write!(formatter, ",loosest={:e},loosest_kept={:e}", self.loosest, self.loosest_kept)
    }
}

/// Reads choices such as `explicit=taylor,implicit=radau,exact=no,loosest=1e-2`; those that are not
/// given have their defaults.
impl FromStr for Auto {
    type Err = BadChoice;

    fn from_str(text: &str) -> Result<Self, BadChoice> {
        let mut choices = Self::default();
        for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
            let unknown = || BadChoice::UnknownKey(part.to_owned());
            let (key, value) = part.split_once('=').ok_or_else(unknown)?;
            choices.set(key.trim(), value.trim()).ok_or_else(unknown)??;
        }
        Ok(choices)
    }
}

impl Auto {
    /// Sets one choice; `None` if there is none of this name.
    fn set(&mut self, key: &str, value: &str) -> Option<Result<(), BadChoice>> {
        const SHARES: &str = "numbers above 0 and at most 1";
        let bad = |key, known| BadChoice::BadValue { key, value: value.to_owned(), known };
        let tolerance = || value.parse().ok().filter(|part| *part > 0.0 && *part <= 1.0);
        let known = match key {
            "exact" => {
                let read = match value {
                    "yes" => Some(true),
                    "no" => Some(false),
                    _ => None,
                };
                read.map(|read| self.exact = read).ok_or_else(|| bad("exact", "yes, no"))
            }
            "explicit" => {
                let read = match value {
                    "taylor" => Some(ExplicitMethod::Taylor),
                    "dop853" => Some(ExplicitMethod::Dop853),
                    "tsit5" => Some(ExplicitMethod::Tsit5),
                    _ => None,
                };
                let read = read.ok_or_else(|| bad("explicit", "taylor, dop853, tsit5"));
                read.map(|read| self.explicit = Some(read))
            }
            "implicit" => {
                let read = match value {
                    "rodas5p" => Some(ImplicitMethod::Rodas5p),
                    "radau" => Some(ImplicitMethod::Radau),
                    _ => None,
                };
                let read = read.ok_or_else(|| bad("implicit", "rodas5p, radau"));
                read.map(|read| self.implicit = Some(read))
            }
            "loosest" => {
                let read = tolerance().ok_or_else(|| bad("loosest", SHARES));
                read.map(|read| self.loosest = read)
            }
            "loosest_kept" => {
                let read = tolerance().ok_or_else(|| bad("loosest_kept", SHARES));
                read.map(|read| self.loosest_kept = read)
            }
            _ => return None,
        };
        Some(known)
    }

    /// Returns the relative tolerance of the steps of a method for one requested, in a machine in
    /// which errors add up for a reason, if they do; and why it is tighter than requested, if it is.
    pub(super) fn step_rtol(
        &self,
        method: Method,
        requested: f64,
        keeps_errors: impl FnOnce() -> Option<&'static str>,
    ) -> (f64, Option<&'static str>) {
        if method != Method::Auto || requested <= self.loosest.min(self.loosest_kept) {
            return (requested, None);
        }
        let limit = match keeps_errors() {
            Some(why) => (self.loosest_kept, why),
            None => (self.loosest, "looser steps skip whole oscillations"),
        };
        if requested > limit.0 { (limit.0, Some(limit.1)) } else { (requested, None) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_read_and_refused() {
        let read =
            "explicit=taylor, implicit=radau,exact=no,loosest=0.01,loosest_kept=1e-4".parse();
        let expected = Auto {
            exact: false,
            explicit: Some(ExplicitMethod::Taylor),
            implicit: Some(ImplicitMethod::Radau),
            loosest: 0.01,
            loosest_kept: 1e-4,
        };
        assert_eq!(read, Ok(expected));
        assert_eq!(expected.to_string().parse(), Ok(expected));
        assert_eq!("".parse(), Ok(Auto::default()));
        assert_eq!(Auto::default().to_string(), "exact=yes,loosest=1e-3,loosest_kept=1e-5");
        for (text, message) in [
            ("explicit", "`explicit` is not a choice of auto: give exact, explicit,"),
            ("fast=yes", "`fast=yes` is not a choice of auto"),
            ("explicit=radau", "`radau` is not a value of explicit: taylor, dop853, tsit5"),
            ("implicit=taylor", "`taylor` is not a value of implicit: rodas5p, radau"),
            ("exact=1", "`1` is not a value of exact: yes, no"),
            ("loosest=0", "`0` is not a value of loosest: numbers above 0 and at most 1"),
            ("loosest_kept=NaN", "`NaN` is not a value of loosest_kept: numbers"),
        ] {
            let refused = text.parse::<Auto>().expect_err(text).to_string();
            assert!(refused.starts_with(message), "{refused}");
        }
    }
}
