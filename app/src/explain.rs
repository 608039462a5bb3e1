//! What is left out of a scene, why, and what that saves, measured.

use std::time::{Duration, Instant};

use crate::object::{ObjectError, object};
use machinist::{SimulateError, Simulation, Trajectory};
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

/// Runs of each, of which the median counts.
const RUNS: usize = 5;
/// Tolerance at which outputs are compared.
const FINE: f64 = 1e-12;

/// A scene, whole and reduced.
pub struct Explanation {
    /// The scene.
    pub scene: String,
    /// One line for people.
    pub title: String,
    /// Each thing left out.
    pub reduction: Reduction,
    /// The scene after each step of reduction that changed it, the whole one first.
    pub stages: Vec<Stage>,
    /// Names of the states that are left.
    pub states: Vec<String>,
    /// What the structure of what is left allows.
    pub structure: Structure,
    /// Whether fields belong to it, whose part is not in the structure.
    pub has_fields: bool,
    /// Why there are no object files, where they were wanted.
    pub no_object: Option<ObjectError>,
    /// What could be taken for rigid, and at what price, if runs were wanted.
    pub candidates: Vec<Candidate>,
    /// Run times, if they were measured.
    pub times: Option<Result<Times, SimulateError>>,
}

/// The scene after a step of reduction.
pub struct Stage {
    /// What has been done up to here.
    pub done: &'static str,
    /// What is left.
    pub size: Size,
}

/// How large a scene is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Size {
    /// Entries of the state.
    pub states: usize,
    /// How many of them are only integrated for an output.
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

/// Times of the scene's own run, whole and reduced, by one method at one tolerance,
/// both evaluated from their tapes.
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
    /// Largest difference of an output at relative tolerance 1e-12, relative to its
    /// largest value.
    pub difference: f64,
}

impl Explanation {
    /// Looks at the models of a scene, and times them if asked to; with its spec, also at
    /// what could be frozen.
    pub fn new(
        scene: Option<&SpecSource>,
        models: Stages,
        with_times: bool,
    ) -> Result<Self, Failure> {
        // A scene with fields is kept whole, and runs once it is cut into elements only.
        let with_times = with_times && models.whole.fields.is_empty();
        let mut stages = vec![(Stage::of(Keep::All, &models.whole), &models.whole)];
        stages.extend(models.steps.iter().map(|(step, model)| (Stage::of(*step, model), model)));
        // A step that renamed or noted something only is none to show.
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
            has_fields: !needed.fields.is_empty(),
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

    /// The figures with their names.
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

/// Compiles what each stage emits, all at once; nothing where nothing is left out, as the
/// compiler takes longer than all else.
fn measure_objects(stages: &mut [(Stage, &Model)]) -> Result<(), ObjectError> {
    if stages.len() < 2 {
        return Ok(());
    }
    std::thread::scope(|scope| {
        let compile = |model| scope.spawn(move || object(model).map(|object| object.len()));
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
        // In turns, so that what slows the machine down slows both.
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

    /// Time of the reduced scene for that of the whole one.
    pub fn ratio(&self) -> f64 {
        self.needed / self.whole
    }
}

/// Time of the scene's own run \[ms\], and the run.
pub fn timed(simulator: &ModelSimulator) -> Result<(f64, Trajectory), SimulateError> {
    let start = Instant::now();
    let run = limited(simulator).run()?;
    Ok((start.elapsed().as_secs_f64() * 1e3, run))
}

/// A run that ends if it takes too long to be compared.
pub fn limited(simulator: &ModelSimulator) -> Simulation<'_> {
    const LONGEST: Duration = Duration::from_secs(60);
    Simulation::new(simulator).time_limit(LONGEST)
}

fn fine(simulator: &ModelSimulator) -> Result<Trajectory, SimulateError> {
    let atol = vec![1e-13; simulator.shape().states()];
    limited(simulator).rtol(FINE).atol(&atol).points(101).run()
}

/// The middle one.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Of each output, the largest difference relative to its largest value.
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
