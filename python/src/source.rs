//! Sources of simulators.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::sweep::{InLanes, Sweepable};
use machinist_contract::Simulator;
use machinist_model::{ModelSimulator, Running};
use machinist_scenes::scenes;

use crate::failure::Failure;

/// A simulator that threads can share, or the data to create one.
#[derive(Debug)]
pub enum Source {
    /// Built-in scene, by a known name.
    BuiltIn(&'static str),
    /// Built-in scene with fields to discretize.
    BuiltInFields(&'static str, Discretisation),
    /// Simulator of a model.
    Model(Box<ModelSimulator>),
    /// Model with fields to discretize.
    Fields(Box<ModelSimulator>, Discretisation),
}

impl Source {
    /// The built-in scene of a name, if it exists.
    ///
    /// # Errors
    /// Fields that cannot be cut as wanted.
    pub fn built_in(name: &str, wanted: Discretisation) -> Result<Option<Self>, Failure> {
        let known = |names: &[&'static str]| names.iter().find(|known| **known == name).copied();
        if let Some(name) = known(scenes::NAMES) {
            require_uncut(name, wanted)?;
            return Ok(Some(Self::BuiltIn(name)));
        }
        let Some(name) = known(scenes::FIELD_NAMES) else { return Ok(None) };
        let source = Self::BuiltInFields(name, wanted);
        source.with(|_| ())?;
        Ok(Some(source))
    }

    /// The scene of a model.
    ///
    /// # Errors
    /// Fields that cannot be cut as wanted.
    pub fn of_model(
        model: machinist_model::Model,
        wanted: Discretisation,
    ) -> Result<Self, Failure> {
        let has_fields = !model.fields.is_empty();
        let simulator = Box::new(ModelSimulator::new(model));
        if !has_fields {
            require_uncut(&simulator.model().name, wanted)?;
            return Ok(Self::Model(simulator));
        }
        let source = Self::Fields(simulator, wanted);
        source.with(|_| ())?;
        Ok(source)
    }

    /// Calls a function with the simulator. Discretizes fields anew each time.
    ///
    /// # Errors
    /// Fields that cannot be cut as wanted: not once a source has been made.
    pub fn with<T>(&self, job: impl FnOnce(&dyn Simulator<f64>) -> T) -> Result<T, Failure> {
        match self {
            Self::BuiltIn(name) => Ok(job(built_in(name))),
            Self::Model(simulator) => Ok(job(simulator.single())),
            Self::Fields(..) | Self::BuiltInFields(..) => Ok(job(self.cut()?.single())),
        }
    }

    /// Division of the fields as requested.
    pub fn discretisation(&self) -> Discretisation {
        match self {
            Self::BuiltIn(_) | Self::Model(_) => Discretisation::default(),
            Self::BuiltInFields(_, wanted) | Self::Fields(_, wanted) => *wanted,
        }
    }

    /// Discretizes the fields again.
    ///
    /// # Errors
    /// Fields that cannot be cut as wanted: not once a source has been made.
    ///
    /// # Panics
    /// If the source has no fields.
    pub fn cut(&self) -> Result<FieldSimulator<'_, f64>, Failure> {
        match self {
            Self::Fields(simulator, wanted) => {
                let cut = FieldSimulator::new(simulator.with_fields(), *wanted)?;
                Ok(cut.with_derivatives(simulator.with_fields_on_duals()))
            }
            Self::BuiltInFields(name, wanted) => {
                let scene = scenes::find_field_f64(name).expect("it was found before");
                let cut = FieldSimulator::new(scene, *wanted)?;
                Ok(match scenes::find_field_duals(name) {
                    Some(scene) => cut.with_derivatives(scene),
                    None => cut,
                })
            }
            Self::BuiltIn(_) | Self::Model(_) => unreachable!("there are no fields to be cut"),
        }
    }

    /// The simulator for many threads, if it has no fields.
    pub fn shared(&self) -> Option<Shared<'_>> {
        match self {
            Self::BuiltIn(name) => Some(Shared::BuiltIn(name)),
            Self::Model(simulator) => Some(Shared::Model(simulator)),
            Self::BuiltInFields(..) | Self::Fields(..) => None,
        }
    }

    /// Execution mode.
    pub fn running(&self) -> &'static str {
        match self {
            Self::BuiltIn(_) | Self::BuiltInFields(..) => "emitted",
            Self::Model(simulator) | Self::Fields(simulator, _) => match simulator.running() {
                Running::Compiled | Running::CompiledAtOnce => "compiled",
                Running::Interpreted => "interpreted",
            },
        }
    }
}

/// The simulator of a built-in scene, by a known name.
fn built_in(name: &str) -> &'static dyn Simulator<f64> {
    scenes::find_f64(name).expect("it was found before")
}

/// A machine without fields, which threads can run concurrently.
pub enum Shared<'a> {
    /// Built-in scene, by name.
    BuiltIn(&'static str),
    /// Simulator of a model.
    Model(&'a ModelSimulator),
}

impl Sweepable for Shared<'_> {
    fn single(&self) -> &dyn Simulator<f64> {
        match self {
            Self::BuiltIn(name) => built_in(name),
            Self::Model(simulator) => simulator.single(),
        }
    }

    fn in_lanes(&self) -> Option<InLanes<'_>> {
        match self {
            Self::BuiltIn(name) => machinist_lanes::find(name).map(InLanes::Eight),
            Self::Model(simulator) => Some(InLanes::Two(simulator.in_pairs())),
        }
    }
}

fn require_uncut(name: &str, wanted: Discretisation) -> Result<(), Failure> {
    if wanted == Discretisation::default() {
        return Ok(());
    }
    let message = format!("scene `{name}` has no fields. Hint: leave `elements` and `order` out");
    Err(Failure::input(message))
}
