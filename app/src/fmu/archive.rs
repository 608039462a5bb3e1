//! Archive of an FMU. The same scene gives the same bytes.

use machinist_fmu::resource::{EXPORT, Export, MODEL, Machine, token};
use machinist_fmu::variables::Unfit;
use machinist_model::file::{self, Stamped};

use super::description::Description;
use super::library::Library;
use super::terminals;
use super::zip::archive;
use crate::cli::scene::CUTTING;
use crate::failure::{Failure, did_you_mean};

/// Functional mock-up unit.
pub struct Archive {
    bytes: Vec<u8>,
    variables: usize,
}

impl Archive {
    /// Builds the archive of a model with the settings of its export.
    pub fn of(stamped: &Stamped, export: &Export, library: &Library) -> Result<Self, Failure> {
        let model = &stamped.model;
        let inputs = &export.inputs;
        let bytes_of_model = file::write(stamped);
        let bytes_of_export = export.write();
        let token = token(&bytes_of_model, &bytes_of_export);
        let machine = Machine::of(model.clone(), export, token).map_err(|unfit| {
            let help = match &unfit {
                Unfit::UnknownInput { name, .. } => {
                    let names = model.parameters.iter().map(|p| p.quantity.name.path.as_str());
                    did_you_mean(name, names)
                }
                Unfit::NotAnInput { .. } => {
                    "forces, torques, voltages and other terms of the motion can be".to_owned()
                }
                Unfit::NoFields { .. } => "leave `--elements` and `--order` out".to_owned(),
                Unfit::Cut(_) => CUTTING.to_owned(),
            };
            Failure::input(unfit, help)
        })?;
        if let Some(twice) = (1..inputs.len()).find(|at| inputs[..*at].contains(&inputs[*at])) {
            return Err(Failure::input(format!("--inputs {} is given twice", inputs[twice]), ""));
        }
        let description = Description { machine: &machine }.text()?;
        let binary =
            format!("binaries/{}/{}", Library::platform(), Library::file_name(&model.name));
        let model_path = format!("resources/{MODEL}");
        let export_path = format!("resources/{EXPORT}");
        let terminals = terminals::text(&machine);
        let mut files: Vec<(&str, &[u8])> = vec![
            ("modelDescription.xml", description.as_bytes()),
            (&binary, &library.bytes),
            (&model_path, &bytes_of_model),
            (&export_path, &bytes_of_export),
        ];
        if let Some(text) = &terminals {
            files.push(("terminalsAndIcons/terminalsAndIcons.xml", text.as_bytes()));
        }
        let bytes = archive(&files).map_err(|error| {
            Failure::unsuccessful(format!("cannot create the archive: {error}"), "")
        })?;
        Ok(Self { bytes, variables: machine.variables.all().len() })
    }

    /// Returns the bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Number of variables.
    pub fn variables(&self) -> usize {
        self.variables
    }
}
