//! Answer of `machinist linearize` as data.

use machinist::linear_analysis::{Estimator, Hidden, Regulator, StateSpace};
use machinist_contract::Simulator;
use num_complex::Complex64;
use serde::Serialize;

use super::Designs;
use crate::failure::Failure;
use crate::matrices::Entry;

/// Output of `--json`.
#[derive(Serialize)]
pub struct Answer<'a> {
    scene: &'a str,
    #[serde(skip)]
    pub title: &'a str,
    pub place: String,
    #[serde(flatten)]
    pub model: &'a StateSpace,
    /// Poles and zeros, as real and imaginary part.
    pub poles: Vec<[f64; 2]>,
    pub zeros: Vec<[f64; 2]>,
    pub uncontrollable: Vec<Hidden>,
    pub unobservable: Vec<Hidden>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lqr: Option<&'a Regulator>,
    #[serde(skip_serializing_if = "Option::is_none")]
    kalman: Option<&'a Estimator>,
}

impl<'a> Answer<'a> {
    pub fn new(
        simulator: &'a dyn Simulator<f64>,
        place: String,
        model: &'a StateSpace,
        designs: &'a Designs,
    ) -> Result<Self, Failure> {
        let pairs = |values: Vec<Complex64>| values.iter().map(|s| [s.re, s.im]).collect();
        Ok(Self {
            scene: simulator.name(),
            title: simulator.title(),
            place,
            model,
            poles: pairs(model.poles()?),
            zeros: pairs(model.zeros()?),
            uncontrollable: model.uncontrollable()?,
            unobservable: model.unobservable()?,
            lqr: designs.regulator.as_ref(),
            kalman: designs.estimator.as_ref(),
        })
    }

    /// Returns the name of the scene.
    pub fn scene(&self) -> &str {
        self.scene
    }

    /// Returns the answer as JSON.
    pub fn json(&self) -> Result<String, Failure> {
        serde_json::to_string_pretty(self).map_err(|error| Failure::unsuccessful(error, ""))
    }

    /// Returns the named matrices of a `.mat` or `.npz` file.
    pub fn entries(&self) -> Vec<(&'static str, Entry)> {
        let model = self.model;
        let (n, m) = (model.states.len(), model.inputs.len());
        let matrix = |rows: &Vec<Vec<f64>>, columns| Entry::Matrix(rows.clone(), columns);
        let mut entries = vec![
            ("A", matrix(&model.a, n)),
            ("B", matrix(&model.b, m)),
            ("C", matrix(&model.c, n)),
            ("D", matrix(&model.d, m)),
            // MATLAB takes a period of 0 for continuous time.
            ("Ts", Entry::number(model.sampling.map_or(0.0, |sampling| sampling.period))),
            ("drift", Entry::column(&model.drift)),
            ("scene", Entry::Text(self.scene.to_owned())),
            ("place", Entry::Text(self.place.clone())),
        ];
        let signals = [
            (["states", "state_units", "x0"], &model.states),
            (["inputs", "input_units", "u0"], &model.inputs),
            (["outputs", "output_units", "y0"], &model.outputs),
        ];
        for ([names, units, values], signals) in signals {
            let of = |text: fn(&machinist::linear_analysis::Signal) -> &String| {
                Entry::Names(signals.iter().map(|signal| text(signal).clone()).collect())
            };
            entries.push((names, of(|signal| &signal.name)));
            entries.push((units, of(|signal| &signal.unit)));
            let numbers: Vec<f64> = signals.iter().map(|signal| signal.value).collect();
            entries.push((values, Entry::column(&numbers)));
        }
        if let Some(regulator) = self.lqr {
            entries.push(("K", matrix(&regulator.gain, n)));
            entries.push(("controlled", Entry::Names(regulator.inputs.clone())));
        }
        if let Some(estimator) = self.kalman {
            let measured = estimator.outputs.len();
            entries.push(("L", matrix(&estimator.gain, measured)));
            if let Some(gain) = &estimator.innovation_gain {
                entries.push(("M", matrix(gain, measured)));
            }
            entries.push(("P", matrix(&estimator.covariance, n)));
            entries.push(("measured", Entry::Names(estimator.outputs.clone())));
        }
        entries
    }
}
