//! Eigenmodes and frequency responses.

use std::ops::Range;

use machinist::Simulation;
use machinist::linear_analysis::{
    Hold, LinearError, Linearization, Mode, ModeKind, NoSlope, Piece, Place, PointSlopes,
    RegulatorError, Rows, Signal, StateSpace, Weight, models_along, operating_point,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::{array, numbers};
use crate::failure::Failure;
use crate::machine::Machine;
use crate::patience::Patience;
use crate::settings::Settings;

/// Operating point of a run.
struct Looked {
    time: f64,
    state: Vec<f64>,
}

/// Finds the operating point and linearizes there; releases the GIL.
fn looked_at<T: Send>(
    py: Python<'_>,
    machine: &Machine,
    settings: &Settings,
    place: &str,
    job: impl FnOnce(&Linearization<'_>, &Simulation<'_>, Place) -> Result<T, LinearError> + Send,
) -> Result<(T, Looked), Failure> {
    let place: Place = place.parse().map_err(Failure::input)?;
    let (found, quiet) = py.detach(|| {
        let patience = Patience::new();
        let end = || patience.end();
        let found = machine.source.with(|simulator| {
            let run = settings.apply(Simulation::new(simulator))?.until_told(&end);
            let linearization = Linearization::at(simulator, operating_point(&run, place)?)?;
            let found = job(&linearization, &run, place)?;
            let point = linearization.point();
            Ok((found, Looked { time: point.time, state: point.state.clone() }))
        });
        (found, patience.require_quiet())
    });
    quiet?;
    found?.map_err(|error: LinearError| error.into())
}

/// Data of all eigenmodes.
struct Description {
    names: Vec<String>,
    coordinates: usize,
    modes: Vec<Mode>,
    /// Parameters, and the derivatives of each eigenmode by them.
    by: Vec<String>,
    slopes: Vec<Result<Vec<[f64; 4]>, String>>,
    /// `None` if it would be too large.
    matrix: Option<Vec<f64>>,
}

/// Eigenmodes of a machine at an operating point, as a dictionary.
#[pyfunction]
pub fn modes<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    at: &str,
    by: Vec<String>,
) -> Result<Bound<'py, PyDict>, Failure> {
    let settings = Settings::of(settings)?;
    let (told, point) = looked_at(py, machine, &settings, at, |linearization, run, place| {
        let modes = linearization.modes()?;
        let mut slopes = Vec::new();
        if !by.is_empty() {
            let moves = PointSlopes::of(run, place, linearization.point(), &by)?;
            let of_modes = linearization.mode_slopes(&modes, &moves)?;
            slopes = of_modes.into_iter().map(slopes_of).collect();
        }
        Ok(Description {
            names: linearization.motion_names(),
            coordinates: linearization.simulator().shape().coordinates,
            modes,
            by,
            slopes,
            // Columns of the transposed are rows.
            matrix: linearization.matrix().ok().map(|a| a.transpose().as_slice().to_vec()),
        })
    })?;
    let answer = PyDict::new(py);
    answer.set_item("time", point.time)?;
    answer.set_item("state", array(py, point.state))?;
    answer.set_item("names", told.names)?;
    answer.set_item("coordinates", told.coordinates)?;
    answer.set_item("matrix", told.matrix.map(|matrix| array(py, matrix)))?;
    answer.set_item("by", told.by)?;
    let rows = PyList::empty(py);
    let mut slopes = told.slopes.into_iter();
    for mode in told.modes {
        let row = PyDict::new(py);
        let kind = match mode.kind {
            ModeKind::Free => "free",
            ModeKind::Aperiodic => "aperiodic",
            ModeKind::Oscillation => "oscillation",
        };
        row.set_item("kind", kind)?;
        row.set_item("real", mode.real)?;
        row.set_item("imaginary", mode.imaginary)?;
        row.set_item("natural_frequency", mode.natural_frequency())?;
        row.set_item("damping_ratio", mode.damping_ratio())?;
        row.set_item("decay_time", mode.decay_time())?;
        row.set_item("residual", mode.residual)?;
        let (real, imaginary): (Vec<f64>, Vec<f64>) =
            mode.shape.iter().map(|[real, imaginary]| (*real, *imaginary)).unzip();
        row.set_item("shape", (array(py, real), array(py, imaginary)))?;
        row.set_item("shares", array(py, mode.shares))?;
        match slopes.next() {
            None => row.set_item("slopes", py.None())?,
            Some(Ok(slopes)) => row.set_item("slopes", slopes)?,
            Some(Err(why)) => row.set_item("slopes", why)?,
        }
        rows.append(row)?;
    }
    answer.set_item("modes", rows)?;
    Ok(answer)
}

/// Derivatives of real part, imaginary part, natural frequency and damping ratio, or the reason
/// why they do not exist.
fn slopes_of(
    slopes: Result<Vec<machinist::linear_analysis::ModeSlope>, NoSlope>,
) -> Result<Vec<[f64; 4]>, String> {
    let row = |s: &machinist::linear_analysis::ModeSlope| {
        [s.real, s.imaginary, s.natural_frequency, s.damping_ratio]
    };
    match slopes {
        Ok(slopes) => Ok(slopes.iter().map(row).collect()),
        Err(NoSlope::Free) => Err("nothing restores it".to_owned()),
        Err(NoSlope::Repeated(modes)) => Err(format!("modes {modes:?} share its eigenvalue")),
        Err(NoSlope::Defective) => Err("it moves as a root of the parameter".to_owned()),
    }
}

/// (input, output, unit of amplitudes, [frequencies, amplitudes, phases], growth rate, frequency
/// and value of the largest amplitude).
type Answered<'py> =
    (String, String, String, [Bound<'py, PyAny>; 3], Option<f64>, Option<(f64, f64)>);

/// Frequency response of an output to a parameter or to a force on a coordinate.
#[pyfunction]
pub fn response<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    at: &str,
    from_to: (String, String),
    frequencies: Option<&Bound<'py, PyAny>>,
    points: usize,
) -> Result<Answered<'py>, Failure> {
    let (from, to) = from_to;
    let settings = Settings::of(settings)?;
    let given = frequencies.map(|given| numbers("frequencies", given, None)).transpose()?;
    let given = given.map(|given| given.as_slice().to_vec());
    if let Some(bad) = given.iter().flatten().find(|w| !(w.is_finite() && **w >= 0.0)) {
        return Err(Failure::input(format!(
            "frequencies hold {bad}; they are finite and not below 0"
        )));
    }
    let ((response, growth, largest), _) =
        looked_at(py, machine, &settings, at, |linearization, _, _| {
            let frequencies = if let Some(given) = given {
                given
            } else {
                let Range { start, end } = linearization.range_of_interest()?;
                machinist::linear_analysis::logarithmic_range(start, end, points)?
            };
            let response = linearization.response(&from, &to, &frequencies)?;
            let largest = linearization.largest(&from, &to, &response).ok().flatten();
            let largest = largest.map(|largest| (largest.frequency, largest.amplitude));
            Ok((response, linearization.growth().ok().flatten(), largest))
        })?;
    let unit = response.amplitude_unit();
    let arrays = [response.frequencies, response.amplitudes, response.phases];
    let arrays = arrays.map(|values| array(py, values).into_any());
    Ok((response.from, response.to, unit, arrays, growth, largest))
}

/// State-space model of a machine at an operating point, as a dictionary of names, units, values
/// and rows. `sampling` is the period \[s\] and the conversion, `zoh` or `tustin`.
#[pyfunction]
pub fn state_space<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    at: &str,
    signals: (Vec<String>, Vec<String>),
    sampling: Option<(f64, String)>,
) -> Result<Bound<'py, PyDict>, Failure> {
    let (inputs, outputs) = signals;
    let settings = Settings::of(settings)?;
    let sampling = match sampling {
        None => None,
        Some((period, hold)) => match hold.as_str() {
            "zoh" => Some((period, Hold::Zoh)),
            "tustin" => Some((period, Hold::Tustin)),
            other => {
                return Err(Failure::input(format!("hold is `zoh` or `tustin`, not `{other}`")));
            }
        },
    };
    let (told, _) = looked_at(py, machine, &settings, at, |linearization, _, _| {
        let model = linearization.state_space(&inputs, &outputs)?;
        let model = match sampling {
            None => model,
            Some((period, hold)) => model.sampled(period, hold)?,
        };
        let (poles, zeros) = (model.poles()?, model.zeros()?);
        Ok((poles, zeros, model.uncontrollable()?, model.unobservable()?, model))
    })?;
    let (poles, zeros, uncontrollable, unobservable, model) = told;
    let answer = PyDict::new(py);
    let signals =
        [("states", &model.states), ("inputs", &model.inputs), ("outputs", &model.outputs)];
    for (key, signals) in signals {
        let row = |signal: &machinist::linear_analysis::Signal| {
            (signal.name.clone(), signal.unit.clone(), signal.value)
        };
        answer.set_item(key, signals.iter().map(row).collect::<Vec<_>>())?;
    }
    let named = |modes: &[machinist::linear_analysis::Hidden]| -> Vec<((f64, f64), String)> {
        let one = |hidden: &machinist::linear_analysis::Hidden| {
            ((hidden.pole[0], hidden.pole[1]), model.named(hidden))
        };
        modes.iter().map(one).collect()
    };
    answer.set_item("uncontrollable", named(&uncontrollable))?;
    answer.set_item("unobservable", named(&unobservable))?;
    for (key, roots) in [("poles", poles), ("zeros", zeros)] {
        let parts: Vec<(f64, f64)> = roots.iter().map(|root| (root.re, root.im)).collect();
        answer.set_item(key, parts)?;
    }
    for (key, rows) in [("a", model.a), ("b", model.b), ("c", model.c), ("d", model.d)] {
        answer.set_item(key, array(py, rows.concat()))?;
    }
    answer.set_item("time", model.time)?;
    answer.set_item("drift", array(py, model.drift))?;
    answer.set_item("eliminated", model.eliminated)?;
    answer.set_item("period", model.sampling.map(|sampling| sampling.period))?;
    Ok(answer)
}

/// Matrices A, B, C and D, row by row, and their numbers of states, inputs and outputs.
type Matrices<'py> = ([Bound<'py, PyAny>; 4], (usize, usize, usize));

/// Regulator (`lqr`) or estimator (`kalman`) of a state-space model, as a dictionary of rows.
/// `weights` are the places of weighted inputs and outputs, `u` or `y` with a number from 1, and
/// their deviations.
#[pyfunction]
pub fn design<'py>(
    py: Python<'py>,
    kind: &str,
    matrices: Matrices<'py>,
    period: Option<f64>,
    weights: Vec<(String, f64)>,
) -> Result<Bound<'py, PyDict>, Failure> {
    let (given, (states, inputs, outputs)) = matrices;
    let rows = |index: usize, height: usize, width: usize| -> Result<Rows, Failure> {
        let values = numbers("the matrix", &given[index], Some(height * width))?;
        let row = |row: usize| values.as_slice()[row * width..(row + 1) * width].to_vec();
        Ok((0..height).map(row).collect())
    };
    let model = [
        rows(0, states, states)?,
        rows(1, states, inputs)?,
        rows(2, outputs, states)?,
        rows(3, outputs, inputs)?,
    ];
    let model = StateSpace::of_matrices(model, period)?;
    let weight = |(name, deviation)| Weight { name, deviation };
    let weights: Vec<Weight> = weights.into_iter().map(weight).collect();
    let refused =
        |error: RegulatorError| Failure::Coded("InputError", error.code(), error.to_string());
    let answer = PyDict::new(py);
    let poles = |poles: &[[f64; 2]]| poles.iter().map(|[re, im]| (*re, *im)).collect::<Vec<_>>();
    if kind == "lqr" {
        let found = py.detach(|| model.lqr(&weights)).map_err(refused)?;
        answer.set_item("poles", poles(&found.poles))?;
        answer.set_item("gain", array(py, found.gain.concat()))?;
        answer.set_item("cost", array(py, found.cost.concat()))?;
    } else {
        let found = py.detach(|| model.kalman(&weights)).map_err(refused)?;
        answer.set_item("poles", poles(&found.poles))?;
        answer.set_item("gain", array(py, found.gain.concat()))?;
        let correction = found.innovation_gain.map(|gain| array(py, gain.concat()));
        answer.set_item("correction", correction)?;
        answer.set_item("covariance", array(py, found.covariance.concat()))?;
    }
    Ok(answer)
}

/// Linear models along a run, in pieces of one order, as dictionaries of rows.
#[pyfunction]
pub fn pieces_along<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    signals: (Vec<String>, Vec<String>),
    times: &Bound<'py, PyAny>,
) -> Result<Bound<'py, PyList>, Failure> {
    let (inputs, outputs) = signals;
    let settings = Settings::of(settings)?;
    let times = numbers("times", times, None)?.as_slice().to_vec();
    let (found, quiet) = py.detach(|| {
        let patience = Patience::new();
        let end = || patience.end();
        let found = machine.source.with(|simulator| {
            let run = settings.apply(Simulation::new(simulator))?.until_told(&end);
            models_along(&run, &times, &inputs, &outputs)
        });
        (found, patience.require_quiet())
    });
    quiet?;
    let pieces: Vec<Piece> = found?.map_err(Failure::from)?;
    let answer = PyList::empty(py);
    for Piece { modes, models } in pieces {
        let row = PyDict::new(py);
        let first = &models[0];
        let names = |signals: &[Signal]| {
            signals.iter().map(|signal| (signal.name.clone(), signal.unit.clone())).collect()
        };
        for (key, signals) in
            [("states", &first.states), ("inputs", &first.inputs), ("outputs", &first.outputs)]
        {
            let names: Vec<(String, String)> = names(signals);
            row.set_item(key, names)?;
        }
        row.set_item("eliminated", first.eliminated.clone())?;
        row.set_item("modes", modes)?;
        let all =
            |of: fn(&StateSpace) -> Vec<f64>| models.iter().flat_map(of).collect::<Vec<f64>>();
        for (key, numbers) in [
            ("times", all(|model| vec![model.time])),
            ("a", all(|model| model.a.concat())),
            ("b", all(|model| model.b.concat())),
            ("c", all(|model| model.c.concat())),
            ("d", all(|model| model.d.concat())),
            ("drift", all(|model| model.drift.clone())),
            ("x", all(|model| model.states.iter().map(|signal| signal.value).collect())),
            ("y", all(|model| model.outputs.iter().map(|signal| signal.value).collect())),
        ] {
            row.set_item(key, array(py, numbers))?;
        }
        answer.append(row)?;
    }
    Ok(answer)
}
