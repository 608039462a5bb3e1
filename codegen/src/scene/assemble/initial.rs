//! Initial values.

use crate::scene::assemble::Assembler;
use crate::scene::assemble::distributed::Profiles;
use crate::scene::evaluate::evaluate;
use crate::scene::layout::{Local, Scope};
use crate::scene::resolve::Wanted;
use crate::scene::typed::{Uses, integer, product, reciprocal};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::{Formula, did_you_mean, quoted};
use machinist_algebra::expr::{Expr, ParameterId};

/// Initial values of all states, of parameters only.
pub struct Initial {
    /// Position and velocity of each coordinate of the scene.
    pub coordinates: Vec<[Expr; 2]>,
    /// True for position and velocity, respectively, if the spec gives them, so that constraints
    /// may not change them.
    pub given: Vec<[bool; 2]>,
    /// Initial value of each first-order state.
    pub states: Vec<Expr>,
    /// Initial value of the part w of each orientation.
    pub scalars: Vec<Expr>,
    /// True if the spec gives it.
    pub given_scalars: Vec<bool>,
}

/// A line of `[initial]` or `[guess]`.
struct Entry<'a> {
    is_given: bool,
    scope: Scope,
    name: &'a Spanned<String>,
    formula: &'a Formula,
}

/// Quantity that an entry of `[initial]`, or an event, sets.
pub enum Target {
    /// Coordinate of the scene, 0 or 1 for its velocity, and the factor by which the named one
    /// follows it.
    Coordinate(usize, usize, Option<Expr>),
    State(usize),
    /// The part w of an orientation.
    Scalar(usize),
}

impl<'a> Assembler<'a> {
    /// Returns the initial values of the machine, and those of its fields along x.
    pub(super) fn initial(&mut self) -> (Initial, Profiles) {
        let coordinates = self.layout.representatives.iter().map(|_| [integer(0), integer(0)]);
        let mut initial = Initial {
            coordinates: coordinates.collect(),
            given: vec![[false; 2]; self.layout.representatives.len()],
            states: self.of_units(),
            scalars: Vec::new(),
            given_scalars: Vec::new(),
        };
        self.orient(&mut initial);
        // Quantities set so far, and their scopes: the scene precedes its units, which precede
        // their parts.
        let mut set: Vec<((usize, usize), Scope)> = Vec::new();
        self.refuse_guesses();
        let mut profiles = Profiles::new();
        for Entry { is_given, scope, name, formula } in self.entries() {
            if is_given && scope == Scope::Scene && self.profile(name, formula, &mut profiles) {
                continue;
            }
            let (target, dimension) = match self.target(name, scope) {
                Ok(found) => found,
                Err(mistake) => {
                    self.mistakes.push(*mistake);
                    continue;
                }
            };
            let what = format!("the initial value of {}", quoted(&name.value));
            let value = self.initial_value(formula, scope, dimension, what);
            let key = match &target {
                Target::State(index) => (*index, 2),
                Target::Coordinate(index, order, _) => (*index, *order),
                Target::Scalar(index) => (*index, 3),
            };
            if let Some((_, by)) = set.iter().find(|(known, _)| *known == key) {
                if *by == scope {
                    let message = format!("two initial values of {}", quoted(&name.value));
                    let mistake =
                        Mistake::new(Code::DuplicateName, name.span, message, "given again");
                    self.mistakes.push(mistake.help("joined coordinates start together"));
                }
                continue;
            }
            set.push((key, scope));
            match target {
                Target::State(index) => initial.states[index] = value,
                Target::Scalar(index) => {
                    initial.scalars[index] = value;
                    initial.given_scalars[index] = is_given;
                }
                Target::Coordinate(index, order, factor) => {
                    let value = match factor {
                        Some(factor) => product(vec![value, reciprocal(factor)]),
                        None => value,
                    };
                    initial.given[index][order] = is_given;
                    initial.coordinates[index][order] = value;
                }
            }
        }
        self.start_on_fields(&profiles, &mut initial);
        (initial, profiles)
    }

    /// Returns all initial values: those of the scene, then those of units from the outside in.
    /// In each, given values precede guesses.
    fn entries(&self) -> Vec<Entry<'a>> {
        let spec = self.spec;
        let units = self.instances().map(|(index, _, unit)| {
            (Scope::Instance(index), &unit.inside.initial, &unit.inside.guess)
        });
        let all = std::iter::once((Scope::Scene, &spec.initial, &spec.guess)).chain(units);
        let entries = all.flat_map(|(scope, initial, guess)| {
            let given = initial.iter().map(move |entry| (true, entry));
            let guessed = guess.iter().map(move |entry| (false, entry));
            given.chain(guessed).map(move |(is_given, (name, formula))| Entry {
                is_given,
                scope,
                name,
                formula,
            })
        });
        entries.collect()
    }

    /// Rejects guesses without constraints that could determine the values.
    fn refuse_guesses(&mut self) {
        let spec = self.spec;
        let mut constraints = spec.constraints.len();
        constraints += self.instances().map(|(_, _, unit)| unit.constraints.len()).sum::<usize>();
        constraints += self.layout.cuts.len();
        if constraints == 0
            && let Some((name, _)) = spec.guess.first()
        {
            let message = "guesses are allowed only in scenes with constraints";
            let mistake = Mistake::new(Code::InvalidStart, name.span, message, "a guess");
            self.mistakes.push(mistake.help("give the value in [initial]"));
        }
        for Entry { scope, name, .. } in self.entries().iter().filter(|entry| !entry.is_given) {
            if let Ok((Target::State(_), _)) = self.target(name, *scope) {
                let message = format!("{} is not a coordinate or velocity", quoted(&name.value));
                let mistake =
                    Mistake::new(Code::WrongKindOfName, name.span, message, "a first-order state");
                self.mistakes.push(mistake.help("constraints do not change it: use [initial]"));
            }
        }
    }

    /// Sets the initial parts of orientations by the rotations of their units.
    fn orient(&mut self, initial: &mut Initial) {
        for (instance, _, unit) in self.instances() {
            for (index, orientation) in unit.orientations.iter().enumerate() {
                if !self.layout.has_orientation(instance, index) {
                    continue;
                }
                let scope = Scope::Instance(instance);
                let found = self.resolver.quaternion_of(&orientation.rotations, scope);
                let [w, vector @ ..] = found.unwrap_or_else(|mistake| {
                    self.mistakes.push(*mistake);
                    [1, 0, 0, 0].map(integer)
                });
                let parts = self.resolver.parts_of(instance, index);
                for (id, value) in parts.vector.into_iter().zip(vector) {
                    initial.coordinates[id.0 as usize][0] = value;
                }
                initial.scalars.push(w);
                initial.given_scalars.push(false);
            }
        }
    }

    /// Returns the initial values of states given by their units, or by the scene.
    fn of_units(&mut self) -> Vec<Expr> {
        let mut values = Vec::new();
        for (scope, _, state) in self.states() {
            let what = format!("the initial value of {}", quoted(&state.name.value));
            let dimension = state.unit.unit.dimension;
            values.push(state.initial.as_ref().map_or_else(
                || integer(0),
                |formula| self.initial_value(formula, scope, dimension, what),
            ));
        }
        values
    }

    fn initial_value(
        &mut self,
        formula: &Formula,
        scope: Scope,
        dimension: Dimension,
        what: String,
    ) -> Expr {
        let wanted = Wanted::new(dimension, what).of(Uses::PARAMETERS);
        let resolved = self.resolver.formula(formula, scope, &wanted);
        let good = resolved.is_ok();
        let expr = self.note(resolved);
        if good {
            self.finite(&expr, formula.span(), "an initial value");
        }
        expr
    }

    /// Checks that an expression of parameters is finite at their values in the spec.
    pub(super) fn finite(&mut self, expr: &Expr, span: Span, what: &str) {
        let value = evaluate(expr, &|id: ParameterId| self.values[id.0 as usize]);
        if !value.is_finite() {
            let message = format!("{what} must be a finite number, but this is {value}");
            self.mistakes.push(Mistake::new(Code::UndefinedValue, span, message, "not finite"));
        }
    }

    pub(super) fn target(
        &self,
        path: &Spanned<String>,
        scope: Scope,
    ) -> Result<(Target, Dimension), Box<Mistake>> {
        if let (Scope::Scene, Some(index)) = (scope, self.own_state(&path.value)) {
            let id = self.layout.state(scope, index).0 as usize;
            return Ok((Target::State(id), self.spec.states[index].unit.unit.dimension));
        }
        if scope == Scope::Scene && !path.value.contains('.') {
            let message = format!("{} cannot have an initial value", quoted(&path.value));
            let mistake = Mistake::new(Code::InvalidStart, path.span, message, "not instance.name");
            return Err(Box::new(mistake.help("write \"instance.name\" = value")));
        }
        let (instance, name) = self.owner(path, scope)?;
        self.target_of(instance, name, path)
    }

    /// Finds the scene's own state or mode of a name.
    pub(super) fn own_state(&self, name: &str) -> Option<usize> {
        match self.layout.scene.get(name) {
            Some(Local::State(index)) => Some(index),
            _ => None,
        }
    }

    /// Finds the quantity `name` of an instance; `path` is its spelling in the spec.
    pub(super) fn target_of(
        &self,
        instance: usize,
        name: &str,
        path: &Spanned<String>,
    ) -> Result<(Target, Dimension), Box<Mistake>> {
        let unit_index = self.spec.instances[instance].unit;
        let (unit, names) = (&self.spec.units[unit_index], &self.layout.units[unit_index]);
        let (index, order) = match names.get(name) {
            Some(Local::Coordinate(index)) => (index, 0),
            Some(Local::Velocity(index)) => (index, 1),
            Some(Local::Scalar(index)) => {
                // Asks for its parts, in case that they are left out.
                self.resolver.parts_of(instance, index);
                let number = self.layout.orientation(instance, index);
                return Ok((Target::Scalar(number), Dimension::ONE));
            }
            Some(Local::State(index)) => {
                let id = self.layout.state(Scope::Instance(instance), index).0 as usize;
                return Ok((Target::State(id), unit.states[index].unit.unit.dimension));
            }
            _ => {
                let message = format!("{} has no initial value", quoted(&path.value));
                let coordinates = unit.coordinates.iter();
                let coordinates = coordinates.flat_map(|c| [&c.name.value, &c.velocity.value]);
                let known = coordinates.chain(unit.states.iter().map(|state| &state.name.value));
                let help = did_you_mean(name, known.map(String::as_str));
                let label = "no coordinate, velocity or state";
                return Err(Box::new(
                    Mistake::new(Code::InvalidStart, path.span, message, label).help(help),
                ));
            }
        };
        if self.layout.is_held(self.layout.slot(instance, index)) {
            let message = format!("{} is fixed, by its unit or by a joint", quoted(&path.value));
            let mistake = Mistake::new(Code::InvalidStart, path.span, message, "fixed at zero");
            return Err(Box::new(mistake.help("leave it out")));
        }
        let link = self.layout.link(instance, index);
        let stands_for = self.layout.representatives.get(link.id.0 as usize);
        if stands_for.is_none_or(|slot| self.layout.attachment(*slot).is_some())
            || self.layout.is_fixed(self.layout.slot(instance, index))
        {
            let message = format!("{} takes its initial value from its field", quoted(&path.value));
            let help = "give the field's initial value, an expression of x";
            return Err(Box::new(
                Mistake::new(Code::InvalidStart, path.span, message, "part of a field").help(help),
            ));
        }
        let target = Target::Coordinate(link.id.0 as usize, order, link.factor.clone());
        let coordinate = &unit.coordinates[index];
        let own = coordinate.unit.unit;
        let rate = || coordinate.unit_of_rate(order as i32).map_or(own, |(_, unit)| unit);
        let dimension = if order == 0 { own } else { rate() }.dimension;
        Ok((target, dimension))
    }
}
