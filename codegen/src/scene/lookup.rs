//! Resolution of names in expressions: symbols, helpers, inputs.

use std::collections::HashMap;
use std::rc::Rc;

use machinist_algebra::cas::arithmetic;
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Function, Symbol};
use num_rational::BigRational;
use num_traits::Zero as _;

use crate::scene::layout::{
    FieldPart, Layout, Link, Local, Scope, Side, find_inside, find_instance,
};
use crate::scene::parameters;
use crate::scene::resolve::{Resolved, Resolver, Wanted, beyond_reason, fits, sound};
use crate::scene::typed::{Typed, Uses, product};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::{Angular, Dimension, Unit};
use crate::spec::expression::{Ast, Literal, Node};
use crate::spec::{
    Declared, DefinitionSpec, Formula, InputSpec, InstanceSpec, did_you_mean, quoted,
};
use machinist_model::Place;

/// pi to fifty digits, so that folding exact numbers loses nothing.
const PI: &str = "3.1415926535897932384626433832795028841971693993751";

/// A named expression of a scope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Definition {
    Helper(Scope, usize),
    Input(usize, usize),
    Output(usize, usize),
    Constraint(Scope, usize),
    /// The force of dry friction.
    Friction(Scope, usize),
    /// A parameter that is computed from others.
    Parameter(Scope, usize),
}

pub(super) enum State {
    Pending,
    Done(Rc<Typed>),
    Failed(Box<Mistake>),
}

impl Resolver<'_> {
    pub(super) fn name(
        &mut self,
        instance: Option<&str>,
        name: &str,
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let typed = match (instance, scope, name) {
            (None, _, "t") => {
                let unit = Unit { dimension: Dimension::TIME, rad: 0 };
                let uses = Uses { time: true, ..Uses::default() };
                self.leaf(Symbol::Time, unit, uses, span)?
            }
            (None, _, "pi") => {
                self.spend(1, span)?;
                let pi = Literal::parse(PI);
                let pi = Typed::number(&pi.map_or_else(BigRational::zero, |pi| pi.0), None);
                Typed { expr: Expr::Symbol(Symbol::Pi), ..pi }
            }
            (None, ..) => match self.of_field(name, span, scope) {
                Some(typed) => typed?,
                None => self.outside_of_field(name, span, scope)?,
            },
            (Some(path), ..) => {
                let instance = self.instance(path, span, scope)?;
                self.local(name, span, Scope::Instance(instance))?
            }
        };
        match typed.uses.beyond(allowed) {
            None => Ok(typed),
            Some(what) => {
                let message =
                    format!("{} depends on {what}, which is not allowed here", quoted(name));
                let help = match what {
                    "an acceleration" => {
                        "accelerations and slopes of fields may be used in outputs only"
                    }
                    "the force of a constraint" => {
                        "forces of constraints may be used in outputs, forces, rates of states and guards of events only"
                    }
                    "a velocity" => "write it with coordinates, states, time and parameters",
                    _ => "write it with numbers and parameters",
                };
                Err(Box::new(
                    Mistake::new(Code::ForbiddenDependence, span, message, "not allowed here")
                        .help(help),
                ))
            }
        }
    }

    /// Returns the instance of a path, as a scope sees it.
    pub(super) fn instance(
        &self,
        path: &str,
        span: Span,
        scope: Scope,
    ) -> Result<usize, Box<Mistake>> {
        match scope {
            Scope::Instance(own) | Scope::Density(own, _) => {
                find_inside(self.spec, own, path, span)
            }
            Scope::Scene | Scope::Profile => find_instance(self.spec, path, span),
        }
    }

    /// Resolves x and the quantities of the field, within its densities.
    fn of_field(&mut self, name: &str, span: Span, scope: Scope) -> Option<Resolved> {
        let position = Uses { position: true, ..Uses::default() };
        let metre = Unit { dimension: Dimension::LENGTH, rad: 0 };
        let place = Symbol::FirstOrder(FirstOrderId(0));
        let (instance, field) = match scope {
            Scope::Density(instance, field) => (instance, field),
            Scope::Profile if name == "x" => return Some(self.leaf(place, metre, position, span)),
            _ => return None,
        };
        let unit = self.spec.instances[instance].unit;
        let (symbol, rates, slopes) = match self.layout.units[unit].get(name)? {
            Local::Place => return Some(self.leaf(place, metre, position, span)),
            Local::Field(index, part) if index == field => match part {
                FieldPart::Value => (Symbol::Coordinate(CoordinateId(0)), 0, 0),
                FieldPart::Gradient => (Symbol::Coordinate(CoordinateId(1)), 0, 1),
                FieldPart::Rate => (Symbol::Velocity(CoordinateId(0)), 1, 0),
                FieldPart::GradientRate => (Symbol::Velocity(CoordinateId(1)), 1, 1),
            },
            _ => return None,
        };
        let declared = self.spec.units[unit].fields[field].unit.unit;
        let dimension = declared.per_second(rates).and_then(|unit| {
            let per_metres = Dimension::LENGTH.power(slopes, 1)?;
            Some(Unit { dimension: unit.dimension.over(per_metres)?, rad: unit.rad })
        });
        let uses = Uses { position: rates == 0, velocity: rates == 1, ..Uses::default() };
        Some(match dimension {
            Some(unit) => self.leaf(symbol, unit, uses, span),
            None => Err(Box::new(beyond_reason(span))),
        })
    }

    /// Resolves a name that is not the field's. Within a density it must not move.
    fn outside_of_field(&mut self, name: &str, span: Span, scope: Scope) -> Resolved {
        let typed = self.local(name, span, scope.base())?;
        if scope != scope.base() && typed.uses.moves() {
            let message = format!("{} belongs to the machine, not to the field", quoted(name));
            let help = "an expression along a field may use the field, x, t and parameters; join \
                        moving parts to a port";
            return Err(Box::new(
                Mistake::new(Code::ForbiddenDependence, span, message, "not of the field")
                    .help(help),
            ));
        }
        Ok(typed)
    }

    pub(super) fn local(&mut self, name: &str, span: Span, scope: Scope) -> Resolved {
        let names = match scope {
            Scope::Scene | Scope::Profile => &self.layout.scene,
            Scope::Instance(instance) | Scope::Density(instance, _) => {
                &self.layout.units[self.spec.instances[instance].unit]
            }
        };
        let Some(local) = names.get(name) else {
            if let Scope::Instance(instance) = scope
                && let Some((id, dimension)) = self.layout.closing(self.spec, instance, name)
            {
                let dimension = Dimension::ENERGY.over(dimension);
                let dimension = dimension.ok_or_else(|| beyond_reason(span))?;
                let uses = Uses { reaction: true, ..Uses::default() };
                return self.leaf(Symbol::Multiplier(id), Unit { dimension, rad: 0 }, uses, span);
            }
            let message = format!("unknown name {}", quoted(name));
            let help = did_you_mean(name, names.iter());
            return Err(Box::new(
                Mistake::new(Code::UnknownName, span, message, "unknown").help(help),
            ));
        };
        match (scope, local) {
            (scope, Local::Helper(index)) => {
                self.definition(Definition::Helper(scope, index), span)
            }
            (Scope::Instance(i), Local::Input(index)) => {
                self.definition(Definition::Input(i, index), span)
            }
            (Scope::Instance(i), Local::Output(index)) => {
                self.definition(Definition::Output(i, index), span)
            }
            (scope, Local::Parameter(index)) => {
                let Some(id) = self.layout.parameter(scope, index) else {
                    return self.definition(Definition::Parameter(scope.base(), index), span);
                };
                let unit = parameters::declared(self.spec, scope, index).unit.unit;
                self.leaf(Symbol::Parameter(id), unit, Uses::default(), span)
            }
            (scope, Local::Constraint(index)) => self.multiplier(scope, index, span),
            (scope, Local::Friction(index)) => {
                self.definition(Definition::Friction(scope, index), span)
            }
            (scope, Local::State(index)) => {
                let states = match scope.base() {
                    Scope::Instance(instance) => {
                        &self.spec.units[self.spec.instances[instance].unit].states
                    }
                    _ => &self.spec.states,
                };
                let symbol = Symbol::FirstOrder(self.layout.state(scope, index));
                let uses = Uses { position: true, ..Uses::default() };
                self.leaf(symbol, states[index].unit.unit, uses, span)
            }
            (Scope::Instance(instance), Local::Frame(index, part)) => {
                self.of_frame(instance, index, part, span)
            }
            (Scope::Instance(instance), Local::Scalar(index)) => {
                let symbol = Symbol::Coordinate(self.parts_of(instance, index).scalar);
                let uses = Uses { position: true, ..Uses::default() };
                self.leaf(symbol, Unit::default(), uses, span)
            }
            (Scope::Instance(instance), local) => self.motion(instance, local, span),
            _ => Err(Box::new(Mistake::new(
                Code::WrongKindOfName,
                span,
                "this name has no value",
                "not a value",
            ))),
        }
    }

    /// Resolves the force of a constraint. Its dimension is energy over the constrained
    /// expression, or power over it for a constraint on velocities.
    fn multiplier(&mut self, scope: Scope, index: usize, span: Span) -> Resolved {
        let constraint = self.definition(Definition::Constraint(scope, index), span)?;
        let work = if constraint.uses.velocity { Dimension::POWER } else { Dimension::ENERGY };
        let dimension = work.over(constraint.dimension.unwrap_or(Dimension::ONE));
        let dimension = dimension.ok_or_else(|| beyond_reason(span))?;
        let unit = Unit { dimension, rad: 0 };
        let uses = Uses { reaction: true, ..Uses::default() };
        self.leaf(Symbol::Multiplier(self.layout.constraint(scope, index)), unit, uses, span)
    }

    /// Resolves a coordinate or its rates.
    fn motion(&mut self, instance: usize, local: Local, span: Span) -> Resolved {
        let unit = &self.spec.units[self.spec.instances[instance].unit];
        let none = Uses::default();
        let (index, order, uses) = match local {
            Local::Velocity(index) => (index, 1, Uses { velocity: true, ..none }),
            Local::Acceleration(index) => (index, 2, Uses { acceleration: true, ..none }),
            Local::Coordinate(index) => (index, 0, Uses { position: true, ..none }),
            Local::Slope(port, side) => return self.slope(instance, port, side, span),
            Local::Place | Local::Field(..) => {
                let help = "use its value at a port, by the name of the port";
                let mistake = Mistake::new(
                    Code::WrongKindOfName,
                    span,
                    "a field has no single value",
                    "along a field",
                );
                return Err(Box::new(mistake.help(help)));
            }
            _ => {
                return Err(Box::new(Mistake::new(
                    Code::WrongKindOfName,
                    span,
                    "this name has no value",
                    "not a value",
                )));
            }
        };
        let coordinate = &unit.coordinates[index];
        let declared = if order == 0 {
            coordinate.unit.unit
        } else {
            coordinate.unit_of_rate(order).ok_or_else(|| beyond_reason(span))?.1
        };
        let Link { id, factor } = self.layout.link(instance, index);
        let symbol = match order {
            0 => Symbol::Coordinate(*id),
            1 => Symbol::Velocity(*id),
            _ => Symbol::Acceleration(*id),
        };
        let mut typed = self.leaf(symbol, declared, uses, span)?;
        if let Some(factor) = factor {
            let leaves = leaves(factor);
            self.spend(leaves, span)?;
            typed.terms += leaves;
            typed.depth += 3;
            typed.expr = product(vec![factor.clone(), typed.expr]);
        }
        Ok(typed)
    }

    /// Resolves the derivative along a field on one side of a port.
    fn slope(&mut self, instance: usize, port: usize, side: Side, span: Span) -> Resolved {
        let unit = &self.spec.units[self.spec.instances[instance].unit];
        let at = self.layout.attachment_of(instance, port);
        let Some((index, attachment)) = at.map(|index| (index, &self.layout.attachments[index]))
        else {
            return Err(Box::new(Mistake::new(
                Code::WrongKindOfName,
                span,
                "this name has no value",
                "not a value",
            )));
        };
        let outside = match side {
            Side::Before => attachment.place == Place::Start,
            Side::After => attachment.place == Place::End,
        };
        if outside {
            let message = "the field ends at this port";
            return Err(Box::new(Mistake::new(
                Code::InvalidField,
                span,
                message,
                "no field on this side",
            )));
        }
        let declared = unit.fields[attachment.field].unit.unit;
        let dimension = declared.dimension.over(Dimension::LENGTH);
        let dimension = dimension.ok_or_else(|| beyond_reason(span))?;
        let slope = Unit { dimension, rad: declared.rad };
        let which = if side == Side::Before { 2 } else { 3 };
        let symbol = Symbol::Handed(Layout::handed(index, which));
        // It is known after the motion, like an acceleration: in outputs only.
        let uses = Uses { acceleration: true, ..Uses::default() };
        self.leaf(symbol, slope, uses, span)
    }

    fn leaf(&mut self, symbol: Symbol, unit: Unit, uses: Uses, span: Span) -> Resolved {
        self.spend(1, span)?;
        let angular = Angular::of(unit, uses.moves());
        Ok(Typed::leaf(Expr::Symbol(symbol), unit.dimension, angular, uses))
    }

    /// Resolves a helper, input or output, once; later uses copy it.
    fn definition(&mut self, definition: Definition, span: Span) -> Resolved {
        let done = match self.definitions.get(&definition) {
            Some(State::Done(done)) => Rc::clone(done),
            Some(State::Failed(mistake)) => return Err(mistake.clone()),
            Some(State::Pending) => {
                let mistake = Mistake::new(
                    Code::CyclicDefinition,
                    span,
                    "this definition refers to itself",
                    "back to itself",
                );
                return Err(Box::new(mistake.help("a helper cannot depend on itself")));
            }
            None => {
                self.definitions.insert(definition, State::Pending);
                self.descend(span, 0)?;
                let (level, spent) = (self.level, std::mem::take(&mut self.spent));
                let resolved = self.resolve_definition(definition);
                (self.level, self.spent) = (level, spent);
                match resolved {
                    Ok(typed) => {
                        let done = Rc::new(typed);
                        self.definitions.insert(definition, State::Done(Rc::clone(&done)));
                        done
                    }
                    Err(mistake) => {
                        self.definitions.insert(definition, State::Failed(mistake.clone()));
                        return Err(mistake);
                    }
                }
            }
        };
        self.descend(span, done.depth + 1)?;
        self.spend(done.terms, span)?;
        let mut typed = Typed::clone(&done);
        typed.depth += 1;
        Ok(typed)
    }

    fn resolve_definition(&mut self, definition: Definition) -> Resolved {
        let spec = self.spec;
        let unit = |instance: usize| &spec.units[spec.instances[instance].unit];
        match definition {
            Definition::Helper(Scope::Scene | Scope::Profile, index) => {
                let typed =
                    self.named(&spec.helpers[index], Scope::Scene, "helper", Uses::GUARD)?;
                Ok(if self.are_long(None) { shared(typed) } else { typed })
            }
            Definition::Helper(
                scope @ (Scope::Instance(instance) | Scope::Density(instance, _)),
                index,
            ) => {
                let helper = &unit(instance).helpers[index];
                let typed = self.named(helper, scope, "helper", Uses::GUARD)?;
                let is_long = self.are_long(Some(spec.instances[instance].unit));
                Ok(if is_long { shared(typed) } else { typed })
            }
            Definition::Output(instance, index) => {
                let output = &unit(instance).outputs[index];
                self.named(output, Scope::Instance(instance), "output", Uses::ANYTHING)
            }
            Definition::Parameter(scope, index) => {
                let typed =
                    self.given(scope, index, parameters::declared(spec, scope, index).name.span)?;
                Ok(declared(typed, &parameters::declared(spec, scope, index).unit))
            }
            Definition::Constraint(scope, index) => {
                let constraint = match scope.base() {
                    Scope::Instance(instance) => &unit(instance).constraints[index],
                    _ => &spec.constraints[index],
                };
                self.resolve(&constraint.expression, scope, Uses::MOTION)
            }
            Definition::Friction(scope, index) => {
                let friction = match scope.base() {
                    Scope::Instance(instance) => &unit(instance).frictions[index],
                    _ => &spec.frictions[index],
                };
                self.named(&friction.force, scope, "friction", Uses::GUARD)
            }
            Definition::Input(instance, index) => {
                let input = &unit(instance).inputs[index];
                let instance = &spec.instances[instance];
                let bound = instance.inputs.iter().find(|(name, _)| name.value == input.name.value);
                let Some((_, formula)) = bound else {
                    return Err(Box::new(unbound(input, instance)));
                };
                let what = format!("input {}", quoted(&input.name.value));
                let wanted = Wanted::new(input.unit.unit.dimension, what).of(Uses::GUARD);
                let scope = Scope::within(instance.parent);
                let typed = match formula {
                    Formula::Expression(ast) => self.nested(ast, scope, &wanted)?,
                    Formula::Number(_) => self.formula(formula, scope, &wanted)?,
                };
                Ok(declared(typed, &input.unit))
            }
        }
    }

    /// Returns whether helpers of a unit, or of the scene, are to be shared: written out wherever they
    /// are used, long helpers that use each other, such as the places along an arm, would grow
    /// exponentially.
    fn are_long(&mut self, unit: Option<usize>) -> bool {
        let spec = self.spec;
        let helpers = unit.map_or(&spec.helpers, |unit| &spec.units[unit].helpers);
        let coordinates = unit.map_or(&[][..], |unit| &spec.units[unit].coordinates);
        let moves = |name: &str| coordinates.iter().any(|one| one.name.value == name);
        *self.long_helpers.entry(unit).or_insert_with(|| are_long(helpers, moves))
    }

    fn named(
        &mut self,
        definition: &DefinitionSpec,
        scope: Scope,
        kind: &str,
        allowed: Uses,
    ) -> Resolved {
        let what = format!("{kind} {}", quoted(&definition.name.value));
        let wanted = Wanted::new(definition.unit.unit.dimension, what).of(allowed);
        let typed = self.nested(&definition.expression, scope, &wanted)?;
        Ok(declared(typed, &definition.unit))
    }

    /// Resolves like [`Resolver::expect`], but counts levels from the place of use, so that a
    /// chain of definitions cannot exhaust the stack.
    pub(super) fn nested(&mut self, ast: &Ast, scope: Scope, wanted: &Wanted) -> Resolved {
        self.level += 1;
        let typed = match &ast.node {
            Node::Sum(terms) => self.sum(terms, scope, wanted.allowed, Some(wanted)),
            _ => self.resolve(ast, scope, wanted.allowed),
        };
        self.level -= 1;
        let typed = typed?;
        fits(ast.span, &typed, wanted)?;
        sound(typed, ast.span)
    }
}

/// Returns the mistake of an input that the scene does not bind.
fn unbound(input: &InputSpec, instance: &InstanceSpec) -> Mistake {
    let (name, of) = (quoted(&input.name.value), quoted(&instance.name.value));
    let help = format!(
        "write inputs = {{ {} = \"...\" }}, an expression in {}",
        input.name.value, input.unit.text
    );
    let message = format!("input {name} of {of} is not bound");
    Mistake::new(Code::UnboundInput, instance.name.span, message, "lacks an input").help(help)
}

/// Gives a named expression its declared unit.
fn declared(mut typed: Typed, unit: &Declared) -> Typed {
    typed.dimension = Some(unit.unit.dimension);
    typed.angular = Angular::of(unit.unit, typed.uses.moves());
    typed
}

/// Returns a helper of the motion as a shared part. Parts that may switch stay visible.
fn shared(mut typed: Typed) -> Typed {
    let moves = |symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_));
    if typed.expr.mentions(moves) && is_smooth(&typed.expr) {
        typed.expr = arithmetic::normal_form(&typed.expr).shared();
        (typed.terms, typed.depth) = (1, 0);
    }
    typed
}

/// Returns whether one of some helpers mentions many coordinates, with those written out that it uses.
fn are_long(helpers: &[DefinitionSpec], moves: impl Fn(&str) -> bool) -> bool {
    /// Number of coordinates, each as often as it occurs. The places of a chain of 31 links, whose last
    /// helpers have as many, make a model of the same size with and without shared parts. Shorter
    /// chains become smaller without them, by up to a fifth, and longer ones with them, at a third
    /// of the time from 40 links on.
    const LONG: usize = 32;
    let mut lengths: HashMap<&str, usize> = HashMap::new();
    loop {
        let mut has_changed = false;
        for helper in helpers {
            let mut length = 0;
            helper.expression.visit(&mut |part| {
                length += match &part.node {
                    Node::Name(None, name) => {
                        let known = lengths.get(name.as_str()).copied();
                        known.unwrap_or_else(|| usize::from(moves(name)))
                    }
                    Node::Name(..) => 1,
                    _ => 0,
                };
            });
            if length >= LONG {
                return true;
            }
            has_changed |= lengths.insert(&helper.name.value, length) != Some(length);
        }
        if !has_changed {
            return false;
        }
    }
}

fn is_smooth(expr: &Expr) -> bool {
    let mut is_smooth = true;
    Expr::visit_all([expr], &mut |part| {
        is_smooth &= match part {
            Expr::Call(function, _) => !matches!(
                function,
                Function::Abs | Function::Floor | Function::SelectLess | Function::Table { .. }
            ),
            Expr::Symbol(symbol) => matches!(
                symbol,
                Symbol::Pi
                    | Symbol::Time
                    | Symbol::Coordinate(_)
                    | Symbol::Velocity(_)
                    | Symbol::Parameter(_)
            ),
            _ => true,
        }
    });
    is_smooth
}

/// Counts the leaves of an expression.
fn leaves(expr: &Expr) -> usize {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => 1,
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            parts.iter().map(leaves).sum()
        }
        Expr::Power(base, exponent) => leaves(base) + leaves(exponent),
    }
}
