//! Fields of instances, and the numbers they pass to the machine at their ports.

use std::collections::BTreeMap;

use machinist_algebra::expr::{
    CoordinateId, Expr, FirstOrderId, Function, HandedId, ParameterId, Symbol,
};
use num_rational::BigRational;

use crate::scene::assemble::initial::Initial;
use crate::scene::assemble::{Assembler, per_second, quantity};
use crate::scene::attachments::ends;
use crate::scene::evaluate::evaluate;
use crate::scene::layout::{FieldPart, Layout, Local, Scope};
use crate::scene::resolve::Wanted;
use crate::scene::system::{Attachment, Field, GeneralizedForce, Parameter};
use crate::scene::typed::{Uses, integer, product, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::expression::Ast;
use crate::spec::{Boundary, FieldSpec, Formula, quoted};
use machinist_contract::field::HANDED;

/// Initial u and u_t of fields by instance, field and 0 or 1.
pub type Profiles = BTreeMap<(usize, usize, usize), Expr>;

const VALUE: Symbol = Symbol::Coordinate(CoordinateId(0));
const SLOPE: Symbol = Symbol::Coordinate(CoordinateId(1));
const RATE: Symbol = Symbol::Velocity(CoordinateId(0));
const SLOPE_RATE: Symbol = Symbol::Velocity(CoordinateId(1));
const PLACE: Symbol = Symbol::FirstOrder(FirstOrderId(0));

impl Assembler<'_> {
    /// Reads an initial value of a field; false if it is not one.
    pub(super) fn profile(
        &mut self,
        name: &Spanned<String>,
        formula: &Formula,
        profiles: &mut Profiles,
    ) -> bool {
        let Some((instance, own)) = name.value.rsplit_once('.') else { return false };
        let named = |known: &&crate::spec::InstanceSpec| known.name.value == instance;
        let Some(index) = self.spec.instances.iter().position(|known| named(&known)) else {
            return false;
        };
        let unit = self.spec.instances[index].unit;
        let (field, order) = match self.layout.units[unit].get(own) {
            Some(Local::Field(field, FieldPart::Value)) => (field, 0),
            Some(Local::Field(field, FieldPart::Rate)) => (field, 1),
            _ => return false,
        };
        let declared = self.spec.units[unit].fields[field].unit.unit;
        let dimension = declared.per_second(order as i32).unwrap_or(declared).dimension;
        let what = format!("the initial value of {}", quoted(&name.value));
        let allowed = Uses { position: true, ..Uses::PARAMETERS };
        let wanted = Wanted::new(dimension, what).of(allowed);
        let resolved = self.resolver.formula(formula, Scope::Profile, &wanted);
        let expr = self.note(resolved);
        if profiles.insert((index, field, order), expr).is_some() {
            let message = format!("two initial values of {}", quoted(&name.value));
            self.mistakes.push(Mistake::new(
                Code::DuplicateName,
                name.span,
                message,
                "given again",
            ));
        }
        true
    }

    /// Sets the initial values of places on fields to those of the fields.
    pub(super) fn start_on_fields(&self, profiles: &Profiles, initial: &mut Initial) {
        for (id, slot) in self.layout.representatives.iter().enumerate() {
            let Some(at) = self.layout.attachment(*slot) else { continue };
            for order in [0, 1] {
                if let Some(profile) = profiles.get(&(at.instance, at.field, order)) {
                    let here = |symbol| (symbol == PLACE).then(|| at.expr.clone());
                    initial.coordinates[id][order] = profile.replace(&here);
                }
            }
        }
    }

    /// Returns the fields of all instances.
    pub(super) fn fields(&mut self, profiles: &Profiles) -> Vec<Field> {
        let mut fields = Vec::new();
        for (index, instance, unit) in self.instances() {
            for (number, field) in unit.fields.iter().enumerate() {
                let densities = self.densities(index, number, field);
                let profile = |order| {
                    profiles.get(&(index, number, order)).cloned().unwrap_or_else(|| integer(0))
                };
                let choice =
                    instance.fields.iter().find(|choice| choice.field.value == field.name.value);
                let Some(choice) = choice else { continue };
                let (over, scope) = (&field.over, Scope::Instance(index));
                let Ok(length) = self.resolver.value(&over.value, over.span, scope) else {
                    continue;
                };
                let length_value =
                    evaluate(&length.expr, &|id: ParameterId| self.values[id.0 as usize]);
                let [kinetic, potential, dissipation, force] = densities;
                fields.push(Field {
                    quantities: quantities(&instance.name.value, field),
                    scale: field.scale,
                    kinetic,
                    potential,
                    dissipation,
                    force,
                    initial: [profile(0), profile(1)],
                    length: length.expr,
                    length_value,
                    attachments: self.attachments(index, number),
                    fixed: ends(instance, field).map(|end| end == Boundary::Fixed),
                    elements: choice.elements,
                    order: choice.order,
                });
            }
        }
        if !fields.is_empty() {
            self.without_reduction();
        }
        fields
    }

    /// Rejects approximations and fixed parameters, which need whole machines.
    fn without_reduction(&mut self) {
        let tunable = self.spec.tunable.iter().flatten().next();
        if let Some(name) = tunable.or(self.spec.rigid.first()) {
            let message = "a scene with fields does not support [tunable] and [freeze]";
            let help = "remove [tunable] and [freeze]";
            self.mistakes.push(
                Mistake::new(Code::InvalidField, name.span, message, "not with fields").help(help),
            );
        }
    }

    fn attachments(&mut self, instance: usize, field: usize) -> Vec<Attachment> {
        let mut attachments = Vec::new();
        let all = self.layout.attachments.iter().enumerate();
        for (index, at) in all.filter(|(_, at)| (at.instance, at.field) == (instance, field)) {
            let spec = &self.spec.instances[instance];
            let port = &self.spec.units[spec.unit].ports[at.port];
            let names = &self.layout.units[spec.unit];
            let Some(Local::Coordinate(place)) = names.get(&port.coordinate.value) else {
                continue;
            };
            let link = self.layout.link(instance, place);
            if link.factor.is_some() && !at.fixed {
                let message = "two points of fields are joined with a ratio";
                let help = "join them one to one, or put a gear with inertia between them";
                let mistake = Mistake::new(
                    Code::InvalidField,
                    port.name.span,
                    message,
                    "joined with a ratio",
                );
                self.mistakes.push(mistake.help(help));
            }
            attachments.push(Attachment {
                name: crate::scene::names::name(Some(&spec.name.value), &port.name.value),
                coordinate: (!at.fixed).then_some(link.id),
                at: at.expr.clone(),
                place: at.place,
                x: at.x,
                handed: Layout::handed(index, 0),
            });
        }
        attachments
    }

    /// Returns T, V, D and Q per length.
    fn densities(&mut self, instance: usize, number: usize, field: &FieldSpec) -> [Expr; 4] {
        let scope = Scope::Density(instance, number);
        let per_metre = |of: Dimension| of.over(Dimension::LENGTH).unwrap_or(of);
        let force = Dimension::ENERGY.over(field.unit.unit.dimension).unwrap_or(Dimension::ENERGY);
        let timeless = Uses { position: true, velocity: true, ..Uses::PARAMETERS };
        let wanted = [
            Wanted::new(per_metre(Dimension::ENERGY), "the kinetic energy per length").of(timeless),
            Wanted::new(per_metre(Dimension::ENERGY), "the potential energy per length"),
            Wanted::new(per_metre(Dimension::POWER), "the dissipation per length"),
            Wanted::new(per_metre(force), "the force per length"),
        ];
        let [kinetic, potential, dissipation] = &field.densities;
        let texts = [kinetic, potential, dissipation, &field.force];
        let mut densities = [const { None }; 4];
        for ((text, wanted), density) in texts.into_iter().zip(&wanted).zip(&mut densities) {
            let Some(ast) = text else { continue };
            let resolved = self.resolver.expect(ast, scope, wanted);
            *density = Some(self.note(resolved));
        }
        self.inertia_of_field(field, densities[0].as_ref());
        if let (Some(ast), Some(expr)) = (potential, &densities[1]) {
            let moving = |symbol| symbol == RATE || symbol == SLOPE_RATE;
            self.refuse(ast, expr, moving, "a potential energy must not depend on rates");
        }
        densities.map(|density| density.unwrap_or_else(|| integer(0)))
    }

    /// Checks that T per length is m(x) u_t^2/2 with m above 0.
    fn inertia_of_field(&mut self, field: &FieldSpec, density: Option<&Expr>) {
        let (Some(ast), Some(density)) = (&field.densities[0], density) else {
            let message = format!("field {} has no inertia", quoted(&field.name.value));
            let help = "give it a kinetic energy per length";
            let mistake =
                Mistake::new(Code::NoInertia, field.name.span, message, "lacks `kinetic`");
            self.mistakes.push(mistake.help(help));
            return;
        };
        let elsewhere = |symbol| [VALUE, SLOPE, SLOPE_RATE].contains(&symbol);
        let message = "the kinetic energy per length may depend on the rate, x and parameters only";
        self.refuse(ast, density, elsewhere, message);
        if !density.mentions(|symbol| symbol == RATE) {
            let message = "the kinetic energy per length does not depend on the rate";
            self.mistakes.push(Mistake::new(
                Code::InvalidField,
                ast.span,
                message,
                "without inertia",
            ));
        }
        let tables = |expr: &Expr| {
            let mut found = false;
            Expr::visit_all([expr], &mut |part| {
                found |= matches!(part, Expr::Call(Function::Table { .. }, _));
            });
            found
        };
        if tables(density) || !self.mistakes.is_empty() {
            return;
        }
        let number = |value: i64| Expr::Number(BigRational::new(value.into(), 2.into()));
        let at_rate = |rate: i64| {
            let with = |symbol| match symbol {
                RATE => Some(number(rate)),
                PLACE => Some(number(1)),
                _ => None,
            };
            let parameter = |id: ParameterId| self.values[id.0 as usize];
            evaluate(&density.replace(&with), &parameter)
        };
        let [one, three] = [at_rate(2), at_rate(6)];
        if (three - 9.0 * one).abs() > 1e-9 * three.abs() {
            let message = "the kinetic energy per length must be quadratic in the rate";
            let help = "write inertia*rate^2/2, where inertia depends on x and parameters only";
            let mistake =
                Mistake::new(Code::InvalidField, ast.span, message, "not a quadratic form");
            self.mistakes.push(mistake.help(help));
        }
    }

    fn refuse(&mut self, ast: &Ast, expr: &Expr, wrong: impl Fn(Symbol) -> bool, message: &str) {
        if expr.mentions(wrong) {
            self.mistakes.push(Mistake::new(
                Code::InvalidField,
                ast.span,
                message,
                "not of this form",
            ));
        }
    }

    /// Returns the numbers that fields pass, in the order of attachments.
    pub(super) fn handed(&self) -> Vec<Parameter> {
        let mut handed = Vec::new();
        for at in &self.layout.attachments {
            let instance = &self.spec.instances[at.instance];
            let unit = &self.spec.units[instance.unit];
            let (field, port) = (&unit.fields[at.field], &unit.ports[at.port].name.value);
            let (of, slope) = (field.unit.text.trim(), &field.gradient.value);
            let entries: [(String, String, &str, f64); HANDED] = [
                (
                    format!("{port}_field_inertia"),
                    format!("J s^2/({of})^2"),
                    "inertia of the field's node",
                    1.0,
                ),
                (
                    format!("{port}_field_force"),
                    format!("J/({of})"),
                    "force of the field on its node",
                    0.0,
                ),
                (
                    format!("{port}_{slope}_before"),
                    format!("{of}/m"),
                    "slope of the field before the port",
                    0.0,
                ),
                (
                    format!("{port}_{slope}_after"),
                    format!("{of}/m"),
                    "slope of the field after the port",
                    0.0,
                ),
            ];
            handed.extend(entries.map(|(name, unit, doc, value)| Parameter {
                quantity: quantity(
                    Some(&instance.name.value),
                    &name,
                    &unit,
                    &format!("{doc}; the field sets it"),
                ),
                value,
                tunable: true,
            }));
        }
        handed
    }
}

/// Adds inertia and force to every place on a field.
pub fn take_hold(fields: &[Field], kinetic: &mut Expr, forces: &mut [GeneralizedForce]) {
    let half = Expr::Number(BigRational::new(1.into(), 2.into()));
    for at in fields.iter().flat_map(|field| &field.attachments) {
        let Some(id) = at.coordinate else { continue };
        let handed = |which| Expr::Symbol(Symbol::Handed(HandedId(at.handed.0 + which)));
        let rate = Expr::Symbol(Symbol::Velocity(id));
        let square = crate::scene::typed::power(rate, &BigRational::from_integer(2.into()));
        let energy = product(vec![half.clone(), handed(0), square]);
        *kinetic = sum(vec![kinetic.clone(), energy]);
        if let Some(force) = forces.get_mut(id.0 as usize) {
            force.total = sum(vec![force.total.clone(), handed(1)]);
        }
    }
}

/// Returns the quantities u, u_x, u_t, u_xt and x.
fn quantities(instance: &str, field: &FieldSpec) -> [machinist_model::Quantity; 5] {
    let (unit, doc) = (field.unit.text.trim(), field.doc.as_str());
    let rate_unit = per_second(&field.unit);
    let rate_of = |doc: &str| if doc.is_empty() { String::new() } else { format!("rate of {doc}") };
    let slope = if doc.is_empty() { String::new() } else { format!("slope of {doc}") };
    [
        quantity(Some(instance), &field.name.value, unit, doc),
        quantity(Some(instance), &field.gradient.value, &format!("{unit}/m"), &slope),
        quantity(Some(instance), &field.rate.value, &rate_unit, &rate_of(doc)),
        quantity(
            Some(instance),
            &field.gradient_rate.value,
            &format!("{rate_unit}/m"),
            &rate_of(&slope),
        ),
        quantity(Some(instance), "x", "m", "place along the field"),
    ]
}
