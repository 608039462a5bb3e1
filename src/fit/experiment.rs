//! What was measured, and how.

/// What was measured in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// When, ascending and not before the start of the run \[s\].
    pub times: Vec<f64>,
    /// Outputs or states by name, with a value for each time; NaN where there is none.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A measured run with what the machine was set to.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment {
    /// What it is called by.
    pub name: String,
    /// What was measured.
    pub measured: Measured,
    /// Parameters and initial values of states that differ from those of the fit, by name and
    /// in SI units.
    pub given: Vec<(String, f64)>,
    /// Start of the run \[s\], if it is not that of the fit.
    pub from: Option<f64>,
    /// Standard deviations of measured columns that are known. What is known of a column in one
    /// experiment has to be so in all.
    pub noise: Vec<(String, Noise)>,
}

/// Standard deviations of measured values.
#[derive(Debug, Clone, PartialEq)]
pub enum Noise {
    /// sqrt(absolute^2 + (share value)^2).
    Of {
        /// In the unit of the values.
        absolute: f64,
        /// Of the value measured.
        share: f64,
    },
    /// Of each value its own, in their unit.
    Each(Vec<f64>),
}

impl Experiment {
    /// A measured run with the settings of the fit.
    #[must_use]
    pub fn new(name: &str, measured: Measured) -> Self {
        let name = name.to_owned();
        Self { name, measured, given: Vec::new(), from: None, noise: Vec::new() }
    }

    /// What is known of the noise of a column.
    #[must_use]
    pub fn noise_of(&self, column: &str) -> Option<&Noise> {
        self.noise.iter().find(|(name, _)| name == column).map(|(_, noise)| noise)
    }
}

impl Noise {
    /// The same for all values.
    #[must_use]
    pub fn constant(absolute: f64) -> Self {
        Self::Of { absolute, share: 0.0 }
    }

    /// The standard deviation of the value of a row.
    #[must_use]
    pub fn at(&self, row: usize, value: f64) -> f64 {
        match self {
            Self::Of { absolute, share } => absolute.hypot(share * value),
            Self::Each(all) => all.get(row).copied().unwrap_or(f64::NAN),
        }
    }
}
