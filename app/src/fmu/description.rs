//! `modelDescription.xml`: the description of an archive for hosts.

use machinist_fmu::abi::CATEGORIES;
use machinist_fmu::resource::Machine;
use machinist_fmu::variables::{Causality, Initial, Kind, Variability, Variable};

use super::quantity::{MODE, type_of, types, unit_of, units};
use super::structure::Structure;
use super::xml::Element;
use crate::failure::Failure;

/// Description of a machine.
pub struct Description<'a> {
    pub machine: &'a Machine,
}

impl Description<'_> {
    /// Returns the text of the file.
    pub fn text(&self) -> Result<String, Failure> {
        let model = self.machine.model();
        let units = units(&self.machine.variables)?;
        let has_modes = self.has(|variable| matches!(variable.kind, Kind::Mode(_)));
        let types = types(&self.machine.variables, has_modes);
        let mut elements = vec![self.exchange(), self.simulation()];
        let lists = [("UnitDefinitions", units), ("TypeDefinitions", types)];
        let filled = lists.into_iter().filter(|(_, list)| !list.is_empty());
        elements.extend(filled.map(|(name, list)| Element::new(name).holding(list)));
        let categories = CATEGORIES.map(|(name, doc)| {
            Element::new("Category").with("name", name).with("description", doc)
        });
        elements.push(Element::new("LogCategories").holding(categories));
        elements.push(self.experiment());
        let variables = self
            .machine
            .variables
            .with_references()
            .map(|(at, variable)| self.variable(at, variable));
        elements.push(Element::new("ModelVariables").holding(variables));
        let structure = Structure::new(model, &self.machine.variables).elements();
        elements.push(Element::new("ModelStructure").holding(structure));
        let description = [&model.title, &model.doc].map(|text| text.trim());
        let description = description.into_iter().filter(|text| !text.is_empty());
        let description = description.collect::<Vec<_>>().join(": ");
        let tool = concat!("Machinist ", env!("CARGO_PKG_VERSION"));
        let root = Element::new("fmiModelDescription")
            .with("fmiVersion", "3.0")
            .with("modelName", &model.name)
            .with("instantiationToken", &self.machine.token)
            .with("description", description)
            .with("generationTool", tool)
            .with("variableNamingConvention", "structured");
        Ok(root.holding(elements).document())
    }

    fn has(&self, is: impl Fn(&Variable) -> bool) -> bool {
        self.machine.variables.all().iter().any(is)
    }

    fn interface(&self, name: &'static str) -> Element {
        let derives = self.machine.simulator().derivatives().is_some();
        Element::new(name)
            .with("modelIdentifier", &self.machine.model().name)
            .with("canGetAndSetFMUState", true)
            .with("canSerializeFMUState", true)
            .with("providesDirectionalDerivatives", derives)
            .with("providesAdjointDerivatives", derives)
    }

    fn exchange(&self) -> Element {
        let model = self.machine.model();
        // Guards are evaluated after steps, and constraints need projection.
        let looks = self.machine.variables.indicators() > 0 || !model.constraints.is_empty();
        self.interface("ModelExchange").with("needsCompletedIntegratorStep", looks)
    }

    fn simulation(&self) -> Element {
        let derives = self.machine.simulator().derivatives().is_some();
        self.interface("CoSimulation")
            .with("canHandleVariableCommunicationStepSize", true)
            .with("maxOutputDerivativeOrder", i32::from(derives))
            .with("providesIntermediateUpdate", true)
            .with("mightReturnEarlyFromDoStep", true)
            .with("canReturnEarlyAfterIntermediateUpdate", true)
            .with("hasEventMode", true)
    }

    fn experiment(&self) -> Element {
        let run = &self.machine.model().run;
        let step = (run.until - run.from) / (run.points.max(2) - 1) as f64;
        Element::new("DefaultExperiment")
            .with_number("startTime", run.from)
            .with_number("stopTime", run.until)
            .with_number("tolerance", run.rtol)
            .with_number("stepSize", step)
    }

    fn variable(&self, at: u32, variable: &Variable) -> Element {
        let is_mode = matches!(variable.kind, Kind::Mode(_));
        let element = Element::new(if is_mode { "Int32" } else { "Float64" })
            .with("name", &variable.name)
            .with("valueReference", at)
            .with_some("description", Some(&variable.doc).filter(|doc| !doc.is_empty()))
            .with_some("declaredType", declared_type(variable))
            .with("causality", causality(variable.causality))
            .with("variability", variability(variable.variability))
            .with_some("initial", variable.initial.map(initial));
        if is_mode {
            // Modes are integers.
            return element.with_some("start", variable.start.map(|start| start as i32));
        }
        let mut element = element.with_some("unit", unit_of(&variable.unit));
        if let Some(nominal) = variable.nominal {
            element = element.with_number("nominal", nominal);
        }
        if let Some(start) = variable.start {
            element = element.with_number("start", start);
        }
        match variable.kind {
            Kind::Derivative(entry) => element
                .with_some("derivative", self.machine.variables.reference(Kind::State(entry))),
            Kind::State(entry) if self.is_set(entry) => element.with("reinit", true),
            _ => element,
        }
    }

    /// Returns whether events or projection onto constraints may change a state.
    fn is_set(&self, entry: usize) -> bool {
        let model = self.machine.model();
        let is_set = model.events.iter().any(|event| event.sets.contains(&(entry as u32)));
        is_set || !model.constraints.is_empty()
    }
}

fn declared_type(variable: &Variable) -> Option<String> {
    match variable.kind {
        Kind::Mode(_) => Some(MODE.to_owned()),
        _ => type_of(&variable.unit),
    }
}

fn causality(causality: Causality) -> &'static str {
    match causality {
        Causality::Independent => "independent",
        Causality::Parameter => "parameter",
        Causality::Input => "input",
        Causality::Output => "output",
        Causality::Local => "local",
    }
}

fn variability(variability: Variability) -> &'static str {
    match variability {
        Variability::Fixed => "fixed",
        Variability::Tunable => "tunable",
        Variability::Discrete => "discrete",
        Variability::Continuous => "continuous",
    }
}

fn initial(initial: Initial) -> &'static str {
    match initial {
        Initial::Exact => "exact",
        Initial::Approx => "approx",
        Initial::Calculated => "calculated",
    }
}
