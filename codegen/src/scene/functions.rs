//! Function calls: arguments are checked, and switches are written with `select_less`.

use crate::scene::along::{self, NoRate};
use crate::scene::layout::Scope;
use crate::scene::motion_laws::MOST_ENDS;
use crate::scene::resolve::{MAX_TERMS, Resolved, Resolver, not_zero};
use crate::scene::spline::Course;
use crate::scene::tables::course_of;
use crate::scene::typed::{Typed, Uses, integer, power, product, reciprocal, select_less, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::{Angular, Dimension};
use crate::spec::expression::Ast;
use crate::spec::{did_you_mean, quoted};
use machinist_algebra::expr::{Expr, Function, Symbol};
use machinist_model::evaluate::call;

/// Functions of one dimensionless number.
const PURE: &[(&str, Function)] = &[
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("asin", Function::Asin),
    ("acos", Function::Acos),
    ("atan", Function::Atan),
    ("sinh", Function::Sinh),
    ("cosh", Function::Cosh),
    ("tanh", Function::Tanh),
    ("exp", Function::Exp),
    ("ln", Function::Ln),
];
/// All other functions, with their arguments.
const OTHERS: &[(&str, &str)] = &[
    ("sqrt", "sqrt(x)"),
    ("cbrt", "cbrt(x)"),
    ("atan2", "atan2(y, x)"),
    ("abs", "abs(x)"),
    ("min", "min(a, b)"),
    ("max", "max(a, b)"),
    ("mod", "mod(x, y)"),
    ("sign", "sign(x)"),
    ("smooth_step", "smooth_step(x)"),
    ("step", "step(t, t0)"),
    ("piecewise", "piecewise(t < t1, a, x < x2, b, c)"),
    ("motion_law", "motion_law(\"modified sine\", x), or with speeds at both ends behind x"),
    (
        "table",
        "table(\"file.csv\", \"column\", x), or with \"linear\", \"monotone\" or \"natural\" behind x",
    ),
    ("der", "der(x)"),
    ("dot", "dot(u, v)"),
    ("norm", "norm(u)"),
    ("x_of", "x_of(u)"),
    ("y_of", "y_of(u)"),
    ("z_of", "z_of(u)"),
];

/// Functions of one dimensionless number that return a whole one. Their names are not reserved,
/// since machines have floors; a parenthesis tells calls from names.
const WHOLE: &[&str] = &["floor", "ceil", "round"];

impl Resolver<'_> {
    /// Resolves a call.
    pub(super) fn call(
        &mut self,
        function: &str,
        name: Span,
        arguments: &[Ast],
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        if let Some(of_vectors) = self.of_vectors(function, arguments, span, scope, allowed) {
            return of_vectors;
        }
        let pure = PURE.iter().find(|(known, _)| *known == function);
        match (function, arguments) {
            (_, [x]) if let Some((_, pure)) = pure => self.pure(*pure, x, scope, allowed),
            ("sqrt", [x]) => self.root(x, scope, allowed),
            ("cbrt", [x]) => self.cube_root(x, span, scope, allowed),
            ("atan2", [y, x]) => self.angle(y, x, scope, allowed),
            ("abs", [x]) => {
                let x = self.resolve(x, scope, allowed)?;
                let mut typed = like(&x, &[&x]);
                typed.value = x.value.map(f64::abs);
                typed.expr = Expr::Call(Function::Abs, vec![x.expr]);
                Ok(typed)
            }
            ("min" | "max", [a, b]) => self.extremum(function == "min", a, b, scope, allowed),
            ("mod", [x, y]) => self.remainder(x, y, span, scope, allowed),
            ("floor" | "ceil" | "round", [x]) => self.whole(function, x, span, scope, allowed),
            ("sign", [x]) => self.sign(x, span, scope, allowed),
            ("smooth_step", [x]) => self.smooth_step(x, span, scope, allowed),
            ("step", [t, at]) => self.step(t, at, span, scope, allowed),
            ("piecewise", [.., _]) if arguments.len() >= 3 && arguments.len() % 2 == 1 => {
                self.piecewise(arguments, span, scope, allowed)
            }
            ("table", [file, column, x]) => {
                let typed = self.table((file, column, Course::Natural), x, scope, allowed)?;
                self.warn_of_overshoot(file, column);
                Ok(typed)
            }
            ("table", [file, column, x, course]) => {
                let course = course_of(course)?;
                self.table((file, column, course), x, scope, allowed)
            }
            ("motion_law", [law, x, ends @ ..]) if ends.len() <= MOST_ENDS => {
                self.motion_law(law, x, ends, scope, allowed)
            }
            ("der", [x]) => self.rate(x, span, scope, allowed),
            _ => Err(Box::new(unknown(function, name, span, arguments.len()))),
        }
    }

    fn pure(&mut self, function: Function, of: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        let x = self.number(of, scope, allowed)?;
        if function == Function::Ln {
            not_zero(&x, of.span, "the logarithm of zero")?;
        }
        let mut typed = Typed::over(&[&x]);
        typed.angular = Angular::of_function(x.uses.moves());
        typed.value = x.value.zip(function.unary()).map(|(value, function)| call(function, value));
        typed.expr = Expr::Call(function, vec![x.expr]);
        Ok(typed)
    }

    /// Resolves a dimensionless argument.
    pub(super) fn number(&mut self, x: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        let typed = self.resolve(x, scope, allowed)?;
        match typed.dimension {
            None | Some(Dimension::ONE) => Ok(typed),
            Some(dimension) => {
                let message = "the argument of this function must be dimensionless";
                let label = format!("in {dimension}");
                Err(Box::new(
                    Mistake::new(Code::DimensionMismatch, x.span, message, label)
                        .help("divide it by a quantity of its unit"),
                ))
            }
        }
    }

    /// Resolves a whole number near a dimensionless one.
    ///
    /// ```text
    /// floor(x)      ceil(x) = -floor(-x)      round(x) = floor(x + 1/2)
    /// ```
    fn whole(
        &mut self,
        function: &str,
        of: &Ast,
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let x = self.number(of, scope, allowed)?;
        self.spend(2, span)?;
        let mut typed = Typed::over(&[&x]);
        typed.terms += 2;
        typed.depth += 3;
        typed.angular = Angular::of_function(x.uses.moves());
        let floor = |x: Expr| Expr::Call(Function::Floor, vec![x]);
        let negative = |x: Expr| product(vec![integer(-1), x]);
        (typed.value, typed.expr) = match function {
            "floor" => (x.value.map(f64::floor), floor(x.expr)),
            "ceil" => (x.value.map(f64::ceil), negative(floor(negative(x.expr)))),
            _ => {
                let half = Expr::Number(num_rational::BigRational::new(1.into(), 2.into()));
                (x.value.map(|x| (x + 0.5).floor()), floor(sum(vec![x.expr, half])))
            }
        };
        Ok(typed)
    }

    /// Resolves x - y floor(x/y).
    fn remainder(
        &mut self,
        of: &Ast,
        by: &Ast,
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let x = self.resolve(of, scope, allowed)?;
        let y = self.resolve(by, scope, allowed)?;
        not_zero(&y, by.span, "a remainder by zero")?;
        if let (Some(dimension), Some(other)) = (x.dimension, y.dimension)
            && dimension != other
        {
            let message =
                format!("the arguments of `mod` differ in dimension: this is in {dimension}");
            return Err(Box::new(Mistake::new(
                Code::DimensionMismatch,
                by.span,
                message,
                format!("in {other}"),
            )));
        }
        self.spend(x.terms.saturating_add(y.terms), span)?;
        let mut typed = Typed::over(&[&x, &x, &y, &y]);
        typed.depth += 4;
        typed.dimension = x.dimension.or(y.dimension);
        typed.angular = x.angular;
        typed.value = x.value.zip(y.value).map(|(x, y)| x - y * (x / y).floor());
        let ratio = product(vec![x.expr.clone(), reciprocal(y.expr.clone())]);
        let whole = Expr::Call(Function::Floor, vec![ratio]);
        typed.expr = sum(vec![x.expr, product(vec![integer(-1), y.expr, whole])]);
        Ok(typed)
    }

    fn root(&mut self, of: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        let x = self.resolve(of, scope, allowed)?;
        let mut typed = Typed::over(&[&x]);
        typed.dimension = match x.dimension {
            None => None,
            Some(dimension) => Some(dimension.power(1, 2).ok_or_else(|| {
                let label = format!("in {dimension}");
                Mistake::new(
                    Code::NoDimension,
                    of.span,
                    "this root has no dimension in SI units",
                    label,
                )
            })?),
        };
        typed.angular = x.angular.power(1, 2);
        typed.value = x.value.map(f64::sqrt);
        typed.expr = Expr::Call(Function::Sqrt, vec![x.expr]);
        Ok(typed)
    }

    /// Resolves a cube root, also of negative numbers: -(-x)^(1/3) below zero.
    fn cube_root(&mut self, of: &Ast, span: Span, scope: Scope, allowed: Uses) -> Resolved {
        let x = self.resolve(of, scope, allowed)?;
        self.spend(x.terms.saturating_mul(2), span)?;
        let mut typed = Typed::over(&[&x, &x, &x]);
        typed.depth += 4;
        typed.dimension = match x.dimension {
            None => None,
            Some(dimension) => Some(dimension.power(1, 3).ok_or_else(|| {
                let label = format!("in {dimension}");
                Mistake::new(
                    Code::NoDimension,
                    of.span,
                    "this root has no dimension in SI units",
                    label,
                )
            })?),
        };
        typed.angular = x.angular.power(1, 3);
        typed.value = x.value.map(f64::cbrt);
        let third = num_rational::BigRational::new(1.into(), 3.into());
        let above = power(x.expr.clone(), &third);
        let below = power(product(vec![integer(-1), x.expr.clone()]), &third);
        let below = product(vec![integer(-1), below]);
        typed.expr = select_less(x.expr, integer(0), below, above);
        Ok(typed)
    }

    /// Resolves the angle of (x, y), from -pi to pi. With r its distance from the origin, it is
    ///
    /// ```text
    /// 2 atan(y/(r + x))               where x >= 0
    /// +-pi - 2 atan(y/(r - x))        where x < 0, by the sign of y
    /// ```
    ///
    /// so that nothing cancels, and only the origin is singular.
    fn angle(&mut self, y: &Ast, x: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        let span = y.span.to(x.span);
        let (y, x) = (self.resolve(y, scope, allowed)?, self.resolve(x, scope, allowed)?);
        Self::agree(span, &y, &x)?;
        if y.value == Some(0.0) && x.value == Some(0.0) {
            return Err(Box::new(Mistake::new(
                Code::UndefinedValue,
                span,
                "`atan2(0, 0)` is undefined",
                "both are 0",
            )));
        }
        self.spend(x.terms.saturating_add(y.terms).saturating_mul(5).saturating_add(8), span)?;
        let mut typed = Typed::over(&[&x, &y, &x, &y, &x, &y, &x, &y, &x, &y]);
        typed.terms += 8;
        typed.depth += 10;
        typed.dimension = Some(Dimension::ONE);
        typed.angular = Angular::of_function(x.uses.moves() || y.uses.moves());
        typed.value = y.value.zip(x.value).map(|(y, x)| y.atan2(x));
        let (y, x) = (y.expr, x.expr);
        let square =
            |of: &Expr| power(of.clone(), &num_rational::BigRational::from_integer(2.into()));
        let distance = Expr::Call(Function::Sqrt, vec![sum(vec![square(&x), square(&y)])]);
        let twice = |over: Expr, sign: i64| {
            let tangent = product(vec![y.clone(), reciprocal(over)]);
            product(vec![integer(sign * 2), Expr::Call(Function::Atan, vec![tangent])])
        };
        let ahead = twice(sum(vec![distance.clone(), x.clone()]), 1);
        let minus_x = product(vec![integer(-1), x.clone()]);
        let pi = || Expr::Symbol(Symbol::Pi);
        let half_turn = select_less(y.clone(), integer(0), product(vec![integer(-1), pi()]), pi());
        let behind = sum(vec![half_turn, twice(sum(vec![distance, minus_x]), -1)]);
        typed.expr = select_less(x, integer(0), behind, ahead);
        Ok(typed)
    }

    /// Resolves min(a, b) = a where a < b, else b; max likewise.
    fn extremum(&mut self, min: bool, a: &Ast, b: &Ast, scope: Scope, allowed: Uses) -> Resolved {
        let (x, y) = (self.resolve(a, scope, allowed)?, self.resolve(b, scope, allowed)?);
        Self::agree(b.span, &x, &y)?;
        self.spend(x.terms.saturating_add(y.terms), a.span)?;
        let mut typed = like(&x, &[&x, &y, &x, &y]);
        typed.dimension = x.dimension.or(y.dimension);
        typed.angular = x.angular.plus(y.angular);
        let extremum = if min { f64::min } else { f64::max };
        typed.value = x.value.zip(y.value).map(|(x, y)| extremum(x, y));
        let (x, y) = (x.expr, y.expr);
        let (then, otherwise) = if min { (x.clone(), y.clone()) } else { (y.clone(), x.clone()) };
        typed.expr = select_less(x, y, then, otherwise);
        Ok(typed)
    }

    pub(super) fn agree(span: Span, a: &Typed, b: &Typed) -> Result<(), Box<Mistake>> {
        match a.dimension.zip(b.dimension) {
            Some((a, b)) if a != b => {
                let message = format!("the preceding values are in {a}, but this one is in {b}");
                Err(Box::new(Mistake::new(
                    Code::DimensionMismatch,
                    span,
                    message,
                    format!("in {b}"),
                )))
            }
            _ => Ok(()),
        }
    }

    fn sign(&mut self, x: &Ast, span: Span, scope: Scope, allowed: Uses) -> Resolved {
        let x = self.resolve(x, scope, allowed)?;
        self.spend(3, span)?;
        let mut typed = Typed::over(&[&x]);
        typed.terms += 3;
        typed.angular = Angular::of_function(x.uses.moves());
        typed.value = x.value.map(|x| if x < 0.0 { -1.0 } else { 1.0 });
        typed.expr = select_less(x.expr, integer(0), integer(-1), integer(1));
        Ok(typed)
    }

    /// Resolves 0 below 0, 1 above 1, between them x^3 (10 - 15 x + 6 x^2).
    fn smooth_step(&mut self, x: &Ast, span: Span, scope: Scope, allowed: Uses) -> Resolved {
        let x = self.number(x, scope, allowed)?;
        self.spend(x.terms.saturating_mul(4).saturating_add(9), span)?;
        let mut typed = Typed::over(&[&x, &x, &x, &x, &x]);
        typed.terms += 9;
        typed.depth += 5;
        typed.bits = x.bits.saturating_mul(5);
        typed.angular = Angular::of_function(x.uses.moves());
        typed.value = x.value.map(|x| {
            let x = x.clamp(0.0, 1.0);
            x * x * x * (10.0 - 15.0 * x + 6.0 * x * x)
        });
        let x = x.expr;
        let raised = |n: i64| power(x.clone(), &num_rational::BigRational::from_integer(n.into()));
        let blend = sum(vec![
            integer(10),
            product(vec![integer(-15), x.clone()]),
            product(vec![integer(6), raised(2)]),
        ]);
        let inside = product(vec![raised(3), blend]);
        let above = select_less(x.clone(), integer(1), inside, integer(1));
        typed.expr = select_less(x, integer(0), integer(0), above);
        Ok(typed)
    }

    fn step(&mut self, t: &Ast, at: &Ast, span: Span, scope: Scope, allowed: Uses) -> Resolved {
        let place = at.span;
        let (time, at) = self.condition(t, at, scope, allowed)?;
        if time.expr != Expr::Symbol(Symbol::Time) || at.uses != Uses::default() {
            let message = "a step must be in `t`, at a time that depends on parameters only";
            let mistake =
                Mistake::new(Code::WrongArguments, t.span.to(place), message, "not a step in time");
            return Err(Box::new(mistake.help("otherwise write piecewise(x < x1, 0, 1)")));
        }
        self.spend(2, span)?;
        let mut typed = Typed::over(&[&time, &at]);
        typed.terms += 2;
        typed.angular = Angular::of_function(false);
        typed.expr = select_less(time.expr, at.expr, integer(0), integer(1));
        Ok(typed)
    }

    /// Resolves dx/dt along the motion.
    fn rate(&mut self, of: &Ast, span: Span, scope: Scope, allowed: Uses) -> Resolved {
        if !allowed.velocity {
            let message = "a rate is a velocity, which is not allowed here";
            return Err(Box::new(Mistake::new(
                Code::ForbiddenDependence,
                span,
                message,
                "not allowed here",
            )));
        }
        // The rate must use only what is allowed here.
        let velocity = allowed.acceleration;
        let within = Uses { velocity, acceleration: false, reaction: false, ..allowed };
        let x = self.resolve(of, scope, within)?;
        let orientations = self.orientations();
        let of_symbol = |symbol| match symbol {
            Symbol::Coordinate(id) => Some(orientations.rate(id)),
            Symbol::Velocity(id) => Some(Expr::Symbol(Symbol::Acceleration(id))),
            mode if self.is_mode(&Expr::Symbol(mode)) => Some(integer(0)),
            _ => None,
        };
        let (expr, terms) = along::rate(&x.expr, MAX_TERMS, &of_symbol).map_err(|why| {
            let message = match why {
                NoRate::TooLarge => format!("this rate has more than {MAX_TERMS} terms"),
                NoRate::Unknown(_) => "this depends on a state or a field, whose rate is not \
                                       available here"
                    .to_owned(),
            };
            Mistake::new(Code::NoDerivative, of.span, message, "its rate")
                .help("only expressions of coordinates and time have a rate here")
        })?;
        self.spend(terms, span)?;
        let mut typed = Typed::over(&[&x]);
        typed.dimension = match x.dimension {
            None => None,
            Some(dimension) => Some(dimension.over(Dimension::TIME).ok_or_else(|| {
                Mistake::new(
                    Code::NoDimension,
                    span,
                    "this rate has no dimension in SI units",
                    "beyond reason",
                )
            })?),
        };
        typed.angular = x.angular;
        typed.uses = Uses {
            velocity: x.uses.position || x.uses.velocity,
            acceleration: x.uses.velocity,
            ..x.uses
        };
        typed.terms = terms;
        typed.depth = x.depth.saturating_mul(2).saturating_add(4);
        typed.bits = x.bits.saturating_mul(2);
        typed.value = x.value.map(|_| 0.0);
        typed.expr = expr;
        Ok(typed)
    }
}

/// Returns an expression with the dimension and angles of `x`, made of `parts`.
fn like(x: &Typed, parts: &[&Typed]) -> Typed {
    Typed { dimension: x.dimension, angular: x.angular, ..Typed::over(parts) }
}

fn unknown(function: &str, name: Span, span: Span, given: usize) -> Mistake {
    if PURE.iter().any(|(known, _)| *known == function) || WHOLE.contains(&function) {
        let message = format!("{function} takes one argument, not {given}");
        return Mistake::new(Code::WrongArguments, span, message, "here");
    }
    if let Some((_, usage)) = OTHERS.iter().find(|(known, _)| *known == function) {
        let message = format!("{function}: wrong number or kind of arguments ({given} given)");
        return Mistake::new(Code::WrongArguments, span, message, "here")
            .help(format!("write {usage}"));
    }
    let known = PURE.iter().map(|(name, _)| *name).chain(OTHERS.iter().map(|(name, _)| *name));
    let known = known.chain(WHOLE.iter().copied());
    let message = format!("unknown function {}", quoted(function));
    Mistake::new(Code::UnknownFunction, name, message, "unknown")
        .help(did_you_mean(function, known))
}

#[cfg(test)]
mod tests {
    use super::{OTHERS, PURE};
    use crate::spec::FUNCTIONS;

    #[test]
    fn no_name_may_be_that_of_a_function() {
        let pure = PURE.iter().map(|(name, _)| *name);
        let mut known: Vec<&str> = pure.chain(OTHERS.iter().map(|(name, _)| *name)).collect();
        let mut reserved = FUNCTIONS.to_vec();
        known.sort_unstable();
        reserved.sort_unstable();
        assert_eq!(known, reserved);
    }
}
