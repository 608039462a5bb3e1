//! The second derivation of a spec under check, in this process: it takes no computer algebra.

use machinist::{Discretisation, FieldSimulator};
use machinist_codegen::independent::{At, Comparison, Deviation, elements};
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator, What};
use machinist_studies::double_double::DoubleDouble;
use machinist_studies::verify::automatic::{Difference, Independent, Look};

use crate::failure::Failure;
use crate::spec_source::SpecSource;

/// Random places, beside those of the run.
const PLACES: usize = 20;
/// Which random places.
const SEED: u64 = 0x5eed;
/// Coordinates and constraints up to which equations are solved as one dense matrix, in
/// seconds.
const MOST: usize = 300;
/// Those up to which that is done at every place.
const EVERYWHERE: usize = 100;

/// The system that a model was derived from.
pub struct Spec {
    system: LagrangianSystem,
    /// Of fields, into how many elements each is cut.
    elements: Option<usize>,
}

impl Spec {
    /// Of a spec, or why it cannot be asked.
    pub fn of(source: &SpecSource, model: &Model) -> Result<Result<Self, String>, Failure> {
        let mut system = source.system()?;
        let left_out = &model.reduction.left_out;
        for dropped in left_out.iter().filter(|one| one.what == What::Constraint) {
            system.drop_constraint(&dropped.name, &[]);
        }
        let read = system.files.iter().map(|file| &file.sha256);
        if !read.eq(model.files.iter().map(|file| &file.sha256)) {
            return Ok(Err("the spec has changed while it was checked".to_owned()));
        }
        let (system, elements) = if system.fields.is_empty() {
            (system, None)
        } else if let Some((system, elements)) = elements::written_out(&system) {
            (system, Some(elements))
        } else {
            let why = "no one number of elements cuts all its fields once between ports";
            return Ok(Err(why.to_owned()));
        };
        let unknowns = system.coordinates.len() + system.constraints.len();
        if unknowns > MOST {
            let why = format!("{unknowns} coordinates and constraints, more than {MOST}");
            return Ok(Err(why));
        }
        Ok(Ok(Self { system, elements }))
    }

    /// Of a simulator without fields.
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

    /// Of a model with fields, in few elements, at random places: the run has more of them.
    pub fn against_fields<'a>(
        &'a self,
        machine: &'a ModelSimulator,
        parameters: &[f64],
    ) -> Independent<'a> {
        let cut = Discretisation { elements: self.elements, order: None };
        // Whether it can be cut so is known before anybody asks.
        FieldSimulator::new(machine.with_fields(), cut).map_err(|error| error.to_string())?;
        let parameters = parameters.to_vec();
        Ok(Box::new(move |_| {
            let failed = |place: String| Difference { error: f64::NAN, place, compared: 1 };
            let simulator = match FieldSimulator::new(machine.with_fields(), cut) {
                Ok(simulator) => simulator,
                Err(error) => return failed(error.to_string()),
            };
            match Comparison::new(&self.system, &simulator, DoubleDouble::to_f64) {
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
