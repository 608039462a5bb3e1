//! Archive of an FMU. The same scene gives the same bytes.

use machinist::field::Discretisation;
use machinist_codegen::emit::c99::FmiVersion;
use machinist_fmu::resource::{EXPORT, Export, MODEL, Machine, token};
use machinist_fmu::variables::Unfit;
use machinist_model::file::{self, Stamped};

use super::description::Description;
use super::description2::Description2;
use super::library::Library;
use super::source::{SourceSettings, Sources};
use super::terminals;
use super::zip::archive;
use crate::cli::scene::CUTTING;
use crate::failure::{Failure, did_you_mean};
use crate::fields::whole;

/// Code that runs the model of an archive.
pub enum Content {
    /// The library, with the model as a resource.
    Library(Library),
    /// C99 sources, which the host compiles.
    Sources(SourceSettings),
}

/// Functional mock-up unit.
pub struct Archive {
    bytes: Vec<u8>,
    variables: usize,
    /// Sentence about the steps of sources.
    statement: Option<String>,
}

impl Archive {
    /// Builds the archive of a model with the settings of its export.
    pub fn of(
        stamped: &Stamped,
        export: &Export,
        version: FmiVersion,
        content: &Content,
    ) -> Result<Self, Failure> {
        let Content::Sources(_) = content else {
            return Self::of_machine(stamped, export, version, content);
        };
        // Sources have the nodes of fields as states.
        let wanted = Discretisation { elements: export.elements, order: export.order };
        let model = whole(stamped.model.clone(), wanted)?;
        let stamped = Stamped { model, ..stamped.clone() };
        let export = Export { elements: None, order: None, ..export.clone() };
        Self::of_machine(&stamped, &export, version, content)
    }

    fn of_machine(
        stamped: &Stamped,
        export: &Export,
        version: FmiVersion,
        content: &Content,
    ) -> Result<Self, Failure> {
        let inputs = &export.inputs;
        let bytes_of_model = file::write(stamped);
        let bytes_of_export = export.write();
        let token = token(&bytes_of_model, &bytes_of_export);
        let mut machine = Machine::of(stamped.model.clone(), export, token)
            .map_err(|unfit| refused(unfit, stamped))?;
        if let Some(twice) = (1..inputs.len()).find(|at| inputs[..*at].contains(&inputs[*at])) {
            return Err(Failure::input(format!("--inputs {} is given twice", inputs[twice]), ""));
        }
        let mut files: Vec<(String, Vec<u8>)> = Vec::new();
        let (variables, sources) = match content {
            Content::Library(library) => {
                let name = &machine.model().name;
                let platform = Library::platform(version)?;
                let binary = format!("binaries/{platform}/{}", Library::file_name(name));
                files.extend([
                    (binary, library.bytes.clone()),
                    (format!("resources/{MODEL}"), bytes_of_model),
                    (format!("resources/{EXPORT}"), bytes_of_export),
                ]);
                (machine.variables.clone(), None)
            }
            Content::Sources(settings) => {
                let sources = Sources::of(&mut machine, settings, version)?;
                files.extend(sources.files());
                (sources.variables.clone(), Some(sources))
            }
        };
        let description = match version {
            FmiVersion::Three => {
                let is_source = sources.is_some();
                Description { machine: &machine, variables: &variables, is_source }.text()?
            }
            FmiVersion::Two => {
                let sources = sources.as_ref().map_or_else(Vec::new, Sources::compiled);
                Description2 { machine: &machine, variables: &variables, sources: &sources }
                    .text()?
            }
        };
        files.insert(0, ("modelDescription.xml".to_owned(), description.into_bytes()));
        // FMI 2.0 has no terminals.
        if version == FmiVersion::Three
            && let Some(text) = terminals::text(&machine)
        {
            files.push(("terminalsAndIcons/terminalsAndIcons.xml".to_owned(), text.into_bytes()));
        }
        let files: Vec<(&str, &[u8])> =
            files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
        let bytes = archive(&files).map_err(|error| {
            Failure::unsuccessful(format!("cannot create the archive: {error}"), "")
        })?;
        let statement = sources.map(|sources| sources.statement);
        Ok(Self { bytes, variables: variables.all().len(), statement })
    }

    /// Returns the bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Number of variables.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Sentence about the steps of Co-Simulation, if the archive has sources.
    pub fn statement(&self) -> Option<&str> {
        self.statement.as_deref()
    }
}

/// Explains why a model cannot be exported.
fn refused(unfit: Unfit, stamped: &Stamped) -> Failure {
    let help = match &unfit {
        Unfit::UnknownInput { name, .. } => {
            let parameters = stamped.model.parameters.iter();
            did_you_mean(name, parameters.map(|p| p.quantity.name.path.as_str()))
        }
        Unfit::NotAnInput { .. } => {
            "forces, torques, voltages and other terms of the motion can be".to_owned()
        }
        Unfit::NoFields { .. } => "leave `--elements` and `--order` out".to_owned(),
        Unfit::Cut(_) => CUTTING.to_owned(),
    };
    Failure::input(unfit, help)
}
