//! Screening by elementary effects, and linear propagation.

use machinist::Simulation;
use machinist::improve::{Expression, gradient};
use machinist::scatter::{Distribution, Effect, Morris, propagate};
use serde::Serialize;

use super::Results;
use super::inputs::Inputs;
use super::runs::{Outcome, Runner};
use crate::failure::Failure;
use crate::progress::during;

/// Elementary effects on one result.
#[derive(Debug, Serialize)]
pub struct Screened {
    pub of: String,
    pub effects: Vec<ScreenedParameter>,
}

/// Elementary effects of one parameter.
#[derive(Debug, Serialize)]
pub struct ScreenedParameter {
    pub parameter: String,
    /// Mean of absolute effects, per unit of probability.
    pub mean_absolute: f64,
    /// Half the width of its interval.
    pub error: f64,
    /// Mean of effects.
    pub mean: f64,
    /// Standard deviation of effects.
    pub deviation: f64,
    /// Number of effects.
    pub count: usize,
}

/// Screens parameters by paths of Morris' design.
pub fn morris(
    paths: usize,
    runner: &Runner<'_>,
    results: &Results,
) -> Result<Vec<Screened>, Failure> {
    let (names, command) = (&runner.inputs().names, runner.settings());
    let design = Morris { dimensions: names.len(), paths, seed: command.seed };
    let length = names.len() + 1;
    let points: Vec<Vec<f64>> = (0..paths).flat_map(|path| design.path(path)).collect();
    let outcomes = during("screening", || runner.outcomes(&points, |_| {}))?;
    let wrong = |message: String| Failure::unsuccessful(format!("--morris: {message}"), "");
    let value = |outcome: &Outcome, index: usize| {
        outcome.values.as_ref().map_or(f64::NAN, |values| values[index])
    };
    let mut all = Vec::new();
    for (index, (of, _)) in results.of.iter().enumerate() {
        let values: Vec<Vec<f64>> = outcomes
            .chunks_exact(length)
            .map(|path| path.iter().map(|outcome| value(outcome, index)).collect())
            .collect();
        let effects = design.effects(&values, command.confidence);
        let effects = effects.map_err(|error| wrong(error.to_string()))?;
        let told = |(name, effect): (&String, &Effect)| ScreenedParameter {
            parameter: name.clone(),
            mean_absolute: effect.mean_absolute,
            error: effect.error,
            mean: effect.mean,
            deviation: effect.deviation,
            count: effect.count,
        };
        let effects = names.iter().zip(&effects).map(told).collect();
        all.push(Screened { of: of.clone(), effects });
    }
    Ok(all)
}

/// Linear propagation to one result.
#[derive(Debug, Serialize)]
pub struct Linearized {
    /// Text of the expression.
    pub of: String,
    /// Value at the means of the parameters.
    pub value: f64,
    /// Standard deviation to first order.
    pub deviation: f64,
    /// Contributions of all parameters.
    pub shares: Vec<LinearShare>,
    /// Parameters without a derivative, with reasons.
    pub left_out: Vec<String>,
}

/// Contribution of one parameter.
#[derive(Debug, Serialize)]
pub struct LinearShare {
    /// Name of the parameter.
    pub parameter: String,
    /// Derivative of the result.
    pub slope: f64,
    /// Change of the result for one standard deviation.
    pub contribution: f64,
    /// Share of the variance.
    pub share: f64,
}

/// Propagates deviations about the means of the parameters.
pub fn linear(
    simulation: &Simulation<'_>,
    inputs: &Inputs,
    results: &Results,
) -> Result<Vec<Linearized>, Failure> {
    let each = results.of.iter();
    each.map(|of| during("differentiating", || propagated(simulation, inputs, of))).collect()
}

/// Propagates deviations about the means of the parameters to one result.
pub fn propagated(
    simulation: &Simulation<'_>,
    inputs: &Inputs,
    (of, expression): &(String, Expression),
) -> Result<Linearized, Failure> {
    let means: Vec<f64> = inputs.distributions.iter().map(Distribution::mean).collect();
    let simulation = simulation.clone().parameters(&inputs.variant(&means));
    let deviations: Vec<f64> = inputs.distributions.iter().map(Distribution::deviation).collect();
    let found = gradient(&simulation, expression)?;
    let slope = |name: &String| {
        let mut slopes = found.gradient.slopes.iter();
        let own = slopes.find(|slope| slope.is_parameter && slope.name == *name);
        own.map_or(f64::NAN, |slope| slope.value)
    };
    let slopes: Vec<f64> = inputs.names.iter().map(slope).collect();
    let propagation = propagate(&slopes, &deviations, &inputs.correlation);
    let shares = inputs.names.iter().zip(&slopes).zip(&propagation.shares);
    let shares = shares.map(|((name, slope), share)| LinearShare {
        parameter: name.clone(),
        slope: *slope,
        contribution: share.contribution,
        share: share.share,
    });
    let is_input = |(name, _): &&(String, String)| inputs.names.contains(name);
    let left_out = found.left_out.iter().filter(is_input);
    Ok(Linearized {
        of: of.clone(),
        value: found.value,
        deviation: propagation.deviation,
        shares: shares.collect(),
        left_out: left_out.map(|(name, why)| format!("{name} {why}")).collect(),
    })
}
