//! Second derivation of a spec under check, in this process. It needs no computer algebra.

use machinist::{Discretisation, FieldSimulator};
use machinist_codegen::independent::{At, Comparison, Deviation, elements};
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator, What};
use machinist_studies::double_double::DoubleDouble;
use machinist_studies::verify::automatic::{Difference, Independent, Look};

use crate::failure::Failure;
use crate::spec_source::SpecSource;

/// Number of random places, in addition to those of the run.
const PLACES: usize = 20;
/// Seed of the random places.
const SEED: u64 = 0x5eed;
/// Maximum number of coordinates and constraints, so that solving the equations as one dense matrix
/// takes seconds.
const MOST: usize = 300;
/// Number up to which the equations are solved at every place.
const EVERYWHERE: usize = 100;

/// System from which a model was derived.
pub struct Spec {
    system: LagrangianSystem,
    /// Number of elements of each field.
    elements: Option<usize>,
}

impl Spec {
    /// Reads the system of a spec, or returns why it cannot be compared.
    pub fn of(source: &SpecSource, model: &Model) -> Result<Result<Self, String>, Failure> {
        let mut system = source.system()?;
        let left_out = &model.reduction.left_out;
        for dropped in left_out.iter().filter(|one| one.what == What::Constraint) {
            system.drop_constraint(&dropped.name, &[]);
        }
        let read = system.files.iter().map(|file| &file.sha256);
        if !read.eq(model.files.iter().map(|file| &file.sha256)) {
            return Ok(Err("the spec changed during the check".to_owned()));
        }
        let (system, elements) = if system.fields.is_empty() {
            (system, None)
        } else if let Some((system, elements)) = elements::written_out(&system) {
            (system, Some(elements))
        } else {
            let why = "no common number of elements divides all its fields once between ports";
            return Ok(Err(why.to_owned()));
        };
        let unknowns = system.coordinates.len() + system.constraints.len();
        if unknowns > MOST {
            let why = format!("{unknowns} coordinates and constraints, more than {MOST}");
            return Ok(Err(why));
        }
        Ok(Ok(Self { system, elements }))
    }

    /// Compares the system with a simulator without fields.
    pub fn against<'a>(
        &'a self,
        simulator: &'a dyn Simulator<f64>,
        parameters: &[f64],
    ) -> Independent<'a> {
        let comparison = Comparison::new(&self.system, simulator, DoubleDouble::to_f64);
        let comparison = comparison.map_err(|error| error.to_string())?;
        let parameters = parameters.to_vec();
        let fewer = EVERYWHERE.pow(3) as f64 / (self.system.coordinates.len() as f64).powi(3);
        Ok(Box::new(move |looks: &[Look<'_>]| {
            let most = |places: usize| ((places as f64 * fewer) as usize).clamp(1, places.max(1));
            let random = comparison.at_random(most(PLACES), &parameters, SEED);
            let looks = looks.iter().take(most(looks.len())).map(|look| At {
                time: look.time,
                state: look.state,
                parameters: look.parameters,
            });
            difference(random.or(comparison.at_places(looks, SEED)))
        }))
    }

    /// Compares the system with a model with fields, in few elements and only at random places,
    /// because the run has more elements.
    pub fn against_fields<'a>(
        &'a self,
        machine: &'a ModelSimulator,
        parameters: &[f64],
    ) -> Independent<'a> {
        let cut = Discretisation { elements: self.elements, order: None };
        // Discretization errors are found before the comparison.
        FieldSimulator::new(machine.with_fields(), cut).map_err(|error| error.to_string())?;
        let parameters = parameters.to_vec();
        Ok(Box::new(move |_| {
            let failed = |place: String| Difference { error: f64::NAN, place, compared: 1 };
            let simulator = match FieldSimulator::new(machine.with_fields(), cut) {
                Ok(simulator) => simulator,
                Err(error) => return failed(error.to_string()),
            };
            match Comparison::new(&self.system, simulator.single(), DoubleDouble::to_f64) {
                Ok(comparison) => difference(comparison.at_random(PLACES, &parameters, SEED)),
                Err(error) => failed(error.to_string()),
            }
        }))
    }
}

fn difference(found: Deviation) -> Difference {
    let Deviation { error, place, compared } = found;
    Difference { error, place, compared }
}
