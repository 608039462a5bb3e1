//! Reduction of a scene: what is left out, why, and the measured savings.

use std::time::{Duration, Instant};

use crate::object::{Compiler, ObjectError};
use machinist::{Discretisation, FieldSimulator, Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::rust::emit;
use machinist_codegen::lower::structure::Structure;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::Stages;
use machinist_contract::Describe as _;
use machinist_model::Model;
use machinist_model::ModelSimulator;
use machinist_model::Reduction;
use machinist_model::operations;
use serde::Serialize;

use crate::failure::Failure;
use crate::freeze::{self, Candidate};
use crate::spec_source::SpecSource;

/// Runs of each scene, of which the median counts.
const RUNS: usize = 5;
/// Relative tolerance at which outputs are compared.
const FINE: f64 = 1e-12;
/// Limit on the computing time of a run.
const LONGEST: Duration = Duration::from_secs(60);

/// Comparison of a scene, whole and reduced.
pub struct Explanation {
    /// Name of the scene.
    pub scene: String,
    /// Title in one line.
    pub title: String,
    /// States and parameters left out, with reasons.
    pub reduction: Reduction,
    /// Scene after each step of the reduction that changed it, the whole one first.
    pub stages: Vec<Stage>,
    /// Names of the remaining states.
    pub states: Vec<String>,
    /// Structure of the remaining equations.
    pub structure: Structure,
    /// The machine with its fields divided into elements, which the structure does not include.
    pub divided: Option<Result<Divided, String>>,
    /// Reason why there are no object files, if they were wanted.
    pub no_object: Option<ObjectError>,
    /// Parts that could be taken as rigid, with the error of doing so, if runs were wanted.
    pub candidates: Vec<Candidate>,
    /// Run times, if measured.
    pub times: Option<Result<Times, SimulateError>>,
}

/// Scene after a step of the reduction.
pub struct Stage {
    /// Steps done so far.
    pub done: &'static str,
    /// Size of what remains.
    pub size: Size,
}

/// Size of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Size {
    /// Entries of the state.
    pub states: usize,
    /// States that are integrated only for an output.
    pub quadratures: usize,
    /// Parameters.
    pub parameters: usize,
    /// Operations of y'.
    pub rate_operations: usize,
    /// Operations of dy'/dy.
    pub jacobian_operations: usize,
    /// Nonzeros of dy'/dy.
    pub jacobian_nonzeros: usize,
    /// Nonzeros of dy'/dp.
    pub parameter_jacobian_nonzeros: usize,
    /// Lines of the emitted module.
    pub lines: usize,
    /// Bytes of its object file, if it was compiled.
    pub object_bytes: Option<usize>,
}

/// Times of the scene's own run, whole and reduced, by one method at one tolerance, both evaluated
/// from their tapes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Times {
    /// Median of the whole scene \[ms\].
    pub whole: f64,
    /// Median of the reduced scene \[ms\].
    pub needed: f64,
    /// Steps of the whole scene.
    pub whole_steps: u64,
    /// Steps of the reduced scene.
    pub needed_steps: u64,
    /// Largest difference of an output at relative tolerance 1e-12, relative to its largest value.
    pub difference: f64,
}

/// A machine whose fields are divided into elements, as a run divides them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Divided {
    /// Each field with its elements.
    pub fields: Vec<DividedField>,
    /// Entries of the state.
    pub states: usize,
    /// Nonzeros of dy'/dy.
    pub jacobian_nonzeros: usize,
    /// True if the equations are linear with constant coefficients, so that a run can take its
    /// eigenmodes instead of steps.
    pub is_linear: bool,
    /// Relations and events, which runs locate.
    pub switches: usize,
    /// The scene's own run, if measured.
    pub run: Option<DividedRun>,
}

/// Run of a machine with fields.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DividedRun {
    /// Time \[ms\].
    pub milliseconds: f64,
    /// Number of steps.
    pub steps: u64,
    /// Reason why it stopped early, if it did.
    pub stopped: Option<String>,
}

/// A field with its elements.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DividedField {
    /// Name.
    pub name: String,
    /// Number of elements.
    pub elements: usize,
    /// Order of the elements.
    pub order: usize,
    /// Number of nodes, including those at ports.
    pub nodes: usize,
}

impl Divided {
    fn new(model: &Model, is_timed: bool) -> Result<Self, String> {
        let machine = ModelSimulator::new(model.clone());
        let cut = FieldSimulator::new(machine.with_fields(), Discretisation::default());
        let cut = cut.map_err(|error| error.to_string())?;
        let simulator = cut.single();
        let simulation = Simulation::new(simulator).time_limit(LONGEST);
        let parameters = simulation.parameter_values();
        let fields = model.fields.iter().enumerate().map(|(index, field)| {
            let nodes = cut.places(index, parameters).len();
            let name = field.quantities[0].name.path.clone();
            DividedField { name, elements: (nodes - 1) / field.order, order: field.order, nodes }
        });
        let run = is_timed.then(|| {
            let start = Instant::now();
            let run = simulation.run();
            DividedRun {
                milliseconds: start.elapsed().as_secs_f64() * 1e3,
                steps: run.as_ref().map_or(0, |run| run.work.steps),
                stopped: run.err().map(|error| error.to_string()),
            }
        });
        Ok(Self {
            fields: fields.collect(),
            states: simulator.shape().states(),
            jacobian_nonzeros: simulator.rate_jacobian_pattern().entries.len(),
            is_linear: Method::Exact.suits(simulator),
            switches: simulator.events() + simulator.relations(),
            run,
        })
    }
}

impl Explanation {
    /// Compares the models of a scene, and times them on request. With the spec, candidates for
    /// freezing are found too.
    pub fn new(
        scene: Option<&SpecSource>,
        models: Stages,
        with_times: bool,
    ) -> Result<Self, Failure> {
        // A scene with fields is kept whole, so that there is nothing to compare its run with.
        let (is_timed, with_times) = (with_times, with_times && models.whole.fields.is_empty());
        let mut stages = vec![(Stage::of(Keep::All, &models.whole), &models.whole)];
        stages.extend(models.steps.iter().map(|(step, model)| (Stage::of(*step, model), model)));
        // Steps that only renamed or noted something are not shown.
        stages.dedup_by(|(next, _), (last, _)| next.size == last.size);
        let no_object = if with_times { measure_objects(&mut stages).err() } else { None };
        let stages = stages.into_iter().map(|(stage, _)| stage).collect();
        let needed = models.needed().clone();
        Ok(Self {
            scene: needed.name.clone(),
            title: needed.title.clone(),
            reduction: needed.reduction.clone(),
            stages,
            states: needed
                .states
                .iter()
                .map(|state| &state.quantity)
                .map(|q| q.name.path.clone())
                .collect(),
            structure: Structure::of(&needed),
            divided: (!needed.fields.is_empty()).then(|| Divided::new(&needed, is_timed)),
            no_object,
            candidates: match scene {
                Some(scene) if with_times => freeze::candidates(scene)?,
                _ => Vec::new(),
            },
            times: with_times.then(|| Times::measure(models.whole, needed)),
        })
    }
}

impl Stage {
    fn of(step: Keep, model: &Model) -> Self {
        Self { done: step.name(), size: Size::of(model) }
    }
}

impl Size {
    fn of(model: &Model) -> Self {
        let text = emit(model, &EmitOptions::for_scenes()).unwrap_or_default();
        Self {
            states: model.states.len(),
            quadratures: model.quadratures,
            parameters: model.parameters.len(),
            rate_operations: operations(&model.rate),
            jacobian_operations: operations(&model.rate_jacobian.tape),
            jacobian_nonzeros: model.rate_jacobian.pattern.entries.len(),
            parameter_jacobian_nonzeros: model.parameter_jacobian.pattern.entries.len(),
            lines: text.lines().count(),
            object_bytes: None,
        }
    }

    /// Returns the figures with their names.
    pub fn figures(&self) -> Vec<(&'static str, usize)> {
        let mut figures = vec![
            ("states", self.states),
            ("parameters", self.parameters),
            ("rate, operations", self.rate_operations),
            ("Jacobian, operations", self.jacobian_operations),
            ("Jacobian, nonzeros", self.jacobian_nonzeros),
            ("by parameters, nonzeros", self.parameter_jacobian_nonzeros),
            ("emitted lines", self.lines),
        ];
        figures.extend(self.object_bytes.map(|bytes| ("object, bytes", bytes)));
        figures
    }
}

/// Compiles the emitted code of all stages in parallel. Does nothing if nothing is left out,
/// because compiling takes longer than all else.
fn measure_objects(stages: &mut [(Stage, &Model)]) -> Result<(), ObjectError> {
    if stages.len() < 2 {
        return Ok(());
    }
    let compiler = &Compiler::new()?;
    std::thread::scope(|scope| {
        let compile =
            |model| scope.spawn(move || compiler.object(model).map(|object| object.len()));
        let compiled: Vec<_> = stages.iter().map(|(_, model)| compile(*model)).collect();
        for ((stage, _), compiled) in stages.iter_mut().zip(compiled) {
            let bytes = compiled.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            stage.size.object_bytes = Some(bytes?);
        }
        Ok(())
    })
}

impl Times {
    fn measure(whole: Model, needed: Model) -> Result<Self, SimulateError> {
        let [whole, needed] = [whole, needed].map(ModelSimulator::compiled_at_once);
        let (mut whole_times, mut needed_times) = (Vec::new(), Vec::new());
        let mut steps = (0, 0);
        // The runs alternate, so that a slow moment of the computer affects both.
        for _ in 0..RUNS {
            let (time, run) = timed(&whole)?;
            whole_times.push(time);
            steps.0 = run.work.steps;
            let (time, run) = timed(&needed)?;
            needed_times.push(time);
            steps.1 = run.work.steps;
        }
        Ok(Self {
            whole: median(whole_times),
            needed: median(needed_times),
            whole_steps: steps.0,
            needed_steps: steps.1,
            difference: relative_differences(&fine(&whole)?, &fine(&needed)?)
                .iter()
                .fold(0.0, |largest, (_, difference)| difference.max(largest)),
        })
    }

    /// Ratio of the reduced scene's time to that of the whole one.
    pub fn ratio(&self) -> f64 {
        self.needed / self.whole
    }
}

/// Runs the scene and returns the time \[ms\] with the run.
pub fn timed(simulator: &ModelSimulator) -> Result<(f64, Trajectory), SimulateError> {
    let start = Instant::now();
    let run = limited(simulator).run()?;
    Ok((start.elapsed().as_secs_f64() * 1e3, run))
}

/// Prepares a run with a time limit.
pub fn limited(simulator: &ModelSimulator) -> Simulation<'_> {
    Simulation::new(simulator).time_limit(LONGEST)
}

fn fine(simulator: &ModelSimulator) -> Result<Trajectory, SimulateError> {
    let atol = vec![1e-13; simulator.shape().states()];
    limited(simulator).rtol(FINE).atol(&atol).points(101).run()
}

/// Returns the median.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Returns the largest difference of each output, relative to its largest value.
pub fn relative_differences(exact: &Trajectory, other: &Trajectory) -> Vec<(String, f64)> {
    let columns = exact.of_kind(machinist::trajectory::ColumnKind::Output);
    let differences = columns.map(|column| {
        let name = column.name.clone();
        let Some(ours) = other.column(&name) else { return (name, f64::NAN) };
        let size = column.values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let differences = ours.iter().zip(&column.values).map(|(a, b)| (a - b).abs());
        let largest = differences.fold(0.0_f64, f64::max);
        (name, if largest == 0.0 { 0.0 } else { largest / size })
    });
    differences.collect()
}
