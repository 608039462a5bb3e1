//! Translation of expressions of the spec to expressions of the scene: names become symbols,
//! helpers are substituted, dimensions are checked term by term.

use std::collections::{BTreeSet, HashMap};

use machinist_algebra::expr::extent::derivatives;
use machinist_algebra::expr::identity::{Identity, identity};
use machinist_algebra::expr::{ConstraintId, Expr};
use num_rational::BigRational;
use num_traits::{One as _, Pow, Signed as _, ToPrimitive as _, Zero as _};

use crate::scene::bodies;
use crate::scene::layout::{Layout, Scope};
use crate::scene::lookup::{Definition, State};
use crate::scene::reactions::{in_proportion, signed};
use crate::scene::spline::Course;
use crate::scene::typed::{self, Typed, Uses, integer, product, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::{Angular, Dimension, Unit};
use crate::spec::expression::{Ast, MAX_NESTING, Node};
use crate::spec::{Formula, SceneSpec};
use machinist_model::Table;

/// Maximum number of leaves of an expression with helpers expanded.
pub(super) const MAX_TERMS: usize = 100_000;
/// Maximum number of leaves of all expressions of a scene.
const MAX_SCENE_TERMS: usize = 1_000_000;
/// Maximum depth of a tree: each nesting of the text makes at most a sum, a product and the
/// nested part.
const MAX_LEVELS: usize = 3 * MAX_NESTING + 2;
/// Maximum number of constraint forces that act by their sizes. Which sign each has takes as many
/// solutions as there are subsets of them.
const MAX_SIGNED: usize = 4;
/// Maximum number of bits of exact numbers.
const MAX_BITS: u64 = 1 << 18;
/// Maximum number of bits of powers, some twenty thousand digits. Symbolica receives and returns
/// as text the sums of as many such numbers as the power has, in time that grows as the square of
/// their digits.
const MAX_BITS_OF_POWERS: u64 = 70_000;
/// Maximum number of leaves of a second derivative, written out. Equations of motion contain
/// second derivatives of energies, and their Jacobians those of forces.
const MAX_DERIVATIVE: f64 = 200_000.0;

pub(super) type Resolved = Result<Typed, Box<Mistake>>;

/// Requirements on an expression.
#[derive(Debug, Clone)]
pub struct Wanted {
    pub dimension: Dimension,
    /// `the potential energy`.
    pub what: String,
    pub allowed: Uses,
    /// True for an energy: terms that are torques according to their angles are rejected.
    pub energy: bool,
}

impl Wanted {
    /// Requires a dimension, and allows everything except accelerations.
    pub fn new(dimension: Dimension, what: impl Into<String>) -> Self {
        Wanted { dimension, what: what.into(), allowed: Uses::MOTION, energy: false }
    }

    /// Sets what is allowed.
    pub fn of(self, allowed: Uses) -> Self {
        Wanted { allowed, ..self }
    }
}

/// Resolves expressions, each definition once.
pub struct Resolver<'a> {
    pub(super) spec: &'a SceneSpec,
    pub(super) layout: &'a Layout,
    /// Values of the parameters in the spec, if they are known yet.
    pub(super) values: &'a [f64],
    pub(super) definitions: HashMap<Definition, State>,
    /// True for units whose helpers are long; `None` stands for the scene.
    pub(super) long_helpers: HashMap<Option<usize>, bool>,
    /// Trees of joints of instances with frames.
    pub(super) trees: HashMap<usize, bodies::Tree>,
    /// Joint that sees the frames of the expression at hand; `None` for the world.
    pub(super) carrier: Option<usize>,
    /// Tables in use, with their CSV file, column and kind of curve.
    pub(super) tables: Vec<Table>,
    pub(super) table_columns: Vec<(usize, usize, Course)>,
    /// Times of discontinuities, each once.
    pub(super) discontinuities: Vec<Expr>,
    /// Warnings, each once.
    pub(super) warnings: Vec<Mistake>,
    pub(super) level: usize,
    pub(super) spent: usize,
    spent_in_all: usize,
    /// Constraints whose forces act by their sizes.
    pub(super) signed: BTreeSet<ConstraintId>,
}

impl<'a> Resolver<'a> {
    /// Returns a resolver without results.
    pub fn new(spec: &'a SceneSpec, layout: &'a Layout) -> Self {
        Resolver {
            spec,
            layout,
            values: &[],
            definitions: HashMap::new(),
            long_helpers: HashMap::new(),
            trees: HashMap::new(),
            carrier: None,
            tables: Vec::new(),
            table_columns: Vec::new(),
            discontinuities: Vec::new(),
            warnings: Vec::new(),
            level: 0,
            spent: 0,
            spent_in_all: 0,
            signed: BTreeSet::new(),
        }
    }

    /// Resolves an expression according to its requirements.
    ///
    /// # Errors
    /// At the term that has another dimension, depends on something not allowed, or uses an
    /// unknown name.
    pub fn expect(&mut self, ast: &Ast, scope: Scope, wanted: &Wanted) -> Resolved {
        (self.level, self.spent) = (0, 0);
        self.nested(ast, scope, wanted).and_then(|typed| derivable(typed, ast.span))
    }

    /// Resolves a force, which may contain constraint forces in proportion.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn expect_force(&mut self, ast: &Ast, scope: Scope, wanted: Wanted) -> Resolved {
        let typed = self.expect(ast, scope, &wanted.of(Uses::GUARD))?;
        if !typed.uses.reaction {
            return Ok(typed);
        }
        let expr = in_proportion(typed.expr, ast.span)?;
        self.signed.extend(signed(&expr));
        if self.signed.len() > MAX_SIGNED {
            let message = format!(
                "the forces of {} constraints act by their sizes, more than {MAX_SIGNED}",
                self.signed.len()
            );
            let help = "their signs are found by solving for each combination; where a constraint \
                        force keeps its sign, leave out `abs`";
            return Err(Box::new(
                Mistake::new(Code::InvalidForce, ast.span, message, "one more").help(help),
            ));
        }
        self.require_no_fields("a force", ast.span)?;
        Ok(Typed { expr, ..typed })
    }

    /// Resolves the rate of a first-order state, which may contain constraint forces.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn expect_rate(&mut self, ast: &Ast, scope: Scope, wanted: Wanted) -> Resolved {
        let typed = self.expect(ast, scope, &wanted.of(Uses::GUARD))?;
        if typed.uses.reaction {
            self.require_no_fields("a rate", ast.span)?;
        }
        // As forces read them: one sign, one relation.
        let expr = in_proportion(typed.expr.clone(), ast.span).unwrap_or(typed.expr);
        Ok(Typed { expr, ..typed })
    }

    /// Rejects what reads constraint forces in a scene with fields.
    fn require_no_fields(&self, what: &str, span: Span) -> Result<(), Box<Mistake>> {
        let units = self.spec.instances.iter().map(|instance| &self.spec.units[instance.unit]);
        if units.flat_map(|unit| &unit.fields).next().is_none() {
            return Ok(());
        }
        let message =
            format!("{what} depends on the force of a constraint, and the scene has fields");
        let help = "constraint forces are solved for without what fields add to the machine; use \
                    lumped masses and springs instead";
        Err(Box::new(Mistake::new(Code::InvalidForce, span, message, "not with fields").help(help)))
    }

    /// Resolves a name.
    ///
    /// # Errors
    /// If its definition is wrong.
    pub fn value(&mut self, name: &str, span: Span, scope: Scope) -> Resolved {
        (self.level, self.spent) = (0, 0);
        self.local(name, span, scope)
    }

    /// Resolves an output, which may have any dimension and depend on accelerations.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn expect_any(&mut self, ast: &Ast, scope: Scope) -> Resolved {
        (self.level, self.spent) = (0, 0);
        self.resolve(ast, scope, Uses::ANYTHING)
    }

    /// Resolves a guard, which may be of any dimension.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn expect_motion(&mut self, ast: &Ast, scope: Scope) -> Resolved {
        (self.level, self.spent) = (0, 0);
        self.resolve(ast, scope, Uses::MOTION).and_then(|typed| derivable(typed, ast.span))
    }

    /// Resolves an expression of any dimension that may contain constraint forces.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn expect_guard(&mut self, ast: &Ast, scope: Scope) -> Resolved {
        (self.level, self.spent) = (0, 0);
        self.resolve(ast, scope, Uses::GUARD).and_then(|typed| derivable(typed, ast.span))
    }

    /// Resolves a formula. A bare number is in the required unit.
    ///
    /// # Errors
    /// As [`Resolver::expect`].
    pub fn formula(&mut self, formula: &Formula, scope: Scope, wanted: &Wanted) -> Resolved {
        match formula {
            Formula::Expression(ast) => self.expect(ast, scope, wanted),
            Formula::Number(number) => {
                let unit = Unit { dimension: wanted.dimension, rad: 0 };
                Ok(Typed::number(&number.value.0, Some(unit)))
            }
        }
    }

    /// Resolves part of an expression.
    pub(super) fn resolve(&mut self, ast: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        self.descend(ast.span, 0)?;
        self.level += 1;
        let resolved = match &ast.node {
            Node::Number(number, unit) => {
                self.spend(1, ast.span).map(|()| Typed::number(&number.0, *unit))
            }
            Node::Name(instance, name) => {
                self.name(instance.as_deref(), name, ast.span, scope, allowed)
            }
            Node::Negative(of) => self.resolve(of, scope, allowed).map(negative),
            Node::Sum(terms) => self.sum(terms, scope, allowed, None),
            Node::Product(factors) => self.product(factors, ast.span, scope, allowed),
            Node::Power(base, exponent) => self.power(base, exponent, ast.span, scope, allowed),
            Node::Call(function, span, arguments) => {
                self.call(function, *span, arguments, ast.span, scope, allowed)
            }
            Node::Less(..) => Err(Box::new(
                Mistake::new(
                    Code::Syntax,
                    ast.span,
                    "a comparison is allowed only in piecewise",
                    "not here",
                )
                .help("write piecewise(t < t1, a, b)"),
            )),
            Node::Text(_) => Err(Box::new(
                Mistake::new(Code::Syntax, ast.span, "a quoted text is not a value", "not here")
                    .help("only `table` and `motion_law` take texts"),
            )),
        };
        self.level -= 1;
        resolved.and_then(|typed| sound(typed, ast.span))
    }

    pub(super) fn sum(
        &mut self,
        terms: &[(bool, Ast)],
        scope: Scope,
        allowed: Uses,
        wanted: Option<&Wanted>,
    ) -> Resolved {
        let mut parts: Vec<Typed> = Vec::with_capacity(terms.len());
        for (negated, term) in terms {
            let part = self.resolve(term, scope, allowed)?;
            match wanted {
                Some(wanted) => fits(term.span, &part, wanted)?,
                None => same(term.span, &part, &parts)?,
            }
            parts.push(if *negated { negative(part) } else { part });
        }
        let mut typed = Typed::over(&parts.iter().collect::<Vec<_>>());
        typed.dimension = parts.iter().find_map(|part| part.dimension);
        let angular = parts.iter().map(|part| part.angular).reduce(Angular::plus);
        typed.angular = angular.unwrap_or_default();
        typed.value = parts.iter().map(|part| part.value).sum();
        typed.expr = sum(parts.into_iter().map(|part| part.expr).collect());
        Ok(typed)
    }

    fn product(
        &mut self,
        factors: &[(bool, Ast)],
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let mut parts = Vec::with_capacity(factors.len());
        for (divides, factor) in factors {
            let part = self.resolve(factor, scope, allowed)?;
            if *divides {
                not_zero(&part, factor.span, "division by zero")?;
            }
            parts.push(if *divides { reciprocal(part) } else { part });
        }
        let mut typed = Typed::over(&parts.iter().collect::<Vec<_>>());
        for part in &parts {
            typed.angular = typed.angular.times(part.angular);
            let product = typed.dimension.zip(part.dimension).map(|(a, b)| a.times(b));
            // Zero times anything is zero, of any dimension.
            typed.dimension = product.map(|d| d.ok_or_else(|| beyond_reason(span))).transpose()?;
        }
        typed.value = parts.iter().map(|part| part.value).product();
        guard_bits(typed.bits, MAX_BITS, span)?;
        typed.expr = product(parts.into_iter().map(|part| part.expr).collect());
        Ok(typed)
    }

    fn power(
        &mut self,
        base: &Ast,
        exponent: &Ast,
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let number = constant(exponent).ok_or_else(|| {
            Mistake::new(
                Code::NotConstant,
                exponent.span,
                "an exponent must be a number",
                "not a number",
            )
            .help("write exp(b*ln(a)) for a^b")
        })?;
        let Some((numerator, denominator)) = typed::exponent(&number) else {
            let mistake = Mistake::new(
                Code::OutOfRange,
                exponent.span,
                "an exponent is at most 64 in magnitude",
                "too large",
            );
            return Err(Box::new(mistake));
        };
        let part = self.resolve(base, scope, allowed)?;
        if numerator < 0 {
            not_zero(&part, base.span, "division by zero")?;
        }
        let mut typed = Typed::over(&[&part]);
        typed.angular = part.angular.power(numerator, denominator);
        typed.dimension = match part.dimension {
            None | Some(Dimension::ONE) => Some(Dimension::ONE),
            Some(dimension) => Some(dimension.power(numerator, denominator).ok_or_else(|| {
                let label = format!("the base is in {dimension}");
                Mistake::new(
                    Code::NoDimension,
                    exponent.span,
                    "this power has no dimension in SI units",
                    label,
                )
                .help("exponents of a quantity with a dimension must be multiples of 1/840")
            })?),
        };
        typed.bits = part.bits.saturating_mul(u64::from(numerator.unsigned_abs().max(1)));
        typed.value = match (part.value, number.to_f64()) {
            (Some(base), Some(exponent)) => Some(base.powf(exponent)),
            _ => None,
        };
        guard_bits(typed.bits, MAX_BITS_OF_POWERS, span)?;
        typed.terms += 1;
        self.spend(1, span)?;
        if number.is_zero() {
            // The power 0 of anything, also of zero, is 1.
            typed.value = Some(1.0);
            typed.expr = integer(1);
            return Ok(typed);
        }
        typed.expr = typed::power(part.expr, &number);
        Ok(typed)
    }

    pub(super) fn descend(&self, span: Span, levels: usize) -> Result<(), Box<Mistake>> {
        if self.level + levels <= MAX_LEVELS {
            return Ok(());
        }
        let message = format!("with helpers expanded, expressions nest deeper than {MAX_NESTING}");
        Err(Box::new(Mistake::new(Code::TooLarge, span, message, "too deep here")))
    }

    /// Counts leaves before they are created.
    pub(super) fn spend(&mut self, terms: usize, span: Span) -> Result<(), Box<Mistake>> {
        self.spent = self.spent.saturating_add(terms);
        self.spent_in_all = self.spent_in_all.saturating_add(terms);
        if self.spent <= MAX_TERMS && self.spent_in_all <= MAX_SCENE_TERMS {
            return Ok(());
        }
        let message = if self.spent > MAX_TERMS {
            format!("with helpers expanded, the expression has more than {MAX_TERMS} terms")
        } else {
            format!("with helpers expanded, the scene has more than {MAX_SCENE_TERMS} terms")
        };
        Err(Box::new(Mistake::new(Code::TooLarge, span, message, "grows beyond the limit here")))
    }
}

fn negative(part: Typed) -> Typed {
    let value = part.value.map(|value| -value);
    Typed { value, depth: part.depth + 1, expr: product(vec![integer(-1), part.expr]), ..part }
}

fn reciprocal(part: Typed) -> Typed {
    Typed {
        dimension: part.dimension.and_then(|dimension| dimension.power(-1, 1)),
        angular: part.angular.power(-1, 1),
        value: part.value.map(f64::recip),
        depth: part.depth + 1,
        expr: typed::reciprocal(part.expr),
        ..part
    }
}

/// Returns a number computed from numbers, for exponents.
fn constant(ast: &Ast) -> Option<BigRational> {
    let number = match &ast.node {
        Node::Number(number, None) => number.0.clone(),
        Node::Negative(of) => -constant(of)?,
        Node::Product(factors) => {
            let mut product = BigRational::one();
            for (divides, factor) in factors {
                let factor = constant(factor)?;
                product = match (divides, factor.is_zero()) {
                    (true, true) => return None,
                    (true, false) => product / factor,
                    (false, _) => product * factor,
                };
                short(&product)?;
            }
            product
        }
        Node::Power(base, exponent) => {
            let (base, exponent) = (constant(base)?, constant(exponent)?);
            let exponent = exponent.is_integer().then(|| exponent.to_i32()).flatten()?;
            let size = typed::bits(&base.abs()).saturating_mul(u64::from(exponent.unsigned_abs()));
            if size > 4096 || base.is_zero() && exponent <= 0 {
                return None;
            }
            Pow::pow(base, exponent)
        }
        _ => return None,
    };
    short(&number).map(|()| number)
}

/// Rejects long numbers as exponents.
fn short(number: &BigRational) -> Option<()> {
    (typed::bits(&number.abs()) <= 4096).then_some(())
}

/// Rejects a term of another dimension than required.
pub(super) fn fits(span: Span, part: &Typed, wanted: &Wanted) -> Result<(), Box<Mistake>> {
    let what = &wanted.what;
    if let Some(dimension) = part.dimension
        && dimension != wanted.dimension
    {
        let message = format!("{what} is in {}, but this term is in {dimension}", wanted.dimension);
        let mistake =
            Mistake::new(Code::DimensionMismatch, span, message, format!("in {dimension}"));
        let bare = part.value.is_some() && dimension == Dimension::ONE;
        let help = if bare { "write the unit of a number in brackets: 0.1 [s]" } else { "" };
        return Err(Box::new(mistake.help(help)));
    }
    if wanted.energy && part.angular.is_torque() {
        let message = format!("this term of {what} is a torque, not an energy");
        let mistake = Mistake::new(
            Code::NotAnEnergy,
            span,
            message,
            "a stiffness per rad times a single angle",
        );
        let help = "is a square missing? a spring stores stiffness*angle^2/2";
        return Err(Box::new(mistake.help(help)));
    }
    Ok(())
}

/// Rejects a term of another dimension than those before it.
fn same(span: Span, part: &Typed, before: &[Typed]) -> Result<(), Box<Mistake>> {
    let first = before.iter().find_map(|part| part.dimension);
    match first.zip(part.dimension) {
        Some((first, this)) if first != this => {
            let message = format!("the preceding terms are in {first}, but this term is in {this}");
            Err(Box::new(Mistake::new(
                Code::DimensionMismatch,
                span,
                message,
                format!("in {this}"),
            )))
        }
        _ => Ok(()),
    }
}

/// Rejects an expression that is zero for all values of its symbols, `p - p` as well as 0.
pub(super) fn not_zero(part: &Typed, span: Span, what: &str) -> Result<(), Box<Mistake>> {
    if part.value != Some(0.0) && identity(&part.expr) == Identity::NotZero {
        return Ok(());
    }
    let label = if part.value.is_some() { "this is 0" } else { "this is always 0" };
    Err(Box::new(Mistake::new(Code::UndefinedValue, span, what, label)))
}

/// Rejects an expression that would grow too much by differentiation.
fn derivable(typed: Typed, span: Span) -> Resolved {
    let leaves = derivatives(&typed.expr).second;
    if leaves <= MAX_DERIVATIVE {
        return Ok(typed);
    }
    let message =
        format!("a second derivative of this would expand to more than {MAX_DERIVATIVE} terms");
    let mistake = Mistake::new(Code::TooLarge, span, message, "nests or multiplies too much");
    Err(Box::new(mistake.help("replace a part of it by a state, a coordinate or a table")))
}

/// Rejects numbers beyond the range of `f64`.
pub(super) fn sound(typed: Typed, span: Span) -> Resolved {
    if typed.value.is_some_and(|value| !value.is_finite()) {
        return Err(Box::new(Mistake::new(
            Code::UndefinedValue,
            span,
            "this is not a finite number",
            "not finite",
        )));
    }
    Ok(typed)
}

fn guard_bits(bits: u64, most: u64, span: Span) -> Result<(), Box<Mistake>> {
    if bits <= most {
        return Ok(());
    }
    let message = "nested powers exceed the range of exact numbers";
    Err(Box::new(Mistake::new(Code::TooLarge, span, message, "grows beyond the limit here")))
}

pub(super) fn beyond_reason(span: Span) -> Mistake {
    Mistake::new(Code::NoDimension, span, "exponents of units are too large", "here")
}
