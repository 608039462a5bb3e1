//! Generalized forces of units and of the scene, by virtual work.

use std::collections::BTreeSet;

use machinist_algebra::cas::arithmetic::{negative, normal_form};

use crate::scene::along::{self, NoRate};
use crate::scene::assemble::Assembler;
use crate::scene::frames::find;
use crate::scene::layout::{Layout, Local, Scope, coordinate_spec, find_port, unknown_coordinate};
use crate::scene::ports::{dimension_of, ratio_of};
use crate::scene::resolve::{MAX_TERMS, Wanted, beyond_reason};
use crate::scene::system::GeneralizedForce;
use crate::scene::typed::{Uses, integer, product, sum};
use crate::spatial::vector::{times, zero};
use crate::spec::body::{Components, LoadSpec};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::expression::Ast;
use crate::spec::{Acts, Formula, UnitSpec, quoted};
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};

/// A force on a coordinate of the scene.
type OnCoordinate = (CoordinateId, Expr);

impl Assembler<'_> {
    /// Returns Q of each coordinate of the scene. By virtual work, a force on a coordinate that
    /// follows another by a factor acts on that one times the factor.
    pub(super) fn forces(&mut self) -> Vec<GeneralizedForce> {
        let count = self.layout.representatives.len();
        let mut forces: Vec<[Vec<Expr>; 2]> = vec![Default::default(); count];
        for (index, _, unit) in self.instances() {
            for force in &unit.forces {
                let found = match &force.acts {
                    Acts::On(coordinate) => {
                        self.on_coordinate(coordinate, &force.expression, index, unit)
                    }
                    Acts::Along(along) => {
                        self.along(along, &force.expression, Scope::Instance(index))
                    }
                };
                for (id, q) in self.noted(found) {
                    if force.conversion {
                        forces[id.0 as usize][1].push(q.clone());
                    }
                    forces[id.0 as usize][0].push(q);
                }
            }
        }
        for (index, _, unit) in self.instances() {
            for load in &unit.loads {
                let found = self.load(load, index, unit);
                for (id, q) in self.noted(found) {
                    if load.conversion {
                        forces[id.0 as usize][1].push(q.clone());
                    }
                    forces[id.0 as usize][0].push(q);
                }
            }
        }
        for force in &self.spec.forces {
            let found = match &force.acts {
                Acts::On(port) => self.on_port(port, &force.expression),
                Acts::Along(along) => self.along(along, &force.expression, Scope::Scene),
            };
            for (id, q) in self.noted(found) {
                forces[id.0 as usize][0].push(q);
            }
        }
        let forces = forces.into_iter().map(|force| force.map(sum));
        forces.map(|[total, conversion]| GeneralizedForce { total, conversion }).collect()
    }

    fn noted(&mut self, found: Result<Vec<OnCoordinate>, Box<Mistake>>) -> Vec<OnCoordinate> {
        found.unwrap_or_else(|mistake| {
            self.mistakes.push(*mistake);
            Vec::new()
        })
    }

    fn on_coordinate(
        &mut self,
        name: &Spanned<String>,
        expression: &Ast,
        instance: usize,
        unit: &UnitSpec,
    ) -> Result<Vec<OnCoordinate>, Box<Mistake>> {
        let names = &self.layout.units[self.spec.instances[instance].unit];
        let Some(Local::Coordinate(place)) = names.get(&name.value) else {
            return Err(Box::new(unknown_coordinate(name, unit)));
        };
        let slot = self.layout.slot(instance, place);
        let own = coordinate_spec(self.spec, self.layout, slot).unit.unit.dimension;
        let q = self.force_along(expression, Scope::Instance(instance), slot, own)?;
        Ok(vec![q])
    }

    fn on_port(
        &mut self,
        port: &Spanned<String>,
        expression: &Ast,
    ) -> Result<Vec<OnCoordinate>, Box<Mistake>> {
        let (port, slot) = find_port(self.spec, self.layout, port)?;
        let dimension = dimension_of(self.spec, self.layout, port, slot);
        let ratio = ratio_of(&mut self.resolver, port, slot)?;
        let (id, q) = self.force_along(expression, Scope::Scene, slot, dimension)?;
        Ok(vec![(id, product(ratio.into_iter().chain([q]).collect()))])
    }

    /// Resolves a force and a torque at a frame: Q_j = F dv/dq'_j + T domega/dq'_j along the tree, less
    /// those of the frame that takes the reaction at the same point.
    fn load(
        &mut self,
        load: &LoadSpec,
        instance: usize,
        unit: &UnitSpec,
    ) -> Result<Vec<OnCoordinate>, Box<Mistake>> {
        let scope = Scope::Instance(instance);
        let spatial = self.resolver.spatial(instance, load.name.span)?;
        let frame = |name: &Spanned<String>| {
            Ok::<_, Box<Mistake>>(find(unit, name)?.map(|index| (instance, index)))
        };
        let at = frame(&load.frame)?;
        let against = load.against.as_ref().map(frame).transpose()?;
        let axes = load.axes.as_ref().map_or(Ok(None), frame)?;
        let mut along = |given: &Option<Components>, dimension, what: &str| match given {
            None => Ok(zero()),
            Some(given) => {
                let wanted = Wanted::new(dimension, what);
                let mut all = zero();
                for (entry, formula) in all.iter_mut().zip(given) {
                    let force = match formula {
                        Formula::Expression(ast) => {
                            self.resolver.expect_force(ast, scope, wanted.clone())?
                        }
                        Formula::Number(_) => self.resolver.formula(formula, scope, &wanted)?,
                    };
                    *entry = normal_form(&force.expr);
                }
                let rotation = spatial.mechanism.placed(spatial.frame(axes)).rotation;
                Ok::<_, Box<Mistake>>(times(&rotation, &all))
            }
        };
        let force = along(&load.force, Dimension::FORCE, "a component of the force")?;
        let torque = along(&load.torque, Dimension::ENERGY, "a component of the torque")?;
        let point = spatial.mechanism.placed(spatial.frame(at)).position;
        let wrench = [force, torque];
        let on = |frame| spatial.mechanism.generalized(spatial.frame(frame), &point, &wrench);
        let mut all: Vec<OnCoordinate> = on(at).into_iter().collect();
        if let Some(against) = against {
            all.extend(on(against).into_iter().map(|(id, q)| (id, negative(&q))));
        }
        if all.is_empty() {
            let message = format!("load {} acts on nothing that moves", quoted(&load.name.value));
            return Err(Box::new(Mistake::new(
                Code::NoEffect,
                load.frame.span,
                message,
                "fixed to the world",
            )));
        }
        Ok(all)
    }

    /// Resolves a force on a coordinate that does work along a quantity with a dimension.
    fn force_along(
        &mut self,
        ast: &Ast,
        scope: Scope,
        slot: usize,
        along: Dimension,
    ) -> Result<OnCoordinate, Box<Mistake>> {
        let coordinate = coordinate_spec(self.spec, self.layout, slot);
        let dimension = Dimension::ENERGY.over(along);
        let what = format!("the force on {}", quoted(&coordinate.name.value));
        let wanted = Wanted::new(dimension.unwrap_or(Dimension::ENERGY), what);
        let force = self.resolver.expect_force(ast, scope, wanted)?.expr;
        let link = self.layout.link_of(slot);
        Ok((link.id, product(vec![Layout::factor(link), force])))
    }

    /// Resolves a force F along x(q, t): Q_j = F dx/dq_j, so that Q q' is F times the rate of x
    /// by the coordinates.
    fn along(
        &mut self,
        along: &Ast,
        expression: &Ast,
        scope: Scope,
    ) -> Result<Vec<OnCoordinate>, Box<Mistake>> {
        let way = self.resolver.expect_any(along, scope)?;
        if let Some(what) = way.uses.beyond(Uses::PLACE) {
            let message = format!("the `along` of a force depends on {what}");
            let mistake = Mistake::new(Code::InvalidForce, along.span, message, "not allowed here");
            return Err(Box::new(mistake.help("write it with coordinates, time and parameters")));
        }
        let dimension = way.dimension.and_then(|along| Dimension::ENERGY.over(along));
        let dimension = dimension.ok_or_else(|| beyond_reason(along.span))?;
        let wanted = Wanted::new(dimension, "the force");
        let force = self.resolver.expect_force(expression, scope, wanted)?;
        let orientations = self.resolver.orientations();
        let moving = way.expr.symbols().into_iter().filter_map(|symbol| match symbol {
            Symbol::Coordinate(id) => Some(orientations.velocities(id)),
            _ => None,
        });
        let moving: BTreeSet<CoordinateId> = moving.flatten().collect();
        let mut forces = Vec::new();
        for id in moving {
            let moves = orientations.moves(id);
            let of = |symbol| {
                let moved = moves.iter().find(|(part, _)| symbol == Symbol::Coordinate(*part));
                Some(moved.map_or_else(|| integer(0), |(_, slope)| slope.clone()))
            };
            let (slope, _) = along::slope_by(&way.expr, MAX_TERMS, &of).map_err(|why| {
                let message = match why {
                    NoRate::TooLarge => {
                        format!("the derivative of this has more than {MAX_TERMS} terms")
                    }
                    NoRate::Unknown(_) => "the derivative of this is not known".to_owned(),
                };
                Mistake::new(Code::NoDerivative, along.span, message, "along this")
            })?;
            if !slope.is_zero() {
                forces.push((id, product(vec![slope, force.expr.clone()])));
            }
        }
        if forces.is_empty() {
            let message = "the `along` of a force depends on no coordinate";
            let mistake = Mistake::new(Code::InvalidForce, along.span, message, "does not move");
            return Err(Box::new(mistake.help("a force along it would do no work")));
        }
        Ok(forces)
    }
}
