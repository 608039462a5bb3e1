//! Events: guards, the modes in which they are active, and their resets.

use std::collections::HashMap;

use crate::scene::assemble::Assembler;
use crate::scene::assemble::initial::Target;
use crate::scene::layout::{Local, Scope, find_inside, find_instance};
use crate::scene::names::{Flat, name};
use crate::scene::resolve::Wanted;
use crate::scene::system::Event;
use crate::scene::typed::{Uses, integer, product, reciprocal};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::{EventSpec, FrictionSpec, Openings, did_you_mean, quoted};
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Symbol};

impl Assembler<'_> {
    /// Returns all events, those of instances first.
    pub(super) fn events(&mut self) -> Vec<Event> {
        let spec = self.spec;
        let mut events = Vec::new();
        let mut names = Flat::default();
        let of_units = self.instances().flat_map(|(index, instance, unit)| {
            let whose = Some(instance.name.value.as_str());
            unit.events.iter().map(move |event| (Scope::Instance(index), whose, event))
        });
        let own = spec.events.iter().map(|event| (Scope::Scene, None, event));
        let mut openings: HashMap<Scope, Vec<Openings>> = HashMap::new();
        for (scope, whose, event) in of_units.chain(own) {
            let openings = openings.entry(scope).or_insert_with(|| self.constant_openings(scope));
            if openings.iter().any(|openings| openings.opens.contains(&event.name.value)) {
                continue;
            }
            let name = name(whose, &event.name.value);
            if let Err(mistake) = names.take(&name, event.name.span) {
                self.mistakes.push(*mistake);
            }
            let sets_in = openings.iter().any(|openings| openings.closes == event.name.value);
            let guard = if sets_in { integer(1) } else { self.guard(event, scope) };
            let (when, set) = (self.modes(&event.when, scope), self.new_values(event, scope));
            let doc = event.doc.split_whitespace().collect::<Vec<_>>().join(" ");
            events.push(Event { name, doc, guard, direction: event.direction, when, set });
        }
        events
    }

    /// Returns the events of frictions whose magnitudes read constraint forces. These never open:
    /// friction itself changes the force, which may pass zero only for an instant.
    fn constant_openings(&mut self, scope: Scope) -> Vec<Openings> {
        let spec = self.spec;
        let frictions = match scope {
            Scope::Instance(index) => &spec.units[spec.instances[index].unit].frictions,
            _ => &spec.frictions,
        };
        let reads = |friction: &&FrictionSpec| {
            let slide = self.resolver.expect_guard(&friction.slide, scope);
            slide.is_ok_and(|slide| slide.uses.reaction)
        };
        frictions.iter().filter(reads).map(|friction| friction.openings.clone()).collect()
    }

    /// Resolves a guard of any dimension. It must be able to cross zero, or to decide by its sign
    /// at the start that a mode is another.
    fn guard(&mut self, event: &EventSpec, scope: Scope) -> Expr {
        let resolved = self.resolver.expect_guard(&event.guard, scope);
        let is_set = |mode: &str| event.set.iter().any(|(path, _)| path.value == mode);
        let leaves_mode = event.when.iter().any(|(path, _)| is_set(&path.value));
        if let Ok(typed) = &resolved
            && typed.uses == Uses::default()
            && (!leaves_mode || typed.value == Some(0.0))
        {
            let what = if typed.value == Some(0.0) { "is always zero" } else { "never changes" };
            let name = quoted(&event.name.value);
            let message = format!("the guard of event {name} {what}");
            let mistake =
                Mistake::new(Code::InvalidGuard, event.guard.span, message, "of parameters only");
            let help = "a guard must depend on time, coordinates, velocities or states";
            self.mistakes.push(mistake.help(help));
        }
        self.note(resolved)
    }

    /// Returns modes by name, with the values they must have.
    pub(super) fn modes(
        &mut self,
        when: &[(Spanned<String>, i32)],
        scope: Scope,
    ) -> Vec<(FirstOrderId, i32)> {
        let mut modes: Vec<(FirstOrderId, i32)> = Vec::new();
        for (path, value) in when {
            match self.mode(path, scope) {
                Ok(id) if modes.iter().any(|(known, _)| *known == id) => {
                    let message = format!("mode {} is given twice", quoted(&path.value));
                    self.mistakes.push(Mistake::new(
                        Code::DuplicateName,
                        path.span,
                        message,
                        "again",
                    ));
                }
                Ok(id) => modes.push((id, *value)),
                Err(mistake) => self.mistakes.push(*mistake),
            }
        }
        modes
    }

    /// Finds the mode of a name.
    fn mode(&self, path: &Spanned<String>, scope: Scope) -> Result<FirstOrderId, Box<Mistake>> {
        if let (Scope::Scene, Some(index)) = (scope, self.own_state(&path.value))
            && self.spec.states[index].is_mode
        {
            return Ok(self.layout.state(scope, index));
        }
        let (instance, name) = self.owner(path, scope)?;
        let unit_index = self.spec.instances[instance].unit;
        let unit = &self.spec.units[unit_index];
        match self.layout.units[unit_index].get(name) {
            Some(Local::State(index)) if unit.states[index].is_mode => {
                Ok(self.layout.state(Scope::Instance(instance), index))
            }
            _ => {
                let modes = unit.states.iter().filter(|state| state.is_mode);
                let help = did_you_mean(name, modes.map(|state| state.name.value.as_str()));
                let message = format!("{} is not a mode", quoted(&path.value));
                Err(Box::new(
                    Mistake::new(Code::WrongKindOfName, path.span, message, "not a mode")
                        .help(help),
                ))
            }
        }
    }

    /// Returns the resets of an event, each quantity once, by an expression of its dimension.
    fn new_values(&mut self, event: &EventSpec, scope: Scope) -> Vec<(Symbol, Expr)> {
        let mut set: Vec<(Symbol, Expr)> = Vec::new();
        for (path, formula) in &event.set {
            let (symbol, factor, dimension) = match self.settable(path, scope) {
                Ok(found) => found,
                Err(mistake) => {
                    self.mistakes.push(*mistake);
                    continue;
                }
            };
            let what = format!("the new value of {}", quoted(&path.value));
            let wanted = Wanted::new(dimension, what);
            let resolved = self.resolver.formula(formula, scope, &wanted);
            let value = self.note(resolved);
            let value = match factor {
                Some(factor) => product(vec![value, reciprocal(factor)]),
                None => value,
            };
            if set.iter().any(|(known, _)| *known == symbol) {
                let message = format!("{} is set twice by one event", quoted(&path.value));
                let mistake = Mistake::new(Code::DuplicateName, path.span, message, "set again");
                self.mistakes.push(mistake.help("joined coordinates move together"));
            }
            set.push((symbol, value));
        }
        set
    }

    fn settable(
        &self,
        path: &Spanned<String>,
        scope: Scope,
    ) -> Result<(Symbol, Option<Expr>, Dimension), Box<Mistake>> {
        let is_own = scope == Scope::Scene && self.own_state(&path.value).is_some();
        let (target, dimension) = if is_own {
            self.target(path, scope)?
        } else {
            let (instance, name) = self.owner(path, scope)?;
            self.target_of(instance, name, path)?
        };
        Ok(match target {
            Target::State(id) => (Symbol::FirstOrder(FirstOrderId(id as u32)), None, dimension),
            Target::Scalar(number) => {
                let id = CoordinateId((self.layout.representatives.len() + number) as u32);
                (Symbol::Coordinate(id), None, dimension)
            }
            Target::Coordinate(id, order, factor) => {
                let id = CoordinateId(id as u32);
                let symbol = if order == 0 { Symbol::Coordinate(id) } else { Symbol::Velocity(id) };
                (symbol, factor, dimension)
            }
        })
    }

    /// Finds the instance of a name, and the name within it.
    pub(super) fn owner<'n>(
        &self,
        path: &'n Spanned<String>,
        scope: Scope,
    ) -> Result<(usize, &'n str), Box<Mistake>> {
        match (scope.base(), path.value.rsplit_once('.')) {
            (Scope::Instance(instance), None) => Ok((instance, &path.value)),
            (_, None) => {
                let message = format!("an event cannot set {}", quoted(&path.value));
                let mistake =
                    Mistake::new(Code::WrongKindOfName, path.span, message, "not instance.name");
                Err(Box::new(mistake.help("write \"instance.name\"")))
            }
            (Scope::Instance(own), Some(_))
                if !self.spec.units[self.spec.instances[own].unit].is_assembly() =>
            {
                let message = "names with a dot are allowed in scenes and assemblies only";
                let help = "an event of a unit can set only variables of the unit";
                Err(Box::new(
                    Mistake::new(Code::OutOfScope, path.span, message, "not in a unit").help(help),
                ))
            }
            (Scope::Instance(own), Some((part, name))) => {
                Ok((find_inside(self.spec, own, part, path.span)?, name))
            }
            (_, Some((instance, name))) => {
                Ok((find_instance(self.spec, instance, path.span)?, name))
            }
        }
    }
}
