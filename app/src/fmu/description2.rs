//! `modelDescription.xml` by FMI 2.0.
//!
//! Variables are those of FMI 3.0 without event indicators, which have only a number there. Value
//! references are the same. The structure refers to variables by their index, from 1.

use machinist_fmu::resource::Machine;
use machinist_fmu::variables::{Kind, Variable, Variables};

use super::description::{
    TOOL, causality, declared_type, definitions, description_of, experiment, initial,
    needs_completed_steps, variability, with_numbers,
};
use super::quantity::{MODE, MODE_DOC, Type, types, unit_of, units};
use super::structure::{List, Structure, Unknown, joined};
use super::xml::Element;
use crate::failure::Failure;

/// Description of a machine by FMI 2.0.
pub struct Description2<'a> {
    pub machine: &'a Machine,
    /// Variables of the archive.
    pub variables: &'a Variables,
    /// Names of the source files to compile; empty for an archive with the library.
    pub sources: &'a [String],
}

impl Description2<'_> {
    /// Returns the text of the file.
    pub fn text(&self) -> Result<String, Failure> {
        let model = self.machine.model();
        let is_source = !self.sources.is_empty();
        let mut elements = vec![self.exchange(), self.simulation()];
        elements.extend(definitions(units(self.variables)?, self.types(), is_source));
        elements.push(experiment(model));
        let variables = self.listed().map(|(at, variable)| self.variable(at, variable));
        elements.push(Element::new("ModelVariables").holding(variables));
        elements.push(Element::new("ModelStructure").holding(self.structure()));
        let root = Element::new("fmiModelDescription")
            .with("fmiVersion", "2.0")
            .with("modelName", &model.name)
            .with("guid", &self.machine.token)
            .with("description", description_of(model))
            .with("generationTool", TOOL)
            .with("variableNamingConvention", "structured")
            .with("numberOfEventIndicators", self.variables.indicators());
        Ok(root.holding(elements).document())
    }

    fn types(&self) -> Vec<Element> {
        let types = types(self.variables).into_iter().map(|Type { name, quantity, unit }| {
            let real = Element::new("Real").with("quantity", quantity).with("unit", unit);
            Element::new("SimpleType").with("name", name).holding([real])
        });
        let mode = Element::new("SimpleType").with("name", MODE).with("description", MODE_DOC);
        let mut all = self.variables.all().iter();
        let has_modes = all.any(|variable| matches!(variable.kind, Kind::Mode(_)));
        types.chain(has_modes.then(|| mode.holding([Element::new("Integer")]))).collect()
    }

    fn interface(&self, name: &'static str) -> Element {
        let files = self.sources.iter().map(|file| Element::new("File").with("name", file));
        let sources = Element::new("SourceFiles").holding(files);
        Element::new(name)
            .with("modelIdentifier", &self.machine.model().name)
            .with("canGetAndSetFMUstate", true)
            .with("canSerializeFMUstate", true)
            .with("providesDirectionalDerivative", self.derives())
            .holding((!self.sources.is_empty()).then_some(sources))
    }

    /// Returns whether there are exact derivatives. Sources have none of outputs.
    fn derives(&self) -> bool {
        self.sources.is_empty() && self.machine.simulator().derivatives().is_some()
    }

    fn exchange(&self) -> Element {
        let looks = needs_completed_steps(self.machine.model(), self.variables);
        self.interface("ModelExchange").with("completedIntegratorStepNotNeeded", !looks)
    }

    fn simulation(&self) -> Element {
        self.interface("CoSimulation")
            .with("canHandleVariableCommunicationStepSize", true)
            .with("maxOutputDerivativeOrder", i32::from(self.derives()))
    }

    /// Iterates over the variables with their value references, in the order of their indices.
    fn listed(&self) -> impl Iterator<Item = (u32, &Variable)> {
        let all = self.variables.with_references();
        all.filter(|(_, variable)| !matches!(variable.kind, Kind::Indicator(_)))
    }

    /// Returns the index of a variable, from 1.
    fn index(&self, reference: u32) -> Option<usize> {
        self.listed().position(|(at, _)| at == reference).map(|position| position + 1)
    }

    fn variable(&self, at: u32, variable: &Variable) -> Element {
        Element::new("ScalarVariable")
            .with("name", &variable.name)
            .with("valueReference", at)
            .with_some("description", Some(&variable.doc).filter(|doc| !doc.is_empty()))
            .with("causality", causality(variable.causality))
            .with("variability", variability(variable.variability))
            .with_some("initial", variable.initial.map(initial))
            .holding([self.value(variable)])
    }

    fn value(&self, variable: &Variable) -> Element {
        if matches!(variable.kind, Kind::Mode(_)) {
            // Modes are integers.
            let start = variable.start.map(|start| start as i32);
            return Element::new("Integer").with("declaredType", MODE).with_some("start", start);
        }
        let element = Element::new("Real")
            .with_some("declaredType", declared_type(variable))
            .with_some("unit", unit_of(&variable.unit));
        let state = |entry| self.index(self.variables.reference(Kind::State(entry))?);
        with_numbers(element, self.machine.model(), variable, state)
    }

    fn structure(&self) -> Vec<Element> {
        let mut unknowns = Structure::new(self.machine.model(), self.variables).unknowns();
        unknowns.sort_by_key(|unknown| unknown.at);
        let lists = [
            (List::Outputs, "Outputs"),
            (List::Derivatives, "Derivatives"),
            (List::AtStart, "InitialUnknowns"),
        ];
        let element = |unknown: &Unknown| {
            let dependencies = unknown.dependencies.as_ref();
            let dependencies =
                dependencies.map(|all| joined(all.iter().filter_map(|at| self.index(*at))));
            Element::new("Unknown")
                .with_some("index", self.index(unknown.at))
                .with_some("dependencies", dependencies)
        };
        let lists = lists.map(|(list, name)| {
            let of_list = unknowns.iter().filter(|unknown| unknown.list == list);
            (name, of_list.map(element).collect::<Vec<_>>())
        });
        let filled = lists.into_iter().filter(|(_, list)| !list.is_empty());
        filled.map(|(name, list)| Element::new(name).holding(list)).collect()
    }
}
