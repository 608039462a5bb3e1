//! Assembly of the system of a scene with known coordinates.

mod checks;
mod constraints;
mod distributed;
mod events;
mod forces;
mod friction;
mod impacts;
mod initial;
mod outputs;
mod precision;
mod run;

use std::collections::BTreeSet;

use crate::scene::layout::{Layout, Scope, coordinate_spec};
use crate::scene::massless::{self, Remaining};
use crate::scene::names::{Flat, name};
use crate::scene::parameters;
use crate::scene::resolve::{Resolved, Resolver, Wanted};
use crate::scene::scatter;
use crate::scene::system::{
    Constraint, Coordinate, Drawn, FirstOrderState, LagrangianSystem, Parameter, Scalar, Spring,
};
use crate::scene::typed::{integer, sum};
use crate::spatial::mechanism::Mechanism;
use crate::spatial::orientation::Orientations;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::Dimension;
use crate::spec::expression::Ast;
use crate::spec::measure::in_coherent_units;
use crate::spec::{
    Declared, EnergySpec, InstanceSpec, OutputSpec, PowerSpec, SceneSpec, StateSpec, UnitSpec,
    did_you_mean, quoted,
};
use machinist_algebra::expr::rank::motion_without_energy;
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};
use machinist_model::{Name, Quantity, RunDefaults};

/// Assembles the system, which is meaningless if mistakes were found.
pub fn assemble(
    spec: &SceneSpec,
    layout: &Layout,
    values: &[f64],
    mistakes: &mut Vec<Mistake>,
) -> LagrangianSystem {
    let run = RunDefaults {
        from: 0.0,
        until: 0.0,
        points: 0,
        times: Vec::new(),
        rtol: spec.run.rtol,
        method: spec.run.method.clone(),
    };
    let mut resolver = Resolver::new(spec, layout);
    resolver.values = values;
    let mut assembler = Assembler { spec, layout, values, resolver, run, mistakes };
    assembler.span_of_run();
    // A requirement on a ratio made of a parameter is the same as that on the parameter.
    let mut requirements = parameters::check(&mut assembler.resolver, values, assembler.mistakes);
    requirements.extend(layout.required.iter().cloned());
    // Distributions are checked with the scene; the model does not contain them.
    scatter::find(spec, assembler.mistakes);
    assembler.inputs();
    let (energies, springs) = assembler.energies();
    let [mut kinetic, potential, dissipation, stored_energy, supplied_power, dissipated_power] =
        energies;
    let (mechanisms, drawing) = assembler.mechanisms();
    let mut generalized_force = assembler.forces();
    let power = [supplied_power, dissipated_power];
    let [supplied_power, dissipated_power] = assembler.friction(&mut generalized_force, power);
    let events = assembler.events();
    let constraints = assembler.constraints();
    let (initial, profiles) = assembler.initial();
    let coordinates = assembler.coordinates(&initial);
    let (orientations, scalars) = assembler.orientations(&initial);
    let first_order = assembler.first_order(&initial);
    let parameters = assembler.parameters();
    let fields = assembler.fields(&profiles);
    distributed::take_hold(&fields, &mut kinetic, &mut generalized_force);
    let handed = assembler.handed();
    let freeze = assembler.freeze();
    let helpers = assembler.helpers();
    let mut outputs = assembler.outputs();
    let checks = assembler.checks(&mut outputs, &coordinates, &first_order);
    assembler.clashes();
    let tables = std::mem::take(&mut assembler.resolver.tables);
    let discontinuities = std::mem::take(&mut assembler.resolver.discontinuities);
    let mut system = LagrangianSystem {
        name: spec.name.value.clone(),
        title: spec.title.clone(),
        doc: or_of_units(&spec.doc, spec, |unit| &unit.doc),
        source: or_of_units(&spec.source, spec, |unit| &unit.source),
        shares_redundant: spec.shares_redundant,
        coordinates,
        first_order,
        parameters,
        handed,
        kinetic,
        potential,
        mechanisms,
        drawing,
        orientations,
        scalars,
        springs,
        dissipation,
        generalized_force,
        stored_energy,
        supplied_power,
        dissipated_power,
        helpers,
        outputs,
        checks,
        tables,
        discontinuities,
        events,
        constraints,
        run: assembler.run.clone(),
        freeze,
        fields,
        starts_in_equilibrium: spec.starts_in_equilibrium,
        warnings: spec.sources.warnings(&assembler.resolver.warnings),
        notes: layout.cuts.iter().map(|cut| cut.note(spec, layout)).collect(),
        requirements,
        files: spec.sources.files(),
    };
    assembler.inertia(&mut system);
    impacts::reopen_frictions(&mut system);
    let impulses = impacts::impulses_without_friction(&system);
    system.notes.extend(impulses);
    system
}

/// Returns the scene's own text, or those of its units, one per line.
fn or_of_units(own: &str, spec: &SceneSpec, of: fn(&UnitSpec) -> &String) -> String {
    if !own.trim().is_empty() {
        return own.trim().to_owned();
    }
    let lines = spec.units.iter().filter_map(|unit| {
        let text = of(unit).split_whitespace().collect::<Vec<_>>().join(" ");
        let title = if unit.title.is_empty() { &unit.name } else { &unit.title };
        (!text.is_empty()).then(|| format!("{title}: {text}"))
    });
    lines.collect::<Vec<_>>().join("\n")
}

struct Assembler<'a> {
    spec: &'a SceneSpec,
    layout: &'a Layout,
    values: &'a [f64],
    resolver: Resolver<'a>,
    run: RunDefaults,
    mistakes: &'a mut Vec<Mistake>,
}

impl<'a> Assembler<'a> {
    fn instances(&self) -> impl Iterator<Item = (usize, &'a InstanceSpec, &'a UnitSpec)> + use<'a> {
        let spec = self.spec;
        let instances = spec.instances.iter().enumerate();
        instances.map(|(index, instance)| (index, instance, &spec.units[instance.unit]))
    }

    /// Returns the expression, or 0 after recording its mistake.
    fn note(&mut self, resolved: Resolved) -> Expr {
        match resolved {
            Ok(typed) => typed.expr,
            Err(mistake) => {
                self.mistakes.push(*mistake);
                integer(0)
            }
        }
    }

    /// Checks that every input is bound by an expression of its unit, and nothing else is bound.
    fn inputs(&mut self) {
        for (index, instance, unit) in self.instances() {
            for input in &unit.inputs {
                let scope = Scope::Instance(index);
                let resolved = self.resolver.value(&input.name.value, input.name.span, scope);
                self.note(resolved);
            }
            for (name, _) in &instance.inputs {
                if !unit.inputs.iter().any(|input| input.name.value == name.value) {
                    let message =
                        format!("unit {} has no input {}", quoted(&unit.name), quoted(&name.value));
                    let known = unit.inputs.iter().map(|input| input.name.value.as_str());
                    let help = did_you_mean(&name.value, known);
                    self.mistakes.push(
                        Mistake::new(Code::UnknownInput, name.span, message, "unknown").help(help),
                    );
                }
            }
        }
    }

    /// Sums T, V, D, stored energy, supplied and dissipated power over instances and the scene's
    /// own terms; also returns V of each instance.
    fn energies(&mut self) -> ([Expr; 6], Vec<Spring>) {
        let mut springs = Vec::new();
        let energy = |what: &str| Wanted { energy: true, ..Wanted::new(Dimension::ENERGY, what) };
        let power = |what: &str| Wanted::new(Dimension::POWER, what);
        let place = crate::scene::typed::Uses::PLACE;
        let wanted = [
            energy("the kinetic energy"),
            energy("the potential energy").of(place),
            power("the dissipation"),
            energy("the stored energy"),
            power("the supplied power"),
            power("the dissipated power"),
        ];
        let mut terms: [Vec<Expr>; 6] = Default::default();
        for (index, instance, unit) in self.instances() {
            let texts = texts_of(&unit.energy, &unit.power);
            self.energy_terms(&texts, Scope::Instance(index), &wanted, &mut terms);
            if unit.energy.potential.is_some()
                && let Some(potential) = terms[1].last().cloned()
            {
                springs.push(Spring { instance: instance.name.value.clone(), potential });
            }
        }
        let texts = texts_of(&self.spec.energy, &self.spec.power);
        self.energy_terms(&texts, Scope::Scene, &wanted, &mut terms);
        (terms.map(sum), springs)
    }

    /// Returns the trees of rigid bodies of connected instances, and the drawing of all trees.
    fn mechanisms(&mut self) -> (Vec<Mechanism>, Vec<Drawn>) {
        let (mut mechanisms, mut seen) = (Vec::new(), BTreeSet::new());
        let mut drawing = Vec::new();
        for (index, instance, unit) in self.instances() {
            if unit.frames.is_empty() && unit.bodies.is_empty() || seen.contains(&index) {
                continue;
            }
            let connected = self.resolver.connected(index);
            match self.resolver.spatial(index, instance.name.span) {
                Ok(spatial) => {
                    match self.resolver.drawn(&connected, &spatial) {
                        Ok(drawn) if !spatial.mechanism.joints.is_empty() => drawing.extend(drawn),
                        Ok(_) => {}
                        Err(mistake) => self.mistakes.push(*mistake),
                    }
                    mechanisms.push(spatial.mechanism.clone());
                }
                Err(mistake) => self.mistakes.push(*mistake),
            }
            seen.extend(connected);
        }
        mechanisms.retain(|mechanism| mechanism.joints.iter().any(|j| j.inertia.is_some()));
        (mechanisms, drawing)
    }

    /// Adds each given text to the terms of its sum.
    fn energy_terms(
        &mut self,
        texts: &[&Option<Ast>],
        scope: Scope,
        wanted: &[Wanted],
        terms: &mut [Vec<Expr>],
    ) {
        for ((text, wanted), terms) in texts.iter().zip(wanted).zip(terms) {
            if let Some(ast) = text {
                let resolved = self.resolver.expect(ast, scope, wanted);
                terms.push(self.note(resolved));
            }
        }
    }

    fn coordinates(&mut self, initial: &initial::Initial) -> Vec<Coordinate> {
        let layout = self.layout;
        let values = initial.coordinates.iter().zip(&initial.given);
        let coordinates = layout.representatives.iter().zip(values);
        let coordinates = coordinates.enumerate().map(|(id, (slot, (initial, given)))| {
            let spec = coordinate_spec(self.spec, layout, *slot);
            let instance = &self.spec.instances[layout.coordinate(*slot).0].name.value;
            let position = quantity(Some(instance), &spec.name.value, &spec.unit.text, &spec.doc);
            let doc =
                if spec.doc.is_empty() { String::new() } else { format!("rate of {}", spec.doc) };
            let unit = spec.unit_of_rate(1).map_or_else(String::new, |(text, _)| text);
            let velocity = quantity(Some(instance), &spec.velocity.value, &unit, &doc);
            let followers = layout.links.iter().enumerate().filter(|(other, link)| {
                link.id.0 as usize == id && other != slot && !layout.is_absent(*other)
            });
            let identified = followers.map(|(other, link)| {
                let spec = &coordinate_spec(self.spec, layout, other).name.value;
                let instance = &self.spec.instances[layout.coordinate(other).0].name.value;
                (format!("{instance}.{spec}"), Layout::factor(link))
            });
            let identified = identified.collect();
            Coordinate {
                position,
                velocity,
                identified,
                initial: initial.clone(),
                is_given: *given,
                scale: spec.scale,
            }
        });
        coordinates.collect()
    }

    /// Returns the orientations and their parts w.
    fn orientations(&self, initial: &initial::Initial) -> (Orientations, Vec<Scalar>) {
        let layout = self.layout;
        let all = self.instances().flat_map(|(at, instance, unit)| {
            let all = unit.orientations.iter().enumerate();
            let present = all.filter(move |(index, _)| layout.has_orientation(at, *index));
            present.map(move |(_, orientation)| (instance, orientation))
        });
        let values = initial.scalars.iter().zip(&initial.given_scalars);
        let scalars = all.zip(values).map(|((instance, orientation), (initial, is_given))| {
            let name = &orientation.name.value;
            let doc = if orientation.doc.is_empty() {
                format!("part w of {name}")
            } else {
                orientation.doc.clone()
            };
            let quantity =
                quantity(Some(&instance.name.value), &orientation.scalar().value, "1", &doc);
            Scalar { quantity, initial: initial.clone(), is_given: *is_given }
        });
        (self.resolver.orientations(), scalars.collect())
    }

    fn first_order(&mut self, initial: &initial::Initial) -> Vec<FirstOrderState> {
        let mut states = Vec::new();
        for (scope, instance, state) in self.states() {
            let what = format!("the rate of {}", quoted(&state.name.value));
            let rate = state.unit.unit.per_second(1).unwrap_or_default().dimension;
            let wanted = Wanted::new(rate, what);
            let resolved = self.resolver.expect_rate(&state.rate, scope, wanted);
            let rate = self.note(resolved);
            let quantity = quantity(instance, &state.name.value, &state.unit.text, &state.doc);
            let initial = initial.states[states.len()].clone();
            let (scale, is_mode) = (state.scale, state.is_mode);
            states.push(FirstOrderState { quantity, rate, initial, scale, is_mode });
        }
        states
    }

    /// Iterates over first-order states and modes in the order of their ids, with their scope and
    /// instance.
    fn states(&self) -> impl Iterator<Item = (Scope, Option<&'a str>, &'a StateSpec)> + use<'a> {
        let of_instances = self.instances().flat_map(|(index, instance, unit)| {
            let whose = Some(instance.name.value.as_str());
            unit.states.iter().map(move |state| (Scope::Instance(index), whose, state))
        });
        of_instances.chain(self.spec.states.iter().map(|state| (Scope::Scene, None, state)))
    }

    fn parameters(&mut self) -> Vec<Parameter> {
        let tunable = self.tunable();
        let all = parameters::numbers(self.spec).zip(tunable);
        let parameters = all.map(|((scope, index, value), tunable)| {
            let parameter = parameters::declared(self.spec, scope, index);
            let instance = match scope {
                Scope::Instance(instance) => {
                    Some(self.spec.instances[instance].name.value.as_str())
                }
                _ => None,
            };
            let unit = in_coherent_units(&parameter.unit.text);
            let quantity = quantity(instance, &parameter.name.value, &unit, &parameter.doc);
            Parameter { quantity, value, tunable }
        });
        parameters.collect()
    }

    /// Eliminates coordinates without inertia, and checks that every other motion has kinetic
    /// energy, for any parameter values except zeros, or that a constraint holds it; else
    /// accelerations would not follow from forces. Whether constraints determine a motion is
    /// checked once they are derived.
    fn inertia(&mut self, system: &mut LagrangianSystem) {
        if !self.mistakes.is_empty() {
            return;
        }
        let Remaining { coordinates, undetermined } =
            massless::eliminate(system, &|index| self.is_unjoined(index));
        let [kinetic, _] = system.energies();
        let mut moving = vec![false; coordinates.len()];
        mark_velocities(&kinetic, &mut moving);
        let found = undetermined.iter().flat_map(|motion| &motion.coordinates);
        let mut found: BTreeSet<usize> = found.copied().collect();
        for motion in &undetermined {
            self.without_inertia(&motion.coordinates, motion.why.text());
        }
        let is_held = |id: usize| is_held(CoordinateId(id as u32), &system.constraints);
        for (id, index) in coordinates.iter().enumerate() {
            if !moving[id] && !is_held(id) && found.insert(*index) {
                self.without_inertia(&[*index], "no kinetic energy depends on its velocity");
            }
        }
        if !found.is_empty() || !system.mechanisms.is_empty() {
            return;
        }
        let kinetic = system.given(&kinetic);
        let Some(moving) = motion_without_energy(&kinetic, coordinates.len()) else { return };
        if !moving.iter().any(|id| is_held(id.0 as usize)) {
            let moving: Vec<usize> = moving.iter().map(|id| coordinates[id.0 as usize]).collect();
            self.without_inertia(&moving, "their speeds have no constant ratio");
        }
    }

    /// Reports whether a coordinate is that of a port that is joined to nothing.
    fn is_unjoined(&self, index: usize) -> bool {
        let slot = self.layout.representatives[index];
        let (instance, _) = self.layout.coordinate(slot);
        let name = &coordinate_spec(self.spec, self.layout, slot).name.value;
        let ports = &self.spec.units[self.spec.instances[instance].unit].ports;
        let is_joined = self.layout.links.iter().enumerate().any(|(other, link)| {
            link.id.0 as usize == index && other != slot && !self.layout.is_absent(other)
        });
        !is_joined && ports.iter().any(|port| port.coordinate.value == *name)
    }

    /// Records that coordinates move without kinetic energy.
    fn without_inertia(&mut self, coordinates: &[usize], why: &str) {
        let name = |index: &usize| {
            let slot = self.layout.representatives[*index];
            let instance = &self.spec.instances[self.layout.coordinate(slot).0].name.value;
            let spec = coordinate_spec(self.spec, self.layout, slot);
            quoted(&format!("{instance}.{}", spec.name.value))
        };
        let Some(first) = coordinates.first() else { return };
        let names: Vec<String> = coordinates.iter().take(8).map(name).collect();
        let names = names.join(", ");
        let slot = self.layout.representatives[*first];
        let span = coordinate_spec(self.spec, self.layout, slot).name.span;
        let (message, label, help) = if coordinates.len() == 1 {
            let help = "join it to a unit with inertia, or give it a kinetic energy";
            (format!("coordinate {names} has no inertia: {why}"), "without inertia", help)
        } else {
            let more = if coordinates.len() > 8 { ", ..." } else { "" };
            let message = format!(
                "the mass matrix is singular: {names}{more} can move together without kinetic \
                 energy: {why}"
            );
            let help = "give one of them an inertia (for a node of a circuit, a capacitance to \
                        ground), or describe the machine by fewer coordinates";
            (message, "moves without energy", help)
        };
        self.mistakes.push(Mistake::new(Code::NoInertia, span, message, label).help(help));
    }

    /// Checks that names of one kind stay distinct when flattened.
    fn clashes(&mut self) {
        let [mut states, mut parameters, mut helpers] =
            [Flat::default(), Flat::default(), Flat::default()];
        let mut clashes = Vec::new();
        let mut take = |flat: &mut Flat, name: &Name, span: Span| {
            clashes.extend(flat.take(name, span).err().map(|mistake| *mistake));
        };
        for parameter in &self.spec.parameters {
            take(&mut parameters, &name(None, &parameter.name.value), parameter.name.span);
        }
        for (index, instance, unit) in self.instances() {
            let whose = Some(instance.name.value.as_str());
            // The instance is what the scene's author can rename.
            let span = instance.name.span;
            for coordinate in &unit.coordinates {
                take(&mut states, &name(whose, &coordinate.name.value), span);
                take(&mut states, &name(whose, &coordinate.velocity.value), span);
            }
            for state in &unit.states {
                take(&mut states, &name(whose, &state.name.value), span);
            }
            for orientation in &unit.orientations {
                take(&mut states, &name(whose, &orientation.scalar().value), span);
            }
            // Computed parameters are not in the model, so `rod.mass` may coincide with
            // `rod_mass`.
            let is_number =
                |at: &usize| self.layout.parameter(Scope::Instance(index), *at).is_some();
            for at in (0..unit.parameters.len()).filter(is_number) {
                take(&mut parameters, &name(whose, &unit.parameters[at].name.value), span);
            }
            for helper in &unit.helpers {
                take(&mut helpers, &name(whose, &helper.name.value), span);
            }
        }
        for helper in &self.spec.helpers {
            take(&mut helpers, &name(None, &helper.name.value), helper.name.span);
        }
        for state in &self.spec.states {
            take(&mut states, &name(None, &state.name.value), state.name.span);
        }
        for output in self.spec.outputs.iter().map(OutputSpec::name) {
            if self.spec.states.iter().any(|state| state.name.value == output.value) {
                let message = format!("{} is both a state and an output", quoted(&output.value));
                let mistake =
                    Mistake::new(Code::DuplicateName, output.span, message, "given again");
                clashes.push(mistake.help("give the output another name"));
            }
        }
        self.mistakes.extend(clashes);
    }
}

fn quantity(instance: Option<&str>, own: &str, unit: &str, doc: &str) -> Quantity {
    let doc = doc.split_whitespace().collect::<Vec<_>>().join(" ");
    Quantity { name: name(instance, own), unit: unit.trim().to_owned(), doc }
}

/// Changes `rad` to `rad/s`.
fn per_second(unit: &Declared) -> String {
    format!("{}/s", unit.text.trim())
}

fn mark_velocities(expr: &Expr, moving: &mut [bool]) {
    for symbol in expr.symbols() {
        if let Symbol::Velocity(id) = symbol {
            moving[id.0 as usize] = true;
        }
    }
}

/// Returns the texts of energies and powers: kinetic, potential, dissipation, stored; supplied,
/// dissipated.
fn texts_of<'t>(energy: &'t EnergySpec, power: &'t PowerSpec) -> [&'t Option<Ast>; 6] {
    [
        &energy.kinetic,
        &energy.potential,
        &energy.dissipation,
        &energy.stored,
        &power.supplied,
        &power.dissipated,
    ]
}

/// Reports whether a constraint that always holds depends on a coordinate or its velocity.
fn is_held(id: CoordinateId, constraints: &[Constraint]) -> bool {
    let is_its = |symbol| symbol == Symbol::Coordinate(id) || symbol == Symbol::Velocity(id);
    constraints.iter().any(|held| held.when.is_empty() && held.expr.mentions(is_its))
}
