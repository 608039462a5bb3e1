//! Machines for Python.

use std::sync::OnceLock;
use std::time::Instant;

use machinist::field::Discretisation;
use machinist::hosted::{branches, margins};
use machinist::{SimulateError, Simulation};
use machinist_model::{file, fingerprint};
use numpy::PyUntypedArrayMethods;
use numpy::{PyArray1, PyArray2, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, array, numbers};
use crate::describe::describe;
use crate::failure::Failure;
use crate::patience::Patience;
use crate::run::Run;
use crate::settings::Settings;
use crate::source::Source;
use crate::tunable::tunable;

/// A machine ready to run.
#[pyclass(frozen, module = "machinist._machinist")]
pub struct Machine {
    pub source: Source,
    defaults: Vec<f64>,
    states: usize,
    outputs: usize,
    /// Hash of the model file; for emitted code see [`fingerprint::of_behaviour`].
    fingerprint: String,
    /// (row, column) of the nonzeros of the Jacobian.
    pattern: Vec<(u32, u32)>,
    tunable: OnceLock<Vec<bool>>,
}

impl Machine {
    fn new(source: Source, fingerprint: Option<String>) -> Result<Self, Failure> {
        let (defaults, states, outputs, pattern, behaviour) = source.with(|simulator| {
            let shape = simulator.shape();
            let defaults: Vec<f64> =
                (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
            let pattern = simulator.rate_jacobian_pattern().entries.to_vec();
            let behaviour = if fingerprint.is_none() {
                fingerprint::of_behaviour(simulator)
            } else {
                String::new()
            };
            (defaults, shape.states(), shape.outputs, pattern, behaviour)
        })?;
        let fingerprint = fingerprint.unwrap_or(behaviour);
        let tunable = OnceLock::new();
        Ok(Self { source, defaults, states, outputs, fingerprint, pattern, tunable })
    }

    /// Returns, for each parameter, whether it may change during a run.
    pub fn tunable(&self) -> Result<&[bool], Failure> {
        if let Some(known) = self.tunable.get() {
            return Ok(known);
        }
        let found = self.source.with(tunable)?;
        Ok(self.tunable.get_or_init(|| found))
    }

    /// Returns what distinguishes the machine: its fingerprint, and how its fields are divided.
    pub fn identity(&self) -> (String, Option<usize>, Option<usize>) {
        let Discretisation { elements, order } = self.source.discretisation();
        (self.fingerprint.clone(), elements, order)
    }

    /// Parameters; those of the scene if none are given.
    fn parameters<'a, 'py>(
        &'a self,
        given: Option<&Bound<'py, PyAny>>,
    ) -> Result<Parameters<'a, 'py>, Failure> {
        match given {
            None => Ok(Parameters::Defaults(&self.defaults)),
            Some(given) => Ok(Parameters::Given(numbers("p", given, Some(self.defaults.len()))?)),
        }
    }
}

impl Machine {
    /// Returns the parameters, with held branches after them if any are given.
    fn holding(
        &self,
        parameters: &[f64],
        held: Option<&Bound<'_, PyAny>>,
    ) -> Result<Vec<f64>, Failure> {
        let relations = self.source.with(|simulator| simulator.relations())?;
        let held = held.map(|held| numbers("branches", held, Some(relations))).transpose()?;
        Ok([parameters, held.as_ref().map_or(&[], |held| held.as_slice())].concat())
    }
}

enum Parameters<'a, 'py> {
    Defaults(&'a [f64]),
    Given(Numbers<'py>),
}

impl Parameters<'_, '_> {
    fn as_slice(&self) -> &[f64] {
        match self {
            Self::Defaults(values) => values,
            Self::Given(values) => values.as_slice(),
        }
    }
}

#[pymethods]
impl Machine {
    /// The built-in scene of this name, or `None`.
    #[staticmethod]
    fn built_in(
        name: &str,
        elements: Option<usize>,
        order: Option<usize>,
    ) -> Result<Option<Self>, Failure> {
        let source = Source::built_in(name, Discretisation { elements, order })?;
        source.map(|source| Self::new(source, None)).transpose()
    }

    /// The scene of a model file, from its bytes.
    #[staticmethod]
    fn of_model(
        py: Python<'_>,
        bytes: &[u8],
        elements: Option<usize>,
        order: Option<usize>,
    ) -> Result<Self, Failure> {
        py.detach(|| {
            let model = file::read(bytes)?.model;
            let source = Source::of_model(model, Discretisation { elements, order })?;
            Self::new(source, Some(fingerprint::of_bytes(bytes)))
        })
    }

    /// Hash that identifies the machine.
    #[getter]
    fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    /// Number of states.
    #[getter]
    fn states(&self) -> usize {
        self.states
    }

    /// Parameter values of the scene.
    fn defaults<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.defaults)
    }

    /// Description of the machine as a dictionary.
    fn describe<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let about = (self.source.running(), self.tunable()?);
        self.source.with(|simulator| describe(py, simulator, about))?
    }

    /// Rate y' = f(t, y, p), written to `out` if given, with `held` branches if given.
    #[pyo3(signature = (t, y, p=None, out=None, held=None))]
    fn rate<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
        held: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyAny>, Failure> {
        let y = numbers("y", y, Some(self.states))?;
        let p = self.holding(self.parameters(p)?.as_slice(), held)?;
        let fill = |values: &mut [f64]| {
            self.source.with(|simulator| simulator.rate(t, y.as_slice(), &p, values))
        };
        into_array(py, self.states, out, fill)
    }

    /// Branches of all relations at a state.
    #[pyo3(signature = (t, y, p=None))]
    fn branches<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let (y, p) = (numbers("y", y, Some(self.states))?, self.parameters(p)?);
        let at = (t, y.as_slice());
        Ok(array(py, self.source.with(|it| branches(it, p.as_slice(), at))?))
    }

    /// Distances of guards from the ends of held branches.
    #[pyo3(signature = (t, y, held, p=None))]
    fn margins<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'py, PyAny>,
        held: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let y = numbers("y", y, Some(self.states))?;
        let all = self.holding(self.parameters(p)?.as_slice(), Some(held))?;
        let as_held = all.split_at(self.defaults.len());
        let at = (t, y.as_slice());
        Ok(array(py, self.source.with(|it| margins(it, as_held, at))?))
    }

    /// Outputs o(t, y, p).
    #[pyo3(signature = (t, y, p=None, out=None))]
    fn outputs<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyAny>, Failure> {
        let (y, p) = (numbers("y", y, Some(self.states))?, self.parameters(p)?);
        let fill = |values: &mut [f64]| {
            self.source.with(|simulator| simulator.outputs(t, y.as_slice(), p.as_slice(), values))
        };
        into_array(py, self.outputs, out, fill)
    }

    /// Dense Jacobian dy'/dy, `states` by `states`, with `held` branches if given.
    #[pyo3(signature = (t, y, p=None, out=None, held=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
        held: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyAny>, Failure> {
        let y = numbers("y", y, Some(self.states))?;
        let p = self.holding(self.parameters(p)?.as_slice(), held)?;
        let mut values = vec![0.0; self.pattern.len()];
        self.source.with(|it| it.rate_jacobian(t, y.as_slice(), &p, &mut values))?;
        let wanted = [self.states; 2];
        let matrix = match out {
            None => PyArray2::<f64>::zeros(py, wanted, false).into_any(),
            Some(out) => out.clone(),
        };
        let mut filled: PyReadwriteArray2<'py, f64> =
            matrix.extract().map_err(|_| bad_out("matrix"))?;
        if filled.shape() != wanted {
            return Err(bad_out_shape(filled.shape(), &wanted));
        }
        let mut entries = filled.as_array_mut();
        entries.fill(0.0);
        for ((row, column), value) in self.pattern.iter().zip(values) {
            entries[(*row as usize, *column as usize)] = value;
        }
        drop(filled);
        Ok(matrix)
    }

    /// Rows and columns of the structural nonzeros of dy'/dy.
    fn jacobian_pattern(&self) -> (Vec<u32>, Vec<u32>) {
        self.pattern.iter().copied().unzip()
    }

    /// Initial state of the scene, before it is made to satisfy constraints or an equilibrium.
    #[pyo3(signature = (p=None))]
    fn initial_state<'py>(
        &self,
        py: Python<'py>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let p = self.parameters(p)?;
        let mut state = vec![0.0; self.states];
        self.source.with(|simulator| simulator.initial_state(p.as_slice(), &mut state))?;
        Ok(array(py, state))
    }

    /// Times at which the rate is discontinuous.
    #[pyo3(signature = (p=None))]
    fn discontinuities<'py>(
        &self,
        py: Python<'py>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let p = self.parameters(p)?;
        let jumps = self.source.with(|simulator| {
            let mut jumps = vec![0.0; simulator.shape().discontinuities];
            simulator.discontinuities(p.as_slice(), &mut jumps);
            jumps
        })?;
        Ok(array(py, jumps))
    }

    /// Simulates the machine. A run that stops early returns the partial run and the exception.
    fn simulate(
        &self,
        py: Python<'_>,
        settings: &Bound<'_, PyDict>,
    ) -> Result<(Option<Run>, Option<Py<PyAny>>), Failure> {
        let settings = Settings::of(settings)?;
        let (run, quiet) = py.detach(|| {
            let patience = Patience::new();
            let end = || patience.end();
            let run = self.source.with(|simulator| {
                settings.run(&settings.apply(Simulation::new(simulator))?.until_told(&end))
            });
            (run, patience.require_quiet())
        });
        quiet?;
        match run? {
            Ok(run) => Ok((Some(Run::new(run)), None)),
            Err(mut error) => {
                let SimulateError::Stopped { kept, .. } = &mut error else {
                    return Err(error.into());
                };
                let kept = kept.take().map(|kept| Run::new(*kept));
                let told = PyErr::from(Failure::from(error)).into_value(py);
                Ok((kept, Some(told.into_any())))
            }
        }
    }

    /// Times of consecutive runs \[s\], without the overhead of Python.
    fn time_runs(
        &self,
        py: Python<'_>,
        settings: &Bound<'_, PyDict>,
        runs: usize,
    ) -> Result<Vec<f64>, Failure> {
        let settings = Settings::of(settings)?;
        py.detach(|| {
            self.source.with(|simulator| {
                let time = || {
                    let start = Instant::now();
                    settings.apply(Simulation::new(simulator))?.run()?;
                    Ok(start.elapsed().as_secs_f64())
                };
                (0..runs).map(|_| time()).collect::<Result<Vec<f64>, SimulateError>>()
            })
        })?
        .map_err(Failure::from)
    }
}

/// Fills a new array or the caller's.
fn into_array<'py>(
    py: Python<'py>,
    length: usize,
    out: Option<&Bound<'py, PyAny>>,
    fill: impl FnOnce(&mut [f64]) -> Result<(), Failure>,
) -> Result<Bound<'py, PyAny>, Failure> {
    let Some(out) = out else {
        let mut values = vec![0.0; length];
        fill(&mut values)?;
        return Ok(array(py, values).into_any());
    };
    let mut filled: PyReadwriteArray1<'py, f64> =
        out.extract().map_err(|_| bad_out("row of numbers"))?;
    if filled.len() != length {
        return Err(bad_out_shape(filled.shape(), &[length]));
    }
    fill(filled.as_slice_mut().map_err(|_| bad_out("row of numbers"))?)?;
    drop(filled);
    Ok(out.clone())
}

fn bad_out(what: &str) -> Failure {
    let message = format!("out must be a writable {what} of float64, which nothing else borrows");
    Failure::input(message)
}

fn bad_out_shape(found: &[usize], wanted: &[usize]) -> Failure {
    Failure::Refused("ShapeError", format!("out has shape {found:?}, but must have {wanted:?}"))
}
