//! The archive. The same scene gives the same bytes.

use machinist_fmu::resource::{EXPORT, Export, MODEL, token};
use machinist_fmu::variables::{Unfit, Variables};
use machinist_model::file::{self, Stamped};

use super::description::Description;
use super::library::Library;
use super::zip::archive;
use crate::failure::{Failure, did_you_mean};

/// A functional mock-up unit.
pub struct Archive {
    bytes: Vec<u8>,
    variables: usize,
}

impl Archive {
    /// Of a model, whose parameters of these names are inputs.
    pub fn of(stamped: &Stamped, inputs: &[String], library: &Library) -> Result<Self, Failure> {
        let model = &stamped.model;
        let variables = Variables::of(model, inputs).map_err(|unfit| {
            let help = match &unfit {
                Unfit::UnknownInput { name, .. } => {
                    let names = model.parameters.iter().map(|p| p.quantity.name.path.as_str());
                    did_you_mean(name, names)
                }
                Unfit::NotAnInput { .. } => {
                    "forces, torques, voltages and other terms of the motion can be".to_owned()
                }
                Unfit::Fields { .. } => String::new(),
            };
            Failure::input(unfit, help)
        })?;
        if let Some(twice) = (1..inputs.len()).find(|at| inputs[..*at].contains(&inputs[*at])) {
            return Err(Failure::input(format!("--inputs {} is given twice", inputs[twice]), ""));
        }
        let bytes_of_model = file::write(stamped);
        let export = Export { inputs: inputs.to_vec() }.write();
        let token = token(&bytes_of_model, &export);
        let description = Description { stamped, variables: &variables, token: &token }.text()?;
        let binary =
            format!("binaries/{}/{}", Library::platform(), Library::file_name(&model.name));
        let files: [(&str, &[u8]); 4] = [
            ("modelDescription.xml", description.as_bytes()),
            (&binary, &library.bytes),
            (&format!("resources/{MODEL}"), &bytes_of_model),
            (&format!("resources/{EXPORT}"), &export),
        ];
        let bytes = archive(&files).map_err(|error| {
            Failure::unsuccessful(format!("the archive cannot be made: {error}"), "")
        })?;
        Ok(Self { bytes, variables: variables.all().len() })
    }

    /// Its bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// How many variables it has.
    pub fn variables(&self) -> usize {
        self.variables
    }
}
