//! Measured data and the settings of experiments.

/// Data measured in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Times, ascending and not before the start of the run \[s\].
    pub times: Vec<f64>,
    /// Names of outputs or states, with a value for each time; NaN where there is none.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A measured run with its settings.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment {
    /// Name of the experiment.
    pub name: String,
    /// Measured data.
    pub measured: Measured,
    /// Parameters and initial values that differ from those of the fit, by name and in SI units.
    pub given: Vec<(String, f64)>,
    /// Start of the run \[s\], if it is not that of the fit.
    pub from: Option<f64>,
    /// Known standard deviations of measured columns. A column whose noise is known in one
    /// experiment must have known noise in all.
    pub noise: Vec<(String, Noise)>,
}

/// Standard deviations of measured values.
#[derive(Debug, Clone, PartialEq)]
pub enum Noise {
    /// sqrt(absolute^2 + (share value)^2).
    Of {
        /// Absolute part, in the unit of the values.
        absolute: f64,
        /// Relative part, as a fraction of the measured value.
        share: f64,
    },
    /// One standard deviation for each value, in its unit.
    Each(Vec<f64>),
}

impl Experiment {
    /// Creates an experiment with the settings of the fit.
    #[must_use]
    pub fn new(name: &str, measured: Measured) -> Self {
        let name = name.to_owned();
        Self { name, measured, given: Vec::new(), from: None, noise: Vec::new() }
    }

    /// Returns the noise of a column, if it is known.
    #[must_use]
    pub fn noise_of(&self, column: &str) -> Option<&Noise> {
        self.noise.iter().find(|(name, _)| name == column).map(|(_, noise)| noise)
    }
}

impl Noise {
    /// Returns a constant standard deviation.
    #[must_use]
    pub fn constant(absolute: f64) -> Self {
        Self::Of { absolute, share: 0.0 }
    }

    /// Returns the standard deviation of the value in a row.
    #[must_use]
    pub fn at(&self, row: usize, value: f64) -> f64 {
        match self {
            Self::Of { absolute, share } => absolute.hypot(share * value),
            Self::Each(all) => all.get(row).copied().unwrap_or(f64::NAN),
        }
    }
}
