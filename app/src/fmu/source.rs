//! Sources of an FMU: the C99 of its machine with the functions of the standard.

use machinist_codegen::emit::c99::{
    C99File, C99Options, FmiVersion, Real, Settable, UnitKind, UnitOptions, UnitVariable, emit_unit,
};
use machinist_codegen::write::WriteError;
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::resource::{Machine, token};
use machinist_fmu::variables::{Causality, Initial, Kind, Variability, Variable, Variables};

use super::fixed_step::FixedStep;
use super::xml::Element;
use crate::cli::generate::start;
use crate::failure::Failure;

/// Settings of an archive with sources.
#[derive(Debug, Clone, PartialEq)]
pub struct SourceSettings {
    /// Method of Co-Simulation, if it is given.
    pub method: Option<StepMethod>,
    /// Largest step of Co-Simulation \[s\], if it is given.
    pub step: Option<f64>,
    /// The command that makes the archive again, for the headers of the sources.
    pub command: String,
}

/// Sources of an archive.
pub struct Sources {
    files: Vec<C99File>,
    /// Variables of the archive.
    pub variables: Variables,
    /// Sentence about method, step and error of Co-Simulation.
    pub statement: String,
    version: FmiVersion,
    identifier: String,
}

impl Sources {
    /// Emits the sources of a machine and gives it a token of their own.
    pub fn of(
        machine: &mut Machine,
        settings: &SourceSettings,
        version: FmiVersion,
    ) -> Result<Self, Failure> {
        let found = FixedStep::of(machine, settings)?;
        let (step, method, statement) = (found.size, found.method, found.statement());
        let model = machine.model();
        let doc = format!("largest step of Co-Simulation: {statement}");
        let variables = machine.variables.clone().of_sources(model, step, doc);
        let options = C99Options {
            real: Real::Double,
            method,
            command: settings.command.clone(),
            inputs: Vec::new(),
            start: start(model)?,
            estimator: None,
        };
        let of_sources =
            format!("{} {version:?} {} {step:?}", env!("CARGO_PKG_VERSION"), method.name());
        let token = token(machine.token.as_bytes(), of_sources.as_bytes());
        let unit = UnitOptions {
            version,
            token: token.clone(),
            variables: variables.all().iter().map(unit_variable).collect(),
            step,
            statement: format!("Co-Simulation: {statement}."),
        };
        let scene = || model.name.clone();
        let files = emit_unit(model, &options, &unit)
            .map_err(|source| WriteError::Emit { scene: scene(), source })?;
        let identifier = model.name.clone();
        machine.token = token;
        Ok(Self { files, variables, statement, version, identifier })
    }

    /// Returns the names of the files to compile.
    pub fn compiled(&self) -> Vec<String> {
        let names = self.files.iter().map(|file| file.name.clone());
        names.filter(|name| name.to_ascii_lowercase().ends_with(".c")).collect()
    }

    /// Returns the files of the archive. FMI 2.0 lists sources in the model description, FMI 3.0 in
    /// a file of its own.
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let sources = self.files.iter();
        let mut files: Vec<(String, Vec<u8>)> = sources
            .map(|file| (format!("sources/{}", file.name), file.text.clone().into_bytes()))
            .collect();
        if self.version == FmiVersion::Three {
            let name = "sources/buildDescription.xml".to_owned();
            files.push((name, self.build_description().into_bytes()));
        }
        files
    }

    fn build_description(&self) -> String {
        let names = self.compiled();
        let files = names.iter().map(|name| Element::new("SourceFile").with("name", name));
        let set = Element::new("SourceFileSet").with("language", "C99").holding(files);
        let configuration = Element::new("BuildConfiguration")
            .with("modelIdentifier", &self.identifier)
            .holding([set]);
        let root = Element::new("fmiBuildDescription").with("fmiVersion", "3.0");
        root.holding([configuration]).document()
    }
}

/// Returns what the emitter has to know of a variable.
fn unit_variable(variable: &Variable) -> UnitVariable {
    let kind = match variable.kind {
        Kind::Time => UnitKind::Time,
        Kind::State(entry) => UnitKind::State(entry),
        Kind::Derivative(entry) => UnitKind::Derivative(entry),
        Kind::Mode(entry) => UnitKind::Mode(entry),
        Kind::Parameter(index) => UnitKind::Parameter(index),
        Kind::Output(index) => UnitKind::Output(index),
        Kind::Indicator(index) => UnitKind::Indicator(index),
        Kind::Step => UnitKind::Step,
    };
    let settable = match (variable.causality, variable.variability, variable.initial) {
        (Causality::Input, ..) => Settable::Input,
        (Causality::Parameter, Variability::Tunable, _) => Settable::Tunable,
        (Causality::Parameter, ..) | (_, _, Some(Initial::Exact)) => Settable::Fixed,
        (_, _, Some(Initial::Approx)) => Settable::Guess,
        _ => Settable::Never,
    };
    let doc = if variable.doc.is_empty() { &variable.name } else { &variable.doc };
    UnitVariable {
        name: variable.name.clone(),
        meaning: format!("{doc} [{}]", variable.unit),
        kind,
        settable,
        nominal: variable.nominal.unwrap_or(1.0),
    }
}
