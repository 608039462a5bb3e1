//! `modelDescription.xml`: the description of an archive for hosts.

use machinist_fmu::abi::{CATEGORIES, EVENTS};
use machinist_fmu::resource::Machine;
use machinist_fmu::variables::{Causality, Initial, Kind, Variability, Variable, Variables};
use machinist_model::Model;

use super::quantity::{MODE, MODE_DOC, Type, type_of, types, unit_of, units};
use super::structure::Structure;
use super::xml::Element;
use crate::failure::Failure;

/// Description of a machine by FMI 3.0.
pub struct Description<'a> {
    pub machine: &'a Machine,
    /// Variables of the archive.
    pub variables: &'a Variables,
    /// True if the archive has sources in place of the library.
    pub is_source: bool,
}

impl Description<'_> {
    /// Returns the text of the file.
    pub fn text(&self) -> Result<String, Failure> {
        let model = self.machine.model();
        let has_modes = self.has(|variable| matches!(variable.kind, Kind::Mode(_)));
        let types = types(self.variables).into_iter().map(|Type { name, quantity, unit }| {
            let element = Element::new("Float64Type").with("name", name);
            element.with("quantity", quantity).with("unit", unit)
        });
        let mode = Element::new("Int32Type").with("name", MODE).with("description", MODE_DOC);
        let types: Vec<Element> = types.chain(has_modes.then_some(mode)).collect();
        let mut elements = vec![self.exchange(), self.simulation()];
        elements.extend(definitions(units(self.variables)?, types, self.is_source));
        elements.push(experiment(model));
        let variables =
            self.variables.with_references().map(|(at, variable)| self.variable(at, variable));
        elements.push(Element::new("ModelVariables").holding(variables));
        let structure = Structure::new(model, self.variables).elements();
        elements.push(Element::new("ModelStructure").holding(structure));
        let root = Element::new("fmiModelDescription")
            .with("fmiVersion", "3.0")
            .with("modelName", &model.name)
            .with("instantiationToken", &self.machine.token)
            .with("description", description_of(model))
            .with("generationTool", TOOL)
            .with("variableNamingConvention", "structured");
        Ok(root.holding(elements).document())
    }

    fn has(&self, is: impl Fn(&Variable) -> bool) -> bool {
        self.variables.all().iter().any(is)
    }

    fn interface(&self, name: &'static str) -> Element {
        let derives = self.derives();
        Element::new(name)
            .with("modelIdentifier", &self.machine.model().name)
            .with("canGetAndSetFMUState", true)
            .with("canSerializeFMUState", true)
            .with("providesDirectionalDerivatives", derives)
            .with("providesAdjointDerivatives", derives)
    }

    /// Returns whether there are exact derivatives. Sources have none of outputs.
    fn derives(&self) -> bool {
        !self.is_source && self.machine.simulator().derivatives().is_some()
    }

    fn exchange(&self) -> Element {
        let looks = needs_completed_steps(self.machine.model(), self.variables);
        self.interface("ModelExchange").with("needsCompletedIntegratorStep", looks)
    }

    fn simulation(&self) -> Element {
        let element = self.interface("CoSimulation");
        if self.is_source {
            return element.with("canHandleVariableCommunicationStepSize", true);
        }
        element
            .with("canHandleVariableCommunicationStepSize", true)
            .with("maxOutputDerivativeOrder", i32::from(self.derives()))
            .with("providesIntermediateUpdate", true)
            .with("mightReturnEarlyFromDoStep", true)
            .with("canReturnEarlyAfterIntermediateUpdate", true)
            .with("hasEventMode", true)
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
        let element = element.with_some("unit", unit_of(&variable.unit));
        let state = |entry| self.variables.reference(Kind::State(entry));
        with_numbers(element, self.machine.model(), variable, state)
    }
}

/// Adds the typical size and the start value of a continuous variable, the state of a derivative,
/// and a mark for a state that jumps. `state` returns the reference of an entry of the state.
pub fn with_numbers<T: ToString>(
    mut element: Element,
    model: &Model,
    variable: &Variable,
    state: impl FnOnce(usize) -> Option<T>,
) -> Element {
    if let Some(nominal) = variable.nominal {
        element = element.with_number("nominal", nominal);
    }
    if let Some(start) = variable.start {
        element = element.with_number("start", start);
    }
    match variable.kind {
        Kind::Derivative(entry) => element.with_some("derivative", state(entry)),
        Kind::State(entry) if is_set(model, entry) => element.with("reinit", true),
        _ => element,
    }
}

/// Program that writes descriptions.
pub const TOOL: &str = concat!("Machinist ", env!("CARGO_PKG_VERSION"));

/// Returns title and documentation of a model as one text.
pub fn description_of(model: &Model) -> String {
    let texts = [&model.title, &model.doc].map(|text| text.trim());
    texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ")
}

/// Returns the definitions of units and types, where there are any, and of log categories. Sources
/// log no events.
pub fn definitions(units: Vec<Element>, types: Vec<Element>, is_source: bool) -> Vec<Element> {
    let lists = [("UnitDefinitions", units), ("TypeDefinitions", types)];
    let filled = lists.into_iter().filter(|(_, list)| !list.is_empty());
    let filled = filled.map(|(name, list)| Element::new(name).holding(list));
    let logged = CATEGORIES.into_iter().filter(|(name, _)| !(is_source && *name == EVENTS));
    let categories = logged
        .map(|(name, doc)| Element::new("Category").with("name", name).with("description", doc));
    filled.chain([Element::new("LogCategories").holding(categories)]).collect()
}

/// Returns the experiment of a model's run.
pub fn experiment(model: &Model) -> Element {
    let run = &model.run;
    let step = (run.until - run.from) / (run.points.max(2) - 1) as f64;
    Element::new("DefaultExperiment")
        .with_number("startTime", run.from)
        .with_number("stopTime", run.until)
        .with_number("tolerance", run.rtol)
        .with_number("stepSize", step)
}

/// Returns whether the unit has to look at the state after each step of the host.
pub fn needs_completed_steps(model: &Model, variables: &Variables) -> bool {
    // Guards are evaluated after steps, and constraints need projection.
    variables.indicators() > 0 || !model.constraints.is_empty()
}

/// Returns whether events or projection onto constraints may change a state.
fn is_set(model: &Model, entry: usize) -> bool {
    let is_set = model.events.iter().any(|event| event.sets.contains(&(entry as u32)));
    is_set || !model.constraints.is_empty()
}

/// Returns the type of a variable, if it has a name.
pub fn declared_type(variable: &Variable) -> Option<String> {
    match variable.kind {
        Kind::Mode(_) => Some(MODE.to_owned()),
        _ => type_of(&variable.unit),
    }
}

/// Returns the standard's word for a causality.
pub fn causality(causality: Causality) -> &'static str {
    match causality {
        Causality::Independent => "independent",
        Causality::Parameter => "parameter",
        Causality::Input => "input",
        Causality::Output => "output",
        Causality::Local => "local",
    }
}

/// Returns the standard's word for a variability.
pub fn variability(variability: Variability) -> &'static str {
    match variability {
        Variability::Fixed => "fixed",
        Variability::Tunable => "tunable",
        Variability::Discrete => "discrete",
        Variability::Continuous => "continuous",
    }
}

/// Returns the standard's word for the origin of a start value.
pub fn initial(initial: Initial) -> &'static str {
    match initial {
        Initial::Exact => "exact",
        Initial::Approx => "approx",
        Initial::Calculated => "calculated",
    }
}
